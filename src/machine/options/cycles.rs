//! `[cycles]`: what a control decides inside its machining cycles. docs/cycles.md says what each key changes.

use crate::machine::keys::{Key, Kind, key};
use crate::machine::tree::{ConfigError, Node};
use crate::machine::values::{flag, is, number, put};

pub const KEYS: &[Key] = &[
    key("groove_dwell", Kind::Flag, "SINUMERIK: CYCLE930 waits at the floor of a groove", |s, v| {
        put(&mut s.cycles.groove_dwell, flag(v))
    })
    .or("true"),
    key(
        "groove_dwell_revolutions",
        Kind::Number,
        "SINUMERIK: turns of the spindle that CYCLE930 waits at the floor (SD 55510)",
        |s, v| put(&mut s.cycles.groove_dwell_revolutions, not_below_zero(v)?),
    )
    .or("1.0"),
    key(
        "cutoff_reference",
        Kind::Choice(&["workpiece", "tip"]),
        "SINUMERIK: what CYCLE92 puts at Z0: the corner of the tool on the side of the workpiece, or the programmed tip",
        |s, v| {
            let tip = is(v, "tip");
            put(
                &mut s.cycles.cutoff_reference,
                Some(if tip { CutOffReference::Tip } else { CutOffReference::Workpiece }),
            )
        },
    )
    .or_warn(r#""workpiece""#),
];

fn not_below_zero(node: &Node) -> Result<f64, ConfigError> {
    number(node).filter(|v| *v >= 0.0).ok_or_else(|| node.fail("is not below 0"))
}

/// What a cut-off puts at its programmed Z.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CutOffReference {
    /// The corner of the tool that lies on the side of the workpiece.
    Workpiece,
    /// The programmed point of the tool.
    Tip,
}

/// `[cycles]`
#[derive(Debug, Clone, PartialEq)]
pub struct Cycles {
    /// A groove cycle with a dwell of its own waits at the floor.
    pub groove_dwell: bool,
    /// Turns of the spindle that it waits (SD 55510).
    pub groove_dwell_revolutions: f64,
    /// `None`: nobody said, so the corner on the side of the workpiece is taken, and a program that depends on it is told so.
    pub cutoff_reference: Option<CutOffReference>,
}

impl Default for Cycles {
    fn default() -> Cycles {
        Cycles { groove_dwell: true, groove_dwell_revolutions: 1.0, cutoff_reference: None }
    }
}
