//! Arcs: centre, sense, turns, and every place on the way, whether an arc is printed in one block, in several, or as lines.

use crate::geo::tolerance;
use core::f64::consts::TAU;

use crate::geo::distance;
use crate::ir::Feed;
use crate::ir::motion::{Arc, Move};
use crate::read::{self, AXES, Act, SCALE};

use super::moves::kind;
use super::{Text, Validator, Why, is_rounding, plane};

/// What the radii at both ends of a printed arc may differ by, where the receiver allows that, and how far its centre may lie
/// from the exact one on each axis, in units of the last place.
pub(super) const MOST_OFF: f64 = 1.5;
/// By how many units the printed ends and the printed centre turn the ends of an arc about its centre.
const TURNED: f64 = 6.0;
/// Places at which that is looked at.
const LOOKS: u32 = 96;
/// How far from the circle the middle of a line may be that stands for a part of it.
pub(super) const CHORD: f64 = 1.3;
/// What an angle in degrees of four places may be off, in rad,
const ANGLE: f64 = 1e-6;
/// and the printed ends and centre beside it, in units of the last place.
const MENDED: f64 = 4.0;
/// Below so many units of radius a circle is lost between its places: that it stays there is all that can be said.
const LOST: f64 = 3.0;

/// An arc as it is followed from block to block, in units of the reader.
struct Course {
    center: [f64; 2],
    radius: f64,
    sweep: f64,
    /// What of it was printed.
    swept: f64,
    blocks: f64,
    /// The blocks are lines; they are all of one kind.
    as_lines: bool,
    /// The last block was an arc whose end is as exact as its angle: a line leads to where it is meant to end.
    open: bool,
    /// F of its first block.
    feed: i64,
}

impl Validator {
    pub(super) fn check_arc(&mut self, mv: &Move, arc: &Arc, feed: Feed, text: Text<'_>) -> Result<(), Why> {
        let Text { bytes: mut rest, mut end } = text;
        let scale = SCALE as f64;
        let mut course = Course {
            center: [arc.center.x * scale, arc.center.y * scale],
            radius: distance(arc.from, arc.center) * scale,
            sweep: arc.sweep,
            swept: 0.0,
            blocks: 0.0,
            as_lines: false,
            open: false,
            feed: 0,
        };
        let [first, second, _] = plane(arc.plane).axes();
        let (start, known) = (*self.reader.at(), self.reader.known());
        let mut from = [start[first], start[second]];
        let mut printed = 0;
        self.before = start;
        while let Some(act) = self.reader.next(&mut rest, &mut end)? {
            let Act::Move(found) = act else { return Err(Why::new("an arc is meant")) };
            if self.strays(found.axes, mv) || found.machine {
                return Err(Why::new("an axis moves that shall stand"));
            }
            let to = [self.reader.at()[first], self.reader.at()[second]];
            let line = matches!(found.path, read::Path::Line);
            if std::mem::take(&mut course.open) {
                self.mends(&course, from, to, line)?;
                self.feed_of_part(&mut course, feed)?;
                printed |= found.axes;
                from = to;
                continue;
            }
            if course.blocks > 0.0 && line != course.as_lines {
                return Err(Why::new("an arc is either arcs or lines"));
            }
            course.as_lines = line;
            course.blocks += 1.0;
            course.swept += match found.path {
                read::Path::Arc(found) => self.part(&course, &found, arc)?,
                read::Path::Line => self.chord(&course, from, to)?,
                read::Path::Rapid | read::Path::Thread(_) => return Err(Why::new("an arc is meant")),
            };
            self.same_side(mv)?;
            self.feed_of_part(&mut course, feed)?;
            printed |= found.axes;
            course.open = matches!(found.path, read::Path::Arc(part) if part.by_angle && part.from != part.to);
            if end > 0 && !course.open {
                self.on_the_way(&course, mv, &start, known, [first, second])?;
            }
            from = to;
        }
        self.leads(mv, printed)?;
        let room = TURNED * self.unit * course.blocks.max(1.0) + course.radius * course.sweep.abs() * 1e-9;
        let off = (course.swept - course.sweep).abs() * course.radius;
        if course.radius > LOST * self.unit && off > room {
            return Err(Why::new("the arc turns another way, or another number of times"));
        }
        match feed {
            // The blocks share the time.
            Feed::InverseTime(f)
                if course.blocks > 0.0
                    && course.radius > LOST * self.unit
                    && !is_rounding(course.feed, f * course.blocks, self.grain.inverse_time) =>
            {
                Err(Why::new("the blocks of the arc take another time"))
            }
            Feed::InverseTime(_) | Feed::PerMinute(_) | Feed::PerRevolution(_) => Ok(()),
        }
    }

    /// A line from where the angle of an arc leads to where the arc is meant to end.
    fn mends(&self, course: &Course, from: [i64; 2], to: [i64; 2], line: bool) -> Result<(), Why> {
        let way = libm::hypot((to[0] - from[0]) as f64, (to[1] - from[1]) as f64);
        let near = way <= MENDED * self.unit + course.radius * ANGLE;
        if line && near { Ok(()) } else { Err(Why::new("an arc ends elsewhere")) }
    }

    /// A block that is an arc; how far it turns.
    fn part(&self, course: &Course, found: &read::Arc, arc: &Arc) -> Result<f64, Why> {
        if found.plane != plane(arc.plane) {
            return Err(Why::new("the arc lies in another plane"));
        }
        let off = [0, 1].map(|i| (found.center[i] as f64 - course.center[i]).abs());
        let slack = 0.51 * self.unit + 2.0;
        let near = |most: f64| off.iter().all(|off| *off <= most);
        let closes = found.from == found.to || self.radii(found, found.center) <= self.most_off + 2.0;
        if !closes {
            return Err(Why::new("start and end of the arc are not on one circle"));
        }
        // Another centre than the rounded one only where that does not close.
        if !near(slack) && (!near(MOST_OFF * self.unit + 2.0) || self.rounded_closes(course, found)) {
            return Err(Why::new("the centre of the arc is another one"));
        }
        let sense = f64::from(found.turns.signum());
        let angle = |p: [i64; 2]| {
            let off = [0, 1].map(|i| (p[i] - found.center[i]) as f64);
            libm::atan2(off[1], off[0])
        };
        let mut part = sense * (angle(found.to) - angle(found.from));
        if part <= 0.0 {
            part += TAU;
        }
        if found.from == found.to {
            part = TAU;
        }
        if self.leaves(course, found, sense * part) {
            return Err(Why::new("the arc leaves the one that is meant"));
        }
        Ok(sense * (part + TAU * f64::from(found.turns.abs() - 1)))
    }

    /// Is a place of the printed arc, which turns so far, away from the circle?
    fn leaves(&self, course: &Course, found: &read::Arc, turned: f64) -> bool {
        let most =
            tolerance::ROUNDED_POINT * self.unit + tolerance::LEAVES * SCALE as f64 + 2.0 + course.radius * 1e-14;
        let center = found.center.map(|c| c as f64);
        let about = |p: [i64; 2]| [p[0] as f64 - center[0], p[1] as f64 - center[1]];
        let (start, end) = (about(found.from), about(found.to));
        let [first, last] = [start, end].map(|[x, y]| libm::hypot(x, y));
        let shift = libm::hypot(center[0] - course.center[0], center[1] - course.center[1]);
        if (first - course.radius).abs().max((last - course.radius).abs()) + shift <= most {
            return false;
        }
        let from = libm::atan2(start[1], start[0]);
        (1..LOOKS).any(|look| {
            let share = f64::from(look) / f64::from(LOOKS);
            let (sin, cos) = libm::sincos(from + turned * share);
            let radius = first + (last - first) * share;
            let [x, y] = [radius * cos, radius * sin];
            let off = libm::hypot(center[0] + x - course.center[0], center[1] + y - course.center[1]) - course.radius;
            off.abs() > most
        })
    }

    /// Does the arc close around its exact centre as it is rounded?
    #[cold]
    fn rounded_closes(&self, course: &Course, found: &read::Arc) -> bool {
        let center = [0, 1].map(|i| {
            let meant = course.center[i];
            // A start that was printed as a diameter may lie half a unit beside the places of the centre.
            let shift = found.from[i] as f64 - libm::round(found.from[i] as f64 / self.unit) * self.unit;
            (libm::round((meant - shift) / self.unit) * self.unit + shift) as i64
        });
        let center_is_end = center == found.from || center == found.to;
        found.from == found.to || !center_is_end && self.radii(found, center) < self.most_off - 2.0
    }

    /// Difference of the radii at start and end.
    fn radii(&self, found: &read::Arc, center: [i64; 2]) -> f64 {
        let square = |p: [i64; 2]| {
            let off = [0, 1].map(|i| i128::from(p[i]) - i128::from(center[i]));
            off[0].checked_mul(off[0])?.checked_add(off[1].checked_mul(off[1])?)
        };
        let Some((a, b)) = square(found.from).zip(square(found.to)) else { return f64::INFINITY };
        let sum = libm::sqrt(a as f64) + libm::sqrt(b as f64);
        if sum > 0.0 { (a - b).unsigned_abs() as f64 / sum } else { f64::INFINITY }
    }

    /// A line that stands for a part of the arc; how far it turns about the centre.
    fn chord(&self, course: &Course, from: [i64; 2], to: [i64; 2]) -> Result<f64, Why> {
        let off = |p: [i64; 2]| [0, 1].map(|i| p[i] as f64 - course.center[i]);
        let ([ax, ay], [bx, by]) = (off(from), off(to));
        let middle = libm::hypot((ax + bx) / 2.0, (ay + by) / 2.0);
        let beside = libm::hypot(bx, by) - course.radius;
        let slack = 2.0 + course.radius * 1e-14;
        if beside.abs() > tolerance::ROUNDED_POINT * self.unit + slack || course.radius - middle > self.chord + slack {
            return Err(Why::new("a line leaves the arc that it stands for"));
        }
        Ok(libm::atan2(ax * by - ay * bx, ax * bx + ay * by))
    }

    /// The feed of a block of an arc: blocks share the time.
    fn feed_of_part(&mut self, course: &mut Course, feed: Feed) -> Result<(), Why> {
        let Feed::InverseTime(_) = feed else { return self.same_feed(feed) };
        let read = self.reader.feed().filter(|read| *read > 0).ok_or_else(|| Why::new("there is no feed"))?;
        if self.reader.modes().feed_kind != Some(kind(feed)) {
            return Err(Why::new("the feed is of another kind"));
        }
        if course.blocks > 1.0 && read != course.feed {
            return Err(Why::new("the blocks of the arc take different times"));
        }
        course.feed = read;
        Ok(())
    }

    /// A place between start and end: on the circle, and the other axes as far as the arc.
    fn on_the_way(
        &self,
        course: &Course,
        mv: &Move,
        start: &[i64; AXES],
        known: u16,
        in_plane: [usize; 2],
    ) -> Result<(), Why> {
        let at = self.reader.at();
        let [x, y] = [0, 1].map(|i| at[in_plane[i]] as f64 - course.center[i]);
        if (libm::hypot(x, y) - course.radius).abs()
            > tolerance::ROUNDED_POINT * self.unit + 2.0 + course.radius * 1e-14
        {
            return Err(Why::new("a part of the arc ends beside it"));
        }
        let share = course.swept / course.sweep;
        for axis in mv.axes.iter().filter(|axis| !in_plane.contains(&axis.index())) {
            let i = axis.index();
            let Some(end) = mv.end.get(axis).filter(|_| known & (1 << i) != 0) else { continue };
            let (way, gone) = (end * SCALE as f64 - start[i] as f64, (at[i] - start[i]) as f64);
            let turned = TURNED * self.unit * course.blocks / (course.radius * course.sweep.abs());
            let room = self.unit + 2.0;
            let beyond = gone * way.signum() < -room || gone.abs() > way.abs() + room;
            let lags = course.radius > LOST * self.unit && (gone - way * share).abs() > room + way.abs() * turned;
            if beyond || lags {
                return Err(Why::new("an axis does not go along with the arc"));
            }
        }
        Ok(())
    }
}
