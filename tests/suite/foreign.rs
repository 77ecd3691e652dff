//! Files that are in none of the languages: one finding says what they are, in every command that reads programs.

use partc::internals::dialect::read_as;

use super::book::cases;
use super::cli_run::{Folder, PART};

/// As newcomers try it first.
const FANUC: &str = "%\nO1000 (PART)\nG21 G17 G40 G80 G90\nG91 G28 Z0\nT1 M6\nG54 G90 G0 X10. Y10. S2000 M3\nG43 H1 Z50.\n\
                     G81 G98 Z-10. R2. F100\nM30\n%\n";
const PRINTER: &str = ";FLAVOR:Marlin\nM104 S200\nG28\nG1 X10 Y10 E0.5\n";
const HEADER: &str = "#ifndef SERIAL_H\n#define SERIAL_H\nint tool(void);\n#endif\n";

/// `read_as` is right for all programs of ours: of none of them is said that it is something else.
#[test]
fn no_program_of_the_books_is_taken_for_another_language() {
    let mut wrong = Vec::new();
    for case in cases("") {
        let read = read_as(&case.file, &case.program[..case.program.len().min(64 * 1024)]);
        if read.is_some_and(|dialect| dialect.is_foreign()) {
            wrong.push(format!("{} ({})", case.name, case.file));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn each_command_says_once_what_the_file_is() {
    let folder = Folder::new("foreign").with(&[("fan.nc", FANUC)]);
    for command in [
        &["check", "fan.nc"][..],
        &["compile", "fan.nc", "-o", "-"],
        &["plot", "fan.nc", "-o", "-"],
        &["stats", "fan.nc"],
        &["report", "fan.nc", "-o", "r.html"],
        &["trace", "fan.nc", "-o", "-"],
    ] {
        let ran = folder.run(command).exits(1).says("P0009").says("Fanuc, Haas").says("`O1000`");
        let told = format!("{}{}", ran.out, ran.err);
        assert_eq!(told.matches("error[").count(), 1, "{command:?}: {told}");
        assert!(!told.contains("P9011") && !told.contains("pass_m"), "{command:?}: {told}");
    }
}

/// Who says the language has decided.
#[test]
fn a_language_that_is_said_is_believed() {
    let folder = Folder::new("foreign_said").with(&[("fan.nc", FANUC), ("sub/a.nc", FANUC)]);
    folder.write("sub/partc.toml", "[dialects]\n\"**/*.nc\" = \"gcode\"\n");
    folder.run(&["check", "fan.nc", "--dialect", "gcode"]).exits(1).says("R1001");
    folder.run(&["check", "sub/a.nc"]).exits(1).says("R1001");
}

/// In a folder they are told, too: with an extension of ours, each was meant as a program.
#[test]
fn a_folder_tells_what_lies_among_its_programs() {
    let folder = Folder::new("foreign_folder").with(&[
        ("a/PART.H", PART),
        ("a/fan.nc", FANUC),
        ("a/serial.h", HEADER),
        ("a/cube.gcode", PRINTER),
        ("a/notes.txt", "The part is milled in two clampings.\n"),
    ]);
    let ran =
        folder.run(&["check", "a", "--format", "concise"]).exits(1).says("a/fan.nc:1:1").says("C or C++ source text");
    assert_eq!(format!("{}{}", ran.out, ran.err).matches("P0009").count(), 2, "{}", ran.out);
    folder.run(&["check", "a/cube.gcode"]).exits(1).says("3-D printer");
    // `init` counts what it can ask for.
    let written = folder.run(&["init", "a", "-o", "-"]).exits(0).out;
    for line in [
        "# Written by `partc init` from 1 program: 1 HEIDENHAIN Klartext.",
        "# Not part programs of these controls, and not counted: 1 C or C++, 1 Fanuc or Haas (`partc check` says which).",
    ] {
        assert!(written.contains(line), "{written}");
    }
    let folder = Folder::new("foreign_only").with(&[("fan.nc", FANUC)]);
    folder
        .run(&["init", ".", "-o", "-"])
        .exits(2)
        .says("no part program of a control that partc reads: 1 Fanuc or Haas");
}
