//! Tolerances that more than one place compares with, and why each is as large as it is.
//!
//! A place that needs another one names it itself, with its reason; a tolerance of a control stands where the control is known.

/// What sums and products of coordinates lose, in mm: double arithmetic loses 1e-12 mm on a machine's travel, and a cycle adds up
/// hundreds of them. Sizes that differ by less were computed in two ways from one number.
pub const LOST: f64 = 1e-9;

/// Points closer than this are one, and lengths below it are none, in mm: less than the radius of the smallest circle that a HEIDENHAIN
/// control makes (1.6e-6 mm), far above what double arithmetic loses on a machine's travel, far below what any target prints.
pub const SAME: f64 = 1e-6;

/// Directions closer than this are parallel, in rad.
pub const SAME_DIRECTION: f64 = 1e-9;

/// Largest angle in rad by which moving the centre may turn an arc at its start: 1.8 degrees, as controls allow.
pub const MOST_TURN: f64 = 0.0316;

/// Shifts of a centre up to this much are rounding of the source, and not worth a note, in mm: half of its third decimal.
pub const UNNOTED: f64 = 0.0005;

/// How far a printed arc may leave the programmed one, in mm, besides the rounding of a place: what prints and what checks the
/// print have to mean the same.
pub const LEAVES: f64 = 0.005;

/// How far the printed pitch of a tap may lead beside the meant one along the whole hole, in mm; of printer and check alike.
pub const PITCH_LEAVES: f64 = 0.005;

/// How far rounding moves a point at most, in units of the last place: half of one on each axis; of printer and check alike.
pub const ROUNDED_POINT: f64 = 0.7072;

/// A travel along an axis of the machine that may stand in a block of its own where a contour is carried out, in mm; of printer and
/// check alike.
pub const STEP_ASIDE: f64 = 0.0005;
