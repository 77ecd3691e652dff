//! What the grammar's actions write into: the block under construction.

use lalrpop_util::ParseError;

use crate::diag::{Fault, codes};
use crate::lexer::sinumerik::{LetterNumber, Number, Tok, TypeName};
use crate::parser::problem::Problem;
use crate::parser::symbols::{Symbol, Symbols};
use crate::text::{Span, decode::readable};

use super::ast::*;

/// A block that fits the grammar but means nothing.
pub type Refusal = Problem;

type Refused<T> = Result<T, ParseError<u32, Tok, Refusal>>;

fn refuse<T>(span: Span, fault: Fault) -> Refused<T> {
    Err(ParseError::User { error: fault.among(span) })
}

/// What may follow the label of REPEAT.
#[derive(Debug, Clone, Copy)]
pub enum RepeatWord {
    Label(Symbol),
    Times(Formula),
    /// `P=n`
    Address(u8, Formula, Span),
}

/// The block under construction, and its text.
#[derive(Debug)]
pub struct Build<'a> {
    text: &'a [u8],
    block: &'a mut Block,
    symbols: &'a mut Symbols,
    problems: &'a mut Vec<Problem>,
}

impl<'a> Build<'a> {
    pub fn new(
        text: &'a [u8],
        block: &'a mut Block,
        symbols: &'a mut Symbols,
        problems: &'a mut Vec<Problem>,
    ) -> Build<'a> {
        Build { text, block, symbols, problems }
    }

    pub fn set(&mut self, stmt: Stmt) {
        self.block.stmt = stmt;
    }

    /// The symbol of a name in the block.
    pub fn name(&mut self, start: u32, end: u32) -> Symbol {
        self.symbols.intern(Span { start, end }.of(self.text))
    }

    // Words.

    pub fn word(&mut self, target: Target, value: Value, start: u32, end: u32) {
        self.block.words.push(Word { target, value, span: Span { start, end } });
    }

    pub fn literal(&mut self, n: LetterNumber, sign: f64, start: u32, end: u32) {
        let value = Value::Literal { value: sign * n.number.value, whole: n.number.whole, digits: n.digits };
        self.word(Target::Letter(n.letter), value, start, end);
    }

    pub fn signed(&mut self, letter: u8, n: Number, sign: f64, start: u32, end: u32) {
        let value = Value::Literal { value: sign * n.value, whole: n.whole, digits: 0 };
        self.word(Target::Letter(letter), value, start, end);
    }

    pub fn bare(&mut self, start: u32, end: u32) {
        let name = self.name(start, end);
        self.word(Target::Name(name), Value::None, start, end);
    }

    pub fn call_word(&mut self, args: Args, start: u32, name_end: u32, end: u32) {
        let name = self.name(start, name_end);
        self.word(Target::Name(name), Value::Call(args), start, end);
    }

    /// `F100 (text)`: a word and what is meant as a comment. Programs have names of two letters or more, or are numbered:
    /// `L140(1)`.
    pub fn numbered_call(&mut self, args: Args, start: u32, name_end: u32, end: u32) -> Refused<()> {
        let name = Span { start, end: name_end }.of(self.text);
        let numbered =
            matches!(name, [b'L' | b'l', digits @ ..] if !digits.is_empty() && digits.iter().all(u8::is_ascii_digit));
        if numbered && self.text.get(name_end as usize) == Some(&b'(') {
            self.call_word(args, start, name_end, end);
            return Ok(());
        }
        let span = Span { start: name_end, end };
        let problem = codes::S0003::brackets_hold_no_comment_on_this_control().among(span);
        Err(ParseError::User { error: problem.alarm(12080).help("a comment starts with `;`") })
    }

    pub fn indexed_word(&mut self, indices: Args, start: u32, name_end: u32, end: u32) {
        let name = self.name(start, name_end);
        self.word(Target::Indexed(Base::Name(name), indices), Value::None, start, end);
    }

    pub fn stray_text(&mut self, start: u32, end: u32) {
        let span = Span { start, end };
        self.problems.push(codes::P1001::text_cannot_stand_here().among(span).alarm(12080));
        self.block.stmt = Stmt::Bad;
    }

    /// A letter with a number in front of `=`: spindle number, numbered axis, parameter, name.
    pub fn numbered(&mut self, n: LetterNumber, start: u32, end: u32) -> Refused<Target> {
        let span = Span { start, end };
        if !n.number.whole || n.number.value > 1e6 {
            let text = readable(span.of(self.text)).into_owned();
            return refuse(span, codes::P1001::cannot_stand_in_front_2(&text));
        }
        let name = self.name(start, end);
        Ok(Target::Numbered(n.letter, n.number.value as u32, name))
    }

    pub fn args(&mut self, list: Vec<Formula>) -> Args {
        // `()` is no argument.
        if let [only] = list.as_slice()
            && only.is_missing()
        {
            return Args::default();
        }
        let from = self.block.args.len() as u32;
        self.block.args.extend_from_slice(&list);
        Args { from, count: list.len() as u32 }
    }

    // Statements.

    pub fn arm(&mut self, when: When, jump: Jump) {
        self.block.arms.push(Arm { when, jump });
    }

    pub fn constant(&mut self, n: Number, sign: i64, start: u32, end: u32) -> Refused<i64> {
        if !n.whole || n.value > f64::from(i32::MAX) {
            return refuse(Span { start, end }, codes::P1001::constant_of_case_is_whole_number());
        }
        Ok(sign * n.value as i64)
    }

    pub fn block_number(&mut self, n: Number, start: u32, end: u32) -> Refused<JumpTarget> {
        if !n.whole || n.value > f64::from(u32::MAX) {
            return refuse(Span { start, end }, codes::P1001::block_number_is_whole_number());
        }
        Ok(JumpTarget::Number(n.value as u32))
    }

    /// `N100` is a block number; any other letter with a number is a label.
    pub fn jump_target(&mut self, n: LetterNumber, start: u32, end: u32) -> JumpTarget {
        if n.letter == b'N' && n.number.whole && n.number.value <= f64::from(u32::MAX) {
            return JumpTarget::Number(n.number.value as u32);
        }
        JumpTarget::Label(self.name(start, end))
    }

    pub fn repeat_word(&mut self, n: LetterNumber, start: u32, end: u32) -> RepeatWord {
        if n.letter == b'P' && n.number.whole {
            let from = self.op_start();
            self.number(n.number);
            return RepeatWord::Times(self.formula(from, start + 1, end));
        }
        RepeatWord::Label(self.name(start, end))
    }

    pub fn repeat(&mut self, from: Symbol, rest: Vec<RepeatWord>, one_block: bool) -> Refused<Stmt> {
        let mut to = None;
        let mut times = None;
        for word in rest {
            match word {
                RepeatWord::Label(label) if to.is_none() && times.is_none() && !one_block => to = Some(label),
                RepeatWord::Times(n) | RepeatWord::Address(b'P', n, _) if times.is_none() => times = Some(n),
                RepeatWord::Times(n) => return refuse(n.span, codes::P1001::p_stands_twice()),
                RepeatWord::Address(_, _, span) => {
                    return refuse(span, codes::P1001::only_p_may_follow_label_of_repetition());
                }
                RepeatWord::Label(_) => {
                    let span = Span { start: 0, end: self.text.len() as u32 };
                    return refuse(span, codes::P1001::label_too_many_in_repetition());
                }
            }
        }
        Ok(if one_block { Stmt::RepeatBlock { label: from, times } } else { Stmt::Repeat { from, to, times } })
    }

    pub fn modal_call(&mut self, (name, span): (Symbol, Span), args: Option<Args>, times: Option<RepeatWord>) -> Stmt {
        if times.is_some() {
            let problem = codes::S1013::modal_call_takes_no_number_of_passes().among(span);
            self.problems.push(problem.alarm(12100).help("leave out what follows the name"));
            return Stmt::Bad;
        }
        Stmt::Call(CallForm::Modal { name, args: args.unwrap_or_default() })
    }

    pub fn def(&mut self, attributes: Vec<Symbol>, (kind, length): (TypeName, Option<Formula>)) -> Stmt {
        for variable in &mut self.block.variables {
            variable.kind = kind;
        }
        let global = attributes.iter().any(|name| matches!(self.symbols.name(*name), "NCK" | "CHAN"));
        Stmt::Def { kind, length, global }
    }

    pub fn variable(&mut self, name: Symbol, sizes: Option<Args>, value: Option<Formula>, start: u32, end: u32) {
        self.block.variables.push(Variable {
            name: Some(name),
            kind: TypeName::Int,
            by_reference: false,
            length: None,
            sizes: sizes.unwrap_or_default(),
            open: sizes.is_some_and(|sizes| sizes.count == 0),
            value,
            span: Span { start, end },
        });
    }

    /// A parameter of PROC, or of EXTERN, which has no name. `STRING[20] S` has a length, `REAL[3]` is an
    /// array without a name.
    #[allow(clippy::too_many_arguments)]
    pub fn parameter(
        &mut self,
        by_reference: bool,
        kind: TypeName,
        bracket: Option<Args>,
        name: Option<(Symbol, Option<Args>)>,
        value: Option<Formula>,
        start: u32,
        end: u32,
    ) {
        let (length, unnamed) = match bracket {
            Some(args) if kind == TypeName::String => (self.block.arguments(args).first().copied(), None),
            other => (None, other),
        };
        let (name, sizes) = match name {
            Some((name, sizes)) => (Some(name), sizes.or(unnamed)),
            None => (None, unnamed),
        };
        self.block.variables.push(Variable {
            name,
            kind,
            by_reference,
            length,
            sizes: sizes.unwrap_or_default(),
            open: sizes.is_some_and(|sizes| sizes.count == 0),
            value,
            span: Span { start, end },
        });
    }

    // Formulas.

    pub fn op_start(&mut self) -> u32 {
        self.block.ops.len() as u32
    }

    pub fn op(&mut self, op: Op) {
        self.block.ops.push(op);
    }

    pub fn formula(&mut self, from: u32, start: u32, end: u32) -> Formula {
        Formula { from, to: self.block.ops.len() as u32, span: Span { start, end } }
    }

    pub fn number(&mut self, n: Number) {
        let op = if n.whole && n.value <= f64::from(i32::MAX) { Op::Int(n.value as i64) } else { Op::Real(n.value) };
        self.op(op);
    }

    /// `LLI 0`, `ULI 10` of DEF; units and access rights (`PHU 5`, `APR 7`) mean nothing here.
    pub fn limit(&mut self, start: u32, end: u32, value: f64) {
        let name = Span { start, end }.of(self.text).to_ascii_uppercase();
        match name.as_slice() {
            b"LLI" => self.block.limits[0] = Some(value),
            b"ULI" => self.block.limits[1] = Some(value),
            _ => {}
        }
    }

    /// A text in quotes.
    pub fn text(&mut self, start: u32, end: u32) {
        self.op(Op::Text(Span { start: start + 1, end: end - 1 }));
    }

    /// `R5` is a parameter, any other letter with a number a name.
    pub fn letter_number_value(&mut self, n: LetterNumber, start: u32, end: u32) -> Refused<()> {
        let span = Span { start, end };
        if n.letter == b'R' && n.number.whole && n.number.value <= f64::from(u32::MAX) {
            self.op(Op::R(n.number.value as u32, span));
            return Ok(());
        }
        if !n.name_like {
            let text = readable(span.of(self.text)).into_owned();
            return refuse(span, codes::P1001::is_no_value(&text));
        }
        self.name_value(start, end);
        Ok(())
    }

    pub fn name_value(&mut self, start: u32, end: u32) {
        let name = self.name(start, end);
        self.op(Op::Name(name, Span { start, end }));
    }

    pub fn system_value(&mut self, start: u32, end: u32) {
        let name = self.name(start, end);
        self.op(Op::System(name, Span { start, end }));
    }

    pub fn index_value(&mut self, start: u32, name_end: u32, count: u32, end: u32, system: bool) {
        let name = self.name(start, name_end);
        let base = if system { Base::System(name) } else { Base::Name(name) };
        self.op(Op::Index(base, count, Span { start, end }));
    }

    pub fn call_value(&mut self, start: u32, name_end: u32, count: u32, end: u32) {
        let name = self.name(start, name_end);
        self.op(Op::Call(name, count, Span { start, end }));
    }

    /// A comparison; `logical` if AND, OR or XOR without brackets is one of its sides.
    pub fn compare(&mut self, op: Operator, logical: bool, start: u32, end: u32) -> bool {
        self.op(Op::Binary(op));
        if logical {
            let found = codes::S8001::and_or_xor_bind_tighter_than_comparison().among(Span { start, end });
            self.problems.push(found.help("put each comparison in brackets: IF (R1==1) AND (R2==2)"));
        }
        false
    }
}
