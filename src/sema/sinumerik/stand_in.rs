//! Programs of the machine builder that are found nowhere: what `[programs]` says stands for them.

use crate::diag::{Diagnostic, codes};
use crate::machine::StandIn;
use crate::text::Span;

use super::programs::without_extension;
use super::value::{Val, whole};
use super::vars::Argument;
use super::{Channel, Outcome, Run};

impl Run<'_> {
    /// What the call of `name` does by `[programs]`; `None` for a program that is looked for.
    pub(super) fn stand_in(&mut self, name: &str, span: Span, arguments: &[Argument], passes: u32) -> Option<Outcome> {
        let name = without_extension(&name.to_ascii_uppercase()).to_owned();
        let stand_in = self.job.settings.programs.get(&name)?.clone();
        let place = match stand_in {
            StandIn::File(_) => return None,
            StandIn::Tool(place) => Some(place),
            StandIn::Ignored => None,
        };
        if self.own_program(&name) {
            return None;
        }
        let what = match place {
            Some(_) => format!("{name} changes the tool, as `[programs]` says; whatever else it does is left out"),
            None => format!("{name} is left out, as `[programs]` says"),
        };
        let found = Diagnostic::new(codes::S8135, self.loc(span), what);
        if !self.job.diags.knows(&found) {
            self.report(found);
        }
        Some(match place {
            Some(place) => self.change_by_program(&name, place, span, arguments, passes),
            None => Ok(()),
        })
    }
}

impl Channel<'_> {
    fn change_by_program(
        &mut self,
        name: &str,
        place: usize,
        span: Span,
        arguments: &[Argument],
        passes: u32,
    ) -> Outcome {
        if passes != 1 {
            return self.fail(codes::S2043, span, format!("{name} changes the tool {passes} times"));
        }
        let number = match place.checked_sub(1).and_then(|at| arguments.get(at)).map(|argument| &argument.value) {
            Some(Val::Text(text)) => {
                let tool = String::from_utf8_lossy(text).into_owned();
                self.tool_by_name(&tool, span)?
            }
            Some(value) => match value.number().and_then(whole).and_then(|n| u32::try_from(n).ok()) {
                Some(number) => number,
                None => {
                    return self.fail(
                        codes::S2043.alarm(17190),
                        span,
                        format!("argument {place} of {name} is no tool"),
                    );
                }
            },
            None => {
                let help = "count the arguments for `[programs]` from 1";
                return self.fail_help(codes::S2043, span, format!("{name} has no argument {place}"), help);
            }
        };
        self.st.tool.choose(number);
        self.change_tool()?;
        // Where it leaves the axes is not known.
        self.st.position.clear();
        Ok(())
    }
}
