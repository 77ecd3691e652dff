//! Words that only the machine builder knows.

use crate::diag::{Answer, codes};
use crate::parser::mtc200::problem::{self, is_system_function};
use crate::text::Span;

use super::Core;
use super::g_functions::Group;
use super::reserved::{reserved, reserved_m};
use super::words::{Strange, Words};

impl Words {
    /// Are there words of the path that no G function of the block takes? A strange word beside them may.
    fn has_loose_words(&self) -> bool {
        let taken = [Group::Motion, Group::Once].iter().any(|group| self.g[*group as usize].is_some());
        let axes = self.axes.iter().next().is_some() || self.has_centre();
        let others = [self.radius, self.feed, self.program, self.chamfer, self.rounding];
        !taken && (axes || others.iter().any(Option::is_some) || self.has_correction())
    }
}

impl Core<'_> {
    /// The words of the machine of a block, when all its words are known.
    #[cold]
    pub(super) fn settle_strange(&self, w: &mut Words) {
        let loose = w.has_loose_words();
        for word in std::mem::take(&mut w.strange) {
            if loose || !self.declares(w, &word.name, word.span) {
                self.refuse_strange(&word, loose);
            }
        }
    }

    /// Is the word declared in `[control] machine_words`? Then it is noted, or printed as an M function.
    pub(super) fn declares(&self, w: &mut Words, name: &str, span: Span) -> bool {
        let Some(printed) = self.job.settings.control.mtc200.machine_words.get(name) else { return false };
        if reserved(name).is_some() {
            // The entry is refused at the top of the program.
            return false;
        }
        match *printed {
            // The entry is refused at the top of the program.
            Some(number) if reserved_m(number).is_some() => {}
            Some(number) => w.print_m(number, span),
            None if self.job.diags.first_time(codes::M2702, name) => self.say(span, codes::M2702::is_left_out(&name)),
            None => {}
        }
        true
    }

    fn refuse_strange(&self, word: &Strange, loose: bool) {
        let Strange { name, span, .. } = word;
        let shown = name.split_whitespace().collect::<Vec<_>>().join(" ");
        if !word.is_g
            && let Some((what, help)) = known_word(&shown)
        {
            return self.say(*span, codes::M9002::is_not_supported(&shown, &what).help(help));
        }
        // Reported once at the word: the rest of the block still says where the axes go.
        let answer = || Answer::item("control", "machine_words", format!("\"{shown}\""));
        let fault = match (word.is_g, loose) {
            (true, true) => codes::P9011::is_no_function_beside_words(&shown),
            (true, false) => codes::P9011::is_no_function_that_is_known(&shown).answer(answer()),
            (false, true) => codes::M9002::is_no_word_beside_words(&shown),
            (false, false) => codes::M9002::is_no_word_that_is_known(&shown).answer(answer()),
        };
        self.say(*span, fault);
    }
}

/// A word that is refused with what it does, and what to do about it.
fn known_word(shown: &str) -> Option<(&'static str, &'static str)> {
    let letters = shown.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(shown.len());
    if is_system_function(&shown[..letters]) {
        return Some((problem::SYSTEM_FUNCTION, problem::WITHOUT_SYSTEM_DATA));
    }
    let help = match shown.as_bytes().first()? {
        b'O' => "select the offset by G54 to G59",
        _ => "write the word with the name of an axis of the machine, and one value",
    };
    reserved(shown).map(|what| (what, help))
}
