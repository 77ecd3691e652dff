//! Geometry: from what was programmed to what the machine shall do.
//!
//! In: contour items. Out: motion items. Knows no dialect and no target. The passes, in order: [`arcs`] get centre and sweep, [`corner`]s are cut (one element of
//! look-ahead), [`frames`] map to workpiece coordinates, the radius of the tool is compensated ([`compensation`]),
//! other axes than the program sees carry it out ([`machine_axes`], [`transformation`]), [`limits`] are checked.

#![cfg_attr(not(test), warn(clippy::wildcard_enum_match_arm))]

pub mod arcs;
pub mod capture;
mod claimed;
pub mod compensation;
pub mod corner;
pub mod cycles;
pub mod frames;
pub mod limits;
pub mod machine_axes;
pub mod step;
mod tap;
mod tilt;
pub mod transformation;
pub mod undercut;

use std::rc::Rc;

use crate::diag::{Diagnostic, Diags, Fault, codes};
use crate::geo::{Element, Vec2};
use crate::ir::captured::{Captured, Unfit};
use crate::ir::contour::{self, Coords, Corner, CtxRef, Load, Sink};
use crate::ir::cycle::Cycle;
use crate::ir::{Function, Origin, Pos, Side, Tap, Transformation, motion, verify};
use crate::machine::{Axis, AxisSet, Machine};

use arcs::{Adjusted, Extra, LastDirection};
use capture::{Recording, SavedPasses};
use compensation::Compensator;
use corner::Corners;
use cycles::no_path::NoPath;
use machine_axes::{MachineAxes, Out};
use step::{Checked, Event, Step};
use transformation::Transformer;

/// Moves that an arc counts as: its centre and its printed numbers take as long.
const ARC: u64 = 3;
/// Moves that each whole turn of an arc counts as: most targets get it in parts.
const TURN: u64 = 8;
/// Moves that a cycle without a path counts as: its depths may have been computed up to the fault.
const REFUSED: u64 = 500;

/// The passes of one run, from contour items to `out`.
pub struct Lower<'a> {
    diags: &'a Diags,
    machine: &'a Machine,
    out: &'a mut dyn motion::Sink,
    /// Programmed position in the frame of `ctx`.
    at: Pos,
    ctx: CtxRef,
    last: LastDirection,
    adjusted: Adjusted,
    corners: Corners,
    /// What the steps behind the corners led to, for their check.
    chain: Checked,
    compensator: Compensator,
    machine_axes: MachineAxes,
    /// A contour that is described now.
    recording: Option<Box<Recording>>,
    /// Where axes stand that did not move yet, as the configuration says; in the work offset in force.
    start: Pos,
    /// Axes that stand where the configuration says, and have not moved since.
    claimed: AxisSet,
    /// Is the tool clear of the part?
    clear: tilt::Clear,
    /// Moves taken so far.
    moves: u64,
    /// The last cycle that made no path, which was reported: a modal one comes again at each place.
    refused: Option<Box<Cycle>>,
    /// The last area in which a cutter found no path, which was reported.
    no_path: Option<Box<NoPath>>,
}

impl std::fmt::Debug for Lower<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Lower").field("at", &self.at).finish_non_exhaustive()
    }
}

impl<'a> Lower<'a> {
    pub fn new(diags: &'a Diags, machine: &'a Machine, out: &'a mut dyn motion::Sink) -> Lower<'a> {
        Lower {
            diags,
            machine,
            out,
            at: Pos::UNKNOWN,
            ctx: CtxRef::default(),
            last: LastDirection::default(),
            adjusted: Adjusted::default(),
            corners: Corners::default(),
            chain: Checked::default(),
            compensator: Compensator::default(),
            machine_axes: MachineAxes::default(),
            recording: None,
            start: Pos::UNKNOWN,
            claimed: AxisSet::EMPTY,
            clear: tilt::Clear::default(),
            moves: 0,
            refused: None,
            no_path: None,
        }
    }

    /// Everything was sent: what is held back goes out.
    pub fn finish(mut self) {
        self.flush();
        let (compensator, mut out) = self.compensator();
        compensator.finish(&mut out);
        self.adjusted.report(self.diags);
    }

    fn flush(&mut self) {
        let (corners, mut finish) = self.split();
        corners.flush(finish.diags, &mut |event| finish.event(event));
    }

    /// The same after an error: that a corner has lost its neighbour is not worth another one.
    fn abandon(&mut self) {
        let (corners, mut finish) = self.split();
        corners.abandon(&mut |event| finish.event(event));
    }

    fn split(&mut self) -> (&mut Corners, Finish<'_>) {
        let out = Out {
            diags: self.diags,
            machine: self.machine,
            sink: &mut *self.out,
            machine_axes: &mut self.machine_axes,
        };
        let recording = self.recording.as_deref_mut();
        let (chain, compensator) = (&mut self.chain, &mut self.compensator);
        (&mut self.corners, Finish { diags: self.diags, out, chain, compensator, recording })
    }

    fn compensator(&mut self) -> (&mut Compensator, Out<'_>) {
        let out = Out {
            diags: self.diags,
            machine: self.machine,
            sink: &mut *self.out,
            machine_axes: &mut self.machine_axes,
        };
        (&mut self.compensator, out)
    }

    /// The frame changed: the tool stays, its programmed position does not.
    #[cold]
    fn enter_frame(&mut self, ctx: &CtxRef, origin: &Origin) {
        if self.ctx.frame != ctx.frame {
            let workpiece = self.ctx.frame.apply(&self.at);
            self.at = ctx.frame.unapply(&workpiece);
            self.last.forget();
            self.rotary_stays(ctx, origin);
        }
        self.ctx = Rc::clone(ctx);
    }

    #[inline(always)]
    fn path_element(&mut self, mv: &contour::Move, origin: &Origin) {
        let step = self.corners.slot();
        if !Rc::ptr_eq(&step.ctx, &self.ctx) {
            step.ctx = Rc::clone(&self.ctx);
        }
        step.start = self.at;
        step.origin = *origin;
        step.mv.side = mv.side;
        step.mv.plane = self.ctx.plane;
        step.mv.machine = mv.coords == Coords::Machine;
        let programmed = &mv.end;
        step.mv.axes = programmed.known();
        if !self.start.known().is_empty() {
            step.mv.axes.iter().for_each(|axis| self.start.forget(axis));
        }
        if step.mv.machine {
            return self.machine_element(mv);
        }
        if let Some(path) = arcs::straight(&mv.path) {
            self.at.update(programmed);
            step.mv.end = self.at;
            step.mv.path = path;
            self.last.follow(step);
            return self.push();
        }
        self.bent_element(mv, origin);
    }

    /// The rest of [`Lower::path_element`] in machine coordinates.
    #[cold]
    fn machine_element(&mut self, mv: &contour::Move) {
        let step = self.corners.slot();
        step.mv.path = match mv.path {
            contour::Path::Rapid => motion::Path::Rapid,
            contour::Path::Line(feed) | contour::Path::Arc(_, feed) => motion::Path::Line(feed),
            contour::Path::Thread(thread) => motion::Path::Thread { lead: thread.lead },
        };
        step.mv.end = mv.end;
        // Every programmed coordinate that depends on the axes that moved is unknown now.
        let mut workpiece = self.ctx.frame.apply(&self.at);
        let tilted = self.machine_axes.tilted && !mv.end.known().common(AxisSet::MAIN).is_empty();
        let beside = if tilted { AxisSet::MAIN } else { AxisSet::EMPTY };
        for axis in mv.end.known().union(beside).iter() {
            workpiece.forget(axis);
        }
        self.at = self.ctx.frame.unapply(&workpiece);
        self.last.forget();
        self.push();
    }

    /// The rest of [`Lower::path_element`] for what is more than a straight line.
    #[inline(never)]
    fn bent_element(&mut self, mv: &contour::Move, origin: &Origin) {
        let step = self.corners.slot();
        step.mv.end = self.at;
        step.mv.end.update(&mv.end);
        match arcs::resolve(&mv.path, step, &self.last, &mut self.adjusted) {
            Ok(extra) => {
                if let Err(found) = step.is_exact(*origin) {
                    return self.refuse(Some(found), &mv.end, origin);
                }
                self.last.follow(step);
                self.at = step.mv.end;
                self.push();
                match extra {
                    Extra::None => {}
                    Extra::Word(word) => self.diags.push(*word),
                    Extra::Second(second) => {
                        self.at = second.mv.end;
                        *self.corners.slot() = *second;
                        self.push();
                    }
                }
            }
            Err(found) => {
                self.refuse(found, &mv.end, origin);
            }
        }
    }

    /// The element cannot be computed; the next ones start at its programmed end all the same.
    #[cold]
    fn refuse(&mut self, found: Option<Box<Diagnostic>>, programmed: &Pos, origin: &Origin) {
        self.abandon();
        if let Some(found) = found {
            self.diags.push(*found);
        }
        self.at.update(programmed);
        self.last.forget();
        self.position_lost(origin);
    }

    /// The moves do not say any more where the tool is.
    fn position_lost(&mut self, origin: &Origin) {
        self.chain.lost();
        if let Some(recording) = &mut self.recording {
            return recording.reported();
        }
        let (compensator, mut out) = self.compensator();
        compensator.lost(origin, &mut out);
    }

    /// Some functions change where the tool tip is in workpiece coordinates.
    fn displace(&mut self, function: &Function) {
        if let Function::WorkOffset(_) = function {
            self.at = match self.machine_axes.transformer {
                // What the start says is said of the axes of the machine.
                Some(_) => Pos::UNKNOWN,
                None => self.ctx.frame.unapply(&self.start),
            };
            self.last.forget();
        } else if let Function::ToolChange { .. } = function {
            self.claimed = AxisSet::EMPTY;
            // A tool of another length.
            let (_, _, third) = self.ctx.plane.axes();
            let axes = if self.machine_axes.tilted { AxisSet::MAIN } else { AxisSet::of(Axis::ALL[third]) };
            for axis in axes.iter() {
                self.at.forget(axis);
                self.start.forget(axis);
            }
            self.last.forget();
        }
    }

    /// The program sees other axes from here on.
    #[cold]
    fn transform(&mut self, by: Option<Transformation>, origin: &Origin) {
        self.flush();
        if !self.compensator.is_idle(Side::None) {
            self.diags.push(at(*origin, codes::G3204::transformation_begins_or_ends()));
            self.position_lost(origin);
        }
        let workpiece = self.ctx.frame.apply(&self.at);
        let mut real = match self.machine_axes.transformer.take() {
            Some(before) => {
                self.moves += before.parts;
                before.left()
            }
            None => workpiece,
        };
        if let Some(by) = by {
            let transformer = Transformer::new(by, &real);
            real = transformer.seen();
            for axis in [Axis::X, Axis::Y, by.rotary] {
                self.start.forget(axis);
            }
            self.machine_axes.transformer = Some(Box::new(transformer));
        }
        self.at = self.ctx.frame.unapply(&real);
        self.last.forget();
        self.chain.lost();
        let ctx = Rc::clone(&self.ctx);
        self.rotary_stays(&ctx, origin);
    }

    /// The zero of an axis that a transformation moves cannot be shifted.
    fn rotary_stays(&self, ctx: &CtxRef, origin: &Origin) {
        let Some(rotary) = self.machine_axes.transformer.as_ref().map(|transformer| transformer.rotary()) else {
            return;
        };
        if ctx.frame.shift_of(rotary) != 0.0 {
            self.diags.push(at(*origin, codes::G3339::frame_shifts(&rotary.letter())));
        }
    }

    #[inline(always)]
    fn push(&mut self) {
        if cfg!(debug_assertions) {
            self.corners.slot().check();
        }
        let beside = !self.compensator.is_idle(Side::None);
        let (corners, mut finish) = self.split();
        corners.push(beside, finish.diags, &mut |event| finish.event(event));
    }

    fn expand(&mut self, cycle: &Cycle, start: &Pos, ctx: &CtxRef, origin: &Origin) -> Result<bool, Box<Diagnostic>> {
        if cfg!(debug_assertions) {
            return cycles::expand(cycle, start, ctx, origin, &mut verify::Contour::standing(self, start, ctx));
        }
        cycles::expand(cycle, start, ctx, origin, self)
    }

    /// A refusal, unless one in front of it says the same of the same area.
    fn unless_explained(&mut self, cycle: &Cycle, found: Box<Diagnostic>) -> Option<Box<Diagnostic>> {
        if self.no_path.as_mut().is_some_and(|known| known.explains(cycle, &found)) {
            return None;
        }
        self.no_path = NoPath::of(cycle, &found).map(Box::new);
        Some(found)
    }

    /// Says what is left of a turned part, where the frame only shifts it.
    fn finished(&mut self, cycle: &Cycle) {
        if let Some((contour, into)) = cycle.finished()
            && self.ctx.frame.is_shift()
            && self.machine_axes.transformer.is_none()
            && !self.machine_axes.tilted
        {
            let by = Vec2::new(self.ctx.frame.shift_of(Axis::Z), self.ctx.frame.shift_of(Axis::X));
            let contour: Vec<Element> = contour.iter().map(|element| element.shifted(by)).collect();
            self.out.finished(&contour, into);
        }
    }

    fn cuts_nothing(&self, origin: &Origin) {
        self.diags.push_once(at(*origin, codes::G3304::cycle_cuts_nothing()));
    }

    #[inline]
    fn follow_ctx(&mut self, ctx: &CtxRef, origin: &Origin) {
        if !Rc::ptr_eq(&self.ctx, ctx) {
            self.enter_frame(ctx, origin);
        }
    }
}

impl Sink for Lower<'_> {
    fn movement(&mut self, mv: &contour::Move, ctx: &CtxRef, origin: &Origin) {
        self.follow_ctx(ctx, origin);
        self.clear.follow(mv);
        self.moves += match &mv.path {
            contour::Path::Arc(arc, _) => ARC + TURN * arc.whole_turns(),
            contour::Path::Rapid | contour::Path::Line(_) | contour::Path::Thread(_) => 1,
        };
        if !self.claimed.is_empty() && self.recording.is_none() {
            self.state_end(mv);
        }
        self.path_element(mv, origin);
    }

    fn corner(&mut self, corner: &Corner, ctx: &CtxRef, origin: &Origin) {
        self.follow_ctx(ctx, origin);
        self.last.corner();
        if let contour::CornerShape::Undercut(_) = &corner.shape
            && let Err(found) = undercut::admit(self.machine, ctx.plane, origin)
        {
            self.diags.push(*found);
            return;
        }
        let (corners, mut finish) = self.split();
        corners.corner(*corner, *origin, finish.diags, &mut |event| finish.event(event));
    }

    fn function(&mut self, function: &Function, ctx: &CtxRef, origin: &Origin) {
        self.follow_ctx(ctx, origin);
        if let Function::Transformation(by) = function {
            return self.transform(*by, origin);
        }
        if let Function::Tilt(tilting) = function {
            return self.tilt(tilting, origin);
        }
        self.displace(function);
        let (corners, mut finish) = self.split();
        corners.function(function, origin, finish.diags, &mut |event| finish.event(event));
        if matches!(function, Function::WorkOffset(_)) && !self.start.known().is_empty() {
            self.out.begins_at(&self.start);
        }
    }

    fn tap(&mut self, tap: &Tap, ctx: &CtxRef, origin: &Origin) {
        self.follow_ctx(ctx, origin);
        self.clear.lost();
        self.tap_hole(tap, origin);
    }

    fn cycle(&mut self, cycle: &Cycle, ctx: &CtxRef, origin: &Origin) {
        self.follow_ctx(ctx, origin);
        if !self.compensator.is_idle(Side::None) {
            self.flush();
            if !self.compensator.is_idle(Side::None) {
                return self.refuse(compensation::cycle_beside(origin), &cycle.leaves(&self.at), origin);
            }
        }
        self.state_claimed(origin);
        let start = self.at;
        let modal = cycle.repeats();
        let known = modal && self.refused.as_deref() == Some(cycle);
        let found = match known {
            true => None,
            false => match self.expand(cycle, &start, ctx, origin) {
                Ok(true) => return self.finished(cycle),
                Ok(false) => return self.cuts_nothing(origin),
                Err(found) => self.unless_explained(cycle, found),
            },
        };
        // What was not made is work as well.
        self.moves += if known { 1 } else { REFUSED };
        if modal && !known {
            self.refused = Some(Box::new(cycle.clone()));
        }
        self.refuse(found, &cycle.leaves(&start), origin);
    }

    fn begins_at(&mut self, at: &Pos) {
        self.start = *at;
        self.at.update(at);
        self.out.begins_at(at);
    }

    fn stands_at(&mut self, at: &Pos, ctx: &CtxRef, origin: &Origin) {
        self.follow_ctx(ctx, origin);
        self.claim(at);
    }

    fn load(&self) -> Load {
        let parts = self.machine_axes.transformer.as_ref().map_or(0, |transformer| transformer.parts);
        Load { moves: self.moves + parts, full: self.out.full() }
    }

    fn lost(&mut self, ctx: &CtxRef, origin: &Origin) {
        self.follow_ctx(ctx, origin);
        if self.diags.has_errors() {
            self.abandon();
        } else {
            self.flush();
        }
        self.at.clear();
        self.clear.lost();
        self.last.forget();
        self.position_lost(origin);
    }

    fn contour_begins(&mut self, limit: usize, ctx: &CtxRef, origin: &Origin) {
        self.follow_ctx(ctx, origin);
        let before = SavedPasses {
            at: std::mem::replace(&mut self.at, Pos::UNKNOWN),
            ctx: Rc::clone(&self.ctx),
            last: std::mem::take(&mut self.last),
            corners: std::mem::take(&mut self.corners),
            chain: std::mem::take(&mut self.chain),
        };
        self.recording = Some(Box::new(Recording::new(limit, self.diags.errors(), before)));
    }

    fn contour_ends(&mut self, origin: &Origin) -> Result<Captured, Unfit> {
        self.flush();
        let Some(recording) = self.recording.take() else { return Err(Unfit::NoStart(*origin)) };
        let (before, made) = recording.finish(self.diags.errors(), origin);
        (self.at, self.ctx, self.last, self.corners) = (before.at, before.ctx, before.last, before.corners);
        self.chain = before.chain;
        made
    }
}

/// The last passes, which need no memory.
struct Finish<'a> {
    diags: &'a Diags,
    out: Out<'a>,
    chain: &'a mut Checked,
    compensator: &'a mut Compensator,
    recording: Option<&'a mut Recording>,
}

impl Finish<'_> {
    #[inline(always)]
    fn event(&mut self, event: Event<'_>) {
        if cfg!(debug_assertions) {
            self.chain.event(&event);
        }
        if self.recording.is_some() {
            return self.record(event);
        }
        match event {
            Event::Step(step) if step.is_in_workpiece() && self.compensator.is_idle(step.mv.side) => {
                self.out.movement(&step.mv, &step.origin);
            }
            Event::Step(step) => self.place(step),
            Event::Function(function, origin) => self.compensator.function(function, &origin, &mut self.out),
        }
    }

    /// A step in a frame, or beside a contour.
    #[inline(never)]
    fn place(&mut self, step: &Step) {
        let frame = &step.ctx.frame;
        if step.is_in_workpiece() {
            return self.beside(&step.mv, &step.start, step);
        }
        match frames::workpiece(&step.mv, frame) {
            Ok(mv) => {
                if !mv.machine
                    && mv.end.exceeds(step::FAR)
                    && let Err(found) = step::exact_far_out(&Pos::UNKNOWN, &mv, step.origin)
                {
                    self.diags.push(*found);
                    return self.compensator.lost(&step.origin, &mut self.out);
                }
                if self.compensator.is_idle(mv.side) {
                    return self.out.movement(&mv, &step.origin);
                }
                self.beside(&mv, &frame.apply(&step.start), step);
            }
            Err(fault) => {
                self.diags.push(at(step.origin, fault));
                // The move is missing, so the next one does not start where the last one ended.
                self.compensator.lost(&step.origin, &mut self.out);
            }
        }
    }

    /// A move on one side of a contour, or the first one behind it.
    #[inline]
    fn beside(&mut self, mv: &motion::Move, start: &Pos, step: &Step) {
        let rules = step.ctx.compensation.as_ref();
        self.compensator.movement(mv, start, rules, &step.origin, &mut self.out);
    }

    /// The element belongs to a contour that is described. Functions have no place in one; who sends them says so.
    #[cold]
    fn record(&mut self, event: Event<'_>) {
        if let (Event::Step(step), Some(recording)) = (event, &mut self.recording) {
            recording.take(step);
        }
    }
}

/// A finding about a whole block.
fn at(origin: Origin, fault: Fault) -> Diagnostic {
    fault.at(origin.loc).called(origin.call)
}
