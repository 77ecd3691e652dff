//! G functions: one table says to which group each belongs and what it does.
//!
//! Source: M 5, 6, 7, 9 (docs/sources.md).

use crate::geo::Plane;
use crate::ir::Side;

/// Kind of motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Motion {
    Rapid,
    Line,
    Clockwise,
    CounterClockwise,
    Thread,
}

impl Motion {
    pub fn is_arc(self) -> bool {
        matches!(self, Motion::Clockwise | Motion::CounterClockwise)
    }
}

/// Which zero offset is in force.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Offset {
    /// Nothing programmed: what the machine has.
    Start,
    /// G54 is 1.
    Work(u8),
    /// G53.
    Machine,
    /// A JMP reset it to what the machine's parameters say.
    Reset,
}

/// One G function of each group may stand in a block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Group {
    Motion,
    Plane,
    Dimension,
    Diameter,
    Unit,
    FollowingError,
    Transition,
    ExactStop,
    Compensation,
    CornerElement,
    ToolLength,
    Offset,
    FeedUnit,
    SpindleMode,
    /// Not modal.
    Once,
}

pub(super) const GROUPS: usize = Group::Once as usize + 1;

/// What a G function does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum G {
    Motion(Motion),
    Plane(Plane),
    /// G91 or G90.
    Incremental(bool),
    /// G16 or G15.
    Diameter(bool),
    /// G70 or G71.
    Inch(bool),
    /// Dynamics only.
    Nothing,
    /// G08.
    Smooth,
    /// G61 or G62.
    ExactStop(bool),
    Side(Side),
    /// G44 or G43.
    Chamfers(bool),
    /// G48 or G47.
    Length(bool),
    Offset(Offset),
    /// G95 or G94.
    PerRevolution(bool),
    /// G96 or G97.
    ConstantSpeed(bool),
    Dwell,
    /// G50
    ShiftTo,
    /// G51
    ShiftBy,
    /// G52
    Name,
    /// G74
    Home,
    /// G92
    SpeedLimit,
}

/// Group and function of a number.
#[inline]
pub(super) fn entry(number: u32) -> Option<(Group, G)> {
    use Group::*;
    Some(match number {
        0 => (Motion, G::Motion(self::Motion::Rapid)),
        1 => (Motion, G::Motion(self::Motion::Line)),
        2 => (Motion, G::Motion(self::Motion::Clockwise)),
        3 => (Motion, G::Motion(self::Motion::CounterClockwise)),
        33 => (Motion, G::Motion(self::Motion::Thread)),
        4 => (Once, G::Dwell),
        6 | 7 => (FollowingError, G::Nothing),
        8 => (Transition, G::Smooth),
        9 => (Transition, G::Nothing),
        15 => (Diameter, G::Diameter(false)),
        16 => (Diameter, G::Diameter(true)),
        17 => (Plane, G::Plane(crate::geo::Plane::Xy)),
        18 => (Plane, G::Plane(crate::geo::Plane::Zx)),
        19 => (Plane, G::Plane(crate::geo::Plane::Yz)),
        40 => (Compensation, G::Side(Side::None)),
        41 => (Compensation, G::Side(Side::Left)),
        42 => (Compensation, G::Side(Side::Right)),
        43 => (CornerElement, G::Chamfers(false)),
        44 => (CornerElement, G::Chamfers(true)),
        47 => (ToolLength, G::Length(false)),
        48 => (ToolLength, G::Length(true)),
        50 => (Once, G::ShiftTo),
        51 => (Once, G::ShiftBy),
        52 => (Once, G::Name),
        53 => (Offset, G::Offset(self::Offset::Machine)),
        54..=59 => (Offset, G::Offset(self::Offset::Work((number - 53) as u8))),
        61 => (ExactStop, G::ExactStop(true)),
        62 => (ExactStop, G::ExactStop(false)),
        70 => (Unit, G::Inch(true)),
        71 => (Unit, G::Inch(false)),
        74 => (Once, G::Home),
        90 => (Dimension, G::Incremental(false)),
        91 => (Dimension, G::Incremental(true)),
        92 => (Once, G::SpeedLimit),
        94 => (FeedUnit, G::PerRevolution(false)),
        95 => (FeedUnit, G::PerRevolution(true)),
        96 => (SpindleMode, G::ConstantSpeed(true)),
        97 => (SpindleMode, G::ConstantSpeed(false)),
        _ => return None,
    })
}

/// What a function that cannot be compiled is for.
pub(super) fn refused(number: u32) -> Option<&'static str> {
    Some(match number {
        20 => "free plane selection",
        30 => "coordinate transformation off",
        31 => "machining of a face by a coordinate transformation",
        32 => "machining of a cylinder by a coordinate transformation",
        36..=38 => "approach logic of endless rotary axes",
        49 => "tool length compensation, whose sense no available manual gives",
        63..=65 => "tapping in step with the spindle",
        72 | 73 => "mirror imaging",
        75 | 76 => "feed to positive stop",
        77 => "repositioning",
        78 | 79 => "scaling",
        93 => "inverse time feed",
        98 | 99 => "feed at the contour",
        _ => return None,
    })
}

/// What to write in place of a function that cannot be compiled.
pub(super) fn instead(number: u32) -> &'static str {
    match number {
        20 => "program the contour in G17, G18 or G19",
        30..=32 => "have the CAM system put out the positions of the axes themselves",
        36..=38 => {
            "leave it out of the copy that is compiled, and program positions that the axis reaches by the shortest way"
        }
        49 => "program G48 for the tip of the tool, G47 for the spindle nose",
        63..=65 => "program the thread by G33 with its lead, out again with the spindle reversed: `G33 Z-10 K1.5`",
        72 | 73 => "have the CAM system put out the mirrored contour",
        75 | 76 => "program the position itself by G01",
        77 => "leave it out of the copy that is compiled",
        78 | 79 => "have the CAM system put out the scaled contour",
        93 => "program the feed in mm/min by G94 or in mm/rev by G95",
        _ => "program the feed of the tool centre, and leave the function out",
    }
}
