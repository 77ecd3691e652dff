//! Tool data, from the program's surroundings: `[tools]`, a HEIDENHAIN `TOOL.T` or a LinuxCNC `tool.tbl`.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use crate::diag::{Answer, Help};
use crate::text::number::decimal;

/// How a tool is asked for.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum ToolKey {
    /// Number and index (`5.2` is 5, 2).
    Number(u32, u8),
    Name(String),
}

impl fmt::Display for ToolKey {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ToolKey::Number(n, 0) => write!(f, "{n}"),
            ToolKey::Number(n, index) => write!(f, "{n}.{index}"),
            ToolKey::Name(name) => write!(f, "\"{name}\""),
        }
    }
}

/// A corner of a recessing tool, seen along the axis of its width.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Corner {
    /// Towards -Z, for axial tools towards -X.
    #[default]
    Minus,
    Plus,
    Middle,
}

/// Data of one tool; lengths in mm. `None` is "not known", which is not zero.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Tool {
    /// Number to print, where it is not the one of the key.
    pub number: Option<u32>,
    pub name: Option<String>,
    pub kind: Option<String>,
    /// Cutter radius; nose radius of turning and recessing tools.
    pub radius: Option<f64>,
    pub length: Option<f64>,
    pub corner_radius: Option<f64>,
    /// Angle at the tip of a drill, degrees.
    pub tip_angle: Option<f64>,
    /// Greatest angle at which a cutter goes down into material, degrees.
    pub plunge_angle: Option<f64>,
    /// Wear or oversize of length, radius and corner radius in the table.
    pub deltas: [f64; 3],
    /// Cutting-edge position 1 to 9.
    pub orientation: Option<u8>,
    /// Angle between the flank of a turning tool and the way of its cuts, degrees.
    pub clearance: Option<f64>,
    /// Cutting width of recessing tools.
    pub width: Option<f64>,
    /// Corner of a recessing tool that is programmed.
    pub reference: Corner,
}

/// The known tools.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Tools {
    pub table: BTreeMap<ToolKey, Tool>,
    /// A tool table was given, so a tool that is not in it is worth a word.
    pub complete: bool,
}

impl Tools {
    pub fn by_number(&self, number: u32, index: u8) -> Option<&Tool> {
        self.table.get(&ToolKey::Number(number, index))
    }

    /// The tool of this name and its number; one that differs in upper and lower case only if there is no other.
    pub fn by_name(&self, name: &str) -> Option<(Option<u32>, &Tool)> {
        self.named(|other| other == name).or_else(|| self.named(|other| other.eq_ignore_ascii_case(name)))
    }

    /// The tool of exactly this name and its number.
    pub fn by_exact_name(&self, name: &str) -> Option<(Option<u32>, &Tool)> {
        self.named(|other| other == name)
    }

    /// A name that differs from `name` in nothing but case, blanks, `_` and `-`. Anything else would be another tool.
    pub fn alike(&self, name: &str) -> Option<&str> {
        let bare = |name: &str| -> String {
            name.chars().filter(|c| !matches!(c, ' ' | '_' | '-')).flat_map(char::to_lowercase).collect()
        };
        let wanted = bare(name);
        let names = self.table.iter().filter_map(|(key, tool)| match key {
            ToolKey::Name(name) => Some(name.as_str()),
            ToolKey::Number(..) => tool.name.as_deref(),
        });
        names.into_iter().find(|other| bare(other) == wanted && *other != name)
    }

    /// Is the number given to a tool, as its key or to print?
    fn is_taken(&self, number: u32) -> bool {
        self.table
            .iter()
            .any(|(key, tool)| tool.number == Some(number) || matches!(key, ToolKey::Number(n, _) if *n == number))
    }

    /// Radius of the tool that is printed as `number`; `None` if it is not known, or edges of it differ.
    pub fn radius_of_printed(&self, number: u32) -> Option<f64> {
        let mut radii = self.table.iter().filter_map(|(key, tool)| match (key, tool.number) {
            (_, Some(printed)) => (printed == number).then_some(tool),
            (ToolKey::Number(own, _), None) => (*own == number).then_some(tool),
            (ToolKey::Name(_), None) => None,
        });
        let radius = |tool: &Tool| tool.radius.map(|radius| radius + tool.deltas[1]);
        let first = radii.next().and_then(radius)?;
        radii.all(|tool| radius(tool) == Some(first)).then_some(first)
    }

    fn named(&self, is_it: impl Fn(&str) -> bool) -> Option<(Option<u32>, &Tool)> {
        self.table.iter().find_map(|(key, tool)| match key {
            ToolKey::Name(n) if is_it(n) => Some((tool.number, tool)),
            ToolKey::Number(n, 0) if tool.name.as_deref().is_some_and(&is_it) => {
                Some((Some(tool.number.unwrap_or(*n)), tool))
            }
            _ => None,
        })
    }
}

/// Numbers proposed for tools that the program calls by a name without a number.
#[derive(Debug, Clone, Default)]
pub struct Proposed {
    names: Vec<(String, u32)>,
    /// Numbers that the program called.
    called: BTreeSet<u32>,
}

impl Proposed {
    /// The program called this number: it is no free one.
    pub fn call(&mut self, number: u32) {
        self.called.insert(number);
    }

    /// What to put into the configuration for the tool `name`: each name gets a number of its own.
    pub fn help(&mut self, name: &str, tools: &Tools) -> Help {
        let known = self.names.iter().find(|(known, _)| known == name).map(|(_, number)| *number);
        let number = known.unwrap_or_else(|| {
            let free = |n: &u32| {
                !tools.is_taken(*n) && !self.called.contains(n) && !self.names.iter().any(|(_, given)| given == n)
            };
            let number = (1..).find(free).unwrap_or(1);
            self.names.push((name.to_owned(), number));
            number
        });
        let escaped = name.replace('\\', "\\\\").replace('"', "\\\"");
        let line = format!("give it a number in partc.toml: `[tools.{number}]` with `name = \"{escaped}\"`");
        Answer::tool(number, "name").one_of(&[format!("\"{escaped}\"")]).help(match tools.alike(name) {
            Some(alike) => format!("{line}; the table has a tool `{alike}`, whose name is written differently"),
            None => line,
        })
    }
}

/// A tool table that cannot be read: the line and what is wrong with it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TableError {
    pub line: usize,
    pub message: String,
}

/// Reads a HEIDENHAIN `TOOL.T` or a LinuxCNC `tool.tbl`; the content tells which.
///
/// # Errors
/// A line that is neither.
pub fn read_table(text: &str) -> Result<BTreeMap<ToolKey, Tool>, TableError> {
    let first = text.lines().find(|line| !line.trim().is_empty()).unwrap_or_default();
    let columns = text.lines().find(|line| column_start(line, "T").is_some() && column_start(line, "L").is_some());
    if first.trim_start().to_ascii_uppercase().starts_with("BEGIN") || columns.is_some() {
        read_tool_t(text)
    } else {
        read_tool_tbl(text)
    }
}

/// Start of the column with this title in a header line.
fn column_start(header: &str, title: &str) -> Option<usize> {
    let mut at = 0;
    for word in header.split_inclusive(char::is_whitespace) {
        if word.trim().eq_ignore_ascii_case(title) {
            return Some(at);
        }
        at += word.len();
    }
    None
}

/// `TOOL.T`: `BEGIN TOOL .T MM`, a header whose words stand above their columns, one tool a line, `[END]`.
fn read_tool_t(text: &str) -> Result<BTreeMap<ToolKey, Tool>, TableError> {
    let mut table = BTreeMap::new();
    let mut inch = false;
    let mut columns: Option<Vec<(String, usize)>> = None;
    for (i, line) in text.lines().enumerate() {
        let trimmed = line.trim();
        let upper = trimmed.to_ascii_uppercase();
        if trimmed.is_empty() || trimmed.starts_with([';', '#']) {
            continue;
        }
        if upper.starts_with("BEGIN") {
            inch = upper.contains("INCH");
            continue;
        }
        if upper.starts_with("[END]") || upper.starts_with("END") {
            break;
        }
        let Some(known) = &columns else {
            columns = Some(header_columns(line));
            continue;
        };
        let field = |title: &str| field_of(line, known, title);
        let fail = |title: &str| TableError { line: i + 1, message: format!("column {title} holds no number") };
        let number = field("T").ok_or_else(|| fail("T"))?;
        let (number, index) = tool_number(number).ok_or_else(|| fail("T"))?;
        let unit = if inch { 25.4 } else { 1.0 };
        let length = |title: &str| -> Result<Option<f64>, TableError> {
            match field(title) {
                None => Ok(None),
                Some(text) => signed(text).map(|v| Some(v * unit)).ok_or_else(|| fail(title)),
            }
        };
        let number_of = |title: &str| match field(title) {
            None => Ok(None),
            Some(text) => signed(text).map(Some).ok_or_else(|| fail(title)),
        };
        let tool = Tool {
            name: field("NAME").map(|name| name.trim_matches('"').to_owned()),
            radius: length("R")?,
            length: length("L")?,
            corner_radius: length("R2")?,
            plunge_angle: field("ANGLE").map(|text| signed(text).ok_or_else(|| fail("ANGLE"))).transpose()?,
            tip_angle: number_of("T-ANGLE")?.filter(|angle| *angle != 0.0),
            deltas: [length("DL")?.unwrap_or(0.0), length("DR")?.unwrap_or(0.0), length("DR2")?.unwrap_or(0.0)],
            ..Tool::default()
        };
        table.insert(ToolKey::Number(number, index), tool);
    }
    Ok(table)
}

fn header_columns(line: &str) -> Vec<(String, usize)> {
    let mut columns = Vec::new();
    let mut at = 0;
    for word in line.split_inclusive(char::is_whitespace) {
        if !word.trim().is_empty() {
            columns.push((word.trim().to_ascii_uppercase(), at));
        }
        at += word.len();
    }
    columns
}

/// The text under a column title, up to the next column.
fn field_of<'a>(line: &'a str, columns: &[(String, usize)], title: &str) -> Option<&'a str> {
    let at = columns.iter().position(|(name, _)| name == title)?;
    let start = columns[at].1;
    let end = columns.get(at + 1).map_or(line.len(), |next| next.1);
    // Tables with comments in other encodings shift bytes only behind the first columns.
    let text = line.get(start..end.min(line.len()).max(start)).unwrap_or_default().trim();
    (!text.is_empty() && text != "-").then_some(text)
}

fn tool_number(text: &str) -> Option<(u32, u8)> {
    let (number, index) = text.split_once(['.', ',']).unwrap_or((text, "0"));
    Some((number.trim().parse().ok()?, index.trim().parse().ok()?))
}

fn signed(text: &str) -> Option<f64> {
    let (sign, digits) = match text.as_bytes().first()? {
        b'-' => (-1.0, &text[1..]),
        b'+' => (1.0, &text[1..]),
        _ => (1.0, text),
    };
    let (value, used) = decimal(digits.as_bytes(), true)?;
    (used == digits.len()).then_some(sign * value)
}

/// LinuxCNC `tool.tbl`: `T1 P1 D6.0 Z50.0 ;remark`, D is a diameter.
fn read_tool_tbl(text: &str) -> Result<BTreeMap<ToolKey, Tool>, TableError> {
    let mut table = BTreeMap::new();
    for (i, line) in text.lines().enumerate() {
        let (words, remark) = line.split_once(';').unwrap_or((line, ""));
        let mut number = None;
        let mut tool = Tool::default();
        for word in words.split_whitespace() {
            let fail = || TableError { line: i + 1, message: format!("{word:?} is no word of a tool table") };
            let letter = word.chars().next().filter(char::is_ascii_alphabetic).ok_or_else(fail)?;
            let value = signed(&word[1..]).ok_or_else(fail)?;
            match letter.to_ascii_uppercase() {
                'T' => number = Some(value as u32),
                'D' => tool.radius = Some(value / 2.0),
                'Z' => tool.length = Some(value),
                // Cutting-edge positions are numbered otherwise there; `[tools]` gives them.
                'Q' => {}
                'P' | 'X' | 'Y' | 'A' | 'B' | 'C' | 'U' | 'V' | 'W' | 'I' | 'J' => {}
                _ => return Err(fail()),
            }
        }
        if let Some(number) = number {
            tool.name = Some(remark.trim().to_owned()).filter(|name| !name.is_empty());
            table.insert(ToolKey::Number(number, 0), tool);
        } else if !words.trim().is_empty() {
            return Err(TableError { line: i + 1, message: "a tool line starts with its T word".to_owned() });
        }
    }
    Ok(table)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tool_t_by_columns() {
        let text = "BEGIN TOOL    .T MM\nT    NAME             L         R          R2        DL       DR\n\
                    0                      +0        +0         +0        +0       +0\n\
                    5    MILL D10          +80,5     +5         +0,5               -0,02\n\
                    5.2  MILL D10 B        +70       +5\n[END]\n";
        let table = read_table(text).unwrap();
        let five = &table[&ToolKey::Number(5, 0)];
        assert_eq!((five.radius, five.length, five.corner_radius), (Some(5.0), Some(80.5), Some(0.5)));
        assert_eq!(five.deltas, [0.0, -0.02, 0.0]);
        assert_eq!(five.name.as_deref(), Some("MILL D10"));
        assert_eq!(table[&ToolKey::Number(5, 2)].length, Some(70.0));
        let inch = read_table("BEGIN TOOL .T INCH\nT NAME L R\n1 A    2 0.5\n").unwrap();
        assert_eq!(inch[&ToolKey::Number(1, 0)].radius, Some(12.7));
    }

    #[test]
    fn linuxcnc_table() {
        let table = read_table("T1 P1 D6.0 Z+50.5 Q2 ;6 mm end mill\n;remark\n\nT12 D.5\n").unwrap();
        let one = &table[&ToolKey::Number(1, 0)];
        assert_eq!((one.radius, one.length, one.orientation), (Some(3.0), Some(50.5), None));
        assert_eq!(table[&ToolKey::Number(12, 0)].radius, Some(0.25));
        assert_eq!(read_table("X1 2\n").unwrap_err().line, 1);
    }
}
