//! A key of `partc.toml` that is asked for: what would answer it, and its line in a configuration.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use crate::diag::{Answer, Values};
use crate::driver::Session;
use crate::machine::keys::{Key, Kind, SECTIONS, choices};
use crate::text::Loc;

/// Column of the remarks.
pub(super) const WIDTH: usize = 34;
/// Characters of a block that are quoted.
const QUOTED: usize = 60;
/// Of the number of a tool that is called by its name.
pub(super) const FREE: &str = "a free number: write the one of this tool, it is printed";

/// A block that asks for a key.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Place {
    pub file: String,
    pub line: u32,
    pub block: String,
}

impl Place {
    pub fn new(loc: Loc, session: &Session) -> Place {
        let line = session.sources.line(loc);
        Place { file: session.sources.shown(loc.file), line: line.number, block: cut(line.text.trim()) }
    }
}

/// Source text as far as it is quoted.
pub(super) fn cut(text: &str) -> String {
    match text.char_indices().nth(QUOTED) {
        Some((at, _)) => format!("{}…", &text[..at]),
        None => text.to_owned(),
    }
}

/// All that is asked for a key.
#[derive(Debug, Clone)]
pub(super) struct Need {
    pub answer: Answer,
    pub values: BTreeSet<Values>,
    pub first: Place,
    /// Programs that ask.
    pub programs: BTreeSet<String>,
    pub codes: BTreeSet<&'static str>,
}

impl Need {
    pub fn items(&self) -> Vec<String> {
        let mut items: Vec<String> = self
            .values
            .iter()
            .filter_map(|values| match values {
                Values::Item(item) => Some(item.clone()),
                _ => None,
            })
            .collect();
        items.sort_by_key(|item| (item.parse::<u32>().unwrap_or(u32::MAX), item.clone()));
        items
    }

    /// The values that would do.
    pub fn choices(&self) -> Vec<String> {
        let mut choices: Vec<String> = Vec::new();
        for values in &self.values {
            if let Values::OneOf(list) = values {
                choices.extend(list.iter().filter(|value| !choices.contains(value)).cloned().collect::<Vec<_>>());
            }
        }
        if choices.is_empty() { self::choices(&self.answer) } else { choices }
    }

    /// What kind of value the user has to find.
    pub fn wanted(&self) -> String {
        if let Values::Meaning(meaning) = &self.answer.values {
            return format!("number: {meaning}; ");
        }
        match (self.answer.section, key_of(&self.answer)) {
            ("include", _) => "a folder, counted from this file; ".to_owned(),
            ("datums", None) if self.answer.values == Values::Coordinates => {
                "machine coordinates of its zero, as { X = …, Y = …, Z = … }; ".to_owned()
            }
            ("machine", _) if self.answer.path[0] == "after_tool_change" => {
                "number, what the control shows for the new tool when the change is over; ".to_owned()
            }
            (_, Some(key)) => format!("{}; ", kind(key)),
            ("datums", None) => "a work offset of the target, as \"G55\"; ".to_owned(),
            ("start", None) => "number, where the axis stands before the first block; ".to_owned(),
            (_, None) => "number; ".to_owned(),
        }
    }

    pub fn places(&self) -> String {
        let Place { file, line, block } = &self.first;
        let more = match self.programs.len() {
            0 | 1 => String::new(),
            2 => ", and another program".to_owned(),
            n => format!(", and {} other programs", n - 1),
        };
        format!("{file}:{line} `{block}`{more}")
    }
}

/// How keys are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    /// To be pasted: what is open is left for the user to write.
    Lines,
    /// Commented, `#key =`, for a file that is used as it stands.
    Commented,
    /// With some value for each key, so that a run goes on: for trying only.
    Tried,
}

/// What a program of the machine builder does is a promise of the user, also where only one can be made.
pub(super) fn is_promise(need: &Need) -> bool {
    need.answer.section == "programs" || is_alternative(need)
}

/// A promise that stands beside another answer to the same finding.
fn is_alternative(need: &Need) -> bool {
    matches!(need.answer.path[0].as_str(), "tool_change_m" | "probing_contact")
}

/// The items that a list of this key holds already.
pub(super) type Listed<'a> = &'a dyn Fn(&str) -> Vec<String>;

/// One line of a key, with what it is and what asks for it. `choice` is the one that is tried, `given` what the user said; items that
/// are `doubted` are left to the user, those `listed` already stay.
pub(super) fn line(
    text: &mut String,
    form: Form,
    need: &Need,
    (choice, given): (usize, Option<&str>),
    (doubted, listed): (&[String], Listed<'_>),
) {
    let key = match need.answer.is_of_tool() {
        true => need.answer.path[1].clone(),
        false => need.answer.place().1,
    };
    // A trial takes the other answer: the number, or the function as it stands.
    if form == Form::Tried && is_alternative(need) {
        return;
    }
    let choices = need.choices();
    let (value, remark) = match (&need.answer.values, &choices[..]) {
        _ if given.is_some() => (given.unwrap_or_default().to_owned(), String::new()),
        (Values::Item(_), _) => {
            let mut items = listed(&need.answer.path[0]);
            let more = need.items().into_iter().filter(|item| !items.contains(item) && !doubted.contains(item));
            items.extend(more.collect::<Vec<_>>());
            let remark = match doubted {
                [] => String::new(),
                _ => format!("and {}, if it changes no tool; ", doubted.join(", ")),
            };
            (if items.is_empty() { String::new() } else { format!("[{}]", items.join(", ")) }, remark)
        }
        (_, [only]) if form == Form::Tried || !is_promise(need) => (only.clone(), String::new()),
        (_, [first, ..]) if form == Form::Tried => {
            // What a block behind the call asks for comes on top of what the call asked for.
            let further = choices.iter().find(|choice| choice.contains("motion = ")).filter(|_| choice == 0);
            (further.or(choices.get(choice)).unwrap_or(first).clone(), String::new())
        }
        (_, [only]) => (String::new(), format!("{only}, if that is so; ")),
        (_, [_, ..]) => (String::new(), format!("{}; ", choices.join(" or "))),
        (_, []) if form == Form::Tried => match tried(&need.answer) {
            Some(value) => (value.to_owned(), String::new()),
            None => return,
        },
        (_, []) => (String::new(), need.wanted()),
    };
    if form == Form::Tried {
        let _ = writeln!(text, "{key} = {value}");
        return;
    }
    let mark = if form == Form::Commented && given.is_none() { "#" } else { "" };
    let entry = format!("{mark}{key} = {value}");
    let _ = writeln!(text, "{entry:WIDTH$} # {remark}{}", need.places());
}

/// The key of the configuration that is asked for.
fn key_of(answer: &Answer) -> Option<&'static Key> {
    let section = SECTIONS.iter().find(|section| section.name == answer.section)?;
    let ([first, ..], Some(last)) = (&answer.path[..], answer.path.last()) else { return None };
    section.keys().find(|key| key.name == first).or_else(|| section.entry.iter().find(|key| key.name == last))
}

/// What kind of value a key takes, in words.
fn kind(key: &Key) -> String {
    let what = match key.kind {
        Kind::Text | Kind::Choice(_) | Kind::Corners => "text",
        Kind::Flag => "true or false",
        Kind::Number | Kind::Free | Kind::NumberOr(_) => "number",
        Kind::Whole | Kind::Places => "whole number",
        Kind::Wholes | Kind::Digits | Kind::Texts | Kind::Words => "list",
    };
    match key.kind {
        Kind::Free => what.to_owned(),
        _ => format!("{what}, {}", key.doc),
    }
}

/// Some value that lets a run go on; it says nothing about the machine. `None` for what nobody can make up: the name of a file.
pub(super) fn tried(answer: &Answer) -> Option<&'static str> {
    let key = answer.path.last().map_or("", String::as_str);
    Some(match (answer.section, key) {
        ("datums", _) => "{ X = 0.0, Y = 0.0, Z = 0.0 }",
        ("tools", "length") => "100.0",
        ("tools", "tip_angle") => "118.0",
        ("tools", "orientation") => "3",
        ("tools", "number") => "1",
        ("tools", "width") => "3.0",
        ("machine", "diameter_axis") => "\"X\"",
        ("machine", "geometry_axes") => "[\"X\", \"Y\", \"Z\"]",
        ("machine", "tilt_axes") => "[\"A\", \"C\"]",
        ("machine", _) if answer.path[0] == "axes" => "\"leave-out\"",
        ("control", "feed" | "rapid_feed") => "1000.0",
        ("output", "rapid_feed") => "1000",
        ("output", "decimals") => "6",
        ("output", "tool_offsets") => "999",
        ("control", "retract_max") | ("start" | "machine", _) => "0.0",
        ("include", _) => "\".\"",
        ("undercut", _) => return None,
        ("control", "modulo") => "\"truncate\"",
        _ => match key_of(answer).map(|key| key.kind) {
            Some(Kind::Text | Kind::Texts | Kind::Words | Kind::Wholes | Kind::Digits) => return None,
            Some(Kind::Flag) => "true",
            Some(Kind::Whole | Kind::Places) => "1",
            Some(Kind::Corners) => "\"none\"",
            Some(Kind::Number | Kind::NumberOr(_) | Kind::Free | Kind::Choice(_)) | None => "1.0",
        },
    })
}

/// Does a trial have a value for the key?
pub(super) fn can_be_tried(answer: &Answer) -> bool {
    match &answer.values {
        Values::OneOf(values) if !values.is_empty() => true,
        Values::Item(_) => true,
        // No folder of these programs has the file.
        Values::FolderOf(_) => false,
        _ => !choices(answer).is_empty() || tried(answer).is_some(),
    }
}
