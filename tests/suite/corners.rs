//! What stands at a corner does not part it from its elements: comments, M functions in the blocks of the elements,
//! blocks between them. One matrix over all dialects that have corners.
//!
//! The contour is one corner of 90 degrees at X40 Y0 (X40 Z-30 on a lathe). Each row says what stands where, and in front
//! of which of the three moves (element, inserted, element) it has to come out; 3 is behind them.

use partc::internals::machine::Settings;
use partc::internals::text::files::NoFiles;

use super::common::compile_bytes;

/// A corner of a dialect: `{before}` ends the block of the first element, `{own}` are blocks in front of the corner's
/// own, `{corner}` ends that, `{behind}` are blocks behind the corner, `{after}` ends the block of the second element.
struct Form {
    dialect: &'static str,
    name: &'static str,
    text: &'static str,
    moves: [&'static str; 3],
}

const KLARTEXT: [Form; 2] = [
    Form {
        dialect: "klartext",
        name: "RND",
        text: "0 BEGIN PGM A MM\nL X+0 Y+0 R0 F200\nL X+40{before}\n{own}RND R6{corner}\n{behind}L Y+30{after}\nEND PGM A MM\n",
        moves: ["G1 X34", "G3 X40 Y6 I0 J6", "G1 Y30"],
    },
    Form {
        dialect: "klartext",
        name: "CHF",
        text: "0 BEGIN PGM A MM\nL X+0 Y+0 R0 F200\nL X+40{before}\n{own}CHF 6{corner}\n{behind}L Y+30{after}\nEND PGM A MM\n",
        moves: ["G1 X34", "G1 X40 Y6", "G1 Y30"],
    },
];

const MTC200: [Form; 2] = [
    Form {
        dialect: "mtc200",
        name: "RD",
        text: "G90 G00 X0 Y0\nG01 X40 F200{before}\n{own}RD6{corner}\n{behind}Y30{after}\nRET\n",
        moves: ["G1 X34 F200", "G3 X40 Y6 I0 J6", "G1 Y30"],
    },
    Form {
        dialect: "mtc200",
        name: "CF",
        text: "G90 G00 X0 Y0\nG01 X40 F200{before}\n{own}CF6{corner}\n{behind}Y30{after}\nRET\n",
        moves: ["G1 X34 F200", "G1 X40 Y6", "G1 Y30"],
    },
];

/// The corner is a word of the first element's block.
const SINUMERIK: [Form; 4] = [
    Form {
        dialect: "sinumerik",
        name: "RND",
        text: "G0 X0 Y0\nG1 X40 F200 RND=6{before}\n{behind}Y30{after}\nM30\n",
        moves: ["G1 X34 F200", "G3 X40 Y6 I0 J6", "G1 Y30"],
    },
    Form {
        dialect: "sinumerik",
        name: "CHR",
        text: "G0 X0 Y0\nG1 X40 F200 CHR=6{before}\n{behind}Y30{after}\nM30\n",
        moves: ["G1 X34 F200", "G1 X40 Y6", "G1 Y30"],
    },
    Form {
        dialect: "sinumerik",
        name: "CHF",
        text: "G0 X0 Y0\nG1 X40 F200 CHF=8.48528137{before}\n{behind}Y30{after}\nM30\n",
        moves: ["G1 X34 F200", "G1 X40 Y6", "G1 Y30"],
    },
    Form {
        dialect: "sinumerik",
        name: "RNDM",
        text: "G0 X0 Y0\nG1 X40 F200 RNDM=6{before}\n{behind}Y30{after}\nM30\n",
        moves: ["G1 X34 F200", "G3 X40 Y6 I0 J6", "G1 Y30"],
    },
];

const TURNING: [Form; 2] = [
    Form {
        dialect: "heidenhain-turning",
        name: "B",
        text: "%1.nc\nG94 F200 G97 S1000 M3\nG0 X80 Z0\nG1 Z-30 B6{before}\n{behind}G1 X120{after}\nEND\n",
        moves: ["G1 Z-24 F200", "G2 X46 Z-30 I6 K0", "G1 X60"],
    },
    Form {
        dialect: "heidenhain-turning",
        name: "B-",
        text: "%1.nc\nG94 F200 G97 S1000 M3\nG0 X80 Z0\nG1 Z-30 B-6{before}\n{behind}G1 X120{after}\nEND\n",
        moves: ["G1 Z-24 F200", "G1 X46 Z-30", "G1 X60"],
    },
];

/// What is put in: the slot, its text, what is printed, in front of which move, and the warning.
type Row = (&'static str, &'static str, &'static str, usize, Option<&'static str>);

const KLARTEXT_ROWS: &[Row] = &[
    ("before", " ; note", "(note)", 0, None),
    ("before", " M3", "M3", 0, None),
    ("before", " M8", "M8", 0, None),
    ("before", " M13", "M3 M8", 0, None),
    ("before", " M5", "M5", 1, None),
    ("before", " M9", "M9", 1, None),
    ("before", " M1", "M1", 1, None),
    ("before", " M0", "M0", 1, None),
    ("before", " M19", "M19 R0", 1, None),
    ("before", " M5 M9", "M5 M9", 1, None),
    ("own", "; note\n", "(note)", 1, None),
    ("own", "* - note\n", "(- note)", 1, None),
    ("own", "; note\n; more\n* - again\n", "(note) (more) (- again)", 1, None),
    ("own", "\n", "", 1, None),
    ("own", "Q1 = 5\n", "", 1, None),
    ("own", "LBL 7\n", "", 1, None),
    ("own", "M8\n", "M8", 1, Some("G3090")),
    ("own", "M9\n", "M9", 1, Some("G3090")),
    ("own", "L M5\n", "M5", 1, Some("G3090")),
    ("corner", " ; note", "(note)", 1, None),
    ("behind", "; note\n", "(note)", 2, None),
    ("behind", "* - note\n", "(- note)", 2, None),
    ("behind", "M8\n", "M8", 2, Some("G3090")),
    ("after", " ; note", "(note)", 2, None),
    ("after", " M8", "M8", 2, None),
    ("after", " M9", "M9", 3, None),
];

const MTC200_ROWS: &[Row] = &[
    ("before", " (note)", "(note)", 0, None),
    ("before", " M8", "M8", 0, None),
    ("before", " M9", "M9", 1, None),
    ("before", " M5", "M5", 1, None),
    ("own", "; note\n", "(note)", 1, None),
    ("own", "(note)\n", "(note)", 1, None),
    ("corner", " (note)", "(note)", 1, None),
    ("behind", "; note\n", "(note)", 2, None),
    ("behind", "M8\n", "M8", 2, None),
    ("behind", "M5\n", "M5", 2, None),
    ("after", " (note)", "(note)", 2, None),
    ("after", " M8", "M8", 2, None),
    ("after", " M9", "M9", 3, None),
];

/// Blocks without a move, and what begins the next block, come before the inserted element (MD 20201 bit 0 = 0).
const SINUMERIK_ROWS: &[Row] = &[
    ("before", " ; note", "(note)", 0, None),
    ("before", " M3 S100", "S100 M3", 0, None),
    ("before", " M8", "M8", 0, None),
    ("before", " M9", "M9", 0, None),
    ("before", " M5", "M5", 0, None),
    ("before", " M1", "M1", 1, None),
    ("before", " M0", "M0", 1, None),
    ("behind", "; note\n", "(note)", 1, None),
    ("behind", "M8\n", "M8", 1, None),
    ("behind", "M9 ; note\n", "(note) M9", 1, None),
    ("behind", "M5\n", "M5", 1, None),
    ("after", " ; note", "(note)", 1, None),
    ("after", " M8", "M8", 1, None),
    ("after", " M1", "M1", 3, None),
];

/// A corner belongs to the block of its element: what ends that comes after the corner.
const TURNING_ROWS: &[Row] = &[
    ("before", " [note]", "(note)", 0, None),
    ("before", " M8", "M8", 0, None),
    ("before", " M9", "M9", 2, None),
    ("before", " M5", "M5", 2, None),
    ("behind", "[note]\n", "(note)", 2, None),
    ("behind", "M8\n", "M8", 2, None),
    ("after", " [note]", "(note)", 2, None),
    ("after", " M8", "M8", 2, None),
    ("after", " M9", "M9", 3, None),
];

fn compile(form: &Form, put: (&str, &str)) -> (Vec<String>, Vec<&'static str>, Vec<String>) {
    let mut text = form.text.to_owned();
    for slot in ["before", "own", "corner", "behind", "after"] {
        text = text.replace(&format!("{{{slot}}}"), if slot == put.0 { put.1 } else { "" });
    }
    let settings = Settings::default();
    let made = compile_bytes("A", text.into_bytes(), form.dialect, &settings, &NoFiles);
    (made.output.lines().map(str::to_owned).collect(), made.codes(), made.rendered)
}

fn check(forms: &[Form], rows: &[Row]) {
    for form in forms {
        let (plain, _, said) = compile(form, ("", ""));
        let at = plain
            .windows(3)
            .position(|lines| lines.iter().eq(&form.moves))
            .unwrap_or_else(|| panic!("{} {}: {plain:#?} {said:#?}", form.dialect, form.name));
        for &(slot, put, printed, place, warning) in rows {
            if !form.text.contains(&format!("{{{slot}}}")) {
                continue;
            }
            let (output, codes, said) = compile(form, (slot, put));
            let mut expected = plain.clone();
            // `(` begins a comment, which may have blanks.
            let words = printed.replace(" (", "\n(").replace(" M", "\nM");
            expected.splice(at + place..at + place, words.lines().map(str::to_owned));
            // The head names the source by its hash.
            let body = |lines: &[String]| lines.iter().filter(|l| !l.contains("hash")).cloned().collect::<Vec<_>>();
            let what = format!("{} {} with {put:?} at {slot}", form.dialect, form.name);
            assert_eq!(body(&output), body(&expected), "{what}: {said:#?}");
            assert_eq!(codes.contains(&"G3090"), warning.is_some(), "{what}: {said:#?}");
        }
    }
}

#[test]
fn klartext_corners_keep_their_neighbours() {
    check(&KLARTEXT, KLARTEXT_ROWS);
}

#[test]
fn mtc200_corners_keep_their_neighbours() {
    check(&MTC200, MTC200_ROWS);
}

#[test]
fn sinumerik_corners_keep_their_neighbours() {
    check(&SINUMERIK, SINUMERIK_ROWS);
}

#[test]
fn turning_corners_keep_their_neighbours() {
    check(&TURNING, TURNING_ROWS);
}

/// No page of the manual lets these stand between a corner and its element.
#[test]
fn blocks_that_part_a_klartext_corner() {
    let parting = ["STOP\n", "L Z+5\n", "TOOL CALL 2 Z S100\n", "TOOL CALL S100\n", "M0\n"];
    let dwell = "CYCL DEF 9.0 DWELL TIME\nCYCL DEF 9.1 DWELL 1\n";
    for form in &KLARTEXT {
        for slot in ["own", "behind"] {
            for put in parting.into_iter().chain([dwell]) {
                let (_, codes, said) = compile(form, (slot, put));
                assert!(codes.contains(&"G3007"), "{} with {put:?} at {slot}: {said:#?}", form.name);
            }
        }
    }
}

/// Far more comments than any program has between a corner and its element are too many, which is said.
#[test]
fn comments_without_end_do_not_grow_the_memory() {
    let put = "; note\n".repeat(1000);
    let (_, codes, _) = compile(&KLARTEXT[0], ("own", &put));
    assert!(codes.contains(&"G3007"));
}
