//! Taps: printed on every target as they are meant, and each fault in one is noticed.

use crate::geo::Plane;
use crate::ir::function::{Spindle, Turn};
use crate::ir::motion::{Move, Path, Place};
use crate::ir::tap::Stroke;
use crate::ir::{Function, Pos, Side, Tap};
use crate::machine::settings::Units;
use crate::machine::{Axis, AxisSet, Settings};

use super::streams::{Dice, Item, Stream, stream_of_taps};
use super::{as_it_is, validate};

/// Taps of each target.
const TAPS: u64 = 400;
/// Receivers with a word for a tap.
const TARGETS: [&str; 7] = ["linuxcnc", "fanuc", "haas", "mazak", "fanuc-lathe", "sinumerik", "heidenhain"];

#[test]
fn random_taps_are_printed_as_they_are_meant() {
    for target in TARGETS {
        let (mut valid, mut refused) = (0u64, 0u64);
        for seed in 1..=TAPS {
            let mut dice = Dice(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
            let mut stream = stream_of_taps(&mut dice, target);
            stream.settings.output.units = dice.of(&[Units::Millimetres, Units::Inches]);
            stream.settings.output.modal = dice.one_in(2);
            let Some(outcome) = validate(&stream, None, &mut as_it_is) else {
                refused += 1;
                continue;
            };
            if let Some(mismatch) = outcome.mismatch {
                let meant = &mismatch.meant;
                panic!("{target} stream {seed}: {mismatch}\nmeant {meant}\n{}", outcome.pieces.concat());
            }
            valid += 1;
        }
        println!("{target}: {valid} streams, {refused} refused");
        assert!(valid > TAPS / 8, "{target}: {valid} of {TAPS} streams");
    }
}

/// M12, left-hand, from Z2 to Z-18 in two steps.
fn stream(target: &str, turn: Turn) -> Stream {
    let mut settings = Settings::default();
    settings.output.target = crate::target::find(target).expect("a target");
    settings.output.tool_length = Some(false);
    let mut at = Pos::UNKNOWN;
    [(Axis::X, 10.0), (Axis::Y, 20.0), (Axis::Z, 2.0)].into_iter().for_each(|(axis, value)| at.set(axis, value));
    let rapid =
        Move { end: at, axes: AxisSet::MAIN, path: Path::Rapid, side: Side::None, plane: Plane::Xy, machine: false };
    let strokes = vec![Stroke { to: -10.0, back: -9.5, dwell: 0.0 }, Stroke { to: -18.0, back: 2.0, dwell: 0.0 }];
    let tap = Tap {
        axis: Axis::Z,
        start: 2.0,
        surface: 0.0,
        strokes,
        lead: 1.75,
        turn,
        speed_in: Some(300.0),
        speed_out: Some(300.0),
        orient: None,
        pause: 0.0,
        again: None,
    };
    let items = vec![
        Item::Move(rapid),
        Item::Function(Function::Spindle(Spindle::Speed(300.0))),
        Item::Tap(tap, Place { at, plane: Plane::Xy }),
        Item::Function(Function::Spindle(Spindle::Stop)),
    ];
    Stream { settings, items }
}

/// Words of the printed text and what stands there instead.
type Faults = &'static [(&'static str, &'static str)];

#[test]
fn every_fault_in_a_tap_is_noticed() {
    let faults: [(&str, Turn, Faults); 5] = [
        (
            "linuxcnc",
            Turn::Clockwise,
            &[
                ("Z-18", "Z-18.1"),
                ("Z-10", "Z-9"),
                ("K1.75", "K1.5"),
                ("K1.75", "K1.75 I2"),
                ("M3\n", "M4\n"),
                ("M3\n", ""),
                ("G33.1", "G33"),
                ("G33.1 Z-10 K1.75\n", ""),
                ("G33.1 Z-10 K1.75\n", "G33.1 Z-10 K1.75\nG4 P1\n"),
                ("G33.1 Z-18 K1.75\n", "G33.1 Z-18 K1.75\nG33.1 Z-18 K1.75\n"),
            ],
        ),
        (
            "fanuc",
            Turn::CounterClockwise,
            &[
                ("Z-18.", "Z-18.1"),
                ("R2.", "R3."),
                ("G74", "G84"),
                ("F525.", "F500."),
                ("M29 S300\n", ""),
                ("M29 S300", "M29 S200"),
                ("G80\n", ""),
                ("\nZ-18.\n", "\nG80\nZ-18.\n"),
                ("\nZ-18.\n", "\nX10. Z-18.\n"),
                ("\nZ-18.\n", "\nZ-18. F500.\n"),
                ("X10.", "X11."),
                ("G99 G74", "G99 G74 P500"),
            ],
        ),
        ("haas", Turn::Clockwise, &[("G84", "G74"), ("F525.", "F530."), ("F525.", "J2 F525."), ("R2.", "R1.")]),
        (
            "mazak",
            Turn::Clockwise,
            &[("G84.2", "G84.3"), ("G84.2", "G84"), ("F1.75", "F1.7"), ("G95\n", ""), ("G80\n", "")],
        ),
        (
            "sinumerik",
            Turn::CounterClockwise,
            &[
                ("SPOS=0\n", ""),
                ("SPOS=0\n", "SPOS=90\n"),
                ("K-1.75", "K1.75"),
                ("K-1.75", "K-1.5"),
                ("S300", "S200"),
                ("Z-18", "Z-17"),
                ("G332 Z-9.5", "G332 Z-9"),
                ("G332 Z2", "G332 Z3"),
                ("G332 Z2 K-1.75\n", ""),
                ("G331 Z-18", "G332 Z-18"),
            ],
        ),
    ];
    for (target, turn, faults) in faults {
        notices(target, turn, faults);
    }
    let dialog: &[(&str, &str)] = &[
        ("Q201=-18", "Q201=-19"),
        ("Q239=-1.75", "Q239=+1.75"),
        ("Q239=-1.75", "Q239=-1.5"),
        ("Q203=+0", "Q203=+1"),
        ("Q200=+2", "Q200=+3"),
        ("Q204=+2", "Q204=+20"),
        ("Q403=+1 ", "Q403=+2 "),
        ("CYCL CALL\n", "M5\n"),
    ];
    notices("heidenhain", Turn::CounterClockwise, dialog);
}

fn notices(target: &str, turn: Turn, faults: &[(&str, &str)]) {
    let stream = stream(target, turn);
    let right = validate(&stream, None, &mut as_it_is).expect("is printed");
    assert!(right.mismatch.is_none(), "{target}: {:?}\n{}", right.mismatch, right.pieces.concat());
    for (word, other) in faults {
        let mut changed = false;
        let outcome = validate(&stream, None, &mut |n, text| {
            let hit = n == 3 && text.contains(word);
            changed |= hit;
            hit.then(|| text.replacen(word, other, 1))
        });
        assert!(changed, "{target}: there is no {word} in\n{}", right.pieces.concat());
        assert!(outcome.is_some_and(|outcome| outcome.mismatch.is_some()), "{target}: {word} -> {other:?}");
    }
}
