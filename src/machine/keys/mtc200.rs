//! Rows of `[control]` of the MTC200.

use super::key::{Key, Kind, key};
use crate::machine::options::mtc200::{Centres, G52, InchSpeed, Reading, ShiftedIncrement};
use crate::machine::tree::{ConfigError, Node};
use crate::machine::values::{BOTH_STARTS, is, machine_words, positions, put, text, texts, tolerance};

pub const KEYS: &[Key] = &[
    key(
        "machine_words",
        Kind::Words,
        "MTC200: words of the machine builder that do not move the tool: a list, or a table LA_ON = \"M101\"",
        |s, v| put(&mut s.control.mtc200.machine_words, machine_words(v)?),
    )
    .or(r#"[]"#),
    key(
        "centres",
        Kind::Choice(&["settle", "absolute", "relative", "dimension"]),
        "MTC200: what I, J, K count from; settle: what fits the arcs of the program",
        |s, v| {
            s.control.mtc200.centres = match text(v) {
                "absolute" => Centres::Absolute,
                "relative" => Centres::Relative,
                "dimension" => Centres::Dimension,
                _ => Centres::Settle,
            };
            Ok(())
        },
    )
    .or(r#""settle""#),
    key("circle_tolerance", Kind::Number, "MTC200: how far the end of an arc may miss the circle, in mm", |s, v| {
        put(&mut s.control.mtc200.circle_tolerance, tolerance(v)?)
    })
    .or(r#"0.01"#),
    key("start", Kind::Free, "MTC200: older name of [start], X as a radius", |s, v| {
        if !s.start.is_empty() {
            return Err(v.fail(BOTH_STARTS));
        }
        positions(&mut s.control.mtc200.start, v)
    }),
    key("home", Kind::Free, "MTC200: machine coordinates of the home position that G74 goes to, in mm", |s, v| {
        positions(&mut s.control.mtc200.home, v)
    }),
    key("repeated_words", Kind::Choice(&["refuse", "last"]), "MTC200: which of two equal words counts", |s, v| {
        put(&mut s.control.mtc200.last_word_counts, is(v, "last"))
    })
    .or(r#""refuse""#),
    key("zero_feed", Kind::Choice(&["refuse", "previous"]), "MTC200: what F0 means", |s, v| {
        put(&mut s.control.mtc200.zero_feed_keeps, is(v, "previous"))
    })
    .or(r#""refuse""#),
    key("g52", Kind::Choice(&["refuse", "position", "shift"]), "MTC200: what G52 does", |s, v| {
        s.control.mtc200.g52 = match text(v) {
            "position" => G52::Position,
            "shift" => G52::Shift,
            _ => G52::Refuse,
        };
        Ok(())
    })
    .or(r#""refuse""#),
    key("g53", Kind::Choice(&["refuse", "machine"]), "MTC200: what positions under G53 are", |s, v| {
        put(&mut s.control.mtc200.g53_is_machine, is(v, "machine"))
    })
    .or(r#""refuse""#),
    key(
        "g91_after_offset",
        Kind::Choice(&["refuse", "with-offset", "increment"]),
        "MTC200: what an increment after a changed zero offset travels: the change as well, or itself alone",
        |s, v| {
            s.control.mtc200.g91_after_offset = match text(v) {
                "with-offset" => ShiftedIncrement::WithOffset,
                "increment" => ShiftedIncrement::Increment,
                _ => ShiftedIncrement::Refuse,
            };
            Ok(())
        },
    )
    .or(r#""refuse""#),
    key(
        "spindle_nose",
        Kind::Choice(&["warn", "refuse"]),
        "MTC200: moves along the tool axis under G47, or before the first G48",
        |s, v| put(&mut s.control.mtc200.refuse_spindle_nose, is(v, "refuse")),
    )
    .or(r#""warn""#),
    key(
        "cf_at_arcs",
        Kind::Choice(&["refuse", "along"]),
        "MTC200: CF beside an arc; along: its width is measured along the arc",
        |s, v| put(&mut s.control.mtc200.chamfers_along_arcs, is(v, "along")),
    )
    .or(r#""refuse""#),
    key(
        "confirmed",
        Kind::Texts,
        "MTC200: readings that no available manual confirms and that this control has: [\"flow\", \"degrees\"]",
        |s, v| confirm(&mut s.control.mtc200.confirmed, v),
    )
    .or("[]"),
    key("dwell", Kind::Choice(&["s", "ms"]), "MTC200: unit of the F of G04", |s, v| {
        s.control.mtc200.confirmed.push(Reading::Dwell);
        put(&mut s.control.mtc200.dwell_ms, is(v, "ms"))
    })
    .or_warn(r#""s""#),
    key("angles", Kind::Choice(&["degrees", "radians"]), "MTC200: unit of angles in formulas", |s, v| {
        s.control.mtc200.confirmed.push(Reading::Degrees);
        put(&mut s.control.mtc200.radians, is(v, "radians"))
    })
    .or_warn(r#""degrees""#),
    key(
        "rotary",
        Kind::Choice(&["shortest", "absolute"]),
        "MTC200: way of a rotary axis to an absolute position",
        |s, v| put(&mut s.control.mtc200.rotary_absolute, is(v, "absolute")),
    )
    .or(r#""shortest""#),
    key(
        "inch_speed",
        Kind::Choice(&["refuse", "metres", "feet"]),
        "MTC200: unit of the cutting speed under G70, per minute",
        |s, v| {
            s.control.mtc200.inch_speed = match text(v) {
                "metres" => InchSpeed::Metres,
                "feet" => InchSpeed::Feet,
                _ => InchSpeed::Refuse,
            };
            Ok(())
        },
    )
    .or(r#""refuse""#),
];

fn confirm(confirmed: &mut Vec<Reading>, node: &Node) -> Result<(), ConfigError> {
    for name in texts(node) {
        let known = Reading::ALL.into_iter().find(|reading| reading.name() == name);
        let names = Reading::ALL.map(Reading::name).join(", ");
        confirmed.push(known.ok_or_else(|| node.fail(format!("`{name}` is no reading: {names}")))?);
    }
    Ok(())
}
