//! The worked examples of the SINUMERIK contour reference, number by number.
//!
//! The listings are those of worked examples, computed by hand: X in diameters for turning, centres absolute. The moves of the golden
//! case are compared with them before they are rounded, so a listing accepted by mistake does not help.

use std::fmt::Write as _;

use partc::internals::driver::Session;
use partc::internals::geo::Plane;
use partc::internals::ir::{Function, Origin, motion};
use partc::internals::machine::Axis;
use partc::internals::text::{Memory, Opened};

use super::book;

/// Half a unit of the last place of the examples, and what a diameter makes of it.
const NEAR: f64 = 6e-5;

/// One listing and the case that has to make it.
struct Example {
    section: &'static str,
    case: &'static str,
    /// Factor from X of the listing to a radius.
    scale: f64,
    plane: Plane,
    listing: &'static str,
}

const fn turned(section: &'static str, case: &'static str, listing: &'static str) -> Example {
    Example { section, case, scale: 0.5, plane: Plane::Zx, listing }
}

const fn milled(section: &'static str, case: &'static str, listing: &'static str) -> Example {
    Example { section, case, scale: 1.0, plane: Plane::Xy, listing }
}

const F_EXTERNAL: &str = "G1 Z-47.5 X50.2
    G1 Z-48.5433 X49.6409
    G2 Z-48.6986 X49.6 K-48.6986 I50.8
    G1 Z-49.6 X49.6
    G2 Z-50.1942 X50.967 K-49.6 I50.8
    G1 Z-50 X53.7301
    G1 Z-50 X65";

const THREAD_END: &str = "G1 Z-28.8 X16.4
    G2 Z-30 X18.8 K-28.8 I18.8
    G1 Z-30 X30";

const EXAMPLES: &[Example] = &[
    turned(
        "8.1",
        "undercut_corners/example_8_1",
        "G1 Z-72.5 X65
         G1 Z-73.5433 X64.4409
         G2 Z-73.6986 X64.4 K-73.6986 I65.6
         G1 Z-74.4 X64.4
         G2 Z-75 X65.6 K-74.4 I65.6
         G1 Z-75 X80",
    ),
    turned(
        "8.2",
        "undercut_corners/example_8_2",
        "G1 Z-22.5 X65
         G1 Z-21.4567 X64.4409
         G3 Z-21.3014 X64.4 K-21.3014 I65.6
         G1 Z-20.6 X64.4
         G3 Z-20 X65.6 K-20.6 I65.6
         G1 Z-20 X80",
    ),
    turned("8.3", "undercut_corners/f_external_minus_z", F_EXTERNAL),
    turned(
        "8.3",
        "undercut_corners/f_external_plus_z",
        "G1 Z-22.5 X50.2
         G1 Z-21.4567 X49.6409
         G3 Z-21.3014 X49.6 K-21.3014 I50.8
         G1 Z-20.4 X49.6
         G3 Z-19.8058 X50.967 K-20.4 I50.8
         G1 Z-20 X53.7301
         G1 Z-20 X65",
    ),
    turned(
        "8.3",
        "undercut_corners/f_internal_minus_z",
        "G1 Z-27.5 X40
         G1 Z-28.5433 X40.5591
         G3 Z-28.6986 X40.6 K-28.6986 I39.4
         G1 Z-29.6 X40.6
         G3 Z-30.1942 X39.233 K-29.6 I39.4
         G1 Z-30 X36.4699
         G1 Z-30 X20",
    ),
    turned(
        "8.3",
        "undercut_corners/f_internal_plus_z",
        "G1 Z-32.5 X40
         G1 Z-31.4567 X40.5591
         G2 Z-31.3014 X40.6 K-31.3014 I39.4
         G1 Z-30.4 X40.6
         G2 Z-29.8058 X39.233 K-30.4 I39.4
         G1 Z-30 X36.4699
         G1 Z-30 X20",
    ),
    turned(
        "8.4",
        "undercut_corners/example_8_4",
        "G1 Z-27.5 X40
         G1 Z-28.5433 X40.5591
         G3 Z-28.6986 X40.6 K-28.6986 I39.4
         G1 Z-29.4 X40.6
         G3 Z-30 X39.4 K-29.4 I39.4
         G1 Z-30 X20",
    ),
    turned(
        "8.5, 30 degrees",
        "undercut_corners/thread_a_30",
        "G1 Z-21.2912 X20
         G1 Z-24.1304 X16.7215
         G2 Z-24.7304 X16.4 K-24.7304 I18.8
         G1 Z-28.8 X16.4
         G2 Z-30 X18.8 K-28.8 I18.8
         G1 Z-30 X30",
    ),
    turned(
        "8.5, 60 degrees",
        "undercut_corners/thread_a_60",
        "G1 Z-22.3304 X20
         G1 Z-23.0232 X17.6
         G2 Z-24.0624 X16.4 K-24.0624 I18.8
         G1 Z-28.8 X16.4",
    ),
    turned(
        "8.5, 90 degrees",
        "undercut_corners/thread_a_90",
        "G1 Z-22.85 X20
         G1 Z-22.85 X18.8
         G2 Z-24.05 X16.4 K-24.05 I18.8
         G1 Z-28.8 X16.4",
    ),
    turned("8.5, the end", "undercut_corners/thread_a_90", THREAD_END),
    turned(
        "8.5, form B",
        "undercut_cycles/cycle940_b_external_minus_z",
        "G1 Z-23.6912 X20
         G1 Z-26.5304 X16.7215
         G2 Z-27.1304 X16.4 K-27.1304 I18.8
         G1 Z-28.8 X16.4
         G2 Z-30 X18.8 K-28.8 I18.8
         G1 Z-30 X30",
    ),
    turned(
        "8.6, form C",
        "undercut_cycles/cycle940_c_internal_minus_z",
        "G1 Z-17.1116 X17.2937
         G1 Z-19.6099 X20.1785
         G3 Z-20.2099 X20.5 K-20.2099 I18.1
         G1 Z-28.8 X20.5
         G3 Z-30 X18.1 K-28.8 I18.1
         G1 Z-30 X12",
    ),
    turned(
        "8.6, form D",
        "undercut_cycles/cycle940_d_internal_minus_z",
        "G1 Z-20.8116 X17.2937
         G1 Z-23.3099 X20.1785
         G3 Z-23.9099 X20.5 K-23.9099 I18.1",
    ),
    turned(
        "8.7",
        "contours/stored_rebuilt",
        "G1 Z0 X27
         G1 Z-1.5 X30
         G1 Z-19.5 X30
         G1 Z-20.5433 X29.4409
         G2 Z-20.6986 X29.4 K-20.6986 I30.6
         G1 Z-21.4 X29.4
         G2 Z-22 X30.6 K-21.4 I30.6
         G1 Z-22 X42
         G3 Z-24 X46 K-24 I42
         G1 Z-40 X46
         G1 Z-52 X59.8564
         G1 Z-60 X59.8564",
    ),
    turned("8.8, chamfer", "contours/stored_start_chamfer", "G0 Z0 X54\nG1 Z-1 X52"),
    turned("8.9", "contours/stored_open_line", "G1 Z-3 X22\nG2 Z0 X40 K0 I30"),
    turned("8.12, to Z", "contours/ang_to_z", "G1 Z-28 X40.0111"),
    turned("8.12, to X", "contours/ang_to_x", "G1 Z-47.1962 X63"),
    turned(
        "8.13",
        "contours/ang_two_lines_rounded",
        "G1 Z-42.0808 X52.551
         G2 Z-44.0233 X55.8109 K-41.3044 I58.3466
         G1 Z-45 X60",
    ),
    turned(
        "8.14",
        "contours/ang_three_lines",
        "G1 Z-36.71 X32.9459
         G2 Z-37.5211 X34.5682 K-36.5363 I34.9155
         G1 Z-37.8513 X38.3133
         G3 Z-38.8018 X40.6014 K-39.3285 I37.7924
         G1 Z-70 X64",
    ),
    milled(
        "8.11",
        "contours/pole_g17",
        "G1 X42.766082 Y27.943057
         G3 X3.054073 Y44.39231 I10 J5
         G1 X-13.492316 Y13.550503",
    ),
    milled(
        "8.15, moves",
        "drilling/cycle83_amount",
        "G0 Z151
         G1 Z100
         G0 Z101
         G1 Z70
         G0 Z71
         G1 Z50
         G0 Z51
         G1 Z30
         G0 Z31
         G1 Z17.5
         G0 Z18.5
         G1 Z5
         G0 Z155",
    ),
    milled("8.16, re-entry", "drilling/cycle83_factor_removal", "G1 Z-20\nG0 Z1\nG0 Z-19.4"),
    milled("8.16, re-entry", "drilling/cycle83_factor_removal", "G1 Z-48.8\nG0 Z1\nG0 Z-47.824"),
];

/// Moves of a case, as they are before printing.
#[derive(Default)]
struct Moves(Vec<motion::Move>);

impl motion::Sink for Moves {
    fn movement(&mut self, mv: &motion::Move, _: &Origin) {
        self.0.push(*mv);
    }

    fn function(&mut self, _: &Function, _: &Origin) {}
    fn lost(&mut self, _: &Origin) {}
}

fn moves(case: &str) -> Vec<motion::Move> {
    let case = book::find(&format!("sinumerik/{case}")).unwrap_or_else(|| panic!("{case}"));
    let text = Box::new(Memory::new(case.program.clone()));
    let session = Session::new(Opened { name: case.file.clone(), identity: case.file.clone(), text });
    let dialect = partc::internals::dialect::find("sinumerik").expect("a dialect");
    let mut out = Moves::default();
    session.lower(dialect, &case.settings(), case, &mut out);
    assert!(!session.diags.has_errors(), "{} is refused", case.name);
    // What a chamfer leaves of a line may have no length.
    out.0.dedup_by(|mv, before| matches!(mv.path, motion::Path::Line(_)) && mv.end == before.end);
    out.0
}

/// `word` and its number in a line of a listing.
fn word(line: &str, letter: char) -> Option<f64> {
    let word = line.split_whitespace().find(|word| word.starts_with(letter))?;
    Some(word[1..].parse().unwrap_or_else(|_| panic!("{line}")))
}

/// Does the move do what the line says?
fn fits(mv: &motion::Move, line: &str, example: &Example) -> bool {
    let near = |a: f64, b: f64| (a - b).abs() <= NEAR;
    let x = |value: f64| value * example.scale;
    let ends = [(Axis::X, word(line, 'X').map(x)), (Axis::Y, word(line, 'Y')), (Axis::Z, word(line, 'Z'))];
    let end = ends.iter().all(|(axis, wanted)| wanted.is_none_or(|w| mv.end.get(*axis).is_some_and(|v| near(v, w))));
    let path = match (&mv.path, &line.trim_start()[..2]) {
        (motion::Path::Rapid, "G0") | (motion::Path::Line(_), "G1") => true,
        (motion::Path::Arc(arc, _), g @ ("G2" | "G3")) => {
            let (first, second) = match example.plane {
                Plane::Zx => (word(line, 'K'), word(line, 'I').map(x)),
                _ => (word(line, 'I'), word(line, 'J')),
            };
            let (Some(first), Some(second)) = (first, second) else { panic!("{line}") };
            (arc.sweep > 0.0) == (g == "G3") && near(arc.center.x, first) && near(arc.center.y, second)
        }
        _ => false,
    };
    end && path
}

#[test]
fn the_reference_is_met_number_by_number() {
    let mut bad = String::new();
    for example in EXAMPLES {
        let lines: Vec<&str> = example.listing.lines().collect();
        let made = moves(example.case);
        let met =
            made.windows(lines.len()).any(|part| part.iter().zip(&lines).all(|(mv, line)| fits(mv, line, example)));
        if !met {
            let _ = writeln!(bad, "{} ({}):", example.section, example.case);
            for mv in &made {
                let _ = writeln!(bad, "  {:?} {:?}", mv.end, mv.path);
            }
        }
    }
    assert!(bad.is_empty(), "not as in the reference:\n{bad}");
}
