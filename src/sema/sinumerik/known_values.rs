//! System variables whose value follows from the program and `[tools]`.
//!
//! Source: S 4.7 and 5.7 (docs/sources.md).

use std::rc::Rc;

use crate::diag::codes;
use crate::ir::Feed;
use crate::ir::function::Turn;
use crate::machine::{Axis, Settings};
use crate::text::Span;

use super::diameter::Diameter;
use super::frames::FrameValue;
use super::g_groups::ActiveCodes;
use super::offsets::Outer;
use super::rotary::reduced;
use super::system::system_key;
use super::tool_questions::told_of_tool;
use super::value::{Val, whole};
use super::{Channel, Core, Outcome, Reported, State};

impl State {
    /// What the words of the program have set so far.
    fn set_by_words(&self, word: &str, args: &[Val]) -> Option<Val> {
        let tool = |number: u32| Val::Int(i32::try_from(number).unwrap_or(0));
        Some(match word {
            "$P_TOOLNO" => tool(self.tool.active()?),
            "$P_TOOLP" => tool(self.tool.next().or(self.tool.active())?),
            "$P_TOOL" => Val::Int(i32::try_from(self.tool.edge_or_first()).unwrap_or(1)),
            "$P_F" => Val::Real(match self.feed.word() {
                Some(feed @ Feed::InverseTime(_)) => feed.value(),
                Some(feed) => feed.value() / self.feed_unit(),
                None => 0.0,
            }),
            "$P_S" => Val::Real(self.spindles.speed().unwrap_or(0.0)),
            "$P_SDIR" => Val::Int(match self.spindles.turn() {
                Some(Turn::Clockwise) => 3,
                Some(Turn::CounterClockwise) => 4,
                None => 5,
            }),
            "$P_MSNUM" => Val::Int(i32::from(self.spindles.master())),
            "$P_UIFRNUM" => Val::Int(i32::from(self.frames.offset())),
            "$P_MC" => Val::Bool(self.modal_call.is_on()),
            "$P_OFFN" => Val::Real(self.path.normal() / self.length_unit()),
            "$AC_MARKER" | "$AC_PARAM" if !self.system.is_written(&system_key(word, args)) => Val::Int(0),
            _ => return None,
        })
    }

    /// `$P_AD[n]` is the `$TC_DPn` of the active edge, where the program wrote that.
    fn written_parameter(&self, word: &str, args: &[Val]) -> Option<Val> {
        let ("$P_AD", [parameter]) = (word, args) else { return None };
        let parameter = parameter.number().and_then(whole)?;
        let (tool, edge) = (self.tool.active()?, self.tool.edge_or_first());
        self.system.get(&format!("$TC_DP{parameter}[{tool},{edge}]")).cloned()
    }

    /// Data of tools and edges that the program did not write: of `[tools]`, or of the edge it wrote them for.
    fn tool_value(&self, settings: &Settings, word: &str, args: &[Val]) -> Option<Val> {
        let is_written = || self.system.is_written(&system_key(word, args));
        match word {
            "$TC_DP2" | "$TC_DP3" | "$TC_DP6" | "$TC_DP7" | "$TC_DP12" | "$TC_DP15" | "$P_AD" | "$P_TOOLL"
                if !is_written() =>
            {
                if let Some(written) = self.written_parameter(word, args) {
                    return Some(written);
                }
                let is_number = word == "$TC_DP2" || word == "$P_AD" && args.first().and_then(Val::number) == Some(2.0);
                let value = self.table_value(settings, word, args)?;
                Some(if is_number { Val::Int(value as i32) } else { Val::Real(value / self.feed_unit()) })
            }
            "$TC_TP2" | "$P_TOOLEXIST" if !is_written() => told_of_tool(&settings.tools, word, args),
            "$P_TOOLR" => self.known_radius(settings).map(|radius| Val::Real(radius / self.feed_unit())),
            _ => None,
        }
    }

    fn known_frame(&self, core: &Core<'_>, word: &str, args: &[Val], span: Span) -> Outcome<Option<Val>> {
        let (frame, component) = match word {
            "$P_PFRAME" => (Some(self.frames.programmable().clone()), args),
            // Under G500 the frame of the offset is none, whatever its positions are printed through.
            "$P_IFRAME" if self.frames.offset() == 0 && self.offsets.outer() != Outer::Basic => {
                (Some(FrameValue::default()), args)
            }
            "$P_IFRAME" => (self.frames.settable().cloned(), args),
            _ => match core.offset_number(args, span)? {
                Some((number, rest)) => (self.frames.offset_of(&core.job.settings.datums, number), rest),
                None => return Ok(None),
            },
        };
        match frame {
            None => Ok(None),
            Some(frame) if component.is_empty() => Ok(Some(Val::Frame(Rc::new(frame)))),
            Some(frame) => core.accept(span, frame.read_component(component, self.feed_unit())).map(Some),
        }
    }
}

impl Channel<'_> {
    /// The value of `$NAME[args]`, if the program or `[tools]` determine it.
    pub(super) fn known_value(&mut self, word: &str, args: &[Val], span: Span) -> Outcome<Option<Val>> {
        match word {
            "$P_AD" | "$P_TOOLL" | "$P_TOOLR" if self.st.tool.is_rewritten() => {
                let number = self.st.tool.active().unwrap_or(0);
                self.st.tool.is_as_selected(&self.core, number, self.st.tool.edge_or_first(), span)?;
                Ok(None)
            }
            "$P_S" if self.left.speed.is_some() => {
                self.left.speed_is_known(&self.core, self.capture.is_some(), "this reads the speed")?;
                Ok(None)
            }
            "$P_EP" | "$AA_IW" => end_position(&self.core, &self.st, word, args, span),
            "$P_GG" => code_in_force(&self.core, &self.st.codes, args, span).map(Some),
            "$P_PFRAME" | "$P_IFRAME" | "$P_UIFR" => self.st.known_frame(&self.core, word, args, span),
            _ => Ok(self
                .st
                .set_by_words(word, args)
                .or_else(|| self.st.tool_value(self.core.job.settings, word, args))
                .or_else(|| self.value_of_run(word, args))),
        }
    }

    /// What the machine, its settings and the call of this program determine.
    fn value_of_run(&mut self, word: &str, args: &[Val]) -> Option<Val> {
        let [first, second, third] = self.st.roles().map(|axis| self.axis_names.of(axis));
        match word {
            "$PI" => Some(Val::Real(core::f64::consts::PI)),
            "$P_AXN1" => Some(Val::Axis(first)),
            "$P_AXN2" => Some(Val::Axis(second)),
            "$P_AXN3" => Some(Val::Axis(third)),
            "$P_SIM" | "$P_SEARCH" | "$P_SEARCHL" | "$P_ISTEST" | "$P_DRYRUN" | "$P_PROGPATH_SIM" => {
                (!self.core.job.settings.variables.contains_key(word)).then_some(Val::Bool(false))
            }
            "$P_SUBPAR" => {
                let n = args.first().and_then(Val::number).and_then(whole).and_then(|n| usize::try_from(n).ok());
                let given = &super::levels::program(&mut self.core.levels).given;
                Some(Val::Bool(n.and_then(|n| n.checked_sub(1)).and_then(|n| given.get(n)).is_some_and(|given| *given)))
            }
            "$P_STACK" => Some(Val::Int(self.core.levels.len() as i32 - 1)),
            _ => None,
        }
    }
}

fn end_position(core: &Core<'_>, st: &State, word: &str, args: &[Val], span: Span) -> Outcome<Option<Val>> {
    let [Val::Axis(named)] = args else {
        return core.refuse(span, codes::S2031::needs_axis(&word));
    };
    named.axis.map(|axis| position_value(core, st, axis, span).map(Val::Real)).transpose()
}

/// Where an axis stands, as the program would write it.
fn position_value(core: &Core<'_>, st: &State, axis: Axis, span: Span) -> Outcome<f64> {
    if st.position.is_lost(axis) {
        return Err(Reported);
    }
    let Some(value) = st.position.get(axis) else {
        return st.no_position(core, axis, span, codes::P2001::where_axis_stands_is_not_known_2);
    };
    if axis.is_rotary() {
        return Ok(if st.machine.modulo.contains(axis) { reduced(value) } else { value });
    }
    let diameter = core.is_diameter_axis(axis) && st.diameter_mode() != Diameter::Off;
    Ok(value * if diameter { 2.0 } else { 1.0 } / st.feed_unit())
}

fn code_in_force(core: &Core<'_>, codes_on: &ActiveCodes, args: &[Val], span: Span) -> Outcome<Val> {
    let group = args.first().and_then(Val::number).and_then(whole).and_then(|n| usize::try_from(n).ok());
    match group.and_then(|group| codes_on.shown(group)) {
        Some(index) => Ok(Val::Int(i32::from(index))),
        None => core.refuse(span, codes::S2018::there_is_no_such_g_group()),
    }
}

impl Core<'_> {
    /// Number of a work offset and what follows it in the brackets.
    pub(super) fn offset_number<'v>(&self, args: &'v [Val], span: Span) -> Outcome<Option<(u8, &'v [Val])>> {
        let Some((first, rest)) = args.split_first() else { return Ok(None) };
        match first.number().and_then(whole).and_then(|n| u8::try_from(n).ok()).filter(|n| *n <= 99) {
            Some(number) => Ok(Some((number, rest))),
            None => self.refuse(span, codes::S2018::work_offsets_have_numbers_0_to_99()),
        }
    }
}
