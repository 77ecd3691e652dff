//! What is said about a contour that the tool cannot follow.

use crate::diag::{Answer, Code, Diagnostic, Diags, codes};
use crate::geo::{Element, Plane, Point2, distance, joint};
use crate::ir::compensation::{Compensation, FeedAt};
use crate::ir::motion::{Move, Path};
use crate::ir::{Function, Origin};

use super::super::at;
use super::piece::{Item, Kind, Piece};

/// Why a contour is refused.
pub type Refused = Box<Diagnostic>;

/// A length for a message: four decimals, no trailing zeros.
fn length(mm: f64) -> String {
    let text = format!("{mm:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

fn raised(code: &'static Code, alarm: Option<u32>, origin: &Origin, message: String) -> Diagnostic {
    let mut found = at(code, *origin, message);
    found.alarm = alarm;
    found
}

pub fn arc_too_small(contour: &Element, rules: &Compensation, origin: &Origin) -> Refused {
    let message = match *contour {
        Element::Arc { from, center, .. } => format!(
            "the tool of radius {} mm does not fit into this arc of radius {} mm",
            length(rules.radius),
            length(distance(from, center))
        ),
        Element::Line { .. } => "an element of no length has no path beside it".to_owned(),
    };
    Box::new(
        raised(codes::G3201, rules.alarms.no_room, origin, message)
            .help("take a smaller tool, or make the radius of the arc at least that of the tool"),
    )
}

pub fn no_room(last: &Piece, next: &Piece) -> Refused {
    let radius = length(next.rules.radius);
    let message = if next.rules.search.elements > 0 {
        let ahead = next.rules.search.elements;
        format!("the tool of radius {radius} mm does not fit: the path meets none of the next {ahead} elements")
    } else {
        let (before, own) = (length(last.curve.length()), length(next.contour.length()));
        format!(
            "the tool of radius {radius} mm does not fit into the corner in front of this element: {before} mm of the \
             path before are left, the element is {own} mm long, and their paths do not cross"
        )
    };
    let found = raised(codes::G3202, next.rules.alarms.no_room, &next.origin, message);
    let found = found.also(last.origin.loc, "element before");
    Box::new(found.help("take a smaller tool, or make the elements at this corner longer"))
}

pub fn start_unknown(origin: &Origin) -> Refused {
    let message = "where this element of the compensated contour lies in the plane is not known";
    Box::new(at(codes::G3203, *origin, message).help("program both axes of the plane in front of the contour"))
}

pub fn no_line(begins: bool, arc: bool, rules: &Compensation, origin: &Origin) -> Refused {
    let what = if begins { "begins" } else { "ends" };
    let how = if arc { "on an arc" } else { "in a block that does not move in the working plane" };
    let message = format!("radius compensation {what} {how}");
    let found = raised(codes::G3203, rules.alarms.no_line, origin, message);
    Box::new(found.help("begin it in a straight block that leads from beside the contour to its first point"))
}

pub fn leaves_on_arc(arc: bool, origin: &Origin) -> Refused {
    let what = if arc { "an arc" } else { "a thread" };
    let message =
        format!("{what} follows a compensated contour: the tool stands beside it, where the block does not start");
    Box::new(at(codes::G3203, *origin, message).help("put a straight block without compensation in between"))
}

pub fn no_contour(of: &Origin, origin: &Origin) -> Refused {
    let message = "radius compensation ends before the contour has an element: there is no direction to stand beside";
    let found = at(codes::G3204, *origin, message).also(of.loc, "compensation begins here");
    Box::new(found.help("program one element of the contour at least between the two blocks"))
}

pub fn never_ends(of: &Origin) -> Refused {
    let message = "radius compensation is still on at the end of the program: how the contour ends is not known";
    Box::new(at(codes::G3204, *of, message).help("end it in a block that leads away from the contour"))
}

/// What TRANSMIT and TRACYL do.
pub const TRANSFORMED: &str = "a transformation begins or ends";

pub fn still_on(event: &str, origin: &Origin) -> Refused {
    let message = format!("{event} while radius compensation is on");
    Box::new(at(codes::G3204, *origin, message).help("end the compensation in a block in front of it"))
}

pub fn position_lost(origin: &Origin) -> Refused {
    let message = "the position of the tool gets lost inside a compensated contour";
    Box::new(at(codes::G3203, *origin, message).help("end the compensation in front of this block"))
}

pub fn too_much_between(origin: &Origin) -> Refused {
    let message = "too many blocks without a move in the plane stand between two elements of a compensated contour";
    Box::new(at(codes::G3205, *origin, message).help("end the compensation in front of them"))
}

/// What may not stand in a contour at all.
#[inline]
pub fn admit(mv: &Move, origin: &Origin) -> Result<(), Refused> {
    let what = match &mv.path {
        _ if mv.machine => "a block in machine coordinates",
        Path::Thread { .. } => "a thread",
        Path::Arc(arc, _) if arc.plane != mv.plane => "an arc outside the working plane",
        Path::Rapid | Path::Line(_) | Path::Arc(..) | Path::Carried { .. } => return Ok(()),
    };
    Err(stands_inside(what, origin))
}

#[cold]
fn stands_inside(what: &str, origin: &Origin) -> Refused {
    let message = format!("{what} stands inside a contour with radius compensation");
    Box::new(at(codes::G3205, *origin, message).help("end the compensation in front of this block"))
}

pub fn plane_changes(rules: &Compensation, origin: &Origin) -> Refused {
    let message = "the working plane changes inside a contour with radius compensation".to_owned();
    let found = raised(codes::G3205, rules.alarms.plane, origin, message);
    Box::new(found.help("end the compensation in front of this block"))
}

pub fn side_changes(side: bool, origin: &Origin) -> Refused {
    let what = if side { "the side" } else { "the radius" };
    let message = format!("{what} of the compensation changes inside a contour");
    Box::new(at(codes::G3205, *origin, message).help("end the compensation, and begin it anew behind this place"))
}

pub fn constant_at_start(origin: &Origin) -> Refused {
    let message = "the offset is held constant before the contour has one";
    Box::new(at(codes::G3205, *origin, message).help("let one element of the contour stand in front"))
}

pub fn no_feed(last: &Piece, next: &Piece) -> Refused {
    let message = "the arc about this corner lies between two blocks at rapid traverse and has no feed";
    let found = at(codes::G3206, next.origin, message).also(last.origin.loc, "element before");
    Box::new(found.help("program the contour at a feed"))
}

pub fn too_long(last: &Piece, next: &Piece, by: f64, most: f64) -> Refused {
    let message = format!(
        "the elements are to be prolonged by {} mm beyond the corner, and meet after {} mm",
        length(by),
        length(most)
    );
    let found = at(codes::G3207, last.origin, message).also(next.origin.loc, "element after");
    Box::new(found.help("make the length smaller"))
}

pub fn around_otherwise(leaves: bool, origin: &Origin) -> Refused {
    let what = if leaves { "leaves" } else { "comes to" };
    let message =
        format!("the tool {what} the contour from behind, and the control's way around the corner is not known");
    Box::new(
        at(codes::G3208, *origin, message).help("program the way around, or let it lead around on a circle (G450)"),
    )
}

pub fn inside_circle(leaves: bool, rules: &Compensation, origin: &Origin) -> Refused {
    let (what, alarm) = if leaves { ("end", rules.alarms.end_inside) } else { ("start", rules.alarms.start_inside) };
    let message = format!(
        "the {what} of the way lies nearer to the contour point than the radius of the tool, {} mm",
        length(rules.radius)
    );
    let found = raised(codes::G3208, alarm, origin, message);
    Box::new(found.help("start or end farther away from the contour"))
}

pub fn left_out<'p>(gone: impl Iterator<Item = &'p Piece>, last: &Piece, next: &Piece) -> Refused {
    let gone: Vec<&Piece> = gone.collect();
    let what = if gone.len() == 1 { "an element is" } else { "elements are" };
    let message = format!(
        "{what} left out, because the tool of radius {} mm does not fit: the path goes on in this block",
        length(next.rules.radius)
    );
    let mut found = raised(codes::G3210, next.rules.alarms.left_out, &next.origin, message);
    for piece in gone.iter().take(8) {
        found = found.also(piece.origin.loc, "left out");
    }
    Box::new(
        found.also(last.origin.loc, "element before").help("check that the material may stay, or take a smaller tool"),
    )
}

pub fn damaged(path: &Origin, contour: &Origin, radius: f64, refuses: bool) -> Refused {
    let message = format!(
        "the tool of radius {} mm damages the contour here: its path comes too near to an element that is no neighbour",
        length(radius)
    );
    let code = if refuses { codes::G3202 } else { codes::G3211 };
    let found = at(code, *path, message).also(contour.loc, "this element");
    let help = if refuses {
        "take a smaller tool, or switch the search of the control off in front of this contour (M120 LA0, CDOF)"
    } else {
        "take a smaller tool"
    };
    Box::new(found.help(help))
}

pub fn offset_stays(at_point: Option<Point2>, plane: Plane, origin: &Origin) -> Refused {
    let (first, second, _) = plane.axes();
    let names = ["X", "Y", "Z"];
    let place = at_point
        .map_or(String::new(), |p| format!(" ({}{} {}{})", names[first], length(p.x), names[second], length(p.y)));
    let message = format!(
        "radius compensation ends in a block that leaves the plane alone: the tool stays beside the contour{place} until the next block in the plane"
    );
    Box::new(
        at(codes::G3212, *origin, message).help("end the compensation in a block that leads away from the contour"),
    )
}

/// Says once that a machine datum decides the corner which nobody gave.
pub fn open_turn(last: &Piece, next: &Piece, diags: &Diags) {
    let Some((above, up_to)) = last.rules.outside.open else { return };
    let turn = joint::turn(last.headings.end, next.headings.start).abs();
    let meets = turn <= last.rules.outside.prolonged.radians();
    if turn <= above.radians() || turn > up_to.radians() || !diags.first_time(codes::G3215, meets) {
        return;
    }
    let way = if meets { "both paths are prolonged until they meet" } else { "the tool goes around it on an arc" };
    let message = format!(
        "at this outside corner of {} degrees a limit decides that is machine data of the control: {way}",
        length(turn.to_degrees())
    );
    diags.push(at(codes::G3215, last.origin, message).also(next.origin.loc, "element after").help(
        Answer::key("control", "g451_limit").help(
            "give the limits of the machine: `[control] g451_limit` (MD 20210) and `g450_flat` (MD 20230), in degrees",
        ),
    ));
}

/// A corner that the block of `last` asks for, and that is none on the outside.
pub fn corner_without_effect(last: &Piece, next: &Piece, diags: &Diags) {
    if !last.rules.own_corner {
        return;
    }
    let message = "the M function for the corner at the end of this element has no effect: the contour turns towards the tool there, or goes on straight";
    let found = at(codes::G3218, last.origin, message).also(next.origin.loc, "element after");
    diags.push(found.help("move it into the block that ends in the corner that is meant, or remove it"));
}

/// A corner that the last block of a contour asks for; `leaves` is the way off it.
pub fn last_corner(last: &Piece, leaves: &Origin, diags: &Diags) {
    if !last.rules.own_corner {
        return;
    }
    let message = "the M function for the corner at the end of this element has no effect: the compensation ends there";
    let found = at(codes::G3218, last.origin, message).also(leaves.loc, "the tool leaves the contour here");
    diags.push(found.help("move it into the block that ends in the corner that is meant, or remove it"));
}

/// What no manual says about the joint in front of `next`.
pub fn reading(last: &Piece, next: &Piece, diags: &Diags) {
    let (before, behind) = (last.mv.path.feed(), next.mv.path.feed());
    let idle = |item: &Item| {
        matches!(item, Item::Function(Function::Comment(_) | Function::Remark(_) | Function::PathControl(_), _))
    };
    let moves = last.items.iter().any(|item| !idle(item));
    let message = match (before != behind, moves) {
        (false, false) => return,
        (true, _) => {
            "the arc about the corner in front of this element takes its feed; the element before has another one"
        }
        (false, true) => {
            "what stands between this element and the one before happens in front of the arc about the corner"
        }
    };
    if diags.first_text(codes::G3213, message) {
        let found = at(codes::G3213, next.origin, message).also(last.origin.loc, "element before");
        diags.push(found.help("program the same feed for both elements, and nothing between them"));
    }
}

/// The start or end of the way lies between the contour and its path, where controls may see it as behind or not.
pub fn nearly_behind(leaves: bool, origin: &Origin) -> Refused {
    let what = if leaves { "end" } else { "start" };
    let message = format!(
        "the {what} of the way lies less than the tool radius beside the contour: it is taken to be behind it, so a circle leads around the contour point"
    );
    Box::new(
        at(codes::G3214, *origin, message).help("start or end farther away from the contour, or clearly behind it"),
    )
}

/// A cycle works from where the tool stands, and that is not the programmed point.
#[cold]
pub fn cycle_beside(origin: &Origin) -> Option<Refused> {
    let message = "a cycle is called while the tool stands beside a contour with radius compensation";
    Some(Box::new(at(codes::G3205, *origin, message).help("leave the contour in the plane in a block in front of it")))
}

/// F counts at the contour on the control, and is printed for the centre.
#[inline]
pub fn feed_instead(piece: &Piece, diags: &Diags) {
    if piece.rules.feed == FeedAt::CentreInstead {
        feed_of_centre(piece, diags);
    }
}

fn feed_of_centre(piece: &Piece, diags: &Diags) {
    let (Element::Arc { from, center, .. }, Element::Arc { from: own, .. }) = (piece.contour, piece.curve) else {
        return;
    };
    if piece.kind != Kind::Element || !diags.first_time(codes::G3216, ()) {
        return;
    }
    let message = format!(
        "F is printed for the centre of the tool, whose radius is {} mm here; the control keeps it at the contour of radius {} mm",
        length(distance(own, center)),
        length(distance(from, center))
    );
    diags.push(at(codes::G3216, piece.origin, message).help(
        Answer::key("control", "curve_feed").help("for the feed of the control set `[control] curve_feed = \"control\"`, or program CFTCP if F is meant for the centre"),
    ));
}
