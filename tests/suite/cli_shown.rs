//! How findings, outputs and what is left are told: places of one file in one excerpt, a place once, an output of another target.

use super::cli_run::Folder;

/// Where the same file explains a finding, its lines stand under the finding itself: next to it where they follow each other.
#[test]
fn places_of_one_file_stand_in_one_excerpt() {
    let inner = "0 BEGIN PGM INNER MM\n1 LBL 1\n2 L X+10 R5\n3 LBL 0\n4 CALL LBL 1\n5 END PGM INNER MM\n";
    let outer = "0 BEGIN PGM OUTER MM\n1 L X+0 Y+0 R0 F300\n2 CALL PGM INNER.H\n3 M30\n4 END PGM OUTER MM\n";
    let folder = Folder::new("shown_places").with(&[("OUTER.H", outer), ("INNER.H", inner)]);
    insta::assert_snapshot!(folder.run(&["check", "OUTER.H"]).exits(1).err);
    let twice = "0 BEGIN PGM TWICE MM\n1 LBL 5\n2 LBL 5\n3 M30\n4 END PGM TWICE MM\n";
    let folder = Folder::new("shown_places_near").with(&[("TWICE.H", twice)]);
    insta::assert_snapshot!(folder.run(&["check", "TWICE.H"]).exits(1).err);
}

/// Two machines whose targets have one extension: the second output takes the place of the first, and says so.
#[test]
fn an_output_of_another_target_is_not_replaced_without_a_word() {
    let part = "0 BEGIN PGM A MM\n1 L X+0 Y+0 Z+5 R0 FMAX\n2 M30\n3 END PGM A MM\n";
    let folder = Folder::new("shown_targets").with(&[("A.H", part)]);
    for (target, said) in [
        ("haas", ""),
        ("haas", ""),
        ("mazak", "was made for haas, and is for mazak now"),
        ("haas", "was made for mazak"),
    ] {
        let err = folder.run(&["compile", "A.H", "--target", target, "--ignore", "O9338"]).exits(0).err;
        assert!(if said.is_empty() { err.is_empty() } else { err.contains(said) }, "{target}: {err}");
    }
    folder.run(&["compile", "A.H", "--target", "mazak", "--ignore", "O9338", "-q"]).exits(0).quietly();
    assert!(folder.read("A.tap").contains("TARGET MAZAK"));
}

/// A place in which several programs meet is named once, with their number.
#[test]
fn a_place_that_is_left_is_named_once() {
    let called = "0 BEGIN PGM SUB MM\n1 CYCL DEF 1002\n2 END PGM SUB MM\n";
    let part = |name: &str| {
        format!(
            "0 BEGIN PGM {name} MM\n1 L X+0 Y+0 R0 FMAX\n2 CALL PGM SUB.H\n3 L X+1 LBL\n4 M30\n5 END PGM {name} MM\n"
        )
    };
    let folder = Folder::new("shown_left").with(&[("SUB.H", called)]);
    ["A", "B", "C"].iter().for_each(|name| folder.write(&format!("{name}.H"), &part(name)));
    let config = folder.run(&["init", ".", "-o", "-"]).exits(0).out;
    let left: Vec<&str> = config.lines().skip_while(|line| !line.starts_with("# What is left")).skip(1).collect();
    assert!(left.iter().all(|line| line.matches("SUB.H:2").count() <= 1), "{config}");
    insta::assert_snapshot!(left.join("\n"));
}

/// A folder of a control that no program lies in is asked for, and not said to be left whatever is filled in.
#[test]
fn a_folder_is_counted_from_the_configuration() {
    let part = "0 BEGIN PGM A MM\n1 CALL PGM TNC:\\X\\Y.H\n2 M30\n3 END PGM A MM\n";
    let folder = Folder::new("shown_roots").with(&[("A.H", part)]);
    let config = folder.run(&["init", ".", "-o", "-"]).exits(0).out;
    assert!(
        config.contains("#roots.\"TNC:\" =") && config.contains("# a folder, counted from this file; "),
        "{config}"
    );
    assert!(!config.contains("left whatever"), "{config}");
}

/// Of many programs the errors of each stand first, and what is found in several blocks is told once, with how often.
#[test]
fn a_cause_is_told_once_and_errors_first() {
    let part = "0 BEGIN PGM A MM\n1 TOOL CALL 5 Z S1000\n2 CC X+0\n3 L X+0 Y+0 R5 F300\n4 L X+1 R5\n5 L X+2 R5\n6 L X+3 R6\n7 M30\n\
                8 END PGM A MM\n";
    let folder = Folder::new("shown_causes").with(&[("A.H", part), ("B.H", &part.replace("PGM A", "PGM B"))]);
    let said = folder.run(&["check", "."]).exits(1).err;
    let of_a: Vec<&str> = said.lines().filter(|line| line.contains("A.H:")).collect();
    let told: Vec<&&str> = of_a.iter().filter(|line| line.contains("`R5`")).collect();
    assert!(
        told.len() == 1 && told[0].contains("A.H:4:13: error[P1003]: ") && told[0].contains(" (3 times)"),
        "{said}"
    );
    let severities: Vec<bool> = of_a.iter().map(|line| line.contains(": error[")).collect();
    assert!(severities.is_sorted_by(|a, b| a >= b), "{said}");
    assert!(said.contains("2 programs, 10 errors"), "{said}");
}
