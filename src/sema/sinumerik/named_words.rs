//! Words with a name, a number or an index: addresses, calls, spindles, axes by variable.
//!
//! Source: S 1.3 and 5.6 (docs/sources.md).

use crate::diag::{Answer, codes};
use crate::parser::sinumerik::ast::{Args, Base, Block, Formula, Value, Word};
use crate::parser::symbols::Symbol;
use crate::text::Span;

use super::axis_names::{AxisNames, NamedAxis};
use super::beside_path::Beside;
use super::g_groups::{GCode, Group};
use super::probe_state;
use super::value::{Val, whole};
use super::vocabulary::{Address, Indexed, Meaning, Procedure, Refusal};
use super::words::{CallWord, Given, MachineAxis, Positioning, SWord, Words};
use super::{Channel, Core, Outcome, Run};

/// Does the block set an interrupt? The program it names is not called here.
fn interrupts(words: &Words) -> bool {
    words.calls.word.is_some_and(|call| call.meaning == Meaning::Procedure(Procedure::Interrupt))
}

impl Run<'_> {
    pub(super) fn name_word(
        &mut self,
        words: &mut Words,
        name: Symbol,
        word: &Word,
        block: &Block,
        text: &[u8],
    ) -> Outcome<bool> {
        if let Value::Formula(formula) = word.value {
            return self.name_with_value(words, (name, formula), word, block, text);
        }
        let args = match word.value {
            Value::Call(args) => Some(args),
            _ => None,
        };
        let meaning = self.meaning(name);
        match (meaning, args) {
            (Meaning::Code(code), None) => words.add_code(&self.channel.core, code, word.span)?,
            (Meaning::Procedure(Procedure::NoEffect), _) if words.calls.word.is_none() => {
                self.without_effect(name, args, word.span)?;
            }
            // `SETINT(1) PRIO=1 NAME`
            (Meaning::Unknown, _) if interrupts(words) && words.calls.interrupt.is_none() => {
                words.calls.interrupt = Some(word.span);
            }
            _ if words.calls.word.is_some() => {
                return self.channel.core.refuse(word.span, codes::S2013::two_calls_stand_in_one_block());
            }
            _ => words.calls.word = Some(CallWord { name, meaning, args, span: word.span }),
        }
        Ok(false)
    }

    /// `NAME=…`: a variable, an address, or an axis.
    fn name_with_value(
        &mut self,
        words: &mut Words,
        (name, formula): (Symbol, Formula),
        word: &Word,
        block: &Block,
        text: &[u8],
    ) -> Outcome<bool> {
        if self.vars.find(name).is_some() {
            self.assign_word(word, block, text)?;
            return Ok(true);
        }
        match self.meaning(name) {
            Meaning::Address(Address::Prio) if interrupts(words) => {
                let given = self.given(word, block, text)?;
                if !(1.0..=128.0).contains(&given.value) {
                    return self.channel.core.refuse(word.span, codes::S2021::priority_of_interrupt_is_1_to_128());
                }
            }
            Meaning::Address(Address::Dynamics) => {
                let value = self.eval(formula, block, text)?;
                self.dynamics_word(words, name, value.number(), word.span)?;
            }
            Meaning::Address(address) => {
                let given = self.given(word, block, text)?;
                words.set_address(&self.channel.core, address, given)?;
            }
            Meaning::Axis(named) => {
                let given = self.given(word, block, text)?;
                words.add_axis(&self.channel.core, &mut self.channel.axis_names, named, given)?;
            }
            Meaning::Procedure(Procedure::Refused(_))
                if probe_state::word(self.channel.core.symbols.name(name), word.span).is_some() =>
            {
                let probe = probe_state::word(self.channel.core.symbols.name(name), word.span);
                if let Some(probe) = probe {
                    self.probe_word(words, probe, word, block, text)?;
                }
            }
            Meaning::Procedure(Procedure::Refused(_)) | Meaning::Known(_)
                if Beside::find(self.channel.core.symbols.name(name)).is_some() =>
            {
                let own = self.channel.core.symbols.name(name).to_owned();
                self.oscillation_word(&own, word, block, text)?;
            }
            Meaning::Procedure(Procedure::Refused(Refusal { what, .. })) => {
                return self.channel.core.refuse(
                    word.span,
                    codes::P9010::is_not_supported_so_replace(&self.channel.core.symbols.name(name), &what),
                );
            }
            _ => {
                if self.definitions_known() {
                    return self.measuring_word(name, None, word, block, text);
                }
                return self.name_word(words, name, word, block, text);
            }
        }
        Ok(false)
    }

    /// OVR, ADIS, CTOL and the like.
    fn dynamics_word(&self, words: &mut Words, name: Symbol, value: Option<f64>, span: Span) -> Outcome {
        match self.channel.core.symbols.name(name) {
            "OVR" if value != Some(100.0) => {
                return self.channel.core.refuse(span, codes::S9009::ovr_changes_every_feed_by_factor());
            }
            "ADIS" => words.smoothing.distance = value,
            "CTOL" => words.smoothing.tolerance = value,
            _ => drop(words.dynamics.get_or_insert(span)),
        }
        Ok(())
    }

    /// STOPRE and other words that do nothing to the path.
    fn without_effect(&mut self, name: Symbol, args: Option<Args>, span: Span) -> Outcome {
        let own = self.channel.core.symbols.name(name);
        if own == "SAVE" || own == "STOPRE" && args.is_some_and(|args| args.count > 0) {
            let fault = if own == "SAVE" {
                codes::P1001::save_is_attribute_of_proc()
            } else {
                codes::P1001::stopre_takes_no_argument()
            };
            return self.channel.core.refuse(span, fault);
        }
        self.channel.core.control_words_are_left_out(span);
        // It ends the look-ahead.
        if self.channel.st.pair.is_open() && self.channel.core.symbols.name(name) == "STOPRE" {
            self.channel.pending_must_be_done(span)?;
        }
        Ok(())
    }

    pub(super) fn indexed_word(
        &mut self,
        words: &mut Words,
        base: Base,
        args: Args,
        word: &Word,
        block: &Block,
        text: &[u8],
    ) -> Outcome<bool> {
        let name = match base {
            Base::Name(name) if self.vars.find(name).is_none() => name,
            Base::Letter(letter) if letter != b'R' && self.letter_variable(letter).is_none() => {
                return self.indexed_letter(words, letter, args, word, block, text).map(|()| false);
            }
            Base::Name(_) | Base::Letter(_) | Base::System(_) => {
                self.assign_word(word, block, text)?;
                return Ok(true);
            }
        };
        match self.meaning(name) {
            Meaning::Indexed(indexed) => self.indexed_address(words, indexed, args, word, block, text).map(|()| false),
            Meaning::Address(address @ (Address::Lims | Address::Spos | Address::Sposa)) => {
                let spindle = self.spindle_index(args, block, text)?;
                let given = self.given(word, block, text)?;
                self.channel.address_of_spindle(words, address, spindle, given).map(|()| false)
            }
            Meaning::Address(Address::Dynamics) => {
                self.given(word, block, text)?;
                words.dynamics.get_or_insert(word.span);
                Ok(false)
            }
            Meaning::Address(address @ (Address::Toff | Address::Toffl | Address::Toffr)) => {
                let given = self.given(word, block, text)?;
                words.set_address(&self.channel.core, address, given).map(|()| false)
            }
            Meaning::Procedure(Procedure::Refused(_))
                if probe_state::word(self.channel.core.symbols.name(name), word.span).is_some() =>
            {
                self.axis_index(args, block, text)?;
                if let Some(probe) = probe_state::word(self.channel.core.symbols.name(name), word.span) {
                    self.probe_word(words, probe, word, block, text)?;
                }
                Ok(false)
            }
            Meaning::Procedure(Procedure::Refused(_)) | Meaning::Known(_)
                if Beside::find(self.channel.core.symbols.name(name)).is_some() =>
            {
                let own = self.channel.core.symbols.name(name).to_owned();
                self.oscillation_word(&own, word, block, text).map(|()| false)
            }
            _ => {
                if self.definitions_known() {
                    return self.measuring_word(name, Some(args), word, block, text);
                }
                self.indexed_word(words, base, args, word, block, text)
            }
        }
    }

    /// `_MVAR=100`, `_SETV[0]=10`: what a measuring cycle is told; any other name is not known.
    fn measuring_word(
        &mut self,
        name: Symbol,
        args: Option<Args>,
        word: &Word,
        block: &Block,
        text: &[u8],
    ) -> Outcome<bool> {
        let own = self.channel.core.symbols.name(name);
        if super::measuring_data::find(own).is_none()
            || !self.channel.core.job.settings.control.klartext_choices.probing_left_out
        {
            return self.undefined_word(name, word.span);
        }
        let own = own.to_owned();
        let mut indices = Vec::new();
        for formula in args.map(|args| block.arguments(args).to_vec()).unwrap_or_default() {
            indices.push(self.eval(formula, block, text)?);
        }
        let Value::Formula(formula) = word.value else { return self.undefined_word(name, word.span) };
        let list = self.list_of(formula, block, text)?.is_some();
        let value = if list { None } else { Some(self.eval(formula, block, text)?) };
        self.keeps_measuring_data(&own, &indices, value, word.span);
        Ok(true)
    }

    /// `S[2]=`, `M[1]=`, `G[8]=`, `T[1]=`
    pub(super) fn indexed_letter(
        &mut self,
        words: &mut Words,
        letter: u8,
        args: Args,
        word: &Word,
        block: &Block,
        text: &[u8],
    ) -> Outcome {
        match letter {
            b'S' | b'M' => {
                let spindle = self.spindle_index(args, block, text)?;
                let given = self.given(word, block, text)?;
                if letter == b'M' {
                    return words.add_m(&self.channel.core, Some(spindle), given);
                }
                self.channel.core.no_modifier(given)?;
                words.s.push(SWord { spindle: Some(spindle), value: given.value, span: given.span });
                Ok(())
            }
            b'H' => {
                self.index_number(args, block, text)?;
                self.given(word, block, text)?;
                words.h = Some(word.span);
                Ok(())
            }
            b'G' => {
                let group = self.index_number(args, block, text)?;
                let given = self.given(word, block, text)?;
                let known = u8::try_from(group).ok().and_then(Group::of).filter(|group| group.takes_index());
                let Some(known) = known else {
                    return self.channel.core.refuse(word.span, codes::S2010::g_group_cannot_be_set_by_index(&group));
                };
                let size = known.size();
                let index = whole(given.value).and_then(|n| u8::try_from(n).ok()).filter(|n| (1..=size).contains(n));
                match index {
                    Some(index) => words.add_code(&self.channel.core, GCode::new(known, index), word.span),
                    None => self
                        .channel
                        .core
                        .refuse(word.span, codes::S2011::g_group_has_indices_1(&group, &size, &given.value)),
                }
            }
            _ => self.channel.core.refuse(word.span, codes::P1001::takes_no_index(&(letter as char))),
        }
    }

    pub(super) fn index_number(&mut self, args: Args, block: &Block, text: &[u8]) -> Outcome<i32> {
        let [formula] = *block.arguments(args) else {
            return self.channel.core.refuse(block.span, codes::S2018::one_index_is_needed());
        };
        let value = self.number(formula, block, text)?;
        match whole(value) {
            Some(n) => Ok(n),
            None => self.channel.core.refuse(formula.span, codes::S2018::index_is_whole_number()),
        }
    }

    pub(super) fn spindle_index(&mut self, args: Args, block: &Block, text: &[u8]) -> Outcome<u8> {
        let n = self.index_number(args, block, text)?;
        match u8::try_from(n) {
            Ok(n) if (1..=20).contains(&n) => Ok(n),
            _ => self.channel.core.refuse(block.span, codes::S2018::there_is_no_spindle(&n)),
        }
    }

    /// The axis in brackets.
    pub(super) fn axis_index(&mut self, args: Args, block: &Block, text: &[u8]) -> Outcome<NamedAxis> {
        let [formula] = *block.arguments(args) else {
            return self.channel.core.refuse(block.span, codes::S2031::one_axis_is_needed_in_brackets());
        };
        match self.eval(formula, block, text)? {
            Val::Axis(axis) => Ok(axis),
            other => self.channel.core.refuse(formula.span, codes::S2031::axis_is_needed_in_brackets(&other.what())),
        }
    }

    pub(super) fn indexed_address(
        &mut self,
        words: &mut Words,
        indexed: Indexed,
        args: Args,
        word: &Word,
        block: &Block,
        text: &[u8],
    ) -> Outcome {
        match indexed {
            Indexed::Ax => {
                let named = self.axis_index(args, block, text)?;
                let given = self.given(word, block, text)?;
                words.axis_once(&self.channel.core, &mut self.channel.axis_names, named, given)
            }
            Indexed::Pos => {
                let named = self.axis_index(args, block, text)?;
                let given = self.given(word, block, text)?;
                words.positioning_word(&self.channel.core, &mut self.channel.axis_names, named, given)
            }
            Indexed::Fa => {
                let named = self.axis_index(args, block, text)?;
                let given = self.given(word, block, text)?;
                self.channel.core.positioning_feed(words, named, given)
            }
            Indexed::Override => {
                if self.given(word, block, text)?.value != 100.0 {
                    return self.channel.core.refuse(word.span, codes::S9009::ovra_changes_feed_of_axis_or_speed());
                }
                Ok(())
            }
            Indexed::Dynamics => {
                if !matches!(word.value, Value::None) {
                    self.given(word, block, text)?;
                }
                words.dynamics.get_or_insert(word.span);
                Ok(())
            }
            Indexed::DiameterOn | Indexed::Diameter90 | Indexed::DiameterOff | Indexed::DiameterChannel => {
                match self.axis_index(args, block, text)?.axis {
                    Some(axis) => words.diameter = Some((indexed, axis, word.span)),
                    None => return self.channel.core.no_diameter_axis(word.span),
                }
                Ok(())
            }
            Indexed::Posa => {
                let named = self.axis_index(args, block, text)?;
                words.moves_beside(&self.channel.core, &mut self.channel.axis_names, named, word.span)
            }
            Indexed::CutAxis => {
                let named = self.axis_index(args, block, text)?;
                self.channel.core.refers_to_cut_axis(named, word.span)
            }
            Indexed::Polynomial => self.channel.core.refuse(word.span, codes::S9002::polynomials_cannot_be_printed()),
        }
    }

    #[allow(clippy::too_many_arguments)]
    pub(super) fn numbered_word(
        &mut self,
        words: &mut Words,
        letter: u8,
        number: u32,
        name: Symbol,
        word: &Word,
        block: &Block,
        text: &[u8],
    ) -> Outcome<bool> {
        if letter == b'R' || self.vars.find(name).is_some() {
            self.assign_word(word, block, text)?;
            return Ok(true);
        }
        match self.meaning(name) {
            Meaning::Address(address) => {
                let given = self.given(word, block, text)?;
                words.set_address(&self.channel.core, address, given)?;
                return Ok(false);
            }
            Meaning::Axis(named) => {
                let given = self.given(word, block, text)?;
                words.add_axis(&self.channel.core, &mut self.channel.axis_names, named, given)?;
                return Ok(false);
            }
            _ => {}
        }
        let spindle = u8::try_from(number).ok();
        match letter {
            b'T' if number <= 1 => {
                let Value::Formula(formula) = word.value else { return Err(super::Reported) };
                self.tool_word(words, formula, word.span, block, text)?;
            }
            b'S' => {
                let given = self.given(word, block, text)?;
                self.channel.core.no_modifier(given)?;
                words.s.push(SWord { spindle, value: given.value, span: given.span });
            }
            b'M' => {
                let given = self.given(word, block, text)?;
                words.add_m(&self.channel.core, spindle, given)?;
            }
            b'H' => {
                self.given(word, block, text)?;
                words.h = Some(word.span);
            }
            b'A' | b'B' | b'C' if (2..=7).contains(&number) => {
                return self
                    .channel
                    .core
                    .refuse(word.span, codes::S9006::gives_direction_of_tool(&(letter as char), &number));
            }
            b'X' | b'Y' | b'Z' | b'A' | b'B' | b'C' | b'U' | b'V' | b'W' => {
                self.given(word, block, text)?;
                words.beside.machine.push(MachineAxis { letter, number, span: word.span });
            }
            _ => return self.undefined_word(name, word.span),
        }
        Ok(false)
    }
}

impl Channel<'_> {
    /// LIMS, SPOS and SPOSA with the number of a spindle.
    fn address_of_spindle(&mut self, words: &mut Words, address: Address, spindle: u8, given: Given) -> Outcome {
        if spindle == self.st.spindles.master() {
            return words.set_address(&self.core, address, given);
        }
        if address == Address::Lims {
            return self.st.spindles.speed_limit(&self.core, Some(spindle), given);
        }
        let turned = self.st.spindles.position_of(&self.core, spindle, given)?;
        self.function(turned);
        Ok(())
    }
}

impl Words {
    /// `AX[Z]=`: the word of an axis, once in a block.
    fn axis_once(&mut self, core: &Core<'_>, names: &mut AxisNames, named: NamedAxis, given: Given) -> Outcome {
        if named.axis.is_some_and(|axis| self.axes.contains(axis)) {
            return core.refuse(given.span, codes::P1002::axis_stands_twice_in_block_so_delete_one(&named.text()));
        }
        self.add_axis(core, names, named, given)
    }
}

impl Words {
    fn positioning_word(&mut self, core: &Core<'_>, names: &mut AxisNames, named: NamedAxis, given: Given) -> Outcome {
        match names.printed(core, named, given.span)? {
            Some(axis) => self.beside.positioning.push(Positioning { axis, given }),
            None => self.beside.left_out.push((named, given.span)),
        }
        Ok(())
    }
}

impl Words {
    /// POSA moves its axis while the next blocks run.
    fn moves_beside(&mut self, core: &Core<'_>, names: &mut AxisNames, named: NamedAxis, span: Span) -> Outcome {
        if names.printed(core, named, span)?.is_none() {
            self.beside.left_out.push((named, span));
            return Ok(());
        }
        core.refuse(span, codes::S9008::axis_that_moves_beside_path_cannot().answer(Answer::key("machine", "axes")))
    }
}

impl Core<'_> {
    fn positioning_feed(&self, words: &mut Words, named: NamedAxis, given: Given) -> Outcome {
        if given.value <= 0.0 {
            return self.refuse(given.span, codes::P2003::feed_of_positioning_axis_is_not_above(&given.value));
        }
        if let Some(axis) = named.axis {
            words.beside.feeds.push((axis, given.value));
        }
        Ok(())
    }

    /// SCC names the axis of the diameter, or nothing that can be printed.
    fn refers_to_cut_axis(&self, named: NamedAxis, span: Span) -> Outcome {
        if named.axis.is_some() && named.axis == self.job.settings.machine.diameter_axis {
            return Ok(());
        }
        self.refuse(span, codes::S9132::scc_refers_g96(&named.text()).answer(Answer::key("machine", "diameter_axis")))
    }
}
