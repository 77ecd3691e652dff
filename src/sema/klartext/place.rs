//! Where axes stand behind a tool change and behind M91, as far as the configuration says.
//!
//! `[machine] after_tool_change` counts in the datum in force, or from the machine zero; `[datums]` says where the datum
//! lies. Machine coordinates are those of the spindle nose: the length of the tool does not count in them. Source: K 1.5
//! and 4.2 (docs/sources.md).

use std::fmt::Display;

use crate::diag::{Answer, Fault, codes};
use crate::geo::{Plane, Point2, SAME_POINT, arc, distance};
use crate::ir::contour::ArcShape;
use crate::ir::{Feed, Pos};
use crate::machine::{Axis, AxisSet};
use crate::sema::common::hidden::By;
use crate::sema::common::plane::plane_axes;
use crate::sema::run::Where;
use crate::sema::run::place::{ACTIVE, Lack, Unknown, out_of_machine, zero};
use crate::text::Span;

use super::active_tool::ActiveTool;
use super::state::State;
use super::words::Words;
use super::{Core, Outcome, Reported, Run};

/// The name under `[datums]` of the place that M92 counts from.
const BUILDERS: &str = "M92";

impl ActiveTool {
    /// Length that printed coordinates count with: that of the tool table. DL of a TOOL CALL is part of the coordinates
    /// ([`Run::update_frame`]).
    fn printed_length(&self) -> Option<f64> {
        self.length.map(|length| length + self.table_deltas[0])
    }
}

/// What a block sees: the machine under it, and the state before it. Nothing is changed by looking.
#[derive(Clone, Copy)]
pub(super) struct View<'v, 'a> {
    pub core: &'v Core<'a>,
    pub st: &'v State,
}

impl View<'_, '_> {
    /// The name under `[datums]` of the datum in force: the work offset that its preset is printed as.
    fn datum_name(&self) -> String {
        let Some(row) = self.st.frames.preset_row() else { return ACTIVE.to_owned() };
        match self.core.job.settings.datums.presets.get(&row).map_or(row, |offset| u32::from(*offset)) {
            number @ 1..=6 => format!("G{}", 53 + number),
            number @ 7..=9 => format!("G59.{}", number - 6),
            number => format!("G54.1 P{}", number.saturating_sub(9)),
        }
    }

    /// What lies between the machine coordinate of an axis and its printed place in the datum.
    fn zero_in_machine(&self, axis: Axis) -> Result<f64, Lack> {
        let frames = &self.st.frames;
        if !self.st.tilt.is_upright() {
            return Err(Lack::Nothing);
        }
        if frames.transform().is_turned_as_a_whole() || frames.transform().turn.0 != 0.0 {
            return Err(Lack::Nothing);
        }
        let name = self.datum_name();
        let zero = zero(&self.core.job.settings.datums, &[&name], axis).map_err(|name| Lack::Datum(name.to_owned()))?;
        if axis != self.st.axis() {
            return Ok(zero);
        }
        let tool = self.st.tool.active();
        match tool.and_then(ActiveTool::printed_length) {
            Some(length) => Ok(zero + length),
            None => Err(Lack::Length(tool.and_then(|tool| tool.own))),
        }
    }

    /// The machine coordinate at which an axis stands: named by an M91, or out of its place in the datum.
    pub fn machine_coordinate(&self, axis: Axis) -> Option<f64> {
        match (self.st.position.get(axis), self.st.position.hidden(axis)) {
            (Some(at), _) => {
                let mut place = Pos::UNKNOWN;
                place.set(axis, at);
                let frame = &self.st.ctx.frame;
                let at = if frame.is_shift() {
                    frame.apply(&place).get(axis)
                } else {
                    frame.apply(self.st.position.at()).get(axis)
                };
                Some(at? + self.zero_in_machine(axis).ok()?)
            }
            (None, Some((By::Machine(value), _))) => value,
            (None, _) => None,
        }
    }

    /// Machine coordinates of the axes that the next datum finds where they stand: not of those that never moved, which
    /// `[start]` tells in that datum, nor of those that somebody may have moved.
    pub fn machine_coordinates(&self) -> Pos {
        let position = &self.st.position;
        let start = position.start();
        let mut known = Pos::UNKNOWN;
        for axis in AxisSet::MAIN.iter() {
            let open = position.may_be_moved(axis) || position.stands_beside(AxisSet::of(axis));
            match self.machine_coordinate(axis) {
                Some(value) if start.get(axis).is_none() && !open => known.set(axis, value),
                _ => {}
            }
        }
        known
    }

    /// M92: machine coordinates of an end point that counts from a place of the machine builder.
    pub fn by_builders_datum(&self, w: &Words) -> Outcome<Pos> {
        let span = w.any_m(&[92]).map_or(w.axes_span, |m| m.span);
        if w.has_m(91) {
            return self.core.refuse(span, codes::K9008::m91_m92_count_from_two_places());
        }
        let mut end = Pos::UNKNOWN;
        for (axis, value) in w.axes.iter() {
            match zero(&self.core.job.settings.datums, &[BUILDERS], axis) {
                Ok(zero) => end.set(axis, zero + value),
                Err(name) => {
                    let fault = codes::K9008::m92_counts_from_position_that_machine_builder(&axis.letter(), &name);
                    return self.core.refuse(span, fault.answer(Answer::datum(name)));
                }
            }
        }
        Ok(end)
    }

    /// An error where the position of an axis is needed and not known; `fault` makes it of the axis and why.
    pub fn unknown_position<T>(
        &self,
        axis: Axis,
        place: impl Into<Where>,
        fault: impl FnOnce(&dyn Display, &dyn Display) -> Fault,
    ) -> Outcome<T> {
        let lack = || self.zero_in_machine(axis).err().unwrap_or(Lack::Nothing);
        let unknown = Unknown { position: &self.st.position, axis, lack: &lack, otherwise: " here" };
        self.core.position_unknown(place, unknown, fault)
    }

    /// Where axes at machine coordinates stand in the datum, as far as that is known.
    pub fn out_of_machine(&self, at: &Pos) -> Pos {
        out_of_machine(at, |axis, value| Some(value - self.zero_in_machine(axis).ok()?))
    }

    /// Where the configuration says that a change of the tool leaves the axes.
    pub fn after_change(&self) -> Pos {
        match self.st.position.after_change() {
            (after, true) => self.out_of_machine(&after),
            (after, false) => self.printed(after),
        }
    }

    /// Places that the control shows in the datum, as they are printed: with the oversize DL of TOOL CALL.
    fn printed(&self, mut places: Pos) -> Pos {
        let axis = self.st.axis();
        let oversize = self.st.tool.active().map_or(0.0, |tool| tool.call_deltas[0]);
        match places.get(axis) {
            Some(shown) if oversize != 0.0 => places.set(axis, shown + oversize),
            _ => {}
        }
        places
    }

    /// Turns an axis value into an absolute one. `None` for axes that the block does not name.
    pub fn absolute(&self, w: &Words) -> Outcome<Pos> {
        if w.incremental.is_empty() {
            return Ok(w.axes);
        }
        let mut end = w.axes;
        for axis in w.incremental.iter() {
            let from = self.position_of(axis, w.axes_span, "an incremental word")?;
            end.set(axis, from + w.axes.get(axis).unwrap_or(0.0));
        }
        Ok(end)
    }

    /// Programmed position of an axis; an error where it is not known.
    pub fn position_of(&self, axis: Axis, span: Span, what: &str) -> Outcome<f64> {
        if let Some(value) = self.st.position.programmed(axis) {
            return Ok(value);
        }
        if self.st.position.is_lost(axis) {
            return Err(Reported);
        }
        self.unknown_position(axis, span, |axis, why| codes::P2001::needs_position_of(&what, axis, why))
    }

    /// Where the tool stands in `plane`.
    pub fn start_in(&self, plane: Plane, what: &str) -> Outcome<Point2> {
        let (first, second, _) = plane.axes();
        let span = self.core.block_span();
        if self.st.position.stands_beside(plane_axes(plane)) {
            return self.core.refuse(span, codes::K2604::starts_where_r_or_r_left_tool(&what));
        }
        let x = self.position_of(Axis::ALL[first], span, what)?;
        let y = self.position_of(Axis::ALL[second], span, what)?;
        Ok(Point2::new(x, y))
    }

    /// Length of an arc in its plane. An arc that does not exist has none: it is refused later.
    pub fn arc_length(&self, plane: Plane, shape: ArcShape, end: &Pos) -> Outcome<f64> {
        let from = self.start_in(plane, "M103")?;
        let Some(to) = end.in_plane(plane) else { return Ok(0.0) };
        let about = |center: Point2, ccw: bool| {
            let whole = distance(from, to) <= SAME_POINT;
            let sweep = if whole { core::f64::consts::TAU } else { arc::sweep(from, to, center, ccw).abs() };
            distance(from, center) * sweep
        };
        Ok(match shape {
            ArcShape::Center { center, ccw, .. } => about(center, ccw),
            ArcShape::Sweep { center, sweep } => distance(from, center) * sweep.radians().abs(),
            ArcShape::Radius { radius, ccw, tol } => {
                arc::center_by_radius(from, to, radius, ccw, SAME_POINT, tol).map_or(0.0, |center| about(center, ccw))
            }
            // A tangential arc moves no other axis, and the rest is not of this language.
            ArcShape::Tangent | ArcShape::Opening { .. } | ArcShape::Via { .. } => 0.0,
        })
    }

    /// CT and CTP go on from the element of the program in front of them, not from the way of a cycle.
    pub fn follows_a_block(&self, function: &str) -> Outcome {
        if !self.st.position.moved_by_cycle() {
            return Ok(());
        }
        self.core.refuse(Where::Block, codes::K2946::stands_directly_behind_cycle(&function))
    }

    /// M103: the feed component into the workpiece is limited.
    ///
    /// `in_plane` is the length of an arc; without it the way is straight.
    #[inline]
    pub fn plunged(&self, w: &Words, feed: Feed, end: &Pos, in_plane: Option<f64>) -> Feed {
        match self.st.feed.plunge_share() {
            Some(share) => self.shared_feed(w, feed, share, end, in_plane),
            None => feed,
        }
    }

    #[cold]
    fn shared_feed(&self, w: &Words, feed: Feed, share: f64, end: &Pos, in_plane: Option<f64>) -> Feed {
        let tool_axis = self.st.axis();
        if end.get(tool_axis).is_none() {
            return feed;
        }
        let mut step = nalgebra::Vector3::zeros();
        let mut open = AxisSet::EMPTY;
        for axis in AxisSet::MAIN.iter() {
            match (end.get(axis), self.st.position.get(axis)) {
                (Some(to), Some(from)) => step[axis.index()] = to - from,
                (Some(_), None) => open.insert(axis),
                (None, _) => {}
            }
        }
        // Which way is down, and how long the way is, counts on the workpiece.
        let linear = *self.st.ctx.frame.linear();
        let real = linear * step;
        let down = real[tool_axis.index()];
        if open.contains(tool_axis) || (down < 0.0 && !open.is_empty()) {
            self.core.say(w.axes_span, codes::K2709::start_of_this_move_is_not_known(&(share * 100.0)));
            return feed.with_value(feed.value() * share);
        }
        if down >= 0.0 {
            return feed;
        }
        let way = match in_plane {
            Some(length) => {
                let (first, ..) = self.st.plane().axes();
                libm::hypot(length * linear.column(first).norm(), down)
            }
            None => real.norm(),
        };
        feed.with_value((feed.value() * share * way / -down).min(feed.value()))
    }
}

impl<'a> Run<'a> {
    /// What the block in hand sees.
    #[inline]
    pub(super) fn view(&self) -> View<'_, 'a> {
        View { core: &self.core, st: &self.st }
    }

    /// These axes went to machine coordinates: their places are known where the datum is.
    pub(super) fn moved_by_machine(&mut self, end: &Pos) {
        let loc = self.core.here.origin.loc;
        self.st.moved_by_machine(end, loc);
        let places = self.view().out_of_machine(end);
        self.st.stand(&mut self.core, &places);
    }

    /// The change is over: axes stand where the configuration says.
    pub(super) fn stand_after_change(&mut self) {
        let places = self.view().after_change();
        self.st.stand(&mut self.core, &places);
    }
}
