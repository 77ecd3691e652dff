//! The motion stream, and the steps between the passes of lower.

use crate::geo::{distance, turned};
use crate::ir::motion::{Arc, Move, Path, Place, Sink};
use crate::ir::{Feed, Function, Origin, Pos, Tap};
use crate::machine::Axis;

use super::{Fault, MOST_TURNS, TOLERANCE, displaces, ensure, feed, finite, finite_pos, function, hold, lead, near};

/// Moves one after the other: each starts where the one before ended, in all axes that are known.
#[derive(Debug, Clone, Default)]
pub struct Chain {
    at: Pos,
}

impl Chain {
    /// The next move of a stream in which a move starts where the one before ends.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn follow(&mut self, mv: &Move) -> Result<(), Fault> {
        let start = self.at;
        self.take(&start, mv)
    }

    /// The next element, which says itself where it starts.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn take(&mut self, start: &Pos, mv: &Move) -> Result<(), Fault> {
        for (axis, value) in start.iter() {
            ensure(self.at.get(axis).is_none_or(|at| near(at, value)), Fault::Gap(axis))?;
        }
        element(start, mv)?;
        if mv.machine {
            // Under a rotation other axes are lost with these.
            self.at.clear();
        } else {
            self.at.update(&mv.end);
        }
        Ok(())
    }

    /// A tap from where the moves before it lead.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn tap(&mut self, tap: &Tap, place: &Place) -> Result<(), Fault> {
        for (axis, value) in place.at.iter() {
            ensure(self.at.get(axis).is_none_or(|at| near(at, value)), Fault::Gap(axis))?;
        }
        let starts = place.at.get(tap.axis).is_some_and(|at| near(at, tap.start));
        ensure(starts && tap.check().is_ok(), Fault::Tap)?;
        self.at.set(tap.axis, tap.end());
        Ok(())
    }

    /// A function: what it leaves of the position.
    pub fn function(&mut self, function: &Function) {
        if displaces(function) {
            self.at.clear();
        }
    }

    /// The position is not known any more.
    pub fn lost(&mut self) {
        self.at.clear();
    }

    /// Axes stand here although no move said so.
    pub fn begins_at(&mut self, at: &Pos) {
        self.at.update(at);
    }
}

/// What a move promises by itself, from `start` on.
///
/// # Errors
/// What is wrong with it.
pub fn element(start: &Pos, mv: &Move) -> Result<(), Fault> {
    finite_pos(&mv.end)?;
    ensure(!mv.axes.is_empty(), Fault::NoAxis)?;
    if let Some(axis) = mv.axes.without(mv.end.known()).iter().next() {
        return Err(Fault::NoEnd(axis));
    }
    if let Some(f) = mv.path.feed() {
        feed(f)?;
    }
    if mv.machine {
        let straight = matches!(mv.path, Path::Rapid | Path::Line(_));
        return ensure(straight && mv.end.known() == mv.axes, Fault::Machine);
    }
    let aside = |(axis, end): &(Axis, f64)| {
        !mv.axes.contains(*axis) && start.get(*axis).is_some_and(|before| !near(before, *end))
    };
    if let Some((axis, _)) = mv.end.iter().find(aside) {
        return Err(Fault::Unnamed(axis));
    }
    match &mv.path {
        Path::Rapid | Path::Line(_) => Ok(()),
        Path::Carried { feed: along, length } => feed(Feed::PerMinute(*along)).and_then(|()| lead(*length)),
        Path::Thread { lead: along } => lead(*along),
        Path::Arc(arc, _) => circle(arc, start, mv),
    }
}

fn circle(arc: &Arc, start: &Pos, mv: &Move) -> Result<(), Fault> {
    finite(&[arc.from.x, arc.from.y, arc.center.x, arc.center.y, arc.sweep])?;
    let (x, y, _) = arc.plane.axes();
    let named = [x, y].into_iter().all(|axis| mv.axes.contains(Axis::ALL[axis]));
    let to = mv.end.in_plane(arc.plane).filter(|_| named).ok_or(Fault::NotInPlane)?;
    let radius = distance(arc.from, arc.center);
    let tolerance = TOLERANCE * (1.0 + radius);
    if let Some(from) = start.in_plane(arc.plane) {
        ensure(distance(from, arc.from) <= tolerance, Fault::ArcStart)?;
    }
    ensure(radius > 0.0, Fault::NoRadius)?;
    ensure((distance(to, arc.center) - radius).abs() <= tolerance, Fault::Radius)?;
    let turns = arc.sweep.abs() / core::f64::consts::TAU;
    ensure(arc.sweep != 0.0 && turns <= MOST_TURNS, Fault::Turns)?;
    // Many turns lose digits of the angle.
    let leads = arc.center + turned(arc.from - arc.center, arc.sweep);
    ensure(distance(leads, to) <= tolerance * (1.0 + turns), Fault::Sweep)
}

/// Passes the items of a motion stream on and checks them.
pub struct Motion<'a> {
    out: &'a mut dyn Sink,
    chain: Chain,
}

impl std::fmt::Debug for Motion<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Motion").field("chain", &self.chain).finish_non_exhaustive()
    }
}

impl<'a> Motion<'a> {
    /// Checks a stream from its start, where nothing is known.
    pub fn new(out: &'a mut dyn Sink) -> Motion<'a> {
        Motion { out, chain: Chain::default() }
    }
}

impl Sink for Motion<'_> {
    fn movement(&mut self, mv: &Move, origin: &Origin) {
        hold(self.chain.follow(mv), mv);
        self.out.movement(mv, origin);
    }

    fn tap(&mut self, tap: &Tap, place: &Place, origin: &Origin) {
        hold(self.chain.tap(tap, place), tap);
        self.out.tap(tap, place, origin);
    }

    fn function(&mut self, item: &Function, origin: &Origin) {
        hold(function(item), item);
        self.chain.function(item);
        self.out.function(item, origin);
    }

    fn lost(&mut self, origin: &Origin) {
        self.chain.lost();
        self.out.lost(origin);
    }

    fn begins_at(&mut self, at: &Pos) {
        hold(finite_pos(at), at);
        self.chain.begins_at(at);
        self.out.begins_at(at);
    }

    fn finished(&mut self, contour: &[crate::geo::Element], into: crate::ir::cycle::turning::Towards) {
        self.out.finished(contour, into);
    }

    fn programmed(&mut self, mv: &Move, start: &Pos) {
        self.out.programmed(mv, start);
    }

    fn full(&self) -> bool {
        self.out.full()
    }
}
