//! Pockets and slots: 251 to 254.
//!
//! Source: K 6.5; F B4 (docs/sources.md).

use core::f64::consts::TAU;

use crate::diag::codes;
use crate::geo::{Deg, Point2};
use crate::ir::cycle::Cycle;
use crate::ir::cycle::milling::{MOST_LEVELS, Mill, Place, parts};
use crate::ir::cycle::pocket::{Finish, Insertion, LevelChange, Pocket, Room, Shape, Strategy, WallApproach};
use crate::sema::cycle::call::Made;
use crate::sema::cycle::row::{Kind, Name, Rule};

use super::call::{By, CycleCall};
use super::drilling::Q201;
use super::machining::{Machining, Plunging, shown};
use super::milling::{
    CORNER, DIAMETER, FIRST_SIDE, POSITION, Q202, Q206, Q207, Q215, Q338, Q351, Q366, Q368, Q369, Q370, Q385, Q439,
    SECOND_SIDE, TURN, cycle,
};
use super::{ABOVE_0, AT_SURFACE, Planned, Row, SECOND, SET_UP, q};

pub(in super::super) const CENTER: (Name, Name) = (Name::Q(216), Name::Q(217));
pub(in super::super) const OPENING: Name = Name::Q(248);
pub(in super::super) const SLOT_TURN: Name = Name::Q(374);
pub(in super::super) const PITCH_CIRCLE: Name = Name::Q(375);
pub(in super::super) const START_ANGLE: Name = Name::Q(376);
pub(in super::super) const NUMBER: Name = Name::Q(377);
pub(in super::super) const STEP: Name = Name::Q(378);

/// The parameters of a cycle of its own, those that all pockets and slots have, and how it goes down.
macro_rules! parameters {
    ($($own:expr),* ; $($down:expr),*) => {
        &[
            Q215, $($own),*, Q368, Q207, Q351, Q201, Q202, Q369, Q206, Q338, SET_UP, AT_SURFACE, SECOND, $($down),*, Q385, Q439,
        ]
    };
}

pub(super) const ROWS: &[Row] = &[
    cycle(
        251,
        "CYCL DEF 251",
        "RECTANGULAR POCKET",
        |call| call.rectangular_pocket(),
        parameters![
            q(FIRST_SIDE, Kind::Length, "length of the pocket along the first axis").needed().rule(ABOVE_0),
            q(SECOND_SIDE, Kind::Length, "length of the pocket along the second axis").needed().rule(ABOVE_0),
            q(super::milling::CORNER, Kind::Length, "radius of the corners; the cutter's where that is larger")
                .unsigned()
                .default("0"),
            q(TURN, Kind::Angle, "angle by which the pocket is turned about the place of the call").default("0"),
            q(POSITION, Kind::Number, "place of the call: 0 the middle, 1 to 4 the corners from the lower left one on")
                .rule(Rule::OneOf(0, 4))
                .default("0");
            Q370, Q366
        ],
    ),
    cycle(
        252,
        "CYCL DEF 252",
        "CIRCULAR POCKET",
        |call| call.circular_pocket(),
        parameters![
            q(DIAMETER, Kind::Length, "diameter of the pocket").needed().rule(ABOVE_0);
            Q370, Q366
        ],
    ),
    cycle(
        253,
        "CYCL DEF 253",
        "SLOT MILLING",
        |call| call.slot(),
        parameters![
            q(FIRST_SIDE, Kind::Length, "length of the slot").needed().rule(ABOVE_0),
            q(SECOND_SIDE, Kind::Length, "width of the slot").needed().rule(ABOVE_0),
            q(SLOT_TURN, Kind::Angle, "angle by which the slot is turned about the place of the call").default("0"),
            q(
                POSITION,
                Kind::Number,
                "place of the call: 0 the middle, 1 the left end, 2 and 3 the centres of the left and the right arc, 4 the right end",
            )
            .rule(Rule::OneOf(0, 4))
            .default("0");
            Q366
        ],
    ),
    cycle(
        254,
        "CYCL DEF 254",
        "CIRCULAR SLOT",
        |call| call.circular_slot(),
        parameters![
            q(SECOND_SIDE, Kind::Length, "width of the slot").needed().rule(ABOVE_0),
            q(PITCH_CIRCLE, Kind::Length, "diameter of the pitch circle").needed().rule(ABOVE_0),
            q(
                POSITION,
                Kind::Number,
                "0 the centre is Q216/Q217; 2 the call is in the middle of the slot; 1 and 3, its ends, are refused",
            )
            .rule(Rule::OneOf(0, 3))
            .default("0"),
            q(CENTER.0, Kind::Length, "centre along the first axis; for Q367 = 0").default("0"),
            q(CENTER.1, Kind::Length, "centre along the second axis; for Q367 = 0").default("0"),
            q(START_ANGLE, Kind::Angle, "angle of the centre of the first arc; of the middle for Q367 = 2").needed(),
            q(OPENING, Kind::Angle, "angle of the slot between the centres of its arcs").needed(),
            q(STEP, Kind::Angle, "angle from slot to slot").default("0"),
            q(NUMBER, Kind::Count, "number of slots").rule(Rule::OneOf(1, 99_999)).default("1");
            Q366
        ],
    ),
];

/// Smaller helices and strokes are no way down, mm.
const SMALLEST_WAY: f64 = 0.1;

/// The widest allowance on the wall that one circuit of finishing takes off: with more, stock stays between what the
/// roughing clears and what the finishing does.
fn widest_allowance(shape: &Shape, radius: f64) -> f64 {
    if shape.room(2.0 * radius).least() <= 0.0 {
        return f64::INFINITY;
    }
    match *shape {
        // The rounded corner of the roughing has to reach the one inside of the finishing cut.
        Shape::Rectangle { corner, .. } => {
            let path = (corner - radius).clamp(radius, 2.0 * radius);
            path + (2.0 * radius - path) * core::f64::consts::FRAC_1_SQRT_2
        }
        Shape::Circle { .. } | Shape::Slot { .. } | Shape::Bow { .. } => 2.0 * radius,
    }
}

/// A cutter that is wider by less, mm, is as wide as the shape: an inch program writes its widths rounded.
const AS_WIDE: f64 = 5e-5;

impl CycleCall<'_> {
    /// Cycle 251.
    pub fn rectangular_pocket(&self) -> Made<Planned> {
        let Some((mill, asked)) = self.pocket_of()? else { return Ok(Planned::default()) };
        let half = [self.given.length(FIRST_SIDE) / 2.0, self.given.length(SECOND_SIDE) / 2.0];
        let corner = self.given.length(CORNER);
        let corner = self.corner_of(CORNER, corner, mill.radius);
        let turn = Deg(self.given.or_zero(TURN));
        let start = self.call_point()?;
        let to_middle = self.way_to_middle(half);
        let place = Place { at: Place { at: start, turn }.point(to_middle), turn };
        let width = self.overlap(mill.radius)?;
        let pocket = self.pocket(mill, asked, Shape::Rectangle { half, corner }, (place, width))?;
        let plunging = self.plunging()?;
        let insertion = self.insertion(&pocket, plunging)?;
        self.milled(Pocket { insertion, home: Some(start), ..pocket })
    }

    /// Cycle 252.
    pub fn circular_pocket(&self) -> Made<Planned> {
        let Some((mill, asked)) = self.pocket_of()? else { return Ok(Planned::default()) };
        let radius = self.given.length(DIAMETER) / 2.0;
        let place = Place { at: self.call_point()?, turn: Deg(0.0) };
        let width = self.overlap(mill.radius)?;
        let pocket = self.pocket(mill, asked, Shape::Circle { radius }, (place, width))?;
        let plunging = self.plunging()?;
        let insertion = self.insertion(&pocket, plunging)?;
        self.milled(Pocket { insertion, home: Some(place.at), ..pocket })
    }

    /// Cycle 253.
    pub fn slot(&self) -> Made<Planned> {
        let Some((mill, asked)) = self.pocket_of()? else { return Ok(Planned::default()) };
        let (length, width) = (self.given.length(FIRST_SIDE), self.given.length(SECOND_SIDE));
        if length <= width {
            return self.refuse(codes::P2090::slot_length_q218_mm_is_not_above(&length, &width));
        }
        let half = (length - width) / 2.0;
        let turn = Deg(self.given.or_zero(SLOT_TURN));
        let start = self.call_point()?;
        let position = self.given.whole(POSITION);
        let to_middle = [0.0, length / 2.0, half, -half, -length / 2.0][position as usize];
        let place = Place { at: Place { at: start, turn }.point(Point2::new(to_middle, 0.0)), turn };
        let shape = Shape::Slot { from: -half, to: half, width };
        let pocket = self.pocket(mill, asked, shape, (place, mill.radius))?;
        let insertion = self.plunging_along(&pocket, 2.0 * half)?;
        let home = (position == 0).then_some(start);
        self.milled(Pocket { insertion, home, ..pocket })
    }

    /// Cycle 254.
    pub fn circular_slot(&self) -> Made<Planned> {
        let Some((mill, asked)) = self.pocket_of()? else { return Ok(Planned::default()) };
        let (width, radius) = (self.given.length(SECOND_SIDE), self.given.length(PITCH_CIRCLE) / 2.0);
        let sweep = self.given.or_zero(OPENING);
        if sweep <= 0.0 || sweep >= 360.0 {
            return self.refuse(codes::P2090::opening_angle_q248_is_not_above_0(&sweep));
        }
        let angle = self.given.or_zero(START_ANGLE);
        let start = self.call_point()?;
        let (center, first) = match self.given.whole(POSITION) {
            0 if self.st.calling.by == By::Pattern => {
                return self.refuse(codes::P9010::pattern_of_slots_about_one_centre());
            }
            0 => (Point2::new(self.required(CENTER.0)?, self.required(CENTER.1)?), angle),
            2 => (start - Deg(angle).unit() * radius, angle - sweep / 2.0),
            other => {
                return self.refuse(codes::P9010::call_at_one_end_of_slot(&other));
            }
        };
        let count = if self.given.has(NUMBER) { self.given.whole(NUMBER) as u32 } else { 1 };
        let step = self.given.or_zero(STEP);
        let place = |i: u32| Place { at: center, turn: Deg(first + f64::from(i) * step) };
        let shape = Shape::Bow { radius, sweep: Deg(sweep), width };
        let pocket = self.pocket(mill, asked, shape, (place(0), mill.radius))?;
        let insertion = self.plunging_along(&pocket, radius * sweep * core::f64::consts::PI / 180.0)?;
        let places: Vec<Place> = (0..count).map(place).collect();
        let middle = pocket.shape.middle();
        self.say_of_repeated(places.iter().map(|place| place.point(middle)));
        let made = self.milled(Pocket { insertion, places, ..pocket })?;
        Ok(Planned { steps: 2 * u64::from(count), ..made })
    }

    /// What all of them take.
    fn pocket_of(&self) -> Made<Option<(Mill, Machining)>> {
        let Some(mill) = self.cutter_of()? else { return Ok(None) };
        self.feed_of_centre()?;
        let Some(asked) = self.asked(&mill)? else { return Ok(None) };
        if asked.floor {
            self.floor_in_one_cut(&mill)?;
        }
        Ok(Some((mill, asked)))
    }

    /// From the place of the call to the middle, by Q367.
    pub fn way_to_middle(&self, [x, y]: [f64; 2]) -> Point2 {
        match self.given.whole(POSITION) {
            0 => Point2::new(0.0, 0.0),
            1 => Point2::new(x, y),
            2 => Point2::new(-x, y),
            3 => Point2::new(-x, -y),
            _ => Point2::new(x, -y),
        }
    }

    /// The radius of the corners; 0 for that of the cutter, which is said.
    pub fn corner_of(&self, name: impl core::fmt::Display, corner: f64, radius: f64) -> f64 {
        if corner >= radius {
            return corner;
        }
        self.say_of_all(codes::K8102::corners_get_radius_of_cutter(&radius, &name, &corner));
        0.0
    }

    /// How much room a cutter has that fits into the shape.
    pub fn room(&self, shape: &Shape, radius: f64) -> Made<f64> {
        let room = shape.room(radius).least();
        if room >= -AS_WIDE {
            return Ok(room.max(0.0));
        }
        self.refuse(codes::K2901::cutter_is_wider(&(2.0 * radius), &shown(2.0 * (room + radius))))
    }

    /// A pocket that is entered straight down.
    pub fn pocket(&self, mill: Mill, asked: Machining, shape: Shape, (place, width): (Place, f64)) -> Made<Pocket> {
        let room = self.room(&shape, mill.radius)?;
        // Finishing enters through what roughing has cleared, too.
        if (asked.rough || asked.wall) && room - asked.allowance < -1e-9 {
            return self.refuse(codes::K2901::allowance_leaves_no_room(&shown(asked.allowance)));
        }
        if asked.wall {
            let most = widest_allowance(&shape, mill.radius);
            self.finishing_meets_roughing((asked.allowance, most), mill.radius)?;
        }
        let finish = (asked.wall || asked.floor).then_some(Finish {
            wall: asked.wall,
            floor: asked.floor,
            feed: asked.feed,
            step: asked.step,
            speed: None,
            onto: WallApproach::Quarter(room / 2.0),
            inserts: true,
        });
        Ok(Pocket {
            counter_clockwise: self.climbs()?,
            allowance: asked.allowance,
            mill,
            shape,
            places: vec![place],
            width,
            insertion: Insertion::Vertical,
            strategy: Strategy::Levels,
            rough: asked.rough,
            finish,
            cleared: None,
            transfer: None,
            between: LevelChange::Lifted,
            home: None,
        })
    }

    /// How the tool gets into a pocket: its ways keep the angle of the tool, and stay where roughing has room.
    fn insertion(&self, pocket: &Pocket, plunging: Plunging) -> Made<Insertion> {
        let radius = pocket.mill.radius;
        let room = pocket.shape.room(pocket.rough_distance());
        let deep = pocket.mill.heights.step.min(pocket.mill.heights.way());
        match plunging {
            Plunging::Vertical => Ok(Insertion::Vertical),
            Plunging::Helix(angle) => {
                let least = room.least();
                let ring = least / parts(least, pocket.width) as f64;
                let about = (radius / 2.0).min(ring);
                let pitch = TAU * about * libm::tan(angle.radians());
                if about < SMALLEST_WAY || parts(deep, pitch) > MOST_LEVELS {
                    return self.refuse(codes::K2903::no_room_for_plunging(&1));
                }
                Ok(Insertion::Helix { radius: about, pitch })
            }
            Plunging::Ramp(angle) => {
                let stroke = match room {
                    Room::Rectangle([x, y]) => (2.0 * (x - y).abs()).max(2.0 * x.max(y) / 3.0),
                    Room::Around(half) => 2.0 * half / 3.0,
                };
                let stroke = stroke.min(4.0 * radius);
                if stroke < SMALLEST_WAY || parts(deep, stroke * libm::tan(angle.radians())) > MOST_LEVELS {
                    return self.refuse(codes::K2903::no_room_for_plunging(&2));
                }
                Ok(Insertion::Ramp { angle, stroke: Some(stroke) })
            }
        }
    }

    /// The way into a slot, along its middle line.
    fn plunging_along(&self, pocket: &Pocket, length: f64) -> Made<Insertion> {
        let insertion = self.plunging()?.along();
        if let Insertion::Ramp { angle, .. } = insertion {
            let deep = pocket.mill.heights.step.min(pocket.mill.heights.way());
            if length < SMALLEST_WAY || parts(deep, length * libm::tan(angle.radians())) > MOST_LEVELS {
                return self.refuse(codes::K2903::no_room_for_plunging(&2));
            }
        }
        Ok(insertion)
    }

    pub fn milled(&self, pocket: Pocket) -> Made<Planned> {
        let steps = pocket.places.len() as u64;
        Ok(Planned { steps, ..Cycle::Pocket(self.sound(pocket)?).into() })
    }
}
