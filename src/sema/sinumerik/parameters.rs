//! Arguments of calls and parameters of PROC.
//!
//! Source: S 5.6 (docs/sources.md).

use crate::diag::{Label, codes};
use crate::parser::sinumerik::ast::{Args, Base, Block, Formula, Op, Target, TypeName, Variable};
use crate::parser::symbols::Symbol;

use super::conversions::{ASSIGNED, says_negative_half};
use super::levels::{self, FrameKind};
use super::line::Line;
use super::value::{MOST_TEXT, Val, r_index, type_name};
use super::vars::{Argument, Reference, Slot, Var, Vars};
use super::{Core, Outcome, Reported, Run};

impl Run<'_> {
    /// Evaluates the arguments of a call.
    pub(super) fn arguments(&mut self, args: Option<Args>, line: Line<'_>) -> Outcome<Vec<Argument>> {
        let formulas = line.arguments_of(args);
        let mut list = Vec::with_capacity(formulas.len());
        for formula in formulas {
            let reference = self.reference(*formula, line)?;
            let array = match reference {
                Some(Reference::Variable(slot)) => self.vars.get(slot).is_some_and(|var| !var.sizes.is_empty()),
                _ => false,
            };
            let value = if array { Val::Missing } else { self.eval(*formula, line)? };
            list.push(Argument { value, reference, loc: self.channel.core.loc(formula.span) });
        }
        Ok(list)
    }

    /// The variable that a formula is, if it is nothing else.
    pub(super) fn reference(&mut self, formula: Formula, line: Line<'_>) -> Outcome<Option<Reference>> {
        let (indices, base, span) = match line.ops(formula) {
            [Op::R(n, _)] => return Ok(Some(Reference::R(*n))),
            [Op::Name(name, _)] => return Ok(self.known_variable(*name).map(Reference::Variable)),
            [indices @ .., Op::Index(base, count, span)] if indices.len() == *count as usize => (indices, *base, *span),
            _ => return Ok(None),
        };
        let mut values = Vec::with_capacity(indices.len());
        for op in indices {
            let one = Block { ops: vec![*op], ..Block::default() };
            values.push(self.eval(Formula { from: 0, to: 1, span }, Line { block: &one, text: line.text })?);
        }
        let slot = match base {
            Base::Letter(b'R') => {
                return self.channel.core.accept(span, r_index(&values)).map(|n| Some(Reference::R(n)));
            }
            Base::Name(name) => self.known_variable(name),
            Base::Letter(letter) => self.vars.letter(letter, &self.channel.core.symbols),
            Base::System(_) => None,
        };
        match slot {
            Some(slot) => self.channel.core.accept(span, self.vars.element(slot, &values)),
            None => Ok(None),
        }
    }

    /// PROC: the arguments of the call become variables.
    pub(super) fn proc_block(&mut self, line: Line<'_>) -> Outcome {
        let (block, core) = (line.block, &mut self.channel.core);
        let level = levels::program(&mut core.levels);
        if level.executed {
            return core.refuse(block.span, codes::S2015::proc_stands_behind_executed_blocks());
        }
        if std::mem::replace(&mut level.declares, true) {
            // Its parameters are defined all the same: what reads them is right.
            core.say(block.span, codes::S2015::proc_stands_inside_definition_part());
        }
        let unit = levels::unit(&core.levels);
        let level = levels::program(&mut core.levels);
        let (arguments, further_pass) = (level.arguments.take().unwrap_or_default(), level.further_pass);
        self.externs.check(core, &self.units.list[unit].name, block);
        let is_save = |name: Symbol| core.symbols.name(name) == "SAVE";
        if block.words.iter().any(|word| matches!(word.target, Target::Name(name) if is_save(name)))
            && let FrameKind::Program { saved, .. } = &mut levels::program(&mut core.levels).kind
        {
            *saved = Some(Box::new(self.channel.st.save()));
        }
        if further_pass {
            return Ok(());
        }
        let count = block.variables.len();
        if let Some(more) = arguments.get(count) {
            let found = codes::S2021::program_takes_arguments(&count).at(more.loc);
            core.report(found.also(core.loc(block.span), Label::ItsParameters));
            for variable in &block.variables {
                self.vars.lose_parameter(*variable, core);
            }
            self.vars.parameters_are_known();
            return Err(Reported);
        }
        let mut arguments = arguments.into_iter();
        let mut result = Ok(());
        for variable in &block.variables {
            if self.parameter(*variable, arguments.next(), line).is_err() {
                self.vars.lose_parameter(*variable, &self.channel.core);
                result = Err(Reported);
            }
        }
        self.vars.parameters_are_known();
        result
    }

    fn parameter(&mut self, variable: Variable, argument: Option<Argument>, line: Line<'_>) -> Outcome {
        let core = &mut self.channel.core;
        let Some(name) = variable.name else {
            return core.refuse(variable.span, codes::S2021::parameter_of_proc_needs_name());
        };
        let left_out = argument.is_some();
        let given = argument.as_ref().filter(|a| a.reference.is_some() || a.value != Val::Missing);
        levels::program(&mut core.levels).given.push(given.is_some());
        if variable.by_reference {
            return self.vars.reference_parameter(name, variable, given, left_out, core);
        }
        let value = match (given, variable.value) {
            (Some(argument), _) => argument.passed_to(variable, core.symbols.name(name), core)?,
            (None, Some(formula)) => {
                let value = self.eval(formula, line)?;
                value.taken_as(variable.kind, ASSIGNED, &self.channel.core, formula.span)?
            }
            (None, None) if variable.kind == TypeName::Axis && !levels::in_main(&core.levels) => {
                return missing_argument(name, if left_out { 14010 } else { 12310 }, core);
            }
            (None, None) => Val::zero(variable.kind),
        };
        let length = match variable.length {
            Some(formula) => self.number(formula, line)? as usize,
            None => MOST_TEXT,
        };
        let core = &self.channel.core;
        if let (Val::Text(text), Some(argument)) = (&value, given)
            && text.len() > length
        {
            let (len, shown) = (text.len(), core.symbols.name(name));
            core.report(codes::S2030::text_has_characters_parameter_takes(&len, &shown, &length).at(argument.loc));
            return Err(Reported);
        }
        let defined = core.loc(variable.span);
        self.vars.define(name, Var::single(variable.kind, value, length, defined), false);
        Ok(())
    }
}

impl Vars {
    fn reference_parameter(
        &mut self,
        name: Symbol,
        variable: Variable,
        given: Option<&Argument>,
        left_out: bool,
        core: &mut Core<'_>,
    ) -> Outcome {
        let Some(argument) = given else {
            if !levels::in_main(&core.levels) {
                // An empty place between commas, or too few arguments.
                return missing_argument(name, if left_out { 14010 } else { 12300 }, core);
            }
            // Of the program that is compiled by itself nothing is known of its variable.
            self.lose_parameter(variable, core);
            // One of them says it for all.
            if !core.job.diags.first_time(codes::S2021, ()) {
                return Err(Reported);
            }
            let fault = codes::S2021::parameter_is_var_this_is_subprogram(&core.symbols.name(name));
            return core.refuse(variable.span, fault);
        };
        let shown = core.symbols.name(name);
        let Some(reference) = argument.reference else {
            core.report(codes::S2021::parameter_is_var_and_needs_variable(&shown).at(argument.loc));
            return Err(Reported);
        };
        let (kind, array) = match reference {
            Reference::R(_) => (TypeName::Real, false),
            Reference::Variable(slot) | Reference::Element(slot, _) => {
                let var = self.get(slot).ok_or(Reported)?;
                (var.kind, matches!(reference, Reference::Variable(_)) && !var.sizes.is_empty())
            }
        };
        let wants_array = variable.open || variable.sizes.count > 0;
        if kind != variable.kind || array != wants_array {
            let what = |kind, array| format!("{}{}", type_name(kind), if array { " array" } else { "" });
            let fault = codes::S2021::parameter_is_var(&shown, &what(variable.kind, wants_array), &what(kind, array));
            let alarm = if array == wants_array { 12330 } else { 12360 };
            core.report(fault.alarm(alarm).at(argument.loc));
            return Err(Reported);
        }
        if let Reference::Variable(slot @ Slot::Local(_)) = reference {
            self.bind(name, slot);
            return Ok(());
        }
        let var = match reference {
            Reference::Variable(slot) => self.get(slot).cloned(),
            _ => None,
        };
        let var = var.unwrap_or_else(|| Var::single(kind, argument.value.clone(), MOST_TEXT, argument.loc));
        self.define(name, var, false);
        if let FrameKind::Program { references, .. } = &mut levels::program(&mut core.levels).kind {
            references.push((name, reference));
        }
        Ok(())
    }
}

impl Argument {
    /// The value as the parameter takes it.
    fn passed_to(&self, variable: Variable, shown: &str, core: &Core<'_>) -> Outcome<Val> {
        let Ok(value) = self.value.converted(variable.kind) else {
            let (kind, what) = (type_name(variable.kind), self.value.what());
            core.report(codes::S2021::parameter_is_argument(&shown, &kind, &what).at(self.loc));
            return Err(Reported);
        };
        if variable.kind == TypeName::Int {
            says_negative_half(&self.value, &value, core, variable.span);
        }
        Ok(value)
    }
}

/// A parameter that needs an argument has none. Of the program that is compiled by itself nobody gives any.
fn missing_argument(name: Symbol, alarm: u32, core: &Core<'_>) -> Outcome {
    if levels::in_main(&core.levels) {
        return Ok(());
    }
    let found = codes::S2021::argument_for_parameter_is_missing(&core.symbols.name(name)).alarm(alarm);
    core.report(found.at(levels::call_site(&core.levels)));
    Err(Reported)
}
