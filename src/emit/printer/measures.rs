//! How the numbers of each quantity are written.

use crate::machine::OutputSettings;
use crate::machine::settings::{Quantity, Units};
use crate::target::Form;

use super::super::number::Places;

/// Quantities besides lengths.
#[derive(Debug, Clone, Copy)]
pub(super) struct Measures {
    pub angle: Places,
    pub feed: Places,
    pub feed_per_revolution: Places,
    pub inverse_time: Places,
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
