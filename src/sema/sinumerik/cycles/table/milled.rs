//! Parameters that most milling cycles take.

use crate::sema::cycle::row::{Digit, Digits, Parameter, angle, digits, feed, length, number};

pub(super) const RTP: Parameter = length("_RTP", "retraction plane").needed();
pub(super) const RFP: Parameter = length("_RFP", "reference plane: the surface").needed();
pub(super) const SDIS: Parameter =
    length("_SDIS", "safety distance above the surface; its sign is left out").default("0");
pub(super) const DP: Parameter = length("_DP", "depth, absolute or below the surface by `_AMODE`").default("0");
pub(super) const PA: Parameter = length("_PA", "reference point, first axis").default("0");
pub(super) const PO: Parameter = length("_PO", "reference point, second axis").default("0");
pub(super) const STA: Parameter = angle("_STA", "rotation").default("0");
pub(super) const MID: Parameter = length("_MID", "greatest infeed in depth").default("one level");
pub(super) const FAL: Parameter = length("_FAL", "allowance on the wall").default("0");
pub(super) const FALD: Parameter = length("_FALD", "allowance on the floor").default("0");
pub(super) const FFP1: Parameter = feed("_FFP1", "feed in the plane").default("F");
pub(super) const FFD: Parameter = feed("_FFD", "feed in depth").default("F");
pub(super) const CDIR: Parameter = number("_CDIR", "0 climb, 1 conventional, 2 G2, 3 G3").default("0");
pub(super) const MIDA: Parameter =
    length("_MIDA", "greatest infeed in the plane; percent of the cutter by `_AMODE`").default("0.8 of the cutter");
pub(super) const UMODE: Parameter = number("_UMODE", "").without_effect("reserved");
pub(super) const DMODE: Parameter = digits(
    "_DMODE",
    &MODE,
    "units: plane, 0 the active one, 1 G17, 2 G18, 3 G19; tens 0 and 1: the feeds count as F does",
);
pub(super) const MODE_PLANE: Digit = Digit { place: 0, most: 3, unknown: "this plane (units of `_DMODE`)" };
pub(super) const MODE_FEEDS: Digit = Digit { place: 1, most: 1, unknown: "this kind of feeds (tens of `_DMODE`)" };
const fn shown(place: u32) -> Digit {
    Digit { place, most: 9, unknown: "" }
}
/// Plane and feeds; above them how the dialog shows the call.
pub(super) const MODE: Digits = Digits {
    known: &[MODE_PLANE, MODE_FEEDS, shown(2), shown(3), shown(4), shown(5), shown(6), shown(7), shown(8)],
    other: "",
    doubt: None,
    checked: true,
};

/// Depth by the units.
pub(super) const DEPTH: Digit = Digit { place: 0, most: 1, unknown: "this reading of the depth (units of `_AMODE`)" };
/// Depth by the units, where it may come from `DP` or `DPR`.
pub(super) const PAIR: Digit = Digit { most: 2, ..DEPTH };
/// Plane infeed by the tens.
pub(super) const PERCENT: Digit =
    Digit { place: 1, most: 1, unknown: "this unit of the plane infeed (tens of `_AMODE`)" };
/// Depth of a chamfer by the hundreds.
pub(super) const CHAMFER: Digit =
    Digit { place: 2, most: 1, unknown: "this reading of the chamfer (hundreds of `_AMODE`)" };
/// Hundreds of the geometry: more than 1 computes the start point only.
pub(super) const START_ONLY: Digit =
    Digit { place: 2, most: 1, unknown: "a start point that is computed only (hundreds of `_GMODE`)" };

pub(super) const WHAT_AMODE: &str =
    "units: depth 0 absolute, 1 below the surface; tens: plane infeed 0 mm, 1 percent of the cutter";
pub(super) const READING: Digits = Digits { known: &[DEPTH, PERCENT, CHAMFER], other: "", doubt: None, checked: true };
pub(super) const AMODE: Parameter = digits("_AMODE", &READING, WHAT_AMODE);
