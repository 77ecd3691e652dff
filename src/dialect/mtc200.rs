//! Bosch Rexroth (Indramat) MTC200.

use crate::sema::mtc200;

use super::Dialect;

pub(super) const DIALECT: Dialect = Dialect {
    id: "mtc200",
    name: "Bosch Rexroth MTC200",
    extensions: &["npg"],
    recognizes,
    turns: false,
    folders: &[],
    run: mtc200::run,
    check_form: mtc200::check_form,
    check_unexecuted: None,
    comment: ["; ", "[", "]", ""],
    numbers_by_one: false,
    survey: mtc200::survey,
    cycles: Vec::new,
};

/// The first line that is not blank begins with `%NPG`.
fn recognizes(head: &[u8]) -> bool {
    let head = head.strip_prefix(b"\xef\xbb\xbf").unwrap_or(head);
    let mut lines = head.split(|b| matches!(b, b'\n' | b'\r')).filter(|line| !line.trim_ascii().is_empty());
    lines.next().and_then(|line| line.get(..4)).is_some_and(|start| start.eq_ignore_ascii_case(b"%NPG"))
}
