//! The arguments.

use std::ffi::OsString;
use std::path::PathBuf;

use clap::{Args as ClapArgs, CommandFactory, FromArgMatches, Parser, Subcommand, ValueEnum};

use super::options::{Common, Deps, Findings, ListFormat, Machine, Many, Timing, TraceFormats};

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
    /// with errors it shows them, the path up to the first one and lines for partc.toml, and no G-code; the exit code is that of
    /// `compile`.
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
    #[command(flatten)]
    pub timing: Timing,
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

#[derive(Debug, ClapArgs)]
pub(super) struct Init {
    /// Part programs and folders
    #[arg(required_unless_present = "files_from")]
    pub paths: Vec<PathBuf>,
    /// File to write; `-` writes standard output. Default: partc.toml in the folder that is named
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Write over an existing file, as if it were not there
    #[arg(long)]
    pub force: bool,
    /// Ask for the values one by one
    #[arg(short, long)]
    pub interactive: bool,
    /// Keep an existing file as it is, and add the lines that are new
    #[arg(long, conflicts_with = "force")]
    pub update: bool,
    #[command(flatten)]
    pub many: Many,
    #[command(flatten)]
    pub common: Common,
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
    #[command(flatten)]
    pub machine: Machine,
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
    #[command(flatten)]
    pub timing: Timing,
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
