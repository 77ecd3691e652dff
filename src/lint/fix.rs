//! How a finding is mended: another text for bytes of the program.

use crate::diag::{Code, Diagnostic};
use crate::sema::Job;
use crate::sema::run::survey::{Surveyed, Visitor, Wanted, What};
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

/// Numbers blocks anew.
#[derive(Debug)]
pub struct Renumber {
    step: u32,
    next: u32,
    changes: Vec<(Span, Vec<u8>)>,
    /// A jump leads to a number.
    jumps: bool,
}

impl Renumber {
    /// Counts by `step`; by one from 0.
    pub fn new(step: u32) -> Renumber {
        Renumber { step, next: if step == 1 { 0 } else { step }, changes: Vec::new(), jumps: false }
    }

    /// What is written in place of the numbers; nothing where a jump leads to one.
    pub fn changes(self) -> Vec<(Span, Vec<u8>)> {
        if self.jumps { Vec::new() } else { self.changes }
    }
}

impl Visitor for Renumber {
    fn wanted(&self) -> Wanted<'_> {
        Wanted::ALL
    }

    fn items(&self) -> bool {
        true
    }

    fn block(&mut self, block: &Surveyed<'_>, _: &Job<'_>) {
        self.jumps |= block.items.iter().any(|item| match &item.what {
            What::Uses(name) => name.starts_with('N'),
            what => *what == What::UsesUnknown,
        });
        if block.number.is_none() {
            return;
        }
        let head = block.text.iter().position(|b| !(b.is_ascii_whitespace() || matches!(b, b'/' | b'N' | b'n' | b':')));
        let Some(from) = head else { return };
        let digits = block.text[from..].iter().take_while(|b| b.is_ascii_digit()).count();
        let span = Span::at(block.site.at + from as u32, digits as u32);
        let number = self.next;
        self.next = number.saturating_add(self.step);
        // `/1` has a level behind its mark; without N it is the number of the block for some controls.
        let is_number = !block.skip || block.text[..from].ends_with(b"N") || block.text[..from].ends_with(b"n");
        if digits > 0 && is_number {
            self.changes.push((span, number.to_string().into_bytes()));
        }
    }
}
