//! Arguments of stock removal in layers: parallel cuts down to a contour, relief cuts, and the contour itself.

use core::fmt;

use crate::geo::element::quarters;
use crate::geo::profile::{Grown, LEVEL, Profile};
use crate::geo::{Element, Plane, Point2, Vec2};
use crate::ir::{Feed, Pos};

use super::Family;
use super::recess::{Operation, is_element, joined};
use super::roughing::{Corner, Nose};
use super::turning::{Towards, is_coordinate, is_length, is_point, is_positive};

/// Most elements of a contour.
pub const MOST_ELEMENTS: usize = 1000;

/// Least depth of a relief cut, mm: what the rounding of stored contours makes is none.
pub const LEAST_DIP: f64 = 0.005;

/// Stock removal in layers. Points are (Z, X) with X as a radius; all lengths in mm.
#[derive(Debug, Clone, PartialEq)]
pub struct Layers {
    /// The finished contour, from the side where the cuts begin to the other.
    pub contour: Vec<Element>,
    /// Infeed direction.
    pub into: Towards,
    /// Sense of the cutting axis in which the cuts run, 1 or -1.
    pub along: f64,
    /// The nose of the tool; its programmed point is what is sent.
    pub nose: Nose,
    /// The stock that is removed down to the contour.
    pub blank: Blank,
    /// Allowance that roughing leaves on the contour.
    pub allowance: Allowance,
    /// Greatest depth of a cut, over 0; finishing alone does not look at it.
    pub most: f64,
    /// Where the levels of the cuts lie.
    pub segmentation: Segmentation,
    /// What becomes of the steps between the cuts.
    pub trace: Trace,
    /// Interruptions of long cuts; `None` for cuts in one go.
    pub chips: Option<ChipBreaking>,
    /// Whether what falls behind a higher part is cut.
    pub relief: Relief,
    /// Borders beyond which nothing is machined.
    pub limits: Limits,
    /// Roughing, finishing or both.
    pub operation: Operation,
    /// Finishing runs from the far end of the contour to the end where the cuts begin.
    pub finish_backwards: bool,
    /// How far the tool lifts off, and where a cut begins.
    pub clearance: Clearance,
    /// Each over 0.
    pub feeds: LayerFeeds,
    /// Where the cycle begins and ends, (Z, X) with X as a radius, clear of the blank; [`Layers::parked`] says where
    /// the programmed point is then.
    pub home: Point2,
}

/// The stock above the contour.
#[derive(Debug, Clone, PartialEq)]
pub enum Blank {
    /// Its outline, in either direction; one element at least.
    Outline(Vec<Element>),
    /// This much on the contour along Z and X (radius), mm, 0 or more.
    On(Vec2),
    /// All between the contour and the place where the cycle begins.
    Corner(Corner),
}

/// What roughing leaves on the contour, in mm, 0 or more; the parts add up.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Allowance {
    /// Along Z and X (radius).
    pub axes: Vec2,
    /// On all sides, at right angles to the contour.
    pub around: f64,
}

/// Where the levels of the cuts lie.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Segmentation {
    /// At equal distances, all of them at most the greatest depth of a cut.
    #[default]
    Uniform,
    /// At the edges of the contour, equal between them.
    Edges,
}

/// What removes the steps between the cuts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Trace {
    /// Each cut goes on along the contour up to the level of the one before.
    #[default]
    Level,
    /// The same and one nose radius farther.
    Overlapping,
    /// One cut along the whole contour after the last one.
    Last,
    /// Nothing: the steps stay.
    None,
}

/// What interrupts a long cut to break the chip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChipBreaking {
    /// From one interruption to the next, in mm of the cut, over 0.
    pub every: f64,
    /// What the tool does there.
    pub by: Interruption,
}

/// How a cut is interrupted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Interruption {
    /// The tool waits so many seconds.
    Dwell(f64),
    /// The tool goes back so many mm at rapid, not beyond the start of the cut, and on at the feed.
    Retract(f64),
}

/// What becomes of parts of the contour that fall behind higher ones, seen along the cuts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Relief {
    /// They are left standing, level with the higher one.
    #[default]
    Left,
    /// They are cut from their falling side after the other cuts, where they are deeper than [`LEAST_DIP`].
    Cut,
}

/// Borders of the area that is machined: coordinates in mm, `None` where there is no border. Of a pair the order does
/// not matter. One alone comes with external cuts towards -Z only: the first one is then the border in front (Z) or the
/// smaller radius (X), the second one the other border.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Limits {
    /// Along Z.
    pub z: [Option<f64>; 2],
    /// Along X (radius).
    pub x: [Option<f64>; 2],
}

/// Distances of the tool in mm, over 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clearance {
    /// Along both axes when it lifts off the contour.
    pub lift: f64,
    /// In front of the blank where a cut begins.
    pub entry: f64,
}

/// Feeds of stock removal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LayerFeeds {
    /// Of roughing, lift-off included.
    pub rough: Feed,
    /// Down the falling side of a relief cut.
    pub plunge: Feed,
    /// Along the finished contour.
    pub finish: Feed,
}

/// An argument that describes no stock removal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LayersFault {
    /// No contour element, or more than [`MOST_ELEMENTS`].
    Elements,
    /// A coordinate of the contour, a limit or the place where the cycle begins is no number, or the sense of the cuts
    /// is none.
    Point,
    /// Neighbouring elements do not meet.
    Gap,
    /// The nose radius is negative, or its programmed point does not lie on the nose.
    Nose,
    /// The blank has no outline, an allowance below 0, or an infeed that is not over 0.
    Blank,
    /// The greatest depth of a cut is not over 0, and there is roughing.
    Most,
    /// An allowance is negative.
    Allowance,
    /// A clearance is not over 0.
    Clearance,
    /// A feed is not over 0.
    Feed,
    /// The distance of interruptions is not over 0.
    Chips,
}

impl fmt::Display for LayersFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            LayersFault::Elements => "the contour has 1 to 1000 elements",
            LayersFault::Point => "a point of the contour is not a number",
            LayersFault::Gap => "an element of the contour does not start where the one before ends",
            LayersFault::Nose => "the nose radius must not be negative, and its point lies on the nose",
            LayersFault::Blank => "the blank is not known",
            LayersFault::Most => "the greatest infeed must be over 0",
            LayersFault::Allowance => "an allowance must not be negative",
            LayersFault::Clearance => "a clearance must be over 0",
            LayersFault::Feed => "a feed must be over 0",
            LayersFault::Chips => "the way between two interruptions must be over 0",
        })
    }
}

impl Family for Layers {
    type Fault = LayersFault;

    fn check(&self) -> Result<(), LayersFault> {
        let unit = |v: f64| v == -1.0 || v == 0.0 || v == 1.0;
        let nose = is_length(self.nose.radius) && unit(self.nose.tip.x) && unit(self.nose.tip.y);
        let blank = match &self.blank {
            Blank::Outline(list) => !list.is_empty() && list.iter().all(is_element),
            Blank::On(by) => is_length(by.x) && is_length(by.y),
            Blank::Corner(corner) => corner.infeed.is_none_or(|feed| is_positive(feed.value())),
        };
        let allowance = [self.allowance.axes.x, self.allowance.axes.y, self.allowance.around];
        let limits = self.limits.z.iter().chain(&self.limits.x).flatten();
        let feeds = [self.feeds.rough, self.feeds.plunge, self.feeds.finish];
        let rules = [
            ((1..=MOST_ELEMENTS).contains(&self.contour.len()), LayersFault::Elements),
            (self.contour.iter().all(is_element) && is_point(self.home), LayersFault::Point),
            (limits.copied().all(is_coordinate) && self.along.abs() == 1.0, LayersFault::Point),
            (joined(&self.contour), LayersFault::Gap),
            (nose, LayersFault::Nose),
            (blank, LayersFault::Blank),
            (is_positive(self.most) || self.operation == Operation::Finish, LayersFault::Most),
            (allowance.into_iter().all(is_length), LayersFault::Allowance),
            (is_positive(self.clearance.lift) && is_positive(self.clearance.entry), LayersFault::Clearance),
            (feeds.iter().all(|feed| is_positive(feed.value())), LayersFault::Feed),
            (self.chips.is_none_or(|chips| is_positive(chips.every)), LayersFault::Chips),
        ];
        rules.iter().find(|(good, _)| !good).map_or(Ok(()), |(_, fault)| Err(*fault))
    }

    fn leaves(&self, at: &mut Pos) {
        match &self.blank {
            Blank::Corner(Corner { back: false, .. }) => self.leaves_beside(at),
            Blank::Outline(_) | Blank::On(_) | Blank::Corner(_) => at.set_in_plane(Plane::Zx, self.parked()),
        }
    }
}

impl Layers {
    /// Where the programmed point of the tool begins and ends, (Z, X) with X as a radius. A nose that reaches lower
    /// than its programmed point stands as much higher.
    pub fn parked(&self) -> Point2 {
        let into = self.into.unit();
        self.home - into * (self.nose.radius * (1.0 - self.nose.tip.dot(&into)))
    }

    /// Direction of the cuts as (Z, X), of length 1.
    pub fn side_of_cuts(&self) -> Vec2 {
        if self.into.is_radial() { Vec2::new(self.along, 0.0) } else { Vec2::new(0.0, self.along) }
    }

    /// Does the programmed point of the nose lie behind its centre, seen along the cuts?
    pub fn points_back(&self) -> bool {
        self.nose.radius > 0.0 && self.nose.tip.dot(&self.side_of_cuts()) < 0.0
    }

    /// The contour with the cuts towards +x and the infeed towards -y.
    pub(super) fn seen(&self) -> Vec<Element> {
        let out = -(self.into.unit().x + self.into.unit().y);
        let (along, radial) = (self.along, self.into.is_radial());
        let point = |p: Point2| {
            if radial { Point2::new(p.x * along, p.y * out) } else { Point2::new(p.y * along, p.x * out) }
        };
        let mirrors = (along * out < 0.0) == radial;
        let element = |element: &Element| match *element {
            Element::Line { from, to } => Element::Line { from: point(from), to: point(to) },
            Element::Arc { from, to, center, sweep } => Element::Arc {
                from: point(from),
                to: point(to),
                center: point(center),
                sweep: if mirrors { -sweep } else { sweep },
            },
        };
        self.contour.iter().map(element).collect()
    }

    /// Where the contour falls behind a higher part: coordinates of both ends along the cutting axis, the one where the
    /// cuts come from first.
    pub fn reliefs(&self) -> Vec<(f64, f64)> {
        let chain = self.seen();
        let Some(start) = chain.first().map(Element::from) else { return Vec::new() };
        let outline = Profile::new(&chain, Grown::default());
        let dips = outline.dips(start, f64::INFINITY, LEAST_DIP);
        dips.iter().map(|dip| (dip.left * self.along, dip.right * self.along)).collect()
    }

    /// Angle to the direction of the cuts at which the contour falls most steeply, in degrees; 0 where it does not
    /// fall.
    pub fn steepest_fall(&self) -> f64 {
        let falls = |element: &Element| element.from().y - element.to().y > LEAST_DIP;
        let steep = |way: Option<Vec2>| way.map_or(0.0, |way| libm::atan2(-way.y, way.x).to_degrees());
        let parts = self.seen();
        let falling = parts.iter().flat_map(quarters).filter(falls);
        falling.map(|part| steep(part.start_direction()).max(steep(part.end_direction()))).fold(0.0, f64::max)
    }

    /// Does a part of the contour lean over, out of the reach of the cuts?
    pub fn leans_over(&self) -> bool {
        self.seen().iter().flat_map(quarters).any(|element| element.to().x < element.from().x - LEVEL)
    }
}
