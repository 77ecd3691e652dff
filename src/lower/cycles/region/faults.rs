//! Why a pocket along a contour has no path.

use crate::diag::codes;
use crate::geo::{Element, distance, gap};
use crate::lower::cycles::track::Failure;

use super::walls::Walls;

/// A gap that differs from the width of the cutter by less is about as wide, mm.
const ABOUT: f64 = 0.02;

pub fn no_room() -> Failure {
    Failure::of(codes::G3321::cutter_finds_no_room_between_walls())
}

pub fn start_point() -> Failure {
    Failure::of(codes::G3321::from_start_point_no_straight_way_leads())
}

pub fn no_insertion(what: &str) -> Failure {
    Failure::new(codes::G3321, what, "take a smaller cutter, or go straight down, which needs a cutter that can plunge")
}

/// No rings could be made that are proved to lie at `away` from the walls: next to them, or farther inside.
pub fn unproved(walls: &Walls, away: f64) -> Failure {
    let what = "the rings along the contour do not keep their distance from it";
    match tight_place(walls.elements(), away) {
        Some(place) => Failure::of(codes::G3321::cutter_with_its_allowance_takes_mm(&what, &place, &(2.0 * away))),
        None => Failure::of(codes::G3321::rings_along_contour_do_not_keep()),
    }
}

/// A gap or an inside arc that is about as wide as the cutter.
fn tight_place(walls: &[Element], away: f64) -> Option<String> {
    let is_tight = |width: f64| (width - 2.0 * away).abs() <= ABOUT;
    for (at, a) in walls.iter().enumerate() {
        for b in &walls[..at] {
            let width = gap::between(a, b);
            if is_tight(width) {
                let p = a.middle();
                return Some(format!("the walls next to ({:.3}, {:.3}) are {width:.3} mm apart", p.x, p.y));
            }
        }
    }
    walls.iter().find_map(|wall| match *wall {
        Element::Arc { from, center, .. } if is_tight(2.0 * distance(from, center)) => {
            let radius = distance(from, center);
            Some(format!("the arc about ({:.3}, {:.3}) has a radius of {radius:.3} mm", center.x, center.y))
        }
        _ => None,
    })
}
