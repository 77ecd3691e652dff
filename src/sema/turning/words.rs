//! The words of a block by address, with their values computed.

use crate::diag::{Label, codes};
use crate::lexer::turning::Addr;
use crate::parser::turning::ast::{Block, Value, Word};
use crate::text::Span;

use super::{Outcome, Run};

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
    #[inline]
    pub fn clear(&mut self) {
        self.present = 0;
        self.more.clear();
        self.texts.clear();
        self.g.clear();
        self.m.clear();
    }

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
    pub fn text(&self, name: &str) -> Option<Span> {
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

    /// Span of a word, or `other` where it is not there.
    pub fn span(&self, letter: u8, other: Span) -> Span {
        self.get(letter).map_or(other, |num| num.span)
    }
}

impl Run<'_> {
    /// Reads the words of a block. The box comes back through [`Run::put_back`].
    #[inline]
    pub(super) fn gather(&mut self, block: &Block) -> Outcome<Box<Words>> {
        let mut words = self.words.take().unwrap_or_default();
        words.clear();
        for word in &block.words {
            if let Err(reported) = self.gather_word(word, block, &mut words) {
                self.words = Some(words);
                return Err(reported);
            }
        }
        Ok(words)
    }

    pub(super) fn put_back(&mut self, words: Box<Words>) {
        self.words = Some(words);
    }

    #[inline]
    fn gather_word(&mut self, word: &Word, block: &Block, words: &mut Words) -> Outcome {
        let (value, unknown) = match word.value {
            Value::Number { value, .. } => (value, false),
            Value::Unknown => (0.0, true),
            Value::Formula(formula) => (self.formula(block, formula)?, false),
            Value::Text(span) => return self.gather_text(word, span, words),
        };
        if value.is_nan() || value.abs() > LARGEST {
            return self.core.refuse(word.span, codes::T1007::number_is_too_large_for_any_control());
        }
        let Some(letter) = word.address.addr.letter() else {
            return self.gather_long(word, value, unknown, words);
        };
        if letter == b'G' || letter == b'M' {
            if unknown {
                return self.core.refuse(word.span, codes::P1001::function_has_number());
            }
            let list = if letter == b'G' { &mut words.g } else { &mut words.m };
            return match whole(value).filter(|_| list.len() < MOST) {
                Some(number) => {
                    list.push(Fun { number, span: word.span });
                    Ok(())
                }
                None => self.core.refuse(word.span, codes::P1001::there_is_no_function(&(letter as char), &value)),
            };
        }
        let at = index(letter);
        if words.present & 1 << at != 0 {
            return self.twice(word, words.singles[at].span);
        }
        words.present |= 1 << at;
        words.singles[at] = Num { value, incremental: word.address.incremental, unknown, span: word.span };
        Ok(())
    }

    fn gather_long(&mut self, word: &Word, value: f64, unknown: bool, words: &mut Words) -> Outcome {
        let addr = word.address.addr;
        if let Some((_, first)) = words.more.iter().find(|(known, _)| *known == addr) {
            return self.twice(word, first.span);
        }
        words.more.push((addr, Num { value, incremental: false, unknown, span: word.span }));
        Ok(())
    }

    fn gather_text(&mut self, word: &Word, span: Span, words: &mut Words) -> Outcome {
        let addr = word.address.addr;
        if words.texts.iter().any(|(known, _)| *known == addr) {
            return self.twice(word, span);
        }
        words.texts.push((addr, span));
        Ok(())
    }

    #[cold]
    fn twice(&self, word: &Word, first: Span) -> Outcome {
        let found = codes::P1002::word_stands_twice_in_block(&word.address.addr).at(self.core.loc(word.span));
        self.core.report(found.also(self.core.loc(first), Label::FirstOne));
        Err(super::Reported)
    }
}

/// A whole number of at most three digits, or four for spindles with a number (`G126`).
fn whole(value: f64) -> Option<u16> {
    (value.fract() == 0.0 && (0.0..=9999.0).contains(&value)).then_some(value as u16)
}
