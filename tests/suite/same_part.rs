//! The same part in two dialects gives the same motion. The books under `tests/golden/same_part` have a chapter for each
//! part, and in it a program for each dialect.

use std::collections::BTreeMap;

use super::book::{self, Case};
use partc::internals::machine::axis::AXES;
use partc::internals::machine::settings::Quantity;

use super::meant::{Does, Found, How, Kind, Way, tolerance};
use super::reader;

/// The moves of the output that go somewhere; the plane is none of theirs, and how corners are taken a matter of the machine.
fn moves(case: &Case) -> Vec<(Way, How)> {
    let compiled = case.compile();
    assert!(!compiled.has_errors(), "{}: {:?}", case.name, compiled.rendered);
    let found = reader::read(&compiled.output, case.settings().output.places(Quantity::Length));
    let found = found.unwrap_or_else(|why| panic!("{}: {why}", case.name));
    let moves = found.into_iter().filter_map(|found| match found {
        Found::Move(way, how) => Some((way, How { plane: None, corners: None, ..how })),
        Found::Does(Does::Tap { axis, to, lead, turn, speed }) => {
            let mut end = [0.0; AXES];
            end[axis] = to;
            let feed = Some((Kind::PerRevolution, speed));
            Some((Way::Feed(end), How { feed, lead: Some(lead * f64::from(turn)), ..How::default() }))
        }
        Found::Does(_) => None,
    });
    moves.collect()
}

fn near(a: &[f64], b: &[f64]) -> bool {
    // Each has been rounded for itself, and a radius is half of a diameter.
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 2.0 * tolerance(4))
}

fn same(a: &(Way, How), b: &(Way, How)) -> bool {
    let way = match (&a.0, &b.0) {
        (Way::Rapid(a), Way::Rapid(b)) | (Way::Feed(a), Way::Feed(b)) => near(a, b),
        (
            Way::Arc { plane, center, turns, end },
            Way::Arc { plane: other_plane, center: other, turns: other_turns, end: other_end },
        ) => plane == other_plane && turns == other_turns && near(center, other) && near(end, other_end),
        _ => false,
    };
    way && a.1 == b.1
}

#[test]
fn the_same_part_in_two_dialects_gives_the_same_motion() {
    let mut parts: BTreeMap<&str, Vec<&Case>> = BTreeMap::new();
    for case in book::cases("same_part/mill").into_iter().chain(book::cases("same_part/lathe")) {
        parts.entry(&case.chapter).or_default().push(case);
    }
    let mut different = Vec::new();
    let mut pairs: BTreeMap<(&str, &str), usize> = BTreeMap::new();
    for (part, cases) in &parts {
        let all: Vec<Vec<(Way, How)>> = cases.iter().map(|case| moves(case)).collect();
        assert!(cases.len() >= 2 && all[0].len() >= 2, "{part}: {} programs, {} moves", cases.len(), all[0].len());
        for (i, case) in cases.iter().enumerate() {
            for (other, moves) in cases.iter().zip(&all).skip(i + 1) {
                *pairs.entry((&case.dialect, &other.dialect)).or_default() += 1;
                let at = all[i].iter().zip(moves).position(|(a, b)| !same(a, b));
                if at.is_some() || all[i].len() != moves.len() {
                    let at = at.unwrap_or(all[i].len().min(moves.len()));
                    let (a, b) = (all[i].get(at), moves.get(at));
                    different.push(format!("{part}: move {at}\n  {}: {a:?}\n  {}: {b:?}", case.heading, other.heading));
                }
            }
        }
    }
    println!("{} parts: {pairs:?}", parts.len());
    assert!(different.is_empty(), "{}", different.join("\n"));
    assert!(parts.len() >= 45, "{} parts", parts.len());
    assert!(pairs.len() >= 5 && pairs.values().all(|count| *count >= 8), "{pairs:?}");
}
