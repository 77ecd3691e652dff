//! A machining cycle where it is called: its arguments, what it requires, its plan, and what is said of it.
//!
//! Source: K 4.4, 6.0 (docs/sources.md). The parameters from Q200 on stay variables: a call takes what they hold then.

use std::rc::Rc;

use crate::diag::{Fault, Label, codes};
use crate::lexer::klartext::{QKind, QRef};
use crate::machine::AxisSet;
use crate::sema::cycle::call::{Kind, Made, Refusal};
use crate::sema::cycle::given::{Given, Value};
use crate::sema::cycle::row::{Name, Parameter};
use crate::sema::run::Where;

use super::cycles::call::{Calling, CycleCall, Heights, Instead, Seen};
use super::cycles::data::{Contoured, Kept, Values};
use super::cycles::{CycleKind, DefinedCycle, Planned, Requires};
use super::known::Known;
use super::place::View;
use super::reading::Reading;
use super::{Core, Outcome, Reported, Run};

impl Run<'_> {
    /// Runs the cycle where the tool stands.
    pub(super) fn run_cycle(&mut self, cycle: &DefinedCycle, calling: Calling) -> Outcome {
        cycle.same_unit(&self.core)?;
        let contours = self.requirements(cycle, calling)?;
        let given = self.checked(cycle)?;
        self.run_planned(cycle, &given, calling, contours)
    }

    /// What the parameters hold now, which is what the row asks for.
    pub(super) fn checked(&mut self, cycle: &DefinedCycle) -> Outcome<Given> {
        let given = cycle.given(self.reading())?;
        self.planned(cycle, &given, Calling::HERE, None, |call| call.fits())?;
        Ok(given)
    }

    /// The same at one of many places, with arguments that were read before.
    pub(super) fn run_given(&mut self, cycle: &DefinedCycle, given: &Given, calling: Calling) -> Outcome {
        let contours = self.requirements(cycle, calling)?;
        self.run_planned(cycle, given, calling, contours)
    }

    fn run_planned(
        &mut self,
        cycle: &DefinedCycle,
        given: &Given,
        calling: Calling,
        contours: Option<Contoured>,
    ) -> Outcome {
        let nature = cycle.row().nature;
        let planned = self.planned(cycle, given, calling, contours, |call| match nature {
            CycleKind::Drilling(drilling) => call.hole(drilling),
            CycleKind::Milling(plan) => plan(call),
            _ => Ok(Planned::default()),
        })?;
        self.send_planned(cycle, planned)
    }

    /// What has to hold where the cycle is called, and the contours and data that it takes.
    fn requirements(&mut self, cycle: &DefinedCycle, calling: Calling) -> Outcome<Option<Contoured>> {
        let mut contours = None;
        for requires in cycle.row().requires {
            match requires {
                Requires::NoCompensation if self.st.compensation.is_on() => {
                    return self.core.refuse(Where::Block, codes::K2407::cycle_is_called_while_rl_or_rr());
                }
                Requires::Turning if !self.st.spindle.turns() => {
                    return cycle.refuse_as_is(&self.core, codes::K2405::spindle_does_not_turn_at_this_cycle());
                }
                Requires::Speed if self.st.spindle.speed().is_none_or(|speed| speed <= 0.0) => {
                    return cycle.refuse_as_is(&self.core, codes::K2405::spindle_has_no_speed_at_this_cycle());
                }
                Requires::ToolChange => {
                    self.st.tool.cuts_now(&self.core)?;
                    if self.st.feed.plunge_share().is_some() {
                        self.core.say_here(codes::K2709::m103_does_not_change_feeds());
                    }
                }
                Requires::NoScaling if self.st.frames.transform().scales() => {
                    return cycle.refuse(&self.core, codes::P9010::tapping_under_scaling());
                }
                Requires::CutterUnscaled => cycle.keeps_the_cutter(self.view())?,
                Requires::Contours => {
                    let named = self.contours.taken(&self.core, cycle, calling)?;
                    contours = Some(Contoured { named, data: None, area: None, train: None });
                }
                Requires::PocketData => {
                    let Some(data) = self.contours.pocket.read(self.reading())? else {
                        return cycle.refuse(&self.core, codes::K2952::there_is_no_contour_data());
                    };
                    if let Some(contours) = &mut contours {
                        contours.data = Some(data);
                    }
                }
                Requires::NoCompensation | Requires::Turning | Requires::Speed | Requires::NoScaling => {}
            }
        }
        if cycle.row().drills() {
            self.st.leave_open_end(&self.core, AxisSet::EMPTY, false);
        }
        Ok(contours)
    }

    /// Plans a call, and reports what is said of it.
    pub(super) fn planned<T>(
        &mut self,
        cycle: &DefinedCycle,
        given: &Given,
        calling: Calling,
        mut contours: Option<Contoured>,
        plan: impl Fn(&CycleCall<'_>) -> Made<T>,
    ) -> Outcome<T> {
        loop {
            let seen = Seen {
                cycle,
                calling,
                state: &self.st,
                radius_of: &|number| match self.st.tool.is_measured() {
                    true => None,
                    false => self.tools.radius_of(&self.core, number),
                },
                contours: contours.as_ref(),
                roughed: &self.contours.roughed,
                instead: None.into(),
                at_definition: Vec::new().into(),
            };
            let call = CycleCall::new(given, &seen, self.core.job.settings);
            let made = plan(&call);
            for fault in seen.at_definition.take() {
                self.core.report(fault.at(cycle.loc));
            }
            for remark in call.remarks() {
                let found = remark.fault.at(self.core.loc(remark.place)).also(cycle.loc, Label::CycleDefined);
                if remark.kind == Kind::Once { self.core.report_once(found) } else { self.core.report(found) }
            }
            let lacks = seen.instead.take();
            match (made, lacks) {
                (Ok(made), _) => return Ok(made),
                (Err(Refusal::Fault(place, fault)), _) => return cycle.refuse_at(&self.core, place, fault),
                (Err(Refusal::Known), None) => return Err(Reported),
                (Err(Refusal::Known), Some(lacks)) => self.provide(cycle, given, contours.as_mut(), lacks)?,
            }
        }
    }

    /// Gets what a plan cannot go on without, or says that it is not to be had.
    fn provide(
        &mut self,
        cycle: &DefinedCycle,
        given: &Given,
        contours: Option<&mut Contoured>,
        lacks: Instead,
    ) -> Outcome {
        let span = self.core.block_span();
        match (lacks, contours) {
            (Instead::Position(axis), _) => self.view().position_of(axis, span, &given.called).and(Err(Reported)),
            (Instead::Radius, _) => self.st.tool.radius(&self.core, span).and(Err(Reported)),
            (Instead::Teeth, _) => self.st.tool.feed_of_teeth(&self.core, 1.0, span).and(Err(Reported)),
            (Instead::Area { corners, away }, Some(contours)) => {
                contours.area = Some(self.contour_area(cycle, &contours.named, (corners, away))?);
                Ok(())
            }
            (Instead::Train, Some(contours)) => {
                contours.train = Some(self.train_of(cycle, &contours.named)?);
                Ok(())
            }
            (Instead::Data(fault), Some(Contoured { data: Some(data), .. })) => {
                data.values.cycle.refuse(&self.core, fault)
            }
            (Instead::Data(fault), Some(Contoured { train: Some(train), .. })) => match &train.data {
                Some(data) => data.values.cycle.refuse(&self.core, fault),
                None => Err(Reported),
            },
            (Instead::Area { .. } | Instead::Train | Instead::Data(_), _) => Err(Reported),
        }
    }
}

impl DefinedCycle {
    // The definition.

    /// Are all parameters of the definition there? Looked at when it is complete.
    pub(super) fn check(&self, core: &Core<'_>) -> Outcome {
        let row = self.row();
        if !row.nature.runs() {
            return Ok(());
        }
        if row.has_parts(self.number) {
            let Some(missing) = row.needed().find(|name| !self.gives(*name)) else { return Ok(()) };
            return core.refuse(Where::Block, codes::K2402::cycle_lacks_value_of_part(&self.number, &missing));
        }
        self.all_are_set(core)
    }

    /// Every Q parameter that the cycle needs.
    pub(super) fn all_are_set(&self, core: &Core<'_>) -> Outcome {
        let needed = self.row().needed();
        let missing: Vec<String> = needed.filter(|name| !self.gives(*name)).map(|name| name.to_string()).collect();
        if missing.is_empty() {
            return Ok(());
        }
        let of = format_args!("cycle {}", self.number);
        core.refuse(Where::Block, codes::K2402::lacks_so_program_all(&of, &missing.join(", ")))
    }

    /// Q parameters have no unit: those of a definition count in the unit of its program, which a call has to share.
    pub(super) fn same_unit(&self, core: &Core<'_>) -> Outcome {
        if self.mm == core.mm() {
            return Ok(());
        }
        let fault = codes::K2947::cycle_is_called_in_program_of_another(&self.number);
        core.report(fault.at(core.here.origin.loc).also(self.loc, Label::CycleDefined));
        Err(Reported)
    }

    // The call.

    /// What the parameters hold now.
    pub(super) fn given(&self, reading: Reading<'_, '_>) -> Outcome<Given> {
        let row = self.row();
        let called = format!("cycle {}", self.number);
        let mut given = Given::new(&row.signature, called, Where::Block, self.mm);
        for parameter in row.signature.parameters {
            given.push(self.value(reading, parameter)?, Where::Block);
        }
        Ok(given)
    }

    fn value(&self, reading: Reading<'_, '_>, parameter: &Parameter) -> Outcome<Value> {
        let name = parameter.name;
        if parameter.without_effect.is_some() || !self.gives(name) {
            return Ok(Value::Missing);
        }
        let Name::Q(number) = name else {
            return Ok(self.in_definition(name).map_or(Value::Missing, Value::Number));
        };
        match self.word(name) {
            Some(word) => Ok(Value::Word(word)),
            None => {
                let q = QRef { kind: QKind::Q, number };
                reading.parameter(q, reading.core.block_span()).map(Value::Number)
            }
        }
    }

    /// The heights that Q200, Q203 and Q204 give.
    pub(super) fn heights(&self, core: &Core<'_>, given: &Given, shift: f64) -> Heights {
        if let Some(fault) = Heights::low_second(given) {
            core.report(fault.at(core.here.origin.loc).also(self.loc, Label::CycleDefined));
        }
        Heights::of(given, shift)
    }

    /// The tool has the size that it has: a frame may shift, turn and mirror in the plane.
    fn keeps_the_cutter(&self, view: View<'_, '_>) -> Outcome {
        let (frame, plane) = (&view.st.ctx.frame, view.st.plane());
        if !frame.is_unscaled() {
            return self.refuse(view.core, codes::K9030::milling_under_scaling());
        }
        if !frame.keeps_axis_across(plane) {
            return self.refuse(view.core, codes::K9030::milling_with_mirrored_tool_axis());
        }
        Ok(())
    }

    // What is said.

    /// Refuses the call of the cycle.
    pub(super) fn refuse<T>(&self, core: &Core<'_>, fault: Fault) -> Outcome<T> {
        self.refuse_as_is(core, fault.of(format_args!("cycle {}", self.number)))
    }

    /// The same by a text that does not begin with the cycle, or does so already.
    fn refuse_as_is<T>(&self, core: &Core<'_>, fault: Fault) -> Outcome<T> {
        self.refuse_at(core, Where::Block, fault)
    }

    fn refuse_at<T>(&self, core: &Core<'_>, place: Where, mut fault: Fault) -> Outcome<T> {
        if fault.code() == codes::P2090 && !fault.has_help() {
            let told = fault.message().split_once(": ").map_or(fault.message(), |(_, told)| told);
            let help = check_the_values(self.mm, told);
            fault = fault.help(help);
        }
        core.report_cause(fault.at(core.loc(place)).also(self.loc, Label::CycleDefined));
        Err(Reported)
    }
}

impl Known<Values> {
    /// The data of cycle 20 or 270 as they are now.
    pub(super) fn read(&self, reading: Reading<'_, '_>) -> Outcome<Option<Kept>> {
        match self {
            Known::Nothing => Ok(None),
            Known::Lost => Err(Reported),
            Known::Given(values) => {
                values.cycle.same_unit(reading.core)?;
                let given = values.cycle.given(reading)?;
                Ok(Some(Kept { values: Rc::clone(values), given }))
            }
        }
    }
}

/// Lengths are said in mm, in programs in inches, too.
fn check_the_values(mm: f64, message: &str) -> &'static str {
    if mm == 1.0 || !message.contains(|c: char| c.is_ascii_digit()) {
        "check the values of the definition"
    } else {
        "check the values of the definition; lengths are given here in mm"
    }
}
