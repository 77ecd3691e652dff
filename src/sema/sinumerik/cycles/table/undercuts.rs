//! Undercut cycles: CYCLE94, CYCLE96, CYCLE940.

use crate::sema::cycle::row::{
    ANY_DIGITS, Parameter, Rule, Signature, angle, digits, either, feed, length, number, words,
};

use super::{BUILT, Cycle, Need, Work};

const SPL: Parameter = length("SPL", "corner along Z").needed();
const POSITION: Parameter =
    number("_VARI", "position in the numbers of the cutting edge: 1 to 4").default("the edge of the tool");

const UNDERCUT: &[Need] =
    &[Need::Lathe, Need::TurningPlane, Need::NoNormalOffset, Need::DiameterAxis, Need::ActivePlane];

pub(super) const ROWS: &[Cycle] = &[
    Cycle {
        signature: Signature {
            name: "CYCLE94",
            what: "undercut of DIN 509",
            status: BUILT,
            source: "SINUMERIK 840D cycles 11/2002",
            parameters: &[
                length("SPD", "finished diameter, from 3 mm").needed(),
                SPL,
                either("FORM", "form: \"E\" or \"F\"").needed().or_else(61609, "\"E\" and \"F\" are of DIN 509"),
                POSITION,
            ],
        },
        needs: UNDERCUT,
        work: Work::Plan(|call| call.undercut_by_diameter()),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE96",
            what: "undercut of a thread",
            status: BUILT,
            source: "SINUMERIK 840D cycles 11/2002",
            parameters: &[
                length("DIATH", "nominal diameter of the thread, M3 to M68").needed(),
                SPL,
                either("FORM", "form of DIN 76: \"A\" to \"D\"")
                    .needed()
                    .or_else(61609, "\"A\" to \"D\" are of DIN 76"),
                POSITION,
            ],
        },
        needs: UNDERCUT,
        work: Work::Plan(|call| call.undercut_of_thread()),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE940",
            what: "undercut",
            status: BUILT,
            source: "SINUMERIK NC programming 12/2019, p. 1119; SINUMERIK 840D sl turning 06/2019, p. 416",
            parameters: &[
                length("_SPD", "corner, diameter").needed(),
                length("_SPL", "corner along Z").needed(),
                either("_FORM", "\"E\" and \"F\" of DIN 509, \"A\" to \"D\" of DIN 76, \"T\" free")
                    .needed()
                    .or_else(61609, "\"E\" and \"F\" are of DIN 509, \"A\" to \"D\" of DIN 76, \"T\" is free"),
                number("_LAGE", "0 external +Z, 1 external -Z, 2 internal +Z, 3 internal -Z")
                    .needed()
                    .rule(Rule::OneOf(0, 3))
                    .or_else(61613, "0 is external +Z, 1 external -Z, 2 internal +Z, 3 internal -Z"),
                length("_SDIS", "safety distance").needed().rule(Rule::Above(61019)),
                feed("_FFP", "feed per revolution").needed().rule(Rule::Above(61019)),
                digits("_VARI", &ANY_DIGITS, "A to D, T: units 1 roughs, 2 finishes, 3 does both"),
                length("_EPD", "E, F: allowance along X; T: depth; read by `_AMODE`"),
                length("_EPL", "F: allowance along Z; T: width; read by `_AMODE`"),
                length("_R1", "T: radius at the entry").default("0"),
                length("_R2", "T: radius at the corner").default("0"),
                angle("_STA", "A to D, T: angle of the entry, 30 to 90"),
                length("_VRT", "diameter up to which the face is turned").default("no face"),
                length("_MID", "A to D, T: greatest infeed of roughing, above 0"),
                length("_FAL", "allowance of roughing on all sides, without sign").default("0"),
                length("_FALX", "allowance of roughing along X, on the radius, without sign").default("0"),
                length("_FALZ", "allowance of roughing along Z, without sign").default("0"),
                either("_PITI", "index of the size of DIN 509 or of the pitch of DIN 76"),
                words("_PTAB", "table of the thread").without_effect("name of the table of the thread"),
                words("_PTABA", "size of the thread; refused").default("`_PITI` counts"),
                digits("_DMODE", &ANY_DIGITS, "units: plane, 0 the active one, 2 G18"),
                digits(
                    "_AMODE",
                    &ANY_DIGITS,
                    "units `_EPD`, tens `_EPL`: 0 absolute, 1 incremental; thousands: allowance",
                ),
            ],
        },
        needs: UNDERCUT,
        work: Work::Plan(|call| call.undercut_940()),
    },
];
