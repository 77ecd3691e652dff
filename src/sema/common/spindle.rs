//! The spindle, as far as the program says: whether it turns, what S counts, and how fast it may turn.

use crate::ir::function::{Spindle, Turn};

/// What S counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SpeedKind {
    /// Revolutions per minute.
    Turns,
    /// Cutting speed in m/min.
    Cutting,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
enum Turning {
    #[default]
    Stands,
    Turns(Turn),
    /// A function of the machine may have started it.
    MayTurn,
}

/// What the program told the spindle.
#[derive(Debug, Clone, Copy, Default)]
pub struct ModalSpindle {
    turning: Turning,
    /// `None` until the program says it.
    kind: Option<SpeedKind>,
    /// S, as its kind counts.
    speed: Option<f64>,
    /// Highest speed in rev/min.
    limit: Option<f64>,
}

impl ModalSpindle {
    /// S counts `kind` until the program says something else.
    pub fn counting(kind: SpeedKind) -> ModalSpindle {
        ModalSpindle { kind: Some(kind), ..ModalSpindle::default() }
    }

    /// Sense of rotation, while it turns.
    pub fn turn(&self) -> Option<Turn> {
        match self.turning {
            Turning::Turns(turn) => Some(turn),
            Turning::Stands | Turning::MayTurn => None,
        }
    }

    /// It does not turn, as far as the program says.
    pub fn stands(&self) -> bool {
        self.turning == Turning::Stands
    }

    /// Sense of rotation from here on, or none.
    pub fn turns(&mut self, turn: Option<Turn>) {
        self.turning = turn.map_or(Turning::Stands, Turning::Turns);
    }

    /// A function of the machine may start it.
    pub fn may_turn(&mut self) {
        self.turning = Turning::MayTurn;
    }

    pub fn kind(&self) -> Option<SpeedKind> {
        self.kind
    }

    pub fn is_cutting(&self) -> bool {
        self.kind == Some(SpeedKind::Cutting)
    }

    /// S counts `kind` from here on. True if it counted something else: the speed of before is none any more.
    pub fn count(&mut self, kind: SpeedKind) -> bool {
        let changes = self.kind != Some(kind);
        if changes {
            self.speed = None;
        }
        self.kind = Some(kind);
        changes
    }

    pub fn speed(&self) -> Option<f64> {
        self.speed
    }

    /// S, where it counts in turns.
    pub fn speed_in_turns(&self) -> Option<f64> {
        self.speed.filter(|_| self.kind == Some(SpeedKind::Turns))
    }

    pub fn set_speed(&mut self, speed: f64) {
        self.speed = Some(speed);
    }

    pub fn set_limit(&mut self, limit: f64) {
        self.limit = Some(limit);
    }

    /// A number of turns, kept under the limit.
    pub fn limited(&self, turns: f64) -> f64 {
        self.limit.map_or(turns, |limit| turns.min(limit))
    }

    /// The cutting speed in force, with its limit.
    pub fn cutting_speed(&self) -> Option<Spindle> {
        let speed = self.speed.filter(|_| self.is_cutting())?;
        Some(Spindle::CuttingSpeed { speed, limit: self.limit })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_speed_of_the_other_kind_is_none() {
        let mut spindle = ModalSpindle::default();
        assert!(spindle.count(SpeedKind::Cutting));
        spindle.set_speed(180.0);
        spindle.set_limit(2000.0);
        assert_eq!(spindle.cutting_speed(), Some(Spindle::CuttingSpeed { speed: 180.0, limit: Some(2000.0) }));
        assert!(!spindle.count(SpeedKind::Cutting) && spindle.speed() == Some(180.0));
        assert!(spindle.count(SpeedKind::Turns));
        assert_eq!((spindle.speed(), spindle.cutting_speed()), (None, None));
        assert_eq!(spindle.limited(3000.0), 2000.0);
    }

    #[test]
    fn what_the_machine_may_start_has_no_sense() {
        let mut spindle = ModalSpindle::default();
        assert!(spindle.stands());
        spindle.may_turn();
        assert!(!spindle.stands() && spindle.turn().is_none());
        spindle.turns(None);
        assert!(spindle.stands());
    }
}
