//! One output line under construction.

use super::number::{Places, write_whole};

/// Collects the words of a line.
#[derive(Debug, Default)]
pub struct Line {
    text: Vec<u8>,
}

impl Line {
    pub fn clear(&mut self) {
        self.text.clear();
    }

    pub fn is_empty(&self) -> bool {
        self.text.is_empty()
    }

    pub fn len(&self) -> usize {
        self.text.len()
    }

    pub fn bytes(&self) -> &[u8] {
        &self.text
    }

    /// Appends text as it is, with a blank in front unless the line is empty.
    #[inline]
    pub fn word(&mut self, word: &[u8]) -> &mut Line {
        if !self.text.is_empty() {
            self.text.push(b' ');
        }
        self.text.extend_from_slice(word);
        self
    }

    /// Appends an address with a number in units of `places`.
    #[inline]
    pub fn number(&mut self, address: u8, units: i64, places: Places) -> &mut Line {
        if !self.text.is_empty() {
            self.text.push(b' ');
        }
        self.text.push(address);
        places.write(units, &mut self.text);
        self
    }

    /// Appends an address with a whole number.
    pub fn whole(&mut self, address: u8, number: u64) -> &mut Line {
        if !self.text.is_empty() {
            self.text.push(b' ');
        }
        self.text.push(address);
        write_whole(number, &mut self.text);
        self
    }

    /// Appends without a blank in front.
    pub fn raw(&mut self, bytes: &[u8]) -> &mut Line {
        self.text.extend_from_slice(bytes);
        self
    }
}
