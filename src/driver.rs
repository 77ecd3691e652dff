//! Wires the stages; the only file that knows them all.

use std::io;

use crate::diag::{Diags, Trail};
use crate::dialect::Dialect;
use crate::emit::plot::Plot;
use crate::emit::trace::Trace;
use crate::emit::{LineMap, Output, Printer};
use crate::ir::motion;
use crate::ir::verify;
use crate::lower::Lower;
use crate::machine::Settings;
use crate::sema::Job;
use crate::text::{FileId, Files, Opened, Sources};

/// One run: its files, findings and call paths.
#[derive(Debug, Default)]
pub struct Session {
    pub sources: Sources,
    pub diags: Diags,
    pub trail: Trail,
}

impl Session {
    /// A session whose main program is `main`.
    pub fn new(main: Opened) -> Session {
        let session = Session::default();
        // The first file always fits.
        let _ = session.sources.add(main);
        session
    }

    fn job<'a>(&'a self, settings: &'a Settings, files: &'a dyn Files) -> Job<'a> {
        Job { sources: &self.sources, diags: &self.diags, trail: &self.trail, files, settings, main: FileId(0) }
    }

    /// Runs the program and lowers it to `out`. Returns the hash of the source.
    fn run(&self, dialect: &Dialect, settings: &Settings, files: &dyn Files, out: &mut dyn motion::Sink) -> u64 {
        let settings = dialect.settings(settings);
        let settings = settings.as_ref();
        let job = self.job(settings, files);
        if cfg!(debug_assertions) {
            let mut motion = verify::Motion::new(out);
            let mut lower = Lower::new(&self.diags, &settings.machine, &mut motion);
            let hash = (dialect.run)(&job, &mut verify::Contour::new(&mut lower));
            lower.finish();
            return hash;
        }
        let mut lower = Lower::new(&self.diags, &settings.machine, out);
        let hash = (dialect.run)(&job, &mut lower);
        lower.finish();
        hash
    }

    /// Runs the program and gives its moves to `out`.
    pub fn lower(&self, dialect: &Dialect, settings: &Settings, files: &dyn Files, out: &mut dyn motion::Sink) {
        self.run(dialect, settings, files, out);
    }

    /// Compiles the main program to `out`. With an error among the findings the output must not be used.
    ///
    /// # Errors
    /// What the output reports.
    pub fn compile<'a>(
        &'a self,
        dialect: &Dialect,
        settings: &'a Settings,
        files: &dyn Files,
        out: &'a mut dyn Output,
        map: Option<&'a mut dyn LineMap>,
    ) -> io::Result<()> {
        let name = self.sources.name(FileId(0));
        let settings = dialect.settings(settings);
        let settings = settings.as_ref();
        // The settings may live shorter than what was handed in.
        let map = map.map(|map| -> &mut dyn LineMap { map });
        let mut printer = Printer::new(settings, &name, &self.diags, out, map);
        let hash = self.run(dialect, settings, files, &mut printer);
        printer.finish(hash)
    }

    /// Reads all blocks, also those that never run, runs the program, and prints nothing.
    pub fn check(&self, dialect: &Dialect, settings: &Settings, files: &dyn Files) {
        (dialect.check_form)(&self.job(settings, files));
        self.diags.begin_run();
        let mut nowhere = Nowhere;
        let settings = dialect.settings(settings);
        let settings = settings.as_ref();
        // An output of the target finds what only shows in printed numbers.
        let mut printer = Printer::new(settings, "", &self.diags, &mut nowhere, None);
        let hash = self.run(dialect, settings, files, &mut printer);
        let _ = printer.finish(hash);
        if let Some(check_unexecuted) = dialect.check_unexecuted {
            check_unexecuted(&self.job(settings, files));
        }
    }

    /// Draws the resolved path. With an error among the findings the picture must not be used.
    ///
    /// # Errors
    /// What `out` reports.
    pub fn plot(
        &self,
        dialect: &Dialect,
        settings: &Settings,
        files: &dyn Files,
        out: &mut dyn Output,
    ) -> io::Result<()> {
        let mut plot = Plot::new(settings, &self.sources.name(FileId(0)), out);
        self.run(dialect, settings, files, &mut plot);
        plot.finish()
    }

    /// Writes the resolved moves as JSON Lines.
    ///
    /// # Errors
    /// What `out` reports.
    pub fn trace(
        &self,
        dialect: &Dialect,
        settings: &Settings,
        files: &dyn Files,
        out: &mut dyn io::Write,
    ) -> io::Result<()> {
        let mut trace = Trace::new(&self.sources, &self.trail, out);
        self.run(dialect, settings, files, &mut trace);
        trace.finish()
    }
}

/// An output that keeps nothing.
struct Nowhere;

impl Output for Nowhere {
    fn append(&mut self, _: &[u8]) -> io::Result<()> {
        Ok(())
    }

    fn patch(&mut self, _: u64, _: &[u8]) -> io::Result<()> {
        Ok(())
    }
}
