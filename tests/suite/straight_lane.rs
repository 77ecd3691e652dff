//! Straight blocks take a lane of their own; with a comment behind it a block does not. Both ways lead to the same moves.

use partc::files::NoFiles;
use partc::internals::machine::Settings;
use proptest::prelude::*;

use super::book::{Case, cases};
use super::common::{Compiled, compile_bytes};

/// The program with an empty comment behind each block that is a line of words and nothing else.
fn commented(program: &str) -> String {
    let of_words = |c: char| c.is_ascii_uppercase() || c.is_ascii_digit() || " +-.=".contains(c);
    let plain = |line: &str| !line.trim().is_empty() && line.chars().all(of_words);
    let mut goes_on = false;
    let line = |line| {
        let follows = std::mem::replace(&mut goes_on, str::ends_with(str::trim_end(line), '~'));
        format!("{line}{}\n", if plain(line) && !follows { " ;" } else { "" })
    };
    program.lines().map(line).collect()
}

/// Output, and the findings by code and line.
fn said(compiled: &Compiled) -> (String, Vec<(&'static str, u32)>) {
    let findings = compiled.findings.iter().map(|found| (found.code.id, found.label.loc.line)).collect();
    (moves(&compiled.output), findings)
}

/// Without the line that tells the hash of the program.
fn moves(output: &str) -> String {
    output
        .lines()
        .filter(|line| !line.to_ascii_lowercase().contains(", hash "))
        .map(|line| format!("{line}\n"))
        .collect()
}

fn golden(case: &Case) {
    let Some(program) = case.text() else { return };
    if program.contains('\r') {
        return;
    }
    let (fast, slow) = (case.compile(), case.compile_instead(&commented(program)));
    assert_eq!(said(&fast), said(&slow), "{}", case.name);
}

#[test]
fn golden_programs_move_the_same() {
    cases("sinumerik").into_iter().chain(cases("klartext")).for_each(golden);
}

const SINUMERIK: &[&str] = &[
    "G1",
    "G0",
    "G2 X10 Y10 I5 J5",
    "G3 X0 Y20 CR=30",
    "X10",
    "Y20",
    "X5 Y5",
    "Z-3",
    "Z5 F50",
    "F100",
    "F0",
    "G0 X40",
    "G01 Y7 F300",
    "G1 X1 Y2 Z3 F4",
    "G1 X-8",
    "G0 Z20 F70",
    "X12 G1",
    "G1 X3 X4",
    "G41 D1",
    "G42",
    "G40",
    "G41 G1 X30 Y1",
    "G90",
    "G91",
    "G17",
    "G18",
    "G54",
    "G500",
    "G95",
    "G94",
    "G94 F80",
    "G96 S100",
    "G97 S500",
    "G93",
    "G70",
    "G71",
    "T1 D1",
    "D0",
    "D1",
    "M6",
    "M3 S800",
    "M5",
    "RND=1",
    "RNDM=2",
    "RNDM=0",
    "X20 RND=2",
    "X25 CHR=1",
    "ANG=30 X60",
    "ANG=10",
    "TRANS X5",
    "ATRANS Y3",
    "ROT RPL=30",
    "TRANS",
    "SCALE X2",
    "MIRROR X0",
    "G53 X0 Y0",
    "SUPA Z0",
    "G4 F1",
    "M0",
    "G33 Z-20 K2",
    "AP=30 RP=20",
    "G111 X0 Y0",
    "MCALL CYCLE81(5,0,1,-5)",
    "MCALL",
    "R1=R1+5",
    "X=R1",
    "G1 X=R1 F=R1+20",
    "A10",
    "G64",
    "G9 X3",
    "SOFT",
    "CYCLE81(5,0,1,-5)",
    "G1 X10 A5",
    "STOPRE",
    "G110 X1",
    "G290",
    "CR=5 X3 Y9",
    "G1 X0 Y0 F100\nG2 X10 Y0 I5 J0",
    "G1 X0 Y0 F100\nG3 X10 Y0 Z-2 I5 J0",
    "G1 X10 Y0 F90\nG3 X0 Y10 I-10\nX-10 Y0 J-10\nX0 Y-10 I10 F60",
    "G1 X0 Y0\nG2 X0 Y0 I7 J3",
    "G0 X3 Y4\nG2 X3 I2",
    "G2 Y4 J2",
    "G1 X0 Y0\nG2 X10.004 Y0 I5 J0",
    "G1 X0 Y0\nG3 X10.02 Y0.03 I5 J0",
    "G1 X0 Y0\nG3 X0.01 Y0.01 I5 J0",
    "G1 X0 Y0\nG2 X10 Z3 I5",
    "G1 X0 Y0 Z0\nG2 X10 Z3 I5 J0 F20",
    "X10 Y0 I5 J0",
    "X3 I2",
    "G1 X5 I3",
    "G2 X1 Y1 I0 J0",
    "G3 X10 Y0 I5 K0",
    "G2 I10",
    "CFIN",
    "G1 X-10 F0 G41",
    "G110 X5 Y5",
    "CT X5 Y5",
    "X9 Y2",
];

const KLARTEXT: &[&str] = &[
    "L X+10",
    "L Y+5 F200",
    "L Z-2 FMAX",
    "L X+3 Y+3 R0",
    "L X+1 Y+2 Z+3 F400",
    "L FMAX",
    "L F150",
    "L X+7 RL",
    "L X+9 RR F90",
    "L X+30 R0 FMAX",
    "L IX+5",
    "L X+4 M3",
    "CC X+0 Y+0",
    "C X+10 Y+0 DR+",
    "CR X+5 Y+5 R+20 DR-",
    "RND R2",
    "CHF 1",
    "LP PR+20 PA+30",
    "TOOL CALL 1 Z S2000",
    "TOOL CALL 1 Z",
    "FN 0: Q1 = +5",
    "L X+Q1",
    "L X+2 F MAX",
    "CYCL DEF 7.0 DATUM SHIFT",
    "CYCL DEF 7.1 X+5",
    "L X+6 FAUTO",
    "L Y+8 F0.2",
    "CT X+9 Y+9",
    "L A+10",
    "L X+1 X+2",
    "L C+5 X+3 F100",
    "M5",
    "L X+8 M91",
    "PLANE RESET STAY",
    "L Z+50 R0 FMAX M140",
    "APPR LT X+3 Y+3 LEN5 RL",
    "DEP LT LEN5",
];

fn agree(name: &str, dialect: &str, program: &str) -> Result<(), TestCaseError> {
    let settings = Settings::default();
    let compile = |text: String| compile_bytes(name, text.into_bytes(), dialect, &settings, &NoFiles);
    let (fast, slow) = (compile(program.to_owned()), compile(commented(program)));
    prop_assert_eq!(said(&fast), said(&slow), "{}", program);
    // Also what came out beside errors, which tells more of the state behind them.
    prop_assert_eq!(moves(&fast.attempt), moves(&slow.attempt), "{}", program);
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn random_sinumerik_programs_move_the_same(
        begun in any::<bool>(),
        lines in prop::collection::vec(prop::sample::select(SINUMERIK), 1..24),
        often in prop::collection::vec(prop::sample::select(&SINUMERIK[..20]), 24),
    ) {
        let head = if begun { "G17 G90 G54 G94\nT1 D1\nM6\nS800 M3\nG0 X0 Y0 Z10\nG1 Z0 F100\n" } else { "" };
        let body: String = lines.iter().zip(&often).map(|(line, next)| format!("{line}\n{next}\n")).collect();
        agree("A.MPF", "sinumerik", &format!("{head}{body}M30\n"))?;
    }

    #[test]
    fn random_arcs_move_the_same(
        arcs in prop::collection::vec((0.5f64..40.0, 0.0f64..360.0, -359.0f64..359.0, 0u8..4, 0u8..64), 1..16),
        beside in prop::sample::select(vec!["", "G41", "G42", "TRANS X7 Y-3", "G70", "ROT RPL=30", "G91", "CFTCP", "G290"]),
    ) {
        let mut body = format!("G17 G90 G54 G71 G94\nT1 D1\nM6\nS800 M3\nG0 X0 Y0 Z10\n{beside}\nG1 X1 Y1 Z0 F100\n");
        let (mut x, mut y) = (1.0_f64, 1.0_f64);
        for (radius, from, sweep, decimals, more) in arcs {
            let write = |value: f64| format!("{:+.*}", usize::from(decimals) + 1, value);
            let (begin, end) = (f64::to_radians(from), f64::to_radians(from + sweep));
            let (i, j) = (-radius * begin.cos(), -radius * begin.sin());
            let to = (x + i + radius * end.cos(), y + j + radius * end.sin());
            let code = if more & 1 > 0 { "" } else if sweep > 0.0 { "G3" } else { "G2" };
            let z = if more & 2 > 0 { "Z-1" } else { "" };
            let feed = if more & 4 > 0 { "F77" } else { "" };
            // One of the words is left out now and then.
            let words = [format!("X{}", write(to.0)), format!("Y{}", write(to.1)), format!("I{}", write(i)), format!("J{}", write(j))];
            let words: Vec<&str> = words.iter().enumerate().filter(|(n, _)| more >> 3 != *n as u8 + 1).map(|(_, word)| &word[..]).collect();
            body += &format!("{code} {} {z} {feed}\n", words.join(" "));
            (x, y) = (write(to.0).parse().unwrap_or(0.0), write(to.1).parse().unwrap_or(0.0));
        }
        agree("A.MPF", "sinumerik", &format!("{body}G40\nM30\n"))?;
    }

    #[test]
    fn random_klartext_programs_move_the_same(
        begun in any::<bool>(),
        lines in prop::collection::vec(prop::sample::select(KLARTEXT), 1..24),
        often in prop::collection::vec(prop::sample::select(&KLARTEXT[..10]), 24),
    ) {
        let head = if begun { "TOOL CALL 1 Z S2000\nL X+0 Y+0 Z+10 R0 FMAX M3\nL Z+0 F100" } else { "M5" };
        let blocks = head.lines().chain(lines.iter().zip(&often).flat_map(|(line, next)| [*line, *next]));
        let body: String = blocks.enumerate().map(|(n, line)| format!("{} {line}\n", n + 1)).collect();
        agree("A.H", "klartext", &format!("0 BEGIN PGM A MM\n{body}999 END PGM A MM\n"))?;
    }
}
