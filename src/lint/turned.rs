//! What is left of a bar while a turned part is made, by a coarse picture: where a tool went in any direction, nothing is said.

use crate::machine::axis::Axis;

use super::motion::{Bar, Step};

/// Pieces along Z.
const PIECES: usize = 400;
/// Room beside each cut, mm: tools have a width.
const ROOM: f64 = 6.0;
/// Less than this inside is the surface, mm.
const MARGIN: f64 = 0.1;

/// A bar, and the least radius that a cut has reached in each piece of it.
#[derive(Debug)]
pub struct Turned {
    bar: Bar,
    reached: Vec<f64>,
}

impl Turned {
    pub fn new(bar: Bar) -> Turned {
        Turned { bar, reached: vec![f64::INFINITY; PIECES] }
    }

    fn piece(&self, z: f64) -> usize {
        let share = (z - self.bar.left) / (self.bar.right - self.bar.left);
        ((share * PIECES as f64) as usize).min(PIECES - 1)
    }

    /// A cut takes away what it passes.
    pub fn cut(&mut self, step: &Step<'_>) {
        let (from, to) = (place(&step.place(step.from)), place(&step.place(&step.to)));
        // An end that is not known may be anywhere.
        let (Some(from), Some(to)) = (from, to) else {
            self.reached.fill(0.0);
            return;
        };
        let (low, high) = (from.1.min(to.1) - ROOM, from.1.max(to.1) + ROOM);
        if high < self.bar.left || low > self.bar.right {
            return;
        }
        let least = if from.0.signum() == to.0.signum() { from.0.abs().min(to.0.abs()) } else { 0.0 };
        for piece in self.piece(low)..=self.piece(high) {
            self.reached[piece] = self.reached[piece].min(least);
        }
    }

    /// Radius and Z of the end of a move that lies in material that no cut has come near.
    pub fn inside(&self, step: &Step<'_>) -> Option<(f64, f64)> {
        let (x, z) = place(&step.place(&step.to))?;
        let (radius, bar) = (x.abs(), &self.bar);
        let within = z > bar.left + MARGIN && z < bar.right - MARGIN;
        let material = radius < bar.radius - MARGIN && radius > bar.bore + MARGIN;
        (within && material && radius < self.reached[self.piece(z)] - MARGIN).then_some((radius, z))
    }
}

fn place(at: &crate::ir::Pos) -> Option<(f64, f64)> {
    Some((at.get(Axis::X)?, at.get(Axis::Z)?))
}
