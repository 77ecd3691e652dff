//! CYCL CALL PAT with the program of cycle 12: it runs once for each place.
//!
//! What a place is to the program no available manual says; `[cycles] pattern_program` does. Source: K 4.3, 4.6
//! (docs/sources.md).

use crate::diag::{Answer, Label, codes};
use crate::ir::contour::Path;
use crate::machine::Axis;
use crate::machine::options::klartext_cycles::PatternProgram;
use crate::sema::run::Where;

use super::pattern_def::{Place, Places};
use super::words::Words;
use super::{Outcome, Reported, Run};

impl Run<'_> {
    pub(super) fn run_program_pattern(&mut self, w: &Words, places: &Places, name: &str) -> Outcome {
        let Some(reading) = self.core.job.settings.cycles.klartext.pattern_program else {
            let fault = codes::P9010::cycl_call_pat_with_program_of_cycle_12(&name);
            return self.core.refuse(Where::Block, fault.answer(Answer::key("cycles", "pattern_program")));
        };
        if places.iter().any(|place| place.surface != 0.0) {
            let found = codes::P9010::cycl_call_pat_with_program(&name).at(self.core.here.origin.loc);
            self.core.report(found.also(places.loc, Label::Pattern));
            return Err(Reported);
        }
        self.m_at_start(w, true)?;
        let (height, feed) = match reading {
            PatternProgram::Shift => {
                self.st.set_feed(&self.core, w)?;
                (None, None)
            }
            PatternProgram::Position => {
                let feed = self.pattern_feed(w, "CYCL CALL PAT")?;
                (Some(self.view().position_of(self.st.axis(), self.core.block_span(), "CYCL CALL PAT")?), feed)
            }
        };
        for place in places.iter() {
            self.core.goes_on()?;
            match height {
                None => self.run_shifted(name, place)?,
                Some(height) => {
                    // As high as the tool stood in front of the pattern, or at the clearance of the place.
                    self.rise_to(place.clearance.map_or(height, |clearance| clearance.max(height)));
                    self.go_in_plane(place.at, Path::straight(feed));
                    self.run_program(name)?;
                }
            }
        }
        self.m_at_end(w.m())
    }

    /// The program in a system that is shifted to the place, which has to be the same behind it.
    fn run_shifted(&mut self, name: &str, place: &Place) -> Outcome {
        let base = self.st.frames.transform().clone();
        let (first, second, _) = self.st.plane().axes();
        if !base.is_shift_only() || base.turn.0 != 0.0 || base.is_turned_as_a_whole() {
            return self.core.refuse(Where::Block, codes::P9010::cycl_call_pat_with_program_of_cycle(&name));
        }
        let mut shifted = base.clone();
        for (axis, by) in [(first, place.at.x), (second, place.at.y)] {
            shifted.shift_by(Axis::ALL[axis], by, true, false);
        }
        self.set_transformation(shifted.clone())?;
        self.run_program(name)?;
        if *self.st.frames.transform() != shifted {
            return self.core.refuse(Where::Block, codes::P9010::program_of_cycle_12_changes_coordinate_system(&name));
        }
        self.set_transformation(base)
    }

    fn run_program(&mut self, name: &str) -> Outcome {
        self.run_whole(name)?;
        if self.st.compensation.is_on() {
            return self.core.refuse(Where::Block, codes::K2407::program_of_cycle_12_ends_with_radius(&name));
        }
        Ok(())
    }
}
