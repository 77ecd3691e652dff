//! Runs LALRPOP over `grammar/`: one block grammar per dialect. Lists the rules of `src/lint/rules`, a file each.

use std::path::{Path, PathBuf};

fn main() {
    let out = PathBuf::from(std::env::var_os("OUT_DIR").expect("cargo sets OUT_DIR for build scripts"));
    let root = std::env::var_os("CARGO_MANIFEST_DIR").expect("cargo sets CARGO_MANIFEST_DIR for build scripts");
    // The parsers' panic messages hold the path they were included by: seen from `src/parser/<dialect>`, it is the same
    // in every folder, so that two builds give the same bytes.
    let seen_from_parser = out.strip_prefix(root).map_or(out.clone(), |inside| Path::new("../../..").join(inside));
    println!("cargo:rustc-env=PARTC_GRAMMARS={}", seen_from_parser.display());
    println!("cargo:rerun-if-changed=src/lint/rules");
    if let Err(error) = rules().and_then(|list| std::fs::write(out.join("rules.rs"), list)) {
        eprintln!("src/lint/rules: {error}");
        std::process::exit(1);
    }
    // A grammar that is new; those that exist are watched one by one.
    println!("cargo:rerun-if-changed=grammar");
    if let Err(error) =
        lalrpop::Configuration::new().set_in_dir("grammar").set_out_dir(out).emit_rerun_directives(true).process()
    {
        eprintln!("grammar: {error}");
        std::process::exit(1);
    }
}

/// The rules as an array, in order of their codes: a file says its own behind `rule! {`.
fn rules() -> std::io::Result<String> {
    let mut rules = Vec::new();
    for entry in std::fs::read_dir("src/lint/rules")? {
        let path = entry?.path();
        let text = std::fs::read_to_string(&path)?;
        let code = text.split_once("rule! { ").and_then(|(_, rest)| rest.split_whitespace().next());
        if let (Some(code), Some(module)) = (code, path.file_stem()) {
            rules.push((code.to_owned(), module.to_string_lossy().into_owned()));
        }
    }
    rules.sort();
    let list: String = rules.iter().map(|(_, module)| format!("    {module}::RULE,\n")).collect();
    Ok(format!("&[\n{list}]\n"))
}
