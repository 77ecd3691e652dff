//! Streams that must be caught, one for each promise, beside one that keeps all of them.

use core::f64::consts::{FRAC_PI_2, TAU};
use std::rc::Rc;

use super::contour::Check;
use super::motion::element;
use super::{Chain, Fault};
use crate::geo::{Deg, Plane, Point2};
use crate::ir::contour::{
    self, ArcChamfer, ArcShape, Blocks, Coords, Corner, CornerShape, Ctx, CtxRef, LargeCorner, Thread,
};
use crate::ir::function::Spindle;
use crate::ir::motion::{Arc, Move, Path};
use crate::ir::{Feed, Frame, Function, Pos, Side};
use crate::machine::axis::{AXES, Axis, AxisSet};

const F: Feed = Feed::PerMinute(100.0);

fn pos(x: f64, y: f64) -> Pos {
    let mut pos = Pos::UNKNOWN;
    pos.set(Axis::X, x);
    pos.set(Axis::Y, y);
    pos
}

fn line(x: f64, y: f64) -> Move {
    let end = pos(x, y);
    Move { end, axes: end.known(), path: Path::Line(F), ..Move::default() }
}

/// A quarter turn about the origin from (10, 0) to (0, 10).
fn quarter() -> Arc {
    Arc { plane: Plane::Xy, from: Point2::new(10.0, 0.0), center: Point2::origin(), sweep: FRAC_PI_2 }
}

fn arc(arc: Arc, x: f64, y: f64) -> Move {
    Move { path: Path::Arc(arc, F), ..line(x, y) }
}

fn fault(mv: &Move) -> Option<Fault> {
    element(&pos(10.0, 0.0), mv).err()
}

#[test]
fn moves_that_keep_all_promises_pass() {
    let mut chain = Chain::default();
    let quarters = Arc { sweep: FRAC_PI_2 + 3.0 * TAU, ..quarter() };
    let back = Arc { from: Point2::new(0.0, 10.0), sweep: -FRAC_PI_2, ..quarter() };
    for mv in [line(10.0, 0.0), arc(quarters, 0.0, 10.0), arc(back, 10.0, 0.0)] {
        assert_eq!(chain.follow(&mv), Ok(()), "{mv:?}");
    }
    // X stays where it was without being named.
    let up = Move { axes: AxisSet::of(Axis::Y), ..line(10.0, 5.0) };
    assert_eq!(chain.follow(&up), Ok(()));
}

#[test]
fn every_broken_promise_of_a_move_is_caught() {
    let with = |path| Move { path, ..line(1.0, 1.0) };
    assert_eq!(fault(&line(f64::NAN, 0.0)), Some(Fault::NotFinite));
    assert_eq!(fault(&line(f64::INFINITY, 0.0)), Some(Fault::NotFinite));
    assert_eq!(fault(&Move { axes: AxisSet::EMPTY, ..line(10.0, 0.0) }), Some(Fault::NoAxis));
    assert_eq!(fault(&Move { axes: AxisSet::MAIN, ..line(10.0, 0.0) }), Some(Fault::NoEnd(Axis::Z)));
    for zero in [0.0, -1.0] {
        assert_eq!(fault(&with(Path::Line(Feed::PerRevolution(zero)))), Some(Fault::Feed));
        assert_eq!(fault(&with(Path::Thread { lead: zero })), Some(Fault::Lead));
    }
    assert_eq!(fault(&with(Path::Line(Feed::InverseTime(f64::NAN)))), Some(Fault::NotFinite));
    assert_eq!(fault(&with(Path::Thread { lead: f64::INFINITY })), Some(Fault::NotFinite));
    // Named in neither, moved all the same.
    let aside = Move { axes: AxisSet::of(Axis::Y), ..line(11.0, 0.0) };
    assert_eq!(fault(&aside), Some(Fault::Unnamed(Axis::X)));
}

#[test]
fn moves_in_machine_coordinates_are_straight_and_say_nothing_else() {
    let machine = Move { machine: true, ..line(-5.0, -5.0) };
    assert_eq!(fault(&machine), None);
    let turned = Move { machine: true, ..arc(quarter(), 0.0, 10.0) };
    assert_eq!(fault(&turned), Some(Fault::Machine));
    let more = Move { axes: AxisSet::of(Axis::X), ..machine };
    assert_eq!(fault(&more), Some(Fault::Machine));
}

#[test]
fn every_broken_promise_of_an_arc_is_caught() {
    let with = |change: fn(&mut Arc)| {
        let mut made = quarter();
        change(&mut made);
        fault(&arc(made, 0.0, 10.0))
    };
    assert_eq!(with(|_| {}), None);
    assert_eq!(with(|a| a.sweep = f64::NAN), Some(Fault::NotFinite));
    assert_eq!(with(|a| a.center.x = f64::INFINITY), Some(Fault::NotFinite));
    assert_eq!(with(|a| a.plane = Plane::Zx), Some(Fault::NotInPlane));
    assert_eq!(with(|a| a.from = Point2::new(10.001, 0.0)), Some(Fault::ArcStart));
    assert_eq!(with(|a| a.center = Point2::new(0.0, 0.1)), Some(Fault::Radius));
    assert_eq!(with(|a| a.sweep = 0.0), Some(Fault::Turns));
    assert_eq!(with(|a| a.sweep = 1e11), Some(Fault::Turns));
    // The right circle, and half a turn too far, the other way round, or a thousandth beside.
    assert_eq!(with(|a| a.sweep = 3.0 * FRAC_PI_2), Some(Fault::Sweep));
    assert_eq!(with(|a| a.sweep = -FRAC_PI_2), Some(Fault::Sweep));
    assert_eq!(with(|a| a.sweep += 1e-4), Some(Fault::Sweep));
    let point = Arc { center: Point2::new(10.0, 0.0), ..quarter() };
    assert_eq!(fault(&arc(point, 10.0, 0.0)), Some(Fault::NoRadius));
    let unnamed = Move { axes: AxisSet::of(Axis::X), ..arc(Arc { sweep: TAU / 2.0, ..quarter() }, -10.0, 0.0) };
    assert_eq!(fault(&unnamed), Some(Fault::NotInPlane));
}

#[test]
fn an_element_starts_where_the_one_before_ended() {
    let mut chain = Chain::default();
    assert_eq!(chain.follow(&line(10.0, 0.0)), Ok(()));
    assert_eq!(chain.take(&pos(10.0, 0.1), &line(0.0, 0.0)), Err(Fault::Gap(Axis::Y)));
    // After a change of the tool, the work offset or a loss the start is open.
    for function in [Function::ToolChange { number: 1 }, Function::WorkOffset(2)] {
        let mut chain = chain.clone();
        chain.function(&function);
        assert_eq!(chain.take(&pos(10.0, 0.1), &line(0.0, 0.0)), Ok(()));
    }
    let mut lost = chain.clone();
    lost.lost();
    assert_eq!(lost.take(&pos(10.0, 0.1), &line(0.0, 0.0)), Ok(()));
    // Coolant moves nothing.
    chain.function(&Function::Stop);
    assert_eq!(chain.take(&pos(10.0, 0.1), &line(0.0, 0.0)), Err(Fault::Gap(Axis::Y)));
    // The arc of a stream that begins elsewhere.
    let mut chain = Chain::default();
    chain.begins_at(&pos(9.0, 0.0));
    assert_eq!(chain.follow(&arc(quarter(), 0.0, 10.0)), Err(Fault::ArcStart));
}

#[test]
fn functions_have_finite_numbers_above_zero() {
    let wrong = [
        Function::Dwell(-1.0),
        Function::Spindle(Spindle::Speed(-1.0)),
        Function::SpindleOf { number: 2, spindle: Spindle::CuttingSpeed { speed: 100.0, limit: Some(-1.0) } },
    ];
    for item in wrong {
        assert_eq!(super::function(&item), Err(Fault::Function), "{item:?}");
    }
    for item in [Function::Dwell(f64::NAN), Function::Spindle(Spindle::Orient(f64::INFINITY))] {
        assert_eq!(super::function(&item), Err(Fault::NotFinite), "{item:?}");
    }
    assert_eq!(super::function(&Function::Spindle(Spindle::Speed(0.0))), Ok(()));
}

fn programmed(path: contour::Path) -> contour::Move {
    contour::Move { end: pos(0.0, 10.0), path, side: Side::None, coords: Coords::Frame }
}

fn circle(shape: ArcShape) -> contour::Path {
    contour::Path::Arc(contour::Arc { plane: Plane::Xy, shape, turns: 0 }, F)
}

/// What the contour stream says to a move from (10, 0).
fn contour_fault(mv: &contour::Move) -> Option<Fault> {
    let (mut check, ctx) = (Check::default(), CtxRef::default());
    let start = contour::Move { end: pos(10.0, 0.0), ..programmed(contour::Path::Rapid) };
    assert_eq!(check.movement(&start, &ctx), Ok(()));
    check.movement(mv, &ctx).err()
}

#[test]
fn every_broken_promise_of_a_programmed_move_is_caught() {
    use contour::Path;
    let of = |path| contour_fault(&programmed(path));
    assert_eq!(of(Path::Line(F)), None);
    assert_eq!(of(Path::Line(Feed::PerMinute(0.0))), Some(Fault::Feed));
    assert_eq!(of(Path::Thread(Thread { lead: 0.0, along: None })), Some(Fault::Lead));
    let nowhere = contour::Move { end: Pos::UNKNOWN, ..programmed(Path::Rapid) };
    assert_eq!(contour_fault(&nowhere), Some(Fault::NoAxis));
    let endless = contour::Move { end: pos(f64::NAN, 0.0), ..programmed(Path::Rapid) };
    assert_eq!(contour_fault(&endless), Some(Fault::NotFinite));
    let thread = Path::Thread(Thread { lead: 1.0, along: None });
    let machine = contour::Move { coords: Coords::Machine, ..programmed(thread) };
    assert_eq!(contour_fault(&machine), Some(Fault::Machine));
}

#[test]
fn every_broken_promise_of_a_programmed_arc_is_caught() {
    let of = |shape| contour_fault(&programmed(circle(shape)));
    let (center, nan) = (Point2::origin(), Point2::new(f64::NAN, 0.0));
    assert_eq!(of(ArcShape::Center { center, ccw: true, tol: 0.01 }), None);
    assert_eq!(of(ArcShape::Center { center: nan, ccw: true, tol: 0.01 }), Some(Fault::NotFinite));
    assert_eq!(of(ArcShape::Center { center, ccw: true, tol: -0.01 }), Some(Fault::Shape));
    assert_eq!(of(ArcShape::Radius { radius: 0.0, ccw: true, tol: 0.01 }), Some(Fault::Shape));
    assert_eq!(of(ArcShape::Via { point: nan }), Some(Fault::NotFinite));
    for sweep in [0.0, 360.0, -400.0] {
        assert_eq!(of(ArcShape::Opening { sweep: Deg(sweep) }), Some(Fault::Shape));
    }
    assert_eq!(of(ArcShape::Sweep { center, sweep: Deg(90.0) }), None);
    assert_eq!(of(ArcShape::Sweep { center, sweep: Deg(90.0 + 7200.0) }), None);
    assert_eq!(of(ArcShape::Sweep { center, sweep: Deg(-90.0) }), Some(Fault::Sweep));
    assert_eq!(of(ArcShape::Sweep { center, sweep: Deg(90.1) }), Some(Fault::Sweep));
    assert_eq!(of(ArcShape::Sweep { center, sweep: Deg(0.0) }), Some(Fault::Turns));
    assert_eq!(of(ArcShape::Sweep { center, sweep: Deg(1e13) }), Some(Fault::Turns));
}

#[test]
fn the_programmed_position_follows_frames_and_losses() {
    let ctx = CtxRef::default();
    let mut shift = [0.0; AXES];
    shift[Axis::Y.index()] = 5.0;
    let frame = Frame::new(nalgebra::Matrix3::identity(), shift).expect("a shift");
    let shifted = Rc::new(Ctx { frame, ..Ctx::default() });
    let mut check = Check::default();
    let start = contour::Move { end: pos(10.0, 0.0), ..programmed(contour::Path::Rapid) };
    assert_eq!(check.movement(&start, &ctx), Ok(()));
    // The tool stands in (10, -5) of the shifted frame.
    let sweep = circle(ArcShape::Sweep { center: Point2::new(0.0, -5.0), sweep: Deg(90.0) });
    let end = contour::Move { end: pos(0.0, 5.0), ..programmed(sweep) };
    assert_eq!(check.movement(&end, &shifted), Ok(()));
    assert_eq!(check.movement(&end, &shifted), Err(Fault::Sweep));
    check.lost(&shifted);
    assert_eq!(check.movement(&end, &shifted), Ok(()));
}

#[test]
fn corners_have_a_size_and_a_feed_above_zero() {
    let of = |shape, feed| {
        let corner = Corner {
            shape,
            feed,
            early: false,
            modal: false,
            large: LargeCorner::Refuse,
            at_arc: ArcChamfer::Refuse,
            blocks: Blocks::PassedOver,
        };
        Check::default().corner(&corner, &CtxRef::default()).err()
    };
    assert_eq!(of(CornerShape::Rounding { radius: 1.0 }, Some(F)), None);
    assert_eq!(of(CornerShape::Rounding { radius: 0.0 }, None), Some(Fault::Corner));
    assert_eq!(of(CornerShape::Chamfer { side: f64::NAN }, None), Some(Fault::NotFinite));
    assert_eq!(of(CornerShape::ChamferLength { length: 1.0 }, Some(Feed::PerMinute(0.0))), Some(Fault::Feed));
}

#[test]
fn descriptions_and_starts_come_in_their_order() {
    let ctx = CtxRef::default();
    let mut check = Check::default();
    assert_eq!(check.contour_ends(), Err(Fault::Description));
    assert_eq!(check.contour_begins(&ctx), Ok(()));
    assert_eq!(check.contour_begins(&ctx), Err(Fault::Description));
    let mut check = Check::default();
    assert_eq!(check.begins_at(&pos(0.0, 0.0)), Ok(()));
    assert_eq!(check.movement(&programmed(contour::Path::Rapid), &ctx), Ok(()));
    assert_eq!(check.begins_at(&pos(0.0, 0.0)), Err(Fault::Late));
}
