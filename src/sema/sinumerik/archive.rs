//! `%` lines: where the programs of an archive begin, and what may stand behind the last one.
//!
//! Source: S 1.1 (docs/sources.md).

use crate::diag::codes;
use crate::sema::run::Where;
use crate::text::{Place, Span};

use super::{Core, Outcome, Run, programs};

impl Run<'_> {
    /// A `%` line: the program of an archive that follows is another one.
    pub(super) fn header(&mut self) -> Outcome {
        let unit = self.channel.core.level().frame.unit;
        if self.channel.core.here.at == self.units.list[unit].start.at || !self.channel.core.starts_program() {
            return Ok(());
        }
        if self.channel.core.levels.len() == 1
            && self.channel.core.program_level().executed
            && self.units.list[unit].start.at == 0
        {
            let first = self.channel.core.job.sources.bytes(self.channel.core.here.file, Span::at(0, 4));
            if !first.contains(&b'%') {
                return self.channel.core.refuse(Where::Block, codes::S2013::blocks_stand_in_front_of_first_program());
            }
        }
        if self.channel.core.levels.len() > 1 || self.channel.core.program_level().executed {
            let lost = self.channel.core.blocks_behind_the_end();
            self.file_over();
            if lost {
                return self.channel.core.refuse(Where::Block, codes::S2013::blocks_stand_behind_that_closes_program());
            }
            return Ok(());
        }
        // Comments in front of the first header.
        let line =
            self.channel.core.job.sources.bytes(self.channel.core.here.file, Span::at(self.channel.core.here.at, 200));
        let line = line.split(|b| matches!(b, b'\n' | b'\r')).next().unwrap_or_default();
        if let Some((name, kind)) = programs::header_name(line) {
            let first = &mut self.units.list[unit];
            first.name = name;
            first.kind = kind;
            first.start = Place { at: self.channel.core.here.at, line: self.channel.core.here.line };
            let main = self.main_unit(unit);
            self.channel.core.level().frame.unit = main;
        }
        Ok(())
    }
}

impl Core<'_> {
    /// Does the `%` of this line have no name, and a block behind it?
    fn blocks_behind_the_end(&self) -> bool {
        const AHEAD: u32 = 1 << 16;
        let bytes = self.job.sources.bytes(self.here.file, Span::at(self.here.at, AHEAD));
        let mut lines = bytes.split(|b| matches!(b, b'\n' | b'\r')).map(<[u8]>::trim_ascii);
        let bare = lines.next().is_some_and(|line| programs::header_name(line).is_none());
        let next = lines.find(|line| !line.is_empty() && !line.starts_with(b";"));
        bare && next.is_some_and(|line| !matches!(line[0], b'%' | 0 | 0x1a))
    }

    fn starts_program(&self) -> bool {
        self.job.sources.bytes(self.here.file, Span::at(self.here.at, 1)) == b"%"
    }
}
