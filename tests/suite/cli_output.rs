//! The command line and its files: whole outputs or none, whatever kills the process; pipes, links and rights; names
//! that would write to the terminal; configurations that nobody named.
#![cfg(unix)]

use std::fs;
use std::io::Read as _;
use std::os::unix::fs::{PermissionsExt as _, symlink};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use super::cli_run::{Folder, HOLE, PART, WRONG, caller, set};
use super::quality::kills::{kills, long};

/// How often the process is killed; `examples/quality.rs` does it more often.
const KILLS: usize = 200;

fn partc(folder: &Folder, args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_partc"));
    command.args(args).current_dir(&folder.0).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command
}

#[test]
fn a_killed_process_leaves_the_older_output_or_the_whole_new_one() {
    let folder = Folder::new("killed");
    let seen = kills(Path::new(env!("CARGO_BIN_EXE_partc")), &folder.0, KILLS);
    assert!(seen.broken.is_empty(), "{:?}", seen.broken);
    assert!(seen.killed * 4 > KILLS, "only {} of {KILLS} processes were killed in time", seen.killed);
    assert_eq!(folder.names(), set(&["LONG.H", "LONG.ngc", "LONG.map"]));
}

#[cfg(target_os = "linux")]
#[test]
fn while_it_is_written_an_output_has_no_name() {
    let folder = Folder::new("no_name").with(&[("LONG.H", &long(1))]);
    let mut child = partc(&folder, &["compile", "LONG.H"]).spawn().expect("partc runs");
    while child.try_wait().expect("partc runs").is_none() {
        let names = folder.names();
        assert!(names.iter().all(|name| name == "LONG.H" || name == "LONG.ngc"), "{names:?}");
    }
    assert!(folder.read("LONG.ngc").ends_with("M30\n%\n"));
}

#[test]
fn an_output_keeps_the_rights_of_the_file_that_it_replaces() {
    let folder = Folder::new("rights").with(&[("PART.H", PART)]);
    let mode = |name: &str| fs::metadata(folder.0.join(name)).expect("a file").permissions().mode() & 0o777;
    folder.run(&["compile", "PART.H", "--map", "m.json"]).exits(0);
    fs::write(folder.0.join("plain"), "").expect("a file");
    assert_eq!((mode("PART.ngc"), mode("m.json")), (mode("plain"), mode("plain")));
    for rights in [0o600, 0o640, 0o664] {
        for name in ["PART.ngc", "m.json"] {
            fs::set_permissions(folder.0.join(name), fs::Permissions::from_mode(rights)).expect("rights");
        }
        folder.run(&["compile", "PART.H", "--map", "m.json"]).exits(0);
        assert_eq!((mode("PART.ngc"), mode("m.json")), (rights, rights));
    }
}

#[test]
fn an_output_goes_through_a_link() {
    let folder = Folder::new("through_link").with(&[("PART.H", PART), ("far/old.ngc", ""), ("mine.txt", "mine\n")]);
    let link = |to: &str, name: &str| symlink(to, folder.0.join(name)).expect("a link");
    link("far/old.ngc", "a.ngc");
    link("a.ngc", "b.ngc");
    link("far/new.ngc", "c.ngc");
    link("mine.txt", "d.ngc");
    link("e.ngc", "e.ngc");
    folder.run(&["compile", "PART.H"]).exits(0);
    let output = folder.read("PART.ngc");
    for (name, real) in [("a.ngc", "far/old.ngc"), ("b.ngc", "far/old.ngc"), ("c.ngc", "far/new.ngc")] {
        folder.write(real, "");
        folder.run(&["compile", "PART.H", "-o", name]).exits(0);
        assert!(folder.0.join(name).is_symlink() && !folder.0.join(real).is_symlink());
        assert_eq!(folder.read(real), output);
    }
    // Through a link, too, a foreign file stays, and an older output is set aside.
    folder.run(&["compile", "PART.H", "-o", "d.ngc"]).exits(2).says("--force");
    folder.run(&["compile", "PART.H", "-o", "e.ngc"]).exits(2).says("e.ngc");
    folder.write("PART.H", WRONG);
    folder.run(&["compile", "PART.H", "-o", "a.ngc"]).exits(1).says("far/old.ngc.stale");
    assert!(folder.has("far/old.ngc.stale") && !folder.has("far/old.ngc") && folder.0.join("a.ngc").is_symlink());
    folder.write("PART.H", PART);
    folder.run(&["compile", "PART.H", "-o", "a.ngc"]).exits(0);
    assert_eq!(folder.read("far/old.ngc"), output);
}

#[test]
fn pipes_are_inputs_and_outputs() {
    let folder = Folder::new("pipes").with(&[("PART.H", PART)]);
    let wanted = folder.run(&["compile", "PART.H", "-o", "-"]).exits(0).out;
    let body = |text: &str| text.lines().skip(3).map(str::to_owned).collect::<Vec<_>>();
    let fifo = folder.0.join("pipe.H");
    assert!(Command::new("mkfifo").arg(&fifo).status().expect("mkfifo runs").success());
    // As an output.
    let mut child = partc(&folder, &["compile", "PART.H", "-o", "pipe.H"]).spawn().expect("partc runs");
    let mut text = String::new();
    fs::File::open(&fifo).and_then(|mut pipe| pipe.read_to_string(&mut text)).expect("a pipe");
    assert_eq!((child.wait().expect("partc ends").code(), text.as_str()), (Some(0), wanted.as_str()));
    // As an input.
    let mut child = partc(&folder, &["compile", "pipe.H", "-o", "made.ngc"]).spawn().expect("partc runs");
    fs::write(&fifo, PART).expect("a pipe");
    assert_eq!(child.wait().expect("partc ends").code(), Some(0));
    assert_eq!(body(&folder.read("made.ngc")), body(&wanted));
    // As a shell writes `<(…)`.
    if Path::new("/dev/fd/0").exists() {
        let ran = folder.run_with(&["compile", "/dev/fd/0", "-o", "-"], PART).exits(0).quietly();
        assert_eq!(body(&ran.out), body(&wanted));
    }
}

#[cfg(target_os = "linux")]
#[test]
fn what_never_ends_is_no_input() {
    let folder = Folder::new("endless").with(&[("PART.H", PART)]);
    for args in [
        ["compile", "/dev/zero", "--dialect=klartext"],
        ["check", "/dev/zero", "--dialect=klartext"],
        ["trace", "/dev/random", "--dialect=sinumerik"],
        ["check", "PART.H", "--tools=/dev/zero"],
        ["check", "PART.H", "--config=/dev/zero"],
    ] {
        folder.run(&args).exits(2).says("is a device");
    }
    // A device as standard input counts as a pipe, which has a bound.
    let mut command = partc(&folder, &["check", "-", "--dialect=klartext"]);
    let zero = fs::File::open("/dev/zero").expect("a device");
    let output = command.stdin(zero).stderr(Stdio::piped()).output().expect("partc runs");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.contains("256 MiB"), "{said}");
}

#[test]
fn a_huge_called_program_is_not_read() {
    let folder =
        Folder::new("huge_called").with(&[("A.H", &caller("HUGE")), ("B.H", &caller("HOLE")), ("HOLE.H", HOLE)]);
    let sparse = fs::File::create(folder.0.join("HUGE.H")).expect("a file");
    sparse.set_len(3 << 30).expect("a sparse file");
    let start = Instant::now();
    folder.run(&["compile", "A.H"]).exits(1).says("P0120").says("3072 MiB").says("256 MiB");
    assert!(start.elapsed() < Duration::from_secs(10));
    folder.run(&["compile", "B.H"]).exits(0);
    // Many of them together: four fit, the fifth does not.
    let blocks: String = (0..5).map(|n| format!("CALL PGM L{n}\n")).collect();
    folder.write("C.H", &format!("0 BEGIN PGM C MM\n1 L X+0 Y+0 Z+2 R0 FMAX\n{blocks}END PGM C MM\n"));
    let program = |n: usize| format!("0 BEGIN PGM L{n} MM\n1 L Z-5 F150\n2 END PGM L{n} MM\n");
    for n in 0..5 {
        folder.write(&format!("L{n}.H"), &program(n));
    }
    folder.run(&["check", "C.H"]).exits(0);
}

// Names.

#[test]
fn names_of_files_do_nothing_to_the_terminal() {
    let name = "e\u{1b}[31m\u{202e}x.H";
    let folder = Folder::new("names").with(&[(name, WRONG), ("A.H", &caller("\u{202e}GONE\u{1b}[2J"))]);
    let tame = |ran: &str| {
        let active = |c: char| c != '\n' && (c.is_control() || matches!(c, '\u{202a}'..='\u{202e}'));
        assert!(!ran.contains(active), "{ran:?}");
    };
    let found = folder.run(&["check", name, "--format", "concise", "--color", "never"]).exits(1).says("e [31m x.H:2:");
    tame(&found.err);
    tame(&folder.run(&["check", name, "--color", "never"]).exits(1).says("e [31m x.H").err);
    tame(&folder.run(&["check", "A.H", "--color", "never"]).exits(1).says("GONE").err);
    let json = folder.run(&["check", name, "--format", "json"]).exits(1);
    tame(&json.out);
    assert_eq!(json.json()["diagnostics"][0]["file"], serde_json::json!(name));
    folder.write(name, PART);
    tame(&folder.run(&["compile", name, "-o", "a.ngc", "--map", "-"]).exits(0).out);
    tame(&folder.run(&["trace", name]).exits(0).out);
    tame(&folder.run(&["test", ".", "--update"]).out);
    // What is no file at all, and what is no argument.
    let gone = folder.run(&["check", "gone\u{1b}[31m.H"]).exits(2).says("gone [31m.H");
    tame(&gone.err);
    tame(&folder.run(&["check", "--\u{1b}[31mred"]).exits(2).err);
    // Beside errors nothing of it gets into the source map of the program or into its output.
    folder.write(name, WRONG);
    let ran = folder.run(&["compile", name, "-o", "a.ngc"]).exits(1).says("a.ngc.stale");
    assert!(!ran.err.contains('\u{202e}'));
}

// Configurations that nobody named.

#[test]
fn a_configuration_that_was_found_opens_nothing_outside_its_folder() {
    let folder = Folder::new("found_config").with(&[
        ("secret.toml", "password = \"x\"\n"),
        ("partc.toml", "[output]\ndecimals = 3\n"),
        ("lib/HOLE.H", HOLE),
        ("down/PART.H", PART),
        ("down/sub/base.toml", "[output]\ncomments = false\n"),
    ]);
    let config = |text: &str| folder.write("down/partc.toml", text);
    let outside = fs::canonicalize(&folder.0).expect("a folder").join("secret.toml");
    for other in ["../secret.toml", "sub/../../secret.toml", "/etc/passwd", &outside.to_string_lossy()] {
        config(&format!("extend = {other:?}\n"));
        let ran = folder.run(&["check", "down/PART.H"]).exits(2).says("partc.toml:1:").says("--config");
        assert!(!ran.err.contains("password") && !ran.err.contains("root"), "{}", ran.err);
        // Named, it is trusted: here the file is read, and is no configuration.
        folder.run(&["check", "down/PART.H", "--config", "down/partc.toml"]).exits(2).says("key");
        if other == "/etc/passwd" {
            break;
        }
    }
    for (root, code) in [("..", 2), ("/", 2), ("../lib", 2), ("sub", 0), (".", 0), ("not/there", 0), ("not/../../x", 2)]
    {
        config(&format!("[include]\nroots = {{ \"TNC:\" = {root:?} }}\n"));
        folder.run(&["check", "down/PART.H"]).exits(code);
        folder.run(&["check", "down/PART.H", "--config", "down/partc.toml"]).exits(0);
    }
    // A link out is outside; the configuration of a folder above would be found anyway.
    symlink("../lib", folder.0.join("down/link")).expect("a link");
    config("[include]\nroots = { \"TNC:\" = \"link\" }\n");
    folder.run(&["check", "down/PART.H"]).exits(2).says("partc.toml:2:");
    config("extend = \"../partc.toml\"\n");
    folder.run(&["check", "down/PART.H"]).exits(0);
    config("extend = \"sub/base.toml\"\n");
    folder.run(&["check", "down/PART.H"]).exits(0);
}

/// A pipe waits for somebody who reads it: not for ever.
#[cfg(target_os = "linux")]
#[test]
fn an_output_that_is_a_pipe_which_nobody_reads_is_given_up() {
    let folder = Folder::new("pipe_out").with(&[("PART.H", PART)]);
    let pipe = folder.0.join("out");
    assert!(Command::new("mkfifo").arg(&pipe).status().expect("mkfifo runs").success());
    folder.run(&["compile", "PART.H", "-o", "out"]).exits(2).says("without a reader");
    let reader = std::thread::spawn(move || fs::read_to_string(pipe));
    folder.run(&["compile", "PART.H", "-o", "out"]).exits(0);
    assert!(reader.join().expect("a reader").expect("a pipe").contains("M30"));
}
