//! Rows of axis values: preset tables (`.PR`), datum tables (`.D`), point tables (`.PNT`).

use std::collections::BTreeMap;

use crate::machine::Axis;

use super::columns::{Columns, Row};
use super::{Contents, Kind, TableError};

/// A row of a table of places; lengths in mm, angles in degrees.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Place {
    pub line: usize,
    pub number: Option<u32>,
    /// Axes without a value are not there.
    pub values: BTreeMap<Axis, f64>,
    /// Basic rotation of a preset.
    pub rotation: f64,
    pub remark: Option<String>,
    /// A column that partc knows nothing of, with a value other than zero.
    pub unknown: Option<String>,
}

/// Columns that say nothing about the place.
const BESIDE: &[&str] = &["NR", "DOC", "ACTNO", "LOCKED", "LOCK", "NO"];
const ROTATIONS: &[&str] = &["ROT"];

pub(super) fn is_text(title: &str) -> bool {
    matches!(title, "DOC" | "ACTNO" | "LOCKED")
}

/// Reads a preset or datum table.
///
/// # Errors
/// A table that says something else, or is cut off.
pub(super) fn read(text: &str, kind: Kind) -> Result<Contents, TableError> {
    let table = Columns::read(text, is_text)?;
    let fail = |message: &str| TableError { line: text.lines().count().max(1), message: message.to_owned() };
    if table.unit.is_none() {
        let message = "it does not begin with BEGIN, its name, and MM or INCH".to_owned();
        return Err(TableError { line: 1, message });
    }
    if !table.ended {
        return Err(fail("[END] is missing, so the table may be cut off"));
    }
    let mut contents = Contents { kind, unit: table.unit, ..Contents::default() };
    for row in &table.rows {
        contents.places.push(place(&table, row)?);
    }
    Ok(contents)
}

fn place(table: &Columns, row: &Row) -> Result<Place, TableError> {
    let mut place = Place { line: row.line, ..Place::default() };
    let number = table.cell(row, "NR").or_else(|| table.cell(row, "NO"));
    if let Some(text) = number {
        let fail = || TableError { line: row.line, message: format!("`{text}` under NR is no number of a row") };
        place.number = Some(text.parse().map_err(|_| fail())?);
    }
    place.remark = table.cell(row, "DOC").map(str::to_owned);
    for title in table.titles() {
        let axis = title.as_bytes().first().filter(|_| title.len() == 1).and_then(|letter| Axis::of(*letter));
        match axis {
            Some(axis) if axis.is_rotary() => {
                if let Some(angle) = table.number(row, title)? {
                    place.values.insert(axis, angle);
                }
            }
            Some(axis) => {
                if let Some(value) = table.length(row, title)? {
                    place.values.insert(axis, value);
                }
            }
            None if ROTATIONS.contains(&title) => place.rotation = table.number(row, title)?.unwrap_or_default(),
            None if BESIDE.contains(&title) => {}
            None => {
                let says = |text: &str| super::columns::signed(text) != Some(0.0);
                if place.unknown.is_none() && table.cell(row, title).is_some_and(says) {
                    place.unknown = Some(title.to_owned());
                }
            }
        }
    }
    Ok(place)
}
