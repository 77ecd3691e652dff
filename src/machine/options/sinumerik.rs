//! SINUMERIK: machine and setting data that change what a program means.

use crate::machine::keys::{Key, Kind, key};
use crate::machine::tree::{ConfigError, Node};
use crate::machine::values::{flag, is, number, put, whole};

pub const KEYS: &[Key] = &[
    key("sd42440", Kind::Flag, "an increment after a change of the frame travels the change, too", |s, v| put(&mut s.control.sinumerik.frame_offset_incremental, Some(flag(v)))),
    key("md21000", Kind::Number, "largest difference of the radii of a circle, in mm", |s, v| put(&mut s.control.sinumerik.circle_error, not_below_zero(v)?)).or("0.01"),
    key("md21010", Kind::Number, "largest difference of the radii of a circle, as a part of the radius", |s, v| put(&mut s.control.sinumerik.circle_error_factor, not_below_zero(v)?)).or("0.001"),
    key(
                "large_corners",
                Kind::Choice(&["refuse", "shorten"]),
                "SINUMERIK: a chamfer or rounding that does not fit; shorten: as large as it fits, in the order of the path", |s, v| put(&mut s.control.sinumerik.shorten_corners, is(v, "shorten"))).or(r#""refuse""#),
    key("md20150", Kind::Choice(&["g94", "g95"]), "SINUMERIK: kind of feed at the start of a program; default: g94", |s, v| put(&mut s.control.sinumerik.feed_per_revolution, Some(is(v, "g95")))),
    key(
                "md10760",
                Kind::Flag,
                "SINUMERIK: G53, G153 and SUPA suppress the tool length, too, so that they place the spindle, not the tip", |s, v| put(&mut s.control.sinumerik.machine_moves_without_tool, flag(v))).or("false"),
    key(
                "md30455",
                Kind::Choice(&["absolute", "shortest"]),
                "SINUMERIK: way of a modulo axis to an absolute position: inside its turn, or the shortest", |s, v| put(&mut s.control.sinumerik.modulo_shortest, is(v, "shortest"))).or(r#""absolute""#),
    key(
                "arc_chamfers",
                Kind::Choice(&["refuse", "bisector"]),
                "SINUMERIK: a chamfer beside an arc; bisector: across the bisector of the corner, its ends on both elements", |s, v| put(&mut s.control.sinumerik.arc_chamfers, is(v, "bisector"))).or(r#""refuse""#),
    key(
                "g40_without_motion",
                Kind::Choice(&["warn", "error"]),
                "SINUMERIK: G40 before a move that leaves the plane alone: its offset waits for the next one in the plane, or alarm 10754", |s, v| put(&mut s.control.sinumerik.g40_needs_motion, is(v, "error"))).or(r#""warn""#),
    key("md10617", Kind::Whole, "SINUMERIK: what SAVE brings back; bit 0: the frame of the work offset", |s, v| put(&mut s.control.sinumerik.save_restores_offset, Some(whole(v) & 1 != 0))),
    key(
                "cycle86_lift",
                Kind::Choice(&["lift", "none"]),
                "SINUMERIK: what CYCLE86 does under `_GMODE` 1 and 2: lift off at the bottom, or straight out; refused if not given", |s, v| put(&mut s.control.sinumerik.cycle86_lift, Some(is(v, "lift")))),
    key(
                "thread_flank",
                Kind::Choice(&["crest", "root"]),
                "SINUMERIK: what stands at the programmed start of a thread with a flank infeed; default: crest", |s, v| {
    let root = is(v, "root");
    put(&mut s.control.sinumerik.thread_flank, Some(if root { FlankReference::Root } else { FlankReference::Crest }))
}),
    key(
                "g451_limit",
                Kind::Number,
                "SINUMERIK: outside corners up to this turn of the contour, in degrees, get an intersection under G451, sharper ones an arc (MD 20210); default: 100", |s, v| put(&mut s.control.sinumerik.compensation.limit, Some(turn(v)?))),
    key(
                "g450_flat",
                Kind::Number,
                "SINUMERIK: outside corners up to this turn of the contour, in degrees, get an intersection under G450, too (MD 20230); default: 0", |s, v| put(&mut s.control.sinumerik.compensation.flat, Some(turn(v)?))),
    key(
                "disc",
                Kind::Choice(&["refuse", "circle"]),
                "SINUMERIK: arcs about outside corners under DISC=1 to DISC=100: refused, or circles as under DISC=0", |s, v| put(&mut s.control.sinumerik.compensation.disc_as_circle, is(v, "circle"))).or(r#""refuse""#),
    key(
                "md20240",
                Kind::Whole,
                "SINUMERIK: blocks that are looked through where a compensated path has no room", |s, v| put(&mut s.control.sinumerik.compensation.look_ahead, look_ahead(v)?)).or("3"),
    key(
                "curve_feed",
                Kind::Choice(&["programmed", "control"]),
                "SINUMERIK: F on compensated arcs: as programmed, or as CFC, CFTCP and CFIN say, so that the centre gets F times its radius by that of the contour", |s, v| put(&mut s.control.sinumerik.compensation.curve_feed, is(v, "control"))).or(r#""programmed""#),
    key("md10602", Kind::Whole, "SINUMERIK: what becomes of a frame where TRANSMIT, TRACYL and TRAFOOF change the axes; 1: it stays, others are refused", |s, v| put(&mut s.control.sinumerik.transformation_keeps_frame, whole(v) == 1)),
    key(
                "called_first",
                Kind::Choice(&["spf", "mpf"]),
                "SINUMERIK: which of NAME_SPF and NAME_MPF a call of NAME runs where both lie in the folder of the main program; refused if not given", |s, v| {
    let main = is(v, "mpf");
    put(&mut s.control.sinumerik.called_first, Some(if main { CalledFirst::Main } else { CalledFirst::Sub }))
}),
    key(
                "synchronized_actions",
                Kind::Choice(&["refuse", "leave-out"]),
                "SINUMERIK: synchronized actions (WHEN … DO, ID=, IDS=); leave-out: those that set outputs, markers or the feed only", |s, v| put(&mut s.control.sinumerik.beside.synchronized, is(v, "leave-out"))).or(r#""refuse""#),
    key(
                "oscillation",
                Kind::Choice(&["refuse", "leave-out"]),
                "SINUMERIK: oscillation (OS, OSP1, OSCILL …); leave-out: that of axes that are left out by `axes` of [machine]", |s, v| put(&mut s.control.sinumerik.beside.oscillation, is(v, "leave-out"))).or(r#""refuse""#),
    key(
                "couplings",
                Kind::Choice(&["refuse", "leave-out"]),
                "SINUMERIK: couplings and curve tables (TRAILON, LEADON, TANG, EGON, CTABDEF …); leave-out: those whose following axis is left out by `axes` of [machine]", |s, v| put(&mut s.control.sinumerik.beside.couplings, is(v, "leave-out"))).or(r#""refuse""#),
    key("md11120", Kind::Flag, "variables of the main program are seen in subprograms", |s, v| put(&mut s.control.sinumerik.main_variables_visible, flag(v))).or("false"),
];

/// A turn of a contour in degrees.
fn turn(node: &Node) -> Result<f64, ConfigError> {
    number(node).filter(|v| (0.0..=180.0).contains(v)).ok_or_else(|| node.fail("lies between 0 and 180"))
}

/// Blocks of the collision search.
fn look_ahead(node: &Node) -> Result<u32, ConfigError> {
    u32::try_from(whole(node)).ok().filter(|n| *n <= 100).ok_or_else(|| node.fail("lies between 0 and 100"))
}

fn not_below_zero(node: &Node) -> Result<f64, ConfigError> {
    number(node).filter(|v| *v >= 0.0).ok_or_else(|| node.fail("is not below 0"))
}

/// SINUMERIK: machine and setting data that change what a program means.
#[derive(Debug, Clone, PartialEq)]
pub struct Sinumerik {
    /// The control (`802d`, `840dsl`), where a word means something else on it.
    pub model: String,
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
    /// A frame stays where a transformation begins or ends (MD 10602).
    pub transformation_keeps_frame: bool,
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
    /// What the machine says about the path of the tool centre.
    pub compensation: CentrePath,
    /// CYCLE86 lifts the tool off under `_GMODE` 1 and 2, or does not; `None` refuses them.
    pub cycle86_lift: Option<bool>,
    /// Which pass of a flank infeed stands at the programmed start.
    pub thread_flank: Option<FlankReference>,
    /// Which program runs where two of one name lie in the folder of the main program; `None` refuses the call.
    pub called_first: Option<CalledFirst>,
    /// What stands beside the path and is left out instead of being refused.
    pub beside: LeftOutBeside,
}

/// Words beside the path that are left out where nothing of them reaches it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct LeftOutBeside {
    /// Synchronized actions.
    pub synchronized: bool,
    pub oscillation: bool,
    /// Couplings and curve tables.
    pub couplings: bool,
}

/// What a call of a name runs where a subprogram and a main program have it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CalledFirst {
    /// NAME_SPF.
    Sub,
    /// NAME_MPF.
    Main,
}

/// What the machine says about the path of the tool centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CentrePath {
    /// Largest turn of an outside corner in degrees that gets an intersection under G451 (MD 20210), and under G450
    /// (MD 20230).
    pub limit: Option<f64>,
    pub flat: Option<f64>,
    /// DISC above 0 makes circles.
    pub disc_as_circle: bool,
    /// F on arcs counts as the codes of the program say.
    pub curve_feed: bool,
    /// Blocks that are looked through where the path has no room (MD 20240).
    pub look_ahead: u32,
}

impl Default for CentrePath {
    fn default() -> CentrePath {
        CentrePath { limit: None, flat: None, disc_as_circle: false, curve_feed: false, look_ahead: 3 }
    }
}

/// From where the flank infeed of a thread cycle counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FlankReference {
    /// The crest stands at the programmed start; the last pass is shifted most.
    Crest,
    /// The last pass stands there.
    Root,
}

impl Default for Sinumerik {
    fn default() -> Sinumerik {
        Sinumerik {
            model: String::new(),
            frame_offset_incremental: None,
            circle_error: 0.01,
            circle_error_factor: 0.001,
            tool_change_by_t: None,
            save_restores_offset: None,
            g40_needs_motion: false,
            transformation_keeps_frame: false,
            main_variables_visible: false,
            feed_per_revolution: None,
            machine_moves_without_tool: false,
            modulo_shortest: false,
            shorten_corners: false,
            arc_chamfers: false,
            compensation: CentrePath::default(),
            cycle86_lift: None,
            thread_flank: None,
            called_first: None,
            beside: LeftOutBeside::default(),
        }
    }
}
