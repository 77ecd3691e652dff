//! What a plan makes of a call, and what all plans ask.

use crate::diag::{Answer, Fault, codes};
use crate::geo::{Plane, Point2};
use crate::ir::Feed;
use crate::ir::cycle::Cycle;
use crate::ir::function::{Spindle, Turn};
use crate::machine::{Axis, MachineKind};
use crate::sema::cycle::call::{Call, Kind, Made, Refusal, Says};
use crate::sema::cycle::given::{Breach, Given};
use crate::sema::cycle::row::{Name, Rule};
use crate::sema::run::Where;

use super::super::diameter::Diameter;
use super::super::g_groups::Group;
use super::super::spindle_state::MAIN_SPINDLE;
use super::super::state::State;
use super::names::{AMODE, DMODE, GMODE};
use super::table::{Cycle as Row, Need};

/// A call of a cycle while it is planned.
pub(in super::super) type CycleCall<'c> = Call<'c, State>;

/// What is carried out, in this order.
pub(in super::super) type Acts = Vec<Act>;

/// A part of what a call does.
#[derive(Debug)]
pub(in super::super) enum Act {
    Cycle(Cycle),
    /// A cycle that begins at a place to which the tool goes first, for nobody knows where it stands.
    From(Point2, Cycle),
    /// Goes to each place and runs the modal cycle there.
    Drill(Vec<Point2>),
    /// The cycle told the spindle something that holds on.
    Spindle(SpindleTold),
}

/// What a call tells the spindle.
#[derive(Debug, Default)]
pub(in super::super) struct SpindleTold {
    pub speed: Option<Spindle>,
    pub turn: Option<Turn>,
    /// Fixed turns from a place of the path on.
    pub reduced: Option<f64>,
}

impl Says for State {
    fn breach(&self, given: &Given, at: usize, breach: Breach) -> Fault {
        let (place, called) = (at + 1, &given.called);
        let Some(parameter) = given.signature.parameters.get(at) else {
            return codes::P2090::argument_of_is_out_of_all_range(called);
        };
        let (name, meaning) = (&parameter.name, &parameter.what);
        let fault = match breach {
            Breach::NoNumber => return codes::P2090::argument_of_has_to_be_number(&place, called),
            Breach::NoText => return codes::P2090::argument_of_has_to_be_text(&place, called),
            Breach::OutOfAllRange => return codes::P2090::argument_of_is_out_of_all_range(called),
            Breach::NoDigits(coded) => codes::P2090::argument_is_code_of_digits(&place, &coded),
            Breach::Missing if parameter.rule == Rule::Size => {
                codes::P2090::argument_is_missing(name, &place, meaning).alarm(61118).help("give a size above 0")
            }
            Breach::Missing => codes::P2090::argument_is_missing(name, &place, meaning),
            Breach::Negative(value) => codes::P2090::argument_takes_no_sign(name, &place, meaning, &value),
            Breach::NotAboveZero(value, alarm) => {
                codes::P2090::argument_is_not_above_zero(name, &place, meaning, &value)
                    .alarm(Some(alarm).filter(|alarm| *alarm > 0))
            }
            Breach::Zero => codes::P2090::argument_size_is_zero(name, &place, meaning),
            Breach::NotBelow90(value) => codes::P2090::argument_is_not_below_90(name, &place, meaning, &value),
            Breach::NoneOf(value, range) => codes::P2090::argument_is_none_of(name, &place, meaning, &value, &range),
        };
        // What helps against a wrong sign does not help where nothing is given.
        let own = breach != Breach::Missing || parameter.rule != Rule::Unsigned;
        let fault = if own && parameter.alarm > 0 { fault.alarm(parameter.alarm) } else { fault };
        let fault = if own && !parameter.fix.is_empty() { fault.help(parameter.fix) } else { fault };
        fault.of(called)
    }
}

impl CycleCall<'_> {
    /// An argument that the call gives and the cycle does not use.
    pub(super) fn unused(&self, name: Name, why: &str) {
        let fault = codes::S8035::is_not_used(&self.given.called, &self.given.written(name), &why);
        self.note(self.given.place_of(name), fault, Kind::Each);
    }

    /// A variant that is known, but not built.
    pub(super) fn not_built<T>(&self, name: Name, what: &str) -> Made<T> {
        self.refuse_as_said(self.given.place_of(name), codes::S9015::is_not_supported(&self.given.called, &what))
    }

    /// Arguments that make no cycle of its family.
    pub(super) fn unsound<T>(
        &self,
        (name, alarm, help): (Name, u32, &'static str),
        fault: &dyn core::fmt::Display,
    ) -> Made<T> {
        let (written, place) = (self.given.written(name), self.given.argument(name));
        let fault = codes::P2090::family_refuses(&fault, &written, &place).help(help);
        self.refuse_argument(name, if alarm == 0 { fault } else { fault.alarm(alarm) })
    }

    /// The same, of the call as a whole.
    pub(super) fn unsound_call<T>(
        &self,
        alarm: impl Into<Option<u32>>,
        fault: &dyn core::fmt::Display,
        help: &'static str,
    ) -> Made<T> {
        self.refuse(codes::P2090::call_makes_no_cycle(&fault).help(help).alarm(alarm))
    }

    /// The feed in force, for a cycle.
    pub(super) fn cycle_feed(&self) -> Made<Feed> {
        if self.st.feed.is_lost() {
            return Err(Refusal::Known);
        }
        match self.st.feed.word() {
            Some(feed) => {
                self.takes_modal_feed.set(true);
                Ok(feed)
            }
            None => self.refuse_as_said(self.given.place, codes::P2002::cycle_has_no_feed()),
        }
    }

    /// Does `_DMODE` name another plane than the active one?
    pub(super) fn names_other_plane(&self) -> bool {
        let plane = self.given.digit(DMODE, 0);
        plane != 0 && plane != i32::from(self.st.codes.of(Group::Plane).index)
    }

    pub(super) fn is_diameter_axis(&self, axis: Axis) -> bool {
        self.settings.machine.diameter_axis == Some(axis)
    }

    /// The cycles program their axes as any block does, so that lengths along X are diameters under DIAMON in some versions
    /// and radii in others.
    pub(in super::super) fn no_diameters(&self, axis: Axis, place: Where) -> Made {
        if !self.is_diameter_axis(axis) || self.st.diameter_mode() == Diameter::Off {
            return Ok(());
        }
        self.refuse_as_said(
            place,
            codes::S9015::whether_its_lengths_along_are_diameters_under(&self.given.called, &axis.letter()),
        )
    }

    /// Tool and edge whose data the cycle works with.
    pub(super) fn active_edge(&self) -> Made<(u32, u32)> {
        let tool = &self.st.tool;
        let Some(number) = tool.active().filter(|number| *number != 0) else {
            let change = if self.st.machine.lathe { "T1 D1" } else { "T1 M6" };
            return self.refuse(codes::P2090::no_tool_is_active(&change));
        };
        if tool.is_without_offset() {
            return self.refuse(codes::P2090::no_tool_offset_is_active());
        }
        let edge = tool.edge_or_first();
        if tool.is_rewritten() {
            return self.refuse_as_said(self.given.place, codes::P9013::data_of_t_d_were_written_after(&number, &edge));
        }
        Ok((number, edge))
    }

    /// The radius of the active edge with its wear.
    pub(super) fn known_radius(&self) -> Option<f64> {
        self.st.known_radius(self.settings)
    }

    /// What the spindle drives has to follow the main one.
    pub(super) fn master_is_main(&self, place: Where, what: &str) -> Made {
        let master = self.st.spindles.master();
        if master == MAIN_SPINDLE {
            return Ok(());
        }
        self.refuse_as_said(place, codes::S9007::follows_spindle(&what, &master))
    }

    /// Seconds from a dwell that is negative for turns of the spindle.
    pub(super) fn dwell_of(&self, name: Name) -> Made<f64> {
        let value = self.given.or_zero(name);
        if value >= 0.0 { Ok(value) } else { self.spindle_turns_of(name, -value) }
    }

    /// Seconds that so many turns of the spindle take.
    pub(super) fn spindle_turns_of(&self, name: Name, turns: f64) -> Made<f64> {
        if turns == 0.0 {
            return Ok(0.0);
        }
        match self.st.spindles.speed().filter(|speed| *speed > 0.0 && !self.st.spindles.is_cutting()) {
            Some(speed) => Ok(turns * 60.0 / speed),
            None => self.refuse_argument(name, codes::P2090::dwell_in_turns_needs_fixed_spindle_speed()),
        }
    }

    /// Where the tool stands in the turning plane: Z and the radius. What was refused in front of the cycle is not worth a second error.
    pub(super) fn turning_position(&self) -> Made<Option<Point2>> {
        let at = self.st.position.in_plane(Plane::Zx);
        if at.is_none() && [Axis::X, Axis::Z].into_iter().any(|axis| self.st.position.is_lost(axis)) {
            return Err(Refusal::Known);
        }
        Ok(at)
    }

    /// A cycle that begins where the tool stands, made for that place. Where it is not known the tool goes to `front` first, in one rapid
    /// move of both axes as to the start of CYCLE951, and comes back there.
    pub(super) fn begins_at(&self, front: Point2, made: impl FnOnce(Point2) -> Cycle) -> Made<Acts> {
        Ok(vec![match self.turning_position()? {
            Some(at) => Act::Cycle(made(at)),
            None => {
                let fault = codes::S8164::where_tool_stands_is_not_known(&self.given.called);
                self.note(self.given.place, fault, Kind::Each);
                Act::From(front, made(front))
            }
        }])
    }

    /// What the row asks of the channel, in its order, and of the coded arguments.
    pub(in super::super) fn meets_row(&self, row: &Row) -> Made {
        for need in row.needs {
            self.meets(*need)?;
        }
        self.digits_of_are_known(GMODE)?;
        self.digits_of_are_known(AMODE)
    }

    /// Does the channel have what a row asks for?
    fn meets(&self, need: Need) -> Made {
        let (given, st) = (self.given, self.st);
        match need {
            Need::Lathe if self.settings.machine.kind != MachineKind::Lathe => {
                let lathe = Answer::key("machine", "kind").one_of(&["\"lathe\""]);
                self.refuse(codes::P2090::cycle_needs_turning_technology().answer(lathe))
            }
            Need::TurningPlane if st.plane() != Plane::Zx => self.refuse(codes::P2090::turning_cycles_work_in_g18()),
            Need::DiameterAxis => {
                let [first, second, _] = st.roles();
                if [first, second].iter().any(|axis| self.is_diameter_axis(*axis)) {
                    return Ok(());
                }
                let axis = Answer::key("machine", "diameter_axis");
                self.refuse(codes::P2090::machine_datum_20100_names_no_axis().answer(axis))
            }
            Need::ActivePlane if self.names_other_plane() => {
                self.refuse_argument(DMODE, codes::S9015::plane_other_than_active_one())
            }
            Need::NoNormalOffset => self.no_normal_offset(),
            Need::UnscaledFrame => self.frame_is_not_scaled(),
            Need::ShiftFrame if !st.ctx.frame.is_shift() => self.refuse_as_said(
                given.place,
                codes::S9015::under_mirrored_or_turned_frame_programmed_corner(&given.called),
            ),
            Need::FixedSpeed if st.spindles.is_cutting() => {
                self.refuse(codes::P2090::tapping_under_constant_cutting_speed())
            }
            Need::MainSpindle(what) => self.master_is_main(given.place, what),
            Need::TurningSpindle if st.spindles.turn().is_none() => {
                self.refuse(codes::P2090::spindle_does_not_turn_so_program_m3())
            }
            Need::ModalCall if st.modal_call.is_lost() => Err(Refusal::Known),
            Need::ModalCall if !st.modal_call.is_on() => self.refuse(codes::P2090::no_drilling_cycle_is_active()),
            Need::PlainLengths => {
                let [first, second, _] = st.roles();
                self.no_diameters(first, given.place)?;
                self.no_diameters(second, given.place)
            }
            // A place is asked of the channel, which knows what hid it.
            _ => Ok(()),
        }
    }

    /// Cycles whose path does not count OFFN refuse it: the control selects compensation in them, with the radius that OFFN enlarges.
    fn no_normal_offset(&self) -> Made {
        let normal = self.st.path.normal() / self.st.length_unit();
        if normal == 0.0 {
            return Ok(());
        }
        self.refuse_as_said(self.given.place, codes::S9015::offn_is_in_force(&self.given.called, &normal))
    }

    /// Mirrors and rotations are allowed: the shape is turned with its frame.
    pub(super) fn frame_is_not_scaled(&self) -> Made {
        if self.st.ctx.frame.is_unscaled() {
            return Ok(());
        }
        self.refuse(codes::P2090::scaling_is_active())
    }
}
