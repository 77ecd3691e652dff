//! SINUMERIK: bad input, and properties of whole programs.

use std::time::{Duration, Instant};

use proptest::prelude::*;

use partc::internals::machine::Settings;
use partc::internals::text::files::NoFiles;
use partc::internals::text::{FileError, Files, Memory, Opened, Request};

use super::book::cases;
use super::common::{Compiled, check_program, compile_bytes, settings};
use super::damage::{Dice, KINDS, damage};

/// What one small program may take, even unoptimized.
const SOON: Duration = Duration::from_secs(20);

/// Few steps, so that a mutated loop ends soon; options that let more be executed.
fn limited(lathe: bool) -> Settings {
    let machine = if lathe { "[machine]\nkind = \"lathe\"\ndiameter_axis = \"X\"\n" } else { "" };
    settings(&format!(
        "{machine}[limits]\nsteps = 20000\noutput_blocks = 20000\n[output]\ncompensation = \"control\"\n[control]\nfeed = 100\n"
    ))
}

fn run(name: &str, bytes: &[u8], settings: &Settings) -> Compiled {
    let start = Instant::now();
    let compiled = compile_bytes(name, bytes.to_vec(), "sinumerik", settings, &NoFiles);
    assert!(start.elapsed() < SOON, "{name} took {:?}", start.elapsed());
    for found in &compiled.findings {
        let loc = found.label.loc;
        let inside = loc.span.start as usize <= bytes.len() && loc.span.end as usize <= bytes.len() + 1;
        assert!(inside && loc.line >= 1, "{name}: no place: {found:?} in {} bytes", bytes.len());
        assert!(!found.message.is_empty());
    }
    assert!(compiled.attempt.is_ascii());
    for line in compiled.output.lines() {
        assert!(
            line.len() <= 255 && (!line.contains("NaN") && !line.contains("inf") || line.starts_with('(')),
            "{line}"
        );
    }
    compiled
}

fn codes(program: &str, settings: &Settings) -> Vec<&'static str> {
    run("P.MPF", program.as_bytes(), settings).codes()
}

/// Programs to damage: golden cases, which use every feature between them.
fn victims(count: usize) -> Vec<(String, Vec<u8>)> {
    let all = cases("sinumerik");
    let step = (all.len() / count).max(1);
    all.into_iter().step_by(step).take(count).map(|case| (case.name.clone(), case.program.clone())).collect()
}

#[test]
fn every_prefix_of_twenty_programs() {
    for (i, (name, bytes)) in victims(20).into_iter().enumerate() {
        let settings = limited(i % 2 == 0);
        for end in 0..bytes.len() {
            run(&name, &bytes[..end], &settings);
        }
    }
}

#[test]
fn damaged_programs() {
    let mut dice = Dice(0x5eed_0840);
    for (i, (name, bytes)) in victims(60).into_iter().enumerate() {
        let settings = limited(i % 2 == 0);
        for round in 0..150 {
            let mut damaged = bytes.clone();
            for _ in 0..1 + dice.roll(3) {
                damage(&mut damaged, round % KINDS, &mut dice);
            }
            run(&name, &damaged, &settings);
        }
    }
}

#[test]
fn giant_lines() {
    let giant = [b"G90 G1 F100 ".to_vec(), b"X1 ".repeat(1 << 19), b"\nM30\n".to_vec()].concat();
    assert!(run("giant.mpf", &giant, &Settings::default()).codes().contains(&"P0003"));
    let large = [b"G90 G1 F100 ".to_vec(), b"X1 ".repeat(200_000), b"\nM30\n".to_vec()].concat();
    assert!(run("large.mpf", &large, &Settings::default()).codes().contains(&"P1002"));
}

#[test]
fn deep_brackets() {
    for depth in [200, 10_000, 100_000] {
        let program = format!("R1={}1{}\nG0 X=R1\nM30\n", "(".repeat(depth), ")".repeat(depth));
        assert_eq!(codes(&program, &Settings::default()), [""; 0], "{depth}");
    }
    assert_eq!(codes(&format!("R1={}1\nM30\n", "(".repeat(10_000)), &Settings::default()), ["P1001"]);
    assert_eq!(codes(&format!("R1={}1\nM30\n", "NOT ".repeat(10_000)), &Settings::default()), [""; 0]);
}

#[test]
fn loops_and_calls_end() {
    let d = Settings::default();
    let few = settings("[limits]\nsteps = 100000\n");
    assert_eq!(codes("LOOP\nENDLOOP\nM30\n", &few), ["P4001"]);
    assert_eq!(codes("AGAIN: R1=1\nGOTOB AGAIN\nM30\n", &few), ["P4001"]);
    assert_eq!(codes("AA: R1=1\nBB: REPEAT AA BB\nM30\n", &d), ["P4003"]);
    assert_eq!(codes("%_N_M_MPF\nSELF\nM30\n%_N_SELF_SPF\nSELF\nM17\n", &d), ["P4003"]);
    let nested = "L1: L2: L3: R1=R1+1\nL3: R1=1\nREPEATB L3 P=9999\nEE: R2=2\nREPEAT L3 EE P=9999\nM30\n";
    assert!(codes(nested, &few).contains(&"P4001"));
    // What only goes forward ends by itself, however long it is.
    let long = format!("{}M30\n", "G0 X1\nG0 X2\n".repeat(200_000));
    assert_eq!(codes(&long, &few), [""; 0]);
    assert_eq!(codes("R1=1/0\nG0 X=R1\nM30\n", &d), ["P2022"]);
    assert_eq!(codes("G0 X=NOTHING\nM30\n", &d), ["S2001"]);
    assert_eq!(codes("GOTOF NOWHERE\nM30\n", &d), ["P2011"]);
    assert_eq!(codes("DEF STRING[100] TT\nTT=\"EXECSTRING(TT)\"\nEXECSTRING(TT)\nM30\n", &d), ["P4003"]);
    assert_eq!(codes("DEFINE AAA AS BBB\nDEFINE BBB AS AAA\nG0 X1\nM30\n", &d), [""; 0]);
}

/// Answers every call with the same program.
struct Same(&'static str);

impl Files for Same {
    fn open(&self, request: &Request<'_>) -> Result<Opened, FileError> {
        let text = Box::new(Memory::new(self.0.as_bytes().to_vec()));
        Ok(Opened { name: request.name.to_owned(), identity: "same".to_owned(), text })
    }
}

/// 5 turns of 300 a minute are 1 second, 10 turns of 100 are 6 seconds.
#[test]
fn a_dwell_counts_the_turns_of_the_named_spindle() {
    let program = b"S1=100 M1=3\nS2=300 M2=3\nG4 S2=5\nG4 S10\nM30\n";
    let compiled = run("m.mpf", program, &Settings::default());
    assert!(compiled.output.contains("G4 P1\nG4 P6\n"), "{}", compiled.output);
    assert_eq!(codes("S1=100 M1=3\nG4 S2=5\nM30\n", &Settings::default()), ["S2045"]);
}

#[test]
fn programs_that_call_each_other_end() {
    let few = settings("[limits]\nsteps = 10000\n");
    let compile =
        |main: &str, called| compile_bytes("m.mpf", main.as_bytes().to_vec(), "sinumerik", &few, &Same(called));
    assert_eq!(compile("OTHER\nM30\n", "OTHER\nM17\n").codes(), ["P4003"]);
}

/// A contour that no cycle takes is run to be checked only: without its call the program does the same.
#[test]
fn calling_a_contour_changes_nothing() {
    let mut count = 0;
    for case in cases("sinumerik/contour_cycles") {
        let text = case.text().expect("a program in UTF-8");
        let settings = if case.config.is_empty() { limited(false) } else { case.settings() };
        let moves = |text: &str| {
            let compiled = compile_bytes("P.MPF", text.as_bytes().to_vec(), "sinumerik", &settings, case);
            let output: Vec<String> =
                compiled.output.lines().filter(|line| !line.starts_with('(')).map(str::to_owned).collect();
            (!compiled.has_errors()).then_some(output)
        };
        let calls = |line: &&str| !line.to_ascii_uppercase().starts_with("CYCLE62");
        let without = text.lines().filter(calls).collect::<Vec<_>>().join("\n") + "\n";
        let taken = ["CYCLE63", "CYCLE64", "CYCLE72", "CYCLE95"].iter().any(|taker| text.contains(taker));
        if let Some(with) = moves(text).filter(|_| !taken) {
            assert_eq!(Some(with), moves(&without), "{}", case.name);
            count += 1;
        }
    }
    assert!(count >= 15, "{count} contours");
}

/// Contours that call themselves, hold their call, or never end.
#[test]
fn contours_that_turn_in_circles_end() {
    let settings = limited(true);
    for text in [
        "CYCLE62(\"A\",1)\nM30\nE_LAB_A_A:\nCYCLE62(\"A\",1)\nE_LAB_E_A:\n",
        "E_LAB_A_A:\nG0 X1 Z1\nG1 X2\nCYCLE62(\"A\",1)\nZ2\nE_LAB_E_A:\nM30\n",
        "CYCLE62(\"A\",1)\nM30\nE_LAB_A_A:\nG0 X1 Z1\nLOOP\nG1 X2\nX1\nENDLOOP\nE_LAB_E_A:\n",
        "CYCLE62(\"A\",1)\nM30\nE_LAB_A_A:\nG0 X1 Z1\nHERE:\nGOTOB HERE\nE_LAB_E_A:\n",
        "CYCLE62(\"A\",1)\nM30\nE_LAB_A_A:\nG0 X1 Z1\nEXECSTRING(\"CYCLE62(\"\"A\"\",1)\")\nE_LAB_E_A:\n",
        "LOOP\nCYCLE62(\"A\",1)\nENDLOOP\nM30\nE_LAB_A_A:\nG0 X1 Z1\nG1 X2\nE_LAB_E_A:\n",
        "CYCLE62(\"P\",0)\nM30\n",
    ] {
        assert!(run("P.MPF", text.as_bytes(), &settings).has_errors(), "{text}");
    }
}

#[test]
fn bytes_of_all_kinds() {
    let mut dice = Dice(7);
    const WORDS: &[&str] = &[
        "G1",
        "G2",
        "X1",
        "X=",
        "R1",
        "=",
        "(",
        ")",
        "I5",
        "CR=5",
        "RND=1",
        "ANG=30",
        "LAB:",
        "GOTOB",
        "\n",
        "F100",
        "M30",
        "REPEAT",
        "IF",
        "ENDIF",
        "G91",
        "TRANS",
        "AROT RPL=30",
        "DIAMON",
        "M6",
        "T1",
        "G41",
        "G40",
        "-",
        "SIN",
        "1.5",
        "%_N_A_SPF",
        ";",
        "[",
        "/",
        "N10",
        "DEF INT",
        "\"A\"",
        "<<",
        "MCALL",
        "CYCLE81(5,0,1,-5)",
        "G111",
        "AP=",
        "RP=10",
        "TURN=2",
        "FOR",
        "\nE_LAB_A_A:",
        "\nE_LAB_E_A:\n",
        "CYCLE62(\"A\",1)",
        "CYCLE95(\"A:LAB\",1,,,,,,,1)",
        "CYCLE952(,,,11)",
    ];
    for size in [0, 1, 2, 3, 10, 100, 1000, 5000] {
        for lathe in [false, true] {
            let settings = limited(lathe);
            for _ in 0..10 {
                let noise: Vec<u8> = (0..size).map(|_| dice.roll(256) as u8).collect();
                run("noise.mpf", &noise, &settings);
                let words: String = (0..size).flat_map(|_| [WORDS[dice.roll(WORDS.len())], " "]).collect();
                run("words.mpf", words.as_bytes(), &settings);
            }
        }
    }
}

// Properties.

/// Output lines that move.
fn moves(program: &str, options: &str) -> Vec<String> {
    let compiled = compile_bytes("P.MPF", program.as_bytes().to_vec(), "sinumerik", &settings(options), &NoFiles);
    assert!(!compiled.has_errors(), "{program}\n{:?}", compiled.rendered);
    compiled
        .output
        .lines()
        .filter(|line| {
            line.starts_with("G0 ") || line.starts_with("G1 ") || line.starts_with("G2 ") || line.starts_with("G3 ")
        })
        .map(str::to_owned)
        .collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// A frame and its inverse are no frame.
    #[test]
    fn a_frame_and_its_inverse(x in -50.0f64..50.0, y in -50.0f64..50.0, angle in -180.0f64..180.0) {
        let (x, y, angle) = ((x * 100.0).round() / 100.0, (y * 100.0).round() / 100.0, (angle * 10.0).round() / 10.0);
        let body = "G0 X10 Y20 Z0\nG1 X30 F100\nG3 X40 Y30 I0 J10\nM30\n";
        let framed = format!("TRANS X{x} Y{y}\nAROT RPL={angle}\nAROT RPL={}\nATRANS X{} Y{}\n{body}", -angle, -x, -y);
        prop_assert_eq!(moves(&framed, ""), moves(body, ""));
    }

    /// Polar and Cartesian end points agree.
    #[test]
    fn polar_is_cartesian(radius in 1.0f64..100.0, angle in -360.0f64..360.0) {
        let (radius, angle) = ((radius * 1000.0).round() / 1000.0, (angle * 1000.0).round() / 1000.0);
        let polar = format!("G111 X10 Y5\nG0 X0 Y0 Z0\nG1 RP={radius} AP={angle} F100\nM30\n");
        let formula = format!("G0 X0 Y0 Z0\nG1 X=10+{radius}*COS({angle}) Y=5+{radius}*SIN({angle}) F100\nM30\n");
        prop_assert_eq!(moves(&polar, ""), moves(&formula, ""));
    }

    /// A loop makes what its unrolled blocks make.
    #[test]
    fn a_loop_is_its_blocks(count in 1i32..30, step in -5i32..5) {
        let looped = format!("DEF INT NN\nG0 X0 Y0 Z0\nFOR NN=1 TO {count}\nG1 X=NN*{step}+1 Y=NN F100\nENDFOR\nM30\n").replace("*-", "*(-1)*");
        let unrolled: String = (1..=count).map(|n| format!("G1 X{} Y{n} F100\n", n * step + 1)).collect();
        prop_assert_eq!(moves(&looped, ""), moves(&format!("G0 X0 Y0 Z0\n{unrolled}M30\n"), ""));
    }

    /// Diameters are twice the radius, inches 25.4 mm.
    #[test]
    fn diameters_and_inches(x in 1i32..400, z in -200i32..0) {
        let lathe = "[machine]\nkind = \"lathe\"\ndiameter_axis = \"X\"\n";
        let radius = moves(&format!("DIAMOF\nG0 X{x} Z{z}\nM30\n"), lathe);
        prop_assert_eq!(&moves(&format!("DIAMON\nG0 X{} Z{z}\nM30\n", 2 * x), lathe), &radius);
        prop_assert_eq!(&moves(&format!("DIAMOF\nG0 X=DAC({}) Z{z}\nM30\n", 2 * x), lathe), &radius);
        let inch = format!("G70\nG0 X{x} Z{z}\nM30\n");
        let metric = format!("G71\nG0 X={x}*25.4 Z={}*25.4\nM30\n", if z < 0 { format!("(-{})", -z) } else { z.to_string() });
        prop_assert_eq!(moves(&inch, ""), moves(&metric, ""));
    }
}

/// What is told of a program, by code and line.
fn told(program: &str) -> Vec<(&'static str, u32)> {
    check_program("sinumerik", "A.MPF", program).iter().map(|found| (found.code.id, found.label.loc.line)).collect()
}

/// Its finding once stood at a column of a later block, and behind those of blocks that follow.
#[test]
fn a_failed_block_of_g41_begins_nothing_in_a_later_one() {
    let f0 = |body: &str| format!("G17 G90 G94\nG0 X0 Y0 Z5\nG1 X-10 F0 G41\n{body}M30\n");
    assert_eq!(told(&f0("X10\nG93\nG1 X3\n")), [("P2003", 3), ("P2002", 6)]);
    assert_eq!(told(&f0("G42 X10 F100\n")), [("P2003", 3), ("S2080", 4)]);
    assert_eq!(told(&f0("X10 F100\nG40 X20\n")), [("P2003", 3)]);
}
