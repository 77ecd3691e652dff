//! Source text: where it comes from, how it is cut into logical blocks, how it is shown.
//!
//! In: bytes of any encoding. Out: [`BlockText`] slices with their place. Never copies a block,
//! never interprets a word, never opens a file itself (that is [`Files`]).

pub mod block_numbers;
pub mod blocks;
pub mod decode;
pub mod files;
pub mod lines;
mod nul_bytes;
pub mod number;
pub mod sources;

pub use block_numbers::BlockNumbers;
pub use blocks::{Cursor, Next};
pub use files::{ControlFolder, FileError, Files, Folder, Memory, Opened, ReadAt, Request, Within};
pub use lines::SplitRules;
pub use sources::{FileId, Sources};

/// A range of bytes in one file; `end` is exclusive. Files are at most 4 GiB.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Span {
    pub start: u32,
    pub end: u32,
}

impl Span {
    /// Span of `len` bytes from `start`.
    pub fn at(start: u32, len: u32) -> Span {
        Span { start, end: start.saturating_add(len) }
    }

    /// Smallest span that covers both.
    pub fn to(self, other: Span) -> Span {
        Span { start: self.start.min(other.start), end: self.end.max(other.end) }
    }

    /// The same span with its offsets counted from `origin` on.
    pub fn shifted(self, origin: u32) -> Span {
        Span { start: self.start.saturating_add(origin), end: self.end.saturating_add(origin) }
    }

    /// The bytes of the span in `text`; empty where the span does not lie in it.
    pub fn of(self, text: &[u8]) -> &[u8] {
        text.get(self.start as usize..self.end as usize).unwrap_or_default()
    }

    pub fn is_empty(self) -> bool {
        self.end <= self.start
    }
}

/// A place in a file: the span, and the 1-based line on which the block of the span begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Loc {
    pub file: FileId,
    pub line: u32,
    pub span: Span,
}

impl Loc {
    /// The same block, another span.
    pub fn with_span(self, span: Span) -> Loc {
        Loc { span, ..self }
    }
}

/// Place of a block: what a jump needs to come back to it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Place {
    pub at: u32,
    pub line: u32,
}
