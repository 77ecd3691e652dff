//! The command line as users and CI jobs see it: commands, exit codes, files written and not written.
//!
//! Every test works in a folder of its own and runs the built binary there.

use std::fs;
use std::io::Read;
use std::process::{Command, Stdio};

use partc::internals::diag::codes;
use serde_json::{Value, json};

use super::cli_run::{Folder, PART, WARNED, WRONG, body, set};

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
    assert!(ran.err.starts_with("BRACKET.H:2:14: error[P1003]: "), "{}", ran.err);
}

#[test]
fn the_dialect_of_standard_input_is_told_by_content_or_name() {
    let folder = Folder::new("stdin_dialect");
    let fragment = "L X+10 Y+5 R0 F100 M30\n";
    folder.run_with(&["compile", "-"], fragment).exits(2).says("--dialect");
    folder.run_with(&["compile", "-", "--stdin-filename", "A.H"], fragment).exits(0);
    folder.run_with(&["compile", "-", "--dialect", "klartext"], fragment).exits(0);
}

#[test]
fn several_inputs() {
    let folder = Folder::new("several").with(&[("A.H", PART), ("B.H", WRONG), ("C.H", PART)]);
    // One wrong program does not stop the others.
    folder.run(&["compile", "A.H", "B.H", "C.H"]).exits(1).says("P1003");
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
    let trace = folder.run(&["trace", "WRONG.H"]).exits(1).out;
    assert!(trace.starts_with("{\"kind\":\"incomplete\",\"code\":\"P1003\"") && trace.lines().count() == 1, "{trace}");
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
    assert_eq!(ran.codes(), ["P1001"]);
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
    // A name that promises another form gets nothing, unless the form is said.
    let other = folder.run(&["plot", "T.H", "-o", "t.pdf"]).exits(2);
    assert!(other.err.contains(".svg or .png") && !folder.0.join("t.pdf").exists(), "{}", other.err);
    folder.run(&["plot", "T.H", "-o", "t.xml", "--as", "svg"]).exits(0);
    folder.run(&["plot", "BAD.H", "-o", "bad.svg"]).exits(1);
    folder.run(&["plot", "none.H", "-o", "-"]).exits(2);
}

#[test]
fn plot_takes_a_side_sizes_and_a_form() {
    let text = "0 BEGIN PGM T MM\n1 L X+10 Y+0 Z+2 R0 FMAX\n2 L X+50 Z-3 F200\n3 END PGM T MM\n";
    let bad = "0 BEGIN PGM T MM\n1 L X+10 R5\n2 END PGM T MM\n";
    let folder = Folder::new("plot_sides").with(&[("T.H", text), ("BAD.H", bad)]);
    let front = folder.run(&["plot", "T.H", "--view", "xz", "-o", "-"]).exits(0).out;
    assert!(
        front.contains("M10 2L50 -3") && front.contains(">Z<") && front.contains(">X in mm<") && !front.contains(">Y<"),
        "{front}"
    );
    let sized = folder.run(&["plot", "T.H", "--view", "xz", "--dimensions", "-o", "-"]).exits(0).out;
    assert!(sized.contains(">40<") && sized.contains(">5<"), "{sized}");
    let iso = folder.run(&["plot", "T.H", "--view", "iso", "-o", "-"]).exits(0).out;
    assert!([">X<", ">Y<", ">Z<"].iter().all(|axis| iso.contains(axis)), "{iso}");
    folder.run(&["plot", "T.H", "--view", "zx"]).exits(2);
    folder.run(&["plot", "T.H", "--as", "bmp"]).exits(2);
    if cfg!(feature = "png") {
        let is_png =
            |name: &str| std::fs::read(folder.0.join(name)).expect("a picture").starts_with(b"\x89PNG\r\n\x1a\n");
        folder.run(&["plot", "T.H", "-o", "t.png"]).exits(0);
        folder.run(&["plot", "T.H", "-o", "t.PNG", "--force"]).exits(0);
        folder.run(&["plot", "T.H", "--as", "png"]).exits(0);
        assert!(is_png("t.png") && is_png("T.png"));
        // It is known again, and replaced where the program has errors; a picture of somebody else stays.
        folder.run(&["plot", "T.H", "-o", "t.png"]).exits(0);
        std::fs::write(folder.0.join("photo.png"), b"\x89PNG\r\n\x1a\nphoto").expect("a file");
        folder.run(&["plot", "T.H", "-o", "photo.png"]).exits(2);
        folder.run(&["plot", "BAD.H", "-o", "t.png"]).exits(1).says("t.png is incomplete");
        assert!(is_png("t.png") && !folder.has("t.png.stale"));
        folder.run(&["diff", "T.H", "T.H", "--plot", "both.png"]).exits(0);
        assert!(is_png("both.png"));
    }
}

#[test]
fn plot_of_a_dense_program_is_small_and_says_so() {
    let mut text = "0 BEGIN PGM T MM\n1 L X+0 Y+0 Z+2 R0 FMAX\n".to_owned();
    // 300 rows of 200 short steps.
    for row in 0..300 {
        for step in 0..200 {
            let x = if row % 2 == 0 { step } else { 199 - step };
            text.push_str(&format!("L X{}.{} Y{}.{} F900\n", x / 2, x % 2 * 5, row / 3, row % 3 * 3));
        }
    }
    text.push_str("L X+250 Y+7\nEND PGM T MM\n");
    let folder = Folder::new("plot_dense").with(&[("T.H", &text)]);
    let ran = folder.run(&["plot", "T.H", "-o", "t.svg"]).exits(0);
    assert!(ran.err.contains("are drawn with") && ran.err.contains("mm away"), "{}", ran.err);
    let svg = folder.read("t.svg");
    assert!(svg.len() < 1_500_000 && svg.contains("moves drawn with") && svg.contains("X 0 to 250"), "{}", svg.len());
    assert!(svg.contains("L250 7"), "the farthest point stays");
    assert!(folder.run(&["plot", "T.H", "-o", "t.svg", "--quiet"]).exits(0).err.is_empty());
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

// Telling the dialect.

#[test]
fn the_dialect_is_told_or_asked_for() {
    let folder = Folder::new("dialect").with(&[
        ("content.txt", PART),
        ("PART.H", "L X+10 Y+5 R0 F300 M30\n"),
        ("unknown.txt", "L X+10 Y+5 R0 F300 M30\n"),
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

#[test]
fn a_report_shows_results_or_errors_and_replaces_nothing_foreign() {
    let text = "0 BEGIN PGM T MM\n1 L X+10 Y+0 Z+2 R0 FMAX\n2 L X+50 F200\n3 END PGM T MM\n";
    let folder =
        Folder::new("report").with(&[("T.H", text), ("BAD.H", "0 BEGIN PGM T MM\n1 L X+10 R5\n2 END PGM T MM\n")]);
    folder.run(&["report", "T.H"]).exits(0);
    let page = folder.run(&["report", "T.H", "-o", "-"]).exits(0).out;
    assert!(page.starts_with("<!doctype html>\n<!-- (partc report) -->\n") && page.ends_with("</html>\n"));
    assert_eq!(page.matches("<script type=\"text/plain\" id=").count(), 4);
    let broken = folder.run(&["report", "BAD.H", "-o", "-"]).exits(1).out;
    assert!(broken.ends_with("</html>\n"), "a page with the findings");
    // The folder of a program goes nowhere with its page.
    let named = folder.run(&["report", &folder.0.join("BAD.H").display().to_string(), "-o", "-"]).exits(1).out;
    assert_eq!(named, broken);
    // What fails the run lets no output pass: the page shows the finding and the path, and no code.
    std::fs::write(folder.0.join("W.H"), text.replace("L X+50", "L X\u{2212}50")).expect("a program");
    let lenient = folder.run(&["report", "W.H", "-o", "-"]).exits(0).out;
    let strict = folder.run(&["report", "W.H", "-o", "-", "--fail-on", "warning"]).exits(1).out;
    assert!(strict.ends_with("</html>\n") && strict.len() < lenient.len(), "{} {}", strict.len(), lenient.len());
    folder.run(&["report", "W.H", "-o", "-", "--fail-on", "warning", "--exit-zero"]).exits(0);
    // A second time it is our own page; a program is not.
    folder.run(&["report", "T.H"]).exits(0);
    folder.run(&["report", "T.H", "-o", "T.H"]).exits(2);
    folder.run(&["report", "T.H", "-o", "BAD.H"]).exits(2);
    let other = folder.run(&["report", "T.H", "-o", "t.ngc"]).exits(2);
    assert!(other.err.contains(".html or .htm") && !folder.0.join("t.ngc").exists(), "{}", other.err);
    folder.run(&["report", "T.H", "-o", "t.HTM"]).exits(0);
}
