//! A folder of one test, in which the built binary runs, and what came of a run.

use std::collections::BTreeSet;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde_json::Value;

/// A program without findings.
pub(super) const PART: &str =
    "0 BEGIN PGM PART MM\n1 L X+10 Y+5 Z+2 R0 FMAX M3\n2 L Z-5 F150\n3 L Z+50 FMAX M30\n4 END PGM PART MM\n";
/// A program with an error in its second line.
pub(super) const WRONG: &str = "0 BEGIN PGM WRONG MM\n1 L X+10 Y+5 R5 F300\n2 END PGM WRONG MM\n";
/// A program with a warning in its third line.
pub(super) const WARNED: &str =
    "0 BEGIN PGM WARNED MM\n1 L X+10 Y+0 R0 F300\n2 CC X+0\n3 C X+0 Y+10 DR+\n4 END PGM WARNED MM\n";
/// A program that calls another one.
pub(super) const CALLER: &str =
    "0 BEGIN PGM CALLER MM\n1 L X+10 Y+5 Z+2 R0 FMAX\n2 CALL PGM {}\n3 L Z+50 FMAX M30\n4 END PGM CALLER MM\n";
pub(super) const HOLE: &str = "0 BEGIN PGM HOLE MM\n1 L Z-5 F150\n2 L Z+2 FMAX\n3 END PGM HOLE MM\n";
/// A program that needs the radius of tool 5.
pub(super) const RADIUS: &str =
    "0 BEGIN PGM RADIUS MM\n1 TOOL CALL 5 Z S2000\n2 L X+0 Y+0 R0 F300\n3 X+50 R+ F200\n4 END PGM RADIUS MM\n";

pub(super) fn caller(name: &str) -> String {
    CALLER.replace("{}", name)
}

/// A folder of one test.
pub(super) struct Folder(pub(super) PathBuf);

impl Folder {
    pub(super) fn new(test: &str) -> Folder {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("cli").join(test);
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).expect("a folder for the test");
        Folder(path)
    }

    /// Writes files: name and content.
    pub(super) fn with(self, files: &[(&str, &str)]) -> Folder {
        for (name, text) in files {
            self.write(name, text);
        }
        self
    }

    pub(super) fn write(&self, name: &str, text: &str) {
        let path = self.0.join(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(path, text).expect("a file");
    }

    pub(super) fn read(&self, name: &str) -> String {
        fs::read_to_string(self.0.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    pub(super) fn has(&self, name: &str) -> bool {
        self.0.join(name).symlink_metadata().is_ok()
    }

    /// Names of everything in the folder and below.
    pub(super) fn names(&self) -> BTreeSet<String> {
        let mut found = BTreeSet::new();
        let mut folders = vec![self.0.clone()];
        while let Some(folder) = folders.pop() {
            for entry in fs::read_dir(folder).expect("a readable folder") {
                let path = entry.expect("an entry").path();
                found.insert(path.strip_prefix(&self.0).expect("inside").to_string_lossy().replace('\\', "/"));
                if path.is_dir() && !path.is_symlink() {
                    folders.push(path);
                }
            }
        }
        found
    }

    pub(super) fn run(&self, args: &[&str]) -> Ran {
        self.run_with(args, "")
    }

    /// Runs partc in the folder, with this on standard input.
    pub(super) fn run_with(&self, args: &[&str], input: &str) -> Ran {
        let mut child = Command::new(env!("CARGO_BIN_EXE_partc"))
            .args(args)
            .current_dir(&self.0)
            .env_remove("NO_COLOR")
            .env_remove("GITHUB_ACTIONS")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("partc runs");
        let mut stdin = child.stdin.take().expect("a pipe");
        let input = input.to_owned();
        let feeder = std::thread::spawn(move || {
            // A command that reads no input closes it early.
            let _ = stdin.write_all(input.as_bytes());
        });
        let output = child.wait_with_output().expect("partc ends");
        feeder.join().expect("the input is written");
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("UTF-8");
        Ran { args: args.join(" "), code: output.status.code(), out: text(output.stdout), err: text(output.stderr) }
    }
}

/// What a run came to.
#[derive(Debug)]
pub(super) struct Ran {
    args: String,
    pub(super) code: Option<i32>,
    pub(super) out: String,
    pub(super) err: String,
}

impl Ran {
    #[track_caller]
    pub(super) fn exits(self, code: i32) -> Ran {
        assert_eq!(self.code, Some(code), "partc {}\n{}\n{}", self.args, self.out, self.err);
        self
    }

    #[track_caller]
    pub(super) fn says(self, text: &str) -> Ran {
        assert!(self.err.contains(text), "partc {}: `{text}` is missing in:\n{}", self.args, self.err);
        self
    }

    #[track_caller]
    pub(super) fn quietly(self) -> Ran {
        assert!(self.err.is_empty(), "partc {}:\n{}", self.args, self.err);
        self
    }

    #[track_caller]
    pub(super) fn json(&self) -> Value {
        assert_eq!(self.out.lines().count(), 1, "one document in one line:\n{}", self.out);
        serde_json::from_str(&self.out).unwrap_or_else(|error| panic!("{error}:\n{}", self.out))
    }

    /// Codes in the findings of `--format concise`.
    pub(super) fn codes(&self) -> Vec<&str> {
        self.err
            .lines()
            .filter_map(|line| Some(line.split_once('[')?.1.split_once(']')?.0))
            .filter(|c| c.len() == 5)
            .collect()
    }
}

pub(super) fn set(names: &[&str]) -> BTreeSet<String> {
    names.iter().map(|name| (*name).to_owned()).collect()
}

/// The moves of an output, without head and frame.
pub(super) fn body(program: &str) -> Vec<&str> {
    program.lines().skip(5).filter(|line| *line != "%").collect()
}
