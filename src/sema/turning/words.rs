//! The words of a block by address, with their values computed.

use crate::diag::{Label, codes};
use crate::lexer::turning::Addr;
use crate::machine::Axis;
use crate::parser::turning::ast::{Block, Value, Word};
use crate::sema::cycle::given::Range;
use crate::sema::run::Where;
use crate::sema::run::refusal::{Made, refused};
use crate::text::Span;

use super::chain::Coord;
use super::eval::Computing;
use super::program_parts::Family;
use super::{Core, Outcome, Reported};

/// Most G or M functions in a block.
const MOST: usize = 12;
const LETTERS: usize = 26;
/// Largest number that is taken.
const LARGEST: f64 = 1e8;

/// A set of single letters.
pub(super) type Letters = u32;

/// The set of these letters.
pub(super) const fn letters(text: &str) -> Letters {
    let bytes = text.as_bytes();
    let (mut set, mut i) = (0, 0);
    while i < bytes.len() {
        set |= 1 << (bytes[i] - b'A');
        i += 1;
    }
    set
}

/// The value of a word.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Num {
    pub value: f64,
    pub incremental: bool,
    /// `?`
    pub unknown: bool,
    pub span: Span,
}

/// A G or M function.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Fun {
    pub number: u16,
    pub span: Span,
}

/// The words of a block.
#[derive(Debug, Clone, Default)]
pub(super) struct Words {
    present: Letters,
    singles: [Num; LETTERS],
    /// Addresses of two or three letters.
    more: Vec<(Addr, Num)>,
    texts: Vec<(Addr, Span)>,
    g: Vec<Fun>,
    m: Vec<Fun>,
}

fn index(letter: u8) -> usize {
    usize::from(letter.wrapping_sub(b'A')) % LETTERS
}

impl Words {
    /// The value behind a letter.
    #[inline]
    pub fn get(&self, letter: u8) -> Option<Num> {
        (self.present & 1 << index(letter) != 0).then(|| self.singles[index(letter)])
    }

    /// The number behind a letter that takes neither `?` nor an incremental mark.
    #[inline]
    pub fn value(&self, letter: u8) -> Option<f64> {
        self.get(letter).map(|num| num.value)
    }

    pub fn has(&self, letter: u8) -> bool {
        self.present & 1 << index(letter) != 0
    }

    #[inline]
    pub fn present(&self) -> Letters {
        self.present
    }

    /// The value behind an address of several letters.
    pub fn long(&self, name: &str) -> Option<Num> {
        if self.more.is_empty() {
            return None;
        }
        let addr = Addr::of(name.as_bytes())?;
        self.more.iter().find(|(known, _)| *known == addr).map(|(_, num)| *num)
    }

    /// A word that another block says for this one.
    pub fn add_long(&mut self, name: &str, num: Num) {
        if let Some(addr) = Addr::of(name.as_bytes()) {
            self.more.push((addr, num));
        }
    }

    pub fn longs(&self) -> &[(Addr, Num)] {
        &self.more
    }

    /// The text behind an address.
    #[inline]
    pub fn text(&self, name: &str) -> Option<Span> {
        if self.texts.is_empty() {
            return None;
        }
        let addr = Addr::of(name.as_bytes())?;
        self.texts.iter().find(|(known, _)| *known == addr).map(|(_, span)| *span)
    }

    pub fn texts(&self) -> &[(Addr, Span)] {
        &self.texts
    }

    #[inline]
    pub fn g(&self) -> &[Fun] {
        &self.g
    }

    #[inline]
    pub fn m(&self) -> &[Fun] {
        &self.m
    }
}

/// How the numbers of words count: millimetres in a unit of the program, and the family of controls that reads them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Measure {
    pub mm: f64,
    pub family: Family,
}

impl Num {
    /// A length in mm that is above zero.
    pub fn above_zero(self, mm: f64, what: &str) -> Made<f64> {
        let length = self.value * mm;
        if length > 0.0 {
            return Ok(length);
        }
        refused(self.span, codes::T1007::has_to_be_above_zero(&what))
    }

    /// The number of a block.
    pub fn block_number(self) -> Option<u32> {
        (self.value.fract() == 0.0 && (0.0..=99_999.0).contains(&self.value)).then_some(self.value as u32)
    }
}

/// What words say by themselves.
impl Words {
    /// A coordinate in mm, X as a radius.
    #[inline]
    pub fn coord(&self, axis: Axis, mm: f64) -> Coord {
        let Some(num) = self.get(axis.letter() as u8) else { return Coord::Stay };
        let mm = mm * if axis == Axis::X { 0.5 } else { 1.0 };
        match (num.unknown, num.incremental) {
            (true, _) => Coord::Open,
            (_, true) => Coord::By(num.value * mm),
            _ => Coord::At(num.value * mm),
        }
    }

    /// The word that a function cannot do without.
    pub fn needed(&self, letter: u8, what: &str) -> Made<Num> {
        match self.get(letter) {
            Some(num) => Ok(num),
            None => refused(Where::Block, codes::P1004::is_missing(&(letter as char), &what)),
        }
    }

    /// The same for a length above zero, in mm.
    pub fn needed_length(&self, letter: u8, mm: f64, what: &str) -> Made<f64> {
        self.needed(letter, what)?.above_zero(mm, what)
    }

    /// A whole number in a range, or the default where the word is missing.
    pub fn choice(&self, letter: u8, default: u32, most: u32) -> Made<u32> {
        let Some(num) = self.get(letter) else { return Ok(default) };
        if num.value.fract() == 0.0 && num.value >= 0.0 && num.value <= f64::from(most) {
            return Ok(num.value as u32);
        }
        refused(num.span, codes::T1007::is_none_of(&(letter as char), &num.value, &Range(0, most as i32)))
    }

    /// Place of a word, or the block where it is not there.
    pub fn place(&self, letter: u8) -> Where {
        self.get(letter).map_or(Where::Block, |num| num.span.into())
    }

    // Reading.

    /// Reads the words of a block.
    #[inline]
    pub fn gather(&mut self, block: &Block, from: &mut Computing<'_, '_>) -> Outcome {
        self.present = 0;
        self.more.clear();
        self.texts.clear();
        self.g.clear();
        self.m.clear();
        block.words.iter().try_for_each(|word| self.gather_word(word, block, from))
    }

    #[inline]
    fn gather_word(&mut self, word: &Word, block: &Block, from: &mut Computing<'_, '_>) -> Outcome {
        let (value, unknown) = match word.value {
            Value::Number { value, .. } => (value, false),
            Value::Unknown => (0.0, true),
            Value::Formula(formula) => (from.formula(block, formula)?, false),
            Value::Text(span) => {
                let first = self.texts.iter().find(|(known, _)| *known == word.address.addr).map(|_| span);
                self.texts.push((word.address.addr, span));
                return from.core.unless_twice(word, first);
            }
        };
        if value.is_nan() || value.abs() > LARGEST {
            return from.core.refuse(word.span, codes::T1007::number_is_too_large_for_any_control());
        }
        let num = Num { value, incremental: false, unknown, span: word.span };
        let Some(letter) = word.address.addr.letter() else {
            let first = self.more.iter().find(|(known, _)| *known == word.address.addr).map(|(_, num)| num.span);
            self.more.push((word.address.addr, num));
            return from.core.unless_twice(word, first);
        };
        if letter == b'G' || letter == b'M' {
            if unknown {
                return from.core.refuse(word.span, codes::P1001::function_has_number());
            }
            let list = if letter == b'G' { &mut self.g } else { &mut self.m };
            let Some(number) = whole(value).filter(|_| list.len() < MOST) else {
                return from.core.refuse(word.span, codes::P1001::there_is_no_function(&(letter as char), &value));
            };
            list.push(Fun { number, span: word.span });
            return Ok(());
        }
        let at = index(letter);
        if self.present & 1 << at != 0 {
            return from.core.unless_twice(word, Some(self.singles[at].span));
        }
        self.present |= 1 << at;
        self.singles[at] = Num { incremental: word.address.incremental, ..num };
        Ok(())
    }
}

impl Core<'_> {
    /// A word that the block has already, at `first`.
    fn unless_twice(&self, word: &Word, first: Option<Span>) -> Outcome {
        let Some(first) = first else { return Ok(()) };
        let found = codes::P1002::word_stands_twice_in_block(&word.address.addr).at(self.loc(word.span));
        self.report(found.also(self.loc(first), Label::FirstOne));
        Err(Reported)
    }
}

/// A whole number of at most three digits, or four for spindles with a number (`G126`).
fn whole(value: f64) -> Option<u16> {
    (value.fract() == 0.0 && (0.0..=9999.0).contains(&value)).then_some(value as u16)
}
