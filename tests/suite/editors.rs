//! Editors: Neovim as a client that others wrote, and the extension for VS Code: its grammars, its commands and what it names.
//! Skipped where the editor, Node or its packages are absent; `PARTC_REQUIRE_EDITORS=1` makes that a failure.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use serde_json::Value;

use super::cli_run::Folder;
use super::tools;

/// Longer than anything here takes on a busy machine.
const LONGEST: Duration = Duration::from_secs(120);

fn extension() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("editors/vscode")
}

fn json(path: &str) -> Value {
    serde_json::from_str(&fs::read_to_string(extension().join(path)).expect(path)).expect(path)
}

/// Skips a test that lacks something, unless it has to be there.
fn or_skipped(is_there: bool, what: &str) -> bool {
    assert!(is_there || !tools::required("PARTC_REQUIRE_EDITORS"), "{what} is not there");
    is_there
}

fn finished(mut child: Child) -> Output {
    let end = Instant::now() + LONGEST;
    while child.try_wait().expect("a process").is_none() {
        if Instant::now() > end {
            child.kill().expect("our own process");
            break;
        }
        thread::sleep(Duration::from_millis(20));
    }
    child.wait_with_output().expect("its output")
}

#[test]
fn neovim_shows_findings_hover_and_hints() {
    if !or_skipped(tools::runs("nvim"), "Neovim") {
        return;
    }
    let program = "0 BEGIN PGM T MM\n1 L X+10 Y+0 Z+2 R0 FMAX\n2 L X+50 F200 Q\n3 L Y+8\n4 END PGM T MM\n";
    let folder = Folder::new("neovim").with(&[("T.H", program)]);
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/suite/neovim.lua");
    let child = Command::new("nvim")
        .args(["--headless", "-u", "NONE", "-i", "NONE", "-n", "-c"])
        .arg(format!("luafile {}", script.display()))
        .current_dir(&folder.0)
        .env("PARTC", env!("CARGO_BIN_EXE_partc"))
        .env("PROGRAM", folder.0.join("T.H"))
        // What the editor keeps of its own stays in the folder of the test.
        .env("XDG_STATE_HOME", &folder.0)
        .env("XDG_CACHE_HOME", &folder.0)
        .env("XDG_DATA_HOME", &folder.0)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("Neovim");
    let out = finished(child);
    let said = String::from_utf8_lossy(&out.stdout).into_owned();
    assert!(out.status.success(), "{said}\n{}", String::from_utf8_lossy(&out.stderr));
    let lines: Vec<&str> = said.lines().collect();
    let has = |begin: &str| lines.iter().any(|line| line.starts_with(begin));
    assert!(has("finding P1003 ") && lines[0].ends_with("line 3 partc"), "{said}");
    assert!(has("hover ") && !has("hover nothing"), "{said}");
    assert!(has("hint line 2") && lines.last() == Some(&"mended"), "{said}");
}

#[test]
fn grammars_and_commands_of_the_extension() {
    if !or_skipped(tools::runs("node") && tools::extension_packages(), "Node with the packages of editors/vscode") {
        return;
    }
    let child = Command::new("node")
        .args(["--test", "test/grammar.test.mjs", "test/extension.test.mjs"])
        .env("PARTC", env!("CARGO_BIN_EXE_partc"))
        .current_dir(extension())
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("Node");
    let out = finished(child);
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stdout));
}

/// What the extension names is there: languages as the server knows them, files, settings that its code reads, commands.
#[test]
fn the_extension_names_what_is_there() {
    let meta = json("package.json");
    let list = |pointer: &str| meta.pointer(pointer).and_then(Value::as_array).cloned().unwrap_or_default();
    let dialects: Vec<&str> = partc::internals::dialect::ALL.iter().map(|dialect| dialect.id).collect();
    let languages = list("/contributes/languages");
    assert_eq!(languages.len(), 4);
    for language in &languages {
        let id = language["id"].as_str().expect("an id");
        let dialect = partc::internals::dialect::find(id).unwrap_or_else(|| panic!("{id}: {dialects:?}"));
        json(language["configuration"].as_str().expect("a path"));
        for extension in language["extensions"].as_array().into_iter().flatten().filter_map(Value::as_str) {
            let known = dialect.extensions.contains(&extension.trim_start_matches('.').to_lowercase().as_str());
            assert!(known, "{id} {extension}");
        }
    }
    for grammar in list("/contributes/grammars") {
        let (path, scope) = (grammar["path"].as_str().expect("a path"), &grammar["scopeName"]);
        assert_eq!(&json(path)["scopeName"], scope);
    }
    let code = fs::read_to_string(extension().join("src/extension.js")).expect("the code");
    for command in list("/contributes/commands") {
        assert!(code.contains(&format!("\"{}\"", command["command"].as_str().expect("a name"))), "{command}");
    }
    let settings = meta.pointer("/contributes/configuration/properties").and_then(Value::as_object).expect("settings");
    for name in settings.keys() {
        let short = name.trim_start_matches("partc.");
        assert!(code.contains(&format!("get(\"{short}\")")), "{name}");
    }
    // Versions of the crate and of the extension go together, and what is pinned comes from no place in particular.
    assert_eq!(meta["version"], env!("CARGO_PKG_VERSION"));
    let lock = fs::read_to_string(extension().join("package-lock.json")).expect("the lock");
    assert!(!lock.contains("\"resolved\"") && lock.contains("\"integrity\""));
    for (name, version) in
        meta["dependencies"].as_object().into_iter().chain(meta["devDependencies"].as_object()).flatten()
    {
        assert!(version.as_str().is_some_and(|v| v.starts_with(|c: char| c.is_ascii_digit())), "{name} is not pinned");
    }
}
