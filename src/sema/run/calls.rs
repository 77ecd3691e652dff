//! Calls: programs are opened, levels entered and left.

use std::fmt::Display;

use crate::diag::{CallPath, Diagnostic, Fault, codes};
use crate::machine::tree::did_you_mean;
use crate::sema::Outcome;
use crate::text::{FileId, Loc, Place, Request};

use super::Language;
use super::core::Core;
use super::files::{Wanted, find_program, is_nowhere, open_program};
use super::level::{Level, Program};

/// The name that is most like one that is not there.
pub fn like<'n>(name: &str, names: impl Iterator<Item = &'n str>) -> Option<String> {
    let mut names: Vec<&str> = names.collect();
    names.sort_unstable();
    did_you_mean(name, names).map(str::to_owned)
}

/// Calls of a cycle that are named.
const MOST_CALLS: usize = 4;

impl<L: Language> Core<'_, L> {
    #[inline]
    pub fn level(&mut self) -> &mut Level<L::Frame> {
        self.levels.last_mut().expect("the main level is popped only when the run ends")
    }

    /// The program that runs.
    pub fn program(&mut self) -> &mut Program<L> {
        let at = self.level().program;
        &mut self.programs[at]
    }

    /// Index of the program that runs, and how it was reached.
    #[inline]
    pub(super) fn running(&mut self) -> (usize, CallPath) {
        let level = self.level();
        (level.program, level.call)
    }

    /// Does the program run already, on any level?
    pub fn is_running(&self, program: usize) -> bool {
        self.levels.iter().any(|level| level.program == program)
    }

    /// Finds and opens the program that the block in hand calls.
    pub fn open_called(&mut self, wanted: &Wanted<'_>) -> Option<usize> {
        let origin = self.here.origin;
        self.budget.search();
        let file: FileId = open_program(&self.job, wanted, origin.loc, origin.call)?;
        self.open(file, origin.loc)
    }

    /// The same; a finding that is not reported yet where it cannot be opened.
    pub fn find_called(&mut self, wanted: &Wanted<'_>) -> Result<Option<usize>, Box<Diagnostic>> {
        let origin = self.here.origin;
        self.budget.search();
        let file = find_program(&self.job, wanted, origin.loc, origin.call)?;
        Ok(self.open(file, origin.loc))
    }

    /// Is the program that the block in hand calls nowhere?
    pub fn is_nowhere(&mut self, wanted: &Wanted<'_>) -> bool {
        self.budget.search();
        is_nowhere(&self.job, wanted, self.here.origin.loc)
    }

    /// The file that the block in hand would call, as people know it.
    pub fn opens(&self, wanted: &Wanted<'_>) -> Option<String> {
        let from = self.job.sources.identity(self.here.file);
        let Wanted { name, extensions, within } = *wanted;
        self.job.files.open(&Request { from: &from, name, extensions, within }).ok().map(|opened| opened.name)
    }

    /// Goes on at `to` in `program`, until [`Core::leave`] comes back.
    pub fn enter(&mut self, program: usize, to: Place, frame: L::Frame) -> Outcome {
        let site = self.here.origin.loc;
        let back = self.program().source.cursor.place();
        let call = self.job.trail.enter(self.here.origin.call, site);
        self.levels.push(Level { program, back, call, site, frame });
        self.budget.jump(site);
        self.seek(to)
    }

    /// The same, unless calls are nested deeper than `most` or the configuration allow: `fault` says so of the number.
    pub fn enter_within(
        &mut self,
        most: usize,
        fault: fn(&dyn Display) -> Fault,
        (program, to): (usize, Place),
        frame: L::Frame,
    ) -> Outcome {
        let most = most.min(self.job.settings.limits.call_depth);
        if self.levels.len() > most {
            return self.too_deep(fault(&most));
        }
        self.enter(program, to, frame)
    }

    /// Goes back to where the level was called, and hands out what it held.
    pub fn leave(&mut self) -> Outcome<Option<L::Frame>> {
        let called = self.levels.len() > 1;
        let Some(level) = called.then(|| self.levels.pop()).flatten() else { return Ok(None) };
        // A caller in a file of its own still stands there, and may be too large for the memory.
        if self.program().source.cursor.place() != level.back {
            self.seek(level.back)?;
        }
        Ok(Some(level.frame))
    }

    /// Goes on at `to` in the program that runs.
    pub fn seek(&mut self, to: Place) -> Outcome {
        let sources = self.job.sources;
        match self.program().source.cursor.seek(sources, to) {
            Ok(()) => Ok(()),
            Err(error) => self.unreadable(&error),
        }
    }

    /// The same for a jump of the block in hand.
    pub fn jump_to(&mut self, to: Place) -> Outcome {
        self.note_jump();
        self.seek(to)
    }

    /// The block in hand goes on elsewhere, and may come here again.
    pub fn note_jump(&mut self) {
        self.budget.jump(self.here.origin.loc);
    }

    /// Calls are nested deeper than `fault` says it is possible.
    pub fn too_deep<T>(&self, fault: Fault) -> Outcome<T> {
        self.end_run(match self.cycle_of_calls() {
            Some(cycle) => codes::P4003::calls_go_round(&fault.message(), &cycle),
            None => fault,
        })
    }

    /// The calls that lead back to the block in hand, where it runs on an outer level already.
    pub fn cycle_of_calls(&self) -> Option<String> {
        let site = self.here.origin.loc;
        let last = self.levels.iter().rposition(|level| level.site == site && level.call != CallPath::MAIN)?;
        let calls: Vec<Loc> = self.levels[last + 1..].iter().map(|level| level.site).chain([site]).collect();
        let name = |loc: &Loc| self.job.sources.shown(loc.file);
        if let [only] = calls[..] {
            return Some(format!("line {} of `{}` calls what it stands in", only.line, name(&only)));
        }
        let line = |loc: &Loc| format!("line {} of `{}`", loc.line, name(loc));
        let lines: Vec<String> = calls.iter().take(MOST_CALLS).map(line).collect();
        Some(format!("these blocks call each other: {}", lines.join(", ")))
    }
}
