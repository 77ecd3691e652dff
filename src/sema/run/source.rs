//! A program file that is read block by block, and the blocks that were read before.

use std::rc::Rc;

use rustc_hash::FxHashMap;

use crate::diag::{CallPath, codes};
use crate::sema::Job;
use crate::text::{Cursor, FileId, Loc, Next, Place, Span, SplitRules};

use super::files::{open_cursor, report_hole};
use super::site::Site;

/// Most blocks kept parsed.
const CACHED: usize = 1 << 16;

/// Parsed blocks of programs that jump, by place.
#[derive(Debug)]
pub struct Cache<B> {
    blocks: FxHashMap<u32, Rc<B>>,
}

impl<B> Default for Cache<B> {
    fn default() -> Cache<B> {
        Cache { blocks: FxHashMap::default() }
    }
}

impl<B> Cache<B> {
    pub fn get(&self, at: u32) -> Option<Rc<B>> {
        self.blocks.get(&at).cloned()
    }

    /// Keeps a block; starts anew when there are too many.
    pub fn insert(&mut self, at: u32, block: Rc<B>) {
        if self.blocks.len() >= CACHED {
            self.blocks.clear();
        }
        self.blocks.insert(at, block);
    }
}

/// A block with what its execution needs besides.
#[derive(Debug, Clone, Default)]
pub struct Parsed<B> {
    pub block: B,
    /// The text of the block, where the block needs it.
    pub text: Vec<u8>,
    pub lines: u32,
    /// The text was written anew before it was parsed: spans do not fit the file.
    pub rewritten: bool,
    next: Place,
}

/// A file that runs: the reading position, and the blocks that were read before.
#[derive(Debug)]
pub struct Source<B> {
    pub file: FileId,
    pub cursor: Cursor,
    cache: Cache<Parsed<B>>,
    /// Up to here the file was read at least once.
    furthest: u32,
    /// The last block had been read before, and was parsed again.
    pub parsed_again: bool,
}

/// What [`Source::read`] found.
#[derive(Debug)]
pub enum Read {
    Block(Site),
    /// A block over 1 MiB, which was reported and passed over.
    TooLong,
    End,
    /// The file cannot be read on, which was reported.
    Broken,
}

impl<B: Clone> Source<B> {
    /// Opens a file; reports what is wrong with it.
    pub fn open(job: &Job<'_>, file: FileId, rules: SplitRules, from: Loc) -> Option<Source<B>> {
        open_cursor(job, file, rules, from).map(|cursor| Source {
            file,
            cursor,
            cache: Cache::default(),
            furthest: 0,
            parsed_again: false,
        })
    }

    /// Forgets the blocks that were read before: they would be parsed in another way now.
    pub fn forget_blocks(&mut self) {
        self.cache = Cache::default();
    }

    /// Bytes from `site` to the reading position, and whether that block was parsed once more.
    #[inline]
    pub fn cost(&self, site: &Site) -> (u32, bool) {
        (self.cursor.place().at.saturating_sub(site.at), self.parsed_again)
    }

    /// Goes behind the next block, a line of `len` bytes that was read where it stands.
    #[inline(always)]
    pub fn pass_line(&mut self, len: usize, call: CallPath) -> Site {
        let place = self.cursor.place();
        self.parsed_again = false;
        self.furthest = self.furthest.max(place.at.saturating_add(1));
        self.cursor.pass_line(len);
        Site::new(self.file, place.at, place.line, 1, call)
    }

    /// The next block, if it was read before.
    #[inline]
    pub fn again(&mut self, call: CallPath) -> Option<(Rc<Parsed<B>>, Site)> {
        if !self.cursor.is_whole() {
            return None;
        }
        let place = self.cursor.place();
        let parsed = self.cache.get(place.at)?;
        self.cursor.resume(parsed.next);
        self.parsed_again = false;
        let mut site = Site::new(self.file, place.at, place.line, parsed.lines, call);
        site.rewritten = parsed.rewritten;
        Some((parsed, site))
    }

    /// Reads the next block and keeps it for [`Source::again`]; `parse` fills the block and its text.
    #[inline]
    pub fn read(
        &mut self,
        job: &Job<'_>,
        call: CallPath,
        into: &mut Parsed<B>,
        parse: impl FnOnce(&[u8], &mut Parsed<B>),
    ) -> Read {
        let at = self.cursor.place().at;
        let read = self.pass(job, call, into, parse);
        if self.cursor.is_whole() && matches!(read, Read::Block(_)) {
            into.next = self.cursor.place();
            self.cache.insert(at, Rc::new(Parsed::clone(into)));
        }
        read
    }

    /// Reads the next block, which is not executed now.
    #[inline]
    pub fn pass(
        &mut self,
        job: &Job<'_>,
        call: CallPath,
        into: &mut Parsed<B>,
        parse: impl FnOnce(&[u8], &mut Parsed<B>),
    ) -> Read {
        into.text.clear();
        into.rewritten = false;
        let place = self.cursor.place();
        self.parsed_again = place.at < self.furthest;
        self.furthest = self.furthest.max(place.at.saturating_add(1));
        let read = match self.cursor.next(job.sources) {
            Ok(Next::Block(found)) => {
                parse(found.text, into);
                into.lines = found.lines;
                let mut site = Site::new(self.file, place.at, place.line, into.lines, call);
                site.rewritten = into.rewritten;
                Read::Block(site)
            }
            Ok(Next::TooLong { at, line }) => {
                let loc = Loc { file: self.file, line, span: Span::at(at, 1) };
                job.diags.push(codes::P0003::block_is_longer_than_1_mib().at(loc).called(call));
                Read::TooLong
            }
            Ok(Next::End) => Read::End,
            Err(error) => {
                let loc = Loc { file: self.file, line: place.line, span: Span::at(place.at, 0) };
                let found = codes::P0105::file_cannot_be_read(&error).at(loc);
                job.diags.push(found.called(call));
                Read::Broken
            }
        };
        report_hole(job, self.file, &mut self.cursor, place, call);
        read
    }
}
