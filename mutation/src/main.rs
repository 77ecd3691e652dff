//! The mutation score out of one build: a sample of the changes that `cargo mutants` lists is built in at once, each behind a
//! number that a variable of the environment switches on. `mutation/run` calls the steps in turn.
//!
//! What a step knows lies in `target/mutation`, so that a run goes on where it was stopped.

mod compile;
mod edit;
mod list;
mod process;
mod reach;
mod report;
mod tree;
mod trial;

use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;

/// Why a step cannot go on.
pub type Result<T> = std::result::Result<T, Box<dyn Error>>;

/// Where the steps find the project, and leave what they know.
pub struct Places {
    pub project: PathBuf,
    pub work: PathBuf,
}

impl Places {
    /// The copy that holds the changes.
    pub fn tree(&self) -> PathBuf {
        self.work.join("tree")
    }
}

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    match step(&args) {
        Ok(()) => ExitCode::SUCCESS,
        Err(trouble) => {
            eprintln!("{trouble}");
            ExitCode::FAILURE
        }
    }
}

fn step(args: &[String]) -> Result<()> {
    let project = std::env::current_dir()?;
    let places = Places { work: project.join("target/mutation"), project };
    let words: Vec<&str> = args.iter().map(String::as_str).collect();
    match words[..] {
        ["sample", seed, count] => list::sample(&places, seed.parse()?, count.parse()?),
        ["again"] => list::again(&places),
        ["build"] => compile::build(&places),
        ["reach"] => reach::reach(&places),
        ["try"] => trial::try_all(&places, false),
        ["try", "long"] => trial::try_all(&places, true),
        ["report"] => report::report(&places),
        _ => Err("partc-mutation sample SEED COUNT | again | build | reach | try [long] | report".into()),
    }
}
