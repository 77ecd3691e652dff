//! Why a pocket along a contour has no path.

use crate::diag::codes;
use crate::geo::{Element, distance, gap};
use crate::lower::cycles::track::Failure;

use super::walls::Walls;

/// A gap that differs from the width of the cutter by less is about as wide, mm.
const ABOUT: f64 = 0.02;

pub fn no_room() -> Failure {
    Failure::new(
        codes::G3321,
        "the cutter finds no room between the walls of the contour",
        "take a smaller cutter, or a smaller allowance",
    )
}

pub fn start_point() -> Failure {
    Failure::new(
        codes::G3321,
        "from the start point no straight way leads between the walls to where the rings begin",
        "give a start point farther from the walls, or leave the choice to the cycle",
    )
}

pub fn no_insertion(what: &str) -> Failure {
    Failure::new(codes::G3321, what, "take a smaller cutter, or go straight down, which needs a cutter that can plunge")
}

/// No rings could be made that are proved to lie at `away` from the walls: next to them, or farther inside.
pub fn unproved(walls: &Walls, away: f64) -> Failure {
    let what = "the rings along the contour do not keep their distance from it";
    match tight_place(walls.elements(), away) {
        Some(place) => Failure::new(
            codes::G3321,
            format!("{what}: {place}, and the cutter with its allowance takes {:.3} mm", 2.0 * away),
            "take a cutter or an allowance that is smaller, so that it passes there, or larger, so that it does not",
        ),
        None => Failure::new(
            codes::G3321,
            what,
            "move an end point of the contour a little, or take another infeed in the plane",
        ),
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
