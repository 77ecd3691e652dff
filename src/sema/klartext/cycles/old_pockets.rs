//! The old pockets and slots, whose values stand in parts: 3 to 5. The tool stands at the set-up clearance over them, and
//! comes back to there.
//!
//! Source: K 6.5; F B5 (docs/sources.md).

use crate::diag::codes;
use crate::geo::{Deg, Point2};
use crate::ir::cycle::milling::{Division, Feeds, Heights, Mill, Place};
use crate::ir::cycle::pocket::{Insertion, LevelChange, Pocket, Shape, Strategy};
use crate::ir::cycle::{Cycle, LongHole};
use crate::machine::{Axis, AxisSet};
use crate::sema::cycle::call::Made;
use crate::sema::cycle::row::{Kind, Name, Parameter, Rule, Signature, Status};

use super::call::CycleCall;
use super::milling::MILLING;
use super::{CycleKind, Plan, Planned, Row};

/// Parts that all of them have.
const STEP: Name = Name::Part(3);
const PLUNGING: Name = Name::In(3, "F");
/// Of cycle 4 and of cycle 5.
const CORNER: Name = Name::In(6, "RADIUS");
const RADIUS: Name = Name::Part(4);

const MANUAL: &str = "HEIDENHAIN TNC 426 DIN/ISO manual, p. 155; TNC 407 manual";

const fn part(part: u32, what: &'static str) -> Parameter {
    Parameter::new(Name::Part(part), Kind::Length, what).needed()
}

const fn word(part: u32, word: &'static str, kind: Kind, what: &'static str) -> Parameter {
    Parameter::new(Name::In(part, word), kind, what).needed()
}

const SET_UP: Parameter = part(1, "set-up clearance, its sign is left out; the tool stands there");
const DEPTH: Parameter = part(2, "depth below the surface, below 0");
const INFEED: Parameter = part(3, "greatest infeed in depth, its sign is left out");
const PLUNGE: Parameter = word(3, "F", Kind::Feed, "feed for plunging");
const TURN: &str = "sense of the way: DR+ counter-clockwise, climb milling with M3, DR- clockwise";

const fn cycle(
    number: u32,
    name: &'static str,
    what: &'static str,
    form: &'static str,
    plan: Plan,
    parameters: &'static [Parameter],
) -> Row {
    let signature = Signature { name, what, status: Status::Built, source: MANUAL, parameters };
    Row { numbers: (number, number), nature: CycleKind::Milling(plan), requires: MILLING, signature, form }
}

pub(super) const ROWS: &[Row] = &[
    cycle(
        3,
        "CYCL DEF 3",
        "SLOT MILLING",
        "write `3.1 SET UP 2`, `3.2 DEPTH -15`, `3.3 PECKG 4 F80`, `3.4 X80`, `3.5 Y10`, `3.6 F100`",
        |call| call.old_slot(),
        &[
            SET_UP,
            DEPTH,
            INFEED,
            PLUNGE,
            word(4, "X", Kind::Length, "axis and length of the slot; its sign says to which side"),
            word(5, "Y", Kind::Length, "the other axis, and the width; a tool of another size is refused"),
            word(6, "F", Kind::Feed, "feed for milling"),
        ],
    ),
    cycle(
        4,
        "CYCL DEF 4",
        "POCKET MILLING",
        "write `4.1 SET UP 2`, `4.2 DEPTH -15`, `4.3 PECKG 4 F80`, `4.4 X80`, `4.5 Y40`, `4.6 F100 DR+ RADIUS 10`",
        |call| call.old_rectangle(),
        &[
            SET_UP,
            DEPTH,
            INFEED,
            PLUNGE,
            word(4, "X", Kind::Length, "an axis of the plane, and the length of the pocket along it"),
            word(5, "Y", Kind::Length, "the other axis, and the length along it"),
            word(6, "F", Kind::Feed, "feed for milling"),
            word(6, "DR", Kind::Number, TURN),
            Parameter::new(CORNER, Kind::Length, "radius of the corners").unsigned().default("the cutter's"),
        ],
    ),
    cycle(
        5,
        "CYCL DEF 5",
        "CIRCULAR POCKET",
        "write `5.1 SET UP 2`, `5.2 DEPTH -15`, `5.3 PECKG 4 F80`, `5.4 RADIUS 35`, `5.5 F100 DR+`",
        |call| call.old_circle(),
        &[
            SET_UP,
            DEPTH,
            INFEED,
            PLUNGE,
            part(4, "radius of the pocket").rule(Rule::Above(0)),
            word(5, "F", Kind::Feed, "feed for milling"),
            word(5, "DR", Kind::Number, TURN),
        ],
    ),
];

/// A tool that differs by less has the width of the slot, mm.
const SAME_WIDTH: f64 = 1e-4;

impl CycleCall<'_> {
    /// Cycle 3.
    pub fn old_slot(&self) -> Made<Planned> {
        let mill = self.old_cutter(6)?;
        let ([along, across], [length, width]) = self.old_sides()?;
        if width <= 0.0 || length.abs() <= width {
            let (along, across) = (along.letter(), across.letter());
            return self.refuse(codes::P2090::length_mm_of_slot_is_not_above(&along, &length, &across, &width));
        }
        if (width - 2.0 * mill.radius).abs() > SAME_WIDTH {
            return self.refuse(codes::P9010::old_slot_with_another_tool(&width, &(2.0 * mill.radius)));
        }
        let start = self.call_point()?;
        let way = (length.abs() - width) * length.signum();
        let (first, _, _) = mill.plane.axes();
        let end = if along == Axis::ALL[first] {
            Point2::new(start.x + way, start.y)
        } else {
            Point2::new(start.x, start.y + way)
        };
        let slot = LongHole { mill, holes: vec![[start, end]], home: Some(start) };
        Ok(Cycle::LongHole(self.sound(slot)?).into())
    }

    /// Cycle 4.
    pub fn old_rectangle(&self) -> Made<Planned> {
        let mill = self.old_cutter(6)?;
        let ([along, _], sides) = self.old_sides()?;
        if let Some(side) = sides.into_iter().find(|side| *side <= 0.0) {
            return self.refuse(codes::P2090::side_of_mm_is_not_above_zero(&side));
        }
        let (first, _, _) = mill.plane.axes();
        let half = if along == Axis::ALL[first] { sides } else { [sides[1], sides[0]] }.map(|side| side / 2.0);
        self.room(&Shape::Rectangle { half, corner: 0.0 }, mill.radius)?;
        let corner = self.given.length_if(CORNER).map_or(0.0, |corner| self.corner_of("RADIUS", corner, mill.radius));
        // The first way leads towards plus of the longer side, of a square towards plus of the second axis.
        let turn = if half[0] == half[1] { Deg(90.0) } else { Deg(180.0) };
        self.old_pocket(mill, Shape::Rectangle { half, corner }, (6, turn))
    }

    /// Cycle 5.
    pub fn old_circle(&self) -> Made<Planned> {
        let mill = self.old_cutter(5)?;
        let radius = self.given.length(RADIUS);
        self.room(&Shape::Circle { radius }, mill.radius)?;
        self.old_pocket(mill, Shape::Circle { radius }, (5, Deg(0.0)))
    }

    /// A pocket over whose middle the tool stands; the part that says DR.
    fn old_pocket(&self, mill: Mill, shape: Shape, (part, turn): (u32, Deg)) -> Made<Planned> {
        let start = self.call_point()?;
        let pocket = Pocket {
            counter_clockwise: self.given.or_zero(Name::In(part, "DR")) > 0.0,
            width: self.settings.cycles.klartext.old_overlap * mill.radius,
            mill,
            shape,
            places: vec![Place { at: start, turn }],
            allowance: 0.0,
            insertion: Insertion::Vertical,
            strategy: Strategy::Levels,
            rough: true,
            finish: None,
            cleared: None,
            transfer: None,
            between: LevelChange::Lifted,
            home: Some(start),
        };
        self.milled(pocket)
    }

    /// The cutter of an old pocket; the part that says the feed for milling.
    fn old_cutter(&self, milling: u32) -> Made<Mill> {
        self.can_mill()?;
        let radius = self.cutter_radius()?;
        let levels = self.old_levels(self.st.state.axis())?;
        let step = self.given.magnitude(STEP);
        if step == 0.0 {
            return self.refuse(codes::P2090::infeed_in_depth_is_0());
        }
        let heights = Heights {
            retract: levels.retract,
            reference: levels.reference,
            clearance: levels.clearance,
            depth: levels.depth,
            step,
            division: Division::Whole,
            allowance: 0.0,
        };
        let feeds = Feeds { plane: self.feed(Name::In(milling, "F"))?, depth: self.feed(PLUNGING)? };
        Ok(Mill { plane: self.st.state.plane(), heights, radius, feeds })
    }

    /// Axes and lengths of the parts 4 and 5: both axes of the plane.
    fn old_sides(&self) -> Made<([Axis; 2], [f64; 2])> {
        let (first, second, _) = self.st.state.plane().axes();
        let plane: AxisSet = [first, second].map(|axis| Axis::ALL[axis]).into_iter().collect();
        let cycle = self.st.cycle;
        match (cycle.along(4), cycle.along(5)) {
            (Some((a, length)), Some((b, width))) if a != b && plane.contains(a) && plane.contains(b) => {
                Ok(([a, b], [length * cycle.mm, width * cycle.mm]))
            }
            _ => self.refuse(codes::P2090::its_two_sides_do_not_lie_along()),
        }
    }
}
