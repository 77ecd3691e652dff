//! Arguments of the undercut cycle: one finishing cut along an undercut, in depth steps if wanted.

use core::fmt;

use crate::geo::undercut::{Allowance, Fault, Orientation, Shape};
use crate::geo::{Point2, Vec2};
use crate::ir::{Feed, Pos, Side};

use super::Family;
use super::roughing::Nose;
use super::turning::is_coordinate;

/// An undercut cut by itself. Points are (Z, X) with X as a radius, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UndercutCycle {
    /// Where cylinder and face meet, without allowance, (Z, X) with X as a radius.
    pub corner: Point2,
    /// Sense along Z in which the cylinder leaves the corner, and along X in which the face does. `first_leads` is
    /// not looked at: the cut always goes along the cylinder to the face.
    pub orientation: Orientation,
    /// The finished undercut; its slope lies on the cylinder.
    pub shape: Shape,
    /// Allowance that the cylinder (`reference`) and the face (`other`) still carry, mm, 0 or more.
    pub allowance: Allowance,
    /// Distance to the part at rapid, mm, over 0.
    pub clearance: f64,
    /// The face is cut up to here (X as a radius); `None`: to the end of the undercut and the clearance on.
    pub face_end: Option<f64>,
    /// Of all cuts, above 0.
    pub feed: Feed,
    /// Greatest depth of a cut in mm, above 0; `None` for the finishing cut alone.
    pub step: Option<f64>,
    /// What the depth steps leave on the finished undercut.
    pub leave: Leave,
    /// A finishing cut follows the depth steps; without it there are depth steps.
    pub finishing: bool,
    /// The output selects radius compensation, and its receiver makes the path of the nose.
    pub compensated: bool,
    /// The nose that runs along the undercut; its programmed point is printed. Not looked at where the receiver compensates.
    pub nose: Nose,
}

/// An allowance; lengths in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Leave {
    /// `z` along Z and `x` along X (radius), 0 or more: floor, face and slope are moved out of the material along both.
    /// `x` is less than the depth of the undercut.
    Along { z: f64, x: f64 },
    /// The same everywhere, less than the depth of the undercut: its lines lie parallel to those of the finished one.
    Around(f64),
}

impl Leave {
    /// No allowance.
    pub const NOTHING: Leave = Leave::Along { z: 0.0, x: 0.0 };

    fn is_possible(self, depth: f64) -> bool {
        let good = |v: f64| (0.0..depth).contains(&v);
        match self {
            Leave::Along { z, x } => z >= 0.0 && z.is_finite() && good(x),
            Leave::Around(all) => good(all),
        }
    }

    /// Do the depth steps go down to the finished undercut?
    pub fn is_nothing(self) -> bool {
        matches!(self, Leave::Along { z: 0.0, x: 0.0 } | Leave::Around(0.0))
    }
}

/// Arguments that make no undercut cut.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum UndercutFault {
    /// A value is not a number.
    Number,
    /// The clearance is not above 0.
    Clearance,
    /// The feed is not above 0.
    Feed,
    /// The depth step is not over 0.
    Step,
    /// The finishing allowance is negative, or as large as the depth.
    Finish,
    /// Neither depth steps nor a finishing cut.
    Nothing,
    /// The end of the face lies inside the undercut.
    FaceEnd,
    /// The nose radius is negative, or its programmed point does not lie on it.
    Nose,
    /// The programmed point of the nose lies on the side away from the cylinder or from the face.
    Edge,
    /// The undercut itself.
    Shape(Fault),
}

impl fmt::Display for UndercutFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            UndercutFault::Number => "a value of the undercut is not a number",
            UndercutFault::Clearance => "the safety distance must be over 0",
            UndercutFault::Feed => "the feed must be over 0",
            UndercutFault::Step => "the depth of a cut must be over 0",
            UndercutFault::Finish => "the finishing allowance must be less than the depth of the undercut",
            UndercutFault::Nothing => "neither roughing nor finishing is asked for",
            UndercutFault::FaceEnd => "the face ends inside the undercut",
            UndercutFault::Nose => "the nose radius must not be negative",
            UndercutFault::Edge => "the edge of the tool points away from the corner of the undercut",
            UndercutFault::Shape(Fault::Dimension) => "a depth, width or radius of the undercut is no positive number",
            UndercutFault::Shape(Fault::Angle) => "an angle of the undercut is out of range",
            UndercutFault::Shape(_) => "slope, floor and roundings do not fit into the undercut",
        })
    }
}

impl Family for UndercutCycle {
    type Fault = UndercutFault;

    fn check(&self) -> Result<(), UndercutFault> {
        let positive = |v: f64| v > 0.0 && v.is_finite();
        let numbers = [self.corner.x, self.corner.y, self.allowance.reference, self.allowance.other];
        let sense = |v: f64| v == 1.0 || v == -1.0;
        let rules = [
            (numbers.iter().all(|v| v.is_finite()), UndercutFault::Number),
            (self.allowance.reference >= 0.0 && self.allowance.other >= 0.0, UndercutFault::Number),
            (self.face_end.is_none_or(f64::is_finite), UndercutFault::Number),
            (sense(self.orientation.first) && sense(self.orientation.second), UndercutFault::Number),
            (positive(self.clearance), UndercutFault::Clearance),
            (positive(self.feed.value()), UndercutFault::Feed),
            (self.step.is_none_or(positive), UndercutFault::Step),
            (self.leave.is_possible(self.shape.depth()), UndercutFault::Finish),
            (self.step.is_some() || self.finishing, UndercutFault::Nothing),
            (self.compensated || self.nose_is_possible(), UndercutFault::Nose),
            (self.compensated || self.tip().x <= 0.0 && self.tip().y <= 0.0, UndercutFault::Edge),
        ];
        if let Some((_, fault)) = rules.iter().find(|(good, _)| !good) {
            return Err(*fault);
        }
        self.shape.check().map_err(UndercutFault::Shape)
    }

    /// It ends where it starts.
    fn leaves(&self, _: &mut Pos) {}
}

impl UndercutCycle {
    fn nose_is_possible(&self) -> bool {
        let unit = |v: f64| v == -1.0 || v == 0.0 || v == 1.0;
        self.nose.radius >= 0.0 && is_coordinate(self.nose.radius) && unit(self.nose.tip.x) && unit(self.nose.tip.y)
    }

    /// From the centre of the nose to the programmed point, along the cylinder and along the face, both away from the corner; in mm.
    pub fn tip(&self) -> Vec2 {
        let tip = self.nose.tip * self.nose.radius;
        Vec2::new(tip.x * self.orientation.first, tip.y * self.orientation.second)
    }

    /// Side on which the nose is compensated: the tool stays outside the part.
    pub fn side(&self) -> Side {
        match (self.compensated, self.orientation.first * self.orientation.second > 0.0) {
            (false, _) => Side::None,
            (true, true) => Side::Right,
            (true, false) => Side::Left,
        }
    }
}
