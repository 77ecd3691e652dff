//! How corners are taken: each head states it, nothing else changes it, and whoever compares two programs sees it.

use partc::internals::target;
use partc::internals::text::files::NoFiles;

use super::cli_run::Folder;
use super::common::{compile_bytes, settings};

const MILL: &str = "G17 G90\nG0 X0 Y0 Z5\nG1 X10 F1000\nY10\nM30\n";
const LATHE: &str = "G18 G90\nG0 X20 Z5\nG1 Z-5 F100\nX30\nM30\n";

/// What of the words for corners stands in the output, in order, and whether it was told that there is no bound.
fn words(target: &str, kind: &str, key: &str) -> (Vec<String>, bool) {
    let more = match target {
        "klipper" | "marlin" => "rapid_feed = 3000\n",
        "mach3" => "dwell_unit = \"seconds\"\n",
        _ => "",
    };
    let key = if key.is_empty() { String::new() } else { format!("path_control = {key}\n") };
    let diameter = if kind == "lathe" { "diameter_axis = \"X\"\npower_on_diameter = false\n" } else { "" };
    let settings =
        settings(&format!("[machine]\nkind = \"{kind}\"\n{diameter}[output]\ntarget = \"{target}\"\n{more}{key}"));
    let program = if kind == "lathe" { LATHE } else { MILL };
    let compiled = compile_bytes("PART.MPF", program.as_bytes().to_vec(), "sinumerik", &settings, &NoFiles);
    assert!(!compiled.has_errors(), "{target} {kind} {key}: {:#?}", compiled.rendered);
    let is_word = |word: &str| {
        ["G60", "G61", "G64", "G641", "G642", "G187"].contains(&word)
            || word.starts_with('P') && word[1..].starts_with(|c: char| c.is_ascii_digit())
            || word.starts_with("CTOL=")
            || word.starts_with("ADIS=")
    };
    let mut found = Vec::new();
    for line in compiled.output.lines().filter(|line| !line.contains("partc") && !line.contains("PARTC")) {
        if let Some((_, tolerance)) = line.split_once("CYCL DEF 32.1 ") {
            found.push(tolerance.to_owned());
        }
        found.extend(line.split(' ').filter(|word| is_word(word)).map(str::to_owned));
    }
    let told = compiled.rendered.iter().any(|found| found.contains("O9338"));
    (found, told)
}

#[test]
fn each_head_states_how_corners_are_taken_or_it_is_told_that_none_does() {
    for (target, wanted, told) in [
        ("linuxcnc", "G64 P0.01", false),
        ("grbl", "", true),
        ("grblhal", "", true),
        ("fanuc", "G64", true),
        ("haas", "G64", true),
        ("sinumerik", "G642 CTOL=0.01", false),
        ("heidenhain", "T0.01", false),
        ("centroid", "", true),
        ("mazak", "G64", true),
        ("mach3", "", true),
        ("uccnc", "", true),
        ("okuma", "", true),
        ("klipper", "", true),
        ("marlin", "", true),
    ] {
        assert_eq!(
            words(target, "mill", ""),
            (wanted.split_whitespace().map(str::to_owned).collect(), told),
            "{target}"
        );
        assert_eq!(words(target, "mill", "\"none\""), (Vec::new(), false), "{target}");
    }
    for (target, wanted, told) in [
        ("linuxcnc", "G61", false),
        ("grbl", "", true),
        ("fanuc-lathe", "G64", true),
        ("fanuc-lathe-b", "G64", true),
        ("fanuc-lathe-c", "G64", true),
        ("sinumerik", "G60", false),
    ] {
        assert_eq!(
            words(target, "lathe", ""),
            (wanted.split_whitespace().map(str::to_owned).collect(), told),
            "{target}"
        );
    }
}

#[test]
fn what_the_configuration_wants_stands_in_the_head() {
    for (target, key, wanted) in [
        ("linuxcnc", "\"exact\"", "G61"),
        ("linuxcnc", "{ tolerance = 0.05 }", "G64 P0.05"),
        ("fanuc", "\"exact\"", "G61"),
        ("mach3", "\"exact\"", "G61"),
        ("sinumerik", "\"exact\"", "G60"),
        ("sinumerik", "{ tolerance = 0.002 }", "G642 CTOL=0.002"),
        ("heidenhain", "{ tolerance = 0.05 }", "T0.05"),
    ] {
        assert_eq!(
            words(target, "mill", key),
            (wanted.split(' ').map(str::to_owned).collect(), false),
            "{target} {key}"
        );
    }
}

/// A word in a table that no case above prints would be a word that nobody looked at.
#[test]
fn every_target_is_in_the_tables() {
    let here = include_str!("path_control.rs");
    for target in target::ALL {
        assert!(here.contains(&format!("(\"{}\"", target.name)), "{}", target.name);
    }
}

#[test]
fn values_that_are_none_are_refused() {
    let folder = Folder::new("path_control_values").with(&[("A.MPF", MILL)]);
    for (value, says) in [
        ("\"fast\"", "\"exact\", { tolerance = 0.01 } or \"none\""),
        ("{ tolerance = 0 }", "0.001 to 1 mm"),
        ("{ tolerance = 2.0 }", "0.001 to 1 mm"),
        ("{ p = 0.01 }", "\"exact\", { tolerance = 0.01 } or \"none\""),
        ("0.01", "a text in quotes or a table"),
    ] {
        folder.write("partc.toml", &format!("[output]\npath_control = {value}\n"));
        folder.run(&["compile", "A.MPF", "-o", "-"]).exits(2).says(says);
    }
}

#[test]
fn another_way_to_take_corners_is_a_difference() {
    let folder = Folder::new("path_control_diff").with(&[("A.MPF", MILL)]);
    folder.run(&["compile", "A.MPF", "-o", "a.ngc"]).exits(0);
    let output = folder.read("a.ngc");
    folder.run(&["diff", "A.MPF", "a.ngc"]).exits(0);
    for (name, to, says) in [
        ("free.ngc", " G64", "free.ngc: G64 (line 5)"),
        ("exact.ngc", " G61", "exact.ngc: G61 (line 5)"),
        ("larger.ngc", " G64 P0.02", "larger.ngc: G64 P0.02 (line 5)"),
        ("filter.ngc", " G64 P0.01 Q0.005", "filter.ngc: G64 P0.005 (line 5)"),
        ("none.ngc", "", "a.ngc: G64 P0.01 (line 5)"),
    ] {
        folder.write(name, &output.replace(" G64 P0.01", to));
        let ran = folder.run(&["diff", "a.ngc", name]);
        assert!(ran.out.contains(says), "{name}: {}", ran.out);
        ran.exits(1);
    }
    // Behind a while it is G61, and then G64 again.
    folder.write("between.ngc", &output.replace("G1 Y10", "G61\nG1 Y10"));
    folder.run(&["diff", "a.ngc", "between.ngc"]).exits(1);
    folder.write("twice.ngc", &output.replace("G1 Y10", "G64 P0.01\nG1 Y10"));
    folder.run(&["diff", "a.ngc", "twice.ngc"]).exits(0);
}

/// GRBL has no word for corners: its programs may be compared with others all the same.
#[test]
fn a_target_without_a_word_does_not_differ_by_it() {
    let folder = Folder::new("path_control_unsaid").with(&[("A.MPF", MILL)]);
    for target in ["linuxcnc", "grbl", "grblhal"] {
        folder.run(&["compile", "A.MPF", "--target", target, "-o", &format!("{target}.ngc")]).exits(0);
    }
    folder.run(&["diff", "linuxcnc.ngc", "grbl.ngc"]).exits(0);
    folder.run(&["diff", "A.MPF", "grblhal.ngc"]).exits(0);
}
