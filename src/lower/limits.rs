//! Pass 4: travel limits, including the bulge of arcs.

use std::collections::BTreeMap;

use crate::diag::{Diags, codes};
use crate::geo::{Deg, Vec2, distance};
use crate::ir::Origin;
use crate::ir::motion::{Move, Path};
use crate::machine::Axis;

use super::at;

/// Reports an end point or an arc that leaves the limits.
pub fn check(mv: &Move, limits: &BTreeMap<Axis, (f64, f64)>, origin: Origin, diags: &Diags) {
    for (&axis, &(low, high)) in limits {
        if !mv.axes.contains(axis) {
            continue;
        }
        let (least, most) = extent(mv, axis);
        if least < low || most > high {
            let value = if least < low { least } else { most };
            diags.push(at(origin, codes::G3018::is_beyond_travel_limits(&axis.letter(), &value, &low, &high)));
        }
    }
}

/// Least and greatest coordinate on the way.
fn extent(mv: &Move, axis: Axis) -> (f64, f64) {
    let end = mv.end.get(axis).unwrap_or(0.0);
    let Path::Arc(arc, _) = &mv.path else { return (end, end) };
    let (first, second, _) = arc.plane.axes();
    let along = match axis.index() {
        i if i == first => 0.0,
        i if i == second => 90.0,
        _ => return (end, end),
    };
    let (start, center) = if along == 0.0 { (arc.from.x, arc.center.x) } else { (arc.from.y, arc.center.y) };
    let (mut least, mut most) = (end.min(start), end.max(start));
    let radius = distance(arc.from, arc.center);
    for (direction, value) in [(along, center + radius), (along + 180.0, center - radius)] {
        if passes(arc.from - arc.center, arc.sweep, Deg(direction)) {
            least = least.min(value);
            most = most.max(value);
        }
    }
    (least, most)
}

/// Does an arc that starts in direction `from` pass the direction `through`?
fn passes(from: Vec2, sweep: f64, through: Deg) -> bool {
    let way = through.0 - Deg::of(from).0;
    let way = Deg(if sweep > 0.0 { way } else { -way }).normal();
    way.radians() <= sweep.abs()
}
