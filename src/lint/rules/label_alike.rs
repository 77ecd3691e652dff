//! Two labels differ in upper and lower case only.

use crate::diag::{Diagnostic, codes};
use crate::lint::motion::Setup;
use crate::lint::source::{Read, SourceRule, Told};
use crate::sema::run::survey::What;
use crate::text::Loc;

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
    fn block(&mut self, read: &Read<'_>, told: &mut Told<'_>) {
        for item in read.block.items {
            let What::Label(name) = &item.what else { continue };
            let lower = name.to_lowercase();
            let loc = read.loc(item.span);
            if let Some((_, other, first)) = self.labels.iter().find(|(low, other, _)| *low == lower && other != name) {
                let message = format!("`{name}` and `{other}` differ in upper and lower case only");
                let found = Diagnostic::new(codes::L2006, loc, message).also(*first, "the other one");
                told.say.found(found.help("rename one of them"));
            }
            if self.labels.len() < MOST {
                self.labels.push((lower, name.clone(), loc));
            }
        }
    }
}
