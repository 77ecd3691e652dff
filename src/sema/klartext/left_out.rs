//! Programs of the machine builder that are found nowhere: what `[programs]` says stands for their calls.
//!
//! Comes in: the name as a block writes it. Goes out: what the entry says that the program leaves behind, or the file that
//! runs in its place. A program that is found runs, whatever the entry says.

use crate::diag::{Answer, Diagnostic, codes};
use crate::ir::function::Turn;
use crate::machine::{AxisSet, ChangeCall, Left, LeftSpindle, StandIn};
use crate::sema::common::hidden::By;
use crate::sema::run::{Wanted, Where};
use crate::text::{Span, Within};

use super::active_tool::Change;
use super::{Core, Outcome, Run};

impl Run<'_> {
    /// Does what the entry `key` says in place of the call of `name`, which runs no file.
    pub(super) fn stand_in(&mut self, name: &str, key: &str, change: Option<ChangeCall>) -> Outcome {
        let span = self.core.block_span();
        if self.core.job.settings.left_by(key).rapid.is_some() {
            return self.core.refuse(span, codes::P0205::programs_says_that_leaves_g0_or_g1(&key));
        }
        match change {
            None => self.core.say_once(Where::Block, codes::P8105::is_left_out(&name)),
            Some(ChangeCall { tool: None, edge: None }) => self.change_by_program(name, span)?,
            Some(_) => {
                return self.core.refuse(span, codes::P0205::programs_says_that_argument_of_names_tool(&key));
            }
        }
        self.leave_axes(key, "end the contour with R0 before the call")?;
        self.leave_technology(key)?;
        if self.core.job.settings.left_by(key).feed.is_none() && self.st.feed.word().is_some() {
            self.st.feed.left_by_call(name, key_of(name), self.core.here.origin.loc, false);
        }
        Ok(())
    }

    /// The program changes to the tool that was called.
    fn change_by_program(&mut self, name: &str, span: Span) -> Outcome {
        if matches!(self.st.tool.change, Change::None | Change::Announced | Change::InSpindle) {
            let fault = codes::K2802::changes_tool(&name);
            return self.core.refuse(span, fault.answer(Answer::key("control", "tool_change").one_of(&["\"m6\""])));
        }
        self.change_at(span, &format!("`{name}`"))?;
        // Where it leaves the axes only the configuration knows.
        let loc = self.core.here.origin.loc;
        self.st.position.forget(AxisSet::MAIN);
        self.st.position.hide(AxisSet::MAIN, By::ToolChange, loc);
        self.st.lost(&mut self.core);
        self.stand_after_change();
        self.core.say_once(Where::Block, codes::P8105::changes_tool(&name));
        Ok(())
    }

    /// Axes that stand at a place that nothing says behind what the entry `name` stands for.
    pub(super) fn leave_axes(&mut self, name: &str, under_compensation: &'static str) -> Outcome {
        let moved = self.core.job.settings.left_by(name).lost;
        if moved.is_empty() {
            return Ok(());
        }
        if self.st.compensation.is_on() {
            let refused = self.core.refuse(
                Where::Block,
                codes::P2001::moves_axes_under_radius_compensation(&name).help(under_compensation),
            );
            self.st.lose_all(&mut self.core);
            return refused;
        }
        self.st.position.forget(moved);
        self.st.position.hide(moved, By::Call, self.core.here.origin.loc);
        self.st.lost(&mut self.core);
        let known = *self.st.position.at();
        self.core.stands_at(&known, &self.st.ctx);
        Ok(())
    }

    /// What the entry says of feed and spindle is done as the words of a block would do it.
    pub(super) fn leave_technology(&mut self, name: &str) -> Outcome {
        let left = self.core.job.settings.left_by(name);
        match left.feed {
            Some(Left::Value(written)) => {
                let feed = self.st.feed.counted(written, self.core.unit());
                self.st.feed.program(feed, written);
            }
            Some(Left::Lost) => {
                self.st.feed.left_by_call(name, key_of(name), self.core.here.origin.loc, true);
            }
            None => {}
        }
        match left.speed {
            Some(Left::Value(speed)) => {
                let function = self.st.spindle.set_speed(&self.core, speed, self.core.block_span())?;
                self.function(function);
            }
            Some(Left::Lost) => {
                let what = if name.starts_with("CYCL ") { "cycle" } else { "program" };
                return self.core.refuse(Where::Block, codes::P9010::leaves_speed_that_is_not_known(&name, &what));
            }
            None => {}
        }
        let switched = match left.spindle {
            Some(LeftSpindle::Clockwise) => self.st.spindle.start(Turn::Clockwise),
            Some(LeftSpindle::CounterClockwise) => self.st.spindle.start(Turn::CounterClockwise),
            Some(LeftSpindle::Stopped) => self.st.spindle.stop(),
            None => return Ok(()),
        };
        self.function(switched);
        Ok(())
    }
}

impl Core<'_> {
    /// What stands for the program `name`: the name of its entry, and what it says. `None`: the program is here, or has no entry.
    pub(super) fn stands_for(&mut self, name: &str) -> Option<(String, StandIn)> {
        let (key, stands) = entry_of(&self.job.settings.programs, name)?;
        let wanted = Wanted { name, extensions: &["H", "h"], within: Within::Caller };
        self.is_nowhere(&wanted).then_some((key, stands))
    }
}

/// The finding for a program that is nowhere, with what may stand for it.
pub(super) fn or_left_out(mut found: Diagnostic, name: &str) -> Diagnostic {
    if !matches!(found.code.id, "P0101" | "P0104") || found.answers.is_empty() {
        return found;
    }
    let key = key_of(name);
    let more = format!(
        "; a program of the machine builder that moves nothing is left out by `[programs] \"{key}\" = {{ ignore = true }}`"
    );
    found.help.get_or_insert_default().push_str(&more);
    found.answers.push(Answer::key("programs", key).one_of(&["{ ignore = true }"]));
    found
}

/// The entry for a program: by its name as written, without its folder, or without its extension, too.
fn entry_of(programs: &std::collections::BTreeMap<String, StandIn>, name: &str) -> Option<(String, StandIn)> {
    let written = name.to_ascii_uppercase();
    let last = written.rsplit(['/', '\\', ':']).next().unwrap_or(&written).to_owned();
    [written, last, key_of(name)].into_iter().find_map(|key| {
        let stands = programs.get(&key)?.clone();
        Some((key, stands))
    })
}

/// The name that an entry has: in capitals, without folder and extension.
fn key_of(name: &str) -> String {
    let name = name.to_ascii_uppercase();
    let last = name.rsplit(['/', '\\', ':']).next().unwrap_or(&name);
    last.strip_suffix(".H").or_else(|| last.strip_suffix(".I")).unwrap_or(last).to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_entries() {
        for name in ["TNC:\\BUILDER\\Clean.h", "clean.H", "CLEAN", "oem/clean.i"] {
            assert_eq!(key_of(name), "CLEAN", "{name}");
        }
        assert_eq!(key_of("A.B.H"), "A.B");
    }
}
