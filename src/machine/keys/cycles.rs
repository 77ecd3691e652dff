//! Rows of `[cycles]` that several languages share.

use super::key::{Key, Kind, key};
use crate::machine::options::cycles::{
    BackwardSide, CutOffReference, DrillingZones, MultiEdgeStart, SpigotSize, Transmit,
};
use crate::machine::tree::{ConfigError, Node};
use crate::machine::values::{flag, is, number, put, text};

pub const KEYS: &[Key] = &[
    key(
        "transmit",
        Kind::Choice(&["refuse", "cartesian", "polar"]),
        "SINUMERIK: TRANSMIT and TRACYL: refused, the axes that the program sees, or X and the rotary axis of the machine",
        |s, v| {
            put(
                &mut s.cycles.transmit,
                match text(v) {
                    "cartesian" => Transmit::Cartesian,
                    "polar" => Transmit::Polar,
                    _ => Transmit::Refuse,
                },
            )
        },
    )
    .or(r#""refuse""#),
    key("groove_dwell", Kind::Flag, "SINUMERIK: CYCLE930 waits at the floor of a groove", |s, v| {
        put(&mut s.cycles.groove_dwell, flag(v))
    })
    .or("true"),
    key(
        "groove_dwell_revolutions",
        Kind::Number,
        "SINUMERIK: turns of the spindle that CYCLE930 waits at the floor (SD 55510)",
        |s, v| put(&mut s.cycles.groove_dwell_revolutions, not_below_zero(v)?),
    )
    .or("1.0"),
    key(
        "cutoff_reference",
        Kind::Choice(&["workpiece", "tip"]),
        "SINUMERIK: what CYCLE92 puts at Z0: the corner of the tool on the side of the workpiece, or the programmed tip",
        |s, v| {
            let tip = is(v, "tip");
            put(
                &mut s.cycles.cutoff_reference,
                Some(if tip { CutOffReference::Tip } else { CutOffReference::Workpiece }),
            )
        },
    )
    .or_warn(r#""workpiece""#),
    key(
        "cycle82_vari",
        Kind::Choice(&["both", "thousands-through", "thousands-predrill"]),
        "SINUMERIK: zones that one digit of `_VARI` of CYCLE82 drills slowly: both, or the one that the digit stands for",
        |s, v| {
            s.cycles.drilling_zones = match text(v) {
                "thousands-through" => DrillingZones::ThousandsThrough,
                "thousands-predrill" => DrillingZones::ThousandsPredrill,
                _ => DrillingZones::Both,
            };
            Ok(())
        },
    )
    .or(r#""both""#),
    key(
        "parts_gripper",
        Kind::Choice(&["refuse", "ignore"]),
        "SINUMERIK: the part catcher of CYCLE92 (`_DIAGM`): refused, or left out, with the same path",
        |s, v| put(&mut s.cycles.ignores_gripper, is(v, "ignore")),
    )
    .or(r#""refuse""#),
    key(
        "cycle95_rough",
        Kind::Choice(&["compensated", "tip"]),
        "SINUMERIK: how CYCLE95 roughs: with the nose radius, or by the programmed tip; default: compensated, tip on an 802D",
        |s, v| put(&mut s.cycles.layers.rough_by_tip, Some(is(v, "tip"))),
    ),
    key(
        "cut_segmentation",
        Kind::Choice(&["uniform", "edge"]),
        "SINUMERIK: where CYCLE952 puts its cuts: at equal distances, or at the edges of the contour",
        |s, v| put(&mut s.cycles.layers.cuts_at_edges, is(v, "edge")),
    )
    .or(r#""uniform""#),
    key(
        "release_distance",
        Kind::Number,
        "SINUMERIK: lift of CYCLE95 without `_VRT` and of CYCLE952, in mm (SD 55581)",
        |s, v| put(&mut s.cycles.layers.release, above_zero(v)?),
    )
    .or("1.0"),
    key(
        "rough_release_outside",
        Kind::Number,
        "SINUMERIK: lift of CYCLE951 outside, in mm; -1: its safety distance (SD 55505)",
        |s, v| put(&mut s.cycles.layers.release_outside, release(v)?),
    )
    .or("1.0"),
    key(
        "rough_release_inside",
        Kind::Number,
        "SINUMERIK: lift of CYCLE951 inside, in mm; -1: its safety distance (SD 55506)",
        |s, v| put(&mut s.cycles.layers.release_inside, release(v)?),
    )
    .or("0.5"),
    key(
        "blank_offset",
        Kind::Number,
        "SINUMERIK: how far in front of the blank rapid traverse becomes feed in CYCLE952, in mm (SD 55584)",
        |s, v| put(&mut s.cycles.layers.blank_offset, above_zero(v)?),
    )
    .or("1.0"),
    key(
        "finish_feed_percent",
        Kind::Number,
        "SINUMERIK: feed of finishing in CYCLE951, in percent of its feed (SD 55500)",
        |s, v| put(&mut s.cycles.layers.finish_feed_percent, above_zero(v)?),
    )
    .or("100.0"),
    key(
        "spigot_size",
        Kind::Choice(&["refuse", "diameter", "radius"]),
        "SINUMERIK: the sixth argument of CYCLE77 in the old form of 16 arguments",
        |s, v| {
            let size = if is(v, "diameter") { SpigotSize::Diameter } else { SpigotSize::Radius };
            put(&mut s.cycles.spigot_size, (!is(v, "refuse")).then_some(size))
        },
    )
    .or(r#""refuse""#),
    key(
        "backward_side",
        Kind::Choice(&["refuse", "travel", "contour"]),
        "SINUMERIK: side of the cutter where CYCLE72 runs its contour backwards: seen in the direction of travel, or of the contour",
        |s, v| {
            let side = if is(v, "travel") { BackwardSide::Travel } else { BackwardSide::Contour };
            put(&mut s.cycles.backward_side, (!is(v, "refuse")).then_some(side))
        },
    )
    .or(r#""refuse""#),
    key(
        "thread_milling_digits",
        Kind::Flag,
        "SINUMERIK: read the tens (1 down, 2 up) and hundreds (1 left-hand) of `_VARI` of CYCLE70; refused if not",
        |s, v| put(&mut s.cycles.thread_digits, flag(v)),
    )
    .or("false"),
    key(
        "multi_edge_start",
        Kind::Choice(&["refuse", "edge", "corner"]),
        "what of the polygon of CYCLE79 (SINUMERIK) or of cycle 258 (Klartext) lies on the first axis, turned by `_STA` or Q224: the middle of an edge, or a corner",
        |s, v| {
            let starts = if is(v, "edge") { MultiEdgeStart::Edge } else { MultiEdgeStart::Corner };
            put(&mut s.cycles.multi_edge_start, (!is(v, "refuse")).then_some(starts))
        },
    )
    .or(r#""refuse""#),
];

fn above_zero(node: &Node) -> Result<f64, ConfigError> {
    number(node).filter(|v| *v > 0.0).ok_or_else(|| node.fail("is above 0"))
}

/// A lift; -1 stands for the safety distance of the call.
fn release(node: &Node) -> Result<Option<f64>, ConfigError> {
    match number(node) {
        Some(-1.0) => Ok(None),
        Some(v) if v > 0.0 => Ok(Some(v)),
        _ => Err(node.fail("is above 0, or -1")),
    }
}

fn not_below_zero(node: &Node) -> Result<f64, ConfigError> {
    number(node).filter(|v| *v >= 0.0).ok_or_else(|| node.fail("is not below 0"))
}
