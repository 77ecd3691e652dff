use super::*;
use crate::geo::{Plane, cross, distance};
use crate::ir::cycle::milling::{Division, Feeds, Heights, Mill};

fn pocket(half: [f64; 2], corner: f64) -> Pocket {
    let feed = Feed::PerMinute(100.0);
    let heights = Heights {
        retract: 50.0,
        reference: 0.0,
        clearance: 2.0,
        depth: -10.0,
        step: 5.0,
        division: Division::Even,
        allowance: 0.0,
    };
    Pocket {
        mill: Mill { plane: Plane::Xy, heights, radius: 5.0, feeds: Feeds { plane: feed, depth: feed } },
        shape: Shape::Rectangle { half, corner },
        places: vec![Place::HERE],
        counter_clockwise: true,
        allowance: 0.0,
        width: 4.0,
        insertion: Insertion::Vertical,
        strategy: Strategy::Levels,
        rough: true,
        finish: None,
        cleared: None,
        transfer: None,
        between: LevelChange::Straight,
        home: None,
    }
}

/// What a closed path encloses, counter-clockwise positive, and its length. Each element begins where the one before ends.
fn enclosed(elements: &[Element]) -> (f64, f64) {
    let mut at = elements.last().expect("a path").to();
    let (mut area, mut length) = (0.0, 0.0);
    for element in elements {
        assert!(distance(at, element.from()) < 1e-9, "{at} {element:?}");
        at = element.to();
        length += element.length();
        area += match *element {
            Element::Line { from, to } => cross(from.coords, to.coords) / 2.0,
            Element::Arc { from, to, center, sweep } => {
                assert!((distance(from, center) - distance(to, center)).abs() < 1e-9, "{element:?}");
                (cross(center.coords, to - from) + distance(from, center) * distance(from, center) * sweep) / 2.0
            }
        };
    }
    (area, length)
}

#[test]
fn rings_of_a_rectangle_are_round_where_its_corners_are() {
    // 60 x 40 with corners of 8, a cutter of 5: the centre reaches 50 x 30 with corners of 3. Four rings, 3.75 apart.
    for (half, standing) in [([30.0, 20.0], false), ([20.0, 30.0], true)] {
        let area = Area::new(&pocket(half, 8.0), 5.0);
        assert_eq!(area.rings.len(), 4);
        for (ring, k) in area.rings.iter().rev().zip(0..) {
            let (x, y) = (25.0 - f64::from(k) * 3.75, 15.0 - f64::from(k) * 3.75);
            let corner = if k == 0 { 3.0 } else { 0.0 };
            assert_eq!(ring.half, if standing { [y, x] } else { [x, y] });
            let arcs = ring.elements.iter().filter(|element| matches!(element, Element::Arc { .. })).count();
            assert_eq!(arcs, if k == 0 { 4 } else { 0 }, "ring {k}");
            let (found, length) = enclosed(&ring.elements);
            let pi = core::f64::consts::PI;
            assert!((found - (4.0 * x * y - (4.0 - pi) * corner * corner)).abs() < 1e-9, "ring {k}: {found}");
            assert!((length - (4.0 * (x + y) - (8.0 - 2.0 * pi) * corner)).abs() < 1e-9, "ring {k}: {length}");
        }
    }
}

#[test]
fn the_other_sense_is_the_same_path_back() {
    let there = Area::new(&pocket([30.0, 20.0], 8.0), 5.0);
    let back = Area::new(&Pocket { counter_clockwise: false, ..pocket([30.0, 20.0], 8.0) }, 5.0);
    for (a, b) in there.rings.iter().zip(&back.rings) {
        let ((area, length), (other, way)) = (enclosed(&a.elements), enclosed(&b.elements));
        assert!((area + other).abs() < 1e-9 && (length - way).abs() < 1e-9);
        assert_eq!(a.start(), b.start());
    }
}
