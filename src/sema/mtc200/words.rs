//! The words of a block, evaluated once and sorted by what they mean.

use crate::diag::{Answer, codes};
use crate::ir::Pos;
use crate::machine::Axis;
use crate::parser::mtc200::ast::{Block, Target, Value, Word};
use crate::parser::symbols::Symbol;
use crate::sema::run::refusal::{Made, refused};
use crate::text::{Span, decode::readable};

use super::eval::{Computing, Condition};
use super::g_functions::{self, G, GROUPS, Group, Motion};
use super::{Core, Outcome};

/// Longest time of G04, as written.
const MOST_DWELL: f64 = 1e6;

/// Most M functions and words of the machine of a block.
const MOST_M: usize = 8;

/// A value with its place.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct At {
    pub value: f64,
    pub span: Span,
}

/// A word of the program flow.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Flow {
    Return,
    ProgramEnd,
    StopAndBranch,
    Halt,
    Branch(Condition),
    Call,
    EndOfSubroutine,
    JumpProgram,
    CallProgram,
    Reverse,
}

impl Flow {
    /// Does a program number P belong to it?
    pub fn takes_program(self) -> bool {
        matches!(self, Flow::JumpProgram | Flow::CallProgram)
    }
}

/// A flow word with the label behind it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct FlowWord {
    pub flow: Flow,
    pub label: Option<Symbol>,
    pub span: Span,
}

/// A G function or a word that is none of the control's.
#[derive(Debug, Clone)]
pub(super) struct Strange {
    /// In capitals.
    pub name: String,
    pub span: Span,
    pub is_g: bool,
}

/// The evaluated words, in the unit of the program. Kept in a box that goes from block to block.
#[derive(Debug, Clone, Default)]
pub(super) struct Words {
    /// G functions by group.
    pub g: [Option<(G, u32)>; GROUPS],
    pub g_spans: [Span; GROUPS],
    pub axes: Pos,
    /// From the first axis word to the last.
    pub axes_span: Span,
    /// I, J, K.
    pub centre: [Option<f64>; 3],
    pub centre_span: Span,
    pub radius: Option<At>,
    pub feed: Option<At>,
    pub speed: Option<At>,
    pub tool: Option<At>,
    pub program: Option<At>,
    pub chamfer: Option<At>,
    pub rounding: Option<At>,
    pub flow: Option<FlowWord>,
    /// D, E, ACC: set once each, without effect.
    silent: [Option<At>; 3],
    m: Vec<(u32, Span)>,
    /// M functions printed for words of the machine.
    aux: Vec<(u32, Span)>,
    /// Words that only the machine builder knows.
    pub(super) strange: Vec<Strange>,
}

impl Words {
    pub fn clear(&mut self) {
        self.g = [None; GROUPS];
        self.axes.clear();
        (self.axes_span, self.centre_span) = (Span::default(), Span::default());
        self.centre = [None; 3];
        (self.radius, self.feed, self.speed, self.tool) = (None, None, None, None);
        (self.program, self.chamfer, self.rounding, self.flow) = (None, None, None, None);
        self.silent = [None; 3];
        self.m.clear();
        self.aux.clear();
        self.strange.clear();
    }

    pub(super) fn print_m(&mut self, number: u32, span: Span) {
        self.aux.push((number, span));
    }

    pub fn m(&self) -> &[(u32, Span)] {
        &self.m
    }

    /// D or E.
    pub(super) fn has_correction(&self) -> bool {
        self.silent[..2].iter().any(Option::is_some)
    }

    pub fn aux(&self) -> &[(u32, Span)] {
        &self.aux
    }

    pub fn has_centre(&self) -> bool {
        self.centre.iter().any(Option::is_some)
    }
}

/// Does the E of this word stand right behind the number of a coordinate or a feed?
fn is_exponent(span: Span, text: &[u8]) -> bool {
    let before = text.get(..span.start as usize).unwrap_or_default();
    let number = before.iter().rev().take_while(|b| b.is_ascii_digit() || **b == b'.').count();
    let rest = before.get(..before.len() - number).unwrap_or_default();
    let letter = rest.iter().rev().find(|b| !matches!(**b, b' ' | b'\t' | b'+' | b'-'));
    number > 0 && letter.is_some_and(|b| b"XYZUVWABCIJKRF".contains(&b.to_ascii_uppercase()))
}

impl At {
    /// The whole number of a word.
    #[inline]
    pub fn whole(self, letter: &str) -> Made<u32> {
        if (0.0..=1e6).contains(&self.value) && self.value.fract() == 0.0 {
            return Ok(self.value as u32);
        }
        refused(self.span, codes::M2401::takes_whole_number(&letter, &self.value))
    }
}

/// The axis of each letter: the first three have names of the machine builder's choice, the others their own.
#[derive(Debug)]
pub(super) struct AxisNames([Option<Axis>; 26]);

impl AxisNames {
    pub fn new(main: [Axis; 3]) -> AxisNames {
        let mut names = [None; 26];
        let slot = |axis: Axis| axis.letter() as usize - 'A' as usize;
        for axis in Axis::ALL.into_iter().filter(|axis| !axis.is_main()) {
            names[slot(axis)] = Some(axis);
        }
        for (meaning, name) in [Axis::X, Axis::Y, Axis::Z].into_iter().zip(main) {
            names[slot(name)] = Some(meaning);
        }
        AxisNames(names)
    }

    #[inline]
    fn of(&self, letter: u8) -> Option<Axis> {
        self.0[usize::from(letter.wrapping_sub(b'A')).min(25)]
    }
}

/// D or E: it chooses what else counts of the tool.
#[derive(Debug, Clone, Copy)]
pub(super) struct ToolData {
    pub letter: char,
    pub number: u32,
    pub at: At,
}

/// A block whose words are evaluated.
#[derive(Clone, Copy)]
pub(super) struct Written<'b> {
    pub block: &'b Block,
    pub text: &'b [u8],
    pub axes: &'b AxisNames,
}

impl Words {
    /// Takes in one word of a block. D and E come back: what they choose counts before the next word does.
    #[inline]
    pub fn sort_in(
        &mut self,
        word: &Word,
        written: Written<'_>,
        from: &mut Computing<'_, '_>,
    ) -> Outcome<Option<ToolData>> {
        let Target::Letter(letter) = word.target else { return self.sort_name(word, written, from).map(|()| None) };
        let value = from.number(word, written.block)?;
        let at = At { value, span: word.span };
        let seen = if let Some(axis) = written.axes.of(letter) {
            let seen = self.axes.get(axis).is_some();
            self.axes.set(axis, value);
            self.axes_span = if self.axes_span.is_empty() { word.span } else { self.axes_span.to(word.span) };
            seen
        } else {
            let slot = match letter {
                b'G' => return self.sort_g(at, from).map(|()| None),
                b'M' => return self.sort_m(at, from).map(|()| None),
                b'I' | b'J' | b'K' => {
                    let seen = self.centre[usize::from(letter - b'I')].replace(value).is_some();
                    self.centre_span =
                        if self.centre_span.is_empty() { word.span } else { self.centre_span.to(word.span) };
                    return from.core.unless_twice(seen, letter as char, word.span).map(|()| None);
                }
                b'F' => &mut self.feed,
                b'S' => &mut self.speed,
                b'R' => &mut self.radius,
                b'T' => &mut self.tool,
                b'P' => &mut self.program,
                b'E' if is_exponent(word.span, written.text) => {
                    return from.core.refuse(word.span, codes::M9002::e_behind_number_looks_like_exponent());
                }
                b'D' | b'E' => {
                    let number = from.core.made(at.whole(if letter == b'D' { "D" } else { "E" }))?;
                    return Ok(Some(ToolData { letter: letter as char, number, at }));
                }
                _ => {
                    self.machine_word(word.span, written.text);
                    return Ok(None);
                }
            };
            slot.replace(at).is_some()
        };
        from.core.unless_twice(seen, letter as char, word.span).map(|()| None)
    }

    /// Takes D or E in, once it has acted.
    pub fn take_in(&mut self, data: &ToolData, core: &Core<'_>) -> Outcome {
        let seen = self.silent[usize::from(data.letter == 'E')].replace(data.at).is_some();
        core.unless_twice(seen, data.letter, data.at.span)
    }

    #[inline]
    fn sort_g(&mut self, at: At, from: &mut Computing<'_, '_>) -> Outcome {
        let number = from.core.made(at.whole("G"))?;
        if matches!(number, 6..=9 | 47 | 48 | 61 | 62) && from.core.declares(self, &format!("G{number}"), at.span) {
            return Ok(());
        }
        let Some((group, g)) = g_functions::entry(number) else {
            self.unknown_g(number, at.span, from.core);
            return Ok(());
        };
        match self.g[group as usize] {
            Some((_, first)) if first != number => {
                from.core.refuse(at.span, codes::M1005::g_contradicts_g_of_same_block(&number, &first))
            }
            Some(_) => from.core.unless_twice(true, 'G', at.span),
            None => {
                self.g[group as usize] = Some((g, number));
                self.g_spans[group as usize] = at.span;
                Ok(())
            }
        }
    }

    #[cold]
    fn unknown_g(&mut self, number: u32, span: Span, core: &Core<'_>) {
        let name = format!("G{number}");
        match g_functions::refused(number) {
            Some(what) => {
                core.say(span, codes::P9011::is_not_supported_2(&name, &what).help(g_functions::instead(number)));
            }
            None => self.strange.push(Strange { name, span, is_g: true }),
        }
    }

    fn sort_m(&mut self, at: At, from: &mut Computing<'_, '_>) -> Outcome {
        let number = from.core.made(at.whole("M"))?;
        if !from.core.job.settings.control.mtc200.machine_words.is_empty()
            && from.core.declares(self, &format!("M{number}"), at.span)
        {
            return Ok(());
        }
        if self.m.iter().any(|(m, _)| *m == number) {
            return from.core.unless_twice(true, 'M', at.span);
        }
        if self.m.len() >= MOST_M {
            return from.core.refuse(at.span, codes::P1005::more_than_m_functions_in_one_block(&MOST_M));
        }
        self.m.push((number, at.span));
        Ok(())
    }

    /// Names, variables and everything rare.
    fn sort_name(&mut self, word: &Word, written: Written<'_>, from: &mut Computing<'_, '_>) -> Outcome {
        let symbol = match word.target {
            Target::Name(symbol) => symbol,
            Target::Variable(_) => {
                return from.core.refuse(word.span, codes::M1011::variable_is_assigned_in_block_with_other());
            }
            Target::Numbered(..) | Target::Letter(_) => {
                self.machine_word(word.span, written.text);
                return Ok(());
            }
        };
        let core = from.core;
        let has_value = !matches!(word.value, Value::None | Value::Label(_));
        match core.symbols.name(symbol) {
            name @ ("CF" | "RD") => {
                if !has_value {
                    return core.refuse(word.span, codes::M1003::has_no_value(&name));
                }
                let value = from.number(word, written.block)?;
                if self.chamfer.is_some() || self.rounding.is_some() {
                    return core.refuse(word.span, codes::P1002::one_corner_takes_one_cf_or_rd());
                }
                let slot = if name == "CF" { &mut self.chamfer } else { &mut self.rounding };
                *slot = Some(At { value, span: word.span });
            }
            "ACC" => {
                if !has_value {
                    return core.refuse(word.span, codes::M1003::acc_has_no_value());
                }
                let value = from.number(word, written.block)?;
                if self.silent[2].replace(At { value, span: word.span }).is_some() {
                    return core.refuse(word.span, codes::P1002::acc_stands_twice_in_this_block());
                }
                core.without_geometry("ACC", word.span);
            }
            name => match flow_word(name) {
                Some(flow) => return core.made(self.sort_flow(flow, word, written.text)),
                None if FOREIGN.contains(&name) => {
                    core.say(word.span, codes::M9003::depends_on_running_machine(&name));
                }
                None => self.machine_word(word.span, written.text),
            },
        }
        Ok(())
    }

    fn sort_flow(&mut self, flow: Flow, word: &Word, text: &[u8]) -> Made {
        let name = || readable(word.span.of(text)).into_owned();
        let label = match word.value {
            Value::None => None,
            Value::Label(label) => Some(label),
            Value::Literal(_) | Value::Formula(_) => {
                return refused(word.span, codes::P1001::takes_no_value(&name()));
            }
        };
        let wants = matches!(flow, Flow::StopAndBranch | Flow::Branch(_) | Flow::Call | Flow::Reverse);
        match label {
            None if wants => return refused(word.span, codes::P1004::names_no_label(&name())),
            Some(_) if !wants => return refused(word.span, codes::P1003::no_label_belongs(&name())),
            _ => {}
        }
        if self.flow.is_some() {
            return refused(word.span, codes::P1003::two_words_of_one_block_say());
        }
        self.flow = Some(FlowWord { flow, label, span: word.span });
        Ok(())
    }

    /// A word that only the machine builder knows.
    #[cold]
    fn machine_word(&mut self, span: Span, text: &[u8]) {
        let name = readable(span.of(text)).to_ascii_uppercase();
        self.strange.push(Strange { name, span, is_g: false });
    }

    /// Words of the path where nothing moves: no function takes R, and beside one that takes axis words none takes I, J and K.
    pub fn no_path_words(&self, beside: bool) -> Made {
        if beside && self.has_centre() {
            return refused(self.centre_span, codes::P1003::i_j_k_have_no_meaning());
        }
        match self.radius {
            Some(at) => refused(at.span, codes::P1003::r_has_no_meaning()),
            None => Ok(()),
        }
    }

    /// P belongs to a program, or is an angle that no output has.
    #[cold]
    pub fn check_p(&self, motion: Option<Motion>) -> Made {
        let (Some(at), None) = (self.program, self.flow.filter(|flow| flow.flow.takes_program())) else {
            return Ok(());
        };
        if self.g[Group::Once as usize].is_some() {
            return refused(at.span, codes::M9002::angle_p_of_offset_is_not_documented());
        }
        if motion == Some(Motion::Thread) && !self.axes.known().is_empty() {
            if at.value == 0.0 {
                return Ok(());
            }
            return refused(at.span, codes::M9002::start_angle_of_thread_has_no_word());
        }
        refused(at.span, codes::P1003::p_has_no_meaning())
    }

    /// The time of G04, which stands alone with its F.
    #[cold]
    pub fn dwell_time(&self) -> Made<At> {
        let span = self.g_spans[Group::Once as usize];
        let other_g = self.g.iter().filter(|g| g.is_some()).count() > 1;
        let other = [self.speed, self.tool, self.program, self.radius, self.chamfer, self.rounding];
        let other = other_g || other.iter().any(Option::is_some) || self.flow.is_some() || !self.m.is_empty();
        if other || self.has_centre() || !self.axes.known().is_empty() {
            return refused(span, codes::P1003::g04_stands_beside_other_words());
        }
        match self.feed {
            None => refused(span, codes::P1004::g04_needs_its_time()),
            Some(at) if !(0.0..=MOST_DWELL).contains(&at.value) => {
                refused(at.span, codes::M2705::dwell_time(&at.value))
            }
            Some(at) => Ok(at),
        }
    }
}

impl Core<'_> {
    /// A word that the block has already, unless the last one counts.
    #[inline]
    fn unless_twice(&self, seen: bool, letter: char, span: Span) -> Outcome {
        if !seen || self.job.settings.control.mtc200.last_word_counts {
            return Ok(());
        }
        self.refuse(
            span,
            codes::P1002::stands_twice_in_this_block(&letter)
                .answer(Answer::key("control", "repeated_words").one_of(&["\"last\""])),
        )
    }
}

/// Words of events, tool management and other processes.
const FOREIGN: &[&str] =
    &["BES", "BER", "BEV", "CEV", "BTE", "SE", "RE", "WES", "WER", "DP", "SP", "RP", "AP", "WP", "POK"];

/// Is it a word that says where the program goes on?
pub(super) fn is_of_flow(name: &str) -> bool {
    flow_word(name).is_some() || FOREIGN.contains(&name)
}

fn flow_word(name: &str) -> Option<Flow> {
    Some(match name {
        "RET" => Flow::Return,
        "PROGRAMMENDE" => Flow::ProgramEnd,
        "BST" => Flow::StopAndBranch,
        "HLT" => Flow::Halt,
        "BRA" => Flow::Branch(Condition::Always),
        "BEQ" => Flow::Branch(Condition::Zero),
        "BNE" => Flow::Branch(Condition::NotZero),
        "BPL" => Flow::Branch(Condition::NotNegative),
        "BMI" => Flow::Branch(Condition::Negative),
        "BSR" => Flow::Call,
        "RTS" => Flow::EndOfSubroutine,
        "JMP" => Flow::JumpProgram,
        "JSR" => Flow::CallProgram,
        "REV" => Flow::Reverse,
        _ => return None,
    })
}
