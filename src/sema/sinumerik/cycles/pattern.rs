//! Hole patterns: HOLES1, HOLES2, CYCLE801, CYCLE802.
//!
//! Source: C 6.4 (docs/sources.md).

use crate::diag::{Fault, codes};
use crate::geo::pattern::{Circle, Fault as PatternFault, Grid, Row, Shear};
use crate::geo::{Deg, Point2};
use crate::sema::cycle::row::Name;

use super::super::value::whole;
use super::call::{Act, Acts, CycleCall};
use super::names::{
    ANG1, ANG2, CPA, CPO, DBH, DIS1, DIS2, FDIS, HIDE, INDA, NSP, NUM, NUM1, NUM2, RAD, SPCA, SPCO, STA, STA1, VARI,
    XA, YA,
};
use crate::sema::cycle::call::{Kind, Made};

/// The positions of CYCLE802.
const POSITIONS: [(Name, Name); 9] = [
    (Name::Word("X0"), Name::Word("Y0")),
    (Name::Word("X1"), Name::Word("Y1")),
    (Name::Word("X2"), Name::Word("Y2")),
    (Name::Word("X3"), Name::Word("Y3")),
    (Name::Word("X4"), Name::Word("Y4")),
    (Name::Word("X5"), Name::Word("Y5")),
    (Name::Word("X6"), Name::Word("Y6")),
    (Name::Word("X7"), Name::Word("Y7")),
    (Name::Word("X8"), Name::Word("Y8")),
];

/// Begin of the names of arguments that CYCLE802 has besides.
const FURTHER: &str = "S_AB";

impl CycleCall<'_> {
    /// HOLES1
    pub(super) fn row(&self) -> Made<Acts> {
        let given = self.given;
        self.plain_variant()?;
        self.all_positions_in_order()?;
        let made = Row {
            reference: self.point_in_plane(SPCA, SPCO),
            direction: Deg(given.or_zero(STA1)),
            first: given.length(FDIS),
            spacing: given.length(DBH),
            count: self.holes(NUM),
        };
        let positions = made.positions().map(Iterator::collect);
        self.drill_pattern(SPCA, positions, codes::P2090::pattern_has_no_hole())
    }

    /// HOLES2
    pub(super) fn circle_of_holes(&self) -> Made<Acts> {
        let given = self.given;
        self.plain_variant()?;
        self.all_positions_in_order()?;
        let made = Circle {
            center: self.point_in_plane(CPA, CPO),
            radius: given.length(RAD),
            start: Deg(given.or_zero(STA1)),
            step: Deg(given.or_zero(INDA)),
            count: self.holes(NUM),
        };
        let positions = made.positions().map(Iterator::collect);
        self.drill_pattern(CPA, positions, codes::P2090::pattern_has_no_hole())
    }

    /// CYCLE801
    pub(super) fn grid(&self) -> Made<Acts> {
        let given = self.given;
        self.all_positions_in_order()?;
        if !matches!(given.or_zero(VARI), 0.0 | 1.0) {
            return self.refuse_argument(VARI, codes::S9015::this_variant_of_pattern());
        }
        if given.or_zero(ANG1) != 0.0 || given.or_zero(ANG2) != 0.0 {
            return self.refuse_argument(ANG1, codes::S9015::oblique_grid_is_not_supported());
        }
        let made = Grid {
            reference: self.point_in_plane(SPCA, SPCO),
            turn: Deg(given.or_zero(STA)),
            column_spacing: given.length(DIS1),
            row_spacing: given.length(DIS2),
            columns: self.holes(NUM1),
            rows: self.holes(NUM2),
            shear: Shear { rows: Deg(0.0), columns: Deg(0.0) },
            frame: given.or_zero(VARI) != 0.0,
        };
        let positions = made.positions().map(Iterator::collect);
        self.drill_pattern(SPCA, positions, codes::P2090::pattern_has_no_column_or_row())
    }

    /// Goes to each position and runs the modal cycle there; `empty` is what a pattern without a hole is refused as.
    fn drill_pattern(&self, first: Name, made: Result<Vec<Point2>, PatternFault>, empty: Fault) -> Made<Acts> {
        match made {
            Ok(_) if self.st.modal_call.cycle().is_none() => {
                self.refuse_argument(first, codes::S9015::pattern_with_modal_program_of_ones_own())
            }
            Ok(places) => Ok(vec![Act::Drill(places)]),
            Err(PatternFault::None) => self.refuse(empty),
            Err(PatternFault::Overlap) => self.refuse(codes::P2090::holes_go_round_more_than_once()),
            Err(PatternFault::TooMany) => self.refuse(codes::P2090::pattern_has_too_many_holes()),
            Err(PatternFault::Value) => self.refuse(codes::P2090::data_of_pattern_make_no_positions()),
        }
    }

    /// CYCLE802: up to nine positions, absolute as the masks say.
    pub(super) fn free_positions(&self) -> Made<Acts> {
        let given = self.given;
        self.plain_variant()?;
        self.all_positions_in_order()?;
        for parameter in given.signature.parameters {
            if let Name::Word(name) = parameter.name
                && name.starts_with(FURTHER)
                && given.or_zero(parameter.name) != 0.0
            {
                return self
                    .refuse_argument(parameter.name, codes::S9015::further_arguments_of_cycle802_is_not_supported());
            }
        }
        let unit = self.given.unit;
        let mut positions = Vec::new();
        for (x, y) in POSITIONS {
            let (x, y) = (given.number(x), given.number(y));
            let (Some(x), Some(y)) = (x, y) else {
                if x.is_some() || y.is_some() {
                    return self.refuse(codes::P2090::position_has_one_coordinate());
                }
                continue;
            };
            // One digit for each position, 1 absolute; the digit of an incremental one is not confirmed.
            for mask in [XA, YA] {
                if given.or_zero(mask) != 111_111_111.0 {
                    return self.refuse_argument(mask, codes::S9015::mask_that_is_not_111111111());
                }
            }
            positions.push(Point2::new(x * unit, y * unit));
        }
        self.drill_pattern(XA, Ok(positions), codes::P2090::pattern_has_no_hole())
    }

    /// Arguments that leave positions out or change their order.
    fn all_positions_in_order(&self) -> Made {
        let given = self.given;
        if given.text(HIDE).is_some_and(|text| text != "0") || given.or_zero(HIDE) != 0.0 {
            return self.refuse_argument(HIDE, codes::S9015::hidden_positions());
        }
        if given.or_zero(NSP) != 0.0 {
            return self.refuse_argument(NSP, codes::S9015::another_first_position());
        }
        Ok(())
    }

    fn point_in_plane(&self, first: Name, second: Name) -> Point2 {
        Point2::new(self.given.length(first), self.given.length(second))
    }

    fn plain_variant(&self) -> Made {
        let given = self.given;
        if given.or_zero(VARI) != 0.0 {
            return self.refuse_argument(VARI, codes::S9015::variant_of_pattern());
        }
        Ok(())
    }

    /// A number of holes: an INT of the cycle, so a REAL is rounded.
    fn holes(&self, key: Name) -> u32 {
        let given = self.given;
        let number = given.or_zero(key);
        // No pattern has so many; it is refused there.
        let count = whole(number).map_or(u32::MAX, i32::unsigned_abs);
        if number != f64::from(count) {
            let fault = codes::S8050::argument_is_cycle_counts(&given.called, &given.argument(key), &number, &count);
            self.note(given.place_of(key), fault, Kind::Each);
        }
        count
    }
}
