//! Ruled surfaces: 231.
//!
//! Source: F B7 (docs/sources.md).

use crate::diag::codes;
use crate::geo::Point2;
use crate::ir::Feed;
use crate::ir::cycle::milling::{Division, Feeds, Heights, Mill};
use crate::ir::cycle::ruled::Corner;
use crate::ir::cycle::{Cycle, Ruled};

use super::cycles::DefinedCycle;
use super::cycles::call::Call;
use super::cycles::faces::CORNERS;
use super::cycles::milling::MILLING_FEED;
use super::{Outcome, Run};

impl Run<'_> {
    /// Cycle 231.
    pub(super) fn ruled_surface(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Cycle>> {
        if call.placed() {
            return self.refuse_cycle(cycle, codes::P9010::pattern_or_cycl_call_pos_with_surface());
        }
        let mut corners = [Corner { at: Point2::origin(), height: 0.0 }; 4];
        for (corner, [first, second, height]) in corners.iter_mut().zip(CORNERS) {
            corner.at = Point2::new(self.cycle_length(cycle, first)?, self.cycle_length(cycle, second)?);
            corner.height = self.cycle_length(cycle, height)?;
        }
        let [a, b, c, d] = corners;
        let radius = self.cutter_radius(cycle)?;
        let highest = corners.iter().map(|corner| corner.height).fold(f64::MIN, f64::max);
        let lowest = corners.iter().map(|corner| corner.height).fold(f64::MAX, f64::min);
        let plane = self.cycle_feed(cycle, MILLING_FEED, None)?;
        // The cycle names no height to travel at: a diameter of the tool above the surface.
        let heights = Heights {
            retract: highest + 2.0 * radius,
            reference: highest,
            clearance: 2.0 * radius,
            depth: lowest,
            step: 0.0,
            division: Division::Even,
            allowance: 0.0,
        };
        let surface = Ruled {
            mill: Mill { plane: self.st.plane(), heights, radius, feeds: Feeds { plane, depth: plane } },
            corners: [[a, b], [d, c]],
            rows: self.cuts(cycle)?,
            first: half(plane),
        };
        Ok(Some(Cycle::Ruled(self.sound(cycle, surface)?)))
    }
}

fn half(feed: Feed) -> Feed {
    match feed {
        Feed::PerMinute(value) => Feed::PerMinute(value / 2.0),
        Feed::PerRevolution(value) => Feed::PerRevolution(value / 2.0),
        // The same way in twice the time.
        Feed::InverseTime(value) => Feed::InverseTime(value / 2.0),
    }
}
