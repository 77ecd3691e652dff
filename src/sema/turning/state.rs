//! Modal state of a turning program.

use std::rc::Rc;

use crate::geo::{Plane, Point2};
use crate::ir::contour::{Ctx, CtxRef};
use crate::ir::cycle::Layers;
use crate::machine::{AxisSet, Settings, Unit};
use crate::sema::common::compensation::Compensation;
use crate::sema::common::feed::ModalFeed;
use crate::sema::common::position::Position;
use crate::sema::common::start::Start;
use crate::text::Loc;

use super::chain::Solved;
use super::technology::{ActiveTool, Oversize, SpindleState};

/// Everything that one block leaves to the next. Positions are millimetres, X is a radius.
#[derive(Debug)]
pub(super) struct State {
    pub unit: Unit,
    pub position: Position,
    /// The last path element, for its direction.
    pub last: Option<Solved>,
    /// The last element ended in a chamfer, a rounding or B0: nothing is tangential to it.
    pub cornered: bool,
    pub feed: ModalFeed,
    pub compensation: Compensation,
    /// Number of the tool in the cutting position.
    pub tool: Option<ActiveTool>,
    pub spindle: SpindleState,
    /// G47: clearance of the next cycles in mm.
    pub clearance: Option<f64>,
    pub oversize: Option<(Oversize, Loc)>,
    pub shift: Shift,
    /// G9 stands in this block, or in one whose move waits.
    pub exact_stop: bool,
    /// Something moved already.
    pub moved: bool,
    /// Something was cut from the blank already.
    pub cut: bool,
    /// The last roughing, and the shift of the zero it counts from.
    pub roughed: Vec<(Rc<Layers>, f64)>,
    pub ctx: CtxRef,
}

/// Shifts of the workpiece zero along Z in mm.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Shift {
    /// First G59, from which the output counts.
    pub base: Option<f64>,
    /// Last G59.
    pub absolute: Option<f64>,
    /// G51.
    pub relative: f64,
    /// Sum of G56.
    pub additive: f64,
}

impl Shift {
    pub fn total(&self) -> f64 {
        let absolute = self.absolute.unwrap_or(0.0) - self.base.unwrap_or(0.0);
        absolute + self.relative + self.additive
    }
}

impl State {
    pub fn new(settings: &Settings) -> State {
        State {
            unit: settings.control.unit.unwrap_or_default(),
            position: Position::new(Start::new(settings, true)),
            last: None,
            cornered: false,
            feed: ModalFeed::new(settings.control.feed, None),
            compensation: Compensation::default(),
            tool: None,
            spindle: SpindleState::default(),
            clearance: None,
            oversize: None,
            shift: Shift::default(),
            exact_stop: false,
            moved: false,
            cut: false,
            roughed: Vec::new(),
            ctx: Rc::new(Ctx { plane: Plane::Zx, ..Ctx::default() }),
        }
    }

    /// How the compiler compensates from now on.
    pub fn compensate(&mut self, rules: crate::ir::Compensation) {
        if self.ctx.compensation.as_deref() != Some(&rules) {
            self.ctx = Rc::new(Ctx { compensation: Some(Rc::new(rules)), ..(*self.ctx).clone() });
        }
    }

    /// Millimetres in a unit of the program.
    pub fn mm(&self) -> f64 {
        self.unit.mm()
    }

    /// Where the tool stands, as (Z, X).
    #[inline]
    pub fn at(&self) -> Option<Point2> {
        self.position.in_plane(Plane::Zx)
    }

    /// The tool stands at `p`.
    #[inline]
    pub fn stands(&mut self, p: Point2) {
        self.position.move_in_plane(Plane::Zx, p);
    }

    /// The tool stands somewhere, for a good reason.
    pub fn forget(&mut self) {
        self.position.forget(AxisSet::MAIN);
        self.last = None;
    }

    /// The tool stands somewhere because an error was reported.
    pub fn lose(&mut self) {
        self.forget();
        self.position.lose(AxisSet::MAIN);
    }
}
