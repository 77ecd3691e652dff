//! Datum tables: `SEL TABLE "NAME.D"` selects one, `CYCL DEF 7.1 #5` and `TRANS DATUM TABLE TABLINE5` take a row.
//!
//! A row replaces the shift of all axes (K 3.1, 3.5 in docs/sources.md); axes without a value are refused.

use std::rc::Rc;

use crate::diag::{Answer, Diagnostic, codes};
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
            return self.refuse(self.block_span(), codes::K2402::cycle_7_has_row_of_table());
        }
        let Some(row) = row.map(|row| row.value) else {
            return self.refuse(self.block_span(), codes::K2402::cycle_7_does_not_name_one_row());
        };
        self.take_datum_row(row)
    }

    /// The shift of a row.
    pub(super) fn take_datum_row(&mut self, number: f64) -> Outcome {
        if number.fract() != 0.0 || !(0.0..=MOST_ROWS).contains(&number) {
            return self.refuse(self.block_span(), codes::K2402::is_no_row_of_datum_table(&number));
        }
        let rows = self.datum_rows()?;
        let found: Vec<&Place> = rows.list.iter().filter(|row| row.number == Some(number as u32)).collect();
        let row = match found.as_slice() {
            [row] => *row,
            [] => {
                return self
                    .no_datum(format!("the datum table has no row {number}"), "check the number, or add the row");
            }
            _ => return self.no_datum(format!("the datum table has several rows {number}"), "number the rows"),
        };
        let unit = self.level().frame.unit;
        if rows.unit != Some(unit) {
            let what = "the datum table and the program have different units";
            return self.no_datum(what.to_owned(), "convert the table, and put its unit behind BEGIN");
        }
        let axes = self.axes_of_row(row)?;
        let shown: Vec<String> =
            axes.iter().filter_map(|axis| Some(format!("{}{}", axis.axis.letter(), shown(axis.value?)))).collect();
        self.report(codes::K2513::row_of_datum_table_shifts(&number, &shown.join(" ")).at(self.here.origin.loc));
        self.shift(&axes)
    }

    fn axes_of_row(&mut self, row: &Place) -> Outcome<Vec<AxisValue>> {
        let number = row.number.unwrap_or_default();
        if let Some(title) = &row.unknown {
            let what = format!("row {number} of the datum table has a value under {title}, which is not known");
            return self.no_datum(what, "program the shift: `CYCL DEF 7.1 X+60`");
        }
        if row.rotation != 0.0 {
            let what = format!("row {number} of the datum table has a rotation");
            return self.no_datum(what, "program the shift and cycle 10");
        }
        let mm = self.level().frame.unit.mm();
        let loc = self.here.origin.loc;
        let mut axes = Vec::new();
        for axis in Axis::ALL {
            let value = row.values.get(&axis).copied();
            if value.is_none() && axis.is_main() {
                let what = format!("row {number} of the datum table has no value for {}", axis.letter());
                return self.no_datum(what, "write 0 where the datum stays in place");
            }
            // Axes beside X, Y and Z are shifted only where the table says so.
            let Some(value) = value.filter(|value| axis.is_main() || *value != 0.0) else { continue };
            if !axis.is_main() && !axis.is_rotary() {
                let what = format!("row {number} of the datum table shifts {}", axis.letter());
                return self.no_datum(what, "shifts of U, V and W are not computed");
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
            if let Some(known) = self.job.settings.datums.table.clone() {
                return Ok(self.keep_rows(known.unit, known.places));
            }
            self.report(
                codes::K9012::no_datum_table_is_selected()
                    .answer(Answer::key("control", "datum_table"))
                    .at(self.here.origin.loc),
            );
            return Err(Reported);
        };
        let wanted = Wanted { name: &name, extensions: &["D", "d"], within: Within::Caller };
        let file = open_program(&self.job, &wanted, from, self.here.origin.call).ok_or(Reported)?;
        let text = match whole_file(self.job.sources, file) {
            Ok(text) => text,
            Err(what) => return self.no_datum(format!("the datum table `{name}`: {what}"), "check the file"),
        };
        let contents = match table::read(&text) {
            Ok(contents) => contents,
            Err(wrong) => {
                let what = format!("line {} of the datum table `{name}`: {}", wrong.line, wrong.message);
                return self.no_datum(what, TABLE_FORM);
            }
        };
        if contents.kind != Kind::Datums {
            let what = format!("`{name}` is a {}", contents.kind.name());
            return self.no_datum(what, TABLE_FORM);
        }
        Ok(self.keep_rows(contents.unit, contents.places))
    }

    fn keep_rows(&mut self, unit: Option<Unit>, list: Vec<Place>) -> Rc<Rows> {
        self.datum_table.lost = false;
        let rows = Rc::new(Rows { unit, list });
        self.datum_table.read = Some(Rc::clone(&rows));
        rows
    }

    fn no_datum<T>(&self, what: String, help: &str) -> Outcome<T> {
        self.report(Diagnostic::new(codes::K2948, self.here.origin.loc, what).help(help.to_owned()));
        Err(Reported)
    }
}

const TABLE_FORM: &str =
    "a table has `BEGIN NAME.D MM`, a line with the names of its columns (NR X Y Z …), one row a line, and [END]";
