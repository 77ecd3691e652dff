//! Programs that call each other, and the end of the run.

use crate::diag::{self, codes};
use crate::ir::Function;
use crate::machine::{AxisSet, StandIn, Unit};
use crate::parser::klartext::ast::{LabelRef, Repeat};
use crate::sema::run::{Wanted, Where, step};
use crate::text::Within;

use super::labels::Label;
use super::left_out::or_left_out;
use super::level::FrameKind;
use super::{Outcome, Reported, Run};

impl Run<'_> {
    pub(super) fn end(&mut self, name: &[u8], unit: Option<Unit>) -> Outcome {
        self.core.check_end(name, unit);
        self.program_over(true)
    }

    /// The file has no further block.
    pub(super) fn file_over(&mut self) {
        let loc = self.core.end_of_text();
        self.core.here.origin.loc = loc;
        if let Some(head) = &self.core.program().known.head {
            let begin = head.loc;
            self.core.report(codes::P1006::file_ends_without_end_pgm().at(loc).also(begin, diag::Label::ProgramBegins));
        } else if self.core.in_called_program() {
            self.core.is_cut_off("END PGM", "END PGM");
        } else {
            // Without BEGIN PGM it is a piece of a program.
            self.core.piece_may_end_open("END PGM, M30 or M2", "M30", None);
        }
        let _ = self.program_over(false);
    }

    /// The end of a program file was reached: return to the caller, or end the run.
    fn program_over(&mut self, regular: bool) -> Outcome {
        self.core.leave_open_subprograms(regular)?;
        if self.core.level().frame.kind == FrameKind::Program {
            return self.core.leave().map(drop);
        }
        self.core.warn_without_head();
        self.st.refuse_compensated(&mut self.core, "the program ends");
        self.function(Function::End { rewind: false });
        self.core.stop_run();
        Ok(())
    }

    /// M2, M30.
    pub(super) fn program_end(&mut self, rewind: bool) -> Outcome {
        if self.core.in_called_program() {
            return self.core.end_run(codes::P2013::called_program_ends_job_with_m2());
        }
        self.core.warn_without_head();
        self.st.refuse_compensated(&mut self.core, "the program ends");
        self.core.end_is_whole();
        self.function(Function::End { rewind });
        self.core.stop_run();
        Ok(())
    }

    pub(super) fn call_label(&mut self, label: LabelRef, repeat: Option<Repeat>, text: &[u8]) -> Outcome {
        let reading = self.reading();
        let label = reading.label(label, text)?;
        if label == Label::Number(0) {
            return self.core.refuse(Where::Block, codes::P2011::lbl_0_ends_subprogram());
        }
        match repeat {
            None | Some(Repeat::Empty) => self.core.call_subprogram(&label),
            Some(Repeat::Count(count)) => self.core.repeat_section(&label, count),
            Some(Repeat::Param(q)) => {
                let count = reading.parameter(q, self.core.block_span())?;
                self.core.repeat_section(&label, count)
            }
        }
    }

    /// CALL SELECTED PGM
    pub(super) fn call_selected(&mut self) -> Outcome {
        match self.selected.clone() {
            Some(name) => self.call_program(&name),
            None => self.core.end_run(codes::P0101::no_program_is_selected()),
        }
    }

    /// Calls a program by its name.
    pub(super) fn call_program(&mut self, name: &str) -> Outcome {
        if self.st.compensation.is_on() {
            self.core.say_here(codes::P2041::program_call_ends_radius_compensation());
            self.st.end_compensation();
        }
        let opened = match self.core.stands_for(name) {
            Some((_, StandIn::File(file))) => {
                self.core.open_called(&Wanted { name: &file, extensions: &[], within: Within::Configured })
            }
            Some((key, StandIn::Change(change))) => return self.stand_in(name, &key, Some(change)),
            Some((key, StandIn::Ignored)) => return self.stand_in(name, &key, None),
            None if name.to_ascii_uppercase().ends_with(".I") => {
                self.core.say_here(codes::P9012::is_din_iso_program(&name));
                None
            }
            None => {
                let found = self.core.find_called(&Wanted { name, extensions: &["H", "h"], within: Within::Caller });
                found.unwrap_or_else(|found| {
                    self.core.job.diags.push(or_left_out(*found, name));
                    None
                })
            }
        };
        let Some(program) = opened else {
            // What the program would have done is unknown: nothing after it can be trusted.
            self.st.lose(AxisSet::MAIN);
            self.st.lost(&mut self.core);
            self.core.go_on_in_doubt();
            return Err(Reported);
        };
        if self.core.is_running(program) {
            return self.core.end_run(codes::P2012::program_calls_itself(&name));
        }
        let start = self.core.programs[program].source.cursor.start();
        self.core.call_part(FrameKind::Program, program, start)
    }

    /// The whole program, before the block in hand goes on.
    pub(super) fn run_whole(&mut self, name: &str) -> Outcome {
        let (here, below) = (self.core.here, self.core.levels.len());
        self.call_program(name)?;
        while self.core.levels.len() > below && !self.core.has_ended() {
            step(self);
        }
        self.core.here = here;
        if self.core.has_ended() || self.core.levels.len() != below { Err(Reported) } else { Ok(()) }
    }
}
