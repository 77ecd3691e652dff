//! What lies in `ci/` for users: each of its commands runs, and the hook stops a commit.
#![cfg(unix)]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use super::cli_run::{Folder, PART, WRONG};

fn recipe(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("ci").join(name)
}

/// The commands of partc in a recipe.
fn commands(name: &str) -> Vec<Vec<String>> {
    let text = fs::read_to_string(recipe(name)).expect("a recipe");
    let line = |line: &str| {
        let line = line.trim().trim_start_matches("- ").trim_start_matches("run: ");
        line.strip_prefix("partc ").map(|rest| rest.split(' ').map(str::to_owned).collect())
    };
    text.lines().filter_map(line).collect()
}

#[test]
fn every_command_of_the_recipes_runs() {
    for (name, files) in [
        ("github.yml", &["partc.sarif", "partc-tests.xml"][..]),
        ("gitlab.yml", &["gl-code-quality-report.json", "partc-tests.xml"]),
    ] {
        let folder = Folder::new(&format!("ci_{name}")).with(&[("programs/A.H", PART)]);
        folder.run(&["test", "programs", "--update"]).exits(0);
        let commands = commands(name);
        assert!(commands.len() >= 2, "{name}");
        for command in &commands {
            folder.run(&command.iter().map(String::as_str).collect::<Vec<_>>()).exits(0);
        }
        let text = fs::read_to_string(recipe(name)).expect("a recipe");
        for file in files {
            assert!(folder.has(file) && text.matches(file).count() >= 2, "{name}: {file}");
        }
        folder.write("programs/A.H", WRONG);
        let failing = commands.iter().filter(|command| command[0] == "check" || command[0] == "test");
        for command in failing {
            folder.run(&command.iter().map(String::as_str).collect::<Vec<_>>()).exits(1);
        }
    }
}

fn git(folder: &Folder, args: &[&str]) -> bool {
    let bin = Path::new(env!("CARGO_BIN_EXE_partc")).parent().expect("a folder");
    let path = format!("{}:{}", bin.display(), std::env::var("PATH").unwrap_or_default());
    let mut command = Command::new("git");
    command.args(["-c", "user.name=test", "-c", "user.email=test@localhost", "-c", "commit.gpgsign=false"]);
    command.args(args).current_dir(&folder.0).env("PATH", path).env_remove("GIT_DIR").env_remove("GIT_INDEX_FILE");
    command
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .is_ok_and(|status| status.success())
}

#[test]
fn the_hook_looks_at_what_is_staged() {
    let folder = Folder::new("ci_hook").with(&[("shop/A.H", PART), ("notes.txt", "no program")]);
    if !git(&folder, &["init", "-q"]) {
        return;
    }
    fs::create_dir_all(folder.0.join(".git/hooks")).expect("a folder");
    fs::copy(recipe("pre-commit"), folder.0.join(".git/hooks/pre-commit")).expect("the hook");
    assert!(git(&folder, &["add", "."]) && git(&folder, &["commit", "-q", "-m", "clean"]), "a clean program");
    folder.write("shop/B.H", WRONG);
    assert!(git(&folder, &["add", "."]) && !git(&folder, &["commit", "-q", "-m", "wrong"]), "a program with an error");
    // What is staged counts, not what lies in the folder.
    folder.write("shop/B.H", PART);
    assert!(!git(&folder, &["commit", "-q", "-m", "wrong"]), "the error is staged");
    assert!(git(&folder, &["add", "."]) && git(&folder, &["commit", "-q", "-m", "mended"]), "a mended program");
    // Programs of lathes are looked at, outputs of the same name are not.
    folder.write("shop/L.nc", "T1\nG97 S500 M3\nG95 F0.2\nG0 X100 Z2\nG1 X\nM30\n");
    assert!(
        git(&folder, &["add", "."]) && !git(&folder, &["commit", "-q", "-m", "lathe"]),
        "a lathe program with an error"
    );
    folder.run(&["compile", "shop/B.H", "-o", "shop/L.nc", "--force"]).exits(0);
    assert!(git(&folder, &["add", "."]) && git(&folder, &["commit", "-q", "-m", "output"]), "an output");
    folder.write("notes.txt", "still no program");
    assert!(git(&folder, &["commit", "-q", "-a", "-m", "notes"]), "no program at all");
}
