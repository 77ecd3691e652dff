//! A literal has more decimals than controls resolve.

use crate::lint::motion::Setup;
use crate::lint::source::{Read, Report, SourceRule};
use crate::sema::run::survey::{LONG, What};
use crate::text::decode::readable;

super::rule! { L2012 Source NumberPrecision Note off "digits-beyond-resolution"
    what "number has more digits than controls resolve"
    why "A literal has more than five decimals. Controls resolve a tenth of a micrometre at best, and some refuse longer numbers. \
        Digits were computed and not rounded. Off by default. Said once."
    example r#"
-- Example (L2012_fires.MPF)
; Seven decimals.
G0 X0 Y0 Z5
G1 X5.1234567 F100
M30
-- partc.toml
# Every rule.
[lint]
select = ["all"]
"#
    says {
        long(word, decimals) "`{word}` has {decimals} decimals" help "round it";
    }
}

/// Most decimals that controls resolve.
const MOST_DECIMALS: usize = LONG - 1;

#[derive(Debug, Default)]
pub(super) struct NumberPrecision {
    said: bool,
}

impl NumberPrecision {
    pub(super) fn new(_: &Setup<'_>) -> NumberPrecision {
        NumberPrecision::default()
    }
}

impl SourceRule for NumberPrecision {
    fn block(&mut self, read: &Read<'_>, report: &mut Report<'_>) {
        if self.said || read.block.is_empty {
            return;
        }
        for item in read.block.items {
            let text = item.span.of(read.block.text);
            let decimals = memchr::memchr2(b'.', b',', text)
                .map_or(0, |at| text[at + 1..].iter().filter(|b| b.is_ascii_digit()).count());
            if matches!(item.what, What::Word { .. }) && decimals > MOST_DECIMALS {
                self.said = true;
                report.say.found(L2012::long(&readable(text), &decimals).at(read.loc(item.span)));
                return;
            }
        }
    }
}
