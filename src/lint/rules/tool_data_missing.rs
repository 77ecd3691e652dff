//! The tool table has neither radius nor length of a tool.

use crate::diag::codes;
use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup};
use crate::machine::tools::{Tool, Tools};

/// Most tools that are remembered.
const MOST: usize = 1000;

#[derive(Debug, Default)]
pub(super) struct ToolDataMissing<'a> {
    said: Vec<u32>,
    tools: Option<&'a Tools>,
}

impl<'a> ToolDataMissing<'a> {
    pub(super) fn new(setup: &Setup<'a>) -> ToolDataMissing<'a> {
        ToolDataMissing { tools: Some(&setup.settings.tools), ..ToolDataMissing::default() }
    }
}

impl MotionRule for ToolDataMissing<'_> {
    fn wants_moves(&self) -> bool {
        false
    }

    fn function(&mut self, function: &Function, _: &Machine, origin: &Origin, say: Say<'_>) {
        let Function::ToolChange { number } = function else { return };
        let known = self.tools.and_then(|tools| tools.by_printed(*number));
        let bare = |tool: &Tool| tool.radius.unwrap_or(0.0) == 0.0 && tool.length.unwrap_or(0.0) == 0.0;
        if *number != 0 && known.is_some_and(bare) && !self.said.contains(number) && self.said.len() < MOST {
            self.said.push(*number);
            let message = format!("the tool table has neither a radius nor a length of tool {number}");
            say.about(codes::L1023, origin, message, "measure the tool, and fill in the table");
        }
    }
}
