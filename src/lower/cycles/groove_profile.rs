//! A groove as a recessing tool sees it: between two walls that fall to one floor.

use crate::diag::{Fault, codes};
use crate::geo::element::quarters;
use crate::geo::nose_profile::{NoProfile, NoseProfile};
use crate::geo::offset::shifted;
use crate::geo::profile::Leg;
use crate::geo::{Element, Point2, Vec2, left};

/// Heights closer than this belong to the floor, mm: half a unit of the fourth decimal is far more.
const LEVEL: f64 = 1e-6;

/// The contour in its view, cut at its floor. Both walls fall towards +x; the second is seen in a mirror.
#[derive(Debug, Clone, PartialEq)]
pub struct GrooveProfile {
    first: Vec<Element>,
    second: Vec<Element>,
    floor: f64,
}

/// What is left on a groove.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Oversize {
    /// Square to the contour.
    pub around: f64,
    /// How far the first and the second wall move towards each other.
    pub along: [f64; 2],
    /// How far all moves out of the material.
    pub up: f64,
}

/// What lies above the rims of a groove.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Above {
    /// The walls go on straight up.
    Material,
    /// Nothing: the noses come down beside the rim.
    Nothing,
}

/// Why a contour is no groove.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NoGroove {
    /// It has more than one floor, or rises before it falls.
    Waves,
    /// A wall leans over.
    Leans,
    /// It begins or ends at its floor.
    Open,
}

impl NoGroove {
    /// Why a contour is not one recess or groove, as its cycle calls it.
    pub fn refused(self, name: &str) -> Fault {
        match self {
            NoGroove::Waves => codes::G3044::contour_is_not_one(&name),
            NoGroove::Leans => codes::G3044::wall_leans_over(&name),
            NoGroove::Open => codes::G3044::contour_begins_or_ends_at_floor(&name),
        }
    }
}

/// The same element run through backwards and seen in a mirror, so that it falls where it rose.
fn mirrored(element: &Element) -> Element {
    let mirror = |p: Point2| Point2::new(-p.x, p.y);
    match *element {
        Element::Line { from, to } => Element::Line { from: mirror(to), to: mirror(from) },
        Element::Arc { from, to, center, sweep } => {
            Element::Arc { from: mirror(to), to: mirror(from), center: mirror(center), sweep }
        }
    }
}

impl GrooveProfile {
    /// Cuts `contour`, given in the view, at its floor.
    ///
    /// # Errors
    /// See [`NoGroove`].
    pub fn new(contour: &[Element]) -> Result<GrooveProfile, NoGroove> {
        let pieces: Vec<Element> = contour.iter().flat_map(quarters).collect();
        let floor = pieces.iter().map(|p| p.from().y.min(p.to().y)).fold(f64::INFINITY, f64::min);
        let low = |p: Point2| p.y <= floor + LEVEL;
        let (Some(start), Some(end)) = (pieces.first(), pieces.last()) else { return Err(NoGroove::Open) };
        if low(start.from()) || low(end.to()) {
            return Err(NoGroove::Open);
        }
        let falls = pieces.iter().position(|p| low(p.to())).map_or(pieces.len(), |i| i + 1);
        let rises = pieces.iter().rposition(|p| low(p.from())).unwrap_or(0);
        let between = pieces.get(falls..rises).unwrap_or_default();
        if !between.iter().all(|p| matches!(p, Element::Line { .. }) && low(p.from()) && low(p.to())) {
            return Err(NoGroove::Waves);
        }
        let first = pieces[..falls.min(pieces.len())].to_vec();
        let second: Vec<Element> = pieces[rises..].iter().rev().map(mirrored).collect();
        // The floor may be off the level by what arithmetic loses; both walls reach down to it.
        let foot = |chain: &[Element]| chain.last().map_or(floor, |e| e.to().y);
        let floor = foot(&first).max(foot(&second));
        let groove_profile = GrooveProfile { first, second, floor };
        // A nose of no radius tells whether the walls are walls.
        for chain in [&groove_profile.first, &groove_profile.second] {
            NoseProfile::new(chain, 0.0).map_err(|why| match why {
                NoProfile::Rises if chain.iter().any(|e| e.to().y > e.from().y + LEVEL) => NoGroove::Waves,
                NoProfile::Rises => NoGroove::Leans,
                NoProfile::Gap | NoProfile::Empty => NoGroove::Open,
            })?;
        }
        Ok(groove_profile)
    }

    /// The groove for a tool of `width` with noses of radius `nose`. `None` if the tool does not fit between the walls down
    /// to the floor.
    pub fn slot(&self, width: f64, nose: f64, left: Oversize, above: Above) -> Option<Slot> {
        let wall = |chain: &[Element], along: f64| {
            let mut moved = shifted(chain, Vec2::new(along, left.up));
            let radius = nose + left.around;
            if above == Above::Nothing {
                moved.splice(0..0, free_rim(moved.first()?, radius));
            }
            NoseProfile::new(&moved, radius).ok()
        };
        let slot = Slot {
            first: wall(&self.first, left.along[0])?,
            second: wall(&self.second, left.along[1])?,
            floor: self.floor + left.up + left.around,
            width,
            nose,
            around: left.around,
        };
        let room = slot.raw_end(slot.floor) - slot.begin(slot.floor);
        (room >= -LEVEL).then_some(slot)
    }
}

/// The surface beside the rim, as far as the nose hangs over it where it touches the first element.
fn free_rim(first: &Element, nose: f64) -> Option<Element> {
    let over = nose * (1.0 - left(first.start_direction()?).x);
    let rim = first.from();
    (over > 0.0).then(|| Element::Line { from: rim - Vec2::new(over, 0.0), to: rim })
}

/// Where a recessing tool may be. Positions are those of its edge towards -x.
#[derive(Debug, Clone, PartialEq)]
pub struct Slot {
    first: NoseProfile,
    second: NoseProfile,
    pub floor: f64,
    width: f64,
    nose: f64,
    around: f64,
}

impl Slot {
    /// Nearest position to the first wall with the cutting edge at height `y`.
    pub fn begin(&self, y: f64) -> f64 {
        self.first.touch(y - self.around) - self.nose
    }

    /// Nearest position to the second wall.
    pub fn end(&self, y: f64) -> f64 {
        // Where the tool just fits, rounding must not turn its way around.
        self.raw_end(y).max(self.begin(y))
    }

    fn raw_end(&self, y: f64) -> f64 {
        -(self.second.touch(y - self.around) - self.nose) - self.width
    }

    /// Radius of the corners of the tool that it was made for.
    pub fn nose(&self) -> f64 {
        self.nose
    }

    /// Least height of the cutting edge with the tool at `x`, not below the floor and not above `top`.
    pub fn depth_at(&self, x: f64, top: f64) -> f64 {
        let first = self.first.height(x + self.nose);
        let second = self.second.height(self.nose - x - self.width);
        (first.max(second) + self.around).max(self.floor).min(top)
    }

    /// The way down the first wall from `top` to the floor.
    pub fn down_first(&self, top: f64) -> (Point2, Vec<Leg>) {
        let place = |p: Point2| Point2::new(p.x - self.nose, p.y + self.around);
        let (start, legs) = self.first.way(top - self.around, self.floor - self.around);
        (place(start), legs.iter().map(|leg| moved(leg, place, false)).collect())
    }

    /// The way down the second wall.
    pub fn down_second(&self, top: f64) -> (Point2, Vec<Leg>) {
        let place = |p: Point2| Point2::new(-(p.x - self.nose) - self.width, p.y + self.around);
        let (start, legs) = self.second.way(top - self.around, self.floor - self.around);
        (place(start), legs.iter().map(|leg| moved(leg, place, true)).collect())
    }
}

fn moved(leg: &Leg, place: impl Fn(Point2) -> Point2, mirror: bool) -> Leg {
    match *leg {
        Leg::Line { to } => Leg::Line { to: place(to) },
        Leg::Arc { to, center, ccw } => Leg::Arc { to: place(to), center: place(center), ccw: ccw != mirror },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(points: &[(f64, f64)]) -> Vec<Element> {
        let point = |p: (f64, f64)| Point2::new(p.0, p.1);
        points.windows(2).map(|pair| Element::Line { from: point(pair[0]), to: point(pair[1]) }).collect()
    }

    fn why(points: &[(f64, f64)]) -> NoGroove {
        GrooveProfile::new(&lines(points)).expect_err("no groove")
    }

    #[test]
    fn contours_that_are_no_grooves() {
        assert_eq!(why(&[(0.0, 5.0), (0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (6.0, 0.0), (8.0, 5.0)]), NoGroove::Waves);
        assert_eq!(why(&[(0.0, 5.0), (1.0, 6.0), (1.0, 0.0), (4.0, 0.0), (4.0, 5.0)]), NoGroove::Waves);
        assert_eq!(why(&[(0.0, 5.0), (-1.0, 0.0), (4.0, 0.0), (4.0, 5.0)]), NoGroove::Leans);
        assert_eq!(why(&[(0.0, 0.0), (4.0, 0.0), (4.0, 5.0)]), NoGroove::Open);
    }

    #[test]
    fn a_tool_that_is_too_wide_has_no_slot() {
        let groove_profile =
            GrooveProfile::new(&lines(&[(0.0, 5.0), (0.0, 0.0), (4.0, 0.0), (4.0, 5.0)])).expect("a groove");
        assert!(groove_profile.slot(4.0, 0.2, Oversize::default(), Above::Material).is_some());
        assert!(
            groove_profile
                .slot(4.0, 0.2, Oversize { along: [0.1; 2], ..Oversize::default() }, Above::Material)
                .is_none()
        );
        let vee = GrooveProfile::new(&lines(&[(0.0, 5.0), (3.0, 0.0), (6.0, 5.0)])).expect("a groove");
        assert!(vee.slot(1.0, 0.2, Oversize::default(), Above::Material).is_none());
    }

    #[test]
    fn a_round_groove_is_cut_at_its_lowest_point() {
        let half = Element::Arc {
            from: Point2::new(0.0, 0.0),
            to: Point2::new(10.0, 0.0),
            center: Point2::new(5.0, 0.0),
            sweep: core::f64::consts::PI,
        };
        let groove_profile = GrooveProfile::new(&[half]).expect("a groove");
        assert!((groove_profile.floor + 5.0).abs() < 1e-12);
        // A full-radius tool reaches the floor, a flat one does not.
        assert!(groove_profile.slot(2.0, 1.0, Oversize::default(), Above::Material).is_some());
        assert!(groove_profile.slot(2.0, 0.2, Oversize::default(), Above::Material).is_none());
    }
}
