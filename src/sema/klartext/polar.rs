//! Polar blocks: LP, CTP, CP, and the pole they refer to.
//!
//! Source: K 2.2 and 2.8 (docs/sources.md).

use crate::diag::{Answer, Label, codes};
use crate::geo::arc::{self, Closing};
use crate::geo::{Deg, Plane, Point2, SAME_POINT, Vec2, angle, distance};
use crate::ir::Pos;
use crate::ir::contour::{Arc, ArcShape, Path};
use crate::machine::{Axis, AxisSet, CcMissing, CpSign, PolarMissing};
use crate::parser::klartext::ast::Block;
use crate::sema::common::plane::plane_axes;
use crate::text::Loc;
use crate::text::Span;

use super::words::{Admits, Words};
use super::{Outcome, Reported, Run};

#[derive(Debug, Clone, Copy)]
pub(super) struct PoleState {
    pub at: Point2,
    pub plane: Plane,
    pub set: Loc,
    pub system: u32,
    /// A polar block named or reached an angle about it.
    pub used: bool,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct LastPolar {
    /// Not negative: a negative PR is kept as its opposite direction.
    pub radius: f64,
    pub angle: Deg,
    pub pole: Point2,
    pub plane: Plane,
    /// PR was written negative or zero: what a missing word means then is open.
    pub doubtful: bool,
}

impl LastPolar {
    pub fn new(radius: f64, angle: Deg, pole: &PoleState) -> LastPolar {
        let (at, plane) = (pole.at, pole.plane);
        let angle = if radius < 0.0 { Deg(angle.0 + 180.0) } else { angle };
        LastPolar { radius: radius.abs(), angle, pole: at, plane, doubtful: radius <= 0.0 }
    }
}

/// Poles, and what polar blocks and arcs leave to the next.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct PolarState {
    pole: Option<PoleState>,
    /// A pole block was refused: a missing pole is not worth another error.
    lost: bool,
    /// Radius and angle of the last polar block, while nothing else moved in the plane.
    last: Option<LastPolar>,
    /// Radius and angle last written in a polar block.
    programmed: Option<(f64, Deg)>,
    /// Counter-clockwise, of the last arc.
    turn: Option<bool>,
}

impl PolarState {
    pub fn pole(&self) -> Option<PoleState> {
        self.pole
    }

    /// Radius and angle of the last polar block hold.
    pub fn has_last(&self) -> bool {
        self.last.is_some()
    }

    pub fn is_lost(&self) -> bool {
        self.lost
    }

    /// Counter-clockwise, of the last arc.
    pub fn turn(&self) -> Option<bool> {
        self.turn
    }

    pub fn set_turn(&mut self, ccw: bool) {
        self.turn = Some(ccw);
    }

    /// The pole is not known any more, which was reported.
    pub fn lose_pole(&mut self) {
        (self.pole, self.lost) = (None, true);
    }

    /// A free contour follows: a pole in front of it does not hold behind it.
    pub fn forget_pole(&mut self) {
        self.pole = None;
    }

    /// Something else moved: radius and angle of the last polar block do not count.
    #[inline]
    pub fn forget_last(&mut self) {
        self.last = None;
    }

    /// The same where one of these axes moved.
    #[inline]
    pub fn forget_last_of(&mut self, axes: AxisSet) {
        if let Some(last) = self.last
            && !plane_axes(last.plane).common(axes).is_empty()
        {
            self.last = None;
        }
    }

    fn keep(&mut self, radius: f64, angle: Deg, pole: &PoleState) {
        self.last = Some(LastPolar::new(radius, angle, pole));
        self.programmed = Some((radius, angle));
        if let Some(pole) = &mut self.pole {
            pole.used = true;
        }
    }
}

impl Run<'_> {
    /// Radius and angle of the start, about the pole: as the last polar block left them, or from the position.
    pub(super) fn polar_start(&mut self, pole: &PoleState, what: &str) -> Outcome<(f64, Option<Deg>)> {
        if let Some(last) = self.st.polar.last
            && last.pole == pole.at
            && last.plane == pole.plane
        {
            return Ok((last.radius, Some(last.angle)));
        }
        let start = self.start_in(pole.plane, what)?;
        let v: Vec2 = start - pole.at;
        let radius = distance(start, pole.at);
        Ok((radius, (radius > SAME_POINT).then(|| Deg::of(v))))
    }

    /// A missing polar word: the same as the position, or the last programmed one.
    pub(super) fn inherited_polar(
        &mut self,
        w: &Words,
        pole: &PoleState,
        start: (f64, Option<Deg>),
    ) -> Outcome<(f64, Option<Deg>)> {
        let plain = |word: Option<(f64, bool)>| matches!(word, Some((_, false)));
        let complete = plain(w.polar_radius) && plain(w.polar_angle);
        let last = self.st.polar.last.filter(|last| last.pole == pole.at && last.plane == pole.plane);
        let missing = w.polar_radius.is_none() || w.polar_angle.is_none();
        match last {
            _ if complete => return Ok(start),
            Some(LastPolar { doubtful: false, .. }) => return Ok(start),
            None if !missing => return Ok(start),
            _ => {}
        }
        if self.core.job.settings.control.polar_missing == PolarMissing::Programmed
            && let Some((radius, angle)) = self.st.polar.programmed
        {
            return Ok((radius, Some(angle)));
        }
        let chosen = self.core.job.settings.control.polar_missing != PolarMissing::SamePole;
        if w.polar_angle.is_none() && !pole.used && !chosen && start.1.is_some() {
            return self.angle_of_new_pole(w, pole);
        }
        // Without an angle the block is refused, and that is enough to say.
        if start.1.is_some() || matches!(w.polar_angle, Some((_, false))) {
            self.core.say_here(match last {
                Some(_) => codes::K2107::open_word_is_computed_from_position(),
                None => codes::K2107::missing_word_is_computed_from_position(),
            });
        }
        Ok(start)
    }

    #[cold]
    fn angle_of_new_pole<T>(&mut self, w: &Words, pole: &PoleState) -> Outcome<T> {
        self.core.report(
            codes::K2811::pa_is_missing()
                .answer(Answer::key("control", "polar_missing"))
                .at(self.core.loc(w.polar_radius_span))
                .also(pole.set, Label::Pole),
        );
        Err(Reported)
    }

    /// What a polar block leaves to the next.
    pub(super) fn keep_polar(&mut self, radius: f64, angle: Deg, pole: &PoleState) {
        self.st.polar.keep(radius, angle, pole);
    }

    /// LP.
    pub(super) fn polar_line(&mut self, w: &Words) -> Outcome {
        let pole = self.pole("LP")?;
        let (radius, angle) = self.polar_words(w, &pole, "LP")?;
        let feed = self.move_feed(w)?;
        let end = self.polar_end(w, &pole, (radius, angle), feed.is_some())?;
        let feed = self.plunge_feed(w, feed, &end, None);
        self.send(&end, Path::straight(feed));
        self.keep_polar(radius, angle, &pole);
        Ok(())
    }

    /// CTP.
    pub(super) fn tangent_polar(&mut self, w: &Words) -> Outcome {
        let pole = self.pole("CTP")?;
        self.check_edge_feed(self.st.compensation.side())?;
        let (radius, angle) = self.polar_words(w, &pole, "CTP")?;
        let feed = self.arc_feed(w)?;
        let end = self.polar_end(w, &pole, (radius, angle), true)?;
        self.flat(w, pole.plane, "CTP")?;
        self.follows_a_block("CTP")?;
        self.start_in(pole.plane, "CTP")?;
        let feed = self.plunged(w, feed, &end, None);
        let arc = Arc { plane: pole.plane, shape: ArcShape::Tangent, turns: 0 };
        self.send(&end, Path::Arc(arc, feed));
        self.keep_polar(radius, angle, &pole);
        Ok(())
    }

    /// Radius and angle of the end of LP or CTP.
    pub(super) fn polar_words(&mut self, w: &Words, pole: &PoleState, function: &str) -> Outcome<(f64, Deg)> {
        if w.polar_radius.is_none() && w.polar_angle.is_none() {
            return self.core.refuse(self.core.block_span(), codes::K2109::has_neither_pr_nor_pa(&function));
        }
        let complete = matches!((w.polar_radius, w.polar_angle), (Some((_, false)), Some((_, false))));
        let start = if complete { (0.0, None) } else { self.polar_start(pole, function)? };
        let (r0, a0) = self.inherited_polar(w, pole, start)?;
        let radius = match w.polar_radius {
            Some((r, false)) => r,
            Some((r, true)) => start.0 + r,
            None => r0,
        };
        let angle = match (w.polar_angle, start.1, a0) {
            (Some((a, false)), ..) => Deg(a),
            (Some((a, true)), Some(from), _) => Deg(from.0 + a),
            (None, _, Some(angle)) => angle,
            _ => return self.angle_undefined(w),
        };
        self.forbid_plane_axes(w, pole.plane, function)?;
        Ok((radius, angle))
    }

    /// The end point of LP or CTP with the axes beside the plane.
    fn polar_end(&mut self, w: &Words, pole: &PoleState, to: (f64, Deg), cuts: bool) -> Outcome<Pos> {
        let rest = self.absolute(w)?;
        let mut end = self.check_axes(w, rest, cuts)?;
        end.set_in_plane(pole.plane, angle::polar_point(pole.at, to.0, to.1));
        Ok(end)
    }

    pub(super) fn angle_undefined<T>(&mut self, w: &Words) -> Outcome<T> {
        let span = if w.polar_angle.is_some() { w.polar_angle_span } else { w.polar_radius_span };
        self.core.refuse(span, codes::K2110::tool_stands_on_pole())
    }

    /// CP: arc or helix about the pole.
    pub(super) fn polar_arc(&mut self, w: &Words) -> Outcome {
        let pole = self.pole("CP")?;
        if w.polar_radius.is_some() {
            return self.core.refuse(w.polar_radius_span, codes::P1003::cp_takes_no_pr());
        }
        let Some((angle, incremental)) = w.polar_angle else {
            return self.core.refuse(self.core.block_span(), codes::K2109::cp_needs_pa_or_ipa());
        };
        self.forbid_plane_axes(w, pole.plane, "CP")?;
        let start = self.start_in(pole.plane, "CP")?;
        let (radius, Some(from)) = self.polar_start(&pole, "CP")? else { return self.angle_undefined(w) };
        let sweep = if incremental {
            self.incremental_sweep(w, angle)?
        } else {
            let ccw = self.turn(w, "CP")?;
            if angle.abs() > 360.0 {
                self.core
                    .report(codes::K2106::pa_is_reduced_to_direction(&angle).at(self.core.loc(w.polar_angle_span)));
            }
            self.absolute_sweep(from, angle, ccw, radius)?
        };
        let mut end = self.absolute(w)?;
        end.set_in_plane(pole.plane, angle::rotated(start, pole.at, Deg(sweep)));
        let cuts = self.move_feed(w)?.is_some();
        let end = self.check_axes(w, end, cuts)?;
        let shape = ArcShape::Sweep { center: pole.at, sweep: Deg(sweep) };
        self.send_arc(w, pole.plane, shape, end)?;
        let angle = Deg(from.0 + sweep);
        self.keep_polar(radius, angle, &pole);
        Ok(())
    }

    /// IPA is the sweep itself; its sign and DR must agree.
    pub(super) fn incremental_sweep(&mut self, w: &Words, angle: f64) -> Outcome<f64> {
        if angle == 0.0 {
            return self.core.refuse(w.polar_angle_span, codes::K2109::ipa_is_zero());
        }
        let ccw = match w.turn {
            Some(turn) => turn,
            None => self.turn(w, "CP")?,
        };
        self.st.polar.turn = Some(ccw);
        if ccw == (angle > 0.0) {
            return Ok(angle);
        }
        if self.core.job.settings.control.cp_sign == CpSign::Dr {
            let one_turn = Deg(angle).normal().0;
            return Ok(match (ccw, one_turn == 0.0) {
                (true, true) => 360.0,
                (true, false) => one_turn,
                (false, true) => -360.0,
                (false, false) => one_turn - 360.0,
            });
        }
        self.core.refuse(
            w.polar_angle_span,
            codes::K2105::ipa_turns_one_way(&angle).answer(Answer::key("control", "cp_sign").one_of(&["\"dr\""])),
        )
    }

    /// Axes of the plane have no place beside a polar end.
    pub(super) fn forbid_plane_axes(&mut self, w: &Words, plane: Plane, function: &str) -> Outcome {
        if w.axes.known().common(plane_axes(plane)).is_empty() {
            return Ok(());
        }
        self.core.refuse(w.axes_span, codes::P1003::takes_its_end_from_pr(&function))
    }

    pub(super) fn pole_block(&mut self, block: &Block) -> Outcome {
        let result = self.gather(block, "CC", Admits::AXES).and_then(|w| {
            let result = self.set_pole(&w, block.span);
            self.put_back(w);
            result
        });
        self.st.polar.lost = false;
        if result.is_err() {
            self.st.polar.lose_pole();
        }
        result
    }

    fn set_pole(&mut self, w: &Words, span: Span) -> Outcome {
        let axes = w.axes.known();
        if !axes.without(AxisSet::MAIN).is_empty() || axes.len() > 2 {
            return self.core.refuse(w.axes_span, codes::P1003::cc_takes_two_of_x());
        }
        let mut indices = axes.iter().map(Axis::index);
        let plane = match (indices.next(), indices.next()) {
            (Some(a), Some(b)) => Plane::spanned_by(a, b).unwrap_or_default(),
            (Some(a), None) => {
                let plane = self.st.plane();
                let (first, second, _) = plane.axes();
                if a != first && a != second {
                    return self.core.refuse(w.axes_span, codes::P1003::this_axis_is_not_in_working_plane());
                }
                plane
            }
            _ => self.st.plane(),
        };
        let written = self.absolute(w)?;
        let (first, second, _) = plane.axes();
        let previous = self.st.polar.pole.filter(|pole| pole.plane == plane);
        let keep = axes.len() == 1 && self.core.job.settings.control.cc_missing == CcMissing::Previous;
        let old = previous.filter(|_| keep).map(|pole| pole.at);
        if axes.len() == 1 {
            let from = if old.is_some() { "the CC before" } else { "the position" };
            self.core.report(codes::K2102::cc_with_one_coordinate(&from).at(self.core.loc(span)));
        }
        let mut coordinate = |axis: Axis, old: Option<f64>| match (written.get(axis), old) {
            (Some(value), _) => Ok(value),
            (None, Some(old)) => Ok(old),
            (None, None) => self.position_of(axis, span, "CC"),
        };
        let x = coordinate(Axis::ALL[first], old.map(|p| p.x))?;
        let y = coordinate(Axis::ALL[second], old.map(|p| p.y))?;
        let (at, set, system) = (Point2::new(x, y), self.core.loc(span), self.st.frames.system());
        self.st.polar.pole = Some(PoleState { at, plane, set, system, used: false });
        Ok(())
    }

    /// Sweep from `from` to the direction `to`, at most one turn; a turn if there is nothing to go.
    fn absolute_sweep(&mut self, from: Deg, to: f64, ccw: bool, radius: f64) -> Outcome<f64> {
        let ahead = Deg(to - from.0).normal().0;
        let away = ahead.min(360.0 - ahead);
        let gap = away.to_radians() * radius;
        match arc::closing(Vec2::new(gap, 0.0)) {
            Closing::Closed => Ok(if ccw { 360.0 } else { -360.0 }),
            Closing::Unclear => {
                self.core.refuse(self.core.block_span(), codes::G3023::cp_starts_mm_beside_its_end(&gap))
            }
            Closing::Open => Ok(if ccw { ahead } else { ahead - 360.0 }),
        }
    }
}
