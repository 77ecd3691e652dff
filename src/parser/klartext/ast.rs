//! A Klartext block as data. No borrows: names are spans into the text of the block.

use crate::lexer::klartext::{PatternKind, QKind, QRef, Value};
use crate::machine::{Axis, Unit};
use crate::text::Span;

pub use crate::lexer::formula::{Function, Operator};
pub use crate::lexer::klartext::FkHead;

/// One block. Reused from block to block, so that reading allocates nothing.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Block {
    pub number: Option<u32>,
    /// A `/` stands before the block.
    pub skip: bool,
    pub stmt: Stmt,
    /// The block from its first word to its last.
    pub span: Span,
    /// Text of the comment, without `;`.
    pub comment: Option<Span>,
    /// Words in order.
    pub words: Vec<Word>,
    /// Formulas of the block in postfix order.
    pub ops: Vec<Op>,
}

impl Block {
    pub fn clear(&mut self) {
        self.number = None;
        self.skip = false;
        self.stmt = Stmt::Empty;
        self.span = Span::default();
        self.comment = None;
        self.words.clear();
        self.ops.clear();
    }
}

/// What a block does.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Stmt {
    /// Comment, structure block, or nothing.
    #[default]
    Empty,
    /// Cannot be read; was reported.
    Bad,
    Begin {
        name: Span,
        unit: Option<Unit>,
    },
    End {
        name: Span,
        unit: Option<Unit>,
    },
    /// `BLK FORM 0.1`, `0.2` or a word such as CYLINDER.
    BlkForm,
    ToolDef,
    ToolCall,
    Path(PathFn),
    /// Positioning block without a function word: `X+50 R0 F200`.
    Paraxial,
    /// Only M functions or a feed.
    Functions,
    Stop,
    Pole,
    Rounding,
    Chamfer,
    Approach,
    Fk(FkHead),
    /// `LN` or `SPL`.
    Surface,
    Iso,
    Label(LabelRef),
    CallLabel {
        label: LabelRef,
        repeat: Option<Repeat>,
    },
    CallProgram(Span),
    SelectProgram(Span),
    CallSelected,
    /// `Q1 = …`
    Assign(QRef),
    AssignText(QRef),
    /// `FN n: Q… = …` with the result in the formula.
    Fn {
        number: u32,
        target: QRef,
    },
    /// FN 9 to 12.
    If {
        number: u32,
        test: Test,
        target: LabelRef,
    },
    /// FN 18: words `ID`, `NR`, `IDX`.
    SystemRead(QRef),
    /// FN 14 and up: the number and the rest of the block.
    FnOther {
        number: u32,
        rest: Span,
    },
    Cycle {
        number: u32,
        part: Option<u32>,
    },
    CycleCall(CallKind),
    Transform(Transform),
    PlaneReset(Span),
    /// Its words are the patterns, each followed by its data.
    PatternDef,
    /// Recognized and refused; the span is the rest of the block.
    Refused(Refused, Span),
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PathFn {
    /// `L`
    Line,
    /// `C`: arc about the pole.
    Circle,
    /// `CR`: arc by radius.
    CircleRadius,
    /// `CT`: tangential arc.
    CircleTangent,
    /// `LP`: line to a polar end.
    LinePolar,
    /// `CP`: arc about the pole by angle.
    CirclePolar,
    /// `CTP`: tangential arc to a polar end.
    TangentPolar,
}

impl PathFn {
    pub fn word(self) -> &'static str {
        match self {
            PathFn::Line => "L",
            PathFn::Circle => "C",
            PathFn::CircleRadius => "CR",
            PathFn::CircleTangent => "CT",
            PathFn::LinePolar => "LP",
            PathFn::CirclePolar => "CP",
            PathFn::TangentPolar => "CTP",
        }
    }

    pub fn is_arc(self) -> bool {
        !matches!(self, PathFn::Line | PathFn::LinePolar)
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CallKind {
    Here,
    /// `CYCL CALL POS`
    At,
    /// `CYCL CALL PAT`
    Pattern,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Transform {
    Datum,
    Mirror,
    Rotation,
    Scale,
}

/// Statements that are known by name only.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Refused {
    Plane,
    TouchProbe,
    Pattern,
    SelectTable,
    Contour,
    Function,
    GlobalDef,
}

/// A label: its number, its name in quotes, or a parameter that holds either.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LabelRef {
    Number(u32),
    Name(Span),
    Param(QRef),
}

/// `REP 3`, `REP 3/2`, `REPQ9`, `REP` alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Repeat {
    Empty,
    Count(f64),
    Param(QRef),
}

/// The condition of FN 9 to 12.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Test {
    Compare {
        relation: Relation,
        left: Operand,
        right: Operand,
    },
    /// `IS DEFINED`, or `IS UNDEFINED` for false.
    Defined {
        q: QRef,
        defined: bool,
    },
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Relation {
    Equal,
    NotEqual,
    Greater,
    Less,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Operand {
    Number(f64),
    Param { negative: bool, q: QRef },
    Text(Span),
}

/// One step of a formula in postfix order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Op {
    Number(f64),
    Param(QRef),
    Text(Span),
    Unary(Function),
    Binary(Operator),
    /// Function of texts; its arguments were pushed in the order of [`TextFn`].
    TextFn(TextFn),
    /// Joins two texts.
    Join,
    /// `-a^b` or `a^b^c` was written at the span.
    DoubtfulPower(Span),
}

/// Functions on texts. Their arguments are pushed in the order in which they are named here.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TextFn {
    /// `TOCHAR ( DAT+Q50 DECIMALS3 )`
    ToChar,
    /// `TONUMB ( SRC_QS11 )`
    ToNumber,
    /// `SUBSTR ( SRC_QS10 BEG2 LEN4 )`
    Substring,
    /// `INSTR ( SRC_QS10 SEA_QS13 BEG2 )`
    Find,
    /// `STRLEN ( SRC_QS15 )`
    Length,
    /// `STRCOMP ( SRC_QS12 SEA_QS14 )`
    Compare,
    /// Reads from the control.
    Unknown,
}

/// A word of a block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Word {
    pub addr: Addr,
    pub value: Value,
    pub span: Span,
}

/// What a word is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Addr {
    /// A pattern of PATTERN DEF with its data: `POS1 (X+12 Y+20)`.
    Pattern(PatternKind),
    /// D, NUM, ROT and the like in its data.
    PatternWord(PatternWord),
    Axis {
        axis: Axis,
        incremental: bool,
    },
    /// PR
    PolarRadius {
        incremental: bool,
    },
    /// PA
    PolarAngle {
        incremental: bool,
    },
    /// `R` with a value; unsigned 0 is the compensation word R0.
    Radius {
        signed: bool,
    },
    /// `R` alone: unchanged.
    RadiusEmpty,
    CompLeft,
    CompRight,
    ParaxialPlus,
    ParaxialMinus,
    TurnPlus,
    TurnMinus,
    Feed,
    FeedMax,
    FeedAuto,
    /// `F` alone: unchanged.
    FeedEmpty,
    /// FU
    FeedPerRev,
    /// FZ, FT, FMAXT
    FeedOther,
    /// S
    Speed,
    /// `S( VC = 120 )`
    CuttingSpeed,
    /// `L` with a value (TOOL DEF)
    Length,
    DeltaLength,
    DeltaRadius,
    DeltaRadius2,
    /// M function by number.
    M(u32),
    /// `M` alone.
    MEmpty,
    /// A number or parameter without an address.
    Value,
    /// A name; `glued` parameter in the value where one follows at once.
    Name,
    Text,
    /// `#`
    Hash,
    /// `/`
    Slash,
    /// `:`
    Colon,
    /// `Q200=`; its value follows in the word.
    Assign(QRef),
    /// `QS500=`
    AssignText(QRef),
}

impl Addr {
    /// Is this a word that gives a position?
    pub fn is_axis(self) -> bool {
        matches!(self, Addr::Axis { .. })
    }
}

impl QRef {
    pub fn is_text(self) -> bool {
        self.kind == QKind::Qs
    }
}

/// What the data of a pattern say besides its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PatternWord {
    D,
    Dx,
    Dy,
    Num,
    NumX,
    NumY,
    Rot,
    RotX,
    RotY,
    Start,
    Step,
    End,
}

impl PatternWord {
    const ALL: [PatternWord; 12] = {
        use PatternWord::{D, Dx, Dy, End, Num, NumX, NumY, Rot, RotX, RotY, Start, Step};
        [D, Dx, Dy, Num, NumX, NumY, Rot, RotX, RotY, Start, Step, End]
    };

    /// As a program writes it.
    pub fn name(self) -> &'static str {
        match self {
            PatternWord::D => "D",
            PatternWord::Dx => "DX",
            PatternWord::Dy => "DY",
            PatternWord::Num => "NUM",
            PatternWord::NumX => "NUMX",
            PatternWord::NumY => "NUMY",
            PatternWord::Rot => "ROT",
            PatternWord::RotX => "ROTX",
            PatternWord::RotY => "ROTY",
            PatternWord::Start => "START",
            PatternWord::Step => "STEP",
            PatternWord::End => "END",
        }
    }

    pub fn named(name: &[u8]) -> Option<PatternWord> {
        PatternWord::ALL.into_iter().find(|word| name.eq_ignore_ascii_case(word.name().as_bytes()))
    }
}
