//! CYCLE81 to CYCLE89 and CYCLE840.

use crate::ir::Feed;
use crate::ir::cycle::drilling::Method;
use crate::sema::cycle::row::{
    ANY_DIGITS, Digit, Digits, Parameter, Rule, Signature, angle, digits, dwell, feed, length, number, speed, words,
};

use super::super::names::{DTB, FFR, RFF, SDIR};
use super::{BUILT, Cycle, Hole, Need, Work};

const STANDARD: &str = "standard cycles V06.02.09; SINUMERIK 840D cycles 11/2002";
const OLD: &str = "SINUMERIK 840D cycles 11/2002";

const RTP: Parameter = length("RTP", "retraction plane").needed();
const RFP: Parameter = length("RFP", "reference plane: the surface").needed();
const SDIS: Parameter = length("SDIS", "safety distance above the surface; its sign is left out").default("0");
const DP: Parameter = length("DP", "depth").default("0, unless DPR is given");
const DPR: Parameter = length("DPR", "depth below the surface; its sign is left out").default("DP counts");
const DWELL: Parameter = dwell("DTB", "dwell at the depth; below 0 in turns of the spindle").default("0");
const DIRECTION: Parameter =
    number("SDIR", "spindle: 3 M3, 4 M4").needed().rule(Rule::OneOf(3, 4)).or_else(61102, "give 3 or 4");
const AXN: Parameter = number("_AXN", "drilling axis: 1, 2 or 3, 0 the tool axis").default("0");
const PITA: Parameter =
    number("_PITA", "unit of the pitch: 0 of the program, 1 mm, 2 turns per inch, 3 inch").default("0");
const MPIT: Parameter = length("MPIT", "pitch as a metric size, M3 to M48; below 0 a left-hand thread").default("PIT");
const PIT: Parameter = length("PIT", "pitch; below 0 a left-hand thread").default("that of MPIT");
const PITM: Parameter =
    words("_PITM", "pitch as the editor shows it").without_effect("text of the editor: the pitch stands beside it");
const PTAB: Parameter = words("_PTAB", "table of the thread").without_effect("name of the table of the thread");
const PTABA: Parameter =
    words("_PTABA", "size of the thread").without_effect("name of the thread: the pitch stands beside it");
/// What helps where a value has the wrong sign.
const NO_SIGN: &str = "give `_VRT` and `_DIS1` without a sign; 0 for the values of the cycle";
const HAND: &str = "the sign of the pitch makes the hand of the thread";
const DMODE: Parameter = digits("_DMODE", &ANY_DIGITS, "units: plane, 0 the active one, 1 G17, 2 G18, 3 G19");
const WHAT_GMODE: &str = "how the depth counts; tens: 0 of the tip, 1 of the shank";
const WHAT_AMODE: &str =
    "units: depth 0 by what is given, 1 by DPR, 2 by DP; tens: dwell 0 by its sign, 1 seconds, 2 turns";
const AMODE: Parameter = digits("_AMODE", &READING, WHAT_AMODE);
const PLAIN_GMODE: Parameter = digits("_GMODE", &GEOMETRY, "how the depth counts; 0");

/// No digit is known.
const GEOMETRY: Digits = Digits { known: &[SHANK_UNKNOWN], other: OTHER_GEOMETRY, doubt: None, checked: true };
const OTHER_GEOMETRY: &str = "this reading of the geometry (`_GMODE`)";
const SHANK_UNKNOWN: Digit =
    Digit { place: 1, most: 0, unknown: "a depth by the shank of the tool (tens of `_GMODE`)" };
/// The tens by the shank.
const SHANK: Digits =
    Digits { known: &[Digit { most: 1, ..SHANK_UNKNOWN }], other: OTHER_GEOMETRY, doubt: None, checked: true };
/// The tens by the diameter of the centring.
const CENTRING: Digits = Digits {
    known: &[Digit { place: 1, most: 1, unknown: "this reading of DP (tens of `_GMODE`)" }],
    other: OTHER_GEOMETRY,
    doubt: None,
    checked: true,
};
/// The units say whether the tool lifts off.
const LIFT: Digits = Digits {
    known: &[Digit { place: 0, most: 2, unknown: OTHER_GEOMETRY }, SHANK_UNKNOWN],
    other: OTHER_GEOMETRY,
    doubt: None,
    checked: true,
};

const DEPTH: Digit = Digit { place: 0, most: 2, unknown: "this reading of the depth (units of `_AMODE`)" };
const OF_DWELL: Digit = Digit { place: 1, most: 2, unknown: "this unit of the dwell (tens of `_AMODE`)" };
const READING: Digits = Digits { known: &[DEPTH, OF_DWELL], other: "", doubt: None, checked: true };
/// All eight digits were seen as 1 in stored calls, and the hundred thousands as 2.
const PECKING: Digits = Digits {
    known: &[
        DEPTH,
        OF_DWELL,
        of_pecks(2),
        of_pecks(3),
        Digit { place: 4, most: 1, unknown: "this reading of the first depth (`_AMODE`)" },
        Digit { place: 5, most: 2, unknown: "this reading of the degression (`_AMODE`)" },
        of_pecks(6),
        Digit { place: 7, most: 1, unknown: "this reading of the first feed (`_AMODE`)" },
    ],
    other: OTHER_PECK,
    doubt: None,
    checked: true,
};
const OTHER_PECK: &str = "this reading of a dwell or a distance (`_AMODE`)";

const fn of_pecks(place: u32) -> Digit {
    Digit { place, most: 1, unknown: OTHER_PECK }
}

/// The thousands are the hand of the thread; the millions are 1 in all stored calls.
const TAPPING: Digits = Digits {
    known: &[
        DEPTH,
        OF_DWELL,
        Digit { place: 3, most: 2, unknown: "this hand of the thread (thousands of `_AMODE`)" },
        Digit { place: 6, most: 1, unknown: "" },
    ],
    other: "",
    doubt: None,
    checked: true,
};
/// As in CYCLE84; no stored call is at hand.
const CHUCK: Digits = Digits {
    known: &[DEPTH, OF_DWELL, Digit { place: 3, most: 1, unknown: "" }, Digit { place: 6, most: 1, unknown: "" }],
    other: "",
    doubt: Some((&[3, 6], "1 in the thousands and in the millions of `_AMODE` is read as in CYCLE84")),
    checked: true,
};

const TAPS: Need = Need::MainSpindle("tapping");

pub(super) const ROWS: &[Cycle] = &[
    Cycle {
        signature: Signature {
            name: "CYCLE81",
            what: "drilling, centring",
            status: BUILT,
            source: STANDARD,
            parameters: &[
                RTP,
                RFP,
                SDIS,
                length("DP", "depth; with 1 in the tens of `_GMODE` the diameter of the centring"),
                DPR,
                DWELL,
                digits("_GMODE", &CENTRING, "tens: DP is 0 a depth, 1 the diameter of the centring"),
                DMODE,
                AMODE,
            ],
        },
        needs: &[],
        work: Work::Hole(Hole {
            feed: |call| call.cycle_feed(),
            method: |call, _, _| Ok(Method::Drill { dwell: call.dwell_at_depth(DTB)? }),
            centring: true,
            modal_feed: true,
        }),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE82",
            what: "drilling, counterboring",
            status: BUILT,
            source: STANDARD,
            parameters: &[
                RTP,
                RFP,
                SDIS,
                DP,
                DPR,
                DWELL,
                digits("_GMODE", &SHANK, WHAT_GMODE),
                DMODE,
                AMODE,
                digits(
                    "_VARI",
                    &ANY_DIGITS,
                    "thousands, ten thousands 1: slow zones at both ends, see `[cycles] cycle82_vari`",
                ),
                length("S_ZA", "depth of predrilling; reported where its digit of `_VARI` is 0"),
                number("S_FA", "feed of predrilling, percent; reported where its digit of `_VARI` is 0"),
                length("S_ZD", "rest of through-drilling; reported where its digit of `_VARI` is 0"),
                number("S_FD", "feed of through-drilling, percent; reported where its digit of `_VARI` is 0"),
            ],
        },
        needs: &[],
        work: Work::Hole(Hole {
            feed: |call| call.cycle_feed(),
            method: |call, _, _| call.counterbore(),
            centring: false,
            modal_feed: true,
        }),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE83",
            what: "deep-hole drilling",
            status: BUILT,
            source: STANDARD,
            parameters: &[
                RTP,
                RFP,
                SDIS,
                DP,
                DPR,
                length("FDEP", "first depth").default("FDPR counts"),
                length("FDPR", "first depth below the surface; goes before FDEP").default("FDEP counts"),
                number("DAM", "above 0 an amount by which each step is shorter, below 0 the factor")
                    .default("equal steps"),
                dwell("DTB", "dwell at the depth of each step; below 0 in turns").default("0"),
                dwell("DTS", "dwell at the start plane; below 0 in turns").default("0"),
                number("FRF", "factor on the feed of the first step, 0.001 to 1; percent by `_AMODE`").default("1"),
                number("VARI", "0 breaks the chip, 1 removes it").rule(Rule::OneOf(0, 1)),
                AXN,
                length("_MDEP", "least step, where DAM is a factor").default("0"),
                length("_VRT", "way back to break the chip").unsigned().or_else(0, NO_SIGN).default("1 mm"),
                dwell("_DTD", "dwell at the last depth; below 0 in turns").default("DTB"),
                length("_DIS1", "distance above the last depth, where rapid traverse ends")
                    .unsigned()
                    .or_else(0, NO_SIGN)
                    .default("0.6 mm to 30 mm deep, then a fiftieth of the depth, at most 7 mm"),
                digits("_GMODE", &SHANK, WHAT_GMODE),
                DMODE,
                digits(
                    "_AMODE",
                    &PECKING,
                    "as of CYCLE82; hundred thousands 2: DAM in percent; ten millions 1: FRF in percent",
                ),
            ],
        },
        needs: &[],
        work: Work::Hole(Hole {
            feed: |call| call.cycle_feed(),
            method: |call, levels, _| call.peck(levels),
            centring: false,
            modal_feed: true,
        }),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE84",
            what: "rigid tapping",
            status: BUILT,
            source: STANDARD,
            parameters: &[
                RTP,
                RFP,
                SDIS,
                DP,
                DPR,
                DWELL,
                number("SDAC", "spindle afterwards: 3 M3, 4 M4, 5 M5").default("5"),
                MPIT,
                PIT,
                angle("POSS", "angle of the spindle before").default("no stop"),
                speed("SST", "speed on the way in").unsigned().or_else(16763, HAND).default("S"),
                speed("SST1", "speed on the way out").unsigned().or_else(16763, HAND).default("SST"),
                AXN,
                PITA,
                number("_TECHNO", "speed and accuracy: reported, changes no move"),
                digits("_VARI", &ANY_DIGITS, "0 in one go, 1 breaks the chip, 2 removes it").default("0"),
                length("_DAM", "depth of a step; its sign is left out").default("refused where `_VARI` is not 0"),
                length("_VRT", "way back to break the chip, or distance above the last depth").default("1 mm"),
                PITM,
                PTAB,
                PTABA,
                PLAIN_GMODE,
                DMODE,
                digits(
                    "_AMODE",
                    &TAPPING,
                    "as of CYCLE82; thousands: 0 hand by the sign of the pitch, 1 right, 2 left",
                ),
            ],
        },
        needs: &[Need::FixedSpeed, TAPS],
        work: Work::Hole(Hole {
            feed: |call| Ok(call.st.feed.word().unwrap_or(Feed::PerMinute(1.0))),
            method: |call, levels, _| call.rigid_tap(levels),
            centring: false,
            modal_feed: true,
        }),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE840",
            what: "tapping with compensating chuck",
            status: BUILT,
            source: "SINUMERIK 840D cycles 11/2002, p. 86",
            parameters: &[
                RTP,
                RFP,
                SDIS,
                DP,
                DPR,
                DWELL,
                number("SDR", "spindle on the way out: 3 M3, 4 M4, 0 the other one").default("0"),
                number("SDAC", "spindle afterwards: 3 M3, 4 M4, 5 M5").default("as before, where SDR is 0"),
                number("ENC", "0 encoder, 20 encoder and dwell, 1 feed F, 11 feed of S and the pitch").default("0"),
                MPIT,
                PIT,
                AXN,
                PITA,
                number("_TECHNO", "speed and accuracy: reported, changes no move"),
                PITM,
                PTAB,
                PTABA,
                PLAIN_GMODE,
                DMODE,
                digits("_AMODE", &CHUCK, WHAT_AMODE),
            ],
        },
        needs: &[Need::FixedSpeed, TAPS],
        work: Work::Hole(Hole {
            feed: |call| call.feed_of_chuck(),
            method: |call, _, _| call.tap_with_chuck(),
            centring: false,
            modal_feed: true,
        }),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE85",
            what: "reaming",
            status: BUILT,
            source: OLD,
            parameters: &[
                RTP,
                RFP,
                SDIS,
                DP,
                DPR,
                DWELL,
                feed("FFR", "feed").needed().rule(Rule::Above(61003)),
                feed("RFF", "feed of the return").needed().rule(Rule::Above(61003)),
                PLAIN_GMODE,
                DMODE,
                AMODE,
            ],
        },
        needs: &[],
        work: Work::Hole(Hole {
            feed: |call| Ok(call.own_feed(FFR)),
            method: |call, _, _| Ok(Method::Ream { dwell: call.dwell_at_depth(DTB)?, back: call.own_feed(RFF) }),
            centring: false,
            modal_feed: false,
        }),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE86",
            what: "boring",
            status: BUILT,
            source: OLD,
            parameters: &[
                RTP,
                RFP,
                SDIS,
                DP,
                DPR,
                DWELL,
                DIRECTION,
                length("RPA", "lift-off along the first axis of the plane").default("0"),
                length("RPO", "lift-off along the second axis of the plane").default("0"),
                length("RPAP", "lift-off along the drilling axis").default("0"),
                angle("POSS", "angle of the spindle at which the edge is lifted off").default("0"),
                digits("_GMODE", &LIFT, "units: 0 lifts off, 1 and 2 by `[control] cycle86_lift`"),
                DMODE,
                AMODE,
            ],
        },
        needs: &[],
        work: Work::Hole(Hole {
            feed: |call| call.cycle_feed(),
            method: |call, _, _| call.bore(),
            centring: false,
            modal_feed: true,
        }),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE87",
            what: "boring with stop",
            status: BUILT,
            source: OLD,
            parameters: &[RTP, RFP, SDIS, DP, DPR, DIRECTION],
        },
        needs: &[],
        work: Work::Hole(Hole {
            feed: |call| call.cycle_feed(),
            method: |call, _, _| Ok(Method::BoreWithStop { dwell: 0.0, turn: call.spindle_turn(SDIR)? }),
            centring: false,
            modal_feed: true,
        }),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE88",
            what: "boring with stop and dwell",
            status: BUILT,
            source: OLD,
            parameters: &[RTP, RFP, SDIS, DP, DPR, DWELL, DIRECTION],
        },
        needs: &[],
        work: Work::Hole(Hole {
            feed: |call| call.cycle_feed(),
            method: |call, _, _| {
                Ok(Method::BoreWithStop { dwell: call.dwell_of(DTB)?, turn: call.spindle_turn(SDIR)? })
            },
            centring: false,
            modal_feed: true,
        }),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE89",
            what: "boring, out at feed",
            status: BUILT,
            source: OLD,
            parameters: &[RTP, RFP, SDIS, DP, DPR, DWELL, PLAIN_GMODE, DMODE, AMODE],
        },
        needs: &[],
        work: Work::Hole(Hole {
            feed: |call| call.cycle_feed(),
            method: |call, _, feed| Ok(Method::Ream { dwell: call.dwell_at_depth(DTB)?, back: feed }),
            centring: false,
            modal_feed: true,
        }),
    },
];
