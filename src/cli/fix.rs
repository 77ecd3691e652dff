//! `partc check --fix`: mends what rules know how to mend, where the program still does the same.

use std::collections::BTreeSet;
use std::path::Path;

use crate::diag::codes;
use crate::driver::Session;
use crate::lint::lead;
use crate::lint::renumber::Renumber;
use crate::lint::rules::L2005;
use crate::text::{FileId, Span};

use super::Trouble;
use super::edit::{Edit, Program, apply, write};
use super::options::Common;
use super::unified::unified;

/// Most times that a program is checked again: one change may make room for another.
const MOST_ROUNDS: usize = 10;

/// What is done with the changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Mode {
    Write,
    /// Shown only.
    Show,
}

/// What became of a program.
#[derive(Debug, Default)]
pub(super) struct Fixed {
    /// Changes that were made.
    pub made: usize,
    /// The program has errors: nobody knows what it does, and nothing was changed.
    pub refused: bool,
    pub diff: String,
}

/// Mends a program.
///
/// # Errors
/// It cannot be read or written.
pub(super) fn fix(path: &Path, common: &Common, mode: Mode, with_unsafe: bool) -> Result<Fixed, Trouble> {
    let program = Program::read(path, common)?;
    let before = program.does(&program.text);
    let mut fixed = Fixed::default();
    // Of a program with errors nobody knows what it does.
    if before.1 > 0 {
        return Ok(Fixed { refused: true, ..fixed });
    }
    let mut text = program.text.clone();
    for _ in 0..MOST_ROUNDS {
        let edits = edits(&program, &text, with_unsafe);
        let kept = kept(&program, &text, &edits, before);
        if kept.is_empty() {
            break;
        }
        fixed.made += kept.len();
        text = apply(&text, &kept);
    }
    if fixed.made == 0 {
        return Ok(fixed);
    }
    program.unchanged()?;
    match mode {
        Mode::Write => write(path, &text)?,
        Mode::Show => {
            let (old, new) = (String::from_utf8_lossy(&program.text), String::from_utf8_lossy(&text));
            let name = path.display().to_string();
            fixed.diff = unified(&old, &new, &name);
        }
    }
    Ok(fixed)
}

/// The largest sets of changes, found by halves, with which the program still does the same.
fn kept(program: &Program, text: &[u8], edits: &[Edit], before: (u128, u32)) -> Vec<Edit> {
    let mut kept: Vec<Edit> = Vec::new();
    let mut open = vec![edits];
    while let Some(some) = open.pop() {
        if some.is_empty() {
            continue;
        }
        let tried = [&kept, some].concat();
        if program.does(&apply(text, &tried)) == before {
            kept = tried;
        } else if some.len() > 1 {
            let (first, second) = some.split_at(some.len() / 2);
            open.extend([second, first]);
        }
    }
    kept
}

/// What the findings of a check propose.
fn edits(program: &Program, text: &[u8], with_unsafe: bool) -> Vec<Edit> {
    let session = program.session(text);
    let fixes = program.fixes(&session);
    let Session { sources, diags, .. } = session;
    let list = diags.into_sorted();
    // A finding that is ignored or suppressed is not mended.
    let own = || list.iter().filter(|found| found.label.loc.file == FileId(0));
    let found: BTreeSet<(&str, u32)> = own().map(|found| (found.code.id, found.label.loc.span.start)).collect();
    let wanted = fixes.into_iter().filter(|fix| found.contains(&(fix.code.id, fix.at)));
    let mut edits: Vec<Edit> = wanted.map(|fix| Edit { span: fix.span, text: fix.text }).collect();
    let useless = own().filter(|found| found.code.id == codes::P8001.id);
    edits.extend(useless.filter_map(|found| comment_around(text, found.label.loc.span)).map(removal));
    if with_unsafe && own().any(|found| found.code.id == L2005.id) {
        let step = if program.dialect.numbers_by_one { 1 } else { 10 };
        let mut renumber = Renumber::new(step);
        lead(&sources, FileId(0), program.dialect.survey, &mut renumber);
        edits.extend(renumber.changes().into_iter().map(|(span, text)| Edit { span, text }));
    }
    edits.retain(|edit| *edit.span.of(text) != *edit.text);
    edits
}

fn removal(span: Span) -> Edit {
    Edit { span, text: Vec::new() }
}

/// The comment that holds the one code at `span` and nothing else than its suppression; with its line where it stands alone.
fn comment_around(text: &[u8], span: Span) -> Option<Span> {
    let (from, to) = (span.start as usize, span.end as usize);
    // Lines end in LF, CR LF or, on old controls, CR.
    let line_start = memchr::memrchr2(b'\n', b'\r', &text[..from]).map_or(0, |at| at + 1);
    let line_end = memchr::memchr2(b'\n', b'\r', &text[to..]).map_or(text.len(), |at| to + at);
    let head = &text[line_start..from];
    let mark = head.iter().rposition(|b| *b == b';')?;
    let words = String::from_utf8_lossy(&head[mark + 1..]).to_ascii_lowercase();
    let words: String = words.chars().filter(|c| !c.is_whitespace()).collect();
    let alone = matches!(words.as_str(), "partc:ignore[" | "partc:ignore-file[") && text.get(to) == Some(&b']');
    // Further comments behind it stay as they are.
    if !alone || text[to..line_end].contains(&b';') {
        return None;
    }
    let before = head[..mark].trim_ascii_end().len();
    let (start, end) = if head[..before].is_empty() {
        let sign = usize::from(text[line_end..].starts_with(b"\r\n"));
        (line_start, (line_end + 1 + sign).min(text.len()))
    } else {
        let written = text[to..line_end].trim_ascii_end().len();
        (line_start + before, to + written)
    };
    Some(Span { start: start as u32, end: end as u32 })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_comment_goes_with_its_line_or_with_the_blanks_in_front() {
        let around = |text: &str| {
            let from = text.find("K2102").unwrap() as u32;
            comment_around(text.as_bytes(), Span::at(from, 5)).map(|span| {
                let edit = removal(span);
                String::from_utf8(apply(text.as_bytes(), &[edit])).unwrap()
            })
        };
        assert_eq!(around("A\n; partc: ignore[K2102] -- b\nC\n").as_deref(), Some("A\nC\n"));
        assert_eq!(around("A\nB  ; partc: ignore[K2102]\r\nC\n").as_deref(), Some("A\nB\r\nC\n"));
        assert_eq!(around("A\r\n; partc: ignore[K2102]\r\nC\r\n").as_deref(), Some("A\r\nC\r\n"));
        assert_eq!(around("A\r; partc: ignore[K2102]\rC\r").as_deref(), Some("A\rC\r"));
        assert_eq!(around("B ; partc: ignore[K2102, K8]\n"), None);
        assert_eq!(around("B ; deburr partc: ignore[K2102]\n"), None);
        assert_eq!(around("B ; partc: ignore[K2102] ; deburr\n"), None);
    }
}
