//! Into how many parts a way is divided.

/// What a way may be longer than n parts without one part more, in mm: the error of sums, of formulas and of values in
/// inches. Far below what any target prints, and far below what any tool cuts.
pub const NOTHING: f64 = 1e-6;

/// The same for parts of this size: of tiny ones, a thousandth of a part.
fn slack(most: f64) -> f64 {
    NOTHING.min(most.abs() * 1e-3)
}

/// How many parts of at most `most` make up `way`; 0 for no way. A whole number, as a float: what is too large for an
/// integer is still larger than any limit.
pub fn count(way: f64, most: f64) -> f64 {
    libm::ceil(((way - slack(most)) / most).max(0.0))
}

/// How many cuts of equal cross-section make up `depth` if the first one is `first` deep: cut n ends at `first` · √n.
pub fn count_of_areas(depth: f64, first: f64) -> f64 {
    let cuts = (depth - slack(first)).max(0.0) / first;
    libm::ceil(cuts * cuts)
}

/// How many whole parts of `most` fit into `way`, and what is left over; 0 where nothing is.
pub fn whole(way: f64, most: f64) -> (f64, f64) {
    let whole = libm::floor((way + slack(most)) / most);
    let left = way - whole * most;
    (whole, if left > slack(most) { left } else { 0.0 })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_way_that_is_whole_parts_but_for_the_error_of_its_numbers_has_none_more() {
        let parts = |way| (count(way, 2.0), whole(way, 2.0));
        assert_eq!(parts(6.0), (3.0, (3.0, 0.0)));
        assert_eq!(parts(6.000_000_9), (3.0, (3.0, 0.0)));
        assert_eq!(parts(5.999_999_1), (3.0, (3.0, 0.0)));
        assert_eq!(count(6.000_002, 2.0), 4.0);
        let (parts, left) = whole(6.000_002, 2.0);
        assert!(parts == 3.0 && (left - 2e-6).abs() < 1e-12);
        assert_eq!(count(0.92, 1e-6), 920_000.0);
        assert_eq!((count(0.0, 2.0), count(1e-7, 2.0), count(0.9, 0.3)), (0.0, 0.0, 3.0));
    }
}
