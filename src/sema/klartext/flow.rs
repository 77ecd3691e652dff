//! Program flow: labels, subprograms, section repeats, jumps, called programs, the program frame.

use crate::diag::{self, Answer, CallPath, Diagnostic, codes};
use crate::ir::Function;
use crate::machine::{AxisSet, Generation, RepeatCount, StandIn, Unit};
use crate::parser::klartext::ast::{Block, LabelRef, Repeat};
use crate::sema::Job;
use crate::sema::run::{Level, Program, Wanted, Where};
use crate::text::Place;
use crate::text::blocks::Cursor;
use crate::text::{FileId, Loc, Next, Span, Within, decode::readable};

use super::labels::{Label, Labels};
use super::left_out::or_left_out;
use super::level::{Frame, FrameKind};
use super::vars::Locals;
use super::{Core, Outcome, ProgramHead, Reported, Run};

/// Most repeats of a section.
const MOST_REPEATS: f64 = 65534.0;

impl Core<'_> {
    // Programs.

    /// BEGIN PGM
    pub(super) fn begins(&mut self, name: &[u8], unit: Option<Unit>, block: &Block) -> Outcome {
        let loc = self.loc(block.span);
        if let Some(first) = &self.program().known.head
            && first.loc != loc
        {
            let first = first.loc;
            let found = codes::P1009::second_program_begins_in_this_file().at(loc);
            self.report(found.also(first, diag::Label::FirstOneBegins));
            return Err(Reported);
        }
        self.program().known.head = Some(ProgramHead { name: name.to_vec(), unit, loc });
        let Some(unit) = unit else {
            return self.refuse(Where::Block, codes::K1007::begin_pgm_states_neither_mm_nor_inch());
        };
        let call_site = self.level().site;
        if self.level().frame.kind == FrameKind::Program
            && self.levels[..self.levels.len() - 1].iter().any(|level| level.frame.unit != unit)
        {
            let found = codes::K2209::called_program_has_another_unit().at(loc);
            self.report(found.also(call_site, diag::Label::CalledHere));
        }
        self.level().frame.unit = unit;
        Ok(())
    }

    /// END PGM is met: does it fit to BEGIN PGM, and does something follow?
    fn check_end(&mut self, name: &[u8], unit: Option<Unit>) {
        let here = self.here.origin.loc;
        if let Some(head) = self.program().known.head.clone() {
            if head.unit.is_some() && unit.is_some() && head.unit != unit {
                self.report(other_unit(here, head.loc));
            }
            if !head.name.eq_ignore_ascii_case(name) {
                let (begin, end) = (readable(&head.name).into_owned(), readable(name).into_owned());
                let found = codes::K1010::end_pgm_names(&end, &begin).at(here);
                self.report(found.also(head.loc, diag::Label::ProgramBegins));
            }
        }
        let (job, call) = (self.job, self.here.origin.call);
        let program = self.program();
        let file = program.source.file;
        let place = program.source.cursor.place();
        report_behind_end(&job, &mut program.source.cursor, file, call);
        if program.source.cursor.is_whole() {
            program.source.cursor.resume(place);
        }
    }

    /// The program is over: levels of labels that it ends inside of are left, or refused.
    fn leave_open_subprograms(&mut self, regular: bool) -> Outcome {
        while let FrameKind::Subprogram { label_at } = self.level().frame.kind {
            let call_site = self.level().site;
            let file = self.program().source.file;
            let label = Loc { file, line: self.line_of(label_at), span: Span::at(label_at, 1) };
            if regular && self.job.settings.control.klartext_choices.open_subprogram_ends {
                self.report(
                    codes::K2850::program_ends_inside_this_label()
                        .at(call_site)
                        .here("called here")
                        .also(label, diag::Label::BeginsHere),
                );
                // The caller of this label goes on nowhere.
                self.levels.pop();
                continue;
            }
            return self.stop(
                codes::K2203::program_ends_before_lbl_0()
                    .answer(Answer::key("control", "open_subprogram").one_of(&["\"end\""]))
                    .at(call_site)
                    .here("called here")
                    .also(label, diag::Label::BeginsHere),
            );
        }
        Ok(())
    }

    fn line_of(&mut self, at: u32) -> u32 {
        let file = self.program().source.file;
        let text = self.job.sources.bytes(file, Span { start: 0, end: at });
        text.iter().filter(|b| **b == b'\n').count() as u32 + 1
    }

    fn warn_without_head(&mut self) {
        if self.programs[self.levels[0].program].known.head.is_none()
            && self.job.settings.control.unit.is_none()
        {
            let loc = Loc { file: self.job.main, line: 1, span: Span::at(0, 1) };
            self.job.diags.push(codes::K1008::no_begin_pgm_block().answer(Answer::key("control", "unit")).at(loc));
        }
    }

    // Labels.

    fn find_label(&mut self, label: &Label) -> Outcome<Place> {
        let (job, here) = (self.job, self.here.origin.loc);
        let Program { source, known } = self.program();
        let file = source.file;
        let labels = known
            .labels
            .get_or_insert_with(|| Labels::scan(&job, file, here, &mut |found| push_unless_known(&job, found)));
        if let Some(place) = labels.place(label) {
            return Ok(place);
        }
        let found = labels.missing(label, here);
        self.report(found);
        Err(Reported)
    }

    /// `LBL n` in passing.
    pub(super) fn passes_label(&mut self, label: LabelRef, text: &[u8]) -> Outcome {
        let here = self.here.origin.loc;
        self.note_label(label, text);
        if label != LabelRef::Number(0) {
            self.level().frame.passed = Some(here);
            return Ok(());
        }
        if let FrameKind::Subprogram { .. } = self.level().frame.kind {
            return self.leave().map(drop);
        }
        let found = match self.level().frame.passed.take() {
            Some(label) => codes::K2210::program_runs_into_this_subprogram_without_call()
                .at(label)
                .also(here, diag::Label::EndsHere),
            None => codes::K2210::this_lbl_0_ends_no_subprogram().at(here),
        };
        self.report(found.help("put M30 or M2 before the subprograms, or skip this one with a jump"));
        Ok(())
    }

    /// In a program without jumps nothing looks for labels: whether one is set twice shows in passing.
    fn note_label(&mut self, label: LabelRef, text: &[u8]) {
        let loc = self.here.origin.loc;
        let place = Place { at: self.here.at, line: self.here.line };
        let program = &mut self.program().known;
        if program.labels.is_some() || label == LabelRef::Number(0) {
            return;
        }
        if let Some(found) = program.passed.add(label, text, place, loc) {
            self.report(found);
        }
    }

    pub(super) fn call_subprogram(&mut self, label: &Label) -> Outcome {
        let place = self.find_label(label)?;
        let kind = FrameKind::Subprogram { label_at: place.at };
        let program = self.level().program;
        let mut of_program = self.levels.iter().rev().take_while(|level| level.program == program);
        if of_program.any(|level| level.frame.kind == kind) {
            return self.end_run(codes::P2012::calls_itself(&label));
        }
        self.call_part(kind, program, place)
    }

    /// `CALL LBL n REP count`: back to the label, `count` more times.
    fn repeat_section(&mut self, label: &Label, count: f64) -> Outcome {
        let place = self.find_label(label)?;
        let call_at = self.here.at;
        if place.at > call_at {
            return self.stop(codes::K2206::lies_behind_this_block(&label).at(self.here.origin.loc));
        }
        let count = match self.job.settings.control.repeat_count {
            RepeatCount::Refuse => count,
            RepeatCount::Truncate => count.trunc(),
            RepeatCount::Round => count.round(),
        };
        if count.fract() != 0.0 || count > MOST_REPEATS {
            return self.stop(
                codes::K2205::rep_is_no_number_of_repeats(&count)
                    .answer(Answer::key("control", "repeat_count"))
                    .at(self.here.origin.loc),
            );
        }
        let repeats = &mut self.level().frame.repeats;
        let left = match repeats.iter().position(|(at, _)| *at == call_at) {
            Some(i) => &mut repeats[i].1,
            None => {
                // REP counts additional passes.
                repeats.push((call_at, count.max(0.0) as u32));
                &mut repeats.last_mut().expect("just pushed").1
            }
        };
        if *left == 0 {
            self.level().frame.repeats.retain(|(at, _)| *at != call_at);
            return Ok(());
        }
        *left -= 1;
        self.jump_to(place)
    }

    /// Conditional jump whose condition holds.
    pub(super) fn jump(&mut self, label: &Label) -> Outcome {
        let place = match self.find_label(label) {
            Ok(place) => place,
            Err(reported) => {
                // Going on past a jump that should be taken would run blocks that never run.
                self.stop_run();
                return Err(reported);
            }
        };
        if let FrameKind::Subprogram { label_at } = self.level().frame.kind {
            let end = self.program().known.labels.as_ref().and_then(|labels| labels.zero_after(label_at));
            if place.at < label_at || end.is_some_and(|end| place.at > end) {
                self.say_here(codes::K2207::jump_to_leaves_subprogram(&label));
            }
        }
        self.jump_to(place)
    }

    // Levels.

    fn call_part(&mut self, kind: FrameKind, program: usize, to: Place) -> Outcome {
        self.check_depth(kind)?;
        let unit = self.level().frame.unit;
        let locals = (kind == FrameKind::Program).then(Locals::default);
        self.enter(program, to, Frame { kind, unit, locals, repeats: Vec::new(), passed: None })
    }

    /// Nesting the control allows, and the configured limit.
    fn check_depth(&mut self, kind: FrameKind) -> Outcome {
        let old = self.job.settings.control.klartext == Generation::Tnc426;
        let called = kind == FrameKind::Program;
        let same = |level: &&Level<Frame>| (level.frame.kind == FrameKind::Program) == called;
        let depth = self.levels[1..].iter().filter(same).count() + 1;
        let (what, most) = match called {
            true => ("programs", if old { 6 } else { 19 }),
            false => ("subprograms", if old { 8 } else { 19 }),
        };
        let limit = self.job.settings.limits.call_depth;
        if depth > most {
            return self.too_deep(codes::P4003::control_allows_no_deeper_nesting(&what, &most));
        }
        if self.levels.len() > limit {
            return self.too_deep(codes::P4003::calls_are_nested_deeper(&limit));
        }
        Ok(())
    }
}

impl Run<'_> {
    pub(super) fn end(&mut self, name: &[u8], unit: Option<Unit>) -> Outcome {
        self.core.check_end(name, unit);
        self.program_over(true)
    }

    /// The file has no further block.
    pub(super) fn file_over(&mut self) {
        let loc = self.core.end_of_text();
        self.core.here.origin.loc = loc;
        self.finish_cycle();
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
}

/// A label set twice may have been found in passing before.
fn push_unless_known(job: &crate::sema::Job<'_>, found: Diagnostic) {
    if !job.diags.knows(&found) {
        job.diags.push(found);
    }
}

/// The finding for a program whose head and end state different units.
pub(super) fn other_unit(end: Loc, begin: Loc) -> Diagnostic {
    codes::K1009::end_pgm_states_another_unit_than_begin().at(end).also(begin, diag::Label::ProgramBegins)
}

/// Warns about the first block behind END PGM, where the cursor stands.
pub(super) fn report_behind_end(job: &Job<'_>, cursor: &mut Cursor, file: FileId, call: CallPath) {
    while let Ok(Next::Block(block)) = cursor.next(job.sources) {
        if block.text.iter().all(|b| b.is_ascii_whitespace() || matches!(b, 0 | 0x1a)) {
            continue;
        }
        let loc = Loc { file, line: block.line, span: Span::at(block.at, block.text.len() as u32) };
        job.diags.push(codes::P1008::this_stands_behind_end_pgm().at(loc).called(call));
        return;
    }
}
