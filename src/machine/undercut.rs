//! Sizes of undercuts: DIN 509 for forms E and F, DIN 76-1 for threads. `[undercut]` changes single values.

use super::tree::{ConfigError, Node, Table, Value};

/// A size of forms E and F, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Din509 {
    /// r: both roundings.
    pub radius: f64,
    /// t1: depth in the cylinder.
    pub depth: f64,
    /// f: length on the cylinder.
    pub length: f64,
    /// t2: depth behind the face, form F.
    pub face_depth: f64,
}

/// Shortest and longest length in the standard: g1 is the least length of the floor, g2 the greatest of all.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lengths {
    pub g1: f64,
    pub g2: f64,
}

/// Undercuts of a thread pitch, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Din76 {
    pub pitch: f64,
    /// Nominal diameter less diameter of the undercut, external.
    pub external: f64,
    /// External, normal.
    pub a: Lengths,
    /// External, short.
    pub b: Lengths,
    pub radius: f64,
    /// Diameter of the undercut less nominal diameter, internal.
    pub internal: f64,
    /// Internal, normal.
    pub c: Lengths,
    /// Internal, short.
    pub d: Lengths,
}

/// Which length a thread undercut has between what the standard allows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ThreadLength {
    /// The floor lies midway between the shortest and the longest: what a control was seen to make for pitch 3
    /// and 30 degrees.
    #[default]
    Middle,
    /// The floor is g1 long.
    Shortest,
    /// The whole undercut is g2 long.
    Longest,
}

/// From where the depth of an internal thread undercut counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum InternalDepth {
    /// The contour is the core of the thread; the diameter of the undercut counts from the nominal diameter.
    #[default]
    Core,
    /// The table value is added to the diameter of the contour.
    Bore,
}

/// `[undercut]`
#[derive(Debug, Clone, PartialEq)]
pub struct Undercuts {
    /// Forms E and F, by radius and depth.
    sizes: Vec<Din509>,
    /// Up to this diameter, the index into `sizes`.
    by_diameter: Vec<(f64, usize)>,
    threads: Vec<Din76>,
    editor: SizeList,
    cycle: SizeList,
    pub thread_length: ThreadLength,
    pub internal_depth: InternalDepth,
}

const fn size(radius: f64, depth: f64, length: f64, face_depth: f64) -> Din509 {
    Din509 { radius, depth, length, face_depth }
}

type Pair = (f64, f64);

#[allow(clippy::too_many_arguments)]
const fn thread(pitch: f64, external: f64, a: Pair, b: Pair, radius: f64, internal: f64, c: Pair, d: Pair) -> Din76 {
    const fn lengths(pair: Pair) -> Lengths {
        Lengths { g1: pair.0, g2: pair.1 }
    }
    Din76 { pitch, external, a: lengths(a), b: lengths(b), radius, internal, c: lengths(c), d: lengths(d) }
}

/// DIN 509: r, t1, f, t2. Source: extract of the edition of 1998; 0.1 x 0.1 from HEIDENHAIN CNC PILOT 4290.
const DIN_509: &[Din509] = &[
    size(0.1, 0.1, 0.5, 0.1),
    size(0.2, 0.1, 1.0, 0.1),
    size(0.4, 0.2, 2.0, 0.1),
    size(0.6, 0.2, 2.0, 0.1),
    size(0.6, 0.3, 2.5, 0.2),
    size(0.8, 0.3, 2.5, 0.2),
    size(1.0, 0.2, 2.5, 0.1),
    size(1.0, 0.4, 4.0, 0.3),
    size(1.2, 0.2, 2.5, 0.1),
    size(1.2, 0.4, 4.0, 0.3),
    size(1.6, 0.3, 4.0, 0.2),
    size(2.5, 0.4, 5.0, 0.3),
    size(4.0, 0.5, 7.0, 0.3),
];

/// Sizes by diameter of the cylinder, normal load: up to, r, t1. Where DIN 509 names two sizes for a range
/// (10 to 18, 18 to 80, over 80), the one HEIDENHAIN lists; what other controls take is not published.
const BY_DIAMETER: &[(f64, f64, f64)] = &[
    (1.6, 0.1, 0.1),
    (3.0, 0.2, 0.1),
    (10.0, 0.4, 0.2),
    (18.0, 0.6, 0.2),
    (80.0, 0.6, 0.3),
    (f64::INFINITY, 1.0, 0.4),
];

/// Sizes by their place in the list of SINUMERIK's contour editor. Place 4 was seen in stored programs, the others follow
/// from the order by radius and are not confirmed.
const EDITOR: &[(f64, f64)] = &[
    (0.1, 0.1),
    (0.2, 0.1),
    (0.4, 0.2),
    (0.6, 0.2),
    (0.6, 0.3),
    (1.0, 0.2),
    (1.0, 0.4),
    (1.6, 0.3),
    (2.5, 0.4),
    (4.0, 0.5),
];
const EDITOR_SEEN: u32 = 4;

/// Sizes by their place in the list of CYCLE940 (`_PITI`): 0 was seen, the others are not confirmed.
const CYCLE: &[(f64, f64)] = &[
    (0.6, 0.3),
    (1.0, 0.4),
    (1.0, 0.2),
    (1.6, 0.3),
    (2.5, 0.4),
    (4.0, 0.5),
    (0.4, 0.2),
    (0.6, 0.2),
    (0.1, 0.1),
    (0.2, 0.1),
];
const CYCLE_SEEN: u32 = 0;

/// A list in which programs name sizes by their place.
#[derive(Debug, Clone, PartialEq)]
struct SizeList {
    sizes: Vec<(f64, f64)>,
    /// The one place that is confirmed; `None` for a list of the configuration, which the user answers for.
    seen: Option<u32>,
}

/// DIN 76-1: pitch, d - dg, A, B, r, dg - D, C, D. Depths, r and the longest lengths of A and C: HEIDENHAIN CNC
/// PILOT 4290, p. 426; g1 and the short forms B and D have a single source and are not confirmed.
#[rustfmt::skip]
const DIN_76: &[Din76] = &[
    thread(0.2, 0.3, (0.45, 0.7), (0.25, 0.5), 0.1, 0.1, (0.8, 1.2), (0.5, 0.9)),
    thread(0.25, 0.4, (0.55, 0.9), (0.25, 0.6), 0.12, 0.1, (1.0, 1.4), (0.6, 1.0)),
    thread(0.3, 0.5, (0.6, 1.05), (0.3, 0.75), 0.16, 0.1, (1.2, 1.6), (0.75, 1.25)),
    thread(0.35, 0.6, (0.7, 1.2), (0.4, 0.9), 0.16, 0.2, (1.4, 1.9), (0.9, 1.4)),
    thread(0.4, 0.7, (0.8, 1.4), (0.5, 1.0), 0.2, 0.2, (1.6, 2.2), (1.0, 1.6)),
    thread(0.45, 0.7, (1.0, 1.6), (0.5, 1.1), 0.2, 0.2, (1.8, 2.4), (1.1, 1.7)),
    thread(0.5, 0.8, (1.1, 1.75), (0.5, 1.25), 0.2, 0.3, (2.0, 2.7), (1.25, 2.0)),
    thread(0.6, 1.0, (1.2, 2.1), (0.6, 1.5), 0.4, 0.3, (2.4, 3.3), (1.5, 2.4)),
    thread(0.7, 1.1, (1.5, 2.45), (0.8, 1.75), 0.4, 0.3, (2.8, 3.8), (1.75, 2.75)),
    thread(0.75, 1.2, (1.6, 2.6), (0.9, 1.9), 0.4, 0.3, (3.0, 4.0), (1.9, 2.9)),
    thread(0.8, 1.3, (1.7, 2.8), (0.9, 2.0), 0.4, 0.3, (3.2, 4.2), (2.0, 3.0)),
    thread(1.0, 1.6, (2.1, 3.5), (1.1, 2.5), 0.6, 0.5, (4.0, 5.2), (2.5, 3.7)),
    thread(1.25, 2.0, (2.7, 4.4), (1.5, 3.2), 0.6, 0.5, (5.0, 6.7), (3.2, 4.9)),
    thread(1.5, 2.3, (3.2, 5.2), (1.8, 3.8), 0.8, 0.5, (6.0, 7.8), (3.8, 5.6)),
    thread(1.75, 2.6, (3.9, 6.1), (2.1, 4.3), 1.0, 0.5, (7.0, 9.1), (4.3, 6.4)),
    thread(2.0, 3.0, (4.5, 7.0), (2.5, 5.0), 1.0, 0.5, (8.0, 10.3), (5.0, 7.3)),
    thread(2.5, 3.6, (5.6, 8.7), (3.2, 6.3), 1.2, 0.5, (10.0, 13.0), (6.3, 9.3)),
    thread(3.0, 4.4, (6.7, 10.5), (3.7, 7.5), 1.6, 0.5, (12.0, 15.2), (7.5, 10.7)),
    thread(3.5, 5.0, (7.7, 12.0), (4.7, 9.0), 1.6, 0.5, (14.0, 17.7), (9.0, 12.7)),
    thread(4.0, 5.7, (9.0, 14.0), (5.0, 10.0), 2.0, 0.5, (16.0, 20.0), (10.0, 14.0)),
    thread(4.5, 6.4, (10.5, 16.0), (5.5, 11.0), 2.0, 0.5, (18.0, 23.0), (11.0, 16.0)),
    thread(5.0, 7.0, (11.5, 17.5), (6.5, 12.5), 2.5, 0.5, (20.0, 26.0), (12.5, 18.5)),
    thread(5.5, 7.7, (12.5, 19.0), (7.5, 14.0), 3.2, 0.5, (22.0, 28.0), (14.0, 20.0)),
    thread(6.0, 8.3, (14.0, 21.0), (8.0, 15.0), 3.2, 0.5, (24.0, 30.0), (15.0, 21.0)),
];

/// Coarse pitch by nominal diameter, DIN 13-1 and ISO 261.
const COARSE: &[(f64, &[f64])] = &[
    (0.25, &[1.0, 1.1, 1.2]),
    (0.3, &[1.4]),
    (0.35, &[1.6, 1.8]),
    (0.4, &[2.0]),
    (0.45, &[2.2, 2.5]),
    (0.5, &[3.0]),
    (0.6, &[3.5]),
    (0.7, &[4.0]),
    (0.75, &[4.5]),
    (0.8, &[5.0]),
    (1.0, &[6.0, 7.0]),
    (1.25, &[8.0, 9.0]),
    (1.5, &[10.0, 11.0]),
    (1.75, &[12.0]),
    (2.0, &[14.0, 16.0]),
    (2.5, &[18.0, 20.0, 22.0]),
    (3.0, &[24.0, 27.0]),
    (3.5, &[30.0, 33.0]),
    (4.0, &[36.0, 39.0]),
    (4.5, &[42.0, 45.0]),
    (5.0, &[48.0, 52.0]),
    (5.5, &[56.0, 60.0]),
    (6.0, &[64.0, 68.0]),
];

/// How much a programmed value may differ from one of a table, in mm: more than rounding, less than a step.
const SAME: f64 = 1e-6;
/// How far a turned diameter may lie below the nominal one, in mm, for the pitch to be proposed.
const TURNED: f64 = 0.5;

/// Coarse pitch of a nominal diameter; `None` for a diameter that has no metric coarse thread.
pub fn coarse_pitch(diameter: f64) -> Option<f64> {
    COARSE.iter().find(|(_, list)| list.iter().any(|d| (d - diameter).abs() <= SAME)).map(|(pitch, _)| *pitch)
}

/// A pitch to propose for a turned diameter, which is often a little less than the nominal one: the coarse
/// pitch of the nearest nominal diameter at or above it.
pub fn proposed_pitch(diameter: f64) -> Option<f64> {
    let nominal = COARSE.iter().flat_map(|(pitch, list)| list.iter().map(|d| (*d, *pitch)));
    nominal
        .filter(|(d, _)| *d >= diameter - SAME && *d - diameter <= TURNED)
        .min_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, pitch)| pitch)
}

impl Default for Undercuts {
    fn default() -> Undercuts {
        let index = |r: f64, t: f64| DIN_509.iter().position(|size| size.radius == r && size.depth == t);
        Undercuts {
            sizes: DIN_509.to_vec(),
            by_diameter: BY_DIAMETER.iter().filter_map(|(upto, r, t)| Some((*upto, index(*r, *t)?))).collect(),
            threads: DIN_76.to_vec(),
            editor: SizeList { sizes: EDITOR.to_vec(), seen: Some(EDITOR_SEEN) },
            cycle: SizeList { sizes: CYCLE.to_vec(), seen: Some(CYCLE_SEEN) },
            thread_length: ThreadLength::default(),
            internal_depth: InternalDepth::default(),
        }
    }
}

impl Undercuts {
    /// The size r x t1.
    pub fn size(&self, radius: f64, depth: f64) -> Option<&Din509> {
        self.sizes.iter().find(|size| same_size(size, radius, depth))
    }

    /// The size at a place of the contour editor's list, and whether the place is confirmed.
    pub fn editor_size(&self, index: u32) -> Option<(&Din509, bool)> {
        self.listed(&self.editor, index)
    }

    /// The size at a place of CYCLE940's list, and whether the place is confirmed.
    pub fn cycle_size(&self, index: u32) -> Option<(&Din509, bool)> {
        self.listed(&self.cycle, index)
    }

    fn listed(&self, list: &SizeList, index: u32) -> Option<(&Din509, bool)> {
        let (radius, depth) = list.sizes.get(index as usize)?;
        Some((self.size(*radius, *depth)?, list.seen.is_none_or(|seen| seen == index)))
    }

    /// The size for a diameter of the cylinder.
    pub fn size_for(&self, diameter: f64) -> Option<&Din509> {
        let (_, index) = self.by_diameter.iter().find(|(upto, _)| diameter > 0.0 && diameter <= *upto)?;
        self.sizes.get(*index)
    }

    pub fn thread(&self, pitch: f64) -> Option<&Din76> {
        self.threads.iter().find(|row| (row.pitch - pitch).abs() <= SAME)
    }

    /// The pitch of the table that is nearest to `pitch`.
    pub fn nearest_pitch(&self, pitch: f64) -> Option<f64> {
        self.threads.iter().map(|row| row.pitch).min_by(|a, b| (a - pitch).abs().total_cmp(&(b - pitch).abs()))
    }

    /// All sizes of forms E and F, by radius and depth.
    pub fn sizes(&self) -> &[Din509] {
        &self.sizes
    }

    /// All thread pitches, in order.
    pub fn threads(&self) -> &[Din76] {
        &self.threads
    }

    /// Takes a key of `[undercut]`.
    ///
    /// # Errors
    /// A value that does not fit.
    pub(super) fn set(&mut self, name: &str, node: &Node) -> Result<(), ConfigError> {
        match (name, &node.value) {
            ("thread_length", Value::Text(text)) => {
                self.thread_length = match text.as_str() {
                    "shortest" => ThreadLength::Shortest,
                    "longest" => ThreadLength::Longest,
                    _ => ThreadLength::Middle,
                }
            }
            ("internal_depth", Value::Text(text)) => {
                self.internal_depth = if text == "bore" { InternalDepth::Bore } else { InternalDepth::Core };
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
            ("din509_in_editor", Value::List(items)) => self.editor = self.size_list(items)?,
            ("din509_in_cycle", Value::List(items)) => self.cycle = self.size_list(items)?,
            _ => return Err(node.fail(format!("`{name}` has no place in [undercut]"))),
        }
        Ok(())
    }

    fn set_size(&mut self, name: &str, node: &Node) -> Result<(), ConfigError> {
        let fail = || node.fail("a size is its radius and its depth: \"0.6x0.3\" = { f = 2.5, t2 = 0.2 }");
        let (radius, depth) = radius_and_depth(name).ok_or_else(fail)?;
        let Value::Table(values) = &node.value else { return Err(fail()) };
        let index = match self.sizes.iter().position(|size| same_size(size, radius, depth)) {
            Some(index) => index,
            None => {
                for needed in ["f", "t2"] {
                    if !values.contains_key(needed) {
                        return Err(node.fail(format!("a new size needs `{needed}`")));
                    }
                }
                // New sizes go to the end, so that what refers to others by index keeps its meaning.
                self.sizes.push(size(radius, depth, 0.0, 0.0));
                self.sizes.len() - 1
            }
        };
        let Some(row) = self.sizes.get_mut(index) else { return Err(fail()) };
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
    fn size_list(&self, items: &[Node]) -> Result<SizeList, ConfigError> {
        let mut sizes = Vec::with_capacity(items.len());
        for node in items {
            let known = match &node.value {
                Value::Text(text) => radius_and_depth(text).filter(|(r, t)| self.size(*r, *t).is_some()),
                _ => None,
            };
            sizes.push(known.ok_or_else(|| node.fail("needs a size of DIN 509 such as \"0.6x0.3\""))?);
        }
        Ok(SizeList { sizes, seen: None })
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
            let index = match &node.value {
                Value::Text(text) => {
                    radius_and_depth(text).and_then(|(r, t)| self.sizes.iter().position(|size| same_size(size, r, t)))
                }
                _ => None,
            };
            list.push((upto, index.ok_or_else(|| node.fail("needs a size of DIN 509 such as \"0.6x0.3\""))?));
        }
        list.sort_by(|a, b| a.0.total_cmp(&b.0));
        self.by_diameter = list;
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
                self.threads
                    .insert(index, thread(pitch, 0.0, (0.0, 0.0), (0.0, 0.0), 0.0, 0.0, (0.0, 0.0), (0.0, 0.0)));
                index
            }
        };
        let Some(row) = self.threads.get_mut(index) else { return Err(fail()) };
        for (key, node) in values {
            match key.as_str() {
                "external" => row.external = positive(node)?,
                "internal" => row.internal = positive(node)?,
                "r" => row.radius = positive(node)?,
                "a" => row.a = lengths(node)?,
                "b" => row.b = lengths(node)?,
                "c" => row.c = lengths(node)?,
                "d" => row.d = lengths(node)?,
                _ => {
                    let known = "external, a, b, r, internal, c, d";
                    return Err(node.fail(format!("unknown key `{key}`; a thread undercut has {known}")));
                }
            }
        }
        Ok(())
    }
}

fn same_size(size: &Din509, radius: f64, depth: f64) -> bool {
    (size.radius - radius).abs() <= SAME && (size.depth - depth).abs() <= SAME
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
        let by = |d: f64| tables.size_for(d).map(|s| (s.radius, s.depth));
        assert_eq!(by(1.6), Some((0.1, 0.1)));
        assert_eq!(by(10.0), Some((0.4, 0.2)));
        assert_eq!(by(18.0), Some((0.6, 0.2)));
        assert_eq!(by(18.001), Some((0.6, 0.3)));
        assert_eq!(by(500.0), Some((1.0, 0.4)));
        assert_eq!((by(0.0), by(-5.0)), (None, None));
        assert_eq!(tables.thread(2.5).map(|t| (t.external, t.a.g1, t.a.g2, t.radius)), Some((3.6, 5.6, 8.7, 1.2)));
        assert_eq!(tables.thread(2.6), None);
        assert_eq!(tables.nearest_pitch(2.6), Some(2.5));
        assert_eq!((coarse_pitch(20.0), coarse_pitch(19.9)), (Some(2.5), None));
        assert_eq!((proposed_pitch(19.8), proposed_pitch(20.0), proposed_pitch(21.0)), (Some(2.5), Some(2.5), None));
    }

    #[test]
    fn columns_grow_with_the_pitch() {
        for pair in DIN_76.windows(2) {
            let (p, q) = (&pair[0], &pair[1]);
            assert!(p.pitch < q.pitch && p.radius <= q.radius && p.external <= q.external && p.internal <= q.internal);
            for (a, b) in [(p.a, q.a), (p.b, q.b), (p.c, q.c), (p.d, q.d)] {
                assert!(a.g1 <= b.g1 && a.g2 < b.g2 && a.g1 < a.g2, "{p:?}");
            }
        }
        // g2 - g1 of A and B is the run-up under 30 degrees, within 0.2 mm; the one of C and D counts from the core.
        for row in DIN_76 {
            let run_up = row.external / 2.0 / libm::tan(30f64.to_radians());
            for l in [row.a, row.b] {
                assert!((l.g2 - l.g1 - run_up).abs() < 0.25, "{row:?} {run_up}");
            }
            let run_up = (row.internal + 1.08253 * row.pitch) / 2.0 / libm::tan(30f64.to_radians());
            for l in [row.c, row.d] {
                assert!((l.g2 - l.g1 - run_up).abs() < 0.95, "{row:?} {run_up}");
            }
        }
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
        assert_eq!(tables.size_for(19.0).map(|s| s.length), Some(3.0));
        assert_eq!(tables.size_for(21.0).map(|s| s.radius), Some(1.0));
        assert_eq!(tables.thread_length, ThreadLength::Shortest);
        assert_eq!(tables.internal_depth, InternalDepth::Bore);
    }

    #[test]
    fn sizes_are_named_by_their_place() {
        let place = |found: Option<(&Din509, bool)>| found.map(|(size, sure)| (size.radius, size.depth, sure));
        let tables = Undercuts::default();
        assert_eq!(place(tables.editor_size(4)), Some((0.6, 0.3, true)));
        assert_eq!(place(tables.editor_size(0)), Some((0.1, 0.1, false)));
        assert_eq!(place(tables.cycle_size(0)), Some((0.6, 0.3, true)));
        assert_eq!(place(tables.cycle_size(9)), Some((0.2, 0.1, false)));
        assert_eq!((place(tables.editor_size(10)), place(tables.cycle_size(10))), (None, None));
        let tables = read("din509_in_editor = ['0.8x0.3', '1.2x0.2']\ndin509_in_cycle = ['1.2x0.4']\n").unwrap();
        assert_eq!(place(tables.editor_size(1)), Some((1.2, 0.2, true)));
        assert_eq!((place(tables.editor_size(2)), place(tables.cycle_size(0))), (None, Some((1.2, 0.4, true))));
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
