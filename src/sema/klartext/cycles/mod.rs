//! The cycles of CYCL DEF: one row each, one file a family.

mod bores;
pub(super) mod call;
mod contour_pockets;
mod contour_trains;
pub(super) mod contours;
pub(super) mod data;
mod deep_holes;
mod defined;
mod drilling;
pub(super) mod faces;
mod finishing;
pub(super) mod holes;
pub(super) mod machining;
mod milling;
mod named;
mod old_pockets;
pub(super) mod patterns;
mod pockets;
mod ruled;
mod slots;
mod studs;
mod tapping_in_steps;
mod thread_milling;
mod threads;
pub(super) mod transformations;

use crate::diag::codes::told;
use crate::geo::Point2;
use crate::ir::Feed;
use crate::ir::cycle::Cycle;
use crate::ir::cycle::drilling::Method;
use crate::lexer::klartext::{QKind, QRef};
use crate::sema::cycle::call::Made;
use crate::sema::cycle::row::{Kind, Name, Parameter, Rule, Signature, Status};

use super::cycle_definition::What;

use call::CycleCall;
use data::Roughed;
pub(super) use defined::DefinedCycle;

/// A cycle: what its definition gives, and what it does.
#[derive(Debug)]
pub(super) struct Row {
    /// The first and the last number of cycles that are known by one name.
    pub numbers: (u32, u32),
    pub nature: CycleKind,
    /// What has to hold where it is called, in the order in which it is asked.
    pub requires: &'static [Requires],
    pub signature: Signature,
    /// What to write in place of a word that the cycle does not take.
    pub form: &'static str,
}

/// What a cycle is.
#[derive(Debug, Clone, Copy)]
pub(super) enum CycleKind {
    DatumShift,
    Mirror,
    Dwell,
    Rotation,
    Scaling,
    ProgramCall,
    Orientation,
    Tilt,
    AxisScaling,
    Tolerance,
    Preset,
    /// Sets data that other cycles use.
    Setting(Setting),
    /// The same, for cycles that are refused.
    Data,
    /// Would act where it is defined.
    Acting,
    /// Drills when called.
    Drilling(&'static Drilling),
    /// Mills when called.
    Milling(Plan),
    /// Would run when called.
    Machining,
    /// Runs the machining cycle at once, at many places: the places, where the pattern is compiled.
    Pattern(Option<Places>),
    Unknown,
}

/// What a cycle needs where it is called.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Requires {
    NoCompensation,
    /// The spindle turns.
    Turning,
    /// The spindle has a speed; the cycle may start it itself.
    Speed,
    /// The tool that was called is in the spindle.
    ToolChange,
    /// A tap has one pitch, whatever a scaling makes of its depth.
    NoScaling,
    /// The tool has the size that it has: a frame may shift, turn and mirror in the plane.
    CutterUnscaled,
    /// Contours of cycle 14.
    Contours,
    /// Data of cycle 20.
    PocketData,
}

/// What the definition of a cycle is kept as.
#[derive(Debug, Clone, Copy)]
pub(super) enum Setting {
    /// Cycle 14.
    Contours,
    /// Cycle 20.
    Pocket,
    /// Cycle 270.
    Train,
}

/// What a call does.
#[derive(Debug, Default)]
pub(super) struct Planned {
    /// Nothing where there is nothing to do.
    pub cycle: Option<Cycle>,
    /// Of the budget.
    pub steps: u64,
    /// What cycle 22 clears.
    pub roughed: Option<Box<Roughed>>,
}

impl From<Cycle> for Planned {
    fn from(cycle: Cycle) -> Planned {
        Planned { cycle: Some(cycle), ..Planned::default() }
    }
}

/// Makes the cycle where it is called.
pub(super) type Plan = fn(&CycleCall<'_>) -> Made<Planned>;

/// Makes the places of a pattern.
pub(super) type Places = fn(&CycleCall<'_>) -> Made<Vec<Point2>>;

/// A drilling cycle.
#[derive(Debug)]
pub(super) struct Drilling {
    pub method: fn(&CycleCall<'_>, Cut) -> Made<Method>,
    /// What gives the feed; `None` where a pitch does.
    pub feed: Option<Name>,
    /// What gives the dwell at the depth.
    pub dwell: Option<Name>,
    pub requires: &'static [Requires],
}

/// Feed, and dwell at the depth in seconds.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cut {
    pub feed: Feed,
    pub dwell: f64,
}

impl CycleKind {
    /// Does it act at once, so that what it says would be lost if it were not taken?
    pub fn acts(self) -> bool {
        !self.is_machining()
            && !matches!(
                self,
                CycleKind::Pattern(_)
                    | CycleKind::Setting(_)
                    | CycleKind::Data
                    | CycleKind::Acting
                    | CycleKind::Unknown
            )
    }

    /// Does it run when it is called?
    pub fn is_machining(self) -> bool {
        self.runs() || matches!(self, CycleKind::Machining)
    }

    /// Is it compiled where it is called?
    pub fn runs(self) -> bool {
        matches!(self, CycleKind::Drilling(_) | CycleKind::Milling(_))
    }

    pub fn drilling(self) -> Option<&'static Drilling> {
        match self {
            CycleKind::Drilling(drilling) => Some(drilling),
            _ => None,
        }
    }
}

impl Row {
    /// Do its values stand in parts, `1.1`, `1.2`, …, which have to be there?
    pub fn has_parts(&self, number: u32) -> bool {
        match self.nature {
            CycleKind::Preset | CycleKind::Pattern(_) | CycleKind::Data | CycleKind::Acting | CycleKind::Unknown => {
                false
            }
            CycleKind::Drilling(_) | CycleKind::Milling(_) | CycleKind::Setting(_) | CycleKind::Machining => {
                number < 20
            }
            _ => true,
        }
    }

    /// Does the part of an old cycle take such a word?
    pub fn takes_in_part(&self, part: u32, what: What) -> bool {
        self.signature.parameters.iter().any(|known| match (known.name, what) {
            (Name::Part(of) | Name::In(of, "RADIUS"), What::Value) => of == part,
            (Name::In(of, "F"), What::Feed) | (Name::In(of, "DR"), What::Turn) => of == part,
            (Name::In(of, word), What::Along(_)) => of == part && !matches!(word, "F" | "DR" | "RADIUS"),
            _ => false,
        })
    }

    /// Does the tool axis of a drill or a tap carry it out alone?
    pub fn drills(&self) -> bool {
        matches!(self.nature, CycleKind::Drilling(_))
    }

    /// The parameters that a definition has to set.
    pub fn needed(&self) -> impl Iterator<Item = Name> {
        self.signature.parameters.iter().filter(|known| known.needed).map(|known| known.name)
    }

    /// May a definition of the cycle `number` set this parameter?
    pub fn takes(&self, number: u32, q: QRef) -> bool {
        if q.kind != QKind::Q {
            return false;
        }
        if self.signature.parameters.iter().any(|known| matches!(known.name, Name::Q(_))) {
            return self.signature.parameters.iter().any(|known| known.name == Name::Q(q.number));
        }
        matches!(q.number, 200..=1199) || (matches!(number, 20..=39) && q.number <= 21)
    }

    /// How the manuals call it.
    pub fn called(&self) -> &'static str {
        self.signature.what
    }
}

const FAMILIES: &[&[Row]] = &[
    drilling::ROWS,
    tapping_in_steps::ROWS,
    old_pockets::ROWS,
    pockets::ROWS,
    slots::ROWS,
    finishing::ROWS,
    studs::ROWS,
    faces::ROWS,
    bores::ROWS,
    threads::ROWS,
    contours::ROWS,
    patterns::ROWS,
    transformations::ROWS,
    named::ROWS,
];

/// All cycles that are known, family by family.
pub(super) fn rows() -> impl Iterator<Item = &'static Row> {
    FAMILIES.iter().copied().flatten()
}

/// What all of them take.
pub fn signatures() -> Vec<&'static Signature> {
    rows().map(|row| &row.signature).collect()
}

/// The cycle of this number.
pub(super) fn find(number: u32) -> &'static Row {
    rows().find(|row| (row.numbers.0..=row.numbers.1).contains(&number)).unwrap_or(&UNKNOWN)
}

const UNKNOWN: Row = Row {
    numbers: (0, 0),
    nature: CycleKind::Unknown,
    requires: &[],
    signature: Signature { name: "", what: "", status: Status::Refused { code: "P9010" }, source: "", parameters: &[] },
    form: REMOVE,
};

const REMOVE: &str = "remove the word";

const fn q(name: Name, kind: Kind, what: &'static str) -> Parameter {
    Parameter::new(name, kind, told(what))
}

const ABOVE_0: Rule = Rule::Above(0);

/// Parameters that many cycles have.
pub(super) const CLEARANCE: Name = Name::Q(200);
pub(super) const DEPTH: Name = Name::Q(201);
pub(super) const SURFACE: Name = Name::Q(203);
pub(super) const SECOND_CLEARANCE: Name = Name::Q(204);

/// What is read before the depth 0 says that there is nothing to do.
const BEFORE_DEPTH: &[Name] = &[CLEARANCE, DEPTH, SURFACE, SECOND_CLEARANCE, drilling::BY_DIAMETER, threads::STEPS];

/// What some calls of a cycle take that does not need it: looked at where they do.
const OF_SOME_CALLS: &[Name] = &[drilling::DIAMETER, pockets::CENTER.0, pockets::CENTER.1];

/// What is read before it shows that there is nothing to finish.
const BEFORE_FINISHING: &[Name] = &[
    CLEARANCE,
    DEPTH,
    SURFACE,
    SECOND_CLEARANCE,
    drilling::PLUNGE,
    milling::FINISHING_INFEED,
    milling::SIDE_ALLOWANCE,
    milling::FLOOR_ALLOWANCE,
    milling::OPERATION,
    milling::FEED_REFERENCE,
];

const SET_UP: Parameter = q(CLEARANCE, Kind::Length, "set-up clearance above the surface").needed().unsigned();
const AT_SURFACE: Parameter = q(SURFACE, Kind::Length, "coordinate of the surface").needed();
const SECOND: Parameter =
    q(SECOND_CLEARANCE, Kind::Length, "2nd set-up clearance above the surface, where the tool goes in the end")
        .needed();

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_parameters_are_unique() {
        let mut numbers: Vec<(u32, u32)> = rows().map(|row| row.numbers).collect();
        numbers.sort_unstable();
        assert!(numbers.windows(2).all(|pair| pair[0].1 < pair[1].0), "{numbers:?}");
        for row in rows() {
            let list = row.signature.parameters;
            let twice = (1..list.len()).find(|at| list[..*at].iter().any(|before| before.name == list[*at].name));
            assert!(twice.is_none(), "{}: {twice:?}", row.signature.name);
        }
    }
}
