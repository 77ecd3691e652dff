//! Hole patterns: HOLES1, HOLES2, CYCLE801, CYCLE802.

use crate::sema::cycle::row::{ANY_DIGITS, Parameter, Signature, angle, count, digits, either, length, number};

use super::{BUILT, Cycle, Need, Work};

const STANDARD: &str = "standard cycles V06.02.09; SINUMERIK 840D cycles 11/2002";
const STORED: &str = "stored calls of SINUMERIK 840D sl";

const VARI: Parameter = digits("_VARI", &ANY_DIGITS, "variant; 0");
const UMODE: Parameter = number("_UMODE", "").without_effect("reserved");
const HIDE: Parameter = either("_HIDE", "hidden positions; refused").default("none");
const NSP: Parameter = number("_NSP", "first position; refused where it is not 0").default("0");
const DMODE: Parameter = digits("_DMODE", &ANY_DIGITS, "units: plane, 0 the active one, 1 G17, 2 G18, 3 G19");

/// What helps where a distance or a number has a sign.
const SIGN: &str =
    "some versions of the cycle take its magnitude: write it without the sign, and turn the row by its angle";

/// A pattern runs what MCALL gave; its lengths lie in the active plane.
const PATTERN: &[Need] = &[Need::ModalCall, Need::ActivePlane, Need::PlainLengths];

pub(super) const ROWS: &[Cycle] = &[
    Cycle {
        signature: Signature {
            name: "HOLES1",
            what: "row of holes",
            status: BUILT,
            source: STANDARD,
            parameters: &[
                length("SPCA", "reference point along the first axis").default("0"),
                length("SPCO", "reference point along the second axis").default("0"),
                angle("STA1", "angle of the row").default("0"),
                length("FDIS", "distance of the first hole from the reference point")
                    .unsigned()
                    .or_else(61019, SIGN)
                    .default("0"),
                length("DBH", "distance of the holes").unsigned().or_else(61019, SIGN).default("0"),
                count("NUM", "number of holes").unsigned(),
                VARI,
                UMODE,
                HIDE,
                NSP,
                DMODE,
            ],
        },
        needs: PATTERN,
        work: Work::Plan(|call| call.row()),
    },
    Cycle {
        signature: Signature {
            name: "HOLES2",
            what: "circle of holes",
            status: BUILT,
            source: STANDARD,
            parameters: &[
                length("CPA", "centre along the first axis").default("0"),
                length("CPO", "centre along the second axis").default("0"),
                length("RAD", "radius of the circle").unsigned().or_else(61019, SIGN),
                angle("STA1", "angle of the first hole").default("0"),
                angle("INDA", "angle from hole to hole").default("360 degrees by NUM"),
                count("NUM", "number of holes").unsigned(),
                VARI,
                UMODE,
                HIDE,
                NSP,
                DMODE,
            ],
        },
        needs: PATTERN,
        work: Work::Plan(|call| call.circle_of_holes()),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE801",
            what: "grid or frame of holes",
            status: BUILT,
            source: STANDARD,
            parameters: &[
                length("_SPCA", "reference point along the first axis").default("0"),
                length("_SPCO", "reference point along the second axis").default("0"),
                angle("_STA", "angle by which the grid is turned").default("0"),
                length("_DIS1", "distance of the columns").unsigned().or_else(61019, SIGN).default("0"),
                length("_DIS2", "distance of the rows").unsigned().or_else(61019, SIGN).default("0"),
                count("_NUM1", "number of columns").unsigned(),
                count("_NUM2", "number of rows").unsigned(),
                digits("_VARI", &ANY_DIGITS, "0 grid, 1 frame"),
                UMODE,
                angle("_ANG1", "shear of the rows; refused where it is not 0").default("0"),
                angle("_ANG2", "shear of the columns; refused where it is not 0").default("0"),
                HIDE,
                NSP,
                DMODE,
            ],
        },
        needs: PATTERN,
        work: Work::Plan(|call| call.grid()),
    },
    Cycle {
        signature: Signature {
            name: "CYCLE802",
            what: "up to nine positions",
            status: BUILT,
            source: STORED,
            parameters: &[
                digits("_XA", &ANY_DIGITS, "a digit for each position: 1 absolute"),
                digits("_YA", &ANY_DIGITS, "a digit for each position: 1 absolute"),
                position("_X0"),
                position("_Y0"),
                position("_X1"),
                position("_Y1"),
                position("_X2"),
                position("_Y2"),
                position("_X3"),
                position("_Y3"),
                position("_X4"),
                position("_Y4"),
                position("_X5"),
                position("_Y5"),
                position("_X6"),
                position("_Y6"),
                position("_X7"),
                position("_Y7"),
                position("_X8"),
                position("_Y8"),
                digits("_VARI", &ANY_DIGITS, "variant; 0"),
                UMODE,
                DMODE,
                further("S_ABA"),
                further("S_AB0"),
                further("S_AB1"),
                further("S_AB2"),
                further("S_AB3"),
                further("S_AB4"),
                further("S_AB5"),
                further("S_AB6"),
                further("S_AB7"),
                further("S_AB8"),
            ],
        },
        needs: PATTERN,
        work: Work::Plan(|call| call.free_positions()),
    },
];

const fn position(name: &'static str) -> Parameter {
    length(name, "coordinate of a position").default("no such position")
}

const fn further(name: &'static str) -> Parameter {
    number(name, "refused where it is not 0").default("0")
}
