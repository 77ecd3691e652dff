//! The settings of a run, with their defaults.

use std::collections::BTreeMap;
use std::path::PathBuf;

use crate::diag::Selection;
use crate::target::{self, DwellUnit, Form, Length, Target};

use super::axis::{Axis, AxisSet};
use super::options::cycles::Cycles;
use super::options::klartext::{
    CcMissing, CpSign, Generation, KlartextChoices, KlartextReadings, Modulo, PolarMissing, RepeatCount, ShiftAxes,
};
use super::options::mtc200::Mtc200;
use super::options::sinumerik::Sinumerik;
use super::options::turning::Turning;
use super::path_control::{self, PathChoice, PathControl};
use super::table::Contents;
use super::tools::Tools;
use super::tree::Spot;
use super::undercut::Undercuts;
use super::unit::Unit;

/// Everything the user can say about a run.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Settings {
    pub machine: Machine,
    pub control: Control,
    pub tools: Tools,
    pub datums: Datums,
    pub include: Include,
    pub undercut: Undercuts,
    pub cycles: Cycles,
    /// What stands for programs of the machine builder that are found nowhere, by upper-case name.
    pub programs: BTreeMap<String, StandIn>,
    /// What such a program leaves behind, where the configuration says it, by upper-case name.
    pub leaves: BTreeMap<String, Leaves>,
    /// Where the axes stand before the first block, as the program would write it: mm (X of a lathe whose program begins
    /// under diameter programming: the diameter) and degrees.
    pub start: BTreeMap<Axis, f64>,
    /// Start values of parameters, by upper-case name (`Q50`, `R1`, `@50`).
    pub variables: BTreeMap<String, f64>,
    pub output: OutputSettings,
    /// Which findings are reported.
    pub lint: Selection,
    /// What rules take for the blank of a program that describes none, by axis.
    pub blank: BTreeMap<Axis, (f64, f64)>,
    pub limits: Limits,
    /// `[dialects]`: patterns of files and the language they are in.
    pub dialects: Vec<(String, String)>,
}

/// Turning technology or not.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MachineKind {
    #[default]
    Mill,
    Lathe,
}

/// What stands for a program that is found nowhere.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum StandIn {
    /// It changes the tool.
    Change(ChangeCall),
    /// Nothing that is printed.
    Ignored,
    /// Another program.
    File(String),
}

/// What a program that is left out, or changes the tool, leaves behind.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Leaves {
    /// G0 is active (true) or G1 (false).
    pub rapid: Option<bool>,
    /// Axes that stand at a place that nothing says.
    pub lost: AxisSet,
    /// F, as the program would write it.
    pub feed: Option<Left>,
    /// S, as the program would write it.
    pub speed: Option<Left>,
    /// What the spindle does.
    pub spindle: Option<LeftSpindle>,
}

/// A value that a call leaves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Left {
    Value(f64),
    /// None that is known.
    Lost,
}

/// What a call leaves the spindle doing: M3, M4 or M5.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LeftSpindle {
    Clockwise,
    CounterClockwise,
    Stopped,
}

impl Settings {
    /// What the program of this name, in capitals, leaves behind.
    pub fn left_by(&self, name: &str) -> Leaves {
        self.leaves.get(name).copied().unwrap_or_default()
    }
}

/// The call of a program that changes the tool.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ChangeCall {
    /// Argument that names the tool, counted from 1; `None` for the tool that T has chosen.
    pub tool: Option<usize>,
    /// Argument that is the D number, counted from 1.
    pub edge: Option<usize>,
}

/// What the name of a channel axis stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AxisUse {
    /// Words of the axis are printed as words of this one.
    Printed(Axis),
    /// The target has no such axis.
    LeftOut,
}

/// Most characters of the name of an axis.
pub const LONGEST_AXIS_NAME: usize = 8;

/// `[machine]`
#[derive(Debug, Clone, PartialEq)]
pub struct Machine {
    pub kind: MachineKind,
    /// Names of the first, second and third geometry axis (MD 20050, MD 20080).
    pub geometry_axes: [Axis; 3],
    /// What names of channel axes stand for (MD 20080), by upper-case name; a letter that is missing stands for itself.
    pub axes: BTreeMap<String, AxisUse>,
    /// MD 20100; `None` for no diameter axis.
    pub diameter_axis: Option<Axis>,
    pub power_on_diameter: bool,
    /// Smallest and largest printed coordinate, by axis.
    pub limits: BTreeMap<Axis, (f64, f64)>,
    pub kinematics: String,
    /// Machine coordinates of the reference point, by axis (G74).
    pub reference_point: BTreeMap<Axis, f64>,
    /// Machine coordinates of the fixed points 1 to 4, by axis (G75, MD 30600).
    pub fixed_point: [BTreeMap<Axis, f64>; 4],
    /// Rotary axes that count modulo 360 degrees.
    pub modulo: AxisSet,
    /// The axis that turns the workpiece about Z under a transformation.
    pub rotary_axis: Axis,
    /// Where a tool change leaves axes.
    pub after_tool_change: AfterToolChange,
    /// Where CYCLE800 retracts to, in machine coordinates.
    pub swivel_retract: BTreeMap<Axis, f64>,
    /// The same of its retraction as far as possible along the tool.
    pub swivel_retract_most: BTreeMap<Axis, f64>,
    /// Rotary axes that tilt the working plane.
    pub tilt_axes: AxisSet,
    /// Name of the swivel record that CYCLE800 is printed with; empty for the only one, `None` where nothing is said.
    pub swivel_record: Option<String>,
}

/// `[machine] after_tool_change`: what the control shows for the new tool behind a change.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct AfterToolChange {
    /// By axis, as the program would write it: mm (X of a lathe that begins under diameter programming: the diameter) and
    /// degrees. In the work offset in force, without what the program shifts, turns, mirrors or scales.
    pub at: BTreeMap<Axis, f64>,
    /// They are machine coordinates.
    pub machine: bool,
}

impl Machine {
    /// The axis of a lathe of which people are shown diameters, whatever a block counts in.
    pub fn shown_diameter(&self) -> Option<Axis> {
        self.diameter_axis.filter(|_| self.kind == MachineKind::Lathe)
    }
}

impl Default for Machine {
    fn default() -> Machine {
        Machine {
            kind: MachineKind::Mill,
            geometry_axes: [Axis::X, Axis::Y, Axis::Z],
            axes: BTreeMap::new(),
            diameter_axis: None,
            power_on_diameter: true,
            limits: BTreeMap::new(),
            kinematics: "3axis".to_owned(),
            reference_point: BTreeMap::new(),
            fixed_point: Default::default(),
            modulo: AxisSet::EMPTY,
            after_tool_change: AfterToolChange::default(),
            rotary_axis: Axis::C,
            swivel_retract: BTreeMap::new(),
            swivel_retract_most: BTreeMap::new(),
            tilt_axes: AxisSet::EMPTY,
            swivel_record: None,
        }
    }
}

/// `[control]`
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Control {
    pub klartext: Generation,
    pub heidenhain_turning: String,
    /// Skip levels that are switched on.
    pub skip_blocks: Vec<u8>,
    /// M functions of the machine builder that change the tool as M6 does.
    pub tool_change_m: Vec<u32>,
    /// Unit of a Klartext file without BEGIN PGM.
    pub unit: Option<Unit>,
    /// A main program without an end of program is taken.
    pub open_end: bool,
    /// Feed in force at the start and for F AUTO without a TOOL CALL, in mm/min.
    pub feed: Option<f64>,
    /// Feed of arcs programmed at rapid traverse, in mm/min.
    pub rapid_feed: Option<f64>,
    pub cc_missing: CcMissing,
    pub polar_missing: PolarMissing,
    pub klartext_readings: KlartextReadings,
    pub shift_axes: ShiftAxes,
    pub cp_sign: CpSign,
    pub modulo: Modulo,
    pub repeat_count: RepeatCount,
    pub klartext_choices: KlartextChoices,
    /// Scaling (cycle 11) leaves the tool axis alone.
    pub scaling_in_plane: bool,
    /// Machine coordinate of the tool axis for M140 MB MAX, in mm.
    pub retract_max: Option<f64>,
    pub sinumerik: Sinumerik,
    pub turning: Turning,
    pub mtc200: Mtc200,
}

impl Control {
    /// Is it said which word changes tools?
    pub fn says_tool_change(&self) -> bool {
        self.sinumerik.tool_change_by_t.is_some()
    }
}

/// `[datums]`
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Datums {
    /// The basic frame of a SINUMERIK, seen from the machine zero, by axis; `None` where nobody said it.
    pub basic: Option<BTreeMap<Axis, f64>>,
    /// Work offset values the program may read, by name (`G54`).
    pub offsets: BTreeMap<String, BTreeMap<Axis, f64>>,
    /// Work offset that is printed for a word of the program (`G500`), 1 (G54) to 9 (G59.3), and on.
    pub words: BTreeMap<String, u8>,
    /// Work offset word of a preset number, 1 (G54) to 9 (G59.3), and on.
    pub presets: BTreeMap<u32, u8>,
    /// The datum table that is selected on a HEIDENHAIN control.
    pub table: Option<Contents>,
}

/// `[include]`
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Include {
    /// Prefix of the control's path and the folder of this computer; the longest prefix wins.
    pub roots: BTreeMap<String, PathBuf>,
}

/// How radius compensation is printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Compensation {
    /// Tool-centre path.
    #[default]
    Resolve,
    /// Programmed contour with G41/G42.
    Control,
}

/// How a tool change is printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ToolChange {
    /// By the word of the target.
    #[default]
    Change,
    /// Spindle stop, a comment and a program stop: somebody changes by hand.
    Stop,
}

/// `[output]`
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OutputSettings {
    pub target: &'static Target,
    pub units: Units,
    pub decimals: Decimals,
    pub compensation: Compensation,
    /// X as a diameter; otherwise as the target has it.
    pub diameter: Option<bool>,
    pub comments: bool,
    /// Every block says all axes and the feed, not only what changes.
    pub modal: bool,
    /// Step of block numbers; 0 for none.
    pub line_numbers: u32,
    pub program_number: u32,
    /// Comments behind the head and in front of the end.
    pub header: Vec<String>,
    pub footer: Vec<String>,
    /// M functions that are printed as they stand.
    pub pass_m: Vec<u32>,
    /// The length of the tool behind a tool change; otherwise as is usual with the target.
    pub tool_length: Option<bool>,
    pub tool_change: ToolChange,
    /// Largest number of a tool's length and radius (H, D); otherwise what every receiver of the kind has.
    pub tool_offsets: Option<u32>,
    /// What the number of a wait counts, where the target leaves it to a setting of the receiver.
    pub dwell_unit: Option<DwellUnit>,
    /// Feed of rapid traverse in mm/min, where that goes at the last F.
    pub rapid_feed: Option<u32>,
    /// How far lines may leave an arc that the target cannot say, in millionths of a mm; `None`: it is refused.
    pub arc_fallback: Option<u32>,
    /// What a tap of the target leaves out or does in its own way is taken without a word.
    pub tapping_as_target: bool,
    /// How corners are taken where the program has no say; otherwise as is usual with the target.
    pub path_control: Option<PathChoice>,
    /// What is printed is read back and compared with what was meant.
    pub validate: bool,
    /// Keys that the configuration states, and where.
    pub stated: Stated,
}

/// Keys with their places, which are no part of what the settings say: those of two files may be alike.
#[derive(Debug, Clone, Default)]
pub struct Stated(pub Vec<(&'static str, Spot)>);

impl PartialEq for Stated {
    fn eq(&self, _: &Stated) -> bool {
        true
    }
}

impl Eq for Stated {}

impl Default for OutputSettings {
    fn default() -> OutputSettings {
        OutputSettings {
            target: target::ALL[0],
            units: Units::Millimetres,
            decimals: Decimals::default(),
            compensation: Compensation::Resolve,
            diameter: None,
            comments: true,
            modal: true,
            line_numbers: 0,
            program_number: 1,
            header: Vec::new(),
            footer: Vec::new(),
            pass_m: Vec::new(),
            tool_length: None,
            tool_change: ToolChange::Change,
            tool_offsets: None,
            dwell_unit: None,
            rapid_feed: None,
            arc_fallback: None,
            tapping_as_target: false,
            path_control: None,
            validate: true,
            stated: Stated::default(),
        }
    }
}

/// A ten-thousandth of a degree is a thousandth of a mm at half a metre.
const TILT_PLACES: u8 = 4;

impl OutputSettings {
    /// Places behind the point of a quantity: those of its own key, of the target, of lengths.
    pub fn places(&self, quantity: Quantity) -> u8 {
        let numbers = &self.target.numbers;
        let unit = usize::from(self.units == Units::Inches);
        let lengths = self.decimals.length.unwrap_or(numbers.length[unit]);
        let own = |places: Option<[u8; 2]>| places.map(|places| places[unit]);
        let of_feed = self.decimals.feed;
        match quantity {
            Quantity::Length => lengths,
            Quantity::Angle => self.decimals.angle.or(self.decimals.length).unwrap_or(numbers.length[0]),
            Quantity::Feed => of_feed.or(own(numbers.feed)).unwrap_or(lengths),
            Quantity::FeedPerRevolution => of_feed.or(own(numbers.feed_per_revolution)).unwrap_or(lengths),
            Quantity::InverseTime => of_feed.unwrap_or(lengths),
            Quantity::Lead => own(numbers.lead).unwrap_or(lengths),
            Quantity::Speed => self.decimals.speed.or(numbers.speed).unwrap_or(lengths),
            Quantity::Time if self.dwell_unit() == Some(DwellUnit::Milliseconds) => 3,
            Quantity::Time => self.decimals.time.or(numbers.time).unwrap_or(lengths),
        }
    }

    /// Places of the angles of a tilted plane: at least four, unless the configuration says how many.
    pub fn tilt_places(&self) -> u8 {
        self.decimals.angle.unwrap_or_else(|| self.places(Quantity::Angle).max(TILT_PLACES))
    }

    /// What a printed feed of one is, in mm a minute.
    pub fn feed_unit(&self) -> f64 {
        match (self.target.form, self.units) {
            (_, Units::Millimetres) => 1.0,
            (Form::Words, Units::Inches) => Unit::Inch.mm(),
            (Form::Dialog(dialog), Units::Inches) => dialog.inch_feed,
        }
    }

    /// What the number of a wait counts; `None` where a setting of the receiver says it, and the configuration does not.
    pub fn dwell_unit(&self) -> Option<DwellUnit> {
        match self.target.dwell.unit {
            DwellUnit::Setting => self.dwell_unit,
            unit => Some(unit),
        }
    }

    /// What the radii at both ends of an arc may differ by on the receiver, in mm.
    pub fn arc_mismatch(&self) -> f64 {
        self.target.arcs.mismatch[usize::from(self.units == Units::Inches)]
    }

    /// Waits are counted in milliseconds.
    pub fn waits_in_milliseconds(&self) -> bool {
        self.dwell_unit() == Some(DwellUnit::Milliseconds)
    }

    /// What is printed for what the program says of its corners, `None` where it has no say. No answer: nothing is printed.
    pub fn path_control(&self, said: Option<PathControl>, lathe: bool) -> Option<PathControl> {
        path_control::printed(&self.target.path, self.path_control, said, lathe)
    }

    /// Has the target a word for what the configuration says of corners?
    pub fn can_say_path_control(&self) -> bool {
        path_control::can_say(&self.target.path, self.path_control)
    }

    /// X is printed as a diameter, on a lathe.
    pub fn prints_diameters(&self) -> bool {
        self.diameter.unwrap_or(self.target.frame.lathe.is_none())
    }

    /// The target adds the length of a tool after a change.
    pub fn prints_tool_length(&self) -> bool {
        match self.target.tool.length {
            Length::None => self.tool_length.unwrap_or(false),
            Length::WithTool => self.tool_length.unwrap_or(true),
            Length::Words(words) => self.tool_length.unwrap_or(words.usual),
        }
    }

    /// What adds the length of the tool to Z, and what to do where it acts along another axis.
    pub fn length_along_z(&self) -> [String; 2] {
        let texts = match self.target.tool.length {
            Length::WithTool => [
                "the tool call of the target",
                "take another target, or set `[output] tool_length = \"off\"` where the length is zero in its table",
            ],
            Length::Words(words) => {
                let help = "set `[output] tool_length = \"off\"` and the length on the target";
                return [format!("the {} of the target", words.on), help.to_owned()];
            }
            Length::None => ["the target", "leave `[output] tool_length` at \"off\" and set the length on the target"],
        };
        texts.map(str::to_owned)
    }

    /// The length of a tool is stated by the first move along Z behind its change.
    pub fn tool_length_waits(&self) -> bool {
        self.prints_tool_length() && matches!(self.target.tool.length, Length::Words(words) if words.with_move)
    }
}

/// Unit of the printed lengths.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Units {
    #[default]
    Millimetres,
    Inches,
}

/// Places behind the point, where the configuration says them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Decimals {
    pub length: Option<u8>,
    pub angle: Option<u8>,
    pub feed: Option<u8>,
    pub speed: Option<u8>,
    pub time: Option<u8>,
}

/// What a printed number counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    Length,
    Angle,
    /// Per minute.
    Feed,
    FeedPerRevolution,
    InverseTime,
    /// Way of a turn of a thread.
    Lead,
    Speed,
    Time,
}

/// `[limits]`
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Limits {
    /// Blocks that may be executed.
    pub steps: u64,
    /// Lines that may be printed.
    pub output_blocks: u64,
    pub call_depth: usize,
}

impl Default for Limits {
    fn default() -> Limits {
        Limits { steps: 10_000_000, output_blocks: 50_000_000, call_depth: 64 }
    }
}
