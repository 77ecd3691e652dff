//! A machining cycle where it is called: its arguments, what it requires, its plan, and what is said of it.
//!
//! Source: K 4.4, 6.0 (docs/sources.md). The parameters from Q200 on stay variables: a call takes what they hold then.

use crate::diag::{Fault, Label, codes};
use crate::lexer::klartext::{QKind, QRef};
use crate::machine::AxisSet;
use crate::sema::cycle::call::{Kind, Made, Refusal};
use crate::sema::cycle::given::{Given, Value};
use crate::sema::cycle::row::{Name, Parameter};
use crate::sema::run::Where;

use super::cycles::call::{Calling, CycleCall, Heights, Instead, Seen};
use super::cycles::data::{Contoured, Kept};
use super::cycles::{DefinedCycle, Nature, Planned, Requires};
use super::known::Known;
use super::{Outcome, Reported, Run};

impl Run<'_> {
    // The definition.

    /// Are all parameters of the definition there? Looked at when it is complete.
    pub(super) fn check_definition(&mut self, cycle: &DefinedCycle) -> Outcome {
        let row = cycle.row();
        if !row.nature.runs() {
            return Ok(());
        }
        if row.has_parts(cycle.number) {
            let Some(missing) = row.needed().find(|name| !cycle.gives(*name)) else { return Ok(()) };
            return self.core.refuse(Where::Block, codes::K2402::cycle_lacks_value_of_part(&cycle.number, &missing));
        }
        self.all_are_set(cycle)
    }

    /// Every Q parameter that the cycle needs.
    pub(super) fn all_are_set(&self, cycle: &DefinedCycle) -> Outcome {
        let needed = cycle.row().needed();
        let missing: Vec<String> = needed.filter(|name| !cycle.gives(*name)).map(|name| name.to_string()).collect();
        if missing.is_empty() {
            return Ok(());
        }
        let of = format_args!("cycle {}", cycle.number);
        self.core.refuse(Where::Block, codes::K2402::lacks_so_program_all(&of, &missing.join(", ")))
    }

    /// Q parameters have no unit: those of a definition count in the unit of its program, which a call has to share.
    pub(super) fn same_unit(&mut self, cycle: &DefinedCycle) -> Outcome {
        if cycle.mm == self.core.level().frame.unit.mm() {
            return Ok(());
        }
        let fault = codes::K2947::cycle_is_called_in_program_of_another(&cycle.number);
        self.core.report(fault.at(self.core.here.origin.loc).also(cycle.loc, Label::CycleDefined));
        Err(Reported)
    }

    // The call.

    /// Runs the cycle where the tool stands.
    pub(super) fn run_cycle(&mut self, cycle: &DefinedCycle, calling: Calling) -> Outcome {
        self.same_unit(cycle)?;
        let contours = self.requirements(cycle, calling)?;
        let given = self.checked(cycle)?;
        self.run_planned(cycle, &given, calling, contours)
    }

    /// What the parameters hold now, which is what the row asks for.
    pub(super) fn checked(&mut self, cycle: &DefinedCycle) -> Outcome<Given> {
        let given = self.given_of(cycle)?;
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
            Nature::Drilling(drilling) => call.hole(drilling),
            Nature::Milling(plan) => plan(call),
            _ => Ok(Planned::default()),
        })?;
        self.send_planned(cycle, planned)
    }

    /// What the parameters hold now.
    pub(super) fn given_of(&mut self, cycle: &DefinedCycle) -> Outcome<Given> {
        let row = cycle.row();
        let called = format!("cycle {}", cycle.number);
        let mut given = Given::new(&row.signature, called, Where::Block, cycle.mm);
        for parameter in row.signature.parameters {
            let value = self.value_of(cycle, parameter)?;
            given.push(value, Where::Block);
        }
        Ok(given)
    }

    fn value_of(&mut self, cycle: &DefinedCycle, parameter: &Parameter) -> Outcome<Value> {
        let name = parameter.name;
        if parameter.without_effect.is_some() || !cycle.gives(name) {
            return Ok(Value::Missing);
        }
        let Name::Q(number) = name else {
            return Ok(cycle.in_definition(name).map_or(Value::Missing, Value::Number));
        };
        match cycle.word(name) {
            Some(word) => Ok(Value::Word(word)),
            None => {
                let span = self.core.block_span();
                self.parameter(QRef { kind: QKind::Q, number }, span).map(Value::Number)
            }
        }
    }

    /// What has to hold where the cycle is called, and the contours and data that it takes.
    fn requirements(&mut self, cycle: &DefinedCycle, calling: Calling) -> Outcome<Option<Contoured>> {
        let mut contours = None;
        for requires in cycle.row().requires {
            match requires {
                Requires::NoCompensation if self.st.compensation.is_on() => {
                    self.core.say_here(codes::K2407::cycle_is_called_while_rl_or_rr());
                    return Err(Reported);
                }
                Requires::Turning if !self.st.spindle.turns() => {
                    return self.refuse_as_is(cycle, codes::K2405::spindle_does_not_turn_at_this_cycle());
                }
                Requires::Speed if self.st.spindle.speed().is_none_or(|speed| speed <= 0.0) => {
                    return self.refuse_as_is(cycle, codes::K2405::spindle_has_no_speed_at_this_cycle());
                }
                Requires::ToolChange => {
                    self.cuts_now()?;
                    if self.st.feed.plunge_share().is_some() {
                        self.core.say_here(codes::K2709::m103_does_not_change_feeds());
                    }
                }
                Requires::NoScaling if self.st.frames.transform().scales() => {
                    return self.refuse_cycle(cycle, codes::P9010::tapping_under_scaling());
                }
                Requires::CutterUnscaled => self.frame_keeps_the_cutter(cycle)?,
                Requires::Contours => {
                    let named = self.named_contours(cycle, calling)?;
                    contours = Some(Contoured { named, data: None, area: None, train: None });
                }
                Requires::PocketData => {
                    let data = self.pocket_data(cycle)?;
                    if let Some(contours) = &mut contours {
                        contours.data = Some(data);
                    }
                }
                Requires::NoCompensation | Requires::Turning | Requires::Speed | Requires::NoScaling => {}
            }
        }
        if cycle.row().drills() {
            self.leave_open_end(AxisSet::EMPTY, false);
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
            let (made, lacks) = self.plan_once(cycle, given, calling, contours.as_ref(), &plan);
            match (made, lacks) {
                (Ok(made), _) => return Ok(made),
                (Err(Refusal::Fault(place, fault)), _) => return self.refuse_call(cycle, place, *fault),
                (Err(Refusal::Known), None) => return Err(Reported),
                (Err(Refusal::Known), Some(lacks)) => self.provide(cycle, given, contours.as_mut(), lacks)?,
            }
        }
    }

    fn plan_once<T>(
        &self,
        cycle: &DefinedCycle,
        given: &Given,
        calling: Calling,
        contours: Option<&Contoured>,
        plan: &impl Fn(&CycleCall<'_>) -> Made<T>,
    ) -> (Made<T>, Option<Instead>) {
        let seen = Seen {
            cycle,
            calling,
            state: &self.st,
            radius_of: &|number| self.radius_by_number(number),
            contours,
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
        (made, seen.instead.take())
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
            (Instead::Position(axis), _) => self.position_of(axis, span, &given.called).and(Err(Reported)),
            (Instead::Radius, _) => self.tool_radius(span).and(Err(Reported)),
            (Instead::Teeth, _) => self.feed_of_teeth(1.0, span).and(Err(Reported)),
            (Instead::Area { corners, away }, Some(contours)) => {
                contours.area = Some(self.contour_area(cycle, &contours.named, (corners, away))?);
                Ok(())
            }
            (Instead::Train, Some(contours)) => {
                contours.train = Some(self.train_of(cycle, &contours.named)?);
                Ok(())
            }
            (Instead::Data(fault), Some(Contoured { data: Some(data), .. })) => self.refuse_data(data, *fault),
            (Instead::Data(fault), Some(Contoured { train: Some(train), .. })) => match &train.data {
                Some(data) => self.refuse_data(data, *fault),
                None => Err(Reported),
            },
            (Instead::Area { .. } | Instead::Train | Instead::Data(_), _) => Err(Reported),
        }
    }

    fn refuse_data(&self, data: &Kept, fault: Fault) -> Outcome {
        self.refuse_cycle(&data.values.cycle, fault)
    }

    // What is said.

    /// The heights that Q200, Q203 and Q204 give.
    pub(super) fn heights(&self, cycle: &DefinedCycle, given: &Given, shift: f64) -> Heights {
        if let Some(fault) = Heights::low_second(given) {
            self.core.report(fault.at(self.core.here.origin.loc).also(cycle.loc, Label::CycleDefined));
        }
        Heights::of(given, shift)
    }

    /// Refuses the call of a cycle.
    pub(super) fn refuse_cycle<T>(&self, cycle: &DefinedCycle, fault: Fault) -> Outcome<T> {
        self.refuse_as_is(cycle, fault.of(format_args!("cycle {}", cycle.number)))
    }

    /// The same by a text that does not begin with the cycle, or does so already.
    pub(super) fn refuse_as_is<T>(&self, cycle: &DefinedCycle, fault: Fault) -> Outcome<T> {
        self.refuse_call(cycle, Where::Block, fault)
    }

    fn refuse_call<T>(&self, cycle: &DefinedCycle, place: Where, mut fault: Fault) -> Outcome<T> {
        if fault.raised.code == codes::P2090 && fault.help.is_none() {
            let told = fault.message.split_once(": ").map_or(fault.message.as_str(), |(_, told)| told);
            let help = check_the_values(cycle.mm, told);
            fault = fault.help(help);
        }
        self.core.report_cause(fault.at(self.core.loc(place)).also(cycle.loc, Label::CycleDefined));
        Err(Reported)
    }

    /// The data of cycle 20 or 270 as they are now.
    pub(super) fn kept(&mut self, values: &Known<super::cycles::data::Values>) -> Outcome<Option<Kept>> {
        match values {
            Known::Nothing => Ok(None),
            Known::Lost => Err(Reported),
            Known::Given(values) => {
                self.same_unit(&values.cycle)?;
                let given = self.given_of(&values.cycle)?;
                Ok(Some(Kept { values: std::rc::Rc::clone(values), given }))
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
