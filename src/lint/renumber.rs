//! Block numbers in order.

use crate::sema::Job;
use crate::sema::run::survey::{Surveyed, Visitor, Wanted, What};
use crate::text::Span;

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
