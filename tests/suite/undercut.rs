//! Undercuts on their way through lowering: where they are put, and every condition that refuses them.

use std::rc::Rc;

use partc::internals::diag::Diags;
use partc::internals::geo::undercut::{Allowance, Shape};
use partc::internals::geo::{Deg, Plane};
use partc::internals::ir::contour::{
    Arc, ArcChamfer, ArcShape, Blocks, Coords, Corner, CornerShape, Ctx, CtxRef, LargeCorner, Move, Path, Sink,
};
use partc::internals::ir::undercut::{Surface, Undercut, form_e, form_f, thread_by_contour};
use partc::internals::ir::{Feed, Function, Origin, Pos, Side, motion};
use partc::internals::lower::Lower;
use partc::internals::machine::{Axis, Machine, MachineKind, Undercuts};

/// Moves as text: Z and X (radius) of the end, K and I of the centre.
#[derive(Default)]
struct Printed(Vec<String>);

impl motion::Sink for Printed {
    fn movement(&mut self, mv: &motion::Move, _: &Origin) {
        let at = mv.end.in_plane(Plane::Zx).expect("both axes");
        let word = match &mv.path {
            motion::Path::Rapid => "G0".to_owned(),
            motion::Path::Line(_) | motion::Path::Carried { .. } => "G1".to_owned(),
            motion::Path::Thread { .. } => "G33".to_owned(),
            motion::Path::Arc(arc, _) => {
                format!("{} K{:.4} I{:.4}", if arc.sweep > 0.0 { "G3" } else { "G2" }, arc.center.x, arc.center.y)
            }
        };
        let feed = mv.path.feed().map_or(0.0, Feed::value);
        self.0.push(format!("Z{:.4} X{:.4} {word} F{feed}", at.x, at.y));
    }

    fn function(&mut self, _: &Function, _: &Origin) {}
    fn lost(&mut self, _: &Origin) {}
}

fn lathe() -> Machine {
    Machine { kind: MachineKind::Lathe, diameter_axis: Some(Axis::X), ..Machine::default() }
}

fn point(z: f64, x: f64) -> Pos {
    let mut pos = Pos::UNKNOWN;
    pos.set(Axis::Z, z);
    pos.set(Axis::X, x);
    pos
}

fn line(z: f64, x: f64) -> Move {
    let path = Path::Line(Feed::PerRevolution(0.2));
    Move { end: point(z, x), path, side: Side::None, coords: Coords::Frame }
}

fn rapid(z: f64, x: f64) -> Move {
    Move { path: Path::Rapid, ..line(z, x) }
}

/// Lines before the undercut, lines behind it.
fn lower(
    machine: &Machine,
    plane: Plane,
    before: &[Move],
    undercut: Undercut,
    after: &[Move],
) -> (Vec<String>, Vec<&'static str>) {
    let diags = Diags::default();
    let mut out = Printed::default();
    let ctx: CtxRef = Rc::new(Ctx { plane, ..Ctx::default() });
    let origin = Origin::default();
    let mut lower = Lower::new(&diags, machine, &mut out);
    for mv in before {
        lower.movement(mv, &ctx, &origin);
    }
    let feed = Some(Feed::PerRevolution(0.05));
    lower.corner(
        &Corner {
            shape: CornerShape::Undercut(undercut),
            feed,
            early: false,
            modal: false,
            large: LargeCorner::Refuse,
            at_arc: ArcChamfer::Refuse,
            blocks: Blocks::PassedOver,
        },
        &ctx,
        &origin,
    );
    for mv in after {
        lower.movement(mv, &ctx, &origin);
    }
    lower.finish();
    (out.0, diags.into_sorted().iter().map(|found| found.code.id).collect())
}

fn e() -> Undercut {
    Undercut::new(form_e(Undercuts::default().size(0.6, 0.3).expect("a size")))
}

fn shaft() -> [Move; 2] {
    [rapid(0.0, 25.0), line(-50.0, 25.0)]
}

/// The one code of a shaft with this undercut.
fn code(machine: &Machine, plane: Plane, before: &[Move], undercut: Undercut, after: &[Move]) -> &'static str {
    let (_, codes) = lower(machine, plane, before, undercut, after);
    assert_eq!(codes.len(), 1, "{codes:?}");
    codes[0]
}

#[test]
fn an_undercut_replaces_its_corner() {
    let (moves, codes) = lower(&lathe(), Plane::Zx, &shaft(), e(), &[line(-50.0, 40.0)]);
    assert!(codes.is_empty(), "{codes:?}");
    assert_eq!(
        moves,
        [
            "Z0.0000 X25.0000 G0 F0",
            "Z-47.5000 X25.0000 G1 F0.2",
            "Z-48.5433 X24.7204 G1 F0.05",
            "Z-48.6986 X24.7000 G2 K-48.6986 I25.3000 F0.05",
            "Z-49.4000 X24.7000 G1 F0.05",
            "Z-50.0000 X25.3000 G2 K-49.4000 I25.3000 F0.05",
            "Z-50.0000 X40.0000 G1 F0.2",
        ]
    );
}

#[test]
fn the_contour_decides_between_outside_and_inside() {
    let tables = Undercuts::default();
    let thread = thread_by_contour(&tables, tables.thread(2.5).expect("a pitch"), false, Deg(30.0));
    // Outside 8.7088 long, inside 12.8884.
    let (moves, _) = lower(&lathe(), Plane::Zx, &shaft(), thread, &[line(-50.0, 40.0)]);
    assert!(moves[1].starts_with("Z-41.2912 X25.0000"), "{moves:?}");
    let (moves, _) = lower(&lathe(), Plane::Zx, &shaft(), thread, &[line(-50.0, 10.0)]);
    assert!(moves[1].starts_with("Z-37.1116 X25.0000"), "{moves:?}");
    // On the other side of the turning centre outside is down.
    let (moves, _) =
        lower(&lathe(), Plane::Zx, &[rapid(0.0, -25.0), line(-50.0, -25.0)], thread, &[line(-50.0, -40.0)]);
    assert!(moves[1].starts_with("Z-41.2912 X-25.0000"), "{moves:?}");
}

#[test]
fn all_conditions_refuse() {
    let face = [line(-50.0, 40.0)];
    assert_eq!(code(&Machine::default(), Plane::Zx, &shaft(), e(), &face), "G3061");
    assert_eq!(code(&lathe(), Plane::Xy, &shaft(), e(), &face), "G3060");
    assert_eq!(code(&Machine { diameter_axis: None, ..lathe() }, Plane::Zx, &shaft(), e(), &face), "G3062");
    assert_eq!(code(&Machine { diameter_axis: Some(Axis::Y), ..lathe() }, Plane::Zx, &shaft(), e(), &face), "G3062");
    // 45 degrees, an arc, a rapid, no corner.
    assert_eq!(code(&lathe(), Plane::Zx, &shaft(), e(), &[line(-60.0, 35.0)]), "G3063");
    let shape = ArcShape::Radius { radius: 20.0, ccw: false, tol: 0.0 };
    let arc = Path::Arc(Arc { plane: Plane::Zx, shape, turns: 0 }, Feed::PerRevolution(0.2));
    assert_eq!(code(&lathe(), Plane::Zx, &shaft(), e(), &[Move { path: arc, ..line(-50.0, 40.0) }]), "G3063");
    assert_eq!(code(&lathe(), Plane::Zx, &shaft(), e(), &[rapid(-50.0, 40.0)]), "G3063");
    assert_eq!(code(&lathe(), Plane::Zx, &shaft(), e(), &[line(-90.0, 25.0)]), "G3063");
    // No room on the cylinder, none on the face.
    assert_eq!(code(&lathe(), Plane::Zx, &[rapid(-48.0, 25.0), line(-50.0, 25.0)], e(), &face), "G3064");
    let f = Undercut::new(form_f(Undercuts::default().size(0.6, 0.3).expect("a size")));
    assert_eq!(code(&lathe(), Plane::Zx, &shaft(), f, &[line(-50.0, 26.7)]), "G3064");
    assert!(lower(&lathe(), Plane::Zx, &shaft(), f, &[line(-50.0, 26.8)]).1.is_empty());
    // Not a number of the standard.
    let none = Shape::Slope { length: 2.0, entry: Deg(0.0), radius: 0.4 };
    assert_eq!(code(&lathe(), Plane::Zx, &shaft(), Undercut::new(none), &face), "G3065");
    let inside = Undercut { surface: Some(Surface::Internal), ..e() };
    assert_eq!(code(&lathe(), Plane::Zx, &shaft(), inside, &face), "G3066");
    // A second corner word, and none behind.
    assert_eq!(code(&lathe(), Plane::Zx, &shaft(), e(), &[]), "G3007");
}

#[test]
fn tapers_and_steep_entries_get_a_note() {
    let taper = [rapid(0.0, 25.0), line(-50.0, 26.5)];
    assert_eq!(code(&lathe(), Plane::Zx, &taper, e(), &[line(-50.0, 40.0)]), "G3067");
    // 3 degrees are allowed, a little more is not.
    let lean = |degrees: f64| [rapid(0.0, 25.0), line(-50.0, 25.0 + 50.0 * degrees.to_radians().tan())];
    assert_eq!(code(&lathe(), Plane::Zx, &lean(3.0), e(), &[line(-50.0, 40.0)]), "G3067");
    assert_eq!(code(&lathe(), Plane::Zx, &lean(3.01), e(), &[line(-50.0, 40.0)]), "G3063");
    let steep = Shape::Square { length: 4.0, depth: 0.5, entry: Deg(90.0), entry_radius: 0.8, corner_radius: 0.8 };
    assert_eq!(code(&lathe(), Plane::Zx, &shaft(), Undercut::new(steep), &[line(-50.0, 40.0)]), "G3068");
}

/// The worked contour with an allowance: cylinder X72.211, form F on the finished X72.011.
#[test]
fn an_allowance_lengthens_the_slope_only() {
    let f = form_f(Undercuts::default().size(0.6, 0.3).expect("a size"));
    let undercut = Undercut { allowance: Allowance { reference: 0.1, other: 0.0 }, ..Undercut::new(f) };
    let before = [rapid(0.0, 36.1055), line(-31.0, 36.1055)];
    let (moves, codes) = lower(&lathe(), Plane::Zx, &before, undercut, &[line(-31.0, 50.0)]);
    assert!(codes.is_empty(), "{codes:?}");
    assert!(moves[1].starts_with("Z-28.1268 X36.1055") && moves[4].starts_with("Z-30.6000 X35.7055"), "{moves:?}");
    assert!(moves[6].starts_with("Z-31.0000 X37.7705"), "{moves:?}");
}
