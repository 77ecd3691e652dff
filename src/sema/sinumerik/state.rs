//! Modal state of a run. Written here and by the statements, sampled by every item.

use std::collections::BTreeMap;
use std::rc::Rc;

use crate::diag::{Diagnostic, codes};
use crate::geo::{Plane, Point2};
use crate::ir::contour::{Ctx, CtxRef};
use crate::ir::{Feed, Side};
use crate::machine::{Axis, AxisSet, MachineKind, Settings, Unit};
use crate::sema::common::position::Position;
use crate::sema::common::start::Start;

use super::Run;
use super::frames::FrameValue;
use super::g_groups::{ActiveCodes, Code, Group};
use super::offsets::{FromBasic, Outer};
use crate::sema::run::Where;

/// How values of the diameter axis count.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Diameter {
    Off,
    /// Absolute and incremental values are diameters.
    On,
    /// Absolute values are diameters, increments radii.
    Absolute,
}

/// Everything modal.
#[derive(Debug, Clone)]
pub(super) struct State {
    pub codes: ActiveCodes,
    pub geometry_axes: [Axis; 3],
    pub lathe: bool,
    pub ctx: CtxRef,
    /// The numbers last programmed count where a frame changed (SD 42440).
    pub position: Position,
    /// Rotary axes that count modulo 360 degrees: declared, or shown by DC, ACP or ACN.
    pub modulo: AxisSet,
    /// The way of the last block that travelled.
    pub heading: super::tangent::Heading,
    pub pole: Point2,
    /// The pole was set under an error.
    pub pole_lost: bool,
    pub ap: Option<f64>,
    pub rp: Option<f64>,
    /// F word in mm, with the kind of feed under which it was written.
    pub feed: Option<Feed>,
    pub feed_lost: bool,
    /// No block has said what F counts, and lathes differ in what it does at the start.
    pub feed_kind_open: bool,
    pub rndm: f64,
    pub frcm: Option<Feed>,
    pub speed: Option<f64>,
    /// Speed that was printed, within its limits.
    pub turns: Option<f64>,
    /// LIMS of the master spindle.
    pub speed_limit: Option<f64>,
    /// G26 S of the master spindle.
    pub highest_speed: Option<f64>,
    pub constant_cut: bool,
    /// G97 took the speed over that G96 had given, and no S has named one since.
    pub speed_kept: bool,
    /// Sense of rotation of the master spindle, while it turns.
    pub turn: Option<crate::ir::function::Turn>,
    /// Where the master spindle was stopped by SPOS, degrees.
    pub spindle_angle: Option<f64>,
    /// Master spindle.
    pub master: u8,
    /// What the spindles that are not the master were told.
    pub spindles: BTreeMap<u8, SpindleState>,
    pub programmable: FrameValue,
    /// Work offsets that the program wrote, by number (0 is G500).
    pub written: BTreeMap<u8, FrameValue>,
    /// The work offset in force, where the program wrote it.
    pub settable: Option<FrameValue>,
    /// Number of the work offset in force.
    pub offset: u8,
    /// The program selected offsets of the machine, and offsets that it wrote.
    pub offsets_printed: bool,
    pub offsets_resolved: bool,
    /// What printed positions count from.
    pub outer: Outer,
    /// G500 was programmed while nothing else was.
    pub under_g500: bool,
    pub moved_from_basic: FromBasic,
    /// A move in machine coordinates was printed.
    pub machine_moved: bool,
    pub diameter: Option<Diameter>,
    pub tool: Tool,
    pub basic_unit: Unit,
}

/// The spindle that the target turns when no number is said, and the master of the control at the start.
pub(super) const MAIN_SPINDLE: u8 = 1;

/// What a spindle was told while another one is the master.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct SpindleState {
    pub speed: Option<f64>,
    pub turn: Option<crate::ir::function::Turn>,
    pub limit: Option<f64>,
    pub highest: Option<f64>,
    /// It was stopped under G96 and has got no speed since.
    pub kept: bool,
}

/// The tool in use.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Tool {
    /// In the spindle or turret.
    pub active: Option<u32>,
    /// Chosen by T, not yet changed.
    pub next: Option<u32>,
    /// Edge (D number).
    pub edge: Option<u32>,
    /// D that was programmed between T and M6, and the doubt behind M6 whether it counts (MD 20270).
    pub edge_before_change: Option<u32>,
    pub edge_in_doubt: bool,
    pub lost: bool,
}

/// What SAVE brings back.
#[derive(Debug, Clone)]
pub(super) struct Saved {
    codes: ActiveCodes,
    programmable: FrameValue,
    settable: Option<FrameValue>,
}

impl State {
    pub fn new(settings: &Settings) -> State {
        let codes = ActiveCodes::at_start(settings);
        let machine = &settings.machine;
        let lathe = machine.kind == MachineKind::Lathe;
        let basic_unit = settings.control.unit.unwrap_or_default();
        let feed_at_start = settings.control.siemens.feed_per_revolution;
        let plane = if lathe { Plane::Zx } else { Plane::Xy };
        let start = Start::new(settings, codes.is(Code::DIAMON));
        State {
            codes,
            geometry_axes: machine.geometry_axes,
            lathe,
            ctx: Rc::new(Ctx { plane, ..Ctx::default() }),
            position: Position::new(start),
            modulo: machine.modulo,
            heading: super::tangent::Heading::None,
            pole: Point2::origin(),
            pole_lost: false,
            ap: None,
            rp: None,
            feed: settings.control.feed.map(Feed::PerMinute),
            feed_lost: false,
            rndm: 0.0,
            frcm: None,
            speed: None,
            turns: None,
            speed_limit: None,
            highest_speed: None,
            feed_kind_open: lathe && feed_at_start.is_none(),
            constant_cut: false,
            speed_kept: false,
            turn: None,
            spindle_angle: None,
            master: MAIN_SPINDLE,
            spindles: BTreeMap::new(),
            programmable: FrameValue::default(),
            written: BTreeMap::new(),
            settable: None,
            offset: 0,
            offsets_printed: false,
            offsets_resolved: false,
            outer: Outer::Basic,
            under_g500: false,
            moved_from_basic: FromBasic::None,
            machine_moved: false,
            diameter: None,
            tool: Tool::default(),
            basic_unit,
        }
    }

    pub fn is(&self, code: Code) -> bool {
        self.codes.is(code)
    }

    /// Under G500 beside offsets of the machine.
    pub fn in_machine(&self) -> bool {
        matches!(self.outer, Outer::Machine | Outer::Unrelated)
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
        self.codes.feed_unit(self.basic_unit)
    }

    /// Does F count per revolution?
    pub fn per_revolution(&self) -> bool {
        self.codes.per_revolution()
    }

    /// Does a feed count as the kind of feed in force?
    pub fn counts_as(&self, feed: Feed) -> bool {
        match feed {
            Feed::PerRevolution(_) => self.per_revolution(),
            Feed::InverseTime(_) => self.is(Code::G93),
            Feed::PerMinute(_) => !self.per_revolution() && !self.is(Code::G93),
        }
    }

    pub fn side(&self) -> Side {
        match self.codes.of(Group::Compensation) {
            Code::G41 => Side::Left,
            Code::G42 => Side::Right,
            _ => Side::None,
        }
    }

    pub fn diameter_mode(&self) -> Diameter {
        self.diameter.unwrap_or(match self.codes.of(Group::Diameter) {
            Code::DIAMON => Diameter::On,
            Code::DIAM90 => Diameter::Absolute,
            _ => Diameter::Off,
        })
    }

    /// Axes of the working plane and the one at a right angle to it.
    pub fn roles(&self) -> [Axis; 3] {
        let (first, second, third) = self.plane().axes();
        [Axis::ALL[first], Axis::ALL[second], Axis::ALL[third]]
    }
}

impl Run<'_> {
    pub(super) fn save(&self) -> Saved {
        Saved { codes: self.st.codes, programmable: self.st.programmable.clone(), settable: self.st.settable.clone() }
    }

    pub(super) fn restore(&mut self, saved: Saved) {
        let changed = self.st.codes.of(Group::FeedType) != saved.codes.of(Group::FeedType);
        let (offset, plane) = (self.st.codes.of(Group::WorkOffset), saved.codes.of(Group::Plane));
        self.st.codes = saved.codes;
        self.st.programmable = saved.programmable;
        self.set_plane(plane);
        if !self.st.is(offset) {
            // The work offset of the call comes back, whatever MD 10617 says.
            let _: super::Outcome = self.work_offset(self.st.codes.of(Group::WorkOffset).index, Where::Block);
        } else if self.st.settable != saved.settable {
            self.restore_offset_frame(saved.settable);
        }
        self.refresh_frame();
        if changed {
            self.feed_mode_changed();
        }
    }

    /// The same work offset is in force, with another frame than at the call: bit 0 of MD 10617 decides.
    fn restore_offset_frame(&mut self, frame: Option<FrameValue>) {
        let chosen = self.job.settings.control.siemens.save_restores_offset;
        if chosen == Some(true) {
            self.st.settable = frame;
        } else if chosen.is_none() {
            let message =
                "the program with SAVE changed the frame of the work offset; it stays changed (MD 10617, bit 0 = 0)";
            let found = Diagnostic::new(codes::S9018, self.here.origin.loc, message);
            self.report(found.help("set `[control] md10617`, or select the offset again in the calling program"));
        }
    }

    /// The context with the plane of group 6.
    pub(super) fn set_plane(&mut self, code: Code) {
        let (i, j) = match code {
            Code::G18 => (2, 0),
            Code::G19 => (1, 2),
            _ => (0, 1),
        };
        let axes = self.st.geometry_axes;
        let fits = |plane: &Plane| {
            let (first, second, _) = plane.axes();
            (Axis::ALL[first], Axis::ALL[second]) == (axes[i], axes[j])
        };
        let plane = [Plane::Xy, Plane::Zx, Plane::Yz].into_iter().find(fits).unwrap_or(self.st.ctx.plane);
        if plane != self.st.ctx.plane {
            self.st.ctx = Rc::new(Ctx { plane, frame: self.st.ctx.frame.clone() });
            self.st.ap = None;
            self.st.pole = Point2::origin();
        }
    }

    /// Makes the context fit the frames; the tool stays where it is.
    pub(super) fn refresh_frame(&mut self) {
        let total = match &self.st.settable {
            Some(outer) => outer.chain(&self.st.programmable),
            None => self.st.programmable.clone(),
        };
        let Some(frame) = total.map() else {
            self.st.position.lose(AxisSet::ALL);
            self.st.programmable = FrameValue::default();
            let _: super::Outcome = self.fail(
                codes::S2034,
                Where::Block,
                "the frame cannot be used: a factor or a shift is zero or out of all range",
            );
            return;
        };
        if frame != self.st.ctx.frame {
            self.st.heading = self.heading_across_frames(frame.linear() != self.st.ctx.frame.linear());
            self.st.position.keep_programmed();
            self.st.position.through_frame(&self.st.ctx.frame, &frame);
            self.st.ctx = Rc::new(Ctx { plane: self.st.ctx.plane, frame });
        }
    }
}
