//! A level of the call stack: what was called, its unit, its parameters and the repeats under way.

use crate::machine::Unit;
use crate::text::Loc;

use super::Core;
use super::vars::Locals;

/// What a level of the call stack holds.
#[derive(Debug)]
pub(super) struct Frame {
    pub kind: FrameKind,
    pub unit: Unit,
    /// QL parameters, on levels that are programs.
    pub locals: Option<Locals>,
    /// Section repeats under way: offset of the call block and repeats left.
    pub repeats: Vec<(u32, u32)>,
    /// The label passed last.
    pub passed: Option<Loc>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum FrameKind {
    Main,
    /// CALL PGM.
    Program,
    /// CALL LBL; offset of the label.
    Subprogram {
        label_at: u32,
    },
}

impl Frame {
    pub fn main(unit: Unit, locals: Locals) -> Frame {
        Frame { kind: FrameKind::Main, unit, locals: Some(locals), repeats: Vec::new(), passed: None }
    }
}

impl Core<'_> {
    /// Unit of the program that runs.
    #[inline]
    pub(super) fn unit(&self) -> Unit {
        self.levels.last().map_or(Unit::Mm, |level| level.frame.unit)
    }

    /// Millimetres in it.
    #[inline]
    pub(super) fn mm(&self) -> f64 {
        self.unit().mm()
    }

    /// Index of the program that runs.
    pub(super) fn running_program(&self) -> usize {
        self.levels.last().map_or(0, |level| level.program)
    }

    pub(super) fn locals(&self) -> &Locals {
        let locals = self.levels.iter().rev().find_map(|level| level.frame.locals.as_ref());
        locals.expect("the main level has locals")
    }

    /// The QL parameters of the innermost program.
    pub(super) fn locals_mut(&mut self) -> Option<&mut Locals> {
        self.levels.iter_mut().rev().find_map(|level| level.frame.locals.as_mut())
    }

    /// Those of its caller.
    pub(super) fn locals_of_caller(&mut self) -> Option<&mut Locals> {
        let inner = self.levels.iter().rposition(|level| level.frame.kind == FrameKind::Program)?;
        self.levels[..inner].iter_mut().rev().find_map(|level| level.frame.locals.as_mut())
    }

    /// Does a program run that CALL PGM called?
    pub(super) fn in_called_program(&self) -> bool {
        self.levels.iter().any(|level| level.frame.kind == FrameKind::Program)
    }
}
