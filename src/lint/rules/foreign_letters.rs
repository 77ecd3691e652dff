//! A comment holds letters that controls do not show.

use crate::lint::motion::Setup;
use crate::lint::source::{Read, Report, SourceRule};

super::rule! { L2015 Source ForeignLetters Note off "comment-foreign-letters"
    what "comment holds letters that controls do not show"
    why "A comment holds characters beyond ASCII. Controls show them as other signs or not at all, and some refuse the file. Off by \
        default. Said once."
    example r#"
-- Example (L2015_fires.H)
0 BEGIN PGM P MM
; A letter beyond ASCII.
1 L X+0 Y+0 Z+5 R0 F300
; Außenkontur
2 L Z+50 FMAX M30
3 END PGM P MM
-- partc.toml
# Every rule.
[lint]
select = ["all"]
"#
    says {
        foreign() "this comment holds letters beyond ASCII" help "write it without accents and special signs";
    }
}

#[derive(Debug, Default)]
pub(super) struct ForeignLetters {
    said: bool,
}

impl ForeignLetters {
    pub(super) fn new(_: &Setup<'_>) -> ForeignLetters {
        ForeignLetters::default()
    }
}

impl SourceRule for ForeignLetters {
    fn block(&mut self, read: &Read<'_>, report: &mut Report<'_>) {
        let foreign = read.block.comments.iter().find(|comment| !comment.of(read.block.text).is_ascii());
        if let Some(comment) = foreign.filter(|_| !self.said) {
            self.said = true;
            let found = L2015::foreign().at(read.loc(*comment));
            report.say.found(found);
        }
    }
}
