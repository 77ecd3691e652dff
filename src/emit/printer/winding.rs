//! Arcs of very many turns, for a target that does not count them: they are printed and read back piece by piece, so that no
//! one has to hold the text of all of them.

use core::f64::consts::TAU;

use crate::geo::Plane;
use crate::ir::Feed;
use crate::ir::motion::{Arc, Move, Path};
use crate::machine::Axis;
use crate::machine::axis::AXES;

/// Turns of a piece. The last one has the rest as well, so that it is no shorter.
const TURNS: f64 = 100.0;
/// An arc of a smaller sweep is one piece.
pub(crate) const LEAST: f64 = 2.0 * TURNS * TAU;

/// An arc in pieces of whole turns.
#[derive(Debug)]
pub(crate) struct Winding {
    mv: Move,
    arc: Arc,
    feed: Feed,
    /// Where the axes stand that go along, in mm.
    start: [f64; AXES],
    count: u32,
}

impl Winding {
    /// A move along an arc, with the other axes that go along from `start`.
    pub(super) fn new(mv: &Move, arc: Arc, feed: Feed, start: [f64; AXES]) -> Winding {
        let count = libm::floor(arc.sweep.abs() / (TURNS * TAU)) as u32;
        Winding { mv: *mv, arc, feed, start, count }
    }

    /// The pieces, in order.
    pub fn pieces(&self) -> impl Iterator<Item = Move> + '_ {
        (1..=self.count).map(|n| self.piece(n))
    }

    fn piece(&self, n: u32) -> Move {
        let Winding { mv, arc, feed, count, .. } = self;
        let whole = (TURNS * TAU).copysign(arc.sweep);
        let sweep = if n == *count { arc.sweep - whole * f64::from(count - 1) } else { whole };
        let feed = match feed {
            Feed::InverseTime(f) => Feed::InverseTime(f * arc.sweep / sweep),
            Feed::PerMinute(_) | Feed::PerRevolution(_) => *feed,
        };
        let mut piece = Move { path: Path::Arc(Arc { sweep, ..*arc }, feed), ..*mv };
        if n < *count {
            self.end_whole(&mut piece, whole * f64::from(n) / arc.sweep);
        }
        piece
    }

    /// Whole turns end where the arc starts; the other axes have gone `share` of their way.
    fn end_whole(&self, piece: &mut Move, share: f64) {
        let (first, second) = plane_axes(self.arc.plane);
        for axis in self.mv.axes.iter() {
            let from = self.start[axis.index()];
            let Some(to) = self.mv.end.get(axis) else { continue };
            let at = match axis {
                axis if axis == first => self.arc.from.x,
                axis if axis == second => self.arc.from.y,
                _ => from + (to - from) * share,
            };
            piece.end.set(axis, at);
        }
    }
}

fn plane_axes(plane: Plane) -> (Axis, Axis) {
    let (first, second, _) = plane.axes();
    (Axis::ALL[first], Axis::ALL[second])
}
