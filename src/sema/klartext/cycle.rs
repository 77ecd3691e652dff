//! Cycles: the definition under way, and the one that calls run.
//!
//! Source: K 4.4 and 4.5 (docs/sources.md).

use std::collections::BTreeMap;
use std::rc::Rc;

use crate::diag::{Label, codes};
use crate::lexer::klartext::QRef;
use crate::machine::AxisSet;
use crate::parser::klartext::ast::{Block, Stmt};
use crate::sema::run::Where;
use crate::text::{FileId, Loc, Span};

use super::cycle_definition::Open;
use super::cycles::DefinedCycle;
use super::cycles::call::Calling;
use super::cycles::contours::ROUGH_OUT;
use super::cycles::{CycleKind, find};
use super::known::Known;
use super::m_table::{When, entry};
use super::words::MWord;
use super::{Core, Outcome, Reported, Run};

/// What is known of cycles: the definition under way and the one that calls run.
#[derive(Debug, Default)]
pub(super) struct Cycles {
    open: Option<Open>,
    defined: Option<Defined>,
    /// M89: every positioning block calls the cycle.
    modal: bool,
    /// Definitions of cycles that are not supported, by place.
    unsupported: BTreeMap<(FileId, u32, u32), Unsupported>,
}

/// A definition of a cycle that is not supported.
#[derive(Debug)]
struct Unsupported {
    number: u32,
    loc: Loc,
    called: bool,
}

/// What CYCL CALL, M99 and M89 run.
#[derive(Debug, Clone)]
pub(super) enum Defined {
    Program {
        name: String,
    },
    Machining {
        cycle: Rc<DefinedCycle>,
        refused: bool,
    },
    /// The definition was refused, which was reported.
    Refused,
}

impl Cycles {
    pub fn is_open(&self) -> bool {
        self.open.is_some()
    }

    pub fn modal(&self) -> bool {
        self.modal
    }

    pub fn set_modal(&mut self, on: bool) {
        self.modal = on;
    }

    /// A definition begins.
    pub fn begin(&mut self, open: Open) {
        self.open = Some(open);
    }

    /// The definition that was open is complete.
    pub fn complete(&mut self) -> Option<Open> {
        self.open.take()
    }

    /// The definition under way.
    pub fn open(&mut self) -> Option<&mut Open> {
        self.open.as_mut()
    }

    /// Does the block go on with the definition that is open?
    pub fn goes_on(&self, block: &Block) -> bool {
        let Some(open) = &self.open else { return false };
        match block.stmt {
            Stmt::Cycle { number, part: Some(part) } => number == open.number && part > 0 && open.part.is_some(),
            // A line of parameters without a continuation mark in front of it.
            Stmt::Assign(q) => block.number.is_none() && open.part.is_none() && find(open.number).takes(open.number, q),
            _ => false,
        }
    }

    /// A formula block turned out to be a line of the open definition.
    pub fn note_parameter(&mut self, core: &Core<'_>, q: QRef, value: f64, span: Span) -> Outcome {
        let Some(open) = &mut self.open else { return Ok(()) };
        if open.part.is_some() || !find(open.number).takes(open.number, q) {
            return Ok(());
        }
        // Behind a definition that `~` holds together, such a line is a block that changes the cycle.
        if !open.parameters.iter().any(|(number, _)| *number == q.number) {
            open.loose = true;
            open.parameters.push((q.number, value));
        } else if open.loose {
            open.failed = true;
            return core.refuse(span, codes::P1002::sets_second_time_so_remove_one(&core.word_text(span), &q));
        }
        Ok(())
    }

    /// The program that calls run.
    pub fn program(&self) -> Option<String> {
        match &self.defined {
            Some(Defined::Program { name }) => Some(name.clone()),
            _ => None,
        }
    }

    pub fn define(&mut self, defined: Defined) {
        self.defined = Some(defined);
        self.modal = false;
    }

    /// A machining cycle, which calls run.
    pub fn define_machining(&mut self, core: &Core<'_>, cycle: DefinedCycle) -> Outcome {
        cycle.check(core)?;
        if matches!(cycle.row().nature, CycleKind::Machining) {
            self.defines_unsupported(cycle.number, cycle.loc, false);
        }
        self.define(Defined::Machining { cycle: Rc::new(cycle), refused: false });
        Ok(())
    }

    /// Says of definitions that nothing used that their cycles are not supported.
    pub fn note_uncalled(&mut self, core: &Core<'_>) {
        let all = std::mem::take(&mut self.unsupported);
        for Unsupported { number, loc, .. } in all.into_values().filter(|cycle| !cycle.called) {
            let row = find(number);
            let what = if matches!(row.nature, CycleKind::Data) {
                "is defined for cycles that are not supported, and none of them is called"
            } else {
                "is defined and never called; it is not supported"
            };
            core.report(codes::K2412::cycle(&number, &row.called(), &what).at(loc));
        }
    }

    /// A cycle that is not supported is defined there, and perhaps called.
    pub fn defines_unsupported(&mut self, number: u32, loc: Loc, called: bool) {
        let place = (loc.file, loc.line, loc.span.start);
        self.unsupported.entry(place).or_insert(Unsupported { number, loc, called }).called |= called;
    }
}

impl Run<'_> {
    /// The machining cycle that a pattern runs.
    pub(super) fn pattern_subject(&mut self, by: &str) -> Outcome<Rc<DefinedCycle>> {
        match &self.cycles.defined {
            Some(Defined::Refused) => Err(Reported),
            Some(Defined::Machining { cycle, .. }) if cycle.row().nature.runs() => Ok(Rc::clone(cycle)),
            Some(Defined::Machining { .. }) => {
                self.call_cycle(by)?;
                Err(Reported)
            }
            Some(Defined::Program { name }) => {
                self.core.refuse(Where::Block, codes::P9010::with_program_of_cycle_12_is_not(&by, &name))
            }
            None => self.core.refuse(Where::Block, codes::K2401::runs_machining_cycle(&by)),
        }
    }

    /// Runs the cycle defined last, and after it what acts at the end of the block.
    pub(super) fn call_cycle_then(&mut self, by: &str, functions: &[MWord]) -> Outcome {
        let wait = functions.iter().any(|m| matches!(entry(m.number), Some((_, When::End))));
        match self.cycles.program() {
            Some(name) if wait => self.run_whole(&name)?,
            _ => self.call_cycle(by)?,
        }
        self.m_at_end(functions)
    }

    /// Runs the cycle defined last.
    pub(super) fn call_cycle(&mut self, by: &str) -> Outcome {
        let here = self.core.here.origin.loc;
        match &mut self.cycles.defined {
            None => self.core.refuse(Where::Block, codes::K2401::calls_cycle(&by)),
            Some(Defined::Refused) => {
                self.st.lose_all(&mut self.core);
                // It may have been a cycle 22.
                self.contours.roughed = Known::Lost;
                Err(Reported)
            }
            Some(Defined::Program { name, .. }) => {
                let name = name.clone();
                self.call_program(&name)
            }
            Some(Defined::Machining { cycle, .. }) if cycle.row().nature.runs() => {
                let cycle = Rc::clone(cycle);
                let result = self.run_cycle(&cycle, Calling::HERE);
                if result.is_err() {
                    let drills = cycle.row().drills();
                    if cycle.number == ROUGH_OUT {
                        self.contours.roughed = Known::Lost;
                    }
                    self.st.lose(if drills { AxisSet::of(self.st.axis()) } else { AxisSet::MAIN });
                    self.st.lost(&mut self.core);
                }
                result
            }
            Some(Defined::Machining { cycle, refused }) => {
                let (number, loc, again) = (cycle.number, cycle.loc, std::mem::replace(refused, true));
                self.cycles.defines_unsupported(number, loc, true);
                if !again {
                    let fault = codes::P9010::cycle_is_not_supported_yet(&number, &find(number).called());
                    self.core.report(fault.at(here).here("called here").also(loc, Label::DefinedHere));
                }
                let axis = self.st.axis();
                self.st.lose(AxisSet::of(axis));
                self.st.lost(&mut self.core);
                Err(Reported)
            }
        }
    }
}
