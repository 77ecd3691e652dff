//! The path of the nose beside an undercut, in the frame of the corner.

use crate::diag::{Fault, codes};
use crate::geo::offset::{self, NoParallel};
use crate::geo::tolerance;
use crate::geo::{Element, Point2, Vec2, cross, distance, left};
use crate::ir::cycle::UndercutCycle;

/// An undercut with the slope prolonged to where the tool comes in, and the face to where it leaves.
pub(super) struct Outline {
    pub elements: Vec<Element>,
    /// Where the slope meets the cylinder, and the direction in which it rises there.
    pub begin: Point2,
    pub slope: Vec2,
}

/// A rounding that is larger than the nose by less is the nose's own, mm: what lies between them in a corner is less than half of it.
const AS_LARGE: f64 = 1e-3;
/// Sine of the angle between lines that are one.
const SAME_WAY: f64 = 1e-9;

/// The way of the programmed point along the outline. A nose of radius 0 goes along it itself. A rounding that the nose makes
/// by itself becomes a corner; so does a smaller one where the cut does not finish.
///
/// # Errors
/// G3049 for a nose that does not fit into the finished undercut.
pub(super) fn path(cycle: &UndercutCycle, outline: &Outline, finishes: bool) -> Result<Vec<Element>, Fault> {
    let radius = cycle.nose.radius;
    if radius == 0.0 {
        return Ok(outline.elements.clone());
    }
    let contour = cornered(joined(&outline.elements), radius, finishes);
    // The tool is on the right: the frame runs from the cylinder to the face.
    let parallel = offset::parallel(&contour, -radius).map_err(|why| no_room(&contour, radius, why))?;
    let mut list: Vec<Element> = parallel.iter().map(|part| part.element).collect();
    let beside = outline.begin + left(outline.slope) * radius;
    if let Some(Element::Line { from, to }) = list.first().copied()
        && (from - beside).dot(&(beside - to)) > tolerance::SAME
    {
        // What lies in front of the undercut and what lies in it.
        list.splice(0..1, [Element::Line { from, to: beside }, Element::Line { from: beside, to }]);
    }
    Ok(offset::shifted(&list, cycle.tip()))
}

/// The approach and the slope are one line.
fn joined(elements: &[Element]) -> Vec<Element> {
    let mut list = elements.to_vec();
    if let [approach @ Element::Line { .. }, slope @ Element::Line { .. }, ..] = list[..]
        && let (Some(u), Some(w)) = (approach.end_direction(), slope.start_direction())
        && cross(u, w).abs() < SAME_WAY
    {
        list.splice(0..2, [slope.starting_at(approach.from())]);
    }
    list
}

/// The contour without the hollow roundings that are as large as the nose, or not larger where the cut does not finish.
fn cornered(mut list: Vec<Element>, radius: f64, finishes: bool) -> Vec<Element> {
    let mut at = 1;
    while at + 1 < list.len() {
        if let [before @ Element::Line { .. }, Element::Arc { from, center, sweep, .. }, after @ Element::Line { .. }] =
            list[at - 1..=at + 1]
        {
            let larger = radius - distance(from, center);
            if sweep < 0.0 && larger > -AS_LARGE && (larger < tolerance::SAME || !finishes) {
                let corner = corner(&before, from, center, sweep);
                list.splice(at - 1..=at + 1, [before.ending_at(corner), after.starting_at(corner)]);
                continue;
            }
        }
        at += 1;
    }
    list
}

/// Where the tangents at both ends of a rounding meet.
fn corner(before: &Element, from: Point2, center: Point2, sweep: f64) -> Point2 {
    let tangent = distance(from, center) * libm::tan(sweep.abs() / 2.0);
    from + before.end_direction().map_or_else(Vec2::zeros, |way| way * tangent)
}

fn no_room(contour: &[Element], radius: f64, why: NoParallel) -> Fault {
    let hollow = contour.iter().filter_map(|element| match *element {
        Element::Arc { from, center, sweep, .. } if sweep < 0.0 => Some(distance(from, center)),
        _ => None,
    });
    let least = hollow.fold(f64::INFINITY, f64::min);
    match why {
        NoParallel::TooNarrow | NoParallel::Reversal if least < radius => {
            codes::G3049::nose_radius_is_larger_than_rounding(&radius, &least)
        }
        NoParallel::TooNarrow | NoParallel::Reversal | NoParallel::Empty => {
            codes::G3049::nose_has_no_room_in_undercut(&radius)
        }
    }
}
