//! Codes of group 3: the programmable frame, poles, working area limits.
//!
//! Source: S 1.5 and 5.6 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::ir::Side;
use crate::machine::Axis;
use crate::sema::run::Where;
use crate::text::Span;

use super::frames::FrameValue;
use super::g_groups::{ActiveCodes, GCode, Group};
use super::vocabulary::Address;
use super::words::{Given, Mode, Words, misfit, misplaced_modifier};
use super::{Channel, Core, Outcome, State};

impl ActiveCodes {
    /// No frame may change under a contour that is compensated: the elements before and behind would not meet.
    pub(super) fn frame_is_free(&self, core: &Core<'_>, place: impl Into<Where>) -> Outcome {
        if self.side() == Side::None {
            return Ok(());
        }
        core.refuse(place, codes::S2080::frame_changes_while_radius_compensation())
    }
}

impl State {
    fn frame_statement(&mut self, core: &Core<'_>, code: GCode, span: Span, w: &mut Words) -> Outcome {
        // What a frame does to an axis that is left out moves nothing.
        w.beside.left_out.clear();
        let adds = matches!(code, GCode::ATRANS | GCode::AROT | GCode::ASCALE | GCode::AMIRROR);
        self.codes.frame_is_free(core, span)?;
        let rpl = w.take(Address::Rpl);
        if let Some(rpl) = rpl.filter(|_| !matches!(code, GCode::ROT | GCode::AROT)) {
            return core.refuse(rpl.span, misfit());
        }
        let bare = w.axes.is_empty() && rpl.is_none();
        let frame = match code {
            GCode::ATRANS => self.frames.programmable().translated(&shifts(core, self.length_unit(), w)?),
            _ => {
                let frame = frame_of(core, self, code, span, w, rpl)?;
                match (adds, bare) {
                    (true, true) => return Ok(()),
                    (true, false) => self.frames.programmable().chain(&frame),
                    // Without axes the whole programmable frame goes.
                    (false, true) => FrameValue::default(),
                    (false, false) => frame,
                }
            }
        };
        self.frames.set_programmable(frame);
        self.refresh_frame(core);
        Ok(())
    }
}

impl Channel<'_> {
    /// A code of group 3.
    pub(super) fn frame_block(&mut self, code: GCode, span: Span, w: &mut Words) -> Outcome {
        if let Some((_, suppressed)) = w.code_of(Group::Suppression) {
            return self.core.not_alone(suppressed);
        }
        match code {
            GCode::G110 | GCode::G111 | GCode::G112 => self.st.pole_block(&self.core, code, span, w)?,
            GCode::G25 | GCode::G26 => {
                for at in 0..w.s.len() {
                    let lims_counts = self.st.codes.of(Group::FeedType).ends_cutting_speed();
                    let changed = self.st.spindles.speed_range(&self.core, code, w.s[at], lims_counts)?;
                    self.function(changed);
                }
                w.s.clear();
                w.beside.left_out.clear();
                self.core.say_once(span, codes::S8013::working_area_limits());
            }
            GCode::G58 | GCode::G59 => self.axial_shift(code, span, w)?,
            _ => {
                self.pending_must_be_done(span)?;
                self.st.frame_statement(&self.core, code, span, w)?;
            }
        }
        if let Some(m) = w.m.first() {
            return self.core.not_alone(m.span);
        }
        self.core.nothing_left(w)
    }

    /// G58 and G59: parts of the programmable shift; settable offsets on small controls.
    fn axial_shift(&mut self, code: GCode, span: Span, w: &mut Words) -> Outcome {
        let small = self.core.job.settings.control.sinumerik.model == "802d";
        if w.axes.is_empty() && !small {
            return self
                .core
                .refuse(span, codes::S2013::has_no_axes(&code.word()).answer(Answer::key("control", "sinumerik")));
        }
        if small && !w.axes.is_empty() {
            return self.core.refuse(span, codes::S2013::selects_work_offset_on_802d(&code.word()));
        }
        if w.axes.is_empty() && small {
            let number = if code == GCode::G58 { 5 } else { 6 };
            return self.work_offset(number + 1, span);
        }
        self.pending_must_be_done(span)?;
        self.st.codes.frame_is_free(&self.core, span)?;
        w.beside.left_out.clear();
        for axis in w.axes.iter() {
            let Some(given) = w.axis(axis) else { continue };
            given.counts_in_frame(&self.core)?;
            let unit = if axis.is_rotary() { 1.0 } else { self.st.length_unit() };
            let place = if code == GCode::G58 {
                &mut self.st.frames.programmable_mut().shift
            } else {
                &mut self.st.frames.programmable_mut().fine
            };
            if let Some(place) = place.get_mut(axis.index()) {
                *place = given.value * unit;
            }
        }
        self.st.refresh_frame(&self.core);
        Ok(())
    }
}

/// The frame that a statement makes of its words.
fn frame_of(
    core: &Core<'_>,
    st: &State,
    code: GCode,
    span: Span,
    w: &Words,
    rpl: Option<Given>,
) -> Outcome<FrameValue> {
    Ok(match code {
        GCode::TRANS => FrameValue::shifted(&shifts(core, st.length_unit(), w)?),
        GCode::ROT | GCode::AROT => {
            let mut angles = core.geometry_values(w, 0.0)?;
            if let Some(rpl) = rpl {
                if !w.axes.is_empty() {
                    return core.not_alone(rpl.span);
                }
                let [_, _, third] = st.roles();
                if let Some(angle) = angles.get_mut(third.index()) {
                    *angle = rpl.value;
                }
            }
            FrameValue::rotated(angles)
        }
        GCode::SCALE | GCode::ASCALE => {
            let scale = core.geometry_values(w, 1.0)?;
            if scale.contains(&0.0) {
                return core.refuse(span, codes::S2034::scaling_factor_is_0());
            }
            FrameValue::scaled(scale)
        }
        GCode::MIRROR | GCode::AMIRROR => {
            core.geometry_values(w, 0.0)?;
            let mut mirror = [false; 3];
            for axis in w.axes.iter() {
                if let Some(place) = mirror.get_mut(axis.index()) {
                    *place = true;
                }
            }
            FrameValue::mirrored(mirror)
        }
        _ => {
            return core.refuse(span, codes::P9011::turns_plane_by_solid_angles(&code.word()));
        }
    })
}

fn shifts(core: &Core<'_>, mm: f64, w: &Words) -> Outcome<Vec<(Axis, f64)>> {
    let mut values = Vec::new();
    for axis in w.axes.iter() {
        let Some(given) = w.axis(axis) else { continue };
        given.counts_in_frame(core)?;
        let unit = if axis.is_rotary() { 1.0 } else { mm };
        values.push((axis, given.value * unit));
    }
    Ok(values)
}

impl Given {
    /// AC and IC have no meaning in frames and poles, and no effect; a diameter or a sense of rotation would have one.
    pub(super) fn counts_in_frame(self, core: &Core<'_>) -> Outcome {
        match self.mode {
            Mode::Plain | Mode::Ac | Mode::Ic => Ok(()),
            _ => core.refuse(self.span, misplaced_modifier()),
        }
    }
}

impl Core<'_> {
    fn geometry_values(&self, w: &Words, neutral: f64) -> Outcome<[f64; 3]> {
        let mut values = [neutral; 3];
        for axis in w.axes.iter() {
            let Some(given) = w.axis(axis) else { continue };
            given.counts_in_frame(self)?;
            match values.get_mut(axis.index()) {
                Some(place) => *place = given.value,
                None => {
                    return self.refuse(given.span, codes::S2031::is_no_geometry_axis(&axis.letter()));
                }
            }
        }
        Ok(values)
    }
}
