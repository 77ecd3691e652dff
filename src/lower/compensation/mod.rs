//! Pass 4: from the programmed contour to the path of the tool centre.
//!
//! It works in workpiece coordinates, behind the frames: there a mirror has swapped the side, and the radius of the tool
//! is what it is. What a control decides comes with the elements ([`Compensation`]); what it does is here. The path of an
//! element is printed when its end is settled: one element of look-ahead, more where the control may leave elements out.
//!
//! Geometry: docs/compensation.md.

mod border;
mod damage;
mod joints;
mod piece;
mod reports;
mod search;
#[cfg(test)]
mod tests;

use std::collections::VecDeque;
use std::rc::Rc;

use crate::diag::Diagnostic;
use crate::geo::{Element, Plane, SAME_POINT, Vec2, distance, joint};
use crate::ir::compensation::Compensation;
use crate::ir::motion::{Move, Path};
use crate::ir::{Function, Origin, Pos, Side};

use super::carrier::Out;
use super::step;
use damage::Damage;
use piece::{Item, Kind, Piece, aside, moved};
use reports::Refused;
pub use reports::{cycle_beside, still_on};

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
    path: VecDeque<Piece>,
    /// Elements behind one that the path does not meet.
    ahead: VecDeque<Piece>,
    /// What comes between two elements, while they are joined.
    made: Vec<Piece>,
    /// Elements of the contour in `path`.
    elements: u32,
    /// Where the printed path stands.
    at: Pos,
    damage: Damage,
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
        self.made.clear();
        self.elements = 0;
        self.at.clear();
        self.damage.forget();
        self.stage = Stage::Off;
    }

    pub fn function(&mut self, function: &Function, origin: &Origin, out: &mut Out<'_>) {
        match self.stage {
            Stage::Off | Stage::Refused => out.function(function, origin),
            Stage::Leaving | Stage::Constant(_) => {
                if matches!(function, Function::WorkOffset(_) | Function::ToolChange { .. }) {
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

    /// The function happens where the last element ends.
    fn waits(&mut self, function: &Function, origin: &Origin) -> Result<(), Refused> {
        let breaks = match function {
            Function::ToolChange { .. }
            | Function::End { .. }
            | Function::WorkOffset(_)
            | Function::Cutter(_)
            | Function::Transformation(_) => true,
            Function::Plane(plane) => *plane != self.plane,
            Function::ToolPrepare { .. }
            | Function::Spindle(_)
            | Function::SpindleOf { .. }
            | Function::FeedSpindle(_)
            | Function::Coolant(_)
            | Function::Dwell(_)
            | Function::Stop
            | Function::OptionalStop
            | Function::Aux(_)
            | Function::Comment(_) => false,
        };
        if breaks {
            return Err(reports::still_on(function, origin));
        }
        self.item(Item::Function(function.clone(), *origin), origin)
    }

    fn item(&mut self, item: Item, origin: &Origin) -> Result<(), Refused> {
        let last = match self.stage {
            Stage::Entering => self.entry.as_deref_mut(),
            Stage::Off | Stage::Contour | Stage::Constant(_) | Stage::Leaving | Stage::Refused => {
                self.ahead.back_mut().or(self.path.back_mut())
            }
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

    fn last_origin(&self) -> Origin {
        let last = self.ahead.back().or(self.path.back()).or(self.entry.as_deref());
        last.map(|piece| piece.origin).unwrap_or_default()
    }

    /// Sends `mv` and remembers where it ends.
    fn send(&mut self, mv: &Move, origin: &Origin, out: &mut Out<'_>) {
        if !mv.machine
            && mv.end.exceeds(step::FAR)
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
        if !moves_in_plane(mv, start) {
            if let Stage::Constant(_) = self.stage {
                let mv = aside(mv, &self.at, self.plane);
                self.send(&mv, origin, out);
                return Ok(());
            }
            // An element of no length has no direction, and no way.
            return if leaves_others(mv, start) { Ok(()) } else { self.item(Item::Move(*mv, *origin), origin) };
        }
        let Some(contour) = element(mv, start) else { return Err(reports::start_unknown(origin)) };
        out.programmed(mv, start);
        match self.stage {
            Stage::Entering => {
                if rules.constant {
                    return Err(reports::constant_at_start(origin));
                }
                self.enter(self.piece(mv, contour, rules, origin)?, out)
            }
            Stage::Contour if rules.constant => {
                let by = self.hold_offset(out)?;
                self.stage = Stage::Constant(by);
                self.send(&moved(mv, by), origin, out);
                Ok(())
            }
            Stage::Constant(by) if rules.constant => {
                self.send(&moved(mv, by), origin, out);
                Ok(())
            }
            Stage::Constant(by) => {
                self.stage = Stage::Contour;
                self.resume(self.piece(mv, contour, rules, origin)?, by, out)
            }
            Stage::Off | Stage::Contour | Stage::Leaving | Stage::Refused => {
                let next = self.piece(mv, contour, rules, origin)?;
                self.join(next, out)?;
                self.damage.refuses = rules.search.bottlenecks;
                if rules.is_way {
                    self.damage.way();
                } else {
                    self.damage.contour(&contour, origin, self.d, out.diags);
                }
                self.settle(rules.search.elements, out);
                Ok(())
            }
        }
    }

    /// What may not stand in a contour.
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
    fn piece(&self, mv: &Move, contour: Element, rules: &Rc<Compensation>, origin: &Origin) -> Result<Piece, Refused> {
        let (kind, curve) = match joint::parallel(&contour, self.d) {
            Some(curve) => (Kind::Element, curve),
            None if rules.search.elements > 0 => (Kind::Gone, contour),
            None => return Err(reports::arc_too_small(&contour, rules, origin)),
        };
        Ok(Piece {
            kind,
            index: self.damage.next_index(),
            contour,
            curve,
            stop: None,
            mv: *mv,
            origin: *origin,
            rules: Rc::clone(rules),
            items: Vec::new(),
        })
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
        let Some(first) = self.path.front_mut() else { return };
        let items = std::mem::take(&mut first.items);
        let (kind, origin) = (first.kind, first.origin);
        if kind.is_of_contour() {
            self.elements -= 1;
        }
        let mv = match kind {
            // The way to the contour leads to where the path begins.
            Kind::Entry => Some(first.printed(&Element::Line { from: first.end(), to: first.end() }, &self.at)),
            Kind::Exit | Kind::Gone => None,
            Kind::Element | Kind::Joint => {
                let way = first.travelled();
                let mv = first.printed(&way, &self.at);
                if is_nothing(&way) && leaves_others(&mv, &self.at) {
                    None
                } else {
                    reports::feed_instead(first, out.diags);
                    self.damage.path(first, &way, self.d, out.diags);
                    Some(mv)
                }
            }
        };
        self.path.pop_front();
        // An approach on an arc has brought the tool beside the contour already.
        let mv = mv.filter(|mv| kind != Kind::Entry || !self.stands_at_end(mv));
        if let Some(mv) = mv {
            self.send(&mv, &origin, out);
        }
        if !items.is_empty() {
            self.send_items(items, out);
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

/// Does `mv` change the place in its plane?
fn moves_in_plane(mv: &Move, start: &Pos) -> bool {
    if let Path::Arc(arc, _) = &mv.path {
        return arc.plane == mv.plane || distance_in_plane(mv, start).is_none_or(|way| way > SAME_POINT);
    }
    distance_in_plane(mv, start).unwrap_or_else(|| {
        let named = step::plane_axes(mv.plane).common(mv.axes);
        if named.is_empty() { 0.0 } else { f64::INFINITY }
    }) > SAME_POINT
}

fn distance_in_plane(mv: &Move, start: &Pos) -> Option<f64> {
    Some(distance(start.in_plane(mv.plane)?, mv.end.in_plane(mv.plane)?))
}

/// The element in its plane.
fn element(mv: &Move, start: &Pos) -> Option<Element> {
    let (from, to) = (start.in_plane(mv.plane)?, mv.end.in_plane(mv.plane)?);
    Some(match &mv.path {
        Path::Arc(arc, _) => Element::Arc { from, to, center: arc.center, sweep: arc.sweep },
        Path::Rapid | Path::Line(_) | Path::Thread { .. } | Path::Carried { .. } => Element::Line { from, to },
    })
}
