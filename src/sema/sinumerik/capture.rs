//! Describing a contour: the blocks of a contour run, but what they move is kept instead of carried out.
//!
//! The executor runs them as any other blocks – variables, loops, calls, stored contours, angles and corners included –
//! and afterwards everything is what it was, variables too: when the control runs them, and how often, depends on the cycle.

use crate::diag::{Fault, codes};
use crate::ir::Function;
use crate::text::Span;

use super::g_groups::{GCode, Group};
use super::levels::FrameKind;
use super::vocabulary::Address;
use super::words::Words;
use super::{Core, Outcome};

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

impl Capture {
    /// A contour above the levels of the call stack that are there.
    pub fn above(below: usize, name: &str) -> Box<Capture> {
        Box::new(Capture { below, complete: false, failed: false, name: name.to_owned() })
    }

    /// Does the contour go on?
    pub fn goes_on(&self, core: &Core<'_>) -> bool {
        core.levels.len() > self.below
    }

    /// A level ended by itself: perhaps it was the contour. `levels` are left.
    pub fn level_ended(&mut self, levels: usize) {
        self.complete |= levels <= self.below;
    }

    /// May the program that runs end here? Not if only a part of it describes the contour.
    pub fn ends_program(&self, core: &Core<'_>) -> bool {
        let mut levels = core.levels.iter().skip(self.below);
        if levels.any(|level| matches!(level.frame.kind, FrameKind::Program { .. })) {
            return false;
        }
        core.stop_run();
        core.say_here(codes::S2091::program_ends_inside_contour());
        true
    }

    /// Inside a contour no function is carried out; those of the machine do not belong there.
    pub fn function(&mut self, core: &Core<'_>, function: &Function) {
        if !matches!(
            function,
            Function::Comment(_) | Function::Remark(_) | Function::Plane(_) | Function::PathControl(_)
        ) {
            self.failed = true;
            core.say_here(codes::S2091::contour_holds_function_of_machine(&self.name));
        }
    }

    /// What is no part of a contour, by a fault that names the contour.
    pub fn refuse<T>(&mut self, core: &Core<'_>, span: Span, fault: impl FnOnce(&str) -> Fault) -> Outcome<T> {
        self.failed = true;
        core.refuse(span, fault(&self.name))
    }

    /// Words that shape no contour: the cycle has its own compensation and feeds.
    pub fn words(&mut self, core: &Core<'_>, w: &Words) -> Outcome {
        let offset =
            w.get(Address::Offn).filter(|offset| offset.value != 0.0).map(|given| ("OFFN".to_owned(), given.span));
        let side = w.code_of(Group::Compensation).filter(|(code, _)| *code != GCode::G40);
        let limit = w.get(Address::Lims).map(|given| ("LIMS".to_owned(), given.span));
        if let Some((word, span)) = side.map(|(code, span)| (code.word(), span)).or(offset).or(limit) {
            return self.refuse(core, span, |name| codes::S2091::stands_in_contour_which_is_shape(&word, &name));
        }
        let feeds = [Address::F, Address::Fb, Address::Frc, Address::Frcm];
        if let Some((word, given)) =
            feeds.iter().zip(["F", "FB", "FRC", "FRCM"]).find_map(|(address, word)| Some((word, w.get(*address)?)))
            && core.job.diags.first_time(codes::P8103, (word, &self.name))
        {
            let found = codes::P8103::in_contour_does_not_count(&word, &self.name).at(core.loc(given.span));
            core.report(
                found.help(
                    "give the feed to the cycle; whether a control finishes at F of the contour is not known here",
                ),
            );
        }
        Ok(())
    }

    /// Did it run to its end? Nothing is known of one in which something was refused.
    pub fn is_complete(&self) -> Option<bool> {
        (!self.failed).then_some(self.complete)
    }
}
