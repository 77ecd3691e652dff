//! Rexroth MTC200: what its manual leaves open, and what only the machine knows.

use std::collections::BTreeMap;

use crate::machine::axis::Axis;
use crate::machine::keys::{Key, Kind, key};
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

/// What I, J and K of an arc count from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Centres {
    /// What fits the arcs of the program; a program in which nothing decides is refused.
    #[default]
    Settle,
    /// The programmed zero point.
    Absolute,
    /// The start of the arc.
    Relative,
    /// Absolute under G90, relative under G91.
    Dimension,
}

/// What G52 does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum G52 {
    #[default]
    Refuse,
    /// The present position gets the values.
    Position,
    /// The zero point moves by the values.
    Shift,
}

/// Unit of the cutting speed while inches are programmed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum InchSpeed {
    #[default]
    Refuse,
    Metres,
    Feet,
}

/// Where an increment behind a changed zero offset starts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ShiftedIncrement {
    #[default]
    Refuse,
    /// At the last programmed number: the change of the offset is travelled, too.
    WithOffset,
    /// Where the tool stands: only the increment is travelled.
    Increment,
}

/// What no available manual confirms, and partc reads all the same.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reading {
    AtStart,
    Degrees,
    Flow,
    ArcRadius,
    Helix,
    Dwell,
    DiameterCodes,
    G50,
    ThreadTaper,
    MFunctions,
    Transition,
}

impl Reading {
    pub const ALL: [Reading; 11] = [
        Reading::AtStart,
        Reading::Degrees,
        Reading::Flow,
        Reading::ArcRadius,
        Reading::Helix,
        Reading::Dwell,
        Reading::DiameterCodes,
        Reading::G50,
        Reading::ThreadTaper,
        Reading::MFunctions,
        Reading::Transition,
    ];

    /// Name in the configuration.
    pub fn name(self) -> &'static str {
        match self {
            Reading::AtStart => "at-start",
            Reading::Degrees => "degrees",
            Reading::Flow => "flow",
            Reading::ArcRadius => "arc-radius",
            Reading::Helix => "helix",
            Reading::Dwell => "dwell",
            Reading::DiameterCodes => "diameter-codes",
            Reading::G50 => "g50",
            Reading::ThreadTaper => "thread-taper",
            Reading::MFunctions => "m-functions",
            Reading::Transition => "transition",
        }
    }
}

/// Settings of the MTC200 dialect.
#[derive(Debug, Clone, PartialEq)]
pub struct Mtc200 {
    /// Words of the machine builder that do not move the tool, upper case, and the M function printed for them.
    pub machine_words: BTreeMap<String, Option<u32>>,
    pub centres: Centres,
    /// How far the end of an arc may miss the circle, in mm.
    pub circle_tolerance: f64,
    /// Where the axes stand at the start, programmed coordinates in mm and degrees, radius values.
    pub start: BTreeMap<Axis, f64>,
    /// Machine coordinates of the home position.
    pub home: BTreeMap<Axis, f64>,
    /// A word written twice counts as last written.
    pub last_word_counts: bool,
    /// F0 leaves the feed as it was.
    pub zero_feed_keeps: bool,
    pub g52: G52,
    /// Positions under G53 are machine coordinates.
    pub g53_is_machine: bool,
    /// The F of G04 counts milliseconds.
    pub dwell_ms: bool,
    /// T changes the tool without M6.
    pub t_changes: bool,
    /// Angles in formulas are radians.
    pub radians: bool,
    /// An absolute position of a rotary axis is taken as it is, not the short way.
    pub rotary_absolute: bool,
    pub inch_speed: InchSpeed,
    pub g91_after_offset: ShiftedIncrement,
    /// Moves of the spindle nose (G47) are refused, not only warned of.
    pub refuse_spindle_nose: bool,
    /// CF beside an arc is measured along the arc.
    pub chamfers_along_arcs: bool,
    /// Readings that the user confirms.
    pub confirmed: Vec<Reading>,
}

impl Default for Mtc200 {
    fn default() -> Mtc200 {
        Mtc200 {
            machine_words: BTreeMap::new(),
            centres: Centres::default(),
            circle_tolerance: 0.01,
            start: BTreeMap::new(),
            home: BTreeMap::new(),
            last_word_counts: false,
            zero_feed_keeps: false,
            g52: G52::default(),
            g53_is_machine: false,
            dwell_ms: false,
            t_changes: false,
            radians: false,
            rotary_absolute: false,
            inch_speed: InchSpeed::default(),
            g91_after_offset: ShiftedIncrement::default(),
            refuse_spindle_nose: false,
            chamfers_along_arcs: false,
            confirmed: Vec::new(),
        }
    }
}
