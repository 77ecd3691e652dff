//! The arguments.

use std::path::PathBuf;

use clap::{Args as ClapArgs, CommandFactory, Parser, Subcommand, ValueEnum};

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
    /// Print the resolved moves as JSON Lines, one move a line
    Trace(Trace),
    /// Draw the resolved path as an SVG picture
    Plot(Plot),
    /// Compile the programs of a folder and compare with the golden outputs beside them
    ///
    /// PART.H belongs to PART.golden.ngc, for grbl PART.golden.gcode, for grblhal PART.golden.grblhal.gcode; those of other
    /// targets are passed over. A difference is shown as text and as motion; version and source hash in the head do not
    /// count.
    Test(Test),
    /// Show the configuration in force, or its JSON Schema
    Config(Config),
    /// Explain a diagnostic code
    Explain {
        /// Code such as K2101, or its name
        code: String,
        #[arg(long, value_enum, default_value = "human")]
        format: Format,
    },
    /// List all diagnostic codes
    Rules {
        #[arg(long, value_enum, default_value = "human")]
        format: Format,
    },
    /// List the targets and what each can say
    Targets {
        #[arg(long, value_enum, default_value = "human")]
        format: Format,
    },
    /// Print completions for a shell
    Completions { shell: clap_complete::Shell },
    /// Print the manual page
    Man,
}

#[derive(Debug, ClapArgs)]
pub(super) struct Compile {
    /// Part programs; `-` reads standard input
    #[arg(required = true)]
    pub inputs: Vec<PathBuf>,
    /// Output file; `-` writes standard output. Default: beside the input, with the target's extension
    #[arg(short, long, value_name = "FILE", conflicts_with = "out_dir")]
    pub output: Option<PathBuf>,
    /// Folder for the output files
    #[arg(long, value_name = "DIR")]
    pub out_dir: Option<PathBuf>,
    /// Write a source map: output line to input file, line and call stack
    #[arg(long, value_name = "FILE")]
    pub map: Option<PathBuf>,
    /// Overwrite an output file that partc did not write
    #[arg(long)]
    pub force: bool,
    #[command(flatten)]
    pub common: Common,
}

#[derive(Debug, ClapArgs)]
pub(super) struct Check {
    /// Part programs and folders; `-` reads standard input
    #[arg(required = true)]
    pub paths: Vec<PathBuf>,
    #[command(flatten)]
    pub common: Common,
}

#[derive(Debug, ClapArgs)]
pub(super) struct Trace {
    /// Part program; `-` reads standard input
    pub input: PathBuf,
    #[command(flatten)]
    pub common: Common,
}

#[derive(Debug, ClapArgs)]
pub(super) struct Plot {
    /// Part program; `-` reads standard input
    pub input: PathBuf,
    /// Picture; `-` writes standard output. Default: beside the input, with the extension svg
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Overwrite a picture that partc did not draw
    #[arg(long)]
    pub force: bool,
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
    #[command(flatten)]
    pub common: Common,
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

#[derive(Debug, ClapArgs)]
pub(super) struct Common {
    /// Language of the input
    #[arg(long, default_value = "auto", value_parser = dialects())]
    pub dialect: String,
    /// Control that shall run the output
    #[arg(long, value_name = "TARGET", value_parser = crate::target::NAMES)]
    pub target: Option<String>,
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
    /// How findings are written
    #[arg(long, value_enum, default_value = "human")]
    pub format: Format,
    /// Show errors only
    #[arg(short, long)]
    pub quiet: bool,
    #[arg(long, value_enum, default_value = "auto")]
    pub color: Color,
    /// Name of what standard input holds
    #[arg(long, value_name = "NAME")]
    pub stdin_filename: Option<PathBuf>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    Human,
    Concise,
    Json,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Color {
    Auto,
    Always,
    Never,
}

/// The definition of the command line, for completions and the manual page.
pub(super) fn command() -> clap::Command {
    Args::command()
}

/// `auto` and the name of every dialect.
fn dialects() -> clap::builder::PossibleValuesParser {
    let names = std::iter::once("auto").chain(crate::dialect::ALL.iter().map(|dialect| dialect.id));
    clap::builder::PossibleValuesParser::new(names)
}
