//! What build systems and fleets need: lists of what was read, keys, reports of shards put together, the same bytes.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

use serde_json::{Value, json};

use super::cli_run::{Folder, HOLE, PART, RADIUS, WARNED, WRONG, caller};

const CONFIG: &str = "extend = \"base.toml\"\n[tools]\ntable = \"tool.t\"\n";
const BASE: &str = "[output]\ndecimals = 3\n";
const TABLE: &str = "[tools.5]\nradius = 5.0\n";

/// A program that calls another one, under a configuration with a table.
fn tree(test: &str) -> Folder {
    Folder::new(test).with(&[
        ("parts/A.H", &caller("HOLE")),
        ("parts/HOLE.H", HOLE),
        ("partc.toml", "extend = \"base.toml\"\n"),
        ("base.toml", &format!("{BASE}{TABLE}")),
    ])
}

#[test]
fn lists_name_every_file_that_was_read() {
    let folder = tree("deps");
    folder.run(&["compile", "parts/A.H", "--out-dir", "out", "--deps", "a.d"]).exits(0);
    let list = folder.read("a.d");
    assert!(list.starts_with("out/A.ngc: \\\n  parts/A.H \\\n"), "{list}");
    for file in ["parts/HOLE.H", "partc.toml", "base.toml"] {
        assert!(list.lines().any(|line| line.trim_end_matches(" \\").trim().ends_with(file)), "{file}: {list}");
    }
    folder.run(&["check", "parts", "-o", "found.txt", "--deps", "c.json", "--deps-format", "json"]).exits(0);
    let found: Value = serde_json::from_str(&folder.read("c.json")).expect("JSON");
    assert_eq!((&found["version"], &found["rules"][0]["outputs"]), (&json!(1), &json!(["found.txt"])));
    let names = |key: &str| -> BTreeSet<String> {
        let list = found["rules"][0][key].as_array().expect("names");
        list.iter().map(|name| name.as_str().expect("a name").to_owned()).collect()
    };
    let wanted = ["base.toml", "partc.toml", "parts/A.H", "parts/HOLE.H"].map(str::to_owned);
    assert_eq!(names("inputs"), BTreeSet::from(wanted));
    // A file of the very name would be called in its place; a nearer configuration would hold.
    let absent = names("absent");
    assert!(absent.contains("parts/HOLE") && absent.contains("parts/partc.toml"), "{absent:?}");
    // Each once, in order, below the folder as the inputs are.
    let list = found["rules"][0]["absent"].as_array().expect("names");
    let list: Vec<&str> = list.iter().filter_map(Value::as_str).collect();
    assert!(list.is_sorted_by(|a, b| a < b), "{list:?}");
    let here = fs::canonicalize(&folder.0).expect("a folder").display().to_string();
    assert!(!list.iter().any(|name| name.starts_with(&here) || name.starts_with("./")), "{list:?}");
    for command in [["trace", "parts/A.H", "-o", "a.csv"], ["report", "parts/A.H", "-o", "a.html"]] {
        folder.run(&[&command[..], &["--deps", "d.d"]].concat()).exits(0);
        let list = folder.read("d.d");
        assert!(list.starts_with(&format!("{}: \\\n  parts/A.H", command[3])) && list.contains("HOLE.H"), "{list}");
    }
}

/// One of them would go without a word.
#[test]
fn a_list_and_a_report_do_not_share_a_file() {
    let folder = tree("deps_and_report");
    for command in ["compile", "check", "trace", "report"] {
        let args = [command, "parts/A.H", "--report", "json=both.json", "--deps", "parts/../both.json"];
        folder.run(&args).exits(2).says("the list of files and a report cannot go to one file");
        assert!(!folder.has("both.json"), "{command}");
    }
    folder.run(&["check", "parts/A.H", "--report", "json=/dev/null", "--deps", "a.d"]).exits(0);
}

/// What a run reads stays, whatever command writes there, and with `--force`.
#[test]
fn no_command_replaces_what_it_reads() {
    let files = [
        ("A.H", caller("HOLE")),
        // Without extensions, so that no name tells what they are.
        ("HOLE", HOLE.to_owned()),
        ("shop", "extend = \"base\"\n[tools]\ntable = \"tool\"\n".to_owned()),
        ("base", BASE.to_owned()),
        ("tool", tool_t(3)),
    ];
    let folder = Folder::new("closure");
    files.iter().for_each(|(name, text)| folder.write(name, text));
    for (victim, text) in &files {
        let report = format!("json={victim}");
        let commands: [&[&str]; 11] = [
            &["compile", "A.H", "--force", "-o", victim],
            &["compile", "A.H", "--force", "-o", "a.ngc", "--map", victim],
            &["trace", "A.H", "--force", "--format", "csv", "-o", victim],
            &["plot", "A.H", "--force", "--as", "svg", "-o", victim],
            &["report", "A.H", "--force", "-o", victim],
            &["diff", "A.H", "A.H", "--force", "--plot", victim],
            &["check", "A.H", "-o", victim],
            &["stats", "A.H", "--report", &report],
            &["compile", "A.H", "-o", "a.ngc", "--report", &report],
            &["plot", "A.H", "-o", "a.svg", "--report", &report],
            &["trace", "A.H", "-o", "a.csv", "--deps", victim],
        ];
        for command in commands {
            let ran = folder.run(&[command, &["--config", "shop"]].concat()).exits(2);
            assert!(!ran.err.is_empty(), "{command:?}");
            assert_eq!(&folder.read(victim), text, "{command:?}");
        }
        assert!(!folder.has("a.ngc") && !folder.has("a.svg") && !folder.has("a.csv"), "{victim}");
    }
    folder.run(&["compile", "A.H", "--config", "shop", "--force", "-o", "HOLE"]).exits(2).says("is read for A.H");
    folder.run(&["init", "A.H", "--config", "shop", "--force", "-o", "tool"]).exits(2).says("is read for A.H");
    folder.run(&["tools", "tool", "--to", "csv", "-o", "./tool"]).exits(2).says("would be replaced");
    assert_eq!(folder.read("tool"), tool_t(3));
    // Among several programs, too, and through a link.
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("HOLE", folder.0.join("link")).expect("a link");
        folder.run(&["trace", "A.H", "--force", "--format", "csv", "-o", "link"]).exits(2).says("is read for");
    }
    folder.write("B.H", PART);
    folder.run(&["check", "B.H", "A.H", "--report", "json=HOLE"]).exits(2).says("is read for A.H");
    assert_eq!(folder.read("HOLE"), HOLE);
    // The first of several outputs waits for what a later program calls.
    folder.write("C.H", &caller("B.ngc"));
    folder.write("B.ngc", HOLE);
    for jobs in ["1", "2"] {
        folder.run(&["compile", "--jobs", jobs, "--force", "B.H", "C.H"]).exits(2).says("B.ngc: is read for C.H");
        assert_eq!((folder.read("B.ngc"), folder.has("C.ngc")), (HOLE.to_owned(), false));
    }
}

#[test]
fn results_of_golden_tests_replace_no_source() {
    let folder = Folder::new("junit_closure").with(&[("A.H", &caller("HOLE")), ("HOLE", HOLE), ("partc.toml", "")]);
    folder.run(&["test", "--update"]).exits(0);
    for victim in ["A.H", "HOLE", "partc.toml", "A.golden.ngc"] {
        let before = folder.read(victim);
        folder.run(&["test", "--junit", victim]).exits(2).says(victim);
        assert_eq!(folder.read(victim), before);
    }
    folder.run(&["test", "--junit", "results.xml"]).exits(0);
    folder.run(&["test", "--junit", "results.xml"]).exits(0);
    assert!(
        folder.read("results.xml").contains("name=\"./A.H\"") || folder.read("results.xml").contains("name=\"A.H\"")
    );
}

#[test]
fn the_extension_of_a_trace_is_one_that_is_known() {
    let folder = Folder::new("trace_extension").with(&[("A.H", PART)]);
    for name in ["a.txt", "a.json", "a.xlsx", "a.H"] {
        folder.run(&["trace", "A.H", "-o", name]).exits(2).says("--format");
        assert!(!folder.has(name), "{name}");
        folder.run(&["trace", "A.H", "-o", name, "--format", "csv"]).exits(0);
        assert!(folder.read(name).starts_with("kind,"), "{name}");
    }
    for name in ["a.jsonl", "a.NDJSON", "a", "-"] {
        let ran = folder.run(&["trace", "A.H", "-o", name]).exits(0);
        let text = if name == "-" { ran.out } else { folder.read(name) };
        assert!(text.starts_with("{\"kind\""), "{name}");
    }
}

#[test]
fn reports_are_read_as_they_come_but_once() {
    let folder = Folder::new("merge_forms").with(&[("A.H", PART), ("B.H", WRONG)]);
    folder.run(&["check", "A.H", "--format", "json", "-o", "a.json"]).exits(0);
    folder.run(&["check", "B.H", "--format", "json", "-o", "b.json"]).exits(1);
    let whole = folder.run(&["merge", "a.json", "b.json"]).exits(0).out;
    assert_eq!(folder.run(&["merge", "b.json", "a.json"]).exits(0).out, whole);
    folder.run(&["merge", "a.json", "b.json", "./a.json"]).exits(2).says("given twice");
    assert_eq!(folder.run_with(&["merge", "-", "a.json"], &folder.read("b.json")).exits(0).out, whole);
    folder.run_with(&["merge", "-", "-"], &whole).exits(2).says("given twice");
    folder.write("bom.json", &format!("\u{feff}{}", folder.read("b.json")));
    assert_eq!(folder.run(&["merge", "bom.json", "a.json"]).exits(0).out, whole);
    for (count, says) in
        [("18446744073709551615", "more than there can be"), ("-1", "is no json"), ("1e30", "is no json")]
    {
        folder.write("odd.json", &folder.read("b.json").replace("\"files\":1", &format!("\"files\":{count}")));
        folder.run(&["merge", "a.json", "odd.json"]).exits(2).says(says);
    }
}

#[test]
fn a_program_is_in_one_shard_however_it_is_typed() {
    let folder = Folder::new("shards_typed");
    let names: Vec<String> = (0..12).map(|n| format!("progs/P{n}.H")).collect();
    names.iter().for_each(|name| folder.write(name, PART));
    let part = |path: &str, part: &str| {
        let keys = folder.run(&["key", path, "--shard", part]).exits(0).out;
        keys.lines().filter_map(|line| line.rsplit('/').next().map(str::to_owned)).collect::<Vec<_>>()
    };
    let whole = folder.0.join("progs");
    let (first, second) = (part("progs", "1/2"), part("progs", "2/2"));
    assert!(!first.is_empty() && !second.is_empty() && first.len() + second.len() == names.len());
    for typed in ["./progs/../progs", whole.to_str().expect("text")] {
        assert_eq!((part(typed, "1/2"), part(typed, "2/2")), (first.clone(), second.clone()), "{typed}");
    }
}

#[test]
fn a_source_map_replaces_no_source() {
    let folder = Folder::new("map_spares").with(&[("A.H", PART), ("B.H", PART)]);
    for (file, force) in [("B.H", None), ("B.H", Some("--force")), ("partc.toml", Some("--force"))] {
        let words: Vec<&str> = ["compile", "A.H", "--map", file].into_iter().chain(force).collect();
        folder.run(&words).exits(2).says("would replace a part program, a table or a configuration");
        assert!(!folder.has("A.ngc") && folder.read("B.H") == PART);
    }
    folder.run(&["compile", "A.H", "--map", "A.map"]).exits(0);
    folder.run(&["compile", "A.H", "--map", "A.map"]).exits(0);
}

#[test]
fn a_run_that_fails_leaves_the_older_list() {
    let folder = Folder::new("deps_failed").with(&[("A.H", PART), ("W.H", WRONG)]);
    folder.write("a.d", "older.ngc: \\\n  A.H\n");
    folder.run(&["compile", "W.H", "--deps", "a.d"]).exits(1);
    assert!(folder.read("a.d").starts_with("older.ngc"));
    folder.run(&["compile", "A.H", "--deps", "A.H"]).exits(2).says("would replace");
    folder.run(&["compile", "A.H", "--deps", "A.ngc"]).exits(2).says("would replace");
    // Neither a program nor a configuration that has nothing to do with it, nor any other text.
    folder.write("notes.txt", "Ask about the fixture.\n");
    for other in ["W.H", "partc.toml", "notes.txt"] {
        folder.run(&["compile", "A.H", "-o", "b.ngc", "--deps", other]).exits(2).says("would replace");
    }
    folder.run(&["check", "A.H", "--format", "json", "-o", "r.json"]).exits(0);
    for other in ["W.H", "partc.toml", "DATUMS.D"] {
        folder.run(&["merge", "r.json", "-o", other]).exits(2).says("would be replaced");
    }
    let other = folder.read("r.json").replace("{\"version\":1", "{\"version\":2");
    folder.write("v2.json", &other);
    folder.run(&["merge", "v2.json"]).exits(2).says("another version");
    folder.run(&["compile", "A.H", "--deps-format", "json"]).exits(2);
    assert_eq!(folder.read("A.H"), PART);
    folder.run(&["compile", "A.H", "--deps", "a.d"]).exits(0);
    assert_eq!(folder.read("a.d"), "A.ngc: \\\n  A.H\n");
}

/// Make reads the names as they are, and builds again when one of them changes.
#[cfg(unix)]
#[test]
fn make_understands_the_names() {
    if Command::new("make").arg("--version").output().is_err() {
        println!("skipped: make is not installed");
        return;
    }
    let folder = Folder::new("deps_make");
    let name = "a b#c$d:e\\ f.H";
    folder.write(name, PART);
    folder.run(&["compile", name, "-o", "x.ngc", "--deps", "x.d"]).exits(0);
    assert_eq!(folder.read("x.d"), "x.ngc: \\\n  a\\ b\\#c$$d\\:e\\\\\\ f.H\n");
    folder.write("Makefile", "all: x.ngc\nx.ngc:\n\ttouch made x.ngc\ninclude x.d\n");
    let make = || {
        let ran = Command::new("make").current_dir(&folder.0).env_remove("MAKEFLAGS").output().expect("make runs");
        assert!(ran.status.success(), "{}", String::from_utf8_lossy(&ran.stderr));
        folder.has("made")
    };
    let now = std::time::SystemTime::now();
    let age = |name: &str, seconds: u64| {
        let file = fs::File::options().append(true).open(folder.0.join(name)).expect("a file");
        file.set_modified(now - std::time::Duration::from_secs(seconds)).expect("a time");
    };
    age(name, 100);
    age("x.ngc", 50);
    assert!(!make(), "nothing has changed");
    age(name, 10);
    assert!(make(), "the program has changed");
}

fn key(folder: &Folder, args: &[&str]) -> String {
    let out = folder.run(&[&["key"], args].concat()).exits(0).out;
    let (key, _) = out.split_once("  ").expect("a key and a name");
    assert!(key.len() == 32 && key.bytes().all(|b| b.is_ascii_hexdigit()), "{out}");
    key.to_owned()
}

#[test]
fn a_key_is_the_same_in_every_folder() {
    let (one, other) = (tree("key_here"), tree("key_there/below/another"));
    assert_eq!(key(&one, &["parts/A.H"]), key(&other, &["parts/A.H"]));
    // By whatever path it is named, and whenever it was written.
    let absolute = one.0.join("parts/A.H").display().to_string();
    assert_eq!(key(&one, &["./parts/A.H"]), key(&one, &[&absolute]));
    one.write("parts/A.H", &caller("HOLE"));
    assert_eq!(key(&one, &["parts/A.H"]), key(&other, &["parts/A.H"]));
    let all = one.run(&["key", "parts", "-j", "2"]).exits(0).out;
    assert_eq!(all, one.run(&["key", "parts", "-j", "1"]).exits(0).out);
    let names: Vec<&str> = all.lines().map(|line| &line[34..]).collect();
    assert_eq!(names, ["parts/A.H", "parts/HOLE.H"]);
    assert_eq!(key(&one, &["parts/A.H"]), all[..32]);
}

#[test]
fn a_key_changes_with_everything_that_counts() {
    let folder = tree("key_changes");
    folder.write("tool.t", &tool_t(3));
    folder.write("partc.toml", CONFIG);
    let mut keys = BTreeSet::from([key(&folder, &["parts/A.H"])]);
    let mut is_new = |what: &str, key: String| assert!(keys.insert(key), "the key does not show {what}");
    for (name, text) in [
        ("parts/A.H", caller("HOLE").replace("X+10", "X+11")),
        ("parts/HOLE.H", HOLE.replace("F150", "F151")),
        ("base.toml", BASE.replace('3', "4")),
        ("tool.t", tool_t(4)),
        ("partc.toml", format!("{CONFIG}radius = 1\n").replace("radius = 1\n", "[output]\nunits = \"inch\"\n")),
        // They were looked for.
        ("parts/HOLE", HOLE.to_owned()),
        ("parts/partc.toml", BASE.to_owned()),
    ] {
        folder.write(name, &text);
        is_new(name, key(&folder, &["parts/A.H"]));
    }
    is_new("the target", key(&folder, &["parts/A.H", "--target", "fanuc"]));
    is_new("block numbers", key(&folder, &["parts/A.H", "--numbers", "10"]));
    is_new("compensation", key(&folder, &["parts/A.H", "--compensation", "control"]));
    is_new("rapid traverse", key(&folder, &["parts/A.H", "--rapid", "20000"]));
    is_new("acceleration", key(&folder, &["parts/A.H", "--acceleration", "2"]));
    is_new("tool changes", key(&folder, &["parts/A.H", "--tool-change", "3"]));
    is_new("selected findings", key(&folder, &["parts/A.H", "--select", "all"]));
    is_new("no configuration", key(&folder, &["parts/A.H", "--isolated"]));
    // What is said of them is what holds anyway.
    let said = key(&folder, &["parts/A.H", "--rapid", "10000", "--acceleration", "1.0"]);
    assert_eq!(said, key(&folder, &["parts/A.H"]));
    fs::rename(folder.0.join("parts/A.H"), folder.0.join("parts/B.H")).expect("another name");
    is_new("the name", key(&folder, &["parts/B.H"]));
    // Neither does what nobody reads.
    let before = key(&folder, &["parts/B.H"]);
    folder.write("parts/UNUSED.H", PART);
    folder.write("README", "text");
    assert_eq!(key(&folder, &["parts/B.H"]), before);
    folder.run(&["key", "parts/NONE.H"]).exits(2);
}

/// A program that lacks what it calls has a key, and another one when that is there.
#[test]
fn a_called_program_that_appears_changes_the_key() {
    let folder = Folder::new("key_absent").with(&[("A.H", &caller("HOLE"))]);
    let before = key(&folder, &["A.H"]);
    folder.write("HOLE.H", HOLE);
    assert_ne!(key(&folder, &["A.H"]), before);
}

fn tool_t(radius: u32) -> String {
    format!(
        "BEGIN TOOL.T MM\nT    NAME             L          R          R2\n5    MILL             +50        +{radius}         +0\n[END]\n"
    )
}

const FORMS: [&str; 5] = ["json", "sarif", "gitlab", "junit", "checkstyle"];

/// Programs with findings of their own and in what they call.
fn fleet(test: &str) -> Folder {
    let folder = Folder::new(test).with(&[("ZZ.H", &HOLE.replace("F150", "R5")), ("partc.toml", "")]);
    for n in 0..24 {
        let folders = ["a", "a b", "a-b", "a&b/c", "ä"];
        let text = match n % 6 {
            0 => PART.to_owned(),
            1 => WRONG.to_owned(),
            2 => WARNED.to_owned(),
            3 => RADIUS.to_owned(),
            4 => "N10 G1 X5\nN20 M30\n".to_owned(),
            _ => caller("YY"),
        };
        let extension = if n % 6 == 4 { "MPF" } else { "H" };
        let place = folders[n % folders.len()];
        folder.write(&format!("fleet/{place}/P{n}.{extension}"), &text);
        folder.write(&format!("fleet/{place}/YY.H"), &HOLE.replace("F150", "R5"));
    }
    folder
}

#[test]
fn shards_put_together_are_the_whole() {
    let folder = fleet("merge");
    for form in FORMS {
        folder.run(&["check", "fleet", "--format", form, "-o", "whole"]).exits(1);
        for of in [1, 3, 7] {
            let mut parts: Vec<String> = Vec::new();
            for part in 1..=of {
                let (name, shard) = (format!("part{part}"), format!("{part}/{of}"));
                let ran = folder.run(&["check", "fleet", "--format", form, "-o", &name, "--shard", &shard]);
                assert!(ran.code == Some(0) || ran.code == Some(1), "{}", ran.err);
                parts.push(name);
            }
            // In whatever order they come.
            parts.reverse();
            let names: Vec<&str> = parts.iter().map(String::as_str).collect();
            let merged = folder.run(&[&["merge"], &names[..]].concat()).exits(0).quietly().out;
            assert!(merged == folder.read("whole"), "{form} of {of} shards:\n{merged}\n{}", folder.read("whole"));
            folder.run(&[&["merge", "-o", "merged"], &names[..]].concat()).exits(0);
            assert_eq!(folder.read("merged"), merged);
        }
    }
}

#[test]
fn what_is_no_report_is_not_put_together() {
    let folder = Folder::new("merge_refused").with(&[("A.H", PART), ("b.json", "{\"a\":1}"), ("c.xml", "<a/>")]);
    folder.run(&["check", "A.H", "--format", "json", "-o", "a.json"]).exits(0);
    folder.run(&["check", "A.H", "--format", "junit", "-o", "a.xml"]).exits(0);
    for file in ["A.H", "b.json", "c.xml"] {
        folder.run(&["merge", "a.json", file]).exits(2).says(file);
    }
    folder.run(&["merge", "a.json", "a.xml"]).exits(2).says("another form");
    folder.run(&["merge", "a.json", "-o", "a.json"]).exits(2).says("would be replaced");
    folder.run(&["merge", "none.json"]).exits(2);
    folder.run(&["merge"]).exits(2);
}

#[test]
fn trouble_of_all_shards_is_told_once() {
    let folder = Folder::new("merge_trouble").with(&[("A.H", PART)]);
    for form in FORMS {
        folder.run(&["check", "A.H", "none.H", "--format", form, "-o", "whole"]).exits(2);
        let parts = ["one", "two"];
        for (name, shard) in parts.iter().zip(["1/2", "2/2"]) {
            folder.run(&["check", "A.H", "none.H", "--format", form, "-o", name, "--shard", shard]);
        }
        assert_eq!(folder.run(&["merge", "one", "two"]).exits(0).out, folder.read("whole"), "{form}");
    }
}

/// All outputs of a folder of programs, by name.
fn outputs(folder: &Folder, jobs: &str) -> Vec<(String, Vec<u8>)> {
    let run = |args: &[&str]| folder.run(&[args, &["--jobs", jobs]].concat());
    run(&["compile", "parts", "--out-dir", "out", "--report", "sarif=out/found.sarif"]).exits(0);
    run(&["check", "parts", "--format", "json", "-o", "out/found.json"]).exits(0);
    run(&["stats", "parts", "--as", "csv"]).exits(0);
    folder.run(&["compile", "parts/A.H", "--out-dir", "out", "--map", "out/a.map"]).exits(0);
    let forms = if cfg!(feature = "columns") { &["jsonl", "csv", "arrow", "parquet"][..] } else { &["jsonl", "csv"] };
    for form in forms {
        folder.run(&["trace", "parts/A.H", "-o", &format!("out/a.{form}")]).exits(0);
    }
    folder.run(&["report", "parts/A.H", "-o", "out/a.html"]).exits(0);
    folder.run(&["plot", "parts/A.H", "-o", "out/a.svg"]).exits(0);
    let names = folder.names().into_iter().filter(|name| name.starts_with("out/"));
    names.map(|name| (name.clone(), fs::read(folder.0.join(&name)).expect("a file"))).collect()
}

#[test]
fn outputs_are_the_same_in_every_folder_and_on_any_number_of_threads() {
    let one = outputs(&tree("same_here"), "1");
    let other = outputs(&tree("same_there/further/below"), "4");
    assert!(one.len() >= 8, "{}", one.len());
    for ((name, one), (other_name, other)) in one.iter().zip(&other) {
        assert_eq!(name, other_name);
        assert!(one == other, "{name} differs");
    }
}

/// What the rule for Bazel runs, in a folder as Bazel makes it: inputs are links, the output is named.
#[cfg(unix)]
#[test]
fn the_commands_of_the_bazel_rule_work() {
    let rule = Path::new(env!("CARGO_MANIFEST_DIR")).join("ci/bazel/partc.bzl");
    let rule = fs::read_to_string(rule).expect("the rule");
    let (_, script) = rule.split_once("_COMPILE = \"\"\"").expect("the script");
    let (script, _) = script.split_once("\"\"\"").expect("its end");
    let source = tree("bazel_source");
    let box_ = Folder::new("bazel_box");
    fs::create_dir_all(box_.0.join("parts")).expect("a folder");
    let files = ["parts/A.H", "parts/HOLE.H", "partc.toml", "base.toml"];
    for file in files {
        std::os::unix::fs::symlink(source.0.join(file), box_.0.join(file)).expect("a link");
    }
    let run = |out: &str| {
        let ran = Command::new("bash")
            .args(["-c", script, "partc_compile", env!("CARGO_BIN_EXE_partc"), "parts/A.H", out, "linuxcnc"])
            .args(files)
            .current_dir(&box_.0)
            .output()
            .expect("bash runs");
        assert!(ran.status.success(), "{}", String::from_utf8_lossy(&ran.stderr));
        fs::read(box_.0.join(out)).expect("an output")
    };
    fs::create_dir_all(box_.0.join("bin/parts")).expect("a folder");
    source.run(&["compile", "parts/A.H", "-o", "A.ngc"]).exits(0);
    assert_eq!(String::from_utf8_lossy(&run("bin/parts/A.ngc")), source.read("A.ngc"));
    // A program with an error has no output, and the action fails.
    source.write("parts/A.H", WRONG);
    let ran = Command::new("bash")
        .args(["-c", script, "partc_compile", env!("CARGO_BIN_EXE_partc"), "parts/A.H", "bin/W.ngc", "linuxcnc"])
        .args(files)
        .current_dir(&box_.0)
        .output()
        .expect("bash runs");
    assert!(!ran.status.success() && !box_.has("bin/W.ngc"));
}
