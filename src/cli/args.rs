//! The arguments.

use std::ffi::OsString;
use std::path::PathBuf;

use clap::builder::{PossibleValue, TypedValueParser};
use clap::{Args as ClapArgs, CommandFactory, FromArgMatches, Parser, Subcommand, ValueEnum};

use crate::diag::{self, report::Kind};

/// Compiles CNC part programs of control dialects into plain, fully resolved G-code, and lints them
#[derive(Debug, Parser)]
#[command(name = "partc", version, about, max_term_width = 100, propagate_version = true)]
pub(super) struct Args {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Compile part programs to plain G-code
    Compile(Compile),
    /// Report findings and write nothing; folders are walked
    Check(Check),
    /// Read all programs of a folder and write a commented partc.toml with what they need
    ///
    /// Each line names the program and the block that asks for it. Nothing is guessed: what only you know is left empty and
    /// commented. Write the values, take the `#` away, and compile.
    Init(Init),
    /// Write the resolved moves as JSON Lines or as a table
    ///
    /// A row for each move: where it begins and ends, centre, feed, spindle, tool, length, time, block. The columns of csv, arrow and
    /// parquet are those of docs/trace.md. `--format` is that of the moves here, and of the findings with human or concise.
    Trace(Trace),
    /// Count cutting and rapid ways, times, tools and extents
    ///
    /// The time is that of a simple machine: each move speeds up and slows down evenly, moves that go on in nearly the same
    /// direction are passed without a stop, and between others the machine stops.
    Stats(Stats),
    /// Draw the resolved path as an SVG picture
    Plot(Plot),
    /// Write one page with the path, the findings, the G-code, tools and figures
    ///
    /// The page is a file that needs nothing else: it can be sent, kept with an order, and opened without a network. Of a program
    /// with errors it shows them, and neither path nor G-code; the exit code is that of `compile`.
    Report(Page),
    /// Compile the programs of a folder and compare with the golden outputs beside them
    ///
    /// PART.H belongs to PART.golden.ngc, for grbl PART.golden.gcode, for grblhal PART.golden.grblhal.gcode; those of other
    /// targets are passed over. A difference is shown as text and as motion; version and source hash in the head do not
    /// count.
    Test(Test),
    /// Compare what two programs have the machine do
    ///
    /// Each is a part program in any language, or plain G-code such as partc prints (.ngc, .gcode, .nc, .tap). Moves, arcs, feeds,
    /// tools, speeds and functions are compared, whatever words say them; exit code 1 if something differs.
    Diff(Diff),
    /// Language server for editors, on standard input and output
    Lsp(Common),
    /// Show the configuration in force, or its JSON Schema
    Config(Config),
    /// Explain a diagnostic code, or a key of partc.toml
    Explain {
        /// Code such as K2101, its name, or a key such as control.feed
        code: String,
        #[arg(long, value_enum, default_value = "human")]
        format: ListFormat,
    },
    /// List all diagnostic codes
    Rules {
        #[arg(long, value_enum, default_value = "human")]
        format: ListFormat,
    },
    /// List the targets and what each can say
    Targets {
        #[arg(long, value_enum, default_value = "human")]
        format: ListFormat,
    },
    /// Print tool, preset, datum and point tables and machine data in one form; convert them
    Tools(ToolsArgs),
    /// Check, and check again when a file changes
    Watch(Watch),
    /// Print a key for each program: a hash of all that its results depend on
    ///
    /// That are the version of partc, the program, what it calls, the configuration and the tables by their contents, and which
    /// files were looked for and not found. Neither times nor the folder count: the same on two machines.
    Key(Key),
    /// Put the reports of shards together: what `check --shard i/n` wrote becomes what `check` would have written
    ///
    /// Reports are json, sarif, junit, gitlab or checkstyle, all of one form, and ordered by the paths of their programs. The exit
    /// code says whether they could be put together, not what they found.
    Merge(Merge),
    /// Print completions for a shell
    Completions { shell: clap_complete::Shell },
    /// Print the manual page of partc, or of one of its commands
    Man {
        /// `compile`, `check` …
        command: Option<String>,
        /// Write all pages into this folder
        #[arg(long, value_name = "DIR", conflicts_with = "command")]
        out_dir: Option<PathBuf>,
    },
}

#[derive(Debug, ClapArgs)]
pub(super) struct Compile {
    /// Part programs and folders; `-` reads standard input
    #[arg(required_unless_present = "files_from")]
    pub inputs: Vec<PathBuf>,
    /// Output file; `-` writes standard output. Default: beside the input, with the target's extension
    #[arg(short, long, value_name = "FILE", conflicts_with = "out_dir")]
    pub output: Option<PathBuf>,
    /// Folder for the output files; the tree of a folder of programs is kept
    #[arg(long, value_name = "DIR")]
    pub out_dir: Option<PathBuf>,
    /// Write a source map: output line to input file, line and call stack
    #[arg(long, value_name = "FILE")]
    pub map: Option<PathBuf>,
    /// Overwrite an output file that partc did not write
    #[arg(long)]
    pub force: bool,
    /// Do not read the output back and compare it with what the program does
    #[arg(long)]
    pub no_verify: bool,
    #[command(flatten)]
    pub many: Many,
    #[command(flatten)]
    pub deps: Deps,
    #[command(flatten)]
    pub findings: Findings,
    #[command(flatten)]
    pub common: Common,
}

#[derive(Debug, ClapArgs)]
pub(super) struct Check {
    /// Part programs and folders; `-` reads standard input
    #[arg(required_unless_present = "files_from")]
    pub paths: Vec<PathBuf>,
    /// File for the report, instead of the terminal or standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Write comments into the programs that suppress the warnings found now; notes, too, with `--fail-on note`
    #[arg(long, conflicts_with_all = ["fix", "diff"])]
    pub add_ignores: bool,
    /// Mend what rules can mend, where what the program does stays the same
    #[arg(long)]
    pub fix: bool,
    /// Show what `--fix` would change, and write nothing; exit code 1 if there is something
    #[arg(long)]
    pub diff: bool,
    /// With `--fix` or `--diff`: number blocks anew, too
    #[arg(long)]
    pub unsafe_fixes: bool,
    #[command(flatten)]
    pub many: Many,
    #[command(flatten)]
    pub deps: Deps,
    #[command(flatten)]
    pub findings: Findings,
    #[command(flatten)]
    pub common: Common,
}

#[derive(Debug, ClapArgs)]
pub(super) struct Watch {
    #[command(flatten)]
    pub check: Check,
}

#[derive(Debug, ClapArgs)]
pub(super) struct Key {
    /// Part programs and folders; `-` reads standard input
    #[arg(required_unless_present = "files_from")]
    pub paths: Vec<PathBuf>,
    /// Rapid traverse of the machine, as `trace` and `stats` have it
    #[arg(long, value_name = "MM/MIN", default_value_t = 10_000.0, value_parser = above_zero)]
    pub rapid: f64,
    /// Acceleration along the path, as `trace` and `stats` have it
    #[arg(long, value_name = "M/S²", default_value_t = 1.0, value_parser = above_zero)]
    pub acceleration: f64,
    /// Time of a tool change, as `stats` has it
    #[arg(long, value_name = "SECONDS", default_value_t = 0.0, value_parser = seconds)]
    pub tool_change: f64,
    #[command(flatten)]
    pub many: Many,
    #[command(flatten)]
    pub common: Common,
}

#[derive(Debug, ClapArgs)]
pub(super) struct Merge {
    /// Reports of `partc check --shard`; `-` reads standard input
    #[arg(required = true)]
    pub reports: Vec<PathBuf>,
    /// File to write instead of standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

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

#[derive(Debug, ClapArgs)]
pub(super) struct Init {
    /// Part programs and folders
    #[arg(required_unless_present = "files_from")]
    pub paths: Vec<PathBuf>,
    /// File to write; `-` writes standard output. Default: partc.toml in the folder that is named
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Write over an existing file
    #[arg(long)]
    pub force: bool,
    #[command(flatten)]
    pub many: Many,
    #[command(flatten)]
    pub common: Common,
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

#[derive(Debug, ClapArgs)]
pub(super) struct Trace {
    /// Part program; `-` reads standard input
    pub input: PathBuf,
    /// File for the moves; `-`, the default, is standard output. Its extension decides the form; `--format` is needed for one that is not known
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Overwrite a file that is no trace
    #[arg(long)]
    pub force: bool,
    /// Rapid traverse of the machine
    #[arg(long, value_name = "MM/MIN", default_value_t = 10_000.0, value_parser = above_zero)]
    pub rapid: f64,
    /// Acceleration along the path
    #[arg(long, value_name = "M/S²", default_value_t = 1.0, value_parser = above_zero)]
    pub acceleration: f64,
    #[command(flatten)]
    pub deps: Deps,
    #[command(flatten)]
    pub findings: Findings,
    #[command(flatten)]
    pub common: Common,
}

#[derive(Debug, ClapArgs)]
pub(super) struct ToolsArgs {
    /// TOOL.T, .D, .PR, .PNT, tool data of a SINUMERIK (.INI, .TOA, .UFR), tool.tbl or machine .ini of LinuxCNC, CSV
    pub file: PathBuf,
    /// Form to print
    #[arg(long, value_enum, default_value = "table")]
    pub to: TableForm,
    /// Unit of a file that states none
    #[arg(long, value_parser = ["mm", "inch"])]
    pub unit: Option<String>,
    /// File to write instead of standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// Forms of tables.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum TableForm {
    /// For people
    Table,
    /// One object
    Json,
    /// A line for each tool or row
    Csv,
    /// Lines for partc.toml
    Toml,
    /// Tool table of a HEIDENHAIN control
    #[value(name = "tool.t")]
    ToolT,
    /// Tool table of LinuxCNC
    #[value(name = "tool.tbl")]
    ToolTbl,
}

#[derive(Debug, ClapArgs)]
pub(super) struct Stats {
    /// Part programs and folders; `-` reads standard input
    #[arg(required_unless_present = "files_from")]
    pub inputs: Vec<PathBuf>,
    /// Form of the figures
    #[arg(long = "as", value_enum, default_value = "table")]
    pub form: StatsFormat,
    /// Rapid traverse of the machine
    #[arg(long, value_name = "MM/MIN", default_value_t = 10_000.0, value_parser = above_zero)]
    pub rapid: f64,
    /// Acceleration along the path
    #[arg(long, value_name = "M/S²", default_value_t = 1.0, value_parser = above_zero)]
    pub acceleration: f64,
    /// Time of a tool change
    #[arg(long, value_name = "SECONDS", default_value_t = 0.0, value_parser = seconds)]
    pub tool_change: f64,
    #[command(flatten)]
    pub many: Many,
    #[command(flatten)]
    pub findings: Findings,
    #[command(flatten)]
    pub common: Common,
}

/// Forms of figures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum StatsFormat {
    /// For people
    Table,
    /// One object
    Json,
    /// A line for each tool of each program
    Csv,
}

fn above_zero(text: &str) -> Result<f64, String> {
    let value: f64 = text.parse().map_err(|_| "a number".to_owned())?;
    if value.is_finite() && value > 0.0 { Ok(value) } else { Err("a number above 0".to_owned()) }
}

fn seconds(text: &str) -> Result<f64, String> {
    let value: f64 = text.parse().map_err(|_| "a number of seconds".to_owned())?;
    if value.is_finite() && value >= 0.0 { Ok(value) } else { Err("0 or more seconds".to_owned()) }
}

#[derive(Debug, ClapArgs)]
pub(super) struct Plot {
    /// Part program; `-` reads standard input
    pub input: PathBuf,
    /// Picture, .svg or .png; `-` writes standard output. Default: beside the input, with the extension svg
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Form of the picture [default: by the extension of the output]
    #[arg(long = "as", value_enum)]
    pub form: Option<PictureForm>,
    /// Side from which the path is seen [default: the working plane; on a lathe Z to the right and X up]
    #[arg(long, value_enum)]
    pub view: Option<View>,
    /// Write sizes, circles, holes and diameters into the picture
    #[arg(long)]
    pub dimensions: bool,
    /// Overwrite a picture that partc did not draw
    #[arg(long)]
    pub force: bool,
    #[command(flatten)]
    pub findings: Findings,
    #[command(flatten)]
    pub common: Common,
}

/// Forms of pictures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum PictureForm {
    Svg,
    Png,
}

/// Sides of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum View {
    /// From above
    Xy,
    /// From the front; on a lathe Z to the right and X up
    Xz,
    /// From the right
    Yz,
    /// From the right in front and above
    Iso,
}

#[derive(Debug, ClapArgs)]
pub(super) struct Page {
    /// Part program; `-` reads standard input
    pub input: PathBuf,
    /// Page; `-` writes standard output. Default: beside the input, with the extension html
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Overwrite a page that partc did not write
    #[arg(long)]
    pub force: bool,
    #[command(flatten)]
    pub deps: Deps,
    #[command(flatten)]
    pub findings: Findings,
    #[command(flatten)]
    pub common: Common,
}

#[derive(Debug, ClapArgs)]
pub(super) struct Test {
    /// Folder with programs and golden outputs
    #[arg(default_value = ".")]
    pub dir: PathBuf,
    /// Write the golden outputs anew, also those that do not exist yet
    #[arg(long)]
    pub update: bool,
    /// Write the results as JUnit XML, too
    #[arg(long, value_name = "FILE")]
    pub junit: Option<PathBuf>,
    #[command(flatten)]
    pub common: Common,
}

#[derive(Debug, ClapArgs)]
pub(super) struct Diff {
    /// The first program
    pub a: PathBuf,
    /// The second program
    pub b: PathBuf,
    /// Lengths, angles, feeds and speeds that differ by this much are the same
    #[arg(long, value_name = "MM", default_value_t = 0.001, value_parser = tolerance)]
    pub tolerance: f64,
    /// Draw both paths into an SVG picture
    #[arg(long, value_name = "FILE")]
    pub plot: Option<PathBuf>,
    /// Overwrite a picture that partc did not draw
    #[arg(long)]
    pub force: bool,
    #[command(flatten)]
    pub common: Common,
}

fn tolerance(text: &str) -> Result<f64, String> {
    let value: f64 = text.parse().map_err(|_| "a number of millimetres".to_owned())?;
    if value.is_finite() && (0.0..=10.0).contains(&value) { Ok(value) } else { Err("0 to 10 millimetres".to_owned()) }
}

#[derive(Debug, ClapArgs)]
#[group(id = "what", required = true, multiple = false, args = ["show", "schema"])]
pub(super) struct Config {
    /// Show what holds for this program or folder, and where each value comes from
    #[arg(long, value_name = "PATH")]
    pub show: Option<PathBuf>,
    /// Print the JSON Schema of partc.toml
    #[arg(long)]
    pub schema: bool,
    #[command(flatten)]
    pub common: Common,
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

/// The definition of the command line, for completions and the manual page, too.
pub(super) fn command() -> clap::Command {
    Args::command().mut_subcommand("trace", |trace| {
        trace.mut_arg("format", |format| {
            format
                .value_parser(TraceFormats)
                .help("How the moves are written [default: by the extension of the output, or jsonl]; human, concise: the findings")
        })
    })
}

impl Args {
    /// Reads a command line, the name of the program in front.
    ///
    /// # Errors
    /// What clap has to say, help included.
    pub fn read(arguments: impl IntoIterator<Item = OsString>) -> Result<Args, clap::Error> {
        Args::from_arg_matches(&command().try_get_matches_from(arguments)?)
    }
}

/// Values of `--format` of `partc trace`.
#[derive(Debug, Clone)]
struct TraceFormats;

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
