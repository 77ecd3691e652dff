//! What `partc check` says of blocks that do not run.

use super::common::{check_klartext, check_program};

/// What the language says; lint rules have tests of their own.
fn codes(text: &str) -> Vec<(u32, &'static str)> {
    check_klartext(text)
        .iter()
        .map(|found| (found.label.loc.line, found.code.id))
        .filter(|(_, code)| !code.starts_with('L'))
        .collect()
}

#[test]
fn blocks_behind_the_end_are_looked_at() {
    let text = "0 BEGIN PGM A MM\n\
        1 L X+1 Y+0 R0 F100 M30\n\
        2 L X+Q1 M77\n\
        3 CALL LBL 99\n\
        4 SPL X+10\n\
        5 LBL 5\n\
        6 LBL 5\n\
        7 CYCL DEF 4711 FOO\n\
        8 L X+5 X+6\n\
        9 C X+5 R12\n\
        10 PLANE AXIAL B+30 STAY\n\
        11 FN 9: IF +1 EQU +1 GOTO LBL 77\n\
        12 L Z+5 M140 MB 50\n\
        13 CALL LBL 5 REP 2\n\
        14 END PGM A MM\n";
    let expected = [
        (3, "P8140"),
        (4, "P2011"),
        (5, "P8140"),
        (7, "P2010"),
        (8, "P8140"),
        (9, "P1002"),
        (10, "P1003"),
        (11, "P8140"),
        (12, "P8140"),
    ];
    assert_eq!(codes(text), expected);
}

/// What the run reports is not said twice, and what ran without an error has none.
#[test]
fn blocks_that_run_are_left_alone() {
    let text = "0 BEGIN PGM A MM\n1 L X+1 Y+0 R0 F100\n2 FL X+10\n3 LBL 1\n4 LBL 1\n5 CALL LBL 9\n6 END PGM A MM\n";
    assert_eq!(codes(text), [(3, "K3001"), (5, "P2010"), (6, "P2011")]);
    assert!(check_klartext(text).iter().all(|found| found.times == 1));
}

#[test]
fn every_golden_case_that_compiles_passes_the_check() {
    for case in super::book::cases("klartext") {
        let Some(text) = case.text() else { continue };
        if !case.config.is_empty() || case.compile().has_errors() {
            continue;
        }
        let findings = check_klartext(text);
        // The check of this test has no files to call.
        if findings.iter().any(|found| found.code.id == "P0101") {
            continue;
        }
        let errors: Vec<String> = findings
            .iter()
            .filter(|found| found.code.severity == partc::internals::diag::Severity::Error)
            .map(|found| format!("{}:{} {}", case.name, found.label.loc.line, found.text()))
            .collect();
        assert!(errors.is_empty(), "{errors:?}");
    }
}

const SIEMENS: &str = "%_N_T_MPF\n\
    G17 G54 G90 G0 X0 Y0 Z5\n\
    R1=0\n\
    IF R1==5\n\
    G1 X5 X6\n\
    G199 X5\n\
    G17 G18\n\
    G0 G1 X5\n\
    NOWHERE\n\
    R2=1 R2=2\n\
    M77\n\
    TRAORI\n\
    MCALL CYCLE81(10,0,2,-5)\n\
    CALL \"MISSING\"\n\
    G2 CR=5 CR=6\n\
    ENDIF\n\
    IF R1==7 GOTOF NIX\n\
    IF R1==7 GOTOB FIN\n\
    GOTOF FIN\n\
    REPEAT LA LB\n\
    ID=1 DO M5\n\
    FIN: M30\n\
    L77\n\
    SUB2\n\
    %_N_SUB2_SPF\n\
    IF R1\n\
    G1 G95 X10 D1 D2\n\
    M17\n";

#[test]
fn sinumerik_blocks_that_do_not_run_are_looked_at() {
    let found: Vec<(u32, &str)> = check_program("sinumerik", "T.MPF", SIEMENS)
        .iter()
        .filter(|found| !found.code.id.starts_with('L'))
        .map(|found| (found.label.loc.line, found.code.id))
        .collect();
    let expected = [
        (5, "P1002"),
        (6, "S2010"),
        (7, "S2008"),
        (8, "S2009"),
        (9, "P8140"),
        (11, "P8140"),
        (12, "P8140"),
        (14, "P8140"),
        (15, "P1002"),
        (17, "P8140"),
        (18, "P8140"),
        (20, "P8140"),
        (21, "P8140"),
        (23, "P8140"),
        (26, "S2004"),
        (27, "P1002"),
    ];
    assert_eq!(found, expected);
}

/// The control looks for the target when it jumps, and `compile` accepts the program.
#[test]
fn a_sinumerik_jump_that_is_not_made_needs_no_target() {
    let found = check_program("sinumerik", "T.MPF", "IF 1==2 GOTOB LAB\nG0 X0 Y0\nLAB: M30\n");
    let codes: Vec<(u32, &str)> = found.iter().map(|found| (found.label.loc.line, found.code.id)).collect();
    assert_eq!(codes, [(1, "P8140")]);
}

/// What the run reports is not said twice.
#[test]
fn sinumerik_blocks_that_run_are_left_alone() {
    let text = "G0 X0 Y0 Z5\nG199\nG1 X5 X6 F100\nIF 1\nG17 G18\nGOTOF NIX\nENDWHILE\n";
    let found = check_program("sinumerik", "T.MPF", text);
    let codes: Vec<(u32, &str)> = found.iter().map(|found| (found.label.loc.line, found.code.id)).collect();
    // Behind the IF that is not closed nothing runs.
    let expected = [(2, "S2010"), (3, "P1002"), (4, "S2004"), (5, "S2008"), (6, "P8140"), (7, "S2004")];
    assert_eq!(codes, expected);
    assert!(found.iter().all(|found| found.times == 1), "{found:?}");
}

#[test]
fn every_sinumerik_case_that_compiles_passes_the_check() {
    for case in super::book::cases("sinumerik") {
        let Some(text) = case.text() else { continue };
        // Nor has it definitions.
        let defines = case.called.keys().any(|name| name.ends_with(".DEF"));
        if !case.config.is_empty() || defines || case.compile().has_errors() {
            continue;
        }
        let findings = check_program("sinumerik", "PART.MPF", text);
        // The check of this test has no files to call.
        if findings.iter().any(|found| found.code.id == "S2002") {
            continue;
        }
        let errors: Vec<String> = findings
            .iter()
            .filter(|found| found.code.severity == partc::internals::diag::Severity::Error)
            .map(|found| format!("{} {}", found.code.id, found.text()))
            .collect();
        assert!(errors.is_empty(), "{}: {errors:?}", case.name);
    }
}
