//! Names of called programs that would lead out of the folders that a program may read.
#![cfg(unix)]

use std::fs;
use std::os::unix::fs::symlink;
use std::path::Path;
use std::time::Duration;

use super::process::{folder, run};

/// The mark of what lies outside: no output and no message may hold it.
const MARK: &str = "777.125";

/// What was seen.
#[derive(Debug, Default)]
pub struct Names {
    pub names: usize,
    pub programs: usize,
    /// Names that led out, that ended partc, or that took too long.
    pub wrong: Vec<String>,
}

/// Names that lead out, or would on some system.
pub fn hostile(outside: &str) -> Vec<String> {
    let mut names = Vec::new();
    let absolute = format!("{outside}/");
    let prefixes = [
        "../",
        "..\\",
        "./../",
        "../../deep/../",
        "sub/../../",
        "sub\\..\\..\\",
        ".../../",
        "..//",
        "../.",
        "%2e%2e/",
        "..%2f",
        "TNC:\\..\\",
        "TNC:/../",
        "tnc:\\sub\\..\\..\\",
        "TNC:..\\",
        "TNC:\\\\..\\",
        "PLC:\\..\\",
        "C:\\",
        "C:",
        "\\\\host\\share\\",
        "//host/share/",
        "\\\\?\\",
        "\\\\.\\",
        "file://",
        "file:///",
        "http://localhost/",
        "/",
        "\\",
        "~/",
        "$HOME/",
        "link/",
        "LINK/",
        "TNC:\\link\\",
        "sub/up/",
        "SUB\\UP\\",
        "/_N_WKS_DIR/../",
        "/proc/self/cwd/../",
        "/proc/self/root",
        "sub/./../../",
        &absolute,
    ];
    for prefix in prefixes {
        for name in ["SECRET.H", "secret.h", "SECRET", "out/SECRET.H", "out\\SECRET.H"] {
            names.push(format!("{prefix}{name}"));
        }
    }
    for device in ["NUL", "CON", "PRN", "AUX", "COM1", "COM9", "LPT1", "LPT9", "CLOCK$", "CONIN$", "CONOUT$"] {
        names.extend(["", ".H", ".txt", ":"].map(|end| format!("{device}{end}")));
    }
    for odd in [
        ".",
        "..",
        "...",
        "/",
        "\\",
        "/etc/passwd",
        "/etc/shadow",
        "/dev/zero",
        "/dev/stdin",
        "/dev/tty",
        "/proc/self/mem",
        "/proc/self/environ",
        "-",
        "--help",
        "-o",
        "`id`",
        "$(id)",
        "*.H",
        "?ECRET.H",
        "[A-Z]*.H",
        "PART.H:stream",
        "PART.H::$DATA",
        "SECRET.H ",
        " ../SECRET.H",
        "link",
        "LINK",
        "aim.H",
        "AIM.H",
        "sub/up",
        "dangling.H",
        "loop.H",
        "a\u{0}b",
        "a\u{202e}H.b",
        "a\tb",
        "a\u{7f}",
        "\u{ff0e}\u{ff0e}/SECRET.H",
        "..\u{2215}SECRET.H",
    ] {
        names.push(odd.to_owned());
    }
    names.extend([255, 256, 1000, 5000, 100_000].map(|long| "A".repeat(long)));
    names.push("../".repeat(100) + "etc/passwd");
    names.push("sub/".repeat(2000) + "A.H");
    names
}

/// Calls each of them, from both languages that call files by name.
pub fn escapes(partc: &Path, under: &Path) -> Names {
    let outside = folder(under, "names");
    let inside = folder(&outside, "in");
    let secret = format!("0 BEGIN PGM SECRET MM\n1 L X+{MARK} Y+0 R0 F100\n2 END PGM SECRET MM\n");
    for place in ["SECRET.H", "out/SECRET.H", "out/A.H"] {
        let path = outside.join(place);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(path, &secret).expect("a file");
    }
    fs::create_dir_all(inside.join("sub")).expect("a folder");
    fs::write(inside.join("partc.toml"), "[include]\nroots = { \"TNC:\" = \".\" }\n").expect("a file");
    for (to, name) in [
        ("..", "link"),
        ("../../out", "sub/up"),
        ("../SECRET.H", "aim.H"),
        ("nowhere", "dangling.H"),
        ("loop.H", "loop.H"),
    ] {
        symlink(to, inside.join(name)).expect("a link");
    }
    let mut seen = Names::default();
    for name in hostile(&outside.to_string_lossy()) {
        seen.names += 1;
        let klartext = format!("0 BEGIN PGM P MM\n1 L X+0 Y+0 Z+5 R0 F100\n2 CALL PGM {name}\n3 END PGM P MM\n");
        let sinumerik = format!("G17 G90 G94 G1 X0 Y0 Z5 F100\nEXTCALL \"{name}\"\nCALL \"{name}\"\nM30\n");
        fs::write(inside.join("P.H"), klartext).expect("a program");
        fs::write(inside.join("Q.MPF"), sinumerik).expect("a program");
        seen.programs += 2;
        let took = run(partc, &inside, &["compile", "P.H", "Q.MPF", "--format", "concise"], Duration::from_secs(20));
        let outputs = ["P.ngc", "Q.ngc"].map(|output| inside.join(output));
        let printed = outputs.each_ref().map(|output| fs::read_to_string(output).unwrap_or_default());
        outputs.iter().for_each(|output| drop(fs::remove_file(output)));
        let leaks = printed.iter().chain([&took.said]).any(|text| text.contains(MARK) || text.contains("root:"));
        if leaks || !matches!(took.code, Some(0 | 1)) {
            let shown: String = name.chars().take(60).collect();
            seen.wrong.push(format!("{shown:?}: {:?}, {}", took.code, took.said.lines().next().unwrap_or("")));
        }
    }
    seen
}
