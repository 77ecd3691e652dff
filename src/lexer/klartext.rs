//! Tokens of HEIDENHAIN Klartext.
//!
//! Numbers may have a comma or a point, blanks may stand between address, sign and digits, keywords may
//! be written in any case. A comment and a continuation mark are tokens, so that nothing is skipped unseen.

use logos::{Lexer, Logos};

use crate::machine::axis::Axis;
use crate::text::{Span, number::decimal};

/// A kind of parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum QKind {
    /// Global.
    Q,
    /// Local to a program.
    Ql,
    /// Kept over power-off.
    Qr,
    /// Text.
    Qs,
}

impl QKind {
    pub fn prefix(self) -> &'static str {
        match self {
            QKind::Q => "Q",
            QKind::Ql => "QL",
            QKind::Qr => "QR",
            QKind::Qs => "QS",
        }
    }
}

/// A parameter by kind and number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct QRef {
    pub kind: QKind,
    pub number: u32,
}

impl std::fmt::Display for QRef {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}{}", self.kind.prefix(), self.number)
    }
}

/// What stands behind an address.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Value {
    /// Nothing.
    #[default]
    None,
    Number(f64),
    /// A parameter with its sign.
    Param {
        negative: bool,
        q: QRef,
    },
    /// FMAX as the value of a cycle parameter.
    FeedMax,
    /// FAUTO as the value of a cycle parameter.
    FeedAuto,
}

/// An axis word such as `IX-10.5` or `Y+Q3`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxisWord {
    pub axis: Axis,
    pub incremental: bool,
    pub value: Value,
}

/// A word with a value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ValueWord {
    pub incremental: bool,
    pub value: Value,
    /// A sign is written: `R+0` is a radius, `R0` a compensation.
    pub signed: bool,
}

/// A dotted cycle number: `CYCL DEF 7.1` is cycle 7, part 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CycleNumber {
    pub number: u32,
    pub part: Option<u32>,
    /// Written `CYCLE DEF`.
    pub misspelled: bool,
    /// The rest of the block where it is a name of a file (cycle 12).
    pub rest: Span,
}

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
    #[regex(r"(?i)TCH[ \t]+PROBE", tail)]
    TchProbe(Span),
    #[regex(r"(?i)PATTERN[ \t]+DEF", all_lines)]
    PatternDef(Span),
    #[regex(r"(?i)SEL[ \t]+PATTERN", tail)]
    Pattern(Span),
    #[regex(r"(?i)SEL[ \t]+TABLE", tail)]
    SelTable(Span),
    #[regex(r"(?i)SEL[ \t]+CONTOUR", tail)]
    #[regex(r"(?i)CONTOUR[ \t]+DEF", tail)]
    #[regex(r"(?i)DECLARE[ \t]+CONTOUR", tail)]
    ContourDef(Span),
    #[regex(r"(?i)DECLARE[ \t]+STRING")]
    DeclareString,
    #[token("FUNCTION", tail, ignore(case))]
    #[token("POLARKIN", tail, ignore(case))]
    #[regex(r"(?i)(TABDATA|SECTION|MONITORING|PRESET)", tail)]
    Function(Span),

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
    #[token("FL", ignore(case))]
    #[token("FLT", ignore(case))]
    #[token("FC", ignore(case))]
    #[token("FCT", ignore(case))]
    #[token("FPOL", ignore(case))]
    #[token("FSELECT", ignore(case))]
    Fk,
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

    #[regex(b";[^\n]*", allow_greedy = true)]
    Comment,
    #[token("~")]
    Tilde,
    /// A byte that belongs nowhere.
    Bad,
}

/// An FN block that is read by its number only.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FnTail {
    pub number: u32,
    pub rest: Span,
}

/// A name and the parameter glued to it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NameQ {
    /// Length of the name in bytes.
    pub name: u32,
    pub q: QRef,
}

type Lex<'s> = Lexer<'s, Tok>;

/// Takes the rest of the block up to its comment as raw text.
fn tail(lex: &mut Lex<'_>) -> Span {
    let rest = lex.remainder();
    let mut quoted = false;
    let len = rest
        .iter()
        .position(|b| {
            quoted ^= *b == b'"';
            (*b == b';' && !quoted) || *b == b'\n'
        })
        .unwrap_or(rest.len());
    let start = lex.span().end as u32;
    lex.bump(len);
    let text = &rest[..len];
    let lead = text.iter().take_while(|b| b.is_ascii_whitespace()).count();
    let trimmed = text.trim_ascii();
    Span::at(start + lead as u32, trimmed.len() as u32)
}

/// Takes the rest of the block with all its lines.
fn all_lines(lex: &mut Lex<'_>) -> Span {
    let (start, len) = (lex.span().end as u32, lex.remainder().len());
    lex.bump(len);
    Span::at(start, len as u32)
}

fn cycle(lex: &mut Lex<'_>) -> CycleNumber {
    let text = lex.slice();
    let digits = text.iter().position(u8::is_ascii_digit).unwrap_or(text.len());
    let mut parts = text[digits..].split(|b| *b == b'.').map(whole);
    let mut cycle = CycleNumber {
        number: parts.next().flatten().unwrap_or(u32::MAX),
        part: parts.next().flatten(),
        misspelled: text[4].eq_ignore_ascii_case(&b'E'),
        rest: Span::default(),
    };
    match (cycle.number, cycle.part) {
        (_, None | Some(0)) => skip_cycle_name(lex),
        (12, _) => cycle.rest = tail(lex),
        _ => {}
    }
    cycle
}

/// The name behind a cycle number is decoration in the language of the control: only the number counts.
fn skip_cycle_name(lex: &mut Lex<'_>) {
    let rest = lex.remainder();
    let len = rest.iter().position(|b| matches!(b, b';' | b'\n' | b'~')).unwrap_or(rest.len());
    let name = &rest[..len];
    let mut end = len;
    for at in 0..name.len() {
        let starts_word = at == 0 || name[at - 1].is_ascii_whitespace();
        if starts_word && is_parameter_assignment(&name[at..]) {
            end = at;
            break;
        }
    }
    lex.bump(end);
}

/// `Q200=`, `QS500 =`.
fn is_parameter_assignment(text: &[u8]) -> bool {
    let Some(rest) = text.strip_prefix(b"Q").or_else(|| text.strip_prefix(b"q")) else { return false };
    let rest = rest.strip_prefix(b"S").or_else(|| rest.strip_prefix(b"s")).unwrap_or(rest);
    let digits = rest.iter().take_while(|b| b.is_ascii_digit()).count();
    digits > 0 && rest[digits..].trim_ascii_start().starts_with(b"=")
}

fn fn_number(lex: &mut Lex<'_>) -> u32 {
    let text = lex.slice();
    let digits = text.iter().position(u8::is_ascii_digit).unwrap_or(text.len());
    whole(text[digits..].strip_suffix(b":").unwrap_or(&text[digits..])).unwrap_or(u32::MAX)
}

fn fn_tail(lex: &mut Lex<'_>) -> FnTail {
    FnTail { number: fn_number(lex), rest: tail(lex) }
}

fn m_number(lex: &mut Lex<'_>) -> u32 {
    let text = lex.slice();
    whole(text[1..].strip_suffix(b".").unwrap_or(&text[1..])).unwrap_or(u32::MAX)
}

fn whole(digits: &[u8]) -> Option<u32> {
    std::str::from_utf8(digits.trim_ascii()).ok()?.parse().ok()
}

fn axis(lex: &mut Lex<'_>) -> Option<AxisWord> {
    let text = lex.slice();
    let incremental = text[0].eq_ignore_ascii_case(&b'I');
    let at = usize::from(incremental);
    let (value, _) = value(&text[at + 1..])?;
    Some(AxisWord { axis: Axis::of(text[at])?, incremental, value })
}

fn axis_letter(lex: &mut Lex<'_>) -> Option<AxisWord> {
    let text = lex.slice();
    let incremental = text.len() == 2;
    Some(AxisWord { axis: Axis::of(text[text.len() - 1])?, incremental, value: Value::None })
}

/// The value behind the letters of a word.
fn value_word(lex: &mut Lex<'_>) -> Option<ValueWord> {
    let text = lex.slice();
    let incremental = text[0].eq_ignore_ascii_case(&b'I');
    let from = text.iter().position(|b| !b.is_ascii_alphabetic())?;
    // `FQ5`: the Q belongs to the value. `DR2+1`: the 2 belongs to the address.
    let from = match text[..from].iter().position(|b| b.eq_ignore_ascii_case(&b'Q')) {
        Some(q) => q,
        None if text[..from].eq_ignore_ascii_case(b"DR") && is_dr2(text) => from + 1,
        None => from,
    };
    let (value, signed) = value(&text[from..])?;
    Some(ValueWord { incremental, value, signed })
}

/// `DR2` with a value behind it, not `DR` with the value 2.
fn is_dr2(text: &[u8]) -> bool {
    text.len() > 3 && text[2] == b'2' && !matches!(text[3], b'0'..=b'9' | b'.' | b',')
}

/// Reads `[sign] number` or `[sign] parameter`, with blanks anywhere between.
fn value(text: &[u8]) -> Option<(Value, bool)> {
    let text = text.trim_ascii_start();
    let (negative, signed, text) = match text.first()? {
        b'+' => (false, true, text[1..].trim_ascii_start()),
        b'-' => (true, true, text[1..].trim_ascii_start()),
        _ => (false, false, text),
    };
    if text.first()?.eq_ignore_ascii_case(&b'Q') {
        return Some((Value::Param { negative, q: parameter(text)? }, signed));
    }
    let (number, _) = decimal(text, true)?;
    Some((Value::Number(if negative { -number } else { number }), signed))
}

fn parameter(text: &[u8]) -> Option<QRef> {
    let (kind, digits) = match text.get(1)?.to_ascii_uppercase() {
        b'L' => (QKind::Ql, &text[2..]),
        b'R' => (QKind::Qr, &text[2..]),
        b'S' => (QKind::Qs, &text[2..]),
        _ => (QKind::Q, &text[1..]),
    };
    Some(QRef { kind, number: whole(digits).unwrap_or(u32::MAX) })
}

fn q_ref(lex: &mut Lex<'_>) -> Option<QRef> {
    parameter(lex.slice())
}

fn plain_number(lex: &mut Lex<'_>) -> Option<f64> {
    decimal(lex.slice(), true).map(|(value, _)| value)
}

fn name_q(lex: &mut Lex<'_>) -> Option<NameQ> {
    let text = lex.slice();
    let q = text.iter().rposition(|b| b.eq_ignore_ascii_case(&b'Q'))?;
    Some(NameQ { name: q as u32, q: parameter(&text[q..])? })
}

/// The tokens of a block, comments and continuation marks taken out.
#[derive(Debug)]
pub struct Tokens<'s> {
    text: &'s [u8],
    lex: Lex<'s>,
    /// The first comment, without its `;`.
    pub comment: Option<Span>,
    /// End of the last token.
    pub end: u32,
}

impl<'s> Tokens<'s> {
    /// Tokens of `text` from the byte `from` on.
    pub fn new(text: &'s [u8], from: usize) -> Tokens<'s> {
        let mut lex = Tok::lexer(text);
        lex.bump(from.min(text.len()));
        // The bump belongs to no token; the next one starts behind it.
        Tokens { text, lex, comment: None, end: 0 }
    }

    /// A name may hold points and hyphens, so the longest one reaches into a value that stands at once behind it
    /// (`PITCH-Q5`, `SCL.5`, `PI-SIN Q1`). Reads the name again up to that value.
    fn without_value(&mut self, start: usize, end: usize) -> Option<(Tok, usize)> {
        let cut = start + value_in(self.text.get(start..end)?, self.text.get(end..)?)?;
        let mut name = Tok::lexer(self.text.get(..cut)?);
        name.bump(start);
        let tok = name.next()?.unwrap_or(Tok::Bad);
        let end = name.span().end;
        self.lex = Tok::lexer(self.text);
        self.lex.bump(end);
        Some((tok, end))
    }
}

/// Where in a name the value begins that it has swallowed the start of.
fn value_in(name: &[u8], rest: &[u8]) -> Option<usize> {
    if name.len() > 3 && name[..3].eq_ignore_ascii_case(b"PI-") {
        return Some(2);
    }
    if !rest.first()?.is_ascii_digit() {
        return None;
    }
    if name.len() > 1 && name.ends_with(b".") {
        return Some(name.len() - 1);
    }
    let kind = usize::from(matches!(name.last()?.to_ascii_uppercase(), b'L' | b'R' | b'S'));
    let q = name.len().checked_sub(1 + kind)?;
    if q == 0 || !name[q].eq_ignore_ascii_case(&b'Q') {
        return None;
    }
    Some(if q > 1 && name[q - 1] == b'-' { q - 1 } else { q })
}

impl Iterator for Tokens<'_> {
    type Item = (u32, Tok, u32);

    fn next(&mut self) -> Option<(u32, Tok, u32)> {
        loop {
            let mut tok = self.lex.next()?.unwrap_or(Tok::Bad);
            let mut span = self.lex.span();
            if tok == Tok::Name
                && let Some((name, end)) = self.without_value(span.start, span.end)
            {
                (tok, span.end) = (name, end);
            }
            let (start, end) = (span.start as u32, span.end as u32);
            match tok {
                Tok::Comment => {
                    self.comment.get_or_insert(Span { start: start + 1, end });
                }
                // A mark in the middle of a line joins nothing.
                Tok::Tilde if joins(self.lex.remainder()) => {}
                _ => {
                    self.end = end;
                    let tok = if tok == Tok::Tilde { Tok::Bad } else { tok };
                    return Some((start, tok, end));
                }
            }
        }
    }
}

fn joins(rest: &[u8]) -> bool {
    let line = rest.iter().position(|b| *b == b'\n').map_or(rest, |end| &rest[..end]);
    let line = line.trim_ascii();
    line.is_empty() || line.starts_with(b";")
}
