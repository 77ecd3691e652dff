//! HEIDENHAIN turning: what the manuals leave open. docs/turning.md says what each key decides.

use crate::machine::keys::{Key, Kind, key};
use crate::machine::tree::Node;
use crate::machine::values::{change_point, is, number, put, tolerance};

pub const KEYS: &[Key] = &[
    key(
        "turning_arc_q",
        Kind::Choice(&["near", "far"]),
        "solution that Q0 of an arc names in turning programs",
        |s, v| {
            let far = is(v, "far");
            put(&mut s.control.turning.arc_choice, Some(if far { ArcChoice::ZeroIsFar } else { ArcChoice::ZeroIsNear }))
        },
    )
    .or_warn(r#""near""#),
    key(
        "recess_depth",
        Kind::Choice(&["diameter", "radius"]),
        "what an incremental I of a recess (G22) counts",
        |s, v| put(&mut s.control.turning.recess_depth, Some(counts(v))),
    )
    .or_warn(r#""diameter""#),
    key(
        "clearance",
        Kind::Number,
        "clearance of turning cycles in mm where the program sets none; 1 mm if not given",
        |s, v| {
            let clearance = number(v).filter(|mm| *mm > 0.0);
            put(&mut s.control.turning.clearance, Some(clearance.ok_or_else(|| v.fail("a clearance is above 0"))?))
        },
    ),
    key(
        "recess_side",
        Kind::Choice(&["plus", "minus"]),
        "side of its corner, along Z, on which a wide recess of G86 lies; refused if not given",
        |s, v| {
            put(
                &mut s.control.turning.recess_side,
                Some(if is(v, "plus") { RecessSide::Plus } else { RecessSide::Minus }),
            )
        },
    ),
    key(
        "infeed",
        Kind::Choice(&["radius", "diameter"]),
        "what the infeed I of G81 in turning programs counts",
        |s, v| put(&mut s.control.turning.infeed, Some(counts(v))),
    )
    .or_warn(r#""radius""#),
    key(
        "thread_left",
        Kind::Choice(&["minus", "plus"]),
        "turning programs: end of the Z axis that is left for the flank offset H of a thread",
        |s, v| put(&mut s.control.turning.left_is_plus, Some(is(v, "plus"))),
    )
    .or_warn(r#""minus""#),
    key(
        "recess_width",
        Kind::Choice(&["opening", "floor"]),
        "where K of a recess with leaning flanks (G23) is measured",
        |s, v| {
            let floor = is(v, "floor");
            put(
                &mut s.control.turning.recess_width,
                Some(if floor { RecessWidth::Floor } else { RecessWidth::Opening }),
            )
        },
    )
    .or_warn(r#""opening""#),
    key(
        "recess_blank",
        Kind::Choice(&["diameter", "radius"]),
        "what RI of G869 (blank oversize in X) counts",
        |s, v| put(&mut s.control.turning.recess_blank, Some(counts(v))),
    )
    .or_warn(r#""diameter""#),
    key(
        "simple_thread",
        Kind::Choice(&["documented", "refuse"]),
        "G32 of turning programs: its words as in docs/turning.md, or refused",
        |s, v| put(&mut s.control.turning.refuse_simple_thread, Some(is(v, "refuse"))),
    )
    .or_warn(r#""documented""#),
    key(
        "contour_words",
        Kind::Choice(&["documented", "refuse"]),
        "contour in the words of G80: as in docs/turning.md, or refused",
        |s, v| put(&mut s.control.turning.refuse_contour_words, Some(is(v, "refuse"))),
    )
    .or_warn(r#""documented""#),
    key(
        "line_angle",
        Kind::Choice(&["minus-z", "plus-z"]),
        "turning programs: direction from which the angle A or AN of a line counts",
        |s, v| put(&mut s.control.turning.angle_from_plus, Some(is(v, "plus-z"))),
    )
    .or_warn(r#""minus-z""#),
    key(
        "undercut_limit",
        Kind::Choice(&["lower", "upper"]),
        "row of the table of G85 for a diameter of exactly 18 or 80 mm",
        |s, v| put(&mut s.control.turning.undercut_upper, Some(is(v, "upper"))),
    )
    .or_warn(r#""lower""#),
    key(
        "thread_face",
        Kind::Choice(&["front", "rear"]),
        "face that a transverse thread of G31 is cut in; if not given, the edge position of the tool tells",
        |s, v| put(&mut s.control.turning.rear_face, Some(is(v, "rear"))),
    ),
    key(
        "turning_depth",
        Kind::Choice(&["away", "towards"]),
        "turning depth compensation R or RB of G869: away from the floor, or towards it",
        |s, v| put(&mut s.control.turning.towards_floor, Some(is(v, "towards"))),
    )
    .or_warn(r#""away""#),
    key(
        "offset_one_way",
        Kind::Choice(&["none", "end"]),
        "offset width B of G869 with U1: no effect, or each pass from the second on ends earlier",
        |s, v| put(&mut s.control.turning.offset_one_way, Some(is(v, "end"))),
    )
    .or_warn(r#""none""#),
    key(
        "recess_oversize",
        Kind::Choice(&["all", "floor"]),
        "oversize of G86: left on the floor and the walls, or on the floor alone",
        |s, v| put(&mut s.control.turning.oversize_on_floor, Some(is(v, "floor"))),
    )
    .or_warn(r#""all""#),
    key(
        "arc_tolerance",
        Kind::Number,
        "turning programs: how far the radii at both ends of an arc may differ, in mm; 0.02 if not given",
        |s, v| put(&mut s.control.turning.arc_tolerance, Some(tolerance(v)?)),
    ),
    key("tool_change_point", Kind::Free, "machine coordinates of G14: X (diameter) and Z", |s, v| {
        put(&mut s.control.turning.change_point, Some(change_point(v)?))
    }),
];

fn counts(node: &Node) -> RecessDepth {
    if is(node, "radius") { RecessDepth::Radius } else { RecessDepth::Diameter }
}

/// Which of two solutions Q0 of an arc names.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ArcChoice {
    #[default]
    ZeroIsNear,
    ZeroIsFar,
}

/// What a depth or height across the axis counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum RecessDepth {
    #[default]
    Diameter,
    Radius,
}

/// Where the width of a recess with leaning flanks counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum RecessWidth {
    /// At the element that it is cut into.
    #[default]
    Opening,
    Floor,
}

/// On which side of the programmed corner a recess of G86 lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RecessSide {
    /// Towards +Z.
    Plus,
    /// Towards -Z.
    Minus,
}

/// What turning programs leave to the control. `None`: nobody said, so the default holds and a program that depends on it is
/// told so.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Turning {
    /// Near, if nobody said.
    pub arc_choice: Option<ArcChoice>,
    /// What an incremental I of G22 counts: the diameter, if nobody said.
    pub recess_depth: Option<RecessDepth>,
    /// Clearance of cycles in mm where the program sets none.
    pub clearance: Option<f64>,
    /// Machine coordinates of the tool change point: X as a diameter, Z, in mm.
    pub change_point: Option<(f64, f64)>,
    /// Where a recess of G86 lies that is wider than the tool; `None` refuses it.
    pub recess_side: Option<RecessSide>,
    /// Where K of G23 counts: at the opening, if nobody said.
    pub recess_width: Option<RecessWidth>,
    /// What the infeed I of G81 counts: the radius, if nobody said.
    pub infeed: Option<RecessDepth>,
    /// A flank offset from the left (H1) starts a thread towards +Z, not towards -Z.
    pub left_is_plus: Option<bool>,
    /// What RI of G869 counts: the diameter, if nobody said.
    pub recess_blank: Option<RecessDepth>,
    /// G32, whose words no available manual lists, is refused.
    pub refuse_simple_thread: Option<bool>,
    /// A contour in the words of G80, which no available manual lists, is refused.
    pub refuse_contour_words: Option<bool>,
    /// Angles of lines count from +Z, not from -Z.
    pub angle_from_plus: Option<bool>,
    /// An undercut of G85 at exactly 18 or 80 mm takes the row above, not the one below.
    pub undercut_upper: Option<bool>,
    /// The face that a transverse thread is cut in is the one towards -Z. `None`: the tool tells.
    pub rear_face: Option<bool>,
    /// R or RB of G869 moves the tool towards the floor, not away from it.
    pub towards_floor: Option<bool>,
    /// B of G869 shortens the passes of one-way turning at their ends.
    pub offset_one_way: Option<bool>,
    /// The oversize of G86 is left on the floor alone, not on the walls.
    pub oversize_on_floor: Option<bool>,
    /// How far the radii at both ends of an arc may differ, in mm.
    pub arc_tolerance: Option<f64>,
}
