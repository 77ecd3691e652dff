//! The blocks of a stored contour beside those that its records make.

use crate::geo::{Point2, arc, distance};

use super::made::{Contour, ContourBlock, CornerWord};

/// Where the blocks of a program and those of its records differ.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Difference {
    Start,
    /// The number of blocks.
    Count,
    /// End point of the block with this index.
    End(usize),
    /// Line or arc, centre, or sense.
    Arc(usize),
    /// Radius or chamfer at its end.
    Corner(usize),
}

/// Compares what is written with what the records make, within `tol` mm.
///
/// # Errors
/// The first difference, by the index into `made.blocks`.
pub(super) fn compare(start: Point2, written: &[ContourBlock], made: &Contour, tol: f64) -> Result<(), Difference> {
    if distance(start, made.start) > tol {
        return Err(Difference::Start);
    }
    for (i, (there, here)) in written.iter().zip(&made.blocks).enumerate() {
        if distance(there.end, here.end) > tol {
            return Err(Difference::End(i));
        }
        let from = i.checked_sub(1).and_then(|before| made.blocks.get(before)).map_or(made.start, |before| before.end);
        if !same_arc(from, there, here, tol) {
            return Err(Difference::Arc(i));
        }
        let same = match (there.corner, here.corner) {
            (None, None) => true,
            (Some(CornerWord::Radius(a)), Some(CornerWord::Radius(b)))
            | (Some(CornerWord::Chamfer(a)), Some(CornerWord::Chamfer(b))) => (a - b).abs() <= tol,
            _ => false,
        };
        if !same {
            return Err(Difference::Corner(i));
        }
    }
    if written.len() == made.blocks.len() { Ok(()) } else { Err(Difference::Count) }
}

/// A line, or an arc by the same centre, or by the same radius where that is what was written.
fn same_arc(from: Point2, there: &ContourBlock, here: &ContourBlock, tol: f64) -> bool {
    match (there.arc, there.radius, here.arc) {
        (None, None, None) => true,
        (Some((a, ccw)), None, Some((b, sense))) => ccw == sense && distance(a, b) <= tol,
        (_, Some(radius), Some((center, sense))) => {
            let ccw = there.arc.is_none_or(|(_, ccw)| ccw == sense);
            let sweep = arc::sweep(from, here.end, center, sense).abs();
            // Rounded points make a half circle a little shorter or longer.
            let half = distance(from, here.end) >= 2.0 * (radius.abs() - tol);
            let long = half || (sweep > core::f64::consts::PI) == (radius < 0.0);
            ccw && long && (radius.abs() - distance(center, here.end)).abs() <= tol
        }
        _ => false,
    }
}
