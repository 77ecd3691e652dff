//! Tokens of the MTC200 language.
//!
//! A letter and the number behind it are one token, sign and all (`X-10`, `G01`): letters stand in no formula.
//! Names have two letters or more. A `(` opens a bracket where a formula can go on, else a comment; what is
//! a comment never becomes a token.

use logos::{Lexer, Logos};

use crate::text::{Span, number::decimal};

use super::formula::Function;

/// A letter with the number behind it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LetterNumber {
    /// Upper case.
    pub letter: u8,
    pub value: f64,
    /// Written without sign.
    pub plain: bool,
}

/// A token. Names are found by the span that comes with the token.
#[derive(Logos, Debug, Clone, Copy, PartialEq)]
#[logos(utf8 = false)]
#[logos(skip(r"[ \t\r\n\x00\x0b\x0c\x1a]+"))]
#[logos(subpattern number = r"[0-9]+(\.[0-9]*)?|\.[0-9]+")]
pub enum Tok {
    #[regex(r"[A-Za-z][ \t]*([+\-][ \t]*)?((?&number))", letter_number, priority = 20)]
    LetterNumber(LetterNumber),
    #[regex(r"[A-Za-z]", |lex| lex.slice()[0].to_ascii_uppercase(), priority = 3)]
    Letter(u8),
    #[regex(r"[A-Za-z][A-Za-z_]+", priority = 2)]
    Name,
    #[regex(r"(?&number)", |lex| number(lex.slice()), priority = 10)]
    Number(f64),
    /// `@050`
    #[regex(r"@[0-9]+", |lex| variable(lex.slice()))]
    Variable(u32),
    /// `@1:050`: of another process.
    #[regex(r"@[0-9]+:[0-9]+")]
    OtherVariable,
    /// `.LOOP`
    #[regex(r"\.[A-Za-z][A-Za-z0-9_]*")]
    Label,

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
    #[token("MOD", ignore(case))]
    Mod,
    #[token("DIV", ignore(case))]
    Div,
    #[token("PI", ignore(case))]
    Pi,
    #[token("ABS", |_| Function::Abs, ignore(case))]
    #[token("INT", |_| Function::Int, ignore(case))]
    #[token("SQRT", |_| Function::Sqrt, ignore(case))]
    #[token("SIN", |_| Function::Sin, ignore(case))]
    #[token("COS", |_| Function::Cos, ignore(case))]
    #[token("TAN", |_| Function::Tan, ignore(case))]
    #[token("ASIN", |_| Function::Asin, ignore(case))]
    #[token("ACOS", |_| Function::Acos, ignore(case))]
    #[token("ATAN", |_| Function::Atan, ignore(case))]
    Function(Function),

    /// `;` to the end of the line.
    #[regex(b";[^\n]*", allow_greedy = true)]
    Comment,
    /// `[ … ]`, a text for the operator.
    #[regex(br"\[[^\]\n]*\]")]
    Hint,
    /// A comment that is not closed.
    #[token("[")]
    Unclosed,
    /// A byte that belongs nowhere.
    Bad,
}

type Lex<'s> = Lexer<'s, Tok>;

fn letter_number(lex: &mut Lex<'_>) -> Option<LetterNumber> {
    let text = lex.slice();
    let digits = text[1..].trim_ascii_start();
    let (sign, digits) = match digits {
        [b'-', rest @ ..] => (-1.0, rest),
        [b'+', rest @ ..] => (1.0, rest),
        _ => (1.0, digits),
    };
    let plain = text.get(1..).is_some_and(|rest| !rest.contains(&b'+') && !rest.contains(&b'-'));
    Some(LetterNumber { letter: text[0].to_ascii_uppercase(), value: sign * number(digits.trim_ascii_start())?, plain })
}

fn number(text: &[u8]) -> Option<f64> {
    decimal(text, false).map(|(value, _)| value)
}

/// The number of a variable; one that is far too large stays too large.
fn variable(text: &[u8]) -> u32 {
    text[1..].iter().fold(0u32, |n, digit| n.saturating_mul(10).saturating_add(u32::from(digit - b'0')))
}

/// The tokens of a block, without its comments.
#[derive(Debug)]
pub struct Tokens<'s> {
    lex: Lex<'s>,
    /// Does a `(` open a bracket of a formula here?
    bracket: bool,
    /// The comments, without their signs.
    pub comments: Vec<Span>,
    /// End of the last token.
    pub end: u32,
}

impl<'s> Tokens<'s> {
    /// Tokens of `text` from the byte `from` on.
    pub fn new(text: &'s [u8], from: usize) -> Tokens<'s> {
        let mut lex = Tok::lexer(text);
        lex.bump(from.min(text.len()));
        Tokens { lex, bracket: false, comments: Vec::new(), end: 0 }
    }

    /// The comment that a `(` just read begins; false if nothing closes it.
    fn comment(&mut self) -> bool {
        let start = self.lex.span().end as u32;
        let Some(len) = self.lex.remainder().iter().position(|b| *b == b')') else { return false };
        self.lex.bump(len + 1);
        self.comments.push(Span::at(start, len as u32));
        true
    }
}

impl Iterator for Tokens<'_> {
    type Item = (u32, Tok, u32);

    fn next(&mut self) -> Option<(u32, Tok, u32)> {
        loop {
            let mut tok = self.lex.next()?.unwrap_or(Tok::Bad);
            let span = self.lex.span();
            let (start, end) = (span.start as u32, span.end as u32);
            match tok {
                Tok::Comment => {
                    self.comments.push(Span { start: start + 1, end });
                    continue;
                }
                Tok::Hint => {
                    self.comments.push(Span { start: start + 1, end: end - 1 });
                    continue;
                }
                Tok::Open if !self.bracket => {
                    if self.comment() {
                        continue;
                    }
                    tok = Tok::Unclosed;
                }
                _ => {}
            }
            self.bracket = matches!(
                tok,
                Tok::Assign
                    | Tok::Plus
                    | Tok::Minus
                    | Tok::Star
                    | Tok::Slash
                    | Tok::Mod
                    | Tok::Div
                    | Tok::Function(_)
                    | Tok::Open
            );
            self.end = end;
            return Some((start, tok, end));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tokens(text: &str) -> Vec<Tok> {
        Tokens::new(text.as_bytes(), 0).map(|(_, tok, _)| tok).collect()
    }

    fn word(letter: u8, value: f64) -> Tok {
        Tok::LetterNumber(LetterNumber { letter, value, plain: value >= 0.0 })
    }

    #[test]
    fn words_without_blanks() {
        assert_eq!(
            tokens("g01x-10.5Y.5F1000.0D02"),
            [word(b'G', 1.0), word(b'X', -10.5), word(b'Y', 0.5), word(b'F', 1000.0), word(b'D', 2.0)]
        );
        assert_eq!(tokens("CF2 LA_ON RET"), [Tok::Name, Tok::Number(2.0), Tok::Name, Tok::Name]);
    }

    #[test]
    fn brackets_and_comments() {
        assert_eq!(
            tokens("X=(@1)(done) [hint] Y5 ; rest"),
            [Tok::Letter(b'X'), Tok::Assign, Tok::Open, Tok::Variable(1), Tok::Close, word(b'Y', 5.0)]
        );
        assert_eq!(
            tokens("@100=SIN(30)(a)"),
            [Tok::Variable(100), Tok::Assign, Tok::Function(Function::Sin), Tok::Open, Tok::Number(30.0), Tok::Close]
        );
        assert_eq!(tokens("M3 (open"), [word(b'M', 3.0), Tok::Unclosed, Tok::Name]);
        assert_eq!(tokens("BNE .LOOP"), [Tok::Name, Tok::Label]);
    }
}
