//! Readings that no manual at hand confirms: each is said once per program, until the configuration confirms it.
//!
//! Source: M 13 (docs/sources.md).

use crate::diag::{Answer, Diagnostic, codes};
use crate::machine::options::mtc200::Reading;
use crate::text::Span;

use super::Run;
use super::words::{Condition, Flow, Words};

impl Run<'_> {
    /// Says that `what` is a reading of ours; `span` is the word it is about.
    #[inline]
    pub(super) fn reading(&mut self, reading: Reading, span: Span, what: &str) {
        if !self.confirmed.contains(&reading) {
            self.say_reading(reading, span, what);
        }
    }

    #[cold]
    fn say_reading(&mut self, reading: Reading, span: Span, what: &str) {
        self.confirmed.push(reading);
        let code = if reading == Reading::MFunctions { codes::M8005 } else { codes::P8106 };
        let help = format!("if the control does so, add `[control] confirmed = [\"{}\"]`", reading.name());
        let answer = Answer::item("control", "confirmed", format!("\"{}\"", reading.name()));
        self.report(Diagnostic::new(code, self.loc(span), what).help(answer.help(help)));
    }

    /// G90 and G94 are in force at the start; where a program relies on that it shows at its first position or feed.
    pub(super) fn relies_on_the_start(&mut self, said: bool, span: Span) {
        if !said {
            let what = "G90 and G94 are taken to be in force at the start, and the program does not say so before this";
            self.reading(Reading::AtStart, span, what);
        }
    }

    /// Words of the program flow that no page read describes.
    pub(super) fn flow_reading(&mut self, flow: Flow, span: Span) {
        let what = match flow {
            Flow::Branch(Condition::Always) => "BRA goes on at its label",
            Flow::Branch(_) => "BEQ, BNE, BPL and BMI look at the result of the last assignment",
            Flow::Call | Flow::EndOfSubroutine => "BSR calls what stands at its label, up to RTS",
            Flow::CallProgram => "JSR calls a program, up to RTS",
            Flow::Halt => "HLT waits for the operator",
            Flow::Return | Flow::ProgramEnd | Flow::StopAndBranch | Flow::JumpProgram | Flow::Reverse => return,
        };
        self.reading(Reading::Flow, span, what);
    }

    /// M functions of the standard set, which a machine builder may have given another meaning.
    pub(super) fn m_reading(&mut self, w: &Words) {
        if let Some(&(number, span)) = w.m().iter().find(|(number, _)| !matches!(number, 2 | 30)) {
            let what = format!("M{number} and the other M functions are taken in their standard meaning");
            self.reading(Reading::MFunctions, span, &what);
        }
    }
}
