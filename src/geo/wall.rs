//! The way of a round tool nose down a wall: the exact offset of a falling chain of lines and arcs.
//!
//! The chain runs towards +x and never rises; the material lies on its left and below. For every height of
//! the nose's lowest point there is one place where the nose touches. Each line, arc and corner of the chain
//! says how near it lets the nose come at a height; the greatest of these values wins. So the way cannot
//! gouge, whatever small element or narrow arc the chain has.
//!
//! ```text
//!   material │
//!            ╰─╮   ◯ nose
//!   ═══════════╰───────────
//! ```

use super::arc::NEARLY_ONE_POINT;
use super::{Element, Point2, SAME_DIRECTION, Vec2, cross, direction, distance, intersect, left};

/// An element may rise or lean over by this, mm: what arithmetic loses.
const SAME_HEIGHT: f64 = 1e-7;

/// Legs shorter than this are left out, mm. It must be small: where the way is level, heights that differ by
/// 1e-7 lie 1e-3 apart.
const SHORTEST_LEG: f64 = 2e-7;

/// Arcs with a shorter chord are lines, mm: they might be taken for full circles. The limit for that holds for
/// each axis, so a chord at 45 degrees may be √2 times as long.
const SHORTEST_ARC: f64 = 1.5 * NEARLY_ONE_POINT;

/// Curves closer than this are one, mm.
const SAME_CURVE: f64 = 1e-9;

/// A piece holds the nose this far below its end, mm, so that no rounding between two pieces lets it in.
const BELOW: f64 = 1e-9;

/// How a piece of the way runs. Points are those of the nose's lowest point below its centre.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Curve {
    /// Through `at`, `slope` = dx/dy.
    Line { at: Point2, slope: f64 },
    /// On a circle, on its right (`+1`) or left (`-1`) half.
    Circle { center: Point2, radius: f64, half: f64 },
}

/// What one line, arc or corner demands, from `high` (exclusive) down to `low`.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Demand {
    curve: Curve,
    high: f64,
    low: f64,
}

/// A wall as a nose of some radius sees it.
#[derive(Debug, Clone, PartialEq)]
pub struct Wall {
    pieces: Vec<Demand>,
    radius: f64,
}

/// A piece of the way down.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Leg {
    Line { to: Point2 },
    Arc { to: Point2, center: Point2, ccw: bool },
}

impl Leg {
    pub fn to(&self) -> Point2 {
        match *self {
            Leg::Line { to } | Leg::Arc { to, .. } => to,
        }
    }
}

/// Why a chain is no wall.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NoWall {
    /// An element rises, or leans over.
    Rises,
    /// An element does not start where the one before ends.
    Gap,
    Empty,
}

impl Wall {
    /// The wall of `chain` for a nose of `radius`. Above its start the wall goes straight up, below
    /// its end straight down.
    ///
    /// # Errors
    /// See [`NoWall`]. Arcs must not run through a quadrant point; see [`quarters`].
    pub fn new(chain: &[Element], radius: f64) -> Result<Wall, NoWall> {
        let start = chain.first().ok_or(NoWall::Empty)?.from();
        let mut wall = Wall { pieces: Vec::with_capacity(2 * chain.len() + 2), radius };
        let ray = Point2::new(start.x + radius, start.y);
        wall.add(Curve::Line { at: ray, slope: 0.0 }, f64::INFINITY, start.y - radius);
        let mut at = start;
        wall.corner(at);
        for element in chain {
            if distance(at, element.from()) > super::SAME_POINT {
                return Err(NoWall::Gap);
            }
            if !falls(element) {
                return Err(NoWall::Rises);
            }
            wall.element(element);
            at = element.to();
            wall.corner(at);
        }
        // So that every height has an answer, the wall goes straight down below its end.
        let ray = Point2::new(at.x + radius, at.y);
        wall.add(Curve::Line { at: ray, slope: 0.0 }, at.y - radius, f64::NEG_INFINITY);
        Ok(wall)
    }

    fn add(&mut self, curve: Curve, high: f64, low: f64) {
        if high > low {
            self.pieces.push(Demand { curve, high, low });
        }
    }

    /// The nose turns about a point of the chain.
    fn corner(&mut self, p: Point2) {
        let center = Point2::new(p.x, p.y - self.radius);
        self.add(Curve::Circle { center, radius: self.radius, half: 1.0 }, p.y, p.y - self.radius);
    }

    fn element(&mut self, element: &Element) {
        let r = self.radius;
        match *element {
            Element::Line { from, to } => {
                let Some(u) = direction(to - from, 0.0) else { return };
                let shift = left(u) * r - Vec2::new(0.0, r);
                let (a, b) = (from + shift, to + shift);
                // A level line is held up by its end corner.
                if a.y > b.y {
                    self.add(Curve::Line { at: a, slope: (b.x - a.x) / (b.y - a.y) }, a.y, b.y);
                }
            }
            Element::Arc { from, to, center, sweep } => {
                let arc = distance(from, center);
                // Material inside the arc, or outside of it.
                let (radius, half) = if sweep < 0.0 { (arc + r, 1.0) } else { (arc - r, -1.0) };
                if radius <= 0.0 || arc <= 0.0 {
                    return;
                }
                let height = |p: Point2| center.y + (p.y - center.y) / arc * radius - r;
                let seen = Point2::new(center.x, center.y - r);
                self.add(Curve::Circle { center: seen, radius, half }, height(from), height(to));
            }
        }
    }

    /// Least x of the nose centre when its lowest point is at height `y`.
    ///
    /// A piece also counts below its end: the wall falls, so nothing there lets the nose come nearer. So no
    /// rounding at the ends of pieces leaves a gap.
    pub fn touch(&self, y: f64) -> f64 {
        let asked = self.pieces.iter().filter(|piece| y < piece.high);
        asked.map(|piece| piece.curve.x(y.max(piece.low))).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The piece that holds the nose at height `y`.
    fn best(&self, y: f64) -> Option<usize> {
        let mut best: Option<(usize, f64)> = None;
        for (i, piece) in self.pieces.iter().enumerate() {
            if piece.low - BELOW <= y && y < piece.high {
                let x = piece.curve.x(y);
                if best.is_none_or(|(_, most)| x > most) {
                    best = Some((i, x));
                }
            }
        }
        best.map(|(i, _)| i)
    }

    /// The piece that holds the nose at height `y`; the one before as long as no other is really ahead, so that
    /// pieces that touch do not take turns.
    fn next(&self, y: f64, before: Option<usize>) -> Option<usize> {
        let best = self.best(y)?;
        let most = self.pieces[best].curve.x(y);
        let stays = |i: &usize| {
            let piece = &self.pieces[*i];
            piece.low - BELOW <= y && y < piece.high && piece.curve.x(y) > most - SAME_CURVE
        };
        Some(before.filter(stays).unwrap_or(best))
    }

    /// The way down from height `top` to `bottom`: where it starts, and its legs. x is the nose centre, y its
    /// lowest point.
    pub fn way(&self, top: f64, bottom: f64) -> (Point2, Vec<Leg>) {
        let mut at = Point2::new(self.touch(top), top);
        let start = at;
        let mut legs = Vec::new();
        let mut last: Option<usize> = None;
        // Where the leg under way starts, and how many legs there were before it.
        let (mut leg_start, mut before) = (at, 0);
        for pair in self.heights(top, bottom).windows(2) {
            let (high, low) = (pair[0], pair[1]);
            let Some(i) = self.next((high + low) / 2.0, last) else { continue };
            let curve = self.pieces[i].curve;
            let from = Point2::new(curve.x(high), high);
            if distance(from, at) > super::SAME_POINT {
                // A level piece of the chain, on which the nose rides.
                legs.push(Leg::Line { to: from });
                at = from;
                last = None;
            }
            let to = Point2::new(curve.x(low), low);
            if distance(to, at) <= SHORTEST_LEG {
                continue;
            }
            let goes_on = last.is_some_and(|last| self.pieces[last].curve.continues(&curve));
            if goes_on {
                legs.truncate(before);
            } else {
                (leg_start, before) = (at, legs.len());
            }
            curve.run(leg_start, to, &mut legs);
            last = Some(i);
            at = to;
        }
        (start, legs)
    }

    /// Heights between which one piece holds the nose, downwards.
    fn heights(&self, top: f64, bottom: f64) -> Vec<f64> {
        let mut list = vec![top, bottom];
        let mut take = |y: f64| {
            if y > bottom && y < top {
                list.push(y);
            }
        };
        for (i, a) in self.pieces.iter().enumerate() {
            take(a.high);
            take(a.low);
            for b in &self.pieces[i + 1..] {
                let (high, low) = (a.high.min(b.high), a.low.max(b.low));
                if high <= low {
                    continue;
                }
                for y in a.curve.meets(&b.curve).into_iter().flatten() {
                    if y > low && y < high {
                        take(y);
                    }
                }
            }
        }
        list.sort_by(|a, b| b.total_cmp(a));
        list.dedup();
        list
    }
}

impl Curve {
    fn x(&self, y: f64) -> f64 {
        match *self {
            Curve::Line { at, slope } => at.x + slope * (y - at.y),
            Curve::Circle { center, radius, half } => {
                let up = y - center.y;
                center.x + half * (radius * radius - up * up).max(0.0).sqrt()
            }
        }
    }

    /// Is `other` the same curve?
    fn continues(&self, other: &Curve) -> bool {
        match (*self, *other) {
            (Curve::Line { slope: a, .. }, Curve::Line { at, slope: b }) => {
                (a - b).abs() < SAME_CURVE && (self.x(at.y) - at.x).abs() < SAME_CURVE
            }
            (Curve::Circle { center: c, radius: r, half: a }, Curve::Circle { center: d, radius: s, half: b }) => {
                a == b && (r - s).abs() < SAME_CURVE && distance(c, d) < SAME_CURVE
            }
            _ => false,
        }
    }

    /// Downwards along the curve from `from` to `to`. A short arc becomes lines that leave material rather than
    /// gouge: its chord where the material lies outside, else the tangents of its ends.
    fn run(&self, from: Point2, to: Point2, legs: &mut Vec<Leg>) {
        if let Curve::Circle { center, radius, half } = *self {
            let chord = distance(from, to);
            if chord > SHORTEST_ARC {
                // Downwards on the right half is clockwise.
                legs.push(Leg::Arc { to, center, ccw: half < 0.0 });
                return;
            }
            let (a, b) = (from - center, to - center);
            let square = radius * radius;
            let reach = square + a.dot(&b);
            // Within a quarter the ends are never more than a right angle apart, unless arithmetic made them so.
            if half > 0.0 && chord > super::SAME_POINT && reach > square / 2.0 {
                legs.push(Leg::Line { to: center + (a + b) * (square / reach) });
            }
        }
        legs.push(Leg::Line { to });
    }

    /// Heights at which two curves meet.
    fn meets(&self, other: &Curve) -> [Option<f64>; 2] {
        let unit = |slope: f64| direction(Vec2::new(slope, 1.0), 0.0).unwrap_or_default();
        let heights = |pair: Option<[Point2; 2]>| match pair {
            Some([a, b]) => [Some(a.y), Some(b.y)],
            None => [None, None],
        };
        match (*self, *other) {
            (Curve::Line { at: p, slope: a }, Curve::Line { at: q, slope: b }) => {
                let u = unit(a);
                [intersect::lines(p, u, q, unit(b), SAME_DIRECTION).map(|(s, _)| p.y + s * u.y), None]
            }
            (Curve::Line { at, slope }, Curve::Circle { center, radius, .. })
            | (Curve::Circle { center, radius, .. }, Curve::Line { at, slope }) => {
                heights(intersect::line_circle(at, unit(slope), center, radius, 0.0))
            }
            (Curve::Circle { center: a, radius: ra, .. }, Curve::Circle { center: b, radius: rb, .. }) => {
                heights(intersect::circles(a, ra, b, rb, 0.0))
            }
        }
    }
}

/// Does the element run towards +x and never rise? Arcs lie within a quarter.
fn falls(element: &Element) -> bool {
    let way = element.to() - element.from();
    if way.x < -SAME_HEIGHT || way.y > SAME_HEIGHT {
        return false;
    }
    match *element {
        Element::Line { .. } => true,
        // Within a quarter both coordinates run one way only; which quarter it is shows in the middle.
        Element::Arc { from, center, sweep, .. } => {
            let middle = element.middle() - from;
            sweep.abs() <= core::f64::consts::FRAC_PI_2 + 1e-9
                && middle.x >= -SAME_HEIGHT
                && middle.y <= SAME_HEIGHT
                && distance(from, center) > 0.0
        }
    }
}

/// The element in pieces between its leftmost, topmost, rightmost and lowest points.
pub fn quarters(element: &Element) -> Vec<Element> {
    let Element::Arc { from, to, center, sweep } = *element else { return vec![*element] };
    let radius = distance(from, center);
    let poles = [Vec2::x(), Vec2::y(), -Vec2::x(), -Vec2::y()];
    let mut cuts: Vec<(f64, Point2)> = poles
        .iter()
        .filter_map(|pole| {
            let start = from - center;
            let turn = libm::atan2(cross(start, *pole), start.dot(pole));
            let turn = if sweep > 0.0 { turn } else { -turn };
            let turn = if turn <= 0.0 { turn + core::f64::consts::TAU } else { turn };
            // A pole at an end cuts nothing off.
            let near = 1e-9;
            (turn > near && turn < sweep.abs() - near && turn < core::f64::consts::TAU - near)
                .then_some((turn, center + *pole * radius))
        })
        .collect();
    cuts.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut list = Vec::with_capacity(cuts.len() + 1);
    let (mut at, mut done) = (from, 0.0);
    let sign = sweep.signum();
    for (turn, p) in cuts {
        list.push(Element::Arc { from: at, to: p, center, sweep: sign * (turn - done) });
        (at, done) = (p, turn);
    }
    list.push(Element::Arc { from: at, to, center, sweep: sweep - sign * done });
    list
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(a: (f64, f64), b: (f64, f64)) -> Element {
        Element::Line { from: Point2::new(a.0, a.1), to: Point2::new(b.0, b.1) }
    }

    fn near(a: Point2, b: (f64, f64)) -> bool {
        (a - Point2::new(b.0, b.1)).norm() < 1e-9
    }

    #[test]
    fn a_vertical_wall_is_one_line() {
        let wall = Wall::new(&[line((0.0, 0.0), (0.0, -5.0))], 0.2).unwrap();
        let (start, legs) = wall.way(1.0, -5.0);
        assert!(near(start, (0.2, 1.0)));
        assert!(matches!(legs[..], [Leg::Line { to }] if near(to, (0.2, -5.0))), "{legs:?}");
    }

    #[test]
    fn a_sharp_edge_is_rolled_over() {
        // Rim, edge, vertical wall.
        let wall = Wall::new(&[line((-3.0, 0.0), (0.0, 0.0)), line((0.0, 0.0), (0.0, -5.0))], 0.5).unwrap();
        let (start, legs) = wall.way(1.0, -5.0);
        assert!(near(start, (-2.5, 1.0)));
        let ends: Vec<Point2> = legs.iter().map(Leg::to).collect();
        assert!(near(*ends.last().unwrap(), (0.5, -5.0)));
        assert!(ends.iter().any(|p| near(*p, (0.0, 0.0))), "{ends:?}");
        let arc = legs.iter().find(|leg| matches!(leg, Leg::Arc { .. })).unwrap();
        let Leg::Arc { to, center, ccw } = *arc else { unreachable!() };
        assert!(near(to, (0.5, -0.5)) && near(center, (0.0, -0.5)) && !ccw);
    }

    #[test]
    fn a_long_arc_with_a_short_rest_stays_an_arc() {
        // Far from the axes rounding cuts the arc in two where the wall turns upright; the second is next to nothing.
        let bulge = Element::Arc {
            from: Point2::new(-80.76707189016575, 52.1),
            to: Point2::new(-80.66707189016574, 52.0),
            center: Point2::new(-80.76707189016575, 52.0),
            sweep: -core::f64::consts::FRAC_PI_2,
        };
        let foot = Point2::new(-80.66707189016574, 50.0);
        let wall = Wall::new(&[bulge, Element::Line { from: bulge.to(), to: foot }], 0.9168178244483085).unwrap();
        let (_, legs) = wall.way(53.1, 50.0);
        let arcs: Vec<&Leg> = legs.iter().filter(|leg| matches!(leg, Leg::Arc { .. })).collect();
        let end = (foot.x + wall.radius, 52.0 - wall.radius);
        assert!(
            matches!(arcs[..], [Leg::Arc { to, .. }] if (*to - Point2::new(end.0, end.1)).norm() < 1e-6),
            "{legs:?}"
        );
    }

    #[test]
    fn a_short_arc_becomes_lines_that_do_not_gouge() {
        // A quarter of 5e-4 mm about the edge: its chord would come nearer than the nose is round.
        let (r, edge) = (5e-4, Point2::new(0.0, 0.0));
        let wall = Wall::new(&[line((-3.0, 0.0), (0.0, 0.0)), line((0.0, 0.0), (0.0, -5.0))], r).unwrap();
        let (start, legs) = wall.way(1.0, -5.0);
        let mut at = start;
        for leg in &legs {
            assert!(matches!(leg, Leg::Line { .. }), "{legs:?}");
            for i in 0..=1000 {
                let p = at + (leg.to() - at) * (f64::from(i) / 1000.0);
                let near = distance(Point2::new(p.x, p.y + r), edge);
                assert!(near > r - 1e-9, "{near} at {p:?}");
            }
            at = leg.to();
        }
    }

    #[test]
    fn an_arc_narrower_than_the_nose_is_bridged() {
        // A hollow of radius 0.3 at the foot of a wall; the nose of 0.5 touches the wall only.
        let foot = Element::Arc {
            from: Point2::new(0.0, -4.7),
            to: Point2::new(0.3, -5.0),
            center: Point2::new(0.3, -4.7),
            sweep: core::f64::consts::FRAC_PI_2,
        };
        let wall = Wall::new(&[line((0.0, 0.0), (0.0, -4.7)), foot], 0.5).unwrap();
        assert!((wall.touch(-5.0) - 0.5).abs() < 1e-12);
        let large = Wall::new(&[line((0.0, 0.0), (0.0, -4.7)), foot], 0.1).unwrap();
        // The nose of 0.1 follows: at the floor its centre is below the centre of the hollow.
        assert!((large.touch(-5.0) - 0.3).abs() < 1e-12);
    }

    #[test]
    fn a_slope_offsets_by_its_normal() {
        let wall = Wall::new(&[line((0.0, 0.0), (5.0, -5.0))], 1.0).unwrap();
        // Centre on the line x + y = √2, centre height y + 1.
        assert!((wall.touch(-3.0) - (2f64.sqrt() + 2.0)).abs() < 1e-12);
    }

    /// A slope with a hollow at its foot, far from the origin: rounding puts the end of the hollow a little above the floor.
    #[test]
    fn the_way_never_turns_back_at_the_foot() {
        let (sin, cos) = libm::sincos(37.662_f64.to_radians());
        let (depth, hollow, nose) = (4.055, 1.566, 0.681);
        for k in 0..200 {
            let rim = Point2::new(150.0 + 0.0137 * f64::from(k), -7.0 + 0.003 * f64::from(k));
            let foot = rim + Vec2::new(depth * sin / cos, -depth);
            let back = hollow * (1.0 - sin) / cos;
            let slope = line((rim.x, rim.y), (foot.x - back * sin, foot.y + back * cos));
            let center = Point2::new(foot.x + back, foot.y + hollow);
            let end = Point2::new(center.x, foot.y);
            let sweep = libm::acos(sin);
            let arc = Element::Arc { from: slope.to(), to: end, center, sweep };
            let wall = Wall::new(&[slope, arc], nose).unwrap();
            let (start, legs) = wall.way(rim.y + 1.0, foot.y);
            let mut at = start.x;
            for leg in &legs {
                assert!(leg.to().x >= at - 1e-6, "{k}: {legs:?}");
                at = leg.to().x;
            }
            assert!((at - center.x).abs() < 1e-5, "{k}: {at} {}", center.x);
        }
    }

    #[test]
    fn rising_and_overhanging_chains_are_no_walls() {
        assert_eq!(Wall::new(&[line((0.0, 0.0), (1.0, 1.0))], 0.1), Err(NoWall::Rises));
        assert_eq!(Wall::new(&[line((0.0, 0.0), (-1.0, -1.0))], 0.1), Err(NoWall::Rises));
        assert_eq!(Wall::new(&[], 0.1), Err(NoWall::Empty));
        let gap = [line((0.0, 0.0), (1.0, -1.0)), line((2.0, -1.0), (3.0, -2.0))];
        assert_eq!(Wall::new(&gap, 0.1), Err(NoWall::Gap));
    }

    #[test]
    fn quarters_of_a_half_circle() {
        let half = Element::Arc {
            from: Point2::new(0.0, 0.0),
            to: Point2::new(4.0, 0.0),
            center: Point2::new(2.0, 0.0),
            sweep: core::f64::consts::PI,
        };
        let parts = quarters(&half);
        assert_eq!(parts.len(), 2);
        assert!(near(parts[0].to(), (2.0, -2.0)) && near(parts[1].to(), (4.0, 0.0)));
    }
}
