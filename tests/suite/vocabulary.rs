//! No word of the language goes in silence: each is used, noted, warned of or refused.

use partc::internals::sema::sinumerik::all_words;
use partc::internals::text::files::NoFiles;

use super::common::{compile_bytes, settings};

/// What came of a program, as one text: findings by code and message, and the output without its head.
fn result(text: &str, toml: &str) -> String {
    let compiled = compile_bytes("PART.MPF", text.as_bytes().to_vec(), "sinumerik", &settings(toml), &NoFiles);
    let findings: Vec<String> =
        compiled.findings.iter().map(|found| format!("{} {}", found.code.id, found.text())).collect();
    let head = |line: &&str| !line.starts_with("(source ");
    let path: Vec<&str> = compiled.output.lines().filter(head).collect();
    format!("{}\n{}", findings.join("\n"), path.join("\n"))
}

const MILL: &str = "[output]\ncompensation = \"control\"\n[tools.1]\nradius = 2.0";
const LATHE: &str =
    "[machine]\nkind = \"lathe\"\ndiameter_axis = \"X\"\n[output]\ncompensation = \"control\"\n[tools.1]\nradius = 2.0";

/// Moves whose output or findings depend on what was said in front of them.
const MOVES: &str = "G1 X10 Y5 Z1\nG41 X20 Y10 Z0\nX30\nG40 X40 Y20\n";

/// Do `words`, in a block of their own or beside an axis, change what comes of a program with `before` and `after`?
fn is_heard(words: &str, before: &str, after: &str) -> bool {
    [MILL, LATHE].iter().any(|toml| {
        let program =
            |line: &str| format!("T1 M6\nD1 S500 M3\nG94\nG0 X0 Y0 Z0\nF100\n{before}{line}{MOVES}{after}M30\n");
        let without = result(&program(""), toml);
        result(&program(&format!("{words}\n")), toml) != without
            || result(&program(&format!("{words} X7\n")), toml) != result(&program("X7\n"), toml)
    })
}

#[test]
fn each_code_of_a_group_is_heard() {
    let words = all_words();
    let of_group = |group: u8| words.iter().filter(move |(_, other)| *other == Some(group)).map(|(name, _)| name);
    let mut silent = Vec::new();
    for (name, group) in &words {
        let Some(group) = *group else { continue };
        // A code may be in force already: then another one of its group stands in front of it.
        let others = of_group(group).filter(|other| *other != name).map(|other| format!("{other}\n"));
        if !std::iter::once(String::new()).chain(others).any(|before| is_heard(name, &before, "")) {
            silent.push(name.as_str());
        }
    }
    assert_eq!(silent, Vec::<&str>::new(), "codes that go in silence");
}

/// Forms that are heard only with other words: what stands in front of them and behind them.
const WITH_OTHERS: &[(&str, &str, &str)] = &[
    ("SETMS", "SETMS(2)\n", ""),
    ("SETMS(1)", "SETMS(2)\n", ""),
    ("DIAMCHAN", "DIAMOFA[X]\n", ""),
    ("DIAMCHAN()", "DIAMOFA[X]\n", ""),
    ("FA[X]=50", "", "POS[X]=3\n"),
    ("FRCM=3", "", "X50 RND=1\nY50\n"),
    ("LIMS=3", "", "G96 S100\nG1 X60 F1\n"),
];

/// They take a message from the screen; the comment that was made of it is in the output.
const SILENT: &[&str] = &[
    "MSG",
    "MSG()",
    // Bounds of corners, which count from G641, G642 or G645 on; and what ends a tolerance, or the folders of CALLPATH.
    "ADIS=3",
    "CTOL=3",
    "CYCLE832",
    "CYCLE832()",
    "CALLPATH",
    "CALLPATH()",
];

#[test]
fn each_other_word_is_heard_in_every_form() {
    let mut silent = Vec::new();
    for (name, group) in all_words() {
        if group.is_some() {
            continue;
        }
        // A bare word, an address, an address with an axis, procedures with arguments.
        for form in ["", "=3", "[X]=50", "[X]", "(1)", "(2)", "(X)", "(R1,\"A\")", "()"] {
            let words = format!("{name}{form}");
            let with = WITH_OTHERS.iter().find(|(other, ..)| *other == words);
            let (before, after) = with.map_or(("", ""), |(_, before, after)| (*before, *after));
            if !is_heard(&words, before, after) && !SILENT.contains(&words.as_str()) {
                silent.push(words);
            }
        }
    }
    assert_eq!(silent, Vec::<String>::new(), "words that go in silence");
}

/// Where a word stands alone in its usual form, it is no error to pass over, and has one note at most.
#[test]
fn words_for_speed_and_accuracy_make_one_note() {
    let blocks = "G601\nG602\nG603\nCFC\nFNORM\nSOFT\nFFWON\nCOMPOF\nCOMPCAD\nSPATH\nUPATH\nRTLION\n";
    let program = format!("G0 X0 Y0 Z0\n{blocks}{blocks}X10\nM30\n");
    let compiled = compile_bytes("PART.MPF", program.into_bytes(), "sinumerik", &settings(""), &NoFiles);
    assert_eq!(compiled.codes(), ["S8002"], "{:?}", compiled.rendered);
}

/// The words that went in silence once, each with what is said of it now.
#[test]
fn words_that_once_went_in_silence() {
    let cases = [
        ("G601", "S8002"),
        ("G602", "S8002"),
        ("G603", "S8002"),
        ("CFC", "S8002"),
        ("CFTCP", "S8002"),
        ("CFIN", "S8101"),
        ("FNORM", "S8002"),
        ("FLIN", "S8101"),
        ("FCUB", "S8101"),
        ("LFON", "S8103"),
        ("LFTXT", "S8103"),
        ("SPATH", "S8002"),
        ("UPATH", "S8002"),
        ("COMPOF", "S8002"),
        ("RTLIOF", "S8102"),
        ("TOWMCS", "S8010"),
        ("ORIMKS", "S8104"),
        ("FTOCON", "S8010"),
        ("SPCON", "S8103"),
        ("GWPSON(1)", "S8101"),
        ("WAITP(X)", "S8103"),
        ("DELETE(R1,\"A\")", "S8017"),
        ("STOPRE", "S8103"),
        ("SUPD", "S8103"),
    ];
    for (word, code) in cases {
        let with_axis = if word == "SUPD" { " X5" } else { "" };
        let program = format!("R1=0\nG0 X0 Y0 Z0\n{word}{with_axis}\nX10\nM30\n");
        let compiled = compile_bytes("PART.MPF", program.into_bytes(), "sinumerik", &settings(""), &NoFiles);
        assert!(compiled.codes().contains(&code), "{word}: {:?}", compiled.rendered);
        assert!(!compiled.has_errors(), "{word}: {:?}", compiled.rendered);
    }
}
