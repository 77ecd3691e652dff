//! Sorts the words of a block by what they mean. Assignments are carried out on the way.
//!
//! Source: S 1.2 and 1.3 (docs/sources.md).

use crate::diag::{Label, codes};
use crate::machine::axis::AXES;
use crate::machine::{Axis, AxisSet};
use crate::parser::sinumerik::ast::{Args, Block, Formula, Op, Target, Value, Word};
use crate::parser::symbols::Symbol;
use crate::text::Span;

use super::axis_names::NamedAxis;
use super::foreign_codes::in_place_of;
use super::g_groups::{GCode, Group};
use super::probe_state::ProbeWord;
use super::value::Val;
use super::vocabulary::{ADDRESSES, Address, Indexed, Meaning};
use super::{Core, Outcome, Run};

/// How a value is meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum Mode {
    /// As G90 or G91 say.
    #[default]
    Plain,
    Ac,
    Ic,
    Dc,
    Acp,
    Acn,
    Dac,
    Dic,
    Rac,
    Ric,
    /// `QU`: quick output of an auxiliary function.
    Quick,
    /// `PM`: a feed as under G94.
    PerMinute,
    /// `PR`: a feed as under G95.
    PerTurn,
}

impl Mode {
    fn is_feed(self) -> bool {
        matches!(self, Mode::PerMinute | Mode::PerTurn)
    }

    fn of(name: &str) -> Option<Mode> {
        Some(match name {
            "AC" => Mode::Ac,
            "IC" => Mode::Ic,
            "DC" => Mode::Dc,
            "ACP" => Mode::Acp,
            "ACN" => Mode::Acn,
            "DAC" => Mode::Dac,
            "DIC" => Mode::Dic,
            "RAC" => Mode::Rac,
            "RIC" => Mode::Ric,
            "QU" => Mode::Quick,
            "PM" => Mode::PerMinute,
            "PR" => Mode::PerTurn,
            _ => return None,
        })
    }
}

/// Is the name one of AC, IC, DC and their kin?
pub(super) fn is_modifier(name: &str) -> bool {
    Mode::of(name).is_some()
}

/// A number with its place.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Given {
    pub value: f64,
    pub mode: Mode,
    pub span: Span,
}

/// An M word; `spindle` is its extension.
#[derive(Debug, Clone, Copy)]
pub(super) struct MWord {
    pub spindle: Option<u8>,
    pub number: u32,
    pub span: Span,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct SWord {
    pub spindle: Option<u8>,
    pub value: f64,
    pub span: Span,
}

/// A machine axis: `X1`.
#[derive(Debug, Clone, Copy)]
pub(super) struct MachineAxis {
    pub letter: u8,
    pub number: u32,
    pub span: Span,
}

/// A call of a program or procedure by name.
#[derive(Debug, Clone, Copy)]
pub(super) struct CallWord {
    pub name: Symbol,
    pub meaning: Meaning,
    /// `None` for a bare name.
    pub args: Option<Args>,
    pub span: Span,
}

/// A positioning axis: `POS[X]=`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Positioning {
    pub axis: Axis,
    pub given: Given,
}

/// Words that call a program.
#[derive(Debug, Default)]
pub(super) struct CallWords {
    pub word: Option<CallWord>,
    /// Subprogram number, as written.
    pub number: Option<(String, Span)>,
    pub passes: Option<Given>,
    /// The program after SETINT.
    pub interrupt: Option<Span>,
}

/// Words of axes that stand beside the path.
#[derive(Debug, Default)]
pub(super) struct BesideWords {
    /// Machine axes `X1=0`, in G74 and G75 only.
    pub machine: Vec<MachineAxis>,
    /// Words of axes that the target does not have.
    pub left_out: Vec<(NamedAxis, Span)>,
    pub positioning: Vec<Positioning>,
    /// Feed of positioning axes.
    pub feeds: Vec<(Axis, f64)>,
}

/// ADIS and CTOL, in the unit of the program.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct SmoothingWords {
    pub distance: Option<f64>,
    pub tolerance: Option<f64>,
}

impl SmoothingWords {
    pub fn is_given(self) -> bool {
        self.distance.is_some() || self.tolerance.is_some()
    }
}

/// The words of a block, sorted. Reused; what is stored for a word that is not given is never read.
#[derive(Debug)]
pub(super) struct Words {
    pub axes: AxisSet,
    axis_words: [Given; AXES],
    given: u64,
    addresses: Vec<Given>,
    pub codes: Vec<(GCode, Span)>,
    pub m: Vec<MWord>,
    pub s: Vec<SWord>,
    pub h: Option<Span>,
    /// F stands in the block.
    pub feed_given: bool,
    /// Tool by name.
    pub tool_name: Option<String>,
    pub calls: CallWords,
    pub beside: BesideWords,
    /// Words without any effect on the path.
    pub dynamics: Option<Span>,
    pub smoothing: SmoothingWords,
    pub diameter: Option<(Indexed, Axis, Span)>,
    /// D in the block of M6.
    pub edge_of_new_tool: Option<Given>,
    /// A word that measures while the block moves.
    pub probe: Option<ProbeWord>,
    /// An assignment, and a word that is none.
    assigned: Option<Span>,
    other: Option<Span>,
}

impl Words {
    pub fn new() -> Words {
        Words {
            axes: AxisSet::EMPTY,
            axis_words: [Given::default(); AXES],
            given: 0,
            addresses: vec![Given::default(); ADDRESSES],
            codes: Vec::new(),
            m: Vec::new(),
            s: Vec::new(),
            h: None,
            feed_given: false,
            tool_name: None,
            calls: CallWords::default(),
            beside: BesideWords::default(),
            dynamics: None,
            smoothing: SmoothingWords::default(),
            diameter: None,
            edge_of_new_tool: None,
            probe: None,
            assigned: None,
            other: None,
        }
    }

    pub fn clear(&mut self) {
        self.axes = AxisSet::EMPTY;
        self.given = 0;
        self.codes.clear();
        self.m.clear();
        self.s.clear();
        self.h = None;
        self.feed_given = false;
        self.tool_name = None;
        self.calls = CallWords::default();
        self.beside.machine.clear();
        self.beside.left_out.clear();
        self.beside.positioning.clear();
        self.beside.feeds.clear();
        self.dynamics = None;
        self.smoothing = SmoothingWords::default();
        self.diameter = None;
        self.edge_of_new_tool = None;
        self.probe = None;
        self.assigned = None;
        self.other = None;
    }

    #[inline]
    pub fn axis(&self, axis: Axis) -> Option<Given> {
        self.axes.contains(axis).then(|| self.axis_words[axis.index()])
    }

    #[inline]
    pub fn get(&self, address: Address) -> Option<Given> {
        (self.given & 1 << address as u64 != 0).then(|| self.addresses[address as usize])
    }

    /// Takes a word out, so that nobody finds it left over.
    pub fn take(&mut self, address: Address) -> Option<Given> {
        let found = self.get(address);
        self.given &= !(1 << address as u64);
        found
    }

    /// Addresses that nobody took.
    pub fn left(&self) -> Option<Given> {
        (self.given != 0).then(|| self.addresses[self.given.trailing_zeros() as usize])
    }

    /// A word of an axis besides its end point: a positioning axis, a machine axis, one that is left out.
    pub fn axis_word_left(&self) -> Option<Span> {
        let positioning = self.beside.positioning.first().map(|positioning| positioning.given.span);
        let left_out = self.beside.left_out.first().map(|(_, span)| *span);
        positioning.or(self.beside.machine.first().map(|axis| axis.span)).or(left_out)
    }

    pub fn has_addresses(&self) -> bool {
        self.given != 0
    }

    /// Code of a group, if the block has one.
    #[inline]
    pub fn code_of(&self, group: Group) -> Option<(GCode, Span)> {
        self.codes.iter().copied().find(|(code, _)| code.group == group)
    }

    /// Nothing but assignments and comments.
    pub fn is_empty(&self) -> bool {
        self.other.is_none()
    }
}

/// Addresses that mean a place; which of the modifiers they take is decided where they are used.
fn takes_modifiers(address: Address) -> bool {
    use Address::{Ap, Discl, Disrp, I, I1, J, J1, K, K1, Rp, Spos, Sposa};
    matches!(address, I | J | K | I1 | J1 | K1 | Ap | Rp | Spos | Sposa | Discl | Disrp)
}

impl Run<'_> {
    /// Sorts the words of `block`.
    pub(super) fn sort_words(&mut self, words: &mut Words, block: &Block, text: &[u8]) -> Outcome {
        for word in &block.words {
            let assigned = self.sort_word(words, word, block, text)?;
            let seen = if assigned { &mut words.assigned } else { &mut words.other };
            seen.get_or_insert(word.span);
        }
        if let (Some(assigned), Some(_)) = (words.assigned, words.other) {
            return self.channel.core.refuse(assigned, codes::S2014::assignment_stands_beside_other_words());
        }
        Ok(())
    }

    /// True for an assignment.
    #[inline]
    fn sort_word(&mut self, words: &mut Words, word: &Word, block: &Block, text: &[u8]) -> Outcome<bool> {
        match word.target {
            Target::Letter(letter) => {
                if matches!(word.value, Value::Formula(_)) && self.letter_variable(letter).is_some() {
                    self.assign_word(word, block, text)?;
                    return Ok(true);
                }
                self.letter_word(words, letter, word, block, text).map(|()| false)
            }
            Target::Numbered(letter, number, name) => {
                self.numbered_word(words, letter, number, name, word, block, text)
            }
            Target::Name(name) => self.name_word(words, name, word, block, text),
            Target::System(_) => {
                self.assign_word(word, block, text)?;
                Ok(true)
            }
            Target::Indexed(base, args) => self.indexed_word(words, base, args, word, block, text),
        }
    }

    /// A variable whose name is one letter.
    pub(super) fn letter_variable(&self, letter: u8) -> Option<super::vars::Slot> {
        let name = [letter];
        let name = std::str::from_utf8(&name).ok()?;
        self.vars.find(self.channel.core.symbols.find(name)?)
    }

    #[inline]
    fn letter_word(&mut self, words: &mut Words, letter: u8, word: &Word, block: &Block, text: &[u8]) -> Outcome {
        if letter == b'T'
            && let Value::Formula(formula) = word.value
        {
            return self.tool_word(words, formula, word.span, block, text);
        }
        let given = self.given(word, block, text)?;
        if given.mode != Mode::Plain && b"GSPHL".contains(&letter) {
            self.channel.core.no_modifier(given)?;
        }
        if letter == b'R' {
            return self.channel.core.refuse(word.span, codes::S2016::address_r_has_no_meaning());
        }
        if let Some(named) = self.channel.axis_names.letter(letter) {
            return words.add_axis(&self.channel.core, &mut self.channel.axis_names, named, given);
        }
        match letter {
            b'G' => self.g_word(words, given),
            b'M' => words.add_m(&self.channel.core, None, given),
            b'F' => words.set_address(&self.channel.core, Address::F, given),
            b'S' if words.s.iter().any(|s| s.spindle.is_none()) => {
                self.channel.core.refuse(given.span, codes::P1002::s_stands_twice_in_block())
            }
            b'S' => {
                words.s.push(SWord { spindle: None, value: given.value, span: given.span });
                Ok(())
            }
            b'T' => words.set_address(&self.channel.core, Address::T, given),
            b'D' => words.set_address(&self.channel.core, Address::D, given),
            b'I' => words.set_address(&self.channel.core, Address::I, given),
            b'J' => words.set_address(&self.channel.core, Address::J, given),
            b'K' => words.set_address(&self.channel.core, Address::K, given),
            b'H' => {
                words.h = Some(given.span);
                Ok(())
            }
            b'P' if words.calls.passes.is_some() => {
                self.channel.core.refuse(given.span, codes::P1002::p_stands_twice_in_block())
            }
            b'P' => {
                words.calls.passes = Some(given);
                Ok(())
            }
            b'L' => words.set_subprogram(&self.channel.core, word, given),
            _ => {
                let help = match letter {
                    b'E' => "an exponent is written EX: 1EX5 for 1e5; axes are X Y Z A B C U V W",
                    _ => "check the letter; axes are X Y Z A B C U V W",
                };
                self.channel.core.refuse(word.span, codes::S2016::address_is_not_known(&(letter as char)).help(help))
            }
        }
    }

    fn g_word(&mut self, words: &mut Words, given: Given) -> Outcome {
        match self.gcodes.get(given.value) {
            Some(code) => words.add_code(&self.channel.core, code, given.span),
            None => self
                .channel
                .core
                .refuse(given.span, codes::S2010::g_is_not_known(&given.value).help(in_place_of(given.value))),
        }
    }

    pub(super) fn tool_word(
        &mut self,
        words: &mut Words,
        formula: Formula,
        span: Span,
        block: &Block,
        text: &[u8],
    ) -> Outcome {
        match self.eval(formula, block, text)? {
            Val::Text(name) => {
                words.tool_name = Some(String::from_utf8_lossy(&name).into_owned());
                words.set_address(&self.channel.core, Address::T, Given { value: 0.0, mode: Mode::Plain, span })
            }
            value => {
                let value = self.channel.core.as_number(&value, formula.span)?;
                words.set_address(&self.channel.core, Address::T, Given { value, mode: Mode::Plain, span })
            }
        }
    }

    /// The number behind a word, with its modifier.
    #[inline]
    pub(super) fn given(&mut self, word: &Word, block: &Block, text: &[u8]) -> Outcome<Given> {
        match word.value {
            Value::Literal { value, .. } if value.is_finite() => {
                Ok(Given { value, mode: Mode::Plain, span: word.span })
            }
            Value::Literal { .. } => self.channel.core.refuse(word.span, codes::S2029::number_is_too_large()),
            Value::Formula(formula) => self.given_formula(formula, word.span, block, text),
            Value::None | Value::Call(_) => self.channel.core.refuse(word.span, codes::P1001::word_has_no_value()),
        }
    }

    pub(super) fn given_formula(&mut self, formula: Formula, span: Span, block: &Block, text: &[u8]) -> Outcome<Given> {
        if let [.., Op::Call(name, count, _)] = block.formula(formula)
            && let Some(mode) = Mode::of(self.channel.core.symbols.name(*name))
        {
            if *count != 1 {
                return self.channel.core.refuse(formula.span, codes::S2021::modifier_takes_one_value());
            }
            let inner = Formula { to: formula.to - 1, ..formula };
            let value = self.number(inner, block, text)?;
            return Ok(Given { value, mode, span });
        }
        let value = self.number(formula, block, text)?;
        Ok(Given { value, mode: Mode::Plain, span })
    }
}

impl Words {
    pub fn set_subprogram(&mut self, core: &Core<'_>, word: &Word, given: Given) -> Outcome {
        let Value::Literal { digits, whole: true, value } = word.value else {
            return core.refuse(word.span, codes::P1001::subprogram_number_is_written_in_digits());
        };
        if self.calls.number.is_some() {
            return core.refuse(given.span, codes::P1002::l_stands_twice_in_block());
        }
        let width = usize::from(digits);
        self.calls.number = Some((format!("L{value:0width$}"), given.span));
        Ok(())
    }

    pub fn set_axis(&mut self, core: &Core<'_>, axis: Axis, given: Given) -> Outcome {
        if self.axes.contains(axis) {
            return core.refuse(given.span, codes::P1002::axis_stands_twice_in_block(&axis.letter()));
        }
        if given.mode.is_feed() {
            return core.misplaced_modifier(given.span);
        }
        self.axes.insert(axis);
        self.axis_words[axis.index()] = given;
        Ok(())
    }

    pub fn set_address(&mut self, core: &Core<'_>, address: Address, given: Given) -> Outcome {
        let fits = if given.mode.is_feed() { address == Address::Fad } else { takes_modifiers(address) };
        if given.mode != Mode::Plain && !fits {
            core.no_modifier(given)?;
        }
        if self.given & 1 << address as u64 != 0 {
            return core.refuse(given.span, codes::P1002::address_stands_twice_in_block());
        }
        self.given |= 1 << address as u64;
        self.addresses[address as usize] = given;
        Ok(())
    }

    pub fn add_code(&mut self, core: &Core<'_>, code: GCode, span: Span) -> Outcome {
        if let Some((first, other)) = self.codes.iter().copied().find(|(known, _)| known.group == code.group) {
            if first == code {
                return Ok(());
            }
            if code.group.shapes_block() {
                return core.two_shapes(first, other, code, span);
            }
            let (a, b) = (first.word(), code.word());
            let found = codes::S2008::are_of_one_group(&a, &b).at(core.loc(span));
            core.report(
                found.also(core.loc(other), Label::OtherOne).help("delete one of them; the control takes the last"),
            );
            return Err(super::Reported);
        }
        self.codes.push((code, span));
        Ok(())
    }

    pub fn add_m(&mut self, core: &Core<'_>, spindle: Option<u8>, given: Given) -> Outcome {
        core.no_modifier(given)?;
        if given.value < 0.0 || given.value > 1e9 || given.value.fract() != 0.0 {
            return core.refuse(given.span, codes::P2007::m_is_no_m_function(&given.value));
        }
        let mut number = given.value as u32;
        // `M1=66` is a function of the spindle, whatever M66 is.
        if spindle.is_none() && core.job.settings.control.tool_change_m.contains(&number) {
            number = 6;
        }
        self.m.push(MWord { spindle, number, span: given.span });
        Ok(())
    }
}

impl Core<'_> {
    /// AC, IC and their kin stand where a place is meant.
    pub(super) fn no_modifier(&self, given: Given) -> Outcome {
        if matches!(given.mode, Mode::Plain | Mode::Quick) { Ok(()) } else { self.misplaced_modifier(given.span) }
    }

    #[cold]
    pub(super) fn misplaced_modifier(&self, span: Span) -> Outcome {
        self.refuse(span, codes::P1003::this_address_takes_no_such_modifier())
    }
}
