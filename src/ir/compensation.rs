//! What a control decides about the radius of its tool. What is done with it is done in one place, after the corners.

use crate::geo::{Deg, Vec2};

use super::Ask;

/// How the radius of the tool is compensated by the compiler. A block may have its own: what it says about a joint counts
/// for the end of its element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Compensation {
    /// Radius of the tool with its oversizes in mm, not below zero. No frame scales it.
    pub radius: f64,
    /// From the programmed point to the centre of the nose, in mm, in the working plane of the workpiece; zero for a
    /// milling cutter.
    pub nose: Vec2,
    /// The path to the start of the first contour element.
    pub approach: Border,
    /// The path from the end of the last contour element.
    pub retract: Border,
    /// At corners that turn away from the tool.
    pub outside: Outside,
    /// At corners that turn towards the tool.
    pub inside: Inside,
    /// Where neighbours do not meet.
    pub search: Search,
    /// What becomes of a border element that does not meet its neighbour.
    pub ends: Ends,
    /// Elements keep the last offset instead of one of their own.
    pub constant: bool,
    /// Where the feed of an arc counts.
    pub feed: FeedAt,
    /// A chamfer or rounding may lie beside the path to the contour or from it: the producer has looked at it.
    pub rounded_border: bool,
    /// The element belongs to a path that a cycle makes to its contour, not to the contour: the path may come near to
    /// it.
    pub is_way: bool,
    /// The block asks for the corner at its end by itself: that nothing comes of it is worth a word.
    pub own_corner: bool,
    /// The manuals say which feed counts on the arc about a corner, and where blocks between two elements happen.
    pub joints_are_documented: bool,
    /// Alarms of the control for what is reported.
    pub alarms: Alarms,
}

impl Default for Compensation {
    fn default() -> Compensation {
        Compensation {
            radius: 0.0,
            nose: Vec2::zeros(),
            approach: Border::default(),
            retract: Border::default(),
            outside: Outside::default(),
            inside: Inside::default(),
            search: Search::default(),
            ends: Ends::default(),
            constant: false,
            feed: FeedAt::default(),
            rounded_border: false,
            is_way: false,
            own_corner: false,
            joints_are_documented: false,
            alarms: Alarms::default(),
        }
    }
}

/// Where the feed of an arc counts; on lines it is the same.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum FeedAt {
    /// On the path of the tool centre.
    #[default]
    Centre,
    /// On the contour: the centre is slower in hollow arcs, and faster around others.
    Contour,
    /// On the contour in hollow arcs only.
    HollowContour,
    /// On the contour; the user has not asked for it, so it is printed as programmed and said.
    CentreInstead(&'static Ask),
}

/// The path to the first contour element, or from the last one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Border {
    /// Straight to the point beside the start of the element, at a right angle to its direction there.
    #[default]
    Perpendicular,
    /// The same, but around the start of the contour on a circle where the straight path would come nearer to it than
    /// the radius.
    Around,
    /// Around it by another path, which the compiler does not make.
    AroundOtherwise,
}

/// A corner that turns away from the tool.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Outside {
    /// Up to this turn of the contour in degrees both offsets are prolonged until they meet, beyond it an arc leads
    /// about the corner.
    pub prolonged: Deg,
    /// Turns above the first and up to the second are decided by a machine datum that nobody gave.
    pub open: Option<(Deg, Deg, &'static Ask)>,
    /// Both offsets are prolonged by this length in mm, and a smaller arc leads from one to the other.
    pub by: Option<f64>,
}

/// A corner that turns towards the tool.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Inside {
    /// Both elements end where their offsets cross.
    #[default]
    Crossing,
    /// Both are cut to their ends, and a line leads from one to the other.
    Open,
}

/// What is done where neighbours do not meet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Search {
    /// Elements that may be left out; none: the contour is refused.
    pub elements: u32,
    /// A bottleneck between elements that are no neighbours is an error, too.
    pub bottlenecks: bool,
}

/// How the border element of a contour is prolonged where it does not meet its neighbour.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Ends {
    /// Not at all.
    #[default]
    AsTheyAre,
    /// By the circle of the tool about the programmed border point.
    Circle,
    /// By the tangent.
    Tangent,
}

/// Numbers of the control's own alarms, for reports.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Alarms {
    /// Neighbours do not meet.
    pub no_room: Option<u32>,
    /// Elements were left out.
    pub left_out: Option<u32>,
    /// The tool stands inside of the circle about the border point.
    pub start_inside: Option<u32>,
    /// The same at the end of the contour.
    pub end_inside: Option<u32>,
    /// The plane changes.
    pub plane: Option<u32>,
    /// The compensation begins or ends on an arc, or without a move in the plane.
    pub no_line: Option<u32>,
}
