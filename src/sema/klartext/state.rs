//! Modal state of a Klartext program.

use std::rc::Rc;

use crate::diag::{Fault, codes};
use crate::geo::{Plane, Point2, Vec2};
use crate::ir::contour::{Ctx, CtxRef, Path};
use crate::ir::{Pos, Side};
use crate::machine::{Axis, AxisSet, Settings};
use crate::sema::common::compensation::Compensation;
use crate::sema::common::hidden::By;
use crate::sema::common::position::Position;
use crate::sema::common::start::Start;
use crate::sema::run::Where;
use crate::sema::run::place::move_beside;
use crate::text::Loc;

use super::active_tool::{Change, ToolState};
use super::contour::{ContourState, LastMove, Step};
use super::feed::FeedState;
use super::frame_state::FrameState;
use super::labels::Label;
use super::pole::PolarState;
use super::rotary::RotaryState;
use super::spindle::SpindleState;
use super::tilt_state::TiltState;
use super::transformation::Transformation;
use super::words::{FeedWord, Words};
use super::{Core, Outcome, Reported};

/// Everything that one block leaves to the next. Positions are millimetres in the current input system.
#[derive(Debug, Clone)]
pub(super) struct State {
    /// R+ and R- leave an axis beside its nominal position.
    pub position: Position,
    pub polar: PolarState,
    pub feed: FeedState,
    pub compensation: Compensation,
    pub contour: ContourState,
    /// RND or CHF that waits for its second element.
    pub corner: Option<CornerMade>,
    pub tool: ToolState,
    pub frames: FrameState,
    pub spindle: SpindleState,
    pub rotary: RotaryState,
    pub tilt: TiltState,
    /// How the last move led to where it ends.
    pub last_path: Path,
    /// Direction of a tangential arc at its start, if that was the last move.
    pub last_entry: Option<Vec2>,
    /// Something moved already.
    pub moved: bool,
    /// The contour that is described, which is not carried out.
    pub described: Option<Label>,
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
            contour: ContourState::default(),
            corner: None,
            tool: ToolState::default(),
            frames: FrameState::new(Transformation::none(settings.control.klartext_readings.mirror_last)),
            spindle: SpindleState::default(),
            rotary: RotaryState::default(),
            tilt: TiltState::default(),
            last_path: Path::Rapid,
            last_entry: None,
            moved: false,
            described: None,
            left_by: None,
            blank: Blank::default(),
            ctx: Rc::new(Ctx::default()),
        }
    }

    /// The contour of this label is described from here on: it depends neither on where the tool stands nor on what its moves may do.
    pub fn begin_contour(&mut self, label: &Label) {
        self.described = Some(label.clone());
        self.position.forget(AxisSet::ALL);
        self.position.not_lost(AxisSet::ALL);
        self.left_by = None;
        self.polar.forget_last();
        self.feed.describe();
        self.contour.now = None;
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

    /// Nobody knows where the tool is.
    pub fn lost(&mut self, core: &mut Core<'_>) {
        self.corner = None;
        core.send_lost(&self.ctx);
    }

    /// Nothing is known behind the block in hand; what only suffers from it is not worth another error.
    pub fn lose_all(&mut self, core: &mut Core<'_>) {
        self.lose(AxisSet::MAIN);
        self.polar.lose_pole();
        self.lost(core);
    }

    /// A block that would move is refused: afterwards no position is known.
    pub fn refuse_motion<T>(&mut self, core: &mut Core<'_>, place: impl Into<Where>, fault: Fault) -> Outcome<T> {
        core.say(place, fault);
        self.lose_all(core);
        Err(Reported)
    }

    /// Refuses what may not stand in a compensated contour, where the compiler computes it.
    pub fn refuse_compensated(&mut self, core: &mut Core<'_>, what: &str) {
        if !self.compensation.is_on() || !core.computes_path() {
            return;
        }
        core.say_here(codes::K2606::while_radius_compensation(&what));
        self.end_compensation();
        self.contour.now = None;
        self.lose_all(core);
    }

    /// Reports a move that does not name the axes that a left-out cycle moved; behind a left-out probe only cuts have to.
    #[inline]
    pub fn moves_beside(&mut self, core: &mut Core<'_>, named: AxisSet, rapid: bool) -> bool {
        let probed = if rapid { AxisSet::EMPTY } else { self.position.left_by_probes() };
        let left = self.position.left_by_calls().union(probed);
        if left.is_empty() || self.described.is_some() {
            return false;
        }
        let found = move_beside(&self.position, left, named, &self.ctx.frame, core.here.origin.loc);
        let Some(found) = found else { return false };
        core.report(found);
        self.lose_all(core);
        true
    }

    /// F of a block; a cycle moves along a contour at its own feeds.
    pub fn set_feed(&mut self, core: &Core<'_>, w: &Words) -> Outcome {
        match &self.described {
            None => self.feed.take(core, &self.tool, w),
            Some(_) if w.feed == FeedWord::None => Ok(()),
            Some(label) => {
                let fault = codes::P8103::f_in_contour_does_not_count(&label);
                core.say_once(w.feed_span, fault.help("give the feed to the cycle, and remove it here"));
                Ok(())
            }
        }
    }

    /// Axes stand at places of the datum in force, as the configuration says.
    pub fn stand(&mut self, core: &mut Core<'_>, places: &Pos) {
        // What compensates holds back a move; what is only described stands nowhere.
        if self.compensation.is_on() || self.described.is_some() {
            return;
        }
        let known = self.position.stand_in_offset(places, &self.ctx.frame);
        self.polar.forget_last_of(known.known());
        core.stands_at(&known, &self.ctx);
    }

    /// The direction in which the last move ended, in the working plane.
    pub fn last_direction(&self) -> Option<Vec2> {
        let plane = self.plane();
        let (from, to) = (self.position.move_began(plane)?, self.position.in_plane(plane)?);
        LastMove::entered(from, to, plane, self.last_path, self.last_entry).direction(false)
    }

    /// These axes were moved in machine coordinates: forgets every programmed coordinate that depends on them.
    pub fn moved_by_machine(&mut self, end: &Pos, loc: Loc) {
        self.position.moved_by_machine(end, &self.ctx.frame, loc);
        if !self.tilt.is_upright() {
            // Each axis of the machine moves several of the plane.
            self.position.forget_tip(AxisSet::MAIN, By::Machine(None), loc);
        }
        self.rotary.forget_turns(end.known());
        self.polar.forget_last();
    }

    // The contour under compensation.

    /// How a move leads through the working plane, before its end is taken over.
    #[inline]
    pub fn step<'m>(&self, end: &'m Pos, path: &'m Path) -> Step<'m> {
        let plane = self.plane();
        let (first, second, _) = plane.axes();
        let (first, second) = (Axis::ALL[first], Axis::ALL[second]);
        let from = self.position.get(first).zip(self.position.get(second)).map(|(x, y)| Point2::new(x, y));
        let to = |from: Point2| Point2::new(end.get(first).unwrap_or(from.x), end.get(second).unwrap_or(from.y));
        Step { plane, way: from.map(|from| [from, to(from)]), end, path }
    }

    /// Notes a move of a contour, or the move that leads away from it, that is about to be sent.
    #[inline]
    pub fn note_contour(&mut self, end: &Pos, path: &Path) {
        if self.compensation.is_on() || self.contour.now.is_some() {
            let step = self.step(end, path);
            self.contour.follow(self.compensation.side(), &step);
        }
    }

    /// The compensation ends, and what M120 says with it.
    pub fn end_compensation(&mut self) {
        self.compensation.end();
        self.contour.look_ahead = 0;
    }

    /// The contour was refused, or lacks an element: what only suffers from it is not worth another error.
    pub fn lose_contour(&mut self) {
        self.end_compensation();
        self.compensation.lose();
        self.contour.now = None;
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
