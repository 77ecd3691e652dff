//! Point tables: `SEL PATTERN "NAME.PNT"` reads the places at which CYCL CALL PAT runs the machining cycle.
//!
//! `BEGIN NAME.PNT MM`, a header whose words stand above their columns, one place a line, `[END]`. Source: K 4.6
//! (docs/sources.md).

use crate::diag::codes;
use crate::geo::Point2;
use crate::machine::Axis;
use crate::machine::table::TableError;
use crate::machine::table::columns::{Columns, Row, signed, unit_of};
use crate::sema::run::{Wanted, Where, open_program};
use crate::text::decode::readable_lines;
use crate::text::{FileId, Loc, Sources, Within};

use super::pattern_def::{Place, Places};
use super::reading::Reading;
use super::{Outcome, Reported};

/// Largest table, bytes.
const LARGEST: u64 = 16 << 20;

/// SEL PATTERN: the places come from a table, which is read at once. `written` is its name.
pub(super) fn select(reading: Reading<'_, '_>, written: &[u8]) -> Outcome<Places> {
    let core = reading.core;
    let name = reading.program_name(written)?;
    let here = core.here.origin;
    let wanted = Wanted { name: &name, extensions: &["PNT", "pnt"], within: Within::Caller };
    let file = open_program(&core.job, &wanted, here.loc, here.call).ok_or(Reported)?;
    let (first, second, third) = reading.st.plane().axes();
    let letters = [first, second, third].map(|axis| Axis::ALL[axis].letter());
    let text = whole_file(core.job.sources, file).map_err(|what| TableError { line: 1, message: what.to_owned() });
    text.and_then(|text| read(&text, letters, here.loc)).or_else(|TableError { line, message }| {
        core.refuse(Where::Block, codes::K2945::line_of_point_table(&line, &name, &message))
    })
}

/// The text of a table that a program names.
pub(super) fn whole_file(sources: &Sources, file: FileId) -> Result<String, &'static str> {
    if sources.size(file) > LARGEST {
        return Err("the file is larger than 16 MB");
    }
    let mut bytes = vec![0; sources.size(file) as usize];
    let mut at = 0;
    while at < bytes.len() {
        match sources.read_at(file, at as u64, &mut bytes[at..]) {
            Ok(read) if read > 0 => at += read,
            _ => return Err("the file cannot be read"),
        }
    }
    Ok(String::from_utf8(bytes).unwrap_or_else(|error| readable_lines(error.as_bytes())))
}

/// The places of a table, for a plane with these axes.
fn read(text: &str, axes: [char; 3], loc: Loc) -> Result<Places, TableError> {
    let fail = |line: usize, message: &str| TableError { line, message: message.to_owned() };
    if unit_of(text).is_none() {
        return Err(fail(1, "it does not begin with BEGIN, its name, and MM or INCH"));
    }
    let table = Columns::read(text, |title| title == "DOC")?;
    if let Some(axis) = axes[..2].iter().find(|axis| !table.has(&axis.to_string())) {
        return Err(fail(2, &format!("the column {axis} is missing")));
    }
    if !table.ended {
        return Err(fail(text.lines().count(), "[END] is missing, so the table may be cut off"));
    }
    let mut list = Vec::new();
    for row in &table.rows {
        list.extend(place(&table, row, axes)?);
    }
    Ok(Places::of_table(list, loc))
}

/// A place; nothing where FADE leaves it out.
fn place(table: &Columns, row: &Row, axes: [char; 3]) -> Result<Option<Place>, TableError> {
    let fail = |message: String| TableError { line: row.line, message };
    for title in table.titles() {
        let known = ["NR", "FADE", "CLEARANCE", "DOC"].contains(&title);
        let axis = axes.iter().any(|axis| title.chars().eq([*axis]));
        if !known && !axis && table.cell(row, title).is_some_and(|text| signed(text) != Some(0.0)) {
            return Err(fail(format!("a value under {title}, which is not known")));
        }
    }
    match table.cell(row, "FADE").map(str::to_ascii_uppercase).as_deref() {
        None | Some("N" | "0") => {}
        Some("Y" | "1" | "J") => return Ok(None),
        Some(other) => return Err(fail(format!("FADE is `{other}` in place of Y or N"))),
    }
    let length = |axis: char| table.length(row, &axis.to_string());
    let needed = |axis: char| length(axis)?.ok_or_else(|| fail(format!("the place has no {axis}")));
    Ok(Some(Place {
        at: Point2::new(needed(axes[0])?, needed(axes[1])?),
        surface: length(axes[2])?.unwrap_or(0.0),
        clearance: table.length(row, "CLEARANCE")?,
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &str = "BEGIN HOLES.PNT MM\n\
        NR    X         Y         Z         FADE  CLEARANCE\n\
        0     +10       +20,5     +0        N     +30\n\
        1     +30       -5        -2        Y\n\
        2     +50       +0\n\
        [END]\n";

    #[test]
    fn places_of_a_table() {
        let places = read(TABLE, ['X', 'Y', 'Z'], Loc::default()).unwrap();
        let made: Vec<_> = places.iter().map(|p| (p.at.x, p.at.y, p.surface, p.clearance)).collect();
        assert_eq!(made, [(10.0, 20.5, 0.0, Some(30.0)), (50.0, 0.0, 0.0, None)]);
        let inch = TABLE.replace(" MM", " INCH");
        assert_eq!(read(&inch, ['X', 'Y', 'Z'], Loc::default()).unwrap().iter().next().unwrap().at.x, 254.0);
    }

    #[test]
    fn tables_that_say_something_else_are_refused() {
        let wrong = |text: &str| read(text, ['X', 'Y', 'Z'], Loc::default()).unwrap_err();
        assert_eq!(wrong(&TABLE.replace("[END]", "")).line, 6);
        assert_eq!(wrong(&TABLE.replace("BEGIN", "TABLE")).line, 1);
        assert_eq!(wrong(&TABLE.replace("+20,5", "abc  ")).message, "`abc` under Y is no number");
        assert_eq!(wrong(&TABLE.replace(" Y  ", " B  ")).message, "the column Y is missing");
        assert_eq!(wrong(&format!("{TABLE}3 +60 +0\n")).message, "it stands after [END]");
    }

    #[test]
    fn words_beside_their_columns_are_counted_or_refused() {
        let first = |head: &str, row: &str| {
            let text = format!("BEGIN B.PNT MM\n{head}\n{row}\n[END]\n");
            read(&text, ['X', 'Y', 'Z'], Loc::default()).map(|list| {
                let place = list.iter().next().expect("one place");
                (place.at.x, place.at.y, place.surface)
            })
        };
        assert_eq!(first("NR X Y Z", "0 10 20 30"), Ok((10.0, 20.0, 30.0)));
        assert_eq!(first("NR X Y Z", "0 1 2 3"), Ok((1.0, 2.0, 3.0)));
        assert_eq!(first("NR    X    Y   Z", "0   10   20  30"), Ok((10.0, 20.0, 30.0)));
        assert_eq!(first("NR    X      Y      Z DOC", "0     1      2        left hole"), Ok((1.0, 2.0, 0.0)));
        assert!(first("NR    X    Y   Z", "0  100.5   200.5").is_err());
    }
}
