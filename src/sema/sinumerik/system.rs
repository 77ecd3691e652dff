//! System variables that a compiler can know, and functions that need the program.
//!
//! Source: S 4.7 and 5.7 (docs/sources.md).

use crate::diag::{Answer, Fault, Help, codes};
use crate::parser::symbols::Symbol;
use crate::text::Span;

use super::axis_names::AxisNames;
use super::frames::FrameValue;
use super::offsets::{Outer, offset_word};
use super::system_meanings::{is_measured, meaning_of, said_meaning};
use super::system_variables::SystemVariables;
use super::tool_questions::tool_is_asked;
use super::value::Val;
use super::{Channel, Core, Outcome, State};

impl State {
    /// Millimetres in the unit of a system variable: lengths and radii of edges follow G700 and G710.
    fn tool_data_unit(&self, word: &str) -> f64 {
        match word {
            "$TC_DP3" | "$TC_DP4" | "$TC_DP5" | "$TC_DP6" | "$TC_DP7" | "$TC_DP12" | "$TC_DP13" | "$TC_DP14"
            | "$TC_DP15" => self.feed_unit(),
            _ => 1.0,
        }
    }
}

/// A probe that only guards its move touches nothing.
fn or_untouched(mut help: Help) -> Help {
    help.text.push_str(
        "; if the probe only guards its move and touches nothing, set `[control] probing_contact = \"none\"`",
    );
    help.and(Answer::key("control", "probing_contact").one_of(&["\"none\""]))
}

impl SystemVariables {
    /// `$SC_…`, `$SN_…`: setting data, which change what other words do.
    fn write_setting(&mut self, core: &Core<'_>, word: &str, key: String, value: Val, span: Span) -> Outcome {
        let on_the_machine = core.job.settings.variables.get(&key).copied();
        let changes = on_the_machine.is_none() || on_the_machine != value.number();
        match word {
            // Read by increments and threads. Behind a new tool length no increment has a place to count from.
            "$SC_FRAME_OFFSET_INCR_PROG" | "$SC_THREAD_START_ANGLE" | "$SC_TOOL_OFFSET_INCR_PROG" => {}
            "$SC_DRY_RUN_FEED" | "$SC_SINGLEBLOCK2_STOPRE" => {
                core.say_once(span, codes::S8006::is_for_trial_runs(&word));
            }
            _ if changes => {
                let shown = value.number().unwrap_or(0.0);
                return core.refuse(
                    span,
                    codes::S9103::is_setting_datum(&word, &key, &shown).answer(Answer::key("variables", &key)),
                );
            }
            _ => {}
        }
        self.set(key, value);
        Ok(())
    }
}

impl State {
    /// `$P_PFRAME`, `$P_IFRAME`: the frames in force.
    fn write_frame(&mut self, core: &Core<'_>, word: &str, args: &[Val], value: &Val, span: Span) -> Outcome {
        let programmable = word == "$P_PFRAME";
        let old = if programmable { Some(self.frames.programmable()) } else { self.frames.settable() };
        let frame = core.accept(span, new_frame(self.feed_unit(), old.cloned().unwrap_or_default(), args, value))?;
        self.codes.frame_is_free(core, span)?;
        if programmable {
            self.frames.set_programmable(frame);
            self.refresh_frame(core);
        } else if self.frames.is_tilted() {
            return core.refuse(span, codes::S2283::frame_of_offset_changes(&word));
        } else {
            core.resolved_offset_note(span);
            self.offsets.resolve(core, &mut self.position, span)?;
            self.counts_from(core, Outer::Basic, Some(frame));
        }
        Ok(())
    }

    /// `$P_UIFR[n]`: a work offset, which counts once it is selected.
    fn write_offset(&mut self, core: &Core<'_>, args: &[Val], value: &Val, span: Span) -> Outcome {
        let Some((number, rest)) = core.offset_number(args, span)? else {
            return core.refuse(span, codes::S2018::number_of_work_offset_is_missing());
        };
        let old = match self.frames.offset_of(&core.job.settings.datums, number) {
            Some(frame) => frame,
            None if rest.is_empty() => FrameValue::default(),
            None => {
                let word = offset_word(number);
                let fault = codes::P2023::one_component_of_is_set(&word).answer(Answer::key("datums", &word));
                return core.refuse(span, fault);
            }
        };
        let frame = core.accept(span, new_frame(self.feed_unit(), old, rest, value))?;
        self.frames.write(number, frame);
        core.resolved_offset_note(span);
        Ok(())
    }
}

impl AxisNames {
    /// `AXNAME("X")`
    pub(super) fn of_text(&mut self, core: &Core<'_>, args: &[Val], span: Span) -> Outcome<Val> {
        let [Val::Text(text)] = args else {
            return core.refuse(span, codes::S2021::axname_takes_text());
        };
        let name = String::from_utf8_lossy(text).to_ascii_uppercase();
        let Some(named) = self.find(&name) else {
            return core.refuse(span, codes::P2022::axname_names_no_axis_of_this_machine(&name));
        };
        self.printed(core, named, span)?;
        Ok(Val::Axis(named))
    }
}

impl Channel<'_> {
    /// Reads `$NAME[args]`.
    pub(super) fn system_value(&mut self, name: Symbol, args: &[Val], span: Span) -> Outcome<Val> {
        let word = self.core.symbols.name(name).to_owned();
        let key = system_key(&word, args);
        self.set_beside.leaves_system(&word, &key, &self.core, span)?;
        if let Some(value) = self.known_value(&word, args, span)? {
            says_unused(&self.core, &key, &value, span);
            return Ok(value);
        }
        if let Some(value) = self.measured.untouched_value(&self.core, &self.st.system, &word, &key, span)? {
            says_unused(&self.core, &key, &value, span);
            return Ok(value);
        }
        if let Some(value) = self.st.system.get(&key) {
            let unit = self.st.tool_data_unit(&word);
            return Ok(match value.number() {
                Some(number) if unit != 1.0 => Val::Real(number / unit),
                _ => value.clone(),
            });
        }
        if let Some(value) = self.core.job.settings.variables.get(&key).copied() {
            if is_measured(&word) {
                self.measured.says_given(&self.core, &key, value, false, span);
            }
            return Ok(Val::Real(value));
        }
        let help =
            tool_is_asked(&self.core.job.settings.tools, &self.st.tool, &word, args, &key).unwrap_or_else(|| {
                let meaning = meaning_of(&word, args).unwrap_or_default();
                let help =
                    Answer::variable(&key, meaning).help(format!("give it under [variables]: \"{key}\" = value"));
                if word == "$AC_MEA" && !self.core.never_touches() { or_untouched(help) } else { help }
            });
        self.core.refuse(span, codes::P2023::value_of_is_known_on_machine(&key, &said_meaning(&word, args)).help(help))
    }

    /// Writes `$NAME[args]`.
    pub(super) fn write_system(&mut self, name: Symbol, args: &[Val], value: Val, span: Span) -> Outcome {
        let word = self.core.symbols.name(name).to_owned();
        let starts = |prefixes: &[&str]| prefixes.iter().any(|prefix| word.starts_with(prefix));
        match word.as_str() {
            "$P_PFRAME" | "$P_IFRAME" => self.st.write_frame(&self.core, &word, args, &value, span),
            "$P_UIFR" => self.st.write_offset(&self.core, args, &value, span),
            _ if starts(&["$SC_", "$SN_"]) => {
                self.st.system.write_setting(&self.core, &word, system_key(&word, args), value, span)
            }
            _ if starts(&["$TC_", "$AC_MARKER", "$AC_PARAM", "$P_AD"]) => {
                let unit = self.st.tool_data_unit(&word);
                let value = match value.number() {
                    Some(number) if unit != 1.0 => Val::Real(number * unit),
                    _ => value,
                };
                // Tool data besides the radius stay in the program.
                if word.starts_with("$TC_") && !matches!(&word[..], "$TC_DP6" | "$TC_DP15") {
                    self.core.report_new(codes::S8010::is_not_printed(&word).at(self.core.loc(span)));
                }
                let key = system_key(&word, args);
                self.st.tool.is_written(&word, &key);
                self.st.system.set(key, value);
                Ok(())
            }
            _ if starts(&["$A_", "$AC_", "$AN_"]) => {
                self.core.say_once(span, codes::S8006::is_output_or_counter_of_control(&word));
                self.st.system.set(system_key(&word, args), value);
                Ok(())
            }
            _ if word.starts_with("$P_") && !word.contains("FR") => {
                self.core.refuse(span, codes::P2023::is_state_of_program(&word))
            }
            _ => self.core.refuse(span, codes::P2023::cannot_be_set_by_compiled_program(&word)),
        }
    }
}

/// `frame` with the component `args`, or a whole one; lengths count in `unit` mm.
fn new_frame(unit: f64, mut frame: FrameValue, args: &[Val], value: &Val) -> Result<FrameValue, Fault> {
    if args.is_empty() {
        return match value {
            Val::Frame(frame) => Ok((**frame).clone()),
            other => Err(codes::P2024::frame_is_needed(&other.what())),
        };
    }
    frame.write_component(args, value, unit)?;
    Ok(frame)
}

/// What the program and `[tools]` determine goes before a value of `[variables]`.
fn says_unused(core: &Core<'_>, key: &str, value: &Val, span: Span) {
    let Some(given) = core.job.settings.variables.get(key).copied() else { return };
    let Some(taken) = value.number().filter(|taken| *taken != given) else { return };
    core.report_once(codes::S8172::of_variables_is_not_used(&key, &given, &taken).at(core.loc(span)));
}

/// `$TC_DP6[1,1]`
pub(super) fn system_key(word: &str, args: &[Val]) -> String {
    if args.is_empty() {
        return word.to_owned();
    }
    let shown: Vec<String> = args
        .iter()
        .map(|value| match super::value::to_text(value) {
            Some(text) => String::from_utf8_lossy(&text).into_owned(),
            None => String::new(),
        })
        .collect();
    format!("{word}[{}]", shown.join(","))
}
