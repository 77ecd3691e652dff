//! A tilted plane: items that count in it become items in workpiece coordinates.

use nalgebra::Matrix3;

use crate::geo::{Plane, Point2};
use crate::ir::motion::{Arc, Move, Path, Place};
use crate::ir::tap::Stroke;
use crate::ir::{Pos, Tap, Tilt};
use crate::machine::axis::{Axis, AxisSet};

use super::chords;

/// What an axis of the plane may have along another axis and still lie across it: 1e-7 mm at a coordinate of 100 m.
const SQUARE: f64 = 1e-12;

/// A plane in force, and where the path is in it.
#[derive(Debug)]
pub(super) struct Tilted {
    tilt: Tilt,
    /// In coordinates of the plane.
    at: Pos,
    /// Main axes of the workpiece whose position may be known to who gets the items.
    told: AxisSet,
}

impl Tilted {
    /// `None` where the plane is that of the workpiece.
    pub fn new(tilt: &Tilt) -> Option<Tilted> {
        let is_own = |tilt: &Tilt| tilt.axes == Matrix3::identity() && tilt.origin.iter().all(|v| *v == 0.0);
        let tilted = Tilted::of_any(tilt);
        (!is_own(&tilted.tilt)).then_some(tilted)
    }

    /// Of any plane, also of that of the workpiece.
    pub(super) fn of_any(tilt: &Tilt) -> Tilted {
        let axes = tilt.axes.map(|v| if (v - v.round()).abs() <= SQUARE { v.round() } else { v });
        Tilted { tilt: Tilt { axes, ..*tilt }, at: Pos::UNKNOWN, told: AxisSet::EMPTY }
    }

    /// Nobody knows where the tool is.
    pub fn lost(&mut self) {
        self.at.clear();
        self.told = AxisSet::EMPTY;
    }

    /// Gives a move as one or more; `None` where nothing that was told of the position holds any more.
    pub fn movement(&mut self, mv: &Move, take: &mut dyn FnMut(Option<&Move>)) {
        if mv.machine {
            take(Some(mv));
            take(None);
            return self.lost();
        }
        let start = std::mem::replace(&mut self.at, mv.end);
        let mut told = self.told;
        self.pieces(mv, &start, &mut |piece| {
            if hides(&mut told, piece.end.known()) || piece.axes.is_empty() {
                told = AxisSet::EMPTY;
                take(None);
            }
            if !piece.axes.is_empty() {
                told = piece.end.known().common(AxisSet::MAIN);
                take(Some(piece));
            }
        });
        self.told = told;
    }

    /// An element of the contour beside which the path runs, from `start` on, as one or more with their starts.
    pub fn programmed(&self, mv: &Move, start: &Pos, take: &mut dyn FnMut(&Move, &Pos)) {
        let mut from = self.tilt.in_workpiece(start);
        self.pieces(mv, start, &mut |piece| {
            if !piece.axes.is_empty() {
                take(piece, &from);
            }
            from = piece.end;
        });
    }

    /// The tap, where it goes along a main axis of the workpiece. `lost` is called before where what was told does not hold.
    pub fn tap(&mut self, tap: &Tap, place: &Place, lost: &mut dyn FnMut()) -> Option<(Tap, Place)> {
        let (axis, sign) = self.main_axis(tap.axis)?;
        let along = |at: f64| sign * at + self.tilt.origin[axis.index()];
        let stroke = |s: &Stroke| Stroke { to: along(s.to), back: along(s.back), dwell: s.dwell };
        let turned = Tap {
            axis,
            start: along(tap.start),
            surface: along(tap.surface),
            strokes: tap.strokes.iter().map(stroke).collect(),
            ..tap.clone()
        };
        let at = self.tilt.in_workpiece(&place.at);
        self.at = place.at;
        self.at.set(tap.axis, tap.end());
        if hides(&mut self.told, at.known()) {
            lost();
        }
        Some((turned, Place { at, plane: self.plane(place.plane) }))
    }

    /// What is known of the workpiece by axes that stand here; nothing where that is not enough.
    pub fn begins_at(&mut self, at: &Pos) -> Pos {
        self.at.update(at);
        let mut place = self.tilt.in_workpiece(&self.at);
        let new = self.moved(at.known());
        place.known().without(new).iter().for_each(|axis| place.forget(axis));
        self.told = self.told.union(place.known().common(AxisSet::MAIN));
        place
    }

    /// A move from `start` on, both in the plane, as one or more in workpiece coordinates. One that names no axis says
    /// that nothing is known of where the move leads.
    fn pieces(&self, mv: &Move, start: &Pos, take: &mut dyn FnMut(&Move)) {
        let mut give = |local: &Move, path: Path| {
            let end = self.tilt.in_workpiece(&local.end);
            let axes = self.moved(local.axes).common(end.known());
            // The side is seen along the tool, here as there.
            take(&Move { end, axes, path, side: local.side, plane: self.plane(local.plane), machine: false });
        };
        match &mv.path {
            Path::Arc(arc, feed) => match self.arc(arc) {
                Some(turned) => give(mv, Path::Arc(turned, *feed)),
                None => chords::of(arc, *feed, mv, start, &mut |chord| give(chord, chord.path)),
            },
            Path::Rapid | Path::Line(_) | Path::Thread { .. } | Path::Carried { .. } => give(mv, mv.path),
        }
    }

    /// Axes that move with `axes` of the plane.
    fn moved(&self, axes: AxisSet) -> AxisSet {
        let mut moved = axes.without(AxisSet::MAIN);
        for to in AxisSet::MAIN.iter() {
            if axes.common(AxisSet::MAIN).iter().any(|from| self.tilt.axes[(to.index(), from.index())] != 0.0) {
                moved.insert(to);
            }
        }
        moved
    }

    /// The main axis of the workpiece along which one of the plane lies, and whether it leads the same way (1) or back (-1).
    fn main_axis(&self, of: Axis) -> Option<(Axis, f64)> {
        let axes = &self.tilt.axes;
        let along = |to: &Axis| axes[(to.index(), of.index())].abs() == 1.0;
        let to = AxisSet::MAIN.iter().find(along)?;
        let across = (0..3).all(|i| {
            (i == of.index() || axes[(to.index(), i)] == 0.0) && (i == to.index() || axes[(i, of.index())] == 0.0)
        });
        across.then(|| (to, axes[(to.index(), of.index())]))
    }

    /// The main plane of the workpiece in which a working plane lies, and whether its angles count the same way.
    fn main_plane(&self, of: Plane) -> Option<(Plane, f64)> {
        let (_, _, third) = of.axes();
        let (axis, sign) = self.main_axis(Axis::ALL[third])?;
        Some((Plane::normal_to(axis.index())?, sign))
    }

    /// The working plane as those see it who want a main one.
    fn plane(&self, of: Plane) -> Plane {
        self.main_plane(of).map_or(of, |(plane, _)| plane)
    }

    /// The arc, where it lies in a main plane of the workpiece.
    fn arc(&self, arc: &Arc) -> Option<Arc> {
        let (plane, sign) = self.main_plane(arc.plane)?;
        let turned = |p: Point2| {
            let mut at = Pos::UNKNOWN;
            at.set_in_plane(arc.plane, p);
            self.tilt.in_workpiece(&at).in_plane(plane)
        };
        Some(Arc { plane, from: turned(arc.from)?, center: turned(arc.center)?, sweep: sign * arc.sweep })
    }
}

/// Takes down what is known after an item; true where something of what was told is not among it.
fn hides(told: &mut AxisSet, known: AxisSet) -> bool {
    let main = known.common(AxisSet::MAIN);
    let hides = !told.without(main).is_empty();
    *told = main;
    hides
}
