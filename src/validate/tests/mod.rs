//! What is right is never refused; what is wrong is always noticed.

mod faults;
mod streams;

use crate::diag::Diags;
use crate::emit::Printer;
use crate::emit::printer::disturb::Disturbance;
use crate::ir::Origin;
use crate::ir::motion::Sink as _;
use crate::machine::settings::Units;

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
