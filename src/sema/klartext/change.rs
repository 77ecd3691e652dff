//! Which block changes the tool: the TOOL CALL, or an M6 of the program's own.
//!
//! Many programs write `TOOL CALL 2 Z S2000`, retract, and then M6: a change at the TOOL CALL would come in the cut.
//! Others never write M6, and there TOOL CALL is the change. Which of the two a program does is looked up once in its
//! text; what the run then meets has to fit to it, or is refused. Source: K 1.5 (docs/sources.md).

use crate::diag::{Answer, Label, codes};
use crate::ir::contour::{Coords, Move, Path};
use crate::ir::{Function, Pos};
use crate::machine::Axis;
use crate::parser::klartext::ast::{Addr, Stmt, Word};
use crate::parser::symbols::Symbols;
use crate::sema::common::plane::plane_axes;
use crate::sema::run::unexecuted::Blocks;
use crate::text::{FileId, Loc, Span};

use super::super::Job;
use super::active_tool::Change;
use super::m_table::M6;
use super::state::State;
use super::{Klartext, Outcome, Reported, Run};

impl State {
    /// TOOL CALL of the tool that was called last: nothing is to change that is not under way already.
    pub(super) fn call_again(&mut self) {
        match self.tool.change {
            Change::Called { .. } | Change::Missed => {}
            Change::Announced => self.tool.change = Change::None,
            Change::None | Change::InSpindle | Change::Printed { .. } => self.tool.change = Change::InSpindle,
        }
    }

    /// The block under way ends with M6.
    pub(super) fn m6_at_end(&mut self) {
        if let Change::Called { at_end, .. } = &mut self.tool.change {
            *at_end = true;
        }
    }

    /// Does the move cut? Not at rapid traverse, and not upwards along the tool axis alone, however fast.
    fn cuts(&self, mv: &Move) -> bool {
        let (axis, plane) = (self.axis(), plane_axes(self.plane()));
        if mv.path.is_rapid() || mv.coords == Coords::Machine {
            return false;
        }
        if !matches!(mv.path, Path::Line(_)) || plane.iter().any(|axis| goes(self.position.at(), &mv.end, axis)) {
            return true;
        }
        let height = match self.tool.change {
            Change::Called { height, .. } => height,
            _ => None,
        };
        match (mv.end.get(axis), self.position.get(axis), height) {
            (Some(to), Some(from), _) => to < from,
            (Some(to), None, Some(height)) => to <= height,
            _ => false,
        }
    }
}

impl Run<'_> {
    /// TOOL CALL of another tool: changes it, or makes it ready for the M6.
    pub(super) fn call_for_change(&mut self, number: u32) {
        let height = self.st.position.get(self.st.axis());
        let announced = self.st.tool.change == Change::Announced;
        let waits = match self.core.job.settings.control.sinumerik.tool_change_by_t {
            Some(at_call) => !at_call,
            None => !announced && self.writes_m6(),
        };
        self.replaced_change(number);
        // The length of the tool that is called counts from here on.
        self.forget_tip();
        if waits {
            let from = self.core.here.origin.loc;
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
        self.forget_tip();
        self.st.tool.in_spindle = Some(number);
        self.function(Function::ToolChange { number });
        self.stand_after_change();
    }

    /// M6: changes to the tool that was called, or announces the next TOOL CALL.
    pub(super) fn m6(&mut self, span: Span) -> Outcome {
        self.change_at(span, "this M6")
    }

    /// The same of whatever the program changes the tool by.
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
            Change::Missed => {
                if self.st.spindle.turns() {
                    self.stop_spindle();
                }
                return Ok(());
            }
            Change::InSpindle => codes::K2702::stops_spindle_tool_is_in_it(&by),
            Change::Printed { .. } => codes::K2702::belongs_to_change_of_tool_call(&by),
            Change::None | Change::Announced => {
                self.st.tool.change = Change::Announced;
                codes::K2702::stops_spindle_and_changes_no_tool(&by)
            }
        };
        if self.st.spindle.turns() {
            self.stop_spindle();
        }
        self.core.say(span, fault);
        Ok(())
    }

    /// A move while a change is under way, before its end is taken over.
    #[cold]
    pub(super) fn watch_move(&mut self, mv: &Move) {
        let axis = self.st.axis();
        let cuts = self.st.cuts(mv);
        match &mut self.st.tool.change {
            Change::None | Change::InSpindle | Change::Missed => {}
            Change::Printed { moved } => *moved = true,
            Change::Announced => {
                // Back towards the workpiece, the M6 was not meant for a change at the next TOOL CALL.
                if mv.end.get(axis).is_some() {
                    self.st.tool.change = Change::None;
                }
            }
            Change::Called { at_end: true, .. } => return,
            Change::Called { moved, .. } => *moved = true,
        }
        if cuts {
            let _ = self.cuts_now();
        }
    }

    /// Something cuts: the tool that was called has to be in the spindle.
    pub(super) fn cuts_now(&mut self) -> Outcome {
        let Change::Called { number, from, .. } = self.st.tool.change else {
            if self.st.tool.change != Change::Missed {
                self.st.tool.change = Change::None;
            }
            return Ok(());
        };
        if self.st.tool.in_spindle == Some(number) {
            self.st.tool.change = Change::None;
            return Ok(());
        }
        self.st.tool.change = Change::Missed;
        self.core.report(
            codes::K2801::tool_is_called(&number)
                .answer(Answer::key("control", "tool_change").one_of(&["\"t\""]))
                .at(self.core.here.origin.loc)
                .also(from, Label::CalledHere),
        );
        Err(Reported)
    }

    /// TOOL CALL of another tool while one waits for its M6: after a move it was not only the tool to make ready.
    fn replaced_change(&self, next: u32) {
        if let Change::Called { number, from, moved: true, .. } = self.st.tool.change
            && self.st.tool.in_spindle != Some(number)
        {
            self.core.report(
                codes::K2803::no_m6_follows_this_tool_call_before(&next, &number)
                    .at(from)
                    .also(self.core.here.origin.loc, Label::NextToolCall),
            );
        }
    }

    /// The run is over: a tool that was called for its M6 stays ready.
    pub(super) fn forgotten_change(&self) {
        if let Change::Called { number, from, .. } = self.st.tool.change
            && self.st.tool.in_spindle != Some(number)
        {
            self.core.report(codes::K2803::no_m6_follows_this_tool_call(&number).at(from));
        }
    }

    /// Does a program that runs write M6 anywhere? Each file is looked through once, at its first TOOL CALL.
    fn writes_m6(&mut self) -> bool {
        let mut found = false;
        for at in 0..self.core.programs.len() {
            if self.core.programs[at].known.writes_m6.is_none() {
                let file = self.core.programs[at].source.file;
                self.core.programs[at].known.writes_m6 =
                    Some(writes_m6(&self.core.job, file, self.core.here.origin.loc));
            }
            found |= self.core.programs[at].known.writes_m6 == Some(true);
        }
        found
    }
}

/// Does the move give the axis another coordinate? Yes where the old one is not known.
fn goes(from: &Pos, end: &Pos, axis: Axis) -> bool {
    end.get(axis).is_some_and(|to| from.get(axis) != Some(to))
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
