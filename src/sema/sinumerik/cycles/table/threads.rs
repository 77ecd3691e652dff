//! Thread cycles: CYCLE97, CYCLE98, CYCLE99.

use crate::sema::cycle::row::{ANY_DIGITS, Parameter, Rule, Signature, angle, count, digits, length, number, words};

use super::{BUILT, Cycle, Need, Work};

const TURNING: &str = "SINUMERIK turning 01/2017, p. 205; SINUMERIK 840D cycles 11/2002";

const TEXT_OF_PITCH: &str = "text of the editor: the pitch stands beside it";
const LEAD: &str = "pitch, without sign: the spindle makes the hand of the thread";
const RUN_IN: &str = "run-in";
const RUN_OUT: &str = "run-out";
const DEPTH: &str = "depth of the thread, on the radius";
const LAST: &str = "finishing allowance, taken in one last pass";
const IANG: &str = "infeed angle: 0 radial, above 0 along one flank, below 0 along both in turns";
const NSP: &str = "angle of the spindle at which the first start begins";
const NRC: &str = "number of roughing passes";
const NID: &str = "number of passes at full depth";
const VARI: &str = "1 external, 2 internal with equal infeed; 3 external, 4 internal with equal cross-section";
const NUMT: &str = "number of starts";
const VRT: &str = "way of the lift-off outside the thread, on the radius";

/// What helps where a value has the wrong sign.
const SIGN: &str = "give the pitch without a sign; M3 or M4 makes the hand of the thread";
const LENGTHS: &str = "give the depth, the allowance, run-in and run-out without a sign";

const THREAD: &[Need] =
    &[Need::TurningPlane, Need::ActivePlane, Need::MainSpindle("the lead of a thread"), Need::TurningSpindle];

pub(super) const ROWS: &[Cycle] = &[
    Cycle {
        signature: Signature {
            name: "CYCLE97",
            what: "thread",
            status: BUILT,
            source: TURNING,
            parameters: &[
                length("PIT", LEAD).unsigned().or_else(61001, SIGN).default("that of MPIT"),
                length("MPIT", "pitch as a metric size, M3 to M60").unsigned().or_else(61001, SIGN).default("PIT"),
                length("SPL", "start along Z").needed(),
                length("FPL", "end along Z").needed(),
                length("DM1", "diameter at the start").needed(),
                length("DM2", "diameter at the end").needed(),
                length("APP", RUN_IN).unsigned().or_else(61001, LENGTHS).default("0"),
                length("ROP", RUN_OUT).unsigned().or_else(61001, LENGTHS).default("0"),
                length("TDEP", DEPTH).needed().unsigned().or_else(61001, LENGTHS),
                length("FAL", LAST).unsigned().or_else(61001, LENGTHS).default("0"),
                angle("IANG", IANG).default("0"),
                angle("NSP", NSP).default("0"),
                count("NRC", NRC).needed(),
                count("NID", NID).default("0"),
                number("VARI", VARI).needed().rule(Rule::OneOf(1, 4)).or_else(61002, ""),
                count("NUMT", NUMT).default("1"),
                length("_VRT", VRT).default("1 mm"),
            ],
        },
        needs: THREAD,
        work: Work::Plan(|call| call.single_thread()),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE98",
            what: "chain of threads",
            status: BUILT,
            source: TURNING,
            parameters: &[
                length("PO1", "first point along Z").needed(),
                length("DM1", "diameter at the first point").needed(),
                length("PO2", "second point along Z").needed(),
                length("DM2", "diameter at the second point").needed(),
                length("PO3", "third point along Z").needed(),
                length("DM3", "diameter at the third point").needed(),
                length("PO4", "last point along Z").needed(),
                length("DM4", "diameter at the last point").needed(),
                length("APP", RUN_IN).unsigned().or_else(61001, LENGTHS).default("0"),
                length("ROP", RUN_OUT).unsigned().or_else(61001, LENGTHS).default("0"),
                length("TDEP", DEPTH).needed().unsigned().or_else(61001, LENGTHS),
                length("FAL", LAST).unsigned().or_else(61001, LENGTHS).default("0"),
                angle("IANG", IANG).default("0"),
                angle("NSP", NSP).default("0"),
                count("NRC", NRC).needed(),
                count("NID", NID).default("0"),
                length("PP1", LEAD).needed().unsigned().or_else(61001, SIGN),
                length("PP2", LEAD).needed().unsigned().or_else(61001, SIGN),
                length("PP3", LEAD).needed().unsigned().or_else(61001, SIGN),
                number("VARI", VARI).needed().rule(Rule::OneOf(1, 4)).or_else(61002, ""),
                count("NUMT", NUMT).default("1"),
                length("_VRT", VRT).default("1 mm"),
                length("_MID", "first infeed; refused where it is not 0").default("0"),
                length("_GDEP", "refused where it is not 0").default("0"),
                length("_IFLANK", "infeed along the flank, as the angle makes it").default("not compared"),
                number("_PITA", "unit of the pitch: 0 or 1").default("0"),
                pitch_text("_PITM1"),
                pitch_text("_PITM2"),
                pitch_text("_PITM3"),
                digits("_DMODE", &ANY_DIGITS, "units: plane, 0 the active one, 2 G18"),
                digits("_AMODE", &ANY_DIGITS, "coded reading of positions; 0"),
            ],
        },
        needs: THREAD,
        work: Work::Plan(|call| call.chain_of_threads()),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE99",
            what: "thread of the editor",
            status: BUILT,
            source: "stored calls of SINUMERIK 840D sl; SINUMERIK 840D turning 03/2010, p. 369",
            parameters: &[
                length("_SPL", "start along Z").needed(),
                length("_SPD", "diameter at the start").needed(),
                length("_FPL", "end along Z").needed(),
                length("_FPD", "diameter at the end").default("that of the start"),
                length("_APP", RUN_IN).default("0"),
                length("_ROP", RUN_OUT).default("0"),
                length("_TDEP", DEPTH).needed(),
                length("_FAL", LAST).default("0"),
                angle("_IANG", IANG).default("0"),
                angle("_NSP", NSP).default("0"),
                count("_NRC", NRC).default("made of `_MID`"),
                count("_NID", NID).default("0"),
                length("_PIT", "pitch, above 0: the spindle makes the hand of the thread")
                    .needed()
                    .rule(Rule::Above(61001)),
                digits("_VARI", &ANY_DIGITS, "units as VARI of CYCLE97; 1310101 in stored calls"),
                count("_NUMTH", NUMT).default("1"),
                length("_SDIS", VRT).default("1 mm"),
                length("_MID", "first infeed, which makes the number of passes").default("`_NRC` counts"),
                length("_GDEP", "return distance of the editor: reported, changes no pass"),
                length("_PIT1", "change of the pitch; refused where it is not 0").default("0"),
                length("_FDEP", "refused where it is not 0").default("0"),
                length(
                    "_GST",
                    "first start that is cut: 1 for a thread of one start is reported, other values are refused",
                )
                .default("0"),
                length("_GUD", "refused where it is not 0").default("0"),
                length("_IFLANK", "infeed along the flank, as the angle makes it").default("not compared"),
                number("_PITA", "unit of the pitch: 0 of the program, 1 mm").default("0"),
                pitch_text("_PITM"),
                words("_PTAB", "table of the thread").without_effect("name of the table of the thread"),
                words("_PTABA", "size of the thread").without_effect("name of the thread: the pitch stands beside it"),
                digits("_DMODE", &ANY_DIGITS, "units: plane, 0 the active one, 2 G18"),
                digits("_AMODE", &ANY_DIGITS, "coded reading of positions; 0"),
                number("_S_XRS", "crowned thread; refused where it is not 0").default("0"),
            ],
        },
        needs: THREAD,
        work: Work::Plan(|call| call.thread_of_editor()),
    },
];

const fn pitch_text(name: &'static str) -> Parameter {
    words(name, "pitch as the editor shows it").without_effect(TEXT_OF_PITCH)
}
