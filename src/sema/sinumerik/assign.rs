//! Assignments to variables, arrays and system variables; SET and REP.
//!
//! Source: S 5.1 and 5.6 (docs/sources.md).

use crate::diag::codes;
use crate::parser::sinumerik::ast::{Args, Base, Block, Formula, Op, Target, Value, Word};
use crate::text::Span;

use super::conversions::Fill;
use super::line::Line;
use super::value::{Val, indices, r_index, whole};
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
        if let Some(values) = self.list_of(formula, line)? {
            return self.fill_target(word.target, &values, formula.span, line);
        }
        let value = self.eval(formula, line)?;
        self.write_target(word.target, value, word.span, line)
    }

    /// The values in the brackets of a target.
    fn indices_of(&mut self, target: Target, line: Line<'_>) -> Outcome<Vec<Val>> {
        let args: Option<Args> = if let Target::Indexed(_, args) = target { Some(args) } else { None };
        self.values(line.arguments_of(args), line)
    }

    /// Reads a target, for counting loops.
    pub(super) fn read_target(&mut self, target: Target, line: Line<'_>) -> Outcome<Val> {
        let span = line.block.span;
        let args = self.indices_of(target, line)?;
        let Run { channel, vars, .. } = self;
        let core = &channel.core;
        match target {
            Target::Numbered(b'R', n, _) => return vars.r_value(n, channel, span),
            Target::Indexed(Base::Letter(b'R'), _) => {
                let n = core.accept(span, r_index(&args))?;
                return vars.r_value(n, channel, span);
            }
            Target::Letter(_) if vars.target(target, &core.symbols).is_none() => {
                return core.refuse(span, codes::P1001::address_cannot_count_loop());
            }
            Target::System(_) | Target::Indexed(Base::Letter(_) | Base::System(_), _) => {
                return core.refuse(span, codes::P1001::this_cannot_count_loop());
            }
            Target::Letter(_) | Target::Numbered(..) | Target::Name(_) | Target::Indexed(..) => {}
        }
        let Some(slot) = vars.target(target, &core.symbols) else {
            return core.refuse(span, vars.no_target(target, core));
        };
        let indices = core.accept(span, indices(&args))?;
        vars.value(slot, &indices, channel, span)
    }

    pub(super) fn write_target(&mut self, target: Target, value: Val, span: Span, line: Line<'_>) -> Outcome {
        let args = self.indices_of(target, line)?;
        let Run { channel, vars, .. } = self;
        match target {
            Target::System(name) | Target::Indexed(Base::System(name), _) => {
                return channel.write_system(name, &args, value, span);
            }
            Target::Numbered(b'R', n, _) => {
                let value = channel.core.accept(span, value.as_number())?;
                return vars.set_r_parameter(n, value, &channel.core, span);
            }
            Target::Indexed(Base::Letter(b'R'), _) => {
                let n = channel.core.accept(span, r_index(&args))?;
                let value = channel.core.accept(span, value.as_number())?;
                return vars.set_r_parameter(n, value, &channel.core, span);
            }
            Target::Letter(_) | Target::Numbered(..) | Target::Name(_) | Target::Indexed(..) => {}
        }
        let core = &channel.core;
        let Some(slot) = vars.target(target, &core.symbols) else {
            return core.refuse(span, vars.no_target(target, core));
        };
        if let Target::Indexed(..) = target {
            return vars.write_indexed(slot, &args, &value, channel, span);
        }
        if let (Target::Numbered(_, _, name) | Target::Name(name), Some(number)) = (target, value.number()) {
            let origin = core.here.origin;
            core.job.trail.assigns(origin.loc, origin.call, || core.symbols.name(name).to_owned(), number);
        }
        vars.write(slot, &[], &value, core, span)
    }

    // Lists of values.

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
        let list = self.list_values(inner, formula.span, line.text)?;
        if !repeats {
            return Ok(Some(Fill::Set(list)));
        }
        let count = list.get(1).map(|value| value.number().and_then(whole).and_then(|n| usize::try_from(n).ok()));
        if count == Some(None) {
            let fault = codes::S2017::rep_counts_elements_by_whole_number();
            return self.channel.core.refuse(formula.span, fault);
        }
        match list.into_iter().next() {
            Some(value) => Ok(Some(Fill::Repeat(value, count.flatten()))),
            None => self.channel.core.refuse(formula.span, codes::S2017::rep_needs_value()),
        }
    }

    /// Values that stand one behind the other: what is left on the stack.
    fn list_values(&mut self, ops: &[Op], span: Span, text: &[u8]) -> Outcome<Vec<Val>> {
        let mut wrapped = Block { ops: ops.to_vec(), ..Block::default() };
        wrapped.ops.push(Op::List(depth(ops)));
        let whole = Formula { from: 0, to: wrapped.ops.len() as u32, span };
        match self.eval(whole, Line { block: &wrapped, text })? {
            Val::List(list) => Ok(list.to_vec()),
            _ => Err(Reported),
        }
    }

    fn fill_target(&mut self, target: Target, fill: &Fill, span: Span, line: Line<'_>) -> Outcome {
        let core = &self.channel.core;
        let slot = match (target, self.vars.target(target, &core.symbols)) {
            (_, Some(slot)) => slot,
            (Target::Name(_) | Target::Numbered(..) | Target::Indexed(Base::Name(_), _), None) => {
                return core.refuse(span, self.vars.no_target(target, core));
            }
            _ => return core.refuse(span, codes::P2024::list_of_values_fills_array()),
        };
        let args = self.indices_of(target, line)?;
        let core = &mut self.channel.core;
        let indices = core.accept(span, indices(&args))?;
        let var = self.vars.get(slot).cloned().ok_or(Reported)?;
        let start = if indices.is_empty() { Some(0) } else { var.offset(&indices) };
        let Some(start) = start.filter(|_| !var.sizes.is_empty()) else {
            return core.refuse(span, codes::S2018::array_has_no_such_element());
        };
        core.budget.take(var.values.len() as u64 / 16);
        let filled = var.filled(start, fill, core, span)?;
        if let Some(var) = self.vars.get_mut(slot) {
            *var = filled;
        }
        Ok(())
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
