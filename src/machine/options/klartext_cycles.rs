//! `[cycles]`: what a HEIDENHAIN control decides inside its machining cycles. docs/cycles.md says what each key changes.

use crate::machine::keys::{Key, Kind, key};
use crate::machine::values::{flag, is, put, text};

pub const KEYS: &[Key] = &[
    key(
        "cycle_entry",
        Kind::Choice(&["arc", "line"]),
        "HEIDENHAIN: way from the middle of a hole to its wall in cycle 208: a semicircle, or a straight line",
        |s, v| put(&mut s.cycles.klartext.straight_entry, is(v, "line")),
    )
    .or(r#""arc""#),
    key(
        "helix_from",
        Kind::Choice(&["clearance", "surface"]),
        "HEIDENHAIN: where the helix of cycle 208 begins: at the set-up clearance, or on the surface",
        |s, v| put(&mut s.cycles.klartext.helix_from_surface, is(v, "surface")),
    )
    .or(r#""clearance""#),
    key(
        "cycle_208_rings",
        Kind::Flag,
        "HEIDENHAIN: mill large holes of cycle 208 in several circles; refused if not",
        |s, v| put(&mut s.cycles.klartext.bore_in_rings, flag(v)),
    )
    .or("false"),
    key(
        "thread_267",
        Kind::Choice(&["refuse", "nominal", "core"]),
        "HEIDENHAIN: what the radius of the tool touches in cycle 267: the nominal diameter, or the core of the thread",
        |s, v| {
            s.cycles.klartext.outside_thread = match text(v) {
                "nominal" => Some(OutsideThread::Nominal),
                "core" => Some(OutsideThread::Core),
                _ => None,
            };
            Ok(())
        },
    )
    .or(r#""refuse""#),
    key(
        "pattern_program",
        Kind::Choice(&["refuse", "shift", "position"]),
        "HEIDENHAIN: what the places of CYCL CALL PAT are to the program of cycle 12: datum shifts, or where the tool goes in front of it",
        |s, v| {
            s.cycles.klartext.pattern_program = match text(v) {
                "shift" => Some(PatternProgram::Shift),
                "position" => Some(PatternProgram::Position),
                _ => None,
            };
            Ok(())
        },
    )
    .or(r#""refuse""#),
];

/// What a place of a pattern is to the program of cycle 12.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PatternProgram {
    /// A further datum shift.
    Shift,
    /// Where the tool goes in front of the program.
    Position,
}

/// What the radius of a thread mill touches on an outside thread.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OutsideThread {
    /// The nominal diameter: its tip reaches the core then.
    Nominal,
    /// The core: the radius is that of the tip.
    Core,
}

/// What HEIDENHAIN controls decide inside their machining cycles.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct KlartextCycles {
    /// Cycle 208 goes straight to the wall.
    pub straight_entry: bool,
    /// The helix of cycle 208 begins on the surface.
    pub helix_from_surface: bool,
    /// Cycle 208 makes large holes in several circles.
    pub bore_in_rings: bool,
    /// `None` refuses outside threads.
    pub outside_thread: Option<OutsideThread>,
    /// What a place of a pattern is to the program of cycle 12; refused without it.
    pub pattern_program: Option<PatternProgram>,
}
