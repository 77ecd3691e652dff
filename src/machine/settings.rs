//! The settings of a run, with their defaults.

use std::collections::BTreeMap;
use std::path::PathBuf;

use crate::target::{self, Target};

use super::axis::{Axis, AxisSet};
use super::mtc200::Mtc200;
use super::tools::Tools;
use super::undercut::Undercuts;

/// Everything the user can say about a run.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Settings {
    pub machine: Machine,
    pub control: Control,
    pub tools: Tools,
    pub datums: Datums,
    pub include: Include,
    pub undercut: Undercuts,
    /// What stands for programs of the machine builder that are found nowhere, by upper-case name.
    pub programs: BTreeMap<String, StandIn>,
    /// Where the axes stand before the first block, as the program would write it: mm (X of a lathe whose program begins
    /// under diameter programming: the diameter) and degrees.
    pub start: BTreeMap<Axis, f64>,
    /// Start values of parameters, by upper-case name (`Q50`, `R1`, `@50`).
    pub variables: BTreeMap<String, f64>,
    pub output: OutputSettings,
    pub limits: Limits,
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
    /// It changes to the tool that this argument names, counted from 1.
    Tool(usize),
    /// Nothing that is printed.
    Ignored,
    /// Another program.
    File(String),
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
    /// Where CYCLE800 retracts to, in machine coordinates.
    pub swivel_retract: BTreeMap<Axis, f64>,
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
            swivel_retract: BTreeMap::new(),
        }
    }
}

/// HEIDENHAIN control generations, in order of age.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
pub enum Generation {
    Tnc426,
    #[default]
    Itnc530,
    Tnc640,
    Tnc7,
}

/// Unit of length.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Unit {
    #[default]
    Mm,
    Inch,
}

impl Unit {
    /// Millimetres in one unit.
    pub fn mm(self) -> f64 {
        match self {
            Unit::Mm => 1.0,
            Unit::Inch => 25.4,
        }
    }
}

/// What a missing coordinate of a CC block is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum CcMissing {
    #[default]
    Position,
    Previous,
}

/// What a missing PR or PA is after a block that was not polar.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum PolarMissing {
    /// From the position, and refused where PA about a new pole is missing.
    #[default]
    SamePole,
    Position,
    Programmed,
}

/// Along which axes a datum shift counts while a rotation, mirror or scaling is active.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ShiftAxes {
    #[default]
    Original,
    Transformed,
}

/// What happens when IPA and DR of a CP block disagree.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum CpSign {
    #[default]
    Refuse,
    Dr,
}

/// What `%` of a formula gives where an operand is negative.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Modulo {
    #[default]
    Refuse,
    /// The sign of the left operand: -400 % 360 = -40.
    Truncate,
    /// The sign of the right operand: -400 % 360 = 320.
    Floor,
}

/// What CALL LBL REP makes of a number with decimals.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum RepeatCount {
    #[default]
    Refuse,
    Truncate,
    Round,
}

/// Klartext: what the machine or the manuals leave to the user to say.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct KlartextChoices {
    /// END PGM inside a called label ends the program file instead of being refused.
    pub open_subprogram_ends: bool,
    /// Probing cycles are left out instead of being refused.
    pub probing_left_out: bool,
    /// Angles of cycle 19 are positions of the rotary axes, not space angles.
    pub cycle_19_axes: bool,
}

/// Which of two solutions Q0 of an arc names.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ArcChoice {
    #[default]
    ZeroIsNear,
    ZeroIsFar,
}

/// What a depth or height across the axis counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum RecessDepth {
    #[default]
    Diameter,
    Radius,
}

/// Where the width of a recess with leaning flanks counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum RecessWidth {
    /// At the element that it is cut into.
    #[default]
    Opening,
    Floor,
}

/// On which side of the programmed corner a recess of G86 lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RecessSide {
    /// Towards +Z.
    Plus,
    /// Towards -Z.
    Minus,
}

/// What turning programs leave to the control. `None`: nobody said, so the default holds and a program that depends on it is
/// told so.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Turning {
    /// Near, if nobody said.
    pub arc_choice: Option<ArcChoice>,
    /// What an incremental I of G22 counts: the diameter, if nobody said.
    pub recess_depth: Option<RecessDepth>,
    /// Clearance of cycles in mm where the program sets none.
    pub clearance: Option<f64>,
    /// Machine coordinates of the tool change point: X as a diameter, Z, in mm.
    pub change_point: Option<(f64, f64)>,
    /// Where a recess of G86 lies that is wider than the tool; `None` refuses it.
    pub recess_side: Option<RecessSide>,
    /// Where K of G23 counts: at the opening, if nobody said.
    pub recess_width: Option<RecessWidth>,
    /// What the infeed I of G81 counts: the radius, if nobody said.
    pub infeed: Option<RecessDepth>,
    /// A flank offset from the left (H1) starts a thread towards +Z, not towards -Z.
    pub left_is_plus: Option<bool>,
    /// What RI of G869 counts: the diameter, if nobody said.
    pub recess_blank: Option<RecessDepth>,
    /// G32, whose words no manual at hand lists, is refused.
    pub refuse_simple_thread: Option<bool>,
    /// A contour in the words of G80, which no manual at hand lists, is refused.
    pub refuse_contour_words: Option<bool>,
    /// Angles of lines count from +Z, not from -Z.
    pub angle_from_plus: Option<bool>,
    /// An undercut of G85 at exactly 18 or 80 mm takes the row above, not the one below.
    pub undercut_upper: Option<bool>,
    /// The face that a transverse thread is cut in is the one towards -Z. `None`: the tool tells.
    pub rear_face: Option<bool>,
    /// R or RB of G869 moves the tool towards the floor, not away from it.
    pub towards_floor: Option<bool>,
    /// B of G869 shortens the passes of one-way turning at their ends.
    pub offset_one_way: Option<bool>,
    /// The oversize of G86 is left on the floor alone, not on the walls.
    pub oversize_on_floor: Option<bool>,
    /// How far the radii at both ends of an arc may differ, in mm.
    pub arc_tolerance: Option<f64>,
}

/// Klartext: further readings that manuals leave open.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct KlartextReadings {
    /// CYCL CALL PAT and CYCL CALL POS without F go at rapid traverse, not at the last feed.
    pub pattern_at_rapid: bool,
    /// The mirror acts on what cycle 10 has turned.
    pub mirror_last: bool,
    /// A cycle 26 without a centre keeps the one before.
    pub keep_scaling_center: bool,
}

/// `[control]`
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Control {
    pub klartext: Generation,
    pub sinumerik: String,
    pub heidenhain_turning: String,
    /// Skip levels that are switched on.
    pub skip_blocks: Vec<u8>,
    /// Unit of a Klartext file without BEGIN PGM.
    pub unit: Option<Unit>,
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
    pub siemens: Siemens,
    pub turning: Turning,
    pub mtc200: Mtc200,
}

/// SINUMERIK: machine and setting data that change what a program means.
#[derive(Debug, Clone, PartialEq)]
pub struct Siemens {
    /// An increment behind a change of the frame travels the change, too (SD 42440).
    pub frame_offset_incremental: Option<bool>,
    /// Largest difference of the radii at start and end of a circle: in mm, and as a part of the radius
    /// (MD 21000, MD 21010).
    pub circle_error: f64,
    pub circle_error_factor: f64,
    /// T changes the tool, not M6; `None` for what the kind of machine does.
    pub tool_change_by_t: Option<bool>,
    /// Bit 0 of MD 10617: SAVE brings back the frame that the work offset had at the call.
    pub save_restores_offset: Option<bool>,
    /// G40 in front of a move that leaves the plane alone is refused, as alarm 10754 has it.
    pub g40_needs_motion: bool,
    /// Variables of the main program are seen in subprograms (MD 11120).
    pub main_variables_visible: bool,
    /// Feed at the start of a program is per revolution (MD 20150).
    pub feed_per_revolution: Option<bool>,
    /// G53, G153 and SUPA suppress the length of the tool, too (MD 10760).
    pub machine_moves_without_tool: bool,
    /// An absolute position of a modulo axis takes the shortest way (MD 30455 bit 2).
    pub modulo_shortest: bool,
    /// A chamfer or rounding that does not fit is made as large as it fits.
    pub shorten_corners: bool,
    /// A chamfer beside an arc stands across the bisector of the corner.
    pub arc_chamfers: bool,
    /// CYCLE86 lifts the tool off under `_GMODE` 1 and 2, or does not; `None` refuses them.
    pub cycle86_lift: Option<bool>,
    /// Which pass of a flank infeed stands at the programmed start.
    pub thread_flank: Option<FlankReference>,
}

/// From where the flank infeed of a thread cycle counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FlankReference {
    /// The crest stands at the programmed start; the last pass is shifted most.
    Crest,
    /// The last pass stands there.
    Root,
}

impl Default for Siemens {
    fn default() -> Siemens {
        Siemens {
            frame_offset_incremental: None,
            circle_error: 0.01,
            circle_error_factor: 0.001,
            tool_change_by_t: None,
            save_restores_offset: None,
            g40_needs_motion: false,
            main_variables_visible: false,
            feed_per_revolution: None,
            machine_moves_without_tool: false,
            modulo_shortest: false,
            shorten_corners: false,
            arc_chamfers: false,
            cycle86_lift: None,
            thread_flank: None,
        }
    }
}

/// `[datums]`
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Datums {
    /// The basic frame of a SINUMERIK, seen from the machine zero, by axis; `None` where nobody said it.
    pub basic: Option<BTreeMap<Axis, f64>>,
    /// Work offset values the program may read, by name (`G54`).
    pub offsets: BTreeMap<String, BTreeMap<Axis, f64>>,
    /// Work offset that is printed for a word of the program (`G500`), 1 (G54) to 9 (G59.3).
    pub words: BTreeMap<String, u8>,
    /// Work offset word of a preset number, 1 (G54) to 9 (G59.3).
    pub presets: BTreeMap<u32, u8>,
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

/// `[output]`
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OutputSettings {
    pub target: &'static Target,
    pub decimals: u8,
    pub compensation: Compensation,
    pub diameter: bool,
    pub comments: bool,
    /// M functions that are printed as they stand.
    pub pass_m: Vec<u32>,
    /// `G43 H` behind a tool change.
    pub tool_length: bool,
}

impl Default for OutputSettings {
    fn default() -> OutputSettings {
        OutputSettings {
            target: target::ALL[0],
            decimals: 4,
            compensation: Compensation::Resolve,
            diameter: false,
            comments: true,
            pass_m: Vec::new(),
            tool_length: false,
        }
    }
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
