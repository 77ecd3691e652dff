//! All files of one run: their names, and their text when a diagnostic wants to show it.

use std::cell::RefCell;
use std::fmt;
use std::rc::Rc;

use super::decode;
use super::files::{Opened, ReadAt};
use super::lines::{self, SplitRules, Stretch};
use super::{Loc, Span};

/// Number of a file in [`Sources`]; the main program is 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct FileId(pub u16);

/// Most files one run may open.
pub const MAX_FILES: usize = 1000;

/// Most bytes of one called file. A jump reads its file whole.
pub const MAX_CALLED: u64 = 256 << 20;
/// Most bytes of all called files together.
pub const MAX_ALL_CALLED: u64 = 1 << 30;

/// Why a file is not taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TooMuch {
    /// More than [`MAX_FILES`].
    Files,
    /// A called file of so many bytes, over [`MAX_CALLED`].
    Bytes(u64),
    /// So many bytes with all files that were called before, over [`MAX_ALL_CALLED`].
    AllBytes(u64),
}

/// Bytes shown of one line; longer lines are cut around the place of interest.
const SHOWN: usize = 512;
/// Bytes searched backwards for the start of a line.
const BACK: u32 = 1 << 21;
/// Lines searched backwards for the start of a block.
const BACK_LINES: usize = 1000;

/// The files of one run.
#[derive(Default)]
pub struct Sources {
    files: RefCell<Vec<File>>,
}

struct File {
    name: String,
    identity: String,
    text: Box<dyn ReadAt>,
    /// How its lines join, once somebody has read it as a program.
    rules: Option<SplitRules>,
    line_end: Option<u8>,
    /// What is known of its lines.
    straight: Rc<[Stretch]>,
}

impl fmt::Debug for Sources {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.files.borrow().iter().map(|file| file.name.clone())).finish()
    }
}

/// One physical line of a file, for showing.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Line {
    /// 1-based number of the line.
    pub number: u32,
    /// Readable text, cut to a few hundred characters around the span.
    pub text: String,
    /// 1-based column of the span in the whole line, in characters.
    pub column: u32,
    /// Byte range of the span in `text`, clipped to this line.
    pub marked: (usize, usize),
    /// 1-based column just behind the span, in characters.
    pub end_column: u32,
    /// Line on which the span ends.
    pub end_line: u32,
}

impl Sources {
    /// Adds a file, or finds it again by its identity. Its size is looked at before a byte of it is read.
    ///
    /// # Errors
    /// There are too many files, or it is a called one that is too large.
    pub fn add(&self, opened: Opened) -> Result<FileId, TooMuch> {
        let mut files = self.files.borrow_mut();
        let known = files.iter().position(|file| file.identity == opened.identity);
        let id = u16::try_from(known.unwrap_or(files.len())).map_err(|_| TooMuch::Files)?;
        if known.is_some() {
            return Ok(FileId(id));
        }
        if files.len() >= MAX_FILES {
            return Err(TooMuch::Files);
        }
        // The first file is the main program, which is read through a window as long as it does not jump.
        if !files.is_empty() {
            let size = opened.text.len();
            let all = files.iter().skip(1).map(|file| file.text.len()).fold(size, u64::saturating_add);
            if size > MAX_CALLED {
                return Err(TooMuch::Bytes(size));
            }
            if all > MAX_ALL_CALLED {
                return Err(TooMuch::AllBytes(all));
            }
        }
        let Opened { name, identity, text } = opened;
        files.push(File { name, identity, text, rules: None, line_end: None, straight: Rc::default() });
        Ok(FileId(id))
    }

    pub fn len(&self) -> usize {
        self.files.borrow().len()
    }

    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Name of a file as people know it.
    pub fn name(&self, id: FileId) -> String {
        self.files.borrow().get(id.0 as usize).map(|file| file.name.clone()).unwrap_or_default()
    }

    /// What tells a file from every other one.
    pub fn identity(&self, id: FileId) -> String {
        self.files.borrow().get(id.0 as usize).map(|file| file.identity.clone()).unwrap_or_default()
    }

    /// Name of a file for a terminal: nothing in it moves the cursor or turns the text around.
    pub fn shown(&self, id: FileId) -> String {
        decode::harmless(&self.name(id)).into_owned()
    }

    /// Length of a file in bytes.
    pub fn size(&self, id: FileId) -> u64 {
        self.files.borrow().get(id.0 as usize).map_or(0, |file| file.text.len())
    }

    /// Reads from a file.
    ///
    /// # Errors
    /// What the operating system reports.
    pub fn read_at(&self, id: FileId, at: u64, buf: &mut [u8]) -> std::io::Result<usize> {
        match self.files.borrow_mut().get_mut(id.0 as usize) {
            Some(file) => file.text.read_at(at, buf),
            None => Ok(0),
        }
    }

    /// The bytes of a span, as far as they can be read.
    pub fn bytes(&self, file: FileId, span: Span) -> Vec<u8> {
        let mut buf = vec![0; (span.end.saturating_sub(span.start)) as usize];
        let mut done = 0;
        while done < buf.len() {
            match self.read_at(file, u64::from(span.start) + done as u64, &mut buf[done..]) {
                Ok(n) if n > 0 => done += n,
                _ => break,
            }
        }
        buf.truncate(done);
        buf
    }

    /// The lines of this file join by `rules`.
    pub fn read_by(&self, id: FileId, rules: SplitRules) {
        if let Some(file) = self.files.borrow_mut().get_mut(id.0 as usize) {
            file.rules = Some(rules);
        }
    }

    /// The byte that every line has whose block goes on, if some do.
    pub fn joins_at(&self, id: FileId) -> Option<u8> {
        self.files.borrow().get(id.0 as usize).and_then(|file| file.rules).map(|rules| rules.mark)
    }

    /// The straight lines of a file, as far as somebody has noted them.
    pub fn straight(&self, id: FileId) -> Rc<[Stretch]> {
        self.files.borrow().get(id.0 as usize).map(|file| Rc::clone(&file.straight)).unwrap_or_default()
    }

    /// Notes the straight lines of a file, in their order.
    pub fn note_straight(&self, id: FileId, stretches: Vec<Stretch>) {
        if let Some(file) = self.files.borrow_mut().get_mut(id.0 as usize) {
            file.straight = stretches.into();
        }
    }

    /// The byte that ends the lines of a file.
    pub fn line_end(&self, id: FileId) -> u8 {
        let known = self.files.borrow().get(id.0 as usize).and_then(|file| file.line_end);
        known.unwrap_or_else(|| {
            let head = self.bytes(id, Span { start: 0, end: lines::CHUNK as u32 });
            let line_end = lines::line_end(&head);
            if let Some(file) = self.files.borrow_mut().get_mut(id.0 as usize) {
                file.line_end = Some(line_end);
            }
            line_end
        })
    }

    /// The physical line on which `loc.span` starts.
    ///
    /// `loc.line` is the line of the block's start; a block of several lines is followed to the span.
    pub fn line(&self, loc: Loc) -> Line {
        let at = loc.span.start;
        let feed = self.line_end(loc.file);
        let line_start = self.line_start(loc.file, at);
        let size = u32::try_from(self.size(loc.file)).unwrap_or(u32::MAX);
        let want = loc.span.end.max(at).saturating_add(SHOWN as u32).min(size);
        let text = self.bytes(loc.file, Span { start: line_start, end: want });
        let mark = (at - line_start) as usize;
        let line_end = text[mark.min(text.len())..]
            .iter()
            .position(|b| *b == feed)
            .map_or(text.len(), |i| i + mark.min(text.len()));
        let whole = trim_end(&text[..line_end]);
        let end = ((loc.span.end.max(at) - line_start) as usize).min(text.len());
        let inner_breaks = text[mark.min(end)..end].iter().filter(|b| **b == feed).count() as u32;
        let last_line_start = text[..end].iter().rposition(|b| *b == feed).map_or(0, |i| i + 1);
        let clipped_end = end.min(whole.len()).max(mark.min(whole.len()));
        let (shown, shift) = cut(whole, mark.min(whole.len()));
        let head = decode::readable(&whole[shift..mark.min(whole.len()).max(shift)]).len();
        let marked_len = decode::readable(&whole[mark.min(whole.len())..clipped_end]).len();
        let readable = decode::readable(shown).into_owned();
        let limit = readable.len();
        Line {
            number: loc.line,
            column: decode::char_count(&whole[..mark.min(whole.len())]) as u32 + 1,
            end_column: decode::char_count(&text[last_line_start..end]) as u32 + 1,
            end_line: loc.line + inner_breaks,
            marked: (head.min(limit), (head + marked_len).min(limit)),
            text: readable,
        }
    }

    /// Start of the physical line that holds the byte `at`.
    fn line_start(&self, file: FileId, at: u32) -> u32 {
        let feed = self.line_end(file);
        let mut back = 256;
        loop {
            let from = at.saturating_sub(back);
            let before = self.bytes(file, Span { start: from, end: at });
            match before.iter().rposition(|b| *b == feed) {
                Some(i) => return from + i as u32 + 1,
                None if from == 0 || back >= BACK => return from,
                None => back *= 16,
            }
        }
    }

    /// Start of the block that the physical line at `line` belongs to.
    fn block_start(&self, file: FileId, line: u32) -> u32 {
        let rules = self.files.borrow().get(file.0 as usize).and_then(|file| file.rules);
        let Some(rules) = rules else { return line };
        // Back to a line behind one that cannot go on, then forward again: only that way it is known which
        // lines are continuations.
        let mut lines: Vec<(u32, Vec<u8>)> = Vec::new();
        let mut start = line;
        while start > 0 && lines.len() < BACK_LINES {
            let before = self.line_start(file, start - 1);
            let text = self.bytes(file, Span { start: before, end: start - 1 });
            if !text.contains(&rules.mark) {
                break;
            }
            lines.push((before, text));
            start = before;
        }
        let mut first = start;
        for (at, text) in lines.iter().rev() {
            if !(rules.continues)(text, first < *at) {
                first = at + text.len() as u32 + 1;
            }
        }
        first
    }

    /// Block number at the start of the block that `loc` lies in, as written (`14`, `N40`).
    pub fn block_number(&self, loc: Loc) -> Option<String> {
        let start = self.block_start(loc.file, self.line_start(loc.file, loc.span.start));
        let line = self.line(loc.with_span(Span::at(start, 0)));
        let text = line.text.trim_start_matches(|c: char| c.is_whitespace() || c == '/');
        let digits = text.strip_prefix(['N', 'n']).unwrap_or(text);
        let n = digits.bytes().take_while(u8::is_ascii_digit).count();
        (n > 0).then(|| text[..text.len() - digits.len() + n].to_owned())
    }
}

fn trim_end(line: &[u8]) -> &[u8] {
    let end = line.iter().rposition(|b| !matches!(b, b'\r' | b'\n' | b' ' | b'\t')).map_or(0, |i| i + 1);
    &line[..end]
}

/// A window of the line around `mark`, and how many bytes were cut in front of it.
fn cut(line: &[u8], mark: usize) -> (&[u8], usize) {
    if line.len() <= SHOWN {
        return (line, 0);
    }
    let from = mark.saturating_sub(SHOWN / 4);
    (&line[from..line.len().min(from + SHOWN)], from)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::Memory;

    #[test]
    fn lines_that_end_in_carriage_returns() {
        let sources = one("1 L X+1\r2 L Y+2 R5\r3 L Z+3\r");
        let loc = Loc { file: FileId(0), line: 2, span: Span { start: 16, end: 18 } };
        let line = sources.line(loc);
        assert_eq!((line.text.as_str(), line.column, line.end_column, line.end_line), ("2 L Y+2 R5", 9, 11, 2));
        assert_eq!(sources.block_number(loc).as_deref(), Some("2"));
    }

    #[test]
    fn a_continuation_line_belongs_to_the_block_it_continues() {
        let text = "1 L ~\n X+1\n2 L ~\n Y+2 ~\n Z+3\n L X+1 ; ~\n4 L\n";
        let sources = one(text);
        let continues = |line: &[u8], _: bool| line.ends_with(b"~") && !line.contains(&b';');
        let number = |word: &str| {
            let start = text.find(word).unwrap() as u32;
            sources.block_number(Loc { file: FileId(0), line: 1, span: Span::at(start, 1) })
        };
        // Nobody has read the file as a program: lines are blocks.
        assert_eq!(number("Y+2"), None);
        sources.read_by(FileId(0), SplitRules { mark: b'~', continues });
        for (word, block) in [("X+1\n", "1"), ("Y+2", "2"), ("Z+3", "2"), ("4 L", "4")] {
            assert_eq!(number(word).as_deref(), Some(block), "{word}");
        }
        assert_eq!(number("X+1 ;"), None);
    }

    /// A file that only has a size.
    struct Sparse(u64);

    impl ReadAt for Sparse {
        fn len(&self) -> u64 {
            self.0
        }

        fn read_at(&mut self, _: u64, _: &mut [u8]) -> std::io::Result<usize> {
            panic!("nothing of it is read");
        }
    }

    #[test]
    fn called_files_are_limited_by_size_one_by_one_and_together() {
        let sources = Sources::default();
        let add = |name: &str, size: u64| {
            sources.add(Opened { name: name.into(), identity: name.into(), text: Box::new(Sparse(size)) })
        };
        assert_eq!(add("main", 3 << 30), Ok(FileId(0)));
        assert_eq!(add("a", MAX_CALLED + 1), Err(TooMuch::Bytes(MAX_CALLED + 1)));
        for (n, name) in ["a", "b", "c", "d"].into_iter().enumerate() {
            assert_eq!(add(name, MAX_CALLED), Ok(FileId(n as u16 + 1)));
        }
        assert_eq!(add("e", 1), Err(TooMuch::AllBytes(MAX_ALL_CALLED + 1)));
        // What is there already is not counted again.
        assert_eq!((add("a", MAX_CALLED), add("main", 3 << 30)), (Ok(FileId(1)), Ok(FileId(0))));
    }

    fn one(text: &str) -> Sources {
        let sources = Sources::default();
        let text = Memory::new(text.as_bytes().to_vec());
        sources.add(Opened { name: "a.H".into(), identity: "a".into(), text: Box::new(text) }).unwrap();
        sources
    }

    #[test]
    fn columns_count_characters_and_lines_are_cut_at_their_end() {
        let sources = one("1 ; Ø\r\n2 L Xä5\r\n");
        let loc = Loc { file: FileId(0), line: 2, span: Span { start: 12, end: 15 } };
        let line = sources.line(loc);
        assert_eq!(line.text, "2 L Xä5");
        assert_eq!((line.column, line.end_column), (5, 7));
        assert_eq!(&line.text[line.marked.0..line.marked.1], "Xä");
        assert_eq!(sources.block_number(loc).as_deref(), Some("2"));
    }
}
