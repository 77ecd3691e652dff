//! Tokens of the SINUMERIK language.
//!
//! A letter and the number behind it are one token (`X10`, `G01`, `R5`); a sign in between makes three,
//! because in a formula it is an operator. A name starts with two letters or `_`; with that rule here, `Y2O`
//! is a word and a stray letter, not a name.

use logos::{Lexer, Logos};

use crate::text::{Span, number::decimal};

/// Types of variables.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TypeName {
    Int,
    Real,
    Bool,
    Char,
    String,
    Axis,
    Frame,
}

/// A number as written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Number {
    pub value: f64,
    /// Written without point and exponent.
    pub whole: bool,
}

/// A letter with the number behind it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LetterNumber {
    /// Upper case.
    pub letter: u8,
    pub number: Number,
    /// Digits only, no blank before them: may be a name (`A0`, `X1`).
    pub name_like: bool,
    /// Digits of a whole number: `L1` and `L01` are different programs.
    pub digits: u8,
}

/// A token. Names are found by the span that comes with the token.
#[derive(Logos, Debug, Clone, Copy, PartialEq)]
#[logos(utf8 = false)]
#[logos(skip(r"[ \t\r\n&\x00\x0b\x0c\x1a]+"))]
#[logos(subpattern number = r"([0-9]+(\.[0-9]*)?|\.[0-9]+)([Ee][Xx][+\-]?[0-9]+)?")]
pub enum Tok {
    #[regex(r"[A-Za-z][ \t]*(?&number)", letter_number, priority = 20)]
    LetterNumber(LetterNumber),
    #[regex(r"[A-Za-z]", |lex| lex.slice()[0].to_ascii_uppercase(), priority = 3)]
    Letter(u8),
    #[regex(r"[A-Za-z_][A-Za-z_][A-Za-z0-9_]*", priority = 2)]
    #[regex(r"_([0-9][A-Za-z0-9_]*)?", priority = 2)]
    Name,
    /// `$P_EP`
    #[regex(r"\$[A-Za-z$_][A-Za-z0-9_]*")]
    System,
    #[regex(r"(?&number)", number, priority = 10)]
    Number(Number),
    /// `'H3F'`, `'B1011'`
    #[regex(r"'[Hh][0-9A-Fa-f]+'", |lex| based(lex, 16))]
    #[regex(r"'[Bb][01]+'", |lex| based(lex, 2))]
    Based(i64),
    /// `'"'`
    #[regex(r"'(?-u:[^'\n])'", |lex| lex.slice()[1], priority = 4)]
    Char(u8),
    #[regex(r#""(?-u:[^"\n])*""#)]
    Text,

    #[token("==")]
    Equal,
    #[token("<>")]
    NotEqual,
    #[token("<=")]
    LessEqual,
    #[token(">=")]
    GreaterEqual,
    #[token("<<")]
    Concat,
    #[token("<")]
    Less,
    #[token(">")]
    Greater,
    #[token("=")]
    Assign,
    #[token("+")]
    Plus,
    #[token("-")]
    Minus,
    #[token("*")]
    Star,
    #[token("/")]
    Slash,
    #[token("(")]
    Open,
    #[token(")")]
    Close,
    #[token("[")]
    OpenIndex,
    #[token("]")]
    CloseIndex,
    #[token(",")]
    Comma,
    #[token(":")]
    Colon,

    #[token("IF", ignore(case))]
    If,
    #[token("ELSE", ignore(case))]
    Else,
    #[token("ENDIF", ignore(case))]
    EndIf,
    #[token("WHILE", ignore(case))]
    While,
    #[token("ENDWHILE", ignore(case))]
    EndWhile,
    #[token("FOR", ignore(case))]
    For,
    #[token("TO", ignore(case))]
    To,
    #[token("ENDFOR", ignore(case))]
    EndFor,
    #[token("LOOP", ignore(case))]
    Loop,
    #[token("ENDLOOP", ignore(case))]
    EndLoop,
    #[token("REPEAT", ignore(case))]
    Repeat,
    #[token("REPEATB", ignore(case))]
    RepeatB,
    #[token("UNTIL", ignore(case))]
    Until,
    #[token("GOTO", ignore(case))]
    Goto,
    #[token("GOTOF", ignore(case))]
    GotoF,
    #[token("GOTOB", ignore(case))]
    GotoB,
    #[token("GOTOC", ignore(case))]
    GotoC,
    #[token("GOTOS", ignore(case))]
    GotoS,
    #[token("CASE", ignore(case))]
    Case,
    #[token("OF", ignore(case))]
    Of,
    #[token("DEFAULT", ignore(case))]
    Default,
    #[token("DEF", ignore(case))]
    Def,
    /// The rest of the block: access rights and start values of variables known before.
    #[regex(r"(?i)REDEF[ \t]", tail)]
    Redef(Span),
    #[token("INT", |_| TypeName::Int, ignore(case))]
    #[token("REAL", |_| TypeName::Real, ignore(case))]
    #[token("BOOL", |_| TypeName::Bool, ignore(case))]
    #[token("CHAR", |_| TypeName::Char, ignore(case))]
    #[token("STRING", |_| TypeName::String, ignore(case))]
    #[token("AXIS", |_| TypeName::Axis, ignore(case))]
    #[token("FRAME", |_| TypeName::Frame, ignore(case))]
    Type(TypeName),
    #[token("PROC", ignore(case))]
    Proc,
    #[token("EXTERN", ignore(case))]
    Extern,
    #[regex(r"(?i)DEFINE[ \t]", tail)]
    Define(Span),
    #[token("VAR", ignore(case))]
    Var,
    #[token("CALL", ignore(case))]
    Call,
    #[token("PCALL", ignore(case))]
    PCall,
    #[token("MCALL", ignore(case))]
    MCall,
    #[token("EXTCALL", ignore(case))]
    ExtCall,
    #[token("ISOCALL", ignore(case))]
    IsoCall,
    #[token("BLOCK", ignore(case))]
    Block,
    #[token("NOT", ignore(case))]
    Not,
    #[token("AND", ignore(case))]
    And,
    #[token("OR", ignore(case))]
    Or,
    #[token("XOR", ignore(case))]
    Xor,
    #[token("B_NOT", ignore(case))]
    BitNot,
    #[token("B_AND", ignore(case))]
    BitAnd,
    #[token("B_OR", ignore(case))]
    BitOr,
    #[token("B_XOR", ignore(case))]
    BitXor,
    #[token("DIV", ignore(case))]
    Div,
    #[token("MOD", ignore(case))]
    Mod,
    #[token("TRUE", ignore(case))]
    True,
    #[token("FALSE", ignore(case))]
    False,

    /// A synchronized action: the rest of the block.
    #[token("WHEN", tail, ignore(case))]
    #[token("WHENEVER", tail, ignore(case))]
    #[token("EVERY", tail, ignore(case))]
    #[token("FROM", tail, ignore(case))]
    #[token("DO", tail, ignore(case))]
    #[regex(r"(?i)IDS?[ \t]*=", tail)]
    Sync(Span),

    #[regex(b";[^\n]*", allow_greedy = true)]
    Comment,
    /// A byte that belongs nowhere.
    Bad,
}

type Lex<'s> = Lexer<'s, Tok>;

fn letter_number(lex: &mut Lex<'_>) -> Option<LetterNumber> {
    let text = lex.slice();
    let digits = text[1..].trim_ascii_start();
    let number = parse_number(digits)?;
    Some(LetterNumber {
        letter: text[0].to_ascii_uppercase(),
        number,
        name_like: number.whole && digits.len() + 1 == text.len(),
        digits: if number.whole { digits.len().min(255) as u8 } else { 0 },
    })
}

fn number(lex: &mut Lex<'_>) -> Option<Number> {
    parse_number(lex.slice())
}

/// A decimal with an optional exponent `EX`.
fn parse_number(text: &[u8]) -> Option<Number> {
    let (mantissa, used) = decimal(text, false)?;
    let whole = !text[..used].contains(&b'.');
    let rest = &text[used..];
    if rest.is_empty() {
        return Some(Number { value: mantissa, whole });
    }
    // `1.5EX-3` is read as one decimal, so that it is rounded once.
    let plain = [&text[..used], b"e", &rest[2..]].concat();
    let value = std::str::from_utf8(&plain).ok()?.parse().ok()?;
    Some(Number { value, whole: false })
}

fn based(lex: &mut Lex<'_>, radix: u32) -> Option<i64> {
    let text = lex.slice();
    let digits = std::str::from_utf8(&text[2..text.len() - 1]).ok()?;
    i64::from_str_radix(digits, radix).ok()
}

/// Takes the rest of the block up to its comment as raw text.
fn tail(lex: &mut Lex<'_>) -> Span {
    let rest = lex.remainder();
    let len = comment_start(rest).unwrap_or(rest.len());
    let start = lex.span().end as u32;
    lex.bump(len);
    let text = &rest[..len];
    let lead = text.len() - text.trim_ascii_start().len();
    Span::at(start + lead as u32, text.trim_ascii().len() as u32)
}

/// Where the comment of a block begins; a `;` in a text begins none.
pub fn comment_start(text: &[u8]) -> Option<usize> {
    let mut quoted = false;
    text.iter().position(|b| {
        quoted ^= *b == b'"';
        *b == b';' && !quoted
    })
}

/// The tokens of a block, without its comment.
#[derive(Debug)]
pub struct Tokens<'s> {
    lex: Lex<'s>,
    /// The comment, without its `;`.
    pub comment: Option<Span>,
    /// End of the last token.
    pub end: u32,
}

impl<'s> Tokens<'s> {
    /// Tokens of `text` from the byte `from` on.
    pub fn new(text: &'s [u8], from: usize) -> Tokens<'s> {
        let mut lex = Tok::lexer(text);
        lex.bump(from.min(text.len()));
        Tokens { lex, comment: None, end: 0 }
    }
}

impl Iterator for Tokens<'_> {
    type Item = (u32, Tok, u32);

    fn next(&mut self) -> Option<(u32, Tok, u32)> {
        loop {
            let tok = self.lex.next()?.unwrap_or(Tok::Bad);
            let span = self.lex.span();
            let (start, end) = (span.start as u32, span.end as u32);
            if tok == Tok::Comment {
                self.comment.get_or_insert(Span { start: start + 1, end });
                continue;
            }
            self.end = end;
            return Some((start, tok, end));
        }
    }
}
