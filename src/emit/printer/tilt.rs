//! Tilted working planes in the words of the target: the angles are made of the matrix here, and turned back to see that
//! what is printed is the same plane.

use nalgebra::Matrix3;

use crate::diag::{Answer, Fault, codes};
use crate::geo::{Plane, rotation};
use crate::ir::tilt::{Solution, Tilt};
use crate::ir::{Origin, Tilting};
use crate::machine::Axis;
use crate::target::{EulerWords, Length, PlaneWords, SwivelWords, TiltWords};

use super::super::number::Places;
use super::Printer;
use super::told_plane::Known;

/// What a printed plane may differ by from the meant one, as part of a direction: 0.01 mm at a metre.
const ANOTHER: f64 = 1e-5;
/// Cosine from which an axis is parallel to the tool axis.
const PARALLEL: f64 = 1.0 - 1e-12;

impl Printer<'_> {
    /// The working plane is tilted, or is so no more.
    #[cold]
    pub(super) fn tilt(&mut self, tilting: &Tilting, origin: &Origin) {
        let Some(words) = self.target.tilt else {
            let asking = codes::O9342::target_has_no_word_for_tilted_plane(&self.target.name);
            return self.deny(origin, asking.answers([]));
        };
        self.select_plane(Plane::Xy, origin);
        let said = match (words, tilting) {
            (TiltWords::Euler(words), Tilting::Into(tilt)) => self.euler_plane(words, tilt, origin),
            (TiltWords::Euler(words), Tilting::Back(_)) => self.euler_back(words, origin),
            (TiltWords::Euler(words), Tilting::Off) => {
                self.euler_off(words, origin);
                Ok(())
            }
            (TiltWords::Swivel(words), Tilting::Into(tilt)) => self.swivels(words, tilt, origin),
            (TiltWords::Swivel(words), Tilting::Back(solution)) => {
                self.swivels_back(words, *solution, origin);
                Ok(())
            }
            (TiltWords::Swivel(words), Tilting::Off) => {
                self.lines.words(words.off, origin);
                Ok(())
            }
            (TiltWords::Dialog(words), Tilting::Into(tilt)) => self.dialog_plane(words, tilt, origin),
            (TiltWords::Dialog(words), Tilting::Back(_)) => self.dialog_reset(words, words.back, origin),
            (TiltWords::Dialog(words), Tilting::Off) => self.dialog_reset(words, words.off, origin),
        };
        if let Err(fault) = said {
            self.deny(origin, fault);
        }
        self.tilting.plane = if tilting.plane().is_some() { Known::Tilted } else { Known::None };
        self.modal.forget_all();
        self.modal.forget_feed();
        self.modal.dialog.center = None;
    }

    /// Is another work offset no word of the target here?
    pub(super) fn offset_is_tilted(&self) -> bool {
        // A swivel frame lies inside of the offset.
        self.tilting.plane != Known::None && !matches!(self.target.tilt, Some(TiltWords::Swivel(_)))
    }

    /// In front of a move in machine coordinates: not every target takes one in a tilted plane.
    pub(super) fn leave_plane(&mut self, origin: &Origin) {
        if let (Some(TiltWords::Euler(words)), Known::Tilted) = (self.target.tilt, self.tilting.plane) {
            self.euler_off(words, origin);
            self.tilting.plane = Known::Left;
        }
    }

    /// A move in the plane that is there no more.
    #[cold]
    pub(super) fn lacks_plane(&mut self, origin: &Origin) {
        if let Some(TiltWords::Euler(words)) = self.target.tilt
            && !self.diags.has_errors()
        {
            self.deny(origin, codes::O9343::move_goes_on_in_plane(&self.target.name, &words.off));
        }
    }

    fn tilt_places(&self) -> Places {
        let numbers = self.target.numbers;
        Places::new(self.settings.tilt_places()).written(numbers.point, numbers.zero)
    }

    /// Angles in units of their last place, if they make the same plane.
    fn angles_of(
        &self,
        angles: [f64; 3],
        made_of: fn([f64; 3]) -> Matrix3<f64>,
        meant: &Matrix3<f64>,
    ) -> Result<[i64; 3], Fault> {
        let places = self.tilt_places();
        // A whole turn at most.
        let units = angles.map(|angle| places.units(angle).unwrap_or_default());
        let printed = made_of(units.map(|units| units as f64 / places.scale()));
        if (printed - meant).iter().all(|off| off.abs() <= ANOTHER) {
            return Ok(units);
        }
        let asking = codes::O9343::angles_print_as_another_plane(&self.settings.tilt_places());
        Err(asking.answer(Answer::key("output", "decimals")))
    }

    /// The zero point in units of the last place.
    fn zero_point(&self, tilt: &Tilt) -> Result<[i64; 3], Fault> {
        let mut place = [0; 3];
        for (units, value) in place.iter_mut().zip(tilt.origin.iter()) {
            *units = self.places.units(*value).ok_or_else(codes::O1002::number_of_this_block_is_too_large)?;
        }
        Ok(place)
    }
}

/// G68.2, G53.1, G69.
impl Printer<'_> {
    fn euler_plane(&mut self, words: &EulerWords, tilt: &Tilt, origin: &Origin) -> Result<(), Fault> {
        let angles = self.angles_of(rotation::euler_of(&tilt.axes), rotation::euler, &tilt.axes)?;
        let place = self.zero_point(tilt)?;
        self.diags.push_once(
            codes::O2004::plane_is_an_option(&self.target.name, &words.on).at(origin.loc).called(origin.call),
        );
        let word = match tilt.solution {
            Solution::Control => None,
            Solution::Primary { .. } => Some("SEQ"),
            Solution::Reference { .. } => Some("`_DIR`"),
        };
        if let Some(word) = word {
            let fault = codes::O2003::target_chooses_by_itself(&self.target.name, &word);
            self.diags.push_once(fault.at(origin.loc).called(origin.call));
        }
        self.euler_off(words, origin);
        self.length_ends(origin);
        let (lengths, degrees) = (self.places, self.tilt_places());
        self.lines.text.word(words.on);
        if let Some(mode) = words.mode {
            self.lines.text.word(mode);
        }
        for (axis, units) in [Axis::X, Axis::Y, Axis::Z].into_iter().zip(place) {
            self.lines.text.number(axis.letter() as u8, units, lengths);
        }
        for (address, units) in words.angles.into_iter().zip(angles) {
            self.lines.text.number(address, units, degrees);
        }
        self.lines.end_line(origin);
        self.lines.words(words.turn, origin);
        Ok(())
    }

    fn euler_back(&mut self, words: &EulerWords, origin: &Origin) -> Result<(), Fault> {
        let axes = self.machine.tilt_axes;
        if axes.is_empty() {
            let asking = codes::O9343::letters_of_rotary_axes_are_not_known(&self.target.name);
            return Err(asking.answer(Answer::key("machine", "tilt_axes")));
        }
        self.euler_off(words, origin);
        self.length_ends(origin);
        let degrees = self.tilt_places();
        self.lines.text.word(self.target.motion.rapid);
        for axis in axes.iter() {
            self.lines.text.number(axis.letter() as u8, 0, degrees);
        }
        self.lines.end_line(origin);
        Ok(())
    }

    /// Ends a plane that is on.
    fn euler_off(&mut self, words: &EulerWords, origin: &Origin) {
        if self.tilting.plane == Known::Tilted {
            self.lines.words(words.off, origin);
        }
        self.tilting.plane = Known::None;
    }

    /// The length of the tool ends, where the tool was taken away, and counts anew with the next move along its axis.
    fn length_ends(&mut self, origin: &Origin) {
        let Length::Words(words) = self.target.tool.length else { return };
        if let Some(off) = words.off
            && std::mem::take(&mut self.length.counts)
        {
            self.lines.words(off, origin);
            self.length.waits = self.length.tool != 0;
        }
    }
}

/// CYCLE800.
impl Printer<'_> {
    fn swivels(&mut self, words: &SwivelWords, tilt: &Tilt, origin: &Origin) -> Result<(), Fault> {
        let spatial = |[c, b, a]: [f64; 3]| rotation::spatial([a, b, c]);
        let [a, b, c] = rotation::spatial_of(&tilt.axes);
        let angles = self.angles_of([c, b, a], spatial, &tilt.axes)?;
        let place = self.zero_point(tilt)?;
        let direction = self.direction(tilt.solution, origin);
        self.swivel_begins(words, origin);
        let (lengths, degrees) = (self.places, self.tilt_places());
        self.lines.text.raw(words.into.as_bytes());
        for (i, units) in place.into_iter().chain(angles).enumerate() {
            self.lines.text.joined(words.between, units, if i < place.len() { lengths } else { degrees });
        }
        self.swivel_ends(words, direction, origin);
        Ok(())
    }

    fn swivels_back(&mut self, words: &SwivelWords, solution: Solution, origin: &Origin) {
        let direction = self.direction(solution, origin);
        self.swivel_begins(words, origin);
        self.lines.text.raw(words.back.as_bytes());
        self.swivel_ends(words, direction, origin);
    }

    fn swivel_begins(&mut self, words: &SwivelWords, origin: &Origin) {
        let machine = self.machine;
        let name = machine.swivel_record.as_deref().unwrap_or_else(|| {
            let asking = codes::O2005::empty_name_of_swivel_record();
            let fault = asking.answer(Answer::key("machine", "swivel_record"));
            self.diags.push_once(fault.at(origin.loc).called(origin.call));
            ""
        });
        self.lines.text.word(words.begin).raw(name.as_bytes());
    }

    fn swivel_ends(&mut self, words: &SwivelWords, direction: i64, origin: &Origin) {
        self.lines.text.raw(words.direction.as_bytes()).joined(words.between, direction, Places::new(0));
        self.lines.text.raw(words.end.as_bytes());
        self.lines.end_call(origin);
    }

    /// Which solution the target is told, as it counts them.
    fn direction(&mut self, solution: Solution, origin: &Origin) -> i64 {
        let sign = |greater: bool| if greater { 1 } else { -1 };
        let name = &self.target.name;
        let (direction, fault) = match solution {
            Solution::Reference { greater } => return sign(greater),
            Solution::Primary { positive } => {
                let direction = sign(positive);
                let own = format!("`_DIR` {direction}");
                (direction, codes::O2003::target_counts_by_another_axis(name, &"SEQ", &own))
            }
            Solution::Control => (1, codes::O2003::program_leaves_it_to_its_control(name, &"`_DIR` 1")),
        };
        self.diags.push_once(fault.at(origin.loc).called(origin.call));
        direction
    }
}

/// PLANE, behind a shift.
impl Printer<'_> {
    fn dialog_plane(&mut self, words: &PlaneWords, tilt: &Tilt, origin: &Origin) -> Result<(), Fault> {
        let angles = self.angles_of(rotation::spatial_of(&tilt.axes), rotation::spatial, &tilt.axes)?;
        let place = self.zero_point(tilt)?;
        let primary = match tilt.solution {
            Solution::Control => None,
            Solution::Primary { positive } => Some(words.primary[usize::from(!positive)]),
            Solution::Reference { .. } => {
                let fault = codes::O2003::target_chooses_by_itself(&self.target.name, &"`_DIR`");
                self.diags.push_once(fault.at(origin.loc).called(origin.call));
                None
            }
        };
        if self.tilting.plane == Known::Tilted {
            self.lines.words(words.off, origin);
        }
        self.shift(words, place, origin);
        let degrees = self.tilt_places();
        self.lines.text.word(words.on);
        for (word, units) in words.angles.into_iter().zip(angles) {
            self.lines.text.word(word).signed(units, degrees);
        }
        self.lines.text.word(words.turn);
        if let Some(primary) = primary {
            self.lines.text.word(primary);
        }
        if tilt.axes[(2, 2)].abs() >= PARALLEL {
            self.lines.text.word(words.free);
        }
        self.lines.end_line(origin);
        Ok(())
    }

    fn dialog_reset(&mut self, words: &PlaneWords, reset: &str, origin: &Origin) -> Result<(), Fault> {
        self.lines.words(reset, origin);
        self.shift(words, [0; 3], origin);
        Ok(())
    }

    /// The zero point, where it is another one than that of the workpiece, or was.
    fn shift(&mut self, words: &PlaneWords, place: [i64; 3], origin: &Origin) {
        let shifted = place != [0; 3];
        if !std::mem::replace(&mut self.tilting.shifted, shifted) && !shifted {
            return;
        }
        self.lines.words(words.shift, origin);
        let places = self.places;
        for (word, units) in words.shift_axes.into_iter().zip(place) {
            self.lines.text.word(word).signed(units, places);
            self.lines.end_line(origin);
        }
    }
}
