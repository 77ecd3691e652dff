//! How the tool stands to the workpiece: as at the start, in a tilted plane, or as a plane left it that is off.
//!
//! Which rotary axes a plane turns is for the machine. What the program says of them by words of its own is kept here.

use crate::machine::{Axis, AxisSet};
use crate::text::Loc;

/// Degrees within which a rotary axis stands at 0.
const AT_ZERO: f64 = 1e-6;

/// What planes and rotary words of the program have made of the tool.
#[derive(Debug, Clone, Default)]
pub struct Orientation {
    stands: Stands,
    /// Rotary axes that the program moves by their own words.
    moved: AxisSet,
    /// Those of them that such a word took to 0 last.
    at_zero: AxisSet,
    /// A plane turned rotary axes.
    turned: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Default)]
enum Stands {
    /// As at the start, or as rotary words of the program say.
    #[default]
    Upright,
    /// Along Z of the tilted plane in force.
    InPlane,
    /// Along Z of a plane that the block at this place switched off.
    Askew(Loc),
}

impl Orientation {
    /// The rotary axes turn into a plane.
    pub fn turn_into_plane(&mut self) {
        *self = Orientation { stands: Stands::InPlane, turned: true, at_zero: AxisSet::EMPTY, ..*self };
    }

    /// They turn back until the tool stands along Z of the workpiece.
    pub fn turn_back(&mut self) {
        *self = Orientation { stands: Stands::Upright, turned: true, at_zero: self.moved, ..*self };
    }

    /// The block at `loc` ends the plane, and the rotary axes stay.
    pub fn leave_plane(&mut self, loc: Loc) {
        if self.stands == Stands::InPlane {
            self.stands = Stands::Askew(loc);
        }
    }

    /// A word of the program takes a rotary axis there, without frame, or nobody knows where. Behind a plane that is off the tool
    /// stands upright again once each of `tilting`, the axes that turn tool or part into planes, was taken to 0; where nobody said
    /// which these are, never.
    pub fn rotary_move(&mut self, axis: Axis, to: Option<f64>, tilting: AxisSet) {
        self.moved.insert(axis);
        if to.is_some_and(|to| to.abs() < AT_ZERO) {
            self.at_zero.insert(axis);
        } else {
            self.at_zero.remove(axis);
        }
        let all = !tilting.is_empty() && tilting.without(self.at_zero).is_empty();
        if matches!(self.stands, Stands::Askew(_)) && all && !self.is_turned_by_words() {
            self.stands = Stands::Upright;
        }
    }

    /// May main axes move by coordinates of the program?
    #[inline]
    pub fn may_move(&self) -> bool {
        !matches!(self.stands, Stands::Askew(_))
    }

    /// The block that switched off the plane in which the tool still stands.
    pub fn askew_since(&self) -> Option<Loc> {
        match self.stands {
            Stands::Askew(loc) => Some(loc),
            Stands::Upright | Stands::InPlane => None,
        }
    }

    /// Does the tool stand along Z of the workpiece, as far as planes go?
    pub fn is_upright(&self) -> bool {
        self.stands == Stands::Upright
    }

    /// Do words of the program leave a rotary axis elsewhere than at 0?
    pub fn is_turned_by_words(&self) -> bool {
        !self.moved.without(self.at_zero).is_empty()
    }

    /// Has a plane turned rotary axes? Where a work offset lies in the machine is not known any more then.
    pub fn is_disturbed(&self) -> bool {
        self.turned
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn both() -> AxisSet {
        [Axis::A, Axis::C].into_iter().collect()
    }

    fn here() -> Loc {
        Loc { file: crate::text::FileId(0), line: 7, span: crate::text::Span::default() }
    }

    #[test]
    fn a_plane_that_is_off_leaves_the_tool_askew_until_rotary_axes_turn_back() {
        let mut tool = Orientation::default();
        assert!(tool.may_move() && tool.is_upright() && !tool.is_disturbed());
        tool.leave_plane(here());
        assert!(tool.may_move(), "no plane was on");
        tool.turn_into_plane();
        assert!(tool.may_move() && !tool.is_upright() && tool.is_disturbed());
        tool.leave_plane(here());
        assert_eq!((tool.may_move(), tool.askew_since()), (false, Some(here())));
        tool.turn_back();
        assert!(tool.may_move() && tool.is_upright());
        tool.turn_into_plane();
        tool.leave_plane(here());
        tool.turn_into_plane();
        assert!(tool.may_move());
    }

    #[test]
    fn all_rotary_axes_of_the_program_have_to_stand_at_zero() {
        let mut tool = Orientation::default();
        tool.rotary_move(Axis::A, Some(30.0), both());
        tool.rotary_move(Axis::C, Some(0.0), both());
        assert!(tool.may_move() && tool.is_turned_by_words());
        tool.turn_into_plane();
        tool.leave_plane(here());
        tool.rotary_move(Axis::C, Some(0.0), both());
        assert!(!tool.may_move(), "A turned before the plane");
        tool.rotary_move(Axis::A, None, both());
        assert!(!tool.may_move(), "an increment says no place");
        tool.rotary_move(Axis::A, Some(360.0), both());
        assert!(!tool.may_move(), "a turn may be more than the axis counts");
        tool.rotary_move(Axis::A, Some(0.0), both());
        assert!(tool.may_move() && tool.is_upright());
    }

    #[test]
    fn axes_that_nobody_named_are_not_known_to_be_back() {
        let mut tool = Orientation::default();
        tool.turn_into_plane();
        tool.leave_plane(here());
        for axis in [Axis::A, Axis::C] {
            tool.rotary_move(axis, Some(0.0), AxisSet::EMPTY);
        }
        assert!(!tool.may_move());
    }

    #[test]
    fn where_rotary_axes_stood_before_a_plane_says_nothing_behind_it() {
        let mut tool = Orientation::default();
        tool.rotary_move(Axis::A, Some(0.0), AxisSet::of(Axis::A));
        tool.turn_into_plane();
        tool.leave_plane(here());
        assert!(!tool.may_move());
        tool.rotary_move(Axis::A, Some(-0.0), AxisSet::of(Axis::A));
        assert!(tool.may_move());
    }
}
