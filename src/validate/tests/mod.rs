//! What is right is never refused; what is wrong is always noticed.

mod faults;
mod streams;
mod taps;
mod tilts;

use crate::diag::Diags;
use crate::emit::Printer;
use crate::emit::printer::disturb::Disturbance;
use crate::geo::Plane;
use crate::ir::function::CutterData;
use crate::ir::motion::{Move, Path, Sink as _};
use crate::ir::{Feed, Function, Origin, Pos, Side};
use crate::machine::settings::Units;
use crate::machine::{Axis, AxisSet, Settings};

use super::{Mismatch, Validator};
use streams::{Dice, Item, Stream, stream, stream_for};

/// Streams of a run; the environment variable `PARTC_STREAMS` says another number.
const STREAMS: u64 = 2_000;
/// Items of a stream.
const LENGTH: usize = 12;

/// What happens to the text of an item before it is read.
type Tamper<'a> = &'a mut dyn FnMut(usize, &str) -> Option<String>;

/// Prints a stream and validates it. `disturb` happens in front of the item of this number. `None` where the printer has
/// refused something; whether the text of the whole differs from `usual` comes with it.
fn validate(stream: &Stream, disturb: Option<(usize, Disturbance)>, tamper: Tamper<'_>) -> Option<Outcome> {
    let diags = Diags::default();
    let (mut out, mut text) = (Vec::new(), Vec::new());
    let mut printer = Printer::new(&stream.settings, "part", &diags, &mut out, None);
    let mut validator = Validator::new(&stream.settings);
    printer.hold();
    let mut items = Vec::new();
    let last = stream.items.len() + 1;
    for n in 0..=last {
        if let Some((at, disturbance)) = disturb
            && at == n
        {
            printer.disturb(disturbance);
        }
        let item = n.checked_sub(1).and_then(|n| stream.items.get(n));
        let origin = Origin::default();
        match item {
            Some(Item::Move(mv)) => printer.movement(mv, &origin),
            Some(Item::Tap(tap, place)) => printer.tap(tap, place, &origin),
            Some(Item::Function(function)) => printer.function(function, &origin),
            Some(Item::BeginsAt(at)) => printer.begins_at(at),
            None if n == last => printer.close(),
            None => {}
        }
        let (bytes, end) = printer.held();
        let piece = String::from_utf8(bytes[..end].to_vec()).expect("ASCII");
        let piece = tamper(n, &piece).unwrap_or(piece);
        text.extend_from_slice(piece.as_bytes());
        items.push(piece.clone());
        if !diags.has_errors() {
            let (bytes, end) = (piece.as_bytes(), piece.len());
            match item {
                Some(Item::Move(mv)) => validator.movement(mv, &origin, bytes, end),
                Some(Item::Tap(tap, place)) => validator.tap(tap, place, &origin, bytes, end),
                Some(Item::Function(function)) => validator.function(function, &origin, bytes, end),
                Some(Item::BeginsAt(at)) => validator.begins_at(at),
                None if n == last => validator.finish(bytes, end),
                None => validator.head(bytes, end),
            }
        }
        printer.release();
    }
    let refused = diags.has_errors();
    (!refused).then(|| Outcome { mismatch: validator.into_mismatch(), pieces: items })
}

struct Outcome {
    mismatch: Option<Box<Mismatch>>,
    /// What was printed for each item, the head and the end.
    pieces: Vec<String>,
}

fn as_it_is(_: usize, _: &str) -> Option<String> {
    None
}

/// Streams of a run.
fn count() -> u64 {
    std::env::var("PARTC_STREAMS").ok().and_then(|text| text.parse().ok()).unwrap_or(STREAMS)
}

#[test]
fn generated_streams_are_printed_as_they_are_meant() {
    let (mut valid, mut lines, mut refused) = (0u64, 0u64, 0u64);
    for seed in 1..=count() {
        let mut dice = Dice(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
        let stream = stream(&mut dice, LENGTH);
        let Some(outcome) = validate(&stream, None, &mut as_it_is) else {
            refused += 1;
            continue;
        };
        if let Some(mismatch) = outcome.mismatch {
            panic!("stream {seed}: {mismatch}\nmeant {}\n{}", mismatch.meant, outcome.pieces.concat());
        }
        valid += 1;
        lines += outcome.pieces.iter().map(|piece| piece.lines().count() as u64).sum::<u64>();
    }
    println!("{valid} streams, {lines} lines, 0 mismatches; {refused} streams were refused by the printer");
    assert!(valid > count() / 2, "{refused} of {} streams are refused", count());
}

/// In millimetres and inches, with all words in each block, with block numbers.
#[test]
fn streams_are_printed_as_they_are_meant_on_every_target() {
    for target in crate::target::ALL {
        let mut valid = 0u64;
        for seed in 1..=count() / 4 {
            let mut dice = Dice(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
            let mut stream = stream_for(&mut dice, LENGTH, target.name);
            // What cannot say which unit it means has millimetres only.
            if !target.m.listed {
                stream.settings.output.units = dice.of(&[Units::Millimetres, Units::Inches]);
            }
            // A line that is too long gives its feed away, which a move by time cannot.
            if target.feed.inverse_time.is_none() {
                stream.settings.output.modal = dice.one_in(2);
                stream.settings.output.line_numbers = dice.of(&[0, 10]);
            }
            let Some(outcome) = validate(&stream, None, &mut as_it_is) else { continue };
            if let Some(mismatch) = outcome.mismatch {
                panic!(
                    "{} stream {seed}: {mismatch}\nmeant {}\n{}",
                    target.name,
                    mismatch.meant,
                    outcome.pieces.concat()
                );
            }
            valid += 1;
        }
        println!("{}: {valid} streams", target.name);
        assert!(valid > count() / 80, "{}: {valid} of {} streams", target.name, count() / 4);
    }
}

/// Behind linuxcnc, the words of the compensation belong into the move; alone, or for another tool, they mean something else.
#[test]
fn a_side_that_is_said_elsewhere_is_noticed() {
    for target in ["fanuc", "sinumerik"] {
        let mut settings = Settings::default();
        settings.output.target = crate::target::find(target).expect("a target");
        let to = |x: f64, y: f64, path: Path, side: Side| {
            let mut end = Pos::UNKNOWN;
            [(Axis::X, x), (Axis::Y, y), (Axis::Z, 1.0)].into_iter().for_each(|(axis, value)| end.set(axis, value));
            Item::Move(Move { end, axes: AxisSet::MAIN, path, side, plane: Plane::Xy, machine: false })
        };
        let cut = Path::Line(Feed::PerMinute(100.0));
        let items = vec![
            Item::Function(Function::ToolChange { number: 3 }),
            Item::Function(Function::Cutter(CutterData { number: 3, ..CutterData::default() })),
            to(-20.0, 0.0, Path::Rapid, Side::None),
            to(0.0, 0.0, cut, Side::Left),
            to(0.0, 30.0, cut, Side::Left),
            to(-20.0, 30.0, cut, Side::None),
        ];
        let stream = Stream { settings, items };
        let right = validate(&stream, None, &mut as_it_is).expect("is printed");
        assert!(right.mismatch.is_none(), "{target}: {:?}", right.mismatch);
        let (on, off) = if target == "fanuc" { ("G41 D3 ", "G40 ") } else { ("G41 ", "G40 ") };
        let faults: [(&str, &str, String); 5] = [
            ("on its own", on, String::new()),
            ("another side", "G41", "G42".to_owned()),
            ("on its own again", off, String::new()),
            ("never", "G41", "G40".to_owned()),
            ("another tool", "D3", "D4".to_owned()),
        ];
        for (what, word, other) in faults {
            let mut changed = false;
            let outcome = validate(&stream, None, &mut |n, text| {
                let hit = n > 0 && text.contains(word) && !text.starts_with("D1");
                changed |= hit;
                let alone = if other.is_empty() { format!("{}\n", word.trim_end()) } else { String::new() };
                hit.then(|| alone + &text.replacen(word, &other, 1))
            });
            let noticed = outcome.is_some_and(|outcome| outcome.mismatch.is_some());
            assert!(noticed || !changed, "{target}: {what} is not noticed");
            assert!(changed || target == "sinumerik" && word == "D3", "{target}: {what} changed nothing");
        }
    }
}
