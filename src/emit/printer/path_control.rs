//! How corners are taken: the head states it, and a line says where the program changes it.

use crate::diag::{Answer, codes};
use crate::ir::{Origin, Side};
use crate::machine::{PathChoice, PathControl};
use crate::target::{Form, PathBound};
use crate::text::Loc;

use super::super::compensation::resolved;
use super::super::number::Places;
use super::Printer;
use super::corners::Doubt;

impl Printer<'_> {
    /// The last line of the head: `modes`, and how the program begins to take its corners.
    pub(super) fn head_modes(&mut self, modes: &str, lathe: bool) {
        self.corners.lathe = lathe;
        if !self.settings.can_say_path_control() {
            self.lacks_path_control();
        }
        let mode = self.settings.path_control(None, lathe);
        self.corners.look_at(self.settings.path_control, (None, mode), None);
        let dialog = match self.target.form {
            Form::Dialog(dialog) => Some(dialog),
            Form::Words => None,
        };
        if !modes.is_empty() {
            self.lines.text.word(modes);
        }
        if let Some(mode) = mode {
            if let Some(dialog) = dialog {
                self.lines.block(dialog.tolerance.as_bytes());
            }
            self.corner_words(mode);
        }
        if !modes.is_empty() || mode.is_some() {
            self.lines.block(b"");
        }
    }

    /// Another mode of the program.
    pub(super) fn path_control(&mut self, said: Option<PathControl>, origin: &Origin) {
        if self.settings.path_control == Some(PathChoice::None) {
            if said.is_some() && self.diags.first_time(codes::O4006, ()) {
                self.say(origin, codes::O4006::how_program_takes_its_corners_is_left());
            }
            return;
        }
        let mode = self.settings.path_control(said, self.corners.lathe);
        self.corners.look_at(self.settings.path_control, (said, mode), Some(origin));
        let Some(mode) = mode.filter(|mode| self.corners.printed != Some(*mode)) else { return };
        if self.compensation.side != Side::None && !self.target.path.under_compensation {
            let asking = codes::O9003::how_corners_are_taken_changes_while_radius(&self.target.name);
            return self.say(origin, asking.answer(resolved()));
        }
        if let Form::Dialog(dialog) = self.target.form {
            self.lines.words(dialog.tolerance, origin);
        }
        self.corner_words(mode);
        self.lines.end_line(origin);
    }

    /// The words of a mode, on the line under construction.
    fn corner_words(&mut self, mode: PathControl) {
        self.corners.printed = Some(mode);
        let words = self.target.path;
        let (bound, mm) = match mode {
            PathControl::Exact | PathControl::Unbounded => {
                let word = if mode == PathControl::Exact { words.exact } else { words.unbounded };
                self.lines.text.word(word.unwrap_or_default());
                return;
            }
            PathControl::Within(mm) => (words.within, mm),
            PathControl::Before(mm) => (words.before, mm),
        };
        if let Some(PathBound { word, length }) = bound {
            let places = self.bound_places();
            let units = bound_units(mm, places);
            self.lines.text.word(word).valued(length, units, places);
        }
    }

    /// A bound has as many places as the target reads.
    fn bound_places(&self) -> Places {
        let numbers = &self.target.numbers;
        let places = Places::new(numbers.most).written(numbers.point, numbers.zero);
        if self.measures.inches { places.of_inches() } else { places }
    }

    /// In front of the first move whose corners are not bounded as they should be: told once.
    #[cold]
    pub(super) fn tell_of_corners(&mut self, first: &Origin) {
        self.corners.told = true;
        let Some((origin, doubt)) = self.corners.doubt.take() else { return };
        let origin = origin.unwrap_or(*first);
        let (name, words) = (self.target.name, self.target.path);
        let word = words.unbounded.unwrap_or_default();
        let asking = match (doubt, words.exact) {
            (Doubt::Unbounded, Some(_)) => codes::O9338::target_passes_corners_under(&name, &word),
            (Doubt::Unbounded, None) => codes::O9338::target_passes_all_corners_under(&name, &word),
            (Doubt::Unsaid, Some(_)) => codes::O9338::how_far_target_rounds_corners_off(&name),
            (Doubt::Unsaid, None) => codes::O9338::how_far_target_rounds_all_corners_off(&name),
            (Doubt::NoStop(mm), _) => codes::O9338::program_stops_in_its_corners(&name, &mm),
        };
        let answer = Answer::key("output", "path_control");
        let answer = match (doubt, words.exact) {
            (Doubt::NoStop(mm), _) => answer.one_of(&[format!("{{ tolerance = {mm} }}")]),
            (Doubt::Unbounded | Doubt::Unsaid, Some(_)) => answer.one_of(&["\"exact\"", "\"none\""]),
            (Doubt::Unbounded | Doubt::Unsaid, None) => answer,
        };
        self.say(&origin, asking.answer(answer));
    }

    /// The configuration wants what the target cannot say.
    #[cold]
    fn lacks_path_control(&self) {
        let words = self.target.path;
        let mut choices = vec!["\"none\""];
        if words.exact.is_some() {
            choices.insert(0, "\"exact\"");
        }
        if words.within.is_some() {
            choices.insert(0, "{ tolerance = 0.01 }");
        }
        let (name, list) = (&self.target.name, choices.join(" or "));
        let asking = match self.settings.path_control {
            Some(PathChoice::Exact) => codes::O9339::target_has_no_word_for_stop_in_every_corner(name, &list),
            Some(PathChoice::Within(_) | PathChoice::None) | None => {
                codes::O9339::target_has_no_word_for_how_far(name, &list)
            }
        };
        let start = Loc { line: 1, ..Loc::default() };
        self.diags.push(asking.answer(Answer::key("output", "path_control").one_of(&choices)).at(start));
    }
}

/// A bound in units of the last place: never a larger one, and never nothing.
fn bound_units(mm: f64, places: Places) -> i64 {
    let nearest = places.units(mm).unwrap_or(i64::MAX);
    let larger = nearest as f64 > mm * places.scale() * (1.0 + 1e-9);
    (nearest - i64::from(larger)).max(1)
}
