//! What the lines of plain G-code have the machine do besides moving, in the words of everything behind the languages.

use crate::geo::Plane;
use crate::ir::function::{CutterData, PathControl, Spindle};
use crate::ir::{Feed, Function, Side};
use crate::read::{self, Act, FeedKind, Reader, SCALE, Speed};
use crate::sema::common::m_functions::standard;

/// The function of an act that is no move and chooses no tool.
///
/// # Errors
/// What the act lacks.
pub fn function(act: &Act) -> Result<Option<Function>, &'static str> {
    Ok(Some(match *act {
        Act::Move(_) | Act::Tap | Act::Select(_) | Act::Change => return Ok(None),
        Act::Speed(speed) if speed.value < 0 => return Err("a speed below zero"),
        Act::Speed(Speed { constant_cut: Some(Some(limit)), .. }) if limit <= 0 => {
            return Err("a limit of the speed that is not above zero");
        }
        Act::Speed(speed) => of_speed(speed),
        Act::M { number, spindle, angle } => m_function(number, spindle, angle)?,
        Act::Dwell(seconds) => Function::Dwell(real(seconds)),
        Act::Corners(mode) => Function::PathControl(Some(path_control(mode))),
        Act::Offset(number) => Function::WorkOffset(number),
        Act::Tilt(_) => return Err("a tilted working plane"),
    }))
}

fn path_control(mode: read::PathControl) -> PathControl {
    match mode {
        read::PathControl::Exact => PathControl::Exact,
        read::PathControl::Within(bound) => PathControl::Within(real(bound)),
        read::PathControl::Before(distance) => PathControl::Before(real(distance)),
        read::PathControl::Unbounded => PathControl::Unbounded,
    }
}

fn of_spindle(number: u8, spindle: Spindle) -> Function {
    match number {
        0 => Function::Spindle(spindle),
        _ => Function::SpindleOf { number: number.saturating_add(1), spindle },
    }
}

fn of_speed(speed: Speed) -> Function {
    let value = real(speed.value);
    let order = match speed.constant_cut {
        Some(limit) => Spindle::CuttingSpeed { speed: value, limit: limit.map(real) },
        None => Spindle::Speed(value),
    };
    of_spindle(speed.spindle, order)
}

fn m_function(number: u32, spindle: u8, angle: Option<i64>) -> Result<Function, &'static str> {
    Ok(match standard(number) {
        Some(Function::Spindle(order)) => of_spindle(spindle, order),
        Some(function) => function,
        None if number == 19 => of_spindle(spindle, Spindle::Orient(real(angle.ok_or("M19 without its angle")?))),
        None => Function::Aux(number),
    })
}

/// What the target needs to know of a cutter.
pub fn cutter(cutter: read::Cutter) -> Function {
    let radius = cutter.diameter.map(|diameter| real(diameter) / 2.0);
    Function::Cutter(CutterData { number: cutter.tool, radius, known: radius, edge: cutter.edge })
}

pub fn side(cutter: read::Cutter) -> Side {
    match cutter.side {
        1 => Side::Left,
        -1 => Side::Right,
        _ => Side::None,
    }
}

/// The feed that holds.
///
/// # Errors
/// There is none.
pub fn feed(reader: &Reader) -> Result<Feed, &'static str> {
    let feed = reader.feed().filter(|feed| *feed > 0).map(real).ok_or("a cut without a feed")?;
    match reader.modes().feed_kind {
        Some(FeedKind::PerMinute) => Ok(Feed::PerMinute(feed)),
        Some(FeedKind::PerRevolution) => Ok(Feed::PerRevolution(feed)),
        Some(FeedKind::InverseTime) => Ok(Feed::InverseTime(feed)),
        None => Err("it is not stated what the feed counts"),
    }
}

pub fn plane(plane: read::Plane) -> Plane {
    match plane {
        read::Plane::Xy => Plane::Xy,
        read::Plane::Zx => Plane::Zx,
        read::Plane::Yz => Plane::Yz,
    }
}

/// A number of the reader in mm, degrees, seconds.
pub fn real(units: i64) -> f64 {
    units as f64 / SCALE as f64
}
