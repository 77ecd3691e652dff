//! `[machine] after_tool_change`: where a tool change leaves the axes, in all dialects.

use super::common::{Compiled, compile_bytes, settings};
use partc::internals::text::files::NoFiles;

/// A program of a dialect that changes the tool.
struct Form {
    dialect: &'static str,
    name: &'static str,
    settings: &'static str,
    around: fn(&str) -> String,
    /// Z to 3, the change, and behind it an increment of -5 along Z; the line of the change.
    increment: &'static str,
    line: u32,
    /// A rapid to Z250 behind the change, and the word that the output has for it.
    same: &'static str,
    /// The same behind a shift of Z by 10: the increment counts in the shifted system.
    shifted: Option<&'static str>,
    code: &'static str,
}

const FORMS: &[Form] = &[
    Form {
        dialect: "klartext",
        name: "P.H",
        settings: "",
        around: |body| format!("0 BEGIN PGM P MM\n{body}\n9 END PGM P MM\n"),
        increment: "1 TOOL CALL 1 Z S100\n2 L Z+3 R0 FMAX M3\n3 TOOL CALL 2 Z S100\n4 L IZ-5 R0 F100",
        line: 4,
        same: "3 TOOL CALL 2 Z S100\n4 L X+0 R0 FMAX\n5 L Z+250 R0 F100",
        shifted: Some("1 CYCL DEF 7.0 DATUM SHIFT\n2 CYCL DEF 7.1 Z+10\n3 TOOL CALL 2 Z S100\n4 L IZ-5 R0 F100"),
        code: "P2001",
    },
    Form {
        dialect: "sinumerik",
        name: "P.MPF",
        settings: "",
        around: |body| format!("{body}\nM30\n"),
        increment: "G54 G90 G0 Z3\nT2 M6\nG91 G1 Z-5 F100",
        line: 2,
        same: "G54 G90\nT2 M6\nG0 X0\nG1 Z250 F100",
        shifted: Some("G54 G90\nTRANS Z10\nT2 M6\nG1 Z=IC(-5) F100"),
        code: "P2001",
    },
    Form {
        dialect: "sinumerik",
        name: "P.MPF",
        settings: "[machine]\nkind = \"lathe\"\ndiameter_axis = \"X\"\n",
        around: |body| format!("{body}\nM30\n"),
        increment: "G18 G54 G90 G0 Z3\nT2\nG94 G91 G1 Z-5 F100",
        line: 2,
        same: "G18 G54 G90\nT2\nG94 G0 X0\nG1 Z250 F100",
        shifted: None,
        code: "P2001",
    },
    Form {
        dialect: "heidenhain-turning",
        name: "P.ncs",
        settings: "[machine]\nkind = \"lathe\"\n",
        around: |body| format!("{body}\nM30\n"),
        increment: "G94 F100\nG0 Z3\nT2\nG1 Zi-5",
        line: 3,
        same: "T2\nG94 F100\nG0 X0\nG1 Z250",
        shifted: None,
        code: "P2001",
    },
    Form {
        dialect: "mtc200",
        name: "P.npg",
        settings: "",
        around: |body| format!("{body}\nRET\n"),
        increment: "G54 G90 G94 G00 Z3\nT2 M6\nG91 G01 Z-5 F100",
        line: 2,
        same: "G54 G90 G94\nT2 M6\nG00 X0\nG01 Z250 F100",
        shifted: Some("G54 G90 G94\nG50 Z10\nT2 M6\nG91 G01 Z-5 F100"),
        code: "P2001",
    },
    Form {
        dialect: "gcode",
        name: "P.ngc",
        settings: "",
        around: |body| format!("G90 G21 G94\n{body}\nM30\n"),
        increment: "G0 Z3\nT2 M6\nG91 G1 Z-5 F100",
        line: 3,
        same: "T2 M6\nG0 X0\nG1 Z250 F100",
        shifted: None,
        code: "R1001",
    },
];

const KEY: &str = "after_tool_change = { Z = 250.0 }\n";

fn run(form: &Form, body: &str, machine: &str) -> Compiled {
    let text = (form.around)(body);
    let head = if form.settings.is_empty() { "[machine]\n" } else { form.settings };
    let settings = settings(&format!("{head}{machine}"));
    compile_bytes(form.name, text.into_bytes(), form.dialect, &settings, &NoFiles)
}

/// The first line with a feed move.
fn first_move(compiled: &Compiled) -> String {
    let line = compiled.output.lines().find(|line| line.starts_with("G1 ") || line.contains(" G1 "));
    line.unwrap_or_else(|| panic!("no move: {:?}\n{}", compiled.rendered, compiled.attempt)).to_owned()
}

#[test]
fn an_increment_counts_from_where_the_change_leaves_the_axis() {
    for form in FORMS {
        let line = first_move(&run(form, form.increment, KEY));
        assert!(line.contains("Z245"), "{}: {line}", form.dialect);
    }
}

#[test]
fn without_it_the_finding_names_the_change_and_the_key() {
    for form in FORMS {
        let compiled = run(form, form.increment, "");
        let found = compiled.findings.iter().find(|found| found.code.id == form.code);
        let found = found.unwrap_or_else(|| panic!("{}: {:?}", form.dialect, compiled.rendered));
        let says = format!("after the tool change in line {}", form.line);
        assert!(found.message.contains(&says), "{}: {}", form.dialect, found.message);
        let places: Vec<_> = found.answers.iter().map(|answer| answer.place()).collect();
        let key = ("machine".to_owned(), "after_tool_change.Z".to_owned());
        assert!(places.contains(&key), "{}: {places:?}", form.dialect);
    }
}

/// Whether the changer of the target leaves the axis there, too, nobody knows: a coordinate that the program writes is
/// printed, even where it is the one that the configuration says.
#[test]
fn the_same_coordinate_is_printed_all_the_same() {
    for form in FORMS {
        let line = first_move(&run(form, form.same, KEY));
        assert!(line.contains("Z250"), "{}: {line}", form.dialect);
    }
}

#[test]
fn it_counts_in_the_work_offset_and_not_in_a_shift_of_the_program() {
    for form in FORMS {
        let Some(body) = form.shifted else { continue };
        let line = first_move(&run(form, body, KEY));
        assert!(line.contains("Z245"), "{}: {line}", form.dialect);
    }
}

/// A change says nothing of an axis that the key does not list.
#[test]
fn only_the_listed_axes_are_known() {
    for form in FORMS {
        let compiled = run(form, form.increment, "after_tool_change = { X = 0.0 }\n");
        assert!(compiled.codes().contains(&form.code), "{}: {:?}", form.dialect, compiled.rendered);
    }
}

#[test]
fn x_of_a_lathe_is_a_diameter() {
    let cases = [(2, "G18 G54 G90\nT2\nG94 G1 Z=IC(-5) X=IC(-10) F100"), (3, "G94 F100\nT2\nG1 Zi-5 Xi-10")];
    for (form, body) in cases {
        let form = &FORMS[form];
        let line = first_move(&run(form, body, "after_tool_change = { X = 100.0, Z = 250.0 }\n"));
        assert!(line.contains("X45") && line.contains("Z245"), "{}: {line}", form.dialect);
    }
}

/// Z of the spindle nose is 500, the datum lies at 100, and the tool is 150 long: its tip stands at 250.
#[test]
fn in_machine_coordinates_datum_and_length_count() {
    const LONG: &str = "[tools.2]\nlength = 150.0\n";
    let cases = [
        (0, "[datums]\nactive = { Z = 100.0 }\n", "tools.2"),
        (1, "[datums]\nG54 = { Z = 100.0 }\nbasic = { Z = 0.0 }\n", "tools.2"),
    ];
    let machine = "after_tool_change = { Z = 500.0, machine = true }\n";
    for (form, datums, tool) in cases {
        let form = &FORMS[form];
        let line = first_move(&run(form, form.increment, &format!("{machine}{datums}{LONG}")));
        assert!(line.contains("Z245"), "{}: {line}", form.dialect);
        // What is missing is asked for.
        for (given, table) in [(LONG, "datums"), (datums, tool)] {
            let compiled = run(form, form.increment, &format!("{machine}{given}"));
            let found = compiled.findings.iter().find(|found| found.code.id == form.code).expect("it is refused");
            let places: Vec<_> = found.answers.iter().map(|answer| answer.place().0).collect();
            assert_eq!(places, [table], "{}: {:?}", form.dialect, compiled.rendered);
        }
    }
}

/// Behind a move in machine coordinates the place in the work offset follows from the datum.
#[test]
fn a_machine_coordinate_becomes_a_place_of_the_datum() {
    let cases = [
        // The nose goes to Z0, 150 above the tip.
        (
            0,
            "1 TOOL CALL 2 Z S100\n2 L Z+0 R0 FMAX M91\n3 L IZ-5 R0 F100",
            "[datums]\nactive = { Z = -400.0 }\n",
            "Z245",
        ),
        // The tip goes to Z-100 (MD 10760 = 0).
        (
            1,
            "G54 G90\nT2 M6\nSUPA G0 Z-100\nG91 G1 Z-5 F100",
            "[datums]\nG54 = { Z = -350.0 }\nbasic = { Z = 0.0 }\n",
            "Z245",
        ),
        // X has no length.
        (0, "1 TOOL CALL 2 Z S100\n2 L X+50 R0 FMAX M91\n3 L IX+1 R0 F100", "[datums]\nactive = { X = 20.0 }\n", "X31"),
    ];
    for (form, body, datums, place) in cases {
        let form = &FORMS[form];
        let compiled = run(form, body, &format!("{datums}[tools.2]\nlength = 150.0\n"));
        assert!(first_move(&compiled).contains(place), "{}: {}", form.dialect, first_move(&compiled));
        let compiled = run(form, body, "");
        let found = compiled.findings.iter().find(|found| found.code.id == form.code).expect("it is refused");
        assert!(found.message.contains("after the move in machine coordinates in line"), "{}", found.message);
        assert_eq!(found.answers[0].place().0, "datums", "{}", found.message);
    }
}

/// In a turned frame X of the machine is both axes of the program.
#[test]
fn a_machine_coordinate_hides_both_axes_of_a_turned_frame() {
    let body = "G54 G90\nT2 M6\nROT RPL=30\nG0 X10 Y10\nSUPA G0 X0 D0\nG91 G1 Y5 F100";
    let compiled = run(&FORMS[1], body, "");
    assert!(compiled.codes().contains(&"P2001"), "{:?}", compiled.rendered);
}

/// Somebody who is asked to stop may jog the axes: what FN 18 reads behind a STOP is asked for.
#[test]
fn a_position_behind_a_stop_is_asked_for() {
    let form = &FORMS[0];
    for (id, first) in [("ID270 NR1 IDX3", "1 L Z+30 R0 FMAX"), ("ID240 NR1 IDX3", "1 L Z+30 R0 FMAX M91")] {
        let read = format!("FN 18: SYSREAD Q1 = {id}\n6 L X+Q1 R0 F100");
        // Without the stop it is what the program says.
        let line = first_move(&run(form, &format!("{first}\n4 {read}"), ""));
        assert!(line.contains("X30"), "{line}");
        let stopped = format!("{first}\n3 STOP\n4 {read}");
        let compiled = run(form, &stopped, "");
        let found = compiled.findings.iter().find(|found| found.code.id == "K9016").expect("it is asked for");
        assert_eq!(found.answers[0].place(), ("variables".to_owned(), format!("\"{id}\"")));
        let line = first_move(&run(form, &stopped, &format!("[variables]\n\"{id}\" = 7.5\n")));
        assert!(line.contains("X7.5"), "{line}");
    }
}
