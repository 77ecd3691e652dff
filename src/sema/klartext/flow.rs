//! Program flow: labels, subprograms, section repeats, jumps, called programs, the program frame.

use crate::diag::{Answer, CallPath, Diagnostic, codes};
use crate::ir::Function;
use crate::lexer::klartext::{QKind, QRef};
use crate::machine::{Generation, RepeatCount, StandIn, Unit};
use crate::parser::klartext::ast::{Block, LabelRef, Repeat};
use crate::sema::Job;
use crate::sema::run::{Level, Program, Wanted};
use crate::text::blocks::{Cursor, Place};
use crate::text::{FileId, Loc, Next, Span, Within, decode::readable};

use super::labels::{Label, Labels};
use super::left_out::or_left_out;
use super::vars::{Locals, Val};
use super::{Outcome, ProgramHead, Reported, Run};

/// Most repeats of a section.
const MOST_REPEATS: f64 = 65534.0;

/// What a level of the call stack holds.
#[derive(Debug)]
pub(super) struct Frame {
    pub kind: FrameKind,
    pub unit: Unit,
    /// QL parameters, on levels that are programs.
    pub locals: Option<Locals>,
    /// Section repeats under way: offset of the call block and repeats left.
    repeats: Vec<(u32, u32)>,
    /// The label passed last.
    passed: Option<Loc>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum FrameKind {
    Main,
    /// CALL PGM.
    Program,
    /// CALL LBL; offset of the label.
    Subprogram {
        label_at: u32,
    },
}

impl Frame {
    pub fn main(unit: Unit, locals: Locals) -> Frame {
        Frame { kind: FrameKind::Main, unit, locals: Some(locals), repeats: Vec::new(), passed: None }
    }
}

/// The QL parameters of the innermost program.
pub(super) fn innermost_locals(levels: &mut [Level<Frame>]) -> Option<&mut Locals> {
    levels.iter_mut().rev().find_map(|level| level.frame.locals.as_mut())
}

impl Run<'_> {
    pub(super) fn begin(&mut self, name: &[u8], unit: Option<Unit>, block: &Block) -> Outcome {
        let loc = self.loc(block.span);
        if let Some(first) = &self.program().known.head
            && first.loc != loc
        {
            let first = first.loc;
            self.report(
                Diagnostic::new(codes::K1013, loc, "a second program begins in this file")
                    .also(first, "the first one begins here")
                    .help("put each program into a file of its own"),
            );
            return Err(Reported);
        }
        self.program().known.head = Some(ProgramHead { name: name.to_vec(), unit, loc });
        let Some(unit) = unit else {
            self.error(codes::K1007, "BEGIN PGM states neither MM nor INCH");
            return Err(Reported);
        };
        let call_site = self.level().site;
        if self.level().frame.kind == FrameKind::Program
            && self.levels[..self.levels.len() - 1].iter().any(|level| level.frame.unit != unit)
        {
            self.report(
                Diagnostic::new(codes::K2209, loc, "the called program has another unit than its caller")
                    .also(call_site, "called here"),
            );
        }
        self.level().frame.unit = unit;
        Ok(())
    }

    pub(super) fn end(&mut self, name: &[u8], unit: Option<Unit>) -> Outcome {
        let here = self.here.origin.loc;
        if let Some(head) = self.program().known.head.clone() {
            if head.unit.is_some() && unit.is_some() && head.unit != unit {
                self.report(other_unit(here, head.loc));
            }
            if !head.name.eq_ignore_ascii_case(name) {
                let (begin, end) = (readable(&head.name).into_owned(), readable(name).into_owned());
                self.report(
                    Diagnostic::new(codes::K1010, here, format!("END PGM names `{end}`, BEGIN PGM `{begin}`"))
                        .also(head.loc, "the program begins here"),
                );
            }
        }
        self.look_behind_end();
        self.program_over(true)
    }

    /// The file has no further block.
    pub(super) fn file_over(&mut self) {
        let loc = self.end_of_text();
        self.here.origin.loc = loc;
        if self.cycles.is_open() {
            self.finish_cycle();
        }
        if let Some(head) = &self.program().known.head {
            let begin = head.loc;
            self.report(
                Diagnostic::new(codes::K1011, loc, "the file ends without END PGM")
                    .also(begin, "the program begins here")
                    .help("the file may have been cut off in transfer; if it is complete, add END PGM"),
            );
        } else if self.in_called_program() {
            self.is_cut_off("END PGM", "END PGM");
        } else {
            // Without BEGIN PGM it is a piece of a program.
            self.piece_may_end_open("END PGM, M30 or M2", "M30", None);
        }
        let _ = self.program_over(false);
    }

    /// Warns about blocks behind END PGM.
    fn look_behind_end(&mut self) {
        let (job, call) = (self.job, self.here.origin.call);
        let program = self.program();
        let file = program.source.file;
        let place = program.source.cursor.place();
        report_behind_end(&job, &mut program.source.cursor, file, call);
        if program.source.cursor.is_whole() {
            program.source.cursor.resume(place);
        }
    }

    /// The end of a program file was reached: return to the caller, or end the run.
    fn program_over(&mut self, regular: bool) -> Outcome {
        while let FrameKind::Subprogram { label_at } = self.level().frame.kind {
            let call_site = self.level().site;
            let file = self.program().source.file;
            let label = Loc { file, line: self.line_of(label_at), span: Span::at(label_at, 1) };
            if regular && self.job.settings.control.klartext_choices.open_subprogram_ends {
                let text = "the program ends inside this label, whose call ends it: nothing behind the call runs";
                self.report(
                    Diagnostic::new(codes::K2850, call_site, text)
                        .here("called here")
                        .also(label, "it begins here")
                        .help("write M30, or LBL 0 behind the last block of the subprogram"),
                );
                // The caller of this label goes on nowhere.
                self.levels.pop();
                continue;
            }
            return self.stop(
                Diagnostic::new(codes::K2203, call_site, "the program ends before the LBL 0 of this subprogram")
                    .here("called here")
                    .also(label, "it begins here")
                    .help(Answer::key("control", "open_subprogram").one_of(&["\"end\""]).help(
                        "put LBL 0 behind the last block of the subprogram; if the control takes END PGM for the end \
                         of the program here, set `[control] open_subprogram = \"end\"`",
                    )),
            );
        }
        if self.level().frame.kind == FrameKind::Program {
            return self.leave().map(drop);
        }
        self.warn_without_head();
        self.refuse_compensated("the program ends");
        self.function(Function::End { rewind: false });
        self.stop_run();
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
            self.job.diags.push(
                Diagnostic::new(codes::K1008, loc, "no BEGIN PGM block: lengths are taken as millimetres")
                    .help(Answer::key("control", "unit").help("set `[control] unit` in partc.toml, or add the block")),
            );
        }
    }

    /// M2, M30.
    pub(super) fn program_end(&mut self, rewind: bool) -> Outcome {
        if self.in_called_program() {
            return self.fatal(codes::K2208, "a called program ends the job with M2 or M30");
        }
        self.warn_without_head();
        self.refuse_compensated("the program ends");
        self.end_is_whole();
        self.function(Function::End { rewind });
        self.stop_run();
        Ok(())
    }

    // Labels.

    fn resolve_label(&mut self, label: LabelRef, text: &[u8]) -> Outcome<Label> {
        Ok(match label {
            LabelRef::Number(n) => Label::Number(n),
            LabelRef::Name(span) => Label::Name(readable(span.of(text)).into()),
            LabelRef::Param(q) => {
                let span = self.block_span();
                match self.read(q, span)? {
                    Val::Text(name) => Label::Name(String::from_utf8_lossy(&name).into()),
                    Val::Real(n) if n.fract() == 0.0 && (0.0..=65535.0).contains(&n) => Label::Number(n as u32),
                    other => {
                        let n = other.number().unwrap_or_default();
                        return self.fail(codes::K2202, span, format!("{q} = {n} is no label number"));
                    }
                }
            }
        })
    }

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
    pub(super) fn label(&mut self, label: LabelRef, text: &[u8]) -> Outcome {
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
            Some(label) => Diagnostic::new(codes::K2210, label, "the program runs into this subprogram without a call")
                .also(here, "it ends here"),
            None => Diagnostic::new(codes::K2210, here, "this LBL 0 ends no subprogram"),
        };
        self.report(found.help("put M30 or M2 in front of the subprograms, or skip this one with a jump"));
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

    pub(super) fn call_label(&mut self, label: LabelRef, repeat: Option<Repeat>, text: &[u8]) -> Outcome {
        let label = self.resolve_label(label, text)?;
        if label == Label::Number(0) {
            self.error(codes::K2202, "LBL 0 ends a subprogram and cannot be called");
            return Err(Reported);
        }
        let count = match repeat {
            None | Some(Repeat::Empty) => None,
            Some(Repeat::Count(n)) => Some(n),
            Some(Repeat::Param(q)) => {
                let span = self.block_span();
                Some(self.parameter(q, span)?)
            }
        };
        match count {
            None => self.call_subprogram(&label),
            Some(count) => self.repeat_section(&label, count),
        }
    }

    pub(super) fn call_subprogram(&mut self, label: &Label) -> Outcome {
        let place = self.find_label(label)?;
        let kind = FrameKind::Subprogram { label_at: place.at };
        let program = self.level().program;
        let running =
            self.levels.iter().rev().take_while(|level| level.program == program).any(|level| level.frame.kind == kind);
        if running {
            return self.fatal(codes::K2204, format!("{label} calls itself"));
        }
        self.call_part(kind, program, place)
    }

    /// `CALL LBL n REP count`: back to the label, `count` more times.
    fn repeat_section(&mut self, label: &Label, count: f64) -> Outcome {
        let place = self.find_label(label)?;
        let call_at = self.here.at;
        if place.at > call_at {
            return self.stop(
                Diagnostic::new(codes::K2206, self.here.origin.loc, format!("{label} lies behind this block"))
                    .help("a repeated section lies in front of its call; leave out REP to call a subprogram"),
            );
        }
        let count = match self.job.settings.control.repeat_count {
            RepeatCount::Refuse => count,
            RepeatCount::Truncate => count.trunc(),
            RepeatCount::Round => count.round(),
        };
        if count.fract() != 0.0 || count > MOST_REPEATS {
            return self.stop(
                Diagnostic::new(codes::K2205, self.here.origin.loc, format!("REP {count} is no number of repeats"))
                    .help(Answer::key("control", "repeat_count").help(
                        "REP takes a whole number from 0 to 65534; round the parameter with INT, or set \
                         `[control] repeat_count`",
                    )),
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
    pub(super) fn jump(&mut self, label: LabelRef, text: &[u8]) -> Outcome {
        let label = self.resolve_label(label, text)?;
        let place = match self.find_label(&label) {
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
                self.report(
                    Diagnostic::new(
                        codes::K2207,
                        self.here.origin.loc,
                        format!("the jump to {label} leaves the subprogram"),
                    )
                    .help("leave a subprogram by its LBL 0"),
                );
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
            return self
                .too_deep(format!("{what} are nested deeper than {most} levels, which the control does not allow"));
        }
        if self.levels.len() > limit {
            return self.too_deep(format!("calls are nested deeper than {limit} levels"));
        }
        Ok(())
    }

    // Programs.

    pub(super) fn call_program(&mut self, name: &[u8]) -> Outcome {
        let name = self.program_name(name)?;
        self.call_program_named(&name)
    }

    pub(super) fn select_program(&mut self, name: &[u8]) -> Outcome {
        self.selected = Some(self.program_name(name)?);
        Ok(())
    }

    pub(super) fn call_selected(&mut self) -> Outcome {
        match self.selected.clone() {
            Some(name) => self.call_program_named(&name),
            None => self.fatal(codes::P0101, "no program is selected: SEL PGM comes first"),
        }
    }

    /// The name as written: bare, in quotes, or in a text parameter.
    pub(super) fn program_name(&mut self, name: &[u8]) -> Outcome<String> {
        let name = readable(name.trim_ascii()).into_owned();
        if let Some(digits) = name.strip_prefix("QS").or_else(|| name.strip_prefix("qs"))
            && let Ok(number) = digits.parse()
        {
            let span = self.block_span();
            return match self.read(QRef { kind: QKind::Qs, number }, span)? {
                Val::Text(text) => Ok(String::from_utf8_lossy(&text).into_owned()),
                _ => self.fail(codes::K2307, span, "a text parameter is needed"),
            };
        }
        let name = name.trim_matches('"').trim().to_owned();
        if name.is_empty() {
            self.error(codes::K1006, "the name of the program is missing");
            return Err(Reported);
        }
        Ok(name)
    }

    pub(super) fn call_program_named(&mut self, name: &str) -> Outcome {
        let site = self.here.origin.loc;
        if self.st.compensation.is_on() {
            self.report(
                Diagnostic::new(codes::K2603, site, "a program call ends the radius compensation")
                    .help("program a block with R0 first"),
            );
            self.st.end_compensation();
        }
        let opened = match self.stands_for(name) {
            Some((_, StandIn::File(file))) => {
                self.open_called(&Wanted { name: &file, extensions: &[], within: Within::Configured })
            }
            Some((key, StandIn::Change(change))) => return self.stand_in(name, &key, Some(change)),
            Some((key, StandIn::Ignored)) => return self.stand_in(name, &key, None),
            None if name.to_ascii_uppercase().ends_with(".I") => {
                self.error(codes::K9009, format!("`{name}` is a DIN/ISO program"));
                None
            }
            None => {
                let found = self.find_called(&Wanted { name, extensions: &["H", "h"], within: Within::Caller });
                found.unwrap_or_else(|found| {
                    self.job.diags.push(or_left_out(found, name));
                    None
                })
            }
        };
        let Some(program) = opened else {
            // What the program would have done is unknown: nothing after it can be trusted.
            self.st.lose(crate::machine::AxisSet::MAIN);
            self.lost();
            self.go_on_in_doubt();
            return Err(Reported);
        };
        if self.is_running(program) {
            return self.fatal(codes::K2204, format!("program `{name}` calls itself"));
        }
        let start = self.programs[program].source.cursor.start();
        self.call_part(FrameKind::Program, program, start)
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
    Diagnostic::new(codes::K1009, end, "END PGM states another unit than BEGIN PGM")
        .also(begin, "the program begins here")
        .help("correct the wrong one of the two")
}

/// Warns about the first block behind END PGM, where the cursor stands.
pub(super) fn report_behind_end(job: &Job<'_>, cursor: &mut Cursor, file: FileId, call: CallPath) {
    while let Ok(Next::Block(block)) = cursor.next(job.sources) {
        if block.text.iter().all(|b| b.is_ascii_whitespace() || matches!(b, 0 | 0x1a)) {
            continue;
        }
        let loc = Loc { file, line: block.line, span: Span::at(block.at, block.text.len() as u32) };
        let what = "this stands behind END PGM and is not part of the program";
        job.diags.push(Diagnostic::new(codes::K1012, loc, what).called(call));
        return;
    }
}
