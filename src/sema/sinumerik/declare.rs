//! Declarations: DEF in programs and in definition files.
//!
//! Source: S 5.1 (docs/sources.md).

use crate::diag::{Label, codes};
use crate::parser::sinumerik::SPLIT;
use crate::parser::sinumerik::ast::{Block, Formula, Stmt, TypeName, Variable};
use crate::parser::sinumerik::parse_block;
use crate::parser::symbols::Symbol;
use crate::sema::run::{not_opened, open_cursor, refused};
use crate::text::{FileError, Loc, Next, Opened, Place, Request, Span, Within};

use super::control_folders::names_below;
use super::formula_functions;
use super::value::{MOST_TEXT, Val, whole};
use super::vars::{Kept, MOST_ELEMENTS, Slot, Var};
use super::vocabulary::Meaning;
use super::{Core, Outcome, Reported, Run};

/// The folder of the control in which definitions count.
const DEFINITIONS: &str = "/_N_DEF_DIR";
/// Definition files that a control reads at power-on, if they stand beside the program.
pub(super) const DEFINITION_FILES: &[&str] =
    &["SGUD", "MGUD", "UGUD", "GUD4", "GUD5", "GUD6", "GUD7", "GUD8", "GUD9", "SMAC", "MMAC", "UMAC"];

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
        block: &Block,
        text: &[u8],
    ) -> Outcome {
        if self.channel.core.program_level().executed && !global {
            return self.channel.core.refuse(block.span, codes::S2015::def_stands_behind_executed_blocks());
        }
        self.channel.core.program_level().declares |= !global;
        let length = match length {
            Some(formula) => {
                let n = self.number(formula, block, text)?;
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
        for variable in block.variables.clone() {
            if let Err(reported) = self.define(variable, kind, length, global, block, text) {
                result = Err(reported);
            }
        }
        result
    }

    pub(super) fn define(
        &mut self,
        variable: Variable,
        kind: TypeName,
        length: usize,
        global: bool,
        block: &Block,
        text: &[u8],
    ) -> Outcome {
        let Some(name) = variable.name else { return Ok(()) };
        let word = self.channel.core.symbols.name(name).to_owned();
        self.is_free_name(name, global, variable.span)?;
        let sizes = self.sizes_of(variable, block, text)?;
        let count = self.channel.core.elements_of(&sizes, variable.span)?;
        let limits = block.limits;
        if let [Some(least), Some(most)] = limits
            && least > most
        {
            return self.channel.core.refuse(variable.span, codes::S2029::lli_is_above_uli(&least, &most));
        }
        let zero = self.channel.core.start_value(kind, limits, variable.span)?;
        let values = vec![zero; count as usize];
        let defined = self.channel.core.loc(variable.span);
        let mut var = Var { kind, sizes, values, length, defined, lost: false, kept: Kept::default(), limits };
        if let Some(formula) = variable.value {
            if kind == TypeName::Frame {
                return self.channel.core.refuse(formula.span, codes::S2017::frame_cannot_be_given_value_by_def());
            }
            var = self.started(var, formula, block, text)?;
        }
        if global {
            var.kept = Kept::of_global(name);
            var = self.with_kept_values(&word, var, variable.span)?;
        }
        self.channel.core.job.trail.forget_zero(self.channel.core.symbols.name(name));
        if !self.vars.define(name, var, global) {
            return self.channel.core.refuse(variable.span, codes::S2018::variables_of_program_are_too_large());
        }
        Ok(())
    }

    /// May a variable have this name? Not one that is known here by another definition, or as a word.
    fn is_free_name(&mut self, name: Symbol, global: bool, span: Span) -> Outcome {
        let word = self.channel.core.symbols.name(name).to_owned();
        if word.len() > LONGEST_NAME {
            return self.channel.core.refuse(span, codes::S1014::name_has_characters(&word.len()));
        }
        let defined = self.channel.core.loc(span);
        // Those of the definition files are one level, in whichever of them they stand.
        let known = if global { self.vars.get(Slot::Global(name)) } else { self.vars.of_level(name) };
        if let Some(first) = known.map(|var| var.defined).filter(|first| *first != defined) {
            let found = codes::S2016::is_defined_twice(&word).at(defined);
            self.channel.core.report(found.also(first, Label::FirstDefinition).help("rename one of them"));
            return Err(Reported);
        }
        let taken = match self.meaning(name) {
            Meaning::Axis(named)
                if named.axis.is_some_and(|axis| self.channel.st.machine.geometry_axes.contains(&axis)) =>
            {
                Some("a geometry axis")
            }
            Meaning::Axis(named) if self.channel.axis_names.is_given(named) => Some("an axis"),
            Meaning::Axis(_) => None,
            Meaning::Unknown if is_address(&word) => Some("an address"),
            Meaning::Unknown if formula_functions::find(&word).is_some() => Some("a function"),
            Meaning::Unknown => None,
            // Options of the language, whose names machines without them leave free.
            Meaning::Known(_) => None,
            _ => Some("a word of the language"),
        };
        if let Some(what) = taken {
            return self.channel.core.refuse(span, codes::S2016::is_cannot_be_variable(&word, &what));
        }
        Ok(())
    }

    fn sizes_of(&mut self, variable: Variable, block: &Block, text: &[u8]) -> Outcome<Vec<u32>> {
        let mut sizes = Vec::new();
        for formula in block.arguments(variable.sizes).to_vec() {
            let n = self.number(formula, block, text)?;
            match whole(n).and_then(|n| u32::try_from(n).ok()).filter(|n| (1..=MOST_ELEMENTS).contains(n)) {
                Some(n) => sizes.push(n),
                None => {
                    return self.channel.core.refuse(formula.span, codes::S2018::array_has_1_to_32767_elements());
                }
            }
        }
        if sizes.len() > 3 {
            return self.channel.core.refuse(variable.span, codes::S2018::array_has_at_most_three_directions());
        }
        Ok(sizes)
    }

    pub(super) fn started(&mut self, mut var: Var, formula: Formula, block: &Block, text: &[u8]) -> Outcome<Var> {
        if let Some(fill) = self.list_of(formula, block, text)? {
            return self.channel.core.filled(&var, 0, &fill, formula.span);
        }
        let value = self.eval(formula, block, text)?;
        let value = self.channel.core.converted_or(&value, var.kind, formula.span, [12390, 12160])?;
        self.channel.core.check_length(&value, var.length, formula.span)?;
        self.channel.core.check_limits(&value, var.limits, [12160, 12160], formula.span)?;
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
        let _ = self.list_programs(0);
        for name in DEFINITION_FILES {
            // In an archive they lie between the programs.
            if let Some((start, end)) = self.units.definitions(name) {
                any = true;
                self.read_definitions(self.channel.core.job.main, Some(start), end);
                continue;
            }
            let from = Loc { line: 1, ..Loc::default() };
            let (opened, of_control) = match self.definition_file(name) {
                Ok(Some(found)) => found,
                Ok(None) => continue,
                // What it defines is not known, and may change the meaning of any word.
                Err(error) => {
                    self.channel.core.job.diags.push(not_opened(error, &format!("{name}.DEF"), from));
                    self.channel.core.stop_run();
                    break;
                }
            };
            let file = match self.channel.core.job.sources.add(opened) {
                Ok(file) => file,
                Err(too_much) => {
                    self.channel.core.job.diags.push(refused(too_much, name, from));
                    continue;
                }
            };
            any = true;
            if of_control {
                self.note_copy(DEFINITIONS, Loc { file, line: 1, ..Loc::default() });
            }
            self.read_definitions(file, None, u32::MAX);
        }
        !any
    }

    /// The file of definitions, and whether it lies in the folder of the control where they count; if not, beside the main program.
    fn definition_file(&self, name: &str) -> Result<Option<(Opened, bool)>, FileError> {
        let from = self.channel.core.job.sources.identity(self.channel.core.job.main);
        let ask = |name: &str| {
            let request = Request { from: &from, name, extensions: &["DEF"], within: Within::Main };
            match self.channel.core.job.files.open(&request) {
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

    /// Reads a definition file, or the part of an archive from `start` to the offset `end`.
    fn read_definitions(&mut self, file: crate::text::FileId, start: Option<Place>, end: u32) {
        let Some(mut cursor) = open_cursor(&self.channel.core.job, file, SPLIT, self.channel.core.here.origin.loc)
        else {
            return;
        };
        if let Some(start) = start
            && cursor
                .load(self.channel.core.job.sources)
                .and_then(|()| cursor.seek(self.channel.core.job.sources, start))
                .is_err()
        {
            return;
        }
        let here = self.channel.core.here;
        let mut block = Block::default();
        while let Ok(Next::Block(found)) = cursor.next(self.channel.core.job.sources) {
            let (at, line, text) = (found.at, found.line, found.text.to_vec());
            if at >= end {
                break;
            }
            parse_block(&text, &mut block, &mut self.channel.core.symbols, &mut self.channel.core.problems);
            self.channel.core.here = crate::sema::run::Site::new(file, at, line, 1, here.origin.call);
            self.channel.core.here.origin.loc.span = block.span.shifted(at);
            self.channel.core.report_problems();
            let _ = match block.stmt {
                Stmt::Def { kind, length, .. } => self.def_block(kind, length, true, &block, &text),
                Stmt::Define(span) => self.define_macro(span.of(&text), span),
                Stmt::Empty | Stmt::Header | Stmt::Bad | Stmt::Redef(_) | Stmt::Words => Ok(()),
                _ => self.channel.core.refuse(block.span, codes::S2013::definition_file_holds_def()),
            };
        }
        self.channel.core.here = here;
    }
}

impl Core<'_> {
    fn elements_of(&mut self, sizes: &[u32], span: Span) -> Outcome<u64> {
        let count = sizes.iter().map(|n| u64::from(*n)).product::<u64>();
        if count > u64::from(MOST_ELEMENTS) * 4 {
            return self.refuse(span, codes::S2018::elements_are_too_many(&count));
        }
        // Making them is work.
        self.budget.take(count / 64);
        Ok(count)
    }

    /// The value of a variable that is given none: zero, or the nearer limit.
    fn start_value(&self, kind: TypeName, limits: [Option<f64>; 2], span: Span) -> Outcome<Val> {
        let zero = Val::zero(kind);
        if zero.number().is_none() {
            return Ok(zero);
        }
        let least = limits[0].unwrap_or(f64::NEG_INFINITY);
        let most = limits[1].unwrap_or(f64::INFINITY);
        self.converted_or(&Val::Real(0.0f64.max(least).min(most)), kind, span, [12390, 12160])
    }
}
