//! What a target is made of: its words, their forms, its limits.
//!
//! `None` stands where the target has no word: what needs it is refused, never said in another way that is not exact.

use crate::geo::Plane;

/// A receiver of plain G-code.
#[derive(Debug)]
pub struct Target {
    /// Name in `--target`, in the configuration and in the head of the output.
    pub name: &'static str,
    /// The receiver in a few words.
    pub about: &'static str,
    /// Extension of output files.
    pub extension: &'static str,
    pub frame: Frame,
    pub comments: Comments,
    pub line: Line,
    /// Letters of the axes.
    pub axes: &'static str,
    pub motion: Motion,
    pub feed: FeedWords,
    pub arcs: Arcs,
    pub spindle: SpindleWords,
    pub coolant: CoolantWords,
    pub tool: ToolWords,
    pub dwell: Dwell,
    pub flow: Flow,
    /// Work offsets in order, from G54 on.
    pub offsets: &'static [&'static str],
    pub compensation: Option<CompensationWords>,
    pub m: MFunctions,
}

impl PartialEq for Target {
    fn eq(&self, other: &Target) -> bool {
        self.name == other.name
    }
}

impl Eq for Target {}

/// What stands around the program, and the modes stated at its start.
#[derive(Debug)]
pub struct Frame {
    pub first: Option<&'static str>,
    pub last: Option<&'static str>,
    /// Modes that hold on every machine.
    pub head: &'static [&'static str],
    pub mill: &'static str,
    /// On a lathe, with X as a radius.
    pub lathe: &'static str,
    /// On a lathe, with X as a diameter.
    pub lathe_diameter: Option<&'static str>,
}

/// How comments look.
#[derive(Debug)]
pub struct Comments {
    pub open: &'static str,
    pub close: &'static str,
    /// Characters the receiver acts on even inside a comment: printed as a point.
    pub forbidden: &'static [u8],
}

/// Limits of one line.
#[derive(Debug, Clone, Copy)]
pub struct Line {
    /// Longest line, end of line not counted.
    pub length: usize,
    /// Most digits of a number that are read; 0 for any.
    pub digits: u32,
}

/// Straight moves, planes, coordinates of the machine.
#[derive(Debug)]
pub struct Motion {
    pub rapid: &'static str,
    pub line: &'static str,
    /// In front of a move in machine coordinates.
    pub machine: &'static str,
    /// Line in step with the spindle, and the address of its lead.
    pub thread: Option<(&'static str, u8)>,
    /// XY, ZX, YZ.
    pub planes: [&'static str; 3],
}

impl Motion {
    pub fn plane(&self, plane: Plane) -> &'static str {
        match plane {
            Plane::Xy => self.planes[0],
            Plane::Zx => self.planes[1],
            Plane::Yz => self.planes[2],
        }
    }
}

/// Feeds and their kinds.
#[derive(Debug)]
pub struct FeedWords {
    pub address: u8,
    pub per_minute: &'static str,
    pub per_revolution: Option<&'static str>,
    pub inverse_time: Option<&'static str>,
    /// What F counts in a move of linear and rotary axes together.
    pub measure: Measure,
}

/// What a feed per minute counts where linear and rotary axes move together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Measure {
    /// The way of X, Y and Z; where none of them moves, the degrees of the rotary axes.
    Linear,
}

/// Arcs by offset from the start to the centre.
#[derive(Debug)]
pub struct Arcs {
    pub clockwise: &'static str,
    pub counter_clockwise: &'static str,
    /// Addresses of the centre, by axis.
    pub center: [u8; 3],
    /// Address of the number of turns in one block; `None`: an arc is divided at `most_sweep`.
    pub turns: Option<u8>,
    /// Largest sweep of a block in rad where it cannot count turns.
    pub most_sweep: f64,
    /// Largest difference of the radii at start and end of a printed arc, in units of the last place.
    pub tolerance: f64,
    /// Radii in mm that are printed as arcs; others become lines.
    pub least_radius: f64,
    pub most_radius: f64,
    /// Shortest distance in mm from start to end by which the receiver tells a short arc from a full circle.
    pub least_chord: f64,
}

impl Arcs {
    /// Blocks that an arc of this sweep takes.
    #[inline]
    pub fn blocks(&self, sweep: f64) -> u32 {
        let blocks = libm::ceil(sweep.abs() / self.most_sweep - ROUNDING);
        blocks.clamp(1.0, f64::from(u32::MAX)) as u32
    }
}

/// What a sweep may exceed the largest one by, as a part of it.
const ROUNDING: f64 = 1e-9;

#[derive(Debug)]
pub struct SpindleWords {
    pub clockwise: &'static str,
    pub counter_clockwise: &'static str,
    pub stop: &'static str,
    pub speed: u8,
    pub cutting_speed: Option<CuttingSpeed>,
    /// Stop at an angle, and the address of the angle.
    pub orient: Option<(&'static str, u8)>,
    /// Address that names another spindle, counted from 0.
    pub other: Option<u8>,
}

/// Constant cutting speed.
#[derive(Debug)]
pub struct CuttingSpeed {
    pub on: &'static str,
    pub off: &'static str,
    /// Address of the largest speed.
    pub limit: u8,
}

#[derive(Debug)]
pub struct CoolantWords {
    pub mist: Option<&'static str>,
    pub flood: &'static str,
    pub off: &'static str,
}

#[derive(Debug)]
pub struct ToolWords {
    pub address: u8,
    /// Largest tool number.
    pub most: u32,
    pub change: Option<&'static str>,
    pub length: Option<LengthWords>,
}

/// Length of the tool from the table of the target.
#[derive(Debug)]
pub struct LengthWords {
    pub on: &'static str,
    pub number: u8,
    pub off: &'static str,
}

/// Waiting, in seconds.
#[derive(Debug)]
pub struct Dwell {
    pub word: &'static str,
    pub seconds: u8,
    /// Longest wait of one block in seconds; a longer one takes several.
    pub most: f64,
}

/// Stops and the end of the program.
#[derive(Debug)]
pub struct Flow {
    pub stop: &'static str,
    pub optional_stop: &'static str,
    /// The receiver reads the optional stop and never stops there.
    pub optional_stop_is_idle: bool,
    pub end: &'static str,
    pub rewind: &'static str,
}

/// Radius compensation by the target.
#[derive(Debug)]
pub struct CompensationWords {
    pub left: &'static str,
    pub right: &'static str,
    /// With the diameter given in the block.
    pub left_by_diameter: &'static str,
    pub right_by_diameter: &'static str,
    pub off: &'static str,
    /// Address of the tool number or the diameter.
    pub tool: u8,
    /// Working planes in which the target compensates.
    pub planes: &'static [Plane],
}

/// M functions that a program passes through.
#[derive(Debug)]
pub struct MFunctions {
    pub address: u8,
    /// Those that the target knows by itself, and what they do there.
    pub own: &'static [(u32, &'static str)],
    /// The machine builder may add M functions to those of the target.
    pub open: bool,
}
