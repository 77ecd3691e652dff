//! Everything a program does besides moving. The same items pass through both languages.

use crate::geo::Plane;
use crate::machine::Axis;

use super::{Tilting, Transformation};

pub use crate::machine::PathControl;

/// Sense of rotation of a spindle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Turn {
    /// M3: a tap for a right-hand thread goes in with it.
    Clockwise,
    /// M4: a tap for a left-hand thread goes in with it.
    CounterClockwise,
}

impl Turn {
    /// The other way round.
    pub fn reversed(self) -> Turn {
        match self {
            Turn::Clockwise => Turn::CounterClockwise,
            Turn::CounterClockwise => Turn::Clockwise,
        }
    }
}

/// What a spindle does. Numbers are finite, speeds not below zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Spindle {
    /// It turns in this sense, at the speed that was said last.
    Start(Turn),
    /// It stands.
    Stop,
    /// Speed in rev/min.
    Speed(f64),
    /// Constant cutting `speed` in m/min, up to the `limit` in rev/min; `None` for no limit.
    CuttingSpeed { speed: f64, limit: Option<f64> },
    /// Stop at an angle in degrees.
    Orient(f64),
}

/// What the coolant does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Coolant {
    /// M7.
    Mist,
    /// M8.
    Flood,
    /// M9: both are off.
    Off,
}

/// What radius compensation needs to know of the tool.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct CutterData {
    /// Number of the tool whose radius the target looks up, as it is printed; 0 for none.
    pub number: u32,
    /// Radius in mm where the program changes it (oversizes), so that the target's own must not be used.
    pub radius: Option<f64>,
    /// Radius in mm as far as the program or its surroundings tell it: for checks only.
    pub known: Option<f64>,
    /// Where the edge points to from the centre of its nose, along Z and X, where `radius` is that of a turning tool: -1, 0 or 1
    /// each. No way at all where the centre is what is programmed.
    pub edge: [i8; 2],
}

/// The material that a program begins with, in coordinates of the workpiece, mm. Each side is longer than nothing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Blank {
    /// X, Y and Z of two corners: `low` has the smaller coordinate of each axis, `high` the greater one.
    Cuboid { low: [f64; 3], high: [f64; 3] },
    /// Round about the line through zero along `axis`, on which it lies between the coordinates `low` and `high`;
    /// `radius` outside, `bore` inside, which is 0 without a bore.
    Round { axis: Axis, radius: f64, bore: f64, low: f64, high: f64 },
}

/// What only those who show a program want to know: no machine hears of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Remark {
    /// A block was refused: from here on the program is known in parts.
    Refused,
    /// The program says with which material it begins.
    Blank(Blank),
}

/// Something other than a move.
#[derive(Debug, Clone, PartialEq)]
pub enum Function {
    /// Change to the tool `number`, as it is printed; 0 empties the spindle. Positions that were said before it no
    /// longer hold.
    ToolChange { number: u32 },
    /// Tell the changer that the tool `number`, as it is printed, comes next.
    ToolPrepare { number: u32 },
    /// What radius compensation takes of the tool from here on.
    Cutter(CutterData),
    /// The first spindle.
    Spindle(Spindle),
    /// What a spindle other than the first does, `spindle`; `number` counts from 1.
    SpindleOf { number: u8, spindle: Spindle },
    /// Feeds per revolution count the turns of this spindle from here on, 1 for the first. Lower carries it out.
    FeedSpindle(u8),
    /// The program sees other axes from here on, or again those of the machine. Lower carries it out.
    Transformation(Option<Transformation>),
    /// The working plane is tilted, or is so no more. Positions that were said before it no longer hold. Nothing is compensated.
    Tilt(Box<Tilting>),
    /// Coolant on or off.
    Coolant(Coolant),
    /// Wait, seconds, not below zero.
    Dwell(f64),
    /// Program stop, M0.
    Stop,
    /// Stop where the operator has asked for it, M1.
    OptionalStop,
    /// M function of this number that is printed as it stands.
    Aux(u32),
    /// Work offset, 1 (G54) to 9 (G59.3), and on. Positions that were said before it no longer hold.
    WorkOffset(u8),
    /// Working plane, stated by the program.
    Plane(Plane),
    /// How corners are taken from here on; `None` where the program has no say any more: as at its start.
    PathControl(Option<PathControl>),
    /// Text of the source, any bytes.
    Comment(Vec<u8>),
    /// For those who show the program; nothing is printed of it.
    Remark(Remark),
    /// End of the program; with `rewind` back to its start (M30), else without (M2).
    End { rewind: bool },
}
