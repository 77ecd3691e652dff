//! Where axes stand as the configuration says it: behind a tool change, and behind moves in machine coordinates.

use crate::diag::{Answer, Code, Diagnostic, Help, Raised};
use crate::ir::Pos;
use crate::ir::frame::Frame;
use crate::machine::settings::Datums;
use crate::machine::{Axis, AxisSet};
use crate::sema::common::hidden::{By, because};
use crate::sema::common::position::Position;
use crate::sema::{Outcome, Reported};
use crate::text::Loc;

use super::Language;
use super::core::Core;
use super::report::Where;

/// The name under `[datums]` of the datum that is active where the program selects none.
pub const ACTIVE: &str = "active";
/// The name of the basic frame of a SINUMERIK.
pub const BASIC: &str = "basic";

/// What is wrong with a move that names only `named` while what is left out moved the axes `left`: the control moves at another place.
/// In a frame that turns or mirrors, an axis of the program moves several of the machine.
pub fn move_beside(
    code: &'static Code,
    position: &Position,
    left: AxisSet,
    named: AxisSet,
    frame: &Frame,
    here: Loc,
) -> Option<Diagnostic> {
    let first = left.iter().next()?;
    let missing = if frame.is_shift() { left } else { left.union(AxisSet::MAIN) }.without(named);
    if missing.is_empty() {
        return None;
    }
    let letters: Vec<String> = missing.iter().map(|axis| axis.letter().to_string()).collect();
    let (letters, stand) = (letters.join(" and "), if missing.len() > 1 { "stand" } else { "stands" });
    let why = because(position.hidden(first), here);
    let message = format!("this block moves without {letters}, and where {letters} {stand} is not known{why}");
    let help = format!("program {letters} in absolute coordinates before this block, or in it");
    Some(Diagnostic::new(code, here, message).help(help))
}

/// Machine coordinate of the zero of nested systems, by their names under `[datums]`; the name of one that is not known.
///
/// # Errors
/// The first name that says nothing of the axis.
pub fn zero<'n>(datums: &Datums, names: &[&'n str], axis: Axis) -> Result<f64, &'n str> {
    names.iter().try_fold(0.0, |sum, name| {
        let values =
            if *name == BASIC { datums.basic.as_ref() } else { datums.offsets.get(&name.to_ascii_uppercase()) };
        values.and_then(|values| values.get(&axis)).map(|value| sum + value).ok_or(*name)
    })
}

/// What a machine coordinate lacks to be a place of the work offset.
#[derive(Debug, Clone, PartialEq)]
pub enum Lack {
    /// The zero of a datum, by its name.
    Datum(String),
    /// The length of a tool, by its number.
    Length(Option<u32>),
    /// Nothing that can be said.
    Nothing,
}

impl Lack {
    /// What to do, behind `usual`.
    fn help(&self, axis: Axis, usual: &str) -> Help {
        let letter = axis.letter();
        match self {
            Lack::Datum(name) => Answer::datum(name).help(format!(
                "{usual}; or say where the datum lies, in machine coordinates: `[datums] {name} = {{ X = …, Y = …, Z = … }}`"
            )),
            Lack::Length(Some(number)) => Answer::tool(number, "length").help(format!(
                "{usual}; or give the length of the tool, which {letter} of the machine counts without: `[tools.{number}] length = …`"
            )),
            Lack::Length(None) | Lack::Nothing => usual.into(),
        }
    }
}

impl<L: Language> Core<'_, L> {
    /// An error about an axis whose position is not known: `message` ends in front of why. `lack` is what a machine coordinate
    /// of the axis lacks.
    pub fn position_unknown<T>(
        &self,
        code: impl Into<Raised>,
        place: impl Into<Where>,
        message: String,
        usual: &str,
        unknown: Unknown<'_>,
    ) -> Outcome<T> {
        let Unknown { position, axis, lack, otherwise } = unknown;
        let loc = self.loc(place);
        let hidden = position.hidden(axis);
        let why = because(hidden, loc);
        let why = if why.is_empty() { otherwise } else { &why };
        let counts = match hidden {
            Some((By::Machine(_), _)) => true,
            Some((By::ToolChange, _)) => position.after_change().1 && position.after_change().0.get(axis).is_some(),
            Some((By::Edge | By::Call | By::Probe | By::Table, _)) | None => false,
        };
        let help = if counts { lack().help(axis, usual) } else { position.help(axis, usual) };
        let mut found = Diagnostic::new(code, loc, format!("{message}{why}")).help(help);
        if let Some((by, at)) = hidden {
            found = found.also(at, label(by));
        }
        self.report(found);
        Err(Reported)
    }
}

/// An axis whose position is asked for and not known.
pub struct Unknown<'a> {
    pub position: &'a Position,
    pub axis: Axis,
    /// What a machine coordinate of the axis lacks.
    pub lack: &'a dyn Fn() -> Lack,
    /// The end of the message where nothing is known to have hidden it.
    pub otherwise: &'a str,
}

fn label(by: By) -> &'static str {
    match by {
        By::ToolChange => "the tool changes here, and its tip stands elsewhere",
        By::Edge => "another cutting edge is selected here, and its tip stands elsewhere",
        By::Call => "what is called here moves the axis, as `[programs]` says",
        By::Probe => "a probe moves the axis here, and what it does is left out",
        By::Table => "a curve table names the axis here, and is left out",
        By::Machine(_) => "the axis goes to a machine coordinate here",
    }
}

/// Places of the work offset out of machine coordinates, as far as `place` knows the way.
pub fn out_of_machine(machine: &Pos, mut place: impl FnMut(Axis, f64) -> Option<f64>) -> Pos {
    let mut known = Pos::UNKNOWN;
    for (axis, value) in machine.iter() {
        if let Some(value) = place(axis, value) {
            known.set(axis, value);
        }
    }
    known
}
