//! End points of rotary axes, those that count modulo 360 degrees among them.
//!
//! Source: S 2.6 (docs/sources.md).

use crate::diag::codes;
use crate::machine::Axis;

use super::g_groups::GCode;
use super::words::{Given, Mode};
use super::{Core, Outcome, Reported, State};

impl State {
    /// The end point of a rotary axis in degrees, unless it is an increment. Those of a modulo axis count on from the last
    /// one, turn by turn; DC, ACP and ACN are the shortest way, or a way of one sense.
    pub(super) fn rotary_target(&mut self, core: &Core<'_>, axis: Axis, given: Given) -> Outcome<f64> {
        let way = match given.mode {
            Mode::Plain | Mode::Ac if !self.machine.modulo.contains(axis) => return Ok(given.value),
            Mode::Plain | Mode::Ac => return self.modulo_target(core, axis, given),
            Mode::Acp => Way::Up,
            Mode::Acn => Way::Down,
            Mode::Dc => Way::Short,
            _ => return core.no_diameter_axis(given.span),
        };
        core.inside_one_turn(given)?;
        self.machine.modulo.insert(axis);
        if let Some(at) = self.position.get(axis) {
            return Ok(counted_on(at, given.value, way));
        }
        // In front of any other position of the axis the place is the same whatever the way to it.
        if given.mode != Mode::Dc || !self.is(GCode::G0) || self.position.is_lost(axis) {
            return self.unknown_axis(core, axis, given.span);
        }
        core.say_once(given.span, codes::S8044::where_stands_is_not_known(&axis.letter()));
        Ok(given.value)
    }

    /// `C20` of a modulo axis: up or down inside the turn in which it stands.
    fn modulo_target(&self, core: &Core<'_>, axis: Axis, given: Given) -> Outcome<f64> {
        core.inside_one_turn(given)?;
        if self.position.is_lost(axis) {
            return Err(Reported);
        }
        let Some(at) = self.position.get(axis) else {
            core.say_once(given.span, codes::S8044::where_stands_is_not_known_its_way(&axis.letter()));
            return Ok(given.value);
        };
        let shortest = core.job.settings.control.sinumerik.modulo_shortest;
        if !shortest && reduced(self.ctx.frame.shift_of(axis)) != 0.0 {
            // Which way is meant depends on where the turn of the axis begins: in the program or on the machine.
            return core.refuse(given.span, codes::S9101::sense_in_which_turns_is_not_known(&axis.letter()));
        }
        Ok(counted_on(at, given.value, if shortest { Way::Short } else { Way::Inside }))
    }
}

impl Core<'_> {
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
