//! The old pockets and slots: 3 to 5. The tool stands at the set-up clearance over them, and comes back to there.
//!
//! Source: K 6.5; F B5 (docs/sources.md).

use crate::diag::codes;
use crate::geo::{Deg, Point2};
use crate::ir::Feed;
use crate::ir::cycle::milling::{Division, Feeds, Heights, Mill, Place};
use crate::ir::cycle::pocket::{Between, Insertion, Pocket, Shape, Strategy};
use crate::ir::cycle::{Cycle, LongHole};
use crate::machine::{Axis, AxisSet};

use super::cycles::old_pockets::PLUNGING;
use super::cycles::{DefinedCycle, What};
use super::{Outcome, Run};

/// A tool that differs by less has the width of the slot, mm.
const SAME_WIDTH: f64 = 1e-4;

impl Run<'_> {
    /// Cycle 3.
    pub(super) fn old_slot(&mut self, cycle: &DefinedCycle) -> Outcome<Option<Cycle>> {
        let mill = self.old_cutter(cycle, 6)?;
        let ([along, across], [length, width]) = self.old_sides(cycle)?;
        if width <= 0.0 || length.abs() <= width {
            return self.refuse_value(
                cycle,
                codes::P2090::length_mm_of_slot_is_not_above(&along.letter(), &length, &across.letter(), &width),
            );
        }
        if (width - 2.0 * mill.radius).abs() > SAME_WIDTH {
            let what = format!(
                "a slot of {width} mm with a tool of {} mm (where the slot lies beside the tool is not documented)",
                2.0 * mill.radius
            );
            let help = "take a tool as wide as the slot, or program cycle 253 with its place";
            return self.cycle_otherwise(cycle, &what, help);
        }
        let start = self.call_point(cycle)?;
        let way = (length.abs() - width) * length.signum();
        let (first, _, _) = mill.plane.axes();
        let end = if along == Axis::ALL[first] {
            Point2::new(start.x + way, start.y)
        } else {
            Point2::new(start.x, start.y + way)
        };
        let slot = LongHole { mill, holes: vec![[start, end]], home: Some(start) };
        Ok(Some(Cycle::LongHole(self.sound(cycle, slot)?)))
    }

    /// Cycle 4.
    pub(super) fn old_rectangle(&mut self, cycle: &DefinedCycle) -> Outcome<Option<Cycle>> {
        let mill = self.old_cutter(cycle, 6)?;
        let ([along, _], sides) = self.old_sides(cycle)?;
        if let Some(side) = sides.into_iter().find(|side| *side <= 0.0) {
            return self.refuse_value(cycle, codes::P2090::side_of_mm_is_not_above_zero(&side));
        }
        let (first, _, _) = mill.plane.axes();
        let half = if along == Axis::ALL[first] { sides } else { [sides[1], sides[0]] }.map(|side| side / 2.0);
        self.fits(cycle, &Shape::Rectangle { half, corner: 0.0 }, mill.radius)?;
        let corner = match cycle.in_part(6, What::Value).map(|corner| corner * cycle.mm) {
            Some(corner) if corner < 0.0 => {
                return self.refuse_value(cycle, codes::P2090::radius_of_corners_is_below_zero(&corner));
            }
            Some(corner) => self.corner_of(cycle, ("RADIUS", corner), mill.radius)?,
            None => 0.0,
        };
        // The first way leads towards plus of the longer side, of a square towards plus of the second axis.
        let turn = if half[0] == half[1] { Deg(90.0) } else { Deg(180.0) };
        self.old_pocket(cycle, mill, Shape::Rectangle { half, corner }, (6, turn))
    }

    /// Cycle 5.
    pub(super) fn old_circle(&mut self, cycle: &DefinedCycle) -> Outcome<Option<Cycle>> {
        let mill = self.old_cutter(cycle, 5)?;
        let radius = cycle.in_part(4, What::Value).unwrap_or(0.0) * cycle.mm;
        if radius <= 0.0 {
            return self.refuse_value(cycle, codes::P2090::radius_of_pocket_is_not_above_zero(&radius));
        }
        self.fits(cycle, &Shape::Circle { radius }, mill.radius)?;
        self.old_pocket(cycle, mill, Shape::Circle { radius }, (5, Deg(0.0)))
    }

    /// A pocket over whose middle the tool stands; the part that says DR.
    fn old_pocket(
        &mut self,
        cycle: &DefinedCycle,
        mill: Mill,
        shape: Shape,
        (part, turn): (u32, Deg),
    ) -> Outcome<Option<Cycle>> {
        let start = self.call_point(cycle)?;
        let pocket = Pocket {
            counter_clockwise: cycle.in_part(part, What::Turn).is_some_and(|turn| turn > 0.0),
            width: self.job.settings.cycles.klartext.old_overlap * mill.radius,
            mill,
            shape,
            places: vec![Place { at: start, turn }],
            allowance: 0.0,
            insertion: Insertion::Vertical,
            strategy: Strategy::Levels,
            rough: true,
            finish: None,
            cleared: None,
            transfer: None,
            between: Between::Lifted,
            home: Some(start),
        };
        self.milled(cycle, pocket)
    }

    /// The cutter of an old pocket; the part that says the feed for milling.
    fn old_cutter(&mut self, cycle: &DefinedCycle, milling: u32) -> Outcome<Mill> {
        let axis = self.st.axis();
        if !AxisSet::MAIN.contains(axis) {
            return self.refuse_value(cycle, codes::P2090::tool_axis_cannot_mill(&axis.letter()));
        }
        let radius = self.cutter_radius(cycle)?;
        let levels = self.old_levels(cycle, axis)?;
        let step = cycle.in_part(3, What::Value).unwrap_or(0.0).abs() * cycle.mm;
        if step == 0.0 {
            return self.refuse_value(cycle, codes::P2090::infeed_in_depth_is_0());
        }
        let heights = Heights {
            retract: levels.retract,
            reference: levels.reference,
            clearance: levels.clearance,
            depth: levels.depth,
            step,
            division: Division::Whole,
            allowance: 0.0,
        };
        let feeds = Feeds { plane: self.old_feed(cycle, milling)?, depth: self.old_feed(cycle, PLUNGING)? };
        Ok(Mill { plane: self.st.plane(), heights, radius, feeds })
    }

    fn old_feed(&mut self, cycle: &DefinedCycle, part: u32) -> Outcome<Feed> {
        let value = cycle.in_part(part, What::Feed).unwrap_or(0.0);
        self.check_feed(cycle, value)
    }

    /// Axes and lengths of the parts 4 and 5: both axes of the plane.
    fn old_sides(&mut self, cycle: &DefinedCycle) -> Outcome<([Axis; 2], [f64; 2])> {
        let (first, second, _) = self.st.plane().axes();
        let plane: AxisSet = [first, second].map(|axis| Axis::ALL[axis]).into_iter().collect();
        match (cycle.along(4), cycle.along(5)) {
            (Some((a, length)), Some((b, width))) if a != b && plane.contains(a) && plane.contains(b) => {
                Ok(([a, b], [length * cycle.mm, width * cycle.mm]))
            }
            _ => self.refuse_value(cycle, codes::P2090::its_two_sides_do_not_lie_along()),
        }
    }
}
