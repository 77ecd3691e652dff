//! Drilling and tapping: 1, 2, 17, 200 to 203, 205 to 207, 240, 241.

use crate::ir::cycle::drilling::Method;
use crate::sema::cycle::row::{Kind, Name, Parameter, Rule, Signature, Status};

use super::{ABOVE_0, AT_SURFACE, CycleKind, DEPTH, Drilling, REMOVE, Requires, Row, SECOND, SET_UP, q};

pub(in super::super) const PLUNGE: Name = Name::Q(202);
pub(in super::super) const LEAST_PLUNGE: Name = Name::Q(205);
pub(in super::super) const FEED: Name = Name::Q(206);
pub(in super::super) const RETRACT_FEED: Name = Name::Q(208);
pub(in super::super) const DWELL_ABOVE: Name = Name::Q(210);
pub(in super::super) const DWELL: Name = Name::Q(211);
pub(in super::super) const DECREMENT: Name = Name::Q(212);
pub(in super::super) const BREAKS: Name = Name::Q(213);
pub(in super::super) const DIRECTION: Name = Name::Q(214);
pub(in super::super) const PITCH: Name = Name::Q(239);
pub(in super::super) const PREPOSITION: Name = Name::Q(253);
pub(in super::super) const BREAK_WAY: Name = Name::Q(256);
pub(in super::super) const BREAK_DEPTH: Name = Name::Q(257);
pub(in super::super) const AHEAD_ABOVE: Name = Name::Q(258);
pub(in super::super) const AHEAD_BELOW: Name = Name::Q(259);
pub(in super::super) const ANGLE: Name = Name::Q(336);
pub(in super::super) const ROUGH_DIAMETER: Name = Name::Q(342);
pub(in super::super) const BY_DIAMETER: Name = Name::Q(343);
pub(in super::super) const DIAMETER: Name = Name::Q(344);
pub(in super::super) const DEEPENED: Name = Name::Q(379);
pub(in super::super) const DEPTH_REFERENCE: Name = Name::Q(395);
pub(in super::super) const FEED_PERCENT: Name = Name::Q(401);
pub(in super::super) const ENTRY_TURN: Name = Name::Q(426);
pub(in super::super) const ENTRY_SPEED: Name = Name::Q(427);
pub(in super::super) const DRILLING_SPEED: Name = Name::Q(428);
pub(in super::super) const COOLANT_ON: Name = Name::Q(429);
pub(in super::super) const COOLANT_OFF: Name = Name::Q(430);
pub(in super::super) const DWELL_DEPTH: Name = Name::Q(435);

pub(super) const Q201: Parameter = q(DEPTH, Kind::Length, "depth below the surface, 0 or less").needed();
const Q202: Parameter = q(PLUNGE, Kind::Length, "plunging depth").needed().rule(ABOVE_0);
const Q205: Parameter = q(LEAST_PLUNGE, Kind::Length, "least plunging depth").needed();
const Q206: Parameter = q(FEED, Kind::Feed, "feed for plunging; FAUTO takes that of the TOOL CALL").needed();
const Q208: Parameter = q(RETRACT_FEED, Kind::Feed, "feed of the retraction, 0 that of Q206; FMAX at rapid").needed();
const Q210: Parameter = q(DWELL_ABOVE, Kind::Dwell, "dwell above the hole").needed();
const Q211: Parameter = q(DWELL, Kind::Dwell, "dwell at the depth").needed();
const Q212: Parameter = q(DECREMENT, Kind::Length, "by which each plunging depth is shorter").needed();
pub(super) const Q239: Parameter = q(PITCH, Kind::Length, "pitch; above 0 right-hand, below 0 left-hand").needed();
const Q379: Parameter =
    q(DEEPENED, Kind::Length, "deepened start below the surface: the hole is open down to it").unsigned().default("0");
const Q395: Parameter = q(DEPTH_REFERENCE, Kind::Number, "depth: 0 of the tip, 1 of the full diameter")
    .rule(Rule::OneOf(0, 1))
    .default("0");

/// What drilling cycles need where they are called.
const DRILLING: &[Requires] = &[Requires::NoCompensation, Requires::Turning, Requires::Speed, Requires::ToolChange];
/// The control itself starts the spindle for rigid tapping.
pub(super) const TAPPING: &[Requires] =
    &[Requires::NoCompensation, Requires::Speed, Requires::ToolChange, Requires::NoScaling];
const TAPPING_TURNING: &[Requires] =
    &[Requires::NoCompensation, Requires::Turning, Requires::Speed, Requires::ToolChange, Requires::NoScaling];
/// The cycle brings its speeds, too.
const STARTING: &[Requires] = &[Requires::NoCompensation, Requires::ToolChange];

/// Feed by Q206.
const BY_Q206: Option<Name> = Some(FEED);

const BY_Q211: Option<Name> = Some(DWELL);

const CUTTING: Drilling =
    Drilling { method: |call, cut| call.drilling(cut), feed: BY_Q206, dwell: BY_Q211, requires: DRILLING };

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
    Row {
        numbers: (number, number),
        nature: CycleKind::Drilling(drilling),
        requires: drilling.requires,
        signature,
        form,
    }
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
            method: |call, cut| call.old_pecking(cut),
            feed: Some(Name::Part(5)),
            dwell: Some(Name::Part(4)),
            requires: DRILLING,
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
            method: |call, cut| Ok(call.tapping(cut, None)),
            feed: Some(Name::Part(4)),
            dwell: Some(Name::Part(3)),
            requires: TAPPING_TURNING,
        },
        &[CLEARANCE_OF_OLD, DEPTH_OF_OLD, part(3, Kind::Dwell, "dwell at the depth"), part(4, Kind::Feed, "feed")],
    ),
    cycle(
        17,
        "CYCL DEF 17",
        "RIGID TAPPING",
        &Drilling { method: |call, cut| call.old_rigid_tapping(cut), feed: None, dwell: None, requires: TAPPING },
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
        &Drilling { method: |call, cut| call.reaming(cut), ..CUTTING },
        &[SET_UP, Q201, Q206, Q211, Q208, AT_SURFACE, SECOND],
    ),
    cycle(
        202,
        "CYCL DEF 202",
        "BORING",
        &Drilling { method: |call, cut| call.boring(cut), ..CUTTING },
        &[
            SET_UP,
            Q201,
            Q206,
            Q211,
            Q208,
            AT_SURFACE,
            SECOND,
            q(DIRECTION, Kind::Number, "way of the lift-off: 0 none, 1 -X, 2 -Y, 3 +X, 4 +Y of the plane")
                .needed()
                .rule(Rule::OneOf(0, 4)),
            q(ANGLE, Kind::Angle, "angle of the spindle at which the edge is lifted off").default("0"),
        ],
    ),
    cycle(
        203,
        "CYCL DEF 203",
        "UNIVERSAL DRILLING",
        &Drilling { method: |call, cut| call.universal(cut), ..CUTTING },
        &[
            SET_UP,
            Q201,
            Q206,
            Q202,
            Q210,
            AT_SURFACE,
            SECOND,
            Q212,
            q(BREAKS, Kind::Count, "number of chip breaks before the tool leaves the hole")
                .needed()
                .rule(Rule::OneOf(0, 99_999)),
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
        &Drilling { method: |call, cut| call.pecking(cut), ..CUTTING },
        &[
            SET_UP,
            Q201,
            Q206,
            Q202,
            AT_SURFACE,
            SECOND,
            Q212,
            Q205,
            q(AHEAD_ABOVE, Kind::Length, "distance above the last depth after the first plunge").needed(),
            q(AHEAD_BELOW, Kind::Length, "distance above the last depth before the last plunge").needed(),
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
        &Drilling { method: |call, cut| Ok(call.tapping(cut, None)), requires: TAPPING_TURNING, ..CUTTING },
        &[SET_UP, Q201, Q206, Q211, AT_SURFACE, SECOND],
    ),
    cycle(
        207,
        "CYCL DEF 207",
        "RIGID TAPPING",
        &Drilling {
            method: |call, cut| Ok(Method::Tap(call.rigid_tapping(cut))),
            feed: None,
            dwell: None,
            requires: TAPPING,
        },
        &[SET_UP, Q201, Q239, AT_SURFACE, SECOND],
    ),
    cycle(
        240,
        "CYCL DEF 240",
        "CENTERING",
        &Drilling { method: |_, cut| Ok(Method::Drill { dwell: cut.dwell }), ..CUTTING },
        &[
            SET_UP,
            q(BY_DIAMETER, Kind::Number, "0 the depth Q201 is given, 1 the diameter Q344")
                .needed()
                .rule(Rule::OneOf(0, 1)),
            Q201,
            Q206,
            Q211,
            AT_SURFACE,
            SECOND,
            q(DIAMETER, Kind::Length, "diameter on the surface, its sign is left out").default("needed with Q343"),
            q(ROUGH_DIAMETER, Kind::Length, "diameter that is drilled already").unsigned().default("0"),
            q(PREPOSITION, Kind::Feed, "feed to where the drilled hole is that wide").default("needed with Q342"),
        ],
    ),
    cycle(
        241,
        "CYCL DEF 241",
        "SINGLE-LIP DEEP-HOLE DRILLING",
        &Drilling { method: |call, cut| call.deep_hole(cut), requires: STARTING, ..CUTTING },
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
            q(ENTRY_TURN, Kind::Number, "spindle on the way in and out: 3 as M3, 4 as M4, 5 it stands")
                .needed()
                .rule(Rule::OneOf(3, 5)),
            q(ENTRY_SPEED, Kind::Speed, "speed on the way in and out").needed(),
            q(DRILLING_SPEED, Kind::Speed, "speed of drilling").needed(),
            q(COOLANT_ON, Kind::Number, "M function before drilling: 7, 8, 9, or 0 for none").default("8"),
            q(COOLANT_OFF, Kind::Number, "M function at the bottom: 7, 8, 9, or 0 for none").default("9"),
            q(DWELL_DEPTH, Kind::Length, "depth at which it dwells; refused where it is not 0").default("0"),
            q(FEED_PERCENT, Kind::Number, "feed after that depth in percent; refused where it is not 100")
                .default("100"),
            q(PLUNGE, Kind::Length, "plunging depth; refused where it is less than the depth")
                .unsigned()
                .default("the depth"),
            q(DECREMENT, Kind::Length, "by which each plunging depth is shorter").without_effect("there is one plunge"),
            q(LEAST_PLUNGE, Kind::Length, "least plunging depth").without_effect("there is one plunge"),
            Q395,
        ],
    ),
];
