//! What is said about a contour that the tool cannot follow.

use crate::diag::{Code, Diagnostic, Diags, codes};
use crate::geo::{Element, Plane, Point2, distance, joint};
use crate::ir::compensation::{Compensation, FeedAt};
use crate::ir::motion::{Move, Path};
use crate::ir::{Ask, Function, Origin};

use super::super::{at, raised_at};
use super::piece::{Item, Kind, Piece};

/// Why a contour is refused.
pub type Refused = Box<Diagnostic>;

/// A length for a message: four decimals, no trailing zeros.
fn length(mm: f64) -> String {
    let text = format!("{mm:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

fn raised(code: &'static Code, alarm: Option<u32>, origin: &Origin, message: String) -> Diagnostic {
    let mut found = raised_at(code, *origin, message);
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
            "the tool of radius {radius} mm does not fit into the corner before this element: {before} mm of the \
             path before are left, the element is {own} mm long, and their paths do not cross"
        )
    };
    let found = raised(codes::G3202, next.rules.alarms.no_room, &next.origin, message);
    let found = found.also(last.origin.loc, "element before");
    Box::new(found.help("take a smaller tool, or make the elements at this corner longer"))
}

pub fn start_unknown(origin: &Origin) -> Refused {
    Box::new(
        at(*origin, codes::G3203::where_this_element_of_compensated_contour_lies())
            .help("program both axes of the plane before the contour"),
    )
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
    Box::new(
        at(*origin, codes::G3203::follows_compensated_contour(&what))
            .help("put a straight block without compensation in between"),
    )
}

pub fn no_contour(of: &Origin, origin: &Origin) -> Refused {
    let found = at(*origin, codes::G3204::radius_compensation_ends_before_contour_has_element())
        .also(of.loc, "compensation begins here");
    Box::new(found.help("program one element of the contour at least between the two blocks"))
}

pub fn never_ends(of: &Origin) -> Refused {
    Box::new(
        at(*of, codes::G3204::radius_compensation_is_still_on_at_end())
            .help("end it in a block that leads away from the contour"),
    )
}

/// What TRANSMIT and TRACYL do.
pub const TRANSFORMED: &str = "a transformation begins or ends";

pub fn still_on(event: &str, origin: &Origin) -> Refused {
    Box::new(
        at(*origin, codes::G3204::while_radius_compensation(&event)).help("end the compensation in a block before it"),
    )
}

pub fn position_lost(origin: &Origin) -> Refused {
    Box::new(
        at(*origin, codes::G3203::position_of_tool_gets_lost_inside_compensated())
            .help("end the compensation before this block"),
    )
}

pub fn too_much_between(origin: &Origin) -> Refused {
    Box::new(
        at(*origin, codes::G3205::too_many_blocks_without_move_in_plane()).help("end the compensation before them"),
    )
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
    Box::new(
        at(*origin, codes::G3205::stands_inside_contour_with_radius_compensation(&what))
            .help("end the compensation before this block"),
    )
}

pub fn plane_changes(rules: &Compensation, origin: &Origin) -> Refused {
    let message = "the working plane changes inside a contour with radius compensation".to_owned();
    let found = raised(codes::G3205, rules.alarms.plane, origin, message);
    Box::new(found.help("end the compensation before this block"))
}

pub fn side_changes(side: bool, origin: &Origin) -> Refused {
    let what = if side { "the side" } else { "the radius" };
    Box::new(
        at(*origin, codes::G3205::of_compensation_changes_inside_contour(&what))
            .help("end the compensation, and begin it anew after this place"),
    )
}

pub fn constant_at_start(origin: &Origin) -> Refused {
    Box::new(
        at(*origin, codes::G3205::offset_is_held_constant_before_contour())
            .help("let one element of the contour stand before it"),
    )
}

pub fn no_feed(last: &Piece, next: &Piece) -> Refused {
    let found =
        at(next.origin, codes::G3206::arc_about_this_corner_lies_between_two()).also(last.origin.loc, "element before");
    Box::new(found.help("program the contour at a feed"))
}

pub fn too_long(last: &Piece, next: &Piece, by: f64, most: f64) -> Refused {
    let found = at(last.origin, codes::G3207::elements_are_to_be_prolonged_by_mm(&length(by), &length(most)))
        .also(next.origin.loc, "element after");
    Box::new(found.help("make the length smaller"))
}

pub fn around_otherwise(leaves: bool, origin: &Origin) -> Refused {
    let what = if leaves { "leaves" } else { "comes to" };
    Box::new(
        at(*origin, codes::G3208::tool_contour(&what))
            .help("program the way around, or let it lead around on a circle (G450)"),
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
    let found = raised_at(code, *path, message).also(contour.loc, "this element");
    let help = if refuses {
        "take a smaller tool, or switch the search of the control off before this contour (M120 LA0, CDOF)"
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
    Box::new(
        at(*origin, codes::G3212::radius_compensation_ends_in_block_that_leaves(&place))
            .help("end the compensation in a block that leads away from the contour"),
    )
}

/// Says once that a machine datum decides the corner which nobody gave.
pub fn open_turn(last: &Piece, next: &Piece, diags: &Diags) {
    let Some((above, up_to, ask)) = last.rules.outside.open else { return };
    let turn = joint::turn(last.headings.end, next.headings.start).abs();
    let meets = turn <= last.rules.outside.prolonged.radians();
    if turn <= above.radians() || turn > up_to.radians() || !diags.first_time(codes::G3215, meets) {
        return;
    }
    let way = if meets { "both paths are prolonged until they meet" } else { "the tool goes around it on an arc" };
    diags.push(
        at(last.origin, codes::G3215::at_this_outside_corner_of_degrees_limit(&length(turn.to_degrees()), &way))
            .also(next.origin.loc, "element after")
            .help(ask.help()),
    );
}

/// A corner that the block of `last` asks for, and that is none on the outside.
pub fn corner_without_effect(last: &Piece, next: &Piece, diags: &Diags) {
    if !last.rules.own_corner {
        return;
    }
    let found = at(last.origin, codes::G3218::m_function_for_corner_at_end_of_this_element())
        .also(next.origin.loc, "element after");
    diags.push(found.help("move it into the block that ends in the corner that is meant, or remove it"));
}

/// A corner that the last block of a contour asks for; `leaves` is the way off it.
pub fn last_corner(last: &Piece, leaves: &Origin, diags: &Diags) {
    if !last.rules.own_corner {
        return;
    }
    let found = at(last.origin, codes::G3218::m_function_for_corner_at_end())
        .also(leaves.loc, "the tool leaves the contour here");
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
        (true, _) => "the arc about the corner before this element takes its feed; the element before has another one",
        (false, true) => "what stands between this element and the one before happens before the arc about the corner",
    };
    if diags.first_text(codes::G3213, message) {
        let found = raised_at(codes::G3213, next.origin, message).also(last.origin.loc, "element before");
        diags.push(found.help("program the same feed for both elements, and nothing between them"));
    }
}

/// The start or end of the way lies between the contour and its path, where controls may see it as behind or not.
pub fn nearly_behind(leaves: bool, origin: &Origin) -> Refused {
    let what = if leaves { "end" } else { "start" };
    Box::new(
        at(*origin, codes::G3214::of_way_lies_less_than_tool_radius(&what))
            .help("start or end farther away from the contour, or clearly behind it"),
    )
}

/// A cycle works from where the tool stands, and that is not the programmed point.
#[cold]
pub fn cycle_beside(origin: &Origin) -> Option<Refused> {
    Some(Box::new(
        at(*origin, codes::G3205::cycle_is_called_while_tool_stands_beside())
            .help("leave the contour in the plane in a block before it"),
    ))
}

/// F counts at the contour on the control, and is printed for the centre.
#[inline]
pub fn feed_instead(piece: &Piece, diags: &Diags) {
    if let FeedAt::CentreInstead(ask) = piece.rules.feed {
        feed_of_centre(piece, ask, diags);
    }
}

fn feed_of_centre(piece: &Piece, ask: &Ask, diags: &Diags) {
    let (Element::Arc { from, center, .. }, Element::Arc { from: own, .. }) = (piece.contour, piece.curve) else {
        return;
    };
    if piece.kind != Kind::Element || !diags.first_time(codes::G3216, ()) {
        return;
    }
    diags.push(
        at(
            piece.origin,
            codes::G3216::f_is_printed_for_centre_of_tool(
                &length(distance(own, center)),
                &length(distance(from, center)),
            ),
        )
        .help(ask.help()),
    );
}
