//! MTC200: bad input, and properties of whole programs.

use std::time::{Duration, Instant};

use proptest::prelude::*;

use partc::internals::machine::Settings;
use partc::internals::text::files::NoFiles;
use partc::internals::text::{FileError, Files, Memory, Opened, Request};

use super::book::cases;
use super::common::{Compiled, compile_bytes, settings};
use super::damage::{Dice, KINDS, damage};

/// What one small program may take, even unoptimized.
const SOON: Duration = Duration::from_secs(20);

/// Few steps, so that a mutated loop ends soon; options that let more be executed.
fn limited() -> Settings {
    settings(
        "[limits]\nsteps = 20000\noutput_blocks = 20000\n[output]\ncompensation = \"control\"\n\
         [control]\nfeed = 100\ng52 = \"position\"\ng53 = \"machine\"\nstart = { X = 0.0, Y = 0.0, Z = 0.0 }\n",
    )
}

fn run(name: &str, bytes: &[u8], settings: &Settings) -> Compiled {
    let start = Instant::now();
    let compiled = compile_bytes(name, bytes.to_vec(), "mtc200", settings, &NoFiles);
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
    run("p.npg", program.as_bytes(), settings).codes()
}

/// Programs to damage: golden cases, which use every feature between them.
fn victims(count: usize) -> Vec<(String, Vec<u8>)> {
    let all = cases("mtc200");
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
    let mut dice = Dice(0x5eed_0200);
    for (name, bytes) in victims(40) {
        for round in 0..250 {
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
    let giant = [b"G90 G01 F100 ".to_vec(), b"X+1 ".repeat(1 << 19), b"\nRET\n".to_vec()].concat();
    assert!(run("giant.npg", &giant, &Settings::default()).codes().contains(&"P0003"));
    let large = [b"G90 G01 F100 ".to_vec(), b"X+1 ".repeat(200_000), b"\nRET\n".to_vec()].concat();
    assert!(run("large.npg", &large, &Settings::default()).codes().contains(&"P1002"));
}

#[test]
fn deep_brackets() {
    for depth in [200, 10_000, 200_000] {
        let program = format!("@001={}1{}\nG90 G00 X=@001\nRET\n", "(".repeat(depth), ")".repeat(depth));
        assert_eq!(codes(&program, &Settings::default()), [""; 0], "{depth}");
    }
    assert_eq!(codes(&format!("@001={}1\nRET\n", "(".repeat(10_000)), &Settings::default()), ["P1001"]);
    assert_eq!(codes(&format!("@001={}1\nRET\n", "-".repeat(10_001)), &Settings::default()), [""; 0]);
}

#[test]
fn loops_and_calls_end() {
    let d = Settings::default();
    let few = settings("[limits]\nsteps = 100000\n");
    assert_eq!(codes(".A BRA .A\nRET\n", &few), ["P8106", "P4001"]);
    assert_eq!(codes(".A BSR .A\nRET\n", &d), ["P8106", "P4003"]);
    assert_eq!(codes("@001=1\n.A @002=1\nBNE .A\nRET\n", &few), ["P8106", "P4001"]);
    assert_eq!(codes("JSR P5\nRET\n", &d), ["P8106", "P0101"]);
}

/// Answers every call with the same program.
struct Same(&'static str);

impl Files for Same {
    fn open(&self, request: &Request<'_>) -> Result<Opened, FileError> {
        let text = Box::new(Memory::new(self.0.as_bytes().to_vec()));
        Ok(Opened { name: request.name.to_owned(), identity: request.name.to_owned(), text })
    }
}

#[test]
fn programs_that_call_each_other_end() {
    let few = settings("[limits]\nsteps = 10000\n");
    let compile = |main: &str, called| compile_bytes("m.npg", main.as_bytes().to_vec(), "mtc200", &few, &Same(called));
    assert_eq!(compile("JSR P5\nRET\n", "JSR P5\nRTS\n").codes(), ["P8106", "P4003"]);
    assert_eq!(compile("JMP P5\n", "JMP P5\n").codes(), ["P4001"]);
}

#[test]
fn bytes_of_all_kinds() {
    let mut dice = Dice(7);
    let settings = limited();
    const WORDS: &[&str] = &[
        "G01", "G2", "X1", "X=", "@1", "=", "(", ")", "I5", "R5", "CF1", "RD", ".A", "BRA", "\n", "F100", "RET", "BSR",
        "RTS", "G91", "G50", "G70", "G16", "M6", "T1", "G41", "G40", "-", "SIN", "1.5", "%NPG", ";", "[", "/", "N10",
    ];
    for size in [0, 1, 2, 3, 10, 100, 1000, 5000] {
        for _ in 0..20 {
            let noise: Vec<u8> = (0..size).map(|_| dice.roll(256) as u8).collect();
            run("noise.npg", &noise, &settings);
            let words: String = (0..size).flat_map(|_| [WORDS[dice.roll(WORDS.len())], " "]).collect();
            run("words.npg", words.as_bytes(), &settings);
        }
    }
}

// Properties.

/// Output lines that move.
fn moves(program: &str, options: &str) -> Vec<String> {
    let compiled = compile_bytes("P.npg", program.as_bytes().to_vec(), "mtc200", &settings(options), &NoFiles);
    assert!(!compiled.has_errors(), "{program}\n{:?}", compiled.rendered);
    compiled
        .output
        .lines()
        .filter(|line| line.starts_with("G0") || line.starts_with("G1 "))
        .map(str::to_owned)
        .collect()
}

const MILL: &str = "[output]\ncomments = false\n";
const LATHE: &str = "[machine]\nkind = \"lathe\"\n[output]\ncomments = false\n";

/// Points in thousandths of a millimetre.
fn points() -> impl Strategy<Value = Vec<(i32, i32)>> {
    prop::collection::vec((-200_000i32..200_000, -200_000i32..200_000), 1..20)
}

fn mm(n: i32) -> f64 {
    f64::from(n) / 1000.0
}

proptest! {
    #[test]
    fn distances_and_coordinates_are_the_same_path(points in points()) {
        let mut absolute = "G90 G00 X0 Y0\nG01 F500\n".to_owned();
        let mut distances = absolute.clone() + "G91\n";
        let mut at = (0, 0);
        for &(x, y) in &points {
            absolute += &format!("X{} Y{}\n", mm(x), mm(y));
            distances += &format!("X{} Y{}\n", mm(x - at.0), mm(y - at.1));
            at = (x, y);
        }
        prop_assert_eq!(moves(&(absolute + "RET\n"), MILL), moves(&(distances + "RET\n"), MILL));
    }

    #[test]
    fn inches_are_25_4_mm(points in points()) {
        let metric: String = points.iter().map(|(x, y)| format!("X{} Y{}\n", mm(*x) * 25.4, mm(*y) * 25.4)).collect();
        let inch: String = points.iter().map(|(x, y)| format!("X{} Y{}\n", mm(*x), mm(*y))).collect();
        let metric = format!("G71 G90 G01 F508\n{metric}RET\n");
        let inch = format!("G70 G90 G01 F20\n{inch}RET\n");
        prop_assert_eq!(moves(&metric, MILL), moves(&inch, MILL));
    }

    #[test]
    fn diameters_are_twice_the_radius(points in points(), incremental in any::<bool>()) {
        let body = |factor: i32| -> String { points.iter().map(|(x, z)| format!("X{} Z{}\n", mm(factor * x), mm(*z))).collect() };
        let mode = if incremental { "G91" } else { "G90" };
        let radius = format!("G15 G90 G00 X0 Z0\nG01 F100\n{mode}\n{}RET\n", body(1));
        let diameter = format!("G16 G90 G00 X0 Z0\nG01 F100\n{mode}\n{}RET\n", body(2));
        prop_assert_eq!(moves(&radius, LATHE), moves(&diameter, LATHE));
    }

    #[test]
    fn an_offset_is_added_as_radius(points in points(), dx in -50_000i32..50_000, dz in -50_000i32..50_000) {
        let body: String = points.iter().map(|(x, z)| format!("X{} Z{}\n", mm(2 * x), mm(*z))).collect();
        let shifted: String = points.iter().map(|(x, z)| format!("X{} Z{}\n", mm(2 * (x + dx)), mm(z + dz))).collect();
        let offset = format!("G16 G90 G01 F100\nG50 X{} Z{}\n{body}RET\n", mm(dx), mm(dz));
        prop_assert_eq!(moves(&offset, LATHE), moves(&format!("G16 G90 G01 F100\n{shifted}RET\n"), LATHE));
    }

    #[test]
    fn a_loop_is_its_passes(passes in 1u32..12, step in 1i32..5000) {
        let looped = format!("G90 G00 Z0\nG91 G01 F100\n@1={passes}\n.L Z-{}\n@1=@1-1\nBNE .L\nRET\n", mm(step));
        let unrolled = format!("G90 G00 Z0\nG91 G01 F100\n{}RET\n", format!("Z-{}\n", mm(step)).repeat(passes as usize));
        prop_assert_eq!(moves(&looped, MILL), moves(&unrolled, MILL));
    }

    /// Whatever the reading, the compiled centre is the programmed one.
    #[test]
    fn arcs_by_coordinates_and_by_distances_agree(x in -50_000i32..50_000, y in -50_000i32..50_000, r in 1_000i32..40_000) {
        // A quarter circle from (x + r, y) to (x, y + r) about (x, y).
        let arc = |i: i32, j: i32| format!("G90 G00 X{} Y{}\nG03 X{} Y{} I{} J{} F100\nRET\n", mm(x + r), mm(y), mm(x), mm(y + r), mm(i), mm(j));
        let output = |text: &str, centres: &str| -> Vec<String> {
            let options = settings(&format!("[control]\ncentres = \"{centres}\"\n"));
            let compiled = compile_bytes("P.npg", text.as_bytes().to_vec(), "mtc200", &options, &NoFiles);
            assert!(!compiled.has_errors(), "{text}\n{:?}", compiled.rendered);
            compiled.output.lines().filter(|line| line.starts_with("G3")).map(str::to_owned).collect()
        };
        prop_assert_eq!(output(&arc(x, y), "absolute"), output(&arc(-r, 0), "relative"));
    }
}
