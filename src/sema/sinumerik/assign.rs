//! Assignments to variables, arrays and system variables.
//!
//! Source: S 5.1 and 5.6 (docs/sources.md).

use crate::diag::codes;
use crate::parser::sinumerik::ast::{Base, Target, Value, Word};
use crate::text::Span;

use super::line::Line;
use super::value::Val;
use super::{Outcome, Run};

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
        let args = match target {
            Target::Indexed(..) => self.values(line.indices_of(target), line)?,
            _ => Vec::new(),
        };
        match target {
            Target::System(name) | Target::Indexed(Base::System(name), _) => {
                self.channel.write_system(name, &args, value, span)
            }
            _ => self.vars.write_target(target, &args, &value, &self.channel, span),
        }
    }
}
