//! The same programs through nc-gcode-interpreter, a SINUMERIK interpreter on PyPI: an optional tool.
//!
//! It is asked where it knows the language: variables, structures, jumps, TRANS and ROT, end points of arcs. What it
//! leaves out without a word (chamfers, angles, inches, cycles …) is told by the words of the program.
//! `NC_GCODE_INTERPRETER_PYTHON` names a Python that has it (`tools.rs`).

use std::io::Write as _;
use std::process::{Command, Stdio};

use super::book::{Case, cases};
use super::tools;

/// Prints a line for each program: end points, and whether the interpreter refused or warned.
const SCRIPT: &str = r#"
import json, os, sys, tempfile
import nc_gcode_interpreter as n
said = tempfile.TemporaryFile()
os.dup2(said.fileno(), 2)
for text in json.load(sys.stdin):
    said.seek(0)
    said.truncate()
    at, ends = {}, []
    try:
        for _, row in n.nc_to_rows(text.replace("\r\n", "\n")):
            at = {axis: row.get(axis, at.get(axis)) for axis in "XYZ"}
            ends.append([at[axis] or 0.0 for axis in "XYZ"])
        refused = False
    except Exception:
        refused = True
    said.seek(0)
    print(json.dumps({"ends": ends, "known": not refused and b"Warning" not in said.read()}))
"#;

/// Words that it passes over, or takes for something else.
const NOT_KNOWN: &[&str] = &[
    "G41", "G42", "ANG=", "RND", "CHR=", "CHF=", "CYCLE", "POCKET", "SLOT", "LONGHOLE", "HOLES", "MCALL", "G70", "G25",
    "G26", "G53", "G58", "G59", "G11", "G[", "DEFINE", "G147", "G148", "G247", "G248", "G347", "G348",
];
/// Programs in which it is wrong by the manuals.
const WRONG: &[(&str, &str)] = &[
    ("for_end_changes.MPF", "takes the end of FOR once"),
    ("bool_from_number.MPF", "keeps numbers in BOOL"),
    ("real_to_int.MPF", "keeps fractions in INT"),
    ("joined_text.MPF", "writes a CHAR as a number"),
    ("start_angle_of_a_taper.MPF", "knows no start angle"),
    ("m9_at_the_end_of_the_block_of_g332.MPF", "stands between two blocks of one tap"),
    // Each step of ours leaves the hole.
    ("chip_breaking.MPF", "breaks the chip of a tap within the hole"),
    ("the_tool_in_use_and_the_one_that_is_chosen.MPF", "answers 0 for the number of each tool"),
    ("file_access.MPF", "leaves the error variable of WRITE and DELETE as it was"),
];
/// Largest difference of two end points.
const SAME: f64 = 1e-3;

/// End points of the printed moves.
fn end_points(output: &str) -> Vec<[f64; 3]> {
    let mut at = [0.0; 3];
    let mut ends = Vec::new();
    for line in output.lines() {
        let mut words = line.split(' ');
        let word = words.next();
        if !matches!(word, Some("G0" | "G1" | "G2" | "G3" | "G33" | "G33.1")) {
            continue;
        }
        let start = at;
        for word in words {
            let (address, number) = word.split_at(1);
            if let Some(axis) = "XYZ".find(address)
                && let Ok(value) = number.parse()
            {
                at[axis] = value;
            }
        }
        ends.push(at);
        // A tap comes back.
        if word == Some("G33.1") {
            at = start;
            ends.push(at);
        }
    }
    ends
}

/// Places that the tool comes to, each once while it stays.
fn visited(ends: impl IntoIterator<Item = [f64; 3]>) -> Vec<[f64; 3]> {
    let mut places = vec![[0.0; 3]];
    for end in ends {
        if !places.last().is_some_and(|last| same(last, &end)) {
            places.push(end);
        }
    }
    places
}

fn same(a: &[f64; 3], b: &[f64; 3]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= SAME)
}

fn within_its_words(case: &&Case) -> bool {
    let Some(text) = case.text() else { return false };
    let text = text.to_ascii_uppercase();
    // It calls no programs.
    case.config.is_empty()
        && case.called.is_empty()
        && !NOT_KNOWN.iter().any(|word| text.contains(word))
        && !WRONG.iter().any(|(wrong, _)| *wrong == case.file)
}

#[test]
fn sinumerik_programs_go_where_the_peer_says() {
    let Some(python) = tools::peer() else {
        assert!(!tools::required("PARTC_REQUIRE_PEER"), "no Python with nc-gcode-interpreter 0.2 or later");
        return;
    };
    let programs: Vec<&Case> = cases("sinumerik").into_iter().filter(within_its_words).collect();
    let texts: Vec<&str> = programs.iter().filter_map(|case| case.text()).collect();
    let mut command = Command::new(python);
    let mut peer =
        command.args(["-c", SCRIPT]).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().expect("a run of the peer");
    let input = serde_json::to_vec(&texts).expect("JSON");
    peer.stdin.take().expect("a pipe").write_all(&input).expect("programs for the peer");
    let output = peer.wait_with_output().expect("the end of the peer");
    let text = String::from_utf8(output.stdout).expect("JSON");
    let (mut compared, mut failures) = (0, Vec::new());
    for (case, line) in programs.iter().zip(text.lines()) {
        let answer: serde_json::Value = serde_json::from_str(line).expect("a line of JSON");
        let compiled = case.compile();
        let replaced = compiled.codes().iter().any(|code| matches!(*code, "O4001" | "O4002"));
        if answer["known"] != true || compiled.has_errors() || replaced {
            continue;
        }
        compared += 1;
        let theirs: Vec<[f64; 3]> = serde_json::from_value(answer["ends"].clone()).expect("end points");
        let (ours, theirs) = (visited(end_points(&compiled.output)), visited(theirs));
        if ours.len() != theirs.len() || !ours.iter().zip(&theirs).all(|(a, b)| same(a, b)) {
            failures.push(format!("{}:\n  ours   {ours:?}\n  theirs {theirs:?}", case.name));
        }
    }
    println!("{compared} programs compared");
    assert!(compared >= 100, "only {compared} programs could be compared");
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
