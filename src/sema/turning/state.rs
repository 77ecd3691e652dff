//! Modal state of a turning program.

use std::rc::Rc;

use crate::diag::{Fault, codes};
use crate::geo::{Plane, Point2, SAME_POINT, Vec2, distance};
use crate::ir::contour::{Ctx, CtxRef};
use crate::ir::cycle::recess::RecessTool;
use crate::machine::{AxisSet, Settings, Unit};
use crate::sema::common::compensation::Compensation;
use crate::sema::common::feed::ModalFeed;
use crate::sema::common::position::Position;
use crate::sema::common::spindle::ModalSpindle;
use crate::sema::common::start::Start;
use crate::text::Loc;

use super::chain::Solved;
use super::element_data::Transition;
use super::frames::Shift;
use super::stock::Stock;
use super::technology::Oversize;
use super::tool_facts::ActiveTool;

/// Everything that one block leaves to the next. Positions are millimetres, X is a radius.
#[derive(Debug)]
pub(super) struct State {
    pub unit: Unit,
    pub position: Position,
    pub last: Last,
    pub feed: ModalFeed,
    pub compensation: Compensation,
    /// Number of the tool in the cutting position.
    pub tool: Option<ActiveTool>,
    pub spindle: ModalSpindle,
    /// G47: clearance of the next cycles in mm.
    pub clearance: Option<f64>,
    pub oversize: Option<(Oversize, Loc)>,
    pub shift: Shift,
    /// G9 stands in this block, or in one whose move waits.
    pub exact_stop: bool,
    /// Something moved already.
    pub moved: bool,
    pub stock: Stock,
    pub ctx: CtxRef,
}

/// The last path element, for its direction.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Last {
    element: Option<Solved>,
    /// It ended in a chamfer, a rounding or B0: nothing is tangential to it.
    cornered: bool,
}

impl Last {
    /// The direction in which a tangential element goes on.
    pub fn direction(&self) -> Option<Vec2> {
        self.element.filter(|_| !self.cornered).and_then(|last| last.end_direction())
    }

    #[inline]
    pub fn follow(&mut self, solved: Solved, transition: Transition) {
        if solved.arc.is_some() || distance(solved.from, solved.to) > SAME_POINT {
            self.element = Some(solved);
        }
        self.cornered = transition != Transition::Open;
    }

    pub fn forget(&mut self) {
        self.element = None;
    }
}

impl State {
    pub fn new(settings: &Settings) -> State {
        State {
            unit: settings.control.unit.unwrap_or_default(),
            position: Position::new(Start::new(settings, true)),
            last: Last::default(),
            feed: ModalFeed::new(settings.control.feed, None),
            compensation: Compensation::default(),
            tool: None,
            spindle: ModalSpindle::default(),
            clearance: None,
            oversize: None,
            shift: Shift::default(),
            exact_stop: false,
            moved: false,
            stock: Stock::default(),
            ctx: Rc::new(Ctx { plane: Plane::Zx, ..Ctx::default() }),
        }
    }

    /// Millimetres in a unit of the program.
    pub fn mm(&self) -> f64 {
        self.unit.mm()
    }

    /// The tool in the cutting position as a recessing tool, and whether it cuts radially.
    pub fn recess_tool(&self, settings: &Settings) -> Result<(RecessTool, bool), Fault> {
        let missing = codes::P2004::no_tool_is_in_cutting_position;
        self.tool.as_ref().ok_or_else(missing).and_then(|tool| tool.recess_tool(settings))
    }

    /// Where the tool stands, as (Z, X).
    #[inline]
    pub fn at(&self) -> Option<Point2> {
        self.position.in_plane(Plane::Zx)
    }

    /// The tool stands somewhere, for a good reason.
    pub fn forget(&mut self) {
        self.position.forget(AxisSet::MAIN);
        self.last.forget();
    }

    /// The tool stands somewhere because an error was reported.
    pub fn lose(&mut self) {
        self.forget();
        self.position.lose(AxisSet::MAIN);
    }
}
