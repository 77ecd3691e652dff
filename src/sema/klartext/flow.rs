//! Program flow: labels, subprograms, section repeats, jumps, and what a program begins and ends with.

use crate::diag::{self, Answer, CallPath, Diagnostic, codes};
use crate::machine::{Generation, RepeatCount, Unit};
use crate::parser::klartext::ast::{Block, LabelRef};
use crate::sema::Job;
use crate::sema::run::{Level, Program, Where};
use crate::text::Place;
use crate::text::blocks::Cursor;
use crate::text::{FileId, Loc, Next, Span, decode::readable};

use super::labels::{Label, Labels};
use super::level::{Frame, FrameKind};
use super::vars::Locals;
use super::{Core, Outcome, ProgramHead, Reported};

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
    pub(super) fn check_end(&mut self, name: &[u8], unit: Option<Unit>) {
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
    pub(super) fn leave_open_subprograms(&mut self, regular: bool) -> Outcome {
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

    pub(super) fn warn_without_head(&mut self) {
        if self.programs[self.levels[0].program].known.head.is_none() && self.job.settings.control.unit.is_none() {
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
    pub(super) fn repeat_section(&mut self, label: &Label, count: f64) -> Outcome {
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

    pub(super) fn call_part(&mut self, kind: FrameKind, program: usize, to: Place) -> Outcome {
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
