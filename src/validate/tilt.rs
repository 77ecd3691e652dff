//! Tilted working planes.

use crate::ir::Tilting;
use crate::read::Act;

use super::Validator;

impl Validator {
    /// Is the plane that was read the one that is meant?
    pub(super) fn is_tilt(&mut self, _tilting: &Tilting, acts: &[Act]) -> bool {
        acts.is_empty()
    }
}
