//! Limits of words and cycles: the last value on this side, and the first one on the other.

use partc::internals::machine::Settings;
use partc::internals::text::files::NoFiles;

use super::common::compile_bytes;

/// Blocks with `{}` for the value; a value that passes in silence; one that does not, and what is said of it.
const LIMITS: &[(&str, &str, &str, &str)] = &[
    ("CYCL DEF 9.0\nCYCL DEF 9.1 DWELL {}", "3600", "3600.001", "P2090"),
    ("CYCL DEF 9.0\nCYCL DEF 9.1 DWELL {}", "0", "-0.001", "P2090"),
    ("CYCL DEF 13.0\nCYCL DEF 13.1 ANGLE {}", "360", "360.001", "P2090"),
    ("CYCL DEF 13.0\nCYCL DEF 13.1 ANGLE {}", "0", "-0.001", "P2090"),
    ("TRANS SCALE SCL{}\nTRANS SCALE RESET", "99.999999", "100", "P2090"),
    ("TRANS SCALE SCL{}\nTRANS SCALE RESET", "0.000001", "0.0000009", "P2090"),
    ("L X+20 M103 F{}", "100", "100.01", "K2707"),
    ("L X+20 M103 F{}", "0.01", "0", "K2707"),
    ("L M140 MB {}", "0.001", "0", "K2707"),
    ("TOOL CALL {} Z", "32767", "32768", "K2010"),
    ("L X{}", "+99999.9999", "+100000", "K0003"),
    ("M136\nL X+20 F{}", "10", "10.001", "K2013"),
    ("CC X+0 Y+0\nCP PA{} DR+", "+360", "+360.001", "K2106"),
    ("L C+0 FMAX\nM126\nL IC{} FMAX", "+180", "+180.001", "K9008"),
    ("L C+0 FMAX\nM126\nL C{} FMAX", "+179.9", "+180", "K2510"),
    ("FN 12: IF +0 LT {} GOTO LBL 1\nLBL 1", "+0.000000002", "+0.0000000005", "K2810"),
    ("RND R{}", "0.001", "0", "P1004"),
    ("CHF {}", "0.001", "0", "P1004"),
    ("L X+20 F{}", "0.0001", "0", "O1001"),
    (
        "CYCL DEF 10.0\nCYCL DEF 10.1 ROT{}\nCYCL DEF 8.0\nCYCL DEF 8.1 X\nCYCL DEF 8.0\nCYCL DEF 8.1\nTRANS ROTATION RESET",
        "+180",
        "+179.999",
        "K2807",
    ),
    ("CALL LBL 2 REP {}", "1", "1.5", "K2205"),
];

fn codes(blocks: &str) -> Vec<&'static str> {
    let text = format!(
        "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S1000\n2 L X+10 Y+0 Z+5 R0 F100\n3 LBL 2\n{blocks}\n7 L X+30 Y+10\n\
         8 END PGM A MM\n"
    );
    let compiled = compile_bytes("A.H", text.into_bytes(), "klartext", &Settings::default(), &NoFiles);
    compiled.codes()
}

#[test]
fn values_at_the_limit_pass_and_values_beyond_do_not() {
    let mut wrong = Vec::new();
    for (blocks, passes, fails, code) in LIMITS {
        if codes(&blocks.replace("{}", passes)).contains(code) {
            wrong.push(format!("{code}: {blocks} with {passes} does not pass"));
        }
        if !codes(&blocks.replace("{}", fails)).contains(code) {
            wrong.push(format!("{code}: {blocks} with {fails} passes: {:?}", codes(&blocks.replace("{}", fails))));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Where the tool stands just at the height that it has to be lifted to, it is not lifted.
#[test]
fn a_tool_at_its_height_is_not_lifted() {
    let lifts = |height: &str, call: &str| {
        let text = format!(
            "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S1000\n2 L X+10 Y+0 Z{height} R0 FMAX M3\n\
             3 PATTERN DEF POS1 (X+50 Y+0 Z+0)\n4 CYCL DEF 200 DRILLING ~\n Q200=2 Q201=-10 Q206=100 Q202=10 Q210=0 \
             Q203=0 Q204=20 Q211=0\n5 {call} FMAX\n6 END PGM A MM\n"
        );
        let compiled = compile_bytes("A.H", text.into_bytes(), "klartext", &Settings::default(), &NoFiles);
        assert!(!compiled.has_errors(), "{:?}", compiled.rendered);
        let moves: Vec<&str> = compiled.output.lines().filter(|line| line.starts_with("G0 ")).collect();
        // Behind the move of the program: a lift, or the way to the hole.
        moves[1].starts_with("G0 Z")
    };
    // To the 2nd set-up clearance, 20 mm above the surface.
    assert!(!lifts("+20", "CYCL CALL PAT") && lifts("+19.9999", "CYCL CALL PAT"));
    // From below the surface only.
    assert!(!lifts("+0", "CYCL CALL POS X+50 Y+0 Z+0") && lifts("-0.0001", "CYCL CALL POS X+50 Y+0 Z+0"));
}
