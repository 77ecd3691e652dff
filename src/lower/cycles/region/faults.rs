//! Why a pocket along a contour has no path.

use crate::diag::{Fault, codes};
use crate::geo::{Element, clearance, distance};

use super::walls::Walls;

/// A gap that differs from the width of the cutter by less is about as wide, mm.
const ABOUT: f64 = 0.02;

pub fn no_room() -> Fault {
    codes::G3321::cutter_finds_no_room_between_walls()
}

pub fn start_point() -> Fault {
    codes::G3321::from_start_point_no_straight_way_leads()
}

/// No rings could be made that are proved to lie at `away` from the walls: next to them, or farther inside.
pub fn unproved(walls: &Walls, away: f64) -> Fault {
    tight_place(walls.elements(), 2.0 * away).unwrap_or_else(codes::G3321::rings_along_contour_do_not_keep)
}

/// A gap or an inside arc that is about as wide as the cutter `takes`.
fn tight_place(walls: &[Element], takes: f64) -> Option<Fault> {
    let is_tight = |width: f64| (width - takes).abs() <= ABOUT;
    for (at, a) in walls.iter().enumerate() {
        for b in &walls[..at] {
            let width = clearance::between(a, b);
            if is_tight(width) {
                let p = a.middle();
                return Some(codes::G3321::rings_do_not_keep_between_walls(&p.x, &p.y, &width, &takes));
            }
        }
    }
    walls.iter().find_map(|wall| match *wall {
        Element::Arc { from, center, .. } if is_tight(2.0 * distance(from, center)) => {
            let radius = distance(from, center);
            Some(codes::G3321::rings_do_not_keep_at_arc(&center.x, &center.y, &radius, &takes))
        }
        _ => None,
    })
}
