//! Tables of HEIDENHAIN controls: `BEGIN NAME.EXT MM`, a header whose words stand above their columns, a row a line, `[END]`.

use crate::machine::Unit;
use crate::text::number::decimal;

use super::TableError;

/// A table whose rows point into its text.
#[derive(Debug)]
pub struct Columns<'t> {
    /// What stands between BEGIN and the unit, in capitals and without blanks: `TOOL.T`.
    pub name: String,
    pub unit: Option<Unit>,
    titles: Vec<Title>,
    pub rows: Vec<Row<'t>>,
    /// Does `[END]` stand behind the rows?
    pub ended: bool,
}

/// A column title and where it begins, in characters.
#[derive(Debug)]
struct Title {
    name: String,
    from: usize,
    is_text: bool,
}

#[derive(Debug)]
pub struct Row<'t> {
    pub line: usize,
    cells: Vec<Option<&'t str>>,
}

impl<'t> Columns<'t> {
    /// Reads a table; `is_text` tells columns whose cells are any number of words.
    ///
    /// # Errors
    /// A word that stands under no column, or rows behind `[END]`.
    pub fn read(text: &'t str, is_text: impl Fn(&str) -> bool) -> Result<Columns<'t>, TableError> {
        let mut table = Columns { name: String::new(), unit: None, titles: Vec::new(), rows: Vec::new(), ended: false };
        for (line, text) in (1..).zip(text.trim_start_matches('\u{feff}').lines()) {
            let upper = text.trim().to_ascii_uppercase();
            if upper.is_empty() || upper.starts_with([';', '#']) {
                continue;
            }
            if table.ended {
                return Err(TableError { line, message: "it stands after [END]".to_owned() });
            }
            if upper.starts_with("[END]") {
                table.ended = true;
            } else if table.titles.is_empty() && upper.split_whitespace().next() == Some("BEGIN") {
                (table.name, table.unit) = head(&upper);
            } else if table.titles.is_empty() {
                table.titles = titles(text, &is_text);
            } else {
                let cells = table.cells(text).map_err(|message| TableError { line, message })?;
                table.rows.push(Row { line, cells });
            }
        }
        Ok(table)
    }

    pub fn has(&self, title: &str) -> bool {
        self.titles.iter().any(|known| known.name == title)
    }

    pub fn titles(&self) -> impl Iterator<Item = &str> {
        self.titles.iter().map(|title| title.name.as_str())
    }

    /// What a row has under a title; nothing for `-`.
    pub fn cell(&self, row: &Row<'t>, title: &str) -> Option<&'t str> {
        let at = self.titles.iter().position(|known| known.name == title)?;
        row.cells[at].filter(|text| *text != "-")
    }

    /// The number that a row has under a title.
    ///
    /// # Errors
    /// Something that is no number.
    pub fn number(&self, row: &Row<'t>, title: &str) -> Result<Option<f64>, TableError> {
        let Some(text) = self.cell(row, title) else { return Ok(None) };
        let fail = || TableError { line: row.line, message: format!("`{text}` under {title} is no number") };
        signed(text).map(Some).ok_or_else(fail)
    }

    /// The length that a row has under a title, in mm.
    ///
    /// # Errors
    /// Something that is no number.
    pub fn length(&self, row: &Row<'t>, title: &str) -> Result<Option<f64>, TableError> {
        Ok(self.number(row, title)?.map(|value| value * self.unit.unwrap_or_default().mm()))
    }

    /// The words of a line by their columns. Columns may be counted in letters or in bytes.
    fn cells<'l>(&self, line: &'l str) -> Result<Vec<Option<&'l str>>, String> {
        let letters = self.cells_by(line, |piece| piece.chars().count());
        if line.is_ascii() {
            return letters;
        }
        match (letters, self.cells_by(line, str::len)) {
            (Ok(letters), Ok(bytes)) if letters == bytes => Ok(letters),
            (Ok(_), Ok(_)) => {
                Err("letters beyond ASCII make it uncertain which value stands under which name".to_owned())
            }
            (letters, bytes) => letters.or(bytes),
        }
    }

    /// Each word stands under its name, or there are as many words as names.
    fn cells_by<'l>(&self, line: &'l str, width: impl Fn(&str) -> usize) -> Result<Vec<Option<&'l str>>, String> {
        let mut spans: Vec<Option<(usize, usize)>> = vec![None; self.titles.len()];
        let mut beside = None;
        let mut words = Vec::new();
        let (mut from, mut at) = (0, 0);
        for piece in line.split_inclusive(char::is_whitespace) {
            let word = piece.trim_end();
            let (begin, start) = (from, at);
            from += width(piece);
            at += piece.len();
            if word.is_empty() {
                continue;
            }
            words.push(word);
            let end = begin + width(word);
            let column = self.titles.iter().rposition(|title| title.from <= begin);
            let border = column.and_then(|column| self.titles.get(column + 1)).map_or(usize::MAX, |next| next.from);
            let span = column.filter(|_| end <= border).map(|column| (&mut spans[column], self.titles[column].is_text));
            match span {
                Some((Some(cell), true)) => cell.1 = start + word.len(),
                Some((cell @ None, _)) => *cell = Some((start, start + word.len())),
                _ => beside = beside.or(Some(word)),
            }
        }
        match beside {
            None => Ok(spans.iter().map(|span| span.map(|(from, to)| &line[from..to])).collect()),
            Some(_) if words.len() == self.titles.len() => Ok(words.into_iter().map(Some).collect()),
            Some(word) => Err(format!("`{word}` does not stand under the name of one column")),
        }
    }
}

/// The unit behind BEGIN in the first line of a table.
pub fn unit_of(text: &str) -> Option<Unit> {
    let first = text.trim_start_matches('\u{feff}').lines().find(|line| !line.trim().is_empty())?.to_ascii_uppercase();
    (first.split_whitespace().next() == Some("BEGIN")).then(|| head(&first).1)?
}

/// `BEGIN TOOL    .T MM`: its name and unit.
fn head(upper: &str) -> (String, Option<Unit>) {
    let mut words: Vec<&str> = upper.split_whitespace().skip(1).collect();
    let unit = match words.last() {
        Some(&"MM") => Some(Unit::Mm),
        Some(&"INCH") => Some(Unit::Inch),
        _ => None,
    };
    if unit.is_some() {
        words.pop();
    }
    (words.concat(), unit)
}

fn titles(line: &str, is_text: &impl Fn(&str) -> bool) -> Vec<Title> {
    let mut titles = Vec::new();
    let mut from = 0;
    for piece in line.split_inclusive(char::is_whitespace) {
        let name = piece.trim().to_ascii_uppercase();
        if !name.is_empty() {
            titles.push(Title { is_text: is_text(&name), name, from });
        }
        from += piece.chars().count();
    }
    titles
}

/// A number with its sign; a decimal comma is one.
pub fn signed(text: &str) -> Option<f64> {
    let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
    let (value, used) = decimal(digits.as_bytes(), true)?;
    (used == digits.len()).then_some(if text.starts_with('-') { -value } else { value })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_stand_under_their_titles() {
        let read = |text| Columns::read(text, |title| title == "DOC");
        let table = read("BEGIN A  .D INCH\nNR    X      Y      DOC\n0     1,5    -      left hole\n[END]\n").unwrap();
        assert_eq!((table.name.as_str(), table.unit, table.ended), ("A.D", Some(Unit::Inch), true));
        let row = &table.rows[0];
        assert_eq!(table.length(row, "X").unwrap().map(|x| (x * 10.0).round()), Some(381.0));
        assert_eq!((table.number(row, "Y").unwrap(), table.cell(row, "DOC")), (None, Some("left hole")));
        // As many words as titles need no columns.
        let table = read("BEGIN A.D MM\nNR X Y Z\n0 10 20 30\n").unwrap();
        assert_eq!(table.number(&table.rows[0], "Z").unwrap(), Some(30.0));
        assert!(read("BEGIN A.D MM\nNR    X    Y   Z\n0  100.5   200.5\n").is_err());
        assert!(read("BEGIN A.D MM\nNR X\n[END]\n0 1\n").is_err());
    }

    #[test]
    fn letters_of_several_bytes_move_no_column() {
        let text = "BEGIN TOOL.T MM\nT    NAME        L    R\n1    FRÄSER GÄNZ +50  +5\n";
        let table = Columns::read(text, |title| title == "NAME").unwrap();
        let row = &table.rows[0];
        assert_eq!((table.cell(row, "NAME"), table.number(row, "R").unwrap()), (Some("FRÄSER GÄNZ"), Some(5.0)));
    }
}
