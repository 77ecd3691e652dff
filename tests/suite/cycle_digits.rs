//! Every digit of every coded argument: changed alone it changes the output, gives a finding, or is documented as one that
//! changes nothing.
//!
//! The table of those that change nothing is docs/cycle-digits.md.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use partc::internals::machine::Settings;

use super::common::{compile_bytes, settings};

const MILL: &str = "T1 M6\nG17 G0 X10 Y20 Z50\nS500 M3\nF120\n";
const HOLES: &str = "T1 M6\nG17 G0 X10 Y20 Z50\nS500 M3\nF120\nMCALL CYCLE81(10,0,2,-15)\n";
const LATHE: &str = "T1 D1\nG18 G90 DIAMON\nG0 X100 Z10\nG97 S400 M3\nG95 F0.15\n";

const GROOVES: &str = "T2 D1\nG18 G90 DIAMON\nG0 X100 Z10\nG97 S400 M3\nG95 F0.15\n";

/// A contour between labels, called by CYCLE62.
const TURNED: &str = "T2 D1\nG18 G90 DIAMON\nG0 X100 Z10\nG97 S400 M3\nG95 F0.15\nGOTOF OVER\nFROM:\nG1 X30 Z1\nZ-20\nX25 Z-25\nZ-35\nUPTO: X50\nOVER:\nCYCLE62(,2,\"FROM\",\"UPTO\")\n";

/// A cutter of 10 mm, and a contour between labels.
const CUTTER: &str =
    "$TC_DP6[1,1]=5\nT1 M6\nG17 G0 X10 Y20 Z50\nS500 M3\nF120\nGOTOF OVER\nFROM:\nG1 X0 Y0\nX40\nY40\nUPTO:\nOVER:\n";

/// A closed contour.
const CLOSED: &str = "$TC_DP6[1,1]=5\nT1 M6\nG17 G0 X10 Y20 Z50\nS500 M3\nF120\nGOTOF OVER\nFROM:\nG1 X0 Y0\nX40\nY40\nX0\nUPTO: Y0\nOVER:\nCYCLE62(,2,\"FROM\",\"UPTO\")\n";

/// The program in front of the call, the call with `#` for the coded argument, the name of the argument and its value.
const CALLS: &[(&str, &str, &str, u32)] = &[
    (TURNED, "CYCLE95(\"FROM:UPTO\",3,0.1,0.2,0,0.3,0.2,0.1,#)", "VARI", 9),
    (TURNED, "CYCLE95(\"FROM:UPTO\",3,0.1,0.2,0,0.3,0.2,0.1,9,0,0,1,#)", "_GMODE", 0),
    (TURNED, "CYCLE95(\"FROM:UPTO\",3,0.1,0.2,0,0.3,0.2,0.1,9,0,0,1,0,#)", "_DMODE", 2),
    (TURNED, "CYCLE951(60,0,50,-20,52,-18,#,3,0.3,0.1,31,0.5,0.5,0.5,1,0.25,2,2,0)", "_LAGE", 1),
    (TURNED, "CYCLE951(60,0,50,-20,52,-18,1,3,0.3,0.1,#,0.5,0.5,0.5,1,0.25,2,2,0)", "_VARI", 31),
    (TURNED, "CYCLE951(60,0,50,-20,52,-18,1,3,0.3,0.1,31,0.5,0.5,0.5,1,0.25,#,2,0)", "_NR", 2),
    (TURNED, "CYCLE951(60,0,50,-20,52,-18,1,3,0.3,0.1,31,0.5,0.5,0.5,1,0.25,2,#,0)", "_DMODE", 2),
    (TURNED, "CYCLE951(60,0,50,-20,52,-18,1,3,0.3,0.1,31,0.5,0.5,0.5,1,0.25,2,2,#)", "_AMODE", 0),
    (
        TURNED,
        "CYCLE952(\"P\",,\"\",#,0.3,0.1,0,3,0,0,0.2,0.1,0.3,0,1,0,0,20,2,80,-30,,,,,0,1,,0,2,110,1,0,0.1)",
        "_VARI",
        1_101_331,
    ),
    (
        TURNED,
        "CYCLE952(\"P\",,\"\",1101331,0.3,0.1,0,3,0,0,0.2,0.1,0.3,0,1,0,0,31,2,44,-30,,,,,0,1,,#,2,110,1,0,0.1)",
        "_GMODE",
        11_111_000,
    ),
    (
        TURNED,
        "CYCLE952(\"P\",,\"\",1101331,0.3,0.1,0,3,0,0,0.2,0.1,0.3,0,1,0,0,20,2,80,-30,,,,,0,1,,0,#,110,1,0,0.1)",
        "_DMODE",
        2,
    ),
    (
        TURNED,
        "CYCLE952(\"P\",,\"\",1101331,0.3,0.1,0,3,0,0,0.2,0.1,0.3,0.1,1,1,2,20,2,80,-30,,,,,0,1,,0,2,#,1,0,0.1)",
        "_AMODE",
        110,
    ),
    (
        TURNED,
        "CYCLE952(\"P\",,\"\",1101331,0.3,0.1,0,3,0,0,0.2,0.1,0.3,0,1,0,0,20,2,80,-30,,,,,0,1,,0,2,110,#,0,0.1)",
        "_PK",
        1,
    ),
    (MILL, "CYCLE81(10,0,2,,15,0.5,#,1,11)", "_GMODE", 0),
    (MILL, "CYCLE81(10,0,2,,15,0.5,0,#,11)", "_DMODE", 1),
    (MILL, "CYCLE81(10,0,2,,15,0.5,0,1,#)", "_AMODE", 11),
    (MILL, "CYCLE82(10,0,2,,15,0.5,#,1,11)", "_GMODE", 0),
    (MILL, "CYCLE82(10,0,2,,15,0.5,0,#,11)", "_DMODE", 1),
    (MILL, "CYCLE82(10,0,2,,15,0.5,0,1,#)", "_AMODE", 11),
    (MILL, "CYCLE82(10,0,2,,15,0.5,0,1,11,#,1,50,2,50)", "_VARI", 0),
    (MILL, "CYCLE83(10,0,2,,40,,20,5,0.5,0.3,50,#,0,1.2,1.4,0.7,1.6,0,1,11111111)", "VARI", 1),
    (MILL, "CYCLE83(10,0,2,,40,,20,5,0.5,0.3,50,1,0,1.2,1.4,0.7,1.6,#,1,11111111)", "_GMODE", 0),
    (MILL, "CYCLE83(10,0,2,,40,,20,5,0.5,0.3,50,1,0,1.2,1.4,0.7,1.6,0,#,11111111)", "_DMODE", 1),
    (MILL, "CYCLE83(10,0,2,,40,,20,5,0.5,0.3,50,1,0,1.2,1.4,0.7,1.6,0,1,#)", "_AMODE", 11_111_111),
    (MILL, "CYCLE84(10,0,2,,15,0.5,5,,1,0,300,300,0,1,0,#,5,1,,,,0,1,1001001)", "_VARI", 1),
    (MILL, "CYCLE84(10,0,2,,15,0.5,5,,1,0,300,300,0,1,#,1,5,1,,,,0,1,1001001)", "_TECHNO", 0),
    (MILL, "CYCLE84(10,0,2,,15,0.5,5,,1,0,300,300,0,1,0,1,5,1,,,,#,1,1001001)", "_GMODE", 0),
    (MILL, "CYCLE84(10,0,2,,15,0.5,5,,1,0,300,300,0,1,0,1,5,1,,,,0,#,1001001)", "_DMODE", 1),
    (MILL, "CYCLE84(10,0,2,,15,0.5,5,,1,0,300,300,0,1,0,1,5,1,,,,0,1,#)", "_AMODE", 1_001_001),
    (MILL, "CYCLE840(10,0,2,,15,0.5,4,3,20,,1.25,,,#,,,,0,1,1)", "_TECHNO", 0),
    (MILL, "CYCLE840(10,0,2,,15,0.5,4,3,20,,1.25,,,,,,,#,1,1)", "_GMODE", 0),
    (MILL, "CYCLE840(10,0,2,,15,0.5,4,3,20,,1.25,,,,,,,0,#,1)", "_DMODE", 1),
    (MILL, "CYCLE840(10,0,2,,15,0.5,4,3,20,,1.25,,,,,,,0,1,#)", "_AMODE", 1),
    (MILL, "CYCLE840(10,0,2,,15,0.5,4,3,#,,1.25,,,,,,,0,1,1)", "ENC", 0),
    (MILL, "CYCLE85(10,0,2,,15,0.5,80,200,#,1,1)", "_GMODE", 0),
    (MILL, "CYCLE85(10,0,2,,15,0.5,80,200,0,#,1)", "_DMODE", 1),
    (MILL, "CYCLE85(10,0,2,,15,0.5,80,200,0,1,#)", "_AMODE", 1),
    (MILL, "CYCLE86(10,0,2,,15,0.5,3,-0.5,0.3,0.8,45,#,1,1)", "_GMODE", 0),
    (MILL, "CYCLE86(10,0,2,,15,0.5,3,-0.5,0.3,0.8,45,0,#,1)", "_DMODE", 1),
    (MILL, "CYCLE86(10,0,2,,15,0.5,3,-0.5,0.3,0.8,45,0,1,#)", "_AMODE", 1),
    (MILL, "CYCLE89(10,0,2,,15,0.5,#,1,1)", "_GMODE", 0),
    (MILL, "CYCLE89(10,0,2,,15,0.5,0,#,1)", "_DMODE", 1),
    (MILL, "CYCLE89(10,0,2,,15,0.5,0,1,#)", "_AMODE", 1),
    (HOLES, "HOLES1(0,0,30,5,10,4,#,,,,1)", "_VARI", 0),
    (HOLES, "HOLES1(0,0,30,5,10,4,0,#,,,1)", "_UMODE", 0),
    (HOLES, "HOLES1(0,0,30,5,10,4,0,,,,#)", "_DMODE", 1),
    (HOLES, "HOLES2(0,0,30,5,40,4,#,,,,1)", "_VARI", 0),
    (HOLES, "HOLES2(0,0,30,5,40,4,0,#,,,1)", "_UMODE", 0),
    (HOLES, "HOLES2(0,0,30,5,40,4,0,,,,#)", "_DMODE", 1),
    (HOLES, "CYCLE801(0,0,30,5,10,4,3,#,0,,,,,1)", "_VARI", 0),
    (HOLES, "CYCLE801(0,0,30,5,10,4,3,0,#,,,,,1)", "_UMODE", 0),
    (HOLES, "CYCLE801(0,0,30,5,10,4,3,0,0,,,,,#)", "_DMODE", 1),
    (HOLES, "CYCLE802(#,111111111,1,2,3,4,,,,,,,,,,,,,,,0,0,1)", "_XA", 111_111_111),
    (HOLES, "CYCLE802(111111111,#,1,2,3,4,,,,,,,,,,,,,,,0,0,1)", "_YA", 111_111_111),
    (HOLES, "CYCLE802(111111111,111111111,1,2,3,4,,,,,,,,,,,,,,,#,0,1)", "_VARI", 0),
    (HOLES, "CYCLE802(111111111,111111111,1,2,3,4,,,,,,,,,,,,,,,0,#,1)", "_UMODE", 0),
    (HOLES, "CYCLE802(111111111,111111111,1,2,3,4,,,,,,,,,,,,,,,0,0,#)", "_DMODE", 1),
    (LATHE, "CYCLE94(20,-30,\"E\",#)", "_VARI", 3),
    (LATHE, "CYCLE96(20,-30,\"A\",#)", "_VARI", 3),
    (LATHE, "CYCLE940(20,-30,\"T\",1,1,0.1,#,2,8,1,0.5,45,30,5,0.3,0,0,,,,2,1011)", "_VARI", 1),
    (LATHE, "CYCLE940(20,-30,\"T\",1,1,0.1,1,2,8,1,0.5,45,30,5,0.3,0,0,,,,#,1011)", "_DMODE", 2),
    (LATHE, "CYCLE940(20,-30,\"T\",1,1,0.1,1,2,8,1,0.5,45,30,5,0.3,0,0,,,,2,#)", "_AMODE", 1011),
    (LATHE, "CYCLE940(20,-30,\"F\",#,1,0.1,,0.1,0.1,,,,40,,,,,0,,,2,11)", "_LAGE", 1),
    (LATHE, "CYCLE940(20,-30,\"F\",1,1,0.1,,0.1,0.1,,,,40,,,,,#,,,2,11)", "_PITI", 0),
    (LATHE, "CYCLE97(1.5,,0,-20,20,20,3,2,0.92,0.05,30,0,5,1,#,1)", "VARI", 3),
    (LATHE, "CYCLE98(0,20,-10,20,-20,22,-30,22,3,2,0.92,0.05,0,0,5,1,1.5,1.5,2,#,1,,,,,1,,,,2,0)", "VARI", 3),
    (LATHE, "CYCLE98(0,20,-10,20,-20,22,-30,22,3,2,0.92,0.05,0,0,5,1,1.5,1.5,2,3,1,,,,,1,,,,#,0)", "_DMODE", 2),
    (LATHE, "CYCLE98(0,20,-10,20,-20,22,-30,22,3,2,0.92,0.05,0,0,5,1,1.5,1.5,2,3,1,,,,,1,,,,2,#)", "_AMODE", 0),
    (LATHE, "CYCLE99(0,20,-20,20,3,2,0.92,0.05,30,0,5,1,1.5,#,1,2,0,0,,,,,,1,,,,102,0)", "_VARI", 1_310_101),
    (LATHE, "CYCLE99(0,20,-20,20,3,2,0.92,0.05,30,0,5,1,1.5,1310101,1,2,0,0,,,,,,1,,,,#,0)", "_DMODE", 102),
    (LATHE, "CYCLE99(0,20,-20,20,3,2,0.92,0.05,30,0,5,1,1.5,1310101,1,2,0,0,,,,,,1,,,,102,#)", "_AMODE", 0),
    (GROOVES, "CYCLE92(40,-50,4,-0.6,2,1,120,2000,4,0.1,0.05,500,,#,,2,10000)", "_VARI", 0),
    (GROOVES, "CYCLE92(40,-50,4,-0.6,2,1,120,2000,4,0.1,0.05,500,,0,,#,10000)", "_DMODE", 2),
    (GROOVES, "CYCLE92(40,-50,4,-0.6,2,1,120,2000,4,0.1,0.05,500,,0,,2,#)", "_AMODE", 10_000),
    (GROOVES, "CYCLE93(80,-40,12,6,0,10,15,0.5,-0.5,0.3,0.3,0.1,0.1,2,0.5,#,1,0)", "VARI", 5),
    (GROOVES, "CYCLE930(80,-40,10,,6,,0,15,20,0.5,0.4,0.6,0.8,0.1,2,1,#,0,2,-20,0.08,1,,,2,1111010)", "_VARI", 10_530),
    (GROOVES, "CYCLE930(80,-40,10,,6,,0,15,20,0.5,0.4,0.6,0.8,0.1,2,1,10530,0,2,-20,0.08,1,,,#,1111010)", "_DMODE", 2),
    (
        GROOVES,
        "CYCLE930(80,-40,10,,6,,0,15,20,0.5,0.4,0.6,0.8,0.1,2,1,10530,0,2,-20,0.08,1,,,2,#)",
        "_AMODE",
        1_111_010,
    ),
    (
        GROOVES,
        "CYCLE930(80,-40,10,,6,,0,15,20,0.5,0.4,0.6,0.8,0.1,2,1,10530,0,2,-20,0.08,1,,,2,1111010,#)",
        "_GMODE",
        0,
    ),
    (CUTTER, "POCKET3(20,5,2,-11,60,40,8,80,60,10,8,0.5,0.2,900,200,0,11,6,0,0,0,0,0,0,0,0,0,#,0)", "_DMODE", 1),
    (CUTTER, "POCKET4(20,5,2,-11,60,80,60,8,0.5,0.2,900,200,0,11,6,0,0,0,0,0,0,0,0,#,0)", "_DMODE", 1),
    (CLOSED, "CYCLE63(\"P\",1,10,0,2,-5,600,200,5,3,0.2,0,0,0,0,4,2,0,0,0,\"\",0,0,0,#,0)", "_DMODE", 1),
    (CUTTER, "CYCLE71(20,5,2,-11,100,90,60,40,10,9,9,5,0.2,4000,#,2)", "_VARI", 31),
    (CUTTER, "CYCLE61(20,5,2,-11,10,20,60,40,8,80,0.2,3000,#,0,1,11010)", "_VARI", 31),
    (CUTTER, "CYCLE61(20,5,2,-11,10,20,60,40,8,80,0.2,3000,31,#,1,11010)", "_LIM", 0),
    (CUTTER, "CYCLE61(20,5,2,-11,10,20,60,40,8,80,0.2,3000,31,0,#,11010)", "_DMODE", 1),
    (CUTTER, "CYCLE61(20,5,2,-11,10,20,60,40,8,80,0.2,3000,31,0,1,#)", "_AMODE", 11_010),
    (CUTTER, "CYCLE76(20,5,2,-11,9,60,40,8,80,60,10,8,0.5,0.2,900,200,1,#,80,50,,,0,1,2)", "_VARI", 1),
    (CUTTER, "CYCLE76(20,5,2,-11,9,60,40,8,80,60,10,8,0.5,0.2,900,200,1,1,80,50,,,#,1,2)", "_GMODE", 0),
    (CUTTER, "CYCLE76(20,5,2,-11,9,60,40,8,80,60,10,8,0.5,0.2,900,200,1,1,80,50,,,0,#,2)", "_DMODE", 1),
    (CUTTER, "CYCLE76(20,5,2,-11,9,60,40,8,80,60,10,8,0.5,0.2,900,200,1,1,80,50,,,0,1,#)", "_AMODE", 2),
    (CUTTER, "CYCLE77(20,5,2,-11,9,50,60,70,8,0.5,0.2,900,200,1,#,60,,,0,1,2)", "_VARI", 1),
    (CUTTER, "CYCLE77(20,5,2,-11,9,50,60,70,8,0.5,0.2,900,200,1,1,60,,,#,1,2)", "_GMODE", 0),
    (CUTTER, "CYCLE77(20,5,2,-11,9,50,60,70,8,0.5,0.2,900,200,1,1,60,,,0,#,2)", "_DMODE", 1),
    (CUTTER, "CYCLE77(20,5,2,-11,9,50,60,70,8,0.5,0.2,900,200,1,1,60,,,0,1,#)", "_AMODE", 2),
    (CUTTER, "CYCLE72(\"FROM:UPTO\",20,5,2,11,6,0.3,0.2,800,200,#,42,2,8,1500,1,6,,,,0,1,1)", "_VARI", 111),
    (CUTTER, "CYCLE72(\"FROM:UPTO\",20,5,2,11,6,0.3,0.2,800,200,111,42,#,8,1500,1,6,,,,0,1,1)", "_AS1", 2),
    (CUTTER, "CYCLE72(\"FROM:UPTO\",20,5,2,11,6,0.3,0.2,800,200,111,42,2,8,1500,#,6,,,,0,1,1)", "_AS2", 1),
    (CUTTER, "CYCLE72(\"FROM:UPTO\",20,5,2,11,6,0.3,0.2,800,200,111,42,2,8,1500,1,6,,,,#,1,1)", "_GMODE", 0),
    (CUTTER, "CYCLE72(\"FROM:UPTO\",20,5,2,11,6,0.3,0.2,800,200,111,42,2,8,1500,1,6,,,,0,#,1)", "_DMODE", 1),
    (CUTTER, "CYCLE72(\"FROM:UPTO\",20,5,2,11,6,0.3,0.2,800,200,111,42,2,8,1500,1,6,,,,0,1,#)", "_AMODE", 1),
    (CUTTER, "CYCLE70(20,5,2,-11,20,0.92,0.1,1.5,1,0.5,300,1,30,40,45,#,1,,,,0,1,0)", "_VARI", 1),
    (CUTTER, "CYCLE70(20,5,2,-11,20,0.92,0.1,1.5,1,0.5,300,1,30,40,45,1,1,,,,#,1,0)", "_GMODE", 0),
    (CUTTER, "CYCLE70(20,5,2,-11,20,0.92,0.1,1.5,1,0.5,300,1,30,40,45,1,1,,,,0,#,0)", "_DMODE", 1),
    (CUTTER, "CYCLE70(20,5,2,-11,20,0.92,0.1,1.5,1,0.5,300,1,30,40,45,1,1,,,,0,1,#)", "_AMODE", 0),
];

/// Digits of a whole number of an argument.
const PLACES: u32 = 9;

/// The moves and what is said.
fn result(head: &str, call: &str, value: &str) -> (Vec<String>, Vec<String>) {
    let settings = if [LATHE, GROOVES, TURNED].contains(&head) {
        settings(
            "[machine]\nkind = \"lathe\"\ndiameter_axis = \"X\"\n[tools.1]\nradius = 0.0\n[tools.2]\nwidth = 4.0\nradius = 0.2\norientation = 3\n",
        )
    } else {
        Settings::default()
    };
    let text = format!("{head}{}\nM30\n", call.replace('#', value));
    let compiled =
        compile_bytes("PART.MPF", text.into_bytes(), "sinumerik", &settings, &partc::internals::text::files::NoFiles);
    let moves = compiled.output.lines().filter(|line| !line.starts_with('(')).map(str::to_owned).collect();
    let said = compiled.findings.iter().map(|found| format!("{} {}", found.code.id, found.text())).collect();
    (moves, said)
}

/// Rows of the table: cycle, argument, place of the digit from the right, its values.
fn documented() -> BTreeSet<(String, String, u32, u32)> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/cycle-digits.md");
    let text = fs::read_to_string(path).expect("the table");
    let mut list = BTreeSet::new();
    for line in text.lines().filter(|line| line.starts_with("| ")) {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        let [cycles, name, places, values, _] = cells[..] else { panic!("five cells: {line}") };
        if cycles == "cycle" || cycles.starts_with("--") {
            continue;
        }
        let numbers = |cell: &str| -> Vec<u32> {
            match cell.split_once(" to ") {
                Some((from, to)) => (from.parse().expect("a number")..=to.parse().expect("a number")).collect(),
                None => cell.split_whitespace().map(|n| n.parse().expect("a number")).collect(),
            }
        };
        for cycle in cycles.split(' ') {
            for place in numbers(places) {
                for value in numbers(values) {
                    list.insert((cycle.to_owned(), name.trim_matches('`').to_owned(), place, value));
                }
            }
        }
    }
    list
}

#[test]
fn no_digit_is_ignored_in_silence() {
    let mut silent = BTreeSet::new();
    for (head, call, name, value) in CALLS {
        let cycle = call.split('(').next().expect("a name").to_owned();
        let base = result(head, call, &value.to_string());
        let errors = base.1.iter().filter(|said| said.starts_with("S9") || said.starts_with("S2"));
        assert_eq!(errors.count(), 0, "{call} with {value} is refused: {:?}", base.1);
        for place in 0..PLACES {
            let power = 10_u32.pow(place);
            let here = value / power % 10;
            for digit in (0..10).filter(|digit| *digit != here) {
                let changed = value - here * power + digit * power;
                if result(head, call, &changed.to_string()) == base {
                    silent.insert((cycle.clone(), (*name).to_owned(), place + 1, digit));
                }
            }
        }
    }
    let documented = documented();
    let missing: Vec<_> = silent.difference(&documented).collect();
    let stale: Vec<_> = documented.difference(&silent).collect();
    assert!(missing.is_empty(), "these change nothing, and docs/cycle-digits.md does not say so: {missing:#?}");
    assert!(stale.is_empty(), "these change something, and docs/cycle-digits.md says they do not: {stale:#?}");
}
