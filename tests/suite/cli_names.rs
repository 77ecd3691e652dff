//! The command line with programs that call others by name: which file or program of an archive runs.

use std::fs;
use std::io::{Seek as _, SeekFrom, Write as _};
use std::sync::atomic::{AtomicBool, Ordering};

use super::cli_run::{Folder, HOLE, Ran, body, caller};

/// The folders that a SINUMERIK searches, in its order, and what stands for them here.
const PLACES: [(&str, &str); 5] = [
    ("/_N_WKS_DIR/_N_A_WPD", ""),
    ("/_N_SPF_DIR", "spf/"),
    ("/_N_CUS_DIR", "cus/"),
    ("/_N_CMA_DIR", "aaa/"),
    ("/_N_CST_DIR", "cst/"),
];

const MAIN: &str = "%_N_MAIN_MPF\n;$PATH=/_N_WKS_DIR/_N_A_WPD\nN10 G17 G90 G54 G0 X0 Y0 Z10\nN20 DRILL\nN30 M30\n";
const ROOTS: &str = "[include.roots]\n\"/_N_CST_DIR\" = \"cst\"\n\"/_N_CMA_DIR\" = \"aaa\"\n\"/_N_CUS_DIR\" = \"cus\"\n\"/_N_SPF_DIR\" = \"spf\"\n";

/// The moves behind the first of a compiled `MAIN.MPF`.
#[track_caller]
fn moves(folder: &Folder) -> Vec<String> {
    let ran = folder.run(&["compile", "MAIN.MPF", "-o", "-", "--format", "concise"]).exits(0).quietly();
    let moves = body(&ran.out).into_iter().filter(|line| line.contains('Z')).skip(1);
    moves.map(str::to_owned).collect()
}

/// Two programs DRILL, each in an archive or in a folder, in both orders: the one whose folder is searched first runs.
#[test]
fn archives_and_folders_are_searched_in_one_order() {
    let folder = Folder::new("names_matrix");
    for (first, second) in
        (0..PLACES.len()).flat_map(|first| (first + 1..PLACES.len()).map(move |other| (first, other)))
    {
        for (in_archive, swapped) in [([true, true], false), ([true, true], true), ([true, false], false)]
            .into_iter()
            .chain([([false, true], false), ([false, false], false)])
        {
            let both = [first, second];
            let mut units: Vec<String> = Vec::new();
            folder.write("partc.toml", ROOTS);
            for (place, in_archive) in both.into_iter().zip(in_archive) {
                let (path, dir) = PLACES[place];
                let text = format!("%_N_DRILL_SPF\n;$PATH={path}\nG0 Z{}\nM17\n", place + 1);
                match in_archive {
                    true => units.push(text),
                    false => folder.write(&format!("{dir}DRILL.SPF"), &text),
                }
            }
            if swapped {
                units.reverse();
            }
            folder.write("MAIN.MPF", &format!("{MAIN}{}", units.concat()));
            assert_eq!(moves(&folder), [format!("G0 Z{}", first + 1)], "{first} {second} {in_archive:?} {swapped}");
            both.into_iter().for_each(|place| drop(fs::remove_file(folder.0.join(PLACES[place].1).join("DRILL.SPF"))));
        }
    }
}

#[test]
fn roots_are_searched_in_the_order_of_the_control() {
    let folder = Folder::new("names_roots").with(&[
        ("partc.toml", "[include]\nroots = { \"/_N_SPF_DIR\" = \"b\", \"/_N_CMA_DIR\" = \"a\" }\n"),
        ("MAIN.MPF", "N10 G17 G90 G54 G0 X0 Y0 Z10\nN20 DRILL\nN25 CALL \"/_N_CMA_DIR/_N_DRILL_SPF\"\nN30 M30\n"),
        ("a/DRILL.SPF", "G0 Z3\nM17\n"),
        ("b/DRILL.SPF", "G0 Z1\nM17\n"),
    ]);
    assert_eq!(moves(&folder), ["G0 Z1", "G0 Z3"]);
}

#[test]
fn the_folder_of_the_main_program_counts_whoever_calls() {
    let folder = Folder::new("names_current").with(&[
        ("partc.toml", "[include]\nroots.\"/_N_SPF_DIR\" = \"spf\"\n"),
        ("main/M.MPF", "N10 G17 G90 G54 G0 X0 Y0 Z10\nN20 OUTER\nN30 M30\n"),
        ("main/INNER.SPF", "G0 Z1\nM17\n"),
        ("spf/OUTER.SPF", "INNER\nM17\n"),
        ("spf/INNER.SPF", "G0 Z2\nM17\n"),
    ]);
    let ran = folder.run(&["compile", "main/M.MPF", "-o", "-"]).exits(0).quietly();
    assert!(ran.out.contains("\nG0 Z1\n") && !ran.out.contains("Z2"), "{}", ran.out);
    // Run by itself, OUTER is the main program.
    let ran = folder.run(&["compile", "spf/OUTER.SPF", "-o", "-"]).exits(0);
    assert!(ran.out.contains("\nG0 Z2\n"), "{}", ran.out);
}

#[test]
fn two_programs_of_one_rank_are_refused_with_both_places() {
    let folder = Folder::new("names_rank").with(&[
        ("MAIN.MPF", "N10 G17 G90 G54 G0 X0 Y0 Z10\nN20 DRILL\nN30 M30\n"),
        ("DRILL.MPF", "G0 Z5\nM17\n"),
        ("DRILL.SPF", "G0 Z6\nM17\n"),
    ]);
    let check = |says: &[&str]| {
        let ran = folder.run(&["compile", "MAIN.MPF", "-o", "-"]).exits(1);
        says.iter().for_each(|text| assert!(ran.err.contains(text), "{text} is missing in:\n{}", ran.err));
        assert!(ran.out.is_empty());
    };
    check(&["S2047", "DRILL.SPF", "DRILL.MPF", "called_first"]);
    folder.write("partc.toml", "[control]\ncalled_first = \"spf\"\n");
    assert_eq!(moves(&folder), ["G0 Z6"]);
    folder.write("partc.toml", "[control]\ncalled_first = \"mpf\"\n");
    assert_eq!(moves(&folder), ["G0 Z5"]);
    // A copy of the folder under the other name that it has on disks.
    folder.write("partc.toml", "[include]\nroots.\"/\" = \"nc\"\n");
    folder.write("MAIN.MPF", "N10 G17 G90 G54 G0 X0 Y0 Z10\nN20 MILL\nN30 M30\n");
    folder.write("nc/SPF.DIR/MILL.SPF", "G0 Z1\nM17\n");
    assert_eq!(moves(&folder), ["G0 Z1"]);
    folder.write("nc/_N_SPF_DIR/MILL.SPF", "G0 Z2\nM17\n");
    check(&["S2046", "nc/SPF.DIR/MILL.SPF", "nc/_N_SPF_DIR/MILL.SPF"]);
}

#[test]
fn two_roots_for_one_folder_are_refused() {
    let folder = Folder::new("names_two_roots").with(&[("A.H", &caller("HOLE"))]);
    for (one, other) in [("/_N_SPF_DIR", "/_n_spf_dir/"), ("/_N_SPF_DIR", "/SPF.DIR"), ("TNC:", "tnc:\\\\")] {
        folder.write("partc.toml", &format!("[include.roots]\n\"{one}\" = \"a\"\n\"{other}\" = \"b\"\n"));
        folder.run(&["check", "A.H"]).exits(2).says("are one folder of the control");
    }
}

/// A TNC looks beside the program that calls; what lies elsewhere is taken where only one does, and that is said.
#[test]
fn klartext_names_mean_the_folder_of_the_caller() {
    let hole = |z: u32| HOLE.replace("Z-5", &format!("Z-{z}"));
    let folder = Folder::new("names_tnc").with(&[
        ("partc.toml", "[include]\nroots = { \"TNC:\" = \"tnc\", \"PLC:\" = \"plc\" }\n"),
        ("A.H", &caller("TNC:\\\\SUB\\\\B.H").replace("\\\\", "\\")),
        ("tnc/SUB/B.H", "0 BEGIN PGM B MM\n1 CALL PGM HOLE.H\n2 END PGM B MM\n"),
        ("tnc/SUB/HOLE.H", &hole(1)),
        ("HOLE.H", &hole(2)),
        ("tnc/HOLE.H", &hole(3)),
    ]);
    let run = || folder.run(&["compile", "A.H", "-o", "-", "--format", "concise"]);
    let ran = run().exits(0).quietly();
    assert!(ran.out.contains("G1 Z-1 F150"), "{}", ran.out);
    fs::remove_file(folder.0.join("tnc/SUB/HOLE.H")).expect("a file");
    // Beside the main program, and in a root: neither goes before the other.
    let ran = run().exits(1).says("P0103").says("HOLE.H, tnc/HOLE.H");
    assert!(ran.out.is_empty());
    fs::remove_file(folder.0.join("HOLE.H")).expect("a file");
    let ran = run().exits(0).says("P0107").says("tnc/HOLE.H");
    assert!(ran.out.contains("G1 Z-3 F150"), "{}", ran.out);
    folder.write("plc/HOLE.H", &hole(4));
    run().exits(1).says("P0103").says("plc/HOLE.H");
    // A file without extension has no rank among those with one.
    folder.write("tnc/SUB/B.H", "0 BEGIN PGM B MM\n1 CALL PGM HOLE\n2 END PGM B MM\n");
    folder.write("tnc/SUB/HOLE", &hole(5));
    folder.write("tnc/SUB/HOLE.H", &hole(1));
    run().exits(1).says("P0103").says("tnc/SUB/HOLE, tnc/SUB/HOLE.H");
}

#[test]
fn mtc200_numbers_that_two_files_have_are_refused() {
    let program = |z: u32| format!("G00 Z{z}\nRTS\n");
    let folder = Folder::new("names_mtc").with(&[
        ("partc.toml", "[include]\nroots.\"NC:\" = \"lib\"\n"),
        ("A.npg", "G00 X0 Y0 Z5\nJSR P5\nRET\n"),
        ("5.npg", &program(1)),
    ]);
    let run = || folder.run(&["compile", "A.npg", "-o", "-", "--format", "concise"]);
    assert!(run().exits(0).out.contains("\nG0 Z1\n"));
    folder.write("5.dat", &program(2));
    run().exits(1).says("P0103").says("5.dat").says("5.npg");
    fs::remove_file(folder.0.join("5.dat")).expect("a file");
    folder.write("lib/5.dat", &program(3));
    run().exits(1).says("P0103").says("lib/5.dat");
}

#[test]
fn stand_ins_lie_beside_their_configuration() {
    let folder = Folder::new("names_stand_in").with(&[
        ("partc.toml", "[programs]\nFOO = { file = \"stubs/FOO.SPF\" }\n"),
        ("stubs/FOO.SPF", "G0 Z1\nM17\n"),
        ("sub/P.MPF", "N10 G17 G90 G54 G0 X0 Y0 Z10\nN20 FOO\nN30 M30\n"),
        // Beside the program nothing is looked for.
        ("sub/stubs/FOO.SPF", "G0 Z2\nM17\n"),
    ]);
    for (program, from) in [("sub/P.MPF", ""), ("P.MPF", "sub")] {
        let folder = Folder(folder.0.join(from));
        let ran = folder.run(&["compile", program, "-o", "-"]).exits(0).quietly();
        assert!(ran.out.contains("\nG0 Z1\n"), "{}", ran.out);
    }
    fs::remove_file(folder.0.join("stubs/FOO.SPF")).expect("a file");
    let concise = ["compile", "sub/P.MPF", "-o", "-", "--format", "concise"];
    folder.run(&concise).exits(1).says("[S2002]").says("/stubs/FOO.SPF`");
    // A configuration that nobody named opens nothing outside of its folder.
    let inner = Folder::new("names_stand_in/out/inner").with(&[
        ("../FOO.SPF", "G0 Z1\nM17\n"),
        ("partc.toml", "[programs]\nFOO = { file = \"../FOO.SPF\" }\n"),
        ("P.MPF", "N10 G17 G90 G54 G0 X0 Y0 Z10\nN20 FOO\nN30 M30\n"),
    ]);
    inner.run(&["compile", "P.MPF", "-o", "-"]).exits(2).says("leads out");
    inner.run(&["compile", "P.MPF", "-o", "-", "--config", "partc.toml"]).exits(0);
}

#[test]
fn lists_of_files_name_what_would_go_before() {
    let folder = Folder::new("names_deps").with(&[
        ("partc.toml", ROOTS),
        ("MAIN.MPF", MAIN),
        ("aaa/DRILL.SPF", "G0 Z4\nM17\n"),
        ("spf/X.SPF", "M17\n"),
    ]);
    folder.run(&["compile", "MAIN.MPF", "--deps", "d.json", "--deps-format", "json"]).exits(0);
    let list: serde_json::Value = serde_json::from_str(&folder.read("d.json")).expect("JSON");
    let names = |key: &str| -> Vec<String> {
        let list = list["rules"][0][key].as_array().expect("a list");
        list.iter().map(|name| name.as_str().expect("a name").to_owned()).collect()
    };
    let (inputs, absent) = (names("inputs"), names("absent"));
    assert!(inputs.contains(&"aaa/DRILL.SPF".to_owned()), "{inputs:?}");
    for before in ["DRILL.SPF", "DRILL.MPF", "spf/DRILL.SPF", "cus/DRILL.SPF"] {
        assert!(absent.contains(&before.to_owned()), "{before}: {absent:?}");
    }
    assert!(!absent.iter().any(|name| name.starts_with("cst/")), "{absent:?}");
}

// Roots that `init` finds.

#[test]
fn init_names_folders_of_a_backup_as_the_control_does() {
    let call = "N10 G17 G90 G54 G0 X0 Y0 Z10\nN20 DRILL\nN25 MILL\nN30 M30\n";
    // The program lies in no folder of the backup, so that nothing is found without a root.
    let folder = Folder::new("names_init").with(&[
        ("parts/A.MPF", call),
        ("SPF.DIR/DRILL.SPF", "G0 Z1\nM17\n"),
        ("CMA.DIR/DRILL.SPF", "G0 Z3\nM17\n"),
        ("CMA.DIR/MILL.SPF", "G0 Z4\nM17\n"),
        ("WKS.DIR/B.WPD/DRILL.SPF", "G0 Z9\nM17\n"),
    ]);
    folder.run(&["init", "."]).exits(0);
    let config = folder.read("partc.toml");
    for wanted in ["#roots.\"/_N_SPF_DIR\" = \"SPF.DIR\"", "#roots.\"/_N_CMA_DIR\" = \"CMA.DIR\""] {
        assert!(config.contains(wanted), "{wanted} is missing in:\n{config}");
    }
    assert!(!config.contains("ignore") && !config.contains("WPD"), "{config}");
    let filled: String = config.lines().map(|line| line.replace("#roots", "roots") + "\n").collect();
    folder.write("partc.toml", &filled);
    let ran = folder.run(&["compile", "parts/A.MPF", "-o", "-"]).exits(0).quietly();
    assert!(ran.out.contains("\nG0 Z1\nG0 Z4\n"), "{}", ran.out);
}

// Files that change.

/// Runs partc while somebody rewrites a file in place, over and over.
fn run_while_written(folder: &Folder, file: &str, args: &[&str]) -> Ran {
    run_while(folder, file, [";A\n", ";B\n"], args)
}

/// The same with the two texts that its start changes between. Where the writer did not get its turn while partc read, the
/// file did not change: it is run again.
fn run_while(folder: &Folder, file: &str, texts: [&str; 2], args: &[&str]) -> Ran {
    for _ in 0..50 {
        let ran = run_beside(folder, file, texts, args);
        if ran.code != Some(0) {
            return ran;
        }
    }
    run_beside(folder, file, texts, args)
}

fn run_beside(folder: &Folder, file: &str, texts: [&str; 2], args: &[&str]) -> Ran {
    let stop = AtomicBool::new(false);
    std::thread::scope(|scope| {
        scope.spawn(|| {
            let mut open = fs::OpenOptions::new().write(true).open(folder.0.join(file)).expect("a file");
            let mut flip = false;
            while !stop.load(Ordering::Relaxed) {
                flip = !flip;
                // The same length: only the time tells.
                open.seek(SeekFrom::Start(0)).expect("a place");
                open.write_all(texts[usize::from(flip)].as_bytes()).expect("it is written");
            }
        });
        let ran = folder.run(args);
        stop.store(true, Ordering::Relaxed);
        ran
    })
}

#[test]
fn a_file_that_changes_while_it_is_read_gives_no_output() {
    let blocks: String = (0..4000).map(|n| format!("G1 X{}.{:03} Z-1\n", n % 90, n % 1000)).collect();
    let sub = format!(";A\n{blocks}M17\n");
    let folder = Folder::new("names_changes").with(&[
        ("SUB.SPF", &sub),
        ("CALLS.MPF", "G17 G90 G54 G0 X0 Y0 Z5\nF100 S100 M3\nSUB\nM30\n"),
        ("MAIN.MPF", &format!(";A\nG17 G90 G54 G0 X0 Y0 Z5\nF100 S100 M3\n{blocks}M30\n")),
    ]);
    for (file, main) in [("MAIN.MPF", "MAIN.MPF"), ("SUB.SPF", "CALLS.MPF")] {
        let commands: [&[&str]; 9] = [
            &["compile", main, "-o", "-"],
            &["compile", main, "-o", "out.ngc"],
            &["check", main],
            &["trace", main, "-o", "-"],
            &["stats", main],
            &["plot", main, "-o", "out.svg"],
            &["report", main, "-o", "out.html"],
            &["key", main],
            &["diff", main, main],
        ];
        for args in commands {
            let ran = run_while_written(&folder, file, args).exits(2).says(file).says("changed while it was read");
            assert!(ran.out.is_empty(), "{args:?}: {}", ran.out);
            assert!(!["out.ngc", "out.svg", "out.html"].iter().any(|name| folder.has(name)), "{args:?}");
        }
        // When nobody writes any more, all is well.
        folder.run(&["compile", main, "-o", "-"]).exits(0);
    }
    // A configuration, and a table that it names.
    folder.write("partc.toml", "[tools]\ntable = \"tools.csv\"\n");
    folder.write("tools.csv", "number,radius\n5,5\n");
    folder.run(&["compile", "MAIN.MPF", "-o", "-"]).exits(0);
    for (file, [one, other]) in [("partc.toml", ["[tools]"; 2]), ("tools.csv", ["number"; 2])] {
        let ran = run_while(&folder, file, [one, other], &["compile", "MAIN.MPF", "-o", "-"]);
        assert!(ran.exits(2).says(file).says("changed while it was read").out.is_empty());
    }
}

/// A program that is replaced under its name is another file: the one that was read is whole, and is not the one that is there.
#[test]
fn a_file_that_is_replaced_while_it_is_read_gives_no_output() {
    let blocks: String = (0..4000).map(|n| format!("G1 X{}.{:03} Z-1\n", n % 90, n % 1000)).collect();
    let main = format!("G17 G90 G54 G0 X0 Y0 Z5\nF100 S100 M3\n{blocks}M30\n");
    let folder = Folder::new("names_replaced").with(&[("MAIN.MPF", &main)]);
    let stop = AtomicBool::new(false);
    std::thread::scope(|scope| {
        scope.spawn(|| {
            while !stop.load(Ordering::Relaxed) {
                fs::write(folder.0.join("new"), &main).expect("a file");
                fs::rename(folder.0.join("new"), folder.0.join("MAIN.MPF")).expect("a file");
            }
        });
        let run = || folder.run(&["compile", "MAIN.MPF", "-o", "-"]);
        let ran = (0..50).map(|_| run()).find(|ran| ran.code != Some(0)).unwrap_or_else(run);
        stop.store(true, Ordering::Relaxed);
        assert!(ran.exits(2).says("MAIN.MPF: changed while it was read").out.is_empty());
    });
}

/// On a control upper and lower case are one, so that two such files are one program, and nobody knows which.
#[cfg(target_os = "linux")]
#[test]
fn names_that_differ_in_case_alone_are_refused() {
    let main = "N10 G17 G90 G54 G0 X0 Y0 Z10\nN20 DRILL\nN30 M30\n";
    let folder = Folder::new("names_case").with(&[("MAIN.MPF", main), ("DRILL.SPF", "G0 Z5\nM17\n")]);
    assert_eq!(moves(&folder), ["G0 Z5"]);
    folder.write("drill.spf", "G0 Z6\nM17\n");
    let ran = folder.run(&["compile", "MAIN.MPF", "-o", "-"]).exits(1).says("P0103").says("DRILL.SPF, drill.spf");
    assert!(ran.out.is_empty());
    // In a root, too.
    let folder = Folder::new("names_case_root").with(&[
        ("MAIN.MPF", main),
        ("partc.toml", "[include]\nroots.\"/_N_SPF_DIR\" = \"spf\"\n"),
        ("spf/DRILL.SPF", "G0 Z5\nM17\n"),
        ("spf/Drill.SPF", "G0 Z6\nM17\n"),
    ]);
    folder.run(&["compile", "MAIN.MPF", "-o", "-"]).exits(1).says("P0103");
    // And for a TNC.
    let folder = Folder::new("names_case_tnc").with(&[("A.H", &caller("HOLE")), ("HOLE.H", HOLE), ("hole.h", HOLE)]);
    folder.run(&["check", "A.H"]).exits(1).says("P0103");
}

/// A file beside the main program lies there, or where its own line says: both readings lead to one program.
#[test]
fn a_neighbour_that_lies_elsewhere_by_its_line_has_no_rival() {
    let own = |dir: &str, z: i32| format!("%_N_DRILL_SPF\n;$PATH=/_N_{dir}_DIR\nG0 Z{z}\nM17\n");
    let folder = Folder::new("names_line").with(&[
        ("MAIN.MPF", "N10 G17 G90 G54 G0 X0 Y0 Z10\nN20 DRILL\nN30 M30\n"),
        ("DRILL.SPF", &own("CUS", 5)),
        ("partc.toml", "[include]\nroots.\"/_N_SPF_DIR\" = \"spf\"\n"),
        ("spf/OTHER.SPF", "M17\n"),
    ]);
    assert_eq!(moves(&folder), ["G0 Z5"]);
    folder.write("spf/DRILL.SPF", "G0 Z6\nM17\n");
    let both = |folder: &Folder| {
        let ran = folder.run(&["compile", "MAIN.MPF", "-o", "-"]).exits(1).says("S2046").says("spf/DRILL.SPF");
        assert!(ran.out.is_empty());
    };
    both(&folder);
    // The main program names a folder of its own.
    folder.write(
        "MAIN.MPF",
        "%_N_MAIN_MPF\n;$PATH=/_N_WKS_DIR/_N_A_WPD\nN10 G17 G90 G54 G0 X0 Y0 Z10\nN20 DRILL\nN30 M30\n",
    );
    both(&folder);
}

#[cfg(unix)]
#[test]
fn a_pipe_is_no_program_that_is_called() {
    let folder = Folder::new("names_pipe")
        .with(&[("MAIN.MPF", "N10 G17 G90 G54 G0 X0 Y0 Z10\nN20 DRILL\nN30 M30\n"), ("A.H", &caller("HOLE"))]);
    for name in ["DRILL.SPF", "HOLE.H"] {
        let made = std::process::Command::new("mkfifo").arg(folder.0.join(name)).status();
        assert!(made.expect("mkfifo runs").success());
    }
    for main in ["MAIN.MPF", "A.H"] {
        folder.run(&["check", main]).exits(1).says("P0105").says("is a pipe");
    }
}
