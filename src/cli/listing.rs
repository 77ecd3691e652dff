//! Codes on the terminal: `partc explain`, `partc rules`.

use std::fs;
use std::io::{self, Write};
use std::path::Path;

use serde_json::json;

use crate::diag::codes;
use crate::diag::fault::Wording;
use crate::machine::keys::{Key, Kind, SECTIONS, Section};
use crate::machine::tree::did_you_mean;

use super::options::ListFormat;
use super::{Exit, Trouble};

/// `partc man`
pub(super) fn manual(all: clap::Command, command: Option<&str>, folder: Option<&Path>) -> Result<Exit, Trouble> {
    let trouble = |error: io::Error| error.to_string();
    if let Some(folder) = folder {
        fs::create_dir_all(folder).map_err(trouble)?;
        clap_mangen::generate_to(all, folder).map_err(trouble)?;
        return Ok(Exit::Clean);
    }
    let (page_of, title) = match command {
        None => (all, "partc".to_owned()),
        Some(name) => {
            let names: Vec<&str> = all.get_subcommands().map(clap::Command::get_name).collect();
            let found = all.get_subcommands().find(|sub| sub.get_name() == name).cloned();
            let hint = || match did_you_mean(name, names.iter().copied()) {
                Some(like) => format!("did you mean `{like}`?"),
                None => names.join(", "),
            };
            let found = found.ok_or_else(|| format!("no command `{name}`; {}", hint()))?;
            (found.bin_name(format!("partc {name}")), format!("partc-{name}"))
        }
    };
    let mut page = Vec::new();
    clap_mangen::Man::new(page_of).title(title).render(&mut page).map_err(trouble)?;
    print(&page)
}

/// The keys of a configuration: `control.feed`, or `feed` alone, which several tables may have.
fn keys(name: &str) -> Vec<(&'static Section, &'static Key)> {
    let (section, key) = name.trim_matches(['[', ']']).rsplit_once('.').map_or((None, name), |(s, k)| (Some(s), k));
    let sections = SECTIONS.iter().filter(|found| section.is_none_or(|wanted| wanted == found.name));
    let keys = sections.flat_map(|section| section.keys().chain(section.entry).map(move |key| (section, key)));
    keys.filter(|(_, found)| found.name == key).collect()
}

/// What a key means, as text.
fn explained_key(section: &Section, key: &Key) -> String {
    let entry = if section.entry.iter().any(|part| part.name == key.name) { ".NAME" } else { "" };
    let mut text = format!("[{}{entry}] {}\n{}\n\n", section.name, key.name, key.doc);
    if let Kind::Choice(values) = key.kind {
        text += &format!("values: {}\n", values.join(", "));
    }
    text += &match (key.default, key.warns) {
        ("", _) => "default: none\n".to_owned(),
        (default, true) => format!("default: {default}, with a warning until it is set\n"),
        (default, false) => format!("default: {default}\n"),
    };
    text
}

fn key_object(section: &Section, key: &Key) -> serde_json::Value {
    let values = if let Kind::Choice(values) = key.kind { values } else { &[] };
    let (name, default) = (key.name, key.default);
    json!({ "table": section.name, "key": name, "doc": key.doc, "values": values, "default": default })
}

/// The table of this name.
fn section(name: &str) -> Option<&'static Section> {
    SECTIONS.iter().find(|section| section.name.eq_ignore_ascii_case(name.trim_matches(['[', ']'])))
}

/// What a table is for, with its keys.
fn explained_section(section: &Section, format: ListFormat) -> String {
    let keys = || section.keys().chain(section.entry);
    if format == ListFormat::Json {
        let keys: Vec<&str> = keys().map(|key| key.name).collect();
        return format!("{}\n", json!({ "table": section.name, "doc": section.doc, "keys": keys }));
    }
    let width = keys().map(|key| key.name.len()).max().unwrap_or(0);
    let keys: String = keys().map(|key| format!("  {:width$}  {}\n", key.name, key.doc)).collect();
    let keys = if keys.is_empty() { keys } else { format!("\nkeys:\n{keys}") };
    format!("[{}]\n{}\n{keys}", section.name, section.doc)
}

/// `partc explain CODE`
pub(super) fn explain(code: &str, format: ListFormat) -> Result<Exit, Trouble> {
    let Some(found) = codes::find(code) else {
        if let Some(section) = section(code) {
            return print(explained_section(section, format).as_bytes());
        }
        let keys = keys(code);
        if !keys.is_empty() {
            let text = if format == ListFormat::Json {
                let objects: Vec<serde_json::Value> =
                    keys.iter().map(|(section, key)| key_object(section, key)).collect();
                // A single key is no list.
                if let [object] = &objects[..] { format!("{object}\n") } else { format!("{}\n", json!(objects)) }
            } else {
                keys.iter().map(|(section, key)| explained_key(section, key)).collect::<Vec<_>>().join("\n")
            };
            return print(text.as_bytes());
        }
        let all = codes::all();
        let like = did_you_mean(code, all.iter().map(|code| code.id).chain(all.iter().map(|code| code.name)));
        let hint = like.map_or("`partc rules` lists all codes".to_owned(), |like| format!("did you mean `{like}`?"));
        return Err(format!("no code `{code}`; {hint}"));
    };
    let text = if format == ListFormat::Json {
        let mut value = object(found);
        value["says"] = found.wordings.iter().map(wording_object).collect();
        value["example"] = json!(found.example());
        format!("{value}\n")
    } else {
        let head = format!("{} {} ({})\n{}\n", found.id, found.name, found.severity.word(), found.title);
        format!("{head}\n{}\n{}{}{}", found.explain, wordings(found), before(found), example(found))
    };
    print(text.as_bytes())
}

/// What a code says of its faults, and what to do: once, after those that share it. A fault that is all quantity says nothing here.
fn wordings(code: &codes::Code) -> String {
    let says = |wording: &&Wording| wording.shown(wording.message).contains(char::is_alphabetic);
    let mut told = code.wordings.iter().filter(says).peekable();
    let mut text = if told.peek().is_some() { "\nIt says:\n".to_owned() } else { String::new() };
    while let Some(wording) = told.next() {
        let alarm = wording.alarm.map_or_else(String::new, |alarm| format!(" (alarm {alarm})"));
        text += &format!("  {}{alarm}\n", wording.shown(wording.message));
        if !wording.help.is_empty() && told.peek().is_none_or(|next| next.help != wording.help) {
            text += &format!("    {}\n", wording.shown(wording.help));
        }
    }
    text
}

fn wording_object(wording: &Wording) -> serde_json::Value {
    let help = (!wording.help.is_empty()).then(|| wording.shown(wording.help));
    json!({ "name": wording.name, "message": wording.shown(wording.message), "help": help, "alarm": wording.alarm })
}

/// Codes and names that stay valid.
fn before(code: &codes::Code) -> String {
    if code.was.is_empty() { String::new() } else { format!("\nBefore, and still valid: {}\n", code.was) }
}

/// The example of a code, its programs indented.
fn example(code: &codes::Code) -> String {
    let lines = code.example().into_iter().flat_map(str::lines);
    let shown = lines.map(|line| match line.strip_prefix("-- ") {
        Some(name) => format!("\n{name}:\n\n"),
        None => format!("    {line}").trim_end().to_owned() + "\n",
    });
    shown.collect()
}

/// `partc rules`
pub(super) fn rules(format: ListFormat) -> Result<Exit, Trouble> {
    let all = codes::all();
    let text = if format == ListFormat::Json {
        format!("{}\n", json!(all.iter().map(|code| object(code)).collect::<Vec<_>>()))
    } else {
        let width = all.iter().map(|code| code.name.len()).max().unwrap_or(0);
        all.iter()
            .map(|code| format!("{} {:7} {:width$}  {}\n", code.id, code.severity.word(), code.name, code.title))
            .collect()
    };
    print(text.as_bytes())
}

fn object(code: &codes::Code) -> serde_json::Value {
    json!({
        "code": code.id,
        "name": code.name,
        "severity": code.severity.word(),
        "title": code.title,
        "explanation": code.explain,
    })
}

/// Writes to standard output. `partc rules | head` is no trouble.
pub(super) fn print(bytes: &[u8]) -> Result<Exit, Trouble> {
    let mut out = io::stdout().lock();
    match out.write_all(bytes).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(format!("stdout: {error}")),
        _ => Ok(Exit::Clean),
    }
}
