//! Pockets along a contour with islands: rings at growing distances from the walls, cut from inside out.

mod carriers;
mod faults;
mod loops;
mod pilot_holes;
mod rest;
mod tool;
mod walls;

use crate::diag::codes;
use crate::geo::wall::quarters;
use crate::geo::{Deg, Point2, distance};
use crate::ir::cycle::milling::{MOST_LEVELS, Place, parts};
use crate::ir::cycle::pocket::{Finish, Insertion, Onto};
use crate::ir::cycle::{Family, Region};

use super::cutter::Cutter;
use super::pocket::{endless_strokes, strokes};
use super::track::Failure;
use super::{CycleItem, Expand, Start};
use faults::{no_insertion, no_room, start_point, unproved};
use loops::{Area, Entry, Part};
use rest::Cleared;
use tool::{Places, Tool};
use walls::{Walls, roomiest};

/// Rooms for less than this are none, mm.
const NOTHING: f64 = 1e-4;
/// Radius of the arc on which a wall is approached, mm; it becomes smaller where the walls are near.
const APPROACH: f64 = 2.0;
const SMALLEST_APPROACH: f64 = 0.1;
/// Directions in which strokes to and fro are tried.
const STROKE_DIRECTIONS: u32 = 72;
/// How much the room of a place may lose against the step of the rings, mm.
const ROOM: f64 = 5e-3;
/// How often rings are tried.
const MOST_TRIES: u32 = 6;

impl Expand for Region {
    fn expand(&self, start: &Start, out: &mut dyn FnMut(CycleItem)) -> Result<(), Failure> {
        let help = "check the contour, the data of the cutter, and the allowances";
        self.check().map_err(|fault| Failure::new(codes::G3321, fault.to_string(), help))?;
        let walls = Walls::new(self.walls().copied().collect());
        let area = Area::new(&self.outlines, &self.islands);
        let radius = self.mill.radius;
        // All rings are known before the tool moves.
        let mut rough = match self.rough {
            true => self.rings(&area, &walls, radius + self.allowance)?,
            false => Vec::new(),
        };
        if let Some(coarse) = &self.coarse {
            let cleared =
                Cleared::new(coarse, radius).ok_or_else(|| unproved(&walls, coarse.radius + coarse.allowance))?;
            cleared.look_along(&mut rough);
        }
        let floor = match self.finish {
            Some(Finish { floor: true, wall, .. }) => {
                self.rings(&area, &walls, radius + if wall { self.left } else { self.allowance })?
            }
            _ => Vec::new(),
        };
        let wall = match self.finish {
            Some(Finish { wall: true, .. }) => {
                area.parts(radius + self.left, &walls).ok_or_else(|| unproved(&walls, radius + self.left))?
            }
            _ => Vec::new(),
        };
        if self.finish.is_some_and(|finish| finish.wall) && !area.has_all(&wall) {
            return Err(no_room());
        }
        for part in &rough {
            self.check_insertion(part, radius + self.allowance)?;
        }
        // A cutter that cannot go straight down, or shall not without a hole, must not have to.
        if self.insertion != Insertion::Vertical && self.places(&rough, &walls, start).is_plunged {
            return Err(no_insertion("a ring of the pocket can only be reached straight down"));
        }
        let mut tool = Tool::new(self, &walls, Cutter::new(&self.mill, Place::HERE, start, out));
        tool.rough(&rough);
        if let Some(finish) = &self.finish {
            if let Some(speed) = finish.speed {
                tool.cutter.speed(speed.finishing);
            }
            for part in &wall {
                let most = match finish.onto {
                    Onto::Quarter(most) => Some(self.widest_arc(part, &walls).min(most)),
                    Onto::Usual | Onto::Semicircle => None,
                };
                tool.begin(part);
                for ring in part.loops() {
                    tool.wall(ring, finish, most.unwrap_or(APPROACH));
                }
            }
            for part in &floor {
                tool.begin(part);
                tool.floor(part, finish);
            }
            if let Some(after) = finish.speed.and_then(|speed| speed.after) {
                tool.cutter.speed(after);
            }
        }
        tool.cutter.retract();
        Ok(())
    }
}

impl Region {
    /// Parts of the area at `least` from the walls, with all that lies deeper.
    fn rings(&self, area: &Area, walls: &Walls, least: f64) -> Result<Vec<Part>, Failure> {
        let fault = || unproved(walls, least);
        let roots = area.parts(least, walls).ok_or_else(fault)?;
        if !area.has_all(&roots) {
            return Err(no_room());
        }
        let mut most = 0.0f64;
        for root in &roots {
            most = most.max(entry(root, walls).ok_or_else(fault)?.room);
        }
        let mut more = 0;
        for _ in 0..MOST_TRIES {
            match self.nested(area, walls, &roots, (least, most), more) {
                // On a long ridge the most room may only be found in the innermost ring.
                Some(entered) if entered.room > most + ROOM => most = entered.room,
                Some(Entered { parts, taken: true, .. }) => return Ok(parts),
                Some(_) => return Err(start_point()),
                // A ring may lie where the area is just as wide: one ring more moves all of them.
                None => more += 1,
            }
        }
        Err(fault())
    }

    /// The parts by rings from `least` to `most` from the walls, by so many rings more than the width of a cut asks for; `None` where a
    /// ring is not at its distance from the walls, or misses.
    fn nested(
        &self,
        area: &Area,
        walls: &Walls,
        roots: &[Part],
        (least, most): (f64, f64),
        more: usize,
    ) -> Option<Entered> {
        // Every point between two rings is at most a step from the outer one: a step of a radius leaves nothing.
        let count = parts(most - least, self.width.min(self.mill.radius)) + more;
        let step = (most - least) / count as f64;
        let mut levels = vec![roots.to_vec()];
        for j in 1..count {
            levels.push(area.parts(least + step * j as f64, walls)?);
        }
        let mut inner: Vec<Part> = Vec::new();
        while let Some(mut outer) = levels.pop() {
            for part in inner {
                let at = part.outer.start();
                outer.iter_mut().find(|holder| holder.holds(at))?.inner.push(part);
            }
            inner = outer;
        }
        let mut entered = Entered { parts: Vec::new(), taken: self.start.is_none(), room: 0.0 };
        for part in &mut inner {
            self.enter(part, walls, (least, step, most), &mut entered)?;
        }
        Some(Entered { parts: inner, ..entered })
    }

    /// Where the cutter goes down into solid material on a level; all levels are alike.
    fn places(&self, rough: &[Part], walls: &Walls, start: &Start) -> Places {
        let mut nothing = |_: CycleItem| ();
        let mut tool = Tool::new(self, walls, Cutter::new(&self.mill, Place::HERE, start, &mut nothing));
        let heights = self.mill.heights;
        for part in rough {
            let least = self.mill.radius + self.allowance;
            tool.level(part, least, heights.reference, heights.rough_floor(), self.mill.feeds.plane);
        }
        tool.places
    }

    /// Half of the room that the cutter has between the walls of a part.
    fn widest_arc(&self, part: &Part, walls: &Walls) -> f64 {
        entry(part, walls).map_or(0.0, |entry| (entry.room - part.away) / 2.0)
    }

    /// Radius of the helix at a place that is `room` from the walls; 0 for one straight down.
    fn helix_arm(&self, room: f64, least: f64) -> f64 {
        match self.insertion {
            Insertion::Helix { radius, .. } => radius.min(room - least).min(self.mill.radius).max(0.0),
            Insertion::Predrilled | Insertion::Vertical | Insertion::Sway { .. } | Insertion::Strokes { .. } => 0.0,
        }
    }

    /// The longest way from a place on which strokes to and fro keep off the walls, up to two diameters of the cutter.
    fn stroke(&self, from: Point2, walls: &Walls, least: f64) -> Option<Point2> {
        let lengths = [4.0, 3.0, 2.0, 1.0, 0.5, 0.25].map(|part| part * self.mill.radius);
        lengths.into_iter().find_map(|length| {
            let ends = (0..STROKE_DIRECTIONS).map(|i| {
                let (sin, cos) = Deg(360.0 * f64::from(i) / f64::from(STROKE_DIRECTIONS)).sin_cos();
                Point2::new(from.x + length * cos, from.y + length * sin)
            });
            ends.into_iter().find(|end| walls.is_free(from, *end, least))
        })
    }

    /// Is there room for the insertion, and does it end?
    fn check_insertion(&self, part: &Part, least: f64) -> Result<(), Failure> {
        for inner in &part.inner {
            self.check_insertion(inner, least)?;
        }
        let Some(entry) = part.entry.filter(|_| part.is_inserted()) else { return Ok(()) };
        let step = self.mill.heights.way() / self.mill.heights.levels().len() as f64;
        match (self.insertion, entry.stroke) {
            (Insertion::Helix { radius, .. }, _)
                if radius >= SMALLEST_APPROACH && self.helix_arm(entry.room, least) < SMALLEST_APPROACH =>
            {
                Err(no_insertion("the walls leave no room for the helix"))
            }
            (Insertion::Sway { .. }, None) => Err(no_insertion("the walls leave no room for strokes to and fro")),
            (Insertion::Sway { angle, .. }, Some(end))
                if strokes(step, distance(entry.at, end), angle) > MOST_LEVELS =>
            {
                Err(endless_strokes())
            }
            _ => Ok(()),
        }
    }

    /// Finds where the tool is inserted into the parts that have nothing deeper. The start point counts for the first of them that
    /// is reached from there.
    fn enter(&self, part: &mut Part, walls: &Walls, ways: (f64, f64, f64), entered: &mut Entered) -> Option<()> {
        let (least, step, most) = ways;
        for inner in &mut part.inner {
            self.enter(inner, walls, ways, entered)?;
        }
        if !part.inner.is_empty() {
            return Some(());
        }
        let found = entry(part, walls)?;
        // With more room than a step there is a ring inside, or something would stay in the middle.
        let is_deepest = part.away + step >= most - ROOM;
        if found.room > part.away + step + ROOM && !is_deepest {
            return None;
        }
        entered.room = entered.room.max(found.room);
        let stroke = |from: Point2| match self.insertion {
            Insertion::Sway { .. } if self.rough => self.stroke(from, walls, least),
            _ => None,
        };
        part.entry = Some(Entry { stroke: stroke(found.at), ..found });
        let (Some(start), false) = (self.start, entered.taken) else { return Some(()) };
        let then = (!part.holds(start)).then_some(found.at);
        if then.is_none_or(|then| walls.is_free(start, then, least)) {
            part.entry = Some(Entry { at: start, room: walls.distance(start), then, stroke: stroke(start) });
            entered.taken = true;
        }
        Some(())
    }
}

/// The point of a part that is farthest from the walls, and how far it is.
fn entry(part: &Part, walls: &Walls) -> Option<Entry> {
    // A circle reaches farther than its ends.
    let points = part.outer.elements.iter().flat_map(quarters).map(|piece| piece.from());
    let (mut low, mut high) = (Point2::new(f64::MAX, f64::MAX), Point2::new(f64::MIN, f64::MIN));
    for p in points {
        low = Point2::new(low.x.min(p.x), low.y.min(p.y));
        high = Point2::new(high.x.max(p.x), high.y.max(p.y));
    }
    let found = roomiest(low, high, |p| if part.holds(p) { walls.distance(p) } else { -part.outer.away(p) });
    found.map(|(at, room)| Entry { at, room, then: None, stroke: None })
}

fn entry_of(part: &Part, least: f64) -> Entry {
    part.entry.unwrap_or(Entry { at: part.outer.start(), room: least, then: None, stroke: None })
}

/// Parts in which the tool is inserted.
struct Entered {
    parts: Vec<Part>,
    /// A start point that was asked for is used, or none was.
    taken: bool,
    /// The most room that was found.
    room: f64,
}
