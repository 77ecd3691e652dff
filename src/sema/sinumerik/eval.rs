//! Computes formulas: postfix operations over a stack of values, and lists of them.
//!
//! Source: S 5.2 (docs/sources.md). Comparisons bind weakest; REAL values are equal within 1e-12 of their size.

use std::borrow::Cow;
use std::rc::Rc;

use crate::diag::{Answer, codes};
use crate::lexer::formula::Function;
use crate::parser::sinumerik::ast::{Base, Block, Formula, Op};
use crate::parser::symbols::Symbol;
use crate::sema::value::{At, Divisor, Fault, Formulas, SetBy, Stop, evaluate};
use crate::text::Span;
use crate::text::decode::readable;

use super::axis_names::NamedAxis;
use super::conversions::{Fill, says_negative_half};
use super::formula_functions::{self, FormulaFunction};
use super::frame_functions::frame_function;
use super::frames::FrameValue;
use super::line::Line;
use super::measuring_data;
use super::system::system_key;
use super::system_meanings::{meaning_of, said_meaning};
use super::tool_questions::named_tool;
use super::value::{Val, r_index, to_text, whole};
use super::vars::Slot;
use super::vocabulary::Meaning;
use super::{Outcome, Reported, Run};

/// Longest text that a formula makes.
const MOST_JOINED: usize = 800;

/// A text in quotes with its constants as bytes (`'H41'`, `'B1000001'`); where one is too large, its place and the fault.
fn resolved_text(text: &[u8]) -> Result<Cow<'_, [u8]>, (usize, crate::diag::Fault)> {
    if !text.contains(&b'\'') {
        return Ok(Cow::Borrowed(text));
    }
    let mut made = Vec::with_capacity(text.len());
    let mut at = 0;
    while let Some(&byte) = text.get(at) {
        match byte_constant(&text[at..]) {
            Some((Some(value), len)) => {
                made.push(value);
                at += len;
            }
            Some((None, _)) => {
                let binary = text.get(at + 1).is_some_and(|b| b.eq_ignore_ascii_case(&b'B'));
                let (what, alarm) = if binary { ("binary", 12220) } else { ("hexadecimal", 12230) };
                return Err((at, codes::S2030::constant_in_text_is_larger_than_one(&what).alarm(alarm)));
            }
            None => {
                made.push(byte);
                at += 1;
            }
        }
    }
    Ok(Cow::Owned(made))
}

/// `'H41'` or `'B1000001'` at the start of `text`: its byte, `None` for one that is too large, and its length.
fn byte_constant(text: &[u8]) -> Option<(Option<u8>, usize)> {
    let [b'\'', kind, rest @ ..] = text else { return None };
    let radix = match kind.to_ascii_uppercase() {
        b'H' => 16,
        b'B' => 2,
        _ => return None,
    };
    let len = rest.iter().take_while(|b| char::from(**b).is_digit(radix)).count();
    if len == 0 || rest.get(len) != Some(&b'\'') {
        return None;
    }
    let value = rest[..len].iter().try_fold(0u8, |value, b| {
        let digit = char::from(*b).to_digit(radix)?;
        value.checked_mul(radix as u8)?.checked_add(digit as u8)
    });
    Some((value, len + 3))
}

pub(super) type Machine = crate::sema::value::Machine<NamedAxis, Rc<FrameValue>>;

impl Formulas for Run<'_> {
    type Op = Op;
    type Axis = NamedAxis;
    type Frame = Rc<FrameValue>;

    fn machine(&mut self) -> &mut Machine {
        &mut self.machine
    }

    fn operation(&mut self, op: &Op, machine: &mut Machine, at: At<'_>) -> Result<Val, Stop> {
        Ok(match *op {
            Op::Real(v) if v.is_finite() => Val::Real(v),
            Op::Real(_) => return Ok(self.channel.core.refuse(at.span, codes::S2029::number_is_too_large())?),
            Op::Int(n) => int_or_real(n),
            Op::Bool(b) => Val::Bool(b),
            Op::Char(c) => Val::Char(c),
            Op::Text(span) => match resolved_text(span.of(at.text)) {
                Ok(bytes) => Val::text(&bytes),
                Err((from, fault)) => {
                    let constant = Span::at(span.start + from as u32, 1);
                    return Ok(self.channel.core.refuse(constant, fault)?);
                }
            },
            Op::Missing => Val::Missing,
            Op::Name(name, span) => self.name_value(name, span)?,
            Op::R(n, span) => self.vars.r_value(n, &self.channel, span)?,
            Op::System(name, span) => self.channel.system_value(name, &[], span)?,
            Op::Index(base, count, span) => {
                let value = self.indexed_value(base, machine.last(count), span)?;
                machine.discard(count);
                value
            }
            Op::Call(name, count, span) => {
                let value = self.function_value(name, machine.last(count), span)?;
                machine.discard(count);
                value
            }
            Op::List(count) => {
                let list = Val::List(machine.last(count).into());
                machine.discard(count);
                list
            }
            Op::Unary(f) => machine.unary(f)?,
            Op::Binary(f) => machine.binary(f)?,
            Op::ToText => {
                let value = machine.pop()?;
                Val::Text(to_text(&value).ok_or(Fault::Misfit(value.what()))?.into())
            }
            Op::Join => joined(machine)?,
            Op::Chain => match (machine.pop()?, machine.pop()?) {
                (Val::Frame(b), Val::Frame(a)) => Val::Frame(Rc::new(a.chain(&b))),
                (b, a) => return Err(Fault::Mismatch(a.what(), b.what()).into()),
            },
        })
    }

    fn divisor(&self, operand: &[Op], at: At<'_>) -> Option<Divisor> {
        let last = match operand {
            [.., last, Op::Unary(Function::Negate)] | [.., last] => last,
            [] => return None,
        };
        let core = &self.channel.core;
        // As the block has it; one that was read as it stands in its file has its text there.
        let written = |span: Span| {
            let loc = core.loc(span);
            let written = match span.of(at.text) {
                [] if !core.here.rewritten => core.job.sources.bytes(loc.file, loc.span),
                text => text.to_vec(),
            };
            readable(&written).trim().to_uppercase()
        };
        Some(match *last {
            Op::R(n, _) => {
                let never = self.vars.r(n).is_some_and(|(_, set)| !set);
                let (name, nobody) = (format!("R{n}"), if never { SetBy::Nobody } else { SetBy::Unknown });
                let set = if never { None } else { SetBy::of(&core.job, &name, None) };
                Divisor { set: set.unwrap_or(nobody), name }
            }
            Op::Name(name, span) => Divisor { name: written(span), set: self.vars.set_to_zero(name, core) },
            Op::System(_, span) | Op::Index(_, _, span) => Divisor { name: written(span), set: SetBy::Unknown },
            _ => return None,
        })
    }

    fn fault(&self, fault: Fault, at: At<'_>) -> Reported {
        let core = &self.channel.core;
        let unset = &self.vars.said.unset;
        let found = match fault {
            Fault::Misfit(what) => codes::P2024::operator_does_not_fit(&what),
            Fault::Mismatch(a, b) => codes::P2024::values_do_not_go_together(&a, &b),
            Fault::Missing => codes::P2024::value_is_missing(),
            Fault::Said(found) => found,
            Fault::Zero(_) => or_give_values(codes::P2022::division_by_zero(), unset),
            // The divisor is a variable alone: it is named, and where it got its value.
            Fault::ZeroBy(_, by) => {
                let said = by.said(&core.job, core.here.origin.loc);
                or_give_values(codes::P2022::division_by_zero_that(&said), unset)
            }
            Fault::TooLargeInt => codes::P2022::result_is_too_large_for_int(),
            Fault::TooLarge | Fault::Domain(..) | Fault::Open(..) | Fault::Outside(..) | Fault::OpenBetween(..) => {
                codes::P2022::result_is_too_large().alarm(14051)
            }
        };
        core.say(at.span, found);
        Reported
    }
}

/// The control may keep other values in the variables that the formula has read and nothing has set.
fn or_give_values(fault: crate::diag::Fault, unset: &[String]) -> crate::diag::Fault {
    let [first, rest @ ..] = unset else { return fault };
    let help = Answer::key("variables", first).help(codes::P2022::give_values_that_control_keeps());
    fault.help(rest.iter().fold(help, |help, name| help.and(Answer::key("variables", name))))
}

impl Run<'_> {
    /// The value of a formula.
    pub(super) fn eval(&mut self, formula: Formula, line: Line<'_>) -> Outcome<Val> {
        let ops = line.ops(formula);
        match ops {
            [Op::Int(n)] => return Ok(int_or_real(*n)),
            [Op::Real(v)] if v.is_finite() => return Ok(Val::Real(*v)),
            [] => return Ok(Val::Missing),
            _ => {}
        }
        self.vars.said.unset.clear();
        evaluate(self, ops, At { span: formula.span, text: line.text })
    }

    /// The values of formulas, in their order.
    pub(super) fn values(&mut self, formulas: &[Formula], line: Line<'_>) -> Outcome<Vec<Val>> {
        formulas.iter().map(|formula| self.eval(*formula, line)).collect()
    }

    /// The value of a formula as a number.
    pub(super) fn number(&mut self, formula: Formula, line: Line<'_>) -> Outcome<f64> {
        let value = self.eval(formula, line)?;
        self.channel.core.accept(formula.span, value.as_number())
    }

    /// The same as a whole number; `fault` is what any other is.
    pub(super) fn whole_number(
        &mut self,
        formula: Formula,
        line: Line<'_>,
        fault: impl FnOnce() -> crate::diag::Fault,
    ) -> Outcome<i32> {
        let value = self.number(formula, line)?;
        self.channel.core.accept(formula.span, whole(value).ok_or_else(fault))
    }

    /// The values of `SET(…)`, `(…)` or `REP(…)`; `None` for anything else.
    pub(super) fn list_of(&mut self, formula: Formula, line: Line<'_>) -> Outcome<Option<Fill>> {
        let (inner, repeats) = match line.ops(formula) {
            [inner @ .., Op::List(_)] => (inner, false),
            [inner @ .., Op::Call(name, _, _)] => match self.channel.core.symbols.name(*name) {
                "SET" => (inner, false),
                "REP" => (inner, true),
                _ => return Ok(None),
            },
            _ => return Ok(None),
        };
        // Values that stand one behind the other: what is left on the stack.
        let mut wrapped = Block { ops: inner.to_vec(), ..Block::default() };
        wrapped.ops.push(Op::List(depth(inner)));
        let all = Formula { from: 0, to: wrapped.ops.len() as u32, span: formula.span };
        let Val::List(list) = self.eval(all, Line { block: &wrapped, text: line.text })? else { return Err(Reported) };
        if !repeats {
            return Ok(Some(Fill::Set(list.to_vec())));
        }
        let count = list.get(1).map(|value| value.number().and_then(whole).and_then(|n| usize::try_from(n).ok()));
        match (list.first(), count) {
            (_, Some(None)) => {
                let fault = codes::S2017::rep_counts_elements_by_whole_number();
                self.channel.core.refuse(formula.span, fault)
            }
            (Some(value), count) => Ok(Some(Fill::Repeat(value.clone(), count.flatten()))),
            (None, _) => self.channel.core.refuse(formula.span, codes::S2017::rep_needs_value()),
        }
    }

    fn name_value(&mut self, name: Symbol, span: Span) -> Outcome<Val> {
        if let Some(value) = self.found_by_cycle(name, &[], span)? {
            return Ok(value);
        }
        if let Some(slot) = self.known_variable(name) {
            return self.vars.value(slot, &[], &self.channel, span);
        }
        let word = self.channel.core.symbols.name(name);
        if let Some(named) = self.channel.axis_names.find(word) {
            self.channel.axis_names.printed(&self.channel.core, named, span)?;
            return Ok(Val::Axis(named));
        }
        if let Some(value) = constant(word) {
            return Ok(value);
        }
        // Names of machine axes (MD 10000), which index machine data.
        if word.strip_prefix("AX").is_some_and(|n| n.parse::<u8>().is_ok_and(|n| (1..=31).contains(&n))) {
            return Ok(Val::text(word.as_bytes()));
        }
        self.channel.core.refuse(span, self.vars.undefined(name, &self.channel.core))
    }

    /// A result of the measuring cycles: their own, where one is left out or no variable has the name. What the program wrote goes
    /// before what `[variables]` says.
    fn found_by_cycle(&mut self, name: Symbol, args: &[Val], span: Span) -> Outcome<Option<Val>> {
        let word = self.channel.core.symbols.name(name);
        // Few names begin so: the others are not looked up.
        let Some(result) = word.starts_with('_').then(|| measuring_data::find(word)).flatten() else { return Ok(None) };
        let word = word.to_owned();
        let left_out = result && self.channel.measured.cycle.is_some();
        if !left_out && self.known_variable(name).is_some() {
            return Ok(None);
        }
        let key = system_key(&word, args);
        if let Some(value) = self.channel.st.system.get(&key) {
            return Ok(Some(value.clone()));
        }
        if !result {
            return Ok(None);
        }
        let Some(value) = self.channel.core.job.settings.variables.get(&key).copied() else {
            let help = format!(
                "give it under [variables]: \"{key}\" = value; the measuring cycles keep it in the global data of the control"
            );
            let help = Answer::variable(&key, meaning_of(&word, args).unwrap_or_default()).help(help);
            let fault = codes::S9133::is_result_of_measuring_cycles(&key, &said_meaning(&word, args));
            return self.channel.core.refuse(span, fault.help(help));
        };
        self.channel.measured.says_given(&self.channel.core, &key, value, true, span);
        Ok(Some(Val::Real(value)))
    }

    /// A variable; the definition files are read when a name is not known otherwise.
    pub(super) fn known_variable(&mut self, name: Symbol) -> Option<Slot> {
        if let Some(slot) = self.vars.find(name) {
            return Some(slot);
        }
        let word = self.channel.core.symbols.name(name);
        if self.definitions_read || self.channel.axis_names.find(word).is_some() || constant(word).is_some() {
            return None;
        }
        self.definitions_known();
        self.vars.find(name)
    }

    fn indexed_value(&mut self, base: Base, args: &[Val], span: Span) -> Outcome<Val> {
        let core = &self.channel.core;
        let slot = match base {
            Base::Letter(b'R') => {
                let n = core.accept(span, r_index(args))?;
                return self.vars.r_value(n, &self.channel, span);
            }
            Base::Letter(letter) => match self.vars.letter(letter, &core.symbols) {
                Some(slot) => slot,
                None => return core.refuse(span, codes::P1001::has_no_index_here(&(letter as char))),
            },
            Base::System(name) => return self.channel.system_value(name, args, span),
            Base::Name(name) => {
                if let Some(value) = self.found_by_cycle(name, args, span)? {
                    return Ok(value);
                }
                match self.known_variable(name) {
                    Some(slot) => slot,
                    None => return self.channel.core.refuse(span, self.vars.undefined(name, &self.channel.core)),
                }
            }
        };
        self.vars.indexed(slot, args, &self.channel, span)
    }

    fn function_value(&mut self, name: Symbol, args: &[Val], span: Span) -> Outcome<Val> {
        let word = self.channel.core.symbols.name(name);
        if word == "GETT" {
            let named = self.channel.core.accept(span, named_tool(args))?;
            let number = match self.channel.st.system.tool_named(&named) {
                Some(number) => number,
                None => self.channel.tool_by_name(&named, span)?,
            };
            return Ok(Val::Int(i32::try_from(number).unwrap_or(0)));
        }
        let Some((word, function)) = formula_functions::find(word) else {
            let fault = match self.names.meaning(name, &self.channel) {
                Meaning::Unknown => codes::S2001::there_is_no_function(&self.channel.core.symbols.name(name)),
                _ => self.names.misused(name, &self.vars, &self.channel),
            };
            return self.channel.core.refuse(span, fault);
        };
        let args = if args == [Val::Missing] { &[] } else { args };
        let made = match function {
            FormulaFunction::Program if matches!(word, "ISVAR" | "ISFILE") => {
                let core = &mut self.channel.core;
                let wanted = core.accept(span, asked_name(word, args))?;
                let there = if word == "ISFILE" {
                    let there = self.units.is_file(core, &wanted);
                    core.accept(span, there.map_err(|error| codes::P0105::file_cannot_be_read(&error)))?
                } else {
                    self.vars.is_known(&wanted, &mut core.symbols)
                };
                return Ok(Val::Bool(there));
            }
            FormulaFunction::Program if word == "AXNAME" => {
                return self.channel.axis_names.of_text(&self.channel.core, args, span);
            }
            FormulaFunction::Program => {
                let st = &self.channel.st;
                return self.channel.core.accept(span, frame_function(word, args, st.feed_unit(), st.roles()[2]));
            }
            FormulaFunction::Plain(function) => function(args),
            FormulaFunction::Number(f) => formula_functions::number(f, args),
        };
        if let (Ok(value), Some(from), "ROUND" | "RTOI") = (&made, args.first(), word) {
            says_negative_half(from, value, &self.channel.core, span);
        }
        self.channel.core.accept(span, made.map_err(|error| error.fault(word)))
    }
}

/// What ISVAR and ISFILE ask for.
fn asked_name(function: &str, args: &[Val]) -> Result<String, crate::diag::Fault> {
    let [Val::Text(text)] = args else { return Err(codes::S2021::takes_text(&function)) };
    let wanted = String::from_utf8_lossy(text).into_owned();
    if function == "ISVAR" && wanted.trim_start().starts_with('$') {
        return Err(codes::P2023::whether_control_has_is_known_on_machine(&wanted));
    }
    Ok(wanted)
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

fn joined(machine: &mut Machine) -> Result<Val, Stop> {
    let (b, a) = (machine.pop()?, machine.pop()?);
    let (Some(mut text), Some(rest)) = (to_text(&a), to_text(&b)) else {
        return Err(Fault::Mismatch(a.what(), b.what()).into());
    };
    text.extend_from_slice(&rest);
    if text.len() > MOST_JOINED {
        return Err(codes::S2030::joined_text_is_too_long().into());
    }
    Ok(Val::Text(text.into()))
}

fn int_or_real(n: i64) -> Val {
    i32::try_from(n).map_or(Val::Real(n as f64), Val::Int)
}

/// Names of frame components, as texts; they are words in `[X,TR]` only.
fn constant(name: &str) -> Option<Val> {
    matches!(name, "TR" | "FI" | "RT" | "SC" | "MI").then(|| Val::text(name.as_bytes()))
}
