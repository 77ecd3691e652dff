//! HEIDENHAIN Klartext for milling.

use crate::sema::klartext;

use super::Dialect;

pub(super) const DIALECT: Dialect = Dialect {
    id: "klartext",
    name: "HEIDENHAIN Klartext",
    extensions: &["h", "klartext"],
    recognizes,
    turns: false,
    folders: &[],
    run: klartext::run,
    check_form: klartext::check_form,
    check_unexecuted: Some(klartext::check_unexecuted),
    comment: ["; ", "[", "]", ""],
    numbers_by_one: true,
    survey: klartext::survey,
    cycles: klartext::cycle_signatures,
};

/// `BEGIN PGM` starts a line.
fn recognizes(head: &[u8]) -> bool {
    head.split(|b| matches!(b, b'\n' | b'\r')).any(|line| {
        let line = line.trim_ascii_start();
        let line = line.strip_prefix(b"\xef\xbb\xbf").unwrap_or(line);
        let line = line.strip_prefix(b"N").unwrap_or(line);
        let words = &line[line.iter().take_while(|b| b.is_ascii_digit()).count()..];
        let mut words = words.split(|b| b.is_ascii_whitespace()).filter(|word| !word.is_empty());
        let mut is = |text: &[u8]| words.next().is_some_and(|word| word.eq_ignore_ascii_case(text));
        is(b"BEGIN") && is(b"PGM")
    })
}
