//! Where axes stand as the configuration says it: behind a tool change, and behind moves in machine coordinates.

use std::fmt::Display;

use crate::diag::{Answer, Diagnostic, Fault, Help, Label, codes};
use crate::ir::Pos;
use crate::ir::contour::CtxRef;
use crate::ir::frame::Frame;
use crate::machine::settings::Datums;
use crate::machine::{Axis, AxisSet};
use crate::sema::common::hidden::{By, because};
use crate::sema::common::position::{Missing, Position};
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
pub fn move_beside(position: &Position, left: AxisSet, named: AxisSet, frame: &Frame, here: Loc) -> Option<Diagnostic> {
    let first = left.iter().next()?;
    let missing = if frame.is_shift() { left } else { left.union(AxisSet::MAIN) }.without(named);
    if missing.is_empty() {
        return None;
    }
    let letters: Vec<String> = missing.iter().map(|axis| axis.letter().to_string()).collect();
    let (letters, stand) = (letters.join(" and "), if missing.len() > 1 { "stand" } else { "stands" });
    let why = because(position.hidden(first), here);
    Some(codes::P2001::this_block_moves_without(&letters, &stand, &why).at(here))
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
    /// What else to do, as a help goes on.
    fn or_give(&self, axis: Axis) -> Option<Help> {
        match self {
            Lack::Datum(name) => Some(Answer::datum(name).help(codes::P2001::or_say_where_datum_lies(name))),
            Lack::Length(Some(number)) => {
                let length = codes::P2001::or_give_length_of_tool(&axis.letter(), number);
                Some(Answer::tool(number, "length").help(length))
            }
            Lack::Length(None) | Lack::Nothing => None,
        }
    }
}

impl<L: Language> Core<'_, L> {
    /// Where an axis stands; an error where nothing says it, none where an error hides it.
    #[inline]
    pub fn place_of(
        &self,
        place: impl Into<Where>,
        asked: Unknown<'_>,
        fault: impl FnOnce(&dyn Display, &dyn Display) -> Fault,
    ) -> Outcome<f64> {
        match asked.position.require(asked.axis) {
            Ok(at) => Ok(at),
            Err(Missing::Lost) => Err(Reported),
            Err(Missing::Unknown) => self.position_unknown(place, asked, fault),
        }
    }

    /// Axes stand at these places of the work offset: what is known of them in the frame in force.
    pub fn stand(&mut self, position: &mut Position, places: &Pos, ctx: &CtxRef) -> Pos {
        let known = position.stand_in_offset(places, &ctx.frame);
        self.stands_at(&known, ctx);
        known
    }

    /// A tool change is over: axes stand where the configuration says, unless it says that in machine coordinates, which nothing
    /// relates to places of the tip here.
    pub fn stand_after_change(&mut self, position: &mut Position, ctx: &CtxRef) -> Pos {
        match position.after_change() {
            (_, true) => Pos::UNKNOWN,
            (places, false) => self.stand(position, &places, ctx),
        }
    }

    /// An error about an axis whose position is not known: `fault` makes it of the axis and why. `lack` is what a machine coordinate
    /// of the axis lacks.
    pub fn position_unknown<T>(
        &self,
        place: impl Into<Where>,
        unknown: Unknown<'_>,
        fault: impl FnOnce(&dyn Display, &dyn Display) -> Fault,
    ) -> Outcome<T> {
        let Unknown { position, axis, lack, otherwise } = unknown;
        let loc = self.loc(place);
        let hidden = position.hidden(axis);
        let why = because(hidden, loc);
        let why = if why.is_empty() { otherwise } else { &why };
        let counts = match hidden {
            Some((By::Machine(_), _)) => true,
            Some((By::ToolChange, _)) => position.after_change().1 && position.after_change().0.get(axis).is_some(),
            Some((By::Edge | By::Call | By::Probe | By::Tilt | By::Table, _)) | None => false,
        };
        let mut fault = fault(&axis.letter(), &why);
        if let Some(more) = if counts { lack().or_give(axis) } else { Some(position.or_say(axis)) } {
            fault = fault.or(more);
        }
        let mut found = fault.at(loc);
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

fn label(by: By) -> Label {
    match by {
        By::ToolChange => Label::ToolChanges,
        By::Edge => Label::EdgeChanges,
        By::Call => Label::CallMoves,
        By::Probe => Label::ProbeMoves,
        By::Tilt => Label::PlaneTurns,
        By::Table => Label::CurveTableLeftOut,
        By::Machine(_) => Label::MachineCoordinate,
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
