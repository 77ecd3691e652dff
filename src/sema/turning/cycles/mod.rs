//! The cycles of the turning dialects: one file a family, with its rows and the plans that make the arguments of `ir::cycle`.
//!
//! A plan reads the words by name and what holds where the cycle is called; it reports nothing and moves nothing (`cycle_call.rs` does).
//! Sources: MANUALplus 4110 pilot (4110P) and manual (4110), CNC PILOT 4290 DIN PLUS (4290-71), MANUALplus 620.

mod contour_finishing;
mod drilling;
mod finishing;
mod lathe;
mod nose;
mod recess_turning;
mod roughing;
mod simple_recess;
mod simple_thread;
mod thread_line;
mod threads;
mod undercut;
mod word;

use crate::diag::Fault;
use crate::geo::Point2;
use crate::ir::contour::Path;
use crate::ir::cycle::Cycle;
use crate::machine::Settings;
use crate::sema::cycle::call::Made;
use crate::sema::cycle::row::{Kind, Name, Parameter, Rule, Signature, Status, angle, feed, length, number, words};

pub(super) use lathe::{CycleCall, Lathe};

use super::readings::Question;
use super::words::{Letters, Words, letters};

/// A cycle that is compiled.
#[derive(Debug)]
pub(super) struct Row {
    pub number: u16,
    pub signature: Signature,
    pub contour: Contour,
    pub unbuilt: &'static [Unbuilt],
    pub requires: &'static [Need],
    pub plan: fn(&CycleCall<'_>) -> Planned,
}

/// What a cycle makes.
pub(super) type Planned = Made<Vec<Step>>;

/// A part of what a cycle makes.
#[derive(Debug)]
pub(super) enum Step {
    Cycle(Box<Cycle>),
    /// To a point (Z, X).
    Move(Point2, Path),
}

/// Where a cycle has its contour from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Contour {
    /// It has none.
    None,
    /// From the blocks up to G80.
    Follows,
    /// From NS, NE or ID, else from the blocks up to G80; V and D leave parts of it out.
    Referenced,
    /// From NS, NE or ID, else from the blocks up to G80; a line to X, Z needs none.
    LineOrReferenced,
}

/// What has to hold where a cycle is called, besides that it is known where the tool stands.
#[derive(Debug, Clone, Copy)]
pub(super) enum Need {
    Feed,
    /// The spindle turns.
    Spindle,
    /// S counts in turns, not as a cutting speed.
    Turns,
    /// A reading of ours, of which the first call says a word.
    Reading(Question),
    /// The configuration does not refuse it.
    Wanted(fn(&Settings) -> Option<Fault>),
    NotDinPlus(fn() -> Fault),
    /// The control is no MANUALplus 4110.
    LaterControl(fn() -> Fault),
}

/// Values of a word that are not compiled.
#[derive(Debug)]
pub(super) struct Unbuilt {
    pub word: Name,
    values: Values,
    pub why: fn(&Refused) -> Fault,
}

#[derive(Debug, Clone, Copy)]
enum Values {
    All,
    NotZero,
    One(f64),
}

/// A word that is refused.
#[derive(Debug, Clone, Copy)]
pub(super) struct Refused {
    pub cycle: u16,
    pub word: Name,
    pub value: f64,
}

impl Unbuilt {
    /// Whatever its value is.
    const fn all(word: Name, why: fn(&Refused) -> Fault) -> Unbuilt {
        Unbuilt { word, values: Values::All, why }
    }

    /// 0 is as if it were not there.
    const fn not_zero(word: Name, why: fn(&Refused) -> Fault) -> Unbuilt {
        Unbuilt { word, values: Values::NotZero, why }
    }

    const fn one(word: Name, value: f64, why: fn(&Refused) -> Fault) -> Unbuilt {
        Unbuilt { word, values: Values::One(value), why }
    }

    /// Is this value not compiled?
    pub fn is(&self, value: f64) -> bool {
        match self.values {
            Values::All => true,
            Values::NotZero => value != 0.0,
            Values::One(one) => value == one,
        }
    }
}

impl Row {
    const fn new(
        number: u16,
        name: &'static str,
        what: &'static str,
        source: &'static str,
        parameters: &'static [Parameter],
        plan: fn(&CycleCall<'_>) -> Planned,
    ) -> Row {
        let signature = Signature { name, what, status: Status::Built, source, parameters };
        Row { number, signature, contour: Contour::None, unbuilt: &[], requires: &[], plan }
    }

    const fn contour(self, contour: Contour) -> Row {
        Row { contour, ..self }
    }

    const fn unbuilt(self, unbuilt: &'static [Unbuilt]) -> Row {
        Row { unbuilt, ..self }
    }

    const fn requires(self, requires: &'static [Need]) -> Row {
        Row { requires, ..self }
    }

    /// Does an oversize of G57 or G58 count once, for this cycle?
    pub fn uses_oversize(&self) -> bool {
        matches!(self.contour, Contour::Follows | Contour::Referenced)
    }

    /// Its single letters.
    pub const fn letters(&self) -> Letters {
        let mut found = 0;
        let mut at = 0;
        while at < self.signature.parameters.len() {
            if let Name::Word(name) = self.signature.parameters[at].name
                && name.len() == 1
            {
                found |= letters(name);
            }
            at += 1;
        }
        found
    }

    /// Does it take this longer address with a number?
    pub fn takes(&self, long: &str) -> bool {
        let mut numbers = self.signature.parameters.iter().filter(|known| !matches!(known.kind, Kind::Text));
        numbers.any(|known| matches!(known.name, Name::Word(name) if name.len() > 1 && name == long))
    }

    /// Do blocks of a contour follow?
    pub fn waits(&self, w: &Words, named: bool) -> bool {
        let referenced = w.long("NS").is_some() || named;
        match self.contour {
            Contour::None => false,
            Contour::Follows => true,
            Contour::Referenced => !referenced,
            Contour::LineOrReferenced => !w.has(b'X') && !w.has(b'Z') && !referenced,
        }
    }

    /// ID names its contour.
    pub fn takes_name(&self) -> bool {
        matches!(self.contour, Contour::Referenced | Contour::LineOrReferenced)
    }
}

/// The rows of each family.
const FAMILIES: [&[Row]; 9] = [
    contour_finishing::ROWS,
    drilling::ROWS,
    finishing::ROWS,
    recess_turning::ROWS,
    roughing::ROWS,
    simple_recess::ROWS,
    simple_thread::ROWS,
    threads::ROWS,
    undercut::ROWS,
];

/// What all of them take, by number.
pub fn signatures() -> Vec<&'static Signature> {
    let mut rows: Vec<&Row> = FAMILIES.iter().copied().flatten().collect();
    rows.sort_by_key(|row| row.number);
    rows.into_iter().map(|row| &row.signature).collect()
}

/// The cycle of this number; there has to be one.
pub(super) const fn of(number: u16) -> &'static Row {
    let (mut family, mut at) = (0, 0);
    loop {
        let rows = FAMILIES[family];
        if at == rows.len() {
            (family, at) = (family + 1, 0);
        } else if rows[at].number == number {
            return &rows[at];
        } else {
            at += 1;
        }
    }
}

/// Most cuts of a thread at its full depth.
const MOST_AIR_CUTS: i32 = 99;

/// A plan of one cycle.
fn one(cycle: Cycle) -> Planned {
    Ok(vec![Step::Cycle(Box::new(cycle))])
}

const CORNER_X: Parameter = length("X", "corner or end point, diameter");
const CORNER_Z: Parameter = length("Z", "corner or end point");
const NS: Parameter = number("NS", "block number of the first element of the contour");
const NE: Parameter = number("NE", "block number of the last element of the contour").default("NS alone");
const ID: Parameter = words("ID", "name of the contour");
const XA: Parameter = length("XA", "corner of the blank, diameter");
const ZA: Parameter = length("ZA", "corner of the blank along Z");
const LIMIT_X: Parameter = length("X", "limit of the cut, diameter").default("none");
const LIMIT_Z: Parameter = length("Z", "limit of the cut").default("none");
const INFEED: Parameter = length("P", "greatest infeed").needed().rule(Rule::Above(0));
const OVERSIZE_X: Parameter = length("I", "oversize along X, diameter").unsigned().default("that of G57 or G58");
const OVERSIZE_Z: Parameter = length("K", "oversize along Z").unsigned().default("that of G57 or G58");
const APPROACH: Parameter = angle("A", "angle of the approach");
const DEPARTURE: Parameter = angle("W", "angle of the departure");
const ENDS: Parameter = number("V", "chamfer or rounding at 0 both ends, 1 the first, 2 the last, 3 none")
    .rule(Rule::OneOf(0, 3))
    .default("0");
const LEFT_OUT: Parameter = number("D", "elements that are left out").default("none");
const SMOOTHING: Parameter =
    number("H", "0 along the contour after each cut, 1 after the last one, 2 not at all").rule(Rule::OneOf(0, 2));
const DESCENDING: Parameter = feed("E", "feed of descending elements; 0 leaves them out").default("reduced");
const END: Parameter = number("Q", "0 back to the start, 1 in front of the contour, 2 lifted").rule(Rule::OneOf(0, 2));

#[cfg(test)]
mod tests {
    use super::*;

    /// A name of the code that no row has would read as a word that is never given.
    #[test]
    fn every_name_of_the_code_is_in_a_row() {
        for name in word::ALL {
            assert!(signatures().iter().any(|row| row.place(*name).is_some()), "{name}");
        }
    }

    #[test]
    fn what_is_not_built_is_a_word_of_its_row() {
        for row in FAMILIES.iter().copied().flatten() {
            for unbuilt in row.unbuilt {
                assert!(row.signature.place(unbuilt.word).is_some(), "{}: {}", row.signature.name, unbuilt.word);
            }
        }
    }
}
