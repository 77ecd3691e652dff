//! What a refused program still shows: its picture, its moves and its page, each up to the first error, none of them whole.

use serde_json::Value;

use super::cli_run::{Folder, HOLE, PART};

/// Blocks 5 and 6 are whole, block 7 is refused; block 10 begins and ends at places that are known again.
const REFUSED: &str = "0 BEGIN PGM R MM\n1 BLK FORM 0.1 Z X+0 Y+0 Z-20\n2 BLK FORM 0.2 X+100 Y+80 Z+0\n\
                       3 TOOL CALL 1 Z S1000\n4 L X+10 Y+10 Z+5 R0 FMAX M3\n5 L Z-5 F100\n6 L X+90\n7 L X+95 R5\n\
                       8 L Y+70\n9 L X+20 Y+60 Z+5 FMAX\n10 L Y+30 F100\n11 END PGM R MM\n";

fn refused(test: &str) -> Folder {
    Folder::new(test).with(&[("R.H", REFUSED)])
}

#[test]
fn a_picture_stops_at_the_error_and_says_so() {
    let folder = refused("refused_plot");
    folder.write("R.svg", "<!-- (partc plot) -->\n<svg>an older one</svg>\n");
    let ran = folder.run(&["plot", "R.H", "--dimensions"]).exits(1).says("P1003").says("R.svg is incomplete");
    assert!(ran.out.is_empty() && !folder.has("R.svg.stale") && !folder.has("R.ngc"));
    let svg = folder.read("R.svg");
    assert!(svg.contains(" class=\"incomplete\" data-code=\"P1003\" data-file=\"R.H\" data-line=\"8\">"), "{svg}");
    assert!(svg.contains(" class=\"loud\"") && svg.contains(">incomplete: stops at line 8 (P1003)</text>"), "{svg}");
    // The cut in front of the error is whole; the one behind it stands among what is pale, and from nowhere leads nothing.
    let (whole, after) = svg.split_once("<g class=\"after\">").expect("something behind the error");
    let (after, rest) = after.split_once("</g>").expect("its end");
    assert!(after.contains("M20 60L20 30") && !after.contains("90 10"), "{after}");
    assert!(rest.contains("M10 10L90 10") && !whole.contains("M10 10L90 10") && !rest.contains("L20 30"), "{svg}");
    assert!(!svg.contains("95 10") && !svg.contains("90 70"), "{svg}");
    // Sizes are those of what is cut in front of the error; the blank has its own.
    assert!(svg.contains("X 10 to 90, Y 10 to 10, Z -5 to 5"), "{svg}");
    assert!(
        svg.contains("class=\"b\" d=\"M0 0L100 0L100 80L0 80Z\"") && svg.contains(">blank 100 x 80 x 20<"),
        "{svg}"
    );
    assert_eq!(svg.matches("<g ").count(), svg.matches("</g>").count());
    // On standard output, too; nothing is said beside the finding.
    let ran = folder.run(&["plot", "R.H", "--dimensions", "-o", "-"]).exits(1);
    assert!(ran.out == svg && !ran.err.contains("is incomplete"), "{}", ran.err);
    if cfg!(feature = "png") {
        folder.run(&["plot", "R.H", "-o", "r.png"]).exits(1).says("r.png is incomplete");
        assert!(folder.has("r.png"));
    }
}

#[test]
fn what_only_fails_by_request_is_whole() {
    let folder = Folder::new("refused_by_request").with(&[("W.H", &PART.replace("L X+10", "L X\u{2212}10"))]);
    let whole = folder.run(&["plot", "W.H", "-o", "-"]).exits(0).out;
    assert_eq!(folder.run(&["plot", "W.H", "-o", "-", "--fail-on", "warning"]).exits(1).out, whole);
    assert!(!whole.contains("incomplete") && !whole.contains("class=\"after\""), "{whole}");
    let whole = folder.run(&["trace", "W.H"]).exits(0).out;
    assert_eq!(folder.run(&["trace", "W.H", "--fail-on", "warning"]).exits(1).out, whole);
    assert!(!whole.contains("incomplete"), "{whole}");
}

#[test]
fn moves_stop_at_the_error_with_a_line_about_it() {
    let folder = refused("refused_trace");
    let out = folder.run(&["trace", "R.H"]).exits(1).out;
    let lines: Vec<Value> = out.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    let (last, moves) = lines.split_last().expect("lines");
    let of: Vec<_> = moves.iter().map(|line| line["line"].as_u64().expect("a line")).collect();
    assert_eq!(of, [5, 6, 7], "{out}");
    assert_eq!((&last["kind"], &last["code"]), (&Value::from("incomplete"), &Value::from("P1003")));
    assert_eq!((&last["file"], &last["line"], &last["block"]), (&"R.H".into(), &8.into(), &"7".into()));
    assert!(last["message"].as_str().is_some_and(|text| !text.is_empty()) && last.get("start").is_none());
    // What is in front of the error is what the whole program says there.
    folder.write("W.H", &REFUSED.replace("7 L X+95 R5\n", ""));
    let whole = folder.run(&["trace", "W.H"]).exits(0).out.replace("W.H", "R.H");
    let mut pairs = whole.lines().zip(out.lines()).take(2);
    assert!(pairs.all(|(whole, shown)| whole == shown), "{whole}\n{out}");
    let forms = if cfg!(feature = "columns") { &["csv", "arrow", "parquet"][..] } else { &["csv"] };
    for form in forms {
        let file = format!("r.{form}");
        folder.run(&["trace", "R.H", "-o", &file]).exits(1).says("--format jsonl");
        assert!(!folder.has(&file));
    }
}

/// The error of a called program: the picture names its file, and a program that never ends has all its moves.
#[test]
fn errors_in_called_programs_and_at_the_end_are_told() {
    let main = "0 BEGIN PGM M MM\n1 L X+10 Y+5 Z+2 R0 FMAX\n2 CALL PGM HOLE\n3 L X+20 FMAX\n4 END PGM M MM\n";
    let folder = Folder::new("refused_called").with(&[("M.H", main), ("HOLE.H", &HOLE.replace("L Z+2", "L Z+2 R5"))]);
    let svg = folder.run(&["plot", "M.H", "-o", "-", "--view", "xz"]).exits(1).out;
    assert!(svg.contains("incomplete: stops at line 3 of HOLE.H (P1003)"), "{svg}");
    let cut = "0 BEGIN PGM C MM\n1 L X+10 Y+5 Z+2 R0 FMAX\n2 L X+20 F100\n";
    folder.write("C.H", cut);
    let out = folder.run(&["trace", "C.H"]).exits(1).out;
    assert_eq!(out.lines().count(), 3, "{out}");
    let svg = folder.run(&["plot", "C.H", "-o", "-"]).exits(1).out;
    assert!(svg.contains(">incomplete: stops at line") && svg.contains("L20 5"), "{svg}");
}

#[test]
fn a_page_shows_the_path_and_lines_to_paste_and_no_code() {
    let text = "0 BEGIN PGM P MM\n1 TOOL CALL 5 Z S2000\n2 L X+0 Y+0 Z+5 R0 F300\n3 L X+50 RL F200\n4 L Y+50\n5 L Z+50 R0 FMAX M30\n6 END PGM P MM\n";
    let folder = Folder::new("refused_page").with(&[("sub/P.H", text)]);
    let page = folder.run(&["report", "sub/P.H", "-o", "-"]).exits(1).out;
    let part = |name: &str| {
        let (_, rest) = page.split_once(&format!("id=\"{name}\">\n")).expect("a part");
        decoded(rest.split('<').next().expect("letters"))
    };
    let made = part("made");
    let made = String::from_utf8_lossy(&made);
    assert!(
        made.contains("\"incomplete\":{\"code\":\"P9013\"") || made.contains("\"incomplete\":{\"code\":\""),
        "{made}"
    );
    assert!(!made.contains("G21") && !made.contains("M30\n"), "no code: {made}");
    let paste = String::from_utf8(part("paste")).expect("text");
    assert!(paste.contains("[tools") && paste.contains("radius") && !paste.contains("sub/"), "{paste}");
}

/// Letters of RFC 4648 as bytes.
fn decoded(letters: &str) -> Vec<u8> {
    let value = |letter: u8| match letter {
        b'A'..=b'Z' => u32::from(letter - b'A'),
        b'a'..=b'z' => u32::from(letter - b'a') + 26,
        b'0'..=b'9' => u32::from(letter - b'0') + 52,
        b'+' => 62,
        _ => 63,
    };
    let mut out = Vec::new();
    for four in letters.trim_end_matches('=').as_bytes().chunks(4) {
        let bits = four.iter().enumerate().fold(0, |bits, (i, letter)| bits | value(*letter) << (18 - 6 * i));
        out.extend(bits.to_be_bytes().iter().skip(1).take(four.len() - 1));
    }
    out
}
