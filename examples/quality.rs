//! Measures what partc promises of its reliability, and prints a row for each promise: value, goal, kept or missed.
//!
//!     cargo run --release --example quality                    # builds the command, measures it: some minutes
//!     cargo run --release --example quality -- --giant         # a program of a gibibyte, too: needs the room on the disk
//!     cargo run --release --example quality -- --partc FILE    # measures this command
//!     cargo run --release --example quality -- R5 R10          # these rows, and those that come with them
//!     cargo run --release --example quality -- --to-release    # figures of long runs that are older than the source are missed
//!
//! What takes hours is counted elsewhere: `fuzz/run` and `fuzz/counters.toml`. Exit code 1 if a goal is missed.

#![allow(clippy::disallowed_methods, reason = "measurements need not give the same bits on every platform")]

#[allow(dead_code, reason = "the test suite uses more of it")]
#[path = "../tests/suite/book/mod.rs"]
mod book;
#[allow(dead_code, reason = "the test suite uses more of it")]
#[path = "../tests/suite/common.rs"]
mod common;
#[path = "../tests/suite/damage.rs"]
mod damage;
#[path = "../tests/quality/mod.rs"]
mod quality;

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use quality::process::Took;
use quality::{arcs, kills, malformed, names, numbers, same, stops};

/// A promise, and what came of it.
struct Row {
    id: &'static str,
    what: &'static str,
    value: String,
    goal: &'static str,
    kept: bool,
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let given = arguments.iter().position(|argument| argument == "--partc").and_then(|at| arguments.get(at + 1));
    let partc = given.map_or_else(|| built(root), PathBuf::from);
    let partc = std::fs::canonicalize(partc).expect("the command");
    let giant = arguments.iter().any(|argument| argument == "--giant");
    let under = std::env::temp_dir().join(format!("partc-quality-{}", std::process::id()));
    std::fs::create_dir_all(&under).expect("a folder");

    let mut missed = 0;
    let mut show = |rows: Vec<Row>| {
        for Row { id, what, value, goal, kept } in rows {
            missed += u32::from(!kept);
            println!("{id:<4} {} {what:<44} {value}   (goal: {goal})", if kept { "ok    " } else { "MISSED" });
        }
    };
    let named: Vec<&String> = arguments.iter().filter(|argument| argument.starts_with('R')).collect();
    let wanted = |rows: &[&str]| named.is_empty() || named.iter().any(|name| rows.contains(&name.as_str()));
    if wanted(&["R1", "R18"]) {
        show(counted(root));
        show(vec![counted_of_this_source(root, arguments.iter().any(|argument| argument == "--to-release"))]);
    }
    if wanted(&["R2", "R3", "R4"]) {
        show(damaged());
    }
    if wanted(&["R5", "R6"]) {
        show(endless(&partc, &under));
    }
    if wanted(&["R6", "R7", "R8"]) {
        show(large(&partc, &under, giant));
    }
    if wanted(&["R10"]) {
        show(vec![hostile_names(&partc, &under)]);
    }
    if wanted(&["R11"]) {
        show(vec![killed(&partc, &under)]);
    }
    if wanted(&["R12"]) {
        show(vec![everywhere(&partc, &under)]);
    }
    if wanted(&["R13"]) {
        show(vec![printed_numbers()]);
    }
    if wanted(&["R14"]) {
        show(printed_arcs());
    }
    let _ = std::fs::remove_dir_all(&under);
    println!("{}", if missed == 0 { "every goal is kept".to_owned() } else { format!("{missed} goals are missed") });
    ExitCode::from(u8::from(missed > 0))
}

/// The command as it is shipped, but for link-time optimization.
fn built(root: &Path) -> PathBuf {
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned());
    let built = Command::new(cargo).args(["build", "--release", "--locked"]).current_dir(root).status();
    assert!(built.is_ok_and(|status| status.success()), "partc cannot be built");
    let own = std::env::current_exe().expect("a program");
    let name = format!("partc{}", std::env::consts::EXE_SUFFIX);
    own.parent().and_then(Path::parent).expect("the folder of the build").join(name)
}

/// What other runs counted.
fn counted(root: &Path) -> Vec<Row> {
    let text = std::fs::read_to_string(root.join("fuzz/counters.toml")).expect("fuzz/counters.toml");
    let counters: toml::Table = text.parse().expect("counters");
    let number = |table: &str, key: &str| {
        let value = counters.get(table).and_then(|table| table.get(key));
        value.and_then(|value| value.as_float().or(value.as_integer().map(|n| n as f64))).unwrap_or(0.0)
    };
    let fuzz = counters.get("fuzz").and_then(toml::Value::as_table).cloned().unwrap_or_default();
    let sum = |key: &str| {
        let values = fuzz.values().filter_map(|target| target.get(key)?.as_integer());
        values.sum::<i64>()
    };
    let (runs, failures) = (sum("executions"), sum("failures"));
    let coverage = number("coverage", "lines");
    let (tried, caught) = (number("mutation", "tried"), number("mutation", "caught"));
    let score = 100.0 * caught / tried.max(1.0);
    vec![
        Row {
            id: "R1",
            what: "runs of the fuzz targets",
            value: format!("{runs} of {} targets, {failures} failures", fuzz.len()),
            goal: ">= 100000000 of >= 8 targets, 0 failures",
            kept: runs >= 100_000_000 && fuzz.len() >= 8 && failures == 0,
        },
        Row {
            id: "R18",
            what: "lines that tests run",
            value: format!("{coverage:.1} %"),
            goal: ">= 90 %",
            kept: coverage >= 90.0,
        },
        Row {
            id: "R18",
            what: "changes of the source that tests notice",
            value: format!("{score:.0} % of a sample of {tried:.0}"),
            goal: ">= 75 %",
            kept: tried > 0.0 && score >= 75.0,
        },
    ]
}

/// How many commits changed the compiler since the figures of long runs were counted. A release has figures of its own source.
fn counted_of_this_source(root: &Path, to_release: bool) -> Row {
    let text = std::fs::read_to_string(root.join("fuzz/counters.toml")).expect("fuzz/counters.toml");
    let counters: toml::Table = text.parse().expect("counters");
    let commit = |table: Option<&toml::Value>, key: &str| Some(table?.get(key)?.as_str()?.to_owned());
    let fuzzed = counters.get("fuzz").and_then(toml::Value::as_table).into_iter().flat_map(|fuzz| fuzz.values());
    let mut commits: Vec<(&str, Option<String>)> =
        fuzzed.map(|target| ("fuzz", commit(Some(target), "since"))).collect();
    commits.extend(["mutation", "coverage"].map(|name| (name, commit(counters.get(name), "commit"))));
    commits.dedup();
    let age = |commit: &Option<String>| commit.as_ref().and_then(|commit| changes_since(root, commit));
    let ages: Vec<(&str, Option<u32>)> = commits.iter().map(|(name, commit)| (*name, age(commit))).collect();
    let shown: Vec<String> = ages
        .iter()
        .map(|(name, age)| {
            format!("{name} {}", age.map_or("of no known commit".to_owned(), |age| format!("{age} commits ago")))
        })
        .collect();
    Row {
        id: "R18",
        what: "age of these figures",
        value: shown.join(", "),
        goal: if to_release { "of this source" } else { "of this source, for a release" },
        kept: !to_release || ages.iter().all(|(_, age)| *age == Some(0)),
    }
}

/// Commits since then that changed what is compiled, or what judges it.
fn changes_since(root: &Path, commit: &str) -> Option<u32> {
    let range = format!("{commit}..HEAD");
    let listed = Command::new("git")
        .args(["rev-list", "--count", &range, "--", "src", "grammar", "tests", "fuzz", "Cargo.lock"])
        .current_dir(root)
        .output();
    String::from_utf8(listed.ok().filter(|listed| listed.status.success())?.stdout).ok()?.trim().parse().ok()
}

fn damaged() -> Vec<Row> {
    // What panics is counted, and shown below.
    let hook = std::panic::take_hook();
    std::panic::set_hook(Box::new(|_| {}));
    let tried = malformed::malformed(malformed::Amount { cut: 20, damaged: 60, rounds: 270 });
    std::panic::set_hook(hook);
    for program in tried.panics.iter().take(3) {
        println!("---- panics:\n{program}");
    }
    vec![
        Row {
            id: "R2",
            what: "malformed programs",
            value: format!("{}, {} of them cut at every byte of {}", tried.programs, tried.cuts, tried.cut),
            goal: ">= 10000, cut at every byte of >= 50",
            kept: tried.programs >= 10_000 && tried.cut >= 50,
        },
        Row {
            id: "R3",
            what: "panics, outputs in spite of an error",
            value: format!("{}, {}", tried.panics.len(), tried.outputs),
            goal: "0, 0",
            kept: tried.panics.is_empty() && tried.outputs == 0,
        },
        Row {
            id: "R4",
            what: "findings without a place",
            value: format!("{} of {}", tried.unlocated, tried.findings),
            goal: "0",
            kept: tried.unlocated == 0 && tried.findings > 0,
        },
    ]
}

fn endless(partc: &Path, under: &Path) -> Vec<Row> {
    let ended = stops::endless(partc, under);
    let refused = |took: &Took| took.code == Some(1);
    let slowest = ended.iter().max_by_key(|(_, took)| took.time).expect("programs");
    let largest = ended.iter().map(|(_, took)| took.memory).max().unwrap_or(0);
    let wrong: Vec<_> = ended.iter().filter(|(_, took)| !refused(took)).map(|(what, _)| *what).collect();
    vec![
        Row {
            id: "R5",
            what: "programs without an end",
            value: format!(
                "{}, at most {:.1} s ({}) and {} MiB{}",
                ended.len(),
                slowest.1.time.as_secs_f64(),
                slowest.0,
                largest >> 10,
                if wrong.is_empty() { String::new() } else { format!("; not refused: {}", wrong.join(", ")) },
            ),
            goal: "refused within 5 s and 300 MiB",
            kept: wrong.is_empty() && slowest.1.time.as_secs_f64() <= 5.0 && largest >> 10 <= 300,
        },
        Row {
            id: "R6",
            what: "memory of a program of repeats",
            value: format!("{} MiB", ended[0].1.memory >> 10),
            goal: "<= 64 MiB",
            kept: ended[0].1.memory >> 10 <= 64,
        },
    ]
}

fn large(partc: &Path, under: &Path, giant: bool) -> Vec<Row> {
    let deep = stops::deep(partc, under);
    let computed = deep.iter().filter(|(levels, ..)| *levels == 200).all(|(_, _, took)| took.code == Some(0));
    let bracketed: Vec<&Took> = deep.iter().filter(|(levels, ..)| *levels > 200).map(|(_, _, took)| took).collect();
    let longest = bracketed.iter().map(|took| took.time.as_millis()).max().unwrap_or(0);
    let lines = stops::long_lines(partc, under);
    let said = lines.iter().filter(|(_, took)| took.code == Some(1) && took.said.contains("P0003")).count();
    let mib = if giant { 1024 } else { 128 };
    let most = 20.0 * f64::from(mib) / 1024.0;
    let (checked, compiled) = stops::giant(partc, under, mib as usize);
    let (time, memory) = (checked.time.as_secs_f64(), checked.memory.max(compiled.memory) >> 10);
    vec![
        Row {
            id: "R7",
            what: "levels of a formula",
            value: format!(
                "200 {}, 1000000 brackets {} within {longest} ms",
                if computed { "are computed" } else { "are REFUSED" },
                if bracketed.iter().all(|took| took.code == Some(1)) { "refused" } else { "NOT refused" },
            ),
            goal: "200 are computed, 1000000 refused within 100 ms",
            kept: computed && longest <= 100 && bracketed.iter().all(|took| took.code == Some(1)),
        },
        Row {
            id: "R8",
            what: "lines of more than a mebibyte",
            value: format!("a finding in {said} of {} languages", lines.len()),
            goal: "in all",
            kept: said == lines.len(),
        },
        Row {
            id: "R8",
            what: "check of a giant program",
            value: format!("{mib} MiB in {time:.1} s"),
            goal: "1024 MiB in 20 s",
            kept: checked.code == Some(0) && time <= most,
        },
        Row {
            id: "R6",
            what: "memory of a giant program",
            value: format!("{memory} MiB for {mib} MiB"),
            goal: "<= 64 MiB + 3 x input",
            kept: compiled.code == Some(0) && memory <= 64 + 3 * mib as u64,
        },
    ]
}

fn hostile_names(partc: &Path, under: &Path) -> Row {
    let tried = names::escapes(partc, under);
    tried.wrong.iter().take(5).for_each(|name| println!("---- {name}"));
    Row {
        id: "R10",
        what: "hostile names that lead out",
        value: format!("{} of {} in {} programs", tried.wrong.len(), tried.names, tried.programs),
        goal: "0 of >= 200",
        kept: tried.wrong.is_empty() && tried.names >= 200,
    }
}

fn killed(partc: &Path, under: &Path) -> Row {
    let seen = kills::kills(partc, &quality::process::folder(under, "kills"), 1_000);
    Row {
        id: "R11",
        what: "partial files after kills",
        value: format!("{} of {} runs, {} killed in time", seen.broken.len(), seen.started, seen.killed),
        goal: "0 of >= 1000",
        kept: seen.broken.is_empty() && seen.started >= 1_000 && seen.killed * 4 > seen.started,
    }
}

fn everywhere(partc: &Path, under: &Path) -> Row {
    let seen = same::same(partc, under, 4);
    let differ = if seen.differ.is_empty() { String::new() } else { format!("; differ: {}", seen.differ.join(", ")) };
    Row {
        id: "R12",
        what: "the same bytes whatever the circumstances",
        value: format!("{} programs, {} outputs, {} ways{differ}", seen.programs, seen.outputs, seen.ways),
        goal: "threads, folder, language, time zone: no difference",
        kept: seen.differ.is_empty() && seen.outputs > 100,
    }
}

fn printed_numbers() -> Row {
    let numbers = numbers::numbers(100_000_000, 200_000);
    let wrong = numbers.wrong.as_ref().map(|wrong| format!("; wrong: {wrong:?}")).unwrap_or_default();
    Row {
        id: "R13",
        what: "printed numbers",
        value: format!("{} and around {} ties{wrong}", numbers.numbers, numbers.ties),
        goal: "100000000, each the nearest decimal",
        kept: numbers.wrong.is_none() && numbers.numbers >= 100_000_000,
    }
}

fn printed_arcs() -> Vec<Row> {
    [(3, "printed arcs, three decimals"), (4, "printed arcs, four decimals")]
        .map(|(decimals, what)| {
            let arcs = arcs::arcs(2_000, decimals);
            let unread = arcs.unread.as_ref().map(|why| format!("; unread: {why}")).unwrap_or_default();
            Row {
                id: "R14",
                what,
                value: format!("{} arcs, radii differ by {:.3} units{unread}", arcs.arcs, arcs.worst),
                goal: "<= 1.5 units",
                kept: arcs.worst <= 1.5 && arcs.arcs > 1_000 && arcs.unread.is_none(),
            }
        })
        .into()
}
