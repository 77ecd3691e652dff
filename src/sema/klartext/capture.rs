//! Describing a contour: the blocks of a subprogram run, but what they move is kept instead of carried out.
//!
//! Everything is afterwards what it was, parameters included: when a control runs the blocks, and how often, depends on the
//! cycle. Source: K 6.6 (docs/sources.md).

use crate::diag::{self, codes};
use crate::ir::Side;
use crate::ir::captured::{Captured, Unfit};
use crate::lexer::klartext::QKind;
use crate::parser::klartext::ast::{Block, Stmt};
use crate::sema::run::step;
use crate::text::{Loc, Span};

use super::known::Known;
use super::labels::Label;
use super::words::{Comp, FeedWord, Words};
use super::{Outcome, Reported, Run};

/// Most elements of a contour, roundings and chamfers counted.
const MOST_ELEMENTS: usize = 1000;
/// The last parameter that cycles along contours keep their data in.
const LAST_OF_CYCLES: u32 = 20;

/// A contour while its blocks run.
#[derive(Debug)]
pub(super) struct Capture {
    label: Label,
}

impl Run<'_> {
    /// Runs the subprogram of a contour; `cycle` is where the cycle that takes it is defined.
    pub(super) fn capture(&mut self, label: &Label, cycle: Loc) -> Outcome<Captured> {
        let here = self.core.here;
        let back = self.core.program().source.cursor.place();
        let before = (self.st.clone(), self.vars.clone(), self.locals().clone());
        let (free, modal) = (self.free.take(), self.cycles.modal());
        self.cycles.set_modal(false);
        self.st.begin_contour();
        let below = self.core.levels.len();
        self.capture = Some(Box::new(Capture { label: label.clone() }));
        let counted = self.core.contour_begins(MOST_ELEMENTS, &self.st.ctx);
        let entered = self.call_subprogram(label);
        while entered.is_ok() && self.core.levels.len() > below && !self.core.has_ended() {
            step(self);
        }
        let closed = self.close_contour();
        let made = self.core.contour_ends(counted, &here.origin);
        self.capture = None;
        (self.free, self.core.here) = (free, here);
        self.cycles.set_modal(modal);
        (self.st, self.vars) = (before.0, before.1);
        if let Some(locals) = super::flow::innermost_locals(&mut self.core.levels) {
            *locals = before.2;
        }
        entered?;
        closed?;
        if self.core.has_ended() {
            return Err(Reported);
        }
        if self.core.program().source.cursor.place() != back {
            self.core.stop_run();
            return self.contour_fault(label, "the program jumps out of it", "end the contour by its LBL 0");
        }
        made.or_else(|unfit| self.unfit(label, unfit, cycle))
    }

    pub(super) fn is_capturing(&self) -> bool {
        self.capture.is_some()
    }

    fn contour_name(&self) -> String {
        self.capture.as_ref().map(|capture| capture.label.to_string()).unwrap_or_default()
    }

    /// Only what shapes a contour may stand in one.
    #[inline]
    pub(super) fn may_stand_in_contour(&mut self, block: &Block) -> Outcome {
        if self.is_capturing() { self.shapes_contour(block) } else { Ok(()) }
    }

    #[cold]
    fn shapes_contour(&mut self, block: &Block) -> Outcome {
        let target = match block.stmt {
            Stmt::Empty
            | Stmt::Path(_)
            | Stmt::Functions
            | Stmt::Rounding
            | Stmt::Chamfer
            | Stmt::Pole
            | Stmt::Fk(_)
            | Stmt::Label(_)
            | Stmt::CallLabel { .. }
            | Stmt::AssignText(_)
            | Stmt::If { .. }
            // What they say of themselves is enough.
            | Stmt::Bad
            | Stmt::End { .. } => return Ok(()),
            Stmt::Assign(target) | Stmt::Fn { target, .. } | Stmt::SystemRead(target) => target,
            _ => {
                let _: Outcome = self.core.refuse(self.core.block_span(), codes::K2951::this_block_stands_in_contour(&self.contour_name()));
                self.lose_all();
                return Err(Reported);
            }
        };
        if target.kind != QKind::Q || !(1..=LAST_OF_CYCLES).contains(&target.number) {
            return Ok(());
        }
        let _: Outcome =
            self.core.refuse(self.core.block_span(), codes::K2951::contour_sets(&self.contour_name(), &target));
        self.lose_all();
        Err(Reported)
    }

    /// RL or RR in the first block says on which side of the contour the tool lies.
    pub(super) fn side_of_contour(&mut self, side: Side, span: Span) -> Outcome {
        if self.st.compensation.side() != Side::None {
            return self.core.refuse(span, codes::K2951::rl_rr_or_r0_stands_in_contour(&self.contour_name()));
        }
        self.st.compensation.select(side);
        Ok(())
    }

    /// A cycle moves at its own feeds.
    pub(super) fn feed_in_contour(&mut self, w: &Words) {
        if w.feed == FeedWord::None {
            return;
        }
        let found = codes::P8103::f_in_contour_does_not_count(&self.contour_name()).at(self.core.loc(w.feed_span));
        self.core.report_once(found.help("give the feed to the cycle, and remove it here"));
    }

    pub(super) fn no_m_in_contour(&mut self, w: &Words) -> Outcome {
        if !self.is_capturing() {
            return Ok(());
        }
        let paraxial = matches!(w.comp, Some(Comp::Paraxial(_))).then_some(w.comp_span);
        let speed = w.speed.map(|_| w.speed_span);
        let Some(span) = w.m().first().map(|m| m.span).or(speed).or(paraxial) else { return Ok(()) };
        self.core.refuse(span, codes::K2951::stands_in_contour(&self.word_text(span), &self.contour_name()))
    }

    pub(super) fn contour_fault<T>(&mut self, label: &Label, what: &str, help: &str) -> Outcome<T> {
        let mut found = codes::K2951::contour(&label, &what).at(self.core.here.origin.loc);
        if let Known::Given(named) = &self.contours.named {
            found = found.also(named.loc, diag::Label::ContoursNamed);
        }
        self.core.report_cause(found.help(help));
        Err(Reported)
    }

    fn unfit<T>(&mut self, label: &Label, unfit: Unfit, cycle: Loc) -> Outcome<T> {
        let (origin, what, help) = match unfit {
            Unfit::Reported => return Err(Reported),
            Unfit::TooMany(origin) => {
                (origin, format!("it has more than {MOST_ELEMENTS} elements"), "split the contour")
            }
            Unfit::NoStart(origin) => (
                origin,
                "it has no start point".to_owned(),
                "its first block names both axes of the working plane and the side: L X+10 Y+20 RL",
            ),
            Unfit::Plane(origin) => {
                (origin, "the working plane changes inside of it".to_owned(), "a contour lies in one plane")
            }
            Unfit::Frame(origin) => (
                origin,
                "the coordinate system changes inside of it".to_owned(),
                "program shifts, rotations and mirrors before the cycle call",
            ),
            Unfit::Leaves(origin) => (
                origin,
                "this block leaves the working plane".to_owned(),
                "a contour has moves of the two axes of its plane only; the depth belongs to the cycle",
            ),
        };
        let found = codes::K2951::contour(&label, &what).at(origin.loc);
        self.core.report(found.called(origin.call).also(cycle, diag::Label::CycleThatTakesDefined).help(help));
        Err(Reported)
    }
}
