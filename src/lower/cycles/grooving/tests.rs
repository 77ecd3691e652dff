use super::*;
use crate::ir::Feed;
use crate::ir::cycle::grooving::tests::groove;
use crate::ir::cycle::grooving::{Copies, GrooveAllowance, GrooveFeeds};
use crate::ir::cycle::recess::RecessTool;
use crate::ir::cycle::recess::tests::lines;
use crate::ir::cycle::turning::Towards;
use crate::lower::cycles::track::{Path, Stroke};

const FROM: Point2 = Point2::new(5.0, 30.0);

/// Strokes as words with X as a diameter, rounded to four decimals; axes that stay are left out.
fn words(grooving: &Grooving) -> Vec<String> {
    let mut at = FROM;
    let mut text = Vec::new();
    let round = |v: f64| (v * 1e4).round() / 1e4 + 0.0;
    let word = |letter, new: f64, old: f64| {
        if round(new) == round(old) { String::new() } else { format!(" {letter}{}", round(new)) }
    };
    expand(grooving, FROM, &mut |stroke| match stroke {
        Stroke::Dwell { seconds } => text.push(format!("G4 P{seconds}")),
        Stroke::Move(mv) => {
            let head = match mv.path {
                Path::Rapid => "G0",
                Path::Line { .. } => "G1",
                Path::Arc { ccw: false, .. } => "G2",
                Path::Arc { ccw: true, .. } => "G3",
                Path::Thread { .. } => "G33",
            };
            text.push(format!("{head}{}{}", word('X', 2.0 * mv.to.y, 2.0 * at.y), word('Z', mv.to.x, at.x)));
            at = mv.to;
        }
    })
    .expect("a groove");
    text
}

#[test]
fn rectangular_groove_in_steps() {
    let mut grooving = groove();
    grooving.operation = Operation::Rough;
    let stroke = |z: &str| -> Vec<String> {
        let steps = ["G1 X36.0667", "G0 X38.0667", "G1 X32.1333", "G0 X34.1333", "G1 X28.2", "G0 X42"];
        [z].into_iter().chain(steps).map(str::to_owned).collect()
    };
    let mut expected = vec!["G0 Z-26.7".to_owned(), "G0 X42".to_owned()];
    expected.extend(stroke("").into_iter().skip(1));
    for z in ["G0 Z-29.3", "G0 Z-24.1", "G0 Z-31.9"] {
        expected.extend(stroke(z));
    }
    // The edge flush with the rim of the reference point.
    expected.push("G0 Z-24".to_owned());
    assert_eq!(words(&grooving), expected);
}

#[test]
fn finishing_goes_along_a_chamfer_with_the_corner_disc() {
    let mut grooving = groove();
    grooving.operation = Operation::Finish;
    grooving.contour =
        lines(&[(-19.5, 40.0), (-20.0, 39.0), (-20.0, 28.0), (-32.0, 28.0), (-32.0, 39.0), (-32.5, 40.0)]);
    let expected = [
        "G0 Z-32.5586",
        "G0 X42",
        "G1 X39.8828",
        "G1 X38.8828 Z-32.0586",
        "G2 X38.6 Z-32",
        "G1 X28",
        "G1 Z-27.8",
        "G0 X42",
        "G0 Z-23.4414",
        "G1 X39.8828",
        "G1 X38.8828 Z-23.9414",
        "G3 X38.6 Z-24",
        "G1 X28",
        "G1 Z-28.2",
        "G0 X42",
        "G0 Z-23.5",
    ];
    assert_eq!(words(&grooving), expected);
}

/// CYCLE930: flanks of 15 and 20 degrees, B1 10, T1 6, reference top right X60 Z-30, U 0.1, tool 3 wide.
fn leaning() -> Grooving {
    let tan = |degrees: f64| libm::tan(degrees.to_radians());
    let left = -40.0 - 6.0 * tan(15.0);
    let contour =
        lines(&[(-30.0, 60.0), (-30.0 - 6.0 * tan(15.0), 48.0), (left, 48.0), (left - 6.0 * tan(20.0), 60.0)]);
    Grooving {
        contour,
        tool: RecessTool { width: 3.0, nose: 0.0, edge: 0.0 },
        surface: 30.0,
        spacing: 2.4,
        plunges: Plunges::Whole,
        operation: Operation::Rough,
        ..groove()
    }
}

#[test]
fn leaning_walls_are_plunged_in_steps_and_cleaned() {
    let expected = [
        "G0 X62",
        "G0 Z-36.9688",
        "G1 X48.2",
        "G0 X62",
        "G0 Z-39.2533",
        "G1 X48.2",
        "G0 X62",
        "G0 Z-34.6844",
        "G1 X48.2",
        "G0 X62",
        "G0 Z-41.5377",
        "G1 X48.2",
        "G0 X62",
        "G0 Z-42.6114",
        "G1 X54.1",
        "G0 X62",
        "G0 Z-33.894",
        "G1 X54.1",
        "G0 X62",
    ];
    let words = words(&leaning());
    assert_eq!(words[..expected.len()], expected);
    // Down the left wall from its rim, 0.1 beside it; then the right one.
    let cleaning = ["G0 Z-43.6975", "G1 X60.0684", "G1 X48.2 Z-41.5377", "G0 X62", "G0 Z-33.0966", "G1 X60.0518"];
    assert_eq!(words[expected.len()..expected.len() + cleaning.len()], cleaning);
    assert_eq!(words.last().unwrap(), "G0 Z-33");
}

#[test]
fn plunges_in_turns_reach_the_floor_together() {
    let grooving = Grooving {
        contour: lines(&[(-10.0, 40.0), (-10.0, 28.0), (-18.0, 28.0), (-18.0, 40.0)]),
        plunges: Plunges::Alternating { most: 2.0, retract: 3.0 },
        dwell: 0.5,
        operation: Operation::Rough,
        ..groove()
    };
    let expected = [
        "G0 Z-16",
        "G0 X42",
        "G1 X36",
        "G0 X42",
        "G0 Z-14.1",
        "G1 X32",
        "G0 X42",
        "G0 Z-16",
        "G1 X28.2",
        "G4 P0.5",
        "G0 X42",
        "G0 Z-14.1",
        "G1 X28.2",
        "G4 P0.5",
        "G0 X42",
        "G0 Z-17.9",
        "G1 X28.2",
        "G4 P0.5",
        "G0 X42",
        "G0 Z-14",
    ];
    assert_eq!(words(&grooving), expected);
    // A single plunge has no neighbour.
    let single = Grooving {
        contour: lines(&[(-10.0, 40.0), (-10.0, 28.0), (-14.0, 28.0), (-14.0, 40.0)]),
        allowance: GrooveAllowance { depth: 0.1, ..GrooveAllowance::default() },
        ..grooving
    };
    let expected =
        ["G0 Z-14", "G0 X42", "G1 X36.0667", "G0 X42", "G1 X32.1333", "G0 X38.1333", "G1 X28.2", "G4 P0.5", "G0 X42"];
    assert_eq!(words(&single), expected);
}

#[test]
fn all_sides_cut_the_same_groove() {
    // A face groove from the outer rim inwards; the corner of the tool towards -X is programmed.
    let face = Grooving {
        contour: vec![
            Element::Line { from: Point2::new(0.0, 20.0), to: Point2::new(-6.0, 20.0) },
            Element::Line { from: Point2::new(-6.0, 20.0), to: Point2::new(-6.0, 8.0) },
            Element::Line { from: Point2::new(-6.0, 8.0), to: Point2::new(0.0, 8.0) },
        ],
        into: Towards::MinusZ,
        surface: 0.0,
        operation: Operation::Rough,
        plunges: Plunges::Whole,
        ..groove()
    };
    let expected = [
        "G0 X26.6", "G0 Z1", "G1 Z-5.9", "G0 Z1", "G0 X21.4", "G1 Z-5.9", "G0 Z1", "G0 X31.8", "G1 Z-5.9", "G0 Z1",
        "G0 X16.2", "G1 Z-5.9", "G0 Z1", "G0 X32",
    ];
    assert_eq!(words(&face), expected);
    let inside = Grooving {
        contour: lines(&[(-32.0, 40.0), (-32.0, 52.0), (-20.0, 52.0), (-20.0, 40.0)]),
        into: Towards::PlusX,
        plunges: Plunges::Whole,
        copies: Copies { count: 2, distance: -15.0 },
        operation: Operation::Rough,
        ..groove()
    };
    let words = words(&inside);
    let expected = ["G0 X38", "G0 Z-29.3", "G1 X51.8", "G0 X38", "G0 Z-26.7", "G1 X51.8"];
    assert_eq!(words[..6], expected);
    assert_eq!(words[13..16], ["G0 Z-44.3", "G1 X51.8", "G0 X38"]);
    assert_eq!(words.last().unwrap(), "G0 Z-32");
}

#[test]
fn what_makes_no_groove() {
    let code = |grooving: &Grooving| expand(grooving, FROM, &mut |_| {}).expect_err("a failure").code().id;
    let mut wide = groove();
    wide.tool.width = 12.0;
    assert_eq!(code(&wide), "G3045");
    let mut leans = groove();
    leans.contour = lines(&[(-20.0, 40.0), (-19.0, 28.0), (-32.0, 28.0), (-32.0, 40.0)]);
    assert_eq!(code(&leans), "G3044");
    let mut shallow = groove();
    shallow.allowance.depth = 6.0;
    assert_eq!(code(&shallow), "G3041");
    let mut many = groove();
    many.plunges = Plunges::Steps { most: 1e-6, retract: 1.0 };
    assert_eq!(code(&many), "G3040");
    let mut feed = groove();
    feed.feeds = GrooveFeeds { plunge: Feed::PerRevolution(0.0), finish: Feed::PerRevolution(0.1) };
    assert_eq!(code(&feed), "G3041");
}

#[test]
fn a_round_foot_is_reached_under_by_the_corners() {
    // Floor of 4 between hollows of 0.2: the square edge of 4 would stop above them.
    let quarter = core::f64::consts::FRAC_PI_2;
    let point = Point2::new;
    let mut grooving = groove();
    let arc = |from: Point2, to: Point2, center: Point2| Element::Arc { from, to, center, sweep: quarter };
    grooving.contour = vec![
        Element::Line { from: point(-24.0, 20.0), to: point(-24.0, 14.2) },
        arc(point(-24.0, 14.2), point(-23.8, 14.0), point(-23.8, 14.2)),
        Element::Line { from: point(-23.8, 14.0), to: point(-20.2, 14.0) },
        arc(point(-20.2, 14.0), point(-20.0, 14.2), point(-20.2, 14.2)),
        Element::Line { from: point(-20.0, 14.2), to: point(-20.0, 20.0) },
    ];
    grooving.allowance = GrooveAllowance::default();
    grooving.plunges = Plunges::Whole;
    grooving.operation = Operation::Rough;
    assert_eq!(words(&grooving), ["G0 Z-24", "G0 X42", "G1 X28", "G0 X42"]);
}
