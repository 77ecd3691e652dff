//! `partc check --add-ignores`: comments that suppress what is found now.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use crate::diag::Severity;
use crate::lint::ends::Ends;
use crate::text::{FileId, Span};

use super::Trouble;
use super::edit::{Edit, Program, apply, ignorable, write};
use super::options::Common;

/// Most times that a program is checked again: one change may make room for another.
const MOST_ROUNDS: usize = 10;

/// Writes the comments for what is at least so bad, and says how many.
///
/// # Errors
/// The program cannot be read or written.
pub(super) fn add(path: &Path, common: &Common, least: Severity) -> Result<usize, Trouble> {
    let program = Program::read(path, common)?;
    let before = program.does(&program.text);
    let mut text = program.text.clone();
    let mut added = 0;
    let mut last: Vec<(u32, Vec<u8>)> = Vec::new();
    for _ in 0..MOST_ROUNDS {
        let edits = comments(&program, &text, least);
        if edits.is_empty() {
            break;
        }
        // What is said again was not heard.
        let said: Vec<(u32, Vec<u8>)> = edits.iter().map(|(line, edit)| (*line, edit.text.clone())).collect();
        let edits: Vec<Edit> = edits.into_iter().map(|(_, edit)| edit).collect();
        if said == last {
            return Err(format!("{}: its blocks take no comments at their ends; nothing was written", path.display()));
        }
        last = said;
        let made = apply(&text, &edits);
        // Nothing but comments was added: it must do what it did.
        if program.does(&made) != before {
            return Err(format!("{}: its blocks take no comments at their ends; nothing was written", path.display()));
        }
        added += edits.len();
        text = made;
    }
    if added > 0 {
        program.unchanged()?;
        write(path, &text)?;
    }
    Ok(added)
}

/// A comment for each block in which something is found that none of its comments names, and a line of the block.
fn comments(program: &Program, text: &[u8], least: Severity) -> Vec<(u32, Edit)> {
    let session = program.check(text);
    let sources = std::rc::Rc::clone(&session.sources);
    let mut codes: BTreeMap<u32, BTreeSet<&str>> = BTreeMap::new();
    for found in ignorable(session.diags.into_sorted(), least) {
        codes.entry(found.label.loc.line).or_default().insert(found.code.id);
    }
    if codes.is_empty() {
        return Vec::new();
    }
    let ends = Ends::of(&sources, FileId(0), program.dialect.survey);
    let mut by_end: BTreeMap<u32, (u32, BTreeSet<&str>)> = BTreeMap::new();
    for (line, found) in codes {
        if let Some(end) = ends.at(line) {
            by_end.entry(end).or_insert_with(|| (line, BTreeSet::new())).1.extend(found);
        }
    }
    let edit = |(end, (line, codes)): (u32, (u32, BTreeSet<&str>))| {
        let list = codes.into_iter().collect::<Vec<_>>().join(", ");
        let [open, inner_open, inner_close, close] = program.dialect.comment;
        let text = format!(" {open}partc: ignore{inner_open}{list}{inner_close}{close}").into_bytes();
        (line, Edit { span: Span::at(end, 0), text })
    };
    by_end.into_iter().map(edit).collect()
}
