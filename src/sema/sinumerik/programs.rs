//! The programs of a run: files, the programs in an archive, and their skeletons for jumps.
//!
//! Source: S 1.1, 5.3 and 5.4 (docs/sources.md).

use std::rc::Rc;

use rustc_hash::{FxHashMap, FxHashSet};

use crate::diag::{Diagnostic, Label, codes};
use crate::parser::problem::Problem;
use crate::parser::sinumerik::ast::Search;
use crate::parser::sinumerik::scan::{self, Word, scan, skipped_line};
use crate::parser::symbols::{Symbol, Symbols};
use crate::sema::Job;
use crate::sema::run::Program;
use crate::text::{FileId, Loc, Next, Place, Span};

use super::control_folders::path_line;
use super::macros::Sinumerik;

/// Deepest nesting of structures that any control allows.
const MOST_NESTED: usize = 16;

/// The programs of a file were listed.
#[derive(Debug, Default)]
pub(super) struct Listed(bool);

type File = Program<Sinumerik>;

/// Main program or subprogram, as far as the header says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum UnitKind {
    Main,
    Sub,
    /// Definitions and data.
    Other,
}

/// A program: a file, or a part of an archive.
#[derive(Debug)]
pub(super) struct Unit {
    pub file: usize,
    /// Upper case, without `_N_` and the suffix.
    pub name: String,
    pub kind: UnitKind,
    /// The folder of the control in which it lies, where that is known.
    pub folder: Option<String>,
    pub start: Place,
    /// Offset of the header of the next program; the end of the file is not looked for.
    pub end: u32,
    pub skeleton: Option<Rc<Skeleton>>,
}

/// A line that begins a program of an archive.
struct Head {
    place: Place,
    name: String,
    kind: UnitKind,
    folder: Option<String>,
}

/// All of them.
#[derive(Debug, Default)]
pub(super) struct Units {
    pub list: Vec<Unit>,
    /// Names of cycles, by the file whose program asked whether one of that name stands here, with the answer.
    pub asked: FxHashMap<usize, FxHashMap<String, bool>>,
    /// Programs by the file that calls them and the name that it calls them by.
    pub found: FxHashMap<(usize, String), usize>,
    /// The same of programs that are nowhere.
    pub missing: FxHashSet<(usize, String)>,
    /// The folder that CALLPATH adds to the search path.
    pub call_path: Option<String>,
    /// Folders of the control of which it was said what stands for them.
    pub copies: FxHashSet<&'static str>,
}

impl Units {
    /// The first program of a file.
    pub fn first_of(&mut self, job: &Job<'_>, files: &[File], file: usize) -> usize {
        if let Some(known) = self.list.iter().position(|unit| unit.file == file) {
            return known;
        }
        let source = &files[file].source;
        let header = first_line(source.cursor.head());
        let (name, kind) = match header_name(header) {
            Some(found) => found,
            None => stem(&job.sources.name(source.file)),
        };
        let start = source.cursor.start();
        self.list.push(Unit { file, name, kind, folder: None, start, end: u32::MAX, skeleton: None });
        self.list.len() - 1
    }

    /// Lists the programs of a file by their headers. Keeps the reading position.
    pub fn list_file(&mut self, job: &Job<'_>, files: &mut [File], file: usize) -> std::io::Result<()> {
        let Some(entry) = files.get_mut(file).filter(|entry| !entry.known.0) else { return Ok(()) };
        entry.known.0 = true;
        let cursor = &mut entry.source.cursor;
        cursor.load(job.sources)?;
        let back = cursor.place();
        cursor.seek(job.sources, cursor.start())?;
        let mut found: Vec<Head> = Vec::new();
        // The line behind a head may name its folder.
        let mut behind_head = false;
        loop {
            let place = cursor.place();
            match cursor.next(job.sources)? {
                Next::Block(block) => {
                    let head = header_name(block.text);
                    if let Some(last) = found.last_mut().filter(|_| behind_head) {
                        last.folder = path_line(block.text);
                    }
                    behind_head = head.is_some();
                    found.extend(head.map(|(name, kind)| Head { place, name, kind, folder: None }));
                }
                Next::TooLong { .. } => behind_head = false,
                Next::End => break,
            }
        }
        cursor.seek(job.sources, back)?;
        let Some(first) = self.list.iter().position(|unit| unit.file == file) else { return Ok(()) };
        // Comments in front of the first header are no program.
        let named = header_name(first_line(files[file].source.cursor.head())).is_some();
        for (i, Head { place, name, kind, folder }) in found.into_iter().enumerate() {
            if place == self.list[first].start {
                self.list[first].folder = folder;
                continue;
            }
            if i == 0 && !named && only_remarks(job, files[file].source.file, place) {
                let unit = &mut self.list[first];
                (unit.name, unit.kind, unit.folder, unit.start) = (name, kind, folder, place);
                continue;
            }
            let last = self.list.iter_mut().rev().find(|unit| unit.file == file);
            if let Some(last) = last {
                last.end = last.end.min(place.at);
            }
            self.list.push(Unit { file, name, kind, folder, start: place, end: u32::MAX, skeleton: None });
        }
        Ok(())
    }

    /// The main program: the first one of the main file that is no subprogram.
    pub fn main(&self) -> Option<usize> {
        let of_main = || self.list.iter().enumerate().filter(|(_, unit)| unit.file == 0);
        let main = of_main().find(|(_, unit)| unit.kind == UnitKind::Main).or_else(|| of_main().next());
        main.map(|(at, _)| at)
    }

    /// Programs of a file without a line that names their folder lie in this one.
    pub fn lie_in(&mut self, file: usize, folder: &str) {
        for unit in self.list.iter_mut().filter(|unit| unit.file == file && unit.folder.is_none()) {
            unit.folder = Some(folder.to_owned());
        }
    }

    /// Lists the programs behind the one that ran, without loading the file.
    pub fn list_rest(&mut self, job: &Job<'_>, files: &mut [File]) -> std::io::Result<()> {
        let Some(entry) = files.first_mut().filter(|entry| !entry.known.0) else { return Ok(()) };
        let mut found = Vec::new();
        let cursor = &mut entry.source.cursor;
        loop {
            let place = cursor.place();
            match cursor.next(job.sources)? {
                Next::Block(block) => {
                    if let Some((name, kind)) = header_name(block.text) {
                        let (folder, end) = (None, u32::MAX);
                        found.push(Unit { file: 0, name, kind, folder, start: place, end, skeleton: None });
                    }
                }
                Next::TooLong { .. } => {}
                Next::End => break,
            }
        }
        self.list.extend(found);
        Ok(())
    }

    /// Programs of this name in a file.
    pub fn of_file<'u>(&'u self, file: usize, name: &'u str) -> impl Iterator<Item = usize> + 'u {
        let of_file = self.list.iter().enumerate();
        let fits = move |unit: &Unit| unit.file == file && unit.kind != UnitKind::Other && unit.name == name;
        of_file.filter(move |(_, unit)| fits(unit)).map(|(at, _)| at)
    }

    /// Where the definitions `name` of the main file's archive lie: start and end.
    pub fn definitions(&self, name: &str) -> Option<(Place, u32)> {
        let unit = self.list.iter().find(|unit| unit.file == 0 && unit.kind == UnitKind::Other && unit.name == name)?;
        Some((unit.start, unit.end))
    }

    /// The skeleton of a program, made on demand.
    pub fn skeleton(
        &mut self,
        job: &Job<'_>,
        files: &mut [File],
        unit: usize,
        symbols: &mut Symbols,
    ) -> std::io::Result<Rc<Skeleton>> {
        if let Some(known) = &self.list[unit].skeleton {
            return Ok(Rc::clone(known));
        }
        let file = self.list[unit].file;
        self.list_file(job, files, file)?;
        let (start, end) = (self.list[unit].start, self.list[unit].end);
        let entry = &mut files[file].source;
        let back = entry.cursor.place();
        entry.cursor.seek(job.sources, start)?;
        let mut made = Skeleton::default();
        let mut open = Vec::new();
        loop {
            let place = entry.cursor.place();
            if place.at >= end {
                break;
            }
            let mark = match entry.cursor.next(job.sources)? {
                Next::Block(block) => {
                    let mark = scan(block.text, symbols);
                    if let Some(problem) = mark.structure.and_then(|word| skipped_line(block.text, word, symbols)) {
                        made.wrong.insert(place.at, (place.line, block.lines, problem));
                    }
                    mark
                }
                Next::TooLong { .. } => continue,
                Next::End => break,
            };
            let after = entry.cursor.place();
            let loc = Loc {
                file: entry.file,
                line: place.line,
                span: Span::at(place.at, after.at.saturating_sub(place.at + 1)),
            };
            made.names(job, &mark, Mark { place, after }, loc, symbols);
            if let Some(word) = mark.structure {
                made.structure(job, word, Mark { place, after }, loc, &mut open);
            }
        }
        not_closed(job, entry.file, open);
        entry.cursor.seek(job.sources, back)?;
        let made = Rc::new(made);
        self.list[unit].skeleton = Some(Rc::clone(&made));
        Ok(made)
    }
}

/// Is there nothing but comments in front of `place`?
fn only_remarks(job: &Job<'_>, file: FileId, place: Place) -> bool {
    let text = job.sources.bytes(file, Span { start: 0, end: place.at.min(1 << 16) });
    text.split(|b| matches!(b, b'\n' | b'\r')).all(|line| {
        let line = line.trim_ascii();
        let line = line.strip_prefix(b"\xef\xbb\xbf").unwrap_or(line);
        line.is_empty() || line.starts_with(b";")
    })
}

/// A block and where the one behind it starts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Mark {
    pub place: Place,
    pub after: Place,
}

/// A control structure.
#[derive(Debug, Clone, Copy)]
pub(super) struct Structure {
    pub open: Mark,
    /// ELSE.
    pub middle: Option<Mark>,
    pub close: Mark,
}

/// Where the labels, block numbers and structures of a program are.
#[derive(Debug, Default)]
pub(super) struct Skeleton {
    labels: FxHashMap<Symbol, Vec<Mark>>,
    numbers: FxHashMap<u32, Vec<Mark>>,
    structures: Vec<Structure>,
    /// Structure that a block belongs to, by the offset of the block.
    by_block: FxHashMap<u32, usize>,
    /// Lines of structures that cannot be read, with their line, its number of lines, and why.
    wrong: FxHashMap<u32, (u32, u32, Problem)>,
}

impl Skeleton {
    /// The label and the number of a block.
    fn names(&mut self, job: &Job<'_>, scanned: &scan::Mark, mark: Mark, loc: Loc, symbols: &Symbols) {
        if let Some(label) = scanned.label {
            let marks = self.labels.entry(label).or_default();
            if let Some(first) = marks.first()
                && !symbols.name(label).eq_ignore_ascii_case("ENDLABEL")
            {
                push_once(job, label_again(symbols.name(label), loc, first));
            }
            marks.push(mark);
        }
        if let Some(number) = scanned.number {
            self.numbers.entry(number).or_default().push(mark);
        }
    }

    fn structure(&mut self, job: &Job<'_>, word: Word, mark: Mark, loc: Loc, open: &mut Vec<(Word, Mark)>) {
        match word {
            Word::If | Word::While | Word::For | Word::Loop | Word::Repeat => {
                if open.len() == MOST_NESTED {
                    push_once(job, codes::S2004::structures_are_nested_more_than_deep(&MOST_NESTED).at(loc));
                }
                open.push((word, mark));
                return;
            }
            Word::Else => {
                if let Some((Word::If, opener)) = open.last().copied() {
                    // The ELSE stands in for its IF until ENDIF comes.
                    let at = self.structures.len();
                    self.structures.push(Structure { open: opener, middle: Some(mark), close: mark });
                    self.by_block.insert(opener.place.at, at);
                    self.by_block.insert(mark.place.at, at);
                    if let Some(last) = open.last_mut() {
                        last.0 = Word::Else;
                    }
                    return;
                }
            }
            _ => {
                if let Some((opener, from)) = open.last().copied()
                    && closes(opener, word)
                {
                    open.pop();
                    let at = match self.by_block.get(&from.place.at) {
                        Some(at) => *at,
                        None => {
                            self.structures.push(Structure { open: from, middle: None, close: mark });
                            self.by_block.insert(from.place.at, self.structures.len() - 1);
                            self.structures.len() - 1
                        }
                    };
                    self.structures[at].close = mark;
                    self.by_block.insert(mark.place.at, at);
                    return;
                }
            }
        }
        let found = codes::S2004::has_no_opening(&name(word)).at(loc);
        let found = match open.last() {
            Some((opener, from)) => {
                let opened =
                    Loc { line: from.place.line, span: Span::at(from.place.at, from.after.at - from.place.at), ..loc };
                found
                    .also(opened, Label::IsOpen(name(*opener).to_owned()))
                    .help(format!("close it by {} first", closing(*opener)))
            }
            None => found.help(format!("delete {} or write its opening", name(word))),
        };
        push_once(job, found);
    }

    /// What is wrong with the line of a structure.
    pub fn wrong_line(&self, at: u32) -> Option<&(u32, u32, Problem)> {
        if self.wrong.is_empty() { None } else { self.wrong.get(&at) }
    }

    pub fn structure_of(&self, at: u32) -> Option<Structure> {
        self.by_block.get(&at).map(|i| self.structures[*i])
    }

    pub fn label(&self, name: Symbol, from: u32, search: Search) -> Option<Mark> {
        nearest(self.labels.get(&name)?, from, search)
    }

    pub fn number(&self, number: u32, from: u32, search: Search) -> Option<Mark> {
        nearest(self.numbers.get(&number)?, from, search)
    }

    pub fn labels(&self) -> impl Iterator<Item = Symbol> + '_ {
        self.labels.keys().copied()
    }
}

/// Structures that are still open where the program ends.
fn not_closed(job: &Job<'_>, file: FileId, open: Vec<(Word, Mark)>) {
    for (word, mark) in open {
        let loc = Loc { file, line: mark.place.line, span: Span::at(mark.place.at, mark.after.at - mark.place.at) };
        let found = codes::S2004::is_not_closed(&(if word == Word::Else { "IF" } else { name(word) })).at(loc);
        push_once(job, found.help(format!("write {} at its end", closing(word))));
    }
}

/// The check of blocks that do not run looks at programs again.
fn push_once(job: &Job<'_>, found: Diagnostic) {
    if !job.diags.knows(&found) {
        job.diags.push(found);
    }
}

/// A label that stands a second time: a jump takes the nearest one in its direction.
fn label_again(name: &str, loc: Loc, first: &Mark) -> Diagnostic {
    let place = Span::at(first.place.at, first.after.at.saturating_sub(first.place.at + 1));
    codes::S8036::label_stands_twice_in_this_program(&name)
        .at(loc)
        .also(Loc { line: first.place.line, span: place, ..loc }, Label::FirstTime)
}

/// The nearest mark in the direction of the search; a block finds itself backwards.
fn nearest(marks: &[Mark], from: u32, search: Search) -> Option<Mark> {
    let split = marks.partition_point(|mark| mark.place.at <= from);
    let forward = marks.get(split).copied();
    let backward = split.checked_sub(1).and_then(|at| marks.get(at)).copied();
    match search {
        Search::Forward => forward,
        Search::Backward => backward,
        Search::Both | Search::BothQuiet => forward.or(backward),
    }
}

fn closes(opener: Word, word: Word) -> bool {
    matches!(
        (opener, word),
        (Word::If | Word::Else, Word::EndIf)
            | (Word::While, Word::EndWhile)
            | (Word::For, Word::EndFor)
            | (Word::Loop, Word::EndLoop)
            | (Word::Repeat, Word::Until)
    )
}

fn closing(opener: Word) -> &'static str {
    match opener {
        Word::While => "ENDWHILE",
        Word::For => "ENDFOR",
        Word::Loop => "ENDLOOP",
        Word::Repeat => "UNTIL",
        _ => "ENDIF",
    }
}

fn name(word: Word) -> &'static str {
    match word {
        Word::If => "IF",
        Word::Else => "ELSE",
        Word::EndIf => "ENDIF",
        Word::While => "WHILE",
        Word::EndWhile => "ENDWHILE",
        Word::For => "FOR",
        Word::EndFor => "ENDFOR",
        Word::Loop => "LOOP",
        Word::EndLoop => "ENDLOOP",
        Word::Repeat => "REPEAT",
        Word::Until => "UNTIL",
    }
}

fn first_line(head: &[u8]) -> &[u8] {
    let head = head.strip_prefix(b"\xef\xbb\xbf").unwrap_or(head);
    let end = head.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(head.len());
    &head[..end]
}

/// Name and kind of a program from `%_N_NAME_MPF`.
pub(super) fn header_name(line: &[u8]) -> Option<(String, UnitKind)> {
    let line = line.strip_prefix(b"%")?.trim_ascii();
    // A lone % closes a file.
    if line.is_empty() {
        return None;
    }
    let end = line.iter().position(|b| *b == b';' || b.is_ascii_whitespace()).unwrap_or(line.len());
    let name = String::from_utf8_lossy(&line[..end]).to_ascii_uppercase();
    let old = |stem: &str| {
        name.strip_prefix(stem).is_some_and(|rest| !rest.is_empty() && rest.bytes().all(|b| b.is_ascii_digit()))
    };
    if old("SPF") || old("MPF") {
        // DIN form: %SPF2 is called by L2.
        let kind = if old("SPF") { UnitKind::Sub } else { UnitKind::Main };
        return Some((if old("SPF") { format!("L{}", &name[3..]) } else { name }, kind));
    }
    Some(bare_name(&name))
}

/// `_N_PART_MPF` is PART, a main program.
pub(super) fn bare_name(name: &str) -> (String, UnitKind) {
    let Some(name) = name.strip_prefix("_N_") else { return plain_name(name) };
    for (suffix, kind) in [("_MPF", UnitKind::Main), ("_SPF", UnitKind::Sub), ("_CYC", UnitKind::Sub)] {
        if let Some(stem) = name.strip_suffix(suffix) {
            return (stem.to_owned(), kind);
        }
    }
    for suffix in ["_DEF", "_INI", "_TEA", "_TOA", "_UFR", "_RPA", "_ARC", "_COM"] {
        if let Some(stem) = name.strip_suffix(suffix) {
            return (stem.to_owned(), UnitKind::Other);
        }
    }
    (name.to_owned(), UnitKind::Main)
}

/// `X.SPF` as a program of an archive is named: X.
pub(super) fn without_extension(name: &str) -> &str {
    name.strip_suffix(".SPF").or_else(|| name.strip_suffix(".MPF")).unwrap_or(name)
}

/// A name as it is called; `NAME_MPF` and `NAME_SPF` are NAME.
fn plain_name(name: &str) -> (String, UnitKind) {
    for (suffix, kind) in [("_MPF", UnitKind::Main), ("_SPF", UnitKind::Sub)] {
        if let Some(stem) = name.strip_suffix(suffix) {
            return (stem.to_owned(), kind);
        }
    }
    (name.to_owned(), UnitKind::Main)
}

/// Name and kind of a program by its file.
fn stem(file: &str) -> (String, UnitKind) {
    let name = file.rsplit(['/', '\\']).next().unwrap_or(file);
    let (stem, extension) = name.rsplit_once('.').unwrap_or((name, ""));
    let (name, kind) = bare_name(&stem.to_ascii_uppercase());
    (name, if extension.eq_ignore_ascii_case("spf") { UnitKind::Sub } else { kind })
}
