//! The old pockets and slots, whose values stand in parts: 3 to 5.

use crate::sema::cycle::row::{Kind, Name, Parameter, Signature, Status};

use super::{MillingOf, Nature, Row};

/// Parts that all of them have, and where the feed for plunging stands.
pub(in super::super) const PLUNGING: u32 = 3;

const MANUAL: &str = "HEIDENHAIN TNC 426 DIN/ISO manual, p. 155; TNC 407 manual";

const fn part(part: u32, what: &'static str) -> Parameter {
    Parameter::new(Name::Part(part), Kind::Length, what).needed()
}

const fn word(part: u32, word: &'static str, kind: Kind, what: &'static str) -> Parameter {
    Parameter::new(Name::In(part, word), kind, what).needed()
}

const SET_UP: Parameter = part(1, "set-up clearance, its sign is left out; the tool stands there");
const DEPTH: Parameter = part(2, "depth below the surface, below 0");
const INFEED: Parameter = part(3, "greatest infeed in depth, its sign is left out");
const PLUNGE: Parameter = word(3, "F", Kind::Feed, "feed for plunging");
const TURN: &str = "sense of the way: DR+ counter-clockwise, climb milling with M3, DR- clockwise";

const fn cycle(
    number: u32,
    name: &'static str,
    what: &'static str,
    form: &'static str,
    making: MillingOf,
    parameters: &'static [Parameter],
) -> Row {
    let signature = Signature { name, what, status: Status::Built, source: MANUAL, parameters };
    Row { numbers: (number, number), nature: Nature::Milling(making), signature, form }
}

pub(super) const ROWS: &[Row] = &[
    cycle(
        3,
        "CYCL DEF 3",
        "SLOT MILLING",
        "write `3.1 SET UP 2`, `3.2 DEPTH -15`, `3.3 PECKG 4 F80`, `3.4 X80`, `3.5 Y10`, `3.6 F100`",
        |run, cycle, _| run.old_slot(cycle),
        &[
            SET_UP,
            DEPTH,
            INFEED,
            PLUNGE,
            word(4, "X", Kind::Length, "axis and length of the slot; its sign says to which side"),
            word(5, "Y", Kind::Length, "the other axis, and the width; a tool of another size is refused"),
            word(6, "F", Kind::Feed, "feed for milling"),
        ],
    ),
    cycle(
        4,
        "CYCL DEF 4",
        "POCKET MILLING",
        "write `4.1 SET UP 2`, `4.2 DEPTH -15`, `4.3 PECKG 4 F80`, `4.4 X80`, `4.5 Y40`, `4.6 F100 DR+ RADIUS 10`",
        |run, cycle, _| run.old_rectangle(cycle),
        &[
            SET_UP,
            DEPTH,
            INFEED,
            PLUNGE,
            word(4, "X", Kind::Length, "an axis of the plane, and the length of the pocket along it"),
            word(5, "Y", Kind::Length, "the other axis, and the length along it"),
            word(6, "F", Kind::Feed, "feed for milling"),
            word(6, "DR", Kind::Number, TURN),
            Parameter::new(Name::In(6, "RADIUS"), Kind::Length, "radius of the corners").default("the cutter's"),
        ],
    ),
    cycle(
        5,
        "CYCL DEF 5",
        "CIRCULAR POCKET",
        "write `5.1 SET UP 2`, `5.2 DEPTH -15`, `5.3 PECKG 4 F80`, `5.4 RADIUS 35`, `5.5 F100 DR+`",
        |run, cycle, _| run.old_circle(cycle),
        &[
            SET_UP,
            DEPTH,
            INFEED,
            PLUNGE,
            part(4, "radius of the pocket"),
            word(5, "F", Kind::Feed, "feed for milling"),
            word(5, "DR", Kind::Number, TURN),
        ],
    ),
];
