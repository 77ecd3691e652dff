//! The control's alarm numbers: each stands in the text of the finding it belongs to.
//!
//! Causes and numbers are those of the diagnostics manual of the control. What no compiler can see (limits of the
//! machine, buffers, run-time collisions) and what is refused as a whole (splines, transformations, measuring) is left out.

use partc::internals::text::files::NoFiles;

use super::common::{compile_bytes, settings};

/// Programs that a case may call.
const CALLED: &str = "%_N_VARP_SPF\nPROC VARP(VAR REAL A, REAL B)\nM17\n%_N_AXP_SPF\nPROC AXP(AXIS A)\nM17\n\
    %_N_PLAIN_SPF\nG0 X5\nM17\n%_N_L10_SPF\nG0 X1\nM17\n%_N_REC_SPF\nREC\nM17\n";
/// In front of each case: the tool stands at the origin and came along Y.
const START: &str = "G17 G90 G0 X0 Y0 Z0\nX-1 Y0\nX0 Y0\n";

/// Alarm and blocks, divided by `|`. `!` is a program of its own, `#` runs on a machine without a diameter axis.
const CASES: &[(u32, &str)] = &[
    (12000, "G1 X5 X6 F100"),
    (12000, "G1 X5 F100 F200"),
    (12010, "M10 M11 M12 M13 M14 M15"),
    (12020, "G2 X5 I=DC(20) F100"),
    (12020, "G1 X5 F=AC(100)"),
    (12020, "S=IC(100)"),
    (12020, "G1 X5 ANG=IC(5) F100"),
    (12020, "G111 X=RAC(5) Y0"),
    (12020, "TRANS X=DAC(5)"),
    (12020, "ROT Z=DC(5)"),
    (12040, "AX[1]=5"),
    (12040, "POS[R1]=5"),
    (12050, "G1 Q5 F100"),
    (12060, "G17 G18"),
    (12070, "G0 G1 X5"),
    (12070, "G1 G110 X0 Y0"),
    (12070, "TRANS X5 G1"),
    (12080, "R1=10 M=R1"),
    (12080, "G1 X="),
    (12080, "IF"),
    (12090, "TRAFOOF(1)"),
    (12100, "MCALL L10 P3"),
    (12110, "G1 X20 I10 F100"),
    (15460, "G1 X5 F100|X20 I10"),
    (12120, "G4 F1 X5"),
    (12120, "G111 X0 Y0 M8"),
    (12120, "STOPFIFO M8"),
    (12120, "STARTFIFO M8"),
    (12120, "G25 X5 M8"),
    (12120, "G26 S500 F100"),
    (12120, "G110 X5 F100"),
    (12120, "TRANS X5 F100"),
    (12120, "PLAIN X5"),
    (12120, "VARP(R1,2) X5"),
    (12120, "L10 X5"),
    (12120, "RET X5"),
    (12120, "SETMS(1) X5"),
    (12150, r#"DEF INT V|V=1+"A""#),
    (12160, "DEF INT V=3000000000"),
    (12161, "DEF INT LLI 5 ULI 3 V=4"),
    (12170, "DEF INT I|DEF REAL I"),
    (12170, "DEF INT X"),
    (12180, "R1=R2--R3"),
    (12190, "DEF REAL A[2,2,2,2]"),
    (12210, r#"DEF STRING[3] SS="ABCDE""#),
    (12220, r#"DEF STRING[9] SS="A'B100000000'""#),
    (12230, r#"DEF STRING[9] SS="A'H100'""#),
    (12260, "DEF INT A[2]=SET(1,2,3)"),
    (12261, "DEF FRAME FF=CTRANS(X,1)"),
    (12270, "DEFINE G1 AS M3"),
    (12270, "DEFINE ABC AS M3|DEFINE ABC AS M4"),
    (12300, "VARP()"),
    (12310, "AXP()"),
    (12320, "VARP(5)"),
    (12330, "DEF INT I|VARP(I)"),
    (12340, "VARP(R1,2,3)"),
    (12360, "DEF REAL A[3]|VARP(A)"),
    (12390, r#"DEF INT V="A""#),
    (12400, "DEF INT A[2]|A[2]=1"),
    (12410, r#"DEF INT A[2]|A["A"]=1"#),
    (12430, "DEF INT A[40000]"),
    (12420, "DEF INT A2345678901234567890123456789012345"),
    (12470, "G888"),
    (12470, "G[99]=1"),
    (12475, "G[6]=9"),
    (12480, "!%_N_T_MPF|EXTERN PLAIN(INT)|EXTERN PLAIN(REAL)|M30"),
    (12530, "DEFINE M123 AS M3"),
    (12530, "DEFINE G1234 AS M3"),
    (12550, "FOO=3"),
    (12560, "DEF INT V|V=3000000000"),
    (12630, "LAB: IF R1>0|ENDIF"),
    (12630, "IF R1==0|/ENDIF"),
    (12640, "IF R1>0"),
    (12640, "ENDWHILE"),
    (14000, "!G0 X1"),
    (14010, "VARP(,1)"),
    (14011, "FOO"),
    (14012, "REC"),
    (14013, "L10 P0"),
    (14020, "$P_PFRAME=CTRANS(5)"),
    (14021, "R1=SIN(1,2,3)"),
    (14051, "R1=1/0"),
    (14060, "/12 G0 X5"),
    (14065, r#"DEF STRING[9] S|S=SPRINT("%q",1)"#),
    (14080, "GOTOF NIX"),
    (14082, "CALL BLOCK LA TO LB"),
    (14091, "!%_N_T_MPF|RET"),
    (14096, "R1=RTOI(1EX300)"),
    (14097, r#"R1=AXNAME("QQ")"#),
    (14098, r#"R1=NUMBER("ABC")"#),
    (14197, "D1 H5"),
    (14500, "G1 X5 F100|DEF INT I"),
    (14510, "PLAIN(1)"),
    (14520, "!%_N_T_MPF|DEF INT I|PROC TT|M30"),
    (14530, "!%_N_T_MPF|EXTERN SUB(INT)|SUB(1)|M30|%_N_SUB_SPF|PROC SUB(REAL A)|M17"),
    (14660, "SETINT(1) PRIO=200 ABC"),
    (14760, "M3 M4"),
    (15700, "SETAL(5)"),
    (10600, "S5 M3|G33 Z-5 K1|M8|G33 Z-9 K1"),
    (10600, "S5 M3|G33 Z-5 K1|G33 Z-9 K1 S9"),
    (10601, "S5 M3|G33 Z-5 K1 M0|G33 Z-9 K1"),
    (10601, "S5 M3|G33 Z-5 K1|G4 F1|G33 Z-9 K1"),
    (10750, "T0|G41 G1 X0 Y0 F100"),
    (10753, "T1 M6|G2 G41 X10 Y0 CR=5 F100"),
    (10754, "T1 M6|G41 G1 X5 Y5 F100|G40 G2 X10 Y5 CR=20"),
    (10757, "T1 M6|G41 G1 X5 Y5 F100|G18"),
    (10780, "T1 M6|G41 G1 X5 Y5 F100|T2 M6"),
    (10790, "G1 F100 ANG=30|G18|X50 Y20 ANG=40"),
    (10791, "G1 F100 ANG=30|X50 Y20 ANG=30"),
    (10792, "G2 X5 Y5 ANG=30 F100"),
    (10793, "G1 ANG=30 F100|M30"),
    (10794, "G1 ANG=30 F100|X50 Y20"),
    (10795, "G1 X40 Y20 ANG=30 F100"),
    (10860, "G1 X10"),
    (10860, "G94 G1 F200 X5|G95 X10"),
    (10870, "#G96 S100"),
    (10900, "G96 M3|G1 X5 F0.1"),
    (14040, "G2 X10 Y10.5 I10 J0 F100"),
    (14040, "G2 I0 J0 F100"),
    (14040, "G2 X10 Y0 I10 F100"),
    (14040, "G2 X0 Y0 CR=10 F100"),
    (14045, "G1 X10 F100|CT X-5 Y0"),
    (14048, "G3 X10 Y0 I5 Z-5 TURN=-1 F100"),
    (14095, "G2 X30 Y0 CR=10 F100"),
    (17180, "T1 D1.5"),
    (17190, "T1.5"),
    (17191, r#"T="NOPE""#),
    (14200, "G1 RP=-5 AP=0 F100"),
    (14210, "G1 RP=5 AP=400 F100"),
    (14250, "G111 RP=-5 AP=0"),
    (14260, "G111 RP=5 AP=400"),
    (14270, "G17|G111 X0 Z5"),
    (14280, "G1 X10 AP=30 F100"),
    (14414, "GEOAX(5,X)"),
    (14800, "G1 X10 F0"),
    (14810, "FA[X]=-5 POS[X]=5"),
    (14820, "LIMS=-5"),
    (14840, "S-5"),
    (14900, "G3 X10 Y0 I5 AR=90 F100"),
    (14910, "G3 X10 Y0 AR=400 F100"),
    (14920, "CIP X20 Y0 I1=30 J1=0 F100"),
    (16420, "X5 AX[X]=5"),
    (16430, "ROT RPL=30|POS[X]=5 FA[X]=100"),
    (16440, "ROT C5"),
    (16500, "G1 X50 Y0 RND=-2 F100"),
    (16510, "#DIAMON"),
    (16510, "#G0 X=DAC(5)"),
    (16720, "G33 Z5"),
    (16720, "G33 Z5 K0"),
    (16730, "G33 Z5 I1"),
    (16740, "G33 K1"),
    (16720, "S5|G331 Z5"),
    (16720, "S5|G331 Z5 K0"),
    (16730, "S5|G331 Z5 I1"),
    (16740, "S5|G331 K1"),
    (16760, "G331 Z5 K1"),
    (16763, "S0|G331 Z5 K1"),
    (16763, "G331 Z5 K1 S-5"),
    (16800, "G0 X=DC(30)"),
    (16810, "G0 X=ACP(30)"),
    (16820, "G0 X=ACN(30)"),
    (16830, "G0 C0|C=DC(400)"),
    (17020, "R1=$P_UIFR[200,X,TR]"),
    (17070, "$P_EP[X]=5"),
];

fn shown(case: &str) -> String {
    let (machine, case) = match case.strip_prefix('#') {
        Some(rest) => ("", rest),
        None => ("[machine]\ndiameter_axis = \"X\"\n", case),
    };
    let blocks = |text: &str| text.replace('|', "\n");
    let program = match case.strip_prefix('!') {
        Some(rest) => format!("{}\n", blocks(rest)),
        None => {
            // Definitions stand in front of what is executed.
            let declares = |line: &&str| line.starts_with("DEF ");
            let head: Vec<&str> = case.split('|').take_while(declares).collect();
            let rest: Vec<&str> = case.split('|').skip(head.len()).collect();
            format!("%_N_T_MPF\n{}\n{START}{}\nM30\n{CALLED}", head.join("\n"), rest.join("\n"))
        }
    };
    let settings = settings(&format!("{machine}[output]\ncompensation = \"control\"\n"));
    let compiled = compile_bytes("T.MPF", program.into_bytes(), "sinumerik", &settings, &NoFiles);
    compiled.findings.iter().map(|found| format!("{} {}\n", found.code.id, found.text())).collect()
}

#[test]
fn each_finding_names_its_alarm() {
    let nested = format!("{}|{}", ["IF 1"; 17].join("|"), ["ENDIF"; 17].join("|"));
    let long_macro = format!("DEFINE ABC AS {}", "M3 ".repeat(90));
    let more = [(12641, nested.as_str()), (12280, long_macro.as_str())];
    let mut failures = Vec::new();
    for (alarm, case) in CASES.iter().copied().chain(more) {
        let shown = shown(case);
        if !shown.contains(&format!("(alarm {alarm}")) {
            failures.push(format!("{alarm} is not named for {case}:\n{shown}"));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// One state has one alarm, in whatever cycle: no tool is 61009, a tool without an offset 61000.
#[test]
fn cycles_without_a_tool_show_one_alarm() {
    let lathe = settings(
        "[machine]\nkind = \"lathe\"\ndiameter_axis = \"X\"\n[tools.1]\nradius = 0.4\norientation = 3\nwidth = 3.0\n",
    );
    let mill = settings("[tools.1]\nradius = 4.0\n");
    let turning = "G18 G90 DIAMON G95 F0.1 S500 M3";
    let milling = "G17 G90 G94 F100 S500 M3";
    let calls = [
        (&lathe, turning, "CYCLE951(60,0,40,-30,,,1,2,0,0,11,0,0,0,1,0.2,0)"),
        (&lathe, turning, "CYCLE95(\"KA:KE\",1,,,0.2,0.2,,,1,,,1)"),
        (&lathe, turning, "CYCLE93(40,-20,8,5,0,0,0,0,0,0,0,0.1,0.1,2,0.5,5)"),
        (&mill, milling, "POCKET4(10,0,1,-5,10,0,0,2.5,0,0,100,100,0,11)"),
        (&mill, milling, "CYCLE76(10,0,1,,-5,30,20,0,0,0,0,2,0,0,100,100,0,1,40,30)"),
    ];
    for (settings, head, call) in calls {
        for (tool, alarm) in [("", 61009), ("T1\nM6\nD0", 61000)] {
            let program = format!("{head}\n{tool}\nG0 X100 Z50\n{call}\nM30\nKA:\nG1 X20 Z0\nZ-20\nX60\nKE:\n");
            let done = compile_bytes("A.MPF", program.into_bytes(), "sinumerik", settings, &NoFiles);
            let alarms: Vec<_> = done.findings.iter().filter_map(|found| found.alarm).collect();
            assert_eq!(alarms, [alarm], "{call} {tool}: {:#?}", done.rendered);
        }
    }
}
