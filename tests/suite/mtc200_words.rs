//! No word of an MTC200 program goes in silence: it shows in the output, or a finding names it.

use partc::internals::text::files::NoFiles;

use super::common::{Compiled, compile_bytes, settings};

fn run(program: &str) -> Compiled {
    let settings =
        settings("[output]\ncompensation = \"control\"\n[control]\ng52 = \"shift\"\ninch_speed = \"metres\"\n");
    compile_bytes("P.npg", program.as_bytes().to_vec(), "mtc200", &settings, &NoFiles)
}

/// States in force in front of the word, so that it has something to change.
const BEFORE: &[&str] =
    &["", "G91", "G70", "G95", "G96 S100", "G18", "G19", "G16", "G02", "G00", "G61", "G55", "G42", "G47"];

/// What stands beside the word in its block.
const BESIDE: &[&str] = &["", "X5 Y4", "X5 Y4 Z3", "S500", "F2", "X0"];

/// Blocks behind the word, in which what it changed shows.
const BEHIND: &str = "G01 X7 Y9 Z1 F50\nX20 Y20 Z2\nG02 X24 Y24 R9\nG01 G40 X50 Y50\nG00 Z3\nG01 X1\nS200\nRET\n";

/// Does the word show, in the output or in a finding on its line?
fn shows(word: &str) -> bool {
    BEFORE.iter().any(|before| {
        BESIDE.iter().any(|beside| {
            let head = format!("G90 G94 G00 X0 Y0 Z0\nT1 M6\nG00 X1 Y1 Z1\nS100 M3\nG01 F100\n{before}\n");
            let with = run(&format!("{head}{word} {beside}\n{BEHIND}"));
            let without = run(&format!("{head} {beside}\n{BEHIND}"));
            let line = head.lines().count() as u32 + 1;
            let named =
                |compiled: &Compiled| compiled.findings.iter().filter(|found| found.label.loc.line == line).count();
            with.attempt.lines().skip(4).ne(without.attempt.lines().skip(4)) || named(&with) > named(&without)
        })
    })
}

#[test]
fn every_g_function_is_used_noted_or_refused() {
    let silent: Vec<u32> = (0..=200).chain([999, 1000]).filter(|n| !shows(&format!("G{n}"))).collect();
    assert_eq!(silent, [0u32; 0]);
}

#[test]
fn every_m_function_is_used_noted_or_refused() {
    let silent: Vec<u32> = (0..=200).chain([999, 1000]).filter(|n| !shows(&format!("M{n}"))).collect();
    assert_eq!(silent, [0u32; 0]);
}

#[test]
fn every_letter_is_used_noted_or_refused() {
    // N is the number of a block.
    let letters = ('A'..='Z').filter(|letter| *letter != 'N');
    let silent: Vec<char> = letters.filter(|letter| !shows(&format!("{letter}7"))).collect();
    assert_eq!(silent, [' '; 0]);
}

#[test]
fn every_name_is_used_noted_or_refused() {
    let names = [
        "RET",
        "PROGRAMMENDE",
        "BST .A",
        "HLT",
        "BRA .A",
        "BEQ .A",
        "BNE .A",
        "BPL .A",
        "BMI .A",
        "BSR .A",
        "RTS",
        "JMP P1",
        "JSR P1",
        "REV .A",
        "BES .A",
        "BER .A",
        "BEV .A",
        "CEV",
        "BTE .A",
        "SE 1",
        "RE 1",
        "WES 1",
        "WER 1",
        "DP",
        "SP",
        "RP",
        "AP",
        "WP",
        "POK",
        "CF2",
        "RD2",
        "ACC50",
        "TMS",
        "MTP",
        "LA_ON",
        "@1=5",
        "Q5",
        "O1",
        "H3",
        "/",
        "S1=500",
        "[hint]",
    ];
    let silent: Vec<&str> = names.into_iter().filter(|name| !shows(name)).collect();
    // The skip mark does nothing where no skip level is switched on.
    assert_eq!(silent, ["/"]);
}
