use proptest::prelude::*;

use super::pecking::depths;
use super::*;
use crate::ir::Feed;
use crate::ir::contour::Path;
use crate::ir::cycle::drilling::{
    AdvancedStop, Bore, Breaks, Chip, Degression, Levels, Pecking, Removal, Resolved, TapStep,
};
use crate::ir::function::Turn;
use crate::ir::tap::Part;

const XYZ: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

fn levels(retract: f64, reference: f64, clearance: f64, depth: f64) -> Levels {
    Levels { retract, reference, clearance, depth }
}

fn hole(levels: Levels, method: Method) -> Drilling {
    Drilling { axis: Axis::Z, levels, feed: Feed::PerMinute(100.0), entry: None, method }
}

fn breaking(first: f64, degression: Degression) -> Method {
    Method::Peck(Pecking { breaks: Breaks::Always, way: 1.0, ..Pecking::new(first, degression) })
}

fn number(v: f64) -> String {
    let text = format!("{v:.3}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

fn function(function: &Function) -> String {
    match function {
        Function::Dwell(s) => format!("G4 {}", number(*s)),
        Function::Spindle(Spindle::Start(Turn::Clockwise)) => "M3".to_owned(),
        Function::Spindle(Spindle::Start(Turn::CounterClockwise)) => "M4".to_owned(),
        Function::Spindle(Spindle::Stop) => "M5".to_owned(),
        Function::Spindle(Spindle::Speed(s)) => format!("S{s}"),
        Function::Spindle(Spindle::Orient(a)) => format!("M19 R{a}"),
        Function::Stop => "M0".to_owned(),
        other => panic!("{other:?}"),
    }
}

fn words(drilling: &Drilling) -> Vec<String> {
    let mut start = Pos::UNKNOWN;
    start.set(Axis::X, 10.0);
    start.set(Axis::Y, 20.0);
    let mut list = Vec::new();
    expand(drilling, &start, XYZ, &mut |part| {
        list.push(match part {
            CycleItem::Tap(tap) => {
                tap.parts(&mut |part| {
                    list.push(match part {
                        Part::To(to) => format!("G33 K{} Z{}", number(tap.lead), number(to)),
                        other => function(&other.function().expect("a function")),
                    });
                });
                return;
            }
            CycleItem::Move(mv) | CycleItem::Beside(mv, _) => {
                let end = mv.end;
                let axes: Vec<_> = end.iter().map(|(axis, v)| format!("{}{}", axis.letter(), number(v))).collect();
                let word = match mv.path {
                    Path::Rapid => "G0".to_owned(),
                    Path::Line(feed) => format!("G1 F{}", number(feed.value())),
                    Path::Thread(thread) => format!("G33 K{}", number(thread.lead)),
                    Path::Arc(..) => panic!("an arc"),
                };
                format!("{word} {}", axes.join(" "))
            }
            CycleItem::Function(item) => function(&item),
        });
    })
    .expect("a hole");
    list
}

/// `CYCLE83(155,150,1,5,0,100,,20,0,0,1,0)`.
#[test]
fn degression_by_amount() {
    let drilling = hole(levels(155.0, 150.0, 1.0, 5.0), breaking(50.0, Degression::Amount(20.0)));
    let z: Vec<_> = words(&drilling).iter().map(|line| line.rsplit(['Z']).next().unwrap().to_owned()).collect();
    assert_eq!(z, ["151", "100", "101", "70", "71", "50", "51", "30", "31", "17.5", "18.5", "5", "155"]);
}

fn series(total: f64, first: f64, degression: Degression) -> Vec<String> {
    depths(&levels(2.0, 0.0, 1.0, -total), first, degression).expect("a series").into_iter().map(number).collect()
}

#[test]
fn other_series_as_computed_by_hand() {
    assert_eq!(series(100.0, 30.0, Degression::Amount(5.0)), ["-30", "-55", "-75", "-90", "-100"]);
    assert_eq!(series(50.0, 20.0, Degression::Amount(5.0)), ["-20", "-35", "-45", "-50"]);
    // What is left is the step that is due: 9 - 2.
    assert_eq!(series(16.0, 9.0, Degression::Amount(2.0)), ["-9", "-16"]);
    assert_eq!(series(100.0, 30.0, Degression::constant(30.0)), ["-30", "-60", "-80", "-100"]);
    assert_eq!(
        series(100.0, 20.0, Degression::Factor { factor: 0.8, least: 5.0 }),
        [
            "-20", "-36", "-48.8", "-59.04", "-67.232", "-73.786", "-79.028", "-84.028", "-89.028", "-94.028",
            "-97.014", "-100"
        ]
    );
    assert_eq!(series(10.0, 30.0, Degression::constant(30.0)), ["-10"]);
    // What is left behind the last step is nothing, which is less than a step: the cycle halves it.
    assert_eq!(series(90.0, 30.0, Degression::constant(30.0)), ["-30", "-60", "-75", "-90"]);
    assert_eq!(series(0.3, 0.1, Degression::constant(0.1)).last().map(String::as_str), Some("-0.3"));
    assert_eq!(series(90.0, 30.0, Degression::Even { least: 30.0 }), ["-30", "-60", "-90"]);
    assert_eq!(series(100.0, 30.0, Degression::Even { least: 30.0 }), ["-30", "-60", "-80", "-100"]);
}

#[test]
fn swarf_removal_stops_short_of_the_last_depth() {
    let degression = Degression::Factor { factor: 0.8, least: 5.0 };
    let mut peck = Pecking::new(20.0, degression);
    peck.removal.dwell = 0.5;
    let list = words(&hole(levels(10.0, 0.0, 1.0, -100.0), Method::Peck(peck)));
    assert_eq!(list[..5], ["G0 Z1", "G1 F100 Z-20", "G0 Z1", "G4 0.5", "G0 Z-19.4"]);
    assert!(list.contains(&"G0 Z-47.824".to_owned()), "{list:?}");
    assert_eq!(list[list.len() - 2..], ["G1 F100 Z-100", "G0 Z10"]);
}

/// One step plan for all: a break every 4 mm, removal at a feed with a distance that grows.
#[test]
fn chips_are_broken_and_removed_by_turns() {
    let back = Some(Feed::PerMinute(500.0));
    let removal = Removal { back, dwell: 0.0, ahead: AdvancedStop::Evenly([0.5, 1.5]), last: Some(back) };
    let degression = Degression::Plain { less: 2.0, least: 3.0 };
    let peck = Pecking { removal, way: 0.2, breaks: Breaks::Times(1), ..Pecking::new(6.0, degression) };
    assert_eq!(
        words(&hole(levels(50.0, 0.0, 2.0, -15.0), Method::Peck(peck))),
        [
            "G0 Z2",
            "G1 F100 Z-6",
            "G0 Z-5.8",
            "G1 F100 Z-10",
            "G1 F500 Z2",
            "G0 Z-9",
            "G1 F100 Z-13",
            "G0 Z-12.8",
            "G1 F100 Z-15",
            "G1 F500 Z2",
            "G0 Z50"
        ]
    );
    let within = Pecking { breaks: Breaks::Every(4.0), way: 0.2, ..Pecking::new(10.0, degression) };
    assert_eq!(
        words(&hole(levels(50.0, 0.0, 2.0, -10.0), Method::Peck(within))),
        ["G0 Z2", "G1 F100 Z-4", "G0 Z-3.8", "G1 F100 Z-8", "G0 Z-7.8", "G1 F100 Z-10", "G0 Z50"]
    );
}

#[test]
fn plain_holes() {
    let at = levels(50.0, 0.0, 2.0, -20.0);
    let plain = ["G0 Z2", "G1 F100 Z-20", "G0 Z50"];
    assert_eq!(words(&hole(at, Method::Drill { dwell: 0.0 })), plain);
    assert_eq!(words(&hole(at, Method::Drill { dwell: 1.5 })), ["G0 Z2", "G1 F100 Z-20", "G4 1.5", "G0 Z50"]);
    let ream = Method::Ream { dwell: 0.0, back: Feed::PerMinute(300.0) };
    assert_eq!(words(&hole(at, ream)), ["G0 Z2", "G1 F100 Z-20", "G1 F300 Z2", "G0 Z50"]);
    let stop = Method::BoreWithStop { dwell: 0.0, turn: Turn::Clockwise };
    assert_eq!(words(&hole(at, stop)), ["G0 Z2", "G1 F100 Z-20", "M5", "M0", "G0 Z50", "M3"]);
    // Upwards.
    assert_eq!(
        words(&hole(levels(-50.0, 0.0, 2.0, 20.0), Method::Drill { dwell: 0.0 })),
        ["G0 Z-2", "G1 F100 Z20", "G0 Z-50"]
    );
    assert!(words(&hole(levels(50.0, 0.0, 2.0, 0.0), Method::Drill { dwell: 0.0 })).is_empty());
}

#[test]
fn boring_lifts_the_edge_off() {
    let bore = Bore { dwell: 1.0, turn: Turn::Clockwise, orient: 45.0, back: None, lift: [-1.0, 0.0, 0.5] };
    assert_eq!(
        words(&hole(levels(50.0, 0.0, 2.0, -20.0), Method::Bore(bore))),
        ["G0 Z2", "G1 F100 Z-20", "G4 1", "M19 R45", "G0 X9 Z-19.5", "G0 Z2", "G0 Z50", "G0 X10", "M3"]
    );
}

#[test]
fn tapping_turns_back_on_the_way_out() {
    let tap = Tap {
        rigid: true,
        lead: Some(1.25),
        turn: Turn::Clockwise,
        dwell_reversed: false,
        dwell: 0.0,
        speed_in: Some(200.0),
        speed_out: Some(400.0),
        orient: Some(0.0),
        step: None,
        after: Spindle::Stop,
        speed_after: Some(1000.0),
    };
    let at = levels(50.0, 0.0, 2.0, -20.0);
    assert_eq!(
        words(&hole(at, Method::Tap(tap))),
        ["G0 Z2", "M19 R0", "S200", "M3", "G33 K1.25 Z-20", "S400", "M4", "G33 K1.25 Z2", "S1000", "M5", "G0 Z50"]
    );
    let by = |way, chip| Some(TapStep { way, degression: Degression::Even { least: way }, chip });
    let breaking = |way, back| by(way, Chip::Break { back });
    let steps = Tap {
        step: by(12.0, Chip::Remove { ahead: 1.0 }),
        speed_in: None,
        speed_out: None,
        orient: None,
        speed_after: None,
        ..tap
    };
    assert_eq!(
        words(&hole(at, Method::Tap(steps))),
        [
            "G0 Z2",
            "M3",
            "G33 K1.25 Z-12",
            "M4",
            "G33 K1.25 Z2",
            "M3",
            "G33 K1.25 Z-20",
            "M4",
            "G33 K1.25 Z2",
            "M5",
            "G0 Z50"
        ]
    );
    // The way out has a speed of its own, and so has the way down through the thread that is cut.
    let quick = Tap { speed_in: Some(200.0), speed_out: Some(400.0), ..steps };
    let found = words(&hole(at, Method::Tap(quick)));
    let again = ["S400", "M4", "G33 K1.25 Z2", "S400", "M3", "G33 K1.25 Z-11", "S200", "M3", "G33 K1.25 Z-20"];
    assert_eq!(found[4..13], again, "{found:?}");
    // Exactly two steps, and the chip broken between them.
    let words_of = |tap: Tap| words(&hole(at, Method::Tap(tap)));
    let broken = words_of(Tap { step: breaking(10.0, 1.5), ..steps });
    let expected = ["M3", "G33 K1.25 Z-10", "M4", "G33 K1.25 Z-8.5", "M3", "G33 K1.25 Z-20", "M4", "G33 K1.25 Z2"];
    assert_eq!(broken[1..9], expected);
    let far = words_of(Tap { step: breaking(10.0, 99.0), ..steps });
    assert_eq!(far[1..5], ["M3", "G33 K1.25 Z-10", "M4", "G33 K1.25 Z2"]);
    let chuck =
        Tap { lead: None, turn: Turn::CounterClockwise, step: None, after: Spindle::Start(Turn::Clockwise), ..steps };
    assert_eq!(
        words(&hole(at, Method::Tap(chuck))),
        ["G0 Z2", "M4", "G1 F100 Z-20", "M3", "G1 F100 Z2", "M3", "G0 Z50"]
    );
}

#[test]
fn depths_absolute_and_relative() {
    let resolve = |rtp, rfp, dp, dpr| Levels::resolve(rtp, rfp, 1.0, dp, dpr);
    let depth = |found: Result<Resolved, _>| found.map(|r| (r.levels.depth, r.overridden));
    assert_eq!(depth(resolve(10.0, 0.0, Some(-20.0), None)), Ok((-20.0, false)));
    assert_eq!(depth(resolve(10.0, 0.0, Some(0.0), Some(0.0))), Ok((0.0, false)));
    assert_eq!(depth(resolve(10.0, 0.0, Some(-20.0), Some(-25.0))), Ok((-25.0, true)));
    assert_eq!(depth(resolve(10.0, 0.0, None, Some(25.0))), Ok((-25.0, false)));
    assert_eq!(depth(resolve(-10.0, 0.0, None, Some(25.0))), Ok((25.0, false)));
    assert_eq!(depth(resolve(0.0, 0.0, Some(-20.0), None)), Ok((-20.0, false)));
    assert_eq!(depth(resolve(0.0, 0.0, None, Some(20.0))), Err(DrillingFault::ReferencePlane));
    assert_eq!(depth(resolve(10.0, 0.0, Some(20.0), None)), Err(DrillingFault::ReferencePlane));
    let at = levels(10.0, 0.0, 1.0, -20.0);
    assert_eq!(Pecking::first_step(&at, Some(-5.0), None), Some(5.0));
    assert_eq!(Pecking::first_step(&at, Some(5.0), None), None);
    assert_eq!(Pecking::first_step(&at, Some(-5.0), Some(50.0)), Some(20.0));
    assert_eq!(Pecking::first_step(&at, None, None), None);
}

#[test]
fn refusals() {
    let code = |drilling: Drilling| expand(&drilling, &Pos::UNKNOWN, XYZ, &mut |_| ()).expect_err("refused").code().id;
    let at = levels(50.0, 0.0, 2.0, -20.0);
    assert_eq!(code(hole(levels(f64::NAN, 0.0, 2.0, -20.0), Method::Drill { dwell: 0.0 })), "G3041");
    assert_eq!(code(hole(levels(-50.0, 0.0, 2.0, -20.0), Method::Drill { dwell: 0.0 })), "G3041");
    assert_eq!(code(hole(at, Method::Drill { dwell: -1.0 })), "G3041");
    let endless = Degression::Factor { factor: 0.5, least: 0.0 };
    assert_eq!(code(hole(at, breaking(5.0, endless))), "G3040");
    assert_eq!(code(hole(at, breaking(1e-9, Degression::constant(1e-9)))), "G3040");
    assert_eq!(code(hole(at, breaking(0.0, endless))), "G3041");
    let bore = Bore { dwell: 0.0, turn: Turn::Clockwise, orient: 0.0, back: None, lift: [1.0, 0.0, 0.0] };
    assert_eq!(code(hole(at, Method::Bore(bore))), "G3043");
    let none = Drilling { feed: Feed::PerMinute(0.0), ..hole(at, Method::Drill { dwell: 0.0 }) };
    assert_eq!(code(none), "G3041");
}

proptest! {
    /// Steps go one way, end at the bottom, and none is longer than the one before.
    #[test]
    fn steps_never_grow(total in 1.0f64..300.0, first in 0.5f64..60.0, value in 0.05f64..20.0, factor in any::<bool>()) {
        let degression = if factor {
            Degression::Factor { factor: (value / 20.0).min(1.0), least: value / 4.0 }
        } else {
            Degression::Amount(value)
        };
        // A tiny factor makes more steps than anybody drills.
        let Ok(list) = depths(&levels(5.0, 0.0, 1.0, -total), first, degression) else { return Ok(()) };
        prop_assert_eq!(*list.last().unwrap(), -total);
        let mut before = 0.0;
        for z in list {
            prop_assert!(z < before);
            before = z;
        }
    }
}
