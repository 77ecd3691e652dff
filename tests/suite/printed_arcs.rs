//! The printed numbers of an arc, on every target: within what the receiver takes, and near the programmed arc.

use partc::internals::machine::settings::Units;
use partc::internals::target::{self, Target};
use partc::internals::text::files::NoFiles;

use super::common::{Compiled, compile_bytes, settings};

/// What is allowed besides the rounding of a place, in mm.
const LEAVES: f64 = 0.005;

/// Arcs of any radius and sweep: the end, then the centre, from the origin; and full circles.
fn arcs() -> Vec<([f64; 2], [f64; 2])> {
    let mut arcs = Vec::new();
    for (i, radius) in [0.7, 1.37, 3.3, 7.77, 21.21, 64.9, 301.3].into_iter().enumerate() {
        for (j, sweep) in [0.35f64, 1.0, 1.7, 2.9, 3.6, 5.1].into_iter().enumerate() {
            let first = 0.41 + (7 * i + 3 * j) as f64;
            let center = [-radius * libm::cos(first), -radius * libm::sin(first)];
            let end = [center[0] + radius * libm::cos(first + sweep), center[1] + radius * libm::sin(first + sweep)];
            arcs.push((end, center));
        }
        arcs.push(([0.0, 0.0], [radius * 0.6, radius * 0.8]));
    }
    arcs
}

fn print(target: &'static Target, configuration: &str, (end, center): ([f64; 2], [f64; 2])) -> Compiled {
    let mut settings = settings(configuration);
    settings.output.target = target;
    let [x, y] = end.map(|v| format!("{v:.6}"));
    let [i, j] = center.map(|v| format!("{v:.6}"));
    let text = format!("G17 G90 G0 X0 Y0 Z5\nS1000 M3\nG3 X{x} Y{y} I{i} J{j} F100\nM30\n");
    compile_bytes("PART.MPF", text.into_bytes(), "sinumerik", &settings, &NoFiles)
}

/// Value of a word of this line.
fn word(line: &str, address: char) -> Option<f64> {
    line.split(' ').find_map(|word| word.strip_prefix(address)?.parse().ok())
}

/// The largest distance between the circle and what is printed for it, and the largest difference of radii, in mm.
fn off(compiled: &Compiled, center: [f64; 2], mm: f64) -> [f64; 2] {
    let meant = libm::hypot(center[0], center[1]);
    let mut at = [0.0, 0.0];
    let mut most = [0.0f64; 2];
    let arc = |line: &&str| ["G1 ", "G01 ", "G3 ", "G03 "].iter().any(|word| line.starts_with(word));
    // What is printed as lines goes on without its G word nowhere: every block has it.
    for line in compiled.output.lines().filter(arc) {
        let to = [word(line, 'X').map_or(at[0], |x| x * mm), word(line, 'Y').map_or(at[1], |y| y * mm)];
        if line.starts_with("G3") || line.starts_with("G03") {
            let [i, j] = ['I', 'J'].map(|address| word(line, address).unwrap_or(0.0) * mm);
            let about = [at[0] + i, at[1] + j];
            let [first, last] = [at, to].map(|p| libm::hypot(p[0] - about[0], p[1] - about[1]));
            let from = libm::atan2(at[1] - about[1], at[0] - about[0]);
            let way = libm::atan2(to[1] - about[1], to[0] - about[0]) - from;
            let sweep = if way <= 0.0 || at == to { way + core::f64::consts::TAU } else { way };
            most[1] = most[1].max((first - last).abs());
            for look in 0..=200 {
                let share = f64::from(look) / 200.0;
                let (sin, cos) = libm::sincos(from + sweep * share);
                let radius = first + (last - first) * share;
                let p = [about[0] + radius * cos, about[1] + radius * sin];
                most[0] = most[0].max((libm::hypot(p[0] - center[0], p[1] - center[1]) - meant).abs());
            }
        } else {
            let middle = [(at[0] + to[0]) / 2.0, (at[1] + to[1]) / 2.0];
            for p in [middle, to] {
                most[0] = most[0].max((libm::hypot(p[0] - center[0], p[1] - center[1]) - meant).abs());
            }
        }
        at = to;
    }
    most
}

#[test]
fn printed_arcs_stay_near_the_programmed_ones_on_every_target() {
    for target in target::ALL {
        let words = target.name != "heidenhain" && target.frame.mill.is_some();
        for (units, places) in
            [(Units::Millimetres, 3), (Units::Millimetres, 0), (Units::Inches, 3), (Units::Inches, 0)]
        {
            let inches = units == Units::Inches;
            if !words || inches && target.frame.inch_head.is_none() {
                continue;
            }
            let unit = if inches { 25.4 } else { 1.0 };
            let places_key = if places == 0 { String::new() } else { format!("decimals = {places}\n") };
            let units_key = if inches { "inch" } else { "mm" };
            let configuration = format!(
                "[output]\nunits = \"{units_key}\"\nrapid_feed = 3000\npass_m = [3, 5]\ntool_length = \"off\"\n{places_key}"
            );
            let configuration = if target.motion.rapid_at_feed {
                configuration
            } else {
                configuration.replace("rapid_feed = 3000\n", "")
            };
            let step = unit
                * 10f64
                    .powi(-(if places == 0 { i32::from(target.numbers.length[usize::from(inches)]) } else { places }));
            let (mut printed, mut refused) = (0, 0);
            for arc in arcs() {
                let compiled = print(target, &configuration, arc);
                let codes: Vec<&str> = compiled.findings.iter().map(|found| found.code.id).collect();
                if codes.contains(&"O9335") {
                    refused += 1;
                    continue;
                }
                assert!(!compiled.has_errors(), "{} {units_key} {places}: {:#?}", target.name, compiled.rendered);
                let [off, radii] = off(&compiled, arc.1, unit);
                let name = target.name;
                assert!(
                    off <= 0.7072 * step + LEAVES + 1e-6,
                    "{name} {units_key} {places}: {off}\n{}",
                    compiled.output
                );
                assert!(
                    radii <= target.arcs.mismatch[usize::from(inches)] + 1e-9,
                    "{name}: {radii}\n{}",
                    compiled.output
                );
                printed += 1;
            }
            let coarse = inches && places == 3;
            assert_eq!(refused > 0, coarse, "{} {units_key} {places}: {printed} printed", target.name);
        }
    }
}

/// Lines that stand for an arc: rounding is a part of what they may leave it by.
#[test]
fn lines_keep_the_tolerance_with_their_rounding() {
    let uccnc = target::find("uccnc").expect("a target");
    for (output, fits) in [
        ("arc_fallback_tolerance = 0.005", true),
        ("arc_fallback_tolerance = 0.001", true),
        ("arc_fallback_tolerance = 0.001\ndecimals = 3", true),
        ("arc_fallback_tolerance = 0.005\nunits = \"inch\"", true),
        ("arc_fallback_tolerance = 0.001\nunits = \"inch\"", false),
        ("arc_fallback_tolerance = 0.01\nunits = \"inch\"\ndecimals = 3", false),
        ("arc_fallback_tolerance = 0.05\nunits = \"inch\"\ndecimals = 3", true),
    ] {
        let mut settings = settings(&format!("[output]\n{output}"));
        settings.output.target = uccnc;
        let text = b"G18 G90 G0 X0 Y0 Z5\nS1000 M3\nG3 X10 Z15 I10 K0 F100\nM30\n".to_vec();
        let compiled = compile_bytes("PART.MPF", text, "sinumerik", &settings, &NoFiles);
        let codes: Vec<&str> = compiled.findings.iter().map(|found| found.code.id).collect();
        assert_eq!(codes.contains(&"O9335"), !fits, "{output}: {:?}", compiled.rendered);
        assert_eq!(compiled.has_errors(), !fits, "{output}: {:?}", compiled.rendered);
        if !fits {
            continue;
        }
        let number = |key: &str| output.split(key).nth(1)?.split(['\n', ' ']).find_map(|text| text.parse::<f64>().ok());
        let most = number("arc_fallback_tolerance").expect("a number");
        let mm = if output.contains("inch") { 25.4 } else { 1.0 };
        let (mut at, mut off) = ([0.0, 5.0], 0.0f64);
        for line in compiled.output.lines().filter(|line| line.starts_with("G1 ")) {
            let to = [word(line, 'X').map_or(at[0], |x| x * mm), word(line, 'Z').map_or(at[1], |z| z * mm)];
            let middle = [(at[0] + to[0]) / 2.0, (at[1] + to[1]) / 2.0];
            off = [middle, to].iter().fold(off, |off, p| off.max((libm::hypot(p[0] - 10.0, p[1] - 5.0) - 10.0).abs()));
            at = to;
        }
        assert!(off > 0.0 && off <= most, "{output}: {off}");
    }
}
