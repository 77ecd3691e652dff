//! Files of somebody else: a configuration that was found by itself reads none, and no output takes the place of one.

use std::fs;
use std::path::Path;
use std::process::Command;

use super::cli_run::{Folder, PART, RADIUS};

const TABLE: &str = "BEGIN TOOL .T MM\nT   NAME   L     R\n5   A      +80   +5\n[END]\n";
const SECRET: &str = "token_0123456789 second third\n";

#[cfg(unix)]
fn link(folder: &Folder, to: &str, name: &str) {
    std::os::unix::fs::symlink(to, folder.0.join(name)).expect("a link");
}

#[cfg(unix)]
fn fifo(folder: &Folder, name: &str) {
    assert!(Command::new("mkfifo").arg(folder.0.join(name)).status().expect("mkfifo runs").success());
}

// Configurations.

#[test]
#[cfg(unix)]
fn a_configuration_that_was_found_reads_no_file_outside_its_folder() {
    let folder = Folder::new("foreign_tables").with(&[
        ("secret", SECRET),
        ("tool.t", TABLE),
        ("shop/A.H", RADIUS),
        ("shop/tables/tool.t", TABLE),
    ]);
    link(&folder, "../secret", "shop/link");
    link(&folder, "..", "shop/up");
    let secret = folder.0.join("secret").display().to_string();
    for path in [&secret, "../secret", "link", "up/secret", "tables/../../secret", "/etc/passwd", "../missing"] {
        for key in ["[tools]\ntable", "[control]\ndatum_table"] {
            folder.write("shop/partc.toml", &format!("{key} = \"{path}\"\n"));
            for command in ["check", "compile"] {
                let ran = folder.run(&[command, "shop/A.H"]).exits(2).says("leads out of the folder");
                assert!(!ran.err.contains("token") && !ran.err.contains("root:"), "{}", ran.err);
            }
        }
    }
    // Who names the configuration means it.
    folder.write("shop/partc.toml", "[tools]\ntable = \"../tool.t\"\n");
    folder.run(&["check", "shop/A.H"]).exits(2);
    folder.run(&["check", "shop/A.H", "--config", "shop/partc.toml"]).exits(0);
    folder.write("shop/partc.toml", "");
    folder.run(&["check", "shop/A.H", "--tools", "tool.t"]).exits(0);
    folder.write("shop/partc.toml", "[tools]\ntable = \"tables/tool.t\"\n");
    folder.run(&["check", "shop/A.H"]).exits(0);
    // The one above has a folder of its own.
    folder.write("partc.toml", "[tools]\ntable = \"tool.t\"\n");
    folder.write("shop/partc.toml", "extend = \"../partc.toml\"\n");
    folder.run(&["check", "shop/A.H"]).exits(0);
}

#[test]
#[cfg(unix)]
fn a_link_in_the_place_of_a_configuration_leads_nowhere_else() {
    let folder = Folder::new("foreign_config").with(&[
        ("secret", SECRET),
        ("other/shared.toml", "[output]\npass_m = [26]\n"),
        ("partc.toml", "[output]\npass_m = [26]\n"),
        ("shop/A.H", &PART.replace("FMAX M3\n", "FMAX M26\n")),
        ("shop/own.toml", "[output]\npass_m = [26]\n"),
    ]);
    for (to, is_taken) in
        [("own.toml", true), ("../partc.toml", true), ("../other/shared.toml", false), ("../secret", false)]
    {
        link(&folder, to, "shop/partc.toml");
        let ran = folder.run(&["check", "shop/A.H"]).exits(if is_taken { 0 } else { 2 });
        assert!(is_taken || ran.err.contains("leads out of the folder"), "{}", ran.err);
        assert!(!ran.err.contains("token"), "{}", ran.err);
        let key = folder.run(&["key", "shop/A.H"]).exits(if is_taken { 0 } else { 2 });
        assert!(!key.err.contains("token"), "{}", key.err);
        if !is_taken && to != "../secret" {
            folder.run(&["check", "shop/A.H", "--config", "shop/partc.toml"]).exits(0);
        }
        fs::remove_file(folder.0.join("shop/partc.toml")).expect("a link");
    }
}

#[test]
#[cfg(unix)]
fn a_configuration_that_cannot_be_read_is_not_passed_over() {
    let folder = Folder::new("unreadable_config").with(&[("partc.toml", ""), ("shop/A.H", PART)]);
    let place = folder.0.join("shop/partc.toml");
    let refuses = |says: &str| {
        for command in ["check", "compile", "trace"] {
            folder.run(&[command, "shop/A.H"]).exits(2).says(says);
        }
        folder.run_with(&["check", "-", "--stdin-filename", "shop/NEW.H"], PART).exits(2).says(says);
        folder.run(&["check", "shop/A.H", "--isolated"]).exits(0);
    };
    link(&folder, "gone.toml", "shop/partc.toml");
    refuses("a link that leads nowhere");
    fs::remove_file(&place).expect("a link");
    link(&folder, "partc.toml", "shop/partc.toml");
    refuses("partc.toml");
    fs::remove_file(&place).expect("a link");
    fs::create_dir(&place).expect("a folder");
    refuses("is a folder");
    fs::remove_dir(&place).expect("a folder");
    fifo(&folder, "shop/partc.toml");
    refuses("is a pipe");
    fs::remove_file(&place).expect("a pipe");
    folder.run(&["check", "shop/A.H"]).exits(0);
}

#[test]
#[cfg(unix)]
fn nobody_waits_for_a_pipe() {
    let folder = Folder::new("pipes").with(&[("A.H", RADIUS), ("deep/A.H", RADIUS)]);
    fifo(&folder, "pipe");
    fifo(&folder, "deep/B.H");
    for text in ["[tools]\ntable = \"pipe\"\n", "[control]\ndatum_table = \"pipe\"\n", "extend = \"pipe\"\n"] {
        folder.write("partc.toml", text);
        folder.run(&["check", "A.H"]).exits(2).says("is a pipe");
        folder.run(&["check", "A.H", "--config", "partc.toml"]).exits(2).says("is a pipe");
    }
    folder.write("partc.toml", "");
    folder.run(&["check", "A.H", "--config", "pipe"]).exits(2).says("is a pipe");
    folder.run(&["check", "A.H", "--tools", "pipe"]).exits(2).says("is a pipe");
    // Programs of a folder, and programs that are called.
    folder.write("partc.toml", "[tools.5]\nradius = 5.0\n");
    folder.run(&["check", "deep"]).exits(0);
    folder.write("C.H", "0 BEGIN PGM C MM\n1 CALL PGM deep/B.H\n2 END PGM C MM\n");
    folder.run(&["check", "C.H"]).exits(1).says("P0105").says("is a pipe");
}

// Outputs.

#[test]
fn a_protected_output_is_kept() {
    let folder = Folder::new("protected").with(&[("A.H", PART)]);
    folder.run(&["compile", "A.H", "--map", "A.map"]).exits(0);
    folder.run(&["plot", "A.H", "-o", "A.svg"]).exits(0);
    let protect = |name: &str, on: bool| {
        let path = folder.0.join(name);
        let mut rights = fs::metadata(&path).expect("a file").permissions();
        rights.set_readonly(on);
        fs::set_permissions(path, rights).expect("rights");
    };
    let (program, map) = (folder.read("A.ngc"), folder.read("A.map"));
    folder.write("A.H", &PART.replace("X+10", "X+11"));
    for (name, args) in [
        ("A.ngc", &["compile", "A.H"][..]),
        ("A.ngc", &["compile", "A.H", "--map", "A.map"]),
        ("A.ngc", &["compile", "A.H", "--force"]),
        ("A.map", &["compile", "A.H", "--map", "A.map"]),
        ("A.svg", &["plot", "A.H", "-o", "A.svg"]),
    ] {
        protect(name, true);
        folder.run(args).exits(2).says("write-protected");
        protect(name, false);
        assert_eq!((folder.read("A.ngc"), folder.read("A.map")), (program.clone(), map.clone()), "{args:?}");
    }
    folder.run(&["compile", "A.H", "--map", "A.map"]).exits(0);
    assert!(folder.read("A.ngc") != program && folder.read("A.map").contains("\"lines\""));
}

/// A closed stream is no place for a program; the null device is one.
#[test]
#[cfg(target_os = "linux")]
fn a_closed_standard_output_is_no_success() {
    let folder = Folder::new("closed_stdout").with(&[("A.H", PART)]);
    let run = |line: &str| {
        let partc = env!("CARGO_BIN_EXE_partc");
        let ran = Command::new("sh").args(["-c", &line.replace("partc", partc)]).current_dir(&folder.0).output();
        let ran = ran.expect("a shell");
        (ran.status.code(), String::from_utf8(ran.stderr).expect("UTF-8"))
    };
    for line in ["partc compile A.H -o - >&-", "partc trace A.H >&-", "partc plot A.H -o - >&-"] {
        let (code, says) = run(line);
        assert!(code == Some(2) && says.contains("standard output is closed"), "{line}: {code:?} {says}");
    }
    for line in ["partc compile A.H -o - >/dev/null", "partc compile A.H -o /dev/null >&-", "partc check A.H >&-"] {
        assert_eq!(run(line).0, Some(0), "{line}");
    }
    assert!(Path::new("/dev/null").exists());
}

// Programs that are no main programs.

#[test]
fn subprograms_need_no_end_of_a_main_program() {
    let folder = Folder::new("subprograms").with(&[
        ("SUB.SPF", "PROC SUB(REAL D)\nG90 G0 X0 Y0 Z5\nG1 X=D F100\nM17\n"),
        ("RET.SPF", "G90 G0 X0 Y0 Z5\nRET\n"),
        ("OPEN.SPF", "G90 G0 X0 Y0 Z5\n"),
        ("SUB.npg", "G90 G00 X0\nRTS\n"),
        ("MAIN.MPF", "G90 G0 X0 Y0 Z5\n"),
    ]);
    for name in ["SUB.SPF", "RET.SPF", "OPEN.SPF", "SUB.npg"] {
        let ran = folder.run(&["check", name]);
        assert!(!ran.err.contains("P000"), "{name}: {}", ran.err);
    }
    folder.run(&["check", "MAIN.MPF"]).exits(1).says("P0007");
    folder.write("OPEN.SPF", "G90 G0 X0 Y0 Z5");
    folder.run(&["check", "OPEN.SPF"]).exits(1).says("P0008");
}
