//! Boxes about elements: what does not meet them needs no closer look.

use crate::geo::{Element, Vec2, distance};

/// A box about an element.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bounds {
    least: Vec2,
    most: Vec2,
}

impl Bounds {
    pub(super) fn of(element: &Element) -> Bounds {
        let (from, to) = (element.from().coords, element.to().coords);
        let (mut least, mut most) = (from.inf(&to), from.sup(&to));
        if let Element::Arc { center, sweep, .. } = *element {
            let radius = distance(element.from(), center);
            // A flat arc bulges little beyond its ends.
            let bulge = if sweep.abs() < 1.5 { radius * sweep * sweep / 8.0 } else { 2.0 * radius };
            least.add_scalar_mut(-bulge);
            most.add_scalar_mut(bulge);
        }
        Bounds { least, most }
    }

    #[inline]
    pub(super) fn is_far(&self, other: &Bounds, r: f64) -> bool {
        self.least.x > other.most.x + r
            || other.least.x > self.most.x + r
            || self.least.y > other.most.y + r
            || other.least.y > self.most.y + r
    }
}

/// What was looked at has its boxes.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Seen {
    pub(super) way: Option<Bounds>,
    pub(super) contour: Option<Bounds>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_box_holds_all_of_its_arc() {
        use crate::geo::{Point2, turned};
        let center = Point2::new(7.0, -3.0);
        for radius in [0.5, 10.0, 80.0] {
            for start in 0..12 {
                for sweep in [0.3, 1.4, 1.6, 3.0, 6.2, core::f64::consts::TAU] {
                    let on = |angle: f64| center + turned(Vec2::new(radius, 0.0), 0.5 * f64::from(start) + angle);
                    let bounds = Bounds::of(&Element::Arc { from: on(0.0), to: on(sweep), center, sweep });
                    for part in 0..=20 {
                        let p = on(sweep * f64::from(part) / 20.0).coords;
                        let holds = (0..2).all(|i| p[i] > bounds.least[i] - 1e-9 && p[i] < bounds.most[i] + 1e-9);
                        assert!(holds, "radius {radius}, {sweep} from {start}, part {part}");
                    }
                }
            }
        }
    }
}
