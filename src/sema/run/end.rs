//! Where a file ends without an end of program: most often it was cut off in transfer.

use crate::diag::{Diagnostic, codes};
use crate::text::{Loc, Span};

use super::Language;
use super::core::Core;

/// Bytes at the end of a file that are looked at for what ends its last line.
const TAIL: u32 = 64 * 1024;

/// Does the text end its last line? NUL, Ctrl-Z and blanks behind a line end are padding.
fn ends_its_line(text: &[u8]) -> bool {
    let last = text.iter().rfind(|byte| !matches!(byte, 0 | 0x1a | b' ' | b'\t'));
    matches!(last, Some(b'\n' | b'\r'))
}

impl<L: Language> Core<'_, L> {
    /// The last byte of the file that runs, which has no further block.
    pub fn end_of_text(&mut self) -> Loc {
        let source = &self.program().source;
        let place = source.cursor.place();
        let span = Span::at(place.at.saturating_sub(1), 1);
        Loc { file: source.file, line: place.line.saturating_sub(1).max(1), span }
    }

    /// May the main program end here, where `end` is missing? What was said of it stops nothing: the run is over anyway.
    pub fn may_end_open(&mut self, end: &str) -> bool {
        if self.is_cut_off(end) {
            return false;
        }
        if self.job.settings.control.open_end {
            return true;
        }
        let loc = self.end_of_text();
        let help = format!(
            "the file may have been cut off in transfer: compare it with the original; if it is complete, write {end} as its last \
             block; where the control needs none, `[control] open_end = \"allow\"` in partc.toml says so"
        );
        self.report(Diagnostic::new(codes::P0007, loc, format!("the program ends without {end}")).help(help));
        false
    }

    /// Does the last line of the file have no line end either? Then the rest of it is missing, in a subprogram, too.
    pub fn is_cut_off(&mut self, end: &str) -> bool {
        let loc = self.end_of_text();
        let behind = loc.span.end;
        let tail = self.job.sources.bytes(loc.file, Span { start: behind.saturating_sub(TAIL), end: behind });
        if ends_its_line(&tail) {
            return false;
        }
        let message = format!("the file ends inside a line, without {end}: it was cut off");
        let help = format!("get the file anew from where it was made; if it is complete, end its last line, and write {end} behind it");
        self.report(Diagnostic::new(codes::P0008, loc, message).help(help));
        true
    }
}
