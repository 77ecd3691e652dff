//! Modal state of a Klartext program.

use std::rc::Rc;

use crate::geo::{Plane, Vec2};
use crate::ir::contour::{Ctx, CtxRef, Path};
use crate::ir::{Pos, Side};
use crate::machine::{Axis, AxisSet, Settings};
use crate::sema::common::compensation::Compensation;
use crate::sema::common::position::Position;
use crate::sema::common::start::Start;
use crate::text::Loc;

use super::active_tool::Change;
use super::contour::{Contour, OwnCorner};
use super::feed::FeedState;
use super::frames::FrameState;
use super::m_functions::SpindleState;
use super::polar::PolarState;
use super::rotary::RotaryState;
use super::tool::ToolState;
use super::transformation::Transformation;

/// Everything that one block leaves to the next. Positions are millimetres in the current input system.
#[derive(Debug, Clone)]
pub(super) struct State {
    /// R+ and R- leave an axis beside its nominal position.
    pub position: Position,
    pub polar: PolarState,
    pub feed: FeedState,
    pub compensation: Compensation,
    pub contour: Option<Contour>,
    /// M97, M98 or M197 of this block.
    pub own_corner: OwnCorner,
    /// Blocks that M120 looks ahead.
    pub look_ahead: u32,
    /// RND or CHF that waits for its second element.
    pub corner: Option<CornerMade>,
    pub tool: ToolState,
    pub frames: FrameState,
    pub spindle: SpindleState,
    pub coolant: bool,
    pub rotary: RotaryState,
    /// How the last move led to where it ends.
    pub last_path: Path,
    /// Direction of a tangential arc at its start, if that was the last move.
    pub last_entry: Option<Vec2>,
    /// Something moved already.
    pub moved: bool,
    /// The definition of the cycle that left the tool at an open place of the plane.
    pub left_by: Option<Loc>,
    pub blank: Blank,
    pub ctx: CtxRef,
}

/// A chamfer or rounding whose second element is still to come.
#[derive(Debug, Clone, Copy)]
pub(super) struct CornerMade {
    pub rounding: bool,
    /// Of the element before.
    pub side: Side,
    pub loc: Loc,
}

/// BLK FORM, for checks only.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Blank {
    pub axis: Option<Axis>,
    pub min: Option<[f64; 3]>,
}

impl State {
    pub fn new(settings: &Settings) -> State {
        State {
            position: Position::new(Start::new(settings, false)),
            polar: PolarState::default(),
            feed: FeedState::new(settings.control.feed),
            compensation: Compensation::default(),
            contour: None,
            own_corner: OwnCorner::No,
            look_ahead: 0,
            corner: None,
            tool: ToolState::default(),
            frames: FrameState::new(Transformation::none(settings.control.klartext_readings.mirror_last)),
            spindle: SpindleState::default(),
            coolant: false,
            rotary: RotaryState::default(),
            last_path: Path::Rapid,
            last_entry: None,
            moved: false,
            left_by: None,
            blank: Blank::default(),
            ctx: Rc::new(Ctx::default()),
        }
    }

    /// A contour is described from here on: it depends neither on where the tool stands nor on what its moves may do.
    pub fn begin_contour(&mut self) {
        self.position.forget(AxisSet::ALL);
        self.position.not_lost(AxisSet::ALL);
        self.left_by = None;
        self.polar.forget_last();
        self.feed.presume();
        self.feed.share_plunges(None);
        self.contour = None;
        self.tool.change = Change::None;
    }

    /// Tool axis in force: called, or that of the blank, or Z.
    pub fn axis(&self) -> Axis {
        self.tool.axis().or(self.blank.axis).unwrap_or(Axis::Z)
    }

    /// Working plane that belongs to the tool axis.
    pub fn plane(&self) -> Plane {
        plane_of(self.axis())
    }

    /// Forgets where these axes are.
    pub fn lose(&mut self, axes: AxisSet) {
        self.position.lose(axes);
        self.polar.forget_last();
    }

    /// These axes were moved in machine coordinates: forgets every programmed coordinate that depends on them.
    pub fn moved_by_machine(&mut self, end: &Pos, loc: Loc) {
        self.position.moved_by_machine(end, &self.ctx.frame, loc);
        self.rotary.forget_turns(end.known());
        self.polar.forget_last();
    }

    /// What is shown for a rotary axis: the position without the whole turns that only the output counts.
    pub fn shown(&self, axis: Axis, at: f64) -> f64 {
        at - self.rotary.turns_of(axis)
    }
}

/// Working plane of a tool axis; U, V, W stand for the main axis they are parallel to.
pub(super) fn plane_of(axis: Axis) -> Plane {
    match axis {
        Axis::X | Axis::U => Plane::Yz,
        Axis::Y | Axis::V => Plane::Zx,
        _ => Plane::Xy,
    }
}
