//! What a target is made of: its words, their forms, its limits.
//!
//! `None` stands where the target has no word: what needs it is refused, never said in another way that is not exact.

use core::f64::consts::TAU;
use std::borrow::Cow;

use crate::geo::Plane;

use super::tap_words::RigidTap;

/// A receiver of plain G-code.
#[derive(Debug)]
pub struct Target {
    /// Name in `--target`, in the configuration and in the head of the output.
    pub name: &'static str,
    /// The receiver in a few words.
    pub about: &'static str,
    /// Extension of output files.
    pub extension: &'static str,
    pub form: Form,
    pub frame: Frame,
    pub comments: Comments,
    pub line: Line,
    pub numbers: Numbers,
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
    /// Those behind them.
    pub more_offsets: Option<MoreOffsets>,
    /// Those behind so many are others than the program names, counted on: which one is printed is told.
    pub offsets_named: u8,
    /// That the receiver knows them is confirmed.
    pub offsets_confirmed: bool,
    pub compensation: Option<CompensationWords>,
    pub path: PathWords,
    pub m: MFunctions,
}

impl PartialEq for Target {
    fn eq(&self, other: &Target) -> bool {
        self.name == other.name
    }
}

impl Eq for Target {}

impl Target {
    /// Is the lead of a thread given by the word of the feed, where the feed may count per revolution, too?
    pub fn lead_is_feed(&self) -> bool {
        let by_feed = |thread: &Thread| match thread.lead {
            Lead::Way(address) | Lead::OneAxis(address) | Lead::AlongZ(address) => address == self.feed.address,
        };
        self.feed.per_revolution.is_some() && self.motion.thread.as_ref().is_some_and(by_feed)
    }

    /// The word of a work offset, counted from 1.
    pub fn offset(&self, number: u8) -> Option<Cow<'static, str>> {
        let named = self.offsets.get(usize::from(number).checked_sub(1)?);
        named.map(|word| Cow::Borrowed(*word)).or_else(|| {
            let more = self.more_offsets.filter(|more| number > more.less && number <= more.most)?;
            Some(Cow::Owned(format!("{}{}", more.word, number - more.less)))
        })
    }
}

impl Target {
    /// All work offsets, for people: `G54 to G59, G54.1 P1 to G54.1 P48`; `None` where there are none.
    pub fn offset_range(&self) -> Option<String> {
        let last = self.more_offsets.map_or(self.offsets.len() as u8, |more| more.most);
        let range = |from: u8, to: u8| Some(format!("{} to {}", self.offset(from)?, self.offset(to)?));
        match self.offsets_named {
            0 => range(1, last),
            named if named >= last => range(1, last),
            named => Some(format!("{}, {}", range(1, named)?, range(named + 1, last)?)),
        }
    }
}

/// Work offsets by a number behind a word.
#[derive(Debug, Clone, Copy)]
pub struct MoreOffsets {
    pub word: &'static str,
    /// What the number is less than that of the offset.
    pub less: u8,
    /// The last one, as we count.
    pub most: u8,
}

/// How blocks are made.
#[derive(Debug, Clone, Copy)]
pub enum Form {
    /// Words of a letter and a number; G functions state modes that hold.
    Words,
    /// A block begins with what it does, names its axes, and ends with how fast.
    Dialog(&'static Dialog),
}

/// Words of a dialog.
#[derive(Debug)]
pub struct Dialog {
    /// First and last block; the name of the program and the unit stand behind.
    pub begin: &'static str,
    pub end: &'static str,
    /// Millimetres, inches.
    pub units: [&'static str; 2],
    /// What F1 is in a program in inches, in mm/min.
    pub inch_feed: f64,
    /// At rapid traverse, where a feed would stand; it holds for its own block.
    pub rapid: &'static str,
    /// The tool centre moves along the programmed path.
    pub uncompensated: &'static str,
    /// States the centre of the arcs behind it.
    pub center: &'static str,
    /// An arc to its end.
    pub arc: &'static str,
    pub helix: HelixWords,
    /// Calls a tool, or states the speed alone.
    pub tool: &'static str,
    /// The axis along which the tool is long.
    pub tool_axis: &'static str,
    /// Brings a tool forth.
    pub prepare: &'static str,
    /// The block in front of the one that waits.
    pub dwell: &'static str,
    /// The block in front of the one that says how far corners are rounded off.
    pub tolerance: &'static str,
    /// What stands in front of the number of a work offset and behind it, in lines of one block.
    pub offset: [&'static str; 2],
}

/// An arc that goes along its third axis, by the angle that it turns.
#[derive(Debug)]
pub struct HelixWords {
    pub word: &'static str,
    /// The angle from the start.
    pub angle: &'static str,
    /// In front of an axis: its way.
    pub way: &'static str,
    /// Places of the angle.
    pub places: u8,
    /// Turns of one block.
    pub most_turns: i64,
    /// Up to this radius in mm the last place of the angle moves the end by less than a thousandth.
    pub most_radius: f64,
    /// Working planes.
    pub planes: &'static [Plane],
}

/// What stands around the program, and the modes stated at its start.
#[derive(Debug)]
pub struct Frame {
    pub first: Option<&'static str>,
    pub last: Option<&'static str>,
    /// By what the receiver knows a program, behind the first line.
    pub name: ProgramName,
    /// Modes that hold on every machine, in millimetres and in inches; `None` where the target knows no inches.
    pub head: &'static [&'static str],
    pub inch_head: Option<&'static [&'static str]>,
    pub mill: Option<&'static str>,
    /// On a lathe, with X as a radius.
    pub lathe: Option<&'static str>,
    /// On a lathe, with X as a diameter.
    pub lathe_diameter: Option<&'static str>,
}

/// The line that names a program.
#[derive(Debug, Clone, Copy)]
pub enum ProgramName {
    None,
    /// `O0001`: a letter and at least so many digits, from 1 to `most`.
    Number {
        letter: u8,
        digits: usize,
        most: u32,
    },
    /// At most so many letters, digits and `marks` of the name of the source, with this in front.
    Text {
        front: &'static str,
        most: usize,
        marks: &'static str,
    },
}

/// How comments look.
#[derive(Debug)]
pub struct Comments {
    pub open: &'static str,
    pub close: &'static str,
    /// Capitals, digits, blanks and `.,=_-` alone; other characters are printed as a point.
    pub upper: bool,
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
    /// Most digits in front of the point; 0 for any.
    pub whole: u32,
    pub sequence: Sequence,
}

/// Numbers of blocks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sequence {
    /// By this address, up to the largest one, where the configuration wants them.
    Address(u8, u32),
    /// Every line that begins a block has its number, counted from 0.
    Blocks,
    /// A number would mean something else.
    None,
}

/// How numbers are written. Places come in pairs: in millimetres, in inches.
#[derive(Debug, Clone, Copy)]
pub struct Numbers {
    /// A whole length has its point, too: without it, some controls count in their least increment.
    pub point: bool,
    /// So does a whole feed.
    pub feed_point: bool,
    /// The zero in front of a point.
    pub zero: bool,
    pub length: [u8; 2],
    /// Most places of a length that are read.
    pub most: u8,
    /// Where they have no places of their own, these have those of lengths.
    pub feed: Option<[u8; 2]>,
    pub feed_per_revolution: Option<[u8; 2]>,
    pub lead: Option<[u8; 2]>,
    pub speed: Option<u8>,
    /// Most places of a wait that are read, too.
    pub time: Option<u8>,
}

/// Straight moves, planes, coordinates of the machine.
#[derive(Debug)]
pub struct Motion {
    pub rapid: &'static str,
    pub line: &'static str,
    /// Rapid traverse goes at the F that was read last: the configuration says which one.
    pub rapid_at_feed: bool,
    /// In front of a move in machine coordinates, in a dialog behind it.
    pub machine: Option<&'static str>,
    /// Such a move may have a feed.
    pub machine_feed: bool,
    /// The length of the tool counts in machine coordinates, too: it is switched off for the move.
    pub machine_drops_length: bool,
    pub thread: Option<Thread>,
    pub rigid_tap: Option<RigidTap>,
    /// XY, ZX, YZ; `None` where an arc says its plane itself.
    pub planes: Option<[&'static str; 3]>,
}

/// Line in step with the spindle.
#[derive(Debug, Clone, Copy)]
pub struct Thread {
    pub word: &'static str,
    pub lead: Lead,
    /// The spindle may stop or turn round between two threads without a move, as for tapping.
    pub stops: bool,
}

/// What gives the way of a turn.
#[derive(Debug, Clone, Copy)]
pub enum Lead {
    /// This address, along the way.
    Way(u8),
    /// This address, along the axis that moves; a way along two axes is not said.
    OneAxis(u8),
    /// This address, where Z alone moves.
    AlongZ(u8),
}

impl Motion {
    pub fn plane(&self, plane: Plane) -> Option<&'static str> {
        self.planes.map(|[xy, zx, yz]| match plane {
            Plane::Xy => xy,
            Plane::Zx => zx,
            Plane::Yz => yz,
        })
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

/// All planes.
pub const EVERY_PLANE: &[Plane] = &[Plane::Xy, Plane::Zx, Plane::Yz];

/// Arcs by offset from the start to the centre.
#[derive(Debug)]
pub struct Arcs {
    pub clockwise: &'static str,
    pub counter_clockwise: &'static str,
    /// Addresses of the centre, by axis.
    pub center: [u8; 3],
    /// Planes in which the receiver goes round.
    pub planes: &'static [Plane],
    /// A third axis goes along with an arc, in every build of the receiver.
    pub helices: bool,
    /// Number of turns in one block; `None`: an arc is divided at `most_sweep`.
    pub turns: Option<Turns>,
    /// Largest sweep of a block in rad where it cannot count turns.
    pub most_sweep: f64,
    /// Largest sweep of a block, whole turns left out, whose end is not its start. A control that moves a centre which does
    /// not quite fit moves it far where the sweep is near a half or a whole turn. Others are divided.
    pub most_open_sweep: f64,
    /// Largest difference of the radii at start and end of a printed arc, in units of the last place.
    pub tolerance: f64,
    /// The same in mm, in programs in millimetres and in inches.
    pub mismatch: [f64; 2],
    /// Radii in mm that are printed as arcs; others become lines.
    pub least_radius: f64,
    pub most_radius: f64,
    /// Shortest distance in mm from start to end by which the receiver tells a short arc from a full circle.
    pub least_chord: f64,
}

/// How a block counts the turns of its arc.
#[derive(Debug, Clone, Copy)]
pub enum Turns {
    /// This address gives all, the last one begun included.
    All(u8),
    /// This word gives whole turns that are added.
    More(&'static str),
}

impl Arcs {
    /// Blocks that an arc of this sweep takes.
    #[inline]
    pub fn blocks(&self, sweep: f64) -> u32 {
        let blocks = libm::ceil(sweep.abs() / self.most_sweep - ROUNDING);
        blocks.clamp(1.0, f64::from(u32::MAX)) as u32
    }

    /// The same for an arc that does not end where it starts.
    #[inline]
    pub fn open_blocks(&self, sweep: f64) -> u32 {
        let last = sweep.abs() % TAU;
        if last > self.most_open_sweep {
            libm::ceil(sweep.abs() / self.most_open_sweep) as u32
        } else {
            self.blocks(sweep)
        }
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
    /// A speed is a part of the block that starts the spindle.
    pub speed_with_start: bool,
    pub cutting_speed: Option<CuttingSpeed>,
    /// Stop at an angle, and the address of the angle, where the word is not `SPOS=` itself.
    pub orient: Option<(&'static str, Option<u8>)>,
    /// Address that names another spindle, counted from 0.
    pub other: Option<u8>,
}

/// Constant cutting speed.
#[derive(Debug)]
pub struct CuttingSpeed {
    pub on: &'static str,
    pub off: &'static str,
    pub limit: Limit,
}

/// How the largest speed is said.
#[derive(Debug, Clone, Copy)]
pub enum Limit {
    /// This word in the block.
    Word(&'static str),
    /// A block in front, of this word and a speed; it holds until the next one.
    Block(&'static str),
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
    /// Largest number of an offset that every receiver has, where the length and the radius of a tool are called by one and how
    /// many there are is an option.
    pub most_offset: Option<u32>,
    pub change: Option<Change>,
    /// A tool may be called without being changed.
    pub prepares: bool,
    pub length: Length,
}

/// How a tool comes into the spindle.
#[derive(Debug, Clone, Copy)]
pub enum Change {
    /// The tool and this word.
    Word(&'static str),
    /// `T0101`: the tool and its offset, in so many digits each.
    Turret { digits: usize },
    /// By its block in a dialog.
    Call,
}

/// Length of the tool from the table of the target.
#[derive(Debug, Clone, Copy)]
pub enum Length {
    /// The target has no such table.
    None,
    /// The change brings it.
    WithTool,
    Words(LengthWords),
}

#[derive(Debug, Clone, Copy)]
pub struct LengthWords {
    pub on: &'static str,
    pub number: LengthNumber,
    /// Where there is none, an empty spindle is not said.
    pub off: Option<&'static str>,
    /// The words stand in the next move along Z: alone, some controls move by the length.
    pub with_move: bool,
    /// They are printed unless the configuration says otherwise.
    pub usual: bool,
}

/// What follows the word for the length.
#[derive(Debug, Clone, Copy)]
pub enum LengthNumber {
    /// This address, with the number of the tool.
    Tool(u8),
    /// Nothing.
    None,
}

/// Waiting.
#[derive(Debug, Clone, Copy)]
pub struct Dwell {
    pub word: &'static str,
    pub address: u8,
    pub unit: DwellUnit,
    /// Longest wait of one block in seconds; a longer one takes several.
    pub most: f64,
    /// Under a feed per revolution the number may count revolutions: the feed per minute is switched on before.
    pub per_minute: bool,
}

/// What the number of a wait counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DwellUnit {
    Seconds,
    /// Whole milliseconds.
    Milliseconds,
    /// A setting of the receiver says which of them; so does the configuration.
    Setting,
}

/// Stops and the end of the program.
#[derive(Debug)]
pub struct Flow {
    pub stop: &'static str,
    pub optional_stop: &'static str,
    /// The receiver reads the optional stop and never stops there.
    pub optional_stop_is_idle: bool,
    /// `None` where the end of the text is the end of the program.
    pub end: Option<&'static str>,
    pub rewind: Option<&'static str>,
}

/// Radius compensation by the target.
#[derive(Debug)]
pub struct CompensationWords {
    pub left: &'static str,
    pub right: &'static str,
    /// Left and right with the diameter given in the block, where the target takes one.
    pub by_diameter: Option<[&'static str; 2]>,
    /// Address and numbers of where the edge of a turning tool points to, beside that diameter; a number of 0 is left out.
    pub edge: Option<EdgeWords>,
    pub off: &'static str,
    /// Address of the tool number or the diameter; `None` where the radius comes with the length of the tool.
    pub tool: Option<u8>,
    /// The words stand in the straight move to the contour or from it, and one block at most between two moves of the contour
    /// moves nothing in its plane.
    pub with_move: bool,
    /// A stop (M0, M1) does not keep the target from reading the element behind it.
    pub reads_over_stops: bool,
    /// Working planes in which the target compensates.
    pub planes: &'static [Plane],
}

/// Where the edge of a turning tool points to.
#[derive(Debug, Clone, Copy)]
pub struct EdgeWords {
    pub address: u8,
    /// Rows by the sign along Z, columns by that along X: minus, nothing, plus.
    pub numbers: [[u8; 3]; 3],
}
impl EdgeWords {
    /// The number of an edge that points there, along Z and X.
    pub fn number(&self, edge: [i8; 2]) -> u8 {
        let [z, x] = edge.map(|sign| usize::from(sign.clamp(-1, 1).wrapping_add(1) as u8));
        self.numbers.get(z).and_then(|row| row.get(x)).copied().unwrap_or(0)
    }
}

/// How corners are taken.
#[derive(Debug, Clone, Copy)]
pub struct PathWords {
    /// Every block ends on its corner.
    pub exact: Option<&'static str>,
    /// Corners are rounded off, by so much off the path at most.
    pub within: Option<PathBound>,
    /// Rounding off begins so far in front of a corner at most.
    pub before: Option<PathBound>,
    /// Corners are passed without a stop and without a bound.
    pub unbounded: Option<&'static str>,
    /// So does every receiver before a program says anything: the head states it, so that nothing else is left on.
    pub starts_unbounded: bool,
    /// The mode may change between G41 and G40.
    pub under_compensation: bool,
    /// Exact is how a program for a lathe begins: the receiver starts so, or stops only where the path has a corner.
    pub exact_on_lathes: bool,
}

impl PathWords {
    /// A receiver whose corners are a matter of its settings alone.
    pub const NONE: PathWords = PathWords {
        exact: None,
        within: None,
        before: None,
        unbounded: None,
        starts_unbounded: false,
        under_compensation: true,
        exact_on_lathes: false,
    };

    /// No word says anything of corners.
    pub fn is_empty(&self) -> bool {
        self.exact.is_none() && self.within.is_none() && self.before.is_none() && self.unbounded.is_none()
    }
}

/// A word, and the one that gives its length: `G64` and `P`, `G642` and `CTOL=`. In a dialog it stands in a block of its own.
#[derive(Debug, Clone, Copy)]
pub struct PathBound {
    pub word: &'static str,
    pub length: &'static str,
}

/// M functions that a program passes through.
#[derive(Debug)]
pub struct MFunctions {
    pub address: u8,
    /// Those that the target knows by itself, and what they do there.
    pub own: &'static [(u32, &'static str)],
    /// The machine builder may add M functions to those of the target.
    pub open: bool,
    /// Those of spindle, coolant and stops are matters of the machine, too: they are printed where `pass_m` lists them.
    pub listed: bool,
}
