//! Feeds, tools, compensation, oversizes: what holds until it is changed.

use std::fmt::Display;

use crate::diag::{Answer, Fault, codes};
use crate::geo::Vec2;
use crate::ir::function::{Spindle, Turn};
use crate::ir::{self, Feed, Function, Side};
use crate::machine::tools::ToolKey;
use crate::machine::{AxisSet, Compensation, Settings};
use crate::sema::common::compensation::{compensate, nose_of, rules_of_nose};
use crate::sema::common::feed::{FeedKind, ModalFeed};
use crate::sema::common::hidden::By;
use crate::sema::run::Where;
use crate::sema::run::refusal::{Made, refused};
use crate::text::{Span, decode::readable};

use super::readings::Question;
use super::spindle::order;
use super::tool_facts::ActiveTool;
use super::words::{Fun, Num, Words};
use super::{Core, Outcome, Run};

/// Oversize of the next cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Oversize {
    /// G57: X as a diameter, Z, in mm.
    Paraxial { x: f64, z: f64 },
    /// G58: normal distance in mm.
    Equidistant(f64),
}

impl Oversize {
    /// The function that sets it.
    pub fn name(self) -> &'static str {
        match self {
            Oversize::Paraxial { .. } => "G57",
            Oversize::Equidistant(_) => "G58",
        }
    }
}

impl Words {
    /// G57.
    pub(super) fn paraxial(&self, mm: f64) -> Oversize {
        let value = |letter| self.value(letter).unwrap_or(0.0) * mm;
        Oversize::Paraxial { x: value(b'X'), z: value(b'Z') }
    }

    /// G58.
    pub(super) fn equidistant(&self, mm: f64) -> Made<Oversize> {
        Ok(Oversize::Equidistant(self.needed(b'P', "the oversize")?.value * mm))
    }

    /// G94 and G95.
    pub(super) fn feed_mode(&self, feed: &mut ModalFeed, kind: FeedKind, mm: f64) -> Made {
        match self.get(b'F') {
            Some(num) => {
                feed.assume(kind);
                num.feed(feed, mm)
            }
            None => {
                feed.count(kind);
                Ok(())
            }
        }
    }
}

impl Num {
    /// F.
    pub(super) fn feed(self, feed: &mut ModalFeed, mm: f64) -> Made {
        let value = self.value * mm;
        if value <= 0.0 {
            return refused(self.span, codes::O1001::feed(&self.value));
        }
        match feed.of(value) {
            Some(word) => {
                feed.program(word);
                Ok(())
            }
            None => refused(self.span, codes::P2002::neither_g94_nor_g95_says_what_f()),
        }
    }

    /// T: `T3`, `T3.1`, or the four digits of a tool and its offset.
    fn tool(self, written: &[u8]) -> Made<(u32, u8)> {
        let unclear = |fault: fn(&dyn Display) -> Fault| refused(self.span, fault(&readable(written)));
        let digits = written.get(1..).unwrap_or_default();
        let (whole, fraction) = match digits.iter().position(|b| *b == b'.') {
            Some(at) => (&digits[..at], &digits[at + 1..]),
            None => (digits, &[][..]),
        };
        let read = |text: &[u8]| std::str::from_utf8(text).ok().and_then(|text| text.parse::<u32>().ok());
        let whole_digits = !whole.is_empty() && whole.iter().all(u8::is_ascii_digit);
        let number =
            if whole_digits { read(whole) } else { Some(self.value).filter(|n| n.fract() == 0.0).map(|n| n as u32) };
        let Some(number) = number.filter(|_| (0.0..=99_999.0).contains(&self.value)) else {
            return unclear(codes::T2007::word_is_no_tool);
        };
        if !whole_digits || whole.len() < 4 {
            let edge = if whole_digits && !fraction.is_empty() { read(fraction) } else { Some(0) };
            return match edge.and_then(|edge| u8::try_from(edge).ok()) {
                Some(edge) => Ok((number, edge)),
                None => unclear(codes::T2007::word_is_no_edge),
            };
        }
        match (number / 100, number % 100) {
            (tool, offset) if tool == offset && whole.len() == 4 && fraction.is_empty() => Ok((tool, 0)),
            _ => unclear(codes::T2007::word_names_tool_and_offset_of_another),
        }
    }
}

/// How the compiler itself computes the path of the nose centre, for the function of this number.
fn rules(tool: Option<&ActiveTool>, number: u16, settings: &Settings) -> Result<ir::Compensation, Fault> {
    let what = match nose_of(tool.and_then(|tool| tool.known(settings))) {
        (Some(radius), Some(edge)) if radius >= 0.0 => return Ok(rules_of_nose(radius, edge)),
        (Some(0.0), None) => return Ok(rules_of_nose(0.0, Vec2::zeros())),
        (Some(radius), _) if radius < 0.0 => "the nose radius of the tool is below zero",
        (Some(_), _) => "the cutting-edge position of the tool is not known",
        (None, _) => "the nose radius of the tool is not known",
    };
    Err(codes::P2004::g_compensates_nose_radius(&number, &what)
        .answer(Answer::key("output", "compensation").one_of(&["\"control\""])))
}

impl Core<'_> {
    /// Feed of a move that cuts.
    #[inline]
    pub(super) fn cutting_feed(&self, feed: &mut ModalFeed) -> Outcome<Feed> {
        self.accept(Where::Block, feed.of_cut(codes::P2002::no_feed_is_programmed_before_this_cutting))
    }
}

impl Run<'_> {
    /// Prints the speed in force, which a word at `span` changed.
    pub(super) fn send_speed(&mut self, span: Span) {
        let Some((spindle, lowered)) = order(&self.st.spindle) else { return };
        if let Some(fault) = lowered {
            self.core.say(span, fault);
        }
        self.core.send_function(&Function::Spindle(spindle), &self.st.ctx);
    }

    pub(super) fn turn_spindle(&mut self, turn: Option<Turn>) {
        self.st.spindle.turns(turn);
        let spindle = turn.map_or(Spindle::Stop, Spindle::Start);
        self.core.send_function(&Function::Spindle(spindle), &self.st.ctx);
    }

    /// G40, G41, G42: compensation of the nose radius.
    pub(super) fn compensation(&mut self, side: Side, fun: Fun) -> Outcome {
        if side != Side::None {
            if ![Side::None, side].contains(&self.st.compensation.side()) {
                return self.core.refuse(fun.span, codes::T2021::g41_g42_follow_each_other_without_g40());
            }
            let settings = self.core.job.settings;
            if settings.output.compensation == Compensation::Resolve {
                let rules = self.core.accept(fun.span, rules(self.st.tool.as_ref(), fun.number, settings))?;
                if rules.radius > 0.0 {
                    self.core.depends_on(Question::NosePath, fun.span);
                }
                compensate(&mut self.st.ctx, rules);
            }
        }
        self.st.compensation.select(side);
        Ok(())
    }

    pub(super) fn tool_word(&mut self, num: Num, text: &[u8]) -> Outcome {
        let (number, edge) = self.core.made(num.tool(num.span.of(text)))?;
        if self.st.tool.as_ref().is_some_and(|tool| tool.number == number && tool.edge == edge) {
            return Ok(());
        }
        if self.st.compensation.is_on() {
            return self.core.refuse(num.span, codes::T2021::tool_changes_under_nose_radius_compensation());
        }
        let tool = ActiveTool { number, edge, name: self.sections.tool_name(number, edge) };
        self.core.job.calls_tool_in(self.st.unit, self.core.loc(num.span));
        let printed = self.core.accept(num.span, tool.printed(self.core.job.settings))?;
        self.core.send_tool(&ToolKey::Number(number, edge), printed, num.span, &self.st.ctx)?;
        self.st.tool = Some(tool);
        self.st.forget();
        self.st.position.hide(AxisSet::MAIN, By::ToolChange, self.core.here.origin.loc);
        // The lengths of a turning tool, which machine coordinates count without, are not in its table.
        self.core.stand_after_change(&mut self.st.position, &self.st.ctx);
        Ok(())
    }
}
