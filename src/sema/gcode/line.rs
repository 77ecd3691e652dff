//! A line of plain G-code: its skip mark, where its words end, its comments.

use crate::text::Span;

/// A line.
#[derive(Debug, Clone, Default)]
pub(super) struct Line {
    pub span: Span,
    /// Mark of a line that the control may skip, and where the words behind it begin.
    pub skip: Option<u8>,
    pub from: usize,
    /// Where words and comments end.
    pub end: usize,
    /// A line break stands inside.
    pub is_broken: bool,
    pub comments: Vec<Span>,
}

/// Blanks, and what pads a file.
pub(super) fn is_blank(byte: u8) -> bool {
    byte.is_ascii_whitespace() || matches!(byte, 0 | 0x0b | 0x1a)
}

impl Line {
    pub fn read(&mut self, text: &[u8]) {
        self.comments.clear();
        let start = text.iter().position(|b| !is_blank(*b)).unwrap_or(text.len());
        let end = text.iter().rposition(|b| !is_blank(*b)).map_or(start, |last| last + 1);
        let text = &text[..end];
        self.span = Span { start: start as u32, end: end as u32 };
        self.is_broken = memchr::memchr2(b'\r', b'\n', &text[start..]).is_some();
        (self.skip, self.from) = (None, start);
        if let [b'/', rest @ ..] = &text[start..] {
            let digits = rest.iter().take_while(|b| b.is_ascii_digit()).count();
            let level = rest[..digits].iter().fold(0u8, |n, b| n.saturating_mul(10).saturating_add(b - b'0'));
            (self.skip, self.from) = (Some(level), start + 1 + digits);
        }
        let mut at = self.from;
        while let Some(mark) = memchr::memchr2(b'(', b';', &text[at..]) {
            let open = at + mark;
            let rest = &text[open + 1..];
            let close = if text[open] == b'(' { memchr::memchr(b')', rest) } else { None };
            let end = open + 1 + close.unwrap_or(rest.len());
            self.comments.push(Span { start: (open + 1) as u32, end: end as u32 });
            match close {
                Some(_) => at = end + 1,
                None => break,
            }
        }
        self.span.end = self.end_of_words(text, start) as u32;
        self.end = end;
    }

    /// Where the words end behind which only comments stand.
    fn end_of_words(&self, text: &[u8], start: usize) -> usize {
        let mut end = text.len();
        for comment in self.comments.iter().rev() {
            if (comment.end as usize + 1).min(text.len()) < end {
                break;
            }
            let before = &text[start..comment.start as usize - 1];
            end = start + before.iter().rposition(|b| !is_blank(*b)).map_or(0, |last| last + 1);
        }
        if end > start { end } else { (start + 1).min(text.len()) }
    }
}

/// The words of a line, blanks in place of comments.
#[cold]
pub(super) fn without(line: &Line, text: &[u8]) -> Vec<u8> {
    let mut words = text[..line.end].to_vec();
    for comment in &line.comments {
        let (from, to) = (comment.start as usize - 1, (comment.end as usize + 1).min(words.len()));
        words[from..to].fill(b' ');
    }
    words.split_off(line.from)
}
