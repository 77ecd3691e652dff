use core::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, PI};

use super::clock::{along_arc, time_of};
use super::*;
use crate::geo::Plane;
use crate::geo::Point2;
use crate::ir::Feed;
use crate::ir::function::Spindle;

/// Speeds up and stops in no time: a way takes its length by its speed.
const AT_ONCE: Model = Model { rapid: 6000.0, acceleration: 1e12, tool_change: 4.0 };

fn is_near(value: f64, wanted: f64) -> bool {
    (value - wanted).abs() < 1e-6
}

fn all_near(values: [f64; 3], wanted: [f64; 3]) -> bool {
    values.iter().zip(wanted).all(|(value, wanted)| is_near(*value, wanted))
}

fn place(values: &[(Axis, f64)]) -> Pos {
    let mut pos = Pos::UNKNOWN;
    values.iter().for_each(|(axis, value)| pos.set(*axis, *value));
    pos
}

fn to(values: &[(Axis, f64)], path: Path) -> Move {
    Move { end: place(values), axes: values.iter().map(|(axis, _)| *axis).collect(), path, ..Move::default() }
}

/// What moves and functions from a place make.
fn counted(model: Model, from: &[(Axis, f64)], functions: &[Function], moves: &[Move]) -> Stats {
    let mut counter = Counter::new(model);
    counter.begins_at(&place(from));
    functions.iter().for_each(|function| counter.function(function, &Origin::default()));
    moves.iter().for_each(|mv| counter.movement(mv, &Origin::default()));
    counter.finish()
}

fn line(feed: Feed) -> Path {
    Path::Line(feed)
}

#[test]
fn a_way_from_rest_to_rest_takes_its_time() {
    // 1 m/s² up to 100 mm/s takes 0.1 s and 5 mm each; 90 mm at 100 mm/s take 0.9 s.
    assert!(is_near(time_of(100.0, 0.0, 100.0, 0.0, 1000.0), 1.1));
    // Too short to reach it: 2 * sqrt(d / a).
    assert!(is_near(time_of(2.5, 0.0, 100.0, 0.0, 1000.0), 0.1));
    // At one speed all along.
    assert!(is_near(time_of(50.0, 100.0, 100.0, 100.0, 1000.0), 0.5));
}

#[test]
fn a_way_between_two_speeds_takes_its_time() {
    // From 60 to 100 mm/s in 0.04 s and 3.2 mm, down to 20 in 0.08 s and 4.8 mm, 42 mm at 100 mm/s.
    assert!(is_near(time_of(50.0, 60.0, 100.0, 20.0, 1000.0), 0.54));
    // The peak v of 1 mm: v² = 1000 * 1 + (30² + 10²) / 2; it takes (v - 30) / a + (v - 10) / a.
    assert!(is_near(time_of(1.0, 30.0, 100.0, 10.0, 1000.0), 0.037_459_666_9));
    // 0.1 mm are too short to come from 30 down to 10 mm/s: at the mean of both.
    assert!(is_near(time_of(0.1, 30.0, 100.0, 10.0, 1000.0), 0.005));
}

#[test]
fn a_half_circle_reaches_beside_its_ends() {
    let arc = Arc { plane: Plane::Xy, from: Point2::new(10.0, 0.0), center: Point2::new(0.0, 0.0), sweep: PI };
    let mut most = 0.0_f64;
    farthest(&arc, |axis, value| {
        if axis == 1 {
            most = most.max(value);
        }
    });
    assert!((most - 10.0).abs() < 1e-9);
    let (length, enters, leaves) = along_arc(&arc, [-20.0, 0.0, 0.0]);
    assert!((length - 10.0 * PI).abs() < 1e-9);
    assert!((enters[1] - 1.0).abs() < 1e-9 && (leaves[1] + 1.0).abs() < 1e-9);
}

#[test]
fn an_arc_reaches_each_quarter_that_it_passes() {
    let reached = |from: Point2, sweep: f64| {
        let mut reached = [(f64::MAX, f64::MIN); 3];
        let arc = Arc { plane: Plane::Xy, from, center: Point2::new(5.0, 3.0), sweep };
        farthest(&arc, |axis, value| reached[axis] = (reached[axis].0.min(value), reached[axis].1.max(value)));
        reached
    };
    // Around (5 3) with radius 10: from 10° over 90° to 190°, and back.
    let (sin, cos) = (libm::sin(PI / 18.0), libm::cos(PI / 18.0));
    for (start, sweep) in
        [(Point2::new(5.0 + 10.0 * cos, 3.0 + 10.0 * sin), PI), (Point2::new(5.0 - 10.0 * cos, 3.0 - 10.0 * sin), -PI)]
    {
        let [x, y, z] = reached(start, sweep);
        assert!(is_near(x.0, -5.0) && is_near(x.1, 5.0), "{x:?}");
        assert!(is_near(y.0, 3.0) && is_near(y.1, 13.0), "{y:?}");
        assert_eq!(z, (f64::MAX, f64::MIN));
    }
    // Between two of them nothing is farther than the ends.
    assert_eq!(reached(Point2::new(5.0 + 10.0 * cos, 3.0 + 10.0 * sin), PI / 3.0), [(f64::MAX, f64::MIN); 3]);
}

#[test]
fn a_helix_is_as_long_as_its_slope_and_leads_along_it() {
    // A quarter of 5 pi mm that rises as much: 45°.
    let rise = 5.0 * PI;
    let helix =
        |sweep: f64| Arc { plane: Plane::Xy, from: Point2::new(12.0, 1.0), center: Point2::new(2.0, 1.0), sweep };
    let (length, enters, leaves) = along_arc(&helix(FRAC_PI_2), [-10.0, 10.0, rise]);
    assert!(is_near(length, rise / FRAC_1_SQRT_2));
    assert!(all_near(enters, [0.0, FRAC_1_SQRT_2, FRAC_1_SQRT_2]), "{enters:?}");
    assert!(all_near(leaves, [-FRAC_1_SQRT_2, 0.0, FRAC_1_SQRT_2]), "{leaves:?}");
    let (_, enters, leaves) = along_arc(&helix(-FRAC_PI_2), [-10.0, -10.0, 0.0]);
    assert!(all_near(enters, [0.0, -1.0, 0.0]), "{enters:?}");
    assert!(all_near(leaves, [-1.0, 0.0, 0.0]), "{leaves:?}");
}

#[test]
fn rotary_axes_alone_count_in_degrees() {
    // 30° and 40° together are 50°, at 100°/min.
    let from = [(Axis::X, 0.0), (Axis::Y, 0.0), (Axis::Z, 0.0), (Axis::A, 10.0), (Axis::C, 5.0)];
    let stats = counted(AT_ONCE, &from, &[], &[to(&[(Axis::A, 40.0), (Axis::C, 45.0)], line(Feed::PerMinute(100.0)))]);
    assert!(is_near(stats.total().cutting, 50.0) && is_near(stats.time(), 30.0), "{stats:?}");
    // Beside a linear axis they do not count.
    let both = to(&[(Axis::X, 10.0), (Axis::C, 45.0)], line(Feed::PerMinute(100.0)));
    assert!(is_near(counted(AT_ONCE, &from, &[], &[both]).total().cutting, 10.0));
}

#[test]
fn feeds_become_speeds() {
    let from = [(Axis::X, 20.0), (Axis::Y, 0.0), (Axis::Z, 0.0)];
    let seconds = |functions: &[Function], path: Path| {
        let stats = counted(AT_ONCE, &from, functions, &[to(&[(Axis::Z, -10.0)], path)]);
        assert!(is_near(stats.total().cutting, 10.0), "{stats:?}");
        (stats.untimed_moves == 0).then_some(stats.time())
    };
    let is = |seconds: Option<f64>, wanted: f64| seconds.is_some_and(|seconds| is_near(seconds, wanted));
    assert!(is(seconds(&[], line(Feed::PerMinute(100.0))), 6.0));
    // Three moves a minute.
    assert!(is(seconds(&[], line(Feed::InverseTime(3.0))), 20.0));
    // 40 mm of a contour at 100 mm/min, however far the axes go for it.
    assert!(is(seconds(&[], Path::Carried { feed: 100.0, length: 40.0 }), 24.0));
    // 500 turns a minute of 0.2 mm, and a thread of 2 mm.
    let speed = Function::Spindle(Spindle::Speed(500.0));
    assert!(is(seconds(std::slice::from_ref(&speed), line(Feed::PerRevolution(0.2))), 6.0));
    assert!(is(seconds(std::slice::from_ref(&speed), Path::Thread { lead: 2.0 }), 0.6));
    assert_eq!(seconds(&[], line(Feed::PerRevolution(0.2))), None);
    // 40 pi m/min on a diameter of 40 mm are 1000 turns a minute, but 500 where that is the limit.
    let surface = |limit| Function::Spindle(Spindle::CuttingSpeed { speed: 40.0 * PI, limit });
    assert!(is(seconds(&[surface(None)], line(Feed::PerRevolution(0.2))), 3.0));
    assert!(is(seconds(&[surface(Some(500.0))], line(Feed::PerRevolution(0.2))), 6.0));
    assert!(is(seconds(&[surface(Some(2000.0))], line(Feed::PerRevolution(0.2))), 3.0));
    // From radius 5 to 50 the spindle slows down: 45 mm of a mean circumference of 55·pi, either way.
    let face = |from: f64, to_x: f64, limit| {
        let from = [(Axis::X, from), (Axis::Y, 0.0), (Axis::Z, 0.0)];
        let functions = [Function::Spindle(Spindle::CuttingSpeed { speed: 200.0, limit })];
        counted(AT_ONCE, &from, &functions, &[to(&[(Axis::X, to_x)], line(Feed::PerRevolution(0.2)))]).time()
    };
    let expected = 45.0 * PI * 55.0 / (200.0 * 1000.0 / 60.0 * 0.2);
    assert!(is_near(face(5.0, 50.0, None), expected), "{}", face(5.0, 50.0, None));
    assert!(is_near(face(50.0, 5.0, None), expected));
    // Through the centre, and at the limit of 100 / (40 pi) turns up to radius 20: 20 mm there, and a mean of 25 mm for the others.
    let limit = Some(200_000.0 / (40.0 * PI));
    let part = |way: f64, radius: f64| way * 2.0 * PI * radius / (200.0 * 1000.0 / 60.0 * 0.2);
    assert!(is_near(face(-10.0, 30.0, limit), part(30.0, 20.0) + part(10.0, 25.0)), "{}", face(-10.0, 30.0, limit));
    // A speed behind it holds again.
    assert!(is(seconds(&[surface(None), speed], line(Feed::PerRevolution(0.2))), 6.0));
}

#[test]
fn moves_in_one_direction_are_passed_without_a_stop() {
    let from = [(Axis::X, 0.0), (Axis::Y, 0.0), (Axis::Z, 0.0)];
    // 1 m/s²; 100 mm/s.
    let model = Model { rapid: 6000.0, acceleration: 1.0, tool_change: 4.0 };
    let feed = line(Feed::PerMinute(6000.0));
    let time = |moves: &[Move]| counted(model, &from, &[], moves).time();
    // 200 mm: 0.1 s to speed up, 0.1 s to slow down, 190 mm at 100 mm/s.
    let straight = [to(&[(Axis::X, 100.0)], feed), to(&[(Axis::X, 200.0)], feed)];
    assert!(is_near(time(&straight), 2.1));
    // Each from rest to rest.
    let around = [to(&[(Axis::X, 100.0)], feed), to(&[(Axis::Y, 100.0)], feed)];
    assert!(is_near(time(&around), 2.2));
    // Where a move is passed to a slower one, it slows down to that: 100 to 50 mm/s take 3.75 mm and 0.05 s.
    let slower = [to(&[(Axis::X, 100.0)], feed), to(&[(Axis::X, 150.0)], line(Feed::PerMinute(3000.0)))];
    let first = 0.15 + (100.0 - 5.0 - 3.75) / 100.0;
    assert!(is_near(time(&slower), first + 0.05 + (50.0 - 1.25) / 50.0));
    // From rest over 1.25 mm no more than 50 mm/s are reached, as high as the feed may be.
    let short = [to(&[(Axis::X, 1.25)], feed), to(&[(Axis::X, 101.25)], feed)];
    assert!(is_near(time(&short), 0.05 + 0.15 + (100.0 - 3.75 - 5.0) / 100.0));
}

#[test]
fn tools_have_the_ways_that_they_go() {
    let change = |number| Function::ToolChange { number };
    let mut counter = Counter::new(AT_ONCE);
    counter.begins_at(&place(&[(Axis::X, 0.0), (Axis::Y, 0.0), (Axis::Z, 0.0)]));
    let origin = Origin::default();
    for (number, x, path) in
        [(5, 100.0, Path::Rapid), (7, 130.0, line(Feed::PerMinute(600.0))), (5, 100.0, line(Feed::PerMinute(300.0)))]
    {
        counter.function(&change(number), &origin);
        counter.movement(&to(&[(Axis::X, x)], path), &origin);
    }
    counter.function(&Function::Dwell(1.5), &origin);
    // One that never moves is in the list, too.
    counter.function(&change(9), &origin);
    let stats = counter.finish();
    let numbers: Vec<_> = stats.tools.iter().map(|tool| (tool.number, tool.changes, tool.figures.moves)).collect();
    assert_eq!(numbers, [(Some(5), 2, 2), (Some(7), 1, 1), (Some(9), 1, 0)]);
    let (five, seven) = (stats.tools[0].figures, stats.tools[1].figures);
    assert!(is_near(five.rapid, 100.0) && is_near(five.rapid_time, 1.0), "{five:?}");
    assert!(is_near(five.cutting, 30.0) && is_near(five.cutting_time, 6.0), "{five:?}");
    assert!(is_near(seven.cutting, 30.0) && is_near(seven.cutting_time, 3.0), "{seven:?}");
    let all = stats.total();
    assert!(is_near(all.cutting, 60.0) && is_near(all.rapid, 100.0) && all.moves == 3, "{all:?}");
    assert!(is_near(all.cutting_time, 9.0) && is_near(all.rapid_time, 1.0), "{all:?}");
    // 1 s and 9 s of ways, four changes of 4 s, a dwell.
    assert!(is_near(stats.time(), 27.5));
}

#[test]
fn a_way_that_goes_nowhere_is_a_move_of_no_time() {
    let from = [(Axis::X, 0.0), (Axis::Y, 0.0), (Axis::Z, 0.0)];
    let stats = counted(AT_ONCE, &from, &[], &[to(&[(Axis::X, 0.0)], line(Feed::PerMinute(100.0)))]);
    assert_eq!((stats.total().moves, stats.total().cutting, stats.time()), (1, 0.0, 0.0));
    // What is not known has neither.
    let unknown = counted(AT_ONCE, &from[..2], &[], &[to(&[(Axis::Z, 1.0)], Path::Rapid)]);
    assert_eq!((unknown.unknown_moves, unknown.total().moves), (1, 0));
}

/// A plane that stands upright in front of the part: its Y lies along Z, its Z along -Y.
#[test]
fn extents_of_a_tilted_plane_are_those_of_the_workpiece() {
    use crate::geo::rotation::spatial;
    use crate::ir::Tilting;
    use crate::ir::tilt::{Solution, Tilt};
    use crate::ir::workpiece::InWorkpiece;

    let plane = Tilt { axes: spatial([90.0, 0.0, 0.0]), origin: [0.0, 20.0, 0.0].into(), solution: Solution::Control };
    let mut counter = Counter::new(AT_ONCE);
    let mut seen = InWorkpiece::new(&mut counter);
    seen.function(&Function::Tilt(Box::new(Tilting::Into(plane))), &Origin::default());
    for y in [10.0, 40.0] {
        let end = [(Axis::X, 1.0), (Axis::Y, y), (Axis::Z, -3.0)];
        seen.movement(&to(&end, line(Feed::PerMinute(600.0))), &Origin::default());
    }
    let stats = counter.finish();
    let extents: Vec<(Axis, (f64, f64))> = stats.extents.into_iter().collect();
    assert_eq!(extents, [(Axis::X, (1.0, 1.0)), (Axis::Y, (23.0, 23.0)), (Axis::Z, (10.0, 40.0))]);
}
