//! A comment says that something is to be done.

use crate::lint::motion::Setup;
use crate::lint::source::{Read, Report, SourceRule};

super::rule! { L2013 Source Unfinished Note off "comment-unfinished"
    what "comment says that something is to be done"
    why "A comment holds TODO, FIXME or XXX: whoever wrote the program meant to come back. Off by default."
    example r#"
-- Example (L2013_fires.H)
0 BEGIN PGM P MM
; Something is to be done.
1 L X+0 Y+0 Z+5 R0 F300
; TODO measure
2 L Z+50 FMAX M30
3 END PGM P MM
-- partc.toml
# Every rule.
[lint]
select = ["all"]
"#
    says {
        unfinished() "this comment says that something is to be done" help "do it, and remove the comment";
    }
}

#[derive(Debug)]
pub(super) struct Unfinished;

impl Unfinished {
    pub(super) fn new(_: &Setup<'_>) -> Unfinished {
        Unfinished
    }
}

impl SourceRule for Unfinished {
    fn block(&mut self, read: &Read<'_>, report: &mut Report<'_>) {
        for comment in read.block.comments {
            let text = comment.of(read.block.text);
            let words = text.split(|b| !b.is_ascii_alphanumeric());
            if words.into_iter().any(|word| matches!(word, b"TODO" | b"FIXME" | b"XXX")) {
                let found = L2013::unfinished().at(read.loc(*comment));
                report.say.found(found);
            }
        }
    }
}
