//! Cycles become moves: one file per family.

// The enums matched here belong to one family each.
#![allow(clippy::wildcard_enum_match_arm)]

pub mod bore_milling;
pub mod cut_off;
pub mod cutter;
pub mod drilling;
pub mod facing;
pub mod finishing;
mod groove_cutter;
pub mod groove_profile;
pub mod grooving;
pub mod infeed;
pub mod layers;
pub mod long_hole;
pub mod no_path;
pub mod path_milling;
pub mod pocket;
pub mod recess;
pub mod region;
pub mod ruled;
#[cfg(test)]
mod simulate;
pub mod spigot;
pub mod thread;
pub mod thread_milling;
pub mod track;
pub mod undercut;

use std::rc::Rc;

use crate::diag::{Diagnostic, Fault, codes};
use crate::geo::{Plane, Point2};
use crate::ir::contour::{Ctx, CtxRef, Move, Sink};
use crate::ir::cycle::{Cycle, families};
use crate::ir::{Compensation, Function, Origin, Pos, Tap};
use crate::machine::Axis;

use track::Stroke;

/// What a cycle is made of.
#[derive(Debug, Clone, PartialEq)]
pub enum CycleItem {
    Move(Move),
    /// A move beside a contour, by rules of the cycle's own.
    Beside(Move, Rc<Compensation>),
    Function(Function),
    /// Without a compensating chuck.
    Tap(Tap),
}

/// Where a cycle starts: where the tool stands, in the programmed frame, and the axes of the working plane.
#[derive(Debug, Clone, Copy)]
pub struct Start {
    pub at: Pos,
    pub axes: [Axis; 3],
}

/// A family of cycles as moves.
pub trait Expand {
    /// Sends the parts of the cycle.
    ///
    /// # Errors
    /// Arguments that describe no safe path.
    fn expand(&self, start: &Start, out: &mut dyn FnMut(CycleItem)) -> Result<(), Fault>;
}

impl Start {
    /// Z and X, as a radius.
    ///
    /// # Errors
    /// G3043 where they are not known.
    fn in_turning_plane(&self) -> Result<Point2, Fault> {
        self.at.in_plane(Plane::Zx).ok_or_else(codes::G3043::cycle_starts_where_tool_stands)
    }
}

impl Stroke {
    fn part(self) -> CycleItem {
        match self {
            Stroke::Dwell { seconds } => CycleItem::Function(Function::Dwell(seconds)),
            Stroke::Move(path) => CycleItem::Move(path.movement()),
        }
    }
}

/// Sends what `cycle` does to `out`, starting in `start` (programmed frame). False for one that only travels.
///
/// # Errors
/// Arguments that describe no safe path.
pub fn expand(
    cycle: &Cycle,
    start: &Pos,
    ctx: &CtxRef,
    origin: &Origin,
    out: &mut dyn Sink,
) -> Result<bool, Box<Diagnostic>> {
    let (first, second, third) = ctx.plane.axes();
    let start = Start { at: *start, axes: [Axis::ALL[first], Axis::ALL[second], Axis::ALL[third]] };
    let mut beside: Option<CtxRef> = None;
    let mut cuts = false;
    let mut send = |part: CycleItem| match part {
        CycleItem::Move(mv) => {
            cuts |= !mv.path.is_rapid();
            out.movement(&mv, ctx, origin);
        }
        CycleItem::Beside(mv, rules) => {
            cuts |= !mv.path.is_rapid();
            let known = beside
                .take()
                .filter(|known| known.compensation.as_ref().is_some_and(|of| Rc::ptr_eq(of, &rules)))
                .unwrap_or_else(|| Rc::new(Ctx { compensation: Some(rules), ..(**ctx).clone() }));
            out.movement(&mv, &known, origin);
            beside = Some(known);
        }
        CycleItem::Function(function) => out.function(&function, ctx, origin),
        CycleItem::Tap(tap) => {
            cuts = true;
            out.tap(&tap, ctx, origin);
        }
    };
    expand_family(cycle, &start, &mut send).map_err(|fault| Box::new(super::at(*origin, fault)))?;
    Ok(cuts)
}

macro_rules! expand_family {
    ($($family:ident($arguments:ty),)*) => {
        fn expand_family(cycle: &Cycle, start: &Start, out: &mut dyn FnMut(CycleItem)) -> Result<(), Fault> {
            match cycle {
                $(Cycle::$family(cycle) => Expand::expand(cycle, start, out),)*
            }
        }
    };
}
families!(expand_family);
