//! The findings of a command: on the terminal, as documents, and as an exit code.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::time::Instant;

use crate::diag::render::terminal::Style;
use crate::diag::render::{brief, concise};
use crate::diag::report::{Checked, Counts, Document};
use crate::diag::{Answer, Diagnostic, Severity, Trail, Values, codes};
use crate::driver::Session;
use crate::machine::keys::choices;
use crate::text::decode::harmless_lines;
use crate::text::{FileId, Sources};

use super::answers::{Request, requests};
use super::inputs::Input;
use super::listing::print;
use super::made::is_output;
use super::options::{Color, Common, Findings, Format};
use super::output::Destination;
use super::paths::{is_source_name, real, same_file};
use super::progress::{AGAIN, CLEARED, QUIET};
use super::summary::{Line, Summary, USUAL};
use super::{Exit, Trouble, say};

/// Characters in a line on the terminal.
const WIDTH: usize = 100;
/// Fewer bytes show no speed: what they took was mostly the start.
const LEAST_FOR_SPEED: u64 = 5_000_000;

/// How findings shall look: all that a thread needs to know that makes them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Look {
    /// Human or concise: the text of one program.
    text: Option<Format>,
    /// The same for files, where nothing is coloured.
    human: bool,
    concise: bool,
    /// Some document wants them.
    documents: bool,
    quiet: bool,
    color: bool,
    fails: Severity,
    /// Several programs, and the user chose no format: a line a finding.
    list: bool,
}

/// What one program came to, ready to be shown.
#[derive(Debug)]
pub(super) struct Presented {
    checked: Checked,
    text: String,
    /// The same of one among several programs.
    lines: Vec<Line>,
    /// Keys that its errors ask for.
    asked: Vec<Request>,
    /// The same for files, where somebody wants it.
    human: String,
    concise: String,
    /// Codes of its findings, each with how often it was found.
    codes: BTreeMap<&'static str, u32>,
}

impl Look {
    /// Does a run that found so much give an output?
    pub(super) fn fails(&self, session: &Session) -> bool {
        Counts::of(&session.diags).at_least(self.fails) > 0 || session.diags.has_errors()
    }

    /// Looks everything up in the session, which ends here.
    pub(super) fn present(&self, session: Session) -> Presented {
        let asked = if self.quiet { Vec::new() } else { requests(&session, &|_| None) };
        let Session { sources, diags, trail } = session;
        let counts = Counts::of(&diags);
        let file = sources.name(FileId(0));
        let mut list = diags.into_sorted();
        let mut codes = BTreeMap::new();
        for found in &list {
            *codes.entry(found.code.id).or_default() += 1;
        }
        if self.quiet {
            list.retain(|found| found.severity == Severity::Error);
        }
        let written = |format: Format, color: bool| {
            let mut text = String::new();
            let style = (format == Format::Human && !list.is_empty()).then(|| Style::new(color, WIDTH));
            for found in &list {
                text += &match &style {
                    Some(style) => style.render(found, &sources, &trail),
                    None => concise(found, &sources, &trail),
                };
                text.push('\n');
            }
            if counts.not_shown > 0 && (counts.errors > 0 || !self.quiet) {
                let more = counted(counts.not_shown, "more finding is", "more findings are");
                text += &format!("{}: {more} not shown\n", sources.shown(FileId(0)));
            }
            text
        };
        let lines = if self.list { lines(&list, &sources, &trail) } else { Vec::new() };
        let text = self.text.filter(|_| !self.list).map(|format| written(format, self.color)).unwrap_or_default();
        let human = if self.human { written(Format::Human, false) } else { String::new() };
        let concise = if self.concise { written(Format::Concise, false) } else { String::new() };
        let shown = if self.documents { list.as_slice() } else { &[] };
        Presented {
            checked: Checked::new(&file, shown, counts, (&sources, &trail), choices),
            text,
            human,
            concise,
            lines,
            asked,
            codes,
        }
    }
}

/// The findings of one of many programs: errors first, and what is found again in other blocks told once, with how often.
fn lines(list: &[Diagnostic], sources: &Sources, trail: &Trail) -> Vec<Line> {
    let mut met: BTreeMap<(&str, u16, String, Option<&str>), usize> = BTreeMap::new();
    let mut causes: Vec<(Diagnostic, u32)> = Vec::new();
    for found in list {
        let cause = (found.code.id, found.label.loc.file.0, found.text().into_owned(), found.help.as_deref());
        match met.get(&cause).and_then(|at| causes.get_mut(*at)) {
            Some((first, findings)) => {
                first.times = first.times.saturating_add(found.times);
                *findings += 1;
            }
            None => {
                met.insert(cause, causes.len());
                causes.push((found.clone(), 1));
            }
        }
    }
    causes.sort_by_key(|(found, _)| Reverse(found.severity));
    causes.iter().map(|(found, findings)| line(found, *findings, sources, trail)).collect()
}

/// A finding as one of many: what a configuration answers stands below all of them.
fn line(found: &Diagnostic, findings: u32, sources: &Sources, trail: &Trail) -> Line {
    let told = found.answers.iter().filter(|answer| !matches!(answer.values, Values::FolderOf(_)));
    let keys: Vec<String> = told.map(key).collect();
    let text = if keys.is_empty() { concise(found, sources, trail) } else { brief(found, sources, trail) };
    Line { text, code: found.code.id, keys, findings }
}

/// `[output] pass_m = [25]`
fn key(answer: &Answer) -> String {
    let (table, key) = answer.place();
    match &answer.values {
        Values::Item(item) => format!("[{table}] {key} = [{item}]"),
        _ => format!("[{table}] {key}"),
    }
}

impl Presented {
    /// Does a configuration answer some of its errors?
    pub(super) fn asks(&self) -> bool {
        !self.asked.is_empty()
    }

    /// Asks for all that the program needs, which no single run shows.
    pub(super) fn ask(&mut self, all: Vec<Request>) {
        self.asked = all;
    }
}

/// Where the findings of `--format` go.
enum Main {
    /// Text, to stderr as it comes.
    Terminal,
    /// Text, to a file in the end.
    Text(String),
    Document(Box<dyn Document>),
}

/// A report in a file beside the one of `--format`.
enum Further {
    Human(String),
    Concise(String),
    Document(Box<dyn Document>),
}

/// Collects and prints the findings of a command.
pub(super) struct Reporter {
    look: Look,
    main: Main,
    /// File of the report, instead of the terminal or standard output.
    output: Option<PathBuf>,
    /// Further reports, each with its file.
    more: Vec<(Further, PathBuf)>,
    counts: Counts,
    codes: BTreeMap<&'static str, u32>,
    summary: Summary,
    /// Findings of a program that are shown.
    most: usize,
    /// Programs that were written.
    written: u32,
    programs: u32,
    bytes: u64,
    statistics: bool,
    exit_zero: bool,
    /// A clean program is worth a word to somebody at a terminal.
    tells_clean: bool,
    /// What is no finding in a program, such as a file that cannot be read.
    troubles: Vec<Trouble>,
    /// partc itself was at fault.
    internal: bool,
    started: Instant,
    /// When progress was shown last.
    shown: Option<Instant>,
}

/// Is somebody else using standard output?
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Stdout {
    Free,
    Taken,
}

/// The format that holds: a workflow of GitHub Actions gets annotations unless the user says otherwise.
fn format(common: &Common, stdout: Stdout) -> Format {
    let in_workflow = || std::env::var_os("GITHUB_ACTIONS").is_some_and(|value| value == "true");
    match common.report.format {
        Some(format) => format,
        None if stdout == Stdout::Free && in_workflow() => Format::Github,
        None => Format::Human,
    }
}

impl Reporter {
    /// A reporter that has found nothing yet.
    pub(super) fn new(common: &Common, findings: &Findings, stdout: Stdout, output: Option<&Path>) -> Reporter {
        let args = &common.report;
        let fails = findings.fail_on.of_findings();
        let format = format(common, stdout);
        let kind = format.kind();
        let output = output.filter(|path| *path != Path::new("-")).map(Path::to_path_buf);
        let color = match args.color {
            Color::Always => true,
            Color::Never => false,
            Color::Auto => output.is_none() && io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none(),
        };
        let main = match kind {
            Some(kind) => Main::Document(kind.document(fails)),
            None if output.is_some() => Main::Text(String::new()),
            None => Main::Terminal,
        };
        let further = |(format, file): &(Format, PathBuf)| {
            let report = match format.kind() {
                Some(kind) => Further::Document(kind.document(fails)),
                None if *format == Format::Human => Further::Human(String::new()),
                None => Further::Concise(String::new()),
            };
            (report, file.clone())
        };
        let wanted = |format: Format| findings.more.iter().any(|(further, _)| *further == format);
        let look = Look {
            text: kind.is_none().then_some(format),
            human: wanted(Format::Human),
            concise: wanted(Format::Concise),
            documents: kind.is_some() || findings.more.iter().any(|(further, _)| further.kind().is_some()),
            quiet: args.quiet,
            color,
            fails,
            list: false,
        };
        Reporter {
            look,
            main,
            output,
            more: findings.more.iter().map(further).collect(),
            counts: Counts::default(),
            codes: BTreeMap::new(),
            summary: Summary::default(),
            most: findings.max.unwrap_or(USUAL),
            written: 0,
            programs: 0,
            bytes: 0,
            statistics: findings.statistics,
            exit_zero: findings.exit_zero,
            tells_clean: false,
            troubles: Vec::new(),
            internal: false,
            started: Instant::now(),
            shown: None,
        }
    }

    /// The same for so many programs.
    pub(super) fn look_at(&mut self, programs: usize, common: &Common) -> Look {
        self.look.list = programs > 1 && common.report.format.is_none() && self.look.text.is_some();
        self.look
    }

    /// The findings are all that the command gives.
    pub(super) fn only_checks(&mut self) {
        self.tells_clean = true;
    }

    /// A program was written.
    pub(super) fn wrote(&mut self, outputs: u32) {
        self.written += outputs;
    }

    pub(super) fn look(&self) -> Look {
        self.look
    }

    /// Keeps its files off what is no report: the programs themselves, and what partc makes of them.
    ///
    /// # Errors
    /// A file that would be lost.
    pub(super) fn spares(&self, inputs: &[Input], outputs: &BTreeSet<PathBuf>) -> Result<(), Trouble> {
        let files = self.output.iter().chain(self.more.iter().map(|(_, file)| file));
        let mut taken = BTreeSet::new();
        for file in files.filter(|file| file.as_path() != Path::new("/dev/null")) {
            let shown = file.display();
            if !taken.insert(real(file)) {
                return Err(format!("{shown}: two reports cannot go to one file"));
            }
            if outputs.contains(&real(file)) {
                return Err(format!("{shown}: the report would replace what is made of a program; name another file"));
            }
            spares_sources(file, inputs.iter().map(|input| input.path.as_path()))?;
        }
        Ok(())
    }

    /// Files of its reports.
    pub(super) fn files(&self) -> impl Iterator<Item = &Path> {
        self.output.iter().chain(self.more.iter().map(|(_, file)| file)).map(PathBuf::as_path)
    }

    /// Takes what a session found.
    pub(super) fn session(&mut self, session: Session) {
        self.take(self.look.present(session));
    }

    /// Takes what one program came to, in the order of the inputs.
    pub(super) fn take(&mut self, presented: Presented) {
        let Presented { checked, mut text, human, concise, lines, asked, codes } = presented;
        if self.look.list {
            let name = harmless_lines(&checked.file);
            text = self.summary.lines(&name, &lines, checked.counts.not_shown, self.most);
        }
        self.summary.ask(&checked.file, &asked);
        self.programs += 1;
        self.bytes += checked.bytes;
        self.counts.add(&checked.counts);
        for (code, times) in codes {
            *self.codes.entry(code).or_default() += times;
        }
        match &mut self.main {
            Main::Document(document) => document.program(&checked),
            Main::Text(report) => report.push_str(&text),
            Main::Terminal if text.is_empty() => {}
            Main::Terminal => {
                self.clear_progress();
                let _ = io::stderr().lock().write_all(text.as_bytes());
            }
        }
        for (report, _) in &mut self.more {
            match report {
                Further::Human(report) => report.push_str(&human),
                Further::Concise(report) => report.push_str(&concise),
                Further::Document(document) => document.program(&checked),
            }
        }
    }

    /// Prints trouble that is no finding; the command goes on with what is left.
    pub(super) fn trouble(&mut self, trouble: Trouble) {
        // One configuration may be at fault for many programs.
        if !self.troubles.contains(&trouble) {
            self.clear_progress();
            say(&format!("partc: {trouble}"));
            self.troubles.push(trouble);
        }
    }

    /// A line about a file.
    pub(super) fn say(&mut self, line: &str) {
        self.clear_progress();
        say(line);
    }

    /// partc itself was at fault: nothing else matters for the exit code.
    pub(super) fn internal(&mut self) {
        self.internal = true;
    }

    /// What was no finding.
    pub(super) fn troubles(&self) -> &[Trouble] {
        &self.troubles
    }

    /// Shows on a terminal that long work goes on.
    pub(super) fn progress(&mut self, done: usize, all: usize) {
        let now = Instant::now();
        let due = self.shown.map_or(now - self.started > QUIET, |shown| now - shown > AGAIN);
        if due && done < all && io::stderr().is_terminal() {
            self.shown = Some(now);
            let _ = write!(io::stderr(), "\r{done} of {all} programs");
        }
    }

    fn clear_progress(&mut self) {
        if self.shown.is_some() {
            let _ = write!(io::stderr(), "{CLEARED}");
        }
    }

    /// Prints the end of the report.
    ///
    /// # Errors
    /// A report that cannot be written.
    pub(super) fn finish(mut self) -> Result<Exit, Trouble> {
        self.clear_progress();
        let failed = self.counts.at_least(self.look.fails) > 0 && !self.exit_zero;
        let exit = match (self.troubles.is_empty(), failed) {
            (false, _) => Exit::Usage,
            (true, true) => Exit::Errors,
            (true, false) => Exit::Clean,
        };
        let exit = if self.internal { Exit::Internal } else { exit };
        let statistics = if self.statistics { self.table() } else { String::new() };
        let summary = self.summary();
        match self.main {
            Main::Terminal => {}
            Main::Text(text) => write(self.output.as_deref(), &text)?,
            Main::Document(document) => write(self.output.as_deref(), &document.finish(&self.troubles))?,
        }
        for (report, file) in self.more {
            let text = match report {
                Further::Human(text) | Further::Concise(text) => text,
                Further::Document(document) => document.finish(&self.troubles),
            };
            write(Some(&file), &text)?;
        }
        if !statistics.is_empty() {
            say(statistics.trim_end());
        }
        if !self.look.quiet && self.counts.errors > 0 {
            let table = if self.look.list { self.summary.table() } else { String::new() };
            let text = table + &self.summary.to_paste(self.look.list);
            if !text.is_empty() {
                say(text.trim_end());
                say("");
            }
        }
        if let Some(summary) = summary.filter(|_| !self.look.quiet) {
            say(&summary);
        }
        Ok(exit)
    }

    /// How much there was in one line; nothing for one clean program.
    fn summary(&self) -> Option<String> {
        let Counts { errors, warnings, .. } = self.counts;
        if self.programs < 2 && errors + warnings == 0 {
            // Off a terminal no news is good news.
            let is_seen = self.tells_clean && self.programs == 1 && io::stderr().is_terminal();
            let told = if self.counts.notes == 0 { "no findings" } else { "no errors, no warnings" };
            return is_seen.then(|| format!("1 program, {told}"));
        }
        let counts = format!("{}, {}", counted(errors, "error", "errors"), counted(warnings, "warning", "warnings"));
        let time = self.started.elapsed();
        let speed = if time > QUIET && self.bytes >= LEAST_FOR_SPEED {
            format!(", {:.1} MB/s", self.bytes as f64 / 1e6 / time.as_secs_f64())
        } else {
            String::new()
        };
        let written = if self.written > 0 { format!("{} written, ", self.written) } else { String::new() };
        Some(if self.programs < 2 { counts } else { format!("{} programs, {written}{counts}{speed}", self.programs) })
    }

    /// The codes, the most frequent first.
    fn table(&self) -> String {
        let mut rows: Vec<_> = self.codes.iter().collect();
        rows.sort_by_key(|(code, times)| (Reverse(**times), **code));
        let row = |(code, times): (&&str, &u32)| {
            let (severity, name, title) =
                codes::find(code).map_or(("", "", ""), |code| (code.severity.word(), code.name, code.title));
            format!("{times:7} {code} {severity:7} {name}: {title}\n")
        };
        let mut text: String = rows.into_iter().map(row).collect();
        if self.counts.not_shown > 0 {
            text += &format!("{:7} not told apart: a program shows its first findings only\n", self.counts.not_shown);
        }
        text
    }
}

/// Writes a report to its file, or to standard output.
fn write(file: Option<&Path>, text: &str) -> Result<(), Trouble> {
    let Some(file) = file else { return print(text.as_bytes()).map(drop) };
    let written =
        Destination::open(file).and_then(|mut out| out.write_all(text.as_bytes()).and_then(|()| out.commit()));
    written.map_err(|error| format!("{}: {error}", file.display()))
}

/// A number with its word: `1 error`, `2 errors`.
pub(super) fn counted(n: u32, one: &str, many: &str) -> String {
    format!("{n} {}", if n == 1 { one } else { many })
}

/// Refuses a report in the place of a source.
///
/// # Errors
/// A file that would be lost.
pub(super) fn spares_sources<'p>(file: &Path, mut inputs: impl Iterator<Item = &'p Path>) -> Result<(), Trouble> {
    // By its name only: a report for people quotes blocks.
    if is_source_name(file) || inputs.any(|input| same_file(input, file)) || is_output(file) {
        return Err(format!(
            "{}: the report would replace a part program, a table or a configuration; name another file",
            file.display()
        ));
    }
    Ok(())
}
