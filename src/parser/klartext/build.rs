//! What the grammar's actions write into: the block under construction.

use lalrpop_util::ParseError;

use crate::lexer::klartext::{AxisWord, CycleNumber, NameQ, QRef, Tok, Value};
use crate::machine::{Axis, Unit};
use crate::text::Span;

use super::ast::{Addr, Block, Function, LabelRef, Op, Operator, PatternWord, Repeat, Stmt, Test, TextFn, Word};

/// A block that fits the grammar but means nothing: where, and what is wrong.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refusal {
    pub span: Span,
    pub message: String,
}

type Refused<T> = Result<T, ParseError<u32, Tok, Refusal>>;

fn refuse<T>(span: Span, message: impl Into<String>) -> Refused<T> {
    Err(ParseError::User { error: Refusal { span, message: message.into() } })
}

/// The block under construction, and its text.
#[derive(Debug)]
pub struct Build<'a> {
    pub text: &'a [u8],
    pub block: &'a mut Block,
    /// `CYCLE DEF` was written.
    pub misspelled: bool,
    /// Arguments of the text function being read.
    arguments: Vec<(Span, Value)>,
}

impl<'a> Build<'a> {
    pub fn new(text: &'a [u8], block: &'a mut Block) -> Build<'a> {
        Build { text, block, misspelled: false, arguments: Vec::new() }
    }

    pub fn set(&mut self, stmt: Stmt) {
        self.block.stmt = stmt;
    }

    pub fn word(&mut self, addr: Addr, value: Value, start: u32, end: u32) {
        self.block.words.push(Word { addr, value, span: Span { start, end } });
    }

    pub fn axis(&mut self, word: AxisWord, start: u32, end: u32) {
        let addr = Addr::Axis { axis: word.axis, incremental: word.incremental };
        self.word(addr, word.value, start, end);
    }

    /// `Q206=FU Q202=5`: in a path block Q202 would be the value of FU, here it is the next parameter.
    pub fn feed_word_in_front(&mut self, q: QRef, next: Value, value: Value, [start, middle, end]: [u32; 3]) {
        self.word(Addr::Assign(q), Value::None, start, middle);
        match next {
            Value::Param { negative: false, q } => self.word(Addr::Assign(q), value, middle, end),
            _ => self.word(Addr::Colon, Value::None, middle, end),
        }
    }

    pub fn rotary_c(&mut self, start: u32, end: u32) {
        self.word(Addr::Axis { axis: Axis::C, incremental: false }, Value::None, start, end);
    }

    pub fn name_q(&mut self, word: NameQ, start: u32, end: u32) {
        self.word(Addr::Name, Value::None, start, start + word.name);
        self.word(Addr::Value, Value::Param { negative: false, q: word.q }, start + word.name, end);
    }

    /// A pattern is over: its word reaches from its name to the bracket.
    pub fn pattern_ends(&mut self, end: u32) {
        let head = self.block.words.iter_mut().rev().find(|word| matches!(word.addr, Addr::Pattern(_)));
        if let Some(head) = head {
            head.span.end = end;
        }
    }

    pub fn pattern_word(&mut self, name: Span, value: Value, end: u32) -> Refused<()> {
        let Some(word) = PatternWord::named(name.of(self.text)) else {
            return refuse(name, "a pattern has no such word");
        };
        self.word(Addr::PatternWord(word), value, name.start, end);
        Ok(())
    }

    pub fn op(&mut self, op: Op) {
        self.block.ops.push(op);
    }

    pub fn power(&mut self, doubtful: bool, start: u32, end: u32) -> bool {
        if doubtful {
            self.op(Op::DoubtfulPower(Span { start, end }));
        }
        self.op(Op::Binary(Operator::Power));
        true
    }

    /// Pushes the value of a word as an operand.
    pub fn operand(&mut self, value: Value) {
        match value {
            Value::Number(n) => self.op(Op::Number(n)),
            Value::Param { negative, q } => {
                self.op(Op::Param(q));
                if negative {
                    self.op(Op::Unary(Function::Negate));
                }
            }
            Value::None | Value::FeedMax | Value::FeedAuto => {}
        }
    }

    /// A function glued to its parameter: `SINQ3`.
    pub fn function_q(&mut self, word: NameQ, start: u32, end: u32) -> Refused<()> {
        let name = &self.text[start as usize..(start + word.name) as usize];
        let Some(function) = function_named(name) else {
            return refuse(Span { start, end }, "name of no function");
        };
        self.op(Op::Param(word.q));
        self.op(Op::Unary(function));
        Ok(())
    }

    /// Name and unit of BEGIN PGM or END PGM.
    pub fn frame(&mut self, rest: Span, end: bool) -> Stmt {
        let text = rest.of(self.text);
        let last = text.iter().rposition(|b| b.is_ascii_whitespace()).map_or(0, |at| at + 1);
        let unit = match &text[last..] {
            word if word.eq_ignore_ascii_case(b"MM") => Some(Unit::Mm),
            word if word.eq_ignore_ascii_case(b"INCH") => Some(Unit::Inch),
            _ => None,
        };
        let name_len = if unit.is_some() { text[..last].trim_ascii_end().len() } else { text.len() };
        let name = Span::at(rest.start, name_len as u32);
        if end { Stmt::End { name, unit } } else { Stmt::Begin { name, unit } }
    }

    pub fn cycle(&mut self, number: CycleNumber) -> Stmt {
        self.misspelled |= number.misspelled;
        if !number.rest.is_empty() {
            self.word(Addr::Text, Value::None, number.rest.start, number.rest.end);
        }
        Stmt::Cycle { number: number.number, part: number.part }
    }

    pub fn label_number(&mut self, number: f64, start: u32, end: u32) -> Refused<LabelRef> {
        if number.fract() == 0.0 && (0.0..=65535.0).contains(&number) {
            return Ok(LabelRef::Number(number as u32));
        }
        refuse(Span { start, end }, "a label is a whole number from 0 to 65535, or a name in quotes")
    }

    /// `REPQ9`
    pub fn repeat_q(&mut self, word: NameQ, start: u32, end: u32) -> Refused<Repeat> {
        let name = &self.text[start as usize..(start + word.name) as usize];
        if name.eq_ignore_ascii_case(b"REP") {
            return Ok(Repeat::Param(word.q));
        }
        refuse(Span { start, end }, "only REP may follow the label")
    }

    /// Pushes the operator of an FN function; `form` is the number that has this form.
    pub fn fn_form(&mut self, form: u32, op: Op) -> u32 {
        self.op(op);
        form
    }

    pub fn fn_assign(&mut self, number: u32, target: QRef, form: u32, start: u32, end: u32) -> Refused<Stmt> {
        if number == form {
            return Ok(Stmt::Fn { number, target });
        }
        refuse(Span { start, end }, format!("this is the form of FN {form}, not of FN {number}"))
    }

    pub fn fn_if(&mut self, number: u32, test: Test, target: LabelRef, start: u32, end: u32) -> Refused<Stmt> {
        use super::ast::Relation;
        let fits = match test {
            Test::Defined { .. } => number == 9,
            Test::Compare { relation, .. } => {
                number
                    == match relation {
                        Relation::Equal => 9,
                        Relation::NotEqual => 10,
                        Relation::Greater => 11,
                        Relation::Less => 12,
                    }
            }
        };
        if fits {
            return Ok(Stmt::If { number, test, target });
        }
        refuse(Span { start, end }, format!("FN {number} has another comparison: 9 EQU, 10 NE, 11 GT, 12 LT"))
    }

    pub fn fn_read(&mut self, number: u32, target: QRef, name: Span, start: u32) -> Refused<Stmt> {
        if number == 18 && name.of(self.text).eq_ignore_ascii_case(b"SYSREAD") {
            return Ok(Stmt::SystemRead(target));
        }
        refuse(Span { start, end: name.end }, format!("FN {number} has no such form"))
    }

    pub fn argument(&mut self, word: NameQ, start: u32) {
        let value = Value::Param { negative: false, q: word.q };
        self.arguments.push((Span::at(start, word.name), value));
    }

    pub fn argument_value(&mut self, name: Span, value: Value) {
        self.arguments.push((name, value));
    }

    /// Pushes the arguments of a text function in its own order, then the function.
    pub fn text_call(&mut self, name: Span, end: u32) -> Refused<()> {
        let arguments = std::mem::take(&mut self.arguments);
        let (function, wanted): (TextFn, &[&str]) = match upper(name.of(self.text)).as_slice() {
            b"TOCHAR" => (TextFn::ToChar, &["DAT", "DECIMALS?"]),
            b"TONUMB" => (TextFn::ToNumber, &["SRC_"]),
            b"SUBSTR" => (TextFn::Substring, &["SRC_", "BEG", "LEN"]),
            b"INSTR" => (TextFn::Find, &["SRC_", "SEA_", "BEG"]),
            b"STRLEN" => (TextFn::Length, &["SRC_"]),
            b"STRCOMP" => (TextFn::Compare, &["SRC_", "SEA_"]),
            b"SYSSTR" | b"CFGREAD" => (TextFn::Unknown, &[]),
            _ => return refuse(name, "name of no function"),
        };
        let span = Span { start: name.start, end };
        for &want in wanted {
            let (want, optional) = want.strip_suffix('?').map_or((want, false), |want| (want, true));
            let found = arguments.iter().find(|(name, _)| name.of(self.text).eq_ignore_ascii_case(want.as_bytes()));
            match found {
                Some(&(_, value)) => self.operand(value),
                None if optional => self.op(Op::Number(-1.0)),
                None => return refuse(span, format!("argument {want} is missing")),
            }
        }
        if function != TextFn::Unknown && arguments.len() > wanted.len() {
            return refuse(span, "too many arguments");
        }
        self.op(Op::TextFn(function));
        Ok(())
    }
}

fn upper(text: &[u8]) -> Vec<u8> {
    text.to_ascii_uppercase()
}

fn function_named(name: &[u8]) -> Option<Function> {
    Some(match upper(name).as_slice() {
        b"SIN" => Function::Sin,
        b"COS" => Function::Cos,
        b"TAN" => Function::Tan,
        b"ASIN" => Function::Asin,
        b"ACOS" => Function::Acos,
        b"ATAN" => Function::Atan,
        b"SQRT" => Function::Sqrt,
        b"LN" => Function::Ln,
        b"LOG" => Function::Log,
        b"EXP" => Function::Exp,
        b"NEG" => Function::Negate,
        b"INT" => Function::Int,
        b"ABS" => Function::Abs,
        b"FRAC" => Function::Fraction,
        b"SGN" => Function::Sign,
        _ => return None,
    })
}
