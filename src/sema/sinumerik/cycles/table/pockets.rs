//! Pockets, slots and long holes.

use crate::sema::cycle::row::{
    ANY_DIGITS, Digit, Digits, Parameter, Rule, Signature, angle, count, digits, feed, length, number, speed, words,
};

use super::milled::{
    AMODE, CDIR, CHAMFER, DMODE, DP, FAL, FALD, FFD, FFP1, MID, MIDA, MODE, MODE_FEEDS, MODE_PLANE, PA, PAIR, PO, RFP,
    RTP, SDIS, STA, START_ONLY, UMODE,
};
use super::{BUILT, Cycle, Source, Work};

const STORED: &str = "SINUMERIK 840D cycles 11/2002; stored calls of SINUMERIK 840D sl";
const OLD: &str = "SINUMERIK 840D cycles 11/2002";
const OF_CHAMFER: &str = "of chamfering, which is refused";

const FS: Parameter = length("_FS", "width of the chamfer").without_effect(OF_CHAMFER);
const ZFS: Parameter = length("_ZFS", "depth of the chamfer").without_effect(OF_CHAMFER);
const VARI: Parameter = digits(
    "_VARI",
    &ANY_DIGITS,
    "units: 1 roughs, 2 finishes, 3 the floor, 4 the wall; tens: 0 down at rapid traverse, 1 at the feed, 2 helix, 3 to and fro",
)
.needed();
const LENG: Parameter = length("_LENG", "length").needed().rule(Rule::Size);
const WID: Parameter = length("_WID", "width").needed().rule(Rule::Size);
const CRAD: Parameter = length("_CRAD", "radius of the corners").default("the radius of the cutter");
const DEPTH_CLEARED: Parameter = length("_AD", "depth that was cleared before").default("0");
const DP1: Parameter = length("_DP1", "depth of one turn of the helix");

/// Hundreds, reference point by the thousands, what was cleared before by the ten thousands.
const REFERENCE: Digits = Digits {
    known: &[START_ONLY, Digit { place: 3, most: 5, unknown: "this reference point (thousands of `_GMODE`)" }, BEFORE],
    other: "",
    doubt: None,
    checked: true,
};
const BEFORE: Digit = Digit { place: 4, most: 2, unknown: "this reading of `_AP1` (ten thousands of `_GMODE`)" };
const CENTRE: Digits = Digits {
    known: &[START_ONLY, Digit { place: 3, most: 1, unknown: "this reference point (thousands of `_GMODE`)" }, BEFORE],
    other: "",
    doubt: None,
    checked: true,
};
const SLOT_CENTRE: Digits = Digits {
    known: &[START_ONLY, Digit { place: 3, most: 1, unknown: "this reference point (thousands of `_GMODE`)" }],
    other: "",
    doubt: None,
    checked: true,
};
/// Plane, feeds, and what CYCLE63 mills: 2 in the hundreds is a spigot.
const POCKET_MODE: Digits = Digits {
    known: &[
        MODE_PLANE,
        MODE_FEEDS,
        Digit { place: 2, most: 1, unknown: "a spigot (hundreds of `_DMODE`; 0 and 1 are a pocket)" },
    ],
    other: "",
    doubt: None,
    checked: true,
};
const PLAIN: Digits = Digits { known: &[START_ONLY], other: "", doubt: None, checked: true };
const OF_PAIR: Digits = Digits { known: &[PAIR, CHAMFER], other: "", doubt: None, checked: true };
const AMODE_OF_PAIR: Parameter = digits("_AMODE", &OF_PAIR, "units: depth 0 by what is given, 1 by DPR, 2 by DP");

const O_RTP: Parameter = length("RTP", "retraction plane").needed();
const O_RFP: Parameter = length("RFP", "reference plane: the surface").needed();
const O_SDIS: Parameter = length("SDIS", "safety distance above the surface; its sign is left out").default("0");
const O_DP: Parameter = length("DP", "depth").default("DPR counts");
const O_DPR: Parameter = length("DPR", "depth below the surface; its sign is left out").default("DP counts");
const NUM: Parameter = count("NUM", "how many").default("1");
const CPA: Parameter = length("CPA", "centre of the circle, first axis").default("0");
const CPO: Parameter = length("CPO", "centre of the circle, second axis").default("0");
const CENTRE_1: Parameter = length("CPA", "centre of the pocket, first axis").default("0");
const CENTRE_2: Parameter = length("CPO", "centre of the pocket, second axis").default("0");
const RAD: Parameter = length("RAD", "radius of the circle").default("0");
const STA1: Parameter = angle("STA1", "angle of the first one").default("0");
const INDA: Parameter = angle("INDA", "angle from one to the next").default("spread over a turn");
const O_FFD: Parameter = feed("FFD", "feed in depth").default("F");
const O_FFP1: Parameter = feed("FFP1", "feed in the plane").default("F");
const O_MID: Parameter = length("MID", "greatest infeed in depth").default("one level");
const O_CDIR: Parameter = number("CDIR", "0 climb, 1 conventional, 2 G2, 3 G3").default("0");
const O_FAL: Parameter = length("FAL", "allowance on the wall").default("0");
const O_VARI: Parameter = digits("VARI", &ANY_DIGITS, "0 complete, 1 roughs, 2 finishes").default("0");
const SLOT_VARI: Parameter = digits(
    "VARI",
    &ANY_DIGITS,
    "units: 0 complete, 1 roughs, 2 finishes, 4 the wall; tens: 0 down at rapid traverse, 1 at the feed, 3 to and fro",
)
.default("0");
const MIDF: Parameter = length("MIDF", "greatest infeed in depth of finishing").default("one level");
const FFP2: Parameter = feed("FFP2", "feed of finishing").default("FFP1");
const SSF: Parameter = speed("SSF", "speed of finishing").default("unchanged");

pub(super) const ROWS: &[Cycle] = &[
    Cycle {
        signature: Signature {
            name: "POCKET1",
            what: "rectangular pocket",
            status: BUILT,
            source: OLD,
            parameters: &[
                O_RTP,
                O_RFP,
                O_SDIS,
                O_DP,
                O_DPR,
                length("LENG", "length").needed().rule(Rule::Size),
                length("WID", "width").needed().rule(Rule::Size),
                length("CRAD", "radius of the corners").default("the radius of the cutter"),
                CENTRE_1,
                CENTRE_2,
                angle("STA1", "rotation").default("0"),
                O_FFD,
                O_FFP1,
                O_MID,
                O_CDIR,
                O_FAL,
                O_VARI,
                MIDF,
                FFP2,
                SSF,
            ],
        },
        needs: &[],
        work: Work::Plan(|call| call.old_rectangular_pocket()),
    },
    Cycle {
        signature: Signature {
            name: "POCKET2",
            what: "circular pocket",
            status: BUILT,
            source: OLD,
            parameters: &[
                O_RTP,
                O_RFP,
                O_SDIS,
                O_DP,
                O_DPR,
                length("PRAD", "radius").needed().rule(Rule::Size),
                CENTRE_1,
                CENTRE_2,
                O_FFD,
                O_FFP1,
                O_MID,
                O_CDIR,
                O_FAL,
                O_VARI,
                MIDF,
                FFP2,
                SSF,
            ],
        },
        needs: &[],
        work: Work::Plan(|call| call.old_circular_pocket()),
    },
    Cycle {
        signature: Signature {
            name: "POCKET3",
            what: "rectangular pocket",
            status: BUILT,
            source: STORED,
            parameters: &[
                RTP,
                RFP,
                SDIS,
                DP,
                LENG,
                WID,
                CRAD,
                PA,
                PO,
                STA,
                MID,
                FAL,
                FALD,
                FFP1,
                FFD,
                CDIR,
                VARI,
                MIDA,
                length("_AP1", "length that was cleared before").default("0"),
                length("_AP2", "width that was cleared before").default("0"),
                DEPTH_CLEARED,
                length("_RAD1", "radius of the helix; to and fro: greatest angle, degrees"),
                DP1,
                UMODE,
                FS,
                ZFS,
                digits(
                    "_GMODE",
                    &REFERENCE,
                    "thousands: `_PA`, `_PO` 0 and 1 the centre, 2 to 5 a corner; ten thousands: 1 nothing was cleared before",
                ),
                DMODE,
                AMODE,
            ],
        },
        needs: &[],
        work: Work::Plan(|call| call.rectangular_pocket()),
    },
    Cycle {
        signature: Signature {
            name: "POCKET4",
            what: "circular pocket",
            status: BUILT,
            source: STORED,
            parameters: &[
                RTP,
                RFP,
                SDIS,
                DP,
                length("_CDIAM", "diameter; the radius in a call of 19 arguments").needed().rule(Rule::Size),
                PA,
                PO,
                MID,
                FAL,
                FALD,
                FFP1,
                FFD,
                CDIR,
                digits("_VARI", &ANY_DIGITS, "as of POCKET3; thousands: 0 level by level, 1 on helices").needed(),
                MIDA,
                length("_AP1", "diameter that was cleared before").default("0"),
                DEPTH_CLEARED,
                length("_RAD1", "radius of the helix"),
                DP1,
                UMODE,
                FS,
                ZFS,
                digits("_GMODE", &CENTRE, "ten thousands: 1 nothing was cleared before"),
                DMODE,
                AMODE,
            ],
        },
        needs: &[],
        work: Work::Plan(|call| call.circular_pocket()),
    },
    Cycle {
        signature: Signature {
            name: "SLOT1",
            what: "slots on a circle",
            status: BUILT,
            source: STORED,
            parameters: &[
                O_RTP,
                O_RFP,
                O_SDIS,
                O_DP,
                O_DPR,
                NUM,
                length("LENG", "length over the outer edges").needed().rule(Rule::Size),
                length("WID", "width").needed().rule(Rule::Size),
                CPA,
                CPO,
                RAD,
                STA1,
                INDA,
                O_FFD,
                O_FFP1,
                O_MID,
                O_CDIR,
                O_FAL,
                SLOT_VARI,
                MIDF,
                FFP2,
                SSF,
                FALD,
                angle("_STA2", "greatest angle of going to and fro").default("one stroke"),
                length("_DP1", "depth of one turn").without_effect("of a helix, which is refused in slots"),
                UMODE,
                FS,
                ZFS,
                digits("_GMODE", &SLOT_CENTRE, "thousands: 1 the slot lies about CPA and CPO"),
                digits("_DMODE", &MODE, "units: plane, as of POCKET3; thousands 1: a single slot"),
                AMODE_OF_PAIR,
            ],
        },
        needs: &[],
        work: Work::Plan(|call| call.slots()),
    },
    Cycle {
        signature: Signature {
            name: "SLOT2",
            what: "circular slots on a circle",
            status: BUILT,
            source: STORED,
            parameters: &[
                O_RTP,
                O_RFP,
                O_SDIS,
                O_DP,
                O_DPR,
                NUM,
                angle("AFSL", "angle between the centres of the round ends")
                    .needed()
                    .or_else(61118, "give an angle above 0 and below 360 degrees"),
                length("WID", "width").needed().rule(Rule::Size),
                CPA,
                CPO,
                length("RAD", "radius of the circle").needed().rule(Rule::Size),
                STA1,
                INDA,
                O_FFD,
                O_FFP1,
                O_MID,
                O_CDIR,
                O_FAL,
                SLOT_VARI,
                MIDF,
                FFP2,
                SSF,
                feed("_FFCP", "feed on the circle from slot to slot").default("straight at rapid traverse"),
                UMODE,
                FS,
                ZFS,
                digits("_GMODE", &PLAIN, "0"),
                DMODE,
                AMODE_OF_PAIR,
            ],
        },
        needs: &[],
        work: Work::Plan(|call| call.circular_slots()),
    },
    Cycle {
        signature: Signature {
            name: "LONGHOLE",
            what: "long holes on a circle",
            status: BUILT,
            source: STORED,
            parameters: &[
                O_RTP,
                RFP,
                O_SDIS,
                O_DP,
                O_DPR,
                NUM,
                length("LENG", "length over the outer edges").needed().rule(Rule::Size),
                CPA,
                CPO,
                RAD,
                STA1,
                INDA,
                O_FFD,
                O_FFP1,
                O_MID,
                number("_VARI", "0").default("0"),
                UMODE,
                digits("_GMODE", &PLAIN, "0"),
                DMODE,
                AMODE_OF_PAIR,
            ],
        },
        needs: &[],
        work: Work::Plan(|call| call.long_holes()),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE63",
            what: "contour pocket",
            status: BUILT,
            source: "stored calls of SINUMERIK 840D sl",
            parameters: &[
                words("_PRG", "program that is made").without_effect("name of a program that the control makes"),
                digits(
                    "_VARI",
                    &ANY_DIGITS,
                    "units: 1 roughs, 3 finishes the floor, 4 the wall; tens: 0 straight down, 1 helix, 2 to and fro; \
                     thousands: lifts 0 to `_RP`, 1 to the safety distance; ten thousands: 1 begins at `_XS`, `_YS`",
                )
                .needed(),
                length("_RP", "retraction plane").needed(),
                length("_Z0", "reference plane: the surface").needed(),
                length("_SC", "safety distance above the surface; its sign is left out").default("0"),
                length("_Z1", "depth, absolute or below the surface by `_AMODE`").default("0"),
                feed("_F", "feed in the plane").default("F"),
                feed("_FZ", "feed in depth").default("F"),
                length("_DXY", "greatest infeed in the plane; percent of the cutter by `_AMODE`")
                    .default("0.8 of the cutter"),
                length("_MID", "greatest infeed in depth").default("one level"),
                length("_UXY", "allowance on the wall").default("0"),
                length("_UZ", "allowance on the floor").default("0"),
                number("_CDIR", "0 climb, 1 conventional, 2 G2, 3 G3").default("0"),
                length("_XS", "start point, first axis").default("0"),
                length("_YS", "start point, second axis").default("0"),
                length("_ER", "radius of the helix").default("0"),
                length("_EP", "depth of one turn of the helix"),
                angle("_EW", "greatest angle of going to and fro"),
                FS,
                ZFS,
                words("_TR", "tool whose residual material is milled; refused").default("none"),
                number("_DR", "its edge; reported, as `_TR` is empty"),
                UMODE,
                digits("_GMODE", &PLAIN, "0"),
                digits("_DMODE", &POCKET_MODE, "as of POCKET3; hundreds 0 and 1: a pocket"),
                AMODE,
            ],
        },
        needs: &[],
        work: Work::Along(Source::Milled, |call, contours| call.contour_pocket(contours)),
    },
];
