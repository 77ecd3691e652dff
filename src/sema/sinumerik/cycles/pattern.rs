//! Hole patterns: HOLES1, HOLES2, CYCLE801, CYCLE802.
//!
//! Source: C 6.4 (docs/sources.md).

use crate::diag::codes;
use crate::geo::pattern::{Circle, Fault, Grid, Row, Shear};
use crate::geo::{Deg, Point2};
use crate::ir::contour::Path;
use crate::sema::cycle::row::{Name, Rule};

use super::super::value::whole;
use super::super::{Outcome, Reported};
use super::arguments::{
    ANG1, ANG2, CPA, CPO, DBH, DIS1, DIS2, DMODE, FDIS, HIDE, INDA, Key, NSP, NUM, NUM1, NUM2, RAD, SPCA, SPCO, STA,
    STA1, VARI, XA, YA,
};
use super::call::CycleCall;

/// The positions of CYCLE802.
const POSITIONS: [(Key, Key); 9] = [
    (Key("X0"), Key("Y0")),
    (Key("X1"), Key("Y1")),
    (Key("X2"), Key("Y2")),
    (Key("X3"), Key("Y3")),
    (Key("X4"), Key("Y4")),
    (Key("X5"), Key("Y5")),
    (Key("X6"), Key("Y6")),
    (Key("X7"), Key("Y7")),
    (Key("X8"), Key("Y8")),
];

/// Alarm and fault of a pattern without a hole.
const NO_HOLE: (u32, &str) = (61103, "the pattern has no hole");

/// Begin of the names of arguments that CYCLE802 has besides.
const FURTHER: &str = "S_AB";

impl CycleCall<'_, '_> {
    /// HOLES1
    pub(super) fn row(&mut self) -> Outcome {
        let args = self.args;
        self.begin_pattern()?;
        self.plain_variant()?;
        self.all_positions_in_order()?;
        self.no_signs()?;
        let made = Row {
            reference: self.point_in_plane(SPCA, SPCO),
            direction: Deg(args.or_zero(STA1)),
            first: self.length_or_zero(FDIS),
            spacing: self.length_or_zero(DBH),
            count: self.holes(NUM),
        };
        let positions = made.positions().map(Iterator::collect);
        self.drill_pattern(SPCA, positions, NO_HOLE)
    }

    /// HOLES2
    pub(super) fn circle_of_holes(&mut self) -> Outcome {
        let args = self.args;
        self.begin_pattern()?;
        self.plain_variant()?;
        self.all_positions_in_order()?;
        self.no_signs()?;
        let made = Circle {
            center: self.point_in_plane(CPA, CPO),
            radius: self.length_or_zero(RAD),
            start: Deg(args.or_zero(STA1)),
            step: Deg(args.or_zero(INDA)),
            count: self.holes(NUM),
        };
        let positions = made.positions().map(Iterator::collect);
        self.drill_pattern(CPA, positions, NO_HOLE)
    }

    /// CYCLE801
    pub(super) fn grid(&mut self) -> Outcome {
        let args = self.args;
        self.begin_pattern()?;
        self.all_positions_in_order()?;
        self.no_signs()?;
        if !matches!(args.or_zero(VARI), 0.0 | 1.0) {
            return self.refuse_argument(VARI, codes::S9015::this_variant_of_pattern());
        }
        if args.or_zero(ANG1) != 0.0 || args.or_zero(ANG2) != 0.0 {
            return self.refuse_argument(ANG1, codes::S9015::oblique_grid_is_not_supported());
        }
        let made = Grid {
            reference: self.point_in_plane(SPCA, SPCO),
            turn: Deg(args.or_zero(STA)),
            column_spacing: self.length_or_zero(DIS1),
            row_spacing: self.length_or_zero(DIS2),
            columns: self.holes(NUM1),
            rows: self.holes(NUM2),
            shear: Shear { rows: Deg(0.0), columns: Deg(0.0) },
            frame: args.or_zero(VARI) != 0.0,
        };
        let positions = made.positions().map(Iterator::collect);
        self.drill_pattern(SPCA, positions, (62105, "the pattern has no column or no row"))
    }

    /// Goes to each position and runs the modal cycle there.
    fn drill_pattern(&mut self, first: Key, made: Result<Vec<Point2>, Fault>, empty: (u32, &str)) -> Outcome {
        let args = self.args;
        let positions = match made {
            Ok(positions) => positions,
            Err(fault) => {
                let (alarm, what) = match fault {
                    Fault::None => (Some(empty.0), empty.1),
                    Fault::Overlap => (Some(61106), "the holes go round more than once"),
                    Fault::TooMany => (None, "the pattern has more than 100000 holes"),
                    Fault::Value => (None, "the data of the pattern make no positions"),
                };
                return self.cycle_fault(args.span, alarm, what, "check number and spacing of the holes");
            }
        };
        if self.st.modal_call.cycle().is_none() {
            return self.refuse_argument(first, codes::S9015::pattern_with_modal_program_of_ones_own());
        }
        // Computing them is work, too.
        self.budget.take(positions.len() as u64 / 16);
        for position in positions {
            self.goes_on()?;
            let end = self.moved_in_plane(position);
            self.send(&end, Path::Rapid);
            self.drill_modal()?;
        }
        Ok(())
    }

    /// CYCLE802: up to nine positions, absolute as the masks say.
    pub(super) fn free_positions(&mut self) -> Outcome {
        let args = self.args;
        self.begin_pattern()?;
        self.plain_variant()?;
        self.all_positions_in_order()?;
        for parameter in args.cycle.signature.parameters {
            if let Name::Word(name) = parameter.name
                && name.starts_with(FURTHER)
                && args.or_zero(Key(name)) != 0.0
            {
                return self.refuse_argument(Key(name), codes::S9015::further_arguments_of_cycle802_is_not_supported());
            }
        }
        self.no_signs()?;
        let unit = self.st.length_unit();
        let mut positions = Vec::new();
        for (x, y) in POSITIONS {
            let (x, y) = (args.number(x), args.number(y));
            let (Some(x), Some(y)) = (x, y) else {
                if x.is_some() || y.is_some() {
                    return self.refuse_cycle(args.span, codes::P2090::position_has_one_coordinate());
                }
                continue;
            };
            // One digit for each position, 1 absolute; the digit of an incremental one is not confirmed.
            for mask in [XA, YA] {
                if args.or_zero(mask) != 111_111_111.0 {
                    return self.refuse_argument(mask, codes::S9015::mask_that_is_not_111111111());
                }
            }
            positions.push(Point2::new(x * unit, y * unit));
        }
        self.drill_pattern(XA, Ok(positions), NO_HOLE)
    }

    /// A pattern needs a cycle that it runs.
    fn begin_pattern(&self) -> Outcome {
        let args = self.args;
        if self.st.modal_call.is_lost() {
            return Err(Reported);
        }
        if !self.st.modal_call.is_on() {
            return self.refuse_cycle(args.span, codes::P2090::no_drilling_cycle_is_active());
        }
        Ok(())
    }

    /// Arguments that leave positions out or change their order.
    fn all_positions_in_order(&self) -> Outcome {
        let args = self.args;
        if args.text(HIDE).is_some_and(|text| !text.is_empty() && text != "0") {
            return self.refuse_argument(HIDE, codes::S9015::hidden_positions());
        }
        if args.or_zero(NSP) != 0.0 {
            return self.refuse_argument(NSP, codes::S9015::another_first_position());
        }
        if self.names_other_plane(args) {
            return self.refuse_argument(DMODE, codes::S9015::plane_other_than_active_one());
        }
        Ok(())
    }

    /// Distances and numbers stand without a sign; standard cycles V06.02.09 take the magnitude of one, others are not
    /// known.
    fn no_signs(&self) -> Outcome {
        let args = self.args;
        let below =
            (1..).zip(args.cycle.signature.parameters).zip(&args.list).find_map(|((place, known), (value, span))| {
                let given = value.number().filter(|given| known.rule == Rule::Unsigned && *given < 0.0)?;
                Some((place, given, *span))
            });
        let Some((place, given, span)) = below else { return self.lengths_are_plain() };
        let place: usize = place;
        self.refuse_cycle(span, codes::P2090::argument_is_has_no_sign_in_manuals(&place, &given))
    }

    fn lengths_are_plain(&self) -> Outcome {
        let args = self.args;
        let [first, second, _] = self.st.roles();
        for axis in [first, second] {
            self.no_diameters(args.name(), axis, args.span)?;
        }
        Ok(())
    }

    fn length_or_zero(&self, key: Key) -> f64 {
        let args = self.args;
        args.or_zero(key) * self.st.length_unit()
    }

    fn point_in_plane(&self, first: Key, second: Key) -> Point2 {
        Point2::new(self.length_or_zero(first), self.length_or_zero(second))
    }

    fn plain_variant(&self) -> Outcome {
        let args = self.args;
        if args.or_zero(VARI) != 0.0 {
            return self.refuse_argument(VARI, codes::S9015::variant_of_pattern());
        }
        Ok(())
    }

    /// A number of holes: an INT of the cycle, so a REAL is rounded.
    fn holes(&self, key: Key) -> u32 {
        let args = self.args;
        let given = args.or_zero(key);
        // No pattern has so many; it is refused there.
        let count = whole(given).map_or(u32::MAX, i32::unsigned_abs);
        if given != f64::from(count) {
            let found = codes::S8050::argument_is_cycle_counts(&args.name(), &args.place(key), &given, &count)
                .at(self.loc(args.span_of(key)));
            self.report(found.help("write a whole number"));
        }
        count
    }
}
