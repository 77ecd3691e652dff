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
use crate::sema::cycle::row::{Signature, Status};

use super::super::{Outcome, Run};
use super::arguments::Arguments;
use super::call::CycleCall;

pub(in super::super) use named::instead;

/// A cycle: what a call gives, and what is done with it.
#[derive(Debug)]
pub(in super::super) struct Cycle {
    pub signature: Signature,
    pub work: Work,
}

/// What is done with a call.
#[derive(Debug)]
pub(in super::super) enum Work {
    /// Drills a hole, also behind MCALL.
    Hole(Hole),
    /// Makes moves.
    Moves(fn(&mut CycleCall<'_, '_>) -> Outcome),
    /// Takes or names contours, all of which are read; a cycle of this name that is a program of the user goes before it.
    Contour(fn(&mut Run<'_>, &Arguments) -> Outcome),
    /// Takes contours and makes moves along them.
    Along(fn(&mut Run<'_>, &Arguments) -> Outcome),
    /// Takes contours, and is refused with what was read, because its tracks are not published.
    Unpublished(Unpublished),
    /// Refused by its name.
    Nothing,
}

/// A drilling cycle.
#[derive(Debug)]
pub(in super::super) struct Hole {
    pub feed: fn(&mut CycleCall<'_, '_>) -> Outcome<Feed>,
    pub method: fn(&mut CycleCall<'_, '_>, &Levels, Feed) -> Outcome<Method>,
    /// A depth by the tens of `_GMODE` is that of the diameter of a centring, not that of the shank.
    pub centring: bool,
    /// Behind MCALL it drills at the feed that is modal there.
    pub modal_feed: bool,
}

/// A cycle that is read and checked only.
#[derive(Debug)]
pub(in super::super) struct Unpublished {
    pub contour: Source,
    /// A turning cycle: in G18.
    pub turned: bool,
    /// What helps beside the general advice.
    pub advice: Option<fn(&Arguments) -> Option<String>>,
}

/// Where a cycle has its contour from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) enum Source {
    /// It has none.
    None,
    /// From its first argument.
    Argument,
    /// From CYCLE62: the turned part, or blank and part.
    Turned,
    /// From CYCLE62: closed contours of pockets, islands and spigots.
    Milled,
}

impl Work {
    /// Are its arguments checked by their rules alone?
    pub fn is_read_only(&self) -> bool {
        matches!(self, Work::Contour(_) | Work::Unpublished(_))
    }
}

impl Cycle {
    /// Does it only measure? What it corrects is data of the machine.
    pub fn measures(&self) -> bool {
        self.signature.what == named::MEASURING
    }

    pub fn is_built(&self) -> bool {
        matches!(self.work, Work::Hole(_) | Work::Moves(_) | Work::Along(_))
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
    use crate::sema::sinumerik::cycles::arguments;

    /// A name of the code that no row has would read as an argument that is never given.
    #[test]
    fn every_name_of_the_code_is_in_a_row() {
        for key in arguments::ALL {
            assert!(rows().any(|cycle| cycle.place(*key).is_some()), "{key:?}");
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
