//! A note never covers a deviation: each note of the catalogue stands here with what proves that the printed path is the
//! control's. What is not known, or differs, is a warning or an error.

use std::fs;

use partc::internals::diag::{Severity, codes};

use super::book::{Case, cases};
use super::common::Compiled;

/// Why a note is enough.
enum Proof {
    /// With these replacements the firing case says the same without the word, statement or datum that the note is about:
    /// it prints the same blocks, and the note is gone.
    Same(&'static [(&'static str, &'static str)]),
    /// A key of partc.toml asked for it: without its configuration the firing case is refused, or does not say it.
    Asked,
    /// The control itself chooses, or no manual says more than the result: this page describes what partc does, in these words.
    Free(&'static str, &'static str),
    /// The firing case and its listing hold the numbers, worked out from the manual.
    Worked,
}

use Proof::{Asked, Free, Same, Worked};

const CYCLES: &str = "docs/cycles.md";

const NOTES: &[(&str, Proof)] = &[
    ("G3013", Worked),
    ("K2011", Same(&[(" DL+0.2", ""), ("Z-5", "Z-4.8")])),
    ("K2014", Same(&[(" DR2+0.1", "")])),
    ("K2408", Free(CYCLES, "205")),
    ("K2409", Free(CYCLES, "tap")),
    ("K2410", Free(CYCLES, "PAT")),
    ("K2412", Same(&[("2 CYCL DEF 225 ENGRAVING ~\n    Q573=+0\n", "")])),
    ("P8105", Same(&[("2 CYCL DEF 392 ATC\n", "")])),
    ("K2504", Worked),
    ("K2512", Same(&[("1 PLANE RESET TURN FMAX\n", "")])),
    ("K2513", Same(&[("TABLE TABLINE5", "AXIS X+50 Y+40 Z+0"), ("1 SEL TABLE \"NULLTAB.D\"\n", "")])),
    ("K2702", Same(&[(" M6", "")])),
    ("K2703", Same(&[(" M120 LA 5", "")])),
    ("K2704", Asked),
    ("K2708", Worked),
    ("K2805", Same(&[("1 FN 20: WAIT FOR SYNC\n", ""), ("2 FN 16: F-PRINT TNC:\\MASK.A / TNC:\\PROT.TXT\n", "")])),
    (
        "K2853",
        Same(&[
            ("PLANE SPATIAL SPA+0 SPB+0 SPC+90 STAY", "CYCL DEF 10.0 ROTATION\n1 CYCL DEF 10.1 ROT+90"),
            ("3 PLANE RESET STAY\n", ""),
        ]),
    ),
    ("K2853", Worked),
    ("P8101", Free(CYCLES, "251")),
    ("K8104", Worked),
    ("K8141", Free(CYCLES, "205")),
    ("M2702", Asked),
    ("M2703", Same(&[(" ACC50", "")])),
    ("M8001", Same(&[("%\n", "")])),
    ("M8002", Same(&[("G48 ", "")])),
    ("O4001", Worked),
    ("O4002", Worked),
    ("O4003", Free("docs/targets.md", "preset")),
    ("O4004", Free("docs/targets.md", "arc_fallback_tolerance")),
    ("O4006", Asked),
    ("R8001", Same(&[(" G64", "")])),
    ("S8002", Same(&[("FFWON SOFT\n", "")])),
    ("S8004", Same(&[("M41 ", "")])),
    ("S8006", Same(&[("$A_OUT[3]=1\n", "")])),
    ("S8010", Same(&[("$TC_DP3[1,1]=120\n", "")])),
    ("S8011", Worked),
    ("S8012", Same(&[("$P_UIFR[1]=CTRANS(X,100,Y,50)\nG54", "TRANS X100 Y50")])),
    ("S8013", Same(&[("G25 X-10 Y-10\n", "")])),
    ("S8014", Worked),
    ("S8015", Same(&[("WAITM(1,1,2)\n", "")])),
    ("S8016", Same(&[("DISABLE(1)\n", "")])),
    ("S8168", Same(&[("_MVAR=100 _KNUM=0\nCYCLE978\n", "CYCLE978(100,0)\n")])),
    ("S8170", Same(&[("CANCEL(1)\n", "")])),
    ("S8017", Same(&[("WRITE(ERROR,\"LOG\",\"START\")\n", "")])),
    ("S8023", Free("docs/undercuts.md", "roughs")),
    ("S8027", Worked),
    ("S8028", Worked),
    ("S8029", Same(&[("CYCLE800(0,\"TC1\",200000,57,0,0,0,0,0,0,0,0,0,-1)\n", "")])),
    ("S8035", Same(&[("0.3,7,,,80", "0.3,,,,80")])),
    ("S8037", Same(&[("CALLPATH(\"/_N_WKS_DIR/_N_SHAFT_WPD\")\n", "")])),
    ("S8039", Free("docs/sinumerik.md", "MPF.DIR")),
    ("S8041", Worked),
    ("S8049", Worked),
    ("S8103", Same(&[("STOPRE\n", "")])),
    ("S8104", Same(&[("ORIMKS\n", "")])),
    ("S8105", Worked),
    ("S8108", Worked),
    ("S8130", Asked),
    ("P8105", Asked),
    ("S8196", Same(&[("FAD=300 ", "")])),
    ("S8210", Worked),
    ("S8211", Worked),
    ("S8212", Free(CYCLES, "CYCLE95")),
    ("P8101", Free(CYCLES, "CYCLE93")),
    ("S8221", Free(CYCLES, "CYCLE93")),
    ("S8223", Same(&[(",5,,2)", ",5)")])),
    ("P8101", Free(CYCLES, "CYCLE92")),
    ("P8101", Free(CYCLES, "POCKET4")),
    ("S8250", Asked),
    ("S8251", Asked),
    ("S8253", Same(&[("G95", "G94"), ("F0.1", "F100")])),
    ("T1013", Same(&[("HEADER\n", "HEADER\n#UNIT METRIC\n")])),
    ("T2005", Same(&[("S800", "S500")])),
    ("T2015", Same(&[("N1 G59 Z150\n", "")])),
    ("T2026", Worked),
    ("T2027", Worked),
    ("T2031", Worked),
    ("T8017", Same(&[(" P1", "")])),
];

fn firing(code: &str) -> Vec<&'static Case> {
    let fires = format!("{code}_fires");
    cases("errors").iter().copied().filter(|case| case.stem().starts_with(&fires)).collect()
}

/// The blocks of an output, without the comments that stand for the source's.
fn blocks(compiled: &Compiled) -> Vec<String> {
    let lines = compiled.output.lines().map(str::trim);
    lines.filter(|line| !line.starts_with('(') && !line.is_empty()).map(str::to_owned).collect()
}

fn check(code: &str, proof: &Proof) {
    let fires = firing(code);
    match proof {
        Same(replacements) => {
            let case = fires.first().unwrap_or_else(|| panic!("{code}: no case fires"));
            let mut twin = case.text().expect("UTF-8").to_owned();
            for (from, to) in *replacements {
                assert!(twin.contains(from), "{code}: {} has no {from:?}", case.name);
                twin = twin.replace(from, to);
            }
            let (noted, silent) = (case.compile(), case.compile_instead(&twin));
            assert!(noted.codes().contains(&code), "{code}: {:#?}", noted.rendered);
            assert!(!silent.codes().contains(&code) && !silent.has_errors(), "{code}: {:#?}", silent.rendered);
            assert_eq!(blocks(&noted), blocks(&silent), "{code}: {}", case.name);
        }
        Asked => {
            for case in fires {
                assert!(!case.config.is_empty(), "{code}: {} has no configuration", case.name);
                let plain = Case { config: String::new(), ..case.clone() }.compile();
                assert!(plain.has_errors() || !plain.codes().contains(&code), "{code}: {:#?}", plain.rendered);
            }
        }
        Free(page, words) => {
            let text = fs::read_to_string(page).unwrap_or_else(|error| panic!("{code}: {page}: {error}"));
            assert!(text.contains(words), "{code}: {page} does not name {words:?}");
        }
        Worked => assert!(!fires.is_empty(), "{code}: no case holds the numbers"),
    }
}

#[test]
fn a_note_never_covers_a_deviation() {
    let retired = |code: &codes::Code| code.explain.starts_with("Retired");
    let mut unproved = Vec::new();
    for code in codes::all() {
        // The rules of L are about the program, whose path is printed as it is.
        if code.severity != Severity::Note || code.id.starts_with('L') || retired(code) {
            continue;
        }
        match NOTES.iter().find(|(id, _)| *id == code.id) {
            Some((id, proof)) => check(id, proof),
            None => unproved.push(code.id),
        }
    }
    assert!(unproved.is_empty(), "a note needs a proof that the path is the control's, or is a warning: {unproved:?}");
    for (id, _) in NOTES {
        let code = codes::find(id).unwrap_or_else(|| panic!("{id} is no code"));
        assert!(code.severity == Severity::Note && !retired(code), "{id} is no note any more: take it out");
    }
}
