//! Which file of `src` imports which, by its `use` declarations and by paths in its code.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// Files, each with those that it names something of; both below `src`.
pub type Imports = BTreeMap<String, BTreeSet<String>>;

type Names = Vec<String>;

/// The imports of all files but those of tests. `files` are paths and texts below `root`. A name that a file only hands on
/// (`pub use`) counts as a use of the file that has it. In a module written inside a file, `super` counts from the file.
pub fn imports(root: &Path, files: &[(String, String)]) -> Imports {
    let mut modules: BTreeMap<Names, (String, String)> = BTreeMap::new();
    for (file, text) in files {
        let inside = Path::new(file).strip_prefix(root).expect("a file of the folder");
        let inside = inside.to_string_lossy().replace('\\', "/");
        if inside.contains("/tests/") || inside.ends_with("/tests.rs") || inside == "main.rs" {
            continue;
        }
        let mut module: Names = inside.trim_end_matches(".rs").split('/').map(str::to_owned).collect();
        if module.last().is_some_and(|last| last == "mod" || last == "lib") {
            module.pop();
        }
        modules.insert(module, (inside, code_of(text)));
    }
    let mut handed_on: BTreeMap<Names, BTreeMap<String, Names>> = BTreeMap::new();
    for (here, (_, code)) in &modules {
        let public = declarations(code).filter_map(|(_, used)| used.filter(|(is_public, _)| *is_public));
        let paths = public.flat_map(|(_, tree)| paths_of(tree));
        let known = paths.filter_map(|path| Some((path.last()?.clone(), absolute(&path, here, &modules)?)));
        handed_on.insert(here.clone(), known.collect());
    }
    let mut imports = Imports::new();
    for (here, (file, code)) in &modules {
        let used = declarations(code)
            .flat_map(|(code, used)| paths_in(code).chain(used.into_iter().flat_map(|(_, tree)| paths_of(tree))));
        let targets = used.filter_map(|path| {
            let mut path = absolute(&path, here, &modules)?;
            for _ in 0..8 {
                let (module, rest) = split(&path, &modules);
                let next = rest.first().and_then(|name| Some((handed_on.get(module)?.get(name)?, &rest[1..])));
                let Some((from, rest)) = next else { break };
                path = from.iter().chain(rest).cloned().collect();
            }
            Some(modules[split(&path, &modules).0].0.clone())
        });
        imports.insert(file.clone(), targets.filter(|target| target != file).collect());
    }
    imports
}

/// The code without comments, and without what is built for tests only; by the layout of rustfmt.
pub fn code_of(text: &str) -> String {
    let mut code = String::new();
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        if line.trim_start() != "#[cfg(test)]" {
            code += line.split("//").next().unwrap_or_default();
            code.push('\n');
            continue;
        }
        let indent = line.len() - line.trim_start().len();
        // An item ends on its line, or with the bracket below its start.
        let mut ends = lines.next().is_none_or(|line| line.ends_with([';', ',', '}']));
        while !ends {
            let Some(line) = lines.next() else { break };
            ends = line.len() - line.trim_start().len() == indent && line.trim_start().starts_with(['}', ')', ']']);
        }
    }
    code
}

/// The code in front of each `use` declaration and behind the last one, and the tree of that; true for one that is public.
fn declarations(code: &str) -> impl Iterator<Item = (&str, Option<(bool, &str)>)> {
    code.split(';').map(|part| {
        let at = part.rfind("use ").filter(|at| part[..*at].chars().next_back().is_none_or(char::is_whitespace));
        let Some(at) = at else { return (part, None) };
        let line = part[..at].lines().next_back().unwrap_or_default();
        (&part[..at], Some((line.trim_start().starts_with("pub"), &part[at + 4..])))
    })
}

/// Every path of a tree: `a::{b, c::D}` has two.
fn paths_of(tree: &str) -> Vec<Names> {
    let Some((front, inner)) = tree.split_once('{') else {
        let path = tree.split(" as ").next().unwrap_or_default();
        return vec![path.split("::").map(|name| name.trim().to_owned()).filter(|name| !name.is_empty()).collect()];
    };
    let inner = &inner[..inner.rfind('}').unwrap_or(inner.len())];
    let mut depth = 0;
    let parts = inner.split(|c: char| {
        depth += i32::from(c == '{') - i32::from(c == '}');
        c == ',' && depth == 0
    });
    let front: Vec<Names> = paths_of(front);
    let parts = parts.filter(|part| !part.trim().is_empty()).flat_map(paths_of);
    parts.map(|path| [front[0].clone(), path].concat()).collect()
}

/// Paths that stand in the code, such as `super::page::MARK`.
fn paths_in(code: &str) -> impl Iterator<Item = Names> + '_ {
    let words = code.split(|c: char| !(c.is_alphanumeric() || c == '_' || c == ':'));
    words.filter(|word| word.contains("::")).map(|word| {
        let path = word.trim_start_matches(':').split("::");
        path.map(str::to_owned).filter(|name| !name.is_empty() && !name.contains(':')).collect()
    })
}

/// A path from the root of the crate; `None` for what is no path of ours.
fn absolute(path: &[String], here: &[String], modules: &BTreeMap<Names, (String, String)>) -> Option<Names> {
    let up = path.iter().take_while(|name| *name == "super").count();
    let first = path.first()?;
    let (from, rest) = match first.as_str() {
        "crate" => (&[][..], &path[1..]),
        "self" => (here, &path[1..]),
        "super" => (&here[..here.len().checked_sub(up)?], &path[up..]),
        _ if modules.contains_key(&[here, std::slice::from_ref(first)].concat()) => (here, path),
        _ => return None,
    };
    Some([from, rest].concat())
}

/// The module that a path leads to, and what is left of the path.
fn split<'p>(path: &'p [String], modules: &BTreeMap<Names, (String, String)>) -> (&'p [String], &'p [String]) {
    let at = (0..=path.len()).rev().find(|at| modules.contains_key(&path[..*at])).unwrap_or(0);
    path.split_at(at)
}
