//! Stock removal in layers: parallel cuts that end at the contour and follow it up to the cut before, relief cuts, and the
//! contour itself.
//!
//! ```text
//!   ┌──────────────────────────── blank
//!   ├─── cut 1 ───────────►│ trace
//!   ├─── cut 2 ──────►╭────┘
//!   ├─── cut 3 ──►╭───╯
//!   └─────────────┘  contour, grown by allowances and nose
//! ```
//!
//! Everything is computed in a view that cuts towards +x and feeds in towards -y, with the places of the nose centre as x
//! and the heights of its lowest point as y.

mod finishing;
mod passes;
mod region;
mod relief;

use crate::diag::{Fault, codes};
use crate::geo::profile::{LEVEL, Leg};
use crate::geo::{Plane, Point2, Vec2};
use crate::ir::Feed;
use crate::ir::cycle::Family;
use crate::ir::cycle::layers::{Blank, Layers};
use crate::ir::cycle::recess::Operation;
use crate::ir::cycle::roughing::Corner;

use super::infeed::steps as infeed_steps;
use super::track::{Strokes, Track, View};
use super::{CycleItem, Expand, Start};

use region::Region;

/// Most cuts of one cycle.
const MOST_CUTS: u64 = 100_000;

impl Expand for Layers {
    fn expand(&self, start: &Start, out: &mut dyn FnMut(CycleItem)) -> Result<(), Fault> {
        expand(self, start.at.in_plane(Plane::Zx), &mut |stroke| out(stroke.part()))
    }
}

/// Sends the strokes of `layers`; the tool stands at `from`, where that is known.
///
/// # Errors
/// G3040 too many cuts, G3041 bad arguments, G3046 the blank, G3047 the contour, G3049 no room for the nose, G3301 no
/// free way to the start, G3302 the tool, G3303 the limits.
pub fn expand<'a>(layers: &Layers, from: Option<Point2>, out: &'a mut Strokes<'a>) -> Result<(), Fault> {
    layers.check().map_err(|why| codes::G3041::layers_makes_no_path(&why))?;
    let view = View::new(layers.into, layers.along);
    let region = Region::of(layers, view)?;
    // Unknown: the first move names both axes.
    let stands = from.unwrap_or(Point2::new(f64::NAN, f64::NAN));
    let mut cutter = Cutter { track: Track::new(view, stands, out), region: &region, at: Point2::origin() };
    cutter.approach(from.map(|p| view.point(p)))?;
    if layers.operation != Operation::Finish {
        cutter.rough()?;
        cutter.relieve()?;
    }
    if layers.operation != Operation::Rough {
        cutter.finish()?;
    }
    cutter.go_home();
    Ok(())
}

/// The tool at work. Places are those of the nose: its centre along x, its lowest point along y.
struct Cutter<'c> {
    track: Track<'c>,
    region: &'c Region<'c>,
    at: Point2,
}

impl Cutter<'_> {
    fn rapid(&mut self, to: Point2) {
        self.at = to;
        self.track.rapid(self.region.tip(to));
    }

    fn line(&mut self, to: Point2, feed: Feed) {
        self.at = to;
        self.track.line(self.region.tip(to), feed);
    }

    fn legs(&mut self, legs: &[Leg], feed: Feed) {
        for leg in legs {
            match *leg {
                Leg::Line { to } => self.line(to, feed),
                Leg::Arc { to, center, ccw } => {
                    self.at = to;
                    self.track.arc(self.region.tip(to), self.region.tip(center), ccw, feed);
                }
            }
        }
    }

    fn rapid_x(&mut self, x: f64) {
        self.rapid(Point2::new(x, self.at.y));
    }

    fn rapid_y(&mut self, y: f64) {
        self.rapid(Point2::new(self.at.x, y));
    }

    /// To where the cycle begins, around the blank.
    fn approach(&mut self, from: Option<Point2>) -> Result<(), Fault> {
        let home = self.region.home();
        if self.corner().is_some() {
            // The tool stands there.
            self.at = home;
            return Ok(());
        }
        if let Some(from) = from {
            let to = self.region.tip(home);
            let ways = [vec![to], vec![Point2::new(from.x, to.y), to], vec![Point2::new(to.x, from.y), to]];
            let Some(way) = ways.iter().find(|way| self.region.is_free(from, way)) else {
                return Err(codes::G3301::tool_stands_inside_of_blank());
            };
            for to in way {
                self.track.rapid(*to);
            }
        }
        self.rapid(home);
        Ok(())
    }

    /// Back to where the cycle began, above all that stands in front of the tool.
    fn go_home(&mut self) {
        let home = self.region.home();
        if let Some(corner) = self.corner() {
            let is_beside = (self.at.x - home.x).abs() <= LEVEL;
            if corner.back || !is_beside {
                // The steps of the cuts may stand in front of a lower tool.
                self.rapid_y(home.y.max(self.at.y));
                self.rapid_x(home.x);
                self.rapid(home);
            }
            return;
        }
        let needed = self.region.highest_before(self.at.x.max(home.x));
        if self.at.y < needed {
            self.rapid_y(needed + self.region.layers.clearance.lift);
        }
        self.rapid_x(home.x);
        self.rapid(home);
    }

    fn corner(&self) -> Option<&Corner> {
        match &self.region.layers.blank {
            Blank::Corner(corner) => Some(corner),
            Blank::Outline(_) | Blank::On(_) => None,
        }
    }

    /// Off the material: up, and back by no more than `back`.
    fn lift(&mut self, up: f64, back: f64, feed: Feed) {
        let to = self.at + Vec2::new(-up.min(back).max(0.0), up);
        self.line(to, feed);
    }
}

#[cfg(test)]
mod tests;
