//! G31, the universal thread cycle: its parameters and their defaults.
//!
//! Source: reference section 10, worked examples 1 to 5 and 14.

use crate::diag::codes;
use crate::geo::{Deg, Element, Point2};
use crate::ir::cycle::thread::{Flank, Infeed, MOST_PARTS, ThreadPart};
use crate::ir::cycle::turning::Towards;
use crate::ir::cycle::{Cycle, Thread};
use crate::machine::Axis;
use crate::text::Span;

use super::chain::Coord;
use super::contour::{Outline, ThreadData};
use super::sections::Family;
use super::state::SpeedMode;
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
        for letter in [b'O', b'J'] {
            if let Some(num) = w.get(letter).filter(|num| num.value != 0.0) {
                let message = format!("{}{} of a thread is not supported", letter as char, num.value);
                return self.fail_help(
                    codes::T9007,
                    num.span,
                    message,
                    "leave the word out, and write the contour as it is to be cut",
                );
            }
        }
        let (start, parts) = self.thread_line(w, outline, at, lead)?;
        let (into, depth) = match (w.get(b'U'), data) {
            (None, Some(data)) if at.y > start.y => (Towards::MinusX, data.depth[0]),
            (None, Some(data)) => (Towards::PlusX, data.depth[1]),
            _ => {
                let u = self.needed(w, b'U', "the depth of the thread, negative for an external one", span)?;
                let into = if u.value > 0.0 { Towards::PlusX } else { Towards::MinusX };
                if u.value == 0.0 {
                    return self.fail(codes::T1007, u.span, "the thread has no depth");
                }
                (into, u.value.abs() * self.st.mm())
            }
        };
        self.above_centre(start, &parts, into, depth)?;
        let forward = parts.first().is_some_and(|part| part.end.x < start.x);
        let thread = Thread {
            start,
            parts,
            into,
            depth,
            infeed: self.infeed(w, lead)?,
            flank: self.flank(w, lead, depth, forward)?,
            finish: 0.0,
            air_cuts: self.choice(w, b'Q', 0, MOST_AIR_CUTS)?,
            run_in: self.run_way(w, b'B', "run-in", lead)?,
            run_out: self.run_way(w, b'P', "run-out", lead)?,
            fixed_end: false,
            starts: 1,
            start_angle: Deg(w.value(b'C').unwrap_or(0.0)),
            retract: at.y,
            park: at,
        };
        self.send_cycle(&Cycle::Thread(thread));
        Ok(())
    }

    /// A thread is cut with a turning spindle.
    pub(super) fn spindle_turns(&self, number: u16) -> Outcome {
        if self.st.spindle.is_some() {
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
        let data = edges.iter().find(|edge| !edge.corner && !edge.form).and_then(|edge| edge.thread);
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

    /// Start and parts of the thread: from the tool to X and Z, or along a contour.
    fn thread_line(
        &mut self,
        w: &Words,
        outline: Option<&Outline>,
        at: Point2,
        lead: f64,
    ) -> Outcome<(Point2, Vec<ThreadPart>)> {
        let span = self.block_span();
        let (x, z) = (w.get(b'X'), w.get(b'Z'));
        let taper = w.get(b'R');
        if x.is_none() && z.is_none() {
            if let Some(num) = taper.filter(|num| num.value != 0.0) {
                return self.fail(
                    codes::T1003,
                    num.span,
                    "R has no meaning beside a contour, which says where the thread leads",
                );
            }
            return self.thread_contour(w, outline, lead);
        }
        if outline.is_some() || w.long("NS").is_some() || self.named.is_some() {
            return self.fail(codes::T1006, span, "the thread has an end point and a contour: only one can hold");
        }
        let (Some(_), Some(_)) = (x, z) else {
            return self.fail_help(
                codes::T1005,
                span,
                "a thread needs both X and Z of its end",
                "X is the diameter at the end; transverse threads are not supported",
            );
        };
        let ordinate = |coord: Coord, from: f64| match coord {
            Coord::At(v) => Some(v),
            Coord::By(d) => Some(from + d),
            Coord::Missing | Coord::Unknown => None,
        };
        let (x, z) = (self.coord(x, Axis::X), self.coord(z, Axis::Z));
        let (Some(x), Some(z)) = (ordinate(x, at.y), ordinate(z, at.x)) else {
            return self.fail(codes::T1005, span, "the end of a thread cannot be left open");
        };
        let rise = taper.map_or(0.0, |num| num.value * self.st.mm());
        Ok((Point2::new(at.x, x - rise), vec![ThreadPart { end: Point2::new(z, x), lead }]))
    }

    fn thread_contour(
        &mut self,
        w: &Words,
        outline: Option<&Outline>,
        lead: f64,
    ) -> Outcome<(Point2, Vec<ThreadPart>)> {
        let edges = self.contour_of(w, outline, 0)?.edges;
        // The thread lies on the basic elements; chamfers and undercuts are not cut.
        let elements: Vec<Element> =
            edges.iter().filter(|edge| !edge.corner && !edge.form).map(|edge| edge.element).collect();
        let span = self.block_span();
        if elements.len() > MOST_PARTS {
            let message = format!("the contour of a thread has {} elements, more than {MOST_PARTS}", elements.len());
            return self.fail(codes::T3003, span, message);
        }
        let mut parts: Vec<ThreadPart> = Vec::new();
        let mut start: Option<Point2> = None;
        for element in elements {
            let Element::Line { from, to } = element else {
                return self.fail(codes::T3003, span, "a thread is cut along straight elements only");
            };
            if (to.y - from.y).abs() > (to.x - from.x).abs() + 1e-3 {
                return self.fail_help(
                    codes::T9007,
                    span,
                    "a transverse thread is not supported: to which side its depth counts no manual at hand says",
                    "cut it with G33 blocks",
                );
            }
            let gap = parts
                .last()
                .map(|part: &ThreadPart| part.end)
                .is_some_and(|end| crate::geo::distance(end, from) > 1e-6);
            if gap {
                return self.fail(codes::T3003, span, "a chamfer, rounding or undercut interrupts the thread");
            }
            start.get_or_insert(from);
            parts.push(ThreadPart { end: to, lead });
        }
        match start {
            Some(start) => Ok((start, parts)),
            None => self.fail(codes::T3003, span, "the contour of the thread has no element"),
        }
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
                    "I is missing: the greatest infeed",
                    "the control takes it from pitch and speed by a rule that no manual at hand gives: program I",
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
                "set `[control] heidenhain_turning = \"manualplus620\"` in partc.toml, or program V0, V1 or V2",
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
        // Left is the side of -Z, as far as any text says.
        let forward = forward != self.job.settings.control.turning.left_is_plus;
        Ok(match (self.choice(w, b'H', 0, 3)?, forward) {
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
        let turns = self.st.speed.filter(|_| self.st.speed_mode == Some(SpeedMode::Revolutions));
        let turns = turns.map(|speed| self.st.speed_limit.map_or(speed, |limit| speed.min(limit)));
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
