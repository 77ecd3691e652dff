//! The cycles of the control: one row each, one file a family.

mod contours;
mod drilling;
mod grooves;
mod layers;
mod milled;
mod milling;
mod named;
mod patterns;
mod pockets;
mod threads;
mod undercuts;

use crate::ir::Feed;
use crate::ir::cycle::drilling::{Levels, Method};
use crate::sema::cycle::call::Made;
use crate::sema::cycle::row::{Signature, Status};

use super::super::named_contour::CalledContour;
use super::call::{Acts, CycleCall};

pub(in super::super) use named::instead;

/// A cycle: what a call gives, what it needs of the channel, and what is done with it.
#[derive(Debug)]
pub(in super::super) struct Cycle {
    pub signature: Signature,
    /// Asked in this order, in front of the plan.
    pub needs: &'static [Need],
    pub work: Work,
}

/// What a call needs besides its arguments.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) enum Need {
    /// Turning technology.
    Lathe,
    /// G18.
    TurningPlane,
    /// MD 20100 names an axis of the plane.
    DiameterAxis,
    /// `_DMODE` names no other plane than the active one.
    ActivePlane,
    /// OFFN is 0.
    NoNormalOffset,
    UnscaledFrame,
    /// The frame only shifts.
    ShiftFrame,
    /// The tool stands in a known place of the turning plane.
    KnownPlace,
    /// No constant cutting speed.
    FixedSpeed,
    /// The spindle that this counts with is the main one.
    MainSpindle(&'static str),
    TurningSpindle,
    /// MCALL with what a pattern runs.
    ModalCall,
    /// Lengths in the plane are no diameters.
    PlainLengths,
}

/// Makes what is carried out of a call.
pub(in super::super) type Plan = fn(&CycleCall<'_>) -> Made<Acts>;

/// What is done with a call.
#[derive(Debug)]
pub(in super::super) enum Work {
    /// Drills a hole, also behind MCALL.
    Hole(Hole),
    Plan(Plan),
    /// Takes contours, and plans along them.
    Along(Source, fn(&CycleCall<'_>, &[CalledContour]) -> Made<Acts>),
    /// Names a contour for what follows; a cycle of this name that is a program of the user goes before it.
    NamesContour,
    /// Takes contours, and is refused with what was read, because its tracks are not published.
    Unpublished(Source),
    /// Refused by its name.
    Nothing,
}

/// A drilling cycle.
#[derive(Debug)]
pub(in super::super) struct Hole {
    pub feed: fn(&CycleCall<'_>) -> Made<Feed>,
    pub method: fn(&CycleCall<'_>, &Levels, Feed) -> Made<Method>,
    /// A depth by the tens of `_GMODE` is that of the diameter of a centring, not that of the shank.
    pub centring: bool,
    /// Behind MCALL it drills at the feed that is modal there.
    pub modal_feed: bool,
}

/// Where a cycle has its contour from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) enum Source {
    /// A turned part, from its first argument.
    Argument,
    /// One to go along, named by it or called in front of it.
    Single,
    /// From CYCLE62: the turned part, or blank and part.
    Turned,
    /// From CYCLE62: closed contours of pockets, islands and spigots.
    Milled,
}

impl Cycle {
    /// Does it only measure? What it corrects is data of the machine.
    pub fn measures(&self) -> bool {
        self.signature.what == named::MEASURING
    }

    pub fn is_built(&self) -> bool {
        matches!(self.work, Work::Hole(_) | Work::Plan(_) | Work::Along(..))
    }
}

const FAMILIES: &[&[Cycle]] = &[
    drilling::ROWS,
    patterns::ROWS,
    threads::ROWS,
    undercuts::ROWS,
    contours::ROWS,
    pockets::ROWS,
    layers::ROWS,
    milling::ROWS,
    grooves::ROWS,
    named::ROWS,
];

/// All cycles of the control, family by family.
pub(in super::super) fn rows() -> impl Iterator<Item = &'static Cycle> {
    FAMILIES.iter().copied().flatten()
}

/// What all of them take.
pub fn signatures() -> Vec<&'static Signature> {
    rows().map(|cycle| &cycle.signature).collect()
}

/// The cycle of this name.
pub(in super::super) fn find(name: &str) -> Option<&'static Cycle> {
    rows().find(|cycle| cycle.signature.name == name)
}

/// The status of a cycle that is compiled.
const BUILT: Status = Status::Built;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sema::cycle::row::Name;
    use crate::sema::sinumerik::cycles::names;

    /// A name of the code that no row has would read as an argument that is never given.
    #[test]
    fn every_name_of_the_code_is_in_a_row() {
        for name in names::ALL {
            assert!(rows().any(|cycle| cycle.signature.place(*name).is_some()), "{name:?}");
        }
    }

    #[test]
    fn names_are_unique() {
        let mut cycles: Vec<&str> = rows().map(|cycle| cycle.signature.name).collect();
        cycles.sort_unstable();
        assert!(cycles.windows(2).all(|pair| pair[0] != pair[1]), "{cycles:?}");
        for cycle in rows() {
            let mut names: Vec<&str> = Vec::new();
            for parameter in cycle.signature.parameters {
                let Name::Word(name) = parameter.name else { panic!("{}: {}", cycle.signature.name, parameter.name) };
                let plain = name.strip_prefix('_').unwrap_or(name);
                assert!(!names.contains(&plain), "{} has {name} twice", cycle.signature.name);
                names.push(plain);
            }
        }
    }
}
