//! Entries of `partc.toml` that would make a word of the language vanish.

use crate::diag::{Diagnostic, codes};
use crate::text::{Loc, Span};

use super::{Core, Language};

impl<L: Language> Core<'_, L> {
    /// Refuses an entry that declares harmless what moves the tool or says where it goes: the move would be printed as if
    /// the word were not there. The entry holds for the whole run, so this is said at the top of the program.
    #[cold]
    pub fn refuse_entry(&self, entry: &str, what: &str, help: impl Into<String>) {
        let loc = Loc { file: self.job.main, line: 1, span: Span::default() };
        let found = Diagnostic::new(codes::P0205, loc, format!("{entry} of partc.toml names {what}")).help(help.into());
        if !self.job.diags.knows(&found) {
            self.report(found);
        }
    }
}
