//! Tokens of HEIDENHAIN turning programs.
//!
//! An address of one to three letters and the number behind it are one token (`X50`, `AN30`, `Xi-5`); the letter
//! `i` behind a coordinate makes it incremental. Keywords and function names are runs of letters without a number.

use logos::{Lexer, Logos};

use crate::text::number::decimal;

/// An address: up to three letters, upper case.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Addr(pub u32);

/// Longest address in letters.
pub const MOST_LETTERS: usize = 3;

impl Addr {
    /// The address of these letters; `None` for more than three or for none.
    pub const fn of(letters: &[u8]) -> Option<Addr> {
        if letters.is_empty() || letters.len() > MOST_LETTERS {
            return None;
        }
        let mut code = 0;
        let mut i = 0;
        while i < letters.len() {
            if !letters[i].is_ascii_alphabetic() {
                return None;
            }
            code = code << 8 | letters[i].to_ascii_uppercase() as u32;
            i += 1;
        }
        Some(Addr(code))
    }

    /// The letter of an address of one letter.
    pub fn letter(self) -> Option<u8> {
        (self.0 < 256).then_some(self.0 as u8)
    }
}

impl std::fmt::Display for Addr {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for shift in [16, 8, 0] {
            let byte = (self.0 >> shift) as u8;
            if byte != 0 {
                write!(f, "{}", byte as char)?;
            }
        }
        Ok(())
    }
}

impl std::fmt::Debug for Addr {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{self}")
    }
}

/// An address, and whether its value counts from where the tool stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Address {
    pub addr: Addr,
    pub incremental: bool,
}

/// Splits the incremental mark off: `XI`, `Zi`, `II`, `KI`.
pub fn address(letters: &[u8]) -> Option<Address> {
    if let [first, b'I' | b'i'] = letters
        && matches!(first.to_ascii_uppercase(), b'X' | b'Z' | b'I' | b'K' | b'Y' | b'C')
    {
        return Some(Address { addr: Addr::of(&letters[..1])?, incremental: true });
    }
    Some(Address { addr: Addr::of(letters)?, incremental: false })
}

/// A family of variables.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum VarKind {
    /// `#5`
    Hash,
    /// `#l5`: of one program level.
    Local,
    /// `#c5`: of the channel.
    Channel,
    /// `#g5`: of the control.
    Global,
    /// `#i5`: information of the machine.
    Machine,
    /// `#n5`: data of the interpreter.
    Interpreter,
    /// `#__la`, `#LA`: a value handed to a subprogram.
    Argument,
    /// `V5`: evaluated when the block runs.
    Real,
}

/// A variable; the number of an argument is its [`Addr`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct VarRef {
    pub kind: VarKind,
    pub number: u32,
}

impl std::fmt::Display for VarRef {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let head = match self.kind {
            VarKind::Hash => "#",
            VarKind::Local => "#l",
            VarKind::Channel => "#c",
            VarKind::Global => "#g",
            VarKind::Machine => "#i",
            VarKind::Interpreter => "#n",
            VarKind::Real => "V",
            VarKind::Argument => return write!(f, "#{}", Addr(self.number)),
        };
        write!(f, "{head}{}", self.number)
    }
}

/// An address with a literal number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Word {
    pub address: Address,
    pub value: f64,
    /// Written without point and sign.
    pub whole: bool,
}

/// A token. Names and texts are found by the span that comes with the token.
#[derive(Logos, Debug, Clone, Copy, PartialEq)]
#[logos(utf8 = false)]
#[logos(skip(r"[ \t\r\n\x00\x0b\x0c\x1a]+"))]
#[logos(subpattern number = r"([0-9]+(\.[0-9]*)?|\.[0-9]+)")]
pub enum Tok {
    #[regex(r"[A-Za-z][A-Za-z]?[A-Za-z]?([+\-][ \t]*)?(?&number)", word, priority = 20)]
    Word(Word),
    #[regex(r"[A-Za-z_]+", priority = 2)]
    Name,
    #[regex(r"(?&number)", |lex| decimal(lex.slice(), false).map(|(value, _)| value), priority = 10)]
    Number(f64),
    #[regex(r"#[A-Za-z_]*[0-9]*", variable)]
    Variable(VarRef),
    /// `$1`: a slide.
    #[regex(r"\$[0-9]+", |lex| std::str::from_utf8(&lex.slice()[1..]).ok().and_then(|n| n.parse::<u32>().ok()))]
    Slide(u32),
    #[regex(r#""[^"\n]*""#)]
    Text,

    #[token("?")]
    Unknown,
    #[token("==")]
    Equal,
    #[token("!=")]
    NotEqual,
    #[token("<=")]
    LessEqual,
    #[token(">=")]
    GreaterEqual,
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
    #[token("{")]
    OpenFormula,
    #[token("}")]
    CloseFormula,
    #[token(",")]
    Comma,

    #[token("IF", ignore(case))]
    If,
    #[token("THEN", ignore(case))]
    Then,
    #[token("ELSE", ignore(case))]
    Else,
    #[token("ENDIF", ignore(case))]
    EndIf,
    #[token("WHILE", ignore(case))]
    While,
    #[token("ENDWHILE", ignore(case))]
    EndWhile,
    #[token("SWITCH", ignore(case))]
    Switch,
    #[token("CASE", ignore(case))]
    Case,
    #[token("BREAK", ignore(case))]
    Break,
    #[token("DEFAULT", ignore(case))]
    Default,
    #[token("ENDSWITCH", ignore(case))]
    EndSwitch,
    #[token("AND", ignore(case))]
    And,
    #[token("OR", ignore(case))]
    Or,

    /// A byte that belongs nowhere.
    Bad,
}

type Lex<'s> = Lexer<'s, Tok>;

fn word(lex: &mut Lex<'_>) -> Option<Word> {
    let text = lex.slice();
    let letters = text.iter().take_while(|b| b.is_ascii_alphabetic()).count();
    let address = address(&text[..letters])?;
    let (sign, digits) = match text.get(letters)? {
        b'-' => (-1.0, text[letters + 1..].trim_ascii_start()),
        b'+' => (1.0, text[letters + 1..].trim_ascii_start()),
        _ => (1.0, &text[letters..]),
    };
    let (value, _) = decimal(digits, false)?;
    let whole = digits.len() + letters == text.len() && !digits.contains(&b'.');
    Some(Word { address, value: sign * value, whole })
}

fn variable(lex: &mut Lex<'_>) -> Option<VarRef> {
    let text = &lex.slice()[1..];
    let letters = text.iter().take_while(|b| !b.is_ascii_digit()).count();
    let (name, digits) = text.split_at(letters);
    let argument = |name: &[u8]| Addr::of(name).map(|addr| VarRef { kind: VarKind::Argument, number: addr.0 });
    if digits.is_empty() {
        return argument(name.strip_prefix(b"__").unwrap_or(name));
    }
    let kind = match name {
        [] => VarKind::Hash,
        [b'L' | b'l'] => VarKind::Local,
        [b'C' | b'c'] => VarKind::Channel,
        [b'G' | b'g'] => VarKind::Global,
        [b'I' | b'i'] => VarKind::Machine,
        [b'N' | b'n'] => VarKind::Interpreter,
        _ => return None,
    };
    let number = std::str::from_utf8(digits).ok()?.parse().ok()?;
    Some(VarRef { kind, number })
}

/// The tokens of a block.
#[derive(Debug)]
pub struct Tokens<'s> {
    lex: Lex<'s>,
    /// End of the last token.
    pub end: u32,
}

impl<'s> Tokens<'s> {
    /// Tokens of `text` from the byte `from` on; the comment was cut off.
    pub fn new(text: &'s [u8], from: usize) -> Tokens<'s> {
        let mut lex = Tok::lexer(text);
        lex.bump(from.min(text.len()));
        Tokens { lex, end: 0 }
    }
}

impl Iterator for Tokens<'_> {
    type Item = (u32, Tok, u32);

    fn next(&mut self) -> Option<(u32, Tok, u32)> {
        let tok = self.lex.next()?.unwrap_or(Tok::Bad);
        let span = self.lex.span();
        self.end = span.end as u32;
        Some((span.start as u32, tok, span.end as u32))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all(text: &str) -> Vec<Tok> {
        Tokens::new(text.as_bytes(), 0).map(|(_, tok, _)| tok).collect()
    }

    #[test]
    fn words_and_their_incremental_mark() {
        let word = |text: &str| match all(text)[..] {
            [Tok::Word(word)] => (word.address.addr.to_string(), word.address.incremental, word.value),
            ref other => panic!("{text}: {other:?}"),
        };
        assert_eq!(word("X50"), ("X".into(), false, 50.0));
        assert_eq!(word("Xi-15"), ("X".into(), true, -15.0));
        assert_eq!(word("II-8"), ("I".into(), true, -8.0));
        assert_eq!(word("RI2"), ("RI".into(), false, 2.0));
        assert_eq!(word("an30.5"), ("AN".into(), false, 30.5));
        assert_eq!(word("B-.5"), ("B".into(), false, -0.5));
    }

    #[test]
    fn variables() {
        let shown = |text: &str| match all(text)[..] {
            [Tok::Variable(var)] => var.to_string(),
            ref other => panic!("{text}: {other:?}"),
        };
        for (text, name) in [("#5", "#5"), ("#L12", "#l12"), ("#__la", "#LA"), ("#LA", "#LA"), ("#i3", "#i3")] {
            assert_eq!(shown(text), name);
        }
        assert_eq!(all("#abcd1"), [Tok::Bad]);
        assert_eq!(all("CASE1"), [Tok::Case, Tok::Number(1.0)]);
    }
}
