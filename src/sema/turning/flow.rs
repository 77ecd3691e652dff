//! Program flow: IF, WHILE, SWITCH. Branches that are not taken are read and passed.
//!
//! Source: T 13.3 (docs/sources.md). A CASE that is reached from the one before, which some languages allow, is refused.

use crate::diag::codes;
use crate::parser::turning::ast::{Block, Formula, Stmt};
use crate::sema::run::Read;
use crate::text::{Loc, Place};

use super::program_parts::ProgramPart;
use super::{Outcome, Parsed, Reported, Run};

/// Deepest nesting of structures.
const DEEPEST: usize = 100;

/// An open structure.
#[derive(Debug, Clone, Copy)]
pub(super) struct Nest {
    pub kind: NestKind,
    pub loc: Loc,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum NestKind {
    If,
    /// Its ELSE was met.
    Else,
    /// Where its condition stands.
    While(Place),
    Switch,
}

impl Run<'_> {
    /// An assignment or a block of a control structure.
    pub(super) fn flow_block(&mut self, block: &Block) -> Outcome {
        self.settle_chain()?;
        if !matches!(self.sections.part, ProgramPart::Start | ProgramPart::Machining) || self.capture.is_some() {
            return self.core.refuse(block.span, codes::T1008::variables_program_flow_belong_into_section_machining());
        }
        self.sections.settle_family();
        self.core.level().frame.begun = true;
        match block.stmt {
            Stmt::Assign(var, formula) => self.assign(var, block, formula),
            Stmt::If(condition) => self.if_block(block, condition),
            Stmt::Else => match self.top() {
                Some(NestKind::If) => self.pass(&[Stmt::EndIf], 0),
                _ => self.misplaced("ELSE", "IF"),
            },
            Stmt::EndIf => match self.top() {
                Some(NestKind::If | NestKind::Else) => self.close(),
                _ => self.misplaced("ENDIF", "IF"),
            },
            Stmt::While(condition) => self.while_block(block, condition),
            Stmt::EndWhile => match self.top() {
                Some(NestKind::While(place)) => {
                    self.close()?;
                    self.core.jump_to(place)
                }
                _ => self.misplaced("ENDWHILE", "WHILE"),
            },
            Stmt::Switch(value) => self.switch_block(block, value),
            Stmt::Case(_) | Stmt::Default => match self.top() {
                Some(NestKind::Switch) => {
                    self.core.report(codes::T2020::branch_before_has_no_break().at(self.core.here.origin.loc));
                    self.pass(&[Stmt::EndSwitch], 0)
                }
                _ => self.misplaced("CASE", "SWITCH"),
            },
            Stmt::Break => self.break_block(),
            Stmt::EndSwitch => match self.top() {
                Some(NestKind::Switch) => self.close(),
                _ => self.misplaced("ENDSWITCH", "SWITCH"),
            },
            _ => Ok(()),
        }
    }

    fn top(&mut self) -> Option<NestKind> {
        self.core.level().frame.nests.last().map(|nest| nest.kind)
    }

    fn close(&mut self) -> Outcome {
        self.core.level().frame.nests.pop();
        Ok(())
    }

    fn open_nest(&mut self, kind: NestKind) -> Outcome {
        let loc = self.core.here.origin.loc;
        let nests = &mut self.core.level().frame.nests;
        nests.push(Nest { kind, loc });
        if nests.len() <= DEEPEST {
            return Ok(());
        }
        self.core.stop_run();
        self.core.refuse(self.core.block_span(), codes::T1009::structures_are_nested_deeper_than_levels(&DEEPEST))
    }

    fn misplaced(&mut self, what: &str, needs: &str) -> Outcome {
        self.core.stop_run();
        self.core.refuse(self.core.block_span(), codes::T1009::stands_outside(&what, &needs))
    }

    /// A condition; if it cannot be computed, nobody knows which blocks run.
    fn condition(&mut self, block: &Block, formula: Formula) -> Outcome<f64> {
        let value = self.formula(block, formula);
        if value.is_err() {
            self.core.stop_run();
        }
        value
    }

    fn if_block(&mut self, block: &Block, condition: Formula) -> Outcome {
        let holds = self.condition(block, condition)? != 0.0;
        self.open_nest(NestKind::If)?;
        if holds {
            return Ok(());
        }
        self.pass(&[Stmt::Else, Stmt::EndIf], 0)
    }

    fn while_block(&mut self, block: &Block, condition: Formula) -> Outcome {
        let place = Place { at: self.core.here.at, line: self.core.here.line };
        let sources = self.core.job.sources;
        if self.core.program().source.cursor.load(sources).is_err() {
            self.core.stop_run();
            return self.core.refuse(self.core.block_span(), codes::P0105::file_cannot_be_read_2());
        }
        let holds = self.condition(block, condition)? != 0.0;
        self.open_nest(NestKind::While(place))?;
        if holds {
            return Ok(());
        }
        self.pass(&[Stmt::EndWhile], 0)
    }

    /// Goes to the branch of this value, or to DEFAULT.
    fn switch_block(&mut self, block: &Block, value: Formula) -> Outcome {
        let value = self.condition(block, value)?;
        self.open_nest(NestKind::Switch)?;
        let sources = self.core.job.sources;
        if self.core.program().source.cursor.load(sources).is_err() {
            self.core.stop_run();
            return self.core.refuse(self.core.block_span(), codes::P0105::file_cannot_be_read_2());
        }
        let here = self.core.here;
        let mut default = None;
        let mut depth = 0;
        loop {
            let parsed = self.next_passed(here.origin.loc)?;
            match parsed.block.stmt {
                Stmt::If(_) | Stmt::While(_) | Stmt::Switch(_) => depth += 1,
                Stmt::EndIf | Stmt::EndWhile | Stmt::EndSwitch if depth > 0 => depth -= 1,
                Stmt::Case(case) if depth == 0 && self.condition(&parsed.block, case)? == value => return Ok(()),
                Stmt::Default if depth == 0 => default = Some(self.core.program().source.cursor.place()),
                Stmt::EndSwitch => break,
                _ => {}
            }
        }
        match default {
            Some(place) => self.core.seek(place),
            None => self.close(),
        }
    }

    fn break_block(&mut self) -> Outcome {
        let nests = &self.core.level().frame.nests;
        let inner = nests.iter().rev().take_while(|nest| matches!(nest.kind, NestKind::If | NestKind::Else)).count();
        let at = nests.len() - inner;
        if at == 0 || nests[at - 1].kind != NestKind::Switch {
            return self.misplaced("BREAK", "SWITCH");
        }
        self.core.level().frame.nests.truncate(at);
        self.pass(&[Stmt::EndSwitch], inner)
    }

    /// Passes blocks up to one of `ends`, inside of which `depth` structures are open.
    fn pass(&mut self, ends: &[Stmt], mut depth: usize) -> Outcome {
        let from = self.core.here.origin.loc;
        loop {
            let parsed = self.next_passed(from)?;
            let stmt = parsed.block.stmt;
            if depth == 0 && ends.contains(&stmt) {
                if stmt == Stmt::Else {
                    if let Some(nest) = self.core.level().frame.nests.last_mut() {
                        nest.kind = NestKind::Else;
                    }
                    return Ok(());
                }
                return self.close();
            }
            match stmt {
                Stmt::If(_) | Stmt::While(_) | Stmt::Switch(_) => depth += 1,
                Stmt::EndIf | Stmt::EndWhile | Stmt::EndSwitch => match depth.checked_sub(1) {
                    Some(less) => depth = less,
                    None => return self.unclosed(from),
                },
                _ => {}
            }
        }
    }

    /// The next block of a branch that is passed; what is wrong with it does not matter here.
    fn next_passed(&mut self, from: Loc) -> Outcome<Parsed<Block>> {
        if !self.core.has_steps_at(from) {
            return Err(Reported);
        }
        let mut parsed = Parsed::default();
        match self.core.pass_block(&mut parsed) {
            Read::Block(_) | Read::TooLong => {}
            Read::End | Read::Broken => return self.unclosed(from),
        }
        match parsed.block.stmt {
            Stmt::Section(..) => self.unclosed(from),
            _ => Ok(parsed),
        }
    }

    fn unclosed<T>(&mut self, from: Loc) -> Outcome<T> {
        self.core.stop(codes::T1009::this_structure_is_not_closed().at(from))
    }
}
