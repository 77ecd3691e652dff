//! Blocks that did not run: what `partc check` can say of them.
//!
//! What is wrong in the block itself is an error as in a block that runs. Jumps that lead nowhere and what partc would
//! refuse, and programs that are not here, are warnings: the output does not depend on them. Blocks of which the run
//! reported an error are left alone.

use rustc_hash::{FxHashMap, FxHashSet};

use crate::diag::{Code, Diagnostic, Label, codes};
use crate::parser::sinumerik::ast::{
    Block, CallForm, Formula, Jump, JumpTarget, Op, Search, Stmt, Target, Value, Word,
};
use crate::parser::symbols::{Symbol, Symbols};
use crate::sema::Job;
use crate::sema::run::unexecuted::{Blocks, Passed};
use crate::sema::run::{Program, Site};
use crate::text::{Loc, Span};

use super::beside_path::Beside;
use super::cycles::{is_built, is_taken, measures};
use super::dictionary;
use super::entries::reserved;
use super::foreign_codes::in_place_of;
use super::g_groups::{GCode, GCodes};
use super::macros::Sinumerik;
use super::programs::{Skeleton, Units, bare_name, without_extension};
use super::search_path::{Found, SearchPath};
use super::stand_in::NameOfCall;
use super::vocabulary::{Meaning, Procedure};

/// Looks at every block of the main program after its run.
pub fn check_unexecuted(job: &Job<'_>) {
    let start = Loc { file: job.main, line: 1, span: Span::default() };
    let mut check = Unexecuted::new(job);
    let Some(main) = Program::open(job, job.main, start) else { return };
    check.files.push(main);
    check.units.first_of(job, &check.files, 0);
    if check.collect_names().is_err() {
        return;
    }
    let Some(mut blocks) = Blocks::<Sinumerik>::of_main(job) else { return };
    while let Some(passed) = blocks.next_behind_straight(job, &mut check.symbols) {
        // A macro may stand for anything.
        if matches!(passed.block.stmt, Stmt::Define(_)) {
            return;
        }
        if passed.is_free_of(&check.reported) && !check.iso_dialect(passed.block) {
            check.look(passed.block, passed.text, &passed.site);
        }
    }
}

struct Unexecuted<'a> {
    job: &'a Job<'a>,
    symbols: Symbols,
    files: Vec<Program<Sinumerik>>,
    units: Units,
    vocabulary: &'static FxHashMap<&'static str, Meaning>,
    gcodes: GCodes,
    /// Offsets of reported errors.
    reported: Vec<u32>,
    /// Variables of any program of the file.
    variables: FxHashSet<Symbol>,
    /// Programs that were looked for, and whether they are here.
    looked_for: FxHashMap<Symbol, bool>,
    iso: bool,
}

impl<'a> Unexecuted<'a> {
    fn new(job: &'a Job<'a>) -> Unexecuted<'a> {
        Unexecuted {
            job,
            symbols: Symbols::default(),
            files: Vec::new(),
            units: Units::default(),
            vocabulary: dictionary::words(),
            gcodes: GCodes::new(),
            reported: job.diags.errors_in(job.main),
            variables: FxHashSet::default(),
            looked_for: FxHashMap::default(),
            iso: false,
        }
    }

    /// Variables and programs of the file, and whether the structures of each program are closed. A file without
    /// structures is not loaded for it.
    fn collect_names(&mut self) -> std::io::Result<()> {
        let Some(mut blocks) = Blocks::<Sinumerik>::of_main(self.job) else { return Ok(()) };
        let mut structured = Vec::new();
        let mut several = false;
        while let Some(Passed { block, site, .. }) = blocks.next_behind_straight(self.job, &mut self.symbols) {
            match block.stmt {
                Stmt::Def { .. } | Stmt::Proc(_) => {
                    self.variables.extend(block.variables.iter().filter_map(|variable| variable.name));
                }
                Stmt::Header => several = true,
                Stmt::If(_) | Stmt::Else | Stmt::EndIf | Stmt::While(_) | Stmt::EndWhile => structured.push(site.at),
                Stmt::For { .. } | Stmt::EndFor | Stmt::Loop | Stmt::EndLoop => structured.push(site.at),
                Stmt::RepeatLoop | Stmt::Until(_) => structured.push(site.at),
                _ => {}
            }
        }
        if several || !structured.is_empty() {
            self.units.list_file(self.job, &mut self.files, 0)?;
        }
        let mut known = FxHashSet::default();
        for at in structured {
            let unit = self.units.list.iter().rposition(|unit| unit.start.at <= at).unwrap_or(0);
            if known.insert(unit) {
                self.units.skeleton(self.job, &mut self.files, unit, &mut self.symbols)?;
            }
        }
        Ok(())
    }

    /// Between G291 and G290 words mean something else.
    fn iso_dialect(&mut self, block: &Block) -> bool {
        let has = |number: f64| {
            block.words.iter().any(|word| matches!((word.target, word.value), (Target::Letter(b'G'), Value::Literal { value, .. }) if value == number))
        };
        if has(291.0) {
            self.iso = true;
        }
        if has(290.0) {
            self.iso = false;
            return true;
        }
        self.iso
    }

    fn look(&mut self, block: &Block, text: &[u8], here: &Site) {
        let at = here.at;
        let found = match block.stmt {
            Stmt::Words => self.words(block, here),
            Stmt::Goto(jump) => self.jump(jump, at, here),
            Stmt::IfJump | Stmt::Case(_) => block.arms.iter().find_map(|arm| self.jump(arm.jump, at, here)),
            Stmt::Repeat { from, to, .. } => {
                [Some(from), to].into_iter().flatten().find_map(|label| self.label(label, block, at, here))
            }
            Stmt::RepeatBlock { label, .. } => self.label(label, block, at, here),
            Stmt::Call(form) => self.call(form, block, text, here),
            Stmt::Sync(_) if self.job.settings.control.sinumerik.beside.synchronized => None,
            Stmt::Sync(span) => Some(refused(self.job, here, span, codes::S9004)),
            _ => None,
        };
        if let Some(found) = found
            && !self.job.diags.knows(&found)
        {
            self.job.diags.push(found);
        }
    }

    // Jumps.

    fn skeleton(&mut self, at: u32) -> Option<std::rc::Rc<Skeleton>> {
        let unit = self.units.list.iter().rposition(|unit| unit.start.at <= at)?;
        self.units.skeleton(self.job, &mut self.files, unit, &mut self.symbols).ok()
    }

    fn jump(&mut self, jump: Jump, at: u32, here: &Site) -> Option<Diagnostic> {
        if jump.search == Search::BothQuiet {
            return None;
        }
        let skeleton = self.skeleton(at)?;
        let (found, what) = match jump.target {
            JumpTarget::Number(n) => (skeleton.number(n, at, jump.search), format!("block N{n}")),
            JumpTarget::Label(name) if self.variables.contains(&name) => return None,
            JumpTarget::Label(name) => {
                (skeleton.label(name, at, jump.search), format!("label `{}`", self.symbols.name(name)))
            }
            JumpTarget::Text(_) | JumpTarget::Start => return None,
        };
        if found.is_some() {
            return None;
        }
        let way = match jump.search {
            Search::Forward => " after this block",
            Search::Backward => " before this block",
            _ => "",
        };
        // The control looks for the target when it jumps.
        Some(codes::P8140::this_jump_is_not_made(&what, &way, &codes::P2011.id).at(here.loc(self.job, jump.span)))
    }

    fn label(&mut self, name: Symbol, block: &Block, at: u32, here: &Site) -> Option<Diagnostic> {
        let jump = Jump { search: Search::Both, target: JumpTarget::Label(name), span: block.span };
        self.jump(jump, at, here)
    }

    // Calls.

    fn call(&mut self, form: CallForm, block: &Block, text: &[u8], here: &Site) -> Option<Diagnostic> {
        let written = |formula: Formula| match block.formula(formula) {
            [Op::Text(span)] => Some((String::from_utf8_lossy(span.of(text)).into_owned(), formula.span)),
            _ => None,
        };
        match form {
            CallForm::Text(formula) | CallForm::External(formula) => {
                let (name, span) = written(formula)?;
                self.program(&name, None, span, here)
            }
            CallForm::Modal { name, .. } => {
                let word = self.symbols.name(name).to_owned();
                match self.vocabulary.get(word.as_str()) {
                    Some(_) if is_built(&word) || self.stands_for(&word) => None,
                    Some(_) => Some(refused(self.job, here, block.span, codes::P9010)),
                    None => self.program(&word, None, block.span, here),
                }
            }
            CallForm::Iso => Some(refused(self.job, here, block.span, codes::P9012)),
            CallForm::Path { .. } | CallForm::Section { .. } | CallForm::ModalOff => None,
        }
    }

    /// Does `[programs]` say what stands for this name?
    fn stands_for(&self, name: &str) -> bool {
        self.job.settings.programs.contains_key(name)
    }

    /// Does `[control]` leave this word of the language out?
    fn is_left_out(&self, name: &str) -> bool {
        let beside = || Beside::find(name).is_some_and(|beside| beside.is_left_out(self.job.settings));
        measures(name) && self.job.settings.control.klartext_choices.probing_left_out || beside()
    }

    /// A warning for a program that is not here. `text` is the first argument that is a text, if there are arguments.
    fn program(&mut self, name: &str, text: Option<Option<usize>>, span: Span, here: &Site) -> Option<Diagnostic> {
        let upper = name.to_ascii_uppercase();
        let last = upper.rsplit(['/', '\\']).next().unwrap_or(&upper);
        let (bare, _) = bare_name(last);
        let symbol = self.symbols.intern(upper.as_bytes());
        let is_here = match self.looked_for.get(&symbol) {
            Some(known) => *known,
            None => {
                let is_here = self.stands_for(without_extension(&bare)) || self.is_there(&upper);
                self.looked_for.insert(symbol, is_here);
                is_here
            }
        };
        (!is_here).then(|| {
            let call = NameOfCall {
                name: without_extension(&bare),
                text: text.flatten(),
                arguments: text.is_some(),
                tool_waits: false,
            };
            let known = self.vocabulary.get(call.name).is_some_and(|known| reserved(*known).is_some());
            let help = if known { call.help_of_word() } else { call.help() };
            codes::P8140::this_block_does_not_run_if_it_did(&bare, &codes::S2002.id)
                .at(here.loc(self.job, span))
                .help(help)
        })
    }

    /// What cannot be opened, or stands twice, is there.
    fn is_there(&self, name: &str) -> bool {
        let main = (0, self.job.main);
        let path = SearchPath { job: self.job, units: &self.units, files: [main, main], call_path: None };
        !matches!(path.look(name), Found::Nowhere(_))
    }

    // Words.

    fn words(&mut self, block: &Block, here: &Site) -> Option<Diagnostic> {
        let repeated = repeated_words(self, block, here);
        repeated
            .or_else(|| self.codes(block, here))
            .or_else(|| block.words.iter().find_map(|word| self.refused_word(word, block, here)))
    }

    /// The G code that a word is.
    fn code_of(&self, word: &Word) -> Option<Result<GCode, f64>> {
        match (word.target, word.value) {
            (Target::Letter(b'G'), Value::Literal { value, .. }) => Some(self.gcodes.get(value).ok_or(value)),
            (Target::Name(name), Value::None) => match self.vocabulary.get(self.symbols.name(name)) {
                Some(Meaning::Code(code)) => Some(Ok(*code)),
                _ => None,
            },
            _ => None,
        }
    }

    /// G codes that do not exist or exclude each other.
    fn codes(&self, block: &Block, here: &Site) -> Option<Diagnostic> {
        let mut seen: Vec<(GCode, Span)> = Vec::new();
        for word in &block.words {
            let code = match self.code_of(word) {
                None => continue,
                Some(Ok(code)) => code,
                Some(Err(number)) => {
                    return Some(
                        codes::S2010::g_is_not_known(&number)
                            .at(here.loc(self.job, word.span))
                            .help(in_place_of(number)),
                    );
                }
            };
            let shapes = |code: GCode| code.group.shapes_block();
            let other = seen
                .iter()
                .find(|(known, _)| *known != code && (known.group == code.group || shapes(*known) && shapes(code)));
            if let Some((first, at)) = other {
                let (a, b) = (first.word(), code.word());
                let fault = if shapes(code) {
                    codes::S2009::cannot_stand_in_one_block(&a, &b)
                } else {
                    codes::S2008::are_of_one_group(&a, &b)
                };
                let found = fault.at(here.loc(self.job, word.span));
                return Some(found.also(here.loc(self.job, *at), Label::OtherOne).help("delete one of them"));
            }
            seen.push((code, word.span));
        }
        None
    }

    /// What would be refused, or is not here.
    fn refused_word(&mut self, word: &Word, block: &Block, here: &Site) -> Option<Diagnostic> {
        match (word.target, word.value) {
            (Target::Letter(b'L'), Value::Literal { value, digits, whole: true }) => {
                let width = usize::from(digits);
                self.program(&format!("L{value:0width$}"), None, word.span, here)
            }
            (Target::Letter(b'M'), Value::Literal { value, .. }) => {
                let known = value <= 9.0 || matches!(value as u32, 17 | 19 | 30 | 40..=45);
                let passed = self.job.settings.output.pass_m.contains(&(value as u32))
                    || self.job.settings.control.tool_change_m.contains(&(value as u32));
                (!known && !passed).then(|| refused(self.job, here, word.span, codes::P2007))
            }
            (Target::Name(name), Value::None | Value::Call(_)) => {
                let shown = self.symbols.name(name).to_owned();
                if self.stands_for(&shown) || self.is_left_out(&shown) {
                    return None;
                }
                match self.vocabulary.get(shown.as_str()) {
                    Some(Meaning::Procedure(Procedure::Refused(_))) if is_taken(&shown) => None,
                    Some(Meaning::Procedure(Procedure::Refused(refusal))) => {
                        Some(refused(self.job, here, word.span, refusal.code))
                    }
                    Some(Meaning::Known(_)) if !self.variables.contains(&name) => {
                        Some(refused(self.job, here, word.span, codes::S9132))
                    }
                    Some(_) => None,
                    None if self.variables.contains(&name) || block.words.len() > 1 => None,
                    None => {
                        let arguments = match word.value {
                            Value::Call(args) => Some(block.arguments(args)),
                            _ => None,
                        };
                        let is_text = |formula: &Formula| matches!(block.formula(*formula), [Op::Text(_)]);
                        let text = arguments.map(|list| list.iter().position(is_text).map(|at| at + 1));
                        self.program(&shown, text, word.span, here)
                    }
                }
            }
            _ => None,
        }
    }
}

/// A word that may stand once and stands twice.
fn repeated_words(check: &Unexecuted<'_>, block: &Block, here: &Site) -> Option<Diagnostic> {
    let once = |word: &Word| match word.target {
        Target::Letter(
            letter @ (b'X' | b'Y' | b'Z' | b'A'..=b'C' | b'U'..=b'W' | b'I'..=b'K' | b'F' | b'T' | b'D' | b'L' | b'P'),
        ) => {
            let variable = std::str::from_utf8(&[letter]).ok().and_then(|name| check.symbols.find(name));
            !variable.is_some_and(|name| check.variables.contains(&name))
        }
        Target::Name(name) => {
            let address = matches!(check.vocabulary.get(check.symbols.name(name)), Some(Meaning::Address(_)));
            address && !check.variables.contains(&name)
        }
        _ => false,
    };
    for (at, word) in block.words.iter().enumerate().filter(|(_, word)| once(word)) {
        if block.words[..at].iter().any(|first| first.target == word.target) {
            return Some(codes::P1002::address_stands_twice_in_block().at(here.loc(check.job, word.span)));
        }
    }
    None
}

fn refused(job: &Job<'_>, here: &Site, span: Span, code: &'static Code) -> Diagnostic {
    codes::P8140::this_block_does_not_run(&code.title, &code.id).at(here.loc(job, span))
}
