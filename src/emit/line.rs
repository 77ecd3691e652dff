//! The text under construction: finished lines, and the line that words are added to.

use super::number::{LONGEST, Places, Room, write_whole};

/// Collects words into lines.
#[derive(Debug)]
pub struct Text {
    /// The text up to `end`; what stands behind it is of no account.
    bytes: Vec<u8>,
    end: usize,
    /// Start of the line under construction.
    line: usize,
    /// Units from which a number may have more digits than the target reads, whatever its places.
    many: u64,
    /// Units, and whole ones, from which it has more digits unless they are zeros at its end.
    many_digits: u64,
    many_whole: u64,
    digits: u32,
    whole: u32,
    /// A number of the line has more digits than that.
    too_long: bool,
}

impl Text {
    /// An empty text for numbers of at most `digits` digits, `whole` of them in front of the point; 0 for any number of them.
    pub fn new(capacity: usize, [digits, whole]: [u32; 2]) -> Text {
        let any = |count: u32| if count == 0 { u32::MAX } else { count };
        let [many_digits, many_whole] = [digits, whole].map(|count| 10u64.saturating_pow(any(count)));
        Text {
            bytes: vec![0; capacity],
            end: 0,
            line: 0,
            many: many_digits.min(many_whole),
            many_digits,
            many_whole,
            digits: any(digits),
            whole: any(whole),
            too_long: false,
        }
    }

    fn is_too_long(&self, units: i64, places: Places) -> bool {
        let few = units.unsigned_abs() < self.many_digits.min(places.power().saturating_mul(self.many_whole));
        !few && (places.digits(units) > self.digits || places.whole_digits(units) > self.whole)
    }

    /// Has a number of the line more digits than the target reads? Asking forgets it.
    #[inline]
    pub fn take_too_long(&mut self) -> bool {
        std::mem::take(&mut self.too_long)
    }

    /// Everything, the unfinished line included.
    #[inline]
    pub fn bytes(&self) -> &[u8] {
        &self.bytes[..self.end]
    }

    /// Everything from `from` on, with room behind it that holds anything.
    #[inline]
    pub fn from(&self, from: usize) -> &[u8] {
        &self.bytes[from.min(self.end)..]
    }

    /// Bytes of everything.
    #[inline]
    pub fn len(&self) -> usize {
        self.end
    }

    /// Forgets everything that was collected.
    pub fn clear(&mut self) {
        self.end = 0;
        self.line = 0;
    }

    /// The line under construction.
    pub fn line(&self) -> &[u8] {
        &self.bytes[self.line..self.end]
    }

    /// Bytes of the line under construction.
    #[inline]
    pub fn line_len(&self) -> usize {
        self.end - self.line
    }

    /// Takes the line under construction back.
    pub fn drop_line(&mut self) {
        self.end = self.line;
    }

    /// Room behind the text.
    #[inline(always)]
    fn room(&mut self) -> &mut Room {
        if self.bytes.len() < self.end + LONGEST {
            self.grow(LONGEST);
        }
        self.bytes[self.end..].first_chunk_mut().expect("room was made")
    }

    #[cold]
    fn grow(&mut self, by: usize) {
        self.bytes.resize(self.end + by.max(1 << 12), 0);
    }

    /// Ends the line.
    #[inline(always)]
    pub fn end_line(&mut self) {
        self.room()[0] = b'\n';
        self.end += 1;
        self.line = self.end;
    }

    /// Appends text as it is, with a blank in front unless the line is empty.
    #[inline(always)]
    pub fn word(&mut self, word: &str) -> &mut Text {
        if self.end > self.line {
            self.raw(b" ");
        }
        let len = word.len();
        let room = self.room();
        match *word.as_bytes() {
            [a] => room[0] = a,
            [a, b] => [room[0], room[1]] = [a, b],
            [a, b, c] => [room[0], room[1], room[2]] = [a, b, c],
            [a, b, c, d] => [room[0], room[1], room[2], room[3]] = [a, b, c, d],
            _ => return self.raw(word.as_bytes()),
        }
        self.end += len;
        self
    }

    /// Appends an address with a number in units of `places`.
    #[inline(always)]
    pub fn hot_number(&mut self, address: u8, units: i64, places: Places) {
        if units.unsigned_abs() >= self.many {
            self.too_long |= self.is_too_long(units, places);
        }
        // A line that begins with a number word has no blank in front.
        let blank = self.end > self.line;
        self.end += places.write(blank, address, units, self.room());
    }

    /// The same where it is not called often.
    pub fn number(&mut self, address: u8, units: i64, places: Places) -> &mut Text {
        self.hot_number(address, units, places);
        self
    }

    /// Appends a number without a blank in front, with its sign, whichever it is.
    pub fn signed(&mut self, units: i64, places: Places) -> &mut Text {
        self.too_long |= units.unsigned_abs() >= self.many && self.is_too_long(units, places);
        let sign = if units < 0 { b'-' } else { b'+' };
        self.end += places.signed(false).write(false, sign, units.saturating_abs(), self.room());
        self
    }

    /// Appends an address with a whole number.
    pub fn whole(&mut self, address: u8, number: u64) -> &mut Text {
        let blank = self.end > self.line;
        self.end += write_whole(blank, address, number, self.room());
        self
    }

    /// Appends a number without an address.
    pub fn bare(&mut self, units: i64, places: Places) -> &mut Text {
        self.end += places.write(false, b' ', units, self.room());
        self
    }

    /// Appends a number behind a mark, without a blank in front.
    pub fn joined(&mut self, mark: u8, units: i64, places: Places) -> &mut Text {
        self.too_long |= units.unsigned_abs() >= self.many && self.is_too_long(units, places);
        self.end += places.write(false, mark, units, self.room());
        self
    }

    /// Appends a word that ends with what gives its number, such as `D` or `LIMS=`, and the number.
    pub fn valued(&mut self, word: &str, units: i64, places: Places) -> &mut Text {
        if let Some((last, first)) = word.as_bytes().split_last() {
            if self.end > self.line {
                self.raw(b" ");
            }
            self.raw(first);
            self.end += places.write(false, *last, units, self.room());
        }
        self
    }

    /// Puts `number` of `address` in front of the line.
    #[cold]
    pub fn begin_with(&mut self, address: Option<u8>, number: u64) {
        let mut room = [0; LONGEST];
        let len = write_whole(false, address.unwrap_or_default(), number, &mut room);
        room[len] = b' ';
        let number = &room[usize::from(address.is_none())..=len];
        let (line, end) = (self.line, self.end);
        self.room();
        self.end += number.len();
        self.bytes.copy_within(line..end, line + number.len());
        self.bytes[line..line + number.len()].copy_from_slice(number);
    }

    /// Appends without a blank in front.
    pub fn raw(&mut self, bytes: &[u8]) -> &mut Text {
        let end = self.end + bytes.len();
        if self.bytes.len() < end {
            self.grow(bytes.len());
        }
        self.bytes[self.end..end].copy_from_slice(bytes);
        self.end = end;
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_is_too_long_by_its_digits_or_those_in_front_of_the_point() {
        let places = Places::new(3);
        let is_too_long = |limits: [u32; 2], value: f64| {
            let units = places.units(value).expect("a number");
            Text::new(16, limits).is_too_long(units, places)
        };
        for (limits, value, wanted) in [
            ([7, 0], 1234.567, false),
            ([7, 0], 12345.678, true),
            // Nobody writes the zeros behind the point.
            ([7, 0], 1_234_567.0, false),
            ([7, 0], 123_456_789.0, true),
            ([0, 4], 9999.999, false),
            ([0, 4], -10000.0, true),
            ([8, 4], 1234.567, false),
            ([0, 0], 123_456_789.0, false),
        ] {
            assert_eq!(is_too_long(limits, value), wanted, "{limits:?} {value}");
        }
    }
}
