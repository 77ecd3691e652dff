//! The text under construction: finished lines, and the line that words are added to.

use super::number::{Places, write_whole};

/// Collects words into lines.
#[derive(Debug, Default)]
pub struct Text {
    bytes: Vec<u8>,
    /// Start of the line under construction.
    line: usize,
    /// Units from which a number may have more digits than the target reads.
    many: u64,
    digits: u32,
    /// A number of the line has more digits than that.
    too_long: bool,
}

impl Text {
    /// An empty text for numbers of at most `digits` digits; 0 for any number of them.
    pub fn new(capacity: usize, digits: u32) -> Text {
        let many = if digits == 0 { u64::MAX } else { 10u64.saturating_pow(digits) };
        Text { bytes: Vec::with_capacity(capacity), line: 0, many, digits, too_long: false }
    }

    /// Has a number of the line more digits than the target reads? Asking forgets it.
    #[inline]
    pub fn take_too_long(&mut self) -> bool {
        std::mem::take(&mut self.too_long)
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
    pub fn word(&mut self, word: &str) -> &mut Text {
        if self.bytes.len() > self.line {
            self.bytes.push(b' ');
        }
        self.bytes.extend_from_slice(word.as_bytes());
        self
    }

    /// Appends an address with a number in units of `places`.
    #[inline]
    pub fn number(&mut self, address: u8, units: i64, places: Places) -> &mut Text {
        if units.unsigned_abs() >= self.many {
            self.too_long |= places.digits(units) > self.digits;
        }
        // A line that begins with a number word has no blank in front.
        let blank = self.bytes.len() > self.line;
        places.write(blank, address, units, &mut self.bytes);
        self
    }

    /// Appends an address with a whole number.
    pub fn whole(&mut self, address: u8, number: u64) -> &mut Text {
        if self.bytes.len() > self.line {
            self.bytes.push(b' ');
        }
        self.bytes.push(address);
        write_whole(number, &mut self.bytes);
        self
    }

    /// Appends without a blank in front.
    pub fn raw(&mut self, bytes: &[u8]) -> &mut Text {
        self.bytes.extend_from_slice(bytes);
        self
    }
}
