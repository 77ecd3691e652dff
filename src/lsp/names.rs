//! Labels, variables and programs: where they are set, where they are used, other names for them.

use std::collections::HashMap;

use lsp_types::{DocumentHighlight, Location, Position, Range, TextEdit, WorkspaceEdit};

use crate::text::Span;

use super::document::{Document, World};
use super::study::{Study, Uses};
use super::words::meaning;

/// A name under the cursor.
pub struct Name<'s> {
    pub name: &'s str,
    pub uses: &'s Uses,
    /// Labels stand in a block that names them; variables are their own words.
    pub is_label: bool,
}

/// The label or variable at a place.
pub fn at<'s>(document: &Document, study: &'s Study, position: Position) -> Option<Name<'s>> {
    let offset = document.text.offset(position) as u32;
    let within = |span: &Span| span.start <= offset && offset <= span.end;
    let find = |names: &'s std::collections::BTreeMap<String, Uses>, is_label: bool| {
        let found = names.iter().find(|(name, uses)| {
            let all = uses.set.iter().chain(&uses.used);
            all.map(|span| spot_or_words(document, study, *span, name)).any(|span| within(&span))
        });
        found.map(|(name, uses)| Name { name, uses, is_label })
    };
    find(&study.survey.variables, false).or_else(|| find(&study.survey.labels, true))
}

/// The name itself in the words that use it.
fn spot(document: &Document, span: Span, name: &str) -> Option<Span> {
    let text = span.of(document.text.bytes());
    let (front, bare) = parts(name);
    // What stands in front of the name is its kind: `LBL 5` may end with `REP 5`.
    let from = front.map_or(Some(0), |front| find(text, front, 0).map(|at| at + front.len()));
    let found = from.and_then(|from| find(text, bare, from))?;
    Some(Span::at(span.start + found as u32, bare.len() as u32))
}

/// The same, in the whole block where it stands in front of the words; they themselves where it is not to be found.
pub fn spot_or_words(document: &Document, study: &Study, span: Span, name: &str) -> Span {
    exact(document, study, span, name).unwrap_or(span)
}

fn exact(document: &Document, study: &Study, span: Span, name: &str) -> Option<Span> {
    spot(document, span, name).or_else(|| spot(document, study.survey.block_at(span.start)?.span, name))
}

/// `LBL "PART"` is `LBL` and `PART`.
fn parts(name: &str) -> (Option<&str>, &str) {
    match name.split_once(' ') {
        Some((front, bare)) => (Some(front), bare.trim_matches('"')),
        None => (None, name.trim_matches('"')),
    }
}

/// The first place of a whole word from `from` on.
fn find(text: &[u8], word: &str, from: usize) -> Option<usize> {
    let free = |b: Option<&u8>| !b.is_some_and(|b| b.is_ascii_alphanumeric() || *b == b'_');
    let last = text.len().checked_sub(word.len())?;
    (from..=last).find(|at| {
        let end = at + word.len();
        text[*at..end].eq_ignore_ascii_case(word.as_bytes())
            && free(at.checked_sub(1).and_then(|front| text.get(front)))
            && free(text.get(end))
    })
}

impl Name<'_> {
    /// The places where it is set, and those where it is used.
    pub fn spots(&self, document: &Document, study: &Study) -> (Vec<Span>, Vec<Span>) {
        let spots =
            |spans: &[Span]| spans.iter().map(|span| spot_or_words(document, study, *span, self.name)).collect();
        (spots(&self.uses.set), spots(&self.uses.used))
    }
}

/// Where the name is set; a called program is its file.
pub fn definition<W: World>(document: &Document, position: Position, world: &W) -> Vec<Location> {
    let Some(study) = &document.study else { return Vec::new() };
    if let Some(name) = at(document, study, position) {
        let (mut set, _) = name.spots(document, study);
        // A jump to the number of a block.
        let number = name.name.strip_prefix('N').and_then(|digits| digits.parse::<u32>().ok());
        if set.is_empty()
            && name.is_label
            && let Some(number) = number
        {
            let numbered = study.survey.blocks.iter().filter(|block| block.number == Some(number));
            set.extend(numbered.map(|block| Span { start: block.span.start, end: block.words.start }));
        }
        if !set.is_empty() {
            return set.into_iter().map(|span| location(document, span)).collect();
        }
    }
    // A name that nothing sets may be that of a program.
    called(document, study, position, world).into_iter().collect()
}

/// The program that the block calls, if the run opened a file of a name in it.
fn called<W: World>(document: &Document, study: &Study, position: Position, world: &W) -> Option<Location> {
    let block = study.survey.block_at(document.text.offset(position) as u32)?;
    let text = String::from_utf8_lossy(block.words.of(document.text.bytes())).to_ascii_uppercase();
    let stem = |name: &str| -> String {
        let file = name.rsplit(['/', '\\', ':']).next().unwrap_or(name);
        file.rsplit_once('.').map_or(file, |(stem, _)| stem).to_ascii_uppercase()
    };
    let parts: Vec<&str> = text.split(|c: char| !(c.is_alphanumeric() || c == '_' || c == '-')).collect();
    let (_, identity) = study.files.iter().skip(1).find(|(name, _)| parts.contains(&stem(name).as_str()))?;
    Some(Location { uri: world.uri(identity)?.parse().ok()?, range: Range::default() })
}

pub fn references(document: &Document, position: Position, with_definition: bool) -> Vec<Location> {
    let Some(study) = &document.study else { return Vec::new() };
    let Some(name) = at(document, study, position) else { return Vec::new() };
    let (set, used) = name.spots(document, study);
    let set = if with_definition { set } else { Vec::new() };
    let mut all: Vec<Span> = set.into_iter().chain(used).collect();
    all.sort_unstable_by_key(|span| span.start);
    all.dedup();
    all.into_iter().map(|span| location(document, span)).collect()
}

pub fn highlights(document: &Document, position: Position) -> Vec<DocumentHighlight> {
    let shown = |found: Location| DocumentHighlight { range: found.range, kind: None };
    references(document, position, true).into_iter().map(shown).collect()
}

/// The range of a name that can be another one.
pub fn can_rename(document: &Document, position: Position) -> Option<Range> {
    let study = document.study.as_ref()?;
    let name = at(document, study, position).filter(|name| !name.uses.set.is_empty())?;
    let offset = document.text.offset(position) as u32;
    let (set, used) = name.spots(document, study);
    let here = set.into_iter().chain(used).find(|span| span.start <= offset && offset <= span.end)?;
    Some(document.text.range(here))
}

/// Every place of the name with another one.
///
/// # Errors
/// There is no name, or the new one is none of its kind or taken, or the name stands where it is no name: in a text, or as
/// a part of the name of a program. `shared`: other programs that call this one, or are called, may use its variables.
pub fn rename(document: &Document, position: Position, new: &str, shared: bool) -> Result<WorkspaceEdit, String> {
    let study = document.study.as_ref().ok_or("the program cannot be read")?;
    let name = at(document, study, position).ok_or("there is no label or variable here")?;
    let new = new.trim().trim_matches('"');
    let digits = |text: &str| text.bytes().all(|b| b.is_ascii_digit());
    let word =
        |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_alphanumeric() || b"_-.#@$".contains(&b));
    let (_, bare) = parts(name.name);
    // `Q5` may become `Q6` or `QL6`, a label of digits another number, a name another name.
    let fits = if name.is_label { digits(new) == digits(bare) } else { alike(bare, new) };
    let taken = document.dialect.is_some_and(|dialect| meaning(dialect.id, new).is_some());
    if !word(new) || !fits || taken {
        return Err(format!("`{new}` cannot stand in place of `{bare}`: a name of the same kind is needed"));
    }
    if shared && !name.is_label {
        return Err(format!("`{bare}` may be used by the programs that are called, or that call this one"));
    }
    let mut names = study.survey.labels.keys().chain(study.survey.variables.keys());
    if names.any(|known| parts(known).1.eq_ignore_ascii_case(new)) {
        return Err(format!("`{new}` is in use already"));
    }
    if name.uses.set.is_empty() {
        return Err(format!("`{bare}` is set nowhere in this program"));
    }
    let all = name.uses.set.iter().chain(&name.uses.used).map(|span| exact(document, study, *span, name.name));
    let mut all: Vec<Span> = all.collect::<Option<_>>().ok_or("not every place of the name can be found")?;
    all.sort_unstable_by_key(|span| span.start);
    all.dedup();
    if let Some(hidden) = all.iter().find(|span| !name.is_label && is_text(document, study, **span)) {
        let line = document.text.position(hidden.start).line + 1;
        return Err(format!("`{bare}` stands in a text or in a name in line {line}, too"));
    }
    let edits = all.into_iter().map(|span| TextEdit { range: document.text.range(span), new_text: new.to_owned() });
    #[expect(clippy::mutable_key_type, reason = "the protocol's own type")]
    let changes = HashMap::from([(document.uri.clone(), edits.collect())]);
    Ok(WorkspaceEdit { changes: Some(changes), ..WorkspaceEdit::default() })
}

/// Does the place lie in quotation marks, or in a block that names a file?
fn is_text(document: &Document, study: &Study, span: Span) -> bool {
    let Some(block) = study.survey.block_at(span.start) else { return true };
    let front = Span { start: block.span.start, end: span.start }.of(document.text.bytes());
    let quoted = front.iter().filter(|b| **b == b'"').count() % 2 == 1;
    let words = block.words.of(document.text.bytes());
    let names_a_file = ["PGM", "F-PRINT", "TABLE", "PATTERN"]
        .iter()
        .any(|word| words.windows(word.len()).any(|part| part.eq_ignore_ascii_case(word.as_bytes())));
    quoted || names_a_file
}

/// Are both variables of a kind: letters and a number, or names?
fn alike(old: &str, new: &str) -> bool {
    let kind = |text: &str| {
        let text = text.to_ascii_uppercase();
        let front = text.trim_end_matches(|c: char| c.is_ascii_digit());
        let known =
            ["Q", "QL", "QR", "QS", "R", "#", "@"].into_iter().find(|kind| *kind == front && front.len() < text.len());
        // Q100 to Q199 belong to the control.
        let number: u32 = text[front.len()..].parse().unwrap_or(0);
        (known, front == "Q" && (100..200).contains(&number))
    };
    let ((old, _), (new, reserved)) = (kind(old), kind(new));
    let text = |kind: Option<&str>| kind == Some("QS");
    old.is_some() == new.is_some()
        && old.and_then(|kind| kind.chars().next()) == new.and_then(|kind| kind.chars().next())
        && text(old) == text(new)
        && !reserved
}

fn location(document: &Document, span: Span) -> Location {
    Location { uri: document.uri.clone(), range: document.text.range(span) }
}
