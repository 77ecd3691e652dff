//! Moves while the tool stands along a swivelled plane, or askew behind one.

use crate::diag::{Fault, codes};
use crate::ir::Pos;
use crate::ir::contour::Coords;
use crate::machine::{Axis, AxisSet};
use crate::sema::run::Where;

use super::{Channel, Outcome, Reported, State};

impl Channel<'_> {
    /// A move goes to `end`: main axes move by coordinates of the program only where the tool does not stand askew, and no word
    /// turns it out of a tilted plane.
    #[inline]
    pub(super) fn stands_right(&mut self, end: &Pos, coords: Coords) -> Outcome {
        let plain = end.known().without(AxisSet::MAIN).is_empty() && self.st.orientation.may_move();
        if plain || self.capture.is_some() {
            return Ok(());
        }
        let tilting = self.core.job.settings.machine.tilt_axes;
        let Some((axis, fault)) = self.st.turn_by_words(end, coords, tilting) else { return Ok(()) };
        // What was said once is worth no second finding.
        if !self.st.position.is_lost(axis) {
            self.core.say(Where::Block, fault);
        }
        self.lose_all();
        Err(Reported)
    }
}

impl State {
    /// Takes note of rotary words, unless the tool stands so that the block cannot be carried out: why, and the axis that it is about.
    #[cold]
    fn turn_by_words(&mut self, end: &Pos, coords: Coords, tilting: AxisSet) -> Option<(Axis, Fault)> {
        let first = |is: fn(Axis) -> bool| end.known().iter().find(|axis| is(*axis));
        let (main, rotary) = (first(Axis::is_main).filter(|_| coords == Coords::Frame), first(Axis::is_rotary));
        if let (Some(axis), Some(since)) = (main, self.orientation.askew_since()) {
            return Some((axis, codes::P2042::plane_is_off_and_rotary_axes_stay(&since.line)));
        }
        if let Some(axis) = rotary.filter(|_| self.frames.is_tilted()) {
            return Some((axis, codes::P2043::rotary_axis_moves_in_tilted_plane(&axis.letter())));
        }
        let places = if coords == Coords::Machine { *end } else { self.ctx.frame.apply(end) };
        for axis in end.known().iter().filter(|axis| axis.is_rotary()) {
            self.orientation.rotary_move(axis, places.get(axis), tilting);
        }
        None
    }
}
