//! Where the thread of a G31 runs: from the tool to an end point, along a contour, across a face.
//!
//! Source: T 10.1 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::{Element, Point2};
use crate::ir::cycle::thread::{MOST_PARTS, ThreadPart};
use crate::ir::cycle::turning::Towards;
use crate::sema::cycle::call::Made;

use super::super::chain::{AGREES, Coord};
use super::super::readings::Question;
use super::{CycleCall, word};

/// What a drawing loses at 45 degrees, mm.
const LEANS: f64 = 1e-3;

/// The thread at depth 0.
pub(super) struct ThreadLine {
    pub start: Point2,
    pub parts: Vec<ThreadPart>,
    /// It runs across a face: its pitch counts along X, its depth along Z.
    pub transverse: bool,
}

impl CycleCall<'_> {
    /// Start and parts of the thread: from the tool to X and Z, or along a contour.
    pub(super) fn thread_line(&self, lead: f64) -> Made<ThreadLine> {
        let (given, at) = (self.given, self.st.at);
        let across = given.number(word::J).map(|across| across == 1.0);
        let rise = given.length(word::R);
        if !given.has(word::X) && !given.has(word::Z) {
            let line = self.thread_contour(lead, across)?;
            let end = line.parts.last().map_or(line.start, |part| part.end);
            if given.has(word::R) && (end.y - line.start.y - rise).abs() > AGREES {
                let fault = codes::P1005::r_is_not_difference_of_radii(&(end.y - line.start.y));
                return self.refuse_argument(word::R, fault);
            }
            return Ok(line);
        }
        if given.has(word::NS) || given.has(word::ID) {
            return self.refuse(codes::P1005::thread_has_end_point());
        }
        if !given.has(word::X) || !given.has(word::Z) {
            return self.refuse(codes::P1004::thread_needs_both_x());
        }
        let ordinate = |coord: Coord, from: f64| match coord {
            Coord::At(v) => Some(v),
            Coord::By(d) => Some(from + d),
            Coord::Stay | Coord::Open => None,
        };
        let (Some(x), Some(z)) = (ordinate(self.st.x, at.y), ordinate(self.st.z, at.x)) else {
            return self.refuse(codes::P1004::end_of_thread_cannot_be_left_open());
        };
        let end = Point2::new(z, x);
        // Steeper than 45 degrees to Z it runs across a face, and the tool stands clear of that.
        let transverse = across.unwrap_or(rise.abs() > (z - at.x).abs() + LEANS);
        if transverse && rise == 0.0 {
            return self.refuse(codes::P1004::thread_across_face_has_no_r());
        }
        let start = Point2::new(if transverse { z } else { at.x }, x - rise);
        Ok(ThreadLine { start, parts: vec![ThreadPart { end, lead }], transverse })
    }

    fn thread_contour(&self, lead: f64, across: Option<bool>) -> Made<ThreadLine> {
        let edges = &self.contour()?.edges;
        // The thread lies on the basic elements; chamfers and undercuts are not cut.
        let elements: Vec<Element> =
            edges.iter().filter(|edge| !edge.corner && edge.form.is_none()).map(|edge| edge.element).collect();
        if elements.len() > MOST_PARTS {
            return self.refuse(codes::T3003::contour_of_thread_has_elements(&elements.len(), &MOST_PARTS));
        }
        let (Some(first), true) = (elements.first(), elements.iter().all(|e| matches!(e, Element::Line { .. }))) else {
            return self.refuse(codes::T3003::thread_is_cut_along_straight_elements());
        };
        let way = first.to() - first.from();
        let transverse = across.unwrap_or(way.y.abs() > way.x.abs() + LEANS);
        let gap = elements.windows(2).any(|pair| crate::geo::distance(pair[0].to(), pair[1].from()) > 1e-6);
        if gap {
            return self.refuse(codes::T3003::chamfer_rounding_or_undercut_interrupts_thread());
        }
        let start = first.from();
        let parts = elements.iter().map(|element| ThreadPart { end: element.to(), lead }).collect();
        Ok(ThreadLine { start, parts, transverse })
    }

    /// The face that a transverse thread is cut in: the configuration says it, else the edge of the tool points to it.
    pub(super) fn thread_face(&self) -> Made<Towards> {
        let told = match self.settings.control.turning.rear_face {
            Some(rear) => Some(rear),
            None => match self.known_tool().and_then(|tool| tool.orientation) {
                Some(2 | 3 | 7) => Some(false),
                Some(1 | 4 | 5) => Some(true),
                _ => None,
            },
        };
        match told {
            Some(rear) => {
                self.depends_on(Question::ThreadFace, self.given.place_of(word::U));
                Ok(if rear { Towards::PlusZ } else { Towards::MinusZ })
            }
            None => self.refuse(codes::P2004::thread_runs_across_face().answer(Answer::key("control", "thread_face"))),
        }
    }

    /// A thread across a face stays on its side of the turning centre, with its run-in and run-out.
    pub(super) fn off_centre(&self, start: Point2, parts: &[ThreadPart], run_in: f64, run_out: f64) -> Made {
        let Some(last) = parts.last() else { return Ok(()) };
        let inwards = last.end.y < start.y;
        let (begin, end) =
            if inwards { (start.y + run_in, last.end.y - run_out) } else { (start.y - run_in, last.end.y + run_out) };
        if begin.min(end) >= 0.0 {
            return Ok(());
        }
        self.refuse(codes::T1007::thread_with_its_run(&(2.0 * begin.min(end))))
    }
}
