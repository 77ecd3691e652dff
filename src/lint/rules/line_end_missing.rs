//! The last block has no line end.

use crate::lint::fix::Fix;
use crate::lint::motion::Setup;
use crate::lint::source::{Read, Report, SourceRule};
use crate::text::{FileId, Loc, Sources, Span};

super::rule! { L2011 Source LineEndMissing Note off "line-end-missing"
    what "last block has no line end"
    why "The last line of the file does not end. Some controls and transfer programs lose such a block, which is most often the end \
        of the program. Off by default; `partc check --fix` ends it."
    example r#"
-- Example (L2011_fires.H)
0 BEGIN PGM P MM
; The file ends after the last letter.
1 L X+0 Y+0 Z+5 R0 F300
2 END PGM P MM
-- partc.toml
# Every rule.
[lint]
select = ["all"]
"#
    says {
        missing() "the last block has no line end" help "end the line";
    }
}

#[derive(Debug)]
pub(super) struct LineEndMissing<'a> {
    /// Its words, the offset behind it, and how many bytes of padding follow.
    last: Option<(Loc, u32, u32)>,
    /// Where the last line begins.
    line: u32,
    size: u64,
    sources: &'a Sources,
}

impl<'a> LineEndMissing<'a> {
    pub(super) fn new(setup: &Setup<'a>) -> LineEndMissing<'a> {
        LineEndMissing { last: None, line: 0, size: setup.size, sources: setup.sources }
    }

    /// Does the line in front of the last one end in CR LF?
    fn is_windows(&self) -> bool {
        let before = Span { start: self.line.saturating_sub(2), end: self.line };
        self.sources.bytes(FileId(0), before) == b"\r\n"
    }
}

impl SourceRule for LineEndMissing<'_> {
    fn block(&mut self, read: &Read<'_>, _: &mut Report<'_>) {
        let (block, site) = (read.block, &read.block.site);
        // Ctrl-Z and NUL, which a transmission puts behind the last line, are no part of it.
        let padding = block.text.iter().rev().take_while(|b| matches!(b, 0 | 0x1A)).count();
        if padding > 0 && padding == block.text.len() {
            self.last = None;
            return;
        }
        let end = site.at + (block.text.len() - padding) as u32;
        self.line = site.at;
        self.last = Some((read.words(), end, padding as u32));
    }

    fn finish(&mut self, report: &mut Report<'_>) {
        let ends_there = |(_, end, padding): &(Loc, u32, u32)| u64::from(*end) + u64::from(*padding) >= self.size;
        let Some((loc, end, _)) = self.last.filter(ends_there) else { return };
        let found = L2011::missing().at(loc);
        let text = if self.is_windows() { b"\r\n".to_vec() } else { b"\n".to_vec() };
        let fix = Fix::new(&found, Span::at(end, 0), text);
        report.found_with(found, fix);
    }
}
