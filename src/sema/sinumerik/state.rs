//! Modal state of a run. Written here and by the statements, sampled by every item.

use std::rc::Rc;

use crate::diag::codes;
use crate::geo::Plane;
use crate::ir::contour::{Ctx, CtxRef};
use crate::ir::{Feed, Frame, Side};
use crate::machine::{Axis, AxisSet, MachineKind, Settings, Unit};
use crate::sema::common::orientation::Orientation;
use crate::sema::common::position::Position;
use crate::sema::common::start::Start;
use crate::sema::run::Where;

use super::Core;
use super::angle_lines::Pair;
use super::compensation::CompensationState;
use super::corners::Corners;
use super::diameter::Diameter;
use super::editor_contour::Stored;
use super::feed::FeedState;
use super::frames::{FrameValue, Frames, SavedFrames};
use super::g_groups::{ActiveCodes, GCode, Group};
use super::modal_call::ModalCall;
use super::offsets::OffsetUse;
use super::path_control::Smoothing;
use super::polar::Polar;
use super::probe_state::Touched;
use super::spindle_state::Spindles;
use super::system_variables::SystemVariables;
use super::tangent::Heading;
use super::tapping::Taps;
use super::threads::Threads;
use super::tool::ToolInUse;
use super::transformation::Transformed;
use super::vocabulary::Address;

/// Everything modal: what describing a contour leaves as it was.
#[derive(Debug, Clone)]
pub(super) struct State {
    pub codes: ActiveCodes,
    pub machine: MachineData,
    pub ctx: CtxRef,
    /// A contour is described, which nothing moves along.
    pub describes: bool,
    /// The numbers last programmed count where a frame changed (SD 42440).
    pub position: Position,
    /// The way of the last block that travelled.
    pub heading: Heading,
    pub polar: Polar,
    pub feed: FeedState,
    pub spindles: Spindles,
    pub frames: Frames,
    /// What planes and rotary words made of the tool.
    pub orientation: Orientation,
    /// Name of the swivel record by which CYCLE800 last turned rotary axes.
    pub swivel_record: String,
    pub offsets: OffsetUse,
    /// DIAMONA and its kin, over group 29.
    pub diameter: Option<Diameter>,
    pub tool: ToolInUse,
    pub compensation: CompensationState,
    /// How the compiler computes the path of the centre.
    pub path: super::compensation::Path,
    pub corners: Corners,
    pub pair: Pair,
    pub threads: Threads,
    pub taps: Taps,
    /// The program sees other axes than the machine has.
    pub transformation: Option<Transformed>,
    pub modal_call: ModalCall,
    /// The contour of the contour editor that runs.
    pub stored: Option<Box<Stored>>,
    pub smoothing: Smoothing,
    /// System variables that the program wrote.
    pub system: SystemVariables,
    /// Axes that stand where a probe left them.
    pub touched: Option<Touched>,
}

/// What the machine is, as far as programs depend on it.
#[derive(Debug, Clone, Copy)]
pub(super) struct MachineData {
    pub geometry_axes: [Axis; 3],
    pub lathe: bool,
    pub basic_unit: Unit,
    /// Rotary axes that count modulo 360 degrees: declared, or shown by DC, ACP or ACN.
    pub modulo: AxisSet,
}

impl MachineData {
    /// Interpolation parameters with the geometry axes they belong to (MD 20050).
    pub fn parameters(&self, names: [Address; 3]) -> [(Address, Axis); 3] {
        let axes = self.geometry_axes;
        [(names[0], axes[0]), (names[1], axes[1]), (names[2], axes[2])]
    }
}

/// What SAVE brings back.
#[derive(Debug, Clone)]
pub(super) struct Saved {
    pub codes: ActiveCodes,
    pub smoothing: Smoothing,
    pub frames: SavedFrames,
}

impl State {
    pub fn new(settings: &Settings) -> State {
        let codes = ActiveCodes::at_start(settings);
        let machine = &settings.machine;
        let lathe = machine.kind == MachineKind::Lathe;
        let basic_unit = settings.control.unit.unwrap_or_default();
        let plane = if lathe { Plane::Zx } else { Plane::Xy };
        State {
            codes,
            machine: MachineData { geometry_axes: machine.geometry_axes, lathe, basic_unit, modulo: machine.modulo },
            ctx: Rc::new(Ctx { plane, ..Ctx::default() }),
            describes: false,
            position: Position::new(Start::new(settings, codes.is(GCode::DIAMON))),
            heading: Heading::None,
            polar: Polar::default(),
            feed: FeedState::at_start(settings),
            spindles: Spindles::default(),
            frames: Frames::default(),
            orientation: Orientation::default(),
            swivel_record: String::new(),
            offsets: OffsetUse::default(),
            diameter: None,
            tool: ToolInUse::default(),
            compensation: CompensationState::default(),
            path: super::compensation::Path::default(),
            corners: Corners::default(),
            pair: Pair::default(),
            threads: Threads::default(),
            taps: Taps::default(),
            transformation: None,
            modal_call: ModalCall::default(),
            stored: None,
            smoothing: Smoothing::default(),
            system: SystemVariables::of_edges(&settings.tools.edges),
            touched: None,
        }
    }

    /// A contour is described from here on: it does not depend on where the tool stands, and what waits for a block
    /// outside waits for no block of it.
    pub fn begin_contour(&mut self) {
        self.describes = true;
        self.position.forget(AxisSet::ALL);
        self.position.not_lost(AxisSet::ALL);
        self.modal_call = ModalCall::default();
        self.stored = None;
        self.touched = None;
        self.threads.forget_lead();
        self.corners.open.close();
        self.spindles.close_cut_speed();
    }

    pub fn is(&self, code: GCode) -> bool {
        self.codes.is(code)
    }

    pub fn plane(&self) -> Plane {
        self.ctx.plane
    }

    /// Millimetres in a programmed unit of length.
    #[inline]
    pub fn length_unit(&self) -> f64 {
        self.codes.length_unit()
    }

    /// Millimetres in the unit of length of F.
    pub fn feed_unit(&self) -> f64 {
        self.codes.feed_unit(self.machine.basic_unit)
    }

    /// Does F count per revolution?
    pub fn per_revolution(&self) -> bool {
        self.codes.per_revolution()
    }

    /// Does a feed count as the kind of feed in force?
    pub fn counts_as(&self, feed: Feed) -> bool {
        match feed {
            Feed::PerRevolution(_) => self.per_revolution(),
            Feed::InverseTime(_) => self.is(GCode::G93),
            Feed::PerMinute(_) => !self.per_revolution() && !self.is(GCode::G93),
        }
    }

    /// A programmed feed with the kind that is in force.
    pub(super) fn feed_of(&self, value: f64) -> Feed {
        if self.is(GCode::G93) {
            return Feed::InverseTime(value);
        }
        let value = value * self.feed_unit();
        if self.codes.per_revolution() { Feed::PerRevolution(value) } else { Feed::PerMinute(value) }
    }

    /// F means something else now.
    pub(super) fn feed_mode_changed(&mut self) {
        let fits = self.feed.word().is_none_or(|feed| self.counts_as(feed));
        if !fits {
            self.feed.end();
        }
    }

    pub fn side(&self) -> Side {
        self.codes.side()
    }

    /// The side on which a move is printed: behind G40 the one of before, until a move in the plane takes the offset off.
    #[inline]
    pub(super) fn side_of_move(&self) -> Side {
        // The computed path stays beside the contour by itself.
        if self.path.is_computed() {
            self.printed_side(self.side())
        } else {
            self.compensation.side_of_move(self.side())
        }
    }

    /// The side of a move, as the sign of the radius has it.
    #[inline]
    pub(super) fn printed_side(&self, side: Side) -> Side {
        match side {
            Side::Left if self.path.swaps => Side::Right,
            Side::Right if self.path.swaps => Side::Left,
            side => side,
        }
    }

    pub fn diameter_mode(&self) -> Diameter {
        self.diameter.unwrap_or(match self.codes.of(Group::Diameter) {
            GCode::DIAMON => Diameter::On,
            GCode::DIAM90 => Diameter::Absolute,
            _ => Diameter::Off,
        })
    }

    /// Axes of the working plane and the one at a right angle to it.
    pub fn roles(&self) -> [Axis; 3] {
        let (first, second, third) = self.plane().axes();
        [Axis::ALL[first], Axis::ALL[second], Axis::ALL[third]]
    }
}

impl State {
    pub(super) fn save(&self) -> Saved {
        Saved { codes: self.codes, smoothing: self.smoothing, frames: self.frames.saved() }
    }

    /// The context with the plane of group 6.
    pub(super) fn set_plane(&mut self, code: GCode) {
        let (i, j) = match code {
            GCode::G18 => (2, 0),
            GCode::G19 => (1, 2),
            _ => (0, 1),
        };
        let axes = self.machine.geometry_axes;
        let fits = |plane: &Plane| {
            let (first, second, _) = plane.axes();
            (Axis::ALL[first], Axis::ALL[second]) == (axes[i], axes[j])
        };
        let plane = [Plane::Xy, Plane::Zx, Plane::Yz].into_iter().find(fits).unwrap_or(self.ctx.plane);
        if plane != self.ctx.plane {
            self.ctx = Rc::new(Ctx { plane, ..(*self.ctx).clone() });
            self.polar.plane_changed();
        }
    }

    /// Makes the context fit the frames; the tool stays where it is.
    pub(super) fn refresh_frame(&mut self, core: &Core<'_>) {
        let Some(frame) = self.frames.of_positions().map() else {
            self.position.lose(AxisSet::ALL);
            self.frames.set_programmable(FrameValue::default());
            let _: super::Outcome = core.refuse(Where::Block, codes::S2034::frame_cannot_be_used());
            return;
        };
        if frame != self.ctx.frame {
            let [_, _, axis] = self.roles();
            let turned = |frame: &Frame| frame.linear()[(axis.index(), axis.index())] < 0.0;
            if turned(&frame) && !turned(&self.ctx.frame) {
                let fault = codes::P2030::tool_axis_is_mirrored_2(&axis.letter());
                core.say_here(fault.help("check that this is meant; most often another axis is"));
            }
            self.heading = self.heading.across_frames(&self.position, frame.linear() != self.ctx.frame.linear());
            self.position.keep_programmed();
            self.position.through_frame(&self.ctx.frame, &frame);
            self.ctx = Rc::new(Ctx { frame, ..(*self.ctx).clone() });
        }
    }
}
