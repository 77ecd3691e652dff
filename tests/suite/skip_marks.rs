//! The skip mark: which blocks are left out, in every dialect.
//!
//! A mark without a level is level 0. Level 1 takes it along; where a program has both, that is said.

use partc::internals::text::files::NoFiles;

use super::common::{compile_bytes, settings};

/// Dialect, file name, program with `MARK` in front of the move to 7, levels that it can write.
const PROGRAMS: &[(&str, &str, &str, &[u8])] = &[
    ("klartext", "A.H", "0 BEGIN PGM A MM\n1 L X+1 Y+1 R0 F100\nMARK2 L X+7\n3 L Y+5\n4 END PGM A MM\n", &[]),
    ("sinumerik", "A.MPF", "N1 G90 G1 X1 Y1 F100\nMARKN2 X7\nN3 Y5\nM30\n", &[1, 2]),
    ("heidenhain-turning", "A.nc", "%1.nc\nN1 G94 F100\nN2 G0 X2 Z1\nMARKN3 G1 Z7\nN4 G1 X60\nEND\n", &[1, 2]),
    ("gcode", "A.ngc", "N0 G90 G21\nN1 G94 G1 X1 Y1 F100\nMARKN2 X7\nN3 Y5\nM30\n", &[1, 2]),
    ("mtc200", "A.mtc", "N1 G90 G71 G94 G01 X1 Y1 F100\nMARKN2 X7\nN3 Y5\nN4 M30\n", &[]),
];

/// `skip_blocks`, and the levels of marks (0: none written) that it skips.
const OPTIONS: &[(&str, &[u8])] =
    &[("[]", &[]), ("[0]", &[0]), ("[1]", &[0, 1]), ("[0, 1]", &[0, 1]), ("[2]", &[2]), ("[1, 2]", &[0, 1, 2])];

#[test]
fn level_1_takes_the_mark_without_a_level_along() {
    for (dialect, name, program, levels) in PROGRAMS {
        for (option, skipped) in OPTIONS {
            let options = settings(&format!("[control]\nskip_blocks = {option}\n"));
            for level in levels.iter().copied().chain([0]) {
                for blank in ["", " "] {
                    let mark = if level == 0 { "/".to_owned() } else { format!("/{level}") };
                    let text = program.replace("MARK", &format!("{mark}{blank}"));
                    let compiled = compile_bytes(name, text.clone().into_bytes(), dialect, &options, &NoFiles);
                    assert!(!compiled.has_errors(), "{dialect}, {mark}: {:?}", compiled.rendered);
                    // X7 or Z7 is reached by this block alone.
                    let runs = compiled.output.lines().any(|line| line.ends_with("X7") || line.contains("Z7"));
                    assert_eq!(runs, !skipped.contains(&level), "{dialect}, skip_blocks = {option}: {text}");
                }
            }
        }
    }
}

#[test]
fn two_levels_that_are_switched_as_one_are_said_once() {
    for (dialect, name, program, _) in PROGRAMS.iter().filter(|row| !row.3.is_empty()) {
        for (option, said) in [("[]", 0), ("[0]", 0), ("[1]", 1), ("[0, 1]", 0), ("[2]", 0)] {
            for (first, second) in [("/", "/1 "), ("/1 ", "/")] {
                let options = settings(&format!("[control]\nskip_blocks = {option}\n"));
                let text = program.replace("MARK", first).replace("N1", &format!("{second}N1"));
                let compiled = compile_bytes(name, text.clone().into_bytes(), dialect, &options, &NoFiles);
                let warnings = compiled.codes().iter().filter(|code| **code == "P0201").count();
                assert_eq!(warnings, said, "{dialect}, skip_blocks = {option}: {text}");
            }
        }
    }
}
