//! A definition of CYCL DEF while it is read.

use crate::machine::Axis;
use crate::text::Loc;

use crate::sema::run::Site;

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

/// A word of a definition that is left out.
#[derive(Debug, Clone)]
pub(super) struct LeftWord {
    pub text: String,
    pub does: Does,
    pub loc: Loc,
}

/// What a word would do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Does {
    /// It is a value of the cycle.
    Nothing,
    /// It says where an axis goes.
    Moves(Axis),
    /// It switches something, or sets a text.
    Acts,
}

impl Does {
    /// Reads a word out of the name of a cycle: `X+50`, `IX+5`, `M3`. Nothing for a word of the name.
    pub fn read(word: &str) -> Option<Does> {
        let upper = word.to_ascii_uppercase();
        let of_axis = |text: &str| Axis::of(*text.as_bytes().first()?).filter(|_| is_value(&text[1..]));
        if let Some(axis) = of_axis(&upper).or_else(|| of_axis(upper.strip_prefix('I')?)) {
            return Some(Does::Moves(axis));
        }
        if upper.strip_prefix('M').is_some_and(is_value) {
            return Some(Does::Acts);
        }
        upper.contains(|c: char| c.is_ascii_digit()).then_some(Does::Nothing)
    }
}

/// `+50`, `-.5`, `Q5`, `+QL1`
fn is_value(text: &str) -> bool {
    let number = text.strip_prefix(['+', '-']).unwrap_or(text);
    let number = ["QL", "QR", "Q"].iter().find_map(|q| number.strip_prefix(q)).unwrap_or(number);
    number.starts_with(|c: char| c.is_ascii_digit() || c == '.') && number.contains(|c: char| c.is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_in_names_of_cycles() {
        for (word, does) in [
            ("X+50", Some(Does::Moves(Axis::X))),
            ("iz-.5", Some(Does::Moves(Axis::Z))),
            ("C+Q5", Some(Does::Moves(Axis::C))),
            ("M3", Some(Does::Acts)),
            ("F100", Some(Does::Nothing)),
            ("5", Some(Does::Nothing)),
            ("ATC", None),
            ("X", None),
            ("", None),
            ("I", None),
        ] {
            assert_eq!(Does::read(word), does, "{word}");
        }
    }
}
