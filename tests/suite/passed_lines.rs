//! Rules on source text pass over straight lines, and find the same as where they look at each line: a rule that wants all
//! of them (L2008) makes them do so.

use partc::internals::diag::Diagnostic;
use partc::internals::dialect;
use partc::internals::driver::Session;
use partc::internals::text::files::NoFiles;
use partc::internals::text::{Memory, Opened};
use proptest::prelude::*;

use super::common::settings;

fn findings(dialect: &str, program: &str, select: &str) -> Vec<(&'static str, u32, String)> {
    let main = Opened {
        name: "PART".to_owned(),
        identity: "PART".to_owned(),
        text: Box::new(Memory::new(program.as_bytes().to_vec())),
    };
    let session = Session::new(main);
    let settings = settings(&format!("[limits]\nsteps = 2000\n[lint]\nselect = [{select}]\n"));
    session.check(dialect::find(dialect).expect("a dialect"), &settings, &NoFiles);
    let told = |found: Diagnostic| (found.code.id, found.label.loc.span.start, found.message);
    session.diags.into_sorted().into_iter().filter(|found| found.code.id != "L2008").map(told).collect()
}

fn finds_the_same(dialect: &str, program: &str) -> Vec<(&'static str, u32, String)> {
    let passed = findings(dialect, program, "\"L\"");
    assert_eq!(passed, findings(dialect, program, "\"L\", \"L2008\""), "{program}");
    let all = findings(dialect, program, "\"default\"");
    assert_eq!(all, findings(dialect, program, "\"default\", \"L2008\""), "{program}");
    passed
}

/// Lines that are passed over, as many as are noted, and some between them.
fn lines(straight: &'static str, other: &'static [&'static str]) -> impl Strategy<Value = Vec<(u32, String)>> {
    let line = prop_oneof![
        6 => (straight, 1..40usize).prop_map(|(line, times)| vec![line; times]),
        2 => prop::sample::select(other).prop_map(|line| vec![line.to_owned()]),
    ];
    let numbered = prop::collection::vec(line, 1..8).prop_map(|lines| lines.concat());
    (numbered, prop::collection::vec(0..200u32, 0..3)).prop_map(|(lines, odd)| {
        let number = |at: usize| if odd.contains(&(at as u32)) { at as u32 / 2 } else { at as u32 + 1 };
        lines.into_iter().enumerate().map(|(at, line)| (number(at), line)).collect()
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn klartext(
        lines in lines("L [XYZ][+-][0-9]{1,3}(\\.[0-9]{1,7})?( F[0-9]{3})?", &[
            "LBL 1", "CALL LBL 1", "FN 9: IF +1 EQU +1 GOTO LBL 1", "L X+1 M3", "L X+Q1", "Q1 = 5", "; TODO", "L X+1 ; L X+2",
            "M30", "CC X+0 Y+0", "C X+1 Y+1 DR+", "L X+1 Q", "STOP", "/ L X+5", "END PGM A MM", "",
        ]),
        numbered in any::<bool>(),
        end in prop::sample::select(vec!["\n", "\r\n"]),
        last in any::<bool>(),
    ) {
        let line = |(number, line): &(u32, String)| if numbered { format!("{number} {line}") } else { line.clone() };
        let mut program = lines.iter().map(line).collect::<Vec<_>>().join(end);
        if last {
            program.push_str(end);
        }
        finds_the_same("klartext", &program);
    }

    #[test]
    fn sinumerik(
        lines in lines("(G[01] )?[XYZ]-?[0-9]{1,3}(\\.[0-9]{1,7})?( F[0-9]{3})?", &[
            "MARK1:", "GOTOB MARK1", "GOTOF MARK2", "MARK2: G0 X1", "G1 X=R1", "R1=5", "; TODO", "G1 X1 ; G1 X2", "M30",
            "G91", "G90", "G18", "AP=5 RP=10", "G71", "G70", "IF R1==1 GOTOB MARK1", "X1 Q", "DEFINE A AS G1 X5", "A", "/G1 X5", "",
        ]),
        numbered in any::<bool>(),
        end in prop::sample::select(vec!["\n", "\r\n"]),
        last in any::<bool>(),
    ) {
        let line = |(number, line): &(u32, String)| if numbered { format!("N{number} {line}") } else { line.clone() };
        let mut program = lines.iter().map(line).collect::<Vec<_>>().join(end);
        if last {
            program.push_str(end);
        }
        finds_the_same("sinumerik", &program);
    }
}

#[test]
fn what_straight_lines_lack_is_found_in_them() {
    let many = |from: u32| (from..from + 20).map(|n| format!("{n} L X+{n}\n")).collect::<String>();
    let codes = |program: &str| finds_the_same("klartext", program).iter().map(|found| found.0).collect::<Vec<_>>();
    let program = |body: String| format!("0 BEGIN PGM A MM\n{body}99999 END PGM A MM\n");
    let has = |body: String, code: &str| codes(&program(body)).contains(&code);
    assert!(!has(many(1) + &many(21), "L2005"));
    assert!(has(many(1) + &many(20), "L2005"));
    assert!(has(many(100) + "50 L M3\n" + &many(40), "L2005"));
    assert!(has(many(1) + "21 L X+1.123456\n" + &many(22), "L2012"));
    assert!(!has(many(1) + "21 L X+1.12345\n" + &many(22), "L2012"));
    assert!(has("1 LBL 1\n2 FN 9: IF +1 EQU +1 GOTO LBL 1\n".to_owned() + &many(3), "L2002"));
    assert!(has("1 L M30\n".to_owned() + &many(3), "L2003"));
}

#[test]
fn the_last_line_lacks_its_end() {
    for end in ["\n", "\r\n"] {
        let lines = (1..40).map(|n| format!("N{n} X{n}")).collect::<Vec<_>>().join(end);
        let found = finds_the_same("sinumerik", &lines);
        assert!(found.iter().any(|found| found.0 == "L2011"), "{found:?}");
        let found = finds_the_same("sinumerik", &(lines + end));
        assert!(!found.iter().any(|found| found.0 == "L2011"), "{found:?}");
    }
}
