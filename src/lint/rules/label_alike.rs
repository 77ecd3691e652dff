//! Two labels differ in upper and lower case only.

use crate::diag::Label;
use crate::lint::motion::Setup;
use crate::lint::source::{Read, Report, SourceRule};
use crate::sema::run::survey::What;
use crate::text::Loc;

super::rule! { L2006 Source LabelAlike Warning "label-alike"
    what "two labels differ in upper and lower case only"
    why "Two labels have the same letters in different case. Controls differ in whether they tell them apart, so a call may lead to \
        the wrong one on another machine. Rename one of them."
    example r#"
-- Example (L2006_fires.H)
0 BEGIN PGM P MM
; A and a.
1 L X+0 Y+0 Z+5 R0 F300
2 CALL LBL "A"
3 CALL LBL "a"
4 L Z+50 FMAX M30
5 LBL "A"
6 L X+10
7 LBL 0
8 LBL "a"
9 L X+20
10 LBL 0
11 END PGM P MM
"#
    says {
        alike(name, other) "`{name}` and `{other}` differ in upper and lower case only" help "rename one of them";
    }
}

/// Most labels that are remembered.
const MOST: usize = 1000;

#[derive(Debug, Default)]
pub(super) struct LabelAlike {
    labels: Vec<(String, String, Loc)>,
}

impl LabelAlike {
    pub(super) fn new(_: &Setup<'_>) -> LabelAlike {
        LabelAlike::default()
    }
}

impl SourceRule for LabelAlike {
    fn block(&mut self, read: &Read<'_>, report: &mut Report<'_>) {
        for item in read.block.items {
            let What::Label(name) = &item.what else { continue };
            let lower = name.to_lowercase();
            let loc = read.loc(item.span);
            if let Some((_, other, first)) = self.labels.iter().find(|(low, other, _)| *low == lower && other != name) {
                let found = L2006::alike(&name, &other).at(loc).also(*first, Label::OtherOne);
                report.say.found(found);
            }
            if self.labels.len() < MOST {
                self.labels.push((lower, name.clone(), loc));
            }
        }
    }
}
