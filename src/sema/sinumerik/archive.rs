//! `%` lines: where the programs of an archive begin, and what may stand behind the last one.
//!
//! Source: S 1.1 (docs/sources.md).

use crate::diag::codes;
use crate::sema::run::Where;
use crate::text::{Place, Span};

use super::programs::{Units, header_name};
use super::{Core, Outcome, levels};

/// A program of an archive ends at the `%` line of the next one.
pub(super) struct ProgramEnds {
    /// Blocks follow a bare `%`.
    pub blocks_follow: bool,
}

impl Units {
    /// A `%` line: the program of an archive that follows is another one.
    pub(super) fn header(&mut self, core: &mut Core<'_>) -> Outcome<Option<ProgramEnds>> {
        const AHEAD: u32 = 1 << 16;
        let unit = core.level().frame.unit;
        let (file, here) = (core.here.file, core.here.at);
        let start = self.list[unit].start.at;
        if here == start || core.job.sources.bytes(file, Span::at(here, 1)) != b"%" {
            return Ok(None);
        }
        let called = core.levels.len() > 1;
        let executed = levels::program(&mut core.levels).executed;
        if !called && executed && start == 0 && !core.job.sources.bytes(file, Span::at(0, 4)).contains(&b'%') {
            return core.refuse(Where::Block, codes::S2013::blocks_stand_in_front_of_first_program());
        }
        if called || executed {
            let blocks_follow = blocks_behind_the_end(&core.job.sources.bytes(file, Span::at(here, AHEAD)));
            return Ok(Some(ProgramEnds { blocks_follow }));
        }
        // Comments in front of the first header.
        let line = core.job.sources.bytes(file, Span::at(here, 200));
        let line = line.split(|b| matches!(b, b'\n' | b'\r')).next().unwrap_or_default();
        if let Some((name, kind)) = header_name(line) {
            let first = &mut self.list[unit];
            (first.name, first.kind) = (name, kind);
            first.start = Place { at: here, line: core.here.line };
            let main = self.main_of(core, unit);
            core.level().frame.unit = main;
        }
        Ok(None)
    }
}

/// Has the `%` of this line no name, and a block behind it?
fn blocks_behind_the_end(bytes: &[u8]) -> bool {
    let mut lines = bytes.split(|b| matches!(b, b'\n' | b'\r')).map(<[u8]>::trim_ascii);
    let bare = lines.next().is_some_and(|line| header_name(line).is_none());
    let next = lines.find(|line| !line.is_empty() && !line.starts_with(b";"));
    bare && next.is_some_and(|line| !matches!(line[0], b'%' | 0 | 0x1a))
}
