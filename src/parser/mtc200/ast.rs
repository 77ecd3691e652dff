//! An MTC200 block as data. No borrows: names are symbols, texts are spans into the block.

use crate::parser::symbols::Symbol;
use crate::text::Span;

pub use crate::lexer::formula::{Function, Operator};

/// One block. Reused from block to block, so that reading plain blocks allocates nothing.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Block {
    /// `N10`
    pub number: Option<u32>,
    /// `/` in front.
    pub skip: bool,
    /// `.LOOP`
    pub label: Option<Symbol>,
    pub stmt: Stmt,
    /// The block from its first word to its last.
    pub span: Span,
    /// Texts of the comments, without their signs.
    pub comments: Vec<Span>,
    /// Words in order.
    pub words: Vec<Word>,
    /// Formulas of the block in postfix order.
    pub ops: Vec<Op>,
}

impl Block {
    pub fn clear(&mut self) {
        self.number = None;
        self.skip = false;
        self.label = None;
        self.stmt = Stmt::Empty;
        self.span = Span::default();
        self.comments.clear();
        self.words.clear();
        self.ops.clear();
    }

    /// The operations of a formula.
    pub fn formula(&self, formula: Formula) -> &[Op] {
        self.ops.get(formula.from as usize..formula.to as usize).unwrap_or_default()
    }
}

/// What a block is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Stmt {
    /// Comment, label or nothing.
    #[default]
    Empty,
    /// Cannot be read; was reported.
    Bad,
    /// A line of the file header; its first byte.
    Header(u8),
    Words,
}

/// A range of `Block::ops`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Formula {
    pub from: u32,
    pub to: u32,
}

/// A word of a block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Word {
    pub target: Target,
    pub value: Value,
    pub span: Span,
}

/// What stands in front of the value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Target {
    /// `X`, `G` …, upper case.
    Letter(u8),
    /// `S1=`: letter and number in front of `=`.
    Numbered(u8, u32),
    /// `CF`, `RET`, a word of the machine.
    Name(Symbol),
    /// `@050=`
    Variable(u32),
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Value {
    /// A name alone.
    None,
    Literal(f64),
    Formula(Formula),
    /// The label of a jump.
    Label(Symbol),
}

/// A step of a formula.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Op {
    Number(f64),
    Variable(u32, Span),
    Unary(Function),
    Binary(Operator),
}
