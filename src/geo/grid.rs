//! Coordinates on a grid, so that what was computed in two ways is one number.
//!
//! A contour whose coordinates come from formulas differs from the same contour in literals by the last bits of its numbers, at most
//! some 1e-12 mm on a machine's travel. Behind the grid both are the same bits, and so is everything that is made of them. A coordinate
//! moves by less than 1e-8 mm: a ten-thousandth of the last place that is printed, and below what rings and crossings allow for.

use core::f64::consts::TAU;

use super::{Element, Point2, arc};

/// Lines of the grid on a millimetre.
const LINES: f64 = 1e8;
/// Where a step ends: not halfway, where short decimals and fractions of two lie.
const STEP_ENDS: f64 = 0.43;

/// The value on the grid; the same with the other sign.
pub fn on_grid(value: f64) -> f64 {
    let scaled = value.abs() * LINES;
    // From 2^53 lines on, 90 km, the grid is finer than the numbers, and what is no number stays none.
    if scaled < 9e15 { (libm::floor(scaled + 1.0 - STEP_ENDS) / LINES).copysign(value) + 0.0 } else { value }
}

pub fn point(p: Point2) -> Point2 {
    Point2::new(on_grid(p.x), on_grid(p.y))
}

/// An element whose points lie on the grid.
pub fn element(element: &Element) -> Element {
    match *element {
        Element::Line { from, to } => Element::Line { from: point(from), to: point(to) },
        Element::Arc { from, to, center, sweep } => {
            let (from, to, center) = (point(from), point(to), point(center));
            Element::Arc { from, to, center, sweep: swept(from, to, center, sweep) }
        }
    }
}

/// The sweep that was nearly `before`, from the points alone.
fn swept(from: Point2, to: Point2, center: Point2, before: f64) -> f64 {
    let whole = TAU * libm::round(before / TAU);
    if from == to {
        return whole;
    }
    let once = arc::sweep(from, to, center, before > 0.0);
    // Next to a full turn, or to none, it may be the other one.
    once + TAU * libm::round((before - once) / TAU).clamp(-1e6, 1e6)
}

/// Closed elements, each from where the one before ends.
pub fn chain(elements: &[Element]) -> Vec<Element> {
    elements.iter().map(self::element).collect()
}

/// Coordinates to compare by, where those that differ by less than a micrometre's hundredth are the same.
pub fn key(p: Point2) -> (f64, f64) {
    let rough = |v: f64| libm::floor(v * 1e5 + 1.0 - STEP_ENDS) + 0.0;
    (rough(p.x), rough(p.y))
}

/// By the first coordinate, then by the second.
pub fn before(p: Point2, q: Point2) -> core::cmp::Ordering {
    let (a, b) = (key(p), key(q));
    a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::PI;

    #[test]
    fn what_formulas_add_is_lost() {
        for value in [21.88, -21.88, 0.0, 1e-3, 99_999.999, 12.345_678_5, 1.0 / 256.0, 25.4 / 1024.0] {
            for by in [1e-15, -1e-15, 4e-14, -4e-14] {
                let noisy = value + by * f64::max(1.0, f64::abs(value));
                assert_eq!(on_grid(noisy).to_bits(), on_grid(value).to_bits(), "{value} {by}");
            }
            assert!((on_grid(value) - value).abs() < 1e-8, "{value}");
            assert_eq!(on_grid(-value), -on_grid(value));
        }
        assert_eq!(on_grid(21.88 * 3.0 - 2.0 * 21.88).to_bits(), 21.88f64.to_bits());
        assert_eq!(on_grid(f64::INFINITY), f64::INFINITY);
        assert!(on_grid(f64::NAN).is_nan());
    }

    #[test]
    fn arcs_keep_their_turns() {
        let at = Point2::new(5.0, 0.0);
        let near = Point2::new(5.0, 1e-10);
        for (from, to, sweep, wanted) in [
            (at, at, TAU, TAU),
            (at, at, -TAU, -TAU),
            (at, near, TAU, TAU),
            (at, near, 1e-11, 0.0),
            (at, Point2::new(-5.0, 0.0), PI + 1e-12, PI),
            (at, Point2::new(-5.0, 0.0), -PI, -PI),
        ] {
            let made = element(&Element::Arc { from, to, center: Point2::origin(), sweep });
            assert!(matches!(made, Element::Arc { sweep, .. } if (sweep - wanted).abs() < 1e-8), "{made:?}");
        }
    }
}
