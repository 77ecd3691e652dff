//! The tokens of a block.

use logos::Logos;

use super::{Lex, Tok};
use crate::text::Span;

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
