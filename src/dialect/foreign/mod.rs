//! Files that are in none of the languages: what they are, what shows it, and the way on.
//!
//! In: the name and the first bytes of a file. Out: its [`Kind`], with the words that show it, or nothing. A kind is a row of
//! [`kinds`]; for the rest of the compiler it is a dialect whose run reports one finding. A false alarm is worse than none:
//! a row needs a mark that no language of ours has, or two marks that none has together, and no word of the language that the
//! extension says.

mod files;
mod kinds;
mod line;
mod marks;
mod own;
mod source_marks;
mod way_on;

use crate::diag::{Diagnostic, codes};
use crate::ir::contour::Sink;
use crate::sema::Job;
use crate::sema::run::survey::Visitor;
use crate::text::decode::readable;
use crate::text::{FileId, Loc, Span};

use super::Dialect;
use kinds::ALL;
use line::Line;
use marks::Mark;
use own::Own;
use way_on::WayOn;

/// Name in place of that of a language.
pub const ID: &str = "foreign";
/// Bytes of a file that are looked at.
const HEAD: u32 = 64 * 1024;
/// Marks that are named.
const NAMED: usize = 3;
/// Characters of a mark that are shown.
const SHOWN: usize = 40;

/// A kind of file that is no part program of ours.
struct Kind {
    /// As it is counted: "Fanuc or Haas", "C or C++".
    dialect: &'static Dialect,
    /// As it is called: "a program for Fanuc, Haas and similar controls".
    is: &'static str,
    /// What to do with it.
    way_on: WayOn,
    marks: &'static [Mark],
    /// Its marks count also where a line looks like one of the language that the extension says.
    sure: bool,
    /// Its marks count also in sections of the ISO dialect of a SINUMERIK.
    iso_sections: bool,
    /// Extensions of ours under which such a file is looked for.
    under: fn(Own) -> bool,
}

/// What shows the kind of a file, in order of the lines.
struct Found {
    kind: &'static Kind,
    evidence: Vec<(u32, Span)>,
}

/// The kind of this file as a dialect that refuses it.
pub fn guess(file_name: &str, head: &[u8]) -> Option<&'static Dialect> {
    look(file_name, head).map(|found| found.kind.dialect)
}

/// What is no text of a program at all shows in its first bytes, before any line of it is believed.
pub fn is_container(head: &[u8]) -> bool {
    files::container(head).is_some()
}

fn look(file_name: &str, head: &[u8]) -> Option<Found> {
    let head = &head[..head.len().min(HEAD as usize)];
    if let Some(kind) = files::container(head) {
        let first = head.split(|b| matches!(b, b'\n' | b'\r')).next().unwrap_or_default();
        return Some(Found { kind, evidence: vec![(1, Span::at(0, first.len().min(SHOWN) as u32))] });
    }
    let own = Own::of(file_name);
    let mut seen = Vec::new();
    let mut lines: Vec<Line<'_>> = line::lines(head).filter(|line| !line.repeats(&mut seen)).collect();
    mark_sections(&mut lines);
    let is_own = lines.iter().any(|line| own.shows(line));
    ALL.iter()
        .copied()
        .filter(|kind| (kind.under)(own))
        .find_map(|kind| kind.fits(&lines, is_own))
        .or_else(|| files::as_a_whole(own, &lines, is_own))
        .or_else(|| undecided(own, head, &lines))
}

/// What many languages could be, by the extension and by its words.
fn undecided(own: Own, head: &[u8], lines: &[Line<'_>]) -> Option<Found> {
    let kind = &kinds::UNDECIDED;
    let is_ours = || own::shows_turning(lines) || own::is_numbered_as_turning(head);
    if (kind.under)(own) && !is_ours() { kind.fits(lines, false) } else { None }
}

/// Is a file of this name, which is read as HEIDENHAIN turning, taken for it because of the numbers of its blocks alone?
pub fn is_turning_by_numbers(file_name: &str, head: &[u8]) -> bool {
    let head = &head[..head.len().min(HEAD as usize)];
    let lines: Vec<Line<'_>> = line::lines(head).collect();
    (kinds::UNDECIDED.under)(Own::of(file_name)) && !own::shows_turning(&lines)
}

/// From G291 to G290 a program of a SINUMERIK is one of the ISO dialect.
fn mark_sections(lines: &mut [Line<'_>]) {
    let mut is_iso = false;
    for line in lines {
        let switched = |to| line.words.iter().any(|word| word.is("G", to));
        is_iso = (is_iso || switched("291")) && !switched("290");
        line.is_iso = is_iso;
    }
}

impl Kind {
    /// One mark that decides, or two.
    fn fits(&'static self, lines: &[Line<'_>], is_own: bool) -> Option<Found> {
        let (mut weight, mut evidence) = (0, Vec::new());
        for mark in self.marks {
            let place = lines
                .iter()
                .enumerate()
                .filter(|(_, line)| !line.is_skipped() && (self.iso_sections || !line.is_iso))
                .find_map(|(at, line)| Some((line, (mark.shows)(line, at)?)));
            let Some((line, span)) = place else { continue };
            if !is_own || self.sure || mark.is_proof() {
                weight += mark.weight;
            }
            evidence.push((line.number, span.shifted(line.start)));
        }
        evidence.sort_unstable_by_key(|(_, span): &(u32, Span)| (span.start, u32::MAX - span.end));
        // What lies in words that are named already says no more.
        let mut named = 0;
        evidence.retain(|(_, span)| {
            span.start >= named && {
                named = span.end;
                true
            }
        });
        (weight >= marks::DECIDES).then_some(Found { kind: self, evidence })
    }
}

/// A dialect that stands for a kind.
const fn stands_for(name: &'static str) -> Dialect {
    Dialect {
        id: ID,
        name,
        extensions: &[],
        folders: &[],
        recognizes: |_| false,
        turns: false,
        run,
        check_form: report,
        check_unexecuted: None,
        comment: ["; ", "[", "]", ""],
        numbers_by_one: false,
        survey,
        cycles: Vec::new,
    }
}

fn survey(_: &Job<'_>, _: FileId, _: &mut dyn Visitor) {}

fn run(job: &Job<'_>, _: &mut dyn Sink) -> u64 {
    report(job);
    0
}

/// The one finding.
fn report(job: &Job<'_>) {
    let head = job.sources.bytes(job.main, Span { start: 0, end: HEAD });
    let found = look(&job.sources.name(job.main), &head);
    let here = |(line, span): (u32, Span)| Loc { file: job.main, line, span };
    let Some(Found { kind, evidence }) = found else {
        let start = here((1, Span::at(0, 1)));
        job.diags.push(Diagnostic::new(codes::P0009, start, "the file is in none of the languages that partc reads"));
        return;
    };
    let text = |span: Span| {
        let shown: String = readable(span.of(&head)).chars().take(SHOWN).collect();
        format!("`{}`", shown.trim())
    };
    let shown: Vec<String> =
        evidence.iter().take(NAMED).map(|(line, span)| format!("{} in line {line}", text(*span))).collect();
    let start = evidence.first().copied().unwrap_or((1, Span::at(0, 1)));
    let shown = if shown.iter().any(|shown| shown.len() > 2 + " in line 1".len()) {
        format!(": {}", shown.join(", "))
    } else {
        String::new()
    };
    let message = format!("this is {}{shown}", kind.is);
    let turns = line::lines(&head).any(|line| marks::of_lathe(&line));
    let way_on = kind.way_on.text(&job.sources.name(job.main), &head, turns, job.settings);
    job.diags.push(Diagnostic::new(codes::P0009, here(start), message).help(way_on));
}

#[cfg(test)]
mod tests;
