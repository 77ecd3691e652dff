//! Computes formulas: postfix operations over a stack of values.
//!
//! Source: reference section 5.2. Comparisons bind weakest; REAL values are equal within 1e-12 of their size.

use std::borrow::Cow;
use std::rc::Rc;

use crate::diag::{Diagnostic, codes};
use crate::parser::sinumerik::ast::{Base, Binary, Block, Formula, Op, Unary};
use crate::parser::symbols::Symbol;
use crate::text::Span;

use super::functions::{self, NoResult};
use super::known_words::Known;
use super::value::{Val, to_text, whole};
use super::vars::{MOST_R, Slot};
use super::vocabulary::{Meaning, Procedure};
use super::{Outcome, Reported, Run};

/// Relative difference up to which two REAL values are equal.
const EQUAL: f64 = 1e-12;
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
        let mut stack = std::mem::take(&mut self.stack);
        stack.clear();
        let mut result = Ok(());
        for op in ops {
            result = self.operation(op, &mut stack, formula.span, text);
            if result.is_err() {
                break;
            }
        }
        let value = stack.pop();
        self.stack = stack;
        result?;
        value.ok_or(Reported)
    }

    /// The value of a formula as a number.
    pub(super) fn number(&mut self, formula: Formula, block: &Block, text: &[u8]) -> Outcome<f64> {
        let value = self.eval(formula, block, text)?;
        self.as_number(&value, formula.span)
    }

    pub(super) fn as_number(&self, value: &Val, span: Span) -> Outcome<f64> {
        match value.number() {
            Some(v) if v.is_finite() => Ok(v),
            Some(_) => self.fail(codes::S2006, 14051, span, "the value is infinite"),
            None => self.fail(codes::S2005, 12150, span, format!("a number is needed, this is {}", value.what())),
        }
    }

    /// The value of a formula as a condition.
    pub(super) fn condition(&mut self, formula: Formula, block: &Block, text: &[u8]) -> Outcome<bool> {
        let value = self.eval(formula, block, text)?;
        match value.truth() {
            Some(truth) => Ok(truth),
            None => {
                let message = format!("a condition is needed, this is {}", value.what());
                self.fail(codes::S2005, 12150, formula.span, message)
            }
        }
    }

    /// A text in quotes. Bytes stand in it as `'H41'` or `'B1000001'`, too.
    fn text_value(&self, span: Span, text: &[u8]) -> Outcome<Val> {
        match resolved_text(span.of(text)) {
            Ok(bytes) => Ok(Val::text(&bytes)),
            Err((at, alarm)) => {
                let what = if alarm == BINARY_TOO_LARGE { "binary" } else { "hexadecimal" };
                let span = Span::at(span.start + at as u32, 1);
                let message = format!("the {what} constant in the text is larger than one character");
                self.fail_help(codes::S2030, alarm, span, message, "a character has 8 bits: 'H00' to 'HFF'")
            }
        }
    }

    fn operation(&mut self, op: &Op, stack: &mut Vec<Val>, whole_span: Span, text: &[u8]) -> Outcome {
        let value = match *op {
            Op::Real(v) if v.is_finite() => Val::Real(v),
            Op::Real(_) => return self.fail(codes::S2029, 12160, whole_span, "the number is too large"),
            Op::Int(n) => int_or_real(n),
            Op::Bool(b) => Val::Bool(b),
            Op::Char(c) => Val::Char(c),
            Op::Text(span) => self.text_value(span, text)?,
            Op::Missing => Val::Missing,
            Op::Name(name, span) => self.name_value(name, span)?,
            Op::R(n, span) => self.r_value(n, span)?,
            Op::System(name, span) => self.system_value(name, &[], span)?,
            Op::Index(base, count, span) => {
                let args = taken(stack, count);
                self.indexed_value(base, &args, span)?
            }
            Op::Call(name, count, span) => {
                let mut args = taken(stack, count);
                if args == [Val::Missing] {
                    args.clear();
                }
                self.function_value(name, &args, span)?
            }
            Op::List(count) => Val::List(taken(stack, count).into()),
            Op::Unary(op) => {
                let value = stack.pop().ok_or(Reported)?;
                self.unary(op, &value, whole_span)?
            }
            Op::Binary(op) => {
                let right = stack.pop().ok_or(Reported)?;
                let left = stack.pop().ok_or(Reported)?;
                self.binary(op, &left, &right, whole_span)?
            }
        };
        stack.push(value);
        Ok(())
    }

    pub(super) fn r_value(&mut self, n: u32, span: Span) -> Outcome<Val> {
        if n > MOST_R {
            return self.fail(codes::S2018, 17020, span, format!("there is no parameter R{n}"));
        }
        let (value, set) = self.vars.r(n).ok_or(Reported)?;
        if !set && self.warned_r.insert(n) {
            let message = format!("R{n} is read before the program sets it; it counts as 0");
            let found = Diagnostic::new(codes::S2025, self.loc(span), message);
            self.report(found.help(format!("set it in the program, or as `R{n} = …` under [variables]")));
        }
        Ok(Val::Real(value))
    }

    fn name_value(&mut self, name: Symbol, span: Span) -> Outcome<Val> {
        if let Some(slot) = self.known_variable(name) {
            return self.variable_value(slot, &[], span);
        }
        let word = self.symbols.name(name);
        if let Some(named) = self.axis_names.find(word) {
            self.printed_axis(named, span)?;
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

    /// A variable; the definition files are read when a name is not known otherwise.
    pub(super) fn known_variable(&mut self, name: Symbol) -> Option<Slot> {
        if let Some(slot) = self.vars.find(name) {
            return Some(slot);
        }
        let word = self.symbols.name(name);
        if self.definitions_read || self.axis_names.find(word).is_some() || constant(word).is_some() {
            return None;
        }
        self.definitions_known();
        self.vars.find(name)
    }

    /// A word that nothing is known of, or one of the language that is not compiled.
    pub(super) fn undefined_word<T>(&mut self, name: Symbol, span: Span) -> Outcome<T> {
        match self.meaning(name) {
            Meaning::Known(known) => self.not_compiled(name, known, span),
            Meaning::Procedure(Procedure::Refused(what)) => {
                let message = format!("{} ({what}) is not supported", self.symbols.name(name));
                self.fail_help(codes::S9005, 0, span, message, "replace it by plain moves")
            }
            _ => self.undefined(name, span),
        }
    }

    pub(super) fn not_compiled<T>(&self, name: Symbol, known: &Known, span: Span) -> Outcome<T> {
        let message = format!("{} ({}) is not compiled", self.symbols.name(name), known.what);
        self.fail_help(codes::S9132, 0, span, message, known.help)
    }

    /// A name that nothing is known of.
    pub(super) fn undefined<T>(&self, name: Symbol, span: Span) -> Outcome<T> {
        let word = self.symbols.name(name);
        if matches!(self.vocabulary.get(word), Some(Meaning::Indexed(_))) {
            let message = format!("{word} lacks the axis or spindle in brackets");
            return self.fail_help(codes::S1001, 12080, span, message, &format!("write {word}[X]=…"));
        }
        let names: Vec<&str> = self.vars.names().map(|symbol| self.symbols.name(symbol)).collect();
        let like = crate::machine::tree::did_you_mean(word, names);
        let help = match like {
            Some(like) => format!("did you mean `{like}`?"),
            None if self.vars.in_main(name) => {
                "it is a variable of the main program; if subprograms see those, set `[control] md11120 = true`"
                    .to_owned()
            }
            None => "define it by DEF at the top of the program, or in a definition file beside it".to_owned(),
        };
        self.fail_help(codes::S2001, 12550, span, format!("the name `{word}` is not defined"), &help)
    }

    /// A global variable keeps its value from run to run, so its start value is a guess.
    fn warn_of_global(&mut self, slot: Slot, span: Span) {
        let Slot::Global(name) = slot else { return };
        if self.vars.get(slot).is_some_and(|var| !var.written) && self.warned_global.insert(name) {
            let word = self.symbols.name(name);
            let message = format!("`{word}` is read before the program sets it; it counts as its start value");
            let found = Diagnostic::new(codes::S2025, self.loc(span), message);
            self.report(found.help("set it in the program: what the control keeps in it is not known here"));
        }
    }

    pub(super) fn variable_value(&mut self, slot: Slot, indices: &[i32], span: Span) -> Outcome<Val> {
        self.warn_of_global(slot, span);
        let Some(var) = self.vars.get(slot) else { return Err(Reported) };
        if var.lost {
            return Err(Reported);
        }
        match var.offset(indices) {
            Some(at) => Ok(var.values[at].clone()),
            None => {
                let message = no_element(var.sizes.len(), &var.sizes, indices);
                self.fail(codes::S2018, 12400, span, message)
            }
        }
    }

    /// Indices of an array, as whole numbers.
    pub(super) fn indices(&self, args: &[Val], span: Span) -> Outcome<Vec<i32>> {
        let index = |value: &Val| match value.number().and_then(whole) {
            Some(n) => Ok(n),
            None => {
                self.fail(codes::S2018, 12410, span, format!("an index is a whole number, this is {}", value.what()))
            }
        };
        args.iter().map(index).collect()
    }

    fn indexed_value(&mut self, base: Base, args: &[Val], span: Span) -> Outcome<Val> {
        match base {
            Base::Letter(b'R') => {
                let n = self.r_index(args, span)?;
                self.r_value(n, span)
            }
            Base::Letter(letter) => match self.letter_variable(letter) {
                Some(slot) => self.indexed_variable(slot, args, span),
                None => {
                    let message = format!("`{}` has no index here", letter as char);
                    self.fail(codes::S1001, 12080, span, message)
                }
            },
            Base::System(name) => self.system_value(name, args, span),
            Base::Name(name) => {
                let Some(slot) = self.known_variable(name) else { return self.undefined(name, span) };
                self.indexed_variable(slot, args, span)
            }
        }
    }

    fn indexed_variable(&mut self, slot: Slot, args: &[Val], span: Span) -> Outcome<Val> {
        self.warn_of_global(slot, span);
        if let Some(Val::Frame(frame)) = self.vars.get(slot).and_then(|var| var.values.first()).cloned() {
            return self.frame_component(&frame, args, span);
        }
        let indices = self.indices(args, span)?;
        self.element_or_character(slot, &indices, span)
    }

    /// `S[2]` of a text is its third character.
    fn element_or_character(&mut self, slot: Slot, indices: &[i32], span: Span) -> Outcome<Val> {
        if let Some(var) = self.vars.get(slot)
            && let ([index], [], Some(Val::Text(text))) = (indices, var.sizes.as_slice(), var.values.first())
        {
            let found = usize::try_from(*index).ok().and_then(|at| text.get(at)).copied();
            return match found {
                Some(c) => Ok(Val::Char(c)),
                None => self.fail(codes::S2018, 12400, span, format!("the text has no character {index}")),
            };
        }
        self.variable_value(slot, indices, span)
    }

    pub(super) fn r_index(&self, args: &[Val], span: Span) -> Outcome<u32> {
        let [index] = self.indices(args, span)?[..] else {
            return self.fail(codes::S2018, 12400, span, "an R parameter has one index");
        };
        match u32::try_from(index) {
            Ok(n) if n <= MOST_R => Ok(n),
            _ => self.fail(codes::S2018, 17020, span, format!("there is no parameter R{index}")),
        }
    }

    fn function_value(&mut self, name: Symbol, args: &[Val], span: Span) -> Outcome<Val> {
        let word = self.symbols.name(name).to_owned();
        if let Some(result) = self.program_function(&word, args, span) {
            return result;
        }
        let error = match functions::call(&word, args) {
            Ok(Val::Real(v)) if !v.is_finite() => Domain("the value is infinite"),
            Ok(value) => {
                if matches!(word.as_str(), "ROUND" | "RTOI")
                    && let (Some(from), Some(made)) = (args.first().and_then(Val::number), value.number())
                {
                    self.says_negative_half(from, made, span);
                }
                return Ok(value);
            }
            Err(error) => error,
        };
        use NoResult::{Count, Domain, Type, Unknown};
        match error {
            Unknown if !matches!(self.meaning(name), Meaning::Unknown) => self.undefined_word(name, span),
            Unknown => self.fail_help(
                codes::S2001,
                12550,
                span,
                format!("there is no function `{word}`"),
                "a program is called in a block of its own, not in a formula",
            ),
            Count(takes) => self.fail(codes::S2021, 14021, span, format!("{word} takes {takes}")),
            Type => self.fail(codes::S2005, 12150, span, format!("{word} does not take a value of this type")),
            Domain(why) => {
                let alarm = match word.as_str() {
                    "SPRINT" => 14065,
                    "RTOI" | "BTOI" => 14096,
                    "AXNAME" => 14097,
                    "NUMBER" => 14098,
                    _ => 14051,
                };
                self.fail(codes::S2006, alarm, span, format!("{word}: {why}"))
            }
        }
    }

    fn unary(&self, op: Unary, value: &Val, span: Span) -> Outcome<Val> {
        let made = match (op, value) {
            (Unary::Negate, Val::Int(n)) => n.checked_neg().map(Val::Int),
            (Unary::Negate, Val::Real(v)) => Some(Val::Real(-v)),
            (Unary::Not, value) => value.truth().map(|truth| Val::Bool(!truth)),
            (Unary::BitNot, Val::Int(n)) => Some(Val::Int(!n)),
            (Unary::ToText, value) => to_text(value).map(|text| Val::Text(text.into())),
            _ => None,
        };
        match made {
            Some(value) => Ok(value),
            None => self.fail(codes::S2005, 12150, span, format!("the operator does not fit {}", value.what())),
        }
    }

    fn binary(&self, op: Binary, a: &Val, b: &Val, span: Span) -> Outcome<Val> {
        use Binary::*;
        match op {
            Add | Subtract | Multiply | Divide | Div | Mod => self.arithmetic(op, a, b, span),
            BitAnd | BitOr | BitXor => match (a, b) {
                (Val::Int(a), Val::Int(b)) => Ok(Val::Int(match op {
                    BitAnd => a & b,
                    BitOr => a | b,
                    _ => a ^ b,
                })),
                _ => self.mismatch(a, b, span),
            },
            And | Or | Xor => match (a.truth(), b.truth()) {
                (Some(a), Some(b)) => Ok(Val::Bool(match op {
                    And => a && b,
                    Or => a || b,
                    _ => a != b,
                })),
                _ => self.mismatch(a, b, span),
            },
            Concat => match (to_text(a), to_text(b)) {
                (Some(mut a), Some(b)) => {
                    a.extend_from_slice(&b);
                    if a.len() > MOST_JOINED {
                        return self.fail(codes::S2030, 14099, span, "the joined text is too long");
                    }
                    Ok(Val::Text(a.into()))
                }
                _ => self.mismatch(a, b, span),
            },
            Equal | NotEqual | Less | LessEqual | Greater | GreaterEqual => self.comparison(op, a, b, span),
            Chain => match (a, b) {
                (Val::Frame(a), Val::Frame(b)) => Ok(Val::Frame(Rc::new(a.chain(b)))),
                _ => self.mismatch(a, b, span),
            },
        }
    }

    fn mismatch<T>(&self, a: &Val, b: &Val, span: Span) -> Outcome<T> {
        let message = format!("{} and {} do not go together here", a.what(), b.what());
        self.fail(codes::S2005, 12150, span, message)
    }

    fn arithmetic(&self, op: Binary, a: &Val, b: &Val, span: Span) -> Outcome<Val> {
        if let (Val::Int(x), Val::Int(y)) = (a, b)
            && op != Binary::Divide
        {
            let made = match op {
                Binary::Add => x.checked_add(*y),
                Binary::Subtract => x.checked_sub(*y),
                Binary::Multiply => x.checked_mul(*y),
                _ if *y == 0 => return self.fail(codes::S2006, 14051, span, "division by zero"),
                Binary::Div => x.checked_div(*y),
                _ => x.checked_rem(*y),
            };
            return match made {
                Some(n) => Ok(Val::Int(n)),
                None => self.fail(codes::S2006, 14051, span, "the result is too large for an INT"),
            };
        }
        let (Some(x), Some(y)) = (a.number(), b.number()) else { return self.mismatch(a, b, span) };
        if y == 0.0 && matches!(op, Binary::Divide | Binary::Div | Binary::Mod) {
            return self.fail(codes::S2006, 14051, span, "division by zero");
        }
        let value = match op {
            Binary::Add => x + y,
            Binary::Subtract => x - y,
            Binary::Multiply => x * y,
            Binary::Divide => x / y,
            Binary::Div => libm::trunc(x / y),
            _ => libm::fmod(x, y),
        };
        if !value.is_finite() {
            return self.fail(codes::S2006, 14051, span, "the result is too large");
        }
        Ok(Val::Real(value))
    }

    fn comparison(&self, op: Binary, a: &Val, b: &Val, span: Span) -> Outcome<Val> {
        use std::cmp::Ordering;
        let order = match (a, b) {
            (Val::Text(a), Val::Text(b)) => a.cmp(b),
            (Val::Text(a), Val::Char(b)) => a.as_ref().cmp(&[*b]),
            (Val::Char(a), Val::Text(b)) => [*a].as_slice().cmp(b.as_ref()),
            (Val::Axis(a), Val::Axis(b)) => a.cmp(b),
            _ => match (a.number(), b.number()) {
                (Some(x), Some(y)) if nearly_equal(x, y) => Ordering::Equal,
                (Some(x), Some(y)) => x.partial_cmp(&y).unwrap_or(Ordering::Equal),
                _ => return self.mismatch(a, b, span),
            },
        };
        Ok(Val::Bool(match op {
            Binary::Equal => order.is_eq(),
            Binary::NotEqual => order.is_ne(),
            Binary::Less => order.is_lt(),
            Binary::LessEqual => order.is_le(),
            Binary::Greater => order.is_gt(),
            _ => order.is_ge(),
        }))
    }
}

fn nearly_equal(x: f64, y: f64) -> bool {
    (x - y).abs() <= EQUAL * x.abs().max(y.abs())
}

fn int_or_real(n: i64) -> Val {
    i32::try_from(n).map_or(Val::Real(n as f64), Val::Int)
}

/// The last `count` values of the stack.
fn taken(stack: &mut Vec<Val>, count: u32) -> Vec<Val> {
    let from = stack.len().saturating_sub(count as usize);
    stack.split_off(from)
}

/// Names of frame components, as texts; they are words in `[X,TR]` only.
fn constant(name: &str) -> Option<Val> {
    matches!(name, "TR" | "FI" | "RT" | "SC" | "MI").then(|| Val::text(name.as_bytes()))
}

fn no_element(dimensions: usize, sizes: &[u32], indices: &[i32]) -> String {
    match (dimensions, indices) {
        (0, _) => "the variable is no array".to_owned(),
        (n, indices) if n != indices.len() => format!("the array has {n} indices, not {}", indices.len()),
        _ => format!("the array has no element {indices:?}; its sizes are {sizes:?}, counted from 0"),
    }
}
