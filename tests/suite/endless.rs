//! Programs that never end, or would take days: every run stops soon, with a finding that says why.

use std::time::{Duration, Instant};

use partc::internals::machine::Settings;
use partc::internals::text::{FileError, Files, Memory, Opened, Request};

use super::common::{Compiled, compile_bytes, settings};

/// What a run of so few steps may take, even unoptimized and on a busy machine.
const SOON: Duration = Duration::from_secs(20);

/// A hundredth of the usual limit.
fn few() -> Settings {
    settings("[limits]\nsteps = 100_000\n")
}

/// Calls find a short program, but none that stands in for a cycle.
struct Short(&'static str);

const CYCLES: [&str; 5] = ["CYCLE", "HOLES", "POCKET", "SLOT", "LONGHOLE"];

impl Files for Short {
    fn open(&self, request: &Request<'_>) -> Result<Opened, FileError> {
        // The same program lies in all folders, with whatever ending, and by the name that it has on the control.
        let name = request.name.rsplit('/').next().unwrap_or(request.name).to_ascii_uppercase();
        let name = match name.strip_prefix("_N_").and_then(|name| name.rsplit_once('_')) {
            Some((stem, ending)) => format!("{stem}.{ending}"),
            None => name,
        };
        if CYCLES.iter().any(|cycle| name.starts_with(cycle)) {
            return Err(FileError::NotFound { tried: Vec::new(), similar: Vec::new() });
        }
        let text = Box::new(Memory::new(self.0.as_bytes().to_vec()));
        let identity = name.split('.').next().unwrap_or(&name).to_owned();
        Ok(Opened { name, identity, text })
    }
}

fn stops(dialect: &str, name: &str, program: &str, settings: &Settings) -> Compiled {
    let called = if dialect == "mtc200" { "RTS\n" } else { "0 BEGIN PGM S MM\n1 END PGM S MM\n" };
    let start = Instant::now();
    let compiled = compile_bytes(name, program.as_bytes().to_vec(), dialect, settings, &Short(called));
    let took = start.elapsed();
    let head: String = program.chars().take(300).collect();
    assert!(took < SOON, "{dialect} took {took:?}: {head}");
    assert!(compiled.has_errors(), "{dialect} ended by itself: {head}");
    let limited = compiled.codes().iter().any(|code| matches!(*code, "P4001" | "P4002"));
    assert!(limited, "{dialect}: {:?} in {head}", compiled.rendered);
    compiled
}

// SINUMERIK.

const SPINDLE: &str = "G17 G0 X0 Y0 Z10\nF100 S100 M3\n";

fn sinumerik(body: &str) -> Compiled {
    stops("sinumerik", "P.MPF", body, &few())
}

#[test]
fn sinumerik_patterns_in_a_loop() {
    for pattern in [
        "HOLES1(0,0,0,1,1,99999)",
        "HOLES2(0,0,50,0,0.0036,99999)",
        "CYCLE801(0,0,0,1,1,300,300)",
        "HOLES1(0,0,0,1,1,9)",
    ] {
        for cycle in [
            "CYCLE81(10,0,2,-5)",
            "CYCLE83(10,0,2,-50,,,1,,0.01,0,0,1,0)",
            "CYCLE83(10,0,2,-50,,,.000001,,.000001,0,0,1,0)",
        ] {
            sinumerik(&format!("{SPINDLE}MCALL {cycle}\nLOOP\n{pattern}\nENDLOOP\n"));
        }
    }
}

#[test]
fn sinumerik_loops() {
    let long = vec!["R1*0"; 5000].join("+");
    let many: String = (0..70_000).map(|n| format!("L{n}: G1 X{n} F100\n")).collect();
    let skipped = "R1=1\n".repeat(2000);
    for body in [
        "AA:\nGOTOB AA\n".to_owned(),
        "AA:\nBB:\nCC:\nG91 G1 X1 F100\nREPEAT CC P=9999\nREPEAT BB P=9999\nREPEAT AA P=9999\nM30\n"
            .replace("G91", "G90 G0 X0\nG91"),
        "FOR R1=1 TO 9999\nFOR R2=1 TO 9999\nG90 G0 X=R2\nENDFOR\nENDFOR\n".to_owned(),
        format!("R1=1\nAA:\nR1={long}\nGOTOB AA\n"),
        format!("{many}GOTOB L0\n"),
        format!("LOOP\nIF 0\n{skipped}ENDIF\nR2=1\nENDLOOP\n"),
        "DEF REAL A[32767]\nLOOP\nA[0]=REP(1)\nENDLOOP\n".to_owned(),
        "DEF STRING[200] TXT=\"a\"\nLOOP\nTXT=TXT<<\"b\"\nTXT=\"a\"\nENDLOOP\n".to_owned(),
        "LOOP\nIF ISFILE(\"NOPE.SPF\")\nENDIF\nENDLOOP\n".to_owned(),
        "LOOP\nEXECSTRING(\"R1=R1+1\")\nENDLOOP\n".to_owned(),
    ] {
        sinumerik(&body);
    }
}

#[test]
fn sinumerik_cycles_with_tiny_infeeds_in_a_loop() {
    for cycle in [
        "CYCLE97(2,,0,-50,40,40,5,5,1.2,0,30,0,999,2,3,1)",
        "CYCLE97(2,,0,-50,40,40,5,5,1.2,0,30,0,99999999,2,3,1)",
        "CYCLE94(20,0,1)",
    ] {
        let settings = settings("[limits]\nsteps = 100_000\n[machine]\nkind = \"lathe\"\ndiameter_axis = \"X\"\n");
        let body = format!("G18 G95 F0.1\nT1 D1\nG0 X100 Z10\nS100 M3\nLOOP\n{cycle}\nENDLOOP\n");
        let start = Instant::now();
        let compiled = compile_bytes("P.MPF", body.into_bytes(), "sinumerik", &settings, &Short(""));
        assert!(start.elapsed() < SOON, "{cycle} took {:?}", start.elapsed());
        assert!(compiled.has_errors(), "{cycle}");
    }
}

#[test]
fn sinumerik_milling_cycles_of_very_many_cuts() {
    for body in [
        // One call alone, and calls in a loop.
        "SLOT1(10,0,2,,5,1000,5000,12,0,0,2000,0,0,100,300,0.001,2,0,1,0.001)",
        "POCKET4(10,0,2,-5,2000,0,0,0.001,0,0,300,100,0,11,0.3)",
        "CYCLE71(10,0,2,-5,0,0,900,900,0,0.001,0.1,5,0,300,31,5)",
        "CYCLE70(10,0,2,-200,60,2,0,0.5,2,0.001,300,0,0,0,0,1,1)",
        "LOOP\nPOCKET4(10,0,2,-5,24,0,0,0.01,0,0,300,100,0,11,0.5)\nENDLOOP",
        "LOOP\nCYCLE77(10,0,2,-5,,20,0,0,0.001,0,0,300,100,0,1,21,0,0,0,1,2)\nENDLOOP",
        "LOOP\nLONGHOLE(10,0,2,,5,5,30,0,0,30,0,0,100,300,0.01)\nENDLOOP",
    ] {
        sinumerik(&format!("{SPINDLE}$TC_DP6[1,1]=5\nT1 D1\nM6\nG0 X0 Y0 Z20\n{body}\nM30\n"));
    }
}

#[test]
fn a_full_output_stops_the_run() {
    let settings = settings("[limits]\noutput_blocks = 1000\n");
    let body = format!("{SPINDLE}MCALL CYCLE81(10,0,2,-5)\nLOOP\nHOLES1(0,0,0,1,1,99999)\nENDLOOP\n");
    let compiled = stops("sinumerik", "P.MPF", &body, &settings);
    assert!(compiled.codes().contains(&"P4002") && !compiled.codes().contains(&"P4001"), "{:?}", compiled.rendered);
    assert!(compiled.attempt.lines().count() < 1010);
}

/// An error in a loop is found a thousand times as well as ten million times: what is left after it is a tenth of the limit.
#[test]
fn a_loop_with_an_error_stops_early() {
    for (dialect, name, body) in [
        ("mtc200", "P.npg", "@001=0\n.A @001=@001+1\nMX\nBRA .A\nRET\n"),
        ("sinumerik", "P.MPF", "R1=0\nAA:\nR1=R1+1\nIF R1==5\nG777\nENDIF\nGOTOB AA\nM30\n"),
        ("klartext", "P.H", "0 BEGIN PGM P MM\n1 LBL 1\n2 L X+5 R5\n3 FN 9: IF +0 EQU +0 GOTO LBL 1\n4 END PGM P MM\n"),
        ("heidenhain-turning", "P.nc", "G94 F100\n#1=1\nWHILE #1==1\nG777\nENDWHILE\nM30\n"),
    ] {
        let compiled = stops(dialect, name, body, &few());
        let told = compiled.rendered.iter().any(|found| found.contains("after an error only 10000 "));
        assert!(told, "{dialect}: {:?}", compiled.rendered);
    }
}

/// A text that is executed costs more than a block that was read before, and a label more than no label: fewer of them are run.
#[test]
fn texts_and_labels_cost_what_they_take() {
    let settings = few();
    let passes = |body: &str| {
        let compiled = stops("sinumerik", "P.MPF", body, &settings);
        let found = compiled.findings.iter().find(|found| found.code.id == "P4001").expect("the limit");
        found.label.text.trim_matches(|c: char| !c.is_ascii_digit()).parse::<u64>().expect("a number of jumps")
    };
    let plain = passes("L1:\nR1=R1+1\nGOTOB L1\nM30\n");
    let text = passes("L1:\nEXECSTRING(\"R1=R1+1\")\nGOTOB L1\nM30\n");
    assert!(text * 4 < plain, "{text} passes with a text, {plain} without");
    // More blocks than are kept.
    let labels: String = (0..70_000).map(|n| format!("L{n}: R1={}\n", n % 9)).collect();
    assert!(passes(&format!("{labels}GOTOB L0\n")) <= 1);
}

// Plain G-code.

#[test]
fn arcs_of_many_turns_count_as_work() {
    let arc = "G3 X10 Y0 I-10 J0 Z-1 P20000 F100\n";
    let text = format!("G21 G90 G94 G17\nG0 X10 Y0 Z0\n{}M2\n", arc.repeat(3));
    for target in ["linuxcnc", "grbl", "fanuc", "heidenhain"] {
        let settings = self::settings(&format!("[limits]\nsteps = 200_000\n[output]\ntarget = \"{target}\"\n"));
        let compiled = stops("gcode", "P.ngc", &text, &settings);
        assert!(compiled.codes().contains(&"P4001"), "{target}: {:?}", compiled.rendered);
    }
}

/// The lines over the limit are not made: an arc in very many parts stops inside.
#[test]
fn a_full_output_stops_an_arc() {
    for target in ["grbl", "fanuc", "heidenhain"] {
        let text = "G21 G90 G94 G17\nG0 X10 Y0 Z0\nG3 X10 Y0 I-10 J0 P100000 F100\nM2\n";
        let settings = self::settings(&format!("[limits]\noutput_blocks = 500\n[output]\ntarget = \"{target}\"\n"));
        let compiled = stops("gcode", "P.ngc", text, &settings);
        assert!(compiled.codes().contains(&"P4002"), "{target}: {:?}", compiled.rendered);
        assert!(compiled.attempt.lines().count() < 1500, "{target}: {} lines", compiled.attempt.lines().count());
    }
}

// Klartext.

/// A drilling cycle with pecks of `step`, and `body` again and again.
fn holes(step: &str, body: &str) -> String {
    format!(
        "0 BEGIN PGM P MM\n1 TOOL CALL 1 Z S1000 F100\n2 L X+0 Y+0 Z+50 R0 FMAX M3\n3 CYCL DEF 200 DRILLING ~\n Q200=+2 ;A ~\n \
         Q201=-20 ;A ~\n Q206=+150 ;A ~\n Q202={step} ;A ~\n Q210=+0 ;A ~\n Q203=+0 ;A ~\n Q204=+50 ;A ~\n Q211=+0 ;A\n4 LBL \
         1\n{body}\n8 CALL LBL 1 REP 65000\n9 END PGM P MM\n"
    )
}

#[test]
fn klartext_patterns_in_a_loop() {
    let grid = "5 CYCL DEF 221 PATTERN ~\n Q225=+0 ;A ~\n Q226=+0 ;A ~\n Q237=+1 ;A ~\n Q238=+1 ;A ~\n Q242=+255 ;A ~\n Q243=+255 ;A ~\n \
                Q224=+0 ;A ~\n Q200=+2 ;A ~\n Q203=+0 ;A ~\n Q204=+50 ;A ~\n Q301=+1 ;A";
    let circle = "5 CYCL DEF 220 PATTERN ~\n Q216=+0 ;A ~\n Q217=+0 ;A ~\n Q244=+80 ;A ~\n Q245=+0 ;A ~\n Q246=+360 ;A ~\n Q247=+0 ;A \
                  ~\n Q241=+65535 ;A ~\n Q200=+2 ;A ~\n Q203=+0 ;A ~\n Q204=+50 ;A ~\n Q301=+1 ;A";
    let places = "5 PATTERN DEF PAT1 (X+0 Y+0 DX+1 NUMX255 DY+1 NUMY255 ROT+0 ROTX+0 ROTY+0 Z+0)\n6 CYCL CALL PAT F100";
    for pattern in [grid, circle, places] {
        for step in ["+20", "+0.01", "+0.000001"] {
            let compiled = stops("klartext", "P.H", &holes(step, pattern), &few());
            assert!(compiled.findings.len() < 10, "{:?}", compiled.rendered);
        }
    }
}

#[test]
fn klartext_loops() {
    let long = vec!["Q1"; 5000].join(" + ");
    let many: String = (2..70_000).map(|n| format!("{n} L X+{} R0 F100\n", n % 100)).collect();
    for body in [
        "1 LBL 1\n2 LBL 2\n3 LBL 3\n4 CALL LBL 3 REP 65534\n5 CALL LBL 2 REP 65534\n6 CALL LBL 1 REP 65534".to_owned(),
        "1 LBL 1\n2 FN 9: IF +0 EQU +0 GOTO LBL 1".to_owned(),
        format!("1 LBL 1\n{many}70001 FN 9: IF +0 EQU +0 GOTO LBL 1"),
        format!("1 Q1 = 0\n2 LBL 1\n3 Q1 = {long}\n4 FN 9: IF +0 EQU +0 GOTO LBL 1"),
        "1 LBL 1\n2 CALL PGM S.H\n3 FN 9: IF +0 EQU +0 GOTO LBL 1".to_owned(),
    ] {
        stops("klartext", "P.H", &format!("0 BEGIN PGM P MM\n{body}\n99 END PGM P MM\n"), &few());
    }
}

// HEIDENHAIN turning.

#[test]
fn turning_loops_and_tiny_infeeds() {
    let settings = settings(
        "[limits]\nsteps = 100_000\n[machine]\nkind = \"lathe\"\n[tools.1]\nkind = \"turn\"\nradius = 0.4\norientation = 3\n",
    );
    let head = "T1\nG97 S500 M3\nG95 F0.2\nG0 X100 Z2\n";
    for body in [
        "#1=1\nWHILE #1==1\n#2=1\nENDWHILE\n",
        "#1=1\nWHILE #1==1\nG0 X50\nG0 X60\nENDWHILE\n",
        "#1=1\nWHILE #1==1\nIF #1==2\n#2=1\n#2=1\n#2=1\nENDIF\nENDWHILE\n",
        "#1=1\nWHILE #1==1\nG31 X50 Z-900 F1.5 P1 I0.0001\nENDWHILE\n",
    ] {
        let start = Instant::now();
        let text = format!("{head}{body}M30\n");
        let compiled = compile_bytes("P.ncs", text.into_bytes(), "heidenhain-turning", &settings, &Short(""));
        assert!(start.elapsed() < SOON, "{body} took {:?}", start.elapsed());
        assert!(compiled.has_errors(), "{body}: {}", compiled.attempt);
    }
}

// MTC200.

#[test]
fn mtc200_loops() {
    let long = vec!["@001"; 5000].join("+");
    let many: String = (0..70_000).map(|n| format!(".L{n} G01 X{n} F100\n")).collect();
    for body in [
        ".A BRA .A\nRET\n".to_owned(),
        "G90 G94 G00 X0 Y0\nG01 F100\n.A G91 X1\nX-1\nBRA .A\nRET\n".to_owned(),
        "G90 G94 G00 X0 Y0\nG01 F100\n.A G90 G02 X10 Y0 R5\nG02 X0 R5\nBRA .A\nRET\n".to_owned(),
        format!("G90 G94\n{many}BRA .L0\nRET\n"),
        format!("@001=0\n.A @001={long}\nBRA .A\nRET\n"),
        ".A JSR P7\nBRA .A\nRET\n".to_owned(),
        "@001=1\n.A BSR .B\nBRA .A\nRET\n.B BSR .C\nRTS\n.C @002=1\nBNE .D\n.D RTS\n".to_owned(),
    ] {
        stops("mtc200", "P.npg", &body, &few());
    }
}

// Errors in loops.

/// What was reported once costs little more than a block, and no more than the limit allows.
#[test]
fn errors_that_come_again_are_paid_for() {
    let unknown = |call: &dyn Fn(usize) -> String, n: usize| (0..n).map(call).collect::<String>();
    let labels = unknown(&|n| format!("CALL LBL {}\n", n + 10), 500);
    let klartext = format!("0 BEGIN PGM A MM\nLBL 1\n{labels}FN 9: IF +0 EQU +0 GOTO LBL 1\nEND PGM A MM\n");
    let calls = unknown(&|n| format!("CYCLEUNKNOWN{n}(1,{n})\n"), 5000);
    let sinumerik = format!("G17 G90 G54 G0 X0 Y0\nLOOP\n{calls}ENDLOOP\nM30\n");
    for (dialect, name, program) in [("klartext", "A.H", klartext), ("sinumerik", "A.MPF", sinumerik)] {
        let start = Instant::now();
        let compiled = compile_bytes(name, program.into_bytes(), dialect, &settings(""), &Short(""));
        let took = start.elapsed();
        assert!(compiled.has_errors() && took < SOON, "{dialect} took {took:?}");
    }
}
