//! What calls that are left out leave behind: a tool that they may have changed in, a way at rapid traverse, a speed.
//!
//! Comes in: calls that `[programs]` leaves out, T, changes, cuts. Goes out: S8163 where the program goes on to cut with the tool before it,
//! and what the helps of later findings say of the calls.

use crate::diag::{Answer, Diagnostic, Help, codes};
use crate::machine::tools::{ToolKey, Tools};
use crate::machine::{ChangeCall, Left, Settings, StandIn};
use crate::sema::run::Where;
use crate::text::{Loc, Span};

use super::system_variables::SystemVariables;
use super::value::Val;
use super::vars::Argument;
use super::{Core, Outcome, State};

/// The change that a call which is left out may have made.
struct LeftOut {
    /// The tool that T chose or the call names; `None` for a name that is no known tool's.
    number: Option<u32>,
    /// If nothing else changes it in.
    found: Diagnostic,
    /// Something was cut behind the call.
    cut: bool,
}

/// What a call that is left out may have changed in.
pub(super) enum MayChange {
    /// The tool that T chose.
    Chosen(u32),
    /// The tool of this name.
    Named(u32, String),
    /// A tool of this name, which has no number.
    Unknown(String),
}

/// What calls that are left out leave behind: what later blocks lack may come from them.
#[derive(Default)]
pub(super) struct LeftBehind {
    /// The tool change that a call may have made.
    change: Option<Box<LeftOut>>,
    /// A call that stands for a program of the machine, until a G code of the path follows: its name and place.
    pub motion: Option<Box<(String, Loc)>>,
    /// The last call that stands for a program of the machine.
    pub last: Option<Box<(String, Loc)>>,
    /// The call that leaves a speed that is not known, until S is programmed.
    pub speed: Option<Box<(String, Loc)>>,
}

impl MayChange {
    /// What a call with these arguments may change in, and the place of the argument that names it.
    pub fn of_call(st: &State, settings: &Settings, arguments: &[Argument]) -> Option<(MayChange, usize)> {
        let tool = &st.tool;
        let texts = (1..).zip(arguments).filter_map(|(place, argument)| match &argument.value {
            Val::Text(text) => Some((place, String::from_utf8_lossy(text).into_owned())),
            _ => None,
        });
        let mut first = None;
        for (place, text) in texts {
            match number_of_tool_named(&st.system, &settings.tools, &text) {
                Some(number) if tool.active() == Some(number) => continue,
                Some(number) => return Some((MayChange::Named(number, text), place)),
                None => {}
            }
            first = first.or((!text.is_empty()).then_some((place, text)));
        }
        if let Some(number) = tool.waiting() {
            return Some((MayChange::Chosen(number), 0));
        }
        // Before the first tool of the program a name may well be a tool's.
        let (place, text) = first.filter(|_| tool.active().is_none())?;
        Some((MayChange::Unknown(text), place))
    }
}

impl LeftBehind {
    /// The call of `name` does nothing. Where T has chosen a tool that is not in yet, or the call names one, it may be what changes it in.
    pub fn may_have_changed(&mut self, core: &mut Core<'_>, may: (MayChange, usize), name: &str, span: Span) {
        let (may, place) = may;
        let number = match may {
            MayChange::Chosen(number) | MayChange::Named(number, _) => Some(number),
            MayChange::Unknown(_) => None,
        };
        if self.change.as_ref().is_some_and(|left| left.number == number) {
            return;
        }
        self.report_change(core);
        let key = Answer::key("programs", name);
        let to_argument = key.clone().one_of(&[format!("{{ tool = {place} }}")]);
        let fault = match may {
            MayChange::Chosen(number) => codes::S8163::t_chose_tool_before_call(&number, &name)
                .answers([key.one_of(&["{ change = true }"]), Answer::key("control", "tool_change")]),
            MayChange::Named(number, tool) => {
                codes::S8163::call_names_tool(&name, &number, &tool, &place).answer(to_argument)
            }
            MayChange::Unknown(tool) => codes::S8163::call_may_name_tool(&name, &tool, &place).answer(to_argument),
        };
        let found = fault.at(core.loc(span));
        let found = found.called(core.here.origin.call);
        self.change = Some(Box::new(LeftOut { number, found, cut: false }));
    }

    /// A move cuts, unless it only describes a contour.
    #[inline]
    pub fn cuts(&mut self, describes: bool) {
        if let Some(left) = self.change.as_mut().filter(|_| !describes) {
            left.cut = true;
        }
    }

    /// Straight blocks may take the lane: nothing has to know that they cut.
    pub fn cut_is_known(&self) -> bool {
        self.change.as_ref().is_none_or(|left| left.cut)
    }

    /// T chooses a tool: what was cut until here was cut with the one before, and the call may have made the change for it.
    pub fn chosen(&mut self, core: &mut Core<'_>, number: u32) {
        if !self.change.as_ref().is_some_and(|left| !left.cut && left.number == Some(number)) {
            self.report_change(core);
        }
    }

    /// A tool is changed in: the one that was chosen, or another one before anything was cut.
    pub fn changed(&mut self) {
        self.change = None;
    }

    /// The tool that a left-out call may have changed in was not changed in before cuts: another one is chosen, or the program ends.
    pub fn report_change(&mut self, core: &mut Core<'_>) {
        let Some(lost) = self.change.take().filter(|left| left.cut) else { return };
        core.change_was_reported();
        core.job.diags.push_cause(lost.found);
    }

    /// Refuses what needs a speed where the last call leaves another one.
    pub fn speed_is_known(&mut self, core: &Core<'_>, describes: bool, needs: &str) -> Outcome {
        // What is described runs later, and the speed is no better known then.
        let Some(lost) = self.speed.take_if(|_| !describes) else { return Ok(()) };
        let (name, call) = *lost;
        core.refuse(Where::Block, codes::S2045::in_line_leaves_speed_that_is_not(&needs, &name, &call.line))
    }

    /// What a feed move lacks: `usual`, and where no G code of the path stands between it and a call that stands for a program of
    /// the machine, that the call may leave G0 active.
    pub fn or_left_at_rapid(&self, settings: &Settings, usual: Help) -> Help {
        let Some((name, loc)) = self.motion.as_deref() else { return usual };
        if settings.left_by(name).rapid.is_some() {
            return usual;
        }
        let entries: Vec<String> = entry_with(settings, name, "motion = \"G0\"").into_iter().collect();
        or_by_call(usual, name, *loc, "leaves G0 active", &entries)
    }

    /// What a spindle lacks that does not turn: `usual`, and after a call that stands for a program of the machine, that the call may
    /// start it.
    pub fn or_started_by_call(&self, settings: &Settings, usual: Help) -> Help {
        let Some((name, loc)) = self.last.as_deref() else { return usual };
        if settings.left_by(name).spindle.is_some() {
            return usual;
        }
        let entries: Vec<String> =
            ["M3", "M4"].iter().filter_map(|m| entry_with(settings, name, &format!("spindle = \"{m}\""))).collect();
        or_by_call(usual, name, *loc, "starts the spindle", &entries)
    }
}

/// `usual`, and that the call may do it, for which one of `entries` says so.
fn or_by_call(usual: Help, name: &str, call: Loc, does: &str, entries: &[String]) -> Help {
    let [entry, ..] = entries else { return usual };
    let text =
        format!("{}; or if {name} in line {} {does}, say so: `[programs] {name} = {entry}`", usual.text, call.line);
    let mut help = Help { text, answers: usual.answers };
    help.answers.insert(0, Answer::key("programs", name).one_of(entries));
    help
}

/// The tool that has this name in the table or by `$TC_TP2`.
fn number_of_tool_named(system: &SystemVariables, tools: &Tools, name: &str) -> Option<u32> {
    let listed = || match tools.key_of_name(name, false)? {
        ToolKey::Number(own, _) => Some(*own),
        ToolKey::Name(_) => tools.by_name(name)?.0,
    };
    system.tool_named(name).or_else(listed)
}

/// The entry of `[programs]` for this call with one thing more in it.
fn entry_with(settings: &Settings, name: &str, more: &str) -> Option<String> {
    let what = match settings.programs.get(name)? {
        StandIn::Change(ChangeCall { tool: Some(tool), .. }) => format!("tool = {tool}"),
        StandIn::Change(ChangeCall { tool: None, .. }) => "change = true".to_owned(),
        StandIn::Ignored => "ignore = true".to_owned(),
        StandIn::File(_) => return None,
    };
    let edge = match settings.programs.get(name) {
        Some(StandIn::Change(ChangeCall { edge: Some(edge), .. })) => format!(", d = {edge}"),
        _ => String::new(),
    };
    let left = settings.left_by(name);
    let motion = left.rapid.map(|rapid| if rapid { ", motion = \"G0\"" } else { ", motion = \"G1\"" });
    let axes: Vec<String> = left.lost.iter().map(|axis| format!("\"{}\"", axis.letter())).collect();
    let lost = if axes.is_empty() { String::new() } else { format!(", lost = [{}]", axes.join(", ")) };
    let value = |key: &str, value: Option<Left>| match value {
        Some(Left::Value(value)) => format!(", {key} = {value}"),
        Some(Left::Lost) => format!(", {key} = \"lost\""),
        None => String::new(),
    };
    let (feed, speed) = (value("feed", left.feed), value("speed", left.speed));
    Some(format!("{{ {what}{edge}{}{lost}{feed}{speed}, {more} }}", motion.unwrap_or_default()))
}
