//! The lane of straight blocks: what most blocks of a CAM program are, while nothing else is on.
//!
//! Whether something is on is asked once, behind each block that did not take the lane; those that take it change the
//! position, the heading and the feed only.

use crate::geo::Plane;
use crate::ir::contour::{Coords, Move, Path};
use crate::ir::{Feed, Pos, Side};
use crate::machine::Axis;
use crate::parser::sinumerik::ast::{Block, Stmt, Target, Value};

use super::Run;
use super::g_groups::{Code, Group};
use super::offsets::{FromBasic, Outer};

impl Run<'_> {
    /// Does a straight block do nothing but move?
    pub(super) fn is_plain(&mut self) -> bool {
        self.moves_straight() && self.nothing_waits() && self.program_level().executed
    }

    /// The codes and settings under which a block of axes is a straight move in the plane XY.
    fn moves_straight(&self) -> bool {
        let st = &self.st;
        let straight = match st.codes.of(Group::Motion) {
            Code::G0 => true,
            Code::G1 => matches!(st.feed, Some(Feed::PerMinute(_))) && !st.feed_lost && !st.feed_kind_open,
            _ => false,
        };
        let letters = [(b'X', Some(Axis::X)), (b'Y', Some(Axis::Y)), (b'Z', Some(Axis::Z)), (b'F', None)];
        let named = |(letter, axis)| self.axis_names.letter(letter).and_then(|named| named.axis) == axis;
        let noted = match st.outer {
            Outer::Printed(_) => true,
            Outer::Basic => {
                st.moved_from_basic == FromBasic::UnderG500
                    || st.moved_from_basic == FromBasic::AtStart && !st.under_g500
            }
            Outer::Machine | Outer::Unrelated => false,
        };
        straight
            && noted
            && !st.is(Code::G91)
            && !st.is(Code::G93)
            && !st.per_revolution()
            && !st.codes.of(Group::FeedType).holds_cutting_speed()
            && !st.constant_cut
            && !st.speed_kept
            && st.plane() == Plane::Xy
            && st.side() == Side::None
            && st.tool.edge != Some(0)
            && self.job.settings.machine.diameter_axis.is_none()
            && !self.axis_names.are_given()
            && letters.into_iter().all(named)
    }

    /// Nothing in front of a move waits for it, or takes it for something else.
    fn nothing_waits(&self) -> bool {
        !self.iso
            && self.stored.is_none()
            && self.capture.is_none()
            && self.pending.is_none()
            && self.modal.is_none()
            && self.modal_cycle.is_none()
            && self.tapping.is_none()
            && self.thread_chain.is_none()
            && self.cutter_open.is_none()
            && self.corner_open.is_none()
            && self.cut_speed_open.is_none()
            && !self.compensation_starts
            && !self.leaving_open
            && self.st.rndm == 0.0
    }

    /// Executes a block of X, Y, Z and F while nothing else is on; false if it is another block.
    #[inline]
    pub(super) fn line_lane(&mut self, block: &Block) -> bool {
        let words = matches!(block.stmt, Stmt::Words);
        if !self.plain || !words || block.skip.is_some() || block.comment.is_some() {
            return false;
        }
        let mm = self.st.length_unit();
        let mut end = Pos::UNKNOWN;
        let mut feed = None;
        for word in &block.words {
            let (Target::Letter(letter), Value::Literal { value, .. }) = (word.target, word.value) else {
                return false;
            };
            let axis = match letter {
                b'X' => Axis::X,
                b'Y' => Axis::Y,
                b'Z' => Axis::Z,
                b'F' if value > 0.0 && value.is_finite() && feed.is_none() => {
                    feed = Some(value);
                    continue;
                }
                _ => return false,
            };
            if end.known().contains(axis) || !value.is_finite() {
                return false;
            }
            end.set(axis, value * mm);
        }
        if end.known().is_empty() {
            return false;
        }
        if let Some(feed) = feed {
            self.st.feed = Some(self.feed_of(feed));
            self.st.feed_lost = false;
        }
        let path = if self.st.is(Code::G0) { Path::Rapid } else { Path::straight(self.st.feed) };
        self.note_heading(&end, &path);
        self.core.send_move(&Move { end, path, side: Side::None, coords: Coords::Frame }, &self.st.ctx);
        self.st.position.move_to(&end);
        true
    }
}
