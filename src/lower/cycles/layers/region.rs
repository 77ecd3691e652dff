//! What is to be removed, in the view of the cuts.

use crate::diag::{Fault, codes};
use crate::geo::element::quarters;
use crate::geo::profile::{Grown, LEVEL, Profile};
use crate::geo::{Element, Point2, Vec2};
use crate::ir::cycle::layers::{Blank, LEAST_DIP, Layers, Relief, Segmentation};
use crate::ir::cycle::recess::Operation;
use crate::lower::cycles::infeed;
use crate::lower::cycles::track::View;

use super::MOST_CUTS;

/// Height of the wall behind the contour, mm above everything: no cut gets there.
const WALL: f64 = 1e5;

pub struct Region<'l> {
    pub layers: &'l Layers,
    view: View,
    /// The finished contour.
    pub contour: Vec<Element>,
    /// The nose on the contour with its allowances, seen from in front and from behind.
    pub rough: Profile,
    pub behind: Profile,
    /// The nose on the finished contour.
    pub finished: Profile,
    pub blank: Profile,
    /// First place of the blank.
    pub front: f64,
    /// Heights from the blank down to the deepest cut.
    pub levels: Vec<f64>,
    /// Greatest place of the nose centre, and its least height.
    pub far: f64,
    pub least: f64,
    /// The area ends below the blank.
    pub is_capped: bool,
    /// Greatest height of the contour with its allowances, or of the blank.
    pub crest: f64,
}

/// Allowances along the cutting axis, upwards and around.
struct Left {
    along: f64,
    up: f64,
    around: f64,
}

impl<'l> Region<'l> {
    /// # Errors
    /// G3040, G3046, G3047, G3302, G3303.
    pub fn of(layers: &'l Layers, view: View) -> Result<Region<'l>, Fault> {
        check_nose(layers, &view)?;
        let contour: Vec<Element> = layers.contour.iter().map(|element| view.element(element)).collect();
        let (Some(first), Some(last)) = (contour.first(), contour.last()) else { return Err(no_contour()) };
        let (start, end) = (first.from(), last.to());
        if end.x < start.x - LEVEL {
            return Err(no_contour());
        }
        let axes = if layers.into.is_radial() { layers.allowance.axes } else { layers.allowance.axes.yx() };
        let left = Left { along: axes.x, up: axes.y, around: layers.allowance.around };
        let limits = Limits::of(layers, &view);
        let home = view.point(layers.parked());
        let blank = match &layers.blank {
            Blank::Outline(list) => Profile::hull(&list.iter().map(|e| view.element(e)).collect::<Vec<_>>()),
            Blank::On(by) => {
                let by = if layers.into.is_radial() { *by } else { by.yx() };
                Profile::new(&contour, Grown { along: by.x, up: by.y, disc: 0.0 }).between(f64::NEG_INFINITY, end.x)
            }
            Blank::Corner(_) => Profile::hull(&[Element::Line { from: home, to: Point2::new(end.x, home.y) }]),
        };
        let (front, back) = blank.ends().ok_or_else(no_blank)?;
        let top = blank.highest(front, back).min(limits.top);
        let chain = prolonged(&contour, &left, layers, front);
        let nose = layers.nose.radius;
        let grown = |disc: f64, down: f64| Grown { along: left.along, up: left.up - down, disc: left.around + disc };
        let bare = Profile::new(&chain, grown(0.0, 0.0));
        let edge = front.max(limits.near) - left.along - left.around;
        let reached = bare.highest(f64::NEG_INFINITY, edge + LEVEL);
        let floor = if reached == f64::NEG_INFINITY { start.y } else { reached }.max(limits.bottom);
        // A contour that begins at the blank may have nothing but relief cuts; finishing follows what is there.
        let above = top > floor + LEVEL;
        let floor = floor.min(top);
        if !above && layers.operation == Operation::Rough && layers.relief == Relief::Left {
            return Err(no_blank());
        }
        if front < limits.near - LEVEL && blank.highest(front, limits.near) > floor + LEVEL {
            return Err(codes::G3303::area_that_is_machined_begins_inside());
        }
        let mut rough = Profile::new(&chain, grown(nose, nose));
        let far = limits.far - nose;
        if far.is_finite() {
            rough = rough.walled(far, WALL);
        }
        if limits.bottom.is_finite() {
            rough = rough.raised(limits.bottom);
        }
        let levels = if above { levels(layers, &contour, &left, top, floor)? } else { vec![top] };
        if !above && layers.operation != Operation::Finish {
            let begin = rough.first_above(floor - 3.0 * LEVEL, f64::NEG_INFINITY).unwrap_or(start.x);
            if rough.dips(Point2::new(begin, floor), top, LEAST_DIP).is_empty() {
                return Err(no_blank());
            }
        }
        check_chips(layers, end.x - front, &levels)?;
        let heights = contour.iter().flat_map(quarters).flat_map(|e| [e.from().y, e.to().y]);
        let crest = (heights.fold(f64::NEG_INFINITY, f64::max) + left.up + left.around).min(top);
        let behind = rough.mirrored();
        let mut finished = Profile::new(&contour, Grown { along: 0.0, up: -nose, disc: nose });
        if limits.bottom.is_finite() {
            finished = finished.raised(limits.bottom);
        }
        Ok(Region {
            layers,
            view,
            contour,
            rough,
            behind,
            finished,
            blank,
            front,
            levels,
            far,
            least: limits.bottom,
            is_capped: limits.top.is_finite(),
            crest,
        })
    }

    pub fn top(&self) -> f64 {
        self.levels.first().copied().unwrap_or(0.0)
    }

    pub fn floor(&self) -> f64 {
        self.levels.last().copied().unwrap_or(0.0)
    }

    pub fn nose(&self) -> f64 {
        self.layers.nose.radius
    }

    /// From the lowest point below the nose centre to the programmed point.
    fn to_tip(&self) -> Vec2 {
        self.view.vector(self.layers.nose.tip) * self.nose() + Vec2::new(0.0, self.nose())
    }

    /// The programmed point.
    pub fn tip(&self, p: Point2) -> Point2 {
        p + self.to_tip()
    }

    /// Where the cycle begins and ends.
    pub fn home(&self) -> Point2 {
        self.view.point(self.layers.parked()) - self.to_tip()
    }

    /// Greatest height in front of the nose.
    pub fn highest_before(&self, x: f64) -> f64 {
        self.highest_between(f64::NEG_INFINITY, x - LEVEL)
    }

    /// Greatest height on the way from one place to another, which may be higher than the blank and the area.
    pub fn highest_between(&self, a: f64, b: f64) -> f64 {
        let high = self.rough.highest(a.min(b), a.max(b));
        if high < WALL / 2.0 { high } else { self.top() }
    }

    /// Does a way of the programmed point keep out of the blank and of what lies below it?
    pub fn is_free(&self, from: Point2, way: &[Point2]) -> bool {
        let by = self.to_tip();
        let mut at = from - by;
        way.iter().all(|to| {
            let (a, b) = (std::mem::replace(&mut at, to - by), to - by);
            // The nose reaches its radius farther.
            let edge = self.front - self.nose();
            let inside = |p: Point2| p.x > edge + LEVEL && p.y < self.top() - LEVEL;
            if inside(a) || inside(b) {
                return false;
            }
            // Both ends are outside: only a way across the corner of the blank leads through it.
            let (low, high) = if a.x <= b.x { (a, b) } else { (b, a) };
            if low.x > edge || high.x <= edge {
                return true;
            }
            low.y + (high.y - low.y) * ((edge - low.x) / (high.x - low.x)) >= self.top() - LEVEL
        })
    }
}

/// The borders of the area in the view.
struct Limits {
    near: f64,
    far: f64,
    bottom: f64,
    top: f64,
}

impl Limits {
    fn of(layers: &Layers, view: &View) -> Limits {
        let along = |v: f64| view.point(Point2::new(v, v)).x;
        let (cut, infeed) = if layers.into.is_radial() {
            (layers.limits.z, layers.limits.x)
        } else {
            (layers.limits.x, layers.limits.z)
        };
        let seen = |pair: [Option<f64>; 2], place: &dyn Fn(f64) -> f64| {
            let [a, b] = pair.map(|v| v.map(place));
            match (a, b) {
                (Some(a), Some(b)) => (a.min(b), a.max(b)),
                // One border alone: the first lies in front and at the smaller radius, the second behind and at the larger one.
                (a, b) => (a.unwrap_or(f64::NEG_INFINITY), b.unwrap_or(f64::INFINITY)),
            }
        };
        let (near, far) = seen(cut, &along);
        let (bottom, top) = seen(infeed, &|v| view.height(v));
        Limits { near, far, bottom, top }
    }
}

/// All cuts together are interrupted no more often than cuts may be.
fn check_chips(layers: &Layers, length: f64, levels: &[f64]) -> Result<(), Fault> {
    let Some(chips) = layers.chips else { return Ok(()) };
    let count = infeed::steps(length, chips.every).saturating_mul(levels.len() as u64);
    if layers.operation == Operation::Finish || count <= MOST_CUTS {
        return Ok(());
    }
    Err(codes::G3040::cuts_are_interrupted_times(&count, &MOST_CUTS))
}

fn check_nose(layers: &Layers, view: &View) -> Result<(), Fault> {
    if layers.nose.radius > 0.0 && view.vector(layers.nose.tip).y > 0.0 {
        return Err(codes::G3302::cutting_edge_of_tool_points_out());
    }
    Ok(())
}

fn no_contour() -> Fault {
    codes::G3047::contour_does_not_run_from_side()
}

fn no_blank() -> Fault {
    codes::G3046::blank_does_not_reach_above_contour()
}

/// The contour with what lies in front of it and behind it: level or tangential, and a wall at the end. Seen from a corner of
/// the stock the wall stands at the end itself.
fn prolonged(contour: &[Element], left: &Left, layers: &Layers, front: f64) -> Vec<Element> {
    let (Some(first), Some(last)) = (contour.first(), contour.last()) else { return Vec::new() };
    let (start, end) = (first.from(), last.to());
    let corner = matches!(layers.blank, Blank::Corner(_));
    let nose = layers.nose.radius;
    let more = layers.clearance.lift + left.along + left.up + left.around + nose;
    let rises = |u: Option<Vec2>| u.filter(|u| u.y > LEVEL && u.x >= -LEVEL);
    let before = match rises(first.start_direction()) {
        Some(u) if !corner => start - u * more,
        _ => start - Vec2::new(more + (start.x - front).max(0.0), 0.0),
    };
    let disc = left.around + nose;
    let (foot, beyond) = match (rises(last.end_direction()), last.end_direction()) {
        _ if corner => (end, end),
        (Some(u), _) => (end, end + u * more),
        // The nose goes on as far as it touches a falling end, and at a level one as far as its own centre.
        (None, Some(u)) => {
            let sine = (-u.y).max(0.0);
            let foot = end + u * (disc * sine / (1.0 + u.x.max(0.0)));
            (foot, Point2::new(end.x + disc * (1.0 + sine) + left.along, foot.y))
        }
        (None, None) => (end, end),
    };
    let behind = [end, foot, beyond, Point2::new(beyond.x, WALL), Point2::new(beyond.x + WALL, WALL)];
    let line = |pair: &[Point2]| Element::Line { from: pair[0], to: pair[1] };
    let mut chain = Vec::with_capacity(contour.len() + 5);
    chain.push(Element::Line { from: before, to: start });
    chain.extend_from_slice(contour);
    chain.extend(behind.windows(2).map(line));
    chain.retain(|element| element.from() != element.to());
    chain
}

/// Heights of the cuts, from the blank on, which is the first.
fn levels(layers: &Layers, contour: &[Element], left: &Left, top: f64, floor: f64) -> Result<Vec<f64>, Fault> {
    if layers.operation == Operation::Finish {
        return Ok(vec![top, floor]);
    }
    let mut ends = vec![floor];
    if layers.segmentation == Segmentation::Edges {
        let lifted = |p: Point2| p.y + left.up + left.around;
        let edges = contour.iter().flat_map(|e| [lifted(e.from()), lifted(e.to())]);
        ends.extend(edges.filter(|y| *y > floor + LEVEL && *y < top - LEVEL));
        ends.sort_by(|a, b| b.total_cmp(a));
        ends.dedup_by(|a, b| (*a - *b).abs() <= LEVEL);
    }
    let mut list = vec![top];
    let mut from = top;
    for end in ends {
        list.extend(infeed::heights(from, end, layers.most, (MOST_CUTS + 1).saturating_sub(list.len() as u64))?);
        from = end;
    }
    Ok(list)
}
