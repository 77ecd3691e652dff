//! `; partc: ignore[K8022] -- reason`: findings that the program itself does not want to see.
//!
//! In a comment of any dialect: `ignore` for its own block or, where the comment stands alone, for the next one that is
//! more than a comment; `ignore-file` for the whole file. What is refused, or moves otherwise than programmed, stays.

use crate::diag::{Code, Diagnostic, codes};
use crate::sema::Job;
use crate::sema::run::survey::{Surveyed, Visitor, Wanted};
use crate::text::decode::readable;
use crate::text::{Loc, Span};

/// Begins every suppression.
const MARK: &[u8] = b"partc:";

/// Is the mark in the text, in whatever case?
fn holds_mark(text: &[u8]) -> bool {
    marks(text).next().is_some()
}

/// Where the mark stands.
fn marks(text: &[u8]) -> impl Iterator<Item = usize> + '_ {
    let last = MARK.len() - 1;
    memchr::memchr_iter(MARK[last], text)
        .filter_map(move |colon| colon.checked_sub(last))
        .filter(|at| text[*at..at + MARK.len()].eq_ignore_ascii_case(MARK))
}

/// One code of one suppression.
#[derive(Debug, Clone, Copy)]
struct Entry {
    code: &'static Code,
    /// First and last line of the block that it is about.
    lines: (u32, u32),
    loc: Loc,
    used: bool,
}

/// The suppressions of a file.
#[derive(Debug, Default)]
pub struct Suppressions {
    /// In the order of the lines that they are about.
    blocks: Vec<Entry>,
    file: Vec<Entry>,
    /// Those of a comment alone, until the next block comes.
    waiting: Vec<Entry>,
    /// What is wrong with some of them.
    faults: Vec<Diagnostic>,
}

impl Suppressions {
    /// Is a finding of `code` on this line suppressed?
    pub fn cover(&mut self, code: &Code, line: u32) -> bool {
        let mut covered = false;
        for entry in self.file.iter_mut().filter(|entry| entry.code.id == code.id) {
            entry.used = true;
            covered = true;
        }
        let behind = self.blocks.partition_point(|entry| entry.lines.0 <= line);
        let Some(first) = behind.checked_sub(1).map(|last| self.blocks[last].lines.0) else { return covered };
        for entry in self.blocks[..behind].iter_mut().rev().take_while(|entry| entry.lines.0 == first) {
            if entry.code.id == code.id && line <= entry.lines.1 {
                entry.used = true;
                covered = true;
            }
        }
        covered
    }

    /// What is wrong with the suppressions.
    pub fn take_faults(&mut self) -> Vec<Diagnostic> {
        std::mem::take(&mut self.faults)
    }

    /// The codes that no finding had, and where they are suppressed; those that `counts` are taken.
    pub fn unused(&self, counts: impl Fn(&'static Code) -> bool) -> Vec<(&'static Code, Loc)> {
        let all = self.file.iter().chain(&self.blocks).chain(&self.waiting);
        all.filter(|entry| !entry.used && counts(entry.code)).map(|entry| (entry.code, entry.loc)).collect()
    }

    fn take(&mut self, said: &Said, alone: bool, lines: (u32, u32), loc: impl Fn(Span) -> Loc) {
        let fault = |code, span, message: String, help: &str| Diagnostic::new(code, loc(span), message).help(help);
        let (whole_file, list) = match said {
            Said::Unreadable(span) => {
                let help = "write `partc: ignore[K8022] -- reason` or `partc: ignore-file[K8022] -- reason`";
                return self.faults.push(fault(
                    codes::P8004,
                    *span,
                    "this suppression cannot be read".to_owned(),
                    help,
                ));
            }
            Said::Codes { whole_file, list } => (*whole_file, list),
        };
        for (name, span) in list {
            let Some(code) = codes::find(name) else {
                let (code, message) = if name.is_empty() {
                    (codes::P8002, "this suppression names no code".to_owned())
                } else {
                    (codes::P8002, format!("no finding has the code or name `{name}`"))
                };
                self.faults.push(fault(
                    code,
                    *span,
                    message,
                    "name the codes that are ignored; `partc rules` lists them",
                ));
                continue;
            };
            if code.is_firm() {
                let message = format!("{} ({}) cannot be ignored", code.id, code.name);
                let help = "mend what is found: an error, or a way that the tool goes otherwise than programmed, stays";
                self.faults.push(fault(codes::P8003, *span, message, help));
                continue;
            }
            let entry = Entry { code, lines, loc: loc(*span), used: false };
            match (whole_file, alone) {
                (true, _) => self.file.push(entry),
                (false, true) => self.waiting.push(entry),
                (false, false) => self.blocks.push(entry),
            }
        }
    }
}

/// What stands behind the mark.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Said {
    Codes { whole_file: bool, list: Vec<(String, Span)> },
    Unreadable(Span),
}

/// Reads the suppression that begins at `at`, up to `end`.
fn read(text: &[u8], at: usize, end: usize) -> Said {
    let whole = Span { start: at as u32, end: end as u32 };
    let rest = &text[at + MARK.len()..end];
    let blanks = rest.len() - rest.trim_ascii_start().len();
    let word = &rest[blanks..];
    let starts = |name: &[u8]| word.get(..name.len()).is_some_and(|head| head.eq_ignore_ascii_case(name));
    let name: &[u8] = if starts(b"ignore-file") { b"ignore-file" } else { b"ignore" };
    if !starts(name) {
        return Said::Unreadable(whole);
    }
    let behind = &word[name.len()..];
    let open = behind.len() - behind.trim_ascii_start().len();
    // In a comment that stands in brackets itself, round ones.
    let closing = match behind.get(open) {
        Some(b'[') => b']',
        Some(b'(') => b')',
        _ => 0,
    };
    if closing == 0 {
        // Nothing more, or a reason: a suppression without a code.
        let bare = behind.trim_ascii().is_empty() || behind.trim_ascii_start().starts_with(b"--");
        return if bare {
            Said::Codes { whole_file: name.len() > 6, list: vec![(String::new(), whole)] }
        } else {
            Said::Unreadable(whole)
        };
    }
    let Some(close) = memchr::memchr(closing, behind) else { return Said::Unreadable(whole) };
    // A reason stands behind two dashes, another comment behind its sign.
    let rest = behind[close + 1..].trim_ascii();
    if !(rest.is_empty() || rest.starts_with(b"--") || matches!(rest[0], b';' | b')' | b']')) {
        return Said::Unreadable(whole);
    }
    let mut from = at + MARK.len() + blanks + name.len() + open + 1;
    let mut list = Vec::new();
    for part in behind[open + 1..close].split(|b| *b == b',') {
        let lead = part.len() - part.trim_ascii_start().len();
        let name = part.trim_ascii();
        let span = if name.is_empty() { whole } else { Span::at((from + lead) as u32, name.len() as u32) };
        list.push((readable(name).into_owned(), span));
        from += part.len() + 1;
    }
    Said::Codes { whole_file: name.len() > 6, list }
}

/// Each suppression in a comment: a sign of a comment, blanks or nothing stand in front of its mark.
fn in_comment(text: &[u8], comment: Span) -> Vec<Said> {
    let (start, end) = (comment.start as usize, (comment.end as usize).min(text.len()));
    let Some(inner) = text.get(start..end) else { return Vec::new() };
    let begins = |at: usize| {
        let before = inner[..at].trim_ascii_end();
        before.is_empty() || matches!(before.last(), Some(b';' | b'(' | b'[' | b'*'))
    };
    let starts: Vec<usize> = marks(inner).filter(|at| begins(*at)).map(|at| at + start).collect();
    let ends = starts.iter().skip(1).copied().chain([end]);
    starts.iter().zip(ends).map(|(at, end)| read(text, *at, end)).collect()
}

impl Visitor for Suppressions {
    fn wanted(&self) -> Wanted<'_> {
        if self.waiting.is_empty() { Wanted { letter: Some(b':'), is: &holds_mark } } else { Wanted::ALL }
    }

    fn items(&self) -> bool {
        false
    }

    fn block(&mut self, block: &Surveyed<'_>, job: &Job<'_>) {
        let site = &block.site;
        let lines = (site.line, site.line.saturating_add(site.lines.saturating_sub(1)));
        if !block.is_empty {
            let waiting = self.waiting.drain(..).map(|entry| Entry { lines, ..entry });
            self.blocks.extend(waiting);
        }
        if !holds_mark(block.text) {
            return;
        }
        for comment in block.comments {
            for said in in_comment(block.text, *comment) {
                self.take(&said, block.is_empty, lines, |span| site.loc(job, span));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(comment: &str) -> Vec<Said> {
        in_comment(comment.as_bytes(), Span::at(0, comment.len() as u32))
    }

    fn names(said: &Said) -> Vec<&str> {
        match said {
            Said::Codes { list, .. } => list.iter().map(|(name, _)| name.as_str()).collect(),
            Said::Unreadable(_) => Vec::new(),
        }
    }

    #[test]
    fn codes_are_read_with_their_places() {
        assert_eq!(names(&said("partc: ignore (T8001, T8002)")[0]), ["T8001", "T8002"]);
        let text = " PARTC:  Ignore [ K8022 ,fk-cca-reading] -- two readings";
        let [Said::Codes { whole_file: false, list }] = &said(text)[..] else { panic!() };
        let words: Vec<&[u8]> = list.iter().map(|(_, span)| span.of(text.as_bytes())).collect();
        assert_eq!(words, [&b"K8022"[..], b"fk-cca-reading"]);
        assert!(matches!(&said("partc: ignore-file[K8]")[..], [Said::Codes { whole_file: true, .. }]));
    }

    #[test]
    fn what_is_no_suppression_is_told_from_what_is_a_wrong_one() {
        assert!(said("see partc: ignore[K8022]").is_empty());
        for wrong in [
            "partc: ignore[K8022] [K8023]",
            "partc: ignore[K8022], L1",
            "partc: ignore[K8022",
            "partc: ignroe[K8022]",
            "partc: ignores[K8022]",
            "partc:",
        ] {
            assert!(matches!(&said(wrong)[..], [Said::Unreadable(_)]), "{wrong}");
        }
        for bare in ["partc: ignore", "partc: ignore -- later", "partc: ignore[]"] {
            assert_eq!(names(&said(bare)[0]), [""], "{bare}");
        }
    }

    #[test]
    fn a_comment_may_hold_several() {
        let found = said(" deburr ; partc: ignore[K8022] -- a ; partc: ignore[K8023]");
        assert_eq!(found.iter().flat_map(names).collect::<Vec<_>>(), ["K8022", "K8023"]);
    }
}
