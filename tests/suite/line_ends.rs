//! Line ends, the same for all dialects: LF, CR LF and CR make the same blocks, and a lone CR joins none in silence.

use partc::internals::text::files::NoFiles;

use super::common::{Compiled, compile_bytes, settings};

struct Case {
    dialect: &'static str,
    name: &'static str,
    /// The lines of a program; the marked one is followed by another that moves.
    lines: &'static [&'static str],
    /// Which line the damage stands behind.
    marked: usize,
    /// How a comment begins at the end of a line; comments in brackets have an end, too.
    comments: &'static [(&'static str, &'static str)],
}

const CASES: &[Case] = &[
    Case {
        dialect: "klartext",
        name: "PART.H",
        lines: &[
            "0 BEGIN PGM PART MM",
            "1 L X+0 Y+0 Z+5 R0 FMAX",
            "2 L X+10 F100",
            "3 L Y+20",
            "4 L X+30",
            "5 END PGM PART MM",
        ],
        marked: 2,
        comments: &[(";", "")],
    },
    Case {
        dialect: "sinumerik",
        name: "PART.MPF",
        lines: &["G0 X0 Y0 Z5", "N10 G1 X10 F100", "N20 Y20", "N30 X30", "M30"],
        marked: 1,
        comments: &[(";", "")],
    },
    Case {
        dialect: "heidenhain-turning",
        name: "PART.nc",
        lines: &[
            "PROGRAMMKOPF",
            "#EINHEIT METRISCH",
            "BEARBEITUNG",
            "N1 G95 F0.25 G97 S1000 M3",
            "N2 G0 X36 Z5",
            "N3 G1 Z-10",
            "N4 G1 X60",
            "N5 G1 Z-20",
            "ENDE",
        ],
        marked: 5,
        comments: &[("[", "]")],
    },
    Case {
        dialect: "gcode",
        name: "PART.ngc",
        lines: &["G90 G21 G94 G0 X0 Y0 Z5", "N10 G1 X10 F100", "N20 Y20", "N30 X30", "M30"],
        marked: 1,
        comments: &[(";", ""), ("(", ")")],
    },
    Case {
        dialect: "mtc200",
        name: "PART.npg",
        lines: &["N1 G00 X0 Y0 Z5", "N2 G01 X10 F100", "N3 Y20", "N4 X30", "N5 RET"],
        marked: 1,
        comments: &[(";", ""), ("(", ")")],
    },
];

fn compile(case: &Case, text: String) -> Compiled {
    compile_bytes(case.name, text.into_bytes(), case.dialect, &settings(""), &NoFiles)
}

/// The output without the line of the hash.
fn path(compiled: &Compiled) -> Vec<&str> {
    compiled.output.lines().filter(|line| !line.starts_with('(')).collect()
}

/// The program with `between` behind the marked line in place of its line feed.
fn damaged(case: &Case, between: &str) -> String {
    let (head, tail) = case.lines.split_at(case.marked + 1);
    format!("{}{between}{}\n", head.join("\n"), tail.join("\n"))
}

/// An error, or every block in its place.
fn no_block_is_lost(case: &Case, text: String, whole: &Compiled) {
    let compiled = compile(case, text.clone());
    let same = path(&compiled) == path(whole);
    assert!(compiled.has_errors() || same, "{}: {text:?}\n{}", case.dialect, compiled.output);
}

#[test]
fn line_ends_of_all_kinds_make_the_same_blocks() {
    for case in CASES {
        let whole = compile(case, case.lines.join("\n") + "\n");
        assert!(!whole.has_errors(), "{}: {:?}", case.dialect, whole.rendered);
        assert!(path(&whole).iter().any(|line| line.contains("20") || line.contains("-10")), "{}", whole.output);
        for end in ["\r\n", "\r", "\r\r\n"] {
            let compiled = compile(case, case.lines.join(end) + end);
            assert_eq!(path(&compiled), path(&whole), "{} with {end:?}: {:?}", case.dialect, compiled.rendered);
        }
    }
}

#[test]
fn a_lone_carriage_return_between_blocks_joins_none() {
    for case in CASES {
        let whole = compile(case, case.lines.join("\n") + "\n");
        for between in ["\r", " \r ", "\r\r"] {
            no_block_is_lost(case, damaged(case, between), &whole);
        }
    }
}

#[test]
fn a_lone_carriage_return_in_a_comment_hides_no_block() {
    for case in CASES {
        let whole = compile(case, case.lines.join("\n") + "\n");
        for (open, close) in case.comments {
            // The line end of the comment is damaged.
            no_block_is_lost(case, damaged(case, &format!(" {open}text{close}\r")), &whole);
            // The comment goes on behind it.
            let next = case.lines[case.marked + 1];
            let text = damaged(case, &format!(" {open}text\r{next}{close}\n"));
            no_block_is_lost(case, text, &whole);
            // Nothing stands behind it: a comment of two lines.
            no_block_is_lost(case, damaged(case, &format!(" {open}text\rmore{close}\n")), &whole);
        }
    }
}
