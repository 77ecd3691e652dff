//! Every key of `[output]` on every target: it changes what is printed, or a warning says that it does not.

use std::collections::BTreeSet;

use partc::internals::machine::schema;
use partc::internals::target::{self, Target};
use partc::internals::text::files::NoFiles;

use super::common::{Compiled, compile_bytes, settings};

/// Each key with values of which one at least is not what holds without it.
const KEYS: &[(&str, &[&str])] = &[
    ("units", &["\"inch\""]),
    ("decimals", &["5"]),
    ("decimals.length", &["5"]),
    ("decimals.angle", &["3", "5"]),
    ("decimals.feed", &["1", "2"]),
    ("decimals.speed", &["0", "2"]),
    ("decimals.time", &["1"]),
    ("compensation", &["\"control\""]),
    ("diameter", &["true", "false"]),
    ("comments", &["false"]),
    ("modal", &["false"]),
    ("line_numbers", &["10"]),
    ("program_number", &["7"]),
    ("header", &["[\"a head\"]"]),
    ("footer", &["[\"a foot\"]"]),
    ("pass_m", &["[0, 3, 5, 8, 9, 77]"]),
    ("tool_length", &["\"off\"", "\"G43\""]),
    ("tool_change", &["\"stop\"", "\"change\""]),
    ("tool_offsets", &["6"]),
    ("dwell_unit", &["\"seconds\"", "\"milliseconds\""]),
    ("rapid_feed", &["4000"]),
    ("arc_fallback_tolerance", &["0.01"]),
    ("tapping", &["\"as-target\""]),
    ("path_control", &["\"exact\"", "{ tolerance = 0.05 }"]),
];

/// Keys without which the target prints nothing, `key` itself left out where another value is to be tried.
fn configuration(target: &Target, key: &str, value: Option<&str>) -> String {
    let printer = target.motion.rapid_at_feed;
    let by_hand = if target.tool.change.is_none() { "\"stop\"" } else { "\"change\"" };
    let needed = [
        ("pass_m", printer.then_some("[0, 3, 5, 8, 9]")),
        ("rapid_feed", printer.then_some("3000")),
        ("tool_change", Some(by_hand)),
        ("dwell_unit", (target.name == "mach3").then_some("\"seconds\"")),
    ];
    let mut output = String::new();
    for (name, needed) in needed {
        let needed = needed.filter(|_| name != key || value.is_none());
        output += &needed.map_or(String::new(), |needed| format!("{name} = {needed}\n"));
    }
    output += &value.map_or(String::new(), |value| format!("{key} = {value}\n"));
    let machine = if is_lathe(target) { "[machine]\nkind = \"lathe\"\ndiameter_axis = \"X\"\n" } else { "" };
    let tool = "[tools.1]\nradius = 0.4\norientation = 3\n";
    format!("{machine}[control]\ntool_change = \"m6\"\n[output]\n{output}{tool}")
}

fn is_lathe(target: &Target) -> bool {
    target.frame.mill.is_none()
}

/// A program in which every key has something to say.
fn program(target: &Target, key: &str) -> String {
    let more = match (key, is_lathe(target)) {
        ("pass_m", _) => "M77",
        ("arc_fallback_tolerance", false) => "G0 X0 Y0 Z5\nG18 G2 X10 Y5 Z5 I5 K0 F100\nG17",
        ("compensation", false) => "G0 X-20 Y-20\nG1 G41 X0 Y0 F100\nG1 X10\nG40 X30 Y-20",
        ("compensation", true) => "G0 X80 Z20\nG1 G42 X40 Z2 F100\nG1 Z-10\nG40 X80 Z20",
        // A dwell, and another speed out.
        ("tapping", _) => "G0 Z5\nG331 Z-10 K1.5\nG4 F0.5\nG332 Z5 S777",
        // What has an angle to say.
        ("decimals.angle", _) if target.axes.contains('A') => "G0 A10.123456",
        ("decimals.angle", _) if target.spindle.orient.is_some() => "SPOS=90.123456",
        _ => "",
    };
    let moves = if is_lathe(target) {
        "G18 G0 X40.123456 Z5\nG1 Z-1 F100\nX50 Z-3.65\nG2 X60 Z-8.65 I5 K0"
    } else {
        "G17 G0 X0.123456 Y0 Z5\nG1 Z-1 F100\nX10 Y20\nG2 X30 Y20 I10 J0"
    };
    let (tool, speed, wait) = (if key == "tool_offsets" { 7 } else { 1 }, "1000.123456", "0.123456");
    let head = format!("; a comment\nT{tool} M6\nD1\nS{speed} M3");
    let moves = moves.replace("F100", "F100.123456");
    format!("{head}\n{moves}\nG4 F{wait}\n{more}\nG0 Z50\nM30\n")
}

fn print(target: &'static Target, key: &str, value: Option<&str>) -> Compiled {
    let mut settings = settings(&configuration(target, key, value));
    settings.output.target = target;
    compile_bytes("PART.MPF", program(target, key).into_bytes(), "sinumerik", &settings, &NoFiles)
}

/// What came of it: the text, or the errors instead.
fn outcome(compiled: &Compiled) -> String {
    if !compiled.has_errors() {
        // What a key keeps from being said is an outcome as well.
        let told = compiled.findings.iter().filter(|found| found.code.id == "O4008").map(|found| found.code.id);
        return compiled.output.clone() + &told.collect::<String>();
    }
    let mut codes: Vec<&str> = compiled.findings.iter().map(|found| found.code.id).collect();
    codes.retain(|code| !UNUSED.contains(code));
    codes.join(" ")
}

const UNUSED: [&str; 2] = ["O9329", "O9336"];

#[test]
fn a_key_changes_what_is_printed_or_a_warning_says_that_it_does_not() {
    let schema = schema::schema();
    let named = schema["properties"]["output"]["properties"].as_object().expect("a table");
    let named: BTreeSet<&str> = named.keys().map(String::as_str).filter(|name| *name != "target").collect();
    assert_eq!(named, KEYS.iter().map(|(name, _)| *name).filter(|name| !name.contains('.')).collect());
    let mut wrong = Vec::new();
    for target in target::ALL {
        for (key, values) in KEYS {
            let without = outcome(&print(target, key, None));
            let (mut changes, mut warned) = (false, false);
            for value in *values {
                let compiled = print(target, key, Some(value));
                let differs = outcome(&compiled) != without;
                let said = compiled.findings.iter().any(|found| {
                    UNUSED.contains(&found.code.id) && found.message.contains(key) && found.help.is_some()
                });
                // What is asked for in spite of the warning may well be refused.
                if differs && said && !compiled.has_errors() {
                    wrong.push(format!("{}: {key} = {value} changes the output in spite of the warning", target.name));
                }
                (changes, warned) = (changes || differs, warned || said);
            }
            if !changes && !warned {
                wrong.push(format!("{}: {key} is neither used nor warned of: {without}", target.name));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_warning_names_the_line_of_the_key() {
    let mut settings = settings("[output]\ncomments = false\nrapid_feed = 3000\n");
    settings.output.target = target::find("fanuc").expect("a target");
    let compiled = compile_bytes("PART.MPF", b"G0 X0 Y0 Z5\nM30\n".to_vec(), "sinumerik", &settings, &NoFiles);
    let found = compiled.findings.iter().find(|found| found.code.id == "O9336").expect("a warning");
    let help = found.help.as_ref().expect("what to do");
    assert!(help.starts_with("leave the key away: ") && help.ends_with(":3"), "{help}");
}

/// A thread prints the axes that stand like every other move.
#[test]
fn a_thread_in_full_words_is_what_the_program_says() {
    for way in ["G0 X0 Y0 Z5", "G0 X0 Y0 Z5\nG1 X1 F100", "G0 Z5\nX4 Y-3.5\nX0"] {
        let text = format!("G17 G90\nM3 S500\nG0 X2 Y1 Z9\n{way}\nG33 Z-10 K1.5\nG0 Z20\nM30\n");
        let settings = settings("[output]\nmodal = false\n");
        let compiled = compile_bytes("A.MPF", text.into_bytes(), "sinumerik", &settings, &NoFiles);
        let thread = compiled.output.lines().find(|line| line.starts_with("G33")).unwrap_or_default();
        assert!(
            !compiled.has_errors() && thread.starts_with("G33 X") && thread.ends_with("Z-10 K1.5"),
            "{way}: {thread}"
        );
    }
}
