//! Describing a contour: the blocks of a contour run, but what they move is kept instead of carried out.
//!
//! The executor runs them as any other blocks – variables, loops, calls, stored contours, angles and corners included –
//! and afterwards everything is what it was, variables too: when the control runs them, and how often, depends on the cycle.

use crate::diag::codes;
use crate::ir::Function;
use crate::sema::run::Where;
use crate::text::Span;

use super::g_groups::{GCode, Group};
use super::levels::FrameKind;
use super::vocabulary::Address;
use super::words::Words;
use super::{Channel, Outcome};

/// A contour while its blocks run.
#[derive(Debug)]
pub(super) struct Capture {
    /// Levels of the call stack below the contour.
    below: usize,
    /// The contour ran to its end.
    complete: bool,
    /// Something in it was refused.
    failed: bool,
    name: String,
}

/// What ran up to its last block.
pub(super) enum PartEnds {
    /// A section of a repeat, which is over or goes round again.
    Section,
    /// A part of a program, which has to be left.
    Program,
}

impl Capture {
    /// A contour above the levels of the call stack that are there.
    pub fn above(below: usize, name: &str) -> Box<Capture> {
        Box::new(Capture { below, complete: false, failed: false, name: name.to_owned() })
    }

    /// Did it run to its end? Nothing is known of one in which something was refused.
    pub fn is_complete(&self) -> Option<bool> {
        (!self.failed).then_some(self.complete)
    }
}

impl Channel<'_> {
    pub(super) fn in_contour(&self) -> bool {
        self.capture.as_ref().is_some_and(|capture| self.core.levels.len() > capture.below)
    }

    pub(super) fn is_capturing(&self) -> bool {
        self.capture.is_some()
    }

    /// Ends the section, or its pass, that ran up to its last block; of a part of a program it only says so.
    pub(super) fn section_ends(&mut self, at: u32) -> Option<PartEnds> {
        let level = self.core.level();
        let back = level.back;
        match &mut level.frame.kind {
            FrameKind::Section { from, stop, left } if at >= *stop || at < from.at => {
                let from = *from;
                let again = *left > 0;
                if again {
                    *left -= 1;
                } else {
                    self.core.levels.pop();
                    self.level_ended();
                }
                // A file that was read once can be read again.
                let _ = self.core.resume(if again { from } else { back });
                Some(PartEnds::Section)
            }
            FrameKind::Program { stop: Some(stop), .. } if at >= *stop => Some(PartEnds::Program),
            _ => None,
        }
    }

    /// A level ended by itself: perhaps it was the contour.
    pub(super) fn level_ended(&mut self) {
        let levels = self.core.levels.len();
        if let Some(capture) = self.capture.as_mut().filter(|capture| levels <= capture.below) {
            capture.complete = true;
        }
    }

    /// May the program that runs end here? Not if only a part of it describes the contour.
    pub(super) fn ends_inside_contour(&mut self) -> bool {
        let Some(below) = self.capture.as_ref().map(|capture| capture.below) else { return false };
        let own =
            self.core.levels.iter().skip(below).any(|level| matches!(level.frame.kind, FrameKind::Program { .. }));
        if own {
            return false;
        }
        self.core.stop_run();
        let _: Outcome = self.core.refuse(Where::Block, codes::S2091::program_ends_inside_contour());
        true
    }

    /// A function in a contour. True for one that is done with: inside a contour nothing is carried out.
    pub(super) fn function_in_contour(&mut self, function: &Function) -> bool {
        let Some(capture) = self.capture.as_mut() else { return false };
        if matches!(
            function,
            Function::Comment(_) | Function::Remark(_) | Function::Plane(_) | Function::PathControl(_)
        ) {
            return true;
        }
        capture.failed = true;
        let name = capture.name.clone();
        let _: Outcome = self.core.refuse(Where::Block, codes::S2091::contour_holds_function_of_machine(&name));
        true
    }

    /// An axis that moves by itself is no path.
    pub(super) fn no_positioning_in_contour(&mut self, span: Span) -> Outcome {
        let Some(capture) = self.capture.as_mut() else { return Ok(()) };
        capture.failed = true;
        let name = capture.name.clone();
        self.core.refuse(span, codes::S2091::positioning_axis_moves_in_contour(&name))
    }

    /// Words that shape no contour: the cycle has its own compensation and feeds.
    pub(super) fn words_in_contour(&mut self, w: &Words) -> Outcome {
        let Some(name) = self.capture.as_ref().map(|capture| capture.name.clone()) else { return Ok(()) };
        let offset =
            w.get(Address::Offn).filter(|offset| offset.value != 0.0).map(|given| ("OFFN".to_owned(), given.span));
        let side = w.code_of(Group::Compensation).filter(|(code, _)| *code != GCode::G40);
        let limit = w.get(Address::Lims).map(|given| ("LIMS".to_owned(), given.span));
        if let Some((word, span)) = side.map(|(code, span)| (code.word(), span)).or(offset).or(limit) {
            if let Some(capture) = &mut self.capture {
                capture.failed = true;
            }
            return self.core.refuse(span, codes::S2091::stands_in_contour_which_is_shape(&word, &name));
        }
        let feeds = [Address::F, Address::Frc, Address::Frcm];
        if let Some((word, given)) =
            feeds.iter().zip(["F", "FRC", "FRCM"]).find_map(|(address, word)| Some((word, w.get(*address)?)))
            && self.core.job.diags.first_time(codes::P8103, (word, &name))
        {
            let found = codes::P8103::in_contour_does_not_count(&word, &name).at(self.core.loc(given.span));
            self.core.report(
                found.help(
                    "give the feed to the cycle; whether a control finishes at F of the contour is not known here",
                ),
            );
        }
        Ok(())
    }

    /// A cycle inside a contour.
    pub(super) fn no_cycle_in_contour(&mut self, name: &str, span: Span) -> Outcome {
        let Some(capture) = self.capture.as_mut() else { return Ok(()) };
        capture.failed = true;
        let contour = capture.name.clone();
        self.core.refuse(span, codes::S2091::stands_in_contour(&name, &contour))
    }
}
