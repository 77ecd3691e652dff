//! Program flow inside a program: structures, jumps, repeated sections.
//!
//! Source: S 5.3 to 5.5 (docs/sources.md).

use crate::diag::{Label, codes};
use crate::machine::tree::did_you_mean;
use crate::parser::sinumerik::ast::{Arm, Block, Formula, Jump, JumpTarget, Search, Stmt, Target, When};
use crate::parser::symbols::Symbol;
use crate::sema::run;
use crate::text::{Place, Span};

use crate::sema::run::Where;

use super::calls::FrameKind;
use super::programs::{Mark, Skeleton, Structure};
use super::value::{Val, to_text, whole};
use super::{Core, Outcome, Reported, Run};

/// Most passes of a program or a repeat.
pub(super) const MOST_PASSES: i32 = 9999;

impl Run<'_> {
    pub(super) fn skeleton(&mut self) -> Outcome<std::rc::Rc<Skeleton>> {
        let unit = self.channel.core.level().frame.unit;
        match self.skeleton_of(unit) {
            Ok(made) => Ok(made),
            Err(error) => self.channel.core.refuse(Where::Block, codes::P0105::file_cannot_be_read(&error)),
        }
    }

    /// The skeleton of any program.
    pub(super) fn skeleton_of(&mut self, unit: usize) -> std::io::Result<std::rc::Rc<Skeleton>> {
        let run::Core { job, programs, symbols, .. } = &mut self.channel.core;
        self.units.skeleton(job, programs, unit, symbols)
    }

    /// The structure that the current block belongs to. A structure that is not closed was reported.
    fn own_structure(&mut self) -> Outcome<Structure> {
        let at = self.channel.core.here.at;
        let found = self.skeleton()?.structure_of(at);
        match found {
            Some(found) => Ok(found),
            None => {
                // Without its partner nobody knows where the program goes on.
                self.channel.core.stop_run();
                Err(Reported)
            }
        }
    }

    pub(super) fn structure(&mut self, block: &Block, text: &[u8]) -> Outcome {
        let own = self.own_structure()?;
        match block.stmt {
            Stmt::If(condition) => {
                if !self.decides(condition, block, text)? {
                    return self.go_behind(own.middle.unwrap_or(own.close));
                }
                Ok(())
            }
            Stmt::Else => self.go_behind(own.close),
            Stmt::While(condition) => {
                if self.decides(condition, block, text)? {
                    Ok(())
                } else {
                    self.go_behind(own.close)
                }
            }
            Stmt::EndWhile => self.channel.core.go_to(own.open.place),
            Stmt::EndLoop => self.channel.core.go_to(own.open.after),
            Stmt::Until(condition) => {
                if self.decides(condition, block, text)? {
                    Ok(())
                } else {
                    self.channel.core.go_to(own.open.after)
                }
            }
            Stmt::For { variable, from, to } => self.for_block(own, variable, from, to, block, text),
            Stmt::EndFor => {
                self.channel.core.level().frame.counting = Some(own.open.place.at);
                self.channel.core.go_to(own.open.place)
            }
            _ => Ok(()),
        }
    }

    /// Goes on behind a line of a structure, which is not executed but has to be right.
    fn go_behind(&mut self, line: Mark) -> Outcome {
        let wrong = self.skeleton()?.wrong_line(line.place.at).cloned();
        if let Some((number, lines, problem)) = wrong {
            let file = self.channel.core.here.file;
            let here =
                crate::sema::run::Site::new(file, line.place.at, number, lines, self.channel.core.here.origin.call);
            let found = here.diagnostic(&self.channel.core.job, problem);
            if !self.channel.core.job.diags.knows(&found) {
                self.channel.core.job.diags.push(found);
            }
            self.channel.core.stop_run();
            return Err(Reported);
        }
        self.channel.core.go_to(line.after)
    }

    /// A condition on which the way of the program depends: without it the run cannot go on.
    fn decides(&mut self, condition: Formula, block: &Block, text: &[u8]) -> Outcome<bool> {
        let result = self.condition(condition, block, text);
        if result.is_err() {
            self.channel.core.stop_run();
        }
        result
    }

    fn for_block(
        &mut self,
        own: Structure,
        variable: Target,
        from: Formula,
        to: Formula,
        block: &Block,
        text: &[u8],
    ) -> Outcome {
        let counts = self.channel.core.level().frame.counting.take() == Some(self.channel.core.here.at);
        let result = self.count(counts, variable, from, to, block, text);
        match result {
            Ok(true) => Ok(()),
            Ok(false) => self.go_behind(own.close),
            Err(reported) => {
                self.channel.core.stop_run();
                Err(reported)
            }
        }
    }

    fn count(
        &mut self,
        counts: bool,
        variable: Target,
        from: Formula,
        to: Formula,
        block: &Block,
        text: &[u8],
    ) -> Outcome<bool> {
        let rounded = |run: &mut Self, formula: Formula| {
            let value = run.number(formula, block, text)?;
            match whole(value) {
                Some(n) => Ok(n),
                None => run.channel.core.refuse(formula.span, codes::S2029::count_of_for_fits_no_int()),
            }
        };
        let value = if counts {
            let now = self.read_target(variable, block, text)?;
            let Some(next) = now.number().and_then(whole).and_then(|n| n.checked_add(1)) else {
                return self.channel.core.refuse(block.span, codes::S2029::count_of_for_fits_no_int());
            };
            next
        } else {
            rounded(self, from)?
        };
        let last = rounded(self, to)?;
        self.write_target(variable, Val::Int(value), block.span, block, text)?;
        Ok(value <= last)
    }

    // Jumps.

    pub(super) fn if_jumps(&mut self, block: &Block, text: &[u8]) -> Outcome {
        for arm in &block.arms {
            if let When::Condition(condition) = arm.when
                && self.decides(condition, block, text)?
            {
                return self.jump(arm.jump, block, text);
            }
        }
        Ok(())
    }

    pub(super) fn case_block(&mut self, formula: Formula, block: &Block, text: &[u8]) -> Outcome {
        let value = match self.number(formula, block, text) {
            Ok(value) => value,
            Err(reported) => {
                self.channel.core.stop_run();
                return Err(reported);
            }
        };
        let chosen = |arm: &&Arm| match arm.when {
            When::Constant(n) => n as f64 == libm::floor(value + 0.5),
            When::Default => true,
            When::Condition(_) => false,
        };
        match block.arms.iter().find(chosen) {
            Some(arm) => self.jump(arm.jump, block, text),
            None => Ok(()),
        }
    }

    pub(super) fn jump(&mut self, jump: Jump, block: &Block, text: &[u8]) -> Outcome {
        let result = self.find_target(jump, block, text);
        match result {
            Ok(Some(mark)) => self.channel.core.go_to(mark.place),
            Ok(None) => Ok(()),
            Err(reported) => {
                self.channel.core.stop_run();
                Err(reported)
            }
        }
    }

    fn find_target(&mut self, jump: Jump, block: &Block, text: &[u8]) -> Outcome<Option<Mark>> {
        let from = self.channel.core.here.at;
        let (found, what) = match jump.target {
            JumpTarget::Number(n) => (self.skeleton()?.number(n, from, jump.search), format!("block N{n}")),
            JumpTarget::Label(name) => self.label_or_variable(name, from, jump)?,
            JumpTarget::Text(formula) => {
                let value = self.eval(formula, block, text)?;
                self.named_target(&value, from, jump)?
            }
            JumpTarget::Start => {
                self.channel.core.says_goto_start(jump.span);
                return Ok(None);
            }
        };
        if found.is_some() || jump.search == Search::BothQuiet {
            return Ok(found);
        }
        self.no_target(jump, &what)
    }

    /// A label; a text variable of that name if there is no such label.
    fn label_or_variable(&mut self, name: Symbol, from: u32, jump: Jump) -> Outcome<(Option<Mark>, String)> {
        let found = self.skeleton()?.label(name, from, jump.search);
        if found.is_none()
            && let Some(slot) = self.vars.find(name)
        {
            let value = self.variable_value(slot, &[], jump.span)?;
            return self.named_target(&value, from, jump);
        }
        Ok((found, format!("label `{}`", self.channel.core.symbols.name(name))))
    }

    /// `"N100"`, `"100"` or `"LABEL"`.
    fn named_target(&mut self, value: &Val, from: u32, jump: Jump) -> Outcome<(Option<Mark>, String)> {
        let Some(text) = to_text(value).filter(|text| !text.is_empty()) else {
            return self.channel.core.refuse(jump.span, codes::P2011::jump_target_is_no_text());
        };
        let shown = String::from_utf8_lossy(&text).into_owned();
        let upper = text.to_ascii_uppercase();
        let digits = upper.strip_prefix(b"N").or_else(|| upper.strip_prefix(b":")).unwrap_or(&upper);
        let digits = digits.strip_suffix(b":").unwrap_or(digits);
        let number = std::str::from_utf8(digits).ok().and_then(|digits| digits.parse().ok());
        let skeleton = self.skeleton()?;
        let found = match number {
            Some(n) => skeleton.number(n, from, jump.search),
            None => {
                let name = upper.strip_suffix(b":").unwrap_or(&upper).to_vec();
                let name = self.channel.core.symbols.intern(&name);
                skeleton.label(name, from, jump.search)
            }
        };
        Ok((found, format!("jump target `{shown}`")))
    }

    fn no_target<T>(&mut self, jump: Jump, what: &str) -> Outcome<T> {
        let skeleton = self.skeleton()?;
        let elsewhere = match jump.target {
            JumpTarget::Label(name) => skeleton.label(name, self.channel.core.here.at, Search::Both),
            JumpTarget::Number(n) => skeleton.number(n, self.channel.core.here.at, Search::Both),
            JumpTarget::Text(_) | JumpTarget::Start => None,
        };
        let way = match jump.search {
            Search::Forward => " after this block",
            Search::Backward => " before this block",
            _ => "",
        };
        let found = codes::P2011::there_is_no(&what, &way).at(self.channel.core.loc(jump.span));
        let found = match (elsewhere, jump.target) {
            (Some(mark), _) => {
                let loc = self.channel.core.mark_loc(mark);
                let other = if jump.search == Search::Forward { "GOTOB" } else { "GOTOF" };
                found.also(loc, Label::StandsHere).help(format!("jump by {other} or GOTO"))
            }
            (None, JumpTarget::Label(name)) => {
                let wanted = self.channel.core.symbols.name(name);
                let names: Vec<&str> = skeleton.labels().map(|label| self.channel.core.symbols.name(label)).collect();
                match did_you_mean(wanted, names) {
                    Some(like) => found.help(format!("did you mean `{like}`?")),
                    None => found.help("write the label before the block to jump to: `NAME:`"),
                }
            }
            _ => found.help("check the target of the jump"),
        };
        self.channel.core.report(found);
        Err(Reported)
    }

    // Repeated sections.

    pub(super) fn repeat(
        &mut self,
        from: Symbol,
        to: Option<Symbol>,
        times: Option<Formula>,
        block: &Block,
        text: &[u8],
    ) -> Outcome {
        let start = self.section_label(from, block.span)?;
        let stop = match to {
            Some(to) => {
                let end = self.section_label(to, block.span)?;
                if end.place.at < start.place.at {
                    return self.channel.core.refuse(block.span, codes::P2011::last_label_of_section_stands_in_front());
                }
                end.after.at
            }
            None => {
                let end = self.channel.core.symbols.intern(b"ENDLABEL");
                match self.skeleton()?.label(end, start.place.at, Search::Forward) {
                    Some(end) => end.after.at,
                    None if start.place.at < self.channel.core.here.at => self.channel.core.here.at,
                    None => {
                        return self
                            .channel
                            .core
                            .refuse(block.span, codes::P2011::section_behind_this_block_has_no_endlabel());
                    }
                }
            }
        };
        self.repeat_section(start.place, stop, times, block, text)
    }

    pub(super) fn repeat_block(
        &mut self,
        label: Symbol,
        times: Option<Formula>,
        block: &Block,
        text: &[u8],
    ) -> Outcome {
        let mark = self.section_label(label, block.span)?;
        self.repeat_section(mark.place, mark.after.at, times, block, text)
    }

    /// A label of a repeat: the nearest one in front, else behind.
    pub(super) fn section_label(&mut self, name: Symbol, span: Span) -> Outcome<Mark> {
        let at = self.channel.core.here.at;
        let skeleton = self.skeleton()?;
        match skeleton.label(name, at, Search::Backward).or_else(|| skeleton.label(name, at, Search::Forward)) {
            Some(mark) => Ok(mark),
            None => {
                let jump = Jump { search: Search::Both, target: JumpTarget::Label(name), span };
                let what = format!("label `{}`", self.channel.core.symbols.name(name));
                self.channel.core.stop_run();
                self.no_target(jump, &what)
            }
        }
    }

    fn repeat_section(
        &mut self,
        from: Place,
        stop: u32,
        times: Option<Formula>,
        block: &Block,
        text: &[u8],
    ) -> Outcome {
        let times = match times {
            Some(formula) => self.passes(formula, block, text)?,
            None => 1,
        };
        self.channel.core.enter_section(from, stop, times)
    }

    /// A number of passes.
    pub(super) fn passes(&mut self, formula: Formula, block: &Block, text: &[u8]) -> Outcome<u32> {
        let value = self.number(formula, block, text)?;
        self.channel.core.check_passes(value, formula.span)
    }

    // Return.

    /// `RET`, `RET("LABEL", after, levels)`
    pub(super) fn return_block(&mut self, formulas: &[Formula], span: Span, block: &Block, text: &[u8]) -> Outcome {
        let target = formulas.first().filter(|formula| !formula.is_missing());
        let sub = self.units.list[self.unit()].kind == super::programs::UnitKind::Sub;
        if self.channel.core.in_main() && sub && target.is_none() {
            // A subprogram that is compiled by itself ends here.
            self.channel.pending_must_be_done(span)?;
            self.channel.function(crate::ir::Function::End { rewind: false });
            self.channel.core.stop_run();
            return Ok(());
        }
        if self.channel.core.in_main() {
            let help = if sub { "compile the program that calls this one" } else { "end it by M30" };
            return self.channel.core.refuse(span, codes::S2020::ret_stands_in_main_program().help(help));
        }
        self.channel.pending_must_be_done(span)?;
        let result = self.return_to(target.copied(), formulas, span, block, text);
        if result.is_err() {
            self.channel.core.stop_run();
        }
        result
    }

    fn return_to(
        &mut self,
        target: Option<Formula>,
        formulas: &[Formula],
        span: Span,
        block: &Block,
        text: &[u8],
    ) -> Outcome {
        let value = match target {
            Some(formula) => Some((formula, self.eval(formula, block, text)?)),
            None => None,
        };
        let number = |run: &mut Self, at: usize, usual: i32| -> Outcome<i32> {
            let Some(formula) = formulas.get(at).filter(|formula| !formula.is_missing()) else { return Ok(usual) };
            let value = run.number(*formula, block, text)?;
            match whole(value) {
                Some(n) => Ok(n),
                None => run.channel.core.refuse(formula.span, codes::S2021::this_argument_of_ret_is_whole_number()),
            }
        };
        let behind = number(self, 1, 0)? > 0;
        let levels = number(self, 2, 1)?;
        if number(self, 3, 0)? != 0 {
            return self.channel.core.refuse(span, codes::P9011::ret_back_to_start_of_main_program());
        }
        let programs = self
            .channel
            .core
            .levels
            .iter()
            .filter(|level| matches!(level.frame.kind, FrameKind::Program { .. }))
            .count();
        if levels < 1 || levels as usize > programs {
            return self.channel.core.refuse(span, codes::S2020::ret_goes_back_over_levels(&levels, &programs));
        }
        if value.is_none() && levels == 1 {
            // Like M17: passes that remain are run.
            self.leave_program();
            return Ok(());
        }
        let mut site = self.channel.core.here.at;
        for _ in 0..levels {
            site = self.leave_for_good();
        }
        let Some((formula, value)) = value else { return Ok(()) };
        let jump = Jump { search: Search::Both, target: JumpTarget::Text(formula), span };
        let (found, what) = self.named_target(&value, site, jump)?;
        match found {
            Some(mark) => self.channel.core.go_to(if behind { mark.after } else { mark.place }),
            None => self.no_target(jump, &what),
        }
    }
}

impl Core<'_> {
    /// Goes on at `place` of the current program. Repeats that do not hold the place end.
    fn go_to(&mut self, place: Place) -> Outcome {
        while let FrameKind::Section { from, stop, .. } = self.level().frame.kind
            && !(from.at <= place.at && place.at < stop)
        {
            self.levels.pop();
        }
        self.resume(place)
    }

    pub(super) fn resume(&mut self, place: Place) -> Outcome {
        if place.at <= self.here.at {
            self.note_jump();
        }
        self.seek(place)
    }

    /// GOTOS starts the program again where the machine asks for it, which nothing does here.
    pub(super) fn says_goto_start(&self, span: Span) {
        self.say_once(span, codes::S8049::gotos_is_left_out());
    }

    fn mark_loc(&mut self, mark: Mark) -> crate::text::Loc {
        let span = Span::at(mark.place.at, (mark.after.at - mark.place.at).saturating_sub(1));
        crate::text::Loc { file: self.program().source.file, line: mark.place.line, span }
    }

    pub(super) fn check_passes(&mut self, value: f64, span: Span) -> Outcome<u32> {
        let fits = |n: &i32| (1..=MOST_PASSES).contains(n) && (f64::from(*n) - value).abs() < 1e-6;
        match whole(value).filter(fits) {
            Some(n) => Ok(n as u32),
            None => self.refuse(span, codes::S2019::p_is_no_number_of_passes(&value)),
        }
    }
}
