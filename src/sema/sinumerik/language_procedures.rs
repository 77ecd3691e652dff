//! Procedures of the language that are no cycles: what they set, and what is left out of them.
//!
//! Source: S 1.5, 2.14, 3, 4.9, 5.6, 5.7 and 6 (docs/sources.md).

use crate::diag::{Answer, Fault, codes};
use crate::ir::Function;
use crate::machine::AxisSet;
use crate::parser::sinumerik::ast::{Formula, Op};
use crate::text::Span;

use super::left_out::{LeftOut, said_of_feed_axes};
use super::line::{Line, NextText};
use super::swivel_call::{Arguments, MOST as MOST_OF_SWIVEL, RECORD as SWIVEL_RECORD};
use super::system_meanings::meaning_of;
use super::value::{Val, to_text, whole};
use super::vocabulary::{OnSurface, Procedure, Refusal};
use super::{Channel, Outcome, Run, cycle_alarms, cycles};

/// Words of the tool management that give no value and change no tool.
const LEFT_OUT_BY_ENTRY: [&str; 2] = ["SETPIECE", "RESETMON"];

fn given(formula: Option<&Formula>) -> Option<Formula> {
    formula.copied().filter(|formula| !formula.is_missing())
}

impl Run<'_> {
    /// A word that is written like a call and whose effect is the control's own.
    pub(super) fn procedure_of_language(
        &mut self,
        procedure: Procedure,
        name: &str,
        (formulas, span): (&[Formula], Span),
        line: Line<'_>,
    ) -> Outcome<Option<NextText>> {
        if let Some(done) = self.channel.plain_procedure(procedure, name, !formulas.is_empty(), span) {
            return done.map(|()| None);
        }
        match procedure {
            Procedure::Dynamics if name == "FGROUP" => {
                let values = self.values(formulas, line)?;
                said_of_feed_axes(&values, self.channel.st.machine.geometry_axes).say(&self.channel.core, span);
            }
            Procedure::Dynamics => self.high_speed_settings(formulas, span, line)?,
            Procedure::Message => {
                let value = given(formulas.first()).map(|formula| self.eval(formula, line)).transpose()?;
                let shown = value.as_ref().and_then(to_text).filter(|shown| !shown.is_empty());
                if let Some(shown) = shown.filter(|_| self.channel.core.job.settings.output.comments) {
                    self.channel.function(Function::Comment(shown));
                }
            }
            Procedure::SetAlarm => return self.set_alarm(formulas, span, line),
            Procedure::SetMaster => {
                let n = if let [first, ..] = formulas { self.number(*first, line)? } else { 1.0 };
                let spindle = whole(n).and_then(|n| u8::try_from(n).ok()).filter(|n| (1..=20).contains(n));
                let spindle = spindle.ok_or_else(|| codes::S2045::there_is_no_spindle(&n));
                self.channel.set_master(self.channel.core.accept(span, spindle)?, span)?;
            }
            Procedure::FileAccess => self.file_access(name, formulas, span, line)?,
            Procedure::CallPath => self.call_path_block(formulas, span, line)?,
            Procedure::ExecString => {
                let [formula] = *formulas else {
                    return self.channel.core.refuse(span, codes::S2021::execstring_takes_one_text());
                };
                return match self.eval(formula, line)? {
                    Val::Text(text) => Ok(Some(NextText { text: text.to_vec(), span })),
                    other => self.channel.core.refuse(formula.span, codes::P2024::text_is_needed(&other.what())),
                };
            }
            Procedure::Return => self.return_block(formulas, span, line)?,
            Procedure::Transformation(on) => {
                let most = if on == OnSurface::Face { 1 } else { 3 };
                if let Some(more) = formulas.get(most) {
                    let fault = codes::S2021::takes_argument(&on.word(), &most, &(if most == 1 { "" } else { "s" }));
                    return self.channel.core.refuse(more.span, fault);
                }
                let mut numbers = [None; 3];
                for (place, formula) in numbers.iter_mut().zip(formulas).filter(|(_, formula)| !formula.is_missing()) {
                    *place = Some((self.number(*formula, line)?, formula.span));
                }
                self.channel.transformation(on, numbers, span)?;
            }
            Procedure::Swivel => self.swivel(formulas, span, line)?,
            Procedure::GeoAxes => self.geo_axes(formulas, span, line)?,
            _ => {}
        }
        Ok(None)
    }

    /// SETAL
    fn set_alarm<T>(&mut self, formulas: &[Formula], span: Span, line: Line<'_>) -> Outcome<T> {
        let alarm = formulas.first().and_then(|formula| self.number(*formula, line).ok());
        if let Some(number) = alarm.filter(|number| !(60_000.0..70_000.0).contains(number)) {
            self.channel.core.stop_run();
            return self.channel.core.refuse(span, codes::P2026::setal_is_no_alarm_of_program(&number));
        }
        let mut shown = String::new();
        for value in self.values(formulas, line)? {
            if let Some(text) = to_text(&value) {
                shown = format!("{shown} {}", String::from_utf8_lossy(&text));
            }
        }
        self.channel.core.stop_run();
        let (cause, help) = match alarm.and_then(cycle_alarms::meaning) {
            Some((cause, help)) => (format!(": {cause}"), help),
            None => (String::new(), "it found its own data wrong: look at the conditions before SETAL"),
        };
        self.channel.core.refuse(span, codes::P2026::program_raises_alarm(&shown, &cause).help(help))
    }

    /// CALLPATH("/_N_WKS_DIR/_N_A_WPD"), and CALLPATH() to search no further folder.
    fn call_path_block(&mut self, formulas: &[Formula], span: Span, line: Line<'_>) -> Outcome {
        let folder = match *formulas {
            [] => None,
            [formula] => match self.eval(formula, line)? {
                Val::Text(folder) => Some(String::from_utf8_lossy(&folder).into_owned()).filter(|it| !it.is_empty()),
                Val::Missing => None,
                other => {
                    return self.channel.core.refuse(formula.span, codes::P2024::text_is_needed(&other.what()));
                }
            },
            _ => return self.channel.core.refuse(span, codes::S2021::callpath_takes_one_text()),
        };
        if let Some(wrong) = folder.as_deref().filter(|folder| !folder.starts_with('/')) {
            return self.channel.core.refuse(span, codes::S2021::is_no_folder_of_control(&wrong));
        }
        self.units.extend_search(&mut self.channel.core, folder, span);
        Ok(())
    }

    fn geo_axes(&mut self, formulas: &[Formula], span: Span, line: Line<'_>) -> Outcome {
        for pair in formulas.chunks(2) {
            let [number, axis] = pair else { break };
            let n = self.number(*number, line)?;
            if !(0.0..=3.0).contains(&n) {
                return self.channel.core.refuse(span, codes::S2021::geoax_names_geometry_axis(&n));
            }
            let place = whole(n).and_then(|n| usize::try_from(n).ok()).and_then(|n| n.checked_sub(1));
            let known = place.and_then(|at| self.channel.st.machine.geometry_axes.get(at)).copied();
            let same = match (known, self.eval(*axis, line)?) {
                (Some(known), Val::Axis(named)) => named.axis == Some(known),
                _ => false,
            };
            if !same {
                let answer = Answer::key("machine", "geometry_axes");
                let fault = codes::P9011::geoax_gives_geometry_axes_other_names().answer(answer);
                return self.channel.core.refuse(span, fault);
            }
        }
        self.channel.core.say_once(span, codes::S8103::words_that_only_steer_control());
        Ok(())
    }

    /// WRITE, DELETE and their kin: nothing is written, and nothing is read.
    fn file_access(&mut self, name: &str, formulas: &[Formula], span: Span, line: Line<'_>) -> Outcome {
        let core = &self.channel.core;
        if !matches!(name, "WRITE" | "DELETE") {
            return core.refuse(span, codes::P9011::takes_values_from_file_of_control(&name));
        }
        core.say_once(span, codes::S8017::works_on_file_of_control(&name));
        let Some(formula) = given(formulas.first()) else { return Ok(()) };
        let reference = self.reference(formula, line)?;
        let core = &self.channel.core;
        let Some(reference) = reference else {
            return match line.ops(formula) {
                [Op::Name(name, at)] => core.refuse(*at, self.vars.undefined(*name, core)),
                _ => Ok(()),
            };
        };
        core.job.trail.returns();
        self.vars.set_reference(reference, 0);
        let shown = match line.ops(formula) {
            [Op::Name(name, _)] => core.symbols.name(*name).to_owned(),
            [Op::R(n, _)] => format!("R{n}"),
            _ => "its first argument".to_owned(),
        };
        core.say_once(formula.span, codes::S8108::error_variable_is_set_to_0(&name, &shown));
        Ok(())
    }

    /// `GETEXET(T,1)`: the tool in use. `GETSELT(T,1)`: the one that T has chosen.
    pub(super) fn asks_for_tool(&mut self, name: &str, formulas: &[Formula], span: Span, line: Line<'_>) -> Outcome {
        let [variable, spindle @ ..] = formulas else {
            return self.channel.core.refuse(span, codes::S2021::lacks_variable_that_takes_tool(&name));
        };
        if let Some(spindle) = given(spindle.first()) {
            let number = self.number(spindle, line)?;
            if whole(number) != Some(i32::from(self.channel.st.spindles.master())) {
                let fault = codes::P9010::asks_for_tool_of_spindle(&name, &number);
                return self.channel.core.refuse(spindle.span, fault);
            }
        }
        let tool = &self.channel.st.tool;
        let (number, variable_name) = match name {
            "GETSELT" => (tool.next().or(tool.active()), "$P_TOOLP"),
            _ => (tool.active(), "$P_TOOLNO"),
        };
        let said = || self.channel.core.job.settings.variables.get(variable_name).copied().and_then(whole);
        let Some(number) = number.and_then(|number| i32::try_from(number).ok()).or_else(said) else {
            let meaning = meaning_of(variable_name, &[]).unwrap_or_default();
            let help = format!("select a tool before it, or give it under [variables]: \"{variable_name}\" = number");
            let fault = codes::P2023::asks_for_program_has_selected_none(&name, &meaning);
            let help = Answer::variable(variable_name, meaning).help(help);
            return self.channel.core.refuse(span, fault.help(help));
        };
        let reference = self.reference(*variable, line)?;
        let Some(reference) = reference else {
            return self.channel.core.refuse(variable.span, codes::S2021::needs_variable(&name));
        };
        self.channel.core.job.trail.returns();
        self.vars.set_reference(reference, number);
        Ok(())
    }

    /// CYCLE832(S_TOL, S_TOLM, …): a tolerance of the contour, or none.
    fn high_speed_settings(&mut self, formulas: &[Formula], span: Span, line: Line<'_>) -> Outcome {
        let tolerance = match given(formulas.first()) {
            Some(formula) => self.number(formula, line)?,
            None => 0.0,
        };
        let off = match given(formulas.get(1)) {
            None => false,
            // The modes have names, which the control defines.
            Some(formula) => match line.ops(formula) {
                [Op::Name(name, _)] if self.channel.core.symbols.name(*name).starts_with('_') => {
                    self.channel.core.symbols.name(*name) == "_OFF"
                }
                _ => self.number(formula, line)? == 0.0,
            },
        };
        let core = &self.channel.core;
        if tolerance < 0.0 {
            return core.refuse(span, codes::S2045::cycle832_with_tolerance(&tolerance));
        }
        if formulas.iter().filter(|formula| !formula.is_missing()).count() > 1 {
            core.say_once(span, codes::S8002::words_that_only_shape_speed());
        }
        self.channel.smooth_by_cycle((!off).then_some(tolerance));
        Ok(())
    }

    /// `CYCLE800(…)`
    fn swivel(&mut self, formulas: &[Formula], span: Span, line: Line<'_>) -> Outcome {
        let mut given = Arguments::of(formulas.len());
        for (at, formula) in formulas.iter().enumerate().filter(|(_, formula)| !formula.is_missing()) {
            if at == SWIVEL_RECORD {
                match self.eval(*formula, line)? {
                    Val::Text(name) => given.take_record(&name, formula.span),
                    other => {
                        return self.channel.core.refuse(formula.span, codes::P2024::text_is_needed(&other.what()));
                    }
                }
            } else {
                let value = self.number(*formula, line)?;
                if !given.take(at, value, formula.span) {
                    let fault = codes::S2021::cycle800_takes_arguments(&MOST_OF_SWIVEL);
                    return self.channel.core.refuse(formula.span, fault);
                }
            }
        }
        self.channel.swivel(&given, span)
    }
}

impl Channel<'_> {
    /// A procedure that takes no arguments, or is not compiled; `None` for any other.
    fn plain_procedure(
        &mut self,
        procedure: Procedure,
        name: &str,
        has_arguments: bool,
        span: Span,
    ) -> Option<Outcome> {
        Some(match procedure {
            Procedure::TransformationOff | Procedure::DiameterChannel if has_arguments => {
                self.core.refuse(span, codes::S2021::takes_no_argument(&name))
            }
            Procedure::TransformationOff => {
                let on = self.st.transformation.is_some();
                let ended = self.transformation_ends(span);
                if ended.is_ok() && !on {
                    self.core.say_once(span, codes::S8103::words_that_only_steer_control());
                }
                ended
            }
            Procedure::DiameterChannel => {
                self.st.diameter = None;
                Ok(())
            }
            Procedure::Swivel if !has_arguments => self.swivel_off(span),
            Procedure::EndLabel => self.core.refuse(span, codes::P1001::endlabel_is_label()),
            Procedure::Refused(refusal) => {
                // Nobody knows where it leaves the axes.
                self.st.position.lose(AxisSet::ALL);
                self.lost();
                self.core.refuse(span, not_supported(name, refusal))
            }
            _ => {
                LeftOut::of_procedure(procedure, name)?.say(&self.core, span);
                Ok(())
            }
        })
    }
}

/// What is said of a procedure that cannot be compiled.
fn not_supported(name: &str, Refusal { what, code, .. }: Refusal) -> Fault {
    let key = Answer::key("programs", name);
    let instead = cycles::instead(name);
    if code == codes::S9006 {
        codes::S9006::procedure_is_not_supported(&name, &what).help(instead)
    } else if cycles::is_program(name) {
        let file = key.one_of(&[format!("{{ file = \"stubs/{name}.SPF\" }}")]);
        codes::P9010::cycle_is_not_supported_but_file_may_run(&name, &what, &instead).answer(file)
    } else if LEFT_OUT_BY_ENTRY.contains(&name) {
        let ignored = key.one_of(&["{ ignore = true }"]);
        codes::P9010::procedure_may_be_left_out(&name, &what).answer(ignored)
    } else {
        codes::P9010::procedure_is_not_supported(&name, &what)
    }
}
