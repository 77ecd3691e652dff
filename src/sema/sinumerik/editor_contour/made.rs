//! Contours of the contour editor, worked out from their records.
//!
//! In: the records between begin and end. Out: the NC blocks that the editor makes of them, to be compared with the
//! blocks that are there, or to take their place where they are missing. What the records leave open is not guessed.

use crate::geo::Point2;
use crate::ir::undercut::{Surface, Undercut};

/// An NC block of the contour: a corner point before rounding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ContourBlock {
    /// Abscissa and ordinate, mm, radius values.
    pub end: Point2,
    /// Centre and sense of an arc.
    pub arc: Option<(Point2, bool)>,
    /// The radius of an arc that was written by it, negative for the longer one.
    pub radius: Option<f64>,
    pub corner: Option<CornerWord>,
    /// Index of the record that made it.
    pub record: usize,
    /// Index of the record of its corner.
    pub corner_record: usize,
}

/// What a block says about the corner at its end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum CornerWord {
    /// `RND`
    Radius(f64),
    /// `CHR`
    Chamfer(f64),
    /// Without a word of its own: in the NC half it is lines with `RND`.
    Undercut(Undercut),
}

/// How the numbers of records are written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Written {
    /// Ordinates are diameters.
    pub diameter: bool,
    /// Millimetres in a unit of length.
    pub unit: f64,
}

/// The NC half of a contour.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Contour {
    pub start: Point2,
    /// Index of the record of the start point.
    pub start_record: usize,
    pub blocks: Vec<ContourBlock>,
    /// Records where the values leave two solutions and the choice is not stored, or not confirmed.
    pub chosen: Vec<usize>,
    /// Records of undercuts, and which facts they rest on that are not confirmed.
    pub doubts: Vec<(usize, String)>,
    /// Records of undercuts where nothing else tells that the material lies inside of the corner, and the side of the
    /// part that follows from it.
    pub assumed: Vec<(usize, Surface)>,
    /// Record of an undercut at the start of the contour.
    pub start_undercut: Option<usize>,
}

/// Why records make no contour. Each names the index of its record.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Unsolved {
    /// The contour has no start point, or a record before it.
    NoStart,
    TooLong,
    /// A code or key that is not known, such as the pole.
    Unknown(usize),
    /// The values do not determine the element.
    Open(usize),
    /// The values contradict each other.
    Contradiction(usize),
    /// An undercut that cannot be made.
    Undercut(usize, NoUndercut),
}

/// Why a record makes no undercut.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum NoUndercut {
    /// It stands beside an arc.
    Place,
    /// No size has this index.
    Index(u32),
    /// A thread undercut without a pitch, on a cylinder or in a bore of this diameter.
    PitchMissing { diameter: f64, surface: Surface },
    /// The table has no such pitch.
    Pitch(f64),
    /// The entry angle is missing, or not from 30 to 90 degrees.
    Entry(Option<f64>),
    /// At the start it begins with a rounding, on a line that is none.
    StartRounding,
    /// The keys of the free form are not known.
    Free,
    /// A thread undercut in a contour of inches, whose pitch may be in either unit.
    InchPitch,
    /// At the start of the contour, where what is in front of the corner is not known: no direction, or a rounding there.
    Start,
    /// The corner or its lines do not take it.
    Corner,
    /// A convex edge: the contour reaches the turning centre, so that it tells where the material lies.
    Convex,
    /// The material would lie on the other side than by an undercut before.
    Contradicts,
}

impl Unsolved {
    /// Index of the record at fault.
    pub(super) fn record(&self) -> Option<usize> {
        match self {
            Unsolved::NoStart | Unsolved::TooLong => None,
            Unsolved::Unknown(at) | Unsolved::Open(at) | Unsolved::Contradiction(at) | Unsolved::Undercut(at, _) => {
                Some(*at)
            }
        }
    }
}

impl Contour {
    /// From the unit of the program to mm. Undercuts are in mm already.
    pub(super) fn scaled(mut self, unit: f64) -> Contour {
        if unit == 1.0 {
            return self;
        }
        let point = |p: Point2| Point2::new(unit * p.x, unit * p.y);
        self.start = point(self.start);
        for block in &mut self.blocks {
            block.end = point(block.end);
            block.arc = block.arc.map(|(center, ccw)| (point(center), ccw));
            block.corner = block.corner.map(|corner| match corner {
                CornerWord::Radius(radius) => CornerWord::Radius(unit * radius),
                CornerWord::Chamfer(leg) => CornerWord::Chamfer(unit * leg),
                undercut @ CornerWord::Undercut(_) => undercut,
            });
        }
        self
    }
}
