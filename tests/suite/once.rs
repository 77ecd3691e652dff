//! What holds on in a program is told once: once a *fact*, so that another value is told, too.

use std::collections::BTreeSet;

use partc::internals::text::files::NoFiles;

use super::common::{compile_bytes, settings};

/// Blocks of two facts of one code, and what their findings say of each.
struct Row {
    dialect: &'static str,
    code: &'static str,
    settings: &'static str,
    head: &'static str,
    facts: [(&'static str, &'static str); 2],
    tail: &'static str,
}

const MILL: &str = "G17 G90 G94 G71 S500 M3 F100\nT1 D1 M6\nG0 X0 Y0 Z50\n";

const ROWS: &[Row] = &[
    Row {
        dialect: "klartext",
        code: "K2011",
        settings: "",
        head: "BEGIN PGM D MM\n",
        facts: [
            ("TOOL CALL 1 Z S2000 F500 DL+0.5\nL X+0 Y+0 Z+5 R0 FMAX M3", "DL 0.5 mm"),
            ("TOOL CALL 2 Z S2000 F500 DL-0.8\nL X+0 Y+0 Z+5 R0 FMAX M3", "DL -0.8 mm"),
        ],
        tail: "END PGM D MM\n",
    },
    Row {
        dialect: "klartext",
        code: "K2011",
        settings: "",
        head: "BEGIN PGM D MM\n",
        facts: [
            ("TOOL CALL 1 Z S2000 F500 DL+0.5\nL X+0 Y+0 Z+5 R0 FMAX M3", "of tool 1"),
            ("TOOL CALL 2 Z S2000 F500 DL+0.5\nL X+0 Y+0 Z+5 R0 FMAX M3", "of tool 2"),
        ],
        tail: "END PGM D MM\n",
    },
    Row {
        dialect: "klartext",
        code: "P2008",
        settings: "[output]\npass_m = [38, 39]\n",
        head: "BEGIN PGM D MM\nL X+0 Y+0 Z+5 R0 FMAX\n",
        facts: [("L X+10 F100 M38", "M38"), ("L X+20 F100 M39", "M39")],
        tail: "END PGM D MM\n",
    },
    Row {
        dialect: "klartext",
        code: "K2410",
        settings: "",
        head: "BEGIN PGM D MM\nTOOL CALL 1 Z S2000 F500\nL X+0 Y+0 Z+5 R0 FMAX M3\nCYCL DEF 200 Q200=2 Q201=-5 Q206=100 Q202=5 Q210=0 Q203=0 Q204=5 Q211=0\n",
        facts: [
            ("PATTERN DEF PAT1 (X+10 Y+10 DX+5 DY+5 NUMX2 NUMY2 ROT+0 ROTX+0 ROTY+0 Z+0)\nCYCL CALL PAT FMAX", "PAT"),
            (
                "PATTERN DEF FRAME1 (X+10 Y+10 DX+5 DY+5 NUMX3 NUMY3 ROT+0 ROTX+0 ROTY+0 Z+0)\nCYCL CALL PAT FMAX",
                "FRAME",
            ),
        ],
        tail: "END PGM D MM\n",
    },
    Row {
        dialect: "sinumerik",
        code: "S8025",
        settings: "",
        head: MILL,
        facts: [("F625\nG63 Z-5\nG0 Z50", "G63"), ("S500\nCYCLE840(50,0,2,-20,,0,4,3,1,,1.25)", "encoder")],
        tail: "M30\n",
    },
    Row {
        dialect: "sinumerik",
        code: "S8014",
        settings: "",
        head: MILL,
        facts: [("S2=500 M2=4\nSETMS(2)", "spindle 2"), ("SETMS", "spindle 1")],
        tail: "M30\n",
    },
    Row {
        dialect: "sinumerik",
        code: "P8103",
        settings: "[machine]\nkind = \"lathe\"\ndiameter_axis = \"X\"\n[tools.1]\nradius = 0.4\norientation = 3\n",
        head: "G18 G90 DIAMON G95 F0.2 S400 M3\nT1 D1\nG0 X100 Z10\n",
        facts: [
            ("CYCLE95(\"ONE:ONE_END\",1,,,0.2,0.2,,,1,,,1)", "`ONE"),
            ("CYCLE95(\"TWO:TWO_END\",1,,,0.2,0.2,,,1,,,1)", "`TWO"),
        ],
        tail: "M30\nONE:\nG0 X20 Z0\nG1 Z-20 F0.1\nX60\nONE_END:\nTWO:\nG0 X20 Z0\nG1 Z-30 F0.1\nX60\nTWO_END:\n",
    },
    Row {
        dialect: "gcode",
        code: "R8001",
        settings: "",
        head: "G21 G90 G17 G94\nG0 X0 Y0 Z5\n",
        facts: [("G64 P0.1\nG64", "no bound"), ("G61\nG64", "no bound")],
        tail: "M2\n",
    },
];

#[test]
fn each_fact_is_told_once() {
    for row in ROWS {
        let [first, second] = row.facts;
        let told = |blocks: &[&str]| -> Vec<String> {
            let program = format!("{}{}\n{}", row.head, blocks.join("\n"), row.tail);
            let done = compile_bytes("P", program.into_bytes(), row.dialect, &settings(row.settings), &NoFiles);
            let found = done.findings.into_iter().filter(|found| found.code.id == row.code);
            found.map(|found| found.message).collect()
        };
        let both = told(&[first.0, second.0, first.0, second.0]);
        let distinct: BTreeSet<_> = both.iter().collect();
        assert_eq!(both.len(), distinct.len(), "{} {both:#?}", row.code);
        for (_, said) in row.facts {
            assert!(both.iter().any(|message| message.contains(said)), "{} {said}: {both:#?}", row.code);
        }
    }
}

/// A number with many decimals is one fact, however often it is computed.
#[test]
fn a_long_number_is_one_fact() {
    let cycle = "CYCL DEF 251 Q215=0 Q218=60 Q219=40 Q220=1 Q368=0 Q224=0 Q367=0 Q207=500 Q351=1 Q201=-5 Q202=5 Q369=0 Q206=100 Q338=0 Q200=2 Q203=0 Q204=50 Q370=1 Q366=0 Q385=500";
    let program = format!(
        "BEGIN PGM D MM\nTOOL CALL 1 Z S2000 F500\nL X+0 Y+0 Z+50 R0 FMAX M3\n{cycle}\nL X+50 Y+50 FMAX M99\nL X+150 Y+50 FMAX M99\nL X+250 Y+50 FMAX M99\nL Z+50 FMAX M30\nEND PGM D MM\n"
    );
    let done = compile_bytes(
        "D.H",
        program.into_bytes(),
        "klartext",
        &settings("[tools.1]\nradius = 3.3333333333333335\n"),
        &NoFiles,
    );
    let corners = done.findings.iter().filter(|found| found.code.id == "K8102").count();
    assert_eq!(corners, 1, "{:#?}", done.rendered);
}

/// Of a code with many facts some are listed, and the rest counted.
#[test]
fn many_facts_are_counted() {
    let moves: String = (1..=60).map(|n| format!("M140 MB MAX\nL X+{n} F100 M{}\n", 400 + n)).collect();
    let pass: Vec<String> = (1..=60).map(|n| (400 + n).to_string()).collect();
    let program = format!("BEGIN PGM D MM\nL X+0 Y+0 Z+5 R0 FMAX\n{moves}END PGM D MM\n");
    let config = format!("[control]\nretract_max = 0.0\n[output]\npass_m = [{}]\n", pass.join(", "));
    let done = compile_bytes("D.H", program.into_bytes(), "klartext", &settings(&config), &NoFiles);
    let told: Vec<_> = done.findings.iter().filter(|found| found.code.id == "P2008").collect();
    assert_eq!(told.len(), 20, "{:#?}", done.rendered);
    assert!(told[19].message.ends_with("; 40 more of this kind are not listed"), "{}", told[19].message);
}
