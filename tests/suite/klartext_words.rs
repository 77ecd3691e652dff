//! No word goes in silence: every M number, every FN number and every statement, each in a program of its own, changes
//! the output, or is noted, warned of or refused.

use partc::internals::machine::Settings;
use partc::internals::text::files::NoFiles;

use super::common::{compile_bytes, settings};

/// What came of a program: what was printed, and what was said.
fn outcome(blocks: &[&str], settings: &Settings) -> (Vec<String>, Vec<String>) {
    let text = format!("0 BEGIN PGM A MM\n{}\n999 END PGM A MM\n", blocks.join("\n"));
    let compiled = compile_bytes("A.H", text.into_bytes(), "klartext", settings, &NoFiles);
    // The first lines name the program and its hash.
    let printed = compiled.attempt.lines().skip(3).map(str::to_owned).collect();
    let said = compiled.findings.iter().map(|found| format!("{} {}", found.code.id, found.text())).collect();
    (printed, said)
}

/// Does nobody notice when `with` becomes `without`?
fn silent(with: &[&str], without: &[&str], settings: &Settings) -> bool {
    outcome(with, settings) == outcome(without, settings)
}

/// What an M function needs behind it.
fn arguments(number: u32) -> &'static str {
    match number {
        103 => " F20",
        112 => " T0.01 A10",
        120 => " LA5",
        124 => " T0.01",
        138 => " A",
        140 => " MB 5",
        197 => " DL1",
        _ => "",
    }
}

/// M functions that say nothing by themselves: blocks behind them that show that they act.
fn shown_by(number: u32) -> Option<&'static [&'static str]> {
    Some(match number {
        109 | 110 => &["L X+20 Y+0 RL F100", "L Y+20", "RND R5", "L X+0", "L X-20 R0"],
        116 => &["L C+90 F100"],
        126 => &["L C+0 FMAX", "L C+350 FMAX"],
        128 => &["L C+0 FMAX", "L C+90 FMAX"],
        136 => &["L X+20 F0.2"],
        103 => &["L Z-5"],
        _ => return None,
    })
}

#[test]
fn every_m_number_is_used_or_spoken_of() {
    let settings = settings("[output]\ncompensation = \"control\"\n");
    let mut lost = Vec::new();
    for number in 0..200 {
        for text in [format!("M{number}"), format!("M{number}{}", arguments(number))] {
            let start = ["1 TOOL CALL 1 Z S1000", "2 L X+0 Y+0 Z+50 R0 FMAX"];
            let rest = shown_by(number).unwrap_or(&["5 L X+20 R0"]);
            let alone = format!("3 {text}");
            let beside = format!("4 L X+10 F100 {text}");
            let with_alone: Vec<&str> =
                start.iter().copied().chain([alone.as_str(), "4 L X+10 F100"]).chain(rest.iter().copied()).collect();
            let with: Vec<&str> = start.iter().copied().chain([beside.as_str()]).chain(rest.iter().copied()).collect();
            let without: Vec<&str> =
                start.iter().copied().chain(["4 L X+10 F100"]).chain(rest.iter().copied()).collect();
            for (with, what) in [(with_alone, "alone"), (with, "beside a move")] {
                if silent(&with, &without, &settings) {
                    lost.push(format!("{text} {what}"));
                }
            }
        }
    }
    assert!(lost.is_empty(), "left out in silence: {lost:?}");
}

/// M functions that switch something off act where it is on, and say that they have nothing to do where it is not.
#[test]
fn m_functions_that_switch_off_act_where_it_is_on() {
    let settings = settings("[output]\ncompensation = \"control\"\n");
    for (on, off) in [(109, 111), (110, 111), (116, 117), (126, 127), (128, 129), (136, 137)] {
        let (on_block, off_block) = (format!("3 M{on}"), format!("4 M{off}"));
        let mut with = vec!["1 TOOL CALL 1 Z S1000", "2 L X+0 Y+0 Z+50 C+0 R0 FMAX", on_block.as_str()];
        let mut without = with.clone();
        with.push(&off_block);
        for list in [&mut with, &mut without] {
            list.extend(shown_by(on).expect("a function that is switched off has a proof"));
        }
        assert!(!silent(&with, &without, &settings), "M{off} behind M{on}");
    }
}

#[test]
fn every_fn_number_is_used_or_spoken_of() {
    let forms: &[(u32, &str)] = &[
        (0, "Q1 = +5"),
        (1, "Q1 = +5 + +6"),
        (2, "Q1 = +5 - +6"),
        (3, "Q1 = +5 * +6"),
        (4, "Q1 = +5 DIV +4"),
        (5, "Q1 = SQRT 4"),
        (6, "Q1 = SIN 30"),
        (7, "Q1 = COS 30"),
        (8, "Q1 = +5 LEN +4"),
        (9, "IF +1 EQU +1 GOTO LBL 1"),
        (10, "IF +1 NE +2 GOTO LBL 1"),
        (11, "IF +2 GT +1 GOTO LBL 1"),
        (12, "IF +1 LT +2 GOTO LBL 1"),
        (13, "Q1 = +10 ANG +5"),
        (14, "ERROR = 1000"),
        (15, "PRINT Q1"),
        (16, "F-PRINT TNC:\\MASK.A / TNC:\\PROT.TXT"),
        (17, "SYSWRITE ID 50 NR 1 IDX 5 = +Q1"),
        (18, "SYSREAD Q1 = ID210 NR4 IDX3"),
        (19, "PLC = +10/+Q1"),
        (20, "WAIT FOR SYNC"),
        (20, "WAIT FOR M4711 EQU 1"),
        (23, "Q20 = CDATA Q30"),
        (24, "Q20 = CDATA Q30"),
        (25, "PRESET = X/+0/+Q1"),
        (26, "TABOPEN TNC:\\T.TAB"),
        (27, "TABWRITE 5/\"X\" = Q1"),
        (28, "TABREAD Q1 = 6/\"X\""),
        (29, "PLC = +10"),
        (37, "EXPORT QL5"),
        (38, "SEND /\"TEXT\""),
    ];
    let other = (0..=40).filter(|n| !forms.iter().any(|(form, _)| form == n)).map(|n| (n, "FOO"));
    let start = ["1 L X+0 Y+0 R0 F100", "2 Q1 = 3"];
    let rest = ["4 L X+7", "5 LBL 1", "6 L Y+Q1"];
    let mut lost = Vec::new();
    for (number, form) in forms.iter().copied().chain(other) {
        let block = format!("3 FN {number}: {form}");
        let with: Vec<&str> = start.iter().copied().chain([block.as_str()]).chain(rest).collect();
        let without: Vec<&str> = start.iter().copied().chain(rest).collect();
        if silent(&with, &without, &Settings::default()) {
            lost.push(block);
        }
    }
    assert!(lost.is_empty(), "left out in silence: {lost:?}");
}

/// Statements, and for those that only prepare something the block that shows it.
const STATEMENTS: &[(&str, &str)] = &[
    ("STOP", ""),
    ("STOP M6", ""),
    ("TOOL CALL 2 Z S500", ""),
    ("TOOL CALL S500", ""),
    ("TOOL CALL F500", "L X+50 F AUTO"),
    ("TOOL CALL DR+0.5", "L X+20 RL"),
    ("TOOL DEF 5", ""),
    ("TOOL DEF 1 L+0 R+4", "TOOL CALL 1 Z S5\nL X+Q108 R0"),
    ("CC X+10 Y+5", "LP PR+5 PA+0"),
    ("LBL 1", "CALL LBL 1 REP 1"),
    ("LBL 0", ""),
    ("CALL LBL 7", ""),
    ("CALL PGM A.H", ""),
    ("SEL PGM \"B.H\"", "CALL SELECTED PGM"),
    ("CALL SELECTED PGM", ""),
    ("CYCL CALL", ""),
    ("CYCL CALL PAT", ""),
    ("CYCL CALL POS X+0 Y+0 Z+0", ""),
    ("CYCL DEF 7.0\nCYCL DEF 7.1 X+5", "L X+50"),
    ("CYCL DEF 8.0\nCYCL DEF 8.1 X", "L X+50"),
    ("CYCL DEF 9.0\nCYCL DEF 9.1 DWELL 1", ""),
    ("CYCL DEF 10.0\nCYCL DEF 10.1 ROT+30", "L X+50"),
    ("CYCL DEF 11.0\nCYCL DEF 11.1 SCL 2", "L X+50"),
    ("CYCL DEF 12.0\nCYCL DEF 12.1 PGM B.H", "CYCL CALL"),
    ("CYCL DEF 13.0\nCYCL DEF 13.1 ANGLE 90", "L M19"),
    ("CYCL DEF 19.0\nCYCL DEF 19.1 A+10 B+0 C+0", ""),
    ("CYCL DEF 26.0\nCYCL DEF 26.1 X2", "L X+50"),
    ("CYCL DEF 32.0\nCYCL DEF 32.1 T0.05", ""),
    ("CYCL DEF 247 Q339=2", ""),
    ("CYCL DEF 999 FOO", ""),
    ("TRANS DATUM AXIS X+5", "L X+50"),
    ("TRANS MIRROR AXIS X", "L X+50"),
    ("TRANS ROTATION ROT+30", "L X+50"),
    ("TRANS SCALE SCL2", "L X+50"),
    ("PLANE SPATIAL SPA+10 SPB+0 SPC+0 STAY", ""),
    ("TCH PROBE 0.0 REF. PLANE Q5 Z-", ""),
    ("PATTERN DEF POS1 (X+1 Y+1 Z+0)", "CYCL CALL PAT"),
    ("SEL PATTERN \"A.PNT\"", ""),
    ("SEL TABLE \"A.D\"", ""),
    ("SEL CONTOUR \"A\"", ""),
    ("CONTOUR DEF P1 = \"A\"", ""),
    ("DECLARE CONTOUR QC1 = \"A\"", ""),
    ("DECLARE STRING QS1 = \"MILL\"", "TOOL CALL QS1 Z S5"),
    ("GLOBAL DEF 100 GENERAL Q200=+2", "CYCL DEF 200 X Q200=PREDEF"),
    ("FUNCTION MODE MILL", ""),
    ("FUNCTION MODE TURN", ""),
    ("FUNCTION TCPM F TCP AXIS POS", ""),
    ("FUNCTION PARAXCOMP DISPLAY X Y Z", ""),
    ("FUNCTION FEED DWELL D-TIME0.5 F-TIME5", ""),
    ("POLARKIN AXES X Z C MODE:POS", ""),
    ("TABDATA READ Q1 = TOOL COLUMN \"R\" KEY \"1\"", ""),
    ("PRESET SELECT #3", ""),
    ("SECTION MONITORING START AS \"A\"", ""),
    ("APPR LT X+0 Y+10 LEN15 RL F300", ""),
    ("DEP LT LEN20", ""),
    ("FPOL X+0 Y+0", "FL PR+10 PA+20"),
    ("FL X+10 CLSD+", ""),
    ("FSELECT 1", ""),
    ("LN X+1 Y+1 NX0 NY0 NZ1", ""),
    ("SPL X+1", ""),
    ("G1 X5", ""),
    ("RND R5", ""),
    ("CHF 5", ""),
    ("BLK FORM 0.1 Z X+0 Y+0 Z-20 FOO", ""),
    ("BLK FORM FOO", ""),
    ("BLK FORM", ""),
    ("L X+50 :", ""),
    (":", ""),
    ("FOO BAR", ""),
    ("?", ""),
];

#[test]
fn every_statement_is_used_or_spoken_of() {
    let settings = settings("[output]\ncompensation = \"control\"\n");
    let start = ["1 TOOL CALL 1 Z S1000", "2 L X+10 Y+0 Z+50 R0 F100"];
    let mut lost = Vec::new();
    for (statement, shown) in STATEMENTS {
        let mut without = start.to_vec();
        without.extend(shown.lines());
        let mut with = start.to_vec();
        with.extend(statement.lines());
        with.extend(shown.lines());
        // A block and what it adds: `L X+50 :` is compared with `L X+50`.
        let bare = statement.trim_end_matches([':', ' ']);
        if bare != *statement && !bare.is_empty() {
            without.push(bare);
        }
        if silent(&with, &without, &settings) {
            lost.push(statement);
        }
    }
    assert!(lost.is_empty(), "left out in silence: {lost:?}");
}

/// Statements as they are right, each line of which takes no word more.
const COMPLETE: &[&str] = &[
    "STOP",
    "TOOL CALL 2 Z S500",
    "TOOL CALL S500",
    "TOOL DEF 5",
    "TOOL DEF 1 L+0 R+4",
    "CC X+10 Y+5",
    "LBL 1",
    "LBL \"A\"",
    "LBL 0",
    "BLK FORM 0.1 Z X+0 Y+0 Z-20",
    "BLK FORM CYLINDER Z R50 L105",
    "CYCL DEF 7.0\nCYCL DEF 7.1 X+0",
    "CYCL DEF 8.0\nCYCL DEF 8.1 X",
    "CYCL DEF 8.0\nCYCL DEF 8.1",
    "CYCL DEF 9.0\nCYCL DEF 9.1 DWELL 1",
    "CYCL DEF 10.0\nCYCL DEF 10.1 ROT+0",
    "CYCL DEF 11.0\nCYCL DEF 11.1 SCL 1",
    "CYCL DEF 13.0\nCYCL DEF 13.1 ANGLE 90",
    "CYCL DEF 19.0\nCYCL DEF 19.1 A+0 B+0 C+0",
    "CYCL DEF 19.0\nCYCL DEF 19.1",
    "CYCL DEF 26.0\nCYCL DEF 26.1 X1",
    "CYCL DEF 32.0\nCYCL DEF 32.1 T0.05",
    "CYCL DEF 247 Q339=2",
    "CYCL DEF 200 Q200=2 Q201=-10 Q206=100 Q202=5 Q210=0 Q203=0 Q204=20 Q211=0",
    "TRANS DATUM AXIS X+0",
    "TRANS DATUM RESET",
    "PLANE RESET STAY",
    "PLANE SPATIAL SPA+0 SPB+0 SPC+0 STAY",
    "PATTERN DEF POS1 (X+1 Y+1 Z+0)",
    "DECLARE STRING QS1 = \"MILL\"",
    "Q5 = 3 + 4",
    "QS1 = \"A\" || \"B\"",
    "FN 0: Q5 = +3",
    "FN 9: IF +1 EQU +2 GOTO LBL 5\nLBL 5",
    "FN 18: SYSREAD Q5 = ID270 NR1 IDX1",
    "FN 20: WAIT FOR SYNC",
    "FN 37: EXPORT QL5",
    "L X+20",
    "L M8",
    "M8",
    "X+20",
    "L",
    "L F500",
];

#[test]
fn a_stray_word_is_never_lost() {
    let start = ["1 TOOL CALL 1 Z S1000", "2 L X+10 Y+0 Z+50 R0 F100"];
    let settings = Settings::default();
    let mut lost = Vec::new();
    for statement in COMPLETE {
        let without: Vec<&str> = start.iter().copied().chain(statement.lines()).chain(["L X+30"]).collect();
        for stray in ["FOO", "X", "7", "\"TEXT\"", "#", ":", "Q7"] {
            let with = format!("{}\n{statement} {stray}\nL X+30", start.join("\n"));
            let with: Vec<&str> = with.lines().collect();
            if silent(&with, &without, &settings) {
                lost.push(format!("{statement} {stray}"));
            }
        }
    }
    assert!(lost.is_empty(), "left out in silence: {lost:#?}");
}
