//! Measuring: MEAS and MEAW, the measuring cycles, and what they find.
//!
//! Comes in: blocks and calls that measure. Goes out: an error, or under `[control] probing = "leave-out"` a warning and nothing
//! else; only MEAW, which goes its whole way whatever the probe does, is printed as the plain move that it is. Where the probe left
//! the axes is known at the machine only, and so is what it found: each value is asked for under `[variables]` by its name.
//!
//! Source: S 6, P 3.1 and 3.2 (docs/sources.md).

use crate::diag::{Answer, Help, Label, codes};
use crate::ir::Side;
use crate::machine::{Axis, AxisSet, StandIn};
use crate::sema::common::hidden::By;
use crate::text::{Loc, Span};

use super::block::ARC_ADDRESSES;
use super::measuring_data;
use super::probe_state::{Measured, ProbeWord, Touched, hidden_with};
use super::system_meanings::is_measured;
use super::system_variables::SystemVariables;
use super::value::{Val, whole};
use super::vocabulary::Address;
use super::words::Words;
use super::{Channel, Core, Outcome, Reported, State};

/// What a cycle sets by what it measures.
enum Sets {
    Nothing,
    /// A work offset, by its KNUM where that is known.
    Offset(Option<i32>),
    Tool,
}

impl Measured {
    /// A block or a cycle measures: what was written of its results is no more what the control has.
    pub fn note(&mut self, system: &mut SystemVariables, name: &str, loc: Loc) {
        self.last = Some((name.to_owned(), loc));
        system.forget_where(|key| {
            let word = key.split('[').next().unwrap_or(key);
            is_measured(word) || measuring_data::find(word) == Some(true)
        });
    }

    /// MEAW, and MEAS whose probe touches nothing: its move was printed, if there was one.
    pub fn on_the_way(&mut self, core: &Core<'_>, system: &mut SystemVariables, probe: ProbeWord, moved: bool) {
        let (loc, name) = (core.loc(probe.span), probe.name);
        let found = match (moved, core.never_touches()) {
            (true, true) => codes::S8167::probe_touches_nothing(&name),
            (true, false) => codes::S8167::its_move_is_not_left_out(&name),
            (false, _) => codes::S8167::its_block_moves_no_axis(&name),
        }
        .at(loc);
        core.report_new(found);
        self.note(system, name, loc);
    }

    /// The probe touched nothing: what it measured has no value, and whether it touched is known.
    pub fn untouched_value(
        &self,
        core: &Core<'_>,
        system: &SystemVariables,
        word: &str,
        key: &str,
        span: Span,
    ) -> Outcome<Option<Val>> {
        let Some((name, at)) = self.last.as_ref().filter(|(name, _)| name.starts_with("MEA")) else {
            return Ok(None);
        };
        if !core.never_touches() || !is_measured(word) || system.is_written(key) {
            return Ok(None);
        }
        if word != "$AC_MEA" {
            return core.refuse(span, codes::P2023::has_no_value(&key, &name, &at.line));
        }
        let found = codes::S8169::is_0_in_line_touches_nothing(&key, &name, &at.line)
            .at(core.loc(span))
            .also(*at, Label::Measured);
        core.report_once(found.help("check that the control goes the same way through the program"));
        Ok(Some(Val::Int(0)))
    }

    /// What a feed move lacks after a cycle that is left out.
    pub fn help_of_feed(&self) -> Option<Help> {
        let (name, at) = self.cycle.as_ref()?;
        let help = format!(
            "program F in this block: {name} in line {} runs at feeds of its own, and the one before it ends",
            at.line
        );
        Some(help.into())
    }

    /// A value of `[variables]` stands for what was measured.
    pub fn says_given(&self, core: &Core<'_>, key: &str, value: f64, by_cycle: bool, span: Span) {
        let last = if by_cycle { self.cycle.as_ref() } else { self.last.as_ref() };
        let Some((name, at)) = last else { return };
        let found = codes::S8169::of_variables_is_taken_for_what(&key, &value, &name, &at.line)
            .at(core.loc(span))
            .also(*at, Label::Measured);
        if core.job.diags.first_text(codes::S8169, &found.message) {
            core.report(
                found.help("one value stands for all measurings of the program: check that it is right for this one"),
            );
        }
    }
}

impl ProbeWord {
    /// G4, TRANS and their kin take no words of moves.
    pub fn stands_beside(&self, core: &Core<'_>, span: Span) -> Outcome {
        let found = codes::S2013::needs_move(&self.name).at(core.loc(self.span));
        core.report(found.also(core.loc(span), Label::MovesNoAxis).help("give it a block with G1 and an axis"));
        Err(Reported)
    }
}

impl Channel<'_> {
    /// Leaves a measuring cycle out, however it is called, or refuses it.
    pub(super) fn leave_cycle_out(&mut self, name: &str, values: &[Val], span: Span) -> Outcome {
        let result = self.cycle_left_out(name, values, span);
        if result.is_err() {
            self.lose_all();
        }
        result
    }

    fn cycle_left_out(&mut self, name: &str, values: &[Val], span: Span) -> Outcome {
        self.pending_must_be_done(span)?;
        let ignored = self.core.job.settings.programs.get(name) == Some(&StandIn::Ignored);
        if !ignored && !self.core.job.settings.control.klartext_choices.probing_left_out {
            return self
                .core
                .refuse(span, codes::P9010::measuring_cycle_is_not_supported(&name).help(measuring_data::leave_out()));
        }
        if self.st.side() != Side::None || self.capture.is_some() {
            return self.core.refuse(span, codes::P9010::stands_under_radius_compensation_or_in_contour(&name));
        }
        let what = match set_by(&self.st.system, name, values) {
            Sets::Nothing => "",
            Sets::Tool => "; the data of tools stay those of the tool table",
            Sets::Offset(number) => {
                offset_by_probe(&self.core, &self.st, name, number, span)?;
                "; the work offset of the target has to be as it sets it, before the program runs"
            }
        };
        let loc = self.core.loc(span);
        let found = codes::S8167::is_left_out_what_it_measures(&name, &what).at(loc);
        self.core.report_new(found.help(
                "set up on the target what this cycle measures, before the program runs; look at the next rapid move: the target stands \
                 where it stood before the cycle",
            ));
        self.st.position.forget(AxisSet::ALL);
        self.st.position.hide(AxisSet::ALL, By::Probe, loc);
        let lathe = self.st.machine.lathe;
        let geometry: AxisSet = if lathe {
            [Axis::X, Axis::Z].into_iter().collect()
        } else {
            self.st.machine.geometry_axes.into_iter().collect()
        };
        let all = self.st.touched.map_or(AxisSet::EMPTY, |touched| touched.all);
        self.st.touched = Some(Touched { all, cuts: geometry, loc });
        // The cycle programs feeds of its own.
        self.st.feed.end();
        self.measured.note(&mut self.st.system, name, loc);
        self.measured.cycle = Some((name.to_owned(), loc));
        self.lost();
        Ok(())
    }

    /// A block with MEAS: no axis of it moves, and where the probe left them is not known.
    pub(super) fn probe_block(&mut self, w: &mut Words, probe: ProbeWord) -> Outcome {
        let mut axes = w.axes;
        let plane = w.take(Address::Ap).is_some() | w.take(Address::Rp).is_some() | w.take(Address::Ang).is_some();
        for address in ARC_ADDRESSES {
            w.take(address);
        }
        if plane {
            let [first, second, _] = self.st.roles();
            axes.insert(first);
            axes.insert(second);
        }
        for positioning in w.beside.positioning.drain(..) {
            axes.insert(positioning.axis);
        }
        let result = self.may_leave_probe_out(probe);
        if result.is_err() {
            self.st.position.lose(axes);
            self.lost();
            return result;
        }
        let loc = self.core.loc(probe.span);
        let letters: Vec<String> = axes.iter().map(|axis| axis.letter().to_string()).collect();
        let letters = letters.join(" and ");
        let stops = if axes.len() > 1 { "stop" } else { "stops" };
        let fault = if axes.is_empty() {
            codes::S8167::its_block_moves_no_axis(&probe.name)
        } else {
            codes::S8167::is_left_out_with_its_move(&probe.name, &letters, &stops)
        };
        let found = fault.at(loc);
        self.core.report_new(found);
        self.st.threads.end_chain();
        self.st.heading = super::tangent::Heading::None;
        let axes = hidden_with(&self.st.ctx.frame, axes);
        self.st.position.forget(axes);
        self.st.position.hide(axes, By::Probe, loc);
        let before = self.st.touched;
        let all = before.map_or(axes, |touched| touched.all.union(axes));
        let cuts = before.map_or(AxisSet::EMPTY, |touched| touched.cuts);
        self.st.touched = (!all.union(cuts).is_empty()).then_some(Touched { all, cuts, loc });
        self.measured.note(&mut self.st.system, probe.name, loc);
        self.only_known_axes_stand();
        Ok(())
    }

    pub(super) fn may_leave_probe_out(&mut self, probe: ProbeWord) -> Outcome {
        if !self.core.job.settings.control.klartext_choices.probing_left_out {
            return self.core.refuse(
                probe.span,
                codes::P9010::measuring_is_not_supported(&probe.name).help(measuring_data::leave_out()),
            );
        }
        self.pending_must_be_done(probe.span)?;
        let open = self.st.side() != Side::None || self.st.compensation.waits() || self.soft.is_some();
        if open || self.capture.is_some() || self.st.modal_call.is_on() {
            return self.core.refuse(probe.span, codes::P9010::stands_under_radius_compensation(&probe.name));
        }
        Ok(())
    }
}

impl Core<'_> {
    /// Does the configuration say that the probe touches nothing, so that each move goes its whole way?
    pub(super) fn never_touches(&self) -> bool {
        self.job.settings.control.klartext_choices.never_touches
    }
}

/// What the cycle sets: its arguments MVAR and KNUM, or the global data of the old form.
fn set_by(system: &SystemVariables, name: &str, values: &[Val]) -> Sets {
    let old = values.is_empty();
    let argument = |at: usize, global: &str| {
        let value = if old { system.number(global) } else { values.get(at).and_then(Val::number) };
        value.and_then(whole)
    };
    let (variant, number) = (argument(0, "_MVAR"), argument(1, "_KNUM"));
    match name {
        "CYCLE971" | "CYCLE972" | "CYCLE982" => Sets::Tool,
        "CYCLE973" | "CYCLE976" | "CYCLE995" => Sets::Nothing,
        _ if number == Some(0) => Sets::Nothing,
        "CYCLE974" | "CYCLE977" | "CYCLE978" | "CYCLE979" | "CYCLE994"
            if variant.is_some_and(|variant| variant / 100 % 10 == 0) =>
        {
            Sets::Tool
        }
        _ => Sets::Offset(number),
    }
}

/// A work offset that a left-out cycle corrects by what it measures.
fn offset_by_probe(core: &Core<'_>, st: &State, name: &str, number: Option<i32>, span: Span) -> Outcome {
    let which = number.map_or_else(String::new, |number| format!(" (KNUM {number})"));
    let message = format!("{name} corrects a work offset{which} by what it measures");
    match core.job.settings.control.klartext_choices.probing_datum {
        Some(true) if st.tool.others_worked() => core.refuse(span, codes::S9024::another_tool_worked_before(&message)),
        Some(true) if st.offsets.is_basic_said() => {
            core.refuse(span, codes::S9024::coordinates_count_from_basic_system(&message))
        }
        Some(true) => Ok(()),
        Some(false) => {
            let help = Answer::key("control", "probing_datum").one_of(&["\"set\""]);
            let help = help.help("`[control] probing_datum = \"refuse\"` compiles no such program");
            core.refuse(span, codes::S9024::corrects_work_offset_by_what(&name, &which).help(help))
        }
        None => core.refuse(
            span,
            codes::S9024::corrects_work_offset_by_what_it_measures(&name, &which)
                .answer(Answer::key("control", "probing_datum").one_of(&["\"set\""])),
        ),
    }
}
