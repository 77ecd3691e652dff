//! M functions: those at the start of a block, those at its end, and those the configuration lets pass.

use crate::diag::{Answer, codes};
use crate::ir::Function;
use crate::ir::function::{Coolant, Turn};

use super::words::{Fun, Words};
use super::{Outcome, Run};

/// What an M function does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum What {
    Spindle(Option<Turn>),
    Coolant(Coolant),
    Stop,
    OptionalStop,
    End,
    Pass,
}

impl Run<'_> {
    fn what(&self, m: Fun) -> Outcome<What> {
        Ok(match m.number {
            0 => What::Stop,
            1 => What::OptionalStop,
            3 => What::Spindle(Some(Turn::Clockwise)),
            4 => What::Spindle(Some(Turn::CounterClockwise)),
            5 => What::Spindle(None),
            8 => What::Coolant(Coolant::Flood),
            9 => What::Coolant(Coolant::Off),
            30 => What::End,
            number if self.core.job.settings.output.pass_m.contains(&u32::from(number)) => What::Pass,
            number => {
                return self
                    .core
                    .refuse(m.span, codes::P2007::m_belongs_to_machine(&number).answer(Answer::pass_m(number)));
            }
        })
    }

    /// Refuses functions that contradict each other, before anything is done.
    pub(super) fn check_m(&self, w: &Words) -> Outcome {
        for (i, m) in w.m().iter().enumerate() {
            let what = self.what(*m)?;
            for other in &w.m()[..i] {
                let clash = match (self.what(*other)?, what) {
                    (What::Spindle(_), What::Spindle(_)) | (What::Coolant(_), What::Coolant(_)) => true,
                    (a, b) => a == b && a != What::Pass,
                };
                if clash {
                    return self
                        .core
                        .refuse(m.span, codes::P1005::m_m_cannot_stand_in_one_block(&other.number, &m.number));
                }
            }
        }
        Ok(())
    }

    /// What acts before the move.
    pub(super) fn m_at_start(&mut self, w: &Words) -> Outcome {
        for m in w.m() {
            match self.what(*m)? {
                What::Spindle(Some(turn)) => self.turn_spindle(Some(turn)),
                What::Coolant(coolant) if coolant != Coolant::Off => self.function(Function::Coolant(coolant)),
                What::Pass => self.function(Function::Aux(u32::from(m.number))),
                _ => {}
            }
        }
        Ok(())
    }

    /// What acts after the move.
    pub(super) fn m_at_end(&mut self, w: &Words) -> Outcome {
        // The end of the job comes last, wherever it stands in the block.
        for last in [false, true] {
            for m in w.m() {
                let what = self.what(*m)?;
                if matches!(what, What::End) != last {
                    continue;
                }
                match what {
                    What::Spindle(None) => self.turn_spindle(None),
                    What::Coolant(Coolant::Off) => self.function(Function::Coolant(Coolant::Off)),
                    What::Stop => self.function(Function::Stop),
                    What::OptionalStop => self.function(Function::OptionalStop),
                    What::End => self.end_of_job(true)?,
                    _ => {}
                }
            }
        }
        Ok(())
    }
}
