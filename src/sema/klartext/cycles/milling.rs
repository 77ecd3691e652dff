//! Parameters that many milling cycles have.

use crate::sema::cycle::row::{Kind, Parameter, Signature, Status};

use super::drilling::{FEED, PLUNGE};
use super::{MillingOf, Nature, Q, REMOVE, Row, q};

pub(in super::super) const MILLING_FEED: Q = Q(207);
pub(in super::super) const OPERATION: Q = Q(215);
pub(in super::super) const FIRST_SIDE: Q = Q(218);
pub(in super::super) const SECOND_SIDE: Q = Q(219);
pub(in super::super) const CORNER: Q = Q(220);
pub(in super::super) const DIAMETER: Q = Q(223);
pub(in super::super) const TURN: Q = Q(224);
pub(in super::super) const FINISHING_INFEED: Q = Q(338);
pub(in super::super) const CLIMB: Q = Q(351);
pub(in super::super) const PLUNGING: Q = Q(366);
pub(in super::super) const POSITION: Q = Q(367);
pub(in super::super) const SIDE_ALLOWANCE: Q = Q(368);
pub(in super::super) const FLOOR_ALLOWANCE: Q = Q(369);
pub(in super::super) const OVERLAP: Q = Q(370);
pub(in super::super) const FINISHING_FEED: Q = Q(385);
pub(in super::super) const FEED_REFERENCE: Q = Q(439);

pub(super) const Q202: Parameter = q(PLUNGE, Kind::Length, "greatest infeed in depth, above 0").needed();
pub(super) const Q206: Parameter = q(FEED, Kind::Feed, "feed for plunging").needed();
pub(super) const Q207: Parameter = q(MILLING_FEED, Kind::Feed, "feed for milling").needed();
pub(super) const Q215: Parameter =
    q(OPERATION, Kind::Number, "0 roughs and finishes, 1 roughs, 2 finishes what Q368 and Q369 leave").needed();
pub(super) const Q338: Parameter =
    q(FINISHING_INFEED, Kind::Length, "infeed in depth of finishing the wall; 0 at once").default("0");
pub(super) const Q351: Parameter = q(CLIMB, Kind::Number, "+1 climb, -1 up-cut milling with M3").needed();
pub(super) const Q366: Parameter =
    q(PLUNGING, Kind::Number, "plunging 0 straight down, 1 on a helix, 2 to and fro; slots to and fro for 1, too")
        .needed();
pub(super) const Q368: Parameter = q(SIDE_ALLOWANCE, Kind::Length, "allowance on the wall").default("0");
pub(super) const Q369: Parameter = q(FLOOR_ALLOWANCE, Kind::Length, "allowance on the floor").default("0");
pub(super) const Q370: Parameter =
    q(OVERLAP, Kind::Number, "width of a cut in radii of the cutter, 0.1 to 1.9999").default("1");
pub(super) const Q385: Parameter = q(FINISHING_FEED, Kind::Feed, "feed for finishing").default("Q207");
pub(super) const Q439: Parameter =
    q(FEED_REFERENCE, Kind::Number, "feed of 0 the centre of the cutter; 1 to 3, of its edge, are refused")
        .default("0");

const MANUAL: &str = "HEIDENHAIN iTNC 530 cycle programming; TNC 640 cycles";

pub(super) const fn cycle(
    number: u32,
    name: &'static str,
    what: &'static str,
    making: MillingOf,
    parameters: &'static [Parameter],
) -> Row {
    let signature = Signature { name, what, status: Status::Built, source: MANUAL, parameters };
    Row { numbers: (number, number), nature: Nature::Milling(making), signature, form: REMOVE }
}
