//! Radius compensation by the target, on every target that has it: the words stand in the move that leads to the contour or
//! away from it, and every golden contour that is printed is the one that LinuxCNC gets.

use std::collections::BTreeMap;

use partc::internals::machine::settings::{Compensation, Decimals, Settings};
use partc::internals::target;
use partc::internals::text::files::NoFiles;

use super::book::{Case, cases};
use super::common::{Compiled, compile_bytes, settings};
use super::rewritten::compiled;

/// A target, golden programs that are printed at least, and whether the D of the tool stands beside G41.
const TARGETS: [(&str, usize, bool); 7] = [
    ("fanuc", 20, true),
    ("haas", 20, true),
    ("mazak", 20, true),
    ("centroid", 20, true),
    ("okuma", 20, true),
    ("mach3", 20, true),
    ("sinumerik", 20, false),
];

/// Words of a move or of the compensation: letters and numbers.
type Words = Vec<(char, f64)>;

/// The moves of a text with the words of the compensation, which may stand in a line in front of them.
fn moves(text: &str) -> Vec<Words> {
    let mut found: Vec<Words> = Vec::new();
    let mut waits = Words::new();
    let mut at = [f64::NAN; 3];
    for line in text.lines().filter(|line| !line.starts_with(['(', ';', '%'])) {
        let words: Words = line
            .split(' ')
            .filter_map(|word| Some((word.chars().next()?, word.get(1..)?.parse().ok()?)))
            .filter(|word| "GXYZIJKFD".contains(word.0))
            .collect();
        let is = |wanted: f64| words.contains(&('G', wanted));
        if is(4.0) {
            continue;
        }
        let sides = |words: &Words| -> Words {
            words.iter().filter(|word| matches!(word, ('G', 40.0..=42.0) | ('D', _))).copied().collect()
        };
        let moving: Words = words.iter().filter(|word| "XYZIJK".contains(word.0)).copied().collect();
        if moving.is_empty() {
            // The modes of the head are no end of a compensation.
            waits = if is(17.0) { Words::new() } else { sides(&words) };
            continue;
        }
        let motion = words.iter().filter(|word| matches!(word, ('G', 0.0..=3.0))).copied();
        let mut all: Words = std::mem::take(&mut waits);
        all.extend(sides(&words));
        all.extend(motion);
        // What stands still may be left out or not.
        for (letter, value) in moving {
            match "XYZ".find(letter) {
                Some(axis) if at[axis] == value => {}
                Some(axis) => {
                    at[axis] = value;
                    all.push((letter, value));
                }
                None => all.push((letter, value)),
            }
        }
        all.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        found.push(all);
    }
    found
}

/// The same but for the last place, in which the centre of a printed arc may be another when it is read.
fn near(one: &[Words], other: &[Words]) -> bool {
    let same = |a: &(char, f64), b: &(char, f64)| a.0 == b.0 && (a.1 - b.1).abs() < 0.0011;
    let all = |a: &Words, b: &Words| a.len() == b.len() && a.iter().zip(b).all(|(a, b)| same(a, b));
    one.len() == other.len() && one.iter().zip(other).all(|(one, other)| all(one, other))
}

fn arcs(moves: &[Words]) -> usize {
    moves.iter().filter(|words| words.iter().any(|word| matches!(word, ('G', 2.0..=3.0)))).count()
}

fn print(case: &Case, name: &str) -> Compiled {
    let mut settings = case.settings();
    settings.output.decimals = Decimals { length: Some(3), feed: Some(3), ..Decimals::default() };
    settings.output.tool_length = (name != "sinumerik").then_some(false);
    settings.output.comments = false;
    settings.output.dwell_unit = Some(target::DwellUnit::Seconds);
    settings.output.target = target::find(name).expect("a target");
    compiled("PART", case.program.clone(), &case.dialect, &settings, case)
}

/// What our own front end makes of a program for a SINUMERIK.
fn read_again(case: &Case, text: &str) -> Compiled {
    let mut again: Settings = settings("[control]\ntool_change = \"m6\"\n[output]\ncompensation = \"control\"");
    again.tools = case.settings().tools;
    again.output.decimals = Decimals { length: Some(3), feed: Some(3), ..Decimals::default() };
    compiled("AGAIN.MPF", text.as_bytes().to_vec(), "sinumerik", &again, case)
}

#[test]
fn golden_contours_are_compensated_alike_on_every_target() {
    let list: Vec<&Case> = cases("")
        .into_iter()
        .filter(|case| !case.name.starts_with("errors/"))
        .filter(|case| case.settings().output.compensation == Compensation::Control)
        .collect();
    let mut wrong = Vec::new();
    for (name, least, with_number) in TARGETS {
        let (mut printed, mut refused) = (0, BTreeMap::<&str, usize>::new());
        for case in &list {
            let plain = print(case, "linuxcnc");
            if plain.has_errors() {
                continue;
            }
            let mut meant = moves(&plain.output);
            let other = print(case, name);
            if other.has_errors() {
                let code = other.findings.iter().map(|found| found.code.id).find(|code| code.starts_with('O'));
                match code.filter(|code| code.starts_with("O9")) {
                    Some(code) => *refused.entry(code).or_default() += 1,
                    None => wrong.push(format!("{name} {}: {:?}", case.name, other.rendered)),
                }
                continue;
            }
            let mut found = moves(&other.output);
            if arcs(&found) != arcs(&meant) {
                *refused.entry("arcs in parts").or_default() += 1;
                continue;
            }
            if !with_number {
                meant.iter_mut().chain(&mut found).for_each(|words| words.retain(|word| word.0 != 'D'));
            }
            if found != meant {
                wrong.push(format!("{name} {}:\n{}\n{}", case.name, other.output, plain.output));
                continue;
            }
            if name == "sinumerik" {
                let again = read_again(case, &other.output);
                if again.has_errors() || !near(&moves(&again.output), &moves(&plain.output)) {
                    wrong.push(format!("{name} {}: read again: {:?}\n{}", case.name, again.rendered, again.output));
                }
            }
            printed += 1;
        }
        println!("{name}: printed {printed}, refused {refused:?}");
        assert!(printed >= least || !wrong.is_empty(), "{name}: {printed} printed, {refused:?} refused");
    }
    assert!(wrong.is_empty(), "{} wrong, such as\n{}", wrong.len(), wrong.iter().take(4).cloned().collect::<String>());
}

/// A SINUMERIK program on a target that compensates.
fn on(name: &str, body: &str, more: &str) -> Compiled {
    let tools = "[tools.1]\nradius = 5.0\n";
    let text = format!("[control]\ntool_change = \"m6\"\n[output]\ncompensation = \"control\"\n{more}\n{tools}");
    let mut settings = settings(&text);
    settings.output.target = target::find(name).expect("a target");
    let program = format!("G17 T1 M6 D1\nS1000 M3\nG0 X-20 Y-20 Z5\nG1 Z-2 F100\n{body}\nG0 Z50\nM30\n");
    compile_bytes("PART.MPF", program.into_bytes(), "sinumerik", &settings, &NoFiles)
}

const CONTOUR: &str = "G41 X0 Y0 F200\nY30\nG2 X10 Y40 I10 J0\nG1 X40\nG40 X60 Y60";

/// The lines from the spindle on.
fn cut(compiled: &Compiled) -> String {
    assert!(!compiled.has_errors(), "{:#?}", compiled.rendered);
    compiled.output.lines().skip_while(|line| !line.starts_with('M')).skip(1).collect::<Vec<_>>().join("\n")
}

#[test]
fn the_words_stand_in_the_move() {
    let fanuc = "G0 G43 X-20. Y-20. Z5. H1\nG1 Z-2. F100.\nG1 G41 D1 X0. Y0. F200.\nG1 Y30.\nG2 X10. Y40. I10. J0.\n\
        G1 X40.\nG1 G40 X60. Y60.\nG0 Z50.\nM30\n%";
    assert_eq!(cut(&on("fanuc", CONTOUR, "")), fanuc);
    assert_eq!(cut(&on("haas", CONTOUR, "")), fanuc);
    let sinumerik = on("sinumerik", CONTOUR, "");
    assert!(sinumerik.output.contains("T1 M6\nD1\n"), "{}", sinumerik.output);
    assert_eq!(
        cut(&sinumerik),
        "G0 X-20 Y-20 Z5\nG1 Z-2 F100\nG1 G41 X0 Y0 F200\nG1 Y30\nG2 X10 Y40 I10 J0\nG1 X40\nG1 G40 X60 Y60\nG0 Z50\nM30"
    );
}

#[test]
fn what_the_target_would_not_take_is_refused() {
    let code = |compiled: &Compiled| {
        compiled
            .findings
            .iter()
            .find(|found| found.severity == partc::internals::diag::Severity::Error)
            .map_or("", |found| found.code.id)
    };
    // Two blocks that move nothing in the plane; one is looked over.
    let idle = |blocks: &str| CONTOUR.replace("\nY30", &format!("\n{blocks}\nY30"));
    for name in ["fanuc", "sinumerik"] {
        assert_eq!(code(&on(name, &idle("M8"), "")), "", "{name}");
        assert_eq!(code(&on(name, &idle("M8\nM9"), "")), "O9003", "{name}");
        assert_eq!(code(&on(name, &idle("Z-3\nM9"), "")), "O9003", "{name}");
        assert_eq!(code(&on(name, &idle("Z-3\nZ-4"), "")), "O9003", "{name}");
        // It would end in a block without a move.
        assert_eq!(code(&on(name, "G41 X0 Y0\nY30\nM30", "")), "O9003", "{name}");
        // Other planes are not confirmed.
        let other = "G18 G41 X0 Z5\nX30\nG40 X60 Z50\nG17";
        assert_eq!(code(&on(name, other, "tool_length = \"off\"")), "O9003", "{name}");
    }
    assert_eq!(code(&on("linuxcnc", &idle("M8\nM9"), "")), "");
    for (name, _, numbered) in TARGETS.into_iter().chain([("linuxcnc", 0, false)]) {
        // As where partc computes the path (G3204).
        let more = "dwell_unit = \"seconds\"";
        assert_eq!(code(&on(name, "G41 X0 Y0\nG40 X60 Y60", more)), "O9003", "{name}");
        // Those that have D beside G41 do not read on beyond a stop.
        for stop in ["M0", "M1"] {
            assert_eq!(code(&on(name, &idle(stop), more)), if numbered { "O9003" } else { "" }, "{name} {stop}");
            assert_eq!(code(&on(name, &format!("{CONTOUR}\n{stop}"), more)), "", "{name} {stop}");
        }
    }
    // Without D1 nothing selects the radius.
    assert_eq!(code(&on("sinumerik", CONTOUR, "tool_length = \"off\"")), "O9308");
    assert_eq!(code(&on("fanuc", CONTOUR, "tool_length = \"off\"")), "");
    for name in ["grbl", "grblhal", "uccnc", "heidenhain"] {
        let more = if name.starts_with("grbl") { "tool_change = \"stop\"" } else { "" };
        assert_eq!(code(&on(name, CONTOUR, more)), "O9308", "{name}");
    }
}

/// A departure whose way in the plane is as long as the radius ends beside the contour, and rounding takes a part of it.
#[test]
fn a_departure_as_long_as_the_radius_is_printed_in_both_units() {
    let mut seen = 0;
    for (name, ..) in TARGETS.into_iter().chain([("linuxcnc", 0, true)]) {
        for (units, inches) in [("mm", false), ("inch", true)] {
            for radius in ["3.0", "3.175", "4.7625", "5.0", "6.35"] {
                for departure in [
                    format!("DEP LT LEN{radius}"),
                    format!("DEP LN LEN+{radius}"),
                    format!("DEP CT CCA90 R{radius}"),
                    format!("DEP CT CCA180 R{radius}"),
                    format!("DEP LCT X+72 Y-9.1 R+{radius}"),
                ] {
                    let mut settings = settings(&format!(
                        "[tools.1]\nradius = {radius}\n[output]\ncompensation = \"control\"\nunits = \"{units}\"\ndwell_unit = \"seconds\""
                    ));
                    settings.output.target = target::find(name).expect("a target");
                    if inches && settings.output.target.frame.inch_head.is_none() {
                        continue;
                    }
                    let text = format!(
                        "BEGIN PGM PART MM\nTOOL CALL 1 Z S2000\nL X-20.3 Y-31.7 Z+5 R0 FMAX M3\nL X+0.123 Y+0.457 RL F300\n\
                         L X+33.333 Y+20.711\nL X+61.87 Y+3.3\n{departure}\nL Z+50 R0 FMAX\nEND PGM PART MM\n"
                    );
                    let compiled = compile_bytes("PART.H", text.into_bytes(), "klartext", &settings, &NoFiles);
                    let short = compiled.findings.iter().any(|found| found.code.id == "O9100");
                    assert!(!short, "{name} {units} {departure}: {:?}", compiled.rendered);
                    seen += usize::from(!compiled.has_errors());
                }
            }
        }
    }
    assert!(seen > 100, "{seen} departures are printed");
}
