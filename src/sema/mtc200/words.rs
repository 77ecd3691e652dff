//! The words of a block, evaluated once and sorted by what they mean.

use crate::diag::{Answer, codes};
use crate::ir::Pos;
use crate::machine::Axis;
use crate::parser::mtc200::ast::{Block, Target, Value, Word};
use crate::parser::symbols::Symbol;
use crate::text::{Span, decode::readable};

use super::g_functions::{self, G, GROUPS};
use super::{Outcome, Run};

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

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Condition {
    Always,
    Zero,
    NotZero,
    NotNegative,
    Negative,
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
    fn clear(&mut self) {
        self.g = [None; GROUPS];
        self.axes.clear();
        self.axes_span = Span::default();
        self.centre = [None; 3];
        self.centre_span = Span::default();
        self.radius = None;
        self.feed = None;
        self.speed = None;
        self.tool = None;
        self.program = None;
        self.chamfer = None;
        self.rounding = None;
        self.flow = None;
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

impl Run<'_> {
    /// Evaluates the words of a block.
    pub(super) fn gather(&mut self, block: &Block, text: &[u8]) -> Outcome<Box<Words>> {
        let mut w = self.words.take().unwrap_or_default();
        w.clear();
        let sorted = block.words.iter().try_for_each(|word| self.sort_in(&mut w, word, block, text));
        if !w.strange.is_empty() {
            self.settle_strange(&mut w);
        }
        sorted.map(|()| w)
    }

    #[inline]
    fn sort_in(&mut self, w: &mut Words, word: &Word, block: &Block, text: &[u8]) -> Outcome {
        let Target::Letter(letter) = word.target else { return self.sort_name(w, word, block, text) };
        let value = self.number(word, block)?;
        if let Some(axis) = self.axis_of(letter) {
            if w.axes.get(axis).is_some() {
                self.twice(letter as char, word.span)?;
            }
            w.axes.set(axis, value);
            w.axes_span = if w.axes_span.is_empty() { word.span } else { w.axes_span.to(word.span) };
            return Ok(());
        }
        let at = At { value, span: word.span };
        let slot = match letter {
            b'G' => return self.sort_g(w, at),
            b'M' => return self.sort_m(w, at),
            b'I' | b'J' | b'K' => {
                let slot = &mut w.centre[usize::from(letter - b'I')];
                w.centre_span = if w.centre_span.is_empty() { word.span } else { w.centre_span.to(word.span) };
                if slot.replace(value).is_some() {
                    self.twice(letter as char, word.span)?;
                }
                return Ok(());
            }
            b'F' => &mut w.feed,
            b'S' => &mut w.speed,
            b'R' => &mut w.radius,
            b'T' => &mut w.tool,
            b'P' => &mut w.program,
            b'E' if is_exponent(word.span, text) => {
                return self.core.refuse(word.span, codes::M9002::e_behind_number_looks_like_exponent());
            }
            b'D' | b'E' => {
                let number = self.whole(at, if letter == b'D' { "D" } else { "E" })?;
                if !self.counts_in_length(letter as char, number, word.span) {
                    self.without_geometry(if letter == b'D' { "D" } else { "E" }, word.span);
                }
                self.tool_data_word(letter, number, word.span)?;
                &mut w.silent[usize::from(letter - b'D')]
            }
            _ => return self.machine_word(w, word.span, text),
        };
        if slot.replace(at).is_some() {
            self.twice(letter as char, word.span)?;
        }
        Ok(())
    }

    /// The axis that a letter names.
    #[inline]
    fn axis_of(&self, letter: u8) -> Option<Axis> {
        self.axis_names[usize::from(letter.wrapping_sub(b'A')).min(25)]
    }

    #[cold]
    fn twice(&mut self, letter: char, span: Span) -> Outcome {
        if self.core.job.settings.control.mtc200.last_word_counts {
            return Ok(());
        }
        self.core.refuse(
            span,
            codes::P1002::stands_twice_in_this_block(&letter)
                .answer(Answer::key("control", "repeated_words").one_of(&["\"last\""])),
        )
    }

    #[inline]
    fn sort_g(&mut self, w: &mut Words, at: At) -> Outcome {
        let number = self.whole(at, "G")?;
        if matches!(number, 6..=9 | 47 | 48 | 61 | 62) && self.declared(w, &format!("G{number}"), at.span) {
            return Ok(());
        }
        let Some((group, g)) = g_functions::entry(number) else { return self.unknown_g(w, number, at.span) };
        let slot = &mut w.g[group as usize];
        match slot {
            Some((_, first)) if *first != number => {
                let first = *first;
                self.core.refuse(at.span, codes::M1005::g_contradicts_g_of_same_block(&number, &first))
            }
            Some(_) => self.twice('G', at.span),
            None => {
                *slot = Some((g, number));
                w.g_spans[group as usize] = at.span;
                Ok(())
            }
        }
    }

    #[cold]
    fn unknown_g(&mut self, w: &mut Words, number: u32, span: Span) -> Outcome {
        let name = format!("G{number}");
        if let Some(what) = g_functions::refused(number) {
            let help = g_functions::instead(number);
            self.core.report(codes::P9011::is_not_supported_2(&name, &what).at(self.core.loc(span)).help(help));
            return Ok(());
        }
        w.strange.push(Strange { name, span, is_g: true });
        Ok(())
    }

    fn sort_m(&mut self, w: &mut Words, at: At) -> Outcome {
        let number = self.whole(at, "M")?;
        if !self.core.job.settings.control.mtc200.machine_words.is_empty()
            && self.declared(w, &format!("M{number}"), at.span)
        {
            return Ok(());
        }
        if w.m.iter().any(|(m, _)| *m == number) {
            return self.twice('M', at.span);
        }
        if w.m.len() >= MOST_M {
            return self.core.refuse(at.span, codes::P1005::more_than_m_functions_in_one_block(&MOST_M));
        }
        w.m.push((number, at.span));
        Ok(())
    }

    /// Names, variables and everything rare.
    fn sort_name(&mut self, w: &mut Words, word: &Word, block: &Block, text: &[u8]) -> Outcome {
        let symbol = match word.target {
            Target::Name(symbol) => symbol,
            Target::Variable(_) => {
                return self.core.refuse(word.span, codes::M1011::variable_is_assigned_in_block_with_other());
            }
            Target::Numbered(..) | Target::Letter(_) => return self.machine_word(w, word.span, text),
        };
        let name = self.core.symbols.name(symbol).to_owned();
        match name.as_str() {
            "CF" => self.corner_word(|w| &mut w.chamfer, w, word, block, "CF"),
            "RD" => self.corner_word(|w| &mut w.rounding, w, word, block, "RD"),
            "ACC" => {
                if matches!(word.value, Value::None | Value::Label(_)) {
                    return self.core.refuse(word.span, codes::M1003::acc_has_no_value());
                }
                let value = self.number(word, block)?;
                if w.silent[2].replace(At { value, span: word.span }).is_some() {
                    return self.core.refuse(word.span, codes::P1002::acc_stands_twice_in_this_block());
                }
                self.without_geometry("ACC", word.span);
                Ok(())
            }
            name => match flow_word(name) {
                Some(flow) => self.sort_flow(w, flow, word, text),
                None if FOREIGN.contains(&name) => {
                    self.core.report(codes::M9003::depends_on_running_machine(&name).at(self.core.loc(word.span)));
                    Ok(())
                }
                None => self.machine_word(w, word.span, text),
            },
        }
    }

    fn corner_word(
        &mut self,
        slot: fn(&mut Words) -> &mut Option<At>,
        w: &mut Words,
        word: &Word,
        block: &Block,
        name: &str,
    ) -> Outcome {
        if matches!(word.value, Value::None | Value::Label(_)) {
            return self.core.refuse(word.span, codes::M1003::has_no_value(&name));
        }
        let value = self.number(word, block)?;
        if w.chamfer.is_some() || w.rounding.is_some() {
            return self.core.refuse(word.span, codes::P1002::one_corner_takes_one_cf_or_rd());
        }
        *slot(w) = Some(At { value, span: word.span });
        Ok(())
    }

    fn sort_flow(&mut self, w: &mut Words, flow: Flow, word: &Word, text: &[u8]) -> Outcome {
        let label = match word.value {
            Value::None => None,
            Value::Label(label) => Some(label),
            Value::Literal(_) | Value::Formula(_) => {
                let name = readable(word.span.of(text)).into_owned();
                return self.core.refuse(word.span, codes::P1001::takes_no_value(&name));
            }
        };
        let wants = matches!(flow, Flow::StopAndBranch | Flow::Branch(_) | Flow::Call | Flow::Reverse);
        if wants != label.is_some() {
            let name = readable(word.span.of(text)).into_owned();
            return match label {
                None => self.core.refuse(word.span, codes::P1004::names_no_label(&name)),
                Some(_) => self.core.refuse(word.span, codes::P1003::no_label_belongs(&name)),
            };
        }
        if w.flow.is_some() {
            return self.core.refuse(word.span, codes::P1003::two_words_of_one_block_say());
        }
        w.flow = Some(FlowWord { flow, label, span: word.span });
        Ok(())
    }

    /// A word that only the machine builder knows.
    #[cold]
    fn machine_word(&mut self, w: &mut Words, span: Span, text: &[u8]) -> Outcome {
        let name = readable(span.of(text)).to_ascii_uppercase();
        w.strange.push(Strange { name, span, is_g: false });
        Ok(())
    }

    /// A word of the control that no path depends on: noted once.
    pub(super) fn without_geometry(&mut self, name: &str, span: Span) {
        if self.noted.contains(name) {
            return;
        }
        self.noted.insert(name.to_owned());
        self.core.report(codes::M2703::does_not_change_programmed_path(&name).at(self.core.loc(span)));
    }

    /// The whole number of a word.
    #[inline]
    pub(super) fn whole(&mut self, at: At, letter: &str) -> Outcome<u32> {
        if (0.0..=1e6).contains(&at.value) && at.value.fract() == 0.0 {
            return Ok(at.value as u32);
        }
        self.core.refuse(at.span, codes::M2401::takes_whole_number(&letter, &at.value))
    }

    pub(super) fn put_back(&mut self, w: Box<Words>) {
        self.words = Some(w);
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
