//! A block stands behind the end of the program and nothing leads to it.

use crate::diag::{Diagnostic, Label};
use crate::lint::motion::Setup;
use crate::lint::source::{Read, Report, SourceRule};
use crate::sema::run::survey::What;
use crate::text::Loc;

use super::unreachable::Targets;

super::rule! { L2003 Source BehindEnd Warning "block-behind-end"
    what "block stands after the end of the program and nothing leads to it"
    why "M30, M2, RET or END stands before this block, and no label that could be called comes between. It never runs. It was left \
        over, or the end of the program stands too early. Subprograms after M30 begin with a label. Said once."
    example r#"
-- Example (L2003_fires.MPF)
; A move after M30.
G0 X0 Y0 Z5
G1 X5 F100
M30
G1 X9 F100
"#
    says {
        behind() "this block stands after the end of the program" help "remove it, or give it a label that something calls";
    }
}

/// Most blocks that are remembered.
const MOST: usize = 1000;

#[derive(Debug, Default)]
pub(super) struct BehindEnd {
    end: Option<Loc>,
    branches: bool,
    /// First blocks behind ends, with the numbers that a jump may lead to.
    found: Vec<(Option<u32>, Diagnostic)>,
    targets: Targets,
}

impl BehindEnd {
    pub(super) fn new(_: &Setup<'_>) -> BehindEnd {
        BehindEnd::default()
    }
}

impl SourceRule for BehindEnd {
    fn block(&mut self, read: &Read<'_>, _: &mut Report<'_>) {
        let block = read.block;
        self.targets.see(block);
        if block.items.iter().any(|item| matches!(item.what, What::Label(_) | What::Begins)) {
            self.end = None;
        }
        let ends = block.items.iter().find(|item| item.what == What::Ends);
        let is_found = !block.is_empty && !block.is_bad && ends.is_none() && self.found.len() < MOST;
        if let Some(end) = self.end.filter(|_| is_found) {
            self.end = None;
            let found = L2003::behind().at(read.words()).also(end, Label::ProgramEnds);
            self.found.push((block.number, found));
        }
        // One that may be skipped, or stands in a branch, ends nothing for sure.
        if let Some(item) = ends.filter(|_| !block.skip && !self.branches) {
            self.end = Some(read.loc(item.span));
        }
        self.branches |= read.has(&What::Branches);
    }

    fn wants_straight(&self) -> bool {
        self.end.is_some()
    }

    fn finish(&mut self, report: &mut Report<'_>) {
        let mut found = self.found.drain(..);
        if let Some((_, first)) = found.find(|(number, _)| !self.targets.may_be(*number)) {
            report.say.found(first);
        }
    }
}
