//! The lane of straight blocks: what most blocks of a CAM program are, while nothing else is on.
//!
//! Whether something is on is asked once, behind each block that did not take the lane; those that take it change the
//! position and the feed only. Each condition names what a straight block would otherwise do about it. A contour that the
//! compiler compensates is no obstacle once it has begun: each block notes its direction.

use crate::ir::contour::{Coords, Move, Path};
use crate::ir::{Pos, Side};
use crate::parser::klartext::ast::Block;
use crate::parser::klartext::straight;
use crate::parser::straight::Straight;

use super::Run;
use super::active_tool::Change;

impl Run<'_> {
    /// Does a straight block do nothing but move?
    pub(super) fn is_plain(&self) -> bool {
        let st = &self.st;
        let side = st.compensation.side();
        // A contour that has begun needs nothing but its direction noted.
        let contour_is_plain = match st.contour.now {
            None => side == Side::None,
            Some(contour) => side != Side::None && contour.begun && self.core.computes_path(),
        };
        !self.skipped.is_open()
            && !self.cycles.is_open()
            && !self.cycles.modal()
            && self.approach.is_none()
            && matches!(st.tool.change, Change::None)
            && st.corner.is_none()
            && st.left_by.is_none()
            && !st.polar.has_last()
            && st.feed.plunge_share().is_none()
            && !st.feed.is_per_revolution()
            && !st.feed.is_of_before_call()
            && contour_is_plain
            && !st.compensation.is_lost()
            && st.position.left_by_calls().is_empty()
            && st.position.left_by_probes().is_empty()
            && !self.contour_waits()
            && st.described.is_none()
            && !st.tilt.bars()
    }

    /// Executes the next block where it stands, if it is an `L` of X, Y, Z, F and R0 while nothing else is on.
    #[inline]
    pub(super) fn straight_line(&mut self) -> bool {
        if !self.plain {
            return false;
        }
        let Some(line) = self.core.straight_ahead(straight::of_line).filter(|line| self.admits(line)) else {
            return false;
        };
        self.core.take_straight(&line);
        self.go_straight(&line);
        true
    }

    /// The same for a block that was read; false if it is another one.
    pub(super) fn straight_block(&mut self, block: &Block) -> bool {
        let line = if self.plain { straight::of_block(block) } else { None };
        let Some(line) = line.filter(|line| self.admits(line)) else { return false };
        self.go_straight(&line);
        true
    }

    #[inline(always)]
    fn admits(&self, line: &Straight) -> bool {
        // R0 leads away from a contour.
        (line.rapid || line.feed.is_some() || self.st.feed.word().is_some())
            && !(line.uncompensated && self.st.compensation.is_on())
    }

    #[inline(always)]
    fn go_straight(&mut self, line: &Straight) {
        let unit = self.core.unit();
        if let Some(written) = line.feed {
            let feed = self.st.feed.counted(written, unit);
            self.st.feed.program(feed, written);
        }
        let path = if line.rapid { Path::Rapid } else { Path::straight(self.st.feed.word()) };
        let mm = unit.mm();
        let end = Pos::of_main(line.values.map(|value| value * mm), line.axes);
        let side = self.st.compensation.side();
        self.core.send_move(&Move { end, path, side, coords: Coords::Frame }, &self.st.ctx);
        if side != Side::None {
            self.st.note_contour(&end, &path);
        }
        self.st.last_path = path;
        self.st.feed.last_rapid = line.rapid;
        self.st.position.move_to(&end);
        self.st.moved = true;
    }
}
