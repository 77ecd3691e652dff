//! A definition of CYCL DEF while it is read.

use crate::machine::Axis;
use crate::text::Loc;

use crate::sema::run::Site;

use super::builders_cycle::LeftWord;
use super::labels::Label;

/// A definition that is being read.
#[derive(Debug)]
pub(super) struct Open {
    pub number: u32,
    pub here: Site,
    /// Highest part read; `None` for a cycle with Q parameters.
    pub part: Option<u32>,
    pub axes: Vec<AxisValue>,
    /// Values without an axis.
    pub values: Vec<Labelled>,
    /// Q parameters by number.
    pub parameters: Vec<(u32, f64)>,
    /// Q parameters that are set to a word: FMAX, FAUTO, FU, PREDEF.
    pub words: Vec<(u32, &'static str)>,
    /// Feeds that FU and FZ give with a number.
    pub feeds: Vec<WordFeed>,
    /// Parameters stand in lines of their own, without `~`.
    pub loose: bool,
    /// What the parts of an old machining cycle hold.
    pub parts: Vec<DottedValue>,
    pub table_row: bool,
    pub program: Option<String>,
    /// Labels of contours.
    pub contours: Vec<Label>,
    /// Words of a cycle that nobody knows.
    pub left: Vec<LeftWord>,
    pub failed: bool,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct AxisValue {
    pub axis: Axis,
    pub incremental: bool,
    pub value: Option<f64>,
    pub loc: Loc,
}

/// `Q206=FU0.2`
#[derive(Debug, Clone, Copy)]
pub(super) struct WordFeed {
    pub parameter: u32,
    /// FZ.
    pub per_tooth: bool,
    /// In the unit of the definition.
    pub value: f64,
}

/// A value with the name in front of it, in upper case.
#[derive(Debug, Clone)]
pub(super) struct Labelled {
    pub label: String,
    pub value: f64,
}

impl Open {
    pub fn new(number: u32, part: Option<u32>, here: Site, failed: bool) -> Open {
        Open {
            number,
            here,
            part,
            axes: Vec::new(),
            values: Vec::new(),
            parameters: Vec::new(),
            words: Vec::new(),
            feeds: Vec::new(),
            loose: false,
            parts: Vec::new(),
            table_row: false,
            program: None,
            contours: Vec::new(),
            left: Vec::new(),
            failed,
        }
    }
}

/// A value in a part of an old machining cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct DottedValue {
    pub part: u32,
    pub what: What,
    pub value: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum What {
    Value,
    Feed,
    /// A length along an axis.
    Along(Axis),
    /// DR: 1 counter-clockwise, -1 clockwise.
    Turn,
}
