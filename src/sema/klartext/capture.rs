//! Describing a contour: the blocks of a subprogram run, but what they move is kept instead of carried out.
//!
//! Everything is afterwards what it was, parameters included: when a control runs the blocks, and how often, depends on the
//! cycle. Source: K 6.6 (docs/sources.md).

use crate::diag::{self, codes};
use crate::ir::captured::{Captured, Unfit};
use crate::lexer::klartext::QKind;
use crate::parser::klartext::ast::{Block, Stmt};
use crate::sema::run::step;
use crate::text::Loc;

use super::labels::Label;
use super::state::State;
use super::{Core, Outcome, Reported, Run};

/// Most elements of a contour, roundings and chamfers counted.
const MOST_ELEMENTS: usize = 1000;
/// The last parameter that cycles along contours keep their data in.
const LAST_OF_CYCLES: u32 = 20;

impl Run<'_> {
    /// Runs the subprogram of a contour; `cycle` is where the cycle that takes it is defined.
    pub(super) fn capture(&mut self, label: &Label, cycle: Loc) -> Outcome<Captured> {
        let here = self.core.here;
        let back = self.core.program().source.cursor.place();
        let before = (self.st.clone(), self.vars.clone(), self.core.locals().clone());
        let (free, modal) = (self.free.take(), self.cycles.modal());
        self.cycles.set_modal(false);
        self.st.begin_contour(label);
        let below = self.core.levels.len();
        let counted = self.core.contour_begins(MOST_ELEMENTS, &self.st.ctx);
        let entered = self.core.call_subprogram(label);
        while entered.is_ok() && self.core.levels.len() > below && !self.core.has_ended() {
            step(self);
        }
        let closed = self.close_contour();
        let made = self.core.contour_ends(counted, &here.origin);
        (self.free, self.core.here) = (free, here);
        self.cycles.set_modal(modal);
        (self.st, self.vars) = (before.0, before.1);
        if let Some(locals) = self.core.locals_mut() {
            *locals = before.2;
        }
        entered?;
        closed?;
        if self.core.has_ended() {
            return Err(Reported);
        }
        if self.core.program().source.cursor.place() != back {
            self.core.stop_run();
            return self.contours.fault(
                &self.core,
                label,
                "the program jumps out of it",
                "end the contour by its LBL 0",
            );
        }
        made.or_else(|why| unfit(&self.core, label, why, cycle))
    }
}

impl State {
    /// Only what shapes a contour may stand in one.
    #[inline]
    pub fn may_stand_in_contour(&mut self, core: &mut Core<'_>, block: &Block) -> Outcome {
        if self.described.is_some() { self.shapes_contour(core, block) } else { Ok(()) }
    }

    #[cold]
    fn shapes_contour(&mut self, core: &mut Core<'_>, block: &Block) -> Outcome {
        let Some(label) = &self.described else { return Ok(()) };
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
                let fault = codes::K2951::this_block_stands_in_contour(&label);
                return self.refuse_motion(core, core.block_span(), fault);
            }
        };
        if target.kind != QKind::Q || !(1..=LAST_OF_CYCLES).contains(&target.number) {
            return Ok(());
        }
        let fault = codes::K2951::contour_sets(&label, &target);
        self.refuse_motion(core, core.block_span(), fault)
    }
}

fn unfit<T>(core: &Core<'_>, label: &Label, unfit: Unfit, cycle: Loc) -> Outcome<T> {
    let (origin, what, help) = match unfit {
        Unfit::Reported => return Err(Reported),
        Unfit::TooMany(origin) => (origin, format!("it has more than {MOST_ELEMENTS} elements"), "split the contour"),
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
    core.report(found.called(origin.call).also(cycle, diag::Label::CycleThatTakesDefined).help(help));
    Err(Reported)
}
