//! CYCLE76, CYCLE77 and CYCLE79: spigots.
//!
//! Source: M 7.6 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::geo::Deg;
use crate::ir::cycle::milling::{Mill, Place};
use crate::ir::cycle::spigot::{Blank, MOST_EDGES, Shape, SpigotFault, stock_at_corner};
use crate::ir::cycle::{Cycle, Family, Spigot};
use crate::machine::options::cycles::SpigotSize;

use super::super::value::whole;
use super::call::{Act, Acts, CycleCall};
use super::milling::{Around, CLASSIC};
use super::names::{AP1, AP2, CDIAM, CRAD, FAL, LENG, MIDA, NUM, PA, PO, RC, STA, SWL, VARI, WID};
use crate::sema::cycle::call::{Kind, Made};
use crate::sema::cycle::row::Name;

/// Arguments of CYCLE77 in its old form.
const OLD_FORM: usize = 16;

impl CycleCall<'_> {
    /// CYCLE76
    pub(super) fn rectangular_spigot(&self) -> Made<Acts> {
        let mill = self.mill(&CLASSIC)?;
        let half = [self.given.magnitude(LENG) / 2.0, self.given.magnitude(WID) / 2.0];
        let shape = Shape::Rectangle { half, corner: self.given.magnitude(CRAD) };
        let place = Place { at: self.reference_point(PA, PO), turn: Deg(self.given.or_zero(STA)) };
        let blank = self.blank(&[AP1, AP2])?;
        let over = [(AP1, half[0]), (AP2, half[1])].map(|(key, half)| self.given.magnitude(key) / 2.0 - half);
        let stands = stock_at_corner(over, self.given.magnitude(CRAD));
        self.stock_that_stays(&mill, stands);
        self.mill_spigot(mill, place, shape, blank, None)
    }

    /// CYCLE77
    pub(super) fn circular_spigot(&self) -> Made<Acts> {
        let mill = self.mill(&CLASSIC)?;
        let size = self.given.magnitude(CDIAM);
        let radius = match (self.given.count() > OLD_FORM, self.settings.cycles.spigot_size) {
            (true, _) | (false, Some(SpigotSize::Diameter)) => size / 2.0,
            (false, Some(SpigotSize::Radius)) => size,
            (false, None) => {
                return self.refuse_as_said(
                    self.given.place_of(CDIAM),
                    codes::S9015::cycle77_in_its_old_form_of_16().answer(Answer::key("cycles", "spigot_size")),
                );
            }
        };
        let place = Place { at: self.reference_point(PA, PO), turn: Deg(0.0) };
        let blank = self.blank(&[AP1])?;
        self.stock_that_stays(&mill, blank - radius);
        self.mill_spigot(mill, place, Shape::Circle { radius }, blank, None)
    }

    /// CYCLE79
    pub(super) fn multi_edge(&self) -> Made<Acts> {
        let mill = self.mill(&CLASSIC)?;
        let given = self.given;
        let edges = given.or_zero(NUM);
        if edges == 1.0 || edges == 2.0 {
            let flats = if edges == 1.0 { "one flat" } else { "two flats" };
            return self.refuse_as_said(
                given.place_of(NUM),
                codes::S9015::cycle79_on_round_blank_is_not_supported(&flats, &edges, &given.argument(NUM)),
            );
        }
        let known = whole(edges).and_then(|n| u32::try_from(n).ok()).filter(|_| edges.fract() == 0.0);
        let Some(edges) = known.filter(|n| (3..=MOST_EDGES).contains(n)) else {
            return self
                .refuse_argument(NUM, codes::P2090::number_of_edges_num_is_3(&given.argument(NUM), &MOST_EDGES));
        };
        if given.or_zero(RC) != 0.0 {
            return self.refuse_argument(RC, codes::S9015::transition_at_corners_of_multi_edge());
        }
        let Some(starts) = self.settings.cycles.multi_edge_start else {
            let fault = codes::S9015::cycle79_whether_edge_or_corner_of_multi();
            return self.refuse_as_said(given.place_of(STA), fault.answer(Answer::key("cycles", "multi_edge_start")));
        };
        let size = self.given.magnitude(SWL);
        let apothem = if edges % 2 == 0 {
            self.own_way(codes::P8101::even_number_of_edges());
            size / 2.0
        } else {
            self.own_way(codes::P8101::odd_number_of_edges());
            let (sin, cos) = Deg(180.0 / f64::from(edges)).sin_cos();
            size * cos / sin / 2.0
        };
        let place = Place { at: self.reference_point(PA, PO), turn: Deg(given.or_zero(STA)) };
        let blank = self.blank(&[AP1])?;
        let width = self.width(MIDA, mill.radius)?;
        self.mill_spigot(mill, place, Shape::Polygon { edges, apothem, starts: starts.into() }, blank, Some(width))
    }

    /// Half of the blank along the first axis; roughing needs it.
    fn blank(&self, keys: &[Name]) -> Made<f64> {
        for key in keys {
            if self.given.magnitude(*key) == 0.0 && self.given.digit(VARI, 0) == 1 {
                let (name, place) = (self.given.written(*key), self.given.argument(*key));
                return self.refuse_argument(*key, codes::P2090::size_of_blank_is_0_or_missing(&name, &place));
            }
        }
        Ok(keys.first().map_or(0.0, |key| self.given.magnitude(*key) / 2.0))
    }

    /// One circuit is as wide as the cutter: says what it leaves of a blank that stands out by more.
    fn stock_that_stays(&self, mill: &Mill, stands: f64) {
        let given = self.given;
        let roughs = given.digit(VARI, 0) == 1;
        if roughs && stands < 0.0 {
            self.leaves_open(codes::S8230::blank_is_smaller_than_spigot());
        }
        let reach = 2.0 * mill.radius + if roughs { self.given.magnitude(FAL) } else { 0.0 };
        let stays = stands - reach;
        // Where it finishes, the allowance on the floor is all that was left.
        if stays <= 1e-6 || !roughs && mill.heights.allowance == 0.0 {
            return;
        }
        let what = if roughs { "of the blank" } else { "with the allowance on the floor of the blank" };
        let (name, place) = (given.written(AP1), given.argument(AP1));
        let fault = codes::S8240::tool_goes_round_once(&given.called, &stays, &what, &name, &place);
        self.note(given.place_of(AP1), fault, Kind::Each);
    }

    fn mill_spigot(&self, mill: Mill, place: Place, shape: Shape, blank: f64, width: Option<f64>) -> Made<Acts> {
        let finishes_floor = match self.given.number(VARI).and_then(whole) {
            Some(1) => false,
            Some(2) => true,
            Some(5) => return self.refuse_argument(VARI, codes::S9015::chamfering_units_of_vari_is_not_supported()),
            _ => return self.no_such_machining("1 roughs, 2 finishes"),
        };
        // The finishing cut takes the allowance off.
        let allowance = if finishes_floor { 0.0 } else { self.given.magnitude(FAL) };
        let counter_clockwise = self.goes_counter_clockwise(Around::Outside)?;
        let blank = Blank { reach: blank, stock: blank - shape.least(), aside: mill.heights.clearance };
        let (rough, finish) = (true, None);
        let spigot =
            Spigot { mill, place, shape, counter_clockwise, allowance, blank, width, finishes_floor, rough, finish };
        if let Err(fault) = spigot.check() {
            return self.spigot_fault(fault);
        }
        self.own_way(codes::P8101::tool_goes_down_safety_distance_beside_blank());
        Ok(vec![Act::Cycle(Cycle::Spigot(spigot))])
    }

    fn spigot_fault<T>(&self, fault: SpigotFault) -> Made<T> {
        let at = match fault {
            SpigotFault::Mill(fault) => return self.mill_fault(&CLASSIC, fault),
            SpigotFault::Corner => (CRAD, 61113, "give at most half of the smaller side"),
            SpigotFault::Width | SpigotFault::TooManyCircuits => (MIDA, 61111, "give a usual width of a cut"),
            SpigotFault::Edges => (NUM, 61019, "give a whole number from 3 on"),
            SpigotFault::Size => {
                let known = [LENG, WID, CDIAM, SWL];
                let key = known.into_iter().find(|key| self.given.argument(*key) > 0).unwrap_or(SWL);
                (key, 61118, "give a size above 0")
            }
            SpigotFault::Number => (VARI, 61019, "check the arguments of the cycle"),
        };
        self.unsound(at, &fault)
    }
}
