//! Readings that no available manual confirms: each is said once per program, until the configuration confirms it.
//!
//! Source: M 13 (docs/sources.md).

use std::fmt::Display;

use crate::diag::fault::Asking;
use crate::diag::{Answer, codes};
use crate::machine::options::mtc200::Reading;
use crate::text::Span;

use super::Run;
use super::words::{Condition, Flow, Words};

impl Run<'_> {
    /// Says a reading of ours, whose fault asks for its key; `span` is the word it is about.
    #[inline]
    pub(super) fn reading(&mut self, reading: Reading, span: Span, asking: impl FnOnce(&dyn Display) -> Asking) {
        if !self.confirmed.contains(&reading) {
            self.say_reading(reading, span, asking(&reading.name()));
        }
    }

    #[cold]
    fn say_reading(&mut self, reading: Reading, span: Span, asking: Asking) {
        self.confirmed.push(reading);
        let answer = Answer::item("control", "confirmed", format!("\"{}\"", reading.name()));
        self.core.say(span, asking.answer(answer));
    }

    /// G90 and G94 are in force at the start; where a program relies on that it shows at its first position or feed.
    pub(super) fn relies_on_the_start(&mut self, said: bool, span: Span) {
        if !said {
            self.reading(Reading::AtStart, span, codes::P8106::g90_and_g94_are_in_force);
        }
    }

    /// Words of the program flow that no page read describes.
    pub(super) fn flow_reading(&mut self, flow: Flow, span: Span) {
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
    pub(super) fn m_reading(&mut self, w: &Words) {
        if let Some(&(number, span)) = w.m().iter().find(|(number, _)| !matches!(number, 2 | 30)) {
            self.reading(Reading::MFunctions, span, |key| codes::M8005::m_functions_are_standard(&number, key));
        }
    }
}
