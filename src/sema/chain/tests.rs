use super::*;
use crate::geo::open::{Center, Coord, Solved};
use crate::geo::{Point2, SAME_POINT, Vec2, arc, distance};

/// The further one of two solutions, or the nearer one.
#[derive(Debug)]
struct Far(bool);

impl Choice for Far {
    const RULES: Rules = Rules {
        agrees: 0.02,
        touch: SAME_POINT,
        smooth_touch: 0.02,
        reach: |_| SAME_POINT,
        chord: None,
        one_coordinate: false,
        leaves_along: false,
    };

    fn choose(&self, start: &Start, _: Option<&Far>, among: &Solutions) -> Result<Solution, Fault> {
        let way = |solution: &&Solution| distance(solution.solved.to, start.at);
        let nearer = among.iter().min_by(|a, b| way(a).total_cmp(&way(b)));
        let further = among.iter().max_by(|a, b| way(a).total_cmp(&way(b)));
        if self.0 { further } else { nearer }.copied().ok_or(Fault::Open(""))
    }
}

fn p(x: f64, z: f64) -> Point2 {
    Point2::new(z, x / 2.0)
}

fn solved(start: Point2, dir: Option<Vec2>, elements: &[(Data, bool)]) -> Vec<Solved> {
    let mut chain = Chain::default();
    for (data, far) in elements {
        chain.push(*data, Far(*far));
    }
    let (mut at, mut dir, mut list) = (start, dir, Vec::new());
    while !chain.is_empty() {
        let (solution, _) = chain.next(&Start { at, dir, goes_on: true }, true).unwrap().unwrap();
        at = solution.solved.to;
        dir = solution.solved.end_direction();
        list.push(solution.solved);
    }
    list
}

fn run(start: Point2, elements: &[Data]) -> Vec<Point2> {
    let near: Vec<_> = elements.iter().map(|data| (*data, false)).collect();
    solved(start, None, &near).iter().map(|element| element.to).collect()
}

fn angle(degrees: f64) -> Option<Entry> {
    Some(Angles::FromMinus.entry(Deg(degrees)))
}

fn near(a: Point2, b: Point2) {
    assert!(distance(a, b) < 1e-4, "{a:?} {b:?}");
}

fn line_to(x: f64, z: f64) -> Data {
    Data { y: Coord::At(x / 2.0), x: Coord::At(z), smooth: true, ..Data::default() }
}

#[test]
fn a_line_by_angle() {
    // Worked example 10: from X20 Z-12, Z-24 A20 reaches X28.7353.
    let e = Data { x: Coord::At(-24.0), entry: angle(20.0), ..Data::default() };
    near(run(p(20.0, -12.0), &[e])[0], p(28.7353, -24.0));
    // X100 A80 from X90 leans towards -Z.
    let e = Data { y: Coord::At(50.0), entry: angle(80.0), ..Data::default() };
    near(run(p(90.0, -12.0), &[e])[0], p(100.0, -12.8816));
}

#[test]
fn two_lines_by_their_angles() {
    let first = Data { entry: angle(0.0), ..Data::default() };
    let second = Data { entry: angle(45.0), ..line_to(60.0, -50.0) };
    near(run(p(20.0, 0.0), &[first, second])[0], p(20.0, -30.0));
}

#[test]
fn a_line_cut_by_a_circle_near_and_far() {
    // Circle about X0 Z-50 with radius 25; the line X30 cuts it at Z-30 and Z-70.
    let arc = Data {
        arc: Some(true),
        radius: Some(25.0),
        center: Center { x: Some(-50.0), y: Some(0.0), absolute: true },
        ..line_to(50.0, -50.0)
    };
    let ray = Data { entry: angle(0.0), ..Data::default() };
    let end = |far| solved(p(30.0, 0.0), None, &[(ray, far), (arc, far)])[0].to;
    near(end(false), p(30.0, -30.0));
    near(end(true), p(30.0, -70.0));
}

#[test]
fn a_fillet_between_two_lines() {
    // Corner at X20 Z-30, radius 5 into the shoulder: Z-25, then X30 Z-30.
    let ray = Data { entry: angle(0.0), smooth: true, ..Data::default() };
    let arc =
        Data { arc: Some(false), x: Coord::Open, y: Coord::Open, radius: Some(5.0), smooth: true, ..Data::default() };
    let wall = Data { entry: angle(90.0), ..line_to(60.0, -30.0) };
    let ends = run(p(20.0, 0.0), &[ray, arc, wall]);
    near(ends[0], p(20.0, -25.0));
    near(ends[1], p(30.0, -30.0));
}

#[test]
fn arcs_of_the_640_manual_go_over_into_each_other() {
    // `G12 X? Z? R15` behind a known direction, `G13 X25 Z-30 R30` behind it.
    let first =
        Data { arc: Some(false), x: Coord::Open, y: Coord::Open, radius: Some(15.0), smooth: true, ..Data::default() };
    let second = Data { arc: Some(true), radius: Some(30.0), ..line_to(80.0, -40.0) };
    let solved = solved(p(40.0, 0.0), Some(Vec2::new(-1.0, 0.0)), &[(first, false), (second, false)]);
    let (c, _) = solved[1].arc.unwrap();
    let start = arc::tangent_at(solved[1].from, c, true).unwrap();
    assert!((start - solved[0].end_direction().unwrap()).norm() < 1e-9, "{solved:?}");
}

#[test]
fn a_missing_centre_coordinate_follows_from_the_end() {
    // `G3 X20 Z-41.6241 I-14.5` from Z-23.8759: radius 17.
    let e = Data { arc: Some(true), center: Center { y: Some(-14.5), ..Center::default() }, ..line_to(20.0, -41.6241) };
    let (c, _) = solved(p(20.0, -23.8759), None, &[(e, false)])[0].arc.unwrap();
    assert!((distance(c, p(20.0, -23.8759)) - 17.0).abs() < 1e-4);
}
