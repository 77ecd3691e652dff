//! Variables: R parameters, DEF in programs, definition files.
//!
//! Source: S 5.1 (docs/sources.md).

use std::rc::Rc;

use std::collections::{BTreeMap, BTreeSet};

use rustc_hash::{FxHashMap, FxHashSet};

use crate::parser::sinumerik::ast::{Base, Target, TypeName};
use crate::parser::symbols::{Symbol, Symbols};
use crate::text::Loc;

use super::value::{MOST_R, Val};

/// Most elements of an array.
pub(super) const MOST_ELEMENTS: u32 = 32_767;
/// Elements of all variables together.
const MOST_VALUES: usize = 4_000_000;

/// Number of a variable.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct VarId(u32);

/// A declared variable.
#[derive(Debug, Clone)]
pub(super) struct Var {
    pub kind: TypeName,
    /// Sizes of an array; empty for a single value.
    pub sizes: Vec<u32>,
    pub values: Vec<Val>,
    /// Longest text of a STRING.
    pub length: usize,
    pub defined: Loc,
    /// The value could not be computed, which was reported.
    pub lost: bool,
    /// Elements whose value is the control's own.
    pub kept: Kept,
    /// LLI and ULI.
    pub limits: [Option<f64>; 2],
}

/// Elements of a variable whose values the control keeps; of a variable of the program none.
#[derive(Debug, Clone, Default)]
pub(super) struct Kept {
    /// The variable of the definition files, also where a parameter stands for it.
    name: Option<Symbol>,
    /// Elements that the program or the configuration gave a value.
    known: BTreeSet<usize>,
}

impl Kept {
    /// All elements of the global variable `name`.
    pub fn of_global(name: Symbol) -> Kept {
        Kept { name: Some(name), known: BTreeSet::new() }
    }

    /// The element has a value from now on.
    pub fn knows(&mut self, element: usize) {
        if self.name.is_some() {
            self.known.insert(element);
        }
    }

    /// The variable, where nobody gave the element a value.
    pub fn open(&self, element: usize) -> Option<Symbol> {
        self.name.filter(|_| !self.known.contains(&element))
    }
}

/// Names of one program level.
#[derive(Debug, Default, Clone)]
pub(super) struct Scope {
    names: FxHashMap<Symbol, VarId>,
    /// Variables that end with the level.
    first: usize,
    /// Parameters of the program, and the variables behind them: what a further pass keeps.
    parameters: Option<(FxHashMap<Symbol, VarId>, usize)>,
}

/// All variables of a run.
#[derive(Debug, Default, Clone)]
pub(super) struct Vars {
    r: Vec<f64>,
    r_set: FxHashSet<u32>,
    r_lost: FxHashSet<u32>,
    arena: Vec<Var>,
    scopes: Vec<Scope>,
    global: FxHashMap<Symbol, Var>,
    /// What definition files define, as it starts.
    defined: Option<Rc<FxHashMap<Symbol, Var>>>,
    values: usize,
    /// Variables of the main program are seen in subprograms (MD 11120).
    pub main_visible: bool,
    pub said: Said,
}

/// What was said of variables that the program reads before it gives them a value.
#[derive(Debug, Default, Clone)]
pub(super) struct Said {
    pub r: FxHashSet<u32>,
    /// Elements of global variables.
    pub kept: FxHashSet<(Symbol, usize)>,
    /// Variables without a value that the formula at hand has read.
    pub unset: Vec<String>,
}

/// Where a variable stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Slot {
    Local(VarId),
    Global(Symbol),
}

/// A variable that a VAR parameter stands for.
#[derive(Debug, Clone, Copy)]
pub(super) enum Reference {
    Variable(Slot),
    Element(Slot, usize),
    R(u32),
}

/// An argument of a call.
#[derive(Debug, Clone)]
pub(super) struct Argument {
    pub value: Val,
    pub reference: Option<Reference>,
    pub loc: Loc,
}

impl Vars {
    pub fn new(start: &BTreeMap<String, f64>) -> Vars {
        let mut vars = Vars::default();
        for (name, value) in start {
            if let Some(n) = name.strip_prefix('R').and_then(|digits| digits.parse().ok())
                && n <= MOST_R
            {
                vars.set_r(n, *value);
            }
        }
        vars
    }

    /// An R parameter and whether it was ever set; `None` for a value that was lost.
    pub fn r(&self, n: u32) -> Option<(f64, bool)> {
        if self.r_lost.contains(&n) {
            return None;
        }
        match self.r.get(n as usize) {
            Some(value) => Some((*value, *value != 0.0 || self.r_set.contains(&n))),
            None => Some((0.0, false)),
        }
    }

    /// Sets an R parameter; `n` is at most [`MOST_R`].
    pub fn set_r(&mut self, n: u32, value: f64) {
        let at = n as usize;
        if self.r.len() <= at {
            self.r.resize(at + 1, 0.0);
        }
        self.r[at] = value;
        if value == 0.0 {
            self.r_set.insert(n);
        }
        if !self.r_lost.is_empty() {
            self.r_lost.remove(&n);
        }
    }

    pub fn lose_r(&mut self, n: u32) {
        self.r_lost.insert(n);
    }

    // Levels.

    pub fn enter(&mut self) {
        self.scopes.push(Scope { first: self.arena.len(), ..Scope::default() });
    }

    pub fn leave(&mut self) {
        if let Some(scope) = self.scopes.pop() {
            self.end_from(scope.first);
        }
    }

    fn end_from(&mut self, first: usize) {
        for var in self.arena.drain(first.min(self.arena.len())..) {
            self.values -= var.values.len().min(self.values);
        }
    }

    /// The variables of the current level so far are the parameters of its program.
    pub fn parameters_are_known(&mut self) {
        if let Some(scope) = self.scopes.last_mut() {
            scope.parameters = Some((scope.names.clone(), self.arena.len()));
        }
    }

    /// A further pass of the program: its parameters stay as they are, its other variables end.
    pub fn next_pass(&mut self) {
        let Some(scope) = self.scopes.last_mut() else { return };
        let (names, end) = scope.parameters.clone().unwrap_or((FxHashMap::default(), scope.first));
        scope.names = names;
        self.end_from(end);
    }

    pub fn find(&self, name: Symbol) -> Option<Slot> {
        if let Some(id) = self.scopes.last().and_then(|scope| scope.names.get(&name)) {
            return Some(Slot::Local(*id));
        }
        if self.main_visible
            && let Some(id) = self.scopes.first().and_then(|scope| scope.names.get(&name))
        {
            return Some(Slot::Local(*id));
        }
        self.global.contains_key(&name).then_some(Slot::Global(name))
    }

    /// Is it a variable of the main program?
    pub fn in_main(&self, name: Symbol) -> bool {
        self.scopes.first().is_some_and(|scope| scope.names.contains_key(&name))
    }

    /// A variable of this level only.
    pub fn of_level(&self, name: Symbol) -> Option<&Var> {
        let id = self.scopes.last()?.names.get(&name)?;
        self.arena.get(id.0 as usize)
    }

    pub fn get(&self, slot: Slot) -> Option<&Var> {
        match slot {
            Slot::Local(id) => self.arena.get(id.0 as usize),
            Slot::Global(name) => self.global.get(&name),
        }
    }

    pub fn get_mut(&mut self, slot: Slot) -> Option<&mut Var> {
        match slot {
            Slot::Local(id) => self.arena.get_mut(id.0 as usize),
            Slot::Global(name) => self.global.get_mut(&name),
        }
    }

    /// Makes a variable of the current level, or a global one; false when there are too many values.
    pub fn define(&mut self, name: Symbol, var: Var, global: bool) -> bool {
        if self.values + var.values.len() > MOST_VALUES {
            return false;
        }
        self.values += var.values.len();
        if global {
            self.global.insert(name, var);
            return true;
        }
        let id = VarId(self.arena.len() as u32);
        self.arena.push(var);
        if let Some(scope) = self.scopes.last_mut() {
            scope.names.insert(name, id);
        }
        true
    }

    /// Gives the variable in `slot` a second name in the current level: a VAR parameter.
    pub fn bind(&mut self, name: Symbol, slot: Slot) {
        if let (Slot::Local(id), Some(scope)) = (slot, self.scopes.last_mut()) {
            scope.names.insert(name, id);
        }
    }

    /// Names of the global variables.
    pub fn global_names(&self) -> FxHashSet<Symbol> {
        self.global.keys().copied().collect()
    }

    /// The definition files are read, which define what was not there `before`: it is there from now on, whatever is restored.
    pub fn definitions_end(&mut self, before: &FxHashSet<Symbol>) {
        let defined = self.global.iter().filter(|(name, _)| !before.contains(name));
        self.defined = Some(Rc::new(defined.map(|(name, var)| (*name, var.clone())).collect()));
    }

    /// Everything as it was, except that what was said is not said again, and that definition files are read once.
    pub fn restore(&mut self, before: Vars) {
        let (said, defined) = (std::mem::take(&mut self.said), self.defined.take());
        let met_within = defined.as_ref().filter(|_| before.defined.is_none()).cloned();
        *self = Vars { said, defined, ..before };
        for (name, var) in met_within.iter().flat_map(|defined| defined.iter()) {
            if self.global.contains_key(name) {
                continue;
            }
            self.values += var.values.len();
            self.global.insert(*name, var.clone());
        }
    }

    /// The variable whose name is one letter.
    pub fn letter(&self, letter: u8, symbols: &Symbols) -> Option<Slot> {
        let name = [letter];
        self.find(symbols.find(std::str::from_utf8(&name).ok()?)?)
    }

    /// The variable that `target` names, if it is not an R parameter.
    pub fn target(&self, target: Target, symbols: &Symbols) -> Option<Slot> {
        match target {
            Target::Numbered(b'R', ..) | Target::System(_) | Target::Indexed(Base::System(_), _) => None,
            Target::Numbered(_, _, name) | Target::Name(name) | Target::Indexed(Base::Name(name), _) => self.find(name),
            Target::Letter(letter) | Target::Indexed(Base::Letter(letter), _) => self.letter(letter, symbols),
        }
    }

    /// Names that can be seen, for suggestions.
    pub fn names(&self) -> impl Iterator<Item = Symbol> + '_ {
        self.scopes
            .iter()
            .rev()
            .take(1)
            .flat_map(|scope| scope.names.keys().copied())
            .chain(self.global.keys().copied())
    }
}

impl Var {
    /// A variable of one value, without limits.
    pub fn single(kind: TypeName, value: Val, length: usize, defined: Loc) -> Var {
        let (sizes, values) = (Vec::new(), vec![value]);
        Var { kind, sizes, values, length, defined, lost: false, kept: Kept::default(), limits: [None; 2] }
    }

    /// Offset of an element, row by row.
    pub fn offset(&self, indices: &[i32]) -> Option<usize> {
        if indices.len() != self.sizes.len() {
            return None;
        }
        let mut at = 0usize;
        for (&index, &size) in indices.iter().zip(&self.sizes) {
            let index = u32::try_from(index).ok().filter(|index| *index < size)?;
            at = at * size as usize + index as usize;
        }
        (at < self.values.len()).then_some(at)
    }
}
