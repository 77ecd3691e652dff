//! Datum tables: `SEL TABLE "NAME.D"` selects one, `CYCL DEF 7.1 #5` and `TRANS DATUM TABLE TABLINE5` take a row.
//!
//! A row replaces the shift of all axes (K 3.1, 3.5 in docs/sources.md); axes without a value are refused.

use std::rc::Rc;

use crate::diag::{Answer, Fault, codes};
use crate::machine::table::{self, Kind, Place};
use crate::machine::{Axis, Unit};
use crate::sema::run::{Wanted, open_program};
use crate::text::{Loc, Within};

use super::cycle_definition::{AxisValue, Open};
use super::cycles::machining::shown;
use super::point_table::whole_file;
use super::{Outcome, Reported, Run};

/// Largest number of a row.
const MOST_ROWS: f64 = 2999.0;

/// The table that SEL TABLE names, read when a row is taken.
#[derive(Debug, Default)]
pub(super) struct DatumTable {
    selected: Option<(String, Loc)>,
    read: Option<Rc<Rows>>,
    /// It could not be read, which is said.
    lost: bool,
}

#[derive(Debug)]
struct Rows {
    unit: Option<Unit>,
    list: Vec<Place>,
}

impl DatumTable {
    pub fn select(&mut self, name: String, from: Loc) {
        *self = DatumTable { selected: Some((name, from)), read: None, lost: false };
    }
}

impl Run<'_> {
    /// Cycle 7 with `#5`.
    pub(super) fn shift_by_row(&mut self, open: &Open) -> Outcome {
        let row = match open.values.as_slice() {
            [row] if row.label == "#" => Some(row),
            _ => None,
        };
        if !open.axes.is_empty() {
            return self.core.refuse(self.core.block_span(), codes::K2402::cycle_7_has_row_of_table());
        }
        let Some(row) = row.map(|row| row.value) else {
            return self.core.refuse(self.core.block_span(), codes::K2402::cycle_7_does_not_name_one_row());
        };
        self.take_datum_row(row)
    }

    /// The shift of a row.
    pub(super) fn take_datum_row(&mut self, number: f64) -> Outcome {
        if number.fract() != 0.0 || !(0.0..=MOST_ROWS).contains(&number) {
            return self.core.refuse(self.core.block_span(), codes::K2402::is_no_row_of_datum_table(&number));
        }
        let rows = self.datum_rows()?;
        let found: Vec<&Place> = rows.list.iter().filter(|row| row.number == Some(number as u32)).collect();
        let row = match found.as_slice() {
            [row] => *row,
            [] => {
                return self.no_datum(codes::K2948::table_has_no_row(&number));
            }
            _ => return self.no_datum(codes::K2948::table_has_several_rows(&number)),
        };
        let unit = self.core.level().frame.unit;
        if rows.unit != Some(unit) {
            return self.no_datum(codes::K2948::table_and_program_have_different_units());
        }
        let axes = self.axes_of_row(row)?;
        let shown: Vec<String> =
            axes.iter().filter_map(|axis| Some(format!("{}{}", axis.axis.letter(), shown(axis.value?)))).collect();
        self.core
            .report(codes::K2513::row_of_datum_table_shifts(&number, &shown.join(" ")).at(self.core.here.origin.loc));
        self.shift(&axes)
    }

    fn axes_of_row(&mut self, row: &Place) -> Outcome<Vec<AxisValue>> {
        let number = row.number.unwrap_or_default();
        if let Some(title) = &row.unknown {
            return self.no_datum(codes::K2948::row_has_value_under_unknown_title(&number, &title));
        }
        if row.rotation != 0.0 {
            return self.no_datum(codes::K2948::row_has_rotation(&number));
        }
        let mm = self.core.level().frame.unit.mm();
        let loc = self.core.here.origin.loc;
        let mut axes = Vec::new();
        for axis in Axis::ALL {
            let value = row.values.get(&axis).copied();
            if value.is_none() && axis.is_main() {
                return self.no_datum(codes::K2948::row_has_no_value(&number, &axis.letter()));
            }
            // Axes beside X, Y and Z are shifted only where the table says so.
            let Some(value) = value.filter(|value| axis.is_main() || *value != 0.0) else { continue };
            if !axis.is_main() && !axis.is_rotary() {
                return self.no_datum(codes::K2948::row_shifts(&number, &axis.letter()));
            }
            let value = if axis.is_rotary() { value } else { value / mm };
            axes.push(AxisValue { axis, incremental: false, value: Some(value), loc });
        }
        Ok(axes)
    }

    fn datum_rows(&mut self) -> Outcome<Rc<Rows>> {
        if self.datum_table.lost {
            return Err(Reported);
        }
        if let Some(rows) = &self.datum_table.read {
            return Ok(Rc::clone(rows));
        }
        self.datum_table.lost = true;
        let Some((name, from)) = self.datum_table.selected.clone() else {
            if let Some(known) = self.core.job.settings.datums.table.clone() {
                return Ok(self.keep_rows(known.unit, known.places));
            }
            self.core.report(
                codes::K9012::no_datum_table_is_selected().answer(Answer::key("control", "datum_table")).at(self
                    .core
                    .here
                    .origin
                    .loc),
            );
            return Err(Reported);
        };
        let wanted = Wanted { name: &name, extensions: &["D", "d"], within: Within::Caller };
        let file = open_program(&self.core.job, &wanted, from, self.core.here.origin.call).ok_or(Reported)?;
        let text = match whole_file(self.core.job.sources, file) {
            Ok(text) => text,
            Err(what) => return self.no_datum(codes::K2948::table_is_not_read(&name, &what)),
        };
        let contents = match table::read(&text) {
            Ok(contents) => contents,
            Err(wrong) => {
                return self.no_datum(codes::K2948::line_of_table(&wrong.line, &name, &wrong.message));
            }
        };
        if contents.kind != Kind::Datums {
            return self.no_datum(codes::K2948::is_another_table(&name, &contents.kind.name()));
        }
        Ok(self.keep_rows(contents.unit, contents.places))
    }

    fn keep_rows(&mut self, unit: Option<Unit>, list: Vec<Place>) -> Rc<Rows> {
        self.datum_table.lost = false;
        let rows = Rc::new(Rows { unit, list });
        self.datum_table.read = Some(Rc::clone(&rows));
        rows
    }

    fn no_datum<T>(&self, fault: Fault) -> Outcome<T> {
        self.core.report(fault.at(self.core.here.origin.loc));
        Err(Reported)
    }
}
