//! Places with most room between walls, exactly: where three walls are equally far, or two on opposite sides.

use crate::geo::{Element, Point2, Vec2, cross, direction, distance, grid, left};

use super::walls::{Walls, nearest_on, to_element};

/// How often a place is improved.
const STEPS: usize = 12;
/// A place that moves by less is found, mm.
const FOUND: f64 = 1e-11;
/// What the room of a place may differ from that of the walls it is made of, mm.
const EXACT: f64 = 1e-8;
/// Circles whose centres are nearer are about one centre, mm.
const CONCENTRIC: f64 = 1e-7;
/// Most walls about a place that are looked at.
const MOST: usize = 10;

/// What a place keeps off.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Site {
    Line {
        at: Point2,
        along: Vec2,
    },
    /// A circle, or a point where the radius is 0.
    Round {
        center: Point2,
        radius: f64,
    },
}

impl Site {
    /// Distance from `p`, and the direction in which it grows.
    fn gradient(&self, p: Point2) -> Option<(f64, Vec2)> {
        match *self {
            Site::Line { at, along } => {
                let off = cross(along, p - at);
                let side = if off < 0.0 { -1.0 } else { 1.0 };
                Some((off.abs(), left(along) * side))
            }
            Site::Round { center, radius } => {
                let out = direction(p - center, 1e-9)?;
                let off = distance(p, center) - radius;
                Some(if off < 0.0 { (-off, -out) } else { (off, out) })
            }
        }
    }

    /// Through which point each way square to it goes; none for a line.
    fn center(&self) -> Option<Point2> {
        match *self {
            Site::Line { .. } => None,
            Site::Round { center, .. } => Some(center),
        }
    }

    /// Its points on a way square to it, as lengths from `from` along `unit`.
    fn feet(&self, from: Point2, unit: Vec2) -> [f64; 2] {
        match *self {
            Site::Line { at, along } => {
                let slope = cross(along, unit);
                [cross(along, at - from) / slope; 2]
            }
            Site::Round { center, radius } => {
                let middle = (center - from).dot(&unit);
                [middle - radius, middle + radius]
            }
        }
    }
}

/// The place with most room within `reach` of `near`, and its room; `None` where there is none but at the edge of the reach. `most` is the
/// room of a place, below 0 outside of the area.
pub fn peak(walls: &Walls, near: Point2, reach: f64, most: impl Fn(Point2) -> f64) -> Option<(Point2, f64)> {
    let sites = sites_about(walls, near, reach);
    let mut best: Option<(Point2, f64)> = None;
    let mut take = |p: Point2, room: f64| {
        let fits = distance(p, near) <= reach && (most(p) - room).abs() <= EXACT;
        let is_first = |best: (Point2, f64)| room >= best.1 - EXACT && grid::before(p, best.0).is_lt();
        if fits && best.is_none_or(|best| room > best.1 + EXACT || is_first(best)) {
            best = Some((p, room));
        }
    };
    for (i, a) in sites.iter().enumerate() {
        if let Site::Round { center, radius } = *a {
            // In a circle; at the round end of a slot.
            take(center, radius);
        }
        for (j, b) in sites.iter().enumerate().skip(i + 1) {
            for (p, room) in between(a, b) {
                take(p, room);
            }
            for c in &sites[j + 1..] {
                if let Some((p, room)) = equally_far([a, b, c], near) {
                    take(p, room);
                }
            }
        }
    }
    best
}

/// Lines, circles and ends of the walls that may be the nearest ones within reach of a place.
fn sites_about(walls: &Walls, near: Point2, reach: f64) -> Vec<Site> {
    let most = walls.distance(near) + 2.0 * reach + EXACT;
    let mut found: Vec<(f64, Site)> = Vec::new();
    let mut add = |away: f64, site: Site| {
        if away <= most && !found.iter().any(|(_, known)| same(known, &site)) {
            found.push((away, site));
        }
    };
    for wall in walls.elements() {
        let away = to_element(near, wall);
        if away > most {
            continue;
        }
        match *wall {
            Element::Line { from, to } => {
                if let Some(along) = direction(to - from, 0.0) {
                    add(away, Site::Line { at: from, along });
                }
            }
            Element::Arc { from, center, .. } => add(away, Site::Round { center, radius: distance(from, center) }),
        }
        for end in [wall.from(), wall.to()] {
            // An end counts where it may be nearer than what is beside it.
            if distance(nearest_on(near, wall), end) <= 2.0 * reach {
                add(distance(near, end), Site::Round { center: end, radius: 0.0 });
            }
        }
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    found.truncate(MOST);
    found.into_iter().map(|(_, site)| site).collect()
}

fn same(a: &Site, b: &Site) -> bool {
    match (*a, *b) {
        (Site::Line { at, along }, Site::Line { at: p, along: u }) => {
            cross(along, u).abs() < 1e-9 && cross(along, p - at).abs() < 1e-7
        }
        (Site::Round { center, radius }, Site::Round { center: p, radius: r }) => {
            distance(center, p) < 1e-7 && (radius - r).abs() < 1e-7
        }
        _ => false,
    }
}

/// Midway between two sites, where both are on opposite sides.
fn between(a: &Site, b: &Site) -> Vec<(Point2, f64)> {
    if let (Site::Round { center, radius }, Site::Round { center: other, radius: wider }) = (*a, *b)
        && distance(center, other) < CONCENTRIC
    {
        // All around there is the same room: at the ends of that circle along the axes.
        let middle = f64::midpoint(radius, wider);
        let ends = [Vec2::x(), Vec2::y(), -Vec2::x(), -Vec2::y()];
        return ends.map(|unit| (center + unit * middle, (radius - wider).abs() / 2.0)).to_vec();
    }
    let square = match (a, b) {
        (Site::Line { .. }, Site::Line { .. }) => None,
        (Site::Line { along, .. }, round) | (round, Site::Line { along, .. }) => {
            round.center().map(|center| (center, left(*along)))
        }
        (Site::Round { center, .. }, Site::Round { center: other, .. }) => {
            direction(*other - *center, CONCENTRIC).map(|unit| (*center, unit))
        }
    };
    let Some((from, unit)) = square else { return Vec::new() };
    let feet = |site: &Site| site.feet(from, unit);
    let pairs = feet(a).into_iter().flat_map(|s| feet(b).map(|t| (s, t)));
    pairs.map(|(s, t)| (from + unit * f64::midpoint(s, t), (s - t).abs() / 2.0)).collect()
}

/// The place equally far from three sites, next to `near`, and how far: Newton's method on distances, which are linear but for the bend
/// of circles.
fn equally_far(sites: [&Site; 3], near: Point2) -> Option<(Point2, f64)> {
    let mut p = near;
    for _ in 0..STEPS {
        let [a, b, c] = sites.map(|site| site.gradient(p));
        let ((da, ga), (db, gb), (dc, gc)) = (a?, b?, c?);
        // The differences of the distances vanish: (ga - gb) · s = db - da, (ga - gc) · s = dc - da.
        let (u, w) = (ga - gb, ga - gc);
        let det = cross(u, w);
        if det.abs() < 1e-9 {
            return None;
        }
        let (r, s) = (db - da, dc - da);
        let step = Vec2::new((r * w.y - s * u.y) / det, (s * u.x - r * w.x) / det);
        p += step;
        if crate::geo::length(step) < FOUND {
            let (room, _) = sites[0].gradient(p)?;
            return Some((p, room));
        }
        if crate::geo::length(p - near) > 1e6 {
            return None;
        }
    }
    None
}
