//! Modal state of a Klartext program.

use std::rc::Rc;

use crate::geo::{Deg, Plane, Point2};
use crate::ir::contour::{Ctx, CtxRef};
use crate::ir::function::Turn;
use crate::ir::{Feed, Side};
use crate::machine::{Axis, AxisSet, Settings};
use crate::sema::common::position::Position;
use crate::sema::common::start::Start;
use crate::text::Loc;

use super::approach::Last;
use super::change::Change;
use super::path::CornerMade;
use super::transform::Transformation;

/// Everything that one block leaves to the next. Positions are millimetres in the current input system.
#[derive(Debug)]
pub(super) struct State {
    /// R+ and R- leave an axis beside its nominal position.
    pub position: Position,
    pub pole: Option<PoleState>,
    /// A pole block was refused: a missing pole is not worth another error.
    pub pole_lost: bool,
    /// Radius and angle of the last polar block, while nothing else moved in the plane.
    pub polar: Option<LastPolar>,
    /// Radius and angle last written in a polar block.
    pub programmed_polar: Option<(f64, Deg)>,
    /// Counter-clockwise, of the last arc.
    pub turn: Option<bool>,
    pub feed: Option<Feed>,
    /// Number of the feed word in force, as written: what a move of rotary axes alone takes as degrees.
    pub written_feed: f64,
    /// F of the last TOOL CALL, and the number as written.
    pub tool_feed: Option<(Feed, f64)>,
    /// M136: F counts per revolution.
    pub per_revolution: bool,
    /// M103: highest share of the feed in the negative tool axis.
    pub plunge_share: Option<f64>,
    pub side: Side,
    /// RL or RR was refused: a contour that lacks it is not worth another error.
    pub side_lost: bool,
    /// RND or CHF that waits for its second element.
    pub corner: Option<CornerMade>,
    pub tool: Option<ActiveTool>,
    pub tool_axis: Option<Axis>,
    pub transform: Transformation,
    /// Counts changes of the input system.
    pub system: u32,
    /// Cycle 247 selected a preset.
    pub preset_selected: bool,
    pub spindle: Option<Turn>,
    /// The spindle was started once.
    pub spindle_used: Option<Turn>,
    pub speed: Option<f64>,
    pub coolant: bool,
    /// M126: rotary axes take the short way.
    pub short_way: bool,
    /// M116: feed of rotary axes at the surface.
    pub rotary_feed: bool,
    /// M109 or M110: feed at the cutting edge.
    pub edge_feed: bool,
    /// Whole turns between the printed and the programmed position of A, B, C, in degrees.
    pub rotary_offset: [f64; 3],
    /// The last compensated move in the plane, for its direction.
    pub last: Option<Last>,
    /// The last positioning block went at rapid traverse.
    pub last_rapid: bool,
    /// Rotary axes that the program moved.
    pub rotary_moved: AxisSet,
    /// M128: the tool tip stays where it is when rotary axes turn.
    pub follows_tip: bool,
    /// Angle of cycle 13.
    pub orientation: Option<f64>,
    /// The tool change under way.
    pub change: Change,
    /// Number of the tool that the last change printed.
    pub in_spindle: Option<u32>,
    /// A cycle that measures tools was left out: what the tables say of them is not what the control has.
    pub tools_measured: bool,
    /// Something moved already.
    pub moved: bool,
    pub blank: Blank,
    pub ctx: CtxRef,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct PoleState {
    pub at: Point2,
    pub plane: Plane,
    pub set: Loc,
    pub system: u32,
    /// A polar block named or reached an angle about it.
    pub used: bool,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct LastPolar {
    /// Not negative: a negative PR is kept as its opposite direction.
    pub radius: f64,
    pub angle: Deg,
    pub pole: Point2,
    pub plane: Plane,
    /// PR was written negative or zero: what a missing word means then is open.
    pub doubtful: bool,
}

impl LastPolar {
    pub fn new(radius: f64, angle: Deg, pole: &PoleState) -> LastPolar {
        let (at, plane) = (pole.at, pole.plane);
        let angle = if radius < 0.0 { Deg(angle.0 + 180.0) } else { angle };
        LastPolar { radius: radius.abs(), angle, pole: at, plane, doubtful: radius <= 0.0 }
    }
}

/// The tool in the spindle; lengths in mm, `None` for unknown.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ActiveTool {
    /// Number to print.
    pub number: u32,
    /// As called: the number without the index, or the name.
    pub called: String,
    pub radius: Option<f64>,
    /// What the tool table says where TOOL DEF gave another radius.
    pub other_radius: Option<f64>,
    pub length: Option<f64>,
    pub corner_radius: Option<f64>,
    /// Oversizes of length, radius and corner radius from the table.
    pub table_deltas: [f64; 3],
    /// The same from TOOL CALL.
    pub call_deltas: [f64; 3],
}

impl ActiveTool {
    /// Radius with all oversizes.
    pub fn effective_radius(&self) -> Option<f64> {
        self.radius.map(|r| r + self.table_deltas[1] + self.call_deltas[1])
    }
}

/// BLK FORM, for checks only.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Blank {
    pub axis: Option<Axis>,
    pub min: Option<[f64; 3]>,
}

impl State {
    pub fn new(settings: &Settings) -> State {
        let feed = settings.control.feed;
        State {
            position: Position::new(Start::new(settings, false)),
            pole: None,
            pole_lost: false,
            polar: None,
            programmed_polar: None,
            turn: None,
            feed: feed.map(Feed::PerMinute),
            written_feed: feed.unwrap_or_default(),
            tool_feed: feed.map(|feed| (Feed::PerMinute(feed), feed)),
            per_revolution: false,
            plunge_share: None,
            side: Side::None,
            side_lost: false,
            tool: None,
            tool_axis: None,
            transform: Transformation::none(settings.control.klartext_readings.mirror_last),
            preset_selected: false,
            system: 0,
            spindle: None,
            spindle_used: None,
            speed: None,
            coolant: false,
            short_way: false,
            rotary_feed: false,
            edge_feed: false,
            rotary_offset: [0.0; 3],
            last: None,
            last_rapid: false,
            rotary_moved: AxisSet::EMPTY,
            follows_tip: false,
            orientation: None,
            change: Change::None,
            corner: None,
            in_spindle: None,
            tools_measured: false,
            moved: false,
            blank: Blank::default(),
            ctx: Rc::new(Ctx::default()),
        }
    }

    /// Tool axis in force: called, or that of the blank, or Z.
    pub fn axis(&self) -> Axis {
        self.tool_axis.or(self.blank.axis).unwrap_or(Axis::Z)
    }

    /// Working plane that belongs to the tool axis.
    pub fn plane(&self) -> Plane {
        plane_of(self.axis())
    }

    /// Forgets where these axes are.
    pub fn lose(&mut self, axes: AxisSet) {
        self.position.lose(axes);
        self.polar = None;
    }

    /// These axes were moved in machine coordinates: forgets every programmed coordinate that depends on them.
    pub fn moved_by_machine(&mut self, axes: AxisSet) {
        self.position.moved_by_machine(axes, &self.ctx.frame);
        for axis in axes.iter().filter(|axis| axis.is_rotary()) {
            self.rotary_offset[axis.index() - Axis::A.index()] = 0.0;
        }
        self.polar = None;
    }

    /// What is shown for a rotary axis: the position without the whole turns that only the output counts.
    pub fn shown(&self, axis: Axis, at: f64) -> f64 {
        if axis.is_rotary() { at - self.rotary_offset[axis.index() - Axis::A.index()] } else { at }
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
