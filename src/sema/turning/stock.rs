//! Where the tool stands, seen from the bar or the casting of the section BLANK.
//!
//! Of what a program cut before only roughing counts, and only for the recesses behind it: a cycle that cuts from the tool on begins outside of all of it.

use std::rc::Rc;

use crate::diag::codes;
use crate::geo::wall::quarters;
use crate::geo::{Element, Point2, distance};
use crate::ir::cycle::turning::Towards;
use crate::ir::cycle::{Cycle, Layers};

use super::geometry::Blank;
use super::{Outcome, Run};

/// So many roughing cycles are known.
const ROUGHED: usize = 16;

/// What arithmetic loses in a position, mm.
const SLACK: f64 = 1e-6;

/// The lower and the upper corner of a frame around a contour; arcs count as their circles.
fn frame(contour: &[Element]) -> (Point2, Point2) {
    let mut low = Point2::new(f64::INFINITY, f64::INFINITY);
    let mut high = -low;
    let mut take = |p: Point2, around: f64| {
        low = Point2::new(low.x.min(p.x - around), low.y.min(p.y - around));
        high = Point2::new(high.x.max(p.x + around), high.y.max(p.y + around));
    };
    for element in contour {
        take(element.from(), 0.0);
        take(element.to(), 0.0);
        if let Element::Arc { from, center, .. } = *element {
            take(center, distance(from, center));
        }
    }
    (low, high)
}

impl Run<'_> {
    /// Roughing begins at the tool: it stands outside of the blank along the infeed and along the cut.
    pub(super) fn check_stock(&self, contour: &[Element], at: Point2, into: Towards, number: u16) -> Outcome {
        let (radius, length, right, bore) = match self.geometry.blank {
            Some(Blank::Bar { radius, length, right, bore }) => (radius, length, right, bore),
            Some(Blank::Casting { oversize, bore }) => {
                let (low, high) = frame(contour);
                let inner = if bore { (low.y - oversize).max(0.0) } else { 0.0 };
                (high.y + oversize, high.x - low.x + 2.0 * oversize, high.x + oversize, inner)
            }
            None => return Ok(()),
        };
        let along = |p: Point2| if into.is_radial() { p.x } else { p.y };
        let ends = contour.iter().flat_map(|element| [along(element.from()), along(element.to())]);
        let (low, high) = ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        let cut = match (into.is_radial(), along(at) >= (low + high) / 2.0) {
            (true, true) => Towards::MinusZ,
            (true, false) => Towards::PlusZ,
            (false, true) => Towards::MinusX,
            (false, false) => Towards::PlusX,
        };
        for side in [into, cut] {
            let (word, tool, limit, free) = match side {
                Towards::MinusX => ("X", 2.0 * at.y, 2.0 * radius, at.y >= radius - SLACK),
                Towards::PlusX => ("X", 2.0 * at.y, 2.0 * bore, at.y <= bore + SLACK),
                Towards::MinusZ => ("Z", at.x, right, at.x >= right - SLACK),
                Towards::PlusZ => ("Z", at.x, right - length, at.x <= right - length + SLACK),
            };
            if !free {
                let beyond = if matches!(side, Towards::MinusX | Towards::MinusZ) { "or more" } else { "or less" };
                return self
                    .refuse(self.block_span(), codes::T2025::g_begins_at_tool(&number, &word, &tool, &limit, &beyond));
            }
        }
        Ok(())
    }

    /// The bar as (Z, X) of its lower and upper corner, while nothing was cut from it.
    pub(super) fn uncut_bar(&self) -> Option<(Point2, Point2)> {
        match self.geometry.blank {
            Some(Blank::Bar { radius, length, right, bore }) if !self.st.cut => {
                // A solid bar reaches beyond the turning centre.
                let inner = if bore > 0.0 { bore } else { -radius };
                Some((Point2::new(right - length, inner), Point2::new(right, radius)))
            }
            _ => None,
        }
    }

    /// The tool cuts to `to`: does that take something off the bar?
    #[inline]
    pub(super) fn cuts(&mut self, to: Point2) {
        if let Some((low, high)) = self.uncut_bar() {
            self.st.cut = to.x > low.x && to.x < high.x && to.y > low.y && to.y < high.y;
        }
    }

    /// Threads and holes leave the surfaces as they are.
    pub(super) fn cycle_cuts(&mut self, cycle: &Cycle) {
        self.st.cut |= matches!(cycle, Cycle::Layers(_) | Cycle::Finishing(_));
        if let Cycle::Layers(layers) = cycle {
            if self.st.roughed.len() == ROUGHED {
                self.st.roughed.remove(0);
            }
            self.st.roughed.push((Rc::new(layers.clone()), self.st.shift.total()));
        }
    }

    /// Height of the stock over a contour after the roughing so far, where that is known to have passed all of it.
    pub(super) fn left_by_roughing(&self, contour: &[Element], into: Towards) -> Option<f64> {
        let pieces = contour.iter().flat_map(quarters);
        let along = pieces.flat_map(|e| [e.from(), e.to()]).map(|p| into.cutting_coordinate(p));
        let (low, high) = along.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        let out = -(into.unit().x + into.unit().y);
        let same = |at: &&(Rc<Layers>, f64)| at.0.into == into && at.1 == self.st.shift.total();
        let heights = self.st.roughed.iter().filter(same).filter_map(|(layers, _)| layers.leaves_standing(low, high));
        heights.min_by(|a, b| (a * out).total_cmp(&(b * out)))
    }
}
