//! The command killed at any moment: a file has its older content or the whole new one.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use crate::damage::Dice;

/// What was seen.
#[derive(Debug, Default)]
pub struct Killed {
    /// Processes that were started, and those that a signal ended.
    pub started: usize,
    pub killed: usize,
    /// Outputs that were neither the older nor the new one, or gone.
    pub broken: Vec<String>,
}

/// A program that takes a while, with one number that tells its versions apart.
pub fn long(depth: usize) -> String {
    let mut text = "0 BEGIN PGM LONG MM\n1 L X+0 Y+0 Z+2 R0 FMAX M3\n".to_owned();
    for i in 0..3_000 {
        text += &format!("L X+{}.5 Y+{} Z-{depth} F500\n", i % 200, i % 170);
    }
    text + "L Z+50 FMAX M30\nEND PGM LONG MM\n"
}

/// Starts `partc` so often in an empty folder and kills it.
pub fn kills(partc: &Path, folder: &Path, count: usize) -> Killed {
    let command = || {
        let mut command = Command::new(partc);
        command.args(["compile", "LONG.H", "--map", "LONG.map"]).current_dir(folder);
        command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
        command
    };
    let (program, output) = (folder.join("LONG.H"), folder.join("LONG.ngc"));
    // The shorter time: something else may have been in the way of the other run.
    let mut took = Duration::MAX;
    let outputs = [1, 2].map(|depth| {
        fs::write(&program, long(depth)).expect("a program");
        let start = Instant::now();
        assert!(command().status().expect("partc runs").success());
        took = took.min(start.elapsed());
        fs::read_to_string(&output).expect("an output")
    });
    assert!(outputs[0] != outputs[1]);
    let mut dice = Dice(0x1234_5678_9abc_def1);
    // Where the end of a run is, for who sends the signal: on a busy machine that is late, too.
    let mut reach = took.as_micros() as usize;
    let mut seen = Killed { started: count, ..Killed::default() };
    for n in 0..count {
        fs::write(&program, long(1 + n % 2)).expect("a program");
        // One of three has no older output.
        if n % 3 == 0 {
            fs::remove_file(&output).ok();
        }
        let had = output.exists();
        let mut child = command().spawn().expect("partc runs");
        // Most of them near the end, where the names change.
        let wait = if n % 4 == 0 { dice.roll(reach) } else { reach / 2 + dice.roll(reach) };
        std::thread::sleep(Duration::from_micros(wait as u64));
        let signal = ["-KILL", "-TERM", "-HUP", "-INT"][dice.roll(4)];
        Command::new("kill").args([signal, &child.id().to_string()]).stderr(Stdio::null()).status().expect("kill runs");
        let in_time = child.wait().expect("partc ends").code().is_none();
        seen.killed += usize::from(in_time);
        reach = if in_time { reach + reach / 16 + 1 } else { reach - reach / 8 };
        match fs::read_to_string(&output) {
            Ok(text) if outputs.contains(&text) => {}
            Err(_) if !had => {}
            Ok(_) => seen.broken.push(format!("a part of an output after {signal} at {wait} µs")),
            Err(_) => seen.broken.push(format!("the older output is gone after {signal} at {wait} µs")),
        }
    }
    // What is left between two names goes with the next run.
    assert!(command().status().expect("partc runs").success());
    seen
}
