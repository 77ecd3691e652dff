//! Subprograms: `L"name"` with values, in the same file or in one of its own.
//!
//! Source: T 13.4 (docs/sources.md).

use rustc_hash::FxHashMap;

use crate::diag::codes;
use crate::lexer::turning::{Addr, VarKind, VarRef};
use crate::parser::symbols::Symbols;
use crate::parser::turning::ast::{Section, Stmt};
use crate::sema::Job;
use crate::sema::run::refusal::{Made, refused};
use crate::sema::run::unexecuted::Blocks;
use crate::sema::run::{Program, Wanted, Where, like};
use crate::text::Place;
use crate::text::{FileId, Loc, Within, decode::readable};

use super::flow::Nest;
use super::program_parts::{Family, ProgramPart};
use super::vars::Locals;
use super::words::{Words, letters};
use super::{Core, Outcome, Reported, Run, Turning};

/// Deepest nesting of calls.
const DEEPEST: usize = 6;

/// What a program or subprogram that is running holds.
#[derive(Debug, Default)]
pub(super) struct Frame {
    pub kind: LevelKind,
    pub locals: Locals,
    pub nests: Vec<Nest>,
    /// Tells levels apart: every call gets a new one.
    pub number: u32,
    /// A block of it ran.
    pub begun: bool,
    /// How the blocks of its caller are read.
    part: ProgramPart,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum LevelKind {
    #[default]
    Main,
    /// A section of the caller's file.
    Local { at: u32 },
    /// A file of its own.
    External,
}

impl Frame {
    pub fn main() -> Frame {
        Frame { number: 1, ..Frame::default() }
    }

    /// The innermost structure that is open.
    pub fn open(&self) -> Option<Loc> {
        self.nests.last().map(|nest| nest.loc)
    }
}

/// Where the local subprograms of a file begin, by their upper-case name.
#[derive(Debug, Default)]
pub(super) struct Names {
    places: FxHashMap<String, Place>,
}

impl Names {
    fn scan(job: &Job<'_>, file: FileId, from: Loc) -> Names {
        let mut names = Names::default();
        let Some(mut blocks) = Blocks::<Turning>::open(job, file, from) else { return names };
        let mut symbols = Symbols::default();
        while let Some(passed) = blocks.next_that(job, &mut symbols, None, may_be_section) {
            let Stmt::Section(Section::Subprogram, rest) = passed.block.stmt else { continue };
            let name = readable(rest.of(passed.text)).trim().trim_matches('"').to_ascii_uppercase();
            let section = passed.site.loc(job, passed.block.span);
            let place = blocks.texts.cursor.place();
            if names.places.insert(name.clone(), place).is_some() {
                job.diags.push(codes::T2011::subprogram_stands_twice_in_this_file(&name).at(section));
            }
        }
        names
    }
}

/// Could this block begin a section of a subprogram? Looks at its first letter only.
fn may_be_section(text: &[u8]) -> bool {
    let first = text.iter().find(|b| !b.is_ascii_whitespace());
    matches!(first, Some(b'S' | b's' | b'U' | b'u'))
}

/// What a block calls.
#[derive(Debug)]
pub(super) struct Called {
    name: String,
    /// A file of its own, not a section of this one.
    external: bool,
    arguments: Locals,
}

impl Words {
    /// `L"name" V1 LA.. LB..`
    pub(super) fn called(&self, name: &str, family: Family) -> Made<Called> {
        let arguments = self.arguments()?;
        let external = family == Family::Basic || self.choice(b'V', 0, 1)? == 1;
        if let Some(num) = self.get(b'Q').filter(|num| num.value != 1.0) {
            return refused(num.span, codes::T9007::whether_q_counts_passes_or_repeats_no());
        }
        let name = name.trim().to_owned();
        if name.is_empty() {
            return refused(Where::Block, codes::P1004::name_of_subprogram_is_missing());
        }
        Ok(Called { name, external, arguments })
    }

    fn arguments(&self) -> Made<Locals> {
        const ADMITTED: &[&str] = &["LA", "LB", "LC", "LD", "LE", "LF", "LH"];
        let mut locals = Locals::default();
        let stray = self.present() & !letters("VQI");
        if stray != 0 || !self.g().is_empty() || !self.m().is_empty() || self.texts().len() > 1 {
            return refused(Where::Block, codes::P1003::block_of_call_holds_words_that_no());
        }
        let singles = [self.get(b'V'), self.get(b'Q'), self.get(b'I')].into_iter().flatten();
        let open = singles.chain(self.longs().iter().map(|(_, num)| *num)).find(|num| num.unknown || num.incremental);
        if let Some(num) = open {
            return refused(num.span, codes::P1003::call_takes_plain_numbers());
        }
        let mut give = |addr: Addr, value: f64| {
            locals.insert(VarRef { kind: VarKind::Argument, number: addr.0 }, Some(value));
        };
        for (addr, num) in self.longs() {
            if !ADMITTED.iter().any(|name| Addr::of(name.as_bytes()) == Some(*addr)) {
                return refused(num.span, codes::P1003::hands_no_value_over(&addr));
            }
            give(*addr, num.value);
        }
        if let (Some(num), Some(addr)) = (self.get(b'I'), Addr::of(b"I")) {
            give(addr, num.value);
        }
        Ok(locals)
    }
}

impl Core<'_> {
    /// Where the called blocks begin, and in which program.
    fn find(&mut self, called: &Called) -> Outcome<(LevelKind, usize, Place)> {
        let name = called.name.as_str();
        if called.external {
            let wanted = Wanted { name, extensions: &["ncs", "NCS", "nc"], within: Within::Anywhere };
            let program = self.open_called(&wanted).ok_or(Reported)?;
            return Ok((LevelKind::External, program, self.programs[program].source.cursor.start()));
        }
        let (job, here) = (self.job, self.here.origin.loc);
        let running = self.level().program;
        let Program { source, known } = self.program();
        let file = source.file;
        let names = &known.get_or_insert_with(|| Names::scan(&job, file, here)).places;
        let upper = name.to_ascii_uppercase();
        if let Some(place) = names.get(&upper).copied() {
            return Ok((LevelKind::Local { at: place.at }, running, place));
        }
        let like = like(&upper, names.keys().map(String::as_str));
        let found = codes::T2011::there_is_no_section_subprogram(&name).at(here);
        self.stop(match like {
            Some(like) => found.help(format!("did you mean `{like}`?")),
            None => found.help("write V1 for a subprogram in a file of its own"),
        })
    }

    /// Do the same blocks run on any level?
    fn runs(&self, kind: LevelKind, program: usize) -> bool {
        self.levels.iter().any(|level| {
            let known = level.frame.kind;
            level.program == program && (known == kind || (kind == LevelKind::External && known == LevelKind::Main))
        })
    }
}

impl Run<'_> {
    pub(super) fn enter(&mut self, called: Called) -> Outcome {
        let (kind, program, to) = self.core.find(&called)?;
        if self.core.runs(kind, program) {
            return self.core.end_run(codes::P2012::calls_itself_2(&called.name));
        }
        let number = self.vars.next_level();
        let part = std::mem::replace(&mut self.sections.part, ProgramPart::Machining);
        let frame = Frame { kind, locals: called.arguments, number, part, ..Frame::default() };
        self.core.enter_within(DEEPEST, codes::P4003::subprograms_are_nested_deeper, (program, to), frame)
    }

    /// RETURN.
    pub(super) fn return_from_subprogram(&mut self) -> Outcome {
        if let Some(loc) = self.core.level().frame.open() {
            self.core.report(codes::T1009::this_is_not_closed_when_subprogram_ends().at(loc));
        }
        if let Some(frame) = self.core.leave()? {
            self.sections.part = frame.part;
        }
        Ok(())
    }
}
