//! What the grammar's actions write into: the block under construction.

use lalrpop_util::ParseError;

use crate::diag::{Fault, codes};
use crate::lexer::turning::{self, Tok};
use crate::parser::problem::Problem;
use crate::text::{Span, decode::readable};

use super::ast::*;

/// A block that fits the grammar but means nothing.
pub type Refusal = Problem;

type Refused<T> = Result<T, ParseError<u32, Tok, Refusal>>;

fn refuse<T>(span: Span, fault: Fault) -> Refused<T> {
    Err(ParseError::User { error: fault.among(span) })
}

/// Functions of formulas.
const FUNCTIONS: &[(&str, Function)] = &[
    ("SQRT", Function::Sqrt),
    ("SIN", Function::Sin),
    ("COS", Function::Cos),
    ("TAN", Function::Tan),
    ("ASIN", Function::Asin),
    ("ACOS", Function::Acos),
    ("ATAN", Function::Atan),
    ("ABS", Function::Abs),
    ("INT", Function::Int),
    ("ROUND", Function::Round),
    ("LN", Function::Ln),
    ("EXP", Function::Exp),
];

/// The block under construction, and its text.
#[derive(Debug)]
pub struct Build<'a> {
    text: &'a [u8],
    block: &'a mut Block,
}

impl<'a> Build<'a> {
    pub fn new(text: &'a [u8], block: &'a mut Block) -> Build<'a> {
        Build { text, block }
    }

    pub fn set(&mut self, stmt: Stmt) {
        self.block.stmt = stmt;
    }

    fn shown(&self, span: Span) -> String {
        readable(span.of(self.text)).into_owned()
    }

    // Words.

    pub fn literal(&mut self, word: turning::Word, start: u32, end: u32) {
        let value = Value::Number { value: word.value, whole: word.whole };
        self.block.words.push(Word { address: word.address, value, span: Span { start, end } });
    }

    /// A word whose address is a run of letters without a number.
    pub fn word(&mut self, value: Value, start: u32, name_end: u32, end: u32) -> Refused<()> {
        let name = Span { start, end: name_end };
        let Some(address) = turning::address(name.of(self.text)) else {
            return refuse(name, codes::P1001::is_no_address(&self.shown(name)));
        };
        self.block.words.push(Word { address, value, span: Span { start, end } });
        Ok(())
    }

    pub fn text(&self, start: u32, end: u32) -> Value {
        Value::Text(Span { start: start + 1, end: end - 1 })
    }

    /// `V5=…`
    pub fn target(&self, word: turning::Word, start: u32, end: u32) -> Refused<VarRef> {
        match real_variable(word) {
            Some(var) => Ok(var),
            None => {
                let span = Span { start, end };
                refuse(span, codes::P1001::cannot_stand_in_front(&self.shown(span)))
            }
        }
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

    pub fn variable(&mut self, var: VarRef, start: u32, end: u32) {
        self.op(Op::Var(var, Span { start, end }));
    }

    /// `V5` in a formula.
    pub fn word_value(&mut self, word: turning::Word, start: u32, end: u32) -> Refused<()> {
        let span = Span { start, end };
        match real_variable(word) {
            Some(var) => {
                self.op(Op::Var(var, span));
                Ok(())
            }
            None => refuse(span, codes::P1001::is_no_value_2(&self.shown(span))),
        }
    }

    /// A function with its arguments on the stack.
    pub fn call(&mut self, count: u32, start: u32, name_end: u32, end: u32) -> Refused<()> {
        let name = self.shown(Span { start, end: name_end }).to_ascii_uppercase();
        let span = Span { start, end };
        let known = FUNCTIONS.iter().find(|(known, _)| *known == name);
        let op = match (known, name.as_str()) {
            (Some(&(_, f)), _) if count == 1 => Op::Unary(f),
            (None, "SQRTA") if count == 2 => Op::Binary(Operator::RootOfSum),
            (None, "SQRTS") if count == 2 => Op::Binary(Operator::RootOfDifference),
            (Some(_), _) | (None, "SQRTA" | "SQRTS") => {
                return refuse(span, codes::P1001::takes_another_number_of_values(&name));
            }
            (None, "PARA") => {
                return refuse(span, codes::T9003::para_parameter_of_machine_is_not_supported());
            }
            _ => return refuse(span, codes::T9003::function_is_not_supported(&name)),
        };
        self.op(op);
        Ok(())
    }

    /// A keyword that begins no statement that is supported.
    pub fn keyword(&mut self, start: u32, end: u32) {
        self.block.stmt = Stmt::Refused(Span { start, end });
    }
}

/// `V5`
fn real_variable(word: turning::Word) -> Option<VarRef> {
    let number = word.value;
    let plain = word.address.addr.letter() == Some(b'V') && word.whole && number <= 99_999.0;
    plain.then_some(VarRef { kind: VarKind::Real, number: number as u32 })
}
