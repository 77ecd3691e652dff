//! A variable gets a value that nothing reads.

use crate::lint::motion::Setup;
use crate::lint::source::{Read, Report, SourceRule};
use crate::sema::run::survey::What;
use crate::text::Loc;
use rustc_hash::FxHashSet;

super::rule! { L2004 Source VariableUnread Note off "variable-unread"
    what "variable gets a value that nothing reads"
    why "A variable is set, and no block of the program reads it. It is left over, or the block that should read it names another \
        one. Programs that call others, and parameters that the control reads itself (Q100 to Q1999 of Klartext cycles), are left \
        alone. Off by default: operators read variables, too."
    example r#"
-- Example (L2004_fires.MPF)
; Nothing reads R2.
R1=5
R2=7
G0 X0 Y0 Z5
G1 X=R1 F100
M30
-- partc.toml
# Every rule.
[lint]
select = ["all"]
"#
    says {
        unread(name) "`{name}` gets a value that no block reads" help "remove it, or mend the block that should read it";
    }
}

/// Most variables that are remembered.
const MOST: usize = 1000;

#[derive(Debug, Default)]
pub(super) struct VariableUnread {
    written: Vec<(String, Loc)>,
    read: FxHashSet<String>,
    opaque: bool,
}

impl VariableUnread {
    pub(super) fn new(_: &Setup<'_>) -> VariableUnread {
        VariableUnread::default()
    }
}

impl SourceRule for VariableUnread {
    fn block(&mut self, read: &Read<'_>, _: &mut Report<'_>) {
        for item in read.block.items {
            match &item.what {
                What::Writes(name)
                    if self.written.iter().all(|(known, _)| known != name) && self.written.len() < MOST =>
                {
                    self.written.push((name.clone(), read.loc(item.span)));
                }
                What::Reads(name) => {
                    self.read.insert(name.clone());
                }
                What::Opaque => self.opaque = true,
                _ => {}
            }
        }
    }

    fn finish(&mut self, report: &mut Report<'_>) {
        for (name, loc) in
            self.written.iter().filter(|(name, _)| !self.opaque && !self.read.contains(name) && !of_control(name))
        {
            let found = L2004::unread(&name).at(*loc);
            report.say.found(found);
        }
    }
}

/// Parameters that cycles and the control itself read.
fn of_control(name: &str) -> bool {
    let number = name.strip_prefix('Q').and_then(|digits| digits.parse::<u32>().ok());
    number.is_some_and(|number| number >= 100)
}
