//! Grooves and cut-off: CYCLE92, CYCLE93, CYCLE930.

use crate::sema::cycle::row::{
    ANY_DIGITS, Digit, Digits, Parameter, Rule, Signature, angle, count, digits, dwell, feed, length, number, speed,
};

use super::{BUILT, Cycle, Need, Work};

/// "Above 0" where 0 is what an empty field becomes.
const FEED: Rule = Rule::AboveOrEmpty(61003);

const fn digit(place: u32, most: i32) -> Digit {
    Digit { place, most, unknown: "" }
}

const DMODE: Parameter = digits("_DMODE", &ANY_DIGITS, "units: plane, 0 the active one, 2 G18");
const NO_DIGITS: Digits = Digits { known: &[], other: "", doubt: None, checked: true };

const SIDES: Digits = Digits { known: &[digit(0, 8), digit(1, 1)], other: "", doubt: None, checked: true };
const MACHINING: Digits =
    Digits { known: &[digit(1, 3), digit(2, 8), digit(3, 1), digit(4, 1)], other: "", doubt: None, checked: true };
const GROOVE_READING: Digits = Digits {
    known: &[digit(1, 1), digit(2, 1), digit(3, 1), digit(4, 1), digit(5, 1), digit(6, 1)],
    other: "",
    doubt: None,
    checked: true,
};
const CUT_READING: Digits = Digits { known: &[digit(4, 1)], other: "", doubt: None, checked: true };

const GROOVE: &[Need] = &[
    Need::Lathe,
    Need::TurningPlane,
    Need::NoNormalOffset,
    Need::ActivePlane,
    Need::UnscaledFrame,
    Need::ShiftFrame,
    Need::KnownPlace,
];

pub(super) const ROWS: &[Cycle] = &[
    Cycle {
        signature: Signature {
            name: "CYCLE92",
            what: "cut-off",
            status: BUILT,
            source: "SINUMERIK 828D turning 02/2012, p. 349; stored calls of SINUMERIK 840D sl",
            parameters: &[
                length("_SPD", "reference point, diameter").needed(),
                length("_SPL", "reference point along Z").needed(),
                length("_DIAG1", "diameter from which speed and feed are reduced").needed(),
                length("_DIAG2", "final diameter; below 0 beyond the centre").needed(),
                length("_RC", "radius or chamfer of the edge, by `_AMODE`").unsigned(),
                length("_SDIS", "safety distance").needed().rule(Rule::Above(61019)),
                speed("_SV1", "cutting speed (with `_SV2`) or turns a minute").unsigned().default("the speed in force"),
                speed("_SV2", "greatest turns a minute of a cutting speed").unsigned().default("`_SV1` is turns a minute"),
                number("_SDAC", "sense of the spindle: 3 M3, 4 M4").default("the sense in force"),
                feed("_FF1", "feed").rule(FEED).default("the feed in force"),
                feed("_FF2", "reduced feed").rule(FEED).default("`_FF1`"),
                speed("_SS2", "reduced speed, turns a minute").unsigned().default("the speed at `_DIAG1`"),
                length("_DIAGM", "diameter of the part catcher; refused above `_DIAG2`, see `[cycles] parts_gripper`"),
                digits("_VARI", &NO_DIGITS, "kind of machining: 0"),
                count("_DN", "number of the second edge"),
                DMODE,
                digits("_AMODE", &CUT_READING, "ten thousands: `_RC` is 0 a radius, 1 a chamfer"),
            ],
        },
        needs: GROOVE,
        work: Work::Plan(|call| call.cut_off()),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE93",
            what: "groove",
            status: BUILT,
            source: "SINUMERIK 840D cycles 11/2002",
            parameters: &[
                length("SPD", "start point, diameter").needed(),
                length("SPL", "start point along Z").needed(),
                length("WIDG", "width of the floor").needed().rule(Rule::Above(61019)),
                length("DIAG", "depth, on the radius").needed().rule(Rule::Above(61019)),
                angle("STA1", "inclination of the surface: 0, 180, on faces 90"),
                angle("ANG1", "angle of the flank at the start point").rule(Rule::Below90),
                angle("ANG2", "angle of the other flank").rule(Rule::Below90),
                length("RCO1", "edge at the start point: above 0 a radius, below 0 a chamfer"),
                length("RCO2", "other edge"),
                length("RCI1", "corner at the floor towards the start point"),
                length("RCI2", "other corner at the floor"),
                length("FAL1", "allowance on the floor").unsigned(),
                length("FAL2", "allowance on the flanks").unsigned(),
                length("IDEP", "greatest infeed").unsigned().default("the whole depth at once"),
                dwell("DTB", "dwell at the floor").unsigned(),
                digits(
                    "VARI",
                    &SIDES,
                    "units: 1, 5 outside, 3, 7 inside, 2, 4 rear, 6, 8 front face; tens: chamfers 0 by their length, 1 by their sides",
                )
                .needed(),
                length("_VRT", "retract that breaks the chip").unsigned().default("1 mm"),
                count("_DN", "number of the second edge"),
            ],
        },
        needs: GROOVE,
        work: Work::Plan(|call| call.groove_93()),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE930",
            what: "groove",
            status: BUILT,
            source: "SINUMERIK 840D sl turning 05/2017, p. 352; 06/2019, p. 411; stored calls",
            parameters: &[
                length("_SPD", "reference point, diameter").needed(),
                length("_SPL", "reference point along Z").needed(),
                length("_WIDG", "width of the floor").needed().rule(Rule::Above(61019)),
                length("_WIDG2", "width of the top").unsigned().default("as floor, depth and flanks make it"),
                length("_DIAG", "depth at the reference point, by `_AMODE`").needed(),
                length("_DIAG2", "depth on the other side, of inclined grooves only"),
                angle("_STA", "inclination; refused unless 0"),
                angle("_ANG1", "angle of the flank at the reference point").rule(Rule::Below90),
                angle("_ANG2", "angle of the other flank").rule(Rule::Below90),
                length("_RCO1", "edge at the reference point, by `_AMODE` a radius or a chamfer").unsigned(),
                length("_RCI1", "corner at the floor towards the reference point").unsigned(),
                length("_RCI2", "other corner at the floor").unsigned(),
                length("_RCO2", "other edge").unsigned(),
                length("_FAL", "allowance on all sides").unsigned(),
                length("_IDEP1", "infeed").unsigned().default("the whole depth at once"),
                length("_SDIS", "safety distance").needed().rule(Rule::Above(61019)),
                digits(
                    "_VARI",
                    &MACHINING,
                    "tens 1 roughs, 2 finishes, 3 does both; hundreds side as VARI of CYCLE93; thousands 1: reference point at the floor; ten thousands 1",
                )
                .needed(),
                count("_DN", "number of the second edge"),
                count("_NUM", "number of grooves").unsigned().default("1"),
                length("_DBH", "distance of the grooves"),
                feed("_FF1", "feed").rule(FEED).default("the feed in force"),
                number("_NR", "0 rectangular, 1 with flanks, 2 inclined; 2 is refused").rule(Rule::OneOf(0, 2)),
                length("_FALX", "allowance on X, on the radius").unsigned(),
                length("_FALZ", "allowance on Z").unsigned(),
                DMODE,
                digits(
                    "_AMODE",
                    &GROOVE_READING,
                    "tens `_DIAG`: 0 absolute, 1 incremental; thousands on `_RCO1`, `_RCI1`, `_RCI2`, `_RCO2`: 0 radius, 1 chamfer",
                ),
                digits("_GMODE", &NO_DIGITS, "refused unless 0"),
                number("S_FB", "feed at the floor; refused unless 0"),
            ],
        },
        needs: GROOVE,
        work: Work::Plan(|call| call.groove_930()),
    },
];
