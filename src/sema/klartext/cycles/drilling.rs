//! Drilling and tapping: 1, 2, 17, 200 to 203, 205 to 207, 240, 241.

use crate::sema::cycle::row::{Kind, Name, Parameter, Signature, Status};

use super::{AT_SURFACE, DEPTH, Drilling, Nature, Q, REMOVE, Row, SECOND, SET_UP, q};

pub(in super::super) const PLUNGE: Q = Q(202);
pub(in super::super) const LEAST_PLUNGE: Q = Q(205);
pub(in super::super) const FEED: Q = Q(206);
pub(in super::super) const RETRACT_FEED: Q = Q(208);
pub(in super::super) const DWELL_ABOVE: Q = Q(210);
pub(in super::super) const DWELL: Q = Q(211);
pub(in super::super) const DECREMENT: Q = Q(212);
pub(in super::super) const BREAKS: Q = Q(213);
pub(in super::super) const DIRECTION: Q = Q(214);
pub(in super::super) const PITCH: Q = Q(239);
pub(in super::super) const PREPOSITION: Q = Q(253);
pub(in super::super) const BREAK_WAY: Q = Q(256);
pub(in super::super) const BREAK_DEPTH: Q = Q(257);
pub(in super::super) const AHEAD_ABOVE: Q = Q(258);
pub(in super::super) const AHEAD_BELOW: Q = Q(259);
pub(in super::super) const ANGLE: Q = Q(336);
pub(in super::super) const ROUGH_DIAMETER: Q = Q(342);
pub(in super::super) const BY_DIAMETER: Q = Q(343);
pub(in super::super) const DIAMETER: Q = Q(344);
pub(in super::super) const DEEPENED: Q = Q(379);
pub(in super::super) const DEPTH_REFERENCE: Q = Q(395);
pub(in super::super) const FEED_PERCENT: Q = Q(401);
pub(in super::super) const ENTRY_TURN: Q = Q(426);
pub(in super::super) const ENTRY_SPEED: Q = Q(427);
pub(in super::super) const DRILLING_SPEED: Q = Q(428);
pub(in super::super) const COOLANT_ON: Q = Q(429);
pub(in super::super) const COOLANT_OFF: Q = Q(430);
pub(in super::super) const DWELL_DEPTH: Q = Q(435);

pub(super) const Q201: Parameter = q(DEPTH, Kind::Length, "depth below the surface, 0 or less").needed();
const Q202: Parameter = q(PLUNGE, Kind::Length, "plunging depth, above 0").needed();
const Q205: Parameter = q(LEAST_PLUNGE, Kind::Length, "least plunging depth").needed();
const Q206: Parameter = q(FEED, Kind::Feed, "feed for plunging; FAUTO takes that of the TOOL CALL").needed();
const Q208: Parameter = q(RETRACT_FEED, Kind::Feed, "feed of the retraction, 0 that of Q206; FMAX at rapid").needed();
const Q210: Parameter = q(DWELL_ABOVE, Kind::Dwell, "dwell above the hole").needed();
const Q211: Parameter = q(DWELL, Kind::Dwell, "dwell at the depth").needed();
const Q212: Parameter = q(DECREMENT, Kind::Length, "by which each plunging depth is shorter").needed();
pub(super) const Q239: Parameter = q(PITCH, Kind::Length, "pitch; above 0 right-hand, below 0 left-hand").needed();
const Q379: Parameter =
    q(DEEPENED, Kind::Length, "deepened start below the surface: the hole is open down to it").default("0");
const Q395: Parameter = q(DEPTH_REFERENCE, Kind::Number, "depth: 0 of the tip, 1 of the full diameter").default("0");

/// Feed by Q206.
const BY_Q206: Option<Name> = Some(Name::Q(FEED.0));

const BY_Q211: Option<Name> = Some(Name::Q(DWELL.0));

const CUTTING: Drilling = Drilling {
    method: |run, cycle, cut| run.drilling(cycle, cut),
    feed: BY_Q206,
    dwell: BY_Q211,
    taps: false,
    own_spindle: false,
};

const fn cycle(
    number: u32,
    name: &'static str,
    what: &'static str,
    drilling: &'static Drilling,
    parameters: &'static [Parameter],
) -> Row {
    let source = if number < 20 { OLD } else { MANUAL };
    let signature = Signature { name, what, status: Status::Built, source, parameters };
    let form = match number {
        1 | 2 => "write a name and one value: `CYCL DEF 1.2 DEPTH -15`, the feed as `CYCL DEF 1.5 F80`",
        17 => "write a name and one value: `CYCL DEF 17.3 PITCH +1.5`",
        _ => REMOVE,
    };
    Row { numbers: (number, number), nature: Nature::Drilling(drilling), signature, form }
}

const MANUAL: &str = "HEIDENHAIN iTNC 530 cycle programming; TNC 640 cycles";
const OLD: &str = "HEIDENHAIN TNC 407 DIN/ISO manual, 8-4; TNC 370 manual, 8-6";

const fn part(part: u32, kind: Kind, what: &'static str) -> Parameter {
    Parameter::new(Name::Part(part), kind, what).needed()
}

const CLEARANCE_OF_OLD: Parameter =
    part(1, Kind::Length, "set-up clearance, its sign is left out; the tool stands there");
const DEPTH_OF_OLD: Parameter = part(2, Kind::Length, "depth below the surface, below 0");

pub(super) const ROWS: &[Row] = &[
    cycle(
        1,
        "CYCL DEF 1",
        "PECKING",
        &Drilling {
            method: |run, cycle, cut| run.old_pecking(cycle, cut),
            feed: Some(Name::Part(5)),
            dwell: Some(Name::Part(4)),
            taps: false,
            own_spindle: false,
        },
        &[
            CLEARANCE_OF_OLD,
            DEPTH_OF_OLD,
            part(3, Kind::Length, "pecking depth, its sign is left out"),
            part(4, Kind::Dwell, "dwell at the depth"),
            part(5, Kind::Feed, "feed"),
        ],
    ),
    cycle(
        2,
        "CYCL DEF 2",
        "TAPPING",
        &Drilling {
            method: |run, _, cut| run.tapping(cut, None),
            feed: Some(Name::Part(4)),
            dwell: Some(Name::Part(3)),
            taps: true,
            own_spindle: false,
        },
        &[CLEARANCE_OF_OLD, DEPTH_OF_OLD, part(3, Kind::Dwell, "dwell at the depth"), part(4, Kind::Feed, "feed")],
    ),
    cycle(
        17,
        "CYCL DEF 17",
        "RIGID TAPPING",
        &Drilling {
            method: |run, cycle, cut| run.old_rigid_tapping(cycle, cut),
            feed: None,
            dwell: None,
            taps: true,
            own_spindle: false,
        },
        &[CLEARANCE_OF_OLD, DEPTH_OF_OLD, part(3, Kind::Length, "pitch; above 0 right-hand, below 0 left-hand")],
    ),
    cycle(
        200,
        "CYCL DEF 200",
        "DRILLING",
        &CUTTING,
        &[
            SET_UP,
            Q201,
            Q206,
            Q202,
            Q210,
            AT_SURFACE,
            SECOND,
            q(DWELL, Kind::Dwell, "dwell at the depth").default("0"),
            Q395,
        ],
    ),
    cycle(
        201,
        "CYCL DEF 201",
        "REAMING",
        &Drilling { method: |run, cycle, cut| run.reaming(cycle, cut), ..CUTTING },
        &[SET_UP, Q201, Q206, Q211, Q208, AT_SURFACE, SECOND],
    ),
    cycle(
        202,
        "CYCL DEF 202",
        "BORING",
        &Drilling { method: |run, cycle, cut| run.boring(cycle, cut), ..CUTTING },
        &[
            SET_UP,
            Q201,
            Q206,
            Q211,
            Q208,
            AT_SURFACE,
            SECOND,
            q(DIRECTION, Kind::Number, "way of the lift-off: 0 none, 1 -X, 2 -Y, 3 +X, 4 +Y of the plane").needed(),
            q(ANGLE, Kind::Angle, "angle of the spindle at which the edge is lifted off").default("0"),
        ],
    ),
    cycle(
        203,
        "CYCL DEF 203",
        "UNIVERSAL DRILLING",
        &Drilling { method: |run, cycle, cut| run.universal(cycle, cut), ..CUTTING },
        &[
            SET_UP,
            Q201,
            Q206,
            Q202,
            Q210,
            AT_SURFACE,
            SECOND,
            Q212,
            q(BREAKS, Kind::Count, "number of chip breaks before the tool leaves the hole").needed(),
            Q205,
            Q211,
            Q208,
            q(BREAK_WAY, Kind::Length, "way back to break the chip").default("0.2 mm"),
            Q395,
        ],
    ),
    cycle(
        205,
        "CYCL DEF 205",
        "UNIVERSAL PECKING",
        &Drilling { method: |run, cycle, cut| run.pecking(cycle, cut), ..CUTTING },
        &[
            SET_UP,
            Q201,
            Q206,
            Q202,
            AT_SURFACE,
            SECOND,
            Q212,
            Q205,
            q(AHEAD_ABOVE, Kind::Length, "distance in front of the last depth after the first plunge").needed(),
            q(AHEAD_BELOW, Kind::Length, "distance in front of the last depth before the last plunge").needed(),
            q(BREAK_DEPTH, Kind::Length, "depth after which the chip is broken; 0 never").needed(),
            q(BREAK_WAY, Kind::Length, "way back to break the chip").needed(),
            Q211,
            Q379,
            q(PREPOSITION, Kind::Feed, "feed to a deepened start").default("needed with Q379"),
            q(RETRACT_FEED, Kind::Feed, "feed of the retraction, 0 that of Q206").default("rapid"),
            Q395,
        ],
    ),
    cycle(
        206,
        "CYCL DEF 206",
        "TAPPING",
        &Drilling { method: |run, _, cut| run.tapping(cut, None), taps: true, ..CUTTING },
        &[SET_UP, Q201, Q206, Q211, AT_SURFACE, SECOND],
    ),
    cycle(
        207,
        "CYCL DEF 207",
        "RIGID TAPPING",
        &Drilling {
            method: |run, cycle, cut| run.rigid_tapping(cycle, cut),
            feed: None,
            dwell: None,
            taps: true,
            own_spindle: false,
        },
        &[SET_UP, Q201, Q239, AT_SURFACE, SECOND],
    ),
    cycle(
        240,
        "CYCL DEF 240",
        "CENTERING",
        &Drilling { method: |run, cycle, cut| run.centering(cycle, cut), ..CUTTING },
        &[
            SET_UP,
            q(BY_DIAMETER, Kind::Number, "0 the depth Q201 is given, 1 the diameter Q344").needed(),
            Q201,
            Q206,
            Q211,
            AT_SURFACE,
            SECOND,
            q(DIAMETER, Kind::Length, "diameter on the surface, its sign is left out").default("needed with Q343"),
            q(ROUGH_DIAMETER, Kind::Length, "diameter that is drilled already").default("0"),
            q(PREPOSITION, Kind::Feed, "feed to where the drilled hole is that wide").default("needed with Q342"),
        ],
    ),
    cycle(
        241,
        "CYCL DEF 241",
        "SINGLE-LIP DEEP-HOLE DRILLING",
        &Drilling { method: |run, cycle, cut| run.deep_hole(cycle, cut), own_spindle: true, ..CUTTING },
        &[
            SET_UP,
            Q201,
            Q206,
            Q211,
            AT_SURFACE,
            SECOND,
            Q379,
            q(PREPOSITION, Kind::Feed, "feed to a deepened start").default("needed with Q379"),
            Q208,
            q(ENTRY_TURN, Kind::Number, "spindle on the way in and out: 3 as M3, 4 as M4, 5 it stands").needed(),
            q(ENTRY_SPEED, Kind::Speed, "speed on the way in and out").needed(),
            q(DRILLING_SPEED, Kind::Speed, "speed of drilling").needed(),
            q(COOLANT_ON, Kind::Number, "M function before drilling: 7, 8, 9, or 0 for none").default("8"),
            q(COOLANT_OFF, Kind::Number, "M function at the bottom: 7, 8, 9, or 0 for none").default("9"),
            q(DWELL_DEPTH, Kind::Length, "depth at which it dwells; refused where it is not 0").default("0"),
            q(FEED_PERCENT, Kind::Number, "feed behind that depth in percent; refused where it is not 100")
                .default("100"),
            q(PLUNGE, Kind::Length, "plunging depth; refused where it is less than the depth").default("the depth"),
            q(DECREMENT, Kind::Length, "by which each plunging depth is shorter").without_effect("there is one plunge"),
            q(LEAST_PLUNGE, Kind::Length, "least plunging depth").without_effect("there is one plunge"),
            Q395,
        ],
    ),
];
