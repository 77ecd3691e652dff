//! TOOL DEF, TOOL CALL, and what other blocks ask of the active tool.
//!
//! Source: K 1.5 (docs/sources.md).

use rustc_hash::FxHashMap;

use crate::diag::{Answer, codes};
use crate::ir::function::{CutterData, Spindle};
use crate::ir::{Feed, Function};
use crate::lexer::klartext::Value;
use crate::machine::tools::ToolKey;
use crate::machine::{Axis, AxisSet, Tool};
use crate::parser::klartext::ast::{Addr, Block, Word};
use crate::text::Span;

use super::active_tool::{ActiveTool, Change};
use super::feed::ToolFeed;
use super::vars::Val;
use super::{Outcome, Reported, Run};

/// Highest tool number.
const MOST_TOOLS: f64 = 32767.0;
/// How far two radii of one tool may lie apart by rounding, in mm: a value in inches has no whole micrometre.
const SAME_RADIUS: f64 = 0.001 + 1e-9;

/// A tool as a block names it.
#[derive(Debug, Clone, PartialEq)]
enum Named {
    Number(u32, u8),
    Name(String),
}

impl std::fmt::Display for Named {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Named::Number(n, 0) => write!(f, "{n}"),
            Named::Number(n, index) => write!(f, "\"{n}.{index}\""),
            Named::Name(name) => write!(f, "\"{name}\""),
        }
    }
}

/// Tools that the program itself defines: length and radius in mm.
pub(super) type Defined = FxHashMap<u32, (Option<f64>, Option<f64>)>;

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

/// Are these two radii, or one that was computed and rounded?
fn differs(a: f64, b: f64) -> bool {
    (a - b).abs() > SAME_RADIUS
}

/// The tool that was called, and the one in the spindle.
#[derive(Debug, Clone, Default)]
pub(super) struct ToolState {
    active: Option<ActiveTool>,
    axis: Option<Axis>,
    /// The tool change under way.
    pub change: Change,
    /// Number of the tool that the last change printed.
    pub in_spindle: Option<u32>,
    /// A cycle that measures tools was left out: what the tables say of them is not what the control has.
    measured: bool,
    /// Axes that moved in the work offset in force with tools before this one.
    pub worked: AxisSet,
}

impl ToolState {
    /// The tool that was called last.
    pub fn active(&self) -> Option<&ActiveTool> {
        self.active.as_ref()
    }

    /// Tool axis of the last TOOL CALL that named one.
    #[inline]
    pub fn axis(&self) -> Option<Axis> {
        self.axis
    }

    pub fn is_measured(&self) -> bool {
        self.measured
    }

    /// A cycle that measures tools was left out: their sizes are the machine's.
    pub fn measure(&mut self) {
        self.measured = true;
        if let Some(tool) = &mut self.active {
            (tool.length, tool.radius, tool.corner_radius) = (None, None, None);
        }
    }
}

impl Run<'_> {
    /// `TOOL DEF 5 L+0 R+4` defines a tool; `TOOL DEF 5` alone tells the changer which one comes next.
    pub(super) fn tool_def(&mut self, block: &Block, text: &[u8]) -> Outcome {
        let Some((tool, rest)) = self.named_tool(&block.words, text)? else {
            return self.core.refuse(block.span, codes::P1004::tool_def_names_no_tool());
        };
        let mm = self.core.level().frame.unit.mm();
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
                return self.twice(word, block);
            }
            match word.addr {
                Addr::Length => length = Some(self.number(word.value, word.span)? * mm),
                Addr::Radius { .. } => radius = Some(self.number(word.value, word.span)? * mm),
                // `L+Q5`: the parameter stands by itself.
                Addr::Name if word.span.of(text).eq_ignore_ascii_case(b"L") => match rest.get(at) {
                    Some(value) if value.addr == Addr::Value => {
                        length = Some(self.number(value.value, value.span)? * mm);
                        at += 1;
                    }
                    _ => return self.core.refuse(word.span, codes::P1004::l_lacks_its_value()),
                },
                Addr::RadiusEmpty => {}
                _ => return self.not_admitted(word, "TOOL DEF"),
            }
        }
        if length.is_some() || radius.is_some() {
            let Named::Number(number, _) = tool else {
                return self.core.refuse(block.span, codes::K2010::tool_that_program_defines_needs_number());
            };
            self.defined.insert(number, (length, radius));
            return Ok(());
        }
        let (number, _) = self.look_up(&tool, block.span)?;
        self.function(Function::ToolPrepare { number });
        Ok(())
    }

    pub(super) fn tool_call(&mut self, block: &Block, text: &[u8]) -> Outcome {
        let (tool, rest) = match self.named_tool(&block.words, text)? {
            Some((tool, rest)) => (Some(tool), rest),
            None => (None, block.words.as_slice()),
        };
        let call = self.call_words(rest, block)?;
        self.note_corner_radius(&call, block.span);
        self.refuse_compensated("TOOL CALL stands");
        // The side stays: a contour that goes on compensated behind a tool change is refused.
        if self.st.compensation.is_on() && tool.is_some() {
            self.core.report(codes::P2041::tool_call_ends_radius_compensation().at(self.core.here.origin.loc));
        }
        if call.axis.is_none()
            && self.st.tool.axis.is_none()
            && tool.as_ref().is_some_and(|t| *t != Named::Number(0, 0))
        {
            return self.core.refuse(block.span, codes::K2004::first_tool_call_has_no_tool_axis());
        }
        let turned = call.axis.is_some_and(|axis| self.st.tool.axis != Some(axis));
        if let Some(axis) = call.axis {
            self.set_tool_axis(axis);
        }
        self.length_acts_along_z(tool.as_ref(), block.span)?;
        match &tool {
            Some(tool) => self.change_tool(tool, &call, turned, block.span)?,
            None => self.change_deltas(&call),
        }
        self.update_frame(block.span)?;
        if let Some(speed) = call.speed {
            self.spindle_speed(speed, call.speed_span)?;
        }
        if let Some(feed) = call.feed {
            // It holds until another one is programmed, in a block or a TOOL CALL.
            let feed = self.feed_of_call(&call, feed)?;
            self.st.feed.program_of_tool(feed);
        } else if tool.is_some() {
            self.st.feed.reset_of_tool(self.core.job.settings.control.feed);
        }
        Ok(())
    }

    /// F, FU or FZ of a TOOL CALL.
    fn feed_of_call(&mut self, call: &Call, written: f64) -> Outcome<ToolFeed> {
        let span = call.feed_span;
        if written <= 0.0 {
            return self.feed_not_positive(span, written);
        }
        let mm = self.core.level().frame.unit.mm();
        let per_tooth = call.feed_word == Some(Addr::FeedOther);
        let feed = match call.feed_word {
            Some(Addr::FeedPerRev) => Feed::PerRevolution(written * mm),
            Some(Addr::FeedOther) => self.feed_of_teeth(written * mm, span)?,
            _ => self.feed_of(written),
        };
        let by_word = per_tooth || call.feed_word == Some(Addr::FeedPerRev);
        if by_word {
            self.reads_feed_by_word(span);
        }
        let written = if by_word { feed.value() / mm } else { written };
        Ok(ToolFeed { feed, written, by_word, per_tooth })
    }

    /// How FU and FZ are written outside of path blocks is not confirmed by a manual page.
    pub(super) fn reads_feed_by_word(&self, span: Span) {
        let text = self.word_text(span);
        let what = if text.to_ascii_uppercase().contains("FZ") { "for each tooth" } else { "for each revolution" };
        self.core.report_once(codes::K8026::is_read_as_feed(&text, &what).at(self.core.loc(span)));
    }

    /// G43 of the target adds the length of the tool to Z.
    fn length_acts_along_z(&self, tool: Option<&Named>, span: Span) -> Outcome {
        let axis = self.st.axis();
        let none = tool.is_none_or(|tool| *tool == Named::Number(0, 0));
        if axis == Axis::Z || none || !self.core.job.settings.output.prints_tool_length() {
            return Ok(());
        }
        let [who, help] = self.core.job.settings.output.length_along_z();
        self.core.refuse(
            span,
            codes::O9190::with_tool_axis_length_of_tool_acts(&axis.letter(), &who)
                .help(Answer::key("output", "tool_length").one_of(&["\"off\""]).help(help)),
        )
    }

    fn set_tool_axis(&mut self, axis: Axis) {
        let changed = self.st.tool.axis != Some(axis);
        self.st.tool.axis = Some(axis);
        if changed {
            self.function(Function::Plane(self.st.plane()));
            if self.st.frames.transform().angle.0 != 0.0 && self.st.frames.transform().plane != self.st.plane() {
                self.core.report(codes::K2511::tool_axis_becomes(&axis.letter()).at(self.core.here.origin.loc));
            }
        }
    }

    /// The words behind the tool of a TOOL CALL.
    fn call_words(&mut self, words: &[Word], block: &Block) -> Outcome<Call> {
        let mm = self.core.level().frame.unit.mm();
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
                (Addr::FeedOther, _) if self.counts_teeth(word) => &mut call.feed,
                (Addr::FeedOther, _) => return self.feed_by_time(word),
                (Addr::CuttingSpeed, _) => return self.cutting_speed(word),
                (Addr::Axis { axis, incremental: false }, _) if word.value == Value::None && !axis.is_rotary() => {
                    if call.axis.replace(axis).is_some() {
                        return self.twice(word, block);
                    }
                    continue;
                }
                (Addr::FeedEmpty, _) => continue,
                _ => return self.not_admitted(word, "TOOL CALL"),
            };
            if slot.is_some() {
                return self.twice(word, block);
            }
            match word.addr {
                Addr::Speed => call.speed_span = word.span,
                Addr::Feed | Addr::FeedPerRev | Addr::FeedOther => {
                    (call.feed_span, call.feed_word) = (word.span, Some(word.addr));
                }
                _ => {}
            }
            let value = self.number(word.value, word.span)?;
            *slot = Some(if delta.is_some() { value * mm } else { value });
        }
        Ok(call)
    }

    /// `S( VC = 120 )`
    fn cutting_speed<T>(&self, word: Word) -> Outcome<T> {
        self.core.refuse(word.span, codes::P9011::is_cutting_speed(&self.word_text(word.span)))
    }

    /// Says once a tool that DR2 changes no path.
    fn note_corner_radius(&self, call: &Call, span: Span) {
        let Some(delta) = call.deltas[2].filter(|delta| *delta != 0.0) else { return };
        self.core.report(codes::K2014::dr2_mm_changes_no_path(&delta).at(self.core.loc(span)));
    }

    fn change_tool(&mut self, tool: &Named, call: &Call, turned: bool, span: Span) -> Outcome {
        let unit = self.core.level().frame.unit;
        self.core.job.calls_tool_in(unit, self.core.loc(span));
        let (number, data) = self.look_up(tool, span)?;
        let (mut length, mut radius, mut corner_radius) = (data.length, data.radius, data.corner_radius);
        if let Named::Number(n, 0) = tool {
            if let Some(&(l, r)) = self.defined.get(n) {
                length = l.or(length);
                radius = r.or(radius);
            }
            if *n == 0 {
                (length, radius) = (Some(0.0), Some(0.0));
            }
        }
        let mut other_radius = data.radius.filter(|table| radius.is_some_and(|own| differs(own, *table)));
        if self.st.tool.measured {
            other_radius = None;
            (length, radius, corner_radius) = (None, None, None);
        }
        // The tool that is in the spindle stays there, and its tip where it is. What a call does to a contour under way
        // is open even then.
        let stays = self.st.tool.active.as_ref().is_some_and(|active| {
            !turned
                && !self.st.compensation.is_on()
                && (active.number, &active.called) == (number, &tool.to_string())
                && (active.length, active.radius) == (length, radius)
        });
        if stays {
            self.st.call_again();
            self.change_deltas(call);
            return Ok(());
        }
        let own = match tool {
            Named::Number(own, _) => Some(*own),
            Named::Name(name) => match self.core.job.settings.tools.key_of_name(name, false) {
                Some(ToolKey::Number(own, _)) => Some(*own),
                _ => None,
            },
        };
        self.leave_tool();
        self.st.tool.active = Some(ActiveTool {
            number,
            own,
            called: tool.to_string(),
            radius,
            length,
            other_radius,
            corner_radius,
            plunge_angle: data.plunge_angle,
            teeth: data.teeth,
            tip_angle: data.tip_angle,
            table_deltas: data.deltas,
            call_deltas: call.deltas.map(Option::unwrap_or_default),
        });
        self.call_for_change(number);
        self.send_cutter();
        Ok(())
    }

    /// Another tool comes: what was moved with the one in the spindle, and what only it makes a feed of.
    fn leave_tool(&mut self) {
        self.st.feed.change_teeth();
        if self.st.tool.active.is_none() {
            return;
        }
        let at = &self.st.position;
        let moved: AxisSet = AxisSet::MAIN.iter().filter(|axis| at.get(*axis).is_some()).collect();
        self.st.tool.worked = self.st.tool.worked.union(moved);
    }

    /// TOOL CALL without a tool: the oversizes are set anew.
    fn change_deltas(&mut self, call: &Call) {
        let here = self.core.here.origin.loc;
        let Some(tool) = &mut self.st.tool.active else { return };
        let new = call.deltas.map(Option::unwrap_or_default);
        let dropped = tool.call_deltas.iter().zip(&call.deltas).any(|(old, new)| *old != 0.0 && new.is_none());
        tool.call_deltas = new;
        if dropped {
            self.core.report(codes::K2009::this_tool_call_does_not_repeat_oversizes().at(here));
        }
        self.send_cutter();
    }

    /// Tells what compensation has to know of the tool.
    fn send_cutter(&mut self) {
        let Some(tool) = &self.st.tool.active else { return };
        let changed = tool.call_deltas[1] != 0.0;
        let known = tool.effective_radius();
        let radius = if changed { known } else { None };
        let number = tool.number;
        self.function(Function::Cutter(CutterData { number, radius, known, ..CutterData::default() }));
    }

    /// Before RL or RR: is there a tool, and is its radius what the target believes?
    pub(super) fn check_cutter(&mut self, span: Span) -> Outcome {
        match &self.st.tool.active {
            None => self.core.refuse(span, codes::P2004::radius_compensation_without_tool()),
            Some(tool) if tool.call_deltas[1] != 0.0 && tool.radius.is_none() => {
                let called = tool.called.clone();
                self.core
                    .refuse(span, codes::P2004::tool_has_oversize_dr(&called).answer(Answer::tool(&called, "radius")))
            }
            Some(_) => self.one_radius(span),
        }
    }

    /// TOOL DEF and the tool table give the tool the same radius: the target may compensate by the table.
    fn one_radius(&self, span: Span) -> Outcome {
        let Some(tool) = &self.st.tool.active else { return Ok(()) };
        let (Some(own), Some(table)) = (tool.radius, tool.other_radius) else { return Ok(()) };
        let called = &tool.called;
        self.core.refuse(
            span,
            codes::K2890::tool_has_radius_in_its_tool_def(&called, &own, &table).answer(Answer::tool(called, "radius")),
        )
    }

    /// Radius of the active tool with its oversizes.
    pub(super) fn tool_radius(&mut self, span: Span) -> Outcome<f64> {
        self.one_radius(span)?;
        match &self.st.tool.active {
            Some(tool) => match tool.effective_radius() {
                Some(radius) => Ok(radius),
                None => {
                    let called = tool.called.clone();
                    self.core.refuse(
                        span,
                        codes::P2004::radius_of_tool_is_not_known(&called).answer(Answer::tool(&called, "radius")),
                    )
                }
            },
            None => self.core.refuse(span, codes::P2004::no_tool_is_called()),
        }
    }

    /// The radius of a tool by its number, with the oversize of the table, where it is known.
    pub(super) fn radius_by_number(&self, number: u32) -> Option<f64> {
        if self.st.tool.measured {
            return None;
        }
        let data = self.core.job.settings.tools.by_number(number, 0);
        let own = self.defined.get(&number).and_then(|(_, radius)| *radius);
        let radius = own.or_else(|| data.and_then(|data| data.radius))?;
        Some(radius + data.map_or(0.0, |data| data.deltas[1]))
    }

    pub(super) fn spindle_speed(&mut self, speed: f64, span: Span) -> Outcome {
        if speed < 0.0 {
            return self.core.refuse(span, codes::O9002::spindle_speed(&speed));
        }
        self.st.spindle.set_speed(speed);
        self.function(Function::Spindle(Spindle::Speed(speed)));
        Ok(())
    }

    /// The tool that the first word names, and the words behind it.
    fn named_tool<'w>(&mut self, words: &'w [Word], text: &[u8]) -> Outcome<Option<(Named, &'w [Word])>> {
        let Some((&first, rest)) = words.split_first() else { return Ok(None) };
        let name = |bytes: &[u8]| Named::Name(crate::text::decode::readable(bytes).trim_matches('"').to_owned());
        let tool = match (first.addr, first.value) {
            (Addr::Text, _) => name(first.span.of(text)),
            (Addr::Value, Value::Param { q, .. }) if q.is_text() => match self.read(q, first.span)? {
                Val::Text(text) => Named::Name(String::from_utf8_lossy(&text).into_owned()),
                _ => return self.core.refuse(first.span, codes::P2024::text_parameter_is_needed()),
            },
            (Addr::Value, Value::Number(_)) => self.tool_number(first.span.of(text), first.span)?,
            (Addr::Value, value) => {
                let n = self.number(value, first.span)?;
                self.tool_number(format!("{n}").as_bytes(), first.span)?
            }
            _ => return Ok(None),
        };
        Ok(Some((tool, rest)))
    }

    /// `5` or `5.2`.
    fn tool_number(&self, digits: &[u8], span: Span) -> Outcome<Named> {
        let text = String::from_utf8_lossy(digits);
        let text = text.trim_start_matches('+');
        let (number, index) = text.split_once(['.', ',']).unwrap_or((text, ""));
        let index = if index.trim_end_matches('0').is_empty() { Ok(0) } else { index.parse() };
        match (number.parse::<u32>(), index) {
            (Ok(number), Ok(index)) if f64::from(number) <= MOST_TOOLS => Ok(Named::Number(number, index)),
            _ => self.core.refuse(span, codes::K2010::is_no_tool_number(&text)),
        }
    }

    /// Number to print and data of a tool.
    fn look_up(&self, tool: &Named, span: Span) -> Outcome<(u32, Tool)> {
        let tools = &self.core.job.settings.tools;
        match tool {
            Named::Number(number, index) => {
                let data = tools.by_number(*number, *index);
                if data.is_none() && tools.complete && *number != 0 && !self.defined.contains_key(number) {
                    self.core.report(codes::P2006::tool_is_not_in_tool_table(&tool).at(self.core.loc(span)));
                }
                self.proposed.borrow_mut().call(*number);
                let data = data.cloned().unwrap_or_default();
                let printed = data.number.or((*index == 0).then_some(*number));
                match printed {
                    Some(printed) => {
                        self.core.prints_tool(&ToolKey::Number(*number, *index), printed, span)?;
                        Ok((printed, data))
                    }
                    None => self.core.refuse(
                        span,
                        codes::K2006::tool_is_index(&number, &index, &tool).answer(Answer::tool(tool, "number")),
                    ),
                }
            }
            Named::Name(name) => match tools.by_name(name) {
                Some((Some(number), data)) => {
                    if let Some(key) = tools.key_of_name(name, false) {
                        self.core.prints_tool(key, number, span)?;
                    }
                    Ok((number, data.clone()))
                }
                _ => {
                    let help = self.proposed.borrow_mut().help(name, tools);
                    let found = codes::K2005::tool_has_no_number(&tool).at(self.core.loc(span));
                    self.core.report(found.help(help));
                    Err(Reported)
                }
            },
        }
    }
}
