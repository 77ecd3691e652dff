//! Where a block leads: its axis words as absolute positions in millimetres and radii.
//!
//! Source: S 2.1 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::ir::Pos;
use crate::machine::Axis;
use crate::text::Span;

use super::diameter::Diameter;
use super::g_groups::GCode;
use super::words::{Given, Mode, Words, misfit};
use super::{Core, Outcome, Reported, State};

impl State {
    /// The programmed end points of all axes of the block.
    #[inline]
    pub(super) fn targets(&mut self, core: &Core<'_>, w: &Words) -> Outcome<Pos> {
        let mut end = Pos::UNKNOWN;
        for axis in w.axes.iter() {
            if let Some(given) = w.axis(axis) {
                let value = self.target(core, axis, given)?;
                end.set(axis, value);
            }
        }
        Ok(end)
    }

    /// The end point of one axis in mm (radius) or degrees.
    #[inline]
    pub(super) fn target(&mut self, core: &Core<'_>, axis: Axis, given: Given) -> Outcome<f64> {
        let rotary = axis.is_rotary();
        let incremental = match given.mode {
            Mode::Plain if self.is(GCode::G91) => true,
            Mode::Ic => true,
            _ if rotary => return self.rotary_target(core, axis, given),
            Mode::Plain | Mode::Ac | Mode::Dac | Mode::Rac => false,
            Mode::Dic | Mode::Ric => true,
            Mode::Dc | Mode::Acp | Mode::Acn => {
                let alarm = match given.mode {
                    Mode::Dc => 16800,
                    Mode::Acp => 16810,
                    _ => 16820,
                };
                return core.refuse(given.span, codes::S2061::is_no_rotary_axis(&axis.letter()).alarm(alarm));
            }
            Mode::Quick | Mode::PerMinute | Mode::PerTurn => return core.refuse(given.span, misfit()),
        };
        let value = if rotary { given.value } else { self.length(core, axis, given, incremental)? };
        if incremental { Ok(self.increment_base(core, axis, given.span)? + value) } else { Ok(value) }
    }

    /// A length along an axis as a radius in mm.
    #[inline]
    pub(super) fn length(&self, core: &Core<'_>, axis: Axis, given: Given, incremental: bool) -> Outcome<f64> {
        let value = given.value * self.length_unit();
        let diameter = match given.mode {
            Mode::Dac | Mode::Dic | Mode::Rac | Mode::Ric => {
                if !core.is_diameter_axis(axis) {
                    return core.no_diameter_axis(given.span);
                }
                matches!(given.mode, Mode::Dac | Mode::Dic)
            }
            _ if !core.is_diameter_axis(axis) => false,
            _ => match self.diameter_mode() {
                Diameter::Off => false,
                Diameter::On => true,
                Diameter::Absolute => !incremental,
            },
        };
        Ok(if diameter { value / 2.0 } else { value })
    }

    /// What an increment counts from: the value last programmed, or where the axis stands (SD 42440).
    pub(super) fn increment_base(&mut self, core: &Core<'_>, axis: Axis, span: Span) -> Outcome<f64> {
        if self.position.is_lost(axis) {
            return Err(Reported);
        }
        let Some(at) = self.position.get(axis) else { return self.unknown_axis(core, axis, span) };
        let programmed = self.position.programmed(axis).unwrap_or(at);
        if (programmed - at).abs() <= 1e-9 {
            return Ok(at);
        }
        let with_offset = match self.system.get("$SC_FRAME_OFFSET_INCR_PROG").and_then(super::value::Val::truth) {
            Some(set) => set,
            None => core.job.settings.control.sinumerik.frame_offset_incremental.unwrap_or(true),
        };
        let chosen = if with_offset { programmed } else { at };
        if core.job.settings.control.sinumerik.frame_offset_incremental.is_some() {
            return Ok(chosen);
        }
        let found = codes::S8007::increment_of_follows_change_of_frame(&axis.letter()).at(core.loc(span));
        let how = if with_offset {
            "the frame is travelled, too (SD 42440 = 1)"
        } else {
            "only the increment is travelled (SD 42440 = 0)"
        };
        core.report(found.here(how).help(
            Answer::key("control", "sd42440").help("set `[control] sd42440`, or program the position absolutely"),
        ));
        Ok(chosen)
    }
}
