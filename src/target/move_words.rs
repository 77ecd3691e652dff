//! The words of a target for moves: lines, feeds, arcs, radius compensation, corners.

use core::f64::consts::TAU;

use crate::geo::Plane;

use super::tap_words::RigidTap;

/// Straight moves, planes, coordinates of the machine.
#[derive(Debug)]
pub struct Motion {
    /// A line at rapid traverse.
    pub rapid: &'static str,
    /// A line at a feed.
    pub line: &'static str,
    /// Rapid traverse goes at the F that was read last: the configuration says which one.
    pub rapid_at_feed: bool,
    /// Says that its block counts in machine coordinates: at its start, in a dialog at its end. `None`: such a move is
    /// refused.
    pub machine: Option<&'static str>,
    /// Such a move may have a feed.
    pub machine_feed: bool,
    /// The length of the tool counts in machine coordinates, too: it is switched off for the move.
    pub machine_drops_length: bool,
    /// A line in step with the spindle.
    pub thread: Option<Thread>,
    /// A tap without a compensating chuck.
    pub rigid_tap: Option<RigidTap>,
    /// XY, ZX, YZ; `None` where an arc says its plane itself.
    pub planes: Option<[&'static str; 3]>,
}

/// Line in step with the spindle.
#[derive(Debug, Clone, Copy)]
pub struct Thread {
    /// Begins the block.
    pub word: &'static str,
    /// What of the lead the block says.
    pub lead: Lead,
    /// The spindle may stop or turn round between two threads without a move, as for tapping.
    pub stops: bool,
}

/// What gives the travel of a turn of the spindle, in the unit of the program.
#[derive(Debug, Clone, Copy)]
pub enum Lead {
    /// This address, along the path.
    Way(u8),
    /// This address, along the axis that moves; a path along two axes is not said.
    OneAxis(u8),
    /// This address, where Z alone moves.
    AlongZ(u8),
}

impl Motion {
    /// The word of a plane; `None` where an arc says its plane itself.
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
    /// Address of a feed.
    pub address: u8,
    /// Feeds count per minute from here on, in mm or inches. Not printed where there is one kind of feed alone, or in a
    /// dialog.
    pub per_minute: &'static str,
    /// Feeds count per revolution of the spindle from here on; in a dialog the word of such a feed itself. `None`: they
    /// are refused.
    pub per_revolution: Option<&'static str>,
    /// F is moves a minute from here on; `None`: such feeds are refused.
    pub inverse_time: Option<&'static str>,
    /// What F counts in a move of linear and rotary axes together.
    pub measure: Measure,
}

/// What a feed per minute counts where linear and rotary axes move together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Measure {
    /// The travel of X, Y and Z; where none of them moves, the degrees of the rotary axes.
    Linear,
}

/// All planes.
pub const EVERY_PLANE: &[Plane] = &[Plane::Xy, Plane::Zx, Plane::Yz];

/// Words and limits of arcs. In words the centre is given by its offset from the start.
#[derive(Debug)]
pub struct Arcs {
    /// An arc whose sweep is negative, seen against the plane normal; in a dialog the sense alone.
    pub clockwise: &'static str,
    /// The same for a positive sweep.
    pub counter_clockwise: &'static str,
    /// Addresses of the centre, along X, Y and Z.
    pub center: [u8; 3],
    /// Planes in which the receiver goes round.
    pub planes: &'static [Plane],
    /// A third axis goes along with an arc, in every build of the receiver.
    pub helices: bool,
    /// Number of turns in one block; `None`: an arc is divided at `most_sweep`.
    pub turns: Option<Turns>,
    /// Largest sweep of a block in rad where it cannot count turns.
    pub most_sweep: f64,
    /// Largest sweep of a block in rad, whole turns left out, whose end is not its start. A control that moves a centre
    /// which does not quite fit moves it far where the sweep is near a half or a whole turn. Others are divided.
    pub most_open_sweep: f64,
    /// Largest difference of the radii at start and end of a printed arc, in units of the last place.
    pub tolerance: f64,
    /// The same in mm, in programs in millimetres and in inches.
    pub mismatch: [f64; 2],
    /// Smallest radius in mm that is printed as an arc; smaller ones become lines.
    pub least_radius: f64,
    /// Largest radius in mm that is printed as an arc; larger ones become lines.
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
    /// Blocks that an arc of this `sweep` in rad takes; one at least.
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
    /// The tool is left of the contour, seen in the direction of travel.
    pub left: &'static str,
    /// The tool is right of the contour.
    pub right: &'static str,
    /// Left and right with the diameter given in the block, where the target takes one.
    pub by_diameter: Option<[&'static str; 2]>,
    /// Address and numbers of where the edge of a turning tool points to, beside that diameter; a number of 0 is left out.
    pub edge: Option<EdgeWords>,
    /// Ends the compensation.
    pub off: &'static str,
    /// Address of the tool number or the diameter; `None` where the radius comes with the length of the tool.
    pub tool: Option<u8>,
    /// The words stand in the straight move to the contour or from it, and one block at most between two moves of the contour
    /// moves nothing in its plane.
    pub with_move: bool,
    /// A stop (M0, M1) does not keep the target from reading the element after it.
    pub reads_over_stops: bool,
    /// Working planes in which the target compensates.
    pub planes: &'static [Plane],
}

/// Where the edge of a turning tool points to.
#[derive(Debug, Clone, Copy)]
pub struct EdgeWords {
    /// Address of the number.
    pub address: u8,
    /// The number of each direction from the centre of the nose: rows by the sign along Z, columns by that along X, in
    /// the order minus, nothing, plus.
    pub numbers: [[u8; 3]; 3],
}
impl EdgeWords {
    /// The number of an edge that points there: signs along Z and X, -1, 0 or 1.
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
    /// Selects the mode.
    pub word: &'static str,
    /// Stands in front of the length, in the unit of the program.
    pub length: &'static str,
}
