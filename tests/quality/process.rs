//! Runs the command and watches what it takes.

use std::fs::{self, File};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// What a run took.
#[derive(Debug, Clone)]
pub struct Took {
    /// None where it was ended from outside.
    pub code: Option<i32>,
    pub time: Duration,
    /// Most memory that it held, KiB; 0 where nobody says it.
    pub memory: u64,
    /// What it said.
    pub said: String,
}

/// Runs `partc` in a folder, and ends it after `most`.
pub fn run(partc: &Path, folder: &Path, args: &[&str], most: Duration) -> Took {
    run_with(Command::new(partc).args(args), folder, most)
}

/// The same for a command that is made ready.
pub fn run_with(command: &mut Command, folder: &Path, most: Duration) -> Took {
    let said = folder.join("said.txt");
    let file = File::create(&said).expect("a file for what is said");
    let start = Instant::now();
    let mut child = command
        .current_dir(folder)
        .env_remove("GITHUB_ACTIONS")
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(file)
        .spawn()
        .expect("partc runs");
    let status = format!("/proc/{}/status", child.id());
    let mut memory = 0;
    let code = loop {
        memory = fs::read_to_string(&status).ok().as_deref().and_then(high_water).unwrap_or(memory);
        if let Some(ended) = child.try_wait().expect("partc is asked") {
            break ended.code();
        }
        if start.elapsed() > most {
            child.kill().expect("partc is ended");
            child.wait().expect("partc ends");
            break None;
        }
        std::thread::sleep(Duration::from_micros(500));
    };
    let time = start.elapsed();
    let said = String::from_utf8_lossy(&fs::read(&said).unwrap_or_default()).into_owned();
    Took { code, time, memory, said }
}

fn high_water(status: &str) -> Option<u64> {
    status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?.trim().trim_end_matches("kB").trim().parse().ok()
}

/// An empty folder of this name below `under`.
pub fn folder(under: &Path, name: &str) -> std::path::PathBuf {
    let path = under.join(name);
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(&path).expect("a folder");
    path
}
