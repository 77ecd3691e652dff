//! End points of rotary axes, those that count modulo 360 degrees among them.
//!
//! Source: S 2.6 (docs/sources.md).

use crate::diag::codes;
use crate::machine::Axis;
use crate::text::Span;

use super::g_groups::GCode;
use super::state::State;
use super::words::{Given, Mode};
use super::{Core, Outcome, Reported};

impl State {
    /// The end point of a rotary axis in degrees. Those of a modulo axis count on from the last one, turn by turn.
    pub(super) fn rotary_target(&mut self, core: &Core<'_>, axis: Axis, given: Given) -> Outcome<f64> {
        let incremental = match given.mode {
            Mode::Plain => self.is(GCode::G91),
            Mode::Ac => false,
            Mode::Ic => true,
            Mode::Dc | Mode::Acp | Mode::Acn => return self.directed_target(core, axis, given),
            _ => return core.no_diameter_axis(given.span),
        };
        if incremental {
            return Ok(self.increment_base(core, axis, given.span)? + given.value);
        }
        if self.machine.modulo.contains(axis) { self.modulo_target(core, axis, given) } else { Ok(given.value) }
    }

    /// DC, ACP and ACN: the shortest way, or a way of one sense.
    fn directed_target(&mut self, core: &Core<'_>, axis: Axis, given: Given) -> Outcome<f64> {
        core.inside_one_turn(given)?;
        self.machine.modulo.insert(axis);
        let Some(at) = self.position.get(axis) else {
            return self.first_rotary_target(core, axis, given);
        };
        let way = match given.mode {
            Mode::Acp => Way::Up,
            Mode::Acn => Way::Down,
            _ => Way::Short,
        };
        Ok(counted_on(at, given.value, way))
    }

    /// `C20` of a modulo axis: up or down inside the turn in which it stands.
    fn modulo_target(&mut self, core: &Core<'_>, axis: Axis, given: Given) -> Outcome<f64> {
        core.inside_one_turn(given)?;
        if self.position.is_lost(axis) {
            return Err(Reported);
        }
        let Some(at) = self.position.get(axis) else {
            let letter = axis.letter();
            core.say_once(given.span, codes::S8044::where_stands_is_not_known_its_way(&letter));
            return Ok(given.value);
        };
        let shift = self.ctx.frame.shift_of(axis);
        if reduced(shift) != 0.0 && !core.job.settings.control.sinumerik.modulo_shortest {
            return core.modulo_under_a_shift(axis, given.span);
        }
        let shortest = core.job.settings.control.sinumerik.modulo_shortest;
        Ok(counted_on(at, given.value, if shortest { Way::Short } else { Way::Inside }))
    }

    /// `C=DC(30)` in front of any other position of the axis: the place is the same whatever the way to it.
    fn first_rotary_target(&mut self, core: &Core<'_>, axis: Axis, given: Given) -> Outcome<f64> {
        if given.mode != Mode::Dc || !self.is(GCode::G0) || self.position.is_lost(axis) {
            return self.unknown_axis(core, axis, given.span);
        }
        let letter = axis.letter();
        core.say_once(given.span, codes::S8044::where_stands_is_not_known(&letter));
        Ok(given.value)
    }
}

impl Core<'_> {
    /// Which way is meant depends on where the turn of the axis begins: in the program or on the machine.
    fn modulo_under_a_shift(&self, axis: Axis, span: Span) -> Outcome<f64> {
        let letter = axis.letter();
        self.refuse(span, codes::S9101::sense_in_which_turns_is_not_known(&letter))
    }

    fn inside_one_turn(&self, given: Given) -> Outcome {
        if (0.0..360.0).contains(&given.value) {
            return Ok(());
        }
        self.refuse(given.span, codes::S2061::lies_outside_0_to_359_999(&given.value))
    }
}

/// An angle inside 0 to below 360 degrees.
pub(super) fn reduced(angle: f64) -> f64 {
    angle - 360.0 * libm::floor(angle / 360.0)
}

/// How an axis that counts modulo 360 degrees goes to a position.
#[derive(Debug, Clone, Copy)]
enum Way {
    Up,
    Down,
    /// Half a turn goes up.
    Short,
    /// Inside the turn in which it stands.
    Inside,
}

/// Angles closer than this are one: increments add up with the last bits of a number, controls count in 0.001 degrees.
const ONE_ANGLE: f64 = 1e-6;

/// The angle `to` in the turn in which an axis that stands at `at` reaches it.
fn counted_on(at: f64, to: f64, way: Way) -> f64 {
    let tiny = ONE_ANGLE / 360.0;
    let turns = (at - to) / 360.0;
    let turn = match way {
        Way::Up => libm::ceil(turns - tiny),
        Way::Down => libm::floor(turns + tiny),
        Way::Short => libm::floor(turns + 0.5 + tiny),
        Way::Inside => libm::floor(at / 360.0 + tiny),
    };
    to + 360.0 * turn
}
