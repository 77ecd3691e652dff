//! The last block has no line end.

use crate::diag::{Diagnostic, codes};
use crate::lint::fix::Fix;
use crate::lint::motion::Setup;
use crate::lint::source::{Read, SourceRule, Told};
use crate::text::{Loc, Span};

#[derive(Debug, Default)]
pub(super) struct LineEndMissing {
    /// Its words, and the offset behind it.
    last: Option<(Loc, u32)>,
    /// Lines end in CR LF.
    windows: bool,
    size: u64,
}

impl LineEndMissing {
    pub(super) fn new(setup: &Setup<'_>) -> LineEndMissing {
        LineEndMissing { size: setup.size, ..LineEndMissing::default() }
    }
}

impl SourceRule for LineEndMissing {
    fn block(&mut self, read: &Read<'_>, _: &mut Told<'_>) {
        let (block, site) = (read.block, &read.block.site);
        let end = site.at + block.text.len() as u32;
        self.windows |= site.lines == 1 && self.last.is_some_and(|(_, last)| site.at.saturating_sub(last) > 1);
        self.last = Some((read.words(), end));
    }

    fn finish(&mut self, told: &mut Told<'_>) {
        let Some((loc, end)) = self.last.filter(|(_, end)| u64::from(*end) >= self.size) else { return };
        let found = Diagnostic::new(codes::L2011, loc, "the last block has no line end");
        let found = found.help("end the line");
        let text = if self.windows { b"\r\n".to_vec() } else { b"\n".to_vec() };
        let fix = Fix::new(&found, Span::at(end, 0), text);
        told.found_with(found, fix);
    }
}
