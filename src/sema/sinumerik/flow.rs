//! Program flow inside a program: structures, jumps, repeated sections.
//!
//! Source: S 5.3 to 5.5 (docs/sources.md).

use crate::diag::codes;
use crate::ir::Function;
use crate::parser::sinumerik::ast::{Formula, Jump, JumpTarget, Search, Stmt, Target, When};
use crate::text::{Place, Span};

use super::levels::{self, FrameKind};
use super::line::Line;
use super::programs::{Mark, UnitKind};
use super::value::{Val, whole};
use super::{Outcome, Run};

impl Run<'_> {
    pub(super) fn structure(&mut self, line: Line<'_>) -> Outcome {
        let own = self.units.own_structure(&mut self.channel.core)?;
        let (passed, stands) = match line.block.stmt {
            Stmt::If(condition) => (own.middle.unwrap_or(own.close), self.decides(condition, line)?),
            Stmt::While(condition) => (own.close, self.decides(condition, line)?),
            Stmt::For { variable, from, to } => {
                let at = self.channel.core.here.at;
                let counts = self.channel.core.level().frame.counting.take() == Some(at);
                let goes_on = self.count(counts, variable, [from, to], line);
                // Without a result nobody knows where the program goes on.
                (own.close, goes_on.inspect_err(|_| self.channel.core.stop_run())?)
            }
            Stmt::Else => (own.close, false),
            Stmt::EndWhile => return self.channel.core.go_to(own.open.place),
            Stmt::EndLoop => return self.channel.core.go_to(own.open.after),
            Stmt::Until(condition) => {
                let over = self.decides(condition, line)?;
                return if over { Ok(()) } else { self.channel.core.go_to(own.open.after) };
            }
            Stmt::EndFor => {
                self.channel.core.level().frame.counting = Some(own.open.place.at);
                return self.channel.core.go_to(own.open.place);
            }
            _ => return Ok(()),
        };
        if stands { Ok(()) } else { self.units.go_behind(&mut self.channel.core, passed) }
    }

    /// A condition on which the way of the program depends: without it the run cannot go on.
    fn decides(&mut self, condition: Formula, line: Line<'_>) -> Outcome<bool> {
        let truth = self.eval(condition, line).and_then(|value| {
            let truth = value.truth().ok_or_else(|| codes::P2024::condition_is_needed(&value.what()));
            self.channel.core.accept(condition.span, truth)
        });
        truth.inspect_err(|_| self.channel.core.stop_run())
    }

    /// FOR: does the loop go on?
    fn count(&mut self, counts: bool, variable: Target, [from, to]: [Formula; 2], line: Line<'_>) -> Outcome<bool> {
        let too_large = codes::S2029::count_of_for_fits_no_int;
        let value = if counts {
            let args = self.values(line.indices_of(variable), line)?;
            let now = self.vars.read_target(variable, &args, &self.channel, line.block.span)?;
            let Some(next) = now.number().and_then(whole).and_then(|n| n.checked_add(1)) else {
                return self.channel.core.refuse(line.block.span, too_large());
            };
            next
        } else {
            self.whole_number(from, line, too_large)?
        };
        let last = self.whole_number(to, line, too_large)?;
        self.write_target(variable, Val::Int(value), line.block.span, line)?;
        Ok(value <= last)
    }

    // Jumps.

    /// IF with jumps; CASE of the number that `formula` has.
    pub(super) fn jump_by_arms(&mut self, formula: Option<Formula>, line: Line<'_>) -> Outcome {
        let value = formula.map(|formula| self.number(formula, line)).transpose();
        let value = value.inspect_err(|_| self.channel.core.stop_run())?;
        for arm in &line.block.arms {
            let taken = match arm.when {
                When::Condition(condition) => self.decides(condition, line)?,
                When::Constant(n) => value.is_some_and(|value| n as f64 == libm::floor(value + 0.5)),
                When::Default => true,
            };
            if taken {
                return self.jump(arm.jump, line);
            }
        }
        Ok(())
    }

    pub(super) fn jump(&mut self, jump: Jump, line: Line<'_>) -> Outcome {
        let found = self.find_target(jump, line);
        match found.inspect_err(|_| self.channel.core.stop_run())? {
            Some(mark) => self.channel.core.go_to(mark.place),
            None => Ok(()),
        }
    }

    /// A label; a text variable of that name if there is no such label; a text.
    fn find_target(&mut self, jump: Jump, line: Line<'_>) -> Outcome<Option<Mark>> {
        let from = self.channel.core.here.at;
        let value = match jump.target {
            JumpTarget::Start => {
                self.channel.core.say_once(jump.span, codes::S8049::gotos_is_left_out());
                return Ok(None);
            }
            JumpTarget::Text(formula) => Some(self.eval(formula, line)?),
            JumpTarget::Label(name) => {
                let is_label =
                    self.units.skeleton_here(&mut self.channel.core)?.label(name, from, jump.search).is_some();
                match self.vars.find(name).filter(|_| !is_label) {
                    Some(slot) => Some(self.vars.value(slot, &[], &self.channel, jump.span)?),
                    None => None,
                }
            }
            JumpTarget::Number(_) => None,
        };
        self.units.target(&mut self.channel.core, jump, value.as_ref(), from)
    }

    // Repeated sections.

    /// Repeats the section from `from` to the offset `stop`.
    pub(super) fn repeat(&mut self, from: Place, stop: u32, times: Option<Formula>, line: Line<'_>) -> Outcome {
        let times = match times {
            Some(formula) => {
                let value = self.number(formula, line)?;
                self.channel.core.accept(formula.span, levels::passes(value))?
            }
            None => 1,
        };
        self.channel.core.enter_section(from, stop, times)
    }

    // Return.

    /// `RET`, `RET("LABEL", after, levels)`
    pub(super) fn return_block(&mut self, formulas: &[Formula], span: Span, line: Line<'_>) -> Outcome {
        let target = formulas.first().filter(|formula| !formula.is_missing());
        let sub = self.units.list[levels::unit(&self.channel.core.levels)].kind == UnitKind::Sub;
        let in_main = levels::in_main(&self.channel.core.levels);
        if in_main && sub && target.is_none() {
            // A subprogram that is compiled by itself ends here.
            self.channel.pending_must_be_done(span)?;
            self.channel.function(Function::End { rewind: false });
            self.channel.core.stop_run();
            return Ok(());
        }
        if in_main {
            let help = if sub { "compile the program that calls this one" } else { "end it by M30" };
            return self.channel.core.refuse(span, codes::S2020::ret_stands_in_main_program().help(help));
        }
        self.channel.pending_must_be_done(span)?;
        let result = self.return_to(target.copied(), formulas, span, line);
        result.inspect_err(|_| self.channel.core.stop_run())
    }

    fn return_to(&mut self, target: Option<Formula>, formulas: &[Formula], span: Span, line: Line<'_>) -> Outcome {
        let value = match target {
            Some(formula) => Some((formula, self.eval(formula, line)?)),
            None => None,
        };
        let mut numbers = [0, 0, 1, 0];
        for (place, formula) in numbers.iter_mut().zip(formulas).skip(1) {
            if !formula.is_missing() {
                *place = self.whole_number(*formula, line, codes::S2021::this_argument_of_ret_is_whole_number)?;
            }
        }
        let [_, behind, levels, start] = numbers;
        let core = &mut self.channel.core;
        if start != 0 {
            return core.refuse(span, codes::P9011::ret_back_to_start_of_main_program());
        }
        let programs = levels::calls(&core.levels);
        if levels < 1 || levels as usize > programs {
            return core.refuse(span, codes::S2020::ret_goes_back_over_levels(&levels, &programs));
        }
        if value.is_none() && levels == 1 {
            // Like M17: passes that remain are run.
            self.leave_program();
            return Ok(());
        }
        let mut site = core.here.at;
        for _ in 0..levels {
            let core = &mut self.channel.core;
            site = levels::call_site(&core.levels).span.start;
            // Without further passes.
            if let FrameKind::Program { passes, .. } = &mut levels::program(&mut core.levels).kind {
                *passes = 1;
            }
            self.leave_program();
        }
        let Some((formula, value)) = value else { return Ok(()) };
        let jump = Jump { search: Search::Both, target: JumpTarget::Text(formula), span };
        let core = &mut self.channel.core;
        match self.units.target(core, jump, Some(&value), site)? {
            Some(mark) => core.go_to(if behind > 0 { mark.after } else { mark.place }),
            None => Ok(()),
        }
    }
}
