//! A SINUMERIK block as data. No borrows: names are symbols, texts are spans into the block.

use crate::parser::symbols::Symbol;
use crate::text::Span;

/// One block. Reused from block to block, so that reading plain blocks allocates nothing.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Block {
    /// `N10`, or `:10` for a main block.
    pub number: Option<u32>,
    /// `/` is level 0, `/1` level 1 …
    pub skip: Option<u8>,
    pub label: Option<Symbol>,
    pub stmt: Stmt,
    /// The block from its first word to its last.
    pub span: Span,
    /// Text of the comment, without `;`.
    pub comment: Option<Span>,
    /// Words in order.
    pub words: Vec<Word>,
    /// Formulas of the block in postfix order.
    pub ops: Vec<Op>,
    /// Argument formulas of calls; a call has a range of them.
    pub args: Vec<Formula>,
    /// Conditions and jumps of IF and CASE.
    pub arms: Vec<Arm>,
    /// Variables of DEF, parameters of PROC and EXTERN.
    pub variables: Vec<Variable>,
    /// LLI and ULI of DEF.
    pub limits: [Option<f64>; 2],
}

impl Block {
    pub fn clear(&mut self) {
        self.number = None;
        self.skip = None;
        self.label = None;
        self.stmt = Stmt::Empty;
        self.span = Span::default();
        self.comment = None;
        self.words.clear();
        self.ops.clear();
        self.args.clear();
        self.arms.clear();
        self.variables.clear();
        self.limits = [None; 2];
    }

    /// The operations of a formula.
    pub fn formula(&self, formula: Formula) -> &[Op] {
        self.ops.get(formula.from as usize..formula.to as usize).unwrap_or_default()
    }

    /// The arguments of a call.
    pub fn arguments(&self, args: Args) -> &[Formula] {
        self.args.get(args.from as usize..(args.from + args.count) as usize).unwrap_or_default()
    }
}

/// A range of `Block::ops`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Formula {
    pub from: u32,
    pub to: u32,
    pub span: Span,
}

impl Formula {
    /// An omitted argument.
    pub fn is_missing(self) -> bool {
        self.from == self.to
    }
}

/// A range of `Block::args`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Args {
    pub from: u32,
    pub count: u32,
}

/// What a block does.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Stmt {
    /// Comment, label or nothing.
    #[default]
    Empty,
    /// Cannot be read; was reported.
    Bad,
    /// `%_N_NAME_MPF` or `;$PATH=`: belongs to the file, not to the program.
    Header,
    /// Words: motions, functions, assignments, calls by name.
    Words,
    /// `IF c` with a jump in the same block, perhaps several.
    IfJump,
    If(Formula),
    Else,
    EndIf,
    While(Formula),
    EndWhile,
    /// `FOR v = a TO b`
    For {
        variable: Target,
        from: Formula,
        to: Formula,
    },
    EndFor,
    Loop,
    EndLoop,
    /// REPEAT without a label.
    RepeatLoop,
    Until(Formula),
    /// `REPEAT L1 L2 P=n`
    Repeat {
        from: Symbol,
        to: Option<Symbol>,
        times: Option<Formula>,
    },
    /// `REPEATB L P=n`
    RepeatBlock {
        label: Symbol,
        times: Option<Formula>,
    },
    Goto(Jump),
    /// `GOTOS`: back to the start if the PLC asks for it.
    GotoStart,
    /// `CASE (e) OF … `; the arms hold constants and jumps, the default last.
    Case(Formula),
    /// The variables are in `variables`.
    Def {
        kind: TypeName,
        /// Length of a STRING.
        length: Option<Formula>,
        /// NCK or CHAN.
        global: bool,
    },
    /// Its parameters are in `variables`, its attributes are words of the block.
    Proc(Symbol),
    Extern(Symbol),
    /// `DEFINE NAME AS words`: the part behind DEFINE.
    Define(Span),
    Redef(Span),
    Call(CallForm),
    Sync(Span),
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CallForm {
    /// `CALL "NAME"`, `CALL variable`
    Text(Formula),
    /// `CALL [NAME] BLOCK L1 TO L2`
    Section {
        program: Option<Formula>,
        from: Symbol,
        to: Symbol,
    },
    /// `PCALL path(args)`
    Path {
        path: Span,
        args: Args,
    },
    /// `MCALL NAME(args)`
    Modal {
        name: Symbol,
        args: Args,
    },
    ModalOff,
    /// `EXTCALL("NAME")`
    External(Formula),
    Iso,
}

/// Where a jump searches.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Search {
    Forward,
    Backward,
    /// Forward first, then backward.
    Both,
    /// The same, and no error if nothing is found.
    BothQuiet,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jump {
    pub search: Search,
    pub target: JumpTarget,
    pub span: Span,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum JumpTarget {
    Label(Symbol),
    /// A block number, with or without `N`.
    Number(u32),
    /// A text that is computed.
    Text(Formula),
    /// GOTOS: the start of the program, where the machine asks for it.
    Start,
}

/// `IF c GOTOF L`, `10 GOTOF L` of a CASE, or its DEFAULT.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arm {
    pub when: When,
    pub jump: Jump,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum When {
    Condition(Formula),
    Constant(i64),
    Default,
}

pub use crate::lexer::formula::{Function, Operator};
pub use crate::lexer::sinumerik::TypeName;

/// A variable of DEF or a parameter of PROC.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Variable {
    /// EXTERN parameters have no name.
    pub name: Option<Symbol>,
    pub kind: TypeName,
    pub by_reference: bool,
    /// Length of a STRING parameter.
    pub length: Option<Formula>,
    /// Sizes of an array, as formulas in `args`.
    pub sizes: Args,
    /// `[]` without a size, in parameters.
    pub open: bool,
    /// Start value.
    pub value: Option<Formula>,
    pub span: Span,
}

/// A word of a block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Word {
    pub target: Target,
    pub value: Value,
    pub span: Span,
}

/// What a word is about, as written: what it means is decided by the tables of the resolver.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Target {
    /// `X`, `G`, `R` …, upper case.
    Letter(u8),
    /// `S2=`, `X1=`, `M3=`, `R5=`, `A0=`: letter and number in front of `=`.
    Numbered(u8, u32, Symbol),
    /// `CR=`, a variable, a keyword, a program.
    Name(Symbol),
    /// `$P_UIFR`
    System(Symbol),
    /// Any of them with an index: `R[…]`, `AX[…]`, `A[1,2]`.
    Indexed(Base, Args),
}

/// The part of an indexed target in front of its bracket.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Base {
    Letter(u8),
    Name(Symbol),
    System(Symbol),
}

/// What a word says.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Value {
    /// A bare word.
    None,
    /// A literal behind a single letter: `X10`, `G01`, `L001` (the digits tell `L1` from `L01`).
    Literal { value: f64, whole: bool, digits: u8 },
    /// `= formula`
    Formula(Formula),
    /// `NAME(…)`
    Call(Args),
}

/// One step of a formula in postfix order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Op {
    Real(f64),
    Int(i64),
    Bool(bool),
    Char(u8),
    Text(Span),
    /// A variable, an axis name, a constant.
    Name(Symbol, Span),
    /// R parameter by number.
    R(u32, Span),
    System(Symbol, Span),
    /// Takes its indices from the stack.
    Index(Base, u32, Span),
    /// Takes its arguments from the stack.
    Call(Symbol, u32, Span),
    /// An omitted argument.
    Missing,
    /// `(a, b, c)`
    List(u32),
    Unary(Function),
    Binary(Operator),
    /// A leading `<<`.
    ToText,
    /// `<<` between two values.
    Join,
    /// `:` of frames.
    Chain,
}
