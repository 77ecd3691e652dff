//! What stands under the cursor: a word, a parameter of a cycle, a name, and where the block leads.

use core::fmt::Write;

use lsp_types::{Hover, HoverContents, MarkupContent, MarkupKind, Position};

use crate::block_ends::Stop;
use crate::diag::trail::{Assigned, MOST_ASSIGNED};
use crate::ir::{Feed, Side};
use crate::machine::Axis;
use crate::sema::cycle::row::{Name as ParameterName, Parameter, Signature};
use crate::text::{FileId, Span};

use super::document::Document;
use super::hints::{coordinates, number, turned};
use super::names;
use super::study::Study;
use super::words::meaning;

/// The text for a place.
pub fn hover(document: &Document, position: Position) -> Option<Hover> {
    let study = document.study.as_ref()?;
    let offset = document.text.offset(position);
    let block = study.survey.block_at(offset as u32)?;
    let text = document.text.as_str();
    let word = word_at(text, offset);
    let mut parts = Vec::new();
    let shown = text.get(word.0..word.1).unwrap_or_default();
    let call = Call::of(document, block.words);
    let parameter = call.as_ref().and_then(|call| call.parameter_at(text, offset, block.words));
    if let Some(parameter) = parameter {
        parts.push(described(call.as_ref().map(|call| call.cycle), parameter));
    } else if let Some(call) = call.as_ref().filter(|call| call.names(text, offset, block.words)) {
        parts.push(format!("**{}**: {}", call.cycle.name, call.cycle.what));
    } else if let Some(meaning) = document.dialect.and_then(|dialect| meaning(dialect.id, shown)) {
        parts.push(format!("**{}**: {meaning}", shown.to_ascii_uppercase()));
    }
    let known = |name: &names::Name<'_>| {
        !name.uses.set.is_empty() || name.is_label || name.name.ends_with(|c: char| c.is_ascii_digit())
    };
    if let Some(name) = names::at(document, study, position).filter(known) {
        parts.push(used(document, &name));
        if !name.is_label {
            parts.extend(value(study, name.name, block.words));
        }
    }
    if let Some(stop) = study.seen.stop(FileId(0), block.words.start) {
        parts.push(leads_to(stop, study.seen.diameter));
    }
    if parts.is_empty() {
        return None;
    }
    let contents = HoverContents::Markup(MarkupContent { kind: MarkupKind::Markdown, value: parts.join("\n\n") });
    let span = Span { start: word.0 as u32, end: word.1 as u32 };
    Some(Hover { contents, range: Some(document.text.range(span)) })
}

/// The letters, or the letter and its number, around a byte: a word of a block or a name.
pub fn word_at(text: &str, offset: usize) -> (usize, usize) {
    let bytes = text.as_bytes();
    let part = |b: &u8| b.is_ascii_alphanumeric() || *b == b'_' || *b == b'$';
    let front = bytes[..offset.min(bytes.len())].iter().rev().take_while(|b| part(b)).count();
    let behind = bytes[offset.min(bytes.len())..].iter().take_while(|b| part(b)).count();
    let (start, mut end) = (offset - front, offset + behind);
    // The sense of a turn is part of its word.
    if bytes[start..end].eq_ignore_ascii_case(b"DR") && matches!(bytes.get(end), Some(b'+' | b'-')) {
        end += 1;
    }
    // Of `X-5` and `X10` the letter is the word.
    (start, end)
}

fn leads_to(stop: &Stop, diameter: Option<Axis>) -> String {
    let mut text = format!("**{}** ({}", coordinates(&stop.end, diameter), stop.path.name());
    if let Some(axis) = turned(stop, diameter) {
        _ = write!(text, ", {} is a diameter", axis.letter());
    }
    if stop.machine {
        text.push_str(", coordinates of the machine");
    }
    match stop.feed {
        Some(Feed::PerMinute(feed)) => _ = write!(text, ", {} mm/min", number(feed)),
        Some(Feed::PerRevolution(feed)) => _ = write!(text, ", {} mm/rev", number(feed)),
        Some(Feed::InverseTime(feed)) => _ = write!(text, ", {} /min", number(feed)),
        None => {}
    }
    match stop.side {
        Side::Left => text.push_str(", tool left of the contour"),
        Side::Right => text.push_str(", tool right of the contour"),
        Side::None => {}
    }
    if let Some(tool) = stop.tool {
        _ = write!(text, ", tool {tool}");
    }
    match stop.passes {
        1 => {}
        passes => _ = write!(text, ", first of {passes} passes"),
    }
    text.push(')');
    text
}

/// What a variable holds in a block: what the block assigns, or what it got last before the first run of the block.
fn value(study: &Study, name: &str, words: Span) -> Option<String> {
    let all = || study.values.iter().filter(|assigned| assigned.name.eq_ignore_ascii_case(name));
    let here = |assigned: &&Assigned| assigned.loc.file == FileId(0) && assigned.loc.span.start == words.start;
    if let (Some(first), Some(last)) = (all().find(here), all().rfind(here)) {
        let times = all().filter(here).count();
        // Behind what is remembered there may be more.
        let whole = !study.cut_off && study.values.len() < MOST_ASSIGNED;
        let more = match (times, whole) {
            (1, true) => String::new(),
            (_, true) => format!(" first, {} last of {times} times", exact(last.value)),
            (_, false) => " first".to_owned(),
        };
        return Some(format!("= {}{more}", exact(first.value)));
    }
    let stop = study.seen.stop(FileId(0), words.start)?;
    // What was assigned in front of the block is known where the list goes on behind it.
    let goes_on = study.values.last().is_some_and(|last| last.step > stop.step);
    if study.values.len() == MOST_ASSIGNED && !goes_on {
        return None;
    }
    let last = all().take_while(|assigned| assigned.step <= stop.step).last()?;
    Some(format!("= {}", exact(last.value)))
}

/// Six places, without zeros at the end.
fn exact(value: f64) -> String {
    let text = format!("{value:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

fn used(document: &Document, name: &names::Name<'_>) -> String {
    let lines = |spans: &[Span]| {
        let mut lines: Vec<String> =
            spans.iter().map(|span| (document.text.position(span.start).line + 1).to_string()).collect();
        lines.dedup();
        if lines.len() > 8 {
            let more = lines.len() - 8;
            lines.truncate(8);
            lines.push(format!("{more} more"));
        }
        lines.join(", ")
    };
    let (set, used) = (lines(&name.uses.set), lines(&name.uses.used));
    let mut text = format!("`{}`", name.name);
    match (name.is_label, set.is_empty()) {
        (true, true) if name.name.starts_with('N') => text.push_str(" is a block number"),
        (_, true) => text.push_str(" is set nowhere in this program"),
        (true, false) => _ = write!(text, ", label in line {set}"),
        (false, false) => _ = write!(text, ", set in line {set}"),
    }
    if !used.is_empty() {
        _ = write!(text, "; used in line {used}");
    }
    text
}

fn described(cycle: Option<&Signature>, parameter: &Parameter) -> String {
    let mut text = format!("**{}**: {} ({}", parameter.name, parameter.what, parameter.kind.text());
    let rule = parameter.rule_text();
    if !rule.is_empty() {
        _ = write!(text, "; {rule}");
    }
    if !parameter.default.is_empty() {
        _ = write!(text, "; left out: {}", parameter.default);
    }
    text.push(')');
    if let Some(why) = parameter.without_effect {
        _ = write!(text, "\n\nWithout effect here: {why}");
    }
    if let Some(cycle) = cycle {
        _ = write!(text, "\n\n{}: {}", cycle.name, cycle.what);
    }
    text
}

/// A cycle that a block defines or calls.
pub struct Call {
    pub cycle: &'static Signature,
    /// The part of a dotted cycle.
    part: Option<u32>,
    /// Bytes of the block that name the cycle.
    name_len: usize,
}

impl Call {
    /// The cycle of a block.
    pub fn of(document: &Document, words: Span) -> Option<Call> {
        let dialect = document.dialect?;
        let text = document.text.as_str().get(words.start as usize..words.end as usize)?;
        let upper = text.to_ascii_uppercase();
        if dialect.id == "klartext" {
            let rest = upper.strip_prefix("CYCL")?.trim_start().strip_prefix("DEF")?.trim_start();
            let digits: String = rest.chars().take_while(char::is_ascii_digit).collect();
            let part = rest[digits.len()..]
                .strip_prefix('.')
                .and_then(|part| part.chars().take_while(char::is_ascii_digit).collect::<String>().parse().ok());
            let cycle = dialect.cycle(&format!("CYCL DEF {digits}"))?;
            let name_len = upper.len() - rest.len() + digits.len();
            return Some(Call { cycle, part, name_len });
        }
        let name: String = upper.chars().take_while(|c| c.is_ascii_alphanumeric() || *c == '_').collect();
        // `MCALL CYCLE81(…)`
        if name == "MCALL" {
            let rest = upper["MCALL".len()..].trim_start();
            let inner: String = rest.chars().take_while(|c| c.is_ascii_alphanumeric() || *c == '_').collect();
            let cycle = dialect.cycle(&inner)?;
            return Some(Call { cycle, part: None, name_len: upper.len() - rest.len() + inner.len() });
        }
        let cycle = dialect.cycle(&name)?;
        Some(Call { cycle, part: None, name_len: name.len() })
    }

    /// Does the byte lie in the name of the cycle?
    fn names(&self, _: &str, offset: usize, words: Span) -> bool {
        offset <= words.start as usize + self.name_len
    }

    /// The parameter of which the value or the name stands at a byte.
    fn parameter_at(&self, text: &str, offset: usize, words: Span) -> Option<&'static Parameter> {
        let inside = offset.checked_sub(words.start as usize + self.name_len)?;
        let rest = text.get(words.start as usize + self.name_len..words.end as usize)?;
        if rest.starts_with('(') || rest.trim_start().starts_with('(') {
            let place = argument(rest.get(..inside)?)?;
            return self.cycle.parameters.get(place);
        }
        let (start, end) = word_at(text, offset);
        let word = text.get(start..end)?.to_ascii_uppercase();
        let letters = word.trim_end_matches(|c: char| c.is_ascii_digit() || c == '.');
        let found = self.cycle.parameters.iter().find(|parameter| match parameter.name {
            ParameterName::Q(number) => word == format!("Q{number}"),
            ParameterName::Word(name) => name.eq_ignore_ascii_case(&word) || name.eq_ignore_ascii_case(letters),
            ParameterName::Part(part) => self.part == Some(part),
            ParameterName::In(part, name) => self.part == Some(part) && name.eq_ignore_ascii_case(letters),
        });
        found.filter(|_| inside > 0)
    }
}

/// The number of the argument at the end of what stands behind the name, from 0.
fn argument(front: &str) -> Option<usize> {
    let (mut depth, mut quoted, mut place) = (0, false, 0);
    for c in front.chars() {
        match c {
            '"' => quoted = !quoted,
            '(' if !quoted => depth += 1,
            ')' if !quoted => depth -= 1,
            ',' if !quoted && depth == 1 => place += 1,
            _ => {}
        }
    }
    (depth > 0).then_some(place)
}
