//! Rows of `[control]` of the SINUMERIK.

use super::key::{Key, Kind, key};
use crate::machine::options::sinumerik::{CalledFirst, FlankReference};
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
