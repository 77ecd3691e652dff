//! HEIDENHAIN turning: MANUALplus 4110 DIN programs, DIN PLUS and smart.Turn.

use crate::sema::turning;

use super::Dialect;

pub(super) const DIALECT: Dialect = Dialect {
    id: "heidenhain-turning",
    name: "HEIDENHAIN turning",
    extensions: &["nc", "ncs"],
    recognizes,
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
