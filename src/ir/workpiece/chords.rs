//! Arcs that lie in no main plane, as lines.

use core::f64::consts::{FRAC_PI_2, TAU};

use crate::geo::{distance, turned};
use crate::ir::motion::{Arc, Move, Path};
use crate::ir::{Feed, Pos};

/// How far a chord leaves its arc at most, mm.
pub const TOLERANCE: f64 = 0.005;
/// Chords of one arc, so that a run ends. Of an arc with more whole turns are left out; the others lie on the circle, and the
/// ends are its own.
const MOST: f64 = 65_536.0;

/// Gives the lines of an arc that begins at `start`. The ends of the arc are exact.
pub(super) fn of(arc: &Arc, feed: Feed, mv: &Move, start: &Pos, take: &mut dyn FnMut(&Move)) {
    let (count, sweep) = division(arc);
    let feed = match feed {
        // As many moves as there are chords take the time of one.
        Feed::InverseTime(moves) => Feed::InverseTime(moves * f64::from(count)),
        Feed::PerMinute(_) | Feed::PerRevolution(_) => feed,
    };
    for chord in 1..count {
        let share = f64::from(chord) / f64::from(count);
        let end = between(arc, mv, start, share, sweep);
        take(&Move { end, axes: mv.axes.common(end.known()), path: Path::Line(feed), ..*mv });
    }
    take(&Move { path: Path::Line(feed), ..*mv });
}

/// How many chords, and the sweep that they cover.
fn division(arc: &Arc) -> (u32, f64) {
    let radius = distance(arc.from, arc.center);
    // A chord over the angle 2h leaves the circle by r (1 - cos h) = 2 r sin² (h / 2).
    let step = 4.0 * libm::asin(libm::sqrt(TOLERANCE / 2.0 / radius.max(TOLERANCE)));
    let step = step.min(FRAC_PI_2);
    let turns = libm::floor(arc.sweep.abs() / TAU);
    let kept = libm::floor(MOST * step / TAU).max(1.0);
    let left_out = (turns - kept).max(0.0) * TAU;
    let sweep = arc.sweep - left_out.copysign(arc.sweep);
    let count = libm::ceil(sweep.abs() / step).clamp(1.0, 2.0 * MOST);
    (count as u32, sweep)
}

/// The place after a share of the arc; what is not known at both ends is not known between them.
fn between(arc: &Arc, mv: &Move, start: &Pos, share: f64, sweep: f64) -> Pos {
    let mut at = Pos::UNKNOWN;
    for (axis, end) in mv.end.iter() {
        if !mv.axes.contains(axis) {
            at.set(axis, end);
        } else if let Some(from) = start.get(axis) {
            at.set(axis, from + (end - from) * share);
        }
    }
    at.set_in_plane(arc.plane, arc.center + turned(arc.from - arc.center, sweep * share));
    at
}
