//! Every finding stands in its block: the line that is told is that of the text which is shown.
//!
//! A finding about a block that waits – a compensation, a corner, a contour – keeps the place of that block; a place that is
//! read against the text of another block shows a line that has nothing to do with it.

use partc::internals::diag::Diagnostic;

use super::book::{Case, cases};
use super::common::compile_bytes;
use super::damage::{Dice, damage};

/// Findings of the main program whose text begins in another line than the one that is told.
fn misplaced(program: &[u8], findings: &[Diagnostic]) -> Vec<String> {
    let line_of = |at: usize| program[..at].iter().filter(|byte| **byte == b'\n').count() as u32 + 1;
    let wrong = |found: &&Diagnostic| {
        let loc = found.label.loc;
        let begin = loc.span.start as usize;
        let is_inside = begin < program.len().max(1) && loc.line > 0;
        loc.file.0 == 0 && !(is_inside && line_of(begin) == loc.line)
    };
    findings
        .iter()
        .filter(wrong)
        .map(|found| format!("{} {:?} {}", found.code.id, found.label.loc, found.message))
        .collect()
}

fn look_at(case: &Case, program: &[u8], tries: &str) {
    let mut settings = case.settings();
    settings.limits.steps = 20_000;
    let compiled = compile_bytes(&case.file, program.to_vec(), &case.dialect, &settings, case);
    let wrong = misplaced(program, &compiled.findings);
    assert!(wrong.is_empty(), "{} {tries}: {wrong:#?}\n{}", case.name, String::from_utf8_lossy(program));
}

#[test]
fn of_golden_programs_and_damaged_ones() {
    let mut dice = Dice(0x91ac_e5ed);
    for case in cases("") {
        // Blocks of several lines have one place.
        if case.program.contains(&b'~') || case.program.contains(&b'\r') {
            continue;
        }
        look_at(case, &case.program, "as it is");
        // Cut off in transfer: in front of its last line end, and anywhere.
        let end = case.program.trim_ascii_end().len();
        look_at(case, &case.program[..end], "without its last line end");
        look_at(case, &case.program[..dice.roll(end + 1)], "cut off");
        for kind in [5, 6, 7] {
            let mut damaged = case.program.clone();
            damage(&mut damaged, kind, &mut dice);
            look_at(case, &damaged, "damaged");
        }
    }
}
