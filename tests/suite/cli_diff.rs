//! `partc diff`, and what `partc test` says of motion.

use std::fs;

use serde_json::json;

use super::cli_run::{Folder, PART, WRONG};

/// A full circle, a helix and a tool.
const ROUND: &str = "0 BEGIN PGM ROUND MM\n1 TOOL CALL 1 Z S2000\n2 L X+30 Y+0 Z+2 R0 FMAX M3\n3 L Z-1 F150\n4 CC X+0 Y+0\n\
                     5 C X+30 Y+0 DR+ F300\n6 CP IPA+810 IZ-3 DR+\n7 L Z+50 FMAX M30\n8 END PGM ROUND MM\n";

#[test]
fn a_program_is_the_same_as_its_outputs_for_all_targets() {
    let folder = Folder::new("diff_same").with(&[("ROUND.H", ROUND)]);
    for target in ["linuxcnc", "grblhal"] {
        let output = format!("{target}.ngc");
        folder.run(&["compile", "ROUND.H", "--target", target, "-o", &output]).exits(0);
        let ran = folder.run(&["diff", "ROUND.H", &output]);
        assert!(ran.out.starts_with("motion: all "), "{}", ran.out);
        ran.exits(0);
    }
    folder.run(&["diff", "linuxcnc.ngc", "grblhal.ngc", "--quiet"]).exits(0);
    // Halves of a circle are the circle.
    let part = ROUND.replace("1 TOOL CALL 1 Z S2000\n", "");
    folder.write("HALVES.H", &part);
    for target in ["linuxcnc", "grbl"] {
        folder.run(&["compile", "HALVES.H", "--target", target, "-o", &format!("halves.{target}.ngc")]).exits(0);
    }
    assert!(folder.read("halves.grbl.ngc").matches("\nG3 ").count() > 3);
    folder.run(&["diff", "halves.linuxcnc.ngc", "halves.grbl.ngc"]).exits(0);
}

#[test]
fn a_difference_is_told_drawn_and_an_exit_code() {
    let folder = Folder::new("diff_differs").with(&[("A.H", PART), ("B.H", &PART.replace("Z-5", "Z-5.5"))]);
    let ran = folder.run(&["diff", "A.H", "B.H", "--plot", "both.svg"]);
    assert_eq!(
        ran.out,
        "motion: 1 of 3 moves differs, by up to 0.5\n\
         \x20 first difference  A.H: G1 X10 Y5 Z-5 F150 (line 3)\n\
         \x20                   B.H: G1 X10 Y5 Z-5.5 F150 (line 3)\n\
         \x20 way               A.H: 62 mm\n\
         \x20                   B.H: 63 mm\n"
    );
    ran.exits(1);
    let picture = folder.read("both.svg");
    assert!(picture.starts_with("<!-- (partc plot) -->") && picture.contains(">A.H<") && picture.contains(">B.H<"));
    let ran = folder.run(&["diff", "A.H", "B.H", "--format", "json"]);
    let report: serde_json::Value = serde_json::from_str(&ran.out).expect("a document");
    assert_eq!((&report["same"], &report["largest"], &report["version"]), (&json!(false), &json!(0.5), &json!(1)));
    assert_eq!(report["programs"][1]["first_line"], json!(3));
    ran.exits(1);
    folder.run(&["diff", "A.H", "B.H", "--tolerance", "0.5"]).exits(0);
}

#[test]
fn what_cannot_be_read_is_said() {
    let folder = Folder::new("diff_wrong").with(&[
        ("A.H", PART),
        ("WRONG.H", WRONG),
        ("macro.ngc", "G21\nG0 X#1\n"),
        ("mine.svg", "<svg/>"),
    ]);
    folder.run(&["diff", "A.H", "WRONG.H"]).exits(1);
    let ran = folder.run(&["diff", "A.H", "macro.ngc"]);
    assert!(ran.err.contains("macro.ngc: line 2 cannot be read"), "{}", ran.err);
    ran.exits(2);
    folder.run(&["diff", "A.H", "A.H", "--plot", "mine.svg"]).exits(2);
    folder.run(&["diff", "A.H", "A.H", "--plot", "A.H"]).exits(2);
    assert_eq!(folder.read("mine.svg"), "<svg/>");
    folder.run(&["diff", "A.H", "no.H"]).exits(2);
}

#[test]
fn results_of_golden_suites_are_junit_too() {
    let folder = Folder::new("golden_junit").with(&[("A.H", PART), ("B.H", PART)]);
    folder.run(&["test", "--update"]).exits(0);
    let golden = folder.read("A.golden.ngc").replace("G1 Z-5", "G1 Z-5.5");
    folder.write("A.golden.ngc", &golden);
    folder.run(&["test", "--junit", "results.xml"]).exits(1);
    let report = fs::read_to_string(folder.0.join("results.xml")).expect("a report");
    assert!(report.contains("<testsuites tests=\"2\" failures=\"1\" errors=\"0\">"), "{report}");
    assert!(
        report.contains("name=\"./A.H\"><failure message=\"differs\">") || report.contains("name=\"A.H\"><failure"),
        "{report}"
    );
    assert!(report.contains("by up to 0.5"), "{report}");
}
