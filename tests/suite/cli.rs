//! The command line as users and CI jobs see it: commands, exit codes, files written and not written.
//!
//! Every test works in a folder of its own and runs the built binary there.

use std::collections::BTreeSet;
use std::fs;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use partc::diag::codes;
use serde_json::{Value, json};

/// A program without findings.
pub(super) const PART: &str =
    "0 BEGIN PGM PART MM\n1 L X+10 Y+5 Z+2 R0 FMAX M3\n2 L Z-5 F150\n3 L Z+50 FMAX M30\n4 END PGM PART MM\n";
/// A program with an error in its second line.
pub(super) const WRONG: &str = "0 BEGIN PGM WRONG MM\n1 L X+10 Y+5 R5 F300\n2 END PGM WRONG MM\n";
/// A program with a warning in its third line.
pub(super) const WARNED: &str =
    "0 BEGIN PGM WARNED MM\n1 L X+10 Y+0 R0 F300\n2 CC X+0\n3 C X+0 Y+10 DR+\n4 END PGM WARNED MM\n";
/// A program that calls another one.
const CALLER: &str =
    "0 BEGIN PGM CALLER MM\n1 L X+10 Y+5 Z+2 R0 FMAX\n2 CALL PGM {}\n3 L Z+50 FMAX M30\n4 END PGM CALLER MM\n";
pub(super) const HOLE: &str = "0 BEGIN PGM HOLE MM\n1 L Z-5 F150\n2 L Z+2 FMAX\n3 END PGM HOLE MM\n";
/// A program that needs the radius of tool 5.
const RADIUS: &str =
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
fn body(program: &str) -> Vec<&str> {
    program.lines().skip(5).filter(|line| *line != "%").collect()
}

// Where the output goes.

#[test]
fn output_lies_beside_the_input_with_the_extension_of_the_target() {
    let folder = Folder::new("beside").with(&[("sub/PART.H", PART)]);
    folder.run(&["compile", "sub/PART.H"]).exits(0).quietly();
    assert_eq!(folder.names(), set(&["sub", "sub/PART.H", "sub/PART.ngc"]));
    let program = folder.read("sub/PART.ngc");
    assert!(program.starts_with("%\n(partc ") && program.ends_with("\nM30\n%\n"), "{program}");
    assert_eq!(program.lines().nth(3), Some("G90 G21 G91.1 G94"));
    assert_eq!(body(&program), ["M3", "G0 X10 Y5 Z2", "G1 Z-5 F150", "G0 Z50", "M30"]);
}

#[test]
fn output_by_name_to_standard_output_and_to_a_folder() {
    let folder = Folder::new("output_options").with(&[("PART.H", PART)]);
    folder.run(&["compile", "PART.H", "-o", "made.nc"]).exits(0).quietly();
    let program = folder.read("made.nc");
    let ran = folder.run(&["compile", "PART.H", "-o", "-"]).exits(0).quietly();
    assert_eq!(ran.out, program);
    folder.run(&["compile", "PART.H", "--out-dir", "new/deep"]).exits(0);
    assert_eq!(folder.read("new/deep/PART.ngc"), program);
    assert_eq!(folder.names(), set(&["PART.H", "made.nc", "new", "new/deep", "new/deep/PART.ngc"]));
    folder.run(&["compile", "PART.H", "-o", "a.ngc", "--out-dir", "b"]).exits(2);
    assert!(!folder.has("a.ngc") && !folder.has("b"));
}

#[test]
fn standard_input() {
    let folder = Folder::new("stdin");
    let ran = folder.run_with(&["compile", "-"], PART).exits(0).quietly();
    assert_eq!(body(&ran.out).len(), 5);
    assert!(folder.names().is_empty());
    let named = folder.run_with(&["compile", "-", "--stdin-filename", "some/where/BRACKET.H"], PART).exits(0);
    assert!(named.out.contains("(source BRACKET.H, hash "), "{}", named.out);
    folder.run_with(&["compile", "-", "--stdin-filename", "BRACKET.H", "--out-dir", "out"], PART).exits(0);
    assert_eq!(folder.names(), set(&["out", "out/BRACKET.ngc"]));
    folder.run_with(&["compile", "-", "-o", "x.ngc"], PART).exits(0);
    assert_eq!(body(&folder.read("x.ngc")), body(&ran.out));
    let ran = folder.run_with(&["check", "-", "--stdin-filename", "BRACKET.H", "--format", "concise"], WRONG).exits(1);
    assert!(ran.err.starts_with("BRACKET.H:2:14: error[K1005]: "), "{}", ran.err);
}

#[test]
fn the_dialect_of_standard_input_is_told_by_content_or_name() {
    let folder = Folder::new("stdin_dialect");
    let fragment = "L X+10 Y+5 R0 F100\n";
    folder.run_with(&["compile", "-"], fragment).exits(2).says("--dialect");
    folder.run_with(&["compile", "-", "--stdin-filename", "A.H"], fragment).exits(0);
    folder.run_with(&["compile", "-", "--dialect", "klartext"], fragment).exits(0);
}

#[test]
fn several_inputs() {
    let folder = Folder::new("several").with(&[("A.H", PART), ("B.H", WRONG), ("C.H", PART)]);
    // One wrong program does not stop the others.
    folder.run(&["compile", "A.H", "B.H", "C.H"]).exits(1).says("K1005");
    assert_eq!(folder.names(), set(&["A.H", "A.ngc", "B.H", "C.H", "C.ngc"]));
    folder.run(&["compile", "A.H", "C.H", "--out-dir", "out"]).exits(0);
    assert!(folder.has("out/A.ngc") && folder.has("out/C.ngc"));
    folder.run(&["compile", "A.H", "C.H", "-o", "one.ngc"]).exits(2).says("--out-dir");
    folder.run(&["compile", "A.H", "C.H", "--map", "one.map"]).exits(2);
    assert!(!folder.has("one.ngc") && !folder.has("one.map"));
}

#[test]
fn output_is_the_same_whatever_the_way_to_the_program() {
    let folder = Folder::new("same_output").with(&[("sub/PART.H", PART)]);
    let ran = folder.run(&["compile", "sub/PART.H", "-o", "-"]).exits(0);
    let absolute = folder.0.join("sub/PART.H");
    let again = folder.run(&["compile", absolute.to_str().expect("UTF-8"), "-o", "-"]).exits(0);
    assert_eq!(ran.out, again.out);
    assert!(!ran.out.contains("sub"), "no path of this computer in the output: {}", ran.out);
}

// Exit codes, and what is left behind.

#[test]
fn exit_codes() {
    let folder = Folder::new("exit_codes").with(&[("PART.H", PART), ("WARNED.H", WARNED), ("WRONG.H", WRONG)]);
    fs::create_dir(folder.0.join("DIR.H")).expect("a folder");
    for (args, code) in [
        (vec!["compile", "PART.H"], 0),
        (vec!["compile", "WARNED.H"], 0),
        (vec!["check", "WARNED.H"], 0),
        (vec!["compile", "WRONG.H"], 1),
        (vec!["check", "WRONG.H"], 1),
        (vec!["trace", "WRONG.H"], 1),
        (vec!["compile", "MISSING.H"], 2),
        (vec!["check", "MISSING.H"], 2),
        (vec!["trace", "MISSING.H"], 2),
        (vec!["compile", "DIR.H"], 2),
        (vec!["compile"], 2),
        (vec!["frobnicate"], 2),
        (vec!["compile", "PART.H", "--bogus"], 2),
        (vec!["compile", "PART.H", "--target", "bogus"], 2),
        (vec!["compile", "PART.H", "--dialect", "bogus"], 2),
        (vec!["compile", "PART.H", "--format", "bogus"], 2),
        (vec![], 2),
        (vec!["--help"], 0),
        (vec!["compile", "--help"], 0),
        (vec!["--version"], 0),
    ] {
        folder.run(&args).exits(code);
    }
    folder.run(&["compile", "MISSING.H"]).says("MISSING.H");
    folder.run(&["compile", "DIR.H"]).says("folder");
}

#[test]
fn an_error_leaves_no_output_and_sets_an_older_one_aside() {
    let folder = Folder::new("stale").with(&[("PART.H", PART)]);
    folder.run(&["compile", "PART.H"]).exits(0);
    let older = folder.read("PART.ngc");
    folder.write("PART.H", WRONG);
    folder.run(&["compile", "PART.H"]).exits(1).says("PART.ngc.stale");
    assert_eq!(folder.names(), set(&["PART.H", "PART.ngc.stale"]));
    assert_eq!(folder.read("PART.ngc.stale"), older);
    // Without an older output there is nothing to say.
    let again = folder.run(&["compile", "PART.H"]).exits(1);
    assert!(!again.err.contains("stale"), "{}", again.err);
    assert_eq!(folder.names(), set(&["PART.H", "PART.ngc.stale"]));
    folder.write("PART.H", PART);
    folder.run(&["compile", "PART.H"]).exits(0);
    folder.write("PART.H", WRONG);
    folder.run(&["compile", "PART.H", "-o", "PART.ngc"]).exits(1);
    assert_eq!(folder.names(), set(&["PART.H", "PART.ngc.stale"]));
}

#[test]
fn an_error_does_not_touch_a_file_of_somebody_else() {
    let folder = Folder::new("stale_foreign").with(&[("WRONG.H", WRONG), ("mine.ngc", "G0 X1\n")]);
    folder.run(&["compile", "WRONG.H", "-o", "mine.ngc", "--force"]).exits(1);
    assert_eq!(folder.names(), set(&["WRONG.H", "mine.ngc"]));
    assert_eq!(folder.read("mine.ngc"), "G0 X1\n");
}

#[test]
fn an_error_prints_nothing_to_standard_output() {
    let folder = Folder::new("stdout_on_error").with(&[("WRONG.H", WRONG)]);
    assert_eq!(folder.run(&["compile", "WRONG.H", "-o", "-"]).exits(1).out, "");
    assert_eq!(folder.run_with(&["compile", "-"], WRONG).exits(1).out, "");
    assert_eq!(folder.run(&["trace", "WRONG.H"]).exits(1).out, "");
}

#[test]
fn a_file_that_partc_did_not_write_is_not_replaced() {
    let folder = Folder::new("foreign").with(&[("PART.H", PART), ("PART.ngc", "G0 X1\n"), ("out/PART.ngc", "G0 X2\n")]);
    folder.run(&["compile", "PART.H"]).exits(2).says("--force");
    assert_eq!(folder.read("PART.ngc"), "G0 X1\n");
    folder.run(&["compile", "PART.H", "--out-dir", "out"]).exits(2).says("--force");
    assert_eq!(folder.read("out/PART.ngc"), "G0 X2\n");
    assert_eq!(folder.names(), set(&["PART.H", "PART.ngc", "out", "out/PART.ngc"]));
    folder.run(&["compile", "PART.H", "--force"]).exits(0);
    assert!(folder.read("PART.ngc").contains("(partc "));
    // Now it is one of partc's, and an empty file is nobody's.
    folder.run(&["compile", "PART.H"]).exits(0);
    folder.write("out/PART.ngc", "");
    folder.run(&["compile", "PART.H", "--out-dir", "out"]).exits(0);
}

#[test]
fn the_output_never_replaces_the_input() {
    let folder = Folder::new("replaces_input").with(&[("PART.H", PART), ("part.ngc", PART)]);
    folder.run(&["compile", "PART.H", "-o", "PART.H", "--force"]).exits(2).says("replace the input");
    folder.run(&["compile", "PART.H", "-o", "./PART.H"]).exits(2);
    // An input that has the extension of the target already.
    folder.run(&["compile", "part.ngc", "--force"]).exits(2).says("replace the input");
    assert_eq!((folder.read("PART.H").as_str(), folder.read("part.ngc").as_str()), (PART, PART));
    assert_eq!(folder.names(), set(&["PART.H", "part.ngc"]));
    folder.run(&["compile", "part.ngc", "-o", "made.ngc"]).exits(0);
}

#[cfg(unix)]
#[test]
fn the_output_never_replaces_the_input_by_a_link() {
    let folder = Folder::new("replaces_input_link").with(&[("PART.H", PART)]);
    std::os::unix::fs::symlink("PART.H", folder.0.join("link.ngc")).expect("a link");
    folder.run(&["compile", "PART.H", "-o", "link.ngc", "--force"]).exits(2).says("replace the input");
    assert_eq!(folder.read("PART.H"), PART);
}

#[test]
fn a_target_folder_that_cannot_be_written() {
    let folder = Folder::new("no_folder").with(&[("PART.H", PART), ("file", "")]);
    folder.run(&["compile", "PART.H", "-o", "missing/PART.ngc"]).exits(2).says("missing/PART.ngc");
    folder.run(&["compile", "PART.H", "-o", "file/PART.ngc"]).exits(2);
    folder.run(&["compile", "PART.H", "--out-dir", "file"]).exits(2);
    folder.run(&["compile", "PART.H", "--map", "missing/PART.map"]).exits(2).says("missing/PART.map");
    assert_eq!(folder.names(), set(&["PART.H", "file"]));
}

#[cfg(unix)]
#[test]
fn a_read_only_target_folder() {
    use std::os::unix::fs::PermissionsExt;
    let folder = Folder::new("read_only").with(&[("PART.H", PART)]);
    let closed = folder.0.join("closed");
    fs::create_dir(&closed).expect("a folder");
    fs::set_permissions(&closed, fs::Permissions::from_mode(0o555)).expect("permissions");
    // Permissions do not hold for the superuser, who runs some build machines.
    if fs::write(closed.join("probe"), "").is_ok() {
        eprintln!("skipped: this user may write anywhere");
        return;
    }
    folder.run(&["compile", "PART.H", "--out-dir", "closed"]).exits(2).says("PART.ngc");
    assert_eq!(folder.names(), set(&["PART.H", "closed"]));
}

#[cfg(target_os = "linux")]
#[test]
fn devices_as_output() {
    let folder = Folder::new("devices").with(&[("PART.H", PART), ("WRONG.H", WRONG)]);
    folder.run(&["compile", "PART.H", "-o", "/dev/null"]).exits(0).quietly();
    folder.run(&["compile", "WRONG.H", "-o", "/dev/null"]).exits(1);
    folder.run(&["compile", "PART.H", "-o", "/dev/full"]).exits(2).says("/dev/full");
    assert_eq!(folder.names(), set(&["PART.H", "WRONG.H"]));
}

/// `partc … | head`: a reader that has seen enough is no trouble.
#[cfg(unix)]
#[test]
fn a_closed_pipe_is_no_trouble() {
    let folder = Folder::new("closed_pipe");
    // More than a pipe holds.
    let mut long = "0 BEGIN PGM LONG MM\n1 L X+0 Y+0 R0 F300\n".to_owned();
    for i in 0..20_000 {
        long += &format!("L X+{i}\n");
    }
    long += "END PGM LONG MM\n";
    folder.write("LONG.H", &long);
    for args in [vec!["compile", "LONG.H", "-o", "-"], vec!["trace", "LONG.H"], vec!["rules"], vec!["explain", "K2101"]]
    {
        let mut child = Command::new(env!("CARGO_BIN_EXE_partc"))
            .args(&args)
            .current_dir(&folder.0)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("partc runs");
        drop(child.stdout.take());
        let mut err = String::new();
        child.stderr.take().expect("a pipe").read_to_string(&mut err).expect("UTF-8");
        assert_eq!((child.wait().expect("partc ends").code(), err.as_str()), (Some(0), ""), "{args:?}");
    }
}

#[test]
fn no_temporary_file_is_left() {
    let folder = Folder::new("temporary").with(&[("PART.H", PART), ("WRONG.H", WRONG)]);
    folder.run(&["compile", "PART.H", "--map", "PART.map"]).exits(0);
    folder.run(&["compile", "WRONG.H", "--map", "WRONG.map"]).exits(1);
    folder.run(&["compile", "MISSING.H", "--map", "MISSING.map"]).exits(2);
    assert_eq!(folder.names(), set(&["PART.H", "PART.map", "PART.ngc", "WRONG.H"]));
}

// check, trace, explain, rules.

#[test]
fn check_writes_nothing_and_walks_folders() {
    let folder = Folder::new("check").with(&[
        ("shop/A.H", PART),
        ("shop/deep/B.h", WRONG),
        ("shop/deep/by_content.txt", &PART.replace("R0", "R7")),
        ("shop/notes.txt", "BEGIN with the left side\n"),
        ("shop/.hidden/C.H", WRONG),
        ("shop/.D.H", WRONG),
        ("empty/readme.md", "nothing\n"),
    ]);
    let before = folder.names();
    let ran = folder.run(&["check", "shop", "--format", "json"]).exits(1);
    assert_eq!(folder.names(), before);
    let report = ran.json();
    assert_eq!((&report["files"], &report["errors"]), (&json!(3), &json!(2)));
    let files: Vec<&str> =
        report["diagnostics"].as_array().expect("a list").iter().filter_map(|found| found["file"].as_str()).collect();
    assert_eq!(files, ["shop/deep/B.h", "shop/deep/by_content.txt"]);
    folder.run(&["check", "shop/A.H"]).exits(0).quietly();
    folder.run(&["check", "shop/A.H", "shop/deep/B.h"]).exits(1);
    folder.run(&["check", "empty"]).exits(0);
    // A file that is named has to be a program.
    folder.run(&["check", "shop/notes.txt"]).exits(2).says("--dialect");
}

#[test]
fn check_also_reads_blocks_that_never_run() {
    let text = "0 BEGIN PGM PART MM\n1 L X+10 Y+5 R0 F300 M30\n2 LBL 1\n3 L X+ Y+5\n4 LBL 0\n5 END PGM PART MM\n";
    let folder = Folder::new("never_run").with(&[("PART.H", text)]);
    let ran = folder.run(&["check", "PART.H", "--format", "concise"]).exits(1);
    assert_eq!(ran.codes(), ["K1001"]);
}

#[test]
fn check_and_compile_agree() {
    let text = PART.replace("Z-5", "Z+Q9");
    let folder = Folder::new("agree").with(&[("PART.H", &text)]);
    let check = folder.run(&["check", "PART.H", "--format", "concise"]).exits(1);
    let compile = folder.run(&["compile", "PART.H", "--format", "concise"]).exits(1);
    assert_eq!(check.err, compile.err);
}

#[test]
fn plot_draws_beside_the_program_and_replaces_nothing_foreign() {
    let text = "0 BEGIN PGM T MM\n1 L X+10 Y+0 Z+2 R0 FMAX\n2 L X+50 F200\n3 END PGM T MM\n";
    let folder =
        Folder::new("plot").with(&[("T.H", text), ("BAD.H", "0 BEGIN PGM T MM\n1 L X+10 R5\n2 END PGM T MM\n")]);
    folder.run(&["plot", "T.H"]).exits(0);
    let svg = folder.run(&["plot", "T.H", "-o", "-"]).exits(0).out;
    assert!(svg.contains("<svg ") && svg.contains("L50 0"), "{svg}");
    // A second time it is our own picture; a program is not.
    folder.run(&["plot", "T.H"]).exits(0);
    folder.run(&["plot", "T.H", "-o", "T.H"]).exits(2);
    folder.run(&["plot", "T.H", "-o", "BAD.H"]).exits(2);
    folder.run(&["plot", "BAD.H", "-o", "bad.svg"]).exits(1);
    folder.run(&["plot", "bad.svg", "-o", "-"]).exits(2);
}

#[test]
fn trace_gives_one_move_a_line() {
    let text = "0 BEGIN PGM T MM\n1 TOOL CALL 3 Z S2000\n2 L X+10 Y+0 Z+2 R0 FMAX\n3 CALL LBL 1\n4 M30\n5 LBL 1\n6 CC X+0 Y+0\n\
                7 C X+0 Y+10 DR+ F200\n8 L Z-1\n9 LBL 0\n10 END PGM T MM\n";
    let folder = Folder::new("trace").with(&[("T.H", text)]);
    let ran = folder.run(&["trace", "T.H"]).exits(0).quietly();
    let moves: Vec<Value> = ran.out.lines().map(|line| serde_json::from_str(line).expect("a JSON object")).collect();
    let kinds: Vec<&str> = moves.iter().filter_map(|mv| mv["kind"].as_str()).collect();
    assert_eq!(kinds, ["rapid", "arc", "line"]);
    assert_eq!(moves[0]["end"], json!({"X": 10.0, "Y": 0.0, "Z": 2.0}));
    assert!(moves[0].get("feed").is_none() && moves[0]["stack"] == json!([]));
    let arc = &moves[1];
    assert_eq!(arc["start"], moves[0]["end"]);
    assert_eq!(
        (&arc["center"], &arc["plane"], &arc["sweep_deg"]),
        (&json!({"X": 0.0, "Y": 0.0}), &json!("XY"), &json!(90.0))
    );
    assert_eq!(
        (&arc["feed"], &arc["tool"], &arc["file"], &arc["line"]),
        (&json!(200.0), &json!(3), &json!("T.H"), &json!(8))
    );
    assert_eq!(arc["stack"], json!([{"file": "T.H", "line": 4}]));
    assert_eq!((&moves[2]["end"]["Z"], &moves[2]["feed"]), (&json!(-1.0), &json!(200.0)));
    folder.run(&["trace", "T.H", "--format", "json"]).exits(2);
    assert_eq!(folder.names(), set(&["T.H"]));
}

#[test]
fn explain_by_code_and_by_name() {
    let folder = Folder::new("explain");
    let ran = folder.run(&["explain", "K2101"]).exits(0).quietly();
    assert!(
        ran.out.starts_with("K2101 pole-missing (error)\n") && ran.out.contains("Program `CC X… Y…` first."),
        "{}",
        ran.out
    );
    assert_eq!(folder.run(&["explain", "k2101"]).exits(0).out, ran.out);
    assert_eq!(folder.run(&["explain", "pole-missing"]).exits(0).out, ran.out);
    let found = folder.run(&["explain", "K2101", "--format", "json"]).exits(0).json();
    assert_eq!(
        (&found["code"], &found["name"], &found["severity"]),
        (&json!("K2101"), &json!("pole-missing"), &json!("error"))
    );
    folder.run(&["explain", "H2101"]).exits(2).says("K2101");
    folder.run(&["explain", "pole-mising"]).exits(2).says("pole-missing");
    folder.run(&["explain", "nonsense"]).exits(2).says("partc rules");
    for code in codes::all() {
        assert!(folder.run(&["explain", code.id]).exits(0).out.contains(code.title), "{}", code.id);
    }
}

#[test]
fn rules_lists_every_code() {
    let folder = Folder::new("rules");
    let ran = folder.run(&["rules"]).exits(0).quietly();
    let listed: Vec<&str> = ran.out.lines().filter_map(|line| line.split_whitespace().next()).collect();
    let all: Vec<&str> = codes::all().iter().map(|code| code.id).collect();
    assert_eq!(listed, all);
    let list = folder.run(&["rules", "--format", "json"]).exits(0).json();
    let list = list.as_array().expect("a list");
    assert_eq!(list.len(), all.len());
    for rule in list {
        for key in ["code", "name", "severity", "title", "explanation"] {
            assert!(rule[key].as_str().is_some_and(|text| !text.is_empty()), "{rule}");
        }
    }
}

#[test]
fn completions_and_manual_page() {
    let folder = Folder::new("completions");
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        assert!(folder.run(&["completions", shell]).exits(0).quietly().out.contains("partc"), "{shell}");
    }
    folder.run(&["completions", "dos"]).exits(2);
    let page = folder.run(&["man"]).exits(0).quietly().out;
    assert!(page.contains(".TH partc") && page.contains(".SH NAME"), "{page}");
    assert!(folder.run(&["--version"]).exits(0).out.starts_with("partc "));
}

// How findings are written.

/// Every field that the contract names.
#[test]
fn json_findings() {
    let text = "0 BEGIN PGM J MM\n1 L X+10 Y+0 R0 F300\n2 CC X+0\n3 C X+0 Y+10 DR+\n4 CALL LBL 1\n5 M30\n6 LBL 1\n\
                N7 L X+10 ; Ø78\n8 L Y+5 R5\n9 LBL 0\n10 END PGM J MM\n";
    let folder = Folder::new("json").with(&[("J.H", text)]);
    let ran = folder.run(&["check", "J.H", "--format", "json"]).exits(1).quietly();
    let report = ran.json();
    let keys: Vec<&String> = report.as_object().expect("an object").keys().collect();
    assert_eq!(keys, ["version", "diagnostics", "files", "errors", "warnings"]);
    assert_eq!((&report["version"], &report["files"]), (&json!(1), &json!(1)));
    assert_eq!((&report["errors"], &report["warnings"]), (&json!(1), &json!(1)));
    let found = report["diagnostics"].as_array().expect("a list");
    assert_eq!(found.len(), 2);
    for found in found {
        let text = |key: &str| found[key].as_str().unwrap_or_else(|| panic!("{key} of {found}"));
        let code = codes::find(text("code")).unwrap_or_else(|| panic!("{found}"));
        assert_eq!((text("name"), text("severity")), (code.name, code.severity.word()));
        assert!(!text("message").is_empty() && !text("help").is_empty());
        assert_eq!(text("file"), "J.H");
        for key in ["line", "column", "end_line", "end_column"] {
            assert!(found[key].as_u64().is_some_and(|n| n >= 1), "{key} of {found}");
        }
        assert!(found["stack"].is_array());
    }
    let warning = &found[0];
    assert_eq!(
        (&warning["code"], &warning["severity"], &warning["line"]),
        (&json!("K2102"), &json!("warning"), &json!(3))
    );
    assert_eq!((&warning["block"], &warning["stack"]), (&json!("2"), &json!([])));
    let error = &found[1];
    assert_eq!((&error["code"], &error["severity"], &error["block"]), (&json!("K1005"), &json!("error"), &json!("8")));
    assert_eq!(
        (&error["line"], &error["column"], &error["end_line"], &error["end_column"]),
        (&json!(9), &json!(9), &json!(9), &json!(11))
    );
    assert_eq!(error["stack"], json!([{"file": "J.H", "line": 5}]));
}

#[test]
fn json_columns_count_characters_and_blocks_without_a_number_have_none() {
    let folder = Folder::new("json_columns");
    folder.write("A.H", "0 BEGIN PGM A MM\nTOOL CALL \"Ø10\" Z S100 Q\nN12 L X+1 R5\nEND PGM A MM\n");
    let report = folder.run(&["check", "A.H", "--format", "json"]).exits(1).json();
    let found = &report["diagnostics"];
    assert_eq!((&found[0]["line"], &found[0]["column"]), (&json!(2), &json!(24)), "{found}");
    assert_eq!(found[0]["block"], Value::Null);
    assert_eq!((&found[1]["line"], &found[1]["block"]), (&json!(3), &json!("N12")), "{found}");
}

#[test]
fn json_of_a_clean_program_and_of_none() {
    let folder = Folder::new("json_clean").with(&[("PART.H", PART), ("none/readme.md", "\n")]);
    let report = folder.run(&["check", "PART.H", "--format", "json"]).exits(0).json();
    assert_eq!(report, json!({"version": 1, "diagnostics": [], "files": 1, "errors": 0, "warnings": 0}));
    let report = folder.run(&["compile", "PART.H", "--format", "json"]).exits(0).json();
    assert_eq!(report["errors"], json!(0));
    assert!(folder.has("PART.ngc"));
    let report = folder.run(&["check", "none", "--format", "json"]).exits(0).json();
    assert_eq!(report["files"], json!(0));
    // Program and findings cannot share standard output.
    folder.run(&["compile", "PART.H", "-o", "-", "--format", "json"]).exits(2).says("standard output");
}

#[test]
fn concise_findings_are_one_line_each() {
    let folder = Folder::new("concise").with(&[("WRONG.H", WRONG), ("WARNED.H", WARNED)]);
    let ran = folder.run(&["check", "WRONG.H", "WARNED.H", "--format", "concise"]).exits(1);
    assert_eq!(ran.out, "");
    let lines: Vec<&str> = ran.err.lines().collect();
    assert_eq!(lines.len(), 3, "{}", ran.err);
    assert!(lines[0].starts_with("WRONG.H:2:14: error[K1005]: `R5` has no place in "), "{}", lines[0]);
    assert!(lines[1].starts_with("WARNED.H:3:3: warning[K2102]: "), "{}", lines[1]);
    assert!(lines[2].starts_with("1 error") && lines[2].contains("1 warning"), "{}", lines[2]);
}

#[test]
fn human_findings_show_the_block() {
    let folder = Folder::new("human").with(&[("WRONG.H", WRONG)]);
    let ran = folder.run(&["check", "WRONG.H"]).exits(1);
    assert_eq!(ran.out, "");
    insta::assert_snapshot!(ran.err);
}

#[test]
fn human_findings_show_the_calls() {
    let text = "0 BEGIN PGM CALLS MM\n1 L X+0 Y+0 R0 F300\n2 CALL LBL 1\n3 M30\n4 LBL 1\n5 CALL LBL 2\n6 LBL 0\n7 LBL 2\n\
                8 L X+10 R5\n9 LBL 0\n10 END PGM CALLS MM\n";
    let folder = Folder::new("human_calls").with(&[("CALLS.H", text)]);
    insta::assert_snapshot!(folder.run(&["check", "CALLS.H"]).exits(1).err);
}

#[test]
fn quiet_shows_errors_only() {
    let folder = Folder::new("quiet").with(&[("WARNED.H", WARNED), ("WRONG.H", WRONG)]);
    folder.run(&["check", "WARNED.H", "--quiet"]).exits(0).quietly();
    folder.run(&["compile", "WARNED.H", "-q"]).exits(0).quietly();
    let ran = folder.run(&["check", "WARNED.H", "WRONG.H", "-q", "--format", "concise"]).exits(1);
    assert_eq!((ran.codes(), ran.err.lines().count()), (vec!["K1005"], 1));
}

#[test]
fn colours() {
    let folder = Folder::new("colours").with(&[("WRONG.H", WRONG)]);
    assert!(folder.run(&["check", "WRONG.H", "--color", "always"]).exits(1).err.contains('\u{1b}'));
    for args in [
        vec!["check", "WRONG.H"],
        vec!["check", "WRONG.H", "--color", "never"],
        vec!["check", "WRONG.H", "--color", "auto"],
    ] {
        assert!(!folder.run(&args).exits(1).err.contains('\u{1b}'), "{args:?}");
    }
    folder.run(&["check", "WRONG.H", "--color", "sometimes"]).exits(2);
}

// The source map.

#[test]
fn the_map_leads_from_every_line_to_its_block_and_calls() {
    let text = "0 BEGIN PGM MAP MM\n1 L X+0 Y+0 Z+2 R0 FMAX M3\n2 CALL LBL 1\n3 CALL PGM HOLE\n4 L X+50 FMAX\n5 CALL LBL 1\n\
                6 L Z+50 FMAX M30\n7 LBL 1\n8 L Z-3 F100\n9 CALL PGM HOLE\n10 LBL 0\n11 END PGM MAP MM\n";
    let folder = Folder::new("map").with(&[("MAP.H", text), ("HOLE.H", HOLE)]);
    folder.run(&["compile", "MAP.H", "--map", "MAP.json"]).exits(0);
    let map: Value = serde_json::from_str(&folder.read("MAP.json")).expect("a JSON document");
    assert_eq!((&map["version"], &map["output"]), (&json!(1), &json!("MAP.ngc")));
    let program = folder.read("MAP.ngc");
    let lines: Vec<&str> = program.lines().collect();
    let main = |line: u32| json!({"file": "MAP.H", "line": line});
    let expected = [
        ("M3", "MAP.H", 2, vec![]),
        ("G0 X0 Y0 Z2", "MAP.H", 2, vec![]),
        ("G1 Z-3 F100", "MAP.H", 9, vec![main(3)]),
        ("G1 Z-5 F150", "HOLE.H", 2, vec![main(10), main(3)]),
        ("G0 Z2", "HOLE.H", 3, vec![main(10), main(3)]),
        ("G1 Z-5", "HOLE.H", 2, vec![main(4)]),
        ("G0 Z2", "HOLE.H", 3, vec![main(4)]),
        ("G0 X50", "MAP.H", 5, vec![]),
        ("G1 Z-3 F100", "MAP.H", 9, vec![main(6)]),
        ("G1 Z-5 F150", "HOLE.H", 2, vec![main(10), main(6)]),
        ("G0 Z2", "HOLE.H", 3, vec![main(10), main(6)]),
        ("G0 Z50", "MAP.H", 7, vec![]),
        ("M30", "MAP.H", 7, vec![]),
    ];
    let entries = map["lines"].as_array().expect("a list");
    // Head and frame come from no block; every other line has its entry.
    assert_eq!(entries.len(), lines.len() - 6);
    assert_eq!(entries.len(), expected.len(), "{program}");
    for (i, (entry, (output, file, line, stack))) in entries.iter().zip(expected).enumerate() {
        assert_eq!(entry["line"], json!(i + 6), "{entry}");
        assert_eq!(lines[i + 5], output);
        assert_eq!(
            (&entry["file"], &entry["source_line"], &entry["stack"]),
            (&json!(file), &json!(line), &json!(stack)),
            "{output}"
        );
    }
}

// Configuration.

#[test]
fn the_nearest_configuration_wins() {
    let folder = Folder::new("nearest").with(&[
        ("partc.toml", "[output]\npass_m = [25]\n"),
        ("shop/partc.toml", "[output]\npass_m = [26]\n"),
        ("shop/deep/A.H", &PART.replace("FMAX M3\n", "FMAX M26\n")),
        ("other/A.H", &PART.replace("FMAX M3\n", "FMAX M25\n")),
    ]);
    folder.run(&["check", "shop/deep/A.H", "other/A.H"]).exits(0);
    folder.run(&["check", "other/A.H", "--isolated"]).exits(1).says("K2701");
    folder.run(&["check", "other/A.H", "--config", "shop/partc.toml"]).exits(1).says("K2701");
    folder.run(&["check", "other/A.H", "--config", "shop/partc.toml", "--isolated"]).exits(2);
    folder.run(&["check", "other/A.H", "--config", "missing.toml"]).exits(2).says("missing.toml");
    // Standard input is looked for where its name says, or here.
    let text = PART.replace("FMAX M3\n", "FMAX M26\n");
    folder.run_with(&["check", "-", "--stdin-filename", "shop/deep/NEW.H"], &text).exits(0);
    folder.run_with(&["check", "-"], &text).exits(1);
}

#[test]
fn a_configuration_extends_another() {
    let folder = Folder::new("extend").with(&[
        ("partc.toml", "[output]\npass_m = [25]\ndecimals = 3\n[tools]\ntable = \"tools/tool.t\"\n"),
        ("tools/tool.t", "BEGIN TOOL .T MM\nT   NAME   L     R\n5   A      +80   +5\n[END]\n"),
        ("shop/partc.toml", "extend = \"../partc.toml\"\n[output]\ndecimals = 5\n"),
        ("shop/A.H", &RADIUS.replace("X+50", "X+50.123456").replace("S2000", "S2000\nM25")),
    ]);
    let ran = folder.run(&["compile", "shop/A.H", "-o", "-"]).exits(0);
    assert!(ran.out.contains("\nM25\n") && ran.out.contains("X55.12346"), "{}", ran.out);
    folder.write("shop/partc.toml", "extend = \"partc.toml\"\n");
    folder.run(&["check", "shop/A.H"]).exits(2).says("circles");
    folder.write("shop/partc.toml", "extend = \"gone.toml\"\n");
    folder.run(&["check", "shop/A.H"]).exits(2).says("gone.toml");
    folder.write("shop/partc.toml", "extend = 5\n");
    folder.run(&["check", "shop/A.H"]).exits(2).says("extend");
}

#[test]
fn what_a_configuration_cannot_hold_is_refused() {
    let folder = Folder::new("config_errors").with(&[("A.H", PART)]);
    for (text, says) in [
        ("[output]\ndecimal = 3\n", "partc.toml:2:1: unknown key `decimal`; did you mean `decimals`?"),
        ("[machin]\nkind = \"mill\"\n", "did you mean `machine`?"),
        ("[control]\nklartext = \"tnc641\"\n", "did you mean `tnc640`?"),
        ("[output]\ndecimals = \"4\"\n", "whole number"),
        ("[output]\ndecimals = 9\n", "3 to 6"),
        ("[output\n", "partc.toml:1:"),
        ("[tools.1]\nradus = 5.0\n", "did you mean `radius`?"),
        ("[limits]\nsteps = 0\n", "at least 1"),
        ("[output]\ncomments = true\ncomments = false\n", "partc.toml:3:"),
        ("unknown = 1\n", "unknown key `unknown`"),
        ("output = 1\n", "[output]"),
    ] {
        folder.write("partc.toml", text);
        let ran = folder.run(&["compile", "A.H"]).exits(2).says(says);
        assert_eq!(ran.out, "");
        assert!(!folder.has("A.ngc"), "{text}");
    }
    // Both wrong keys are named at once.
    folder.write("partc.toml", "[output]\ndecimal = 3\ncoments = true\n");
    folder.run(&["compile", "A.H"]).exits(2).says("`decimals`").says("`comments`");
}

#[test]
fn options_win_over_the_configuration() {
    let text =
        "0 BEGIN PGM C MM\n1 TOOL CALL 1 Z S2000\n2 L X+0 Y+0 R0 F300\n3 L X+20 RL\n4 L X+40 R0\n5 END PGM C MM\n";
    let folder =
        Folder::new("options_win").with(&[("C.H", text), ("partc.toml", "[output]\ncompensation = \"control\"\n")]);
    assert!(folder.run(&["compile", "C.H", "-o", "-"]).exits(0).out.contains("G41 D1"));
    // What `resolve` makes of the contour is not looked at here, only that it is no longer the control's.
    let ran = folder.run(&["compile", "C.H", "-o", "-", "--compensation", "resolve"]);
    assert!(!ran.out.contains("G41"), "{}", ran.out);
    let ran = folder.run(&["compile", "C.H", "-o", "-", "--isolated", "--compensation", "control"]).exits(0);
    assert!(ran.out.contains("G41 D1"));
}

// Tool tables.

#[test]
fn tool_tables_of_both_kinds() {
    let tool_t = "BEGIN TOOL .T MM\nT    NAME       L        R\n5    MILL_D10   +80,5    +5\n[END]\n";
    let folder = Folder::new("tools").with(&[
        ("A.H", RADIUS),
        ("B.H", &RADIUS.replace("CALL 5 ", "CALL \"MILL_D10\" ")),
        ("TOOL.T", tool_t),
        ("tool.tbl", "T5 P5 D8.0 Z+80.5 ;8 mm end mill\n"),
        ("shop/partc.toml", "[tools]\ntable = \"../TOOL.T\"\n"),
        ("shop/A.H", RADIUS),
        ("both/partc.toml", "[tools]\ntable = \"../TOOL.T\"\n[tools.5]\nradius = 3.0\n"),
        ("both/A.H", RADIUS),
    ]);
    let end = |args: &[&str]| -> String {
        let mut all = vec!["compile", "-o", "-"];
        all.extend(args);
        let ran = folder.run(&all).exits(0).quietly();
        ran.out.lines().find(|line| line.ends_with("F200")).expect("the compensated move").to_owned()
    };
    folder.run(&["compile", "A.H"]).exits(1).says("K2008");
    assert_eq!(end(&["A.H", "--tools", "TOOL.T"]), "G1 X55 F200");
    assert_eq!(end(&["B.H", "--tools", "TOOL.T"]), "G1 X55 F200");
    assert_eq!(end(&["A.H", "--tools", "tool.tbl"]), "G1 X54 F200");
    assert_eq!(end(&["shop/A.H"]), "G1 X55 F200");
    // The option replaces the table of the configuration; a tool of the configuration wins over any table.
    assert_eq!(end(&["shop/A.H", "--tools", "tool.tbl"]), "G1 X54 F200");
    assert_eq!(end(&["both/A.H"]), "G1 X53 F200");
}

#[test]
fn tool_tables_that_cannot_be_used() {
    let folder = Folder::new("tools_wrong").with(&[
        ("A.H", RADIUS),
        ("broken.t", "BEGIN TOOL .T MM\nT    NAME   L     R\n5    A      +80   five\n[END]\n"),
        ("broken.tbl", "T1 D5\nhello world\n"),
        ("other.t", "BEGIN TOOL .T MM\nT    NAME   L     R\n6    A      +80   +5\n[END]\n"),
    ]);
    folder.run(&["compile", "A.H", "--tools", "broken.t"]).exits(2).says("broken.t:3: column R");
    folder.run(&["compile", "A.H", "--tools", "broken.tbl"]).exits(2).says("broken.tbl:2:");
    folder.run(&["compile", "A.H", "--tools", "gone.t"]).exits(2).says("gone.t");
    folder.write("partc.toml", "[tools]\ntable = \"gone.t\"\n");
    folder.run(&["compile", "A.H"]).exits(2).says("gone.t");
    assert!(!folder.has("A.ngc"));
    let ran = folder.run(&["compile", "A.H", "--tools", "other.t", "--format", "concise"]).exits(1);
    assert_eq!(ran.codes(), ["K2007", "K2008"]);
}

// Called programs.

/// Compiles `A.H` in the folder, which calls `name`; the codes of the findings and the moves.
fn calling(folder: &Folder, name: &str) -> (Vec<String>, Vec<String>) {
    folder.write("A.H", &caller(name));
    let ran = folder.run(&["compile", "A.H", "-o", "-", "--format", "concise"]);
    let codes = ran.codes().into_iter().map(str::to_owned).collect();
    (codes, body(&ran.out).into_iter().map(str::to_owned).collect())
}

#[track_caller]
fn calls(folder: &Folder, name: &str) {
    let (codes, moves) = calling(folder, name);
    assert!(codes.is_empty(), "{name}: {codes:?}");
    assert_eq!(moves, ["G0 X10 Y5 Z2", "G1 Z-5 F150", "G0 Z2", "G0 Z50", "M30"], "{name}");
}

#[track_caller]
fn refuses(folder: &Folder, name: &str, code: &str) {
    let (codes, moves) = calling(folder, name);
    assert_eq!(codes.first().map(String::as_str), Some(code), "{name}: {codes:?}");
    assert!(moves.is_empty(), "{name}: {moves:?}");
}

#[test]
fn called_programs_lie_beside_the_caller() {
    let folder = Folder::new("include").with(&[("HOLE.H", HOLE), ("sub/DEEP.H", HOLE)]);
    for name in
        ["HOLE", "HOLE.H", "\"HOLE.H\"", "hole", "Hole.h", "sub\\DEEP.H", "sub/DEEP", "SUB\\deep.h", ".\\HOLE.H"]
    {
        calls(&folder, name);
    }
    refuses(&folder, "HOLES", "P0101");
    refuses(&folder, "sub", "P0101");
    refuses(&folder, "sub\\", "P0101");
    // A called program looks beside itself.
    folder.write("sub/OUTER.H", "0 BEGIN PGM OUTER MM\n1 CALL PGM DEEP\n2 END PGM OUTER MM\n");
    calls(&folder, "sub\\OUTER.H");
}

#[test]
fn a_missing_program_is_suggested() {
    let folder = Folder::new("include_like").with(&[("HOLE.H", HOLE), ("A.H", &caller("HOEL.H"))]);
    folder.run(&["check", "A.H"]).exits(1).says("did you mean `HOLE.H`?");
}

#[test]
fn include_roots_stand_for_drives_and_folders_of_the_control() {
    let folder = Folder::new("include_roots").with(&[
        ("partc.toml", "[include]\nroots = { \"TNC:\" = \"tnc\", \"TNC:\\\\SPECIAL\" = \"other\" }\n"),
        ("tnc/PARTS/HOLE.H", HOLE),
        ("other/HOLE2.H", HOLE),
        ("tnc/SPECIAL/HOLE3.H", HOLE),
    ]);
    for name in [
        "TNC:\\PARTS\\HOLE.H",
        "TNC:/PARTS/HOLE.H",
        "tnc:\\parts\\hole.h",
        "\"TNC:\\PARTS\\HOLE.H\"",
        "TNC:PARTS\\HOLE.H",
    ] {
        calls(&folder, name);
    }
    // The longest prefix wins, whatever lies under the shorter one.
    calls(&folder, "TNC:\\SPECIAL\\HOLE2.H");
    refuses(&folder, "TNC:\\SPECIAL\\HOLE3.H", "P0101");
    // Roots are searched for names without a drive, too.
    calls(&folder, "HOLE2.H");
    refuses(&folder, "PLC:\\HOLE.H", "P0104");
    refuses(&folder, "TNC:\\PARTS\\GONE.H", "P0101");
}

#[test]
fn nothing_outside_the_include_roots_is_opened() {
    let folder = Folder::new("include_outside/inside").with(&[
        ("../SECRET.H", HOLE),
        ("partc.toml", "[include]\nroots = { \"TNC:\" = \"tnc\" }\n"),
        ("tnc/HOLE.H", HOLE),
    ]);
    let absolute = folder.0.parent().expect("a folder").join("SECRET.H");
    refuses(&folder, "..\\SECRET.H", "P0102");
    refuses(&folder, "../SECRET.H", "P0102");
    refuses(&folder, "tnc/../../SECRET.H", "P0102");
    refuses(&folder, "TNC:\\..\\..\\SECRET.H", "P0102");
    refuses(&folder, absolute.to_str().expect("UTF-8"), "P0104");
    calls(&folder, "TNC:\\HOLE.H");
    refuses(&folder, "\\\\server\\share\\HOLE.H", "P0102");
    refuses(&folder, "NUL", "P0102");
    refuses(&folder, "com1.H", "P0102");
    refuses(&folder, &"A".repeat(300), "P0102");
}

#[cfg(unix)]
#[test]
fn links_may_not_lead_out() {
    use std::os::unix::fs::symlink;
    let folder =
        Folder::new("include_link/inside").with(&[("../SECRET.H", HOLE), ("../far/SECRET2.H", HOLE), ("HOLE.H", HOLE)]);
    symlink("../SECRET.H", folder.0.join("OUT.H")).expect("a link");
    symlink("../far", folder.0.join("far")).expect("a link");
    symlink("HOLE.H", folder.0.join("IN.H")).expect("a link");
    symlink("GONE.H", folder.0.join("DANGLING.H")).expect("a link");
    calls(&folder, "IN.H");
    refuses(&folder, "OUT.H", "P0102");
    refuses(&folder, "far\\SECRET2.H", "P0102");
    refuses(&folder, "DANGLING.H", "P0101");
}

#[cfg(target_os = "linux")]
#[test]
fn names_that_differ_in_case_only_are_ambiguous() {
    let folder = Folder::new("include_case").with(&[("HOLE.H", HOLE), ("Hole.H", HOLE)]);
    refuses(&folder, "hole.h", "P0103");
    // The name as it is written is no question.
    calls(&folder, "Hole.H");
    calls(&folder, "HOLE.H");
}

#[test]
fn a_program_that_calls_itself_is_found_whatever_the_name() {
    let folder = Folder::new("include_itself");
    refuses(&folder, "A.H", "K2204");
    refuses(&folder, "a", "K2204");
    refuses(&folder, ".\\A.H", "K2204");
}

// Telling the dialect.

#[test]
fn the_dialect_is_told_or_asked_for() {
    let folder = Folder::new("dialect").with(&[
        ("content.txt", PART),
        ("PART.H", "L X+10 Y+5 R0 F300\n"),
        ("unknown.txt", "L X+10 Y+5 R0 F300\n"),
        ("empty.txt", ""),
    ]);
    folder.run(&["compile", "content.txt", "PART.H"]).exits(0);
    folder.run(&["compile", "unknown.txt"]).exits(2).says("--dialect");
    folder.run(&["compile", "empty.txt"]).exits(2).says("--dialect");
    folder.run(&["check", "unknown.txt"]).exits(2).says("--dialect");
    folder.run(&["trace", "unknown.txt"]).exits(2).says("--dialect");
    folder.run(&["compile", "unknown.txt", "--dialect", "klartext"]).exits(0);
    folder.run(&["compile", "content.txt", "--dialect", "auto"]).exits(0);
}
