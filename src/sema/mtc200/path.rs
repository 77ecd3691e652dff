//! Motion blocks: straight lines, arcs, threads, corners.
//!
//! Source: M 5, 6.1, 6.2, 8 (docs/sources.md).

use crate::diag::{Answer, Label, codes};
use crate::geo::{Deg, Plane, Point2, SAME_POINT};
use crate::ir::contour::{
    Arc, ArcChamfer, ArcShape, Blocks, Coords, Corner, CornerShape, LargeCorner, Move, Path, Thread,
};
use crate::ir::{Ask, Feed, Pos, Side};
use crate::machine::options::mtc200::{Reading, ShiftedIncrement};
use crate::machine::{Axis, AxisSet, Compensation};
use crate::sema::common::corner::OpenCorner;
use crate::sema::common::hidden::By;
use crate::sema::common::position::Missing;
use crate::sema::run::place::{Lack, Unknown};
use crate::text::Span;

use super::g_functions::{Motion, Offset};
use super::words::{At, Words};
use super::{Outcome, Reported, Run};

/// A chamfer beside an arc.
const AT_ARC: Ask = Ask::key("control", "cf_at_arcs", AT_ARC_HELP);
const AT_ARC_HELP: &str = "program a rounding beside an arc; how the control measures a chamfer there is not confirmed: for its width along both elements \
           set `[control] cf_at_arcs = \"along\"`";

/// Blocks without motion that may stand between a corner and its second neighbour.
const MOST_BETWEEN: u32 = 20;
/// Half turns closer than this to 180° have no certain direction.
const HALF_TURN: f64 = 1e-9;

/// Chamfers and roundings.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Corners {
    /// The last block with words moved at feed: a corner may follow.
    may_follow: bool,
    /// A corner that waits for its second neighbour.
    open: OpenCorner,
}

impl Corners {
    pub fn is_open(&self) -> bool {
        self.open.is_open()
    }

    /// The block before is no first neighbour of a corner.
    #[inline]
    pub fn cannot_follow(&mut self) {
        self.may_follow = false;
    }
}

impl Run<'_> {
    /// Moves as the block says.
    #[inline]
    pub(super) fn motion(&mut self, w: &Words) -> Outcome {
        let Some(motion) = self.st.motion.code() else {
            if self.st.motion.is_lost() {
                return Err(Reported);
            }
            return self.core.refuse(w.axes_span.to(w.centre_span), codes::M2003::no_g00());
        };
        if self.st.offsets.offset() != Offset::Start && self.st.offsets.offset() != Offset::Machine {
            self.offset_is_certain(w.axes_span)?;
        }
        self.check_corner(motion, w.axes_span)?;
        if !motion.is_arc() {
            self.no_arc_words(motion, w)?;
        }
        match motion {
            Motion::Rapid | Motion::Line => self.straight(motion, w),
            Motion::Clockwise | Motion::CounterClockwise => self.arc(motion, w),
            Motion::Thread => self.thread(w),
        }
    }

    #[inline]
    fn no_arc_words(&mut self, motion: Motion, w: &Words) -> Outcome {
        if let Some(at) = w.radius {
            return self.core.refuse(at.span, codes::P1003::r_belongs_to_arc());
        }
        if w.has_centre() && motion != Motion::Thread {
            return self.core.refuse(w.centre_span, codes::P1003::i_j_k_belong_to_arc_or_thread());
        }
        Ok(())
    }

    // Coordinates.

    /// A length along an axis in mm, as written in a block.
    #[inline]
    pub(super) fn length(&mut self, axis: Axis, value: f64, span: Span) -> Outcome<f64> {
        if axis.is_main() {
            let length = value * self.st.unit();
            return Ok(if axis == Axis::X && self.st.diameter { length / 2.0 } else { length });
        }
        if axis.is_rotary() || !self.st.inch {
            return Ok(value);
        }
        self.core.refuse(span, codes::M9008::may_mean_inches_or_degrees_here(&axis.letter()))
    }

    /// Where the block goes: the programmed axes, absolute, in mm (X: radius) and degrees.
    #[inline]
    fn target(&mut self, w: &Words) -> Outcome<Pos> {
        let mut end = Pos::UNKNOWN;
        if !w.axes.known().is_empty() {
            self.relies_on_the_start(self.st.dimension_said, w.axes_span);
        }
        for (axis, value) in w.axes.iter() {
            let length = self.length(axis, value, w.axes_span)?;
            let to = if self.st.incremental {
                self.counts_from(axis, w.axes_span)? + length
            } else if axis.is_rotary() {
                self.rotary_target(axis, length, w.axes_span)?
            } else {
                length
            };
            end.set(axis, to);
        }
        self.moves_the_nose(&end, w.axes_span)?;
        Ok(end)
    }

    /// What an increment is added to: where the axis stands, or behind a changed offset what the option says.
    #[inline]
    fn counts_from(&mut self, axis: Axis, span: Span) -> Outcome<f64> {
        if self.st.offsets.is_shifted(axis) {
            match self.core.job.settings.control.mtc200.g91_after_offset {
                ShiftedIncrement::Increment => {}
                ShiftedIncrement::WithOffset => {
                    if let Some(programmed) =
                        self.st.position.programmed(axis).filter(|_| self.st.offsets.is_written(axis))
                    {
                        return Ok(programmed);
                    }
                }
                ShiftedIncrement::Refuse => return self.refuse_shifted(axis, span),
            }
        }
        self.position_of(axis, span)
    }

    /// An increment right behind a changed offset: from the tool, or from the last programmed position?
    #[cold]
    fn refuse_shifted<T>(&mut self, axis: Axis, span: Span) -> Outcome<T> {
        let letter = axis.letter();
        self.core.refuse(
            span,
            codes::M2018::is_incremental_its_zero_offset_changed_since(&letter)
                .answer(Answer::key("control", "g91_after_offset")),
        )
    }

    /// Where an axis stands.
    pub(super) fn position_of(&mut self, axis: Axis, span: Span) -> Outcome<f64> {
        match self.st.position.require(axis) {
            Ok(at) => return Ok(at),
            Err(Missing::Lost) => return Err(Reported),
            Err(Missing::Unknown) => {}
        }
        let unknown = Unknown { position: &self.st.position, axis, lack: &|| Lack::Nothing, otherwise: " here" };
        self.core.position_unknown(span, unknown, codes::P2001::position_is_not_known)
    }

    /// Where a rotary axis goes in unbroken degrees: the short way.
    fn rotary_target(&mut self, axis: Axis, value: f64, span: Span) -> Outcome<f64> {
        if self.core.job.settings.control.mtc200.rotary_absolute {
            return Ok(value);
        }
        let letter = axis.letter();
        if value.abs() > 360.0 {
            return self.core.refuse(span, codes::M2017::is_more_than_turn(&letter, &value));
        }
        let Some(from) = self.st.position.get(axis) else { return Ok(value) };
        let ahead = Deg(value - from).normal().0;
        if (ahead - 180.0).abs() <= HALF_TURN {
            return self.core.refuse(span, codes::M2017::moves_exactly_half_turn(&letter));
        }
        Ok(from + if ahead > 180.0 { ahead - 360.0 } else { ahead })
    }

    // Feed.

    #[inline]
    fn cutting_feed(&mut self, span: Span) -> Outcome<Feed> {
        match self.st.feed.word() {
            Some(feed) => Ok(feed),
            None => self.feed_missing(span),
        }
    }

    #[cold]
    fn feed_missing(&mut self, span: Span) -> Outcome<Feed> {
        // One report is enough.
        self.st.feed.presume();
        self.core.refuse(span, codes::P2002::no_feed_is_programmed_for_this_move())
    }

    pub(super) fn set_feed(&mut self, at: At) -> Outcome {
        if at.value == 0.0 {
            if self.core.job.settings.control.mtc200.zero_feed_keeps {
                return Ok(());
            }
            return self.core.refuse(
                at.span,
                codes::P2003::feed_is_0().answer(Answer::key("control", "zero_feed").one_of(&["\"previous\""])),
            );
        }
        let value = at.value * self.st.unit();
        if value < 0.0 {
            return self.core.refuse(at.span, codes::O1001::feed(&at.value));
        }
        if let Some(feed) = self.st.feed.of(value) {
            self.st.feed.program(feed);
        }
        Ok(())
    }

    // Moves.

    /// Sends a move and takes over its end.
    #[inline]
    fn send(&mut self, end: Pos, path: Path) {
        self.movement(&Move { end, path, side: self.st.compensation.side(), coords: Coords::Frame });
        self.arrive(&end);
    }

    #[inline]
    fn arrive(&mut self, end: &Pos) {
        self.st.position.move_to(end);
        self.st.offsets.arrive(end.known());
        self.st.corners.open.close();
    }

    fn straight(&mut self, motion: Motion, w: &Words) -> Outcome {
        let feed = if motion == Motion::Line { Some(self.cutting_feed(w.axes_span)?) } else { None };
        if self.st.offsets.offset() == Offset::Machine {
            return self.machine_move(w, feed);
        }
        if self.st.compensation.is_on() && self.st.transition.chamfers {
            self.no_chamfers(w.axes_span)?;
        }
        let end = self.target(w)?;
        if self.st.inch && feed.is_some() && end.known().common(AxisSet::MAIN).is_empty() {
            return self.core.refuse(w.axes_span, codes::M9008::unit_of_feed_of_these_axes());
        }
        self.st.corners.may_follow = feed.is_some();
        let in_plane = plane_axes(self.st.plane).iter().any(|i| end.known().contains(Axis::ALL[*i]));
        self.waits_in_contour(in_plane, w.axes_span)?;
        let switches = self.st.compensation.changes() && self.moves_in_plane(&end, w.axes_span)?;
        if switches {
            self.border_axes(&end, w.axes_span);
        }
        self.send(end, Path::straight(feed));
        if switches {
            self.st.compensation.moves();
        }
        Ok(())
    }

    /// Both axes of the plane belong into the way to a contour, and from it.
    #[cold]
    fn border_axes(&self, end: &Pos, span: Span) {
        let named = plane_axes(self.st.plane).iter().filter(|i| end.known().contains(Axis::ALL[**i])).count();
        let computed = self.core.job.settings.output.compensation == Compensation::Resolve;
        if named < 2 && computed && self.core.job.diags.first_time(codes::M8006, ()) {
            self.core.report(codes::M8006::way_to_contour_or_from_it_names().at(self.core.loc(span)));
        }
    }

    /// Does the move have a length in the plane, so that compensation can start or end on it?
    #[cold]
    fn moves_in_plane(&mut self, end: &Pos, span: Span) -> Outcome<bool> {
        let mut moves = false;
        for axis in plane_axes(self.st.plane).map(|i| Axis::ALL[i]) {
            let from = self.position_of(axis, span)?;
            moves |= end.get(axis).is_some_and(|to| (to - from).abs() > SAME_POINT);
        }
        Ok(moves)
    }

    /// A straight move under G53.
    fn machine_move(&mut self, w: &Words, feed: Option<Feed>) -> Outcome {
        let span = w.axes_span;
        if !self.core.job.settings.control.mtc200.g53_is_machine {
            return self.core.refuse(
                span,
                codes::M9005::block_moves_while_g53_is_active()
                    .answer(Answer::key("control", "g53").one_of(&["\"machine\""])),
            );
        }
        if self.st.incremental || self.st.compensation.is_on() {
            return self.core.refuse(span, codes::M9005::move_under_g53_is_absolute());
        }
        let end = self.target(w)?;
        self.machine_position(end, feed);
        Ok(())
    }

    /// Moves to machine coordinates; afterwards the workpiece position of the axes is not known.
    pub(super) fn machine_position(&mut self, end: Pos, feed: Option<Feed>) {
        let (path, coords) = (Path::straight(feed), Coords::Machine);
        self.movement(&Move { end, path, side: Side::None, coords });
        self.st.position.leave_start(end.known());
        self.st.forget(end.known());
        self.st.position.hide(end.known(), By::Machine(None), self.core.here.origin.loc);
        self.st.corners.cannot_follow();
    }

    fn arc(&mut self, motion: Motion, w: &Words) -> Outcome {
        let plane = self.st.plane;
        let span = if w.axes_span.is_empty() { w.centre_span } else { w.axes_span };
        if self.st.offsets.offset() == Offset::Machine {
            return self.core.refuse(span, codes::M9005::arc_under_g53_has_no_counterpart());
        }
        if self.st.compensation.changes() {
            return self.core.refuse(span, codes::P2040::g41_g42_activated_with_circular_interpolation());
        }
        if self.st.compensation.is_on() && self.st.transition.chamfers {
            self.no_chamfers(span)?;
        }
        if !w.has_centre() && w.radius.is_none() {
            return self.core.refuse(span, codes::P3002::arc_has_neither_centre_nor_radius());
        }
        let feed = self.cutting_feed(span)?;
        let (first, second, third) = plane.axes();
        let (first, second, third) = (Axis::ALL[first], Axis::ALL[second], Axis::ALL[third]);
        let start = Point2::new(self.position_of(first, span)?, self.position_of(second, span)?);
        if self.st.incremental {
            self.shifted_arc([first, second], span)?;
        }
        let mut end = self.target(w)?;
        for (axis, at) in [(first, start.x), (second, start.y)] {
            if end.get(axis).is_none() {
                end.set(axis, at);
            }
        }
        if end.known().contains(third) {
            self.position_of(third, span)?;
            self.reading(Reading::Helix, span, codes::P8106::third_axis_moves_evenly);
        }
        let to = Point2::new(end.get(first).unwrap_or(start.x), end.get(second).unwrap_or(start.y));
        let ccw = motion == Motion::CounterClockwise;
        let tol = self.core.job.settings.control.mtc200.circle_tolerance;
        let shape = match w.radius {
            Some(at) => ArcShape::Radius { radius: self.arc_radius(at, w)?, ccw, tol },
            None => ArcShape::Center { center: self.centre(w, plane, start, to)?, ccw, tol },
        };
        self.waits_in_contour(true, span)?;
        self.st.corners.may_follow = true;
        self.send(end, Path::Arc(Arc { plane, shape, turns: 0 }, feed));
        Ok(())
    }

    /// An arc under G91 behind a changed offset starts where the tool stands only in one of the two readings.
    fn shifted_arc(&mut self, axes: [Axis; 2], span: Span) -> Outcome {
        match axes.into_iter().find(|axis| self.st.offsets.is_shifted(*axis)) {
            Some(axis) if self.core.job.settings.control.mtc200.g91_after_offset != ShiftedIncrement::Increment => {
                self.refuse_shifted(axis, span)
            }
            _ => Ok(()),
        }
    }

    fn arc_radius(&mut self, at: At, w: &Words) -> Outcome<f64> {
        if w.has_centre() {
            return self.core.refuse(at.span, codes::P1003::arc_has_centre_or_radius());
        }
        if at.value == 0.0 {
            return self.core.refuse(at.span, codes::P3002::radius_of_arc_is_0());
        }
        self.reading(Reading::ArcRadius, at.span, codes::P8106::r_is_true_radius);
        Ok(at.value * self.st.unit())
    }

    fn no_chamfers(&self, span: Span) -> Outcome {
        self.core.refuse(span, codes::P9013::chamfers_at_outside_corners())
    }

    /// G33: the lead counts along the axis of its letter, in radius also for X.
    fn thread(&mut self, w: &Words) -> Outcome {
        let span = w.axes_span;
        if self.st.offsets.offset() == Offset::Machine || self.st.compensation.is_on() {
            return self.core.refuse(span, codes::P1003::thread_under_g53_or_path_compensation());
        }
        if self.st.spindle.stands() {
            return self.core.refuse(span, codes::M2019::spindle_does_not_turn_when_g33_begins());
        }
        let mut leads = AxisSet::MAIN.iter().filter_map(|axis| Some((axis, w.centre[axis.index()]?)));
        let (Some((along, value)), None) = (leads.next(), leads.next()) else {
            return self.core.refuse(span, codes::M2015::g33_needs_one_lead());
        };
        let lead = value * self.st.unit();
        if lead <= 0.0 {
            return self.core.refuse(w.centre_span, codes::M2015::lead_of_thread(&value));
        }
        let end = self.target(w)?;
        if !end.known().without(AxisSet::MAIN).is_empty() {
            return self.core.refuse(span, codes::P1003::thread_moves_linear_main_axes());
        }
        let mut travel = [0.0; 3];
        for (axis, to) in end.iter() {
            travel[axis.index()] = (to - self.position_of(axis, span)?).abs();
        }
        let longest = travel.iter().fold(0.0_f64, |most, way| most.max(*way));
        if longest <= SAME_POINT || travel[along.index()] < longest - SAME_POINT {
            let letter = ["I", "J", "K"][along.index()];
            return self.core.refuse(w.centre_span, codes::M2015::is_not_lead_of_longer_travel(&letter));
        }
        if travel.iter().filter(|way| **way > SAME_POINT).count() > 1 {
            self.reading(Reading::ThreadTaper, w.centre_span, codes::P8106::lead_of_taper_counts_along_longer);
        }
        self.st.corners.cannot_follow();
        self.send(end, Path::Thread(Thread { lead, along: Some(along) }));
        Ok(())
    }

    // Corners.

    /// CF or RD at the end of a block, or in a block of its own.
    pub(super) fn corner(&mut self, w: &Words) -> Outcome {
        let (at, name) = match (w.chamfer, w.rounding) {
            (Some(at), _) => (at, "CF"),
            (_, Some(at)) => (at, "RD"),
            _ => return Ok(()),
        };
        let size = at.value * self.st.unit();
        if size <= 0.0 {
            return self.core.refuse(at.span, codes::P1004::needs_length_above_zero(&name));
        }
        if !self.st.corners.may_follow || self.st.corners.is_open() {
            return self.core.refuse(at.span, codes::M2016::no_block_that_moves_at_feed_stands(&name));
        }
        let feed = self.cutting_feed(at.span)?;
        let shape =
            if name == "CF" { CornerShape::Chamfer { side: size } } else { CornerShape::Rounding { radius: size } };
        self.send_corner(&Corner {
            shape,
            feed: Some(feed),
            early: false,
            modal: false,
            large: LargeCorner::Refuse,
            at_arc: if self.core.job.settings.control.mtc200.chamfers_along_arcs {
                ArcChamfer::Along
            } else {
                ArcChamfer::Ask(&AT_ARC)
            },
            blocks: Blocks::PassedOver,
        });
        let site = self.core.loc(at.span);
        self.st.corners.open.open(site);
        Ok(())
    }

    /// Before a motion: may it be the second neighbour of the corner that waits?
    #[inline]
    fn check_corner(&mut self, motion: Motion, span: Span) -> Outcome {
        let Some(loc) = self.st.corners.open.site() else { return Ok(()) };
        if matches!(motion, Motion::Rapid | Motion::Thread) || self.st.offsets.offset() == Offset::Machine {
            self.st.corners.open.close();
            self.core.report(
                codes::M2016::block_behind_chamfer_or_rounding_is_no()
                    .at(self.core.loc(span))
                    .also(loc, Label::CornerProgrammed),
            );
            return Err(Reported);
        }
        Ok(())
    }

    /// After a block without motion: has the corner waited too long?
    pub(super) fn count_between(&mut self) -> Outcome {
        self.waits_in_contour(false, Span::default())?;
        self.st.corners.cannot_follow();
        let Some(loc) = self.st.corners.open.wait(MOST_BETWEEN) else { return Ok(()) };
        self.core.report(codes::M2016::more_than_blocks_without_motion_stand(&MOST_BETWEEN).at(loc));
        Err(Reported)
    }

    /// A motion block failed: the axes it would have moved are unknown now.
    #[cold]
    pub(super) fn lose_all(&mut self) {
        self.st.position.lose(AxisSet::MAIN);
        self.st.corners.open.close();
        // The block may have held the feed that the next ones need.
        self.st.feed.presume();
        self.lost();
    }
}

/// Both axes of a plane.
pub(super) fn plane_axes(plane: Plane) -> [usize; 2] {
    let (first, second, _) = plane.axes();
    [first, second]
}
