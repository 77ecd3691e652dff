//! The command line with configurations, tool tables and called programs.

use super::cli_run::{Folder, HOLE, PART, RADIUS, body, caller};

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
    folder.run(&["check", "other/A.H", "--isolated"]).exits(1).says("P2007");
    folder.run(&["check", "other/A.H", "--config", "shop/partc.toml"]).exits(1).says("P2007");
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
        ("[programs]\nHC = { ignore = true }\nhc = { change = true }\n", "a second entry of this name"),
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
    let text = "0 BEGIN PGM C MM\n1 TOOL CALL 1 Z S2000\n2 L X+0 Y+0 R0 F300\n3 L X+20 RL\n4 L X+30\n5 L X+40 R0\n6 END PGM C MM\n";
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
        ("shop/partc.toml", "[tools]\ntable = \"TOOL.T\"\n"),
        ("shop/TOOL.T", tool_t),
        ("shop/A.H", RADIUS),
        ("both/TOOL.T", tool_t),
        ("both/partc.toml", "[tools]\ntable = \"TOOL.T\"\n[tools.5]\nradius = 3.0\n"),
        ("both/A.H", RADIUS),
        ("number/TOOL.T", tool_t),
        ("number/partc.toml", "[tools]\ntable = \"TOOL.T\"\n[tools.5]\nnumber = 12\n"),
        ("number/A.H", RADIUS),
    ]);
    let end = |args: &[&str]| -> String {
        let mut all = vec!["compile", "-o", "-"];
        all.extend(args);
        let ran = folder.run(&all).exits(0).quietly();
        ran.out.lines().find(|line| line.ends_with("F200")).expect("the compensated move").to_owned()
    };
    folder.run(&["compile", "A.H"]).exits(1).says("P2004");
    assert_eq!(end(&["A.H", "--tools", "TOOL.T"]), "G1 X55 F200");
    assert_eq!(end(&["B.H", "--tools", "TOOL.T"]), "G1 X55 F200");
    assert_eq!(end(&["A.H", "--tools", "tool.tbl"]), "G1 X54 F200");
    assert_eq!(end(&["shop/A.H"]), "G1 X55 F200");
    // The option replaces the table of the configuration; a tool of the configuration wins over any table.
    assert_eq!(end(&["shop/A.H", "--tools", "tool.tbl"]), "G1 X54 F200");
    assert_eq!(end(&["both/A.H"]), "G1 X53 F200");
    // A number to print leaves the rest to the table.
    assert_eq!(end(&["number/A.H"]), "G1 X55 F200");
    assert!(folder.run(&["compile", "number/A.H", "-o", "-"]).exits(0).out.contains("T12 M6"));
}

#[test]
fn tool_tables_that_cannot_be_used() {
    let folder = Folder::new("tools_wrong").with(&[
        ("A.H", RADIUS),
        ("broken.t", "BEGIN TOOL .T MM\nT    NAME   L     R\n5    A      +80   five\n[END]\n"),
        ("broken.tbl", "T1 D5\nhello world\n"),
        ("other.t", "BEGIN TOOL .T MM\nT    NAME   L     R\n6    A      +80   +5\n[END]\n"),
    ]);
    folder.run(&["compile", "A.H", "--tools", "broken.t"]).exits(2).says("broken.t:3: `five` under R is no number");
    folder.run(&["compile", "A.H", "--tools", "broken.tbl"]).exits(2).says("broken.tbl:2:");
    folder.run(&["compile", "A.H", "--tools", "gone.t"]).exits(2).says("gone.t");
    folder.write("partc.toml", "[tools]\ntable = \"gone.t\"\n");
    folder.run(&["compile", "A.H"]).exits(2).says("gone.t");
    assert!(!folder.has("A.ngc"));
    let ran = folder.run(&["compile", "A.H", "--tools", "other.t", "--format", "concise"]).exits(1);
    assert_eq!(ran.codes(), ["P2006", "P2004"]);
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
    // A name without a drive means the folder of the caller; the only other one that has it is taken under a warning.
    let (codes, moves) = calling(&folder, "HOLE2.H");
    assert_eq!((&codes[..], moves.len()), (&["P0107".to_owned()][..], 5));
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
    refuses(&folder, "DANGLING.H", "P0105");
}

#[cfg(target_os = "linux")]
#[test]
fn names_that_differ_in_case_only_are_ambiguous() {
    let folder = Folder::new("include_case").with(&[("HOLE.H", HOLE), ("Hole.H", HOLE)]);
    // On the control both are one name: which of the two it holds nobody knows.
    for name in ["hole.h", "Hole.H", "HOLE.H"] {
        refuses(&folder, name, "P0103");
    }
}

#[test]
fn a_program_that_calls_itself_is_found_whatever_the_name() {
    let folder = Folder::new("include_itself");
    refuses(&folder, "A.H", "P2012");
    refuses(&folder, "a", "P2012");
    refuses(&folder, ".\\A.H", "P2012");
}
