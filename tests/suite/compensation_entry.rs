//! In every dialect: under the target's own radius compensation the way to the contour is longer than the radius, and
//! the way from it not shorter.

use partc::internals::text::files::NoFiles;

use super::common::{compile_bytes, settings};

/// Name, dialect, and a contour along Y whose first block comes from `{from}` to 0 and whose last one goes to `{to}`.
const PROGRAMS: &[(&str, &str, &str)] = &[
    (
        "PART.H",
        "klartext",
        "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S1000\n2 L X+0 Y{from} R0 FMAX M3\n3 L Y+0 RL F200\n4 L Y+40\n5 L X{to} R0\n\
         6 END PGM A MM\n",
    ),
    (
        "PART.MPF",
        "sinumerik",
        "T1 M6\nD1\nG17 G90 S1000 M3\nG0 X0 Y{from} Z0\nG41 G1 Y0 F200\nG1 Y40\nG40 X{to}\nM30\n",
    ),
    ("PART.npg", "mtc200", "T1 M6\nG90 G00 X0 Y{from}\nG41 G01 X0 Y0 F200\nY40\nG40 X{to}\nRET\n"),
    (
        "PART.nc",
        "heidenhain-turning",
        "%1.nc\nN1 T1\nN2 G95 F0.25 G97 S1000 M3\nN3 G0 X0 Z{from}\nN4 G42 G1 X0 Z0\nN5 G1 Z40\nN6 G40 G1 Z{to}\nEND\n",
    ),
];

fn refused(program: &(&str, &str, &str), from: &str, to: &str, radius: Option<&str>) -> bool {
    let (name, dialect, text) = program;
    // The turning program leaves along Z as well: its contour ends at Z40.
    let to = if *dialect == "heidenhain-turning" { to.replace(['-', 'X'], "") } else { to.to_owned() };
    let text = text.replace("{from}", from).replace("{to}", &to);
    let tool = radius.map(|radius| format!("[tools.1]\nradius = {radius}\n")).unwrap_or_default();
    let settings = settings(&format!("[output]\ncompensation = \"control\"\n{tool}"));
    let compiled = compile_bytes(name, text.into_bytes(), dialect, &settings, &NoFiles);
    let codes: Vec<&str> = compiled.codes().into_iter().filter(|code| !matches!(*code, "S8043")).collect();
    let refused = codes.contains(&"O9100");
    assert!(refused || !compiled.has_errors(), "{dialect}: {:?}", compiled.rendered);
    refused
}

#[test]
fn a_way_shorter_than_the_known_radius_is_refused() {
    for program in PROGRAMS {
        let turning = program.1 == "heidenhain-turning";
        let (near, at, far) = if turning { ("44.99", "45", "46") } else { ("-4.99", "-5", "-6") };
        let name = program.1;
        assert!(refused(program, "-4.9999", far, Some("5.0")), "{name}: a short way to the contour");
        assert!(refused(program, "-5", far, Some("5.0")), "{name}: a way as long as the radius");
        assert!(!refused(program, "-5.0001", far, Some("5.0")), "{name}: a longer way");
        assert!(refused(program, "-6", near, Some("5.0")), "{name}: a short way from the contour");
        assert!(!refused(program, "-6", at, Some("5.0")), "{name}: as long as the radius");
        assert!(!refused(program, "-4.9999", near, None), "{name}: a tool whose radius nobody told");
    }
}
