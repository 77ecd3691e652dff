//! Stock removal along a contour: cuts at equal depths up to the contour, then the steps between them, then
//! the contour itself.
//!
//! ```text
//!   blank ──────────────────────────┐
//!      ╱ lift  ◄──── cut 1 ─────────┤ begin
//!   ══╗╱                            │
//!     ║ ◄───────── cut 2 ───────────┤
//!     ╚══╗                          │
//!   part ║ ◄────── cut 3 ───────────┘
//! ```

use crate::diag::codes;
use crate::geo::wall::{Leg, Wall};
use crate::geo::{Element, Point2, Vec2};
use crate::ir::Feed;
use crate::ir::cycle::Family;
use crate::ir::cycle::recess::Operation;
use crate::ir::cycle::roughing::{Falling, Nose, Roughing, RoughingEnd, Smoothing};

use super::infeed;
use super::slope::{NoSlope, Slope};
use super::track::{Failure, Strokes, Track, View};
use super::valley::seen;
use super::{CycleItem, Expand, Start};

/// Most cuts of one cycle.
const MOST_CUTS: u64 = 100_000;

impl Expand for Roughing {
    fn expand(&self, start: &Start, out: &mut dyn FnMut(CycleItem)) -> Result<(), Failure> {
        expand(self, start.in_turning_plane()?, &mut |stroke| out(stroke.part()))
    }
}

/// Sends the strokes of `roughing`; the tool stands at `from`.
///
/// # Errors
/// G3040 too many cuts, G3041 bad arguments, G3046 the blank, G3047 the contour.
pub fn expand<'a>(roughing: &Roughing, from: Point2, out: &'a mut Strokes<'a>) -> Result<(), Failure> {
    let fault = |fault: String| Failure::new(codes::G3041, fault, "correct the roughing data");
    roughing.check().map_err(|why| fault(why.to_string()))?;
    let side = roughing.side().ok_or_else(|| fault("the cuts begin inside of the contour".to_owned()))?;
    let view = View::new(roughing.into, side);
    let stock = Stock::of(roughing, &view)?;
    let mut track = Track::new(view, from, out);
    let start = track.at();
    if start.y < stock.blank && start.x < stock.begin {
        let message = "the tool stands inside of the blank, so it cannot travel to where the cuts begin";
        return Err(Failure::new(codes::G3046, message, "position the tool clear of the blank in front of the cycle"));
    }
    if roughing.operation != Operation::Finish {
        stock.rough(&mut track);
    }
    if roughing.operation != Operation::Rough {
        stock.finish(&mut track);
    }
    if roughing.end == RoughingEnd::Start {
        let height = start.y.max(track.at().y);
        track.rapid(Point2::new(track.at().x, height));
        track.rapid(Point2::new(start.x, height));
        track.rapid(start);
    }
    Ok(())
}

/// What is to be removed, in the view.
struct Stock<'r> {
    roughing: &'r Roughing,
    wall: Wall,
    finished: Wall,
    blank: f64,
    begin: f64,
    floor: f64,
    /// Top of the contour with its oversize, or of the blank.
    top: f64,
    /// Floor and top of the contour.
    ends: (f64, f64),
    cuts: u64,
    tip: Tip,
}

/// From the lowest point below the nose centre to the programmed point.
#[derive(Debug, Clone, Copy)]
pub struct Tip(f64);

impl Tip {
    pub fn new(nose: &Nose, view: &View) -> Tip {
        Tip(view.vector(nose.tip).x * nose.radius)
    }

    pub fn place(self, p: Point2) -> Point2 {
        Point2::new(p.x + self.0, p.y)
    }
}

impl<'r> Stock<'r> {
    fn of(roughing: &'r Roughing, view: &View) -> Result<Stock<'r>, Failure> {
        let contour: Vec<Element> = roughing.contour.iter().map(|element| seen(view, element)).collect();
        let slope = Slope::new(&contour, roughing.falling == Falling::Bridged).map_err(no_slope)?;
        let oversize = if roughing.into.is_radial() { roughing.oversize } else { roughing.oversize.yx() };
        let wall = slope.wall(roughing.nose.radius, oversize).map_err(|_| no_slope(NoSlope::Leans))?;
        let finished = slope.wall(roughing.nose.radius, Vec2::zeros()).map_err(|_| no_slope(NoSlope::Leans))?;
        let blank = view.height(roughing.blank);
        let floor = slope.floor + oversize.y;
        if blank <= floor {
            let message = "the blank does not reach above the contour";
            return Err(Failure::new(codes::G3046, message, "check the height of the blank and the contour"));
        }
        let cuts = infeed::steps(blank - floor, roughing.most).max(1);
        if cuts > MOST_CUTS {
            let message = format!("the infeed makes {cuts} cuts, more than {MOST_CUTS}");
            return Err(Failure::new(codes::G3040, message, "program a larger infeed"));
        }
        let begin = {
            let at = Point2::new(roughing.begin, roughing.begin);
            view.point(at).x
        };
        let tip = Tip::new(&roughing.nose, view);
        let (top, ends) = ((slope.top + oversize.y).min(blank), (slope.floor, slope.top));
        Ok(Stock { roughing, wall, finished, blank, begin, floor, top, ends, cuts, tip })
    }

    /// Height of cut `k`; 0 is the blank.
    fn level(&self, k: u64) -> f64 {
        if k >= self.cuts { self.floor } else { self.blank - (self.blank - self.floor) * (k as f64 / self.cuts as f64) }
    }

    fn rough(&self, track: &mut Track<'_>) {
        let feed = self.roughing.feed;
        for k in 1..=self.cuts {
            let y = self.level(k);
            self.enter(track, y);
            let end = self.tip.place(Point2::new(self.wall.touch(y), y));
            if end.x < track.at().x {
                track.line(end, feed);
                if self.roughing.smoothing == Smoothing::EachCut {
                    self.climb(track, &self.wall, y, self.level(k - 1), feed);
                }
            }
            self.lift(track);
        }
        if self.roughing.smoothing == Smoothing::LastCut {
            self.follow(track, &self.wall, (self.floor, self.top), feed);
        }
    }

    fn finish(&self, track: &mut Track<'_>) {
        self.follow(track, &self.finished, self.ends, self.roughing.finish_feed);
    }

    /// From the begin along the whole contour.
    fn follow(&self, track: &mut Track<'_>, wall: &Wall, (floor, top): (f64, f64), feed: Feed) {
        self.enter(track, floor);
        let foot = self.tip.place(Point2::new(wall.touch(floor), floor));
        if foot.x < track.at().x {
            track.line(foot, feed);
        }
        self.climb(track, wall, floor, top, feed);
        self.lift(track);
    }

    /// To where a cut begins.
    fn enter(&self, track: &mut Track<'_>, y: f64) {
        let to = Point2::new(self.begin, y);
        track.rapid(Point2::new(to.x, track.at().y));
        match self.roughing.entry {
            Some(feed) => track.line(to, feed),
            None => track.rapid(to),
        }
    }

    /// Along the contour from height `low` up to `high`.
    fn climb(&self, track: &mut Track<'_>, wall: &Wall, low: f64, high: f64, feed: Feed) {
        let (start, legs) = wall.way(high, low);
        let mut ends: Vec<Point2> = legs.iter().map(Leg::to).collect();
        ends.insert(0, start);
        // The way down, run through backwards.
        for (leg, to) in legs.iter().zip(&ends).rev() {
            let to = self.tip.place(*to);
            match *leg {
                Leg::Line { .. } => track.line(to, feed),
                Leg::Arc { center, ccw, .. } => track.arc(to, self.tip.place(center), !ccw, feed),
            }
        }
    }

    /// Off the material at 45 degrees and back to the begin.
    fn lift(&self, track: &mut Track<'_>) {
        let at = track.at();
        let way = self.roughing.lift;
        // Not beyond the begin, which may be close to the contour.
        let to = at + Vec2::new(way.min(self.begin - at.x).max(0.0), way);
        track.line(to, self.roughing.feed);
        track.rapid(Point2::new(self.begin, to.y));
    }
}

pub fn no_slope(why: NoSlope) -> Failure {
    let (message, help) = match why {
        NoSlope::Falls => (
            "the contour falls behind a part that the tool has to pass, which needs plunging",
            "machine the recess by a recessing cycle, or leave it out of this contour",
        ),
        NoSlope::Leans => (
            "the contour leans over, or is not on the side from which the tool comes",
            "check the order and the points of the contour",
        ),
        NoSlope::Broken => ("an arc of the contour cannot be cut where it is bridged", "divide the arc at this height"),
    };
    Failure::new(codes::G3047, message, help)
}

#[cfg(test)]
mod tests;
