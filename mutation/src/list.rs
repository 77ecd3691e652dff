//! The list that `cargo mutants --list --json` makes, and a sample of it.

use std::fs;

use serde_json::Value;

use super::{Places, Result};

/// What kind of change, as far as it matters how it is built in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Genre {
    /// The body of a function gives a fixed value.
    Body,
    /// An operator, or a field of a struct with a base: text within an expression is replaced.
    Part,
    Arm,
    Guard,
}

/// A change of the sample.
#[derive(Debug, Clone)]
pub struct Mutant {
    /// Counted from 1 in the order of the sample.
    pub number: usize,
    pub file: String,
    pub name: String,
    pub genre: Genre,
    /// The function gives an `impl` of something: one type, which only its body says.
    pub is_opaque: bool,
    /// Line and column of what is replaced, both from 1; the end is behind it.
    pub start: (usize, usize),
    pub end: (usize, usize),
    pub replacement: String,
}

/// Draws `count` changes of the list, the same ones for the same seed. More of them begin with the same ones.
pub fn sample(places: &Places, seed: u64, count: usize) -> Result<()> {
    let text = fs::read_to_string(places.work.join("mutants.json"))?;
    let mut all: Vec<Value> = serde_json::from_str(&text)?;
    let listed = all.len();
    let mut random = Random(seed);
    // The first part of a shuffle.
    for at in 0..count.min(listed) {
        let left = (listed - at) as u64;
        let other = at + usize::try_from(random.next() % left)?;
        all.swap(at, other);
    }
    all.truncate(count);
    for mutant in &mut all {
        if let Some(fields) = mutant.as_object_mut() {
            fields.remove("diff");
        }
    }
    fs::write(places.work.join("sample.json"), serde_json::to_string_pretty(&all)?)?;
    fs::write(places.work.join("seed"), format!("{seed}\n{listed}\n"))?;
    for stale in ["left_out.tsv", "tests.tsv", "verdicts.tsv"] {
        let _ = fs::remove_file(places.work.join(stale));
    }
    println!("{} of {listed} changes, seed {seed}", all.len());
    Ok(())
}

/// Keeps the sample and what a test caught, and forgets the rest: tests were added, or the machine was busy. Those that stand in a file of the sample stand
/// behind all that is changed in it.
pub fn again(places: &Places) -> Result<()> {
    let path = places.work.join("verdicts.tsv");
    let known = fs::read_to_string(&path)?;
    let is_kept = |line: &&str| line.split('\t').nth(1) == Some("caught");
    let kept: String = known.lines().filter(is_kept).map(|line| format!("{line}\n")).collect();
    fs::write(&path, kept)?;
    for stale in ["programs.tsv", "tests.tsv"] {
        fs::remove_file(places.work.join(stale))?;
    }
    Ok(())
}

/// The sample.
pub fn read(places: &Places) -> Result<Vec<Mutant>> {
    let text = fs::read_to_string(places.work.join("sample.json"))?;
    let all: Vec<Value> = serde_json::from_str(&text)?;
    all.iter().enumerate().map(|(at, value)| mutant(at + 1, value).ok_or_else(|| format!("{value}").into())).collect()
}

fn mutant(number: usize, value: &Value) -> Option<Mutant> {
    let text = |key: &str| value.get(key)?.as_str().map(str::to_owned);
    let place = |key: &str| {
        let at = value.get("span")?.get(key)?;
        let count = |key: &str| at.get(key)?.as_u64().and_then(|count| usize::try_from(count).ok());
        Some((count("line")?, count("column")?))
    };
    let genre = match value.get("genre")?.as_str()? {
        "FnValue" => Genre::Body,
        "MatchArm" => Genre::Arm,
        "MatchArmGuard" => Genre::Guard,
        "BinaryOperator" | "UnaryOperator" | "StructField" => Genre::Part,
        _ => return None,
    };
    Some(Mutant {
        number,
        file: text("file")?,
        name: text("name")?,
        genre,
        is_opaque: value["function"]["return_type"].as_str().is_some_and(|given| given.contains("impl ")),
        start: place("start")?,
        end: place("end")?,
        replacement: text("replacement")?,
    })
}

/// SplitMix64, by Steele, Lea and Flood.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }
}
