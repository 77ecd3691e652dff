//! How a depth is divided into cuts.

use crate::diag::{Fault, codes};
use crate::geo::parts;
use crate::ir::cycle::thread::Infeed;

/// The depths of a series of cuts, each from the surface, increasing up to the whole depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Series {
    infeed: Infeed,
    depth: f64,
    cuts: u64,
    /// What `most` leaves over, for the series that begin with it; 0 if nothing.
    rest: f64,
}

impl Series {
    /// The series for `depth`; all arguments are over 0.
    pub fn new(infeed: Infeed, depth: f64) -> Series {
        let mut rest = 0.0;
        let cuts = match infeed {
            Infeed::ConstantArea { first } => parts::count_of_areas(depth, first),
            Infeed::Equal { most } => parts::count(depth, most),
            Infeed::RemainderSplit { most } | Infeed::Remainder { most } => {
                let (whole, left) = parts::whole(depth, most);
                rest = left;
                let split = if matches!(infeed, Infeed::RemainderSplit { .. }) && whole > 0.0 { 3.0 } else { 0.0 };
                whole + split + if rest > 0.0 { 1.0 } else { 0.0 }
            }
            Infeed::AreaPasses { passes } | Infeed::EqualPasses { passes } => f64::from(passes),
        };
        // A float that is too large for u64 becomes the greatest one, which no budget allows.
        Series { infeed, depth, cuts: (cuts as u64).max(1), rest }
    }

    /// Number of cuts.
    pub fn cuts(&self) -> u64 {
        self.cuts
    }

    /// Depth of cut `k`, counted from 1.
    pub fn depth(&self, k: u64) -> f64 {
        if k >= self.cuts {
            return self.depth;
        }
        let nth = k as f64;
        let of = self.cuts as f64;
        let depth = match self.infeed {
            Infeed::ConstantArea { first } => first * nth.sqrt(),
            Infeed::Equal { .. } | Infeed::EqualPasses { .. } => self.depth * nth / of,
            Infeed::AreaPasses { .. } => self.depth * (nth / of).sqrt(),
            Infeed::Remainder { most } => self.rest + most * (nth - self.lead_in()),
            Infeed::RemainderSplit { most } => {
                // The last four cuts are 1/2, 1/4, 1/8 and 1/8 of `most`.
                match self.cuts - k {
                    1 => self.depth - most / 8.0,
                    2 => self.depth - most / 4.0,
                    3 => self.depth - most / 2.0,
                    _ => self.rest + most * (nth - self.lead_in()),
                }
            }
        };
        depth.min(self.depth)
    }

    /// Cuts before the whole ones.
    fn lead_in(&self) -> f64 {
        if self.rest > 0.0 { 1.0 } else { 0.0 }
    }
}

/// Number of equal steps of at most `most` that make up `depth`; 0 for no depth.
pub fn steps(depth: f64, most: f64) -> u64 {
    parts::count(depth, most) as u64
}

/// Place after `k` of `steps` equal steps from one place to another; the end is exact.
pub fn place(from: f64, to: f64, k: u64, steps: u64) -> f64 {
    if k >= steps { to } else { from + (to - from) * (k as f64 / steps as f64) }
}

/// Ends of the equal cuts of at most `most` from one height to another, one at least.
///
/// # Errors
/// G3040 more than `limit` cuts.
pub fn heights(from: f64, to: f64, most: f64, limit: u64) -> Result<impl Iterator<Item = f64>, Fault> {
    let cuts = steps(from - to, most).max(1);
    if cuts > limit {
        return Err(codes::G3040::infeed_makes_cuts(&cuts, &limit));
    }
    Ok((1..=cuts).map(move |k| place(from, to, k, cuts)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn depths(infeed: Infeed, depth: f64) -> Vec<f64> {
        let series = Series::new(infeed, depth);
        (1..=series.cuts()).map(|k| series.depth(k)).collect()
    }

    /// Diameters of an M20 to four decimals.
    fn diameters(infeed: Infeed, depth: f64) -> Vec<f64> {
        depths(infeed, depth).iter().map(|d| ((20.0 - 2.0 * d) * 1e4).round() / 1e4).collect()
    }

    #[test]
    fn constant_area_as_computed_by_hand() {
        let expected = [19.4, 19.1515, 18.9608, 18.8, 18.6584, 18.5303, 18.4125, 18.3029, 18.2, 18.16];
        assert_eq!(diameters(Infeed::ConstantArea { first: 0.3 }, 0.92), expected);
    }

    #[test]
    fn equal_cuts_as_computed_by_hand() {
        assert_eq!(diameters(Infeed::Equal { most: 0.3 }, 0.92), [19.54, 19.08, 18.62, 18.16]);
        assert_eq!(depths(Infeed::Equal { most: 0.4 }, 1.2).len(), 3);
        assert_eq!(depths(Infeed::Equal { most: 0.3 }, 0.9).len(), 3);
    }

    #[test]
    fn remainder_and_split_as_computed_by_hand() {
        let split = [19.96, 19.36, 18.76, 18.46, 18.31, 18.235, 18.16];
        assert_eq!(diameters(Infeed::RemainderSplit { most: 0.3 }, 0.92), split);
        assert_eq!(diameters(Infeed::Remainder { most: 0.3 }, 0.92), [19.96, 19.36, 18.76, 18.16]);
        // No remainder: three whole cuts, the last one split.
        assert_eq!(depths(Infeed::RemainderSplit { most: 0.3 }, 0.9).len(), 6);
        assert_eq!(depths(Infeed::Remainder { most: 0.3 }, 0.9).len(), 3);
        // The infeed is deeper than the thread: one cut, nothing to split.
        assert_eq!(depths(Infeed::RemainderSplit { most: 2.0 }, 0.92), [0.92]);
    }

    #[test]
    fn a_depth_that_is_whole_infeeds_but_for_the_last_bits_has_no_cut_of_nothing() {
        for infeed in [
            Infeed::Equal { most: 0.25 },
            Infeed::Remainder { most: 0.25 },
            Infeed::RemainderSplit { most: 0.25 },
            Infeed::ConstantArea { first: 0.25 },
        ] {
            let exact = depths(infeed, 0.75);
            for off in [-9e-7, -1e-8, 1e-8, 9e-7] {
                let near = depths(infeed, 0.75 + off);
                assert_eq!(near.len(), exact.len(), "{infeed:?} {off}");
                assert!(near.iter().zip(&exact).all(|(a, b)| (a - b).abs() < 1.1e-6), "{infeed:?} {off} {near:?}");
            }
        }
    }

    #[test]
    fn numbered_passes_as_computed_by_hand() {
        let area = depths(Infeed::AreaPasses { passes: 5 }, 0.87);
        let expected = [0.3891, 0.5502, 0.6739, 0.7782, 0.87];
        assert!(area.iter().zip(expected).all(|(a, b)| (a - b).abs() < 5e-5), "{area:?}");
        let equal = depths(Infeed::EqualPasses { passes: 5 }, 0.87);
        let expected = [0.174, 0.348, 0.522, 0.696, 0.87];
        assert!(equal.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{equal:?}");
    }

    #[test]
    fn steps_are_whole() {
        assert_eq!((steps(5.8, 2.0), steps(6.0, 2.0), steps(0.0, 2.0), steps(11.0, 3.0)), (3, 3, 0, 4));
    }

    fn infeed() -> impl Strategy<Value = Infeed> {
        prop_oneof![
            (0.01f64..3.0).prop_map(|first| Infeed::ConstantArea { first }),
            (0.01f64..3.0).prop_map(|most| Infeed::Equal { most }),
            (0.01f64..3.0).prop_map(|most| Infeed::RemainderSplit { most }),
            (0.01f64..3.0).prop_map(|most| Infeed::Remainder { most }),
            (1u32..60).prop_map(|passes| Infeed::AreaPasses { passes }),
            (1u32..60).prop_map(|passes| Infeed::EqualPasses { passes }),
        ]
    }

    proptest! {
        #[test]
        fn cuts_go_deeper_and_add_up_to_the_depth(infeed in infeed(), depth in 0.05f64..4.0) {
            let depths = depths(infeed, depth);
            prop_assert_eq!(depths.last(), Some(&depth));
            let mut last = 0.0;
            let mut sum = 0.0;
            for d in &depths {
                prop_assert!(*d > last && *d <= depth, "{depths:?}");
                sum += d - last;
                last = *d;
            }
            prop_assert!((sum - depth).abs() < 1e-9);
        }

        #[test]
        fn no_cut_is_over_the_infeed(infeed in infeed(), depth in 0.05f64..4.0) {
            let (Infeed::ConstantArea { first: most } | Infeed::Equal { most } | Infeed::RemainderSplit { most } | Infeed::Remainder { most }) = infeed else { return Ok(()) };
            let mut last = 0.0;
            for d in depths(infeed, depth) {
                prop_assert!(d - last <= most + parts::NOTHING + 1e-9);
                last = d;
            }
        }

        #[test]
        fn cross_sections_are_equal(first in 0.02f64..1.0, depth in 0.05f64..3.0, passes in 1u32..60) {
            let areas = |infeed| {
                let mut last = 0.0;
                depths(infeed, depth).iter().map(|d| { let a = d * d - last * last; last = *d; a }).collect::<Vec<_>>()
            };
            let clipped = areas(Infeed::ConstantArea { first });
            let (rest, whole) = clipped.split_last().expect("a cut");
            prop_assert!(whole.iter().all(|a| (a - first * first).abs() < 1e-9));
            // The last cut takes what is nothing by itself, as in `no_cut_is_over_the_infeed`.
            prop_assert!(*rest <= first * first + 2.0 * depth * parts::NOTHING + 1e-9);
            let all = areas(Infeed::AreaPasses { passes });
            prop_assert!(all.iter().all(|a| (a - all[0]).abs() < 1e-9));
        }
    }
}
