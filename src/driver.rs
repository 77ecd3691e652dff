//! Wires the stages; the only file that knows them all.

use std::fmt;
use std::io;
use std::rc::Rc;

use crate::block_ends::{BlockEnds, Looks};
#[cfg(feature = "arrow")]
use crate::columns::{self, Known, Take};
use crate::diag::{Diags, Finding, Judge, Trail};
use crate::dialect::Dialect;
use crate::emit::plot::{self, Plot, Stop};
use crate::emit::stats::{Counter, Model, Stats};
use crate::emit::trace::Trace;
use crate::emit::{LineMap, Output, Printer};
use crate::ir::refused::Remarks;
use crate::ir::workpiece::InWorkpiece;
use crate::ir::{Function, Origin, Pos, Tap, contour, motion, verify};
use crate::lint::Checks;
use crate::lint::fingerprint::MotionFingerprint;
use crate::lint::fix::Fix;
use crate::lint::motion::{OnContour, OnMotion, Watching};
use crate::lint::policy::Policy;
use crate::lower::Lower;
use crate::machine::Settings;
use crate::program_needs::{ProgramNeeds, Watch};
use crate::sema::Job;
use crate::text::{FileId, Files, Opened, Sources};
use crate::validate::{Mismatch, Validator};
use crate::validated::Validated;

/// Why there is no output although the program has no errors.
#[derive(Debug)]
pub enum Failure {
    Output(io::Error),
    /// What was printed, read back, is not what was meant.
    Mismatch(Box<Mismatch>),
}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Failure {
        Failure::Output(error)
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Failure::Output(error) => error.fmt(f),
            Failure::Mismatch(mismatch) => mismatch.fmt(f),
        }
    }
}

impl std::error::Error for Failure {}

/// What an editor sees of a run, and whether the run is to go on.
type Watched<'w> = (&'w mut BlockEnds, &'w dyn Fn() -> bool);

/// One run: its files, findings and call paths.
#[derive(Debug, Default)]
pub struct Session {
    pub sources: Rc<Sources>,
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

    /// From here on findings are judged as the settings and the comments of the program say.
    fn judge(&self, dialect: &Dialect, settings: &Settings) -> Rc<Policy> {
        let policy = Rc::new(Policy::new(&settings.lint, &self.sources, dialect.survey));
        self.diags.judge_by(Rc::clone(&policy) as Rc<dyn Judge>);
        policy
    }

    fn job<'a>(&'a self, settings: &'a Settings, files: &'a dyn Files) -> Job<'a> {
        Job { sources: &self.sources, diags: &self.diags, trail: &self.trail, files, settings, main: FileId(0) }
    }

    /// Runs the program and lowers it to `out`. Returns the hash of the source.
    fn run(&self, dialect: &Dialect, settings: &Settings, files: &dyn Files, out: &mut dyn motion::Sink) -> u64 {
        self.run_watched(dialect, settings, files, out, (None, None))
    }

    /// The same, while rules and an editor look on.
    fn run_watched(
        &self,
        dialect: &Dialect,
        settings: &Settings,
        files: &dyn Files,
        out: &mut dyn motion::Sink,
        (watch, seen): (Option<&Watching<'_>>, Option<Watched<'_>>),
    ) -> u64 {
        let settings = dialect.settings(settings);
        let settings = settings.as_ref();
        let job = self.job(settings, files);
        let watched = |sink: &mut dyn contour::Sink| match watch {
            Some(watch) => (dialect.run)(&job, &mut OnContour { watch: Rc::clone(watch), next: sink }),
            None => (dialect.run)(&job, sink),
        };
        let run = |sink: &mut dyn contour::Sink| match seen {
            Some((seen, goes_on)) => {
                let mut looks = Looks { seen, trail: &self.trail, next: sink, goes_on };
                watched(&mut Remarks::new(&self.diags, &mut looks))
            }
            None => watched(sink),
        };
        self.lowered(settings, out, run)
    }

    /// Runs a program into `lower`, and what comes of it to `out`.
    fn lowered(
        &self,
        settings: &Settings,
        out: &mut dyn motion::Sink,
        run: impl FnOnce(&mut dyn contour::Sink) -> u64,
    ) -> u64 {
        if cfg!(debug_assertions) {
            let mut motion = verify::Motion::new(out);
            let mut lower = Lower::new(&self.diags, &settings.machine, &mut motion);
            let hash = run(&mut verify::Contour::new(&mut lower));
            lower.finish();
            return hash;
        }
        let mut lower = Lower::new(&self.diags, &settings.machine, out);
        let hash = run(&mut lower);
        lower.finish();
        hash
    }

    /// Runs the program for somebody who shows it also where it is refused: the stream says where the first error lies.
    fn run_shown(&self, dialect: &Dialect, settings: &Settings, files: &dyn Files, out: &mut dyn motion::Sink) -> u64 {
        let settings = dialect.settings(settings);
        let settings = settings.as_ref();
        let job = self.job(settings, files);
        self.lowered(settings, out, |sink| (dialect.run)(&job, &mut Remarks::new(&self.diags, sink)))
    }

    /// The first error of the run, behind which nothing is whole.
    pub fn first_error(&self) -> Option<Finding> {
        let found = self.diags.first_error().filter(|_| self.diags.has_failed())?;
        Some(Finding::new(&found, &self.sources, &self.trail, |_| Vec::new()))
    }

    /// Runs the program and gives its moves to `out`, those of a tilted plane as it counts them.
    pub fn lower(&self, dialect: &Dialect, settings: &Settings, files: &dyn Files, out: &mut dyn motion::Sink) {
        self.judge(dialect, settings);
        self.run(dialect, settings, files, out);
    }

    /// Compiles the main program to `out`. With an error among the findings the output must not be used.
    ///
    /// # Errors
    /// What the output reports, and [`Failure::Mismatch`] where the output does not do what the program says: it must not
    /// be used either, and partc is at fault.
    pub fn compile<'a>(
        &'a self,
        dialect: &Dialect,
        settings: &'a Settings,
        files: &dyn Files,
        out: &'a mut dyn Output,
        map: Option<&'a mut dyn LineMap>,
    ) -> Result<(), Failure> {
        self.compile_beside(dialect, settings, files, out, map, None)
    }

    /// Compiles without a source map, and counts as [`Session::stats`] does.
    ///
    /// # Errors
    /// As [`Session::compile`].
    pub fn compile_counted<'a>(
        &'a self,
        dialect: &Dialect,
        settings: &'a Settings,
        files: &dyn Files,
        out: &'a mut dyn Output,
        model: Model,
    ) -> Result<Stats, Failure> {
        let mut counter = Counter::new(model);
        self.compile_beside(dialect, settings, files, out, None, Some(&mut counter))?;
        Ok(counter.finish())
    }

    /// Compiles, and shows each item to `beside` once it is printed, in workpiece coordinates.
    pub(crate) fn compile_beside<'a>(
        &'a self,
        dialect: &Dialect,
        settings: &'a Settings,
        files: &dyn Files,
        out: &'a mut dyn Output,
        map: Option<&'a mut dyn LineMap>,
        beside: Option<&mut dyn motion::Sink>,
    ) -> Result<(), Failure> {
        self.judge(dialect, settings);
        let name = self.sources.name(FileId(0));
        let settings = dialect.settings(settings);
        let settings = settings.as_ref();
        // The settings may live shorter than what was handed in.
        let map = map.map(|map| -> &mut dyn LineMap { map });
        let mut printer = Printer::new(settings, &name, &self.diags, out, map);
        let run = |printer: &mut dyn motion::Sink| match beside {
            Some(beside) => {
                let beside = InWorkpiece::new(beside);
                self.run_shown(dialect, settings, files, &mut Beside { printer, beside })
            }
            None => self.run(dialect, settings, files, printer),
        };
        if !settings.output.validate {
            let hash = run(&mut printer);
            return Ok(printer.finish(hash)?);
        }
        let mut validated = Validated::new(printer, Validator::new(settings), &self.diags);
        let hash = run(&mut validated);
        validated.finish(hash)?.map_or(Ok(()), |mismatch| Err(Failure::Mismatch(mismatch)))
    }

    /// Reads all blocks, also those that never run, runs the program while rules look on, and prints nothing. Gives what
    /// would mend some of the findings.
    pub fn check(&self, dialect: &Dialect, settings: &Settings, files: &dyn Files) -> Vec<Fix> {
        self.check_seen(dialect, settings, files, None, &|| true)
    }

    /// The same, and notes where the blocks lead. Where it `goes_on` no more, it is given up, and nothing that was found
    /// may be used.
    pub fn check_seen(
        &self,
        dialect: &Dialect,
        settings: &Settings,
        files: &dyn Files,
        mut seen: Option<&mut BlockEnds>,
        goes_on: &dyn Fn() -> bool,
    ) -> Vec<Fix> {
        let policy = self.judge(dialect, settings);
        let settings = dialect.settings(settings);
        let settings = settings.as_ref();
        if let Some(seen) = &mut seen {
            seen.diameter = settings.machine.shown_diameter();
        }
        (dialect.check_form)(&self.job(settings, files));
        self.diags.begin_run();
        let checks = Checks::new(settings, &self.sources, dialect.survey, &policy, &self.diags);
        let mut nowhere = Nowhere;
        // An output of the target finds what only shows in printed numbers.
        let mut printer = Printer::new(settings, "", &self.diags, &mut nowhere, None);
        let hash = match checks.watch() {
            Some(watch) => {
                let mut on_motion = OnMotion { watch: Rc::clone(&watch), next: &mut printer };
                let hash = self.run_watched(
                    dialect,
                    settings,
                    files,
                    &mut on_motion,
                    (Some(&watch), seen.map(|seen| (seen, goes_on))),
                );
                watch.borrow_mut().finish();
                hash
            }
            None => self.run_watched(dialect, settings, files, &mut printer, (None, seen.map(|seen| (seen, goes_on)))),
        };
        let _ = printer.finish(hash);
        if !goes_on() {
            return Vec::new();
        }
        if let Some(check_unexecuted) = dialect.check_unexecuted {
            check_unexecuted(&self.job(settings, files));
        }
        let fixes = checks.read(&self.sources, dialect.survey);
        policy.report(FileId(0), &self.diags);
        fixes
    }

    /// Reads every block in this language, and runs none.
    pub fn check_form(&self, dialect: &Dialect, settings: &Settings) {
        (dialect.check_form)(&self.job(settings, &crate::text::files::NoFiles));
    }

    /// Reads all blocks and runs the program without output and without rules: the findings say what is missing.
    pub fn uses(&self, dialect: &Dialect, settings: &Settings, files: &dyn Files) -> ProgramNeeds {
        self.judge(dialect, settings);
        let settings = dialect.settings(settings);
        let settings = settings.as_ref();
        let job = self.job(settings, files);
        (dialect.check_form)(&job);
        self.diags.begin_run();
        let mut nowhere = Nowhere;
        let mut printer = Printer::new(settings, "", &self.diags, &mut nowhere, None);
        let mut lower = Lower::new(&self.diags, &settings.machine, &mut printer);
        let mut watch = Watch::new(&mut lower);
        let hash = (dialect.run)(&job, &mut watch);
        let uses = watch.uses;
        lower.finish();
        let _ = printer.finish(hash);
        if let Some(check_unexecuted) = dialect.check_unexecuted {
            check_unexecuted(&job);
        }
        uses
    }

    /// What the program does, as one number.
    pub fn fingerprint(&self, dialect: &Dialect, settings: &Settings, files: &dyn Files) -> u128 {
        self.judge(dialect, settings);
        let mut fingerprint = MotionFingerprint::default();
        self.run(dialect, settings, files, &mut fingerprint);
        fingerprint.number()
    }

    /// Draws the resolved path. That of a program with errors ends at the first one, says so, and shows pale what is known
    /// behind it.
    ///
    /// # Errors
    /// What `out` reports.
    pub fn plot(
        &self,
        dialect: &Dialect,
        settings: &Settings,
        files: &dyn Files,
        options: plot::Options,
        out: &mut dyn Output,
    ) -> io::Result<Option<plot::Thinned>> {
        self.judge(dialect, settings);
        let settings = dialect.settings(settings);
        let settings = settings.as_ref();
        let mut plot = Plot::new(settings, &self.sources.name(FileId(0)), options);
        self.run_shown(dialect, settings, files, &mut InWorkpiece::new(&mut plot));
        if let Some(error) = self.first_error() {
            plot.incomplete(self.stop(&error));
        }
        plot.finish(Some(&self.sources), out)
    }

    /// An error as a picture tells it.
    fn stop(&self, error: &Finding) -> Stop {
        let called = error.file != self.sources.name(FileId(0));
        let file = error.file.rsplit(['/', '\\']).next().unwrap_or(&error.file).to_owned();
        Stop { code: error.code, file, called, line: error.line }
    }

    /// Counts ways, times, tools and extents. With an error among the findings the figures must not be used.
    pub fn stats(&self, dialect: &Dialect, settings: &Settings, files: &dyn Files, model: Model) -> Stats {
        self.judge(dialect, settings);
        let mut counter = Counter::new(model);
        self.run(dialect, settings, files, &mut InWorkpiece::new(&mut counter));
        counter.finish()
    }

    /// Writes the resolved moves as JSON Lines. Those of a program with errors end at the first one, with a line that says so.
    ///
    /// # Errors
    /// What `out` reports.
    pub fn trace(
        &self,
        dialect: &Dialect,
        settings: &Settings,
        files: &dyn Files,
        model: Model,
        out: &mut dyn io::Write,
    ) -> io::Result<()> {
        self.judge(dialect, settings);
        let mut trace = Trace::new(&self.sources, &self.trail, model, out);
        self.run_shown(dialect, settings, files, &mut InWorkpiece::new(&mut trace));
        trace.finish(self.first_error().as_ref())
    }

    /// Gives the resolved moves as record batches to `take`, which says whether it wants more. With an error among the
    /// findings none of them must be used. Returns the hash of the main program, as far as it was run.
    #[cfg(feature = "arrow")]
    pub fn trace_batches(
        &self,
        dialect: &Dialect,
        settings: &Settings,
        files: &dyn Files,
        options: columns::Options,
        take: &mut Take<'_>,
    ) -> u64 {
        self.judge(dialect, settings);
        let known = Known { sources: &self.sources, trail: &self.trail, diags: &self.diags };
        columns::batches(known, options, take, |sink| self.run(dialect, settings, files, sink))
    }
}

/// A printer, and somebody who sees each item in workpiece coordinates once it is printed.
struct Beside<'p, 'b> {
    printer: &'p mut dyn motion::Sink,
    beside: InWorkpiece<'b, dyn motion::Sink + 'b>,
}

impl motion::Sink for Beside<'_, '_> {
    fn movement(&mut self, mv: &motion::Move, origin: &Origin) {
        self.printer.movement(mv, origin);
        self.beside.movement(mv, origin);
    }

    fn tap(&mut self, tap: &Tap, place: &motion::Place, origin: &Origin) {
        self.printer.tap(tap, place, origin);
        self.beside.tap(tap, place, origin);
    }

    fn function(&mut self, function: &Function, origin: &Origin) {
        self.printer.function(function, origin);
        self.beside.function(function, origin);
    }

    fn lost(&mut self, origin: &Origin) {
        self.printer.lost(origin);
        self.beside.lost(origin);
    }

    fn programmed(&mut self, mv: &motion::Move, start: &Pos) {
        self.printer.programmed(mv, start);
    }

    fn begins_at(&mut self, at: &Pos) {
        self.printer.begins_at(at);
        self.beside.begins_at(at);
    }

    fn full(&self) -> bool {
        self.printer.full()
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
