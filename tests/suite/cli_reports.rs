//! Reports for forges and CI jobs, and which programs they are about.

use std::process::Command;

use serde_json::Value;
use serde_sarif::sarif;

use super::cli_run::{Folder, HOLE, PART, RADIUS, WARNED, WRONG, caller, set};

fn folder(test: &str) -> Folder {
    Folder::new(test).with(&[("a/PART.H", PART), ("a/deep/WARNED.H", WARNED), ("b/WRONG.H", WRONG)])
}

#[test]
fn sarif_is_what_its_schema_says() {
    let folder = folder("sarif").with(&[("CALLER.H", &caller("HOLE X.H")), ("HOLE X.H", HOLE)]);
    folder.write("b/Teil ä.H", &WRONG.replace("WRONG", "TEIL"));
    let ran = folder.run(&["check", ".", "gone.H", "--format", "sarif"]).exits(2);
    let report: sarif::Sarif = serde_json::from_str(&ran.out).expect("SARIF");
    let run = &report.runs[0];
    let rules = run.tool.driver.rules.as_ref().expect("rules");
    let results = run.results.as_ref().expect("results");
    assert!(results.len() >= 3, "{}", ran.out);
    for result in results {
        let index = usize::try_from(result.rule_index.expect("an index")).expect("from 0");
        assert_eq!(Some(&rules[index].id), result.rule_id.as_ref());
        let place = result.locations.as_ref().expect("places")[0].physical_location.as_ref().expect("a place");
        let uri = place.artifact_location.as_ref().and_then(|file| file.uri.as_ref()).expect("a file");
        assert!(uri.is_ascii() && !uri.contains(' '), "{uri}");
        assert!(place.region.as_ref().expect("a region").start_line >= Some(1));
    }
    // What a rule says stands in it once.
    let ids: std::collections::BTreeSet<_> = rules.iter().map(|rule| &rule.id).collect();
    assert_eq!(ids.len(), rules.len());
    // A file that is missing is no finding.
    let invocation = &run.invocations.as_ref().expect("an invocation")[0];
    assert!(!invocation.execution_successful);
    assert!(ran.out.contains("gone.H"));
}

#[test]
fn each_format_names_file_line_and_code() {
    let folder = folder("formats");
    for (format, wanted) in [
        ("concise", "b/WRONG.H:2:14: error[P1003]"),
        ("jsonl", "\"file\":\"b/WRONG.H\",\"line\":2"),
        ("github", "::error file=b/WRONG.H,line=2,col=14,endColumn=16,title=P1003 "),
        ("gitlab", "\"location\":{\"path\":\"b/WRONG.H\",\"lines\":{\"begin\":2,\"end\":2}}"),
        ("junit", "<testsuites tests=\"3\" failures=\"1\" errors=\"0\">"),
        ("checkstyle", "<file name=\"b/WRONG.H\">\n    <error line=\"2\" column=\"14\" severity=\"error\""),
    ] {
        let ran = folder.run(&["check", ".", "--format", format]).exits(1);
        let text = if format == "concise" { &ran.err } else { &ran.out };
        assert!(text.contains(wanted), "{format}: {text}");
        let file = format!("report.{format}");
        folder.run(&["check", ".", "--format", format, "-o", &file]).exits(1);
        let written = folder.read(&file);
        assert!(text.starts_with(&written) && !written.is_empty(), "{format}: {written}");
        std::fs::remove_file(folder.0.join(file)).expect("written");
    }
    // One finding a line.
    let ran = folder.run(&["check", ".", "--format", "jsonl"]).exits(1);
    let lines: Vec<Value> = ran.out.lines().map(|line| serde_json::from_str(line).expect("an object")).collect();
    assert_eq!(lines.len(), 2);
}

/// No job is red with an empty log: standard error has the lines to paste and the count, whatever the format, and for a file, too.
#[test]
fn each_format_ends_with_what_to_do_and_how_much_there_is() {
    let folder = Folder::new("ends").with(&[("RADIUS.H", RADIUS), ("PART.H", PART)]);
    for format in ["json", "jsonl", "github", "gitlab", "sarif", "junit", "checkstyle", "concise", "human"] {
        for more in [&[][..], &["-o", "out.txt"]] {
            let ran = folder.run(&[&["check", ".", "--format", format][..], more].concat()).exits(1);
            assert!(ran.err.contains("[tools]\n") || ran.err.contains("[tools.5]"), "{format}: {}", ran.err);
            assert!(
                ran.err.contains("radius") && ran.err.ends_with("\n2 programs, 1 error, 0 warnings\n"),
                "{}",
                ran.err
            );
            assert!(!ran.out.contains("Paste") && !ran.out.contains("2 programs"), "{format}: {}", ran.out);
        }
    }
    // Whoever wants quiet has it, and one clean program is told on a terminal only.
    folder.run(&["check", ".", "--format", "gitlab", "--quiet"]).exits(1).quietly();
    folder.run(&["check", "PART.H"]).exits(0).quietly();
}

#[test]
fn further_reports_go_to_files() {
    let folder = folder("further");
    let more = ["--report", "sarif=out.sarif", "--report", "junit=out.xml", "--report", "gitlab=out.json"];
    let ran = folder.run(&[&["check", ".", "--format", "concise"][..], &more].concat()).exits(1);
    assert!(ran.err.contains("WRONG.H:2:14") && ran.err.ends_with("3 programs, 1 error, 1 warning\n"), "{}", ran.err);
    assert!(ran.out.is_empty());
    assert!(folder.read("out.sarif").contains("\"version\":\"2.1.0\""));
    assert!(folder.read("out.xml").starts_with("<?xml "));
    assert!(folder.read("out.json").starts_with("[{\"description\":"));
    // Those for people are as they are on a terminal, without its colours.
    let more = ["--report", "human=out.txt", "--report", "concise=out.log", "--color", "always"];
    let ran = folder.run(&[&["check", ".", "--format", "sarif"][..], &more].concat()).exits(1);
    assert!(ran.out.starts_with('{') && ran.err == "3 programs, 1 error, 1 warning\n", "{}", ran.err);
    let plain = |format: &str| {
        let err = folder.run(&["check", ".", "--format", format, "--color", "never"]).exits(1).err;
        err.rsplit_once("3 programs").expect("a summary").0.trim_end().to_owned()
    };
    assert_eq!(folder.read("out.txt").trim_end(), plain("human"));
    assert_eq!(folder.read("out.log").trim_end(), plain("concise"));
    assert!(folder.read("out.log").contains("WRONG.H:2:14") && !folder.read("out.txt").contains('\u{1b}'));
    folder.run(&["check", ".", "--report", "sarif"]).exits(2);
}

#[test]
fn github_annotations_come_by_themselves_in_a_workflow() {
    let folder = folder("workflow");
    let run = |args: &[&str], value: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_partc"));
        let output = command.args(args).current_dir(&folder.0).env("GITHUB_ACTIONS", value).output().expect("it runs");
        String::from_utf8(output.stdout).expect("UTF-8")
    };
    assert!(run(&["check", "."], "true").contains("::error file=b/WRONG.H"));
    assert!(run(&["check", ".", "--format", "human"], "true").is_empty());
    assert!(run(&["check", "."], "false").is_empty());
    // Standard output is the program's.
    assert!(run(&["compile", "a/PART.H", "-o", "-"], "true").starts_with("%\n"));
}

#[test]
fn what_fails_is_for_the_user_to_say() {
    let folder = folder("fail_on");
    folder.run(&["check", "a"]).exits(0);
    folder.run(&["check", "a", "--fail-on", "warning"]).exits(1);
    folder.run(&["check", "a/PART.H", "--fail-on", "note"]).exits(0);
    folder.run(&["check", ".", "--exit-zero"]).exits(0);
    folder.run(&["check", ".", "gone.H", "--exit-zero"]).exits(2);
    // No output where the exit code says that there is none.
    folder.run(&["compile", "a/deep/WARNED.H", "--fail-on", "warning"]).exits(1);
    folder.run(&["compile", "b/WRONG.H", "--exit-zero"]).exits(0);
    assert!(!folder.has("a/deep/WARNED.ngc") && !folder.has("b/WRONG.ngc"));
    folder.run(&["compile", "a/deep/WARNED.H"]).exits(0);
    assert!(folder.has("a/deep/WARNED.ngc"));
    let junit = folder.run(&["check", "a", "--format", "junit", "--fail-on", "warning"]).exits(1);
    assert!(junit.out.contains("tests=\"2\" failures=\"1\""), "{}", junit.out);
}

#[test]
fn statistics_count_each_code() {
    let folder = folder("statistics");
    let ran = folder.run(&["check", ".", "--quiet", "--statistics", "--format", "concise"]).exits(1);
    let last: Vec<&str> = ran.err.lines().skip(1).collect();
    assert_eq!(last.len(), 2, "{}", ran.err);
    assert!(
        last[0].starts_with("      1 K2102 warning ") && last[1].starts_with("      1 P1003 error "),
        "{}",
        ran.err
    );
}

#[test]
fn threads_do_not_show() {
    let folder = Folder::new("threads");
    for n in 0..40 {
        let text = if n % 3 == 0 { WRONG } else { WARNED };
        folder.write(&format!("{}/P{n}.H", n % 5), text);
    }
    let run = |jobs: &str, format: &str| {
        let ran = folder.run(&["check", ".", "--jobs", jobs, "--format", format]).exits(1);
        // A busy machine takes more than a second, and then the summary says how fast it was.
        let err = ran.err.lines().map(|line| line.split(" warnings, ").next().unwrap_or_default().to_owned());
        (ran.out, err.collect::<Vec<_>>())
    };
    for format in ["human", "json", "sarif", "gitlab"] {
        assert_eq!(run("1", format), run("5", format), "{format}");
    }
    for jobs in ["1", "6"] {
        let ran = folder.run(&["compile", ".", "--out-dir", jobs, "--jobs", jobs, "--format", "concise"]).exits(1);
        assert!(ran.err.contains("40 programs, 26 written, 14 errors, 26 warnings"), "{}", ran.err);
    }
    let of = |jobs: &str| {
        let names = folder.names();
        let names = names.iter().filter_map(|name| name.strip_prefix(&format!("{jobs}/")));
        names
            .filter(|name| name.ends_with(".ngc"))
            .map(|name| (name.to_owned(), folder.read(&format!("{jobs}/{name}"))))
            .collect::<Vec<_>>()
    };
    assert_eq!(of("6").len(), 26);
    assert_eq!(of("1"), of("6"));
}

#[test]
fn a_folder_keeps_its_tree() {
    let folder = folder("tree");
    folder.run(&["compile", ".", "--out-dir", "out"]).exits(1);
    let made = set(&["out", "out/a", "out/a/PART.ngc", "out/a/deep", "out/a/deep/WARNED.ngc", "out/b"]);
    assert!(folder.names().is_superset(&made), "{:?}", folder.names());
    assert!(!folder.has("out/b/WRONG.ngc"));
    // What partc wrote is no program.
    let ran = folder.run(&["compile", ".", "--out-dir", "out"]).exits(1);
    assert!(ran.err.ends_with("3 programs, 2 written, 1 error, 1 warning\n"), "{}", ran.err);
    folder.run(&["compile", "a", "--format", "concise"]).exits(0);
    assert!(folder.has("a/PART.ngc") && folder.has("a/deep/WARNED.ngc"));
}

#[test]
fn patterns_lists_and_ignored_files() {
    let folder = folder("patterns");
    let checked = |args: &[&str], input: &str| {
        let ran = folder.run_with(&[&["check", "--format", "junit"][..], args].concat(), input);
        let names =
            ran.out.lines().filter_map(|line| line.trim().strip_prefix("<testcase classname=\"partc\" name=\""));
        names.filter_map(|rest| rest.split('"').next().map(str::to_owned)).collect::<Vec<_>>()
    };
    assert_eq!(checked(&["**/*.H"], ""), ["a/PART.H", "a/deep/WARNED.H", "b/WRONG.H"]);
    assert_eq!(checked(&["a/*.H"], ""), ["a/PART.H"]);
    assert_eq!(checked(&["--files-from", "-"], "b\na/PART.H\n\na/PART.H\n"), ["b/WRONG.H", "a/PART.H"]);
    folder.write("list", "a/deep\r\n");
    assert_eq!(checked(&["--files-from", "list", "b"], ""), ["b/WRONG.H", "a/deep/WARNED.H"]);
    folder.run(&["check", "c/*.H"]).exits(2);
    folder.run(&["check", "--files-from", "gone"]).exits(2);
    folder.run(&["check"]).exits(2);
    for name in [".gitignore", ".ignore", ".partcignore"] {
        folder.write(name, "deep/\n/b\n");
        assert_eq!(checked(&["."], ""), ["a/PART.H"], "{name}");
        // Who names a file means it.
        assert_eq!(checked(&["b/WRONG.H"], ""), ["b/WRONG.H"]);
        std::fs::remove_file(folder.0.join(name)).expect("written");
    }
}

#[test]
fn shards_share_the_programs() {
    let folder = Folder::new("shards");
    for n in 0..20 {
        folder.write(&format!("P{n:02}.H"), WARNED);
    }
    let lines = |shard: &str| {
        let ran = folder.run(&["check", ".", "--shard", shard, "--format", "jsonl"]).exits(0);
        ran.out.lines().map(str::to_owned).collect::<Vec<_>>()
    };
    let mut parts: Vec<String> = ["1/3", "2/3", "3/3"].iter().flat_map(|shard| lines(shard)).collect();
    parts.sort();
    assert_eq!(parts, lines("1/1"));
    for wrong in ["0/3", "4/3", "1", "a/b", "1/0"] {
        folder.run(&["check", ".", "--shard", wrong]).exits(2);
    }
}

#[test]
fn shards_refuse_two_programs_with_one_output() {
    let folder = Folder::new("shards_outputs").with(&[("in/A.H", PART), ("in/A.MPF", "G0 X1 Y1 Z1\nM30\n")]);
    for shard in ["1/3", "2/3", "3/3"] {
        let ran = folder.run(&["compile", "in", "--out-dir", "out", "--shard", shard]).exits(2);
        assert!(ran.err.contains("would both be written to"), "{}", ran.err);
    }
    assert!(!folder.has("out"));
}

#[test]
fn a_report_replaces_no_program() {
    let folder = folder("spared");
    for args in [
        ["check", "a/PART.H", "-o", "a/PART.H"],
        ["check", "a/PART.H", "-o", "b/WRONG.H"],
        ["check", "a/PART.H", "--report", "sarif=a/PART.H"],
        ["compile", "a/PART.H", "--report", "sarif=b/WRONG.H"],
        ["trace", "a/PART.H", "--report", "sarif=b/WRONG.H"],
        // Nor what the programs are read with.
        ["check", "a/PART.H", "-o", "partc.toml"],
        ["check", "a/PART.H", "--report", "json=TOOL.T"],
    ] {
        let ran = folder.run(&args).exits(2);
        assert!(ran.err.contains("would replace a part program"), "{args:?}: {}", ran.err);
    }
    assert_eq!((folder.read("a/PART.H"), folder.read("b/WRONG.H")), (PART.to_owned(), WRONG.to_owned()));
    folder.run(&["compile", "a/PART.H", "-o", "out.txt"]).exits(0);
    folder.run(&["check", "a/PART.H", "-o", "out.txt"]).exits(2);
    let twice = ["check", "a/PART.H", "--report", "sarif=r", "--report", "junit=./r"];
    assert!(folder.run(&twice).exits(2).err.contains("two reports"));
    // An older report, which quotes blocks, is replaced.
    folder.run(&["check", ".", "-o", "report.txt"]).exits(1);
    folder.run(&["check", ".", "-o", "report.txt"]).exits(1);
}

#[test]
fn commands_refuse_what_they_would_not_do() {
    let folder = folder("refused_words");
    for word in ["--statistics", "--exit-zero", "--report=sarif=x.sarif", "--fail-on=note"] {
        folder.run(&["test", ".", word]).exits(2);
        folder.run(&["config", "--show", ".", word]).exits(2);
    }
    let ran = folder.run(&["check", "-", "--files-from", "-"]).exits(2);
    assert!(ran.err.contains("cannot hold a program, too"), "{}", ran.err);
}

#[cfg(unix)]
#[test]
fn a_link_to_a_program_is_a_program() {
    let folder = folder("links");
    std::os::unix::fs::symlink(folder.0.join("a/PART.H"), folder.0.join("b/LINKED.H")).expect("a link");
    let ran = folder.run(&["check", "b", "--format", "junit"]).exits(1);
    assert!(ran.out.contains("LINKED.H"), "{}", ran.out);
}

#[cfg(target_os = "linux")]
#[test]
fn names_that_are_no_text_stay_apart() {
    use std::os::unix::ffi::OsStrExt as _;
    let folder = Folder::new("raw_names");
    for byte in [0xe4, 0xf6] {
        let name = [&b"N"[..], &[byte], b".H"].concat();
        std::fs::write(folder.0.join(std::ffi::OsStr::from_bytes(&name)), WRONG).expect("a file");
    }
    let sarif = folder.run(&["check", ".", "--format", "sarif"]).exits(1).out;
    assert!(sarif.contains("\"uri\":\"N%E4.H\"") && sarif.contains("\"uri\":\"N%F6.H\""), "{sarif}");
    let gitlab = folder.run(&["check", ".", "--format", "gitlab"]).exits(1).json();
    let of = |n: usize, key: &str| gitlab[n][key].clone();
    assert_eq!(gitlab[0]["location"]["path"], "N\\xE4.H");
    assert!(of(0, "fingerprint") != of(1, "fingerprint") && of(0, "location") != of(1, "location"));
    // Each has an output of its own.
    for byte in [0xe4, 0xf6] {
        let name = [&b"N"[..], &[byte], b".H"].concat();
        std::fs::write(folder.0.join(std::ffi::OsStr::from_bytes(&name)), super::cli_run::PART).expect("a file");
    }
    folder.run(&["compile", ".", "--out-dir", "out"]).exits(0);
    assert_eq!(std::fs::read_dir(folder.0.join("out")).expect("outputs").count(), 2);
}
