//! Why a formula has no value. A dialect has one table from these to its codes and words.

use crate::diag;
use crate::lexer::formula::{Function, Operator};
use crate::sema::Reported;

use super::Divisor;

/// A computation without a result.
#[derive(Debug, Clone, PartialEq)]
pub enum Fault {
    /// The function does not exist there.
    Domain(Function, f64),
    /// Controls differ in what the function gives there, or no manual says it.
    Open(Function, f64),
    /// The operator does not exist there.
    Outside(Operator, f64, f64),
    /// As [`Fault::Open`].
    OpenBetween(Operator, f64, f64),
    /// The first number is divided by zero.
    Zero(f64),
    /// The same by a variable alone.
    ZeroBy(f64, Divisor),
    TooLarge,
    /// More than an INT holds.
    TooLargeInt,
    /// The function or operator takes no value of this kind.
    Misfit(&'static str),
    /// The operator takes no two values of these kinds.
    Mismatch(&'static str, &'static str),
    /// An operand is missing.
    Missing,
    /// Only one dialect has it.
    Said(diag::Fault),
}

/// Why an operation made no value: a fault still to be reported, or something that was.
#[derive(Debug)]
pub enum Stop {
    Fault(Fault),
    Reported,
}

impl From<Fault> for Stop {
    fn from(fault: Fault) -> Stop {
        Stop::Fault(fault)
    }
}

impl From<diag::Fault> for Fault {
    fn from(fault: diag::Fault) -> Fault {
        Fault::Said(fault)
    }
}

impl From<diag::Fault> for Stop {
    fn from(fault: diag::Fault) -> Stop {
        Stop::Fault(fault.into())
    }
}

impl From<Reported> for Stop {
    fn from(_: Reported) -> Stop {
        Stop::Reported
    }
}
