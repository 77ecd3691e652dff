use super::*;

fn lines(points: &[(f64, f64)]) -> Vec<Element> {
    let p = |p: (f64, f64)| Point2::new(p.0, p.1);
    points.windows(2).map(|pair| Element::Line { from: p(pair[0]), to: p(pair[1]) }).collect()
}

fn ends(legs: &[Leg]) -> Vec<(f64, f64)> {
    let round = |v: f64| (v * 1e6).round() / 1e6 + 0.0;
    legs.iter().map(|leg| (round(leg.to().x), round(leg.to().y))).collect()
}

/// A step up and a groove behind it.
const STEPS: [(f64, f64); 6] = [(0.0, 0.0), (5.0, 0.0), (5.0, 3.0), (9.0, 3.0), (11.0, 1.0), (15.0, 1.0)];

#[test]
fn heights_and_places_of_a_bare_chain() {
    let outline = Profile::new(&lines(&STEPS), Grown::default());
    assert_eq!((outline.height(2.0), outline.height(5.0), outline.height(10.0)), (0.0, 3.0, 2.0));
    assert_eq!((outline.first_above(0.0, 0.0), outline.first_above(2.0, 0.0)), (Some(5.0), Some(5.0)));
    assert_eq!((outline.first_above(3.0, 0.0), outline.highest(9.5, 20.0)), (None, 2.5));
    assert_eq!(outline.lowest(8.0, 15.0), Some(Point2::new(11.0, 1.0)));
}

#[test]
fn a_disc_rolls_over_corners_and_does_not_reach_inner_ones() {
    let grown = Grown { along: 0.0, up: -1.0, disc: 1.0 };
    let outline = Profile::new(&lines(&STEPS), grown);
    // Its centre stops in front of the wall, where its lowest point is on the floor.
    assert_eq!(outline.first_above(0.0, 0.0), Some(4.0));
    let way = outline.climb(Point2::new(4.0, 0.0), 3.0);
    assert_eq!(ends(&way), [(4.0, 2.0), (5.0, 3.0)]);
    assert!(matches!(way[1], Leg::Arc { ccw: false, .. }), "{way:?}");
}

#[test]
fn allowances_move_walls_of_both_sides() {
    let outline = Profile::new(&lines(&STEPS), Grown { along: 0.5, up: 0.25, disc: 0.0 });
    assert_eq!((outline.first_above(0.25, 0.0), outline.height(7.0)), (Some(4.5), 3.25));
    // The falling side stands half a millimetre farther.
    assert!((outline.height(10.5) - 2.25).abs() < 1e-12);
}

#[test]
fn what_falls_is_bridged_or_a_dip() {
    let points = [&STEPS[..], &[(15.0, 4.0), (20.0, 4.0)]].concat();
    let outline = Profile::new(&lines(&points), Grown::default());
    assert_eq!(ends(&outline.climb(Point2::new(5.0, 0.0), 4.0)), [(5.0, 3.0), (15.0, 3.0), (15.0, 4.0)]);
    let dips = outline.dips(Point2::new(0.0, 0.0), 10.0, 0.01);
    assert_eq!(dips, [Dip { left: 9.0, right: 15.0, rim: 3.0 }]);
    assert_eq!(outline.dips(Point2::new(0.0, 0.0), 2.0, 0.01), [Dip { left: 10.0, right: 15.0, rim: 2.0 }]);
    let back = outline.mirrored();
    assert_eq!(ends(&back.climb(Point2::new(-11.0, 1.0), 3.0)), [(-9.0, 3.0)]);
}

#[test]
fn ways_run_backwards_through_the_same_points() {
    let start = Point2::new(0.0, 0.0);
    let legs = [
        Leg::Line { to: Point2::new(1.0, 0.0) },
        Leg::Arc { to: Point2::new(2.0, 1.0), center: Point2::new(1.0, 1.0), ccw: true },
    ];
    let back = backwards(start, &legs);
    assert_eq!(ends(&back), [(1.0, 0.0), (0.0, 0.0)]);
    assert!(matches!(back[0], Leg::Arc { ccw: false, .. }));
    assert_eq!(ends(&mirrored(&legs)), [(-1.0, 0.0), (-2.0, 1.0)]);
}

#[test]
fn what_leans_over_is_in_its_own_shadow() {
    let leaning = [(0.0, 0.0), (6.0, 0.0), (6.4, 1.0), (6.0, 2.0), (6.0, 5.0), (9.0, 5.0)];
    let outline = Profile::new(&lines(&leaning), Grown::default());
    assert_eq!((outline.first_above(0.5, 0.0), outline.height(6.2)), (Some(6.0), 5.0));
}

#[test]
fn a_dip_ends_where_its_wall_reaches_the_rim() {
    // Down 10 at half a right angle, and up 20 again: the rim of 0 is reached half the way up.
    let groove = Profile::new(&lines(&[(0.0, 0.0), (10.0, -10.0), (30.0, 10.0), (40.0, 10.0)]), Grown::default());
    let dips = |top: f64, least: f64| {
        let dips = groove.dips(Point2::new(0.0, 0.0), top, least);
        dips.iter().map(|dip| (dip.left, dip.right, dip.rim)).collect::<Vec<_>>()
    };
    assert_eq!(dips(20.0, 1.0), [(0.0, 20.0, 0.0)]);
    // Under a lower top it is narrower, and it is none where it shall be deeper than it is.
    assert_eq!(dips(-4.0, 1.0), [(4.0, 16.0, -4.0)]);
    assert_eq!(dips(20.0, 10.5), []);
    // Behind a wall it ends at the wall.
    let walled = Profile::new(&lines(&[(0.0, 0.0), (0.0, -5.0), (8.0, -5.0), (8.0, 3.0)]), Grown::default());
    let found = walled.dips(Point2::new(-1.0, 0.0), 20.0, 1.0);
    assert!(found.iter().all(|dip| (dip.right - 8.0).abs() < 1e-9 && dip.rim == 0.0), "{found:?}");
}
