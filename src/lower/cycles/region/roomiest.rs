//! Where there is most room between walls.

use crate::geo::tolerance;
use crate::geo::{Point2, Vec2, grid, left};

use super::peak::peak;
use super::walls::Walls;

/// The point within a box for which `room` is largest; of equal ones the first by its first, then its second coordinate.
/// `room` changes by no more than the way does.
pub fn roomiest(walls: &Walls, low: Point2, high: Point2, room: impl Fn(Point2) -> f64) -> Option<(Point2, f64)> {
    let size = (high.x - low.x).max(high.y - low.y);
    if !(size > 0.0 && size.is_finite()) {
        return None;
    }
    // Squares about their middles, halved as long as one may hold a better point than is known.
    let mut half = size / CELLS as f64 / 2.0;
    let reach = |half: f64| half * core::f64::consts::SQRT_2;
    let middle = |i: usize| (2 * i + 1) as f64 * half;
    let mut squares: Vec<(Point2, f64)> = (0..CELLS)
        .flat_map(|i| (0..CELLS).map(move |j| (i, j)))
        .map(|(i, j)| Point2::new(low.x + middle(i), low.y + middle(j)))
        .filter(|p| p.x - half <= high.x + tolerance::SAME && p.y - half <= high.y + tolerance::SAME)
        .map(|p| (p, room(p)))
        .collect();
    let highest = |squares: &[(Point2, f64)]| squares.iter().map(|(_, room)| *room).fold(f64::MIN, f64::max);
    let mut most = highest(&squares);
    while reach(half) > size / FINEST {
        squares.retain(|(_, room)| room + reach(half) >= most);
        half /= 2.0;
        squares = squares
            .iter()
            .flat_map(|(p, _)| {
                [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)]
                    .map(|(i, j)| Point2::new(p.x + i * half, p.y + j * half))
            })
            .map(|p| (p, room(p)))
            .collect();
        most = most.max(highest(&squares));
    }
    let best = squares.iter().copied().fold(None, |best: Option<(Point2, f64)>, square| match best {
        Some(best) if square.1 <= best.1 + tolerance::SAME => Some(best),
        _ => Some(square),
    })?;
    // From the middle of a square no peak in it is farther than half a diagonal.
    let exactly = |p: Point2| peak(walls, p, 2.0 * half, &room);
    let highest = exactly(best.0).filter(|found| found.1 >= best.1).unwrap_or_else(|| climbed(best.0, half, &room));
    squares.retain(|(_, room)| room + reach(half) >= highest.1);
    squares.sort_by(|a, b| grid::before(a.0, b.0));
    squares.truncate(MOST_SQUARES);
    let first = |best: (Point2, f64), found: (Point2, f64)| {
        let equal = found.1 >= best.1 - tolerance::SAME && grid::before(found.0, best.0).is_lt();
        if found.1 > best.1 + tolerance::SAME || equal { found } else { best }
    };
    let peaks = squares.iter().filter_map(|(p, _)| exactly(*p)).reduce(first);
    let found = peaks.filter(|found| found.1 >= highest.1 - tolerance::SAME).unwrap_or_else(|| {
        let mut climbs = squares.iter().take(MOST_CLIMBS).map(|(p, _)| climbed(*p, half, &room));
        slid(climbs.find(|(_, room)| *room >= highest.1 - tolerance::SAME).unwrap_or(highest), half, &room)
    });
    let p = grid::point(found.0);
    Some((p, room(p)))
}

/// Squares along a side at first.
const CELLS: usize = 12;
/// Squares become smaller than this part of the box.
const FINEST: f64 = 400.0;
/// Most squares that are looked at for a place with the smallest coordinates.
const MOST_SQUARES: usize = 200;
const MOST_CLIMBS: usize = 100;

/// Along a ridge to its point with the smallest coordinates.
fn slid((mut p, known): (Point2, f64), half: f64, room: &impl Fn(Point2) -> f64) -> (Point2, f64) {
    for unit in [Vec2::x(), Vec2::y()] {
        let mut step = half;
        while step > 1e-9 {
            if room(p - unit * step) >= known - tolerance::SAME / 2.0 {
                p -= unit * step;
            } else {
                step /= 2.0;
            }
        }
    }
    (p, room(p))
}

/// From `p` to where no step leads to more room, with steps from `step` down. A step goes along an axis, and then across it to where there is
/// most: so it follows a ridge, however flat it is.
fn climbed(mut p: Point2, mut step: f64, room: &impl Fn(Point2) -> f64) -> (Point2, f64) {
    let mut best = room(p);
    while step > FINEST_STEP {
        let around = [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)].map(|(x, y)| {
            let along = Vec2::new(x, y) * step;
            most_across(p + along, left(along), room)
        });
        let found = around.into_iter().fold((p, best), |a, b| if b.1 > a.1 { b } else { a });
        if found.1 > best + LEAST_GAIN * step {
            (p, best) = found;
        } else {
            step /= 2.0;
        }
    }
    (p, best)
}

/// The point with most room from `q - reach` to `q + reach`.
fn most_across(q: Point2, reach: Vec2, room: &impl Fn(Point2) -> f64) -> (Point2, f64) {
    let (mut low, mut high) = (-1.0, 1.0);
    for _ in 0..THIRDS {
        let third = (high - low) / 3.0;
        if room(q + reach * (low + third)) < room(q + reach * (high - third)) {
            low += third;
        } else {
            high -= third;
        }
    }
    let found = q + reach * f64::midpoint(low, high);
    (found, room(found))
}

/// Shortest step of a climb, mm.
const FINEST_STEP: f64 = 1e-8;
/// Gains below this part of a step are none.
const LEAST_GAIN: f64 = 1e-6;
/// How often a way across is cut by a third.
const THIRDS: usize = 24;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geo::{Element, distance};

    fn polygon(corners: &[(f64, f64)]) -> Walls {
        let corner = |i: usize| Point2::from(<[f64; 2]>::from(corners[i % corners.len()]));
        Walls::new((0..corners.len()).map(|i| Element::Line { from: corner(i), to: corner(i + 1) }).collect())
    }

    /// Where there is most room from walls that stand counter-clockwise about it.
    fn most(corners: &[(f64, f64)]) -> (Point2, f64) {
        let walls = polygon(corners);
        let inside = |p: Point2| {
            walls.elements().iter().all(|wall| (p - wall.from()).dot(&left(wall.to() - wall.from())) >= 0.0)
        };
        let room = |p: Point2| if inside(p) { walls.distance(p) } else { -walls.distance(p) };
        let (mut low, mut high) = (Point2::new(f64::MAX, f64::MAX), Point2::new(f64::MIN, f64::MIN));
        for (x, y) in corners {
            low = Point2::new(low.x.min(*x), low.y.min(*y));
            high = Point2::new(high.x.max(*x), high.y.max(*y));
        }
        roomiest(&walls, low, high, room).expect("a box")
    }

    #[test]
    fn most_room_of_a_triangle_is_in_its_inscribed_circle() {
        // Sides 30, 40, 50: radius (30 + 40 - 50) / 2.
        let (p, room) = most(&[(0.0, 0.0), (40.0, 0.0), (0.0, 30.0)]);
        assert!(distance(p, Point2::new(10.0, 10.0)) < 1e-5 && (room - 10.0).abs() < 1e-6, "{p} {room}");
        // Sides 13, 14, 15: area 84, radius 4. The foot of the circle on the side of 14 is 21 - 13 from its end.
        let (p, room) = most(&[(0.0, 0.0), (14.0, 0.0), (9.0, 12.0)]);
        assert!(distance(p, Point2::new(8.0, 4.0)) < 1e-5 && (room - 4.0).abs() < 1e-6, "{p} {room}");
    }

    #[test]
    fn most_room_of_a_leaning_slot_is_on_its_ridge() {
        // 50 long, 10 wide, turned by the angle of a triangle of 3, 4 and 5.
        let (p, room) = most(&[(0.0, 0.0), (40.0, 30.0), (34.0, 38.0), (-6.0, 8.0)]);
        assert!((room - 5.0).abs() < 1e-6, "{p} {room}");
        // Its ridge begins 5 from the end, and that place is taken, which has the least X.
        let along = (p - Point2::new(-3.0, 4.0)).dot(&Vec2::new(0.8, 0.6));
        let aside = (p - Point2::new(-3.0, 4.0)).dot(&Vec2::new(-0.6, 0.8));
        assert!((along - 5.0).abs() < 1e-7 && aside.abs() < 1e-7, "{p} {along} {aside}");
    }
}
