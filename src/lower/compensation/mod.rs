//! Pass 4: from the programmed contour to the path of the tool centre.
//!
//! It works in workpiece coordinates, behind the frames: there a mirror has swapped the side, and the radius of the tool
//! is what it is. What a control decides comes with the elements ([`Compensation`]); what it does is here. The path of an
//! element is printed when its end is settled: one element of look-ahead, more where the control may leave elements out.
//!
//! Geometry: docs/compensation.md.

mod border;
mod bounds;
mod gouge;
mod joints;
mod piece;
mod reports;
mod search;
#[cfg(test)]
mod tests;

use std::collections::VecDeque;
use std::rc::Rc;

use crate::diag::{Diagnostic, Fault, codes};
use crate::geo::joint::Headings;
use crate::geo::{Element, Plane, SAME_POINT, Vec2, joint};
use crate::ir::compensation::Compensation;
use crate::ir::motion::{Move, Path};
use crate::ir::{Function, Origin, Pos, Side};

use super::machine_axes::Out;
use super::{at, step};
use bounds::Seen;
use gouge::Gouges;
use joints::JointScratch;
use piece::{Item, Kind, Piece, aside, moved};
use reports::Refused;
pub use reports::cycle_beside;

/// Functions and moves that may wait for one element of a contour.
const MOST_ITEMS: usize = 4096;

#[derive(Debug, Clone, Copy, PartialEq, Default)]
enum Stage {
    #[default]
    Off,
    /// The way to the contour waits for the first element.
    Entering,
    Contour,
    /// The offset stays what it was.
    Constant(Vec2),
    /// Off again, but the tool still stands beside the contour.
    Leaving,
    /// The contour was refused, which was reported.
    Refused,
}

/// One contour at a time.
#[derive(Debug, Default)]
pub struct Compensator {
    stage: Stage,
    side: Side,
    plane: Plane,
    /// Distance of the path from the contour in mm, positive to the left.
    d: f64,
    /// The way to the contour, and what happens at its end.
    entry: Option<Box<Piece>>,
    /// Pieces whose start is settled; all but the last element end at their joint.
    path: VecDeque<Box<Piece>>,
    /// Elements behind one that the path does not meet.
    ahead: VecDeque<Box<Piece>>,
    scratch: JointScratch,
    /// Elements of the contour in `path`.
    elements: u32,
    /// Where the printed path stands.
    at: Pos,
    gouges: Gouges,
}

impl Compensator {
    /// Is there nothing to do for a move on `side`?
    #[inline]
    pub fn is_idle(&self, side: Side) -> bool {
        side == Side::None && matches!(self.stage, Stage::Off)
    }

    /// A move in workpiece coordinates from `start`.
    pub fn movement(
        &mut self,
        mv: &Move,
        start: &Pos,
        rules: Option<&Rc<Compensation>>,
        origin: &Origin,
        out: &mut Out<'_>,
    ) {
        let done = match (mv.side, rules) {
            (Side::None, _) => self.uncompensated(mv, rules, origin, out),
            (_, Some(rules)) if rules.radius > 0.0 => self.compensated(mv, start, rules, origin, out),
            // The target compensates, or there is nothing to compensate.
            (_, None) => return out.movement(mv, origin),
            (_, Some(_)) => self.uncompensated(&Move { side: Side::None, ..*mv }, rules, origin, out),
        };
        if let Err(found) = done {
            self.refuse(*found, origin, out);
        }
    }

    /// Everything after the fault up to the end of the contour is not printed.
    fn refuse(&mut self, found: Diagnostic, origin: &Origin, out: &mut Out<'_>) {
        out.diags.push(found);
        self.forget();
        self.stage = Stage::Refused;
        out.lost(origin);
    }

    fn forget(&mut self) {
        self.entry = None;
        self.path.clear();
        self.ahead.clear();
        self.scratch.made.clear();
        self.elements = 0;
        self.at.clear();
        self.gouges.forget(&mut self.scratch.pool);
        self.stage = Stage::Off;
    }

    pub fn function(&mut self, function: &Function, origin: &Origin, out: &mut Out<'_>) {
        match self.stage {
            Stage::Off | Stage::Refused => out.function(function, origin),
            Stage::Leaving | Stage::Constant(_) => {
                if let (Stage::Constant(_), Some(fault)) = (self.stage, self.ends_contour(function)) {
                    self.refuse(at(*origin, fault), origin, out);
                } else if matches!(function, Function::WorkOffset(_) | Function::ToolChange { .. }) {
                    self.at.clear();
                }
                out.function(function, origin);
            }
            Stage::Entering | Stage::Contour => {
                if let Err(found) = self.waits(function, origin) {
                    self.refuse(*found, origin, out);
                    out.function(function, origin);
                }
            }
        }
    }

    /// What `function` does that must not happen while the contour goes on.
    fn ends_contour(&self, function: &Function) -> Option<Fault> {
        match function {
            Function::ToolChange { .. } => Some(codes::G3204::tool_changes()),
            Function::End { .. } => Some(codes::G3204::program_ends()),
            Function::WorkOffset(_) => Some(codes::G3204::work_offset_changes()),
            Function::Cutter(_) => Some(codes::G3204::tool_data_change()),
            Function::Transformation(_) => Some(codes::G3204::transformation_begins_or_ends()),
            Function::Tilt(_) => Some(codes::G3204::working_plane_is_tilted()),
            Function::Plane(plane) => (*plane != self.plane).then(codes::G3204::working_plane_changes),
            Function::ToolPrepare { .. }
            | Function::Spindle(_)
            | Function::SpindleOf { .. }
            | Function::FeedSpindle(_)
            | Function::Coolant(_)
            | Function::Dwell(_)
            | Function::Stop
            | Function::OptionalStop
            | Function::Aux(_)
            | Function::PathControl(_)
            | Function::Comment(_)
            | Function::Remark(_) => None,
        }
    }

    /// The function happens where the last element ends.
    fn waits(&mut self, function: &Function, origin: &Origin) -> Result<(), Refused> {
        if let Some(fault) = self.ends_contour(function) {
            return Err(Box::new(at(*origin, fault)));
        }
        self.item(Item::Function(function.clone(), *origin), origin)
    }

    fn item(&mut self, item: Item, origin: &Origin) -> Result<(), Refused> {
        let last = match self.stage {
            Stage::Entering => self.entry.as_deref_mut(),
            Stage::Off | Stage::Contour | Stage::Constant(_) | Stage::Leaving | Stage::Refused => self.last_mut(),
        };
        let Some(last) = last else { return Ok(()) };
        if last.items.len() >= MOST_ITEMS {
            return Err(reports::too_much_between(origin));
        }
        last.items.push(item);
        Ok(())
    }

    /// The position is no longer what the moves say.
    pub fn lost(&mut self, origin: &Origin, out: &mut Out<'_>) {
        match self.stage {
            Stage::Off | Stage::Refused => {}
            Stage::Leaving => self.forget(),
            Stage::Entering | Stage::Contour | Stage::Constant(_) => {
                if !out.diags.has_errors() {
                    out.diags.push(*reports::position_lost(origin));
                }
                self.forget();
                self.stage = Stage::Refused;
            }
        }
        out.lost(origin);
    }

    /// Nothing comes any more.
    pub fn finish(&mut self, out: &mut Out<'_>) {
        if let Stage::Entering | Stage::Contour = self.stage {
            let origin = self.last_origin();
            out.diags.push(*reports::never_ends(&origin));
            self.forget();
        }
    }

    /// The newest piece.
    fn last_mut(&mut self) -> Option<&mut Piece> {
        self.ahead.back_mut().or(self.path.back_mut()).map(Box::as_mut)
    }

    fn last_origin(&self) -> Origin {
        let last = self.ahead.back().or(self.path.back()).or(self.entry.as_ref());
        last.map(|piece| piece.origin).unwrap_or_default()
    }

    /// Sends `mv` and remembers where it ends.
    #[inline]
    fn send(&mut self, mv: &Move, origin: &Origin, out: &mut Out<'_>) {
        if !mv.machine
            && mv.end.exceeds_in(mv.plane, step::FAR)
            && let Err(found) = step::exact_far_out(&self.at, mv, *origin)
        {
            out.diags.push(*found);
            self.at.clear();
            return out.lost(origin);
        }
        out.movement(mv, origin);
        self.at.update(&mv.end);
    }

    /// Is the tool where `mv` leads already?
    fn stands_at_end(&self, mv: &Move) -> bool {
        let close = |(from, to): (f64, f64)| (from - to).abs() <= SAME_POINT;
        mv.axes.iter().all(|axis| self.at.get(axis).zip(mv.end.get(axis)).is_some_and(close))
    }

    fn send_items(&mut self, items: Vec<Item>, out: &mut Out<'_>) {
        for item in items {
            match item {
                Item::Function(function, origin) => out.function(&function, &origin),
                Item::Move(mv, origin) => {
                    let mv = aside(&mv, &self.at, self.plane);
                    self.send(&mv, &origin, out);
                }
            }
        }
    }

    /// A move on one side of the contour.
    fn compensated(
        &mut self,
        mv: &Move,
        start: &Pos,
        rules: &Rc<Compensation>,
        origin: &Origin,
        out: &mut Out<'_>,
    ) -> Result<(), Refused> {
        match self.stage {
            Stage::Refused => return Ok(()),
            Stage::Off | Stage::Leaving => return self.begin(mv, start, rules, origin),
            Stage::Entering | Stage::Contour | Stage::Constant(_) => {}
        }
        self.admit(mv, rules, origin)?;
        let contour = match Way::of(mv, start) {
            Way::Element(contour) => contour,
            Way::Unknown => return Err(reports::start_unknown(origin)),
            Way::Stays => return self.beside(mv, start, origin, out),
        };
        out.programmed(mv, start);
        match self.stage {
            Stage::Contour if !rules.constant => {
                let next = self.piece(mv, contour, rules, origin)?;
                self.join(next, out)?;
                self.gouges.refuses = rules.search.bottlenecks;
                self.watch_contour(out.diags);
                self.settle(rules.search.elements, out);
                Ok(())
            }
            Stage::Entering => {
                if rules.constant {
                    return Err(reports::constant_at_start(origin));
                }
                let first = self.piece(mv, contour, rules, origin)?;
                self.enter(first, out)
            }
            Stage::Constant(by) if rules.constant => {
                self.send(&moved(mv, by), origin, out);
                Ok(())
            }
            Stage::Constant(by) => {
                self.stage = Stage::Contour;
                let first = self.piece(mv, contour, rules, origin)?;
                self.resume(first, by, out)
            }
            Stage::Off | Stage::Contour | Stage::Leaving | Stage::Refused => {
                let by = self.hold_offset(out)?;
                self.stage = Stage::Constant(by);
                self.send(&moved(mv, by), origin, out);
                Ok(())
            }
        }
    }

    /// A move that leaves the plane alone.
    fn beside(&mut self, mv: &Move, start: &Pos, origin: &Origin, out: &mut Out<'_>) -> Result<(), Refused> {
        if let Stage::Constant(_) = self.stage {
            let mv = aside(mv, &self.at, self.plane);
            self.send(&mv, origin, out);
            return Ok(());
        }
        // An element of no length has no direction, and no way.
        if leaves_others(mv, start) { Ok(()) } else { self.item(Item::Move(*mv, *origin), origin) }
    }

    /// What may not stand in a contour.
    #[inline]
    fn admit(&self, mv: &Move, rules: &Rc<Compensation>, origin: &Origin) -> Result<(), Refused> {
        if mv.plane != self.plane {
            return Err(reports::plane_changes(rules, origin));
        }
        if mv.side != self.side || (rules.radius - self.d.abs()).abs() > SAME_POINT {
            return Err(reports::side_changes(mv.side != self.side, origin));
        }
        reports::admit(mv, origin)
    }

    /// The element with its path, before it is joined to anything.
    #[inline(always)]
    fn piece(
        &mut self,
        mv: &Move,
        contour: Element,
        rules: &Rc<Compensation>,
        origin: &Origin,
    ) -> Result<Box<Piece>, Refused> {
        let headings = Headings::of(&contour);
        let parallel = headings.and_then(|headings| joint::parallel(&contour, &headings, self.d));
        let (kind, curve) = match parallel {
            Some(curve) => (Kind::Element, curve),
            None if rules.search.elements > 0 => (Kind::Gone, contour),
            None => return Err(reports::arc_too_small(&contour, rules, origin)),
        };
        let mut piece = self.scratch.pool.take(rules);
        piece.kind = kind;
        piece.index = self.gouges.next_index();
        piece.contour = contour;
        piece.headings = headings.unwrap_or_default();
        piece.curve = curve;
        piece.stop = None;
        (piece.regular, piece.joined, piece.seen) = (true, false, Seen::default());
        piece.mv = *mv;
        piece.origin = *origin;
        Ok(piece)
    }

    /// Prints what no search reaches any more.
    fn settle(&mut self, kept: u32, out: &mut Out<'_>) {
        while self.elements > kept + 1 {
            self.print_first(out);
        }
    }

    fn print_all(&mut self, out: &mut Out<'_>) {
        while !self.path.is_empty() {
            self.print_first(out);
        }
    }

    fn print_first(&mut self, out: &mut Out<'_>) {
        let Some(mut first) = self.path.pop_front() else { return };
        self.elements -= u32::from(first.kind.is_of_contour());
        if self.leads_somewhere(&mut first, out) {
            self.send(&first.mv, &first.origin, out);
        }
        if !first.items.is_empty() {
            self.send_items(std::mem::take(&mut first.items), out);
        }
        match first.kind {
            Kind::Element | Kind::Joint | Kind::Gone => self.gouges.keep(first, &mut self.scratch.pool),
            Kind::Entry | Kind::Exit => self.scratch.pool.put(first),
        }
    }

    /// Makes the move of a piece the one that is printed; there may be none.
    #[inline]
    fn leads_somewhere(&mut self, piece: &mut Piece, out: &Out<'_>) -> bool {
        match piece.kind {
            Kind::Element | Kind::Joint => {
                piece.settle();
                piece.lead_along(&self.at);
                if is_nothing(&piece.curve) && leaves_others(&piece.mv, &self.at) {
                    return false;
                }
                reports::feed_instead(piece, out.diags);
                self.watch_path(piece, out.diags);
                true
            }
            // The way to the contour leads to where the path begins, if an approach on an arc has not done so.
            Kind::Entry => {
                piece.curve = Element::Line { from: piece.end(), to: piece.end() };
                piece.lead_along(&self.at);
                !self.stands_at_end(&piece.mv)
            }
            Kind::Exit | Kind::Gone => false,
        }
    }
}

fn is_nothing(way: &Element) -> bool {
    match *way {
        Element::Line { from, to } => (to - from).norm_squared() <= SAME_POINT * SAME_POINT,
        Element::Arc { .. } => way.length() <= SAME_POINT,
    }
}

/// Do all axes outside of the plane stay where they are?
fn leaves_others(mv: &Move, at: &Pos) -> bool {
    let others = mv.axes.without(step::plane_axes(mv.plane));
    others.iter().all(|axis| at.get(axis) == mv.end.get(axis))
}

/// What a move does in its plane.
enum Way {
    Stays,
    Element(Element),
    /// It moves, nobody knows from where.
    Unknown,
}

impl Way {
    #[inline(always)]
    fn of(mv: &Move, start: &Pos) -> Way {
        let (Some(from), Some(to)) = (start.in_plane(mv.plane), mv.end.in_plane(mv.plane)) else {
            let named = !step::plane_axes(mv.plane).common(mv.axes).is_empty();
            return if named || matches!(mv.path, Path::Arc(..)) { Way::Unknown } else { Way::Stays };
        };
        let moves = (to - from).norm_squared() > SAME_POINT * SAME_POINT;
        match &mv.path {
            Path::Arc(arc, _) if moves || arc.plane == mv.plane => {
                Way::Element(Element::Arc { from, to, center: arc.center, sweep: arc.sweep })
            }
            Path::Rapid | Path::Line(_) | Path::Thread { .. } | Path::Carried { .. } if moves => {
                Way::Element(Element::Line { from, to })
            }
            Path::Arc(..) | Path::Rapid | Path::Line(_) | Path::Thread { .. } | Path::Carried { .. } => Way::Stays,
        }
    }

    fn moves(&self) -> bool {
        !matches!(self, Way::Stays)
    }
}
