//! A comment reads like a block.

use crate::lint::motion::Setup;
use crate::lint::source::{Read, Report, SourceRule};

super::rule! { L2007 Source CommentIsCode Note off "comment-is-code"
    what "comment reads like a block"
    why "A comment holds what would be a block with coordinates or a G function without the sign of the comment. Blocks that were \
        switched off for a test and forgotten are the most frequent reason why a part lacks something. Off by default."
    example r#"
-- Example (L2007_fires.H)
0 BEGIN PGM P MM
; A block that was switched off.
1 L X+0 Y+0 Z+5 R0 F300
; L X+50 Y+20 F200
2 L Z+50 FMAX M30
3 END PGM P MM
-- partc.toml
# Every rule.
[lint]
select = ["all"]
"#
    says {
        is_code() "this comment reads like a block" help "remove it, or let it run";
    }
}

#[derive(Debug)]
pub(super) struct CommentIsCode;

impl CommentIsCode {
    pub(super) fn new(_: &Setup<'_>) -> CommentIsCode {
        CommentIsCode
    }
}

impl SourceRule for CommentIsCode {
    fn block(&mut self, read: &Read<'_>, report: &mut Report<'_>) {
        for comment in read.block.comments {
            let text = comment.of(read.block.text);
            if is_code(text) {
                let found = L2007::is_code().at(read.loc(*comment));
                report.say.found(found);
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
