//! Where the program that runs goes on: the targets of jumps, the lines of structures, the sections of repeats.
//!
//! Source: S 5.3 to 5.5 (docs/sources.md).

use std::rc::Rc;

use crate::diag::{Diagnostic, Fault, Label, codes};
use crate::machine::tree::did_you_mean;
use crate::parser::sinumerik::ast::{Jump, JumpTarget, Search};
use crate::parser::symbols::Symbol;
use crate::sema::run::{Site, Where};
use crate::text::{Loc, Place, Span};

use super::programs::{Mark, Skeleton, Structure, Units};
use super::value::{Val, to_text};
use super::{Core, Outcome, Reported};

impl Units {
    pub(super) fn skeleton_here(&mut self, core: &mut Core<'_>) -> Outcome<Rc<Skeleton>> {
        let unit = core.level().frame.unit;
        self.skeleton_of(core, unit, Where::Block)
    }

    /// The structure that the current block belongs to. A structure that is not closed was reported.
    pub(super) fn own_structure(&mut self, core: &mut Core<'_>) -> Outcome<Structure> {
        let found = self.skeleton_here(core)?.structure_of(core.here.at);
        if found.is_none() {
            // Without its partner nobody knows where the program goes on.
            core.stop_run();
        }
        found.ok_or(Reported)
    }

    /// Goes on behind a line of a structure, which is not executed but has to be right.
    pub(super) fn go_behind(&mut self, core: &mut Core<'_>, line: Mark) -> Outcome {
        let wrong = self.skeleton_here(core)?.wrong_line(line.place.at).cloned();
        if let Some((number, lines, problem)) = wrong {
            let here = Site::new(core.here.file, line.place.at, number, lines, core.here.origin.call);
            let found = here.diagnostic(&core.job, problem);
            if !core.job.diags.knows(&found) {
                core.job.diags.push(found);
            }
            core.stop_run();
            return Err(Reported);
        }
        core.go_to(line.after)
    }

    /// The target of a jump from the offset `from`, by its name where `value` gives one; `None` for one that may be missing.
    pub(super) fn target(
        &mut self,
        core: &mut Core<'_>,
        jump: Jump,
        value: Option<&Val>,
        from: u32,
    ) -> Outcome<Option<Mark>> {
        let named = value.map(|value| core.accept(jump.span, name_of_target(value))).transpose()?;
        let skeleton = self.skeleton_here(core)?;
        let (found, what) = match (named, jump.target) {
            (Some(name), _) => (name.find(&skeleton, core, jump.search, from), format!("jump target `{}`", name.shown)),
            (None, JumpTarget::Number(n)) => (skeleton.number(n, from, jump.search), format!("block N{n}")),
            (None, JumpTarget::Label(name)) => {
                (skeleton.label(name, from, jump.search), format!("label `{}`", core.symbols.name(name)))
            }
            (None, JumpTarget::Text(_) | JumpTarget::Start) => (None, "jump target".to_owned()),
        };
        if found.is_some() || jump.search == Search::BothQuiet {
            return Ok(found);
        }
        let found = no_target(&skeleton, core, jump, &what);
        core.report(found);
        Err(Reported)
    }

    /// A label of a repeat: the nearest one in front, else behind.
    pub(super) fn section_label(&mut self, core: &mut Core<'_>, name: Symbol, span: Span) -> Outcome<Mark> {
        let at = core.here.at;
        let skeleton = self.skeleton_here(core)?;
        match skeleton.label(name, at, Search::Backward).or_else(|| skeleton.label(name, at, Search::Forward)) {
            Some(mark) => Ok(mark),
            None => {
                let jump = Jump { search: Search::Both, target: JumpTarget::Label(name), span };
                let what = format!("label `{}`", core.symbols.name(name));
                core.stop_run();
                let found = no_target(&skeleton, core, jump, &what);
                core.report(found);
                Err(Reported)
            }
        }
    }

    /// The section of a repeat: its start, and the offset behind it.
    pub(super) fn section(
        &mut self,
        core: &mut Core<'_>,
        from: Symbol,
        to: Option<Symbol>,
        span: Span,
    ) -> Outcome<(Place, u32)> {
        let start = self.section_label(core, from, span)?.place;
        if let Some(to) = to {
            let end = self.section_label(core, to, span)?;
            if end.place.at < start.at {
                return core.refuse(span, codes::P2011::last_label_of_section_stands_in_front());
            }
            return Ok((start, end.after.at));
        }
        let end = core.symbols.intern(b"ENDLABEL");
        match self.skeleton_here(core)?.label(end, start.at, Search::Forward) {
            Some(end) => Ok((start, end.after.at)),
            None if start.at < core.here.at => Ok((start, core.here.at)),
            None => core.refuse(span, codes::P2011::section_behind_this_block_has_no_endlabel()),
        }
    }

    /// The section of the program `unit` that a call runs, from one label to another.
    pub(super) fn called_section(
        &mut self,
        core: &mut Core<'_>,
        unit: usize,
        from: Symbol,
        to: Symbol,
        span: Span,
    ) -> Outcome<(Place, u32)> {
        let skeleton = self.skeleton_of(core, unit, span.into())?;
        let start = skeleton.label(from, 0, Search::Both);
        let end =
            start.and_then(
                |start| {
                    if from == to { Some(start) } else { skeleton.label(to, start.place.at, Search::Forward) }
                },
            );
        let fault = match (start, end) {
            (Some(start), Some(end)) => return Ok((start.place, end.after.at)),
            (None, _) => codes::P2011::there_is_no_label_in_program(&core.symbols.name(from)),
            (Some(_), None) => codes::P2011::there_is_no_label_behind_first(&core.symbols.name(to)),
        };
        core.stop_run();
        core.refuse(span, fault)
    }
}

/// `"N100"`, `"100"` or `"LABEL"`.
struct TargetName {
    shown: String,
    upper: Vec<u8>,
}

fn name_of_target(value: &Val) -> Result<TargetName, Fault> {
    let text = to_text(value).filter(|text| !text.is_empty()).ok_or_else(codes::P2011::jump_target_is_no_text)?;
    Ok(TargetName { shown: String::from_utf8_lossy(&text).into_owned(), upper: text.to_ascii_uppercase() })
}

impl TargetName {
    fn find(&self, skeleton: &Skeleton, core: &mut Core<'_>, search: Search, from: u32) -> Option<Mark> {
        let upper = &self.upper[..];
        let digits = upper.strip_prefix(b"N").or_else(|| upper.strip_prefix(b":")).unwrap_or(upper);
        let digits = digits.strip_suffix(b":").unwrap_or(digits);
        match std::str::from_utf8(digits).ok().and_then(|digits| digits.parse().ok()) {
            Some(n) => skeleton.number(n, from, search),
            None => {
                let name = upper.strip_suffix(b":").unwrap_or(upper);
                skeleton.label(core.symbols.intern(name), from, search)
            }
        }
    }
}

/// What is said of a jump without a target.
fn no_target(skeleton: &Skeleton, core: &mut Core<'_>, jump: Jump, what: &str) -> Diagnostic {
    let elsewhere = match jump.target {
        JumpTarget::Label(name) => skeleton.label(name, core.here.at, Search::Both),
        JumpTarget::Number(n) => skeleton.number(n, core.here.at, Search::Both),
        JumpTarget::Text(_) | JumpTarget::Start => None,
    };
    let way = match jump.search {
        Search::Forward => " after this block",
        Search::Backward => " before this block",
        _ => "",
    };
    let found = codes::P2011::there_is_no(&what, &way).at(core.loc(jump.span));
    match (elsewhere, jump.target) {
        (Some(mark), _) => {
            let span = Span::at(mark.place.at, (mark.after.at - mark.place.at).saturating_sub(1));
            let loc = Loc { file: core.program().source.file, line: mark.place.line, span };
            let other = if jump.search == Search::Forward { "GOTOB" } else { "GOTOF" };
            found.also(loc, Label::StandsHere).help(format!("jump by {other} or GOTO"))
        }
        (None, JumpTarget::Label(name)) => {
            let names: Vec<&str> = skeleton.labels().map(|label| core.symbols.name(label)).collect();
            match did_you_mean(core.symbols.name(name), names) {
                Some(like) => found.help(format!("did you mean `{like}`?")),
                None => found.help("write the label before the block to jump to: `NAME:`"),
            }
        }
        _ => found.help("check the target of the jump"),
    }
}
