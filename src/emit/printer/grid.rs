//! The grid on which coordinates and feeds are printed.

use crate::geo::{Plane, Point2};
use crate::machine::Axis;

use super::super::modal::FeedKind;
use super::super::number::Places;
use super::Printer;

/// The units in which both axes of a plane are counted: where one of them is printed as a diameter, the places of the other
/// one and of the centre lie two units apart.
#[derive(Debug, Clone, Copy)]
pub(super) struct Grid {
    /// Units of a place of each axis.
    each: [i64; 2],
    /// The larger of them.
    pub step: i64,
}

impl Grid {
    /// Places as units.
    pub fn of(self, places: [i64; 2]) -> [i64; 2] {
        [places[0] * self.each[0], places[1] * self.each[1]]
    }

    /// Units as places.
    pub fn places(self, units: [i64; 2]) -> [i64; 2] {
        [units[0] / self.each[0], units[1] / self.each[1]]
    }
}

impl Printer<'_> {
    /// Places of the coordinates of an axis; those of a diameter count half a millimetre.
    #[inline(always)]
    pub(super) fn places_of(&self, axis: Axis) -> Places {
        self.by_axis[axis.index()]
    }

    /// Takes these places for lengths, and for X whether it is a diameter.
    pub(super) fn set_places(&mut self, places: Places, diameter: bool) {
        (self.places, self.diameter) = (places, diameter);
        self.by_axis = Axis::ALL.map(|axis| if axis.is_rotary() { self.measures.angle } else { places });
        if diameter {
            self.by_axis[Axis::X.index()] = places.of(0.5);
        }
    }

    /// The units of the axes of a plane.
    pub(super) fn grid(&self, plane: Plane) -> Grid {
        let (first, second, _) = plane.axes();
        let is_diameter = |axis: usize| self.diameter && Axis::ALL[axis] == Axis::X;
        let step = if is_diameter(first) || is_diameter(second) { 2 } else { 1 };
        Grid { each: [first, second].map(|axis| if is_diameter(axis) { 1 } else { step }), step }
    }

    /// A point as it is printed, in the units of its plane.
    pub(super) fn on_grid(&self, plane: Plane, point: Point2) -> Option<[i64; 2]> {
        let (first, second, _) = plane.axes();
        let x = self.places_of(Axis::ALL[first]).units(point.x)?;
        let y = self.places_of(Axis::ALL[second]).units(point.y)?;
        Some(self.grid(plane).of([x, y]))
    }

    #[inline]
    pub(super) fn feed_places(&self, kind: FeedKind) -> Places {
        match kind {
            FeedKind::PerMinute => self.measures.feed,
            FeedKind::PerRevolution => self.measures.feed_per_revolution,
            FeedKind::InverseTime => self.measures.inverse_time,
        }
    }
}
