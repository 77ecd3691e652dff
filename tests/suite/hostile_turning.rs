//! Damaged, absurd and malicious turning programs: no panic, every finding has a place, budgets hold.

use partc::internals::machine::Settings;

use super::common::{Compiled, settings};
use super::damage::{Dice, KINDS, damage};
use super::hostile::{limited, run_as, victims_of};

const DIALECT: &str = "heidenhain-turning";

fn text(program: &str) -> Compiled {
    run_as(DIALECT, "hostile.nc", program.as_bytes(), &Settings::default())
}

#[test]
fn every_prefix_of_turning_programs() {
    let settings = limited();
    for (name, bytes) in victims_of(DIALECT, 20) {
        for end in 0..bytes.len() {
            run_as(DIALECT, &name, &bytes[..end], &settings);
        }
    }
}

#[test]
fn damaged_turning_programs() {
    let settings = limited();
    let mut dice = Dice(0x5eed_0002);
    for (name, bytes) in victims_of(DIALECT, 40) {
        for round in 0..130 {
            let mut damaged = bytes.clone();
            for _ in 0..1 + dice.roll(3) {
                damage(&mut damaged, round % KINDS, &mut dice);
            }
            run_as(DIALECT, &name, &damaged, &settings);
        }
    }
}

#[test]
fn words_in_any_order() {
    const WORDS: &[&str] = &[
        "G0",
        "G1",
        "G2",
        "G13",
        "X20",
        "Xi-5",
        "Z-10",
        "X?",
        "Z?",
        "A20",
        "B2",
        "B-1",
        "R5",
        "I10",
        "K-5",
        "Q1",
        "\n",
        "\n",
        "G31",
        "F1.5",
        "U-1",
        "G80",
        "G22",
        "G25",
        "H5",
        "FINISHED PART\n",
        "MACHINING\n",
        "BLANK\n",
        "#1=5\n",
        "IF #1==5\n",
        "ENDIF\n",
        "WHILE #1>0\n",
        "ENDWHILE\n",
        "L\"A\"\n",
        "SUBPROGRAM \"A\"\n",
        "RETURN\n",
        "END\n",
        "[c]",
        "X#1",
        "T1",
        "G59",
        "G51",
        "G14",
        "M3",
        "NS2",
        "G96",
        "S100",
        "SWITCH 1\n",
        "CASE 1\n",
        "BREAK\n",
    ];
    let settings = limited();
    let mut dice = Dice(11);
    for _ in 0..3000 {
        let mut program = "G95 F0.2\nG0 X50 Z2\n".to_owned();
        for _ in 0..dice.roll(40) {
            program += WORDS[dice.roll(WORDS.len())];
            program += " ";
        }
        run_as(DIALECT, "words.nc", program.as_bytes(), &settings);
    }
    for size in [0, 1, 3, 10, 100, 3000] {
        for _ in 0..20 {
            let noise: Vec<u8> = (0..size).map(|_| dice.roll(256) as u8).collect();
            run_as(DIALECT, "noise.nc", &noise, &settings);
        }
    }
}

#[test]
fn a_giant_turning_block() {
    let mut program = b"G94 F100\n".to_vec();
    program.extend(std::iter::repeat_n(b"X1 ", 1 << 19).flatten());
    program.extend_from_slice(b"\nG0 X1\n");
    assert!(run_as(DIALECT, "giant.nc", &program, &Settings::default()).codes().contains(&"P0003"));
    let mut program = b"G0 ".to_vec();
    program.extend(std::iter::repeat_n(b"X1 ", 200_000).flatten());
    assert!(run_as(DIALECT, "large.nc", &program, &Settings::default()).codes().contains(&"P1002"));
}

#[test]
fn deep_turning_formulas() {
    for depth in [200, 100_000] {
        let program = format!("#1={}1{}\nG94 F100\nG0 X#1\nM30\n", "(".repeat(depth), ")".repeat(depth));
        assert!(!text(&program).has_errors(), "{depth}");
    }
    assert!(text(&format!("#1={}1\n", "(".repeat(10_000))).codes().contains(&"P1001"));
}

#[test]
fn endless_loops_stop_at_the_step_limit() {
    let settings = settings("[limits]\nsteps = 100000\n");
    let run = |program: &str| run_as(DIALECT, "loop.nc", program.as_bytes(), &settings).codes().join(" ");
    assert_eq!(run("WHILE 1==1\n#1=1\nENDWHILE\n"), "P4001");
    // Branches that are passed count as well.
    assert_eq!(run("WHILE 1==1\nIF 1==2\n#1=1\nENDIF\nENDWHILE\n"), "P4001");
    let nested = format!("{}#1=1\n{}", "IF 1==1\n".repeat(200), "ENDIF\n".repeat(200));
    assert!(run(&nested).contains("T1009"));
}

/// Whatever the numbers, a chain of elements with open data ends in moves or in a finding, never in a wrong start.
#[test]
fn open_elements_with_any_numbers() {
    let mut dice = Dice(23);
    let settings = limited();
    for _ in 0..3000 {
        let mut number = |span: usize| dice.roll(2 * span) as f64 / 2.0 - span as f64 / 2.0;
        let (a, b, c, d, e) = (number(200), number(200), number(360), number(360), number(100));
        let program = format!(
            "HEADER\n#UNIT METRIC\nMACHINING\nG94 F100\nG0 X{a} Z{b}\nG1 A{c}\nG2 X? Z? R{e}\nG1 X{b} Z{a} A{d}\nG13 X? Z{e} I{a} K{b}\nEND\n"
        );
        run_as(DIALECT, "open.nc", program.as_bytes(), &settings);
    }
}
