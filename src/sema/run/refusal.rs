//! What of a block cannot be done, as a value: who reads words or computes says so, and whoever has the machine reports it.

use crate::diag::Fault;
use crate::sema::{Outcome, Reported};

use super::Language;
use super::core::Core;
use super::report::Where;

/// Why something is not made.
#[derive(Debug)]
pub enum Refusal {
    /// What is wrong, and where.
    Fault(Where, Fault),
    /// It only suffers from what was reported before.
    Known,
}

/// What is made, or why it is not.
pub type Made<T = ()> = Result<T, Refusal>;

impl From<Reported> for Refusal {
    fn from(Reported: Reported) -> Refusal {
        Refusal::Known
    }
}

/// Words of the block, or all of it, are refused.
pub fn refused<T>(place: impl Into<Where>, fault: Fault) -> Made<T> {
    Err(Refusal::Fault(place.into(), fault))
}

/// Hands what was made to the one place that reports: `refuse` says why there is nothing.
#[inline]
pub fn reported<T>(made: Made<T>, refuse: impl FnOnce(Where, Fault)) -> Outcome<T> {
    made.map_err(|refusal| {
        if let Refusal::Fault(place, fault) = refusal {
            refuse(place, fault);
        }
        Reported
    })
}

impl<L: Language> Core<'_, L> {
    /// What was made; reports why it was not.
    #[inline]
    pub fn made<T>(&self, made: Made<T>) -> Outcome<T> {
        reported(made, |place, fault| self.say(place, fault))
    }
}
