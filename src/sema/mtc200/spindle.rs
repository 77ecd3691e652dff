//! S, G92, G96 and G97.
//!
//! Source: M 5.4, 7 (docs/sources.md).

use crate::diag::{Answer, Fault, codes};
use crate::ir::function::Spindle;
use crate::machine::options::mtc200::InchSpeed;
use crate::machine::{Settings, Unit};
use crate::sema::common::spindle::{ModalSpindle, SpeedKind};
use crate::sema::run::refusal::{Made, refused};

use super::dimensions::Dimensions;
use super::g_functions::{G, Group};
use super::words::{At, Words};

/// G96 (`on`) and G97: where S counts something else now, the block has to say it.
pub(super) fn count(spindle: &mut ModalSpindle, on: bool, w: &Words) -> Result<(), Fault> {
    let changes = spindle.count(if on { SpeedKind::Cutting } else { SpeedKind::Turns });
    let limit_only = w.g[Group::Once as usize].is_some_and(|(g, _)| g == G::SpeedLimit);
    if changes && (w.speed.is_none() || limit_only) {
        let (name, form) = if on { ("G96", "G96 S180") } else { ("G97", "G97 S1200") };
        return Err(codes::P1004::needs_its_s_in_same_block(&name, &form));
    }
    Ok(())
}

/// S, or the limit of G92: what it has the spindle do.
pub(super) fn speed(
    spindle: &mut ModalSpindle,
    at: At,
    limit: bool,
    dimensions: Dimensions,
    settings: &Settings,
) -> Made<Option<Spindle>> {
    if at.value < 0.0 || (limit && at.value == 0.0) {
        return refused(at.span, codes::M2705::spindle_speed(&at.value));
    }
    if limit {
        spindle.set_limit(at.value);
        return Ok(spindle.cutting_speed());
    }
    if !spindle.is_cutting() {
        return Ok(Some(Spindle::Speed(at.value)));
    }
    let metres = match (dimensions.inch, settings.control.mtc200.inch_speed) {
        (false, _) | (true, InchSpeed::Metres) => at.value,
        (true, InchSpeed::Feet) => at.value * Unit::FOOT,
        (true, InchSpeed::Refuse) => {
            return refused(
                at.span,
                codes::M9007::unit_of_cutting_speed_under_g70().answer(Answer::key("control", "inch_speed")),
            );
        }
    };
    spindle.set_speed(metres);
    Ok(spindle.cutting_speed())
}
