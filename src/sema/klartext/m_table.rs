//! The M functions as a table: what each does, when it acts, and what it takes.

use crate::diag::{Code, codes};
use crate::ir::compensation::FeedAt;
use crate::ir::function::Turn;
use crate::machine::{Axis, AxisSet};
use crate::text::Span;

use super::Core;

/// The number of the M function that changes the tool.
pub(super) const M6: u32 = 6;

/// What follows an M function.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Args {
    pub feed: Option<f64>,
    pub feed_max: bool,
    pub value: Option<f64>,
    pub max: bool,
    pub axes: AxisSet,
    /// A value, or MAX, was given.
    pub given: bool,
}

/// What an M function may be followed by.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Takes {
    pub feed: bool,
    /// Axis letters without a value.
    pub letters: bool,
    /// Axis letters with a value that is no position.
    pub values: AxisSet,
    /// A name with a value: `LA 5`, `T0.01`.
    pub named: bool,
    /// `MB 50`, `MB MAX`.
    pub retract: bool,
}

/// When an M function acts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum When {
    Start,
    End,
}

/// What an M function does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Act {
    Spindle(Turn),
    SpindleAndCoolant(Turn),
    SpindleStop,
    CoolantOn,
    CoolantOff,
    Stop,
    OptionalStop,
    ProgramEnd {
        rewind: bool,
    },
    ToolChange,
    Orient,
    /// Handled where the block moves: M89, M91, M92, M99.
    Block,
    /// Smoothing, supervision: no influence on the programmed path.
    Note,
    /// M124: the control may leave out points.
    ShortPoints,
    /// Changes the compensated path: nothing without compensation.
    CompensationOnly,
    /// Leaves out parts of the compensated contour that the tool does not fit into.
    LookAhead,
    PlungeShare,
    EdgeFeed(FeedAt),
    RotaryFeed(bool),
    ShortWay(bool),
    PerRevolution(bool),
    ModuloRotary,
    FollowTip(bool),
    Retract,
    /// Ends the basic rotation.
    EndRotation,
    Refused,
}

/// The table. Everything that is not in it is the machine builder's.
pub(super) fn entry(number: u32) -> Option<(Act, When)> {
    use Act::*;
    use When::*;
    Some(match number {
        0 => (Stop, End),
        1 => (OptionalStop, End),
        2 => (ProgramEnd { rewind: false }, End),
        30 => (ProgramEnd { rewind: true }, End),
        3 => (Spindle(Turn::Clockwise), Start),
        4 => (Spindle(Turn::CounterClockwise), Start),
        5 => (SpindleStop, End),
        6 => (ToolChange, End),
        8 => (CoolantOn, Start),
        9 => (CoolantOff, End),
        13 => (SpindleAndCoolant(Turn::Clockwise), Start),
        14 => (SpindleAndCoolant(Turn::CounterClockwise), Start),
        19 => (Orient, End),
        89 | 91 | 92 | 99 => (Block, Start),
        // Constant path speed, replacement tools, kv factors, oversize errors, rounding of transitions, handwheel,
        // untilted blocks, exact stop, tilt axes, probe supervision, lift-off, limit switch messages.
        90 | 101 | 102 | 105..=108 | 112 | 113 | 118 | 130 | 134 | 135 | 138 | 141 | 148..=150 => (Note, Start),
        124 => (ShortPoints, Start),
        120 => (LookAhead, Start),
        97 | 98 | 197 => (CompensationOnly, End),
        103 => (PlungeShare, Start),
        109 => (EdgeFeed(FeedAt::Contour), Start),
        110 => (EdgeFeed(FeedAt::HollowContour), Start),
        111 => (EdgeFeed(FeedAt::Centre), Start),
        116 => (RotaryFeed(true), Start),
        117 => (RotaryFeed(false), Start),
        126 => (ShortWay(true), Start),
        127 => (ShortWay(false), Start),
        136 => (PerRevolution(true), Start),
        137 => (PerRevolution(false), Start),
        94 => (ModuloRotary, Start),
        140 => (Retract, Start),
        143 => (EndRotation, Start),
        // Switched off is how every program starts.
        115 | 145 => (Note, Start),
        128 => (FollowTip(true), Start),
        129 => (FollowTip(false), End),
        93 | 95 | 96 | 104 | 114 | 142 | 144 => (Refused, Start),
        _ => return None,
    })
}

pub(super) fn takes(number: u32) -> Takes {
    let none = Takes::default();
    match number {
        103 | 128 => Takes { feed: true, ..none },
        94 | 138 => Takes { letters: true, ..none },
        118 => Takes { letters: true, values: Axis::ALL.into_iter().collect(), ..none },
        112 => Takes { named: true, values: AxisSet::of(Axis::A), ..none },
        120 | 124 | 197 => Takes { named: true, ..none },
        140 => Takes { retract: true, feed: true, ..none },
        _ => none,
    }
}

/// Does a name with a value belong to the function?
pub(super) fn takes_name(number: u32, name: &str) -> bool {
    let known: &[&str] = match number {
        112 | 124 => &["T"],
        120 => &["LA"],
        140 => return true,
        _ => &[],
    };
    known.iter().any(|known| known.eq_ignore_ascii_case(name))
}

/// How the words of the function are written.
pub(super) fn usual_words(number: u32) -> &'static str {
    match number {
        112 | 124 => "T0.01",
        120 => "LA5",
        _ => "DL0.5",
    }
}

/// Two functions of one block that contradict each other.
pub(super) fn conflict(a: u32, b: u32) -> bool {
    let group = |n: u32| match n {
        3..=5 | 13 | 14 => 1,
        8 | 9 => 2,
        2 | 30 => 3,
        97 | 197 => 7,
        126 | 127 => 4,
        136 | 137 => 5,
        116 | 117 => 6,
        // The one ends the call that the other begins.
        89 | 99 => 8,
        _ => 0,
    };
    let coolant = |n: u32| matches!(n, 13 | 14);
    (group(a) != 0 && group(a) == group(b)) || (coolant(a) && b == 9) || (coolant(b) && a == 9)
}

/// May words follow that belong to the function?
pub(super) fn takes_words(number: u32) -> bool {
    let takes = takes(number);
    takes.feed || takes.letters || takes.named || takes.retract || !takes.values.is_empty()
}

/// What `partc check` can say of an M function in a block that does not run.
pub(super) fn refused_code(number: u32, pass_m: &[u32]) -> Option<&'static Code> {
    match entry(number) {
        Some((Act::Refused, _)) => Some(codes::K9008),
        None if !pass_m.contains(&number) => Some(codes::P2007),
        _ => None,
    }
}

/// M functions of which it was said that they are left out.
#[derive(Debug, Default)]
pub(super) struct Noted(Vec<u32>);

impl Noted {
    /// Says once of each function that it is left out.
    pub fn note(&mut self, core: &Core<'_>, number: u32, span: Span) {
        if self.0.contains(&number) {
            return;
        }
        self.0.push(number);
        let what = match number {
            91 | 92 => "stands in a block without coordinates, and has",
            94 => "finds no rotary axis beyond a turn, and has",
            103 | 111 | 117 | 127 | 129 | 137 => "switches off what is not on, and has",
            _ => "has",
        };
        core.say(span, codes::K2703::m_no_word_in_output(&number, &what));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn contradictions() {
        assert!(
            conflict(3, 4)
                && conflict(8, 9)
                && conflict(13, 9)
                && conflict(3, 5)
                && conflict(13, 3)
                && conflict(99, 89)
        );
        assert!(!conflict(3, 8) && !conflict(5, 9) && !conflict(13, 91) && !conflict(99, 30));
    }
}
