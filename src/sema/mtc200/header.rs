//! What stands around a program in its file: the header of a transfer file, and the `%` of a paper tape.
//!
//! Source: M 2.1 (docs/sources.md).

use crate::diag::codes;
use crate::parser::mtc200::ast::{Block, Stmt};
use crate::text::Span;

use super::Core;

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

impl Core<'_> {
    /// A line that only a file header has: the comment in it.
    #[cold]
    pub(super) fn header_line<'t>(&mut self, first: u8, block: &Block, text: &'t [u8]) -> Option<&'t [u8]> {
        if first == b'%' && text.trim_ascii() == b"%" && self.is_tape_mark() {
            if self.program().known.header == Header::Start {
                self.program().known.header = Header::None;
            }
            self.say(block.span, codes::M8001::that_stands_alone_is_mark_of_tape());
            return None;
        }
        let is_frame = text.len() >= 4 && text[..4].eq_ignore_ascii_case(b"%NPG");
        let header = self.program().known.header;
        let (next, fits) = match (first, header) {
            (b'%', Header::Start) => (Header::Open, is_frame),
            (b'%', Header::Open) => (Header::Closed, is_frame && text.trim_ascii().len() == 4),
            (b'%', other) => (other, false),
            (_, Header::Open) => (Header::Open, true),
            (_, other) => (other, false),
        };
        self.program().known.header = next;
        if !fits {
            self.say(block.span, codes::M1002::this_line_belongs_into_file_header());
            return None;
        }
        matches!(first, b'*' | b'$').then(|| &text[1..])
    }

    /// A line of the program where a header might stand.
    #[cold]
    pub(super) fn leave_header(&mut self, block: &Block) {
        let blank = block.stmt == Stmt::Empty && block.label.is_none();
        match self.program().known.header {
            Header::Open if !(blank && block.comments.is_empty()) => {
                self.program().known.header = Header::Closed;
                self.say(block.span, codes::M1002::this_line_stands_in_file_header());
            }
            Header::Start if !blank => self.program().known.header = Header::None,
            _ => {}
        }
    }

    /// Is a line of a single `%` the first or the last one that is not blank?
    fn is_tape_mark(&mut self) -> bool {
        if self.program().known.header == Header::Start {
            return true;
        }
        let (file, at) = (self.program().source.file, self.program().source.cursor.place().at);
        let rest = self.job.sources.size(file).saturating_sub(u64::from(at));
        rest <= LONGEST_TAIL
            && self
                .job
                .sources
                .bytes(file, Span::at(at, rest as u32))
                .iter()
                .all(|b| b.is_ascii_whitespace() || matches!(b, 0 | 0x0b | 0x1a))
    }
}
