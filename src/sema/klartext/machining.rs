//! Machining cycles at the place of their call: what all of them need, and the values of their parameters.
//!
//! Source: K 4.4, 6.0 (docs/sources.md).

use crate::diag::{Diagnostic, codes};
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
        let message =
            format!("cycle {} is called in a program of another unit than that of its definition", cycle.number);
        self.report(
            Diagnostic::new(codes::K2947, self.here.origin.loc, message)
                .also(cycle.loc, "the cycle is defined here")
                .help("define the cycle in the program that calls it, or give both programs the same unit"),
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
            return self.fail_help(
                codes::K2402,
                self.block_span(),
                format!("cycle {0} lacks the value of part {0}{missing}", cycle.number),
                "program all parts of the cycle",
            );
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
        let message = format!("{what} lacks {}", missing.join(", "));
        self.fail_help(codes::K2402, self.block_span(), message, "program all parameters of the cycle")
    }

    /// What every machining cycle needs when it is called.
    pub(super) fn cycle_may_run(&mut self, cycle: &DefinedCycle, spindle: Needs) -> Outcome {
        if self.st.compensation.is_on() {
            self.report(
                Diagnostic::new(codes::K2407, self.here.origin.loc, "a cycle is called while RL or RR is active")
                    .help("program a straight block with R0 in front of the call"),
            );
            return Err(Reported);
        }
        if !self.st.spindle.turns() && spindle == Needs::Turning {
            self.report(
                Diagnostic::new(codes::K2405, self.here.origin.loc, "the spindle does not turn at this cycle call")
                    .also(cycle.loc, "the cycle is defined here")
                    .help("program M3 in front of the call"),
            );
            return Err(Reported);
        }
        if self.st.spindle.speed().is_none_or(|speed| speed <= 0.0) && spindle != Needs::Nothing {
            self.report(
                Diagnostic::new(codes::K2405, self.here.origin.loc, "the spindle has no speed at this cycle call")
                    .also(cycle.loc, "the cycle is defined here")
                    .help("program S in the TOOL CALL"),
            );
            return Err(Reported);
        }
        self.cuts_now()?;
        if self.st.feed.plunge_share().is_some() {
            self.report(
                Diagnostic::new(codes::K2709, self.here.origin.loc, "M103 does not change the feeds of this cycle")
                    .help("program M103 without F in front of the cycle, or the feed of the cycle as it is meant"),
            );
        }
        Ok(())
    }

    /// The control does nothing where the depth is 0.
    pub(super) fn has_no_depth(&self, cycle: &DefinedCycle) {
        self.report(
            Diagnostic::new(codes::K2404, self.here.origin.loc, format!("cycle {} has depth 0", cycle.number))
                .also(cycle.loc, "the cycle is defined here")
                .help("program the depth Q201 with a minus sign"),
        );
    }

    /// The heights that Q200, Q203 and Q204 give.
    pub(super) fn heights(&mut self, cycle: &DefinedCycle, shift: f64) -> Outcome<Heights> {
        let clearance = self.cycle_length(cycle, CLEARANCE)?;
        if clearance < 0.0 {
            return self.cycle_value(cycle, &format!("the set-up clearance Q200 is {clearance}"));
        }
        let surface = self.cycle_length(cycle, SURFACE)? + shift;
        let second = self.cycle_length(cycle, SECOND_CLEARANCE)?;
        if second < clearance && second != 0.0 {
            self.report(
                Diagnostic::new(
                    codes::K2406,
                    self.here.origin.loc,
                    format!(
                        "the 2nd set-up clearance Q204 = {second} lies below the set-up clearance Q200 = {clearance}"
                    ),
                )
                .also(cycle.loc, "the cycle is defined here")
                .help("the tool stays at the set-up clearance; check the way to the next position"),
            );
        }
        Ok(Heights { surface, clearance, second: surface + second.max(clearance) })
    }

    // Values by their Q parameters.

    /// What the parameter holds now.
    pub(super) fn cycle_number(&mut self, cycle: &DefinedCycle, q: Q) -> Outcome<f64> {
        if let Some(word) = cycle.word(q) {
            let message = format!("cycle {}: {word} as the value of {q} is not supported", cycle.number);
            let help = match word {
                "FU" => "write the number of FU behind it, or the feed a minute: mm per revolution times the speed",
                "FZ" => {
                    "write the number of FZ behind it, or the feed a minute: mm per tooth times the teeth and the speed"
                }
                _ => "write a number",
            };
            self.report(
                Diagnostic::new(codes::K9001, self.here.origin.loc, message)
                    .also(cycle.loc, "the cycle is defined here")
                    .help(format!("{help}: `{q}=+750`")),
            );
            return Err(Reported);
        }
        if !cycle.sets(q) {
            return self.cycle_value(cycle, &format!("{q} is missing"));
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
        self.cycle_value(cycle, &format!("a dwell of {seconds} s is out of range"))
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
            return self.cycle_value(cycle, &format!("the feed {q} = {value} is not above zero"));
        }
        if feed.per_tooth { self.feed_of_teeth(value, self.block_span()) } else { Ok(Feed::PerRevolution(value)) }
    }

    /// FAUTO: the F of the last TOOL CALL.
    fn tool_feed_of(&mut self, cycle: &DefinedCycle, q: Q) -> Outcome<Feed> {
        let per_revolution = self.st.feed.is_per_revolution();
        match self.st.feed.of_tool() {
            Some(of) if of.by_word || matches!(of.feed, Feed::PerRevolution(_)) == per_revolution => Ok(of.feed),
            Some(_) => self.cycle_unbuilt(cycle, &format!("{q}=FAUTO with a TOOL CALL that counts F in another way")),
            None => {
                self.report(
                    Diagnostic::new(
                        codes::K2003,
                        self.here.origin.loc,
                        format!("the last TOOL CALL has no F, so {q}=FAUTO has no value"),
                    )
                    .also(cycle.loc, "the cycle is defined here")
                    .help("put F into the TOOL CALL, or a number behind the parameter"),
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
        self.cycle_value(cycle, &format!("a feed of {value} is not above zero"))
    }

    /// Refuses a value of the cycle. Lengths are in mm, in programs in inches, too.
    pub(super) fn cycle_value<T>(&self, cycle: &DefinedCycle, what: &str) -> Outcome<T> {
        let help = if cycle.mm == 1.0 || !what.contains(|c: char| c.is_ascii_digit()) {
            "check the values of the definition"
        } else {
            "check the values of the definition; lengths are given here in mm"
        };
        self.report_cause(
            Diagnostic::new(codes::K2403, self.here.origin.loc, format!("cycle {}: {what}", cycle.number))
                .also(cycle.loc, "the cycle is defined here")
                .help(help),
        );
        Err(Reported)
    }

    /// Refuses a variant that is not built.
    pub(super) fn cycle_unbuilt<T>(&self, cycle: &DefinedCycle, what: &str) -> Outcome<T> {
        self.cycle_otherwise(cycle, what, "use the plain variant of the cycle, or program its moves as blocks")
    }

    /// The same, and what to do.
    pub(super) fn cycle_otherwise<T>(&self, cycle: &DefinedCycle, what: &str, help: &'static str) -> Outcome<T> {
        self.report_cause(
            Diagnostic::new(
                codes::K9001,
                self.here.origin.loc,
                format!("cycle {}: {what} is not supported", cycle.number),
            )
            .also(cycle.loc, "the cycle is defined here")
            .help(help),
        );
        Err(Reported)
    }
}
