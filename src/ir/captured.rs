//! A contour that a program describes and does not travel: what the cycles that work along a contour take.

use crate::geo::element::quarters;
use crate::geo::{Element, Plane, Point2, distance};

use super::{Origin, Side};

/// Ends this close are one point, in mm: stored contours are rounded to three decimals.
const CLOSED: f64 = 0.002;

/// A rounding between lines that hardly turn, in mm: its neighbours meet as if it were not there.
const NEXT_TO_NOTHING: f64 = 0.01;

/// The elements of a described contour, arcs resolved and corners cut, in the frame in which it was begun.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Captured {
    /// The working plane; all points lie in it, in mm.
    pub plane: Plane,
    /// End of the first move: how the tool comes there is not part of the contour.
    pub start: Point2,
    /// The side that all its moves have; `None` where it changes.
    pub side: Option<Side>,
    /// In the order of travel, each from where the one before ends, none without length. At most as many as the
    /// consumer asked for; there may be none.
    pub pieces: Vec<CapturedElement>,
}

/// An element of a described contour.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CapturedElement {
    /// In coordinates of the plane, mm.
    pub element: Element,
    /// How it was programmed.
    pub kind: CapturedKind,
    /// The block that describes it; that of the corner for what a corner inserts.
    pub origin: Origin,
}

/// How an element of a contour was programmed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CapturedKind {
    /// A line at rapid traverse.
    Rapid,
    /// A line or an arc at a feed.
    Cut,
    /// A line in step with the spindle.
    Thread,
}

/// Why what was described is no contour. Each names the first block that is at fault.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Unfit {
    /// A finding about it was made already.
    Reported,
    /// More elements than the limit.
    TooMany(Origin),
    /// The first move does not name both coordinates of the plane.
    NoStart(Origin),
    /// The working plane changes.
    Plane(Origin),
    /// The coordinate system is another one than in front of the contour, or changes.
    Frame(Origin),
    /// An axis outside the plane moves, or the block is in machine coordinates.
    Leaves(Origin),
}

impl Captured {
    /// Does it end where it starts, to [`CLOSED`]?
    pub fn is_closed(&self) -> bool {
        self.pieces.last().is_some_and(|last| distance(last.element.to(), self.start) <= CLOSED)
    }

    /// Smallest and largest coordinates of its points, those of arcs between their ends included.
    pub fn extent(&self) -> (Point2, Point2) {
        self.pieces.iter().flat_map(|piece| quarters(&piece.element)).map(|piece| piece.to()).fold(
            (self.start, self.start),
            |(low, high), p| {
                (Point2::new(low.x.min(p.x), low.y.min(p.y)), Point2::new(high.x.max(p.x), high.y.max(p.y)))
            },
        )
    }

    /// The first two elements that cross, by their indices in `pieces`. Neighbours meet in their common end, also with
    /// next to nothing between them, and a closed contour meets itself in its start: that is no crossing.
    pub fn crossing(&self) -> Option<(usize, usize)> {
        let count = self.pieces.len();
        for (j, b) in self.pieces.iter().enumerate() {
            let joined = self.pieces[..j].iter().rev().scan(NEXT_TO_NOTHING, |left, piece| {
                *left -= piece.element.length();
                (*left >= 0.0).then_some(())
            });
            // From this element on nothing to speak of lies in front of `b`.
            let near = j.saturating_sub(1 + joined.count());
            for (i, a) in self.pieces.iter().enumerate().take(j) {
                let neighbours = i >= near;
                let shared = [
                    neighbours.then(|| b.element.from()),
                    neighbours.then(|| a.element.to()),
                    (i == 0 && j + 1 == count && self.is_closed()).then_some(self.start),
                ];
                if crate::geo::crossing::meet(&a.element, &b.element, &shared) {
                    return Some((i, j));
                }
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::TAU;

    use super::*;

    #[test]
    fn an_arc_counts_by_its_whole_way() {
        let at = Point2::new(3.0, 0.0);
        let element = Element::Arc { from: at, to: at, center: Point2::origin(), sweep: TAU };
        let piece = CapturedElement { element, kind: CapturedKind::Cut, origin: Origin::default() };
        let circle = Captured { start: at, pieces: vec![piece], ..Captured::default() };
        let (low, high) = circle.extent();
        let near = |p: Point2, x: f64, y: f64| distance(p, Point2::new(x, y)) < 1e-12;
        assert!(near(low, -3.0, -3.0) && near(high, 3.0, 3.0), "{low} {high}");
    }
}
