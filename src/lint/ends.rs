//! Where the blocks of a file end.

use crate::sema::Job;
use crate::sema::run::survey::{Survey, Surveyed, Visitor, Wanted};
use crate::text::{FileId, Sources};

use super::lead;

/// The blocks of a file by their lines.
#[derive(Debug, Default)]
pub struct Ends {
    /// First and last line of each block, and the offset behind its last byte.
    blocks: Vec<(u32, u32, u32)>,
}

impl Ends {
    pub fn of(sources: &Sources, file: FileId, survey: Survey) -> Ends {
        let mut ends = Ends::default();
        lead(sources, file, survey, &mut ends);
        ends
    }

    /// The offset behind the block on this line.
    pub fn at(&self, line: u32) -> Option<u32> {
        let behind = self.blocks.partition_point(|(first, ..)| *first <= line);
        let (_, last, end) = self.blocks.get(behind.checked_sub(1)?)?;
        (line <= *last).then_some(*end)
    }
}

impl Visitor for Ends {
    fn wanted(&self) -> Wanted<'_> {
        Wanted::ALL
    }

    fn items(&self) -> bool {
        false
    }

    fn block(&mut self, block: &Surveyed<'_>, _: &Job<'_>) {
        let site = &block.site;
        let written = block.text.trim_ascii_end().len() as u32;
        self.blocks.push((site.line, site.line + site.lines.saturating_sub(1), site.at + written));
    }
}
