//! Memory of columns that were handed out, for the next ones: fresh memory of the system costs more than filling it.

use std::collections::VecDeque;

use arrow_buffer::{ArrowNativeType, Buffer};

/// Who takes batches one by one still has the last one when the next is full.
const OUT: usize = 2;
/// Bytes of a column that is kept: of longer ones the memory is worth more than the time.
const MOST: usize = 1 << 20;

/// Columns that were handed out, the oldest first.
#[derive(Debug, Default)]
pub struct BufferPool(VecDeque<Buffer>);

impl BufferPool {
    pub fn hand_out(&mut self, column: &Buffer) {
        if column.capacity() <= MOST {
            self.0.push_back(column.clone());
        }
    }

    /// An empty vector: the memory of a column that nobody reads any more, or of its own for so many values.
    pub fn take<T: ArrowNativeType>(&mut self, values: usize) -> Vec<T> {
        let oldest = if self.0.len() > OUT { self.0.pop_front() } else { None };
        match oldest.map(Buffer::into_vec) {
            Some(Ok(mut free)) => {
                free.clear();
                free
            }
            _ => Vec::with_capacity(values),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn column(pool: &mut BufferPool, value: i32) -> Buffer {
        let mut values = pool.take::<i32>(4);
        assert!(values.is_empty() && values.capacity() >= 4);
        values.extend([value; 4]);
        let column = Buffer::from_vec(values);
        pool.hand_out(&column);
        column
    }

    #[test]
    fn memory_is_taken_again_when_nobody_reads_it() {
        let mut pool = BufferPool::default();
        let places: Vec<usize> = (0..9).map(|n| column(&mut pool, n).as_ptr() as usize).collect();
        assert_eq!(places[3..], places[..6]);
        assert_eq!(pool.0.len(), OUT + 1);
    }

    #[test]
    fn what_somebody_reads_stays_as_it_is() {
        let mut pool = BufferPool::default();
        let all: Vec<Buffer> = (0..9).map(|n| column(&mut pool, n)).collect();
        for (n, column) in all.iter().enumerate() {
            assert_eq!(column.typed_data::<i32>(), [n as i32; 4]);
        }
    }

    #[test]
    fn long_columns_are_not_kept() {
        let mut pool = BufferPool::default();
        pool.hand_out(&Buffer::from_vec(vec![0_u8; MOST + 1]));
        assert!(pool.0.is_empty());
    }
}
