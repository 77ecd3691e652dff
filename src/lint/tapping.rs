//! Which moves tap although no cycle says so.

use crate::machine::tools::Tools;
use crate::text::Sources;

use super::motion::{Machine, Setup, Step, TINY};

/// Knows taps by the tool table, and by G63, G331 or G332 in their block.
#[derive(Debug, Clone, Copy)]
pub struct Tapping<'a> {
    tools: &'a Tools,
    sources: &'a Sources,
}

impl<'a> Tapping<'a> {
    pub fn new(setup: &Setup<'a>) -> Tapping<'a> {
        Tapping { tools: &setup.settings.tools, sources: setup.sources }
    }

    /// Does a tap with a compensating chuck go in or out here, by a block of its own?
    pub fn taps(&self, step: &Step<'_>, machine: &Machine) -> bool {
        let straight = step.is_line() && step.cuts() && !step.of_cycle && !step.goes_sideways();
        straight && step.rise().is_none_or(|rise| rise.abs() > TINY) && (self.is_tap(machine) || self.says_so(step))
    }

    fn is_tap(&self, machine: &Machine) -> bool {
        let tool = machine.tool.and_then(|number| self.tools.by_printed(number));
        tool.is_some_and(|tool| tool.kind.as_deref() == Some("tap"))
    }

    fn says_so(&self, step: &Step<'_>) -> bool {
        let block = self.sources.bytes(step.origin.loc.file, step.origin.loc.span);
        let codes: [&[u8]; 3] = [b"G63", b"G331", b"G332"];
        codes.iter().any(|code| {
            block.windows(code.len()).enumerate().any(|(at, word)| {
                word.eq_ignore_ascii_case(code) && !block.get(at + code.len()).is_some_and(u8::is_ascii_digit)
            })
        })
    }
}
