//! The blank, as its section describes it.

use crate::diag::codes;
use crate::ir;
use crate::machine::Axis;
use crate::sema::run::refusal::{Made, refused};

use super::words::{Words, letters};

/// Raw stock.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Blank {
    /// G20: radius, length, Z of the right face, radius of the bore.
    Bar { radius: f64, length: f64, right: f64, bore: f64 },
    /// G21: oversize on the finished contour, with a bore or without.
    Casting { oversize: f64, bore: bool },
}

impl Blank {
    /// G20
    pub fn bar(w: &Words, mm: f64) -> Made<Blank> {
        let diameter = w.needed_length(b'X', mm, "the diameter of the bar")?;
        let length = w.needed_length(b'Z', mm, "the length of the bar")?;
        let bore = w.value(b'I').unwrap_or(0.0) * mm;
        if bore < 0.0 || bore >= diameter {
            return refused(w.place(b'I'), codes::T1007::bore_of_tube_is_smaller_than_tube());
        }
        let right = w.value(b'K').unwrap_or(0.0) * mm;
        Ok(Blank::Bar { radius: diameter / 2.0, length, right, bore: bore / 2.0 })
    }

    /// G21
    pub fn casting(w: &Words, mm: f64) -> Made<Blank> {
        let oversize = w.needed_length(b'P', mm, "the oversize of the casting")?;
        Ok(Blank::Casting { oversize, bore: w.choice(b'Q', 0, 1)? == 1 })
    }

    /// The words that its block may hold.
    pub fn words(number: u16) -> super::words::Letters {
        if number == 20 { letters("XZKI") } else { letters("PQ") }
    }

    /// What is shown of it.
    pub fn shown(self) -> Option<ir::Blank> {
        let Blank::Bar { radius, length, right, bore } = self else { return None };
        Some(ir::Blank::Round { axis: Axis::Z, radius, bore, low: right - length, high: right })
    }
}
