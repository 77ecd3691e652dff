//! Describing a contour: the blocks of a contour run, but what they move is kept instead of carried out.
//!
//! The executor runs them as any other blocks – variables, loops, calls, stored contours, angles and corners included –
//! and afterwards everything is what it was, variables too: when the control runs them, and how often, depends on the cycle.

use crate::diag::{Fault, Label, codes};
use crate::ir::Function;
use crate::ir::captured::{Captured, Unfit};
use crate::sema::run::{Counted, Where, step};
use crate::text::Span;

use super::calls::FrameKind;
use super::g_groups::{GCode, Group};
use super::named_contour::{ContourCall, MOST_ELEMENTS};
use super::state::State;
use super::vars::Vars;
use super::vocabulary::Address;
use super::words::Words;
use super::{Core, Outcome, Reported, Run};

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
    pub fn refuse(&mut self, core: &Core<'_>, span: Span, fault: impl FnOnce(&str) -> Fault) -> Outcome {
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
        let feeds = [Address::F, Address::Frc, Address::Frcm];
        if let Some((word, given)) =
            feeds.iter().zip(["F", "FRC", "FRCM"]).find_map(|(address, word)| Some((word, w.get(*address)?)))
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
}

impl Run<'_> {
    /// Runs the blocks of a contour.
    pub(super) fn capture(&mut self, call: &ContourCall) -> Outcome<Captured> {
        let here = self.channel.core.here;
        let back = self.channel.core.place();
        let below = self.channel.core.levels.len();
        let (before, counted) = self.enter_capture(call);
        let entered = self.enter_contour(call);
        while entered.is_ok() && self.channel.core.levels.len() > below && !self.channel.core.has_ended() {
            step(self);
        }
        let pending = self.channel.pending_must_be_done(Where::Block);
        let capture = self.channel.capture.take();
        let made = self.channel.core.contour_ends(counted, &here.origin);
        self.channel.core.here = here;
        (self.channel.st, self.vars) = before;
        entered?;
        pending?;
        let Some(capture) = capture else { return Err(Reported) };
        if capture.failed || self.channel.core.has_ended() {
            return Err(Reported);
        }
        if !capture.complete || self.channel.core.place() != back {
            self.channel.core.stop_run();
            return self.channel.core.contour_fault(call, Where::Block, None, "the program jumps out of the contour");
        }
        made.or_else(|unfit| self.channel.core.unfit(call, unfit))
    }

    /// Everything as it is, and a fresh position: a contour does not depend on where the tool stands.
    fn enter_capture(&mut self, call: &ContourCall) -> ((State, Vars), Counted) {
        let before = (self.channel.st.clone(), self.vars.clone());
        self.channel.st.begin_contour();
        let below = self.channel.core.levels.len();
        self.channel.capture =
            Some(Box::new(Capture { below, complete: false, failed: false, name: call.name.clone() }));
        let counted = self.channel.core.contour_begins(MOST_ELEMENTS, &self.channel.st.ctx);
        (before, counted)
    }

    fn enter_contour(&mut self, call: &ContourCall) -> Outcome {
        match call.part {
            // Blocks of the program that calls see its variables.
            Some((from, stop)) if call.unit == self.unit() => self.channel.core.enter_section(from, stop, 1),
            part => self.call_part(call.unit, Vec::new(), 1, false, part),
        }
    }
}

impl Core<'_> {
    fn unfit(&mut self, call: &ContourCall, unfit: Unfit) -> Outcome<Captured> {
        let (origin, fault) = match unfit {
            Unfit::Reported => return Err(Reported),
            Unfit::TooMany(origin) => {
                let found =
                    codes::S4001::contour_has_more_than_elements(&MOST_ELEMENTS).at(origin.loc).called(origin.call);
                self.report(found.also(call.loc, Label::CalledHere).help("split it, or take splines of lines apart"));
                return Err(Reported);
            }
            Unfit::NoStart(origin) => (origin, codes::S2091::contour_has_no_start_point()),
            Unfit::Plane(origin) => (origin, codes::S2091::working_plane_changes_inside_contour()),
            Unfit::Frame(origin) => (origin, codes::S2091::coordinate_system_changes_inside_contour()),
            Unfit::Leaves(origin) => (origin, codes::S2091::block_of_contour_leaves_its_plane()),
        };
        let found = fault.at(origin.loc).called(origin.call);
        self.report(found.also(call.loc, Label::CalledHere));
        Err(Reported)
    }

    /// A fault of a contour, reported at its call.
    pub(super) fn contour_fault<T>(
        &self,
        call: &ContourCall,
        place: impl Into<Where>,
        alarm: impl Into<Option<u32>>,
        what: &str,
    ) -> Outcome<T> {
        self.refuse(place, codes::S2091::contour(&call.name, &what).alarm(alarm))
    }
}
