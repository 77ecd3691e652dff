//! Variables: those of the whole run, and those of each program level.

use std::collections::BTreeMap;

use rustc_hash::FxHashMap;

use crate::lexer::turning::{VarKind, VarRef};

/// A value, and the level of calls on which it was assigned.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Slot {
    /// `None`: its computation failed and was reported.
    pub value: Option<f64>,
    /// Number of the level; 0 for start values, which hold everywhere.
    pub level: u32,
}

/// The variables that every program sees.
#[derive(Debug, Default)]
pub(super) struct Vars {
    slots: FxHashMap<VarRef, Slot>,
}

/// Variables and arguments of one program level.
pub(super) type Locals = FxHashMap<VarRef, Option<f64>>;

impl Vars {
    /// Variables with the start values of the configuration.
    pub fn new(start: &BTreeMap<String, f64>) -> Vars {
        let mut vars = Vars::default();
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
