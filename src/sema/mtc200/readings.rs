//! What is said once for each program: readings that no available manual confirms, until the configuration confirms them, and words
//! that no path depends on.
//!
//! Source: M 13 (docs/sources.md).

use std::fmt::Display;

use rustc_hash::FxHashSet;

use crate::diag::fault::Asking;
use crate::diag::{Answer, codes};
use crate::machine::options::mtc200::Reading;
use crate::text::Span;

use super::Core;
use super::words::{Condition, Flow, Words};

/// What was said, or needs no word.
#[derive(Debug)]
pub(super) struct Said {
    /// Readings that the configuration confirms, and those that were said.
    confirmed: Vec<Reading>,
    noted: FxHashSet<String>,
}

impl Said {
    pub fn new(confirmed: &[Reading]) -> Said {
        Said { confirmed: confirmed.to_vec(), noted: FxHashSet::default() }
    }

    /// Is this the first time that something is said of `name`?
    pub fn is_first(&mut self, name: &str) -> bool {
        !self.noted.contains(name) && self.noted.insert(name.to_owned())
    }

    /// Says a reading of ours, whose fault asks for its key; `span` is the word it is about.
    #[inline]
    pub fn reading(
        &mut self,
        core: &Core<'_>,
        reading: Reading,
        span: Span,
        asking: impl FnOnce(&dyn Display) -> Asking,
    ) {
        if !self.confirmed.contains(&reading) {
            self.say_reading(core, reading, span, asking(&reading.name()));
        }
    }

    #[cold]
    fn say_reading(&mut self, core: &Core<'_>, reading: Reading, span: Span, asking: Asking) {
        self.confirmed.push(reading);
        let answer = Answer::item("control", "confirmed", format!("\"{}\"", reading.name()));
        core.say(span, asking.answer(answer));
    }

    /// G90 and G94 are in force at the start; where a program relies on that it shows at its first position or feed.
    pub fn relies_on_the_start(&mut self, core: &Core<'_>, said: bool, span: Span) {
        if !said {
            self.reading(core, Reading::AtStart, span, codes::P8106::g90_and_g94_are_in_force);
        }
    }

    /// Words of the program flow that no page read describes.
    pub fn flow_reading(&mut self, core: &Core<'_>, flow: Flow, span: Span) {
        let what: fn(&dyn Display) -> Asking = match flow {
            Flow::Branch(Condition::Always) => codes::P8106::bra_goes_on_at_its_label,
            Flow::Branch(_) => codes::P8106::branches_look_at_last_assignment,
            Flow::Call | Flow::EndOfSubroutine => codes::P8106::bsr_calls_its_label,
            Flow::CallProgram => codes::P8106::jsr_calls_program,
            Flow::Halt => codes::P8106::hlt_waits_for_operator,
            Flow::Return | Flow::ProgramEnd | Flow::StopAndBranch | Flow::JumpProgram | Flow::Reverse => return,
        };
        self.reading(core, Reading::Flow, span, what);
    }

    /// M functions of the standard set, which a machine builder may have given another meaning.
    pub fn m_reading(&mut self, core: &Core<'_>, w: &Words) {
        if let Some(&(number, span)) = w.m().iter().find(|(number, _)| !matches!(number, 2 | 30)) {
            self.reading(core, Reading::MFunctions, span, |key| codes::M8005::m_functions_are_standard(&number, key));
        }
    }

    /// A word of the control that no path depends on: noted once.
    pub fn without_geometry(&mut self, core: &Core<'_>, name: &str, span: Span) {
        if self.is_first(name) {
            core.say(span, codes::M2703::does_not_change_programmed_path(&name));
        }
    }
}
