//! Reading and setting variables: their values, what is said of those that nothing set, and the names that nothing has.
//!
//! Source: S 5.1 and 5.6 (docs/sources.md).

use std::rc::Rc;

use crate::diag::{Answer, Fault, Help, Label, codes};
use crate::parser::sinumerik::ast::{Base, Target, TypeName, Variable};
use crate::parser::symbols::{Symbol, Symbols};
use crate::sema::value::SetBy;
use crate::text::Span;

use super::control_folders::DEFINITION_FILES;
use super::conversions::{ASSIGNED, Fill};
use super::dictionary;
use super::measuring_data;
use super::value::{MOST_R, MOST_TEXT, Val, indices, r_index};
use super::vars::{Reference, Slot, Var, Vars};
use super::vocabulary::Meaning;
use super::{Channel, Core, Outcome, Reported};

impl Vars {
    // Reading.

    pub(super) fn r_value(&mut self, n: u32, channel: &Channel<'_>, span: Span) -> Outcome<Val> {
        let core = &channel.core;
        if n > MOST_R {
            return core.refuse(span, codes::S2018::there_is_no_parameter_r(&n));
        }
        channel.set_beside.leaves_r(n, core, span)?;
        let (value, set) = self.r(n).ok_or(Reported)?;
        if !set {
            self.said.unset.push(format!("R{n}"));
            if self.said.r.insert(n) {
                let help = Answer::key("variables", format!("R{n}"))
                    .help(format!("set it in the program, or as `R{n} = …` under [variables]"));
                core.say(span, codes::P2021::r_is_read_before_program_sets(&n).help(help));
            }
        }
        Ok(Val::Real(value))
    }

    pub(super) fn value(&mut self, slot: Slot, indices: &[i32], channel: &Channel<'_>, span: Span) -> Outcome<Val> {
        channel.set_beside.leaves_variable(slot, &channel.core, span)?;
        self.warn_of_kept(slot, indices, &channel.core, span);
        let var = self.get(slot).filter(|var| !var.lost).ok_or(Reported)?;
        match var.offset(indices) {
            Some(at) => Ok(var.values[at].clone()),
            None => channel.core.refuse(span, var.no_element(indices)),
        }
    }

    /// `A[1,2]`, or the third character of a text: `S[2]`; of a frame its component.
    pub(super) fn indexed(&mut self, slot: Slot, args: &[Val], channel: &Channel<'_>, span: Span) -> Outcome<Val> {
        let core = &channel.core;
        let first = self.get(slot).and_then(|var| var.values.first());
        if let Some(Val::Frame(frame)) = first.cloned() {
            self.warn_of_kept(slot, &[], core, span);
            return core.accept(span, frame.read_component(args, channel.st.feed_unit()));
        }
        let indices = core.accept(span, indices(args))?;
        if let Some(var) = self.get(slot)
            && let ([index], [], Some(Val::Text(text))) = (&indices[..], &var.sizes[..], var.values.first())
        {
            let found = usize::try_from(*index).ok().and_then(|at| text.get(at)).copied();
            self.warn_of_kept(slot, &[], core, span);
            let found = found.ok_or_else(|| codes::S2018::text_has_no_character(index));
            return core.accept(span, found.map(Val::Char));
        }
        self.value(slot, &indices, channel, span)
    }

    /// Reads the target that counts a loop; `args` are the values in its brackets.
    pub(super) fn read_target(
        &mut self,
        target: Target,
        args: &[Val],
        channel: &Channel<'_>,
        span: Span,
    ) -> Outcome<Val> {
        let core = &channel.core;
        let slot = self.target(target, &core.symbols);
        match (target, slot) {
            (Target::Numbered(b'R', n, _), _) => self.r_value(n, channel, span),
            (Target::Indexed(Base::Letter(b'R'), _), _) => {
                let n = core.accept(span, r_index(args))?;
                self.r_value(n, channel, span)
            }
            (Target::System(_) | Target::Indexed(Base::Letter(_) | Base::System(_), _), _) => {
                core.refuse(span, codes::P1001::this_cannot_count_loop())
            }
            (Target::Letter(_), None) => core.refuse(span, codes::P1001::address_cannot_count_loop()),
            (_, None) => core.refuse(span, self.no_target(target, core)),
            (_, Some(slot)) => {
                let indices = core.accept(span, indices(args))?;
                self.value(slot, &indices, channel, span)
            }
        }
    }

    // Setting.

    /// Sets a target that is no system variable; `args` are the values in its brackets.
    pub(super) fn write_target(
        &mut self,
        target: Target,
        args: &[Val],
        value: &Val,
        channel: &Channel<'_>,
        span: Span,
    ) -> Outcome {
        let core = &channel.core;
        if let Target::Numbered(b'R', ..) | Target::Indexed(Base::Letter(b'R'), _) = target {
            let n = if let Target::Numbered(_, n, _) = target { n } else { core.accept(span, r_index(args))? };
            let value = core.accept(span, value.as_number())?;
            return self.set_r_parameter(n, value, core, span);
        }
        let Some(slot) = self.target(target, &core.symbols) else {
            return core.refuse(span, self.no_target(target, core));
        };
        if let Target::Indexed(..) = target {
            return self.write_indexed(slot, args, value, channel, span);
        }
        if let (Target::Numbered(_, _, name) | Target::Name(name), Some(number)) = (target, value.number()) {
            let origin = core.here.origin;
            core.job.trail.assigns(origin.loc, origin.call, || core.symbols.name(name).to_owned(), number);
        }
        self.write(slot, &[], value, core, span)
    }

    /// The array that a list of values fills.
    pub(super) fn slot_to_fill(&self, target: Target, core: &Core<'_>) -> Result<Slot, Fault> {
        self.target(target, &core.symbols).ok_or_else(|| match target {
            Target::Name(_) | Target::Numbered(..) | Target::Indexed(Base::Name(_), _) => self.no_target(target, core),
            _ => codes::P2024::list_of_values_fills_array(),
        })
    }

    /// Fills an array from the element on that `args` name.
    pub(super) fn fill(&mut self, slot: Slot, args: &[Val], fill: &Fill, core: &mut Core<'_>, span: Span) -> Outcome {
        let indices = core.accept(span, indices(args))?;
        let var = self.get_mut(slot).ok_or(Reported)?;
        let start = if indices.is_empty() { Some(0) } else { var.offset(&indices) };
        let Some(start) = start.filter(|_| !var.sizes.is_empty()) else {
            return core.refuse(span, codes::S2018::array_has_no_such_element());
        };
        core.budget.take(var.values.len() as u64 / 16);
        *var = var.clone().filled(start, fill, core, span)?;
        Ok(())
    }

    pub(super) fn set_r_parameter(&mut self, n: u32, value: f64, core: &Core<'_>, span: Span) -> Outcome {
        if n > MOST_R {
            return core.refuse(span, codes::S2018::there_is_no_parameter_r(&n));
        }
        let origin = core.here.origin;
        core.job.trail.assigns(origin.loc, origin.call, || format!("R{n}"), value);
        self.set_r(n, value);
        Ok(())
    }

    pub(super) fn write(&mut self, slot: Slot, indices: &[i32], value: &Val, core: &Core<'_>, span: Span) -> Outcome {
        let var = self.get_mut(slot).ok_or(Reported)?;
        let Some(at) = var.offset(indices) else {
            let fault = if var.sizes.is_empty() {
                codes::S2018::variable_is_no_array()
            } else {
                codes::S2018::there_is_no_element(&format_args!("{:?}", var.sizes), &format_args!("{indices:?}"))
            };
            return core.refuse(span, fault);
        };
        let value = value.taken_as(var.kind, ASSIGNED, core, span)?;
        core.accept(span, value.keeps_length(var.length))?;
        core.accept(span, value.keeps_limits(var.limits, [17080, 17090]))?;
        var.set(at, value);
        Ok(())
    }

    /// The same with the indices as values: an element, a character of a text, a component of a frame.
    pub(super) fn write_indexed(
        &mut self,
        slot: Slot,
        args: &[Val],
        value: &Val,
        channel: &Channel<'_>,
        span: Span,
    ) -> Outcome {
        let core = &channel.core;
        let first = self.get(slot).and_then(|var| var.values.first());
        if let Some(Val::Frame(frame)) = first {
            let mut changed = (**frame).clone();
            core.accept(span, changed.write_component(args, value, channel.st.feed_unit()))?;
            return self.write(slot, &[], &Val::Frame(Rc::new(changed)), core, span);
        }
        let indices = core.accept(span, indices(args))?;
        // One character of a text.
        if let Some(var) = self.get(slot)
            && let ([at], [], Some(Val::Text(old))) = (&indices[..], &var.sizes[..], var.values.first())
        {
            let character = value.taken_as(TypeName::Char, ASSIGNED, core, span)?;
            let mut bytes = old.to_vec();
            let place = usize::try_from(*at).ok().and_then(|at| bytes.get_mut(at));
            let (Some(place), Val::Char(c)) = (place, character) else {
                return core.refuse(span, codes::S2018::text_has_no_character(at));
            };
            *place = c;
            return self.write(slot, &[], &Val::text(&bytes), core, span);
        }
        self.write(slot, &indices, value, core, span)
    }

    /// What could not be computed is not reported again by those that read it.
    pub(super) fn lose(&mut self, target: Target, symbols: &Symbols) {
        match target {
            Target::Numbered(b'R', n, _) => self.lose_r(n),
            Target::Numbered(..) | Target::Name(_) | Target::Indexed(Base::Name(_), _) => {
                if let Some(var) = self.target(target, symbols).and_then(|slot| self.get_mut(slot)) {
                    var.lost = true;
                }
            }
            Target::Letter(_) | Target::System(_) | Target::Indexed(..) => {}
        }
    }

    // References.

    /// An element that stands for a VAR parameter.
    pub(super) fn element(&self, slot: Slot, args: &[Val]) -> Result<Option<Reference>, Fault> {
        let indices = indices(args)?;
        Ok(self.get(slot).and_then(|var| var.offset(&indices)).map(|at| Reference::Element(slot, at)))
    }

    /// Sets a variable that is given by reference to a whole number.
    pub(super) fn set_reference(&mut self, reference: Reference, value: i32) {
        let (slot, at) = match reference {
            Reference::R(n) => return self.set_r(n, f64::from(value)),
            Reference::Variable(slot) => (slot, 0),
            Reference::Element(slot, at) => (slot, at),
        };
        if let Some(var) = self.get_mut(slot)
            && let Ok(value) = Val::Int(value).converted(var.kind)
        {
            var.set(at, value);
        }
    }

    /// Hands the values of VAR parameters back to what they stand for.
    pub(super) fn give_back(&mut self, references: &[(Symbol, Reference)]) {
        for (name, reference) in references {
            let Some(own) = self.of_level(*name) else { continue };
            let Some(value) = own.values.first().cloned() else { continue };
            match *reference {
                Reference::R(n) => self.set_r(n, value.number().unwrap_or(0.0)),
                Reference::Variable(slot) => {
                    let (values, kept) = (own.values.clone(), own.kept.clone());
                    if let Some(var) = self.get_mut(slot) {
                        (var.values, var.kept) = (values, kept);
                    }
                }
                Reference::Element(slot, at) => {
                    if let Some(var) = self.get_mut(slot)
                        && let Some(element) = var.values.get_mut(at)
                    {
                        *element = value;
                        var.kept.knows(at);
                    }
                }
            }
        }
    }

    /// A parameter whose argument was refused: what reads it is not reported again.
    pub(super) fn lose_parameter(&mut self, variable: Variable, core: &Core<'_>) {
        let Some(name) = variable.name else { return };
        let defined = core.loc(variable.span);
        let var = Var::single(variable.kind, Val::zero(variable.kind), MOST_TEXT, defined);
        self.define(name, Var { lost: true, ..var }, false);
    }

    // Names.

    /// ISVAR: a variable, or an element of one that exists.
    pub(super) fn is_known(&self, wanted: &str, symbols: &mut Symbols) -> bool {
        let (name, rest) = wanted.split_once('[').unwrap_or((wanted, ""));
        let name = name.trim();
        let (letter, number) = name.split_at(usize::from(name.is_char_boundary(1) && name.len() > 1));
        let number =
            if number.is_empty() || letter.is_empty() { rest.strip_suffix(']').unwrap_or(rest) } else { number };
        if name.eq_ignore_ascii_case("R") || letter.eq_ignore_ascii_case("R") && rest.is_empty() {
            return number.trim().parse::<u32>().is_ok_and(|n| n <= MOST_R);
        }
        let var = self.find(symbols.intern(name.as_bytes())).and_then(|slot| self.get(slot));
        let Some(var) = var else { return false };
        let Some(rest) = rest.strip_suffix(']') else { return rest.is_empty() };
        let indices: Option<Vec<i32>> = rest.split(',').map(|index| index.trim().parse().ok()).collect();
        indices.is_some_and(|indices| var.offset(&indices).is_some())
    }

    /// Who set the variable that is zero.
    pub(super) fn set_to_zero(&self, name: Symbol, core: &Core<'_>) -> SetBy {
        let Some(slot) = self.find(name) else { return SetBy::Unknown };
        let own = matches!(slot, Slot::Local(_)).then_some(core.here.origin.call);
        let defined = self.get(slot).map(|var| SetBy::Definition(var.defined));
        let set = SetBy::of(&core.job, core.symbols.name(name), own);
        match (set, slot) {
            (Some(set), _) => set,
            (None, Slot::Local(_)) if !core.job.trail.has_returned() => defined.unwrap_or(SetBy::Unknown),
            (None, _) => SetBy::Unknown,
        }
    }

    /// What is wrong with a name that nothing is known of.
    pub(super) fn undefined(&self, name: Symbol, core: &Core<'_>) -> Fault {
        let word = core.symbols.name(name);
        if matches!(dictionary::words().get(word), Some(Meaning::Indexed(_))) {
            return codes::P1001::lacks_axis_or_spindle_in_brackets(&word);
        }
        if let Some(result) = measuring_data::find(word) {
            // The control has these in its own definition files.
            let what = if result { "a result" } else { "an argument" };
            let help = if core.job.settings.control.klartext_choices.probing_left_out {
                "give it a value before the cycle that it is for".into()
            } else {
                measuring_data::leave_out()
            };
            return codes::S9133::is_of_measuring_cycles(&word, &what).help(help);
        }
        let names: Vec<&str> = self.names().map(|symbol| core.symbols.name(symbol)).collect();
        let help = match crate::machine::tree::did_you_mean(word, names) {
            Some(like) => format!("did you mean `{like}`?").into(),
            None if self.in_main(name) => Answer::key("control", "md11120")
                .one_of(&["true"])
                .help("it is a variable of the main program; if subprograms see those, set `[control] md11120 = true`"),
            None => Help::from("define it by DEF at the top of the program, or in a definition file beside it"),
        };
        // A variable of all programs is nothing like one of this program.
        let files: Vec<String> = DEFINITION_FILES.iter().map(|file| format!("{file}.DEF")).collect();
        codes::S2001::name_is_not_defined(&word).help(help.and(Answer::folder_of(&files)))
    }

    /// What is wrong with a target that is no variable.
    pub(super) fn no_target(&self, target: Target, core: &Core<'_>) -> Fault {
        match target {
            Target::Numbered(_, _, name) | Target::Name(name) | Target::Indexed(Base::Name(name), _) => {
                self.undefined(name, core)
            }
            Target::Letter(_) | Target::System(_) | Target::Indexed(..) => codes::P1001::this_takes_no_value(),
        }
    }

    /// Says that a value is read which the control keeps, and nothing here says.
    fn warn_of_kept(&mut self, slot: Slot, indices: &[i32], core: &Core<'_>, span: Span) {
        let Some(var) = self.get(slot) else { return };
        let Some(element) = var.offset(indices).or((!var.values.is_empty() && var.sizes.is_empty()).then_some(0))
        else {
            return;
        };
        let Some(name) = var.kept.open(element) else { return };
        let (kind, defined) = (var.kind, var.defined);
        let mut word = core.symbols.name(name).to_owned();
        // An index of a text is a character.
        if !indices.is_empty() && kind != TypeName::String {
            let indices: Vec<String> = indices.iter().map(ToString::to_string).collect();
            word = format!("{word}[{}]", indices.join(","));
        }
        let is_number = matches!(kind, TypeName::Bool | TypeName::Int | TypeName::Real);
        self.said.unset.extend(is_number.then(|| word.clone()));
        if !self.said.kept.insert((name, element)) {
            return;
        }
        let help: Help = if is_number {
            Answer::variable(&word, "the value that the control keeps in it")
                .help("set it in the program, or give the value that the control keeps in it under [variables]")
        } else {
            "set it in the program: what the control keeps in it is not known here".into()
        };
        let found = codes::P2021::is_read_before_program_sets(&word).at(core.loc(span));
        core.report(found.also(defined, Label::IsDefinedHere).help(help));
    }
}

impl Var {
    fn set(&mut self, at: usize, value: Val) {
        if let Some(element) = self.values.get_mut(at) {
            *element = value;
            self.kept.knows(at);
            self.lost = false;
        }
    }

    fn no_element(&self, indices: &[i32]) -> Fault {
        let sizes = &self.sizes;
        match (sizes.len(), indices.len()) {
            (0, _) => codes::S2018::variable_is_no_array(),
            (n, given) if n != given => codes::S2018::array_has_indices(&n, &given),
            _ => codes::S2018::array_has_no_element(&format_args!("{indices:?}"), &format_args!("{sizes:?}")),
        }
    }
}
