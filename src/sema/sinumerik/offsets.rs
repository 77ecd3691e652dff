//! Work offsets: those of the machine are printed, those that the program writes go into the coordinates.
//!
//! Source: reference section 4.7.

use crate::diag::codes;
use crate::ir::{Function, Side};
use crate::machine::Axis;
use crate::text::Span;

use super::frames::FrameValue;
use super::system::offset_word;
use super::{Outcome, Run};

impl Run<'_> {
    /// A code of group 8: number 0 is G500, 1 is G54.
    pub(super) fn work_offset(&mut self, index: u8, span: Span) -> Outcome {
        self.pending_must_be_done(span)?;
        let number = index - 1;
        self.st.groups[8] = index;
        self.st.offset = number;
        if self.st.side() != Side::None {
            return self.fail(codes::S2080, 0, span, "the work offset changes while radius compensation is on");
        }
        if let Some(frame) = self.st.written.get(&number).cloned() {
            self.st.machine_coordinates = false;
            self.resolved_offset_note(span);
            self.resolves_offsets(span)?;
            self.switch_offset(Some(frame));
            return Ok(());
        }
        let mapped = self.job.settings.datums.words.get(&offset_word(number)).copied();
        if number == 0 && mapped.is_none() && self.st.offsets_resolved {
            // Offsets that the program wrote are printed in the basic system, which is what G500 leaves.
            self.st.machine_coordinates = false;
            self.switch_offset(Some(FrameValue::default()));
            return Ok(());
        }
        let printed = match (mapped, number) {
            (Some(printed), _) => Some(printed),
            (None, 0) => None,
            (None, 1..=9) => Some(number),
            _ => {
                let word = offset_word(number);
                return self.fail_help(
                    codes::S9014,
                    0,
                    span,
                    format!("{word} has no counterpart on the target"),
                    &format!("name one: `[datums] {word} = \"G55\"`"),
                );
            }
        };
        let was_machine = self.st.machine_coordinates;
        self.st.machine_coordinates = printed.is_none();
        if self.st.settable.take().is_some() {
            self.refresh_frame();
        }
        if let Some(number) = printed {
            self.st.offsets_printed = true;
            if self.st.offsets_resolved {
                return self.mixed_offsets(span);
            }
            self.function(Function::WorkOffset(number));
        }
        if printed.is_some() || !was_machine {
            self.forget_all();
        }
        if printed.is_none() {
            self.note_once(
                codes::S8011,
                span,
                "under G500 positions count in machine coordinates and are printed with G53",
            );
        }
        Ok(())
    }

    /// A written offset counts from the basic system, a printed one from where the machine has it: nobody knows the
    /// way between the two.
    pub(super) fn resolves_offsets(&mut self, span: Span) -> Outcome {
        self.st.offsets_resolved = true;
        if self.st.offsets_printed { self.mixed_offsets(span) } else { Ok(()) }
    }

    pub(super) fn mixed_offsets(&mut self, span: Span) -> Outcome {
        self.forget_all();
        self.fail_help(
            codes::S9017,
            0,
            span,
            "the program uses a work offset that it writes itself beside one of the machine",
            "let it write all the offsets it uses, or none",
        )
    }

    /// A work offset whose values are known goes into the coordinates.
    pub(super) fn switch_offset(&mut self, frame: Option<FrameValue>) {
        let known = self.st.settable.is_some() || self.st.offset == 0 || self.st.written.contains_key(&self.st.offset);
        self.st.settable = frame;
        if !known {
            self.forget_all();
        }
        self.refresh_frame();
    }

    pub(super) fn forget_all(&mut self) {
        for axis in Axis::ALL {
            self.st.forget(axis);
        }
    }

    pub(super) fn resolved_offset_note(&self, span: Span) {
        self.note_once(
            codes::S8012,
            span,
            "a work offset that the program writes itself is put into the coordinates, no G54 is printed: the offset active \
             on the target has to be zero",
        );
    }
}
