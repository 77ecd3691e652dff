//! The numbers of blocks one after the other, as a list of all moves wants them.

use super::Loc;
use super::sources::{FileId, Sources};

/// Bytes looked at together.
const WINDOW: usize = 1 << 16;
/// Bytes of them in front of a block: its line and the one before begin there.
const BEFORE: usize = 1 << 12;

/// Gives what [`Sources::block_number`] gives, and reads a file that is asked for in order in large pieces.
#[derive(Debug, Default)]
pub struct BlockNumbers {
    /// Pieces of files.
    windows: Vec<Window>,
    /// The file and line that were asked for last, and their number.
    last: Option<(FileId, u32)>,
    has_number: bool,
    /// ASCII
    number: Vec<u8>,
}

#[derive(Debug)]
struct Window {
    file: FileId,
    start: usize,
    text: Vec<u8>,
    line_end: u8,
    /// What a line holds that may go on in the next one.
    joins: Option<u8>,
}

/// Files that are held at a time: a program and what it calls.
const MOST_WINDOWS: usize = 8;

impl BlockNumbers {
    /// Block number at the start of the block that `loc` lies in, as written (`14`, `N40`).
    pub fn of(&mut self, sources: &Sources, loc: Loc) -> Option<&str> {
        self.bytes_of(sources, loc).map(|number| std::str::from_utf8(number).unwrap_or_default())
    }

    /// The same as letters and digits of ASCII.
    #[inline]
    pub fn bytes_of(&mut self, sources: &Sources, loc: Loc) -> Option<&[u8]> {
        if self.last != Some((loc.file, loc.line)) {
            self.last = Some((loc.file, loc.line));
            self.read(sources, loc);
        }
        self.has_number.then_some(&self.number)
    }

    fn read(&mut self, sources: &Sources, loc: Loc) {
        let at = loc.span.start as usize;
        let window = self.window(sources, loc.file, at);
        let known = window.number_at(at - window.start);
        self.number.clear();
        self.has_number = match known {
            Some(Some((from, to))) => {
                let window = self.windows.first().map_or(&[][..], |window| &window.text);
                self.number.extend_from_slice(&window[from..to]);
                true
            }
            Some(None) => false,
            None => match sources.block_number(loc) {
                Some(number) => {
                    self.number.extend_from_slice(number.as_bytes());
                    true
                }
                None => false,
            },
        };
    }

    /// A piece of the file with what lies around `at`; it is the first of the list then.
    fn window(&mut self, sources: &Sources, file: FileId, at: usize) -> &Window {
        let holds = |window: &Window| {
            let (start, end) = (window.start, window.start + window.text.len());
            // Enough in front and behind for a number, unless the file ends there.
            (start == 0 || start + BEFORE / 2 <= at) && (at + 64 <= end || window.text.len() < WINDOW) && at <= end
        };
        let place = match self.windows.iter().position(|window| window.file == file) {
            Some(place) => place,
            None if self.windows.len() < MOST_WINDOWS => {
                self.windows.push(Window { file, start: 0, text: Vec::new(), line_end: b'\n', joins: None });
                self.windows.len() - 1
            }
            None => {
                let place = self.windows.len() - 1;
                self.windows[place].file = file;
                self.windows[place].text.clear();
                place
            }
        };
        if place > 0 {
            self.windows[..=place].rotate_right(1);
        }
        let window = &mut self.windows[0];
        if window.text.is_empty() || !holds(window) {
            window.start = at.saturating_sub(BEFORE);
            window.line_end = sources.line_end(file);
            // The mark of languages whose lines never join.
            window.joins = sources.joins_at(file).filter(|mark| *mark != 0xff);
            window.text.resize(WINDOW, 0);
            let mut done = 0;
            while done < WINDOW {
                match sources.read_at(file, (window.start + done) as u64, &mut window.text[done..]) {
                    Ok(n) if n > 0 => done += n,
                    _ => break,
                }
            }
            window.text.truncate(done);
        }
        window
    }
}

impl Window {
    /// Where the number of the block at `at` stands in the text, or that it has none; `None` where that is not so easily said.
    fn number_at(&self, at: usize) -> Option<Option<(usize, usize)>> {
        let (text, line_end) = (&self.text[..], self.line_end);
        let is_whole = self.start == 0;
        let before = text.get(..at)?;
        let start = match before.last() {
            Some(last) if *last == line_end => at,
            _ => match memchr::memrchr(line_end, before) {
                Some(end) => end + 1,
                None if is_whole => 0,
                None => return None,
            },
        };
        if let Some(mark) = self.joins.filter(|_| start > 0) {
            // A line that may go on: where its block begins is for others to say.
            let end = start - 1;
            let line_before = match memchr::memrchr(line_end, &text[..end]) {
                Some(before) => &text[before + 1..end],
                None if is_whole => &text[..end],
                None => return None,
            };
            if memchr::memchr(mark, line_before).is_some() {
                return None;
            }
        }
        let mut from = start;
        loop {
            match text.get(from)? {
                b' ' | b'\t' | b'/' | b'\r' => from += 1,
                other if other.is_ascii_graphic() => break,
                other if *other == line_end => return Some(None),
                _ => return None,
            }
        }
        let digits = from + usize::from(matches!(text[from], b'N' | b'n'));
        let n = text[digits..].iter().take_while(|b| b.is_ascii_digit()).count();
        // A number at the end of the piece may go on behind it.
        let is_all = digits + n < text.len();
        is_all.then_some((n > 0).then_some((from, digits + n)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::{Memory, Opened, Span, SplitRules};

    #[test]
    fn gives_the_number_that_a_finding_gives() {
        let mut text = String::new();
        let mut starts = Vec::new();
        for n in 0..20_000 {
            starts.push((text.len() as u32, n + 1));
            text += &match n % 8 {
                0 => format!("N{n} G1 X1\n"),
                1 => format!("{n} L X+1\r\n"),
                2 => "G1 X2\n".to_owned(),
                3 => format!("/ {n} L X+5 ~\n"),
                4 => "  Y+5 ~\n".to_owned(),
                5 => format!(" n{n}Z5\n"),
                6 => "\u{a0}12 L\n".to_owned(),
                _ => "N\n".to_owned(),
            };
        }
        let sources = Sources::default();
        let text = Memory::new(text.into_bytes());
        sources.add(Opened { name: "a.H".into(), identity: "a".into(), text: Box::new(text) }).unwrap();
        sources.read_by(FileId(0), SplitRules { mark: b'~', continues: |line, _| line.ends_with(b"~") });
        let mut numbers = BlockNumbers::default();
        let step = |i: usize| if i.is_multiple_of(3) { i } else { starts.len() - 1 - i };
        for i in (0..starts.len()).chain((0..starts.len()).step_by(97).map(step)) {
            let (start, line) = starts[i];
            let loc = Loc { file: FileId(0), line, span: Span::at(start + 1, 1) };
            assert_eq!(numbers.of(&sources, loc).map(str::to_owned), sources.block_number(loc), "{line}");
        }
    }
}
