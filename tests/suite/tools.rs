//! What some checks need and a machine may lack: an interpreter, a peer, programs beside the repository.
//!
//! A check without its tool does nothing and passes. So that nobody takes that for a result, `tests/tools.rs` names all
//! such checks in one line at the end of a run. `PARTC_REQUIRE_ORACLE`, `PARTC_REQUIRE_PEER` and
//! `PARTC_REQUIRE_EDITORS` make them fail.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Folders with real programs that may lie beside the repository.
const CORPORA: [&str; 3] = ["corpus/heidenhain", "corpus/sinumerik", "corpus/rexroth"];

/// Is LinuxCNC's stand-alone interpreter installed?
pub fn rs274() -> bool {
    Command::new("rs274").arg("-h").stdout(Stdio::null()).stderr(Stdio::null()).status().is_ok()
}

/// A Python that has nc-gcode-interpreter.
pub fn peer() -> Option<String> {
    let python = std::env::var("NC_GCODE_INTERPRETER_PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let mut probe = Command::new(&python);
    probe.args(["-c", "import nc_gcode_interpreter as n; n.nc_to_rows"]).stdout(Stdio::null()).stderr(Stdio::null());
    probe.status().is_ok_and(|status| status.success()).then_some(python)
}

/// Does the program say its version?
pub fn runs(program: &str) -> bool {
    let mut probe = Command::new(program);
    probe.arg("--version").stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    probe.status().is_ok_and(|status| status.success())
}

/// Are the packages there that the tests of the extension for VS Code need?
pub fn extension_packages() -> bool {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("editors/vscode/node_modules/vscode-textmate").is_dir()
}

/// Material that lies in the folder `shared` beside the repository, or where `PARTC_SHARED` says.
pub fn beside_repository(path: &str) -> Option<PathBuf> {
    let beside = || Some(Path::new(env!("CARGO_MANIFEST_DIR")).parent()?.join("shared"));
    let found = std::env::var_os("PARTC_SHARED").map(PathBuf::from).or_else(beside)?.join(path);
    found.exists().then_some(found)
}

/// What is absent, with the check that needs it.
pub fn missing() -> Vec<String> {
    let mut missing = Vec::new();
    if !rs274() {
        missing.push("comparison with rs274 (Debian package linuxcnc-uspace)".to_owned());
    }
    if peer().is_none() {
        missing.push("comparison with nc-gcode-interpreter (PyPI, 0.2 or later)".to_owned());
    }
    if !runs("nvim") {
        missing.push("language server in Neovim (Debian package neovim)".to_owned());
    }
    if !runs("node") || !extension_packages() {
        missing.push("extension for VS Code (Node, `npm ci` in editors/vscode)".to_owned());
    }
    let absent = CORPORA.iter().filter(|path| beside_repository(path).is_none());
    missing.extend(absent.map(|path| format!("sweep over ../shared/{path}")));
    missing
}

/// Must this be there?
pub fn required(variable: &str) -> bool {
    std::env::var_os(variable).is_some()
}
