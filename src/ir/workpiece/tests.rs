use nalgebra::{Matrix3, Vector3};
use proptest::prelude::*;

use super::*;
use crate::geo::rotation::spatial;
use crate::geo::{Plane, Point2, distance, turned};
use crate::ir::function::{Coolant, Turn};
use crate::ir::motion::Arc;
use crate::ir::tap::Stroke;
use crate::ir::tilt::Solution;
use crate::ir::{Feed, Side, Tilt, Tilting, verify};
use crate::machine::axis::{Axis, AxisSet};

/// What a sink was given.
#[derive(Debug, Clone, PartialEq)]
enum Item {
    Move(Move),
    Tap(Tap, Place),
    Function(Function),
    Lost,
    Programmed(Move, Pos),
    BeginsAt(Pos),
}

#[derive(Debug, Default)]
struct Paper(Vec<Item>);

impl Sink for Paper {
    fn movement(&mut self, mv: &Move, _: &Origin) {
        self.0.push(Item::Move(*mv));
    }
    fn tap(&mut self, tap: &Tap, place: &Place, _: &Origin) {
        self.0.push(Item::Tap(tap.clone(), *place));
    }
    fn function(&mut self, function: &Function, _: &Origin) {
        self.0.push(Item::Function(function.clone()));
    }
    fn lost(&mut self, _: &Origin) {
        self.0.push(Item::Lost);
    }
    fn programmed(&mut self, mv: &Move, start: &Pos) {
        self.0.push(Item::Programmed(*mv, *start));
    }
    fn begins_at(&mut self, at: &Pos) {
        self.0.push(Item::BeginsAt(*at));
    }
}

impl Item {
    fn give(&self, sink: &mut dyn Sink) {
        let origin = Origin::default();
        match self {
            Item::Move(mv) => sink.movement(mv, &origin),
            Item::Tap(tap, place) => sink.tap(tap, place, &origin),
            Item::Function(function) => sink.function(function, &origin),
            Item::Lost => sink.lost(&origin),
            Item::Programmed(mv, start) => sink.programmed(mv, start),
            Item::BeginsAt(at) => sink.begins_at(at),
        }
    }
}

/// What comes out behind the function that tilts the plane. Both sides keep the promises of the stream.
fn seen(tilt: Tilt, items: &[Item]) -> Vec<Item> {
    let mut paper = Paper::default();
    {
        let mut after = verify::Motion::new(&mut paper);
        let mut adaptor = InWorkpiece::new(&mut after);
        let mut before = verify::Motion::new(&mut adaptor);
        before.function(&Function::Tilt(Box::new(Tilting::Into(tilt))), &Origin::default());
        items.iter().for_each(|item| item.give(&mut before));
    }
    assert_eq!(paper.0.remove(0), Item::Function(Function::Tilt(Box::new(Tilting::Into(tilt)))));
    paper.0
}

fn tilt(angles: [f64; 3], origin: [f64; 3]) -> Tilt {
    Tilt { axes: spatial(angles), origin: Vector3::from(origin), solution: Solution::default() }
}

fn at(place: [f64; 3]) -> Pos {
    Pos::of_main(place, AxisSet::MAIN)
}

/// X and Y, and not Z.
fn in_xy(x: f64, y: f64) -> Pos {
    let mut pos = Pos::UNKNOWN;
    pos.set(Axis::X, x);
    pos.set(Axis::Y, y);
    pos
}

fn vector(pos: &Pos) -> Vector3<f64> {
    Vector3::from([Axis::X, Axis::Y, Axis::Z].map(|axis| pos.get(axis).expect("a known axis")))
}

const FEED: Feed = Feed::PerMinute(300.0);

fn straight(end: Pos, axes: AxisSet, path: Path) -> Item {
    Item::Move(Move { end, axes, path, ..Move::default() })
}

fn line(place: [f64; 3]) -> Item {
    straight(at(place), AxisSet::MAIN, Path::Line(FEED))
}

/// An arc in `plane` from a place on; `rise` along the third axis makes a helix.
fn arc(from: [f64; 3], plane: Plane, center: Point2, sweep: f64, rise: f64, feed: Feed) -> Item {
    let start = at(from);
    let (first, second, third) = plane.axes();
    let begin = Point2::new(from[first], from[second]);
    let mut end = start;
    end.set_in_plane(plane, center + turned(begin - center, sweep));
    end.set(Axis::ALL[third], from[third] + rise);
    let mut axes = AxisSet::of(Axis::ALL[first]).union(AxisSet::of(Axis::ALL[second]));
    if rise != 0.0 {
        axes.insert(Axis::ALL[third]);
    }
    let path = Path::Arc(Arc { plane, from: begin, center, sweep }, feed);
    Item::Move(Move { end, axes, path, plane, ..Move::default() })
}

fn tap(axis: Axis) -> Tap {
    Tap {
        axis,
        start: 2.0,
        surface: 0.0,
        strokes: vec![Stroke { to: -10.0, back: 2.0, dwell: 0.5 }],
        lead: 1.5,
        turn: Turn::Clockwise,
        speed_in: None,
        speed_out: None,
        orient: None,
        pause: 0.0,
        again: None,
    }
}

fn moves(items: &[Item]) -> Vec<Move> {
    items.iter().filter_map(|item| if let Item::Move(mv) = item { Some(*mv) } else { None }).collect()
}

/// Far below what any output shows; coordinates up to a metre have 13 digits of it.
const SAME: f64 = 1e-9;

#[test]
fn a_plane_on_the_right_side_is_seen_from_there() {
    // Y of the plane lies along Z, its Z along -Y: the front side of a block, seen from the front.
    let front = tilt([90.0, 0.0, 0.0], [10.0, 0.0, -5.0]);
    let quarter = core::f64::consts::FRAC_PI_2;
    let given = [line([1.0, 2.0, 3.0]), arc([1.0, 2.0, 3.0], Plane::Xy, Point2::new(0.0, 2.0), quarter, -1.0, FEED)];
    let out = moves(&seen(front, &given));
    assert_eq!((out.len(), out[0].plane), (2, Plane::Zx));
    assert_eq!(vector(&out[0].end), Vector3::new(11.0, -3.0, -3.0));
    let Path::Arc(turned, _) = out[1].path else { panic!("{:?}", out[1]) };
    // Seen against -Y the arc goes to the left; seen against +Y, as G18 counts, to the right.
    assert_eq!(
        (turned.plane, turned.from, turned.center),
        (Plane::Zx, Point2::new(-3.0, 11.0), Point2::new(-3.0, 10.0))
    );
    assert_eq!(turned.sweep, -quarter);
    assert!((vector(&out[1].end) - Vector3::new(10.0, -2.0, -2.0)).norm() < SAME);
    assert_eq!(out[1].axes, AxisSet::MAIN);
}

#[test]
fn axes_move_with_those_of_the_plane() {
    let aside = tilt([30.0, 0.0, 0.0], [0.0; 3]);
    let up = straight(at([1.0, 2.0, 9.0]), AxisSet::of(Axis::Z), Path::Rapid);
    let out = moves(&seen(aside, &[line([1.0, 2.0, 3.0]), up]));
    let mut yz = AxisSet::of(Axis::Y);
    yz.insert(Axis::Z);
    assert_eq!([out[0].axes, out[1].axes], [AxisSet::MAIN, yz]);
}

#[test]
fn what_depends_on_an_unknown_axis_is_unknown() {
    let aside = tilt([30.0, 0.0, 0.0], [0.0; 3]);
    // Z of the plane is not known, so X of the workpiece is all there is.
    let y_only = straight(in_xy(1.0, 7.0), AxisSet::of(Axis::Y), Path::Rapid);
    let given = [straight(in_xy(1.0, 2.0), AxisSet::of(Axis::X), Path::Rapid), y_only.clone()];
    let x = Pos::of_main([1.0, 0.0, 0.0], AxisSet::of(Axis::X));
    assert_eq!(seen(aside, &given), [straight(x, AxisSet::of(Axis::X), Path::Rapid), Item::Lost]);
    // Where all were known, what was told of Y and Z is taken back first.
    let change = Item::Function(Function::ToolChange { number: 2 });
    let out = seen(
        aside,
        &[line([1.0, 2.0, 3.0]), change.clone(), straight(in_xy(4.0, 2.0), AxisSet::of(Axis::X), Path::Rapid)],
    );
    let x = Pos::of_main([4.0, 0.0, 0.0], AxisSet::of(Axis::X));
    assert_eq!(out[1..], [change, Item::Lost, straight(x, AxisSet::of(Axis::X), Path::Rapid)]);
}

#[test]
fn machine_moves_pass_and_forget_the_rest() {
    let mut end = Pos::UNKNOWN;
    end.set(Axis::Z, 0.0);
    let machine = Item::Move(Move { end, axes: AxisSet::of(Axis::Z), machine: true, ..Move::default() });
    let out = seen(tilt([30.0, 0.0, 0.0], [1.0; 3]), &[line([1.0, 2.0, 3.0]), machine.clone(), line([1.0, 2.0, 3.0])]);
    assert_eq!((&out[1], &out[2], out.len()), (&machine, &Item::Lost, 4));
}

#[test]
fn a_tap_stays_one_along_a_main_axis_only() {
    let place = Place { at: at([5.0, 6.0, 2.0]), plane: Plane::Xy };
    let given = [line([5.0, 6.0, 2.0]), Item::Tap(tap(Axis::Z), place)];
    let out = seen(tilt([90.0, 0.0, 0.0], [0.0, 100.0, 0.0]), &given);
    let Item::Tap(turned, place) = &out[1] else { panic!("{out:?}") };
    assert_eq!((turned.axis, turned.start, turned.end(), turned.bottom()), (Axis::Y, 98.0, 98.0, 110.0));
    assert_eq!((turned.outward(), place.plane), (-1.0, Plane::Zx));
    let out = seen(tilt([0.0, 30.0, 0.0], [0.0; 3]), &given);
    let strokes: Vec<Move> = moves(&out)[1..].to_vec();
    let ends = [-10.0, 2.0].map(|z| spatial([0.0, 30.0, 0.0]) * Vector3::new(5.0, 6.0, z));
    assert!(strokes.iter().zip(ends).all(|(mv, end)| (vector(&mv.end) - end).norm() < SAME), "{strokes:?}");
    assert!(strokes.iter().all(|mv| mv.path == Path::Thread { lead: 1.5 }), "{strokes:?}");
    assert!(out.contains(&Item::Function(Function::Dwell(0.5))) && strokes.len() == 2, "{out:?}");
}

#[test]
fn axes_that_stand_somewhere_are_told_as_far_as_they_are_known() {
    let aside = tilt([30.0, 0.0, 0.0], [0.0; 3]);
    let begins = |pos: Pos| Item::BeginsAt(pos);
    let x = Pos::of_main([1.0, 0.0, 0.0], AxisSet::of(Axis::X));
    let y = Pos::of_main([0.0, 2.0, 0.0], AxisSet::of(Axis::Y));
    assert_eq!(seen(aside, &[begins(y)]), []);
    assert_eq!(seen(aside, &[begins(y), begins(x)]), [begins(x)]);
}

#[test]
fn a_programmed_arc_is_told_piece_by_piece() {
    let given = arc([10.0, 0.0, 0.0], Plane::Xy, Point2::new(0.0, 0.0), 1.0, 0.0, FEED);
    let Item::Move(mv) = given else { panic!() };
    let out = seen(tilt([30.0, 0.0, 0.0], [0.0; 3]), &[Item::Programmed(mv, at([10.0, 0.0, 0.0]))]);
    let mut from = at([10.0, 0.0, 0.0]);
    for item in &out {
        let Item::Programmed(mv, start) = item else { panic!("{item:?}") };
        assert_eq!(*start, from);
        from = mv.end;
    }
    assert!(out.len() > 10, "{}", out.len());
}

#[test]
fn an_arc_of_very_many_turns_ends() {
    let turns = 3_000_000.0 * core::f64::consts::TAU;
    let given = arc([50.0, 0.0, 0.0], Plane::Xy, Point2::new(0.0, 0.0), -turns, -10.0, FEED);
    let out = moves(&seen(tilt([30.0, 0.0, 0.0], [0.0; 3]), &[line([50.0, 0.0, 0.0]), given]));
    assert!((30_000..70_000).contains(&out.len()), "{}", out.len());
}

#[test]
fn chords_take_the_time_of_the_arc() {
    let given = arc([50.0, 0.0, 0.0], Plane::Xy, Point2::new(0.0, 0.0), 1.0, 0.0, Feed::InverseTime(2.0));
    let out = moves(&seen(tilt([30.0, 0.0, 0.0], [0.0; 3]), &[line([50.0, 0.0, 0.0]), given]));
    let count = (out.len() - 1) as f64;
    assert!(out[1..].iter().all(|mv| mv.path == Path::Line(Feed::InverseTime(2.0 * count))), "{count}");
}

#[test]
fn without_a_plane_items_pass() {
    let mut paper = Paper::default();
    let mut adaptor = InWorkpiece::new(&mut paper);
    let aside = Tilting::Into(tilt([30.0, 0.0, 0.0], [0.0; 3]));
    for tilting in [aside, Tilting::Off, aside, Tilting::Back(Solution::Control)] {
        adaptor.function(&Function::Tilt(Box::new(tilting)), &Origin::default());
    }
    line([1.0, 2.0, 3.0]).give(&mut adaptor);
    assert_eq!(paper.0.pop(), Some(line([1.0, 2.0, 3.0])));
}

fn angle() -> impl Strategy<Value = f64> {
    prop_oneof![-360.0f64..360.0, (-4i32..=4).prop_map(|n| f64::from(n) * 90.0)]
}

fn angles() -> impl Strategy<Value = [f64; 3]> {
    [angle(), angle(), angle()]
}

fn place() -> impl Strategy<Value = [f64; 3]> {
    [-500.0f64..500.0, -500.0f64..500.0, -500.0f64..500.0]
}

fn plane() -> impl Strategy<Value = Plane> {
    prop_oneof![Just(Plane::Xy), Just(Plane::Zx), Just(Plane::Yz)]
}

/// How far `p` of the plane lies from the cylinder of the arc, or from the height that it has there.
fn off_helix(p: Vector3<f64>, item: &Item, from: [f64; 3], share: f64) -> f64 {
    let Item::Move(Move { path: Path::Arc(arc, _), end, .. }) = item else { panic!("{item:?}") };
    let (first, second, third) = arc.plane.axes();
    let flat = (distance(Point2::new(p[first], p[second]), arc.center) - distance(arc.from, arc.center)).abs();
    let height = from[third] + (end.values()[third] - from[third]) * share;
    flat.max((p[third] - height).abs())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn points_are_origin_and_axes(angles in angles(), origin in place(), places in prop::collection::vec(place(), 1..5)) {
        let tilt = tilt(angles, origin);
        let given: Vec<Item> = places.iter().map(|place| line(*place)).collect();
        let out = moves(&seen(tilt, &given));
        prop_assert_eq!(out.len(), places.len());
        for (mv, place) in out.iter().zip(&places) {
            let due = tilt.origin + tilt.axes * Vector3::from(*place);
            prop_assert!((vector(&mv.end) - due).norm() < SAME, "{:?} {due}", mv);
            prop_assert_eq!((mv.axes, mv.path), (AxisSet::MAIN, Path::Line(FEED)));
        }
    }

    #[test]
    fn arcs_lie_on_their_circle_in_space(
        angles in angles(), origin in place(), from in place(), plane in plane(),
        radius in 0.002f64..400.0, towards in 0.0f64..6.3, sweep in -15.0f64..15.0, rise in prop_oneof![Just(0.0), -30.0f64..30.0],
    ) {
        prop_assume!(sweep.abs() > 1e-3);
        let tilt = tilt(angles, origin);
        let (first, second, third) = plane.axes();
        let begin = Point2::new(from[first], from[second]);
        let center = begin + turned(crate::geo::Vec2::new(radius, 0.0), towards);
        let given = arc(from, plane, center, sweep, rise, FEED);
        let Item::Move(meant) = given.clone() else { panic!() };
        let out = moves(&seen(tilt, &[line(from), given.clone()]));
        let local = |p: Vector3<f64>| tilt.axes.transpose() * (p - tilt.origin);
        let (mut start, pieces) = (vector(&out[0].end), &out[1..]);
        let main = (0..3).any(|i| tilt.axes[(i, third)].abs() > 1.0 - 1e-12);
        prop_assert_eq!(pieces.len() == 1 && matches!(pieces[0].path, Path::Arc(..)), main, "{:?}", pieces);
        for (n, piece) in pieces.iter().enumerate() {
            let end = vector(&piece.end);
            for step in 0..=8 {
                let t = f64::from(step) / 8.0;
                let (p, tolerance) = match &piece.path {
                    Path::Arc(arc, _) => {
                        let (_, _, third) = arc.plane.axes();
                        let mut at = piece.end;
                        at.set_in_plane(arc.plane, arc.center + turned(arc.from - arc.center, arc.sweep * t));
                        at.set(Axis::ALL[third], start[third] + (end[third] - start[third]) * t);
                        (vector(&at), SAME)
                    }
                    _ => (start + (end - start) * t, TOLERANCE + SAME),
                };
                let share = (n as f64 + t) / pieces.len() as f64;
                let off = off_helix(local(p), &given, from, share);
                prop_assert!(off <= tolerance, "{off} at {share} of {}", pieces.len());
                // The same way round.
                let due = arc_at(&meant, from, share);
                prop_assert!((local(p) - due).norm() <= 2.0 * tolerance, "{} {due} at {share}", local(p));
            }
            start = end;
        }
        let due = tilt.origin + tilt.axes * vector(&meant.end);
        prop_assert!((start - due).norm() < SAME, "{start} {due}");
    }

    /// Without the short cut for the plane of the workpiece: the same items, bit by bit.
    #[test]
    fn the_plane_of_the_workpiece_changes_no_item(from in place(), to in place(), plane in plane(), sweep in 0.1f64..9.0) {
        let own = Tilt { axes: Matrix3::identity(), origin: Vector3::zeros(), solution: Solution::Control };
        let (first, second, _) = plane.axes();
        let center = Point2::new(from[first] + 3.0, from[second] - 4.0);
        let curve = arc(from, plane, center, sweep, 1.0, FEED);
        let Item::Move(Move { end, .. }) = curve else { panic!() };
        let mut hole = tap(Axis::Z);
        hole.start = end.values()[2];
        hole.strokes = vec![Stroke { to: hole.start - 9.0, back: hole.start, dwell: 0.0 }];
        let spindle = Item::Function(Function::Coolant(Coolant::Flood));
        let tapped = Item::Tap(hole, Place { at: end, plane });
        let given = [Item::BeginsAt(in_xy(from[0], from[1])), line(from), curve, tapped, spindle, line(to), Item::Lost, line(from)];
        prop_assert_eq!(&seen(own, &given), &given);
        let mut tilted = tilted::Tilted::of_any(&own);
        for item in &given {
            match item {
                Item::Move(mv) => tilted.movement(mv, &mut |given| assert_eq!(given, Some(mv))),
                Item::Tap(tap, place) => {
                    let given = tilted.tap(tap, place, &mut || panic!("lost"));
                    prop_assert_eq!(given, Some((tap.clone(), *place)));
                }
                Item::BeginsAt(at) => prop_assert_eq!(tilted.begins_at(at), *at),
                Item::Lost => tilted.lost(),
                Item::Function(_) | Item::Programmed(..) => {}
            }
        }
    }

    /// Only some axes are known, some are lost again, and the stream still keeps what it promises.
    #[test]
    fn streams_of_which_little_is_known_keep_their_promises(
        angles in angles(), origin in place(), steps in prop::collection::vec((0u8..8, place(), 1u8..8), 1..12),
    ) {
        let mut known = Pos::UNKNOWN;
        let mut given = Vec::new();
        for (kind, place, which) in steps {
            let axes = AxisSet::MAIN.iter().filter(|axis| which >> axis.index() & 1 == 1);
            let axes = axes.fold(AxisSet::EMPTY, |all, axis| all.union(AxisSet::of(axis)));
            let step = Pos::of_main(place, axes);
            given.push(match kind {
                0 => {
                    known.clear();
                    Item::Lost
                }
                1 => {
                    known.forget(Axis::Z);
                    Item::Function(Function::ToolChange { number: 1 })
                }
                2 => {
                    known.clear();
                    Item::Move(Move { end: step, axes, machine: true, ..Move::default() })
                }
                _ => {
                    known.update(&step);
                    straight(known, axes, Path::Line(FEED))
                }
            });
        }
        let out = seen(tilt(angles, origin), &given);
        prop_assert!(out.iter().all(|item| !matches!(item, Item::Move(mv) if mv.axes.is_empty())));
    }
}

/// A place of a helix in the plane.
fn arc_at(mv: &Move, from: [f64; 3], share: f64) -> Vector3<f64> {
    let Path::Arc(arc, _) = &mv.path else { panic!("{mv:?}") };
    let (_, _, third) = arc.plane.axes();
    let mut at = Pos::of_main(from, AxisSet::MAIN);
    at.set_in_plane(arc.plane, arc.center + turned(arc.from - arc.center, arc.sweep * share));
    at.set(Axis::ALL[third], from[third] + (mv.end.values()[third] - from[third]) * share);
    vector(&at)
}

#[test]
fn the_side_and_the_working_plane_go_along() {
    let given = Move { end: at([1.0, 2.0, 3.0]), axes: AxisSet::MAIN, side: Side::Left, ..Move::default() };
    let out = moves(&seen(tilt([30.0, 0.0, 0.0], [0.0; 3]), &[Item::Move(given)]));
    assert_eq!((out[0].side, out[0].plane), (Side::Left, Plane::Xy));
}
