//! Assignments to variables, arrays and system variables; SET and REP.
//!
//! Source: S 5.1 and 5.6 (docs/sources.md).

use crate::diag::codes;
use crate::parser::sinumerik::ast::{Base, Block, Formula, Op, Target, Value, Word};
use crate::text::Span;

use super::conversions::Fill;
use super::line::Line;
use super::value::{Val, whole};
use super::{Outcome, Reported, Run};

impl Run<'_> {
    /// `target = formula`
    pub(super) fn assign_word(&mut self, word: &Word, line: Line<'_>) -> Outcome {
        let result = self.assign(word, line);
        if result.is_err() {
            self.vars.lose(word.target, &self.channel.core.symbols);
        }
        result
    }

    fn assign(&mut self, word: &Word, line: Line<'_>) -> Outcome {
        let Value::Formula(formula) = word.value else {
            return self.channel.core.refuse(word.span, codes::P1001::value_are_missing());
        };
        if let Target::Numbered(b'R', n, _) = word.target {
            let value = self.number(formula, line)?;
            return self.vars.set_r_parameter(n, value, &self.channel.core, word.span);
        }
        // `A[0,1]=SET(7,8)` fills from an element on.
        if let Some(fill) = self.list_of(formula, line)? {
            let core = &self.channel.core;
            let slot = core.accept(formula.span, self.vars.slot_to_fill(word.target, core))?;
            let args = self.values(line.indices_of(word.target), line)?;
            return self.vars.fill(slot, &args, &fill, &mut self.channel.core, formula.span);
        }
        let value = self.eval(formula, line)?;
        self.write_target(word.target, value, word.span, line)
    }

    pub(super) fn write_target(&mut self, target: Target, value: Val, span: Span, line: Line<'_>) -> Outcome {
        let args = self.values(line.indices_of(target), line)?;
        match target {
            Target::System(name) | Target::Indexed(Base::System(name), _) => {
                self.channel.write_system(name, &args, value, span)
            }
            _ => self.vars.write_target(target, &args, &value, &self.channel, span),
        }
    }

    /// The values of `SET(…)`, `(…)` or `REP(…)`; `None` for anything else.
    pub(super) fn list_of(&mut self, formula: Formula, line: Line<'_>) -> Outcome<Option<Fill>> {
        let (inner, repeats) = match line.ops(formula) {
            [inner @ .., Op::List(_)] => (inner, false),
            [inner @ .., Op::Call(name, _, _)] => match self.channel.core.symbols.name(*name) {
                "SET" => (inner, false),
                "REP" => (inner, true),
                _ => return Ok(None),
            },
            _ => return Ok(None),
        };
        // Values that stand one behind the other: what is left on the stack.
        let mut wrapped = Block { ops: inner.to_vec(), ..Block::default() };
        wrapped.ops.push(Op::List(depth(inner)));
        let all = Formula { from: 0, to: wrapped.ops.len() as u32, span: formula.span };
        let Val::List(list) = self.eval(all, Line { block: &wrapped, text: line.text })? else { return Err(Reported) };
        if !repeats {
            return Ok(Some(Fill::Set(list.to_vec())));
        }
        let count = list.get(1).map(|value| value.number().and_then(whole).and_then(|n| usize::try_from(n).ok()));
        match (list.first(), count) {
            (_, Some(None)) => {
                let fault = codes::S2017::rep_counts_elements_by_whole_number();
                self.channel.core.refuse(formula.span, fault)
            }
            (Some(value), count) => Ok(Some(Fill::Repeat(value.clone(), count.flatten()))),
            (None, _) => self.channel.core.refuse(formula.span, codes::S2017::rep_needs_value()),
        }
    }
}

/// How many values postfix operations leave.
fn depth(ops: &[Op]) -> u32 {
    let mut depth = 0u32;
    for op in ops {
        let used = match op {
            Op::Index(_, n, _) | Op::Call(_, n, _) | Op::List(n) => *n,
            Op::Unary(_) | Op::ToText => 1,
            Op::Binary(_) | Op::Join | Op::Chain => 2,
            _ => 0,
        };
        depth = (depth + 1).saturating_sub(used);
    }
    depth
}
