//! Tool changes that a call which is left out may have made: what was chosen or named, and whether anything else changes it in.
//!
//! Comes in: calls that `[programs]` leaves out, T, changes, cuts. Goes out: S8163 where the program goes on to cut with the tool before it.

use crate::diag::{Answer, Diagnostic, codes};
use crate::text::Span;

use super::Channel;
use super::value::Val;
use super::vars::Argument;

/// The change that a call which is left out may have made.
pub(super) struct LeftOut {
    /// The tool that T chose or the call names; `None` for a name that is no known tool's.
    number: Option<u32>,
    /// If nothing else changes it in.
    found: Diagnostic,
    /// Something was cut behind the call.
    cut: bool,
}

/// What a call that is left out may have changed in.
enum MayChange {
    /// The tool that T chose.
    Chosen(u32),
    /// The tool of this name.
    Named(u32, String),
    /// A tool of this name, which has no number.
    Unknown(String),
}

impl Channel<'_> {
    /// The call of `name` does nothing. Where T has chosen a tool that is not in yet, or the call names one, it may be what changes it in.
    pub(super) fn may_have_changed(&mut self, name: &str, span: Span, arguments: &[Argument]) {
        let Some((may, place)) = self.change_of(arguments) else { return };
        let number = match may {
            MayChange::Chosen(number) | MayChange::Named(number, _) => Some(number),
            MayChange::Unknown(_) => None,
        };
        if self.change_left_out.as_ref().is_some_and(|left| left.number == number) {
            return;
        }
        self.report_lost_change();
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
        let found = fault.at(self.core.loc(span));
        let found = found.called(self.core.here.origin.call);
        self.change_left_out = Some(Box::new(LeftOut { number, found, cut: false }));
    }

    /// What a call with these arguments may change in, and the place of the argument that names it.
    fn change_of(&self, arguments: &[Argument]) -> Option<(MayChange, usize)> {
        let tool = &self.st.tool;
        let texts = (1..).zip(arguments).filter_map(|(place, argument)| match &argument.value {
            Val::Text(text) => Some((place, String::from_utf8_lossy(text).into_owned())),
            _ => None,
        });
        let mut first = None;
        for (place, text) in texts {
            match self.number_of_tool_named(&text) {
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

    /// The tool that has this name in the table or by `$TC_TP2`.
    fn number_of_tool_named(&self, name: &str) -> Option<u32> {
        let tools = &self.core.job.settings.tools;
        let listed = || match tools.key_of_name(name, false)? {
            crate::machine::tools::ToolKey::Number(own, _) => Some(*own),
            crate::machine::tools::ToolKey::Name(_) => tools.by_name(name)?.0,
        };
        self.st.system.tool_named(name).or_else(listed)
    }

    /// A move cuts, unless it only describes a contour.
    #[inline]
    pub(super) fn cuts_in_between(&mut self) {
        let describes = self.capture.is_some();
        if let Some(left) = self.change_left_out.as_mut().filter(|_| !describes) {
            left.cut = true;
        }
    }

    /// Straight blocks may take the lane: nothing has to know that they cut.
    pub(super) fn cut_is_known(&self) -> bool {
        self.change_left_out.as_ref().is_none_or(|left| left.cut)
    }

    /// T chooses a tool: what was cut until here was cut with the one before, and the call may have made the change for it.
    pub(super) fn chosen_after_left_out(&mut self, number: u32) {
        let waits = |left: &LeftOut| !left.cut && left.number == Some(number);
        if !self.change_left_out.as_ref().is_some_and(|left| waits(left)) {
            self.report_lost_change();
        }
    }

    /// A tool is changed in: the one that was chosen, or another one before anything was cut.
    pub(super) fn changed_after_left_out(&mut self) {
        self.change_left_out = None;
    }

    /// The tool that a left-out call may have changed in was not changed in before cuts: another one is chosen, or the program ends.
    pub(super) fn report_lost_change(&mut self) {
        let Some(lost) = self.change_left_out.take().filter(|left| left.cut) else { return };
        self.core.change_was_reported();
        self.core.job.diags.push_cause(lost.found);
    }
}
