//! No word goes in silence: in every golden program each number in turn takes other values, and what is printed or what is
//! found has to change.

use super::book::{Case, cases};
use super::common::{Compiled, compile_bytes, settings};
use partc::internals::sema::cycle::row::Kind;

/// Letters whose number is a name, not a value.
const NAMES: &[&str] = &["N", "G", "M", "T", "NS", "NE", "L"];

/// Words that may have another value without any effect, as program, word and reason.
const WITHOUT_EFFECT: &[(&str, &str, &str)] = &[
    ("oversize_of_the_cycle", "X2", "I of the cycle takes the place of G57, as a note says"),
    ("oversize_of_the_cycle", "Z3", "I of the cycle takes the place of G57, as a note says"),
    ("oversize_replaced", "P3", "G57 takes the place of G58, as a note says"),
    ("if_else", "Z-1", "a branch that does not run"),
    ("if_else", "Z-4", "a branch that does not run"),
    ("nested", "Z-1", "a branch that does not run"),
    ("nested", "Z-2", "a branch that does not run"),
    ("nested", "Z-3", "a branch that does not run"),
    ("switch", "Z-1", "a branch that does not run"),
    ("switch", "Z-9", "a branch that does not run"),
    ("switch", "Z-3", "a branch that does not run"),
    ("switch_default", "Z-1", "a branch that does not run"),
    ("switch_default", "Z-5", "a branch that does not run"),
    ("din_plus_english", "H1", "a chuck"),
    ("din_plus_english", "D80", "a chuck"),
    ("din_plus_german", "H1", "a chuck"),
    ("din_plus_german", "D80", "a chuck"),
    ("din_plus_german", "P-5", "a contour for the C axis"),
    ("blank_corner_axial", "Z0", "ZA says where the blank begins"),
    ("words_axial", "ZS0", "the tool finishes from above the rim on"),
    ("words_of_g80", "ZS0", "the tool stands in front of the start"),
    ("unit_with_direct_contour", "RB0", "Q1: nothing is finished"),
    ("arc_of_a_drawing_4110", "Z0", "the tool stands in front of the start"),
    ("single_cut_ramps", "B2", "T8017 says so"),
    ("single_cut_ramps", "P1", "T8017 says so"),
    ("single_cut_ramps", "I1", "T8017 says so"),
    ("single_cut_ramps", "K1", "T8017 says so"),
    ("incremental_after_shift", "Z-10", "the shift is undone by the increment"),
    ("start_at_the_face", "X0", "the tool stands in front of the start"),
    ("undercut_left_out", "E0", "nothing falls but what leans over"),
    ("words_of_g80", "E0", "nothing falls"),
    ("words_of_g80_angles", "E0", "nothing falls"),
    ("words_of_g80_transverse", "E0", "nothing falls"),
];

/// Describes shape: elements that no cycle names count for nothing.
const SHAPE: &[&str] = &["X", "Z", "B", "K"];

/// Where a number of a block stands, and its address.
fn numbers(text: &str) -> Vec<(usize, usize, String)> {
    let bytes = text.as_bytes();
    let (mut list, mut at, mut comment, mut quoted) = (Vec::new(), 0, false, false);
    while at < bytes.len() {
        let byte = bytes[at];
        comment = (comment || byte == b'[') && byte != b']' && byte != b'\n';
        quoted = byte != b'\n' && (quoted != (byte == b'"'));
        let first = at == 0 || bytes[at - 1] == b'\n';
        if first && matches!(byte, b'%' | b'#' | b'/') {
            while at < bytes.len() && bytes[at] != b'\n' {
                at += 1;
            }
            continue;
        }
        if comment || quoted || !byte.is_ascii_alphabetic() {
            at += 1;
            continue;
        }
        let start = at;
        while at < bytes.len() && bytes[at].is_ascii_alphabetic() {
            at += 1;
        }
        let from = at;
        while at < bytes.len() && (bytes[at].is_ascii_digit() || matches!(bytes[at], b'.' | b'-')) {
            at += 1;
        }
        if at > from {
            list.push((from, at, text[start..from].to_ascii_uppercase()));
        }
    }
    list
}

/// What the machine gets, and what the user is told.
fn outcome(compiled: &Compiled) -> (Vec<String>, Vec<&'static str>) {
    let moves = compiled.output.lines().filter(|line| !line.starts_with('(')).map(str::to_owned).collect();
    (moves, compiled.codes())
}

fn check(case: &Case, ignored: &mut Vec<String>) {
    let Some(text) = case.text() else { return };
    let (name, options) = (case.stem(), case.settings());
    let compile = |text: &str| compile_bytes("A.nc", text.as_bytes().to_vec(), "heidenhain-turning", &options, case);
    let plain = compile(text);
    if plain.has_errors() {
        return;
    }
    let before = outcome(&plain);
    let machining = ["MACHINING", "BEARBEITUNG"].iter().find_map(|word| text.find(word)).unwrap_or(0);
    for (from, to, address) in numbers(text) {
        if NAMES.contains(&address.as_str()) || from < machining && SHAPE.contains(&address.as_str()) {
            continue;
        }
        let Ok(value) = text[from..to].parse::<f64>() else { continue };
        // Small steps and large ones, the switches 0 and 1, another sign.
        let others = [value + 0.37, value + 1.0, 0.0, 1.0, -value, value * 3.0, value / 3.0];
        let changes = others.iter().filter(|other| **other != value).any(|other| {
            let changed = format!("{}{other}{}", &text[..from], &text[to..]);
            outcome(&compile(&changed)) != before
        });
        let word = format!("{address}{}", &text[from..to]);
        let known = WITHOUT_EFFECT.iter().any(|(program, w, _)| *program == name && *w == word);
        if changes == known {
            let line = text[..from].lines().count();
            ignored.push(format!("{name}:{line}: {word} {}", if known { "has an effect" } else { "changes nothing" }));
        }
    }
}

#[test]
fn every_number_of_every_golden_program_counts() {
    let mut ignored = Vec::new();
    for case in cases("heidenhain-turning") {
        check(case, &mut ignored);
    }
    assert!(ignored.is_empty(), "{}", ignored.join("\n"));
}

/// A program in which `BLOCK` is replaced by a block, and the options for it.
struct Base {
    /// G functions that the table of functions lists, with a block that compiles.
    blocks: &'static [(u16, &'static str)],
    program: &'static str,
    options: &'static str,
}

const TURNING_TOOL: &str = "[tools.1]\nkind = \"turn\"\nradius = 0.4\norientation = 3\n";
const RECESSING_TOOL: &str =
    "[control]\nrecess_side = \"plus\"\n[tools.1]\nkind = \"recess-radial\"\nwidth = 3.0\nradius = 0.2\n";

const BASES: &[Base] = &[
    Base {
        blocks: &[
            (0, "G0 X70 Z-5"),
            (1, "G1 X70 Z-20"),
            (2, "G2 X80 Z-5 R20"),
            (3, "G3 X80 Z-5 R20"),
            (12, "G12 X80 Z-5 R20"),
            (13, "G13 X80 Z-5 R20"),
            (4, "G4 F1"),
            (26, "G26 S300"),
            (33, "G33 X60 Z-20 F1.5"),
            (47, "G47 P2"),
            (51, "G51 Z-10"),
            (56, "G56 Z-10"),
            (57, "G57 X0.5"),
            (71, "G71 Z-20"),
            (74, "G74 Z-20 P5"),
            (81, "G81 X50 Z-20 I3"),
            (82, "G82 X50 Z-20 K3"),
            (85, "G85 X50 Z-20"),
            (94, "G94 F100"),
            (95, "G95 F0.3"),
            (96, "G96 S150"),
            (97, "G97 S700"),
        ],
        program: "%1.nc\nN1 T1 G95 F0.2 G97 S800 M3\nN2 G0 X60 Z5\nN3 BLOCK\nN4 G1 X70 Z-22 B1\nN5 G1 X90\nN6 G0 X60 Z5\n\
                  N7 G817 P3\nN8 G0 X30 Z5\nN9 G1 Z-20\nN10 G1 X50\nN11 G80\nEND\n",
        options: "[tools.1]\nkind = \"turn\"\nradius = 0.4\norientation = 3\n[output]\n",
    },
    Base {
        blocks: &[(36, "G36 Z-20 F1"), (71, "G71 Z-20 E1"), (74, "G74 Z-20 P5 E1")],
        program: "%1.nc\nN1 T1 G95 F0.2 G97 S800 M3\nN2 G0 X0 Z5\nN3 BLOCK\nN4 G0 Z10\nEND\n",
        options: "",
    },
    Base {
        blocks: &[
            (31, "G31 X20 Z-20 F1.5 U-0.92 I0.3 B3 P1"),
            (32, "G32 X20 Z-20 F1.5 P0.92 I0.3"),
            (33, "G33 X20 Z-20 F1.5"),
        ],
        program: "%1.nc\nN1 T1 G97 S800 M3\nN2 G0 X26 Z5\nN3 BLOCK\nEND\n",
        options: "",
    },
    Base {
        blocks: &[(817, "G817 P3 H1"), (818, "G818 P3 H1"), (819, "G819 P3 H1 E0"), (89, "G89")],
        program: "%1.nc\nN1 T1 G95 F0.2 G97 S800 M3\nN2 G0 X52 Z2\nN3 BLOCK\nN4 G0 X30 Z2\nN5 G1 Z-20\nN6 G1 X40 Z-30\n\
                  N7 G1 X50\nN8 G80\nEND\n",
        options: TURNING_TOOL,
    },
    Base {
        blocks: &[(827, "G827 P3 H1"), (828, "G828 P3 H1"), (829, "G829 P3 H1 E0")],
        program: "%1.nc\nN1 T1 G95 F0.2 G97 S800 M3\nN2 G0 X52 Z2\nN3 BLOCK\nN4 G0 X50 Z-10\nN5 G1 X20\nN6 G1 Z0\nN7 G80\nEND\n",
        options: TURNING_TOOL,
    },
    Base {
        blocks: &[
            (810, "G810 NS12 NE14 P3"),
            (820, "G820 NS13 NE14 P3"),
            (890, "G890 NS12 NE14"),
            (31, "G31 NS13 F1.5 U-0.92 I0.3 B3 P1"),
        ],
        program: "HEADER\n#UNIT METRIC\nFINISHED PART\nN10 G0 X30 Z2\nN12 G1 Z-20 B0.5\nN13 G1 X40 Z-30\nN14 G1 X50 B-0.5\nN15 G1 Z-50\n\
                  MACHINING\nN1 T1 G95 F0.2 G97 S800 M3\nN2 G0 X56 Z6\nN3 BLOCK\nN4 G0 X60 Z6\nEND\n",
        options: TURNING_TOOL,
    },
    Base {
        blocks: &[(819, "G819 P3 H1")],
        program: "%1.nc\nN1 T1 G95 F0.2 G97 S800 M3\nN2 G0 X52 Z2\nN3 BLOCK\nN4 G0 X40 Z2\nN5 G1 Z-20\nN6 G1 X30 Z-25\n\
                  N7 G1 Z-35\nN8 G1 X50\nN9 G80\nEND\n",
        options: TURNING_TOOL,
    },
    Base {
        blocks: &[(829, "G829 P2 H0")],
        program: "%1.nc\nN1 T1 G95 F0.2 G97 S800 M3\nN2 G0 X62 Z4\nN3 BLOCK\nN4 G0 X62 Z-8\nN5 G1 X50\nN6 G1 Z-4\n\
                  N7 G1 X40 Z-7\nN8 G1 X30\nN9 G1 X20 Z0\nN10 G80\nEND\n",
        options: TURNING_TOOL,
    },
    Base {
        blocks: &[(810, "G810 NS12 NE15 P3 H1")],
        program: "HEADER\n#UNIT METRIC\nFINISHED PART\nN10 G0 X40 Z2\nN12 G1 Z-20\nN13 G1 X30 Z-25\nN14 G1 Z-35\nN15 G1 X50\n\
                  MACHINING\nN1 T1 G95 F0.2 G97 S800 M3\nN2 G0 X56 Z6\nN3 BLOCK\nN4 G0 X60 Z6\nEND\n",
        options: TURNING_TOOL,
    },
    Base {
        blocks: &[(820, "G820 NS11 NE15 P2 H0")],
        program: "HEADER\n#UNIT METRIC\nFINISHED PART\nN10 G0 X62 Z-8\nN11 G1 X50\nN12 G1 Z-4\nN13 G1 X40 Z-7\nN14 G1 X30\nN15 G1 X20 Z0\n\
                  MACHINING\nN1 T1 G95 F0.2 G97 S800 M3\nN2 G0 X62 Z4\nN3 BLOCK\nN4 G0 X60 Z6\nEND\n",
        options: TURNING_TOOL,
    },
    Base {
        blocks: &[(869, "G869 NS13 NE15 P2 Q0"), (869, "G869 NS13 NE15 P2 Q0 U1 I0.2 K0.1")],
        program: "HEADER\n#UNIT METRIC\nFINISHED PART\nN11 G0 X60 Z0\nN12 G1 Z-20 B-0.5\nN13 G1 X48\nN14 G1 Z-32\nN15 G1 X60 B0.4\nN16 G1 Z-50\n\
                  MACHINING\nN1 T1 G95 F0.2 G97 S800 M3\nN2 G0 X66 Z-23.1\nN3 BLOCK\nN4 G0 X70 Z6\nEND\n",
        options: RECESSING_TOOL,
    },
    Base {
        blocks: &[(80, "G80 XS60 ZS-20 XE48 ZE-32")],
        program: "HEADER\n#UNIT METRIC\nMACHINING\nN1 T1 G95 F0.2 G97 S800 M3\nN2 G0 X66 Z-23.1\nN3 G869 P2 Q0\nN4 BLOCK\nEND\n",
        options: RECESSING_TOOL,
    },
    Base {
        blocks: &[(86, "G86 X54 Z-30 E1")],
        program: "%1.nc\nN1 T1 G95 F0.2 G97 S800 M3\nN2 G0 X62 Z2\nN3 BLOCK\nEND\n",
        options: RECESSING_TOOL,
    },
    Base {
        blocks: &[(59, "G59 Z-10")],
        program: "%1.nc\nN1 T1 G95 F0.2 G97 S800 M3\nN3 BLOCK\nN2 G0 X60 Z5\nN4 G59 Z-30\nN5 G1 Z-5\nEND\n",
        options: "",
    },
    Base {
        blocks: &[(52, "G52"), (57, "G57 X0.5"), (58, "G58 P0.5")],
        program: "HEADER\n#UNIT METRIC\nFINISHED PART\nN10 G0 X30 Z2\nN12 G1 Z-20\nN13 G1 X40 Z-30\nN14 G1 X50\n\
                  MACHINING\nN1 T1 G95 F0.2 G97 S800 M3\nN2 G0 X56 Z6\nN3 BLOCK\nN4 G890 NS12 NE14\nEND\n",
        options: TURNING_TOOL,
    },
    Base {
        blocks: &[(14, "G14 Q0"), (701, "G701 X400 Z500")],
        program: "%1.nc\nN1 T1 G95 F0.2 G97 S800 M3\nN2 G0 X62 Z2\nN3 BLOCK\nEND\n",
        options: "[control]\ntool_change_point = { X = 300.0, Z = 400.0 }\n",
    },
];

/// Words of the functions and cycles, by number, as the tables of the compiler list them.
fn listed() -> Vec<(u16, Vec<String>)> {
    let table = include_str!("../../src/sema/turning/g_functions.rs");
    let mut list = Vec::new();
    for row in table.split("row(").skip(2) {
        let Some(number) = row.trim_start().split(',').next().and_then(|n| n.trim().parse().ok()) else { continue };
        let row = row.split(")").take_while(|part| !part.contains("refused(")).collect::<String>();
        let texts: Vec<&str> = row.split('"').skip(1).step_by(2).collect();
        let [_, letters, longs @ ..] = &texts[..] else { continue };
        let mut words: Vec<String> = letters.chars().map(String::from).collect();
        words.extend(longs.iter().map(|word| (*word).to_owned()));
        if row.contains("TRANSITIONS") {
            words.extend(["AN".to_owned(), "BR".to_owned()]);
        }
        list.push((number, words));
    }
    for cycle in (partc::internals::dialect::find("heidenhain-turning").expect("a dialect").cycles)() {
        let number = cycle.name.strip_prefix('G').and_then(|number| number.parse().ok()).expect("a G function");
        // ID names a contour.
        let words = cycle.parameters.iter().filter(|known| !matches!(known.kind, Kind::Text));
        list.push((number, words.map(|known| known.name.to_string()).collect()));
    }
    list
}

/// Does the word in the block, with another value or at all, change what comes of the program?
fn word_counts(base: &Base, block: &str, word: &str) -> bool {
    let options = settings(base.options);
    let run = |block: &str| {
        let text = base.program.replace("BLOCK", block).into_bytes();
        outcome(&compile_bytes("A.nc", text, "heidenhain-turning", &options, &partc::internals::text::files::NoFiles))
    };
    let before = run(block);
    assert!(!before.0.is_empty(), "{block}: {:?}", before.1);
    let of_word =
        |part: &&str| part.strip_prefix(word).is_some_and(|value| value.starts_with(|c: char| !c.is_alphabetic()));
    ["1", "0.37", "2", "13", "-1", "-6"].iter().any(|value| {
        let changed = match block.split(' ').find(of_word) {
            Some(old) => block.replacen(old, &format!("{word}{value}"), 1),
            None => format!("{block} {word}{value}"),
        };
        run(&changed) != before
    })
}

#[test]
fn every_word_of_every_function_changes_something_or_is_found() {
    let listed = listed();
    assert!(listed.len() > 40, "{} functions", listed.len());
    let mut silent = Vec::new();
    for (number, words) in &listed {
        let uses: Vec<(&Base, &str)> = BASES
            .iter()
            .flat_map(|base| base.blocks.iter().filter(|(n, _)| n == number).map(move |(_, block)| (base, *block)))
            .collect();
        if uses.is_empty() && !words.is_empty() {
            silent.push(format!("G{number} has no program"));
        }
        // NS and NE name elements, ID a contour.
        for word in words.iter().filter(|_| !uses.is_empty()) {
            if !uses.iter().any(|(base, block)| word_counts(base, block, word)) {
                silent.push(format!("{word} of G{number}"));
            }
        }
    }
    assert!(silent.is_empty(), "{}", silent.join("\n"));
}
