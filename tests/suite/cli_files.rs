//! The command line and its files: what is written over what, names, streams that nobody reads, `test`, `config`.

use std::fs;
use std::process::{Command, Stdio};

use serde_json::{Value, json};

use super::cli_run::{Folder, HOLE, PART, WARNED, WRONG, caller, set};

// What is written over what.

#[test]
fn the_map_replaces_neither_input_nor_output_nor_a_foreign_file() {
    let folder = Folder::new("map_replaces").with(&[("PART.H", PART), ("notes.txt", "mine\n")]);
    folder.run(&["compile", "PART.H", "--map", "PART.H"]).exits(2).says("replace the input");
    folder.run(&["compile", "PART.H", "--map", "./PART.H", "--force"]).exits(2).says("replace the input");
    folder.run(&["compile", "PART.H", "--map", "PART.ngc"]).exits(2).says("different files");
    folder.run(&["compile", "PART.H", "-o", "a.ngc", "--map", "./a.ngc"]).exits(2).says("different files");
    folder.run(&["compile", "PART.H", "--map", "notes.txt"]).exits(2).says("--force");
    assert_eq!((folder.read("PART.H").as_str(), folder.read("notes.txt").as_str()), (PART, "mine\n"));
    assert_eq!(folder.names(), set(&["PART.H", "notes.txt"]));
    // Its own map is replaced, and any file by --force.
    folder.run(&["compile", "PART.H", "--map", "PART.map"]).exits(0);
    folder.run(&["compile", "PART.H", "--map", "PART.map"]).exits(0);
    folder.run(&["compile", "PART.H", "--map", "notes.txt", "--force"]).exits(0);
    assert_eq!(folder.read("notes.txt"), folder.read("PART.map"));
}

#[test]
fn the_map_to_standard_output() {
    let folder = Folder::new("map_stdout").with(&[("PART.H", PART)]);
    let ran = folder.run(&["compile", "PART.H", "--map", "-"]).exits(0).quietly();
    let map: Value = serde_json::from_str(&ran.out).expect("a JSON document");
    assert_eq!(map["output"], json!("PART.ngc"));
    assert_eq!(folder.names(), set(&["PART.H", "PART.ngc"]));
    folder.run(&["compile", "PART.H", "-o", "-", "--map", "-"]).exits(2).says("standard output");
    folder.run(&["compile", "PART.H", "--map", "-", "--format", "json"]).exits(2).says("standard output");
}

#[cfg(target_os = "linux")]
#[test]
fn the_map_to_a_device() {
    let folder = Folder::new("map_device").with(&[("PART.H", PART)]);
    folder.run(&["compile", "PART.H", "--map", "/dev/null"]).exits(0).quietly();
    folder.run(&["compile", "PART.H", "--map", "/dev/full"]).exits(2).says("/dev/full");
}

#[test]
fn two_inputs_never_share_an_output() {
    let folder =
        Folder::new("same_name").with(&[("a/PART.H", PART), ("b/PART.H", PART), ("PART.H", PART), ("PART.h", PART)]);
    folder.run(&["compile", "a/PART.H", "b/PART.H", "--out-dir", "out"]).exits(2).says("out/PART.ngc");
    assert!(!folder.has("out/PART.ngc"));
    folder.run(&["compile", "PART.H", "PART.h"]).exits(2).says("PART.h would both be written");
    assert!(!folder.has("PART.ngc"));
    // Folders keep their trees: two of them may hold the same name.
    folder.run(&["compile", "a", "b", "--out-dir", "out"]).exits(2).says("out/PART.ngc");
    folder.run(&["compile", "a/PART.H", "./a/PART.H"]).exits(2).says("would both be written");
    // Nor is an output lost to a report of the same run.
    for report in ["json=a/PART.ngc", "human=a/../a/PART.ngc"] {
        folder.run(&["compile", "a/PART.H", "--report", report]).exits(2).says("made of a program");
    }
    folder.run(&["compile", "a/PART.H", "-o", "x.out", "--report", "json=x.out"]).exits(2).says("made of a program");
    folder.run(&["compile", "a/PART.H", "--map", "x.map", "--report", "json=x.map"]).exits(2);
    folder.run(&["plot", "a/PART.H", "-o", "x.svg", "--report", "json=x.svg"]).exits(2);
    assert!(!["a/PART.ngc", "x.out", "x.map", "x.svg"].iter().any(|name| folder.has(name)));
    folder.run(&["compile", "a/PART.H", "b/PART.H"]).exits(0);
    assert!(folder.has("a/PART.ngc") && folder.has("b/PART.ngc"));
}

#[test]
fn an_output_by_name_replaces_no_foreign_file() {
    let folder = Folder::new("foreign_by_name").with(&[("A.H", PART), ("B.H", HOLE), ("C.H", PART)]);
    folder.run(&["compile", "A.H", "-o", "B.H"]).exits(2).says("--force");
    assert_eq!(folder.read("B.H"), HOLE);
    folder.run(&["compile", "A.H", "-o", "made.nc"]).exits(0);
    folder.run(&["compile", "A.H", "-o", "made.nc"]).exits(0);
    folder.run(&["compile", "A.H", "-o", "B.H", "--force"]).exits(0);
    assert!(folder.read("B.H").starts_with("%\n(partc "));
    // A comment that speaks of partc does not make a file one of its outputs.
    folder.write("mine.nc", "G0 X1 (partc does this)\n");
    folder.run(&["compile", "A.H", "-o", "mine.nc"]).exits(2);
    // An output beside its input can be another input, too.
    folder.write("C.ngc", PART);
    folder.run(&["compile", "C.H", "C.ngc", "--force"]).exits(2);
    assert_eq!(folder.read("C.ngc"), PART);
}

#[test]
fn an_older_output_is_set_aside_beside_a_foreign_stale_file() {
    let folder = Folder::new("stale_name").with(&[("PART.H", PART), ("PART.ngc.stale", "mine\n")]);
    folder.run(&["compile", "PART.H"]).exits(0);
    folder.write("PART.H", WRONG);
    folder.run(&["compile", "PART.H"]).exits(1).says("PART.ngc.stale.1");
    assert_eq!(folder.read("PART.ngc.stale"), "mine\n");
    assert_eq!(folder.names(), set(&["PART.H", "PART.ngc.stale", "PART.ngc.stale.1"]));
}

#[test]
fn an_older_source_map_is_set_aside_with_its_output() {
    let folder = Folder::new("stale_map").with(&[("PART.H", PART)]);
    folder.run(&["compile", "PART.H", "--map", "m.json"]).exits(0);
    folder.write("PART.H", WRONG);
    folder.run(&["compile", "PART.H", "--map", "m.json"]).exits(1).says("m.json.stale");
    assert_eq!(folder.names(), set(&["PART.H", "PART.ngc.stale", "m.json.stale"]));
}

#[test]
fn check_reads_on_behind_m30() {
    let text = "0 BEGIN PGM A MM\n1 L Z+2 R0 FMAX\n2 M30\n3 END PGM A INCH\n0 BEGIN PGM B MM\n1 END PGM B MM\n";
    let folder = Folder::new("behind_m30").with(&[("A.H", text)]);
    folder.run(&["check", "A.H"]).exits(1).says("K1009").says("P1008");
}

#[test]
fn a_similar_name_is_one_of_a_program() {
    let text = "0 BEGIN PGM A MM\n1 CALL PGM TEILE\n2 CALL PGM t\n3 END PGM A MM\n";
    let folder = Folder::new("similar").with(&[("A.H", text), ("TEIL.H", PART), ("TEILE.sh", "x"), ("g", "x")]);
    let found = folder.run(&["check", "A.H"]).exits(1).says("did you mean `TEIL.H`?");
    assert!(!found.err.contains("`g`"), "{}", found.err);
}

#[test]
fn too_many_output_blocks_leave_no_output() {
    // Five lines of head, three of the program, one of the frame.
    let folder =
        Folder::new("output_limit").with(&[("PART.H", "0 BEGIN PGM P MM\n1 L X+1 R0 F100\n2 L X+2\n3 END PGM P MM\n")]);
    for (most, code) in [(1, 1), (4, 1), (5, 1), (6, 1), (8, 1), (9, 0), (10, 0)] {
        folder.write("partc.toml", &format!("[limits]\noutput_blocks = {most}\n"));
        let ran = folder.run(&["compile", "PART.H"]).exits(code);
        assert_eq!(folder.has("PART.ngc"), code == 0, "{most}");
        folder.run(&["check", "PART.H"]).exits(code);
        if code == 1 {
            ran.says("P4002").says("raise `[limits] output_blocks`");
        } else {
            assert_eq!(folder.read("PART.ngc").lines().count(), 9);
        }
    }
}

/// A line that gives its feed to a line of its own counts as two.
#[test]
fn split_lines_count_for_the_output_limit() {
    let long = "0 BEGIN PGM A MM\n1 L X-12345.123456 Y-12345.123456 Z-12345.123456 A-12345.12 B-12345.12 C-123.12 R0 F12345.123\n\
                2 L X+1\n3 L X+2\n4 END PGM A MM\n";
    let folder = Folder::new("output_limit_split").with(&[("A.H", long)]);
    for (most, code) in [(6, 1), (7, 1), (10, 1), (11, 0)] {
        folder.write("partc.toml", &format!("[limits]\noutput_blocks = {most}\n[output]\ndecimals = 6\n"));
        folder.run(&["compile", "A.H", "-o", "A.ngc"]).exits(code);
    }
}

// Streams that nobody reads.

#[cfg(unix)]
#[test]
fn a_closed_stderr_changes_no_exit_code() {
    let folder = Folder::new("closed_stderr").with(&[("PART.H", PART), ("WRONG.H", WRONG), ("WARNED.H", WARNED)]);
    for (args, code) in [
        (vec!["compile", "WRONG.H"], 1),
        (vec!["check", "WRONG.H", "--format", "concise"], 1),
        (vec!["check", "WARNED.H"], 0),
        (vec!["compile", "MISSING.H"], 2),
        (vec!["compile", "--bogus"], 2),
        (vec!["explain", "X0000"], 2),
    ] {
        for closed in [Stdio::piped(), full_device()] {
            let mut child = Command::new(env!("CARGO_BIN_EXE_partc"))
                .args(&args)
                .current_dir(&folder.0)
                .stdout(Stdio::null())
                .stderr(closed)
                .spawn()
                .expect("partc runs");
            drop(child.stderr.take());
            assert_eq!(child.wait().expect("partc ends").code(), Some(code), "{args:?}");
        }
    }
}

#[cfg(unix)]
fn full_device() -> Stdio {
    match fs::File::options().write(true).open("/dev/full") {
        Ok(file) => file.into(),
        Err(_) => Stdio::piped(),
    }
}

#[cfg(unix)]
#[test]
fn every_command_takes_a_closed_pipe_alike() {
    let folder = Folder::new("closed_pipe_all").with(&[("WRONG.H", WRONG), ("PART.H", PART)]);
    for (args, code) in [
        (vec!["completions", "bash"], 0),
        (vec!["completions", "zsh"], 0),
        (vec!["man"], 0),
        (vec!["rules"], 0),
        (vec!["config", "--schema"], 0),
        (vec!["config", "--show", "PART.H"], 0),
        (vec!["check", "WRONG.H", "--format", "json"], 1),
        (vec!["compile", "PART.H", "--map", "-"], 0),
    ] {
        let mut child = Command::new(env!("CARGO_BIN_EXE_partc"))
            .args(&args)
            .current_dir(&folder.0)
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("partc runs");
        drop(child.stdout.take());
        assert_eq!(child.wait().expect("partc ends").code(), Some(code), "{args:?}");
        let full = Command::new(env!("CARGO_BIN_EXE_partc"))
            .args(&args)
            .current_dir(&folder.0)
            .stdout(full_device())
            .stderr(Stdio::null())
            .status()
            .expect("partc runs");
        if fs::metadata("/dev/full").is_ok() {
            assert_eq!(full.code(), Some(2), "{args:?} to a full device");
        }
    }
}

// Names.

#[test]
fn programs_called_from_standard_input_lie_beside_its_name() {
    let folder = Folder::new("stdin_calls").with(&[("sub/HOLE.H", HOLE)]);
    let ran = folder.run_with(&["compile", "-", "--stdin-filename", "sub/A.H"], &caller("HOLE")).exits(0).quietly();
    assert!(ran.out.contains("G1 Z-5 F150"), "{}", ran.out);
    folder.run_with(&["compile", "-", "--stdin-filename", "A.H"], &caller("HOLE")).exits(1).says("P0101");
    let wrong = folder
        .run_with(
            &["check", "-", "--stdin-filename", "sub/A.H", "--format", "json"],
            &caller("HOLE").replace("FMAX", "R5"),
        )
        .exits(1);
    assert_eq!(wrong.json()["diagnostics"][0]["file"], json!("sub/A.H"));
}

#[test]
fn findings_in_called_programs_name_a_file_that_can_be_opened() {
    let wrong = HOLE.replace("Z-5", "Z-5 R5");
    let folder = Folder::new("called_names").with(&[
        ("sub/A.H", &caller("DEEP\\HOLE")),
        ("sub/DEEP/HOLE.H", &wrong),
        ("partc.toml", "[include]\nroots = { \"TNC:\" = \"lib\" }\n"),
        ("lib/HOLE.H", &wrong),
        ("B.H", &caller("TNC:\\HOLE.H")),
    ]);
    for (main, called) in [("sub/A.H", "sub/DEEP/HOLE.H"), ("B.H", "lib/HOLE.H"), ("./B.H", "lib/HOLE.H")] {
        let report = folder.run(&["check", main, "--format", "json"]).exits(1).json();
        let found = &report["diagnostics"][0];
        assert_eq!(found["file"], json!(called), "{report}");
        assert_eq!(found["stack"][0]["file"], json!(main), "{report}");
    }
}

#[test]
fn a_file_that_cannot_be_read_does_not_hide_the_findings_of_others() {
    let folder = Folder::new("one_missing").with(&[("WRONG.H", WRONG), ("PART.H", PART)]);
    let ran = folder.run(&["check", "GONE.H", "WRONG.H", "--format", "json"]).exits(2).says("GONE.H");
    let report = ran.json();
    assert_eq!((&report["files"], &report["errors"]), (&json!(1), &json!(1)));
    assert_eq!(report["diagnostics"][0]["code"], json!("P1003"));
    assert!(report["troubles"][0].as_str().is_some_and(|text| text.contains("GONE.H")), "{report}");
    folder.run(&["compile", "GONE.H", "PART.H"]).exits(2).says("GONE.H");
    assert!(folder.has("PART.ngc"));
    folder.run(&["check", "GONE.H", "WRONG.H"]).exits(2).says("GONE.H").says("P1003");
}

// How findings are written.

#[test]
fn check_counts_what_it_reads_and_runs_once() {
    let text =
        "0 BEGIN PGM A MM\n1 L X+ Y+5 R0 F100\n2 CALL LBL 1\n3 M30\n4 LBL 1\n5 L Y+ F100\n6 LBL 0\n7 END PGM A MM\n";
    let folder = Folder::new("form_once").with(&[("A.H", text)]);
    let check = folder.run(&["check", "A.H", "--format", "concise"]).exits(1);
    assert!(!check.err.contains("times"), "{}", check.err);
    let compile = folder.run(&["compile", "A.H", "--format", "concise"]).exits(1);
    assert_eq!(check.err, compile.err);
    let report = folder.run(&["check", "A.H", "--format", "json"]).exits(1).json();
    assert_eq!((&report["errors"], &report["diagnostics"][0]["times"]), (&json!(2), &json!(1)), "{report}");
    assert_eq!(report["diagnostics"][1]["stack"], json!([{"file": "A.H", "line": 3}]), "{report}");
}

#[test]
fn a_file_whose_lines_end_in_carriage_returns() {
    let text = WRONG.replace('\n', "\r");
    let folder = Folder::new("carriage_returns").with(&[("A.H", &text)]);
    let report = folder.run(&["check", "A.H", "--format", "json"]).exits(1).json();
    let found = &report["diagnostics"][0];
    assert_eq!(
        (&found["line"], &found["column"], &found["end_line"], &found["end_column"], &found["block"]),
        (&json!(2), &json!(14), &json!(2), &json!(16), &json!("1"))
    );
    let ran = folder.run(&["check", "A.H"]).exits(1).says("[A.H:2:14]").says(" 1 L X+10 Y+5 R5 F300\n");
    assert!(!ran.err.contains("BEGIN"), "{}", ran.err);
}

#[test]
fn a_continuation_line_has_the_number_of_its_block() {
    let text = "0 BEGIN PGM A MM\n1 L X+0 Y+0 Z+0 R0 F100\n2 CYCL DEF 247 DATUM SETTING ~\n  Q339=2 ~\n  Q3X9=5\n3 END PGM A MM\n";
    let folder = Folder::new("continuation").with(&[("A.H", text)]);
    let report = folder.run(&["check", "A.H", "--format", "json"]).exits(1).json();
    let found = &report["diagnostics"][0];
    assert_eq!((&found["line"], &found["block"]), (&json!(5), &json!("2")), "{report}");
}

#[test]
fn human_findings_are_tidy() {
    let folder = Folder::new("tidy").with(&[("WRONG.H", WRONG), ("WARNED.H", WARNED)]);
    let ran = folder.run(&["check", "WRONG.H"]).exits(1).says("[WRONG.H:2:14]").says("this L block");
    assert!(ran.err.lines().all(|line| line == line.trim_end()), "trailing blanks:\n{}", ran.err);
    assert!(ran.err.ends_with("\n1 error, 0 warnings\n"), "{}", ran.err);
    folder.run(&["check", "WARNED.H"]).exits(0).says("0 errors, 1 warning\n");
    folder.write("AGAIN.H", WRONG);
    folder.run(&["check", "WRONG.H", "AGAIN.H"]).exits(1).says("2 programs, 2 errors, 0 warnings\n");
    // Who names a program twice means it once.
    folder.run(&["check", "WRONG.H", "./", "WRONG.H"]).exits(1).says("3 programs, 2 errors, 1 warning\n");
}

#[test]
fn quiet_holds_for_json_too() {
    let folder = Folder::new("quiet_json").with(&[("WARNED.H", WARNED), ("WRONG.H", WRONG)]);
    let report = folder.run(&["check", "WARNED.H", "WRONG.H", "-q", "--format", "json"]).exits(1).json();
    let codes: Vec<&Value> =
        report["diagnostics"].as_array().expect("a list").iter().map(|found| &found["code"]).collect();
    assert_eq!(codes, [&json!("P1003")]);
    assert_eq!((&report["errors"], &report["warnings"]), (&json!(1), &json!(1)));
}

#[test]
fn an_empty_file_is_no_program() {
    let folder =
        Folder::new("empty").with(&[("A.H", ""), ("B.H", " \n\r\n"), ("N.H", "\0\0\0\n"), ("CALLER.H", &caller("B"))]);
    for name in ["A.H", "B.H", "N.H", "CALLER.H"] {
        folder.run(&["compile", name]).exits(1).says("P0004");
    }
    assert_eq!(folder.names(), set(&["A.H", "B.H", "N.H", "CALLER.H"]));
}

#[test]
fn findings_that_are_not_shown_are_counted() {
    let mut text = "0 BEGIN PGM MANY MM\n1 L X+0 Y+0 R0 F300\n".to_owned();
    for _ in 0..600 {
        text += "L X+10 R5\n";
    }
    text += "END PGM MANY MM\n";
    let folder = Folder::new("many").with(&[("MANY.H", &text)]);
    folder.run(&["check", "MANY.H"]).exits(1).says("100 more findings are not shown").says("600 errors, 0 warnings");
    let report = folder.run(&["check", "MANY.H", "--format", "json"]).exits(1).json();
    assert_eq!((&report["errors"], &report["not_shown"]), (&json!(600), &json!(100)));
    assert_eq!(report["diagnostics"].as_array().map(Vec::len), Some(500));
}

// partc test.

#[test]
fn golden_outputs_are_written_and_compared() {
    let folder = Folder::new("golden").with(&[
        ("shop/A.H", PART),
        ("shop/deep/B.H", &caller("HOLE")),
        ("shop/deep/HOLE.H", HOLE),
    ]);
    folder.run(&["test", "shop"]).exits(2).says("--update");
    let ran = folder.run(&["test", "shop", "--update"]).exits(0).quietly();
    assert!(
        ran.out.contains("written    shop/A.H\n") && ran.out.ends_with("3 cases: 0 same, 3 written\n"),
        "{}",
        ran.out
    );
    assert!(folder.read("shop/A.golden.ngc").starts_with("%\n(partc "));
    let before = folder.names();
    let ran = folder.run(&["test", "shop"]).exits(0).quietly();
    assert!(ran.out.ends_with("3 cases: 3 same\n"), "{}", ran.out);
    // Neither the version nor a comment in the source is a difference of the path; line ends neither.
    let golden = folder.read("shop/A.golden.ngc").replacen("(partc 0", "(partc 9", 1).replace('\n', "\r\n");
    folder.write("shop/A.golden.ngc", &golden);
    folder.run(&["test", "shop"]).exits(0);
    assert_eq!(folder.names(), before);
}

#[test]
fn a_golden_difference_is_shown_as_text_and_as_motion() {
    let folder = Folder::new("golden_differs").with(&[("A.H", PART), ("B.H", PART)]);
    folder.run(&["test", "--update"]).exits(0);
    folder.write("A.H", &PART.replace("Z-5 F150", "Z-5.5 F150"));
    let ran = folder.run(&["test"]).exits(1).quietly();
    insta::assert_snapshot!(ran.out);
    let report = folder.run(&["test", "--format", "json"]).exits(1).json();
    assert_eq!((&report["failed"], &report["cases"][0]["result"]), (&json!(1), &json!("differs")));
    assert_eq!(report["cases"][0]["motion"]["now"]["moves"], json!(3));
    assert_eq!(report["cases"][1], json!({"file": "B.H", "result": "same", "motion": null}));
    let quiet = folder.run(&["test", "-q"]).exits(1);
    assert!(!quiet.out.contains("B.H"), "{}", quiet.out);
    // --update takes the new output over.
    folder.run(&["test", "--update"]).exits(0);
    folder.run(&["test"]).exits(0);
}

#[test]
fn golden_outputs_of_several_targets_stand_side_by_side() {
    let folder = Folder::new("golden_targets").with(&[("A.H", PART), ("B.H", PART)]);
    let targets = ["linuxcnc", "grbl", "grblhal"];
    for target in targets {
        folder.run(&["test", "--target", target, "--update"]).exits(0);
    }
    for name in ["A.golden.ngc", "A.golden.gcode", "A.golden.grblhal.gcode"] {
        let target = if name.ends_with("ngc") { "linuxcnc" } else { name.split('.').nth_back(1).unwrap_or_default() };
        let target = if target == "golden" { "grbl" } else { target };
        assert!(folder.read(name).contains(&format!("target {target})")), "{name}");
    }
    for target in targets {
        let ran = folder.run(&["test", "--target", target]).exits(0).quietly();
        assert!(ran.out.ends_with("2 cases: 2 same\n"), "{}", ran.out);
    }
    // A golden output whose program is gone fails for every target.
    fs::remove_file(folder.0.join("B.H")).expect("a file");
    for target in targets {
        let ran = folder.run(&["test", "--target", target]).exits(1);
        assert!(ran.out.contains("no-program B.golden.grblhal.gcode"), "{}", ran.out);
    }
}

#[test]
fn golden_cases_with_errors_or_without_a_program_fail() {
    let folder = Folder::new("golden_fails").with(&[("A.H", PART), ("B.H", PART)]);
    folder.run(&["test", "--update"]).exits(0);
    let golden = folder.read("A.golden.ngc");
    folder.write("A.H", WRONG);
    fs::remove_file(folder.0.join("B.H")).expect("a file");
    let ran = folder.run(&["test"]).exits(1).says("P1003");
    assert!(ran.out.contains("errors     A.H") && ran.out.contains("no-program B.golden.ngc"), "{}", ran.out);
    // An update writes nothing for a program with errors.
    folder.run(&["test", "--update"]).exits(1).says("P1003");
    assert_eq!(folder.read("A.golden.ngc"), golden);
    folder.run(&["test", "GONE"]).exits(2).says("GONE");
}

// partc config.

#[test]
fn the_configuration_in_force_names_where_it_comes_from() {
    let folder = Folder::new("config_show").with(&[
        ("partc.toml", "[output]\ndecimals = 3\ncomments = false\n"),
        ("shop/partc.toml", "extend = \"../partc.toml\"\n[output]\ndecimals = 5\n[tools.1]\nradius = 5.0\n"),
        ("shop/A.H", PART),
    ]);
    for path in ["shop/A.H", "shop"] {
        let ran = folder.run(&["config", "--show", path]).exits(0).quietly();
        let line = |key: &str| {
            let found = ran.out.lines().find(|line| line.starts_with(key));
            found.unwrap_or_else(|| panic!("{key}:\n{}", ran.out)).split_whitespace().collect::<Vec<_>>().join(" ")
        };
        assert!(line("decimals = ").starts_with("decimals = 5 # ") && line("decimals").ends_with("shop/partc.toml:3"));
        assert!(line("comments = ").ends_with("partc.toml:3"));
        assert!(line("target = ").contains("# default; one of linuxcnc"));
        // What is shown can be used as a configuration.
        folder.write("shown.toml", &ran.out);
        let as_file = folder.run(&["compile", "shop/A.H", "-o", "-"]).exits(0).out;
        assert_eq!(folder.run(&["compile", "shop/A.H", "-o", "-", "--config", "shown.toml"]).exits(0).out, as_file);
    }
    let ran = folder.run(&["config", "--show", "shop/A.H", "--compensation", "control", "--format", "json"]).exits(0);
    let output = &ran.json()["settings"]["output"];
    assert_eq!(output["compensation"], json!({"value": "control", "from": "command line"}));
    assert_eq!(output["pass_m"], json!({"value": [], "from": "default"}));
    folder.run(&["config", "--show", "gone.H"]).exits(2).says("gone.H");
    folder.write("shop/partc.toml", "[output]\ndecimal = 5\n");
    folder.run(&["config", "--show", "shop/A.H"]).exits(2).says("did you mean `decimals`?");
    folder.run(&["config"]).exits(2);
    folder.run(&["config", "--schema", "--show", "shop"]).exits(2);
}

#[test]
fn the_schema_of_the_configuration() {
    let folder = Folder::new("config_schema");
    let ran = folder.run(&["config", "--schema"]).exits(0).quietly();
    let schema: Value = serde_json::from_str(&ran.out).expect("a JSON document");
    assert_eq!(schema["properties"]["output"]["properties"]["target"]["enum"], json!(partc::internals::target::NAMES));
    assert_eq!(schema["properties"]["limits"]["properties"]["steps"]["default"], json!(10_000_000));
}
