//! `[cycles]`: what a HEIDENHAIN control decides inside its machining cycles. docs/cycles.md says what each key changes.

use crate::machine::keys::{Key, Kind, key};
use crate::machine::values::{flag, is, number, put, text};

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
        "mp7430",
        Kind::Number,
        "HEIDENHAIN: width of a cut of cycles 4 and 5 in radii of the cutter, 0.1 to 1.9999 (machine parameter 7430)",
        |s, v| {
            let width = number(v).filter(|width| (0.1..=1.9999).contains(width));
            put(&mut s.cycles.klartext.old_overlap, width.ok_or_else(|| v.fail("is 0.1 to 1.9999"))?)
        },
    )
    .or("1.2"),
    key(
        "q202",
        Kind::Choice(&["stroke", "pair"]),
        "HEIDENHAIN: what falls by Q202 in cycles 210 and 211: each stroke, or a stroke to and one fro",
        |s, v| put(&mut s.cycles.klartext.strokes_in_pairs, Some(is(v, "pair"))),
    )
    .or_warn(r#""stroke""#),
    key(
        "rows",
        Kind::Choice(&["radius", "edge"]),
        "HEIDENHAIN: where the outer paths of cycle 230 lie: a radius inside of the sides, or on them",
        |s, v| put(&mut s.cycles.klartext.rows_on_edges, is(v, "edge")),
    )
    .or(r#""radius""#),
    key(
        "pattern_program",
        Kind::Choice(&["refuse", "shift", "position"]),
        "HEIDENHAIN: what the places of CYCL CALL PAT are to the program of cycle 12: datum shifts, or where the tool goes before it",
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
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KlartextCycles {
    /// Cycle 208 goes straight to the wall.
    pub straight_entry: bool,
    /// The helix of cycle 208 begins on the surface.
    pub helix_from_surface: bool,
    /// Cycle 208 makes large holes in several circles.
    pub bore_in_rings: bool,
    /// `None` refuses outside threads.
    pub outside_thread: Option<OutsideThread>,
    /// Width of a cut of the old pockets, in radii of the cutter.
    pub old_overlap: f64,
    /// Two strokes of a slot fall by its infeed; `None`: one does, which is said.
    pub strokes_in_pairs: Option<bool>,
    /// The outer paths of cycle 230 lie on the sides of the face.
    pub rows_on_edges: bool,
    /// What a place of a pattern is to the program of cycle 12; refused without it.
    pub pattern_program: Option<PatternProgram>,
}

impl Default for KlartextCycles {
    fn default() -> KlartextCycles {
        KlartextCycles {
            straight_entry: false,
            helix_from_surface: false,
            bore_in_rings: false,
            outside_thread: None,
            old_overlap: 1.2,
            strokes_in_pairs: None,
            rows_on_edges: false,
            pattern_program: None,
        }
    }
}
