//! Cycles along contours of subprograms: 14, 20 to 25 and 270.

use crate::sema::cycle::row::{Kind, Name, Parameter, Signature, Status};

use super::{CycleKind, Plan, REMOVE, Requires, Row, Setting, milling, q};

pub(in super::super) const DEPTH: Name = Name::Q(1);
pub(in super::super) const OVERLAP: Name = Name::Q(2);
pub(in super::super) const SIDE: Name = Name::Q(3);
pub(in super::super) const FLOOR: Name = Name::Q(4);
pub(in super::super) const SURFACE: Name = Name::Q(5);
pub(in super::super) const SET_UP: Name = Name::Q(6);
pub(in super::super) const HEIGHT: Name = Name::Q(7);
pub(in super::super) const CORNERS: Name = Name::Q(8);
pub(in super::super) const DIRECTION: Name = Name::Q(9);
pub(in super::super) const INFEED: Name = Name::Q(10);
pub(in super::super) const PLUNGING_FEED: Name = Name::Q(11);
pub(in super::super) const MILLING_FEED: Name = Name::Q(12);
pub(in super::super) const ROUGHING_TOOL: Name = Name::Q(13);
pub(in super::super) const LEFT: Name = Name::Q(14);
pub(in super::super) const KIND: Name = Name::Q(15);
pub(in super::super) const COARSE_TOOL: Name = Name::Q(18);
pub(in super::super) const RECIPROCATING_FEED: Name = Name::Q(19);
pub(in super::super) const RETRACT_FEED: Name = Name::Q(208);
pub(in super::super) const WAY: Name = Name::Q(390);
pub(in super::super) const COMPENSATION: Name = Name::Q(391);
pub(in super::super) const WAY_RADIUS: Name = Name::Q(392);
pub(in super::super) const WAY_ANGLE: Name = Name::Q(393);
pub(in super::super) const WAY_LENGTH: Name = Name::Q(394);
pub(in super::super) const FEED_FACTOR: Name = Name::Q(401);

/// Cycle 22.
pub(in super::super) const ROUGH_OUT: u32 = 22;

const MANUAL: &str = "HEIDENHAIN iTNC 530 cycle programming; TNC 640 cycles";

const Q1: Parameter = q(DEPTH, Kind::Length, "depth below the surface, with a minus sign").needed();
const Q10: Parameter = q(INFEED, Kind::Length, "greatest infeed in depth; its sign does not count").needed();
const Q11: Parameter = q(PLUNGING_FEED, Kind::Feed, "feed for plunging").needed();
const Q12: Parameter = q(MILLING_FEED, Kind::Feed, "feed for milling").needed();
const Q208: Parameter =
    q(RETRACT_FEED, Kind::Feed, "feed out of the pocket: 99999 and FMAX are rapid traverse, others are refused")
        .default("99999");

const fn setting(
    number: u32,
    setting: Setting,
    name: &'static str,
    what: &'static str,
    parameters: &'static [Parameter],
) -> Row {
    let signature = Signature { name, what, status: Status::Built, source: MANUAL, parameters };
    let form = if number == 14 { "write the labels: `CYCL DEF 14.1 CONTOUR LABEL 1`" } else { REMOVE };
    Row { numbers: (number, number), nature: CycleKind::Setting(setting), requires: &[], signature, form }
}

/// What cycles along contours need where they are called.
const TRAIN: &[Requires] = &[
    Requires::NoCompensation,
    Requires::Turning,
    Requires::Speed,
    Requires::ToolChange,
    Requires::CutterUnscaled,
    Requires::Contours,
];
const POCKET: &[Requires] = &[
    Requires::NoCompensation,
    Requires::Turning,
    Requires::Speed,
    Requires::ToolChange,
    Requires::CutterUnscaled,
    Requires::Contours,
    Requires::PocketData,
];

const fn along(
    requires: &'static [Requires],
    number: u32,
    name: &'static str,
    what: &'static str,
    plan: Plan,
    parameters: &'static [Parameter],
) -> Row {
    Row { requires, ..milling::cycle(number, name, what, plan, parameters) }
}

pub(super) const ROWS: &[Row] = &[
    setting(
        14,
        Setting::Contours,
        "CYCL DEF 14",
        "CONTOUR GEOMETRY",
        &[Parameter::new(Name::Part(1), Kind::Either, "labels of the contours; one of them is milled").needed()],
    ),
    setting(
        20,
        Setting::Pocket,
        "CYCL DEF 20",
        "CONTOUR DATA",
        &[
            Q1,
            q(OVERLAP, Kind::Number, "width of a cut in radii of the cutter, 0.1 to 1.9999").needed(),
            q(SIDE, Kind::Length, "allowance on the wall").needed(),
            q(FLOOR, Kind::Length, "allowance on the floor").needed(),
            q(SURFACE, Kind::Length, "coordinate of the surface").needed(),
            q(SET_UP, Kind::Length, "set-up clearance above the surface, 0 or more").needed(),
            q(HEIGHT, Kind::Length, "coordinate of the clearance height, where the tool goes in the end").needed(),
            q(CORNERS, Kind::Length, "radius of the path of the centre in inside corners").default("0"),
            q(DIRECTION, Kind::Number, "+1 climb, -1 up-cut milling with M3").needed(),
        ],
    ),
    along(
        POCKET,
        21,
        "CYCL DEF 21",
        "PILOT DRILLING",
        |call| call.pilot_drilling(),
        &[Q10, Q11, q(ROUGHING_TOOL, Kind::Number, "number of the tool that roughs the pocket").needed()],
    ),
    along(
        POCKET,
        ROUGH_OUT,
        "CYCL DEF 22",
        "ROUGH-OUT",
        |call| call.rough_out(),
        &[
            Q10,
            Q11,
            Q12,
            q(
                COARSE_TOOL,
                Kind::Number,
                "number of the tool that roughed before, with a cycle 22 in this program; 0 is none",
            )
            .default("0"),
            q(
                RECIPROCATING_FEED,
                Kind::Feed,
                "feed to and fro into the material at the angle ANGLE of the tool; 0 is straight down",
            )
            .default("0"),
            Q208,
            q(FEED_FACTOR, Kind::Number, "feed at full engagement in %: 100; others are refused").default("100"),
            q(Name::Q(404), Kind::Number, "how a finer tool goes on")
                .without_effect("the path after a coarse tool is partc's own"),
        ],
    ),
    along(POCKET, 23, "CYCL DEF 23", "FLOOR FINISHING", |call| call.floor_finishing(), &[Q11, Q12, Q208]),
    along(
        POCKET,
        24,
        "CYCL DEF 24",
        "SIDE FINISHING",
        |call| call.side_finishing(),
        &[
            q(DIRECTION, Kind::Number, "+1 climb, -1 up-cut milling with M3").needed(),
            Q10,
            Q11,
            Q12,
            q(LEFT, Kind::Length, "allowance that is left on the wall").default("0"),
        ],
    ),
    along(
        TRAIN,
        25,
        "CYCL DEF 25",
        "CONTOUR TRAIN",
        |call| call.contour_train(),
        &[
            Q1,
            q(SIDE, Kind::Length, "allowance on the contour").needed(),
            q(SURFACE, Kind::Length, "coordinate of the surface").needed(),
            q(HEIGHT, Kind::Length, "coordinate of the clearance height").needed(),
            Q10,
            Q11,
            Q12,
            q(KIND, Kind::Number, "+1 climb, -1 up-cut milling with M3, 0 both in turns").needed(),
            q(COARSE_TOOL, Kind::Number, "tool that milled before: 0 is none, others are refused").default("0"),
            q(Name::Q(446), Kind::Length, "material that may stay")
                .without_effect("it counts with a coarse tool Q18 only"),
            q(Name::Q(447), Kind::Length, "longest way from cut to cut")
                .without_effect("it counts with a coarse tool Q18 only"),
            q(Name::Q(448), Kind::Length, "by which the path is prolonged")
                .without_effect("it counts with a coarse tool Q18 only"),
        ],
    ),
    setting(
        270,
        Setting::Train,
        "CYCL DEF 270",
        "CONTOUR TRAIN DATA",
        &[
            q(
                WAY,
                Kind::Number,
                "way to the contour and from it: 1 a tangential arc, 2 a tangential line, 3 a line at a right angle",
            )
            .needed(),
            q(COMPENSATION, Kind::Number, "side of the tool: 0 on the contour, 1 left, 2 right of it").needed(),
            q(WAY_RADIUS, Kind::Length, "radius of the arc, on the path of the centre; for Q390 = 1").default("0"),
            q(WAY_ANGLE, Kind::Angle, "angle of the arc; for Q390 = 1").default("0"),
            q(WAY_LENGTH, Kind::Length, "length of the line, on the path of the centre; for Q390 = 2 and 3")
                .default("0"),
        ],
    ),
];
