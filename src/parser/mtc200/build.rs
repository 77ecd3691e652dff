//! What the grammar's actions write into: the block under construction.

use lalrpop_util::ParseError;

use crate::diag::codes;
use crate::lexer::mtc200::{LetterNumber, Tok};
use crate::parser::problem::Problem;
use crate::parser::symbols::{Symbol, Symbols};
use crate::text::{Span, decode::readable};

use super::ast::*;

/// A block that fits the grammar but means nothing.
pub type Refusal = Problem;

type Refused<T> = Result<T, ParseError<u32, Tok, Refusal>>;

/// Largest number in front of `=`.
const MOST_NUMBER: f64 = 999.0;

/// The block under construction, and its text.
#[derive(Debug)]
pub struct Build<'a> {
    text: &'a [u8],
    block: &'a mut Block,
    symbols: &'a mut Symbols,
}

impl<'a> Build<'a> {
    pub fn new(text: &'a [u8], block: &'a mut Block, symbols: &'a mut Symbols) -> Build<'a> {
        Build { text, block, symbols }
    }

    /// The symbol of a name in the block.
    pub fn name(&mut self, start: u32, end: u32) -> Symbol {
        self.symbols.intern(Span { start, end }.of(self.text))
    }

    pub fn word(&mut self, target: Target, value: Value, start: u32, end: u32) {
        self.block.words.push(Word { target, value, span: Span { start, end } });
    }

    pub fn literal(&mut self, n: LetterNumber, start: u32, end: u32) {
        self.word(Target::Letter(n.letter), Value::Literal(n.value), start, end);
    }

    /// `S1=`: letter and number in front of `=`.
    pub fn numbered(&mut self, n: LetterNumber, start: u32, end: u32) -> Refused<Target> {
        if n.plain && n.value.fract() == 0.0 && n.value <= MOST_NUMBER {
            return Ok(Target::Numbered(n.letter, n.value as u32));
        }
        let span = Span { start, end };
        let text = readable(span.of(self.text)).into_owned();
        let error = codes::P1001::cannot_stand_in_front(&text).among(span);
        Err(ParseError::User { error: error.help("write the letter alone: X=@050") })
    }

    /// `BNE .LOOP`: the label without its point.
    pub fn jump(&mut self, start: u32, name_end: u32, label: u32, end: u32) {
        let name = self.name(start, name_end);
        let label = self.name(label + 1, end);
        self.word(Target::Name(name), Value::Label(label), start, end);
    }

    pub fn op_start(&mut self) -> u32 {
        self.block.ops.len() as u32
    }

    pub fn op(&mut self, op: Op) {
        self.block.ops.push(op);
    }

    pub fn formula(&mut self, from: u32) -> Value {
        Value::Formula(Formula { from, to: self.block.ops.len() as u32 })
    }
}
