//! What `examples/quality.rs` measures, with few tries.

use std::path::Path;

use super::quality::{arcs, malformed, numbers};

#[test]
fn malformed_programs_of_every_language() {
    let tried = malformed::malformed(malformed::Amount { cut: 3, damaged: 12, rounds: 54 });
    assert_eq!((tried.panics.len(), tried.outputs, tried.unlocated), (0, 0, 0), "{:?}", tried.panics.first());
    assert!(tried.cuts > 1_000 && tried.programs > tried.cuts + 4 * 12 * 54, "{tried:?}");
    assert!(tried.findings > tried.programs / 4, "{tried:?}");
}

#[test]
fn numbers_are_the_nearest_decimals() {
    let printed = numbers::numbers(200_000, 2_000);
    assert_eq!(printed.wrong, None);
    assert_eq!((printed.ties, printed.numbers), (28_000, 284_000));
}

#[test]
fn printed_arcs_close() {
    for decimals in [3, 4] {
        let seen = arcs::arcs(40, decimals);
        assert_eq!(seen.unread, None);
        assert!(seen.arcs > 100 && seen.worst <= 1.5, "{seen:?}");
    }
}

#[cfg(unix)]
#[test]
fn hostile_names_lead_nowhere() {
    let under = Path::new(env!("CARGO_TARGET_TMPDIR")).join("quality");
    let seen = super::quality::names::escapes(Path::new(env!("CARGO_BIN_EXE_partc")), &under);
    assert!(seen.wrong.is_empty(), "{:#?}", seen.wrong);
    assert!(seen.names >= 200, "{}", seen.names);
}

#[test]
fn the_same_bytes_whatever_the_circumstances() {
    let under = Path::new(env!("CARGO_TARGET_TMPDIR")).join("quality");
    let seen = super::quality::same::same(Path::new(env!("CARGO_BIN_EXE_partc")), &under, 60);
    assert!(seen.differ.is_empty() && seen.outputs > 10 && seen.ways == 7, "{seen:?}");
}
