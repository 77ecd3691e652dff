//! The printed lines: collects them, keeps their limits, hands them to the output.

use std::io;

use crate::diag::{Answer, Diags, codes};
use crate::ir::Origin;
use crate::target::{Line, Sequence};
use crate::text::Loc;

use super::line::Text;
use super::{LineMap, Output};

/// Bytes collected before they are written.
const CHUNK: usize = 1 << 20;
/// The first piece is smaller: who waits for the output sees it sooner.
const FIRST_CHUNK: usize = 1 << 14;
/// What a block number takes of a line.
const NUMBER: usize = 9;

/// The output under construction.
pub(super) struct LineWriter<'a> {
    diags: &'a Diags,
    out: &'a mut dyn Output,
    map: Option<&'a mut dyn LineMap>,
    pub text: Text,
    limits: Line,
    /// Block numbers: their step, 0 for none; the next one.
    step: u32,
    number: u64,
    /// Address of the feed, which an over-long line gives away.
    feed: u8,
    /// The feed counts by time: every line needs its own.
    pub by_time: bool,
    /// Bytes after which the text is written.
    chunk: usize,
    /// Somebody reads the text before it is written; up to here he has.
    read: Option<usize>,
    lines: u64,
    most_lines: u64,
    /// The limit of lines is passed: what follows is not printed.
    full: bool,
    error: Option<io::Error>,
}

impl<'a> LineWriter<'a> {
    pub fn new(
        mut limits: Line,
        step: u32,
        feed: u8,
        most_lines: u64,
        diags: &'a Diags,
        out: &'a mut dyn Output,
        map: Option<&'a mut dyn LineMap>,
    ) -> LineWriter<'a> {
        let step = match limits.sequence {
            Sequence::Address(..) => step,
            Sequence::Blocks => 1,
            Sequence::None => 0,
        };
        if step > 0 {
            limits.length -= NUMBER;
        }
        let number = if limits.sequence == Sequence::Blocks { 0 } else { u64::from(step) };
        LineWriter {
            diags,
            out,
            map,
            text: Text::new(CHUNK + 4096, [limits.digits, limits.whole]),
            limits,
            step,
            number,
            feed,
            by_time: false,
            chunk: FIRST_CHUNK,
            read: None,
            lines: 0,
            most_lines,
            full: false,
            error: None,
        }
    }

    pub fn lines(&self) -> u64 {
        self.lines
    }

    #[inline]
    pub fn full(&self) -> bool {
        self.full
    }

    /// Longest line, its block number left out.
    pub fn room(&self) -> usize {
        self.limits.length
    }

    /// A line without a source.
    pub fn plain(&mut self, text: &[u8]) {
        self.text.raw(text);
        if self.limits.sequence == Sequence::Blocks {
            self.number_line();
        }
        self.end_plain();
    }

    fn end_plain(&mut self) {
        self.text.end_line();
        self.lines += 1;
        if self.lines > self.most_lines {
            let start = Loc { line: 1, ..Loc::default() };
            self.too_many(&Origin { loc: start, ..Origin::default() });
        }
    }

    /// Ends the line under construction.
    #[inline(always)]
    pub fn end_line(&mut self, origin: &Origin) {
        if self.text.line_len() > self.limits.length {
            self.split_feed(origin);
        }
        if self.text.take_too_long() {
            self.too_many_digits(origin);
        }
        self.count_line(origin);
        if self.text.len() >= self.chunk && self.read.is_none() {
            self.write_out();
        }
    }

    /// Ends a line that calls a cycle of the control: it may be longer than that of a path.
    pub fn end_call(&mut self, origin: &Origin) {
        if self.text.take_too_long() {
            self.too_many_digits(origin);
        }
        self.count_line(origin);
    }

    /// From here on text stays until [`LineWriter::release`].
    pub fn hold(&mut self) {
        self.read = Some(0);
    }

    /// What was printed since the last release: bytes, of which so many count.
    #[inline]
    pub fn held(&self) -> (&[u8], usize) {
        let from = self.read.unwrap_or(0);
        (self.text.from(from), self.text.len() - from)
    }

    /// What was printed so far may be written.
    #[inline]
    pub fn release(&mut self) {
        self.read = Some(self.text.len());
        if self.text.len() >= self.chunk {
            self.write_out();
        }
    }

    /// A line of words that are known as text.
    pub fn words(&mut self, words: &str, origin: &Origin) {
        self.text.word(words);
        self.end_line(origin);
    }

    /// Writes the rest, and `hash` at its place in the head.
    ///
    /// # Errors
    /// The first error of the output.
    pub fn finish(mut self, hash_at: u64, hash: &str) -> io::Result<()> {
        self.write_out();
        match self.error {
            Some(error) => Err(error),
            None => self.out.patch(hash_at, hash.as_bytes()),
        }
    }

    #[cold]
    fn write_out(&mut self) {
        if self.error.is_none()
            && let Err(error) = self.out.append(self.text.bytes())
        {
            self.error = Some(error);
        }
        self.chunk = CHUNK;
        self.read = self.read.map(|_| 0);
        self.text.clear();
    }

    #[inline(always)]
    fn count_line(&mut self, origin: &Origin) {
        if self.step > 0 {
            self.number_line();
        }
        self.end_unnumbered(origin);
    }

    #[inline(always)]
    fn end_unnumbered(&mut self, origin: &Origin) {
        self.text.end_line();
        self.lines += 1;
        if let Some(map) = &mut self.map {
            map.line(self.lines, origin);
        }
        if self.lines > self.most_lines {
            self.too_many(origin);
        }
    }

    /// The number of a block; behind the largest one they begin anew.
    #[cold]
    fn number_line(&mut self) {
        let step = u64::from(self.step);
        let (address, most) = match self.limits.sequence {
            Sequence::Address(address, most) => (Some(address), u64::from(most)),
            Sequence::Blocks | Sequence::None => (None, u64::MAX),
        };
        self.text.begin_with(address, self.number);
        self.number = if self.number > most - step { step } else { self.number + step };
    }

    /// A line of the frame that is a block.
    pub fn block(&mut self, text: &[u8]) {
        self.text.raw(text);
        if self.step > 0 {
            self.number_line();
        }
        self.end_plain();
    }

    /// A line behind the first one of its block.
    pub fn continued(&mut self, text: &[u8], origin: &Origin) {
        self.text.raw(text);
        self.end_unnumbered(origin);
    }

    /// The target would read the number without its last digits.
    #[cold]
    fn too_many_digits(&mut self, origin: &Origin) {
        let line = String::from_utf8_lossy(self.text.line());
        let asking = match self.limits.whole {
            0 => codes::O9314::target_reads_digits_of_number(&self.limits.digits, &line),
            whole => codes::O9314::target_reads_digits_before_point(&self.limits.digits, &whole, &line),
        };
        let fault = asking.answer(Answer::key("output", "decimals"));
        self.diags.push(fault.at(origin.loc).called(origin.call));
    }

    #[cold]
    fn too_many(&mut self, origin: &Origin) {
        if !std::mem::replace(&mut self.full, true) {
            let asking = codes::P4002::output_has_more_than_lines(&self.most_lines);
            let fault = asking.answer(Answer::key("limits", "output_blocks"));
            self.diags.push(fault.at(origin.loc).called(origin.call));
        }
    }

    /// A line that is too long gives its feed word to a line in front of it, if it may stand there.
    #[cold]
    fn split_feed(&mut self, origin: &Origin) {
        let line = self.text.line().to_vec();
        match line.windows(2).rposition(|pair| pair == [b' ', self.feed]) {
            Some(at) if !self.by_time && at <= self.limits.length => {
                self.text.drop_line();
                self.text.raw(&line[at + 1..]);
                self.count_line(origin);
                self.text.raw(&line[..at]);
            }
            _ => self.too_long(origin),
        }
    }

    #[cold]
    fn too_long(&mut self, origin: &Origin) {
        let line = String::from_utf8_lossy(self.text.line());
        let most = self.limits.length;
        let asking = codes::O9330::target_reads_lines_of_characters(&most, &line, &line.len());
        let fault = asking.answer(Answer::key("output", "decimals"));
        self.diags.push(fault.at(origin.loc).called(origin.call));
    }
}
