//! Entering and leaving programs: levels, passes, the end of a program.
//!
//! Source: S 5.6 (docs/sources.md).

use crate::diag::codes;
use crate::ir::Function;
use crate::sema::run::Where;
use crate::text::Place;

use super::levels::{self, Frame, FrameKind};
use super::programs::UnitKind;
use super::vars::Argument;
use super::{Outcome, Run};

impl Run<'_> {
    /// Calls a program, or its blocks from `part.0` to the offset `part.1`.
    pub(super) fn call(
        &mut self,
        unit: usize,
        arguments: Vec<Argument>,
        passes: u32,
        modal: bool,
        part: Option<(Place, u32)>,
    ) -> Outcome {
        self.channel.core.check_depth()?;
        let (file, start) = (self.units.list[unit].file, self.units.list[unit].start);
        let start = part.map_or(start, |(start, _)| start);
        let stop = part.map(|(_, stop)| stop);
        let kind = FrameKind::Program { passes, stop, start, saved: None, references: Vec::new(), modal };
        let arguments = (!arguments.is_empty()).then_some(arguments);
        self.vars.enter();
        let frame = Frame { arguments, ..Frame::new(kind, unit, part.is_some()) };
        self.channel.core.enter(file, start, frame)
    }

    /// The current program is over: M17, RET, its end of file.
    pub(super) fn leave_program(&mut self) {
        if self.channel.capture.as_ref().is_some_and(|capture| capture.ends_program(&self.channel.core)) {
            return;
        }
        let core = &mut self.channel.core;
        while matches!(core.level().frame.kind, FrameKind::Section { .. }) {
            core.levels.pop();
        }
        let FrameKind::Program { passes, start, saved, references, .. } = &mut core.level().frame.kind else {
            core.stop_run();
            return;
        };
        let (start, again) = (*start, *passes > 1);
        let (saved, references) = (saved.take(), references.clone());
        if again {
            *passes -= 1;
        }
        if !references.is_empty() {
            core.job.trail.returns();
            self.vars.give_back(&references);
        }
        if let Some(saved) = saved {
            self.channel.restore(*saved);
        }
        let core = &mut self.channel.core;
        if again {
            // Arguments are handed over once: the parameters keep what the pass before left in them.
            self.vars.next_pass();
            let level = &mut core.level().frame;
            (level.executed, level.declares, level.further_pass) = (false, false, true);
            let _ = core.jump_to(start);
            return;
        }
        self.vars.leave();
        let _ = core.leave();
        if let Some(capture) = &mut self.channel.capture {
            capture.level_ended(self.channel.core.levels.len());
        }
    }

    /// The text of a program is over. Kinds of programs that end without M17 or M30 are worth a word.
    pub(super) fn end_of_program_text(&mut self) {
        let _ = self.channel.pending_must_be_done(Where::Block);
        self.channel.tapping_ends();
        let core = &mut self.channel.core;
        core.refuse_arguments();
        if !levels::in_main(&core.levels) {
            core.is_cut_off("M17 or RET", "M17");
            return self.leave_program();
        }
        let unit = &self.units.list[levels::unit(&core.levels)];
        if !self.channel.iso {
            if unit.kind != UnitKind::Main {
                core.is_cut_off("M17 or RET", "M17");
            } else if core.may_end_open("M30, M2 or M17", "M30", Some(14000)) {
                let loc = core.end_of_text();
                core.report(codes::P1007::program_ends_without_m30().at(loc).help("write M30 as its last block"));
            }
        }
        let behind = core.end_of_text();
        let last = std::mem::replace(&mut core.here.origin.loc, behind);
        self.channel.function(Function::End { rewind: false });
        self.channel.core.here.origin.loc = last;
        self.channel.core.stop_run();
    }
}
