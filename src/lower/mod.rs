//! Geometry: from what was programmed to what the machine shall do.
//!
//! In: contour items. Out: motion items. Knows no dialect and no target. The passes, in order: [`polar`]
//! end points become Cartesian, [`arcs`] get centre and sweep, [`corner`]s are cut (one element of
//! look-ahead), [`frames`] map to workpiece coordinates, [`limits`] are checked.

pub mod arcs;
pub mod corner;
pub mod frames;
pub mod limits;
pub mod polar;
pub mod step;

use std::rc::Rc;

use crate::diag::{Code, Diagnostic, Diags};
use crate::ir::contour::{Coords, CtxRef, Item, Kind, Sink};
use crate::ir::{Function, Origin, Pos, motion};
use crate::machine::{Axis, Machine};

use arcs::{Adjusted, Extra, Last};
use corner::{Corners, Event};
use step::Step;

/// The passes of one run, from contour items to `out`.
pub struct Lower<'a> {
    diags: &'a Diags,
    machine: &'a Machine,
    out: &'a mut dyn motion::Sink,
    /// Programmed position in the frame of `ctx`.
    at: Pos,
    ctx: CtxRef,
    last: Last,
    adjusted: Adjusted,
    corners: Corners,
}

impl std::fmt::Debug for Lower<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Lower").field("at", &self.at).finish_non_exhaustive()
    }
}

impl<'a> Lower<'a> {
    pub fn new(diags: &'a Diags, machine: &'a Machine, out: &'a mut dyn motion::Sink) -> Lower<'a> {
        Lower {
            diags,
            machine,
            out,
            at: Pos::UNKNOWN,
            ctx: CtxRef::default(),
            last: Last::default(),
            adjusted: Adjusted::default(),
            corners: Corners::default(),
        }
    }

    /// Everything was sent: what is held back goes out.
    pub fn finish(mut self) {
        self.flush();
        self.adjusted.report(self.diags);
    }

    fn flush(&mut self) {
        let (corners, mut finish) = self.split();
        corners.flush(finish.diags, &mut |event| finish.event(event));
    }

    fn split(&mut self) -> (&mut Corners, Finish<'_>) {
        (&mut self.corners, Finish { diags: self.diags, machine: self.machine, out: &mut *self.out })
    }

    /// The frame changed: the tool stays, its programmed position does not.
    #[cold]
    fn enter_frame(&mut self, ctx: &CtxRef) {
        if self.ctx.frame != ctx.frame {
            let workpiece = self.ctx.frame.apply(&self.at);
            self.at = ctx.frame.unapply(&workpiece);
            self.last.forget();
        }
        self.ctx = Rc::clone(ctx);
    }

    fn path_element(&mut self, mv: crate::ir::contour::Move, ctx: CtxRef, origin: Origin) {
        let programmed = polar::cartesian(&mv.end);
        let mut step = Step {
            start: self.at,
            end: programmed,
            axes: programmed.known(),
            path: step::Path::Line,
            feed: mv.feed,
            side: mv.side,
            machine: mv.coords == Coords::Machine,
            ctx,
            origin,
        };
        if step.machine {
            if mv.path == crate::ir::contour::Path::Rapid {
                step.path = step::Path::Rapid;
            }
            for axis in step.axes.iter() {
                self.at.forget(axis);
            }
            self.last.forget();
            self.push(step);
            return;
        }
        step.end = self.at;
        step.end.update(&programmed);
        let extra = match arcs::resolve(&mv.path, &mut step, &self.last, &mut self.adjusted) {
            Ok(extra) => extra,
            Err(found) => {
                self.refuse(found, &programmed);
                return;
            }
        };
        self.last.follow(&step);
        self.at = step.end;
        match extra {
            Extra::None => self.push(step),
            Extra::Word(word) => {
                self.diags.push(*word);
                self.push(step);
            }
            Extra::Second(second) => {
                self.at = second.end;
                self.push(step);
                self.push(*second);
            }
        }
    }

    /// The element cannot be computed; the next ones start at its programmed end all the same.
    #[cold]
    fn refuse(&mut self, found: Option<Diagnostic>, programmed: &Pos) {
        if let Some(found) = found {
            self.diags.push(found);
        }
        self.at.update(programmed);
        self.last.forget();
    }

    /// Some functions change where the tool tip is in workpiece coordinates.
    fn displace(&mut self, function: &Function) {
        match function {
            Function::WorkOffset(_) => {
                self.at = Pos::UNKNOWN;
                self.last.forget();
            }
            // A tool of another length.
            Function::ToolChange { .. } => {
                let (_, _, third) = self.ctx.plane.axes();
                self.at.forget(Axis::ALL[third]);
                self.last.forget();
            }
            _ => {}
        }
    }

    #[inline]
    fn push(&mut self, step: Step) {
        let (corners, mut finish) = self.split();
        corners.step(step, finish.diags, &mut |event| finish.event(event));
    }
}

impl Sink for Lower<'_> {
    fn item(&mut self, item: Item) {
        if !Rc::ptr_eq(&self.ctx, &item.ctx) {
            self.enter_frame(&item.ctx);
        }
        match item.kind {
            Kind::Move(mv) => self.path_element(mv, item.ctx, item.origin),
            Kind::Corner(corner) => {
                self.last.corner();
                let (corners, mut finish) = self.split();
                corners.corner(corner, item.origin, finish.diags, &mut |event| finish.event(event));
            }
            Kind::Function(function) => {
                self.displace(&function);
                let (corners, mut finish) = self.split();
                corners.function(function, item.origin, finish.diags, &mut |event| finish.event(event));
            }
            Kind::Lost => {
                self.flush();
                self.at = Pos::UNKNOWN;
                self.last.forget();
                self.out.item(motion::Item { kind: motion::Kind::Lost, origin: item.origin });
            }
        }
    }
}


/// The last passes, which need no memory.
struct Finish<'a> {
    diags: &'a Diags,
    machine: &'a Machine,
    out: &'a mut dyn motion::Sink,
}

impl Finish<'_> {
    fn event(&mut self, event: Event) {
        match event {
            Event::Step(step) => match frames::workpiece(&step) {
                Ok(mv) => {
                    if !self.machine.limits.is_empty() && !mv.machine {
                        limits::check(&mv, &self.machine.limits, step.origin, self.diags);
                    }
                    self.out.item(motion::Item { kind: motion::Kind::Move(mv), origin: step.origin });
                }
                Err((code, message)) => {
                    self.diags.push(at(code, step.origin, message));
                }
            },
            Event::Function(function, origin) => {
                self.out.item(motion::Item { kind: motion::Kind::Function(function), origin });
            }
        }
    }
}

/// A finding about a whole block.
fn at(code: &'static Code, origin: Origin, message: impl Into<String>) -> Diagnostic {
    Diagnostic::new(code, origin.loc, message).called(origin.call)
}

