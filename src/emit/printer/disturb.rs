//! Faults in the state of a printer, for tests of what reads its text.

use crate::geo::Plane;
use crate::ir::{Feed, Side};
use crate::machine::Axis;

use super::super::modal::FeedKind;
use super::super::number::Places;
use super::Printer;

/// A program of this name is printed wrong.
pub const DISTURBED: &str = "DISTURBED.H";

/// What a printer may get wrong about itself or its target.
#[derive(Debug, Clone, Copy)]
pub enum Disturbance {
    /// An axis stands where a later move will lead it, which is therefore not printed.
    Place(Axis, f64),
    Plane(Plane),
    /// This feed holds already.
    Feed(Feed),
    FeedKind(Feed),
    /// X is printed as the other measure.
    Diameter,
    Decimals(u8),
    Side(Side),
    /// The constant cutting speed is on, or off.
    CuttingSpeed(bool),
    /// An axis is where it was printed, whatever happened since.
    Trusted,
}

impl Printer<'_> {
    pub fn disturb(&mut self, disturbance: Disturbance) {
        match disturbance {
            Disturbance::Place(axis, value) => {
                if let Some(units) = self.places_of(axis).units(value) {
                    let mut ends = *self.modal.at();
                    ends[axis.index()] = units;
                    self.modal.reach(crate::machine::AxisSet::of(axis), &ends);
                }
            }
            Disturbance::Plane(plane) => self.modal.plane = plane,
            Disturbance::Feed(feed) => {
                if let Some(units) = self.feed_places(FeedKind::of(feed)).units(feed.value()) {
                    self.modal.feed_changes(feed, units);
                }
            }
            Disturbance::FeedKind(feed) => drop(self.modal.feed_kind_changes(FeedKind::of(feed))),
            Disturbance::Diameter => self.set_places(self.places, !self.diameter),
            Disturbance::Decimals(places) => self.set_places(Places::new(places), self.diameter),
            Disturbance::Side(side) => self.compensation.side = side,
            Disturbance::CuttingSpeed(on) => (self.modal.cutting_speed, self.modal.cuts_at_speed) = (on, on),
            Disturbance::Trusted => {
                let ends = *self.modal.at();
                self.modal.reach(crate::machine::AxisSet::MAIN, &ends);
            }
        }
    }
}
