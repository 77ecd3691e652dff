//! A TOML document as a tree whose every key and value knows its place, so that one file can extend
//! another and a wrong value is still shown where it stands.

use std::collections::BTreeMap;
use std::fmt;

use toml::de::{DeTable, DeValue};

/// Where a key stands.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Spot {
    pub file: String,
    pub line: usize,
    pub column: usize,
}

/// A configuration that cannot be used.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ConfigError {
    pub spot: Spot,
    pub message: String,
    pub help: Option<String>,
}

impl fmt::Display for ConfigError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.spot.file.is_empty() {
            write!(f, "{}:{}:{}: ", self.spot.file, self.spot.line, self.spot.column)?;
        }
        write!(f, "{}", self.message)?;
        match &self.help {
            Some(help) => write!(f, "; {help}"),
            None => Ok(()),
        }
    }
}

impl std::error::Error for ConfigError {}

/// A value with its place.
#[derive(Debug, Clone, PartialEq)]
pub struct Node {
    pub value: Value,
    pub spot: Spot,
}

#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    Text(String),
    Whole(i64),
    Number(f64),
    Flag(bool),
    List(Vec<Node>),
    Table(Table),
}

/// Keys in alphabetical order, each with the place of the key itself.
pub type Table = BTreeMap<String, Node>;

impl Node {
    pub fn fail(&self, message: impl Into<String>) -> ConfigError {
        ConfigError { spot: self.spot.clone(), message: message.into(), help: None }
    }
}

/// Parses `text`, the content of `file`.
///
/// # Errors
/// A syntax error or a value of a kind that no key has (dates).
pub fn parse(text: &str, file: &str) -> Result<Table, ConfigError> {
    let root = DeTable::parse(text).map_err(|error| ConfigError {
        spot: spot(text, file, error.span().map_or(0, |span| span.start)),
        message: error.message().to_owned(),
        help: None,
    })?;
    table(root.get_ref(), text, file)
}

fn table(source: &DeTable<'_>, text: &str, file: &str) -> Result<Table, ConfigError> {
    let mut out = Table::new();
    for (key, item) in source {
        let at = spot(text, file, key.span().start);
        let value = value(item.get_ref(), text, file, &at)?;
        out.insert(key.get_ref().to_string(), Node { value, spot: at });
    }
    Ok(out)
}

fn value(source: &DeValue<'_>, text: &str, file: &str, at: &Spot) -> Result<Value, ConfigError> {
    let fail = |message: &str| ConfigError { spot: at.clone(), message: message.to_owned(), help: None };
    Ok(match source {
        DeValue::String(s) => Value::Text(s.to_string()),
        DeValue::Integer(i) => {
            Value::Whole(i64::from_str_radix(i.as_str(), i.radix()).map_err(|_| fail("number is too large"))?)
        }
        DeValue::Float(x) => Value::Number(
            x.as_str().parse().ok().filter(|v: &f64| v.is_finite()).ok_or_else(|| fail("number is not finite"))?,
        ),
        DeValue::Boolean(b) => Value::Flag(*b),
        DeValue::Datetime(_) => return Err(fail("a date has no meaning here")),
        DeValue::Array(items) => Value::List(
            items
                .iter()
                .map(|item| {
                    let at = spot(text, file, item.span().start);
                    Ok(Node { value: value(item.get_ref(), text, file, &at)?, spot: at })
                })
                .collect::<Result<_, ConfigError>>()?,
        ),
        DeValue::Table(inner) => Value::Table(table(inner, text, file)?),
    })
}

fn spot(text: &str, file: &str, at: usize) -> Spot {
    let before = text.get(..at.min(text.len())).unwrap_or_default();
    let line_start = before.rfind('\n').map_or(0, |i| i + 1);
    Spot {
        file: file.to_owned(),
        line: before.matches('\n').count() + 1,
        column: before[line_start..].chars().count() + 1,
    }
}

/// Puts `top` over `base`: tables are joined, everything else is replaced.
pub fn overlay(base: &mut Table, top: Table) {
    for (key, node) in top {
        match (base.get_mut(&key).map(|old| &mut old.value), node.value) {
            (Some(Value::Table(old)), Value::Table(new)) => overlay(old, new),
            (_, value) => {
                base.insert(key, Node { value, spot: node.spot });
            }
        }
    }
}

/// Letters of a word that are compared: no program makes this slow.
const COMPARED: usize = 64;

/// The candidate most like `word`, if any is close enough to be meant.
pub fn did_you_mean<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let head = |word: &str| word.to_lowercase().chars().take(COMPARED).collect::<String>();
    let lower = head(word);
    candidates
        .into_iter()
        .map(|candidate| (strsim::osa_distance(&lower, &head(candidate)), candidate))
        .filter(|(n, candidate)| *n <= 1 + candidate.chars().count() / 4)
        .min_by_key(|(n, _)| *n)
        .map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn suggestions_need_to_be_close() {
        assert_eq!(did_you_mean("decimal", ["decimals", "diameter"]), Some("decimals"));
        assert_eq!(did_you_mean("CYLC", ["CYCL", "CALL"]), Some("CYCL"));
        assert_eq!(did_you_mean("foo", ["decimals"]), None);
    }

    #[test]
    fn overlay_joins_tables_and_places_are_of_the_key() {
        let mut base = parse("[output]\ndecimals = 3\ntarget = 'a'\n", "a.toml").unwrap();
        overlay(&mut base, parse("[output]\n  decimals = 5\n", "b.toml").unwrap());
        let Value::Table(output) = &base["output"].value else { panic!() };
        assert_eq!(output["decimals"].value, Value::Whole(5));
        assert_eq!(output["decimals"].spot, Spot { file: "b.toml".into(), line: 2, column: 3 });
        assert_eq!(output["target"].value, Value::Text("a".into()));
    }
}
