//! Where the tool stands, seen from the bar or the casting of the section BLANK.
//!
//! Of what a program cut before only roughing counts, and only for the recesses behind it: a cycle that cuts from the tool on begins outside of all of it.

use std::rc::Rc;

use crate::geo::element::quarters;
use crate::geo::{Element, Point2};
use crate::ir::cycle::turning::Towards;
use crate::ir::cycle::{Cycle, Layers};

use super::blank::Blank;

/// So many roughing cycles are known.
const ROUGHED: usize = 16;

/// What was cut already.
#[derive(Debug, Default)]
pub(super) struct Stock {
    /// Something was cut from the blank.
    cut: bool,
    /// The last roughing, and the shift of the zero it counts from.
    roughed: Vec<(Rc<Layers>, f64)>,
}

impl Stock {
    /// The bar as (Z, X) of its lower and upper corner, while nothing was cut from it.
    pub fn uncut_bar(&self, blank: Option<Blank>) -> Option<(Point2, Point2)> {
        match blank {
            Some(Blank::Bar { radius, length, right, bore }) if !self.cut => {
                // A solid bar reaches beyond the turning centre.
                let inner = if bore > 0.0 { bore } else { -radius };
                Some((Point2::new(right - length, inner), Point2::new(right, radius)))
            }
            _ => None,
        }
    }

    /// Height of the stock over a contour after the roughing so far, where that is known to have passed all of it; `shift` is that
    /// of the zero.
    pub fn left_by_roughing(&self, contour: &[Element], into: Towards, shift: f64) -> Option<f64> {
        let pieces = contour.iter().flat_map(quarters);
        let along = pieces.flat_map(|e| [e.from(), e.to()]).map(|p| into.cutting_coordinate(p));
        let (low, high) = along.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        let out = -(into.unit().x + into.unit().y);
        let same = |at: &&(Rc<Layers>, f64)| at.0.into == into && at.1 == shift;
        let heights = self.roughed.iter().filter(same).filter_map(|(layers, _)| layers.leaves_standing(low, high));
        heights.min_by(|a, b| (a * out).total_cmp(&(b * out)))
    }

    /// The tool cuts to `to`: does that take something off the bar?
    #[inline]
    pub fn cut_to(&mut self, to: Point2, blank: Option<Blank>) {
        if let Some((low, high)) = self.uncut_bar(blank) {
            self.cut = to.x > low.x && to.x < high.x && to.y > low.y && to.y < high.y;
        }
    }

    /// Something is cut off.
    pub fn cut_somewhere(&mut self) {
        self.cut = true;
    }

    /// A cycle cuts. Threads and holes leave the surfaces as they are.
    pub fn cut_by(&mut self, cycle: &Cycle, shift: f64) {
        self.cut |= matches!(cycle, Cycle::Layers(_) | Cycle::Finishing(_));
        if let Cycle::Layers(layers) = cycle {
            if self.roughed.len() == ROUGHED {
                self.roughed.remove(0);
            }
            self.roughed.push((Rc::new(layers.clone()), shift));
        }
    }
}
