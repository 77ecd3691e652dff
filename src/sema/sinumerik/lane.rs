//! The lane of straight blocks: what most blocks of a CAM program are, while nothing else is on.
//!
//! Whether something is on is asked once, behind each block that did not take the lane; those that take it change the
//! position, the heading and the feed only.

use crate::geo::Plane;
use crate::ir::contour::{Coords, Move, Path};
use crate::ir::{Feed, Pos, Side};
use crate::machine::Axis;
use crate::parser::sinumerik::ast::Block;
use crate::parser::sinumerik::straight;
use crate::parser::straight::Straight;

use super::Channel;
use super::g_groups::{GCode, Group};

impl Channel<'_> {
    /// Does a straight block do nothing but move?
    pub(super) fn is_plain(&mut self) -> bool {
        self.moves_straight() && self.nothing_waits() && self.program_level().executed
    }

    /// The codes and settings under which a block of axes is a straight move in the plane XY.
    fn moves_straight(&self) -> bool {
        let st = &self.st;
        let straight = match st.codes.of(Group::Motion) {
            GCode::G0 => true,
            GCode::G1 => {
                matches!(st.feed.word(), Some(Feed::PerMinute(_))) && !st.feed.is_lost() && !st.feed.is_kind_open()
            }
            _ => false,
        };
        let letters = [(b'X', Some(Axis::X)), (b'Y', Some(Axis::Y)), (b'Z', Some(Axis::Z)), (b'F', None)];
        let named = |(letter, axis)| self.axis_names.letter(letter).and_then(|named| named.axis) == axis;
        straight
            && st.offsets.are_noted()
            && !st.is(GCode::G91)
            && !st.is(GCode::G93)
            && !st.codes.per_revolution()
            && !st.codes.of(Group::FeedType).holds_cutting_speed()
            && !st.spindles.is_cutting()
            && st.plane() == Plane::Xy
            && (st.side() == Side::None || st.path.is_computed())
            && st.tool.edge() != Some(0)
            && self.job.settings.machine.diameter_axis.is_none()
            && !self.axis_names.are_given()
            && letters.into_iter().all(named)
    }

    /// Nothing in front of a move waits for it, or takes it for something else.
    fn nothing_waits(&self) -> bool {
        !self.iso
            && !self.language.has_macros()
            && self.capture.is_none()
            && self.soft.is_none()
            && self.st.stored.is_none()
            && !self.st.pair.is_open()
            && !self.st.modal_call.is_on()
            && !self.st.threads.are_open()
            && !self.st.spindles.waits_for_cut_speed()
            && !self.st.compensation.waits()
            && !self.st.corners.open.is_open()
            && self.st.corners.rounding() == 0.0
    }

    /// Executes the next block where it stands, if it is one of X, Y, Z and F while nothing else is on.
    #[inline]
    pub(super) fn straight_line(&mut self) -> bool {
        if !self.plain {
            return false;
        }
        let Some(line) = self.core.straight_ahead(straight::of_line) else { return false };
        self.core.take_straight(&line);
        self.go_straight(&line);
        true
    }

    /// The same for a block that was read; false if it is another one.
    pub(super) fn straight_block(&mut self, block: &Block) -> bool {
        let line = if self.plain { straight::of_block(block) } else { None };
        let Some(line) = line else { return false };
        self.go_straight(&line);
        true
    }

    #[inline(always)]
    fn go_straight(&mut self, line: &Straight) {
        if let Some(feed) = line.feed {
            self.st.feed.program(self.st.feed_of(feed));
        }
        let path = if self.st.is(GCode::G0) { Path::Rapid } else { Path::straight(self.st.feed.word()) };
        let mm = self.st.length_unit();
        let end = Pos::of_main(line.values.map(|value| value * mm), line.axes);
        self.note_heading(&end, &path);
        self.core.send_move(&Move { end, path, side: self.st.side_of_move(), coords: Coords::Frame }, &self.st.ctx);
        self.st.position.move_to(&end);
    }
}
