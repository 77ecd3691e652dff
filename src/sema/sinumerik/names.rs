//! What the names in a program mean: words of the language and axes of the machine.

use crate::diag::{Fault, codes};
use crate::parser::symbols::Symbol;

use super::Run;
use super::vocabulary::{Meaning, Procedure, Refusal};

impl Run<'_> {
    pub(super) fn meaning(&mut self, name: Symbol) -> Meaning {
        let at = name.0 as usize;
        if let Some(Some(known)) = self.meanings.get(at) {
            return *known;
        }
        let word = self.channel.core.symbols.name(name);
        let meaning = match self.channel.axis_names.find(word) {
            Some(axis) => Meaning::Axis(axis),
            None => self.vocabulary.get(word).copied().unwrap_or(Meaning::Unknown),
        };
        if self.meanings.len() <= at {
            self.meanings.resize(at + 1, None);
        }
        self.meanings[at] = Some(meaning);
        meaning
    }

    /// What is wrong with a word of which nothing is known here, or which is not compiled.
    pub(super) fn misused_word(&mut self, name: Symbol) -> Fault {
        let word = |run: &Self| run.channel.core.symbols.name(name).to_owned();
        match self.meaning(name) {
            Meaning::Known(known) => known.not_compiled(&word(self)),
            Meaning::Procedure(Procedure::Refused(Refusal { what, .. })) => {
                codes::P9010::is_not_supported_so_replace(&word(self), &what)
            }
            _ => self.vars.undefined(name, &self.channel.core),
        }
    }
}
