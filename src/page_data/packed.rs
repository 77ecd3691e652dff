//! Parts behind each other: a number of parts, the length of each, and the parts, each filled up to eight bytes. Numbers have
//! the low byte first. The first part is JSON, whose `parts` names the others.

use serde_json::{Value, json};

use crate::text::decode::escaped_json;

/// Parts with their names.
#[derive(Debug, Default)]
pub struct Packed {
    parts: Vec<(&'static str, Vec<u8>)>,
}

impl Packed {
    pub fn part(&mut self, name: &'static str, bytes: Vec<u8>) {
        self.parts.push((name, bytes));
    }

    pub fn words(&mut self, name: &'static str, words: &[u32]) {
        self.part(name, words.iter().flat_map(|word| word.to_le_bytes()).collect());
    }

    pub fn halves(&mut self, name: &'static str, words: &[u16]) {
        self.part(name, words.iter().flat_map(|word| word.to_le_bytes()).collect());
    }

    pub fn numbers(&mut self, name: &'static str, numbers: &[f32]) {
        self.part(name, numbers.iter().flat_map(|number| number.to_le_bytes()).collect());
    }

    /// All parts behind `about`.
    pub fn bytes(self, mut about: Value) -> Vec<u8> {
        about["parts"] = json!(self.parts.iter().map(|(name, _)| *name).collect::<Vec<_>>());
        let about = escaped_json(&about.to_string()).into_owned().into_bytes();
        let parts = || std::iter::once(&about).chain(self.parts.iter().map(|(_, bytes)| bytes));
        let whole = 4 * (self.parts.len() + 2) + parts().map(|part| part.len() + 8).sum::<usize>();
        let mut out = Vec::with_capacity(whole);
        out.extend_from_slice(&(self.parts.len() as u32 + 1).to_le_bytes());
        for part in parts() {
            out.extend_from_slice(&(part.len() as u32).to_le_bytes());
        }
        for part in parts() {
            out.resize(out.len().next_multiple_of(8), 0);
            out.extend_from_slice(part);
        }
        out
    }
}
