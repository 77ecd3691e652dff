//! Tokens of HEIDENHAIN Klartext.
//!
//! Numbers may have a comma or a point, blanks may stand between address, sign and digits, keywords may
//! be written in any case. A comment and a continuation mark are tokens, so that nothing is skipped unseen.
mod tokens;
mod words;

use logos::{Lexer, Logos};

use self::words::{
    all_lines, axis, axis_letter, cycle, fn_number, fn_tail, m_number, name_q, pattern_kind, plain_number, q_ref, tail,
    value_word,
};
use crate::text::Span;

pub use self::tokens::Tokens;
pub use self::words::{AxisWord, CycleNumber, FkHead, FnTail, NameQ, PatternKind, QKind, QRef, Value, ValueWord};

type Lex<'s> = Lexer<'s, Tok>;

/// A token. Spans inside a token count from the start of the block.
#[derive(Logos, Debug, Clone, Copy, PartialEq)]
#[logos(utf8 = false)]
#[logos(subpattern number = r"([0-9]+([.,][0-9]*)?|[.,][0-9]+)")]
#[logos(subpattern value = r"[ \t]*[+\-]?[ \t]*((?&number)|[Qq][LlRr]?[0-9]+)")]
#[logos(skip(r"[ \t\r\n\x00\x0b\x0c\x1a]+"))]
pub enum Tok {
    // Statement heads.
    #[regex(r"(?i)BEGIN[ \t]+PGM", tail)]
    BeginPgm(Span),
    #[regex(r"(?i)END[ \t]+PGM", tail)]
    EndPgm(Span),
    #[regex(r"(?i)CALL[ \t]+PGM", tail)]
    CallPgm(Span),
    #[regex(r"(?i)SEL[ \t]+PGM", tail)]
    SelPgm(Span),
    #[regex(r"(?i)CALL[ \t]+SELECTED[ \t]+PGM")]
    CallSelected,
    #[regex(r"(?i)BLK[ \t]+FORM")]
    BlkForm,
    #[regex(r"(?i)TOOL[ \t]+DEF")]
    ToolDef,
    #[regex(r"(?i)TOOL[ \t]+CALL")]
    ToolCall,
    #[regex(r"(?i)CALL[ \t]+LBL")]
    CallLbl,
    #[token("LBL", ignore(case))]
    Lbl,
    #[regex(r"(?i)CYCLE?[ \t]+DEF[ \t]*[0-9]+([ \t]*\.[0-9]+)?", cycle)]
    CyclDef(CycleNumber),
    #[regex(r"(?i)CYCLE?[ \t]+CALL")]
    CyclCall,
    #[regex(r"(?i)FN[ \t]*[0-9]+[ \t]*:?", fn_number)]
    Fn(u32),
    /// FN 14 and up, but for 18: what follows has no common form.
    #[regex(r"(?i)FN[ \t]*(1[4-7]|19|[2-9][0-9]|[0-9][0-9][0-9]+)[ \t]*:?", fn_tail, priority = 50)]
    FnTail(FnTail),
    #[token("STOP", ignore(case))]
    Stop,
    #[regex(r"(?i)TRANS[ \t]+DATUM")]
    TransDatum,
    #[regex(r"(?i)TRANS[ \t]+MIRROR")]
    TransMirror,
    #[regex(r"(?i)TRANS[ \t]+ROTATION")]
    TransRotation,
    #[regex(r"(?i)TRANS[ \t]+SCALE")]
    TransScale,
    #[regex(r"(?i)PLANE[ \t]+RESET", tail)]
    PlaneReset(Span),
    #[regex(r"(?i)PLANE[ \t]+[A-Z]+", tail)]
    Plane(Span),
    #[regex(r"(?i)TCH[ \t]+PROBE", all_lines)]
    TchProbe(Span),
    #[regex(r"(?i)PATTERN[ \t]+DEF")]
    PatternDef,
    /// `POS1 (`, a pattern of PATTERN DEF.
    #[regex(r"(?i)(POS|ROW|PAT|FRAME|CIRC|PITCHCIRC)[0-9]+[ \t\r\n~]*\(", pattern_kind, priority = 60)]
    PatternKind(PatternKind),
    #[regex(r"(?i)SEL[ \t]+PATTERN", tail)]
    Pattern(Span),
    #[regex(r"(?i)SEL[ \t]+TABLE", tail)]
    SelTable(Span),
    #[regex(r"(?i)SEL[ \t]+CONTOUR", tail)]
    #[regex(r"(?i)CONTOUR[ \t]+DEF", tail)]
    #[regex(r"(?i)DECLARE[ \t]+CONTOUR", tail)]
    #[regex(r"(?i)QC[0-9]+[ \t]*=", tail, priority = 50)]
    ContourDef(Span),
    #[regex(r"(?i)DECLARE[ \t]+STRING")]
    DeclareString,
    #[token("FUNCTION", tail, ignore(case))]
    #[token("POLARKIN", tail, ignore(case))]
    #[regex(r"(?i)(TABDATA|SECTION|MONITORING|PRESET|SQL|ELSE)", tail)]
    #[regex(r"(?i)SEL[ \t]+(CYCLE|CORR-TABLE)", tail)]
    #[regex(r"(?i)OPEN[ \t]+FILE", tail)]
    #[regex(r"(?i)FIXTURE[ \t]+SELECT", tail)]
    #[regex(r"(?i)IF[ \t][^\n;]*[ \t]THEN", tail)]
    #[regex(r"(?i)(END|ELSE)[ \t]*IF", tail)]
    Function(Span),
    /// Cycle parameters for PREDEF, over all lines of the block.
    #[regex(r"(?i)GLOBAL[ \t]+DEF", all_lines)]
    GlobalDef(Span),

    // Path functions.
    #[token("L", ignore(case))]
    L,
    #[token("C", ignore(case))]
    C,
    #[token("CR", ignore(case))]
    Cr,
    #[token("CT", ignore(case))]
    Ct,
    #[token("LP", ignore(case))]
    Lp,
    #[token("CP", ignore(case))]
    Cp,
    #[token("CTP", ignore(case))]
    Ctp,
    #[token("CC", ignore(case))]
    Cc,
    #[token("RND", ignore(case))]
    Rnd,
    #[token("CHF", ignore(case))]
    Chf,
    #[token("APPR", ignore(case))]
    Appr,
    #[token("DEP", ignore(case))]
    Dep,
    #[token("FL", |_| FkHead::Line { smooth: false }, ignore(case))]
    #[token("FLT", |_| FkHead::Line { smooth: true }, ignore(case))]
    #[token("FC", |_| FkHead::Arc { smooth: false }, ignore(case))]
    #[token("FCT", |_| FkHead::Arc { smooth: true }, ignore(case))]
    #[token("FPOL", |_| FkHead::Pole, ignore(case))]
    #[token("FSELECT", |_| FkHead::Select, ignore(case))]
    Fk(FkHead),
    /// 3-D block with normal vectors, or the natural logarithm.
    #[token("LN", ignore(case))]
    Ln,
    #[token("SPL", ignore(case))]
    Spl,
    /// DIN/ISO word.
    #[regex(r"(?i)G[0-9]+", priority = 30)]
    G,

    // Words.
    #[regex(r"(?i)I?[XYZUVWABC](?&value)", axis, priority = 40)]
    Axis(AxisWord),
    #[regex(r"(?i)I?[XYZUVWAB]", axis_letter, priority = 20)]
    AxisLetter(AxisWord),
    #[regex(r"(?i)I?PR(?&value)", value_word, priority = 40)]
    Pr(ValueWord),
    #[regex(r"(?i)I?PA(?&value)", value_word, priority = 40)]
    Pa(ValueWord),
    #[regex(r"(?i)F(?&value)", value_word, priority = 40)]
    F(ValueWord),
    #[regex(r"(?i)F[ \t]*MAX", priority = 40)]
    FMax,
    #[regex(r"(?i)F[ \t]*AUTO", priority = 40)]
    FAuto,
    #[regex(r"(?i)FU(?&value)", value_word, priority = 41)]
    Fu(ValueWord),
    #[regex(r"(?i)FZ(?&value)", value_word, priority = 41)]
    #[regex(r"(?i)FT(?&value)", value_word, priority = 41)]
    #[regex(r"(?i)F[ \t]*MAXT(?&value)", value_word, priority = 42)]
    FOther(ValueWord),
    #[token("F", priority = 20, ignore(case))]
    FBare,
    #[regex(r"(?i)R(?&value)", value_word, priority = 40)]
    R(ValueWord),
    #[token("RL", ignore(case))]
    Rl,
    #[token("RR", ignore(case))]
    Rr,
    #[token("R+", ignore(case))]
    RPlus,
    #[token("R-", ignore(case))]
    RMinus,
    #[token("R", priority = 20, ignore(case))]
    RBare,
    #[regex(r"(?i)DR[ \t]*\+")]
    DrPlus,
    #[regex(r"(?i)DR[ \t]*-")]
    DrMinus,
    #[regex(r"(?i)DR(?&value)", value_word, priority = 40)]
    Dr(ValueWord),
    #[regex(r"(?i)DR2[ \t]*[+\-][ \t]*((?&number)|Q[LR]?[0-9]+)", value_word, priority = 41)]
    #[regex(r"(?i)DR2[ \t]+(?&number)", value_word, priority = 41)]
    #[regex(r"(?i)DR2[ \t]*Q[LR]?[0-9]+", value_word, priority = 41)]
    Dr2(ValueWord),
    #[regex(r"(?i)DL(?&value)", value_word, priority = 40)]
    Dl(ValueWord),
    #[regex(r"(?i)L[ \t]*[+\-]?[ \t]*(?&number)", value_word, priority = 40)]
    LWord(ValueWord),
    #[regex(r"(?i)S(?&value)", value_word, priority = 40)]
    S(ValueWord),
    /// `S( VC = 120 )`
    #[regex(r"(?i)S[ \t]*\([ \t]*VC[^)\n;]*\)", priority = 45)]
    SCut,
    #[regex(r"(?i)M[ \t]*[0-9]+\.?", m_number, priority = 40)]
    M(u32),
    #[token("M", priority = 20, ignore(case))]
    MBare,

    // Parameters, numbers, texts, names.
    #[regex(r"(?i)Q[0-9]+", q_ref, priority = 40)]
    #[regex(r"(?i)QL[0-9]+", q_ref, priority = 40)]
    #[regex(r"(?i)QR[0-9]+", q_ref, priority = 40)]
    Q(QRef),
    #[regex(r"(?i)QS[0-9]+", q_ref, priority = 40)]
    Qs(QRef),
    #[regex(r"(?&number)", plain_number, priority = 10)]
    Number(f64),
    #[regex(r#""[^"\n]*""#)]
    Text,
    /// A name, or a word of a cycle in any language.
    #[regex(r"[A-Za-z_\x80-\xff][A-Za-z_.\x80-\xff]*(-[A-Za-z_\x80-\xff][A-Za-z_.\x80-\xff]*)*", priority = 1)]
    #[regex(r"(?i)P[123][XYZ]", priority = 30)]
    #[regex(r"(?i)CLSD[ \t]*[+\-]", priority = 30)]
    Name,
    /// A name directly followed by a parameter: `REPQ9`, `IDXQ11`.
    #[regex(r"(?i)[A-Z_]+Q[LRS]?[0-9]+", name_q, priority = 5)]
    NameQ(NameQ),

    // Formulas and jumps.
    #[token("=")]
    Equals,
    #[token("+")]
    Plus,
    #[token("-")]
    Minus,
    #[token("*")]
    Star,
    #[token("/")]
    Slash,
    #[token("^")]
    Caret,
    #[token("%")]
    Percent,
    #[token("(")]
    Open,
    #[token(")")]
    Close,
    #[token(":")]
    Colon,
    #[token("#")]
    Hash,
    #[token("||")]
    Join,
    #[token("IF", ignore(case))]
    If,
    #[token("GOTO", ignore(case))]
    Goto,
    #[token("EQU", ignore(case))]
    Equ,
    #[token("NE", ignore(case))]
    #[token("NEQ", ignore(case))]
    Ne,
    #[token("GT", ignore(case))]
    Gt,
    #[token("LT", ignore(case))]
    Lt,
    #[token("IS", ignore(case))]
    Is,
    #[token("DEFINED", ignore(case))]
    Defined,
    #[token("UNDEFINED", ignore(case))]
    Undefined,
    #[token("REP", ignore(case))]
    Rep,
    #[token("DIV", ignore(case))]
    Div,
    #[token("LEN", ignore(case))]
    Len,
    #[token("ANG", ignore(case))]
    Ang,
    #[token("SIN", ignore(case))]
    Sin,
    #[token("COS", ignore(case))]
    Cos,
    #[token("TAN", ignore(case))]
    Tan,
    #[token("ASIN", ignore(case))]
    Asin,
    #[token("ACOS", ignore(case))]
    Acos,
    #[token("ATAN", ignore(case))]
    Atan,
    #[token("SQ", ignore(case))]
    Sq,
    #[token("SQRT", ignore(case))]
    Sqrt,
    #[token("LOG", ignore(case))]
    Log,
    #[token("EXP", ignore(case))]
    Exp,
    #[token("NEG", ignore(case))]
    Neg,
    #[token("INT", ignore(case))]
    Int,
    #[token("ABS", ignore(case))]
    Abs,
    #[token("FRAC", ignore(case))]
    Frac,
    #[token("SGN", ignore(case))]
    Sgn,
    #[token("PI", ignore(case))]
    Pi,

    /// A parameter by name, `{Depth}`.
    #[regex(r"\{[^{}\n;]*\}")]
    Named,

    #[regex(b";[^\n]*", allow_greedy = true)]
    Comment,
    #[token("~")]
    Tilde,
    /// A byte that belongs nowhere.
    Bad,
}
