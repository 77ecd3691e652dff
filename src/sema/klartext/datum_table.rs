//! Datum tables: `SEL TABLE "NAME.D"` selects one, `CYCL DEF 7.1 #5` and `TRANS DATUM TABLE TABLINE5` take a row.
//!
//! A row replaces the shift of all axes (K 3.1, 3.5 in docs/sources.md); axes without a value are refused.

use std::rc::Rc;

use crate::diag::{Answer, codes};
use crate::machine::table::{self, Kind, Place};
use crate::machine::{Axis, Unit};
use crate::sema::run::{Wanted, Where, open_program};
use crate::text::{Loc, Within};

use super::cycle_definition::{AxisValue, Open};
use super::cycles::machining::shown;
use super::point_table::whole_file;
use super::{Core, Outcome, Reported};

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

    /// The shift of cycle 7: of the axes that it names, or by a row, `#5`.
    pub fn axes_of(&mut self, core: &Core<'_>, open: &Open) -> Outcome<Vec<AxisValue>> {
        let fault = match (open.table_row, open.values.as_slice()) {
            (false, _) if open.axes.is_empty() => codes::K2402::cycle_7_names_no_axis(),
            (false, _) => return Ok(open.axes.clone()),
            (true, _) if !open.axes.is_empty() => codes::K2402::cycle_7_has_row_of_table(),
            (true, [row]) if row.label == "#" => return self.row(core, row.value),
            (true, _) => codes::K2402::cycle_7_does_not_name_one_row(),
        };
        core.refuse(Where::Block, fault)
    }

    /// The shift of a row.
    pub fn row(&mut self, core: &Core<'_>, number: f64) -> Outcome<Vec<AxisValue>> {
        if number.fract() != 0.0 || !(0.0..=MOST_ROWS).contains(&number) {
            return core.refuse(Where::Block, codes::K2402::is_no_row_of_datum_table(&number));
        }
        let rows = self.rows(core)?;
        let found: Vec<&Place> = rows.list.iter().filter(|row| row.number == Some(number as u32)).collect();
        let row = match found.as_slice() {
            [row] => *row,
            [] => {
                return core.refuse(Where::Block, codes::K2948::table_has_no_row(&number));
            }
            _ => return core.refuse(Where::Block, codes::K2948::table_has_several_rows(&number)),
        };
        if rows.unit != Some(core.unit()) {
            return core.refuse(Where::Block, codes::K2948::table_and_program_have_different_units());
        }
        let axes = axes_of_row(core, row)?;
        let shown: Vec<String> =
            axes.iter().filter_map(|axis| Some(format!("{}{}", axis.axis.letter(), shown(axis.value?)))).collect();
        core.say_here(codes::K2513::row_of_datum_table_shifts(&number, &shown.join(" ")));
        Ok(axes)
    }

    fn rows(&mut self, core: &Core<'_>) -> Outcome<Rc<Rows>> {
        if self.lost {
            return Err(Reported);
        }
        if let Some(rows) = &self.read {
            return Ok(Rc::clone(rows));
        }
        self.lost = true;
        let Some((name, from)) = self.selected.clone() else {
            if let Some(known) = core.job.settings.datums.table.clone() {
                return Ok(self.keep_rows(known.unit, known.places));
            }
            let fault = codes::K9012::no_datum_table_is_selected();
            return core.refuse(Where::Block, fault.answer(Answer::key("control", "datum_table")));
        };
        let wanted = Wanted { name: &name, extensions: &["D", "d"], within: Within::Caller };
        let file = open_program(&core.job, &wanted, from, core.here.origin.call).ok_or(Reported)?;
        let text = match whole_file(core.job.sources, file) {
            Ok(text) => text,
            Err(what) => return core.refuse(Where::Block, codes::K2948::table_is_not_read(&name, &what)),
        };
        let contents = match table::read(&text) {
            Ok(contents) => contents,
            Err(wrong) => {
                return core.refuse(Where::Block, codes::K2948::line_of_table(&wrong.line, &name, &wrong.message));
            }
        };
        if contents.kind != Kind::Datums {
            return core.refuse(Where::Block, codes::K2948::is_another_table(&name, &contents.kind.name()));
        }
        Ok(self.keep_rows(contents.unit, contents.places))
    }

    fn keep_rows(&mut self, unit: Option<Unit>, list: Vec<Place>) -> Rc<Rows> {
        self.lost = false;
        let rows = Rc::new(Rows { unit, list });
        self.read = Some(Rc::clone(&rows));
        rows
    }
}

fn axes_of_row(core: &Core<'_>, row: &Place) -> Outcome<Vec<AxisValue>> {
    let number = row.number.unwrap_or_default();
    if let Some(title) = &row.unknown {
        return core.refuse(Where::Block, codes::K2948::row_has_value_under_unknown_title(&number, &title));
    }
    if row.rotation != 0.0 {
        return core.refuse(Where::Block, codes::K2948::row_has_rotation(&number));
    }
    let mm = core.mm();
    let loc = core.here.origin.loc;
    let mut axes = Vec::new();
    for axis in Axis::ALL {
        let value = row.values.get(&axis).copied();
        if value.is_none() && axis.is_main() {
            return core.refuse(Where::Block, codes::K2948::row_has_no_value(&number, &axis.letter()));
        }
        // Axes beside X, Y and Z are shifted only where the table says so.
        let Some(value) = value.filter(|value| axis.is_main() || *value != 0.0) else { continue };
        if !axis.is_main() && !axis.is_rotary() {
            return core.refuse(Where::Block, codes::K2948::row_shifts(&number, &axis.letter()));
        }
        let value = if axis.is_rotary() { value } else { value / mm };
        axes.push(AxisValue { axis, incremental: false, value: Some(value), loc });
    }
    Ok(axes)
}
