//! Findings and functions of the run, with their place in the program.

use crate::diag::{Code, Diagnostic, codes};
use crate::ir::Function;
use crate::text::{FileId, Loc, Span};

use super::programs::UnitKind;
use super::{MOST_ERRORS, Outcome, Reported, Run};

impl Run<'_> {
    pub(super) fn report_problems(&mut self) {
        let expanded = self.expanded;
        for problem in std::mem::take(&mut self.problems) {
            let mut found = self.here.diagnostic(&self.job, problem);
            if expanded {
                found.label.loc = self.here.origin.loc;
            }
            self.job.diags.push(found);
        }
    }

    pub(super) fn report(&self, found: Diagnostic) {
        if found.code.severity == crate::diag::Severity::Error {
            self.errors.set(self.errors.get() + 1);
            // Nothing is written any more; a loop would report without end.
            if self.errors.get() > MOST_ERRORS {
                self.stop_run();
            }
        }
        self.job.diags.push(found.called(self.here.origin.call));
    }

    /// Reports an error about `span` of the block, or about the whole block, and gives it up. `alarm` is the
    /// number that the control shows; 0 for none.
    pub(super) fn fail<T>(
        &self,
        code: &'static Code,
        alarm: u32,
        span: Span,
        message: impl Into<String>,
    ) -> Outcome<T> {
        self.report(self.found(code, alarm, span, message.into()));
        Err(Reported)
    }

    /// The same with a line of help.
    pub(super) fn fail_help<T>(
        &self,
        code: &'static Code,
        alarm: u32,
        span: Span,
        message: impl Into<String>,
        help: &str,
    ) -> Outcome<T> {
        self.report(self.found(code, alarm, span, message.into()).help(help));
        Err(Reported)
    }

    pub(super) fn found(&self, code: &'static Code, alarm: u32, span: Span, message: String) -> Diagnostic {
        let message = if alarm == 0 { message } else { format!("{message} (alarm {alarm})") };
        Diagnostic::new(code, self.loc(span), message)
    }

    /// A note that is made once for the whole program.
    pub(super) fn note_once(&self, code: &'static Code, span: Span, message: impl Into<String>) {
        if self.job.diags.first_time(code) {
            self.report(Diagnostic::new(code, self.loc(span), message));
        }
    }

    /// A place in the current block; the whole block for an empty span.
    pub(super) fn loc(&self, span: Span) -> Loc {
        if self.expanded || span.is_empty() { self.here.origin.loc } else { self.here.loc(&self.job, span) }
    }

    /// End of the whole run: what is still open is worth a word.
    pub(super) fn finish(&mut self, unit: usize) {
        if self.st.side() != crate::ir::Side::None {
            let found =
                Diagnostic::new(codes::S2082, self.here.origin.loc, "the program ends with radius compensation on");
            self.report(found.help("program G40 with a straight move before the end"));
        }
        if let Some(open) = self.open_modal_call() {
            let found = Diagnostic::new(codes::S8038, self.here.origin.loc, "the program ends with a modal call on");
            self.report(found.also(open, "MCALL stands here").help("write MCALL in a block of its own before the end"));
        }
        let _ = self.programs.list_rest(&self.job);
        let others: Vec<&str> = self
            .programs
            .units
            .iter()
            .enumerate()
            .filter(|(at, other)| *at != unit && other.file == 0 && other.kind == UnitKind::Main)
            .map(|(_, other)| other.name.as_str())
            .collect();
        if !others.is_empty() {
            let start = self.programs.units[unit].start;
            let len = self.job.sources.bytes(FileId(0), Span::at(start.at, 80));
            let len = len.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(len.len());
            let start = Loc { file: FileId(0), line: start.line, span: Span::at(start.at, len as u32) };
            let name = &self.programs.units[unit].name;
            let message = format!("the file holds several main programs; {name} is compiled");
            let found = Diagnostic::new(codes::S8003, start, message);
            self.job.diags.push(found.help(format!("put {} into files of their own", others.join(", "))));
        }
    }

    pub(super) fn comment(&mut self, text: &[u8]) {
        let text = text.trim_ascii();
        if !text.is_empty() {
            self.function(Function::Comment(text.to_vec()));
        }
    }

    pub(super) fn function(&mut self, function: Function) {
        if self.capture.is_some() && self.function_in_contour(&function) {
            return;
        }
        if self.st.compensation.is_leaving() && self.leaves_in_front_of(&function).is_err() {
            return;
        }
        if self.st.pair.is_open() && self.held_back(&function) {
            return;
        }
        self.out.function(&function, &self.st.ctx, &self.here.origin);
    }

    /// Nobody knows where the tool is.
    pub(super) fn lost(&mut self) {
        self.out.lost(&self.st.ctx, &self.here.origin);
    }
}
