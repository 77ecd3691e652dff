//! Arguments of face milling: a rectangle that is milled path by path, level by level.

use core::fmt;

use crate::geo::Point2;
use crate::ir::{Feed, Pos};

use super::Family;
use super::milling::{Mill, MillFault, Place, parts};

/// Most paths of a level; more is a lost decimal point.
const MOST_PATHS: f64 = 10_000.0;
/// Ways below this are none, mm.
const NOTHING: f64 = 1e-9;

/// A face. Lengths in mm; its axes are those of `corner`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Facing {
    /// Plane, heights, cutter and feeds.
    pub mill: Mill,
    /// The corner from which the sizes count; its axes are those of the face.
    pub corner: Place,
    /// Sizes of the face, from the corner along its two axes; below 0 against them, none 0.
    pub size: [f64; 2],
    /// Axis of the face along which the tool cuts: 0 or 1. Paths lie side by side along the other one.
    pub along: usize,
    /// Every other path is cut back; else all paths are cut in one sense.
    pub alternates: bool,
    /// How the tool gets from path to path and from level to level.
    pub links: Links,
    /// Greatest width of a cut; above 0, at most the diameter of the cutter.
    pub width: f64,
    /// How far the cutter leaves the face at sides that are no walls.
    pub overrun: Overrun,
    /// Sides of the face that are walls: of each axis the one towards minus, and the one towards plus.
    pub walls: [[bool; 2]; 2],
    /// Roughing in levels, or finishing of the allowance.
    pub kind: Kind,
    /// After roughing, the allowance is cut in a last level of its own at this feed; `None` leaves it.
    pub last: Option<Feed>,
}

/// How the tool gets from path to path, and from level to level.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Links {
    /// To and fro at the feed of the plane; lifted paths, and levels, at rapid traverse from the first path on.
    Usual,
    /// To the next path, and down to a level, at this feed, without one at rapid traverse; to and fro the next level begins where the
    /// one before ends.
    At(Option<Feed>),
    /// The same, and to and fro the tool turns inside the face, where it moves sideways at the feed of the plane.
    Inside(Option<Feed>),
}

/// How far the cutter leaves the face, mm; 0 or more.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Overrun {
    /// At the ends of a path, from the edge of the cutter.
    pub ends: f64,
    /// Beyond the side where the last path lies.
    pub side: f64,
}

/// What is cut.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Kind {
    /// Down to the allowance, in levels.
    Rough,
    /// The allowance in one level; the tool is lifted by `lift` mm, 0 or more, after each path.
    Finish { lift: f64 },
}

/// Arguments that make no face.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FacingFault {
    /// Plane, heights, cutter or feeds.
    Mill(MillFault),
    /// An overrun or the lift is below 0 or no number, or `along` names no axis.
    Number,
    /// A size is 0.
    Size,
    /// The width of a cut is not above 0, or larger than the cutter.
    Width,
    /// A level has more than [`MOST_PATHS`] paths.
    TooManyPaths,
    /// The cutter does not fit between two walls.
    Cutter,
    /// Both ends of the paths are walls: there is no side to come in by.
    NoEntry,
}

impl fmt::Display for FacingFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            FacingFault::Mill(fault) => return fault.fmt(f),
            FacingFault::Number => "an overrun or a lift is below 0, or no number",
            FacingFault::Size => "a side of the face is 0",
            FacingFault::Width => "the width of a cut is 0, or larger than the cutter",
            FacingFault::TooManyPaths => "the width of a cut is so small that the paths do not end",
            FacingFault::Cutter => "the cutter is wider than the face between its walls",
            FacingFault::NoEntry => "both ends of the paths are walls: there is no open side to come in by",
        })
    }
}

/// The cut along the wall at which the paths end: between them cusps stand there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AlongWall {
    /// From start to end, in the axes of the face, mm.
    pub path: [Point2; 2],
    /// It begins outside of the face, where the tool may go down at rapid; else where the last path lies.
    pub from_outside: bool,
}

/// The walls and sizes of one axis, seen from the side where the work begins.
#[derive(Debug, Clone, Copy)]
struct Way {
    /// Signed length of the axis.
    size: f64,
    /// A wall at the beginning, and at the end.
    walls: [bool; 2],
    /// It begins at the far side from the corner.
    mirrored: bool,
}

impl Way {
    fn of(size: f64, walls: [bool; 2]) -> Way {
        let [near, far] = if size < 0.0 { [walls[1], walls[0]] } else { walls };
        // An open side is the better one to begin at.
        let mirrored = near && !far;
        Way { size, walls: if mirrored { [far, near] } else { [near, far] }, mirrored }
    }

    fn length(&self) -> f64 {
        self.size.abs()
    }

    /// From a way along the axis to its coordinate at the corner.
    fn coordinate(&self, way: f64) -> f64 {
        let way = if self.mirrored { self.length() - way } else { way };
        if self.size < 0.0 { -way } else { way }
    }
}

impl Facing {
    fn ways(&self) -> [Way; 2] {
        let side = 1 - self.along;
        [Way::of(self.size[self.along], self.walls[self.along]), Way::of(self.size[side], self.walls[side])]
    }

    /// Distances of the paths from the side where they begin.
    fn tracks(&self) -> Vec<f64> {
        let [_, side] = self.ways();
        let radius = self.mill.radius;
        let last = if side.walls[1] { side.length() - radius } else { side.length() + self.overrun.side - radius };
        let first = if side.walls[0] { radius } else { self.width - radius };
        // A face that is narrower than one cut; a wall holds the path back.
        if last - first <= NOTHING {
            return vec![if side.walls[1] { first.min(last) } else { first }];
        }
        let count = parts(last - first, self.width);
        (0..=count).map(|i| first + (last - first) * i as f64 / count as f64).collect()
    }

    /// The paths of the cutter's centre on a level, in the axes of the face, each from where the tool begins it; what
    /// the links change is in [`Facing::paths_of`].
    pub fn paths(&self) -> Vec<[Point2; 2]> {
        let [cut, _] = self.ways();
        let clear = self.mill.radius + self.overrun.ends;
        let end = if cut.walls[1] { cut.length() - self.mill.radius } else { cut.length() + clear };
        let backwards = |at: usize| self.goes_back() && at % 2 == 1;
        self.tracks()
            .into_iter()
            .enumerate()
            .map(|(at, t)| {
                let path = [self.point(-clear, t), self.point(end, t)];
                if backwards(at) { [path[1], path[0]] } else { path }
            })
            .collect()
    }

    /// The paths of a level, where it is the `level`th one, from 0.
    pub fn paths_of(&self, level: usize) -> Vec<[Point2; 2]> {
        let mut paths = self.paths();
        if let (Links::Inside(_), true) = (self.links, self.goes_back()) {
            self.turn_inside(&mut paths);
        }
        if level % 2 == 1 && self.goes_back() && self.links != Links::Usual {
            paths.reverse();
            for path in &mut paths {
                path.reverse();
            }
        }
        paths
    }

    /// The tool turns inside as far as nothing stays between two paths at the end where they are not joined; but not at the
    /// last turn, where a corner of the face would be left.
    fn turn_inside(&self, paths: &mut [[Point2; 2]]) {
        let radius = self.mill.radius;
        let reach = libm::sqrt((radius * radius - self.width * self.width / 4.0).max(0.0));
        let by = radius + self.overrun.ends + reach.min(self.size[self.along].abs() / 2.0);
        for turn in 0..paths.len().saturating_sub(2) {
            let [from, to] = paths[turn];
            let along = (to - from) / crate::geo::length(to - from);
            // A path that was made shorter keeps its direction.
            paths[turn][1] = to - along * by;
            paths[turn + 1][0] -= along * by;
        }
    }

    /// The cut along the wall, in the axes of the face; none where the paths end outside.
    pub fn along_wall(&self) -> Option<AlongWall> {
        let [cut, side] = self.ways();
        if !cut.walls[1] {
            return None;
        }
        let radius = self.mill.radius;
        let clear = radius + self.overrun.side;
        let from = if side.walls[1] { side.length() - radius } else { side.length() + clear };
        let to = if side.walls[0] { radius } else { -clear };
        let path = [from, to].map(|t| self.point(cut.length() - radius, t));
        Some(AlongWall { path, from_outside: !side.walls[1] })
    }

    /// A point by its ways along the paths and across them, from where the work begins.
    fn point(&self, s: f64, t: f64) -> Point2 {
        let [cut, side] = self.ways();
        let (s, t) = (cut.coordinate(s), side.coordinate(t));
        if self.along == 0 { Point2::new(s, t) } else { Point2::new(t, s) }
    }

    /// Does every other path lead back? Where the tool is lifted between the paths it needs both ends open for it.
    pub fn goes_back(&self) -> bool {
        let [cut, _] = self.ways();
        self.alternates && (self.kind == Kind::Rough || !cut.walls[1])
    }

    /// Heights of the levels, from the first cut to the last.
    pub fn levels(&self) -> Vec<f64> {
        match self.kind {
            Kind::Rough => {
                let mut levels = self.mill.heights.levels();
                levels.extend(self.last.map(|_| self.mill.heights.depth));
                levels
            }
            Kind::Finish { .. } => vec![self.mill.heights.depth],
        }
    }
}

impl Family for Facing {
    type Fault = FacingFault;

    fn check(&self) -> Result<(), FacingFault> {
        self.mill.check().map_err(FacingFault::Mill)?;
        let unsigned = |v: f64| v >= 0.0 && v.is_finite();
        let lift = match self.kind {
            Kind::Rough => 0.0,
            Kind::Finish { lift } => lift,
        };
        let [cut, side] = self.ways();
        if ![self.overrun.ends, self.overrun.side, lift].into_iter().all(unsigned) || self.along > 1 {
            Err(FacingFault::Number)
        } else if self.size.contains(&0.0) || !self.size.iter().all(|v| v.is_finite()) {
            Err(FacingFault::Size)
        } else if self.width <= 0.0 || self.width > 2.0 * self.mill.radius + NOTHING {
            Err(FacingFault::Width)
        } else if (side.length() + self.overrun.side) / self.width > MOST_PATHS {
            Err(FacingFault::TooManyPaths)
        } else if side.walls == [true; 2] && side.length() < 2.0 * self.mill.radius - NOTHING {
            Err(FacingFault::Cutter)
        } else if cut.walls == [true; 2] {
            Err(FacingFault::NoEntry)
        } else {
            Ok(())
        }
    }

    /// Above the end of the last cut.
    fn leaves(&self, at: &mut Pos) {
        let wall = self.along_wall().map(|wall| wall.path);
        let level = self.levels().len().saturating_sub(1);
        let last = wall.or_else(|| self.paths_of(level).last().copied());
        if let Some([_, end]) = last {
            self.mill.leaves_above(self.corner.point(end), at);
        }
    }

    fn moves(&self) -> f64 {
        4.0 * (self.paths().len() + 1) as f64 * self.levels().len() as f64
    }
}
