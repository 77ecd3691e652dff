//! Metric threads: coarse pitches and thread depths of DIN 13-1, which ISO 261 has as well.

use super::SAME;

/// Core diameter of the nut: nominal diameter less this much of the pitch.
pub const CORE: f64 = 1.08253;
/// Depth of the thread by its pitch, of the bolt and of the nut.
pub const DEPTH: [f64; 2] = [0.613_43, 0.541_27];

/// How far a turned diameter may lie below the nominal one, in mm, for the pitch to be proposed.
const TURNED: f64 = 0.5;

/// Coarse pitch by nominal diameter, mm.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pitches_by_diameter() {
        assert_eq!((coarse_pitch(20.0), coarse_pitch(19.9)), (Some(2.5), None));
        assert_eq!((proposed_pitch(19.8), proposed_pitch(20.0), proposed_pitch(21.0)), (Some(2.5), Some(2.5), None));
    }

    #[test]
    fn pitches_grow_with_the_diameter() {
        let all: Vec<(f64, f64)> =
            COARSE.iter().flat_map(|(pitch, list)| list.iter().map(move |d| (*d, *pitch))).collect();
        assert!(all.windows(2).all(|pair| pair[0].0 < pair[1].0 && pair[0].1 <= pair[1].1));
    }
}
