//! The library without files: what it gives is what the command gives.

use partc::diagnostics::codes;
use partc::files::NoFiles;
use partc::{Program, Settings, Trouble, check, compile, settings, trace};

/// Every golden program without called programs: text and findings agree with a session of its own.
#[test]
fn programs_in_memory_compile_as_files_do() {
    let text = b"0 BEGIN PGM A MM\n1 L X+0 Y+0 R0 FMAX\n2 L IX+10 F200\n3 END PGM A MM\n";
    let program = Program::new("A.H", text).expect("Klartext");
    let made = compile(&program, &Settings::default(), &NoFiles).expect("a target");
    let code = made.text.expect("no error");
    assert!(code.contains("\nG0 X0 Y0\nG1 X10 F200\n"), "{code}");
    assert!(made.findings.is_empty(), "{:?}", made.findings);
    let moves = trace(&program, &Settings::default(), &NoFiles).expect("moves").text.expect("no error");
    assert_eq!(moves.lines().count(), 2, "{moves}");
}

#[test]
fn an_error_leaves_no_text_and_tells_its_place() {
    let text = b"N10 G0 X0\nN20 G1 X10\nM30\n";
    let program = Program::in_language("sinumerik", "part.txt", text).expect("a language");
    let made = compile(&program, &Settings::default(), &NoFiles).expect("a target");
    assert_eq!(made.text, None);
    let finding = &made.findings[0];
    assert_eq!((finding.file.as_str(), finding.line, finding.block.as_deref()), ("part.txt", 2, Some("N20")));
    assert_eq!(finding.alarm, Some(10860), "{finding:?}");
    assert!(codes::find(finding.code).is_some());
    assert_eq!(check(&program, &Settings::default(), &NoFiles)[0].code, finding.code);
}

#[test]
fn what_is_no_program_is_trouble() {
    assert!(matches!(Program::new("a.txt", b"hello"), Err(Trouble::Language(_))));
    assert!(matches!(Program::in_language("basic", "a", b""), Err(Trouble::Language(_))));
    assert!(settings::from_toml("[output]\ndecimal = 3\n", "partc.toml").is_err());
}
