//! Areas inside closed chains of lines and arcs.

use core::f64::consts::{PI, TAU};

use super::{Element, Point2, cross, crossing, direction, distance, turned};

/// Chains nearer than this touch, mm.
pub const NEAR: f64 = 0.003;

/// How two chains lie to each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Relation {
    Apart,
    /// They cross or touch.
    Crossing,
    FirstInside,
    SecondInside,
}

/// Twice the area that a closed chain goes around, above 0 counter-clockwise.
pub fn twice_signed(chain: &[Element]) -> f64 {
    let of = |element: &Element| {
        let (a, b) = (element.from(), element.to());
        let segment = match *element {
            Element::Line { .. } => 0.0,
            Element::Arc { center, sweep, from, .. } => {
                let radius = distance(from, center);
                radius * radius * (sweep - libm::sin(sweep))
            }
        };
        a.x * b.y - a.y * b.x + segment
    };
    chain.iter().map(of).sum()
}

/// Does a closed chain turn to the left?
pub fn is_counter_clockwise(chain: &[Element]) -> bool {
    twice_signed(chain) > 0.0
}

/// The chain the other way round.
pub fn reversed(chain: &[Element]) -> Vec<Element> {
    chain.iter().rev().map(Element::reversed).collect()
}

/// Does a closed chain go around `p`, a point beside it?
pub fn surrounds(chain: &[Element], p: Point2) -> bool {
    chain.iter().map(|element| angle_of(element, p)).sum::<f64>().abs() > PI
}

/// The angle over which a point on its way along the element is seen from `p`.
fn angle_of(element: &Element, p: Point2) -> f64 {
    let chord = |a: Point2, b: Point2| {
        let (a, b) = (a - p, b - p);
        libm::atan2(cross(a, b), a.dot(&b))
    };
    match *element {
        Element::Line { from, to } => chord(from, to),
        Element::Arc { from, to, center, sweep } => {
            // In parts of less than half a turn, whose chords leave `p` on one side.
            const PARTS: u32 = 3;
            let radius = distance(from, center);
            let at = |i: u32| match i {
                0 => from,
                PARTS => to,
                _ => center + turned(from - center, sweep * f64::from(i) / f64::from(PARTS)),
            };
            let between = |a: Point2, b: Point2| {
                let outside = cross(b - a, p - a) * sweep < 0.0;
                let cut_off = outside && distance(p, center) < radius;
                chord(a, b) + if cut_off { TAU.copysign(sweep) } else { 0.0 }
            };
            (0..PARTS).map(|i| between(at(i), at(i + 1))).sum()
        }
    }
}

/// Does the point lie on the chain, or next to it?
pub fn passes(chain: &[Element], p: Point2) -> bool {
    chain.iter().any(|element| {
        let off = match *element {
            Element::Line { from, to } => direction(to - from, 0.0).map_or(0.0, |unit| cross(unit, p - from)),
            Element::Arc { from, center, .. } => distance(p, center) - distance(from, center),
        };
        let way = element.way_to(p);
        off.abs() <= NEAR && way > -NEAR && way < element.length() + NEAR
    })
}

/// Have two chains a point in common?
pub fn meet(a: &[Element], b: &[Element]) -> bool {
    a.iter().any(|a| b.iter().any(|b| crossing::meet(a, b, &[])))
}

/// How two closed chains lie to each other.
pub fn relation(a: &[Element], b: &[Element]) -> Relation {
    let holds = |chain: &[Element], other: &[Element]| other.first().is_some_and(|e| surrounds(chain, e.from()));
    if meet(a, b) {
        Relation::Crossing
    } else if holds(b, a) {
        Relation::FirstInside
    } else if holds(a, b) {
        Relation::SecondInside
    } else {
        Relation::Apart
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    pub fn polygon(points: &[(f64, f64)]) -> Vec<Element> {
        let at = |i: usize| Point2::new(points[i % points.len()].0, points[i % points.len()].1);
        (0..points.len()).map(|i| Element::Line { from: at(i), to: at(i + 1) }).collect()
    }

    pub fn circle(x: f64, y: f64, radius: f64, sweep: f64) -> Vec<Element> {
        let at = Point2::new(x + radius, y);
        vec![Element::Arc { from: at, to: at, center: Point2::new(x, y), sweep: TAU * sweep }]
    }

    #[test]
    fn areas_have_a_size_and_a_sense() {
        let square = polygon(&[(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]);
        assert_eq!(twice_signed(&square), 32.0);
        assert_eq!(twice_signed(&reversed(&square)), -32.0);
        assert!((twice_signed(&circle(3.0, 2.0, 5.0, 1.0)) - 50.0 * PI).abs() < 1e-12);
        assert!(!is_counter_clockwise(&circle(3.0, 2.0, 5.0, -1.0)));
    }

    #[test]
    fn a_point_lies_inside_or_outside() {
        for sense in [1.0, -1.0] {
            let round = circle(0.0, 0.0, 5.0, sense);
            for at in 0..48 {
                let out = turned(super::super::Vec2::new(1.0, 0.0), 0.1309 * f64::from(at));
                assert!(surrounds(&round, Point2::origin() + out * 4.999), "{at}");
                assert!(!surrounds(&round, Point2::origin() + out * 5.001), "{at}");
            }
        }
        // A half moon: its hollow is outside.
        let moon = vec![
            Element::Arc {
                from: Point2::new(0.0, -5.0),
                to: Point2::new(0.0, 5.0),
                center: Point2::origin(),
                sweep: PI,
            },
            Element::Arc {
                from: Point2::new(0.0, 5.0),
                to: Point2::new(0.0, -5.0),
                center: Point2::new(-3.75, 0.0),
                sweep: -2.0 * libm::atan2(5.0, 3.75),
            },
        ];
        assert!(surrounds(&moon, Point2::new(3.0, 0.0)));
        assert!(!surrounds(&moon, Point2::new(1.0, 0.0)));
        assert!(!surrounds(&moon, Point2::new(6.0, 0.0)));
    }

    #[test]
    fn chains_lie_apart_in_each_other_or_cross() {
        let square = polygon(&[(0.0, 0.0), (9.0, 0.0), (9.0, 9.0), (0.0, 9.0)]);
        let to = |other: &[Element]| relation(&square, other);
        assert_eq!(to(&circle(4.0, 4.0, 2.0, 1.0)), Relation::SecondInside);
        assert_eq!(to(&circle(4.0, 4.0, 20.0, -1.0)), Relation::FirstInside);
        assert_eq!(to(&circle(9.0, 4.0, 2.0, 1.0)), Relation::Crossing);
        assert_eq!(to(&circle(7.0, 4.0, 2.0, 1.0)), Relation::Crossing);
        assert_eq!(to(&circle(30.0, 4.0, 2.0, 1.0)), Relation::Apart);
    }

    #[test]
    fn a_point_between_an_arc_and_its_chord_lies_on_the_side_of_the_arc() {
        // A square of 10 with a hollow or a bulge of radius 5 in its right side; the arc reaches x = 5 or 15.
        let (low, high, center) = (Point2::new(10.0, 0.0), Point2::new(10.0, 10.0), Point2::new(10.0, 5.0));
        let around = polygon(&[(10.0, 10.0), (0.0, 10.0), (0.0, 0.0), (10.0, 0.0)]);
        let with = |sweep: f64| {
            let mut chain = around[..3].to_vec();
            chain.push(Element::Arc { from: low, to: high, center, sweep });
            chain
        };
        for (chain, sense) in [(with(-PI), -1.0), (with(PI), 1.0)] {
            // A third of the half circle has its chord at 4.33 from the centre.
            for angle in [90.0, 110.0, 60.0, 150.0, 25.0] {
                let out = turned(super::super::Vec2::new(0.0, -1.0), sense * f64::to_radians(angle));
                let (inner, outer) = (center + out * 4.9, center + out * 5.1);
                assert_eq!(surrounds(&chain, inner), sense > 0.0, "{angle} {sense}");
                assert_eq!(surrounds(&chain, outer), sense < 0.0, "{angle} {sense}");
                let back = reversed(&chain);
                assert_eq!(surrounds(&back, inner), sense > 0.0, "{angle} {sense}");
                assert_eq!(surrounds(&back, outer), sense < 0.0, "{angle} {sense}");
            }
        }
    }
}
