//! Rows of `[cycles]` of HEIDENHAIN Klartext.

use super::key::{Key, Kind, key};
use crate::machine::options::klartext_cycles::{OutsideThread, PatternProgram};
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
