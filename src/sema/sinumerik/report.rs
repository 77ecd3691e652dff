//! What is still open at the end of the run.

use crate::diag::{Label, codes};
use crate::ir::Side;
use crate::text::{FileId, Loc, Span};

use super::programs::{Unit, UnitKind, Units};
use super::{Channel, Core};

impl Channel<'_> {
    /// End of the whole run: what is still open is worth a word.
    pub(super) fn report_open(&mut self) {
        if let Some(table) = self.curve_table.take() {
            self.core.report(table.has_no_end());
        }
        let _: super::Outcome = self.soft_must_be_done();
        // Of a computed path that is an error, which is made where the path is.
        if self.st.side() != Side::None && !self.st.path.is_computed() {
            let fault = codes::P2041::program_ends_with_radius_compensation_2();
            self.core.say_here(fault.help("program G40 with a straight move before the end"));
        }
        if self.st.modal_call.is_on() {
            let found = codes::S8038::program_ends_with_modal_call().at(self.core.here.origin.loc);
            let found = found.also(self.st.modal_call.site(), Label::ModalCall);
            self.core.report(found.help("write MCALL in a block of its own before the end"));
        }
    }
}

impl Units {
    /// Other main programs of the file did not run.
    pub(super) fn report_others(&mut self, core: &mut Core<'_>) {
        let unit = core.levels.first().map_or(0, |level| level.frame.unit);
        let _ = self.list_rest(&core.job, &mut core.programs);
        let is_other = |at: usize| {
            let other = &self.list[at];
            at != unit && other.file == 0 && other.kind == UnitKind::Main
        };
        let others: Vec<&str> =
            (0..self.list.len()).filter(|at| is_other(*at)).map(|at| self.list[at].name.as_str()).collect();
        if others.is_empty() {
            return;
        }
        let Unit { start, name, .. } = &self.list[unit];
        let text = core.job.sources.bytes(FileId(0), Span::at(start.at, 80));
        let len = text.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(text.len());
        let start = Loc { file: FileId(0), line: start.line, span: Span::at(start.at, len as u32) };
        let found = codes::S8003::file_holds_several_main_programs(&name).at(start);
        core.job.diags.push(found.help(format!("put {} into files of their own", others.join(", "))));
    }
}
