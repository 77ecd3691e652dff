//! Sorts the words of a block by what they mean. Assignments are carried out on the way.
//!
//! Source: S 1.2, 1.3 and 5.6 (docs/sources.md).

use crate::diag::codes;
use crate::parser::sinumerik::ast::{Args, Base, Formula, Target, Value, Word};
use crate::parser::symbols::Symbol;

use super::beside_path::Beside;
use super::given::spindle;
use super::line::Line;
use super::measuring_data;
use super::probe_state;
use super::system::system_key;
use super::vocabulary::{Address, Indexed, Meaning, Procedure};
use super::words::{CallWord, Mode, Words};
use super::{Outcome, Reported, Run};

/// Does the block set an interrupt? The program it names is not called here.
fn interrupts(words: &Words) -> bool {
    words.calls.word.is_some_and(|call| call.meaning == Meaning::Procedure(Procedure::Interrupt))
}

/// Does the address take an axis in brackets, and a value?
fn takes(indexed: Indexed, value: Value) -> [bool; 2] {
    match indexed {
        Indexed::Ax | Indexed::Pos | Indexed::Fa => [true, true],
        Indexed::Override => [false, true],
        Indexed::Dynamics => [false, !matches!(value, Value::None)],
        Indexed::Polynomial => [false, false],
        Indexed::DiameterOn
        | Indexed::Diameter90
        | Indexed::DiameterOff
        | Indexed::DiameterChannel
        | Indexed::Posa
        | Indexed::CutAxis => [true, false],
    }
}

impl Run<'_> {
    /// Sorts the words of the block.
    pub(super) fn sort_words(&mut self, words: &mut Words, line: Line<'_>) -> Outcome {
        for word in &line.block.words {
            // Is it an assignment?
            let assigned = match word.target {
                Target::Letter(letter) => {
                    let is_variable = matches!(word.value, Value::Formula(_))
                        && self.vars.letter(letter, &self.channel.core.symbols).is_some();
                    if is_variable {
                        self.assign_word(word, line)?;
                    } else {
                        self.letter_word(words, letter, word, line)?;
                    }
                    is_variable
                }
                Target::Numbered(letter, number, name) => {
                    self.numbered_word(words, letter, number, name, word, line)?
                }
                Target::Name(name) => self.name_word(words, name, word, line)?,
                Target::System(_) => {
                    self.assign_word(word, line)?;
                    true
                }
                Target::Indexed(base, args) => self.indexed_word(words, base, args, word, line)?,
            };
            words.note(assigned, word.span);
        }
        match words.mixed_assignment() {
            Some(assigned) => self.channel.core.refuse(assigned, codes::S2014::assignment_stands_beside_other_words()),
            None => Ok(()),
        }
    }

    #[inline]
    fn letter_word(&mut self, words: &mut Words, letter: u8, word: &Word, line: Line<'_>) -> Outcome {
        if letter == b'T'
            && let Value::Formula(formula) = word.value
        {
            return self.tool_word(words, formula, word.span, line);
        }
        let given = self.given(word, line)?;
        if given.mode != Mode::Plain && b"GSPHL".contains(&letter) {
            self.channel.core.accept(given.span, given.no_modifier())?;
        }
        if letter == b'R' {
            return self.channel.core.refuse(word.span, codes::S2016::address_r_has_no_meaning());
        }
        match self.channel.axis_names.letter(letter) {
            Some(named) => words.add_axis(&self.channel.core, &mut self.channel.axis_names, named, given),
            None => words.set_letter(&self.channel.core, &self.names.gcodes, letter, word, given),
        }
    }

    #[allow(clippy::too_many_arguments)]
    fn numbered_word(
        &mut self,
        words: &mut Words,
        letter: u8,
        number: u32,
        name: Symbol,
        word: &Word,
        line: Line<'_>,
    ) -> Outcome<bool> {
        if letter == b'R' || self.vars.find(name).is_some() {
            return self.assign_word(word, line).map(|()| true);
        }
        match (self.names.meaning(name, &self.channel), letter) {
            (Meaning::Address(address), _) => {
                let given = self.given(word, line)?;
                words.set_address(&self.channel.core, address, given)?;
            }
            (Meaning::Axis(named), _) => {
                let given = self.given(word, line)?;
                words.add_axis(&self.channel.core, &mut self.channel.axis_names, named, given)?;
            }
            (_, b'T') if number <= 1 => {
                let Value::Formula(formula) = word.value else { return Err(Reported) };
                self.tool_word(words, formula, word.span, line)?;
            }
            (_, b'A' | b'B' | b'C') if (2..=7).contains(&number) => {
                let fault = codes::S9006::gives_direction_of_tool(&(letter as char), &number);
                return self.channel.core.refuse(word.span, fault);
            }
            (_, b'S' | b'M' | b'H' | b'X' | b'Y' | b'Z' | b'A' | b'B' | b'C' | b'U' | b'V' | b'W') => {
                let given = self.given(word, line)?;
                words.set_numbered(&self.channel.core, letter, number, given)?;
            }
            _ => {
                let fault = self.names.misused(name, &self.vars, &self.channel);
                return self.channel.core.refuse(word.span, fault);
            }
        }
        Ok(false)
    }

    fn name_word(&mut self, words: &mut Words, name: Symbol, word: &Word, line: Line<'_>) -> Outcome<bool> {
        if let Value::Formula(formula) = word.value {
            return self.name_with_value(words, (name, formula), word, line);
        }
        let args = match word.value {
            Value::Call(args) => Some(args),
            _ => None,
        };
        let meaning = self.names.meaning(name, &self.channel);
        let core = &self.channel.core;
        match (meaning, args) {
            (Meaning::Code(code), None) => words.add_code(core, code, word.span)?,
            (Meaning::Procedure(Procedure::NoEffect), _) if words.calls.word.is_none() => {
                match core.symbols.name(name) {
                    "SAVE" => return core.refuse(word.span, codes::P1001::save_is_attribute_of_proc()),
                    "STOPRE" if args.is_some_and(|args| args.count > 0) => {
                        return core.refuse(word.span, codes::P1001::stopre_takes_no_argument());
                    }
                    _ => {}
                }
                core.say_once(word.span, codes::S8103::words_that_only_steer_control());
                // It ends the look-ahead.
                if self.channel.st.pair.is_open() && core.symbols.name(name) == "STOPRE" {
                    self.channel.pending_must_be_done(word.span)?;
                }
            }
            // `SETINT(1) PRIO=1 NAME`
            (Meaning::Unknown, _) if interrupts(words) && words.calls.interrupt.is_none() => {
                words.calls.interrupt = Some(word.span);
            }
            _ if words.calls.word.is_some() => {
                return core.refuse(word.span, codes::S2013::two_calls_stand_in_one_block());
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
        line: Line<'_>,
    ) -> Outcome<bool> {
        if self.vars.find(name).is_some() {
            return self.assign_word(word, line).map(|()| true);
        }
        match self.names.meaning(name, &self.channel) {
            Meaning::Address(Address::Prio) if interrupts(words) => {
                let given = self.given(word, line)?;
                if !(1.0..=128.0).contains(&given.value) {
                    return self.channel.core.refuse(word.span, codes::S2021::priority_of_interrupt_is_1_to_128());
                }
            }
            Meaning::Address(Address::Dynamics) => {
                let value = self.eval(formula, line)?;
                let core = &self.channel.core;
                let set = words.set_dynamics(core.symbols.name(name), value.number(), word.span);
                core.accept(word.span, set)?;
            }
            Meaning::Address(address) => {
                let given = self.given(word, line)?;
                words.set_address(&self.channel.core, address, given)?;
            }
            Meaning::Axis(named) => {
                let given = self.given(word, line)?;
                words.add_axis(&self.channel.core, &mut self.channel.axis_names, named, given)?;
            }
            meaning => {
                let other = self.other_word(words, (name, meaning), None, word, line)?;
                return other.map_or_else(|| self.name_word(words, name, word, line), Ok);
            }
        }
        Ok(false)
    }

    fn indexed_word(
        &mut self,
        words: &mut Words,
        base: Base,
        args: Args,
        word: &Word,
        line: Line<'_>,
    ) -> Outcome<bool> {
        let name = match base {
            Base::Name(name) if self.vars.find(name).is_none() => name,
            Base::Letter(letter)
                if letter != b'R' && self.vars.letter(letter, &self.channel.core.symbols).is_none() =>
            {
                // `S[2]=`, `M[1]=`, `G[8]=`, `H[1]=`
                if !matches!(letter, b'S' | b'M' | b'H' | b'G') {
                    return self.channel.core.refuse(word.span, codes::P1001::takes_no_index(&(letter as char)));
                }
                let index = self.index_number(args, line)?;
                if matches!(letter, b'S' | b'M') {
                    self.channel.core.accept(line.block.span, spindle(index))?;
                }
                let given = self.given(word, line)?;
                return words.set_indexed(&self.channel.core, letter, index, given).map(|()| false);
            }
            Base::Name(_) | Base::Letter(_) | Base::System(_) => {
                return self.assign_word(word, line).map(|()| true);
            }
        };
        match self.names.meaning(name, &self.channel) {
            Meaning::Indexed(indexed) => {
                let [axis, value] = takes(indexed, word.value);
                let named = if axis { Some(self.axis_index(args, line)?) } else { None };
                let given = if value { Some(self.given(word, line)?) } else { None };
                self.channel.indexed_address(words, (indexed, word.span), named, given)?;
            }
            Meaning::Address(address @ (Address::Lims | Address::Spos | Address::Sposa)) => {
                let index = self.index_number(args, line)?;
                let spindle = self.channel.core.accept(line.block.span, spindle(index))?;
                let given = self.given(word, line)?;
                self.channel.address_of_spindle(words, address, spindle, given)?;
            }
            Meaning::Address(Address::Dynamics) => {
                self.given(word, line)?;
                words.dynamics.get_or_insert(word.span);
            }
            Meaning::Address(address @ (Address::Toff | Address::Toffl | Address::Toffr)) => {
                let given = self.given(word, line)?;
                words.set_address(&self.channel.core, address, given)?;
            }
            meaning => {
                let other = self.other_word(words, (name, meaning), Some(args), word, line)?;
                return other.map_or_else(|| self.indexed_word(words, base, args, word, line), Ok);
            }
        }
        Ok(false)
    }

    /// Words that measure, with or without their axis, words of oscillation, and data of the measuring cycles: true for an assignment.
    /// `None` where the word is to be looked at again: the definition files were read for it.
    fn other_word(
        &mut self,
        words: &mut Words,
        (name, meaning): (Symbol, Meaning),
        args: Option<Args>,
        word: &Word,
        line: Line<'_>,
    ) -> Outcome<Option<bool>> {
        let own = self.channel.core.symbols.name(name).to_owned();
        let refused = matches!(meaning, Meaning::Procedure(Procedure::Refused(_)));
        if let Some(probe) = probe_state::word(&own, word.span).filter(|_| refused) {
            if let Some(args) = args {
                self.axis_index(args, line)?;
            }
            if let Value::Formula(formula) = word.value {
                self.eval(formula, line)?;
            }
            words.probe = Some(probe);
            return Ok(Some(false));
        }
        if (refused || matches!(meaning, Meaning::Known(_))) && Beside::find(&own).is_some() {
            let result = self.oscillation_word(&own, word, line);
            if result.is_err() {
                self.channel.lose_all();
            }
            return result.map(|()| Some(false));
        }
        let without_files = refused && args.is_none();
        if !without_files && !self.definitions_known() {
            return Ok(None);
        }
        // `_MVAR=100`, `_SETV[0]=10`: kept for the cycle that follows where measuring is left out; any other name is not known.
        let left_out = self.channel.core.job.settings.control.klartext_choices.probing_left_out;
        let kept = left_out && !refused && measuring_data::find(&own).is_some();
        let indices = if kept { self.values(line.arguments_of(args), line)? } else { Vec::new() };
        let (true, Value::Formula(formula)) = (kept, word.value) else {
            let fault = self.names.misused(name, &self.vars, &self.channel);
            return self.channel.core.refuse(word.span, fault);
        };
        let list = self.list_of(formula, line)?.is_some();
        let value = if list { None } else { Some(self.eval(formula, line)?) };
        let key = system_key(&own, &indices);
        match value {
            Some(value) => self.channel.st.system.set(key, value),
            None => self.channel.st.system.forget(&key),
        }
        self.channel.core.say_once(word.span, codes::S8168::arguments_of_measuring_cycles());
        Ok(Some(true))
    }
}
