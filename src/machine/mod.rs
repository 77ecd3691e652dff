//! What is known besides the program: axes, tools, datums, limits, and the wishes of the user.
//!
//! In: `partc.toml`, tool tables. Out: [`Settings`], read-only for the whole run. Knows no dialect's grammar.

pub mod axis;
pub mod config;
pub mod keys;
pub mod options;
mod path_control;
pub mod schema;
pub mod settings;
pub mod show;
pub mod table;
pub mod tools;
pub mod tree;
pub mod undercut;
mod unit;
mod values;

pub use axis::{Axis, AxisSet};
pub use options::cycles::Transmit;
pub use options::klartext::{
    ApproachDepth, CcMissing, CpSign, Generation, Modulo, PolarMissing, RepeatCount, ShiftAxes,
};
pub use options::turning::{ArcChoice, RecessDepth, RecessSide, RecessWidth};
pub use path_control::{PathChoice, PathControl};
pub use settings::{
    AxisUse, ChangeCall, Compensation, LONGEST_AXIS_NAME, Left, LeftSpindle, Machine, MachineKind, OutputSettings,
    Settings, StandIn,
};
pub use tools::{Proposed, Tool, ToolKey, Tools};
pub use undercut::Undercuts;
pub use unit::Unit;
