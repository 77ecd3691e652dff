//! `[start]`: where the axes stand before the first block, in all dialects.

use super::common::{Compiled, compile_bytes, settings};
use partc::internals::machine::{config, tree};
use partc::internals::text::files::NoFiles;

/// A program of a dialect, and what to write around the lines of a case.
struct Form {
    dialect: &'static str,
    name: &'static str,
    /// X of the program is a diameter.
    diameter: bool,
    settings: &'static str,
    around: fn(&str) -> String,
    /// An incremental first move X+5, an arc in the plane from X0 to X20 about X10, a work offset.
    increment: &'static str,
    arc: Option<&'static str>,
    offset: Option<&'static str>,
    code: &'static str,
}

const FORMS: &[Form] = &[
    Form {
        dialect: "klartext",
        name: "P.H",
        diameter: false,
        settings: "",
        around: |body| format!("0 BEGIN PGM P MM\n{body}\n9 END PGM P MM\n"),
        increment: "1 L IX+5 R0 F100",
        arc: Some("1 CC X+10 Y+0\n2 C X+20 Y+0 DR- R0 F100"),
        offset: Some("1 CYCL DEF 247 DATUM SETTING ~\n Q339=+1 ;NUMBER\n2 L IX+5 R0 F100"),
        code: "P2001",
    },
    Form {
        dialect: "sinumerik",
        name: "P.MPF",
        diameter: false,
        settings: "",
        around: |body| format!("{body}\nM30\n"),
        increment: "G91 G1 X5 F100",
        arc: Some("G90 G2 X20 Y0 I10 J0 F100"),
        offset: Some("G54\nG91 G1 X5 F100"),
        code: "P2001",
    },
    Form {
        dialect: "sinumerik",
        name: "P.MPF",
        diameter: true,
        settings: "[machine]\nkind = \"lathe\"\ndiameter_axis = \"X\"\n",
        around: |body| format!("{body}\nM30\n"),
        increment: "G94 G91 G1 X10 F100",
        arc: None,
        offset: Some("G54\nG94 G91 G1 X10 F100"),
        code: "P2001",
    },
    Form {
        dialect: "heidenhain-turning",
        name: "P.ncs",
        diameter: true,
        settings: "[machine]\nkind = \"lathe\"\n",
        around: |body| format!("{body}\nM30\n"),
        increment: "G94 F100\nG1 Xi5",
        arc: None,
        offset: None,
        code: "P2001",
    },
    Form {
        dialect: "mtc200",
        name: "P.npg",
        diameter: false,
        settings: "",
        around: |body| format!("{body}\nRET\n"),
        increment: "G94 G91 G01 X5 F100",
        arc: Some("G90 G94 G02 X20 Y0 I10 J0 F100"),
        offset: Some("G54\nG94 G91 G01 X5 F100"),
        code: "P2001",
    },
    Form {
        dialect: "mtc200",
        name: "P.npg",
        diameter: true,
        settings: "[machine]\nkind = \"lathe\"\ndiameter_axis = \"X\"\n",
        around: |body| format!("{body}\nRET\n"),
        increment: "G94 G91 G01 X10 F100",
        arc: None,
        offset: Some("G54\nG94 G91 G01 X10 F100"),
        code: "P2001",
    },
    Form {
        dialect: "gcode",
        name: "P.ngc",
        diameter: false,
        settings: "",
        around: |body| format!("G90 G21 G94\n{body}\nM30\n"),
        increment: "G91 G1 X5 F100",
        arc: Some("G90 G2 X20 Y0 I10 J0 F100"),
        offset: Some("G55\nG91 G1 X5 F100"),
        code: "R1001",
    },
];

fn run(form: &Form, body: &str, start: &str) -> Compiled {
    let text = (form.around)(body);
    let settings = settings(&format!("{}{start}", form.settings));
    compile_bytes(form.name, text.into_bytes(), form.dialect, &settings, &NoFiles)
}

/// Words of the first move of the output.
fn first_move(compiled: &Compiled) -> String {
    let line = compiled.output.lines().find(|line| ["G1 ", "G2 ", "G3 "].iter().any(|word| line.starts_with(word)));
    line.unwrap_or_else(|| panic!("no move: {:?}\n{}", compiled.rendered, compiled.attempt)).to_owned()
}

#[test]
fn an_incremental_first_move_starts_there() {
    for form in FORMS {
        // A radius of 10 in either case; both increments are 5 on the radius, but that of the HEIDENHAIN lathe.
        let (start, end) = if form.diameter { (20.0, 15.0) } else { (10.0, 15.0) };
        let end = if form.dialect == "heidenhain-turning" { 12.5 } else { end };
        let compiled = run(form, form.increment, &format!("[start]\nX = {start}\n"));
        let line = first_move(&compiled);
        assert!(line.contains(&format!("X{end}")), "{}: {line}", form.dialect);
    }
}

#[test]
fn without_it_the_help_names_the_key() {
    for form in FORMS {
        let compiled = run(form, form.increment, "");
        let found = compiled.findings.iter().find(|found| found.code.id == form.code);
        let found = found.unwrap_or_else(|| panic!("{}: {:?}", form.dialect, compiled.rendered));
        let help = found.help.as_deref().unwrap_or_default();
        assert!(help.contains("`[start]` with `X = …`"), "{}: {help}", form.dialect);
    }
}

#[test]
fn an_arc_can_be_the_first_move() {
    for form in FORMS {
        let Some(arc) = form.arc else { continue };
        let line = first_move(&run(form, arc, "[start]\nX = 0\nY = 0\n"));
        assert!(line.starts_with("G2 X20 Y0 I10 J0"), "{}: {line}", form.dialect);
    }
}

#[test]
fn it_counts_in_the_work_offset_that_is_selected_first() {
    for form in FORMS {
        let Some(body) = form.offset else { continue };
        let start = if form.diameter { 20 } else { 10 };
        let line = first_move(&run(form, body, &format!("[start]\nX = {start}\n")));
        assert!(line.contains("X15"), "{}: {line}", form.dialect);
    }
}

#[test]
fn a_tool_change_or_a_machine_position_ends_it() {
    let cases = [
        (0, "1 TOOL CALL 1 Z S100\n2 L IZ+5 R0 F100", "P2001"),
        (0, "1 L Z+0 R0 FMAX M91\n2 L IZ+5 R0 F100", "P2001"),
        (1, "T1 M6\nG91 G1 Z5 F100", "P2001"),
        (1, "G53 G0 Z0\nG91 G1 Z5 F100", "P2001"),
        (3, "T1\nG94 F100\nG1 Zi5", "P2001"),
        (4, "T1 M6\nG94 G91 G01 Z5 F100", "P2001"),
    ];
    for (form, body, code) in cases {
        let compiled = run(&FORMS[form], body, "[start]\nX = 0\nY = 0\nZ = 10\n");
        assert!(compiled.codes().contains(&code), "{body}: {:?}", compiled.rendered);
    }
}

/// A configured position is one that was programmed in front of the first block: an increment behind a changed offset or
/// frame meets the same options and the same refusals as one behind `G0 X10`.
#[test]
fn what_changes_the_offset_treats_it_as_a_programmed_position() {
    const WITH: &str = "[control]\ng91_after_offset = \"with-offset\"\n";
    const SD: &str = "[control]\nsd42440 = true\n";
    let moves = [
        // X10 and 1 more, counted from the zero that G50 moved by 3; TRANS X5 likewise.
        (4, WITH, "G50 X3\nG94 G91 G01 X1 F10", "X14"),
        (1, SD, "TRANS X5\nG94 G91 G1 X1 F10", "X16"),
    ];
    for (form, control, body, end) in moves {
        let text = (FORMS[form].around)(body);
        let settings = settings(&format!("{control}[start]\nX = 10\n"));
        let compiled = compile_bytes(FORMS[form].name, text.into_bytes(), FORMS[form].dialect, &settings, &NoFiles);
        let line = first_move(&compiled);
        assert!(line.contains(end), "{body}: {line}");
    }
    let refused = [
        (4, "G54\nG55\nG94 G91 G01 X1 F10", "P2001"),
        (1, "G54\nG55\nG94 G91 G1 X1 F10", "P2001"),
        (3, "G59 Z5\nG94 F100\nG1 Zi-1", "T2016"),
        (
            0,
            "1 CYCL DEF 247 DATUM SETTING ~\n Q339=+1 ;NUMBER\n2 CYCL DEF 247 DATUM SETTING ~\n Q339=+2 ;NUMBER\n3 L IX+1 R0 F100",
            "P2001",
        ),
    ];
    for (form, body, code) in refused {
        let compiled = run(&FORMS[form], body, "[start]\nX = 10\nZ = 2\n");
        assert!(compiled.codes().contains(&code), "{body}: {:?}", compiled.rendered);
    }
}

#[test]
fn the_older_key_beside_it_is_an_error() {
    for text in
        ["[control]\nstart = { X = 1.0 }\n[start]\nX = 10\n", "[start]\nX = 10\n[control]\nstart = { Y = 1.0 }\n"]
    {
        let read = config::read(&tree::parse(text, "partc.toml").expect("it is TOML"));
        let errors = read.expect_err("one of the two is left out");
        assert!(format!("{errors:?}").contains("older name"), "{errors:?}");
    }
}
