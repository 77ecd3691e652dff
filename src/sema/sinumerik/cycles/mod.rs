//! Machining cycles of the control: their parameters become the arguments of `ir::cycle`.
//!
//! Source: C 5 and 6 (docs/sources.md).

mod alarms;
mod arguments;
mod call;
mod called_contours;
mod contour_pocket;
mod contour_removal;
mod corner_removal;
mod cut_off;
mod drilling;
mod drilling_zones;
mod faces;
mod groove_shape;
mod grooves;
mod layers;
mod milling;
mod modes;
mod path_milling;
mod pattern;
mod pockets;
mod spigots;
mod table;
mod thread;
mod thread_milling;
mod undercut;
mod undercut_call;
mod unknown_start;

use std::rc::Rc;

use crate::diag::{Code, Fault, Help, codes};
use crate::geo::{Plane, Point2};
use crate::ir::contour::Ctx;
use crate::ir::cycle::drilling::Method;
use crate::ir::cycle::{Cycle, Drilling};
use crate::ir::function::{Spindle, Turn};
use crate::ir::{Feed, Pos, Side};
use crate::machine::{Axis, AxisSet};
use crate::parser::sinumerik::ast::{Args, Block, Formula};
use crate::sema::cycle::row::Kind;
use crate::text::Span;

use super::diameter::Diameter;
use super::g_groups::Group;
use super::offsets::Outer;
use super::value::Val;
use super::words::CallWord;
use super::{Channel, Outcome, Reported, Run};
use crate::sema::run::{Site, Where};

pub(super) use alarms::meaning as alarm_meaning;
pub(super) use called_contours::{ContourCall, Contours, MOST_ELEMENTS};
pub(super) use table::instead;
pub use table::signatures;
pub(super) use table::{find, rows};

use arguments::{Arguments, DMODE, Key};
use call::CycleCall;
use table::{Cycle as Row, Work};

/// A drilling cycle that runs behind every positioning block.
#[derive(Debug, Clone)]
pub(super) struct ModalCycle {
    hole: Drilling,
    args: Arguments,
    /// Where MCALL stands.
    here: Site,
    /// The spindle as the hole was made of it: a dwell in turns, a tap and a feed of its own depend on it.
    spindle: SpindleState,
    /// The feed is the one that is modal when the hole is drilled.
    feed_of_block: bool,
    /// Plane and unit of the call: the axis and the lengths of the hole were taken under them.
    under: (Plane, f64),
    /// Why it cannot be drilled was reported.
    refused: bool,
}

/// What holes take from the spindle: speed, sense, whether the speed follows the diameter, whether feeds count per turn; and
/// the tool and its edge, whose tip a depth may count for.
type SpindleState = (Option<f64>, Option<Turn>, bool, bool, Option<u32>, Option<u32>);

impl ModalCycle {
    /// Why it cannot be drilled was reported.
    pub fn refuse(&mut self) {
        self.refused = true;
    }
}

impl Run<'_> {
    /// Runs a machining cycle; `None` for a name that is none, or that is not built.
    pub(super) fn machining_cycle(
        &mut self,
        name: &str,
        call: CallWord,
        block: &Block,
        text: &[u8],
    ) -> Option<Outcome> {
        let cycle = find(name)?;
        if matches!(cycle.work, Work::Nothing) || self.own_program(name) {
            return None;
        }
        let result =
            self.cycle_arguments(cycle, call.args, call.span, block, text).and_then(|args| self.run_cycle(&args));
        if result.is_err() {
            self.st.position.lose(AxisSet::ALL);
            self.lost();
        }
        Some(result)
    }

    fn cycle_arguments(
        &mut self,
        cycle: &'static Row,
        args: Option<Args>,
        span: Span,
        block: &Block,
        text: &[u8],
    ) -> Outcome<Arguments> {
        let name = cycle.signature.name;
        self.no_cycle_in_contour(name, span)?;
        let formulas: Vec<Formula> = args.map(|args| block.arguments(args).to_vec()).unwrap_or_default();
        let mut list = Vec::with_capacity(formulas.len());
        for formula in formulas {
            let value = self.eval(formula, block, text)?;
            list.push((value, formula.span));
        }
        let most = cycle.signature.parameters.len();
        if list.len() > most {
            let at = list.get(most).map_or(span, |(_, span)| *span);
            return self.refuse(at, codes::S2021::takes_arguments(&name, &most));
        }
        let args = Arguments { cycle, span, list };
        self.cycle(&args).check_values()?;
        Ok(args)
    }

    fn run_cycle(&mut self, args: &Arguments) -> Outcome {
        self.begins_executing();
        self.no_turning_cycle_here(args.name(), args.span)?;
        self.pending_must_be_done(args.span)?;
        if self.st.side() != Side::None {
            return self.cycle(args).refuse_cycle(args.span, codes::P2090::radius_compensation());
        }
        match self.st.offsets.outer() {
            Outer::Machine => {
                return self.in_machine_only_lines(args.span, "a cycle cannot be printed in machine coordinates");
            }
            Outer::Unrelated => return self.unrelated(args.span, "G500 stands beside"),
            // A contour that is only named moves nothing.
            Outer::Basic | Outer::Printed(_) if args.cycle.work.is_read_only() => {}
            Outer::Basic | Outer::Printed(_) => self.note_outer(),
        }
        self.no_cycle_by_time(args.span)?;
        if !args.cycle.work.is_read_only() {
            self.speed_is_known()?;
            if self.st.codes.per_revolution() {
                self.master_feeds(args.span);
            }
        }
        match &args.cycle.work {
            Work::Hole(cycle) => {
                let hole = self.cycle(args).hole(cycle)?;
                self.drill(&hole)
            }
            Work::Moves(run) => {
                let mut call = self.cycle(args);
                run(&mut call)?;
                call.say_remarks();
                Ok(())
            }
            Work::Contour(run) | Work::Along(run) => run(self, args),
            Work::Unpublished(cycle) => self.unpublished_cycle(args, cycle),
            Work::Nothing => Ok(()),
        }
    }

    /// `MCALL CYCLE81(…)`; `None` for a name that is no cycle.
    pub(super) fn modal_machining_cycle(
        &mut self,
        name: &str,
        args: Args,
        block: &Block,
        text: &[u8],
    ) -> Option<Outcome> {
        if let Some(cycle) = find(name)
            && let Work::Hole(drilling) = &cycle.work
            && !self.own_program(name)
        {
            let result = self.cycle_arguments(cycle, Some(args), block.span, block, text).and_then(|args| {
                self.st.modal_call.end();
                let hole = self.cycle(&args).hole(drilling)?;
                let feed_of_block = drilling.modal_feed;
                let under = (self.st.plane(), self.st.length_unit());
                let (here, spindle) = (self.here, self.spindle_state());
                let refused = false;
                let made = ModalCycle { hole, args, here, spindle, feed_of_block, under, refused };
                self.st.modal_call.set_cycle(Box::new(made));
                Ok(())
            });
            return Some(result);
        }
        None
    }
}

impl Channel<'_> {
    fn spindle_state(&self) -> SpindleState {
        let (spindles, tool) = (&self.st.spindles, &self.st.tool);
        let (speed, turn, cutting) = (spindles.speed(), spindles.turn(), spindles.is_cutting());
        (speed, turn, cutting, self.st.codes.per_revolution(), tool.active(), tool.edge())
    }

    /// Does `_DMODE` name another plane than the active one?
    fn names_other_plane(&self, args: &Arguments) -> bool {
        let plane = args.digit(DMODE, 0);
        plane != 0 && plane != i32::from(self.st.codes.of(Group::Plane).index)
    }

    fn length_of(&self, args: &Arguments, key: Key) -> Option<f64> {
        args.number(key).map(|value| value * self.st.length_unit())
    }

    fn moved_in_plane(&mut self, point: Point2) -> Pos {
        let mut end = Pos::UNKNOWN;
        end.set_in_plane(self.st.plane(), point);
        end
    }

    /// Drills the modal hole where the tool stands. Why it cannot is said once, and the tool goes on to the next place:
    /// the other places of a pattern are worth no other finding.
    pub(super) fn drill_modal(&mut self) -> Outcome {
        let Some(modal) = self.st.modal_call.cycle().filter(|modal| !modal.refused) else { return Ok(()) };
        let modal = Box::new(modal.clone());
        if self.drill_here(modal).is_err() {
            self.st.modal_call.refuse_cycle();
        }
        Ok(())
    }

    fn drill_here(&mut self, modal: Box<ModalCycle>) -> Outcome {
        self.no_cycle_by_time(Where::Block)?;
        self.speed_is_known()?;
        if self.st.codes.per_revolution() {
            self.master_feeds(Where::Block);
        }
        if modal.under != (self.st.plane(), self.st.length_unit()) {
            return self.refuse(Where::Block, codes::S9015::plane_or_unit_was_changed_since_mcall());
        }
        // The feeds of zones are shares of the one that is modal at each place.
        let zones = modal.args.has_zones();
        let feed_of_block = modal.feed_of_block && !zones;
        self.no_diameters(modal.args.name(), modal.hole.axis, Where::Block)?;
        let same = modal.spindle == self.spindle_state() && !zones;
        let mut hole = if same { modal.hole } else { self.hole_made_anew(modal)? };
        if feed_of_block && let Some(feed) = self.st.feed.word() {
            hole.feed = feed;
        }
        self.drill(&hole)
    }

    /// The hole of the modal call under the spindle of now.
    fn hole_made_anew(&mut self, mut modal: Box<ModalCycle>) -> Outcome<Drilling> {
        let here = std::mem::replace(&mut self.here, modal.here);
        let made = match &modal.args.cycle.work {
            Work::Hole(drilling) => self.cycle(&modal.args).hole(drilling),
            Work::Moves(_) | Work::Contour(_) | Work::Along(_) | Work::Unpublished(_) | Work::Nothing => Err(Reported),
        };
        self.here = here;
        let hole = made?;
        modal.hole = hole.clone();
        modal.spindle = self.spindle_state();
        self.st.modal_call.set_cycle(modal);
        Ok(hole)
    }

    fn no_cycle_by_time(&self, place: impl Into<Where>) -> Outcome {
        if !self.st.is(super::g_groups::GCode::G93) {
            return Ok(());
        }
        self.not_by_time(place, "the moves of a cycle have no share of the time that G93 gives the blocks")
    }

    /// In the plane across the hole, which may be another one than the active one.
    fn drill(&mut self, hole: &Drilling) -> Outcome {
        let plane = drilling::plane_across(hole.axis);
        let active = self.st.ctx.clone();
        if matches!(hole.method, Method::Bore(_)) && plane != active.plane {
            self.st.ctx = Rc::new(Ctx { plane, ..(*active).clone() });
        }
        self.send_cycle(Cycle::Drilling(hole.clone()));
        self.st.ctx = active;
        Ok(())
    }

    fn send_cycle(&mut self, cycle: Cycle) {
        if self.leaves_touched(AxisSet::of(self.st.roles()[2]), false).is_err() {
            return;
        }
        self.length_acts_along_z();
        self.cuts_in_between();
        let end = cycle.leaves(self.st.position.at());
        self.st.heading = super::tangent::Heading::Later;
        self.st.threads.end_chain();
        self.core.send_cycle(&cycle, &self.st.ctx);
        self.st.position.forget(self.st.position.at().known().without(end.known()));
        self.st.position.move_to(&end);
        if let Some(after) = cycle.spindle_after() {
            self.st.spindles.set_turn(match after {
                Spindle::Start(turn) => Some(turn),
                _ => None,
            });
        }
    }

    /// The cycles program their axes as any block does, so that lengths along X are diameters under DIAMON in some versions
    /// and radii in others.
    fn no_diameters(&self, name: &str, axis: Axis, place: impl Into<Where>) -> Outcome {
        if !self.is_diameter_axis(axis) || self.st.diameter_mode() == Diameter::Off {
            return Ok(());
        }
        self.refuse(place, codes::S9015::whether_its_lengths_along_are_diameters_under(&name, &axis.letter()))
    }

    /// Where the tool stands in the turning plane: Z and the radius.
    fn turning_position(&mut self, span: Span) -> Outcome<Point2> {
        let plane = crate::geo::Plane::Zx;
        match self.st.position.in_plane(plane) {
            Some(at) => Ok(at),
            None => {
                let axis = if self.st.position.get(Axis::X).is_none() { Axis::X } else { Axis::Z };
                self.unknown_axis(axis, span)
            }
        }
    }
}

impl CycleCall<'_, '_> {
    /// The feed in force, for a cycle.
    fn cycle_feed(&mut self) -> Outcome<Feed> {
        let args = self.args;
        self.speed_is_known()?;
        if self.st.feed.is_lost() {
            return Err(Reported);
        }
        match self.st.feed.word() {
            Some(feed) => {
                self.feed_kind_is_said();
                Ok(feed)
            }
            None => {
                self.st.feed.lose();
                self.refuse(args.span, codes::P2002::cycle_has_no_feed())
            }
        }
    }

    /// A length in mm that has to be there.
    fn needed_length(&self, key: Key, name: &str) -> Outcome<f64> {
        Ok(self.needed(key, name)? * self.st.length_unit())
    }

    /// Seconds from a dwell that is negative for turns of the spindle.
    fn dwell_of(&self, key: Key) -> Outcome<f64> {
        let args = self.args;
        let value = args.or_zero(key);
        if value >= 0.0 { Ok(value) } else { self.spindle_turns_of(key, -value) }
    }

    /// Seconds that so many turns of the spindle take.
    fn spindle_turns_of(&self, key: Key, turns: f64) -> Outcome<f64> {
        let args = self.args;
        if turns == 0.0 {
            return Ok(0.0);
        }
        match self.st.spindles.speed().filter(|speed| *speed > 0.0 && !self.st.spindles.is_cutting()) {
            Some(speed) => Ok(turns * 60.0 / speed),
            None => self.refuse_cycle(args.span_of(key), codes::P2090::dwell_in_turns_needs_fixed_spindle_speed()),
        }
    }

    /// Turning cycles work in G18.
    fn in_turning_plane(&self) -> Outcome {
        let args = self.args;
        if self.st.plane() == crate::geo::Plane::Zx {
            return Ok(());
        }
        self.refuse_cycle(args.span, codes::P2090::turning_cycles_work_in_g18())
    }

    fn check_values(&self) -> Outcome {
        let args = self.args;
        let name = args.name();
        // What a contour cycle takes is checked by the rules of its parameters.
        let kinds = !args.cycle.work.is_read_only();
        for ((place, parameter), (value, at)) in (1..).zip(args.cycle.signature.parameters).zip(&args.list) {
            let text = matches!(parameter.kind, Kind::Text | Kind::Either);
            if kinds && *value != Val::Missing && value.number().is_none() && !text {
                return self.refuse(*at, codes::P2090::argument_of_has_to_be_number(&place, &name));
            }
            // A number among the texts is a sign of a comma too many or too few.
            if kinds && matches!(parameter.kind, Kind::Text) && value.number().is_some_and(|v| v != 0.0) {
                return self.refuse(*at, codes::P2090::argument_of_has_to_be_text(&place, &name));
            }
            if value.number().is_some_and(|v| !v.is_finite() || v.abs() > 1e9) {
                return self.refuse(*at, codes::P2090::argument_of_is_out_of_all_range(&name));
            }
            if let Some(coded) = value.number()
                && kinds
                && matches!(parameter.kind, Kind::Digits(_))
                && (coded < 0.0 || coded.fract() != 0.0)
            {
                return self.refuse_cycle(*at, codes::P2090::argument_is_code_of_digits(&place, &coded));
            }
        }
        Ok(())
    }

    /// Refuses the call.
    fn refuse_cycle<T>(&self, place: Span, fault: Fault) -> Outcome<T> {
        self.refuse(place, fault.of(self.args.name()))
    }

    /// Refuses an argument of the call.
    fn refuse_argument<T>(&self, key: Key, fault: Fault) -> Outcome<T> {
        self.refuse_cycle(self.args.span_of(key), fault)
    }

    /// An argument is read in a way that is not confirmed.
    fn reads(&self, key: Key, fault: Fault) {
        self.say(self.args.span_of(key), fault.of(self.args.name()));
    }

    /// Refuses the arguments of a cycle.
    fn cycle_fault<T>(
        &self,
        span: Span,
        alarm: impl Into<Option<u32>>,
        what: &str,
        help: impl Into<Help>,
    ) -> Outcome<T> {
        let args = self.args;
        let code: &'static Code = codes::P2090;
        self.fail_help(code.alarm(alarm), span, format!("{}: {what}", args.name()), help)
    }

    /// A variant that is known, but not built.
    fn not_built<T>(&self, key: Key, what: &str) -> Outcome<T> {
        let args = self.args;
        self.refuse(args.span_of(key), codes::S9015::is_not_supported(&args.name(), &what))
    }

    /// An argument that the call gives and the cycle does not use.
    fn unused(&self, key: Key, name: &str, why: &str) {
        let args = self.args;
        self.report(codes::S8035::is_not_used(&args.name(), &name, &why).at(self.loc(args.span_of(key))));
    }

    /// A reading of an argument that is not confirmed.
    fn reading(&self, key: Key, what: &str) {
        let args = self.args;
        let found = codes::P8106::this_is_not_confirmed(&args.name(), &what).at(self.loc(args.span_of(key)));
        self.report(found.help("compare with what the machine does"));
    }

    /// A number that has to be there.
    fn needed(&self, key: Key, name: &str) -> Outcome<f64> {
        let args = self.args;
        match args.number(key) {
            Some(value) => Ok(value),
            None if args.value(key).is_some() => {
                self.refuse_cycle(args.span_of(key), codes::P2090::has_to_be_number(&name, &args.place(key)))
            }
            None => self.refuse_cycle(args.span, codes::P2090::is_missing_so_arguments(&name, &args.place(key))),
        }
    }
}

/// Is this the name of a cycle that is not refused where it stands? The next one takes what some of them say.
pub(super) fn is_taken(name: &str) -> bool {
    find(name).is_some_and(|cycle| cycle.is_built() || matches!(cycle.work, Work::Contour(_)))
}

/// Is this the name of a cycle of the control? Those are programs, the last ones of its search path: one of the user or of the machine
/// builder goes before.
pub(super) fn is_program(name: &str) -> bool {
    find(name).is_some() || name.starts_with("CYCLE")
}

/// Is this the name of a measuring cycle?
pub(super) fn measures(name: &str) -> bool {
    find(name).is_some_and(Row::measures)
}

/// Is this the name of a cycle that is compiled?
pub(super) fn is_built(name: &str) -> bool {
    find(name).is_some_and(Row::is_built)
}
