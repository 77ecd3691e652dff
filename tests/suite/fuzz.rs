//! The fuzz targets without a fuzzer: each takes nothing, its seeds, and damaged seeds, the same ones in each run.

use super::book::cases;
use super::damage::{Dice, KINDS, damage};
use super::targets::ALL;

/// Damaged inputs for each target.
const DAMAGED: usize = 300;

/// The golden programs that are seeds of a target, or their configurations.
fn seeds(target: &str) -> Vec<&'static [u8]> {
    let folder = match target {
        "parse_klartext" | "compile_klartext" => "klartext",
        "parse_turning" | "compile_turning" => "heidenhain-turning",
        "mtc200" => "mtc200",
        "gcode" => "gcode",
        _ => "sinumerik",
    };
    let all = cases(folder).into_iter();
    if target == "tables" {
        all.map(|case| case.config.as_bytes()).filter(|config| !config.is_empty()).collect()
    } else {
        all.map(|case| &case.program[..]).collect()
    }
}

#[test]
fn every_target_takes_seeds_and_damaged_seeds() {
    for (name, target) in ALL {
        target(b"");
        let seeds = seeds(name);
        assert!(seeds.len() > 10, "{} seeds for {name}", seeds.len());
        let blocks = name.starts_with("parse_");
        let mut dice = Dice(0xf022_0000 ^ seeds.len() as u64);
        for n in 0..DAMAGED {
            let mut bytes = seeds[dice.roll(seeds.len())].to_vec();
            if n >= seeds.len() || n % 2 == 1 {
                (0..=dice.roll(3)).for_each(|_| damage(&mut bytes, dice.roll(KINDS), &mut dice));
            }
            if blocks {
                bytes.split(|b| *b == b'\n').for_each(target);
            } else {
                target(&bytes);
            }
        }
    }
}

/// Lone carriage returns beside bytes that are not UTF-8.
#[test]
fn findings_that_the_fuzzer_made() {
    let all = |bytes: &[u8]| ALL.iter().for_each(|(_, target)| target(bytes));
    all(b"; A\r\x01\0feed\x81\x81\xff\xff\0");
    all(b"; A\r\0\x1aL X+1\x1a\0\0");
    all(b"; \r\x1aL X1 F5\x0b\x1a");
    all(b"\xff\r;\r\0\r\0L Y1");
}
