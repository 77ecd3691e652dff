//! Calls of machining cycles: arguments are read and held against their row, the row's plan runs, and what it made is carried out.
//!
//! The one place that reports what a plan refuses or remarks, and that changes the channel for it.

use std::rc::Rc;

use crate::diag::{Parts, codes};
use crate::geo::{Plane, Point2};
use crate::ir::Pos;
use crate::ir::contour::{Coords, Ctx, Path};
use crate::ir::cycle::drilling::{Method, Tap};
use crate::ir::cycle::{Cycle, Drilling};
use crate::ir::function::Spindle;
use crate::machine::Axis;
use crate::sema::cycle::call::{Elsewhere, Kind, Made, Refusal, Remark};
use crate::sema::cycle::given::Given;
use crate::sema::run::Where;

use super::cycles::{self, Act, Acts, Cycle as Row, CycleCall, SpindleTold, Work};
use super::g_groups::{ActiveCodes, GCode, Group};
use super::levels::FrameKind;
use super::modal_call::{ModalCycle, SpindleState};
use super::offsets::Outer;
use super::transformation::no_turning_cycle_here;
use super::vars::Argument;
use super::{Channel, Core, Outcome, Reported, State};
use crate::ir::Side;

impl Channel<'_> {
    /// Does nothing stand in the way of the cycle? Says what its path depends on.
    pub(super) fn takes_cycle(&mut self, row: &Row, given: &Given) -> Outcome {
        let place = given.place;
        let moves = !matches!(row.work, Work::NamesContour | Work::Unpublished(_));
        no_turning_cycle_here(&self.core, &self.st, row.signature.name, place)?;
        self.pending_must_be_done(place)?;
        if self.st.side() != Side::None {
            return self.core.refuse(place, codes::P2090::radius_compensation().of(&given.called));
        }
        match self.st.offsets.outer() {
            Outer::Machine => {
                let what = "a cycle cannot be printed in machine coordinates";
                return self.core.in_machine_only_lines(place, what);
            }
            Outer::Unrelated => return self.core.unrelated(place, "G500 stands beside"),
            // A contour that is only named moves nothing.
            Outer::Basic | Outer::Printed(_) if !moves => {}
            Outer::Basic | Outer::Printed(_) => self.st.offsets.note_move(&self.core),
        }
        self.st.codes.no_cycle_by_time(&self.core, place)?;
        if moves {
            self.speed_is_known()?;
            if self.st.codes.per_revolution() {
                self.st.master_feeds(&self.core, place);
            }
        }
        if matches!(row.work, Work::Hole(_)) { Ok(()) } else { self.asked(given, |call| call.meets_row(row)) }
    }
}

impl State {
    fn spindle_was_told(&mut self, told: &SpindleTold) {
        let printed = told.reduced.or(match told.speed {
            Some(Spindle::Speed(turns)) => Some(turns),
            _ => None,
        });
        if let Some(turns) = printed {
            self.spindles.set_turns(turns, turns);
            // The feed keeps its kind.
            match self.codes.of(Group::FeedType) {
                GCode::G96 => self.codes.activate(GCode::G97),
                GCode::G961 => self.codes.activate(GCode::G971),
                _ => {}
            }
        }
        if told.turn.is_some() {
            self.spindles.set_turn(told.turn);
        }
    }

    pub(super) fn spindle_state(&self) -> SpindleState {
        let (spindles, tool) = (&self.spindles, &self.tool);
        let (speed, turn, cutting) = (spindles.speed(), spindles.turn(), spindles.is_cutting());
        (speed, turn, cutting, self.codes.per_revolution(), tool.active(), tool.edge())
    }
}

impl ActiveCodes {
    fn no_cycle_by_time(&self, core: &Core<'_>, place: impl Into<Where>) -> Outcome {
        if !self.is(GCode::G93) {
            return Ok(());
        }
        core.refuse(place, codes::S9009::moves_of_cycle_have_no_share_of_time())
    }
}

impl Channel<'_> {
    /// After a block that moved: drills the modal cycle, or hands out the modal program, unless it is the one that moved.
    pub(super) fn runs_modally(&mut self) -> Outcome<Option<(usize, Vec<Argument>)>> {
        let is_modal = |kind: &FrameKind| matches!(kind, FrameKind::Program { modal: true, .. });
        let inside = self.core.levels.iter().any(|level| is_modal(&level.frame.kind));
        if !inside && self.st.modal_call.is_on() {
            self.st.pair.under_no_modal_call(&self.core, &mut self.st.position)?;
        }
        if self.st.modal_call.cycle().is_some() {
            self.tapping_ends();
            return if inside { Ok(None) } else { self.drill_modal().map(|()| None) };
        }
        let program = self.st.modal_call.program().filter(|_| !inside);
        Ok(program.map(|(unit, arguments)| (unit, arguments.to_vec())))
    }

    /// Runs a plan and carries out what it made.
    pub(super) fn run_plan(
        &mut self,
        row: &Row,
        given: &Given,
        plan: impl FnOnce(&CycleCall<'_>) -> Made<Acts>,
    ) -> Outcome {
        let (acts, ways) = self.planned(given, plan)?;
        if row.needs.contains(&cycles::Need::KnownPlace) {
            let at = |axis| self.st.position.get(axis);
            if let Some(axis) = [Axis::X, Axis::Z].into_iter().find(|axis| at(*axis).is_none()) {
                return self.st.unknown_axis(&self.core, axis, given.place);
            }
        }
        self.carry_out(acts)?;
        say_ways(&self.core, given, ways);
        Ok(())
    }

    /// Asks a plan that makes no path.
    pub(super) fn asked<T>(&mut self, given: &Given, plan: impl FnOnce(&CycleCall<'_>) -> Made<T>) -> Outcome<T> {
        self.planned(given, plan).map(|(made, _)| made)
    }

    /// What a plan makes, and what is to be said of its path. What it remarks of the call is said here.
    fn planned<T>(&mut self, given: &Given, plan: impl FnOnce(&CycleCall<'_>) -> Made<T>) -> Outcome<(T, Vec<Remark>)> {
        let call = CycleCall::new(given, &self.st, self.core.job.settings);
        let made = plan(&call);
        let takes_feed = call.takes_modal_feed.get();
        let elsewhere = call.elsewhere();
        let (ways, remarks): (Vec<_>, Vec<_>) =
            call.remarks().into_iter().partition(|remark| matches!(remark.kind, Kind::Way | Kind::Open));
        if takes_feed {
            self.st.feed.say_kind(&self.core);
        }
        say_remarks(&self.core, remarks);
        for Elsewhere { place, fault, call } in elsewhere {
            self.core.report(fault.at(place).also(self.core.loc(given.place), call));
        }
        match made {
            Ok(made) => Ok((made, ways)),
            Err(Refusal::Known) => Err(Reported),
            Err(Refusal::Fault(place, fault)) => {
                if fault.code() == codes::P2002 {
                    self.st.feed.lose();
                }
                self.core.refuse(place, fault)
            }
        }
    }

    /// The hole of a drilling cycle.
    pub(super) fn hole_of(&mut self, row: &Row, given: &Given) -> Outcome<Drilling> {
        let Work::Hole(drilling) = &row.work else { return Err(Reported) };
        self.asked(given, |call| call.meets_row(row))?;
        let hole = self.asked(given, |call| call.hole(drilling))?;
        if matches!(hole.method, Method::Tap(Tap { rigid: true, .. })) {
            self.st.spindles.forget_angle();
        }
        Ok(hole)
    }

    fn carry_out(&mut self, acts: Acts) -> Outcome {
        for act in acts {
            match act {
                Act::Cycle(cycle) => {
                    if matches!(&cycle, Cycle::Undercut(undercut) if undercut.compensated) {
                        self.select_cutter(self.core.block_span())?;
                    }
                    self.send_cycle(&cycle);
                }
                Act::From(front, cycle) => {
                    let end = in_plane(self.st.plane(), front);
                    self.send(&end, Path::Rapid);
                    self.send_cycle(&cycle);
                    // The control may end where it came from.
                    self.st.position.forget(end.known());
                }
                Act::Drill(places) => self.drill_pattern(&places)?,
                Act::Spindle(told) => self.st.spindle_was_told(&told),
            }
        }
        Ok(())
    }

    /// Goes to each position and runs the modal cycle there.
    fn drill_pattern(&mut self, places: &[Point2]) -> Outcome {
        // Computing them is work, too.
        self.core.budget.take(places.len() as u64 / 16);
        for place in places {
            self.core.goes_on()?;
            let end = in_plane(self.st.plane(), *place);
            self.send(&end, Path::Rapid);
            self.drill_modal()?;
        }
        Ok(())
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
        self.st.codes.no_cycle_by_time(&self.core, Where::Block)?;
        self.speed_is_known()?;
        if self.st.codes.per_revolution() {
            self.st.master_feeds(&self.core, Where::Block);
        }
        if modal.under != (self.st.plane(), self.st.length_unit()) {
            return self.core.refuse(Where::Block, codes::S9015::plane_or_unit_was_changed_since_mcall());
        }
        // The feeds of zones are shares of the one that is modal at each place.
        let zones = cycles::has_zones(&modal.given);
        let feed_of_block = modal.feed_of_block && !zones;
        let axis = modal.hole.axis;
        self.asked(&modal.given, |call| call.no_diameters(axis, Where::Block))?;
        let same = modal.spindle == self.st.spindle_state() && !zones;
        let mut hole = if same { modal.hole } else { self.hole_made_anew(modal)? };
        if feed_of_block && let Some(feed) = self.st.feed.word() {
            hole.feed = feed;
        }
        self.drill(&hole)
    }

    /// The hole of the modal call under the spindle of now.
    fn hole_made_anew(&mut self, mut modal: Box<ModalCycle>) -> Outcome<Drilling> {
        let here = std::mem::replace(&mut self.core.here, modal.here);
        let made =
            cycles::find(modal.given.signature.name).map_or(Err(Reported), |row| self.hole_of(row, &modal.given));
        self.core.here = here;
        let hole = made?;
        modal.hole = hole.clone();
        modal.spindle = self.st.spindle_state();
        self.st.modal_call.set_cycle(modal);
        Ok(hole)
    }

    /// In the plane across the hole, which may be another one than the active one.
    pub(super) fn drill(&mut self, hole: &Drilling) -> Outcome {
        let plane = cycles::plane_across(hole.axis);
        let active = self.st.ctx.clone();
        if matches!(hole.method, Method::Bore(_)) && plane != active.plane {
            self.st.ctx = Rc::new(Ctx { plane, ..(*active).clone() });
        }
        self.send_cycle(&Cycle::Drilling(hole.clone()));
        self.st.ctx = active;
        Ok(())
    }

    fn send_cycle(&mut self, cycle: &Cycle) {
        let [_, _, third] = self.st.roles();
        let mut along = Pos::UNKNOWN;
        along.set(third, 0.0);
        if self.leaves_touched(along.known(), false).is_err() || self.stands_right(&along, Coords::Frame).is_err() {
            return;
        }
        self.st.length_acts_along_z(&self.core);
        self.left.cuts(self.capture.is_some());
        let end = cycle.leaves(self.st.position.at());
        self.st.heading = super::tangent::Heading::Later;
        self.st.threads.end_chain();
        self.core.send_cycle(cycle, &self.st.ctx);
        self.st.position.forget(self.st.position.at().known().without(end.known()));
        self.st.position.move_to(&end);
        if let Some(after) = cycle.spindle_after() {
            self.st.spindles.set_turn(match after {
                Spindle::Start(turn) => Some(turn),
                _ => None,
            });
        }
    }
}

fn say_remarks(core: &Core<'_>, remarks: Vec<Remark>) {
    for Remark { place, fault, kind } in remarks {
        if kind == Kind::Once {
            core.say_once(place, fault);
            continue;
        }
        let found = fault.at(core.loc(place));
        if kind == Kind::Each || !core.job.diags.knows(&found) {
            core.report(found);
        }
    }
}

/// The ways of a call and what it leaves open in one note each, once for all calls of which the same holds.
fn say_ways(core: &Core<'_>, given: &Given, remarks: Vec<Remark>) {
    let (mut ways, mut open, mut helps) = (Vec::new(), Vec::new(), Vec::new());
    for Remark { fault, kind, .. } in remarks {
        if kind == Kind::Open {
            let Parts { message, help, .. } = fault.into_parts();
            open.push(message);
            helps.push(help.map(|help| help.text).unwrap_or_default());
        } else if ways.iter().all(|said| said != fault.message()) {
            ways.push(fault.into_parts().message);
        }
    }
    if !open.is_empty() {
        let fault = codes::S8230::call_leaves_open(&given.called, &open.join("; "));
        core.say_once(given.place, fault.help(helps.join("; ")));
    }
    if !ways.is_empty() {
        core.say_once(given.place, codes::P8101::ways_of_call(&given.called, &ways.join("; ")));
    }
}

fn in_plane(plane: Plane, point: Point2) -> Pos {
    let mut end = Pos::UNKNOWN;
    end.set_in_plane(plane, point);
    end
}
