//! Pass 3, continued: undercuts in inside corners of a turned contour.

use crate::diag::{self, Answer, Diagnostic, Diags, Label, codes};
use crate::geo::undercut::{Corner, Fault, Orientation, Placed, Reference, place};
use crate::geo::{Element, Plane, SAME_POINT, distance};
use crate::ir::motion::{Arc, Path};
use crate::ir::undercut::{Surface, Undercut};
use crate::ir::{Feed, Origin};
use crate::machine::{Axis, Machine, MachineKind};

use super::at;
use super::step::{Step, plane_axes};

type Refusal = Box<Diagnostic>;

/// Looks whether there are undercuts here at all.
///
/// # Errors
/// G3060 outside the plane of Z and X, G3061 without turning technology, G3062 without a diameter axis.
pub fn admit(machine: &Machine, plane: Plane, origin: &Origin) -> Result<(), Refusal> {
    let fault = if machine.kind != MachineKind::Lathe {
        let lathe = Answer::key("machine", "kind").one_of(&["\"lathe\""]);
        codes::G3061::machine_is_configured_as_milling_machine().answer(lathe)
    } else if plane != Plane::Zx {
        codes::G3060::undercuts_exist_in_plane()
    } else {
        let asking = match machine.diameter_axis {
            Some(Axis::X) => return Ok(()),
            Some(axis) => codes::G3062::diameter_axis_is(&axis.letter()),
            None => codes::G3062::no_diameter_axis_is_configured(),
        };
        asking.answer(Answer::key("machine", "diameter_axis").one_of(&["\"X\""]))
    };
    Err(Box::new(at(*origin, fault)))
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
    let refuse = |fault| -> Refusal {
        let found = at(origin, fault);
        Box::new(found.also(before.origin.loc, Label::LineBefore).also(after.origin.loc, Label::LineAfter))
    };
    if before.ctx.frame != after.ctx.frame {
        return Err(refuse(codes::G3019::coordinate_system_changes(&"undercut")));
    }
    let line = |step: &Step, which: &str| match step.mv.path {
        Path::Line(feed) if !step.mv.machine && !step.leaves(plane) && step.mv.plane == plane => Ok(feed),
        Path::Rapid | Path::Line(_) | Path::Arc(..) | Path::Thread { .. } | Path::Carried { .. } => {
            Err(refuse(codes::G3063::block_is_no_straight_line(&which)))
        }
    };
    line(before, "before")?;
    let feed = feed.unwrap_or(line(after, "after")?);
    let (Some(Element::Line { from, to: corner }), Some(Element::Line { to, .. })) =
        (before.element(plane), after.element(plane))
    else {
        return Err(refuse(codes::G3063::start_of_line_before_is_not_known()));
    };
    let corner = Corner { from, at: corner, to };
    let surface = surface(&corner).map_err(|fault| refuse(worded(fault)))?;
    if undercut.surface.is_some_and(|wanted| wanted != surface) {
        return Err(refuse(match surface {
            Surface::External => codes::G3066::undercut_is_for_bore(),
            Surface::Internal => codes::G3066::undercut_is_for_outside(),
        }));
    }
    let shape = if surface == Surface::External { &undercut.external } else { &undercut.internal };
    let reference = if undercut.on_face { Reference::Second } else { Reference::First };
    let placed = place(shape, &corner, reference, undercut.allowance).map_err(|fault| refuse(worded(fault)))?;
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

fn worded(fault: Fault) -> diag::Fault {
    match fault {
        Fault::Dimension => codes::G3065::depth_width_or_radius_is_no_positive(),
        Fault::Angle => codes::G3065::angle_is_out_of_range(),
        Fault::TooNarrow => codes::G3065::slope_floor_and_roundings_do_not_fit(),
        Fault::Degenerate => codes::G3063::line_has_no_length_in_plane(),
        Fault::NotSquare { direction } => codes::G3063::line_runs_at_degrees(&direction.0),
        Fault::ReferenceTooShort { needs, has } => codes::G3064::undercut_takes_mm_of_cylinder(&needs, &has),
        Fault::OtherTooShort { needs, has } => codes::G3064::undercut_takes_mm_of_face(&needs, &has),
    }
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
