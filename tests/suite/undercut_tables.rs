//! `[undercut]` is one table for the programs of all controls.

use partc::internals::text::files::NoFiles;

use super::common::{Compiled, compile_bytes, settings};

const LATHE: &str = "[machine]\nkind = \"lathe\"\ndiameter_axis = \"X\"\n[tools.1]\nradius = 0.0\n[undercut]\n";

fn compiled(name: &str, dialect: &str, config: &str, text: &str) -> Compiled {
    let made = compile_bytes(name, text.as_bytes().to_vec(), dialect, &settings(&format!("{LATHE}{config}")), &NoFiles);
    assert!(!made.has_errors(), "{text}{:#?}", made.rendered);
    made
}

/// An undercut of the geometry description, at the shoulder Z-30 of a cylinder or a bore.
fn described(config: &str, diameter: f64, form: &str) -> Compiled {
    let shoulder = diameter + 40.0;
    let text = format!(
        "HEADER\n#UNIT METRIC\nFINISHED PART\nN10 G0 X{diameter} Z0\nN11 G1 Z-30\nN90 G25 {form}\nN12 G1 X{shoulder}\n\
         MACHINING\nN100 T1 G95 F0.2 G97 S800 M3\nN101 G0 X{shoulder} Z3\nN102 G890 NS11 NE12 E0.1 O1 H4\nEND\n"
    );
    compiled("A.nc", "heidenhain-turning", config, &text)
}

fn cycle_of_4110(config: &str, words: &str) -> Compiled {
    let text = format!("%1234\nN1 G26 S800\nN2 T1 G95 F0.2 M3\nN3 G0 X60 Z2\nN4 G85 X40 Z-30 {words}\nN5 M30\n");
    compiled("B.nc", "heidenhain-turning", config, &text)
}

fn cycle94(config: &str) -> Compiled {
    let text = "T1 D1\nG18 DIAM90\nG0 X60 Z5\nG97 S400 M3\nG95 F0.1\nCYCLE94(40,-30,\"E\",3)\nM30\n";
    compiled("C.MPF", "sinumerik", config, text)
}

fn has(made: &Compiled, line: &str) -> bool {
    made.output.lines().any(|l| l.starts_with(line))
}

#[test]
fn sizes_by_diameter_reach_every_control() {
    let keys = "din509_by_diameter = { above = \"1.0x0.4\" }\n";
    // 4 mm long instead of 2.5.
    for (plain, changed) in [
        (described("", 40.0, "H5"), described(keys, 40.0, "H5")),
        (described("", 40.0, "H6"), described(keys, 40.0, "H6")),
        (cycle_of_4110("", ""), cycle_of_4110(keys, "")),
        (cycle94(""), cycle94(keys)),
    ] {
        let start = |made: &Compiled, z: &str| made.output.lines().any(|line| line.contains(z));
        assert!(start(&plain, "Z-27.5") && !start(&plain, "Z-26 ") && !start(&plain, "Z-26\n"), "{}", plain.output);
        assert!(!start(&changed, "Z-27.5") && start(&changed, "Z-26"), "{}", changed.output);
    }
}

#[test]
fn a_size_reaches_every_control() {
    let keys = "din509.\"0.6x0.3\" = { f = 3 }\n";
    for made in [described(keys, 40.0, "H5"), described(keys, 40.0, "H6"), cycle94(keys)] {
        assert!(made.output.contains("Z-27") && !made.output.contains("Z-27.5"), "{}", made.output);
    }
    // The table of the 4110 has sizes of its own.
    let made = cycle_of_4110("din509.\"0.6x0.35\" = { f = 3 }\n", "");
    assert!(has(&made, "G0 Z-27") && !made.output.contains("Z-27.5"), "{}", made.output);
}

#[test]
fn a_pitch_reaches_turning_programs() {
    let keys = "din76.\"1.5\" = { external = 3, a = [3, 6], r = 0.5 }\n";
    let made = described(keys, 40.0, "H7 FP1.5");
    assert!(has(&made, "G1 Z-24") && made.output.contains("X18.5"), "{}", made.output);
    let made = described("thread_length = \"shortest\"\n", 40.0, "H7 FP1.5");
    // 3.2 + 1.15 / tan 30
    assert!(has(&made, "G1 Z-24.8081"), "{}", made.output);
    // K of G85 is a width of the table.
    let made = cycle_of_4110("din76.\"1.5\" = { a = [3, 6], r = 0.5 }\n", "I1 K6");
    assert!(made.output.contains("Z-24"), "{}", made.output);
}

#[test]
fn rows_in_dispute_are_told_where_they_are_used() {
    let told = |made: &Compiled| made.codes().contains(&"T8007");
    assert!(told(&described("", 8.0, "H5")) && told(&described("", 8.0, "H6")));
    assert!(!told(&described("", 8.0, "H5 R0.4")) && !told(&described("", 12.0, "H5")));
    let keys = "din509_by_diameter = { \"10\" = \"0.4x0.2\", above = \"0.6x0.3\" }\n";
    assert!(!told(&described(keys, 8.0, "H5")));
}
