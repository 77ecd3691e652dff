//! Pass 3, continued: undercuts in inside corners of a turned contour.

use crate::diag::{Answer, Code, Diagnostic, Diags, Help, codes};
use crate::geo::undercut::{Corner, Fault, Orientation, Placed, Reference, place};
use crate::geo::{Element, Plane, SAME_POINT, distance};
use crate::ir::motion::{Arc, Path};
use crate::ir::undercut::{Surface, Undercut};
use crate::ir::{Feed, Origin};
use crate::machine::{Axis, Machine, MachineKind};

use super::step::{Step, plane_axes};
use super::{at, raised_at};

type Refusal = Box<Diagnostic>;

/// Looks whether there are undercuts here at all.
///
/// # Errors
/// G3060 outside the plane of Z and X, G3061 without turning technology, G3062 without a diameter axis.
pub fn admit(machine: &Machine, plane: Plane, origin: &Origin) -> Result<(), Refusal> {
    let refuse = |code, message: &str, help: Help| Err(Box::new(raised_at(code, *origin, message).help(help)));
    if machine.kind != MachineKind::Lathe {
        let help = "set `[machine] kind = \"lathe\"` if the program is for a lathe";
        let help = Answer::key("machine", "kind").one_of(&["\"lathe\""]).help(help);
        return refuse(codes::G3061, "the machine is configured as a milling machine, which makes no undercuts", help);
    }
    if plane != Plane::Zx {
        return refuse(
            codes::G3060,
            "undercuts exist in the plane of Z and X only",
            "select G18 before the contour".into(),
        );
    }
    let help = Answer::key("machine", "diameter_axis")
        .one_of(&["\"X\""])
        .help("set `[machine] diameter_axis = \"X\"` (MD 20100)");
    match machine.diameter_axis {
        Some(Axis::X) => Ok(()),
        Some(axis) => {
            let message =
                format!("the diameter axis is {}; a part in the plane of Z and X turns about Z", axis.letter());
            refuse(codes::G3062, &message, help)
        }
        None => refuse(codes::G3062, "no diameter axis is configured, so there is no cylinder to relieve", help),
    }
}

/// The element before and what is put between, and the element after.
///
/// # Errors
/// A corner that cannot take this undercut; the place is the undercut's.
pub fn relieve(
    before: &Step,
    after: &Step,
    undercut: &Undercut,
    feed: Option<Feed>,
    origin: Origin,
    diags: &Diags,
) -> Result<(Vec<Step>, Step), Refusal> {
    let plane = after.ctx.plane;
    let refuse = |code, message: String| -> Refusal {
        let found = raised_at(code, origin, message);
        Box::new(found.also(before.origin.loc, "line before").also(after.origin.loc, "line after"))
    };
    if before.ctx.frame != after.ctx.frame {
        return Err(refuse(codes::G3019, "the coordinate system changes at the undercut".to_owned()));
    }
    let line = |step: &Step, which: &str| match step.mv.path {
        Path::Line(feed) if !step.mv.machine && !step.leaves(plane) && step.mv.plane == plane => Ok(feed),
        Path::Rapid | Path::Line(_) | Path::Arc(..) | Path::Thread { .. } | Path::Carried { .. } => {
            let message = format!("the block {which} the undercut is no straight line at feed in the plane");
            Err(refuse(codes::G3063, message))
        }
    };
    line(before, "before")?;
    let feed = feed.unwrap_or(line(after, "after")?);
    let (Some(Element::Line { from, to: corner }), Some(Element::Line { to, .. })) =
        (before.element(plane), after.element(plane))
    else {
        return Err(refuse(codes::G3063, "the start of the line before the undercut is not known".to_owned()));
    };
    let corner = Corner { from, at: corner, to };
    let surface = surface(&corner).map_err(|fault| refuse_fault(fault, &refuse))?;
    if undercut.surface.is_some_and(|wanted| wanted != surface) {
        let message = match surface {
            Surface::External => "the undercut is for a bore, and the corner lies outside on the part",
            Surface::Internal => "the undercut is for the outside of the part, and the corner lies in a bore",
        };
        return Err(refuse(codes::G3066, message.to_owned()));
    }
    let shape = if surface == Surface::External { &undercut.external } else { &undercut.internal };
    let reference = if undercut.on_face { Reference::Second } else { Reference::First };
    let placed = place(shape, &corner, reference, undercut.allowance).map_err(|fault| refuse_fault(fault, &refuse))?;
    report(&placed, origin, diags);
    Ok(pieces(before, after, feed, origin, &placed))
}

/// On which side of the part the corner lies.
fn surface(corner: &Corner) -> Result<Surface, Fault> {
    let orientation = Orientation::of(corner)?;
    // Away from the turning centre, on either side of it.
    let rises = if corner.at.y < 0.0 { -orientation.second } else { orientation.second };
    Ok(if rises > 0.0 { Surface::External } else { Surface::Internal })
}

fn refuse_fault(fault: Fault, refuse: &impl Fn(&'static Code, String) -> Refusal) -> Refusal {
    let (code, message, help) = match fault {
        Fault::Dimension => (
            codes::G3065,
            "a depth, width or radius of the undercut is no positive number".to_owned(),
            "check the values of the undercut",
        ),
        Fault::Angle => (
            codes::G3065,
            "an angle of the undercut is out of range".to_owned(),
            "entry angles lie above 0 and up to 90 degrees",
        ),
        Fault::TooNarrow => (
            codes::G3065,
            "slope, floor and roundings do not fit into the width of the undercut".to_owned(),
            "make the undercut wider, or its radii smaller",
        ),
        Fault::Degenerate => (
            codes::G3063,
            "a line at the undercut has no length in the plane".to_owned(),
            "put the undercut between the two lines of its corner",
        ),
        Fault::NotSquare { direction } => (
            codes::G3063,
            format!("a line at the undercut runs at {:.3} degrees", direction.0),
            "undercuts need lines at 0, 90, 180 or 270 degrees, within 3 degrees, one along each axis",
        ),
        Fault::ReferenceTooShort { needs, has } => (
            codes::G3064,
            format!("the undercut takes {needs:.4} mm of the cylinder, which is {has:.4} mm long"),
            "take a smaller size, or make the cylinder longer",
        ),
        Fault::OtherTooShort { needs, has } => (
            codes::G3064,
            format!("the undercut takes {needs:.4} mm of the face, which is {has:.4} mm high"),
            "take a smaller size or form E, or make the face higher",
        ),
    };
    let mut found = refuse(code, message);
    found.help = Some(help.to_owned());
    found
}

fn report(placed: &Placed, origin: Origin, diags: &Diags) {
    if placed.leans {
        diags.push(at(origin, codes::G3067::line_at_undercut_is_not_parallel()));
    }
    if let Some(radius) = placed.reduced {
        diags.push(at(origin, codes::G3068::radius_at_entry_does_not_fit(&radius)));
    }
}

fn pieces(before: &Step, after: &Step, feed: Feed, origin: Origin, placed: &Placed) -> (Vec<Step>, Step) {
    let plane = after.ctx.plane;
    let mut steps = Vec::with_capacity(placed.elements.len() + 1);
    let mut first = before.clone();
    first.mv.end.set_in_plane(plane, placed.leave);
    first.mv.axes = first.mv.axes.union(plane_axes(plane));
    let mut last = first.clone();
    // An undercut that takes the whole line leaves nothing of it.
    if first.start.in_plane(plane).is_none_or(|start| distance(start, placed.leave) > SAME_POINT) {
        steps.push(first);
    }
    last.origin = origin;
    for element in &placed.elements {
        last.start = last.mv.end;
        last.mv.end.set_in_plane(plane, element.to());
        last.mv.path = match *element {
            Element::Line { .. } => Path::Line(feed),
            Element::Arc { from, center, sweep, .. } => Path::Arc(Arc { plane, from, center, sweep }, feed),
        };
        steps.push(last.clone());
    }
    let mut rest = after.clone();
    rest.start = last.mv.end;
    rest.mv.axes = rest.mv.axes.union(plane_axes(plane));
    (steps, rest)
}
