//! A wall as a round tool nose sees it: the outline of a falling chain of lines and arcs, by height.
//!
//! The chain runs towards +x and never rises; the material lies on its left and below. For every height of
//! the nose's lowest point there is one place where the nose touches.
//!
//! ```text
//!   material │
//!            ╰─╮   ◯ nose
//!   ═══════════╰───────────
//! ```

use super::profile::{Grown, LEVEL, Leg, Profile, backwards, mirrored};
use super::{Element, Point2, Vec2, distance};

/// An element may rise or lean over by this, mm: what arithmetic loses.
const SAME_HEIGHT: f64 = 1e-7;

/// Height of the wall above its chain, mm above everything.
const HIGH: f64 = 1e5;

/// A nose that touches an upright wall is beside it, mm.
const BESIDE: f64 = 1e-9;

/// A wall as a nose of some radius sees it.
#[derive(Debug, Clone, PartialEq)]
pub struct NoseProfile {
    /// In a mirror, so that it rises towards +x.
    outline: Profile,
}

/// Why a chain is no wall.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NoProfile {
    /// An element rises, or leans over.
    Rises,
    /// An element does not start where the one before ends.
    Gap,
    Empty,
}

impl NoseProfile {
    /// The wall of `chain` for a nose of `radius`. Above its start the wall goes straight up, below
    /// its end straight down.
    ///
    /// # Errors
    /// See [`NoProfile`]. Arcs must not run through a quadrant point; see [`quarters`](super::element::quarters).
    pub fn new(chain: &[Element], radius: f64) -> Result<NoseProfile, NoProfile> {
        let start = chain.first().ok_or(NoProfile::Empty)?.from();
        let mut at = start;
        for element in chain {
            if distance(at, element.from()) > super::SAME_POINT {
                return Err(NoProfile::Gap);
            }
            if !falls(element) {
                return Err(NoProfile::Rises);
            }
            at = element.to();
        }
        let top = start + Vec2::new(0.0, HIGH);
        let mut whole = Vec::with_capacity(chain.len() + 2);
        whole.push(Element::Line { from: top - Vec2::new(HIGH, 0.0), to: top });
        whole.push(Element::Line { from: top, to: start });
        whole.extend_from_slice(chain);
        let outline = Profile::new(&whole, Grown { along: 0.0, up: -radius, disc: radius });
        Ok(NoseProfile { outline: outline.mirrored() })
    }

    /// Least x of the nose centre when its lowest point is at height `y`.
    pub fn touch(&self, y: f64) -> f64 {
        self.outline.first_above(y, f64::NEG_INFINITY).map_or(f64::NEG_INFINITY, |x| -x)
    }

    /// Least height of the nose with its centre at `x`; below everything beyond the foot of the wall.
    pub fn height(&self, x: f64) -> f64 {
        self.outline.height(-x - BESIDE)
    }

    /// The way down from height `top` to `bottom`: where it starts, and its legs. x is the nose centre, y its
    /// lowest point.
    pub fn way(&self, top: f64, bottom: f64) -> (Point2, Vec<Leg>) {
        let foot = Point2::new(-self.touch(bottom), bottom);
        let start = Point2::new(self.touch(top), top);
        let mut up = self.outline.climb(foot, top);
        let at = up.last().map_or(foot, Leg::to);
        if -start.x - at.x > LEVEL {
            // A level piece of the chain, on which the nose rides.
            up.push(Leg::Line { to: Point2::new(-start.x, top) });
        }
        let start = up.last().map_or(start, |leg| Point2::new(-leg.to().x, top));
        (start, mirrored(&backwards(foot, &up)))
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
        let wall = NoseProfile::new(&[line((0.0, 0.0), (0.0, -5.0))], 0.2).unwrap();
        let (start, legs) = wall.way(1.0, -5.0);
        assert!(near(start, (0.2, 1.0)));
        assert!(matches!(legs[..], [Leg::Line { to }] if near(to, (0.2, -5.0))), "{legs:?}");
    }

    #[test]
    fn a_sharp_edge_is_rolled_over() {
        // Rim, edge, vertical wall.
        let wall = NoseProfile::new(&[line((-3.0, 0.0), (0.0, 0.0)), line((0.0, 0.0), (0.0, -5.0))], 0.5).unwrap();
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
        let wall =
            NoseProfile::new(&[bulge, Element::Line { from: bulge.to(), to: foot }], 0.9168178244483085).unwrap();
        let (_, legs) = wall.way(53.1, 50.0);
        let arcs: Vec<&Leg> = legs.iter().filter(|leg| matches!(leg, Leg::Arc { .. })).collect();
        let end = (foot.x + 0.9168178244483085, 52.0 - 0.9168178244483085);
        assert!(
            matches!(arcs[..], [Leg::Arc { to, .. }] if (*to - Point2::new(end.0, end.1)).norm() < 1e-6),
            "{legs:?}"
        );
    }

    #[test]
    fn a_short_arc_becomes_lines_that_do_not_gouge() {
        // A quarter of 5e-4 mm about the edge: its chord would come nearer than the nose is round.
        let (r, edge) = (5e-4, Point2::new(0.0, 0.0));
        let wall = NoseProfile::new(&[line((-3.0, 0.0), (0.0, 0.0)), line((0.0, 0.0), (0.0, -5.0))], r).unwrap();
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
        let wall = NoseProfile::new(&[line((0.0, 0.0), (0.0, -4.7)), foot], 0.5).unwrap();
        assert!((wall.touch(-5.0) - 0.5).abs() < 1e-12);
        let large = NoseProfile::new(&[line((0.0, 0.0), (0.0, -4.7)), foot], 0.1).unwrap();
        // The nose of 0.1 follows: at the floor its centre is below the centre of the hollow.
        assert!((large.touch(-5.0) - 0.3).abs() < 1e-12);
    }

    #[test]
    fn a_slope_offsets_by_its_normal() {
        let wall = NoseProfile::new(&[line((0.0, 0.0), (5.0, -5.0))], 1.0).unwrap();
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
            let wall = NoseProfile::new(&[slope, arc], nose).unwrap();
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
        assert_eq!(NoseProfile::new(&[line((0.0, 0.0), (1.0, 1.0))], 0.1), Err(NoProfile::Rises));
        assert_eq!(NoseProfile::new(&[line((0.0, 0.0), (-1.0, -1.0))], 0.1), Err(NoProfile::Rises));
        assert_eq!(NoseProfile::new(&[], 0.1), Err(NoProfile::Empty));
        let gap = [line((0.0, 0.0), (1.0, -1.0)), line((2.0, -1.0), (3.0, -2.0))];
        assert_eq!(NoseProfile::new(&gap, 0.1), Err(NoProfile::Gap));
    }
}
