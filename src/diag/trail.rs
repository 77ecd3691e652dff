//! Call paths: how the program came to a block, kept once per distinct path.

use std::cell::{Cell, RefCell};

use rustc_hash::FxHashMap;

use crate::text::Loc;

/// A chain of calls; 0 is the main program. Equal chains are equal numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct CallPath(u32);

/// Distinct paths kept. A program that calls in more ways loses the inner calls of its trails, nothing else.
const MOST_PATHS: usize = 1 << 18;

/// The table behind [`CallPath`]. It grows with call sites in the text, not with execution.
#[derive(Debug, Default)]
pub struct Trail {
    inner: RefCell<Inner>,
    /// Blocks that ran.
    steps: Cell<u64>,
    /// Does anybody want to know the values of variables?
    watched: Cell<bool>,
    assigned: RefCell<Vec<Assigned>>,
    /// The block that set a variable to zero last, by name, and how the program came to it.
    zeros: RefCell<FxHashMap<String, (Loc, CallPath)>>,
    returned: Cell<bool>,
}

/// Most assignments that are remembered.
pub const MOST_ASSIGNED: usize = 1 << 18;

/// A variable got a number.
#[derive(Debug, Clone, PartialEq)]
pub struct Assigned {
    /// The number of the block that ran, as [`Trail::steps`] counts.
    pub step: u64,
    /// The block that assigns.
    pub loc: Loc,
    pub name: String,
    pub value: f64,
}

#[derive(Debug, Default)]
struct Inner {
    links: Vec<(CallPath, Loc)>,
    known: FxHashMap<(CallPath, Loc), CallPath>,
}

impl CallPath {
    /// The main program.
    pub const MAIN: CallPath = CallPath(0);
}

impl Trail {
    /// A block runs.
    #[inline]
    pub fn step(&self) {
        self.steps.set(self.steps.get() + 1);
    }

    /// How many blocks have run, the last one included.
    pub fn steps(&self) -> u64 {
        self.steps.get()
    }

    /// From here on values of variables are remembered.
    pub fn watch_values(&self) {
        self.watched.set(true);
    }

    /// A variable gets a number.
    #[inline]
    pub fn assigns(&self, loc: Loc, call: CallPath, name: impl Fn() -> String, value: f64) {
        if value == 0.0 {
            self.is_zero(loc, call, name());
        }
        if self.watched.get() {
            let mut assigned = self.assigned.borrow_mut();
            if assigned.len() < MOST_ASSIGNED {
                assigned.push(Assigned { step: self.steps.get(), loc, name: name(), value });
            }
        }
    }

    #[cold]
    fn is_zero(&self, loc: Loc, call: CallPath, name: String) {
        let mut zeros = self.zeros.borrow_mut();
        if zeros.len() < MOST_ASSIGNED || zeros.contains_key(&name) {
            zeros.insert(name, (loc, call));
        }
    }

    /// The block that set the variable to zero last.
    pub fn zero_of(&self, name: &str) -> Option<(Loc, CallPath)> {
        self.zeros.borrow().get(name).copied()
    }

    /// A variable of this name begins.
    pub fn forget_zero(&self, name: &str) {
        self.zeros.borrow_mut().remove(name);
    }

    /// Variables get values that no block assigns: a call gives them back.
    pub fn returns(&self) {
        self.zeros.borrow_mut().clear();
        self.returned.set(true);
    }

    /// Did a call give values back?
    pub fn has_returned(&self) -> bool {
        self.returned.get()
    }

    /// What was assigned since [`Trail::watch_values`], in order.
    pub fn take_values(&self) -> Vec<Assigned> {
        self.assigned.take()
    }

    /// The path that follows `from` through the call at `site`.
    pub fn enter(&self, from: CallPath, site: Loc) -> CallPath {
        let inner = &mut *self.inner.borrow_mut();
        if let Some(&path) = inner.known.get(&(from, site)) {
            return path;
        }
        if inner.links.len() >= MOST_PATHS {
            return from;
        }
        inner.links.push((from, site));
        let path = CallPath(u32::try_from(inner.links.len()).unwrap_or(u32::MAX));
        inner.known.insert((from, site), path);
        path
    }

    /// The calls of a path, the innermost first.
    pub fn sites(&self, path: CallPath) -> Vec<Loc> {
        let inner = self.inner.borrow();
        let mut sites = Vec::new();
        let mut at = path;
        while at.0 > 0 {
            let Some(&(from, site)) = inner.links.get(at.0 as usize - 1) else { break };
            sites.push(site);
            at = from;
        }
        sites
    }
}
