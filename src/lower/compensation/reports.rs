//! What is said about a contour that the tool cannot follow.

use crate::diag::{Diagnostic, Diags, Fault, Label, codes};
use crate::geo::{Element, Plane, Point2, distance, joint};
use crate::ir::compensation::{Compensation, FeedAt};
use crate::ir::motion::{Move, Path};
use crate::ir::{Ask, Function, Origin};

use super::super::at;
use super::piece::{Item, Kind, Piece};

/// Why a contour is refused.
pub type Refused = Box<Diagnostic>;

/// A length for a message: four decimals, no trailing zeros.
fn length(mm: f64) -> String {
    let text = format!("{mm:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

pub fn arc_too_small(contour: &Element, rules: &Compensation, origin: &Origin) -> Refused {
    let fault = match *contour {
        Element::Arc { from, center, .. } => {
            codes::G3201::tool_does_not_fit_into_this_arc(&length(rules.radius), &length(distance(from, center)))
        }
        Element::Line { .. } => codes::G3201::element_of_no_length_has_no_path(),
    };
    Box::new(at(*origin, fault.alarm(rules.alarms.no_room)))
}

pub fn no_room(last: &Piece, next: &Piece) -> Refused {
    let radius = length(next.rules.radius);
    let ahead = next.rules.search.elements;
    let fault = if ahead > 0 {
        codes::G3202::path_meets_none_of_next_elements(&radius, &ahead)
    } else {
        let (before, own) = (length(last.curve.length()), length(next.contour.length()));
        codes::G3202::tool_does_not_fit_into_corner(&radius, &before, &own)
    };
    Box::new(at(next.origin, fault.alarm(next.rules.alarms.no_room)).also(last.origin.loc, Label::ElementBefore))
}

pub fn start_unknown(origin: &Origin) -> Refused {
    Box::new(at(*origin, codes::G3203::where_this_element_of_compensated_contour_lies()))
}

pub fn no_line(begins: bool, arc: bool, rules: &Compensation, origin: &Origin) -> Refused {
    let what = if begins { "begins" } else { "ends" };
    let fault = if arc {
        codes::G3203::radius_compensation_on_arc(&what)
    } else {
        codes::G3203::radius_compensation_in_block_that_does_not_move(&what)
    };
    Box::new(at(*origin, fault.alarm(rules.alarms.no_line)))
}

pub fn leaves_on_arc(arc: bool, origin: &Origin) -> Refused {
    let what = if arc { "an arc" } else { "a thread" };
    Box::new(at(*origin, codes::G3203::follows_compensated_contour(&what)))
}

pub fn no_contour(of: &Origin, origin: &Origin) -> Refused {
    let found = at(*origin, codes::G3204::radius_compensation_ends_before_contour_has_element());
    Box::new(found.also(of.loc, Label::CompensationBegins))
}

pub fn never_ends(of: &Origin) -> Refused {
    Box::new(at(*of, codes::G3204::radius_compensation_is_still_on_at_end()))
}

pub fn position_lost(origin: &Origin) -> Refused {
    Box::new(at(*origin, codes::G3203::position_of_tool_gets_lost_inside_compensated()))
}

pub fn too_much_between(origin: &Origin) -> Refused {
    Box::new(at(*origin, codes::G3205::too_many_blocks_without_move_in_plane()))
}

/// What may not stand in a contour at all.
#[inline]
pub fn admit(mv: &Move, origin: &Origin) -> Result<(), Refused> {
    let fault: fn() -> Fault = match &mv.path {
        _ if mv.machine => codes::G3205::block_in_machine_coordinates_stands_inside,
        Path::Thread { .. } => codes::G3205::thread_stands_inside,
        Path::Arc(arc, _) if arc.plane != mv.plane => codes::G3205::arc_outside_working_plane_stands_inside,
        Path::Rapid | Path::Line(_) | Path::Arc(..) | Path::Carried { .. } => return Ok(()),
    };
    Err(stands_inside(fault, origin))
}

#[cold]
fn stands_inside(fault: fn() -> Fault, origin: &Origin) -> Refused {
    Box::new(at(*origin, fault()))
}

pub fn plane_changes(rules: &Compensation, origin: &Origin) -> Refused {
    Box::new(at(*origin, codes::G3205::working_plane_changes_inside_contour().alarm(rules.alarms.plane)))
}

pub fn side_changes(side: bool, origin: &Origin) -> Refused {
    let what = if side { "the side" } else { "the radius" };
    Box::new(at(*origin, codes::G3205::of_compensation_changes_inside_contour(&what)))
}

pub fn constant_at_start(origin: &Origin) -> Refused {
    Box::new(at(*origin, codes::G3205::offset_is_held_constant_before_contour()))
}

pub fn no_feed(last: &Piece, next: &Piece) -> Refused {
    let found = at(next.origin, codes::G3206::arc_about_this_corner_lies_between_two());
    Box::new(found.also(last.origin.loc, Label::ElementBefore))
}

pub fn too_long(last: &Piece, next: &Piece, by: f64, most: f64) -> Refused {
    let found = at(last.origin, codes::G3207::elements_are_to_be_prolonged_by_mm(&length(by), &length(most)));
    Box::new(found.also(next.origin.loc, Label::ElementAfter))
}

pub fn around_otherwise(leaves: bool, origin: &Origin) -> Refused {
    let what = if leaves { "leaves" } else { "comes to" };
    Box::new(at(*origin, codes::G3208::tool_contour(&what)))
}

pub fn inside_circle(leaves: bool, rules: &Compensation, origin: &Origin) -> Refused {
    let (what, alarm) = if leaves { ("end", rules.alarms.end_inside) } else { ("start", rules.alarms.start_inside) };
    let fault = codes::G3208::of_way_lies_nearer_than_radius(&what, &length(rules.radius));
    Box::new(at(*origin, fault.alarm(alarm)))
}

pub fn left_out<'p>(gone: impl Iterator<Item = &'p Piece>, last: &Piece, next: &Piece) -> Refused {
    let gone: Vec<&Piece> = gone.collect();
    let radius = length(next.rules.radius);
    let fault = match gone[..] {
        [_] => codes::G3210::element_is_left_out(&radius),
        _ => codes::G3210::elements_are_left_out(&radius),
    };
    let mut found = at(next.origin, fault.alarm(next.rules.alarms.left_out));
    for piece in gone.iter().take(8) {
        found = found.also(piece.origin.loc, Label::LeftOut);
    }
    Box::new(found.also(last.origin.loc, Label::ElementBefore))
}

pub fn damaged(path: &Origin, contour: &Origin, radius: f64, refuses: bool) -> Refused {
    let radius = length(radius);
    let fault =
        if refuses { codes::G3202::tool_damages_contour(&radius) } else { codes::G3211::tool_damages_contour(&radius) };
    Box::new(at(*path, fault).also(contour.loc, Label::ThisElement))
}

pub fn offset_stays(at_point: Option<Point2>, plane: Plane, origin: &Origin) -> Refused {
    let (first, second, _) = plane.axes();
    let names = ["X", "Y", "Z"];
    let fault = match at_point {
        Some(p) => {
            let place = format!("{}{} {}{}", names[first], length(p.x), names[second], length(p.y));
            codes::G3212::radius_compensation_ends_where_tool_stays(&place)
        }
        None => codes::G3212::radius_compensation_ends_in_block_that_leaves(),
    };
    Box::new(at(*origin, fault))
}

/// Says once that a machine datum decides the corner which nobody gave.
pub fn open_turn(last: &Piece, next: &Piece, diags: &Diags) {
    let Some((above, up_to, ask)) = last.rules.outside.open else { return };
    let turn = joint::turn(last.headings.end, next.headings.start).abs();
    let meets = turn <= last.rules.outside.prolonged.radians();
    if turn <= above.radians() || turn > up_to.radians() || !diags.first_time(codes::G3215, meets) {
        return;
    }
    let degrees = length(turn.to_degrees());
    let fault = if meets {
        codes::G3215::paths_at_outside_corner_are_prolonged(&degrees)
    } else {
        codes::G3215::tool_goes_around_outside_corner(&degrees)
    };
    diags.push(at(last.origin, fault.help(ask.help())).also(next.origin.loc, Label::ElementAfter));
}

/// A corner that the block of `last` asks for, and that is none on the outside.
pub fn corner_without_effect(last: &Piece, next: &Piece, diags: &Diags) {
    if !last.rules.own_corner {
        return;
    }
    let found = at(last.origin, codes::G3218::m_function_for_corner_at_end_of_this_element());
    diags.push(found.also(next.origin.loc, Label::ElementAfter));
}

/// A corner that the last block of a contour asks for; `leaves` is the way off it.
pub fn last_corner(last: &Piece, leaves: &Origin, diags: &Diags) {
    if !last.rules.own_corner {
        return;
    }
    let found = at(last.origin, codes::G3218::m_function_for_corner_at_end());
    diags.push(found.also(leaves.loc, Label::ToolLeaves));
}

/// What no manual says about the joint in front of `next`.
pub fn reading(last: &Piece, next: &Piece, diags: &Diags) {
    let (before, behind) = (last.mv.path.feed(), next.mv.path.feed());
    let idle = |item: &Item| {
        matches!(item, Item::Function(Function::Comment(_) | Function::Remark(_) | Function::PathControl(_), _))
    };
    let moves = last.items.iter().any(|item| !idle(item));
    let fault = match (before != behind, moves) {
        (false, false) => return,
        (true, _) => codes::G3213::arc_about_corner_takes_its_feed(),
        (false, true) => codes::G3213::what_stands_between_happens_before_arc(),
    };
    diags.push_once(at(next.origin, fault).also(last.origin.loc, Label::ElementBefore));
}

/// The start or end of the way lies between the contour and its path, where controls may see it as behind or not.
pub fn nearly_behind(leaves: bool, origin: &Origin) -> Refused {
    let what = if leaves { "end" } else { "start" };
    Box::new(at(*origin, codes::G3214::of_way_lies_less_than_tool_radius(&what)))
}

/// A cycle works from where the tool stands, and that is not the programmed point.
#[cold]
pub fn cycle_beside(origin: &Origin) -> Option<Refused> {
    Some(Box::new(at(*origin, codes::G3205::cycle_is_called_while_tool_stands_beside())))
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
    let radii = [length(distance(own, center)), length(distance(from, center))];
    let fault = codes::G3216::f_is_printed_for_centre_of_tool(&radii[0], &radii[1]);
    diags.push(at(piece.origin, fault.help(ask.help())));
}
