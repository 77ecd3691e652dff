//! Tool data as values between commas or semicolons; the first line names the columns.

use crate::machine::tools::Corner;
use crate::machine::{Tool, ToolKey, Unit};

use super::columns::signed;
use super::{Contents, Kind, TableError, tool_number};

/// Titles of the columns. `diameter` may stand for `radius`.
pub const TITLES: &[&str] = &[
    "number",
    "name",
    "kind",
    "unit",
    "radius",
    "length",
    "corner_radius",
    "tip_angle",
    "plunge_angle",
    "teeth",
    "delta_length",
    "delta_radius",
    "delta_corner",
    "orientation",
    "clearance",
    "width",
    "reference",
    "printed",
];

/// Is this the first line of such a table?
pub(super) fn begins(line: &str) -> bool {
    let Ok(titles) = cells(line, separator(line)) else { return false };
    titles.len() > 1 && titles.iter().any(|title| matches!(title.to_ascii_lowercase().as_str(), "number" | "name"))
}

fn separator(line: &str) -> char {
    if line.contains(';') { ';' } else { ',' }
}

/// # Errors
/// Unknown columns, rows of another length, and values that do not fit.
pub(super) fn read(text: &str) -> Result<Contents, TableError> {
    let mut contents = Contents { kind: Kind::Csv, ..Contents::default() };
    let mut lines = (1..).zip(text.trim_start_matches('\u{feff}').lines()).filter(|(_, line)| !line.trim().is_empty());
    let Some((line, head)) = lines.next() else { return Ok(contents) };
    let separator = separator(head);
    let of_line = |line: usize, text: &str| cells(text, separator).map_err(|message| TableError { line, message });
    let titles: Vec<String> = of_line(line, head)?.iter().map(|title| title.to_ascii_lowercase()).collect();
    if let Some(title) = titles.iter().find(|title| !TITLES.contains(&title.as_str()) && *title != "diameter") {
        let message = format!("`{title}` is no column; there are {}", TITLES.join(", "));
        return Err(TableError { line, message });
    }
    if let Some(twice) = titles.iter().enumerate().find(|(at, title)| titles[..*at].contains(title)) {
        return Err(TableError { line, message: format!("the column `{}` stands twice", twice.1) });
    }
    for (line, row) in lines {
        let row = of_line(line, row)?;
        if row.len() != titles.len() {
            let message = format!("{} values where there are {} columns", row.len(), titles.len());
            return Err(TableError { line, message });
        }
        let (key, tool, unit) = tool(&titles, &row, separator).map_err(|message| TableError { line, message })?;
        if contents.unit.is_some_and(|before| Some(before) != unit)
            || !contents.tools.is_empty() && contents.unit != unit
        {
            return Err(TableError { line, message: "the rows have several units".to_owned() });
        }
        contents.unit = unit;
        if contents.tools.insert(key, tool).is_some() {
            return Err(TableError { line, message: "this tool stands twice in the table".to_owned() });
        }
    }
    Ok(contents)
}

fn tool(titles: &[String], row: &[String], separator: char) -> Result<(ToolKey, Tool, Option<Unit>), String> {
    let cell = |title: &str| {
        let at = titles.iter().position(|known| known == title)?;
        Some(row[at].as_str()).filter(|text| !text.is_empty())
    };
    let unit = match cell("unit").map(str::to_ascii_lowercase).as_deref() {
        None => None,
        Some("mm") => Some(Unit::Mm),
        Some("inch") => Some(Unit::Inch),
        Some(other) => return Err(format!("the unit `{other}` is neither mm nor inch")),
    };
    let number = |title: &str| match cell(title) {
        None => Ok(None),
        // Thousands or a decimal place: 1,500 may be either.
        Some(text) if separator == ',' && text.contains(',') => {
            Err(format!("`{text}` under {title} holds a comma, which separates columns here; write a decimal point"))
        }
        Some(text) => signed(text).map(Some).ok_or_else(|| format!("`{text}` under {title} is no number")),
    };
    let length = |title: &str| Ok::<_, String>(number(title)?.map(|value| value * unit.unwrap_or_default().mm()));
    let name = cell("name").map(str::to_owned);
    let key = match (cell("number"), &name) {
        (Some(text), _) => {
            let (number, index) = tool_number(text).ok_or_else(|| format!("`{text}` is no tool number"))?;
            ToolKey::Number(number, index)
        }
        (None, Some(name)) => ToolKey::Name(name.clone()),
        (None, None) => return Err("the tool has neither a number nor a name".to_owned()),
    };
    let kind = cell("kind").map(str::to_owned);
    const KINDS: [&str; 7] = ["mill", "drill", "tap", "turn", "thread", "recess-radial", "recess-axial"];
    if let Some(kind) = kind.as_deref().filter(|kind| !KINDS.contains(kind)) {
        return Err(format!("`{kind}` is no kind of tool; there are {}", KINDS.join(", ")));
    }
    let small = |title: &str, most: f64| match number(title)? {
        None => Ok(None),
        Some(value) if value.fract() == 0.0 && (1.0..=most).contains(&value) => Ok(Some(value)),
        Some(value) => Err(format!("{value} under {title} does not lie between 1 and {most}")),
    };
    let radius = match (length("radius")?, length("diameter")?) {
        (Some(radius), Some(diameter)) if (2.0 * radius - diameter).abs() > 1e-6 => {
            return Err(format!("radius {radius} and diameter {diameter} contradict each other"));
        }
        (radius, diameter) => radius.or(diameter.map(|diameter| diameter / 2.0)),
    };
    let tool = Tool {
        number: small("printed", 99_999_999.0)?.map(|value| value as u32),
        name,
        kind,
        radius,
        length: length("length")?,
        corner_radius: length("corner_radius")?,
        tip_angle: number("tip_angle")?,
        plunge_angle: number("plunge_angle")?,
        teeth: small("teeth", 99.0)?.map(|value| value as u8),
        deltas: [
            length("delta_length")?.unwrap_or(0.0),
            length("delta_radius")?.unwrap_or(0.0),
            length("delta_corner")?.unwrap_or(0.0),
        ],
        orientation: small("orientation", 9.0)?.map(|value| value as u8),
        clearance: number("clearance")?,
        width: length("width")?,
        reference: match cell("reference") {
            None | Some("minus") => Corner::Minus,
            Some("plus") => Corner::Plus,
            Some("middle") => Corner::Middle,
            Some(other) => return Err(format!("`{other}` is no corner; there are minus, plus, middle")),
        },
    };
    Ok((key, tool, unit))
}

/// Values of a line; quotes may hold separators, a double quote is one.
fn cells(line: &str, separator: char) -> Result<Vec<String>, String> {
    let mut cells = vec![String::new()];
    let mut quoted = false;
    let mut letters = line.chars().peekable();
    while let Some(c) = letters.next() {
        let last = cells.len() - 1;
        match c {
            '"' if quoted && letters.peek() == Some(&'"') => {
                letters.next();
                cells[last].push('"');
            }
            '"' => quoted = !quoted,
            c if c == separator && !quoted => cells.push(String::new()),
            c => cells[last].push(c),
        }
    }
    if quoted {
        return Err("a quote has no end".to_owned());
    }
    Ok(cells.iter().map(|cell| cell.trim().to_owned()).collect())
}
