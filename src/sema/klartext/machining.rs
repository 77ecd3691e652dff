//! A machining cycle as its definition left it.

use crate::text::Loc;

use super::cycle::Open;

/// A value in a part of an old machining cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Part {
    pub part: u32,
    pub what: What,
    pub value: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum What {
    Value,
    Feed,
}

/// A machining cycle as it was defined.
#[derive(Debug)]
pub(super) struct Machining {
    pub number: u32,
    /// Where.
    pub loc: Loc,
    /// Millimetres per unit of length of the definition.
    pub mm: f64,
    parameters: Vec<u32>,
    words: Vec<(u32, &'static str)>,
    parts: Vec<Part>,
}

impl Machining {
    pub fn new(open: &Open, loc: Loc, mm: f64) -> Machining {
        Machining {
            number: open.number,
            loc,
            mm,
            parameters: open.parameters.iter().map(|(q, _)| *q).collect(),
            words: open.words.clone(),
            parts: open.parts.clone(),
        }
    }

    /// Does the definition set this Q parameter?
    pub fn sets(&self, q: u32) -> bool {
        self.parameters.contains(&q) || self.word(q).is_some()
    }

    /// The word that the definition sets it to.
    pub fn word(&self, q: u32) -> Option<&'static str> {
        self.words.iter().rev().find(|(number, _)| *number == q).map(|(_, word)| *word)
    }

    /// The value in a part of an old cycle: its number, or the feed where it has no number.
    pub fn part(&self, part: u32) -> Option<f64> {
        let of = |what: What| self.parts.iter().find(|p| p.part == part && p.what == what).map(|p| p.value);
        of(What::Value).or_else(|| of(What::Feed))
    }

    pub fn has_part(&self, part: u32) -> bool {
        self.part(part).is_some()
    }
}
