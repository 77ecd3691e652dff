//! DIN 76-1: undercuts of metric threads by their pitch.

use super::Source;

/// Angle between the entry slope and the cylinder, degrees.
pub const ENTRY: f64 = 30.0;

/// Shortest and longest length in the standard: g1 is the least length of the floor, g2 the greatest of all.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lengths {
    pub g1: f64,
    pub g2: f64,
}

/// Undercuts of a pitch, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
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
    /// Depths, radius and g2 of the normal forms. g1 and the short forms have a single source, the standard.
    pub source: Source,
    /// What other sources have of `internal`.
    pub otherwise: Option<&'static str>,
}

impl Row {
    /// A row to be filled.
    pub const EMPTY: Row = row(0.0, 0.0, (0.0, 0.0), (0.0, 0.0), 0.0, 0.0, (0.0, 0.0), (0.0, 0.0));
}

type Pair = (f64, f64);

#[allow(clippy::too_many_arguments)]
const fn row(pitch: f64, external: f64, a: Pair, b: Pair, radius: f64, internal: f64, c: Pair, d: Pair) -> Row {
    const fn lengths(pair: Pair) -> Lengths {
        Lengths { g1: pair.0, g2: pair.1 }
    }
    let (source, otherwise) = (Source::PILOT_4290_TABLES, None);
    Row {
        pitch,
        external,
        a: lengths(a),
        b: lengths(b),
        radius,
        internal,
        c: lengths(c),
        d: lengths(d),
        source,
        otherwise,
    }
}

const fn disputed(row: Row, source: Source, otherwise: &'static str) -> Row {
    Row { source, otherwise: Some(otherwise), ..row }
}

/// Pitch, d - dg, A, B, r, dg - D, C, D. MANUALplus 4110, p. 525, has the same of what CNC PILOT 4290 has.
#[rustfmt::skip]
pub const ROWS: &[Row] = &[
    row(0.2, 0.3, (0.45, 0.7), (0.25, 0.5), 0.1, 0.1, (0.8, 1.2), (0.5, 0.9)),
    row(0.25, 0.4, (0.55, 0.9), (0.25, 0.6), 0.12, 0.1, (1.0, 1.4), (0.6, 1.0)),
    row(0.3, 0.5, (0.6, 1.05), (0.3, 0.75), 0.16, 0.1, (1.2, 1.6), (0.75, 1.25)),
    row(0.35, 0.6, (0.7, 1.2), (0.4, 0.9), 0.16, 0.2, (1.4, 1.9), (0.9, 1.4)),
    row(0.4, 0.7, (0.8, 1.4), (0.5, 1.0), 0.2, 0.2, (1.6, 2.2), (1.0, 1.6)),
    disputed(
        row(0.45, 0.7, (1.0, 1.6), (0.5, 1.1), 0.2, 0.2, (1.8, 2.4), (1.1, 1.7)),
        Source::DIN_76, "MANUALplus 4110, p. 525, has D + 0.3",
    ),
    row(0.5, 0.8, (1.1, 1.75), (0.5, 1.25), 0.2, 0.3, (2.0, 2.7), (1.25, 2.0)),
    row(0.6, 1.0, (1.2, 2.1), (0.6, 1.5), 0.4, 0.3, (2.4, 3.3), (1.5, 2.4)),
    row(0.7, 1.1, (1.5, 2.45), (0.8, 1.75), 0.4, 0.3, (2.8, 3.8), (1.75, 2.75)),
    row(0.75, 1.2, (1.6, 2.6), (0.9, 1.9), 0.4, 0.3, (3.0, 4.0), (1.9, 2.9)),
    row(0.8, 1.3, (1.7, 2.8), (0.9, 2.0), 0.4, 0.3, (3.2, 4.2), (2.0, 3.0)),
    row(1.0, 1.6, (2.1, 3.5), (1.1, 2.5), 0.6, 0.5, (4.0, 5.2), (2.5, 3.7)),
    row(1.25, 2.0, (2.7, 4.4), (1.5, 3.2), 0.6, 0.5, (5.0, 6.7), (3.2, 4.9)),
    row(1.5, 2.3, (3.2, 5.2), (1.8, 3.8), 0.8, 0.5, (6.0, 7.8), (3.8, 5.6)),
    row(1.75, 2.6, (3.9, 6.1), (2.1, 4.3), 1.0, 0.5, (7.0, 9.1), (4.3, 6.4)),
    row(2.0, 3.0, (4.5, 7.0), (2.5, 5.0), 1.0, 0.5, (8.0, 10.3), (5.0, 7.3)),
    row(2.5, 3.6, (5.6, 8.7), (3.2, 6.3), 1.2, 0.5, (10.0, 13.0), (6.3, 9.3)),
    row(3.0, 4.4, (6.7, 10.5), (3.7, 7.5), 1.6, 0.5, (12.0, 15.2), (7.5, 10.7)),
    row(3.5, 5.0, (7.7, 12.0), (4.7, 9.0), 1.6, 0.5, (14.0, 17.7), (9.0, 12.7)),
    row(4.0, 5.7, (9.0, 14.0), (5.0, 10.0), 2.0, 0.5, (16.0, 20.0), (10.0, 14.0)),
    row(4.5, 6.4, (10.5, 16.0), (5.5, 11.0), 2.0, 0.5, (18.0, 23.0), (11.0, 16.0)),
    row(5.0, 7.0, (11.5, 17.5), (6.5, 12.5), 2.5, 0.5, (20.0, 26.0), (12.5, 18.5)),
    row(5.5, 7.7, (12.5, 19.0), (7.5, 14.0), 3.2, 0.5, (22.0, 28.0), (14.0, 20.0)),
    row(6.0, 8.3, (14.0, 21.0), (8.0, 15.0), 3.2, 0.5, (24.0, 30.0), (15.0, 21.0)),
];

#[cfg(test)]
mod tests {
    use super::super::din13::CORE;
    use super::*;

    #[test]
    fn columns_grow_with_the_pitch() {
        for pair in ROWS.windows(2) {
            let (p, q) = (&pair[0], &pair[1]);
            assert!(p.pitch < q.pitch && p.radius <= q.radius && p.external <= q.external && p.internal <= q.internal);
            for (a, b) in [(p.a, q.a), (p.b, q.b), (p.c, q.c), (p.d, q.d)] {
                assert!(a.g1 <= b.g1 && a.g2 < b.g2 && a.g1 < a.g2, "{p:?}");
            }
        }
        // g2 - g1 of A and B is the run-up under 30 degrees, within 0.2 mm; the one of C and D counts from the core.
        for row in ROWS {
            let run_up = row.external / 2.0 / libm::tan(ENTRY.to_radians());
            for l in [row.a, row.b] {
                assert!((l.g2 - l.g1 - run_up).abs() < 0.25, "{row:?} {run_up}");
            }
            let run_up = (row.internal + CORE * row.pitch) / 2.0 / libm::tan(ENTRY.to_radians());
            for l in [row.c, row.d] {
                assert!((l.g2 - l.g1 - run_up).abs() < 0.95, "{row:?} {run_up}");
            }
        }
    }
}
