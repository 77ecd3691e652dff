//! How a cycle is called, and the heights that follow.

/// How a cycle is called.
#[derive(Debug, Clone, Copy)]
pub(in super::super) struct Call {
    /// Lifts the surface, in mm.
    pub shift: f64,
    pub retract: Retract,
    pub by: By,
}

/// What says where the cycle runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) enum By {
    /// CYCL CALL, M99, M89: it runs where the tool stands.
    Block,
    /// CYCL CALL POS names the place.
    Position,
    /// A pattern or a table of points: one place of many.
    Pattern,
}

impl Call {
    /// Does the call name the place?
    pub fn placed(self) -> bool {
        self.by != By::Block
    }
}

/// Where the tool goes behind a hole of a pattern.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in super::super) enum Retract {
    /// To the second set-up clearance, or to the set-up clearance where that is higher.
    Far,
    /// To the set-up clearance.
    Near,
    /// To this height, or to the 2nd set-up clearance where that is higher.
    To(f64),
}

/// Heights of a hole by their Q parameters, in mm.
#[derive(Debug, Clone, Copy)]
pub(in super::super) struct Heights {
    pub surface: f64,
    pub clearance: f64,
    /// 2nd set-up clearance as an absolute height; not below the set-up clearance.
    pub second: f64,
}

impl Heights {
    /// Where rapid traverse ends.
    pub fn start(&self) -> f64 {
        self.surface + self.clearance
    }
}

impl Retract {
    pub fn height(self, heights: &Heights) -> f64 {
        match self {
            Retract::Far => heights.second,
            Retract::Near => heights.start(),
            Retract::To(height) => height.max(heights.second),
        }
    }
}
