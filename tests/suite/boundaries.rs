//! SINUMERIK: the last value that is taken and the first that is not.

use partc::internals::text::files::NoFiles;

use super::common::{compile_bytes, settings};

/// Blocks with the last good value, the same with the first bad one, and the code of its refusal. `|` divides blocks.
const BOUNDS: &[(&str, &str, &str)] = &[
    ("G1 RP=10 AP=360", "G1 RP=10 AP=360.001", "S2053"),
    ("G1 RP=10 AP=-360", "G1 RP=10 AP=-360.001", "S2053"),
    ("G111 RP=10 AP=360", "G111 RP=10 AP=360.001", "S2053"),
    ("G1 RP=0 AP=0", "G1 RP=-0.001 AP=0", "S2052"),
    ("G111 RP=0 AP=0", "G111 RP=-0.001 AP=0", "S2052"),
    ("C=DC(359.999)", "C=DC(360)", "S2061"),
    ("C=ACP(0)", "C=ACN(-0.001)", "S2061"),
    ("G2 X20 Y0 CR=9.995", "G2 X20 Y0 CR=9.994", "S3001"),
    ("G2 X10 Y10.01 I10 J0", "G2 X10 Y10.011 I10 J0", "P3001"),
    ("G2 X1000 Y1001 I1000 J0", "G2 X1000 Y1001.001 I1000 J0", "P3001"),
    ("G2 X20 Y0 AR=359", "G2 X20 Y0 AR=360", "S3004"),
    ("G3 X20 Y0 AR=1", "G3 X20 Y0 AR=0.00009", "S3004"),
    ("G3 X0 Y0 Z-5 I5 TURN=999", "G3 X0 Y0 Z-5 I5 TURN=1000", "S3005"),
    ("G3 X0 Y0 Z-5 I5 TURN=0", "G3 X0 Y0 Z-5 I5 TURN=-1", "S3005"),
    ("G1 X5 F0.001", "G1 X5 F0", "P2003"),
    ("G1 X5 FB=0.001", "G1 X5 FB=0", "P2003"),
    ("G1 X5 RND=0|Y5", "G1 X5 RND=-0.001|Y5", "S2071"),
    ("RNDM=0", "RNDM=-0.001", "S2071"),
    ("G4 F0", "G4 F-0.001", "P2003"),
    ("G4 F100000", "G4 F100001", "P2003"),
    ("S0", "S-1", "S2045"),
    ("LIMS=0.001", "LIMS=0", "S2045"),
    ("SETMS(20)", "SETMS(21)", "S2045"),
    ("T32000 M6", "T32001 M6", "S2043"),
    ("D32000", "D32001", "S2043"),
    ("G[6]=3", "G[6]=4", "S2011"),
    ("R32534=1", "R32535=1", "S2018"),
    ("R1=SQRT(0)", "R1=SQRT(-0.001)", "P2022"),
    ("R1=ACOS(1)", "R1=ACOS(1.001)", "P2022"),
    ("R1=LN(0.001)", "R1=LN(0)", "P2022"),
    ("SETINT(1) PRIO=128 LIFT", "SETINT(1) PRIO=129 LIFT", "S2021"),
    ("M10 M11 M12 M13 M14", "M10 M11 M12 M13 M14 M10", "P1002"),
    ("G75 FP=4 Z1=0", "G75 FP=5 Z1=0", "P1003"),
    ("LABEL_OF_THIRTY_TWO_CHARACTERS12: X5", "LABEL_OF_THIRTY_TWO_CHARACTERS123: X5", "S1014"),
    ("!DEF INT V=2147483647", "!DEF INT V=2147483648", "S2029"),
    ("!DEF INT A[32767]", "!DEF INT A[32768]", "S2018"),
    ("!DEF INT LLI 1 ULI 5 V=4|V=5", "!DEF INT LLI 1 ULI 5 V=4|V=6", "S2029"),
    ("!DEF INT LLI 1 ULI 5 V=4|V=1", "!DEF INT LLI 1 ULI 5 V=4|V=0", "S2029"),
    ("STEP P9999", "STEP P10000", "S2019"),
    ("STEP P1", "STEP P0", "S2019"),
];

const CONFIG: &str = "[machine]\nfixed_point_4 = { Z = 5.0 }\n[output]\npass_m = [10, 11, 12, 13, 14]";

fn codes(blocks: &str) -> (Vec<&'static str>, bool, Vec<String>) {
    let start = "G17 G90 G0 X0 Y0 Z0 C0\nF100\n";
    let blocks = match blocks.strip_prefix('!') {
        Some(own) => format!("{}\n{start}", own.replace('|', &format!("\n{start}"))),
        None => format!("{start}{}\n", blocks.replace('|', "\n")),
    };
    let program = format!("%_N_MAIN_MPF\n{blocks}M30\n%_N_STEP_SPF\nG91 G1 X0.001\nG90\nM17\n");
    let compiled = compile_bytes("PART.MPF", program.into_bytes(), "sinumerik", &settings(CONFIG), &NoFiles);
    (compiled.codes(), compiled.has_errors(), compiled.rendered)
}

#[test]
fn the_last_good_value_is_taken_and_the_first_bad_one_is_not() {
    let mut wrong = Vec::new();
    for (good, bad, code) in BOUNDS {
        let (_, errors, rendered) = codes(good);
        if errors {
            wrong.push(format!("{good} is refused: {rendered:?}"));
        }
        let (found, errors, rendered) = codes(bad);
        if !errors || !found.contains(code) {
            wrong.push(format!("{bad} is not refused with {code}: {rendered:?}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
