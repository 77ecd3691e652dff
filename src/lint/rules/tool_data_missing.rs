//! The tool table has neither radius nor length of a tool.

use crate::ir::{Function, Origin};
use crate::lint::motion::{Machine, MotionRule, Say, Setup};
use crate::machine::tools::{Tool, Tools};

super::rule! { L1023 Motion ToolDataMissing Warning "tool-data-missing"
    what "tool table has no radius or no length of a tool"
    why "The tool is in the table that `[tools]` names, and the table has neither a radius nor a length for it. On the machine a \
        tool of length 0 goes as deep as the spindle nose is programmed: into the part. Measure the tool, and fill in the table."
    example r#"
-- Example (L1023_fires.H)
0 BEGIN PGM P MM
; The table knows the name of tool 1 and nothing else.
1 TOOL CALL 1 Z S2000
2 L X+0 Y+0 Z+5 R0 FMAX M3
3 L Z-1 F100
4 L Z+50 FMAX M30
5 END PGM P MM
-- partc.toml
[tools.1]
name = "MILL"
"#
    says {
        bare(number) "the tool table has neither a radius nor a length of tool {number}"
            help "measure the tool, and fill in the table";
    }
}

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
            say.about(L1023::bare(&number), origin);
        }
    }
}
