//! Pass 3: from programmed to workpiece coordinates. A mirror turns arcs and compensation around.

use crate::diag::{Fault, codes};
use crate::geo::Point2;
use crate::ir::frame::PlaneMap;
use crate::ir::motion::{Arc, Move, Path};
use crate::ir::{Frame, Pos};
use crate::machine::{Axis, AxisSet};

/// A move of `frame` in workpiece coordinates.
///
/// # Errors
/// An arc that is no arc any more, or an axis whose position is not known.
pub fn workpiece(mv: &Move, frame: &Frame) -> Result<Move, Fault> {
    let end = frame.apply(&mv.end);
    let axes = frame.touched(mv.axes);
    if !axes.without(end.known()).is_empty() {
        return Err(position_missing(mv, frame, axes));
    }
    let path = match &mv.path {
        Path::Arc(arc, feed) => Path::Arc(map_arc(arc, frame)?, *feed),
        Path::Thread { lead } => match frame.uniform_scale() {
            Some(scale) => Path::Thread { lead: lead * scale },
            None => return Err(codes::G3022::axes_of_this_thread_have_different_scaling()),
        },
        straight @ (Path::Rapid | Path::Line(_) | Path::Carried { .. }) => *straight,
    };
    // Tilted working planes never get here with compensation on.
    let (plane, flips) = match frame.plane_map(mv.plane) {
        PlaneMap::Similar { plane, flips, .. } => (plane, flips),
        PlaneMap::Uneven | PlaneMap::Tilted => (mv.plane, frame.linear().determinant() < 0.0),
    };
    let side = if flips { mv.side.mirrored() } else { mv.side };
    Ok(Move { end, axes, path, side, plane, ..*mv })
}

/// Under a rotation the target depends on axes of which the program never said where they are.
#[cold]
fn position_missing(mv: &Move, frame: &Frame, axes: AxisSet) -> Fault {
    let unknown = AxisSet::MAIN.without(mv.end.known());
    let missing = unknown
        .iter()
        .filter(|from| axes.iter().any(|to| to.is_main() && frame.linear()[(to.index(), from.index())] != 0.0));
    let missing: AxisSet = missing.collect();
    let list = |axes: AxisSet| axes.iter().map(|axis| axis.letter().to_string()).collect::<Vec<_>>().join(" and ");
    codes::G3015::under_this_rotation_target_depends(&list(mv.axes), &list(missing))
}

fn map_arc(arc: &Arc, frame: &Frame) -> Result<Arc, Fault> {
    let (plane, flips) = match frame.plane_map(arc.plane) {
        PlaneMap::Similar { plane, flips, .. } => (plane, flips),
        PlaneMap::Uneven => return Err(codes::G3011::axes_of_this_arc_have_different_scaling()),
        PlaneMap::Tilted => return Err(codes::G3012::rotation_turns_this_arc_out_of_planes()),
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
