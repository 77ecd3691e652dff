//! A machining cycle as its definition left it.

use crate::machine::Axis;
use crate::sema::cycle::row::Name;
use crate::text::Loc;

use super::super::cycle_definition::{DottedValue, Open, What, WordFeed};
use super::Row;

/// A machining cycle as it was defined.
#[derive(Debug)]
pub(in super::super) struct DefinedCycle {
    pub number: u32,
    /// Where.
    pub loc: Loc,
    /// Millimetres per unit of length of the definition.
    pub mm: f64,
    parameters: Vec<u32>,
    words: Vec<(u32, &'static str)>,
    feeds: Vec<WordFeed>,
    parts: Vec<DottedValue>,
}

impl DefinedCycle {
    pub fn new(open: &Open, loc: Loc, mm: f64) -> DefinedCycle {
        DefinedCycle {
            number: open.number,
            loc,
            mm,
            parameters: open.parameters.iter().map(|(q, _)| *q).collect(),
            words: open.words.clone(),
            feeds: open.feeds.clone(),
            parts: open.parts.clone(),
        }
    }

    /// The word that the definition sets it to.
    pub fn word(&self, name: Name) -> Option<&'static str> {
        self.words.iter().rev().find(|(number, _)| Name::Q(*number) == name).map(|(_, word)| *word)
    }

    /// The feed that FU or FZ gives it with a number.
    pub fn feed(&self, name: Name) -> Option<WordFeed> {
        self.feeds.iter().rev().find(|feed| Name::Q(feed.parameter) == name).copied()
    }

    pub fn row(&self) -> &'static Row {
        super::find(self.number)
    }

    /// Does the definition give this parameter?
    pub fn gives(&self, name: Name) -> bool {
        match name {
            Name::Q(number) => self.parameters.contains(&number) || self.word(name).is_some(),
            _ => self.in_definition(name).is_some(),
        }
    }

    /// The value of an old cycle that stands in its definition.
    pub fn in_definition(&self, name: Name) -> Option<f64> {
        match name {
            // Where a feed has a place of its own, it is not the value of the part.
            Name::Part(part) if self.row().takes_in_part(part, What::Feed) => self.in_part(part, What::Value),
            Name::Part(part) => self.in_part(part, What::Value).or_else(|| self.in_part(part, What::Feed)),
            Name::In(part, "F") => self.in_part(part, What::Feed),
            Name::In(part, "DR") => self.in_part(part, What::Turn),
            Name::In(part, "RADIUS") => self.in_part(part, What::Value),
            Name::In(part, _) => self.along(part).map(|(_, length)| length),
            Name::Q(_) | Name::Word(_) => None,
        }
    }

    /// What a part of an old cycle holds.
    fn in_part(&self, part: u32, what: What) -> Option<f64> {
        self.parts.iter().find(|p| p.part == part && p.what == what).map(|p| p.value)
    }

    /// The axis of a part of an old cycle, and the length along it.
    pub fn along(&self, part: u32) -> Option<(Axis, f64)> {
        self.parts.iter().find_map(|p| match p.what {
            What::Along(axis) if p.part == part => Some((axis, p.value)),
            _ => None,
        })
    }
}
