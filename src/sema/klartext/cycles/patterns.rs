//! Patterns that run the machining cycle at many places: 220 and 221.

use crate::diag::{Fault, codes};
use crate::geo::{Deg, Point2};
use crate::sema::cycle::call::Made;
use crate::sema::cycle::row::{Kind, Name, Parameter, Rule, Signature, Status};

use super::call::CycleCall;
use super::{AT_SURFACE, CycleKind, REMOVE, Row, SECOND, SET_UP, q};

pub(in super::super) const CENTER: (Name, Name) = (Name::Q(216), Name::Q(217));
pub(in super::super) const TURN: Name = Name::Q(224);
pub(in super::super) const START: (Name, Name) = (Name::Q(225), Name::Q(226));
pub(in super::super) const SPACING: (Name, Name) = (Name::Q(237), Name::Q(238));
pub(in super::super) const NUMBER: Name = Name::Q(241);
pub(in super::super) const COLUMNS: Name = Name::Q(242);
pub(in super::super) const LINES: Name = Name::Q(243);
pub(in super::super) const CIRCLE: Name = Name::Q(244);
pub(in super::super) const START_ANGLE: Name = Name::Q(245);
pub(in super::super) const STOP_ANGLE: Name = Name::Q(246);
pub(in super::super) const STEP: Name = Name::Q(247);
pub(in super::super) const AT_SECOND: Name = Name::Q(301);
pub(in super::super) const ON_ARCS: Name = Name::Q(365);

/// Places that are nearer than this are one, mm.
pub(in super::super) const SAME_PLACE: f64 = 1e-6;

/// Most places of a pattern.
const MOST: f64 = 99_999.0;
const PLACES: Rule = Rule::OneOf(1, 99_999);

const Q301: Parameter =
    q(AT_SECOND, Kind::Number, "from place to place at 0 the set-up clearance, 1 the 2nd set-up clearance")
        .needed()
        .rule(Rule::OneOf(0, 1));

pub(super) const ROWS: &[Row] = &[
    Row {
        numbers: (220, 220),
        nature: CycleKind::Pattern(Some(|call| call.polar_places())),
        requires: &[],
        signature: Signature {
            name: "CYCL DEF 220",
            what: "POLAR PATTERN",
            status: Status::Built,
            source: "HEIDENHAIN TNC 320 cycle programming, p. 178; TNC 640 cycles, p. 162",
            parameters: &[
                q(CENTER.0, Kind::Length, "centre along the first axis").needed(),
                q(CENTER.1, Kind::Length, "centre along the second axis").needed(),
                q(CIRCLE, Kind::Length, "pitch circle diameter").needed().unsigned(),
                q(START_ANGLE, Kind::Angle, "angle of the first place").needed(),
                q(STOP_ANGLE, Kind::Angle, "angle of the last place; not used where Q247 is not 0").needed(),
                q(STEP, Kind::Angle, "angle from place to place; 0 by Q246 and Q241").needed(),
                q(NUMBER, Kind::Count, "number of places").needed().rule(PLACES),
                SET_UP,
                AT_SURFACE,
                SECOND,
                Q301,
                q(ON_ARCS, Kind::Number, "from place to place 0 on lines; 1, on arcs, is refused").default("0"),
            ],
        },
        form: REMOVE,
    },
    Row {
        numbers: (221, 221),
        nature: CycleKind::Pattern(Some(|call| call.grid_places())),
        requires: &[],
        signature: Signature {
            name: "CYCL DEF 221",
            what: "CARTESIAN PATTERN",
            status: Status::Built,
            source: "HEIDENHAIN TNC 410 DIN/ISO manual, p. 257",
            parameters: &[
                q(START.0, Kind::Length, "first place along the first axis").needed(),
                q(START.1, Kind::Length, "first place along the second axis").needed(),
                q(SPACING.0, Kind::Length, "distance of the columns").needed(),
                q(SPACING.1, Kind::Length, "distance of the lines").needed(),
                q(COLUMNS, Kind::Count, "number of columns").needed().rule(PLACES),
                q(LINES, Kind::Count, "number of lines").needed().rule(PLACES),
                q(TURN, Kind::Angle, "angle by which the pattern is turned about its first place").needed(),
                SET_UP,
                AT_SURFACE,
                SECOND,
                Q301,
            ],
        },
        form: REMOVE,
    },
    Row {
        numbers: (224, 224),
        nature: CycleKind::Pattern(None),
        requires: &[],
        signature: Signature {
            name: "CYCL DEF 224",
            what: "DATA MATRIX PATTERN",
            status: Status::Refused { code: "P9010" },
            source: "",
            parameters: &[],
        },
        form: REMOVE,
    },
];

impl CycleCall<'_> {
    /// Q216/Q217 centre, Q244 diameter, Q245 first angle, Q246 last angle, Q247 step, Q241 number.
    pub fn polar_places(&self) -> Made<Vec<Point2>> {
        let center = Point2::new(self.given.length(CENTER.0), self.given.length(CENTER.1));
        let radius = self.given.length(CIRCLE) / 2.0;
        let (first, last) = (self.given.or_zero(START_ANGLE), self.given.or_zero(STOP_ANGLE));
        let step = self.given.or_zero(STEP);
        let count = self.given.whole(NUMBER) as u32;
        if step == 0.0 && first == last {
            return self.refuse(codes::P2090::start_angle_q245());
        }
        let span = last - first;
        let full = span.abs() == 360.0;
        let angle = |i: u32| {
            let i = f64::from(i);
            match step {
                // One division keeps a third of a turn exact.
                0.0 if full => first + i * span / f64::from(count),
                0.0 if count > 1 => first + i * span / f64::from(count - 1),
                0.0 => first,
                step => first + i * step,
            }
        };
        Ok((0..count).map(|i| center + Deg(angle(i)).unit() * radius).collect())
    }

    /// Q225/Q226 first place, Q237/Q238 spacing, Q242 columns, Q243 lines, Q224 rotation; line by line, to and fro.
    pub fn grid_places(&self) -> Made<Vec<Point2>> {
        let start = Point2::new(self.given.length(START.0), self.given.length(START.1));
        let (across, up) = (self.given.length(SPACING.0), self.given.length(SPACING.1));
        let (columns, lines) = (self.given.whole(COLUMNS) as u32, self.given.whole(LINES) as u32);
        if f64::from(columns) * f64::from(lines) > MOST {
            return self.refuse(codes::P2090::pattern_has_more_than_99999_places());
        }
        let turn = Deg(self.given.or_zero(TURN));
        let (along, beside) = (turn.unit(), Deg(turn.0 + 90.0).unit());
        let mut places = Vec::new();
        for line in 0..lines {
            for i in 0..columns {
                let column = if line % 2 == 0 { i } else { columns - 1 - i };
                places.push(start + along * (f64::from(column) * across) + beside * (f64::from(line) * up));
            }
        }
        Ok(places)
    }

    /// A place that stands in the list twice is machined twice.
    pub fn say_of_repeated(&self, places: impl Iterator<Item = Point2>) {
        if let Some(fault) = repeated(&self.given.called, places) {
            self.st.at_definition.borrow_mut().push(fault);
        }
    }
}

/// What is worth saying where places are the same.
pub(in super::super) fn repeated(what: &str, places: impl Iterator<Item = Point2>) -> Option<Fault> {
    let grid = |v: f64| libm::round(v / SAME_PLACE) as i64;
    let mut list: Vec<(i64, i64)> = places.map(|p| (grid(p.x), grid(p.y))).collect();
    let count = list.len();
    list.sort_unstable();
    list.dedup();
    let twice = count - list.len();
    (twice > 0).then(|| codes::K8106::has_places_of_which_lie_on_others(&what, &count, &twice))
}
