//! Which block changes the tool: the TOOL CALL, or an M6 of the program's own.
//!
//! Many programs write `TOOL CALL 2 Z S2000`, retract, and then M6: a change at the TOOL CALL would come in the cut.
//! Others never write M6, and there TOOL CALL is the change. Which of the two a program does is looked up once in its
//! text; what the run then meets has to fit to it, or is refused. Source: K 1.5 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::ir::Function;
use crate::machine::AxisSet;
use crate::parser::klartext::ast::{Addr, Stmt, Word};
use crate::parser::symbols::Symbols;
use crate::sema::common::hidden::By;
use crate::sema::run::unexecuted::Blocks;
use crate::text::{FileId, Loc, Span};

use super::super::Job;
use super::active_tool::Change;
use super::m_table::M6;
use super::state::State;
use super::{Core, Klartext, Outcome, Run};

impl State {
    /// The new length of the tool counts from here on, or the change moved the axis.
    fn forget_tip(&mut self, loc: Loc) {
        let axes = AxisSet::of(self.axis());
        self.position.forget_tip(axes, By::ToolChange, loc);
        self.polar.forget_last_of(axes);
    }
}

impl Run<'_> {
    /// TOOL CALL of another tool: changes it, or makes it ready for the M6.
    pub(super) fn call_for_change(&mut self, number: u32) {
        let height = self.st.position.get(self.st.axis());
        let announced = self.st.tool.change == Change::Announced;
        let waits = match self.core.job.settings.control.sinumerik.tool_change_by_t {
            Some(at_call) => !at_call,
            None => !announced && self.core.writes_m6(),
        };
        self.st.tool.warn_of_replaced(&self.core, number);
        let from = self.core.here.origin.loc;
        // The length of the tool that is called counts from here on.
        self.st.forget_tip(from);
        if waits {
            self.st.tool.change = Change::Called { number, from, height, at_end: false, moved: false };
            self.function(Function::ToolPrepare { number });
            return;
        }
        self.print_change(number);
        self.st.tool.change = if announced { Change::None } else { Change::Printed { moved: false } };
    }

    fn print_change(&mut self, number: u32) {
        // The change stops the spindle.
        self.st.spindle.stop();
        self.st.forget_tip(self.core.here.origin.loc);
        self.st.tool.in_spindle = Some(number);
        self.function(Function::ToolChange { number });
        self.stand_after_change();
    }

    /// M6, or whatever else the program changes the tool `by`: changes to the tool that was called, or announces the next TOOL CALL.
    pub(super) fn change_at(&mut self, span: Span, by: &str) -> Outcome {
        let fault = match std::mem::take(&mut self.st.tool.change) {
            Change::Called { number, .. } => {
                self.print_change(number);
                return Ok(());
            }
            Change::Printed { moved: true } if self.core.job.settings.control.sinumerik.tool_change_by_t.is_none() => {
                return self
                    .core
                    .refuse(span, codes::K2802::stands_after_moves(&by).answer(Answer::key("control", "tool_change")));
            }
            Change::Missed => None,
            Change::InSpindle => Some(codes::K2702::stops_spindle_tool_is_in_it(&by)),
            Change::Printed { .. } => Some(codes::K2702::belongs_to_change_of_tool_call(&by)),
            Change::None | Change::Announced => {
                self.st.tool.change = Change::Announced;
                Some(codes::K2702::stops_spindle_and_changes_no_tool(&by))
            }
        };
        if self.st.spindle.turns() {
            let stopped = self.st.spindle.stop();
            self.function(stopped);
        }
        if let Some(fault) = fault {
            self.core.say(span, fault);
        }
        Ok(())
    }
}

impl Core<'_> {
    /// Does a program that runs write M6 anywhere? Each file is looked through once, at its first TOOL CALL.
    fn writes_m6(&mut self) -> bool {
        let mut found = false;
        for at in 0..self.programs.len() {
            if self.programs[at].known.writes_m6.is_none() {
                let file = self.programs[at].source.file;
                self.programs[at].known.writes_m6 = Some(writes_m6(&self.job, file, self.here.origin.loc));
            }
            found |= self.programs[at].known.writes_m6 == Some(true);
        }
        found
    }
}

/// Looks for a block with M6 that the control executes.
fn writes_m6(job: &Job<'_>, file: FileId, from: Loc) -> bool {
    let Some(mut blocks) = Blocks::<Klartext>::open(job, file, from) else { return false };
    let mut symbols = Symbols::default();
    let changing = &job.settings.control.tool_change_m;
    let wanted = |text: &[u8]| may_hold_m6(text) || !changing.is_empty() || may_end(text);
    // END PGM holds an M, too.
    while let Some(passed) = blocks.next_that(job, &mut symbols, Some(b'M'), wanted) {
        if matches!(passed.block.stmt, Stmt::End { .. }) {
            return false;
        }
        let skipped = job.skips(passed.block.skip.then_some(0));
        let changes = |word: &Word| matches!(word.addr, Addr::M(number) if number == M6 || changing.contains(&number));
        if !skipped && passed.block.words.iter().any(changes) {
            return true;
        }
    }
    false
}

/// `M6`, `M06`, `M 6` somewhere in the text, which may still be a comment.
fn may_hold_m6(text: &[u8]) -> bool {
    memchr::memchr2_iter(b'M', b'm', text).any(|at| {
        let number = text[at + 1..].iter().skip_while(|b| matches!(b, b' ' | b'\t' | b'0'));
        let mut digits = number.take(2);
        digits.next() == Some(&b'6') && !digits.next().is_some_and(u8::is_ascii_digit)
    })
}

/// Could the block be END PGM? Looks at its first letter only.
fn may_end(text: &[u8]) -> bool {
    let first = text.iter().find(|b| !matches!(b, b' ' | b'\t' | b'/' | b'0'..=b'9'));
    matches!(first, Some(b'E' | b'e'))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn m6_is_found_in_all_its_forms() {
        for text in ["L Z+100 FMAX M6", "m06", "M 6", "M3 M006 M8", "STOP M6"] {
            assert!(may_hold_m6(text.as_bytes()), "{text}");
        }
        for text in ["L X+6 M60", "M16", "M", "MM", "M0", "L Z+6"] {
            assert!(!may_hold_m6(text.as_bytes()), "{text}");
        }
    }
}
