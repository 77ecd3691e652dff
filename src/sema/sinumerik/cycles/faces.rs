//! CYCLE71 and CYCLE61: face milling.
//!
//! Source: M 7.1 and 7.2 (docs/sources.md).

use crate::diag::codes;
use crate::geo::Deg;
use crate::ir::cycle::facing::{FacingFault, Kind, Links, Overrun};
use crate::ir::cycle::milling::{Mill, Place};
use crate::ir::cycle::{Cycle, Facing, Family};

use super::call::{Act, Acts, CycleCall};
use super::milling::CLASSIC;
use super::names::{AMODE, FDP, FDP1, LENG, LIM, MIDA, PA, PO, STA, VARI, WID};
use crate::sema::cycle::call::Made;
use crate::sema::cycle::row::Name;

impl CycleCall<'_> {
    /// CYCLE71
    pub(super) fn face(&self) -> Made<Acts> {
        let mill = self.mill(&CLASSIC)?;
        let given = self.given;
        let turn = given.or_zero(STA);
        if !(0.0..180.0).contains(&turn) {
            return self.refuse_argument(STA, codes::P2090::rotation_sta_is_0_to_below_180(&given.argument(STA)));
        }
        let size = [given.length(LENG), given.length(WID)];
        let overrun = Overrun { ends: self.given.magnitude(FDP), side: self.given.magnitude(FDP1) };
        let corner = Place { at: self.reference_point(PA, PO), turn: Deg(turn) };
        self.mill_face(mill, corner, size, overrun, [[false; 2]; 2])
    }

    /// CYCLE61
    pub(super) fn face_by_limits(&self) -> Made<Acts> {
        let mill = self.mill(&CLASSIC)?;
        let given = self.given;
        let at = self.reference_point(PA, PO);
        let size = [self.size_from(LENG, 3, at.x)?, self.size_from(WID, 4, at.y)?];
        let limits = given.whole(LIM);
        if limits > 1111 || (0..4).any(|place| given.digit(LIM, place) > 1) {
            return self.refuse_argument(LIM, codes::P2090::limits_lim_are_four_digits_0(&given.argument(LIM)));
        }
        let wall = |place: u32| given.digit(LIM, place) == 1;
        if limits > 0 {
            self.own_way(codes::P8101::limits_are_read_from_right_as_walls());
        }
        let clearance = mill.heights.clearance;
        let corner = Place { at, turn: Deg(0.0) };
        let overrun = Overrun { ends: clearance, side: clearance };
        self.own_way(codes::P8101::cutter_leaves_open_side_by_safety_distance());
        self.mill_face(mill, corner, size, overrun, [[wall(0), wall(1)], [wall(2), wall(3)]])
    }

    /// A length of the face, or its end point, by a digit of `_AMODE`.
    fn size_from(&self, key: Name, place: u32, from: f64) -> Made<f64> {
        let given = self.given.length(key);
        let size = if self.given.digit(AMODE, place) == 1 { given } else { given - from };
        if size == 0.0 { self.size_is_missing(key) } else { Ok(size) }
    }

    fn size_is_missing<T>(&self, key: Name) -> Made<T> {
        let (name, place) = (self.given.written(key), self.given.argument(key));
        self.refuse_argument(key, codes::P2090::side_of_face_is_0(&name, &place))
    }

    fn mill_face(
        &self,
        mill: Mill,
        corner: Place,
        size: [f64; 2],
        overrun: Overrun,
        walls: [[bool; 2]; 2],
    ) -> Made<Acts> {
        let given = self.given;
        let (unit, tens) = (given.digit(VARI, 0), given.digit(VARI, 1));
        let more = given.whole(VARI) >= 100;
        if !(1..=2).contains(&unit) || !(1..=4).contains(&tens) || more {
            return self.no_such_machining(
                "units 1 roughs, 2 finishes; tens 1 and 3 along the first axis, 2 and 4 along the second, 3 and 4 to and fro",
            );
        }
        let kind = if unit == 1 { Kind::Rough } else { Kind::Finish { lift: self.lift(&mill, &overrun) } };
        let width = self.width(MIDA, mill.radius)?;
        let along = usize::from(tens % 2 == 0);
        let face = Facing {
            mill,
            corner,
            size,
            along,
            alternates: tens > 2,
            links: Links::Usual,
            width,
            overrun,
            walls,
            kind,
            last: None,
        };
        if let Err(fault) = face.check() {
            return self.face_fault(fault);
        }
        Ok(vec![Act::Cycle(Cycle::Facing(face))])
    }

    /// How far the tool is lifted behind a finished path.
    fn lift(&self, mill: &Mill, overrun: &Overrun) -> f64 {
        let heights = &mill.heights;
        let free = (heights.retract - heights.depth).abs();
        [overrun.ends, heights.clearance].into_iter().find(|way| *way > 0.0).map_or(free, |way| way.min(free))
    }

    fn face_fault<T>(&self, fault: FacingFault) -> Made<T> {
        let at = match fault {
            FacingFault::Mill(fault) => return self.mill_fault(&CLASSIC, fault),
            FacingFault::Size => (LENG, 61118, "give both sides of the face"),
            FacingFault::Width | FacingFault::TooManyPaths => (MIDA, 61111, "give a usual width of a cut"),
            FacingFault::Cutter => (LIM, 61105, "take a smaller cutter"),
            FacingFault::NoEntry => (VARI, 61002, "cut along the other axis of the face"),
            FacingFault::Number => (VARI, 61019, "check the arguments of the cycle"),
        };
        self.unsound(at, &fault)
    }
}
