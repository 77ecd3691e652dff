//! Faces, spigots, and what is milled along contours.

use crate::sema::cycle::row::{
    ANY_DIGITS, Digit, Digits, Parameter, Rule, Signature, angle, count, digits, feed, length, number, words,
};

use super::milled::{
    AMODE, CDIR, CHAMFER, DEPTH, DMODE, DP, FAL, FALD, FFD, FFP1, MID, MIDA, PA, PAIR, PERCENT, PO, RFP, RTP, SDIS,
    STA, START_ONLY, UMODE,
};
use super::{BUILT, Cycle, Source, Work};

const OLD: &str = "SINUMERIK 840D cycles 11/2002; 808D milling 07/2018, p. 189";
const STORED: &str = "SINUMERIK 840D cycles 11/2002; stored calls of SINUMERIK 840D sl";
const OF_CHAMFER: &str = "of chamfering, which is refused";

const FS: Parameter = length("_FS", "width of the chamfer").without_effect(OF_CHAMFER);
const ZFS: Parameter = length("_ZFS", "depth of the chamfer").without_effect(OF_CHAMFER);
const DPR: Parameter = length("_DPR", "depth below the surface; its sign is left out").default("DP counts");
const FACE_VARI: Parameter = digits(
    "_VARI",
    &ANY_DIGITS,
    "units: 1 roughs, 2 finishes; tens: 1 and 3 along the first axis, 2 and 4 along the second, 3 and 4 to and fro",
)
.needed();
const FACE: &str = "give its length, with the sign of its direction";
const SPIGOT_VARI: Parameter = digits("_VARI", &ANY_DIGITS, "1 roughs, 2 finishes").needed();

const SIZE: &str = "this reading of a side of the face (`_AMODE`)";
const OF_FACE: Digits = Digits {
    known: &[DEPTH, PERCENT, Digit { place: 3, most: 1, unknown: SIZE }, Digit { place: 4, most: 1, unknown: SIZE }],
    other: "",
    doubt: None,
    checked: true,
};
const OF_SPIGOT: Digits = Digits {
    known: &[START_ONLY, Digit { place: 3, most: 1, unknown: "this reference point (thousands of `_GMODE`)" }],
    other: "",
    doubt: None,
    checked: true,
};
const SPIGOT_GMODE: Parameter = digits("_GMODE", &OF_SPIGOT, "thousands: 0 and 1 the reference point is the centre");
const OF_PAIR: Digits = Digits { known: &[PAIR, CHAMFER], other: "", doubt: None, checked: true };
const AMODE_OF_PAIR: Parameter = digits("_AMODE", &OF_PAIR, "units: depth 0 by what is given, 1 by DPR, 2 by DP");

const ONLY_START: Digits = Digits { known: &[START_ONLY], other: "", doubt: None, checked: true };
const OF_DEPTH: Digits = Digits { known: &[DEPTH, CHAMFER], other: "", doubt: None, checked: true };
const APPROACH: &str = "units: 1 straight on, 2 quadrant, 3 semicircle; tens: 0 in the plane of the level, 1 in space";

pub(super) const ROWS: &[Cycle] = &[
    Cycle {
        signature: Signature {
            name: "CYCLE71",
            what: "face milling",
            status: BUILT,
            source: OLD,
            parameters: &[
                RTP,
                RFP,
                SDIS,
                length("_DP", "depth, absolute").default("0"),
                length("_PA", "corner of the face, first axis").default("0"),
                length("_PO", "corner of the face, second axis").default("0"),
                length("_LENG", "side along the first axis, signed").needed().rule(Rule::Size).or_else(61118, FACE),
                length("_WID", "side along the second axis, signed").needed().rule(Rule::Size).or_else(61118, FACE),
                angle("_STA", "rotation about the corner, 0 to below 180").default("0"),
                MID,
                length("_MIDA", "greatest infeed in the plane; the first path takes exactly this")
                    .default("0.8 of the cutter"),
                length("_FDP", "overrun at the ends of a path, and lift after a finished one").default("0"),
                FALD,
                FFP1,
                FACE_VARI,
                length("_FDP1", "overrun beyond the side of the last path").default("0"),
            ],
        },
        needs: &[],
        work: Work::Plan(|call| call.face()),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE61",
            what: "face milling",
            status: BUILT,
            source: STORED,
            parameters: &[
                RTP,
                RFP,
                SDIS,
                DP,
                PA,
                PO,
                length("_LENG", "end point or length along the first axis, by `_AMODE`"),
                length("_WID", "end point or length along the second axis, by `_AMODE`"),
                MID,
                MIDA,
                FALD,
                FFP1,
                FACE_VARI,
                digits("_LIM", &ANY_DIGITS, "walls: first axis minus, plus, second axis minus, plus, from the right")
                    .default("none"),
                DMODE,
                digits(
                    "_AMODE",
                    &OF_FACE,
                    "units: depth 0 absolute, 1 below the surface; tens: plane infeed 0 mm, 1 percent of the cutter; \
                     thousands and ten thousands: sides 0 by their end points, 1 by their lengths",
                ),
            ],
        },
        needs: &[],
        work: Work::Plan(|call| call.face_by_limits()),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE76",
            what: "rectangular spigot",
            status: BUILT,
            source: STORED,
            parameters: &[
                RTP,
                RFP,
                SDIS,
                DP,
                DPR,
                length("_LENG", "length").needed().rule(Rule::Size),
                length("_WID", "width").needed().rule(Rule::Size),
                length("_CRAD", "radius of the corners").default("0"),
                PA,
                PO,
                STA,
                MID,
                FAL,
                FALD,
                FFP1,
                FFD,
                CDIR,
                SPIGOT_VARI,
                length("_AP1", "length of the blank").default("refused where it roughs"),
                length("_AP2", "width of the blank").default("refused where it roughs"),
                FS,
                ZFS,
                SPIGOT_GMODE,
                DMODE,
                AMODE_OF_PAIR,
            ],
        },
        needs: &[],
        work: Work::Plan(|call| call.rectangular_spigot()),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE77",
            what: "circular spigot",
            status: BUILT,
            source: STORED,
            parameters: &[
                RTP,
                RFP,
                SDIS,
                DP,
                DPR,
                length("_CDIAM", "diameter; in the old form by `[cycles] spigot_size`").needed().rule(Rule::Size),
                PA,
                PO,
                MID,
                FAL,
                FALD,
                FFP1,
                FFD,
                CDIR,
                SPIGOT_VARI,
                length("_AP1", "diameter of the blank").default("refused where it roughs"),
                FS,
                ZFS,
                SPIGOT_GMODE,
                DMODE,
                AMODE_OF_PAIR,
            ],
        },
        needs: &[],
        work: Work::Plan(|call| call.circular_spigot()),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE79",
            what: "multi-edge",
            status: BUILT,
            source: STORED,
            parameters: &[
                RTP,
                RFP,
                SDIS,
                DP,
                count("_NUM", "number of edges").needed(),
                length("_SWL", "width across flats; length of an edge where their number is odd").needed().rule(Rule::Size),
                PA,
                PO,
                STA,
                length("_RC", "transition at the corners; refused").default("0"),
                length("_AP1", "diameter of the blank").default("refused where it roughs"),
                MIDA,
                MID,
                FAL,
                FALD,
                FFP1,
                CDIR,
                SPIGOT_VARI,
                FS,
                ZFS,
                SPIGOT_GMODE,
                DMODE,
                AMODE,
            ],
        },
        needs: &[],
        work: Work::Plan(|call| call.multi_edge()),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE72",
            what: "path milling",
            status: BUILT,
            source: "SINUMERIK NC programming 12/2019, p. 1053",
            parameters: &[
                words("_KNAME", "contour: a program, or \"START:END\" of labels").default("the one of CYCLE62"),
                RTP,
                RFP,
                SDIS,
                DP,
                MID,
                FAL,
                FALD,
                FFP1,
                FFD,
                digits(
                    "_VARI",
                    &ANY_DIGITS,
                    "units: 1 roughs, 2 finishes; tens: back to the start at 0 G0, 1 G1; hundreds: lift to 0 the retraction plane, \
                     1 the safety distance above the surface, 2 by the safety distance, 3 none; ten thousands: 1 backwards",
                )
                .needed(),
                number("_RL", "41 the cutter is left of the contour, 42 right, 40 on it").needed(),
                digits("_AS1", &ANY_DIGITS, APPROACH).needed(),
                length("_LP1", "length of the line from the cutter's edge, or radius of the arc of its centre").needed(),
                feed("_FF3", "feed back to the start, where the tens of `_VARI` are 1").default("F"),
                digits("_AS2", &ANY_DIGITS, APPROACH).needed(),
                length("_LP2", "as `_LP1`, from the contour").needed(),
                UMODE,
                FS,
                ZFS,
                digits("_GMODE", &ONLY_START, "0"),
                DMODE,
                digits("_AMODE", &OF_DEPTH, "units: depth 0 absolute, 1 below the surface"),
            ],
        },
        needs: &[],
        work: Work::Along(Source::Single, |call, contours| call.path_milling(contours)),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE70",
            what: "thread milling",
            status: BUILT,
            source: "stored calls of SINUMERIK 840D sl",
            parameters: &[
                RTP,
                RFP,
                SDIS,
                DP,
                length("_DIATH", "nominal diameter").needed().rule(Rule::Size),
                length("_H1", "depth of the thread, on the radius").needed().rule(Rule::Size),
                length("_FAL", "allowance that roughing leaves").default("0"),
                length("_PIT", "pitch, in the unit of `_PITA`").needed().rule(Rule::Above(61001)),
                count("_NT", "teeth of an edge of the cutter").default("1"),
                length("_MID", "greatest infeed of a pass").default("one pass"),
                feed("_FFR", "feed").default("F"),
                number("_TYPTH", "0 internal, 1 external").default("0"),
                PA,
                PO,
                angle("_NSP", "angle at which the thread begins").default("0"),
                digits(
                    "_VARI",
                    &ANY_DIGITS,
                    "units: 1 roughs, 2 finishes; by `[cycles] thread_milling_digits` tens: 1 down, 2 up, hundreds: 1 left-hand",
                )
                .needed(),
                number("_PITA", "unit of the pitch: 0 of the program, 1 mm").default("0"),
                words("_PITM", "pitch as the editor shows it").without_effect("text of the editor: the pitch stands beside it"),
                words("_PTAB", "table of the thread").without_effect("name of the table of the thread"),
                words("_PTABA", "size of the thread").without_effect("name of the thread: the pitch stands beside it"),
                digits("_GMODE", &ONLY_START, "0"),
                DMODE,
                digits("_AMODE", &OF_DEPTH, "units: depth 0 absolute, 1 below the surface"),
            ],
        },
        needs: &[],
        work: Work::Plan(|call| call.thread_by_depth()),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE90",
            what: "thread milling",
            status: BUILT,
            source: "SINUMERIK 840D cycles 11/2002",
            parameters: &[
                length("RTP", "retraction plane").needed(),
                length("RFP", "reference plane: the surface").needed(),
                length("SDIS", "safety distance above the surface, and beside an external thread").default("0"),
                length("DP", "depth").default("DPR counts"),
                length("DPR", "depth below the surface; its sign is left out").default("DP counts"),
                length("DIATH", "nominal diameter").needed().rule(Rule::Size),
                length("KDIAM", "diameter of the core").needed().rule(Rule::Size),
                length("PIT", "pitch").needed().rule(Rule::Above(61001)),
                feed("FFR", "feed").default("F"),
                number("CDIR", "0 climb, 1 conventional, 2 G2, 3 G3").default("0"),
                number("TYPTH", "0 internal, 1 external").default("0"),
                length("CPA", "centre, first axis").default("0"),
                length("CPO", "centre, second axis").default("0"),
            ],
        },
        needs: &[],
        work: Work::Plan(|call| call.thread_by_core()),
    },
];
