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
    /// `CON`: names of abscissa and ordinate.
    Header {
        axes: Option<(u8, u8)>,
    },
    /// `S`: start of the contour.
    Start(Keys),
    Line(Heading, Keys),
    Arc {
        ccw: bool,
        keys: Keys,
    },
    /// `R`: radius in mm; 0 for none.
    Rounding(f64),
    /// `F`: leg of the chamfer in mm; 0 for none.
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

/// What was typed; `None` where nothing was. Lengths in mm as written, angles in degrees.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Keys {
    /// End point, absolute; `ey` is a diameter in a contour of diameters.
    pub ex: Option<f64>,
    pub ey: Option<f64>,
    /// End point from the start of the element; `dey` is a radius.
    pub dex: Option<f64>,
    pub dey: Option<f64>,
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
    /// A key that this reader does not know.
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
        return Some(Record::Header { axes: axes(fields) });
    }
    let keys: Vec<(&str, &str)> = parts.map(|part| part.split_once(':').unwrap_or((part, ""))).collect();
    let value = |name: &str| keys.iter().find(|(key, _)| *key == name).and_then(|(_, v)| number(v));
    Some(match code {
        "S" => Record::Start(read_keys(&keys)),
        "LL" => Record::Line(Heading::Left, read_keys(&keys)),
        "LR" => Record::Line(Heading::Right, read_keys(&keys)),
        "LU" => Record::Line(Heading::Up, read_keys(&keys)),
        "LD" => Record::Line(Heading::Down, read_keys(&keys)),
        "LA" => Record::Line(Heading::Any, read_keys(&keys)),
        "ACW" => Record::Arc { ccw: false, keys: read_keys(&keys) },
        "ACCW" => Record::Arc { ccw: true, keys: read_keys(&keys) },
        "R" => value("RROUND").map_or(Record::Unknown(code.to_owned()), Record::Rounding),
        "F" => value("LFASE").map_or(Record::Unknown(code.to_owned()), Record::Chamfer),
        "AB" => undercut(value).map_or(Record::Unknown(code.to_owned()), Record::Undercut),
        _ => Record::Unknown(code.to_owned()),
    })
}

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

fn number(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|v: &f64| v.is_finite() && v.abs() < 1e9)
}

fn read_keys(list: &[(&str, &str)]) -> Keys {
    let mut keys = Keys::default();
    for (name, value) in list {
        let value = *value;
        match *name {
            "EX" => keys.ex = number(value),
            "EY" => keys.ey = number(value),
            "DEX" => keys.dex = number(value),
            "DEY" => keys.dey = number(value),
            "CX" => keys.cx = number(value),
            "CY" => keys.cy = number(value),
            "RAD" => keys.rad = number(value),
            "ASE" => keys.ase = number(value),
            "AT" => keys.at = number(value),
            "AA" => keys.aa = number(value),
            "DST" => keys.dst = number(value),
            "DIA" => {
                let whole = |text: &str| text.trim().parse().unwrap_or(0);
                keys.dia = value.split_once('/').map_or((whole(value), 0), |(a, b)| (whole(a), whole(b)));
            }
            // How the dialog was shown.
            "ATT" => {}
            _ => keys.unknown = true,
        }
    }
    keys
}

fn undercut(value: impl Fn(&str) -> Option<f64>) -> Option<Undercut> {
    let index = || value("IDX").filter(|i| *i >= 0.0 && *i < 1000.0).map(|i| i as u32);
    match value("FRM").unwrap_or(0.0) {
        0.0 => Some(Undercut::E(index()?)),
        1.0 => Some(Undercut::F(index()?)),
        2.0 => Some(Undercut::Thread { pitch: value("P"), entry: value("ALFA") }),
        3.0 => Some(Undercut::Free),
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
        assert_eq!(header, Some(Record::Header { axes: Some((b'Z', b'X')) }));
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
    fn other_comments_are_no_records() {
        for text in ["; LL,EX:5", ";LL,EX:5", ";#SM Z:2", "; note ;*GP*", ";", "", ";*GP*;*HD*", ";(;*GP*;*RO*;*HD*"] {
            assert_eq!(read(text.as_bytes()), None, "{text}");
        }
        assert_eq!(read(b";LL,EX:\xff;*GP*;*HD*"), None);
    }
}
