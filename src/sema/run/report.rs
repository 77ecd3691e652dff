//! Findings about the block in hand.

use crate::diag::decimals::rounded;
use crate::diag::{Answer, Diagnostic, Fault, Severity, codes};
use crate::parser::problem::Problem;
use crate::sema::{Job, Outcome, Reported};
use crate::text::{Loc, Span};

use super::Language;
use super::core::Core;
use super::site::Site;

/// What of the block a finding is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Where {
    Block,
    /// Words of it, counted from its start.
    Words(Span),
}

impl Where {
    /// The words, or no word for the whole block.
    pub fn span(self) -> Span {
        match self {
            Where::Block => Span::default(),
            Where::Words(span) => span,
        }
    }
}

impl From<Span> for Where {
    /// Words that the block does not have have no place of their own.
    fn from(span: Span) -> Where {
        if span.is_empty() { Where::Block } else { Where::Words(span) }
    }
}

/// Is it an error whatever a missing program would have done? What is not supported, and what only the machine builder
/// can say.
fn holds_in_doubt(found: &Diagnostic) -> bool {
    let of_machine =
        |answer: &Answer| matches!(answer.section, "output" | "programs" | "tools" | "machine" | "include");
    let is_missing = found.code.id == codes::P0101.id || found.code.id == codes::S2002.id;
    is_missing || found.code.id.as_bytes().get(1) == Some(&b'9') || found.answers.iter().any(of_machine)
}

/// Reports what is wrong with the form of the block at `site`.
pub(super) fn report_problem<L: Language>(job: &Job<'_>, site: &Site, problem: Problem) {
    let problem_code = problem.code;
    let once = L::said_once(problem_code);
    let found = site.diagnostic(job, problem);
    if !once || job.diags.first_time(problem_code, ()) {
        job.diags.push(found);
    }
}

impl<L: Language> Core<'_, L> {
    /// A place in the block.
    pub fn loc(&self, place: impl Into<Where>) -> Loc {
        match place.into() {
            Where::Block => self.here.origin.loc,
            Where::Words(span) => self.here.loc(&self.job, span),
        }
    }

    /// Span of the whole block, counted from its start.
    pub fn block_span(&self) -> Span {
        let span = self.here.origin.loc.span;
        Span { start: span.start.saturating_sub(self.here.at), end: span.end.saturating_sub(self.here.at) }
    }

    pub fn report(&self, found: Diagnostic) {
        self.take(found, false);
    }

    /// Reports what is wrong at the places that explain it: once, however many blocks suffer from it.
    pub fn report_cause(&self, found: Diagnostic) {
        self.take(found, true);
    }

    fn take(&self, mut found: Diagnostic, once: bool) {
        if self.in_doubt && found.code.severity == Severity::Error && !holds_in_doubt(&found) {
            return;
        }
        if found.code.severity == Severity::Error {
            self.errors.set(self.errors.get().saturating_add(1));
            // Nothing is written any more; a loop would report without end.
            if self.errors.get() > L::MOST_ERRORS {
                self.stop_run();
            }
        }
        found.message = rounded(found.message);
        let usual = found.code.usual;
        if L::USUAL_HELP && found.help.is_none() && !usual.is_empty() {
            found = found.help(usual);
        }
        let found = found.called(self.here.origin.call);
        if once { self.job.diags.push_cause(found) } else { self.job.diags.push(found) }
    }

    /// Reports what is wrong with the form of the block.
    pub fn report_problems(&mut self) {
        for problem in self.problems.drain(..) {
            report_problem::<L>(&self.job, &self.here, problem);
        }
    }

    /// The same for a problem that only showed now.
    pub fn report_problem(&self, problem: Problem) {
        report_problem::<L>(&self.job, &self.here, problem);
    }

    /// Reports a finding and ends the run.
    pub fn stop<T>(&self, found: Diagnostic) -> Outcome<T> {
        self.report(found);
        self.stop_run();
        Err(Reported)
    }

    /// Reports a fault of words of the block, or of all of it, and gives up the block.
    pub fn refuse<T>(&self, place: impl Into<Where>, fault: Fault) -> Outcome<T> {
        self.say(place, fault);
        Err(Reported)
    }

    /// What was made, or the fault that stands in its place, which is reported.
    #[inline]
    pub fn accept<T>(&self, place: impl Into<Where>, made: Result<T, Fault>) -> Outcome<T> {
        match made {
            Ok(made) => Ok(made),
            Err(fault) => self.refuse(place, fault),
        }
    }

    /// Reports it, and goes on.
    pub fn say(&self, place: impl Into<Where>, fault: Fault) {
        self.report(fault.at(self.loc(place)));
    }

    /// Reports a fault of the whole block, and goes on.
    pub fn say_here(&self, fault: Fault) {
        self.report(fault.at(self.here.origin.loc));
    }

    /// Reports a fault of the whole block and ends the run: nobody knows where the program goes on.
    pub fn end_run<T>(&self, fault: Fault) -> Outcome<T> {
        self.stop(fault.at(self.here.origin.loc))
    }

    /// Reports it once for the whole program: each fact that its text says.
    pub fn say_once(&self, place: impl Into<Where>, fault: Fault) {
        self.report_once(fault.at(self.loc(place)));
    }

    /// Reports it unless it was said of this place already: the block may run many times.
    pub fn report_new(&self, found: Diagnostic) {
        if !self.job.diags.knows(&found) {
            self.report(found);
        }
    }

    /// Reports it unless the same was said before.
    pub fn report_once(&self, found: Diagnostic) {
        if self.job.diags.first_text(found.code, &found.message) {
            self.report(found);
        }
    }
}
