//! The two shared languages of the compiler. Dialects end at [`contour`]; targets start at [`motion`].
//!
//! Both are streams of items with an [`Origin`]. Nothing here knows a dialect or a target.

#![cfg_attr(not(test), warn(clippy::wildcard_enum_match_arm))]

pub mod ask;
pub mod captured;
pub mod compensation;
pub mod contour;
pub mod cycle;
pub mod frame;
pub mod function;
pub mod motion;
pub mod pos;
pub mod refused;
pub mod tap;
pub mod tilt;
pub mod transformation;
pub mod undercut;
pub mod verify;
pub mod workpiece;

use crate::diag::CallPath;
use crate::text::Loc;

pub use ask::Ask;
pub use compensation::Compensation;
pub use frame::Frame;
pub use function::{Blank, Function, Remark};
pub use pos::Pos;
pub use tap::Tap;
pub use tilt::{Tilt, Tilting};
pub use transformation::Transformation;

/// Where an item comes from: the block, and how the program got there.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Origin {
    /// The block in its file, for findings and the source map.
    pub loc: Loc,
    /// The calls that led to the block.
    pub call: CallPath,
}

/// Side of the contour on which the tool lies, seen in the direction of travel, while its radius is compensated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Side {
    /// No compensation: the programmed point is on the contour.
    #[default]
    None,
    /// G41.
    Left,
    /// G42.
    Right,
}

impl Side {
    /// The other side; what a mirror makes of it.
    pub fn mirrored(self) -> Side {
        match self {
            Side::None => Side::None,
            Side::Left => Side::Right,
            Side::Right => Side::Left,
        }
    }
}

/// Feed of a cutting move. What comes with a move is above zero and finite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Feed {
    /// mm/min (degrees/min for moves of rotary axes alone).
    PerMinute(f64),
    /// mm per revolution of the spindle.
    PerRevolution(f64),
    /// Moves a minute: a move with F takes 1/F minutes (G93).
    InverseTime(f64),
}

impl Feed {
    /// The number without its unit.
    pub fn value(self) -> f64 {
        match self {
            Feed::PerMinute(f) | Feed::PerRevolution(f) | Feed::InverseTime(f) => f,
        }
    }

    /// The same kind of feed with another value.
    pub fn with_value(self, value: f64) -> Feed {
        match self {
            Feed::PerMinute(_) => Feed::PerMinute(value),
            Feed::PerRevolution(_) => Feed::PerRevolution(value),
            Feed::InverseTime(_) => Feed::InverseTime(value),
        }
    }
}
