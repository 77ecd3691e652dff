//! HEIDENHAIN turning: MANUALplus 4110 DIN programs, DIN PLUS and smart.Turn.

use crate::sema::turning;

use super::Dialect;

pub(super) const DIALECT: Dialect = Dialect {
    id: "heidenhain-turning",
    name: "HEIDENHAIN turning",
    extensions: &["nc", "ncs"],
    recognizes,
    disowns,
    turns: true,
    folders: &[],
    run: turning::run,
    check_form: turning::check_form,
    check_unexecuted: None,
    comment: ["[", "(", ")", "]"],
    numbers_by_one: true,
    survey: turning::survey,
    cycles: turning::cycle_signatures,
};

/// A name line `%name.nc` with a title in square brackets behind it, or the section codes of DIN PLUS.
fn recognizes(head: &[u8]) -> bool {
    let mut named = false;
    for line in head.split(|b| matches!(b, b'\n' | b'\r')) {
        let line = line.strip_prefix(b"\xef\xbb\xbf").unwrap_or(line).trim_ascii();
        if line.is_empty() {
            continue;
        }
        if named && line.first() == Some(&b'[') {
            return true;
        }
        let upper = line.to_ascii_uppercase();
        named = upper.first() == Some(&b'%') && (upper.ends_with(b".NC") || upper.ends_with(b".NCS"));
        let sections: [&[u8]; 6] =
            [b"PROGRAMMKOPF", b"PROGRAM HEAD", b"BEARBEITUNG", b"MACHINING", b"FERTIGTEIL", b"FINISHED PART"];
        if sections.contains(&upper.as_slice()) {
            return true;
        }
    }
    false
}

/// Words of other controls: `%` and a program number behind it, a tool change by M6, a length by G43 H, or a safety block such as
/// `G90 G21 G94`.
fn disowns(head: &[u8]) -> bool {
    const SAFETY: [&[u8]; 10] = [b"G17", b"G20", b"G21", b"G40", b"G49", b"G54", b"G80", b"G90", b"G94", b"G64"];
    if super::has_program_number(head) {
        return true;
    }
    for line in head.split(|b| matches!(b, b'\n' | b'\r')) {
        let line = line.trim_ascii().to_ascii_uppercase();
        let Some(first) = line.first() else { continue };
        // Comments stand in square brackets.
        if matches!(first, b'[' | b'(') {
            continue;
        }
        let words: Vec<&[u8]> = line.split(|b| matches!(b, b' ' | b'\t')).collect();
        let safe = words.iter().filter(|word| SAFETY.contains(*word)).count();
        let changes = words.iter().any(|word| matches!(*word, b"M6" | b"M06"));
        let length = words.contains(&b"G43".as_slice()) && words.iter().any(|word| word.first() == Some(&b'H'));
        if safe > 1 || changes || length {
            return true;
        }
    }
    false
}
