//! Drilling cycles: 1, 2, 17, 200 to 203, 205 to 207, 240. Their parameters become a [`Drilling`].
//!
//! Source: reference sections 4.4, 6.0 to 6.2. The parameters Q200 and up stay variables: a call takes what they hold
//! then. The values of the old dotted cycles are those of the definition.

use crate::diag::{Diagnostic, codes};
use crate::ir::cycle::drilling::{Bore, Breaks, DeepHole, DrillingFault, Levels, Method, Tap};
use crate::ir::cycle::{Cycle, Drilling};
use crate::ir::function::{Spindle, Turn};
use crate::ir::{Feed, Side};
use crate::machine::{Axis, AxisSet};

use super::machining::Machining;
use super::{Outcome, Reported, Run};

/// Way by which cycle 202 lifts the edge off the wall, in mm.
const LIFT: f64 = 0.2;
/// Old cycle 1: distance in front of the last depth down to this depth, and below as a part of the depth.
const SHALLOW: f64 = 30.0;
const NEAR: f64 = 0.6;
const SHARE: f64 = 50.0;
const FURTHEST: f64 = 7.0;
/// Longest dwell in seconds.
const LONGEST: f64 = 3600.0;

/// The Q parameters that a definition of this cycle has to set, if it is a drilling cycle that is compiled.
pub(super) fn needed(number: u32) -> Option<&'static [u32]> {
    Some(match number {
        1 | 2 | 17 => &[],
        200 => &[200, 201, 206, 202, 210, 203, 204],
        201 => &[200, 201, 206, 211, 208, 203, 204],
        202 => &[200, 201, 206, 211, 208, 203, 204, 214],
        203 => &[200, 201, 206, 202, 210, 203, 204, 212, 213, 205, 211, 208],
        205 => &[200, 201, 206, 202, 203, 204, 212, 205, 258, 259, 257, 256, 211],
        206 => &[200, 201, 206, 211, 203, 204],
        207 => &[200, 201, 239, 203, 204],
        240 => &[200, 343, 201, 206, 211, 203, 204],
        _ => return None,
    })
}

/// The Q parameters of a drilling cycle: those that it needs, and those that newer software has besides.
pub(super) fn parameters(number: u32) -> Option<(&'static [u32], &'static [u32])> {
    let optional: &[u32] = match number {
        200 => &[211, 395],
        202 => &[336],
        203 => &[256, 395],
        205 => &[379, 253, 208, 395],
        240 => &[344, 342, 253],
        1 | 2 | 17 => return None,
        _ => &[],
    };
    Some((needed(number)?, optional))
}

/// The part of an old cycle that holds its feed.
pub(super) fn feed_part(number: u32) -> Option<u32> {
    match number {
        1 => Some(5),
        2 => Some(4),
        _ => None,
    }
}

/// Parts of an old cycle, from 1 on.
fn parts(number: u32) -> u32 {
    match number {
        1 => 5,
        2 => 4,
        _ => 3,
    }
}

/// Where the tool goes behind a hole of a pattern.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Retract {
    /// To the second set-up clearance, or to the set-up clearance where that is higher.
    Far,
    /// To the set-up clearance.
    Near,
    /// To this height, or to the 2nd set-up clearance where that is higher.
    To(f64),
}

/// Heights of a hole by their Q parameters, in mm.
#[derive(Debug, Clone, Copy)]
pub(super) struct Heights {
    pub surface: f64,
    pub clearance: f64,
    /// 2nd set-up clearance as an absolute height; not below the set-up clearance.
    pub second: f64,
}

impl Heights {
    /// Where rapid traverse ends.
    pub fn start(&self) -> f64 {
        self.surface + self.clearance
    }
}

impl Run<'_> {
    /// Are all parameters of the definition there? Looked at when it is complete.
    pub(super) fn check_definition(&mut self, cycle: &Machining) -> Outcome {
        let Some(needed) = needed(cycle.number) else { return Ok(()) };
        let missing: Vec<String> = needed.iter().filter(|q| !cycle.sets(**q)).map(|q| format!("Q{q}")).collect();
        if !missing.is_empty() {
            return self.fail_help(
                codes::K2402,
                self.block_span(),
                format!("cycle {} lacks {}", cycle.number, missing.join(", ")),
                "program all parameters of the cycle",
            );
        }
        if cycle.number < 20 {
            for part in 1..=parts(cycle.number) {
                if !cycle.has_part(part) {
                    return self.fail_help(
                        codes::K2402,
                        self.block_span(),
                        format!("cycle {0} lacks the value of part {0}.{part}", cycle.number),
                        "program all parts of the cycle",
                    );
                }
            }
        }
        Ok(())
    }

    /// Drills where the tool stands. `shift` lifts the surface, in mm.
    pub(super) fn drill(&mut self, cycle: &Machining, shift: f64, retract: Retract) -> Outcome {
        if self.st.side != Side::None {
            self.report(
                Diagnostic::new(codes::K2407, self.here.origin.loc, "a cycle is called while RL or RR is active")
                    .help("program a straight block with R0 in front of the call"),
            );
            return Err(Reported);
        }
        // The control itself starts the spindle for rigid tapping.
        if self.st.spindle.is_none() && !matches!(cycle.number, 17 | 207) {
            self.report(
                Diagnostic::new(codes::K2405, self.here.origin.loc, "the spindle does not turn at this cycle call")
                    .also(cycle.loc, "the cycle is defined here")
                    .help("program M3 in front of the call"),
            );
            return Err(Reported);
        }
        if self.st.speed.is_none_or(|speed| speed <= 0.0) {
            self.report(
                Diagnostic::new(codes::K2405, self.here.origin.loc, "the spindle has no speed at this cycle call")
                    .also(cycle.loc, "the cycle is defined here")
                    .help("program S in the TOOL CALL"),
            );
            return Err(Reported);
        }
        self.cuts_now()?;
        self.check_pitch(cycle)?;
        if self.st.plunge_share.is_some() {
            self.report(
                Diagnostic::new(codes::K2709, self.here.origin.loc, "M103 does not change the feeds of this cycle")
                    .help("program M103 without F in front of the cycle, or the feed of the cycle as it is meant"),
            );
        }
        let Some(hole) = self.hole(cycle, shift, retract)? else { return Ok(()) };
        if let Err(fault) = hole.check() {
            return self.cycle_value(cycle, &fault_text(fault));
        }
        let cycle = Cycle::Drilling(hole);
        let end = cycle.leaves(self.st.position.at());
        self.out.cycle(&cycle, &self.st.ctx, &self.here.origin);
        let axis = self.st.axis();
        self.st.position.cycle_leaves(&end, AxisSet::of(axis));
        self.st.moved = true;
        if matches!(cycle, Cycle::Drilling(Drilling { method: Method::Tap(Tap { after: Spindle::Stop, .. }), .. })) {
            self.st.spindle = None;
        }
        Ok(())
    }

    /// A scaling changes the depth of a thread, but no tap has another pitch.
    fn check_pitch(&mut self, cycle: &Machining) -> Outcome {
        let t = &self.st.transform;
        let scaled = t.scale != 1.0 || t.axis_scale != [1.0; 3];
        if scaled && matches!(cycle.number, 2 | 17 | 206 | 207) {
            return self.cycle_unbuilt(cycle, "tapping under a scaling, which would change the pitch of the thread,");
        }
        Ok(())
    }

    fn hole(&mut self, cycle: &Machining, shift: f64, retract: Retract) -> Outcome<Option<Drilling>> {
        let axis = self.st.axis();
        if !AxisSet::MAIN.contains(axis) {
            return self.cycle_value(cycle, &format!("the tool axis {} cannot drill", axis.letter()));
        }
        if matches!(cycle.number, 1 | 2 | 17) {
            return self.old_hole(cycle, axis).map(Some);
        }
        let heights = self.heights(cycle, shift)?;
        let deep = self.depth_of(cycle)?;
        if deep == 0.0 {
            self.report(
                Diagnostic::new(codes::K2404, self.here.origin.loc, format!("cycle {} has depth 0", cycle.number))
                    .also(cycle.loc, "the cycle is defined here")
                    .help("program the depth Q201 with a minus sign"),
            );
            return Ok(None);
        }
        let far = match retract {
            Retract::Far => heights.second,
            Retract::Near => heights.start(),
            Retract::To(height) => height.max(heights.second),
        };
        let levels = Levels {
            retract: far,
            reference: heights.surface,
            clearance: heights.clearance,
            depth: heights.surface + deep,
        };
        let feed = match cycle.number {
            207 => Feed::PerMinute(1.0),
            _ => self.cycle_feed(cycle, 206, None)?,
        };
        let method = self.method(cycle, feed)?;
        Ok(Some(Drilling { axis, levels, feed, method }))
    }

    /// The heights that Q200, Q203 and Q204 give.
    pub(super) fn heights(&mut self, cycle: &Machining, shift: f64) -> Outcome<Heights> {
        let clearance = self.cycle_length(cycle, 200)?;
        if clearance < 0.0 {
            return self.cycle_value(cycle, &format!("the set-up clearance Q200 is {clearance}"));
        }
        let surface = self.cycle_length(cycle, 203)? + shift;
        let second = self.cycle_length(cycle, 204)?;
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

    /// Depth from the surface, negative or 0.
    fn depth_of(&mut self, cycle: &Machining) -> Outcome<f64> {
        if cycle.number == 240 && self.cycle_number(cycle, 343)? != 0.0 {
            return self.cycle_unbuilt(cycle, "centring by the diameter (Q343=1) needs the tip angle of the tool");
        }
        let deep = self.cycle_length(cycle, 201)?;
        if deep > 0.0 {
            return self.cycle_value(cycle, &format!("the depth Q201 = {deep} is positive"));
        }
        Ok(deep)
    }

    fn method(&mut self, cycle: &Machining, feed: Feed) -> Outcome<Method> {
        if self.cycle_option(cycle, 395)? != 0.0 {
            return self.cycle_unbuilt(cycle, "a depth that counts from the full diameter (Q395=1)");
        }
        let dwell = match cycle.number {
            207 => 0.0,
            _ => self.cycle_dwell(cycle, 211)?,
        };
        Ok(match cycle.number {
            201 => Method::Ream { dwell, back: self.cycle_feed(cycle, 208, Some(feed))? },
            202 => self.boring(cycle, dwell, feed)?,
            203 => self.universal(cycle, dwell, feed)?,
            205 => self.pecking(cycle, dwell)?,
            206 => self.tapping(dwell, None)?,
            207 => {
                let lead = self.cycle_length(cycle, 239)?;
                self.tapping(dwell, Some(lead))?
            }
            240 => {
                if self.cycle_option(cycle, 342)? != 0.0 {
                    return self.cycle_unbuilt(cycle, "centring of a hole that is drilled already (Q342)");
                }
                Method::Drill { dwell }
            }
            _ => {
                let ahead = self.cycle_length(cycle, 200)?;
                let first = self.infeed(cycle)?;
                let dwell_out = self.cycle_dwell(cycle, 210)?;
                Method::Deep(DeepHole {
                    first,
                    less: 0.0,
                    least: 0.0,
                    breaks: Breaks::Never,
                    way: 0.0,
                    ahead: [ahead; 2],
                    dwell_out,
                    dwell,
                    back: None,
                })
            }
        })
    }

    /// Q202.
    fn infeed(&mut self, cycle: &Machining) -> Outcome<f64> {
        let step = self.cycle_length(cycle, 202)?;
        if step <= 0.0 {
            return self.cycle_value(cycle, &format!("the plunging depth Q202 = {step} is not above zero"));
        }
        Ok(step)
    }

    fn universal(&mut self, cycle: &Machining, dwell: f64, feed: Feed) -> Outcome<Method> {
        let first = self.infeed(cycle)?;
        let ahead = self.cycle_length(cycle, 200)?;
        let times = self.cycle_number(cycle, 213)?;
        if !(times >= 0.0 && times.fract() == 0.0 && times <= 99_999.0) {
            return self.cycle_value(cycle, &format!("the number of chip breaks Q213 = {times} is no whole number"));
        }
        // Older software lifts by this fixed way.
        let way = if cycle.sets(256) { self.cycle_length(cycle, 256)? } else { LIFT };
        Ok(Method::Deep(DeepHole {
            first,
            less: self.cycle_length(cycle, 212)?,
            least: self.cycle_length(cycle, 205)?,
            breaks: if times > 0.0 { Breaks::Times(times as u32) } else { Breaks::Never },
            way,
            ahead: [ahead; 2],
            dwell_out: self.cycle_dwell(cycle, 210)?,
            dwell,
            back: self.retract_feed(cycle, 208, Some(feed))?,
        }))
    }

    fn pecking(&mut self, cycle: &Machining, dwell: f64) -> Outcome<Method> {
        if self.cycle_option(cycle, 379)? != 0.0 {
            return self.cycle_unbuilt(cycle, "a deepened start (Q379)");
        }
        let first = self.infeed(cycle)?;
        let ahead = [self.cycle_length(cycle, 258)?, self.cycle_length(cycle, 259)?];
        if ahead[0] != ahead[1] {
            self.job.diags.push_once(Diagnostic::new(
                codes::K2408,
                self.here.origin.loc,
                "the advanced stop distance changes from Q258 to Q259 in even steps",
            ));
        }
        let every = self.cycle_length(cycle, 257)?;
        let back = if cycle.sets(208) { self.retract_feed(cycle, 208, None)? } else { None };
        Ok(Method::Deep(DeepHole {
            first,
            less: self.cycle_length(cycle, 212)?,
            least: self.cycle_length(cycle, 205)?,
            breaks: if every > 0.0 { Breaks::Every(every) } else { Breaks::Never },
            way: self.cycle_length(cycle, 256)?,
            ahead,
            dwell_out: 0.0,
            dwell,
            back,
        }))
    }

    fn boring(&mut self, cycle: &Machining, dwell: f64, feed: Feed) -> Outcome<Method> {
        let lift = match self.cycle_number(cycle, 214)? {
            0.0 => [0.0; 3],
            1.0 => [-LIFT, 0.0, 0.0],
            2.0 => [0.0, -LIFT, 0.0],
            3.0 => [LIFT, 0.0, 0.0],
            4.0 => [0.0, LIFT, 0.0],
            other => {
                return self.cycle_value(cycle, &format!("the disengaging direction Q214 = {other} is not 0 to 4"));
            }
        };
        let back = self.retract_feed(cycle, 208, Some(feed))?;
        // Whole turns more or less are the same angle, and the target takes 0 to 360.
        let angle = self.cycle_option(cycle, 336)?;
        let orient = if (0.0..=360.0).contains(&angle) { angle } else { angle.rem_euclid(360.0) };
        if lift != [0.0; 3] {
            if *self.st.ctx.frame.linear() != nalgebra::Matrix3::identity() {
                return self.cycle_unbuilt(cycle, "lifting the edge off the wall under a mirror, rotation or scaling");
            }
            let (first, second, _) = self.st.plane().axes();
            for axis in [first, second] {
                self.position_of(Axis::ALL[axis], self.block_span(), "cycle 202")?;
            }
        }
        let turn = self.st.spindle.unwrap_or(Turn::Clockwise);
        Ok(Method::Bore(Bore { dwell, turn, orient, back, lift }))
    }

    /// `lead` is positive for a right-hand thread; without one the feed of the hole holds both ways.
    fn tapping(&mut self, dwell: f64, lead: Option<f64>) -> Outcome<Method> {
        let here = self.here.origin.loc;
        self.job.diags.push_once(Diagnostic::new(
            codes::K2409,
            here,
            "the spindle is reversed by M4 and M3: the tap needs a compensating chuck on the target",
        ));
        let turn = match lead {
            Some(lead) if lead < 0.0 => Turn::CounterClockwise,
            Some(_) => Turn::Clockwise,
            None => self.st.spindle.unwrap_or(Turn::Clockwise),
        };
        Ok(Method::Tap(Tap {
            lead: lead.map(f64::abs),
            turn,
            dwell,
            dwell_reversed: true,
            speed_in: None,
            speed_out: None,
            orient: None,
            step: None,
            after: if lead.is_some() { Spindle::Stop } else { Spindle::Start(turn) },
            speed_after: None,
        }))
    }

    /// Cycles 1, 2 and 17: the tool stands at the set-up clearance and comes back to it.
    fn old_hole(&mut self, cycle: &Machining, axis: Axis) -> Outcome<Drilling> {
        let span = self.block_span();
        let start = self.position_of(axis, span, &format!("cycle {}", cycle.number))?;
        let mm = cycle.mm;
        // The signs of the set-up clearance and the pecking depth have no meaning: old programs give all the same.
        let clearance = self.part(cycle, 1)?.abs() * mm;
        let deep = self.part(cycle, 2)? * mm;
        if deep > 0.0 {
            return self.cycle_value(cycle, "the depth is positive");
        }
        if deep == 0.0 {
            return self.cycle_value(cycle, "the depth is 0");
        }
        let reference = start - clearance;
        let levels = Levels { retract: start, reference, clearance, depth: reference + deep };
        let (feed, method) = match cycle.number {
            1 => {
                let first = self.part(cycle, 3)?.abs() * mm;
                let ahead = if -deep <= SHALLOW { NEAR } else { (-deep / SHARE).min(FURTHEST) };
                let dwell = self.part_dwell(cycle, 4)?;
                let deep = DeepHole {
                    first,
                    less: 0.0,
                    least: 0.0,
                    breaks: Breaks::Never,
                    way: 0.0,
                    ahead: [ahead; 2],
                    dwell_out: 0.0,
                    dwell,
                    back: None,
                };
                (self.part_feed(cycle, 5)?, Method::Deep(deep))
            }
            2 => {
                let dwell = self.part_dwell(cycle, 3)?;
                (self.part_feed(cycle, 4)?, self.tapping(dwell, None)?)
            }
            _ => {
                let lead = self.part(cycle, 3)? * mm;
                (Feed::PerMinute(1.0), self.tapping(0.0, Some(lead))?)
            }
        };
        Ok(Drilling { axis, levels, feed, method })
    }

    fn part(&mut self, cycle: &Machining, part: u32) -> Outcome<f64> {
        match cycle.part(part) {
            Some(value) => Ok(value),
            None => self.cycle_value(cycle, &format!("part {}.{part} has no value", cycle.number)),
        }
    }

    fn part_dwell(&mut self, cycle: &Machining, part: u32) -> Outcome<f64> {
        let seconds = self.part(cycle, part)?;
        self.check_dwell(cycle, seconds)
    }

    fn part_feed(&mut self, cycle: &Machining, part: u32) -> Outcome<Feed> {
        let value = self.part(cycle, part)?;
        self.check_feed(cycle, value)
    }

    // Values by their Q parameters.

    /// What the parameter holds now.
    pub(super) fn cycle_number(&mut self, cycle: &Machining, q: u32) -> Outcome<f64> {
        if let Some(word) = cycle.word(q) {
            return self.cycle_unbuilt(cycle, &format!("{word} as the value of Q{q}"));
        }
        if !cycle.sets(q) {
            return self.cycle_value(cycle, &format!("Q{q} is missing"));
        }
        let span = self.block_span();
        self.parameter(crate::lexer::klartext::QRef { kind: crate::lexer::klartext::QKind::Q, number: q }, span)
    }

    pub(super) fn cycle_length(&mut self, cycle: &Machining, q: u32) -> Outcome<f64> {
        let mm = self.level().unit.mm();
        Ok(self.cycle_number(cycle, q)? * mm)
    }

    /// A parameter that newer software has: 0 where the definition does not set it.
    pub(super) fn cycle_option(&mut self, cycle: &Machining, q: u32) -> Outcome<f64> {
        if cycle.sets(q) || cycle.word(q).is_some() { self.cycle_number(cycle, q) } else { Ok(0.0) }
    }

    fn cycle_dwell(&mut self, cycle: &Machining, q: u32) -> Outcome<f64> {
        let seconds = self.cycle_option(cycle, q)?;
        self.check_dwell(cycle, seconds)
    }

    fn check_dwell(&mut self, cycle: &Machining, seconds: f64) -> Outcome<f64> {
        if (0.0..=LONGEST).contains(&seconds) {
            return Ok(seconds);
        }
        self.cycle_value(cycle, &format!("a dwell of {seconds} s is out of range"))
    }

    /// A feed; 0 stands for `instead` where that is given.
    fn cycle_feed(&mut self, cycle: &Machining, q: u32, instead: Option<Feed>) -> Outcome<Feed> {
        if cycle.word(q) == Some("FAUTO") {
            return self.tool_feed_of(cycle, q);
        }
        let value = self.cycle_number(cycle, q)?;
        match instead {
            Some(feed) if value == 0.0 => Ok(feed),
            _ => self.check_feed(cycle, value),
        }
    }

    /// FAUTO: the F of the last TOOL CALL.
    fn tool_feed_of(&mut self, cycle: &Machining, q: u32) -> Outcome<Feed> {
        match self.st.tool_feed {
            Some((feed, _)) if matches!(feed, Feed::PerRevolution(_)) == self.st.per_revolution => Ok(feed),
            Some(_) => self.cycle_unbuilt(cycle, &format!("Q{q}=FAUTO with a TOOL CALL that counts F in another way")),
            None => {
                self.report(
                    Diagnostic::new(
                        codes::K2003,
                        self.here.origin.loc,
                        format!("the last TOOL CALL has no F, so Q{q}=FAUTO has no value"),
                    )
                    .also(cycle.loc, "the cycle is defined here")
                    .help("put F into the TOOL CALL, or a number behind the parameter"),
                );
                Err(Reported)
            }
        }
    }

    /// A retract: FMAX is rapid traverse.
    fn retract_feed(&mut self, cycle: &Machining, q: u32, instead: Option<Feed>) -> Outcome<Option<Feed>> {
        if cycle.word(q) == Some("FMAX") { Ok(None) } else { self.cycle_feed(cycle, q, instead).map(Some) }
    }

    fn check_feed(&mut self, cycle: &Machining, value: f64) -> Outcome<Feed> {
        if value > 0.0 {
            self.large_per_revolution(cycle.loc, value);
            return Ok(self.feed_of(value));
        }
        self.cycle_value(cycle, &format!("a feed of {value} is not above zero"))
    }

    /// Refuses a value of the cycle.
    pub(super) fn cycle_value<T>(&self, cycle: &Machining, what: &str) -> Outcome<T> {
        self.report(
            Diagnostic::new(codes::K2403, self.here.origin.loc, format!("cycle {}: {what}", cycle.number))
                .also(cycle.loc, "the cycle is defined here")
                .help("check the values of the definition"),
        );
        Err(Reported)
    }

    /// Refuses a variant that is not built.
    pub(super) fn cycle_unbuilt<T>(&self, cycle: &Machining, what: &str) -> Outcome<T> {
        self.report(
            Diagnostic::new(
                codes::K9001,
                self.here.origin.loc,
                format!("cycle {}: {what} is not supported", cycle.number),
            )
            .also(cycle.loc, "the cycle is defined here")
            .help("use the plain variant of the cycle, or program its moves as blocks"),
        );
        Err(Reported)
    }
}

fn fault_text(fault: DrillingFault) -> String {
    fault.to_string()
}
