//! Rows of `[control]` of the HEIDENHAIN turning controls.

use super::key::{Key, Kind, key};
use crate::machine::options::turning::{ArcChoice, RecessDepth, RecessSide, RecessWidth};
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
