//! HEIDENHAIN turning: MANUALplus 4110 DIN programs, DIN PLUS and smart.Turn.

use crate::diag::codes;
use crate::ir::contour::Sink;
use crate::sema::{Job, turning};
use crate::text::{Loc, Span};

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

/// The same, of a file that nothing shows but the numbers of its blocks: many controls could have written it.
pub(super) const BY_NUMBERS: Dialect = Dialect { run: run_by_numbers, check_form: check_by_numbers, ..DIALECT };

fn run_by_numbers(job: &Job<'_>, out: &mut dyn Sink) -> u64 {
    say_by_numbers(job);
    turning::run(job, out)
}

fn check_by_numbers(job: &Job<'_>) {
    say_by_numbers(job);
    turning::check_form(job);
}

fn say_by_numbers(job: &Job<'_>) {
    let start = Loc { file: job.main, line: 1, span: Span::at(0, 1) };
    job.diags.push(codes::P0012::file_is_read_as_heidenhain_turning().at(start));
}

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
