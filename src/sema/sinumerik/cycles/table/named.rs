//! Cycles that are known by their names, so that a refusal can say what they are.

use crate::sema::cycle::row::{Signature, Status};

use super::{Cycle, Work};

const fn named(name: &'static str, what: &'static str) -> Cycle {
    let status = Status::Refused { code: "P9010" };
    Cycle { signature: Signature { name, what, status, source: "", parameters: &[] }, needs: &[], work: Work::Nothing }
}

/// What does the work of a cycle that is refused.
pub(in super::super::super) fn instead(name: &str) -> &'static str {
    match name {
        "CYCLE60" => "its glyphs are those of the control: engrave by the plain moves of a CAM system",
        "CYCLE73" | "CYCLE74" | "CYCLE75" => {
            "describe the outline and the islands for CYCLE62 and mill them by CYCLE63"
        }
        "CYCLE78" => "drill by CYCLE81 or CYCLE83 and mill the thread by CYCLE70",
        "CYCLE899" => "mill the open slot by CYCLE72 along its outline, or by plain moves",
        "CYCLE950" => "call the contours by CYCLE62 and cut them by CYCLE952",
        _ => "replace it by plain moves, or compile the program without it",
    }
}

pub(super) const MEASURING: &str = "measuring cycle";

pub(super) const ROWS: &[Cycle] = &[
    named("CYCLE60", "engraving"),
    named("CYCLE73", "pocket with islands"),
    named("CYCLE74", "contour of a pocket"),
    named("CYCLE75", "contour of an island"),
    named("CYCLE78", "drilling and thread milling"),
    named("CYCLE91", "machining cycle"),
    named("CYCLE210", "machining cycle"),
    named("CYCLE830", "deep-hole drilling 2"),
    named("CYCLE899", "open slot"),
    named("CYCLE950", "extended stock removal along a contour"),
    named("CYCLE961", MEASURING),
    named("CYCLE971", MEASURING),
    named("CYCLE972", MEASURING),
    named("CYCLE973", MEASURING),
    named("CYCLE974", MEASURING),
    named("CYCLE976", MEASURING),
    named("CYCLE977", MEASURING),
    named("CYCLE978", MEASURING),
    named("CYCLE979", MEASURING),
    named("CYCLE982", MEASURING),
    named("CYCLE994", MEASURING),
    named("CYCLE995", MEASURING),
    named("CYCLE996", MEASURING),
    named("CYCLE997", MEASURING),
    named("CYCLE998", MEASURING),
    named("CYCLE1001", "machining cycle"),
    named("E_DR", "drilling of ShopMill"),
    named("E_DR_SIN", "drilling of ShopMill"),
    named("F_DRILL", "drilling of ShopTurn"),
];
