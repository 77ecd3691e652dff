//! Subprograms: `L"name"` with values, in the same file or in one of its own.
//!
//! Source: T 13.4 (docs/sources.md).

use rustc_hash::FxHashMap;

use crate::diag::codes;
use crate::lexer::turning::{Addr, VarKind, VarRef};
use crate::parser::symbols::Symbols;
use crate::parser::turning::ast::{Section, Stmt};
use crate::sema::Job;
use crate::sema::run::unexecuted::Blocks;
use crate::sema::run::{Level, Program, Wanted};
use crate::text::Place;
use crate::text::{FileId, Loc, Span, Within, decode::readable};

use super::flow::Nest;
use super::program_parts::{Family, ProgramPart};
use super::vars::Locals;
use super::words::{Words, letters};
use super::{Outcome, Reported, Run, Turning};

/// Deepest nesting of calls.
const DEEPEST: usize = 6;

/// What a program or subprogram that is running holds.
#[derive(Debug)]
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

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum LevelKind {
    Main,
    /// A section of the caller's file.
    Local {
        at: u32,
    },
    /// A file of its own.
    External,
}

impl Frame {
    pub fn main() -> Frame {
        Frame {
            kind: LevelKind::Main,
            locals: Locals::default(),
            nests: Vec::new(),
            number: 1,
            begun: false,
            part: ProgramPart::Start,
        }
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

impl Run<'_> {
    /// `L"name" V1 LA.. LB..`
    pub(super) fn call(&mut self, w: &Words, name: Span, text: &[u8]) -> Outcome {
        let result = self.call_named(w, name, text);
        if result.is_err() {
            // What the subprogram would have done is not known.
            self.lose_all();
        }
        result
    }

    fn call_named(&mut self, w: &Words, span: Span, text: &[u8]) -> Outcome {
        let name = readable(span.of(text)).trim().to_owned();
        let arguments = self.arguments(w)?;
        let external = self.sections.family() == Family::Basic || self.choice(w, b'V', 0, 1)? == 1;
        if let Some(num) = w.get(b'Q').filter(|num| num.value != 1.0) {
            return self.core.refuse(num.span, codes::T9007::whether_q_counts_passes_or_repeats_no());
        }
        if name.is_empty() {
            return self.core.refuse(self.core.block_span(), codes::P1004::name_of_subprogram_is_missing());
        }
        if external { self.call_file(&name, arguments) } else { self.call_section(&name, arguments) }
    }

    fn arguments(&mut self, w: &Words) -> Outcome<Locals> {
        const ADMITTED: &[&str] = &["LA", "LB", "LC", "LD", "LE", "LF", "LH"];
        let mut locals = Locals::default();
        let stray = w.present() & !letters("VQI");
        if stray != 0 || !w.g().is_empty() || !w.m().is_empty() || w.texts().len() > 1 {
            return self.core.refuse(self.core.block_span(), codes::P1003::block_of_call_holds_words_that_no());
        }
        let singles = [w.get(b'V'), w.get(b'Q'), w.get(b'I')].into_iter().flatten();
        let open = singles.chain(w.longs().iter().map(|(_, num)| *num)).find(|num| num.unknown || num.incremental);
        if let Some(num) = open {
            return self.core.refuse(num.span, codes::P1003::call_takes_plain_numbers());
        }
        let mut give = |addr: Addr, value: f64| {
            locals.insert(VarRef { kind: VarKind::Argument, number: addr.0 }, Some(value));
        };
        for (addr, num) in w.longs() {
            if !ADMITTED.iter().any(|name| Addr::of(name.as_bytes()) == Some(*addr)) {
                return self.core.refuse(num.span, codes::P1003::hands_no_value_over(&addr));
            }
            give(*addr, num.value);
        }
        if let (Some(num), Some(addr)) = (w.get(b'I'), Addr::of(b"I")) {
            give(addr, num.value);
        }
        Ok(locals)
    }

    fn call_section(&mut self, name: &str, locals: Locals) -> Outcome {
        let (job, here) = (self.core.job, self.core.here.origin.loc);
        let program = self.core.level().program;
        let Program { source, known } = self.core.program();
        let file = source.file;
        let names = known.get_or_insert_with(|| Names::scan(&job, file, here));
        let Some(place) = names.places.get(&name.to_ascii_uppercase()).copied() else {
            let mut known: Vec<&str> = names.places.keys().map(String::as_str).collect();
            known.sort_unstable();
            let upper = name.to_ascii_uppercase();
            let like = crate::machine::tree::did_you_mean(&upper, known).map(str::to_owned);
            let found = codes::T2011::there_is_no_section_subprogram(&name).at(here);
            return self.core.stop(match like {
                Some(like) => found.help(format!("did you mean `{like}`?")),
                None => found.help("write V1 for a subprogram in a file of its own"),
            });
        };
        self.call_at(LevelKind::Local { at: place.at }, program, place, locals, name)
    }

    fn call_file(&mut self, name: &str, locals: Locals) -> Outcome {
        let wanted = Wanted { name, extensions: &["ncs", "NCS", "nc"], within: Within::Anywhere };
        let program = self.core.open_called(&wanted).ok_or(Reported)?;
        let start = self.core.programs[program].source.cursor.start();
        self.call_at(LevelKind::External, program, start, locals, name)
    }

    fn call_at(&mut self, kind: LevelKind, program: usize, to: Place, locals: Locals, name: &str) -> Outcome {
        let runs = |level: &Level<Frame>| {
            let known = level.frame.kind;
            level.program == program && (known == kind || (kind == LevelKind::External && known == LevelKind::Main))
        };
        if self.core.levels.iter().any(runs) {
            return self.core.end_run(codes::P2012::calls_itself_2(&name));
        }
        let limit = self.core.job.settings.limits.call_depth.min(DEEPEST);
        if self.core.levels.len() > limit {
            return self.core.too_deep(codes::P4003::subprograms_are_nested_deeper(&limit));
        }
        let number = self.next_number();
        let part = std::mem::replace(&mut self.sections.part, ProgramPart::Machining);
        self.core.enter(program, to, Frame { kind, locals, nests: Vec::new(), number, begun: false, part })
    }

    /// A number that no level had before.
    fn next_number(&mut self) -> u32 {
        self.calls = self.calls.saturating_add(1);
        self.calls
    }

    /// RETURN.
    pub(super) fn return_from_subprogram(&mut self) -> Outcome {
        if let Some(nest) = self.core.level().frame.nests.last() {
            let loc = nest.loc;
            self.core.report(codes::T1009::this_is_not_closed_when_subprogram_ends().at(loc));
        }
        if let Some(frame) = self.core.leave()? {
            self.sections.part = frame.part;
        }
        Ok(())
    }
}
