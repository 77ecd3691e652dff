//! Heads of files, by the language that they are in: what each is taken for, and what is said of it.
//!
//! A book of heads, `tests/heads/*.heads`, has chapters (`=== `) and cases (`== `); a case has the names that the file bears
//! (`-- P.MPF P.H`), and then its text (`\xHH` behind `-- escaped P.H`). Beside it lies the listing, a snapshot.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use partc::internals::diag::Severity;
use partc::internals::dialect::read_as;
use partc::internals::driver::Session;
use partc::internals::machine::Settings;
use partc::internals::text::files::NoFiles;
use partc::internals::text::{Memory, Opened};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/heads")
}

/// A head under a name.
struct Head {
    heading: String,
    name: String,
    text: Vec<u8>,
}

fn unescaped(text: &str) -> Vec<u8> {
    let mut parts = text.split("\\x");
    let mut bytes = parts.next().unwrap_or_default().as_bytes().to_vec();
    for part in parts {
        bytes.push(u8::from_str_radix(&part[..2], 16).expect("two hexadecimal digits"));
        bytes.extend(&part.as_bytes()[2..]);
    }
    bytes
}

fn heads(book: &str) -> Vec<Head> {
    let text = fs::read_to_string(folder().join(format!("{book}.heads"))).expect("a book of heads");
    let mut found = Vec::new();
    for case in format!("\n{text}").split("\n== ").skip(1) {
        let (heading, rest) = case.split_once("\n-- ").expect("the names of the file");
        let (names, body) = rest.split_once('\n').unwrap_or((rest, ""));
        let body = body.split("\n=== ").next().unwrap_or_default();
        let body = format!("{}\n", body.trim_end_matches('\n'));
        let (is_escaped, names) = match names.strip_prefix("escaped ") {
            Some(names) => (true, names),
            None => (false, names),
        };
        for name in names.split(' ') {
            let text = if is_escaped { unescaped(body.trim_end_matches('\n')) } else { body.clone().into_bytes() };
            found.push(Head { heading: heading.to_owned(), name: name.to_owned(), text });
        }
    }
    found
}

/// The language, or the one finding.
fn told(head: &Head) -> String {
    let Some(dialect) = read_as(&head.name, &head.text) else { return "asks which language it is".to_owned() };
    if !dialect.is_foreign() {
        return format!("read as {}", dialect.id);
    }
    let text = Box::new(Memory::new(head.text.clone()));
    let session = Session::new(Opened { name: head.name.clone(), identity: head.name.clone(), text });
    session.check(dialect, &Settings::default(), &NoFiles);
    let found = session.diags.into_sorted();
    let [only] = &found[..] else { panic!("{}, {}: {} findings", head.heading, head.name, found.len()) };
    assert_eq!((only.code.id, only.severity), ("P0009", Severity::Error), "{}", head.heading);
    format!("[{}] {}\n     {}", dialect.name, only.text(), only.help.clone().unwrap_or_default())
}

fn check(book: &str) {
    let mut listing = String::new();
    // Names under which the same is said stand together.
    let mut cases: Vec<(String, BTreeMap<String, Vec<String>>)> = Vec::new();
    for head in heads(book) {
        if cases.last().is_none_or(|(heading, _)| *heading != head.heading) {
            cases.push((head.heading.clone(), BTreeMap::new()));
        }
        let (_, said) = cases.last_mut().expect("the case");
        said.entry(told(&head)).or_default().push(head.name);
    }
    for (heading, said) in cases {
        writeln!(listing, "== {heading}").expect("a text");
        for (told, names) in said {
            writeln!(listing, "{}: {told}", names.join(" ")).expect("a text");
        }
    }
    let mut settings = insta::Settings::clone_current();
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_snapshot_path(folder());
    settings.bind(|| insta::assert_snapshot!(book, listing));
}

#[test]
fn programs_of_other_controls() {
    check("controls");
}

#[test]
fn files_nc() {
    check("nc");
}

#[test]
fn files_that_are_no_programs() {
    check("files");
}

/// What looks like another language at first sight is read in its own.
#[test]
fn programs_of_ours() {
    for head in heads("ours") {
        let said = told(&head);
        assert!(said.starts_with("read as "), "{}, {}: {said}", head.heading, head.name);
    }
    check("ours");
}
