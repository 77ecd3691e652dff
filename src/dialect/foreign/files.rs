//! Files that are told as a whole: containers by their first bytes, prose and tables by all of their lines.

use super::super::Dialect;
use super::line::Line;
use super::own::Own;
use super::way_on::WayOn;
use super::{Found, Kind, kinds, stands_for};

const NO_PROGRAM: WayOn = WayOn::Said(
    "no part program: if one was meant, get it anew from where it was made; else leave the file out with a line in \
     `.partcignore`",
);

/// A kind of file with its name, as it is counted and as it is called.
macro_rules! files {
    ($($kind:ident $name:literal $is:literal $way_on:expr;)*) => {
        $(static $kind: Kind = {
            static DIALECT: Dialect = stands_for($name);
            Kind { dialect: &DIALECT, is: $is, way_on: $way_on, marks: &[], sure: true, iso_sections: false, under: |_| true }
        };)*
    };
}

files! {
    PANEL_ARCHIVE "archives of an operator panel" "a binary archive of the operator panel of a SINUMERIK" WayOn::Said(
        "its programs cannot be read out of it here: read the archive in on the control or on a PC and export the programs one by one \
         (`.MPF`, `.SPF`), or as an archive in text (punched tape format)"
    );
    MARKUP "XML or HTML" "XML or HTML" NO_PROGRAM;
    JSON "JSON" "JSON" NO_PROGRAM;
    ZIP "ZIP" "a ZIP archive" WayOn::Said("unpack it, and compile the programs in it");
    PACKED "packed files" "a packed file" WayOn::Said("unpack it, and compile the programs in it");
    PDF "PDF" "a PDF document" NO_PROGRAM;
    EXECUTABLE "executables" "an executable program of a computer" NO_PROGRAM;
    IMAGE "images" "an image" NO_PROGRAM;
    DWG "DWG" "a drawing (DWG or binary DXF)" kinds::OF_CAM;
    MODEL "STL" "a model of a part (binary STL)" kinds::OF_CAM;
    BINARY "binary files" "a binary file, not text" NO_PROGRAM;
    TEXT "text" "text, not a part program" NO_PROGRAM;
    TABLE "CSV" "a table (CSV)" NO_PROGRAM;
}

/// First bytes, and what they show.
static MAGIC: &[(&[u8], &Kind)] = &[
    (b"PK\x03\x04", &ZIP),
    (b"PK\x05\x06", &ZIP),
    (b"\x1f\x8b", &PACKED),
    (b"Rar!\x1a", &PACKED),
    (b"7z\xbc\xaf", &PACKED),
    (b"\xfd7zXZ\x00", &PACKED),
    (b"\x28\xb5\x2f\xfd", &PACKED),
    (b"%PDF-", &PDF),
    (b"\x7fELF", &EXECUTABLE),
    (b"\x89PNG", &IMAGE),
    (b"\xff\xd8\xff", &IMAGE),
    (b"GIF8", &IMAGE),
    (b"AutoCAD Binary DXF", &DWG),
    (b"\xd0\xcf\x11\xe0", &BINARY),
];

/// What is no text of blocks at all, by its first bytes.
pub fn container(head: &[u8]) -> Option<&'static Kind> {
    let text = head.strip_prefix(b"\xef\xbb\xbf").unwrap_or(head).trim_ascii_start();
    if text.get(..5).is_some_and(|start| start.eq_ignore_ascii_case(b"@@MMC")) {
        return Some(&PANEL_ARCHIVE);
    }
    if is_markup(text) {
        return Some(&MARKUP);
    }
    if is_json(text) {
        return Some(&JSON);
    }
    if let Some((_, kind)) = MAGIC.iter().find(|(magic, _)| head.starts_with(magic)) {
        return Some(kind);
    }
    let begins = &head[..head.len().min(64)];
    if begins.contains(&0) && (head.starts_with(b"MZ") || head.starts_with(b"AC10")) {
        return Some(if head.starts_with(b"MZ") { &EXECUTABLE } else { &DWG });
    }
    if is_binary_stl(head) {
        return Some(&MODEL);
    }
    has_control_bytes(head).then_some(&BINARY)
}

/// `<?xml`, `<html>`, `<Program version="1">`: a tag that is closed, in itself or later.
fn is_markup(text: &[u8]) -> bool {
    let Some([next, ..]) = text.strip_prefix(b"<") else { return false };
    let head = &text[..text.len().min(4096)];
    let closes = head.windows(2).any(|two| two == b"</" || two == b"/>");
    matches!(next, b'?' | b'!') || next.is_ascii_alphabetic() && closes
}

/// An object whose first thing is a name in quotes, or an array of such things, texts or numbers.
fn is_json(text: &[u8]) -> bool {
    let inside = |text: &[u8]| text.get(1..).unwrap_or_default().trim_ascii_start().to_vec();
    let begins = |of: &[u8]| of.first().copied();
    match begins(text) {
        Some(b'{') => begins(&inside(text)) == Some(b'"') || text.trim_ascii() == b"{}",
        Some(b'[') => {
            let first = inside(&text[..text.len().min(256)]);
            match begins(&first) {
                Some(b'{') => begins(&inside(&first)).is_some_and(|next| next == b'"' || next == b'}'),
                Some(b'"') => {
                    let mut parts = first.splitn(3, |b| *b == b'"').skip(2);
                    parts.next().is_some_and(|rest| matches!(begins(rest.trim_ascii_start()), Some(b',' | b']')))
                }
                _ => text.contains(&b',') && text.iter().all(|b| b.is_ascii_digit() || b"[], \t\r\n.-+eE".contains(b)),
            }
        }
        _ => false,
    }
}

/// Eighty bytes of anything, a count, and as many facets of fifty bytes as there are.
fn is_binary_stl(head: &[u8]) -> bool {
    let Some(&[a, b, c, d]) = head.get(80..84) else { return false };
    let facets = u64::from(u32::from_le_bytes([a, b, c, d]));
    let size = 84 + facets * 50;
    let fits = size == head.len() as u64 || size > head.len() as u64 && head.len() == super::HEAD as usize;
    facets > 0 && facets < 1 << 26 && fits && head.get(132..134) == Some(&[0, 0])
}

/// One of twenty bytes is none of text. Line ends, tabs, what punched tapes begin with, and NUL and Ctrl-Z, of which findings of
/// their own tell, are no proof.
fn has_control_bytes(head: &[u8]) -> bool {
    let odd = |byte: &&u8| matches!(**byte, 1..=8 | 0x0e..=0x10 | 0x15..=0x19 | 0x1c..=0x1f);
    let count = head.iter().filter(odd).count();
    count >= 16 && count * 20 > head.len()
}

/// Prose, or a table, in a file whose extension is one of ours. Where a line looks like one of that language (`is_own`), as the
/// head of a table may, only a table is looked for.
pub fn as_a_whole(own: Own, lines: &[Line<'_>], is_own: bool) -> Option<Found> {
    if matches!(own, Own::Nothing | Own::Plain) {
        return None;
    }
    let found = |kind: &'static Kind, line: &Line<'_>| Found {
        kind,
        evidence: vec![(line.number, line.span().shifted(line.start))],
    };
    if let Some(line) = lines.iter().find(|line| is_prose(line)).filter(|_| !is_own && is_text(lines)) {
        return Some(found(&TEXT, line));
    }
    lines.first().filter(|_| is_table(lines)).map(|line| found(&TABLE, line))
}

/// Nearly every line is prose; or in a short text each is, or is a heading or an item of a list.
fn is_text(lines: &[Line<'_>]) -> bool {
    let count = lines.iter().filter(|line| is_prose(line)).count();
    let fits = lines.iter().all(|line| is_prose(line) || is_heading(line));
    let is_sentence = |line: &Line<'_>| matches!(line.text.trim_ascii().last(), Some(b'.' | b'!' | b'?' | b':'));
    count >= 3 && count * 10 > lines.len() * 7
        || fits && count * 5 >= lines.len() && (lines.len() > 1 || lines.iter().all(is_sentence))
}

/// Prose: four words of small letters, or three of a sentence.
fn is_prose(line: &Line<'_>) -> bool {
    let text = line.text.trim_ascii();
    let is_comment = matches!(text.first(), Some(b';' | b'(' | b'[' | b'%'));
    let is_of_word = |b: &u8| b.is_ascii_lowercase() || *b >= 0x80 || b",.:'!?-()\"`".contains(b);
    let small = |word: &&[u8]| word.len() > 1 && word[1..].iter().all(is_of_word);
    let words = text.split(|b| b.is_ascii_whitespace()).filter(small).count();
    let least = if matches!(text.last(), Some(b'.' | b'!' | b'?')) { 3 } else { 4 };
    !is_comment && words >= least && !text.contains(&b'=')
}

/// `# Title`, `- item`, `=====`, or a few words.
fn is_heading(line: &Line<'_>) -> bool {
    let text = line.text.trim_ascii();
    let is_rule = text.len() > 2 && text.iter().all(|b| *b == text[0]) && b"=-*`~".contains(&text[0]);
    let is_marked = [&b"# "[..], b"## ", b"### ", b"- ", b"* "].iter().any(|mark| text.starts_with(mark));
    let is_words = text.iter().all(|b| b.is_ascii_alphabetic() || *b >= 0x80 || b" ,.:'!?-".contains(b))
        && text.iter().any(u8::is_ascii_lowercase);
    is_rule || is_marked || is_words
}

/// Lines of a table that are looked at.
const ROWS: usize = 50;

/// Each line has as many fields as the first, and each but the first holds a number.
fn is_table(lines: &[Line<'_>]) -> bool {
    [b',', b';', b'\t'].iter().any(|between| {
        let fields = |line: &Line<'_>| -> Vec<Vec<u8>> {
            line.text.split(|b| b == between).map(|field| field.trim_ascii().to_vec()).collect()
        };
        let Some(first) = lines.first().map(fields) else { return false };
        let least = if *between == b',' { 2 } else { 3 };
        let fits = |line: &Line<'_>| {
            let row = fields(line);
            row.len() == first.len()
                && row.first().is_some_and(|field| !field.is_empty())
                && row.iter().all(|field| is_number(field) || is_label(field))
                && row.iter().any(|field| is_number(field))
        };
        let is_head = first.iter().all(|field| is_label(field));
        lines.len() > 1
            && first.len() >= least
            // Behind a semicolon stand comments, too.
            && (is_head || *between != b';' && lines.first().is_some_and(fits))
            && lines.iter().skip(1).take(ROWS).all(fits)
    })
}

fn is_number(field: &[u8]) -> bool {
    std::str::from_utf8(field).is_ok_and(|field| field.parse::<f64>().is_ok())
}

/// Empty, quoted, or words without a digit.
fn is_label(field: &[u8]) -> bool {
    let is_quoted = field.len() > 1 && field.starts_with(b"\"") && field.ends_with(b"\"");
    is_quoted || field.iter().all(|b| b.is_ascii_alphabetic() || *b >= 0x80 || b" _-/().%".contains(b))
}
