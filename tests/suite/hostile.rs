//! Input that is damaged, absurd or malicious: no panic, every finding has a place, budgets hold.

use std::time::{Duration, Instant};

use partc::internals::machine::Settings;
use partc::internals::text::files::NoFiles;

use super::book::cases;
use super::common::{Compiled, compile_bytes, settings};
use super::damage::{Dice, KINDS, damage};

/// What one small program may take, even unoptimized.
const SOON: Duration = Duration::from_secs(20);

/// Few steps, so that a mutated loop ends soon.
pub fn limited() -> Settings {
    settings(
        "[limits]\nsteps = 20000\noutput_blocks = 20000\n[control]\nfeed = 100\n[output]\ncompensation = \"control\"\n",
    )
}

fn run(name: &str, bytes: &[u8], settings: &Settings) -> Compiled {
    run_as("klartext", name, bytes, settings)
}

/// Compiles in a dialect and checks what holds for every input.
pub fn run_as(dialect: &str, name: &str, bytes: &[u8], settings: &Settings) -> Compiled {
    let start = Instant::now();
    let compiled = compile_bytes(name, bytes.to_vec(), dialect, settings, &NoFiles);
    assert!(start.elapsed() < SOON, "{name} took {:?}", start.elapsed());
    for found in &compiled.findings {
        let loc = found.label.loc;
        let inside = loc.span.start as usize <= bytes.len() && loc.span.end as usize <= bytes.len() + 1;
        assert!(inside && loc.line >= 1, "{name}: no place: {found:?} in {} bytes", bytes.len());
        assert!(!found.message.is_empty());
    }
    assert!(compiled.attempt.is_ascii());
    for line in compiled.output.lines() {
        assert!(line.len() <= 255, "{line}");
        assert!(!line.contains("NaN") && !line.contains("inf") || line.starts_with('('), "{line}");
    }
    compiled
}

fn text(program: &str) -> Compiled {
    run("hostile.H", program.as_bytes(), &Settings::default())
}

/// Programs to damage: golden cases, which use every feature between them.
fn victims(count: usize) -> Vec<(String, Vec<u8>)> {
    victims_of("klartext", count)
}

pub fn victims_of(dialect: &str, count: usize) -> Vec<(String, Vec<u8>)> {
    let all = cases(dialect);
    let step = (all.len() / count).max(1);
    all.into_iter().step_by(step).take(count).map(|case| (case.name.clone(), case.program.clone())).collect()
}

#[test]
fn every_prefix_of_twenty_programs() {
    let settings = limited();
    for (name, bytes) in victims(20) {
        for end in 0..bytes.len() {
            run(&name, &bytes[..end], &settings);
        }
    }
}

#[test]
fn damaged_programs() {
    let settings = limited();
    let mut dice = Dice(0x5eed_0001);
    let mut tried = 0;
    for (name, bytes) in victims(40) {
        for round in 0..260 {
            let mut damaged = bytes.clone();
            for _ in 0..1 + dice.roll(3) {
                damage(&mut damaged, round % KINDS, &mut dice);
            }
            run(&name, &damaged, &settings);
            tried += 1;
        }
    }
    assert!(tried >= 10_000, "{tried}");
}

#[test]
fn a_giant_line() {
    let mut program = b"0 BEGIN PGM A MM\n1 L ".to_vec();
    program.extend(std::iter::repeat_n(b"X+1 ", 1 << 19).flatten());
    program.extend_from_slice(b"\n2 END PGM A MM\n");
    assert!(run("giant.H", &program, &Settings::default()).codes().contains(&"P0003"));
    // Just under the limit the block is read, and refused for what it says.
    let mut program = b"0 BEGIN PGM A MM\n1 L ".to_vec();
    program.extend(std::iter::repeat_n(b"X+1 ", 200_000).flatten());
    program.extend_from_slice(b"\n2 END PGM A MM\n");
    assert!(run("large.H", &program, &Settings::default()).codes().contains(&"P1002"));
}

#[test]
fn deep_brackets() {
    for depth in [200, 10_000, 200_000] {
        let program = format!(
            "0 BEGIN PGM A MM\n1 Q1 = {}1{}\n2 L X+Q1 R0 F100\n3 END PGM A MM\n",
            "( ".repeat(depth),
            " )".repeat(depth)
        );
        let compiled = text(&program);
        assert_eq!(compiled.has_errors(), depth > 200_000, "{depth}: {:?}", compiled.rendered);
    }
    let unclosed = format!("0 BEGIN PGM A MM\n1 Q1 = {}1\n2 END PGM A MM\n", "(".repeat(10_000));
    assert!(text(&unclosed).codes().contains(&"P1001"));
    let signs = format!("0 BEGIN PGM A MM\n1 Q1 = {}1\n2 END PGM A MM\n", "- ".repeat(10_001));
    assert!(!text(&signs).has_errors());
}

#[test]
fn nested_repeats_stop_at_the_step_limit() {
    let program = "0 BEGIN PGM A MM\n1 LBL 1\n2 LBL 2\n3 LBL 3\n4 CALL LBL 3 REP 65534\n5 CALL LBL 2 REP 65534\n\
                   6 CALL LBL 1 REP 65534\n7 END PGM A MM\n";
    let settings = settings("[limits]\nsteps = 1000000\n");
    let compiled = run("rep.H", program.as_bytes(), &settings);
    assert_eq!(compiled.codes(), ["P4001"]);
    // The innermost repeat is named, with its count.
    assert!(
        compiled.rendered[0].contains(":5:") && compiled.rendered[0].contains("1000000"),
        "{:?}",
        compiled.rendered
    );
}

#[test]
fn output_limit() {
    let program = "0 BEGIN PGM A MM\n1 L X+0 R0 F100\n2 LBL 1\n3 L IX+1\n4 CALL LBL 1 REP 60000\n5 END PGM A MM\n";
    let settings = settings("[limits]\noutput_blocks = 1000\n");
    let compiled = run("long.H", program.as_bytes(), &settings);
    assert_eq!(compiled.codes(), ["P4002"]);
    assert!(compiled.attempt.lines().count() < 1010);
}

#[test]
fn mistakes_end_with_their_code() {
    let with = |body: &str| text(&format!("0 BEGIN PGM A MM\n{body}\n99 END PGM A MM\n")).codes().join(" ");
    assert_eq!(with("1 LBL 1\n2 CALL LBL 1\n3 LBL 0\n4 M30"), "P2012");
    assert_eq!(with("1 LBL 1\n2 FN 9: IF +0 EQU +0 GOTO LBL 1"), "P4001");
    assert_eq!(with("1 Q1 = 1 / 0"), "P2022");
    assert_eq!(with("1 L X+Q1 R0 F100"), "P2020");
    assert_eq!(with("1 CALL LBL 7"), "P2011");
    assert_eq!(with("1 CALL PGM B.H"), "P0101");
}

#[test]
fn bytes_of_all_kinds() {
    let mut dice = Dice(7);
    let settings = limited();
    for size in [0, 1, 2, 3, 10, 100, 1000, 5000] {
        for _ in 0..20 {
            let noise: Vec<u8> = (0..size).map(|_| dice.roll(256) as u8).collect();
            run("noise.H", &noise, &settings);
            let words: Vec<u8> = (0..size)
                .flat_map(|_| {
                    let words = [
                        "L", "X+1", "IX", "C", "CC", "Q1", "=", "(", ")", "RND", "R5", "DR+", "\n", "LBL", "1", "F",
                        "FMAX", "CALL",
                    ];
                    format!("{} ", words[dice.roll(words.len())]).into_bytes()
                })
                .collect();
            run("words.H", &words, &settings);
        }
    }
}

/// A byte that is no letter of its own is one place in the program, however it is shown.
#[test]
fn places_are_counted_in_bytes() {
    for word in ["Q3%45=+1", "Q200=%", "% Q200=+2", "Q201=%=%"] {
        for number in [100, 105, 110, 111, 120, 125] {
            let block = format!("0 BEGIN PGM A MM\n1 GLOBAL DEF {number} ALL {word}\n2 END PGM A MM\n");
            let bytes: Vec<u8> = block.bytes().flat_map(|b| if b == b'%' { vec![0xff; 90] } else { vec![b] }).collect();
            run("A.H", &bytes, &limited());
        }
    }
}
