//! What partc is built from: licences and sources as deny.toml allows them, the notice that binaries come with, the toolchain.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

/// Does `allowed` hold for one side of each `OR` and both sides of each `AND`? `/` is an old `OR`.
fn holds(expression: &str, allowed: &dyn Fn(&str) -> bool) -> bool {
    let spaced = expression.replace('/', " OR ").replace('(', " ( ").replace(')', " ) ");
    let words: Vec<&str> = spaced.split_whitespace().collect();
    let mut at = 0;
    let held = either(&words, &mut at, allowed);
    held && at == words.len()
}

fn either(words: &[&str], at: &mut usize, allowed: &dyn Fn(&str) -> bool) -> bool {
    let mut held = both(words, at, allowed);
    while words.get(*at) == Some(&"OR") {
        *at += 1;
        held |= both(words, at, allowed);
    }
    held
}

fn both(words: &[&str], at: &mut usize, allowed: &dyn Fn(&str) -> bool) -> bool {
    let mut held = one(words, at, allowed);
    while words.get(*at) == Some(&"AND") {
        *at += 1;
        held &= one(words, at, allowed);
    }
    held
}

fn one(words: &[&str], at: &mut usize, allowed: &dyn Fn(&str) -> bool) -> bool {
    let Some(word) = words.get(*at) else { return false };
    *at += 1;
    if *word == "(" {
        let held = either(words, at, allowed);
        *at += 1;
        return held;
    }
    if words.get(*at) == Some(&"WITH") {
        let name = format!("{word} WITH {}", words.get(*at + 1).unwrap_or(&""));
        *at += 2;
        return allowed(&name);
    }
    allowed(word)
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// What cargo knows of the packages of the shipped binary, those of all platforms: it fetches what no build here has needed yet.
fn metadata() -> Value {
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned());
    let ran = Command::new(cargo)
        .args(["metadata", "--locked", "--format-version", "1", "--features", "columns", "--manifest-path"])
        .arg(root().join("Cargo.toml"))
        .output()
        .expect("cargo");
    assert!(ran.status.success(), "{}", String::from_utf8_lossy(&ran.stderr));
    serde_json::from_slice(&ran.stdout).expect("the packages")
}

#[test]
fn licences_and_sources_are_allowed() {
    let rules = fs::read_to_string(root().join("deny.toml")).expect("deny.toml");
    let rules: toml::Table = rules.parse().expect("the rules");
    let list = rules["licenses"]["allow"].as_array().expect("a list");
    let allowed = |name: &str| list.iter().any(|known| known.as_str() == Some(name));
    let tree = metadata();
    let packages = tree["packages"].as_array().expect("packages");
    assert!(packages.len() > 100, "{}", packages.len());
    for package in packages {
        let name = &package["name"];
        let licence = package["license"].as_str().unwrap_or_default();
        assert!(holds(licence, &allowed), "{name}: the licence {licence:?} is not allowed");
        // Its own packages have no source.
        let source = package["source"].as_str();
        assert!(source.is_none_or(|source| source.starts_with("registry+")), "{name}: {source:?}");
    }
}

/// The packages whose code is in the command, on whatever system: all that it needs when it runs.
fn in_the_command(tree: &Value) -> Vec<&Value> {
    let packages = tree["packages"].as_array().expect("packages");
    let nodes = tree["resolve"]["nodes"].as_array().expect("nodes");
    let by_id = |list: &'static str, id: &str| {
        let list = if list == "nodes" { nodes } else { packages };
        list.iter().find(|entry| entry["id"] == id).expect("an entry")
    };
    let is_macro = |package: &Value| {
        let kinds = package["targets"].as_array().into_iter().flatten().flat_map(|target| target["kind"].as_array());
        kinds.flatten().any(|kind| kind == "proc-macro")
    };
    let own = tree["resolve"]["root"].as_str().expect("its own package");
    let (mut open, mut seen) = (vec![own], BTreeSet::from([own]));
    while let Some(id) = open.pop() {
        for needed in by_id("nodes", id)["deps"].as_array().expect("dependencies") {
            let runs = needed["dep_kinds"].as_array().into_iter().flatten().any(|kind| kind["kind"].is_null());
            let id = needed["pkg"].as_str().expect("a package");
            if runs && !is_macro(by_id("packages", id)) && seen.insert(id) {
                open.push(id);
            }
        }
    }
    seen.remove(own);
    let mut found: Vec<&Value> = seen.into_iter().map(|id| by_id("packages", id)).collect();
    found.sort_by_key(|package| (package["name"].as_str(), package["version"].as_str()));
    found
}

/// The texts of licences that a package comes with.
fn licence_texts(package: &Value) -> Vec<String> {
    let manifest = Path::new(package["manifest_path"].as_str().expect("a path"));
    let entries = fs::read_dir(manifest.parent().expect("a folder")).expect("a package");
    let mut files: Vec<_> = entries.flatten().map(|entry| entry.path()).filter(|path| path.is_file()).collect();
    files.sort();
    let is_licence =
        |name: &str| ["LICENSE", "LICENCE", "COPYING", "COPYRIGHT", "NOTICE"].iter().any(|kind| name.starts_with(kind));
    files.retain(|path| path.file_name().is_some_and(|name| is_licence(&name.to_string_lossy().to_uppercase())));
    let texts = files.iter().filter_map(|path| fs::read_to_string(path).ok());
    texts
        .map(|text| {
            let lines: Vec<&str> = text.lines().map(str::trim_end).collect();
            lines.join("\n").trim_matches('\n').to_owned()
        })
        .collect()
}

/// What has to come with a binary: whose code is in it, under which licence, and the texts of the licences.
fn notice() -> String {
    let tree = metadata();
    let mut texts: Vec<String> = Vec::new();
    let mut made = "What others wrote of the command partc\n======================================\n\n\
        Made from the metadata of Cargo: INSTA_UPDATE=always cargo test --test suite supply\n\
        Binaries come with this file. The number behind a package is that of its licence texts below.\n\n"
        .to_owned();
    for package in in_the_command(&tree) {
        let text = |key: &str| package[key].as_str().unwrap_or_default().to_owned();
        let mut numbers = Vec::new();
        for found in licence_texts(package) {
            let at = texts.iter().position(|known| *known == found).unwrap_or_else(|| {
                texts.push(found);
                texts.len() - 1
            });
            numbers.push(format!("[{}]", at + 1));
        }
        let authors: Vec<&str> =
            package["authors"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
        made += &format!("{} {}: {} {}\n", text("name"), text("version"), text("license"), numbers.join(" "));
        for line in [text("repository"), authors.join(", ")].iter().filter(|line| !line.is_empty()) {
            made += &format!("    {line}\n");
        }
    }
    for (n, text) in texts.iter().enumerate() {
        made += &format!("\n[{}]\n{}\n\n{text}\n", n + 1, "-".repeat(80));
    }
    let page = fs::read_to_string(root().join("web/THIRD-PARTY.txt")).expect("the notice of the page");
    made + &format!("\n{}\n\n{page}", "=".repeat(80))
}

#[test]
fn the_notice_of_others_is_current() {
    let path = root().join("THIRD-PARTY.txt");
    let made = notice();
    if std::env::var("INSTA_UPDATE").is_ok_and(|update| update == "always") {
        fs::write(&path, &made).expect("the notice");
    }
    let found = fs::read_to_string(&path).unwrap_or_default();
    assert!(found == made, "THIRD-PARTY.txt is not current: INSTA_UPDATE=always cargo test --test suite supply");
    for known in ["\nclap ", "\nmemchr ", "\nlogos ", "\nserde_json "] {
        assert!(made.contains(known), "{known:?}");
    }
    // Nothing of what only builds or tests.
    for other in ["\nlalrpop ", "\ninsta ", "\nproptest ", "\nserde_derive "] {
        assert!(!made.contains(other), "{other:?}");
    }
}

/// The promised toolchain is one that builds. CI, which sets `PARTC_REQUIRE_RUST_VERSION`, says where an older one is promised
/// than it tries; a new toolchain on its machine is no fault of the project.
#[test]
fn the_promised_toolchain_is_the_one_that_builds() {
    let manifest: toml::Table =
        fs::read_to_string(root().join("Cargo.toml")).expect("a manifest").parse().expect("TOML");
    let promised = version(manifest["package"]["rust-version"].as_str().expect("a version"));
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
    let ran = Command::new(rustc).arg("--version").output().expect("rustc");
    let said = String::from_utf8_lossy(&ran.stdout).into_owned();
    let builds = version(said.split_whitespace().nth(1).expect("a version"));
    assert!(promised <= builds, "{promised:?} is promised, and {builds:?} builds");
    if promised < builds && std::env::var_os("PARTC_REQUIRE_RUST_VERSION").is_some() {
        println!("note: rust-version in Cargo.toml is {promised:?}, and this run tries {builds:?} alone");
    }
}

/// Major and minor number.
fn version(text: &str) -> (u32, u32) {
    let mut numbers = text.split(['.', '-']).filter_map(|part| part.parse().ok());
    (numbers.next().unwrap_or(0), numbers.next().unwrap_or(0))
}

#[test]
fn expressions_of_licences_are_read() {
    let allowed = |name: &str| ["MIT", "Zlib", "Apache-2.0 WITH LLVM-exception"].contains(&name);
    for good in ["MIT", "GPL-3.0 OR MIT", "GPL-3.0/MIT", "(GPL-3.0 OR MIT) AND Zlib", "Apache-2.0 WITH LLVM-exception"]
    {
        assert!(holds(good, &allowed), "{good}");
    }
    for bad in ["", "GPL-3.0", "MIT AND GPL-3.0", "Apache-2.0", "(MIT", "MIT Zlib"] {
        assert!(!holds(bad, &allowed), "{bad}");
    }
}

/// What `ci/release` packs has the name under which `cargo binstall` looks for it.
#[test]
fn packed_files_are_found_by_their_name() {
    let script = std::fs::read_to_string(root().join("ci/release")).expect("ci/release");
    assert!(script.contains("name=\"partc-$version-$target\"") && script.contains("$name.tar.gz"));
    let metadata = metadata();
    let package = metadata["packages"].as_array().and_then(|all| all.iter().find(|package| package["name"] == "partc"));
    let binstall = &package.expect("partc")["metadata"]["binstall"];
    let url = binstall["pkg-url"].as_str().expect("an address");
    assert!(url.ends_with("/{ name }-{ version }-{ target }.tar.gz"), "{url}");
    assert_eq!(binstall["bin-dir"], "{ name }-{ version }-{ target }/{ bin }");
}
