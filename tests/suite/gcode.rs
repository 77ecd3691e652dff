//! Plain G-code as a language: what partc prints it reads, and prints again.

use partc::internals::dialect;
use partc::internals::text::files::NoFiles;

use super::book::cases;
use super::common::compile_bytes;

/// The lines behind the head, without comments.
fn body(output: &str) -> Vec<&str> {
    output.lines().filter(|line| !line.starts_with(['(', '%'])).collect()
}

/// The same words; centres of arcs, whose printed numbers are rounded, are fitted anew.
fn alike(a: &str, b: &str) -> bool {
    let centre = |word: &str| word.starts_with(['I', 'J', 'K']).then(|| word[1..].parse::<f64>().ok()).flatten();
    let near = |(a, b): (&str, &str)| {
        a == b || centre(a).zip(centre(b)).is_some_and(|(x, y)| a[..1] == b[..1] && (x - y).abs() < 0.00061)
    };
    let (a, b): (Vec<&str>, Vec<&str>) = (a.split(' ').collect(), b.split(' ').collect());
    // A place that was printed anew although it is known is printed once.
    let again = a.first() == b.first() && b.len() > 1 && b.iter().all(|word| a.contains(word));
    again || a.len() == b.len() && a.into_iter().zip(b).all(near)
}

/// Every output of the golden books is a program, and its output is itself.
#[test]
fn an_output_is_a_program_whose_output_is_itself() {
    let (mut same, mut wrong) = (0, Vec::new());
    for case in cases("") {
        let own = dialect::find(&case.dialect).expect("a dialect");
        let mut settings = own.settings(&case.settings()).into_owned();
        if settings.output.target != partc::internals::machine::Settings::default().output.target {
            continue;
        }
        let first = case.compile();
        if first.has_errors() {
            continue;
        }
        // What stands in the output is said there; where the axes stand in front of it is not.
        settings.control.unit = None;
        settings.control.skip_blocks.clear();
        let text = first.output.clone().into_bytes();
        let second = compile_bytes("PART.ngc", text, "gcode", &settings, &NoFiles);
        let (one, other) = (body(&first.output), body(&second.output));
        // An arc that nearly closes, or is nearly straight, has a centre that its rounded ends hardly fix, which is said.
        let said = second.codes().iter().any(|code| matches!(*code, "G3013" | "G3023"));
        let agree = said
            || !second.has_errors() && one.len() == other.len() && one.iter().zip(&other).all(|(a, b)| alike(a, b));
        same += usize::from(agree);
        if !agree {
            let at = one.into_iter().zip(other).find(|(a, b)| !alike(a, b));
            wrong.push(format!("{}: {:?} {at:?}", case.name, second.codes()));
        }
    }
    wrong.iter().take(40).for_each(|line| println!("{line}"));
    assert!(wrong.is_empty() && same > 3000, "{} of {} differ", wrong.len(), wrong.len() + same);
}

/// Places as far away as the numbers of the reader go: refused or taken, never more than that.
#[test]
fn far_places_are_read() {
    let gcode = dialect::find("gcode").expect("a dialect");
    for program in [
        "G20G0\nG19F6y1Z1\nG2Y2K2\nK8Z1333333333y6\nG2Y4R233322222\nR2333333333\nK9Z1\n",
        "G21\nG17\nG90\nG0 X-9000000000 Y-9000000000\nG2 X9000000000 Y9000000000 I9000000000 J9000000000 F100\nM30\n",
        "G21\nG17\nG90\nG0 X-9000000000 Y0\nG2 X9000000000 Y0 R9000000000 F100\nM30\n",
        "G21\nG17\nG90.1\nG0 X-9223372036 Y0\nG3 X9223372036 Y0 I9223372036 J9223372036 F100\nM30\n",
    ] {
        let compiled = compile_bytes(
            "far.ngc",
            program.as_bytes().to_vec(),
            "gcode",
            &gcode.settings(&Default::default()),
            &NoFiles,
        );
        assert!(compiled.has_errors() || !compiled.output.is_empty(), "{program}");
    }
}

/// G53 is for straight ways.
#[test]
fn threads_and_arcs_in_machine_coordinates_are_refused() {
    for block in ["G53 G33 Z-10 K1.5", "G33 G53 Z-10 K30", "G53 G2 X5 Y5 I5 J0 F100"] {
        let program = format!("G90 G21 G17 G94 G91.1\nG0 X0 Y0 Z5\nS1000 M3\n{block}\nM30\n");
        let settings = dialect::find("gcode").expect("a dialect").settings(&Default::default()).into_owned();
        let compiled = compile_bytes("far.ngc", program.into_bytes(), "gcode", &settings, &NoFiles);
        assert!(compiled.has_errors() && compiled.output.is_empty(), "{block}: {:?}", compiled.rendered);
    }
}
