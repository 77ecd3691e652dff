//! Messages that readers found hard to act on: each says what is wrong, and what to do.

use super::cli_run::Folder;

/// The program, what is said of it, and what is not.
const SAID: &[(&str, &str, &[&str], &[&str])] = &[
    (
        "ARC.MPF",
        "N10 G17 G90 G54 G0 X10 Y0 Z1\nN20 G1 F100\nN30 G3 X-10 Y0 I=AC(10) J=AC(0)\nM30\n",
        &["P3002", "with AC(…) they are the centre itself"],
        &[],
    ),
    ("SPEECH.MPF", "N10 G17 G90 G54\nThe helly is ts CUTTER/ 16.\nM30\n", &["P1001", "a comment starts with `;`"], &[]),
    (
        "AXIS.H",
        "0 BEGIN PGM A MM\n1 L X+0 Y+0 Z+0 R0 FMAX\n80 Z DR+0.0 ; Tool\n3 END PGM A MM\n",
        &["K1002", "a path function is missing before it, as in `L Z… R0 F500`"],
        &["comment"],
    ),
    (
        "HELIX.MPF",
        "N10 G17 G90 G54 G0 X10 Y0 Z1\nN20 G1 F100\nN30 G2 X0 Y0 Z10 I0 J-25 K5\nM30\n",
        &["P1003", "a helix has `TURN=`"],
        &[],
    ),
    ("NEVER.MPF", "N10 G17 G90 G54 G0 X10 Y0 Z1\nR2=10/R5\nM30\n", &["P2022", "`R5` is 0 and set nowhere"], &[]),
    (
        "ZERO.MPF",
        "DEF REAL SHAG\nN10 G17 G90 G54 G0 X10 Y0 Z1\nSHAG=0\nR2=10 / SHAG + 5\nM30\n",
        &["P2022", "division by zero: `SHAG` is 0"],
        &[],
    ),
    // Of two the one that is 0 is named.
    ("TWO.MPF", "R1=1 R5=0\nR2=10/R1/R5\nM30\n", &["P2022", "division by zero: `R5` is 0"], &["R1"]),
    (
        "LEAD.MPF",
        "N10 G17 G90 G54 G0 X10 Y0 Z1\nN15 S100 M3\nR5=0\nN20 G33 Z-10 K=R5\nM30\n",
        &["S2081", "give the variable after the address its value"],
        &[],
    ),
    (
        "ISO.MPF",
        "N10 G21 G17 G90 G54 G0 X10 Y0 Z1\nM30\n",
        &["S2010", "G21 is a code of ISO dialects", "in its place this language has `G71` for millimetres"],
        // A program of ISO code throughout is told as such.
        &["--dialect"],
    ),
    // It runs until there is no level left; it is no second program of its name.
    (
        "ITSELF.MPF",
        "N10 G17 G90 G54 G0 X10 Y0 Z1\nITSELF\nM17\n",
        &["P4003", "line 2 of `ITSELF.MPF` calls what it stands in"],
        &["S2046"],
    ),
    // Words without numbers are one fault.
    (
        "NAN.H",
        "0 BEGIN PGM A MM\n1 L X+0 Y+0 Z+0 R0 FMAX\n2 L Xnan Ynan FMAX\n3 L X+5 Ynan FMAX\n4 L Xnan Ynan FMAX\n5 M30\n6 END PGM A MM\n",
        &["K0801", "1 error"],
        &["P1003"],
    ),
    ("L140.SPF", "PROC L140(INT A)\nG0 X=A\nRET\n", &[], &[]),
    // A subprogram called by its number takes arguments; no comment stands in brackets there.
    ("CALL.MPF", "G17 G90 G54\nL140(1)\nM30\n", &[], &["S0003"]),
];

#[test]
fn each_message_says_what_to_do() {
    let folder = Folder::new("messages");
    SAID.iter().for_each(|(name, text, ..)| folder.write(name, text));
    for (name, _, says, never) in SAID {
        let ran = folder.run(&["check", name, "--isolated", "--format", "concise"]);
        let told = format!("{}{}", ran.out, ran.err);
        for text in *says {
            assert!(told.contains(text), "{name}: `{text}` is missing in\n{told}");
        }
        for text in *never {
            assert!(!told.contains(text), "{name}: `{text}` stands in\n{told}");
        }
    }
}

/// The cycle of calls of two programs, in their order.
#[test]
fn programs_that_call_each_other_are_named() {
    let folder = Folder::new("messages_cycle").with(&[
        ("MAIN.MPF", "N10 G17 G90 G54 G0 X10 Y0 Z1\nONE\nM30\n"),
        ("ONE.SPF", "G1 X5 F100\nTWO\nM17\n"),
        ("TWO.SPF", "ONE\nM17\n"),
    ]);
    let ran = folder.run(&["check", "MAIN.MPF", "--isolated", "--format", "concise"]).exits(1).says("P4003");
    ran.says("these blocks call each other: ").says("line 1 of `TWO.SPF`").says("line 2 of `ONE.SPF`");
}

/// A table of the configuration is explained by its name, before keys that are called alike.
#[test]
fn a_table_of_the_configuration_is_explained() {
    let folder = Folder::new("messages_explain");
    for name in ["start", "[start]"] {
        let text = folder.run(&["explain", name]).exits(0).out;
        assert!(text.starts_with("[start]\nwhere the axes stand before the first block"), "{text}");
    }
    let text = folder.run(&["explain", "programs"]).exits(0).out;
    assert!(text.contains("  feed     F that the call leaves"), "{text}");
    let found = folder.run(&["explain", "programs", "--format", "json"]).exits(0).json();
    assert_eq!(found["table"], "programs");
    assert!(folder.run(&["explain", "control.start"]).exits(0).out.contains("MTC200"));
}

/// A subprogram that is checked alone says so once, however many parameters it has.
#[test]
fn a_subprogram_alone_says_once_that_it_needs_a_caller() {
    let folder =
        Folder::new("messages_var").with(&[("L9.SPF", "PROC L9(VAR REAL A, VAR REAL B, VAR INT C)\nG0 X=A\nRET\n")]);
    let ran =
        folder.run(&["check", "L9.SPF", "--isolated", "--format", "concise"]).exits(1).says("this is a subprogram");
    assert_eq!(format!("{}{}", ran.out, ran.err).matches("S2021").count(), 1);
}

/// The name of an empty file is told whole.
#[test]
fn a_long_name_of_a_file_is_not_cut() {
    let name = "a_name_of_a_file_that_is_longer_than_the_sixty_characters_that_were_shown_of_it.MPF";
    let folder = Folder::new("messages_long").with(&[(name, "\n")]);
    folder.run(&["check", name, "--isolated", "--format", "concise"]).exits(1).says("P0004").says(&format!("`{name}`"));
}

/// Turns of phrase that texts for users do not have, and what stands for them.
const NOT_SAID: &[(&str, &str)] = &[
    ("at hand", "no available manual says …"),
    ("nobody", "it is not known …"),
    ("somebody", "another user"),
    ("goes before it", "takes precedence"),
    ("is worth a word", "is reported"),
];

#[test]
fn texts_for_users_have_the_words_of_the_trade() {
    let mut texts: Vec<(String, String)> = Vec::new();
    for code in partc::internals::diag::codes::all() {
        texts.push((code.id.to_owned(), format!("{} {}", code.title, code.explain)));
        let worded = code.wordings.iter().map(|wording| format!("{} {}", wording.message, wording.help));
        texts.extend(worded.map(|text| (code.id.to_owned(), text)));
    }
    let codes = texts.len();
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    for entry in std::fs::read_dir(root.join("docs")).expect("the documents") {
        let path = entry.expect("a document").path();
        if path.extension().is_some_and(|extension| extension == "md") {
            texts.push((path.display().to_string(), std::fs::read_to_string(&path).expect("a document")));
        }
    }
    assert!(codes > 2000 && texts.len() > codes + 15, "{codes} texts of codes, {} in all", texts.len());
    let mut found = Vec::new();
    for (place, text) in &texts {
        let text = text.to_lowercase();
        let heard = NOT_SAID.iter().filter(|(words, _)| text.contains(words));
        found.extend(heard.map(|(words, better)| format!("{place}: `{words}`; write {better}")));
    }
    assert_eq!(found, [""; 0]);
}
