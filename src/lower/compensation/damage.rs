//! Does the path damage the contour elsewhere? Neighbours are looked at when they are joined; here are the others.

use crate::diag::Diags;
use crate::geo::{Element, gap};
use crate::ir::Origin;

use super::piece::Piece;
use super::reports;

/// Elements looked back upon.
const DEPTH: usize = 16;
/// How much nearer than the radius a path may come, in mm: what a source rounded to three decimals loses.
const NEARER: f64 = 2e-3;

#[derive(Debug, Clone, Copy)]
struct Known {
    element: Element,
    /// Least and largest coordinates.
    least: [f64; 2],
    most: [f64; 2],
    origin: Origin,
}

impl Known {
    fn new(element: &Element, origin: Origin) -> Known {
        let (from, to) = (element.from(), element.to());
        let (least, most) = match *element {
            Element::Line { .. } => ([from.x.min(to.x), from.y.min(to.y)], [from.x.max(to.x), from.y.max(to.y)]),
            Element::Arc { center, .. } => {
                let r = crate::geo::distance(from, center);
                ([center.x - r, center.y - r], [center.x + r, center.y + r])
            }
        };
        Known { element: *element, least, most, origin }
    }

    fn is_far(&self, other: &Known, r: f64) -> bool {
        (0..2).any(|i| self.least[i] > other.most[i] + r || other.least[i] > self.most[i] + r)
    }
}

/// The last elements of the contour and of the path.
#[derive(Debug, Default)]
pub struct Damage {
    contour: Ring,
    path: Ring,
    reported: bool,
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
        } else {
            self.known[self.next % DEPTH] = known;
        }
        self.next = (self.next + 1) % DEPTH;
    }

    /// The one that `known` comes too near to.
    fn hit(&self, known: &Known, r: f64) -> Option<Origin> {
        let near = |other: &&Known| !known.is_far(other, r) && gap::between(&known.element, &other.element) < r;
        self.known.iter().find(near).map(|other| other.origin)
    }
}

impl Damage {
    pub fn forget(&mut self) {
        self.contour.known.clear();
        self.path.known.clear();
        (self.contour.next, self.path.next) = (0, 0);
        self.reported = false;
    }

    /// A contour begins with this element.
    pub fn begin(&mut self, first: &Piece) {
        self.forget();
        self.contour.add(Known::new(&first.contour, first.origin));
    }

    /// The control itself goes beyond the contour.
    pub fn is_wanted(&mut self) {
        self.reported = true;
    }

    /// An element of the contour.
    pub fn contour(&mut self, element: &Element, origin: &Origin, d: f64, diags: &Diags) {
        let known = Known::new(element, *origin);
        if let Some(of) = self.path.hit(&known, d.abs() - NEARER) {
            self.report(&of, origin, d, diags);
        }
        self.contour.add(known);
    }

    /// A settled piece of the path.
    pub fn path(&mut self, piece: &Piece, way: &Element, d: f64, diags: &Diags) {
        let known = Known::new(way, piece.origin);
        if let Some(of) = self.contour.hit(&known, d.abs() - NEARER) {
            self.report(&piece.origin, &of, d, diags);
        }
        self.path.add(known);
    }

    fn report(&mut self, path: &Origin, contour: &Origin, d: f64, diags: &Diags) {
        if !std::mem::replace(&mut self.reported, true) {
            diags.push(*reports::damaged(path, contour, d.abs()));
        }
    }
}
