//! Pockets along a contour with islands: rings at growing distances from the walls, cut from inside out.

mod carriers;
mod course;
mod faults;
mod links;
mod loops;
mod peak;
mod pilot_holes;
mod rest;
mod roomiest;
mod rooms;
mod tool;
mod walls;

use crate::diag::{Fault, codes};
use crate::geo::{Deg, Point2, distance};
use crate::ir::cycle::milling::{MOST_LEVELS, Place, parts};
use crate::ir::cycle::pocket::{Finish, Insertion, WallApproach};
use crate::ir::cycle::{Family, Region};

use super::cutter::Cutter;
use super::pocket::{endless_strokes, strokes};
use super::{CycleItem, Expand, Start};
use course::{Course, Cut, Reach};
use faults::{no_room, start_point, unproved};
use loops::{Area, Part};
use rest::Cleared;
use rooms::{Entry, Room, Tree, peak_of};
use tool::Tool;
use walls::Walls;

/// Rooms for less than this are none, mm.
const NOTHING: f64 = 1e-4;
/// Radius of the arc on which a wall is approached, mm; it becomes smaller where the walls are near.
const APPROACH: f64 = 2.0;
const SMALLEST_APPROACH: f64 = 0.1;
/// Directions in which strokes to and fro are tried.
const STROKE_DIRECTIONS: u32 = 72;
/// Lengths of strokes to and fro, in radii of the cutter.
const STROKES: [f64; 12] = [16.0, 12.0, 10.0, 8.0, 6.0, 5.0, 4.0, 3.0, 2.0, 1.0, 0.5, 0.25];
/// Strokes that lead down to a level are no longer than two diameters where this many are enough.
const FEW_STROKES: f64 = 6.0;
/// How much the room of a place may lose against the step of the rings, mm.
const ROOM: f64 = 5e-3;
/// Widest step between rings, in radii of the cutter: where rings end on a middle line, one radius would just touch it, and a hair stay.
const WIDEST: f64 = 0.98;
/// How often rings are tried.
const MOST_TRIES: u32 = 6;

impl Expand for Region {
    fn expand(&self, start: &Start, out: &mut dyn FnMut(CycleItem)) -> Result<(), Fault> {
        self.check().map_err(|fault| codes::G3321::region_makes_no_path(&fault))?;
        let region = &self.on_grid();
        let walls = Walls::new(region.walls().copied().collect());
        let paths = Paths::new(region, &walls)?;
        let mut tool = Tool::new(region, &walls, Cutter::new(&region.mill, Place::HERE, start, out));
        for course in &paths.rough {
            tool.rough(course);
        }
        if let Some(finish) = &region.finish {
            if let Some(speed) = finish.speed {
                tool.cutter.speed(speed.finishing);
            }
            for part in &paths.wall {
                let most = match finish.onto {
                    WallApproach::Quarter(most) => Some(region.widest_arc(part, &walls).min(most)),
                    WallApproach::Usual | WallApproach::Semicircle => None,
                };
                tool.begin(part.outline);
                for ring in part.loops() {
                    tool.wall(ring, finish, most.unwrap_or(APPROACH));
                }
            }
            for course in &paths.floor {
                tool.floor(course, finish);
            }
            if let Some(after) = finish.speed.and_then(|speed| speed.after) {
                tool.cutter.speed(after);
            }
        }
        tool.cutter.retract();
        Ok(())
    }
}

/// All paths, which are known before the tool moves.
struct Paths {
    rough: Vec<Course>,
    wall: Vec<Part>,
    floor: Vec<Course>,
}

impl Paths {
    fn new(region: &Region, walls: &Walls) -> Result<Paths, Fault> {
        let area = Area::new(&region.outlines, &region.islands);
        let radius = region.mill.radius;
        let least = radius + region.allowance;
        let mut rough = match region.rough {
            true => region.rooms(&area, walls, least)?,
            false => Vec::new(),
        };
        if let Some(coarse) = &region.coarse {
            let cleared =
                Cleared::new(coarse, radius).ok_or_else(|| unproved(walls, coarse.radius + coarse.allowance))?;
            cleared.look_along(&mut rough);
        }
        let floor = match region.finish {
            Some(Finish { floor: true, wall, .. }) => {
                region.rooms(&area, walls, radius + if wall { region.left } else { region.allowance })?
            }
            _ => Vec::new(),
        };
        let wall = match region.finish {
            Some(Finish { wall: true, .. }) => {
                area.parts(radius + region.left, walls).ok_or_else(|| unproved(walls, radius + region.left))?
            }
            _ => Vec::new(),
        };
        if region.finish.is_some_and(|finish| finish.wall) && !area.has_all(&wall) {
            return Err(no_room());
        }
        for room in rough.iter().filter(|room| room.is_solid()) {
            region.check_insertion(&room.entry, least)?;
        }
        let rough = region.courses(&rough, walls);
        // A cutter that cannot go straight down, or shall not without a hole, must not have to.
        let is_plunged = |course: &Course| course.cuts.iter().any(|cut| cut.reach == Reach::Solid);
        if region.insertion != Insertion::Vertical && rough.iter().any(is_plunged) {
            return Err(codes::G3321::ring_can_only_be_reached_straight_down());
        }
        let floor = floor.iter().map(|room| Course::new(room, region, walls, room.entry.goes_on())).collect();
        Ok(Paths { rough, wall, floor })
    }
}

/// How far beside a ring a cutter surely clears the ground.
fn clears(radius: f64) -> f64 {
    (WIDEST * radius).min(radius - 2.0 * ROOM).max(radius / 2.0)
}

impl Region {
    /// The rooms of the area at `least` from the walls, with their rings.
    fn rooms(&self, area: &Area, walls: &Walls, least: f64) -> Result<Vec<Room>, Fault> {
        let fault = || unproved(walls, least);
        let roots = area.parts(least, walls).ok_or_else(fault)?;
        if !area.has_all(&roots) {
            return Err(no_room());
        }
        let (mut rooms, mut start) = (Vec::with_capacity(roots.len()), self.start);
        for root in &roots {
            let with_rings = self.with_rings(area, walls, root, &roots).ok_or_else(fault)?;
            let mut room = Room::new(with_rings, &mut start, self.mill.radius, walls).ok_or_else(fault)?;
            if self.rough {
                room.entry.stroke = self.stroke(room.entry.at, walls, least);
            }
            rooms.push(room);
        }
        if start.is_some() { Err(start_point()) } else { Ok(rooms) }
    }

    /// A part at the least distance from the walls, with all that lies deeper.
    fn with_rings(&self, area: &Area, walls: &Walls, root: &Part, roots: &[Part]) -> Option<Tree> {
        let (mut most, mut more) = (peak_of(root, walls)?.room, 0);
        for _ in 0..MOST_TRIES {
            match self.nested(area, walls, (root, roots), most, more) {
                // On a long ridge the most room may only be found in the innermost ring.
                Some((_, room)) if room > most + ROOM => most = room,
                Some((tree, _)) => return Some(tree),
                // A ring may lie where the area is just as wide: one ring more moves all of them.
                None => more += 1,
            }
        }
        None
    }

    /// The part with rings up to `most` from the walls, by so many rings more than the width of a cut asks for, and the most room in it; `None` where
    /// a ring is not at its distance from the walls, or misses.
    fn nested(
        &self,
        area: &Area,
        walls: &Walls,
        (root, roots): (&Part, &[Part]),
        most: f64,
        more: usize,
    ) -> Option<(Tree, f64)> {
        // Every point between two rings is at most a step from the outer one: a step of less than a radius leaves nothing.
        let count = parts(most - root.away, self.width.min(clears(self.mill.radius))) + more;
        let step = (most - root.away) / count as f64;
        let mut tree = Tree::new(root.clone());
        for depth in 1..count {
            let made = area.parts_of(root.outline, root.away + step * depth as f64, walls)?;
            let held = |part: &Part, by: &Part| by.outer.holds(part.outer.start());
            if !made.iter().all(|part| roots.iter().any(|root| held(part, root))) {
                return None;
            }
            tree.grow(made.into_iter().filter(|part| held(part, root)).collect(), depth)?;
        }
        let room = tree.look_for_peaks(walls, |part, room| {
            let is_deepest = part.away + step >= most - ROOM;
            room > part.away + step + ROOM && !is_deepest
        })?;
        Some((tree, room))
    }

    /// How the cutter goes through rooms that it roughs.
    fn courses(&self, rooms: &[Room], walls: &Walls) -> Vec<Course> {
        let from = |entry: &Entry| entry.then.unwrap_or_else(|| self.begin_of(entry));
        rooms.iter().map(|room| Course::new(room, self, walls, from(&room.entry))).collect()
    }

    /// Where the cutter goes down into solid material on a level; all levels are alike.
    fn places(&self, courses: &[Course]) -> Vec<Point2> {
        let of = |course: &Course| {
            let entry = course.entry.map(|entry| self.begin_of(&entry));
            let solid = course.cuts.iter().filter(|cut| cut.reach == Reach::Solid).map(Cut::start);
            entry.into_iter().chain(solid).collect::<Vec<_>>()
        };
        courses.iter().flat_map(of).collect()
    }

    /// Where the cutter stands over a place at which it is inserted.
    fn begin_of(&self, entry: &Entry) -> Point2 {
        let arm = self.helix_arm(entry.room, self.mill.radius + self.allowance);
        Point2::new(entry.at.x + if arm < SMALLEST_APPROACH { 0.0 } else { arm }, entry.at.y)
    }

    /// Half of the room that the cutter has between the walls of a part.
    fn widest_arc(&self, part: &Part, walls: &Walls) -> f64 {
        peak_of(part, walls).map_or(0.0, |peak| (peak.room - part.away) / 2.0)
    }

    /// Radius of the helix at a place that is `room` from the walls; 0 for one straight down.
    fn helix_arm(&self, room: f64, least: f64) -> f64 {
        match self.insertion {
            Insertion::Helix { radius, .. } => radius.min(room - least).min(self.mill.radius).max(0.0),
            Insertion::Predrilled | Insertion::Vertical | Insertion::Ramp { .. } | Insertion::Strokes { .. } => 0.0,
        }
    }

    /// The longest way from a place on which strokes to and fro keep off the walls: up to two diameters of the cutter, and farther where it
    /// would take many strokes to get down.
    fn stroke(&self, from: Point2, walls: &Walls, least: f64) -> Option<Point2> {
        let Insertion::Ramp { angle, .. } = self.insertion else { return None };
        let radius = self.mill.radius;
        let step = self.mill.heights.way() / self.mill.heights.levels().len() as f64;
        let few = step / libm::tan(angle.radians()) / FEW_STROKES;
        let lengths =
            STROKES.map(|part| part * radius).into_iter().filter(|length| *length <= few.max(4.0 * radius) + NOTHING);
        lengths.into_iter().find_map(|length| {
            let ends = (0..STROKE_DIRECTIONS).map(|i| {
                let (sin, cos) = Deg(360.0 * f64::from(i) / f64::from(STROKE_DIRECTIONS)).sin_cos();
                Point2::new(from.x + length * cos, from.y + length * sin)
            });
            ends.into_iter().find(|end| walls.is_free(from, *end, least))
        })
    }

    /// Is there room for the insertion, and does it end?
    fn check_insertion(&self, entry: &Entry, least: f64) -> Result<(), Fault> {
        let step = self.mill.heights.way() / self.mill.heights.levels().len() as f64;
        match (self.insertion, entry.stroke) {
            (Insertion::Helix { radius, .. }, _)
                if radius >= SMALLEST_APPROACH && self.helix_arm(entry.room, least) < SMALLEST_APPROACH =>
            {
                Err(codes::G3321::walls_leave_no_room_for_helix())
            }
            (Insertion::Ramp { .. }, None) => Err(codes::G3321::walls_leave_no_room_for_strokes()),
            (Insertion::Ramp { angle, .. }, Some(end))
                if strokes(step, distance(entry.at, end), angle) > MOST_LEVELS =>
            {
                Err(endless_strokes())
            }
            _ => Ok(()),
        }
    }
}
