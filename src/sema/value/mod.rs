//! The value machine: formulas in postfix order, computed the same way in all dialects.
//!
//! In: operations of a block. Out: a value, or a [`Fault`] that the dialect puts into its words and code. A dialect
//! brings its [`Rules`], where controls differ, and what only it can read: variables, names, calls. Nothing is
//! allocated while numbers are computed; the stack is kept from formula to formula.

mod divisor;
mod fault;
mod machine;
mod number;

pub use divisor::{Divisor, SetBy};
pub use fault::{Fault, Stop};
pub use machine::{At, Formulas, Machine, evaluate};
pub use number::{Modulo, Rules, noun};

use std::cmp::Ordering;
use std::rc::Rc;

/// Values of a kind that a dialect does not have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Never {}

/// A value of a formula; `A` names axes, `F` is a frame. Dialects without types have REALs and texts only.
#[derive(Debug, Clone, PartialEq)]
pub enum Val<A = Never, F = Never> {
    Int(i32),
    Real(f64),
    Bool(bool),
    Char(u8),
    Text(Rc<[u8]>),
    Axis(A),
    Frame(F),
    /// Several values in brackets.
    List(Rc<[Val<A, F>]>),
    /// An omitted argument.
    Missing,
}

impl<A: Clone + Ord, F: Clone> Val<A, F> {
    pub fn text(bytes: &[u8]) -> Self {
        Val::Text(bytes.into())
    }

    /// What the value is, for messages.
    pub fn what(&self) -> &'static str {
        match self {
            Val::Int(_) => "an INT",
            Val::Real(_) => "a REAL",
            Val::Bool(_) => "a BOOL",
            Val::Char(_) => "a CHAR",
            Val::Text(_) => "a text",
            Val::Axis(_) => "an axis",
            Val::Frame(_) => "a frame",
            Val::List(_) => "a list",
            Val::Missing => "nothing",
        }
    }

    /// The value as a number; texts, axes and frames are none.
    pub fn number(&self) -> Option<f64> {
        match *self {
            Val::Int(n) => Some(f64::from(n)),
            Val::Real(v) => Some(v),
            Val::Bool(b) => Some(f64::from(u8::from(b))),
            Val::Char(c) => Some(f64::from(c)),
            Val::Text(_) | Val::Axis(_) | Val::Frame(_) | Val::List(_) | Val::Missing => None,
        }
    }

    /// The value as a condition.
    pub fn truth(&self) -> Option<bool> {
        match self {
            Val::Text(text) => Some(!text.is_empty()),
            other => other.number().map(|v| v != 0.0),
        }
    }

    /// Which of two values is larger; numbers are equal within `tolerance` of their size.
    pub fn order(&self, other: &Self, tolerance: f64) -> Option<Ordering> {
        match (self, other) {
            (Val::Text(a), Val::Text(b)) => Some(a.cmp(b)),
            (Val::Text(a), Val::Char(b)) => Some(a.as_ref().cmp(&[*b])),
            (Val::Char(a), Val::Text(b)) => Some([*a].as_slice().cmp(b.as_ref())),
            (Val::Axis(a), Val::Axis(b)) => Some(a.cmp(b)),
            _ => {
                let (x, y) = (self.number()?, other.number()?);
                let equal = (x - y).abs() <= tolerance * x.abs().max(y.abs());
                if equal { Some(Ordering::Equal) } else { x.partial_cmp(&y) }
            }
        }
    }
}

/// A number rounded to an INT: halves go up.
pub fn whole(value: f64) -> Option<i32> {
    let rounded = libm::floor(value + 0.5);
    (f64::from(i32::MIN)..=f64::from(i32::MAX)).contains(&rounded).then_some(rounded as i32)
}
