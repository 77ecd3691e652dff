use super::*;

fn p(x: f64, z: f64) -> Point2 {
    Point2::new(z, x / 2.0)
}

fn run(start: Point2, elements: &[Partial]) -> Vec<Point2> {
    let mut chain = Chain::default();
    for e in elements {
        chain.push(*e, ());
    }
    let (mut at, mut dir, mut ends) = (start, None, Vec::new());
    while !chain.is_empty() {
        let (solved, ()) = chain.next(at, dir, true).unwrap().unwrap();
        at = solved.to;
        dir = solved.end_direction();
        ends.push(at);
    }
    ends
}

fn near(a: Point2, b: Point2) {
    assert!(distance(a, b) < 1e-4, "{a:?} {b:?}");
}

fn line_to(x: f64, z: f64) -> Partial {
    Partial { x: Coord::At(x / 2.0), z: Coord::At(z), tangential: true, ..Partial::default() }
}

#[test]
fn a_line_by_angle() {
    // Worked example 10: from X20 Z-12, Z-24 A20 reaches X28.7353.
    let e = Partial { z: Coord::At(-24.0), angle: Some(20.0), ..Partial::default() };
    near(run(p(20.0, -12.0), &[e])[0], p(28.7353, -24.0));
    // X100 A80 from X90 leans towards -Z.
    let e = Partial { x: Coord::At(50.0), angle: Some(80.0), ..Partial::default() };
    near(run(p(90.0, -12.0), &[e])[0], p(100.0, -12.8816));
}

#[test]
fn two_lines_by_their_angles() {
    let first = Partial { angle: Some(0.0), ..Partial::default() };
    let second = Partial { angle: Some(45.0), ..line_to(60.0, -50.0) };
    near(run(p(20.0, 0.0), &[first, second])[0], p(20.0, -30.0));
}

#[test]
fn a_line_cut_by_a_circle_near_and_far() {
    // Circle about X0 Z-50 with radius 25; the line X30 cuts it at Z-30 and Z-70.
    let arc = Partial {
        arc: Some(true),
        radius: Some(25.0),
        center: Center { z: Some(-50.0), x: Some(0.0), absolute: true },
        ..line_to(50.0, -50.0)
    };
    let ray = |far| Partial { angle: Some(0.0), far, ..Partial::default() };
    near(run(p(30.0, 0.0), &[ray(false), arc])[0], p(30.0, -30.0));
    near(run(p(30.0, 0.0), &[ray(true), arc])[0], p(30.0, -70.0));
}

#[test]
fn a_fillet_between_two_lines() {
    // Corner at X20 Z-30, radius 5 into the shoulder: Z-25, then X30 Z-30.
    let ray = Partial { angle: Some(0.0), tangential: true, ..Partial::default() };
    let arc = Partial {
        arc: Some(false),
        x: Coord::Unknown,
        z: Coord::Unknown,
        radius: Some(5.0),
        tangential: true,
        ..Partial::default()
    };
    let wall = Partial { angle: Some(90.0), ..line_to(60.0, -30.0) };
    let ends = run(p(20.0, 0.0), &[ray, arc, wall]);
    near(ends[0], p(20.0, -25.0));
    near(ends[1], p(30.0, -30.0));
}

#[test]
fn arcs_of_the_640_manual_go_over_into_each_other() {
    // `G12 X? Z? R15` behind a known direction, `G13 X25 Z-30 R30` behind it.
    let first = Partial {
        arc: Some(false),
        x: Coord::Unknown,
        z: Coord::Unknown,
        radius: Some(15.0),
        tangential: true,
        ..Partial::default()
    };
    let second = Partial { arc: Some(true), radius: Some(30.0), ..line_to(80.0, -40.0) };
    let solved = {
        let mut chain = Chain::default();
        chain.push(first, ());
        chain.push(second, ());
        let one = chain.next(p(40.0, 0.0), Some(Vec2::new(-1.0, 0.0)), true).unwrap().unwrap().0;
        let two = chain.next(one.to, one.end_direction(), true).unwrap().unwrap().0;
        [one, two]
    };
    let (c, _) = solved[1].arc.unwrap();
    let start = arc::tangent_at(solved[1].from, c, true).unwrap();
    assert!((start - solved[0].end_direction().unwrap()).norm() < 1e-9, "{solved:?}");
}

#[test]
fn a_missing_centre_coordinate_follows_from_the_end() {
    // `G3 X20 Z-41.6241 I-14.5` from Z-23.8759: radius 17.
    let e =
        Partial { arc: Some(true), center: Center { x: Some(-14.5), ..Center::default() }, ..line_to(20.0, -41.6241) };
    let mut chain = Chain::default();
    chain.push(e, ());
    let (c, _) = chain.next(p(20.0, -23.8759), None, true).unwrap().unwrap().0.arc.unwrap();
    assert!((distance(c, p(20.0, -23.8759)) - 17.0).abs() < 1e-4);
}
