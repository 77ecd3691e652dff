//! Point tables: `SEL PATTERN "NAME.PNT"` reads the places at which CYCL CALL PAT runs the machining cycle.
//!
//! `BEGIN NAME.PNT MM`, a header whose words stand above their columns, one place a line, `[END]`. Source: K 4.6
//! (docs/sources.md).

use crate::diag::{Diagnostic, codes};
use crate::geo::Point2;
use crate::machine::Axis;
use crate::parser::klartext::ast::Block;
use crate::sema::run::open_program;
use crate::text::{Loc, Span, number::decimal};

use super::pattern_def::{Place, Places};
use super::{Outcome, Reported, Run};

/// Largest table, bytes.
const LARGEST: u64 = 16 << 20;

/// A table that cannot be read: the line, and what is wrong with it.
#[derive(Debug, PartialEq)]
struct Wrong {
    line: u32,
    what: String,
}

impl Run<'_> {
    /// SEL PATTERN: the places come from a table, which is read at once.
    pub(super) fn select_pattern(&mut self, block: &Block, text: &[u8], name_from: u32) -> Outcome {
        self.places = None;
        self.places_lost = true;
        let written = Span { start: name_from, end: block.span.end }.of(text);
        let name = self.program_name(written)?;
        let here = self.here.origin;
        let Some(file) = open_program(&self.job, &name, &["PNT", "pnt"], here.loc, here.call) else {
            return Err(Reported);
        };
        let (sources, wrong) = (self.job.sources, |run: &Self, line: u32, what: String| {
            run.report(
                Diagnostic::new(codes::K2945, here.loc, format!("line {line} of the point table `{name}`: {what}"))
                    .help(
                        "a table has `BEGIN NAME.PNT MM`, a line with the names of its columns, and one place a line",
                    ),
            );
            Err(Reported)
        });
        if sources.size(file) > LARGEST {
            return wrong(self, 1, "the file is larger than 16 MB".to_owned());
        }
        let mut bytes = vec![0; sources.size(file) as usize];
        let mut at = 0;
        while at < bytes.len() {
            match sources.read_at(file, at as u64, &mut bytes[at..]) {
                Ok(read) if read > 0 => at += read,
                _ => return wrong(self, 1, "the file cannot be read".to_owned()),
            }
        }
        let (first, second, third) = self.st.plane().axes();
        let letters = [first, second, third].map(|axis| Axis::ALL[axis].letter());
        let text = String::from_utf8_lossy(&bytes);
        match read(text.trim_start_matches('\u{feff}'), letters, here.loc) {
            Ok(places) => {
                self.places = Some(places);
                self.places_lost = false;
                Ok(())
            }
            Err(Wrong { line, what }) => wrong(self, line, what),
        }
    }
}

/// The places of a table, for a plane with these axes.
fn read(text: &str, axes: [char; 3], loc: Loc) -> Result<Places, Wrong> {
    let mut columns: Option<Vec<(String, usize)>> = None;
    let mut mm = None;
    let mut list = Vec::new();
    let mut ended = false;
    for (line, text) in (1..).zip(text.lines()) {
        let fail = |what: String| Wrong { line, what };
        let upper = text.trim().to_ascii_uppercase();
        if upper.is_empty() {
            continue;
        }
        let Some(mm) = mm else {
            mm = Some(
                unit(&upper).ok_or_else(|| fail("it does not begin with BEGIN, its name, and MM or INCH".into()))?,
            );
            continue;
        };
        if ended {
            return Err(fail("it stands behind [END]".into()));
        }
        if upper.starts_with("[END]") {
            ended = true;
            continue;
        }
        let Some(known) = &columns else {
            columns = Some(header(text, axes).map_err(fail)?);
            continue;
        };
        if let Some(place) = row(text, known, axes, mm).map_err(fail)? {
            list.push(place);
        }
    }
    if ended {
        return Ok(Places::of_table(list, loc));
    }
    let line = text.lines().count() as u32;
    Err(Wrong { line, what: "[END] is missing, so the table may be cut off".to_owned() })
}

/// Millimetres in the unit of `BEGIN NAME.PNT MM`.
fn unit(head: &str) -> Option<f64> {
    let mut words = head.split_ascii_whitespace();
    let begins = words.next() == Some("BEGIN");
    match words.next_back() {
        Some("MM") if begins => Some(1.0),
        Some("INCH") if begins => Some(25.4),
        _ => None,
    }
}

/// The columns and where they begin.
fn header(line: &str, axes: [char; 3]) -> Result<Vec<(String, usize)>, String> {
    let mut columns = Vec::new();
    let mut at = 0;
    for word in line.split_inclusive(char::is_whitespace) {
        if !word.trim().is_empty() {
            columns.push((word.trim().to_ascii_uppercase(), at));
        }
        at += word.len();
    }
    let has = |name: &str| columns.iter().any(|(title, _)| title == name);
    match axes[..2].iter().find(|axis| !has(&axis.to_string())) {
        Some(axis) => Err(format!("the column {axis} is missing")),
        None => Ok(columns),
    }
}

/// The words of a line by their columns: each stands under its name, or there are as many words as names.
fn fields<'t>(line: &'t str, columns: &[(String, usize)]) -> Result<Vec<Option<&'t str>>, String> {
    let mut by_place: Vec<Option<&str>> = vec![None; columns.len()];
    let mut beside = None;
    let mut words = Vec::new();
    let mut at = 0;
    for piece in line.split_inclusive(char::is_whitespace) {
        let (word, from) = (piece.trim_end(), at);
        at += piece.len();
        if word.is_empty() {
            continue;
        }
        words.push(word);
        let end = from + word.len();
        let column = columns.iter().rposition(|(_, begin)| *begin <= from);
        let border = column.and_then(|column| columns.get(column + 1)).map_or(line.len(), |next| next.1);
        match column {
            // A remark is any number of words.
            Some(column) if columns[column].0 == "DOC" && end <= border => {}
            Some(column) if by_place[column].is_none() && end <= border => by_place[column] = Some(word),
            _ => beside = beside.or(Some(word)),
        }
    }
    match beside {
        None => Ok(by_place),
        Some(_) if words.len() == columns.len() => Ok(words.into_iter().map(Some).collect()),
        Some(word) => Err(format!("`{word}` does not stand under the name of one column")),
    }
}

/// A place; nothing where FADE leaves it out.
fn row(line: &str, columns: &[(String, usize)], axes: [char; 3], mm: f64) -> Result<Option<Place>, String> {
    let fields = fields(line, columns)?;
    let field = |title: &str| -> Option<&str> {
        let at = columns.iter().position(|(name, _)| name == title)?;
        fields.get(at).copied().flatten().filter(|text| *text != "-")
    };
    let length = |title: &str| match field(title) {
        None => Ok(None),
        Some(text) => {
            signed(text).map(|value| Some(value * mm)).ok_or_else(|| format!("`{text}` under {title} is no number"))
        }
    };
    for (title, _) in columns {
        let known = ["NR", "FADE", "CLEARANCE", "DOC"].contains(&title.as_str());
        let axis = axes.iter().any(|axis| title.chars().eq([*axis]));
        if !known && !axis && field(title).is_some_and(|text| signed(text) != Some(0.0)) {
            return Err(format!("a value under {title}, which is not known"));
        }
    }
    match field("FADE").map(str::to_ascii_uppercase).as_deref() {
        None | Some("N" | "0") => {}
        Some("Y" | "1" | "J") => return Ok(None),
        Some(other) => return Err(format!("FADE is `{other}` in place of Y or N")),
    }
    let needed = |axis: char| length(&axis.to_string())?.ok_or_else(|| format!("the place has no {axis}"));
    Ok(Some(Place {
        at: Point2::new(needed(axes[0])?, needed(axes[1])?),
        surface: length(&axes[2].to_string())?.unwrap_or(0.0),
        clearance: length("CLEARANCE")?,
    }))
}

fn signed(text: &str) -> Option<f64> {
    let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
    let (value, used) = decimal(digits.as_bytes(), true)?;
    (used == digits.len()).then_some(if text.starts_with('-') { -value } else { value })
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
        assert_eq!(wrong(&TABLE.replace("+20,5", "abc  ")).what, "`abc` under Y is no number");
        assert_eq!(wrong(&TABLE.replace(" Y  ", " B  ")).what, "the column Y is missing");
        assert_eq!(wrong(&format!("{TABLE}3 +60 +0\n")).what, "it stands behind [END]");
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
