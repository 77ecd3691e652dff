//! What I, J and K count from: coordinates under G90, distances from the start under G91, unless the arcs of the
//! program show something else.
//!
//! The manual describes distances from the start under G91; programs exist that give coordinates under G91, too. An
//! arc whose start and end lie on one circle in one reading only decides; where both readings fit, the whole program
//! is looked through once for arcs that speak against G90 or G91. Source: M 5.2 (docs/sources.md).

use crate::diag::{Answer, Label, codes};
use crate::geo::{Plane, Point2, SAME_POINT, distance};
use crate::machine::Axis;
use crate::machine::options::mtc200::Centres;
use crate::text::{Loc, Span};

use super::path::plane_axes;
use super::words::Words;
use super::{Outcome, Reported, Run, scout};

/// What the centre words are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Reading {
    Coordinates,
    Distances,
}

/// What the arcs of the program showed, under G90 and under G91.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Settled {
    by: [Option<(Reading, Loc)>; 2],
    /// The whole program was looked through.
    scouted: bool,
    /// This run is the look through the program.
    pub scouting: bool,
}

impl Settled {
    pub fn scout() -> Settled {
        Settled { scouting: true, ..Settled::default() }
    }
}

impl Run<'_> {
    /// Centre of an arc from `start` to `end`.
    pub(super) fn centre(&mut self, w: &Words, plane: Plane, start: Point2, end: Point2) -> Outcome<Point2> {
        let [first, second] = plane_axes(plane);
        let third = 3 - first - second;
        if w.centre[third].is_some() {
            let letter = ["I", "J", "K"][third];
            return self.core.refuse(w.centre_span, codes::P1003::is_no_centre_word_of_plane(&letter));
        }
        let mut word = |i: usize| match w.centre[i] {
            Some(value) => self.length(Axis::ALL[i], value, w.centre_span),
            None => Ok(0.0),
        };
        let words = Point2::new(word(first)?, word(second)?);
        let full = distance(start, end) <= SAME_POINT;
        if full && (w.centre[first].is_none() || w.centre[second].is_none()) {
            let missing = if w.centre[first].is_none() { first } else { second };
            self.core.report(
                codes::M2009::of_this_full_circle_is_missing(&["I", "J", "K"][missing])
                    .at(self.core.loc(w.centre_span)),
            );
        }
        if full && let Some(center) = self.full_circle([words, start + words.coords], start, w.centre_span) {
            return center;
        }
        self.read_centre([words, start + words.coords], start, end, w.centre_span)
    }

    /// Every centre closes a full circle, so G90 and G91 alone say what its words are, unless the other arcs of the
    /// program speak against them. `None` where the option decides.
    fn full_circle(&mut self, centres: [Point2; 2], start: Point2, span: Span) -> Option<Outcome<Point2>> {
        if self.core.job.settings.control.mtc200.centres != Centres::Settle {
            return None;
        }
        let tol = self.core.job.settings.control.mtc200.circle_tolerance;
        let (dimension, center) = match self.st.incremental {
            true => (Reading::Distances, centres[1]),
            false => (Reading::Coordinates, centres[0]),
        };
        if distance(start, center) <= tol {
            return Some(self.core.refuse(span, codes::P3001::centre_of_this_full_circle_lies()));
        }
        if distance(centres[0], centres[1]) <= SAME_POINT {
            return Some(Ok(center));
        }
        let slot = usize::from(self.st.incremental);
        match self.evidence(slot, dimension) {
            Some(reading) if reading != dimension => Some(self.ambiguous(centres, span)),
            _ => Some(Ok(center)),
        }
    }

    /// `centres`: read as coordinates, and as distances.
    fn read_centre(&mut self, centres: [Point2; 2], start: Point2, end: Point2, span: Span) -> Outcome<Point2> {
        let tol = self.core.job.settings.control.mtc200.circle_tolerance;
        let miss = |c: Point2| (distance(start, c) - distance(end, c)).abs();
        let fits = |c: Point2| miss(c) <= tol + 1e-9 && distance(start, c) > tol && distance(end, c) > SAME_POINT;
        let of = |reading| centres[if reading == Reading::Coordinates { 0 } else { 1 }];
        let dimension = if self.st.incremental { Reading::Distances } else { Reading::Coordinates };
        let fixed = match self.core.job.settings.control.mtc200.centres {
            Centres::Settle => None,
            Centres::Absolute => Some(Reading::Coordinates),
            Centres::Relative => Some(Reading::Distances),
            Centres::Dimension => Some(dimension),
        };
        if let Some(reading) = fixed {
            if fits(of(reading)) {
                return Ok(of(reading));
            }
            return self.off_circle(&[(reading, miss(of(reading)))], span);
        }
        let slot = usize::from(self.st.incremental);
        match centres.map(fits) {
            [false, false] => {
                let both = [Reading::Coordinates, Reading::Distances].map(|reading| (reading, miss(of(reading))));
                self.off_circle(&both, span)
            }
            [true, true] if distance(centres[0], centres[1]) <= SAME_POINT => Ok(of(dimension)),
            [true, true] => match self.evidence(slot, dimension) {
                Some(reading) => Ok(of(reading)),
                // The manual's reading, which needs no other arc.
                None => Ok(of(dimension)),
            },
            [coordinates, _] => {
                let reading = if coordinates { Reading::Coordinates } else { Reading::Distances };
                self.settle(slot, reading, dimension, span)?;
                Ok(of(reading))
            }
        }
    }

    /// What other arcs decided; looks through the whole program where none did.
    fn evidence(&mut self, slot: usize, dimension: Reading) -> Option<Reading> {
        if self.settled.scouting {
            // Only the end point matters for going on.
            return Some(dimension);
        }
        if self.settled.by[slot].is_none() && !self.settled.scouted {
            self.settled.scouted = true;
            let found = scout(&self.core.job);
            for (mine, found) in self.settled.by.iter_mut().zip(found.by) {
                *mine = mine.or(found);
            }
            if let Some((reading, loc)) = self.settled.by[slot] {
                self.warn_unusual(reading, dimension, loc);
            }
        }
        self.settled.by[slot].map(|(reading, _)| reading)
    }

    /// An arc that fits one reading only.
    fn settle(&mut self, slot: usize, reading: Reading, dimension: Reading, span: Span) -> Outcome {
        let here = self.core.loc(span);
        match self.settled.by[slot] {
            None => {
                self.settled.by[slot] = Some((reading, here));
                self.warn_unusual(reading, dimension, here);
                Ok(())
            }
            Some((settled, _)) if settled == reading => Ok(()),
            Some((_, first)) => {
                let fault = match reading {
                    Reading::Coordinates => codes::M2006::centre_fits_as_coordinates(),
                    Reading::Distances => codes::M2006::centre_fits_as_distances(),
                };
                self.core.report(fault.at(here).also(first, Label::OtherArc));
                Err(Reported)
            }
        }
    }

    fn warn_unusual(&mut self, reading: Reading, dimension: Reading, loc: Loc) {
        if reading == dimension {
            return;
        }
        let asking = match reading {
            Reading::Coordinates => codes::M2007::centres_are_coordinates(),
            Reading::Distances => codes::M2007::centres_are_distances(),
        };
        self.core.report(asking.answer(Answer::key("control", "centres")).at(loc));
    }

    fn off_circle(&mut self, misses: &[(Reading, f64)], span: Span) -> Outcome<Point2> {
        let shown: Vec<String> = misses
            .iter()
            .map(|(reading, miss)| {
                let what = if *reading == Reading::Coordinates { "as coordinates" } else { "as distances" };
                format!("{miss:.4} mm {what}")
            })
            .collect();
        self.core.refuse(
            span,
            codes::P3001::end_point_misses_circle_about_centre(&shown.join(", by "))
                .answer(Answer::key("control", "circle_tolerance")),
        )
    }

    fn ambiguous(&mut self, centres: [Point2; 2], span: Span) -> Outcome<Point2> {
        let [a, b] = plane_axes(self.st.plane).map(|i| Axis::ALL[i].letter());
        let show = |c: Point2| format!("{a}{:.3} {b}{:.3}", c.x, c.y);
        let radius = if self.st.diameter { " (X as radius)" } else { "" };
        self.core.refuse(
            span,
            codes::M2005::centre_can(&show(centres[0]), &show(centres[1]), &radius)
                .answer(Answer::key("control", "centres")),
        )
    }
}
