//! Machining cycles: the arguments of a call are evaluated and held against their row, and its work is done.

use crate::diag::codes;
use crate::machine::AxisSet;
use crate::parser::sinumerik::ast::Args;
use crate::sema::cycle::given::{Given, Value};
use crate::sema::cycle::row;
use crate::text::Span;

use super::cycles::{self, Cycle as Row, Work};
use super::line::Line;
use super::modal_call::ModalCycle;
use super::value::{Val, to_text};
use super::words::CallWord;
use super::{Outcome, Run};

/// A value of the language as the argument of a parameter.
fn value_of(value: &Val, kind: row::Kind) -> Value {
    let text = || {
        let text = to_text(value).unwrap_or_default();
        Value::Text(String::from_utf8_lossy(&text).trim().to_ascii_uppercase())
    };
    match (value, kind) {
        (Val::Missing, _) => Value::Missing,
        // A letter in a variable of type CHAR is the text that it was written as.
        (Val::Text(_), row::Kind::Text) | (Val::Text(_) | Val::Char(_), row::Kind::Either) => text(),
        _ => match value.number() {
            Some(number) => Value::Number(number),
            None if matches!(kind, row::Kind::Text | row::Kind::Either) => text(),
            None => Value::Other,
        },
    }
}

impl Run<'_> {
    /// Runs a machining cycle; `None` for a name that is none, or that is not built.
    pub(super) fn machining_cycle(&mut self, name: &str, call: CallWord, line: Line<'_>) -> Option<Outcome> {
        let row = cycles::find(name)?;
        if matches!(row.work, Work::Nothing) || self.units.own_program(&mut self.channel.core, name) {
            return None;
        }
        let given = self.given_of(row, call.args, call.span, line);
        let result = given.and_then(|given| {
            self.channel.core.begins_executing();
            self.channel.takes_cycle(row, &given)?;
            self.run_cycle(row, &given)
        });
        if result.is_err() {
            self.channel.st.position.lose(AxisSet::ALL);
            self.channel.lost();
        }
        Some(result)
    }

    fn given_of(&mut self, row: &'static Row, args: Option<Args>, span: Span, line: Line<'_>) -> Outcome<Given> {
        let name = row.signature.name;
        if let Some(capture) = &mut self.channel.capture {
            let fault = |contour: &str| codes::S2091::stands_in_contour(&name, &contour);
            return capture.refuse(&self.channel.core, span, fault);
        }
        let parameters = row.signature.parameters;
        let mut given = Given::new(&row.signature, name, span.into(), self.channel.st.length_unit());
        let formulas = line.arguments_of(args);
        for (at, formula) in formulas.iter().enumerate() {
            let value = self.eval(*formula, line)?;
            if let Some(parameter) = parameters.get(at) {
                given.push(value_of(&value, parameter.kind), formula.span.into());
            }
        }
        if let Some(more) = formulas.get(parameters.len()) {
            return self.channel.core.refuse(more.span, codes::S2021::takes_arguments(&name, &parameters.len()));
        }
        self.channel.asked(&given, |call| call.fits_its_row())?;
        Ok(given)
    }

    fn run_cycle(&mut self, row: &'static Row, given: &Given) -> Outcome {
        match &row.work {
            Work::Hole(_) => {
                let hole = self.channel.hole_of(row, given)?;
                self.channel.drill(&hole)
            }
            Work::Plan(plan) => self.channel.run_plan(row, given, plan),
            Work::Along(contour, plan) => {
                let contours = self.contours_of(given, *contour)?;
                self.channel.run_plan(row, given, |call| plan(call, &contours))
            }
            Work::NamesContour => self.contour_call(given),
            Work::Unpublished(cycle) => self.unpublished_cycle(given, *cycle),
            Work::Nothing => Ok(()),
        }
    }

    /// `MCALL CYCLE81(…)`; `None` for a name that is no cycle.
    pub(super) fn modal_machining_cycle(&mut self, name: &str, args: Args, line: Line<'_>) -> Option<Outcome> {
        let row = cycles::find(name)?;
        let Work::Hole(drilling) = &row.work else { return None };
        if self.units.own_program(&mut self.channel.core, name) {
            return None;
        }
        Some(self.given_of(row, Some(args), line.block.span, line).and_then(|given| {
            self.channel.st.modal_call.end();
            let hole = self.channel.hole_of(row, &given)?;
            let feed_of_block = drilling.modal_feed;
            let under = (self.channel.st.plane(), self.channel.st.length_unit());
            let (here, spindle) = (self.channel.core.here, self.channel.st.spindle_state());
            let made = ModalCycle { hole, given, here, spindle, feed_of_block, under, refused: false };
            self.channel.st.modal_call.set_cycle(Box::new(made));
            Ok(())
        }))
    }
}
