//! Physical lines of a file: how they end, how they join to blocks, and which are known to be straight moves.

use super::Place;

/// Bytes read at a time.
pub(super) const CHUNK: usize = 256 * 1024;

/// How a dialect joins physical lines.
#[derive(Debug, Clone, Copy)]
pub struct SplitRules {
    /// A byte without which no line continues; lines without it are not asked about.
    pub mark: u8,
    /// Does the block go on after this physical line? The second argument is true for a line that is
    /// itself a continuation.
    pub continues: fn(&[u8], bool) -> bool,
}

/// Straight lines in a row: nothing but axes, a feed, and G0 or G1, with nothing wrong in them. Who went through the file
/// once need not look at them again.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Stretch {
    pub start: Place,
    pub end: Place,
    /// The first and the last of their block numbers, which rise.
    pub numbers: Option<(u32, u32)>,
}

/// The byte that ends the lines of a file which begins so: a file without a single line feed but with
/// carriage returns ends its lines with those.
pub(super) fn line_end(head: &[u8]) -> u8 {
    let returns = memchr::memchr(b'\n', head).is_none() && memchr::memchr(b'\r', head).is_some();
    if returns { b'\r' } else { b'\n' }
}
