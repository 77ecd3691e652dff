//! Folders use only what the architecture allows them (ARCHITECTURE.md, Allowed dependencies).

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use super::imports::{Imports, imports};

/// Folder under `src`, and the folders its `use crate::…` may name besides itself.
const ALLOWED: &[(&str, &[&str])] = &[
    ("text", &[]),
    ("geo", &[]),
    ("target", &["geo"]),
    ("standard", &[]),
    ("diag", &["text"]),
    ("machine", &["text", "diag", "standard", "target"]),
    ("ir", &["text", "geo", "machine", "diag", "standard"]),
    ("lexer", &["text", "diag", "machine"]),
    ("parser", &["lexer", "text", "diag", "machine"]),
    ("sema", &["parser", "lexer", "machine", "ir", "geo", "diag", "text", "standard", "read"]),
    ("lower", &["ir", "geo", "machine", "diag", "text"]),
    ("emit", &["ir", "machine", "target", "diag", "text", "geo"]),
    ("columns", &["emit", "ir", "machine", "diag", "text", "geo"]),
    ("read", &[]),
    ("validate", &["read", "ir", "machine", "geo"]),
    ("compare", &["read", "sema", "ir", "machine", "geo", "text"]),
    ("lint", &["sema", "ir", "geo", "machine", "diag", "text"]),
    ("dialect", &["lexer", "parser", "sema", "ir", "machine", "diag", "text"]),
    ("page_data", &["diag", "dialect", "driver", "emit", "geo", "ir", "machine", "block_ends", "target", "text"]),
    ("lsp", &["diag", "dialect", "driver", "ir", "lint", "machine", "block_ends", "sema", "text"]),
    (
        "cli",
        &[
            "columns",
            "compare",
            "diag",
            "dialect",
            "driver",
            "emit",
            "page_data",
            "ir",
            "lint",
            "lsp",
            "machine",
            "target",
            "text",
            "validate",
        ],
    ),
];

/// The reader proves what the printer does: it takes nothing from it, nor from what it prints with.
#[test]
fn the_reader_of_outputs_stands_alone() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    for (file, text) in sources(&root.join("read")) {
        let code = text.split("#[cfg(test)]").next().unwrap_or_default();
        assert!(!code.contains("crate::"), "{file} uses another folder");
    }
    for (file, text) in sources(&root.join("validate")).into_iter().filter(|(file, _)| !file.contains("tests")) {
        assert!(!text.contains("crate::emit") && !text.contains("crate::target"), "{file} uses the printer");
    }
}

/// Names of dialects, which nothing behind the contour items may know.
const DIALECTS: &[&str] = &["klartext", "sinumerik", "heidenhain", "siemens", "manualplus", "mtc200", "indramat"];

/// The sources below a folder, with their names.
pub fn sources(folder: &Path) -> Vec<(String, String)> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder of sources") {
        let path = entry.expect("a readable entry").path();
        if path.is_dir() {
            found.extend(sources(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let text = fs::read_to_string(&path).expect("a readable source");
            found.push((path.display().to_string(), text));
        }
    }
    found
}

#[test]
fn folders_use_what_they_may() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let allowed: BTreeMap<&str, &[&str]> = ALLOWED.iter().copied().collect();
    let mut wrong = Vec::new();
    for entry in fs::read_dir(&root).expect("src") {
        let path = entry.expect("a readable entry").path();
        if !path.is_dir() {
            continue;
        }
        let folder = path.file_name().expect("a name").to_string_lossy().into_owned();
        let may = allowed.get(folder.as_str()).unwrap_or_else(|| panic!("src/{folder} is not in the table"));
        // Tests may use what they like.
        for (file, text) in
            sources(&path).into_iter().filter(|(file, _)| !file.contains("/tests/") && !file.ends_with("/tests.rs"))
        {
            let code = text.split("#[cfg(test)]").next().unwrap_or_default();
            for part in code.split("crate::").skip(1) {
                let name: String = part.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
                let folder_of_ours = root.join(&name).exists() || root.join(format!("{name}.rs")).exists();
                if folder_of_ours && name != folder && !may.contains(&name.as_str()) {
                    wrong.push(format!("{file} uses {name}"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// What a folder takes from the root of the crate would go round the table: the catalogue gets the codes of rules so, and
/// nothing else goes this way.
#[test]
fn the_root_hands_down_the_codes_of_rules_only() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let lib = fs::read_to_string(root.join("lib.rs")).expect("lib.rs");
    let own: Vec<&str> =
        lib.lines().filter(|line| line.starts_with("fn ") || line.starts_with("pub(crate) ")).collect();
    assert_eq!(own, ["fn codes_of_rules() -> impl Iterator<Item = &'static diag::Code> {"]);
    let users = sources(&root).into_iter().filter(|(_, text)| text.contains("crate::codes_of_rules"));
    let users: Vec<String> = users.map(|(file, _)| file.replace('\\', "/")).collect();
    assert!(matches!(&users[..], [file] if file.ends_with("src/diag/codes/mod.rs")), "{users:?}");
}

#[test]
fn nothing_behind_the_contour_knows_a_dialect() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    // A receiver may be of the same make.
    for folder in ["lower", "emit", "geo", "ir", "sema/run", "sema/value"] {
        for (file, text) in sources(&root.join(folder)) {
            let lower = text.to_lowercase();
            for dialect in DIALECTS {
                let named = lower.lines().find(|line| line.contains(dialect) && !line.trim_start().starts_with("//"));
                assert!(named.is_none(), "{file} names {dialect}: {named:?}");
            }
        }
    }
}

/// What a control decides comes as data, with the key that answers it: no pass behind the dialects names one.
#[test]
fn no_key_of_a_dialect_is_named_behind_the_contour() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    for folder in ["lower", "emit", "geo"] {
        for (file, text) in sources(&root.join(folder)) {
            let code = text.split("#[cfg(test)]").next().unwrap_or_default();
            for named in ["\"control\"", "\"cycles\"", "`[control]", "`[cycles]"] {
                let line = code.lines().find(|line| line.contains(named) && !line.trim_start().starts_with("//"));
                assert!(line.is_none(), "{file}: {line:?}");
            }
        }
    }
}

/// What is said stands in the catalogue, a function each: behind the dialects nobody makes a finding of a code and a text.
#[test]
fn the_catalogue_words_what_is_found_behind_the_contour() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let barred = ["Fault::new", "Asking::new", "Diagnostic::new", ".help(\"", ".help(format!"];
    for folder in ["lower", "emit"] {
        let mut raises = 0;
        for (file, text) in sources(&root.join(folder)) {
            let code = text.split("#[cfg(test)]").next().unwrap_or_default();
            raises += code.matches("codes::").count();
            let found = barred.iter().find(|barred| code.contains(**barred));
            assert!(found.is_none(), "{file}: {found:?}");
        }
        assert!(raises > 50, "{folder} was not read");
    }
}

/// Files that import each other in a circle, if any are meant to.
const CIRCLES: &[&str] = &[];

/// Which file of `src` imports which.
fn imports_of_src() -> Imports {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let imports = imports(&root, &sources(&root));
    assert!(imports.len() > 700 && imports.values().any(|used| used.len() > 20), "the files were not read");
    imports
}

/// A `mod.rs` holds what all files of its folder share, and knows all of them: it is no part of a circle.
#[test]
fn files_of_a_folder_import_each_other_in_one_direction() {
    let mut imports = imports_of_src();
    let is_whole = |file: &str| file == "lib.rs" || file.ends_with("mod.rs");
    imports.retain(|file, _| !is_whole(file));
    imports.values_mut().for_each(|used| used.retain(|file| !is_whole(file)));
    let circles: Vec<&String> = imports.keys().filter(|file| reaches(&imports, file, file)).collect();
    assert_eq!(circles, CIRCLES, "files that import each other in a circle");
}

/// Modules of a dialect, and which siblings the files of each use. The `mod.rs` of the dialect does not count.
fn uses_between_siblings(imports: &Imports, dialect: &str) -> Imports {
    let folder = format!("sema/{dialect}/");
    let module = |file: &String| {
        let name = file.strip_prefix(&folder)?.split(['/', '.']).next()?;
        (name != "mod").then(|| name.to_owned())
    };
    let mut uses = Imports::new();
    for (file, used) in imports {
        let Some(own) = module(file) else { continue };
        let siblings = used.iter().filter_map(module).filter(|sibling| *sibling != own);
        uses.entry(own.clone()).or_default().extend(siblings);
    }
    uses
}

fn reaches(uses: &Imports, from: &str, to: &str) -> bool {
    let mut seen = BTreeSet::new();
    let mut open = vec![from];
    while let Some(module) = open.pop() {
        for next in &uses[module] {
            if next == to {
                return true;
            }
            if seen.insert(next.as_str()) {
                open.push(next);
            }
        }
    }
    false
}

#[test]
fn modules_of_a_dialect_use_each_other_in_one_direction() {
    let imports = imports_of_src();
    let mut circles = Vec::new();
    for dialect in ["klartext", "mtc200", "sinumerik", "turning"] {
        let uses = uses_between_siblings(&imports, dialect);
        assert!(uses.len() > 10 && uses.values().any(|used| used.len() > 3), "{dialect}: the files were not read");
        circles.extend(uses.keys().filter(|m| reaches(&uses, m, m)).map(|module| format!("{dialect}/{module}")));
    }
    assert_eq!(circles, CIRCLES, "modules that use each other in a circle");
}

/// Files of cycles that still report, and why.
const REPORTING: &[(&str, &str)] = &[];

/// Cycles are rows and plans: a plan returns what is wrong and what is to be carried out, and one place of the dialect does the rest.
#[test]
fn cycles_plan_and_do_not_report() {
    let sema = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/sema");
    let barred = ["Run<", "Channel<", "&mut Core", ".report", ".fail(", ".fail_help(", "format!(", "Diagnostic"];
    for dialect in ["klartext", "sinumerik", "turning"] {
        let cycles = sema.join(dialect).join("cycles");
        let mut rows = 0;
        for (file, text) in sources(&cycles) {
            let inside =
                Path::new(&file).strip_prefix(&sema).expect("a file of sema").to_string_lossy().replace('\\', "/");
            let code = text.split("#[cfg(test)]").next().unwrap_or_default();
            rows += code.matches("ROWS").count();
            if REPORTING.iter().all(|(known, _)| *known != inside) {
                let found = barred.iter().find(|barred| code.contains(**barred));
                assert!(found.is_none(), "{inside}: {found:?}");
            }
        }
        assert!(rows > 5, "{dialect}: the cycles were not read");
    }
}

/// What is wrong is worded in the catalogue of `diag::codes`: languages raise its faults and make none.
#[test]
fn languages_word_no_finding() {
    let sema = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/sema");
    for (file, text) in sources(&sema).into_iter().filter(|(file, _)| !file.ends_with("tests.rs")) {
        let code = text.split("#[cfg(test)]").next().unwrap_or_default();
        let found = ["Diagnostic::new", "Fault::new", "Problem::new"].into_iter().find(|made| code.contains(made));
        assert!(found.is_none(), "{file}: {found:?}");
    }
}

/// What an object of a language uses of another one it names: nothing is reached through it.
#[test]
fn nothing_of_a_language_is_reached_through_another() {
    let sema = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/sema");
    for (file, text) in sources(&sema) {
        assert!(!text.contains("Deref for") && !text.contains("DerefMut for"), "{file}");
    }
}

#[test]
fn no_unsafe_code() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let lib = fs::read_to_string(root.join("src/lib.rs")).expect("lib.rs");
    let main = fs::read_to_string(root.join("src/main.rs")).expect("main.rs");
    assert!(lib.contains("#![forbid(unsafe_code)]") && main.contains("#![forbid(unsafe_code)]"));
}
