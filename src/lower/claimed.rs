//! Axes that stand where the configuration says: behind a tool change, and behind moves in machine coordinates.
//!
//! The streams rely on such a place, and the output does not: the machine that it runs on may have left the axis elsewhere. What
//! begins there states the place first, and a move there is a move all the same.

use crate::ir::contour::{self, Coords};
use crate::ir::{Origin, Pos, Side};

use super::Lower;

impl Lower<'_> {
    /// These axes stand there, in the frame in force, although no move says so.
    pub(super) fn claim(&mut self, at: &Pos) {
        // What a transformation moves has other axes than the program sees.
        if self.machine_axes.transformer.is_some() || self.recording.is_some() {
            return;
        }
        self.flush();
        self.at.update(at);
        self.claimed = self.claimed.union(at.known());
        self.out.begins_at(&self.ctx.frame.apply(&self.at));
    }

    /// A cycle begins where axes stand as the configuration says: the output states the place, for the machine that it runs on may
    /// have left them elsewhere.
    pub(super) fn state_claimed(&mut self, origin: &Origin) {
        let axes = std::mem::take(&mut self.claimed);
        let mut end = Pos::UNKNOWN;
        for axis in axes.iter() {
            if let Some(at) = self.at.get(axis) {
                end.set(axis, at);
            }
        }
        if !end.known().is_empty() && self.recording.is_none() {
            let path = contour::Path::Rapid;
            axes.iter().for_each(|axis| self.at.forget(axis));
            self.path_element(&contour::Move { end, path, side: Side::None, coords: Coords::Frame }, origin);
        }
    }

    /// A straight move to where axes stand as the configuration says is a move all the same: the program names the place.
    #[cold]
    pub(super) fn state_end(&mut self, mv: &contour::Move) {
        let named = self.claimed.common(mv.end.known());
        self.claimed = self.claimed.without(named);
        if matches!(mv.path, contour::Path::Rapid | contour::Path::Line(_)) {
            for axis in named.iter() {
                if self.at.get(axis) == mv.end.get(axis) {
                    self.at.forget(axis);
                }
            }
        }
    }
}
