//! What cycles of stock removal share: the nose of their tools, and the corner of the stock at which some of them begin.

use crate::geo::Vec2;
use crate::ir::Feed;

/// A round tool nose and its programmed point.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Nose {
    /// Nose radius in mm, not negative; 0 for a tool that is taken as a point.
    pub radius: f64,
    /// From the centre of the nose to the programmed point, in radii along Z and X: each -1, 0 or 1.
    pub tip: Vec2,
}

/// The tool stands at a corner of the stock: in front of its cuts, and above them. At its end the contour goes straight out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corner {
    /// Feed to the depth of a cut; `None` for rapid traverse.
    pub infeed: Option<Feed>,
    /// Back to the corner afterwards; else the tool stays beside the stock at the height of the last lift, if its cuts begin there.
    pub back: bool,
}
