//! The lane of straight blocks and plain arcs: what most blocks of a CAM program are, while nothing else is on.
//!
//! Whether something is on is asked once, behind each block that did not take the lane; those that take it change the
//! position, the heading and the feed only.

use crate::geo::{Plane, Point2, distance};
use crate::ir::contour::{Arc, ArcShape, Coords, Move, Path};
use crate::ir::{Feed, Pos, Side};
use crate::machine::Axis;
use crate::parser::sinumerik::ast::Block;
use crate::parser::sinumerik::straight;
use crate::parser::straight::Straight;

use super::Channel;
use super::g_groups::{GCode, Group};

/// The blocks that do nothing but move.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Lane {
    /// None of them.
    Closed,
    /// Those of G0: the feed is not known well enough for G1.
    Rapid,
    /// All, and arcs about I and J.
    Open,
}

impl Channel<'_> {
    /// Which straight blocks do nothing but move?
    pub(super) fn open_lane(&mut self) -> Lane {
        if !(self.moves_straight() && self.nothing_waits() && super::levels::program(&mut self.core.levels).executed) {
            return Lane::Closed;
        }
        let feed = &self.st.feed;
        let known = matches!(feed.word(), Some(Feed::PerMinute(_))) && !feed.is_lost() && !feed.is_kind_open();
        if known { Lane::Open } else { Lane::Rapid }
    }

    /// The codes and settings under which a block of axes with G0 or G1 is a straight move in the plane XY.
    fn moves_straight(&self) -> bool {
        let st = &self.st;
        let letters = [(b'X', Some(Axis::X)), (b'Y', Some(Axis::Y)), (b'Z', Some(Axis::Z)), (b'F', None)];
        let named = |(letter, axis)| self.axis_names.letter(letter).and_then(|named| named.axis) == axis;
        matches!(st.codes.of(Group::Motion), GCode::G0 | GCode::G1 | GCode::G2 | GCode::G3)
            && st.offsets.are_noted()
            && !st.is(GCode::G91)
            && !st.is(GCode::G93)
            && !st.codes.per_revolution()
            && !st.codes.of(Group::FeedType).holds_cutting_speed()
            && !st.spindles.is_cutting()
            && st.plane() == Plane::Xy
            // Behind an error the rules of the path may be missing: the next code gives them.
            && (st.side() == Side::None || st.path.is_computed() && st.ctx.compensation.is_some())
            && st.tool.edge() != Some(0)
            && self.core.job.settings.machine.diameter_axis.is_none()
            && !self.axis_names.are_given()
            && letters.into_iter().all(named)
    }

    /// Nothing in front of a move waits for it, or takes it for something else.
    fn nothing_waits(&self) -> bool {
        !self.iso
            && !self.core.language.has_macros()
            && self.capture.is_none()
            && self.soft.is_none()
            && self.st.stored.is_none()
            && !self.st.pair.is_open()
            && !self.st.modal_call.is_on()
            && !self.st.threads.are_open()
            && !self.st.taps.are_open()
            && !self.st.spindles.waits_for_cut_speed()
            && !self.st.compensation.waits()
            && !self.st.corners.open.is_open()
            && self.st.corners.rounding() == 0.0
            && self.left.cut_is_known()
            && self.st.feed.is_the_programs()
            && self.left.speed.is_none()
            && self.curve_table.is_none()
            && self.st.touched.is_none()
            && self.st.orientation.may_move()
            && self.st.position.left_by_calls().is_empty()
    }

    /// Executes the next block where it stands, if it is one of X, Y, Z, I, J and F while nothing else is on.
    #[inline]
    pub(super) fn straight_line(&mut self) -> bool {
        if self.lane == Lane::Closed {
            return false;
        }
        let Some(line) = self.core.straight_ahead(straight::of_line) else { return false };
        let Some(way) = self.way(&line) else { return false };
        self.core.take_straight(&line);
        self.go(&line, way);
        true
    }

    /// The same for a block that was read; false if it is another one.
    pub(super) fn straight_block(&mut self, block: &Block) -> bool {
        let line = if self.lane == Lane::Closed { None } else { straight::of_block(block) };
        let Some((line, way)) = line.and_then(|line| Some((line, self.way(&line)?))) else { return false };
        self.go(&line, way);
        true
    }

    /// How a block moves, under its own code or the one in force; `None` where it cannot take the lane.
    #[inline(always)]
    fn way(&self, line: &Straight) -> Option<Way> {
        let code = match line.motion {
            Some(0) => GCode::G0,
            Some(1) => GCode::G1,
            Some(2) => GCode::G2,
            Some(_) => GCode::G3,
            None => self.st.codes.of(Group::Motion),
        };
        match code {
            GCode::G0 if line.centered.is_empty() => Some(Way::Line(code)),
            GCode::G1 if line.centered.is_empty() && self.lane == Lane::Open => Some(Way::Line(code)),
            GCode::G2 | GCode::G3 if !line.centered.is_empty() && self.lane == Lane::Open => self.arc(line, code),
            _ => None,
        }
    }

    /// An arc of which there is nothing to say.
    #[inline]
    fn arc(&self, line: &Straight, code: GCode) -> Option<Way> {
        let (axes, ccw) = (line.axes, code == GCode::G3);
        let has = |axis| axes.contains(axis);
        // Without X or Y beside it Z may be meant in another plane.
        if has(Axis::Z) && !(has(Axis::X) && has(Axis::Y) && self.st.position.get(Axis::Z).is_some())
            || self.st.machine.geometry_axes != [Axis::X, Axis::Y, Axis::Z]
            || [b'I', b'J'].into_iter().any(|letter| self.axis_names.letter(letter).is_some())
        {
            return None;
        }
        let mm = self.st.length_unit();
        let start = self.st.position.in_plane(Plane::Xy)?;
        let or = |axis: Axis, stays: f64| if has(axis) { line.values[axis.index()] * mm } else { stays };
        let to = Point2::new(or(Axis::X, start.x), or(Axis::Y, start.y));
        let about = |axis: Axis, start: f64| match line.centered.contains(axis) {
            true => start + line.center[axis.index()] * mm,
            false => start,
        };
        let center = Point2::new(about(Axis::X, start.x), about(Axis::Y, start.y));
        let center = self.core.quiet_center(start, to, center, ccw)?;
        let tol = self.core.circle_tolerance(distance(start, center));
        let arc = Arc { plane: Plane::Xy, shape: ArcShape::Center { center, ccw, tol }, turns: 0 };
        let feed = line.feed.map(|feed| self.st.feed_of(feed)).or(self.st.feed.word())?;
        Some(Way::Arc(code, Path::Arc(arc, feed), to))
    }

    #[inline(always)]
    fn go(&mut self, line: &Straight, way: Way) {
        if let Some(feed) = line.feed {
            self.st.feed.program(self.st.feed_of(feed));
        }
        let mm = self.st.length_unit();
        let mut end = Pos::of_main(line.values.map(|value| value * mm), line.axes);
        let (code, path) = match way {
            Way::Line(GCode::G0) => (GCode::G0, Path::Rapid),
            Way::Line(code) => (code, Path::straight(self.st.feed.word())),
            Way::Arc(code, path, to) => {
                end.set_in_plane(Plane::Xy, to);
                (code, path)
            }
        };
        self.st.codes.activate(code);
        self.st.heading.follow(&self.st.position, &end, &path);
        self.core.send_move(&Move { end, path, side: self.st.side_of_move(), coords: Coords::Frame }, &self.st.ctx);
        self.st.position.move_to(&end);
    }
}

/// How a block of the lane moves.
#[derive(Debug, Clone, Copy)]
enum Way {
    Line(GCode),
    /// With the end in XY.
    Arc(GCode, Path, Point2),
}
