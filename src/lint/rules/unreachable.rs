//! A block can never run.

use rustc_hash::FxHashSet;

use crate::diag::{Diagnostic, Label};
use crate::lint::motion::Setup;
use crate::lint::source::{Read, Report, SourceRule};
use crate::sema::run::survey::{Surveyed, What};
use crate::text::Loc;

super::rule! { L2002 Source Unreachable Warning "block-unreachable"
    what "block can never run"
    why "A jump that is always made stands before this block, and no label leads to it. It can never run: a condition got lost, or \
        the label before it. Said at the first block of each such stretch."
    example r#"
-- Example (L2002_fires.MPF)
; The jump is always made.
G0 X0 Y0 Z5
GOTOF ENDE
G1 X5 F100
ENDE: M30
"#
    says {
        unreachable() "this block can never run" help "remove it, or give it a label that something jumps to";
    }
}

/// Most blocks that are remembered.
const MOST: usize = 1000;

#[derive(Debug, Default)]
pub(super) struct Unreachable {
    after: Option<Loc>,
    /// First blocks behind jumps, with the numbers that a jump further down may lead to.
    found: Vec<(Option<u32>, Diagnostic)>,
    targets: Targets,
}

/// The block numbers that jumps lead to.
#[derive(Debug, Default)]
pub(super) struct Targets {
    numbers: FxHashSet<String>,
    unknown: bool,
}

impl Targets {
    pub(super) fn see(&mut self, block: &Surveyed<'_>) {
        for item in block.items {
            match &item.what {
                What::Uses(name) if name.starts_with('N') => {
                    self.numbers.insert(name.clone());
                }
                What::UsesUnknown => self.unknown = true,
                _ => {}
            }
        }
    }

    /// May a jump lead to a block of this number?
    pub(super) fn may_be(&self, number: Option<u32>) -> bool {
        self.unknown || number.is_some_and(|number| self.numbers.contains(&format!("N{number}")))
    }
}

impl Unreachable {
    pub(super) fn new(_: &Setup<'_>) -> Unreachable {
        Unreachable::default()
    }
}

impl SourceRule for Unreachable {
    fn block(&mut self, read: &Read<'_>, _: &mut Report<'_>) {
        let block = read.block;
        // Where a branch ends, the other one goes on.
        let led_to = |what: &What| matches!(what, What::Label(_) | What::Begins | What::Ends | What::Branches);
        if block.items.iter().any(|item| led_to(&item.what)) {
            self.after = None;
        }
        if let Some(jump) = self.after.filter(|_| !block.is_empty && !block.is_bad && self.found.len() < MOST) {
            self.after = None;
            let found = L2002::unreachable().at(read.words()).also(jump, Label::ProgramGoesOnElsewhere);
            self.found.push((block.number, found));
        }
        self.targets.see(block);
        if let Some(item) = block.items.iter().rfind(|item| item.what == What::Leaves && !block.skip) {
            self.after = Some(read.loc(item.span));
        }
    }

    fn wants_straight(&self) -> bool {
        self.after.is_some()
    }

    fn finish(&mut self, report: &mut Report<'_>) {
        let reached = self.found.drain(..).filter(|(number, _)| !self.targets.may_be(*number));
        reached.for_each(|(_, found)| report.say.found(found));
    }
}
