//! A machining cycle as its definition left it.

use crate::machine::Axis;
use crate::sema::cycle::row::Name;
use crate::text::Loc;

use super::super::cycle_definition::{DottedValue, Open, WordFeed};
use super::{Q, Row, What};

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

    /// Does the definition set this Q parameter?
    pub fn sets(&self, q: Q) -> bool {
        self.parameters.contains(&q.0) || self.word(q).is_some()
    }

    /// The word that the definition sets it to.
    pub fn word(&self, q: Q) -> Option<&'static str> {
        self.words.iter().rev().find(|(number, _)| *number == q.0).map(|(_, word)| *word)
    }

    /// The feed that FU or FZ gives it with a number.
    pub fn feed(&self, q: Q) -> Option<WordFeed> {
        self.feeds.iter().rev().find(|feed| feed.parameter == q.0).copied()
    }

    pub fn row(&self) -> &'static Row {
        super::find(self.number)
    }

    /// Does the definition set it, to a number or to a word?
    pub fn gives_q(&self, q: Q) -> bool {
        self.sets(q) || self.word(q).is_some()
    }

    /// Does the definition give this parameter?
    pub fn gives(&self, name: Name) -> bool {
        match name {
            Name::Q(number) => self.sets(Q(number)),
            // Where a feed has a place of its own, it is not the value of the part.
            Name::Part(part) if self.row().takes_in_part(part, What::Feed) => self.in_part(part, What::Value).is_some(),
            Name::Part(part) => self.part(part).is_some(),
            Name::In(part, "F") => self.in_part(part, What::Feed).is_some(),
            Name::In(part, "DR") => self.in_part(part, What::Turn).is_some(),
            Name::In(part, "RADIUS") => self.in_part(part, What::Value).is_some(),
            Name::In(part, _) => self.along(part).is_some(),
            Name::Word(_) => false,
        }
    }

    /// What a part of an old cycle holds.
    pub fn in_part(&self, part: u32, what: What) -> Option<f64> {
        self.parts.iter().find(|p| p.part == part && p.what == what).map(|p| p.value)
    }

    /// The axis of a part of an old cycle, and the length along it.
    pub fn along(&self, part: u32) -> Option<(Axis, f64)> {
        self.parts.iter().find_map(|p| match p.what {
            What::Along(axis) if p.part == part => Some((axis, p.value)),
            _ => None,
        })
    }

    /// The value in a part of an old cycle: its number, or the feed where it has no number.
    pub fn part(&self, part: u32) -> Option<f64> {
        self.in_part(part, What::Value).or_else(|| self.in_part(part, What::Feed))
    }
}
