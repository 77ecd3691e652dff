//! No parameter of a Klartext cycle is ignored: another value prints something else or is spoken of, and one that has to be
//! there is missed. The parameters are those of the table that the compiler reads them by.

use partc::internals::dialect;
use partc::internals::sema::cycle::row::{Kind, Name, Parameter, Signature, Status};
use partc::internals::target;
use partc::internals::text::files::NoFiles;

use super::common::{compile_bytes, settings};

/// A Q parameter, a value, and another one that makes a difference.
const VALUES: &[(u32, f64, f64)] = &[
    (1, -20.0, -21.0),
    (2, 1.0, 0.5),
    (3, 0.5, 0.6),
    (4, 0.3, 0.4),
    (5, 0.0, 1.0),
    (6, 2.0, 3.0),
    (7, 50.0, 60.0),
    (8, 0.0, 1.0),
    (9, 1.0, -1.0),
    (10, 5.0, 6.0),
    (11, 150.0, 160.0),
    (12, 500.0, 510.0),
    (13, 1.0, 2.0),
    (14, 0.0, 0.1),
    (15, 1.0, 0.0),
    (18, 0.0, 1.0),
    (19, 0.0, 150.0),
    (390, 1.0, 2.0),
    (391, 1.0, 2.0),
    (392, 4.0, 5.0),
    (393, 90.0, 60.0),
    (394, 5.0, 6.0),
    (404, 0.0, 1.0),
    (446, 0.01, 0.02),
    (447, 10.0, 11.0),
    (448, 2.0, 3.0),
    (200, 2.0, 3.0),
    (201, -20.0, -21.0),
    (202, 5.0, 6.0),
    (203, 0.0, 1.0),
    (204, 50.0, 60.0),
    (205, 2.0, 3.5),
    (206, 150.0, 160.0),
    (207, 500.0, 510.0),
    (208, 300.0, 310.0),
    (210, 0.0, 1.0),
    (211, 0.0, 1.0),
    (212, 1.0, 2.0),
    (213, 1.0, 0.0),
    (214, 1.0, 2.0),
    (215, 0.0, 1.0),
    (216, 50.0, 51.0),
    (217, 40.0, 41.0),
    (218, 80.0, 81.0),
    (219, 30.0, 31.0),
    (220, 10.0, 11.0),
    (223, 60.0, 61.0),
    (224, 15.0, 16.0),
    (225, 10.0, 11.0),
    (226, 20.0, 21.0),
    (237, 10.0, 11.0),
    (238, 12.0, 13.0),
    (239, 1.0, -1.0),
    (241, 4.0, 5.0),
    (242, 3.0, 2.0),
    (243, 2.0, 3.0),
    (244, 80.0, 81.0),
    (245, 0.0, 10.0),
    (246, 270.0, 180.0),
    (247, 0.0, 30.0),
    (248, 60.0, 61.0),
    (253, 700.0, 710.0),
    (254, 200.0, 210.0),
    (256, 0.5, 0.6),
    (257, 3.0, 2.0),
    (258, 0.5, 0.7),
    (259, 1.0, 1.2),
    (301, 1.0, 0.0),
    (334, 3.0, 4.0),
    (335, 20.0, 21.0),
    (336, 0.0, 45.0),
    (338, 0.0, 4.0),
    (342, 4.0, 5.0),
    (343, 1.0, 0.0),
    (344, -8.0, -9.0),
    (351, 1.0, -1.0),
    (355, 1.0, 0.0),
    (356, -25.0, -26.0),
    (357, 0.2, 0.3),
    (358, -1.0, -2.0),
    (359, 3.0, 4.0),
    (360, 0.0, 1.0),
    (365, 0.0, 1.0),
    (366, 0.0, 1.0),
    (367, 0.0, 2.0),
    (368, 0.5, 0.6),
    (369, 0.3, 0.4),
    (370, 1.0, 0.5),
    (374, 15.0, 16.0),
    (375, 80.0, 81.0),
    (376, 20.0, 25.0),
    (377, 2.0, 3.0),
    (378, 90.0, 100.0),
    (379, 1.0, 2.0),
    (385, 400.0, 410.0),
    (395, 0.0, 1.0),
    (401, 100.0, 50.0),
    (403, 1.0, 2.0),
    (426, 3.0, 4.0),
    (427, 25.0, 30.0),
    (428, 500.0, 600.0),
    (429, 8.0, 7.0),
    (430, 9.0, 0.0),
    (435, 0.0, 1.0),
    (439, 0.0, 1.0),
    (209, 600.0, 610.0),
    (222, 80.0, 82.0),
    (227, 5.0, 6.0),
    (240, 4.0, 5.0),
    (386, -6.0, -7.0),
    (389, 0.0, 2.0),
    (424, 90.0, 95.0),
    (425, 60.0, 65.0),
    (437, 0.0, 1.0),
    (512, 300.0, 310.0),
    (571, 50.0, 52.0),
    (572, 6.0, 8.0),
    (573, 0.0, 1.0),
    (221, 0.5, 1.5),
    (228, 100.0, 101.0),
    (229, 20.0, 21.0),
    (230, 6.0, 7.0),
    (231, 100.0, 101.0),
    (232, 60.0, 61.0),
    (233, 4.0, 5.0),
    (234, 10.0, 11.0),
    (235, 60.0, 61.0),
    (236, 3.0, 4.0),
    (347, 0.0, 1.0),
    (348, 0.0, 1.0),
    (349, 0.0, 1.0),
    (350, 0.0, 1.0),
];

/// A cycle, a Q parameter, and the values that it has there.
const OWN: &[(u32, u32, f64, f64)] = &[
    (208, 342, 4.0, 30.0),
    (208, 370, 1.0, 0.5),
    (241, 202, 30.0, 10.0),
    (212, 221, 0.5, 6.0),
    (214, 222, 50.0, 20.0),
    (21, 13, 1.0, 9.0),
    (22, 208, 99999.0, 300.0),
    (23, 208, 99999.0, 300.0),
    (258, 220, 0.0, 1.0),
];

/// A cycle, the parameter under test, and another one with the value that makes it count.
const WITH: &[(u32, u32, u32, f64)] = &[(240, 201, 343, 0.0), (270, 394, 390, 2.0)];

/// The parts of the old cycles, by their kinds: a value and another one.
const PARTS: &[(u32, u32, f64, f64)] = &[
    (1, 1, 2.0, 3.0),
    (1, 2, -15.0, -16.0),
    (1, 3, 10.0, 5.0),
    (1, 4, 0.0, 1.0),
    (1, 5, 80.0, 90.0),
    (2, 1, 2.0, 3.0),
    (2, 2, -15.0, -16.0),
    (2, 3, 0.0, 1.0),
    (2, 4, 80.0, 90.0),
    (17, 1, 2.0, 3.0),
    (17, 2, -15.0, -16.0),
    (17, 3, 1.5, -1.5),
    (3, 1, 2.0, 3.0),
    (3, 2, -15.0, -16.0),
    (3, 3, 10.0, 5.0),
    (4, 1, 2.0, 3.0),
    (4, 2, -15.0, -16.0),
    (4, 3, 10.0, 5.0),
    (5, 1, 2.0, 3.0),
    (5, 2, -15.0, -16.0),
    (5, 3, 10.0, 5.0),
    (5, 4, 35.0, 36.0),
];

/// Words in the parts of the old cycles: a value and another one.
const WORDS: &[(u32, u32, &str, f64, f64)] = &[
    (3, 3, "F", 80.0, 90.0),
    (3, 4, "X", 80.0, -80.0),
    (3, 5, "Y", 12.0, 13.0),
    (3, 6, "F", 100.0, 110.0),
    (4, 3, "F", 80.0, 90.0),
    (4, 4, "X", 80.0, 81.0),
    (4, 5, "Y", 40.0, 41.0),
    (4, 6, "F", 100.0, 110.0),
    (4, 6, "DR", 1.0, -1.0),
    (4, 6, "RADIUS", 10.0, 11.0),
    (5, 3, "F", 80.0, 90.0),
    (5, 5, "F", 100.0, 110.0),
    (5, 5, "DR", 1.0, -1.0),
];

/// Machining cycles and patterns that are compiled, by number.
fn cycles() -> Vec<(u32, &'static Signature)> {
    let all = dialect::find("klartext").map(|dialect| (dialect.cycles)()).unwrap_or_default();
    let numbered = all.into_iter().filter(|cycle| cycle.status == Status::Built).filter_map(|cycle| {
        let number = cycle.name.strip_prefix("CYCL DEF ")?.parse().ok()?;
        Some((number, cycle))
    });
    numbered.filter(|(number, _)| matches!(number, 1..=5 | 17 | 20..=25 | 200..=246 | 248..=270)).collect()
}

/// The value of a parameter: `Other` for the one under test.
#[derive(Clone, Copy, PartialEq)]
enum Given {
    Plain,
    Other,
    Nothing,
}

fn value(number: u32, parameter: &Parameter, given: Given) -> Option<f64> {
    let (plain, other) = match parameter.name {
        Name::Q(q) => {
            let own = OWN.iter().find(|(of, known, ..)| (*of, *known) == (number, q)).map(|(.., a, b)| (*a, *b));
            own.or_else(|| VALUES.iter().find(|(known, ..)| *known == q).map(|(_, a, b)| (*a, *b)))
        }
        Name::Part(part) => {
            PARTS.iter().find(|(of, known, ..)| (*of, *known) == (number, part)).map(|(.., a, b)| (*a, *b))
        }
        Name::In(part, word) => WORDS
            .iter()
            .find(|(of, known, name, ..)| (*of, *known, *name) == (number, part, word))
            .map(|(.., a, b)| (*a, *b)),
        Name::Word(_) => None,
    }
    .unwrap_or_else(|| panic!("{number} {} has no value", parameter.name));
    match given {
        Given::Plain => Some(plain),
        Given::Other => Some(other),
        Given::Nothing => None,
    }
}

/// The definition with one of its parameters otherwise.
fn definition(number: u32, cycle: &Signature, at: usize, given: Given) -> String {
    let mut shown = format!("CYCL DEF {number}{}", if number < 20 { ".0 NAME" } else { " NAME" });
    let mut last = 0;
    for (place, parameter) in cycle.parameters.iter().enumerate() {
        let Some(value) = value(number, parameter, if place == at { given } else { Given::Plain }) else { continue };
        let under = cycle.parameters.get(at).map(|parameter| parameter.name);
        let with = WITH
            .iter()
            .find(|(of, tested, other, _)| {
                *of == number && under == Some(Name::Q(*tested)) && parameter.name == Name::Q(*other)
            })
            .map(|(.., value)| *value);
        let value = with.unwrap_or(value);
        match parameter.name {
            Name::Part(part) | Name::In(part, _) => {
                if part != last {
                    shown += &format!("\nCYCL DEF {number}.{part}");
                    last = part;
                }
                shown += &match parameter.name {
                    Name::In(_, "DR") => format!(" DR{}", if value > 0.0 { '+' } else { '-' }),
                    Name::In(_, "RADIUS") => format!(" RADIUS {value}"),
                    Name::In(_, word) => format!(" {word}{value}"),
                    _ if matches!(parameter.kind, Kind::Feed) => format!(" F{value}"),
                    _ => format!(" VALUE {value:+}"),
                };
            }
            name => shown += &format!(" ~\n {name}={value:+}"),
        }
    }
    shown + "\n"
}

/// A drill of 12 mm, or a cutter.
const TOOL: &str = "[tools.1]\nradius = 6.0\nplunge_angle = 4.0\ntip_angle = 118.0\n[cycles]\nthread_267 = \"core\"\nmulti_edge_start = \"corner\"\n[tools.2]\nradius = 7.0\n";

/// The definition among those of a pocket or a contour train.
fn around_contour(number: u32, definition: &str) -> String {
    let of = |other: u32| {
        let found = cycles().into_iter().find(|(number, _)| *number == other).expect("a cycle along a contour");
        self::definition(other, found.1, usize::MAX, Given::Plain)
    };
    let label = if matches!(number, 25 | 270) { 2 } else { 1 };
    let contour = format!("CYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 CONTOUR LABEL {label}\n");
    match number {
        25 => contour + &of(270) + definition + "CYCL CALL\n",
        270 => contour + definition + &of(25) + "CYCL CALL\n",
        20 => contour + definition + &of(22) + "CYCL CALL\n",
        24 => contour + &of(20) + &of(22) + "CYCL CALL\n" + definition + "CYCL CALL\n",
        _ => contour + &of(20) + definition + "CYCL CALL\n",
    }
}

/// What is printed and what is said.
fn run(number: u32, cycle: &Signature, at: usize, given: Given) -> (Vec<String>, Vec<String>) {
    let mut program = "BEGIN PGM T MM\nTOOL CALL 1 Z S1000 F200\nL X+0 Y+0 Z+40 R0 FMAX M3\n".to_owned();
    if (20..=25).contains(&number) || number == 270 {
        program += &around_contour(number, &definition(number, cycle, at, given));
    } else if (220..=229).contains(&number) {
        let drilling = cycles().into_iter().find(|(number, _)| *number == 200).expect("cycle 200");
        program += &definition(200, drilling.1, usize::MAX, Given::Plain);
        program += &definition(number, cycle, at, given);
    } else {
        program += &definition(number, cycle, at, given);
        program += "CYCL CALL\n";
    }
    program += "L X+9 Y+9 M30\nLBL 1\nL X-40 Y-30 RL\nL X+40\nL Y+30\nL X-40\nL Y-30\nLBL 0\nLBL 2\nL X-40 Y-30 RL\nL X+40\nLBL 0\nEND PGM T MM\n";
    let mut settings = settings(TOOL);
    if number == 209 {
        // The tap of LinuxCNC comes out of the hole at each step: these blocks say how far back it goes.
        settings.output.target = target::find("sinumerik").expect("a target");
    }
    let compiled = compile_bytes("T.H", program.into_bytes(), "klartext", &settings, &NoFiles);
    let moves = compiled.output.lines().filter(|line| !line.starts_with('(')).map(str::to_owned).collect();
    (moves, compiled.findings.iter().map(|found| format!("{} {}", found.code.id, found.text())).collect())
}

#[test]
fn no_parameter_is_ignored() {
    assert!(cycles().len() >= 13, "{:?}", cycles());
    let mut bad = Vec::new();
    for (number, cycle) in cycles() {
        let plain = run(number, cycle, usize::MAX, Given::Plain);
        if plain.1.iter().any(|said| {
            said.starts_with("K9") || said.starts_with("K24") && !said.contains("K2409") && !said.contains("K2408")
        }) {
            bad.push(format!("cycle {number}: {:?}", plain.1));
        }
        for (at, parameter) in cycle.parameters.iter().enumerate() {
            let what = format!("cycle {number} {}", parameter.name);
            if (run(number, cycle, at, Given::Other) == plain) != parameter.without_effect.is_some() {
                bad.push(format!("{what}: another value, and without effect: {:?}", parameter.without_effect));
            }
            let missed = run(number, cycle, at, Given::Nothing).1.iter().any(|said| said.starts_with("K2402"));
            if missed != (parameter.needed) {
                bad.push(format!("{what}: {:?}, and it is missed: {missed}", parameter.rule));
            }
        }
    }
    assert!(bad.is_empty(), "{bad:#?}");
}

/// Lengths of programs in inches are messages in mm without what arithmetic adds: every program of the books, read in inches.
#[test]
fn messages_of_inch_programs_have_no_lost_decimals() {
    let mut told = 0;
    for case in super::book::cases("klartext/machining").into_iter().chain(super::book::cases("errors/klartext")) {
        let Some(text) = case.text() else { continue };
        let inch: String = text
            .lines()
            .map(|line| match line.trim_end().strip_suffix(" MM") {
                Some(head) if line.contains(" PGM ") => format!("{head} INCH\n"),
                _ => format!("{line}\n"),
            })
            .collect();
        for found in &case.compile_instead(&inch).findings {
            let message = format!("{} {}", found.message, found.help.as_deref().unwrap_or_default());
            let decimals = message.split(|c: char| !c.is_ascii_digit() && c != '.').filter_map(|n| n.split_once('.'));
            let most = decimals.map(|(_, decimals)| decimals.len()).max().unwrap_or(0);
            assert!(most <= 9, "{}: {message}", case.name);
            told += 1;
        }
    }
    assert!(told > 300, "{told} messages");
}
