//! Which findings are reported: `[lint]`, `--select`, suppressions in programs, `--add-ignores`.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use partc::internals::diag::codes;

use super::cli_run::{Folder, WARNED, WRONG};

const SINUMERIK: &str = "G0 X0 Y0 Z5\nG1 X5 F100\nR1=0.5\nIF R1==1 AND R1==2 GOTOF ENDE\nENDE: M30\n";

/// The codes that a check reports, each with its severity.
fn found(folder: &Folder, args: &[&str]) -> Vec<String> {
    let all = [&["check", "--format", "json"], args].concat();
    let report = folder.run(&all).json();
    let list = report["diagnostics"].as_array().expect("a list");
    let text = |value: &serde_json::Value, key: &str| value[key].as_str().expect("a text").to_owned();
    list.iter().map(|found| format!("{} {}", text(found, "code"), text(found, "severity"))).collect()
}

#[test]
fn a_configuration_chooses_findings_and_their_severity() {
    let folder = Folder::new("lint_config").with(&[("W.H", WARNED), ("legacy/W.H", WARNED)]);
    let with = |text: &str| folder.write("partc.toml", text);
    assert_eq!(found(&folder, &["W.H"]), ["K2102 warning"]);
    for text in ["ignore = [\"K2102\"]", "ignore = [\"K21\"]", "ignore = [\"pole-incomplete\"]", "select = [\"S\"]"] {
        with(&format!("[lint]\n{text}\n"));
        assert_eq!(found(&folder, &["W.H"]), [""; 0], "{text}");
    }
    with("[lint]\nseverity = { K2102 = \"note\" }\n");
    assert_eq!(found(&folder, &["W.H"]), ["K2102 note"]);
    folder.run(&["check", "W.H", "--fail-on", "warning"]).exits(0);
    with("[lint]\nseverity = { K21 = \"error\" }\n");
    assert_eq!(found(&folder, &["W.H"]), ["K2102 error"]);
    // The same holds for compile: an error leaves no output.
    folder.run(&["compile", "W.H"]).exits(1);
    assert!(!folder.has("W.ngc"));
    with("[lint]\nselect = [\"all\"]\n[lint.files.\"legacy/**\"]\nignore = [\"K2102\"]\n");
    assert_eq!(found(&folder, &["W.H"]), ["K2102 warning"]);
    assert_eq!(found(&folder, &["legacy/W.H"]), [""; 0]);
    // What the command line says wins.
    assert_eq!(found(&folder, &["W.H", "--ignore", "K2102,P8140"]), [""; 0]);
    assert_eq!(found(&folder, &["W.H", "--select", "S"]), [""; 0]);
}

#[test]
fn a_configuration_that_extends_another_counts_each_pattern_from_its_own_folder() {
    let folder = Folder::new("lint_extends").with(&[
        ("partc.toml", "[lint.files.\"parts/old/*.H\"]\nignore = [\"K2102\"]\n"),
        ("parts/partc.toml", "extend = \"../partc.toml\"\n[lint.files.\"new/*.H\"]\nignore = [\"K2102\"]\n"),
        ("parts/old/W.H", WARNED),
        ("parts/new/W.H", WARNED),
        ("parts/W.H", WARNED),
    ]);
    for (name, count) in [("parts/old/W.H", 0), ("parts/new/W.H", 0), ("parts/W.H", 1)] {
        assert_eq!(found(&folder, &[name]).len(), count, "{name}");
    }
    let shown = folder.run(&["config", "--show", "parts/W.H"]).exits(0).out;
    assert!(shown.contains("[lint]\nselect = [\"default\"]"), "{shown}");
}

#[test]
fn what_is_refused_cannot_be_ignored() {
    let folder = Folder::new("lint_errors").with(&[("W.H", WRONG)]);
    folder.write("partc.toml", "[lint]\nselect = []\nignore = [\"all\"]\nseverity = { K = \"note\" }\n");
    assert_eq!(found(&folder, &["W.H"]), ["P1003 error"]);
    for (text, wanted) in [
        ("ignore = [\"P1003\"]", "partc.toml:2:11: P1003 (word-misplaced)"),
        ("severity = { P1003 = \"note\" }", "cannot be lowered"),
        ("select = [\"K8O01\"]", "no finding has the code or name `K8O01`"),
    ] {
        folder.write("partc.toml", &format!("[lint]\n{text}\n"));
        let ran = folder.run(&["check", "W.H"]).exits(2);
        assert!(ran.err.contains(wanted) || ran.err.contains("cannot be ignored"), "{}", ran.err);
    }
}

fn warned_with(comment: &str) -> String {
    WARNED.replace("2 CC X+0\n", &format!("2 CC X+0 {comment}\n"))
}

#[test]
fn a_comment_suppresses_a_finding_of_its_block_or_of_the_next() {
    let folder = Folder::new("lint_comments");
    let check = |text: &str| {
        folder.write("W.H", text);
        found(&folder, &["W.H"])
    };
    for comment in [
        "; partc: ignore[K2102] -- the pole stays in Y",
        "; partc: ignore[pole-incomplete]",
        ";PARTC:ignore [ k2102 ]",
        "; the pole ; partc: ignore[K2102]",
    ] {
        assert_eq!(check(&warned_with(comment)), [""; 0], "{comment}");
    }
    let alone = |comment: &str| WARNED.replace("2 CC", &format!("{comment}\n; of the pole\n2 CC"));
    assert_eq!(check(&alone("; partc: ignore[K2102]")), [""; 0]);
    assert_eq!(check(&alone("5 ; partc: ignore[K2102]")), [""; 0]);
    assert_eq!(check(&WARNED.replace("4 END", "; partc: ignore-file[K2102]\n4 END")), [""; 0]);
    // It holds for compile, too, and for what makes a run fail.
    folder.write("W.H", &warned_with("; partc: ignore[K2102]"));
    folder.run(&["compile", "W.H", "--fail-on", "warning"]).exits(0).quietly();
    // The wrong block, no code, another code, no comment.
    let elsewhere = WARNED.replace("1 L X+10 Y+0 R0 F300", "1 L X+10 Y+0 R0 F300 ; partc: ignore[K2102]");
    assert_eq!(check(&elsewhere), ["P8001 warning", "K2102 warning"]);
    assert_eq!(
        check(&warned_with("; partc: ignore")),
        ["P8002 warning", "K2102 warning"].into_iter().rev().collect::<Vec<_>>()
    );
    assert_eq!(check(&warned_with("; partc: ignore[K9999]")), ["K2102 warning", "P8002 warning"]);
    assert_eq!(check(&warned_with("; partc: ignore[K2102")), ["K2102 warning", "P8004 warning"]);
    assert_eq!(check(&warned_with("; see partc: ignore[K2102]")), ["K2102 warning"]);
    let text = "0 BEGIN PGM T MM\n1 QS1 = \"; partc: ignore[K2102]\"\n2 L X+10 Y+0 Z+0 R0 F300\n3 END PGM T MM\n";
    assert_eq!(check(text), [""; 0]);
    // What is refused stays, and the comment is refused, too.
    folder.write("W.H", &WRONG.replace("F300", "F300 ; partc: ignore[P1003]"));
    assert_eq!(found(&folder, &["W.H"]), ["P1003 error", "P8003 warning"]);
}

#[test]
fn every_language_has_its_comment() {
    let folder = Folder::new("lint_languages");
    for (name, text, code, comment) in [
        ("A.MPF", SINUMERIK, "S8001", " ; partc: ignore[S8001]"),
        (
            "A.npg",
            "%NPG\n%NPG\nN10 G90 G00 X0 Y0 Z5\nN20 G01 X10 F100 S100 M3\nN30 RET\n",
            "M8005",
            " (partc: ignore[M8005])",
        ),
        (
            "A.nc",
            "%A.nc\n[test]\nN1 G26 S500\nN2 G97 S1000 M3\nN3 G0 X50 Z2\nN4 M30\n",
            "T2005",
            " [partc: ignore(T2005)]",
        ),
    ] {
        folder.write(name, text);
        let before = found(&folder, &[name]);
        assert!(before.iter().any(|found| found.starts_with(code)), "{name}: {before:?}");
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        let report = folder.run(&["check", "--format", "json", name]).json();
        let list = report["diagnostics"].as_array().expect("a list").clone();
        let line = list.iter().find(|found| found["code"] == code).and_then(|found| found["line"].as_u64());
        lines[line.expect("a line") as usize - 1] += comment;
        folder.write(name, &(lines.join("\n") + "\n"));
        let after = found(&folder, &[name]);
        assert!(!after.iter().any(|found| found.starts_with(code) || found.starts_with("P800")), "{name}: {after:?}");
        // The command writes a comment that it reads itself.
        folder.write(name, text);
        folder.run(&["check", name, "--add-ignores", "--fail-on", "note"]);
        assert_eq!(found(&folder, &[name]), [""; 0], "{}", folder.read(name));
    }
}

#[test]
fn comments_for_all_that_is_found_now() {
    let folder = Folder::new("lint_add").with(&[("W.H", WARNED), ("E.H", WRONG)]);
    let ran = folder.run(&["check", "W.H", "--add-ignores", "--fail-on", "warning"]).exits(0);
    assert!(ran.err.contains("W.H: 1 suppression written"), "{}", ran.err);
    assert!(folder.read("W.H").contains("\n2 CC X+0 ; partc: ignore[K2102]\n"));
    // Once is enough, and an error is not hidden.
    folder.run(&["check", "W.H", "--add-ignores"]).exits(0).quietly();
    folder.run(&["check", "E.H", "--add-ignores"]).exits(1);
    assert_eq!(folder.read("E.H"), WRONG);
    // Lines end as they did, blocks of several lines at their last one.
    folder.write(
        "C.H",
        "0 BEGIN PGM C MM\r\n1 L X+1 Y+1 Z+1 R0 F100\r\n2 CC ~\r\n  X+0\r\n3 C X+2 ~\r\n Y+0 DR+\r\n4 END PGM C MM\r\n",
    );
    folder.run(&["check", "C.H", "--add-ignores", "--fail-on", "warning"]);
    assert!(folder.read("C.H").contains("  X+0 ; partc: ignore[K2102]\r\n3 C"), "{}", folder.read("C.H"));
}

/// A stored contour has blocks, which take comments, and hidden records, which are what they are to the last byte.
#[test]
fn records_of_the_contour_editor_take_no_comments() {
    let records = ";CON,V64,2,0.0000,0,0,MST:3,2,AX:Z,X,K,I,TRANS:0;*GP*;*RO*;*HD*\n;S,EX:0,EY:60,ASE:90;*GP*;*RO*;*HD*\n\
                   ;LL,EX:-40;*GP*;*RO*;*HD*\n;LU,EY:80;*GP*;*RO*;*HD*\n";
    let program = |blocks: &str| {
        format!(
            "G95 F0.2 S500 M3\nG18\nG0 X200 Z50\nE_LAB_A_PART: ;#SM Z:2\n\
             ;#7__DlgK contour definition begin - Don't change!;*GP*;*RO*;*HD*\nG18 G90 DIAM90 ;*GP*\n{blocks}{records}\
             ;#End contour definition end - Don't change!;*GP*;*RO*;*HD*\nE_LAB_E_PART:\nM30\n"
        )
    };
    let blocks = program("G0 Z0 X60 ;*GP*\nG1 Z-40 ;*GP*\nX81 ;*GP*\n");
    let folder = Folder::new("lint_records").with(&[("A.MPF", &blocks), ("B.MPF", &program(""))]);
    folder.write("partc.toml", "[machine]\nkind = \"lathe\"\ndiameter_axis = \"X\"\n");
    let before = folder.run(&["trace", "A.MPF"]).exits(0).out;
    assert_eq!(found(&folder, &["A.MPF"]), ["S8026 warning"]);
    folder.run(&["check", "A.MPF", "--add-ignores"]).exits(0);
    assert_eq!(folder.read("A.MPF"), blocks.replace("X81 ;*GP*\n", "X81 ;*GP* ; partc: ignore[S8026]\n"));
    assert!(found(&folder, &["A.MPF"]).is_empty());
    assert_eq!(folder.run(&["trace", "A.MPF"]).exits(0).out, before);
    // Here the finding stands at a record.
    assert_eq!(found(&folder, &["B.MPF"]), ["S8028 note"]);
    folder.run(&["check", "B.MPF", "--add-ignores", "--fail-on", "note"]).exits(2).says("take no comments");
    assert_eq!(folder.read("B.MPF"), program(""));
}

#[test]
fn a_million_suppressions_and_hostile_ones() {
    let folder = Folder::new("lint_hostile");
    let many = "; partc: ignore[K2102]\n".repeat(20_000);
    folder.write("W.H", &WARNED.replace("2 CC", &(many + "2 CC")));
    assert_eq!(found(&folder, &["W.H"]), [""; 0]);
    // In a loop, with as many in one block.
    let one = ";partc:ignore[K2102]".repeat(20_000);
    let text = format!(
        "0 BEGIN PGM W MM\n1 L X+10 Y+0 Z+0 R0 F300\n2 LBL 1\n3 CC X+0 {one}\n4 C X+10 Y+0 DR+\n5 CALL LBL 1 REP 99\n6 END PGM W MM\n"
    );
    folder.write("W.H", &text);
    folder.run(&["check", "W.H"]).exits(0);
    for hostile in
        ["partc:", "partc:partc:partc:", "partc: ignore[[[[", "partc: ignore[,,,]", "\u{202e}partc: ignore[K]"]
    {
        folder.write("W.H", &warned_with(&format!("; {hostile}")));
        assert!(found(&folder, &["W.H"]).contains(&"K2102 warning".to_owned()), "{hostile}");
    }
    let unterminated =
        format!("{};partc: ignore[{}", "0 BEGIN PGM W MM\n1 L X+10 Y+0 Z+0 R0 F300 ", "K2102,".repeat(50_000));
    folder.write("W.H", &unterminated);
    folder.run(&["check", "W.H"]);
}

#[test]
fn firm_codes_exist() {
    let firm = codes::all()
        .into_iter()
        .filter(|code| code.is_firm() && code.severity != partc::internals::diag::Severity::Error);
    assert_eq!(firm.count(), 11);
}

/// Set, writes docs/lint.md anew.
const UPDATE: &str = "PARTC_UPDATE_DOCS";
const BEHIND: &str = "<!-- written by a test: cli_lint -->\n";

#[test]
fn the_documentation_lists_every_rule() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/lint.md");
    let found = fs::read_to_string(&path).expect("the documentation").replace("\r\n", "\n");
    let (text, _) = found.split_once(BEHIND).expect("the mark in front of the table");
    let mut made =
        format!("{text}{BEHIND}\n| code | name | finds | severity | by default |\n| --- | --- | --- | --- | --- |\n");
    for code in codes::all().into_iter().filter(|code| code.id.starts_with('L')) {
        let on = if code.on { "on" } else { "off" };
        let _ = writeln!(made, "| {} | {} | {} | {} | {on} |", code.id, code.name, code.title, code.severity.word());
    }
    if std::env::var_os(UPDATE).is_some() {
        fs::write(&path, &made).expect("the documentation");
    }
    assert!(found == made, "{} is not up to date: {UPDATE}=1 writes it", path.display());
}

const REDUNDANT: &str = "G0 X0 Y0 Z5\nG1 X5 F100\nG1 Y5 F100\nG1 Y5 Z4\nM30";

#[test]
fn what_does_not_change_the_motion_is_mended() {
    let folder = Folder::new("lint_fix").with(&[("A.MPF", REDUNDANT)]);
    folder.write("partc.toml", "[lint]\nselect = [\"all\"]\n");
    let before = folder.run(&["trace", "A.MPF"]).exits(0).out;
    // Shown first, and nothing is written.
    let shown = folder.run(&["check", "A.MPF", "--diff"]).exits(1).out;
    assert!(shown.contains("-G1 Y5 F100\n") && shown.contains("+ Y5\n"), "{shown}");
    assert_eq!(folder.read("A.MPF"), REDUNDANT);
    let ran = folder.run(&["check", "A.MPF", "--fix"]).exits(0);
    assert!(ran.err.contains("A.MPF: 4 changes written"), "{}", ran.err);
    let after = folder.read("A.MPF");
    assert_eq!(after, "G0 X0 Y0 Z5\nG1 X5 F100\n Y5\n Y5 Z4\nM30\n");
    assert_eq!(folder.run(&["trace", "A.MPF"]).exits(0).out, before);
    folder.run(&["check", "A.MPF", "--diff"]).exits(0).quietly();
    // What is suppressed or not selected stays, and so does a program with an error.
    folder.write("B.MPF", &REDUNDANT.replace("F100\nG1 Y5 Z4", "F100 ; partc: ignore[L2008]\nG1 Y5 Z4"));
    folder.run(&["check", "B.MPF", "--fix", "--select", "L2008"]);
    assert!(folder.read("B.MPF").contains("G1 Y5 F100 ;") && folder.read("B.MPF").ends_with("Y5 Z4\nM30"));
    folder.write("C.MPF", &REDUNDANT.replace("M30", "G1 X=UNKNOWN_WORD\nM30"));
    folder.run(&["check", "C.MPF", "--fix"]).exits(1);
    assert!(folder.read("C.MPF").starts_with(&REDUNDANT[..40]));
}

/// A finding in a called program is no change of the program that calls it, whatever stands at the same bytes.
#[test]
fn what_is_found_in_a_called_program_is_not_mended_in_its_caller() {
    // The caller has nothing to mend; the byte offsets of the called program's findings lie inside of it.
    let caller = "G0 X0 Y0 Z5\nG1 X5 F100\nCALL \"SUB.SPF\"\nG0 X0 Y0 Z5\nG1 X5 F200\nM30\n";
    let called = "G1 X6 F100 ; partc: ignore[K2102]\nG1 Y5 F100\nG1 Y5 Z4\nM17\n";
    let folder = Folder::new("lint_called").with(&[("A.MPF", caller), ("SUB.SPF", called)]);
    folder.write("partc.toml", "[lint]\nselect = [\"all\"]\nignore = [\"L2005\"]\n");
    folder.run(&["check", "A.MPF", "--fix"]);
    folder.run(&["check", "A.MPF", "--add-ignores", "--fail-on", "note"]);
    assert_eq!(folder.read("SUB.SPF"), called);
    let mended = folder.read("A.MPF");
    let without = |text: &str| {
        text.lines().map(|line| line.split(" ; partc").next().unwrap_or_default().to_owned()).collect::<Vec<_>>()
    };
    assert_eq!(without(&mended), without(caller), "{mended}");
}

#[cfg(unix)]
#[test]
fn a_mended_program_keeps_its_owner_and_its_rights() {
    use std::os::unix::fs::{MetadataExt as _, PermissionsExt as _, chown};
    use std::os::unix::process::CommandExt as _;
    use std::process::Command;
    let folder = Folder::new("lint_owner").with(&[("A.MPF", REDUNDANT)]);
    let path = folder.0.join("A.MPF");
    fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).expect("rights");
    // Only root can give a file away; for others it is their own before and after.
    let given = chown(&path, Some(1234), Some(4321)).is_ok();
    let before = fs::metadata(&path).expect("a file");
    folder.run(&["check", "A.MPF", "--select", "L2008", "--fix"]).exits(0);
    let after = fs::metadata(&path).expect("a file");
    assert_ne!(folder.read("A.MPF"), REDUNDANT);
    assert_eq!((after.uid(), after.gid(), after.mode()), (before.uid(), before.gid(), before.mode()));
    assert!(!given || after.uid() == 1234);
    // Who may not give it back to its owner leaves it alone.
    if !given {
        return;
    }
    fs::write(&path, REDUNDANT).expect("a file");
    fs::set_permissions(&path, fs::Permissions::from_mode(0o666)).expect("rights");
    fs::set_permissions(&folder.0, fs::Permissions::from_mode(0o777)).expect("rights");
    let ran = Command::new(env!("CARGO_BIN_EXE_partc"))
        .args(["check", "A.MPF", "--select", "L2008", "--fix"])
        .current_dir(&folder.0)
        .uid(2345)
        .gid(2345)
        .output();
    // Not everybody may look into the folder of the build.
    let Ok(ran) = ran else { return };
    let said = String::from_utf8_lossy(&ran.stderr).into_owned();
    assert_eq!(
        (ran.status.code(), fs::read_to_string(&path).expect("a file").as_str()),
        (Some(2), REDUNDANT),
        "{said}"
    );
}

#[test]
fn block_numbers_and_useless_comments_are_mended_on_request() {
    let text = "0 BEGIN PGM A MM\n1 L X+0 Y+0 Z+5 R0 F300 ; partc: ignore[K2102]\n1 L X+10\n/5 L X+12\n0 L X+20\n9 END PGM A MM\n";
    let folder = Folder::new("lint_numbers").with(&[("A.H", text)]);
    folder.run(&["check", "A.H", "--fix"]).exits(0);
    assert_eq!(folder.read("A.H"), text.replace(" ; partc: ignore[K2102]", ""));
    folder.run(&["check", "A.H", "--fix", "--unsafe-fixes", "--select", "default,L2005"]).exits(0);
    let wanted = "0 BEGIN PGM A MM\n1 L X+0 Y+0 Z+5 R0 F300\n2 L X+10\n/5 L X+12\n4 L X+20\n5 END PGM A MM\n";
    assert_eq!(folder.read("A.H"), wanted);
}

#[test]
fn words_stay_where_something_else_may_hold() {
    let folder = Folder::new("lint_kept");
    folder.write("partc.toml", "[lint]\nselect = [\"all\"]\nignore = [\"L2005\"]\n[variables]\nR0 = 0\n");
    let redundant = |text: &str| {
        folder.write("A.MPF", text);
        found(&folder, &["A.MPF"]).iter().filter(|found| found.starts_with("L2008")).count()
    };
    // Behind a jump to a block number another G may hold than the block before says.
    let jump =
        "N10 G0 X0 Y0 Z5\nN20 G1 X5 F100\nN100 G1 X6 F100\nN105 G0 X50\nN110 R1=R1+1\nN120 IF R1==1 GOTOB N100\nM30\n";
    assert_eq!(redundant(jump), 0);
    assert_eq!(redundant(&jump.replace("GOTOB N100", "R2=1")), 2);
    // The limits of G25 and G26 are no speed; another kind of feed wants its F again.
    assert_eq!(redundant("S1000 M3\nG0 X0 Y0 Z5\nS1000 G1 X5 F100\nG25 S1000\nM30\n"), 0);
    assert_eq!(redundant("S1000 M3\nG1 X0 Y0 Z5 F100\nG95 G1 X5 F100\nG94 X6 F100\nX7 F100\nM30\n"), 2);
    assert_eq!(redundant("G1 X0 Y0 Z5 F100\nG93 X5 F10\nX6 F10\nX7 F10\nM30\n"), 0);
}

#[test]
fn what_cannot_be_mended_is_said() {
    let folder = Folder::new("lint_unmended");
    folder.write("partc.toml", "[lint]\nselect = [\"all\"]\n");
    folder.write("A.MPF", "G1 X=UNKNOWN_WORD F100\nG1 F100 X5\nM30\n");
    let ran = folder.run(&["check", "A.MPF", "--diff"]).exits(1);
    assert!(ran.err.contains("error[") || ran.out.contains("error["), "{} {}", ran.out, ran.err);
    // Ctrl-Z behind the last line is no line.
    folder.write("B.MPF", "G0 X1 Y1 Z1\nM30\n\u{1a}");
    assert!(!found(&folder, &["B.MPF"]).iter().any(|found| found.starts_with("L2011")));
    folder.write("B.MPF", "G0 X1 Y1 Z1\nM30\u{1a}");
    folder.run(&["check", "B.MPF", "--fix", "--select", "L2011"]);
    assert_eq!(folder.read("B.MPF"), "G0 X1 Y1 Z1\nM30\n\u{1a}");
    // Blocks with a skip mark are numbered, too, and each change is counted once.
    folder.write("C.MPF", "N10 G0 X1 Y1 Z1\n/N15 X2\nN12 X3\nN20 M30\n");
    let ran = folder.run(&["check", "C.MPF", "--select", "L2005", "--fix", "--unsafe-fixes"]);
    assert!(ran.err.contains("3 changes written"), "{}", ran.err);
    assert_eq!(folder.read("C.MPF"), "N10 G0 X1 Y1 Z1\n/N20 X2\nN30 X3\nN40 M30\n");
    // Further comments of a block are read as well.
    folder.write("D.nc", "N1 G0 X100 Z5\nN4 G4 F0 [com]\nN5 M30\n");
    folder.run(&["check", "D.nc", "--add-ignores", "--fail-on", "note"]);
    let text = folder.read("D.nc");
    assert_eq!(text.matches("partc:").count(), text.matches("L1011").count(), "{text}");
    assert!(!found(&folder, &["D.nc"]).iter().any(|found| found.starts_with("L1011")), "{text}");
}

/// As Klartext reads it: F of TOOL CALL is that of F AUTO.
const TOOL_FEED: &str = "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S2000 F100\n2 L X+0 Y+0 Z+5 R0 FMAX M3\n3 L Z-1 F200\n4 L X+5 F200\n\
5 L Z+50 FMAX\n6 TOOL CALL 2 Z S2000 F200\n7 L X+0 Z+5 FMAX M3\n8 L Z-1\n9 L X+5 F200 M8\n10 L Z+50 FMAX M30\n11 END PGM A MM\n";

#[test]
fn words_of_a_tool_call_are_not_modal() {
    let folder = Folder::new("lint_tool_feed").with(&[("A.H", TOOL_FEED)]);
    folder.run(&["check", "A.H", "--select", "L2008", "--fix"]).exits(0);
    assert_eq!(folder.read("A.H"), TOOL_FEED.replace("4 L X+5 F200", "4 L X+5"));
}

#[test]
fn a_block_number_that_a_jump_names_leads_to_blocks_behind_the_end() {
    let folder = Folder::new("lint_behind_end");
    let behind = |text: &str| {
        folder.write("A.MPF", text);
        found(&folder, &["A.MPF", "--select", "L2003"])
    };
    let text = "N10 G0 X0 Y0 Z5\nN20 IF R1==1 GOTOF N200\nN40 M30\nN200 G0 X9\nN210 M30\n";
    assert_eq!(behind(text), [""; 0]);
    assert_eq!(behind(&text.replace("GOTOF N200", "GOTOF N210")), ["L2003 warning"]);
}

#[test]
fn rules_look_at_what_the_tool_does() {
    let folder = Folder::new("lint_truth");
    let check = |name: &str, text: &str| {
        folder.write(name, text);
        let all = found(&folder, &[name, "--select", "default,L1025,L2012"]);
        all.into_iter().filter(|found| found.starts_with('L')).collect::<Vec<_>>()
    };
    // A retract at feed is no cut, with the tool before the first one and with the spindle off.
    let up = "0 BEGIN PGM A MM\n1 BLK FORM 0.1 Z X+0 Y+0 Z-40\n2 BLK FORM 0.2 X+100 Y+100 Z+0\n3 L Z+60 R0 F2000 M5\n4 TOOL CALL 2 Z S2500\n\
5 L X+1 Y+1 Z+2 R0 FMAX M3\n6 L Z-1 F50\n7 L Z+6 F2000\n8 M5\n9 L Z+60 R0 F2000\n10 END PGM A MM\n";
    assert_eq!(check("A.H", up), [""; 0]);
    assert_eq!(check("A.H", &up.replace("9 L Z+60", "9 L X+60")), ["L1001 warning", "L1018 warning"]);
    // What nothing sets is said once, not as a dwell that takes no time.
    let dwell = "T1 M6\nS1000 M3\nG0 X0 Y0 Z5\nG4 F=R5\nG4 F=R5\nG1 X1 F100\nG0 Z50\nM30\n";
    assert_eq!(check("B.MPF", dwell), [""; 0]);
    assert_eq!(check("B.MPF", &dwell.replacen("=R5", "0", 1)), ["L1011 warning"]);
    // A speed of 0 is nothing as long as nothing cuts.
    let speed = "T1 M6\nS0 M3\nG0 X0 Y0 Z5\nG1 Z-5 F300\nG0 Z50\nM30\n";
    assert_eq!(check("C.MPF", speed), ["L1017 warning"]);
    assert_eq!(check("C.MPF", &speed.replace("Z5\n", "Z5 S100\n")), [""; 0]);
    let tool = "0 BEGIN PGM P MM\n1 TOOL CALL 1 Z S0\n2 L X+0 Y+0 Z+5 R0 FMAX M3\n3 L Z-1 F100\n4 L Z+50 FMAX M30\n5 END PGM P MM\n";
    assert_eq!(check("C.H", tool), ["L1017 warning"]);
    // The plane of a language that says it with its moves only.
    let plane = "%NPG\n%NPG\nN1 G90 T1 M6\nN2 S1000 M3\nN3 G0 X0 Y0 Z5\nN4 G18\nN5 G1 Z-1 F100\nN6 G0 Z50\nN7 M30\n";
    assert_eq!(check("D.npg", plane), ["L1025 note"]);
    assert_eq!(check("D.npg", &plane.replace("N6 G0", "N6 G17 G0")), [""; 0]);
    assert_eq!(check("E.H", "0 BEGIN PGM P MM\n1 L X+0.1234567 Y+0 Z+5 R0 F300 M30\n2 END PGM P MM\n"), ["L2012 note"]);
}

#[test]
fn rules_stop_where_a_block_is_missing() {
    let text = "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S2000\n2 L X+0 Y+0 Z+5 R0 FMAX\n3 CALL PGM NOTHERE\n4 L X+10 Y+10 Z+5 FMAX M3\n\
5 L Z-1 F100 M5\n6 L X+20\n7 L Z+50 FMAX M30\n8 END PGM A MM\n";
    let folder = Folder::new("lint_stop").with(&[("A.H", text)]);
    assert_eq!(found(&folder, &["A.H"]), ["P0101 error"]);
    folder.write("A.H", &text.replace("3 CALL PGM NOTHERE\n", ""));
    assert_eq!(found(&folder, &["A.H"]), ["L1001 warning"]);
}

#[cfg(unix)]
#[test]
fn a_protected_program_is_not_changed() {
    use std::os::unix::fs::PermissionsExt as _;
    let folder = Folder::new("lint_protected").with(&[("A.MPF", REDUNDANT), ("B.MPF", REDUNDANT)]);
    fs::set_permissions(folder.0.join("A.MPF"), fs::Permissions::from_mode(0o444)).expect("rights");
    let ran = folder.run(&["check", "A.MPF", "--select", "L2008", "--fix"]).exits(2);
    assert!(ran.err.contains("A.MPF: is write-protected"), "{}", ran.err);
    fs::hard_link(folder.0.join("B.MPF"), folder.0.join("C.MPF")).expect("a link");
    let ran = folder.run(&["check", "B.MPF", "--select", "L2008", "--fix"]).exits(2);
    assert!(ran.err.contains("hard links"), "{}", ran.err);
    assert_eq!((folder.read("A.MPF").as_str(), folder.read("B.MPF").as_str()), (REDUNDANT, REDUNDANT));
}

#[test]
fn small_texts_are_right() {
    let folder = Folder::new("lint_texts")
        .with(&[("E.H", ""), ("C.H", "0 BEGIN PGM A MM\n1 L X+\u{2} Y+0 R0 F100\n2 END PGM A MM\n")]);
    let ran = folder.run(&["check", "E.H", "--format", "concise"]).exits(1);
    assert!(!ran.err.contains("times"), "{}", ran.err);
    let ran = folder.run(&["check", "C.H", "--format", "concise"]).exits(1);
    assert!(ran.err.contains("a control character (U+0002) has no place"), "{}", ran.err);
    // Nothing behind a suppression is read over.
    folder.write("W.H", &warned_with("; partc: ignore[K2102], [L1001]"));
    assert_eq!(found(&folder, &["W.H"]), ["K2102 warning", "P8004 warning"]);
    // An archive head takes no comment.
    let archive = "%_N_AA1_MPF\nG0 X1 Y0 Z0\nM30\n%_N_BB1_MPF\nG0 X2\nM30\n";
    folder.write("A.MPF", archive);
    let ran = folder.run(&["check", "A.MPF", "--add-ignores"]).exits(2);
    assert!(ran.err.contains("take no comments"), "{}", ran.err);
    assert_eq!(folder.read("A.MPF"), archive);
}
