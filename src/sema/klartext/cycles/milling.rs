//! Parameters that many milling cycles have.

use crate::sema::cycle::row::{Kind, Name, Parameter, Rule, Signature, Status};

use super::drilling::{FEED, PLUNGE};
use super::{ABOVE_0, CycleKind, Plan, REMOVE, Requires, Row, q};

pub(in super::super) const MILLING_FEED: Name = Name::Q(207);
pub(in super::super) const OPERATION: Name = Name::Q(215);
pub(in super::super) const FIRST_SIDE: Name = Name::Q(218);
pub(in super::super) const SECOND_SIDE: Name = Name::Q(219);
pub(in super::super) const CORNER: Name = Name::Q(220);
pub(in super::super) const DIAMETER: Name = Name::Q(223);
pub(in super::super) const TURN: Name = Name::Q(224);
pub(in super::super) const FINISHING_INFEED: Name = Name::Q(338);
pub(in super::super) const CLIMB: Name = Name::Q(351);
pub(in super::super) const PLUNGING: Name = Name::Q(366);
pub(in super::super) const POSITION: Name = Name::Q(367);
pub(in super::super) const SIDE_ALLOWANCE: Name = Name::Q(368);
pub(in super::super) const FLOOR_ALLOWANCE: Name = Name::Q(369);
pub(in super::super) const OVERLAP: Name = Name::Q(370);
pub(in super::super) const FINISHING_FEED: Name = Name::Q(385);
pub(in super::super) const FEED_REFERENCE: Name = Name::Q(439);

pub(super) const Q202: Parameter = q(PLUNGE, Kind::Length, "greatest infeed in depth").needed().rule(ABOVE_0);
pub(super) const Q206: Parameter = q(FEED, Kind::Feed, "feed for plunging").needed();
pub(super) const Q207: Parameter = q(MILLING_FEED, Kind::Feed, "feed for milling").needed();
pub(super) const Q215: Parameter =
    q(OPERATION, Kind::Number, "0 roughs and finishes, 1 roughs, 2 finishes what Q368 and Q369 leave")
        .needed()
        .rule(Rule::OneOf(0, 2));
pub(super) const Q338: Parameter =
    q(FINISHING_INFEED, Kind::Length, "infeed in depth of finishing the wall; 0 at once").unsigned().default("0");
pub(super) const Q351: Parameter = q(CLIMB, Kind::Number, "+1 climb, -1 up-cut milling with M3").needed();
pub(super) const Q366: Parameter =
    q(PLUNGING, Kind::Number, "plunging 0 straight down, 1 on a helix, 2 to and fro; slots to and fro for 1, too")
        .needed()
        .rule(Rule::OneOf(0, 2));
pub(super) const Q368: Parameter = q(SIDE_ALLOWANCE, Kind::Length, "allowance on the wall").unsigned().default("0");
pub(super) const Q369: Parameter = q(FLOOR_ALLOWANCE, Kind::Length, "allowance on the floor").unsigned().default("0");
pub(super) const Q370: Parameter =
    q(OVERLAP, Kind::Number, "width of a cut in radii of the cutter, 0.1 to 1.9999").default("1");
pub(super) const Q385: Parameter = q(FINISHING_FEED, Kind::Feed, "feed for finishing").default("Q207");
pub(super) const Q439: Parameter =
    q(FEED_REFERENCE, Kind::Number, "feed of 0 the centre of the cutter; 1 to 3, of its edge, are refused")
        .rule(Rule::OneOf(0, 3))
        .default("0");

/// What milling cycles need where they are called.
pub(super) const MILLING: &[Requires] =
    &[Requires::NoCompensation, Requires::Turning, Requires::Speed, Requires::ToolChange, Requires::CutterUnscaled];

const MANUAL: &str = "HEIDENHAIN iTNC 530 cycle programming; TNC 640 cycles";

pub(super) const fn cycle(
    number: u32,
    name: &'static str,
    what: &'static str,
    plan: Plan,
    parameters: &'static [Parameter],
) -> Row {
    let signature = Signature { name, what, status: Status::Built, source: MANUAL, parameters };
    Row { numbers: (number, number), nature: CycleKind::Milling(plan), requires: MILLING, signature, form: REMOVE }
}
