//! How a finding is mended: another text for bytes of the program.

use crate::diag::Code;
use crate::text::Span;

/// A change that a rule proposes. Whether the program still does the same is for the caller to see.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fix {
    pub code: &'static Code,
    /// In the main program.
    pub span: Span,
    pub text: Vec<u8>,
    /// May it change what the control does beside the path, so that it is made on request only?
    pub is_unsafe: bool,
}

impl Fix {
    /// Takes words out of a block that begins at `start`, and the blanks in front of them.
    pub fn removal(code: &'static Code, words: Span, block: &[u8], start: u32) -> Fix {
        let from = words.start.saturating_sub(start) as usize;
        let before = block.get(..from).unwrap_or_default();
        let blanks = before.len() - before.trim_ascii_end().len();
        let span = Span { start: words.start - blanks as u32, end: words.end };
        Fix { code, span, text: Vec::new(), is_unsafe: false }
    }
}
