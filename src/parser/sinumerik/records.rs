//! Hidden records of the contour editor: comment lines that hold what the operator typed.
//!
//! In: the text of one comment. Out: the record as data; what it means for the geometry is decided elsewhere. Such
//! lines stand between `;#7__DlgK … begin` and `;#End … end`, behind the NC blocks that the editor made of them.

/// A line of a stored contour.
#[derive(Debug, Clone, PartialEq)]
pub enum Record {
    /// `;#7__DlgK contour definition begin`
    Begin,
    /// `;#End contour definition end`
    End,
    /// `CON`: names of abscissa and ordinate, and whether the editor made a turned contour, in diameters, or a milled one.
    Header {
        axes: Option<(u8, u8)>,
        turned: Option<bool>,
    },
    /// `S`: start of the contour.
    Start(Keys),
    Line(Heading, Keys),
    Arc {
        ccw: bool,
        keys: Keys,
    },
    /// `R`: radius; 0 for none.
    Rounding(f64),
    /// `F`: leg of the chamfer; 0 for none.
    Chamfer(f64),
    Undercut(Undercut),
    /// A code this reader does not know: the pole, polar elements, what newer editors write.
    Unknown(String),
}

/// Direction that a line has by its code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Heading {
    /// `LL`: 180 degrees.
    Left,
    /// `LR`: 0 degrees.
    Right,
    /// `LU`: 90 degrees.
    Up,
    /// `LD`: 270 degrees.
    Down,
    /// `LA`
    Any,
}

/// What was typed; `None` where nothing was. Lengths as written, in the unit of the program; angles in degrees.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Keys {
    /// End point, absolute; `ey` is a diameter in a contour of diameters.
    pub ex: Option<f64>,
    pub ey: Option<f64>,
    /// Abscissa of the end point from the start of the element. The key of the ordinate was never seen.
    pub dex: Option<f64>,
    /// Centre, absolute; `cy` as `ey`.
    pub cx: Option<f64>,
    pub cy: Option<f64>,
    pub rad: Option<f64>,
    /// Direction of a line, or of an arc at its end; at the start point, in front of the contour.
    pub ase: Option<f64>,
    /// Angle to the element before; 0 for tangential.
    pub at: Option<f64>,
    /// Opening angle.
    pub aa: Option<f64>,
    /// Grinding allowance to the right of the element.
    pub dst: Option<f64>,
    /// Which of several solutions was chosen: for the end, for the centre.
    pub dia: (u32, u32),
    /// A key that this reader does not know or that stands twice, or a value that is no number.
    pub unknown: bool,
}

/// `AB`
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Undercut {
    /// Form E of the size with this index.
    E(u32),
    /// Form F of the size with this index.
    F(u32),
    /// Thread undercut by pitch and entry angle.
    Thread { pitch: Option<f64>, entry: Option<f64> },
    /// The free thread undercut, whose keys are not known.
    Free,
}

/// Reads the line of a stored contour; `None` for any other comment. `text` begins with the semicolon.
pub fn read(text: &[u8]) -> Option<Record> {
    let text = core::str::from_utf8(text).ok()?.trim();
    let body = text.strip_prefix(';')?.trim_start();
    if let Some(dialog) = body.strip_prefix('#') {
        let number = dialog.trim_start_matches(|c: char| c.is_ascii_digit());
        return match () {
            () if number.len() < dialog.len() && number.starts_with("__DlgK contour definition begin") => {
                Some(Record::Begin)
            }
            () if dialog.starts_with("End contour definition end") => Some(Record::End),
            () => None,
        };
    }
    // Every record carries the marks of the editor.
    let (fields, marks) = body.split_once(';')?;
    if !(marks.contains("*GP*") && marks.contains("*HD*")) {
        return None;
    }
    let mut parts = split(fields);
    let code = parts.next()?.trim();
    if code.is_empty() || !code.bytes().all(|b| b.is_ascii_uppercase()) {
        return None;
    }
    if code == "CON" {
        return Some(Record::Header { axes: axes(fields), turned: turned(fields) });
    }
    let keys: Vec<(&str, &str)> = parts.map(|part| part.split_once(':').unwrap_or((part, ""))).collect();
    let value = |name: &str| keys.iter().find(|(key, _)| *key == name).and_then(|(_, v)| number(v));
    // Transitions have few keys: one more would change the corner.
    let only = |known: &[&str]| {
        let mut seen = keys.iter().map(|(key, _)| *key).filter(|key| *key != DISPLAY);
        seen.all(|key| known.contains(&key) && keys.iter().filter(|(other, _)| *other == key).count() == 1)
    };
    let unknown = || Record::Unknown(fields.trim().to_owned());
    Some(match code {
        "S" => Record::Start(read_keys(&keys)),
        "LL" => Record::Line(Heading::Left, read_keys(&keys)),
        "LR" => Record::Line(Heading::Right, read_keys(&keys)),
        "LU" => Record::Line(Heading::Up, read_keys(&keys)),
        "LD" => Record::Line(Heading::Down, read_keys(&keys)),
        "LA" => Record::Line(Heading::Any, read_keys(&keys)),
        "ACW" => Record::Arc { ccw: false, keys: read_keys(&keys) },
        "ACCW" => Record::Arc { ccw: true, keys: read_keys(&keys) },
        "R" if only(&["RROUND"]) => value("RROUND").map_or_else(unknown, Record::Rounding),
        "F" if only(&["LFASE"]) => value("LFASE").map_or_else(unknown, Record::Chamfer),
        "AB" => match undercut(&keys) {
            Some((undercut, known)) if known.is_empty() || only(known) => Record::Undercut(undercut),
            _ => unknown(),
        },
        "R" | "F" => unknown(),
        _ => Record::Unknown(code.to_owned()),
    })
}

/// Is it a line that was meant as a record, though it is none that can be read? `text` is without its semicolon.
pub fn is_spoiled(text: &[u8]) -> bool {
    let text = text.trim_ascii();
    let code = text.split(|b| matches!(b, b',' | b';')).next().unwrap_or_default().trim_ascii();
    let marked = code.first().is_some_and(u8::is_ascii_alphanumeric) && text.windows(4).any(|mark| mark == b"*HD*");
    marked || CODES.iter().any(|known| code.eq_ignore_ascii_case(known)) && text.contains(&b',')
}

/// Codes of records.
const CODES: [&[u8]; 12] = [b"CON", b"S", b"LL", b"LR", b"LU", b"LD", b"LA", b"ACW", b"ACCW", b"R", b"F", b"AB"];

/// Fields between commas that do not stand in brackets.
fn split(fields: &str) -> impl Iterator<Item = &str> {
    let mut depth = 0_i32;
    fields.split(move |c: char| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        c == ',' && depth <= 0
    })
}

fn axes(fields: &str) -> Option<(u8, u8)> {
    let (_, rest) = fields.split_once("AX:")?;
    let mut names = rest.split(',');
    let mut letter = || match names.next()?.as_bytes() {
        [letter] if letter.is_ascii_alphabetic() => Some(letter.to_ascii_uppercase()),
        _ => None,
    };
    Some((letter()?, letter()?))
}

/// The settings of the editor: 3 for turning, with `DIAM90` in the plane block, 0 for milling, with `DIAMOF`.
fn turned(fields: &str) -> Option<bool> {
    let (_, rest) = fields.split_once("MST:")?;
    match rest.split(',').next()?.trim() {
        "3" => Some(true),
        "0" => Some(false),
        _ => None,
    }
}

fn number(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|v: &f64| v.is_finite() && v.abs() < 1e9)
}

fn read_keys(list: &[(&str, &str)]) -> Keys {
    let mut keys = Keys::default();
    let mut chosen = None;
    for (name, value) in list {
        let place = match *name {
            "EX" => &mut keys.ex,
            "EY" => &mut keys.ey,
            "DEX" => &mut keys.dex,
            "CX" => &mut keys.cx,
            "CY" => &mut keys.cy,
            "RAD" => &mut keys.rad,
            "ASE" => &mut keys.ase,
            "AT" => &mut keys.at,
            "AA" => &mut keys.aa,
            "DST" => &mut keys.dst,
            "DIA" => {
                let choice = choice(value);
                keys.unknown |= chosen.is_some() || choice.is_none();
                chosen = choice;
                continue;
            }
            DISPLAY => continue,
            _ => {
                keys.unknown = true;
                continue;
            }
        };
        keys.unknown |= place.is_some();
        *place = number(value);
        keys.unknown |= place.is_none();
    }
    keys.dia = chosen.unwrap_or_default();
    keys
}

/// How the dialog was shown.
const DISPLAY: &str = "ATT";

/// The stored choices: of the end, and of the centre.
fn choice(text: &str) -> Option<(u32, u32)> {
    let (end, center) = text.split_once('/').unwrap_or((text, "0"));
    Some((end.trim().parse().ok()?, center.trim().parse().ok()?))
}

/// The undercut and the keys it may have; no keys where they are not known.
fn undercut(keys: &[(&str, &str)]) -> Option<(Undercut, &'static [&'static str])> {
    let written = |name: &str| keys.iter().find(|(key, _)| *key == name).map(|(_, v)| number(v));
    let value = |name: &str| written(name).flatten();
    let index = || value("IDX").filter(|i| (0.0..1000.0).contains(i) && i.fract() == 0.0).map(|i| i as u32);
    match written("FRM").unwrap_or(Some(0.0))? {
        0.0 => Some((Undercut::E(index()?), &["FRM", "IDX"])),
        1.0 => Some((Undercut::F(index()?), &["FRM", "IDX"])),
        2.0 => Some((Undercut::Thread { pitch: value("P"), entry: value("ALFA") }, &["FRM", "P", "ALFA"])),
        3.0 => Some((Undercut::Free, &[])),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(text: &str) -> Option<Record> {
        read(format!("{text};*GP*;*RO*;*HD*\r").as_bytes())
    }

    #[test]
    fn records_of_all_kinds() {
        assert_eq!(line(";#7__DlgK contour definition begin - Don't change!"), Some(Record::Begin));
        assert_eq!(line(";#End contour definition end - Don't change!"), Some(Record::End));
        let header = line(";CON,V64,2,0.0000,0,0,MST:3,2,AX:Z,X,K,I,TRANS:0");
        assert_eq!(header, Some(Record::Header { axes: Some((b'Z', b'X')), turned: Some(true) }));
        let keys = Keys { ex: Some(-0.5), ..Keys::default() };
        assert_eq!(line(";LL,EX:-.5"), Some(Record::Line(Heading::Left, keys)));
        assert_eq!(line(";LU"), Some(Record::Line(Heading::Up, Keys::default())));
        let Some(Record::Arc { ccw: true, keys }) = line(";ACCW,DIA:0/235,EX:1,CY:.25,RAD:4,ATT:APP(ALL,PARA)") else {
            panic!()
        };
        assert_eq!((keys.dia, keys.cy, keys.rad, keys.unknown), ((0, 235), Some(0.25), Some(4.0), false));
        assert_eq!(line(";R,RROUND:2"), Some(Record::Rounding(2.0)));
        assert_eq!(line(";AB,IDX:4"), Some(Record::Undercut(Undercut::E(4))));
        assert_eq!(line(";AB,FRM:1,IDX:4"), Some(Record::Undercut(Undercut::F(4))));
        let thread = Undercut::Thread { pitch: Some(3.0), entry: Some(30.0) };
        assert_eq!(line(";AB,FRM:2,P:3,ALFA:30"), Some(Record::Undercut(thread)));
        assert_eq!(line(";AB,FRM:3,X:1"), Some(Record::Undercut(Undercut::Free)));
        assert_eq!(line(";POL,EX:1"), Some(Record::Unknown("POL".to_owned())));
        assert!(matches!(line(";LA,L:5"), Some(Record::Line(_, Keys { unknown: true, .. }))));
    }

    #[test]
    fn what_cannot_be_read_is_not_left_out() {
        for text in
            ["LL,EX:3x", "LL,EX:", "LL,EX:1,5", "LL,EX:1,EX:1", "LU,EY:nan", "ACW,DIA:a/b", "ACW,DIA:7/0,DIA:7/0"]
        {
            let keys = match line(&format!(";{text}")) {
                Some(Record::Line(_, keys) | Record::Arc { keys, .. }) => keys,
                other => panic!("{text}: {other:?}"),
            };
            assert!(keys.unknown, "{text}");
        }
        for text in [
            "R,RROUND:2,FRC:.1",
            "F,LFASE:1,LFASE:2",
            "R,RROUND:x",
            "AB,IDX:4.5",
            "AB,IDX:4,P:2",
            "AB,FRM:7",
            "AB,FRM:,IDX:4",
        ] {
            assert!(matches!(line(&format!(";{text}")), Some(Record::Unknown(_))), "{text}");
        }
        assert_eq!(line(";R,RROUND:1e-1,ATT:APP(ALLPARA)"), Some(Record::Rounding(0.1)));
    }

    #[test]
    fn spoiled_records_are_told_from_comments() {
        for text in ["LL,EX:5", "ll,EX:5;*GP*;*RO*;*HD*", "LL,EX:\u{e9};*GP*;*HD*", "XY;*HD*", "3;*GP*;*HD*"] {
            assert!(is_spoiled(text.as_bytes()), "{text}");
        }
        for text in ["", "rough it, then finish", "F", "*GP*;*RO*;*HD*", "#SM Z:2", "LL is the first line"] {
            assert!(!is_spoiled(text.as_bytes()), "{text}");
        }
    }

    #[test]
    fn other_comments_are_no_records() {
        for text in ["; LL,EX:5", ";LL,EX:5", ";#SM Z:2", "; note ;*GP*", ";", "", ";*GP*;*HD*", ";(;*GP*;*RO*;*HD*"] {
            assert_eq!(read(text.as_bytes()), None, "{text}");
        }
        assert_eq!(read(b";LL,EX:\xff;*GP*;*HD*"), None);
    }
}
