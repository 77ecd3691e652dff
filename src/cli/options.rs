//! Options that several commands share.

use std::path::PathBuf;

use clap::builder::{PossibleValue, TypedValueParser};
use clap::{Args as ClapArgs, ValueEnum};

use crate::diag::{self, report::Kind};
use crate::emit::stats::Model;

/// The list of the files that were read.
#[derive(Debug, Default, ClapArgs)]
pub(super) struct Deps {
    /// Write which files were read: programs, called ones, configuration and tables; only when the run succeeds
    #[arg(long, value_name = "FILE")]
    pub deps: Option<PathBuf>,
    /// Form of that list: rules of make, which ninja reads, too, or json, which also names files that were looked for
    #[arg(long, value_enum, default_value = "make", requires = "deps")]
    pub deps_format: DepsFormat,
}

/// Forms of lists of files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum, Default)]
pub(super) enum DepsFormat {
    #[default]
    Make,
    Json,
}

/// Which programs, and how many at a time.
#[derive(Debug, Default, ClapArgs)]
pub(super) struct Many {
    /// More programs and folders, one a line; `-` reads the list from standard input
    #[arg(long, value_name = "FILE")]
    pub files_from: Option<PathBuf>,
    /// The i-th of n parts of all programs, told apart by their names: `--shard 1/4`
    #[arg(long, value_name = "I/N", value_parser = shard)]
    pub shard: Option<Shard>,
    /// Programs at a time [default: one a core]
    #[arg(short, long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub jobs: Option<u16>,
}

/// One of so many parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Shard {
    /// From 1.
    pub part: u32,
    pub of: u32,
}

fn shard(text: &str) -> Result<Shard, String> {
    let (part, of) = text.split_once('/').ok_or("write which part of how many: `2/5`")?;
    let number = |text: &str| text.parse::<u32>().map_err(|_| format!("`{text}` is no number of parts"));
    let shard = Shard { part: number(part)?, of: number(of)? };
    if (1..=shard.of).contains(&shard.part) { Ok(shard) } else { Err(format!("there is no part {text}")) }
}

/// The machine that times are reckoned for.
#[derive(Debug, Clone, Copy, ClapArgs)]
pub(super) struct Machine {
    /// Rapid traverse of the machine
    #[arg(long, value_name = "MM/MIN", default_value_t = 10_000.0, value_parser = above_zero)]
    pub rapid: f64,
    /// Acceleration along the path
    #[arg(long, value_name = "M/S²", default_value_t = 1.0, value_parser = above_zero)]
    pub acceleration: f64,
}

/// The same with what `stats` adds up besides moves.
#[derive(Debug, Clone, Copy, ClapArgs)]
pub(super) struct Timing {
    #[command(flatten)]
    pub machine: Machine,
    /// Time of a tool change
    #[arg(long, value_name = "SECONDS", default_value_t = 0.0, value_parser = seconds)]
    pub tool_change: f64,
}

impl Machine {
    pub fn model(self) -> Model {
        Model { rapid: self.rapid, acceleration: self.acceleration, ..Model::default() }
    }
}

impl Timing {
    pub fn model(self) -> Model {
        Model { tool_change: self.tool_change, ..self.machine.model() }
    }
}

fn above_zero(text: &str) -> Result<f64, String> {
    let value: f64 = text.parse().map_err(|_| "a number".to_owned())?;
    if value.is_finite() && value > 0.0 { Ok(value) } else { Err("a number above 0".to_owned()) }
}

fn seconds(text: &str) -> Result<f64, String> {
    let value: f64 = text.parse().map_err(|_| "a number of seconds".to_owned())?;
    if value.is_finite() && value >= 0.0 { Ok(value) } else { Err("0 or more seconds".to_owned()) }
}

#[derive(Debug, Clone, ClapArgs)]
pub(super) struct Common {
    /// Language of the input
    #[arg(long, default_value = "auto", value_parser = dialects())]
    pub dialect: String,
    /// Control that shall run the output
    #[arg(long, value_name = "TARGET", value_parser = crate::target::NAMES)]
    pub target: Option<String>,
    /// Block numbers in steps of N, as `[output] line_numbers`
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(0..=1000))]
    pub numbers: Option<u32>,
    /// Configuration file, instead of the nearest partc.toml
    #[arg(long, value_name = "FILE", conflicts_with = "isolated")]
    pub config: Option<PathBuf>,
    /// Use no configuration file
    #[arg(long)]
    pub isolated: bool,
    /// Tool table: TOOL.T or tool.tbl
    #[arg(long, value_name = "FILE")]
    pub tools: Option<PathBuf>,
    /// Radius compensation: `resolve` or `control`
    #[arg(long, value_parser = ["resolve", "control"])]
    pub compensation: Option<String>,
    #[command(flatten)]
    pub report: Report,
    /// Name of what standard input holds
    #[arg(long, value_name = "NAME")]
    pub stdin_filename: Option<PathBuf>,
}

impl Common {
    /// The options of a caller that is no command line.
    pub fn asking(dialect: Option<&str>, target: Option<&str>) -> Common {
        let report = Report { format: None, select: None, ignore: None, quiet: true, color: Color::Never };
        Common {
            dialect: dialect.unwrap_or("auto").to_owned(),
            target: target.map(str::to_owned),
            numbers: None,
            config: None,
            isolated: false,
            tools: None,
            compensation: None,
            report,
            stdin_filename: None,
        }
    }
}

/// How findings are shown.
#[derive(Debug, Clone, ClapArgs)]
pub(super) struct Report {
    /// How findings are written [default: human; github in a workflow of GitHub Actions]
    #[arg(long, value_enum)]
    pub format: Option<Format>,
    /// Findings that are reported: codes, beginnings of codes, names, `default`, `all`; as `[lint] select`
    #[arg(long, value_name = "CODES", value_delimiter = ',')]
    pub select: Option<Vec<String>>,
    /// Findings that are not reported; as `[lint] ignore`
    #[arg(long, value_name = "CODES", value_delimiter = ',')]
    pub ignore: Option<Vec<String>>,
    /// Show errors only
    #[arg(short, long)]
    pub quiet: bool,
    #[arg(long, value_enum, default_value = "auto")]
    pub color: Color,
}

/// What the findings of a run come to.
#[derive(Debug, ClapArgs)]
pub(super) struct Findings {
    /// One more report, in a file; may be given several times: `--report sarif=findings.sarif`
    #[arg(long = "report", value_name = "FORMAT=FILE", value_parser = one_more)]
    pub more: Vec<(Format, PathBuf)>,
    /// The least severity of a finding that makes the run fail: exit code 1, and no output
    #[arg(long, value_enum, default_value = "error")]
    pub fail_on: Severity,
    /// Exit code 0 whatever is found in programs
    #[arg(long)]
    pub exit_zero: bool,
    /// How often each code was found, at the end
    #[arg(long)]
    pub statistics: bool,
    /// Findings of a program that are shown where there are several programs [default: 20]
    #[arg(long, value_name = "N")]
    pub max: Option<usize>,
}

impl Findings {
    /// Those of a command that only shows what it found.
    pub const SHOWN: Findings =
        Findings { more: Vec::new(), fail_on: Severity::Error, exit_zero: false, statistics: false, max: None };
}

fn one_more(text: &str) -> Result<(Format, PathBuf), String> {
    let (format, file) = text.split_once('=').ok_or("write the format and the file: `sarif=findings.sarif`")?;
    let format = Format::from_str(format, false)?;
    if file.is_empty() || file == "-" {
        return Err("name a file; `--format` writes to standard output".to_owned());
    }
    Ok((format, PathBuf::from(file)))
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    /// With the block, for people
    Human,
    /// A line each
    Concise,
    /// One object
    Json,
    /// An object a line
    Jsonl,
    /// Annotations of GitHub Actions
    Github,
    /// Code Quality report of GitLab
    Gitlab,
    /// SARIF 2.1.0
    Sarif,
    /// JUnit XML, a test case a program
    Junit,
    /// Checkstyle XML
    Checkstyle,
    /// Moves as comma-separated values
    #[value(skip)]
    Csv,
    /// Moves as a stream or a file of Arrow
    #[value(skip)]
    Arrow,
    /// Moves as a Parquet file
    #[value(skip)]
    Parquet,
}

impl Format {
    /// The document that is made, where it is none for people.
    pub fn kind(self) -> Option<Kind> {
        Some(match self {
            Format::Human | Format::Concise | Format::Csv | Format::Arrow | Format::Parquet => return None,
            Format::Json => Kind::Json,
            Format::Jsonl => Kind::JsonLines,
            Format::Github => Kind::GitHub,
            Format::Gitlab => Kind::GitLab,
            Format::Sarif => Kind::Sarif,
            Format::Junit => Kind::JUnit,
            Format::Checkstyle => Kind::Checkstyle,
        })
    }
}

/// Forms of a list that holds no findings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum ListFormat {
    Human,
    Concise,
    Json,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Severity {
    Error,
    Warning,
    Note,
}

impl Severity {
    pub fn of_findings(self) -> diag::Severity {
        match self {
            Severity::Error => diag::Severity::Error,
            Severity::Warning => diag::Severity::Warning,
            Severity::Note => diag::Severity::Note,
        }
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Color {
    Auto,
    Always,
    Never,
}

/// Values of `--format` of `partc trace`.
#[derive(Debug, Clone)]
pub(super) struct TraceFormats;

impl TraceFormats {
    const ALL: [(&str, &str, Format); 6] = [
        ("jsonl", "An object a move", Format::Jsonl),
        ("csv", "Comma-separated values (RFC 4180)", Format::Csv),
        ("arrow", "Arrow IPC: a file, and a stream on standard output", Format::Arrow),
        ("parquet", "Parquet, compressed with Snappy", Format::Parquet),
        ("human", "Moves as jsonl; findings with the block, for people", Format::Human),
        ("concise", "Moves as jsonl; findings a line each", Format::Concise),
    ];
}

impl TypedValueParser for TraceFormats {
    type Value = Format;

    fn parse_ref(
        &self,
        command: &clap::Command,
        arg: Option<&clap::Arg>,
        value: &std::ffi::OsStr,
    ) -> Result<Format, clap::Error> {
        // Its errors name the values.
        let names = clap::builder::PossibleValuesParser::new(Self::ALL.map(|(name, _, _)| name));
        let name = names.parse_ref(command, arg, value)?;
        Ok(Self::ALL.into_iter().find(|known| known.0 == name).map_or(Format::Jsonl, |known| known.2))
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        Some(Box::new(Self::ALL.into_iter().map(|(name, help, _)| PossibleValue::new(name).help(help))))
    }
}

/// `auto` and the name of every dialect.
fn dialects() -> clap::builder::PossibleValuesParser {
    let names = std::iter::once("auto").chain(crate::dialect::ALL.iter().map(|dialect| dialect.id));
    clap::builder::PossibleValuesParser::new(names)
}
