use core::f64::consts::TAU;

use super::*;

fn steps(text: &str) -> Vec<Step> {
    steps_of_text(format!("G21 G90\n{text}").as_bytes(), 0.001).unwrap_or_else(|stop| panic!("{stop}\n{text}"))
}

fn between(a: &str, b: &str) -> (Difference, String) {
    let (a, b) = (steps(a), steps(b));
    let found = Difference::between(&a, &b, 0.001);
    let text = found.text(&a, &b, ["golden", "now"]);
    (found, text)
}

#[test]
fn steps_carry_what_holds_for_them() {
    let list = steps("(G1 X9)\nG17\nT1 M6\nG0 X0 Y0\nG1 X10 F100\nG3 X10 Y0 I-5 J0 P2\nG53 G0 Z-1\nM30\n%\n");
    let texts: Vec<String> = list.iter().map(Step::text).collect();
    let expected = [
        "T1 M6 (line 4)",
        "G0 X0 Y0 (line 5)",
        "G1 X10 Y0 F100 (line 6)",
        "G3 X10 Y0 I-5 J0 P2 F100 (line 7)",
        "G53 G0 Z-1 (line 8)",
        "M30 (line 9)",
    ];
    assert_eq!(texts, expected);
    let Does::Travel(circles) = &list[3].does else { panic!("a move") };
    assert!((circles.length() - 2.0 * TAU * 5.0).abs() < 1e-9 && circles.tool == Some(1));
}

/// The same in the words of many: increments, modal words, inches, radii, centres from zero, lower case, no blanks.
#[test]
fn words_do_not_matter() {
    let plain = "G0 X0 Y0\nG1 X25.4 Y0 F254\nG3 X25.4 Y20 I0 J10\nG1 X0 Y20\nM5\nM30\n";
    for other in [
        "g0x0y0\nn20 g1 x25.4 f254\ng3y20j10\ng1x0\nm5\nm30",
        "G0 X0 Y0\nG91\nG1 X25.4 F254\nG3 Y20 J10\nG1 X-25.4\nM5 M30",
        "G0 X0 Y0 F254\nG1 X25.4\nG3 X25.4 Y20 R10\nG1 X0\nM5\nM30",
        "G0 X0 Y0\nG1 X25.4 F254\nG90.1\nG3 Y20 I25.4 J10\nG1 X0\nM5\nM30",
        "G0 X0 Y0\nG20\nG1 X1 F10\nG21\nG3 Y20 J10\nG1 X0\nM5\nM30",
        "G0 X0 Y0\nG1 X25.4 F254\nG3 X35.4 Y10 J10\nX25.4 Y20 I-10\nG1 X0\nM5\nM30",
    ] {
        let (found, text) = between(plain, other);
        assert!(found.is_same(), "{other}\n{text}");
    }
}

#[test]
fn a_difference_names_its_first_step_and_its_size() {
    let (found, text) = between("G0 X0 Y0\nG1 X10 F100\n", "G0 X0 Y0\n(new)\nG1 X10.5 F100\n");
    assert!(text.starts_with("motion: 1 of 2 moves differs, by up to 0.5\n"), "{text}");
    assert!(
        text.contains("golden: G1 X10 Y0 F100 (line 3)") && text.contains("now: G1 X10.5 Y0 F100 (line 4)"),
        "{text}"
    );
    assert!(text.contains("golden: 10 mm") && text.contains("now: 10.5 mm"), "{text}");
    assert_eq!((found.differing, found.only, found.largest), (1, [0, 0], 0.5));
}

#[test]
fn one_block_more_leaves_the_others_the_same() {
    let line = |n: i32| format!("G1 X{} Y{} F100\n", n * 7 % 13, n);
    let a: String = (0..200).map(line).collect();
    let b: String = (0..200).filter(|n| *n != 50).map(|n| if n == 120 { line(n) + "M8\n" } else { line(n) }).collect();
    let (found, text) = between(&a, &b);
    assert_eq!((found.differing, found.only, found.functions), (0, [1, 1], 1), "{text}");
    assert!(text.contains("199 moves; 0 differ, 1 are only in golden, 1 only in now"), "{text}");
}

#[test]
fn feeds_tools_senses_and_order_count() {
    let base = "T1 M6\nS100 M3\nG0 X0 Y0\nG1 X10 F100\nG2 X20 I5 J0\nM8\nG0 Z5\n";
    for (from, to, what) in [
        ("F100", "F101", "in the feed alone"),
        ("T1", "T2", "T2"),
        ("G2 ", "G3 ", "G3"),
        ("M8\nG0 Z5\n", "G0 Z5\nM8\n", "M8"),
        ("M3", "M4", "M4"),
        ("S100", "S200", "S200"),
        ("I5 J0", "I5 J0 P2", "P2"),
        ("G1 X10", "G0 X10", "G0"),
        ("G0 Z5\n", "G0 Z5\nG4 P1\n", "dwell 1"),
        ("G2 X20 I5 J0", "G1 X20", "G1 X20"),
    ] {
        let (found, text) = between(base, &base.replace(from, to));
        assert!(!found.is_same() && text.contains(what), "{to}\n{text}");
    }
    assert_eq!(between(base, &base.replace("F100", "F101")).0.feeds, 2);
}

#[test]
fn what_is_no_plain_program_is_said_with_its_line() {
    for (text, line, why) in [
        ("G21 G90\nG1 X#1 F1\n", 2, "is no number"),
        ("G90\nG1 X1 F1\n", 2, "millimetres or inches"),
        ("G21\nG81 X1 Z-3 R2 F1\n", 2, "no word that is read"),
        ("G21\nG1 X1\n", 2, "without a feed"),
        ("G21\nG2 X1 Y1 I1 J0 F1\n", 2, "unknown place"),
        ("G21\n/G0 X1\n", 2, "decided at the machine"),
        ("G21\nM2\nG0 X1\n", 3, "after the end"),
    ] {
        let stop = steps_of_text(text.as_bytes(), 0.001).expect_err(text);
        assert!(stop.line == line && stop.why.contains(why), "{text}: {stop}");
    }
}

/// The words of a receiver do not matter, and what the spindle is told just in front of a tap that starts it.
#[test]
fn a_tap_is_the_same_in_the_words_of_each_receiver() {
    let tap = "S500 M3\nG0 X0 Y0\nG0 Z2\nG33.1 Z-10 K1.25\nM5\n";
    let head = |target: &str| format!("(partc 0.1.0, target {target})\nG17 G94 G40 G80\nS500\nG0 X0. Y0.\nG0 Z2.\n");
    for other in [
        format!("{}M29 S500\nG99 G84 X0. Y0. Z-10. R2. F625.\nG80\nM5\n", head("fanuc")),
        format!("{}G99 G84 X0. Y0. Z-10. R2. F625.\nG80\nM5\n", head("haas")),
        format!("{}G95\nG99 G84.2 X0. Y0. Z-10. R2. F1.25\nG80\nM5\n", head("mazak")),
    ] {
        let plain = tap.replace("S500 M3\n", "S500\n").replace("G0 Z2\n", "G0 Z2\nM3\n");
        let (found, text) = between(&plain, &other);
        assert!(found.is_same(), "{other}\n{text}");
        let (found, _) = between(&plain, &other.replace("625.", "500.").replace("F1.25", "F1."));
        assert!(!found.is_same(), "{other}");
    }
}

#[test]
fn a_tap_is_no_pair_of_threads_and_its_hand_and_depth_count() {
    let tap = "S500 M3\nG0 X0 Y0 Z2\nG33.1 Z-10 K1.25\nM5\n";
    for other in [
        "S500 M3\nG0 X0 Y0 Z2\nG33 Z-10 K1.25\nM4\nG33 Z2 K1.25\nM5\n".to_owned(),
        tap.replace("M3", "M4"),
        tap.replace("Z-10", "Z-9"),
        tap.replace("K1.25", "K1.5"),
        tap.replace("K1.25", "K1.25 I2"),
        tap.replace("S500", "S400"),
    ] {
        let (found, _) = between(tap, &other);
        assert!(!found.is_same(), "{other}");
    }
}

/// 20 mm of 1.25 are 16 turns: 0.0009 more a turn lead 0.0144 mm astray; 0.00005 more 0.0008.
#[test]
fn pitches_are_compared_by_where_they_lead() {
    for tap in ["S500 M3\nG0 Z0\nG33.1 Z-20 K1.25\nM5\n", "S500 M3\nG0 Z0\nG33 Z-20 K1.25\nG0 Z5\nM5\n"] {
        let (found, text) = between(tap, &tap.replace("K1.25", "K1.2509"));
        assert!(!found.is_same() && text.contains("1.2509"), "{text}");
        let (found, text) = between(tap, &tap.replace("K1.25", "K1.25005"));
        assert!(found.is_same(), "{text}");
    }
}

/// The angle of the spindle belongs to a tap, as far as it is said.
#[test]
fn taps_from_other_angles_differ() {
    let head = |angle: &str| {
        format!(
            "; partc 0, target sinumerik\nG710 G90 G17 G40 G94 G60\nT1 M6\nD1\nG0 X0 Y0 Z2\n{angle}G331 Z-10 K1.25 S500\nG332 Z2 K1.25\nM5\nM30\n"
        )
    };
    let list = |text: &str| steps_of_text(text.as_bytes(), 0.001).unwrap_or_else(|stop| panic!("{stop}\n{text}"));
    let same = |a: &str, b: &str| Difference::between(&list(&head(a)), &list(&head(b)), 0.001).is_same();
    assert!(same("SPOS=0\n", "SPOS=360\n"));
    assert!(!same("SPOS=0\n", "SPOS=90\n"));
}

/// What was said of the speed between two taps has no effect, and after them it counts where something cuts with it.
#[test]
fn the_speed_after_a_tap_counts_where_the_spindle_starts() {
    let taps = |between: &str, after: &str| {
        format!(
            "S500 M3\nG0 X0 Y0 Z2\nS300\nG33.1 Z-10 K1.25\n{between}G0 X10\nS300\nG33.1 Z-10 K1.25\nM5\n{after}G0 Z5\nM3\nG1 X20 F100\n"
        )
    };
    let (found, text) = between(&taps("", "S500\n"), &taps("S400\n", "S500\n"));
    assert!(found.is_same(), "{text}");
    let (found, text) = between(&taps("", "S500\n"), &taps("", ""));
    assert!(!found.is_same(), "{text}");
}

/// A tap returns to where it began, and is a step all the same.
#[test]
fn each_tap_is_a_step() {
    let head = "G17 G94\nT1 M6\nS500 M3\nG0 X0 Y0 Z5\n";
    let same = |a: &str, b: &str| between(&format!("{head}{a}G0 Z20\nM30\n"), &format!("{head}{b}G0 Z20\nM30\n")).0;
    let once = "G33.1 Z-10 K1.25\n";
    assert!(same(once, once).is_same());
    let steps = same(once, "G33.1 Z-1 K1.25\nG33.1 Z-2 K1.25\nG33.1 Z-3 K1.25\nG33.1 Z-10 K1.25\n");
    assert_eq!((steps.is_same(), steps.only), (false, [0, 3]));
    let twice = same(once, "G33.1 Z-10 K1.25\nG33.1 Z-10 K1.25\n");
    assert_eq!((twice.is_same(), twice.only), (false, [0, 1]));
    assert!(!same(once, "").is_same());
}

#[test]
fn the_angle_of_a_tap_counts_where_it_was_said() {
    let head = "G17 G94\nT1 M6\nS500\nG0 X0 Y0 Z5\n";
    let same = |a: &str, b: &str| {
        between(&format!("{head}{a}M3\nG33.1 Z-10 K1.25\nM30\n"), &format!("{head}{b}M3\nG33.1 Z-10 K1.25\nM30\n"))
            .0
            .is_same()
    };
    assert!(same("", ""));
    assert!(same("", "M19 R0\n"), "a spindle that turns on from M3 begins anywhere");
}
