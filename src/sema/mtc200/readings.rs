//! What is said once for each program: readings that no available manual confirms, until the configuration confirms them, and words
//! that no path depends on.
//!
//! Source: M 13 (docs/sources.md).

use std::fmt::Display;

use crate::diag::fault::Asking;
use crate::diag::{Answer, codes};
use crate::machine::options::mtc200::Reading;
use crate::text::Span;

use super::Core;
use super::eval::Condition;
use super::words::{Flow, Words};

impl Core<'_> {
    /// Says a reading of ours, whose fault asks for its key; `span` is the word it is about.
    #[inline]
    pub(super) fn reading(&self, reading: Reading, span: Span, asking: impl FnOnce(&dyn Display) -> Asking) {
        let name = reading.name();
        if self.job.settings.control.mtc200.confirmed.contains(&reading)
            || !self.job.diags.first_time(codes::P8106, name)
        {
            return;
        }
        let answer = Answer::item("control", "confirmed", format!("\"{name}\""));
        self.say(span, asking(&name).answer(answer));
    }

    /// G90 and G94 are in force at the start; where a program relies on that it shows at its first position or feed.
    #[inline]
    pub(super) fn relies_on_the_start(&self, said: &mut bool, span: Span) {
        if !*said {
            *said = true;
            self.says_the_start(span);
        }
    }

    #[cold]
    fn says_the_start(&self, span: Span) {
        self.reading(Reading::AtStart, span, codes::P8106::g90_and_g94_are_in_force);
    }

    /// Words of the program flow that no page read describes.
    pub(super) fn flow_reading(&self, flow: Flow, span: Span) {
        let what: fn(&dyn Display) -> Asking = match flow {
            Flow::Branch(Condition::Always) => codes::P8106::bra_goes_on_at_its_label,
            Flow::Branch(_) => codes::P8106::branches_look_at_last_assignment,
            Flow::Call | Flow::EndOfSubroutine => codes::P8106::bsr_calls_its_label,
            Flow::CallProgram => codes::P8106::jsr_calls_program,
            Flow::Halt => codes::P8106::hlt_waits_for_operator,
            Flow::Return | Flow::ProgramEnd | Flow::StopAndBranch | Flow::JumpProgram | Flow::Reverse => return,
        };
        self.reading(Reading::Flow, span, what);
    }

    /// M functions of the standard set, which a machine builder may have given another meaning.
    #[inline]
    pub(super) fn m_reading(&self, w: &Words) {
        if let Some(&(number, span)) = w.m().iter().find(|(number, _)| !matches!(number, 2 | 30)) {
            self.reading(Reading::MFunctions, span, |key| codes::M8005::m_functions_are_standard(&number, key));
        }
    }

    /// A word of the control that no path depends on: noted once.
    pub(super) fn without_geometry(&self, name: &str, span: Span) {
        if self.job.diags.first_time(codes::M2703, name) {
            self.say(span, codes::M2703::does_not_change_programmed_path(&name));
        }
    }
}
