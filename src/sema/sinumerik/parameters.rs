//! Arguments of calls and parameters of PROC.
//!
//! Source: S 5.6 (docs/sources.md).

use crate::diag::{Label, codes};
use crate::parser::sinumerik::ast::{Args, Base, Block, Formula, Op, TypeName, Variable};
use crate::parser::symbols::Symbol;
use crate::text::Span;

use super::calls::FrameKind;
use super::value::{MOST_TEXT, Val, type_name};
use super::vars::{Argument, Reference, Slot, Var};
use super::{Core, Outcome, Reported, Run};

impl Run<'_> {
    /// Evaluates the arguments of a call.
    pub(super) fn arguments(&mut self, args: Args, block: &Block, text: &[u8]) -> Outcome<Vec<Argument>> {
        let formulas: Vec<Formula> = block.arguments(args).to_vec();
        let mut list = Vec::with_capacity(formulas.len());
        for formula in formulas {
            let reference = self.reference(formula, block, text)?;
            let array = match reference {
                Some(Reference::Variable(slot)) => self.vars.get(slot).is_some_and(|var| !var.sizes.is_empty()),
                _ => false,
            };
            let value = if array { Val::Missing } else { self.eval(formula, block, text)? };
            list.push(Argument { value, reference, loc: self.channel.core.loc(formula.span) });
        }
        Ok(list)
    }

    /// The variable that a formula is, if it is nothing else.
    pub(super) fn reference(&mut self, formula: Formula, block: &Block, text: &[u8]) -> Outcome<Option<Reference>> {
        Ok(match block.formula(formula) {
            [Op::R(n, _)] => Some(Reference::R(*n)),
            [Op::Name(name, _)] => self.known_variable(*name).map(Reference::Variable),
            [indices @ .., Op::Index(base, count, span)] if indices.len() == *count as usize => {
                let mut values = Vec::with_capacity(indices.len());
                for op in indices {
                    let one = Block { ops: vec![*op], ..Block::default() };
                    let formula = Formula { from: 0, to: 1, span: *span };
                    values.push(self.eval(formula, &one, text)?);
                }
                match base {
                    Base::Letter(b'R') => Some(Reference::R(self.channel.core.r_index(&values, *span)?)),
                    Base::Name(name) => match self.known_variable(*name) {
                        Some(slot) => self.element(slot, &values, *span)?,
                        None => None,
                    },
                    Base::Letter(letter) => match self.letter_variable(*letter) {
                        Some(slot) => self.element(slot, &values, *span)?,
                        None => None,
                    },
                    Base::System(_) => None,
                }
            }
            _ => None,
        })
    }

    fn element(&self, slot: Slot, values: &[Val], span: Span) -> Outcome<Option<Reference>> {
        let indices = self.channel.core.indices(values, span)?;
        let offset = self.vars.get(slot).and_then(|var| var.offset(&indices));
        Ok(offset.map(|at| Reference::Element(slot, at)))
    }

    /// Sets a variable that is given by reference to a whole number.
    pub(super) fn set_reference(&mut self, reference: Reference, value: i32) {
        let (slot, at) = match reference {
            Reference::R(n) => {
                self.channel.core.job.trail.returns();
                return self.vars.set_r(n, f64::from(value));
            }
            Reference::Variable(slot) => (slot, 0),
            Reference::Element(slot, at) => (slot, at),
        };
        self.channel.core.job.trail.returns();
        let Some(var) = self.vars.get_mut(slot) else { return };
        let Ok(value) = Val::Int(value).converted(var.kind) else { return };
        if let Some(element) = var.values.get_mut(at) {
            *element = value;
            var.kept.knows(at);
            var.lost = false;
        }
    }

    pub(super) fn give_back(&mut self, references: &[(Symbol, Reference)]) {
        if !references.is_empty() {
            self.channel.core.job.trail.returns();
        }
        for (name, reference) in references {
            let Some(own) = self.vars.of_level(*name) else { continue };
            let Some(value) = own.values.first().cloned() else { continue };
            match *reference {
                Reference::R(n) => self.vars.set_r(n, value.number().unwrap_or(0.0)),
                Reference::Variable(slot) => {
                    let (values, kept) = (own.values.clone(), own.kept.clone());
                    if let Some(var) = self.vars.get_mut(slot) {
                        (var.values, var.kept) = (values, kept);
                    }
                }
                Reference::Element(slot, at) => {
                    if let Some(var) = self.vars.get_mut(slot)
                        && let Some(element) = var.values.get_mut(at)
                    {
                        *element = value;
                        var.kept.knows(at);
                    }
                }
            }
        }
    }

    /// PROC: the arguments of the call become variables.
    pub(super) fn proc_block(&mut self, block: &Block, text: &[u8]) -> Outcome {
        let level = self.channel.core.program_level();
        if level.executed {
            return self.channel.core.refuse(block.span, codes::S2015::proc_stands_behind_executed_blocks());
        }
        if std::mem::replace(&mut level.declares, true) {
            // Its parameters are defined all the same: what reads them is right.
            let _: Outcome = self.channel.core.refuse(block.span, codes::S2015::proc_stands_inside_definition_part());
        }
        let level = self.channel.core.program_level();
        let arguments = level.arguments.take().unwrap_or_default();
        let (in_main, further_pass) = (matches!(level.kind, FrameKind::Main), level.further_pass);
        let save = block.words.iter().any(|word| match word.target {
            crate::parser::sinumerik::ast::Target::Name(name) => self.channel.core.symbols.name(name) == "SAVE",
            _ => false,
        });
        self.check_extern(block);
        if save {
            let state = self.channel.st.save();
            if let FrameKind::Program { saved, .. } = &mut self.channel.core.program_level().kind {
                *saved = Some(Box::new(state));
            }
        }
        if further_pass {
            return Ok(());
        }
        if arguments.len() > block.variables.len() {
            let loc = arguments[block.variables.len()].loc;
            let count = block.variables.len();
            let found = codes::S2021::program_takes_arguments(&count).at(loc);
            self.channel.core.report(found.also(self.channel.core.loc(block.span), Label::ItsParameters));
            for variable in block.variables.clone() {
                self.lose_parameter(variable);
            }
            self.vars.parameters_are_known();
            return Err(Reported);
        }
        let mut arguments = arguments.into_iter();
        let mut result = Ok(());
        for variable in block.variables.clone() {
            let argument = arguments.next();
            if self.parameter(variable, argument, in_main, block, text).is_err() {
                self.lose_parameter(variable);
                result = Err(Reported);
            }
        }
        self.vars.parameters_are_known();
        result
    }

    pub(super) fn parameter(
        &mut self,
        variable: Variable,
        argument: Option<Argument>,
        in_main: bool,
        block: &Block,
        text: &[u8],
    ) -> Outcome {
        let Some(name) = variable.name else {
            return self.channel.core.refuse(variable.span, codes::S2021::parameter_of_proc_needs_name());
        };
        let left_out = argument.is_some();
        let given = argument.as_ref().filter(|a| a.reference.is_some() || a.value != Val::Missing);
        self.channel.core.program_level().given.push(given.is_some());
        if variable.by_reference {
            return self.reference_parameter(name, variable, given, left_out, in_main);
        }
        let shown = self.channel.core.symbols.name(name).to_owned();
        let value = match (given, variable.value) {
            (Some(argument), _) => self.channel.core.passed_value(argument, variable, &shown)?,
            (None, Some(formula)) => {
                let value = self.eval(formula, block, text)?;
                self.channel.core.converted(&value, variable.kind, formula.span)?
            }
            (None, None) if variable.kind == TypeName::Axis && !in_main => {
                return self.channel.core.missing_argument(&shown, if left_out { 14010 } else { 12310 });
            }
            (None, None) => Val::zero(variable.kind),
        };
        let length = match variable.length {
            Some(formula) => self.number(formula, block, text)? as usize,
            None => MOST_TEXT,
        };
        if let (Val::Text(text), Some(argument)) = (&value, given)
            && text.len() > length
        {
            self.channel.core.report(
                codes::S2030::text_has_characters_parameter_takes(&text.len(), &shown, &length).at(argument.loc),
            );
            return Err(Reported);
        }
        let defined = self.channel.core.loc(variable.span);
        self.vars.define(name, Var::single(variable.kind, value, length, defined), false);
        Ok(())
    }

    /// A parameter whose argument was refused: what reads it is not reported again.
    pub(super) fn lose_parameter(&mut self, variable: Variable) {
        let Some(name) = variable.name else { return };
        let defined = self.channel.core.loc(variable.span);
        let var = Var::single(variable.kind, Val::zero(variable.kind), MOST_TEXT, defined);
        self.vars.define(name, Var { lost: true, ..var }, false);
    }

    pub(super) fn reference_parameter(
        &mut self,
        name: Symbol,
        variable: Variable,
        given: Option<&Argument>,
        left_out: bool,
        in_main: bool,
    ) -> Outcome {
        let shown = self.channel.core.symbols.name(name).to_owned();
        let Some(argument) = given else {
            if in_main {
                return self.reference_of_main(variable, &shown);
            }
            // An empty place between commas, or too few arguments.
            return self.channel.core.missing_argument(&shown, if left_out { 14010 } else { 12300 });
        };
        let Some(reference) = argument.reference else {
            self.channel.core.report(codes::S2021::parameter_is_var_and_needs_variable(&shown).at(argument.loc));
            return Err(Reported);
        };
        let (kind, array) = match reference {
            Reference::R(_) => (TypeName::Real, false),
            Reference::Variable(slot) | Reference::Element(slot, _) => {
                let Some(var) = self.vars.get(slot) else { return Err(Reported) };
                (var.kind, matches!(reference, Reference::Variable(_)) && !var.sizes.is_empty())
            }
        };
        let wants_array = variable.open || variable.sizes.count > 0;
        if kind != variable.kind || array != wants_array {
            let what = |kind, array| format!("{}{}", type_name(kind), if array { " array" } else { "" });
            let alarm = if array == wants_array { 12330 } else { 12360 };
            self.channel.core.report(
                codes::S2021::parameter_is_var(&shown, &what(variable.kind, wants_array), &what(kind, array))
                    .alarm(alarm)
                    .at(argument.loc),
            );
            return Err(Reported);
        }
        if let Reference::Variable(slot @ Slot::Local(_)) = reference {
            self.vars.bind(name, slot);
            return Ok(());
        }
        let var = match reference {
            Reference::Variable(slot) => self.vars.get(slot).cloned(),
            _ => None,
        };
        let var = var.unwrap_or_else(|| Var::single(kind, argument.value.clone(), MOST_TEXT, argument.loc));
        self.vars.define(name, var, false);
        if let FrameKind::Program { references, .. } = &mut self.channel.core.program_level().kind {
            references.push((name, reference));
        }
        Ok(())
    }

    /// A VAR parameter of the program that is compiled by itself: nothing is known of its variable.
    fn reference_of_main(&mut self, variable: Variable, shown: &str) -> Outcome {
        self.lose_parameter(variable);
        // One of them says it for all.
        if !self.channel.core.job.diags.first_time(codes::S2021, ()) {
            return Err(Reported);
        }
        self.channel.core.refuse(variable.span, codes::S2021::parameter_is_var_this_is_subprogram(&shown))
    }
}

impl Core<'_> {
    /// The value of an argument, as the parameter takes it.
    fn passed_value(&self, argument: &Argument, variable: Variable, shown: &str) -> Outcome<Val> {
        let Ok(value) = argument.value.converted(variable.kind) else {
            let (kind, what) = (type_name(variable.kind), argument.value.what());
            self.report(codes::S2021::parameter_is_argument(&shown, &kind, &what).at(argument.loc));
            return Err(Reported);
        };
        if variable.kind == TypeName::Int
            && let (Some(from), Some(made)) = (argument.value.number(), value.number())
        {
            self.says_negative_half(from, made, variable.span);
        }
        Ok(value)
    }

    pub(super) fn missing_argument(&mut self, name: &str, alarm: u32) -> Outcome {
        if !matches!(self.program_level().kind, FrameKind::Program { .. }) {
            return Ok(());
        }
        let site = self.call_site();
        self.report(codes::S2021::argument_for_parameter_is_missing(&name).alarm(alarm).at(site));
        Err(Reported)
    }

    /// A call waits for a PROC that does not come.
    pub(super) fn refuse_arguments(&mut self) {
        if let Some(argument) = self.program_level().arguments.take().and_then(|list| list.into_iter().next()) {
            let found = codes::S2021::arguments_are_given().at(argument.loc);
            self.report(found.help("write `PROC NAME(…)` as the first block of the called program"));
        }
    }
}
