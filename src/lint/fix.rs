//! How a finding is mended: another text for bytes of the program.

use crate::diag::{Code, Diagnostic};
use crate::text::Span;

/// A change that a rule proposes. Whether the program still does the same is for the caller to see.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fix {
    pub code: &'static Code,
    /// Where its finding begins in the main program.
    pub at: u32,
    pub span: Span,
    pub text: Vec<u8>,
}

impl Fix {
    /// Puts `text` in the place of bytes.
    pub fn new(found: &Diagnostic, span: Span, text: Vec<u8>) -> Fix {
        Fix { code: found.code, at: found.label.loc.span.start, span, text }
    }

    /// Takes the words of a finding out of a block that begins at `start`, and the blanks in front of them.
    pub fn removal(found: &Diagnostic, block: &[u8], start: u32) -> Fix {
        let words = found.label.loc.span;
        let from = words.start.saturating_sub(start) as usize;
        let before = block.get(..from).unwrap_or_default();
        let blanks = before.len() - before.trim_ascii_end().len();
        Fix::new(found, Span { start: words.start - blanks as u32, end: words.end }, Vec::new())
    }
}
