//! The lines of a file of an unknown language: words and comments as most controls write them.

use crate::text::Span;

/// A line with its place.
pub struct Line<'a> {
    /// Counted from 1.
    pub number: u32,
    /// Of its first byte in the file.
    pub start: u32,
    /// Without line end.
    pub text: &'a [u8],
    /// What stands in front of comments; those in round brackets are blanked out.
    pub code: Vec<u8>,
    pub words: Vec<Word>,
    /// It stands between G291 and G290.
    pub is_iso: bool,
}

/// `G43`, `X-1.5`, `#100`, `CYCLE81`: letters, upper case, and what stands behind them.
pub struct Word {
    pub letters: Vec<u8>,
    /// The number, with its sign and point; empty where none stands there.
    pub number: Vec<u8>,
    /// Counted from the start of the line.
    pub span: Span,
}

impl Word {
    pub fn is(&self, letters: &str, number: &str) -> bool {
        self.letters == letters.as_bytes() && self.value() == number.as_bytes()
    }

    /// The number without the zeros in front.
    pub fn value(&self) -> &[u8] {
        let zeros = self.number.iter().take_while(|b| **b == b'0').count();
        &self.number[zeros.min(self.number.len().saturating_sub(1))..]
    }
}

/// The lines of `head`, without blank ones; the last may be cut off.
pub fn lines(head: &[u8]) -> impl Iterator<Item = Line<'_>> {
    let mut at = if head.starts_with(b"\xef\xbb\xbf") { 3 } else { 0 };
    let mut number = 0;
    std::iter::from_fn(move || {
        loop {
            let rest = head.get(at..).filter(|rest| !rest.is_empty())?;
            let length = rest.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(rest.len());
            let (start, text) = (at, &rest[..length]);
            let ends = if rest[length..].starts_with(b"\r\n") { 2 } else { 1 };
            at += length + ends;
            number += 1;
            if !text.trim_ascii().is_empty() {
                return Some(Line::new(number, start as u32, text));
            }
        }
    })
}

impl<'a> Line<'a> {
    fn new(number: u32, start: u32, text: &'a [u8]) -> Line<'a> {
        let code = without_comments(text);
        let words = words(&code);
        Line { number, start, text, code, words, is_iso: false }
    }

    /// The whole of it.
    pub fn span(&self) -> Span {
        let blank = self.text.len() - self.text.trim_ascii_start().len();
        Span::at(blank as u32, self.text.trim_ascii().len() as u32)
    }

    /// Nothing but words of a plain move, as a line before it had them, too (`seen`): it shows no language, and most lines are such.
    pub fn repeats(&self, seen: &mut Vec<u32>) -> bool {
        let of_words = |b: &u8| b.is_ascii_alphanumeric() || matches!(b, b' ' | b'\t' | b'.' | b'+' | b'-');
        let words = self.words.iter().map(bit_of_move).try_fold(0_u32, |all, bit| Some(all | bit?));
        let Some(words) = words.filter(|words| *words != 0 && self.text.iter().all(of_words)) else { return false };
        let is_known = seen.contains(&words);
        if !is_known {
            seen.push(words);
        }
        is_known
    }

    /// A control that is told to skips the block.
    pub fn is_skipped(&self) -> bool {
        matches!(self.text.trim_ascii_start(), [b'/', next, ..] if !matches!(next, b'/' | b'*'))
    }

    /// From a word to the end of the code.
    pub fn span_from(&self, word: &Word) -> Span {
        Span { start: word.span.start, end: (self.code.trim_ascii_end().len() as u32).max(word.span.end) }
    }

    /// From a word to the next blank: `R1=5`, `X=IC(5)`.
    pub fn span_to_blank(&self, word: &Word) -> Span {
        let start = word.span.start as usize;
        let rest = self.text.get(start..).unwrap_or_default();
        let length = rest.iter().position(|b| b.is_ascii_whitespace() || *b == b';').unwrap_or(rest.len());
        Span { start: word.span.start, end: ((start + length) as u32).max(word.span.end) }
    }

    /// The words behind the number of the block.
    pub fn behind_number(&self) -> &[Word] {
        match self.words.split_first() {
            Some((first, rest)) if first.letters == b"N" && !first.number.is_empty() => rest,
            _ => &self.words,
        }
    }
}

/// The words of a plain move: number of the block, G0 to G3, axes and centres, feed. None for any other.
fn bit_of_move(word: &Word) -> Option<u32> {
    match word.letters[..] {
        [b'G'] => match word.value() {
            [digit @ b'0'..=b'3'] => Some(1 << (26 + (digit - b'0'))),
            _ => None,
        },
        [letter @ (b'A'..=b'C' | b'F' | b'I'..=b'K' | b'N' | b'X'..=b'Z')] if !word.number.is_empty() => {
            Some(1 << (letter - b'A'))
        }
        _ => None,
    }
}

fn without_comments(text: &[u8]) -> Vec<u8> {
    let mut code = Vec::with_capacity(text.len());
    let mut depth = 0_u32;
    for byte in text {
        match byte {
            b';' if depth == 0 => break,
            b'(' => depth += 1,
            _ => {}
        }
        code.push(if depth > 0 { b' ' } else { byte.to_ascii_uppercase() });
        if *byte == b')' {
            depth = depth.saturating_sub(1);
        }
    }
    code
}

fn words(code: &[u8]) -> Vec<Word> {
    let (mut words, mut at) = (Vec::new(), 0);
    while at < code.len() {
        if !code[at].is_ascii_alphabetic() && code[at] != b'#' {
            at += 1;
            continue;
        }
        let start = at;
        let letters = code[at..].iter().take_while(|b| b.is_ascii_alphabetic() || **b == b'_').count().max(1);
        at += letters;
        let signed = usize::from(code.get(at).is_some_and(|b| matches!(b, b'+' | b'-')));
        let digits = code[at + signed..].iter().take_while(|b| b.is_ascii_digit() || **b == b'.').count();
        let number = if digits > 0 { signed + digits } else { 0 };
        words.push(Word {
            letters: code[start..start + letters].to_vec(),
            number: code[at..at + number].to_vec(),
            span: Span { start: start as u32, end: (at + number) as u32 },
        });
        at += number;
    }
    words
}
