//! Runs LALRPOP over `grammar/`: one block grammar per dialect.

fn main() {
    // A grammar that is new; those that exist are watched one by one.
    println!("cargo:rerun-if-changed=grammar");
    if let Err(error) = lalrpop::Configuration::new()
        .set_in_dir("grammar")
        .set_out_dir(std::env::var_os("OUT_DIR").expect("cargo sets OUT_DIR for build scripts"))
        .emit_rerun_directives(true)
        .process()
    {
        eprintln!("grammar: {error}");
        std::process::exit(1);
    }
}
