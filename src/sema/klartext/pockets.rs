//! Pockets and slots: 251 to 254.
//!
//! Source: K 6.5; F B4 (docs/sources.md).

use core::f64::consts::TAU;

use crate::diag::codes;
use crate::geo::{Deg, Point2};
use crate::ir::cycle::Cycle;
use crate::ir::cycle::milling::{MOST_LEVELS, Mill, Place, parts};
use crate::ir::cycle::pocket::{Between, Finish, Insertion, Onto, Pocket, Room, Shape, Strategy};

use super::cycles::DefinedCycle;
use super::cycles::call::{By, Call};
use super::cycles::milling::{CORNER, DIAMETER, FIRST_SIDE, POSITION, SECOND_SIDE, TURN};
use super::cycles::pockets::{CENTER, NUMBER, OPENING, PITCH_CIRCLE, SLOT_TURN, START_ANGLE, STEP};
use super::milling::{Asked, Plunging, shown};
use super::{Outcome, Run};

/// Smaller helices and strokes are no way down, mm.
const SMALLEST_WAY: f64 = 0.1;
/// Most slots of a call.
const MOST_SLOTS: u32 = 99_999;

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

/// A length in mm for a text.
pub(super) fn rounded(length: f64) -> f64 {
    libm::rint(length * 1e6) / 1e6
}

impl Run<'_> {
    /// Cycle 251.
    pub(super) fn rectangular_pocket(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Cycle>> {
        let Some((mill, asked)) = self.pocket_of(cycle, call)? else { return Ok(None) };
        let half = [self.above_zero(cycle, FIRST_SIDE)? / 2.0, self.above_zero(cycle, SECOND_SIDE)? / 2.0];
        let corner = self.not_below_zero(cycle, CORNER)?;
        let corner = self.corner_of(cycle, ("Q220", corner), mill.radius)?;
        let turn = Deg(self.cycle_option(cycle, TURN)?);
        let start = self.call_point(cycle)?;
        let to_middle = self.way_to_middle(cycle, half)?;
        let place = Place { at: Place { at: start, turn }.point(to_middle), turn };
        let width = self.overlap(cycle, mill.radius)?;
        let pocket = self.pocket(cycle, mill, asked, Shape::Rectangle { half, corner }, (place, width))?;
        let plunging = self.plunging(cycle)?;
        let insertion = self.insertion(cycle, &pocket, plunging)?;
        self.milled(cycle, Pocket { insertion, home: Some(start), ..pocket })
    }

    /// Cycle 252.
    pub(super) fn circular_pocket(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Cycle>> {
        let Some((mill, asked)) = self.pocket_of(cycle, call)? else { return Ok(None) };
        let radius = self.above_zero(cycle, DIAMETER)? / 2.0;
        let place = Place { at: self.call_point(cycle)?, turn: Deg(0.0) };
        let width = self.overlap(cycle, mill.radius)?;
        let pocket = self.pocket(cycle, mill, asked, Shape::Circle { radius }, (place, width))?;
        let plunging = self.plunging(cycle)?;
        let insertion = self.insertion(cycle, &pocket, plunging)?;
        self.milled(cycle, Pocket { insertion, home: Some(place.at), ..pocket })
    }

    /// Cycle 253.
    pub(super) fn slot(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Cycle>> {
        let Some((mill, asked)) = self.pocket_of(cycle, call)? else { return Ok(None) };
        let (length, width) = (self.above_zero(cycle, FIRST_SIDE)?, self.above_zero(cycle, SECOND_SIDE)?);
        if length <= width {
            return self.refuse_value(cycle, codes::P2090::slot_length_q218_mm_is_not_above(&length, &width));
        }
        let half = (length - width) / 2.0;
        let turn = Deg(self.cycle_option(cycle, SLOT_TURN)?);
        let start = self.call_point(cycle)?;
        let position = self.choice(cycle, POSITION, 4)?;
        let to_middle = [0.0, length / 2.0, half, -half, -length / 2.0][position as usize];
        let place = Place { at: Place { at: start, turn }.point(Point2::new(to_middle, 0.0)), turn };
        let shape = Shape::Slot { from: -half, to: half, width };
        let pocket = self.pocket(cycle, mill, asked, shape, (place, mill.radius))?;
        let insertion = self.plunging_along(cycle, &pocket, 2.0 * half)?;
        let home = (position == 0).then_some(start);
        self.milled(cycle, Pocket { insertion, home, ..pocket })
    }

    /// Cycle 254.
    pub(super) fn circular_slot(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<Cycle>> {
        let Some((mill, asked)) = self.pocket_of(cycle, call)? else { return Ok(None) };
        let (width, radius) = (self.above_zero(cycle, SECOND_SIDE)?, self.above_zero(cycle, PITCH_CIRCLE)? / 2.0);
        let sweep = self.cycle_number(cycle, OPENING)?;
        if sweep <= 0.0 || sweep >= 360.0 {
            return self.refuse_value(cycle, codes::P2090::opening_angle_q248_is_not_above_0(&sweep));
        }
        let angle = self.cycle_number(cycle, START_ANGLE)?;
        let start = self.call_point(cycle)?;
        let (center, first) = match self.choice(cycle, POSITION, 3)? {
            0 if call.by == By::Pattern => {
                return self.cycle_otherwise(
                    cycle,
                    "a pattern of slots whose centre is Q216 and Q217 (Q367=0), so that every place would be the same slot,",
                    "write Q367=+2, so that the places are those of the middles of the slots",
                );
            }
            0 => (Point2::new(self.cycle_length(cycle, CENTER.0)?, self.cycle_length(cycle, CENTER.1)?), angle),
            2 => (start - Deg(angle).unit() * radius, angle - sweep / 2.0),
            other => {
                return self.refuse_cycle(cycle, codes::P9010::call_at_one_end_of_slot(&other));
            }
        };
        let count = if cycle.gives_q(NUMBER) { self.cycle_number(cycle, NUMBER)? } else { 1.0 };
        if count.fract() != 0.0 || !(1.0..=f64::from(MOST_SLOTS)).contains(&count) {
            return self.refuse_value(cycle, codes::P2090::number_of_slots_q377_is_not_1(&count, &MOST_SLOTS));
        }
        let step = self.cycle_option(cycle, STEP)?;
        self.budget.take(count as u64);
        let place = |i: u32| Place { at: center, turn: Deg(first + f64::from(i) * step) };
        let shape = Shape::Bow { radius, sweep: Deg(sweep), width };
        let pocket = self.pocket(cycle, mill, asked, shape, (place(0), mill.radius))?;
        let insertion = self.plunging_along(cycle, &pocket, radius * sweep * core::f64::consts::PI / 180.0)?;
        let places: Vec<Place> = (0..count as u32).map(place).collect();
        let middle = pocket.shape.middle();
        let middles = places.iter().map(|place| place.point(middle));
        self.warn_of_repeated_places("cycle 254", middles, cycle.loc);
        let made = self.milled(cycle, Pocket { insertion, places, ..pocket })?;
        Ok(made)
    }

    /// What all of them take.
    fn pocket_of(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome<Option<(Mill, Asked)>> {
        let Some(mill) = self.cutter_of(cycle, call)? else { return Ok(None) };
        self.feed_of_centre(cycle)?;
        let Some(asked) = self.asked(cycle, &mill)? else { return Ok(None) };
        if asked.floor {
            self.floor_in_one_cut(cycle, &mill)?;
        }
        Ok(Some((mill, asked)))
    }

    /// From the place of the call to the middle, by Q367.
    pub(super) fn way_to_middle(&mut self, cycle: &DefinedCycle, half: [f64; 2]) -> Outcome<Point2> {
        let [x, y] = half;
        let (x, y) = match self.choice(cycle, POSITION, 4)? {
            0 => (0.0, 0.0),
            1 => (x, y),
            2 => (-x, y),
            3 => (-x, -y),
            _ => (x, -y),
        };
        Ok(Point2::new(x, y))
    }

    /// The radius of the corners; 0 for that of the cutter, which is said.
    pub(super) fn corner_of(&mut self, cycle: &DefinedCycle, (word, corner): (&str, f64), radius: f64) -> Outcome<f64> {
        if corner >= radius {
            return Ok(corner);
        }
        self.report_once(
            codes::K8102::cycle_corners_get_radius_of_cutter(&cycle.number, &radius, &word, &corner)
                .at(self.here.origin.loc)
                .also(cycle.loc, "the cycle is defined here"),
        );
        Ok(0.0)
    }

    /// Does the cutter fit into the shape?
    pub(super) fn fits(&mut self, cycle: &DefinedCycle, shape: &Shape, radius: f64) -> Outcome<f64> {
        let room = shape.room(radius).least();
        if room >= -AS_WIDE {
            return Ok(room.max(0.0));
        }
        let what =
            format!("the cutter is {} mm wide, and there are {} mm", 2.0 * radius, rounded(2.0 * (room + radius)));
        self.tool_too_large(cycle, &what)
    }

    /// A pocket that is entered straight down.
    pub(super) fn pocket(
        &mut self,
        cycle: &DefinedCycle,
        mill: Mill,
        asked: Asked,
        shape: Shape,
        (place, width): (Place, f64),
    ) -> Outcome<Pocket> {
        let room = self.fits(cycle, &shape, mill.radius)?;
        // Finishing enters through what roughing has cleared, too.
        if (asked.rough || asked.wall) && room - asked.allowance < -1e-9 {
            let what = format!("the allowance Q368 = {} mm leaves the cutter no room", shown(asked.allowance));
            return self.tool_too_large(cycle, &what);
        }
        if asked.wall {
            let most = widest_allowance(&shape, mill.radius);
            self.finishing_meets_roughing(cycle, (asked.allowance, most), mill.radius)?;
        }
        let finish = (asked.wall || asked.floor).then_some(Finish {
            wall: asked.wall,
            floor: asked.floor,
            feed: asked.feed,
            step: asked.step,
            speed: None,
            onto: Onto::Quarter(room / 2.0),
            inserts: true,
        });
        Ok(Pocket {
            counter_clockwise: self.climbs(cycle)?,
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
            between: Between::Lifted,
            home: None,
        })
    }

    /// How the tool gets into a pocket: its ways keep the angle of the tool, and stay where roughing has room.
    fn insertion(&mut self, cycle: &DefinedCycle, pocket: &Pocket, plunging: Plunging) -> Outcome<Insertion> {
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
                    return self.no_room_to_plunge(cycle, 1);
                }
                Ok(Insertion::Helix { radius: about, pitch })
            }
            Plunging::Sway(angle) => {
                let stroke = match room {
                    Room::Rectangle([x, y]) => (2.0 * (x - y).abs()).max(2.0 * x.max(y) / 3.0),
                    Room::Around(half) => 2.0 * half / 3.0,
                };
                let stroke = stroke.min(4.0 * radius);
                if stroke < SMALLEST_WAY || parts(deep, stroke * libm::tan(angle.radians())) > MOST_LEVELS {
                    return self.no_room_to_plunge(cycle, 2);
                }
                Ok(Insertion::Sway { angle, stroke: Some(stroke) })
            }
        }
    }

    /// The way into a slot, along its middle line.
    fn plunging_along(&mut self, cycle: &DefinedCycle, pocket: &Pocket, length: f64) -> Outcome<Insertion> {
        let insertion = self.plunging(cycle)?.along();
        if let Insertion::Sway { angle, .. } = insertion {
            let deep = pocket.mill.heights.step.min(pocket.mill.heights.way());
            if length < SMALLEST_WAY || parts(deep, length * libm::tan(angle.radians())) > MOST_LEVELS {
                return self.no_room_to_plunge(cycle, 2);
            }
        }
        Ok(insertion)
    }

    pub(super) fn milled(&mut self, cycle: &DefinedCycle, pocket: Pocket) -> Outcome<Option<Cycle>> {
        self.budget.take(pocket.places.len() as u64);
        Ok(Some(Cycle::Pocket(self.sound(cycle, pocket)?)))
    }
}
