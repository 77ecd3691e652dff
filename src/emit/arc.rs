//! Arcs on the printed numbers: the centre is chosen so that start and end, as printed, lie on one circle.

use core::f64::consts::TAU;

use crate::geo::{Point2, arc as geometry};

/// An arc in units of the last printed place.
#[derive(Debug, Clone, Copy)]
pub struct Request {
    /// Printed start and end.
    pub from: [i64; 2],
    pub to: [i64; 2],
    /// Units between two places of the centre.
    pub step: i64,
    /// Exact centre in units.
    pub center: Point2,
    /// Exact sweep in rad, counter-clockwise positive.
    pub sweep: f64,
    /// Exact radius in units.
    pub radius: f64,
    /// Largest difference of the radii at start and end, in units.
    pub tolerance: f64,
    /// How far the printed arc may leave the exact one, in units.
    pub most_off: f64,
    /// Smallest and largest radius that the target takes for an arc, in units.
    pub least_radius: f64,
    pub most_radius: f64,
    /// Shortest distance from start to end, in units, that is no full circle to the target.
    pub least_chord: f64,
}

/// How the arc can be printed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Printed {
    /// Offsets from the printed start to the centre, and whole turns including the last one.
    Arc { offset: [i64; 2], turns: u32 },
    /// Start and end print alike and the arc is short: nothing is left of it.
    Nothing,
    /// The target takes no such arc: print lines.
    Lines,
    /// The printed arc would miss its end, or leave the exact one, by so many units.
    Off(f64),
}

/// Fits the arc to the printed grid.
pub fn fit(request: &Request) -> Printed {
    let Request { from, to, sweep, .. } = *request;
    if from == to {
        if sweep.abs() < core::f64::consts::PI {
            return Printed::Nothing;
        }
        let offset = nearest(request);
        let turns = libm::round(sweep.abs() / TAU).max(1.0);
        if offset == [0, 0] || !takes_radius(offset, request) {
            return Printed::Lines;
        }
        let off = leaves(offset, request);
        return if off > request.most_off { Printed::Off(off) } else { Printed::Arc { offset, turns: turns as u32 } };
    }
    if length([to[0] - from[0], to[1] - from[1]]) < request.least_chord {
        return Printed::Lines;
    }
    let offset = match best_offset(request) {
        Ok(offset) if takes_radius(offset, request) => offset,
        Ok(_) => return Printed::Lines,
        Err(off) if off.is_finite() => return Printed::Off(off),
        Err(_) => return Printed::Lines,
    };
    let off = leaves(offset, request);
    if off > request.most_off {
        return Printed::Off(off);
    }
    // Rounding may carry the end over the start: the printed sweep plus whole turns is the sweep meant.
    let at = |p: [i64; 2]| Point2::new(p[0] as f64, p[1] as f64);
    let printed_center = at([from[0] + offset[0], from[1] + offset[1]]);
    let part = geometry::sweep(at(from), at(to), printed_center, sweep > 0.0).abs();
    let whole = libm::round((sweep.abs() - part) / TAU);
    if whole < 0.0 {
        return Printed::Lines;
    }
    Printed::Arc { offset, turns: whole as u32 + 1 }
}

/// Does the target take the printed radius?
fn takes_radius(offset: [i64; 2], request: &Request) -> bool {
    (request.least_radius..=request.most_radius).contains(&length(offset))
}

fn length(v: [i64; 2]) -> f64 {
    libm::hypot(v[0] as f64, v[1] as f64)
}

fn rounded(v: f64) -> i64 {
    libm::round(v) as i64
}

/// The offset to the place that lies nearest to the centre.
fn nearest(request: &Request) -> [i64; 2] {
    let Request { from, center, step, .. } = *request;
    let of = |center: f64, from: i64| match step {
        1 => rounded(center) - from,
        _ => step * rounded((center - from as f64) / step as f64),
    };
    [of(center.x, from[0]), of(center.y, from[1])]
}

/// How far the arc around the printed centre leaves the exact one between their ends, in units, or a bound of it that is
/// within what is allowed.
///
/// A place of the exact arc is `shift + radius·u` from the printed centre, which is longest and shortest where `u` points
/// along the shift. The ends themselves are off by their rounding, and by what their radii differ.
fn leaves(offset: [i64; 2], request: &Request) -> f64 {
    let Request { from, to, center, sweep, radius, .. } = *request;
    let at = |p: [i64; 2]| Point2::new(p[0] as f64, p[1] as f64);
    let printed = at([from[0] + offset[0], from[1] + offset[1]]);
    let shift = center - printed;
    let radii = [from, to].map(|end| (at(end) - printed).norm());
    let off = |distance: f64| (distance - radii[0]).abs().max((distance - radii[1]).abs());
    let bound = off(radius) + shift.norm();
    if bound <= request.most_off {
        return bound;
    }
    let start = at(from) - center;
    let first = libm::atan2(start.y, start.x);
    let mut most: f64 = 0.0;
    for (angle, distance) in [
        (libm::atan2(shift.y, shift.x), radius + shift.norm()),
        (libm::atan2(-shift.y, -shift.x), radius - shift.norm()),
    ] {
        let turned = ((angle - first) * sweep.signum()).rem_euclid(TAU);
        if turned <= sweep.abs() {
            most = most.max(off(distance));
        }
    }
    most
}

/// The rounded centre, or the neighbour on the grid that lies nearest to the exact one and fits; else what the radii of
/// the rounded one differ by.
fn best_offset(request: &Request) -> Result<[i64; 2], f64> {
    let Request { from, to, center, tolerance, step, .. } = *request;
    let naive = nearest(request);
    let off = mismatch(from, to, naive);
    if off <= tolerance {
        return Ok(naive);
    }
    let mut best: Option<(f64, [i64; 2])> = None;
    for dx in -1..=1 {
        for dy in -1..=1 {
            let offset = [naive[0] + step * dx, naive[1] + step * dy];
            if mismatch(from, to, offset) > tolerance {
                continue;
            }
            let off = Point2::new((from[0] + offset[0]) as f64, (from[1] + offset[1]) as f64) - center;
            let distance = off.norm_squared();
            if best.is_none_or(|(least, _)| distance < least) {
                best = Some((distance, offset));
            }
        }
    }
    best.map(|(_, offset)| offset).ok_or(off)
}

/// Difference of the distances of start and end from the centre; infinite where the centre is an end.
fn mismatch(from: [i64; 2], to: [i64; 2], offset: [i64; 2]) -> f64 {
    let second = [from[0] + offset[0] - to[0], from[1] + offset[1] - to[1]];
    if offset == [0, 0] || second == [0, 0] {
        return f64::INFINITY;
    }
    // Exact squares: (r1 - r2) = (r1² - r2²) / (r1 + r2) does not cancel.
    let square = |v: [i64; 2]| i128::from(v[0]) * i128::from(v[0]) + i128::from(v[1]) * i128::from(v[1]);
    let (a, b) = (square(offset), square(second));
    (a - b).unsigned_abs() as f64 / ((a as f64).sqrt() + (b as f64).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn request(r: f64, start: f64, sweep: f64, cx: f64, cy: f64) -> Request {
        let center = Point2::new(cx, cy);
        let point = |a: f64| [rounded(cx + r * libm::cos(a)), rounded(cy + r * libm::sin(a))];
        Request {
            step: 1,
            from: point(start),
            to: point(start + sweep),
            center,
            sweep,
            radius: r,
            tolerance: 1.5,
            most_off: 5.7,
            least_radius: 13.0,
            most_radius: f64::INFINITY,
            least_chord: 0.0,
        }
    }

    #[test]
    fn turns_are_counted_on_the_printed_numbers() {
        let full = request(10_000.0, 0.3, TAU, 5.0, 7.0);
        assert!(matches!(fit(&full), Printed::Arc { turns: 1, .. }));
        let three = request(10_000.0, 0.3, 2.25 * TAU, 5.0, 7.0);
        assert!(matches!(fit(&three), Printed::Arc { turns: 3, .. }));
        // Nearly two turns, ending one unit behind the start: printed as two turns, not three.
        let nearly = request(10_000.0, 0.3, 2.0 * TAU - 1e-4, 5.0, 7.0);
        assert!(matches!(fit(&nearly), Printed::Arc { turns: 2, .. }));
        let short = request(10_000.0, 0.3, 1e-9, 5.0, 7.0);
        assert_eq!(fit(&short), Printed::Nothing);
    }

    proptest! {
        #[test]
        fn printed_arcs_close_and_turn_as_far_as_meant(
            r in 30.0f64..1e6, start in 0.0f64..TAU, sweep in -20.0f64..20.0, cx in -1e6f64..1e6, cy in -1e6f64..1e6,
        ) {
            let wanted = request(r, start, sweep, cx, cy);
            match fit(&wanted) {
                Printed::Arc { offset, turns } => {
                    prop_assert!(wanted.from == wanted.to || mismatch(wanted.from, wanted.to, offset) <= 1.5);
                    let at = |p: [i64; 2]| Point2::new(p[0] as f64, p[1] as f64);
                    let center = at([wanted.from[0] + offset[0], wanted.from[1] + offset[1]]);
                    prop_assert!((center - wanted.center).amax() <= 1.5 + 1e-9);
                    let part = geometry::sweep(at(wanted.from), at(wanted.to), center, sweep > 0.0).abs();
                    let total = part + f64::from(turns - 1) * TAU;
                    prop_assert!((total - sweep.abs()).abs() < 4.0 / r, "{total} {sweep}");
                }
                Printed::Nothing => prop_assert!(sweep.abs() * r < 2.0),
                Printed::Lines | Printed::Off(_) => prop_assert!(r < 60.0 || sweep.abs() * r < 40.0, "r {r} sweep {sweep}"),
            }
        }
    }

    #[test]
    fn the_nearest_centre_on_the_grid_that_fits_is_taken() {
        let mut moved = [false; 2];
        let mut state = 14u64;
        let mut random = |below: f64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1u64 << 53) as f64 * below
        };
        for _ in 0..20_000 {
            let tight = request(20.0 + random(200.0), random(TAU), 0.3 + random(5.0), random(50.0), random(50.0));
            let tight = Request { tolerance: 0.4, ..tight };
            let naive = [rounded(tight.center.x) - tight.from[0], rounded(tight.center.y) - tight.from[1]];
            let off = |[x, y]: [i64; 2]| {
                let p = Point2::new((tight.from[0] + x) as f64, (tight.from[1] + y) as f64);
                (p - tight.center).norm_squared()
            };
            let near = (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| [naive[0] + dx, naive[1] + dy]));
            let fitting = near.filter(|offset| mismatch(tight.from, tight.to, *offset) <= tight.tolerance);
            let least = fitting.map(off).min_by(f64::total_cmp);
            let found = best_offset(&tight).ok();
            if mismatch(tight.from, tight.to, naive) <= tight.tolerance {
                assert_eq!(found, Some(naive));
            } else {
                assert_eq!(found.map(off), least, "{tight:?}");
                if let Some(offset) = found {
                    moved = [moved[0] || offset[0] != naive[0], moved[1] || offset[1] != naive[1]];
                }
            }
        }
        assert_eq!(moved, [true; 2]);
    }

    #[test]
    fn a_chord_of_the_least_length_is_an_arc_and_a_shorter_one_is_not() {
        // A half circle of radius 50 units.
        let half = request(50.0, 0.0, TAU / 2.0, 0.0, 0.0);
        assert!(matches!(fit(&Request { least_chord: 100.0, ..half }), Printed::Arc { turns: 1, .. }));
        assert_eq!(fit(&Request { least_chord: 100.5, ..half }), Printed::Lines);
    }
}
