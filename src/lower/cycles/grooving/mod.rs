//! Grooving: strokes side by side from the middle outwards, each as deep as the walls let the whole edge go; strokes on
//! walls that lean or have a round foot; what stands at a wall is cut off along it; then the contour in two halves, each
//! with the corner on its side.
//!
//! ```text
//!   ══╗   5   3   1   2   4   6   ╔══
//!     ║   │   │   ▼   │   │   │   ║     at most `spacing` apart
//!      ╲──┘   ▼       ▼   ▼   └──╱      half a width apart on the walls
//!       ╚════════════════════════╝
//! ```
//!
//! Why no rapid move meets stock: between the surface and the clear height there is none, and the tool only goes straight
//! up through what its own stroke has opened.

use crate::diag::{Fault, codes};
use crate::geo::tolerance;
use crate::geo::{Element, Point2};
use crate::ir::cycle::Family;
use crate::ir::cycle::grooving::{Grooving, Plunges};
use crate::ir::cycle::recess::Operation;

use super::groove_cutter::GrooveCutter;
use super::groove_profile::{Above, GrooveProfile, Oversize, Slot};
use super::infeed;
use super::track::{Strokes, Track, View};
use super::{CycleItem, Expand, Start};

/// Most plunges of a groove, and most steps of a plunge.
const MOST_STROKES: u64 = 100_000;

/// Share of the cutting width between strokes on a leaning wall.
const WALL_SHARE: f64 = 0.5;

impl Expand for Grooving {
    fn expand(&self, start: &Start, out: &mut dyn FnMut(CycleItem)) -> Result<(), Fault> {
        expand(self, start.in_turning_plane()?, &mut |stroke| out(stroke.part()))
    }
}

/// Sends the strokes of `grooving`; the tool stands at `from`.
///
/// # Errors
/// G3040 too many strokes, G3041 bad arguments, G3044 no groove, G3045 the tool does not fit.
pub fn expand<'a>(grooving: &Grooving, from: Point2, out: &'a mut Strokes<'a>) -> Result<(), Fault> {
    grooving.check().map_err(|fault| codes::G3041::groove_makes_no_path(&fault))?;
    let view = View::new(grooving.into, 1.0);
    let groove = Groove::of(grooving, &view)?;
    let shift = -grooving.tool.edge;
    let clear = view.height(grooving.clear());
    let mut cutter = GrooveCutter { track: Track::new(view, from, out), shift, clear };
    // Whoever stands higher than the clear height comes down above the groove.
    let start = cutter.track.at();
    cutter.track.rapid(Point2::new(start.x, start.y.max(clear)));
    for copy in 0..grooving.copies.count {
        cutter.shift = shift + f64::from(copy) * grooving.copies.distance;
        if grooving.operation != Operation::Finish {
            groove.rough(&mut cutter);
        }
        if grooving.operation != Operation::Rough {
            groove.finish(&mut cutter);
        }
    }
    cutter.track.rapid(Point2::new(grooving.park(), clear));
    Ok(())
}

/// The groove in its view. Positions are those of the edge of the tool towards -x.
struct Groove<'g> {
    grooving: &'g Grooving,
    surface: f64,
    /// How far the rims reach below the surface: of the wall towards -x, and of the other one.
    rims: [f64; 2],
    /// Where the whole edge may plunge.
    plunged: Slot,
    /// Where the rounded corners may be in roughing, and in finishing.
    rough: Slot,
    finished: Slot,
    /// Gaps between the plunges to the floor.
    gaps: u64,
}

impl<'g> Groove<'g> {
    fn of(grooving: &'g Grooving, view: &View) -> Result<Groove<'g>, Fault> {
        let mut contour: Vec<Element> = grooving.contour.iter().map(|element| view.element(element)).collect();
        let allowance = &grooving.allowance;
        let (mut walls, mut rims) = (allowance.walls, grooving.rims);
        if grooving.runs_towards_minus() {
            contour = contour.iter().rev().map(Element::reversed).collect();
            walls.reverse();
            rims.reverse();
        }
        let groove_profile = GrooveProfile::new(&contour).map_err(|why| why.refused("groove"))?;
        let tool = &grooving.tool;
        let left = Oversize { around: allowance.around, along: walls, up: allowance.depth };
        let slot = |nose: f64, left: Oversize| groove_profile.slot(tool.width, nose, left, Above::Nothing);
        let rough = slot(tool.nose, left);
        // The square edge stays clear of all that the rounded one stays clear of. Only where the foot of a wall is round
        // do the corners have to reach under it.
        let plunged = slot(0.0, left).or_else(|| rough.clone());
        let (Some(rough), Some(plunged), Some(finished)) = (rough, plunged, slot(tool.nose, Oversize::default()))
        else {
            return Err(codes::G3045::tool_of_mm_width_does_not_reach(&tool.width));
        };
        let surface = view.height(grooving.surface);
        if surface - plunged.floor <= tolerance::SAME {
            return Err(codes::G3041::allowance_on_floor_leaves_nothing_of_groove());
        }
        let gaps = infeed::steps(plunged.end(plunged.floor) - plunged.begin(plunged.floor), grooving.spacing);
        let steps = match grooving.plunges {
            Plunges::Whole => 1,
            Plunges::Steps { most, .. } | Plunges::Alternating { most, .. } => {
                infeed::steps(surface - plunged.floor, most)
            }
        };
        let groove = Groove { grooving, surface, rims, plunged, rough, finished, gaps };
        let on_walls = groove.runs().into_iter().flatten().map(|run| infeed::steps(run, groove.wall_spacing()));
        let strokes = on_walls.fold(gaps.max(steps), u64::max);
        if strokes > MOST_STROKES {
            return Err(codes::G3040::groove_takes_strokes(&strokes));
        }
        Ok(groove)
    }

    /// The first and the last position at the floor of `slot`.
    fn floor_of(slot: &Slot) -> (f64, f64) {
        (slot.begin(slot.floor), slot.end(slot.floor))
    }

    /// Positions of the plunges to the floor: from the middle outwards, of two alike the one at the reference point first.
    fn positions(&self) -> Vec<f64> {
        let (begin, end) = Self::floor_of(&self.plunged);
        let at_end = self.grooving.runs_towards_minus();
        let mut order: Vec<u64> = (0..=self.gaps).collect();
        let from_middle = |i: &u64| (2 * i).abs_diff(self.gaps);
        order.sort_by_key(|i| (from_middle(i), if at_end { self.gaps - i } else { *i }));
        // A single one stands at the beginning.
        order.into_iter().map(|i| infeed::place(begin, end, i, self.gaps.max(1))).collect()
    }

    fn wall_spacing(&self) -> f64 {
        WALL_SHARE * self.grooving.tool.width
    }

    /// How far the two walls reach outwards of the floor: up to the rim, and the rim.
    fn runs(&self) -> [[f64; 2]; 2] {
        let (begin, end) = Self::floor_of(&self.plunged);
        let raised = self.surface + self.grooving.allowance.depth;
        let foot_of_rim = |rim: f64| match rim > 0.0 {
            true => (raised - rim - self.plunged.nose()).min(self.surface).max(self.plunged.floor),
            false => self.surface,
        };
        let [first, second] = self.rims.map(foot_of_rim);
        let first = [first, self.surface].map(|y| begin - self.plunged.begin(y));
        let second = [second, self.surface].map(|y| self.plunged.end(y) - end);
        [first, second].map(|[wall, rim]| [wall, rim - wall])
    }

    /// Positions outside of the floor on the wall towards -x and on the other one, from the floor outwards: spread over the wall
    /// without its rim, then over the rim.
    fn on_walls(&self) -> [Vec<f64>; 2] {
        let (begin, end) = Self::floor_of(&self.plunged);
        let spread = |from: f64, run: f64| {
            let count = infeed::steps(run.abs(), self.wall_spacing());
            (1..=count).map(move |k| infeed::place(from, from + run, k, count))
        };
        let positions = |from: f64, sense: f64, [wall, rim]: [f64; 2]| -> Vec<f64> {
            let places = spread(from, sense * wall).chain(spread(from + sense * wall, sense * rim));
            places.filter(|x| self.depth(*x) > tolerance::SAME).collect()
        };
        let [first, second] = self.runs();
        [positions(begin, -1.0, first), positions(end, 1.0, second)]
    }

    /// Do the plunges leave more than the allowance at the wall towards -x, and at the other one?
    fn stands_at_walls(&self) -> [bool; 2] {
        let (begin, end) = Self::floor_of(&self.plunged);
        // Beside the rim, where the round corner of the tool does not hang over it.
        let beside = (self.surface - self.grooving.tool.nose).max(self.rough.floor);
        let off = [begin - self.rough.begin(beside), self.rough.end(beside) - end];
        [off[0].abs() > tolerance::SAME || self.rims[0] > 0.0, off[1].abs() > tolerance::SAME || self.rims[1] > 0.0]
    }

    /// Depth of the plunge at `x` below the surface.
    fn depth(&self, x: f64) -> f64 {
        self.surface - self.plunged.depth_at(x, self.surface)
    }

    fn rough(&self, cutter: &mut GrooveCutter<'_>) {
        let positions = self.positions();
        let mut rest = positions.as_slice();
        if let (Plunges::Alternating { most, .. }, [first, second, others @ ..]) = (self.grooving.plunges, rest) {
            self.alternate(cutter, [*first, *second], most);
            rest = others;
        }
        let alone = positions.len() == 1;
        for x in rest {
            self.plunge(cutter, *x, alone);
        }
        for x in self.on_walls().iter().flatten() {
            self.plunge(cutter, *x, false);
        }
        let feed = self.grooving.feeds.plunge;
        let (begin, end) = Self::floor_of(&self.plunged);
        let ways = [(Slot::down_first as fn(&Slot, f64) -> _, begin), (Slot::down_second, end)];
        for ((way, foot), stands) in ways.into_iter().zip(self.stands_at_walls()) {
            if stands {
                let _ = cutter.down(way(&self.rough, cutter.clear), feed);
                cutter.line(Point2::new(foot, self.rough.floor), feed);
                cutter.lift();
            }
        }
    }

    /// One plunge to its full depth; `alone` if no other one reaches the floor.
    fn plunge(&self, cutter: &mut GrooveCutter<'_>, x: f64, alone: bool) {
        let depth = self.depth(x);
        let (most, retract) = match self.grooving.plunges {
            Plunges::Steps { most, retract } => (most, retract),
            Plunges::Alternating { most, retract } if alone => (most, retract),
            Plunges::Whole | Plunges::Alternating { .. } => (depth, 0.0),
        };
        cutter.above(x);
        let steps = infeed::steps(depth, most).max(1);
        for k in 1..=steps {
            let y = infeed::place(self.surface, self.surface - depth, k, steps);
            cutter.line(Point2::new(x, y), self.grooving.feeds.plunge);
            if k < steps {
                cutter.rapid_up((y + retract).min(cutter.clear));
            }
        }
        // Steps on a wall are cut off.
        if depth >= self.surface - self.plunged.floor - tolerance::SAME {
            cutter.track.dwell(self.grooving.dwell);
        }
        cutter.lift();
    }

    /// Two plunges in turns, each `most` deeper than the last one of the other.
    fn alternate(&self, cutter: &mut GrooveCutter<'_>, places: [f64; 2], most: f64) {
        let depths = places.map(|x| self.depth(x));
        let mut reached = [0.0; 2];
        let mut turn = 0_u32;
        while reached[0] < depths[0] || reached[1] < depths[1] {
            let (here, step) = ((turn % 2) as usize, f64::from(turn + 1) * most);
            turn += 1;
            if reached[here] >= depths[here] {
                continue;
            }
            reached[here] = step.min(depths[here]);
            // What arithmetic leaves over is no step of its own.
            if depths[here] - reached[here] < tolerance::SAME {
                reached[here] = depths[here];
            }
            cutter.above(places[here]);
            cutter.line(Point2::new(places[here], self.surface - reached[here]), self.grooving.feeds.plunge);
            if reached[here] >= depths[here] {
                cutter.track.dwell(self.grooving.dwell);
            }
            cutter.lift();
        }
    }

    /// Down the wall towards -x and along the floor past its middle; down the other one and back past the middle.
    fn finish(&self, cutter: &mut GrooveCutter<'_>) {
        let feed = self.grooving.feeds.finish;
        let (begin, end) = Self::floor_of(&self.finished);
        let (middle, nose) = ((begin + end) / 2.0, self.grooving.tool.nose);
        // Not so far that the stock on the second wall stands above the tool when it goes out.
        let first = (middle + nose).min(self.plunged.end(self.plunged.floor)).min(end).max(begin);
        let second = (middle - nose).min(first).max(begin);
        let halves =
            [(self.finished.down_first(cutter.clear), first), (self.finished.down_second(cutter.clear), second)];
        for (way, meet) in halves {
            let _ = cutter.down(way, feed);
            cutter.line(Point2::new(meet, self.finished.floor), feed);
            cutter.lift();
        }
    }
}

#[cfg(test)]
mod tests;
