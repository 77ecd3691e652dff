//! The block that is being executed, for the places of findings.

use crate::diag::{CallPath, Diagnostic};
use crate::ir::Origin;
use crate::parser::problem::Problem;
use crate::text::{FileId, Loc, Span};

use crate::sema::Job;

/// The block that is being executed.
#[derive(Debug, Clone, Copy, Default)]
pub struct Site {
    pub file: FileId,
    /// Offset of the block in its file.
    pub at: u32,
    pub line: u32,
    pub lines: u32,
    /// The text was written anew before it was parsed: only the block as a whole has a place.
    pub rewritten: bool,
    pub origin: Origin,
}

impl Site {
    #[inline]
    pub fn new(file: FileId, at: u32, line: u32, lines: u32, call: CallPath) -> Site {
        let origin = Origin { loc: Loc { file, line, span: Span::at(at, 0) }, call };
        Site { file, at, line, lines, rewritten: false, origin }
    }

    /// Marks the words of the block, for findings about all of it.
    #[inline]
    pub fn mark(&mut self, words: Span) {
        self.origin.loc.span = if self.rewritten { Span::at(self.at, 1) } else { words.shifted(self.at) };
    }

    /// A place in the block.
    pub fn loc(&self, job: &Job<'_>, span: Span) -> Loc {
        if self.rewritten {
            return self.origin.loc;
        }
        let mut line = self.line;
        if self.lines > 1 {
            let feed = job.sources.line_end(self.file);
            let before = job.sources.bytes(self.file, Span::at(self.at, span.start));
            line += before.iter().filter(|b| **b == feed).count() as u32;
        }
        Loc { file: self.file, line, span: span.shifted(self.at) }
    }

    pub fn diagnostic(&self, job: &Job<'_>, problem: Problem) -> Diagnostic {
        let loc = self.loc(job, problem.span);
        problem.fault().at(loc).called(self.origin.call)
    }
}
