//! Blocks with a call: procedures of the language, and programs by name.
//!
//! Source: S 1.5, 5.6 and 6 (docs/sources.md).

use crate::diag::{Answer, Fault, codes};
use crate::ir::Function;
use crate::machine::{AxisSet, StandIn};
use crate::parser::sinumerik::ast::{Block, Formula};
use crate::text::Span;

use super::stand_in::NameOfCall;
use super::value::{Val, to_text, whole};
use super::vocabulary::{Meaning, Procedure, Refusal};
use super::words::{CallWord, Given, Words};
use super::{Core, Outcome, Run};

/// Words of the tool management that give no value and change no tool.
const LEFT_OUT_BY_ENTRY: [&str; 2] = ["SETPIECE", "RESETMON"];

/// `CYCLE` and digits: a cycle of the control or of the machine builder.
fn is_cycle(name: &str) -> bool {
    name.strip_prefix("CYCLE").is_some_and(|n| !n.is_empty() && n.bytes().all(|b| b.is_ascii_digit()))
}

impl Run<'_> {
    /// A block with a call: of a procedure of the language or of a program.
    pub(super) fn call_block(&mut self, w: &mut Words, block: &Block, text: &[u8]) -> Outcome {
        let is_text = w.calls.word.is_some_and(|call| matches!(call.meaning, Meaning::Procedure(Procedure::Message)));
        if !(is_text && self.channel.st.taps.go_on_beside_text()) {
            self.channel.tapping_ends();
        }
        let passes = w.calls.passes.take();
        if let Some((name, span)) = w.calls.number.take() {
            if block.words.len() > 1 + usize::from(passes.is_some()) {
                return self.channel.core.call_not_alone(span);
            }
            return self.call_program(&name, span, None, passes, block, text);
        }
        let Some(call) = w.calls.word else { return Ok(()) };
        if let Some(probe) = w.probe {
            return self.channel.core.call_not_alone(probe.span);
        }
        if let (Some(beside), Meaning::Procedure(_) | Meaning::Known(_)) = (self.stands_beside_path(w), call.meaning) {
            if self.channel.core.has_other_words(w) || passes.is_some() {
                return self.channel.core.call_not_alone(call.span);
            }
            self.begins_executing();
            let name = self.channel.core.symbols.name(call.name).to_owned();
            let formulas: Vec<Formula> = call.args.map(|args| block.arguments(args).to_vec()).unwrap_or_default();
            return self.coupling(beside, (&name, call), &formulas, block, text);
        }
        if let Meaning::Procedure(procedure) = call.meaning {
            w.calls.passes = passes;
            let alone = matches!(
                procedure,
                Procedure::ExecString
                    | Procedure::Return
                    | Procedure::SetAlarm
                    | Procedure::SetMaster
                    | Procedure::Transformation(_)
                    | Procedure::Refused(_)
            );
            if alone && (self.channel.core.has_other_words(w) || w.calls.passes.is_some()) {
                return self.channel.core.call_not_alone(call.span);
            }
            self.procedure(procedure, call, w, block, text)?;
            return self.rest_of_block(w, block);
        }
        // A name in a definition file may be a macro.
        if !self.definitions_known() && self.channel.core.language.is_macro(call.name) {
            return self.again(block, text);
        }
        self.begins_executing();
        self.named_program(call, passes, w, block, text)
    }

    /// A block that calls a program by its name, unless the name is another word.
    fn named_program(
        &mut self,
        call: CallWord,
        passes: Option<Given>,
        w: &Words,
        block: &Block,
        text: &[u8],
    ) -> Outcome {
        let name = self.channel.core.symbols.name(call.name).to_owned();
        if let Meaning::Known(known) = call.meaning
            && !self.own_program(&name)
        {
            self.channel.st.position.lose(AxisSet::ALL);
            self.channel.lost();
            return self.channel.core.not_compiled(call.name, known, call.span);
        }
        if self.channel.core.has_other_words(w) {
            // Words beside the name of a program; of an unknown word most often.
            return if self.own_program(&name) {
                self.channel.core.call_not_alone(call.span)
            } else {
                self.unknown_word(call)
            };
        }
        if let Some(fault) = self.no_name_of_program(&name, call)
            && !self.own_program(&name)
        {
            if is_cycle(&name) {
                self.channel.st.position.lose(AxisSet::ALL);
                self.channel.lost();
            }
            return self.channel.core.refuse(call.span, fault);
        }
        self.call_program(&name, call.span, Some(call), passes, block, text)
    }

    /// What a name is, if only a program of the user may make it the name of one.
    fn no_name_of_program(&mut self, name: &str, call: CallWord) -> Option<Fault> {
        if super::formula_functions::find(name).is_some() || super::words::is_modifier(name) {
            return Some(codes::P1001::is_function_no_block(&name));
        }
        if is_cycle(name) {
            let line = NameOfCall { name, text: None, arguments: true, tool_waits: false }.line();
            return Some(codes::P9010::cycle_of_control_or_of_machine_builder(&name, &line));
        }
        let is_word = matches!(self.meaning(call.name), Meaning::Address(_) | Meaning::Indexed(_));
        is_word.then(|| codes::P1001::is_word_of_language(&name))
    }

    /// A program of the user with the name of a cycle goes before it, and so does what `[programs]` gives in its place.
    pub(super) fn own_program(&mut self, name: &str) -> bool {
        self.channel.core.job.settings.programs.contains_key(name) || self.is_here(name)
    }

    /// Is there a program of this name in the file, or beside it?
    pub(super) fn is_here(&mut self, name: &str) -> bool {
        let unit = self.unit();
        let file = self.units.list[unit].file;
        if let Some(here) = self.units.asked.get(&file).and_then(|names| names.get(name)) {
            return *here;
        }
        let here = self.stands_beside(name, file);
        self.units.asked.entry(file).or_default().insert(name.to_owned(), here);
        here
    }

    fn stands_beside(&mut self, name: &str, file: usize) -> bool {
        if self.list_programs(0).and_then(|()| self.list_programs(file)).is_err() {
            return false;
        }
        let is_unit = [0, file].into_iter().any(|file| self.units.of_file(file, name).next().is_some());
        // A main program in a file of its own is none that goes before a cycle.
        self.search(|path| path.is_there(&format!("{name}_SPF")) || is_unit && path.is_there(name))
    }

    pub(super) fn unknown_word<T>(&self, call: CallWord) -> Outcome<T> {
        let name = self.channel.core.symbols.name(call.name);
        let letters = name.trim_end_matches(|c: char| c.is_ascii_digit() || c == '.');
        if letters.len() < name.len() && matches!(self.vocabulary.get(letters), Some(Meaning::Address(_))) {
            let digits = &name[letters.len()..];
            return self.channel.core.refuse(call.span, codes::P1001::is_missing(&name, &letters, &digits));
        }
        let mut known: Vec<&str> = self.vocabulary.keys().copied().collect();
        known.sort_unstable();
        let like = crate::machine::tree::did_you_mean(name, known);
        let help = match like {
            Some(like) => format!("did you mean `{like}`?"),
            None => "a call needs a block of its own; an address takes `=`".to_owned(),
        };
        self.channel.core.refuse(call.span, codes::S2001::word_is_not_known_here(&name).help(&help))
    }

    pub(super) fn call_program(
        &mut self,
        name: &str,
        span: Span,
        call: Option<CallWord>,
        passes: Option<Given>,
        block: &Block,
        text: &[u8],
    ) -> Outcome {
        let passes = match passes {
            Some(given) => self.channel.core.check_passes(given.value, given.span)?,
            None => 1,
        };
        let arguments = match call.and_then(|call| call.args) {
            Some(args) => self.arguments(args, block, text)?,
            None => Vec::new(),
        };
        self.channel.pending_must_be_done(span)?;
        self.call_by_name(name, span, arguments, passes)
    }

    /// A word of the language that is written like a call.
    pub(super) fn procedure(
        &mut self,
        procedure: Procedure,
        call: CallWord,
        w: &mut Words,
        block: &Block,
        text: &[u8],
    ) -> Outcome {
        let name = self.channel.core.symbols.name(call.name).to_owned();
        if let Some(result) = self.machining_cycle(&name, call, block, text) {
            if self.channel.core.has_other_words(w) {
                return self.channel.core.call_not_alone(call.span);
            }
            return result;
        }
        let formulas: Vec<Formula> = call.args.map(|args| block.arguments(args).to_vec()).unwrap_or_default();
        let by_file = matches!(self.channel.core.job.settings.programs.get(&name), Some(StandIn::File(_)));
        match procedure {
            Procedure::Refused(_) if super::cycles::measures(&name) && !by_file && !self.is_here(&name) => {
                self.measuring_cycle((&name, call.span), &formulas, block, text)
            }
            Procedure::Refused(_) if matches!(&name[..], "GETEXET" | "GETSELT") => {
                self.asks_for_tool(&name, &formulas, call.span, block, text)
            }
            Procedure::Refused(_) | Procedure::Transformation(_) if self.own_program(&name) => {
                self.call_program(&name, call.span, Some(call), None, block, text)
            }
            Procedure::Dynamics | Procedure::Swivel if super::cycles::is_program(&name) && self.own_program(&name) => {
                if self.channel.core.has_other_words(w) {
                    return self.channel.core.call_not_alone(call.span);
                }
                let passes = w.calls.passes.take();
                self.call_program(&name, call.span, Some(call), passes, block, text)
            }
            _ => self.procedure_of_language(procedure, &name, (&formulas, call.span), block, text),
        }
    }

    /// A word that is written like a call and whose effect is the control's own.
    fn procedure_of_language(
        &mut self,
        procedure: Procedure,
        name: &str,
        (formulas, span): (&[Formula], Span),
        block: &Block,
        text: &[u8],
    ) -> Outcome {
        let core = &self.channel.core;
        match procedure {
            Procedure::Dynamics if name == "FGROUP" => return self.feed_axes(formulas, span, block, text),
            Procedure::Dynamics if name == "CYCLE832" => return self.high_speed_settings(formulas, span, block, text),
            Procedure::NoEffect => core.control_words_are_left_out(span),
            Procedure::WheelSpeed => core.changes_feeds(codes::S8101::speed_of_wheel_is_left_out(&name), span),
            Procedure::Dynamics => core.dynamics_are_left_out(span),
            Procedure::Channel => core.say_once(span, codes::S8015::words_that_synchronize_channels_are_left_out()),
            Procedure::Actions => core.say_once(span, codes::S8170::acts_on_synchronized_actions(&name)),
            Procedure::Interrupt => core.say_once(span, codes::S8016::interrupt_programs_are_left_out()),
            Procedure::Message => return self.message(formulas, block, text),
            Procedure::SetAlarm => return self.set_alarm(formulas, span, block, text),
            Procedure::SetMaster => return self.set_master_block(formulas, span, block, text),
            Procedure::FileAccess => return self.file_access(name, formulas, span, block, text),
            Procedure::CallPath => return self.call_path_block(formulas, span, block, text),
            Procedure::ExecString => return self.exec_string(formulas, span, block, text),
            Procedure::Return => return self.return_block(formulas, span, block, text),
            Procedure::Transformation(on) => return self.transformation(on, formulas, span, block, text),
            Procedure::TransformationOff | Procedure::DiameterChannel if !formulas.is_empty() => {
                return core.refuse(span, codes::S2021::takes_no_argument(&name));
            }
            Procedure::TransformationOff => {
                let on = self.channel.st.transformation.is_some();
                self.channel.transformation_ends(span)?;
                if !on {
                    self.channel.core.control_words_are_left_out(span);
                }
            }
            Procedure::Swivel if formulas.is_empty() => {
                self.channel.swivel_off();
                self.channel.core.control_words_are_left_out(span);
            }
            Procedure::Swivel => return self.swivel(formulas, span, block, text),
            Procedure::GeoAxes => return self.geo_axes(formulas, span, block, text),
            Procedure::EndLabel => return core.refuse(span, codes::P1001::endlabel_is_label()),
            Procedure::DiameterChannel => self.channel.st.diameter = None,
            Procedure::Refused(refusal) => return self.refused_procedure(name, refusal, span),
        }
        Ok(())
    }

    /// SETAL
    fn set_alarm(&mut self, formulas: &[Formula], span: Span, block: &Block, text: &[u8]) -> Outcome {
        let mut shown = String::new();
        let alarm = formulas.first().and_then(|formula| self.number(*formula, block, text).ok());
        if let Some(number) = alarm.filter(|number| !(60_000.0..70_000.0).contains(number)) {
            self.channel.core.stop_run();
            return self.channel.core.refuse(span, codes::P2026::setal_is_no_alarm_of_program(&number));
        }
        for formula in formulas {
            let value = self.eval(*formula, block, text)?;
            if let Some(text) = to_text(&value) {
                shown = format!("{shown} {}", String::from_utf8_lossy(&text));
            }
        }
        self.channel.core.stop_run();
        let (cause, help) = match alarm.and_then(super::cycle_alarms::meaning) {
            Some((cause, help)) => (format!(": {cause}"), help),
            None => (String::new(), "it found its own data wrong: look at the conditions before SETAL"),
        };
        self.channel.core.refuse(span, codes::P2026::program_raises_alarm(&shown, &cause).help(help))
    }

    /// SETMS
    fn set_master_block(&mut self, formulas: &[Formula], span: Span, block: &Block, text: &[u8]) -> Outcome {
        let n = match formulas.first() {
            Some(formula) => self.number(*formula, block, text)?,
            None => 1.0,
        };
        match whole(n).and_then(|n| u8::try_from(n).ok()).filter(|n| (1..=20).contains(n)) {
            Some(n) => self.channel.set_master(n, span),
            None => self.channel.core.refuse(span, codes::S2045::there_is_no_spindle(&n)),
        }
    }

    /// A procedure that cannot be compiled: nobody knows where it leaves the axes.
    fn refused_procedure(&mut self, name: &str, Refusal { what, code, .. }: Refusal, span: Span) -> Outcome {
        self.channel.st.position.lose(AxisSet::ALL);
        self.channel.lost();
        let key = Answer::key("programs", name);
        let instead = super::cycles::instead(name);
        let fault = if code == codes::S9006 {
            codes::S9006::procedure_is_not_supported(&name, &what).help(instead)
        } else if super::cycles::is_program(name) {
            let file = key.one_of(&[format!("{{ file = \"stubs/{name}.SPF\" }}")]);
            codes::P9010::cycle_is_not_supported_but_file_may_run(&name, &what, &instead).answer(file)
        } else if LEFT_OUT_BY_ENTRY.contains(&name) {
            let ignored = key.one_of(&["{ ignore = true }"]);
            codes::P9010::procedure_may_be_left_out(&name, &what).answer(ignored)
        } else {
            codes::P9010::procedure_is_not_supported(&name, &what)
        };
        self.channel.core.refuse(span, fault)
    }

    /// Words beside a procedure that has no effect.
    pub(super) fn rest_of_block(&mut self, w: &mut Words, block: &Block) -> Outcome {
        if self.channel.core.has_other_words(w) || w.calls.passes.is_some() {
            w.calls.word = None;
            self.begins_executing();
            return self.words_again(w, block);
        }
        Ok(())
    }

    pub(super) fn message(&mut self, formulas: &[Formula], block: &Block, text: &[u8]) -> Outcome {
        let Some(formula) = formulas.first().filter(|formula| !formula.is_missing()) else { return Ok(()) };
        let value = self.eval(*formula, block, text)?;
        if self.channel.core.job.settings.output.comments
            && let Some(shown) = to_text(&value)
            && !shown.is_empty()
        {
            self.channel.function(Function::Comment(shown));
        }
        Ok(())
    }

    pub(super) fn exec_string(&mut self, formulas: &[Formula], span: Span, block: &Block, text: &[u8]) -> Outcome {
        let [formula] = *formulas else {
            return self.channel.core.refuse(span, codes::S2021::execstring_takes_one_text());
        };
        match self.eval(formula, block, text)? {
            Val::Text(line) => self.execute_line(&line, span),
            other => self.channel.core.refuse(formula.span, codes::P2024::text_is_needed(&other.what())),
        }
    }

    /// CALLPATH("/_N_WKS_DIR/_N_A_WPD"), and CALLPATH() to search no further folder.
    fn call_path_block(&mut self, formulas: &[Formula], span: Span, block: &Block, text: &[u8]) -> Outcome {
        let folder = match *formulas {
            [] => None,
            [formula] => match self.eval(formula, block, text)? {
                Val::Text(folder) => Some(String::from_utf8_lossy(&folder).into_owned()).filter(|it| !it.is_empty()),
                Val::Missing => None,
                other => {
                    return self.channel.core.refuse(formula.span, codes::P2024::text_is_needed(&other.what()));
                }
            },
            _ => return self.channel.core.refuse(span, codes::S2021::callpath_takes_one_text()),
        };
        if let Some(wrong) = folder.as_deref().filter(|folder| !folder.starts_with('/')) {
            return self.channel.core.refuse(span, codes::S2021::is_no_folder_of_control(&wrong));
        }
        self.extend_search(folder, span);
        Ok(())
    }

    pub(super) fn geo_axes(&mut self, formulas: &[Formula], span: Span, block: &Block, text: &[u8]) -> Outcome {
        for pair in formulas.chunks(2) {
            let [number, axis] = pair else { break };
            let n = self.number(*number, block, text)?;
            if !(0.0..=3.0).contains(&n) {
                return self.channel.core.refuse(span, codes::S2021::geoax_names_geometry_axis(&n));
            }
            let place = whole(n).and_then(|n| usize::try_from(n).ok()).and_then(|n| n.checked_sub(1));
            let same = match (
                place.and_then(|at| self.channel.st.machine.geometry_axes.get(at)).copied(),
                self.eval(*axis, block, text)?,
            ) {
                (Some(known), Val::Axis(named)) => named.axis == Some(known),
                _ => false,
            };
            if !same {
                return self.channel.core.refuse(
                    span,
                    codes::P9011::geoax_gives_geometry_axes_other_names()
                        .answer(Answer::key("machine", "geometry_axes")),
                );
            }
        }
        self.channel.core.control_words_are_left_out(span);
        Ok(())
    }
}

impl Core<'_> {
    pub(super) fn has_other_words(&self, w: &Words) -> bool {
        !w.axes.is_empty()
            || !w.codes.is_empty()
            || !w.m.is_empty()
            || !w.s.is_empty()
            || w.has_addresses()
            || w.h.is_some()
            || w.axis_word_left().is_some()
            || w.diameter.is_some()
            || w.probe.is_some()
    }

    pub(super) fn call_not_alone<T>(&self, span: Span) -> Outcome<T> {
        self.refuse(span, codes::S2013::call_stands_beside_other_words())
    }
}
