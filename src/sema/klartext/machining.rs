//! Machining cycles at the place of their call: what all of them need, and the values of their parameters.
//!
//! Source: K 4.4, 6.0 (docs/sources.md).

use crate::diag::{Fault, codes};
use crate::ir::Feed;

use super::cycle_definition::WordFeed;
use super::cycles::call::{Call, Heights};
use super::cycles::{CLEARANCE, DefinedCycle, Nature, Q, SECOND_CLEARANCE, SURFACE};
use super::{Outcome, Reported, Run};

/// Longest dwell in seconds.
const LONGEST: f64 = 3600.0;

/// What a cycle needs of the spindle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Needs {
    Turning,
    /// The cycle itself starts it.
    Speed,
    /// The cycle brings its speed, too.
    Nothing,
}

impl Run<'_> {
    /// Runs the cycle where the tool stands.
    pub(super) fn run_cycle(&mut self, cycle: &DefinedCycle, call: Call) -> Outcome {
        self.same_unit(cycle)?;
        match cycle.row().nature {
            Nature::Milling(making) => self.mill(cycle, making, call),
            _ => self.drill(cycle, call),
        }
    }

    /// Q parameters have no unit: those of a definition count in the unit of its program, which a call has to share.
    pub(super) fn same_unit(&mut self, cycle: &DefinedCycle) -> Outcome {
        if cycle.mm == self.level().frame.unit.mm() {
            return Ok(());
        }
        self.report(
            codes::K2947::cycle_is_called_in_program_of_another(&cycle.number)
                .at(self.here.origin.loc)
                .also(cycle.loc, "the cycle is defined here"),
        );
        Err(Reported)
    }

    /// Are all parameters of the definition there? Looked at when it is complete.
    pub(super) fn check_definition(&mut self, cycle: &DefinedCycle) -> Outcome {
        let row = cycle.row();
        if !row.nature.runs() {
            return Ok(());
        }
        if row.has_parts(cycle.number) {
            let Some(missing) = row.needed().find(|name| !cycle.gives(*name)) else { return Ok(()) };
            return self.refuse(self.block_span(), codes::K2402::cycle_lacks_value_of_part(&cycle.number, &missing));
        }
        self.all_are_set(cycle, &format!("cycle {}", cycle.number))
    }

    /// Every Q parameter that the cycle needs.
    pub(super) fn all_are_set(&self, cycle: &DefinedCycle, what: &str) -> Outcome {
        let needed = cycle.row().needed();
        let missing: Vec<String> = needed.filter(|name| !cycle.gives(*name)).map(|name| name.to_string()).collect();
        if missing.is_empty() {
            return Ok(());
        }
        self.refuse(self.block_span(), codes::K2402::lacks_so_program_all(&what, &missing.join(", ")))
    }

    /// What every machining cycle needs when it is called.
    pub(super) fn cycle_may_run(&mut self, cycle: &DefinedCycle, spindle: Needs) -> Outcome {
        if self.st.compensation.is_on() {
            self.report(codes::K2407::cycle_is_called_while_rl_or_rr().at(self.here.origin.loc));
            return Err(Reported);
        }
        if !self.st.spindle.turns() && spindle == Needs::Turning {
            self.report(
                codes::K2405::spindle_does_not_turn_at_this_cycle()
                    .at(self.here.origin.loc)
                    .also(cycle.loc, "the cycle is defined here"),
            );
            return Err(Reported);
        }
        if self.st.spindle.speed().is_none_or(|speed| speed <= 0.0) && spindle != Needs::Nothing {
            self.report(
                codes::K2405::spindle_has_no_speed_at_this_cycle()
                    .at(self.here.origin.loc)
                    .also(cycle.loc, "the cycle is defined here"),
            );
            return Err(Reported);
        }
        self.cuts_now()?;
        if self.st.feed.plunge_share().is_some() {
            self.report(codes::K2709::m103_does_not_change_feeds().at(self.here.origin.loc));
        }
        Ok(())
    }

    /// The control does nothing where the depth is 0.
    pub(super) fn has_no_depth(&self, cycle: &DefinedCycle) {
        self.report(
            codes::K2404::cycle_has_depth_0_so_program_depth(&cycle.number)
                .at(self.here.origin.loc)
                .also(cycle.loc, "the cycle is defined here"),
        );
    }

    /// The heights that Q200, Q203 and Q204 give.
    pub(super) fn heights(&mut self, cycle: &DefinedCycle, shift: f64) -> Outcome<Heights> {
        let clearance = self.cycle_length(cycle, CLEARANCE)?;
        if clearance < 0.0 {
            return self.refuse_value(cycle, codes::P2090::set_up_clearance_q200(&clearance));
        }
        let surface = self.cycle_length(cycle, SURFACE)? + shift;
        let second = self.cycle_length(cycle, SECOND_CLEARANCE)?;
        if second < clearance && second != 0.0 {
            self.report(
                codes::K2406::of_2nd_set_up_clearance_q204_lies_below(&second, &clearance)
                    .at(self.here.origin.loc)
                    .also(cycle.loc, "the cycle is defined here"),
            );
        }
        Ok(Heights { surface, clearance, second: surface + second.max(clearance) })
    }

    // Values by their Q parameters.

    /// What the parameter holds now.
    pub(super) fn cycle_number(&mut self, cycle: &DefinedCycle, q: Q) -> Outcome<f64> {
        if let Some(word) = cycle.word(q) {
            let help = match word {
                "FU" => "write the number of FU behind it, or the feed a minute: mm per revolution times the speed",
                "FZ" => {
                    "write the number of FZ behind it, or the feed a minute: mm per tooth times the teeth and the speed"
                }
                _ => "write a number",
            };
            self.report(
                codes::P9010::cycle_as_value_of_is_not_supported(&cycle.number, &word, &q, &help)
                    .at(self.here.origin.loc)
                    .also(cycle.loc, "the cycle is defined here"),
            );
            return Err(Reported);
        }
        if !cycle.sets(q) {
            return self.refuse_value(cycle, codes::P2090::is_missing(&q));
        }
        let span = self.block_span();
        self.parameter(crate::lexer::klartext::QRef { kind: crate::lexer::klartext::QKind::Q, number: q.0 }, span)
    }

    pub(super) fn cycle_length(&mut self, cycle: &DefinedCycle, q: Q) -> Outcome<f64> {
        let mm = self.level().frame.unit.mm();
        Ok(self.cycle_number(cycle, q)? * mm)
    }

    /// A parameter that newer software has: 0 where the definition does not set it.
    pub(super) fn cycle_option(&mut self, cycle: &DefinedCycle, q: Q) -> Outcome<f64> {
        if cycle.sets(q) || cycle.word(q).is_some() { self.cycle_number(cycle, q) } else { Ok(0.0) }
    }

    pub(super) fn cycle_dwell(&mut self, cycle: &DefinedCycle, q: Q) -> Outcome<f64> {
        let seconds = self.cycle_option(cycle, q)?;
        self.check_dwell(cycle, seconds)
    }

    pub(super) fn check_dwell(&mut self, cycle: &DefinedCycle, seconds: f64) -> Outcome<f64> {
        if (0.0..=LONGEST).contains(&seconds) {
            return Ok(seconds);
        }
        self.refuse_value(cycle, codes::P2090::dwell_of_s_is_out(&seconds))
    }

    /// A feed; 0 stands for `instead` where that is given.
    pub(super) fn cycle_feed(&mut self, cycle: &DefinedCycle, q: Q, instead: Option<Feed>) -> Outcome<Feed> {
        if cycle.word(q) == Some("FAUTO") {
            return self.tool_feed_of(cycle, q);
        }
        if let Some(feed) = cycle.feed(q) {
            return self.word_feed_of(cycle, q, feed);
        }
        let value = self.cycle_number(cycle, q)?;
        match instead {
            Some(feed) if value == 0.0 => Ok(feed),
            _ => self.check_feed(cycle, value),
        }
    }

    /// `Q206=FU0.2`
    fn word_feed_of(&mut self, cycle: &DefinedCycle, q: Q, feed: WordFeed) -> Outcome<Feed> {
        let value = feed.value * cycle.mm;
        if value <= 0.0 {
            return self.refuse_value(cycle, codes::P2090::feed_is_not_above_zero(&q, &value));
        }
        if feed.per_tooth { self.feed_of_teeth(value, self.block_span()) } else { Ok(Feed::PerRevolution(value)) }
    }

    /// FAUTO: the F of the last TOOL CALL.
    fn tool_feed_of(&mut self, cycle: &DefinedCycle, q: Q) -> Outcome<Feed> {
        let per_revolution = self.st.feed.is_per_revolution();
        match self.st.feed.of_tool() {
            Some(of) if of.by_word || matches!(of.feed, Feed::PerRevolution(_)) == per_revolution => Ok(of.feed),
            Some(_) => self.refuse_cycle(cycle, codes::P9010::fauto_with_tool_call_that_counts_f(&q)),
            None => {
                self.report(
                    codes::K2003::last_tool_call_has_no_f_so_fauto(&q)
                        .at(self.here.origin.loc)
                        .also(cycle.loc, "the cycle is defined here"),
                );
                Err(Reported)
            }
        }
    }

    /// A retract: FMAX is rapid traverse.
    pub(super) fn retract_feed(&mut self, cycle: &DefinedCycle, q: Q, instead: Option<Feed>) -> Outcome<Option<Feed>> {
        if cycle.word(q) == Some("FMAX") { Ok(None) } else { self.cycle_feed(cycle, q, instead).map(Some) }
    }

    pub(super) fn check_feed(&mut self, cycle: &DefinedCycle, value: f64) -> Outcome<Feed> {
        if value > 0.0 {
            self.large_per_revolution(cycle.loc, value);
            return Ok(self.feed_of(value));
        }
        self.refuse_value(cycle, codes::P2090::feed_of_is_not_above_zero(&value))
    }

    /// Refuses a value of the cycle. Lengths are in mm, in programs in inches, too.
    pub(super) fn refuse_value<T>(&self, cycle: &DefinedCycle, fault: Fault) -> Outcome<T> {
        let help = if cycle.mm == 1.0 || !fault.message.contains(|c: char| c.is_ascii_digit()) {
            "check the values of the definition"
        } else {
            "check the values of the definition; lengths are given here in mm"
        };
        self.refuse_cycle(cycle, fault.help(help))
    }

    /// Refuses the call of a cycle.
    pub(super) fn refuse_cycle<T>(&self, cycle: &DefinedCycle, fault: Fault) -> Outcome<T> {
        let found = fault.of(format_args!("cycle {}", cycle.number)).at(self.here.origin.loc);
        self.report_cause(found.also(cycle.loc, "the cycle is defined here"));
        Err(Reported)
    }

    pub(super) fn cycle_value<T>(&self, cycle: &DefinedCycle, what: &str) -> Outcome<T> {
        self.refuse_value(cycle, Fault::new(codes::P2090, what.to_owned()))
    }

    /// The same, and what to do.
    pub(super) fn cycle_otherwise<T>(&self, cycle: &DefinedCycle, what: &str, help: &'static str) -> Outcome<T> {
        self.report_cause(
            codes::P9010::cycle_is_not_supported(&cycle.number, &what)
                .at(self.here.origin.loc)
                .also(cycle.loc, "the cycle is defined here")
                .help(help),
        );
        Err(Reported)
    }
}
