//! A label is never called.

use crate::diag::{Diagnostic, codes};
use crate::lint::motion::Setup;
use crate::lint::source::{Read, SourceRule, Told};
use crate::sema::run::survey::What;
use crate::text::Loc;
use rustc_hash::FxHashSet;

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
    fn block(&mut self, read: &Read<'_>, _: &mut Told<'_>) {
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

    fn finish(&mut self, told: &mut Told<'_>) {
        for (name, loc) in self.labels.iter().filter(|(name, _)| !self.unknown && !self.used.contains(name)) {
            let found = Diagnostic::new(codes::L2001, *loc, format!("`{name}` is never called"));
            told.say.found(found.help("remove the label, or mend the call that should lead to it"));
        }
    }
}
