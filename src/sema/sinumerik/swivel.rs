//! `CYCLE800`: a swivelled plane that is none. Without angles it shifts the workpiece, and may retract the tool.
//!
//! Source: S 4.9 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::ir::contour::{Coords, Move, Path};
use crate::ir::{Pos, Side};
use crate::machine::{Axis, AxisSet};
use crate::text::Span;

use super::frames::FrameValue;
use super::value::whole;
use super::{Channel, Outcome};

/// Places of the arguments, from 0.
const RETRACTION: usize = 0;
const STATE: usize = 2;
const MODE: usize = 3;
const BEFORE: usize = 4;
const ANGLES: usize = 7;
const AFTER: usize = 10;
const DIRECTION: usize = 13;
const RETRACTION_WAY: usize = 14;
const MODE_OF_SCREEN: usize = 15;

/// The name of the swivel record.
pub(super) const RECORD: usize = 1;
/// Most arguments.
pub(super) const MOST: usize = 16;

/// What the call gives.
#[derive(Debug, Default)]
struct Swivel {
    /// `_FR`
    retraction: f64,
    /// `_FR_I`
    way: f64,
    /// Nothing but a retraction is given: back to the plane that is not swivelled.
    resets: bool,
    /// The shift adds to the one of the call before.
    additive: bool,
    /// `_X0 + _X1` and its kin, in mm.
    shift: [f64; 3],
}

impl Channel<'_> {
    /// An argument alone: an angle, or a code of which somebody knows what it turns.
    pub(super) fn swivel_argument(&mut self, at: usize, value: f64, span: Span) -> Outcome {
        if (ANGLES..AFTER).contains(&at) && value != 0.0 {
            self.st.position.lose(AxisSet::ALL);
            self.lost();
            let name = ["_A", "_B", "_C"].get(at - ANGLES).copied().unwrap_or_default();
            return self.core.refuse(span, codes::S9006::cycle800_swivels_working_plane(&name, &value, &(at + 1)));
        }
        let code = whole(value);
        let (name, known, wanted) = match at {
            STATE => (
                "_ST",
                code.is_some_and(|code| code >= 0 && code % 10 < 2),
                "units 0 for a new plane or 1 for an additive one",
            ),
            MODE => ("_MODE", code.is_some_and(|code| (0..256).contains(&code)), "a code up to 255"),
            DIRECTION => ("_DIR", code.is_some_and(|code| (-2..3).contains(&code)), "-1 or 1, or 0"),
            MODE_OF_SCREEN => ("_DMODE", code.is_some_and(|code| (0..100_000_000).contains(&code)), "a whole number"),
            _ => return Ok(()),
        };
        if known {
            return Ok(());
        }
        self.st.position.lose(AxisSet::ALL);
        self.lost();
        self.core.refuse(span, codes::S9006::cycle800_has_no(&value, &name, &(at + 1), &wanted))
    }

    /// `CYCLE800(…)` without angles; `resets` where it has no argument but the retraction.
    pub(super) fn swivel_by_nothing(&mut self, values: &[f64; MOST], resets: bool, span: Span) -> Outcome {
        let unit = self.st.length_unit();
        let swivel = &Swivel {
            retraction: values[RETRACTION],
            way: values[RETRACTION_WAY] * unit,
            resets,
            additive: whole(values[STATE]).is_some_and(|state| state % 10 == 1),
            shift: [0, 1, 2].map(|axis| (values[BEFORE + axis] + values[AFTER + axis]) * unit),
        };
        let turned = Axis::ALL.into_iter().filter(|axis| axis.is_rotary());
        if let Some(axis) = turned.into_iter().find(|axis| self.st.position.get(*axis).is_some_and(|at| at != 0.0)) {
            return self.core.refuse(span, codes::S9006::cycle800_may_turn_back_to_0(&axis.letter()));
        }
        self.shift_is_clear(swivel, span)?;
        self.swivel_retracts(swivel, span)?;
        self.pending_must_be_done(span)?;
        let added = FrameValue::shifted(&[Axis::X, Axis::Y, Axis::Z].map(|axis| (axis, swivel.shift[axis.index()])));
        let shift = if swivel.additive { self.st.frames.swivelled().chain(&added) } else { added };
        let [x, y, z] = [0, 1, 2].map(|axis| shift.shift[axis]);
        let fault = if shift != FrameValue::default() {
            codes::S8029::turns_nothing_and_shifts(&x, &y, &z)
        } else if swivel.retraction == 0.0 {
            codes::S8029::turns_nothing_and_is_left_out()
        } else {
            codes::S8029::turns_nothing_and_only_retracts()
        };
        self.core.say_once(span, fault);
        self.shift_workpiece(shift);
        Ok(())
    }

    /// `CYCLE800()`: back to the plane that is not swivelled.
    pub(super) fn swivel_off(&mut self, span: Span) {
        self.shift_workpiece(FrameValue::default());
        self.core.say_once(span, codes::S8103::words_that_only_steer_control());
    }

    fn shift_workpiece(&mut self, shift: FrameValue) {
        self.st.frames.set_swivelled(shift);
        self.st.refresh_frame(&self.core);
    }

    /// A shift stands outside of the programmable frame, which a new plane deletes on the control.
    fn shift_is_clear(&mut self, swivel: &Swivel, span: Span) -> Outcome {
        let shifts = swivel.shift != [0.0; 3] || *self.st.frames.swivelled() != FrameValue::default();
        if self.st.side() != Side::None && shifts {
            return self.core.refuse(span, codes::S2080::frame_changes_while_radius_compensation());
        }
        let programmed = !swivel.resets && self.st.frames.programmable().map().is_none_or(|frame| !frame.is_identity());
        let lathe = shifts && self.st.machine.lathe;
        if !programmed && !lathe {
            return Ok(());
        }
        self.st.position.lose(AxisSet::ALL);
        self.lost();
        if lathe {
            return self.core.refuse(span, codes::S9006::cycle800_shifts_workpiece());
        }
        self.core.refuse(span, codes::S9006::cycle800_for_new_plane_deletes_programmed_frames())
    }

    /// The retraction in front of swivelling: 0 none, 1 along Z, 2 along Z and then X and Y, 4 as far as possible along
    /// the tool, 5 by a way along the tool.
    fn swivel_retracts(&mut self, swivel: &Swivel, span: Span) -> Outcome {
        let machine = &self.core.job.settings.machine;
        let (steps, points, key): (&[&[Axis]], _, _) = match swivel.retraction {
            0.0 => return Ok(()),
            1.0 => (&[&[Axis::Z]], &machine.swivel_retract, "swivel_retract"),
            2.0 => (&[&[Axis::Z], &[Axis::X, Axis::Y]], &machine.swivel_retract, "swivel_retract"),
            4.0 => (&[&[Axis::Z]], &machine.swivel_retract_most, "swivel_retract_most"),
            5.0 => return self.swivel_retracts_by(swivel.way, span),
            other => {
                return self.core.refuse(span, codes::S9006::cycle800_has_no_retraction(&other));
            }
        };
        let missing: Vec<Axis> = steps.concat().into_iter().filter(|axis| !points.contains_key(axis)).collect();
        if let [first, others @ ..] = &missing[..] {
            self.st.position.lose(AxisSet::ALL);
            self.lost();
            let help = Answer::entry("machine", key, first.letter()).help(format!(
                "give it in machine coordinates: `[machine] {key} = {{ Z = 0.0 }}`; or program the retraction \
                 (SUPA G0 Z…) and 0 as the first argument"
            ));
            let help = others.iter().fold(help, |help, axis| help.and(Answer::entry("machine", key, axis.letter())));
            return self.core.refuse(span, codes::S9006::cycle800_retracts_tool_to_place().help(&help));
        }
        self.retracts_uncompensated(span)?;
        for axes in steps {
            let mut end = Pos::UNKNOWN;
            for axis in *axes {
                end.set(*axis, points[axis]);
            }
            self.machine_rapid(end);
        }
        Ok(())
    }

    fn retracts_uncompensated(&mut self, span: Span) -> Outcome {
        self.pending_must_be_done(span)?;
        if self.st.side() != Side::None {
            return self.core.refuse(span, codes::S2080::cycle800_retracts_under_radius_compensation());
        }
        Ok(())
    }

    /// Along Z by a way.
    fn swivel_retracts_by(&mut self, way: f64, span: Span) -> Outcome {
        self.retracts_uncompensated(span)?;
        if way < 0.0 {
            return self.core.refuse(span, codes::S9006::retraction_fr_i());
        }
        let Some(at) = self.st.position.get(Axis::Z) else { return self.st.unknown_axis(&self.core, Axis::Z, span) };
        let mut end = Pos::UNKNOWN;
        end.set(Axis::Z, at + way);
        self.leaves_touched(end.known(), true)?;
        let mv = Move { end, path: Path::Rapid, side: Side::None, coords: Coords::Frame };
        self.core.send_move(&mv, &self.st.ctx);
        self.st.position.move_to(&end);
        Ok(())
    }
}
