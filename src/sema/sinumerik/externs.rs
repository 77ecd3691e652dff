//! EXTERN: what a program says of the parameters of another one, held against its PROC.
//!
//! Source: S 5.6, 7.1 and 7.2 (docs/sources.md).

use crate::diag::{Label, codes};
use crate::parser::sinumerik::ast::{Block, TypeName, Variable};
use crate::parser::symbols::Symbol;
use crate::text::Loc;

use super::levels::{self, FrameKind};
use super::value::type_name;
use super::{Core, Outcome, Reported};

/// A parameter as far as EXTERN tells it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Parameter {
    kind: TypeName,
    by_reference: bool,
    /// Directions of an array.
    directions: u32,
}

/// An EXTERN line.
#[derive(Debug)]
struct Extern {
    /// The program in which it stands.
    unit: usize,
    name: Symbol,
    parameters: Vec<Parameter>,
    loc: Loc,
    /// It was reported.
    told: bool,
}

impl Parameter {
    fn of(variable: &Variable) -> Parameter {
        let directions = if variable.open { 1 } else { variable.sizes.count };
        Parameter { kind: variable.kind, by_reference: variable.by_reference, directions }
    }

    fn shown(self) -> String {
        let var = if self.by_reference { "VAR " } else { "" };
        let array = match self.directions {
            0 => String::new(),
            n => format!("[{}]", ",".repeat(n as usize - 1)),
        };
        format!("{var}{}{array}", type_name(self.kind))
    }
}

/// What differs first between an EXTERN line and PROC.
fn difference(said: &[Parameter], is: &[Parameter]) -> Option<String> {
    if said.len() != is.len() {
        return Some(format!("it names {} parameters, PROC has {}", said.len(), is.len()));
    }
    let at = said.iter().zip(is).position(|(said, is)| said != is)?;
    Some(format!("parameter {} is {} here and {} in PROC", at + 1, said[at].shown(), is[at].shown()))
}

/// The EXTERN lines that ran.
#[derive(Debug, Default)]
pub(super) struct Externs(Vec<Extern>);

impl Externs {
    /// EXTERN in the program that runs.
    pub fn declare(&mut self, core: &mut Core<'_>, name: Symbol, block: &Block) -> Outcome {
        levels::program(&mut core.levels).declares = true;
        let (unit, loc) = (levels::unit(&core.levels), core.loc(block.span));
        let parameters: Vec<Parameter> = block.variables.iter().map(Parameter::of).collect();
        let Some(first) = self.0.iter().find(|known| known.unit == unit && known.name == name) else {
            self.0.push(Extern { unit, name, parameters, loc, told: false });
            return Ok(());
        };
        if first.parameters == parameters {
            return Ok(());
        }
        let found = codes::S2021::is_declared_second_time_with_other_parameters(&core.symbols.name(name));
        let found = found.at(loc).also(first.loc, Label::FirstDeclaration);
        core.report(found.help("delete one of the two lines"));
        Err(Reported)
    }

    /// Holds the EXTERN line of the calling program against the PROC of `name`, which runs now.
    pub fn check(&mut self, core: &Core<'_>, name: &str, block: &Block) {
        let at = core.levels.iter().rposition(|level| matches!(level.frame.kind, FrameKind::Program { .. }));
        let Some(caller) = at.and_then(|at| at.checked_sub(1)).and_then(|at| core.levels.get(at)) else { return };
        let symbols = &core.symbols;
        let known = self.0.iter_mut().find(|known| known.unit == caller.frame.unit && symbols.name(known.name) == name);
        let Some(known) = known.filter(|known| !known.told) else { return };
        let is: Vec<Parameter> = block.variables.iter().map(Parameter::of).collect();
        let Some(what) = difference(&known.parameters, &is) else { return };
        known.told = true;
        let found = codes::S2021::extern_does_not_fit_program(&name, &what).at(known.loc);
        let found = found.also(core.loc(block.span), Label::ItsProc);
        core.report(found.help("write the types of PROC into the EXTERN line"));
    }
}
