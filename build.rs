//! Runs LALRPOP over `grammar/`: one block grammar per dialect.

use std::path::{Path, PathBuf};

fn main() {
    let out = PathBuf::from(std::env::var_os("OUT_DIR").expect("cargo sets OUT_DIR for build scripts"));
    let root = std::env::var_os("CARGO_MANIFEST_DIR").expect("cargo sets CARGO_MANIFEST_DIR for build scripts");
    // The parsers' panic messages hold the path they were included by: seen from `src/parser/<dialect>`, it is the same
    // in every folder, so that two builds give the same bytes.
    let seen_from_parser = out.strip_prefix(root).map_or(out.clone(), |inside| Path::new("../../..").join(inside));
    println!("cargo:rustc-env=PARTC_GRAMMARS={}", seen_from_parser.display());
    // A grammar that is new; those that exist are watched one by one.
    println!("cargo:rerun-if-changed=grammar");
    if let Err(error) =
        lalrpop::Configuration::new().set_in_dir("grammar").set_out_dir(out).emit_rerun_directives(true).process()
    {
        eprintln!("grammar: {error}");
        std::process::exit(1);
    }
}
