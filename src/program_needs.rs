//! What a program uses of the machine: tools with what they do, work offsets, constant cutting speed.

use std::collections::{BTreeMap, BTreeSet};

use crate::ir::captured::{Captured, Unfit};
use crate::ir::contour::{Corner, CtxRef, Load, Move, Sink};
use crate::ir::cycle::{Cycle, families};
use crate::ir::function::Spindle;
use crate::ir::{Function, Origin, Pos, Side, Tap};
use crate::text::Loc;

/// What a program uses; each with the first block that does.
#[derive(Debug, Clone, Default)]
pub struct ProgramNeeds {
    pub tools: BTreeMap<u32, ToolUse>,
    /// Work offsets, 1 (G54) to 9 (G59.3), and on.
    pub offsets: BTreeMap<u8, Loc>,
    /// Constant cutting speed, which only lathes have.
    pub cutting_speed: Option<Loc>,
}

/// What a tool does.
#[derive(Debug, Clone)]
pub struct ToolUse {
    pub first: Loc,
    /// Families of cycles, as words.
    pub cycles: BTreeSet<&'static str>,
    /// Its radius is compensated.
    pub compensated: bool,
}

/// Looks on while a program runs, and hands everything to `next`.
pub struct Watch<'s> {
    pub uses: ProgramNeeds,
    pub next: &'s mut dyn Sink,
    tool: u32,
}

impl<'s> Watch<'s> {
    pub fn new(next: &'s mut dyn Sink) -> Watch<'s> {
        Watch { uses: ProgramNeeds::default(), next, tool: 0 }
    }
}

macro_rules! name_families {
    ($($family:ident($arguments:ty),)*) => {
        /// Name of the family of a cycle.
        fn family(cycle: &Cycle) -> &'static str {
            match cycle {
                $(Cycle::$family(_) => stringify!($family),)*
            }
        }
    };
}
families!(name_families);

impl Sink for Watch<'_> {
    fn movement(&mut self, mv: &Move, ctx: &CtxRef, origin: &Origin) {
        if mv.side != Side::None
            && let Some(tool) = self.uses.tools.get_mut(&self.tool)
        {
            tool.compensated = true;
        }
        self.next.movement(mv, ctx, origin);
    }

    fn corner(&mut self, corner: &Corner, ctx: &CtxRef, origin: &Origin) {
        self.next.corner(corner, ctx, origin);
    }

    fn function(&mut self, function: &Function, ctx: &CtxRef, origin: &Origin) {
        match function {
            Function::ToolChange { number } => {
                self.tool = *number;
                let first = ToolUse { first: origin.loc, cycles: BTreeSet::new(), compensated: false };
                self.uses.tools.entry(*number).or_insert(first);
            }
            Function::WorkOffset(number) => {
                self.uses.offsets.entry(*number).or_insert(origin.loc);
            }
            Function::Spindle(Spindle::CuttingSpeed { .. })
            | Function::SpindleOf { spindle: Spindle::CuttingSpeed { .. }, .. } => {
                self.uses.cutting_speed.get_or_insert(origin.loc);
            }
            _ => {}
        }
        self.next.function(function, ctx, origin);
    }

    fn tap(&mut self, tap: &Tap, ctx: &CtxRef, origin: &Origin) {
        self.next.tap(tap, ctx, origin);
    }

    fn cycle(&mut self, cycle: &Cycle, ctx: &CtxRef, origin: &Origin) {
        if let Some(tool) = self.uses.tools.get_mut(&self.tool) {
            tool.cycles.insert(family(cycle));
        }
        self.next.cycle(cycle, ctx, origin);
    }

    fn lost(&mut self, ctx: &CtxRef, origin: &Origin) {
        self.next.lost(ctx, origin);
    }

    fn begins_at(&mut self, at: &Pos) {
        self.next.begins_at(at);
    }

    fn stands_at(&mut self, at: &Pos, ctx: &CtxRef, origin: &Origin) {
        self.next.stands_at(at, ctx, origin);
    }

    fn load(&self) -> Load {
        self.next.load()
    }

    fn contour_begins(&mut self, limit: usize, ctx: &CtxRef, origin: &Origin) {
        self.next.contour_begins(limit, ctx, origin);
    }

    fn contour_ends(&mut self, origin: &Origin) -> Result<Captured, Unfit> {
        self.next.contour_ends(origin)
    }
}
