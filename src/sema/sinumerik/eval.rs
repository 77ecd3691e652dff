//! Computes formulas: postfix operations over a stack of values.
//!
//! Source: S 5.2 (docs/sources.md). Comparisons bind weakest; REAL values are equal within 1e-12 of their size.

use std::borrow::Cow;
use std::rc::Rc;

use crate::diag::{Answer, Help, codes};
use crate::lexer::formula::Function;
use crate::parser::sinumerik::ast::{Base, Block, Formula, Op};
use crate::parser::symbols::Symbol;
use crate::sema::value::{At, Divisor, Fault, Formulas, SetBy, Stop, evaluate};
use crate::text::Span;
use crate::text::decode::readable;

use super::axis_names::NamedAxis;
use super::formula_functions::{self, FormulaFunction, NoResult};
use super::frames::FrameValue;
use super::known_words::Known;
use super::value::{Val, to_text, whole};
use super::vars::{MOST_R, Slot};
use super::vocabulary::{Meaning, Procedure, Refusal};
use super::{Core, Outcome, Reported, Run};

/// Longest text that a formula makes.
const MOST_JOINED: usize = 800;

/// Alarms of constants in texts.
const BINARY_TOO_LARGE: u32 = 12220;
const HEX_TOO_LARGE: u32 = 12230;

/// A text with its constants as bytes; the place of one that is too large, and the alarm.
fn resolved_text(text: &[u8]) -> Result<Cow<'_, [u8]>, (usize, u32)> {
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
                return Err((at, if binary { BINARY_TOO_LARGE } else { HEX_TOO_LARGE }));
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
            Op::Text(span) => self.channel.core.text_value(span, at.text)?,
            Op::Missing => Val::Missing,
            Op::Name(name, span) => self.name_value(name, span)?,
            Op::R(n, span) => self.r_value(n, span)?,
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
            Op::Join => self.channel.core.joined(machine)?,
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
        Some(match *last {
            Op::R(n, _) => {
                let never = self.vars.r(n).is_some_and(|(_, set)| !set);
                let (name, nobody) = (format!("R{n}"), if never { SetBy::Nobody } else { SetBy::Unknown });
                let set = if never { None } else { SetBy::of(&self.channel.core.job, &name, None) };
                Divisor { set: set.unwrap_or(nobody), name }
            }
            Op::Name(name, span) => Divisor { name: self.written(span, at), set: self.set_to_zero(name) },
            Op::System(_, span) | Op::Index(_, _, span) => {
                Divisor { name: self.written(span, at), set: SetBy::Unknown }
            }
            _ => return None,
        })
    }

    fn fault(&self, fault: Fault, at: At<'_>) -> Reported {
        let found = match fault {
            Fault::Misfit(what) => codes::P2024::operator_does_not_fit(&what),
            Fault::Mismatch(a, b) => codes::P2024::values_do_not_go_together(&a, &b),
            Fault::Missing => codes::P2024::value_is_missing(),
            Fault::Said(found) => *found,
            Fault::Zero(_) => return self.divided_by_zero(None, at),
            Fault::ZeroBy(_, by) => return self.divided_by_zero(Some(&by), at),
            Fault::TooLargeInt => codes::P2022::result_is_too_large_for_int(),
            Fault::TooLarge | Fault::Domain(..) | Fault::Open(..) | Fault::Outside(..) | Fault::OpenBetween(..) => {
                codes::P2022::result_is_too_large().alarm(14051)
            }
        };
        self.channel.core.say(at.span, found);
        Reported
    }
}

impl Run<'_> {
    /// Names the divisor where it is a variable alone, and where it got its value.
    fn divided_by_zero(&self, by: Option<&Divisor>, at: At<'_>) -> Reported {
        let mut fault = match by {
            Some(by) => {
                codes::P2022::division_by_zero_that(&by.said(&self.channel.core.job, self.channel.core.here.origin.loc))
            }
            None => codes::P2022::division_by_zero(),
        };
        if let [first, rest @ ..] = &self.warned.unset[..] {
            let help = Answer::key("variables", first).help(codes::P2022::give_values_that_control_keeps());
            fault = fault.help(rest.iter().fold(help, |help, name| help.and(Answer::key("variables", name))));
        }
        self.channel.core.say(at.span, fault);
        Reported
    }

    /// As the block has it.
    fn written(&self, span: Span, at: At<'_>) -> String {
        let loc = self.channel.core.loc(span);
        // A block that was read as it stands in its file has its text there.
        let written = match span.of(at.text) {
            [] if !self.channel.core.here.rewritten => self.channel.core.job.sources.bytes(loc.file, loc.span),
            text => text.to_vec(),
        };
        readable(&written).trim().to_uppercase()
    }

    /// Who set the variable that is zero.
    fn set_to_zero(&self, name: Symbol) -> SetBy {
        let Some(slot) = self.vars.find(name) else { return SetBy::Unknown };
        let own = matches!(slot, Slot::Local(_)).then_some(self.channel.core.here.origin.call);
        let defined = self.vars.get(slot).map(|var| SetBy::Definition(var.defined));
        let set = SetBy::of(&self.channel.core.job, self.channel.core.symbols.name(name), own);
        match (set, slot) {
            (Some(set), _) => set,
            (None, Slot::Local(_)) if !self.channel.core.job.trail.has_returned() => defined.unwrap_or(SetBy::Unknown),
            (None, _) => SetBy::Unknown,
        }
    }
}

impl Run<'_> {
    /// The value of a formula.
    pub(super) fn eval(&mut self, formula: Formula, block: &Block, text: &[u8]) -> Outcome<Val> {
        let ops = block.formula(formula);
        match ops {
            [Op::Int(n)] => return Ok(int_or_real(*n)),
            [Op::Real(v)] if v.is_finite() => return Ok(Val::Real(*v)),
            [] => return Ok(Val::Missing),
            _ => {}
        }
        self.warned.unset.clear();
        evaluate(self, ops, At { span: formula.span, text })
    }

    /// The value of a formula as a number.
    pub(super) fn number(&mut self, formula: Formula, block: &Block, text: &[u8]) -> Outcome<f64> {
        let value = self.eval(formula, block, text)?;
        self.channel.core.as_number(&value, formula.span)
    }

    /// The value of a formula as a condition.
    pub(super) fn condition(&mut self, formula: Formula, block: &Block, text: &[u8]) -> Outcome<bool> {
        let value = self.eval(formula, block, text)?;
        match value.truth() {
            Some(truth) => Ok(truth),
            None => self.channel.core.refuse(formula.span, codes::P2024::condition_is_needed(&value.what())),
        }
    }

    pub(super) fn r_value(&mut self, n: u32, span: Span) -> Outcome<Val> {
        if n > MOST_R {
            return self.channel.core.refuse(span, codes::S2018::there_is_no_parameter_r(&n));
        }
        self.r_is_own(n, span)?;
        let (value, set) = self.vars.r(n).ok_or(Reported)?;
        if !set {
            self.warned.unset.push(format!("R{n}"));
        }
        if !set && self.warned.r.insert(n) {
            let found = codes::P2021::r_is_read_before_program_sets(&n).at(self.channel.core.loc(span));
            self.channel.core.report(
                found.help(
                    Answer::key("variables", format!("R{n}"))
                        .help(format!("set it in the program, or as `R{n} = …` under [variables]")),
                ),
            );
        }
        Ok(Val::Real(value))
    }

    fn name_value(&mut self, name: Symbol, span: Span) -> Outcome<Val> {
        if let Some(value) = self.found_by_cycle(name, &[], span)? {
            return Ok(value);
        }
        if let Some(slot) = self.known_variable(name) {
            return self.variable_value(slot, &[], span);
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
        self.undefined(name, span)
    }

    /// A result of the measuring cycles: their own, where one is left out or no variable has the name.
    fn found_by_cycle(&mut self, name: Symbol, args: &[Val], span: Span) -> Outcome<Option<Val>> {
        let word = self.channel.core.symbols.name(name);
        if !word.starts_with('_') || super::measuring_data::find(word).is_none() {
            return Ok(None);
        }
        let word = word.to_owned();
        if !self.is_found_by_cycle(&word) && self.known_variable(name).is_some() {
            return Ok(None);
        }
        self.measuring_value(&word, args, span)
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

    /// A word that nothing is known of, or one of the language that is not compiled.
    pub(super) fn undefined_word<T>(&mut self, name: Symbol, span: Span) -> Outcome<T> {
        match self.meaning(name) {
            Meaning::Known(known) => self.channel.core.not_compiled(name, known, span),
            Meaning::Procedure(Procedure::Refused(Refusal { what, .. })) => self
                .channel
                .core
                .refuse(span, codes::P9010::is_not_supported_so_replace(&self.channel.core.symbols.name(name), &what)),
            _ => self.undefined(name, span),
        }
    }

    /// A name that nothing is known of.
    pub(super) fn undefined<T>(&self, name: Symbol, span: Span) -> Outcome<T> {
        let word = self.channel.core.symbols.name(name);
        if matches!(self.vocabulary.get(word), Some(Meaning::Indexed(_))) {
            return self.channel.core.refuse(span, codes::P1001::lacks_axis_or_spindle_in_brackets(&word));
        }
        let names: Vec<&str> = self.vars.names().map(|symbol| self.channel.core.symbols.name(symbol)).collect();
        let like = crate::machine::tree::did_you_mean(word, names);
        let help = match like {
            Some(like) => format!("did you mean `{like}`?").into(),
            None if self.vars.in_main(name) => Answer::key("control", "md11120")
                .one_of(&["true"])
                .help("it is a variable of the main program; if subprograms see those, set `[control] md11120 = true`"),
            None => Help::from("define it by DEF at the top of the program, or in a definition file beside it"),
        };
        if let Some(result) = super::measuring_data::find(word) {
            return self.data_of_measuring(word, result, span);
        }
        // A variable of all programs is nothing like one of this program.
        let files: Vec<String> = super::declare::DEFINITION_FILES.iter().map(|file| format!("{file}.DEF")).collect();
        let help = help.and(Answer::folder_of(&files));
        self.channel.core.refuse(span, codes::S2001::name_is_not_defined(&word).help(&help))
    }

    /// The control has these in its own definition files.
    fn data_of_measuring<T>(&self, word: &str, result: bool, span: Span) -> Outcome<T> {
        let what = if result { "a result" } else { "an argument" };
        let help = if self.channel.core.job.settings.control.klartext_choices.probing_left_out {
            "give it a value before the cycle that it is for".into()
        } else {
            super::measuring::leave_out()
        };
        self.channel.core.refuse(span, codes::S9133::is_of_measuring_cycles(&word, &what).help(help))
    }

    pub(super) fn variable_value(&mut self, slot: Slot, indices: &[i32], span: Span) -> Outcome<Val> {
        self.variable_is_own(slot, span)?;
        self.warn_of_kept(slot, indices, span);
        let Some(var) = self.vars.get(slot) else { return Err(Reported) };
        if var.lost {
            return Err(Reported);
        }
        match var.offset(indices) {
            Some(at) => Ok(var.values[at].clone()),
            None => self.channel.core.refuse(span, no_element(var.sizes.len(), &var.sizes, indices)),
        }
    }

    fn indexed_value(&mut self, base: Base, args: &[Val], span: Span) -> Outcome<Val> {
        match base {
            Base::Letter(b'R') => {
                let n = self.channel.core.r_index(args, span)?;
                self.r_value(n, span)
            }
            Base::Letter(letter) => match self.letter_variable(letter) {
                Some(slot) => self.indexed_variable(slot, args, span),
                None => self.channel.core.refuse(span, codes::P1001::has_no_index_here(&(letter as char))),
            },
            Base::System(name) => self.channel.system_value(name, args, span),
            Base::Name(name) => {
                if let Some(value) = self.found_by_cycle(name, args, span)? {
                    return Ok(value);
                }
                let Some(slot) = self.known_variable(name) else { return self.undefined(name, span) };
                self.indexed_variable(slot, args, span)
            }
        }
    }

    fn indexed_variable(&mut self, slot: Slot, args: &[Val], span: Span) -> Outcome<Val> {
        if let Some(Val::Frame(frame)) = self.vars.get(slot).and_then(|var| var.values.first()).cloned() {
            self.warn_of_kept(slot, &[], span);
            return self.channel.frame_component(&frame, args, span);
        }
        let indices = self.channel.core.indices(args, span)?;
        self.element_or_character(slot, &indices, span)
    }

    /// `S[2]` of a text is its third character.
    fn element_or_character(&mut self, slot: Slot, indices: &[i32], span: Span) -> Outcome<Val> {
        if let Some(var) = self.vars.get(slot)
            && let ([index], [], Some(Val::Text(text))) = (indices, var.sizes.as_slice(), var.values.first())
        {
            let found = usize::try_from(*index).ok().and_then(|at| text.get(at)).copied();
            self.warn_of_kept(slot, &[], span);
            return match found {
                Some(c) => Ok(Val::Char(c)),
                None => self.channel.core.refuse(span, codes::S2018::text_has_no_character(&index)),
            };
        }
        self.variable_value(slot, indices, span)
    }

    fn function_value(&mut self, name: Symbol, args: &[Val], span: Span) -> Outcome<Val> {
        if self.channel.core.symbols.name(name) == "GETT" {
            return self.number_of_named_tool(args, span);
        }
        let Some((word, function)) = formula_functions::find(self.channel.core.symbols.name(name)) else {
            if !matches!(self.meaning(name), Meaning::Unknown) {
                return self.undefined_word(name, span);
            }
            return self
                .channel
                .core
                .refuse(span, codes::S2001::there_is_no_function(&self.channel.core.symbols.name(name)));
        };
        let args = if args == [Val::Missing] { &[] } else { args };
        let made = match function {
            FormulaFunction::Program => return self.program_function(word, args, span),
            FormulaFunction::Plain(function) => function(args),
            FormulaFunction::Number(f) => formula_functions::number(f, args),
        };
        let error = match made {
            Ok(value) => {
                if matches!(word, "ROUND" | "RTOI")
                    && let (Some(from), Some(made)) = (args.first().and_then(Val::number), value.number())
                {
                    self.channel.core.says_negative_half(from, made, span);
                }
                return Ok(value);
            }
            Err(error) => error,
        };
        match error {
            NoResult::Count(takes) => self.channel.core.refuse(span, codes::S2021::takes(&word, &takes)),
            NoResult::Type => self.channel.core.refuse(span, codes::P2024::does_not_take_value_of_this_type(&word)),
            NoResult::Domain(why) => {
                let alarm = match word {
                    "SPRINT" => 14065,
                    "RTOI" | "BTOI" => 14096,
                    "AXNAME" => 14097,
                    "NUMBER" => 14098,
                    _ => 14051,
                };
                self.channel.core.refuse(span, codes::P2022::formula_has_no_value(&word, &why).alarm(alarm))
            }
        }
    }
}

impl Core<'_> {
    pub(super) fn as_number(&self, value: &Val, span: Span) -> Outcome<f64> {
        match value.number() {
            Some(v) if v.is_finite() => Ok(v),
            Some(_) => self.refuse(span, codes::P2022::value_is_infinite()),
            None => self.refuse(span, codes::P2024::number_is_needed(&value.what())),
        }
    }

    /// A text in quotes. Bytes stand in it as `'H41'` or `'B1000001'`, too.
    fn text_value(&self, span: Span, text: &[u8]) -> Outcome<Val> {
        match resolved_text(span.of(text)) {
            Ok(bytes) => Ok(Val::text(&bytes)),
            Err((at, alarm)) => {
                let what = if alarm == BINARY_TOO_LARGE { "binary" } else { "hexadecimal" };
                let span = Span::at(span.start + at as u32, 1);
                self.refuse(span, codes::S2030::constant_in_text_is_larger_than_one(&what).alarm(alarm))
            }
        }
    }

    pub(super) fn not_compiled<T>(&self, name: Symbol, known: &Known, span: Span) -> Outcome<T> {
        self.refuse(span, codes::S9132::is_not_compiled(&self.symbols.name(name), &known.what).help(known.help))
    }

    /// Indices of an array, as whole numbers.
    pub(super) fn indices(&self, args: &[Val], span: Span) -> Outcome<Vec<i32>> {
        args.iter().map(|value| self.index(value, span)).collect()
    }

    fn index(&self, value: &Val, span: Span) -> Outcome<i32> {
        let fault = || codes::S2018::index_is_whole_number_this_is(&value.what());
        value.number().and_then(whole).map_or_else(|| self.refuse(span, fault()), Ok)
    }

    pub(super) fn r_index(&self, args: &[Val], span: Span) -> Outcome<u32> {
        let [index] = args else {
            self.indices(args, span)?;
            return self.refuse(span, codes::S2018::r_parameter_has_one_index());
        };
        let index = self.index(index, span)?;
        match u32::try_from(index) {
            Ok(n) if n <= MOST_R => Ok(n),
            _ => self.refuse(span, codes::S2018::there_is_no_parameter_r(&index)),
        }
    }

    fn joined(&self, machine: &mut Machine) -> Result<Val, Stop> {
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
}

fn int_or_real(n: i64) -> Val {
    i32::try_from(n).map_or(Val::Real(n as f64), Val::Int)
}

/// Names of frame components, as texts; they are words in `[X,TR]` only.
fn constant(name: &str) -> Option<Val> {
    matches!(name, "TR" | "FI" | "RT" | "SC" | "MI").then(|| Val::text(name.as_bytes()))
}

fn no_element(dimensions: usize, sizes: &[u32], indices: &[i32]) -> crate::diag::Fault {
    match (dimensions, indices) {
        (0, _) => codes::S2018::variable_is_no_array(),
        (n, indices) if n != indices.len() => codes::S2018::array_has_indices(&n, &indices.len()),
        _ => codes::S2018::array_has_no_element(&format_args!("{indices:?}"), &format_args!("{sizes:?}")),
    }
}
