//! Work offsets of every dialect on every target: each printed one stands for one of the program, and a finding names the
//! program's own word. The same for tools that `[tools]` prints as others.

use partc::internals::target;
use partc::internals::text::files::NoFiles;

use super::common::{Compiled, compile_bytes, settings};

/// How a dialect selects work offsets.
struct Row {
    dialect: &'static str,
    file: &'static str,
    /// What the program calls them, and blocks that select them and move.
    first: (&'static str, &'static str),
    second: (&'static str, &'static str),
    /// The key that maps the second one, where there is one.
    key: Option<&'static str>,
    head: &'static str,
    tail: &'static str,
}

const ROWS: [Row; 4] = [
    Row {
        dialect: "sinumerik",
        file: "PART.MPF",
        first: ("G54", "G54\nG0 X0 Y0 Z5\n"),
        second: ("G505", "G505\nG0 X0 Y0 Z5\n"),
        key: Some("G505"),
        head: "",
        tail: "M30\n",
    },
    Row {
        dialect: "klartext",
        file: "PART.H",
        first: ("preset 1", "CYCL DEF 247 DATUM SETTING Q339=1\nL X+0 Y+0 Z+5 R0 FMAX\n"),
        second: ("preset 5", "CYCL DEF 247 DATUM SETTING Q339=5\nL X+0 Y+0 Z+5 R0 FMAX\n"),
        key: Some("preset.5"),
        head: "BEGIN PGM PART MM\n",
        tail: "END PGM PART MM\n",
    },
    Row {
        dialect: "mtc200",
        file: "PART.npg",
        first: ("G54", "G54\nG0 X0 Y0 Z5\n"),
        second: ("G58", "G58\nG0 X0 Y0 Z5\n"),
        key: None,
        head: "G90 G71\n",
        tail: "M30\n",
    },
    Row {
        dialect: "gcode",
        file: "part.ngc",
        first: ("G54", "G54\nG0 X0 Y0 Z5\n"),
        second: ("G58", "G58\nG0 X0 Y0 Z5\n"),
        key: None,
        head: "G21 G90 G17\n",
        tail: "M30\n",
    },
];

fn print(row: &Row, target: &str, blocks: &[&str], datums: &str) -> Compiled {
    let mut settings =
        settings(&format!("[datums]\n{datums}\n[output]\npass_m = [3, 5]\nrapid_feed = 3000\ntool_length = \"off\"\n"));
    settings.output.target = target::find(target).expect("a target");
    let text = format!("{}{}{}", row.head, blocks.concat(), row.tail);
    compile_bytes(row.file, text.into_bytes(), row.dialect, &settings, &NoFiles)
}

#[test]
fn two_offsets_of_a_program_are_never_printed_as_one() {
    for row in &ROWS {
        let both = [row.first.1, row.second.1, row.first.1, row.second.1];
        let apart = print(row, "linuxcnc", &both, "");
        assert!(!apart.has_errors(), "{}: {:?}", row.dialect, apart.rendered);
        let Some(key) = row.key else { continue };
        for blocks in [both, [row.second.1, row.first.1, row.second.1, row.first.1]] {
            let one = print(row, "linuxcnc", &blocks, &format!("{key} = \"G54\""));
            let found: Vec<_> = one.findings.iter().filter(|found| found.code.id == "P0202").collect();
            assert!(!found.is_empty() && one.output.is_empty(), "{}: {:?}", row.dialect, one.rendered);
            assert!(
                found[0].message.contains(row.first.0) && found[0].message.contains(row.second.0),
                "{}",
                found[0].message
            );
            let help = found[0].help.as_deref().unwrap_or_default();
            assert!(help.contains(&format!("`[datums] {key}`")), "{help}");
        }
        let alone = print(row, "linuxcnc", &[row.second.1, row.second.1], &format!("{key} = \"G54\""));
        assert!(!alone.has_errors() && alone.output.contains("G54"), "{}: {:?}", row.dialect, alone.rendered);
    }
}

/// A finding about a work offset says what the program says, and what the target has instead.
#[test]
fn an_offset_that_a_target_lacks_is_named_by_the_word_of_the_program() {
    for target in target::ALL.iter().filter(|target| target.frame.mill.is_some()) {
        for row in &ROWS {
            let compiled = print(row, target.name, &[row.second.1], "");
            let found = compiled.findings.iter().find(|found| found.code.id == "O9310");
            assert_eq!(found.is_none(), target.offset(5).is_some(), "{} {:?}", target.name, compiled.rendered);
            let Some(found) = found else { continue };
            assert!(found.message.contains(row.second.0), "{}: {}", target.name, found.message);
        }
    }
}

/// `number` in `[tools]` is what every dialect prints, and two tools are never printed as one.
#[test]
fn the_number_of_a_tool_is_the_one_of_its_entry() {
    let head = "[control]\ntool_change = \"m6\"\n";
    for (dialect, file, program) in [
        ("sinumerik", "PART.MPF", "T1 M6\nG0 X0 Y0 Z5\nT2 M6\nG0 X0 Y0 Z5\nM30\n"),
        (
            "klartext",
            "PART.H",
            "BEGIN PGM PART MM\nTOOL CALL 1 Z S100\nL X+0 Y+0 Z+5 R0 FMAX\nTOOL CALL 2 Z S100\nL X+0 Y+0 Z+5 R0 FMAX\nEND PGM PART MM\n",
        ),
        ("mtc200", "PART.npg", "G90 G71\nT1 M6\nG0 X0 Y0 Z5\nT2 M6\nG0 X0 Y0 Z5\nM30\n"),
        ("heidenhain-turning", "PART.nc", "T1\nG26\nG97 S100\nG0 X10 Z5\nT2\nG0 X10 Z5\nEND\n"),
    ] {
        let print = |number: u32| {
            let settings = settings(&format!("{head}[tools.2]\nnumber = {number}\n"));
            compile_bytes(file, program.as_bytes().to_vec(), dialect, &settings, &NoFiles)
        };
        let other = print(12);
        assert!(other.attempt.contains("T12") && !other.attempt.contains("T2 "), "{dialect}: {:?}", other.rendered);
        let same = print(1);
        assert!(same.findings.iter().any(|found| found.code.id == "P0203"), "{dialect}: {:?}", same.rendered);
    }
}
