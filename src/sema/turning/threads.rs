//! G31, the universal thread cycle: its parameters and their defaults.
//!
//! Source: T 10 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::{Deg, Point2};
use crate::ir::cycle::thread::{Flank, Infeed, ThreadPart};
use crate::ir::cycle::turning::Towards;
use crate::ir::cycle::{Cycle, Thread};
use crate::text::Span;

use super::outline::{Outline, ThreadData};
use super::program_parts::Family;
use super::readings::Question;
use super::thread_line::ThreadLine;
use super::words::{Num, Words};
use super::{Outcome, Run};

/// Most air cuts.
const MOST_AIR_CUTS: u32 = 99;
/// Largest infeed angle of the controls, degrees.
const LARGEST_ANGLE: f64 = 60.0;

impl Run<'_> {
    pub(super) fn thread_cycle(&mut self, w: &Words, outline: Option<&Outline>) -> Outcome {
        let at = self.stand()?;
        let span = self.block_span();
        self.spindle_turns(31)?;
        let data = self.thread_data(w, outline)?;
        let lead = match (w.get(b'F'), data) {
            (None, Some(data)) => data.pitch,
            _ => {
                let pitch = self.needed(w, b'F', "the pitch of the thread", span)?;
                self.above_zero(pitch, "the pitch of the thread")?
            }
        };
        if let Some(num) = w.get(b'O').filter(|num| num.value != 0.0) {
            return self.refuse(num.span, codes::T9007::o_of_thread_is_not_supported(&num.value));
        }
        let line = self.thread_line(w, outline, at, lead)?;
        let (into, depth) = self.thread_depth(w, &line, at, data)?;
        let (run_in, run_out) = (self.run_way(w, b'B', "run-in", lead)?, self.run_way(w, b'P', "run-out", lead)?);
        let ThreadLine { start, parts, transverse } = line;
        if transverse {
            self.off_centre(start, &parts, run_in, run_out)?;
        } else {
            self.above_centre(start, &parts, into, depth)?;
        }
        let along = |p: Point2| if transverse { p.y } else { p.x };
        let forward = parts.first().is_some_and(|part| along(part.end) < along(start));
        let thread = Thread {
            start,
            parts,
            into,
            depth,
            infeed: self.infeed(w, lead)?,
            flank: self.flank(w, lead, depth, forward)?,
            finish: 0.0,
            air_cuts: self.choice(w, b'Q', 0, MOST_AIR_CUTS)?,
            run_in,
            run_out,
            fixed_end: false,
            starts: 1,
            start_angle: Deg(w.value(b'C').unwrap_or(0.0)),
            retract: into.depth_coordinate(at),
            park: at,
        };
        self.send_cycle(&Cycle::Thread(thread));
        Ok(())
    }

    /// Into which surface the thread is cut, and how deep: told by U, else by G34 or G37 and where the tool stands.
    fn thread_depth(
        &mut self,
        w: &Words,
        line: &ThreadLine,
        at: Point2,
        data: Option<ThreadData>,
    ) -> Outcome<(Towards, f64)> {
        let u = match (w.get(b'U'), data) {
            (None, Some(data)) if line.transverse => return Ok((self.thread_face(w)?, data.depth[0])),
            (None, Some(data)) if at.y > line.start.y => return Ok((Towards::MinusX, data.depth[0])),
            (None, Some(data)) => return Ok((Towards::PlusX, data.depth[1])),
            _ => self.needed(w, b'U', "the depth of the thread, negative for an external one", self.block_span())?,
        };
        if u.value == 0.0 {
            return self.refuse(u.span, codes::T1007::thread_has_no_depth());
        }
        let into = match (line.transverse, u.value > 0.0) {
            (true, true) => {
                return self.refuse(u.span, codes::T1007::thread_runs_across_face());
            }
            (true, false) => self.thread_face(w)?,
            (false, true) => Towards::PlusX,
            (false, false) => Towards::MinusX,
        };
        Ok((into, u.value.abs() * self.st.mm()))
    }

    /// A thread is cut with a turning spindle.
    pub(super) fn spindle_turns(&self, number: u16) -> Outcome {
        if self.st.spindle.turn().is_some() {
            return Ok(());
        }
        self.refuse(self.block_span(), codes::P1004::spindle_does_not_turn_when_g_begins(&number))
    }

    /// The root of the thread lies on this side of the turning centre.
    pub(super) fn above_centre(&self, start: Point2, parts: &[ThreadPart], into: Towards, depth: f64) -> Outcome {
        let least = parts.iter().map(|part| part.end.y).fold(start.y, f64::min);
        let root = if into == Towards::MinusX { least - depth } else { least };
        if root > 0.0 {
            return Ok(());
        }
        self.refuse(
            self.block_span(),
            codes::T1007::thread_at_x_with_depth_of_mm(&(2.0 * least), &depth, &(2.0 * root)),
        )
    }

    /// What G34 or G37 says of the first element of the contour.
    fn thread_data(&self, w: &Words, outline: Option<&Outline>) -> Outcome<Option<ThreadData>> {
        if w.has(b'X') || w.has(b'Z') || (w.has(b'F') && w.has(b'U')) {
            return Ok(None);
        }
        let edges = self.contour_of(w, outline, 0)?.edges;
        let data = edges.iter().find(|edge| !edge.corner && edge.form.is_none()).and_then(|edge| edge.thread);
        if edges.iter().any(|edge| edge.thread.is_some() && edge.thread != data) {
            return self.refuse(self.block_span(), codes::T9007::elements_of_thread_have_different_pitches());
        }
        Ok(data)
    }

    /// V, I and IC: how the depth is divided.
    fn infeed(&mut self, w: &Words, lead: f64) -> Outcome<Infeed> {
        let span = self.block_span();
        let kind = self.choice(w, b'V', 0, 6)?;
        let din_plus = self.sections.family() == Family::DinPlus;
        if let Some(cuts) = w.long("IC") {
            if let Some(num) = w.get(b'I') {
                return self.refuse(num.span, codes::P1005::i_gives_infeed());
            }
            return self.infeed_by_count(cuts, kind);
        }
        let most = match w.get(b'I') {
            Some(num) => self.above_zero(num, "the greatest infeed")?,
            None if din_plus && kind == 0 => lead / 3.0,
            None => {
                return self.fail_help(
                    codes::P1004,
                    span,
                    match kind {
                        2 | 3 => format!(
                            "I is missing: under V{kind} the control computes the greatest infeed from the speed and the pitch F, by \
                             a formula that no manual at hand prints"
                        ),
                        _ => "I is missing: the greatest infeed".to_owned(),
                    },
                    "program I with the greatest infeed, on the radius",
                );
            }
        };
        let word = w.span(b'V', span);
        match kind {
            0 => Ok(Infeed::ConstantArea { first: most }),
            1 => Ok(Infeed::Equal { most }),
            2 => Ok(Infeed::RemainderSplit { most }),
            3 if !din_plus || self.job.settings.control.heidenhain_turning == "manualplus620" => {
                Ok(Infeed::Remainder { most })
            }
            3 => self.refuse(
                word,
                codes::T9007::v3_divides_depth_on_manualplus().answer(Answer::key("control", "heidenhain_turning")),
            ),
            _ => self.refuse(word, codes::T9007::how_v_divides_depth_no_manual(&kind)),
        }
    }

    fn infeed_by_count(&mut self, cuts: Num, kind: u32) -> Outcome<Infeed> {
        let passes = cuts.value;
        if passes.fract() != 0.0 || !(1.0..=1000.0).contains(&passes) {
            return self.refuse(cuts.span, codes::T1007::ic_is_number_of_cuts());
        }
        let passes = passes as u32;
        match kind {
            0 => Ok(Infeed::AreaPasses { passes }),
            1 => Ok(Infeed::EqualPasses { passes }),
            _ => self.refuse(cuts.span, codes::P1003::ic_belongs_to_v0()),
        }
    }

    /// H and A: where the cuts above the last one lie. `forward`: the thread is cut towards -Z.
    fn flank(&mut self, w: &Words, lead: f64, depth: f64, forward: bool) -> Outcome<Flank> {
        let angle = match w.get(b'A') {
            Some(num) if num.value > 0.0 && num.value < LARGEST_ANGLE => Deg(num.value),
            Some(num) => {
                return self.refuse(num.span, codes::T1007::does_not_lie_between_0(&num.value));
            }
            None if self.sections.family() == Family::DinPlus => Deg(30.0),
            // Half a pitch at depth 0.
            None => Deg::from_radians(libm::atan(0.5 * lead / depth)),
        };
        let kind = self.choice(w, b'H', 0, 3)?;
        if kind != 0 {
            self.depends_on(Question::ThreadLeft, w.span(b'H', self.block_span()));
        }
        // Left is the side of -Z, as far as any text says.
        let forward = forward != (self.job.settings.control.turning.left_is_plus == Some(true));
        Ok(match (kind, forward) {
            (0, _) => Flank::Radial,
            (1, true) | (2, false) => Flank::Ahead { angle },
            (1, false) | (2, true) => Flank::Behind { angle },
            (_, true) => Flank::Alternating { angle },
            (_, false) => {
                return self.refuse(
                    w.span(b'H', self.block_span()),
                    codes::T9007::alternating_flanks_that_begin_on_other_side(),
                );
            }
        })
    }

    /// B and P: what a missing one is follows from the speed.
    fn run_way(&mut self, w: &Words, letter: u8, what: &str, lead: f64) -> Outcome<f64> {
        if let Some(num) = w.get(letter) {
            if num.value < 0.0 {
                return self.refuse(num.span, codes::T1007::is_not_negative_3(&what));
            }
            return Ok(num.value * self.st.mm());
        }
        let turns = self.st.spindle.turns();
        let turns = turns.map(|turns| self.st.spindle.limited(turns));
        match turns.filter(|_| self.sections.family() == Family::Basic) {
            Some(turns) => Ok(lead * turns / 1000.0),
            None => self.run_way_missing(letter, what),
        }
    }

    #[cold]
    fn run_way_missing(&self, letter: u8, what: &str) -> Outcome<f64> {
        let span: Span = self.block_span();
        self.refuse(span, codes::P1004::is_missing_so_control_computes(&(letter as char), &what))
    }
}
