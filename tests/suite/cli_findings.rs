//! How findings and the source map are written.

use partc::internals::diag::codes;
use serde_json::{Value, json};

use super::cli_run::{Folder, HOLE, PART, WARNED, WRONG};

// How findings are written.

/// Every field that the contract names.
#[test]
fn json_findings() {
    let text = "0 BEGIN PGM J MM\n1 L X+10 Y+0 R0 F300\n2 CC X+0\n3 C X+0 Y+10 DR+\n4 CALL LBL 1\n5 M30\n6 LBL 1\n\
                N7 L X+10 ; Ø78\n8 L Y+5 R5\n9 LBL 0\n10 END PGM J MM\n";
    let folder = Folder::new("json").with(&[("J.H", text)]);
    let ran = folder.run(&["check", "J.H", "--format", "json"]).exits(1);
    assert_eq!(ran.err, "1 error, 1 warning\n");
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
    assert_eq!((&error["code"], &error["severity"], &error["block"]), (&json!("P1003"), &json!("error"), &json!("8")));
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
    assert!(lines[0].starts_with("WRONG.H:2:14: error[P1003]: `R5` has no place in "), "{}", lines[0]);
    assert!(lines[1].starts_with("WARNED.H:3:3: warning[K2102]: "), "{}", lines[1]);
    assert!(lines[2].starts_with("2 programs, 1 error") && lines[2].contains("1 warning"), "{}", lines[2]);
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
    assert_eq!((ran.codes(), ran.err.lines().count()), (vec!["P1003"], 1));
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
