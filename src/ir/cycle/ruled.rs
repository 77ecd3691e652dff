//! Arguments of ruled surfaces: straight rows from one edge to the other, to and fro.

use core::fmt;

use crate::geo::{Point2, distance};
use crate::ir::{Feed, Pos};

use super::Family;
use super::milling::{Mill, MillFault};

/// Most rows; more is a lost decimal point.
pub const MOST_ROWS: u32 = 10_000;
/// Rows whose ends lie nearer are none, mm.
const NOTHING: f64 = 1e-9;

/// A surface between two edges.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ruled {
    /// The surface of its heights is the highest corner, their depth the lowest one.
    pub mill: Mill,
    /// Where the first row begins and ends, and where the last one does; the other rows lie evenly between.
    pub corners: [[Corner; 2]; 2],
    /// From 2 to [`MOST_ROWS`].
    pub rows: u32,
    /// Feed of the first row, and of the infeed to it, above 0; the other rows take that of the plane.
    pub first: Feed,
}

/// A point of the plane, and its height.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corner {
    /// In coordinates of the plane, mm.
    pub at: Point2,
    /// Coordinate along the tool axis, mm.
    pub height: f64,
}

/// Arguments that make no surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RuledFault {
    /// Plane, heights, cutter or feeds.
    Mill(MillFault),
    /// A coordinate of a corner is no finite number.
    Number,
    /// Less than 2 rows, or more than [`MOST_ROWS`].
    Rows,
    /// First and last row are points.
    Size,
}

impl fmt::Display for RuledFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            RuledFault::Mill(fault) => return fault.fmt(f),
            RuledFault::Number => "a corner of the surface is not a number",
            RuledFault::Rows => "a surface has 2 rows at least, and 10,000 at most",
            RuledFault::Size => "the first and the last row have no length",
        })
    }
}

impl Corner {
    /// Is it the same place, to what arithmetic loses?
    pub fn is(&self, other: &Corner) -> bool {
        distance(self.at, other.at) <= NOTHING && (self.height - other.height).abs() <= NOTHING
    }

    fn towards(&self, other: &Corner, part: f64) -> Corner {
        Corner { at: self.at + (other.at - self.at) * part, height: self.height + (other.height - self.height) * part }
    }
}

impl Ruled {
    /// A row, counted from 0, from where the tool begins it: every other one leads back.
    pub fn row(&self, index: u32) -> [Corner; 2] {
        let [first, last] = &self.corners;
        let part = f64::from(index) / f64::from(self.rows - 1);
        let ends = if index + 1 == self.rows { *last } else { [0, 1].map(|i| first[i].towards(&last[i], part)) };
        if index % 2 == 1 { [ends[1], ends[0]] } else { ends }
    }
}

impl Family for Ruled {
    type Fault = RuledFault;

    fn check(&self) -> Result<(), RuledFault> {
        let corners = || self.corners.iter().flatten();
        if !corners().all(|c| c.at.x.is_finite() && c.at.y.is_finite() && c.height.is_finite()) {
            return Err(RuledFault::Number);
        }
        self.mill.check().map_err(RuledFault::Mill)?;
        if !(2..=MOST_ROWS).contains(&self.rows) {
            Err(RuledFault::Rows)
        } else if self.first.value() <= 0.0 {
            Err(RuledFault::Mill(MillFault::Feed))
        } else if self.corners.iter().all(|[from, to]| from.is(to)) {
            Err(RuledFault::Size)
        } else {
            Ok(())
        }
    }

    fn moves(&self) -> f64 {
        2.0 * f64::from(self.rows)
    }

    /// Above the end of the last row.
    fn leaves(&self, at: &mut Pos) {
        let [_, end] = self.row(self.rows - 1);
        self.mill.leaves_above(end.at, at);
    }
}
