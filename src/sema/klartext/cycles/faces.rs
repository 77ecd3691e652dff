//! Faces: 230, 232 and 233.
//!
//! Source: K 6.7; F B7 (docs/sources.md).

use crate::diag::codes;
use crate::geo::{Deg, Point2};
use crate::ir::cycle::Cycle;
use crate::ir::cycle::facing::{self, Facing, Links, Overrun};
use crate::ir::cycle::milling::{Division, Feeds, Heights, Mill, Place, parts};
use crate::sema::cycle::call::Made;
use crate::sema::cycle::row::{Kind, Name, Parameter, Rule};

use super::call::{self, CycleCall};
use super::drilling::{FEED, PLUNGE, PREPOSITION};
use super::milling::{
    CORNER, FINISHING_FEED, FIRST_SIDE, FLOOR_ALLOWANCE, MILLING_FEED, OPERATION, POSITION, Q202, Q206, Q207, Q338,
    Q368, Q369, Q370, Q385, SECOND_SIDE, cycle,
};
use super::patterns::START;
use super::{CLEARANCE, Planned, Row, SECOND, SECOND_CLEARANCE, SET_UP, q};

pub(in super::super) const STEP_FEED: Name = Name::Q(209);
pub(in super::super) const TOP: Name = Name::Q(227);
pub(in super::super) const CUTS: Name = Name::Q(240);
pub(in super::super) const LIMITS: [Name; 3] = [Name::Q(347), Name::Q(348), Name::Q(349)];
pub(in super::super) const ALONG: Name = Name::Q(350);
pub(in super::super) const SIDE_CLEARANCE: Name = Name::Q(357);
pub(in super::super) const BOTTOM: Name = Name::Q(386);
pub(in super::super) const STRATEGY: Name = Name::Q(389);
/// First axis, second axis and height of the corners of a ruled surface.
pub(in super::super) const CORNERS: [[Name; 3]; 4] = [
    [START.0, START.1, TOP],
    [Name::Q(228), Name::Q(229), Name::Q(230)],
    [Name::Q(231), Name::Q(232), Name::Q(233)],
    [Name::Q(234), Name::Q(235), Name::Q(236)],
];

const Q225: Parameter = q(START.0, Kind::Length, "corner of the face along the first axis").needed();
const Q226: Parameter = q(START.1, Kind::Length, "corner of the face along the second axis").needed();
const Q218: Parameter = q(FIRST_SIDE, Kind::Length, "length of the face along the first axis").needed();
const Q219: Parameter = q(SECOND_SIDE, Kind::Length, "length of the face along the second axis").needed();
const Q227: Parameter = q(TOP, Kind::Length, "height of the blank").needed();
const Q386: Parameter = q(BOTTOM, Kind::Length, "height of the finished face").needed();
const Q253: Parameter = q(PREPOSITION, Kind::Feed, "feed to the level, and from path to path").needed();
const Q357: Parameter =
    q(SIDE_CLEARANCE, Kind::Length, "how far the cutter leaves the face at the ends of a path").needed().unsigned();
const Q389: Parameter =
    q(STRATEGY, Kind::Number, "0 to and fro, turning outside, 1 turning inside, 2 in one sense; others are refused")
        .needed()
        .rule(Rule::OneOf(0, 4));
const Q204: Parameter = SECOND.unsigned();
const NO_LIMITS: &str = "faces with limits are refused";

const fn limit(limit: Name, what: &'static str) -> Parameter {
    q(limit, Kind::Number, what).default("0")
}

const fn corner(of: Name, what: &'static str) -> Parameter {
    q(of, Kind::Length, what).needed()
}

pub(super) const ROWS: &[Row] = &[
    cycle(
        230,
        "CYCL DEF 230",
        "MULTIPASS MILLING",
        |call| call.multipass(),
        &[
            Q225,
            Q226,
            Parameter { what: "height of the face", ..Q227 },
            Q218,
            Q219,
            q(CUTS, Kind::Count, "number of paths").needed().rule(Rule::OneOf(2, 10_000)),
            Q206,
            Q207,
            q(STEP_FEED, Kind::Feed, "feed from path to path").needed(),
            SET_UP,
        ],
    ),
    cycle(
        231,
        "CYCL DEF 231",
        "RULED SURFACE",
        |call| call.ruled_surface(),
        &[
            corner(CORNERS[0][0], "corner where the first row begins, along the first axis"),
            corner(CORNERS[0][1], "the same corner along the second axis"),
            corner(CORNERS[0][2], "height of the same corner"),
            corner(CORNERS[1][0], "corner where the first row ends, along the first axis"),
            corner(CORNERS[1][1], "the same corner along the second axis"),
            corner(CORNERS[1][2], "height of the same corner"),
            corner(CORNERS[2][0], "corner opposite to the first one, along the first axis"),
            corner(CORNERS[2][1], "the same corner along the second axis"),
            corner(CORNERS[2][2], "height of the same corner"),
            corner(CORNERS[3][0], "corner opposite to the second one, along the first axis"),
            corner(CORNERS[3][1], "the same corner along the second axis"),
            corner(CORNERS[3][2], "height of the same corner"),
            q(CUTS, Kind::Count, "number of rows").needed().rule(Rule::OneOf(2, 10_000)),
            Parameter { what: "feed for milling; half of it in the first row", ..Q207 },
        ],
    ),
    cycle(
        232,
        "CYCL DEF 232",
        "FACE MILLING",
        |call| call.face(),
        &[
            Q389, Q225, Q226, Q227, Q386, Q218, Q219, Q202, Q369, Q370, Q207, Q385, Q253, SET_UP, Q357, Q204,
        ],
    ),
    cycle(
        233,
        "CYCL DEF 233",
        "FACE MILLING",
        |call| call.face_at_call(),
        &[
            q(OPERATION, Kind::Number, "0 roughs and finishes, 1 roughs, 2 finishes what Q369 leaves").needed().rule(Rule::OneOf(0, 2)),
            Q389,
            q(ALONG, Kind::Number, "paths along 0 the first, 1 the second axis").needed().rule(Rule::OneOf(0, 1)),
            Q218,
            Q219,
            Q227,
            Q386,
            Q369,
            Q202,
            Q370,
            Q207,
            Q385,
            Q253,
            Q357,
            SET_UP,
            Q204,
            limit(LIMITS[0], "first limit; above or below 0 it is refused"),
            limit(LIMITS[1], "second limit; above or below 0 it is refused"),
            limit(LIMITS[2], "third limit; above or below 0 it is refused"),
            q(CORNER, Kind::Length, "radius of the corners between limits").without_effect(NO_LIMITS),
            Q368.without_effect(NO_LIMITS),
            Q338.without_effect(NO_LIMITS),
            q(POSITION, Kind::Number, "place of the call: -1 the corner from which signed lengths count, 0 the middle, 1 to 4 the corners from the lower left one on")
                .rule(Rule::OneOf(-1, 4))
                .default("-1"),
        ],
    ),
];

impl CycleCall<'_> {
    /// Cycle 230.
    pub fn multipass(&self) -> Made<Planned> {
        let (corner, size) = self.face_of()?;
        let (top, clearance) = (self.given.length(TOP), self.given.length(CLEARANCE));
        let radius = self.cutter_radius()?;
        let cuts = self.cuts();
        let on_edges = self.settings.cycles.klartext.rows_on_edges;
        let (corner, size) = if on_edges { wider(corner, size, radius) } else { (corner, size) };
        let between = size[1].abs() - 2.0 * radius;
        if between <= 0.0 {
            return self.refuse(codes::K2901::no_room_between_paths());
        }
        let heights = Heights {
            retract: top + clearance,
            reference: top,
            clearance,
            depth: top,
            step: 0.0,
            division: Division::Even,
            allowance: 0.0,
        };
        let feeds = Feeds { plane: self.feed(MILLING_FEED)?, depth: self.feed(FEED)? };
        let face = Facing {
            mill: Mill { plane: self.st.state.plane(), heights, radius, feeds },
            corner: Place { at: corner, turn: Deg(0.0) },
            size,
            along: 0,
            alternates: true,
            links: Links::At(Some(self.feed(STEP_FEED)?)),
            width: between / f64::from(cuts - 1),
            overrun: Overrun { ends: 0.0, side: 0.0 },
            // The paths keep inside of the sides.
            walls: [[false; 2], [true; 2]],
            kind: facing::Kind::Rough,
            last: None,
        };
        Ok(Cycle::Facing(self.sound(face)?).into())
    }

    /// Cycle 232.
    pub fn face(&self) -> Made<Planned> {
        let (corner, size) = self.face_of()?;
        let mill = self.face_cutter()?;
        let finishing = self.feed_if(FINISHING_FEED, mill.feeds.plane)?;
        self.floor_in_one_cut(&mill)?;
        let face = self.paths_of_face(mill, (corner, size), 0)?;
        let last = (mill.heights.allowance > 0.0).then_some(finishing);
        Ok(Cycle::Facing(self.sound(Facing { last, ..face })?).into())
    }

    /// Cycle 233.
    pub fn face_at_call(&self) -> Made<Planned> {
        for limit in LIMITS {
            let value = self.given.or_zero(limit);
            if value != 0.0 {
                return self.refuse(codes::P9010::face_with_limit_is_not_supported(&limit, &value));
            }
        }
        let mill = self.face_cutter()?;
        let (operation, along) = (self.given.whole(OPERATION), self.given.whole(ALONG));
        let finishing = self.feed_if(FINISHING_FEED, mill.feeds.plane)?;
        if operation != 1 {
            self.floor_in_one_cut(&mill)?;
        }
        let place = self.face_at()?;
        let face = self.paths_of_face(mill, place, along as usize)?;
        let allowance = mill.heights.allowance;
        let face = match operation {
            0 => Facing { last: (allowance > 0.0).then_some(finishing), ..face },
            1 => face,
            _ if allowance == 0.0 => {
                self.say(codes::K8103::q369_leaves_nothing());
                return Ok(Planned::default());
            }
            // What roughing left is the blank.
            _ => {
                let heights =
                    Heights { reference: mill.heights.rough_floor(), allowance: 0.0, step: 0.0, ..mill.heights };
                let feeds = Feeds { plane: finishing, ..mill.feeds };
                Facing { mill: Mill { heights, feeds, ..mill }, ..face }
            }
        };
        Ok(Cycle::Facing(self.sound(face)?).into())
    }

    /// Corner and signed sizes of a face that lies where it is called.
    fn face_at(&self) -> Made<(Point2, [f64; 2])> {
        let start = self.call_point()?;
        let size = [self.given.length(FIRST_SIDE), self.given.length(SECOND_SIDE)];
        if self.given.number(POSITION).unwrap_or(-1.0) == -1.0 {
            return Ok((start, size));
        }
        for (name, side) in [(FIRST_SIDE, size[0]), (SECOND_SIDE, size[1])] {
            if side <= 0.0 {
                return self.refuse(codes::P2090::is_not_above_zero_2(&name, &side));
            }
        }
        let half = size.map(|side| side / 2.0);
        let to_middle = self.way_to_middle(half);
        Ok((Point2::new(start.x + to_middle.x - half[0], start.y + to_middle.y - half[1]), size))
    }

    /// Cutter, heights and feeds of a face.
    fn face_cutter(&self) -> Made<Mill> {
        let (top, bottom) = (self.given.length(TOP), self.given.length(BOTTOM));
        if top <= bottom {
            return self.refuse(codes::P2090::blank_q227_does_not_lie_above_face(&top, &bottom));
        }
        let radius = self.cutter_radius()?;
        let clearance = self.given.length(CLEARANCE);
        let second = self.given.length(SECOND_CLEARANCE).max(clearance);
        let surface = top + self.st.calling.shift;
        let heights = Heights {
            retract: self.st.calling.retract.height(&call::Heights { surface, clearance, second: surface + second }),
            reference: surface,
            clearance,
            depth: bottom + self.st.calling.shift,
            step: self.given.length(PLUNGE),
            division: Division::Even,
            allowance: self.given.length(FLOOR_ALLOWANCE),
        };
        let plane = self.feed(MILLING_FEED)?;
        let feeds = Feeds { plane, depth: self.retract_feed(PREPOSITION, None)?.unwrap_or(plane) };
        Ok(Mill { plane: self.st.state.plane(), heights, radius, feeds })
    }

    /// The paths by Q389, along the first axis or the second one.
    fn paths_of_face(&self, mill: Mill, (corner, size): (Point2, [f64; 2]), along: usize) -> Made<Facing> {
        let strategy = self.given.whole(STRATEGY);
        let link = self.retract_feed(PREPOSITION, None)?;
        let links = match strategy {
            0 | 2 => Links::At(link),
            1 => {
                self.say_of_all(codes::K8141::with_q389_1_inner_ways_end_beyond());
                Links::Inside(link)
            }
            3 => return self.refuse(codes::P9010::paths_without_overrun()),
            _ => return self.refuse(codes::P9010::paths_from_outside_inwards()),
        };
        let width = self.overlap(mill.radius)?;
        let across = size[1 - along].abs();
        Ok(Facing {
            mill,
            corner: Place { at: corner, turn: Deg(0.0) },
            size,
            along,
            alternates: strategy < 2,
            links,
            width: across / parts(across, width) as f64,
            overrun: Overrun { ends: self.given.length(SIDE_CLEARANCE), side: 0.0 },
            walls: [[false; 2]; 2],
            kind: facing::Kind::Rough,
            last: None,
        })
    }

    /// Q240.
    pub fn cuts(&self) -> u32 {
        self.given.whole(CUTS) as u32
    }

    /// Corner and signed sizes of a face, which has a place of its own.
    fn face_of(&self) -> Made<(Point2, [f64; 2])> {
        if self.st.calling.placed() {
            return self.refuse(codes::P9010::pattern_or_cycl_call_pos_with_face());
        }
        let corner = Point2::new(self.given.length(START.0), self.given.length(START.1));
        Ok((corner, [self.given.length(FIRST_SIDE), self.given.length(SECOND_SIDE)]))
    }
}

/// The face that a path on its side would lie a radius inside of.
fn wider(corner: Point2, [length, width]: [f64; 2], radius: f64) -> (Point2, [f64; 2]) {
    let by = radius.copysign(width);
    (Point2::new(corner.x, corner.y - by), [length, width + 2.0 * by])
}
