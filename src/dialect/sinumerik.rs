//! SINUMERIK NC language.

use crate::sema::sinumerik;

use super::Dialect;

pub(super) const DIALECT: Dialect = Dialect {
    id: "sinumerik",
    name: "SINUMERIK",
    extensions: &["mpf", "spf", "arc"],
    recognizes,
    turns: false,
    folders: sinumerik::FOLDERS,
    run: sinumerik::run,
    check_form: sinumerik::check_form,
    check_unexecuted: Some(sinumerik::check_unexecuted),
    comment: ["; ", "[", "]", ""],
    numbers_by_one: false,
    survey: sinumerik::survey,
    cycles: sinumerik::cycle_signatures,
};

/// A transfer header starts a line, `%_N_NAME_MPF`, or the head says that partc printed it for this control.
fn recognizes(head: &[u8]) -> bool {
    let printed = |line: &[u8]| line.starts_with(b"; partc ") && line.trim_ascii_end().ends_with(b", target sinumerik");
    head.split(|b| matches!(b, b'\n' | b'\r')).any(|line| {
        let line = line.strip_prefix(b"\xef\xbb\xbf").unwrap_or(line);
        line.starts_with(b"%_N_") || line.starts_with(b";$PATH=/_N_") || printed(line)
    })
}
