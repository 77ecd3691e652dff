//! The tool that a program chooses: does anything change it in before the program cuts?
//!
//! Comes in: the functions and moves that go out. Goes out: warning P0206 for a program that chooses tools and never changes one.

use crate::diag::{Answer, Diagnostic, codes};
use crate::ir::Function;
use crate::text::Loc;

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

    /// The finding where the program chose a tool, cut, and never changed one.
    pub fn never_changed(&self) -> Option<Diagnostic> {
        let ChosenTool::Waits { number, loc, cut: true } = *self else { return None };
        let answer = Answer::key("control", "tool_change").one_of(&["\"t\"", "\"m6\""]);
        Some(codes::P0206::t_chooses_tool(&number).answer(answer).at(loc))
    }
}
