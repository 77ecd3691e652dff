//! A machining cycle as its definition left it.

use crate::sema::cycle_table::Name;
use crate::text::Loc;

use super::super::cycle_definition::{DottedValue, Open, What};
use super::{Q, Row};

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
            Name::Part(part) => self.part(part).is_some(),
            Name::Word(_) => false,
        }
    }

    /// The value in a part of an old cycle: its number, or the feed where it has no number.
    pub fn part(&self, part: u32) -> Option<f64> {
        let of = |what: What| self.parts.iter().find(|p| p.part == part && p.what == what).map(|p| p.value);
        of(What::Value).or_else(|| of(What::Feed))
    }
}
