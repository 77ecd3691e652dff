//! M functions, and the tool change.
//!
//! Source: M 5.4, 7, 8 (docs/sources.md). When an M function acts is not documented: what starts something acts
//! before the move of its block, what ends something behind it.

use crate::diag::{Answer, codes};
use crate::ir::Function;
use crate::ir::function::{Coolant, Spindle};
use crate::machine::AxisSet;
use crate::machine::tools::ToolKey;
use crate::sema::common::hidden::By;
use crate::sema::common::m_functions::{end_last, standard};
use crate::text::Span;

use super::words::{At, Words};
use super::{Core, Outcome, Run};

/// Does a function that is known act before the move of its block?
fn acts_before(number: u32) -> Option<bool> {
    match number {
        3 | 4 | 6 | 7 | 8 | 13 | 14 | 19 => Some(true),
        0 | 1 | 2 | 5 | 9 | 30 => Some(false),
        _ => None,
    }
}

/// Functions of one group contradict each other.
fn groups(number: u32) -> [u8; 2] {
    match number {
        3 | 4 | 5 | 19 => [1, 0],
        7..=9 => [0, 2],
        13 | 14 => [1, 2],
        2 | 30 => [3, 0],
        _ => [0, 0],
    }
}

fn conflict(a: u32, b: u32) -> bool {
    groups(a).iter().any(|group| *group != 0 && groups(b).contains(group))
}

impl Core<'_> {
    /// M functions that are not known are refused before anything of the block acts.
    #[inline]
    pub(super) fn check_m(&self, w: &Words) -> Outcome {
        for (i, &(number, span)) in w.m().iter().enumerate() {
            if acts_before(number).is_none() && !self.job.settings.output.pass_m.contains(&number) {
                self.say(
                    span,
                    codes::P2007::m_is_function_of_machine_so_if_target(&number).answer(Answer::pass_m(number)),
                );
            }
            if let Some((first, _)) = w.m()[..i].iter().find(|(first, _)| conflict(*first, number)) {
                return self.refuse(span, codes::P1005::m_contradicts_m_of_same_block(&number, &first));
            }
        }
        Ok(())
    }
}

impl Run<'_> {
    #[inline]
    pub(super) fn m_at_start(&mut self, w: &Words, moves: bool) -> Outcome {
        for &(number, span) in w.m() {
            match acts_before(number) {
                Some(true) => self.act(number, span)?,
                None if self.core.job.settings.output.pass_m.contains(&number) => self.aux(number, span, moves),
                Some(false) | None => {}
            }
        }
        for &(number, span) in w.aux() {
            self.aux(number, span, moves);
        }
        Ok(())
    }

    /// An M function whose moment is not known.
    fn aux(&mut self, number: u32, span: Span, moves: bool) {
        if moves {
            self.core.say(span, codes::P2008::m_is_printed_before_move_of_its_block(&number));
        }
        self.core.send_function(&Function::Aux(number), &self.st.ctx);
        // It may be the one that starts a spindle of this machine.
        self.st.spindle.may_turn();
    }

    #[inline]
    pub(super) fn m_at_end(&mut self, w: &Words) -> Outcome {
        // Behind the end of the program nothing is done any more.
        for (number, span) in end_last(w.m(), |(number, _)| matches!(number, 2 | 30)) {
            if acts_before(number) == Some(false) {
                self.act(number, span)?;
            }
        }
        Ok(())
    }

    fn act(&mut self, number: u32, span: Span) -> Outcome {
        let function = match number {
            2 | 30 => return self.end_of_program(number == 30, span),
            6 if self.core.job.settings.control.mtc200.t_changes => {
                self.core.without_geometry("M6", span);
                return Ok(());
            }
            6 => return self.change(span),
            13 | 14 => standard(number - 10),
            19 => Some(Function::Spindle(Spindle::Orient(0.0))),
            _ => standard(number),
        };
        let Some(function) = function else { return Ok(()) };
        match function {
            Function::Spindle(Spindle::Start(turn)) => self.st.spindle.turns(Some(turn)),
            Function::Spindle(_) => self.st.spindle.turns(None),
            _ => {}
        }
        self.core.send_function(&function, &self.st.ctx);
        if matches!(number, 13 | 14) {
            self.core.send_function(&Function::Coolant(Coolant::Flood), &self.st.ctx);
        }
        Ok(())
    }

    /// T, and the change where T alone changes; where M6 stands in the same block that comes later.
    pub(super) fn tool_word(&mut self, at: At, changes: bool) -> Outcome {
        let number = self.core.made(at.whole("T"))?;
        self.st.tool.selected = Some(number);
        if self.core.job.settings.control.mtc200.t_changes {
            return self.change(at.span);
        }
        if !changes {
            let number = self.core.job.settings.tools.printed_number(number);
            self.core.send_function(&Function::ToolPrepare { number }, &self.st.ctx);
        }
        Ok(())
    }

    fn change(&mut self, span: Span) -> Outcome {
        let settings = self.core.job.settings;
        let Some(own) = self.st.tool.selected else {
            return self.core.refuse(span, codes::M2012::m6_without_selected_tool());
        };
        if self.st.compensation.is_on() {
            return self.core.refuse(span, codes::P1003::tool_changes_under_path_compensation());
        }
        self.st.tool.active = Some(own);
        self.core.accept(span, self.st.tool.length_acts_along_z(self.st.ctx.plane, settings))?;
        let number = settings.tools.printed_number(own);
        self.core.send_tool(&ToolKey::Number(own, 0), number, span, &self.st.ctx)?;
        // The new tool has its tip elsewhere.
        self.st.forget(AxisSet::MAIN);
        self.st.position.leave_start(AxisSet::MAIN);
        self.st.position.hide(AxisSet::MAIN, By::ToolChange, self.core.here.origin.loc);
        let known = self.core.stand_after_change(&mut self.st.position, &self.st.ctx);
        self.st.offsets.arrive(known.known());
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn contradictions() {
        assert!(conflict(3, 4) && conflict(8, 9) && conflict(13, 9) && conflict(3, 5) && conflict(13, 3));
        assert!(!conflict(3, 8) && !conflict(5, 9) && !conflict(1, 30) && conflict(2, 30));
    }
}
