//! Stock removal on lathes: at a corner, and along a contour.

use crate::sema::cycle::row::{
    Digit, Digits, Parameter, Rule, Signature, count, digits, dwell, feed, length, number, words,
};

use super::{BUILT, Cycle, Need, Source, Work};

/// "Above 0" where 0 is what an empty field becomes.
const FEED: Rule = Rule::AboveOrEmpty(61003);

const PLANE: Parameter = number("_DMODE", "units: plane, 0 the active one, 2 G18").default("0");

const fn either(place: u32, unknown: &'static str) -> Digit {
    Digit { place, most: 1, unknown }
}

/// No digit has a known meaning.
const RESERVED: Digits = Digits { known: &[], other: "", doubt: None, checked: true };

/// Which limits of CYCLE952 are given, and whether they are valid.
const LIMITS: Digits = Digits {
    known: &[either(3, ""), either(4, ""), either(5, ""), either(6, ""), either(7, "")],
    other: "",
    doubt: None,
    checked: true,
};

/// How the blank counts; above the thousands stands what calls have stored without meaning.
const BLANK_MODE: Digits = Digits {
    known: &[either(1, ""), either(2, ""), either(3, ""), either(4, ""), either(5, ""), either(6, "")],
    other: "",
    doubt: None,
    checked: true,
};

/// The process of CYCLE952, beside the plane.
const PROCESS: Digits = Digits {
    known: &[
        Digit { place: 0, most: 2, unknown: "" },
        Digit {
            place: 1,
            most: 1,
            unknown: "another process than stock removal, as grooving or plunge turning (tens of `_DMODE`),",
        },
        Digit { place: 2, most: 0, unknown: "residual material (hundreds of `_DMODE`)" },
        either(4, ""),
    ],
    other: "",
    doubt: None,
    checked: true,
};

/// 0 absolute or a radius, 1 incremental or a chamfer.
const CORNER_MODE: Digits = Digits {
    known: &[
        either(0, "this reading of X1 (units of `_AMODE`)"),
        either(1, "this reading of Z1 (tens of `_AMODE`)"),
        either(2, "this reading of XM (hundreds of `_AMODE`)"),
        either(3, "this reading of ZM (thousands of `_AMODE`)"),
        either(4, "this kind of the first corner (ten thousands of `_AMODE`)"),
        either(5, "this kind of the second corner (hundred thousands of `_AMODE`)"),
        either(6, "this kind of the third corner (millions of `_AMODE`)"),
    ],
    other: "",
    doubt: Some((
        &[0, 1, 2, 3],
        "an incremental X1 or XM is a radius, and increments lead from X0 and Z0 into the material",
    )),
    checked: true,
};

const REMOVAL: &[Need] = &[Need::TurningPlane, Need::NoNormalOffset, Need::UnscaledFrame];

pub(super) const ROWS: &[Cycle] = &[
    Cycle {
        signature: Signature {
            name: "CYCLE95",
            what: "stock removal along a contour",
            status: BUILT,
            source: "SINUMERIK 840D cycles 11/2002; 808D ADVANCED turning 01/2017, p. 187",
            parameters: &[
                words("NPP", "contour: a program, or two labels \"START:END\"").needed(),
                length("MID", "greatest infeed, on the radius").unsigned(),
                length("FALZ", "allowance along Z").unsigned(),
                length("FALX", "allowance along X, on the radius").unsigned(),
                length("FAL", "allowance along the contour").unsigned(),
                feed("FF1", "feed of roughing").rule(FEED).default("F"),
                feed("FF2", "feed into relief cuts").rule(FEED).default("F"),
                feed("FF3", "feed of finishing").rule(FEED).default("F"),
                number("VARI", "1 to 4 rough, 5 to 8 finish, 9 to 12 both; along Z or X, outside or inside; 2 in front: steps stay").needed(),
                dwell("DT", "dwell to break the chip").unsigned().default("0"),
                length("DAM", "way after which the chip is broken").unsigned().default("0"),
                length("_VRT", "lift").unsigned().default("1 mm"),
                digits("_GMODE", &RESERVED, "reserved: 0").default("0"),
                PLANE,
            ],
        },
        needs: REMOVAL,
        work: Work::Along(Source::Argument, |call, contours| call.classic_removal(contours)),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE951",
            what: "stock removal at a corner",
            status: BUILT,
            source: "stored calls of SINUMERIK 840D sl",
            parameters: &[
                length("_SPD", "X0: corner of the blank, diameter").needed(),
                length("_SPL", "Z0: corner of the blank").needed(),
                length("_EPD", "X1: end point, diameter").needed(),
                length("_EPL", "Z1: end point").needed(),
                length("_ZPD", "XM: point between, diameter; `_NR` 2 only"),
                length("_ZPL", "ZM: point between; `_NR` 2 only"),
                number("_LAGE", "0 and 1 external, 2 and 3 internal; odd: from the front").rule(Rule::OneOf(0, 3)),
                length("_MID", "greatest infeed").unsigned(),
                length("_FALX", "allowance along X, on the radius").unsigned(),
                length("_FALZ", "allowance along Z").unsigned(),
                number("_VARI", "units 1 along Z, 2 along X; tens 1 rough, 2 finish, 3 both").needed(),
                length("_RF1", "corner at the front edge").unsigned().default("0"),
                length("_RF2", "corner between both edges").unsigned().default("0"),
                length("_RF3", "corner at the second side of the blank").unsigned().default("0"),
                length("_SDIS", "safety distance").unsigned(),
                feed("_FF1", "feed").rule(FEED).default("F"),
                number("_NR", "0 corner, 1 with transitions, 2 with oblique edges").rule(Rule::OneOf(0, 2)).default("0"),
                PLANE,
                digits("_AMODE", &CORNER_MODE, "X1, Z1, XM, ZM: 0 absolute, 1 incremental; RF1, RF2, RF3: 0 radius, 1 chamfer")
                    .default("0"),
            ],
        },
        needs: REMOVAL,
        work: Work::Plan(|call| call.corner_removal()),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE952",
            what: "stock removal along contours of CYCLE62",
            status: BUILT,
            source: "stored calls of SINUMERIK 840D sl; 840D sl turning 06/2019, p. 466",
            parameters: &[
                words("_PRG", "program that is made").without_effect("the control names a file by it"),
                words("_CON", "blank of the residual material, read"),
                words("_CONR", "blank of the residual material, written"),
                number("_VARI", "machining").needed(),
                feed("_F", "feed of roughing, or of finishing alone").rule(FEED).default("F"),
                feed("_FR", "feed into relief cuts").rule(FEED).default("that of roughing"),
                length("_RP", "retraction plane along X, diameter; 0 none").default("0"),
                length("_D", "greatest infeed").unsigned(),
                length("_DX", "infeed along X, parallel to the contour").unsigned().without_effect("cuts parallel to the contour are refused"),
                length("_DZ", "infeed along Z, parallel to the contour").unsigned().without_effect("cuts parallel to the contour are refused"),
                length("_UX", "allowance along X, on the radius").unsigned(),
                length("_UZ", "allowance along Z").unsigned(),
                length("_U", "allowance along the contour").unsigned(),
                length("_U1", "further allowance; valid by the thousands of `_AMODE`"),
                number("_BL", "blank: 1 cylinder, 2 allowance on the contour, 3 contour of CYCLE62").rule(Rule::OneOf(1, 3)),
                length("_XD", "blank along X: diameter, or on the contour by the tens of `_AMODE`"),
                length("_ZD", "blank along Z, or on the contour by the hundreds of `_AMODE`"),
                length("_XA", "limit along X, diameter; the limits are valid by `_GMODE`"),
                length("_ZA", "limit along Z"),
                length("_XB", "limit along X, diameter"),
                length("_ZB", "limit along Z"),
                length("_XDA", "first limit of the groove").without_effect("grooving only"),
                length("_XDB", "second limit of the groove").without_effect("grooving only"),
                count("_N", "number of grooves").without_effect("grooving only"),
                length("_DP", "distance of grooves").without_effect("grooving only"),
                length("_DI", "way after which the chip is broken").unsigned().default("0"),
                length("_SC", "safety distance").unsigned(),
                count("_DN", "number of the second edge").without_effect("grooving only"),
                digits("_GMODE", &LIMITS, "thousands 1: the limits are valid; above them: XA, ZA, XB, ZB are given").default("0"),
                digits(
                    "_DMODE",
                    &PROCESS,
                    "units: plane, 0 the active one, 2 G18; tens: 0 and 1 stock removal; ten thousands 1: the feeds count per minute, under G94 only",
                )
                .default("0"),
                digits("_AMODE", &BLANK_MODE, "tens and hundreds 1: `_XD` and `_ZD` count from the contour; thousands 1: `_U1` is valid")
                    .default("0"),
                number("_PK", "reserved: 0 or 1, as calls have it").rule(Rule::OneOf(0, 1)).default("0"),
                number("_DCH", "reserved: 0").rule(Rule::OneOf(0, 0)).default("0"),
                feed("_FS", "feed of finishing, after roughing").rule(FEED).default("that of roughing"),
            ],
        },
        needs: REMOVAL,
        work: Work::Along(Source::Turned, |call, contours| call.contour_removal(contours)),
    },
];
