//! The `.ini` of a LinuxCNC machine: limits of its axes, in the unit of the machine.

use crate::machine::{Axis, Unit};

use super::columns::signed;
use super::{Contents, Kind, TableError};

/// # Errors
/// A limit that is no number.
pub(super) fn read(text: &str) -> Result<Contents, TableError> {
    let mut contents = Contents { kind: Kind::Machine, ..Contents::default() };
    let mut section = String::new();
    for (line, text) in (1..).zip(text.lines()) {
        let text = text.trim();
        if text.is_empty() || text.starts_with(['#', ';']) {
            continue;
        }
        if let Some(name) = text.strip_prefix('[') {
            section = name.trim_end_matches(']').trim().to_ascii_uppercase();
            continue;
        }
        let Some((key, value)) = text.split_once('=') else { continue };
        let (key, value) = (key.trim().to_ascii_uppercase(), value.trim());
        if section == "TRAJ" && key == "LINEAR_UNITS" {
            contents.unit = match value.to_ascii_lowercase().as_str() {
                "mm" | "metric" => Some(Unit::Mm),
                "inch" | "in" | "imperial" => Some(Unit::Inch),
                _ => return Err(TableError { line, message: format!("`{value}` is neither mm nor inch") }),
            };
        }
        let axis = section.strip_prefix("AXIS_").filter(|name| name.len() == 1);
        let Some(axis) = axis.and_then(|name| Axis::of(name.as_bytes()[0])) else { continue };
        let side = match key.as_str() {
            "MIN_LIMIT" => 0,
            "MAX_LIMIT" => 1,
            _ => continue,
        };
        // What stands behind the number is a remark.
        let word = value.split_whitespace().next().unwrap_or_default();
        let limit = signed(word).or_else(|| word.parse().ok()).filter(|limit: &f64| limit.is_finite());
        let limit = limit.ok_or_else(|| TableError { line, message: format!("`{value}` is no number") })?;
        contents.limits.entry(axis).or_insert([None; 2])[side] = Some(limit);
    }
    let mm = contents.unit.unwrap_or_default().mm();
    for (axis, limits) in &mut contents.limits {
        for limit in limits.iter_mut().flatten().filter(|_| !axis.is_rotary()) {
            *limit *= mm;
        }
    }
    Ok(contents)
}
