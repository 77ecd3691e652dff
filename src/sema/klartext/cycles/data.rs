//! What cycles 14, 20 and 270 say for the cycles behind them, and what cycle 22 leaves.

use std::rc::Rc;

use crate::geo::Element;
use crate::geo::overlay::Area;
use crate::ir::{Frame, Side};
use crate::sema::cycle::given::Given;
use crate::sema::cycle::row::Name;
use crate::text::Loc;

use super::super::known::Known;
use super::super::labels::Label;
use super::DefinedCycle;

/// What cycles 14, 20 and 270 say for the cycles behind them.
#[derive(Debug, Default)]
pub(in super::super) struct Contours {
    pub named: Known<NamedContours>,
    pub pocket: Known<Values>,
    pub train: Known<Values>,
    pub roughed: Known<Roughed>,
    /// Why the contours that a cycle 14 here names make no area, which was reported.
    pub no_area: Option<(Loc, String)>,
}

/// Cycle 14.
#[derive(Debug)]
pub(in super::super) struct NamedContours {
    pub labels: Vec<Label>,
    /// Index of the program whose labels they are.
    pub program: usize,
    pub loc: Loc,
}

/// A definition with the values that it set.
#[derive(Debug)]
pub(in super::super) struct Values {
    pub cycle: DefinedCycle,
    pub set: Vec<(u32, f64)>,
}

/// The last run of cycle 22.
#[derive(Debug)]
pub(in super::super) struct Roughed {
    pub named: Rc<NamedContours>,
    /// As it was called.
    pub tool: Option<String>,
    pub radius: f64,
    /// What its calls and its table add to its own radius.
    pub oversize: f64,
    pub allowance: f64,
    /// What was cleared, and the system in which it was.
    pub area: Area,
    pub frame: Frame,
    pub pocket: Rc<Values>,
}

impl Contours {
    /// The definition of this cycle was refused.
    pub fn lose(&mut self, number: u32) {
        match number {
            14 => self.named = Known::Lost,
            20 => self.pocket = Known::Lost,
            _ => self.train = Known::Lost,
        }
    }
}

impl Values {
    /// What the definition set it to.
    pub fn set_to(&self, name: Name) -> Option<f64> {
        self.set.iter().rev().find(|(number, _)| Name::Q(*number) == name).map(|(_, value)| *value)
    }
}

/// A definition, and what its parameters hold where another cycle takes them.
#[derive(Debug)]
pub(in super::super) struct Kept {
    pub values: Rc<Values>,
    pub given: Given,
}

/// The contour that cycle 25 follows.
#[derive(Debug)]
pub(in super::super) struct Train {
    pub elements: Vec<Element>,
    /// On which the tool lies by the contour itself.
    pub side: Side,
    /// Of cycle 270.
    pub data: Option<Kept>,
}

/// What a cycle along contours takes, as far as it is known.
#[derive(Debug)]
pub(in super::super) struct Contoured {
    pub named: Rc<NamedContours>,
    /// Of cycle 20.
    pub data: Option<Kept>,
    pub area: Option<Area>,
    pub train: Option<Train>,
}
