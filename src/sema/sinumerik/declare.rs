//! Declarations: DEF in programs and in definition files.
//!
//! Source: S 5.1 (docs/sources.md).

use crate::diag::{Fault, Label, codes};
use crate::parser::sinumerik::SPLIT;
use crate::parser::sinumerik::ast::{Block, Formula, Stmt, TypeName, Variable};
use crate::parser::sinumerik::parse_block;
use crate::parser::symbols::Symbol;
use crate::sema::Job;
use crate::sema::run::{Site, not_opened, open_cursor, refused};
use crate::text::{FileError, FileId, Loc, Next, Opened, Place, Request, Span, Within};

use super::control_folders::{DEFINITION_FILES, names_below};
use super::conversions::DEFINED;
use super::line::Line;
use super::value::{MOST_TEXT, Val, whole};
use super::vars::{Kept, MOST_ELEMENTS, Slot, Var, Vars};
use super::vocabulary::Meaning;
use super::{Channel, Outcome, Reported, Run, formula_functions, levels};

/// The folder of the control in which definitions count.
const DEFINITIONS: &str = "/_N_DEF_DIR";
/// Characters of a STRING.
const LONGEST_TEXT: usize = 200;
/// Characters of a name.
const LONGEST_NAME: usize = 32;

/// `R1`, a machine axis like X1, or a letter that is an address on every machine.
fn is_address(name: &str) -> bool {
    match name.as_bytes() {
        [letter] => b"DFGHMPRST".contains(letter),
        [b'R' | b'X' | b'Y' | b'Z', digits @ ..] => digits.iter().all(u8::is_ascii_digit),
        _ => false,
    }
}

impl Run<'_> {
    pub(super) fn def_block(
        &mut self,
        kind: TypeName,
        length: Option<Formula>,
        global: bool,
        line: Line<'_>,
    ) -> Outcome {
        let level = levels::program(&mut self.channel.core.levels);
        if level.executed && !global {
            return self.channel.core.refuse(line.block.span, codes::S2015::def_stands_behind_executed_blocks());
        }
        level.declares |= !global;
        let length = match length {
            Some(formula) => {
                let n = self.number(formula, line)?;
                match whole(n).and_then(|n| usize::try_from(n).ok()).filter(|n| *n <= LONGEST_TEXT) {
                    Some(n) => n,
                    None => {
                        return self.channel.core.refuse(formula.span, codes::S2030::text_has_0_to_200_characters());
                    }
                }
            }
            None if kind == TypeName::String => 32,
            None => MOST_TEXT,
        };
        let mut result = Ok(());
        for variable in &line.block.variables {
            if let Err(reported) = self.define(variable, kind, length, global, line) {
                result = Err(reported);
            }
        }
        result
    }

    fn define(&mut self, variable: &Variable, kind: TypeName, length: usize, global: bool, line: Line<'_>) -> Outcome {
        let Some(name) = variable.name else { return Ok(()) };
        let meaning = self.names.meaning(name, &self.channel);
        self.vars.is_free_name(name, meaning, global, &self.channel, variable.span)?;
        let mut sizes = Vec::new();
        for formula in line.arguments(variable.sizes) {
            let n = self.number(*formula, line)?;
            match whole(n).and_then(|n| u32::try_from(n).ok()).filter(|n| (1..=MOST_ELEMENTS).contains(n)) {
                Some(n) => sizes.push(n),
                None => return self.channel.core.refuse(formula.span, codes::S2018::array_has_1_to_32767_elements()),
            }
        }
        let core = &mut self.channel.core;
        let count = core.accept(variable.span, elements_of(&sizes))?;
        // Making them is work.
        core.budget.take(count / 64);
        let limits = line.block.limits;
        if let [Some(least), Some(most)] = limits
            && least > most
        {
            return core.refuse(variable.span, codes::S2029::lli_is_above_uli(&least, &most));
        }
        // A variable that is given no value has zero, or the nearer limit.
        let mut zero = Val::zero(kind);
        if zero.number().is_some() {
            let [least, most] = limits;
            let nearest = 0.0f64.max(least.unwrap_or(f64::NEG_INFINITY)).min(most.unwrap_or(f64::INFINITY));
            zero = Val::Real(nearest).taken_as(kind, DEFINED, core, variable.span)?;
        }
        let values = vec![zero; count as usize];
        let defined = core.loc(variable.span);
        let mut var = Var { kind, sizes, values, length, defined, lost: false, kept: Kept::default(), limits };
        if let Some(formula) = variable.value {
            if kind == TypeName::Frame {
                return core.refuse(formula.span, codes::S2017::frame_cannot_be_given_value_by_def());
            }
            var = self.started(var, formula, line)?;
        }
        let core = &self.channel.core;
        if global {
            var.kept = Kept::of_global(name);
            var = var.with_kept_values(core.symbols.name(name), core, variable.span)?;
        }
        core.job.trail.forget_zero(core.symbols.name(name));
        if !self.vars.define(name, var, global) {
            return core.refuse(variable.span, codes::S2018::variables_of_program_are_too_large());
        }
        Ok(())
    }

    fn started(&mut self, mut var: Var, formula: Formula, line: Line<'_>) -> Outcome<Var> {
        if let Some(fill) = self.list_of(formula, line)? {
            return var.filled(0, &fill, &self.channel.core, formula.span);
        }
        let value = self.eval(formula, line)?;
        let core = &self.channel.core;
        let value = value.taken_as(var.kind, DEFINED, core, formula.span)?;
        core.accept(formula.span, value.keeps_length(var.length))?;
        core.accept(formula.span, value.keeps_limits(var.limits, [12160, 12160]))?;
        // A single value fills the first element.
        if let Some(first) = var.values.first_mut() {
            *first = value;
        }
        Ok(var)
    }

    /// True if the definition files were read before; otherwise reads them now.
    pub(super) fn definitions_known(&mut self) -> bool {
        if std::mem::replace(&mut self.definitions_read, true) {
            return true;
        }
        let mut any = false;
        let before = self.vars.global_names();
        let _ = self.units.list_programs(&mut self.channel.core, 0);
        for name in DEFINITION_FILES {
            // In an archive they lie between the programs.
            if let Some((start, end)) = self.units.definitions(name) {
                any = true;
                self.read_definitions(self.channel.core.job.main, Some(start), end);
                continue;
            }
            let from = Loc { line: 1, ..Loc::default() };
            let job = &self.channel.core.job;
            let (opened, of_control) = match definition_file(job, name) {
                Ok(Some(found)) => found,
                Ok(None) => continue,
                // What it defines is not known, and may change the meaning of any word.
                Err(error) => {
                    job.diags.push(not_opened(error, &format!("{name}.DEF"), from));
                    self.channel.core.stop_run();
                    break;
                }
            };
            let file = match job.sources.add(opened) {
                Ok(file) => file,
                Err(too_much) => {
                    job.diags.push(refused(too_much, name, from));
                    continue;
                }
            };
            any = true;
            if of_control {
                let loc = Loc { file, line: 1, ..Loc::default() };
                self.units.note_copy(&self.channel.core, DEFINITIONS, loc);
            }
            self.read_definitions(file, None, u32::MAX);
        }
        self.vars.definitions_end(&before);
        !any
    }

    /// Reads a definition file, or the part of an archive from `start` to the offset `end`.
    fn read_definitions(&mut self, file: FileId, start: Option<Place>, end: u32) {
        let job = self.channel.core.job;
        let here = self.channel.core.here;
        let Some(mut cursor) = open_cursor(&job, file, SPLIT, here.origin.loc) else { return };
        if let Some(start) = start
            && cursor.load(job.sources).and_then(|()| cursor.seek(job.sources, start)).is_err()
        {
            return;
        }
        let mut block = Block::default();
        while let Ok(Next::Block(found)) = cursor.next(job.sources) {
            let (at, line, text) = (found.at, found.line, found.text.to_vec());
            if at >= end {
                break;
            }
            let core = &mut self.channel.core;
            parse_block(&text, &mut block, &mut core.symbols, &mut core.problems);
            core.here = Site::new(file, at, line, 1, here.origin.call);
            core.here.origin.loc.span = block.span.shifted(at);
            core.report_problems();
            let _ = match block.stmt {
                Stmt::Def { kind, length, .. } => {
                    self.def_block(kind, length, true, Line { block: &block, text: &text })
                }
                Stmt::Define(span) => self.names.define_macro(span.of(&text), span, &self.vars, &mut self.channel),
                Stmt::Empty | Stmt::Header | Stmt::Bad | Stmt::Redef(_) | Stmt::Words => Ok(()),
                _ => core.refuse(block.span, codes::S2013::definition_file_holds_def()),
            };
        }
        self.channel.core.here = here;
    }
}

impl Vars {
    /// May a variable have this name? Not one that is known here by another definition, or as a word.
    fn is_free_name(&self, name: Symbol, meaning: Meaning, global: bool, channel: &Channel<'_>, span: Span) -> Outcome {
        let core = &channel.core;
        let word = core.symbols.name(name);
        if word.len() > LONGEST_NAME {
            return core.refuse(span, codes::S1014::name_has_characters(&word.len()));
        }
        let defined = core.loc(span);
        // Those of the definition files are one level, in whichever of them they stand.
        let known = if global { self.get(Slot::Global(name)) } else { self.of_level(name) };
        if let Some(first) = known.map(|var| var.defined).filter(|first| *first != defined) {
            let found = codes::S2016::is_defined_twice(&word).at(defined);
            core.report(found.also(first, Label::FirstDefinition).help("rename one of them"));
            return Err(Reported);
        }
        let taken = match meaning {
            Meaning::Axis(named) if named.axis.is_some_and(|axis| channel.st.machine.geometry_axes.contains(&axis)) => {
                "a geometry axis"
            }
            Meaning::Axis(named) if channel.axis_names.is_given(named) => "an axis",
            Meaning::Unknown if is_address(word) => "an address",
            Meaning::Unknown if formula_functions::find(word).is_some() => "a function",
            // Known words are options of the language, whose names machines without them leave free.
            Meaning::Axis(_) | Meaning::Unknown | Meaning::Known(_) => return Ok(()),
            _ => "a word of the language",
        };
        core.refuse(span, codes::S2016::is_cannot_be_variable(&word, &taken))
    }
}

/// The file of definitions, and whether it lies in the folder of the control where they count; if not, beside the main program.
fn definition_file(job: &Job<'_>, name: &str) -> Result<Option<(Opened, bool)>, FileError> {
    let from = job.sources.identity(job.main);
    let ask = |name: &str| {
        let request = Request { from: &from, name, extensions: &["DEF"], within: Within::Main };
        match job.files.open(&request) {
            Ok(opened) => Ok(Some(opened)),
            Err(FileError::NotFound { .. } | FileError::NoRoot { .. }) => Ok(None),
            Err(error) => Err(error),
        }
    };
    // `MGUD.DEF` is `_N_MGUD_DEF` on the control.
    let file = format!("_N_{name}_DEF");
    let names = names_below(DEFINITIONS, name).into_iter().chain(names_below(DEFINITIONS, &file));
    for of_control in names {
        if let Some(opened) = ask(&of_control)? {
            return Ok(Some((opened, true)));
        }
    }
    let beside = ask(name)?;
    let beside = if beside.is_some() { beside } else { ask(&file)? };
    Ok(beside.map(|opened| (opened, false)))
}

fn elements_of(sizes: &[u32]) -> Result<u64, Fault> {
    if sizes.len() > 3 {
        return Err(codes::S2018::array_has_at_most_three_directions());
    }
    let count = sizes.iter().map(|n| u64::from(*n)).product::<u64>();
    if count > u64::from(MOST_ELEMENTS) * 4 { Err(codes::S2018::elements_are_too_many(&count)) } else { Ok(count) }
}
