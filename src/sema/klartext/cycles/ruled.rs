//! Ruled surfaces: 231.
//!
//! Source: F B7 (docs/sources.md).

use crate::diag::codes;
use crate::geo::Point2;
use crate::ir::Feed;
use crate::ir::cycle::milling::{Division, Feeds, Heights, Mill};
use crate::ir::cycle::ruled::Corner;
use crate::ir::cycle::{Cycle, Ruled};
use crate::sema::cycle::call::Made;

use super::Planned;
use super::call::CycleCall;
use super::faces::CORNERS;
use super::milling::MILLING_FEED;

impl CycleCall<'_> {
    /// Cycle 231.
    pub fn ruled_surface(&self) -> Made<Planned> {
        if self.st.calling.placed() {
            return self.refuse(codes::P9010::pattern_or_cycl_call_pos_with_surface());
        }
        let mut corners = [Corner { at: Point2::origin(), height: 0.0 }; 4];
        for (corner, [first, second, height]) in corners.iter_mut().zip(CORNERS) {
            corner.at = Point2::new(self.given.length(first), self.given.length(second));
            corner.height = self.given.length(height);
        }
        let [a, b, c, d] = corners;
        let radius = self.cutter_radius()?;
        let highest = corners.iter().map(|corner| corner.height).fold(f64::MIN, f64::max);
        let lowest = corners.iter().map(|corner| corner.height).fold(f64::MAX, f64::min);
        let plane = self.feed(MILLING_FEED)?;
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
            mill: Mill { plane: self.st.state.plane(), heights, radius, feeds: Feeds { plane, depth: plane } },
            corners: [[a, b], [d, c]],
            rows: self.cuts(),
            first: half(plane),
        };
        Ok(Cycle::Ruled(self.sound(surface)?).into())
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
