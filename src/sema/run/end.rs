//! Where a file ends without an end of program: most often it was cut off in transfer.

use std::ops::ControlFlow;

use crate::diag::{Answer, codes};
use crate::text::{Loc, Next, Span};

use super::Language;
use super::core::Core;

/// Bytes at the end of a file that are looked at for what ends its last line.
const TAIL: u32 = 64 * 1024;

/// Does the text end its last line? NUL, Ctrl-Z and blanks behind a line end are padding.
fn ends_its_line(text: &[u8]) -> bool {
    let last = text.iter().rfind(|byte| !matches!(byte, 0 | 0x1a | b' ' | b'\t'));
    matches!(last, Some(b'\n' | b'\r'))
}

/// The lines that hold something, without the blanks around it.
fn lines(text: &[u8]) -> impl DoubleEndedIterator<Item = &[u8]> {
    let is_blank = |b: &u8| b.is_ascii_whitespace() || matches!(b, 0 | 0x0b | 0x1a);
    text.split(|b| matches!(b, b'\n' | b'\r')).filter_map(move |line| {
        let start = line.iter().position(|b| !is_blank(b))?;
        let end = line.iter().rposition(|b| !is_blank(b))?;
        Some(&line[start..=end])
    })
}

impl<L: Language> Core<'_, L> {
    /// The last byte of the file that runs, which has no further block.
    pub fn end_of_text(&mut self) -> Loc {
        let source = &self.program().source;
        let place = source.cursor.place();
        let span = Span::at(place.at.saturating_sub(1), 1);
        Loc { file: source.file, line: place.line.saturating_sub(1).max(1), span }
    }

    /// The first thing behind the end of a program in its file: `found` says which words of a block are one, and may end the search.
    pub fn first_behind(
        &mut self,
        program: usize,
        mut found: impl FnMut(&[u8]) -> ControlFlow<Option<Span>>,
    ) -> Option<Loc> {
        let sources = self.job.sources;
        let source = &mut self.programs[program].source;
        loop {
            let (file, block) = match source.cursor.next(sources) {
                Ok(Next::Block(block)) => (source.file, block),
                Ok(Next::TooLong { .. }) => continue,
                Ok(Next::End) | Err(_) => return None,
            };
            if let ControlFlow::Break(words) = found(block.text) {
                return words.map(|words| Loc { file, line: block.line, span: words.shifted(block.at) });
            }
        }
    }

    /// Is the main program one between two lines of `%`? The second one ends the file, as it ended a tape (LinuxCNC User Manual,
    /// "Program structure").
    pub fn is_between_percents(&self) -> bool {
        let file = self.job.main;
        let size = u32::try_from(self.job.sources.size(file)).unwrap_or(u32::MAX);
        let bytes = |start: u32, end: u32| self.job.sources.bytes(file, Span { start, end });
        let (head, tail) = (bytes(0, size.min(TAIL)), bytes(size.saturating_sub(TAIL), size));
        let first = lines(&head).next();
        let mut behind = lines(&tail).rev();
        first == Some(b"%") && behind.next() == Some(b"%") && behind.next().is_some()
    }

    /// May the main program end here, where `end` is missing? `best` of its words is to be added; `alarm` is what the control shows. What was said of it stops nothing: the
    /// run is over anyway.
    pub fn may_end_open(&mut self, end: &str, best: &str, alarm: Option<u32>) -> bool {
        !self.is_cut_off(end, best) && self.piece_may_end_open(end, best, alarm)
    }

    /// The same of a piece that another program joins to others, whose last line needs no line end.
    pub fn piece_may_end_open(&mut self, end: &str, best: &str, alarm: Option<u32>) -> bool {
        if self.job.settings.control.open_end {
            return true;
        }
        let loc = self.end_of_text();
        self.report(
            codes::P0007::program_ends(&end, &best)
                .answer(Answer::key("control", "open_end").one_of(&["\"allow\""]))
                .alarm(alarm)
                .at(loc),
        );
        false
    }

    /// The program ends in the block in hand. Where `M2` is the last that the file holds, without a line end, it may be the beginning
    /// of `M20` or `M2=3`: that is said. `M30` and `M17` are words that nothing goes on.
    pub fn end_is_whole(&self) {
        let Loc { file, span, .. } = self.here.origin.loc;
        let size = u32::try_from(self.job.sources.size(file)).unwrap_or(u32::MAX);
        if size.saturating_sub(span.end) > TAIL {
            return;
        }
        let behind = self.job.sources.bytes(file, Span { start: span.end, end: size });
        if behind.iter().any(|byte| !matches!(byte, 0 | 0x1a)) {
            return;
        }
        let block = self.job.sources.bytes(file, span);
        let stem = block.strip_suffix(b"2").unwrap_or_default().trim_ascii_end();
        if !stem.last().is_some_and(|letter| letter.eq_ignore_ascii_case(&b'M')) {
            return;
        }
        self.report_cause(codes::P0008::file_stops_in_its_last_line_after().at(self.here.origin.loc));
    }

    /// Does the last line of the file have no line end either? Then the rest of it is missing, in a subprogram, too.
    pub fn is_cut_off(&mut self, end: &str, best: &str) -> bool {
        let loc = self.end_of_text();
        let behind = loc.span.end;
        let tail = self.job.sources.bytes(loc.file, Span { start: behind.saturating_sub(TAIL), end: behind });
        if ends_its_line(&tail) {
            return false;
        }
        self.report(codes::P0008::file_stops_in_its_last_line(&end, &best).at(loc));
        true
    }
}
