//! What is still open at the end of the run.

use crate::diag::{Label, codes};
use crate::text::{FileId, Loc, Span};

use super::Run;
use super::programs::UnitKind;

impl Run<'_> {
    /// End of the whole run: what is still open is worth a word.
    pub(super) fn report_open(&mut self) {
        let _: super::Outcome = self.channel.soft_must_be_done();
        // Of a computed path that is an error, which is made where the path is.
        if self.channel.st.side() != crate::ir::Side::None && !self.channel.st.path.is_computed() {
            let found = codes::P2041::program_ends_with_radius_compensation_2().at(self.channel.core.here.origin.loc);
            self.channel.core.report(found.help("program G40 with a straight move before the end"));
        }
        if let Some(open) = self.channel.open_modal_call() {
            let found = codes::S8038::program_ends_with_modal_call().at(self.channel.core.here.origin.loc);
            self.channel
                .core
                .report(found.also(open, Label::ModalCall).help("write MCALL in a block of its own before the end"));
        }
        let unit = self.channel.core.levels.first().map_or(0, |level| level.frame.unit);
        let _ = self.units.list_rest(&self.channel.core.job, &mut self.channel.core.programs);
        let others: Vec<&str> = self
            .units
            .list
            .iter()
            .enumerate()
            .filter(|(at, other)| *at != unit && other.file == 0 && other.kind == UnitKind::Main)
            .map(|(_, other)| other.name.as_str())
            .collect();
        if !others.is_empty() {
            let start = self.units.list[unit].start;
            let len = self.channel.core.job.sources.bytes(FileId(0), Span::at(start.at, 80));
            let len = len.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(len.len());
            let start = Loc { file: FileId(0), line: start.line, span: Span::at(start.at, len as u32) };
            let name = &self.units.list[unit].name;
            let found = codes::S8003::file_holds_several_main_programs(&name).at(start);
            self.channel.core.job.diags.push(found.help(format!("put {} into files of their own", others.join(", "))));
        }
    }
}
