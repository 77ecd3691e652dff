//! Columns that grow value by value.

use std::sync::Arc;

use arrow_array::cast::AsArray;
use arrow_array::types::Int32Type;
use arrow_array::{
    Array, ArrayRef, BooleanArray, DictionaryArray, Float64Array, Int32Array, Int64Array, StringArray, new_null_array,
};
use arrow_buffer::{
    ArrowNativeType, BooleanBuffer, BooleanBufferBuilder, Buffer, NullBuffer, NullBufferBuilder, OffsetBuffer,
    ScalarBuffer,
};
use arrow_schema::DataType;

use super::buffer_pool::BufferPool;

/// Values of which some are missing. Where all are, nothing is kept.
#[derive(Debug)]
pub struct Values<T> {
    values: Vec<T>,
    /// Rows without a value: from, and up to.
    gaps: Vec<(usize, usize)>,
    /// The array of the last batch, if it held nothing.
    empty: Option<ArrayRef>,
    pool: BufferPool,
}

/// Gaps up to this are filled value by value.
const SHORT: usize = 16;

impl<T: Copy + Default + ArrowNativeType> Values<T> {
    pub fn new() -> Values<T> {
        Values { values: Vec::new(), gaps: Vec::new(), empty: None, pool: BufferPool::default() }
    }

    /// The value of a row; rows in front of it without one have none.
    #[inline]
    pub fn put(&mut self, row: usize, value: T) {
        if self.values.len() < row {
            self.fill(row);
        }
        self.values.push(value);
    }

    /// The same value in all rows from one on up to another.
    #[inline]
    fn put_through(&mut self, from: usize, to: usize, value: T) {
        self.put(from, value);
        if from + 1 < to {
            self.values.resize(to, value);
        }
    }

    fn fill(&mut self, rows: usize) {
        let from = self.values.len();
        self.gaps.push((from, rows));
        if rows - from > SHORT {
            self.values.resize(rows, T::default());
        } else {
            (from..rows).for_each(|_| self.values.push(T::default()));
        }
    }

    /// What so many rows hold; nothing where no row has a value.
    fn take(&mut self, rows: usize) -> Option<(ScalarBuffer<T>, Option<NullBuffer>)> {
        if self.values.is_empty() {
            return None;
        }
        if self.values.len() < rows {
            self.fill(rows);
        }
        let nulls = self.nulls(rows);
        let values = Buffer::from_vec(std::mem::take(&mut self.values));
        self.pool.hand_out(&values);
        // The next batch is as long.
        self.values = self.pool.take(rows);
        Some((values.into(), nulls))
    }

    fn nulls(&mut self, rows: usize) -> Option<NullBuffer> {
        if self.gaps.is_empty() {
            return None;
        }
        // A bit for each row, the lowest one first.
        let mut known = vec![u64::MAX; rows.div_ceil(64)];
        self.gaps.drain(..).for_each(|(from, to)| clear(&mut known, from, to));
        clear(&mut known, rows, rows.next_multiple_of(64));
        let known = known.into_iter().map(u64::to_le).collect::<Vec<u64>>();
        Some(NullBuffer::new(BooleanBuffer::new(Buffer::from_vec(known), 0, rows)))
    }

    /// An array of so many rows without a value.
    fn nothing(&mut self, rows: usize, data: &DataType) -> ArrayRef {
        match &self.empty {
            Some(empty) if empty.len() == rows => Arc::clone(empty),
            _ => Arc::clone(self.empty.insert(new_null_array(data, rows))),
        }
    }
}

/// Clears the bits from one on up to another.
fn clear(words: &mut [u64], from: usize, to: usize) {
    let mut from = from;
    while from < to {
        let next = (from / 64 + 1) * 64;
        let end = next.min(to);
        let ones = u64::MAX >> (64 - (end - from));
        words[from / 64] &= !(ones << (from % 64));
        from = end;
    }
}

/// What a column of an Arrow table can hold.
pub trait Cell: Copy + Default + ArrowNativeType {
    const DATA: DataType;

    /// No difference, not in a single bit.
    fn is(self, other: Self) -> bool;

    fn array(values: ScalarBuffer<Self>, nulls: Option<NullBuffer>) -> ArrayRef;
}

macro_rules! cell {
    ($cell:ty, $data:expr, $array:ty, $is:expr) => {
        impl Cell for $cell {
            const DATA: DataType = $data;

            #[inline(always)]
            fn is(self, other: Self) -> bool {
                let is: fn(Self, Self) -> bool = $is;
                is(self, other)
            }

            fn array(values: ScalarBuffer<Self>, nulls: Option<NullBuffer>) -> ArrayRef {
                Arc::new(<$array>::new(values, nulls))
            }
        }
    };
}

cell!(f64, DataType::Float64, Float64Array, |a, b| a.to_bits() == b.to_bits());
cell!(i64, DataType::Int64, Int64Array, |a, b| a == b);
cell!(i32, DataType::Int32, Int32Array, |a, b| a == b);

impl<T: Cell> Values<T> {
    pub fn finish(&mut self, rows: usize) -> ArrayRef {
        match self.take(rows) {
            Some((values, nulls)) => T::array(values, nulls),
            None => self.nothing(rows, &T::DATA),
        }
    }
}

/// Values that hold on for many rows.
#[derive(Debug)]
pub struct Held<T> {
    /// The value that holds, since this row.
    value: Option<T>,
    since: usize,
    values: Values<T>,
    /// The array of the last batch, if one value held through it.
    even: Option<(T, ArrayRef)>,
}

impl<T: Cell> Held<T> {
    pub fn new() -> Held<T> {
        Held { value: None, since: 0, values: Values::new(), even: None }
    }

    /// The value of a row.
    #[inline]
    pub fn put(&mut self, row: usize, value: Option<T>) {
        let same = match (self.value, value) {
            (None, None) => true,
            (Some(a), Some(b)) => a.is(b),
            _ => false,
        };
        if !same {
            self.change(row, value);
        }
    }

    fn change(&mut self, row: usize, value: Option<T>) {
        self.settle(row);
        (self.value, self.since) = (value, row);
    }

    /// Writes down what held up to `row`.
    #[inline]
    fn settle(&mut self, row: usize) {
        if let Some(value) = self.value.filter(|_| row > self.since) {
            self.values.put_through(self.since, row, value);
        }
    }

    pub fn finish(&mut self, rows: usize) -> ArrayRef {
        let all = self.value.filter(|_| self.since == 0);
        if let (Some(value), Some((held, array))) = (all, &self.even)
            && held.is(value)
            && array.len() == rows
        {
            return Arc::clone(array);
        }
        self.settle(rows);
        self.since = 0;
        let array = self.values.finish(rows);
        self.even = all.map(|value| (value, Arc::clone(&array)));
        array
    }
}

/// Words of which each different one is kept once, for all batches.
#[derive(Debug)]
pub struct Words {
    keys: Held<i32>,
    words: Vec<String>,
    /// `words` as the last batch had them.
    array: ArrayRef,
}

impl Words {
    pub fn new(words: &[&str]) -> Words {
        let array = Arc::new(StringArray::from(words.to_vec()));
        Words { keys: Held::new(), words: words.iter().map(|word| (*word).to_owned()).collect(), array }
    }

    /// A new word: its key is the next one.
    pub fn add(&mut self, word: &str) {
        self.words.push(word.to_owned());
    }

    #[inline]
    pub fn put(&mut self, row: usize, key: Option<i32>) {
        self.keys.put(row, key);
    }

    pub fn finish(&mut self, rows: usize) -> ArrayRef {
        if self.array.len() < self.words.len() {
            self.array = Arc::new(StringArray::from_iter_values(&self.words));
        }
        let keys = self.keys.finish(rows).as_primitive::<Int32Type>().clone();
        // Every key is the place of a word.
        Arc::new(DictionaryArray::<Int32Type>::new(keys, Arc::clone(&self.array)))
    }
}

/// Texts of ASCII of which few are the same.
#[derive(Debug, Default)]
pub struct Texts {
    text: Vec<u8>,
    /// Where each text begins, and where the last one ends.
    ends: Vec<i32>,
    nulls: Option<NullBufferBuilder>,
    text_pool: BufferPool,
    ends_pool: BufferPool,
}

impl Texts {
    /// Texts of a batch are far shorter than 2 GiB: a block number has a few digits, and a block [`LONGEST`] of them at most.
    pub fn push(&mut self, text: Option<&[u8]>) {
        let nulls = self.nulls.get_or_insert_with(|| NullBufferBuilder::new(0));
        match text {
            Some(text) => {
                self.text.extend_from_slice(text.get(..LONGEST).unwrap_or(text));
                nulls.append_non_null();
            }
            None => nulls.append_null(),
        }
        if self.ends.is_empty() {
            self.ends.push(0);
        }
        self.ends.push(i32::try_from(self.text.len()).unwrap_or(i32::MAX));
    }

    pub fn finish(&mut self) -> ArrayRef {
        let text = Buffer::from_vec(std::mem::take(&mut self.text));
        if self.ends.is_empty() {
            self.ends.push(0);
        }
        let ends = Buffer::from_vec(std::mem::take(&mut self.ends));
        let nulls = self.nulls.take().and_then(|mut nulls| nulls.finish());
        self.text_pool.hand_out(&text);
        self.ends_pool.hand_out(&ends);
        self.text = self.text_pool.take(0);
        self.ends = self.ends_pool.take(0);
        let offsets = OffsetBuffer::new(ends.into());
        Arc::new(StringArray::new(offsets, text, nulls))
    }
}

/// Characters of one text.
pub const LONGEST: usize = 512;

/// Yes and no.
#[derive(Debug)]
pub struct Truths(BooleanBufferBuilder);

impl Truths {
    pub fn new() -> Truths {
        Truths(BooleanBufferBuilder::new(0))
    }

    pub fn push(&mut self, value: bool) {
        self.0.append(value);
    }

    pub fn finish(&mut self) -> ArrayRef {
        Arc::new(BooleanArray::new(self.0.finish(), None))
    }
}

/// Times in the order of the moves; a place that is no number has none.
pub fn times(mut values: Vec<f64>, pool: &mut BufferPool) -> ArrayRef {
    let nulls = values.iter().any(|value| value.is_nan());
    let nulls = nulls.then(|| NullBuffer::from_iter(values.iter().map(|value| !value.is_nan())));
    values.iter_mut().filter(|value| value.is_nan()).for_each(|value| *value = 0.0);
    let values = Buffer::from_vec(values);
    pool.hand_out(&values);
    Arc::new(Float64Array::new(values.into(), nulls))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bits_are_cleared_over_the_ends_of_words() {
        for from in 0..192 {
            for to in from..=192 {
                let mut words = [u64::MAX; 3];
                clear(&mut words, from, to);
                let is_set = |bit: usize| words[bit / 64] >> (bit % 64) & 1 == 1;
                assert!((0..192).all(|bit| is_set(bit) != (from..to).contains(&bit)), "{from} to {to}");
            }
        }
    }

    #[test]
    fn a_column_tells_which_rows_have_a_value() {
        for rows in [1_usize, 63, 64, 65, 200] {
            let mut column = Values::<f64>::new();
            // Twice, so that what the first batch left is seen in the second.
            for step in [3, 7] {
                (0..rows).step_by(step).for_each(|row| column.put(row, row as f64));
                let array = column.finish(rows);
                let array = array.as_primitive::<arrow_array::types::Float64Type>();
                let found: Vec<Option<f64>> = array.iter().collect();
                let due: Vec<Option<f64>> = (0..rows).map(|row| (row % step == 0).then_some(row as f64)).collect();
                assert_eq!(found, due, "{rows} rows");
            }
        }
    }
}
