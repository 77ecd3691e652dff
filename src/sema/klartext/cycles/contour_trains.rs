//! Cycle 25: along the first contour of cycle 14, beside it or on it; cycle 270 says how it is approached and left.
//!
//! Source: K 6.6; F B7 (docs/sources.md).

use crate::diag::codes;
use crate::geo::Deg;
use crate::ir::Side;
use crate::ir::compensation::{Compensation, Search};
use crate::ir::cycle::milling::{Division, Heights, Mill};
use crate::ir::cycle::path_milling::{Form, LevelChange, Lift, Way};
use crate::ir::cycle::{Cycle, PathMilling};
use crate::sema::cycle::call::Made;

use super::Planned;
use super::call::{CycleCall, Instead};
use super::contours::{COMPENSATION, DEPTH, HEIGHT, KIND, SIDE, SURFACE, WAY, WAY_ANGLE, WAY_LENGTH, WAY_RADIUS};
use super::data::Train;

/// Straight down where no cycle 270 says otherwise.
const DOWN: Way = Way { form: Form::None, size: 0.0, spatial: false };

impl CycleCall<'_> {
    /// Cycle 25.
    pub fn contour_train(&self) -> Made<Planned> {
        self.no_coarse_tool()?;
        let radius = self.cutter_radius()?;
        let (feeds, step) = (self.contour_feeds()?, self.contour_infeed()?);
        let (deep, surface) = (self.given.length(DEPTH), self.given.length(SURFACE));
        let height = self.given.length(HEIGHT);
        if height <= surface {
            return self.refuse(codes::P2090::clearance_height_q7_does_not_lie_above(&height, &surface));
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
        let mill = Mill { plane: self.st.state.plane(), heights, radius, feeds };
        let Some(mill) = self.mill_down(deep, mill)? else { return Ok(Planned::default()) };
        let kind = self.given.or_zero(KIND);
        let allowance = self.given.length(SIDE);
        if allowance < 0.0 {
            return self.refuse(codes::P2090::is_below_zero(&SIDE, &allowance));
        }
        let Some(train) = &self.contours()?.train else { return self.without(Instead::Train) };
        let (side, way) = self.train_data(train)?;
        let rules = Compensation {
            radius: radius + allowance,
            search: Search { bottlenecks: true, ..Search::default() },
            ..Compensation::default()
        };
        let path = PathMilling {
            mill,
            contour: train.elements.clone(),
            side,
            rules,
            approach: way,
            leave: way,
            finishes_floor: true,
            between: LevelChange { lift: Lift::Retract, feed: None },
            alternates: false,
        };
        let path = self.in_kind(path, kind, allowance)?;
        Ok(Cycle::PathMilling(self.sound(path)?).into())
    }

    /// The sense of travel by Q15: with M3 the tool climbs on the left.
    fn in_kind(&self, path: PathMilling, kind: f64, allowance: f64) -> Made<PathMilling> {
        if path.side == Side::None {
            if allowance != 0.0 {
                return self.refuse(codes::P2090::q3_tool_goes_on_contour_itself(&allowance));
            }
            return match kind {
                1.0 => Ok(path),
                0.0 => {
                    Ok(PathMilling { alternates: true, between: LevelChange { lift: Lift::None, feed: None }, ..path })
                }
                other => self.refuse(codes::P2090::kind_of_milling_q15(&other)),
            };
        }
        if kind == 0.0 {
            return Ok(PathMilling { alternates: true, between: LevelChange { lift: Lift::None, feed: None }, ..path });
        }
        let climbs = self.is_climb(KIND, kind)?;
        Ok(if climbs == (path.side == Side::Left) { path } else { path.backwards() })
    }

    /// What cycle 270 says: the side, which counts in place of that of the contour, and the way.
    fn train_data(&self, train: &Train) -> Made<(Side, Way)> {
        let Some(data) = &train.data else { return Ok((train.side, DOWN)) };
        let side = match self.kept_of(data, COMPENSATION)? {
            0.0 => Side::None,
            1.0 => Side::Left,
            2.0 => Side::Right,
            other => return self.refuse_data(codes::P2090::side_q391_is_not_0_1(&other)),
        };
        let (form, size, name) = match self.kept_of(data, WAY)? {
            1.0 => {
                let angle = self.kept_of(data, WAY_ANGLE)?;
                if angle <= 0.0 || angle >= 360.0 {
                    return self.refuse_data(codes::P2090::angle_q393_of_arc_is_not_above(&angle));
                }
                (Form::Arc(Deg(angle)), self.kept_of(data, WAY_RADIUS)? * self.given.unit, WAY_RADIUS)
            }
            2.0 => (Form::Tangent, self.kept_of(data, WAY_LENGTH)? * self.given.unit, WAY_LENGTH),
            3.0 => (Form::Square, self.kept_of(data, WAY_LENGTH)? * self.given.unit, WAY_LENGTH),
            other => return self.refuse_data(codes::P2090::way_q390_is_not_1_2(&other)),
        };
        if size <= 0.0 {
            return self.refuse_data(codes::P2090::is_not_above_zero(&name, &size));
        }
        if side == Side::None && form != Form::Tangent {
            return self.refuse(codes::P2090::tool_goes_on_contour_itself());
        }
        Ok((side, Way { form, size, spatial: false }))
    }
}
