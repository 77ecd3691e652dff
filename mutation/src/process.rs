//! A test program at work: it is stopped at the first failure, and when it takes too long.

use std::io::{BufRead, BufReader};
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::time::Duration;

use super::{Places, Result};

/// How a run ended.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum End {
    Passed,
    /// The test that failed; empty where the program fell over.
    Failed(String),
    TooLong,
}

/// A program that runs tests by name, one at a time. Memory is limited: changed loops may never end.
pub fn command(places: &Places, program: &Path, tests: &[&str]) -> Command {
    let mut command = Command::new("sh");
    command.args(["-c", "ulimit -v 8000000; exec nice -n 10 \"$@\"", "sh"]).arg(program);
    command.args(["--test-threads=1", "--exact"]).args(tests).current_dir(places.tree());
    command.env("CARGO_MANIFEST_DIR", places.tree()).env("INSTA_WORKSPACE_ROOT", places.tree());
    // Nothing is written, and random tests are the same in each run.
    command.env("INSTA_UPDATE", "no").env("INSTA_FORCE_PASS", "0").env("PROPTEST_DISABLE_FAILURE_PERSISTENCE", "1");
    command.env("PROPTEST_RNG_SEED", "14").env("RUST_BACKTRACE", "0");
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::null()).process_group(0);
    command
}

/// Runs it; `patience` for each test.
pub fn run(mut command: Command, patience: Duration) -> Result<End> {
    let mut child = command.spawn()?;
    let out = child.stdout.take().ok_or("no output")?;
    let (lines, read) = mpsc::channel();
    std::thread::spawn(move || {
        for line in BufReader::new(out).split(b'\n').map_while(std::result::Result::ok) {
            if lines.send(String::from_utf8_lossy(&line).into_owned()).is_err() {
                break;
            }
        }
    });
    loop {
        match read.recv_timeout(patience) {
            Ok(line) => {
                if let Some(test) = line.strip_suffix("FAILED").filter(|line| line.starts_with("test ")) {
                    stop(&mut child)?;
                    let name = test.trim_start_matches("test ").trim_end().trim_end_matches("...").trim_end();
                    return Ok(End::Failed(name.split(" ... ").next().unwrap_or_default().to_owned()));
                }
            }
            Err(RecvTimeoutError::Timeout) => {
                stop(&mut child)?;
                return Ok(End::TooLong);
            }
            Err(RecvTimeoutError::Disconnected) => {
                let passed = child.wait()?.success();
                return Ok(if passed { End::Passed } else { End::Failed(String::new()) });
            }
        }
    }
}

/// Ends the program and what it started.
fn stop(child: &mut Child) -> Result<()> {
    Command::new("kill").args(["-KILL", "--", &format!("-{}", child.id())]).stderr(Stdio::null()).status()?;
    child.wait()?;
    Ok(())
}
