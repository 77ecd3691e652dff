//! Sizes of undercuts: those of the standards, and what `[undercut]` changes of them for programs of all controls.

use std::collections::BTreeMap;

use crate::standard::din76::{Lengths, Row};
use crate::standard::din509::{Range, Size};
use crate::standard::{SAME, Source, din76, din509};

use super::tree::{ConfigError, Node, Table, Value};

/// Which length a thread undercut has between what the standard allows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ThreadLength {
    /// The floor lies midway between the shortest and the longest: what a control was seen to make for pitch 3
    /// and 30 degrees.
    Middle,
    /// The floor is g1 long.
    Shortest,
    /// The whole undercut is g2 long.
    Longest,
}

/// From where the depth of an internal thread undercut counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum InternalDepth {
    /// The contour is the core of the thread; the diameter of the undercut counts from the nominal diameter.
    Core,
    /// The table value is added to the diameter of the contour.
    Bore,
}

/// `[undercut]`
#[derive(Debug, Clone, PartialEq)]
pub struct Undercuts {
    /// Forms E and F.
    sizes: Vec<Size>,
    /// In place of the table of the control.
    by_diameter: Option<Vec<Range>>,
    threads: Vec<Row>,
    /// Pitches whose lengths of the short forms the user told, with the key of the form.
    short_forms: Vec<(f64, char)>,
    /// Lists in which programs name sizes by their place, by key: r and t1.
    lists: BTreeMap<String, Vec<(f64, f64)>>,
    /// In place of what the control does.
    pub thread_length: Option<ThreadLength>,
    /// In place of what the control does.
    pub internal_depth: Option<InternalDepth>,
}

impl Default for Undercuts {
    fn default() -> Undercuts {
        Undercuts {
            sizes: din509::SIZES.to_vec(),
            by_diameter: None,
            threads: din76::ROWS.to_vec(),
            short_forms: Vec::new(),
            lists: BTreeMap::new(),
            thread_length: None,
            internal_depth: None,
        }
    }
}

impl Undercuts {
    /// The size r x t1.
    pub fn size(&self, radius: f64, depth: f64) -> Option<&Size> {
        self.sizes.iter().find(|size| size.is((radius, depth)))
    }

    /// A list of sizes that replaces the one of the control, by its key.
    pub fn list(&self, key: &str) -> Option<&[(f64, f64)]> {
        self.lists.get(key).map(Vec::as_slice)
    }

    /// The row for a diameter of the cylinder, and its size; `control` is the table of the control.
    pub fn size_for(&self, diameter: f64, control: &'static [Range]) -> Option<(&Range, &Size)> {
        let ranges = self.by_diameter.as_deref().unwrap_or(control);
        let range = ranges.iter().find(|range| diameter > 0.0 && diameter <= range.upto)?;
        self.size(range.size.0, range.size.1).map(|size| (range, size))
    }

    /// Is the size for a diameter said, and no table of a control in use?
    pub fn says_sizes_by_diameter(&self) -> bool {
        self.by_diameter.is_some()
    }

    pub fn thread(&self, pitch: f64) -> Option<&Row> {
        self.threads.iter().find(|row| (row.pitch - pitch).abs() <= SAME)
    }

    /// Did the user tell the lengths of a short form, `b` outside or `d` inside?
    pub fn says_short_form(&self, pitch: f64, form: char) -> bool {
        self.short_forms.iter().any(|told| told.1 == form && (told.0 - pitch).abs() <= SAME)
    }

    /// The pitch of the table that is nearest to `pitch`.
    pub fn nearest_pitch(&self, pitch: f64) -> Option<f64> {
        self.threads.iter().map(|row| row.pitch).min_by(|a, b| (a - pitch).abs().total_cmp(&(b - pitch).abs()))
    }

    /// All sizes of forms E and F.
    pub fn sizes(&self) -> &[Size] {
        &self.sizes
    }

    /// All thread pitches, in order.
    pub fn threads(&self) -> &[Row] {
        &self.threads
    }

    /// Takes a key of `[undercut]`.
    ///
    /// # Errors
    /// A value that does not fit.
    pub(super) fn set(&mut self, name: &str, node: &Node) -> Result<(), ConfigError> {
        match (name, &node.value) {
            ("thread_length", Value::Text(text)) => {
                self.thread_length = Some(match text.as_str() {
                    "shortest" => ThreadLength::Shortest,
                    "longest" => ThreadLength::Longest,
                    _ => ThreadLength::Middle,
                });
            }
            ("internal_depth", Value::Text(text)) => {
                self.internal_depth = Some(if text == "bore" { InternalDepth::Bore } else { InternalDepth::Core });
            }
            ("din509", Value::Table(table)) => {
                for (name, node) in table {
                    self.set_size(name, node)?;
                }
            }
            ("din76", Value::Table(table)) => {
                for (name, node) in table {
                    self.set_thread(name, node)?;
                }
            }
            ("din509_by_diameter", Value::Table(table)) => self.set_by_diameter(table)?,
            (list, Value::List(items)) => {
                let sizes = self.size_list(items)?;
                self.lists.insert(list.to_owned(), sizes);
            }
            _ => return Err(node.fail(format!("`{name}` has no place in [undercut]"))),
        }
        Ok(())
    }

    fn set_size(&mut self, name: &str, node: &Node) -> Result<(), ConfigError> {
        let fail = || node.fail("a size is its radius and its depth: \"0.6x0.3\" = { f = 2.5, t2 = 0.2 }");
        let (radius, depth) = radius_and_depth(name).ok_or_else(fail)?;
        let Value::Table(values) = &node.value else { return Err(fail()) };
        let index = match self.sizes.iter().position(|size| size.is((radius, depth))) {
            Some(index) => index,
            None => {
                for needed in ["f", "t2"] {
                    if !values.contains_key(needed) {
                        return Err(node.fail(format!("a new size needs `{needed}`")));
                    }
                }
                self.sizes.push(Size { radius, depth, length: 0.0, face_depth: 0.0, source: Source::CONFIGURATION });
                self.sizes.len() - 1
            }
        };
        let Some(row) = self.sizes.get_mut(index) else { return Err(fail()) };
        row.source = Source::CONFIGURATION;
        for (key, node) in values {
            let value = positive(node)?;
            match key.as_str() {
                "f" => row.length = value,
                "t2" => row.face_depth = value,
                _ => return Err(node.fail(format!("unknown key `{key}`; a size has f and t2"))),
            }
        }
        Ok(())
    }

    /// Sizes by their place.
    fn size_list(&self, items: &[Node]) -> Result<Vec<(f64, f64)>, ConfigError> {
        items.iter().map(|node| self.named_size(node)).collect()
    }

    /// r and t1 of a size that there is.
    fn named_size(&self, node: &Node) -> Result<(f64, f64), ConfigError> {
        let known = match &node.value {
            Value::Text(text) => radius_and_depth(text).filter(|(r, t)| self.size(*r, *t).is_some()),
            _ => None,
        };
        known.ok_or_else(|| node.fail("needs a size of DIN 509 such as \"0.6x0.3\""))
    }

    fn set_by_diameter(&mut self, table: &Table) -> Result<(), ConfigError> {
        let mut list = Vec::new();
        for (name, node) in table {
            let upto = match name.as_str() {
                "above" => f64::INFINITY,
                _ => name.parse().ok().filter(|d| *d > 0.0).ok_or_else(|| {
                    node.fail("keys are greatest diameters, and `above` for all larger ones: \"80\" = \"0.6x0.3\"")
                })?,
            };
            let size = self.named_size(node)?;
            list.push(Range { upto, size, source: Source::CONFIGURATION, otherwise: None });
        }
        list.sort_by(|a: &Range, b| a.upto.total_cmp(&b.upto));
        self.by_diameter = Some(list);
        Ok(())
    }

    fn set_thread(&mut self, name: &str, node: &Node) -> Result<(), ConfigError> {
        let fail = || node.fail("a thread undercut is named by its pitch: \"1.5\" = { external = 2.3, r = 0.8 }");
        let pitch: f64 = name.parse().ok().filter(|p: &f64| *p > 0.0 && p.is_finite()).ok_or_else(fail)?;
        let Value::Table(values) = &node.value else { return Err(fail()) };
        let index = match self.threads.iter().position(|row| (row.pitch - pitch).abs() <= SAME) {
            Some(index) => index,
            None => {
                for needed in ["external", "a", "b", "r", "internal", "c", "d"] {
                    if !values.contains_key(needed) {
                        return Err(node.fail(format!("a new pitch needs `{needed}`")));
                    }
                }
                let index = self.threads.iter().take_while(|row| row.pitch < pitch).count();
                self.threads.insert(index, Row { pitch, ..Row::EMPTY });
                index
            }
        };
        let Some(row) = self.threads.get_mut(index) else { return Err(fail()) };
        row.source = Source::CONFIGURATION;
        for (key, node) in values {
            match key.as_str() {
                "external" => row.external = positive(node)?,
                "internal" => {
                    row.internal = positive(node)?;
                    row.otherwise = None;
                }
                "r" => row.radius = positive(node)?,
                "a" => row.a = lengths(node)?,
                "b" => {
                    row.b = lengths(node)?;
                    self.short_forms.push((pitch, 'b'));
                }
                "c" => row.c = lengths(node)?,
                "d" => {
                    row.d = lengths(node)?;
                    self.short_forms.push((pitch, 'd'));
                }
                _ => {
                    let known = "external, a, b, r, internal, c, d";
                    return Err(node.fail(format!("unknown key `{key}`; a thread undercut has {known}")));
                }
            }
        }
        Ok(())
    }
}

/// `0.6x0.3`
fn radius_and_depth(text: &str) -> Option<(f64, f64)> {
    let (radius, depth) = text.split_once(['x', 'X'])?;
    let value = |text: &str| text.trim().parse().ok().filter(|v: &f64| *v > 0.0 && v.is_finite());
    Some((value(radius)?, value(depth)?))
}

fn positive(node: &Node) -> Result<f64, ConfigError> {
    let value = match node.value {
        Value::Whole(n) => n as f64,
        Value::Number(x) => x,
        _ => 0.0,
    };
    if value > 0.0 { Ok(value) } else { Err(node.fail("needs a number of mm over 0")) }
}

fn lengths(node: &Node) -> Result<Lengths, ConfigError> {
    let fail = || node.fail("needs the least and the greatest length: [3.2, 5.2]");
    let Value::List(items) = &node.value else { return Err(fail()) };
    match items.as_slice() {
        [g1, g2] => {
            let (g1, g2) = (positive(g1)?, positive(g2)?);
            if g1 < g2 { Ok(Lengths { g1, g2 }) } else { Err(fail()) }
        }
        _ => Err(fail()),
    }
}

#[cfg(test)]
mod tests {
    use super::super::tree::parse;
    use super::*;

    #[test]
    fn sizes_and_pitches_are_found() {
        let tables = Undercuts::default();
        assert_eq!(tables.size(0.6, 0.3).map(|s| (s.length, s.face_depth)), Some((2.5, 0.2)));
        assert_eq!(tables.size(0.6, 0.4), None);
        let by = |d: f64| tables.size_for(d, din509::NORMAL).map(|(range, _)| range.size);
        assert_eq!(by(1.6), Some((0.1, 0.1)));
        assert_eq!(by(10.0), Some((0.4, 0.2)));
        assert_eq!(by(18.0), Some((0.6, 0.2)));
        assert_eq!(by(18.001), Some((0.6, 0.3)));
        assert_eq!(by(500.0), Some((1.0, 0.4)));
        assert_eq!((by(0.0), by(-5.0)), (None, None));
        assert_eq!(tables.thread(2.5).map(|t| (t.external, t.a.g1, t.a.g2, t.radius)), Some((3.6, 5.6, 8.7, 1.2)));
        assert_eq!(tables.thread(2.6), None);
        assert_eq!(tables.nearest_pitch(2.6), Some(2.5));
    }

    fn read(text: &str) -> Result<Undercuts, ConfigError> {
        let mut tables = Undercuts::default();
        for (name, node) in &parse(text, "partc.toml")? {
            tables.set(name, node)?;
        }
        Ok(tables)
    }

    #[test]
    fn values_can_be_replaced() {
        let tables = read(
            "din509.'0.6x0.3' = { t2 = 0.25 }\ndin509.'0.8x0.5' = { f = 3, t2 = 0.2 }\ndin76.'2.5' = { b = [3.3, 6.4] }\n\
             din509_by_diameter = { '20' = '0.8x0.5', above = '1x0.4' }\nthread_length = 'shortest'\ninternal_depth = 'bore'\n",
        )
        .unwrap();
        assert_eq!(tables.size(0.6, 0.3).map(|s| (s.length, s.face_depth)), Some((2.5, 0.25)));
        assert_eq!(tables.thread(2.5).map(|t| (t.b.g1, t.a.g1)), Some((3.3, 5.6)));
        for control in [din509::NORMAL, din509::HEIDENHAIN, din509::PLUS_4110_G85] {
            assert_eq!(tables.size_for(19.0, control).map(|(_, size)| size.length), Some(3.0));
            assert_eq!(tables.size_for(21.0, control).map(|(_, size)| size.radius), Some(1.0));
        }
        assert_eq!(tables.thread_length, Some(ThreadLength::Shortest));
        assert_eq!(tables.internal_depth, Some(InternalDepth::Bore));
    }

    #[test]
    fn sizes_are_named_by_their_place() {
        let tables = read("din509_in_editor = ['0.8x0.3', '1.2x0.2']\n").unwrap();
        assert_eq!(tables.list("din509_in_editor"), Some(&[(0.8, 0.3), (1.2, 0.2)][..]));
        assert_eq!(tables.list("din509_in_cycle"), None);
        assert!(read("din509_in_editor = ['0.9x0.3']").is_err() && read("din509_in_cycle = [1]").is_err());
    }

    #[test]
    fn wrong_values_are_refused() {
        for text in [
            "din509.'0.6' = { f = 2 }",
            "din509.'0.7x0.3' = { f = 2 }",
            "din509.'0.6x0.3' = { g = 2 }",
            "din509.'0.6x0.3' = { f = -2 }",
            "din76.'0' = { r = 2 }",
            "din76.'1.1' = { r = 2 }",
            "din76.'1' = { a = [4, 2] }",
            "din509_by_diameter = { '20' = '0.9x0.5' }",
            "din509_by_diameter = { 'big' = '0.6x0.3' }",
        ] {
            assert!(read(text).is_err(), "{text}");
        }
    }
}
