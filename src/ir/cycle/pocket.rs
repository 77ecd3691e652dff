//! Arguments of pockets and slots: areas that are cleared from inside out, level by level.

use crate::geo::tolerance;
use core::fmt;

use crate::geo::{Deg, Point2};
use crate::ir::{Feed, Pos};

use super::Family;
use super::milling::{MOST_LEVELS, Mill, MillFault, Place, parts};

/// Most rings of a level; more is a lost decimal point.
pub const MOST_RINGS: f64 = 10_000.0;
/// Radius of the arc on which a wall is approached, mm.
const APPROACH: f64 = 2.0;

/// A pocket or slot, at one or more places. Lengths in mm.
#[derive(Debug, Clone, PartialEq)]
pub struct Pocket {
    /// Plane, heights, cutter and feeds.
    pub mill: Mill,
    /// The finished outline, about its own origin.
    pub shape: Shape,
    /// One at least; the shape is milled at one after the other.
    pub places: Vec<Place>,
    /// Sense in which the tool goes round, seen against the plane normal.
    pub counter_clockwise: bool,
    /// Allowance on the wall that roughing leaves, 0 or more.
    pub allowance: f64,
    /// Greatest width of a cut; above 0, at most the diameter of the cutter.
    pub width: f64,
    /// How roughing gets to a level, and finishing to the floor where [`Finish::inserts`] says so.
    pub insertion: Insertion,
    /// Level by level, or on helices down to the floor; the latter for circles only.
    pub strategy: Strategy,
    /// The pocket is roughed down to the allowances. Without it `finish` is given.
    pub rough: bool,
    /// The finishing cuts after roughing; `None` for none.
    pub finish: Option<Finish>,
    /// A pocket within this one that was cleared before; `None` where all is solid.
    pub cleared: Option<Cleared>,
    /// Feed on the arc from place to place at the retract height; straight at rapid traverse without one.
    pub transfer: Option<Feed>,
    /// How the tool gets from one level to the insertion of the next.
    pub between: LevelChange,
    /// Over this point of the plane, mm, the tool stands in the end; `None`: over the entry of the last place.
    pub home: Option<Point2>,
}

/// From the end of one level to the insertion of the next.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LevelChange {
    /// Straight on the level, at the feed of the plane.
    Straight,
    /// Off the wall on an arc, up by the safety distance, and over cleared ground at rapid traverse.
    Lifted,
}

/// The finished outline, about its own origin. Lengths in mm, in the axes of the place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// Half the sizes along both axes, `half`, and the radius of the corners, `corner`: 0 for corners of the cutter,
    /// else not below its radius nor above half of the smaller size.
    Rectangle { half: [f64; 2], corner: f64 },
    /// About the origin by `radius`.
    Circle { radius: f64 },
    /// Along the first axis between the centres of its round ends: coordinates `from` and `to`, the latter the greater
    /// one; `width` across.
    Slot { from: f64, to: f64, width: f64 },
    /// About the origin at the distance `radius`, from the first axis on by `sweep`, counter-clockwise, over 0 and
    /// below 360 degrees, between the centres of its round ends; `width` across, less than twice the radius.
    Bow { radius: f64, sweep: Deg, width: f64 },
}

/// How the tool gets to a level.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Insertion {
    /// At rapid traverse into a hole that was drilled before at the entry.
    Predrilled,
    /// Straight down into the material.
    Vertical,
    /// On a helix about the entry: `radius` of the centre's path in mm at most, 0 or more, as far as there is room, and
    /// the greatest `pitch` in mm, over 0.
    Helix { radius: f64, pitch: f64 },
    /// To and fro, falling by at most `angle`, below 90 degrees; 0 for one stroke. Along slots, else on the long axis
    /// as far as there is room.
    Ramp {
        angle: Deg,
        /// Greatest length of a stroke, mm; that of the long axis without one. A slot does not look at it.
        stroke: Option<f64>,
    },
    /// To and fro along the middle line of a slot down to its floor, at the feed of the plane: whole falls by `fall` mm
    /// a stroke, over 0, and the rest at last.
    Strokes { fall: f64 },
}

/// The way down.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Strategy {
    /// Level by level.
    Levels,
    /// Circle by circle from inside out, each on a helix down to the floor.
    Helix,
}

/// The finishing cuts: the wall first, then the floor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Finish {
    /// The wall is cut, down to what roughing leaves on the floor.
    pub wall: bool,
    /// The floor is cut to its depth.
    pub floor: bool,
    /// Feed in the plane, above 0.
    pub feed: Feed,
    /// Greatest infeed in depth along the wall, mm; 0 for one cut.
    pub step: f64,
    /// Speeds of the spindle around the finishing cuts; `None` leaves the one in force.
    pub speed: Option<Speed>,
    /// How the cut along the wall begins and ends.
    pub onto: WallApproach,
    /// The floor is entered as roughing enters a level; else straight down.
    pub inserts: bool,
}

/// How a finishing cut comes to the wall and leaves it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum WallApproach {
    /// On quarters of a circle of the usual radius, [`APPROACH`], as far as there is room.
    Usual,
    /// On quarters of a circle of this radius in mm, or of the allowance where that is larger, as far as there is room.
    Quarter(f64),
    /// On semicircles from the middle line of a slot.
    Semicircle,
}

/// Speeds of the spindle in rev/min: while it finishes, and afterwards where that is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Speed {
    /// From before the first finishing cut.
    pub finishing: f64,
    /// After the last finishing cut; `None` leaves the one for finishing.
    pub after: Option<f64>,
}

/// A pocket of the same form about the same centre that was cleared before. Lengths in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cleared {
    /// Half the sizes along both axes; for a circle its radius in both.
    pub half: [f64; 2],
    /// Depth below the surface, 0 or more.
    pub depth: f64,
}

/// The paths of the cutter's centre lie within this, seen from the middle line of the shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Room {
    /// Half sizes along both axes, mm.
    Rectangle([f64; 2]),
    /// This distance in mm to both sides of the middle line, or around the centre.
    Around(f64),
}

/// Arguments that make no pocket.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PocketFault {
    /// Plane, heights, cutter or feeds.
    Mill(MillFault),
    /// A size, an allowance or an infeed is no number or below 0.
    Number,
    /// The cutter with the allowance is larger than the pocket.
    Cutter,
    /// The corners are smaller than the cutter, or larger than the pocket.
    Corner,
    /// The width of a cut is not above 0, or larger than the cutter.
    Width,
    /// The pitch of the helix is not above 0, or the angle not below 90 degrees.
    Insertion,
    /// The helix falls by so little that its turns do not end.
    Pitch,
    /// The infeed of the finishing cuts is so small that they do not end.
    FinishingStep,
    /// The middle line is shorter than nothing, or turns about itself.
    Length,
    /// A level has more than [`MOST_RINGS`] rings.
    TooManyRings,
    /// Nothing is asked for.
    Nothing,
}

impl fmt::Display for PocketFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            PocketFault::Mill(fault) => return fault.fmt(f),
            PocketFault::Number => "a size of the pocket is not a number, or below 0",
            PocketFault::Cutter => "the cutter and the allowance on the wall do not fit into the pocket",
            PocketFault::Corner => {
                "the radius of the corners lies between that of the cutter and half of the smaller side"
            }
            PocketFault::Width => "the infeed in the plane is above 0, and at most the diameter of the cutter",
            PocketFault::Insertion => "the pitch of the helix is above 0, and the angle below 90 degrees",
            PocketFault::Pitch => "the pitch of the helix is so small that its turns do not end",
            PocketFault::FinishingStep => "the infeed in depth of the finishing cuts is so small that they do not end",
            PocketFault::Length => "the slot is no longer than it is wide, or its arc is longer than a turn",
            PocketFault::TooManyRings => "the infeed in the plane is so small that the rings do not end",
            PocketFault::Nothing => "neither roughing nor finishing is asked for",
        })
    }
}

impl Shape {
    /// What is left for the centre of the cutter at `distance` mm from the wall; below 0 where there is no room.
    pub fn room(&self, distance: f64) -> Room {
        match *self {
            Shape::Rectangle { half, .. } => Room::Rectangle(half.map(|size| size - distance)),
            Shape::Circle { radius } => Room::Around(radius - distance),
            Shape::Slot { width, .. } | Shape::Bow { width, .. } => Room::Around(width / 2.0 - distance),
        }
    }

    /// Where the tool is inserted, and over which it stands in the end, in the axes of the shape.
    pub fn entry(&self) -> Point2 {
        match *self {
            Shape::Rectangle { .. } | Shape::Circle { .. } => Point2::origin(),
            Shape::Slot { from, .. } => Point2::new(from, 0.0),
            Shape::Bow { radius, .. } => Point2::new(radius, 0.0),
        }
    }

    /// The middle of the middle line, in the axes of the shape.
    pub fn middle(&self) -> Point2 {
        match *self {
            Shape::Rectangle { .. } | Shape::Circle { .. } => Point2::origin(),
            Shape::Slot { from, to, .. } => Point2::new((from + to) / 2.0, 0.0),
            Shape::Bow { radius, sweep, .. } => Point2::origin() + Deg(sweep.0 / 2.0).unit() * radius,
        }
    }

    /// Largest radius in mm of a helix about the entry whose centre's path keeps `distance` mm from the wall.
    pub fn helix_room(&self, distance: f64) -> f64 {
        self.room(distance).least()
    }

    fn numbers(&self) -> ([f64; 4], bool) {
        match *self {
            Shape::Rectangle { half, corner } => ([half[0], half[1], corner, 0.0], true),
            Shape::Circle { radius } => ([radius, 0.0, 0.0, 0.0], true),
            Shape::Slot { from, to, width } => ([width, from.abs(), to.abs(), 0.0], to > from),
            Shape::Bow { radius, sweep, width } => {
                ([radius, sweep.0, width, 0.0], sweep.0 > 0.0 && sweep.0 < 360.0 && radius > width / 2.0)
            }
        }
    }
}

impl Insertion {
    /// Do the turns of a helix end?
    pub fn ends(&self, mill: &Mill) -> bool {
        match self {
            Insertion::Helix { pitch, .. } => {
                let heights = &mill.heights;
                let level = heights.way() / parts(heights.way(), heights.step) as f64;
                parts(level, *pitch) <= MOST_LEVELS
            }
            Insertion::Strokes { fall } => parts(mill.heights.way(), *fall) <= MOST_LEVELS,
            Insertion::Predrilled | Insertion::Vertical | Insertion::Ramp { .. } => true,
        }
    }
}

impl Room {
    /// The smaller half, mm.
    pub fn least(self) -> f64 {
        match self {
            Room::Rectangle([x, y]) => x.min(y),
            Room::Around(half) => half,
        }
    }
}

impl Pocket {
    /// Distance of the cutter's centre from the wall while roughing, mm.
    pub fn rough_distance(&self) -> f64 {
        self.mill.radius + self.allowance
    }

    /// The radius of the helix in mm, of `asked`: it stays in the pocket, and leaves no core.
    pub fn helix_radius(&self, asked: f64) -> f64 {
        let radius = self.mill.radius;
        asked.min(radius).min(self.shape.helix_room(self.rough_distance())).max(0.0)
    }

    /// Half of the longest stroke to and fro, mm.
    pub fn sway_room(&self) -> f64 {
        match (self.shape, self.shape.room(self.rough_distance())) {
            (Shape::Slot { from, to, .. }, _) => (to - from) / 2.0,
            (Shape::Bow { radius, sweep, .. }, _) => radius * sweep.radians() / 2.0,
            (_, Room::Rectangle([x, y])) => x.max(y).max(0.0),
            (_, Room::Around(half)) => half.max(0.0),
        }
    }

    /// Radius in mm of the arc on which the finishing cut comes to the wall; at most the room that the cutter has.
    pub fn approach_radius(&self) -> f64 {
        let room = self.shape.room(self.mill.radius).least();
        let asked = match self.finish.map(|finish| finish.onto) {
            Some(WallApproach::Semicircle) => return room / 2.0,
            Some(WallApproach::Quarter(radius)) => radius,
            Some(WallApproach::Usual) | None => APPROACH,
        };
        asked.max(self.allowance).min(room)
    }

    /// Does roughing end in the middle of a slot, to which it goes from the end of the last stroke?
    pub fn ends_in_the_middle(&self) -> bool {
        matches!(self.insertion, Insertion::Strokes { .. }) && self.rough && self.finish.is_none()
    }

    /// Was all cleared before at `height` that the cutter reaches from a ring with these half sizes and corners, in mm?
    pub fn is_cleared(&self, half: [f64; 2], corner: f64, height: f64) -> bool {
        let Some(cleared) = self.cleared.filter(|cleared| self.is_above_cleared(cleared, height)) else { return false };
        let radius = self.mill.radius;
        let (swept, round) = (half.map(|size| size + radius), corner + radius);
        let least = cleared.half[0].min(cleared.half[1]);
        let outer = match self.shape {
            Shape::Rectangle { corner, .. } => corner.max(radius).min(least),
            Shape::Circle { .. } => least,
            Shape::Slot { .. } | Shape::Bow { .. } => return false,
        };
        let beyond = [0, 1].map(|i| swept[i] - round - (cleared.half[i] - outer));
        let fits = (0..2).all(|i| swept[i] <= cleared.half[i] + tolerance::LOST);
        let in_corner = beyond.iter().all(|way| *way > 0.0);
        fits && (!in_corner || libm::hypot(beyond[0], beyond[1]) + round <= outer + tolerance::LOST)
    }

    fn is_above_cleared(&self, cleared: &Cleared, height: f64) -> bool {
        let heights = &self.mill.heights;
        (heights.reference - height) * heights.outward() <= cleared.depth + tolerance::LOST
    }
}

impl Family for Pocket {
    type Fault = PocketFault;

    fn check(&self) -> Result<(), PocketFault> {
        self.mill.check().map_err(PocketFault::Mill)?;
        let radius = self.mill.radius;
        let (sizes, long) = self.shape.numbers();
        let usable = |v: f64| v.is_finite() && v >= 0.0;
        let places = self.places.iter().flat_map(|place| [place.at.x, place.at.y, place.turn.0]);
        let cleared = self.cleared.map_or([0.0; 3], |cleared| [cleared.half[0], cleared.half[1], cleared.depth]);
        let finish = self.finish.map_or([0.0, 1.0], |finish| [finish.step, finish.feed.value()]);
        let numbers = sizes.into_iter().chain(cleared).chain(finish).chain([self.allowance]);
        let fits = |distance: f64| self.shape.room(distance).least() >= -tolerance::LOST;
        let round = match self.shape {
            Shape::Rectangle { half, corner } => {
                (corner == 0.0 || corner >= radius - tolerance::LOST)
                    && corner <= half[0].min(half[1]) + tolerance::LOST
            }
            Shape::Circle { .. } | Shape::Slot { .. } | Shape::Bow { .. } => true,
        };
        let insertion = match self.insertion {
            Insertion::Predrilled | Insertion::Vertical => true,
            Insertion::Helix { radius, pitch } => usable(radius) && pitch > 0.0 && pitch.is_finite(),
            Insertion::Ramp { angle, stroke } => (0.0..90.0).contains(&angle.0) && stroke.is_none_or(usable),
            Insertion::Strokes { fall } => {
                fall > 0.0 && fall.is_finite() && matches!(self.shape, Shape::Slot { .. } | Shape::Bow { .. })
            }
        };
        let circle = matches!(self.shape, Shape::Circle { .. });
        let endless = match self.insertion {
            Insertion::Strokes { .. } => PocketFault::Mill(MillFault::TooManyLevels),
            Insertion::Predrilled | Insertion::Vertical | Insertion::Helix { .. } | Insertion::Ramp { .. } => {
                PocketFault::Pitch
            }
        };
        let rings = self.shape.room(radius).least() / self.width;
        let rules = [
            (numbers.into_iter().all(usable) && places.into_iter().all(f64::is_finite), PocketFault::Number),
            (finish[1] > 0.0, PocketFault::Mill(MillFault::Feed)),
            (long, PocketFault::Length),
            (fits(radius) && (!self.rough || fits(self.rough_distance())), PocketFault::Cutter),
            (round, PocketFault::Corner),
            (self.width > 0.0 && self.width <= 2.0 * radius + tolerance::LOST, PocketFault::Width),
            (rings <= MOST_RINGS, PocketFault::TooManyRings),
            (self.insertion.ends(&self.mill), endless),
            (parts(self.mill.heights.way(), finish[0]) <= MOST_LEVELS, PocketFault::FinishingStep),
            (insertion && (self.strategy == Strategy::Levels || circle), PocketFault::Insertion),
            (self.rough || self.finish.is_some_and(|finish| finish.wall || finish.floor), PocketFault::Nothing),
            (!self.places.is_empty(), PocketFault::Nothing),
        ];
        rules.iter().find(|(good, _)| !good).map_or(Ok(()), |(_, fault)| Err(*fault))
    }

    fn moves(&self) -> f64 {
        let heights = &self.mill.heights;
        let rings = parts(self.shape.room(self.mill.radius).least(), self.width) as f64;
        let turns = |step: f64| parts(heights.way(), step) as f64;
        let strokes = match self.insertion {
            Insertion::Strokes { fall } => turns(fall),
            Insertion::Predrilled | Insertion::Vertical | Insertion::Helix { .. } | Insertion::Ramp { .. } => 0.0,
        };
        let rough = if self.rough { 10.0 * rings * turns(heights.step) + strokes } else { 0.0 };
        let finish = self.finish.map_or(0.0, |finish| 16.0 * turns(finish.step) + 10.0 * rings);
        (rough + finish) * self.places.len() as f64
    }

    /// It ends above the entry of the last place, or at home.
    fn leaves(&self, at: &mut Pos) {
        if let Some(place) = self.places.last() {
            let last = if self.ends_in_the_middle() { self.shape.middle() } else { self.shape.entry() };
            let end = self.home.unwrap_or_else(|| place.point(last));
            self.mill.leaves_above(end, at);
        }
    }
}
