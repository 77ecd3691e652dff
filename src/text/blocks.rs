//! Cuts a file into logical blocks while it is read, in constant memory.
//!
//! A logical block is one physical line, or several that the dialect's continuation rule joins
//! (Klartext `~`). Reading goes forward through a window; the first jump loads the whole file.

use std::io;

use memchr::memchr2;
use xxhash_rust::xxh3::Xxh3;

use super::Place;
use super::lines::{CHUNK, SplitRules, line_end};
pub use super::nul_bytes::Hole;
use super::nul_bytes::{Holes, is_empty};
use super::sources::{FileId, Sources};

/// Least room for reading.
const LEAST_ROOM: usize = 4096;
/// Longest logical block; a longer one is reported and left out.
pub const MAX_BLOCK: usize = 1 << 20;

/// One logical block, without its line end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BlockText<'s> {
    pub text: &'s [u8],
    /// Offset of the first byte in the file.
    pub at: u32,
    /// 1-based line of the first byte.
    pub line: u32,
    /// Physical lines of the block.
    pub lines: u32,
}

/// What stands next in the file.
#[derive(Debug, PartialEq, Eq)]
pub enum Next<'s> {
    Block(BlockText<'s>),
    /// A block longer than [`MAX_BLOCK`], skipped; its start.
    TooLong {
        at: u32,
        line: u32,
    },
    End,
}

/// A block of the window.
enum Cut {
    Block { start: usize, end: usize, lines: u32 },
    TooLong,
    End,
}

/// A reading position in one file.
pub struct Cursor {
    file: FileId,
    rules: SplitRules,
    window: Vec<u8>,
    /// Offset in the file of `window[0]`.
    base: u64,
    /// Next unread byte in `window`.
    pos: usize,
    /// Valid bytes in `window`.
    end: usize,
    at_end: bool,
    whole: bool,
    line_end: u8,
    line: u32,
    /// Offset of the first block: behind a byte order mark.
    first: u32,
    holes: Holes,
    hash: Xxh3,
}

impl std::fmt::Debug for Cursor {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Cursor").field("file", &self.file).field("line", &self.line).finish_non_exhaustive()
    }
}

/// A file that cannot be read as a part program.
#[derive(Debug)]
pub enum OpenError {
    Io(io::Error),
    /// Two bytes a character: not a file of a control.
    Utf16,
    /// Over 4 GiB.
    TooLarge,
    /// Nothing but blanks.
    Empty,
}

/// Bytes looked through eight at a time: most lines of a part program end within them.
const SHORT_LINE: usize = 64;

/// Where the first `a` or `b` stands.
#[inline]
fn first_of(a: u8, b: u8, text: &[u8]) -> Option<usize> {
    const ONES: u64 = 0x0101_0101_0101_0101;
    // Sets the high bit of each byte that is zero, and perhaps of bytes above the lowest one of them.
    let zeros = |v: u64| v.wrapping_sub(ONES) & !v & (ONES << 7);
    let (a8, b8) = (ONES * u64::from(a), ONES * u64::from(b));
    let mut rest = text;
    while let Some((bytes, after)) = rest.split_first_chunk::<8>() {
        let bytes = u64::from_le_bytes(*bytes);
        let found = zeros(bytes ^ a8) | zeros(bytes ^ b8);
        let at = text.len() - rest.len();
        if found != 0 {
            return Some(at + found.trailing_zeros() as usize / 8);
        }
        rest = after;
        if at >= SHORT_LINE {
            break;
        }
    }
    memchr2(a, b, rest).map(|at| text.len() - rest.len() + at)
}

/// Two bytes a character without a byte order mark: one of each pair is zero in most of them.
fn is_utf16(head: &[u8]) -> bool {
    let zeros = |from: usize| head.iter().skip(from).step_by(2).filter(|b| **b == 0).count();
    let (even, odd) = (zeros(0), zeros(1));
    head.len() >= 4 && even.max(odd) * 3 > head.len() && even.min(odd) == 0
}

impl Cursor {
    /// Opens `file` at its first block.
    ///
    /// # Errors
    /// [`OpenError`]
    pub fn open(sources: &Sources, file: FileId, rules: SplitRules) -> Result<Cursor, OpenError> {
        if sources.size(file) >= u64::from(u32::MAX) {
            return Err(OpenError::TooLarge);
        }
        let mut cursor = Cursor {
            file,
            rules,
            window: Vec::new(),
            base: 0,
            pos: 0,
            end: 0,
            at_end: false,
            whole: false,
            line_end: b'\n',
            line: 1,
            first: 0,
            holes: Holes::NONE,
            hash: Xxh3::new(),
        };
        cursor.fill(sources).map_err(OpenError::Io)?;
        let head = &cursor.window[..cursor.end];
        if head.starts_with(&[0xff, 0xfe]) || head.starts_with(&[0xfe, 0xff]) || is_utf16(&head[..head.len().min(4096)])
        {
            return Err(OpenError::Utf16);
        }
        if head.starts_with(&[0xef, 0xbb, 0xbf]) {
            cursor.pos = 3;
            cursor.first = 3;
        }
        if head[cursor.pos..].iter().all(|b| is_empty(*b)) && head.len() as u64 == sources.size(file) {
            return Err(OpenError::Empty);
        }
        cursor.line_end = line_end(head);
        sources.read_by(file, rules);
        Ok(cursor)
    }

    /// First bytes of the file, for guessing its dialect.
    pub fn head(&self) -> &[u8] {
        &self.window[..self.end.min(4096)]
    }

    /// Place of the block that [`Cursor::next`] returns next.
    pub fn place(&self) -> Place {
        Place { at: (self.base + self.pos as u64) as u32, line: self.line }
    }

    /// Place of the first block.
    pub fn start(&self) -> Place {
        Place { at: self.first, line: 1 }
    }

    /// Is the whole file in memory?
    pub fn is_whole(&self) -> bool {
        self.whole
    }

    /// The text from the next block on, as far as it was read forward, and the byte that ends its lines. Nothing in a file
    /// that jumps, and while a hole waits to be reported.
    #[inline(always)]
    pub fn ahead(&self) -> (&[u8], u8) {
        let none = self.whole || self.is_past_hole();
        (if none { &[] } else { self.window.get(self.pos..self.end).unwrap_or_default() }, self.line_end)
    }

    /// Goes behind the first `len` bytes of [`Cursor::ahead`], which are one line.
    #[inline(always)]
    pub fn pass_line(&mut self, len: usize) {
        self.pos += len;
        self.line += 1;
    }

    /// Goes on to the start of a later block.
    pub fn pass_to(&mut self, place: Place) {
        let at = u64::from(place.at);
        match at.checked_sub(self.base).filter(|pos| *pos <= self.end as u64) {
            Some(pos) => self.pos = pos as usize,
            None => (self.base, self.pos, self.end, self.at_end) = (at, 0, 0, false),
        }
        self.line = place.line;
    }

    #[inline(always)]
    fn is_past_hole(&self) -> bool {
        let [inside, between] = self.holes.found;
        inside.min(between) < self.base + self.pos as u64
    }

    /// The first hole of each kind that was read over; said once. `block` was read last.
    #[inline]
    pub fn passed_hole(&mut self, block: Place) -> Option<Hole> {
        if self.is_past_hole() { self.hole(block) } else { None }
    }

    #[cold]
    fn hole(&mut self, block: Place) -> Option<Hole> {
        let at = self.holes.found.into_iter().min()?;
        let kind = usize::from(self.holes.found[0] != at);
        // Beyond every place of a file, and found already.
        self.holes.found[kind] = u64::MAX - 1;
        if std::mem::replace(&mut self.holes.said[kind], true) {
            return None;
        }
        let window = at.checked_sub(self.base).and_then(|from| self.window.get(from as usize..self.pos));
        // What was read of it is gone where the hole is larger than what is read at a time.
        let place = window.map_or(block, |since| {
            // The last line may lack its end, and is counted all the same.
            let unended = since.last() != Some(&self.line_end);
            let lines = since.iter().filter(|b| **b == self.line_end).count() as u32 + u32::from(unended);
            Place { at: at as u32, line: self.line.saturating_sub(lines).max(1) }
        });
        Some(Hole { place, inside: kind == 0 })
    }

    /// Reads the next logical block.
    ///
    /// # Errors
    /// What the operating system reports.
    #[inline]
    pub fn next(&mut self, sources: &Sources) -> io::Result<Next<'_>> {
        let place = self.place();
        Ok(match self.cut(sources)? {
            Cut::Block { start, end, lines } => Next::Block(self.block(place, start, end, lines)),
            Cut::TooLong => Next::TooLong { at: place.at, line: place.line },
            Cut::End => Next::End,
        })
    }

    /// Reads up to the next logical block that is not too long and whose text is `wanted`; none at the end of the file.
    /// Text that is wanted holds `letter`, in whatever case, and does not lie between a block and where one may `pass` from
    /// there.
    ///
    /// # Errors
    /// What the operating system reports.
    pub fn next_readable(
        &mut self,
        sources: &Sources,
        letter: Option<u8>,
        wanted: impl Fn(&[u8]) -> bool,
        pass: impl Fn(u32) -> Option<Place>,
    ) -> io::Result<Option<BlockText<'_>>> {
        loop {
            if let Some(place) = pass(self.place().at) {
                self.pass_to(place);
            }
            if let Some(letter) = letter {
                self.pass_lines_without(letter);
            }
            let place = self.place();
            match self.cut(sources)? {
                Cut::Block { start, end, lines } if wanted(self.block(place, start, end, lines).text) => {
                    return Ok(Some(self.block(place, start, end, lines)));
                }
                Cut::Block { .. } | Cut::TooLong => {}
                Cut::End => return Ok(None),
            }
        }
    }

    /// Goes over the lines in front of the next one that holds `letter`, as far as they are in the window and none of them
    /// is continued.
    fn pass_lines_without(&mut self, letter: u8) {
        let rest = &self.window[self.pos..self.end];
        let (upper, lower) = (letter.to_ascii_uppercase(), letter.to_ascii_lowercase());
        let reach = memchr::memchr3(upper, lower, self.rules.mark, rest).unwrap_or(rest.len());
        let Some(last) = memchr::memrchr(self.line_end, &rest[..reach]) else { return };
        self.line += memchr::memchr_iter(self.line_end, &rest[..=last]).count() as u32;
        self.pos += last + 1;
    }

    #[inline]
    fn block(&self, place: Place, start: usize, end: usize, lines: u32) -> BlockText<'_> {
        let text = &self.window[start..end];
        BlockText { text: text.strip_suffix(b"\r").unwrap_or(text), at: place.at, line: place.line, lines }
    }

    /// Finds the end of the next block and goes on behind it.
    #[inline]
    fn cut(&mut self, sources: &Sources) -> io::Result<Cut> {
        let mut scan = self.pos;
        let mut line_start = self.pos;
        let mut lines = 1;
        let mut marked = false;
        let mut too_long = false;
        let end = loop {
            match first_of(self.line_end, self.rules.mark, &self.window[scan..self.end]) {
                Some(i) if self.rules.mark != self.line_end && self.window[scan + i] == self.rules.mark => {
                    marked = true;
                    scan += i + 1;
                }
                Some(i) => {
                    let end = scan + i;
                    if marked && (self.rules.continues)(&self.window[line_start..end], lines > 1) {
                        marked = false;
                        lines += 1;
                        line_start = end + 1;
                        scan = end + 1;
                    } else {
                        break end;
                    }
                }
                None if self.at_end => break self.end,
                None => {
                    if self.end - self.pos > MAX_BLOCK {
                        // What was read of it is of no use any more.
                        too_long = true;
                        self.base += (self.end - self.pos) as u64;
                        self.end = self.pos;
                    }
                    let (was, kept) = (self.pos, self.end - self.pos);
                    self.fill(sources)?;
                    line_start = line_start.min(was + kept) - was + self.pos;
                    scan = self.pos + kept;
                }
            }
        };
        if self.pos >= self.end && self.at_end && end == self.pos {
            return Ok(Cut::End);
        }
        let start = self.pos;
        self.pos = (end + 1).min(self.end);
        self.line += lines;
        if too_long || end - start > MAX_BLOCK {
            return Ok(Cut::TooLong);
        }
        Ok(Cut::Block { start, end, lines })
    }

    /// Goes to `place`, which must be the start of a block; loads the whole file the first time.
    ///
    /// # Errors
    /// What the operating system reports.
    pub fn seek(&mut self, sources: &Sources, place: Place) -> io::Result<()> {
        self.load(sources)?;
        self.pos = (place.at as usize).min(self.end);
        self.line = place.line;
        Ok(())
    }

    /// Goes to `place` in a file that is in memory as a whole.
    pub fn resume(&mut self, place: Place) {
        debug_assert!(self.whole, "only a whole file has places to go to");
        self.pos = (place.at as usize).min(self.end);
        self.line = place.line;
    }

    /// Loads the whole file, keeping the place.
    ///
    /// # Errors
    /// What the operating system reports.
    pub fn load(&mut self, sources: &Sources) -> io::Result<()> {
        if self.whole {
            return Ok(());
        }
        let here = self.place();
        let size = sources.size(self.file) as usize;
        let mut text = vec![0; size];
        let mut done = 0;
        while done < size {
            let n = sources.read_at(self.file, done as u64, &mut text[done..])?;
            if n == 0 {
                break;
            }
            done += n;
        }
        text.truncate(done);
        self.hash = Xxh3::new();
        self.hash.update(&text);
        self.holes.begin_again();
        self.holes.look(&text, 0);
        self.end = text.len();
        self.window = text;
        self.base = 0;
        self.pos = (here.at as usize).min(self.end);
        self.at_end = true;
        self.whole = true;
        Ok(())
    }

    /// Hash of the whole file; reads what was not read yet.
    ///
    /// # Errors
    /// What the operating system reports.
    pub fn content_hash(&mut self, sources: &Sources) -> io::Result<u64> {
        while !self.at_end {
            self.pos = self.end;
            self.fill(sources)?;
        }
        Ok(self.hash.digest())
    }

    /// Drops what was read and reads on.
    fn fill(&mut self, sources: &Sources) -> io::Result<()> {
        self.window.copy_within(self.pos..self.end, 0);
        self.base += self.pos as u64;
        self.end -= self.pos;
        self.pos = 0;
        let at = self.base + self.end as u64;
        // A small file takes no room for a large one. A byte more tells where it ends.
        let left = sources.size(self.file).saturating_sub(at).saturating_add(1);
        let room = usize::try_from(left).map_or(CHUNK, |left| left.clamp(LEAST_ROOM, CHUNK));
        if self.window.len() < self.end + room {
            self.window.resize(self.end + room, 0);
        }
        let n = sources.read_at(self.file, at, &mut self.window[self.end..])?;
        self.hash.update(&self.window[self.end..self.end + n]);
        self.holes.look(&self.window[self.end..self.end + n], at);
        self.end += n;
        self.at_end = n == 0;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    proptest::proptest! {
        #[test]
        fn the_first_mark_is_found(text in "[a-c\u{80}\u{0}]{0,200}", at in 0usize..250, mark in "[~\n]") {
            let mut text = text.into_bytes();
            let mark = mark.as_bytes()[0];
            if at < text.len() {
                text[at] = mark;
            }
            proptest::prop_assert_eq!(first_of(b'\n', b'~', &text), memchr2(b'\n', b'~', &text));
            proptest::prop_assert_eq!(first_of(mark, mark, &text), memchr::memchr(mark, &text));
        }
    }
    use crate::text::{Memory, Opened};

    const RULES: SplitRules = SplitRules { mark: b'~', continues: |line, _| line.trim_ascii_end().ends_with(b"~") };

    fn blocks(bytes: &[u8]) -> Vec<(String, u32, u32)> {
        let sources = Sources::default();
        let text = Box::new(Memory::new(bytes.to_vec()));
        let file = sources.add(Opened { name: "a".into(), identity: "a".into(), text }).unwrap();
        let mut cursor = Cursor::open(&sources, file, RULES).unwrap();
        let mut out = Vec::new();
        loop {
            match cursor.next(&sources).unwrap() {
                Next::Block(b) => out.push((String::from_utf8_lossy(b.text).into_owned(), b.at, b.line)),
                Next::TooLong { at, line } => out.push(("too long".into(), at, line)),
                Next::End => return out,
            }
        }
    }

    #[test]
    fn line_ends_and_continuations() {
        assert_eq!(
            blocks(b"\xef\xbb\xbfA\r\nB ~\n C\nD"),
            [("A".into(), 3, 1), ("B ~\n C".into(), 6, 2), ("D".into(), 13, 4)]
        );
        assert_eq!(blocks(b"A\rB\r"), [("A".into(), 0, 1), ("B".into(), 2, 2)]);
        assert_eq!(blocks(b";a\rb\nC\n"), [(";a\rb".into(), 0, 1), ("C".into(), 5, 2)]);
        assert_eq!(blocks(b"A ~"), [("A ~".into(), 0, 1)]);
    }

    #[test]
    fn a_giant_line_is_skipped_and_the_next_block_is_found() {
        let mut bytes = b"A\n".to_vec();
        bytes.extend(std::iter::repeat_n(b'X', 3 * MAX_BLOCK));
        bytes.extend(b"\nB\n");
        let found = blocks(&bytes);
        assert_eq!(found[0], ("A".into(), 0, 1));
        assert_eq!((found[1].0.as_str(), found[1].1, found[1].2), ("too long", 2, 2));
        assert_eq!(found[2], ("B".into(), 3 * MAX_BLOCK as u32 + 3, 3));
    }

    #[test]
    fn holes_are_told_from_padding() {
        let hole = |bytes: &[u8]| {
            let sources = Sources::default();
            let text = Box::new(Memory::new(bytes.to_vec()));
            let file = sources.add(Opened { name: "a".into(), identity: "a".into(), text }).unwrap();
            let mut cursor = Cursor::open(&sources, file, RULES).unwrap();
            let mut found = Vec::new();
            loop {
                let place = cursor.place();
                let end = matches!(cursor.next(&sources).unwrap(), Next::End);
                found.extend(cursor.passed_hole(place).map(|hole| (hole.place.at, hole.place.line, hole.inside)));
                if end {
                    return found;
                }
            }
        };
        for whole in ["A\nB\n", "\0\0A\nB", "A\nB\0\0", "A\nB\n\x1a", "A\n\x1a\r\n\0 \n", "A\n\0\0%B\nC\n\x1a"] {
            assert_eq!(hole(whole.as_bytes()), [], "{whole:?}");
        }
        assert_eq!(hole(b"A\nB\0C\nD\0E"), [(3, 2, true)]);
        assert_eq!(hole(b"A\n\x1a\nC"), [(2, 2, false)]);
        assert_eq!(hole(b"A\0\nC"), [(1, 1, false)]);
        assert_eq!(hole(b"A\n\0C\nD \0E"), [(2, 2, false), (7, 3, true)]);
        // The padding is longer than what is read at a time.
        let wide = |tail: &str| [b"A\n".to_vec(), vec![0; CHUNK + 10], tail.as_bytes().to_vec()].concat();
        assert_eq!(hole(&wide("\n")), []);
        assert_eq!(hole(&wide("\nB\n")).len(), 1);
    }

    #[test]
    fn long_files_are_cut_at_the_same_places_as_short_ones() {
        let line = b"12 L X+1.000 Y+2.000 ~\n Z+3\n";
        let n = 3 * CHUNK / line.len();
        let found = blocks(&line.repeat(n));
        assert_eq!(found.len(), n);
        for (i, block) in found.iter().enumerate() {
            assert_eq!(block, &("12 L X+1.000 Y+2.000 ~\n Z+3".to_owned(), (i * line.len()) as u32, 2 * i as u32 + 1));
        }
    }
}
