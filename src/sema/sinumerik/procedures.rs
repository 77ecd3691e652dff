//! Blocks with a call: procedures of the language, and programs by name.
//!
//! Source: S 1.5, 5.6 and 6 (docs/sources.md).

use rustc_hash::FxHashMap;

use crate::diag::{Fault, codes};
use crate::machine::{AxisSet, StandIn};
use crate::parser::sinumerik::ast::Formula;
use crate::text::Span;

use super::beside_path::Beside;
use super::cycles::Work;
use super::line::{Line, NextText};
use super::stand_in::NameOfCall;
use super::vocabulary::{Meaning, Procedure};
use super::words::{CallWord, Given, Words, call_not_alone, is_modifier};
use super::{Outcome, Run, cycles, formula_functions, levels};

/// What of a block with a call is still to be done.
pub(super) enum Left {
    Nothing,
    /// The words beside a procedure.
    Words,
    Text(NextText),
}

impl From<Option<NextText>> for Left {
    fn from(text: Option<NextText>) -> Left {
        text.map_or(Left::Nothing, Left::Text)
    }
}

/// `CYCLE` and digits: a cycle of the control or of the machine builder.
fn is_cycle(name: &str) -> bool {
    name.strip_prefix("CYCLE").is_some_and(|n| !n.is_empty() && n.bytes().all(|b| b.is_ascii_digit()))
}

/// A procedure that takes no other words in its block.
fn stands_alone(procedure: Procedure) -> bool {
    matches!(
        procedure,
        Procedure::ExecString
            | Procedure::Return
            | Procedure::SetAlarm
            | Procedure::SetMaster
            | Procedure::Transformation(_)
            | Procedure::Refused(_)
    )
}

impl Run<'_> {
    /// A block with a call: of a procedure of the language or of a program.
    pub(super) fn call_block(&mut self, w: &mut Words, line: Line<'_>) -> Outcome<Left> {
        let is_text = w.calls.word.is_some_and(|call| matches!(call.meaning, Meaning::Procedure(Procedure::Message)));
        if !(is_text && self.channel.st.taps.go_on_beside_text()) {
            self.channel.tapping_ends();
        }
        let passes = w.calls.passes.take();
        if let Some((name, span)) = w.calls.number.take() {
            if line.block.words.len() > 1 + usize::from(passes.is_some()) {
                return self.channel.core.refuse(span, call_not_alone());
            }
            return self.call_program(&name, span, None, passes, line).map(Left::from);
        }
        let Some(call) = w.calls.word else { return Ok(Left::Nothing) };
        if let Some(probe) = w.probe {
            return self.channel.core.refuse(probe.span, call_not_alone());
        }
        let beside = Beside::find(self.channel.core.symbols.name(call.name));
        if let (Some(beside), Meaning::Procedure(_) | Meaning::Known(_)) = (beside, call.meaning) {
            if w.has_other() || passes.is_some() {
                return self.channel.core.refuse(call.span, call_not_alone());
            }
            self.channel.core.begins_executing();
            let result = self.coupling(beside, call, line);
            if result.is_err() {
                self.channel.lose_all();
            }
            return result.map(|()| Left::Nothing);
        }
        if let Meaning::Procedure(procedure) = call.meaning {
            w.calls.passes = passes;
            if stands_alone(procedure) && (w.has_other() || w.calls.passes.is_some()) {
                return self.channel.core.refuse(call.span, call_not_alone());
            }
            let text = self.procedure(procedure, call, w, line)?;
            if text.is_none() && (w.has_other() || w.calls.passes.is_some()) {
                return Ok(Left::Words);
            }
            return Ok(text.into());
        }
        // A name in a definition file may be a macro: the block is read again.
        if !self.definitions_known() && self.channel.core.language.is_macro(call.name) {
            let (core, span) = (&self.channel.core, line.block.span);
            let in_file = || core.job.sources.bytes(core.here.file, span.shifted(core.here.at));
            let text = if line.text.is_empty() { in_file() } else { line.text.to_vec() };
            return Ok(Left::Text(NextText { text, span }));
        }
        self.channel.core.begins_executing();
        self.named_program(call, passes, w, line)
    }

    /// A block that calls a program by its name, unless the name is another word.
    fn named_program(&mut self, call: CallWord, passes: Option<Given>, w: &Words, line: Line<'_>) -> Outcome<Left> {
        let core = &mut self.channel.core;
        let name = core.symbols.name(call.name).to_owned();
        if let Meaning::Known(known) = call.meaning
            && !self.units.own_program(core, &name)
        {
            self.channel.st.position.lose(AxisSet::ALL);
            self.channel.lost();
            return self.channel.core.refuse(call.span, known.not_compiled(&name));
        }
        if w.has_other() {
            // Words beside the name of a program; of an unknown word most often.
            let own = self.units.own_program(core, &name);
            let fault = if own { call_not_alone() } else { unknown_word(&name, self.names.vocabulary) };
            return core.refuse(call.span, fault);
        }
        if let Some(fault) = no_name_of_program(&name, call.meaning)
            && !self.units.own_program(core, &name)
        {
            if is_cycle(&name) {
                self.channel.st.position.lose(AxisSet::ALL);
                self.channel.lost();
            }
            return self.channel.core.refuse(call.span, fault);
        }
        self.call_program(&name, call.span, Some(call), passes, line).map(Left::from)
    }

    fn call_program(
        &mut self,
        name: &str,
        span: Span,
        call: Option<CallWord>,
        passes: Option<Given>,
        line: Line<'_>,
    ) -> Outcome<Option<NextText>> {
        let passes = match passes {
            Some(given) => self.channel.core.accept(given.span, levels::passes(given.value))?,
            None => 1,
        };
        let arguments = self.arguments(call.and_then(|call| call.args), line)?;
        self.channel.pending_must_be_done(span)?;
        self.call_by_name(name, span, arguments, passes)
    }

    /// A word of the language that is written like a call.
    fn procedure(
        &mut self,
        procedure: Procedure,
        call: CallWord,
        w: &mut Words,
        line: Line<'_>,
    ) -> Outcome<Option<NextText>> {
        let core = &mut self.channel.core;
        let name = core.symbols.name(call.name).to_owned();
        let row = cycles::find(&name).filter(|row| !matches!(row.work, Work::Nothing));
        if let Some(row) = row.filter(|_| !self.units.own_program(core, &name)) {
            let given = self.given_of(row, call.args, call.span, line);
            let result = given.and_then(|given| self.run_cycle(row, &given));
            if result.is_err() {
                self.channel.st.position.lose(AxisSet::ALL);
                self.channel.lost();
            }
            if w.has_other() {
                return self.channel.core.refuse(call.span, call_not_alone());
            }
            return result.map(|()| None);
        }
        let formulas: &[Formula] = line.arguments_of(call.args);
        let core = &mut self.channel.core;
        let by_file = matches!(core.job.settings.programs.get(&name), Some(StandIn::File(_)));
        match procedure {
            Procedure::Refused(_) if cycles::measures(&name) && !by_file && !self.units.is_here(core, &name) => {
                let values = self.values(formulas, line)?;
                self.channel.leave_cycle_out(&name, &values, call.span)?;
                Ok(None)
            }
            Procedure::Refused(_) if matches!(&name[..], "GETEXET" | "GETSELT") => {
                self.asks_for_tool(&name, formulas, call.span, line).map(|()| None)
            }
            Procedure::Refused(_) | Procedure::Transformation(_) if self.units.own_program(core, &name) => {
                self.call_program(&name, call.span, Some(call), None, line)
            }
            Procedure::Dynamics | Procedure::Swivel
                if cycles::is_program(&name) && self.units.own_program(core, &name) =>
            {
                if w.has_other() {
                    return core.refuse(call.span, call_not_alone());
                }
                let passes = w.calls.passes.take();
                self.call_program(&name, call.span, Some(call), passes, line)
            }
            _ => self.procedure_of_language(procedure, &name, (formulas, call.span), line),
        }
    }
}

/// What a name is, if only a program of the user may make it the name of one.
fn no_name_of_program(name: &str, meaning: Meaning) -> Option<Fault> {
    if formula_functions::find(name).is_some() || is_modifier(name) {
        return Some(codes::P1001::is_function_no_block(&name));
    }
    if is_cycle(name) {
        let line = NameOfCall { name, text: None, arguments: true, tool_waits: false }.line();
        return Some(codes::P9010::cycle_of_control_or_of_machine_builder(&name, &line));
    }
    matches!(meaning, Meaning::Address(_) | Meaning::Indexed(_)).then(|| codes::P1001::is_word_of_language(&name))
}

/// What is wrong with a word that nothing is known of, beside other words.
fn unknown_word(name: &str, vocabulary: &FxHashMap<&str, Meaning>) -> Fault {
    let letters = name.trim_end_matches(|c: char| c.is_ascii_digit() || c == '.');
    if letters.len() < name.len() && matches!(vocabulary.get(letters), Some(Meaning::Address(_))) {
        return codes::P1001::is_missing(&name, &letters, &&name[letters.len()..]);
    }
    let mut known: Vec<&str> = vocabulary.keys().copied().collect();
    known.sort_unstable();
    let help = match crate::machine::tree::did_you_mean(name, known) {
        Some(like) => format!("did you mean `{like}`?"),
        None => "a call needs a block of its own; an address takes `=`".to_owned(),
    };
    codes::S2001::word_is_not_known_here(&name).help(&help)
}
