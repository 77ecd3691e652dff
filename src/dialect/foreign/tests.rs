use super::super::read_as;
use super::*;

fn kind(name: &str, head: &str) -> Option<&'static str> {
    read_as(name, head.as_bytes()).filter(|dialect| dialect.is_foreign()).map(|dialect| dialect.name)
}

#[test]
fn each_kind_is_told_by_its_marks() {
    for (name, head, is) in [
        ("P.nc", "%\nO1000 (PART)\nG21 G17 G40 G80 G90\n", "Fanuc or Haas"),
        ("P.nc", "%\n:0097\n( FANUC 0M)\n#501=350.(DIA.)\n", "Fanuc or Haas"),
        ("P.MPF", "O1234\nG91 G28 Z0\nG43 H1 Z50.\n", "Fanuc or Haas"),
        ("P.nc", "G0 X1\nG81 G98 Z-10. R2. F100\nG28 U0 W0\n", "Fanuc or Haas"),
        ("P.txt", "%\nO0001\nG65 P9010 A1.\n", "Fanuc or Haas"),
        ("P.gcode", ";FLAVOR:Marlin\nG28\nM104 S200\n", "3-D printer"),
        ("P.nc", "M104 S200\nG92 E0\nG1 X1 E0.5\n", "3-D printer"),
        ("P.nc", "G21 G90 G17\nG0 X1\n", "plain G-code"),
        ("P.nc", "(PART)\nG21\nG0 X1\n", "plain G-code"),
        ("P.MPF", "G291\nG43 H1 Z5\n", "ISO dialect of SINUMERIK"),
        ("P.nc", "N5 G17 G90 G71\nN10 T1 D1\nN35 CYCLE81(10,0,2,-5)\n", "SINUMERIK under another name"),
        ("P.nc", "G17 G90\nDEF REAL A\nIF A>1 GOTOF E1\n", "SINUMERIK under another name"),
        ("P.gcode", "N10 T=\"MILL10\"\nN40 G2 X10 Y10 CR=20\n", "SINUMERIK under another name"),
        ("P.nc", "$NAME.MIN%\nG15 H1\n", "Okuma OSP"),
        ("P.nc", "NAT01\nCALL OBORE\n", "Okuma OSP"),
        ("P.H", "%FLANGE G71 *\nN10 G30 G17 X+0 Y+0 Z-40 *\n", "HEIDENHAIN DIN/ISO"),
        ("P.nc", "%MPF 90\nN1 @371 R52 K2 K0\n", "SINUMERIK 810, 850 or 880"),
        ("P.nc", "%PM\nN9000 (PHILIPS)\n", "Philips or MillPlus"),
        ("serial.h", "/* serial */\n#ifndef SERIAL_H\n#define SERIAL_H\ntool = 3;\n", "C or C++"),
        ("P.MPF", "<?xml version=\"1.0\"?>\n<a/>\n", "XML or HTML"),
        ("P.H", "{\n  \"a\": 1\n}\n", "JSON"),
        ("P.MPF", "PK\u{3}\u{4}junk", "ZIP"),
        ("A.ARC", "@@MMCIBN.\n%_N_OEM_MPF\n", "archives of an operator panel"),
        ("P.MPF", "The holes are drilled first.\nThen the pocket is milled.\nUse the long tool for it.\n", "text"),
    ] {
        assert_eq!(kind(name, head), Some(is), "{head}");
    }
}

/// What a program of ours may hold, and what looks like another control at first sight.
#[test]
fn a_program_of_ours_is_never_taken_for_another() {
    for (name, head) in [
        ("P.MPF", "N10 G17 G90 G54\nO1234\nM30\n"),
        ("P.MPF", "G291\nG0 X=R1\n"),
        ("P.MPF", "G54 G90\nG291\nG1 X10\nM30\n"),
        ("P.MPF", "G54 G90\nG291\nM98 P1000\nG43 H1\nG290\nM30\n"),
        ("P.MPF", "%\nO1000\nDEF REAL A\nG43 H1\n"),
        ("P.MPF", "M104 S200\nG1 E5\nR1=2\n"),
        ("P.MPF", "; The part is turned\n; in one clamping of\n; the main spindle only\nG0 X1\n"),
        ("P.H", "1 L X+0 Y+0 R0 FMAX M104\n2 L Z+5\n"),
        ("P.H", "0 BEGIN PGM A MM\n1 ;FLAVOR:Marlin\n2 END PGM A MM\n"),
        ("P.nc", "N1 G0 X50 Z2\nN2 G81 X10 Z-20 P2 I0.4\nN3 M30\n"),
        ("P.nc", "N1 #1=5\nN2 G21 X80 Z100\n"),
        ("P.npg", "G17 G90 G54\nG43 H1\n"),
        ("P.ngc", "%\nO100 sub\nG43 H1\nG81 G98 Z-1 R1\nO100 endsub\n"),
        ("P.gcode", "%\nG21 G90\nG43 H1\n"),
        ("P.txt", "N10 G17 G90 G54\nN20 G0 X0\n"),
    ] {
        assert_eq!(kind(name, head), None, "{head}");
    }
}

#[test]
fn lines_are_counted_as_an_editor_counts_them() {
    let numbers: Vec<(u32, u32)> = line::lines(b"\xef\xbb\xbfA\r\n\r\nB\rC\n").map(|l| (l.number, l.start)).collect();
    assert_eq!(numbers, [(1, 3), (3, 8), (4, 10)]);
}
