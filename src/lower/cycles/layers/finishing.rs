//! One cut along the finished contour.

use crate::diag::{Fault, codes};
use crate::geo::element::quarters;
use crate::geo::profile::{LEVEL, Leg, backwards};
use crate::geo::{Element, Point2, Vec2, distance, left, length, offset};
use crate::ir::cycle::layers::Relief;

use super::Cutter;
use super::region::Region;

/// A way of the nose: where it starts and its legs.
struct Path {
    start: Point2,
    legs: Vec<Leg>,
}

impl Cutter<'_> {
    /// # Errors
    /// G3049 no room for the nose.
    pub(super) fn finish(&mut self) -> Result<(), Fault> {
        let region = self.region;
        let layers = region.layers;
        let mut path = finished(region)?;
        let reach = {
            let left = &layers.allowance;
            layers.clearance.lift + left.axes.x + left.axes.y + left.around
        };
        if layers.finish_backwards {
            let end = path.legs.last().map_or(path.start, Leg::to);
            path = Path { start: end, legs: backwards(path.start, &path.legs) };
        }
        let Some(first) = path.legs.first() else { return Ok(()) };
        let Some(u) = start_of(path.start, first) else { return Ok(()) };
        let home = region.home();
        self.go_home();
        if layers.finish_backwards || u.y < -0.1 {
            // From above.
            let over = path.start - u * reach;
            let free = u.y < -0.1 && over.x <= path.start.x + LEVEL;
            let over = if free { over } else { path.start + Vec2::new(0.0, reach) };
            // Above what roughing left beside it.
            let left = region.rough.height(over.x).min(home.y);
            let over = Point2::new(over.x, over.y.max(left));
            self.rapid_x(over.x);
            self.rapid(over);
        } else {
            let beside = beside(region, path.start, u, reach);
            self.rapid(Point2::new(home.x.min(beside.x), home.y));
            self.rapid_y(beside.y);
            // What stands in front of the contour was cut down to its deepest cut only.
            let stands = region.front < beside.x + region.nose() && beside.y < region.floor() - LEVEL;
            if stands {
                self.line(beside, layers.feeds.finish);
            } else {
                self.rapid(beside);
            }
        }
        self.line(path.start, layers.feeds.finish);
        self.legs(&path.legs, layers.feeds.finish);
        self.leave(&path);
        Ok(())
    }

    /// Off the contour, at right angles to it, but never on beyond its end.
    fn leave(&mut self, path: &Path) {
        let region = self.region;
        let from = path.legs.len().checked_sub(2).and_then(|at| path.legs.get(at)).map_or(path.start, Leg::to);
        let Some(u) = path.legs.last().and_then(|leg| end_of(from, leg)) else { return };
        let u = if region.layers.finish_backwards { -u } else { u };
        let lift = region.layers.clearance.lift;
        let away = left(u);
        let back = self.at + away * lift;
        let free = region.finished.highest(back.x, self.at.x - LEVEL) <= back.y.min(self.at.y) + LEVEL;
        let to = if away.x > LEVEL || away.y < -LEVEL || !free {
            // Along a wall, through what roughing left in front of it.
            let stands = region.rough.height(self.at.x).min(region.top());
            Point2::new(self.at.x, (self.at.y + lift).max(stands))
        } else {
            back
        };
        self.line(to, region.layers.feeds.finish);
        if !region.layers.into.is_inside() {
            let out = region.home().y.max(self.at.y);
            self.rapid_y(out);
        }
    }
}

/// In front of the start: straight on into it where that keeps the nose off what roughing left at the face, else level.
fn beside(region: &Region<'_>, start: Point2, u: Vec2, reach: f64) -> Point2 {
    let left = &region.layers.allowance;
    let allowance = if region.layers.into.is_radial() { left.axes.x } else { left.axes.y } + left.around;
    let first = region.contour.first().map_or(region.front, |element| element.from().x);
    let clear = first.min(region.front) - allowance - 0.1 * region.layers.clearance.lift - region.nose();
    let ahead = start - u * reach;
    let natural = region.contour.first().is_some_and(|element| {
        let own = element.start_direction().unwrap_or(Vec2::x());
        distance(nose_at(element.from(), own, region.nose()), start) <= LEVEL
    });
    if natural && ahead.x <= clear { ahead } else { Point2::new((start.x - reach).min(clear), start.y) }
}

fn start_of(from: Point2, leg: &Leg) -> Option<Vec2> {
    element(from, leg).start_direction()
}

fn end_of(from: Point2, leg: &Leg) -> Option<Vec2> {
    element(from, leg).end_direction()
}

fn element(from: Point2, leg: &Leg) -> Element {
    match *leg {
        Leg::Line { to } => Element::Line { from, to },
        Leg::Arc { to, center, ccw } => Element::Arc { from, to, center, sweep: if ccw { 1.0 } else { -1.0 } },
    }
}

/// The nose where it touches a point of the contour that runs in the direction `u` there.
fn nose_at(p: Point2, u: Vec2, nose: f64) -> Point2 {
    p + left(u) * nose - Vec2::new(0.0, nose)
}

/// The way of the nose along the finished contour, inside of the limits.
fn finished(region: &Region<'_>) -> Result<Path, Fault> {
    let nose = region.nose();
    let (Some(first), Some(last)) = (region.contour.first(), region.contour.last()) else {
        return Ok(Path { start: Point2::origin(), legs: Vec::new() });
    };
    let touching = |p: Point2, u: Option<Vec2>| nose_at(p, u.unwrap_or(Vec2::x()), nose);
    let start = touching(first.from(), first.start_direction());
    let end = touching(last.to(), last.end_direction());
    let levels = region.layers.relief == Relief::Left;
    let limited = region.far.is_finite() || region.least.is_finite() || region.is_capped;
    let leans = region.contour.iter().flat_map(quarters).any(|e| e.to().x < e.from().x - LEVEL);
    if leans && !levels && !limited {
        return around(region);
    }
    let profile = &region.finished;
    // A falling start begins above its peak. Where a narrow place holds the nose up, it does not reach the ends.
    let held = |p: Point2| Point2::new(p.x, p.y.max(profile.height(p.x)));
    let mut start = match first.start_direction() {
        Some(u) if u.y < -LEVEL => held(first.from()),
        Some(u) if u.x <= LEVEL => start,
        _ => held(start),
    };
    let mut end = {
        let stop = held(end);
        // Over an end that it does not reach from the side the nose rolls until it touches it.
        let touches = || profile.first_about(last.to() - Vec2::new(0.0, nose), stop.x);
        if stop.y > end.y + LEVEL { touches().unwrap_or(stop) } else { stop }
    };
    if region.least.is_finite() && first.from().y < region.least - LEVEL {
        // The nose may meet what rises out of the border in front of the place where it would touch the first point.
        match profile.first_above(region.least, f64::NEG_INFINITY) {
            Some(x) => start = Point2::new(x, region.least),
            // All of it lies outside of the limits.
            None => return Ok(Path { start, legs: Vec::new() }),
        }
    }
    if let Some(x) = profile.first_above(region.top(), start.x).filter(|x| *x < end.x && region.is_capped) {
        end = Point2::new(x, region.top());
    }
    if end.x > region.far {
        end = Point2::new(region.far, profile.height(region.far));
    }
    if limited && end.x < start.x - LEVEL {
        // Nothing of it lies inside of the limits.
        return Ok(Path { start, legs: Vec::new() });
    }
    let legs = if levels { profile.rise(start, end) } else { profile.follow(start, end) };
    Ok(Path { start, legs })
}

/// Along a contour that leans over somewhere: parallel to it, as far as the nose finds room.
fn around(region: &Region<'_>) -> Result<Path, Fault> {
    let nose = region.nose();
    let parts = offset::parallel(&region.contour, nose).map_err(|_| codes::G3049::nose_of_tool_has_no_room())?;
    let down = Vec2::new(0.0, nose);
    let start = parts.first().map_or(Point2::origin(), |part| part.element.from()) - down;
    let legs = parts.iter().filter(|part| length(part.element.to() - part.element.from()) > LEVEL);
    let legs = legs.map(|part| match part.element {
        Element::Line { to, .. } => Leg::Line { to: to - down },
        Element::Arc { to, center, sweep, .. } => Leg::Arc { to: to - down, center: center - down, ccw: sweep > 0.0 },
    });
    Ok(Path { start, legs: legs.collect() })
}
