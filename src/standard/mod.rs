//! The numbers of standards, each row with where it is printed. What controls print differently is a row of its own.
//!
//! In: nothing. Out: constants. Never: what a user or a program says.

pub mod din13;
pub mod din509;
pub mod din76;

/// Where a row is printed: the standard and its edition, or the manual of a control and its page.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Source(pub &'static str);

impl Source {
    pub const DIN_76: Source = Source("DIN 76-1");
    pub const DIN_509: Source = Source("DIN 509:1998");
    pub const PILOT_4290_TABLES: Source = Source("CNC PILOT 4290, user's manual, pp. 426-427");
    pub const PLUS_620_TABLES: Source = Source("MANUALplus 620, user's manual, p. 581; CNC PILOT 640, p. 617");
    pub const PLUS_4110_G85: Source = Source("MANUALplus 4110, programming, p. 80");
    /// The user's own: `[undercut]`.
    pub const CONFIGURATION: Source = Source("partc.toml");
}

/// How much a programmed value may differ from one of a table, in mm: more than rounding, less than a step.
pub const SAME: f64 = 1e-6;
