//! The straight block: a line of the file with X, Y, Z, a feed, G0 or G1 and nothing else, decoded where it stands. In SINUMERIK
//! it may be an arc, too: G2 or G3 with I and J.
//!
//! In: the text of the file from the next block on. Out: what the words of its first line say, or nothing where it holds
//! anything else, or does not end in the text. `of_line` of a dialect decodes the bytes, `of_block` looks at a block that was
//! parsed: property tests hold both equal.

use crate::machine::{Axis, AxisSet};
use crate::text::Span;

use super::literal::{self, Shape};

/// What a straight block says.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Straight {
    /// X, Y and Z as written; only those in `axes` count.
    pub values: [f64; 3],
    /// Axes that are named; one at least.
    pub axes: AxisSet,
    /// As written, above zero.
    pub feed: Option<f64>,
    /// I and J as written; only those of the axes in `centered`, X and Y, count.
    pub center: [f64; 2],
    pub centered: AxisSet,
    /// G0 to G3 stands in the block, by its number.
    pub motion: Option<u8>,
    /// `FMAX`
    pub rapid: bool,
    /// `R0`
    pub uncompensated: bool,
    /// The block from its first word to its last.
    pub words: Span,
    /// Bytes of the line, its end included.
    pub len: usize,
}

impl Straight {
    /// Takes a word of an axis; `None` where it is named twice.
    #[inline(always)]
    pub(super) fn go(&mut self, axis: Axis, value: f64) -> Option<()> {
        let named = self.axes.contains(axis);
        *self.values.get_mut(axis.index())? = value;
        self.axes.insert(axis);
        (!named).then_some(())
    }

    /// Takes I or J by its axis; `None` where it is named twice.
    #[inline(always)]
    pub(super) fn about(&mut self, axis: Axis, value: f64) -> Option<()> {
        let named = self.centered.contains(axis);
        *self.center.get_mut(axis.index())? = value;
        self.centered.insert(axis);
        (!named).then_some(())
    }

    /// Takes a G code; `None` where it is none of G0 to G3, or not the only one.
    #[inline(always)]
    pub(super) fn code(&mut self, number: f64) -> Option<()> {
        let first = self.motion.is_none();
        let known = [0.0, 1.0, 2.0, 3.0].iter().position(|code| *code == number)?;
        self.motion = Some(known as u8);
        first.then_some(())
    }

    /// Takes F; `None` where there is a feed already, or where the number is none.
    #[inline]
    pub(super) fn feed(&mut self, value: f64) -> Option<()> {
        let first = self.feed.is_none() && !self.rapid && value > 0.0 && value.is_finite();
        self.feed = Some(value);
        first.then_some(())
    }
}

/// Reads the words at `at` up to the end of the line.
#[inline(always)]
pub(super) fn read<S: Shape<Block = Straight>>(text: &[u8], from: usize, at: usize, line_end: u8) -> Option<Straight> {
    let mut line = Straight::default();
    let (end, last) = literal::words::<S>(text, at, at, &mut line)?;
    if line.axes.is_empty() {
        return None;
    }
    line.len = match *text.get(last)? {
        byte if byte == line_end => last + 1,
        b'\r' if line_end == b'\n' && text.get(last + 1) == Some(&b'\n') => last + 2,
        _ => return None,
    };
    line.words = Span { start: from as u32, end: end as u32 };
    Some(line)
}

/// Does `byte` end the line?
#[inline(always)]
pub(super) fn ends_line(byte: u8) -> bool {
    byte < b' ' && matches!(byte, b'\n' | b'\r')
}
