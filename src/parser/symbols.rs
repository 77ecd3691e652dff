//! Names as small numbers, upper and lower case alike.

use rustc_hash::FxHashMap;

/// A name that was met.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct Symbol(pub u32);

/// All names that were met in a run.
#[derive(Debug, Default)]
pub struct Symbols {
    names: Vec<Box<str>>,
    known: FxHashMap<Box<str>, Symbol>,
}

/// Longest name in bytes that is looked up without allocating.
const SHORT: usize = 64;

impl Symbols {
    /// The symbol of a name in any case.
    pub fn intern(&mut self, name: &[u8]) -> Symbol {
        let mut buffer = [0; SHORT];
        if name.len() <= SHORT && name.is_ascii() {
            let upper = &mut buffer[..name.len()];
            upper.copy_from_slice(name);
            upper.make_ascii_uppercase();
            if let Some(&symbol) = std::str::from_utf8(upper).ok().and_then(|text| self.known.get(text)) {
                return symbol;
            }
        }
        let text: Box<str> = String::from_utf8_lossy(name).to_ascii_uppercase().into();
        if let Some(&symbol) = self.known.get(&text) {
            return symbol;
        }
        let symbol = Symbol(u32::try_from(self.names.len()).unwrap_or(u32::MAX));
        self.names.push(text.clone());
        self.known.insert(text, symbol);
        symbol
    }

    /// The symbol of an upper-case name, if it was met.
    pub fn find(&self, name: &str) -> Option<Symbol> {
        self.known.get(name).copied()
    }

    /// The name, in upper case.
    pub fn name(&self, symbol: Symbol) -> &str {
        self.names.get(symbol.0 as usize).map_or("", |name| name)
    }

    pub fn len(&self) -> usize {
        self.names.len()
    }

    pub fn is_empty(&self) -> bool {
        self.names.is_empty()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn case_does_not_matter() {
        let mut symbols = Symbols::default();
        let a = symbols.intern(b"Depth_1");
        assert_eq!(symbols.intern(b"DEPTH_1"), a);
        assert_eq!(symbols.name(a), "DEPTH_1");
        assert_ne!(symbols.intern(b"DEPTH_2"), a);
        let long = symbols.intern(&[b'a'; 100]);
        assert_eq!(symbols.intern(&[b'A'; 100]), long);
    }
}
