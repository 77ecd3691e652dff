use super::*;
use crate::geo::distance;
use crate::ir::Feed;
use crate::ir::cycle::Cycle;
use crate::ir::cycle::recess::{Operation, RecessTool};
use crate::ir::cycle::roughing::tests::shaft;
use crate::ir::cycle::turning::Towards;
use crate::lower::cycles::simulate::{Blank, GRID, StepDown, chain, check_lowering, height, moved_by, samples, step};
use crate::lower::cycles::track::{Move, Path, Stroke};
use proptest::prelude::*;

fn strokes(roughing: &Roughing, from: Point2) -> Result<Vec<Move>, &'static str> {
    let mut list = Vec::new();
    expand(roughing, from, &mut |stroke| {
        if let Stroke::Move(mv) = stroke {
            list.push(mv);
        }
    })
    .map_err(|failure| failure.code.id)?;
    Ok(list)
}

/// Strokes as words with X as a diameter; axes that stay are left out.
fn words(roughing: &Roughing, from: Point2) -> Vec<String> {
    let mut at = from;
    let round = |v: f64| (v * 1e4).round() / 1e4;
    let word = |letter, new: f64, old: f64| {
        if round(new) == round(old) { String::new() } else { format!(" {letter}{}", round(new)) }
    };
    let mut text = Vec::new();
    for Move { to, path } in strokes(roughing, from).expect("a path") {
        let head = match path {
            Path::Rapid => "G0",
            Path::Line { .. } => "G1",
            Path::Arc { ccw: true, .. } => "G3",
            Path::Arc { ccw: false, .. } => "G2",
            Path::Thread { .. } => "G33",
        };
        text.push(format!("{head}{}{}", word('X', 2.0 * to.y, 2.0 * at.y), word('Z', to.x, at.x)));
        at = to;
    }
    text
}

#[test]
fn contour_roughing_as_computed_by_hand() {
    let from = Point2::new(2.0, 26.0);
    let expected = [
        "G0 X46.5",
        "G1 Z-30",
        "G1 X48.5 Z-29",
        "G0 Z2", //
        "G0 X41",
        "G1 Z-30",
        "G1 X43 Z-29",
        "G0 Z2", //
        "G0 X35.5",
        "G1 Z-25.5",
        "G1 X37.5 Z-24.5",
        "G0 Z2", //
        "G0 X30",
        "G1 Z-20",
        "G1 X32 Z-19",
        "G0 Z2", //
        "G0 X30",
        "G1 Z-20",
        "G1 X40 Z-30",
        "G1 X50",
        "G1 X52 Z-29",
        "G0 Z2",
    ];
    assert_eq!(words(&shaft(), from), expected);
    let back = Roughing { end: RoughingEnd::Start, ..shaft() };
    assert_eq!(words(&back, from), expected);
}

#[test]
fn finishing_runs_along_the_contour_at_its_own_feed() {
    let from = Point2::new(2.0, 26.0);
    let oversize = Vec2::new(0.1, 0.25);
    let roughing = Roughing { operation: Operation::Finish, oversize, ..shaft() };
    assert_eq!(words(&roughing, from), ["G0 X30", "G1 Z-20", "G1 X40 Z-30", "G1 X50", "G1 X52 Z-29", "G0 Z2"]);
    let both = Roughing { operation: Operation::RoughAndFinish, finish_feed: Feed::PerRevolution(0.1), ..roughing };
    let list = strokes(&both, from).expect("a path");
    let fine = |mv: &&Move| mv.path == Path::Line { feed: Feed::PerRevolution(0.1) };
    assert_eq!(list.iter().filter(fine).count(), 3);
    // Roughing leaves the oversize: 0.25 of radius on the last cut, 0.1 in front of the shoulder.
    assert!(words(&both, from)[..4].contains(&"G1 Z-29.9".to_owned()));
    assert!(words(&both, from).contains(&"G0 X30.5".to_owned()));
}

#[test]
fn a_round_nose_follows_the_contour_with_its_tip() {
    // Nose 0.8, tip at its lower left: on the cone of 26.5651 degrees the tip runs beside the contour.
    let nose = Nose { radius: 0.8, tip: Vec2::new(-1.0, -1.0) };
    let roughing = Roughing { operation: Operation::Finish, nose, ..shaft() };
    let list = strokes(&roughing, Point2::new(2.0, 26.0)).expect("a path");
    let ends: Vec<Point2> = list.iter().map(|mv| mv.to).collect();
    // Foot of the cone: centre at X30/2 + 0.8 and 0.8·tan(26.565/2) = 0.188854 in front of the corner.
    let foot = Point2::new(-20.0 + 0.188_854_38 - 0.8, 15.0);
    assert!(ends.iter().any(|p| distance(*p, foot) < 1e-6), "{ends:?}");
    // On the shoulder the tip touches it.
    assert!(ends.iter().any(|p| (p.x + 30.0).abs() < 1e-9 && p.y > 20.0), "{ends:?}");
}

#[test]
fn every_cut_may_follow_the_contour() {
    let roughing = Roughing { smoothing: Smoothing::EachCut, ..shaft() };
    let list = words(&roughing, Point2::new(2.0, 26.0));
    // The third cut at X35.5 ends on the cone, and follows it and the shoulder up to the second.
    assert_eq!(list[10..16], ["G0 X35.5", "G1 Z-25.5", "G1 X40 Z-30", "G1 X41", "G1 X43 Z-29", "G0 Z2"]);
}

#[test]
fn longitudinal_rectangle_as_computed_by_hand() {
    let from = Point2::new(2.0, 31.0);
    let to = Point2::new(-30.0, 25.0);
    let feed = Feed::PerRevolution(0.3);
    let roughing = Roughing::rectangle(from, to, Towards::MinusX, 2.5, 0.0, feed);
    let expected = [
        "G0 X58",
        "G1 Z-30",
        "G1 X60 Z-29",
        "G0 Z2", //
        "G0 X54",
        "G1 Z-30",
        "G1 X56 Z-29",
        "G0 Z2", //
        "G0 X50",
        "G1 Z-30",
        "G1 X52 Z-29",
        "G0 Z2",
    ];
    assert_eq!(words(&roughing, from), expected);
    let fed = Roughing { entry: Some(feed), end: RoughingEnd::Start, ..roughing };
    let list = words(&fed, from);
    assert_eq!((list[0].as_str(), list.last().map(String::as_str)), ("G1 X58", Some("G0 X62")));
}

#[test]
fn transverse_rectangle_as_computed_by_hand() {
    let from = Point2::new(3.0, 31.0);
    let to = Point2::new(0.0, 10.0);
    let roughing = Roughing::rectangle(from, to, Towards::MinusZ, 1.25, 0.0, Feed::PerRevolution(0.3));
    let expected = [
        "G0 Z2",
        "G1 X20",
        "G1 X22 Z3",
        "G0 X62", //
        "G0 Z1",
        "G1 X20",
        "G1 X22 Z2",
        "G0 X62", //
        "G0 Z0",
        "G1 X20",
        "G1 X22 Z1",
        "G0 X62",
    ];
    assert_eq!(words(&roughing, from), expected);
}

#[test]
fn a_rectangle_may_end_obliquely() {
    // The end face leans by 3 mm from the corner to the height of the tool.
    let from = Point2::new(2.0, 31.0);
    let to = Point2::new(-30.0, 25.0);
    let roughing = Roughing::rectangle(from, to, Towards::MinusX, 3.0, -3.0, Feed::PerRevolution(0.3));
    let roughing = Roughing { smoothing: Smoothing::LastCut, ..roughing };
    let list = words(&roughing, from);
    assert_eq!(list[..2], ["G0 X56", "G1 Z-31.5"]);
    assert_eq!(list[list.len() - 4..], ["G1 Z-30", "G1 X62 Z-33", "G1 X64 Z-32", "G0 Z2"]);
}

#[test]
fn refused_roughing() {
    let from = Point2::new(2.0, 26.0);
    let code = |roughing: Roughing, from| strokes(&roughing, from).expect_err("refused");
    assert_eq!(code(Roughing { most: 1e-9, ..shaft() }, from), "G3040");
    assert_eq!(code(Roughing { lift: 0.0, ..shaft() }, from), "G3041");
    assert_eq!(code(Roughing { blank: 14.0, ..shaft() }, from), "G3046");
    assert_eq!(code(shaft(), Point2::new(-10.0, 20.0)), "G3046");
    let contour = crate::ir::cycle::recess::tests::lines(&[(2.0, 30.0), (-10.0, 30.0), (-15.0, 20.0), (-20.0, 50.0)]);
    assert_eq!(code(Roughing { contour: contour.clone(), ..shaft() }, from), "G3047");
    assert!(strokes(&Roughing { contour, falling: Falling::Bridged, ..shaft() }, from).is_ok());
}

fn case() -> impl Strategy<Value = (Vec<Element>, Roughing, View)> {
    let numbers = (0.3f64..3.0, 0.0f64..0.4, 0.0f64..0.4, 0.15f64..1.2, 0.0f64..2.0, 0.5f64..4.0);
    (prop::collection::vec(step(), 1..6), numbers, (0usize..3, 0usize..3, 0usize..4, any::<bool>(), any::<bool>()))
        .prop_map(|(steps, (most, along, deep, radius, proud, level), (smoothing, operation, into, back, turned))| {
            let wall = chain(&[steps.as_slice(), &[StepDown::Line(level, 0.0)]].concat());
            // The last step down is the helper's own; it must not be below the floor.
            let foot = wall.last().map_or(0.0, |e| e.from().y);
            let wall = moved_by(&wall[..wall.len() - 1], Vec2::new(0.0, -foot));
            let into = [Towards::MinusX, Towards::PlusX, Towards::MinusZ, Towards::PlusZ][into];
            let view = View::new(into, if back { -1.0 } else { 1.0 });
            let place = |p: Point2| view.part(p + Vec2::new(70.0, 90.0));
            let mut contour: Vec<Element> = wall
                .iter()
                .map(|e| match *e {
                    Element::Line { from, to } => Element::Line { from: place(from), to: place(to) },
                    Element::Arc { from, to, center, sweep } => Element::Arc {
                        from: place(from),
                        to: place(to),
                        center: place(center),
                        sweep: if view.mirrors() { -sweep } else { sweep },
                    },
                })
                .collect();
            if turned {
                contour = contour.iter().rev().map(super::super::slope::reversed).collect();
            }
            let end = wall.last().map_or(Point2::origin(), Element::to);
            let begin = place(end + Vec2::new(2.0, 0.0));
            let blank = place(Point2::new(0.0, proud - foot));
            let roughing = Roughing {
                contour,
                into,
                nose: Nose { radius, tip: into.unit() },
                blank: into.depth_coordinate(blank),
                begin: if into.is_radial() { begin.x } else { begin.y },
                most,
                oversize: if into.is_radial() { Vec2::new(along, deep) } else { Vec2::new(deep, along) },
                smoothing: [Smoothing::EachCut, Smoothing::LastCut, Smoothing::Never][smoothing],
                operation: [Operation::Rough, Operation::RoughAndFinish, Operation::Finish][operation],
                finish_feed: Feed::PerRevolution(0.1),
                falling: Falling::Refused,
                lift: 1.0,
                feed: Feed::PerRevolution(0.2),
                entry: None,
                end: RoughingEnd::Start,
            };
            (wall, roughing, view)
        })
}

fn check_cutting(wall: &[Element], roughing: &Roughing, view: &View) -> Result<(), TestCaseError> {
    let origin = Vec2::new(70.0, 90.0);
    let end = wall.last().map_or(Point2::origin(), Element::to);
    let top = view.height(roughing.blank) - origin.y;
    let start = view.part(Point2::new(end.x + 3.0, top + 1.0) + origin);
    let list = match strokes(roughing, start) {
        Ok(list) => list,
        Err("G3046") => return Err(TestCaseError::reject("the blank is lower than the oversize")),
        Err(code) => return Err(TestCaseError::fail(code)),
    };
    prop_assert!(list.iter().all(|mv| mv.to.x.is_finite() && mv.to.y.is_finite()), "{list:?}");
    let r = roughing.nose.radius;
    let tool = RecessTool { width: 2.0 * r, nose: r, edge: 0.0 };
    let over = if roughing.into.is_radial() { roughing.oversize } else { roughing.oversize.yx() };
    // The floor goes on to where the cuts begin.
    let surface = |x: f64| if x > end.x { end.y } else { height(wall, x).max(end.y) };
    let rough = |x: f64| over.y + surface(x - over.x);
    let limit = if roughing.operation == Operation::Rough { &rough as &dyn Fn(f64) -> f64 } else { &surface };
    let mut blank = Blank { left: -1.0 + GRID * 0.37, columns: Vec::new() };
    blank.columns = vec![top; ((end.x + 1.5) / GRID) as usize];
    let column = |blank: &Blank, i: usize| blank.left + i as f64 * GRID;
    if roughing.operation == Operation::Finish {
        for i in 0..blank.columns.len() {
            blank.columns[i] = top.min(rough(column(&blank, i)));
        }
    }
    let mut at = view.point(start) - origin;
    for mv in &list {
        let path = match mv.path {
            Path::Arc { center, ccw, feed } => {
                Path::Arc { center: view.point(center) - origin, ccw: ccw != view.mirrors(), feed }
            }
            other => other,
        };
        let seen = Move { to: view.point(mv.to) - origin, path };
        let before = blank.columns.clone();
        for p in samples(at, &seen) {
            let hits: Vec<(usize, f64)> = blank.under(&tool, p.x - r).map(|(i, up)| (i, p.y + up)).collect();
            for (i, y) in hits {
                let c = column(&blank, i);
                let floor = limit(c).min(limit(c - 1e-6)).min(limit(c + 1e-6));
                prop_assert!(y >= floor - 1e-6 || y >= top, "gouges at {c}: {y} under {floor}, {mv:?}");
                if matches!(mv.path, Path::Rapid) {
                    prop_assert!(y >= blank.columns[i] - 1e-6, "rapid into {} at {c}: {mv:?}", blank.columns[i]);
                } else if y < blank.columns[i] {
                    blank.columns[i] = y;
                }
            }
        }
        // A fillet of the nose may stand on what the cut before left.
        let deep = (0..before.len()).map(|i| before[i] - blank.columns[i]).fold(0.0, f64::max);
        let finishes = roughing.operation != Operation::Rough;
        prop_assert!(finishes || deep <= roughing.most + r + 1e-6, "{deep} deep: {mv:?}");
        at = seen.to;
    }
    prop_assert!(distance(at, view.point(start) - origin) < 1e-9);
    // What stands at the end: nothing but the fillets of the nose, and the steps where they were to stay.
    let stays = roughing.smoothing == Smoothing::Never && roughing.operation == Operation::Rough;
    let most = if stays { roughing.most } else { 0.0 };
    for i in 0..blank.columns.len() {
        let c = column(&blank, i);
        let steep = [-0.3, -0.1, 0.1, 0.3].iter().any(|d| (limit(c + d) - limit(c)).abs() > 3.0 * d.abs());
        let flat = (-20..=20).all(|k| (limit(c + f64::from(k) * r / 10.0) - limit(c)).abs() < 1e-9);
        if !steep && c > over.x {
            let rest = blank.columns[i] - limit(c);
            let fillet = if flat { 0.0 } else { 2.0 * r };
            prop_assert!(rest <= most + fillet + 0.15, "{rest} stands at {c}");
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, failure_persistence: None, ..ProptestConfig::default() })]

    /// No gouge, no rapid in material, no cut over the infeed, nothing left but the oversize.
    #[test]
    fn random_walls_are_cut_right((wall, roughing, view) in case()) {
        check_cutting(&wall, &roughing, &view)?;
        check_lowering(&Cycle::Roughing(roughing), view.part(Point2::new(95.0, 110.0)))?;
    }
}
