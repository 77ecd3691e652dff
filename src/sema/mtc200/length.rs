//! G47 and G48: tool length compensation off and on.
//!
//! The programmed path is that of the tool tip while G48 is in force, and that of the spindle nose under G47. The
//! output is a path of the tip, so neither has a word in it. Source: M 8.0 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::ir::Pos;
use crate::machine::Axis;
use crate::text::{Loc, Span};

use super::{Outcome, Reported, Run};

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

impl Run<'_> {
    /// G47 (`on` is false) and G48.
    pub(super) fn set_length(&mut self, on: bool, span: Span) -> Outcome {
        if self.noted.insert("G48".to_owned()) {
            let word = if on { "G48" } else { "G47" };
            self.core.report(codes::M8002::has_no_word_in_output(&word).at(self.core.loc(span)));
        }
        let before = self.st.length;
        self.st.length = match (on, before) {
            (true, _) => Length::Tip,
            (false, Length::Nose { reported }) => Length::Nose { reported },
            (false, _) => Length::Nose { reported: false },
        };
        for (letter, _) in self.st.tool.chosen().into_iter().filter(|(_, chosen)| on && *chosen) {
            self.length_is_another(letter, span);
        }
        match before {
            Length::Moved(loc) if on => self.nose_moved(loc, "the program switches the tool length on later, by G48"),
            _ => Ok(()),
        }
    }

    /// D and E choose what the control adds along the axes, unless G47 has switched the length off: true where that was said.
    pub(super) fn counts_in_length(&mut self, letter: char, number: u32, span: Span) -> bool {
        let other = number > u32::from(letter == 'E');
        let counts = other && !matches!(self.st.length, Length::Nose { .. });
        if counts {
            self.length_is_another(letter, span);
        }
        counts
    }

    #[cold]
    fn length_is_another(&mut self, letter: char, span: Span) {
        if !self.noted.insert(format!("length of {letter}")) {
            return;
        }
        let fault = if letter == 'D' {
            codes::M8007::correction_counts_in_length()
        } else {
            codes::M8007::edge_has_lengths_of_its_own()
        };
        self.core.say(span, fault);
    }

    /// A move to `end`: is it one of the spindle nose?
    #[inline]
    pub(super) fn moves_the_nose(&mut self, end: &Pos, span: Span) -> Outcome {
        if self.st.length == Length::Tip {
            return Ok(());
        }
        let (_, _, third) = self.st.plane.axes();
        if end.get(Axis::ALL[third]).is_none() {
            return Ok(());
        }
        match self.st.length {
            Length::Open => self.st.length = Length::Moved(self.core.loc(span)),
            Length::Nose { reported: false } => {
                self.st.length = Length::Nose { reported: true };
                return self.nose_moved(self.core.loc(span), "G47 switched the tool length off");
            }
            Length::Moved(_) | Length::Tip | Length::Nose { .. } => {}
        }
        Ok(())
    }

    #[cold]
    fn nose_moved(&mut self, loc: Loc, why: &str) -> Outcome {
        let (_, _, third) = self.st.plane.axes();
        let letter = Axis::ALL[third].letter();
        if self.core.job.settings.control.mtc200.refuse_spindle_nose {
            self.core.report(codes::M9050::moves_spindle_nose_here(&letter, &why).at(loc));
            return Err(Reported);
        }
        self.core.report(
            codes::M8003::moves_spindle_nose_here(&letter, &why).answer(Answer::key("control", "spindle_nose")).at(loc),
        );
        Ok(())
    }
}
