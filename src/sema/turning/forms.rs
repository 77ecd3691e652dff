//! Recesses on a straight element: G22-Geo and G23-Geo.
//!
//! Source: T 6.3 (docs/sources.md).

use crate::diag::{Fault, codes};
use crate::geo::{Element, Point2, SAME_DIRECTION, Vec2, direction, left};

use super::chain::Solved;
use super::element_data::Transition;

/// How far the reference element may be from an axis-parallel line, in mm.
const PARALLEL: f64 = 1e-6;

/// A recess as programmed; mm, X as a radius.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Recess {
    /// G22 with Z: in a cylinder, from `first` to `second` along Z, floor at the radius `floor`.
    Cylinder { first: f64, second: f64, floor: f64, top: Transition, base: f64 },
    /// G22 with X: in a face, from `first` to `second` along X, floor at the Z `floor`.
    Face { first: f64, second: f64, floor: f64, top: Transition, base: f64 },
    /// G23: symmetric. The opening is `width` wide; each flank leans inwards by `lean` mm for each mm of depth.
    Centered { at: Along, width: f64, lean: f64, depth: f64, near: Transition, far: Transition, base: f64 },
}

/// Where the middle of a recess lies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Along {
    Z(f64),
    X(f64),
}

/// A recess on its element.
#[derive(Debug, Clone)]
pub(super) struct Made {
    /// Where the element is left, and where it goes on.
    pub from: Point2,
    pub to: Point2,
    /// How it goes over at both top edges.
    pub edges: (Transition, Transition),
    pub elements: Vec<(Element, Transition)>,
}

/// Puts the recess on the element.
pub(super) fn build(recess: &Recess, line: &Solved) -> Result<Made, Fault> {
    let Some(u) = direction(line.to - line.from, 0.0).filter(|_| line.arc.is_none()) else {
        return Err(codes::T3004::recess_belongs_to_straight_element());
    };
    match *recess {
        Recess::Cylinder { first, second, floor, top, base } => {
            if u.y.abs() > PARALLEL {
                return Err(codes::T3004::recess_needs_line_along_z());
            }
            let r = line.from.y;
            let (a, b) = in_order(first, second, u.x);
            let p = Point2::new;
            made([p(a, r), p(a, floor), p(b, floor), p(b, r)], top, top, base)
        }
        Recess::Face { first, second, floor, top, base } => {
            if u.x.abs() > PARALLEL {
                return Err(codes::T3004::recess_needs_line_along_x());
            }
            let z = line.from.x;
            let (a, b) = in_order(first, second, u.y);
            let p = |x, z| Point2::new(z, x);
            made([p(a, z), p(a, floor), p(b, floor), p(b, z)], top, top, base)
        }
        Recess::Centered { at, width, lean, depth, near, far, base } => {
            let middle = middle(at, line.from, u).ok_or_else(codes::T3004::middle_of_recess_lies_beside_its_element)?;
            // A positive depth lies right of the element, seen in its direction.
            let down = -left(u) * depth;
            let half: Vec2 = u * (width / 2.0);
            let foot: Vec2 = u * (width / 2.0 - lean * depth.abs());
            if foot.dot(&u) <= PARALLEL {
                return Err(codes::T3004::flanks_of_recess_meet());
            }
            made([middle - half, middle - foot + down, middle + foot + down, middle + half], near, far, base)
        }
    }
}

fn in_order(a: f64, b: f64, sense: f64) -> (f64, f64) {
    if (b - a) * sense >= 0.0 { (a, b) } else { (b, a) }
}

fn middle(at: Along, from: Point2, u: Vec2) -> Option<Point2> {
    let t = match at {
        Along::Z(z) if u.x.abs() > SAME_DIRECTION => (z - from.x) / u.x,
        Along::X(x) if u.y.abs() > SAME_DIRECTION => (x - from.y) / u.y,
        _ => return None,
    };
    Some(from + u * t)
}

fn made(corners: [Point2; 4], near: Transition, far: Transition, base: f64) -> Result<Made, Fault> {
    let [a, b, c, d] = corners;
    if crate::geo::distance(a, b) <= PARALLEL || crate::geo::distance(b, c) <= PARALLEL {
        return Err(codes::T3004::recess_has_no_depth_or_width());
    }
    let round = if base > 0.0 { Transition::Rounding(base) } else { Transition::Sharp };
    let line = |from, to| Element::Line { from, to };
    Ok(Made {
        from: a,
        to: d,
        edges: (near, far),
        elements: vec![(line(a, b), round), (line(b, c), round), (line(c, d), far)],
    })
}
