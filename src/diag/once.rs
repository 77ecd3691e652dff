//! What is told once: not once a code, but once a fact. A second tool with another oversize is another fact.

use std::hash::{BuildHasher, Hash};

use rustc_hash::{FxBuildHasher, FxHashMap, FxHashSet};

/// Facts that a code lists in one run; more are counted.
pub const LISTED: usize = 20;
/// So many are told apart.
const COUNTED: usize = 10_000;

/// The facts of each code that were told.
#[derive(Debug, Default)]
pub struct Once(FxHashMap<&'static str, FxHashSet<u64>>);

impl Once {
    /// Is `fact` new to `code`, and one of those that are listed?
    pub fn is_first(&mut self, code: &'static str, fact: impl Hash) -> bool {
        let facts = self.0.entry(code).or_default();
        facts.len() < COUNTED && facts.insert(FxBuildHasher.hash_one(fact)) && facts.len() <= LISTED
    }

    /// Facts of `code` that are not listed, and whether there may be more.
    pub fn unlisted(&self, code: &'static str) -> Option<(usize, bool)> {
        let told = self.0.get(code).map_or(0, FxHashSet::len);
        (told > LISTED).then(|| (told - LISTED, told == COUNTED))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fact_is_told_once_and_many_are_counted() {
        let mut told = Once::default();
        assert!(told.is_first("K2011", "DL 0.5"));
        assert!(!told.is_first("K2011", "DL 0.5"));
        assert!(told.is_first("K2011", "DL -0.8"));
        assert!(told.is_first("P2005", "DL 0.5"));
        let listed = (0..100_000).filter(|fact| told.is_first("S8044", fact)).count();
        assert_eq!((listed, told.unlisted("S8044")), (LISTED, Some((COUNTED - LISTED, true))));
        assert_eq!(told.unlisted("K2011"), None);
    }
}
