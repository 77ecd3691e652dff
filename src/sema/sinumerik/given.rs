//! The values of words: numbers with their modifiers, tools by name, and what stands in brackets.
//!
//! Source: S 1.2 and 1.3 (docs/sources.md).

use crate::diag::{Fault, codes};
use crate::parser::sinumerik::ast::{Args, Formula, Op, Value, Word};
use crate::text::Span;

use super::axis_names::NamedAxis;
use super::line::Line;
use super::value::Val;
use super::vocabulary::Address;
use super::words::{Given, Mode, Words};
use super::{Outcome, Run};

/// The spindle of an index.
pub(super) fn spindle(index: i32) -> Result<u8, Fault> {
    let spindle = u8::try_from(index).ok().filter(|n| (1..=20).contains(n));
    spindle.ok_or_else(|| codes::S2018::there_is_no_spindle(&index))
}

impl Run<'_> {
    /// The number behind a word, with its modifier.
    #[inline]
    pub(super) fn given(&mut self, word: &Word, line: Line<'_>) -> Outcome<Given> {
        match word.value {
            Value::Literal { value, .. } if value.is_finite() => {
                Ok(Given { value, mode: Mode::Plain, span: word.span })
            }
            Value::Literal { .. } => self.channel.core.refuse(word.span, codes::S2029::number_is_too_large()),
            Value::Formula(formula) => self.given_formula(formula, word.span, line),
            Value::None | Value::Call(_) => self.channel.core.refuse(word.span, codes::P1001::word_has_no_value()),
        }
    }

    fn given_formula(&mut self, formula: Formula, span: Span, line: Line<'_>) -> Outcome<Given> {
        if let [.., Op::Call(name, count, _)] = line.ops(formula)
            && let Some(mode) = Mode::of(self.channel.core.symbols.name(*name))
        {
            if *count != 1 {
                return self.channel.core.refuse(formula.span, codes::S2021::modifier_takes_one_value());
            }
            let inner = Formula { to: formula.to - 1, ..formula };
            let value = self.number(inner, line)?;
            return Ok(Given { value, mode, span });
        }
        let value = self.number(formula, line)?;
        Ok(Given { value, mode: Mode::Plain, span })
    }

    /// `T="MILL"` or `T=R1`
    pub(super) fn tool_word(&mut self, words: &mut Words, formula: Formula, span: Span, line: Line<'_>) -> Outcome {
        let value = match self.eval(formula, line)? {
            Val::Text(name) => {
                words.tool_name = Some(String::from_utf8_lossy(&name).into_owned());
                0.0
            }
            value => self.channel.core.accept(formula.span, value.as_number())?,
        };
        words.set_address(&self.channel.core, Address::T, Given { value, mode: Mode::Plain, span })
    }

    pub(super) fn index_number(&mut self, args: Args, line: Line<'_>) -> Outcome<i32> {
        let [formula] = *line.arguments(args) else {
            return self.channel.core.refuse(line.block.span, codes::S2018::one_index_is_needed());
        };
        self.whole_number(formula, line, codes::S2018::index_is_whole_number)
    }

    /// The axis in brackets.
    pub(super) fn axis_index(&mut self, args: Args, line: Line<'_>) -> Outcome<NamedAxis> {
        let [formula] = *line.arguments(args) else {
            return self.channel.core.refuse(line.block.span, codes::S2031::one_axis_is_needed_in_brackets());
        };
        match self.eval(formula, line)? {
            Val::Axis(axis) => Ok(axis),
            other => self.channel.core.refuse(formula.span, codes::S2031::axis_is_needed_in_brackets(&other.what())),
        }
    }
}
