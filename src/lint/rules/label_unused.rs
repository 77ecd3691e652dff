//! A label is never called.

use crate::lint::motion::Setup;
use crate::lint::source::{Read, Report, SourceRule};
use crate::sema::run::survey::What;
use crate::text::Loc;
use rustc_hash::FxHashSet;

super::rule! { L2001 Source LabelUnused Note off "label-unused"
    what "label is never called"
    why "No block of the program jumps to the label or calls it. It is left over, or the call names another one. Where a jump \
        computes its target, or a label is called by another program, nothing is said. Off by default: labels also mark places for \
        people."
    example r#"
-- Example (L2001_fires.H)
0 BEGIN PGM P MM
; Nothing calls LBL 5.
1 L X+0 Y+0 Z+5 R0 F300
2 L Z+50 FMAX M30
3 LBL 5
4 L X+10
5 LBL 0
6 END PGM P MM
-- partc.toml
# Every rule.
[lint]
select = ["all"]
"#
    says {
        unused(name) "`{name}` is never called" help "remove the label, or mend the call that should lead to it";
    }
}

#[derive(Debug, Default)]
pub(super) struct LabelUnused {
    labels: Vec<(String, Loc)>,
    used: FxHashSet<String>,
    unknown: bool,
}

impl LabelUnused {
    pub(super) fn new(_: &Setup<'_>) -> LabelUnused {
        LabelUnused::default()
    }
}

impl SourceRule for LabelUnused {
    fn block(&mut self, read: &Read<'_>, _: &mut Report<'_>) {
        for item in read.block.items {
            match &item.what {
                What::Label(name) => self.labels.push((name.clone(), read.loc(item.span))),
                What::Uses(name) => {
                    self.used.insert(name.clone());
                }
                What::UsesUnknown => self.unknown = true,
                _ => {}
            }
        }
    }

    fn finish(&mut self, report: &mut Report<'_>) {
        for (name, loc) in self.labels.iter().filter(|(name, _)| !self.unknown && !self.used.contains(name)) {
            let found = L2001::unused(&name).at(*loc);
            report.say.found(found);
        }
    }
}
