//! Reports of shards become the report of all programs.
//!
//! In: documents that this folder has written, of one form. Out: the document that one run would have written, where it takes the
//! programs in the order of their paths.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::path::Path;

use serde_json::{Value, json};

use crate::text::decode::escaped_json;

use super::{checkstyle, gitlab, xml};

/// What a report is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Form {
    Json,
    Sarif,
    GitLab,
    JUnit,
    Checkstyle,
}

/// A part of a report with the program that it belongs to.
type Part<T> = (String, T);

/// Puts reports together; each with its name.
///
/// # Errors
/// Which of them is none that can be put to the others.
pub fn merge(reports: &[(String, String)]) -> Result<String, String> {
    let mut common = None;
    for (name, text) in reports {
        let form = form(text).ok_or_else(|| format!("{name}: {NO_REPORT}"))?;
        if *common.get_or_insert(form) != form {
            return Err(format!("{name}: is a report of another form than {}", reports[0].0));
        }
    }
    let named =
        |merged: Merged| merged.map_err(|(at, why)| format!("{}: {why}", reports.get(at).map_or("", |(name, _)| name)));
    let texts: Vec<&str> = reports.iter().map(|(_, text)| text.as_str()).collect();
    named(match common {
        Some(Form::Json) => of_values(&texts, json_report),
        Some(Form::Sarif) => of_values(&texts, sarif),
        Some(Form::GitLab) => of_values(&texts, code_quality),
        Some(Form::JUnit) => junit(&texts),
        Some(Form::Checkstyle) => of_checkstyle(&texts),
        None => Err((0, NO_REPORT)),
    })
}

const NO_REPORT: &str = "is no json, sarif, gitlab, junit or checkstyle report of `partc check`";

fn form(text: &str) -> Option<Form> {
    if let Some(rest) = text.strip_prefix(xml::HEAD) {
        return match rest {
            _ if rest.starts_with("<checkstyle ") => Some(Form::Checkstyle),
            _ if rest.starts_with("<testsuites ") => Some(Form::JUnit),
            _ => None,
        };
    }
    match serde_json::from_str(text).ok()? {
        Value::Array(_) => Some(Form::GitLab),
        Value::Object(object) if object.contains_key("runs") => Some(Form::Sarif),
        Value::Object(object) if object.contains_key("diagnostics") => Some(Form::Json),
        _ => None,
    }
}

/// As a folder is walked: part by part.
fn by_program<T>(a: &Part<T>, b: &Part<T>) -> Ordering {
    Path::new(&a.0).cmp(Path::new(&b.0))
}

fn text_of(value: &Value) -> String {
    value.as_str().unwrap_or_default().to_owned()
}

type Merged = Result<String, Fault>;
/// The number of a report, and what is wrong with it.
type Fault = (usize, &'static str);

fn of_values(texts: &[&str], merge: fn(Vec<Value>) -> Result<Value, Fault>) -> Merged {
    let mut values = Vec::new();
    for (at, text) in texts.iter().enumerate() {
        values.push(serde_json::from_str(text).map_err(|_| (at, NO_REPORT))?);
    }
    Ok(escaped_json(&merge(values)?.to_string()).into_owned() + "\n")
}

/// The elements of a list; a report that has none of this name is none of ours.
fn list(value: &mut Value, at: usize) -> Result<Vec<Value>, Fault> {
    match value.take() {
        Value::Array(list) => Ok(list),
        _ => Err((at, NO_REPORT)),
    }
}

fn without_repeats(all: &mut Vec<Value>, more: Vec<Value>) {
    for value in more {
        if !all.contains(&value) {
            all.push(value);
        }
    }
}

fn json_report(reports: Vec<Value>) -> Result<Value, Fault> {
    let (mut found, mut troubles, mut sums) = (Vec::new(), Vec::new(), BTreeMap::new());
    for (at, mut report) in reports.into_iter().enumerate() {
        if report["version"] != 1 {
            return Err((at, "is a report of another version"));
        }
        for diagnostic in list(&mut report["diagnostics"], at)? {
            // The outermost call stands in the program.
            let outermost = diagnostic["stack"].as_array().and_then(|stack| stack.last());
            let program = text_of(&outermost.unwrap_or(&diagnostic)["file"]);
            found.push((program, diagnostic));
        }
        for name in ["files", "errors", "warnings", "not_shown"] {
            let count = match &report[name] {
                Value::Null if name == "not_shown" => 0,
                count => count.as_u64().ok_or((at, NO_REPORT))?,
            };
            let sum: &mut u64 = sums.entry(name).or_default();
            *sum = sum.checked_add(count).ok_or((at, "counts more than there can be"))?;
        }
        if let Value::Array(list) = report["troubles"].take() {
            without_repeats(&mut troubles, list);
        }
    }
    found.sort_by(by_program);
    let found: Vec<Value> = found.into_iter().map(|(_, found)| found).collect();
    let sum = |name: &str| sums.get(name).copied().unwrap_or(0);
    let mut report = json!({
        "version": 1,
        "diagnostics": found,
        "files": sum("files"),
        "errors": sum("errors"),
        "warnings": sum("warnings"),
    });
    if sum("not_shown") > 0 {
        report["not_shown"] = json!(sum("not_shown"));
    }
    if !troubles.is_empty() {
        report["troubles"] = json!(troubles);
    }
    Ok(report)
}

fn code_quality(reports: Vec<Value>) -> Result<Value, Fault> {
    let mut issues = Vec::new();
    for (at, mut report) in reports.into_iter().enumerate() {
        for issue in list(&mut report, at)? {
            let program = issue.get(gitlab::PROGRAM).unwrap_or(&issue["location"]["path"]);
            issues.push((text_of(program), issue));
        }
    }
    issues.sort_by(by_program);
    Ok(issues.into_iter().map(|(_, issue)| issue).collect())
}

fn sarif(reports: Vec<Value>) -> Result<Value, Fault> {
    let (mut results, mut notifications) = (Vec::new(), Vec::new());
    let mut known: BTreeMap<String, Value> = BTreeMap::new();
    let mut frame: Option<Value> = None;
    for (at, mut report) in reports.into_iter().enumerate() {
        let run = &mut report["runs"][0];
        for result in list(&mut run["results"], at)? {
            results.push((program_of(&result), result));
        }
        for rule in list(&mut run["tool"]["driver"]["rules"], at)? {
            known.insert(text_of(&rule["id"]), rule);
        }
        without_repeats(&mut notifications, list(&mut run["invocations"][0]["toolExecutionNotifications"], at)?);
        match &frame {
            Some(first) if first["runs"][0]["tool"] != report["runs"][0]["tool"] => {
                return Err((at, "was written by another version of partc"));
            }
            Some(_) => {}
            None => frame = Some(report),
        }
    }
    results.sort_by(by_program);
    let (mut rules, mut places) = (Vec::new(), BTreeMap::new());
    for (_, result) in &mut results {
        let id = text_of(&result["ruleId"]);
        let place = *places.entry(id.clone()).or_insert_with(|| {
            rules.push(known.get(&id).cloned().unwrap_or_default());
            rules.len() - 1
        });
        result["ruleIndex"] = json!(place);
    }
    let mut report = frame.unwrap_or_default();
    let run = &mut report["runs"][0];
    run["tool"]["driver"]["rules"] = Value::Array(rules);
    run["invocations"][0]["executionSuccessful"] = json!(notifications.is_empty());
    run["invocations"][0]["toolExecutionNotifications"] = Value::Array(notifications);
    run["results"] = results.into_iter().map(|(_, result)| result).collect();
    Ok(report)
}

/// The program of a result of SARIF: that of the outermost call, or its own file.
fn program_of(result: &Value) -> String {
    let calls = result["relatedLocations"].as_array();
    let outermost = calls.and_then(|calls| calls.iter().rfind(|place| place["message"]["text"] == "called from here"));
    let place = outermost.unwrap_or(&result["locations"][0]);
    let uri = text_of(&place["physicalLocation"]["artifactLocation"]["uri"]);
    let path = uri.strip_prefix("file://").unwrap_or(&uri);
    // What is escaped in a URI is not in the order of paths.
    let mut bytes = Vec::new();
    let mut rest = path.as_bytes();
    while let [first, behind @ ..] = rest {
        let code = behind.get(..2).and_then(|two| u8::from_str_radix(std::str::from_utf8(two).ok()?, 16).ok());
        match code.filter(|_| *first == b'%') {
            Some(code) => {
                bytes.push(code);
                rest = &behind[2..];
            }
            None => {
                bytes.push(*first);
                rest = behind;
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

fn junit(texts: &[&str]) -> Merged {
    const CASE: &str = "    <testcase classname=\"partc\" name=\"";
    const END: &str = "    </testcase>\n";
    let (mut cases, mut troubles): (Vec<Part<String>>, Vec<String>) = (Vec::new(), Vec::new());
    for (at, text) in texts.iter().enumerate() {
        let inside = text.split_once("\n  <testsuite ").and_then(|(_, rest)| rest.split_once(">\n"));
        let (inside, _) = inside.and_then(|(_, rest)| rest.split_once("  </testsuite>\n")).ok_or((at, NO_REPORT))?;
        for case in inside.split_inclusive(END) {
            let name = case.strip_prefix(CASE).and_then(|rest| rest.split_once("\">\n")).ok_or((at, NO_REPORT))?;
            if name.1.starts_with("      <error message=") {
                if !troubles.iter().any(|known| known == case) {
                    troubles.push(case.to_owned());
                }
            } else {
                cases.push((unescaped(name.0), case.to_owned()));
            }
        }
    }
    cases.sort_by(by_program);
    let failures = cases.iter().filter(|(_, case)| case.contains("\n      <failure message=")).count();
    let (tests, errors) = (cases.len() + troubles.len(), troubles.len());
    let counts = format!("tests=\"{tests}\" failures=\"{failures}\" errors=\"{errors}\"");
    let cases: String = cases.into_iter().map(|(_, case)| case).chain(troubles).collect();
    let head = xml::HEAD;
    Ok(format!(
        "{head}<testsuites {counts}>\n  <testsuite name=\"partc\" {counts}>\n{cases}  </testsuite>\n</testsuites>\n"
    ))
}

fn of_checkstyle(texts: &[&str]) -> Merged {
    const OPEN: &str = "<checkstyle version=\"8.0\">\n";
    const FILE: &str = "  <file name=\"";
    let mut files: Vec<Part<String>> = Vec::new();
    for (at, text) in texts.iter().enumerate() {
        let inside = text.strip_prefix(xml::HEAD).and_then(|rest| rest.strip_prefix(OPEN));
        let inside = inside.and_then(|rest| rest.strip_suffix("</checkstyle>\n")).ok_or((at, NO_REPORT))?;
        for element in inside.split_inclusive("  </file>\n") {
            let named = |text: &str, front: &str, behind: &str| {
                let rest = text.trim_start().strip_prefix(front.trim_start())?;
                Some(unescaped(rest.split_once(behind)?.0))
            };
            let program = named(element, checkstyle::PROGRAM, "\"?>\n").or_else(|| named(element, FILE, "\">\n"));
            files.push((program.ok_or((at, NO_REPORT))?, element.to_owned()));
        }
    }
    files.sort_by(by_program);
    let files: String = files.into_iter().map(|(_, element)| element).collect();
    Ok(format!("{}{OPEN}{files}</checkstyle>\n", xml::HEAD))
}

/// What [`xml::escaped`] was made of.
fn unescaped(text: &str) -> String {
    [("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&#10;", "\n"), ("&#9;", "\t"), ("&amp;", "&")]
        .iter()
        .fold(text.to_owned(), |text, (word, c)| text.replace(word, c))
}
