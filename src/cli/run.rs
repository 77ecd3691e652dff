//! The commands that work on programs.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::{self, IsTerminal};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use crate::diag::Severity;
use crate::diag::report::Counts;
use crate::driver::{Failure, Session};
use crate::emit::LineMap;
use crate::text::FileId;
use crate::text::decode::harmless_lines;

use super::args::{Check, Compile};
use super::closure::Targets;
use super::deps::Rule;
use super::disk::file_name;
use super::inputs::{Input, inputs, no_program};
use super::listing::print;
use super::made::{Made, Replaces, is_foreign, is_output, target_of};
use super::options::Common;
use super::output::{Destination, Group, set_aside};
use super::paths::{is_source_name, real};
use super::pool::in_order;
use super::program::{LARGEST_TRIED, Loaded, is_program, load};
use super::progress::Ticker;
use super::report::{Look, Presented, Reporter, Stdout, counted};
use super::source_map::{self, SourceMap};
use super::{Exit, Trouble, bundle, config, fix, ignores};

/// `partc compile`
pub(super) fn compile(args: &Compile) -> Result<Exit, Trouble> {
    let takes = |path: &Path| is_program(path, &args.common) && !is_output(path);
    let found = inputs(&args.inputs, &args.many, &takes)?;
    if found.list.len() > 1 && args.output.is_some() {
        return Err("several inputs cannot go to one output; use --out-dir".to_owned());
    }
    if found.list.len() > 1 && args.map.is_some() {
        return Err("a source map belongs to one input".to_owned());
    }
    let to_stdout = |input: &Input| match &args.output {
        Some(output) => output == Path::new("-"),
        None => input.path == Path::new("-") && args.out_dir.is_none(),
    };
    let program = found.list.iter().any(to_stdout);
    let document = args.common.report.format.is_some_and(|format| format.kind().is_some());
    let streams = [
        (program, "the program"),
        (args.map.as_deref() == Some(Path::new("-")), "the source map"),
        (document, "the findings"),
    ];
    let streams: Vec<&str> = streams.iter().filter(|(used, _)| *used).map(|(_, what)| *what).collect();
    if streams.len() > 1 {
        return Err(format!("{} cannot all go to standard output; name a file", streams.join(" and ")));
    }
    if found.list.is_empty() && found.troubles.is_empty() && args.many.shard.is_none() {
        return Err(no_program(&args.inputs));
    }
    // Shards write to one place: all of them refuse the same.
    let outputs = outputs(args, found.list.iter().chain(&found.others))?;
    if let Some(folder) = &args.out_dir {
        fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    }
    let stdout = if streams.is_empty() || document { Stdout::Free } else { Stdout::Taken };
    let mut reporter = Reporter::new(&args.common, &args.findings, stdout, None);
    reporter.spares(&found.list, &outputs)?;
    args.deps.spares(&paths_of(&found.list), &outputs, &reporter)?;
    found.troubles.into_iter().for_each(|trouble| reporter.trouble(trouble));
    let (look, inputs) = (reporter.look_at(found.list.len(), &args.common), found.list);
    let read = inputs.iter().filter_map(|input| fs::canonicalize(&input.path).ok()).collect();
    let files = outputs.iter().map(PathBuf::as_path).chain(reporter.files()).chain(args.deps.file());
    let targets = Targets::new(files);
    let is_risky = |path: &PathBuf| path != Path::new("-") && is_foreign(path, Made::Program);
    if args.force && inputs.len() > 1 && outputs.iter().any(is_risky) {
        let all = inputs.iter().all(|input| input.path != Path::new("-"));
        if !all {
            return Err("standard input among several programs is read once only; --force has to look ahead".to_owned());
        }
        targets.look_ahead(&inputs, args.many.jobs, &args.common)?;
    }
    let work = Work { args, look, read, targets: &targets, alone: inputs.len() == 1, group: Mutex::default() };
    let mut rules = Vec::new();
    in_order(
        args.many.jobs,
        &inputs,
        |input| work.one(input),
        |done, result| {
            reporter.progress(done, inputs.len());
            // One program that cannot be read does not stop the others.
            match result {
                Ok(done) => {
                    done.said.iter().for_each(|line| reporter.say(line));
                    if done.is_wrong {
                        reporter.internal();
                    }
                    reporter.take(done.presented);
                    rules.extend(done.rule);
                }
                Err(trouble) => reporter.trouble(trouble),
            }
        },
    );
    let mut group = work.group.into_inner().unwrap_or_else(PoisonError::into_inner);
    group.commit();
    reporter.wrote(group.written);
    group.troubles.sort();
    group.troubles.into_iter().for_each(|trouble| reporter.trouble(trouble));
    if targets.was_hit() {
        return Ok(Exit::Usage);
    }
    let exit = reporter.finish()?;
    args.deps.write(rules, exit)
}

fn paths_of(inputs: &[Input]) -> Vec<&Path> {
    inputs.iter().map(|input| input.path.as_path()).collect()
}

/// The files that are made of the inputs: each needs one of its own.
fn outputs<'i>(args: &Compile, inputs: impl Iterator<Item = &'i Input>) -> Result<BTreeSet<PathBuf>, Trouble> {
    let mut taken: BTreeMap<PathBuf, &Path> = BTreeMap::new();
    for input in inputs {
        // A configuration that cannot be read is reported with its program.
        let Ok(settings) = config::settings(&input.path, &args.common) else { continue };
        let output = output_path(input, args, settings.output.target.extension);
        if let Some(first) = taken.insert(real(&output), &input.path) {
            let (first, second) = (first.display(), input.path.display());
            return Err(format!("{first} and {second} would both be written to {}", output.display()));
        }
    }
    Ok(taken.into_keys().chain(args.map.as_deref().map(real)).collect())
}

/// What the threads of `partc compile` share.
struct Work<'a> {
    args: &'a Compile,
    look: Look,
    /// The files of the inputs, links followed.
    read: BTreeSet<PathBuf>,
    /// What the run will replace.
    targets: &'a Targets,
    /// There is one input only.
    alone: bool,
    /// The outputs of several inputs.
    group: Mutex<Group>,
}

/// What came of one program.
struct Done {
    presented: Presented,
    /// Lines about files.
    said: Vec<String>,
    /// The output was not what the program says; it was not written.
    is_wrong: bool,
    /// What it was made of, where somebody wants to know.
    rule: Option<Rule>,
}

impl Work<'_> {
    /// Refuses to write over an input, or over a file of somebody else.
    fn may_write(&self, path: &Path, made: Made) -> Result<(), Trouble> {
        let shown = path.display();
        if path.is_file() && fs::canonicalize(path).is_ok_and(|path| self.read.contains(&path)) {
            let what = if made == Made::Map { "source map" } else { "output" };
            return Err(format!("{shown}: the {what} would replace the input"));
        }
        if made == Made::Map && (is_source_name(path) || is_output(path)) {
            let why = "the source map would replace a part program, a table or a configuration; name another file";
            return Err(format!("{shown}: {why}"));
        }
        if is_foreign(path, made) && !self.args.force {
            return Err(format!("{shown}: not written by partc; use --force to replace it, or another name"));
        }
        Ok(())
    }

    fn one(&self, input: &Input) -> Result<Done, Trouble> {
        let args = self.args;
        let Loaded { session, dialect, mut settings, files, place } = load(&input.path, &args.common)?;
        settings.output.validate = !args.no_verify;
        let target = output_path(input, args, settings.output.target.extension);
        let shown = target.display().to_string();
        let trouble = |error: io::Error| format!("{shown}: {error}");
        self.may_write(&target, Made::Program)?;
        if let Some(path) = &args.map {
            if real(path) == real(&target) && path != Path::new("-") {
                return Err(format!("{}: output and source map need different files", path.display()));
            }
            self.may_write(path, Made::Map)?;
        }
        let map_trouble = |error: io::Error| {
            let path = args.map.as_deref().unwrap_or(Path::new("-"));
            format!("{}: {error}", path.display())
        };
        if let Some(folder) = target.parent().filter(|_| args.out_dir.is_some()) {
            fs::create_dir_all(folder).map_err(trouble)?;
        }
        let before = target_of(&target).filter(|before| before.name != settings.output.target.name);
        let replaces = Replaces::by(Made::Program, args.force);
        let mut out = Destination::open_for(&target, replaces).map_err(trouble)?;
        let mut map = match &args.map {
            Some(path) => Some(SourceMap::create(path, &target, &session, args.force).map_err(map_trouble)?),
            None => None,
        };
        let line_map = map.as_mut().map(|map| map as &mut dyn LineMap);
        let ticker = Ticker::start(self.alone, &place);
        let result = session.compile(dialect, &settings, &files, &mut out, line_map);
        drop(ticker);
        self.targets.spare(&input.path, &args.common, &files)?;
        let map = map.map(SourceMap::finish);
        let mut said = Vec::new();
        let wrong = match &result {
            Err(Failure::Mismatch(mismatch)) => Some(mismatch),
            _ => None,
        };
        let is_wrong = wrong.is_some();
        let is_written = !is_wrong && !self.look.fails(&session);
        if let Some(mismatch) = wrong {
            let name = input.path.display();
            said.push(format!("partc: internal error: {name}: {mismatch}"));
            let config = crate::machine::show::toml(&config::tree_for(&input.path, &args.common)?);
            said.push(match bundle::write(mismatch, &session, &config, &target) {
                Ok(path) => {
                    format!("Nothing was written. Please report this with {}, which holds the program.", path.display())
                }
                Err(error) => format!("Nothing was written. Please report this with the program ({error})."),
            });
        }
        if !is_written {
            drop((out, map));
            let places = [(Some(&target), Made::Program), (args.map.as_ref(), Made::Map)];
            for (path, made) in places.into_iter().filter_map(|(path, made)| Some((path?, made))) {
                let stale = set_aside(path, made).map_err(|error| format!("{}: {error}", path.display()))?;
                said.extend(
                    stale
                        .map(|stale| format!("partc: the older {} was renamed to {}", path.display(), stale.display())),
                );
            }
        } else {
            if let Err(Failure::Output(error)) = result {
                return Err(trouble(error));
            }
            let mut group = self.group.lock().unwrap_or_else(PoisonError::into_inner);
            let name_output = || {
                group.take(out, shown.clone());
                if self.alone {
                    group.commit();
                }
                group.troubles.is_empty()
            };
            match map {
                Some(map) => map.and_then(|map| source_map::name_with(map, name_output)).map_err(map_trouble)?,
                None => drop(name_output()),
            }
            if let Some(before) = before.filter(|_| !args.common.report.quiet) {
                let now = settings.output.target.name;
                said.push(format!(
                    "partc: {shown} was made for {}, and is for {now} now; `-o` or `--out-dir` keeps both",
                    before.name
                ));
            }
            if group.written == 1
                && self.alone
                && target != Path::new("-")
                && !args.common.report.quiet
                && io::stderr().is_terminal()
            {
                let bytes = fs::metadata(&target).map_or(0, |meta| meta.len());
                said.push(format!("{} → {shown}, {bytes} bytes{}", input.path.display(), notes(&session)));
            }
        }
        let made: Vec<&Path> = [Some(target.as_path()), args.map.as_deref()].into_iter().flatten().collect();
        let rule = args.deps.rule(&input.path, &args.common, &files, &made)?;
        let presented = present(self.look, session, &input.path, &args.common, self.alone)?;
        Ok(Done { presented, said, is_wrong, rule })
    }
}

/// What a session found. Of a program alone the run goes on as far as it can, so that all keys show that it needs.
fn present(look: Look, session: Session, path: &Path, common: &Common, alone: bool) -> Result<Presented, Trouble> {
    let small = session.sources.size(FileId(0)) <= LARGEST_TRIED;
    let mut presented = look.present(session);
    if alone && small && path != Path::new("-") && presented.asks() {
        // Values that are no configuration (preset -1) leave what is to be pasted unsaid; the findings stand for themselves.
        if let Ok(requests) = super::trial::requests_of(path, common) {
            presented.ask(requests);
        }
    }
    Ok(presented)
}

/// `, 2 warnings, 1 note`
fn notes(session: &Session) -> String {
    let counts = Counts::of(&session.diags);
    let said = |n: u32, one, many| if n == 0 { String::new() } else { format!(", {}", counted(n, one, many)) };
    said(counts.warnings, "warning", "warnings") + &said(counts.notes, "note", "notes")
}

fn output_path(input: &Input, args: &Compile, extension: &str) -> PathBuf {
    if let Some(output) = &args.output {
        return output.clone();
    }
    let stdin = input.path == Path::new("-");
    let below = match &args.common.stdin_filename {
        Some(name) if stdin => PathBuf::from(file_name(name)),
        _ if stdin => PathBuf::from("stdin"),
        _ => input.below.clone(),
    };
    match &args.out_dir {
        Some(folder) => folder.join(below).with_extension(extension),
        None if stdin => PathBuf::from("-"),
        None => input.path.with_extension(extension),
    }
}

/// `partc check`
pub(super) fn check(args: &Check) -> Result<Exit, Trouble> {
    let mut reporter = Reporter::new(&args.common, &args.findings, Stdout::Free, args.output.as_deref());
    reporter.only_checks();
    let found = inputs(&args.paths, &args.many, &|path| is_program(path, &args.common))?;
    reporter.spares(&found.list, &BTreeSet::new())?;
    args.deps.spares(&paths_of(&found.list), &args.output.as_deref().map(real).into_iter().collect(), &reporter)?;
    found.troubles.into_iter().for_each(|trouble| reporter.trouble(trouble));
    if found.list.is_empty() && reporter.troubles().is_empty() && args.many.shard.is_none() {
        reporter.say(&format!("partc: {}", no_program(&args.paths)));
    }
    let (look, inputs) = (reporter.look_at(found.list.len(), &args.common), found.list);
    if args.diff {
        return show_fixes(args, &inputs, reporter);
    }
    for input in inputs.iter().filter(|_| args.add_ignores || args.fix) {
        let name = input.path.display();
        let changed = if args.fix {
            let fixed = fix::fix(&input.path, &args.common, fix::Mode::Write, args.unsafe_fixes);
            fixed.map(|fixed| counted(fixed.made as u32, "change", "changes"))
        } else {
            let least = args.findings.fail_on.of_findings().min(Severity::Warning);
            ignores::add(&input.path, &args.common, least).map(|n| counted(n as u32, "suppression", "suppressions"))
        };
        match changed {
            Ok(what) if what.starts_with("0 ") => {}
            Ok(what) => reporter.say(&format!("{name}: {what} written")),
            Err(trouble) => reporter.trouble(trouble),
        }
    }
    let alone = inputs.len() == 1;
    let targets = Targets::new(reporter.files().chain(args.deps.file()));
    let work = |input: &Input| {
        let Loaded { session, dialect, settings, files, place } = load(&input.path, &args.common)?;
        let ticker = Ticker::start(alone, &place);
        session.check(dialect, &settings, &files);
        drop(ticker);
        targets.spare(&input.path, &args.common, &files)?;
        let rule = args.deps.rule(&input.path, &args.common, &files, &[])?;
        Ok((present(look, session, &input.path, &args.common, alone)?, rule))
    };
    let mut rules = Vec::new();
    in_order(args.many.jobs, &inputs, work, |done, result: Result<(Presented, Option<Rule>), Trouble>| {
        reporter.progress(done, inputs.len());
        match result {
            Ok((presented, rule)) => {
                reporter.take(presented);
                rules.extend(rule);
            }
            Err(trouble) => reporter.trouble(trouble),
        }
    });
    if targets.was_hit() {
        return Ok(Exit::Usage);
    }
    let exit = reporter.finish()?;
    args.deps.write(Rule::together(rules, args.output.as_deref()), exit)
}

/// `partc check --diff`: of a program with errors these are shown.
fn show_fixes(args: &Check, inputs: &[Input], mut reporter: Reporter) -> Result<Exit, Trouble> {
    let (look, mut changes, mut refused) = (reporter.look(), false, false);
    for input in inputs {
        match fix::fix(&input.path, &args.common, fix::Mode::Show, args.unsafe_fixes) {
            Ok(fixed) if fixed.refused => {
                refused = true;
                let Loaded { session, dialect, settings, files, .. } = load(&input.path, &args.common)?;
                session.check(dialect, &settings, &files);
                files.unchanged()?;
                reporter.take(look.present(session));
            }
            Ok(fixed) => {
                changes |= fixed.made > 0;
                print(harmless_lines(&fixed.diff).as_bytes())?;
            }
            Err(trouble) => reporter.trouble(trouble),
        }
    }
    if refused {
        return reporter.finish();
    }
    Ok(match (reporter.troubles().is_empty(), changes) {
        (false, _) => Exit::Usage,
        (true, true) => Exit::Errors,
        (true, false) => Exit::Clean,
    })
}
