//! Everything a program does besides moving. The same items pass through both languages.

use crate::geo::Plane;
use crate::machine::Axis;

use super::Transformation;

pub use crate::machine::PathControl;

/// Sense of rotation of a spindle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Turn {
    Clockwise,
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

/// What a spindle does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Spindle {
    Start(Turn),
    Stop,
    /// Speed in rev/min.
    Speed(f64),
    /// Constant cutting speed in m/min, up to a speed in rev/min.
    CuttingSpeed {
        speed: f64,
        limit: Option<f64>,
    },
    /// Stop at an angle in degrees.
    Orient(f64),
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Coolant {
    Mist,
    Flood,
    Off,
}

/// What radius compensation needs to know of the tool.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct CutterData {
    /// Number of the tool whose radius the target looks up.
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
    /// X, Y and Z of two corners.
    Cuboid { low: [f64; 3], high: [f64; 3] },
    /// Round about the line through zero along an axis, on which it lies between two places. Without a bore that is 0.
    Round { axis: Axis, radius: f64, bore: f64, low: f64, high: f64 },
}

/// What only those who show a program want to know: no machine hears of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Remark {
    /// A block was refused: from here on the program is known in parts.
    Refused,
    Blank(Blank),
}

/// Something other than a move.
#[derive(Debug, Clone, PartialEq)]
pub enum Function {
    /// Change to this tool; 0 empties the spindle.
    ToolChange {
        number: u32,
    },
    /// Tell the changer which tool comes next.
    ToolPrepare {
        number: u32,
    },
    Cutter(CutterData),
    Spindle(Spindle),
    /// Another spindle than the first.
    SpindleOf {
        number: u8,
        spindle: Spindle,
    },
    /// Feeds per revolution count the turns of this spindle from here on, 1 for the first. Lower carries it out.
    FeedSpindle(u8),
    /// The program sees other axes from here on, or again those of the machine. Lower carries it out.
    Transformation(Option<Transformation>),
    Coolant(Coolant),
    /// Wait, seconds.
    Dwell(f64),
    /// Program stop.
    Stop,
    OptionalStop,
    /// M function that is printed as it stands.
    Aux(u32),
    /// Work offset, 1 (G54) to 9 (G59.3), and on.
    WorkOffset(u8),
    /// Working plane, stated by the program.
    Plane(Plane),
    /// How corners are taken from here on; `None` where the program has no say any more: as at its start.
    PathControl(Option<PathControl>),
    /// Text of the source, any bytes.
    Comment(Vec<u8>),
    Remark(Remark),
    /// End of the program.
    End {
        rewind: bool,
    },
}
