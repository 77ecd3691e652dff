//! SINUMERIK blocks for rules on source text.

use crate::parser::sinumerik::ast::{Base, Block, Jump, JumpTarget, Op, Stmt, Target, Value, When};
use crate::parser::symbols::{Symbol, Symbols};
use crate::sema::Job;
use crate::sema::run::survey::{Notes, Visitor, What};
use crate::sema::run::unexecuted::Passed;
use crate::sema::run::{Shown, Shows, survey_file};
use crate::text::{FileId, Span};

use rustc_hash::FxHashMap;

use super::dictionary;
use super::macros::Sinumerik;
use super::vocabulary::{Address, Meaning};

/// Leads `visitor` through a file.
pub fn survey(job: &Job<'_>, file: FileId, visitor: &mut dyn Visitor) {
    survey_file::<Sinumerik>(job, file, visitor);
}

impl Shows for Sinumerik {
    type Before = ();

    fn show(passed: &Passed<'_, Sinumerik>, symbols: &Symbols, _: &mut (), items: bool, notes: &mut Notes) -> Shown {
        let block = passed.block;
        notes.comments.extend(block.comment);
        if items {
            Noting { block, symbols, words: dictionary::words(), notes }.note();
        }
        Shown {
            number: block.number,
            skip: block.skip.is_some(),
            words: block.span,
            is_empty: block.stmt == Stmt::Empty && block.label.is_none() || block.stmt == Stmt::Header,
            is_bad: block.stmt == Stmt::Bad,
        }
    }
}

struct Noting<'n> {
    block: &'n Block,
    symbols: &'n Symbols,
    words: &'n FxHashMap<&'static str, Meaning>,
    notes: &'n mut Notes,
}

impl Noting<'_> {
    fn note(&mut self) {
        let block = self.block;
        if let Some(label) = block.label {
            let name = self.name(label);
            self.notes.add(What::Label(name), block.span);
        }
        match block.stmt {
            Stmt::Goto(jump) => {
                self.jump(jump);
                if !matches!(jump.target, JumpTarget::Start) {
                    self.notes.add(What::Leaves, block.span);
                }
            }
            Stmt::Repeat { from, to, .. } => [Some(from), to].into_iter().flatten().for_each(|label| self.uses(label)),
            Stmt::RepeatBlock { label, .. } => self.uses(label),
            Stmt::Call(crate::parser::sinumerik::ast::CallForm::Section { from, to, .. }) => {
                self.uses(from);
                self.uses(to);
                self.notes.add(What::Opaque, block.span);
            }
            Stmt::Call(_) | Stmt::Sync(_) | Stmt::Redef(_) => self.notes.add(What::Opaque, block.span),
            // A macro may stand for anything.
            Stmt::Define(_) => {
                self.notes.add(What::Opaque, block.span);
                self.notes.add(What::UsesUnknown, block.span);
            }
            Stmt::Proc(_) | Stmt::Header => self.notes.add(What::Begins, block.span),
            Stmt::For { variable, .. } => {
                self.target(variable, true, block.span);
                self.notes.add(What::Branches, block.span);
            }
            Stmt::If(_)
            | Stmt::Else
            | Stmt::EndIf
            | Stmt::While(_)
            | Stmt::EndWhile
            | Stmt::EndFor
            | Stmt::Loop
            | Stmt::EndLoop
            | Stmt::RepeatLoop
            | Stmt::Until(_) => self.notes.add(What::Branches, block.span),
            _ => {}
        }
        for arm in &block.arms {
            self.jump(arm.jump);
        }
        if block.arms.last().is_some_and(|arm| arm.when == When::Default) {
            self.notes.add(What::Leaves, block.span);
        }
        for variable in &block.variables {
            if let (Some(name), Stmt::Def { global: false, .. }) = (variable.name, block.stmt) {
                let name = self.name(name);
                self.notes.add(What::Writes(name), variable.span);
            }
        }
        self.words();
        self.formulas();
    }

    fn name(&self, symbol: Symbol) -> String {
        self.symbols.name(symbol).to_owned()
    }

    fn uses(&mut self, label: Symbol) {
        let name = self.name(label);
        self.notes.add(What::Uses(name), self.block.span);
    }

    fn jump(&mut self, jump: Jump) {
        match jump.target {
            JumpTarget::Label(label) => {
                let name = self.name(label);
                self.notes.add(What::Uses(name), jump.span);
            }
            // Numbers of blocks are labels, too.
            JumpTarget::Number(number) => self.notes.add(What::Uses(format!("N{number}")), jump.span),
            JumpTarget::Text(_) => self.notes.add(What::UsesUnknown, jump.span),
            JumpTarget::Start => {}
        }
    }

    fn words(&mut self) {
        for word in &self.block.words {
            let assigned = matches!(word.value, Value::Formula(_));
            match (word.target, word.value) {
                (Target::Letter(letter), Value::Literal { value, .. }) => {
                    self.notes.word(letter, value, word.span);
                    if letter == b'G' && matches!(value as i64, 110..=112) && value.fract() == 0.0 {
                        self.notes.add(What::Pole, word.span);
                    }
                    if letter == b'M' && matches!(value as i64, 2 | 17 | 30) && value.fract() == 0.0 {
                        self.notes.add(What::Ends, word.span);
                    }
                    // L is the name of a program.
                    if letter == b'L' {
                        self.notes.add(What::Opaque, word.span);
                    }
                }
                (Target::Name(name), value) => {
                    let text = self.name(name);
                    if value == Value::None && text == "RET" {
                        self.notes.add(What::Ends, word.span);
                    } else if matches!(text.as_str(), "EXECSTRING" | "EXTCALL" | "AXNAME") {
                        self.notes.add(What::Opaque, word.span);
                        self.notes.add(What::UsesUnknown, word.span);
                    }
                    if matches!(self.words.get(text.as_str()), Some(Meaning::Address(Address::Ap | Address::Rp))) {
                        self.notes.add(What::Polar, word.span);
                    }
                    match text.as_str() {
                        "DIAMOF" => self.notes.add(What::Radii(true), word.span),
                        "DIAMON" | "DIAM90" => self.notes.add(What::Radii(false), word.span),
                        _ => {}
                    }
                    if assigned {
                        // CR=, SPOS= and their kin are words, no variables.
                        if !self.words.contains_key(text.as_str()) {
                            self.notes.add(What::Writes(text), word.span);
                        }
                    } else if !text.starts_with("CYCLE") {
                        // A call, a word of the control, or a variable in a call.
                        self.notes.add(What::Reads(text), word.span);
                    }
                }
                (target, _) => self.target(target, assigned, word.span),
            }
        }
    }

    fn target(&mut self, target: Target, written: bool, span: Span) {
        let name = match target {
            Target::Numbered(letter, number, _) if written => format!("{}{number}", letter as char),
            Target::Name(name) | Target::Indexed(Base::Name(name), _) => self.name(name),
            Target::Indexed(Base::Letter(b'R'), _) => return self.notes.add(What::Opaque, span),
            _ => return,
        };
        self.notes.add(if written { What::Writes(name) } else { What::Reads(name) }, span);
    }

    fn formulas(&mut self) {
        for op in &self.block.ops {
            let (name, span) = match *op {
                Op::Name(name, span) | Op::Index(Base::Name(name), _, span) => (self.name(name), span),
                Op::R(number, span) => (format!("R{number}"), span),
                Op::Index(Base::Letter(b'R'), _, span) => {
                    self.notes.add(What::Opaque, span);
                    continue;
                }
                _ => continue,
            };
            self.notes.add(What::Reads(name), span);
        }
    }
}
