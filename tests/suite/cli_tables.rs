//! `partc tools`, and tables of controls as `[tools] table` and `[control] datum_table`.

use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};
use std::time::Duration;

use super::cli_run::{Folder, RADIUS};

const TOOL_T: &str = "BEGIN TOOL    .T MM\n\
    T    NAME             L         R          R2        DL       DR       ANGLE T-ANGLE\n\
    5    MILL D10         +80,5     +5         +0,5               -0,02    5\n\
    5.2  MILL D10 B       +70       +5\n\
    7    DRILL            +120      +3.4                                         118\n[END]\n";

const TO_INI: &str = "%_N_TO_INI\n;$PATH=/_N_TOA_DIR\nCHANDATA(1)\n$TC_TP1[3]=1\n$TC_TP2[3]=\"MILL; D8\"\n\
    N40 $TC_DP1[3,1]=120\n$TC_DP3[3,1]=110.25\n$TC_DP6[3,1]=4\n$TC_DP15[3,1]=-2.5EX-2\n\
    $TC_DP6[3,2]=3.5\nM17\n";

/// Lines of the output of `partc tools`.
fn shown(folder: &Folder, args: &[&str]) -> String {
    let mut all = vec!["tools"];
    all.extend(args);
    folder.run(&all).exits(0).out.clone()
}

#[test]
fn each_table_in_one_form() {
    let folder = Folder::new("tables").with(&[
        ("TOOL.T", TOOL_T),
        ("TO.INI", TO_INI),
        ("tool.tbl", "T1 P1 D6.0 Z+50.5 Q2 ;6 mm end mill\nT12 D.5 X0\n"),
        ("tools.csv", "number;name;diameter;unit\n4;\"A; B\";10,5;mm\n"),
        ("NULL.D", "BEGIN NULL.D MM\nNR    X      Y      Z     DOC\n0     +1     -2,5   +0    left vice\n[END]\n"),
        ("PRESET.PR", "BEGIN PRESET.PR MM\nNR  DOC     ROT    X      Y     Z\n1   vice    +0     +100   -50   +0\n2           +1.5   +0     +0    +0\n[END]\n"),
        ("UFR.INI", "%_N_UFR_INI\n$P_UIFR[1]=CTRANS(X,10,Y,20.5):CROT(Z,0)\n$P_UIFR[2,Z,TR]=5\nM30\n"),
        ("mill.ini", "[TRAJ]\nLINEAR_UNITS = inch\n[AXIS_X]\nMIN_LIMIT = -1.0\nMAX_LIMIT = 20\n[AXIS_Z]\nMAX_LIMIT = 0\n"),
    ]);
    let text = ["TOOL.T", "TO.INI", "tool.tbl", "tools.csv", "NULL.D", "PRESET.PR", "UFR.INI", "mill.ini"]
        .map(|file| format!("== {file}\n{}", shown(&folder, &[file])))
        .concat();
    insta::assert_snapshot!("tables", text);
    let toml = ["TOOL.T", "TO.INI", "PRESET.PR", "UFR.INI", "mill.ini"]
        .map(|file| {
            let ran = folder.run(&["tools", file, "--to", "toml"]).exits(0);
            format!("== {file}\n{}-- stderr\n{}", ran.out, ran.err)
        })
        .concat();
    insta::assert_snapshot!("tables_toml", toml);
}

#[test]
fn forms_read_again_hold_the_same() {
    let folder = Folder::new("tables_again").with(&[("TOOL.T", TOOL_T)]);
    let body = |text: &str| text.split_once("\n\n").map(|(_, body)| body.to_owned()).expect("a head and a body");
    let first = body(&shown(&folder, &["TOOL.T"]));
    folder.run(&["tools", "TOOL.T", "--to", "csv", "-o", "a.csv"]).exits(0);
    folder.run(&["tools", "a.csv", "--to", "tool.t", "-o", "b.t"]).exits(0);
    assert_eq!(body(&shown(&folder, &["a.csv"])), first);
    assert_eq!(body(&shown(&folder, &["b.t"])), first);
    // What a form has no place for is said.
    let ran = folder.run(&["tools", "TOOL.T", "--to", "tool.tbl"]).exits(0);
    assert!(
        ran.err.contains("tool 5: delta_radius -0.02 has no place") && ran.err.contains("tool 5.2 is lost"),
        "{}",
        ran.err
    );
    folder.write("CUT.T", "BEGIN TOOL .T MM\nT   L     LTOL  CUT.\n1   3.1   4\n2   5     4\n[END]\n");
    let ran = folder.run(&["tools", "CUT.T"]).exits(0);
    assert_eq!(ran.err, "CUT.T:3: note: column LTOL is left out: partc has no use for it\n");
    // In inches nothing is 25.400000000000002.
    folder.write("INCH.T", "BEGIN TOOL .T INCH\nT   L      R\n1   3.1    0.1\n[END]\n");
    assert!(shown(&folder, &["INCH.T"]).contains("1       2.54    78.74"), "{}", shown(&folder, &["INCH.T"]));
}

#[test]
fn tables_that_cannot_be_read() {
    let folder = Folder::new("tables_wrong").with(&[
        ("other.t", "BEGIN TOOLT.TRN MM\nT    NAME\n[END]\n"),
        ("left.t", "BEGIN TOOL.T MM\nT     NAME             L           R           R2\n5     FR10      +100        +5          +0\n[END]\n"),
        ("bytes.t", "BEGIN TOOL.T MM\nT     NAME             L    R    R2\n5     Ø10ÄÖÜäöü +10  +5   +0\n[END]\n"),
        ("cut.t", "BEGIN TOOL.T MM\nT     NAME             L           R\n5     FR10             +100        +1"),
        ("twice.tbl", "T5 P5 D10 D12 Z100\n"),
        ("twice.t", "BEGIN TOOL.T MM\nT    L     R\n5    +80   +5\n5    +80   +6\n[END]\n"),
        ("a.csv", "number,raduis\n1,5\n"),
        ("e.csv", "number,name\n1,\"mill\n"),
        ("b.csv", "number,radius\n1,5,6\n"),
        ("f.csv", "number,radius\n1,\"1,500\"\n"),
        ("c.ini", "%_N_TO_INI\n$TC_DP6[1,1]=R1\n"),
        ("d.d", "BEGIN A.D MM\nNR    X\n0     one\n[END]\n"),
    ]);
    std::fs::write(folder.0.join("wide.t"), b"\xFF\xFEB\0E\0").expect("a file");
    for (file, says) in [
        ("other.t", "other.t:1: TOOLT.TRN is no table that partc reads"),
        ("twice.t", "twice.t:4: tool 5 stands twice"),
        ("left.t", "left.t:3: `+100` stands under NAME like a value"),
        ("bytes.t", "bytes.t:3: letters beyond ASCII"),
        ("cut.t", "cut.t:3: [END] is missing"),
        ("twice.tbl", "twice.tbl:1: D stands twice"),
        ("a.csv", "a.csv:1: `raduis` is no column"),
        ("e.csv", "e.csv:2: a quote has no end"),
        ("b.csv", "b.csv:2: 3 values where there are 2 columns"),
        ("f.csv", "f.csv:2: `1,500` under radius holds a comma"),
        ("wide.t", "wide.t: is a UTF-16 file"),
        ("c.ini", "c.ini:2: `$TC_DP6[1,1]=R1` is no value"),
        ("d.d", "d.d:3: `one` under X is no number"),
        ("gone.t", "gone.t: "),
    ] {
        folder.run(&["tools", file]).exits(2).says(says);
    }
    folder.write("e.d", "BEGIN A.D MM\nNR    X\n0     1\n[END]\n");
    folder.run(&["tools", "e.d", "--to", "tool.t"]).exits(2).says("holds no tools");
}

#[test]
fn data_of_a_sinumerik_count_as_if_the_program_had_written_them() {
    let program = "G17 G90 G54\nT3 M6\nS1000 M3\nD{}\nG0 X0 Y-20 Z5\nG1 Z-1 F100\nG1 G41 X10 Y0 F200\nG1 Y50\nG0 Z5\nG40 G0 X-20\nM30\n";
    let folder = Folder::new("tables_sinumerik").with(&[
        ("TO.INI", TO_INI),
        ("A.MPF", &program.replace("{}", "1")),
        ("B.MPF", &program.replace("{}", "2")),
        ("C.MPF", &program.replace("G54\n", "G54 G700\n").replace("{}", "1")),
        ("own.toml", "[tools]\ntable = \"TO.INI\"\n[tools.3]\nradius = 6.0\n"),
    ]);
    // G41 at X10 going up: the centre is one radius to the left; the wear makes 4 mm 3.975.
    let edge = |args: &[&str]| {
        let mut all = vec!["compile", "-o", "-"];
        all.extend(args);
        let ran = folder.run(&all).exits(0);
        ran.out.lines().find(|line| line.starts_with("G1 X")).expect("the compensated move").to_owned()
    };
    assert!(edge(&["A.MPF", "--tools", "TO.INI"]).starts_with("G1 X6.025 "));
    assert!(edge(&["B.MPF", "--tools", "TO.INI"]).starts_with("G1 X6.5 "));
    assert!(edge(&["A.MPF", "--config", "own.toml"]).starts_with("G1 X4 "));
    folder.run(&["compile", "C.MPF", "--tools", "TO.INI"]).exits(1).says("P0130");
    folder.write("inch.toml", "[tools]\ntable = \"TO.INI\"\nunit = \"mm\"\n");
    assert!(edge(&["C.MPF", "--config", "inch.toml"]).starts_with("G1 X250.025 "));
}

#[test]
fn units_of_tables_are_asked_for() {
    let folder = Folder::new("tables_units").with(&[
        ("A.H", RADIUS),
        ("inch.t", "BEGIN TOOL.T INCH\nT    L     R\n5    +3    +0.5\n[END]\n"),
        ("tool.tbl", "T5 D0.5\n"),
        ("a.toml", "[tools]\ntable = \"inch.t\"\nunit = \"inch\"\n"),
        ("b.toml", "[tools]\ntable = \"inch.t\"\nunit = \"mm\"\n"),
        ("c.toml", "[tools]\ntable = \"tool.tbl\"\nunit = \"inch\"\n"),
    ]);
    let ran = folder.run(&["compile", "A.H", "--tools", "inch.t"]).exits(1).says("P0130");
    // Which unit it is, only the user knows.
    assert!(ran.err.contains("    [tools]\n    unit = ") && ran.err.contains("\"mm\" or \"inch\"; "), "{}", ran.err);
    let ran = folder.run(&["compile", "A.H", "--config", "a.toml", "-o", "-"]).exits(0);
    assert!(ran.out.contains("X62.7 "), "{}", ran.out);
    folder
        .run(&["compile", "A.H", "--config", "b.toml", "-o", "-"])
        .exits(2)
        .says("not the one that `[tools] unit` states");
    let ran = folder.run(&["compile", "A.H", "--config", "c.toml", "-o", "-"]).exits(0);
    assert!(ran.out.contains("X56.35 "), "{}", ran.out);
}

#[test]
fn the_table_that_is_selected_on_the_control() {
    let program =
        "0 BEGIN PGM A MM\n1 CYCL DEF 7.0 DATUM SHIFT\n2 CYCL DEF 7.1 #3\n3 L X+10 Y+5 Z+0 R0 F300\n4 END PGM A MM\n";
    let folder = Folder::new("tables_datum").with(&[
        ("A.H", program),
        ("NULL.D", "BEGIN NULL.D MM\nNR    X      Y      Z\n3     +1     -2,5   +0\n[END]\n"),
        ("TOOL.T", TOOL_T),
        ("partc.toml", "[control]\ndatum_table = \"NULL.D\"\n"),
    ]);
    let ran = folder.run(&["compile", "A.H", "-o", "-"]).exits(0);
    assert!(ran.out.contains("G1 X11 Y2.5 Z0 F300"), "{}", ran.out);
    folder.run(&["compile", "A.H", "--isolated", "-o", "-"]).exits(1).says("K9012");
    folder.write("partc.toml", "[control]\ndatum_table = \"TOOL.T\"\n");
    folder.run(&["compile", "A.H", "-o", "-"]).exits(2).says("not a datum table");
}

#[test]
fn watch_checks_again_when_a_file_changes() {
    let folder = Folder::new("watch").with(&[("A.H", RADIUS), ("partc.toml", "[tools.5]\nradius = 5.0\n")]);
    folder.run(&["watch", "--fix", "A.H"]).exits(2).says("watch writes nothing");
    folder.run(&["watch", "-"]).exits(2).says("standard input does not change");
    folder.run(&["watch", "gone"]).exits(2);
    let mut child = Command::new(env!("CARGO_BIN_EXE_partc"))
        .args(["watch", "A.H"])
        .current_dir(&folder.0)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .expect("partc runs");
    let stderr = child.stderr.take().expect("a pipe");
    let (said, heard) = std::sync::mpsc::channel();
    std::thread::spawn(move || {
        for line in BufReader::new(stderr).lines().map_while(Result::ok) {
            let _ = said.send(line);
        }
    });
    let round = || -> String {
        let mut all = String::new();
        loop {
            let line = heard.recv_timeout(Duration::from_secs(60)).expect("watch goes on");
            if line.contains("waits for changes") {
                return all;
            }
            all += &line;
        }
    };
    let first = round();
    folder.write("partc.toml", "[output]\ncomments = false\n");
    let second = round();
    let _ = child.kill();
    let _ = child.wait();
    assert!(!first.contains("P2004") && second.contains("P2004"), "{first} {second}");
}

#[test]
fn the_language_of_a_file_by_its_path() {
    let folder = Folder::new("dialects").with(&[
        ("mill/A.txt", "G0 X1 Y2 Z3\nM30\n"),
        ("mill/notes.md", "Two parts.\n"),
        ("partc.toml", "[dialects]\n\"mill/*.txt\" = \"sinumerik\"\n"),
    ]);
    folder.run(&["compile", "mill/A.txt", "--isolated", "-o", "-"]).exits(2).says("which language is this?");
    folder.run(&["compile", "mill/A.txt", "-o", "-"]).exits(0);
    // A folder takes what a pattern names, and nothing else.
    folder.run(&["check", "mill"]).exits(0);
    folder.write("mill/B.txt", "G0 X1 Y2 Z3\nGOTO NOWHERE\nM30\n");
    folder.run(&["check", "mill"]).exits(1).says("mill/B.txt:2");
    let _ = std::fs::remove_file(folder.0.join("mill/B.txt"));
    folder.run(&["check", "mill/A.txt", "--dialect", "klartext"]).exits(1);
    folder.write("partc.toml", "[dialects]\n\"mill/*.txt\" = \"fanuc\"\n");
    folder.run(&["check", "mill/A.txt"]).exits(2).says("`fanuc` of");
    folder.write("partc.toml", "[dialects]\n\"mill/*.txt\" = \"mtc200\"\n\"**\" = \"sinumerik\"\n");
    folder.run(&["check", "mill/A.txt"]).exits(2).says("says that this is");
    folder.write("partc.toml", "[dialects]\n\"mill/*.txt\" = 5\n");
    folder.run(&["check", "mill/A.txt"]).exits(2).says("name of a language");
}

#[test]
fn tools_of_one_name_are_told_apart_by_the_user() {
    let folder = Folder::new("tables_sisters").with(&[
        ("A.H", &RADIUS.replace("CALL 5 ", "CALL \"FR10\" ")),
        ("TOOL.T", "BEGIN TOOL.T MM\nT     NAME    L     R\n5     FR10    +80   +5\n6     FR10    +80   +6\n[END]\n"),
        ("own.toml", "[tools]\ntable = \"TOOL.T\"\n[tools.\"FR10\"]\nnumber = 6\nradius = 6.0\n"),
    ]);
    folder.run(&["compile", "A.H", "--tools", "TOOL.T"]).exits(1).says("tools 5 and 6 of the table have this name");
    let ran = folder.run(&["compile", "A.H", "--config", "own.toml", "-o", "-"]).exits(0);
    assert!(ran.out.contains("X56 ") && ran.out.contains("T6 M6"), "{}", ran.out);
}
