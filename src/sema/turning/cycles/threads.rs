//! G31, the universal thread cycle: its parameters and their defaults.
//!
//! Source: T 10 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::{Deg, Point2};
use crate::ir::cycle::thread::{Flank, Infeed, ThreadPart};
use crate::ir::cycle::turning::Towards;
use crate::ir::cycle::{Cycle, Thread};
use crate::sema::cycle::call::Made;
use crate::sema::cycle::row::{Name, Rule, angle, count, length, number};

use super::super::outline::ThreadData;
use super::super::program_parts::Family;
use super::super::readings::Question;
use super::thread_line::ThreadLine;
use super::{
    CORNER_X, CORNER_Z, Contour, CycleCall, ID, MOST_AIR_CUTS, NE, NS, Need, Planned, Row, Unbuilt, one, word,
};

/// Largest infeed angle of the controls, degrees.
const LARGEST_ANGLE: f64 = 60.0;

pub(super) const ROWS: &[Row] = &[Row::new(
    31,
    "G31",
    "thread cycle",
    "4110P, p. 74; 4110, p. 336; MANUALplus 620, p. 272",
    &[
        NS,
        NE,
        ID,
        CORNER_X,
        CORNER_Z,
        length("F", "pitch").rule(Rule::Above(0)).default("that of the contour"),
        length("U", "depth on the radius: above 0 internal").default("that of the contour"),
        length("I", "greatest infeed").rule(Rule::Above(0)),
        count("IC", "number of cuts, in place of I").rule(Rule::OneOf(1, 1000)),
        length("R", "difference of the radii of end and start").default("0"),
        length("B", "run-in").unsigned().default("F by turns a minute by 1000"),
        length("P", "run-out").unsigned().default("F by turns a minute by 1000"),
        angle("A", "infeed angle").default("half the pitch at the first cut, 30 degrees in DIN PLUS"),
        number("V", "series of the depths").rule(Rule::OneOf(0, 6)).default("0"),
        number("H", "infeed 0 radial, 1 left, 2 right, 3 by turns").rule(Rule::OneOf(0, 3)).default("0"),
        count("Q", "cuts at full depth").rule(Rule::OneOf(0, MOST_AIR_CUTS)).default("0"),
        angle("C", "start angle").default("0"),
        number("O", "ends of the contour; refused where it is not 0").default("0"),
        number("J", "0 along Z, 1 across").rule(Rule::OneOf(0, 1)).default("by the line"),
    ],
    |call| call.thread(),
)
.contour(Contour::LineOrReferenced)
.unbuilt(&[Unbuilt::not_zero(word::O, |it| codes::T9007::o_of_thread_is_not_supported(&it.value))])
.requires(&[Need::Spindle])];

impl CycleCall<'_> {
    fn thread(&self) -> Planned {
        let at = self.st.at;
        let data = self.thread_data()?;
        let lead = match (self.given.length_if(word::F), data) {
            (Some(lead), _) => lead,
            (None, Some(data)) => data.pitch,
            (None, None) => return self.refuse(codes::P1004::is_missing(&word::F, &"the pitch of the thread")),
        };
        let line = self.thread_line(lead)?;
        let (into, depth) = self.thread_depth(&line, data)?;
        let run_in = self.run_way(word::B, "run-in", lead)?;
        let run_out = self.run_way(word::P, "run-out", lead)?;
        let ThreadLine { start, parts, transverse } = line;
        if transverse {
            self.off_centre(start, &parts, run_in, run_out)?;
        } else {
            self.above_centre(start, &parts, into, depth)?;
        }
        let along = |p: Point2| if transverse { p.y } else { p.x };
        let forward = parts.first().is_some_and(|part| along(part.end) < along(start));
        one(Cycle::Thread(Thread {
            start,
            parts,
            into,
            depth,
            infeed: self.infeed(lead)?,
            flank: self.flank(lead, depth, forward)?,
            finish: 0.0,
            air_cuts: self.given.whole(word::Q).unsigned_abs(),
            run_in,
            run_out,
            fixed_end: false,
            starts: 1,
            start_angle: Deg(self.given.or_zero(word::C)),
            retract: into.depth_coordinate(at),
            park: at,
        }))
    }

    /// Into which surface the thread is cut, and how deep: told by U, else by G34 or G37 and where the tool stands.
    fn thread_depth(&self, line: &ThreadLine, data: Option<ThreadData>) -> Made<(Towards, f64)> {
        let u = match (self.given.length_if(word::U), data) {
            (Some(u), _) => u,
            (None, Some(data)) if line.transverse => return Ok((self.thread_face()?, data.depth[0])),
            (None, Some(data)) if self.st.at.y > line.start.y => return Ok((Towards::MinusX, data.depth[0])),
            (None, Some(data)) => return Ok((Towards::PlusX, data.depth[1])),
            (None, None) => {
                let what = "the depth of the thread, negative for an external one";
                return self.refuse(codes::P1004::is_missing(&word::U, &what));
            }
        };
        if u == 0.0 {
            return self.refuse_argument(word::U, codes::T1007::thread_has_no_depth());
        }
        let into = match (line.transverse, u > 0.0) {
            (true, true) => return self.refuse_argument(word::U, codes::T1007::thread_runs_across_face()),
            (true, false) => self.thread_face()?,
            (false, true) => Towards::PlusX,
            (false, false) => Towards::MinusX,
        };
        Ok((into, u.abs()))
    }

    /// The root of the thread lies on this side of the turning centre.
    pub(super) fn above_centre(&self, start: Point2, parts: &[ThreadPart], into: Towards, depth: f64) -> Made {
        let least = parts.iter().map(|part| part.end.y).fold(start.y, f64::min);
        let root = if into == Towards::MinusX { least - depth } else { least };
        if root > 0.0 {
            return Ok(());
        }
        self.refuse(codes::T1007::thread_at_x_with_depth_of_mm(&(2.0 * least), &depth, &(2.0 * root)))
    }

    /// What G34 or G37 says of the first element of the contour.
    fn thread_data(&self) -> Made<Option<ThreadData>> {
        let Some(section) = &self.st.contour else { return Ok(None) };
        if self.given.has(word::F) && self.given.has(word::U) {
            return Ok(None);
        }
        let edges = &section.edges;
        let data = edges.iter().find(|edge| !edge.corner && edge.form.is_none()).and_then(|edge| edge.thread);
        if edges.iter().any(|edge| edge.thread.is_some() && edge.thread != data) {
            return self.refuse(codes::T9007::elements_of_thread_have_different_pitches());
        }
        Ok(data)
    }

    /// V, I and IC: how the depth is divided.
    fn infeed(&self, lead: f64) -> Made<Infeed> {
        let kind = self.given.whole(word::V);
        let din_plus = self.st.family == Family::DinPlus;
        if self.given.has(word::IC) {
            if self.given.has(word::I) {
                return self.refuse_argument(word::I, codes::P1005::i_gives_infeed());
            }
            return self.infeed_by_count(kind);
        }
        let most = match self.given.length_if(word::I) {
            Some(most) => most,
            None if din_plus && kind == 0 => lead / 3.0,
            None if matches!(kind, 2 | 3) => return self.refuse(codes::P1004::i_is_missing_under_v(&kind)),
            None => return self.refuse(codes::P1004::i_is_missing()),
        };
        match kind {
            0 => Ok(Infeed::ConstantArea { first: most }),
            1 => Ok(Infeed::Equal { most }),
            2 => Ok(Infeed::RemainderSplit { most }),
            3 if !din_plus || self.settings.control.heidenhain_turning == "manualplus620" => {
                Ok(Infeed::Remainder { most })
            }
            3 => {
                let fault = codes::T9007::v3_divides_depth_on_manualplus();
                self.refuse_argument(word::V, fault.answer(Answer::key("control", "heidenhain_turning")))
            }
            _ => self.refuse_argument(word::V, codes::T9007::how_v_divides_depth_no_manual(&kind)),
        }
    }

    fn infeed_by_count(&self, kind: i32) -> Made<Infeed> {
        let passes = self.given.whole(word::IC).unsigned_abs();
        match kind {
            0 => Ok(Infeed::AreaPasses { passes }),
            1 => Ok(Infeed::EqualPasses { passes }),
            _ => self.refuse_argument(word::IC, codes::P1003::ic_belongs_to_v0()),
        }
    }

    /// H and A: where the cuts above the last one lie. `forward`: the thread is cut towards -Z.
    fn flank(&self, lead: f64, depth: f64, forward: bool) -> Made<Flank> {
        let angle = match self.given.number(word::A) {
            Some(angle) if angle > 0.0 && angle < LARGEST_ANGLE => Deg(angle),
            Some(angle) => return self.refuse_argument(word::A, codes::T1007::does_not_lie_between_0(&angle)),
            None if self.st.family == Family::DinPlus => Deg(30.0),
            // Half a pitch at depth 0.
            None => Deg::from_radians(libm::atan(0.5 * lead / depth)),
        };
        let kind = self.given.whole(word::H);
        if kind != 0 {
            self.depends_on(Question::ThreadLeft, self.given.place_of(word::H));
        }
        // Left is the side of -Z, as far as any text says.
        let forward = forward != (self.settings.control.turning.left_is_plus == Some(true));
        Ok(match (kind, forward) {
            (0, _) => Flank::Radial,
            (1, true) | (2, false) => Flank::Ahead { angle },
            (1, false) | (2, true) => Flank::Behind { angle },
            (_, true) => Flank::Alternating { angle },
            (_, false) => {
                let fault = codes::T9007::alternating_flanks_that_begin_on_other_side();
                return self.refuse_argument(word::H, fault);
            }
        })
    }

    /// B and P: what a missing one is follows from the speed.
    fn run_way(&self, name: Name, what: &str, lead: f64) -> Made<f64> {
        if let Some(way) = self.given.length_if(name) {
            return Ok(way);
        }
        let spindle = &self.st.modal.spindle;
        let turns = spindle.speed_in_turns().map(|turns| spindle.limited(turns));
        match turns.filter(|_| self.st.family == Family::Basic) {
            Some(turns) => Ok(lead * turns / 1000.0),
            None => self.refuse(codes::P1004::is_missing_so_control_computes(&name, &what)),
        }
    }
}
