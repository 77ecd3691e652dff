//! Values of Klartext words, and how they are read from the text of a token.

use super::Lex;
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

/// What a block of a free contour is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FkHead {
    /// `FPOL`
    Pole,
    /// `FL`, or tangential `FLT`.
    Line { smooth: bool },
    /// `FC`, or tangential `FCT`.
    Arc { smooth: bool },
    /// `FSELECT`
    Select,
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

/// Takes the rest of the block up to its comment as raw text.
pub(super) fn tail(lex: &mut Lex<'_>) -> Span {
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

/// The patterns of PATTERN DEF.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PatternKind {
    Pos,
    Row,
    Pat,
    Frame,
    Circ,
    PitchCirc,
}

impl PatternKind {
    /// As a program writes it.
    pub fn name(self) -> &'static str {
        match self {
            PatternKind::Pos => "POS",
            PatternKind::Row => "ROW",
            PatternKind::Pat => "PAT",
            PatternKind::Frame => "FRAME",
            PatternKind::Circ => "CIRC",
            PatternKind::PitchCirc => "PITCHCIRC",
        }
    }
}

pub(super) fn pattern_kind(lex: &mut Lex<'_>) -> Option<PatternKind> {
    use PatternKind::{Circ, Frame, Pat, PitchCirc, Pos, Row};
    let letters = lex.slice().iter().take_while(|b| b.is_ascii_alphabetic()).count();
    let name = &lex.slice()[..letters];
    [Pos, Row, Pat, Frame, Circ, PitchCirc].into_iter().find(|kind| name.eq_ignore_ascii_case(kind.name().as_bytes()))
}

/// Takes the rest of the block with all its lines.
pub(super) fn all_lines(lex: &mut Lex<'_>) -> Span {
    let (start, len) = (lex.span().end as u32, lex.remainder().len());
    lex.bump(len);
    Span::at(start, len as u32)
}

pub(super) fn cycle(lex: &mut Lex<'_>) -> CycleNumber {
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
pub(super) fn skip_cycle_name(lex: &mut Lex<'_>) {
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
pub(super) fn is_parameter_assignment(text: &[u8]) -> bool {
    let Some(rest) = text.strip_prefix(b"Q").or_else(|| text.strip_prefix(b"q")) else { return false };
    let rest = rest.strip_prefix(b"S").or_else(|| rest.strip_prefix(b"s")).unwrap_or(rest);
    let digits = rest.iter().take_while(|b| b.is_ascii_digit()).count();
    digits > 0 && rest[digits..].trim_ascii_start().starts_with(b"=")
}

pub(super) fn fn_number(lex: &mut Lex<'_>) -> u32 {
    let text = lex.slice();
    let digits = text.iter().position(u8::is_ascii_digit).unwrap_or(text.len());
    whole(text[digits..].strip_suffix(b":").unwrap_or(&text[digits..])).unwrap_or(u32::MAX)
}

pub(super) fn fn_tail(lex: &mut Lex<'_>) -> FnTail {
    FnTail { number: fn_number(lex), rest: tail(lex) }
}

pub(super) fn m_number(lex: &mut Lex<'_>) -> u32 {
    let text = lex.slice();
    whole(text[1..].strip_suffix(b".").unwrap_or(&text[1..])).unwrap_or(u32::MAX)
}

pub(super) fn whole(digits: &[u8]) -> Option<u32> {
    std::str::from_utf8(digits.trim_ascii()).ok()?.parse().ok()
}

pub(super) fn axis(lex: &mut Lex<'_>) -> Option<AxisWord> {
    let text = lex.slice();
    let incremental = text[0].eq_ignore_ascii_case(&b'I');
    let at = usize::from(incremental);
    let (value, _) = value(&text[at + 1..])?;
    Some(AxisWord { axis: Axis::of(text[at])?, incremental, value })
}

pub(super) fn axis_letter(lex: &mut Lex<'_>) -> Option<AxisWord> {
    let text = lex.slice();
    let incremental = text.len() == 2;
    Some(AxisWord { axis: Axis::of(text[text.len() - 1])?, incremental, value: Value::None })
}

/// The value behind the letters of a word.
pub(super) fn value_word(lex: &mut Lex<'_>) -> Option<ValueWord> {
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
pub(super) fn is_dr2(text: &[u8]) -> bool {
    text.len() > 3 && text[2] == b'2' && !matches!(text[3], b'0'..=b'9' | b'.' | b',')
}

/// Reads `[sign] number` or `[sign] parameter`, with blanks anywhere between.
pub(super) fn value(text: &[u8]) -> Option<(Value, bool)> {
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

pub(super) fn parameter(text: &[u8]) -> Option<QRef> {
    let (kind, digits) = match text.get(1)?.to_ascii_uppercase() {
        b'L' => (QKind::Ql, &text[2..]),
        b'R' => (QKind::Qr, &text[2..]),
        b'S' => (QKind::Qs, &text[2..]),
        _ => (QKind::Q, &text[1..]),
    };
    Some(QRef { kind, number: whole(digits).unwrap_or(u32::MAX) })
}

pub(super) fn q_ref(lex: &mut Lex<'_>) -> Option<QRef> {
    parameter(lex.slice())
}

pub(super) fn plain_number(lex: &mut Lex<'_>) -> Option<f64> {
    decimal(lex.slice(), true).map(|(value, _)| value)
}

pub(super) fn name_q(lex: &mut Lex<'_>) -> Option<NameQ> {
    let text = lex.slice();
    let q = text.iter().rposition(|b| b.eq_ignore_ascii_case(&b'Q'))?;
    Some(NameQ { name: q as u32, q: parameter(&text[q..])? })
}
