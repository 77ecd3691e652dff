//! A backup of a SINUMERIK: the folders of the control beside that of a program are found by their names.

use super::cli_run::{Folder, body};

const DRILL: &str = "N10 G17 G90 G54 G0 X0 Y0 Z10\nN20 DRILL\nN30 M30\n";

fn sub(z: u32) -> String {
    format!("G0 Z{z}\nM17\n")
}

fn moves(folder: &Folder, program: &str) -> Vec<String> {
    let out = folder.run(&["compile", program, "-o", "-"]).exits(0).out;
    body(&out).iter().filter(|line| line.starts_with("G0 Z")).map(|line| (*line).to_owned()).collect()
}

#[test]
fn sibling_folders_stand_for_those_of_the_control() {
    // The spellings of backups, archives and USB sticks; capitals do not matter.
    for [main, subprograms] in [
        ["MPF.DIR", "SPF.DIR"],
        ["_N_MPF_DIR", "_N_SPF_DIR"],
        ["MPF", "SPF"],
        ["mpf.dir", "Spf.Dir"],
        ["WKS.DIR/SHAFT.WPD", "SPF.DIR"],
        ["_N_WKS_DIR/_N_SHAFT_WPD", "_N_CUS_DIR"],
        ["CMA.DIR", "CST.DIR"],
    ] {
        let folder = Folder::new("backup_spellings");
        folder.write(&format!("{main}/A.MPF"), DRILL);
        // Files may have the names that they have on the control, too.
        let file = if subprograms.starts_with("_N_") { "_N_DRILL_SPF" } else { "drill.spf" };
        folder.write(&format!("{subprograms}/{file}"), &sub(7));
        let program = format!("{main}/A.MPF");
        assert_eq!(moves(&folder, &program), ["G0 Z7"], "{main}");
        let said = folder.run(&["check", &program]).exits(0).err;
        assert_eq!(said.matches("note[S8039]").count(), 1, "{said}");
        assert!(said.contains(&format!("`{subprograms}` stands for `/_N_")), "{said}");
        // No configuration says it, so that none is needed.
        folder.run(&["compile", &program, "-o", "-", "--isolated"]).exits(0);
        // From inside, too.
        let inside = folder.0.join(main);
        let here = std::process::Command::new(env!("CARGO_BIN_EXE_partc"))
            .args(["check", "A.MPF", "--format", "concise"])
            .current_dir(inside)
            .output()
            .expect("partc runs");
        let said = String::from_utf8_lossy(&here.stderr).into_owned() + &String::from_utf8_lossy(&here.stdout);
        assert!(here.status.success() && said.contains(&format!("../{subprograms}` stands")), "{main}: {said}");
        assert!(!said.contains(&*folder.0.to_string_lossy()), "no path of this machine: {said}");
    }
}

#[test]
fn the_search_keeps_the_order_of_the_control() {
    let folder = Folder::new("backup_order").with(&[
        ("MPF.DIR/A.MPF", DRILL),
        ("CST.DIR/DRILL.SPF", &sub(4)),
        ("CMA.DIR/DRILL.SPF", &sub(3)),
        ("CUS.DIR/DRILL.SPF", &sub(2)),
        ("SPF.DIR/DRILL.SPF", &sub(1)),
        ("WKS.DIR/X.WPD/DRILL.SPF", &sub(9)),
    ]);
    for wanted in 1..=4 {
        assert_eq!(moves(&folder, "MPF.DIR/A.MPF"), [format!("G0 Z{wanted}")]);
        let at = ["SPF", "CUS", "CMA", "CST"][wanted - 1];
        std::fs::remove_file(folder.0.join(format!("{at}.DIR/DRILL.SPF"))).expect("a file");
    }
    // Another workpiece is never searched, and its path leads there.
    folder.run(&["check", "MPF.DIR/A.MPF"]).exits(1).says("S2002");
    folder.write("MPF.DIR/B.MPF", &DRILL.replace("DRILL", "CALL \"/_N_WKS_DIR/_N_X_WPD/_N_DRILL_SPF\""));
    assert_eq!(moves(&folder, "MPF.DIR/B.MPF"), ["G0 Z9"]);
    // What lies beside the program goes before all.
    folder.write("MPF.DIR/DRILL.SPF", &sub(5));
    folder.write("SPF.DIR/DRILL.SPF", &sub(1));
    assert_eq!(moves(&folder, "MPF.DIR/A.MPF"), ["G0 Z5"]);
}

#[test]
fn a_root_of_the_configuration_goes_before_the_name() {
    let folder = Folder::new("backup_roots").with(&[
        ("MPF.DIR/A.MPF", DRILL),
        ("SPF.DIR/DRILL.SPF", &sub(1)),
        ("CMA.DIR/DRILL.SPF", &sub(3)),
        ("new/DRILL.SPF", &sub(2)),
        ("empty/X.SPF", &sub(8)),
        ("whole/SPF.DIR/DRILL.SPF", &sub(6)),
    ]);
    for (key, to, wanted) in [
        ("/_N_SPF_DIR", "new", 2),
        ("/SPF.DIR", "new", 2),
        // It stands for the folder also where it lacks the program.
        ("/_N_SPF_DIR", "empty", 3),
        ("/", "whole", 6),
    ] {
        folder.write("partc.toml", &format!("[include]\nroots = {{ \"{key}\" = \"{to}\" }}\n"));
        assert_eq!(moves(&folder, "MPF.DIR/A.MPF"), [format!("G0 Z{wanted}")], "{key}");
    }
    // It may come from a configuration that is extended.
    folder.write("MPF.DIR/partc.toml", "extend = \"../partc.toml\"\n");
    assert_eq!(moves(&folder, "MPF.DIR/A.MPF"), ["G0 Z6"]);
}

#[test]
fn a_name_alone_makes_no_folder_of_the_control() {
    // The program lies in no such folder, or is in another language.
    for main in ["parts", "SPF.DIR/parts", "A.WPD", "MPFS"] {
        let folder = Folder::new("backup_plain");
        folder.write(&format!("{main}/A.MPF"), DRILL);
        folder.write("SPF/DRILL.SPF", &sub(1));
        folder.write("SPF.DIR/DRILL.SPF", &sub(1));
        let said = folder.run(&["check", &format!("{main}/A.MPF")]).exits(1).says("S2002");
        assert!(!said.err.contains("S8039"), "{}", said.err);
    }
    let call = "0 BEGIN PGM A MM\n1 L X+0 Y+0 R0 FMAX\n2 CALL PGM HOLE\n3 L Z+50 FMAX M30\n4 END PGM A MM\n";
    let folder = Folder::new("backup_klartext").with(&[("MPF/A.H", call), ("SPF/HOLE.H", "0 BEGIN PGM HOLE MM\n")]);
    folder.run(&["check", "MPF/A.H"]).exits(1).says("P0101");
}

#[test]
fn two_copies_of_one_folder_are_refused() {
    let folder = Folder::new("backup_twice").with(&[
        ("MPF/A.MPF", DRILL),
        ("SPF/DRILL.SPF", &sub(1)),
        ("SPF.DIR/OTHER.SPF", &sub(2)),
        ("CMA/DRILL.SPF", &sub(3)),
    ]);
    let said = folder.run(&["check", "MPF/A.MPF", "--format", "concise"]).exits(1).says("P0102");
    assert!(said.err.contains("`SPF` and `SPF.DIR` stand for one folder of the control"), "{}", said.err);
    folder.write("partc.toml", "[include]\nroots = { \"/_N_SPF_DIR\" = \"SPF.DIR\" }\n");
    assert_eq!(moves(&folder, "MPF/A.MPF"), ["G0 Z3"]);
}

#[cfg(unix)]
#[test]
fn links_that_lead_out_are_refused() {
    use std::os::unix::fs::symlink;
    let folder = Folder::new("backup_links").with(&[
        ("shop/MPF/A.MPF", DRILL),
        ("shop/SPF/OTHER.SPF", &sub(2)),
        ("outside/DRILL.SPF", &sub(9)),
        ("shop/CST/DRILL.SPF", &sub(4)),
    ]);
    // A folder.
    symlink("../outside", folder.0.join("shop/CMA")).expect("a link");
    let said = folder.run(&["check", "shop/MPF/A.MPF", "--format", "concise"]).exits(1).says("P0102");
    assert!(said.err.contains("`shop/CMA` is a link that leads out"), "{}", said.err);
    // A cycle of the control is not taken for the one that the folder may hold.
    let cycle = "N10 G17 G90 G54 G0 X0 Y0 Z10\nN20 F100 S1000 M3\nN30 CYCLE81(5,0,2,-9)\nN40 M30\n";
    folder.write("shop/MPF/B.MPF", cycle);
    folder.run(&["check", "shop/MPF/B.MPF"]).exits(1).says("P0102");
    std::fs::remove_file(folder.0.join("shop/CMA")).expect("a link");
    folder.run(&["check", "shop/MPF/B.MPF"]).exits(0);
    // A file.
    symlink("../../outside/DRILL.SPF", folder.0.join("shop/SPF/DRILL.SPF")).expect("a link");
    folder.run(&["check", "shop/MPF/A.MPF"]).exits(1).says("P0102").says("leads");
    // The folder of the program may be reached by a link: the real one counts.
    let folder = Folder::new("backup_link_in").with(&[("real/MPF/A.MPF", DRILL), ("real/SPF/DRILL.SPF", &sub(1))]);
    folder.write("here/SPF/DRILL.SPF", &sub(9));
    symlink("../real/MPF", folder.0.join("here/MPF")).expect("a link");
    assert_eq!(moves(&folder, "here/MPF/A.MPF"), ["G0 Z1"]);
}

#[test]
fn definitions_are_found_in_their_folder() {
    let program = "N10 G17 G90 G54 G0 X0 Y0 Z10\nN20 SAFE=44\nN30 G0 Z=SAFE\nN40 M30\n";
    let folder = Folder::new("backup_definitions")
        .with(&[("CMA/A.SPF", program), ("def/mgud.def", "DEF CHAN REAL SAFE\nM17\n")]);
    assert_eq!(moves(&folder, "CMA/A.SPF"), ["G0 Z44"]);
    let said = folder.run(&["check", "CMA/A.SPF"]).exits(0).err;
    assert!(said.contains("`def` stands for `/_N_DEF_DIR`"), "{said}");
    // A value that the control keeps is asked for by its name and the place of its definition.
    folder.write("CMA/B.SPF", &program.replace("N20 SAFE=44\n", ""));
    let said = folder.run(&["check", "CMA/B.SPF"]).exits(0).says("warning[P2021]");
    assert!(said.err.contains("mgud.def") && said.err.contains("[variables]"), "{}", said.err);
    folder.write("partc.toml", "[variables]\nsafe = 33.0\n");
    assert_eq!(moves(&folder, "CMA/B.SPF"), ["G0 Z33"]);
    assert!(!folder.run(&["check", "CMA/B.SPF"]).exits(0).err.contains("P2021"));
    folder.write("def/mgud.def", "");
    std::fs::rename(folder.0.join("def/mgud.def"), folder.0.join("def/other.def")).expect("a name");
    folder.write("def/_N_MGUD_DEF", "DEF CHAN REAL SAFE\n");
    assert_eq!(moves(&folder, "CMA/B.SPF"), ["G0 Z33"]);
    std::fs::remove_file(folder.0.join("def/_N_MGUD_DEF")).expect("a file");
    folder.write("def/mgud.def", "DEF CHAN REAL SAFE\n");
    // What cannot be read is not passed over.
    std::fs::remove_file(folder.0.join("def/mgud.def")).expect("a file");
    folder.write("def/MGUD.DEF", "DEF CHAN REAL SAFE\n");
    folder.write("DEF.DIR/X.DEF", "");
    folder.run(&["check", "CMA/A.SPF"]).exits(1).says("P0102");
}

#[test]
fn the_files_are_inputs_of_deps_and_of_the_key() {
    let folder = Folder::new("backup_deps").with(&[
        ("MPF.DIR/A.MPF", DRILL),
        ("SPF.DIR/DRILL.SPF", &sub(1)),
        ("CMA.DIR/DRILL.SPF", &sub(2)),
    ]);
    folder.run(&["compile", "MPF.DIR/A.MPF", "-o", "a.ngc", "--deps", "a.json", "--deps-format", "json"]).exits(0);
    let deps = folder.read("a.json");
    assert!(deps.contains("\"SPF.DIR/DRILL.SPF\"") && !deps.contains("CMA.DIR"), "{deps}");
    let key = || folder.run(&["key", "MPF.DIR/A.MPF"]).exits(0).out;
    let first = key();
    folder.write("SPF.DIR/DRILL.SPF", &sub(2));
    let changed = key();
    assert_ne!(first, changed);
    // A folder that comes into being is one that was looked for.
    std::fs::remove_file(folder.0.join("SPF.DIR/DRILL.SPF")).expect("a file");
    let of_cycles = key();
    assert!(of_cycles != changed, "the same file out of another folder is another input");
    folder.run(&["compile", "MPF.DIR/A.MPF", "-o", "a.ngc", "--deps", "a.json", "--deps-format", "json"]).exits(0);
    let deps = folder.read("a.json");
    assert!(deps.contains("SPF.DIR/DRILL.SPF") && deps.contains("_N_CUS_DIR/DRILL.SPF"), "{deps}");
    folder.write("_N_CUS_DIR/DRILL.SPF", &sub(3));
    assert!(key() != of_cycles);
}

#[test]
fn init_asks_for_nothing_that_the_backup_holds() {
    for line in ["", ";$PATH=/_N_MPF_DIR\n"] {
        let folder = Folder::new("backup_init");
        folder.write("MPF.DIR/A.MPF", &format!("%_N_A_MPF\n{line}{DRILL}"));
        folder.write("SPF.DIR/DRILL.SPF", &format!("BUILDER\n{}", sub(1)));
        folder.write("CMA.DIR/BUILDER.SPF", "HEIGHT=5\nM17\n");
        folder.write("DEF.DIR/MGUD.DEF", "DEF CHAN REAL HEIGHT\nM17\n");
        for at in [".", "MPF.DIR", "MPF.DIR/A.MPF"] {
            let config = folder.run(&["init", at, "-o", "-"]).exits(0).out;
            assert!(config.contains("1 compiles as it is"), "{config}");
            assert!(
                !config.contains("DRILL =") && !config.contains("roots") && !config.contains(".DIR_DIR"),
                "{config}"
            );
        }
    }
    // Outside of the folders roots are offered, by the names that programs write.
    let folder = Folder::new("backup_init_roots").with(&[
        ("parts/A.MPF", "N10 G17 G90 G54 G0 X0 Y0 Z10\nN15 HEIGHT=5\nN20 DRILL\nN30 M30\n"),
        ("CMA.DIR/DRILL.SPF", &sub(1)),
        ("CMA.DIR/MGUD.DEF", "DEF CHAN REAL HEIGHT\nM17\n"),
    ]);
    let config = folder.run(&["init", ".", "-o", "-"]).exits(0).out;
    for wanted in ["#roots.\"/_N_CMA_DIR\" = \"CMA.DIR\"", "#roots.\"/_N_DEF_DIR\" = \"CMA.DIR\""] {
        assert!(config.contains(wanted), "{wanted} is missing in:\n{config}");
    }
}

#[test]
fn a_line_that_contradicts_the_folder_is_refused() {
    let of = |line: &str| format!("{line}{DRILL}");
    // The main program: by its line another program runs than by its folder.
    for head in ["", "%_N_A_MPF\n"] {
        let folder = Folder::new("backup_line_main").with(&[
            ("MPF.DIR/A.MPF", &of(&format!("{head};$PATH=/_N_WKS_DIR/_N_A_WPD\n"))),
            ("SPF.DIR/DRILL.SPF", &sub(4)),
            ("WKS.DIR/A.WPD/DRILL.SPF", &sub(5)),
        ]);
        let said = folder.run(&["check", "MPF.DIR/A.MPF", "--format", "concise"]).exits(1).says("S2046");
        assert!(said.err.contains("`/_N_MPF_DIR`") && said.err.contains("`/_N_WKS_DIR/_N_A_WPD`"), "{}", said.err);
        // Also where the folder of the line lacks it.
        std::fs::remove_file(folder.0.join("WKS.DIR/A.WPD/DRILL.SPF")).expect("a file");
        folder.run(&["check", "MPF.DIR/A.MPF"]).exits(1).says("S2046");
        // The other way.
        folder.write("WKS.DIR/A.WPD/B.MPF", &of(&format!("{head};$PATH=/_N_MPF_DIR\n")));
        folder.write("WKS.DIR/A.WPD/DRILL.SPF", &sub(1));
        folder.write("MPF.DIR/DRILL.SPF", &sub(2));
        folder.run(&["check", "WKS.DIR/A.WPD/B.MPF"]).exits(1).says("S2046");
        // Both readings lead to the program beside it.
        std::fs::remove_file(folder.0.join("MPF.DIR/DRILL.SPF")).expect("a file");
        assert_eq!(moves(&folder, "WKS.DIR/A.WPD/B.MPF"), ["G0 Z1"]);
        // The line and the folder agree, whatever the spelling.
        for (at, line) in [("WKS.DIR/A.WPD", "/_N_WKS_DIR/_N_A_WPD"), ("WKS/A_WPD", "/WKS.DIR/a.wpd")] {
            let folder = Folder::new("backup_line_agrees").with(&[("SPF.DIR/DRILL.SPF", &sub(4))]);
            folder.write(&format!("{at}/A.MPF"), &of(&format!("{head};$PATH={line}\n")));
            assert_eq!(moves(&folder, &format!("{at}/A.MPF")), ["G0 Z4"], "{at}");
        }
    }
    // The program that is called.
    for head in ["", "%_N_DRILL_SPF\n"] {
        let folder = Folder::new("backup_line_called").with(&[
            ("MPF.DIR/A.MPF", DRILL),
            ("SPF.DIR/DRILL.SPF", &format!("{head};$PATH=/_N_CST_DIR\n{}", sub(4))),
            ("CMA.DIR/DRILL.SPF", &sub(5)),
        ]);
        let said = folder.run(&["check", "MPF.DIR/A.MPF", "--format", "concise"]).exits(1).says("S2046");
        assert!(said.err.contains("`SPF.DIR/DRILL.SPF` lies in `/_N_SPF_DIR`"), "{}", said.err);
        folder.write("SPF.DIR/DRILL.SPF", &format!("{head};$PATH=/_N_SPF_DIR\n{}", sub(4)));
        assert_eq!(moves(&folder, "MPF.DIR/A.MPF"), ["G0 Z4"]);
        // Beside the main program: another one would run by the line.
        folder.write("MPF.DIR/DRILL.SPF", &format!("{head};$PATH=/_N_CST_DIR\n{}", sub(3)));
        folder.run(&["check", "MPF.DIR/A.MPF"]).exits(1).says("S2046");
        // Nothing looks there by the line.
        std::fs::remove_file(folder.0.join("SPF.DIR/DRILL.SPF")).expect("a file");
        folder.write("MPF.DIR/DRILL.SPF", &format!("{head};$PATH=/_N_WKS_DIR/_N_X_WPD\n{}", sub(3)));
        std::fs::remove_file(folder.0.join("CMA.DIR/DRILL.SPF")).expect("a file");
        folder.run(&["check", "MPF.DIR/A.MPF"]).exits(1).says("S2046");
    }
}

#[cfg(unix)]
#[test]
fn what_is_no_folder_is_refused() {
    use std::os::unix::fs::symlink;
    let read = "N10 G17 G90 G54 G0 X0 Y0 Z10\nN20 G0 Z=HEIGHT\nN30 M30\n";
    for is_link in [true, false] {
        let folder = Folder::new("backup_no_folder").with(&[
            ("MPF.DIR/A.MPF", DRILL),
            ("MPF.DIR/B.MPF", read),
            ("MPF.DIR/GUD4.DEF", "DEF CHAN REAL HEIGHT=8\nM30\n"),
            ("CST.DIR/DRILL.SPF", &sub(5)),
        ]);
        let make = |name: &str| {
            if is_link { symlink("nowhere", folder.0.join(name)).expect("a link") } else { folder.write(name, "x") }
        };
        make("SPF.DIR");
        let said = folder.run(&["check", "MPF.DIR/A.MPF", "--format", "concise"]).exits(1).says("P0102");
        let why = if is_link { "`SPF.DIR` is a link that leads nowhere" } else { "`SPF.DIR` is no folder" };
        assert!(said.err.contains(why), "{}", said.err);
        // Nothing comes to it.
        folder.write("MPF.DIR/DRILL.SPF", &sub(6));
        assert_eq!(moves(&folder, "MPF.DIR/A.MPF"), ["G0 Z6"]);
        make("DEF.DIR");
        folder.run(&["check", "MPF.DIR/B.MPF"]).exits(1).says("P0102");
        // A root of the configuration.
        folder.write("parts/A.MPF", DRILL);
        folder
            .write("parts/partc.toml", "[include]\nroots = { \"/_N_SPF_DIR\" = \"SPF\", \"/_N_CST_DIR\" = \"CST\" }\n");
        folder.write("parts/CST/DRILL.SPF", &sub(5));
        make("parts/SPF");
        folder.run(&["check", "parts/A.MPF"]).exits(1).says("P0102");
    }
}

#[test]
fn two_copies_of_the_own_folder_are_refused() {
    for (own, other) in [
        ("MPF.DIR", "MPF"),
        ("WKS.DIR/A.WPD", "WKS.DIR/_N_A_WPD"),
        ("WKS.DIR/A.WPD", "WKS/A.WPD"),
        #[cfg(target_os = "linux")]
        ("WKS.DIR/A.WPD", "WKS.DIR/a.wpd"),
    ] {
        let folder = Folder::new("backup_own_twice").with(&[("SPF.DIR/DRILL.SPF", &sub(2))]);
        let program = format!("{own}/A.MPF");
        folder.write(&program, DRILL);
        folder.write(&format!("{other}/OTHER.SPF"), &sub(8));
        // It is in neither.
        assert_eq!(moves(&folder, &program), ["G0 Z2"], "{other}");
        folder.write(&format!("{other}/DRILL.SPF"), &sub(9));
        let said = folder.run(&["check", &program, "--format", "concise"]).exits(1).says("P0102");
        assert!(said.err.contains("stand for one folder of the control"), "{}", said.err);
        folder.write(&format!("{own}/DRILL.SPF"), &sub(1));
        folder.run(&["check", &program]).exits(1).says("P0102");
        // Another workpiece is no copy.
        std::fs::remove_dir_all(folder.0.join(other)).expect("a folder");
        folder.write("WKS.DIR/B.WPD/DRILL.SPF", &sub(7));
        assert_eq!(moves(&folder, &program), ["G0 Z1"], "{other}");
    }
}

#[test]
fn a_variable_of_two_definition_files_is_refused() {
    let folder = Folder::new("backup_defined_twice").with(&[
        ("MPF.DIR/A.MPF", "N10 G17 G90 G54 G0 X0 Y0 Z10\nN20 G0 Z=HEIGHT\nN30 M30\n"),
        ("DEF.DIR/GUD4.DEF", "DEF CHAN REAL HEIGHT=7\nM30\n"),
        ("DEF.DIR/UGUD.DEF", "DEF CHAN REAL HEIGHT=8\nM30\n"),
    ]);
    let said = folder.run(&["check", "MPF.DIR/A.MPF"]).exits(1).says("S2016");
    for file in ["GUD4.DEF", "UGUD.DEF"] {
        assert!(said.err.contains(file), "{}", said.err);
    }
    folder.write("DEF.DIR/UGUD.DEF", "DEF CHAN REAL SAFE=8\nM30\n");
    assert_eq!(moves(&folder, "MPF.DIR/A.MPF"), ["G0 Z7"]);
    // A variable of the program hides it.
    folder.write("MPF.DIR/B.MPF", "DEF REAL HEIGHT=3\nN10 G17 G90 G54 G0 X0 Y0 Z10\nN20 G0 Z=HEIGHT+SAFE\nN30 M30\n");
    assert_eq!(moves(&folder, "MPF.DIR/B.MPF"), ["G0 Z11"]);
}

/// Paths of a configuration count from the file that names them, wherever the programs lie.
#[test]
fn paths_count_from_the_file_that_names_them() {
    let folder = Folder::new("backup_paths").with(&[
        ("shop/sub/deep/A.MPF", "N10 G17 G90 G54 G0 X0 Y0 Z10\nN20 DRILL\nN25 STUB\nN30 T5 M6\nN40 M30\n"),
        ("shop/lib/DRILL.SPF", &sub(1)),
        ("shop/stubs/STUB.SPF", &sub(2)),
        ("shop/sub/deep/stubs/STUB.SPF", &sub(9)),
        ("shop/tables/tools.csv", "number,radius\n5,3.0\n"),
    ]);
    let config = "[include]\nroots = { \"/_N_SPF_DIR\" = \"lib\" }\n[programs]\nSTUB = { file = \"stubs/STUB.SPF\" }\n\
                  [tools]\ntable = \"tables/tools.csv\"\n";
    folder.write("shop/partc.toml", config);
    assert_eq!(moves(&folder, "shop/sub/deep/A.MPF"), ["G0 Z1", "G0 Z2"]);
    // The same where another file extends it.
    folder.write("shop/sub/deep/partc.toml", "extend = \"../../partc.toml\"\n");
    assert_eq!(moves(&folder, "shop/sub/deep/A.MPF"), ["G0 Z1", "G0 Z2"]);
}
