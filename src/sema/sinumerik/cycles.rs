//! Machining cycles of the control: parameters by name and number, expanded by `lower::cycles`.
//!
//! Source: `reference/sinumerik-contours-undercuts-cycles`.

use crate::diag::codes;
use crate::parser::sinumerik::ast::{Args, Block};

use super::vocabulary::{Meaning, Procedure};
use super::words::CallWord;
use super::{Outcome, Run};

/// A drilling cycle that runs behind every positioning block.
#[derive(Debug, Clone)]
pub(super) struct ModalCycle {}

impl Run<'_> {
    /// Runs a machining cycle; `None` for a name that is none, or that is not built.
    pub(super) fn machining_cycle(
        &mut self,
        _name: &str,
        _call: CallWord,
        _block: &Block,
        _text: &[u8],
    ) -> Option<Outcome> {
        None
    }

    /// `MCALL CYCLE81(…)`
    pub(super) fn modal_machining_cycle(
        &mut self,
        name: &str,
        _args: Args,
        block: &Block,
        _text: &[u8],
    ) -> Option<Outcome> {
        match self.vocabulary.get(name) {
            Some(Meaning::Procedure(Procedure::Refused(what))) => Some(self.fail_help(
                codes::S9005,
                0,
                block.span,
                format!("{name} ({what}) is not supported"),
                "replace it by plain moves, or compile the program without it",
            )),
            _ => None,
        }
    }
}
