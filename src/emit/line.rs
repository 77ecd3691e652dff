//! The text under construction: finished lines, and the line that words are added to.

use super::number::{Places, write_whole};

/// Collects words into lines.
#[derive(Debug, Default)]
pub struct Text {
    bytes: Vec<u8>,
    /// Start of the line under construction.
    line: usize,
}

impl Text {
    pub fn with_capacity(capacity: usize) -> Text {
        Text { bytes: Vec::with_capacity(capacity), line: 0 }
    }

    /// Everything, the unfinished line included.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// Forgets everything that was collected.
    pub fn clear(&mut self) {
        self.bytes.clear();
        self.line = 0;
    }

    /// The line under construction.
    pub fn line(&self) -> &[u8] {
        &self.bytes[self.line..]
    }

    /// Takes the line under construction back.
    pub fn drop_line(&mut self) {
        self.bytes.truncate(self.line);
    }

    /// Ends the line.
    #[inline]
    pub fn end_line(&mut self) {
        self.bytes.push(b'\n');
        self.line = self.bytes.len();
    }

    /// Appends text as it is, with a blank in front unless the line is empty.
    #[inline]
    pub fn word(&mut self, word: &[u8]) -> &mut Text {
        if self.bytes.len() > self.line {
            self.bytes.push(b' ');
        }
        self.bytes.extend_from_slice(word);
        self
    }

    /// Appends an address with a number in units of `places`.
    #[inline]
    pub fn number(&mut self, address: u8, units: i64, places: Places) -> &mut Text {
        // A line that begins with a number word has no blank in front.
        let blank = self.bytes.len() > self.line;
        places.write(blank, address, units, &mut self.bytes);
        self
    }

    /// Appends an address with a whole number.
    pub fn whole(&mut self, address: u8, number: u64) -> &mut Text {
        self.word(&[address]);
        write_whole(number, &mut self.bytes);
        self
    }

    /// Appends without a blank in front.
    pub fn raw(&mut self, bytes: &[u8]) -> &mut Text {
        self.bytes.extend_from_slice(bytes);
        self
    }
}
