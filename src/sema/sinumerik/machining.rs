//! Machining cycles: the arguments of a call are evaluated and held against their row, and its work is done.

use crate::diag::codes;
use crate::parser::sinumerik::ast::Args;
use crate::sema::cycle::given::{Given, Value};
use crate::sema::cycle::row;
use crate::text::Span;

use super::called_contours::{check_elements, named, unpublished};
use super::cycles::{Cycle as Row, Work};
use super::line::Line;
use super::value::{Val, to_text};
use super::{Outcome, Reported, Run};

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
    /// The arguments of a call, as the row of the cycle takes them.
    pub(super) fn given_of(
        &mut self,
        row: &'static Row,
        args: Option<Args>,
        span: Span,
        line: Line<'_>,
    ) -> Outcome<Given> {
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

    pub(super) fn run_cycle(&mut self, row: &'static Row, given: &Given) -> Outcome {
        self.channel.core.begins_executing();
        self.channel.takes_cycle(row, given)?;
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
            Work::NamesContour => {
                let core = &mut self.channel.core;
                let call = self.units.contour_of_call(core, given)?;
                core.accept(given.place, self.contours.add(&call).map_err(|fault| fault.of(&given.called)))?;
                // What is wrong with it shows here, also where no cycle follows that is built.
                let made = self.capture(&call)?;
                check_elements(&call, &made).map_err(|found| {
                    self.channel.core.report(*found);
                    Reported
                })
            }
            // Its tracks are not published.
            Work::Unpublished(source) => {
                let contours = self.contours_of(given, *source)?;
                self.channel
                    .core
                    .report(unpublished(given, &contours).at(self.channel.core.loc(given.place)).here(named(given)));
                Err(Reported)
            }
            Work::Nothing => Ok(()),
        }
    }
}
