//! Calls of programs by their names: what runs, or what `[programs]` says stands for it.
//!
//! Source: S 5.6 (docs/sources.md).

use crate::diag::codes;
use crate::machine::{AxisSet, StandIn};
use crate::parser::sinumerik::ast::{Args, CallForm, Op};
use crate::parser::symbols::Symbol;
use crate::text::Span;

use super::callee::{Missing, called_name};
use super::cycles::{self, Work};
use super::entries::reserved;
use super::line::{Line, NextText};
use super::modal_call::{ModalCall, ModalCycle};
use super::programs::{Units, without_extension};
use super::stand_in::NameOfCall;
use super::value::Val;
use super::vars::Argument;
use super::vocabulary::{Meaning, Procedure, Refusal};
use super::{Channel, Outcome, Reported, Run, dictionary};

impl Units {
    /// Finds a program that is called, and proposes what may stand for one that is nowhere.
    fn find_called(
        &mut self,
        channel: &mut Channel<'_>,
        name: &str,
        span: Span,
        arguments: &[Argument],
    ) -> Outcome<usize> {
        let Channel { core, st, .. } = channel;
        let found = self.look_for(core, name, span).or_else(|missing| match missing {
            Missing::Reported => Err(Reported),
            Missing::Nowhere(nowhere) => {
                let plain = called_name(name);
                let text = arguments.iter().position(|argument| matches!(argument.value, Val::Text(_)));
                let call = NameOfCall {
                    name: without_extension(&plain),
                    text: text.map(|at| at + 1),
                    arguments: !arguments.is_empty(),
                    tool_waits: st.tool.waiting().is_some() || st.tool.waits_unnamed,
                };
                let known = dictionary::words().get(call.name).is_some_and(|known| reserved(*known).is_some());
                let help = if known { call.help_of_word() } else { call.help() };
                self.program_missing(core, &plain, nowhere, &help, span)
            }
        });
        if found.is_err() {
            // What it would have done is not known.
            channel.st.position.lose(AxisSet::ALL);
            channel.lost();
        }
        found
    }
}

impl Run<'_> {
    pub(super) fn call_form(&mut self, form: CallForm, line: Line<'_>) -> Outcome<Option<NextText>> {
        let span = line.block.span;
        let named = match form {
            CallForm::Text(formula) | CallForm::External(formula) => Some(formula),
            CallForm::Section { program, .. } => program,
            CallForm::Path { .. } | CallForm::Modal { .. } | CallForm::ModalOff | CallForm::Iso => None,
        };
        // `CALL "NAME"`; `CALL NAME` means a text variable, or a program of that name.
        let name = match named.map(|formula| (formula, line.ops(formula))) {
            None => String::new(),
            Some((_, [Op::Name(name, _)])) if self.vars.find(*name).is_none() => {
                self.channel.core.symbols.name(*name).to_owned()
            }
            Some((formula, _)) => match self.eval(formula, line)? {
                Val::Text(text) if !text.is_empty() => String::from_utf8_lossy(&text).into_owned(),
                other => {
                    let fault = codes::P2024::name_of_program_is_text(&other.what());
                    return self.channel.core.refuse(formula.span, fault);
                }
            },
        };
        match form {
            CallForm::Text(formula) | CallForm::External(formula) => {
                return self.call_by_name(&name, formula.span, Vec::new(), 1);
            }
            CallForm::Section { program, from, to } => {
                let core = &mut self.channel.core;
                let unit = match program {
                    Some(formula) => self.units.find_program(core, &name, formula.span)?,
                    None => core.level().frame.unit,
                };
                let part = self.units.called_section(core, unit, from, to, span)?;
                self.call(unit, Vec::new(), 1, false, Some(part))?;
            }
            CallForm::Path { path, args } => {
                let name = String::from_utf8_lossy(path.of(line.text)).replace(' ', "");
                let arguments = self.arguments(Some(args), line)?;
                return self.call_by_name(&name, path, arguments, 1);
            }
            CallForm::Modal { name, args } => {
                self.channel.st.modal_call.begin(self.channel.core.loc(span));
                self.start_modal_call(name, args, line)?;
                self.channel.st.modal_call.stands();
            }
            CallForm::ModalOff => self.channel.st.modal_call = ModalCall::default(),
            CallForm::Iso => {
                return self.channel.core.refuse(span, codes::P9012::isocall_calls_program_in_iso_dialect());
            }
        }
        Ok(None)
    }

    /// Calls the program `name`, or does what stands for it: what then remains is a text of feed and spindle.
    pub(super) fn call_by_name(
        &mut self,
        name: &str,
        span: Span,
        arguments: Vec<Argument>,
        passes: u32,
    ) -> Outcome<Option<NextText>> {
        let called = called_name(name);
        let called = without_extension(&called);
        if let Some(stand_in) = self.units.stand_in(&mut self.channel.core, called) {
            match stand_in {
                StandIn::Change(change) => {
                    self.channel.change_by_program(called, &change, span, &arguments, passes)?;
                }
                _ => self.channel.leave_call_out(called, span, &arguments)?,
            }
            return Ok(self.channel.leave_technology(called, span).map(|text| NextText { text, span }));
        }
        let unit = self.units.find_called(&mut self.channel, name, span, &arguments)?;
        self.call(unit, arguments, passes, false, None)?;
        Ok(None)
    }

    // MCALL.

    fn start_modal_call(&mut self, name: Symbol, args: Args, line: Line<'_>) -> Outcome {
        let span = line.block.span;
        let core = &mut self.channel.core;
        let word = core.symbols.name(name).to_owned();
        if let Some(row) = cycles::find(&word)
            && let Work::Hole(drilling) = &row.work
            && !self.units.own_program(core, &word)
        {
            let given = self.given_of(row, Some(args), span, line)?;
            let channel = &mut self.channel;
            channel.st.modal_call.end();
            let hole = channel.hole_of(row, &given)?;
            let feed_of_block = drilling.modal_feed;
            let under = (channel.st.plane(), channel.st.length_unit());
            let (here, spindle) = (channel.core.here, channel.st.spindle_state());
            let made = ModalCycle { hole, given, here, spindle, feed_of_block, under, refused: false };
            channel.st.modal_call.set_cycle(Box::new(made));
            return Ok(());
        }
        if let Some(Meaning::Procedure(Procedure::Refused(Refusal { what, .. }))) = self.names.vocabulary.get(&word[..])
            && !self.units.own_program(&mut self.channel.core, &word)
        {
            let help = if cycles::is_built(&word) {
                "call the cycle at each place, with its reference point there or after TRANS"
            } else {
                "replace it by plain moves, or compile the program without it"
            };
            let fault = codes::P9010::is_not_supported_as_modal_call(&word, what).help(help);
            return self.channel.core.refuse(span, fault);
        }
        let arguments = self.arguments(Some(args), line)?;
        let plain = without_extension(&word);
        if let Some(stand_in) = self.units.stand_in(&mut self.channel.core, plain) {
            return self.channel.modal_stand_in(plain, &stand_in, span, &arguments);
        }
        let unit = self.units.find_called(&mut self.channel, &word, span, &arguments)?;
        self.channel.st.modal_call.set_program(unit, arguments);
        Ok(())
    }
}
