//! Contours that are described: what comes back is what would be travelled, and nothing else happens.

use std::rc::Rc;

use partc::internals::diag::Diags;
use partc::internals::geo::{Element, Plane, Point2};
use partc::internals::ir::captured::{Captured, CapturedKind, Unfit};
use partc::internals::ir::contour::{
    ArcChamfer, Blocks, Coords, Corner, CornerShape, Ctx, CtxRef, LargeCorner, Move, Path, Sink,
};
use partc::internals::ir::undercut::{Undercut, form_f};
use partc::internals::ir::{Feed, Function, Origin, Pos, Side, motion};
use partc::internals::lower::Lower;
use partc::internals::machine::{Axis, Machine, MachineKind, Undercuts};

#[derive(Default)]
struct Travelled(Vec<motion::Move>);

impl motion::Sink for Travelled {
    fn movement(&mut self, mv: &motion::Move, _: &Origin) {
        self.0.push(*mv);
    }

    fn function(&mut self, _: &Function, _: &Origin) {}
    fn lost(&mut self, _: &Origin) {}
}

fn machine() -> Machine {
    Machine { kind: MachineKind::Lathe, diameter_axis: Some(Axis::X), ..Machine::default() }
}

fn ctx(plane: Plane) -> CtxRef {
    Rc::new(Ctx { plane, ..Ctx::default() })
}

fn line(z: f64, x: f64) -> Move {
    let mut end = Pos::UNKNOWN;
    end.set(Axis::Z, z);
    end.set(Axis::X, x);
    let path = Path::Line(Feed::PerRevolution(0.2));
    Move { end, path, side: Side::None, coords: Coords::Frame }
}

/// A shaft with an undercut, a rounding and a chamfer.
fn shaft(out: &mut dyn Sink, ctx: &CtxRef) {
    let origin = Origin::default();
    let size = *Undercuts::default().size(0.6, 0.3).expect("a size");
    let corner = |shape| Corner {
        shape,
        feed: None,
        early: true,
        modal: false,
        large: LargeCorner::Refuse,
        at_arc: ArcChamfer::Refuse,
        blocks: Blocks::PassedOver,
    };
    out.movement(&Move { path: Path::Rapid, ..line(0.0, 10.0) }, ctx, &origin);
    out.movement(&line(-20.0, 10.0), ctx, &origin);
    out.corner(&corner(CornerShape::Undercut(Undercut::new(form_f(&size)))), ctx, &origin);
    out.movement(&line(-20.0, 20.0), ctx, &origin);
    out.corner(&corner(CornerShape::Rounding { radius: 2.0 }), ctx, &origin);
    out.movement(&line(-40.0, 20.0), ctx, &origin);
    out.corner(&corner(CornerShape::Chamfer { side: 1.0 }), ctx, &origin);
    out.movement(&line(-40.0, 30.0), ctx, &origin);
}

/// Describes what `blocks` sends, behind a move to Z5 X50.
fn describe(limit: usize, blocks: impl Fn(&mut dyn Sink)) -> (Result<Captured, Unfit>, Vec<motion::Move>) {
    let (diags, machine, mut out) = (Diags::default(), machine(), Travelled::default());
    let (ctx, origin) = (ctx(Plane::Zx), Origin::default());
    let mut lower = Lower::new(&diags, &machine, &mut out);
    lower.movement(&line(5.0, 50.0), &ctx, &origin);
    lower.contour_begins(limit, &ctx, &origin);
    blocks(&mut lower);
    let made = lower.contour_ends(&origin);
    lower.movement(&line(6.0, 60.0), &ctx, &origin);
    lower.finish();
    (made, out.0)
}

#[test]
fn a_described_contour_is_what_would_be_travelled() {
    let (diags, machine, mut out) = (Diags::default(), machine(), Travelled::default());
    let mut lower = Lower::new(&diags, &machine, &mut out);
    shaft(&mut lower, &ctx(Plane::Zx));
    lower.finish();
    let (made, around) = describe(100, |out| shaft(out, &ctx(Plane::Zx)));
    let made = made.expect("a contour");
    assert_eq!((made.plane, made.start), (Plane::Zx, Point2::new(0.0, 10.0)));
    assert_eq!(made.pieces.len(), out.0.len() - 1);
    let mut at = made.start;
    for (piece, mv) in made.pieces.iter().zip(out.0.iter().skip(1)) {
        assert_eq!((piece.element.from(), Some(piece.element.to())), (at, mv.end.in_plane(Plane::Zx)));
        assert_eq!(piece.kind, CapturedKind::Cut);
        match (piece.element, &mv.path) {
            (Element::Line { .. }, motion::Path::Line(_)) => {}
            (Element::Arc { center, sweep, .. }, motion::Path::Arc(arc, _)) => {
                assert_eq!((center, sweep), (arc.center, arc.sweep));
            }
            other => panic!("{other:?}"),
        }
        at = piece.element.to();
    }
    // Only the moves around it are travelled.
    let ends: Vec<_> = around.iter().map(|mv| mv.end.in_plane(Plane::Zx)).collect();
    assert_eq!(ends, [Some(Point2::new(5.0, 50.0)), Some(Point2::new(6.0, 60.0))]);
}

#[test]
fn what_is_no_contour_has_its_reason() {
    let origin = Origin::default();
    let fails = |limit, blocks: &dyn Fn(&mut dyn Sink)| describe(limit, blocks).0.expect_err("no contour");
    let zx = ctx(Plane::Zx);
    assert_eq!(fails(100, &|_| ()), Unfit::NoStart(origin));
    assert_eq!(fails(5, &|out| shaft(out, &zx)), Unfit::TooMany(origin));
    let half = |out: &mut dyn Sink| {
        let mut end = Pos::UNKNOWN;
        end.set(Axis::Z, 1.0);
        out.movement(&Move { end, ..line(0.0, 0.0) }, &zx, &origin);
    };
    assert_eq!(fails(100, &half), Unfit::NoStart(origin));
    let other_plane = |out: &mut dyn Sink| {
        shaft(out, &zx);
        out.movement(&line(-50.0, 30.0), &ctx(Plane::Xy), &origin);
    };
    assert_eq!(fails(100, &other_plane), Unfit::Plane(origin));
    let sideways = |out: &mut dyn Sink| {
        shaft(out, &zx);
        let mut end = Pos::UNKNOWN;
        end.set(Axis::Y, 1.0);
        out.movement(&Move { end, ..line(0.0, 0.0) }, &zx, &origin);
    };
    assert_eq!(fails(100, &sideways), Unfit::Leaves(origin));
    let machine = |out: &mut dyn Sink| {
        shaft(out, &zx);
        out.movement(&Move { coords: Coords::Machine, ..line(0.0, 0.0) }, &zx, &origin);
    };
    assert_eq!(fails(100, &machine), Unfit::Leaves(origin));
    let lost = |out: &mut dyn Sink| {
        shaft(out, &zx);
        out.lost(&zx, &origin);
    };
    assert_eq!(fails(100, &lost), Unfit::Reported);
}
