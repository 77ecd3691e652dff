//! How the numbers of each quantity are written.

use crate::geo::{Plane, Point2};
use crate::machine::settings::{Quantity, Units};
use crate::machine::{Axis, OutputSettings};
use crate::target::Form;

use super::super::modal::FeedKind;
use super::super::number::Places;
use super::Printer;

/// Quantities besides lengths.
#[derive(Debug, Clone, Copy)]
pub(super) struct Measures {
    pub angle: Places,
    feed: Places,
    feed_per_revolution: Places,
    inverse_time: Places,
    pub lead: Places,
    /// A factor, in the places of a lead in millimetres.
    pub factor: Places,
    pub speed: Places,
    pub time: Places,
    pub inches: bool,
}

impl Measures {
    /// Places of lengths, and of the others.
    pub fn of(output: &OutputSettings) -> (Places, Measures) {
        let numbers = output.target.numbers;
        let inches = output.units == Units::Inches;
        let plain = |quantity| Places::new(output.places(quantity)).written(numbers.point, numbers.zero);
        let of_feed = |quantity| plain(quantity).written(numbers.feed_point, numbers.zero);
        let length = |quantity| if inches { plain(quantity).of_inches() } else { plain(quantity) };
        let measures = Measures {
            angle: plain(Quantity::Angle),
            feed: of_feed(Quantity::Feed).of(output.feed_unit()),
            feed_per_revolution: length(Quantity::FeedPerRevolution).written(numbers.feed_point, numbers.zero),
            inverse_time: plain(Quantity::InverseTime),
            lead: length(Quantity::Lead),
            factor: plain(Quantity::Lead),
            // A whole number has no point where the target counts whole turns.
            speed: Places::new(output.places(Quantity::Speed)).written(numbers.point && numbers.speed.is_none(), true),
            time: plain(Quantity::Time),
            inches,
        };
        let signs = matches!(output.target.form, Form::Dialog(_));
        (length(Quantity::Length).signed(signs), measures)
    }
}

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
