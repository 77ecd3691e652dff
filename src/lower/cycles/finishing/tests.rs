use super::*;
use crate::geo::{clearance, turned};
use crate::ir::cycle::Cycle;
use crate::ir::cycle::recess::tests::lines;
use crate::ir::cycle::roughing::Nose;
use crate::ir::cycle::turning::Towards;
use crate::lower::cycles::simulate::check_lowering_with;
use crate::lower::cycles::track::{Move, Path, Stroke};
use proptest::prelude::*;

fn shaft() -> Finishing {
    Finishing {
        contour: lines(&[(0.0, 0.0), (0.0, 30.0), (-20.0, 30.0), (-30.0, 40.0), (-30.0, 60.0)]),
        around: Vec::new(),
        around_left: false,
        into: Towards::MinusX,
        left: false,
        nose: Nose::default(),
        oversize: 0.0,
        shift: Vec2::zeros(),
        away: Vec2::new(1.0, 1.0),
        clearance: 1.0,
        blank: None,
        feed: Feed::PerRevolution(0.2),
        descending: Descending::Cut { feed: Feed::PerRevolution(0.1) },
        arcs: ArcFeed::Same,
        end: FinishingEnd::Lift,
    }
}

fn strokes(finishing: &Finishing, from: Point2) -> Result<Vec<Move>, Fault> {
    let mut list = Vec::new();
    expand(finishing, from, &mut |stroke| {
        if let Stroke::Move(mv) = stroke {
            list.push(mv);
        }
    })?;
    Ok(list)
}

/// Z and X as a diameter of the ends, rounded.
fn ends(list: &[Move]) -> Vec<(f64, f64)> {
    let round = |v: f64| (v * 1e4).round() / 1e4 + 0.0;
    list.iter().map(|mv| (round(mv.to.x), round(2.0 * mv.to.y))).collect()
}

#[test]
fn a_point_follows_the_contour() {
    let found = strokes(&shaft(), Point2::new(2.0, 35.0)).unwrap();
    let expected = [(1.0, 2.0), (0.0, 0.0), (0.0, 30.0), (-20.0, 30.0), (-30.0, 40.0), (-30.0, 60.0), (-29.0, 62.0)];
    assert_eq!(ends(&found), expected);
    assert_eq!(found[0].path, Path::Rapid);
}

#[test]
fn the_nose_is_compensated() {
    // Nose 0.8. The edge of the face is rounded by it; before the cone of 26.565 degrees its centre stops at
    // 0.8·tan(13.283°) = 0.1889 from the corner; at the shoulder it stands 0.8 in front.
    let nose = Nose { radius: 0.8, tip: Vec2::new(-1.0, -1.0) };
    let found = strokes(&Finishing { nose, ..shaft() }, Point2::new(2.0, 35.0)).unwrap();
    let expected = [
        (1.0, 0.4),
        (0.0, -1.6),
        (0.0, 28.4),
        (-0.8, 30.0),
        (-20.6111, 30.0),
        (-30.0, 39.3889),
        (-30.0, 58.4),
        (-29.0, 60.4),
    ];
    assert_eq!(ends(&found), expected);
    assert!(matches!(found[3].path, Path::Arc { ccw: true, .. }));
}

#[test]
fn descending_parts_have_their_feed_or_are_left_out() {
    let groove = lines(&[(0.0, 40.0), (-10.0, 40.0), (-12.0, 36.0), (-20.0, 36.0), (-22.0, 40.0), (-30.0, 40.0)]);
    let cut = Finishing { contour: groove, ..shaft() };
    let from = Point2::new(2.0, 25.0);
    let found = strokes(&cut, from).unwrap();
    let slow = |mv: &&Move| matches!(mv.path, Path::Line { feed } if feed.value() == 0.1);
    assert_eq!(found.iter().filter(slow).map(|mv| mv.to).collect::<Vec<_>>(), [Point2::new(-12.0, 18.0)]);
    let level = strokes(&Finishing { descending: Descending::Left, ..cut }, from).unwrap();
    assert!(level.iter().all(|mv| mv.to.y >= 20.0), "{level:?}");
}

#[test]
fn ways_that_touch_the_contour_are_refused() {
    let code = |finishing: &Finishing, from| strokes(finishing, from).unwrap_err().code().id;
    // Inside of the part.
    assert_eq!(code(&shaft(), Point2::new(-10.0, 5.0)), "G3048");
    let through = FinishingEnd::Point { to: Point2::new(2.0, 5.0), way: Way::XThenZ };
    assert_eq!(code(&Finishing { end: through, ..shaft() }, Point2::new(2.0, 35.0)), "G3048");
    let narrow = Finishing {
        contour: lines(&[(0.0, 40.0), (0.0, 36.0), (-1.0, 36.0), (-1.0, 40.0)]),
        nose: Nose { radius: 0.8, tip: Vec2::new(-1.0, -1.0) },
        ..shaft()
    };
    assert_eq!(code(&narrow, Point2::new(2.0, 35.0)), "G3049");
}

#[test]
fn the_rest_of_the_contour_is_in_the_way() {
    // A face between two steps, cut outwards: below its start lies the smaller step.
    let whole = lines(&[(0.0, 0.0), (0.0, 20.0), (-5.0, 20.0), (-5.0, 50.0)]);
    let face = Finishing { contour: lines(&[(-5.0, 20.0), (-5.0, 50.0)]), away: Vec2::new(1.0, -1.0), ..shaft() };
    let from = Point2::new(3.0, 30.0);
    assert_eq!(ends(&strokes(&face, from).unwrap())[0], (-4.0, 18.0));
    let aware = Finishing { around: whole, ..face };
    assert_eq!(ends(&strokes(&aware, from).unwrap())[0], (-4.0, 22.0));
}

/// Points along a move.
fn along(from: Point2, mv: &Move) -> Vec<Point2> {
    let parts = 40;
    (0..=parts)
        .map(|i| {
            let t = f64::from(i) / f64::from(parts);
            match mv.path {
                Path::Arc { center, ccw, .. } => {
                    center + turned(from - center, crate::geo::arc::sweep(from, mv.to, center, ccw) * t)
                }
                _ => from + (mv.to - from) * t,
            }
        })
        .collect()
}

proptest! {
    /// Rising and falling contours of lines: the nose never cuts into them, rapids keep clear, and every element is
    /// reached up to the fillets that the nose leaves in inner corners.
    #[test]
    fn random_contours(
        steps in prop::collection::vec((0.5f64..8.0, -4.0f64..6.0), 1..8),
        radius in prop_oneof![Just(0.0), 0.1f64..1.2],
        oversize in prop_oneof![Just(0.0), 0.0f64..0.6],
    ) {
        let mut at = (0.0, 60.0);
        let mut points = vec![at];
        for (z, x) in steps {
            at = (at.0 - z, (at.1 + x).max(10.0));
            points.push(at);
        }
        let contour = lines(&points);
        let nose = Nose { radius, tip: Vec2::new(-1.0, -1.0) };
        let finishing = Finishing { contour: contour.clone(), nose, oversize, ..shaft() };
        let from = Point2::new(5.0, 60.0);
        let Ok(list) = strokes(&finishing, from) else { return Ok(()) };
        let mut at = from;
        let mut reached = vec![f64::INFINITY; contour.len()];
        // How much room the nose has about a place of its point.
        let clear = |p: Point2| {
            let off = contour.iter().map(|element| clearance::point_to(p - nose.tip * radius, element));
            off.fold(f64::INFINITY, f64::min) - radius - oversize
        };
        for mv in &list {
            // A narrow place at an end of a rapid leaves less of the clearance.
            let free = clear(at).min(clear(mv.to)).min(0.5);
            prop_assert!(mv.path != Path::Rapid || free > 0.1, "{at:?} {mv:?} {free}");
            for p in along(at, mv) {
                let center = p - nose.tip * radius;
                for (element, least) in contour.iter().zip(&mut reached) {
                    let off = clearance::point_to(center, element);
                    prop_assert!(off > radius + oversize - 2e-3, "{center:?} {element:?} {off}");
                    if mv.path == Path::Rapid {
                        prop_assert!(off > radius + oversize + free - 2e-3, "{center:?} {element:?} {off}");
                    }
                    *least = least.min(off);
                }
            }
            at = mv.to;
        }
        for least in reached {
            prop_assert!(least < radius + oversize + 0.5, "{least}");
        }
        check_lowering_with(&Cycle::Finishing(finishing), from, core::f64::consts::PI)?;
    }
}
