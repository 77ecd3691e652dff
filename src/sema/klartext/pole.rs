//! Poles, and what polar blocks and arcs leave to the next.
//!
//! Source: K 2.2, 2.8 (docs/sources.md).

use crate::diag::{Answer, Label, codes};
use crate::geo::arc::{self, Closing};
use crate::geo::{Deg, Plane, Point2, SAME_POINT, Vec2, distance};
use crate::machine::{AxisSet, CpSign, PolarMissing};
use crate::sema::common::plane::plane_axes;
use crate::sema::run::Where;
use crate::text::Loc;

use super::words::Words;
use super::{Core, Outcome, Reported};

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

    /// Counter-clockwise, of an arc.
    pub fn set_turn(&mut self, ccw: bool) {
        self.turn = Some(ccw);
    }

    /// CC at a point, or refused.
    pub fn set_pole(&mut self, pole: Option<PoleState>) {
        (self.pole, self.lost) = (pole, pole.is_none());
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

    /// What a polar block leaves to the next.
    pub fn keep(&mut self, radius: f64, angle: Deg, pole: &PoleState) {
        self.last = Some(LastPolar::new(radius, angle, pole));
        self.programmed = Some((radius, angle));
        if let Some(pole) = &mut self.pole {
            pole.used = true;
        }
    }

    /// The pole in force.
    pub fn needed(&self, core: &Core<'_>, system: u32, function: &str) -> Outcome<PoleState> {
        let Some(pole) = self.pole else {
            if self.lost {
                return Err(Reported);
            }
            return core.refuse(Where::Block, codes::K2101::needs_circle_centre_or_pole(&function));
        };
        if pole.system != system {
            core.report(
                codes::K2108::coordinate_system_changed_since_cc_was_programmed()
                    .at(core.here.origin.loc)
                    .also(pole.set, Label::PoleProgrammed),
            );
        }
        Ok(pole)
    }

    /// Direction of an arc: as written, or that of the last one.
    pub fn turns(&mut self, core: &Core<'_>, w: &Words, function: &str) -> Outcome<bool> {
        let turn = match (w.turn, self.turn) {
            (Some(turn), _) => turn,
            (None, Some(turn)) => {
                let last = if turn { "DR+" } else { "DR-" };
                core.say_here(codes::K2103::without_dr_turns_as_last_dr_said(&function, &last));
                turn
            }
            (None, None) => {
                return core.refuse(Where::Block, codes::K2104::without_dr_no_arc_before(&function));
            }
        };
        self.turn = Some(turn);
        Ok(turn)
    }

    /// Radius and angle of the start, about the pole: as the last polar block left them, or from the position.
    pub fn start(&self, pole: &PoleState, stands: &dyn Fn() -> Outcome<Point2>) -> Outcome<(f64, Option<Deg>)> {
        if let Some(last) = self.last
            && last.pole == pole.at
            && last.plane == pole.plane
        {
            return Ok((last.radius, Some(last.angle)));
        }
        let start = stands()?;
        let v: Vec2 = start - pole.at;
        let radius = distance(start, pole.at);
        Ok((radius, (radius > SAME_POINT).then(|| Deg::of(v))))
    }

    /// A missing polar word: the same as the position, or the last programmed one.
    fn inherited(
        &self,
        core: &Core<'_>,
        w: &Words,
        pole: &PoleState,
        start: (f64, Option<Deg>),
    ) -> Outcome<(f64, Option<Deg>)> {
        let plain = |word: Option<(f64, bool)>| matches!(word, Some((_, false)));
        let complete = plain(w.polar_radius) && plain(w.polar_angle);
        let last = self.last.filter(|last| last.pole == pole.at && last.plane == pole.plane);
        let missing = w.polar_radius.is_none() || w.polar_angle.is_none();
        match last {
            _ if complete => return Ok(start),
            Some(LastPolar { doubtful: false, .. }) => return Ok(start),
            None if !missing => return Ok(start),
            _ => {}
        }
        if core.job.settings.control.polar_missing == PolarMissing::Programmed
            && let Some((radius, angle)) = self.programmed
        {
            return Ok((radius, Some(angle)));
        }
        let chosen = core.job.settings.control.polar_missing != PolarMissing::SamePole;
        if w.polar_angle.is_none() && !pole.used && !chosen && start.1.is_some() {
            let fault = codes::K2811::pa_is_missing().answer(Answer::key("control", "polar_missing"));
            core.report(fault.at(core.loc(w.polar_radius_span)).also(pole.set, Label::Pole));
            return Err(Reported);
        }
        // Without an angle the block is refused, and that is enough to say.
        if start.1.is_some() || matches!(w.polar_angle, Some((_, false))) {
            core.say_here(match last {
                Some(_) => codes::K2107::open_word_is_computed_from_position(),
                None => codes::K2107::missing_word_is_computed_from_position(),
            });
        }
        Ok(start)
    }

    /// Radius and angle of the end of LP or CTP.
    pub fn words(
        &self,
        core: &Core<'_>,
        w: &Words,
        pole: &PoleState,
        function: &str,
        stands: &dyn Fn() -> Outcome<Point2>,
    ) -> Outcome<(f64, Deg)> {
        if w.polar_radius.is_none() && w.polar_angle.is_none() {
            return core.refuse(Where::Block, codes::K2109::has_neither_pr_nor_pa(&function));
        }
        let complete = matches!((w.polar_radius, w.polar_angle), (Some((_, false)), Some((_, false))));
        let start = if complete { (0.0, None) } else { self.start(pole, stands)? };
        let (r0, a0) = self.inherited(core, w, pole, start)?;
        let radius = match w.polar_radius {
            Some((r, false)) => r,
            Some((r, true)) => start.0 + r,
            None => r0,
        };
        let angle = match (w.polar_angle, start.1, a0) {
            (Some((a, false)), ..) => Deg(a),
            (Some((a, true)), Some(from), _) => Deg(from.0 + a),
            (None, _, Some(angle)) => angle,
            _ => return angle_undefined(core, w),
        };
        w.forbid_plane_axes(core, pole.plane, function)?;
        Ok((radius, angle))
    }

    /// IPA is the sweep itself; its sign and DR must agree.
    pub fn incremental_sweep(&mut self, core: &Core<'_>, w: &Words, angle: f64) -> Outcome<f64> {
        if angle == 0.0 {
            return core.refuse(w.polar_angle_span, codes::K2109::ipa_is_zero());
        }
        let ccw = match w.turn {
            Some(turn) => turn,
            None => self.turns(core, w, "CP")?,
        };
        self.turn = Some(ccw);
        if ccw == (angle > 0.0) {
            return Ok(angle);
        }
        if core.job.settings.control.cp_sign == CpSign::Dr {
            let one_turn = Deg(angle).normal().0;
            return Ok(match (ccw, one_turn == 0.0) {
                (true, true) => 360.0,
                (true, false) => one_turn,
                (false, true) => -360.0,
                (false, false) => one_turn - 360.0,
            });
        }
        let fault = codes::K2105::ipa_turns_one_way(&angle);
        core.refuse(w.polar_angle_span, fault.answer(Answer::key("control", "cp_sign").one_of(&["\"dr\""])))
    }
}

/// The tool stands on the pole: there is no angle.
pub(super) fn angle_undefined<T>(core: &Core<'_>, w: &Words) -> Outcome<T> {
    let span = if w.polar_angle.is_some() { w.polar_angle_span } else { w.polar_radius_span };
    core.refuse(span, codes::K2110::tool_stands_on_pole())
}

/// Sweep from `from` to the direction `to`, at most one turn; a turn if there is nothing to go.
pub(super) fn absolute_sweep(core: &Core<'_>, from: Deg, to: f64, ccw: bool, radius: f64) -> Outcome<f64> {
    let ahead = Deg(to - from.0).normal().0;
    let away = ahead.min(360.0 - ahead);
    let gap = away.to_radians() * radius;
    match arc::closing(Vec2::new(gap, 0.0)) {
        Closing::Closed => Ok(if ccw { 360.0 } else { -360.0 }),
        Closing::Unclear => core.refuse(Where::Block, codes::G3023::cp_starts_mm_beside_its_end(&gap)),
        Closing::Open => Ok(if ccw { ahead } else { ahead - 360.0 }),
    }
}
