//! A call of a cycle while its path is planned.

use std::cell::RefCell;

use crate::diag::Fault;
use crate::machine::Settings;
use crate::sema::run::Where;
use crate::sema::{Outcome, Reported};

use super::given::{Breach, Given};
use super::row::{Name, Parameter};

/// Why a call makes no path.
#[derive(Debug)]
pub enum Refusal {
    /// What is wrong, and where.
    Fault(Where, Box<Fault>),
    /// It only suffers from what was reported before.
    Known,
}

/// What a plan makes, or why it makes nothing.
pub type Made<T = ()> = Result<T, Refusal>;

impl From<Reported> for Refusal {
    fn from(Reported: Reported) -> Refusal {
        Refusal::Known
    }
}

/// Something that is worth saying of a call.
#[derive(Debug)]
pub struct Remark {
    pub place: Where,
    pub fault: Fault,
    /// Once for the whole program, however many calls are worth it.
    pub once: bool,
}

/// The arguments of a call, what they count under, and what is said of it.
#[derive(Debug)]
pub struct Call<'c, S> {
    pub given: &'c Given,
    /// What the control knows where the cycle is called.
    pub st: &'c S,
    pub settings: &'c Settings,
    remarks: RefCell<Vec<Remark>>,
}

/// What a control says of arguments that are not what their rows ask for.
pub trait Says {
    /// `at` counts from 0.
    fn breach(&self, given: &Given, at: usize, breach: Breach) -> Fault;
}

impl<'c, S> Call<'c, S> {
    pub fn new(given: &'c Given, st: &'c S, settings: &'c Settings) -> Call<'c, S> {
        Call { given, st, settings, remarks: RefCell::default() }
    }

    /// What was said, in its order.
    pub fn remarks(self) -> Vec<Remark> {
        self.remarks.into_inner()
    }

    /// A fault of the cycle, which its text begins with.
    pub fn of_cycle(&self, fault: Fault) -> Fault {
        if self.given.called.is_empty() { fault } else { fault.of(&self.given.called) }
    }

    /// Refuses the call.
    pub fn refuse<T>(&self, fault: Fault) -> Made<T> {
        self.refuse_at(self.given.place, fault)
    }

    /// Refuses an argument of the call.
    pub fn refuse_argument<T>(&self, name: Name, fault: Fault) -> Made<T> {
        self.refuse_at(self.given.place_of(name), fault)
    }

    /// Refuses the call for what stands at a place.
    pub fn refuse_at<T>(&self, place: Where, fault: Fault) -> Made<T> {
        Err(Refusal::Fault(place, Box::new(self.of_cycle(fault))))
    }

    /// Says something of the call.
    pub fn say(&self, fault: Fault) {
        self.say_at(self.given.place, fault);
    }

    /// Says something of an argument: that it is read in a way that is not confirmed, or not used.
    pub fn say_of(&self, name: Name, fault: Fault) {
        self.say_at(self.given.place_of(name), fault);
    }

    pub fn say_at(&self, place: Where, fault: Fault) {
        self.remark(Remark { place, fault: self.of_cycle(fault), once: false });
    }

    /// Says something once for the whole program.
    pub fn say_once(&self, place: Where, fault: Fault) {
        self.remark(Remark { place, fault: self.of_cycle(fault), once: true });
    }

    /// Says something whose text does not begin with the cycle.
    pub fn remark(&self, remark: Remark) {
        self.remarks.borrow_mut().push(remark);
    }
}

impl<S: Says> Call<'_, S> {
    /// Every argument against its row.
    pub fn fits_its_row(&self) -> Made {
        self.no_breach(self.given.breach())
    }

    /// The arguments that count for this call against the row.
    pub fn fits_where(&self, counts: impl Fn(&Parameter) -> bool) -> Made {
        self.no_breach(self.given.breach_where(counts))
    }

    /// Every argument against the kind of its row.
    pub fn is_of_its_kind(&self) -> Made {
        self.no_breach(self.given.breach_of_kind())
    }

    fn no_breach(&self, found: Option<(usize, Breach)>) -> Made {
        match found {
            None => Ok(()),
            Some((at, breach)) => {
                Err(Refusal::Fault(self.given.place_at(at), Box::new(self.st.breach(self.given, at, breach))))
            }
        }
    }
}

/// Hands what a plan made to the one place that reports: `refuse` says why there is nothing.
pub fn reported<T>(made: Made<T>, refuse: impl FnOnce(Where, Fault)) -> Outcome<T> {
    made.map_err(|refusal| {
        if let Refusal::Fault(place, fault) = refusal {
            refuse(place, *fault);
        }
        Reported
    })
}
