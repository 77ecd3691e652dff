//! What would never end, or is larger than any program: how soon it is refused, and what that takes.

use std::fmt::Write as _;
use std::fs::{self, File};
use std::io::Write as _;
use std::path::Path;
use std::time::Duration;

use super::process::{Took, folder, run};

/// Time after which a run is ended from outside.
const MOST: Duration = Duration::from_secs(120);

/// Programs without an end, at the limits that hold when nobody says otherwise.
pub fn endless(partc: &Path, under: &Path) -> Vec<(&'static str, Took)> {
    let folder = folder(under, "endless");
    let klartext = |body: &str| format!("0 BEGIN PGM P MM\n1 L X+0 Y+0 Z+0 R0 F100\n{body}\n99 END PGM P MM\n");
    let repeats = "2 LBL 1\n3 LBL 2\n4 LBL 3\n5 L IX+0.001\n6 CALL LBL 3 REP 65534\n7 CALL LBL 2 REP 65534\n8 CALL LBL 1 REP 65534";
    let nested =
        "G90 G94 G0 X0\nAA:\nBB:\nCC:\nG91 G1 X0.001 F100\nREPEAT CC P=9999\nREPEAT BB P=9999\nREPEAT AA P=9999\nM30\n";
    let programs = [
        ("nested REP 65534", "REP.H", klartext(repeats)),
        ("FN 9 to its own label", "FN.H", klartext("2 LBL 1\n3 FN 9: IF +0 EQU +0 GOTO LBL 1")),
        ("a program that calls itself", "SELF.H", klartext("2 CALL PGM SELF.H")),
        ("GOTOB to itself", "GOTOB.MPF", "AA:\nGOTOB AA\n".to_owned()),
        ("WHILE TRUE", "WHILE.MPF", "WHILE TRUE\nR1=R1+1\nENDWHILE\nM30\n".to_owned()),
        ("nested REPEAT P=9999", "REPEAT.MPF", nested.to_owned()),
        ("BRA to itself", "BRA.npg", ".A BRA .A\nRET\n".to_owned()),
        ("WHILE of a lathe", "WHILE.ncs", "#1=1\nWHILE #1==1\n#2=1\nENDWHILE\nM30\n".to_owned()),
    ];
    programs
        .into_iter()
        .map(|(what, name, text)| {
            fs::write(folder.join(name), text).expect("a program");
            (what, run(partc, &folder, &["compile", name, "--format", "concise"], MOST))
        })
        .collect()
}

/// Formulas: 200 levels are computed, a million brackets are refused.
pub fn deep(partc: &Path, under: &Path) -> [(usize, &'static str, Took); 4] {
    let folder = folder(under, "deep");
    [(200, true), (1_000_000, true), (200, false), (1_000_000, false)].map(|(levels, klartext)| {
        let (open, close) = ("(".repeat(levels), ")".repeat(levels));
        let (name, text) = if klartext {
            ("D.H", format!("0 BEGIN PGM D MM\n1 Q1 = {open}1{close}\n2 L X+Q1 R0 F100\n3 END PGM D MM\n"))
        } else {
            ("D.MPF", format!("R1={open}1{close}\nG90 G94 G1 X=R1 F100\nM30\n"))
        };
        fs::write(folder.join(name), text).expect("a program");
        (levels, name, run(partc, &folder, &["compile", name, "--format", "concise"], MOST))
    })
}

/// A line of more than a mebibyte in each language.
pub fn long_lines(partc: &Path, under: &Path) -> [(&'static str, Took); 4] {
    let folder = folder(under, "lines");
    [
        ("L.H", "0 BEGIN PGM L MM\n1 L ", "X+1 ", "\n2 END PGM L MM\n"),
        ("L.MPF", "G90\nG1 ", "X1 ", "\nM30\n"),
        ("L.ncs", "G90\nG1 ", "X1 ", "\nM30\n"),
        ("L.npg", "G90\nG01 ", "X1 ", "\nRET\n"),
    ]
    .map(|(name, head, word, tail)| {
        fs::write(folder.join(name), [head, &word.repeat((1 << 20) / word.len() + 10), tail].concat())
            .expect("a program");
        (name, run(partc, &folder, &["compile", name, "--format", "concise"], MOST))
    })
}

/// A program of so many MiB: checked, and compiled.
pub fn giant(partc: &Path, under: &Path, mib: usize) -> (Took, Took) {
    let folder = folder(under, "giant");
    let mut block = String::new();
    for n in 0..20_000 {
        let _ = writeln!(block, "L X+{}.125 Y-{}.5 Z-{}.25", n % 977, n % 613, n % 31);
    }
    let mut file = File::create(folder.join("G.H")).expect("a file");
    file.write_all(b"0 BEGIN PGM G MM\nL X+0 Y+0 Z+5 R0 F800\n").expect("room on the disk");
    for _ in 0..(mib << 20) / block.len() {
        file.write_all(block.as_bytes()).expect("room on the disk");
    }
    file.write_all(b"END PGM G MM\n").expect("room on the disk");
    drop(file);
    let checked = run(partc, &folder, &["check", "G.H", "--format", "concise"], MOST);
    let compiled = run(partc, &folder, &["compile", "G.H", "--output", "/dev/null"], MOST);
    fs::remove_dir_all(&folder).expect("the folder is emptied");
    (checked, compiled)
}
