//! Columns that grow value by value.

use std::sync::Arc;

use arrow_array::cast::AsArray;
use arrow_array::types::Int32Type;
use arrow_array::{
    Array, ArrayRef, BooleanArray, DictionaryArray, Float64Array, Int32Array, Int64Array, StringArray, new_null_array,
};
use arrow_buffer::{BooleanBufferBuilder, NullBuffer, NullBufferBuilder, ScalarBuffer};
use arrow_schema::DataType;

/// Values of which some are missing. Where all are, nothing is kept.
#[derive(Debug)]
pub struct Values<T> {
    values: Vec<T>,
    /// Rows without a value: from, and up to.
    gaps: Vec<(usize, usize)>,
    /// The array of the last batch, if it held nothing.
    empty: Option<ArrayRef>,
}

impl<T: Copy + Default> Values<T> {
    pub fn new() -> Values<T> {
        Values { values: Vec::new(), gaps: Vec::new(), empty: None }
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
        self.gaps.push((self.values.len(), rows));
        self.values.resize(rows, T::default());
    }

    /// What so many rows hold; nothing where no row has a value.
    fn take(&mut self, rows: usize) -> Option<(Vec<T>, Option<NullBuffer>)> {
        if self.values.is_empty() {
            return None;
        }
        if self.values.len() < rows {
            self.fill(rows);
        }
        let nulls = self.nulls(rows);
        // The next batch is as long.
        Some((std::mem::replace(&mut self.values, Vec::with_capacity(rows)), nulls))
    }

    fn nulls(&mut self, rows: usize) -> Option<NullBuffer> {
        if self.gaps.is_empty() {
            return None;
        }
        let mut known = BooleanBufferBuilder::new(rows);
        for (from, to) in self.gaps.drain(..) {
            known.append_n(from - known.len(), true);
            known.append_n(to - from, false);
        }
        known.append_n(rows - known.len(), true);
        Some(NullBuffer::new(known.finish()))
    }

    /// An array of so many rows without a value.
    fn nothing(&mut self, rows: usize, data: &DataType) -> ArrayRef {
        match &self.empty {
            Some(empty) if empty.len() == rows => Arc::clone(empty),
            _ => Arc::clone(self.empty.insert(new_null_array(data, rows))),
        }
    }
}

/// What a column of an Arrow table can hold.
pub trait Cell: Copy + Default {
    const DATA: DataType;

    /// No difference, not in a single bit.
    fn is(self, other: Self) -> bool;

    fn array(values: Vec<Self>, nulls: Option<NullBuffer>) -> ArrayRef;
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

            fn array(values: Vec<Self>, nulls: Option<NullBuffer>) -> ArrayRef {
                Arc::new(<$array>::new(ScalarBuffer::from(values), nulls))
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
    ends: Vec<i32>,
    nulls: Option<NullBufferBuilder>,
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
        self.ends.push(i32::try_from(self.text.len()).unwrap_or(i32::MAX));
    }

    pub fn finish(&mut self) -> ArrayRef {
        let text = std::mem::take(&mut self.text);
        let ends = std::mem::take(&mut self.ends);
        let nulls = self.nulls.take().and_then(|mut nulls| nulls.finish());
        let mut offsets = Vec::with_capacity(ends.len() + 1);
        offsets.push(0);
        offsets.extend(ends);
        let offsets = arrow_buffer::OffsetBuffer::new(ScalarBuffer::from(offsets));
        Arc::new(StringArray::new(offsets, text.into(), nulls))
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
pub fn times(values: Vec<f64>) -> ArrayRef {
    let nulls = values.iter().any(|value| value.is_nan());
    let nulls = nulls.then(|| NullBuffer::from_iter(values.iter().map(|value| !value.is_nan())));
    let values: Vec<f64> = values.into_iter().map(|value| if value.is_nan() { 0.0 } else { value }).collect();
    Arc::new(Float64Array::new(ScalarBuffer::from(values), nulls))
}
