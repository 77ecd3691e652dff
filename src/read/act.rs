//! What a line has the machine do.

/// Axes of a machine.
pub const AXES: usize = 9;
/// Their letters, in order.
pub const LETTERS: &[u8; AXES] = b"XYZABCUVW";

/// One thing that happens. Numbers are in units of [`SCALE`](super::SCALE): mm, degrees, rev/min, seconds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Act {
    Move(Move),
    /// A hole is tapped in step with the spindle, or a part of one; how, the reader says.
    Tap,
    /// The changer brings this tool forth.
    Select(u32),
    /// The tool brought forth goes into the spindle.
    Change,
    Speed(Speed),
    /// An M function; of those of spindles the spindle, and the angle where one is given.
    M {
        number: u32,
        spindle: u8,
        angle: Option<i64>,
    },
    Dwell(i64),
    /// How corners are taken from here on.
    Corners(PathControl),
    /// Another work offset, 1 (G54) to 9 (G59.3), and on.
    Offset(u8),
    /// Something happens to the working plane; how it lies, the reader says.
    Tilt(Tilting),
}

/// What happens to the working plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tilting {
    /// The zero point is shifted, or is so no more.
    Shifted,
    /// It is tilted, and the rotary axes turn.
    Into,
    /// It is tilted no more, and they turn back.
    Back,
    /// It is tilted no more; they stay.
    Off,
}

/// How corners are taken; lengths are above zero.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PathControl {
    /// Every block ends on its corner (G61, G60).
    Exact,
    /// The path is left by so much at most (G64 P, G642 CTOL=, cycle 32): of P and Q the smaller one.
    Within(i64),
    /// Corners are rounded off from so far in front of them (G641 ADIS=).
    Before(i64),
    /// No bound is stated (G64).
    Unbounded,
}

/// A speed for a spindle, counted from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Speed {
    pub spindle: u8,
    pub value: i64,
    /// The value is a cutting speed in m/min, up to this speed where one is said.
    pub constant_cut: Option<Option<i64>>,
}

/// A move to where the reader now says that the machine stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Move {
    pub path: Path,
    /// A bit for each axis that the line names.
    pub axes: u16,
    /// To a place in machine coordinates.
    pub machine: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Path {
    Rapid,
    Line,
    /// In step with the spindle: the way of a turn.
    Thread(i64),
    Arc(Arc),
}

/// A tap in step with the spindle along one axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Tap {
    pub axis: usize,
    /// Where it begins, where it turns round, and where it ends.
    pub from: i64,
    pub to: i64,
    pub back: i64,
    /// Way of a turn, above zero.
    pub lead: i64,
    /// A left-hand thread.
    pub left: bool,
    /// Turns a minute on the way in, or on the one way that it goes.
    pub speed: Option<i64>,
    /// On the speed of the way back.
    pub factor: i64,
    /// Seconds at the depth.
    pub dwell: i64,
    /// Angle of the spindle before, where the line says it.
    pub angle: Option<i64>,
    pub way: Way,
    /// Depths count from here in steps of so much, with this way back between them; 0 for out of the hole.
    pub steps: Option<[i64; 3]>,
}

/// Which way a line taps.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Way {
    #[default]
    Both,
    In,
    Out,
}

/// What the spindle does, as far as lines said it.
#[derive(Debug, Clone, Copy, Default)]
pub struct Turning {
    /// Turns a minute.
    pub speed: Option<i64>,
    /// M3 or M4.
    pub turn: Option<u32>,
    /// It stands under control of its position.
    pub is_axis: bool,
    /// The next cycle taps in step with it.
    pub is_ready: bool,
    /// Nothing was said of it since a tap.
    pub tapped: bool,
}

/// An arc in the axes of its plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Arc {
    pub plane: Plane,
    pub from: [i64; 2],
    pub to: [i64; 2],
    pub center: [i64; 2],
    /// Turns, the last one begun included; counter-clockwise is positive.
    pub turns: i32,
    /// The end follows from an angle, and is as exact as that.
    pub by_angle: bool,
}

/// Plane of arcs and compensation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Plane {
    Xy,
    Zx,
    Yz,
}

impl Plane {
    /// First, second and third axis.
    pub fn axes(self) -> [usize; 3] {
        match self {
            Plane::Xy => [0, 1, 2],
            Plane::Zx => [2, 0, 1],
            Plane::Yz => [1, 2, 0],
        }
    }
}

/// What F counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FeedKind {
    /// mm or degrees a minute.
    PerMinute,
    /// mm a turn of the spindle.
    PerRevolution,
    /// Moves a minute.
    InverseTime,
}

/// Radius compensation by the control.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Cutter {
    /// Left 1, right -1, none 0.
    pub side: i8,
    pub tool: u32,
    pub diameter: Option<i64>,
    /// Where the edge points to beside a diameter, along Z and X; no way where the programmed point is the centre of the nose.
    pub edge: [i8; 2],
}
