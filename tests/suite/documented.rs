//! The two shared languages and the targets are documented to the last field: unit, sense, reference, and who guarantees it.
//!
//! The lint `missing_docs` looks at what leaves the crate only, and these folders do not. So the sources are read here, as
//! rustfmt lays them out: one item, field or variant a line, its own indentation deeper than the block it is in.

use std::path::Path;

use super::layering::sources;

/// Folders that are documented throughout.
const FOLDERS: [&str; 2] = ["src/ir", "src/target"];

/// Fewest items that a scan of [`FOLDERS`] must come across; with fewer the sources were not read.
const ITEMS: usize = 1_000;

/// What a scan of one source comes to.
#[derive(Default)]
struct Scan {
    items: usize,
    /// Lines that want a `///` above them, as number and text.
    bare: Vec<(usize, String)>,
}

/// A block whose members are public with it, whatever they say of themselves.
#[derive(Clone, Copy, PartialEq)]
enum Block {
    Enum,
    /// The fields of a variant. Its doc counts for those that it names.
    Variant,
    Trait,
}

fn indent(line: &str) -> usize {
    line.len() - line.trim_start().len()
}

/// The name at the start of a line: of a field, a variant.
fn name(line: &str) -> &str {
    line.split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or_default()
}

/// The doc lines above a line, past its attributes.
fn doc<'a>(lines: &[&'a str]) -> Vec<&'a str> {
    let above = lines.iter().rev().map(|line| line.trim()).skip_while(|line| line.starts_with("#["));
    above.take_while(|line| line.starts_with("///")).collect()
}

/// The block that a line opens.
fn opened(line: &str) -> Option<Block> {
    let words = line.strip_prefix("pub").map_or(line, |rest| rest.split_once(' ').map_or("", |(_, rest)| rest));
    match words.split(' ').next()? {
        "enum" => Some(Block::Enum),
        "trait" => Some(Block::Trait),
        _ => None,
    }
}

/// Does the line begin an item that others see?
fn is_public(line: &str) -> bool {
    let rest = line.strip_prefix("pub ").or_else(|| Some(line.strip_prefix("pub(")?.split_once(' ')?.1));
    rest.is_some_and(|rest| !["use ", "mod "].iter().any(|keyword| rest.starts_with(keyword)))
}

fn scan(source: &str) -> Scan {
    let lines: Vec<&str> = source.split("#[cfg(test)]\nmod ").next().unwrap_or_default().lines().collect();
    let mut found = Scan::default();
    // Open blocks, with their indentation and the line that opens them.
    let mut blocks: Vec<(Block, usize, usize)> = Vec::new();
    for (at, whole) in lines.iter().enumerate() {
        let (line, column) = (whole.trim(), indent(whole));
        if blocks.last().is_some_and(|(_, outer, _)| column == *outer && line.starts_with('}')) {
            blocks.pop();
            continue;
        }
        let inside = blocks.last().copied().filter(|(_, outer, _)| column == outer + 4);
        let begins = line.starts_with(|c: char| c.is_alphabetic());
        let wants = match inside {
            Some((Block::Enum, ..)) => begins,
            Some((Block::Variant, ..)) => begins && line[name(line).len()..].starts_with(':'),
            Some((Block::Trait, ..)) => ["fn ", "type ", "const "].iter().any(|item| line.starts_with(item)),
            None => is_public(line),
        };
        if wants {
            found.items += 1;
            let quotes = |docs: Vec<&str>, field: &str| docs.iter().any(|line| line.contains(&format!("`{field}`")));
            let own = doc(&lines[..at]);
            let has = match inside {
                Some((Block::Variant, _, opens)) => !own.is_empty() || quotes(doc(&lines[..opens]), name(line)),
                Some((Block::Enum | Block::Trait, ..)) | None => !own.is_empty(),
            };
            if !has {
                found.bare.push((at + 1, line.to_owned()));
            }
            // The fields of a variant on one line: its doc names them.
            if let (Some((Block::Enum, ..)), Some((_, fields))) = (inside, line.split_once(" { ")) {
                for field in fields.split(", ").filter_map(|field| Some(field.split_once(": ")?.0)) {
                    found.items += 1;
                    if !quotes(doc(&lines[..at]), field) {
                        found.bare.push((at + 1, format!("`{field}` of {line}")));
                    }
                }
            }
        }
        if line.ends_with('{') {
            match inside {
                Some((Block::Enum, ..)) if begins => blocks.push((Block::Variant, column, at)),
                _ => blocks.extend(opened(line).map(|block| (block, column, at))),
            }
        }
    }
    found
}

#[test]
fn every_field_of_the_shared_languages_is_documented() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let (mut items, mut bare) = (0, Vec::new());
    for (file, text) in
        FOLDERS.iter().flat_map(|folder| sources(&root.join(folder))).filter(|(file, _)| !file.ends_with("tests.rs"))
    {
        assert!(text.starts_with("//!"), "{file} does not say what it is");
        let found = scan(&text);
        items += found.items;
        bare.extend(found.bare.iter().map(|(line, text)| format!("{file}:{line}: {text}")));
    }
    bare.sort();
    assert!(bare.is_empty(), "without a doc comment: {}\n{}", bare.len(), bare.join("\n"));
    assert!(items >= ITEMS, "{items}");
}

#[test]
fn what_has_no_doc_is_found() {
    const NONE: [usize; 0] = [];
    let bare = |source| scan(source).bare.into_iter().map(|(line, _)| line).collect::<Vec<_>>();
    assert_eq!(
        bare("pub use a::B;\npub mod c;\n#[derive(Debug)]\npub struct A {\n    pub b: f64,\n    c: f64,\n}\n"),
        [4, 5]
    );
    assert_eq!(bare("/// A.\n#[derive(Debug)]\npub struct A {\n    /// B.\n    pub b: f64,\n}\n"), NONE);
    assert_eq!(
        bare("/// A.\npub enum A {\n    B,\n    /// C.\n    C(f64),\n    D {\n        e: f64,\n    },\n}\n"),
        [3, 6, 7]
    );
    assert_eq!(bare("/// A.\nenum A {\n    /// At `b`.\n    B { b: f64, c: f64 },\n}\n"), [4]);
    assert_eq!(bare("/// A.\nenum A {\n    /// At `b`.\n    B {\n        b: f64,\n        c: f64,\n    },\n}\n"), [6]);
    assert_eq!(
        bare(
            "/// A.\npub trait A {\n    type B;\n    fn c();\n    /// D.\n    fn d() {\n        let e = 1;\n    }\n}\n"
        ),
        [3, 4]
    );
    assert_eq!(bare("impl A {\n    pub(crate) fn b() {}\n    fn c() {}\n    pub const D: f64 = 1.0;\n}\n"), [2, 4]);
    assert_eq!(bare("#[cfg(test)]\nmod tests {\n    pub fn a() {}\n}\n"), NONE);
}
