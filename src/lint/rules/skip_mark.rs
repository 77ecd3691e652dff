//! Blocks with a skip mark, and nothing says whether they run.

use crate::lint::motion::Setup;
use crate::lint::source::{Read, Report, SourceRule};

super::rule! { L2014 Source SkipMark Note off "skip-mark-open"
    what "blocks with a skip mark, and nothing says whether they run"
    why "The program has blocks with `/`, and `[control] skip_blocks` says nothing of them, so they are compiled as if the switch \
        at the machine were off. Say in the configuration what holds in the shop. Off by default. Said once."
    example r#"
-- Example (L2014_fires.MPF)
; A skip mark.
G0 X0 Y0 Z5
/G1 X5 F100
M30
-- partc.toml
# Every rule.
[lint]
select = ["all"]
"#
    says {
        open() "this block has a skip mark, and is compiled as if the switch were off" asks "set `[control] skip_blocks`";
    }
}

#[derive(Debug, Default)]
pub(super) struct SkipMark {
    said: bool,
    open: bool,
}

impl SkipMark {
    pub(super) fn new(setup: &Setup<'_>) -> SkipMark {
        SkipMark { open: setup.settings.control.skip_blocks.is_empty(), said: false }
    }
}

impl SourceRule for SkipMark {
    fn block(&mut self, read: &Read<'_>, report: &mut Report<'_>) {
        if read.block.skip && !self.said && self.open {
            self.said = true;
            report.say.found(L2014::open().answers([]).at(read.words()));
        }
    }
}
