//! Tilted working planes in the words of the target.

use crate::diag::codes;
use crate::ir::{Origin, Tilting};

use super::Printer;

impl Printer<'_> {
    /// The working plane is tilted, or is so no more.
    #[cold]
    pub(super) fn tilt(&mut self, _tilting: &Tilting, origin: &Origin) {
        let asking = codes::O9342::target_has_no_word_for_tilted_plane(&self.target.name);
        self.deny(origin, asking.answers([]));
    }
}
