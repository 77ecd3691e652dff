//! Calls of programs: levels, parameters, passes, return.
//!
//! Source: S 5.6 (docs/sources.md).

use crate::diag::codes;
use crate::parser::sinumerik::ast::{Args, Block, CallForm, Formula, Op};
use crate::parser::symbols::Symbol;
use crate::sema::run::{Level, Where};
use crate::text::{Loc, Place, Span};

use super::modal_call::ModalCall;
use super::programs::UnitKind;
use super::state::Saved;
use super::value::Val;
use super::vars::{Argument, Reference};
use super::vocabulary::{Meaning, Procedure, Refusal};
use super::{Channel, Core, Outcome, Run};

/// What a level of the call stack holds.
#[derive(Debug)]
pub(super) struct Frame {
    pub kind: FrameKind,
    /// The program that runs on this level.
    pub unit: usize,
    /// The FOR that ENDFOR came from.
    pub counting: Option<u32>,
    /// Arguments that wait for PROC.
    pub arguments: Option<Vec<Argument>>,
    /// Which parameters the call gave.
    pub given: Vec<bool>,
    /// Something was executed, so DEF is too late.
    pub executed: bool,
    /// The definition part has begun, so PROC is too late.
    pub declares: bool,
    /// A further pass of a call: the parameters keep their values.
    pub further_pass: bool,
}

#[derive(Debug)]
pub(super) enum FrameKind {
    Main,
    Program {
        passes: u32,
        /// Runs up to this offset only.
        stop: Option<u32>,
        start: Place,
        /// State that SAVE brings back.
        saved: Option<Box<Saved>>,
        /// Values that go back to the caller: parameter and what it stands for.
        references: Vec<(Symbol, Reference)>,
        modal: bool,
    },
    /// REPEAT: a section of the same program.
    Section {
        from: Place,
        stop: u32,
        left: u32,
    },
}

impl Frame {
    pub fn main(unit: usize) -> Frame {
        Frame {
            kind: FrameKind::Main,
            unit,
            counting: None,
            arguments: None,
            given: Vec::new(),
            executed: false,
            declares: false,
            further_pass: false,
        }
    }
}

impl Run<'_> {
    /// An executable block: DEF is too late from here on, arguments without PROC are too many.
    pub(super) fn begins_executing(&mut self) {
        let level = self.channel.core.program_level();
        if level.executed {
            return;
        }
        level.executed = true;
        if level.arguments.is_some() {
            self.channel.core.refuse_arguments();
        }
    }

    /// A section or program ran up to its last block. False if nothing ended.
    pub(super) fn ends_here(&mut self, at: u32) -> bool {
        let level = self.channel.core.level();
        let back = level.back;
        match &mut level.frame.kind {
            FrameKind::Section { from, stop, left } if at >= *stop || at < from.at => {
                let from = *from;
                let again = *left > 0;
                if again {
                    *left -= 1;
                } else {
                    self.channel.core.levels.pop();
                    if let Some(capture) = &mut self.channel.capture {
                        capture.level_ended(self.channel.core.levels.len());
                    }
                }
                // A file that was read once can be read again.
                let _ = self.channel.core.resume(if again { from } else { back });
                true
            }
            FrameKind::Program { stop: Some(stop), .. } if at >= *stop => {
                self.leave_program();
                true
            }
            _ => false,
        }
    }

    /// Calls a program.
    pub(super) fn call_unit(&mut self, unit: usize, arguments: Vec<Argument>, passes: u32, modal: bool) -> Outcome {
        self.call_part(unit, arguments, passes, modal, None)
    }

    /// Calls a program, or its blocks from `part.0` to the offset `part.1`.
    pub(super) fn call_part(
        &mut self,
        unit: usize,
        arguments: Vec<Argument>,
        passes: u32,
        modal: bool,
        part: Option<(Place, u32)>,
    ) -> Outcome {
        self.channel.core.check_depth()?;
        let file = self.units.list[unit].file;
        let start = part.map_or(self.units.list[unit].start, |(start, _)| start);
        let kind = FrameKind::Program {
            passes,
            stop: part.map(|(_, stop)| stop),
            start,
            saved: None,
            references: Vec::new(),
            modal,
        };
        let executed = part.is_some();
        let arguments = (!arguments.is_empty()).then_some(arguments);
        let given = Vec::new();
        let frame =
            Frame { kind, unit, counting: None, arguments, given, executed, declares: executed, further_pass: false };
        self.vars.enter();
        self.channel.core.enter(file, start, frame)
    }

    /// Leaves the current program without its further passes. Returns where in the caller it was called.
    pub(super) fn leave_for_good(&mut self) -> u32 {
        let called = self.channel.core.call_site().span.start;
        if let FrameKind::Program { passes, .. } = &mut self.channel.core.program_level().kind {
            *passes = 1;
        }
        self.leave_program();
        called
    }

    /// The current program is over: M17, RET, its end of file.
    pub(super) fn leave_program(&mut self) {
        if self.channel.capture.as_ref().is_some_and(|capture| capture.ends_program(&self.channel.core)) {
            return;
        }
        while matches!(self.channel.core.level().frame.kind, FrameKind::Section { .. }) {
            self.channel.core.levels.pop();
        }
        let FrameKind::Program { passes, start, saved, references, .. } = &mut self.channel.core.level().frame.kind
        else {
            self.channel.core.stop_run();
            return;
        };
        let (start, again) = (*start, *passes > 1);
        let (saved, references) = (saved.take(), references.clone());
        if again {
            *passes -= 1;
        }
        self.give_back(&references);
        if let Some(saved) = saved {
            self.channel.restore(*saved);
        }
        if again {
            // Arguments are handed over once: the parameters keep what the pass before left in them.
            self.vars.next_pass();
            let level = &mut self.channel.core.level().frame;
            level.executed = false;
            level.declares = false;
            level.further_pass = true;
            let _ = self.channel.core.jump_to(start);
            return;
        }
        self.vars.leave();
        let _ = self.channel.core.leave();
        if let Some(capture) = &mut self.channel.capture {
            capture.level_ended(self.channel.core.levels.len());
        }
    }

    // Forms of calls.

    pub(super) fn call_form(&mut self, form: CallForm, block: &Block, text: &[u8]) -> Outcome {
        match form {
            CallForm::Text(formula) | CallForm::External(formula) => {
                let name = self.program_name(formula, block, text)?;
                self.call_by_name(&name, formula.span, Vec::new(), 1)
            }
            CallForm::Section { program, from, to } => {
                let unit = match program {
                    Some(formula) => {
                        let name = self.program_name(formula, block, text)?;
                        self.find_program(&name, formula.span)?
                    }
                    None => self.channel.core.level().frame.unit,
                };
                self.call_section(unit, from, to, block.span)
            }
            CallForm::Path { path, args } => {
                let name = String::from_utf8_lossy(path.of(text)).replace(' ', "");
                let arguments = self.arguments(args, block, text)?;
                self.call_by_name(&name, path, arguments, 1)
            }
            CallForm::Modal { name, args } => self.modal_call(name, args, block, text),
            CallForm::ModalOff => {
                self.channel.st.modal_call = ModalCall::default();
                Ok(())
            }
            CallForm::Iso => self.channel.core.refuse(block.span, codes::P9012::isocall_calls_program_in_iso_dialect()),
        }
    }

    /// `CALL "NAME"`; `CALL NAME` means a text variable, or a program of that name.
    fn program_name(&mut self, formula: Formula, block: &Block, text: &[u8]) -> Outcome<String> {
        if let [Op::Name(name, _)] = block.formula(formula)
            && self.vars.find(*name).is_none()
        {
            return Ok(self.channel.core.symbols.name(*name).to_owned());
        }
        match self.eval(formula, block, text)? {
            Val::Text(text) if !text.is_empty() => Ok(String::from_utf8_lossy(&text).into_owned()),
            other => self.channel.core.refuse(formula.span, codes::P2024::name_of_program_is_text(&other.what())),
        }
    }

    fn call_section(&mut self, unit: usize, from: Symbol, to: Symbol, span: Span) -> Outcome {
        let skeleton = match self.skeleton_of(unit) {
            Ok(made) => made,
            Err(error) => return self.channel.core.refuse(span, codes::P0105::file_cannot_be_read(&error)),
        };
        let forward = crate::parser::sinumerik::ast::Search::Forward;
        let any = crate::parser::sinumerik::ast::Search::Both;
        let Some(start) = skeleton.label(from, 0, any) else {
            self.channel.core.stop_run();
            return self
                .channel
                .core
                .refuse(span, codes::P2011::there_is_no_label_in_program(&self.channel.core.symbols.name(from)));
        };
        let end = if from == to { Some(start) } else { skeleton.label(to, start.place.at, forward) };
        let Some(end) = end else {
            self.channel.core.stop_run();
            return self
                .channel
                .core
                .refuse(span, codes::P2011::there_is_no_label_behind_first(&self.channel.core.symbols.name(to)));
        };
        self.call_part(unit, Vec::new(), 1, false, Some((start.place, end.after.at)))
    }

    fn modal_call(&mut self, name: Symbol, args: Args, block: &Block, text: &[u8]) -> Outcome {
        let site = self.channel.core.loc(block.span);
        self.channel.st.modal_call.begin(site);
        self.start_modal_call(name, args, block, text)?;
        self.channel.st.modal_call.stands();
        Ok(())
    }

    fn start_modal_call(&mut self, name: Symbol, args: Args, block: &Block, text: &[u8]) -> Outcome {
        let word = self.channel.core.symbols.name(name).to_owned();
        if let Some(result) = self.modal_machining_cycle(&word, args, block, text) {
            return result;
        }
        let refused = match self.vocabulary.get(&word[..]) {
            Some(Meaning::Procedure(Procedure::Refused(Refusal { what, .. }))) => Some(*what),
            _ => None,
        };
        if let Some(what) = refused.filter(|_| !self.own_program(&word)) {
            let help = if super::cycles::is_built(&word) {
                "call the cycle at each place, with its reference point there or after TRANS"
            } else {
                "replace it by plain moves, or compile the program without it"
            };
            return self
                .channel
                .core
                .refuse(block.span, codes::P9010::is_not_supported_as_modal_call(&word, &what).help(help));
        }
        let arguments = self.arguments(args, block, text)?;
        if let Some(done) = self.modal_stand_in(&word, block.span, &arguments) {
            return done;
        }
        let unit = self.find_called(&word, block.span, &arguments)?;
        self.channel.st.modal_call.set_program(unit, arguments);
        Ok(())
    }

    /// Behind a block that moved: the modal program, unless it is the one that moved.
    pub(super) fn call_modal(&mut self) -> Outcome {
        let inside = self
            .channel
            .core
            .levels
            .iter()
            .any(|level| matches!(level.frame.kind, FrameKind::Program { modal: true, .. }));
        if !inside && self.channel.st.modal_call.is_on() {
            self.channel.st.pair.under_no_modal_call(&self.channel.core, &mut self.channel.st.position)?;
        }
        if self.channel.st.modal_call.cycle().is_some() {
            self.channel.tapping_ends();
        }
        if self.channel.st.modal_call.cycle().is_some() && !inside {
            return self.channel.drill_modal();
        }
        match self.channel.st.modal_call.program() {
            Some((unit, arguments)) if !inside => {
                let arguments = arguments.to_vec();
                self.call_unit(unit, arguments, 1, true)
            }
            _ => Ok(()),
        }
    }

    /// Kinds of programs that end without M17 or M30 are worth a word.
    pub(super) fn end_of_program_text(&mut self) {
        self.channel.tapping_ends();
        self.channel.core.refuse_arguments();
        if self.channel.core.in_main() {
            let unit = &self.units.list[self.unit()];
            let is_main = unit.kind == UnitKind::Main && !self.channel.iso;
            if is_main && self.channel.core.may_end_open("M30, M2 or M17", "M30", Some(14000)) {
                let loc = self.channel.core.end_of_text();
                let found = codes::P1007::program_ends_without_m30().at(loc);
                self.channel.core.report(found.help("write M30 as its last block"));
            } else if !is_main && !self.channel.iso {
                self.channel.core.is_cut_off("M17 or RET", "M17");
            }
            let behind = self.channel.core.end_of_text();
            let last = std::mem::replace(&mut self.channel.core.here.origin.loc, behind);
            self.channel.function(crate::ir::Function::End { rewind: false });
            self.channel.core.here.origin.loc = last;
            self.channel.core.stop_run();
            return;
        }
        self.channel.core.is_cut_off("M17 or RET", "M17");
        self.leave_program();
    }
}

impl Channel<'_> {
    /// Where the modal call stands that is still on.
    pub(super) fn open_modal_call(&self) -> Option<Loc> {
        self.st.modal_call.is_on().then_some(self.st.modal_call.site())
    }
}

impl Core<'_> {
    fn program_level_at(&self) -> usize {
        self.levels.iter().rposition(|level| !matches!(level.frame.kind, FrameKind::Section { .. })).unwrap_or(0)
    }

    /// What the level of a program holds, below any repeats.
    pub(super) fn program_level(&mut self) -> &mut Frame {
        let at = self.program_level_at();
        &mut self.levels[at].frame
    }

    /// The block that called the program that runs.
    pub(super) fn call_site(&self) -> Loc {
        self.levels[self.program_level_at()].site
    }

    pub(super) fn enter_section(&mut self, from: Place, stop: u32, times: u32) -> Outcome {
        self.check_depth()?;
        let (site, back) = (self.here.origin.loc, self.place());
        let level = self.level();
        let (program, unit, call) = (level.program, level.frame.unit, level.call);
        let frame = Frame {
            kind: FrameKind::Section { from, stop, left: times - 1 },
            unit,
            counting: None,
            arguments: None,
            given: Vec::new(),
            executed: true,
            declares: true,
            further_pass: false,
        };
        self.levels.push(Level { program, back, call, site, frame });
        self.note_jump();
        self.resume(from)
    }

    fn check_depth(&self) -> Outcome {
        if self.levels.len() >= self.job.settings.limits.call_depth {
            self.stop_run();
            let help = self.cycle_of_calls().unwrap_or_else(|| "call or repeat in fewer levels".to_owned());
            self.refuse(Where::Block, codes::P4003::programs_repeats_are_nested_deeper(&self.levels.len()).help(help))
        } else {
            Ok(())
        }
    }

    /// Where the current program goes on.
    pub(super) fn place(&mut self) -> Place {
        self.program().source.cursor.place()
    }

    /// The kind of the program that runs.
    pub(super) fn in_main(&mut self) -> bool {
        matches!(self.program_level().kind, FrameKind::Main)
    }
}
