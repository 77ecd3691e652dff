//! Does the path damage the contour elsewhere? Neighbours are looked at when they are joined; here are the others.

use crate::diag::Diags;
use crate::geo::{Element, Point2, Vec2, cross, distance, gap};
use crate::ir::Origin;

use super::piece::{Kind, Piece};
use super::reports;

/// Elements looked back upon.
const DEPTH: usize = 16;
/// How much nearer than the radius a path may come, in mm: what a source rounded to three decimals loses.
const NEARER: f64 = 2e-3;

#[derive(Debug, Clone, Copy)]
struct Known {
    element: Element,
    /// Least and largest coordinates.
    least: Vec2,
    most: Vec2,
    /// Place in the contour.
    index: u32,
    /// A piece about the corner behind this place.
    corner: bool,
    origin: Origin,
}

impl Known {
    fn new(element: &Element, index: u32, origin: Origin) -> Known {
        let (from, to) = (element.from().coords, element.to().coords);
        let (mut least, mut most) = (from.inf(&to), from.sup(&to));
        if let Element::Arc { center, sweep, .. } = *element {
            let radius = distance(element.from(), center);
            // A flat arc bulges little beyond its ends.
            let bulge = if sweep.abs() < 1.5 { radius * sweep * sweep / 8.0 } else { 2.0 * radius };
            least.add_scalar_mut(-bulge);
            most.add_scalar_mut(bulge);
        }
        Known { element: *element, least, most, index, corner: false, origin }
    }

    /// Does this piece of the path keep its distance from `contour` because of how it was made? A line that was joined to
    /// its neighbour meets it once; an arc may come back.
    fn is_joined(&self, contour: &Known) -> bool {
        let is_line = |known: &Known| matches!(known.element, Element::Line { .. });
        if self.corner {
            return is_line(contour) && contour.index.wrapping_sub(self.index) <= 1;
        }
        match self.index.abs_diff(contour.index) {
            0 => true,
            1 => is_line(self) && is_line(contour),
            _ => false,
        }
    }

    /// Does this piece of the path come nearer than `r` to `contour`?
    #[inline]
    fn damages(&self, contour: &Known, r: f64) -> bool {
        !self.is_far(contour, r) && !self.is_joined(contour) && self.hits(contour, r)
    }

    #[inline]
    fn is_far(&self, other: &Known, r: f64) -> bool {
        self.least.x > other.most.x + r
            || other.least.x > self.most.x + r
            || self.least.y > other.most.y + r
            || other.least.y > self.most.y + r
    }

    fn hits(&self, other: &Known, r: f64) -> bool {
        match (self.element, other.element) {
            (Element::Line { from: a, to: b }, Element::Line { from: c, to: d }) => lines_are_near(a, b, c, d, r),
            (a, b) => gap::between(&a, &b) < r,
        }
    }
}

/// Do two lines cross, or come nearer than `r` to each other?
fn lines_are_near(a: Point2, b: Point2, c: Point2, d: Point2, r: f64) -> bool {
    let (u, w) = (b - a, d - c);
    let apart = |p: f64, q: f64| p * q > 0.0;
    let cross_over = !apart(cross(u, c - a), cross(u, d - a)) && !apart(cross(w, a - c), cross(w, b - c));
    let near = |p: Point2, from: Point2, way: Vec2| {
        let v = p - from;
        let t = (v.dot(&way) / way.norm_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
        (v - way * t).norm_squared() < r * r
    };
    cross_over || near(a, c, w) || near(b, c, w) || near(c, a, u) || near(d, a, u)
}

/// The last elements of the contour and of the path.
#[derive(Debug, Default)]
pub struct Damage {
    contour: Ring,
    path: Ring,
    /// Elements of the contour so far.
    elements: u32,
    reported: bool,
    /// The control looks for bottlenecks: what it would do about one is not known.
    pub refuses: bool,
}

#[derive(Debug, Default)]
struct Ring {
    known: Vec<Known>,
    next: usize,
}

impl Ring {
    fn add(&mut self, known: Known) {
        if self.known.len() < DEPTH {
            self.known.push(known);
        } else if let Some(oldest) = self.known.get_mut(self.next % DEPTH) {
            *oldest = known;
        }
        self.next = (self.next + 1) % DEPTH;
    }

    fn first(&self, fits: impl Fn(&Known) -> bool) -> Option<Origin> {
        self.known.iter().find(|known| fits(known)).map(|known| known.origin)
    }

    fn forget(&mut self) {
        self.known.clear();
        self.next = 0;
    }
}

impl Damage {
    pub fn forget(&mut self) {
        self.contour.forget();
        self.path.forget();
        self.elements = 0;
        self.reported = false;
    }

    /// A contour begins with this element.
    pub fn begin(&mut self, first: &Piece) {
        self.forget();
        self.elements = first.index;
        self.refuses = first.rules.search.bottlenecks;
        if !first.rules.is_way {
            self.contour.add(Known::new(&first.contour, first.index, first.origin));
        }
    }

    /// The control itself goes beyond the contour.
    pub fn is_wanted(&mut self) {
        self.reported = true;
    }

    /// An element of the contour.
    pub fn contour(&mut self, element: &Element, origin: &Origin, d: f64, diags: &Diags) {
        self.elements += 1;
        let known = Known::new(element, self.elements, *origin);
        if !self.reported
            && let Some(of) = self.path.first(|path| path.damages(&known, d.abs() - NEARER))
        {
            self.report(&of, origin, d, diags);
        }
        self.contour.add(known);
    }

    /// An element that belongs to a way of its own to the contour or from it.
    pub fn way(&mut self) {
        self.elements += 1;
    }

    /// A settled piece of the path.
    pub fn path(&mut self, piece: &Piece, way: &Element, d: f64, diags: &Diags) {
        if piece.rules.is_way {
            return;
        }
        let known = Known { corner: piece.kind == Kind::Joint, ..Known::new(way, piece.index, piece.origin) };
        if !self.reported
            && let Some(of) = self.contour.first(|contour| known.damages(contour, d.abs() - NEARER))
        {
            self.report(&piece.origin, &of, d, diags);
        }
        self.path.add(known);
    }

    /// The place in the contour of the element that comes.
    pub fn next_index(&self) -> u32 {
        self.elements + 1
    }

    fn report(&mut self, path: &Origin, contour: &Origin, d: f64, diags: &Diags) {
        self.reported = true;
        diags.push(*reports::damaged(path, contour, d.abs(), self.refuses));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_that_cross_or_come_near() {
        let p = Point2::new;
        assert!(lines_are_near(p(-50.0, 0.0), p(50.0, 0.0), p(0.0, -50.0), p(0.0, 50.0), 1.0));
        assert!(!lines_are_near(p(-50.0, 0.0), p(50.0, 0.0), p(60.0, -50.0), p(60.0, 50.0), 5.0));
        assert!(lines_are_near(p(-50.0, 0.0), p(50.0, 0.0), p(54.0, -50.0), p(54.0, 50.0), 5.0));
        assert!(!lines_are_near(p(0.0, 0.0), p(50.0, 0.0), p(0.0, 5.0), p(50.0, 5.0), 5.0));
    }
}
