//! What hid where an axis stands: a tool change, another cutting edge, a turn of the working plane, or a move in machine coordinates.

use crate::machine::axis::AXES;
use crate::machine::{Axis, AxisSet};
use crate::text::Loc;

/// What a block did that left the position of an axis unknown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum By {
    /// The tip of another tool stands elsewhere, or the changer moved the axis.
    ToolChange,
    /// The tip of another edge of the tool stands elsewhere.
    Edge,
    /// A call that is left out moved the axis.
    Call,
    /// A probe moved the axis, and its block or cycle is left out.
    Probe,
    /// The rotary axes turned into another plane, or a plane ended.
    Tilt,
    /// A curve table names the axis, and is left out.
    Table,
    /// The axis went to this machine coordinate, or with an axis that did, and where the work offset lies is not known.
    Machine(Option<f64>),
}

/// By axis the block that hid it, until it moves to a place that is known.
#[derive(Debug, Clone, Default)]
pub struct Hidden {
    axes: AxisSet,
    /// Axes that somebody may have moved by hand since.
    doubtful: AxisSet,
    by: [Option<(By, Loc)>; AXES],
    /// Those that a left-out call moved, and those that a left-out probe moved.
    called: AxisSet,
    probed: AxisSet,
}

impl Hidden {
    /// The block at `loc` hides these axes.
    pub fn hide(&mut self, axes: AxisSet, by: By, loc: Loc) {
        for axis in axes.iter() {
            self.by[axis.index()] = Some((by, loc));
        }
        self.axes = self.axes.union(axes);
        (self.called, self.probed) = (self.called.without(axes), self.probed.without(axes));
        match by {
            By::Call => self.called = self.called.union(axes),
            By::Probe => self.probed = self.probed.union(axes),
            By::ToolChange | By::Edge | By::Tilt | By::Table | By::Machine(_) => {}
        }
    }

    /// Axes that a left-out call moved, until they are named.
    #[inline]
    pub fn by_calls(&self) -> AxisSet {
        self.called
    }

    /// Axes that a left-out probe moved, until they are named.
    #[inline]
    pub fn by_probes(&self) -> AxisSet {
        self.probed
    }

    /// The program stops: any axis may be moved by hand.
    pub fn doubt(&mut self) {
        self.doubtful = AxisSet::ALL;
    }

    pub fn is_doubtful(&self, axis: Axis) -> bool {
        self.doubtful.contains(axis)
    }

    /// These axes are known again, or unknown for another reason.
    #[inline]
    pub fn show(&mut self, axes: AxisSet) {
        self.axes = self.axes.without(axes);
        (self.called, self.probed) = (self.called.without(axes), self.probed.without(axes));
        self.doubtful = self.doubtful.without(axes);
    }

    /// What hid the axis, and the block.
    pub fn of(&self, axis: Axis) -> Option<(By, Loc)> {
        self.by[axis.index()].filter(|_| self.axes.contains(axis))
    }
}

/// Why the position of an axis is not known, as a message ends: ` after the tool change in line 3`.
pub fn because(hidden: Option<(By, Loc)>, here: Loc) -> String {
    let Some((by, loc)) = hidden else { return String::new() };
    let what = match by {
        By::ToolChange => "the tool change",
        By::Edge => "the change of the cutting edge",
        By::Call => "the call",
        By::Probe => "the measuring",
        By::Tilt => "the turn of the working plane",
        By::Table => "the curve table",
        By::Machine(_) => "the move in machine coordinates",
    };
    if loc.file == here.file { format!(" after {what} in line {}", loc.line) } else { format!(" after {what}") }
}
