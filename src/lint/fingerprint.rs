//! What a program does, as one number: two texts of a program that have the same do the same.

use std::fmt::Write as _;

use xxhash_rust::xxh3::Xxh3;

use crate::ir::motion::{Move, Place, Sink};
use crate::ir::{Function, Origin, Pos, Tap};

/// Takes everything that a program does, in order, without its comments and the places of its blocks.
#[derive(Default)]
pub struct MotionFingerprint {
    hash: Xxh3,
    text: String,
}

impl std::fmt::Debug for MotionFingerprint {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("MotionFingerprint").finish_non_exhaustive()
    }
}

impl MotionFingerprint {
    pub fn number(&self) -> u128 {
        self.hash.digest128()
    }

    /// All digits of all fields: what differs in one bit differs here.
    fn take(&mut self, item: &dyn std::fmt::Debug) {
        self.text.clear();
        let _ = writeln!(self.text, "{item:?}");
        self.hash.update(self.text.as_bytes());
    }
}

impl Sink for MotionFingerprint {
    fn movement(&mut self, mv: &Move, _: &Origin) {
        self.take(mv);
    }

    fn tap(&mut self, tap: &Tap, place: &Place, _: &Origin) {
        self.take(&(tap, place));
    }

    fn function(&mut self, function: &Function, _: &Origin) {
        if !matches!(function, Function::Comment(_) | Function::Remark(_)) {
            self.take(function);
        }
    }

    fn lost(&mut self, _: &Origin) {
        self.take(&"lost");
    }

    fn begins_at(&mut self, at: &Pos) {
        self.take(at);
    }
}
