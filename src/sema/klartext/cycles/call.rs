//! A call of a cycle while its path is planned: how it is called, what it sees, and what its arguments say.

use std::cell::RefCell;

use crate::diag::{Fault, codes};
use crate::ir::Feed;
use crate::ir::cycle::Family;
use crate::machine::{Axis, Unit};
use crate::sema::cycle::call::{self, Call, Made, Refusal, Says};
use crate::sema::cycle::given::{Breach, Given, Range};
use crate::sema::cycle::row::{Kind, Name, Parameter};

use super::super::feed::ToolFeed;
use super::super::known::Known;
use super::super::state::State;
use super::data::{Contoured, Roughed};
use super::{CLEARANCE, DEPTH, DefinedCycle, SECOND_CLEARANCE, SURFACE};

/// Longest dwell in seconds.
const LONGEST: f64 = 3600.0;

/// How a cycle is called.
#[derive(Debug, Clone, Copy)]
pub(in super::super) struct Calling {
    /// Lifts the surface, in mm.
    pub shift: f64,
    pub retract: Retract,
    pub by: By,
}

/// What says where the cycle runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) enum By {
    /// CYCL CALL, M99, M89: it runs where the tool stands.
    Block,
    /// CYCL CALL POS names the place.
    Position,
    /// A pattern or a table of points: one place of many.
    Pattern,
}

impl Calling {
    /// Where the tool stands.
    pub const HERE: Calling = Calling { shift: 0.0, retract: Retract::Far, by: By::Block };

    /// Does the call name the place?
    pub fn placed(self) -> bool {
        self.by != By::Block
    }
}

/// Where the tool goes behind a hole of a pattern.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in super::super) enum Retract {
    /// To the second set-up clearance, or to the set-up clearance where that is higher.
    Far,
    /// To the set-up clearance.
    Near,
    /// To this height, or to the 2nd set-up clearance where that is higher.
    To(f64),
}

/// Heights of a hole by their Q parameters, in mm.
#[derive(Debug, Clone, Copy)]
pub(in super::super) struct Heights {
    pub surface: f64,
    pub clearance: f64,
    /// 2nd set-up clearance as an absolute height; not below the set-up clearance.
    pub second: f64,
}

impl Heights {
    /// By Q200, Q203 and Q204; `shift` lifts the surface.
    pub fn of(given: &Given, shift: f64) -> Heights {
        let (clearance, surface) = (given.length(CLEARANCE), given.length(SURFACE) + shift);
        Heights { surface, clearance, second: surface + given.length(SECOND_CLEARANCE).max(clearance) }
    }

    /// What is worth saying of Q204.
    pub fn low_second(given: &Given) -> Option<Fault> {
        let (clearance, second) = (given.length(CLEARANCE), given.length(SECOND_CLEARANCE));
        let low = second < clearance && second != 0.0;
        low.then(|| codes::K2406::of_2nd_set_up_clearance_q204_lies_below(&second, &clearance))
    }

    /// Where rapid traverse ends.
    pub fn start(&self) -> f64 {
        self.surface + self.clearance
    }
}

impl Retract {
    pub fn height(self, heights: &Heights) -> f64 {
        match self {
            Retract::Far => heights.second,
            Retract::Near => heights.start(),
            Retract::To(height) => height.max(heights.second),
        }
    }
}

/// What a plan cannot go on without, and what is wrong beside the call itself.
#[derive(Debug)]
pub(in super::super) enum Instead {
    /// The position of an axis is not known.
    Position(Axis),
    /// The radius of the tool is not known.
    Radius,
    /// The teeth of the tool are not known.
    Teeth,
    /// Its contours; the path `away` from them keeps the radius `corners` where it is not 0.
    Area { corners: f64, away: f64 },
    /// The contour that it follows.
    Train,
    /// A fault of the definition that it takes data of.
    Data(Fault),
}

/// What a plan sees besides the arguments.
pub(in super::super) struct Seen<'c> {
    pub cycle: &'c DefinedCycle,
    pub calling: Calling,
    pub state: &'c State,
    /// Radius of a tool by its number.
    pub radius_of: &'c dyn Fn(u32) -> Option<f64>,
    pub contours: Option<&'c Contoured>,
    /// The last run of cycle 22.
    pub roughed: &'c Known<Roughed>,
    pub instead: RefCell<Option<Instead>>,
    /// What is said where the cycle is defined.
    pub at_definition: RefCell<Vec<Fault>>,
}

/// A call of a cycle.
pub(in super::super) type CycleCall<'c> = Call<'c, Seen<'c>>;

impl Says for Seen<'_> {
    fn breach(&self, given: &Given, at: usize, breach: Breach) -> Fault {
        let Some(parameter) = given.signature.parameters.get(at) else {
            return codes::P2090::value_is_out_of_range(&given.called, &"");
        };
        let (name, value) = (self.shown(parameter.name), &given.or_zero(parameter.name));
        let fault = match breach {
            Breach::Missing => codes::P2090::is_missing(&name),
            Breach::Negative(_) => codes::P2090::is_below_zero(&name, value),
            Breach::NotAboveZero(..) => codes::P2090::is_not_above_zero_2(&name, value),
            Breach::NoneOf(_, Range(low, high)) => codes::P2090::is_not_one_of(&name, value, &low, &high),
            Breach::Zero
            | Breach::NoNumber
            | Breach::NoText
            | Breach::OutOfAllRange
            | Breach::NoDigits(_)
            | Breach::NotBelow90(_) => codes::P2090::value_is_out_of_range(&name, value),
        };
        fault.of(&given.called)
    }
}

impl Seen<'_> {
    /// The parameter as its definition writes it: the parts of an old cycle begin with its number.
    fn shown(&self, name: Name) -> String {
        match name {
            Name::Part(_) | Name::In(..) => [self.cycle.number.to_string(), name.to_string()].concat(),
            Name::Q(_) | Name::Word(_) => name.to_string(),
        }
    }
}

impl CycleCall<'_> {
    /// The arguments against their row. A call that does nothing is held against what it reads until it knows so.
    pub fn fits(&self) -> Made {
        let before: Option<&[Name]> = if self.has_no_depth() {
            Some(super::BEFORE_DEPTH)
        } else if self.leaves_nothing_to_finish() {
            Some(super::BEFORE_FINISHING)
        } else {
            None
        };
        let counts = |known: &Parameter| {
            let by_diameter = known.name == DEPTH && self.is_by_diameter();
            known.without_effect.is_none() && !by_diameter && before.is_none_or(|before| before.contains(&known.name))
        };
        let by_word = |known: &&Parameter| {
            let some_calls = !known.needed && super::OF_SOME_CALLS.contains(&known.name);
            counts(known) && !some_calls && !matches!(known.kind, Kind::Feed)
        };
        let list = self.given.signature.parameters.iter().filter(by_word);
        for known in list {
            self.no_word(known.name)?;
        }
        self.fits_where(counts)
    }

    /// A word in place of the number.
    fn no_word(&self, name: Name) -> Made {
        self.given.word(name).map_or(Ok(()), |word| self.refuse(no_such_word(word, name)))
    }

    /// Does the control do nothing, because the depth Q201 is 0?
    pub fn has_no_depth(&self) -> bool {
        self.given.takes(DEPTH) && self.given.or_zero(DEPTH) == 0.0 && !self.is_by_diameter()
    }

    /// Says that it does nothing.
    pub fn without_depth(&self) {
        self.say_bare(codes::K2404::cycle_has_depth_0_so_program_depth(&self.st.cycle.number));
    }

    /// Q201, negative or 0.
    pub fn depth(&self) -> Made<f64> {
        let deep = self.given.length(DEPTH);
        if deep > 0.0 { self.refuse(codes::P2090::depth_q201_is_positive(&deep)) } else { Ok(deep) }
    }

    /// The heights that Q200, Q203 and Q204 give.
    pub fn heights(&self) -> Heights {
        if let Some(fault) = Heights::low_second(self.given) {
            self.say_bare(fault);
        }
        Heights::of(self.given, self.st.calling.shift)
    }

    // What is said.

    /// Says something whose text does not begin with the cycle.
    pub fn say_bare(&self, fault: Fault) {
        self.note(self.given.place, fault, call::Kind::Each);
    }

    /// Says something of all calls that are alike.
    pub fn say_of_all(&self, fault: Fault) {
        self.say_once(self.given.place, fault);
    }

    /// The same, of a text that does not begin with the cycle.
    pub fn say_of_all_bare(&self, fault: Fault) {
        self.note(self.given.place, fault, call::Kind::Once);
    }

    /// The plan cannot go on without this.
    pub fn without<T>(&self, lacks: Instead) -> Made<T> {
        self.st.instead.replace(Some(lacks));
        Err(Refusal::Known)
    }

    /// Arguments that make a cycle, or what is wrong with them.
    pub fn sound<F: Family>(&self, family: F) -> Made<F> {
        match family.check() {
            Ok(()) => Ok(family),
            Err(fault) => self.refuse(codes::P2090::makes_no_path(&fault)),
        }
    }

    /// A length that this call needs.
    pub fn required(&self, name: Name) -> Made<f64> {
        self.no_word(name)?;
        self.given.length_if(name).map_or_else(|| self.refuse(codes::P2090::is_missing(&name)), Ok)
    }

    // Times and feeds.

    /// Seconds; 0 where none are given.
    pub fn dwell(&self, name: Name) -> Made<f64> {
        let seconds = self.given.or_zero(name);
        if (0.0..=LONGEST).contains(&seconds) {
            return Ok(seconds);
        }
        self.refuse(codes::P2090::dwell_of_s_is_out(&seconds))
    }

    pub fn feed(&self, name: Name) -> Made<Feed> {
        self.feed_or(name, None)
    }

    /// A feed; 0 stands for `instead`.
    pub fn feed_or(&self, name: Name, instead: Option<Feed>) -> Made<Feed> {
        if let Some(feed) = self.st.cycle.feed(name) {
            return self.feed_by_word(name, feed.value * self.given.unit, feed.per_tooth);
        }
        match (self.given.word(name), instead) {
            (Some("FAUTO"), _) => self.feed_of_tool(name),
            (Some(word), _) => self.refuse(no_such_word(word, name)),
            (None, Some(feed)) if self.given.or_zero(name) == 0.0 => Ok(feed),
            (None, _) => self.checked_feed(self.given.or_zero(name)),
        }
    }

    /// The feed of a retract; nothing for rapid traverse.
    pub fn retract_feed(&self, name: Name, instead: Option<Feed>) -> Made<Option<Feed>> {
        if self.given.word(name) == Some("FMAX") { Ok(None) } else { self.feed_or(name, instead).map(Some) }
    }

    /// `Q206=FU0.2`
    fn feed_by_word(&self, name: Name, value: f64, per_tooth: bool) -> Made<Feed> {
        if value <= 0.0 {
            return self.refuse(codes::P2090::feed_is_not_above_zero(&name, &value));
        }
        if !per_tooth {
            return Ok(Feed::PerRevolution(value));
        }
        match self.st.state.tool.active().and_then(|tool| tool.teeth) {
            Some(teeth) => Ok(Feed::PerRevolution(value * f64::from(teeth))),
            None => self.without(Instead::Teeth),
        }
    }

    /// FAUTO: the F of the last TOOL CALL.
    fn feed_of_tool(&self, name: Name) -> Made<Feed> {
        let per_revolution = self.st.state.feed.is_per_revolution();
        match self.st.state.feed.of_tool() {
            Some(ToolFeed { feed, by_word, .. })
                if by_word || matches!(feed, Feed::PerRevolution(_)) == per_revolution =>
            {
                Ok(feed)
            }
            Some(_) => self.refuse(codes::P9010::fauto_with_tool_call_that_counts_f(&name)),
            None => self.refuse_bare(codes::K2003::last_tool_call_has_no_f_so_fauto(&name)),
        }
    }

    /// Refuses the call by a text that does not begin with the cycle.
    pub fn refuse_bare<T>(&self, fault: Fault) -> Made<T> {
        Err(Refusal::Fault(self.given.place, fault))
    }

    fn checked_feed(&self, value: f64) -> Made<Feed> {
        if value <= 0.0 {
            return self.refuse(codes::P2090::feed_of_is_not_above_zero(&value));
        }
        let state = &self.st.state.feed;
        if state.is_large(value) {
            self.st.at_definition.borrow_mut().push(codes::K2013::under_m136_this_feed_is_mm_per(&value));
        }
        Ok(state.counted(value, if self.given.unit == Unit::Inch.mm() { Unit::Inch } else { Unit::Mm }))
    }
}

/// A word in place of a number that the parameter does not take.
pub(in super::super) fn no_such_word(word: &str, name: Name) -> Fault {
    match word {
        "FU" => codes::P9010::fu_without_number(&name),
        "FZ" => codes::P9010::fz_without_number(&name),
        _ => codes::P9010::word_as_value(&word, &name),
    }
}
