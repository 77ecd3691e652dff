//! Rexroth MTC200: what its manual leaves open, and what only the machine knows.

use std::collections::BTreeMap;

use crate::machine::axis::Axis;

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
