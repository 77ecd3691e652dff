//! Where the tool stands, as far as the program says.
//!
//! An axis is *known*; or *lost*, because a reported error hides where it stands, which is worth no second report; or
//! *unknown*, until the program says it. Before its first move it may stand where `[start]` says, behind a tool change where
//! `[machine] after_tool_change` says. What hid the place of an axis is remembered until it moves.

use crate::diag::Help;
use crate::geo::{Plane, Point2};
use crate::ir::{Frame, Pos};
use crate::machine::{Axis, AxisSet};

use super::hidden::{By, Hidden};
use super::start::Start;
use crate::text::Loc;

/// The position that one block leaves to the next: mm (X: radius) and degrees in the programmed system.
#[derive(Debug, Clone)]
pub struct Position {
    at: Pos,
    /// Numbers that the program wrote last, of axes that stand elsewhere in the programmed system: the frame moved
    /// under them, or the tool was left beside them.
    programmed: Pos,
    /// Where the last move of a block began; nothing where the position comes from elsewhere.
    from: Pos,
    /// A cycle moved last.
    by_cycle: bool,
    lost: AxisSet,
    hidden: Hidden,
    start: Start,
}

/// Why the position of an axis cannot be said.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Missing {
    /// An error was reported for it.
    Lost,
    /// The program has not said it.
    Unknown,
}

impl Position {
    /// The axes stand where `[start]` says.
    pub fn new(start: Start) -> Position {
        Position {
            at: start.position(),
            programmed: Pos::UNKNOWN,
            from: Pos::UNKNOWN,
            by_cycle: false,
            lost: AxisSet::EMPTY,
            hidden: Hidden::default(),
            start,
        }
    }

    // Questions.

    /// Did a cycle move last, so that no block leads to where the tool stands?
    pub fn moved_by_cycle(&self) -> bool {
        self.by_cycle
    }

    #[inline]
    pub fn get(&self, axis: Axis) -> Option<f64> {
        self.at.get(axis)
    }

    /// All that is known.
    #[inline]
    pub fn at(&self) -> &Pos {
        &self.at
    }

    /// Where the tool stands in a plane, if both axes are known.
    #[inline]
    pub fn in_plane(&self, plane: Plane) -> Option<Point2> {
        self.at.in_plane(plane)
    }

    /// Where the last move of a block began in a plane, if both axes are known.
    pub fn move_began(&self, plane: Plane) -> Option<Point2> {
        self.from.in_plane(plane)
    }

    /// Where an axis stands, or why that is not known.
    #[inline]
    pub fn require(&self, axis: Axis) -> Result<f64, Missing> {
        match self.at.get(axis) {
            Some(at) => Ok(at),
            None if self.lost.contains(axis) => Err(Missing::Lost),
            None => Err(Missing::Unknown),
        }
    }

    /// The number that the program wrote last, or where the axis stands.
    #[inline]
    pub fn programmed(&self, axis: Axis) -> Option<f64> {
        self.programmed.get(axis).or(self.at.get(axis))
    }

    /// Does the tool stand elsewhere than at the numbers written last?
    pub fn stands_beside(&self, axes: AxisSet) -> bool {
        !self.programmed.known().common(axes).is_empty()
    }

    #[inline]
    pub fn is_lost(&self, axis: Axis) -> bool {
        self.lost.contains(axis)
    }

    /// The positions of `[start]` that still hold.
    pub fn start(&self) -> Pos {
        self.start.position()
    }

    /// What else to do where an axis is not known, as a help goes on: the key that would say it.
    pub fn or_say(&self, axis: Axis) -> Help {
        let changed = matches!(self.hidden.of(axis), Some((By::ToolChange, _)));
        self.start.or_say(axis, changed)
    }

    /// What hid where the axis stands, and the block that did.
    pub fn hidden(&self, axis: Axis) -> Option<(By, Loc)> {
        self.hidden.of(axis)
    }

    /// Axes that stand where a left-out call moved them: each move has to name them.
    #[inline]
    pub fn left_by_calls(&self) -> AxisSet {
        self.hidden.by_calls()
    }

    /// Axes that stand where a left-out probe moved them: each cut has to name them.
    #[inline]
    pub fn left_by_probes(&self) -> AxisSet {
        self.hidden.by_probes()
    }

    /// Somebody may have moved the axis by hand since it moved by a block.
    pub fn may_be_moved(&self, axis: Axis) -> bool {
        self.hidden.is_doubtful(axis)
    }

    // Moves.

    /// The axes that `end` names move there.
    #[inline]
    pub fn move_to(&mut self, end: &Pos) {
        self.from = self.at;
        self.by_cycle = false;
        self.at.update(end);
        self.arrived(end.known());
    }

    /// What led to the position is no move of one block.
    pub fn forget_way(&mut self) {
        self.from.clear();
    }

    /// The tool moves to a point of a plane.
    #[inline]
    pub fn move_in_plane(&mut self, plane: Plane, to: Point2) {
        self.forget_way();
        self.at.set_in_plane(plane, to);
        let (first, second, _) = plane.axes();
        self.arrived([Axis::ALL[first], Axis::ALL[second]].into_iter().collect());
    }

    /// A cycle leaves the tool at `end` after moving these axes.
    pub fn cycle_leaves(&mut self, end: &Pos, moved: AxisSet) {
        self.forget_way();
        self.at = *end;
        self.by_cycle = true;
        self.arrived(moved);
    }

    #[inline]
    fn arrived(&mut self, axes: AxisSet) {
        if !self.programmed.known().is_empty() {
            for axis in axes.iter() {
                self.programmed.forget(axis);
            }
        }
        self.lost = self.lost.without(axes);
        self.hidden.show(axes);
        self.start.touch(axes);
    }

    /// The tool was left beside the number that the program wrote.
    pub fn leave_beside(&mut self, axis: Axis, programmed: f64) {
        self.forget_way();
        self.programmed.set(axis, programmed);
    }

    // Losses.

    /// Forgets where these axes are, because of a reported error.
    pub fn lose(&mut self, axes: AxisSet) {
        self.forget_way();
        for axis in axes.iter() {
            self.at.forget(axis);
            self.programmed.forget(axis);
        }
        self.hidden.show(axes);
        self.lost = self.lost.union(axes);
    }

    /// Forgets where these axes are: they moved to where the program cannot say, or their tip is another one.
    pub fn forget(&mut self, axes: AxisSet) {
        self.forget_way();
        for axis in axes.iter() {
            self.at.forget(axis);
            self.programmed.forget(axis);
        }
        self.hidden.show(axes);
        self.start.touch(axes);
    }

    /// The block at `loc` brings another tip: where it is along these axes is not known.
    pub fn forget_tip(&mut self, axes: AxisSet, by: By, loc: Loc) {
        for axis in axes.iter() {
            self.start.change_tip(axis);
        }
        self.forget(axes);
        self.not_lost(axes);
        self.hidden.hide(axes, by, loc);
    }

    /// Somebody may move the axes by hand before the next block.
    pub fn stops(&mut self) {
        self.hidden.doubt();
    }

    /// Where `[machine] after_tool_change` says that axes stand, and whether it counts from the machine zero.
    pub fn after_change(&self) -> (Pos, bool) {
        self.start.after_change()
    }

    /// These axes stand at places of the work offset in force, as the configuration says: what of them and of the axes they turn
    /// into is known in `frame`.
    pub fn stand_in_offset(&mut self, places: &Pos, frame: &Frame) -> Pos {
        let axes = places.known();
        if axes.is_empty() {
            return Pos::UNKNOWN;
        }
        self.forget_way();
        let mut at = frame.apply(&self.at);
        at.update(places);
        self.at = frame.unapply(&at);
        let said = if frame.is_shift() { axes } else { self.at.known() };
        self.arrived(said);
        let mut known = Pos::UNKNOWN;
        for axis in said.iter() {
            if let Some(value) = self.at.get(axis) {
                known.set(axis, value);
            }
        }
        known
    }

    /// Forgets where these axes are, but not the numbers that the program wrote last.
    pub fn forget_place(&mut self, axes: AxisSet) {
        self.forget_way();
        self.keep_programmed();
        for axis in axes.iter() {
            self.at.forget(axis);
        }
        self.hidden.show(axes);
    }

    /// The block at `loc` is why the place of these axes is not known.
    pub fn hide(&mut self, axes: AxisSet, by: By, loc: Loc) {
        self.hidden.hide(axes, by, loc);
    }

    /// Forgets everything but what was lost; `[start]` still says where axes stand that never moved.
    pub fn clear(&mut self) {
        self.forget_way();
        self.at.clear();
        self.programmed.clear();
        self.hidden.show(AxisSet::ALL);
    }

    /// These axes are unknown for another reason than a reported error: that they are is worth a report.
    pub fn not_lost(&mut self, axes: AxisSet) {
        self.lost = self.lost.without(axes);
    }

    // Systems.

    /// The numbers that were written last stay what they are when the frame changes.
    pub fn keep_programmed(&mut self) {
        for (axis, at) in self.at.iter() {
            if self.programmed.get(axis).is_none() {
                self.programmed.set(axis, at);
            }
        }
    }

    /// The frame changes under the tool, which stays where it is. A lost axis takes those with it that it turns into.
    pub fn through_frame(&mut self, from: &Frame, to: &Frame) {
        self.forget_way();
        let known = self.at.known();
        self.at = to.unapply(&from.apply(&self.at));
        if !self.lost.is_empty() {
            self.lost = self.lost.union(known.without(self.at.known()));
        }
    }

    /// Forgets every axis that was left beside its number.
    pub fn forget_beside(&mut self) {
        self.forget_way();
        for axis in self.programmed.known().iter() {
            self.at.forget(axis);
        }
        self.programmed.clear();
    }

    /// The block at `loc` took these axes to machine coordinates: what of `frame` depends on them is unknown.
    pub fn moved_by_machine(&mut self, end: &Pos, frame: &Frame, loc: Loc) {
        let axes = end.known();
        self.forget_way();
        let before = self.at.known();
        let mut at = frame.apply(&self.at);
        for axis in axes.iter() {
            at.forget(axis);
            self.programmed.forget(axis);
        }
        self.at = frame.unapply(&at);
        self.lost = self.lost.without(axes);
        self.start.touch(axes);
        self.hidden.show(axes);
        self.hidden.hide(before.without(self.at.known()).without(axes), By::Machine(None), loc);
        for (axis, value) in end.iter().filter(|(axis, _)| self.at.get(*axis).is_none()) {
            self.hidden.hide(AxisSet::of(axis), By::Machine(Some(value)), loc);
        }
    }

    // The start.

    /// These axes do not stand where `[start]` says any more.
    pub fn leave_start(&mut self, axes: AxisSet) {
        self.start.touch(axes);
    }

    /// Another work offset is selected in place of the one that `[start]` counts in.
    pub fn end_start(&mut self) {
        self.start.end();
    }

    /// A work offset was selected: axes that never moved stand in it where `[start]` says.
    pub fn take_start(&mut self, frame: &Frame) {
        self.forget_way();
        let start = self.start.position();
        if start.known().is_empty() {
            return;
        }
        self.at.update(&frame.unapply(&start));
        self.programmed.update(&start);
    }

    /// A new system: nothing is known but where axes stand that never moved.
    pub fn stand_at_start(&mut self) {
        self.forget_way();
        self.at = self.start.position();
        self.programmed.clear();
        self.lost = AxisSet::EMPTY;
        self.hidden.show(AxisSet::ALL);
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Matrix3;

    use super::*;
    use crate::machine::Settings;

    fn nowhere() -> Position {
        Position::new(Start::default())
    }

    fn at(values: &[(Axis, f64)]) -> Pos {
        let mut pos = Pos::UNKNOWN;
        for (axis, value) in values {
            pos.set(*axis, *value);
        }
        pos
    }

    fn shifted(x: f64) -> Frame {
        let mut shift = [0.0; 9];
        shift[0] = x;
        Frame::new(Matrix3::identity(), shift).expect("a shift is a frame")
    }

    /// A quarter turn about Z.
    fn turned() -> Frame {
        Frame::new(Matrix3::new(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0), [0.0; 9]).expect("a turn is a frame")
    }

    fn here() -> Loc {
        Loc { file: crate::text::FileId(0), line: 3, span: crate::text::Span::default() }
    }

    fn with_start(axis: Axis, value: f64) -> Position {
        let mut settings = Settings::default();
        settings.start.insert(axis, value);
        Position::new(Start::new(&settings, false))
    }

    #[test]
    fn an_axis_is_unknown_until_the_program_moves_it() {
        let mut position = nowhere();
        assert_eq!(position.require(Axis::X), Err(Missing::Unknown));
        position.move_to(&at(&[(Axis::X, 5.0)]));
        assert_eq!(position.require(Axis::X), Ok(5.0));
        assert_eq!(position.in_plane(Plane::Xy), None);
        position.move_in_plane(Plane::Xy, Point2::new(1.0, 2.0));
        assert_eq!((position.get(Axis::X), position.get(Axis::Y)), (Some(1.0), Some(2.0)));
    }

    #[test]
    fn a_lost_axis_stays_lost_until_it_moves() {
        let mut position = nowhere();
        position.move_to(&at(&[(Axis::X, 5.0), (Axis::Y, 6.0)]));
        position.lose(AxisSet::of(Axis::X));
        assert_eq!(position.require(Axis::X), Err(Missing::Lost));
        assert_eq!(position.require(Axis::Y), Ok(6.0));
        position.forget(AxisSet::of(Axis::X));
        assert_eq!(position.require(Axis::X), Err(Missing::Lost), "what follows an error is not worth another one");
        position.move_to(&at(&[(Axis::X, 1.0)]));
        position.forget(AxisSet::of(Axis::X));
        assert_eq!(position.require(Axis::X), Err(Missing::Unknown));
        position.lose(AxisSet::of(Axis::X));
        position.not_lost(AxisSet::of(Axis::X));
        assert_eq!(position.require(Axis::X), Err(Missing::Unknown));
    }

    #[test]
    fn a_frame_moves_under_the_tool_and_leaves_the_numbers() {
        let mut position = nowhere();
        position.move_to(&at(&[(Axis::X, 50.0)]));
        position.keep_programmed();
        position.through_frame(&Frame::default(), &shifted(10.0));
        assert_eq!((position.get(Axis::X), position.programmed(Axis::X)), (Some(40.0), Some(50.0)));
        // A second change still counts from the number that was written.
        position.keep_programmed();
        position.through_frame(&shifted(10.0), &shifted(30.0));
        assert_eq!((position.get(Axis::X), position.programmed(Axis::X)), (Some(20.0), Some(50.0)));
        position.move_to(&at(&[(Axis::X, 7.0)]));
        assert_eq!(position.programmed(Axis::X), Some(7.0));
        assert!(!position.stands_beside(AxisSet::MAIN));
    }

    #[test]
    fn a_rotation_hides_what_an_unknown_axis_turns_into() {
        let mut position = nowhere();
        position.move_to(&at(&[(Axis::X, 5.0), (Axis::Z, 1.0)]));
        position.through_frame(&Frame::default(), &turned());
        assert_eq!(position.require(Axis::X), Err(Missing::Unknown));
        assert_eq!(position.require(Axis::Z), Ok(1.0));
    }

    #[test]
    fn a_lost_axis_takes_its_partner_along_in_a_rotation() {
        let mut position = nowhere();
        position.move_to(&at(&[(Axis::X, 5.0), (Axis::Y, 6.0)]));
        position.lose(AxisSet::of(Axis::Y));
        position.through_frame(&Frame::default(), &turned());
        assert_eq!(position.require(Axis::X), Err(Missing::Lost));
    }

    #[test]
    fn a_tool_beside_its_number_counts_from_the_number() {
        let mut position = nowhere();
        position.move_to(&at(&[(Axis::X, 55.0)]));
        position.leave_beside(Axis::X, 50.0);
        assert!(position.stands_beside(AxisSet::MAIN));
        assert_eq!((position.get(Axis::X), position.programmed(Axis::X)), (Some(55.0), Some(50.0)));
        position.forget_beside();
        assert_eq!(position.programmed(Axis::X), None);
    }

    #[test]
    fn machine_coordinates_hide_what_depends_on_them() {
        let mut position = nowhere();
        position.move_to(&at(&[(Axis::X, 5.0), (Axis::Y, 6.0), (Axis::Z, 7.0)]));
        position.moved_by_machine(&at(&[(Axis::X, 9.0)]), &turned(), here());
        assert!(matches!(position.hidden(Axis::Y), Some((By::Machine(None), _))), "the Y of the program");
        // Under the quarter turn the X of the machine is the Y of the program.
        assert_eq!(position.at().known(), [Axis::X, Axis::Z].into_iter().collect());
    }

    #[test]
    fn a_place_may_go_while_the_number_stays() {
        let mut position = nowhere();
        position.move_to(&at(&[(Axis::X, 5.0)]));
        position.forget_place(AxisSet::MAIN);
        assert_eq!((position.get(Axis::X), position.programmed(Axis::X)), (None, Some(5.0)));
        position.clear();
        assert_eq!(position.programmed(Axis::X), None);
    }

    #[test]
    fn the_start_holds_until_its_axis_moves() {
        let mut position = with_start(Axis::X, 5.0);
        assert_eq!(position.require(Axis::X), Ok(5.0));
        position.clear();
        position.take_start(&shifted(2.0));
        assert_eq!((position.get(Axis::X), position.programmed(Axis::X)), (Some(3.0), Some(5.0)));
        position.move_to(&at(&[(Axis::X, 1.0)]));
        position.stand_at_start();
        assert_eq!(position.require(Axis::X), Err(Missing::Unknown));
    }

    #[test]
    fn another_work_offset_ends_the_start() {
        let mut position = with_start(Axis::X, 5.0);
        position.end_start();
        position.clear();
        position.take_start(&Frame::default());
        assert_eq!(position.require(Axis::X), Err(Missing::Unknown));
    }

    #[test]
    fn the_help_names_the_start_only_while_it_could_help() {
        let mut position = nowhere();
        assert!(position.or_say(Axis::X).text.contains("[start]"));
        position.move_to(&at(&[(Axis::X, 1.0)]));
        assert_eq!(position.or_say(Axis::X).text, "");
        position.leave_start(AxisSet::of(Axis::Z));
        assert_eq!(position.or_say(Axis::Z).text, "");
    }

    #[test]
    fn a_cycle_moves_its_own_axes_only() {
        let mut position = with_start(Axis::X, 5.0);
        position.cycle_leaves(&at(&[(Axis::X, 5.0), (Axis::Z, 2.0)]), AxisSet::of(Axis::Z));
        assert_eq!(position.at(), &at(&[(Axis::X, 5.0), (Axis::Z, 2.0)]));
        assert_eq!(position.start(), at(&[(Axis::X, 5.0)]));
    }
}
