//! Subprograms: `L"name"` with values, in the same file or in one of its own.
//!
//! Source: reference section 13.4.

use rustc_hash::FxHashMap;

use crate::diag::{CallPath, Diagnostic, codes};
use crate::lexer::turning::{Addr, VarKind, VarRef};
use crate::parser::turning::ast::{Block, Section, Stmt};
use crate::parser::turning::{SPLIT, parse_block};
use crate::text::blocks::Place;
use crate::text::{FileId, Loc, Next, Span, decode::readable};

use super::super::Job;
use super::super::exec::{open_cursor, open_program};
use super::flow::Nest;
use super::sections::{Family, Part};
use super::vars::Locals;
use super::words::{Words, letters};
use super::{Outcome, Reported, Run};

/// Deepest nesting of calls.
const DEEPEST: usize = 6;

/// A program or subprogram that is running.
#[derive(Debug)]
pub(super) struct Level {
    pub kind: LevelKind,
    pub program: usize,
    /// Where its caller goes on.
    back: Place,
    pub call: CallPath,
    pub locals: Locals,
    pub nests: Vec<Nest>,
    /// Tells levels apart: every call gets a new one.
    pub number: u32,
    /// A block of it ran.
    pub begun: bool,
    /// How the blocks of its caller are read.
    part: Part,
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

impl Level {
    pub fn main(program: usize) -> Level {
        Level {
            kind: LevelKind::Main,
            program,
            back: Place::default(),
            call: CallPath::MAIN,
            locals: Locals::default(),
            nests: Vec::new(),
            number: 1,
            begun: false,
            part: Part::Start,
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
        let Some(mut cursor) = open_cursor(job, file, SPLIT, from) else { return names };
        let (mut block, mut ignored) = (Block::default(), Vec::new());
        loop {
            let (name, section) = match cursor.next(job.sources) {
                Ok(Next::Block(found)) => {
                    let first = found.text.iter().find(|b| !b.is_ascii_whitespace());
                    if !matches!(first, Some(b'S' | b's' | b'U' | b'u')) {
                        continue;
                    }
                    parse_block(found.text, &mut block, &mut ignored);
                    ignored.clear();
                    let Stmt::Section(Section::Subprogram, rest) = block.stmt else { continue };
                    let name = readable(rest.of(found.text)).trim().trim_matches('"').to_ascii_uppercase();
                    (name, Loc { file, line: found.line, span: block.span.shifted(found.at) })
                }
                Ok(Next::TooLong { .. }) => continue,
                Ok(Next::End) | Err(_) => return names,
            };
            let place = cursor.place();
            if names.places.insert(name.clone(), place).is_some() {
                let message = format!("the subprogram `{name}` stands twice in this file");
                job.diags.push(Diagnostic::new(codes::T2011, section, message).help("give one of them another name"));
            }
        }
    }
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
            return self.fail_help(
                codes::T9007,
                num.span,
                "whether Q counts passes or repeats no manual at hand says",
                "write the L block as often as it shall run",
            );
        }
        if name.is_empty() {
            return self.fail(codes::T1005, self.block_span(), "the name of the subprogram is missing");
        }
        if external { self.call_file(&name, arguments) } else { self.call_section(&name, arguments) }
    }

    fn arguments(&mut self, w: &Words) -> Outcome<Locals> {
        const ADMITTED: &[&str] = &["LA", "LB", "LC", "LD", "LE", "LF", "LH"];
        let mut locals = Locals::default();
        let stray = w.present() & !letters("VQI");
        if stray != 0 || !w.g().is_empty() || !w.m().is_empty() || w.texts().len() > 1 {
            return self.fail_help(
                codes::T1003,
                self.block_span(),
                "the block of a call holds words that no manual at hand describes",
                "hand over values with LA to LF, LH and I, and put functions into blocks of their own",
            );
        }
        let singles = [w.get(b'V'), w.get(b'Q'), w.get(b'I')].into_iter().flatten();
        let open = singles.chain(w.longs().iter().map(|(_, num)| *num)).find(|num| num.unknown || num.incremental);
        if let Some(num) = open {
            return self.fail(codes::T1003, num.span, "a call takes plain numbers");
        }
        let mut give = |addr: Addr, value: f64| {
            locals.insert(VarRef { kind: VarKind::Argument, number: addr.0 }, Some(value));
        };
        for (addr, num) in w.longs() {
            if !ADMITTED.iter().any(|name| Addr::of(name.as_bytes()) == Some(*addr)) {
                return self.fail(codes::T1003, num.span, format!("{addr} hands no value over"));
            }
            give(*addr, num.value);
        }
        if let (Some(num), Some(addr)) = (w.get(b'I'), Addr::of(b"I")) {
            give(addr, num.value);
        }
        Ok(locals)
    }

    fn call_section(&mut self, name: &str, locals: Locals) -> Outcome {
        let (job, here) = (self.job, self.here.origin.loc);
        let program = self.level().program;
        let names = self.program();
        let file = names.source.file;
        let names = names.names.get_or_insert_with(|| Names::scan(&job, file, here));
        let Some(place) = names.places.get(&name.to_ascii_uppercase()).copied() else {
            let mut known: Vec<&str> = names.places.keys().map(String::as_str).collect();
            known.sort_unstable();
            let upper = name.to_ascii_uppercase();
            let like = crate::machine::tree::did_you_mean(&upper, known).map(str::to_owned);
            let found = Diagnostic::new(codes::T2011, here, format!("there is no section SUBPROGRAM \"{name}\""));
            self.report(match like {
                Some(like) => found.help(format!("did you mean `{like}`?")),
                None => found.help("write V1 for a subprogram in a file of its own"),
            });
            self.ended = true;
            return Err(Reported);
        };
        self.enter(LevelKind::Local { at: place.at }, program, place, locals, name)
    }

    fn call_file(&mut self, name: &str, locals: Locals) -> Outcome {
        let site = self.here.origin.loc;
        let call = self.here.origin.call;
        self.budget.search();
        let opened = open_program(&self.job, name, &["ncs", "NCS", "nc"], site, call);
        let Some(program) = opened.and_then(|file| self.open(file, site)) else { return Err(Reported) };
        let start = self.programs[program].source.cursor.start();
        self.enter(LevelKind::External, program, start, locals, name)
    }

    fn enter(&mut self, kind: LevelKind, program: usize, to: Place, locals: Locals, name: &str) -> Outcome {
        let site = self.here.origin.loc;
        let runs = |level: &Level| {
            level.program == program
                && (level.kind == kind || (kind == LevelKind::External && level.kind == LevelKind::Main))
        };
        if self.levels.iter().any(runs) {
            self.error(codes::T2012, format!("`{name}` calls itself"));
            self.ended = true;
            return Err(Reported);
        }
        let limit = self.job.settings.limits.call_depth.min(DEEPEST);
        if self.levels.len() > limit {
            self.error(codes::P4003, format!("subprograms are nested deeper than {limit} levels"));
            self.ended = true;
            return Err(Reported);
        }
        let sources = self.job.sources;
        // The way back needs the caller in memory.
        if self.program().source.cursor.load(sources).is_err() {
            self.ended = true;
            return Err(Reported);
        }
        let back = self.program().source.cursor.place();
        let call = self.job.trail.enter(self.level().call, site);
        let number = self.budget_number();
        let part = std::mem::replace(&mut self.sections.part, Part::Machining);
        self.levels.push(Level { kind, program, back, call, locals, nests: Vec::new(), number, begun: false, part });
        self.budget.jump(site);
        self.seek(to)
    }

    /// A number that no level had before.
    fn budget_number(&mut self) -> u32 {
        self.calls = self.calls.saturating_add(1);
        self.calls
    }

    /// RETURN.
    pub(super) fn return_from_subprogram(&mut self) -> Outcome {
        if let Some(nest) = self.level().nests.last() {
            let loc = nest.loc;
            self.report(Diagnostic::new(codes::T1009, loc, "this is not closed when the subprogram ends"));
        }
        if let Some(level) = self.levels.pop() {
            self.sections.part = level.part;
            return self.seek(level.back);
        }
        Ok(())
    }
}
