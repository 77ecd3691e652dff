//! Any text as a tool table and as a configuration.
#![no_main]

use libfuzzer_sys::fuzz_target;
use partc::machine::{config, tools, tree};

fuzz_target!(|text: &str| {
    let _ = tools::read_table(text);
    if let Ok(tree) = tree::parse(text, "partc.toml") {
        let _ = config::read(&tree);
    }
});
