//! What is hidden of a complete element is found again, and nothing is found that does not fit.

use proptest::prelude::*;

use super::*;
use crate::geo::{Deg, cross};

const RULES: Rules = Rules {
    agrees: 0.02,
    touch: SAME_POINT,
    smooth_touch: 0.02,
    reach: |_| SAME_POINT,
    chord: None,
    one_coordinate: true,
    leaves_along: false,
};
const STRICT: Rules = Rules { one_coordinate: false, ..RULES };
/// What double arithmetic loses on parts of some 100 mm, also where a line grazes a circle.
const NEAR: f64 = 1e-4;

fn start(at: Point2) -> Start {
    Start { at, dir: None, goes_on: false }
}

fn at(p: Point2) -> (Coord, Coord) {
    (Coord::At(p.x), Coord::At(p.y))
}

fn line(angle: f64) -> Data {
    Data { x: Coord::Open, y: Coord::Open, entry: Some(Entry::Along(Deg(angle).unit())), ..Data::default() }
}

fn ending(data: Data, p: Point2) -> Data {
    let (x, y) = at(p);
    Data { x, y, ..data }
}

fn has(found: &Result<Solutions>, to: Point2, center: Option<Point2>) -> bool {
    found.as_ref().is_ok_and(|among| {
        among.iter().any(|solution| {
            let solved = solution.solved;
            let same = match (center, solved.arc) {
                (Some(a), Some((b, _))) => distance(a, b) <= NEAR,
                (None, None) => true,
                _ => false,
            };
            same && distance(solved.to, to) <= NEAR
        })
    })
}

/// An arc from its centre, the direction of its start and its sweep in degrees.
#[derive(Debug, Clone, Copy)]
struct Whole {
    from: Point2,
    to: Point2,
    center: Point2,
    ccw: bool,
    sweep: f64,
    radius: f64,
}

fn whole(x: f64, y: f64, radius: f64, begin: f64, sweep: f64) -> Whole {
    let center = Point2::new(x, y);
    let on = |angle: f64| center + Deg(angle).unit() * radius;
    Whole { from: on(begin), to: on(begin + sweep), center, ccw: sweep > 0.0, sweep: sweep.abs(), radius }
}

impl Whole {
    fn open(&self) -> Data {
        Data { arc: Some(self.ccw), x: Coord::Open, y: Coord::Open, tolerance: 0.005, ..Data::default() }
    }

    fn about_center(&self) -> Data {
        Data { center: Center { x: Some(self.center.x), y: Some(self.center.y), absolute: true }, ..self.open() }
    }

    fn tangent(&self, p: Point2) -> Vec2 {
        arc::tangent_at(p, self.center, self.ccw).expect("a radius")
    }
}

prop_compose! {
    fn arcs()(x in -50.0f64..50.0, y in -50.0f64..50.0, r in 1.0f64..40.0, a in 0.0f64..360.0, s in 5.0f64..170.0, ccw: bool) -> Whole {
        whole(x, y, r, a, if ccw { s } else { -s })
    }
}

proptest! {
    #[test]
    fn a_line_reaches_its_coordinate(x in -90.0f64..90.0, y in -90.0f64..90.0, angle in 0.0f64..360.0, to in -90.0f64..90.0) {
        let from = Point2::new(x, y);
        let u = Deg(angle).unit();
        for data in [Data { x: Coord::At(to), ..line(angle) }, Data { y: Coord::At(to), ..line(angle) }] {
            match solve(&start(from), &data, [None; 2], &STRICT) {
                Ok(among) => {
                    let end = among.single().expect("one end").solved.to;
                    prop_assert!(end.x == to || end.y == to);
                    let size = 1.0 + distance(end, from);
                    prop_assert!(cross(u, end - from).abs() <= 1e-9 * size);
                }
                Err(fault) => prop_assert_eq!(fault, NEVER),
            }
        }
    }

    #[test]
    fn two_lines_have_their_corner(x in -90.0f64..90.0, y in -90.0f64..90.0, a in 0.0f64..360.0, turn in 5.0f64..175.0, m in 1.0f64..80.0, n in 1.0f64..80.0) {
        let from = Point2::new(x, y);
        let corner = from + Deg(a).unit() * m;
        let to = corner + Deg(a + turn).unit() * n;
        let absolute = ending(line(a + turn), to);
        prop_assert!(has(&solve(&start(from), &line(a), [Some(&absolute), None], &STRICT), corner, None));
        let turned = Data { entry: Some(Entry::Turned(Deg(turn).radians())), ..absolute };
        prop_assert!(has(&solve(&start(from), &line(a), [Some(&turned), None], &STRICT), corner, None));
        prop_assert_eq!(solve(&start(from), &line(a), [Some(&ending(line(a), to)), None], &STRICT), Err(PARALLEL));
    }

    #[test]
    fn what_is_hidden_of_an_arc_is_found(w in arcs()) {
        let begin = start(w.from);
        let find = |data: Data| solve(&begin, &data, [None; 2], &RULES);
        let (x, y) = at(w.to);
        let lone = |c: Center| Data { center: Center { absolute: true, ..c }, radius: Some(w.radius), ..w.open() };
        let beside_x = lone(Center { x: Some(w.center.x), ..Center::default() });
        let beside_y = lone(Center { y: Some(w.center.y), ..Center::default() });
        let entry = Some(Entry::Along(w.tangent(w.from)));
        let cases = [
            ending(w.about_center(), w.to),
            Data { x, ..w.about_center() },
            Data { y, ..w.about_center() },
            Data { sweep: Some(Deg(w.sweep).radians()), ..w.about_center() },
            Data { exit: Some(w.tangent(w.to)), ..w.about_center() },
            ending(Data { radius: Some(w.radius), ..w.open() }, w.to),
            ending(Data { entry, ..w.open() }, w.to),
            Data { entry, radius: Some(w.radius), sweep: Some(Deg(w.sweep).radians()), ..w.open() },
            ending(beside_x, w.to),
            ending(beside_y, w.to),
            Data { sweep: Some(Deg(w.sweep).radians()), ..beside_x },
            Data { sweep: Some(Deg(w.sweep).radians()), ..beside_y },
        ];
        for (i, data) in cases.iter().enumerate() {
            let found = find(*data);
            prop_assert!(has(&found, w.to, Some(w.center)), "{} {:?} {:?}", i, w, found);
        }
    }

    #[test]
    fn an_arc_ends_where_the_next_element_begins(w in arcs(), length in 1.0f64..60.0, turn in 20.0f64..160.0) {
        let smooth = Data { smooth: true, ..w.about_center() };
        let find = |e: &Data, next: Data| solve(&start(w.from), e, [Some(&next), None], &STRICT);
        // A tangential line by its end, and by its direction and one coordinate.
        let t = w.tangent(w.to);
        let end = w.to + t * length;
        let plain = Data { entry: None, ..ending(Data::default(), end) };
        prop_assert!(has(&find(&smooth, plain), w.to, Some(w.center)));
        let leaning = Data { entry: Some(Entry::Parallel(-t)), x: Coord::At(end.x), y: Coord::Open, ..Data::default() };
        prop_assume!(t.x.abs() > 0.01);
        prop_assert!(has(&find(&smooth, leaning), w.to, Some(w.center)));
        let along = Rules { leaves_along: true, ..STRICT };
        let ahead = Data { entry: Some(Entry::Along(t)), x: Coord::Open, y: Coord::Open, ..Data::default() };
        prop_assert!(has(&solve(&start(w.from), &w.about_center(), [Some(&ahead), None], &along), w.to, Some(w.center)));
        // A line with a corner.
        let u = turned(t, Deg(turn).radians());
        let cut = Data { entry: Some(Entry::Parallel(u)), ..ending(Data::default(), w.to + u * length) };
        prop_assert!(has(&find(&w.about_center(), cut), w.to, Some(w.center)));
        // A circle.
        let other = w.to + u * length;
        let arc = Data { arc: Some(true), radius: Some(length), center: Center { x: Some(other.x), y: Some(other.y), absolute: true }, ..Data::default() };
        prop_assert!(has(&find(&w.about_center(), arc), w.to, Some(w.center)));
    }

    #[test]
    fn a_line_ends_on_the_circle_of_the_next_arc(w in arcs(), length in 1.0f64..60.0, turn in 10.0f64..170.0) {
        let u = turned(w.tangent(w.from), Deg(turn).radians());
        let from = w.from - u * length;
        let ray = Data { entry: Some(Entry::Along(u)), x: Coord::Open, y: Coord::Open, ..Data::default() };
        let next = ending(w.about_center(), w.to);
        let found = solve(&start(from), &ray, [Some(&next), None], &STRICT);
        prop_assert!(has(&found, w.from, None), "{:?}", found);
        let y = Data { entry: None, y: Coord::At(w.from.y), ..ray };
        prop_assert!(has(&solve(&start(from), &y, [Some(&next), None], &RULES), w.from, None));
        prop_assert_eq!(solve(&start(from), &y, [Some(&next), None], &STRICT), Err(NOT_FIXED));
        // Its centre by the radius, one coordinate and the end.
        let lone = Center { x: Some(w.center.x), y: None, absolute: true };
        let next = Data { center: lone, radius: Some(w.radius), ..next };
        prop_assert!(has(&solve(&start(from), &ray, [Some(&next), None], &RULES), w.from, None));
        // Without a corner: the centre lies beside the line.
        let t = w.tangent(w.from);
        prop_assume!(t.x.abs() > 0.01);
        let ray = Data { entry: Some(Entry::Along(t)), ..ray };
        let next = Data { entry: Some(Entry::Turned(0.0)), ..next };
        prop_assert!(has(&solve(&start(w.from - t * length), &ray, [Some(&next), None], &RULES), w.from, None));
    }

    #[test]
    fn a_fillet_touches_both_lines(a in 0.0f64..360.0, turn in 20.0f64..160.0, left: bool, radius in 0.5f64..5.0) {
        let turn = if left { turn } else { -turn };
        let corner = Point2::new(3.0, -7.0);
        let (u, w) = (Deg(a).unit(), Deg(a + turn).unit());
        let ray = Data { smooth: true, ..line(a) };
        let arc = Data { arc: Some(left), x: Coord::Open, y: Coord::Open, radius: Some(radius), smooth: true, ..Data::default() };
        let end = ending(line(a + turn), corner + w * 60.0);
        let from = corner - u * 60.0;
        let found = solve(&start(from), &ray, [Some(&arc), Some(&end)], &STRICT);
        let touch = found.map(|among| among.single().expect("one").solved.to).expect("a fillet");
        let back = radius * libm::tan(Deg(turn.abs() / 2.0).radians());
        prop_assert!(distance(touch, corner - u * back) <= NEAR);
    }

    /// Nothing that is not a number comes of numbers, and nothing panics.
    #[test]
    fn any_data_gives_numbers(kind in prop::option::of(any::<bool>()), v in prop::collection::vec(prop::option::of(-9.0f64..9.0), 8), next in prop::option::of(any::<bool>()), smooth: bool) {
        let coord = |v: Option<f64>| v.map_or(Coord::Open, Coord::At);
        let center = Center { x: v[3], y: v[4], absolute: smooth };
        let data = |arc, i: usize, j: usize| Data {
            arc, x: coord(v[i]), y: coord(v[j]), entry: v[2].map(|a| Entry::Parallel(Deg(a * 30.0).unit())),
            radius: v[5], center, smooth, tolerance: 0.02, ..Data::default()
        };
        let (e, second) = (data(kind, 0, 1), data(next, 6, 7));
        for rules in [RULES, STRICT] {
            let begin = Start { at: Point2::new(1.0, 2.0), dir: v[6].map(|a| Deg(a * 40.0).unit()), goes_on: smooth };
            if let Ok(among) = solve(&begin, &e, [Some(&second), None], &rules) {
                prop_assert!(among.iter().all(|s| s.solved.to.x.is_finite() && s.solved.to.y.is_finite()));
            }
        }
    }
}

#[test]
fn a_radius_says_which_centre_beside_a_coordinate_is_meant() {
    // A quarter of radius 10 about the zero point; centres with x = 0 by its end (0 10) lie at y = 0 and y = 20.
    let w = whole(0.0, 0.0, 10.0, 0.0, 90.0);
    let data =
        Data { center: Center { x: Some(0.0), y: None, absolute: true }, radius: Some(10.0), ..ending(w.open(), w.to) };
    let found = solve(&start(w.from), &data, [None; 2], &RULES).expect("a solution");
    let single = found.single().expect("only one lies at the radius from the start");
    assert!(distance(single.solved.arc.expect("an arc").0, w.center) <= NEAR);
    // Where a coordinate of a centre alone says nothing, it is one number too many.
    assert_eq!(solve(&start(w.from), &data, [None; 2], &STRICT), Err(TOO_MUCH));
}

#[test]
fn a_radius_that_contradicts_the_centre_is_noticed() {
    let w = whole(3.0, -2.0, 10.0, 20.0, 90.0);
    let about = |radius: f64| Data { radius: Some(radius), ..ending(w.about_center(), w.to) };
    for radius in [10.0, -10.0, 10.004] {
        let found = solve(&start(w.from), &about(radius), [None; 2], &RULES);
        assert!(has(&found, w.to, Some(w.center)), "{radius}");
    }
    for radius in [9.9, 10.1, -9.9] {
        assert_eq!(solve(&start(w.from), &about(radius), [None; 2], &RULES), Err(RADIUS_DIFFERS), "{radius}");
    }
    // A language that compares afterwards takes it.
    let later = Rules { agrees: f64::INFINITY, ..RULES };
    assert!(solve(&start(w.from), &about(9.9), [None; 2], &later).is_ok());
}

#[test]
fn a_line_is_known_without_its_start_where_its_coordinate_stands_still() {
    let near = Point2::new(50.0, 60.0);
    let upright = Data { x: Coord::At(7.0), ..line(90.0) };
    let (on, u) = upright.fixed_line(near, None).expect("x holds all along");
    assert!(on == Point2::new(7.0, 60.0) && (u - Vec2::new(0.0, 1.0)).norm() < 1e-12);
    let level = Data { y: Coord::At(7.0), ..line(0.0) };
    assert_eq!(level.fixed_line(near, None).expect("y holds all along").0, Point2::new(50.0, 7.0));
    // A slanting one goes through many points.
    assert_eq!(Data { x: Coord::At(7.0), ..line(30.0) }.fixed_line(near, None), None);
    assert_eq!(Data { y: Coord::At(7.0), ..line(30.0) }.fixed_line(near, None), None);
    let through = ending(line(30.0), Point2::new(1.0, 2.0));
    assert_eq!(through.fixed_line(near, None).expect("a point of it").0, Point2::new(1.0, 2.0));
}
