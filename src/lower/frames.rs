//! Pass 4: from programmed to workpiece coordinates. A mirror turns arcs and compensation around.

use std::borrow::Cow;

use crate::diag::{Code, codes};
use crate::geo::Point2;
use crate::ir::frame::PlaneMap;
use crate::ir::motion::{Arc, Move, Path};
use crate::ir::{Frame, Pos};
use crate::machine::Axis;

use super::step::Step;

/// What cannot be mapped: code and message.
type Unmapped = (&'static Code, String);

/// The move that `step` is in workpiece coordinates.
///
/// # Errors
/// An arc that is no arc any more, or an axis whose position is not known.
#[inline]
pub fn workpiece(step: &Step) -> Result<Cow<'_, Move>, Unmapped> {
    let frame = &step.ctx.frame;
    if step.mv.machine || frame.is_identity() {
        return Ok(Cow::Borrowed(&step.mv));
    }
    mapped(&step.mv, frame).map(Cow::Owned)
}

fn mapped(mv: &Move, frame: &Frame) -> Result<Move, Unmapped> {
    let end = frame.apply(&mv.end);
    let axes = frame.touched(mv.axes);
    if let Some(axis) = axes.without(end.known()).iter().next() {
        let message =
            format!("under this rotation the block also moves {}, whose position is not known", axis.letter());
        return Err((codes::G3015, message));
    }
    let path = match &mv.path {
        Path::Arc(arc) => Path::Arc(map_arc(arc, frame)?),
        Path::Thread { lead } => match frame.uniform_scale() {
            Some(scale) => Path::Thread { lead: lead * scale },
            None => return Err((codes::G3022, "the axes of this thread have different scaling factors".to_owned())),
        },
        straight => *straight,
    };
    // Tilted working planes never get here with compensation on.
    let (plane, flips) = match frame.plane_map(mv.plane) {
        PlaneMap::Similar { plane, flips, .. } => (plane, flips),
        PlaneMap::Uneven | PlaneMap::Tilted => (mv.plane, frame.linear().determinant() < 0.0),
    };
    let side = if flips { mv.side.mirrored() } else { mv.side };
    Ok(Move { end, axes, path, side, plane, ..*mv })
}

fn map_arc(arc: &Arc, frame: &Frame) -> Result<Arc, Unmapped> {
    let (plane, flips) = match frame.plane_map(arc.plane) {
        PlaneMap::Similar { plane, flips, .. } => (plane, flips),
        PlaneMap::Uneven => {
            return Err((codes::G3011, "the axes of this arc have different scaling factors".to_owned()));
        }
        PlaneMap::Tilted => {
            return Err((codes::G3012, "the rotation turns this arc out of the main planes".to_owned()));
        }
    };
    let (_, _, third) = arc.plane.axes();
    let map = |p: Point2| {
        let mut pos = Pos::UNKNOWN;
        pos.set_in_plane(arc.plane, p);
        // The third axis does not matter in the plane, but the map wants it.
        pos.set(Axis::ALL[third], 0.0);
        frame.apply(&pos).in_plane(plane).unwrap_or(p)
    };
    let sweep = if flips { -arc.sweep } else { arc.sweep };
    Ok(Arc { plane, from: map(arc.from), center: map(arc.center), sweep })
}
