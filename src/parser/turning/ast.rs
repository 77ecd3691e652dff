//! A block of a HEIDENHAIN turning program as data. No borrows: texts are spans into the block.

use crate::text::Span;

pub use super::sections::Section;
pub use crate::lexer::formula::{Function, Operator};
pub use crate::lexer::turning::{Addr, Address, VarKind, VarRef};

/// One block. Reused from block to block, so that reading plain blocks allocates nothing.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Block {
    /// `N10`
    pub number: Option<u32>,
    /// `/` is level 0, `/1` level 1 …
    pub skip: Option<u8>,
    /// `$1` in front of the block: the slide that it is for; of several one that is not 1.
    pub slide: Option<u32>,
    pub stmt: Stmt,
    /// The block from its first word to its last.
    pub span: Span,
    /// Text of the comment, without its brackets.
    pub comment: Option<Span>,
    /// Words in order.
    pub words: Vec<Word>,
    /// Formulas of the block in postfix order.
    pub ops: Vec<Op>,
}

impl Block {
    pub fn clear(&mut self) {
        self.number = None;
        self.skip = None;
        self.slide = None;
        self.stmt = Stmt::Empty;
        self.span = Span::default();
        self.comment = None;
        self.words.clear();
        self.ops.clear();
    }

    /// The operations of a formula.
    pub fn formula(&self, formula: Formula) -> &[Op] {
        self.ops.get(formula.from as usize..formula.to as usize).unwrap_or_default()
    }
}

/// A range of `Block::ops`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Formula {
    pub from: u32,
    pub to: u32,
    pub span: Span,
}

/// What a block does.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Stmt {
    /// Comment or nothing.
    #[default]
    Empty,
    /// Cannot be read; was reported.
    Bad,
    /// `%name.nc`
    Program(Span),
    /// `#KEY value`
    Head {
        key: Span,
        value: Span,
    },
    /// A section code, and what stands behind it.
    Section(Section, Span),
    /// `UNIT ID"…"`
    Unit,
    /// `END_OF_UNIT`
    EndUnit,
    /// Words: functions with their parameters.
    Words,
    /// `#1=…`
    Assign(VarRef, Formula),
    If(Formula),
    Else,
    EndIf,
    While(Formula),
    EndWhile,
    Switch(Formula),
    Case(Formula),
    Default,
    Break,
    EndSwitch,
    /// `$1`: which slide executes what follows.
    Slide(u32),
    /// A keyword that is known and not supported.
    Refused(Span),
}

/// A word of a block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Word {
    pub address: Address,
    pub value: Value,
    pub span: Span,
}

/// What a word says.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Value {
    /// A literal; `whole` if written with digits only.
    Number {
        value: f64,
        whole: bool,
    },
    /// `?`: to be found from the neighbouring elements.
    Unknown,
    Formula(Formula),
    /// Between quotes.
    Text(Span),
}

/// One step of a formula in postfix order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Op {
    Number(f64),
    Var(VarRef, Span),
    Unary(Function),
    Binary(Operator),
}
