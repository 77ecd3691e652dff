//! The lines of one file that a finding shows, as miette wants them.
//!
//! In: the place of the finding, then places that explain it. Out: pieces of lines that follow each other, that of the finding first, each
//! with the marks in it. A place that cannot be marked beside the others is not taken.

use std::collections::BTreeMap;

use miette::{LabeledSpan, MietteError, MietteSpanContents, SourceCode, SourceSpan, SpanContents};

use crate::text::decode::harmless_lines;
use crate::text::sources::Line;
use crate::text::{Loc, Sources};

#[derive(Debug)]
pub(super) struct Excerpt {
    name: String,
    /// Lines by their numbers, until they are put together.
    lines: BTreeMap<u32, String>,
    marks: Vec<Mark>,
    /// The pieces, one after the other.
    text: String,
    pieces: Vec<Piece>,
}

#[derive(Debug)]
struct Mark {
    line: u32,
    /// 1-based, in the whole line.
    column: u32,
    /// Bytes in the line, and once the pieces are made, in the text.
    start: usize,
    end: usize,
    label: Option<String>,
}

/// Lines that follow each other: bytes of the text, and the number of the first.
#[derive(Debug)]
struct Piece {
    start: usize,
    end: usize,
    first: u32,
    lines: usize,
}

impl Mark {
    fn new(line: &Line, label: &str) -> Mark {
        let (start, end) = line.marked;
        let label = (!label.is_empty()).then(|| harmless_lines(label));
        // A mark at the end of the line has something under it.
        Mark { line: line.number, column: line.column, start, end: end.max(start + 1), label }
    }
}

impl Excerpt {
    pub fn new(loc: Loc, label: &str, sources: &Sources) -> Excerpt {
        let line = sources.line(loc);
        Excerpt {
            name: sources.shown(loc.file),
            marks: vec![Mark::new(&line, label)],
            lines: BTreeMap::from([(line.number, line.text)]),
            text: String::new(),
            pieces: Vec::new(),
        }
    }

    /// Marks a further place, unless it lies in another file than the `first`, or two marks would lie over each other.
    pub fn takes(&mut self, first: Loc, loc: Loc, label: &str, sources: &Sources) -> bool {
        if loc.file != first.file {
            return false;
        }
        let line = sources.line(loc);
        let mark = Mark::new(&line, label);
        // Of a long line each place shows another part.
        let is_other_part = self.lines.get(&line.number).is_some_and(|known| *known != line.text);
        let is_over = |other: &Mark| other.line == mark.line && other.start < mark.end && mark.start < other.end;
        if is_other_part || self.marks.iter().any(is_over) {
            return false;
        }
        self.lines.insert(line.number, line.text);
        self.marks.push(mark);
        true
    }

    /// Puts the lines together.
    pub fn in_pieces(mut self) -> Excerpt {
        let mut runs: Vec<Vec<(u32, String)>> = Vec::new();
        for (number, text) in std::mem::take(&mut self.lines) {
            match runs.last_mut() {
                Some(run) if run.last().is_some_and(|(last, _)| last + 1 == number) => run.push((number, text)),
                _ => runs.push(vec![(number, text)]),
            }
        }
        // That of the finding first, then as they explain it.
        let first = |run: &Vec<(u32, String)>| {
            self.marks.iter().position(|mark| run.iter().any(|(number, _)| *number == mark.line))
        };
        runs.sort_by_key(first);
        for run in runs {
            let (start, first, lines) = (self.text.len(), run[0].0, run.len());
            for (number, line) in run {
                let at = self.text.len();
                self.text += &line;
                for mark in self.marks.iter_mut().filter(|mark| mark.line == number) {
                    mark.start += at;
                    mark.end += at;
                    if mark.end > self.text.len() {
                        self.text.push(' ');
                    }
                }
                self.text.push('\n');
            }
            // The last line end belongs to no piece.
            self.pieces.push(Piece { start, end: self.text.len() - 1, first, lines });
        }
        self
    }

    pub fn labels(&self) -> impl Iterator<Item = LabeledSpan> + '_ {
        self.marks.iter().enumerate().map(|(at, mark)| {
            let span = (mark.start, mark.end - mark.start);
            match at {
                0 => LabeledSpan::new_primary_with_span(mark.label.clone(), span),
                _ => LabeledSpan::new_with_span(mark.label.clone(), span),
            }
        })
    }
}

impl SourceCode for Excerpt {
    /// The piece that holds the span; no span goes over two. For the head of a piece, without lines around it, the place of the mark.
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        before: usize,
        after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let (start, end) = (span.offset(), span.offset() + span.len());
        let is_in = |piece: &&Piece| piece.start <= start && end <= piece.end;
        let piece = self.pieces.iter().find(is_in).ok_or(MietteError::OutOfBounds)?;
        let mark = self.marks.iter().find(|mark| mark.start == start).filter(|_| (before, after) == (0, 0));
        let (line, column) = mark.map_or((piece.first, 1), |mark| (mark.line, mark.column));
        Ok(Box::new(MietteSpanContents::new_named(
            self.name.clone(),
            &self.text.as_bytes()[piece.start..piece.end],
            SourceSpan::from((piece.start, piece.end - piece.start)),
            line.saturating_sub(1) as usize,
            column.saturating_sub(1) as usize,
            piece.lines,
        )))
    }
}
