//! What `partc check` says of blocks that do not run.

use super::common::check_klartext;

fn codes(text: &str) -> Vec<(u32, &'static str)> {
    check_klartext(text).iter().map(|found| (found.label.loc.line, found.code.id)).collect()
}

#[test]
fn blocks_behind_the_end_are_looked_at() {
    let text = "0 BEGIN PGM A MM\n\
        1 L X+1 Y+0 R0 F100 M30\n\
        2 L X+Q1 M77\n\
        3 CALL LBL 99\n\
        4 FL X+10\n\
        5 LBL 5\n\
        6 LBL 5\n\
        7 CYCL DEF 4711 FOO\n\
        8 L X+5 X+6\n\
        9 C X+5 R12\n\
        10 PLANE SPATIAL SPA+0 SPB+30 SPC+0 STAY\n\
        11 FN 9: IF +1 EQU +1 GOTO LBL 77\n\
        12 L Z+5 M140 MB 50\n\
        13 CALL LBL 5 REP 2\n\
        14 END PGM A MM\n";
    let expected = [
        (3, "K8001"),
        (4, "K2202"),
        (5, "K8001"),
        (7, "K2201"),
        (8, "K8001"),
        (9, "K1004"),
        (10, "K1005"),
        (11, "K8001"),
        (12, "K2202"),
    ];
    assert_eq!(codes(text), expected);
}

/// What the run reports is not said twice, and what ran without an error has none.
#[test]
fn blocks_that_run_are_left_alone() {
    let text = "0 BEGIN PGM A MM\n1 L X+1 Y+0 R0 F100\n2 FL X+10\n3 LBL 1\n4 LBL 1\n5 CALL LBL 9\n6 END PGM A MM\n";
    assert_eq!(codes(text), [(3, "K9002"), (5, "K2201"), (6, "K2202")]);
    assert!(check_klartext(text).iter().all(|found| found.times == 1));
}

#[test]
fn every_golden_case_that_compiles_passes_the_check() {
    for path in super::common::cases("klartext") {
        let Ok(text) = std::fs::read_to_string(&path) else { continue };
        if path.with_extension("toml").exists() || super::common::compile_case(&path).has_errors() {
            continue;
        }
        let findings = check_klartext(&text);
        // The check of this test has no files to call.
        if findings.iter().any(|found| found.code.id == "P0101") {
            continue;
        }
        let errors: Vec<String> = findings
            .iter()
            .filter(|found| found.code.severity == partc::diag::Severity::Error)
            .map(|found| format!("{}:{} {}", path.display(), found.label.loc.line, found.message))
            .collect();
        assert!(errors.is_empty(), "{errors:?}");
    }
}
