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

use std::collections::VecDeque;

use crate::diag::Diags;
use crate::geo::{Element, Point2, Vec2, clearance, cross, direction};
use crate::ir::Origin;

use super::bounds::Bounds;
use super::piece::{Kind, Piece, PiecePool};
use super::{Compensator, reports};

/// Elements looked back upon.
const DEPTH: usize = 16;
/// How much nearer than the radius a path may come, in mm: what a source rounded to three decimals loses.
const NEARER: f64 = 2e-3;
/// Cosine of a bit less than half a right angle: how far a direction may lie from that of its window.
const HALF: f64 = 0.7072;

/// A piece of the path, or an element of the contour.
struct Looked<'p> {
    element: &'p Element,
    bounds: Bounds,
    /// Place in the contour.
    index: u32,
    /// A piece about the corner behind this place.
    corner: bool,
}

impl Looked<'_> {
    fn is_line(&self) -> bool {
        matches!(self.element, Element::Line { .. })
    }

    /// Does this piece of the path keep its distance from `contour` because of how it was made? A line that was joined to
    /// its neighbour meets it once; an arc may come back.
    fn is_joined(&self, contour: &Looked<'_>) -> bool {
        if self.corner {
            return contour.is_line() && contour.index.wrapping_sub(self.index) <= 1;
        }
        match self.index.abs_diff(contour.index) {
            0 => true,
            1 => self.is_line() && contour.is_line(),
            _ => false,
        }
    }

    /// Does this piece of the path come nearer than `r` to `contour`?
    #[inline]
    fn damages(&self, contour: &Looked<'_>, r: f64) -> bool {
        !self.bounds.is_far(&contour.bounds, r) && !self.is_joined(contour) && self.hits(contour, r)
    }

    fn hits(&self, other: &Looked<'_>, r: f64) -> bool {
        match (*self.element, *other.element) {
            (Element::Line { from: a, to: b }, Element::Line { from: c, to: d }) => lines_are_near(a, b, c, d, r),
            (a, b) => clearance::between(&a, &b) < r,
        }
    }
}

impl Piece {
    fn way(&mut self) -> Looked<'_> {
        let bounds = *self.seen.way.get_or_insert_with(|| Bounds::of(&self.curve));
        Looked { element: &self.curve, bounds, index: self.index, corner: self.kind == Kind::Joint }
    }

    fn element(&mut self) -> Looked<'_> {
        let bounds = *self.seen.contour.get_or_insert_with(|| Bounds::of(&self.contour));
        Looked { element: &self.contour, bounds, index: self.index, corner: false }
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
    fn admits(&self, piece: &Piece) -> bool {
        let headings = &piece.headings;
        let turns = match piece.contour {
            Element::Line { .. } => 0.0,
            Element::Arc { sweep, .. } => sweep.abs(),
        };
        turns < 3.0 && self.towards.dot(&headings.start) > HALF && self.towards.dot(&headings.end) > HALF
    }
}

/// What lies behind: the pieces that were printed, and elements that were left out.
#[derive(Debug, Default)]
pub struct Gouges {
    behind: VecDeque<Box<Piece>>,
    /// How many of them are elements.
    kept: usize,
    window: Window,
    /// How many are no part of the plain parallel.
    irregular: usize,
    /// Elements of the contour so far.
    elements: u32,
    reported: bool,
    /// The control looks for bottlenecks: what it would do about one is not known.
    pub refuses: bool,
}

impl Gouges {
    pub fn forget(&mut self, pool: &mut PiecePool) {
        self.behind.drain(..).for_each(|piece| pool.put(piece));
        *self = Gouges { behind: std::mem::take(&mut self.behind), ..Gouges::default() };
    }

    /// The control itself goes beyond the contour.
    pub fn is_wanted(&mut self) {
        self.reported = true;
    }

    /// The place in the contour of the element that comes.
    pub fn next_index(&self) -> u32 {
        self.elements + 1
    }

    /// A piece that was printed, or left out.
    #[inline]
    pub fn keep(&mut self, piece: Box<Piece>, pool: &mut PiecePool) {
        self.irregular += usize::from(!piece.regular);
        self.kept += usize::from(piece.kind.is_of_contour());
        self.behind.push_back(piece);
        while self.kept > DEPTH {
            let Some(oldest) = self.behind.pop_front() else { return };
            self.kept -= usize::from(oldest.kind.is_of_contour());
            self.irregular -= usize::from(!oldest.regular);
            pool.put(oldest);
        }
    }

    #[cold]
    fn report(&mut self, path: &Origin, contour: &Origin, d: f64, diags: &Diags) {
        self.reported = true;
        diags.push(*reports::damaged(path, contour, d.abs(), self.refuses));
    }
}

impl Compensator {
    /// The contour has a new element.
    #[inline(always)]
    pub(super) fn watch_contour(&mut self, diags: &Diags) {
        self.gouges.elements += 1;
        let Some(newest) = self.ahead.back().or(self.path.back()) else { return };
        let window = &self.gouges.window;
        let goes_on = newest.joined && window.since < newest.index && window.admits(newest);
        if !goes_on {
            self.open_window();
        }
        let since = if self.gouges.irregular > 0 { u32::MAX } else { self.gouges.window.since };
        if self.gouges.behind.front().is_some_and(|oldest| oldest.index < since) {
            self.look_at_path(since, diags);
        }
    }

    /// A window about the direction of the newest element, as far back as it goes.
    #[inline(never)]
    fn open_window(&mut self) {
        let Some(newest) = self.ahead.back().or(self.path.back()) else { return };
        let towards = direction(newest.headings.start + newest.headings.end, 0.0).unwrap_or_default();
        let mut window = Window { towards, since: newest.index + 1 };
        let pieces = self.ahead.iter().rev().chain(self.path.iter().rev()).chain(self.gouges.behind.iter().rev());
        for element in pieces.filter(|piece| piece.kind.is_of_contour()) {
            if element.kind == Kind::Gone || !window.admits(element) {
                break;
            }
            window.since = element.index;
            if !element.joined {
                break;
            }
        }
        self.gouges.window = window;
    }

    /// Do older pieces of the path damage the newest element?
    #[inline(never)]
    fn look_at_path(&mut self, since: u32, diags: &Diags) {
        if self.gouges.reported {
            return;
        }
        let Some(newest) = self.ahead.back_mut().or(self.path.back_mut()).filter(|newest| !newest.rules.is_way) else {
            return;
        };
        let (d, origin, newest) = (self.d, newest.origin, newest.element());
        let pieces = self.gouges.behind.iter_mut();
        let hit = pieces
            .filter(|piece| piece.kind != Kind::Gone && !piece.rules.is_way && piece.index < since)
            .find_map(|piece| piece.way().damages(&newest, d.abs() - NEARER).then_some(piece.origin));
        if let Some(path) = hit {
            self.gouges.report(&path, &origin, d, diags);
        }
    }

    /// A piece of the path is settled.
    #[inline]
    pub(super) fn watch_path(&mut self, piece: &mut Piece, diags: &Diags) {
        let window = self.gouges.window.since;
        let in_window = piece.regular && piece.index >= window;
        if !in_window || self.gouges.behind.front().is_some_and(|oldest| oldest.index < window) {
            self.look_at_contour(piece, if in_window { window } else { u32::MAX }, diags);
        }
    }

    /// Does a piece of the path damage elements of the contour?
    #[inline(never)]
    fn look_at_contour(&mut self, piece: &mut Piece, since: u32, diags: &Diags) {
        if self.gouges.reported || piece.rules.is_way {
            return;
        }
        let (d, origin, way) = (self.d, piece.origin, piece.way());
        let pieces = self.gouges.behind.iter_mut().chain(&mut self.path).chain(&mut self.ahead);
        let hit = pieces
            .filter(|piece| piece.kind.is_of_contour() && !piece.rules.is_way && piece.index < since)
            .find_map(|piece| way.damages(&piece.element(), d.abs() - NEARER).then_some(piece.origin));
        if let Some(contour) = hit {
            self.gouges.report(&origin, &contour, d, diags);
        }
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
