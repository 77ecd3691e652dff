//! Arguments of grooving: a groove plunged by strokes side by side, and finished in two halves.

use core::fmt;

use crate::geo::{Element, Point2};
use crate::ir::{Feed, Pos};

use super::Family;
use super::recess::{MOST_ELEMENTS, Operation, RecessTool, is_element, joined};
use super::turning::{Towards, is_coordinate, is_length, is_positive};

/// Most grooves of one call.
pub const MOST_GROOVES: u32 = 10_000;

/// One groove, or several beside each other. Points are (Z, X) with X as a radius; all lengths in mm.
#[derive(Debug, Clone, PartialEq)]
pub struct Grooving {
    /// The finished groove from rim to rim: it falls to its floor and rises again, seen from the tool. It begins at
    /// the rim of the reference point: there the tool stands afterwards.
    pub contour: Vec<Element>,
    /// How far the chamfer or rounding at the first rim of `contour` and at the last one reaches below the surface; 0
    /// for a sharp rim.
    pub rims: [f64; 2],
    /// Infeed direction: the plunges go this way.
    pub into: Towards,
    /// The grooving tool.
    pub tool: RecessTool,
    /// Coordinate of the surface on the infeed axis (X radius or Z); both rims lie on it and nothing stands above it.
    pub surface: f64,
    /// What roughing leaves on the contour, and finishing takes off.
    pub allowance: GrooveAllowance,
    /// Greatest distance of two plunges, over 0 and at most the cutting width.
    pub spacing: f64,
    /// Whether a plunge breaks its chip.
    pub plunges: Plunges,
    /// Dwell of each plunge that reaches the floor, in seconds, 0 or more.
    pub dwell: f64,
    /// Roughing, finishing or both; all of it groove by groove.
    pub operation: Operation,
    /// Clear height above the surface, over 0; the tool travels there.
    pub clearance: f64,
    /// Each over 0.
    pub feeds: GrooveFeeds,
    /// How many equal grooves there are, and where the others lie.
    pub copies: Copies,
}

/// What roughing leaves, in mm: `around` everywhere; in addition the walls are moved together and all of it is raised.
/// A wall that leans may be moved outwards, because raising the floor moves it, too.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct GrooveAllowance {
    /// Square to the contour, not negative.
    pub around: f64,
    /// How far the first wall and the last one of the contour move towards each other along the surface; a negative one
    /// moves away.
    pub walls: [f64; 2],
    /// How far all of it rises; not negative.
    pub depth: f64,
}

/// How deep each plunge goes at once. Lengths in mm, over 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Plunges {
    /// To its full depth.
    Whole,
    /// In equal steps of at most `most`, with a lift by `retract` between them that breaks the chip, at rapid.
    Steps { most: f64, retract: f64 },
    /// The two in the middle in turns, each step `most` deeper than the last one beside it; the others to their full
    /// depth. A single one as [`Plunges::Steps`], with the same `retract`.
    Alternating { most: f64, retract: f64 },
}

/// Feeds of grooving.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GrooveFeeds {
    /// Of the plunges that rough.
    pub plunge: Feed,
    /// Along the finished contour.
    pub finish: Feed,
}

/// Equal grooves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Copies {
    /// How many, from 1 to [`MOST_GROOVES`]; the first one is the contour as it is given.
    pub count: u32,
    /// From one to the next on the cutting axis, mm, signed.
    pub distance: f64,
}

impl Copies {
    /// A single groove.
    pub const ONE: Copies = Copies { count: 1, distance: 0.0 };
}

/// An argument that describes no groove.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GrooveFault {
    /// No contour element, or too many.
    Elements,
    /// A coordinate is not a finite number.
    Point,
    /// Neighbouring elements do not meet.
    Gap,
    /// The cutting width is not over 0.
    Width,
    /// The nose radius is negative or over half the width.
    Nose,
    /// The place of the cutting edge is no number.
    Edge,
    /// The rims do not lie on the surface.
    Surface,
    /// An allowance is negative where it must not be, or no number.
    Allowance,
    /// The distance of plunges is not over 0 or over the cutting width.
    Spacing,
    /// A step or a retract is not over 0.
    Plunges,
    /// The dwell is negative.
    Dwell,
    /// The clearance is not over 0.
    Clearance,
    /// A feed is not over 0.
    Feed,
    /// There is no groove, or more than [`MOST_GROOVES`], or their distance is no number.
    Copies,
}

impl fmt::Display for GrooveFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            GrooveFault::Elements => "the contour of a groove has 1 to 100 elements",
            GrooveFault::Point => "a point of the groove is not a number",
            GrooveFault::Gap => "an element of the groove does not start where the one before ends",
            GrooveFault::Width => "the cutting width of the tool must be over 0",
            GrooveFault::Nose => "the nose radius must lie between 0 and half the cutting width",
            GrooveFault::Edge => "the reference point of the tool is not known",
            GrooveFault::Surface => "the rims of the groove do not lie on its surface",
            GrooveFault::Allowance => "the allowance must not be negative",
            GrooveFault::Spacing => "the distance of plunges must be over 0 and at most the cutting width",
            GrooveFault::Plunges => "the infeed and its retract must be over 0",
            GrooveFault::Dwell => "the dwell must not be negative",
            GrooveFault::Clearance => "the clearance must be over 0",
            GrooveFault::Feed => "a feed must be over 0",
            GrooveFault::Copies => "the number of grooves must be from 1 to 10000",
        })
    }
}

/// Rims may lie this far from the surface, mm: what arithmetic loses.
const ON_SURFACE: f64 = 1e-6;

impl Family for Grooving {
    type Fault = GrooveFault;

    fn check(&self) -> Result<(), GrooveFault> {
        let tool = &self.tool;
        let feeds = [self.feeds.plunge, self.feeds.finish];
        let [first, last] = self.allowance.walls;
        let rules = [
            ((1..=MOST_ELEMENTS).contains(&self.contour.len()), GrooveFault::Elements),
            (self.contour.iter().all(is_element), GrooveFault::Point),
            (joined(&self.contour), GrooveFault::Gap),
            (is_positive(tool.width), GrooveFault::Width),
            (is_length(tool.nose) && tool.nose <= tool.width / 2.0, GrooveFault::Nose),
            (is_coordinate(tool.edge), GrooveFault::Edge),
            (self.heights_of_rims().iter().all(|rim| (rim - self.surface).abs() <= ON_SURFACE), GrooveFault::Surface),
            (self.rims.into_iter().all(is_length), GrooveFault::Surface),
            (is_coordinate(first) && is_coordinate(last), GrooveFault::Allowance),
            (is_length(self.allowance.depth) && is_length(self.allowance.around), GrooveFault::Allowance),
            (is_positive(self.spacing) && self.spacing <= tool.width, GrooveFault::Spacing),
            (self.plunges.is_possible(), GrooveFault::Plunges),
            (is_length(self.dwell), GrooveFault::Dwell),
            (is_positive(self.clearance), GrooveFault::Clearance),
            (feeds.iter().all(|feed| is_positive(feed.value())), GrooveFault::Feed),
            ((1..=MOST_GROOVES).contains(&self.copies.count), GrooveFault::Copies),
            (is_coordinate(self.copies.distance), GrooveFault::Copies),
        ];
        rules.iter().find(|(good, _)| !good).map_or(Ok(()), |(_, fault)| Err(*fault))
    }

    fn leaves(&self, at: &mut Pos) {
        let (infeed, cutting) = self.into.axes();
        at.set(infeed, self.clear());
        at.set(cutting, self.park());
    }
}

impl Plunges {
    fn is_possible(self) -> bool {
        match self {
            Plunges::Whole => true,
            Plunges::Steps { most, retract } | Plunges::Alternating { most, retract } => {
                is_positive(most) && is_positive(retract)
            }
        }
    }
}

impl Grooving {
    fn ends(&self) -> [Point2; 2] {
        let first = self.contour.first().map_or(Point2::origin(), Element::from);
        [first, self.contour.last().map_or(first, Element::to)]
    }

    fn heights_of_rims(&self) -> [f64; 2] {
        self.ends().map(|end| self.into.depth_coordinate(end))
    }

    /// Does the contour run towards minus on the cutting axis?
    pub fn runs_towards_minus(&self) -> bool {
        let [first, last] = self.ends().map(|end| self.into.cutting_coordinate(end));
        last < first
    }

    /// Coordinate of the clear height on the infeed axis (X radius or Z).
    pub fn clear(&self) -> f64 {
        match self.into {
            Towards::MinusX | Towards::MinusZ => self.surface + self.clearance,
            Towards::PlusX | Towards::PlusZ => self.surface - self.clearance,
        }
    }

    /// Where the programmed point of the tool stands afterwards on the cutting axis: its edge is flush with the rim of the
    /// reference point.
    pub fn park(&self) -> f64 {
        let rim = self.into.cutting_coordinate(self.ends()[0]);
        let edge = if self.runs_towards_minus() { rim - self.tool.width } else { rim };
        edge - self.tool.edge
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::ir::cycle::recess::tests::lines;

    /// Groove Z-20 to Z-32 in a shaft of 40, 6 deep, seen from its right rim; tool 4 wide, its left corner programmed.
    pub(crate) fn groove() -> Grooving {
        Grooving {
            contour: lines(&[(-20.0, 40.0), (-20.0, 28.0), (-32.0, 28.0), (-32.0, 40.0)]),
            rims: [0.0; 2],
            into: Towards::MinusX,
            tool: RecessTool { width: 4.0, nose: 0.2, edge: 0.0 },
            surface: 20.0,
            allowance: GrooveAllowance { around: 0.1, ..GrooveAllowance::default() },
            spacing: 3.2,
            plunges: Plunges::Steps { most: 2.0, retract: 1.0 },
            dwell: 0.0,
            operation: Operation::RoughAndFinish,
            clearance: 1.0,
            feeds: GrooveFeeds { plunge: Feed::PerRevolution(0.08), finish: Feed::PerRevolution(0.05) },
            copies: Copies::ONE,
        }
    }

    #[test]
    fn every_bad_argument_has_its_name() {
        type Spoil = fn(&mut Grooving);
        let cases: &[(GrooveFault, Spoil)] = &[
            (GrooveFault::Elements, |g| g.contour.clear()),
            (GrooveFault::Elements, |g| g.contour = vec![g.contour[0]; 101]),
            (GrooveFault::Point, |g| g.contour = lines(&[(0.0, f64::NAN), (0.0, 1.0)])),
            (GrooveFault::Gap, |g| {
                let _ = g.contour.remove(1);
            }),
            (GrooveFault::Width, |g| g.tool.width = 0.0),
            (GrooveFault::Nose, |g| g.tool.nose = 2.1),
            (GrooveFault::Edge, |g| g.tool.edge = f64::NAN),
            (GrooveFault::Surface, |g| g.surface = 20.1),
            (GrooveFault::Allowance, |g| g.allowance.depth = -0.1),
            (GrooveFault::Allowance, |g| g.allowance.around = -0.1),
            (GrooveFault::Allowance, |g| g.allowance.walls[1] = f64::NAN),
            (GrooveFault::Spacing, |g| g.spacing = 4.1),
            (GrooveFault::Plunges, |g| g.plunges = Plunges::Steps { most: 0.0, retract: 1.0 }),
            (GrooveFault::Plunges, |g| g.plunges = Plunges::Alternating { most: 1.0, retract: 0.0 }),
            (GrooveFault::Dwell, |g| g.dwell = -1.0),
            (GrooveFault::Clearance, |g| g.clearance = 0.0),
            (GrooveFault::Feed, |g| g.feeds.finish = Feed::PerRevolution(0.0)),
            (GrooveFault::Copies, |g| g.copies.count = 0),
            (GrooveFault::Copies, |g| g.copies.distance = f64::NAN),
        ];
        assert_eq!(groove().check(), Ok(()));
        for (fault, spoil) in cases {
            let mut groove = groove();
            spoil(&mut groove);
            assert_eq!(groove.check(), Err(*fault));
        }
    }
}
