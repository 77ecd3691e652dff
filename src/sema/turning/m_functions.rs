//! M functions: those at the start of a block, those at its end, and those the configuration lets pass.

use crate::diag::{Answer, codes};
use crate::ir::Function;
use crate::ir::function::{Coolant, Spindle};
use crate::machine::Settings;
use crate::sema::common::m_functions::{end_last, standard};
use crate::sema::run::refusal::{Made, refused};

use super::words::{Fun, Words};
use super::{Outcome, Run};

/// What an M function does, if it is known or may pass.
fn what(m: Fun, settings: &Settings) -> Made<Function> {
    let number = u32::from(m.number);
    match standard(number) {
        Some(function) if !matches!(number, 2 | 7) => Ok(function),
        _ if settings.output.pass_m.contains(&number) => Ok(Function::Aux(number)),
        _ => refused(m.span, codes::P2007::m_belongs_to_machine(&number).answer(Answer::pass_m(number))),
    }
}

/// Refuses functions that contradict each other, before anything is done.
#[inline]
pub(super) fn check_m(w: &Words, settings: &Settings) -> Made {
    for (i, m) in w.m().iter().enumerate() {
        let function = what(*m, settings)?;
        for other in &w.m()[..i] {
            let clash = match (what(*other, settings)?, &function) {
                (Function::Spindle(_), Function::Spindle(_)) | (Function::Coolant(_), Function::Coolant(_)) => true,
                (Function::Aux(_), _) => false,
                (a, b) => a == *b,
            };
            if clash {
                return refused(m.span, codes::P1005::m_m_cannot_stand_in_one_block(&other.number, &m.number));
            }
        }
    }
    Ok(())
}

/// Does it act before the move of its block?
fn is_at_start(function: &Function) -> bool {
    match function {
        Function::Spindle(spindle) => matches!(spindle, Spindle::Start(_)),
        Function::Coolant(coolant) => *coolant != Coolant::Off,
        function => matches!(function, Function::Aux(_)),
    }
}

impl Run<'_> {
    /// What acts before the move, or after it.
    pub(super) fn m_functions(&mut self, w: &Words, at_start: bool) -> Outcome {
        for m in end_last(w.m(), |m| m.number == 30) {
            let function = self.core.made(what(m, self.core.job.settings))?;
            if is_at_start(&function) != at_start {
                continue;
            }
            match function {
                Function::Spindle(Spindle::Start(turn)) => self.turn_spindle(Some(turn)),
                Function::Spindle(_) => self.turn_spindle(None),
                Function::End { rewind } => self.end_of_job(rewind)?,
                function => self.core.send_function(&function, &self.st.ctx),
            }
        }
        Ok(())
    }
}
