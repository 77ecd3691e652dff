//! DIN 509: sizes of undercuts of forms E and F, and which size a diameter has.

use super::{SAME, Source};

/// Angle between the entry slope and the cylinder, degrees.
pub const ENTRY: f64 = 15.0;
/// Angle between the relief of the face and the face, form F, degrees.
pub const FACE: f64 = 8.0;

/// A size, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Size {
    /// r: both roundings.
    pub radius: f64,
    /// t1: depth in the cylinder.
    pub depth: f64,
    /// f: length on the cylinder.
    pub length: f64,
    /// t2: depth behind the face, form F.
    pub face_depth: f64,
    pub source: Source,
}

/// The size of diameters up to a limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Greatest diameter, mm.
    pub upto: f64,
    /// r and t1 of the size.
    pub size: (f64, f64),
    pub source: Source,
    /// What other sources have.
    pub otherwise: Option<&'static str>,
}

impl Size {
    /// Is it the size of this radius and depth?
    pub fn is(&self, (radius, depth): (f64, f64)) -> bool {
        (self.radius - radius).abs() <= SAME && (self.depth - depth).abs() <= SAME
    }
}

const fn size(radius: f64, depth: f64, length: f64, face_depth: f64, source: Source) -> Size {
    Size { radius, depth, length, face_depth, source }
}

/// r, t1, f, t2.
pub const SIZES: &[Size] = &[
    size(0.1, 0.1, 0.5, 0.1, Source::PILOT_4290_TABLES),
    size(0.2, 0.1, 1.0, 0.1, Source::DIN_509),
    size(0.4, 0.2, 2.0, 0.1, Source::DIN_509),
    size(0.6, 0.2, 2.0, 0.1, Source::DIN_509),
    size(0.6, 0.3, 2.5, 0.2, Source::DIN_509),
    size(0.8, 0.3, 2.5, 0.2, Source::DIN_509),
    size(1.0, 0.2, 2.5, 0.1, Source::DIN_509),
    size(1.0, 0.4, 4.0, 0.3, Source::DIN_509),
    size(1.2, 0.2, 2.5, 0.1, Source::DIN_509),
    size(1.2, 0.4, 4.0, 0.3, Source::DIN_509),
    size(1.6, 0.3, 4.0, 0.2, Source::DIN_509),
    size(2.5, 0.4, 5.0, 0.3, Source::DIN_509),
    size(4.0, 0.5, 7.0, 0.3, Source::DIN_509),
    // Not in the standard.
    size(0.2, 0.2, 2.0, 0.1, Source::PLUS_620_TABLES),
    size(0.6, 0.25, 2.0, 0.1, Source::PLUS_4110_G85),
    size(0.6, 0.35, 2.5, 0.2, Source::PLUS_4110_G85),
    size(1.0, 0.45, 4.0, 0.3, Source::PLUS_4110_G85),
];

const fn range(upto: f64, radius: f64, depth: f64, source: Source) -> Range {
    Range { upto, size: (radius, depth), source, otherwise: None }
}

const fn disputed(upto: f64, radius: f64, depth: f64, source: Source, otherwise: &'static str) -> Range {
    Range { upto, size: (radius, depth), source, otherwise: Some(otherwise) }
}

/// Normal load. Where DIN 509 names two sizes for a range, the one HEIDENHAIN lists; what other controls take is not
/// published.
pub const NORMAL: &[Range] = &[
    range(1.6, 0.1, 0.1, Source::DIN_509),
    range(3.0, 0.2, 0.1, Source::DIN_509),
    range(10.0, 0.4, 0.2, Source::DIN_509),
    disputed(18.0, 0.6, 0.2, Source::PILOT_4290_TABLES, "DIN 509 has 0.4 x 0.2 as well"),
    disputed(80.0, 0.6, 0.3, Source::PILOT_4290_TABLES, "DIN 509 has 0.8 x 0.3 as well"),
    disputed(f64::INFINITY, 1.0, 0.4, Source::PILOT_4290_TABLES, "DIN 509 has 1.2 x 0.4 as well"),
];

/// The table of the HEIDENHAIN lathe controls.
pub const HEIDENHAIN: &[Range] = &[
    range(1.6, 0.1, 0.1, Source::PLUS_620_TABLES),
    range(3.0, 0.2, 0.1, Source::PLUS_620_TABLES),
    // The first edition of CNC PILOT 4290 prints 0.4 for form F (p. 427) and 0.2 for form E.
    disputed(10.0, 0.2, 0.2, Source::PLUS_620_TABLES, "DIN 509 and CNC PILOT 4290, p. 427, have the radius 0.4"),
    range(18.0, 0.6, 0.2, Source::PLUS_620_TABLES),
    range(80.0, 0.6, 0.3, Source::PLUS_620_TABLES),
    range(f64::INFINITY, 1.0, 0.4, Source::PLUS_620_TABLES),
];

/// The coarser table of G85 of MANUALplus 4110: below 18, over 18 to 80, over 80; the limits themselves are in no row.
pub const PLUS_4110_G85: &[Range] = &[
    range(18.0, 0.6, 0.25, Source::PLUS_4110_G85),
    range(80.0, 0.6, 0.35, Source::PLUS_4110_G85),
    range(f64::INFINITY, 1.0, 0.45, Source::PLUS_4110_G85),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_range_has_its_size_and_ends_open() {
        for table in [NORMAL, HEIDENHAIN, PLUS_4110_G85] {
            assert!(table.iter().all(|range| SIZES.iter().filter(|size| size.is(range.size)).count() == 1));
            assert!(table.windows(2).all(|pair| pair[0].upto < pair[1].upto));
            assert_eq!(table.last().map(|range| range.upto), Some(f64::INFINITY));
        }
    }

    /// What tables of different controls say of one range differs only where a row says so.
    #[test]
    fn tables_differ_only_where_a_row_says_so() {
        for (a, b) in NORMAL.iter().zip(HEIDENHAIN) {
            assert_eq!(a.upto, b.upto);
            assert!(a.size == b.size || a.otherwise.or(b.otherwise).is_some(), "{a:?} {b:?}");
        }
    }
}
