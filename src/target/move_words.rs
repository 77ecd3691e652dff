//! The words of a target for moves: lines, feeds, arcs, radius compensation, corners.

use core::f64::consts::TAU;

use crate::geo::Plane;

use super::tap_words::RigidTap;

/// Straight moves, planes, coordinates of the machine.
#[derive(Debug)]
pub struct Motion {
    pub rapid: &'static str,
    pub line: &'static str,
    /// Rapid traverse goes at the F that was read last: the configuration says which one.
    pub rapid_at_feed: bool,
    /// In front of a move in machine coordinates, in a dialog behind it.
    pub machine: Option<&'static str>,
    /// Such a move may have a feed.
    pub machine_feed: bool,
    /// The length of the tool counts in machine coordinates, too: it is switched off for the move.
    pub machine_drops_length: bool,
    pub thread: Option<Thread>,
    pub rigid_tap: Option<RigidTap>,
    /// XY, ZX, YZ; `None` where an arc says its plane itself.
    pub planes: Option<[&'static str; 3]>,
}

/// Line in step with the spindle.
#[derive(Debug, Clone, Copy)]
pub struct Thread {
    pub word: &'static str,
    pub lead: Lead,
    /// The spindle may stop or turn round between two threads without a move, as for tapping.
    pub stops: bool,
}

/// What gives the way of a turn.
#[derive(Debug, Clone, Copy)]
pub enum Lead {
    /// This address, along the way.
    Way(u8),
    /// This address, along the axis that moves; a way along two axes is not said.
    OneAxis(u8),
    /// This address, where Z alone moves.
    AlongZ(u8),
}

impl Motion {
    pub fn plane(&self, plane: Plane) -> Option<&'static str> {
        self.planes.map(|[xy, zx, yz]| match plane {
            Plane::Xy => xy,
            Plane::Zx => zx,
            Plane::Yz => yz,
        })
    }
}

/// Feeds and their kinds.
#[derive(Debug)]
pub struct FeedWords {
    pub address: u8,
    pub per_minute: &'static str,
    pub per_revolution: Option<&'static str>,
    pub inverse_time: Option<&'static str>,
    /// What F counts in a move of linear and rotary axes together.
    pub measure: Measure,
}

/// What a feed per minute counts where linear and rotary axes move together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Measure {
    /// The way of X, Y and Z; where none of them moves, the degrees of the rotary axes.
    Linear,
}

/// All planes.
pub const EVERY_PLANE: &[Plane] = &[Plane::Xy, Plane::Zx, Plane::Yz];

/// Arcs by offset from the start to the centre.
#[derive(Debug)]
pub struct Arcs {
    pub clockwise: &'static str,
    pub counter_clockwise: &'static str,
    /// Addresses of the centre, by axis.
    pub center: [u8; 3],
    /// Planes in which the receiver goes round.
    pub planes: &'static [Plane],
    /// A third axis goes along with an arc, in every build of the receiver.
    pub helices: bool,
    /// Number of turns in one block; `None`: an arc is divided at `most_sweep`.
    pub turns: Option<Turns>,
    /// Largest sweep of a block in rad where it cannot count turns.
    pub most_sweep: f64,
    /// Largest sweep of a block, whole turns left out, whose end is not its start. A control that moves a centre which does
    /// not quite fit moves it far where the sweep is near a half or a whole turn. Others are divided.
    pub most_open_sweep: f64,
    /// Largest difference of the radii at start and end of a printed arc, in units of the last place.
    pub tolerance: f64,
    /// The same in mm, in programs in millimetres and in inches.
    pub mismatch: [f64; 2],
    /// Radii in mm that are printed as arcs; others become lines.
    pub least_radius: f64,
    pub most_radius: f64,
    /// Shortest distance in mm from start to end by which the receiver tells a short arc from a full circle.
    pub least_chord: f64,
}

/// How a block counts the turns of its arc.
#[derive(Debug, Clone, Copy)]
pub enum Turns {
    /// This address gives all, the last one begun included.
    All(u8),
    /// This word gives whole turns that are added.
    More(&'static str),
}

impl Arcs {
    /// Blocks that an arc of this sweep takes.
    #[inline]
    pub fn blocks(&self, sweep: f64) -> u32 {
        let blocks = libm::ceil(sweep.abs() / self.most_sweep - ROUNDING);
        blocks.clamp(1.0, f64::from(u32::MAX)) as u32
    }

    /// The same for an arc that does not end where it starts.
    #[inline]
    pub fn open_blocks(&self, sweep: f64) -> u32 {
        let last = sweep.abs() % TAU;
        if last > self.most_open_sweep {
            libm::ceil(sweep.abs() / self.most_open_sweep) as u32
        } else {
            self.blocks(sweep)
        }
    }
}

/// What a sweep may exceed the largest one by, as a part of it.
const ROUNDING: f64 = 1e-9;

/// Radius compensation by the target.
#[derive(Debug)]
pub struct CompensationWords {
    pub left: &'static str,
    pub right: &'static str,
    /// Left and right with the diameter given in the block, where the target takes one.
    pub by_diameter: Option<[&'static str; 2]>,
    /// Address and numbers of where the edge of a turning tool points to, beside that diameter; a number of 0 is left out.
    pub edge: Option<EdgeWords>,
    pub off: &'static str,
    /// Address of the tool number or the diameter; `None` where the radius comes with the length of the tool.
    pub tool: Option<u8>,
    /// The words stand in the straight move to the contour or from it, and one block at most between two moves of the contour
    /// moves nothing in its plane.
    pub with_move: bool,
    /// A stop (M0, M1) does not keep the target from reading the element behind it.
    pub reads_over_stops: bool,
    /// Working planes in which the target compensates.
    pub planes: &'static [Plane],
}

/// Where the edge of a turning tool points to.
#[derive(Debug, Clone, Copy)]
pub struct EdgeWords {
    pub address: u8,
    /// Rows by the sign along Z, columns by that along X: minus, nothing, plus.
    pub numbers: [[u8; 3]; 3],
}
impl EdgeWords {
    /// The number of an edge that points there, along Z and X.
    pub fn number(&self, edge: [i8; 2]) -> u8 {
        let [z, x] = edge.map(|sign| usize::from(sign.clamp(-1, 1).wrapping_add(1) as u8));
        self.numbers.get(z).and_then(|row| row.get(x)).copied().unwrap_or(0)
    }
}

/// How corners are taken.
#[derive(Debug, Clone, Copy)]
pub struct PathWords {
    /// Every block ends on its corner.
    pub exact: Option<&'static str>,
    /// Corners are rounded off, by so much off the path at most.
    pub within: Option<PathBound>,
    /// Rounding off begins so far in front of a corner at most.
    pub before: Option<PathBound>,
    /// Corners are passed without a stop and without a bound.
    pub unbounded: Option<&'static str>,
    /// So does every receiver before a program says anything: the head states it, so that nothing else is left on.
    pub starts_unbounded: bool,
    /// The mode may change between G41 and G40.
    pub under_compensation: bool,
    /// Exact is how a program for a lathe begins: the receiver starts so, or stops only where the path has a corner.
    pub exact_on_lathes: bool,
}

impl PathWords {
    /// A receiver whose corners are a matter of its settings alone.
    pub const NONE: PathWords = PathWords {
        exact: None,
        within: None,
        before: None,
        unbounded: None,
        starts_unbounded: false,
        under_compensation: true,
        exact_on_lathes: false,
    };

    /// No word says anything of corners.
    pub fn is_empty(&self) -> bool {
        self.exact.is_none() && self.within.is_none() && self.before.is_none() && self.unbounded.is_none()
    }
}

/// A word, and the one that gives its length: `G64` and `P`, `G642` and `CTOL=`. In a dialog it stands in a block of its own.
#[derive(Debug, Clone, Copy)]
pub struct PathBound {
    pub word: &'static str,
    pub length: &'static str,
}
