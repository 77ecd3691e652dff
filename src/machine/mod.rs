//! What is known besides the program: axes, tools, datums, limits, and the wishes of the user.
//!
//! In: `partc.toml`, tool tables. Out: [`Settings`], read-only for the whole run. Knows no dialect's grammar.

pub mod axis;
pub mod config;
pub mod keys;
pub mod mtc200;
pub mod schema;
pub mod settings;
pub mod show;
pub mod tools;
pub mod tree;
pub mod undercut;
mod values;

pub use axis::{Axis, AxisSet};
pub use settings::{
    ArcChoice, AxisUse, CcMissing, Compensation, Control, CpSign, Generation, LONGEST_AXIS_NAME, Limits, Machine,
    MachineKind, Modulo, OutputSettings, PolarMissing, RecessDepth, RecessSide, RecessWidth, RepeatCount, Settings,
    ShiftAxes, StandIn, Unit,
};
pub use tools::{Proposed, Tool, ToolKey, Tools};
pub use undercut::Undercuts;
