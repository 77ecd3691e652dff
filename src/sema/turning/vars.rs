//! Variables: those of the whole run, and those of each program level.

use std::collections::BTreeMap;

use rustc_hash::FxHashMap;

use crate::lexer::turning::{VarKind, VarRef};
use crate::sema::value::{Machine, Rules};

/// No manual says which way a negative number is cut off, or a half is rounded. Results beyond 10¹² are no value of a
/// part program.
const RULES: Rules =
    Rules { result: 1e12, exponents: 100.0, cuts_negative: false, rounds_halves: false, ..Rules::USUAL };

/// A value, and the level of calls on which it was assigned.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Slot {
    /// `None`: its computation failed and was reported.
    pub value: Option<f64>,
    /// Number of the level; 0 for start values, which hold everywhere.
    pub level: u32,
}

/// The variables that every program sees.
#[derive(Debug)]
pub(super) struct Vars {
    slots: FxHashMap<VarRef, Slot>,
    /// Program levels so far, the main program included.
    levels: u32,
    pub machine: Machine,
}

/// Variables and arguments of one program level.
pub(super) type Locals = FxHashMap<VarRef, Option<f64>>;

impl Vars {
    /// Variables with the start values of the configuration.
    pub fn new(start: &BTreeMap<String, f64>) -> Vars {
        let mut vars = Vars { slots: FxHashMap::default(), levels: 1, machine: Machine::new(RULES) };
        for (name, &value) in start {
            if let Some(var) = named(name) {
                vars.slots.insert(var, Slot { value: Some(value), level: 0 });
            }
        }
        vars
    }

    pub fn get(&self, var: VarRef) -> Option<Slot> {
        self.slots.get(&var).copied()
    }

    /// A number for a new level, which no level had before.
    pub fn next_level(&mut self) -> u32 {
        self.levels = self.levels.saturating_add(1);
        self.levels
    }

    pub fn set(&mut self, var: VarRef, value: Option<f64>, level: u32) {
        self.slots.insert(var, Slot { value, level });
    }
}

/// `#5`, `#G1`, `V901`
fn named(name: &str) -> Option<VarRef> {
    const KINDS: &[(&str, VarKind)] = &[
        ("#L", VarKind::Local),
        ("#C", VarKind::Channel),
        ("#G", VarKind::Global),
        ("#I", VarKind::Machine),
        ("#N", VarKind::Interpreter),
        ("#", VarKind::Hash),
        ("V", VarKind::Real),
    ];
    KINDS.iter().find_map(|(head, kind)| {
        let number = name.strip_prefix(head)?.parse().ok()?;
        Some(VarRef { kind: *kind, number })
    })
}
