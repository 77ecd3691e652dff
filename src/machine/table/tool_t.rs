//! `TOOL.T` of a HEIDENHAIN control.

use crate::machine::{Tool, ToolKey};

use super::columns::Columns;
use super::{Contents, TableError};

/// Columns that become fields of a tool.
const READ: &[&str] = &["T", "NAME", "L", "R", "R2", "DL", "DR", "DR2", "CUT", "CUT.", "ANGLE", "T-ANGLE"];
/// Columns that hold numbers or nothing; all others are text or belong to the machine.
const NUMBERS: &[&str] = &["T", "L", "R", "R2", "DL", "DR", "DR2", "CUT", "CUT.", "ANGLE", "T-ANGLE", "LCUTS", "RT"];

pub(super) fn is_text(title: &str) -> bool {
    !NUMBERS.contains(&title)
}

/// # Errors
/// A line without a tool number, or without a number where one belongs.
pub(super) fn read(text: &str) -> Result<Contents, TableError> {
    let table = Columns::read(text, is_text)?;
    if table.name.contains('.') && !table.name.ends_with(".T") {
        let message = format!("{} is no table that partc reads: TOOL.T, .D, .PR or .PNT", table.name);
        return Err(TableError { line: 1, message });
    }
    let mut contents = Contents { unit: table.unit, ..Contents::default() };
    let mut ended = table.ended || table.name.is_empty();
    for row in &table.rows {
        let number = table.cell(row, "T").unwrap_or_default();
        // [END] of older files has no brackets.
        if number.eq_ignore_ascii_case("END") {
            ended = true;
            break;
        }
        let name = table.cell(row, "NAME");
        if let Some(value) = name.and_then(value_within) {
            let message = format!("`{value}` stands under NAME like a value of the column after it");
            return Err(TableError { line: row.line, message });
        }
        let fail = || TableError { line: row.line, message: format!("`{number}` under T is no tool number") };
        let (number, index) = super::tool_number(number).ok_or_else(fail)?;
        let delta = |title| table.length(row, title).map(Option::unwrap_or_default);
        let tool = Tool {
            name: name.map(|name| name.trim_matches('"').to_owned()).filter(|name| !name.is_empty()),
            radius: table.length(row, "R")?,
            length: table.length(row, "L")?,
            corner_radius: table.length(row, "R2")?,
            plunge_angle: table.number(row, "ANGLE")?,
            tip_angle: table.number(row, "T-ANGLE")?.filter(|angle| *angle != 0.0),
            teeth: table.number(row, "CUT")?.or(table.number(row, "CUT.")?).and_then(teeth),
            deltas: [delta("DL")?, delta("DR")?, delta("DR2")?],
            ..Tool::default()
        };
        if contents.tools.insert(ToolKey::Number(number, index), tool).is_some() {
            return Err(TableError { line: row.line, message: format!("tool {number} stands twice in the table") });
        }
    }
    let others = table.titles().filter(|title| !READ.contains(title));
    let with_values = others.filter_map(|title| {
        let first = table.rows.iter().find(|row| table.cell(row, title).is_some())?;
        Some((first.line, format!("column {title}")))
    });
    contents.left_out.extend(with_values);
    if !ended {
        let message = "[END] is missing, so the table may be cut off".to_owned();
        return Err(TableError { line: text.lines().count().max(1), message });
    }
    Ok(contents)
}

/// 0 stands for a number that nobody gave.
fn teeth(count: f64) -> Option<u8> {
    (count.fract() == 0.0 && (1.0..=99.0).contains(&count)).then_some(count as u8)
}

/// What looks like a value in a name: a number with its sign, or one that stands apart.
fn value_within(name: &str) -> Option<&str> {
    let mut apart = false;
    for (at, word) in name.split(' ').enumerate() {
        let digits = word.strip_prefix(['+', '-']).unwrap_or(word);
        let is_number = super::columns::signed(word).is_some();
        if is_number && (digits.len() < word.len() || apart && at > 0) {
            return Some(word);
        }
        apart = word.is_empty();
    }
    None
}
