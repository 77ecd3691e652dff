//! One build with the whole sample. What does not compile is found by the places of the errors, and left out.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use serde_json::Value;

use super::edit::{self, Lines};
use super::{Places, Result, tree};

/// The test programs that judge, by the names of their targets.
pub const PROGRAMS: [&str; 2] = ["partc", "suite"];

/// Builds the test programs, and writes where they are.
pub fn build(places: &Places) -> Result<()> {
    tree::lay_out(places)?;
    loop {
        let (messages, succeeded) = cargo(places, &["check", "--tests"])?;
        if succeeded {
            break;
        }
        let wrong = wrong(places, &messages)?;
        println!("{} changes do not compile", wrong.len());
        tree::leave_out(places, &wrong)?;
        tree::lay_out(places)?;
    }
    let (messages, succeeded) = cargo(places, &["test", "--no-run", "--lib", "--test", "suite", "--bin", "partc"])?;
    if !succeeded {
        return Err("the tests do not build".into());
    }
    let mut programs = BTreeMap::new();
    for message in &messages {
        let Some(program) = message.get("executable").and_then(Value::as_str) else { continue };
        let target = message.get("target");
        let text = |key: &str| target.and_then(|target| target.get(key)).cloned().unwrap_or_default();
        let name = text("name").as_str().unwrap_or_default().to_owned();
        let is_test = message.get("profile").and_then(|profile| profile.get("test")) == Some(&Value::Bool(true));
        if is_test && !text("kind").to_string().contains("bin") && PROGRAMS.contains(&name.as_str()) {
            programs.insert(name, PathBuf::from(program));
        }
    }
    let lines: String = programs.iter().map(|(name, path)| format!("{name}\t{}\n", path.display())).collect();
    print!("{lines}");
    Ok(fs::write(places.work.join("programs.tsv"), lines)?)
}

/// Where the test programs are.
pub fn programs(places: &Places) -> Result<BTreeMap<String, PathBuf>> {
    let text = fs::read_to_string(places.work.join("programs.tsv"))?;
    Ok(text.lines().filter_map(|line| line.split_once('\t')).map(|(name, path)| (name.into(), path.into())).collect())
}

fn cargo(places: &Places, args: &[&str]) -> Result<(Vec<Value>, bool)> {
    let mut command = Command::new(std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned()));
    command.args(args).args(["--locked", "--message-format=json"]).current_dir(places.tree()).stderr(Stdio::inherit());
    // Assertions stay on, and the tests are quick enough to be run hundreds of times.
    command.env("CARGO_TARGET_DIR", places.work.join("build")).env("CARGO_PROFILE_DEV_OPT_LEVEL", "1");
    command.env("CARGO_PROFILE_DEV_DEBUG", "0").env("CARGO_INCREMENTAL", "0");
    command.env("CARGO_PROFILE_DEV_CODEGEN_UNITS", "64").env("RUSTFLAGS", "-Awarnings");
    let out = command.output()?;
    let messages = String::from_utf8(out.stdout)?.lines().filter_map(|line| serde_json::from_str(line).ok()).collect();
    Ok((messages, out.status.success()))
}

/// The changes in whose text errors stand.
fn wrong(places: &Places, messages: &[Value]) -> Result<BTreeMap<usize, String>> {
    let mut wrong = BTreeMap::new();
    for message in messages.iter().filter_map(|message| message.get("message")) {
        if message.get("level").and_then(Value::as_str) != Some("error") {
            continue;
        }
        let code = message.get("code").and_then(|code| code.get("code")).and_then(Value::as_str).unwrap_or("syntax");
        let title = message.get("message").and_then(Value::as_str).unwrap_or_default().replace(['\t', '\n'], " ");
        let spans = message.get("spans").and_then(Value::as_array).cloned().unwrap_or_default();
        let mut owners = Vec::new();
        for span in &spans {
            let found = if code == "E0004" { next_arm(places, span)? } else { owner(places, span)? };
            owners.extend(found.map(|owner| (!is_primary(span), owner)));
        }
        owners.sort_unstable();
        match owners.first() {
            Some((_, number)) => {
                wrong.insert(*number, format!("{code} {title}"));
            }
            None if !spans.is_empty() => {
                let shown = message.get("rendered").and_then(Value::as_str).unwrap_or_default();
                eprintln!("nobody's error: {shown}");
            }
            None => {}
        }
    }
    if wrong.is_empty() { Err("errors that belong to no change".into()) } else { Ok(wrong) }
}

fn is_primary(span: &Value) -> bool {
    span.get("is_primary") == Some(&Value::Bool(true))
}

/// The change in which a place lies. What a macro makes lies where it is called.
fn owner(places: &Places, span: &Value) -> Result<Option<usize>> {
    let call = span.get("expansion").and_then(|expansion| expansion.get("span"));
    if let Some(owner) = call.map(|call| owner(places, call)).transpose()?.flatten() {
        return Ok(Some(owner));
    }
    Ok(place(places, span)?.and_then(|(text, at)| edit::owner(&text, at)))
}

/// The text of a place, and where in it.
fn place(places: &Places, span: &Value) -> Result<Option<(String, usize)>> {
    let count = |key: &str| span.get(key).and_then(Value::as_u64).and_then(|count| usize::try_from(count).ok());
    let path = places.tree().join(span.get("file_name").and_then(Value::as_str).unwrap_or_default());
    let (Some(line), Some(column), true) = (count("line_start"), count("column_start"), path.is_file()) else {
        return Ok(None);
    };
    let text = fs::read_to_string(path)?;
    let at = Lines::of(&text).offset(line, column - 1);
    Ok(at.map(|at| (text, at)))
}

/// A `match` that does not take every value: the next arm that is never taken made it so.
fn next_arm(places: &Places, span: &Value) -> Result<Option<usize>> {
    let Some((text, at)) = place(places, span)? else { return Ok(None) };
    let number = |found: &str| found.split(')').next().and_then(|number| number.parse().ok());
    Ok(text[at..].split_once("!crate::mutation::on(").and_then(|(_, found)| number(found)))
}
