//! What I, J and K count from: coordinates under G90, distances from the start under G91, unless the arcs of the
//! program show something else.
//!
//! The manual describes distances from the start under G91; programs exist that give coordinates under G91, too. An
//! arc whose start and end lie on one circle in one reading only decides; where both readings fit, the whole program
//! is looked through once for arcs that speak against G90 or G91. Source: M 5.2 (docs/sources.md).

use crate::diag::{Answer, Fault, Label, codes};
use crate::geo::{Plane, Point2, SAME_POINT, distance};
use crate::machine::Axis;
use crate::machine::options::mtc200::Centres;
use crate::text::Loc;

use super::dimensions::Dimensions;
use super::words::Words;
use super::{Core, Outcome, Reported, scout};

/// Words of the centre, by axis.
const LETTERS: [&str; 3] = ["I", "J", "K"];

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

/// An arc whose centre is read: its words, and its ends as the axes of the plane have them.
#[derive(Clone, Copy)]
pub(super) struct Ends<'w> {
    pub words: &'w Words,
    pub plane: Plane,
    pub start: Point2,
    pub end: Point2,
    pub dimensions: Dimensions,
}

impl Ends<'_> {
    fn refuse<T>(&self, core: &Core<'_>, fault: Fault) -> Outcome<T> {
        core.refuse(self.words.centre_span, fault)
    }

    /// What the kind of dimensions says.
    fn dimension(&self) -> Reading {
        if self.dimensions.incremental { Reading::Distances } else { Reading::Coordinates }
    }

    fn slot(&self) -> usize {
        usize::from(self.dimensions.incremental)
    }

    /// By how much the end lies beside the circle about `center`.
    fn miss(&self, center: Point2) -> f64 {
        (distance(self.start, center) - distance(self.end, center)).abs()
    }
}

impl Settled {
    /// Centre of an arc.
    pub(super) fn centre(&mut self, arc: &Ends<'_>, core: &Core<'_>) -> Outcome<Point2> {
        let (w, start) = (arc.words, arc.start);
        let (first, second, third) = arc.plane.axes();
        if w.centre[third].is_some() {
            return arc.refuse(core, codes::P1003::is_no_centre_word_of_plane(&LETTERS[third]));
        }
        let word = |i: usize| w.centre[i].map_or(0.0, |value| arc.dimensions.main_length(Axis::ALL[i], value));
        let words = Point2::new(word(first), word(second));
        let full = distance(start, arc.end) <= SAME_POINT;
        if full && (w.centre[first].is_none() || w.centre[second].is_none()) {
            let missing = if w.centre[first].is_none() { first } else { second };
            core.say(w.centre_span, codes::M2009::of_this_full_circle_is_missing(&LETTERS[missing]));
        }
        let centres = [words, start + words.coords];
        if full && core.job.settings.control.mtc200.centres == Centres::Settle {
            return self.full_circle(centres, arc, core);
        }
        self.read_centre(centres, arc, core)
    }

    /// Every centre closes a full circle, so G90 and G91 alone say what its words are, unless the other arcs of the
    /// program speak against them.
    fn full_circle(&mut self, centres: [Point2; 2], arc: &Ends<'_>, core: &Core<'_>) -> Outcome<Point2> {
        let tol = core.job.settings.control.mtc200.circle_tolerance;
        let center = centres[arc.slot()];
        if distance(arc.start, center) <= tol {
            return arc.refuse(core, codes::P3001::centre_of_this_full_circle_lies());
        }
        if distance(centres[0], centres[1]) <= SAME_POINT {
            return Ok(center);
        }
        match self.evidence(arc, core) {
            Some(reading) if reading != arc.dimension() => arc.refuse(core, ambiguous(centres, arc)),
            _ => Ok(center),
        }
    }

    /// `centres`: read as coordinates, and as distances.
    fn read_centre(&mut self, centres: [Point2; 2], arc: &Ends<'_>, core: &Core<'_>) -> Outcome<Point2> {
        let tol = core.job.settings.control.mtc200.circle_tolerance;
        let fits =
            |c: Point2| arc.miss(c) <= tol + 1e-9 && distance(arc.start, c) > tol && distance(arc.end, c) > SAME_POINT;
        let of = |reading| centres[if reading == Reading::Coordinates { 0 } else { 1 }];
        let fixed = match core.job.settings.control.mtc200.centres {
            Centres::Settle => None,
            Centres::Absolute => Some(Reading::Coordinates),
            Centres::Relative => Some(Reading::Distances),
            Centres::Dimension => Some(arc.dimension()),
        };
        if let Some(reading) = fixed {
            if fits(of(reading)) {
                return Ok(of(reading));
            }
            return arc.refuse(core, off_circle(&[(reading, arc.miss(of(reading)))]));
        }
        match centres.map(fits) {
            [false, false] => {
                let both = [Reading::Coordinates, Reading::Distances].map(|reading| (reading, arc.miss(of(reading))));
                arc.refuse(core, off_circle(&both))
            }
            [true, true] if distance(centres[0], centres[1]) <= SAME_POINT => Ok(of(arc.dimension())),
            // Without another arc the manual's reading.
            [true, true] => Ok(of(self.evidence(arc, core).unwrap_or(arc.dimension()))),
            [coordinates, _] => {
                let reading = if coordinates { Reading::Coordinates } else { Reading::Distances };
                self.settle(reading, arc, core)?;
                Ok(of(reading))
            }
        }
    }

    /// What other arcs decided; looks through the whole program where none did.
    fn evidence(&mut self, arc: &Ends<'_>, core: &Core<'_>) -> Option<Reading> {
        if self.scouting {
            // Only the end point matters for going on.
            return Some(arc.dimension());
        }
        if self.by[arc.slot()].is_none() && !self.scouted {
            self.scouted = true;
            let found = scout(&core.job);
            for (mine, found) in self.by.iter_mut().zip(found.by) {
                *mine = mine.or(found);
            }
            if let Some((reading, loc)) = self.by[arc.slot()] {
                core.warn_unusual(reading, arc.dimension(), loc);
            }
        }
        self.by[arc.slot()].map(|(reading, _)| reading)
    }

    /// An arc that fits one reading only.
    fn settle(&mut self, reading: Reading, arc: &Ends<'_>, core: &Core<'_>) -> Outcome {
        let here = core.loc(arc.words.centre_span);
        match self.by[arc.slot()] {
            None => {
                self.by[arc.slot()] = Some((reading, here));
                core.warn_unusual(reading, arc.dimension(), here);
                Ok(())
            }
            Some((settled, _)) if settled == reading => Ok(()),
            Some((_, first)) => {
                let fault = match reading {
                    Reading::Coordinates => codes::M2006::centre_fits_as_coordinates(),
                    Reading::Distances => codes::M2006::centre_fits_as_distances(),
                };
                core.report(fault.at(here).also(first, Label::OtherArc));
                Err(Reported)
            }
        }
    }
}

impl Core<'_> {
    fn warn_unusual(&self, reading: Reading, dimension: Reading, loc: Loc) {
        if reading == dimension {
            return;
        }
        let asking = match reading {
            Reading::Coordinates => codes::M2007::centres_are_coordinates(),
            Reading::Distances => codes::M2007::centres_are_distances(),
        };
        self.report(asking.answer(Answer::key("control", "centres")).at(loc));
    }
}

fn off_circle(misses: &[(Reading, f64)]) -> Fault {
    let shown: Vec<String> = misses
        .iter()
        .map(|(reading, miss)| {
            let what = if *reading == Reading::Coordinates { "as coordinates" } else { "as distances" };
            format!("{miss:.4} mm {what}")
        })
        .collect();
    codes::P3001::end_point_misses_circle_about_centre(&shown.join(", by "))
        .answer(Answer::key("control", "circle_tolerance"))
}

fn ambiguous(centres: [Point2; 2], arc: &Ends<'_>) -> Fault {
    let (a, b, _) = arc.plane.axes();
    let [a, b] = [a, b].map(|i| Axis::ALL[i].letter());
    let show = |c: Point2| format!("{a}{:.3} {b}{:.3}", c.x, c.y);
    let radius = if arc.dimensions.diameter { " (X as radius)" } else { "" };
    codes::M2005::centre_can(&show(centres[0]), &show(centres[1]), &radius).answer(Answer::key("control", "centres"))
}
