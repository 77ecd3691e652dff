//! The lane of straight blocks: what most blocks of a CAM program are, while nothing else is on.
//!
//! A contour that the compiler compensates is no obstacle once it has begun. Whether something is on is asked once, behind each block that did not take the lane; those that take it change the
//! position and the feed only. Each condition names what a straight block would otherwise do about it.

use crate::ir::contour::{Coords, Move, Path};
use crate::ir::{Pos, Side};
use crate::lexer::klartext::Value;
use crate::parser::klartext::ast::{Addr, Block, PathFn, Stmt};

use super::Run;
use super::change::Change;

impl Run<'_> {
    /// Does a straight block do nothing but move?
    pub(super) fn is_plain(&self) -> bool {
        let st = &self.st;
        self.skipped.is_none()
            && !self.cycles.is_open()
            && !self.cycles.modal()
            && self.approach.is_none()
            && matches!(st.tool.change, Change::None)
            && st.corner.is_none()
            && !st.polar.has_last()
            && st.feed.plunge_share().is_none()
            && !st.feed.is_per_revolution()
            && self.contour_is_plain()
            && !st.compensation.is_lost()
    }

    /// Executes an `L` block of X, Y, Z, F and R0 while nothing else is on; false if it is another block.
    #[inline]
    pub(super) fn line_lane(&mut self, block: &Block) -> bool {
        let line = matches!(block.stmt, Stmt::Path(PathFn::Line));
        if !self.plain || !line || block.skip || block.comment.is_some() {
            return false;
        }
        let mm = self.level().frame.unit.mm();
        let mut end = Pos::UNKNOWN;
        let (mut feed, mut rapid, mut uncompensated) = (None, false, false);
        for word in &block.words {
            match (word.addr, word.value) {
                (Addr::Axis { axis, incremental: false }, Value::Number(value))
                    if axis.is_main() && !end.known().contains(axis) =>
                {
                    end.set(axis, value * mm);
                }
                (Addr::Feed, Value::Number(value)) if value > 0.0 && feed.is_none() && !rapid => feed = Some(value),
                (Addr::FeedMax, _) if feed.is_none() && !rapid => rapid = true,
                // Where RL or RR is on, R0 leads away from the contour.
                (Addr::Radius { signed: false }, Value::Number(0.0))
                    if !uncompensated && !self.st.compensation.is_on() =>
                {
                    uncompensated = true;
                }
                _ => return false,
            }
        }
        if end.known().is_empty() || feed.is_none() && self.st.feed.word().is_none() && !rapid {
            return false;
        }
        if let Some(written) = feed {
            let feed = self.feed_of(written);
            self.st.feed.program(feed, written);
        }
        let path = if rapid { Path::Rapid } else { Path::straight(self.st.feed.word()) };
        let side = self.st.compensation.side();
        self.core.send_move(&Move { end, path, side, coords: Coords::Frame }, &self.st.ctx);
        if side != Side::None {
            self.note_contour(&end, path);
        }
        self.st.feed.last_rapid = rapid;
        self.st.position.move_to(&end);
        self.st.moved = true;
        true
    }
}
