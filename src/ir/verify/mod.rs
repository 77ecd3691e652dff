//! Checks what the streams promise. A fault is a defect of the compiler, never of a program.
//!
//! In debug builds and tests [`Contour`] stands between sema and lower, [`Chain`] looks at every step between the
//! passes of lower, and [`Motion`] stands between lower and emit.

mod contour;
mod motion;
#[cfg(test)]
mod tests;

use nalgebra::Matrix3;

use crate::machine::Axis;

use super::function::{PathControl, Spindle};
use super::transformation::Surface;
use super::{Feed, Function, Pos, Tilt};

pub use contour::Contour;
pub use motion::{Chain, Motion, element};

/// How far a point may be off, relative to the size of what it belongs to, in mm.
const TOLERANCE: f64 = 1e-6;
/// Whole turns of an arc that can be counted.
const MOST_TURNS: f64 = u32::MAX as f64;

/// What a stream promises and an item breaks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fault {
    /// A number is infinite or none.
    NotFinite,
    /// A move names no axis.
    NoAxis,
    /// A move is about an axis that has no end.
    NoEnd(Axis),
    /// The feed of a cutting move or corner is not above zero.
    Feed,
    /// The lead of a thread is not above zero.
    Lead,
    /// An arc or thread in machine coordinates, or a position that is not the machine's.
    Machine,
    /// An axis that the move is not about ends elsewhere than it was.
    Unnamed(Axis),
    /// The element does not start where the one before ended.
    Gap(Axis),
    /// The arc has no start or end in its plane.
    NotInPlane,
    /// The arc does not start where its plane says.
    ArcStart,
    /// Start or end lies in the centre.
    NoRadius,
    /// Start and end lie differently far from the centre.
    Radius,
    /// The sweep is none, or more than can be counted.
    Turns,
    /// Centre and sweep lead elsewhere than to the end.
    Sweep,
    /// The radius of the arc, its opening or the tolerance of its ends is out of range.
    Shape,
    /// A chamfer or rounding without a size.
    Corner,
    /// A time, speed or radius below zero.
    Function,
    /// The axes of a tilted plane are none.
    Tilt,
    /// A tap that does not begin where the tool stands, or does not go in and out.
    Tap,
    /// Where axes stand is said after the first move.
    Late,
    /// The description of a contour begins twice, or ends before it begins.
    Description,
}

/// Stops the compiler at a defect.
fn hold(kept: Result<(), Fault>, item: &impl std::fmt::Debug) {
    assert!(kept.is_ok(), "{kept:?}: {item:?}");
}

fn ensure(holds: bool, fault: Fault) -> Result<(), Fault> {
    if holds { Ok(()) } else { Err(fault) }
}

fn finite(numbers: &[f64]) -> Result<(), Fault> {
    ensure(numbers.iter().all(|v| v.is_finite()), Fault::NotFinite)
}

fn finite_pos(pos: &Pos) -> Result<(), Fault> {
    ensure(pos.iter().all(|(_, v)| v.is_finite()), Fault::NotFinite)
}

fn feed(feed: Feed) -> Result<(), Fault> {
    finite(&[feed.value()])?;
    ensure(feed.value() > 0.0, Fault::Feed)
}

fn lead(lead: f64) -> Result<(), Fault> {
    finite(&[lead])?;
    ensure(lead > 0.0, Fault::Lead)
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= TOLERANCE * (1.0 + a.abs().max(b.abs()))
}

/// Numbers of a function; it is the same in both streams.
fn function(function: &Function) -> Result<(), Fault> {
    let amount = match function {
        Function::Cutter(cutter) => return finite(&[cutter.radius.unwrap_or(0.0), cutter.known.unwrap_or(0.0)]),
        Function::Transformation(by) => {
            return match by.map(|by| by.surface) {
                Some(Surface::Mantle { diameter }) => lead(diameter),
                Some(Surface::Face) | None => Ok(()),
            };
        }
        Function::Tilt(tilting) => return tilting.plane().map_or(Ok(()), tilt),
        Function::PathControl(Some(PathControl::Within(mm) | PathControl::Before(mm))) => return lead(*mm),
        Function::PathControl(_) => return Ok(()),
        Function::Dwell(seconds) => *seconds,
        Function::Spindle(spindle) | Function::SpindleOf { spindle, .. } => match spindle {
            Spindle::Start(_) | Spindle::Stop => return Ok(()),
            Spindle::Speed(speed) => *speed,
            Spindle::CuttingSpeed { speed, limit } => speed.min(limit.unwrap_or(*speed)),
            Spindle::Orient(angle) => return finite(&[*angle]),
        },
        Function::ToolChange { .. }
        | Function::ToolPrepare { .. }
        | Function::FeedSpindle(_)
        | Function::Coolant(_)
        | Function::Stop
        | Function::OptionalStop
        | Function::Aux(_)
        | Function::WorkOffset(_)
        | Function::Plane(_)
        | Function::Comment(_)
        | Function::Remark(_)
        | Function::End { .. } => return Ok(()),
    };
    finite(&[amount])?;
    ensure(amount >= 0.0, Fault::Function)
}

/// Are the axes of the plane of unit length, at right angles and right-handed?
fn tilt(tilt: &Tilt) -> Result<(), Fault> {
    let numbers: Vec<f64> = tilt.axes.iter().chain(tilt.origin.iter()).copied().collect();
    finite(&numbers)?;
    let off = tilt.axes * tilt.axes.transpose() - Matrix3::identity();
    let square = off.iter().all(|v| v.abs() <= TOLERANCE);
    ensure(square && tilt.axes.determinant() > 0.0, Fault::Tilt)
}

/// Does `function` leave open where the tool tip is?
fn displaces(function: &Function) -> bool {
    matches!(
        function,
        Function::WorkOffset(_) | Function::ToolChange { .. } | Function::Transformation(_) | Function::Tilt(_)
    )
}
