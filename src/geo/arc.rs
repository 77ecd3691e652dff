//! Arcs from the data that part programs give.

use core::f64::consts::TAU;

use super::{Point2, Vec2, cross, distance, left, length};

/// Start and end of an arc that differ by no more than this in each axis, in mm, are one point: half the
/// last digit (0.0001 mm) to which programs are written. One of the two may be exact and the other rounded.
pub const ONE_POINT: f64 = 5e-5;
/// Up to this difference, in mm, a program of few decimal places may mean a full circle as well as an arc
/// that is next to nothing.
pub const NEARLY_ONE_POINT: f64 = 5e-4;

/// Do start and end of an arc that can be a full circle make one?
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Closing {
    /// They are one point: a full circle.
    Closed,
    /// Too far apart for rounding, too near for an arc anybody programs.
    Unclear,
    Open,
}

/// How an arc closes whose ends differ by `gap`. A gap that is no number is open, which later checks refuse.
pub fn closing(gap: Vec2) -> Closing {
    let most = gap.x.abs().max(gap.y.abs());
    // A hair of room for what the subtraction loses.
    if most <= ONE_POINT + 1e-9 {
        Closing::Closed
    } else if most <= NEARLY_ONE_POINT + 1e-9 {
        Closing::Unclear
    } else {
        Closing::Open
    }
}

/// Signed sweep in rad of the arc `from` → `to` about `center`: in `(0, 2π]` counter-clockwise, in
/// `[-2π, 0)` clockwise. Equal directions give a whole turn.
pub fn sweep(from: Point2, to: Point2, center: Point2, ccw: bool) -> f64 {
    let (a, b) = (from - center, to - center);
    let angle = libm::atan2(cross(a, b), a.dot(&b));
    match (ccw, angle > 0.0) {
        (true, true) => angle,
        (true, false) => angle + TAU,
        (false, true) => angle - TAU,
        (false, false) if angle == 0.0 => -TAU,
        (false, false) => angle,
    }
}

/// Centre of the arc of `radius` from `from` to `to`: under half a turn for a positive radius, over half
/// a turn for a negative one.
///
/// `None` if the points coincide within `same`, or lie further apart than twice the radius by more than
/// `tol`. A half circle that misses its end by rounding (within `tol`) gets the middle as its centre.
pub fn center_by_radius(from: Point2, to: Point2, radius: f64, ccw: bool, same: f64, tol: f64) -> Option<Point2> {
    let chord = to - from;
    let d = length(chord);
    if d <= same || d > 2.0 * radius.abs() + tol {
        return None;
    }
    let half = d / 2.0;
    let height = (radius.abs() * radius.abs() - half * half).max(0.0).sqrt();
    let side = if ccw == (radius > 0.0) { height } else { -height };
    Some(from + chord / 2.0 + left(chord) * (side / d))
}

/// The arc that leaves `from` in direction `tangent` (a unit vector) and ends in `to`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TangentArc {
    Arc {
        center: Point2,
        ccw: bool,
    },
    /// The end lies straight ahead.
    Line,
    /// The end lies straight behind; no arc gets there.
    Behind,
    /// Start and end coincide.
    Nothing,
}

/// Finds the tangential arc; `tol` is the sideways distance in mm under which the end counts as straight ahead.
pub fn tangent_arc(from: Point2, tangent: Vec2, to: Point2, same: f64, tol: f64) -> TangentArc {
    let v = to - from;
    let d = length(v);
    if d <= same {
        return TangentArc::Nothing;
    }
    let aside = cross(tangent, v);
    if aside.abs() <= tol {
        return if tangent.dot(&v) > 0.0 { TangentArc::Line } else { TangentArc::Behind };
    }
    // |to - C| = |from - C| with C = from + k·left(tangent) gives k = |v|² / (2·v·left(tangent)).
    let k = d * d / (2.0 * aside);
    TangentArc::Arc { center: from + left(tangent) * k, ccw: k > 0.0 }
}

/// Centre of the arc from `from` to `to` that sweeps `sweep` rad, less than a turn either way. `None` if the
/// points coincide within `same` or the angle is none.
pub fn center_by_opening(from: Point2, to: Point2, sweep: f64, same: f64) -> Option<Point2> {
    let chord = to - from;
    let half = libm::sin(sweep / 2.0);
    if length(chord) <= same || half == 0.0 || sweep.abs() >= TAU {
        return None;
    }
    Some(from + chord / 2.0 + left(chord) * (libm::cos(sweep / 2.0) / (2.0 * half)))
}

/// Centre and sense of the arc from `from` through `via` to `to`; `None` for points on one line.
pub fn through(from: Point2, via: Point2, to: Point2, same: f64) -> Option<(Point2, bool)> {
    let (a, b) = (via - from, to - from);
    let area = cross(a, b);
    let longest = length(a).max(length(b)).max(distance(via, to));
    let shortest = length(a).min(length(b)).min(distance(via, to));
    if shortest <= same || area.abs() <= same * longest {
        return None;
    }
    let (aa, bb) = (a.dot(&a), b.dot(&b));
    let center = from + Vec2::new(b.y * aa - a.y * bb, a.x * bb - b.x * aa) / (2.0 * area);
    Some((center, area > 0.0))
}

/// Moves `center` onto the perpendicular bisector of `from` and `to`, so that both have the same distance.
/// The points must not coincide.
pub fn centered_between(from: Point2, to: Point2, center: Point2) -> Point2 {
    let chord = to - from;
    let middle = from + chord / 2.0;
    let along = (center - middle).dot(&chord) / chord.dot(&chord);
    center - chord * along
}

/// Direction of travel at `at` on an arc about `center`.
pub fn tangent_at(at: Point2, center: Point2, ccw: bool) -> Option<Vec2> {
    let radius = at - center;
    let r = length(radius);
    (r > 0.0).then(|| if ccw { left(radius) / r } else { -left(radius) / r })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn radius_arcs_of_the_manual() {
        // (40,40) to (70,40), R 20: the four arcs of the manual's figure.
        let (a, b) = (Point2::new(40.0, 40.0), Point2::new(70.0, 40.0));
        let y = |r, ccw| center_by_radius(a, b, r, ccw, 1e-6, 0.0).unwrap().y;
        assert!(y(20.0, false) < 40.0 && y(20.0, true) > 40.0);
        assert!(y(-20.0, false) > 40.0 && y(-20.0, true) < 40.0);
        assert!(center_by_radius(a, b, 14.9, true, 1e-6, 0.01).is_none());
    }

    #[test]
    fn sweeps_of_quarters_go_the_way_that_is_said() {
        let (east, north, zero) = (Point2::new(1.0, 0.0), Point2::new(0.0, 1.0), Point2::origin());
        let quarters = |from, to, ccw| sweep(from, to, zero, ccw) / (TAU / 4.0);
        for (from, to, ccw, wanted) in [
            (east, north, true, 1.0),
            (east, north, false, -3.0),
            (north, east, true, 3.0),
            (north, east, false, -1.0),
            (east, east, true, 4.0),
            (east, east, false, -4.0),
        ] {
            let found = quarters(from, to, ccw);
            assert!((found - wanted).abs() < 1e-12, "{from} {to} {ccw}: {found}");
        }
    }

    #[test]
    fn centres_by_opening_and_through_a_point() {
        let (east, north) = (Point2::new(1.0, 0.0), Point2::new(0.0, 1.0));
        let opening = |quarters: f64| center_by_opening(east, north, quarters * TAU / 4.0, 1e-6).unwrap();
        for (quarters, wanted) in [(1.0, (0.0, 0.0)), (-3.0, (0.0, 0.0)), (-1.0, (1.0, 1.0)), (3.0, (1.0, 1.0))] {
            let found = opening(quarters);
            assert!(distance(found, Point2::from(<[f64; 2]>::from(wanted))) < 1e-12, "{quarters}: {found}");
        }
        assert!(
            center_by_opening(east, north, TAU, 1e-6).is_none() && center_by_opening(east, east, 1.0, 1e-6).is_none()
        );
        let half = core::f64::consts::FRAC_1_SQRT_2;
        for (via, ccw) in [(Point2::new(half, half), true), (Point2::new(-half, -half), false)] {
            let (center, sense) = through(east, via, north, 1e-6).unwrap();
            assert!(distance(center, Point2::origin()) < 1e-12 && sense == ccw, "{via}: {center} {sense}");
        }
        assert!(through(east, Point2::new(0.5, 0.5), north, 1e-6).is_none());
    }

    #[test]
    fn ends_within_rounding_are_one_point() {
        let at = |x, y| closing(Vec2::new(x, y));
        assert_eq!(at(0.0, 0.0), Closing::Closed);
        assert_eq!(at(17.320_508_08 - 17.3205, 0.0), Closing::Closed);
        assert_eq!(at(-5e-5, 5e-5), Closing::Closed);
        assert_eq!(at(0.0, 1e-4), Closing::Unclear);
        assert_eq!(at(-5e-4, 0.0), Closing::Unclear);
        assert_eq!(at(6e-4, 0.0), Closing::Open);
    }

    proptest! {
        #[test]
        fn a_tangent_arc_is_tangent_and_ends_at_its_end(angle in 0.0f64..360.0, x in -100.0f64..100.0, y in -100.0f64..100.0) {
            let from = Point2::new(3.0, -4.0);
            let t = super::super::Deg(angle).unit();
            let to = Point2::new(x, y);
            if let TangentArc::Arc { center, ccw } = tangent_arc(from, t, to, 1e-6, 1e-6) {
                let r = distance(from, center);
                prop_assert!((distance(to, center) - r).abs() <= 1e-9 * (1.0 + r));
                prop_assert!((tangent_at(from, center, ccw).unwrap() - t).norm() < 1e-9);
            }
        }

        #[test]
        fn a_centre_between_has_equal_distances(cx in -50.0f64..50.0, cy in -50.0f64..50.0, x in 1.0f64..9.0) {
            let (a, b) = (Point2::new(0.0, 0.0), Point2::new(x, 2.0));
            let c = centered_between(a, b, Point2::new(cx, cy));
            prop_assert!((distance(b, c) - distance(a, c)).abs() < 1e-9);
        }
    }
}
