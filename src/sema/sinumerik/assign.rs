//! Assignments to variables, arrays and system variables; SET and REP.
//!
//! Source: S 5.1 and 5.6 (docs/sources.md).

use std::rc::Rc;

use crate::diag::codes;
use crate::parser::sinumerik::ast::{Base, Block, Formula, Op, Target, TypeName, Value, Word};
use crate::parser::symbols::Symbol;
use crate::text::Span;

use super::frames::Component;
use super::value::{NoValue, Val, type_name, whole};
use super::vars::{MOST_R, Slot, Var};
use super::vocabulary::Meaning;
use super::{Channel, Core, Outcome, Reported, Run};

impl Run<'_> {
    /// `target = formula`
    pub(super) fn assign_word(&mut self, word: &Word, block: &Block, text: &[u8]) -> Outcome {
        let result = self.assign(word, block, text);
        if result.is_err() {
            self.lose_target(word.target);
        }
        result
    }

    /// What could not be computed is not reported again by those that read it.
    fn lose_target(&mut self, target: Target) {
        match target {
            Target::Numbered(b'R', n, _) => self.vars.lose_r(n),
            Target::Numbered(_, _, name) | Target::Name(name) | Target::Indexed(Base::Name(name), _) => {
                if let Some(slot) = self.vars.find(name)
                    && let Some(var) = self.vars.get_mut(slot)
                {
                    var.lost = true;
                }
            }
            _ => {}
        }
    }

    fn assign(&mut self, word: &Word, block: &Block, text: &[u8]) -> Outcome {
        let Value::Formula(formula) = word.value else {
            return self.channel.core.refuse(word.span, codes::P1001::value_are_missing());
        };
        if let Target::Numbered(b'R', n, _) = word.target {
            let value = self.number(formula, block, text)?;
            return self.set_r(n, value, word.span);
        }
        // `A[0,1]=SET(7,8)` fills from an element on.
        if let Some(values) = self.list_of(formula, block, text)? {
            return self.fill_target(word.target, &values, formula.span, block, text);
        }
        let value = self.eval(formula, block, text)?;
        self.write_target(word.target, value, word.span, block, text)
    }

    fn set_r(&mut self, n: u32, value: f64, span: Span) -> Outcome {
        if n > MOST_R {
            return self.channel.core.refuse(span, codes::S2018::there_is_no_parameter_r(&n));
        }
        let origin = self.channel.core.here.origin;
        self.channel.core.job.trail.assigns(origin.loc, origin.call, || format!("R{n}"), value);
        self.vars.set_r(n, value);
        Ok(())
    }

    fn variable_slot(&self, name: crate::parser::symbols::Symbol, span: Span) -> Outcome<Slot> {
        match self.vars.find(name) {
            Some(slot) => Ok(slot),
            None => self.undefined(name, span),
        }
    }

    /// Reads a target, for counting loops.
    pub(super) fn read_target(&mut self, target: Target, block: &Block, text: &[u8]) -> Outcome<Val> {
        match target {
            Target::Numbered(b'R', n, _) => self.r_value(n, block.span),
            Target::Numbered(_, _, name) | Target::Name(name) => match self.vars.find(name) {
                Some(slot) => self.variable_value(slot, &[], block.span),
                None => self.undefined(name, block.span),
            },
            Target::Indexed(base, args) => {
                let mut values = Vec::new();
                for formula in block.arguments(args).to_vec() {
                    values.push(self.eval(formula, block, text)?);
                }
                match base {
                    Base::Letter(b'R') => {
                        let n = self.channel.core.r_index(&values, block.span)?;
                        self.r_value(n, block.span)
                    }
                    Base::Name(name) => match self.vars.find(name) {
                        Some(slot) => {
                            let indices = self.channel.core.indices(&values, block.span)?;
                            self.variable_value(slot, &indices, block.span)
                        }
                        None => self.undefined(name, block.span),
                    },
                    _ => self.channel.core.refuse(block.span, codes::P1001::this_cannot_count_loop()),
                }
            }
            Target::Letter(letter) => match self.letter_variable(letter) {
                Some(slot) => self.variable_value(slot, &[], block.span),
                None => self.channel.core.refuse(block.span, codes::P1001::address_cannot_count_loop()),
            },
            Target::System(_) => self.channel.core.refuse(block.span, codes::P1001::this_cannot_count_loop()),
        }
    }

    pub(super) fn write_target(
        &mut self,
        target: Target,
        value: Val,
        span: Span,
        block: &Block,
        text: &[u8],
    ) -> Outcome {
        match target {
            Target::Numbered(b'R', n, _) => {
                let value = self.channel.core.as_number(&value, span)?;
                self.set_r(n, value, span)
            }
            Target::Numbered(_, _, name) | Target::Name(name) => {
                let Some(slot) = self.vars.find(name) else { return self.undefined(name, span) };
                if let Some(number) = value.number() {
                    let origin = self.channel.core.here.origin;
                    self.channel.core.job.trail.assigns(
                        origin.loc,
                        origin.call,
                        || self.channel.core.symbols.name(name).to_owned(),
                        number,
                    );
                }
                self.write_element(slot, &[], value, span)
            }
            Target::System(name) => self.channel.write_system(name, &[], value, span),
            Target::Indexed(base, args) => {
                let mut indices = Vec::new();
                for formula in block.arguments(args).to_vec() {
                    indices.push(self.eval(formula, block, text)?);
                }
                match base {
                    Base::Letter(b'R') => {
                        let n = self.channel.core.r_index(&indices, span)?;
                        let value = self.channel.core.as_number(&value, span)?;
                        self.set_r(n, value, span)
                    }
                    Base::System(name) => self.channel.write_system(name, &indices, value, span),
                    Base::Name(name) => {
                        let Some(slot) = self.vars.find(name) else { return self.undefined(name, span) };
                        self.write_indexed(slot, &indices, value, span)
                    }
                    Base::Letter(letter) => match self.letter_variable(letter) {
                        Some(slot) => self.write_indexed(slot, &indices, value, span),
                        None => self.channel.core.refuse(span, codes::P1001::this_takes_no_value()),
                    },
                }
            }
            Target::Letter(letter) => match self.letter_variable(letter) {
                Some(slot) => self.write_element(slot, &[], value, span),
                None => self.channel.core.refuse(span, codes::P1001::this_takes_no_value()),
            },
        }
    }

    fn write_indexed(&mut self, slot: Slot, indices: &[Val], value: Val, span: Span) -> Outcome {
        if let Some(Val::Frame(frame)) = self.vars.get(slot).and_then(|var| var.values.first()).cloned() {
            let mut changed = (*frame).clone();
            self.channel.set_frame_component(&mut changed, indices, &value, span)?;
            return self.write_element(slot, &[], Val::Frame(Rc::new(changed)), span);
        }
        let indices = self.channel.core.indices(indices, span)?;
        // One character of a text.
        if let Some(var) = self.vars.get(slot)
            && let ([at], [], Some(Val::Text(old))) = (indices.as_slice(), var.sizes.as_slice(), var.values.first())
        {
            let character = self.channel.core.converted(&value, TypeName::Char, span)?;
            let mut bytes = old.to_vec();
            let place = usize::try_from(*at).ok().and_then(|at| bytes.get_mut(at));
            let (Some(place), Val::Char(c)) = (place, character) else {
                return self.channel.core.refuse(span, codes::S2018::text_has_no_character(&at));
            };
            *place = c;
            return self.write_element(slot, &[], Val::text(&bytes), span);
        }
        self.write_element(slot, &indices, value, span)
    }

    fn write_element(&mut self, slot: Slot, indices: &[i32], value: Val, span: Span) -> Outcome {
        let Some(var) = self.vars.get(slot) else { return Err(Reported) };
        let (kind, length, limits) = (var.kind, var.length, var.limits);
        let Some(at) = var.offset(indices) else {
            let fault = if var.sizes.is_empty() {
                codes::S2018::variable_is_no_array()
            } else {
                codes::S2018::there_is_no_element(&format_args!("{:?}", var.sizes), &format_args!("{indices:?}"))
            };
            return self.channel.core.refuse(span, fault);
        };
        let value = self.channel.core.converted(&value, kind, span)?;
        self.channel.core.check_length(&value, length, span)?;
        self.channel.core.check_limits(&value, limits, [17080, 17090], span)?;
        if let Some(var) = self.vars.get_mut(slot)
            && let Some(element) = var.values.get_mut(at)
        {
            *element = value;
            var.lost = false;
            var.kept.knows(at);
        }
        Ok(())
    }

    // Lists of values.

    /// The values of `SET(…)`, `(…)` or `REP(…)`; `None` for anything else.
    pub(super) fn list_of(&mut self, formula: Formula, block: &Block, text: &[u8]) -> Outcome<Option<Fill>> {
        match block.formula(formula) {
            [inner @ .., Op::List(_)] => {
                let inner = formula_part(formula, inner.len());
                self.list_values(inner, block, text).map(|list| Some(Fill::Set(list)))
            }
            [inner @ .., Op::Call(name, _, _)] => {
                let word = self.channel.core.symbols.name(*name);
                if word != "SET" && word != "REP" {
                    return Ok(None);
                }
                let set = word == "SET";
                let inner = formula_part(formula, inner.len());
                let list = self.list_values(inner, block, text)?;
                if set {
                    return Ok(Some(Fill::Set(list)));
                }
                let count = match list.get(1) {
                    None => None,
                    Some(value) => {
                        let n = value.number().and_then(whole).and_then(|n| usize::try_from(n).ok());
                        match n {
                            Some(n) => Some(n),
                            None => {
                                return self
                                    .channel
                                    .core
                                    .refuse(formula.span, codes::S2017::rep_counts_elements_by_whole_number());
                            }
                        }
                    }
                };
                match list.into_iter().next() {
                    Some(value) => Ok(Some(Fill::Repeat(value, count))),
                    None => self.channel.core.refuse(formula.span, codes::S2017::rep_needs_value()),
                }
            }
            _ => Ok(None),
        }
    }

    /// Values that stand one behind the other: what is left on the stack.
    fn list_values(&mut self, formula: Formula, block: &Block, text: &[u8]) -> Outcome<Vec<Val>> {
        let ops = block.formula(formula);
        let count = depth(ops);
        let mut wrapped = Block { ops: ops.to_vec(), ..Block::default() };
        wrapped.ops.push(Op::List(count));
        let whole = Formula { from: 0, to: wrapped.ops.len() as u32, span: formula.span };
        match self.eval(whole, &wrapped, text)? {
            Val::List(list) => Ok(list.to_vec()),
            _ => Err(Reported),
        }
    }

    fn fill_target(&mut self, target: Target, fill: &Fill, span: Span, block: &Block, text: &[u8]) -> Outcome {
        let (slot, args) = match target {
            Target::Name(name) | Target::Numbered(_, _, name) => (self.variable_slot(name, span)?, None),
            Target::Indexed(Base::Name(name), args) => (self.variable_slot(name, span)?, Some(args)),
            Target::Indexed(Base::Letter(letter), args) if self.letter_variable(letter).is_some() => {
                (self.letter_variable(letter).ok_or(Reported)?, Some(args))
            }
            Target::Letter(letter) if self.letter_variable(letter).is_some() => {
                (self.letter_variable(letter).ok_or(Reported)?, None)
            }
            _ => return self.channel.core.refuse(span, codes::P2024::list_of_values_fills_array()),
        };
        let mut values = Vec::new();
        for formula in args.map(|args| block.arguments(args).to_vec()).unwrap_or_default() {
            values.push(self.eval(formula, block, text)?);
        }
        let indices = self.channel.core.indices(&values, span)?;
        let Some(var) = self.vars.get(slot).cloned() else { return Err(Reported) };
        let start = if indices.is_empty() { Some(0) } else { var.offset(&indices) };
        let Some(start) = start.filter(|_| !var.sizes.is_empty()) else {
            return self.channel.core.refuse(span, codes::S2018::array_has_no_such_element());
        };
        self.channel.core.budget.take(var.values.len() as u64 / 16);
        let filled = self.channel.core.filled(&var, start, fill, span)?;
        if let Some(var) = self.vars.get_mut(slot) {
            *var = filled;
        }
        Ok(())
    }

    pub(super) fn meaning(&mut self, name: Symbol) -> Meaning {
        let at = name.0 as usize;
        if let Some(Some(known)) = self.meanings.get(at) {
            return *known;
        }
        let word = self.channel.core.symbols.name(name);
        let meaning = match self.channel.axis_names.find(word) {
            Some(axis) => Meaning::Axis(axis),
            None => self.vocabulary.get(word).copied().unwrap_or(Meaning::Unknown),
        };
        if self.meanings.len() <= at {
            self.meanings.resize(at + 1, None);
        }
        self.meanings[at] = Some(meaning);
        meaning
    }
}

impl Channel<'_> {
    pub(super) fn frame_component(&self, frame: &super::frames::FrameValue, args: &[Val], span: Span) -> Outcome<Val> {
        let (axis, component) = self.core.frame_place(args, span)?;
        let Some(axis) = axis else {
            return self.core.refuse(span, codes::P2023::frame_of_axis_that_is_left_out());
        };
        match frame.component(axis, component) {
            Some(value) => Ok(Val::Real(value / self.st.component_unit(axis, component))),
            None => self.core.refuse(span, codes::S2034::this_chain_of_rotations()),
        }
    }

    pub(super) fn set_frame_component(
        &self,
        frame: &mut super::frames::FrameValue,
        args: &[Val],
        value: &Val,
        span: Span,
    ) -> Outcome {
        let (axis, component) = self.core.frame_place(args, span)?;
        let value = self.core.as_number(value, span)?;
        // The frame of an axis that is left out moves nothing.
        let Some(axis) = axis else { return Ok(()) };
        let value = value * self.st.component_unit(axis, component);
        if frame.set_component(axis, component, value) {
            return Ok(());
        }
        self.core.refuse(span, codes::S2034::this_component_cannot_be_set())
    }
}

impl Core<'_> {
    /// LLI and ULI; the alarms are those below and above.
    pub(super) fn check_limits(&self, value: &Val, limits: [Option<f64>; 2], alarms: [u32; 2], span: Span) -> Outcome {
        let Some(number) = value.number() else { return Ok(()) };
        match limits {
            [Some(least), _] if number < least => {
                self.refuse(span, codes::S2029::is_below_limit_lli(&number, &least).alarm(alarms[0]))
            }
            [_, Some(most)] if number > most => {
                self.refuse(span, codes::S2029::is_above_limit_uli(&number, &most).alarm(alarms[1]))
            }
            _ => Ok(()),
        }
    }

    pub(super) fn check_length(&self, value: &Val, length: usize, span: Span) -> Outcome {
        match value {
            Val::Text(text) if text.len() > length => {
                self.refuse(span, codes::S2030::text_has_characters(&text.len(), &length))
            }
            _ => Ok(()),
        }
    }

    /// A value as one of another type.
    pub(super) fn converted(&self, value: &Val, kind: TypeName, span: Span) -> Outcome<Val> {
        self.converted_or(value, kind, span, [12150, 12560])
    }

    /// The same with the alarms for a wrong type and a value out of range.
    pub(super) fn converted_or(&self, value: &Val, kind: TypeName, span: Span, alarms: [u32; 2]) -> Outcome<Val> {
        match value.converted(kind) {
            Ok(made) => {
                if kind == TypeName::Int
                    && let (Some(value), Some(made)) = (value.number(), made.number())
                {
                    self.says_negative_half(value, made, span);
                }
                Ok(made)
            }
            Err(NoValue::Type) => {
                self.refuse(span, codes::P2024::does_not_become(&value.what(), &type_name(kind)).alarm(alarms[0]))
            }
            Err(NoValue::Range) => {
                self.refuse(span, codes::S2029::value_lies_outside_what_holds(&type_name(kind)).alarm(alarms[1]))
            }
        }
    }

    pub(super) fn filled(&self, var: &Var, start: usize, fill: &Fill, span: Span) -> Outcome<Var> {
        let mut made = var.clone();
        let room = made.values.len() - start.min(made.values.len());
        match fill {
            Fill::Set(list) => {
                if list.len() > room {
                    return self.refuse(span, codes::S2017::values_for_elements(&list.len(), &room));
                }
                for (at, value) in list.iter().enumerate().filter(|(_, value)| **value != Val::Missing) {
                    made.values[start + at] = self.converted(value, made.kind, span)?;
                    made.kept.knows(start + at);
                }
            }
            Fill::Repeat(value, count) => {
                let value = self.converted(value, made.kind, span)?;
                let count = count.unwrap_or(room);
                if count > room {
                    return self.refuse(span, codes::S2017::values_for_elements(&count, &room));
                }
                for (at, element) in made.values.iter_mut().enumerate().skip(start).take(count) {
                    *element = value.clone();
                    made.kept.knows(at);
                }
            }
        }
        Ok(made)
    }

    /// A component of a frame: `[X,TR]`.
    pub(super) fn frame_place(&self, args: &[Val], span: Span) -> Outcome<(Option<crate::machine::Axis>, Component)> {
        let component = match args {
            [Val::Axis(axis), Val::Text(name)] => {
                std::str::from_utf8(name).ok().and_then(Component::of).map(|component| (axis.axis, component))
            }
            _ => None,
        };
        match component {
            Some(found) => Ok(found),
            None => self.refuse(span, codes::S2031::component_of_frame_is_axis()),
        }
    }
}

/// What fills an array.
pub(super) enum Fill {
    Set(Vec<Val>),
    Repeat(Val, Option<usize>),
}

fn formula_part(formula: Formula, len: usize) -> Formula {
    Formula { from: formula.from, to: formula.from + len as u32, span: formula.span }
}

/// How many values postfix operations leave.
fn depth(ops: &[Op]) -> u32 {
    let mut depth = 0u32;
    for op in ops {
        let used = match op {
            Op::Index(_, n, _) | Op::Call(_, n, _) | Op::List(n) => *n,
            Op::Unary(_) | Op::ToText => 1,
            Op::Binary(_) | Op::Join | Op::Chain => 2,
            _ => 0,
        };
        depth = (depth + 1).saturating_sub(used);
    }
    depth
}
