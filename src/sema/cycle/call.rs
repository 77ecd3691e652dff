//! A call of a cycle while its path is planned.

use std::cell::{Cell, RefCell};

use crate::diag::{Fault, Label};
use crate::machine::Settings;
use crate::sema::run::Where;
use crate::sema::run::refusal::refused;
use crate::text::Loc;

pub use crate::sema::run::refusal::{Made, Refusal};

use super::given::{Breach, Given};
use super::row::{Name, Parameter};

/// Something that is worth saying of a call.
#[derive(Debug)]
pub struct Remark {
    pub place: Where,
    pub fault: Fault,
    pub kind: Kind,
}

/// How often something is said, and with what.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Of every call.
    Each,
    /// Once at a place, however often the cycle runs there.
    OnceHere,
    /// Once for the whole program, however many calls are worth it.
    Once,
    /// A reading of the manuals or a path of our own: of a call that makes a path.
    Way,
    /// The call leaves something open that the control takes from elsewhere: of a call that makes a path.
    Open,
}

/// Something about a block outside the call, which is named with it.
#[derive(Debug)]
pub struct Elsewhere {
    pub place: Loc,
    pub fault: Fault,
    /// What the call is to it: "the cycle".
    pub call: Label,
}

/// The arguments of a call, what they count under, and what is said of it.
#[derive(Debug)]
pub struct Call<'c, S> {
    pub given: &'c Given,
    /// What the control knows where the cycle is called.
    pub st: &'c S,
    pub settings: &'c Settings,
    remarks: RefCell<Vec<Remark>>,
    elsewhere: RefCell<Vec<Elsewhere>>,
    /// The plan takes the feed that is modal.
    pub takes_modal_feed: Cell<bool>,
}

/// What a control says of arguments that are not what their rows ask for.
pub trait Says {
    /// `at` counts from 0.
    fn breach(&self, given: &Given, at: usize, breach: Breach) -> Fault;
}

impl<'c, S> Call<'c, S> {
    pub fn new(given: &'c Given, st: &'c S, settings: &'c Settings) -> Call<'c, S> {
        let (remarks, elsewhere) = (RefCell::default(), RefCell::default());
        Call { given, st, settings, remarks, elsewhere, takes_modal_feed: Cell::default() }
    }

    /// What was said, in its order.
    pub fn remarks(self) -> Vec<Remark> {
        self.remarks.into_inner()
    }

    /// What was said of blocks outside the call.
    pub fn elsewhere(&self) -> Vec<Elsewhere> {
        self.elsewhere.take()
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
        self.refuse_as_said(place, self.of_cycle(fault))
    }

    /// The same for a fault that names the cycle itself, or that is none of the cycle.
    pub fn refuse_as_said<T>(&self, place: Where, fault: Fault) -> Made<T> {
        refused(place, fault)
    }

    /// Refuses the call for what stands in a block outside it.
    pub fn refuse_elsewhere<T>(&self, found: Elsewhere) -> Made<T> {
        self.say_elsewhere(found);
        Err(Refusal::Known)
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
        self.note(place, self.of_cycle(fault), Kind::Each);
    }

    /// Says something once for the whole program.
    pub fn say_once(&self, place: Where, fault: Fault) {
        self.note(place, self.of_cycle(fault), Kind::Once);
    }

    /// Says something about a block outside the call.
    pub fn say_elsewhere(&self, found: Elsewhere) {
        self.elsewhere.borrow_mut().push(found);
    }

    /// A reading of the manuals or a path of our own.
    pub fn own_way(&self, fault: Fault) {
        self.note(self.given.place, fault, Kind::Way);
    }

    /// The call leaves something open.
    pub fn leaves_open(&self, fault: Fault) {
        self.note(self.given.place, fault, Kind::Open);
    }

    /// Says something whose text does not begin with the cycle, or names it itself.
    pub fn note(&self, place: Where, fault: Fault, kind: Kind) {
        self.remark(Remark { place, fault, kind });
    }

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

    fn no_breach(&self, found: Option<(usize, Breach)>) -> Made {
        match found {
            None => Ok(()),
            Some((at, breach)) => self.refuse_as_said(self.given.place_at(at), self.st.breach(self.given, at, breach)),
        }
    }
}
