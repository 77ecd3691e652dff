//! Does the path damage the contour elsewhere? Neighbours are looked at when they are joined; here are the others.
//!
//! Most need no look: while the contour runs in directions that differ by no more than a right angle, and all joints are
//! those of the plain parallel, the path keeps its distance from all of it. Proof: let p be a place of the path, c(s) the
//! point of the contour beside the path at s, u its direction, n its normal and v the way from p along the path to s: then
//! c - p = v - r·n. The path runs forward, so v and u differ by a right angle at most, and going on (ds·u) or about an outside
//! corner (c stays) takes c no nearer to p. At an inside corner n turns towards -u: |v - r·n| does not fall either. What the
//! corner cuts off: on the line in front of it the distance goes on growing; on the line behind, its least lies v·u
//! behind the foot, which is in front of the corner wherever v leads to the left of the line, for then the path has turned
//! back on circles of r at least, and v·u is no less than r·sin(turn).

use crate::diag::Diags;
use crate::geo::joint::Headings;
use crate::geo::{Element, Point2, Vec2, cross, direction, distance, gap};
use crate::ir::Origin;

use super::piece::{Kind, Piece};
use super::reports;

/// Elements looked back upon.
const DEPTH: usize = 16;
/// How much nearer than the radius a path may come, in mm: what a source rounded to three decimals loses.
const NEARER: f64 = 2e-3;
/// Cosine of a bit less than half a right angle: how far a direction may lie from that of its window.
const HALF: f64 = 0.7072;

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
    /// It is joined to the one before as the plain parallel is.
    regular: bool,
    headings: Headings,
    origin: Origin,
}

impl Known {
    #[inline]
    fn new(element: &Element, index: u32, origin: &Origin) -> Known {
        let lower = |a: f64, b: f64| if a < b { a } else { b };
        let (from, to) = (element.from(), element.to());
        let mut least = Vec2::new(lower(from.x, to.x), lower(from.y, to.y));
        let mut most = Vec2::new(-lower(-from.x, -to.x), -lower(-from.y, -to.y));
        if let Element::Arc { center, sweep, .. } = *element {
            let radius = distance(from, center);
            // A flat arc bulges little beyond its ends.
            let bulge = if sweep.abs() < 1.5 { radius * sweep * sweep / 8.0 } else { 2.0 * radius };
            least.add_scalar_mut(-bulge);
            most.add_scalar_mut(bulge);
        }
        let headings = Headings::default();
        Known { element: *element, least, most, index, corner: false, regular: false, headings, origin: *origin }
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

/// The newest elements whose path needs no look: they run in directions about one, and their joints are regular.
#[derive(Debug, Default)]
struct Window {
    towards: Vec2,
    /// Place of its first element.
    since: u32,
}

impl Window {
    #[inline]
    fn admits(&self, element: &Element, headings: &Headings) -> bool {
        let turns = match *element {
            Element::Line { .. } => 0.0,
            Element::Arc { sweep, .. } => sweep.abs(),
        };
        turns < 3.0 && self.towards.dot(&headings.start) > HALF && self.towards.dot(&headings.end) > HALF
    }
}

/// The last elements of the contour and of the path.
#[derive(Debug, Default)]
pub struct Damage {
    contour: Ring,
    path: Ring,
    window: Window,
    /// Elements of the contour so far.
    elements: u32,
    reported: bool,
    /// The control looks for bottlenecks: what it would do about one is not known.
    pub refuses: bool,
}

#[derive(Debug, Default)]
struct Ring {
    known: Vec<Known>,
    /// Where the next one goes: the oldest, if all places are taken.
    next: usize,
    /// As many are to come until the last irregular one is forgotten.
    irregular: usize,
}

impl Ring {
    #[inline]
    fn add(&mut self, known: Known) {
        self.irregular = if known.regular { self.irregular.saturating_sub(1) } else { DEPTH };
        if self.known.len() < DEPTH {
            self.known.push(known);
        } else if let Some(oldest) = self.known.get_mut(self.next) {
            *oldest = known;
        }
        self.next = (self.next + 1) % DEPTH;
    }

    /// From the oldest on.
    #[inline]
    fn iter(&self) -> impl DoubleEndedIterator<Item = &Known> {
        let (newer, older) = self.known.split_at_checked(self.next).unwrap_or((&self.known, &[]));
        older.iter().chain(newer)
    }

    /// The first one that fits and is older than `since`.
    #[inline]
    fn first(&self, since: u32, fits: impl Fn(&Known) -> bool) -> Option<Origin> {
        self.iter().take_while(|known| known.index < since).find(|known| fits(known)).map(|known| known.origin)
    }

    fn forget(&mut self) {
        *self = Ring { known: std::mem::take(&mut self.known), ..Ring::default() };
        self.known.clear();
    }
}

impl Damage {
    pub fn forget(&mut self) {
        self.contour.forget();
        self.path.forget();
        self.window = Window::default();
        self.elements = 0;
        self.reported = false;
    }

    /// A contour begins with this element.
    pub fn begin(&mut self, first: &Piece) {
        self.forget();
        self.elements = first.index;
        self.refuses = first.rules.search.bottlenecks;
        self.move_window(&first.contour, &first.headings, false);
        let known = Known::new(&first.contour, first.index, &first.origin);
        self.contour.add(Known { headings: first.headings, ..known });
    }

    /// The control itself goes beyond the contour.
    pub fn is_wanted(&mut self) {
        self.reported = true;
    }

    /// An element of the contour, joined to the one before as the plain parallel is, or in another way.
    #[inline]
    pub fn contour(
        &mut self,
        element: &Element,
        headings: &Headings,
        regular: bool,
        origin: &Origin,
        d: f64,
        diags: &Diags,
    ) {
        self.elements += 1;
        self.move_window(element, headings, regular);
        let known = Known { regular, headings: *headings, ..Known::new(element, self.elements, origin) };
        let since = if self.path.irregular > 0 { u32::MAX } else { self.window.since };
        if !self.reported
            && let Some(of) = self.path.first(since, |path| path.damages(&known, d.abs() - NEARER))
        {
            self.report(&of, origin, d, diags);
        }
        self.contour.add(known);
    }

    /// The newest element belongs to the window, or to a new one.
    #[inline]
    fn move_window(&mut self, element: &Element, headings: &Headings, regular: bool) {
        if !(regular && self.window.since < self.elements && self.window.admits(element, headings)) {
            self.open_window(element, headings, regular);
        }
    }

    /// A window about the direction of the newest element, as far back as it goes.
    fn open_window(&mut self, element: &Element, headings: &Headings, regular: bool) {
        let both = headings.start + headings.end;
        self.window.towards = direction(both, 0.0).unwrap_or_default();
        self.window.since = self.elements + 1;
        if !self.window.admits(element, headings) {
            return;
        }
        self.window.since = self.elements;
        let mut joined = regular;
        for known in self.contour.iter().rev() {
            if !joined || !self.window.admits(&known.element, &known.headings) {
                break;
            }
            self.window.since = known.index;
            joined = known.regular;
        }
    }

    /// A settled piece of the path.
    #[inline]
    pub fn path(&mut self, piece: &Piece, way: &Element, d: f64, diags: &Diags) {
        let corner = piece.kind == Kind::Joint;
        let known = Known { corner, regular: piece.regular, ..Known::new(way, piece.index, &piece.origin) };
        let in_window = piece.regular && piece.index >= self.window.since;
        let since = if in_window { self.window.since } else { u32::MAX };
        if !self.reported
            && let Some(of) = self.contour.first(since, |contour| known.damages(contour, d.abs() - NEARER))
        {
            self.report(&piece.origin, &of, d, diags);
        }
        self.path.add(known);
    }

    /// The place in the contour of the element that comes.
    pub fn next_index(&self) -> u32 {
        self.elements + 1
    }

    #[cold]
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
