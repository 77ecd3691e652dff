//! The undercut cycle: in front of the corner at rapid, along the undercut and up the face at feed, back.
//!
//! The path is computed in the frame of the corner: `s` along the cylinder, `n` along the face, both away from the
//! part. The tool enters on the extension of the entry slope, so that it never touches the cylinder in front. A nose
//! of known radius runs beside the undercut (`nose`); its programmed point is what is sent.

mod nose;

use crate::diag::{self, codes};
use crate::geo::tolerance;
use crate::geo::undercut::{Allowance, Corner, Fault, Frame, Placed, Reference, Shape, place};
use crate::geo::{Deg, Element, Plane, Point2, Vec2, clearance, parts};
use crate::ir::contour::{self, ArcShape, Coords, Move, Path};
use crate::ir::cycle::Family;
use crate::ir::cycle::undercut::{Leave, UndercutCycle, UndercutFault};
use crate::ir::{Pos, Side};

use super::{CycleItem, Expand, Start};
use nose::Outline;

/// Most depth steps.
const MOST_STEPS: f64 = 10_000.0;
/// The face goes on above where a nose on the floor touches it by this at least, mm.
const LEAST_FACE: f64 = 0.01;
/// The cylinder and the face reach as far, mm: longer than any undercut, and not part of the cycle.
const LONG: f64 = 1e4;

impl Expand for UndercutCycle {
    fn expand(&self, start: &Start, out: &mut dyn FnMut(CycleItem)) -> Result<(), diag::Fault> {
        expand(self, start.in_turning_plane()?, &mut |mv| out(CycleItem::Move(*mv)))
    }
}

/// Sends the moves of the cycle, which starts and ends in `from`, (Z, X) with X as a radius.
///
/// # Errors
/// G3041 for arguments that make no undercut, G3040 for too many steps, G3046 for a start behind the face, G3048 where
/// the tool cannot leave the face, G3049 for a nose that does not fit.
pub fn expand(cycle: &UndercutCycle, from: Point2, out: &mut dyn FnMut(&Move)) -> Result<(), diag::Fault> {
    cycle.check().map_err(fault)?;
    let mut cuts = Vec::new();
    for step in steps(cycle)? {
        cuts.push(cut(cycle, &step)?);
    }
    let frame = Frame::new(cycle.corner, cycle.orientation, Reference::First, Allowance::default());
    let start = frame.inward(from);
    let radius = cycle.nose.radius;
    if start.x - cycle.tip().x - radius < -tolerance::LOST {
        return Err(codes::G3046::tool_stands_behind_face_of_undercut());
    }
    let mut path = Track { frame, cycle, out };
    let top = top(cycle, &cuts, start);
    path.rapid(Point2::new(start.x, top));
    for cut in &cuts {
        path.rapid(Point2::new(cut.enter.x, top));
        path.rapid(cut.enter);
        for element in &cut.elements {
            path.element(element);
        }
        path.lift(cut);
        path.rapid(Point2::new(cut.lifted().x, top));
    }
    path.rapid(Point2::new(start.x, top));
    path.rapid(start);
    Ok(())
}

/// Height of the travel: over everything the cycle cuts, and never nearer to the part than where the tool stood.
/// Inside it does not go beyond the turning centre for that.
fn top(cycle: &UndercutCycle, cuts: &[Cut], start: Point2) -> f64 {
    let highest = cuts.iter().map(|cut| cut.lifted().y.max(cut.enter.y)).fold(0.0, f64::max);
    let centre = if cycle.orientation.second < 0.0 { cycle.corner.y } else { f64::INFINITY };
    (highest + cycle.clearance).min(centre.max(highest)).max(start.y)
}

fn fault(fault: UndercutFault) -> diag::Fault {
    codes::G3041::undercut_makes_no_path(&fault)
}

/// One cut: its shape, how far it is moved out of the material, and whether it makes the finished undercut.
struct Step {
    shape: Shape,
    moved: Vec2,
    finishes: bool,
}

/// The cuts, the shallowest first.
fn steps(cycle: &UndercutCycle) -> Result<Vec<Step>, diag::Fault> {
    let mut list = Vec::new();
    // Without an allowance the last step is the finished undercut.
    let nothing_left = cycle.leave.is_nothing();
    if let Some(step) = cycle.step {
        let (shape, moved) = left(&cycle.shape, cycle.leave);
        let depth = shape.depth();
        let count = parts::count(depth, step).max(1.0);
        if count > MOST_STEPS {
            return Err(codes::G3040::undercut_takes_cuts_of_mm(&count, &step));
        }
        let count = count as u32;
        list.extend((1..=count).map(|i| {
            let shape = shallower(&shape, depth * f64::from(i) / f64::from(count));
            Step { shape, moved, finishes: i == count && nothing_left && cycle.finishing }
        }));
    }
    if cycle.finishing && !(nothing_left && cycle.step.is_some()) {
        list.push(Step { shape: cycle.shape, moved: Vec2::zeros(), finishes: true });
    }
    Ok(list)
}

/// The undercut that an allowance leaves, and where its corner lies from that of the finished one.
fn left(shape: &Shape, leave: Leave) -> (Shape, Vec2) {
    match (leave, *shape) {
        // The slope faces the other way along the cylinder than the face does: both come nearer to each other.
        (Leave::Along { z, x }, Shape::Square { length, depth, entry, entry_radius, corner_radius }) => {
            let length = length - 2.0 * z;
            (Shape::Square { length, depth, entry, entry_radius, corner_radius }, Vec2::new(z, x))
        }
        (Leave::Along { z, x }, other) => (other, Vec2::new(z, x)),
        // The slope meets the cylinder nearer to the corner: parallel lines, by half of the angle between the two.
        (Leave::Around(all), Shape::Square { length, depth, entry, entry_radius, corner_radius }) => {
            let (sin, cos) = Deg(entry.0 / 2.0).sin_cos();
            let length = length - all * (1.0 + sin / cos);
            (Shape::Square { length, depth, entry, entry_radius, corner_radius }, Vec2::new(all, all))
        }
        (Leave::Around(all), other) => (other, Vec2::new(all, all)),
    }
}

/// The same undercut with its floor at `depth`: its slope lies on the same line.
fn shallower(shape: &Shape, depth: f64) -> Shape {
    match *shape {
        Shape::Square { length, entry, entry_radius, corner_radius, .. } => {
            Shape::Square { length, depth, entry, entry_radius, corner_radius }
        }
        Shape::Groove { width, edge, radius, .. } => Shape::Groove { width, depth, edge, radius },
        other => other,
    }
}

/// One cut of the programmed point in the frame of the corner.
struct Cut {
    /// Where the feed begins, in front of the part.
    enter: Point2,
    elements: Vec<Element>,
    /// From the upper end of the face to where the tool goes out at rapid.
    lift: Vec2,
}

impl Cut {
    fn end(&self) -> Point2 {
        self.elements.last().map_or(self.enter, Element::to)
    }

    fn lifted(&self) -> Point2 {
        self.end() + self.lift
    }
}

fn cut(cycle: &UndercutCycle, step: &Step) -> Result<Cut, diag::Fault> {
    let outline = outline(cycle, step)?;
    let elements = if cycle.compensated {
        // The receiver leads the nose to the slope on a straight line: a way on its extension, clear of the cylinder.
        let from = outline.begin + outline.slope * (2.0 * cycle.clearance / outline.slope.y);
        let first = outline.elements.first().map_or(from, Element::from);
        core::iter::once(Element::Line { from, to: first }).chain(outline.elements.iter().copied()).collect()
    } else {
        nose::path(cycle, &outline, step.finishes)?
    };
    let enter = elements.first().map_or(outline.begin, Element::from);
    let mut cut = Cut { enter, elements, lift: Vec2::zeros() };
    cut.lift = lift(cycle, &outline, &cut)?;
    Ok(cut)
}

fn outline(cycle: &UndercutCycle, step: &Step) -> Result<Outline, diag::Fault> {
    let allowance = cycle.allowance;
    let at = Point2::new(allowance.other, allowance.reference) + step.moved;
    let corner = Corner { from: at + Vec2::new(LONG, 0.0), at, to: at + Vec2::new(0.0, LONG) };
    let placed: Placed = place(&step.shape, &corner, Reference::First, allowance)
        .map_err(|found: Fault| fault(UndercutFault::Shape(found)))?;
    let entry = match step.shape {
        Shape::Square { entry, .. } | Shape::Recessed { entry, .. } | Shape::Slope { entry, .. } => entry,
        Shape::Wedge { opening, axis, .. } => Deg(axis.0 - opening.0 / 2.0),
        Shape::Groove { .. } => Deg(90.0),
    };
    let (sin, cos) = entry.sin_cos();
    let slope = Vec2::new(cos, sin);
    // On the floor a nose touches the face at the height of its centre.
    let radius = if cycle.compensated { 0.0 } else { cycle.nose.radius };
    let touches = step.moved.y - step.shape.depth() + radius;
    let beside_face = if radius > 0.0 { touches + LEAST_FACE } else { touches };
    // A nose beside the slope hangs lower than its line by this.
    let hangs = radius * (1.0 - cos);
    let enter = placed.leave + slope * ((cycle.clearance + hangs) / sin);
    let end = match cycle.face_end {
        Some(x) => {
            let n = (x - cycle.corner.y) * cycle.orientation.second;
            if step.finishes && n < placed.join.y - tolerance::SAME {
                return Err(fault(UndercutFault::FaceEnd));
            }
            // Shallower undercuts reach higher up the face.
            Point2::new(placed.join.x, n.max(placed.join.y).max(beside_face))
        }
        None => Point2::new(placed.join.x, (placed.join.y + cycle.clearance).max(beside_face)),
    };
    let mut elements = Vec::with_capacity(placed.elements.len() + 2);
    elements.push(Element::Line { from: enter, to: placed.leave });
    elements.extend_from_slice(&placed.elements);
    elements.push(Element::Line { from: placed.join, to: end });
    Ok(Outline { elements, begin: placed.leave, slope })
}

/// From the end of a cut to where the tool goes out at rapid: off the face, and up where the undercut, or what the cut leaves in its
/// corners, is in the way.
///
/// # Errors
/// G3048 where the undercut is in every way.
fn lift(cycle: &UndercutCycle, outline: &Outline, cut: &Cut) -> Result<Vec2, diag::Fault> {
    let radius = if cycle.compensated { 0.0 } else { cycle.nose.radius };
    let center = cut.end() - cycle.tip();
    let cylinder = Element::Line { from: outline.begin, to: outline.begin + Vec2::new(LONG, 0.0) };
    // In front of the undercut there is no slope.
    let part = outline.elements.iter().skip(1).chain(core::iter::once(&cylinder));
    let part: Vec<&Element> = part.filter(|element| element.length() > tolerance::SAME).collect();
    let ways = [(1.0, 0.0), (1.0, 1.0), (0.5, 1.0), (0.25, 1.0), (0.125, 1.0)];
    let ways = ways.map(|(s, n)| Vec2::new(s, n) * cycle.clearance);
    // The last of the path is the face.
    let path = cut.elements.split_last().map_or(&[][..], |(_, path)| path);
    let free = |way: &Vec2| {
        let way = Element::Line { from: center + *way * 0.05, to: center + *way };
        let clear = part
            .iter()
            .all(|element| clearance::between(&way, element) > (radius - tolerance::SAME).max(tolerance::SAME));
        clear && path.iter().all(|element| clearance::between(&way.shifted(cycle.tip()), element) > tolerance::SAME)
    };
    ways.into_iter().find(free).ok_or_else(codes::G3048::there_is_no_room_between_end)
}

struct Track<'a> {
    frame: Frame,
    cycle: &'a UndercutCycle,
    out: &'a mut dyn FnMut(&Move),
}

impl Track<'_> {
    fn send(&mut self, to: Point2, path: Path) {
        let mut end = Pos::UNKNOWN;
        end.set_in_plane(Plane::Zx, self.frame.point(to));
        let side = if path.is_rapid() { Side::None } else { self.cycle.side() };
        (self.out)(&Move { end, path, side, coords: Coords::Frame });
    }

    fn rapid(&mut self, to: Point2) {
        self.send(to, Path::Rapid);
    }

    fn line(&mut self, to: Point2) {
        self.send(to, Path::Line(self.cycle.feed));
    }

    /// Off the face: along the cylinder at rapid; on another way the face may still carry stock.
    fn lift(&mut self, cut: &Cut) {
        if cut.lift.y > 0.0 { self.line(cut.lifted()) } else { self.rapid(cut.lifted()) }
    }

    fn element(&mut self, element: &Element) {
        match *element {
            Element::Line { to, .. } => self.line(to),
            Element::Arc { to, center, sweep, .. } => {
                let ccw = (sweep > 0.0) != self.frame.flips();
                let shape = ArcShape::Center { center: self.frame.point(center), ccw, tol: 1e-6 };
                self.send(to, Path::Arc(contour::Arc { plane: Plane::Zx, shape, turns: 0 }, self.cycle.feed));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geo::undercut::Orientation;
    use crate::ir::Feed;
    use crate::ir::cycle::roughing::Nose;
    use crate::ir::undercut::{ThreadForm, form_e, form_f, thread};
    use crate::machine::Undercuts;

    fn cycle(shape: Shape, position: u8, z: f64, x: f64) -> UndercutCycle {
        UndercutCycle {
            corner: Point2::new(z, x),
            orientation: orientation(position).expect("a position"),
            shape,
            allowance: Allowance::default(),
            clearance: 1.0,
            face_end: None,
            feed: Feed::PerRevolution(0.1),
            step: None,
            leave: Leave::NOTHING,
            finishing: true,
            compensated: true,
            nose: Nose::default(),
        }
    }

    fn words(cycle: &UndercutCycle, from: Point2) -> Vec<String> {
        let number = |v: f64| {
            let text = format!("{v:.4}");
            text.trim_end_matches('0').trim_end_matches('.').to_owned()
        };
        let mut list = Vec::new();
        expand(cycle, from, &mut |mv| {
            let to = mv.end.in_plane(Plane::Zx).expect("both axes");
            let word = match mv.path {
                Path::Rapid => "G0".to_owned(),
                Path::Line(_) => "G1".to_owned(),
                Path::Arc(contour::Arc { shape: ArcShape::Center { ccw, .. }, .. }, _) => {
                    if ccw { "G3" } else { "G2" }.to_owned()
                }
                other => panic!("{other:?}"),
            };
            let side = match mv.side {
                Side::None => "",
                Side::Left => " G41",
                Side::Right => " G42",
            };
            list.push(format!("{word} Z{} X{}{side}", number(to.x), number(2.0 * to.y)));
        })
        .expect("a path");
        list
    }

    /// Position numbers of undercut cycles: the senses in which cylinder and face leave the corner. `0` external +Z,
    /// `1` external -Z, `2` internal +Z, `3` internal -Z (SINUMERIK NC programming 12/2019, CYCLE940).
    fn orientation(position: u8) -> Option<Orientation> {
        let (first, second) = match position {
            0 => (-1.0, 1.0),
            1 => (1.0, 1.0),
            2 => (-1.0, -1.0),
            3 => (1.0, -1.0),
            _ => return None,
        };
        Some(Orientation { first, second, first_leads: true })
    }

    #[test]
    fn form_e_with_approach_and_retract() {
        let size = *Undercuts::default().size(0.6, 0.3).expect("a size");
        let mut e = cycle(form_e(&size), 1, -75.0, 32.5);
        e.face_end = Some(40.0);
        assert_eq!(
            words(&e, Point2::new(5.0, 50.0)),
            [
                "G0 Z5 X100",
                "G0 Z-65.0359 X100",
                "G0 Z-65.0359 X69",
                "G1 Z-68.7679 X67 G42",
                "G1 Z-72.5 X65 G42",
                "G1 Z-73.5433 X64.4409 G42",
                "G2 Z-73.6986 X64.4 G42",
                "G1 Z-74.4 X64.4 G42",
                "G2 Z-75 X65.6 G42",
                "G1 Z-75 X80 G42",
                "G0 Z-74 X80",
                "G0 Z-74 X100",
                "G0 Z5 X100",
                "G0 Z5 X100",
            ]
        );
        // Low over the cylinder the tool first goes up, over the face.
        let list = words(&e, Point2::new(-40.0, 34.0));
        assert_eq!((list[0].as_str(), list[13].as_str()), ("G0 Z-40 X82", "G0 Z-40 X68"));
    }

    #[test]
    fn inside_everything_is_mirrored() {
        let size = *Undercuts::default().size(0.6, 0.3).expect("a size");
        let f = cycle(form_f(&size), 3, -30.0, 20.0);
        let list = words(&f, Point2::new(5.0, 10.0));
        assert_eq!(list[4..7], ["G1 Z-27.5 X40 G41", "G1 Z-28.5433 X40.5591 G41", "G3 Z-28.6986 X40.6 G41"]);
        assert_eq!(list[8..10], ["G3 Z-30.1942 X39.233 G41", "G1 Z-30 X36.4699 G41"]);
        assert_eq!(list[10], "G1 Z-30 X34.4699 G41");
    }

    #[test]
    fn depth_steps_lie_on_the_same_slope() {
        let tables = Undercuts::default();
        let (shape, _) = thread(&tables, tables.thread(2.5).expect("a pitch"), ThreadForm::A, Deg(30.0));
        let rough =
            UndercutCycle { step: Some(0.7), leave: Leave::Along { z: 0.0, x: 0.1 }, ..cycle(shape, 1, -30.0, 10.0) };
        let list = words(&rough, Point2::new(5.0, 30.0));
        let begins: Vec<_> = list.iter().filter(|line| line.contains("Z-21.2912")).collect();
        // 1.8 in three steps of at most 0.7 from X20.2, then the finishing cut.
        assert_eq!(begins.len(), 4, "{list:?}");
        let floors: Vec<_> = list.iter().filter(|line| line.starts_with("G1 Z-28.8")).cloned().collect();
        assert_eq!(floors, ["X19", "X17.8", "X16.6", "X16.4"].map(|x| format!("G1 Z-28.8 {x} G42")));
    }

    /// Parallel lines: the slope meets the raised cylinder nearer to the corner by U·tan(A/2).
    #[test]
    fn an_allowance_on_all_sides() {
        let tables = Undercuts::default();
        let (shape, _) = thread(&tables, tables.thread(2.5).expect("a pitch"), ThreadForm::A, Deg(30.0));
        let rough = UndercutCycle {
            step: Some(2.0),
            leave: Leave::Around(0.3),
            finishing: false,
            ..cycle(shape, 1, -30.0, 10.0)
        };
        let list = words(&rough, Point2::new(5.0, 30.0));
        assert!(list.contains(&"G1 Z-21.3715 X20.6 G42".to_owned()), "{list:?}");
        assert!(list.contains(&"G1 Z-28.5 X17 G42".to_owned()), "{list:?}");
    }

    #[test]
    fn refusals() {
        let size = *Undercuts::default().size(0.6, 0.3).expect("a size");
        let e = cycle(form_e(&size), 1, -75.0, 32.5);
        let code = |cycle: UndercutCycle, z: f64| {
            expand(&cycle, Point2::new(z, 50.0), &mut |_| ()).expect_err("refused").code().id
        };
        assert_eq!(code(e, -80.0), "G3046");
        assert_eq!(code(UndercutCycle { clearance: 0.0, ..e }, 0.0), "G3041");
        assert_eq!(code(UndercutCycle { feed: Feed::PerRevolution(0.0), ..e }, 0.0), "G3041");
        assert_eq!(code(UndercutCycle { face_end: Some(32.6), ..e }, 0.0), "G3041");
        assert_eq!(code(UndercutCycle { finishing: false, ..e }, 0.0), "G3041");
        assert_eq!(code(UndercutCycle { step: Some(1e-9), ..e }, 0.0), "G3040");
        assert_eq!(code(UndercutCycle { corner: Point2::new(f64::NAN, 0.0), ..e }, 0.0), "G3041");
    }
}
