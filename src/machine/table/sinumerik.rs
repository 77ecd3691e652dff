//! Data of a SINUMERIK as the control archives them (`.INI`, `.TOA`, `.UFR`): a value a line, `$TC_DP6[1,1]=5`.
//!
//! Source: S (docs/sources.md), tool data by $TC_DP1 to $TC_DP25, work offsets by $P_UIFR.

use std::collections::BTreeMap;

use crate::machine::{Axis, Tool, ToolKey};

use super::columns::signed;
use super::{Contents, Edge, Kind, TableError};

/// # Errors
/// A line that is no value of a tool or a work offset.
pub(super) fn read(text: &str) -> Result<Contents, TableError> {
    let mut contents = Contents { kind: Kind::Sinumerik, ..Contents::default() };
    for (line, text) in (1..).zip(text.trim_start_matches('\u{feff}').lines()) {
        let code = without_comment(text).trim();
        let code = code.strip_prefix(['N', 'n']).map_or(code, |rest| {
            let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
            if digits > 0 { rest[digits..].trim_start() } else { code }
        });
        let upper = code.to_ascii_uppercase();
        let frame = matches!(upper.as_str(), "" | "M2" | "M02" | "M17" | "M30" | "RET");
        if frame || upper.starts_with('%') || upper.starts_with("CHANDATA(") {
            continue;
        }
        value(&mut contents, line, code).map_err(|message| TableError { line, message })?;
    }
    finish(&mut contents);
    Ok(contents)
}

/// A semicolon within quotes begins no comment.
fn without_comment(text: &str) -> &str {
    let mut quoted = false;
    let end = text.find(|c: char| {
        quoted ^= c == '"';
        c == ';' && !quoted
    });
    &text[..end.unwrap_or(text.len())]
}

/// `$NAME[indices]=value`
fn value(contents: &mut Contents, line: usize, code: &str) -> Result<(), String> {
    let no = || format!("`{code}` is no value of a tool or a work offset");
    let (left, right) = code.split_once('=').ok_or_else(no)?;
    let (name, indices) = match left.trim().split_once('[') {
        Some((name, rest)) => (name.trim(), rest.strip_suffix(']').ok_or_else(no)?),
        None => (left.trim(), ""),
    };
    let name = name.strip_prefix('$').ok_or_else(no)?.to_ascii_uppercase();
    let indices: Vec<&str> = indices.split(',').map(str::trim).collect();
    let right = right.trim();
    let whole = |at: usize| indices.get(at).and_then(|text| text.parse::<u32>().ok());
    if let Some(parameter) = name.strip_prefix("TC_DP") {
        let edge = (whole(0), whole(1), parameter.parse().ok(), number(right));
        let (Some(tool), Some(edge), Some(parameter), Some(value)) = edge else { return Err(no()) };
        contents.edges.insert(Edge { tool, edge, parameter }, value);
    } else if name == "TC_TP2" {
        let (Some(tool), Some(text)) = (whole(0), quoted(right)) else { return Err(no()) };
        let entry = contents.tools.entry(ToolKey::Number(tool, 0)).or_default();
        entry.name = Some(text.to_owned()).filter(|text| !text.is_empty());
    } else if name == "P_UIFR" {
        offset(contents, line, &indices, right).ok_or_else(no)?;
    } else if name.starts_with("TC_") || name.starts_with("P_CHBFR") || name.starts_with("A_") {
        // Magazines, monitoring, tool holders: no path depends on them.
        contents.left_out.push((line, format!("${name}")));
    } else {
        return Err(no());
    }
    Ok(())
}

/// `$P_UIFR[1,X,TR]=12.5`, `$P_UIFR[1]=CTRANS(X,12.5,Y,0):CROT(Z,0)`.
fn offset(contents: &mut Contents, line: usize, indices: &[&str], right: &str) -> Option<()> {
    let number: u8 = indices.first()?.parse().ok()?;
    let word = word_of(number);
    let mut left_out = Vec::new();
    let mut set = |axis: &str, kind: &str, value: f64| -> Option<()> {
        let letter = axis.as_bytes().first().filter(|_| axis.len() == 1)?;
        match kind {
            "TR" | "CTRANS" | "FI" | "CFINE" => {
                let values: &mut BTreeMap<Axis, f64> = contents.offsets.entry(word?.to_owned()).or_default();
                *values.entry(Axis::of(letter.to_ascii_uppercase())?).or_default() += value;
            }
            _ if value == 0.0 || (kind == "SC" || kind == "CSCALE") && value == 1.0 => {}
            _ => left_out.push((line, format!("{kind} of $P_UIFR[{number}]"))),
        }
        Some(())
    };
    if let [_, axis, kind] = indices {
        set(axis, &kind.to_ascii_uppercase(), self::number(right)?)?;
    } else {
        for part in right.split(':') {
            let (kind, list) = part.trim().split_once('(')?;
            let kind = kind.trim().to_ascii_uppercase();
            let list: Vec<&str> = list.trim().strip_suffix(')')?.split(',').map(str::trim).collect();
            if kind == "CMIRROR" && !list.concat().is_empty() {
                set("X", "CMIRROR", 1.0)?;
                continue;
            }
            for pair in list.chunks(2).filter(|pair| !pair.concat().is_empty()) {
                set(pair[0], &kind, self::number(pair.get(1)?)?)?;
            }
        }
    }
    contents.left_out.append(&mut left_out);
    Some(())
}

/// The work offset word of a number of $P_UIFR.
fn word_of(number: u8) -> Option<&'static str> {
    ["G500", "G54", "G55", "G56", "G57"].get(usize::from(number)).copied().or(match number {
        5..=99 => OFFSETS.get(usize::from(number) - 5).copied(),
        _ => None,
    })
}

const OFFSETS: [&str; 8] = ["G505", "G506", "G507", "G508", "G509", "G510", "G511", "G512"];

/// `12.5`, `1.2EX-3`.
fn number(text: &str) -> Option<f64> {
    let upper = text.to_ascii_uppercase();
    let (mantissa, exponent) = upper.split_once("EX").unwrap_or((&upper, "0"));
    let exponent: i32 = exponent.trim().parse().ok().filter(|power| (-30..=30).contains(power))?;
    // The nearest value of the whole text.
    if exponent == 0 { signed(mantissa.trim()) } else { format!("{}e{exponent}", mantissa.trim()).parse().ok() }
}

fn quoted(text: &str) -> Option<&str> {
    text.strip_prefix('"')?.strip_suffix('"')
}

/// Edge 1 of each tool, as the other tables have it.
fn finish(contents: &mut Contents) {
    let edges: Vec<(Edge, f64)> = contents.edges.iter().map(|(edge, value)| (*edge, *value)).collect();
    for (Edge { tool, edge, parameter }, value) in edges {
        let entry: &mut Tool = contents.tools.entry(ToolKey::Number(tool, 0)).or_default();
        if edge != 1 {
            continue;
        }
        match parameter {
            1 => entry.kind = kind(value).map(str::to_owned),
            2 => entry.orientation = Some(value as u8).filter(|place| (1..=9).contains(place)),
            3 => entry.length = Some(value),
            6 => entry.radius = Some(value),
            12 => entry.deltas[0] = value,
            15 => entry.deltas[1] = value,
            24 if value != 0.0 => entry.clearance = Some(value),
            _ => {}
        }
    }
}

/// Kind of tool of $TC_DP1.
fn kind(number: f64) -> Option<&'static str> {
    match number as u32 {
        240..=249 => Some("tap"),
        200..=239 => Some("drill"),
        100..=199 => Some("mill"),
        540..=549 => Some("thread"),
        500..=519 => Some("turn"),
        _ => None,
    }
}
