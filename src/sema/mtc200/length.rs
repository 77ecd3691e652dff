//! G47 and G48: tool length compensation off and on.
//!
//! The programmed path is that of the tool tip while G48 is in force, and that of the spindle nose under G47. The
//! output is a path of the tip, so neither has a word in it. Source: M 8.0 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::machine::Axis;
use crate::text::{Loc, Span};

use super::{Core, Outcome, Reported};

/// What positions along the tool axis belong to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum Length {
    /// Neither G47 nor G48 was programmed; the first move along the tool axis since the start.
    #[default]
    Open,
    Moved(Loc),
    /// G48: of the tip.
    Tip,
    /// G47: of the spindle nose; reported or not.
    Nose {
        reported: bool,
    },
}

impl Length {
    /// G47 (`on` is false) and G48: where the nose moved along `axis` before G48, that is one of the nose.
    pub fn switch(&mut self, on: bool, axis: Axis, core: &Core<'_>) -> Outcome {
        let before = *self;
        *self = match (on, before) {
            (true, _) => Length::Tip,
            (false, Length::Nose { reported }) => Length::Nose { reported },
            (false, _) => Length::Nose { reported: false },
        };
        match before {
            Length::Moved(loc) if on => {
                core.nose_moved(axis, loc, "the program switches the tool length on later, by G48")
            }
            _ => Ok(()),
        }
    }

    /// Does what D and E choose count, as the control adds it along the axes?
    pub fn counts(self) -> bool {
        !matches!(self, Length::Nose { .. })
    }

    /// A move along the tool axis: is it one of the spindle nose?
    #[inline]
    pub fn moves_along(&mut self, axis: Axis, span: Span, core: &Core<'_>) -> Outcome {
        match *self {
            Length::Open => *self = Length::Moved(core.loc(span)),
            Length::Nose { reported: false } => {
                *self = Length::Nose { reported: true };
                return core.nose_moved(axis, core.loc(span), "G47 switched the tool length off");
            }
            Length::Moved(_) | Length::Tip | Length::Nose { .. } => {}
        }
        Ok(())
    }
}

impl Core<'_> {
    /// D or E chooses another length than that of the tool.
    #[cold]
    pub(super) fn length_is_another(&self, letter: char, span: Span) {
        if !self.job.diags.first_time(codes::M8007, letter) {
            return;
        }
        self.say(
            span,
            if letter == 'D' {
                codes::M8007::correction_counts_in_length()
            } else {
                codes::M8007::edge_has_lengths_of_its_own()
            },
        );
    }

    #[cold]
    fn nose_moved(&self, axis: Axis, loc: Loc, why: &str) -> Outcome {
        let letter = axis.letter();
        if self.job.settings.control.mtc200.refuse_spindle_nose {
            self.report(codes::M9050::moves_spindle_nose_here(&letter, &why).at(loc));
            return Err(Reported);
        }
        self.report(
            codes::M8003::moves_spindle_nose_here(&letter, &why).answer(Answer::key("control", "spindle_nose")).at(loc),
        );
        Ok(())
    }
}
