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
            return self.fail_help(
                codes::T9007,
                num.span,
                format!("O{} of a thread is not supported", num.value),
                "leave the word out, and write the contour as it is to be cut",
            );
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
            return self.fail(codes::T1007, u.span, "the thread has no depth");
        }
        let into = match (line.transverse, u.value > 0.0) {
            (true, true) => {
                return self.fail_help(
                    codes::T1007,
                    u.span,
                    "the thread runs across a face, and U above 0 is the depth of a thread in a bore",
                    "program U with a minus sign",
                );
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
        self.fail_help(
            codes::T1005,
            self.block_span(),
            format!("the spindle does not turn when G{number} begins, so the thread has no pitch"),
            format!("program M3 or M4 before G{number}"),
        )
    }

    /// The root of the thread lies on this side of the turning centre.
    pub(super) fn above_centre(&self, start: Point2, parts: &[ThreadPart], into: Towards, depth: f64) -> Outcome {
        let least = parts.iter().map(|part| part.end.y).fold(start.y, f64::min);
        let root = if into == Towards::MinusX { least - depth } else { least };
        if root > 0.0 {
            return Ok(());
        }
        self.fail_help(
            codes::T1007,
            self.block_span(),
            format!(
                "the thread at X{} with a depth of {depth} mm reaches the turning centre: its root lies at X{}",
                2.0 * least,
                2.0 * root
            ),
            "check the diameter and the depth, which counts as a radius",
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
            return self.fail_help(
                codes::T9007,
                self.block_span(),
                "the elements of the thread have different pitches or depths",
                "program F and U for all of it, or a cycle for each element",
            );
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
                return self.fail_help(
                    codes::T1006,
                    num.span,
                    "I gives the infeed and IC the number of cuts: only one of the two can hold",
                    "leave one of the two out",
                );
            }
            return self.infeed_by_count(cuts, kind);
        }
        let most = match w.get(b'I') {
            Some(num) => self.above_zero(num, "the greatest infeed")?,
            None if din_plus && kind == 0 => lead / 3.0,
            None => {
                return self.fail_help(
                    codes::T1005,
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
            3 => self.fail_help(
                codes::T9007,
                word,
                "V3 divides the depth on the MANUALplus and follows pitch and speed on the CNC PILOT 4290",
                Answer::key("control", "heidenhain_turning").help(
                    "set `[control] heidenhain_turning = \"manualplus620\"` in partc.toml, or program V0, V1 or V2",
                ),
            ),
            _ => self.fail_help(
                codes::T9007,
                word,
                format!("how V{kind} divides the depth no manual at hand says"),
                "program V0, V1, V2 or V3",
            ),
        }
    }

    fn infeed_by_count(&mut self, cuts: Num, kind: u32) -> Outcome<Infeed> {
        let passes = cuts.value;
        if passes.fract() != 0.0 || !(1.0..=1000.0).contains(&passes) {
            return self.fail(codes::T1007, cuts.span, "IC is a number of cuts");
        }
        let passes = passes as u32;
        match kind {
            0 => Ok(Infeed::AreaPasses { passes }),
            1 => Ok(Infeed::EqualPasses { passes }),
            _ => self.fail(codes::T1003, cuts.span, "IC belongs to V0 and V1"),
        }
    }

    /// H and A: where the cuts above the last one lie. `forward`: the thread is cut towards -Z.
    fn flank(&mut self, w: &Words, lead: f64, depth: f64, forward: bool) -> Outcome<Flank> {
        let angle = match w.get(b'A') {
            Some(num) if num.value > 0.0 && num.value < LARGEST_ANGLE => Deg(num.value),
            Some(num) => {
                return self.fail(
                    codes::T1007,
                    num.span,
                    format!("A{} does not lie between 0 and 60 degrees", num.value),
                );
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
                return self.fail_help(
                    codes::T9007,
                    w.span(b'H', self.block_span()),
                    "alternating flanks that begin on the other side (a thread towards +Z) are not supported",
                    "program H0, H1 or H2",
                );
            }
        })
    }

    /// B and P: what a missing one is follows from the speed.
    fn run_way(&mut self, w: &Words, letter: u8, what: &str, lead: f64) -> Outcome<f64> {
        if let Some(num) = w.get(letter) {
            if num.value < 0.0 {
                return self.fail(codes::T1007, num.span, format!("the {what} is not negative"));
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
        self.fail_help(
            codes::T1005,
            span,
            format!("{} is missing: the {what}", letter as char),
            "the control computes it from the speed, which is not fixed here: program it, or G97 S… before the cycle",
        )
    }
}
