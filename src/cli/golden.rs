//! `partc test`: compiles the programs of a folder and compares with the outputs kept beside them.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};
use similar::TextDiff;

use crate::compare::{Difference, Step, steps_of_text};
use crate::diag::report::xml::{HEAD as HEAD_OF_XML, escaped};
use crate::driver::Failure;
use crate::emit::{Output as _, names_source};
use crate::target::{self, Target};
use crate::text::decode::{escaped_json, harmless_lines};

use super::args::Test;
use super::closure::Targets;
use super::inputs::{Ignored, walk};
use super::listing::print;
use super::made::is_output;
use super::options::{Findings, Format};
use super::output::Destination;
use super::program::{Loaded, is_program, load};
use super::report::{Reporter, Stdout, counted, spares_sources};
use super::{Exit, Trouble};

/// Printed numbers that differ by less are the same.
const SAME: f64 = 1e-7;
const NAMES: [&str; 2] = ["golden", "now"];
/// Most lines shown of a difference.
const MOST_LINES: usize = 60;

/// What came of one program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Result {
    Same,
    Differs,
    /// The program has errors.
    Errors,
    /// There is nothing to compare with.
    NoGolden,
    /// A kept output whose program is gone.
    NoProgram,
    Written,
}

impl Result {
    fn word(self) -> &'static str {
        match self {
            Result::Same => "same",
            Result::Differs => "differs",
            Result::Errors => "errors",
            Result::NoGolden => "no-golden",
            Result::NoProgram => "no-program",
            Result::Written => "written",
        }
    }

    fn fails(self) -> bool {
        matches!(self, Result::Differs | Result::Errors | Result::NoProgram)
    }
}

/// `partc test`
pub(super) fn test(args: &Test) -> std::result::Result<Exit, Trouble> {
    let walked = |takes: &dyn Fn(&Path) -> bool| {
        walk(&args.dir, takes, Ignored::Taken).map_err(|error| format!("{}: {error}", args.dir.display()))
    };
    if !args.dir.is_dir() {
        return Err(format!("{}: is no folder", args.dir.display()));
    }
    let programs = walked(&|path| !is_golden(path) && !is_output(path) && is_program(path, &args.common))?;
    let mut left = walked(&is_golden)?;
    let format = args.common.report.format.unwrap_or(Format::Human);
    if !matches!(format, Format::Human | Format::Concise | Format::Json) {
        return Err("`partc test` writes human, concise or json".to_owned());
    }
    if let Some(junit) = &args.junit {
        spares_sources(junit, programs.iter().chain(&left).map(PathBuf::as_path))?;
    }
    let reporter = Reporter::new(&args.common, &Findings::SHOWN, Stdout::Taken, None);
    let targets = Targets::new(args.junit.as_deref());
    let mut run = Run { args, format, cases: Vec::new(), reporter, targets, taken: BTreeMap::new(), internal: false };
    for program in &programs {
        if let Err(trouble) = run.one(program) {
            if run.targets.was_hit() {
                return Err(trouble);
            }
            run.reporter.trouble(trouble);
        }
        // Those of other targets are theirs.
        left.retain(|path| !target::ALL.iter().any(|target| *path == golden_of(program, target)));
    }
    for golden in left {
        run.show(&golden, Result::NoProgram, None)?;
    }
    run.finish()
}

fn is_golden(path: &Path) -> bool {
    target::ALL.iter().any(|target| path.to_string_lossy().ends_with(&format!(".{}", golden_extension(target))))
}

/// The golden output of a program for a target.
fn golden_of(program: &Path, target: &Target) -> PathBuf {
    program.with_extension(golden_extension(target))
}

/// Of targets with one extension the first has the plain name, the others are named.
fn golden_extension(target: &Target) -> String {
    let extension = target.extension;
    match target::ALL.iter().find(|first| first.extension == extension) {
        Some(first) if first.name != target.name => format!("golden.{}.{extension}", target.name),
        _ => format!("golden.{extension}"),
    }
}

/// The motion of a golden output and of what is printed now, where both can be read.
struct Change {
    steps: std::result::Result<[Vec<Step>; 2], String>,
}

impl Change {
    fn between(before: &str, now: &str) -> Change {
        let steps =
            |name: &str, text: &str| steps_of_text(text.as_bytes(), SAME).map_err(|stop| format!("{name}: {stop}"));
        Change { steps: steps("golden", before).and_then(|before| Ok([before, steps("now", now)?])) }
    }

    fn text(&self) -> String {
        match &self.steps {
            Ok([before, now]) => Difference::between(before, now, SAME).text(before, now, NAMES),
            Err(why) => format!("motion: {why}\n"),
        }
    }

    fn json(&self) -> Value {
        match &self.steps {
            Ok([before, now]) => {
                let mut found = Difference::between(before, now, SAME).json(before, now, NAMES);
                // By name, as there are always these two.
                let [golden, now] = [0, 1].map(|i| found["programs"][i].take());
                found["programs"].take();
                json!({ "same": found["same"], "differing": found["differing"], "largest": found["largest"], "golden": golden, "now": now })
            }
            Err(why) => json!({ "same": false, "unreadable": why }),
        }
    }
}

/// One program and what came of it.
struct Case {
    path: PathBuf,
    result: Result,
    motion: Option<Value>,
    /// What differs, in a few lines.
    text: Option<String>,
}

struct Run<'a> {
    args: &'a Test,
    format: Format,
    cases: Vec<Case>,
    reporter: Reporter,
    /// What it writes besides golden outputs.
    targets: Targets,
    /// Golden outputs, and the program each belongs to.
    taken: BTreeMap<PathBuf, PathBuf>,
    /// Some output was not what its program says.
    internal: bool,
}

impl Run<'_> {
    /// Compiles and compares one program.
    fn one(&mut self, program: &Path) -> std::result::Result<(), Trouble> {
        let Loaded { session, dialect, settings, files, .. } = load(program, &self.args.common)?;
        let golden = golden_of(program, settings.output.target);
        let shown = golden.display().to_string();
        if let Some(other) = self.taken.insert(golden.clone(), program.to_path_buf()) {
            return Err(format!("{} and {} have the same golden output {shown}", other.display(), program.display()));
        }
        let before = match fs::read_to_string(&golden) {
            Ok(text) => Some(text),
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => None,
            Err(error) => return Err(format!("{shown}: {error}")),
        };
        if before.is_none() && !self.args.update {
            return self.show(program, Result::NoGolden, None);
        }
        let mut now = Vec::new();
        if let Err(failure) = session.compile(dialect, &settings, &files, &mut now, None) {
            self.internal |= matches!(failure, Failure::Mismatch(_));
            return Err(format!("{shown}: {failure}"));
        }
        self.targets.spare(program, &self.args.common, &files)?;
        let now = String::from_utf8(now).map_err(|error| format!("{shown}: {error}"))?;
        if session.diags.has_errors() {
            self.reporter.session(session);
            // A program called by others need not compile on its own.
            let result = if before.is_some() { Result::Errors } else { Result::NoGolden };
            return self.show(program, result, None);
        }
        if self.args.update && before.as_deref() != Some(now.as_str()) {
            write(&golden, &now).map_err(|error| format!("{shown}: {error}"))?;
            return self.show(program, Result::Written, None);
        }
        let before = before.unwrap_or_default();
        if body(&before) == body(&now) {
            self.show(program, Result::Same, None)
        } else {
            self.show(program, Result::Differs, Some((&shown, &before, &now)))
        }
    }

    /// Prints a result, with what differs.
    fn show(
        &mut self,
        path: &Path,
        result: Result,
        difference: Option<(&str, &str, &str)>,
    ) -> std::result::Result<(), Trouble> {
        let change = difference.map(|(_, before, now)| Change::between(before, now));
        let json = change.as_ref().map(Change::json);
        let short = change.as_ref().map(Change::text);
        self.cases.push(Case { path: path.to_path_buf(), result, motion: json, text: short });
        if self.format == Format::Json || (self.args.common.report.quiet && !result.fails()) {
            return Ok(());
        }
        let mut text = format!("{:10} {}\n", result.word(), path.display());
        if let (Some((golden, before, now)), Some(change)) = (difference, change)
            && self.format == Format::Human
        {
            text += &text_difference(golden, before, now);
            text += &change.text();
        }
        print(harmless_lines(&text).as_bytes()).map(drop)
    }

    fn finish(self) -> std::result::Result<Exit, Trouble> {
        let count = |result| self.cases.iter().filter(|case| case.result == result).count() as u32;
        let failed = self.cases.iter().filter(|case| case.result.fails()).count() as u32;
        let (same, written) = (count(Result::Same), count(Result::Written));
        let nothing = failed + same + written == 0;
        if self.format == Format::Json {
            let cases: Vec<Value> = self
                .cases
                .iter()
                .map(|Case { path, result, motion, .. }| {
                    json!({ "file": path.to_string_lossy(), "result": result.word(), "motion": motion })
                })
                .collect();
            let report =
                json!({ "version": 1, "cases": cases, "failed": failed, "troubles": self.reporter.troubles() });
            print(escaped_json(&format!("{report}\n")).as_bytes())?;
        } else if !self.args.common.report.quiet {
            let mut parts = vec![format!("{same} same")];
            for (n, what) in [
                (count(Result::Differs), "different"),
                (count(Result::Errors), "with errors"),
                (count(Result::NoProgram), "without a program"),
                (count(Result::NoGolden), "without a golden output"),
                (written, "written"),
            ] {
                if n > 0 {
                    parts.push(format!("{n} {what}"));
                }
            }
            let all = counted(self.cases.len() as u32, "case", "cases");
            print(format!("{all}: {}\n", parts.join(", ")).as_bytes())?;
        }
        if let Some(file) = &self.args.junit {
            write(file, &self.junit()).map_err(|error| format!("{}: {error}", file.display()))?;
        }
        if self.internal {
            return Ok(Exit::Internal);
        }
        if !self.reporter.troubles().is_empty() {
            return Ok(Exit::Usage);
        }
        if nothing {
            let dir = self.args.dir.display();
            return Err(format!("{dir}: no golden output to compare with; `partc test --update` writes them"));
        }
        Ok(if failed > 0 { Exit::Errors } else { Exit::Clean })
    }
}

impl Run<'_> {
    /// The results as JUnit XML: a program is a test case.
    fn junit(&self) -> String {
        let troubles = self.reporter.troubles();
        let mut cases = String::new();
        for case in &self.cases {
            let name = escaped(&case.path.to_string_lossy().replace('\\', "/"));
            cases += &format!("    <testcase classname=\"partc test\" name=\"{name}\">");
            if case.result.fails() {
                let text = case.text.as_deref().unwrap_or_default();
                cases += &format!("<failure message=\"{}\">{}</failure>", case.result.word(), escaped(text));
            } else if case.result == Result::NoGolden {
                cases += "<skipped/>";
            }
            cases += "</testcase>\n";
        }
        for trouble in troubles {
            let text = escaped(trouble);
            cases += &format!(
                "    <testcase classname=\"partc test\" name=\"{text}\"><error message=\"{text}\"/></testcase>\n"
            );
        }
        let failures = self.cases.iter().filter(|case| case.result.fails()).count();
        let (tests, errors) = (self.cases.len() + troubles.len(), troubles.len());
        let counts = format!("tests=\"{tests}\" failures=\"{failures}\" errors=\"{errors}\"");
        format!(
            "{HEAD_OF_XML}<testsuites {counts}>\n  <testsuite name=\"partc test\" {counts}>\n{cases}  </testsuite>\n</testsuites>\n"
        )
    }
}

fn write(path: &Path, text: &str) -> std::io::Result<()> {
    let mut out = Destination::open(path)?;
    out.append(text.as_bytes())?;
    out.commit()
}

/// The lines that matter: neither the version nor the hash in the head, whatever the line ends.
fn body(program: &str) -> Vec<&str> {
    program.lines().filter(|line| !names_source(line.as_bytes())).collect()
}

/// The lines that differ, with two lines around them.
fn text_difference(golden: &str, before: &str, now: &str) -> String {
    let lines = |program: &str| body(program).iter().map(|line| format!("{line}\n")).collect::<String>();
    let (before, now) = (lines(before), lines(now));
    let difference = TextDiff::configure()
        // Programs of a million lines that differ everywhere are not worth minutes.
        .timeout(std::time::Duration::from_secs(2))
        .diff_lines(&before, &now);
    let text = difference.unified_diff().context_radius(2).header(golden, "now").to_string();
    let mut shown: String = text.lines().take(MOST_LINES).map(|line| format!("{line}\n")).collect();
    let more = text.lines().count().saturating_sub(MOST_LINES);
    if more > 0 {
        shown += &format!("... {more} more lines\n");
    }
    shown
}
