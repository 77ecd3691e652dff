//! What stands around a program in its file: the header of a transfer file, and the `%` of a paper tape.
//!
//! Source: M 2.1 (docs/sources.md).

use crate::diag::codes;
use crate::parser::mtc200::ast::{Block, Stmt};
use crate::text::Span;

use super::{Outcome, Run};

/// What may follow the last line of a program, in bytes.
const LONGEST_TAIL: u64 = 1 << 16;

/// Where a program stands with its file header.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum Header {
    /// Nothing was read yet.
    #[default]
    Start,
    Open,
    Closed,
    /// A program without header.
    None,
}

impl Run<'_> {
    /// A line that only a file header has.
    #[cold]
    pub(super) fn header_line(&mut self, first: u8, block: &Block, text: &[u8]) {
        if first == b'%' && text.trim_ascii() == b"%" && self.is_tape_mark() {
            return self.tape_mark(block);
        }
        let is_frame = text.len() >= 4 && text[..4].eq_ignore_ascii_case(b"%NPG");
        let header = self.core.program().known.header;
        let (next, fits) = match (first, header) {
            (b'%', Header::Start) => (Header::Open, is_frame),
            (b'%', Header::Open) => (Header::Closed, is_frame && text.trim_ascii().len() == 4),
            (b'%', other) => (other, false),
            (_, Header::Open) => (Header::Open, true),
            (_, other) => (other, false),
        };
        self.core.program().known.header = next;
        if !fits {
            let span = block.span;
            let _: Outcome = self.core.refuse(span, codes::M1002::this_line_belongs_into_file_header());
            return;
        }
        if matches!(first, b'*' | b'$') {
            self.comment(&text[1..]);
        }
    }

    /// A line of the program where a header might stand.
    #[cold]
    pub(super) fn leave_header(&mut self, block: &Block) {
        let blank = block.stmt == Stmt::Empty && block.label.is_none();
        match self.core.program().known.header {
            Header::Open if !(blank && block.comments.is_empty()) => {
                self.core.program().known.header = Header::Closed;
                let _: Outcome = self.core.refuse(block.span, codes::M1002::this_line_stands_in_file_header());
            }
            Header::Start if !blank => self.core.program().known.header = Header::None,
            _ => {}
        }
    }

    /// Is a line of a single `%` the first or the last one that is not blank?
    fn is_tape_mark(&mut self) -> bool {
        if self.core.program().known.header == Header::Start {
            return true;
        }
        let (file, at) = (self.core.program().source.file, self.core.program().source.cursor.place().at);
        let rest = self.core.job.sources.size(file).saturating_sub(u64::from(at));
        rest <= LONGEST_TAIL
            && self
                .core
                .job
                .sources
                .bytes(file, Span::at(at, rest as u32))
                .iter()
                .all(|b| b.is_ascii_whitespace() || matches!(b, 0 | 0x0b | 0x1a))
    }

    fn tape_mark(&mut self, block: &Block) {
        if self.core.program().known.header == Header::Start {
            self.core.program().known.header = Header::None;
        }
        self.core.report(codes::M8001::that_stands_alone_is_mark_of_tape().at(self.core.loc(block.span)));
    }
}
