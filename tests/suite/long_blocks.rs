//! A block over 1 MiB, which nobody reads: in every dialect the position is lost behind it, and its finding says how the
//! program came there.

use partc::internals::diag::{CallPath, Severity};
use partc::internals::text::files::NoFiles;

use super::common::{Compiled, compile_bytes, settings};

/// Dialect, file name, a program in which the block that `LONG` makes too long moves to 10, in front of an arc that only
/// fits behind that move, and one in which it stands in a called part.
const PROGRAMS: &[(&str, &str, &str, &str)] = &[
    (
        "klartext",
        "A.H",
        "0 BEGIN PGM A MM\n1 L X+0 Y+0 R0 F100\n2 L X+10LONG\n3 CC X+15 Y+0\n4 C X+20 Y+0 DR+\n5 END PGM A MM\n",
        "0 BEGIN PGM A MM\n1 L X+0 Y+0 R0 F100\n2 CALL LBL 1\n3 M30\n4 LBL 1\n5 L X+10LONG\n6 LBL 0\n7 END PGM A MM\n",
    ),
    (
        "sinumerik",
        "A.MPF",
        "G90 G1 X0 Y0 F100\nX10LONG\nG2 X20 Y0 I5 J0\nM30\n",
        "%_N_A_MPF\nG90 G1 X0 Y0 F100\nSUB1\nM30\n%_N_SUB1_SPF\nX10LONG\nM17\n",
    ),
    (
        "heidenhain-turning",
        "A.nc",
        "%1.nc\nN1 G94 F100\nN2 G1 X0 Z0\nN3 G1 Z-10LONG\nN4 G13 X20 Z-10 B12\nN5 G2 X20 Z-20 I15 K-15\nEND\n",
        "HEADER\nMACHINING\nN1 G94 F50\nN2 G1 X0 Z0\nN3 L\"UP\"\nEND\nSUBPROGRAM \"UP\"\nN4 G1 Z-10LONG\nRETURN\n",
    ),
    (
        "mtc200",
        "A.mtc",
        "N1 G90 G71 G94 G01 X0 Y0 F100\nN2 X10LONG\nN3 G02 X20 Y0 R6\nN4 G02 X30 Y0 R1\nN5 M30\n",
        "N1 G90 G71 G94 G01 X0 Y0 F100\nN2 BSR .UP\nN3 RET\n.UP G90\nX10LONG\nRTS\n",
    ),
];

fn compile(dialect: &str, name: &str, program: &str) -> Compiled {
    let text = program.replace("LONG", &" ".repeat((1 << 20) + 1));
    compile_bytes(name, text.into_bytes(), dialect, &settings(""), &NoFiles)
}

#[test]
fn what_follows_a_block_that_is_too_long_is_not_judged() {
    for (dialect, name, program, _) in PROGRAMS {
        let compiled = compile(dialect, name, program);
        let errors: Vec<_> = compiled.findings.iter().filter(|d| d.code.severity == Severity::Error).collect();
        assert_eq!(errors.len(), 1, "{dialect}: {:?}", compiled.rendered);
        assert_eq!(errors[0].code.id, "P0003", "{dialect}");
    }
}

#[test]
fn a_block_that_is_too_long_names_its_call() {
    for (dialect, name, _, program) in PROGRAMS {
        let compiled = compile(dialect, name, program);
        let found = compiled.findings.iter().find(|found| found.code.id == "P0003");
        assert!(found.is_some_and(|d| d.call != CallPath::MAIN), "{dialect}: {:?}", compiled.rendered);
    }
}
