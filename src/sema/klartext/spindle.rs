//! Spindle and coolant, as the program switched them.

use crate::diag::codes;
use crate::ir::Function;
use crate::ir::cycle::drilling::DeepHole;
use crate::ir::function::{Coolant, Spindle, Turn};
use crate::text::Span;

use super::m_table::Act;
use super::{Core, Outcome};

/// What the program told the spindle.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct SpindleState {
    turn: Option<Turn>,
    /// The sense in which it turned last.
    used: Option<Turn>,
    speed: Option<f64>,
    /// Angle of cycle 13.
    orientation: Option<f64>,
    coolant: bool,
}

impl SpindleState {
    /// Sense of rotation, while it turns.
    pub fn turn(&self) -> Option<Turn> {
        self.turn
    }

    pub fn turns(&self) -> bool {
        self.turn.is_some()
    }

    /// The sense in which it turned last.
    pub fn used(&self) -> Option<Turn> {
        self.used
    }

    pub fn speed(&self) -> Option<f64> {
        self.speed
    }

    pub fn coolant(&self) -> bool {
        self.coolant
    }

    pub fn start(&mut self, turn: Turn) -> Function {
        (self.turn, self.used) = (Some(turn), Some(turn));
        Function::Spindle(Spindle::Start(turn))
    }

    pub fn stop(&mut self) -> Function {
        self.turn = None;
        Function::Spindle(Spindle::Stop)
    }

    /// Carries out an M function that switches spindle or coolant.
    pub fn switch(&mut self, act: Act) -> [Option<Function>; 2] {
        match act {
            Act::Spindle(turn) => [Some(self.start(turn)), None],
            Act::SpindleAndCoolant(turn) => [Some(self.start(turn)), Some(self.switch_coolant(true))],
            Act::SpindleStop => [Some(self.stop()), None],
            Act::CoolantOn => [Some(self.switch_coolant(true)), None],
            Act::CoolantOff => [Some(self.switch_coolant(false)), None],
            Act::Orient => {
                self.turn = None;
                [Some(Function::Spindle(Spindle::Orient(self.orientation.unwrap_or(0.0)))), None]
            }
            _ => [None, None],
        }
    }

    fn switch_coolant(&mut self, on: bool) -> Function {
        self.coolant = on;
        Function::Coolant(if on { Coolant::Flood } else { Coolant::Off })
    }

    /// S of the block at `span`.
    pub fn set_speed(&mut self, core: &Core<'_>, speed: f64, span: Span) -> Outcome<Function> {
        if speed < 0.0 {
            return core.refuse(span, codes::O9002::spindle_speed(&speed));
        }
        self.speed = Some(speed);
        Ok(Function::Spindle(Spindle::Speed(speed)))
    }

    /// What M0 stops besides the program, which it says.
    pub fn stop_all(&mut self, core: &Core<'_>, span: Span) -> [Option<Function>; 2] {
        let (turns, flows) = (self.turns(), self.coolant);
        let what = match (turns, flows) {
            (true, true) => "the spindle and the coolant",
            (true, false) => "the spindle",
            (false, true) => "the coolant",
            (false, false) => return [None, None],
        };
        core.say(span, codes::K2708::m0_also_stops(&what));
        [turns.then(|| self.stop()), flows.then(|| self.switch_coolant(false))]
    }

    /// What a deep hole leaves.
    pub fn leave_deep_hole(&mut self, hole: &DeepHole) {
        let (speed, turn) = match hole.entry {
            (speed, Some(turn)) => (speed, Some(turn)),
            (_, None) => (hole.drilling.0, None),
        };
        self.speed = Some(speed);
        self.used = turn.or(self.used);
        self.turn = turn;
        if let Some(last) = hole.coolant[1].or(hole.coolant[0]) {
            self.coolant = last != Coolant::Off;
        }
    }

    /// Cycle 13: where M19 stops the spindle.
    pub fn orient(&mut self, angle: f64) {
        self.orientation = Some(angle);
    }
}
