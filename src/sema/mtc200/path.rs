//! Motion blocks: straight lines, arcs, threads, corners.
//!
//! Source: M 5, 6.1, 6.2, 8 (docs/sources.md).

use crate::diag::{Answer, Fault, Label, codes};
use crate::geo::{Plane, Point2, SAME_POINT};
use crate::ir::contour::{
    Arc, ArcChamfer, ArcShape, Blocks, Coords, Corner, CornerShape, LargeCorner, Move, Path, Thread,
};
use crate::ir::{Ask, Feed, Pos, Side};
use crate::machine::options::mtc200::Reading;
use crate::machine::{Axis, AxisSet, Compensation};
use crate::sema::common::corner::OpenCorner;
use crate::sema::common::feed::ModalFeed;
use crate::sema::common::hidden::By;
use crate::sema::common::plane::plane_axes;
use crate::sema::common::position::Position;
use crate::sema::run::place::{Lack, Unknown};
use crate::sema::run::refusal::{Made, refused};
use crate::text::Span;

use super::centre::Ends;
use super::dimensions::rotary_target;
use super::g_functions::Motion;
use super::offsets::Offset;
use super::words::{At, Words};
use super::{Core, Outcome, Reported, Run};

/// A cut without a feed.
const NO_FEED: fn() -> Fault = codes::P2002::no_feed_is_programmed_for_this_move;

/// A chamfer beside an arc.
const AT_ARC: Ask = Ask::key("control", "cf_at_arcs", AT_ARC_HELP);
const AT_ARC_HELP: &str = "program a rounding beside an arc; how the control measures a chamfer there is not confirmed: for its width along both elements \
           set `[control] cf_at_arcs = \"along\"`";

/// Blocks without motion that may stand between a corner and its second neighbour.
const MOST_BETWEEN: u32 = 20;

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

    /// CF or RD at the end of a block, or in a block of its own; `unit` is mm.
    fn shape(&self, w: &Words, unit: f64) -> Made<Option<(CornerShape, Span)>> {
        let (at, name) = match (w.chamfer, w.rounding) {
            (Some(at), _) => (at, "CF"),
            (_, Some(at)) => (at, "RD"),
            _ => return Ok(None),
        };
        let size = at.value * unit;
        if size <= 0.0 {
            return refused(at.span, codes::P1004::needs_length_above_zero(&name));
        }
        if !self.may_follow || self.is_open() {
            return refused(at.span, codes::M2016::no_block_that_moves_at_feed_stands(&name));
        }
        let shape =
            if name == "CF" { CornerShape::Chamfer { side: size } } else { CornerShape::Rounding { radius: size } };
        Ok(Some((shape, at.span)))
    }
}

impl Words {
    /// R, I, J and K in a block that moves along no arc.
    #[inline]
    fn no_arc_words(&self, motion: Motion) -> Made {
        if let Some(at) = self.radius {
            return refused(at.span, codes::P1003::r_belongs_to_arc());
        }
        if self.has_centre() && motion != Motion::Thread {
            return refused(self.centre_span, codes::P1003::i_j_k_belong_to_arc_or_thread());
        }
        Ok(())
    }

    /// Lead of a thread in mm, and the axis that it counts along.
    fn lead(&self, unit: f64) -> Made<(Axis, f64)> {
        let mut leads = AxisSet::MAIN.iter().filter_map(|axis| Some((axis, self.centre[axis.index()]?)));
        let (Some((along, value)), None) = (leads.next(), leads.next()) else {
            return refused(self.axes_span, codes::M2015::g33_needs_one_lead());
        };
        if value * unit <= 0.0 {
            return refused(self.centre_span, codes::M2015::lead_of_thread(&value));
        }
        Ok((along, value * unit))
    }
}

/// The feed that F programs, in mm; none where F0 keeps the one before.
#[inline]
pub(super) fn feed_word(feed: &ModalFeed, at: At, unit: f64, zero_keeps: bool) -> Made<Option<Feed>> {
    if at.value == 0.0 {
        if zero_keeps {
            return Ok(None);
        }
        let asking = codes::P2003::feed_is_0();
        return refused(at.span, asking.answer(Answer::key("control", "zero_feed").one_of(&["\"previous\""])));
    }
    if at.value < 0.0 {
        return refused(at.span, codes::O1001::feed(&at.value));
    }
    Ok(feed.of(at.value * unit))
}

impl Core<'_> {
    /// Where an axis stands.
    pub(super) fn stands(&self, position: &Position, axis: Axis, span: Span) -> Outcome<f64> {
        let asked = Unknown { position, axis, lack: &|| Lack::Nothing, otherwise: " here" };
        self.place_of(span, asked, codes::P2001::position_is_not_known)
    }

    /// Does a straight move have a length in the plane, so that compensation can start or end on it? Both axes of the plane belong
    /// into the way to a contour, and from it.
    #[cold]
    fn switches_in(&self, plane: Plane, position: &Position, end: &Pos, span: Span) -> Outcome<bool> {
        let mut moves = false;
        let (first, second, _) = plane.axes();
        for axis in [first, second].map(|index| Axis::ALL[index]) {
            let from = self.stands(position, axis, span)?;
            moves |= end.get(axis).is_some_and(|to| (to - from).abs() > SAME_POINT);
        }
        let named = end.known().common(plane_axes(plane)).len();
        let computed = self.job.settings.output.compensation == Compensation::Resolve;
        if moves && named < 2 && computed && self.job.diags.first_time(codes::M8006, ()) {
            self.say(span, codes::M8006::way_to_contour_or_from_it_names());
        }
        Ok(moves)
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
        let offset = self.st.offsets.offset();
        if offset == Offset::Reset {
            return self.core.refuse(w.axes_span, codes::M2102::zero_offset_after_jmp_depends_on_machine());
        }
        // A corner that waits needs a second neighbour.
        if let Some(loc) = self.st.corners.open.site()
            && (matches!(motion, Motion::Rapid | Motion::Thread) || offset == Offset::Machine)
        {
            self.st.corners.open.close();
            let found = codes::M2016::block_behind_chamfer_or_rounding_is_no().at(self.core.loc(w.axes_span));
            self.core.report(found.also(loc, Label::CornerProgrammed));
            return Err(Reported);
        }
        if !motion.is_arc() {
            self.core.made(w.no_arc_words(motion))?;
        }
        match motion {
            Motion::Rapid | Motion::Line => self.straight(motion, w),
            Motion::Clockwise | Motion::CounterClockwise => self.arc(motion, w),
            Motion::Thread => self.thread(w),
        }
    }

    /// Where the block goes: the programmed axes, absolute, in mm (X: radius) and degrees.
    #[inline]
    fn target(&mut self, w: &Words) -> Outcome<Pos> {
        let settings = &self.core.job.settings.control.mtc200;
        let mut end = Pos::UNKNOWN;
        if !w.axes.known().is_empty() {
            self.core.relies_on_the_start(&mut self.st.dimensions.said, w.axes_span);
        }
        for (axis, value) in w.axes.iter() {
            let length = self.core.accept(w.axes_span, self.st.dimensions.length(axis, value))?;
            let to = if self.st.dimensions.incremental {
                let programmed = self.st.offsets.counts_from(axis, &self.st.position, settings.g91_after_offset);
                match self.core.accept(w.axes_span, programmed)? {
                    Some(programmed) => programmed + length,
                    None => self.core.stands(&self.st.position, axis, w.axes_span)? + length,
                }
            } else if axis.is_rotary() && !settings.rotary_absolute {
                let from = self.st.position.get(axis);
                self.core.accept(w.axes_span, rotary_target(axis, length, from))?
            } else {
                length
            };
            end.set(axis, to);
        }
        let [_, _, third] = roles(self.st.ctx.plane);
        if end.get(third).is_some() {
            self.st.length.moves_along(third, w.axes_span, &self.core)?;
        }
        Ok(end)
    }

    // Moves.

    /// Sends a move and takes over its end.
    #[inline]
    fn send(&mut self, end: Pos, path: Path) {
        let side = self.st.compensation.side();
        self.core.send_move(&Move { end, path, side, coords: Coords::Frame }, &self.st.ctx);
        self.st.position.move_to(&end);
        self.st.offsets.arrive(end.known());
        self.st.corners.open.close();
    }

    /// A block of a contour, or between its elements.
    #[inline]
    fn pass(&mut self, moves_in_plane: bool, span: Span) -> Outcome {
        if !self.st.compensation.is_on() {
            return Ok(());
        }
        let passed = self.st.transition.pass(moves_in_plane, self.core.job.settings.output.compensation);
        self.core.accept(span, passed)
    }

    fn straight(&mut self, motion: Motion, w: &Words) -> Outcome {
        let feed = match motion {
            Motion::Line => Some(self.core.accept(w.axes_span, self.st.feed.of_cut(NO_FEED))?),
            _ => None,
        };
        if self.st.offsets.offset() == Offset::Machine {
            let relative = self.st.dimensions.incremental || self.st.compensation.is_on();
            let g53_is_machine = self.core.job.settings.control.mtc200.g53_is_machine;
            self.core.accept(w.axes_span, may_move_in_machine(g53_is_machine, relative))?;
            let end = self.target(w)?;
            self.machine_position(end, feed);
            return Ok(());
        }
        if self.st.compensation.is_on() && self.st.transition.chamfers {
            return self.core.refuse(w.axes_span, codes::P9013::chamfers_at_outside_corners());
        }
        let end = self.target(w)?;
        if self.st.dimensions.inch && feed.is_some() && end.known().common(AxisSet::MAIN).is_empty() {
            return self.core.refuse(w.axes_span, codes::M9008::unit_of_feed_of_these_axes());
        }
        self.st.corners.may_follow = feed.is_some();
        let plane = self.st.ctx.plane;
        self.pass(!end.known().common(plane_axes(plane)).is_empty(), w.axes_span)?;
        let switches =
            self.st.compensation.changes() && self.core.switches_in(plane, &self.st.position, &end, w.axes_span)?;
        self.send(end, Path::straight(feed));
        if switches {
            self.st.compensation.moves();
        }
        Ok(())
    }

    /// Moves to machine coordinates; afterwards the workpiece position of the axes is not known.
    pub(super) fn machine_position(&mut self, end: Pos, feed: Option<Feed>) {
        let (path, coords) = (Path::straight(feed), Coords::Machine);
        self.core.send_move(&Move { end, path, side: Side::None, coords }, &self.st.ctx);
        self.st.position.leave_start(end.known());
        self.st.forget(end.known());
        self.st.position.hide(end.known(), By::Machine(None), self.core.here.origin.loc);
        self.st.corners.cannot_follow();
    }

    /// May an arc stand here? The place where it is refused.
    fn arc_begins(&self, w: &Words) -> Made<Span> {
        let span = if w.axes_span.is_empty() { w.centre_span } else { w.axes_span };
        if self.st.offsets.offset() == Offset::Machine {
            return refused(span, codes::M9005::arc_under_g53_has_no_counterpart());
        }
        if self.st.compensation.changes() {
            return refused(span, codes::P2040::g41_g42_activated_with_circular_interpolation());
        }
        if self.st.compensation.is_on() && self.st.transition.chamfers {
            return refused(span, codes::P9013::chamfers_at_outside_corners());
        }
        if !w.has_centre() && w.radius.is_none() {
            return refused(span, codes::P3002::arc_has_neither_centre_nor_radius());
        }
        Ok(span)
    }

    fn arc(&mut self, motion: Motion, w: &Words) -> Outcome {
        let settings = &self.core.job.settings.control.mtc200;
        let span = self.core.made(self.arc_begins(w))?;
        let feed = self.core.accept(span, self.st.feed.of_cut(NO_FEED))?;
        let (plane, dimensions) = (self.st.ctx.plane, self.st.dimensions);
        let [first, second, third] = roles(plane);
        let stands = |axis| self.core.stands(&self.st.position, axis, span);
        let start = Point2::new(stands(first)?, stands(second)?);
        if dimensions.incremental {
            self.core.accept(span, self.st.offsets.starts_arc([first, second], settings.g91_after_offset))?;
        }
        let mut end = self.target(w)?;
        for (axis, at) in [(first, start.x), (second, start.y)] {
            if end.get(axis).is_none() {
                end.set(axis, at);
            }
        }
        if end.known().contains(third) {
            self.core.stands(&self.st.position, third, span)?;
            self.core.reading(Reading::Helix, span, codes::P8106::third_axis_moves_evenly);
        }
        let to = Point2::new(end.get(first).unwrap_or(start.x), end.get(second).unwrap_or(start.y));
        let (ccw, tol) = (motion == Motion::CounterClockwise, settings.circle_tolerance);
        let shape = match w.radius {
            Some(at) if w.has_centre() => {
                return self.core.refuse(at.span, codes::P1003::arc_has_centre_or_radius());
            }
            Some(at) if at.value == 0.0 => return self.core.refuse(at.span, codes::P3002::radius_of_arc_is_0()),
            Some(at) => {
                self.core.reading(Reading::ArcRadius, at.span, codes::P8106::r_is_true_radius);
                ArcShape::Radius { radius: at.value * dimensions.unit(), ccw, tol }
            }
            None => {
                let arc = Ends { words: w, plane, start, end: to, dimensions };
                ArcShape::Center { center: self.settled.centre(&arc, &self.core)?, ccw, tol }
            }
        };
        self.pass(true, span)?;
        self.st.corners.may_follow = true;
        self.send(end, Path::Arc(Arc { plane, shape, turns: 0 }, feed));
        Ok(())
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
        let (along, lead) = self.core.made(w.lead(self.st.dimensions.unit()))?;
        let end = self.target(w)?;
        if !end.known().without(AxisSet::MAIN).is_empty() {
            return self.core.refuse(span, codes::P1003::thread_moves_linear_main_axes());
        }
        let mut travel = [0.0; 3];
        for (axis, to) in end.iter() {
            travel[axis.index()] = (to - self.core.stands(&self.st.position, axis, span)?).abs();
        }
        let longest = travel.iter().fold(0.0_f64, |most, way| most.max(*way));
        if longest <= SAME_POINT || travel[along.index()] < longest - SAME_POINT {
            let letter = ["I", "J", "K"][along.index()];
            return self.core.refuse(w.centre_span, codes::M2015::is_not_lead_of_longer_travel(&letter));
        }
        if travel.iter().filter(|way| **way > SAME_POINT).count() > 1 {
            let what = codes::P8106::lead_of_taper_counts_along_longer;
            self.core.reading(Reading::ThreadTaper, w.centre_span, what);
        }
        self.st.corners.cannot_follow();
        self.send(end, Path::Thread(Thread { lead, along: Some(along) }));
        Ok(())
    }

    /// CF or RD.
    pub(super) fn corner(&mut self, w: &Words) -> Outcome {
        let Some((shape, span)) = self.core.made(self.st.corners.shape(w, self.st.dimensions.unit()))? else {
            return Ok(());
        };
        let feed = Some(self.core.accept(span, self.st.feed.of_cut(NO_FEED))?);
        let along = self.core.job.settings.control.mtc200.chamfers_along_arcs;
        let at_arc = if along { ArcChamfer::Along } else { ArcChamfer::Ask(&AT_ARC) };
        let (large, blocks) = (LargeCorner::Refuse, Blocks::PassedOver);
        let corner = Corner { shape, feed, early: false, modal: false, large, at_arc, blocks };
        self.core.send_corner(&corner, &self.st.ctx);
        self.st.corners.open.open(self.core.loc(span));
        Ok(())
    }

    /// After a block without motion: has the corner waited too long?
    pub(super) fn count_between(&mut self) -> Outcome {
        self.pass(false, Span::default())?;
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
        self.core.send_lost(&self.st.ctx);
    }
}

/// May a block move under G53? `relative`: it counts from where the tool stands, or is compensated.
fn may_move_in_machine(g53_is_machine: bool, relative: bool) -> Result<(), Fault> {
    if !g53_is_machine {
        let asking = codes::M9005::block_moves_while_g53_is_active();
        return Err(asking.answer(Answer::key("control", "g53").one_of(&["\"machine\""])));
    }
    if relative {
        return Err(codes::M9005::move_under_g53_is_absolute());
    }
    Ok(())
}

/// Axes of the plane, and the one at a right angle to it.
pub(super) fn roles(plane: Plane) -> [Axis; 3] {
    let (first, second, third) = plane.axes();
    [Axis::ALL[first], Axis::ALL[second], Axis::ALL[third]]
}
