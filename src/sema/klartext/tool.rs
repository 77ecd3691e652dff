//! TOOL DEF and TOOL CALL.
//!
//! Source: K 1.5 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::ir::{Feed, Function};
use crate::lexer::klartext::Value;
use crate::machine::Axis;
use crate::parser::klartext::ast::{Addr, Block, Word};
use crate::text::Span;

use super::feed::ToolFeed;
use super::place::View;
use super::reading::Reading;
use super::tool_table::Named;
use super::{Outcome, Run};

/// The words behind the tool of a TOOL CALL.
#[derive(Debug, Default)]
struct Call {
    axis: Option<Axis>,
    speed: Option<f64>,
    speed_span: Span,
    feed: Option<f64>,
    /// FU, FZ, or F.
    feed_word: Option<Addr>,
    feed_span: Span,
    /// DL, DR, DR2 as far as written.
    deltas: [Option<f64>; 3],
}

impl Call {
    /// The words behind the tool of a TOOL CALL.
    fn read(reading: Reading<'_, '_>, words: &[Word], block: &Block) -> Outcome<Call> {
        let mm = reading.core.mm();
        let mut call = Call::default();
        for &word in words {
            let delta = match word.addr {
                Addr::DeltaLength => Some(0),
                Addr::DeltaRadius => Some(1),
                Addr::DeltaRadius2 => Some(2),
                _ => None,
            };
            let slot = match (word.addr, delta) {
                (_, Some(i)) => &mut call.deltas[i],
                (Addr::Speed, _) => &mut call.speed,
                (Addr::Feed | Addr::FeedPerRev, _) => &mut call.feed,
                (Addr::FeedOther, _) => {
                    reading.core.counts_teeth(word)?;
                    &mut call.feed
                }
                // `S( VC = 120 )`
                (Addr::CuttingSpeed, _) => {
                    let text = reading.core.word_text(word.span);
                    return reading.core.refuse(word.span, codes::P9011::is_cutting_speed(&text));
                }
                (Addr::Axis { axis, incremental: false }, _) if word.value == Value::None && !axis.is_rotary() => {
                    if call.axis.replace(axis).is_some() {
                        return reading.core.twice(word, block);
                    }
                    continue;
                }
                (Addr::FeedEmpty, _) => continue,
                _ => return reading.core.not_admitted(word, "TOOL CALL"),
            };
            if slot.is_some() {
                return reading.core.twice(word, block);
            }
            match word.addr {
                Addr::Speed => call.speed_span = word.span,
                Addr::Feed | Addr::FeedPerRev | Addr::FeedOther => {
                    (call.feed_span, call.feed_word) = (word.span, Some(word.addr));
                }
                _ => {}
            }
            let value = reading.number(word.value, word.span)?;
            *slot = Some(if delta.is_some() { value * mm } else { value });
        }
        Ok(call)
    }

    /// F, FU or FZ of a TOOL CALL.
    fn feed(&self, view: View<'_, '_>, written: f64) -> Outcome<ToolFeed> {
        let span = self.feed_span;
        if written <= 0.0 {
            return view.core.feed_not_positive(span, written);
        }
        let mm = view.core.mm();
        let per_tooth = self.feed_word == Some(Addr::FeedOther);
        let feed = match self.feed_word {
            Some(Addr::FeedPerRev) => Feed::PerRevolution(written * mm),
            Some(Addr::FeedOther) => view.st.tool.feed_of_teeth(view.core, written * mm, span)?,
            _ => view.st.feed.counted(written, view.core.unit()),
        };
        let by_word = per_tooth || self.feed_word == Some(Addr::FeedPerRev);
        if by_word {
            view.core.reads_feed_by_word(span);
        }
        let written = if by_word { feed.value() / mm } else { written };
        Ok(ToolFeed { feed, written, by_word, per_tooth })
    }
}

impl View<'_, '_> {
    /// G43 of the target adds the length of the tool to Z.
    fn length_acts_along_z(&self, tool: Option<&Named>, span: Span) -> Outcome {
        let axis = self.st.axis();
        let none = tool.is_none_or(Named::is_none);
        if axis == Axis::Z || none || !self.core.job.settings.output.prints_tool_length() {
            return Ok(());
        }
        let [who, help] = self.core.job.settings.output.length_along_z();
        let fault = codes::O9190::with_tool_axis_length_of_tool_acts(&axis.letter(), &who);
        self.core.refuse(span, fault.help(Answer::key("output", "tool_length").one_of(&["\"off\""]).help(help)))
    }
}

impl Run<'_> {
    /// `TOOL DEF 5 L+0 R+4` defines a tool; `TOOL DEF 5` alone tells the changer which one comes next.
    pub(super) fn tool_def(&mut self, block: &Block, text: &[u8]) -> Outcome {
        let Some((tool, rest)) = Named::first(self.reading(), &block.words, text)? else {
            return self.core.refuse(block.span, codes::P1004::tool_def_names_no_tool());
        };
        let mm = self.core.mm();
        let (mut length, mut radius) = (None, None);
        let mut at = 0;
        while let Some(&word) = rest.get(at) {
            at += 1;
            let repeated = match word.addr {
                Addr::Length | Addr::Name => length.is_some(),
                Addr::Radius { .. } => radius.is_some(),
                _ => false,
            };
            if repeated {
                return self.core.twice(word, block);
            }
            match word.addr {
                Addr::Length => length = Some(self.reading().number(word.value, word.span)? * mm),
                Addr::Radius { .. } => radius = Some(self.reading().number(word.value, word.span)? * mm),
                // `L+Q5`: the parameter stands by itself.
                Addr::Name if word.span.of(text).eq_ignore_ascii_case(b"L") => match rest.get(at) {
                    Some(value) if value.addr == Addr::Value => {
                        length = Some(self.reading().number(value.value, value.span)? * mm);
                        at += 1;
                    }
                    _ => return self.core.refuse(word.span, codes::P1004::l_lacks_its_value()),
                },
                Addr::RadiusEmpty => {}
                _ => return self.core.not_admitted(word, "TOOL DEF"),
            }
        }
        if length.is_some() || radius.is_some() {
            let Named::Number(number, _) = tool else {
                return self.core.refuse(block.span, codes::K2010::tool_that_program_defines_needs_number());
            };
            self.tools.define(number, length, radius);
            return Ok(());
        }
        let (number, _) = self.tools.look_up(&self.core, &tool, block.span)?;
        self.function(Function::ToolPrepare { number });
        Ok(())
    }

    pub(super) fn tool_call(&mut self, block: &Block, text: &[u8]) -> Outcome {
        let (tool, rest) = match Named::first(self.reading(), &block.words, text)? {
            Some((tool, rest)) => (Some(tool), rest),
            None => (None, block.words.as_slice()),
        };
        let call = Call::read(self.reading(), rest, block)?;
        if let Some(delta) = call.deltas[2].filter(|delta| *delta != 0.0) {
            self.core.say(block.span, codes::K2014::dr2_mm_changes_no_path(&delta));
        }
        self.st.refuse_compensated(&mut self.core, "TOOL CALL stands");
        // The side stays: a contour that goes on compensated behind a tool change is refused.
        if self.st.compensation.is_on() && tool.is_some() {
            self.core.say_here(codes::P2041::tool_call_ends_radius_compensation());
        }
        if call.axis.is_none() && self.st.tool.axis().is_none() && tool.as_ref().is_some_and(|tool| !tool.is_none()) {
            return self.core.refuse(block.span, codes::K2004::first_tool_call_has_no_tool_axis());
        }
        if tool.is_some() && self.st.tilt.plane().is_some() {
            let fault = codes::K2857::what_stands_in_tilted_plane(&"TOOL CALL");
            return self.st.refuse_motion(&mut self.core, block.span, fault);
        }
        let turned = call.axis.is_some_and(|axis| self.st.tool.set_axis(axis));
        if turned {
            self.function(Function::Plane(self.st.plane()));
            let transform = self.st.frames.transform();
            if transform.angle.0 != 0.0 && transform.plane != self.st.plane() {
                self.core.say_here(codes::K2511::tool_axis_becomes(&self.st.axis().letter()));
            }
        }
        self.view().length_acts_along_z(tool.as_ref(), block.span)?;
        match &tool {
            Some(tool) => self.change_tool(tool, &call, turned, block.span)?,
            None => self.change_deltas(&call),
        }
        self.update_frame(block.span)?;
        if let Some(speed) = call.speed {
            let function = self.st.spindle.set_speed(&self.core, speed, call.speed_span)?;
            self.function(function);
        }
        if let Some(feed) = call.feed {
            // It holds until another one is programmed, in a block or a TOOL CALL.
            let feed = call.feed(self.view(), feed)?;
            self.st.feed.program_of_tool(feed);
        } else if tool.is_some() {
            self.st.feed.reset_of_tool(self.core.job.settings.control.feed);
        }
        Ok(())
    }

    fn change_tool(&mut self, named: &Named, call: &Call, turned: bool, span: Span) -> Outcome {
        self.core.job.calls_tool_in(self.core.unit(), self.core.loc(span));
        let tool = self.tools.called(&self.core, named, call.deltas, self.st.tool.is_measured(), span)?;
        // The tool that is in the spindle stays there, and its tip where it is. What a call does to a contour under way
        // is open even then.
        let stays = self.st.tool.active().is_some_and(|active| {
            !turned
                && !self.st.compensation.is_on()
                && (active.number, &active.called) == (tool.number, &tool.called)
                && (active.length, active.radius) == (tool.length, tool.radius)
        });
        if stays {
            self.st.tool.call_again();
            self.change_deltas(call);
            return Ok(());
        }
        let number = tool.number;
        self.st.feed.change_teeth();
        self.st.tool.replace(tool, &self.st.position);
        self.call_for_change(number);
        self.st.tool.cutter().into_iter().for_each(|cutter| self.function(cutter));
        Ok(())
    }

    /// The oversizes are set anew.
    fn change_deltas(&mut self, call: &Call) {
        if self.st.tool.change_deltas(call.deltas) {
            self.core.say_here(codes::K2009::this_tool_call_does_not_repeat_oversizes());
        }
        self.st.tool.cutter().into_iter().for_each(|cutter| self.function(cutter));
    }
}
