//! Programs of the machine builder that are found nowhere: what `[programs]` says stands for them.

use crate::diag::{Answer, Help, codes};
use crate::ir::Side;
use crate::machine::settings::Leaves;
use crate::machine::{AxisSet, ChangeCall, Left, LeftSpindle, StandIn};
use crate::sema::common::hidden::By;
use crate::text::Span;

use super::feed::FeedLeft;
use super::g_groups::GCode;
use super::left_behind::MayChange;
use super::value::Val;
use super::vars::Argument;
use super::{Channel, Outcome};

impl Channel<'_> {
    /// What `[programs]` says of feed and spindle: the words of a block that would do it, if there are any.
    pub(super) fn leave_technology(&mut self, name: &str, span: Span) -> Option<Vec<u8>> {
        let left = self.core.job.settings.left_by(name);
        let loc = self.core.loc(span);
        let mut words: Vec<String> = Vec::new();
        match left.feed {
            Some(Left::Value(feed)) => words.push(format!("F{feed}")),
            Some(Left::Lost) => self.st.feed.leave(FeedLeft { name: name.to_owned(), call: loc, lost: true }),
            None if self.st.feed.word().is_some() => {
                self.st.feed.leave(FeedLeft { name: name.to_owned(), call: loc, lost: false });
            }
            None => {}
        }
        match left.speed {
            Some(Left::Value(speed)) => words.push(format!("S{speed}")),
            Some(Left::Lost) => self.left.speed = Some(Box::new((name.to_owned(), loc))),
            None => {}
        }
        words.extend(left.spindle.map(|spindle| match spindle {
            LeftSpindle::Clockwise => "M3".to_owned(),
            LeftSpindle::CounterClockwise => "M4".to_owned(),
            LeftSpindle::Stopped => "M5".to_owned(),
        }));
        self.left.last = Some(Box::new((name.to_owned(), loc)));
        (!words.is_empty()).then(|| words.join(" ").into_bytes())
    }

    /// What stands for a program behind MCALL: only one that does nothing can, after each move.
    pub(super) fn modal_stand_in(
        &mut self,
        name: &str,
        stand_in: &StandIn,
        span: Span,
        arguments: &[Argument],
    ) -> Outcome {
        self.st.modal_call.end();
        if matches!(stand_in, StandIn::Change(_)) {
            return self.core.refuse(span, codes::S2043::changes_tool(&name));
        }
        let measures = super::cycles::measures(name);
        if !measures && self.core.job.settings.left_by(name) != Leaves::default() {
            return self.core.refuse(span, codes::S2043::mcall_calls_after_each_move(&name));
        }
        self.leave_call_out(name, span, arguments)?;
        if !measures {
            self.leave_technology(name, span);
        }
        Ok(())
    }

    /// `name` does nothing.
    pub(super) fn leave_call_out(&mut self, name: &str, span: Span, arguments: &[Argument]) -> Outcome {
        // What a measuring cycle sets, and where it leaves the probe, is as open as where the key leaves it out.
        if super::cycles::measures(name) {
            let values: Vec<Val> = arguments.iter().map(|argument| argument.value.clone()).collect();
            return self.leave_cycle_out(name, &values, span);
        }
        self.core.report_new(codes::P8105::is_left_out_as_programs_says(&name).at(self.core.loc(span)));
        if let Some(may) = MayChange::of_call(&self.st, self.core.job.settings, arguments) {
            self.left.may_have_changed(&mut self.core, may, name, span);
        }
        self.left.motion = Some(Box::new((name.to_owned(), self.core.loc(span))));
        self.leave_behind(name, span)
    }

    /// What `[programs]` says that the call leaves behind.
    fn leave_behind(&mut self, name: &str, span: Span) -> Outcome {
        let left = self.core.job.settings.left_by(name);
        if let Some(rapid) = left.rapid {
            self.st.codes.activate(if rapid { GCode::G0 } else { GCode::G1 });
        }
        if !left.lost.is_empty() {
            let loc = self.core.loc(span);
            if self.st.side() != Side::None {
                let refused =
                    self.core.refuse(span, codes::P2001::moves_axes_under_radius_compensation_as_programs(&name));
                self.lose_all();
                return refused;
            }
            self.st.position.forget(left.lost);
            self.st.position.hide(left.lost, By::Call, loc);
            self.only_known_axes_stand();
        }
        Ok(())
    }

    pub(super) fn change_by_program(
        &mut self,
        name: &str,
        change: &ChangeCall,
        span: Span,
        arguments: &[Argument],
        passes: u32,
    ) -> Outcome {
        if passes != 1 {
            return self.core.refuse(span, codes::S2043::changes_tool_times(&name, &passes));
        }
        match change.tool {
            Some(place) => {
                let number = self.tool_of_argument(name, place, span, arguments)?;
                self.st.tool.choose(number);
            }
            None if self.st.tool.next().is_none() => {
                return self.core.refuse(span, codes::S2043::no_tool_is_chosen(&name));
            }
            None => {}
        }
        self.change_tool()?;
        let edge = change.edge.and_then(|place| Some((place, &arguments.get(place - 1)?.value)));
        match edge.filter(|(_, value)| **value != Val::Missing) {
            None => {}
            Some((place, value)) => match value.number() {
                Some(edge) => self.st.select_edge(&self.core, edge, span)?,
                None => {
                    return self.core.refuse(span, codes::S2043::argument_of_is_no_d_number(&place, &name));
                }
            },
        }
        // Where it leaves the axes only the configuration knows.
        self.st.position.clear();
        let loc = self.core.loc(span);
        self.st.position.hide(AxisSet::MAIN, By::ToolChange, loc);
        self.only_known_axes_stand();
        self.stand_after_change();
        self.leave_behind(name, span)?;
        self.left.motion = Some(Box::new((name.to_owned(), self.core.loc(span))));
        let left = left_out(change, arguments);
        self.core.report_new(codes::P8105::changes_tool_as_programs_says(&name, &left).at(self.core.loc(span)));
        Ok(())
    }

    /// The tool that an argument names, by its number or by its name in the tool table.
    fn tool_of_argument(&mut self, name: &str, place: usize, span: Span, arguments: &[Argument]) -> Outcome<u32> {
        match arguments.get(place - 1).map(|argument| &argument.value) {
            Some(Val::Text(text)) => {
                let tool = String::from_utf8_lossy(text).into_owned();
                self.tool_by_name(&tool, span)
            }
            None | Some(Val::Missing) => self.core.refuse(span, codes::S2043::has_no_argument(&name, &place)),
            Some(value) => match value.number().filter(|n| n.fract() == 0.0 && (0.0..=32_000.0).contains(n)) {
                Some(number) => self.core.tool_by_number(number as u32, span),
                None => self.core.refuse(span, codes::S2043::argument_of_is_no_tool(&place, &name)),
            },
        }
    }
}

/// What of a tool change is not in the output, with its verb.
fn left_out(change: &ChangeCall, arguments: &[Argument]) -> String {
    let given = |at: usize, argument: &Argument| {
        let taken = [change.tool, change.edge].contains(&Some(at));
        !taken && argument.value != Val::Missing && argument.value.number() != Some(0.0)
    };
    let others: Vec<String> =
        (1..).zip(arguments).filter(|(at, argument)| given(*at, argument)).map(|(at, _)| at.to_string()).collect();
    match &others[..] {
        [] => "whatever else it does is".to_owned(),
        [one] => format!("argument {one} and whatever else it does are"),
        more => format!("arguments {} and whatever else it does are", more.join(", ")),
    }
}

/// A call as far as it tells what its program may be.
pub(super) struct NameOfCall<'n> {
    pub name: &'n str,
    /// The first argument that is a text, counted from 1.
    pub text: Option<usize>,
    /// It has arguments.
    pub arguments: bool,
    /// T has chosen a tool that has not been changed.
    pub tool_waits: bool,
}

impl NameOfCall<'_> {
    /// How to answer for the program: by a file, or by the line that stands for it under `[programs]`.
    pub fn help(&self) -> Help {
        // A word alone may be mistyped.
        let mistyped = if self.arguments { "" } else { "; or correct the word" };
        let line = self.line();
        let text = format!("put the program beside this one or into an include root; or {line}{mistyped}");
        self.answer().help(text)
    }

    /// The same for a word of the language: only for a cycle may a file stand.
    pub fn help_of_word(&self) -> Help {
        let name = self.name;
        if !super::cycles::is_program(name) {
            return Help::from("put the program beside this one or into an include root");
        }
        let file = format!("{{ file = \"stubs/{name}.SPF\" }}");
        let text = format!(
            "put the program beside this one or into an include root; or say which file runs: `[programs] {name} = {file}`"
        );
        Answer::key("programs", name).one_of(&[file]).help(text)
    }

    /// The same as the key that says it.
    pub fn answer(&self) -> Answer {
        let ignored = "{ ignore = true }".to_owned();
        let values = match self.text {
            Some(at) => [format!("{{ tool = {at} }}"), ignored],
            None if self.tool_waits => ["{ change = true }".to_owned(), ignored],
            None => [ignored, format!("{{ file = \"stubs/{}.SPF\" }}", self.name)],
        };
        Answer::key("programs", self.name).one_of(&values)
    }

    /// The line that stands for it.
    pub fn line(&self) -> String {
        let name = self.name;
        let ignored = format!("`{name} = {{ ignore = true }}` leaves it out");
        let said = match self.text {
            Some(at) => format!("`{name} = {{ tool = {at} }}` changes to the tool of argument {at}, {ignored}"),
            None if self.tool_waits => {
                format!("`{name} = {{ change = true }}` changes to the tool that T chose, {ignored}")
            }
            None => format!("{ignored}, `{name} = {{ file = \"stubs/{name}.SPF\" }}` runs that file"),
        };
        format!("say under `[programs]` of partc.toml what stands for it: {said}")
    }
}
