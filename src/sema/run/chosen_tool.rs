//! The tool that a program chooses: does anything change it in before the program cuts?
//!
//! Comes in: the functions and moves that go out. Goes out: warning P0206 for a program that chooses tools and never changes one.

use crate::diag::{Answer, codes};
use crate::ir::Function;
use crate::text::Loc;

use super::Language;
use super::core::Core;

/// What became of the first tool that was chosen.
#[derive(Debug, Clone, Copy, Default)]
pub(super) enum ChosenTool {
    /// None was.
    #[default]
    None,
    /// It waits for its change.
    Waits { number: u32, loc: Loc, cut: bool },
    /// The program changes tools, or it was said that it does not.
    Settled,
}

impl ChosenTool {
    /// A function goes out.
    pub fn function(&mut self, function: &Function, loc: Loc) {
        match (function, &self) {
            (Function::ToolChange { .. }, _) => *self = ChosenTool::Settled,
            (
                Function::ToolPrepare { number: number @ 1.. },
                ChosenTool::None | ChosenTool::Waits { cut: false, .. },
            ) => {
                *self = ChosenTool::Waits { number: *number, loc, cut: false };
            }
            _ => {}
        }
    }

    /// A cut goes out.
    #[inline]
    pub fn cuts(&mut self) {
        if let ChosenTool::Waits { cut, .. } = self {
            *cut = true;
        }
    }
}

impl<L: Language> Core<'_, L> {
    /// The loss of a change was reported.
    pub fn change_was_reported(&mut self) {
        self.chosen_tool = ChosenTool::Settled;
    }

    /// Says so where the program chose a tool, cut, and never changed one; unless it is known which word changes tools.
    pub fn report_no_change(&mut self) {
        let ChosenTool::Waits { number, loc, cut: true } = core::mem::take(&mut self.chosen_tool) else { return };
        if self.errors() > 0 || self.in_doubt || self.job.settings.control.says_tool_change() {
            return;
        }
        self.job.diags.push(
            codes::P0206::t_chooses_tool(&number)
                .answer(Answer::key("control", "tool_change").one_of(&["\"t\"", "\"m6\""]))
                .at(loc),
        );
    }
}
