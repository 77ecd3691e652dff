//! A comment reads like a block.

use crate::diag::{Diagnostic, codes};
use crate::lint::motion::Setup;
use crate::lint::source::{Read, SourceRule, Told};

#[derive(Debug)]
pub(super) struct CommentIsCode;

impl CommentIsCode {
    pub(super) fn new(_: &Setup<'_>) -> CommentIsCode {
        CommentIsCode
    }
}

impl SourceRule for CommentIsCode {
    fn block(&mut self, read: &Read<'_>, told: &mut Told<'_>) {
        for comment in read.block.comments {
            let text = comment.of(read.block.text);
            if is_code(text) {
                let found = Diagnostic::new(codes::L2007, read.loc(*comment), "this comment reads like a block");
                told.say.found(found.help("remove it, or let it run"));
            }
        }
    }
}

/// Letters and numbers as in a block: a G function, or two words with coordinates at least.
fn is_code(text: &[u8]) -> bool {
    let words = text.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
    let (mut axes, mut others, mut prose) = (0, 0, 0);
    for word in words.take(12) {
        let letter = word[0].to_ascii_uppercase();
        let rest = &word[1..];
        let number =
            !rest.is_empty() && rest.iter().all(|b| b.is_ascii_digit() || matches!(b, b'.' | b',' | b'+' | b'-'));
        match letter {
            b'X' | b'Y' | b'Z' | b'C' if number => axes += 1,
            b'G' | b'F' | b'M' | b'N' | b'S' if number => others += 1,
            b'L' if rest.is_empty() => others += 1,
            b'0'..=b'9' if word.iter().all(u8::is_ascii_digit) => {}
            _ => prose += 1,
        }
    }
    prose == 0 && axes >= 1 && axes + others >= 2
}
