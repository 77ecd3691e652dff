//! A working plane that stands at an angle to the workpiece, and what the rotary axes do about it.
//!
//! Both streams count in the plane while one is on. Which rotary axes turn, and how far, is for the machine.

use nalgebra::{Matrix3, Vector3};

use crate::machine::{Axis, AxisSet};

use super::Pos;

/// A tilted working plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tilt {
    /// Its columns are the axes X, Y and Z of the plane in workpiece coordinates: of unit length, at right angles,
    /// right-handed.
    pub axes: Matrix3<f64>,
    /// The zero point of the plane in workpiece coordinates, mm.
    pub origin: Vector3<f64>,
    /// Which of two positions the rotary axes take.
    pub solution: Solution,
}

/// Most planes are reached by two positions of the rotary axes. The part is the same, the room is not.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Solution {
    /// The control chooses, as it does where the program says nothing.
    #[default]
    Control,
    /// The axis next to the tool gets a positive angle, or a negative one (SEQ).
    Primary {
        /// It is the positive one.
        positive: bool,
    },
    /// The reference axis of the swivel record gets the greater value, or the smaller one (_DIR).
    Reference {
        /// It is the greater one.
        greater: bool,
    },
}

/// What becomes of the working plane. Behind each of them no main axis is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Tilting {
    /// The rotary axes turn until the tool stands along Z of the plane; positions count in the plane from here on.
    Into(Tilt),
    /// They turn back until it stands along Z of the workpiece, in which positions count from here on.
    Back(Solution),
    /// Positions count in the workpiece again, and the rotary axes stay: no main axis moves but in machine coordinates before
    /// they stand as at the start of the program.
    Off,
}

impl Tilting {
    /// Do rotary axes turn?
    pub fn turns(&self) -> bool {
        !matches!(self, Tilting::Off)
    }

    /// The plane in which positions count from here on.
    pub fn plane(&self) -> Option<&Tilt> {
        match self {
            Tilting::Into(tilt) => Some(tilt),
            Tilting::Back(_) | Tilting::Off => None,
        }
    }
}

impl Tilt {
    /// Workpiece coordinates of a place of the plane; none of the main axes where one that it needs is unknown.
    pub fn in_workpiece(&self, at: &Pos) -> Pos {
        let mut place = *at;
        for to in AxisSet::MAIN.iter() {
            place.forget(to);
            let row = self.axes.row(to.index());
            let sum = AxisSet::MAIN.iter().try_fold(self.origin[to.index()], |sum, from| {
                let factor = row[from.index()];
                if factor == 0.0 { Some(sum) } else { at.get(from).map(|v| sum + factor * v) }
            });
            if let Some(value) = sum {
                place.set(to, value);
            }
        }
        place
    }

    /// A direction of the plane in workpiece coordinates.
    pub fn direction(&self, axis: Axis) -> Vector3<f64> {
        self.axes.column(axis.index()).into_owned()
    }
}
