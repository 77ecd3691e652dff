//! G codes that hold on, and which of them may stand in one block.
//!
//! Source: reference section 3.

use crate::diag::{Diagnostic, codes};
use crate::ir::Side;
use crate::text::Span;

use super::vocabulary::Code;
use super::words::Words;
use super::{Outcome, Reported, Run};

impl Run<'_> {
    /// The codes that hold on.
    pub(super) fn modal_codes(&mut self, w: &Words) -> Outcome {
        for at in 0..w.codes.len() {
            let (code, span) = w.codes[at];
            self.modal_code(code, span)?;
        }
        if let Some((indexed, axis, span)) = w.diameter {
            self.axis_diameter(indexed, axis, span)?;
        }
        if let Some(span) = w.dynamics {
            self.dynamics_are_left_out(span);
        }
        Ok(())
    }

    pub(super) fn modal_code(&mut self, code: Code, span: Span) -> Outcome {
        let old = self.st.groups[code.group as usize];
        match code.group {
            1 => {
                self.check_interpolation(code, span)?;
                self.st.groups[1] = code.index;
            }
            2 | 3 | 9 => {}
            11 | 62 => self.left_out_code(code, span),
            6 => {
                self.st.groups[6] = code.index;
                if old != code.index {
                    self.plane_change(code.index, span)?;
                }
            }
            7 => self.compensation_code(code, span)?,
            8 => self.work_offset(code.index, span)?,
            15 => self.feed_code(code, span)?,
            29 => {
                if code != Code::DIAMOF && self.job.settings.machine.diameter_axis.is_none() {
                    return self.no_diameter_axis(span);
                }
                // DIAMCYCOF counts inside of cycles only.
                if code == Code::DIAMCYCOF {
                    self.control_words_are_left_out(span);
                } else {
                    self.st.groups[29] = code.index;
                    if let Some(stored) = self.stored.as_mut() {
                        stored.diameter_said = true;
                    }
                    self.st.diameter = None;
                }
            }
            _ => {
                self.refused_code(code, span)?;
                self.left_out_code(code, span);
                self.st.groups[code.group as usize] = code.index;
            }
        }
        Ok(())
    }

    pub(super) fn plane_change(&mut self, index: u8, span: Span) -> Outcome {
        if self.st.side() != Side::None {
            return self.fail_help(
                codes::S2080,
                10757,
                span,
                "the plane changes while radius compensation is on",
                "program G40 in a block in front of it",
            );
        }
        if let Some(pending) = self.pending.take() {
            self.pair_lost = true;
            let message = "the plane changes between the two lines of a pair (alarm 10790)";
            let found = Diagnostic::new(codes::S2070, pending.origin.loc, message);
            self.report(found.also(self.loc(span), "here").help("change the plane in front of the first line"));
            self.st.lose(crate::machine::AxisSet::MAIN);
            return Err(Reported);
        }
        self.set_plane(index);
        let plane = self.st.plane();
        self.function(crate::ir::Function::Plane(plane));
        Ok(())
    }

    pub(super) fn refused_code(&mut self, code: Code, span: Span) -> Outcome {
        let what = match (code.group, code.index) {
            (47, 2) => {
                self.iso = true;
                self.st.lose(crate::machine::Axis::ALL.into_iter().collect());
                self.lost();
                return self.fail_help(
                    codes::S9003,
                    0,
                    span,
                    "G291 switches to ISO dialect",
                    "translate the ISO part, or compile it by itself",
                );
            }
            (49, i) if i > 1 => "point-to-point travel",
            (52, 2) => "a frame turned to the workpiece",
            (53, i) if i > 1 => "a frame turned to the tool",
            (42, i) if i > 1 => "an orientable tool carrier",
            (35, i) if i > 1 => "punching",
            (31 | 32, _) => "a code of the machine builder",
            (40, 2) => "compensation with a constant offset",
            (64, _) => "a grinding frame",
            _ => return Ok(()),
        };
        let message = format!("{} is {what}, which cannot be printed", super::vocabulary::word(code));
        self.fail_help(codes::S9001, 0, span, message, "leave it out, or replace it by plain moves")
    }

    /// Groups 1 to 4 shape the block: it takes one of them.
    pub(super) fn check_codes(&mut self, w: &Words) -> Outcome {
        let mut shaping = w.codes.iter().filter(|(code, _)| code.group <= 4);
        if let (Some((a, first)), Some((b, second))) = (shaping.next(), shaping.next()) {
            return self.two_shapes(*a, *first, *b, *second);
        }
        Ok(())
    }

    pub(super) fn two_shapes(&self, a: Code, first: Span, b: Code, second: Span) -> Outcome {
        let (a, b) = (super::vocabulary::word(a), super::vocabulary::word(b));
        let message = format!("{a} and {b} cannot stand in one block (alarm 12070)");
        let found = Diagnostic::new(codes::S2009, self.loc(second), message);
        self.report(found.also(self.loc(first), "the other one").help("give each a block of its own"));
        Err(Reported)
    }
}
