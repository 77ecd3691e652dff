//! Columns that grow value by value.

use std::sync::Arc;

use arrow_array::types::Int32Type;
use arrow_array::{
    Array, ArrayRef, BooleanArray, DictionaryArray, Float64Array, Int32Array, Int64Array, StringArray, new_null_array,
};
use arrow_buffer::{BooleanBufferBuilder, NullBuffer, NullBufferBuilder, ScalarBuffer};
use arrow_schema::DataType;

/// Values of which some are missing. Where all are, nothing is kept but their number.
#[derive(Debug)]
pub struct Values<T> {
    values: Vec<T>,
    nulls: NullBufferBuilder,
    /// Missing values at the end that are not in `values` yet.
    missing: usize,
}

impl<T: Copy + Default> Values<T> {
    pub fn new() -> Values<T> {
        Values { values: Vec::new(), nulls: NullBufferBuilder::new(0), missing: 0 }
    }

    #[inline]
    pub fn push(&mut self, value: Option<T>) {
        match value {
            Some(value) => {
                if self.missing > 0 {
                    self.fill();
                }
                self.values.push(value);
                self.nulls.append_non_null();
            }
            None => self.missing += 1,
        }
    }

    fn fill(&mut self) {
        self.values.resize(self.values.len() + self.missing, T::default());
        self.nulls.append_n_nulls(std::mem::take(&mut self.missing));
    }

    /// What was pushed; `None` where nothing but missing values were, so many.
    fn take(&mut self) -> Result<(Vec<T>, Option<NullBuffer>), usize> {
        if self.values.is_empty() {
            return Err(std::mem::take(&mut self.missing));
        }
        self.fill();
        let nulls = self.nulls.finish();
        // The next batch is as long.
        let capacity = self.values.len();
        Ok((std::mem::replace(&mut self.values, Vec::with_capacity(capacity)), nulls))
    }
}

impl Values<f64> {
    pub fn finish(&mut self) -> ArrayRef {
        match self.take() {
            Ok((values, nulls)) => Arc::new(Float64Array::new(ScalarBuffer::from(values), nulls)),
            Err(missing) => new_null_array(&DataType::Float64, missing),
        }
    }
}

impl Values<i64> {
    pub fn finish(&mut self) -> ArrayRef {
        match self.take() {
            Ok((values, nulls)) => Arc::new(Int64Array::new(ScalarBuffer::from(values), nulls)),
            Err(missing) => new_null_array(&DataType::Int64, missing),
        }
    }
}

/// Words of which each different one is kept once, for all batches.
#[derive(Debug)]
pub struct Words {
    keys: Values<i32>,
    words: Vec<String>,
    /// `words` as the last batch had them.
    array: ArrayRef,
}

impl Words {
    pub fn new(words: &[&str]) -> Words {
        let array = Arc::new(StringArray::from(words.to_vec()));
        Words { keys: Values::new(), words: words.iter().map(|word| (*word).to_owned()).collect(), array }
    }

    /// A new word, and its key.
    pub fn add(&mut self, word: String) -> i32 {
        self.words.push(word);
        i32::try_from(self.words.len() - 1).unwrap_or(i32::MAX)
    }

    #[inline]
    pub fn push(&mut self, key: Option<i32>) {
        self.keys.push(key);
    }

    pub fn finish(&mut self) -> ArrayRef {
        if self.array.len() < self.words.len() {
            self.array = Arc::new(StringArray::from_iter_values(&self.words));
        }
        let keys = match self.keys.take() {
            Ok((values, nulls)) => Int32Array::new(ScalarBuffer::from(values), nulls),
            Err(missing) => Int32Array::new_null(missing),
        };
        // Every key is the place of a word.
        Arc::new(DictionaryArray::<Int32Type>::new(keys, Arc::clone(&self.array)))
    }
}

/// Texts of which few are the same.
#[derive(Debug, Default)]
pub struct Texts {
    text: String,
    ends: Vec<i32>,
    nulls: Option<NullBufferBuilder>,
}

impl Texts {
    /// Texts of a batch are far shorter than 2 GiB: a block number has a few digits, and a block [`LONGEST`] of them at most.
    pub fn push(&mut self, text: Option<&str>) {
        let nulls = self.nulls.get_or_insert_with(|| NullBufferBuilder::new(0));
        match text {
            Some(text) => {
                let cut = text.len().min(LONGEST);
                self.text.push_str(text.get(..cut).unwrap_or_default());
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
        Arc::new(StringArray::new(offsets, text.into_bytes().into(), nulls))
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
