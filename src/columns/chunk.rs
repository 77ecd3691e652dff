//! What goes from the thread that runs the program to the one that fills columns.

use crate::ir::motion::Move;
use crate::ir::{Function, Pos};

/// Items that go together: few enough for the caches of a processor.
pub(super) const MOST: usize = 2048;

/// Some items of the motion stream, with what only the sources of the program know.
#[derive(Debug, Default)]
pub(super) struct Chunk {
    pub items: Vec<Item>,
    /// Block numbers of the moves in ASCII, one behind the other.
    pub numbers: Vec<u8>,
    /// Names that are new: their keys are the next ones of their lists.
    pub files: Vec<String>,
    pub call_paths: Vec<String>,
}

#[derive(Debug)]
pub(super) enum Item {
    Move(Row),
    Function(Function),
    Lost,
    BeginsAt(Pos),
}

/// A move, and where it comes from.
#[derive(Debug)]
pub(super) struct Row {
    pub mv: Move,
    pub line: u32,
    /// Where its block number ends in the text of the chunk; the one before ends where it begins.
    pub number: Option<u32>,
    /// Key of its file.
    pub file: i32,
    /// Key of its call path; a block of the main program has none.
    pub call_path: Option<i32>,
}

impl Chunk {
    pub fn is_full(&self) -> bool {
        self.items.len() >= MOST
    }

    pub fn clear(&mut self) {
        self.items.clear();
        self.numbers.clear();
        self.files.clear();
        self.call_paths.clear();
    }
}
