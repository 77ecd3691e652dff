//! Program flow: IF, WHILE, SWITCH. Branches that are not taken are read and passed.
//!
//! Source: T 13.3 (docs/sources.md). A CASE that is reached from the one before, which some languages allow, is refused.

use crate::diag::codes;
use crate::parser::turning::ast::{Block, Formula, Stmt};
use crate::sema::run::{Read, Where};
use crate::text::{Loc, Place};

use super::eval::Computing;
use super::{Core, Outcome, Parsed, Reported};

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

impl Computing<'_, '_> {
    /// An assignment or a block of a control structure.
    pub(super) fn flow_block(&mut self, block: &Block) -> Outcome {
        let top = self.core.level().frame.nests.last().map(|nest| nest.kind);
        match (block.stmt, top) {
            (Stmt::Assign(var, formula), _) => self.assign(var, block, formula),
            (Stmt::If(condition), _) => {
                let holds = self.condition(block, condition)? != 0.0;
                self.core.open_nest(NestKind::If)?;
                if holds { Ok(()) } else { self.core.pass(&[Stmt::Else, Stmt::EndIf], 0) }
            }
            (Stmt::Else, Some(NestKind::If)) => self.core.pass(&[Stmt::EndIf], 0),
            (Stmt::Else, _) => self.core.misplaced("ELSE", "IF"),
            (Stmt::EndIf, Some(NestKind::If | NestKind::Else)) => self.core.close(),
            (Stmt::EndIf, _) => self.core.misplaced("ENDIF", "IF"),
            (Stmt::While(condition), _) => {
                let place = Place { at: self.core.here.at, line: self.core.here.line };
                self.core.keep_whole()?;
                let holds = self.condition(block, condition)? != 0.0;
                self.core.open_nest(NestKind::While(place))?;
                if holds { Ok(()) } else { self.core.pass(&[Stmt::EndWhile], 0) }
            }
            (Stmt::EndWhile, Some(NestKind::While(place))) => {
                self.core.close()?;
                self.core.jump_to(place)
            }
            (Stmt::EndWhile, _) => self.core.misplaced("ENDWHILE", "WHILE"),
            (Stmt::Switch(value), _) => self.switch_block(block, value),
            (Stmt::Case(_) | Stmt::Default, Some(NestKind::Switch)) => {
                self.core.say_here(codes::T2020::branch_before_has_no_break());
                self.core.pass(&[Stmt::EndSwitch], 0)
            }
            (Stmt::Case(_) | Stmt::Default, _) => self.core.misplaced("CASE", "SWITCH"),
            (Stmt::Break, _) => self.core.break_block(),
            (Stmt::EndSwitch, Some(NestKind::Switch)) => self.core.close(),
            (Stmt::EndSwitch, _) => self.core.misplaced("ENDSWITCH", "SWITCH"),
            _ => Ok(()),
        }
    }

    /// A condition; if it cannot be computed, nobody knows which blocks run.
    fn condition(&mut self, block: &Block, formula: Formula) -> Outcome<f64> {
        let value = self.formula(block, formula);
        if value.is_err() {
            self.core.stop_run();
        }
        value
    }

    /// Goes to the branch of this value, or to DEFAULT.
    fn switch_block(&mut self, block: &Block, value: Formula) -> Outcome {
        let value = self.condition(block, value)?;
        self.core.open_nest(NestKind::Switch)?;
        self.core.keep_whole()?;
        let from = self.core.here.origin.loc;
        let mut default = None;
        let mut depth = 0;
        loop {
            let parsed = self.core.next_passed(from)?;
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
            None => self.core.close(),
        }
    }
}

impl Core<'_> {
    fn close(&mut self) -> Outcome {
        self.level().frame.nests.pop();
        Ok(())
    }

    fn open_nest(&mut self, kind: NestKind) -> Outcome {
        let loc = self.here.origin.loc;
        let nests = &mut self.level().frame.nests;
        nests.push(Nest { kind, loc });
        if nests.len() <= DEEPEST {
            return Ok(());
        }
        self.stop_run();
        self.refuse(Where::Block, codes::T1009::structures_are_nested_deeper_than_levels(&DEEPEST))
    }

    fn misplaced(&self, what: &str, needs: &str) -> Outcome {
        self.stop_run();
        self.refuse(Where::Block, codes::T1009::stands_outside(&what, &needs))
    }

    /// Blocks of the file may run again.
    fn keep_whole(&mut self) -> Outcome {
        let sources = self.job.sources;
        if self.program().source.cursor.load(sources).is_ok() {
            return Ok(());
        }
        self.stop_run();
        self.refuse(Where::Block, codes::P0105::file_cannot_be_read_2())
    }

    fn break_block(&mut self) -> Outcome {
        let nests = &mut self.level().frame.nests;
        let inner = nests.iter().rev().take_while(|nest| matches!(nest.kind, NestKind::If | NestKind::Else)).count();
        let at = nests.len() - inner;
        if at == 0 || nests[at - 1].kind != NestKind::Switch {
            return self.misplaced("BREAK", "SWITCH");
        }
        nests.truncate(at);
        self.pass(&[Stmt::EndSwitch], inner)
    }

    /// Passes blocks up to one of `ends`, inside of which `depth` structures are open.
    fn pass(&mut self, ends: &[Stmt], mut depth: usize) -> Outcome {
        let from = self.here.origin.loc;
        loop {
            let stmt = self.next_passed(from)?.block.stmt;
            if depth == 0 && ends.contains(&stmt) {
                if stmt == Stmt::Else {
                    if let Some(nest) = self.level().frame.nests.last_mut() {
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
        if !self.has_steps_at(from) {
            return Err(Reported);
        }
        let mut parsed = Parsed::default();
        match self.pass_block(&mut parsed) {
            Read::Block(_) | Read::TooLong => {}
            Read::End | Read::Broken => return self.unclosed(from),
        }
        match parsed.block.stmt {
            Stmt::Section(..) => self.unclosed(from),
            _ => Ok(parsed),
        }
    }

    fn unclosed<T>(&self, from: Loc) -> Outcome<T> {
        self.stop(codes::T1009::this_structure_is_not_closed().at(from))
    }
}
