//! Free contours of random words: no panic, a place for each finding, an end in reasonable time.

use std::time::{Duration, Instant};

use partc::internals::machine::Settings;

use super::damage::Dice;
use super::hostile::run_as;

const HEADS: [&str; 6] = ["FL", "FLT", "FC DR+", "FCT DR-", "FC", "FCT"];
const WORDS: [&str; 36] = [
    "X",
    "Y",
    "IX",
    "IY",
    "PR",
    "PA",
    "IPR",
    "IPA",
    "AN",
    "IAN",
    "LEN",
    "R+",
    "CCX",
    "CCY",
    "CCPR",
    "CCPA",
    "CCA",
    "ICCX",
    "ICCY",
    "P1X+1 P1Y",
    "P2X+5 P2Y",
    "P3X-5 P3Y",
    "PDX+1 PDY+2 D",
    "PAR 2 DP",
    "PAR ",
    "IX+5 RX ",
    "IY+1 RY ",
    "IAN+10 RAN ",
    "ICCX+1 RCCX ",
    "IPR+1 RPR ",
    "CLSD+ LEN",
    "CLSD- LEN",
    "P1X",
    "DP",
    "D",
    "RX ",
];
const VALUES: [&str; 14] = ["0", "1", "2", "3", "5", "10", "12.5", "20", "30", "45", "90", "180", "0.0001", "99999"];
const BETWEEN: [&str; 6] = ["RND R2", "CHF 1", "FSELECT 1", "FSELECT 3", "M8", "FPOL X+5 Y+5"];

#[test]
fn random_words_of_free_contours() {
    let mut dice = Dice(20_261_122);
    let settings = Settings::default();
    let mut longest = Duration::ZERO;
    for case in 0..1500 {
        let mut text = String::from("0 BEGIN PGM A MM\n1 L X+0 Y+0 R0 F100\n2 L X+10 Y+0\n");
        for block in 3..3 + 4 + dice.roll(40) {
            if dice.roll(6) == 0 {
                text += &format!("{block} {}\n", BETWEEN[dice.roll(BETWEEN.len())]);
                continue;
            }
            text += &format!("{block} {}", HEADS[dice.roll(HEADS.len())]);
            for _ in 0..dice.roll(5) {
                let sign = if dice.roll(4) == 0 { "-" } else { "" };
                let word = WORDS[dice.roll(WORDS.len())];
                let sign = if word.ends_with(['+', ' ']) { "" } else { sign };
                text += &format!(" {word}{sign}{}", VALUES[dice.roll(VALUES.len())]);
            }
            text.push('\n');
        }
        let start = Instant::now();
        run_as("klartext", &format!("random-{case}.H"), text.as_bytes(), &settings);
        longest = longest.max(start.elapsed());
    }
    assert!(longest < Duration::from_secs(5), "{longest:?}");
}

/// Every element leaves two solutions, and none is ever chosen.
#[test]
fn solutions_that_double_come_to_an_end() {
    let blocks: String = (2..400).map(|block| format!("{block} FL LEN10 X+{}\n", block * 3)).collect();
    let text = format!("0 BEGIN PGM A MM\n1 L X+3 Y+0 R0 F100\n{blocks}400 END PGM A MM\n");
    let compiled = run_as("klartext", "double.H", text.as_bytes(), &Settings::default());
    assert_eq!(compiled.findings.iter().filter(|found| found.code.id == "K9002").count(), 1);
    assert!(compiled.output.is_empty());
}
