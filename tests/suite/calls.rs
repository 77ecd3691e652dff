//! Which file of a folder calls methods of which: what imports do not show where many files carry methods of one object.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use super::imports::{Imports, code_of};
use super::layering::sources;

/// Folders whose files may call each other in sets larger than [`MOST`], with the size of the largest set. A smaller one is
/// written down here.
const LARGER: &[(&str, usize)] = &[("emit", 12), ("sema/sinumerik", 8)];

/// Most files that call each other in one set.
const MOST: usize = 6;

/// Most methods of the objects that execute a dialect, of all dialects together. Fewer are written down here.
const METHODS: usize = 493;

/// The files below a folder, as paths below `src`, with their code.
fn files(folder: &str) -> BTreeMap<String, String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let inside = |file: &str| {
        let path = Path::new(file).strip_prefix(&root).expect("a file of src");
        path.to_string_lossy().replace('\\', "/")
    };
    let of_tests = |file: &str| file.contains("/tests/") || file.ends_with("/tests.rs");
    let files = sources(&root.join(folder)).into_iter().map(|(file, text)| (inside(&file), code_of(&text)));
    files.filter(|(file, _)| !of_tests(file)).collect()
}

/// The blocks of `impl` of a file, each with the name of its type.
fn impls(code: &str) -> impl Iterator<Item = (&str, &str)> {
    code.split("\nimpl").skip(1).filter_map(|block| {
        let (head, body) = block.split_once("{\n")?;
        let of = head.rsplit(" for ").next()?.trim();
        // Parameters of the block itself stand in front of its type.
        let of = of.strip_prefix('<').and_then(|rest| rest.split_once("> ")).map_or(of, |(_, of)| of);
        let path = of.split(['<', ' ']).next()?;
        let body = body.split("\n}").next().unwrap_or(body);
        Some((path.rsplit("::").next()?, body))
    })
}

/// Names of methods that a piece of code has: functions whose first argument is `self`.
fn methods(code: &str) -> impl Iterator<Item = &str> {
    code.split("fn ").skip(1).filter_map(|rest| {
        let name = &rest[..rest.find(|c: char| !(c.is_alphanumeric() || c == '_'))?];
        let arguments = match rest[name.len()..].strip_prefix('(') {
            Some(arguments) => arguments,
            None => rest.split_once(">(")?.1,
        };
        let receiver = arguments.split([',', ')', ':']).next()?.trim().trim_start_matches('&');
        receiver.split_whitespace().next_back().filter(|last| *last == "self").map(|_| name)
    })
}

/// What objects of a language are called where another one uses them.
const FIELDS: &[(&str, &str)] = &[
    ("self.core", "Core"),
    ("self.channel", "Channel"),
    ("self.st", "State"),
    ("self.view()", "View"),
    ("core", "Core"),
    ("channel", "Channel"),
    ("st", "State"),
    ("view", "View"),
    ("run", "Run"),
];

/// The methods that the code of `object` calls of itself and of the other objects: type and name.
fn called<'c>(object: &'c str, body: &'c str) -> BTreeSet<(&'c str, &'c str)> {
    let ends = |text: &str, front: &str| {
        let before = text.strip_suffix(front)?.chars().next_back();
        Some(!before.is_some_and(|c| c.is_alphanumeric() || "_.".contains(c)))
    };
    let mut found = BTreeSet::new();
    let mut at = 0;
    for (dot, _) in body.match_indices('.') {
        let rest = &body[dot + 1..];
        let name = rest
            .find(|c: char| !(c.is_alphanumeric() || c == '_'))
            .filter(|at| *at > 0 && rest[*at..].starts_with('('));
        let Some(name) = name.map(|end| &rest[..end]) else { continue };
        at = at.max(dot.saturating_sub(40));
        while !body.is_char_boundary(at) {
            at += 1;
        }
        let front = body[at.min(dot)..dot].trim_end();
        let known = FIELDS.iter().find(|(field, _)| ends(front, field) == Some(true)).map(|(_, of)| *of);
        let of = known.or_else(|| (ends(front, "self") == Some(true)).then_some(object));
        found.extend(of.map(|of| (of, name)));
    }
    found
}

/// A file calls another one where it calls a method that an object has there.
fn calls(files: &BTreeMap<String, String>) -> Imports {
    let mut owners: BTreeMap<(&str, &str), BTreeSet<&str>> = BTreeMap::new();
    for (file, code) in files {
        for (object, body) in impls(code) {
            for method in methods(body) {
                owners.entry((object, method)).or_default().insert(file);
            }
        }
    }
    let of = |(file, code): (&String, &String)| {
        let called = impls(code).flat_map(|(object, body)| called(object, body));
        let owners = called.filter_map(|method| owners.get(&method)).filter(|owners| owners.len() == 1);
        let others = owners.flatten().filter(|owner| **owner != file.as_str()).map(|owner| (*owner).to_owned());
        (file.clone(), others.collect())
    };
    files.iter().map(of).collect()
}

fn reached(calls: &Imports, from: &str) -> BTreeSet<String> {
    let (mut seen, mut open) = (BTreeSet::new(), vec![from.to_owned()]);
    while let Some(file) = open.pop() {
        open.extend(calls[&file].iter().filter(|next| seen.insert((*next).clone())).cloned());
    }
    seen
}

/// The largest set of files each of which calls all others, if only through others.
fn largest_set(calls: &Imports) -> BTreeSet<String> {
    let reached: BTreeMap<&String, BTreeSet<String>> = calls.keys().map(|file| (file, reached(calls, file))).collect();
    let set = |file: &String| -> BTreeSet<String> {
        reached[file].iter().filter(|other| reached[other].contains(file)).cloned().collect()
    };
    calls.keys().map(set).max_by_key(BTreeSet::len).unwrap_or_default()
}

/// All folders below `src`; those of `sema` each for itself.
fn folders() -> Vec<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let below = |folder: &str| -> Vec<String> {
        let entries =
            std::fs::read_dir(root.join(folder)).expect("a folder").map(|entry| entry.expect("an entry").path());
        let folders = entries.filter(|path| path.is_dir());
        folders.map(|path| path.file_name().expect("a name").to_string_lossy().into_owned()).collect()
    };
    let mut folders: Vec<String> = below("").into_iter().filter(|folder| folder != "sema").collect();
    folders.extend(below("sema").into_iter().map(|folder| format!("sema/{folder}")));
    folders.sort();
    folders
}

#[test]
fn files_that_call_each_other_are_few() {
    let mut wrong = String::new();
    for folder in folders() {
        let files = files(&folder);
        let set = largest_set(&calls(&files));
        let larger = LARGER.iter().find(|(known, _)| *known == folder).map(|(_, size)| *size);
        let is_as_said = larger.map_or(set.len() <= MOST, |size| set.len() == size && size > MOST);
        if !is_as_said {
            wrong += &format!("{folder}: {} of {} files call each other: {set:?}\n", set.len(), files.len());
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

/// What a method needs of the state it is a method of: those that need all of it are few.
#[test]
fn methods_of_the_objects_that_execute_are_counted() {
    let mut count = 0;
    for dialect in ["gcode", "klartext", "mtc200", "sinumerik", "turning"] {
        for code in files(&format!("sema/{dialect}")).values() {
            let mut inside = false;
            for line in code.lines() {
                if line.starts_with("impl") {
                    let of = line.rsplit(" for ").next().unwrap_or(line);
                    inside = ["Run<", "Channel<"].iter().any(|object| of.contains(object));
                }
                inside &= line != "}";
                let is_method = line.starts_with("    ") && !line.starts_with("     ") && line.contains("fn ");
                // A function that takes the whole object is a method of it.
                let takes = line.contains("fn ") && (line.contains("&mut Run<") || line.contains("&mut Channel<"));
                count += usize::from(inside && is_method || !inside && takes);
            }
        }
    }
    assert_eq!(count, METHODS, "methods of Run and Channel");
}

#[test]
fn sets_of_calls_are_found() {
    let file = |name: &str, code: &str| (name.to_owned(), code.to_owned());
    let files = BTreeMap::from([
        file("a.rs", "\nimpl Run<'_> {\n    fn one(&mut self) {\n        self.two(1);\n    }\n}\n"),
        file(
            "b.rs",
            "\nimpl Run<'_> {\n    pub(super) fn two(\n        &mut self,\n    ) {\n        self.three();\n    }\n}\n",
        ),
        file("c.rs", "\nimpl Run<'_> {\n    fn three<T>(&self) {\n        run.one();\n    }\n    fn of(x: u8) {}\n}\n"),
        file("d.rs", "\nimpl Run<'_> {\n    fn four(&self) {\n        self.three();\n    }\n}\n"),
    ]);
    let set: Vec<String> = largest_set(&calls(&files)).into_iter().collect();
    assert_eq!(set, ["a.rs", "b.rs", "c.rs"]);
}
