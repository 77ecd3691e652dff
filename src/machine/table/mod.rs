//! Files with data of tools and of the machine: tables of HEIDENHAIN controls, archives of a SINUMERIK, files of LinuxCNC,
//! CSV. The content tells which; lengths come out in mm.

pub mod columns;
pub mod csv;
mod limits;
mod places;
mod sinumerik;
mod tool_t;
mod tool_tbl;

use std::collections::BTreeMap;
use std::fmt;

use super::{Axis, Tool, ToolKey, Unit};

pub use places::Place;

/// What a file is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Kind {
    /// `TOOL.T`
    #[default]
    HeidenhainTools,
    /// `tool.tbl`
    LinuxcncTools,
    Csv,
    /// `.INI`, `.TOA`, `.UFR`
    Sinumerik,
    /// `.PR`
    Presets,
    /// `.D`
    Datums,
    /// `.PNT`
    Points,
    /// `.ini` of a machine
    Machine,
}

impl Kind {
    pub fn name(self) -> &'static str {
        match self {
            Kind::HeidenhainTools => "tool table of a HEIDENHAIN control",
            Kind::LinuxcncTools => "tool table of LinuxCNC",
            Kind::Csv => "tools as CSV",
            Kind::Sinumerik => "data of a SINUMERIK",
            Kind::Presets => "preset table of a HEIDENHAIN control",
            Kind::Datums => "datum table of a HEIDENHAIN control",
            Kind::Points => "point table of a HEIDENHAIN control",
            Kind::Machine => "machine of LinuxCNC",
        }
    }
}

/// `$TC_DPparameter[tool,edge]`
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Edge {
    pub tool: u32,
    pub edge: u32,
    pub parameter: u32,
}

/// What a file holds.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Contents {
    pub kind: Kind,
    /// The unit that the file states; without one its lengths are taken for mm.
    pub unit: Option<Unit>,
    pub tools: BTreeMap<ToolKey, Tool>,
    pub edges: BTreeMap<Edge, f64>,
    pub places: Vec<Place>,
    /// Work offsets by their words.
    pub offsets: BTreeMap<String, BTreeMap<Axis, f64>>,
    pub limits: BTreeMap<Axis, [Option<f64>; 2]>,
    /// Lines with values that partc has no use for.
    pub left_out: Vec<(usize, String)>,
}

impl Contents {
    /// Does the file hold tools?
    pub fn has_tools(&self) -> bool {
        let for_tools = [Kind::HeidenhainTools, Kind::LinuxcncTools, Kind::Csv].contains(&self.kind);
        for_tools || !self.tools.is_empty()
    }

    /// Says in which unit the lengths of a file are that states none.
    pub fn take_for(&mut self, unit: Unit) {
        let before = self.unit.replace(unit);
        if before.is_some() || unit == Unit::Mm {
            return;
        }
        const MM: f64 = 25.4;
        for tool in self.tools.values_mut() {
            let lengths = [&mut tool.radius, &mut tool.length, &mut tool.corner_radius, &mut tool.width];
            lengths.into_iter().flatten().chain(&mut tool.deltas).for_each(|length| *length *= MM);
        }
        let lengths = self.edges.iter_mut().filter(|(edge, _)| is_length(edge.parameter));
        lengths.for_each(|(_, length)| *length *= MM);
        let offsets = self.offsets.values_mut().flatten().filter(|(axis, _)| !axis.is_rotary());
        offsets.for_each(|(_, value)| *value *= MM);
        let limits = self.limits.iter_mut().filter(|(axis, _)| !axis.is_rotary());
        limits.flat_map(|(_, limits)| limits).flatten().for_each(|limit| *limit *= MM);
    }
}

/// Parameters of $TC_DP that are lengths.
fn is_length(parameter: u32) -> bool {
    matches!(parameter, 3..=9 | 12..=18 | 21..=23)
}

/// A table that cannot be read: the line and what is wrong with it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TableError {
    pub line: usize,
    pub message: String,
}

impl fmt::Display for TableError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.line, self.message)
    }
}

/// Reads a file of any kind.
///
/// # Errors
/// A line that does not belong into such a file.
pub fn read(text: &str) -> Result<Contents, TableError> {
    let kind = kind_of(text)?;
    let contents = match kind {
        Kind::HeidenhainTools => tool_t::read(text),
        Kind::LinuxcncTools => tool_tbl::read(text),
        Kind::Csv => csv::read(text),
        Kind::Sinumerik => sinumerik::read(text),
        Kind::Presets | Kind::Datums | Kind::Points => places::read(text, kind),
        Kind::Machine => limits::read(text),
    }?;
    Ok(Contents { kind, ..contents })
}

fn kind_of(text: &str) -> Result<Kind, TableError> {
    let text = text.trim_start_matches('\u{feff}');
    let mut lines = (1..).zip(text.lines()).map(|(line, text)| (line, text.trim()));
    let mut solid = lines.clone().filter(|(_, text)| !text.is_empty() && !text.starts_with(['#', ';']));
    let Some((line, first)) = solid.next() else { return Ok(Kind::LinuxcncTools) };
    let upper = first.to_ascii_uppercase();
    if upper.split_whitespace().next() == Some("BEGIN") {
        let name: String = upper.split_whitespace().skip(1).filter(|word| !matches!(*word, "MM" | "INCH")).collect();
        return match name.rsplit_once('.').map_or("T", |(_, extension)| extension) {
            "T" => Ok(Kind::HeidenhainTools),
            "PR" => Ok(Kind::Presets),
            "D" => Ok(Kind::Datums),
            "PNT" => Ok(Kind::Points),
            _ => {
                let message = format!("{name} is no table that partc reads: TOOL.T, .D, .PR or .PNT");
                Err(TableError { line, message })
            }
        };
    }
    let titles = upper.split_whitespace().collect::<Vec<_>>();
    if titles.contains(&"T") && titles.contains(&"L") {
        return Ok(Kind::HeidenhainTools);
    }
    let is_value = |text: &str| {
        let behind =
            text.trim_start_matches(|c: char| c.is_ascii_digit() || c.is_whitespace() || matches!(c, 'N' | 'n'));
        behind.starts_with('$')
    };
    if upper.starts_with('%') || upper.starts_with("CHANDATA(") || lines.any(|(_, text)| is_value(text)) {
        return Ok(Kind::Sinumerik);
    }
    if first.starts_with('[') {
        return Ok(Kind::Machine);
    }
    Ok(if csv::begins(first) { Kind::Csv } else { Kind::LinuxcncTools })
}

/// `5.2`: number and index.
fn tool_number(text: &str) -> Option<(u32, u8)> {
    let (number, index) = text.split_once(['.', ',']).unwrap_or((text, "0"));
    Some((number.trim().parse().ok()?, index.trim().parse().ok()?))
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
        let table = read(text).unwrap().tools;
        let five = &table[&ToolKey::Number(5, 0)];
        assert_eq!((five.radius, five.length, five.corner_radius), (Some(5.0), Some(80.5), Some(0.5)));
        assert_eq!(five.deltas, [0.0, -0.02, 0.0]);
        assert_eq!(five.name.as_deref(), Some("MILL D10"));
        assert_eq!(table[&ToolKey::Number(5, 2)].length, Some(70.0));
        let inch = read("BEGIN TOOL .T INCH\nT NAME L R\n1 A    2 0.5\n[END]\n").unwrap().tools;
        assert_eq!(inch[&ToolKey::Number(1, 0)].radius, Some(12.7));
    }

    #[test]
    fn linuxcnc_table() {
        let table = read("T1 P1 D6.0 Z+50.5 Q2 ;6 mm end mill\n;remark\n\nT12 D.5\n").unwrap().tools;
        let one = &table[&ToolKey::Number(1, 0)];
        assert_eq!((one.radius, one.length, one.orientation), (Some(3.0), Some(50.5), None));
        assert_eq!(table[&ToolKey::Number(12, 0)].radius, Some(0.25));
        assert_eq!(read("X1 2\n").unwrap_err().line, 1);
    }
}
