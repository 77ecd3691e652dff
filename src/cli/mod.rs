//! The command line: arguments, files, exit codes. What it promises stands in the README.

mod answers;
mod args;
mod ask;
mod backup;
mod bundle;
mod closure;
mod config;
mod deps;
mod diff;
mod disk;
mod edit;
mod fix;
mod golden;
pub mod host;
mod ignores;
mod init;
mod inputs;
mod key;
mod listed;
mod listing;
mod lsp;
mod made;
mod merge;
mod need;
mod options;
mod output;
mod page;
mod paths;
mod pending;
mod plot;
mod pool;
mod program;
mod progress;
mod regular;
mod report;
mod run;
mod show;
mod source_map;
mod stamp;
mod stats;
mod summary;
mod targets;
mod tool_hints;
mod tool_lines;
mod tools;
mod trace;
mod trial;
mod unified;
mod update;
mod watch;

use std::ffi::OsString;
use std::io::Write as _;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;

use crate::text::decode::harmless_lines;

use args::{Args, Command};

/// What a run came to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Exit {
    /// Clean, or notes and warnings only.
    Clean = 0,
    /// Errors in a program; no output was written.
    Errors = 1,
    /// The command line, the configuration or the file system is at fault.
    Usage = 2,
    /// partc is at fault.
    Internal = 3,
}

/// Trouble that is no finding in a program; its text goes to stderr.
type Trouble = String;

/// Runs the command line of this process.
pub fn main() -> ExitCode {
    ExitCode::from(run_line(std::env::args_os()))
}

/// Runs a command line; the first argument is the name of the program. Returns the exit code.
fn run_line(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    let args = match Args::read(arguments) {
        Ok(args) => args,
        Err(error) => {
            // The text quotes arguments; colours only where it brings nothing else along.
            let plain = error.render().to_string();
            if harmless_lines(&plain) == plain {
                let _ = error.print();
            } else {
                say(plain.trim_end());
            }
            return if error.use_stderr() { Exit::Usage as u8 } else { Exit::Clean as u8 };
        }
    };
    std::panic::set_hook(Box::new(|panic| {
        say(&format!("partc: internal error: {panic}"));
        say("Nothing was written for that program. Please report this with the program that caused it.");
    }));
    let exit = match catch_unwind(AssertUnwindSafe(|| dispatch(&args))) {
        Ok(Ok(exit)) => exit,
        Ok(Err(trouble)) => {
            say(&format!("partc: {trouble}"));
            Exit::Usage
        }
        Err(_) => Exit::Internal,
    };
    exit as u8
}

/// A line on stderr. Names of files in it do nothing to a terminal; nobody listening there is no reason to stop.
fn say(line: &str) {
    let _ = writeln!(std::io::stderr(), "{}", harmless_lines(line));
}

fn dispatch(args: &Args) -> Result<Exit, Trouble> {
    match &args.command {
        Command::Compile(compile) => run::compile(compile),
        Command::Check(check) => run::check(check),
        Command::Init(init) => init::init(init),
        Command::Trace(trace) => trace::trace(trace),
        Command::Plot(plot) => plot::plot(plot),
        Command::Report(args) => page::report(args),
        Command::Stats(args) => stats::stats(args),
        Command::Test(test) => golden::test(test),
        Command::Diff(two) => diff::diff(two),
        Command::Config(show) => show::config(show),
        Command::Explain { code, format } => listing::explain(code, *format),
        Command::Rules { format } => listing::rules(*format),
        Command::Key(args) => key::key(args),
        Command::Merge(args) => merge::merge(args),
        Command::Watch(args) => watch::watch(args),
        Command::Tools(args) => tools::tools(args),
        Command::Lsp(common) => lsp::serve(common),
        Command::Targets { format } => targets::list(*format),
        Command::Completions { shell } => {
            let mut script = Vec::new();
            clap_complete::generate(*shell, &mut args::command(), "partc", &mut script);
            listing::print(&script)
        }
        Command::Man { command, out_dir } => listing::manual(args::command(), command.as_deref(), out_dir.as_deref()),
    }
}
