//! The path in workpiece coordinates, for those who show or measure it: the motion stream counts in the plane that is tilted.
//!
//! In: the motion stream. Out: the same items in workpiece coordinates. The function that tilts a plane is handed on, for whoever
//! wants to know the direction of the tool. What is printed, and what proves it, never goes through here.
//!
//! Where a workpiece coordinate is not known, because it depends on one of the plane that is not, the moves carry the others
//! only, after a [`lost`](Sink::lost). A move of which nothing is left is that `lost`. Machine coordinates have no fixed place in
//! a tilted plane: such a move passes as it is, and a `lost` follows it. The profile of a turned part is left out.

mod chords;
#[cfg(test)]
mod tests;
mod tilted;

use crate::geo::Element;

use super::cycle::turning::Towards;
use super::motion::{Move, Path, Place, Sink};
use super::tap::Part;
use super::{Function, Origin, Pos, Tap};

use tilted::Tilted;

#[cfg(test)]
use chords::TOLERANCE;

/// Hands items on to `next`, those of a tilted plane in workpiece coordinates.
pub struct InWorkpiece<'a, S: ?Sized> {
    next: &'a mut S,
    /// The plane in force; most programs have none.
    tilted: Option<Box<Tilted>>,
}

impl<S: ?Sized> std::fmt::Debug for InWorkpiece<'_, S> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("InWorkpiece").field("tilted", &self.tilted).finish_non_exhaustive()
    }
}

impl<'a, S: Sink + ?Sized> InWorkpiece<'a, S> {
    pub fn new(next: &'a mut S) -> InWorkpiece<'a, S> {
        InWorkpiece { next, tilted: None }
    }

    #[cold]
    fn tilted_movement(&mut self, mv: &Move, origin: &Origin) {
        let Some(tilted) = &mut self.tilted else { return };
        tilted.movement(mv, &mut |given| match given {
            Some(mv) => self.next.movement(mv, origin),
            None => self.next.lost(origin),
        });
    }

    /// A tap along a main axis stays one; any other one is its strokes.
    #[cold]
    fn tilted_tap(&mut self, tap: &Tap, place: &Place, origin: &Origin) {
        let Some(tilted) = &mut self.tilted else { return };
        let along_main = tilted.tap(tap, place, &mut || self.next.lost(origin));
        if let Some((tap, place)) = along_main {
            return self.next.tap(&tap, &place, origin);
        }
        tap.parts(&mut |part| match part {
            Part::To(to) => {
                self.tilted_movement(&place.along(tap, to, Path::Thread { lead: tap.lead }), origin);
            }
            Part::Spindle(_) | Part::Dwell(_) => {
                part.function().iter().for_each(|function| self.next.function(function, origin));
            }
        });
    }
}

impl<S: Sink + ?Sized> Sink for InWorkpiece<'_, S> {
    #[inline]
    fn movement(&mut self, mv: &Move, origin: &Origin) {
        match self.tilted {
            None => self.next.movement(mv, origin),
            Some(_) => self.tilted_movement(mv, origin),
        }
    }

    fn tap(&mut self, tap: &Tap, place: &Place, origin: &Origin) {
        match self.tilted {
            None => self.next.tap(tap, place, origin),
            Some(_) => self.tilted_tap(tap, place, origin),
        }
    }

    fn function(&mut self, function: &Function, origin: &Origin) {
        if let Function::Tilt(tilting) = function {
            self.tilted = tilting.plane().and_then(Tilted::new).map(Box::new);
        } else if let (Function::WorkOffset(_), Some(tilted)) = (function, &mut self.tilted) {
            tilted.lost();
        }
        self.next.function(function, origin);
    }

    fn lost(&mut self, origin: &Origin) {
        self.tilted.iter_mut().for_each(|tilted| tilted.lost());
        self.next.lost(origin);
    }

    fn programmed(&mut self, mv: &Move, start: &Pos) {
        match &self.tilted {
            None => self.next.programmed(mv, start),
            Some(tilted) => tilted.programmed(mv, start, &mut |mv, start| self.next.programmed(mv, start)),
        }
    }

    fn finished(&mut self, contour: &[Element], into: Towards) {
        if self.tilted.is_none() {
            self.next.finished(contour, into);
        }
    }

    fn begins_at(&mut self, at: &Pos) {
        match &mut self.tilted {
            None => self.next.begins_at(at),
            Some(tilted) => {
                let at = tilted.begins_at(at);
                if !at.known().is_empty() {
                    self.next.begins_at(&at);
                }
            }
        }
    }

    fn full(&self) -> bool {
        self.next.full()
    }
}
