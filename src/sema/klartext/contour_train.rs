//! Cycle 25: along the first contour of cycle 14, beside it or on it; cycle 270 says how it is approached and left.
//!
//! Source: K 6.6; F B7 (docs/sources.md).

use crate::diag::codes;
use crate::geo::{Deg, Element};
use crate::ir::compensation::Compensation;
use crate::ir::cycle::milling::{Division, Heights, Mill};
use crate::ir::cycle::path_milling::{Between, Form, Lift, Way};
use crate::ir::cycle::{Cycle, PathMilling};
use crate::ir::{Side, compensation::Search};
use crate::sema::Reported;

use super::contour_data::Known;
use super::cycles::DefinedCycle;
use super::cycles::call::Call;
use super::cycles::contours::{
    COMPENSATION, DEPTH, HEIGHT, KIND, SIDE, SURFACE, WAY, WAY_ANGLE, WAY_LENGTH, WAY_RADIUS,
};
use super::{Outcome, Run};

/// Straight down where no cycle 270 says otherwise.
const DOWN: Way = Way { form: Form::None, size: 0.0, spatial: false };

impl Run<'_> {
    /// Cycle 25.
    pub(super) fn contour_train(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Cycle>> {
        let named = self.named_contours(cycle, call)?;
        self.no_coarse_tool(cycle)?;
        let radius = self.cutter_radius(cycle)?;
        let (feeds, step) = (self.contour_feeds(cycle)?, self.contour_infeed(cycle)?);
        let (deep, surface) = (self.cycle_length(cycle, DEPTH)?, self.cycle_length(cycle, SURFACE)?);
        let height = self.cycle_length(cycle, HEIGHT)?;
        if height <= surface {
            return self.refuse_value(cycle, codes::P2090::clearance_height_q7_does_not_lie_above(&height, &surface));
        }
        let heights = Heights {
            retract: height,
            reference: surface,
            // The cycle has no set-up clearance: from the clearance height on it feeds.
            clearance: height - surface,
            depth: surface + deep,
            step,
            division: Division::Whole,
            allowance: 0.0,
        };
        let mill = Mill { plane: self.st.plane(), heights, radius, feeds };
        let Some(mill) = self.mill_down(cycle, deep, mill)? else { return Ok(None) };
        let kind = self.cycle_number(cycle, KIND)?;
        let allowance = self.cycle_length(cycle, SIDE)?;
        if allowance < 0.0 {
            return self.refuse_value(cycle, codes::P2090::q3_is_below_zero(&allowance));
        }
        if named.labels.len() > 1 {
            let found = codes::K2954::cycle_25_mills_first_contour_of_cycle().at(self.here.origin.loc);
            self.report(
                found
                    .also(named.loc, "they are named here")
                    .help("name the contour alone, and call the cycle once for each contour"),
            );
        }
        let Some(label) = named.labels.first() else { return Err(Reported) };
        let contour = self.capture(label, cycle.loc)?;
        self.check_contour(label, &contour)?;
        let Some(side) = contour.side else {
            let help = "write RL, RR or nothing into its first block, and nothing behind it";
            return self.contour_fault(label, "its side changes", help);
        };
        let (side, way) = self.train_data(cycle, side)?;
        let elements: Vec<Element> = contour.pieces.iter().map(|piece| piece.element).collect();
        let rules = Compensation {
            radius: radius + allowance,
            search: Search { bottlenecks: true, ..Search::default() },
            ..Compensation::default()
        };
        let path = PathMilling {
            mill,
            contour: elements,
            side,
            rules,
            approach: way,
            leave: way,
            finishes_floor: true,
            between: Between { lift: Lift::Retract, feed: None },
            alternates: false,
        };
        let path = self.in_kind(cycle, path, kind, allowance)?;
        self.sound(cycle, path).map(|made| Some(Cycle::PathMilling(made)))
    }

    /// The sense of travel by Q15: with M3 the tool climbs on the left.
    fn in_kind(&mut self, cycle: &DefinedCycle, path: PathMilling, kind: f64, allowance: f64) -> Outcome<PathMilling> {
        if path.side == Side::None {
            if allowance != 0.0 {
                return self.refuse_value(cycle, codes::P2090::q3_tool_goes_on_contour_itself(&allowance));
            }
            return match kind {
                1.0 => Ok(path),
                0.0 => Ok(PathMilling { alternates: true, between: Between { lift: Lift::None, feed: None }, ..path }),
                other => self.refuse_value(cycle, codes::P2090::kind_of_milling_q15(&other)),
            };
        }
        if kind == 0.0 {
            return Ok(PathMilling { alternates: true, between: Between { lift: Lift::None, feed: None }, ..path });
        }
        let climbs = self.is_climb(cycle, KIND, kind)?;
        Ok(if climbs == (path.side == Side::Left) { path } else { path.backwards() })
    }

    /// What cycle 270 says: the side, which counts in place of that of the contour, and the way.
    fn train_data(&mut self, cycle: &DefinedCycle, side: Side) -> Outcome<(Side, Way)> {
        let data = match &self.contours.train {
            Known::Nothing => return Ok((side, DOWN)),
            Known::Lost => return Err(Reported),
            Known::Given(data) => std::rc::Rc::clone(data),
        };
        let side = match self.kept(&data, COMPENSATION)? {
            0.0 => Side::None,
            1.0 => Side::Left,
            2.0 => Side::Right,
            other => return self.refuse_value(&data.cycle, codes::P2090::side_q391_is_not_0_1(&other)),
        };
        let (form, size, q) = match self.kept(&data, WAY)? {
            1.0 => {
                let angle = self.kept(&data, WAY_ANGLE)?;
                if angle <= 0.0 || angle >= 360.0 {
                    return self.refuse_value(&data.cycle, codes::P2090::angle_q393_of_arc_is_not_above(&angle));
                }
                (Form::Arc(Deg(angle)), self.kept_length(&data, WAY_RADIUS)?, WAY_RADIUS)
            }
            2.0 => (Form::Tangent, self.kept_length(&data, WAY_LENGTH)?, WAY_LENGTH),
            3.0 => (Form::Square, self.kept_length(&data, WAY_LENGTH)?, WAY_LENGTH),
            other => return self.refuse_value(&data.cycle, codes::P2090::way_q390_is_not_1_2(&other)),
        };
        if size <= 0.0 {
            return self.refuse_value(&data.cycle, codes::P2090::is_not_above_zero(&q, &size));
        }
        if side == Side::None && form != Form::Tangent {
            return self.refuse_value(cycle, codes::P2090::tool_goes_on_contour_itself());
        }
        Ok((side, Way { form, size, spatial: false }))
    }
}
