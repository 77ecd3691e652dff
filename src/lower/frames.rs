//! Pass 4: from programmed to workpiece coordinates. A mirror turns arcs and compensation around.

use crate::diag::{Code, codes};
use crate::geo::{Plane, Point2};
use crate::ir::frame::PlaneMap;
use crate::ir::{Frame, Pos, motion};
use crate::machine::Axis;

use super::step::{Path, Step};

/// What cannot be mapped: code and message.
type Unmapped = (&'static Code, String);

/// The move that `step` is in workpiece coordinates.
///
/// # Errors
/// An arc that is no arc any more, or an axis whose position is not known.
pub fn workpiece(step: &Step) -> Result<motion::Move, Unmapped> {
    let frame = &step.ctx.frame;
    let plane = step.ctx.plane;
    if step.machine || frame.is_identity() {
        let path = match step.path {
            Path::Rapid => motion::Path::Rapid,
            Path::Line => motion::Path::Line,
            Path::Arc { plane, center, sweep } => {
                let from = step.start.in_plane(plane).unwrap_or(center);
                motion::Path::Arc(motion::Arc { plane, from, center, sweep })
            }
        };
        return Ok(motion::Move {
            end: step.end,
            axes: step.axes,
            path,
            feed: step.feed,
            side: step.side,
            plane,
            machine: step.machine,
        });
    }
    mapped(step, frame, plane)
}

fn mapped(step: &Step, frame: &Frame, plane: Plane) -> Result<motion::Move, Unmapped> {
    let end = frame.apply(&step.end);
    let axes = frame.touched(step.axes);
    if let Some(axis) = axes.without(end.known()).iter().next() {
        return Err((codes::G3015, format!("under this rotation the block also moves {}, whose position is not known", axis.letter())));
    }
    let path = match step.path {
        Path::Rapid => motion::Path::Rapid,
        Path::Line => motion::Path::Line,
        Path::Arc { plane, center, sweep } => motion::Path::Arc(map_arc(step, frame, plane, center, sweep)?),
    };
    // Tilted working planes never get here with compensation on.
    let (plane, flips) = match frame.plane_map(plane) {
        PlaneMap::Similar { plane, flips, .. } => (plane, flips),
        PlaneMap::Uneven | PlaneMap::Tilted => (plane, frame.linear().determinant() < 0.0),
    };
    let side = if flips { step.side.mirrored() } else { step.side };
    Ok(motion::Move { end, axes, path, feed: step.feed, side, plane, machine: false })
}

fn map_arc(step: &Step, frame: &Frame, plane: Plane, center: Point2, sweep: f64) -> Result<motion::Arc, Unmapped> {
    let PlaneMap::Similar { plane: target, flips, .. } = frame.plane_map(plane) else {
        return Err(match frame.plane_map(plane) {
            PlaneMap::Uneven => (codes::G3011, "the axes of this arc have different scaling factors".to_owned()),
            _ => (codes::G3012, "the rotation turns this arc out of the main planes".to_owned()),
        });
    };
    let (_, _, third) = plane.axes();
    let map = |p: Point2| {
        let mut pos = Pos::UNKNOWN;
        pos.set_in_plane(plane, p);
        // The third axis does not matter in the plane, but the map wants it.
        pos.set(Axis::ALL[third], 0.0);
        frame.apply(&pos).in_plane(target).unwrap_or(p)
    };
    let from = step.start.in_plane(plane).map_or_else(|| map(center), map);
    Ok(motion::Arc { plane: target, from, center: map(center), sweep: if flips { -sweep } else { sweep } })
}
