//! Calls of programs by their names: what runs, or what `[programs]` says stands for it.
//!
//! Source: S 5.6 (docs/sources.md).

use crate::diag::codes;
use crate::machine::settings::Leaves;
use crate::machine::{AxisSet, StandIn};
use crate::parser::sinumerik::ast::{Args, CallForm, Formula, Op};
use crate::parser::symbols::Symbol;
use crate::text::Span;

use super::callee::{Missing, called_name};
use super::cycles;
use super::entries::reserved;
use super::line::{Line, NextText};
use super::modal_call::ModalCall;
use super::programs::without_extension;
use super::stand_in::NameOfCall;
use super::value::Val;
use super::vars::Argument;
use super::vocabulary::{Meaning, Procedure, Refusal};
use super::{Outcome, Reported, Run};

impl Run<'_> {
    pub(super) fn call_form(&mut self, form: CallForm, line: Line<'_>) -> Outcome<Option<NextText>> {
        let span = line.block.span;
        match form {
            CallForm::Text(formula) | CallForm::External(formula) => {
                let name = self.program_name(formula, line)?;
                return self.call_by_name(&name, formula.span, Vec::new(), 1);
            }
            CallForm::Section { program, from, to } => {
                let unit = match program {
                    Some(formula) => {
                        let name = self.program_name(formula, line)?;
                        self.units.find_program(&mut self.channel.core, &name, formula.span)?
                    }
                    None => self.channel.core.level().frame.unit,
                };
                let part = self.units.called_section(&mut self.channel.core, unit, from, to, span)?;
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

    /// `CALL "NAME"`; `CALL NAME` means a text variable, or a program of that name.
    fn program_name(&mut self, formula: Formula, line: Line<'_>) -> Outcome<String> {
        if let [Op::Name(name, _)] = line.ops(formula)
            && self.vars.find(*name).is_none()
        {
            return Ok(self.channel.core.symbols.name(*name).to_owned());
        }
        match self.eval(formula, line)? {
            Val::Text(text) if !text.is_empty() => Ok(String::from_utf8_lossy(&text).into_owned()),
            other => self.channel.core.refuse(formula.span, codes::P2024::name_of_program_is_text(&other.what())),
        }
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
        let unit = self.find_called(name, span, &arguments)?;
        self.call(unit, arguments, passes, false, None)?;
        Ok(None)
    }

    /// Finds a program that is called, and proposes what may stand for one that is nowhere.
    fn find_called(&mut self, name: &str, span: Span, arguments: &[Argument]) -> Outcome<usize> {
        let core = &mut self.channel.core;
        let found = self.units.look_for(core, name, span).or_else(|missing| match missing {
            Missing::Reported => Err(Reported),
            Missing::Nowhere(nowhere) => {
                let plain = called_name(name);
                let text = arguments.iter().position(|argument| matches!(argument.value, Val::Text(_)));
                let tool = &self.channel.st.tool;
                let call = NameOfCall {
                    name: without_extension(&plain),
                    text: text.map(|at| at + 1),
                    arguments: !arguments.is_empty(),
                    tool_waits: tool.waiting().is_some() || tool.waits_unnamed,
                };
                let known = self.vocabulary.get(call.name).is_some_and(|known| reserved(*known).is_some());
                let help = if known { call.help_of_word() } else { call.help() };
                self.units.program_missing(core, &plain, nowhere, &help, span)
            }
        });
        if found.is_err() {
            // What it would have done is not known.
            self.channel.st.position.lose(AxisSet::ALL);
            self.channel.lost();
        }
        found
    }

    // MCALL.

    fn start_modal_call(&mut self, name: Symbol, args: Args, line: Line<'_>) -> Outcome {
        let span = line.block.span;
        let word = self.channel.core.symbols.name(name).to_owned();
        if let Some(result) = self.modal_machining_cycle(&word, args, line) {
            return result;
        }
        if let Some(Meaning::Procedure(Procedure::Refused(Refusal { what, .. }))) = self.vocabulary.get(&word[..])
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
            return self.modal_stand_in(plain, &stand_in, span, &arguments);
        }
        let unit = self.find_called(&word, span, &arguments)?;
        self.channel.st.modal_call.set_program(unit, arguments);
        Ok(())
    }

    /// What stands for a program behind MCALL: only one that does nothing can, after each move.
    fn modal_stand_in(&mut self, name: &str, stand_in: &StandIn, span: Span, arguments: &[Argument]) -> Outcome {
        let channel = &mut self.channel;
        channel.st.modal_call.end();
        if matches!(stand_in, StandIn::Change(_)) {
            return channel.core.refuse(span, codes::S2043::changes_tool(&name));
        }
        let measures = cycles::measures(name);
        if !measures && channel.core.job.settings.left_by(name) != Leaves::default() {
            return channel.core.refuse(span, codes::S2043::mcall_calls_after_each_move(&name));
        }
        channel.leave_call_out(name, span, arguments)?;
        if !measures {
            channel.leave_technology(name, span);
        }
        Ok(())
    }
}
