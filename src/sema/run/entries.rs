//! Entries of `partc.toml` that would make a word of the language vanish.

use crate::diag::codes;
use crate::text::{Loc, Span};

use super::{Core, Language};

impl<L: Language> Core<'_, L> {
    /// Refuses entries of `key` that declare harmless what moves the tool or says where it goes, by name and what each is: the
    /// move would be printed as if the word were not there. They hold for the whole run, so this is said at its top.
    pub fn refuse_entries(&self, key: &str, entries: &[(&str, &str)], help: &str) {
        if entries.is_empty() {
            return;
        }
        let named: Vec<String> = entries.iter().map(|(name, what)| format!("{name} ({what})")).collect();
        let loc = Loc { file: self.job.main, line: 1, span: Span::at(0, 1) };
        let found = codes::P0205::of_partc_toml_names(&key, &named.join(", ")).at(loc).help(help);
        if !self.job.diags.knows(&found) {
            self.report(found);
        }
    }
}
