//! Hole patterns: HOLES1, HOLES2, CYCLE801, CYCLE802.
//!
//! Source: reference section 6.4.

use crate::diag::{Diagnostic, codes};
use crate::geo::pattern::{Circle, Fault, Grid, Row, Shear};
use crate::geo::{Deg, Point2};
use crate::ir::contour::Path;

use super::super::g_groups::Group;
use super::super::value::whole;
use super::super::{Outcome, Reported, Run};
use super::Arguments;

/// Positions of CYCLE802.
const POSITIONS: usize = 9;

impl Run<'_> {
    /// Goes to each position and runs the modal cycle there.
    pub(super) fn pattern(&mut self, args: &Arguments) -> Outcome {
        if self.modal_lost {
            return Err(Reported);
        }
        if self.modal_cycle.is_none() && self.modal.is_none() {
            return self.cycle_fault(
                args,
                args.span,
                62100,
                "no drilling cycle is active",
                "call it before: MCALL CYCLE81(…)",
            );
        }
        self.pattern_modes(args)?;
        self.no_signs(args)?;
        let [first, second, _] = self.st.roles();
        for axis in [first, second] {
            self.no_diameters(&args.name, axis, args.span)?;
        }
        let positions = self.positions(args)?;
        if self.modal_cycle.is_none() {
            return self.not_built(args, 1, "a pattern with a modal program of one's own");
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

    /// Arguments that leave positions out or change their order.
    fn pattern_modes(&self, args: &Arguments) -> Outcome {
        let (vari, hide, start, plane) = match args.name.as_str() {
            "HOLES1" => (7, 9, 10, 11),
            "HOLES2" => (7, 9, 10, 11),
            "CYCLE801" => (0, 12, 13, 14),
            _ => (21, 0, 0, 23),
        };
        if vari != 0 && args.or_zero(vari) != 0.0 {
            return self.not_built(args, vari, "a variant of the pattern (`_VARI`)");
        }
        if hide != 0 && args.text(hide).is_some_and(|text| !text.is_empty() && text != "0") {
            return self.not_built(args, hide, "hidden positions (`_HIDE`)");
        }
        if start != 0 && args.or_zero(start) != 0.0 {
            return self.not_built(args, start, "another first position (`_NSP`)");
        }
        let digit = args.digit(plane, 0);
        if digit != 0 && digit != i32::from(self.st.codes.of(Group::Plane).index) {
            return self.not_built(args, plane, "a plane other than the active one (`_DMODE`)");
        }
        for place in 24..=33 {
            if args.name == "CYCLE802" && args.or_zero(place) != 0.0 {
                return self.not_built(args, place, "further arguments of CYCLE802");
            }
        }
        Ok(())
    }

    /// A number of holes: an INT of the cycle, so a REAL is rounded.
    fn holes(&self, args: &Arguments, place: usize) -> u32 {
        let given = args.or_zero(place);
        // No pattern has so many; it is refused there.
        let count = whole(given).map_or(u32::MAX, i32::unsigned_abs);
        if given != f64::from(count) {
            let message = format!("{}: argument {place} is {given}, and the cycle counts {count}", args.name);
            let found = Diagnostic::new(codes::S8050, self.loc(args.span_of(place)), message);
            self.report(found.help("write a whole number"));
        }
        count
    }

    /// Distances and numbers stand without a sign; standard cycles V06.02.09 take the magnitude of one, others are not
    /// known.
    fn no_signs(&self, args: &Arguments) -> Outcome {
        let places: &[usize] = match args.name.as_str() {
            "HOLES1" => &[4, 5, 6],
            "HOLES2" => &[3, 6],
            "CYCLE801" => &[4, 5, 6, 7],
            _ => &[],
        };
        let Some(place) = places.iter().find(|place| args.or_zero(**place) < 0.0) else { return Ok(()) };
        let message = format!("argument {place} is {}, and has no sign in the manuals", args.or_zero(*place));
        let help =
            "some versions of the cycle take its magnitude: write it without the sign, and turn the row by its angle";
        self.cycle_fault(args, args.span_of(*place), 61019, &message, help)
    }

    fn positions(&self, args: &Arguments) -> Outcome<Vec<Point2>> {
        let unit = self.st.length_unit();
        let length = |place: usize| args.or_zero(place) * unit;
        let count = |place: usize| self.holes(args, place);
        let made = match args.name.as_str() {
            "HOLES1" => Row {
                reference: Point2::new(length(1), length(2)),
                direction: Deg(args.or_zero(3)),
                first: length(4),
                spacing: length(5),
                count: count(6),
            }
            .positions()
            .map(Iterator::collect),
            "HOLES2" => Circle {
                center: Point2::new(length(1), length(2)),
                radius: length(3),
                start: Deg(args.or_zero(4)),
                step: Deg(args.or_zero(5)),
                count: count(6),
            }
            .positions()
            .map(Iterator::collect),
            "CYCLE801" => {
                if !matches!(args.or_zero(8), 0.0 | 1.0) {
                    return self.not_built(args, 8, "this variant of the pattern (`_VARI`)");
                }
                if args.or_zero(10) != 0.0 || args.or_zero(11) != 0.0 {
                    return self.not_built(args, 10, "an oblique grid");
                }
                Grid {
                    reference: Point2::new(length(1), length(2)),
                    turn: Deg(args.or_zero(3)),
                    column_spacing: length(4),
                    row_spacing: length(5),
                    columns: count(6),
                    rows: count(7),
                    shear: Shear { rows: Deg(0.0), columns: Deg(0.0) },
                    frame: args.or_zero(8) != 0.0,
                }
                .positions()
                .map(Iterator::collect)
            }
            _ => return self.free_positions(args),
        };
        match made {
            Ok(positions) => Ok(positions),
            Err(fault) => {
                let (alarm, what) = match fault {
                    Fault::None if args.name == "CYCLE801" => (62105, "the pattern has no column or no row"),
                    Fault::None => (61103, "the pattern has no hole"),
                    Fault::Overlap => (61106, "the holes go round more than once"),
                    Fault::TooMany => (0, "the pattern has more than 100000 holes"),
                    Fault::Value => (0, "the data of the pattern make no positions"),
                };
                self.cycle_fault(args, args.span, alarm, what, "check number and spacing of the holes")
            }
        }
    }

    /// Up to nine positions, absolute as the masks say.
    fn free_positions(&self, args: &Arguments) -> Outcome<Vec<Point2>> {
        let unit = self.st.length_unit();
        let mut positions = Vec::new();
        for at in 0..POSITIONS {
            let (x, y) = (args.number(3 + 2 * at), args.number(4 + 2 * at));
            let (Some(x), Some(y)) = (x, y) else {
                if x.is_some() || y.is_some() {
                    return self.cycle_fault(args, args.span, 0, "a position has one coordinate only", "give both");
                }
                continue;
            };
            // One digit for each position, 1 absolute; the digit of an incremental one is not confirmed.
            for mask in [1, 2] {
                if args.or_zero(mask) != 111_111_111.0 {
                    return self.not_built(args, mask, "a mask that is not 111111111, all absolute (`_XA`, `_YA`)");
                }
            }
            positions.push(Point2::new(x * unit, y * unit));
        }
        Ok(positions)
    }
}
