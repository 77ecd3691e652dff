//! Recess turning: the groove is roughed level by level, plunging at a wall and turning to the other one;
//! what the levels leave at the walls is cut off, then the contour is finished. Or it is roughed by strokes
//! side by side.
//!
//! ```text
//!   blank ═══╗ ▼1                        ╔═══
//!            ║ └───────────────────────► ║     turn; the next plunge is at the other wall
//!            ║  ◄──────────────────────┘ ║     from the second level on every turn ends a little earlier
//!            ║  └────────────────────►   ║     at walls where a plunge follows
//!            ╚═══════════════════════════╝
//! ```

use crate::diag::{Fault, codes};
use crate::geo::{Element, Point2, Vec2};
use crate::ir::cycle::Family;
use crate::ir::cycle::recess::{Operation, Passes, RecessEnd, RecessTurning};

use super::groove_cutter::GrooveCutter;
use super::groove_profile::{Above, GrooveProfile, Oversize, Slot};
use super::infeed;
use super::track::{Strokes, Track, View};
use super::{CycleItem, Expand, Start};

/// Most levels of one groove.
const MOST_LEVELS: u64 = 100_000;

/// Share of the effective cutting width that a turned cut may leave standing at a wall.
const OFFSET_SHARE: f64 = 0.8;

impl Expand for RecessTurning {
    fn expand(&self, start: &Start, out: &mut dyn FnMut(CycleItem)) -> Result<(), Fault> {
        expand(self, start.in_turning_plane()?, &mut |stroke| out(stroke.part()))
    }
}

/// Sends the strokes of `recess`; the tool stands at `from`.
///
/// # Errors
/// G3040 too many levels, G3041 bad arguments, G3044 no groove, G3045 the tool does not fit, G3046 the blank.
pub fn expand<'a>(recess: &RecessTurning, from: Point2, out: &'a mut Strokes<'a>) -> Result<(), Fault> {
    recess.check().map_err(|fault| codes::G3041::recess_makes_no_path(&fault))?;
    let groove = Groove::of(recess)?;
    let mut cutter = GrooveCutter {
        track: Track::new(groove.view, from, out),
        shift: groove.shift,
        clear: groove.view.height(recess.clear()),
    };
    let start = cutter.track.at();
    // Whoever stands higher than the clear height comes down above the groove.
    cutter.track.rapid(Point2::new(start.x, start.y.max(cutter.clear)));
    if recess.operation != Operation::Finish {
        groove.rough(&mut cutter);
    }
    if recess.operation != Operation::Rough {
        groove.finish(&mut cutter);
    }
    match recess.end {
        RecessEnd::Start => {
            let height = start.y.max(cutter.clear);
            cutter.track.rapid(Point2::new(cutter.track.at().x, height));
            cutter.track.rapid(Point2::new(start.x, height));
            cutter.track.rapid(start);
        }
        RecessEnd::Front => cutter.track.rapid(Point2::new(groove.start.x, cutter.clear)),
        RecessEnd::Lift => {}
    }
    Ok(())
}

/// The groove in its view, rough and finished.
struct Groove<'r> {
    recess: &'r RecessTurning,
    view: View,
    /// First point of the contour.
    start: Point2,
    /// From the edge of the tool towards -x to its programmed point.
    shift: f64,
    blank: f64,
    rough: Slot,
    finished: Slot,
    levels: u64,
    /// How much a turned cut ends earlier than the last one at the same wall.
    offset: f64,
}

impl<'r> Groove<'r> {
    fn of(recess: &'r RecessTurning) -> Result<Groove<'r>, Fault> {
        let (first, last) = match (recess.contour.first(), recess.contour.last()) {
            (Some(first), Some(last)) => (first.from(), last.to()),
            _ => (Point2::origin(), Point2::origin()),
        };
        let along = if recess.into.is_radial() { last.x - first.x } else { last.y - first.y };
        let view = View::new(recess.into, along);
        let contour: Vec<Element> = recess.contour.iter().map(|element| view.element(element)).collect();
        let groove_profile = GrooveProfile::new(&contour).map_err(|why| why.refused("recess"))?;

        let tool = &recess.tool;
        let oversize = if recess.into.is_radial() { recess.oversize } else { recess.oversize.yx() };
        let slot = |left: Vec2| {
            let left = Oversize { along: [left.x; 2], up: left.y, around: 0.0 };
            groove_profile.slot(tool.width, tool.nose, left, Above::Material)
        };
        let (Some(rough), Some(finished)) = (slot(oversize), slot(Vec2::zeros())) else {
            return Err(codes::G3045::tool_of_mm_width_does_not(&tool.width));
        };

        let blank = view.height(recess.blank);
        let depth = blank - rough.floor;
        if depth <= 0.0 {
            return Err(codes::G3046::blank_does_not_reach_above_floor());
        }
        let levels = infeed::steps(depth, recess.most).max(1);
        if levels > MOST_LEVELS {
            return Err(codes::G3040::infeed_makes_levels_of_this_recess(&levels, &MOST_LEVELS));
        }
        if let Passes::Strokes { width, .. } = recess.passes {
            let strokes = infeed::steps(rough.end(blank) - rough.begin(blank), width);
            if strokes > MOST_LEVELS {
                return Err(codes::G3040::recess_needs_strokes(&strokes, &MOST_LEVELS));
            }
        }
        let shortened = if recess.passes == Passes::OneWayShorter { levels.saturating_sub(1) } else { levels / 2 };
        let turns_per_wall = shortened.max(1) as f64;
        let room = (rough.end(rough.floor) - rough.begin(rough.floor)) / 2.0;
        let most = (OFFSET_SHARE * (tool.width - 2.0 * tool.nose)).min(room);
        let offset = recess.offset_width.min(most / turns_per_wall);
        let shift = if along < 0.0 { tool.edge + tool.width } else { -tool.edge };
        let start = view.point(first);
        Ok(Groove { recess, view, start, shift, blank, rough, finished, levels, offset })
    }

    /// Height of level `k`, counted from 1.
    fn level(&self, k: u64) -> f64 {
        infeed::place(self.blank, self.rough.floor, k, self.levels)
    }

    fn rough(&self, cutter: &mut GrooveCutter<'_>) {
        let left = match self.recess.passes {
            Passes::BothWays => self.both_ways(cutter),
            Passes::OneWay => self.one_way(cutter, 0.0),
            Passes::OneWayShorter => self.one_way(cutter, self.offset),
            Passes::Strokes { width, dwell } => self.strokes(cutter, width, dwell),
        };
        // What stands at a wall: what the offset width left, and the steps on a wall that is not upright.
        let upright =
            |at: fn(&Slot, f64) -> f64| (at(&self.rough, self.blank) - at(&self.rough, self.rough.floor)).abs() < 1e-9;
        let feed = self.recess.feeds.plunge;
        if left[0] > 0.0 || !upright(Slot::begin) {
            cutter.down(self.rough.down_first(cutter.clear), feed);
            cutter.lift();
        }
        if left[1] > 0.0 || !upright(Slot::end) {
            cutter.down(self.rough.down_second(cutter.clear), feed);
            cutter.lift();
        }
    }

    /// Returns what stands at both walls.
    fn both_ways(&self, cutter: &mut GrooveCutter<'_>) -> [f64; 2] {
        let feeds = self.recess.feeds;
        let mut left = [0.0, 0.0];
        for k in 1..=self.levels {
            let y = self.level(k);
            let place = |wall: usize, left: [f64; 2]| {
                if wall == 0 { self.rough.begin(y) + left[0] } else { self.rough.end(y) - left[1] }
            };
            let here = usize::from(k % 2 == 0);
            let there = 1 - here;
            let x = place(here, left);
            if k == 1 {
                cutter.above(x);
            } else {
                // Walls that come closer: back over what is cut already.
                cutter.line(Point2::new(x, cutter.height()), feeds.turn);
            }
            cutter.line(Point2::new(x, y), feeds.plunge);
            if k > 1 {
                left[there] += self.offset;
            }
            cutter.line(Point2::new(place(there, left), y), feeds.turn);
        }
        cutter.lift();
        left
    }

    /// Each pass ends `offset` earlier than the one before. Returns what stands at both walls.
    fn one_way(&self, cutter: &mut GrooveCutter<'_>, offset: f64) -> [f64; 2] {
        let feeds = self.recess.feeds;
        let mut left = 0.0;
        for k in 1..=self.levels {
            let y = self.level(k);
            let x = self.rough.begin(y);
            cutter.above(x);
            if k > 1 {
                cutter.rapid_down(self.level(k - 1) + self.recess.clearance);
            }
            cutter.line(Point2::new(x, y), feeds.plunge);
            if k > 1 {
                left += offset;
            }
            cutter.line(Point2::new(self.rough.end(y) - left, y), feeds.turn);
            cutter.lift();
        }
        [0.0, left]
    }

    fn strokes(&self, cutter: &mut GrooveCutter<'_>, width: f64, dwell: f64) -> [f64; 2] {
        let (first, last) = (self.rough.begin(self.blank), self.rough.end(self.blank));
        let gaps = infeed::steps(last - first, width);
        for k in 0..=gaps {
            let x = infeed::place(first, last, k, gaps);
            let y = self.rough.depth_at(x, self.blank);
            cutter.above(x);
            cutter.line(Point2::new(x, y), self.recess.feeds.plunge);
            cutter.track.dwell(dwell);
            cutter.lift();
        }
        [0.0, 0.0]
    }

    /// Down the first wall and along the floor to where the stock of the second wall begins; down the second
    /// wall and back to that place.
    fn finish(&self, cutter: &mut GrooveCutter<'_>) {
        let feed = self.recess.feeds.finish;
        let turned = self.finished.floor + self.recess.compensation;
        let meet = self.rough.end(self.rough.floor).max(self.finished.begin(self.finished.floor));
        for way in [self.finished.down_first(cutter.clear), self.finished.down_second(cutter.clear)] {
            let foot = cutter.down(way, feed);
            if let Passes::Strokes { dwell, .. } = self.recess.passes {
                cutter.track.dwell(dwell);
            }
            if foot != meet {
                cutter.line(Point2::new(foot, turned), feed);
                cutter.line(Point2::new(meet, turned), feed);
            }
            cutter.lift();
        }
    }
}

#[cfg(test)]
mod tests;
